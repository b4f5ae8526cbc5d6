/* Places on curves over arc length and values of splines, that are asked a few at a time and thousands of times. */
#include "kernels.h"

#include <math.h>
#include <string.h>

#define BLOCK 8

/* The point (2,) at arc length s, and the slope there; its piece is sought from `piece` on, either way. */
static inline Py_ssize_t quintic_at(const Quintics *curve, Py_ssize_t piece, double s, double *point, double *slope)
{
    const Py_ssize_t step = 2 * curve->pieces;
    while (piece + 1 < curve->pieces && curve->nodes[piece + 1] <= s)
        piece++;
    while (piece && curve->nodes[piece] > s)
        piece--;
    const double u = s - curve->nodes[piece];
    for (Py_ssize_t axis = 0; axis < 2; axis++) {
        const double *row = curve->rows + 2 * piece + axis; /* of the constant terms */
        double value = row[5 * step] * u + row[4 * step], pace = row[5 * step];
        for (Py_ssize_t k = 3; k >= 0; k--) {
            pace = pace * u + value;
            value = value * u + row[k * step];
        }
        point[axis] = value;
        slope[axis] = pace;
    }
    return piece;
}

static inline Py_ssize_t piece_at(const Quintics *curve, double s)
{
    return passed(curve->pieces - 1, curve->nodes + 1, s);
}

void quintics_at(const Quintics *curve, Py_ssize_t count, const double *s, double *points, double *slopes)
{
    for (Py_ssize_t i = 0; i < count; i++)
        quintic_at(curve, piece_at(curve, s[i]), s[i], points + 2 * i, slopes + 2 * i);
}

static inline double distance(const double *a, const double *b)
{
    const double dx = a[0] - b[0], dy = a[1] - b[1];
    return sqrt(dx * dx + dy * dy);
}

/* One of the stations that are nearest to a point: the middles of blocks tell which blocks it can be in. */
static double nearest_station(Py_ssize_t count, const double *stations, const double *chain, const double *point)
{
    double least = INFINITY, found = stations[0];
    for (int all = 0; all < 2; all++)
        for (Py_ssize_t first = 0; first < count; first += BLOCK) {
            const Py_ssize_t last = first + BLOCK < count ? first + BLOCK - 1 : count - 1, middle = (first + last) / 2;
            const double away = distance(point, chain + 2 * middle);
            /* no two are farther apart than along the curve */
            const int asked = all && away - (stations[last] - stations[first]) < least;
            for (Py_ssize_t i = asked ? first : middle; i <= (asked ? last : middle); i++) {
                const double here = asked ? distance(point, chain + 2 * i) : away;
                if (here < least) {
                    least = here;
                    found = stations[i];
                }
            }
        }
    return found;
}

void nearest_on_quintics(const Quintics *curve, Py_ssize_t stations, const double *station, const double *chain,
                         double length, int steps, Py_ssize_t count, const double *points, double *s, double *places,
                         double *tangents)
{
    for (Py_ssize_t i = 0; i < count; i++) {
        const double *point = points + 2 * i;
        double *place = places + 2 * i, *tangent = tangents + 2 * i, at = nearest_station(stations, station, chain, point);
        Py_ssize_t piece = quintic_at(curve, piece_at(curve, at), at, place, tangent);
        for (int k = 0; k < steps; k++) {
            at += (point[0] - place[0]) * tangent[0] + (point[1] - place[1]) * tangent[1];
            at = between(0.0, at, length);
            piece = quintic_at(curve, piece, at, place, tangent);
        }
        s[i] = at;
    }
}

void spline_values(const SplinePieces *spline, Py_ssize_t count, const double *x, double *values)
{
    const Py_ssize_t order = spline->degree + 1;
    const double *edges = spline->edges;
    double row[MOST_DEGREE + 1];
    for (Py_ssize_t i = 0; i < count; i++) {
        const Py_ssize_t piece = passed(spline->pieces - 1, edges + 1, x[i]);
        const double u = (x[i] - edges[piece]) / (edges[piece + 1] - edges[piece]);
        memcpy(row, spline->coefficients + order * piece, order * sizeof(double));
        collapse(order, 1, u, row);
        values[i] = row[0];
    }
}
