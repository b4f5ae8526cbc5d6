/* The kernels, each the twin of a function in Python that stays and that tests compare it with. */
#ifndef ELASTICA_KERNELS_H
#define ELASTICA_KERNELS_H

#include "arrays.h"

/* A rod and the grid its derivatives are taken on: `MappedRod`, `StripGrid` of forming/nearest/rod_map.py. */
typedef struct {
    Py_ssize_t edges, coefficients, columns;
    int heavy, closing;
    double length, start_moment, start_angle;
    const double *stiffness, *moments, *all_angles, *tangents, *pull, *shear, *shares, *rest, *basis;
    const double *e, *carried_sums, *carried_slopes;
} RodAt;

/* `QuadraticProgram` of forming/optimizer/quadratic_program.py. */
typedef struct {
    Py_ssize_t unknowns, rows;
    const double *hessian, *gradient, *lower, *upper, *A, *right, *price, *one_sided, *fixed;
} Quadratic;

/* The constants of that module. */
typedef struct {
    double accuracy, feasible, guess_at, backoff, centered, rounding;
    int cycling, most_factorisations, most_guesses, patience;
} InteriorSettings;

/* The second variation of a discrete rod as `DiscreteRod` in mechanics/rod/discrete_rod.py has it. */
typedef struct {
    Py_ssize_t edges;
    int rows, smooth, refinements;
    double rank_tolerance, singular, rounding, settled;
    const double *diagonal, *off, *lengths, *constraints, *polynomials;
} SecondVariation;

#define MOST_DEGREE 32  /* of curves that are evaluated here */
#define MOST_ORDER 32   /* of panels */
#define NEAR 4          /* steps in which a place is looked for before all are halved */
#define MOST_NUMBERS 16 /* of a linear program, R among them */

/* `RationalPieces` of geometry/curves/curve_derivatives.py: columns from `first` of series (degree + 1, width) each. */
typedef struct {
    Py_ssize_t count, degree, width, first, columns;
    const double *series;
} BernsteinPieces;

/* `ArcLength` of geometry/curves/arc_length.py, */
typedef struct {
    Py_ssize_t panels, terms;
    const double *t, *s, *series;
} ArcLengths;

/* and where Newton's method starts in it, with when it stops. */
typedef struct {
    Py_ssize_t of_each;
    const double *meets, *cubics;
    double step_from_cubic, last_step;
} InverseCells;

/* How that is made, */
typedef struct {
    int order;
    double fine, noise, narrowest, short_share;
    const double *shares, *to_series, *integrate;
} SpeedPanels;

/* and the panels of mechanics/stiffness/quadrature_panels.py: the rule on each, and which there are. */
typedef struct {
    int order;
    const double *nodes, *left, *right, *last;
} PanelRule;

typedef struct {
    Py_ssize_t count, zeros_count;
    double rest;
    const double *left, *right, *zero_left, *zero_right, *zeros;
} CutPanels;

/* When one is fine enough, and its numbers at its nodes. */
typedef struct {
    double resolved, noise, narrow;
} PanelLimits;

typedef struct {
    double *left, *zero_left, *zero_right, *t, *velocity, *stretch, *kappa;
} PanelNodes;

/* The constants of `PanelFunction.found_extremes` in geometry/polynomials/panel_functions.py. */
typedef struct {
    Py_ssize_t order, samples;
    int steps;
    double band, reach;
    const double *basis, *places, *slopes;
} ExtremeSearch;

/* `VertexExchange` of mechanics/stiffness/vertex_exchange.py. */
typedef struct {
    Py_ssize_t conditions, numbers;
    int most_exchanges;
    double feasible, pivot, corrected;
    const double *rows, *limits;
} FewNumbers;

/* The spans of geometry/polynomials/fit_function.py, rule and probes on each, and values at all (sites + probes, columns). */
typedef struct {
    Py_ssize_t spans, degree, count, sites, probes, columns;
    const int64_t *first;
    const double *widths, *matrix, *inner, *weight, *probing, *samples;
} SplineFit;

#define DERIVATIVES 4 /* of a curve, its position among them, that are kept piece by piece */

