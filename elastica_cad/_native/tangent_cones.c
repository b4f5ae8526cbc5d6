/* The turning angle of a curve over parts that turn by less than half a turn. */
#include "kernels.h"

#include <math.h>

/* Unit vector along (2,) numbers, zero along none. */
static inline void unit(const double *v, double *along)
{
    const double length = hypot(v[0], v[1]), over = length > 0.0 ? length : 1.0;
    along[0] = v[0] / over;
    along[1] = v[1] / over;
}

/* From direction u to direction v, in (-pi, pi]. */
static inline double turn(const double *u, const double *v)
{
    return atan2(u[0] * v[1] - u[1] * v[0], u[0] * v[0] + u[1] * v[1]);
}

/* The sum of the unit vectors along its ends. */
static inline void middle(const double *ends[2], double *axis)
{
    double first[2], last[2];
    unit(ends[0], first);
    unit(ends[1], last);
    axis[0] = first[0] + last[0];
    axis[1] = first[1] + last[1];
}

int are_cones(const Hodographs *parts, const ConeLimits *limits)
{
    const Py_ssize_t order = parts->order;
    double fastest = 0.0, slowest = INFINITY;
    for (Py_ssize_t i = 0; i < parts->count; i++) {
        const double *row = parts->velocities + 2 * order * i, *ends[2] = {row, row + 2 * (order - 1)};
        double axis[2], largest = 0.0;
        middle(ends, axis);
        for (Py_ssize_t j = 0; j < order; j++) {
            const double *v = row + 2 * j, size = hypot(v[0], v[1]);
            if (!(v[0] * axis[0] + v[1] * axis[1] > limits->along * size))
                return 0;
            largest = size > largest ? size : largest;
        }
        for (int k = 0; k < 2; k++) {
            const double size = hypot(ends[k][0], ends[k][1]);
            if (!(size > limits->slow * largest))
                return 0;
        }
        fastest = largest > fastest ? largest : fastest;
        slowest = largest < slowest ? largest : slowest;
    }
    return slowest > limits->still * fastest;
}

double tangent_angles(const Hodographs *parts, double *axis, double *angle)
{
    const Py_ssize_t order = parts->order;
    const double ahead[2] = {1.0, 0.0};
    double low = INFINITY, high = -INFINITY, last[2] = {0.0, 0.0}, at_end = 0.0;
    for (Py_ssize_t i = 0; i < parts->count; i++) {
        const double *row = parts->velocities + 2 * order * i, *ends[2] = {row, row + 2 * (order - 1)};
        double between_ends[2], first[2], *own = axis + 2 * i;
        middle(ends, between_ends);
        unit(between_ends, own);
        unit(ends[0], first);
        /* at a break by the exterior angle */
        const double begin = i ? angle[i - 1] + at_end + turn(last, first) : turn(ahead, first);
        angle[i] = begin - turn(own, row);
        for (Py_ssize_t j = 0; j < order; j++) {
            at_end = turn(own, row + 2 * j);
            low = angle[i] + at_end < low ? angle[i] + at_end : low;
            high = angle[i] + at_end > high ? angle[i] + at_end : high;
        }
        unit(ends[1], last);
    }
    return high - low;
}

void angles_at(const TangentAngles *tabulated, int to_left, Py_ssize_t places, const double *t, const double *velocity,
               double *angles)
{
    for (Py_ssize_t i = 0, cone = 0; i < places; i++) {
        cone = piece_of(tabulated->count, tabulated->edges, to_left, t[i], cone);
        angles[i] = tabulated->angle[cone] + turn(tabulated->axis + 2 * cone, velocity + 2 * i);
    }
}
