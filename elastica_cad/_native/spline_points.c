/* Points of B-splines side by side, and how they move along them, by de Boor's triangle. */
#include "kernels.h"

void spline_motion(const SplineRows *rows, Py_ssize_t places, const int64_t *which, const double *u, double *position,
                   double *velocity)
{
    const Py_ssize_t degree = rows->degree, knot_count = rows->knot_count, points = knot_count - degree - 1;
    double near[MOST_DEGREE + 1][3];
    for (Py_ssize_t i = 0; i < places; i++) {
        const double *knots = rows->knots + which[i] * knot_count;
        const double first = rows->domain[2 * which[i]], last = rows->domain[2 * which[i] + 1];
        const double t = first * (1.0 - u[i]) + last * u[i];
        Py_ssize_t after = passed(knot_count, knots, t);
        while (after > 0 && !(knots[after - 1] < last))
            after--;
        const Py_ssize_t span = after - 1 < degree ? degree : after - 1 < points ? after - 1 : points - 1;
        const double *about = knots + span + 1 - degree, *row = rows->points + 3 * (which[i] * points + span - degree);
        for (Py_ssize_t r = 0; r <= degree; r++)
            for (int j = 0; j < 3; j++)
                near[r][j] = row[3 * r + j];
        double slope[3] = {0.0, 0.0, 0.0};
        for (Py_ssize_t level = 1; level <= degree; level++) {
            if (level == degree)
                for (int j = 0; j < 3; j++)
                    slope[j] = (near[1][j] - near[0][j]) * ((double)degree / (about[degree] - about[degree - 1]));
            for (Py_ssize_t r = 0; r <= degree - level; r++) {
                const double low = about[level - 1 + r], share = (t - low) / (about[degree + r] - low);
                for (int j = 0; j < 3; j++)
                    near[r][j] = near[r][j] * (1.0 - share) + near[r + 1][j] * share;
            }
        }
        for (int j = 0; j < 2; j++) {
            position[2 * i + j] = near[0][j] / near[0][2];
            velocity[2 * i + j] = (slope[j] - slope[2] * position[2 * i + j]) / near[0][2] * (last - first);
        }
    }
}
