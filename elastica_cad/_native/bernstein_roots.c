/* Zeros of polynomials in Bernstein form, as geometry/polynomials/bernstein.py explains them. */
#include "kernels.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* A part of a polynomial: where it lies in (0, 1), and how often it has been cut. */
typedef struct {
    double low, width, coefficients[MOST_DEGREE + 1];
    int cuts;
} Part;

/* Coefficients on [0, u] and [u, 1], by de Casteljau; those on the right may stand where the whole ones do. */
static void subdivide(Py_ssize_t degree, const double *whole, double u, double *left, double *right)
{
    double row[MOST_DEGREE + 1];
    memcpy(row, whole, (degree + 1) * sizeof(double));
    for (Py_ssize_t k = 0; k <= degree; k++) {
        left[k] = row[0];
        right[degree - k] = row[degree - k];
        for (Py_ssize_t i = 0; i < degree - k; i++)
            row[i] = row[i] * (1 - u) + row[i + 1] * u;
    }
}

static double value_and_slope(Py_ssize_t degree, const double *c, double u, double *slope)
{
    double row[MOST_DEGREE + 1];
    memcpy(row, c, (degree + 1) * sizeof(double));
    collapse(degree + 1, 2, u, row);
    *slope = degree * (row[1] - row[0]);
    return row[0] + (row[1] - row[0]) * u;
}

/* The one sign change of a polynomial whose end values differ in sign, to rounding error, and the slope there. */
static double crossing(Py_ssize_t degree, const double *c, double largest, double *slope)
{
    const int rising = c[degree] > 0;
    double low = 0.0, high = 1.0, u = c[0] / (c[0] - c[degree]);
    for (int step = 0; step < 80; step++) {
        const double value = value_and_slope(degree, c, u, slope);
        if (fabs(value) <= DBL_EPSILON * largest)
            return u;
        if ((value > 0) == rising)
            high = u;
        else
            low = u;
        double following = *slope != 0 ? u - value / *slope : low;
        if (!(low < following && following < high))
            following = (low + high) / 2;
        if (fabs(following - u) <= 4e-16)
            return following;
        u = following;
    }
    return u;
}

/* Where the one sign change of a part lies: at one place, or where it is a multiple zero within a stretch about it. */
static void enclose(const RootSearch *search, const double *c, double noise, double *ends)
{
    const Py_ssize_t degree = search->degree;
    double largest = 0.0, slope = 0.0;
    for (Py_ssize_t i = 0; i <= degree; i++)
        largest = fmax(largest, fabs(c[i]));
    const double u = crossing(degree, c, largest, &slope), blur = cbrt(noise / largest);
    const double reach = fabs(slope) <= search->gentle * blur * blur * largest ? search->blur * blur : 0.0;
    ends[0] = fmax(u - reach, 0.0);
    ends[1] = fmin(u + reach, 1.0);
}

enum { ONE, NONE, CLUSTER, UNDECIDED };

/* What the signs of a part's coefficients say of its zeros. */
static int judged(Py_ssize_t degree, const Part *part, double noise, int most_cuts)
{
    int changes = 0, last = 0, some = 0, blurred = 0, ends[2] = {0, 0};
    for (Py_ssize_t i = 0; i <= degree; i++) {
        const double c = part->coefficients[i];
        const int sign = fabs(c) > noise ? (c > 0) - (c < 0) : 0;
        if (i == 0)
            ends[0] = sign;
        ends[1] = sign;
        some |= sign != 0;
        blurred |= sign == 0;
        changes += sign * last < 0;
        if (sign)
            last = sign;
    }
    if (some && changes == 1 && ends[0] * ends[1] < 0)
        return ONE;
    if (some && changes == 0 && !blurred)
        return NONE;
    return !some || part->cuts == most_cuts ? CLUSTER : UNDECIDED;
}

/* The part cut in two near its middle, where it is farthest from zero; it becomes the left one. */
static void cut(Py_ssize_t degree, const double *splits, Part *part, Part *right)
{
    double best = splits[0], farthest = -1.0;
    for (int k = 0; k < SPLITS; k++) {
        double slope;
        const double there = fabs(value_and_slope(degree, part->coefficients, splits[k], &slope));
        if (there > farthest) {
            farthest = there;
            best = splits[k];
        }
    }
    double left[MOST_DEGREE + 1];
    subdivide(degree, part->coefficients, best, left, right->coefficients);
    memcpy(part->coefficients, left, (degree + 1) * sizeof(double));
    right->low = part->low + part->width * best;
    right->width = part->width * (1 - best);
    part->width *= best;
    right->cuts = ++part->cuts;
}

Py_ssize_t bernstein_roots(const RootSearch *search, const double *coefficients, const double *noise, Py_ssize_t room,
                           int64_t *piece, int64_t *sharp, double *places)
{
    Part parts[MOST_CUTS + 2];
    const Py_ssize_t degree = search->degree;
    Py_ssize_t found = 0;
    for (Py_ssize_t i = 0; i < search->count; i++) {
        Py_ssize_t open = 1;
        parts[0] = (Part){.low = 0.0, .width = 1.0, .cuts = 0};
        memcpy(parts[0].coefficients, coefficients + i * (degree + 1), (degree + 1) * sizeof(double));
        while (open) {
            Part *part = &parts[open - 1];
            const int verdict = judged(degree, part, noise[i], search->most_cuts);
            if (verdict == UNDECIDED) {
                cut(degree, search->splits, part, part + 1);
                open++;
                continue;
            }
            open--;
            if (verdict == NONE)
                continue;
            if (found == room)
                return -1;
            double ends[2] = {0.0, 1.0};
            if (verdict == ONE)
                enclose(search, part->coefficients, noise[i], ends);
            piece[found] = i;
            sharp[found] = ends[0] == ends[1];
            places[2 * found] = part->low + part->width * ends[0];
            places[2 * found + 1] = part->low + part->width * ends[1];
            found++;
        }
    }
    return found;
}
