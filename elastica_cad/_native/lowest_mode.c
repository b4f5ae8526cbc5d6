/* The stability margin of a discrete rod: the lowest mode of its second variation on the end constraints.

   The twin of `_smooth_mode` in mechanics/rod/banded_matrices.py and of `DiscreteRod.margin`, where it is explained. */
#include "loops.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define SWEEPS 30               /* of Jacobi's rotations, which take six to ten */
#define ROUNDING 2.220446049250313e-16
#define RANK_TOLERANCE 1e-9     /* rows closer to dependent than this are one */
#define REFINEMENTS 8           /* Rayleigh quotients: each triples the digits */
#define SETTLED 1e-5            /* of a mode's size: a quotient that changes by less has all its digits */
#define SINGULAR (16 * ROUNDING) /* of a matrix: an eigenvalue that is rounding */

static void subtract(Py_ssize_t n, double factor, const double *restrict a, double *restrict from)
{
    for (Py_ssize_t i = 0; i < n; i++)
        from[i] -= factor * a[i];
}

/* Rows of a tridiagonal system while it is solved, `right` with up to three columns. */
typedef struct {
    double *below, *diagonal, *above, *second;
} Bands;

static int eliminate(Py_ssize_t n, int columns, const double *diagonal, const double *off, double shift, const Bands *b,
                     double *right)
{
    for (Py_ssize_t i = 0; i < n; i++)
        b->diagonal[i] = diagonal[i] - shift;
    memcpy(b->below, off, (size_t)(n - 1) * sizeof(double));
    memcpy(b->above, off, (size_t)(n - 1) * sizeof(double));
    for (Py_ssize_t i = 0; i + 1 < n; i++) {
        double *row = right + i * columns, *next = row + columns;
        b->second[i] = 0.0;
        if (fabs(b->diagonal[i]) >= fabs(b->below[i])) {
            if (b->diagonal[i] == 0.0)
                return 0;
            const double factor = b->below[i] / b->diagonal[i];
            b->diagonal[i + 1] -= factor * b->above[i];
            for (int j = 0; j < columns; j++)
                next[j] -= factor * row[j];
        } else {
            const double factor = b->diagonal[i] / b->below[i], kept = b->diagonal[i + 1];
            b->diagonal[i] = b->below[i];
            b->diagonal[i + 1] = b->above[i] - factor * kept;
            b->above[i] = kept;
            if (i + 2 < n) {
                b->second[i] = b->above[i + 1];
                b->above[i + 1] *= -factor;
            }
            for (int j = 0; j < columns; j++) {
                const double moved = row[j];
                row[j] = next[j];
                next[j] = moved - factor * next[j];
            }
        }
    }
    if (b->diagonal[n - 1] == 0.0)
        return 0;
    for (Py_ssize_t i = n - 1; i >= 0; i--) {
        double *row = right + i * columns;
        for (int j = 0; j < columns; j++) {
            double sum = row[j];
            if (i + 1 < n)
                sum -= b->above[i] * row[columns + j];
            if (i + 2 < n)
                sum -= b->second[i] * row[2 * columns + j];
            row[j] = sum / b->diagonal[i];
        }
    }
    return 1;
}

/* Eigenvalues at or below `shift`, by Sturm's sequence. */
static int count_below(Py_ssize_t n, const double *diagonal, const double *off, double shift, double smallest)
{
    int count = 0;
    double pivot = diagonal[0] - shift;
    for (Py_ssize_t i = 0; i < n; i++) {
        if (i > 0)
            pivot = diagonal[i] - shift - off[i - 1] * off[i - 1] / pivot;
        if (fabs(pivot) < smallest)
            pivot = -smallest;
        count += pivot < 0.0;
    }
    return count;
}

