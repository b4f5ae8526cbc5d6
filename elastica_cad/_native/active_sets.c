/* Small convex quadratic programs by primal-dual active sets.

   The twin of `_by_active_sets` in forming/optimizer/quadratic_program.py, where the method is explained. */
#include "kernels.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define GIVE 1e-13 /* of what a row moves by a multiplier of 1 where all unknowns are free: rounding */

/* Solve the square system in place by elimination with row exchanges; 0 where it is singular. */
WIDE static int solve_dense(Py_ssize_t n, double *restrict system, double *restrict right)
{
    for (Py_ssize_t k = 0; k < n; k++) {
        Py_ssize_t pivot = k;
        double largest = fabs(system[k * n + k]);
        for (Py_ssize_t i = k + 1; i < n; i++) {
            const double size = fabs(system[i * n + k]);
            if (size > largest) {
                largest = size;
                pivot = i;
            }
        }
        if (!(largest > 0.0))
            return 0;
        double *restrict row = system + k * n;
        if (pivot != k) {
            double *restrict other = system + pivot * n;
            for (Py_ssize_t j = k; j < n; j++) {
                const double kept = row[j];
                row[j] = other[j];
                other[j] = kept;
            }
            const double kept = right[k];
            right[k] = right[pivot];
            right[pivot] = kept;
        }
        const double inverse = 1.0 / row[k];
        for (Py_ssize_t i = k + 1; i < n; i++) {
            double *restrict below = system + i * n;
            const double factor = below[k] * inverse;
            if (factor == 0.0)
                continue;
            for (Py_ssize_t j = k + 1; j < n; j++)
                below[j] -= factor * row[j];
            right[i] -= factor * right[k];
        }
    }
    for (Py_ssize_t k = n - 1; k >= 0; k--) {
        const double *restrict row = system + k * n;
        double sum = right[k];
        for (Py_ssize_t j = k + 1; j < n; j++)
            sum -= row[j] * right[j];
        right[k] = sum / row[k];
        if (!isfinite(right[k]))
            return 0;
    }
    return 1;
}

/* H x + g - y A for every unknown. */
WIDE static void pull_inwards(const Quadratic *q, const double *x, const double *y, double *pull)
{
    const Py_ssize_t n = q->unknowns;
    for (Py_ssize_t i = 0; i < n; i++)
        pull[i] = dot(n, q->hessian + i * n, x) + q->gradient[i];
    for (Py_ssize_t k = 0; k < q->rows; k++) {
        const double *restrict row = q->A + k * n;
        if (y[k] != 0.0)
            for (Py_ssize_t i = 0; i < n; i++)
                pull[i] -= y[k] * row[i];
    }
}

/* Which sign a multiplier beyond its row's price has: only equalities are passed upwards. */
static double beyond(double y, double price, double one_sided)
{
    if (y > price)
        return 1.0;
    return one_sided == 0.0 && y < -price ? -1.0 : 0.0;
}

/* What an entry is taken for: an unknown free or at a bound, a row met, broken (with its sign) or idle. */
typedef struct {
    double first, second;
} Taken;

/* What the answer of a guess says an unknown should be taken for. */
static Taken unknown_after(double x, double pull, double lower, double upper, Taken now)
{
    const int is_free = now.first == 0.0 && now.second == 0.0;
    Taken next = {(now.first != 0.0 && pull > 0.0) || (is_free && x < lower),
                  (now.second != 0.0 && pull < 0.0) || (is_free && x > upper)};
    return next;
}

/* The same for a row with multiplier y; `gap` is A x less its right side. */
static Taken row_after(double y, double gap, double price, double one_sided, Taken now)
{
    Taken next = {1.0, 0.0};
    if (now.first != 0.0)
        next.second = beyond(y, price, one_sided);
    else if (now.second * gap < 0.0)
        next.second = now.second;
    if (one_sided != 0.0)
        next.first = now.first != 0.0 ? y > 0.0 : (gap < 0.0 || now.second != 0.0);
    if (next.second != 0.0)
        next.first = 0.0;
    return next;
}

static int differ(Taken one, Taken other)
{
    return (one.first != other.first) + (one.second != other.second);
}

