/* Linear programs in a few numbers from vertex to vertex, as mechanics/stiffness/vertex_exchange.py explains them. */
#include "kernels.h"

#include <math.h>

/* The vertex of the active conditions, corrected by them once; do they lack more than rounding then? */
static int corrected_vertex(const FewNumbers *p, const int64_t *active, const double *inverse, double *vertex)
{
    const Py_ssize_t n = p->numbers;
    double right[MOST_NUMBERS], lack = 0.0, size = 0.0;
    for (Py_ssize_t i = 0; i < n; i++)
        right[i] = p->limits[active[i]];
    for (Py_ssize_t i = 0; i < n; i++)
        vertex[i] = dot(n, inverse + i * n, right);
    for (int pass = 0; pass < 2; pass++) {
        lack = 0.0;
        for (Py_ssize_t i = 0; i < n; i++) {
            right[i] = p->limits[active[i]] - dot(n, p->rows + active[i] * n, vertex);
            lack = fmax(lack, fabs(right[i]));
        }
        for (Py_ssize_t i = 0; pass == 0 && i < n; i++)
            vertex[i] += dot(n, inverse + i * n, right);
    }
    for (Py_ssize_t i = 0; i < n; i++)
        size = fmax(size, fabs(vertex[i]));
    return !(lack <= p->corrected * size);
}

/* The condition that the vertex violates most, -1 where it violates none; -2 where it is no number. */
static inline Py_ssize_t most_violated(const FewNumbers *p, const Py_ssize_t n, const double *vertex)
{
    const double beyond = fmax(vertex[n - 1] - 1.0, 0.0);
    double least = -p->feasible;
    Py_ssize_t worst = -1;
    for (Py_ssize_t i = 0; i < p->conditions; i++) {
        const double *row = p->rows + i * n;
        const double lack = dot(n, row, vertex) - p->limits[i], size = 1.0 + row[n - 1] * beyond;
        if (lack >= least && size >= 1.0) /* a quotient would be nearer to 0 still, and quotients are slow */
            continue;
        const double excess = lack / size;
        if (isnan(excess))
            return -2;
        if (excess < least) {
            least = excess;
            worst = i;
        }
    }
    return worst;
}

int vertex_exchange(const FewNumbers *p, int64_t *active, double *inverse, double *vertex)
{
    const Py_ssize_t n = p->numbers;
    double parts[MOST_NUMBERS], column[MOST_NUMBERS];
    for (int exchange = 0; exchange < p->most_exchanges; exchange++) {
        const int worn = corrected_vertex(p, active, inverse, vertex);
        /* a curve without weight has three numbers and R: known beforehand they are summed without a loop */
        const Py_ssize_t worst = n == 4 ? most_violated(p, 4, vertex) : most_violated(p, n, vertex);
        if (worst == -2)
            return NO_VERTEX;
        if (worst == -1)
            return worn ? INVERSE_WORN : AT_VERTEX;
        double largest = 0.0, best = INFINITY;
        Py_ssize_t out = -1;
        for (Py_ssize_t j = 0; j < n; j++) {
            parts[j] = 0.0;
            for (Py_ssize_t i = 0; i < n; i++)
                parts[j] += p->rows[worst * n + i] * inverse[i * n + j];
            largest = fmax(largest, fabs(parts[j]));
        }
        for (Py_ssize_t j = 0; j < n; j++)
            if (parts[j] > p->pivot * largest && inverse[(n - 1) * n + j] / parts[j] < best) {
                best = inverse[(n - 1) * n + j] / parts[j];
                out = j;
            }
        if (out < 0)
            return NO_VERTEX;
        for (Py_ssize_t i = 0; i < n; i++) {
            column[i] = inverse[i * n + out] / parts[out];
            for (Py_ssize_t j = 0; j < n; j++)
                inverse[i * n + j] = j == out ? column[i] : inverse[i * n + j] - column[i] * parts[j];
        }
        active[out] = worst;
    }
    return NO_VERTEX;
}
