/* Bezier extraction of B-spline spans, and splines nearest in mean square to values at the places of a Gauss rule. */
#include "kernels.h"

#include <math.h>
#include <string.h>

typedef double Points[MOST_DEGREE + 1][MOST_DEGREE + 1];

/* One level of the blossom: each point is a row of shares of the control points. */
static void step(Py_ssize_t degree, const double *knots, Py_ssize_t level, double at, Points points)
{
    for (Py_ssize_t i = 0; i <= degree - level; i++) {
        const double low = knots[level - 1 + i], share = (at - low) / (knots[degree + i] - low);
        for (Py_ssize_t k = i; k <= i + level; k++)
            points[i][k] = points[i][k] * (1 - share) + points[i + 1][k] * share;
    }
}

/* The rows of one span: Bezier point j is the blossom at its start (degree - j times) and its end (j times). */
static void span_rows(Py_ssize_t degree, const double *knots, double *matrix)
{
    const Py_ssize_t size = degree + 1;
    const double start = knots[degree - 1], end = knots[degree];
    Points begun, points;
    for (Py_ssize_t i = 0; i < size; i++) {
        memset(begun[i], 0, size * sizeof(double));
        begun[i][i] = 1.0;
    }
    for (Py_ssize_t j = 0; j < size; j++) {
        for (Py_ssize_t i = 0; i < size - j; i++)
            memcpy(points[i], begun[i], size * sizeof(double));
        for (Py_ssize_t level = j + 1; level < size; level++)
            step(degree, knots, level, start, points);
        memcpy(matrix + j * size, points[0], size * sizeof(double));
        if (j < degree)
            step(degree, knots, j + 1, end, begun);
    }
}

void extraction(Py_ssize_t spans, Py_ssize_t degree, const double *near, double *matrix)
{
    double knots[2 * MOST_DEGREE];
    for (Py_ssize_t p = 0; p < spans; p++) {
        for (Py_ssize_t k = 0; k < 2 * degree; k++)
            knots[k] = near[k * spans + p];
        span_rows(degree, knots, matrix + p * (degree + 1) * (degree + 1));
    }
}

/* Values of a span's B-splines where its Bernstein polynomials are those of `row`. */
static inline void basis_values(Py_ssize_t size, const double *row, const double *matrix, double *basis)
{
    for (Py_ssize_t i = 0; i < size; i++)
        basis[i] = 0.0;
    for (Py_ssize_t j = 0; j < size; j++)
        for (Py_ssize_t i = 0; i < size; i++)
            basis[i] += row[j] * matrix[j * size + i];
}

/* The normal equations: rows of the upper band of their matrix, and their right sides. */
static inline void add_sites(const SplineFit *f, const Py_ssize_t size, double *band, double *right)
{
    double basis[MOST_DEGREE + 1];
    memset(band, 0, f->count * size * sizeof(double));
    memset(right, 0, f->count * f->columns * sizeof(double));
    for (Py_ssize_t p = 0; p < f->spans; p++)
        for (Py_ssize_t site = 0; site < f->sites; site++) {
            const double *value = f->samples + (p * (f->sites + f->probes) + site) * f->columns;
            const double weight = f->widths[p] * f->weight[site];
            basis_values(size, f->inner + site * size, f->matrix + p * size * size, basis);
            for (Py_ssize_t i = 0; i < size; i++) {
                const double share = weight * basis[i];
                double *row = band + (f->first[p] + i) * size, *sum = right + (f->first[p] + i) * f->columns;
                for (Py_ssize_t j = i; j < size; j++)
                    row[j - i] += share * basis[j];
                for (Py_ssize_t c = 0; c < f->columns; c++)
                    sum[c] += share * value[c];
            }
        }
}

/* Cholesky's factor U of the band A = U' U, in its place; 0 where A is not positive. */
static inline int factorised(Py_ssize_t count, const Py_ssize_t size, double *band)
{
    for (Py_ssize_t j = 0; j < count; j++) {
        const Py_ssize_t top = j < size ? 0 : j - size + 1;
        for (Py_ssize_t i = top; i <= j; i++) {
            double sum = band[i * size + j - i];
            for (Py_ssize_t m = top; m < i; m++)
                sum -= band[m * size + i - m] * band[m * size + j - m];
            if (i < j)
                band[i * size + j - i] = sum / band[i * size];
            else if (sum > 0)
                band[i * size] = sqrt(sum);
            else
                return 0;
        }
    }
    return 1;
}

static inline void solve_in_place(Py_ssize_t count, const Py_ssize_t size, Py_ssize_t columns, const double *band, double *x)
{
    for (Py_ssize_t i = 0; i < count; i++)
        for (Py_ssize_t c = 0; c < columns; c++) {
            double sum = x[i * columns + c];
            for (Py_ssize_t m = i < size ? 0 : i - size + 1; m < i; m++)
                sum -= band[m * size + i - m] * x[m * columns + c];
            x[i * columns + c] = sum / band[i * size];
        }
    for (Py_ssize_t i = count - 1; i >= 0; i--)
        for (Py_ssize_t c = 0; c < columns; c++) {
            double sum = x[i * columns + c];
            for (Py_ssize_t k = 1; k < size && i + k < count; k++)
                sum -= band[i * size + k] * x[(i + k) * columns + c];
            x[i * columns + c] = sum / band[i * size];
        }
}

/* The largest error of a span at its probes, NaN where one is. */
static inline double largest_error(const SplineFit *f, const Py_ssize_t size, Py_ssize_t p, const double *coefficients)
{
    const double *acting = coefficients + f->first[p] * f->columns;
    double basis[MOST_DEGREE + 1], largest = 0.0;
    for (Py_ssize_t probe = 0; probe < f->probes; probe++) {
        const double *value = f->samples + (p * (f->sites + f->probes) + f->sites + probe) * f->columns;
        basis_values(size, f->probing + probe * size, f->matrix + p * size * size, basis);
        for (Py_ssize_t c = 0; c < f->columns; c++) {
            double sum = 0.0;
            for (Py_ssize_t i = 0; i < size; i++)
                sum += basis[i] * acting[i * f->columns + c];
            const double error = fabs(sum - value[c]);
            if (error > largest || isnan(error))
                largest = error;
        }
    }
    return largest;
}

static inline int fitted(const SplineFit *f, const Py_ssize_t size, double *band, double *coefficients, double *errors)
{
    add_sites(f, size, band, coefficients);
    if (!factorised(f->count, size, band))
        return 0;
    solve_in_place(f->count, size, f->columns, band, coefficients);
    for (Py_ssize_t p = 0; p < f->spans; p++)
        errors[p] = largest_error(f, size, p, coefficients);
    return 1;
}

int fit_splines(const SplineFit *f, double *band, double *coefficients, double *errors)
{
    /* stiffness is a cubic: of a size that is known beforehand a compiler makes no loops */
    return f->degree == 3 ? fitted(f, 4, band, coefficients, errors)
                          : fitted(f, f->degree + 1, band, coefficients, errors);
}
