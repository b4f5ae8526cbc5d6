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
