/* A spline cut into short panels: for its arc length, and as the stiffness along it is found on. */
#include "kernels.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Columns of the series at one parameter. */
static void at_parameter(const BernsteinPieces *pieces, const double *edges, double t, double *values)
{
    const Py_ssize_t spans = pieces->count;
    const int64_t span = passed(spans - 1, edges + 1, t);
    const double u = between(0.0, (t - edges[span]) / (edges[span + 1] - edges[span]), 1.0);
    bernstein_sums(1, pieces, &span, &u, values);
}

/* How badly the last of `count` coefficients have died away, and all of them: of the speed on one panel. */
static double speed_series(const SpeedPanels *how, const BernsteinPieces *pieces, const double *edges, int64_t span,
                           double low, double width, double *coefficients)
{
    double speeds[MOST_ORDER], tail = 0.0;
    const double from = edges[span], size = edges[span + 1] - from;
    for (int i = 0; i < how->order; i++) {
        double velocity[2];
        const double u = between(0.0, (low + width * how->shares[i] - from) / size, 1.0);
        bernstein_sums(1, pieces, &span, &u, velocity);
        speeds[i] = hypot(velocity[0], velocity[1]);
    }
    for (int k = 0; k < how->order; k++) {
        coefficients[k] = 0.0;
        for (int i = 0; i < how->order; i++)
            coefficients[k] += speeds[i] * how->to_series[i * how->order + k];
    }
    for (int k = how->order - 3; k < how->order; k++)
        tail = fmax(tail, fabs(coefficients[k]));
    return tail;
}

typedef struct {
    int64_t span;
    double low, width, parent, tail;
    double coefficients[MOST_ORDER];
} SpeedPanel;

Py_ssize_t speed_panels(const SpeedPanels *how, const BernsteinPieces *pieces, const double *edges, Py_ssize_t room,
                        double *starts, double *series)
{
    const int terms = how->order + 1;
    const double whole = edges[pieces->count] - edges[0];
    SpeedPanel *level = malloc((size_t)room * sizeof *level), *following = malloc((size_t)room * sizeof *level);
    Py_ssize_t count = pieces->count <= room ? pieces->count : 0, found = count ? 0 : -1;
    double total = 0.0;
    if (level == NULL || following == NULL)
        count = 0, found = -2;
    for (Py_ssize_t i = 0; i < count; i++)
        level[i] = (SpeedPanel){.span = i, .low = edges[i], .width = edges[i + 1] - edges[i], .parent = INFINITY};
    while (count > 0) {
        double sum = 0.0;
        Py_ssize_t next = 0;
        for (Py_ssize_t i = 0; i < count; i++) {
            SpeedPanel *p = level + i;
            p->tail = speed_series(how, pieces, edges, p->span, p->low, p->width, p->coefficients);
            sum += p->coefficients[0] * p->width;
        }
        total = fmax(total, sum);
        for (Py_ssize_t i = 0; i < count && found >= 0; i++) {
            const SpeedPanel *p = level + i;
            const double mean = p->coefficients[0], tail = p->tail;
            if (tail <= how->fine * mean || tail * p->width <= how->short_share * total ||
                p->width < how->narrowest * whole || (tail < how->noise * mean && tail > 0.3 * p->parent)) {
                if (found == room) {
                    found = -1;
                    break;
                }
                starts[found] = p->low;
                for (int j = 0; j < terms; j++) {
                    double sum_of_terms = 0.0;
                    for (int k = 0; k < how->order; k++)
                        sum_of_terms += p->coefficients[k] * p->width / 2 * how->integrate[k * terms + j];
                    series[found * terms + j] = sum_of_terms;
                }
                found++;
                continue;
            }
            const double halvings = ceil(log2(tail / (how->fine * mean)) / (how->order - 1));
            const int parts = isnan(halvings) ? 0 : 1 << (int)between(1.0, halvings, 3.0);
            if (parts == 0 || next + parts > room) {
                found = -1;
                break;
            }
            for (int j = 0; j < parts; j++)
                following[next++] = (SpeedPanel){
                    .span = p->span, .low = p->low + j * (p->width / parts), .width = p->width / parts,
                    .parent = tail,
                };
        }
        SpeedPanel *swapped = level;
        level = following;
        following = swapped;
        count = found < 0 ? 0 : next;
    }
    free(level);
    free(following);
    return found;
}

/* Curvature and, where asked for, its slope by arc length from derivatives (6,) by any parameter. */
static double curvature_of(const double *d, double *slope)
{
    const double speed2 = d[0] * d[0] + d[1] * d[1], turn = d[0] * d[3] - d[1] * d[2];
    if (slope != NULL) {
        const double further = d[0] * d[5] - d[1] * d[4], along = d[0] * d[2] + d[1] * d[3];
        *slope = further / (speed2 * speed2) - 3 * turn * along / (speed2 * speed2 * speed2);
    }
    return turn / (speed2 * sqrt(speed2));
}

/* The larger, or what is no number. */
static double worse(double a, double b)
{
    return isnan(a) || a > b ? a : b;
}

