/* Small convex quadratic programs by interior points with Mehrotra's predictor and corrector.

   The same as in form_finding/quadratic_program.py, where the method is explained. */
#include "loops.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define MOST_FACTORISATIONS 60 /* a dozen is usual */
#define FEASIBLE 1e-10         /* of rows */
#define BACKOFF 0.995          /* of the way to the nearest bound, which interior points do not touch */
#define CYCLING 20             /* factorisations after which the corrector may go round in circles */
#define CENTERED 0.3           /* of mu: what steps aim at from there on, without a corrector */
#define LOOSE 1e4              /* of a row's square over its D: up to here rounding in G hides nothing of H */
#define SINGULAR_SHARE 1e-15   /* added to a diagonal, so that rows that say nearly the same do not make it singular */

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

/* G = H + diagonal + a a^T / D of loose rows, with its L; of the others W = (L^-1 A^T)^T and C of W W^T + D.

   Most limits are far from met, so few rows are left for C. `order` has the tight rows first. */
typedef struct {
    Py_ssize_t n, m, tight, *order;
    const double *A;
    double *L, *W, *C, *D, *right;
} Factors;

static void add(Py_ssize_t n, double factor, const double *restrict a, double *restrict to)
{
    for (Py_ssize_t i = 0; i < n; i++)
        to[i] += factor * a[i];
}

WIDE static int factorise(Factors *f, const double *H, double scale, const double *diagonal)
{
    const Py_ssize_t n = f->n;
    for (Py_ssize_t i = 0; i < n; i++) {
        for (Py_ssize_t j = 0; j <= i; j++)
            f->L[i * n + j] = scale * H[i * n + j];
        f->L[i * n + i] += diagonal[i];
    }
    f->tight = 0;
    for (Py_ssize_t k = 0, loose = f->m; k < f->m; k++) {
        const double *row = f->A + k * n;
        if (dot(n, row, row) > LOOSE * f->D[k]) {
            f->order[f->tight++] = k;
        } else {
            f->order[--loose] = k;
            for (Py_ssize_t i = 0; i < n; i++)
                add(i + 1, row[i] / f->D[k], row, f->L + i * n);
        }
    }
    if (!cholesky(n, f->L))
        return 0;
    for (Py_ssize_t k = 0; k < f->tight; k++) {
        memcpy(f->W + k * n, f->A + f->order[k] * n, (size_t)n * sizeof(double));
        solve_lower(n, f->L, f->W + k * n);
    }
    for (int lifted = 0; lifted < 2; lifted++) {
        double largest = 0.0;
        for (Py_ssize_t k = 0; k < f->tight; k++) {
            double *row = f->C + k * f->tight;
            for (Py_ssize_t j = 0; j <= k; j++)
                row[j] = dot(n, f->W + k * n, f->W + j * n);
            row[k] += f->D[f->order[k]];
            largest = fmax(largest, row[k]);
        }
        for (Py_ssize_t k = 0; lifted && k < f->tight; k++)
            f->C[k * f->tight + k] += SINGULAR_SHARE * largest;
        if (cholesky(f->tight, f->C))
            return 1;
    }
    return 0;
}

/* (dx, dy) with (H + diagonal) dx - A^T dy = a and A dx + D dy = b, in the place of a and b. */
WIDE static void solve_factors(const Factors *f, double *a, double *b)
{
    const Py_ssize_t n = f->n;
    for (Py_ssize_t k = f->tight; k < f->m; k++)
        add(n, b[f->order[k]] / f->D[f->order[k]], f->A + f->order[k] * n, a);
    solve_lower(n, f->L, a);
    for (Py_ssize_t k = 0; k < f->tight; k++)
        f->right[k] = b[f->order[k]] - dot(n, f->W + k * n, a);
    solve_lower(f->tight, f->C, f->right);
    solve_upper(f->tight, f->C, f->right);
    for (Py_ssize_t k = 0; k < f->tight; k++) {
        add(n, f->right[k], f->W + k * n, a);
        b[f->order[k]] = f->right[k];
    }
    solve_upper(n, f->L, a);
    for (Py_ssize_t k = f->tight; k < f->m; k++) {
        const Py_ssize_t row = f->order[k];
        b[row] = (b[row] - dot(n, f->A + row * n, a)) / f->D[row];
    }
}