/* The lowest eigenvalue of a small symmetric matrix, with its eigenvector, by Jacobi's rotations. */
static double lowest_of_small(int n, double *matrix, double *vector)
{
    double turned[MOST_POLYNOMIALS * MOST_POLYNOMIALS] = {0.0};
    for (int i = 0; i < n; i++)
        turned[i * n + i] = 1.0;
    for (int sweep = 0; sweep < SWEEPS; sweep++) {
        double aside = 0.0, along = 0.0;
        for (int i = 0; i < n; i++)
            for (int j = 0; j < n; j++)
                *(i == j ? &along : &aside) += matrix[i * n + j] * matrix[i * n + j];
        if (aside <= 1e-32 * along)
            break;
        for (int p = 0; p < n; p++)
            for (int q = p + 1; q < n; q++) {
                const double off = matrix[p * n + q];
                if (off == 0.0)
                    continue;
                const double theta = (matrix[q * n + q] - matrix[p * n + p]) / (2.0 * off);
                const double t = (theta < 0.0 ? -1.0 : 1.0) / (fabs(theta) + sqrt(theta * theta + 1.0));
                const double c = 1.0 / sqrt(t * t + 1.0), s = t * c;
                for (int k = 0; k < n; k++) {
                    const double a = matrix[k * n + p], b = matrix[k * n + q];
                    matrix[k * n + p] = c * a - s * b;
                    matrix[k * n + q] = s * a + c * b;
                }
                for (int k = 0; k < n; k++) {
                    const double a = matrix[p * n + k], b = matrix[q * n + k];
                    matrix[p * n + k] = c * a - s * b;
                    matrix[q * n + k] = s * a + c * b;
                    const double x = turned[k * n + p], y = turned[k * n + q];
                    turned[k * n + p] = c * x - s * y;
                    turned[k * n + q] = s * x + c * y;
                }
            }
    }
    int lowest = 0;
    for (int i = 1; i < n; i++)
        lowest = matrix[i * n + i] < matrix[lowest * n + lowest] ? i : lowest;
    for (int i = 0; i < n; i++)
        vector[i] = turned[i * n + lowest];
    return matrix[lowest * n + lowest];
}

/* An orthonormal basis of the rows (k, n) in their place; 0 where they are dependent. */
static int orthonormalise(int k, Py_ssize_t n, double *rows, double rank_tolerance)
{
    for (int i = 0; i < k; i++) {
        double *row = rows + i * n;
        for (int pass = 0; pass < 3; pass++) {
            if (pass > 0)
                for (int j = 0; j < i; j++)
                    subtract(n, dot(n, rows + j * n, row), rows + j * n, row);
            const double size = sqrt(dot(n, row, row));
            if (!(size > (pass == 0 ? 0.0 : rank_tolerance)))
                return 0;
            for (Py_ssize_t m = 0; m < n; m++)
                row[m] /= size;
        }
    }
    return 1;
}

/* The best of the given polynomials (n, smooth) that keeps to the rows. */
WIDE static double best_polynomial(const SecondVariation *v, const double *diagonal, const double *off, const double *basis,
                              double *x)
{
    const Py_ssize_t n = v->edges;
    const int s = v->polynomial_count, k = v->rows;
    double energy[MOST_POLYNOMIALS * MOST_POLYNOMIALS] = {0.0}, held[MOST_ROWS * MOST_POLYNOMIALS] = {0.0};
    double mixed[MOST_POLYNOMIALS * MOST_POLYNOMIALS] = {0.0}, mode[MOST_POLYNOMIALS];
    double wide[MOST_POLYNOMIALS][MOST_POLYNOMIALS] = {{0.0}}, here[MOST_POLYNOMIALS] = {0.0}; /* loops of one length are fast */
    for (Py_ssize_t i = 0; i < n; i++) {
        const double *restrict row = v->polynomials + i * s;
        memcpy(here, row, (size_t)s * sizeof(double));
        for (int a = 0; a < s; a++) {
            double turned = diagonal[i] * row[a];
            if (i > 0)
                turned += off[i - 1] * row[a - s];
            if (i + 1 < n)
                turned += off[i] * row[a + s];
            for (int b = 0; b < MOST_POLYNOMIALS; b++)
                wide[a][b] += here[b] * turned;
        }
        for (int j = 0; j < k; j++)
            for (int a = 0; a < s; a++)
                held[j * s + a] += basis[j * n + i] * row[a];
    }
    for (int a = 0; a < s; a++)
        for (int b = 0; b < s; b++)
            energy[b * s + a] = wide[a][b];
    if (!orthonormalise(k, s, held, RANK_TOLERANCE))
        return NAN;
    /* P E P + lift (1 - P): what the rows hold is lifted above all else */
    double lift = 0.0;
    for (int a = 0; a < s; a++) {
        double sum = 0.0;
        for (int b = 0; b < s; b++)
            sum += fabs(energy[a * s + b]);
        lift = fmax(lift, sum);
    }
    for (int side = 0; side < 2; side++) { /* E P, then P (E P), each transposed */
        for (int a = 0; a < s; a++)
            for (int b = 0; b < s; b++)
                mixed[b * s + a] = energy[a * s + b];
        for (int a = 0; a < s; a++)
            for (int j = 0; j < k; j++) {
                double along = 0.0;
                for (int b = 0; b < s; b++)
                    along += energy[a * s + b] * held[j * s + b];
                for (int b = 0; b < s; b++)
                    mixed[b * s + a] -= along * held[j * s + b];
            }
        memcpy(energy, mixed, sizeof(energy));
    }
    for (int a = 0; a < s; a++)
        for (int b = 0; b < s; b++) {
            mixed[a * s + b] = (energy[a * s + b] + energy[b * s + a]) / 2.0;
            for (int j = 0; j < k; j++)
                mixed[a * s + b] += 2.0 * lift * held[j * s + a] * held[j * s + b];
        }
    memcpy(energy, mixed, sizeof(energy));
    const double value = lowest_of_small(s, energy, mode);
    for (Py_ssize_t i = 0; i < n; i++)
        x[i] = dot(s, v->polynomials + i * s, mode);
    return value;
}