/* `RationalPieces` of geometry/curves/curve_derivatives.py: numbers of a place are 2, or 3 with its weight. */
typedef struct {
    Py_ssize_t count, degree, numbers, points;
    const int64_t *first;
    const double *control_points, *matrix, *widths, *origins;
} CurvePieces;

#define MOST_CUTS 48 /* of a polynomial, in two each time */
#define SPLITS 3     /* places near the middle where it may be cut */

/* `roots` of geometry/polynomials/bernstein.py. */
typedef struct {
    Py_ssize_t count, degree;
    int most_cuts;
    double gentle, blur, splits[SPLITS];
} RootSearch;

/* A curve over arc length: quintics (6, pieces, 2), the constant terms first, between nodes (pieces + 1,). */
typedef struct {
    Py_ssize_t pieces;
    const double *nodes, *rows;
} Quintics;

/* Places x, y (count,) in the order of cells, their numbers, and from where to where in that order each looks. */
typedef struct {
    Py_ssize_t count;
    const double *x, *y;
    const int64_t *number, *first, *end;
    double reach;
} NearSearch;

/* A function in Bezier coefficients (pieces, degree + 1) between edges (pieces + 1,). */
typedef struct {
    Py_ssize_t degree, pieces;
    const double *edges, *coefficients;
} SplinePieces;

/* Parts of a curve by the Bernstein coefficients (count, order, 2) along their velocities, */
typedef struct {
    Py_ssize_t count, order;
    const double *velocities;
} Hodographs;

/* when they are `TangentCones` of geometry/curves/tangent_angle.py, by shares of a speed, */
typedef struct {
    double still, slow, along;
} ConeLimits;

/* and `TangentAngle` there. */
typedef struct {
    Py_ssize_t count;
    const double *edges, *axis, *angle;
} TangentAngles;

enum { NO_VERTEX, AT_VERTEX, INVERSE_WORN };

static inline double between(double low, double x, double high)
{
    return x < low ? low : x > high ? high : x;
}

/* How many of rising numbers `sought` is at or beyond. */
static inline Py_ssize_t passed(Py_ssize_t count, const double *rising, double sought)
{
    Py_ssize_t low = 0;
    while (low < count) {
        const Py_ssize_t middle = (low + count) / 2;
        if (rising[middle] <= sought)
            low = middle + 1;
        else
            count = middle;
    }
    return low;
}

/* The same of numbers asked one after the other, which mostly rise: first looked for near where the last was. */
static inline Py_ssize_t passed_near(Py_ssize_t count, const double *rising, double sought, Py_ssize_t last)
{
    if (last > 0 && !(rising[last - 1] <= sought))
        return passed(last - 1, rising, sought);
    for (const Py_ssize_t far = last + NEAR; last < count && rising[last] <= sought; last++)
        if (last == far)
            return last + passed(count - last, rising + last, sought);
    return last;
}

/* In which of the pieces between edges (pieces + 1,) a place lies, at an edge the right or the left one. */
static inline Py_ssize_t piece_of(Py_ssize_t pieces, const double *edges, int to_left, double place, Py_ssize_t last)
{
    Py_ssize_t piece = passed_near(pieces - 1, edges + 1, place, last);
    while (to_left && piece > 0 && edges[piece] == place)
        piece--;
    return piece;
}

/* Coefficients of a polynomial brought down to `left` of them at u, by de Casteljau: one is its value, the step between
   two its slope over the degree. */
static inline void collapse(Py_ssize_t count, Py_ssize_t left, double u, double *row)
{
    for (; count > left; count--)
        for (Py_ssize_t i = 0; i < count - 1; i++)
            row[i] += (row[i + 1] - row[i]) * u;
}

/* Four sums at a time, which a processor adds beside each other. */
static inline double dot(Py_ssize_t n, const double *restrict a, const double *restrict b)
{
    double sum[4] = {0.0, 0.0, 0.0, 0.0};
    Py_ssize_t i = 0;
    for (; i + 4 <= n; i += 4)
        for (int j = 0; j < 4; j++)
            sum[j] += a[i + j] * b[i + j];
    for (; i < n; i++)
        sum[0] += a[i] * b[i];
    return (sum[0] + sum[1]) + (sum[2] + sum[3]);
}

