/* Piecewise polynomials at many places at once, each place in a piece of its own, and arc length by its series. */
#include "kernels.h"

#include <math.h>
#include <string.h>

/* P_k = ahead[k] x P_(k-1) - back[k] P_(k-2). */
typedef struct {
    double ahead[MOST_ORDER], back[MOST_ORDER];
} Legendre;

static Legendre legendre(Py_ssize_t order)
{
    Legendre by;
    for (Py_ssize_t k = 2; k < order; k++) {
        by.ahead[k] = (2.0 * k - 1.0) / k;
        by.back[k] = (k - 1.0) / k;
    }
    return by;
}

#define BESIDE 4 /* places that a processor evaluates beside each other */

/* Polynomials (order, BESIDE) at a few places. */
static void legendre_polynomials(const Legendre *by, Py_ssize_t order, const double *x, double (*polynomials)[BESIDE])
{
    for (int i = 0; i < BESIDE; i++) {
        polynomials[0][i] = 1.0;
        polynomials[1][i] = x[i];
    }
    for (Py_ssize_t k = 2; k < order; k++)
        for (int i = 0; i < BESIDE; i++)
            polynomials[k][i] = by->ahead[k] * x[i] * polynomials[k - 1][i] - by->back[k] * polynomials[k - 2][i];
}

WIDE void legendre_sums(Py_ssize_t places, Py_ssize_t order, Py_ssize_t columns, const double *coefficients,
                        const int64_t *panel, const double *x, double *values)
{
    const Legendre by = legendre(order);
    double polynomials[MOST_ORDER + 1][BESIDE];
    for (Py_ssize_t first = 0; first < places; first += BESIDE) {
        double at[BESIDE] = {0.0};
        const int count = places - first < BESIDE ? (int)(places - first) : BESIDE;
        for (int i = 0; i < count; i++)
            at[i] = x[first + i];
        legendre_polynomials(&by, order, at, polynomials);
        for (int i = 0; i < count; i++) {
            const double *row = coefficients + panel[first + i] * order * columns;
            for (Py_ssize_t j = 0; j < columns; j++) {
                double sum = 0.0;
                for (Py_ssize_t k = 0; k < order; k++)
                    sum += polynomials[k][i] * row[k * columns + j];
                values[(first + i) * columns + j] = sum;
            }
        }
    }
}

/* Where a place lies between two edges, from low to 1. */
static inline double share_of(const double *edges, double low, double place)
{
    const double share = (place - edges[0]) / (edges[1] - edges[0]);
    return between(low, low + (1.0 - low) * share, 1.0);
}

void locate(Py_ssize_t pieces, const double *edges, int to_left, double low, Py_ssize_t count, const double *places,
            int64_t *piece, double *x)
{
    for (Py_ssize_t i = 0, p = 0; i < count; i++) {
        p = piece_of(pieces, edges, to_left, places[i], p);
        piece[i] = p;
        x[i] = share_of(edges + p, low, places[i]);
    }
}

void bernstein_sums(Py_ssize_t places, const BernsteinPieces *pieces, const int64_t *piece, const double *u,
                    double *values)
{
    const Py_ssize_t degree = pieces->degree, columns = pieces->columns;
    double before[MOST_DEGREE + 1], after[MOST_DEGREE + 1];
    for (Py_ssize_t i = 0; i < places; i++) {
        const double *restrict row = pieces->series + piece[i] * (degree + 1) * pieces->width + pieces->first;
        double *restrict sum = values + i * columns;
        before[0] = after[0] = 1.0;
        for (Py_ssize_t k = 1; k <= degree; k++) {
            before[k] = before[k - 1] * u[i];
            after[k] = after[k - 1] * (1.0 - u[i]);
        }
        for (Py_ssize_t j = 0; j < columns; j++)
            sum[j] = 0.0;
        for (Py_ssize_t k = 0; k <= degree; k++) {
            const double share = before[k] * after[degree - k];
            for (Py_ssize_t j = 0; j < columns; j++)
                sum[j] += share * row[k * pieces->width + j];
        }
    }
}