static double largest_of(Py_ssize_t n, const double *values)
{
    double largest = 0.0;
    for (Py_ssize_t i = 0; i < n; i++)
        largest = fabs(values[i]) > largest || isnan(values[i]) ? fabs(values[i]) : largest;
    return largest;
}

WIDE int interior_points(const Quadratic *q, double accuracy, double *x, double *y, double *low, double *high,
                         int *iterations)
{
    const Py_ssize_t n = q->unknowns, m = q->rows, half = n + m, count = 2 * half;
    const double *H = q->hessian, *A = q->A;
    const Py_ssize_t room = n * n + m * n + m * m + 7 * count + 3 * half + m;
    double *work = calloc((size_t)room, sizeof(double));
    Py_ssize_t *order = calloc((size_t)m + 1, sizeof(Py_ssize_t));
    if (work == NULL || order == NULL) {
        free(work);
        free(order);
        return -1;
    }
    double *u = work + n * n + m * n + m * m, *v = u + count, *du = v + count, *dv = du + count, *product = dv + count;
    double *aim = product + count, *change = aim + count, *diagonal = change + count;
    double *dual = diagonal + half, *dx = dual + half;
    double *primal = dual + n, *dy = dx + n, *D = diagonal + n;
    Factors f = {n, m, 0, order, A, work, work + n * n, work + n * n + m * n, D, dx + half};

    double largest = 1e-30;
    for (Py_ssize_t i = 0; i < n; i++)
        largest = fmax(largest, fmax(fabs(q->gradient[i]), fabs(H[i * n + i])));
    const double scale = 1.0 / largest;
    const double tolerance = accuracy * fmin(fmax(scale * largest_of(n, q->gradient), 1e-6), 1.0);
    double mu = 0.0;
    for (Py_ssize_t i = 0; i < n; i++) {
        const double inner = 0.1 * (q->upper[i] - q->lower[i]);
        x[i] = fmin(fmax(0.0, q->lower[i] + inner), q->upper[i] - inner);
        u[i] = x[i] - q->lower[i];
        u[n + i] = q->upper[i] - x[i];
        mu += fabs(scale * q->gradient[i]) * inner;
    }
    mu = fmax(0.03, 0.1 * mu / (double)n);
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

    int converged = 0, iteration = 0;
    while (iteration < MOST_FACTORISATIONS) {
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
        if (mu < tolerance && largest_of(n, dual) < 10.0 * tolerance && largest_of(m, primal) < 10.0 * FEASIBLE) {
            converged = 1;
            break;
        }
        iteration++;
        double least = INFINITY;
        for (Py_ssize_t i = 0; i < count; i++)
            least = fmin(least, fmin(u[i], v[i]));
        for (Py_ssize_t i = 0; i < n; i++)
            diagonal[i] = v[i] / u[i] + v[n + i] / u[n + i];
        for (Py_ssize_t k = 0; k < m; k++)
            D[k] = v[2 * n + k] / u[2 * n + k] + v[2 * n + m + k] / u[2 * n + m + k];
        if (!factorise(&f, H, scale, diagonal) || !(least > 0.0))
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
            step = worst > 0.0 ? fmin(1.0 / BACKOFF, 1.0 / worst) : 1.0 / BACKOFF;
            if (corrector)
                continue;
            for (Py_ssize_t i = 0; i < count; i++)
                after += (u[i] + step * du[i]) * (v[i] + step * dv[i]);
            const double share = after / (double)count / mu;
            for (Py_ssize_t i = 0; i < count; i++)
                aim[i] = iteration > CYCLING ? CENTERED * mu - product[i]
                                                  : mu * share * share * share - product[i] - du[i] * dv[i];
        }
        step *= BACKOFF;
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
    free(order);
    return converged;
}