WIDE int active_sets(const Quadratic *q, double *at_low, double *at_high, double *met, double *broken,
                int most_guesses, int patience, double *x, double *y, double *low, double *high)
{
    const Py_ssize_t n = q->unknowns, m = q->rows, most = n + m;
    double *work = malloc((size_t)(most * most + 2 * most + 1) * sizeof(double));
    Py_ssize_t *free_at = malloc((size_t)(most + 1) * sizeof(Py_ssize_t));
    if (work == NULL || free_at == NULL) {
        free(work);
        free(free_at);
        return -1;
    }
    double *right = work + most * most, *pull = right + most, *gap = pull + n;
    Py_ssize_t least = 2 * most + 1;
    int settled = 0, waited = 0;
    double hessian_size = 1e-300, row_size = 1e-300; /* the largest diagonal entry, and square of a row's length */
    for (Py_ssize_t i = 0; i < n; i++)
        hessian_size = fmax(hessian_size, q->hessian[i * n + i]);
    for (Py_ssize_t k = 0; k < m; k++)
        row_size = fmax(row_size, dot(n, q->A + k * n, q->A + k * n));

    for (int guess = 1; guess <= most_guesses && !settled; guess++) {
        Py_ssize_t count = 0, bound = 0;
        for (Py_ssize_t i = 0; i < n; i++) {
            if (q->fixed[i] != 0.0 || at_low[i] != 0.0)
                x[i] = q->lower[i];
            else if (at_high[i] != 0.0)
                x[i] = q->upper[i];
            else {
                x[i] = 0.0;
                free_at[count++] = i;
            }
        }
        Py_ssize_t *rows = free_at + count;
        for (Py_ssize_t k = 0; k < m; k++) {
            y[k] = broken[k] * q->price[k];
            if (met[k] != 0.0)
                rows[bound++] = k;
        }
        const Py_ssize_t size = count + bound;
        if (size == 0)
            break;
        /* more rows than unknowns that are free: they give way a little, by the least multipliers */
        const double give = bound > count ? GIVE * row_size / hessian_size : 0.0;
        pull_inwards(q, x, y, pull);
        for (Py_ssize_t a = 0; a < count; a++) {
            const double *hessian = q->hessian + free_at[a] * n;
            double *row = work + a * size;
            for (Py_ssize_t b = 0; b < count; b++)
                row[b] = hessian[free_at[b]];
            right[a] = -pull[free_at[a]];
        }
        for (Py_ssize_t k = 0; k < bound; k++) {
            const double *given = q->A + rows[k] * n;
            double *row = work + (count + k) * size;
            for (Py_ssize_t a = 0; a < count; a++)
                row[a] = work[a * size + count + k] = given[free_at[a]];
            for (Py_ssize_t other = 0; other < bound; other++)
                row[count + other] = other == k ? -give : 0.0;
            right[count + k] = q->right[rows[k]] - dot(n, given, x);
        }
        if (!solve_dense(size, work, right))
            break;
        for (Py_ssize_t a = 0; a < count; a++)
            x[free_at[a]] = right[a];
        for (Py_ssize_t k = 0; k < bound; k++)
            y[rows[k]] = -right[count + k];

        pull_inwards(q, x, y, pull);
        Py_ssize_t changed = 0, last = -1;
        for (Py_ssize_t i = 0; i < n; i++) {
            const Taken now = {at_low[i], at_high[i]};
            if (q->fixed[i] == 0.0 && differ(unknown_after(x[i], pull[i], q->lower[i], q->upper[i], now), now)) {
                changed++;
                last = i;
            }
        }
        for (Py_ssize_t k = 0; k < m; k++) {
            const Taken now = {met[k], broken[k]};
            gap[k] = dot(n, q->A + k * n, x) - q->right[k];
            if (differ(row_after(y[k], gap[k], q->price[k], q->one_sided[k], now), now)) {
                changed++;
                last = n + k;
            }
        }
        if (changed == 0 && give == 0.0) {
            settled = guess;
            for (Py_ssize_t i = 0; i < n; i++) {
                const int is_fixed = q->fixed[i] != 0.0;
                low[i] = at_low[i] != 0.0 || (is_fixed && pull[i] > 0.0) ? pull[i] : 0.0;
                high[i] = at_high[i] != 0.0 || (is_fixed && pull[i] < 0.0) ? -pull[i] : 0.0;
            }
            break;
        }
        /* all at once while that comes nearer; else the last alone, which cannot go round in circles */
        waited = changed < least ? 0 : waited + 1;
        least = changed < least ? changed : least;
        for (Py_ssize_t i = 0; i < n; i++) {
            if (q->fixed[i] != 0.0 || (waited > patience && i != last))
                continue;
            const Taken now = {at_low[i], at_high[i]};
            const Taken next = unknown_after(x[i], pull[i], q->lower[i], q->upper[i], now);
            at_low[i] = next.first;
            at_high[i] = next.second;
        }
        for (Py_ssize_t k = 0; k < m; k++) {
            if (waited > patience && n + k != last)
                continue;
            const Taken now = {met[k], broken[k]};
            const Taken next = row_after(y[k], gap[k], q->price[k], q->one_sided[k], now);
            met[k] = next.first;
            broken[k] = next.second;
        }
    }
    free(work);
    free(free_at);
    return settled;
}
