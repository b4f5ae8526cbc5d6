/* What makes a curve quick to evaluate: its derivatives piece by piece, and where Newton's method starts in its length. */
#include "kernels.h"

#include <float.h>
#include <math.h>
#include <string.h>

/* Control points (degree + 1, numbers) of a piece as Bezier points, seen from the place (x, y). */
static void bezier_points(const CurvePieces *c, Py_ssize_t piece, const double *place, double *points)
{
    const Py_ssize_t size = c->degree + 1;
    const double *matrix = c->matrix + piece * size * size, *acting = c->control_points + 3 * c->first[piece];
    memset(points, 0, size * c->numbers * sizeof(double));
    for (Py_ssize_t i = 0; i < size; i++) {
        const double *point = acting + 3 * i;
        const double near[3] = {point[0] - point[2] * place[0], point[1] - point[2] * place[1], point[2]};
        for (Py_ssize_t j = 0; j < size; j++)
            for (Py_ssize_t number = 0; number < c->numbers; number++)
                points[j * c->numbers + number] += matrix[j * size + i] * near[number];
    }
}

void derivative_series(const CurvePieces *c, const double *raised, double *series)
{
    const Py_ssize_t size = c->degree + 1, n = c->numbers, width = DERIVATIVES * n;
    const Py_ssize_t most = c->degree < DERIVATIVES - 1 ? c->degree : DERIVATIVES - 1;
    double points[3 * (MOST_DEGREE + 1)];
    memset(series, 0, c->count * size * width * sizeof(double));
    for (Py_ssize_t piece = 0; piece < c->count; piece++) {
        const double *to_degree = raised;
        double factor = 1.0;
        bezier_points(c, piece, c->origins + 2 * piece, points);
        for (Py_ssize_t k = 0; k <= most; k++) {
            const Py_ssize_t left = size - k;
            if (k) {
                for (Py_ssize_t i = 0; i < left * n; i++)
                    points[i] = points[i + n] - points[i];
                factor *= left / c->widths[piece];
            }
            for (Py_ssize_t j = 0; j < size; j++, to_degree += left)
                for (Py_ssize_t i = 0; i < left; i++)
                    for (Py_ssize_t number = 0; number < n; number++)
                        series[(piece * size + j) * width + k * n + number] +=
                            to_degree[i] * points[i * n + number] * factor;
        }
    }
}

void inverse_cells(const ArcLengths *arc, Py_ssize_t cells, const double *at_steps, const double *paces,
                   double *meets, double *cubics)
{
    const double step = 2.0 / cells;
    for (Py_ssize_t p = 0; p < arc->panels; p++) {
        const double *series = arc->series + p * arc->terms;
        double reached = arc->s[p], pace = dot(arc->terms, series, paces);
        for (Py_ssize_t i = 0; i < cells; i++) {
            const int is_last = i + 1 == cells;
            const double *there = at_steps + (i + 1) * arc->terms;
            const double end = is_last ? arc->s[p + 1] : dot(arc->terms, series, there) + arc->s[p];
            const double size = fmax(end - reached, DBL_MIN);
            const double next_pace = dot(arc->terms, series, paces + (i + 1) * arc->terms);
            /* dx over the cell at its ends, as fast as there */
            const double first = pace > 0 ? size / pace : 0.0, last = next_pace > 0 ? size / next_pace : 0.0;
            double *cubic = cubics + 6 * (p * cells + i);
            cubic[0] = reached;
            cubic[1] = 1 / size;
            cubic[2] = -1.0 + i * step;
            cubic[3] = first;
            cubic[4] = 3 * step - 2 * first - last;
            cubic[5] = first + last - 2 * step;
            if (p || i)
                meets[p * cells + i - 1] = reached;
            reached = end;
            pace = next_pace;
        }
    }
}