void shoot(Py_ssize_t n, const double *bend, const double *rest, const double *pull_x, const double *pull_y,
           double moment, double angle, double wound_up, double *angles, double *moments);

/* Tangents (n, 2), nodes (n + 1, 2), pull and shear (n,) of edges of one length at `angles` (n,) under `force` (n, 2). */
void shape(Py_ssize_t n, const double *angles, const double *force, const double *start, double edge, double *tangents,
           double *position, double *pull, double *shear);

/* The tridiagonal matrix and the rows of `DiscreteRod` in mechanics/rod/discrete_rod.py, a row for each axis that is held. */
void second_variation(Py_ssize_t n, const double *stiffness, const double *weights, const double *lengths,
                      const double *pull, const double *tangents, const int *free_ends, const int *held,
                      double straight, double *diagonal, double *off, double *rows);

void sensitivities(const RodAt *rod, double *angles, double *moments, double *position);

void weighted_gram(Py_ssize_t rows, Py_ssize_t columns, const double *J, const double *added, const double *weights,
                   double *product);

/* The largest distance of points (count, 2) from a chain (nodes, 2) that runs beside them, NaN where a place is; `bounds`
   is room. */
double largest_distance(Py_ssize_t count, const double *points, Py_ssize_t nodes, const double *chain, double *bounds);

/* Places and derivatives (count, 2) at s (count,) in 0..1 on the cubics through nodes (nodes, 2) at equal steps. */
void hermite(Py_ssize_t nodes, const double *position, const double *slopes, Py_ssize_t count, const double *s,
             double *places, double *directions);

/* The guess that settled, counted from 1; 0 where none did, -1 without memory. */
int active_sets(const Quadratic *program, double *at_low, double *at_high, double *met, double *broken,
                int most_guesses, int patience, double *x, double *y, double *low, double *high);

/* 1 converged, 2 exact from a guess, 0 neither, -1 without memory. */
int interior_points(const Quadratic *program, const InteriorSettings *settings, double *x, double *y, double *low,
                    double *high, int *iterations);

/* 1 where the mode is found and proved the lowest, 0 where it is not, -1 without memory. */
int lowest_mode(const SecondVariation *variation, double *mode, double *multipliers, double *value);

/* In which piece between edges (pieces + 1,) places lie, at an edge the right or the left one, and where, from low to 1. */
void locate(Py_ssize_t pieces, const double *edges, int to_left, double low, Py_ssize_t count, const double *places,
            int64_t *piece, double *x);

/* Legendre series (order, columns) of the panels (places,) at x: values (places, columns). */
void legendre_sums(Py_ssize_t places, Py_ssize_t order, Py_ssize_t columns, const double *coefficients,
                   const int64_t *panel, const double *x, double *values);

void bernstein_sums(Py_ssize_t places, const BernsteinPieces *pieces, const int64_t *piece, const double *u,
                    double *values);

/* The same at parameters t between edges (count + 1,), from the first column on; the first two are seen from `origins`. */
void curve_at(const BernsteinPieces *pieces, const double *edges, int to_left, const double *origins,
              Py_ssize_t places, const double *t, double *values);

void arc_lengths_at(const ArcLengths *arc, Py_ssize_t places, const double *t, double *s);

void parameters_at(const ArcLengths *arc, const InverseCells *cells, Py_ssize_t places, const double *s, double *t);

/* How many panels there are; -1 where `room` has no place for them, -2 without memory. */
Py_ssize_t speed_panels(const SpeedPanels *how, const BernsteinPieces *pieces, const double *edges, Py_ssize_t room,
                        double *starts, double *series);

/* The panels that those cut become, from left to right: how many, -1 where `room` has no place for them. */
Py_ssize_t resolve_panels(const PanelRule *rule, const BernsteinPieces *pieces, const double *edges, const CutPanels *cut,
                          const PanelLimits *limits, Py_ssize_t room, const PanelNodes *out);

/* How many extremes there are: `panel`, `sample` and `x` have room for all samples, and `table` for their values. */
Py_ssize_t extremes(const ExtremeSearch *search, Py_ssize_t panels, const double *coefficients, double *table,
                    int64_t *panel, int64_t *sample, double *x);

