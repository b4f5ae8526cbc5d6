/* The inner loops of rods. Each has a function in Python that does the same and explains it; tests compare the two. */
#ifndef ELASTICA_LOOPS_H
#define ELASTICA_LOOPS_H

#include <Python.h>

#ifdef _MSC_VER
#define restrict __restrict
#endif

/* Loops that a processor with wide registers runs with them: the same sums in the same order, so the same digits. */
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__gnu_linux__)
#define WIDE __attribute__((target_clones("avx2", "default")))
#else
#define WIDE
#endif

#define MOST_ROWS 2         /* constraints of a mode */
#define MOST_POLYNOMIALS 16 /* among which a mode is sought */

/* A rod and the grid its derivatives are taken on: `MappedRod` and `StripGrid` of form_finding/rod_map.py. */
typedef struct {
    Py_ssize_t nodes, coefficients;
    int heavy, closing;
    double length, start_moment, start_angle;
    const double *stiffness, *moments, *all_angles, *tangents, *pull, *shear, *shares, *rest, *basis;
    const double *e, *carried_sums, *carried_slopes;
} RodAt;

/* `QuadraticProgram` of form_finding/quadratic_program.py, every unknown with room between its bounds. */
typedef struct {
    Py_ssize_t unknowns, rows;
    const double *hessian, *gradient, *lower, *upper, *A, *right, *price, *one_sided;
} Quadratic;

/* The second variation of a discrete rod: `DiscreteRod` of mechanics/rod/discrete_rod.py. */
typedef struct {
    Py_ssize_t edges;
    int rows, polynomial_count;
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

/* Angles (nodes + 1,) and moments (nodes,) of a rod from its start: `shoot` of mechanics/shooting.py. */
void shoot(Py_ssize_t nodes, const double *bend, const double *rest, const double *pull_x, const double *pull_y,
           double moment, double angle, double most_angle, double *angles, double *moments);

/* Tangents (n, 2), nodes (n + 1, 2), pull and shear (n,) of edges of one length at `angles` (n,) under `force` (n, 2). */
void shape(Py_ssize_t n, const double *angles, const double *force, const double *start, double edge, double *tangents,
           double *position, double *pull, double *shear);

/* The tridiagonal matrix of `DiscreteRod` and a row of n numbers for each axis that is held. */
void second_variation(Py_ssize_t n, const double *stiffness, const double *weights, const double *lengths,
                      const double *pull, const double *tangents, const int *free_ends, const int *held,
                      double straight, double *diagonal, double *off, double *rows);

void sensitivities(const RodAt *rod, Py_ssize_t columns, double *angles, double *moments, double *position);

/* 1 where the mode (edges,) is found and proved the lowest, 0 where it is not, -1 without memory. */
int lowest_mode(const SecondVariation *variation, double *mode, double *multipliers, double *value);

/* 1 where the steps converge, 0 where they do not, -1 without memory. */
int interior_points(const Quadratic *program, double accuracy, double *x, double *y, double *low, double *high,
                    int *iterations);

#endif