void curve_at(const BernsteinPieces *pieces, const double *edges, int to_left, const double *origins,
              Py_ssize_t places, const double *t, double *values)
{
    int64_t piece = 0;
    for (Py_ssize_t i = 0; i < places; i++) {
        double *sum = values + i * pieces->columns;
        piece = piece_of(pieces->count, edges, to_left, t[i], piece);
        const double u = share_of(edges + piece, 0.0, t[i]);
        bernstein_sums(1, pieces, &piece, &u, sum);
        sum[0] += origins[2 * piece];
        sum[1] += origins[2 * piece + 1];
    }
}

/* The sum of a Chebyshev series and its slope by x, by Clenshaw's recurrences. */
static double chebyshev_sum(Py_ssize_t count, const double *restrict series, double x, double *slope)
{
    double one = 0.0, two = 0.0, slope_one = 0.0, slope_two = 0.0;
    for (Py_ssize_t k = count - 1; k > 0; k--) {
        const double next_slope = 2 * x * slope_one - slope_two + 2 * one, next = 2 * x * one - two + series[k];
        slope_two = slope_one;
        slope_one = next_slope;
        two = one;
        one = next;
    }
    *slope = x * slope_one - slope_two + one;
    return x * one - two + series[0];
}

void arc_lengths_at(const ArcLengths *arc, Py_ssize_t places, const double *t, double *s)
{
    double slope;
    for (Py_ssize_t i = 0, p = 0; i < places; i++) {
        p = passed_near(arc->panels - 1, arc->t + 1, t[i], p);
        const double width = arc->t[p + 1] - arc->t[p];
        const double x = between(-1.0, 2 * (t[i] - arc->t[p]) / width - 1, 1.0);
        if (x <= -1 || x >= 1)
            s[i] = arc->s[p + (x >= 1)];
        else
            s[i] = arc->s[p] + chebyshev_sum(arc->terms, arc->series + p * arc->terms, x, &slope);
    }
}

void parameters_at(const ArcLengths *arc, const InverseCells *cells, Py_ssize_t places, const double *s, double *t)
{
    const Py_ssize_t count = arc->panels * cells->of_each;
    for (Py_ssize_t i = 0, cell = 0; i < places; i++) {
        cell = passed_near(count - 1, cells->meets, s[i], cell);
        const Py_ssize_t p = cell / cells->of_each;
        const double *cubic = cells->cubics + 6 * cell, *series = arc->series + p * arc->terms;
        const double target = s[i] - arc->s[p], whole = arc->s[p + 1] - arc->s[p];
        double x, slope;
        if (target <= 0 || target >= whole)
            x = target <= 0 ? -1.0 : 1.0;
        else {
            const double share = (s[i] - cubic[0]) * cubic[1];
            const double rate = (cubic[3] + share * (2 * cubic[4] + share * (3 * cubic[5]))) * cubic[1];
            x = between(-1.0, cubic[2] + share * (cubic[3] + share * (cubic[4] + share * cubic[5])), 1.0);
            double low = -1.0, high = 1.0, gap = chebyshev_sum(arc->terms, series, x, &slope) - target;
            double following = between(-1.0, x - gap * rate, 1.0), enough = cells->step_from_cubic;
            for (int step = 0; step < 60 && fabs(following - x) > enough; step++) {
                if (gap < 0)
                    low = x;
                else
                    high = x;
                x = following;
                gap = chebyshev_sum(arc->terms, series, x, &slope) - target;
                following = x - gap / slope;
                if (!(following >= low && following <= high))
                    following = (low + high) / 2;
                enough = cells->last_step;
            }
            x = following;
        }
        t[i] = arc->t[p] + (arc->t[p + 1] - arc->t[p]) * (1 + x) / 2;
    }
}

/* Coefficients of a Legendre series' derivative by x, from a matrix (order, order). */
static void derive(Py_ssize_t order, const double *slopes, const double *series, double *derivative)
{
    for (Py_ssize_t k = 0; k < order; k++)
        derivative[k] = dot(order, slopes + k * order, series);
}

