/* The discrete rod (paper, section 7.1) from its start: shooting, and the derivatives of all it reaches.

   The same recursions as mechanics/shooting.py and form_finding/rod_map.py, where they are explained. */
#include "loops.h"

#include <math.h>

void shoot(Py_ssize_t nodes, const double *bend, const double *rest, const double *pull_x, const double *pull_y,
           double moment, double angle, double most_angle, double *angles, double *moments)
{
    const Py_ssize_t n = nodes - 1;
    double alpha = angle, M = moment;
    angles[0] = alpha;
    moments[0] = M;
    for (Py_ssize_t i = 0; i < n; i++) {
        alpha += bend[i] * M + rest[i];
        if (!(-most_angle < alpha && alpha < most_angle))
            alpha = M = NAN;
        M += pull_x[i] * cos(alpha) + pull_y[i] * sin(alpha);
        angles[i + 1] = alpha;
        moments[i + 1] = M;
    }
    angles[n + 1] = alpha + bend[n] * M + rest[n];
}

void shape(Py_ssize_t n, const double *angles, const double *force, const double *start, double edge, double *tangents,
           double *position, double *pull, double *shear)
{
    double x = 0.0, y = 0.0;
    position[0] = start[0];
    position[1] = start[1];
    for (Py_ssize_t i = 0; i < n; i++) {
        const double Tx = cos(angles[i]), Ty = sin(angles[i]), fx = force[2 * i], fy = force[2 * i + 1];
        tangents[2 * i] = Tx;
        tangents[2 * i + 1] = Ty;
        pull[i] = fx * Tx + fy * Ty;
        shear[i] = fy * Tx - fx * Ty;
        x += edge * Tx;
        y += edge * Ty;
        position[2 * i + 2] = x + start[0];
        position[2 * i + 3] = y + start[1];
    }
}

WIDE void second_variation(Py_ssize_t n, const double *stiffness, const double *weights, const double *lengths,
                           const double *pull, const double *tangents, const int *free_ends, const int *held,
                           double straight, double *diagonal, double *off, double *rows)
{
    for (Py_ssize_t i = 0; i < n; i++) {
        const double before = i == 0 && free_ends[0] ? 0.0 : stiffness[i] / weights[i];
        const double after = i == n - 1 && free_ends[1] ? 0.0 : stiffness[i + 1] / weights[i + 1];
        diagonal[i] = before + after - lengths[i] * pull[i];
        if (i + 1 < n)
            off[i] = -after;
    }
    for (int axis = 0; axis < 2; axis++) {
        if (!held[axis])
            continue;
        const double *side = tangents + 1 - axis, sign = axis == 0 ? -1.0 : 1.0;
        double largest = 0.0;
        for (Py_ssize_t i = 0; i < n; i++)
            if (!(fabs(side[2 * i]) <= largest) && !isnan(largest)) /* what is no number is the largest */
                largest = fabs(side[2 * i]);
        for (Py_ssize_t i = 0; i < n; i++)
            rows[i] = largest > straight ? sign * lengths[i] * side[2 * i] : 0.0;
        rows += n;
    }
}

WIDE void sensitivities(const RodAt *rod, Py_ssize_t columns, double *angles, double *moments, double *position)
{
    const Py_ssize_t n = rod->nodes - 1, m = rod->coefficients, c = columns;
    const Py_ssize_t at_moment = m, at_force = m + 1, at_position = m + 3, at_angle = m + 5, at_length = m + 6;
    const double edge = rod->length / (double)n;

    for (Py_ssize_t j = 0; j < c; j++)
        angles[j] = moments[j] = position[j] = position[c + j] = 0.0;
    angles[at_angle] = 1.0;
    moments[at_moment] = 1.0;
    position[at_position] = 1.0;
    position[c + at_position + 1] = 1.0;
    if (rod->closing) {
        angles[c - 1] = rod->start_angle - rod->all_angles[0];
        moments[c - 1] = rod->start_moment - rod->moments[0];
    }
    for (Py_ssize_t i = 0; i <= n; i++) {
        const double *restrict basis = rod->basis + i * m;
        const double *restrict alpha = angles + i * c, *restrict M = moments + i * c;
        double *restrict next_alpha = angles + (i + 1) * c;
        const double K = rod->stiffness[i], w = rod->length * rod->shares[i];
        const double bend = rod->moments[i] / K + rod->rest[i];
        const double by_moment = w / K, by_stiffness = -w * rod->moments[i] / (K * K);
        for (Py_ssize_t j = 0; j < c; j++)
            next_alpha[j] = alpha[j] + by_moment * M[j];
        for (Py_ssize_t j = 0; j < m; j++)
            next_alpha[j] += by_stiffness * basis[j];
        next_alpha[at_length] += rod->shares[i] * bend;
        if (rod->closing)
            next_alpha[c - 1] += rod->all_angles[i] + w * bend - rod->all_angles[i + 1];
        if (i == n)
            break;

        const double Tx = rod->tangents[2 * i], Ty = rod->tangents[2 * i + 1];
        const double turn = -edge * rod->pull[i];
        double *restrict next_M = moments + (i + 1) * c;
        for (Py_ssize_t j = 0; j < c; j++)
            next_M[j] = M[j] + turn * next_alpha[j];
        next_M[at_force] -= edge * Ty;
        next_M[at_force + 1] += edge * Tx;
        next_M[at_length] += rod->shear[i] / (double)n;
        if (rod->heavy) {
            const double *restrict slopes = rod->carried_slopes + i * m;
            const double lift = rod->e[1] * Tx - rod->e[0] * Ty, by_weight = -edge * rod->length * lift;
            for (Py_ssize_t j = 0; j < m; j++)
                next_M[j] += by_weight * slopes[j];
            next_M[at_length] -= edge * lift * rod->carried_sums[i];
        }
        if (rod->closing)
            next_M[c - 1] += rod->moments[i] + edge * rod->shear[i] - rod->moments[i + 1];

        const double *restrict x = position + 2 * i * c, *restrict y = x + c;
        double *restrict next_x = position + 2 * (i + 1) * c, *restrict next_y = next_x + c;
        const double by_x = -edge * Ty, by_y = edge * Tx;
        for (Py_ssize_t j = 0; j < c; j++) {
            next_x[j] = x[j] + by_x * next_alpha[j];
            next_y[j] = y[j] + by_y * next_alpha[j];
        }
        next_x[at_length] += Tx / (double)n;
        next_y[at_length] += Ty / (double)n;
    }
}