/* Share of a function's largest value that its last two coefficients still hold. */
static double unresolved(const PanelRule *rule, const double *values)
{
    double largest = 0.0, last = 0.0;
    for (int i = 0; i < rule->order; i++)
        largest = worse(fabs(values[i]), largest);
    for (int k = 0; k < 2; k++)
        last = worse(fabs(dot(rule->order, rule->last + k * rule->order, values)), last);
    return last / largest;
}

/* A cut's panels at their nodes, and how much of each is unresolved. */
static void evaluate_panels(const PanelRule *rule, const BernsteinPieces *pieces, const double *edges, const CutPanels *cut,
                     double *t, double *velocity, double *stretch, double *kappa, double *tails)
{
    const int order = rule->order;
    for (Py_ssize_t i = 0; i < cut->count; i++) {
        const double half = (cut->right[i] - cut->left[i]) / 2, middle = cut->left[i] + half;
        const int from_left = cut->zero_left[i] != 0, beside = from_left || cut->zero_right[i] != 0;
        double growth[MOST_ORDER], quotients[MOST_ORDER], nearest = cut->zeros_count ? cut->zeros[0] : 0.0;
        double *T = t + i * order, *S = stretch + i * order, *K = kappa + i * order;
        for (Py_ssize_t z = 1; z < cut->zeros_count; z++)
            if (fabs(cut->zeros[z] - middle) < fabs(nearest - middle))
                nearest = cut->zeros[z];
        for (int j = 0; j < order; j++) {
            double d[6], slope, *v = velocity + 2 * (i * order + j);
            T[j] = cut->left[i] + half * (1 + rule->nodes[j]);
            at_parameter(pieces, edges, T[j], d);
            v[0] = d[0] * half;
            v[1] = d[1] * half;
            S[j] = hypot(v[0], v[1]);
            K[j] = curvature_of(d, &slope) - cut->rest;
            growth[j] = slope * S[j];
        }
        for (int j = 0; j < order && beside; j++)
            K[j] = from_left ? dot(order, rule->left + j * order, growth)
                             : -dot(order, rule->right + j * order, growth);
        for (int j = 0; j < order; j++) {
            double over = cut->zeros_count ? half * (1 + rule->nodes[j]) + (cut->left[i] - nearest) : 1.0;
            if (beside)
                over = from_left ? 1 + rule->nodes[j] : rule->nodes[j] - 1;
            quotients[j] = over / K[j];
        }
        tails[i] = worse(unresolved(rule, quotients), unresolved(rule, S));
    }
}

#define MOST_OPEN 256 /* panels that wait while those to their left are cut */

typedef struct {
    double left, right, zero_left, zero_right, tail;
} OpenPanel;

/* Into how many parts a panel is cut: halving divides the last coefficient by 2^order or so. */
static int parts_of(double tail, double resolved, int order)
{
    const double halvings = ceil(log2((isfinite(tail) ? tail : 1.0) / resolved) / order);
    return 1 << (int)between(1.0, halvings, 3.0);
}

Py_ssize_t resolve_panels(const PanelRule *rule, const BernsteinPieces *pieces, const double *edges, const CutPanels *cut,
                          const PanelLimits *limits, Py_ssize_t room, const PanelNodes *out)
{
    const int order = rule->order;
    Py_ssize_t found = 0;
    for (Py_ssize_t i = 0; i < cut->count; i++) {
        OpenPanel open[MOST_OPEN] = {
            {cut->left[i], cut->right[i], cut->zero_left[i], cut->zero_right[i], INFINITY},
        };
        for (int waiting = 1; waiting > 0;) {
            const OpenPanel p = open[--waiting];
            const double width = p.right - p.left;
            double tail;
            if (found == room)
                return -1;
            const CutPanels alone = {1, cut->zeros_count, cut->rest, &p.left, &p.right, &p.zero_left,
                                     &p.zero_right, cut->zeros};
            evaluate_panels(rule, pieces, edges, &alone, out->t + found * order, out->velocity + 2 * found * order,
                            out->stretch + found * order, out->kappa + found * order, &tail);
            if (tail <= limits->resolved || (tail < limits->noise && tail > 0.3 * p.tail) || width < limits->narrow) {
                out->left[found] = p.left;
                out->zero_left[found] = p.zero_left;
                out->zero_right[found++] = p.zero_right;
                continue;
            }
            const int parts = parts_of(tail, limits->resolved, order);
            if (waiting + parts > MOST_OPEN)
                return -1;
            for (int k = parts - 1; k >= 0; k--) /* the left one is looked at first */
                open[waiting++] = (OpenPanel){
                    .left = p.left + width * ((double)k / parts),
                    .right = k + 1 == parts ? p.right : p.left + width * ((k + 1.0) / parts),
                    .zero_left = k == 0 ? p.zero_left : 0.0,
                    .zero_right = k + 1 == parts ? p.zero_right : 0.0,
                    .tail = tail,
                };
        }
    }
    return found;
}