/* The solution of a system of k <= 2 equations, by least squares with the least answer where it is singular. */
static void solve_small(int k, const double *matrix, double *right)
{
    if (k == 1)
        right[0] = matrix[0] != 0.0 ? right[0] / matrix[0] : 0.0;
    if (k != 2)
        return;
    const double a = matrix[0], b = matrix[1], c = matrix[2], d = matrix[3], x = right[0], y = right[1];
    const double determinant = a * d - b * c, size = a * a + b * b + c * c + d * d;
    if (fabs(determinant) > 1e-14 * size) {
        right[0] = (d * x - b * y) / determinant;
        right[1] = (a * y - c * x) / determinant;
    } else if (size > 0.0) { /* of rank 1: M^T r over the square of its size */
        right[0] = (a * x + c * y) / size;
        right[1] = (b * x + d * y) / size;
    }
}

/* Is nothing below `shift` on the rows' null space? Sylvester's law on the bordered matrix. */
static int none_below(const SecondVariation *v, const double *diagonal, const double *off, const double *basis,
                      double shift, double reach, const Bands *bands, double *right)
{
    const Py_ssize_t n = v->edges;
    const int k = v->rows;
    double largest = 0.0, S[MOST_ROWS * MOST_ROWS] = {0.0};
    for (Py_ssize_t i = 0; i < n; i++)
        for (int j = 0; j < k; j++)
            right[i * k + j] = basis[j * n + i];
    if (k && !eliminate(n, k, diagonal, off, shift, bands, right))
        return 0;
    for (Py_ssize_t i = 0; i < n * k; i++)
        largest = fmax(largest, fabs(right[i]));
    if (!(largest * SINGULAR * reach < 1.0))
        return 0;
    for (int a = 0; a < k; a++)
        for (int b = 0; b < k; b++)
            for (Py_ssize_t i = 0; i < n; i++)
                S[a * k + b] += right[i * k + a] * basis[b * n + i];
    int positive = 0;
    if (k == 1)
        positive = S[0] > 0.0;
    if (k == 2) {
        const double mean = (S[0] + S[3]) / 2.0, off_diagonal = (S[1] + S[2]) / 2.0;
        const double radius = hypot((S[0] - S[3]) / 2.0, off_diagonal);
        positive = (mean + radius > 0.0) + (mean - radius > 0.0);
    }
    return count_below(n, diagonal, off, shift, 1e-300 * (1.0 + reach * reach)) + positive - k == 0;
}

