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

void sensitivities(const RodAt *rod, double *angles, double *moments, double *position);

void weighted_gram(Py_ssize_t rows, Py_ssize_t columns, const double *J, const double *added, const double *weights,
                   double *product);

/* The largest distance of points (count, 2) from a chain (nodes, 2) that runs beside them, NaN where a place is; `bounds`
   is room. */
double largest_distance(Py_ssize_t count, const double *points, Py_ssize_t nodes, const double *chain, double *bounds);

/* The guess that settled, counted from 1; 0 where none did, -1 without memory. */
int active_sets(const Quadratic *program, double *at_low, double *at_high, double *met, double *broken,
                int most_guesses, int patience, double *x, double *y, double *low, double *high);

/* 1 converged, 2 exact from a guess, 0 neither, -1 without memory. */
int interior_points(const Quadratic *program, const InteriorSettings *settings, double *x, double *y, double *low,
                    double *high, int *iterations);

/* 1 where the mode is found and proved the lowest, 0 where it is not, -1 without memory. */
int lowest_mode(const SecondVariation *variation, double *mode, double *multipliers, double *value);

#endif
