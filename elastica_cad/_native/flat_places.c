/* Places in a flat pattern: which lie near each other, and how far they are from what is cut out. */
#include "kernels.h"

#include <math.h>

#define ROUNDING 1e-12 /* of squares: between these hypot decides, as it does in Python */

Py_ssize_t near_pairs(const NearSearch *search, Py_ssize_t room, int64_t *lower, int64_t *higher)
{
    const double reach = search->reach, sure = reach * reach * (1 - ROUNDING), never = reach * reach * (1 + ROUNDING);
    Py_ssize_t found = 0;
    for (Py_ssize_t i = 0; i < search->count; i++)
        for (int64_t j = search->first[i]; j < search->end[i]; j++) {
            const double dx = search->x[i] - search->x[j], dy = search->y[i] - search->y[j];
            const double square = dx * dx + dy * dy;
            if (!(square <= never) || (!(square < sure) && !(hypot(dx, dy) <= reach)))
                continue;
            if (found < room) {
                const int64_t a = search->number[i], b = search->number[j];
                lower[found] = a < b ? a : b;
                higher[found] = a < b ? b : a;
            }
            found++;
        }
    return found;
}

/* Low and high corners (4,) of the box around `count` points. */
static void box_of(Py_ssize_t count, const double *points, double *box)
{
    for (int axis = 0; axis < 2; axis++) {
        box[axis] = box[2 + axis] = points[axis];
        for (Py_ssize_t i = 1; i < count; i++) {
            const double x = points[2 * i + axis];
            box[axis] = x < box[axis] ? x : box[axis];
            box[2 + axis] = x > box[2 + axis] ? x : box[2 + axis];
        }
    }
}

static inline int chord_meets(const double *chord, const double *box)
{
    for (int axis = 0; axis < 2; axis++) {
        const double a = chord[axis], b = chord[2 + axis];
        if (!((a < b ? a : b) <= box[2 + axis] && (a < b ? b : a) >= box[axis]))
            return 0;
    }
    return 1;
}

Py_ssize_t chord_pairs(Py_ssize_t p_points, const double *p, Py_ssize_t q_points, const double *q, Py_ssize_t room,
                       int64_t *of_p, int64_t *of_q)
{
    double around[4], own[4];
    Py_ssize_t found = 0;
    box_of(q_points, q, around);
    for (Py_ssize_t i = 0; i + 1 < p_points; i++) {
        if (!chord_meets(p + 2 * i, around))
            continue;
        box_of(2, p + 2 * i, own);
        for (Py_ssize_t j = 0; j + 1 < q_points; j++) {
            if (!chord_meets(q + 2 * j, own))
                continue;
            if (found < room) {
                of_p[found] = i;
                of_q[found] = j;
            }
            found++;
        }
    }
    return found;
}

void away_from_rims(Py_ssize_t sides, const double *start, const double *end, Py_ssize_t count, const double *along,
                    const double *across, double *away)
{
    for (Py_ssize_t i = 0; i < count; i++) {
        double least = INFINITY;
        int is_within = 0;
        for (Py_ssize_t k = 0; k < sides; k++) {
            const double dx = end[2 * k] - start[2 * k], dy = end[2 * k + 1] - start[2 * k + 1];
            const double left = along[i] - start[2 * k], down = across[i] - start[2 * k + 1];
            const double where = between(0.0, (left * dx + down * dy) / (dx * dx + dy * dy), 1.0);
            const double here = hypot(where * dx - left, where * dy - down);
            if (here < least || isnan(here))
                least = here;
            /* a line from the place to one side meets the sides of polygons around it an odd number of times */
            if ((down >= 0) != (down >= dy) && (left * dy < down * dx) == (dy > 0))
                is_within = !is_within;
        }
        away[i] = is_within ? -least : least;
    }
}