/* Halley's steps towards the extreme of a series that lies next to `start`. */
static double extreme_near(const ExtremeSearch *search, const double *series, double start)
{
    const Py_ssize_t order = search->order;
    const double low = fmax(start - search->reach, -1.0), high = fmin(start + search->reach, 1.0);
    const int64_t each[3] = {0, 1, 2};
    double derivatives[3 * MOST_ORDER], x = start;
    for (int d = 0; d < 3; d++)
        derive(order, search->slopes, d ? derivatives + (d - 1) * order : series, derivatives + d * order);
    for (int step = 0; step < search->steps; step++) {
        const double places[3] = {x, x, x};
        double at[3];
        legendre_sums(3, order, 1, derivatives, each, places, at);
        const double bend = 2 * at[1] * at[1] - at[0] * at[2];
        x = between(low, bend != 0 ? x + -2 * at[0] * at[1] / bend : x, high);
    }
    return x;
}

Py_ssize_t extremes(const ExtremeSearch *search, Py_ssize_t panels, const double *coefficients, double *table,
                    int64_t *panel, int64_t *sample, double *x)
{
    const Py_ssize_t order = search->order, samples = search->samples, count = panels * samples;
    Py_ssize_t least = 0, most = 0, found = 0;
    for (Py_ssize_t i = 0; i < panels; i++)
        for (Py_ssize_t j = 0; j < samples; j++)
            table[i * samples + j] = dot(order, coefficients + i * order, search->basis + j * order);
    for (Py_ssize_t i = 1; i < count; i++) {
        if (table[i] < table[least])
            least = i;
        if (table[i] > table[most])
            most = i;
    }
    const double band = search->band * (table[most] - table[least]);
    const double above = table[most] - band, below = table[least] + band;
    for (Py_ssize_t i = 0; i < count; i++) {
        const Py_ssize_t j = i % samples;
        const double here = table[i];
        if (i != least && i != most) {
            if (!(here > above || here < below) || j == 0 || j == samples - 1)
                continue;
            if (!((here >= table[i - 1] && here >= table[i + 1]) || (here <= table[i - 1] && here <= table[i + 1])))
                continue;
        }
        panel[found] = i / samples;
        sample[found] = j;
        x[found++] = extreme_near(search, coefficients + i / samples * order, search->places[j]);
    }
    return found;
}

/* The least and the largest so far, each as a place and a value. */
static void take(double value, double place, double *found)
{
    if (value < found[1]) {
        found[0] = place;
        found[1] = value;
    }
    if (value > found[3]) {
        found[2] = place;
        found[3] = value;
    }
}

void cubic_extremes(Py_ssize_t pieces, const double *coefficients, const double *edges, double *found)
{
    found[0] = found[2] = edges[0];
    found[1] = found[3] = coefficients[0];
    for (Py_ssize_t i = 0; i < pieces; i++)
        take(coefficients[4 * i], edges[i], found);
    for (Py_ssize_t i = 0; i < pieces; i++)
        take(coefficients[4 * i + 3], edges[i] + (edges[i + 1] - edges[i]), found);
    const double low = found[1], high = found[3];
    for (Py_ssize_t i = 0; i < pieces; i++) {
        const double *c = coefficients + 4 * i;
        if (!(fmin(c[1], c[2]) < low || fmax(c[1], c[2]) > high))
            continue;
        /* a (1 - u)^2 + 2 b u (1 - u) + c u^2 = 0, in the form that takes no difference of like numbers */
        const double a = c[1] - c[0], b = c[2] - c[1], d = c[3] - c[2], q = b - a, square = a - 2 * b + d;
        const double r = -(q + copysign(sqrt(q * q - a * square), q)), roots[2] = {r / square, a / r};
        for (int k = 0; k < 2; k++)
            if (roots[k] > 0 && roots[k] < 1) {
                double row[4] = {c[0], c[1], c[2], c[3]};
                collapse(4, 1, roots[k], row);
                take(row[0], edges[i] + roots[k] * (edges[i + 1] - edges[i]), found);
            }
    }
}