/* One of the three above; `active` and `inverse` are where it begins and where it ends. */
int vertex_exchange(const FewNumbers *program, int64_t *active, double *inverse, double *vertex);

/* How many zeros there are, sharp ones and stretches (2,) that rounding fills; -1 where `room` has no place for them. */
Py_ssize_t bernstein_roots(const RootSearch *search, const double *coefficients, const double *noise, Py_ssize_t room,
                           int64_t *piece, int64_t *sharp, double *places);

/* Place and value of the least and of the largest value of cubics (pieces, 4) between edges. */
void cubic_extremes(Py_ssize_t pieces, const double *coefficients, const double *edges, double *found);

/* B-splines of one degree: knots (count, knot_count), points x w, y w, w, first and last parameter (count, 2). */
typedef struct {
    Py_ssize_t count, degree, knot_count;
    const double *knots, *points, *domain;
} SplineRows;

/* Points (places, 2) at u in [0, 1] of splines which (places,), and their derivatives by u. */
void spline_motion(const SplineRows *rows, Py_ssize_t places, const int64_t *which, const double *u, double *position,
                   double *velocity);

/* Of knots (2 degree, spans) about each span, rows (degree + 1, degree + 1) of its Bezier points. */
void extraction(Py_ssize_t spans, Py_ssize_t degree, const double *near, double *matrix);

/* Coefficients (count, columns) and the largest error (spans,) on each span; 0 where no spline is nearest. `band` is room
   for (count, degree + 1). */
int fit_splines(const SplineFit *fit, double *band, double *coefficients, double *errors);

/* `_series` of those pieces, (count, degree + 1, DERIVATIVES, numbers), by matrices that raise their degree. */
void derivative_series(const CurvePieces *pieces, const double *raised, double *series);

/* `ArcLength._inverse`, by the terms (cells + 1, terms) of its series and of their slopes where cells meet. */
void inverse_cells(const ArcLengths *arc, Py_ssize_t cells, const double *at_steps, const double *paces,
                   double *meets, double *cubics);

/* Points and slopes (count, 2) at arc lengths s (count,). */
void quintics_at(const Quintics *curve, Py_ssize_t count, const double *s, double *points, double *slopes);

/* Of points (count, 2) the nearest places of the curve, with its tangents there: Newton's steps from the nearest of the
   stations, whose places are the chain (stations, 2). */
void nearest_on_quintics(const Quintics *curve, Py_ssize_t stations, const double *station, const double *chain,
                         double length, int steps, Py_ssize_t count, const double *points, double *s, double *places,
                         double *tangents);

/* Does the velocity of each part keep within an open half plane, nowhere near a standstill? */
int are_cones(const Hodographs *parts, const ConeLimits *limits);

/* The spread of the angle over parts that do, with the axis (count, 2) of each and the angle of that. */
double tangent_angles(const Hodographs *parts, double *axis, double *angle);

/* Angles (places,) of velocities (places, 2) at parameters t (places,). */
void angles_at(const TangentAngles *tabulated, int to_left, Py_ssize_t places, const double *t, const double *velocity,
               double *angles);

/* Values (count,) at places x (count,); beyond the edges the outermost pieces go on. */
void spline_values(const SplinePieces *spline, Py_ssize_t count, const double *x, double *values);

/* How many pairs are no farther apart than the reach; those that there is room for are filled in. */
Py_ssize_t near_pairs(const NearSearch *search, Py_ssize_t room, int64_t *lower, int64_t *higher);

/* How many pairs of chords of two polylines have boxes that meet; those that there is room for are filled in. */
Py_ssize_t chord_pairs(Py_ssize_t p_points, const double *p, Py_ssize_t q_points, const double *q, Py_ssize_t room,
                       int64_t *of_p, int64_t *of_q);

/* How far places (count,) are from the sides (sides, 2) of closed polygons, negative within. */
void away_from_rims(Py_ssize_t sides, const double *start, const double *end, Py_ssize_t count, const double *along,
                    const double *across, double *away);

#endif