int lowest_mode(const SecondVariation *v, double *mode, double *multipliers, double *value)
{
    const Py_ssize_t n = v->edges;
    const int k = v->rows, columns = k + 1;
    double *work = calloc((size_t)n, (size_t)(8 + 3 * MOST_ROWS + columns) * sizeof(double));
    if (work == NULL)
        return -1;
    double *diagonal = work, *off = diagonal + n, *basis = off + n, *right = basis + n * MOST_ROWS;
    const Bands bands = {right + n * columns, right + n * (columns + 1), right + n * (columns + 2),
                         right + n * (columns + 3)};
    double *root = right + n * (columns + 4);
    int found = 0;
    double largest = 0.0, aside = 0.0;
    for (Py_ssize_t i = 0; i < n; i++)
        root[i] = sqrt(v->lengths[i]);
    for (Py_ssize_t i = 0; i < n; i++) {
        diagonal[i] = v->diagonal[i] / v->lengths[i];
        largest = fmax(largest, fabs(diagonal[i]));
        if (i + 1 < n) {
            off[i] = v->off[i] / (root[i] * root[i + 1]);
            aside = fmax(aside, fabs(off[i]));
        }
        for (int j = 0; j < k; j++)
            basis[j * n + i] = v->constraints[j * n + i] / root[i];
    }
    const double reach = largest + 2.0 * aside;
    if (!isfinite(reach) || !orthonormalise(k, n, basis, RANK_TOLERANCE))
        goto done;
    double mu = best_polynomial(v, diagonal, off, basis, mode);
    if (!isfinite(mu))
        goto done;
    const double scale = fabs(mu) + reach / ((double)n * (double)n);
    for (int step = 0; step < REFINEMENTS && !found; step++) {
        for (Py_ssize_t i = 0; i < n; i++) {
            right[i * columns] = mode[i];
            for (int j = 0; j < k; j++)
                right[i * columns + 1 + j] = basis[j * n + i];
        }
        if (!eliminate(n, columns, diagonal, off, mu, &bands, right))
            goto done;
        double S[MOST_ROWS * MOST_ROWS] = {0.0}, y[MOST_ROWS] = {0.0};
        for (int a = 0; a < k; a++)
            for (Py_ssize_t i = 0; i < n; i++) {
                y[a] += basis[a * n + i] * right[i * columns];
                for (int b = 0; b < k; b++)
                    S[a * k + b] += basis[a * n + i] * right[i * columns + 1 + b];
            }
        solve_small(k, S, y);
        double *x = bands.below; /* free again */
        for (Py_ssize_t i = 0; i < n; i++) {
            x[i] = right[i * columns];
            for (int j = 0; j < k; j++)
                x[i] -= y[j] * right[i * columns + 1 + j];
        }
        for (int j = 0; j < k; j++)
            subtract(n, dot(n, basis + j * n, x), basis + j * n, x);
        const double size = sqrt(dot(n, x, x));
        if (!(isfinite(size) && size > 0.0))
            goto done;
        const double change = dot(n, x, mode) / size / size;
        for (Py_ssize_t i = 0; i < n; i++)
            mode[i] = x[i] / size;
        mu += change;
        found = fabs(change) < SETTLED * scale;
    }
    if (!found)
        goto done;
    found = 0;
    const double below = mu - fmax(1e-9 / ((double)n * (double)n), 64.0 * ROUNDING) * reach;
    if (!none_below(v, diagonal, off, basis, below, reach, &bands, right))
        goto done;
    /* back from unit weights, the largest entry upwards; then what the constraints do to it */
    Py_ssize_t peak = 0;
    for (Py_ssize_t i = 0; i < n; i++) {
        mode[i] /= root[i];
        peak = fabs(mode[i]) > fabs(mode[peak]) ? i : peak;
    }
    if (mode[peak] < 0.0)
        for (Py_ssize_t i = 0; i < n; i++)
            mode[i] = -mode[i];
    double G[MOST_ROWS * MOST_ROWS] = {0.0};
    for (int a = 0; a < k; a++)
        multipliers[a] = 0.0;
    for (Py_ssize_t i = 0; i < n; i++) {
        double left = (v->diagonal[i] - mu * v->lengths[i]) * mode[i];
        if (i > 0)
            left += v->off[i - 1] * mode[i - 1];
        if (i + 1 < n)
            left += v->off[i] * mode[i + 1];
        for (int a = 0; a < k; a++) {
            const double share = v->constraints[a * n + i] / v->lengths[i];
            multipliers[a] += share * left;
            for (int b = 0; b < k; b++)
                G[a * k + b] += share * v->constraints[b * n + i];
        }
    }
    *value = mu;
    solve_small(k, G, multipliers);
    found = 1;
done:
    free(work);
    return found;
}
