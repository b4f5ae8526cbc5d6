/* Small convex quadratic programs by interior points with Mehrotra's predictor and corrector.

   The twin of `_by_interior_points` in forming/optimizer/quadratic_program.py, where the method is explained. */
#include "kernels.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* L of L L^T in the lower triangle of `matrix`; 0 where it is not positive definite. */
WIDE static int cholesky(Py_ssize_t n, double *matrix)
{
    for (Py_ssize_t j = 0; j < n; j++) {
        double *restrict row = matrix + j * n;
        for (Py_ssize_t i = 0; i < j; i++) {
            const double *restrict above = matrix + i * n;
            row[i] = (row[i] - dot(i, row, above)) / above[i];
        }
        const double sum = row[j] - dot(j, row, row);
        if (!(sum > 0.0) || !isfinite(sum))
            return 0;
        row[j] = sqrt(sum);
    }
    return 1;
}

WIDE static void solve_lower(Py_ssize_t n, const double *L, double *right)
{
    for (Py_ssize_t i = 0; i < n; i++) {
        const double *restrict row = L + i * n;
        right[i] = (right[i] - dot(i, row, right)) / row[i];
    }
}

/* With L transposed. */
WIDE static void solve_upper(Py_ssize_t n, const double *L, double *right)
{
    for (Py_ssize_t i = n - 1; i >= 0; i--) {
        const double *restrict row = L + i * n;
        const double solved = right[i] / row[i];
        right[i] = solved;
        for (Py_ssize_t k = 0; k < i; k++)
            right[k] -= solved * row[k];
    }
}

/* G = H + diagonal with its L, the rows W = (L^-1 A^T)^T, and C of W W^T + D. */
typedef struct {
    Py_ssize_t n, m;
    double *L, *W, *C;
} Factors;

WIDE static int factorise(const Factors *f, const double *H, double scale, const double *diagonal, const double *A,
                     const double *D, double rounding)
{
    const Py_ssize_t n = f->n, m = f->m;
    for (Py_ssize_t i = 0; i < n; i++) {
        for (Py_ssize_t j = 0; j <= i; j++)
            f->L[i * n + j] = scale * H[i * n + j];
        f->L[i * n + i] += diagonal[i];
    }
    if (!cholesky(n, f->L))
        return 0;
    memcpy(f->W, A, (size_t)(m * n) * sizeof(double));
    for (Py_ssize_t k = 0; k < m; k++)
        solve_lower(n, f->L, f->W + k * n);
    for (int lifted = 0; lifted < 2; lifted++) {
        double largest = 0.0;
        for (Py_ssize_t k = 0; k < m; k++)
            for (Py_ssize_t j = 0; j <= k; j++) {
                const double sum = dot(n, f->W + k * n, f->W + j * n) + (k == j ? D[k] : 0.0);
                f->C[k * m + j] = sum;
                largest = k == j && sum > largest ? sum : largest;
            }
        for (Py_ssize_t k = 0; lifted && k < m; k++)
            f->C[k * m + k] += rounding * largest;
        if (cholesky(m, f->C))
            return 1;
    }
    return 0;
}

/* (dx, dy) with G dx - A^T dy = a and A dx + D dy = b, in the place of a and b. */
WIDE static void solve_factors(const Factors *f, double *a, double *b)
{
    const Py_ssize_t n = f->n, m = f->m;
    solve_lower(n, f->L, a);
    for (Py_ssize_t k = 0; k < m; k++)
        b[k] -= dot(n, f->W + k * n, a);
    solve_lower(m, f->C, b);
    solve_upper(m, f->C, b);
    for (Py_ssize_t k = 0; k < m; k++)
        for (Py_ssize_t i = 0; i < n; i++)
            a[i] += b[k] * f->W[k * n + i];
    solve_upper(n, f->L, a);
}

static double largest_of(Py_ssize_t n, const double *values)
{
    double largest = 0.0;
    for (Py_ssize_t i = 0; i < n; i++)
        largest = fabs(values[i]) > largest || isnan(values[i]) ? fabs(values[i]) : largest;
    return largest;
}

/* The exact minimum where what the pairs tell to bind is what binds. */
static int guess(const Quadratic *q, const InteriorSettings *set, const double *u, const double *v, double *taken,
                 double *x, double *y, double *low, double *high)
{
    const Py_ssize_t n = q->unknowns, m = q->rows;
    double *at_low = taken, *at_high = at_low + n, *met = at_high + n, *broken = met + m;
    for (Py_ssize_t i = 0; i < n; i++) {
        at_low[i] = u[i] < v[i];
        at_high[i] = u[n + i] < v[n + i];
    }
    for (Py_ssize_t k = 0; k < m; k++) {
        const int near_low = u[2 * n + k] < v[2 * n + k], near_high = u[2 * n + m + k] < v[2 * n + m + k];
        met[k] = !(near_low || near_high);
        broken[k] = near_high ? 1.0 : (near_low && q->one_sided[k] == 0.0 ? -1.0 : 0.0);
    }
    return active_sets(q, at_low, at_high, met, broken, set->most_guesses, set->patience, x, y, low, high);
}

WIDE int interior_points(const Quadratic *q, const InteriorSettings *set, double *x, double *y, double *low, double *high,
                    int *iterations)
{
    const Py_ssize_t n = q->unknowns, m = q->rows, half = n + m, count = 2 * half;
    const double *H = q->hessian, *A = q->A;
    const Py_ssize_t room = n * n + m * n + m * m + 7 * count + 6 * half;
    double *work = malloc((size_t)room * sizeof(double));
    if (work == NULL)
        return -1;
    const Factors f = {n, m, work, work + n * n, work + n * n + m * n};
    double *u = f.C + m * m, *v = u + count, *du = v + count, *dv = du + count, *product = dv + count;
    double *aim = product + count, *change = aim + count, *taken = change + count, *diagonal = taken + 2 * half;
    double *dual = diagonal + half, *dx = dual + half, *kept = dx + half;
    double *primal = dual + n, *dy = dx + n, *D = diagonal + n;

    double largest = 1e-30;
    for (Py_ssize_t i = 0; i < n; i++)
        largest = fmax(largest, fmax(fabs(q->gradient[i]), fabs(H[i * n + i])));
    const double scale = 1.0 / largest;
    const double tolerance = set->accuracy * fmin(fmax(scale * largest_of(n, q->gradient), 1e-6), 1.0);
    double guess_at = set->guess_at * tolerance / set->accuracy, mu = 0.0;
    for (Py_ssize_t i = 0; i < n; i++) {
        const double inner = 0.1 * (q->upper[i] - q->lower[i]);
        x[i] = fmin(fmax(0.0, q->lower[i] + inner), q->upper[i] - inner);
        u[i] = x[i] - q->lower[i];
        u[n + i] = q->upper[i] - x[i];
        mu += fabs(scale * q->gradient[i]) * inner;
    }
    mu = fmax(1e-3, 0.1 * mu / (double)n);
    for (Py_ssize_t k = 0; k < m; k++) {
        const double most = scale * q->price[k], least = q->one_sided[k] != 0.0 ? 0.0 : -most;
        y[k] = (least + most) / 2.0;
        u[2 * n + k] = y[k] - least;
        u[2 * n + m + k] = most - y[k];
    }
    for (Py_ssize_t i = 0; i < count; i++)
        v[i] = mu / u[i];
    for (Py_ssize_t k = 0; k < m; k++) {
        const double gap = dot(n, A + k * n, x) - q->right[k];
        const double first = v[2 * n + k];
        v[2 * n + k] = first + gap / 2.0 + hypot(first, gap / 2.0);
        v[2 * n + m + k] = fmax(v[2 * n + k] - gap, mu);
    }

    int status = 0, iteration = 0;
    while (iteration < set->most_factorisations) {
        for (Py_ssize_t i = 0; i < n; i++) {
            dual[i] = scale * (q->gradient[i] + dot(n, H + i * n, x)) - v[i] + v[n + i];
        }
        for (Py_ssize_t k = 0; k < m; k++) {
            for (Py_ssize_t i = 0; i < n; i++)
                dual[i] -= y[k] * A[k * n + i];
            primal[k] = dot(n, A + k * n, x) - q->right[k] - v[2 * n + k] + v[2 * n + m + k];
        }
        mu = 0.0;
        for (Py_ssize_t i = 0; i < count; i++) {
            product[i] = u[i] * v[i];
            mu += product[i];
        }
        mu /= (double)count;
        if (mu < tolerance && largest_of(n, dual) < 10.0 * tolerance && largest_of(m, primal) < 10.0 * set->feasible) {
            status = 1;
            break;
        }
        if (mu < guess_at) {
            memcpy(kept, x, (size_t)n * sizeof(double));
            memcpy(kept + n, y, (size_t)m * sizeof(double));
            status = guess(q, set, u, v, taken, x, y, low, high);
            if (status != 0) {
                *iterations = status;
                free(work);
                return status < 0 ? -1 : 2;
            }
            memcpy(x, kept, (size_t)n * sizeof(double));
            memcpy(y, kept + n, (size_t)m * sizeof(double));
            guess_at = 0.0;
        }
        iteration++;
        double least = INFINITY;
        for (Py_ssize_t i = 0; i < count; i++)
            least = fmin(least, fmin(u[i], v[i]));
        for (Py_ssize_t i = 0; i < n; i++)
            diagonal[i] = v[i] / u[i] + v[n + i] / u[n + i];
        for (Py_ssize_t k = 0; k < m; k++)
            D[k] = v[2 * n + k] / u[2 * n + k] + v[2 * n + m + k] / u[2 * n + m + k];
        if (!factorise(&f, H, scale, diagonal, A, D, set->rounding) || !(least > 0.0))
            break;
        /* straight to mu = 0, then towards the centre that this leaves room for */
        double step = 0.0;
        for (Py_ssize_t i = 0; i < count; i++)
            aim[i] = -product[i];
        for (int corrector = 0; corrector < 2; corrector++) {
            for (Py_ssize_t i = 0; i < count; i++)
                change[i] = aim[i] / u[i];
            for (Py_ssize_t i = 0; i < n; i++)
                dx[i] = change[i] - change[n + i] - dual[i];
            for (Py_ssize_t k = 0; k < m; k++)
                dy[k] = change[2 * n + k] - change[2 * n + m + k] - primal[k];
            solve_factors(&f, dx, dy);
            for (Py_ssize_t i = 0; i < n; i++) {
                du[i] = dx[i];
                du[n + i] = -dx[i];
            }
            for (Py_ssize_t k = 0; k < m; k++) {
                du[2 * n + k] = dy[k];
                du[2 * n + m + k] = -dy[k];
            }
            double worst = 0.0, after = 0.0;
            for (Py_ssize_t i = 0; i < count; i++) {
                dv[i] = change[i] - v[i] / u[i] * du[i];
                worst = fmax(worst, fmax(-du[i] / u[i], -dv[i] / v[i]));
            }
            step = worst > 0.0 ? fmin(1.0 / set->backoff, 1.0 / worst) : 1.0 / set->backoff;
            if (corrector)
                continue;
            for (Py_ssize_t i = 0; i < count; i++)
                after += (u[i] + step * du[i]) * (v[i] + step * dv[i]);
            const double share = after / (double)count / mu;
            for (Py_ssize_t i = 0; i < count; i++)
                aim[i] = iteration > set->cycling ? set->centered * mu - product[i]
                                                  : mu * share * share * share - product[i] - du[i] * dv[i];
        }
        step *= set->backoff;
        for (Py_ssize_t i = 0; i < n; i++)
            x[i] += step * dx[i];
        for (Py_ssize_t k = 0; k < m; k++)
            y[k] += step * dy[k];
        for (Py_ssize_t i = 0; i < count; i++) {
            u[i] += step * du[i];
            v[i] += step * dv[i];
        }
    }
    for (Py_ssize_t k = 0; k < m; k++)
        y[k] /= scale;
    for (Py_ssize_t i = 0; i < n; i++) {
        low[i] = v[i] / scale;
        high[i] = v[n + i] / scale;
    }
    *iterations = iteration;
    free(work);
    return status;
}
