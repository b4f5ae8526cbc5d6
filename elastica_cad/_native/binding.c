/* What Python sees of the compiled loops.

   Each function is given the sizes of its arrays as numbers, checks every array against them, and runs its loop without
   the interpreter's lock. Sizes are at most MOST_SIZE, so that no product of those of an array overflows. */
#include "loops.h"

#include <stdint.h>
#include <string.h>

#define MOST_ARRAYS 20
#define MOST_SIZE 100000
#define MOST_UNKNOWNS 2000 /* of a quadratic program, and rows: their products are held in memory */

typedef struct {
    Py_buffer views[MOST_ARRAYS];
    int count;
} Arrays;

/* The numbers of `object`, which must be (rows, columns) contiguous float64; NULL with a Python error where not. */
static double *numbers(Arrays *arrays, PyObject *object, int writable, Py_ssize_t rows, Py_ssize_t columns,
                       const char *name)
{
    static double nothing; /* where an empty array begins */
    Py_buffer *view = &arrays->views[arrays->count];
    const int flags = PyBUF_C_CONTIGUOUS | PyBUF_FORMAT | (writable ? PyBUF_WRITABLE : 0);
    if (PyObject_GetBuffer(object, view, flags) != 0)
        return NULL;
    arrays->count++;
    const int64_t size = (int64_t)rows * (int64_t)columns;
    if (view->format == NULL || strcmp(view->format, "d") != 0 || view->len % 8 != 0 ||
        (int64_t)(view->len / 8) != size) {
        PyErr_Format(PyExc_ValueError, "%s must be %zd times %zd contiguous float64 numbers", name, rows, columns);
        return NULL;
    }
    return size ? view->buf : &nothing;
}

#define IN(target, object, rows, columns)                                                \
    if ((target = numbers(&arrays, object, 0, rows, columns, #target)) == NULL) goto done
#define OUT(target, object, rows, columns)                                               \
    if ((target = numbers(&arrays, object, 1, rows, columns, #target)) == NULL) goto done

static int within(Py_ssize_t size, Py_ssize_t least, Py_ssize_t most, const char *name)
{
    if (size >= least && size <= most)
        return 1;
    PyErr_Format(PyExc_ValueError, "%s must be from %zd to %zd, not %zd", name, least, most, size);
    return 0;
}

static PyObject *finished(Arrays *arrays, PyObject *answer)
{
    for (int i = 0; i < arrays->count; i++)
        PyBuffer_Release(&arrays->views[i]);
    return answer;
}

static PyObject *py_shoot(PyObject *module, PyObject *arguments)
{
    PyObject *given[4], *out[2], *answer = NULL;
    double moment, angle, most_angle, *angles, *moments;
    const double *bend, *rest, *pull_x, *pull_y;
    Py_ssize_t nodes;
    Arrays arrays = {.count = 0};
    if (!PyArg_ParseTuple(arguments, "nOOOOdddOO", &nodes, &given[0], &given[1], &given[2], &given[3], &moment, &angle,
                          &most_angle, &out[0], &out[1]) ||
        !within(nodes, 1, MOST_SIZE, "nodes"))
        return NULL;
    IN(bend, given[0], nodes, 1);
    IN(rest, given[1], nodes, 1);
    IN(pull_x, given[2], nodes - 1, 1);
    IN(pull_y, given[3], nodes - 1, 1);
    OUT(angles, out[0], nodes + 1, 1);
    OUT(moments, out[1], nodes, 1);
    Py_BEGIN_ALLOW_THREADS
    shoot(nodes, bend, rest, pull_x, pull_y, moment, angle, most_angle, angles, moments);
    Py_END_ALLOW_THREADS
    answer = Py_NewRef(Py_None);
done:
    return finished(&arrays, answer);
}

static PyObject *py_shape(PyObject *module, PyObject *arguments)
{
    PyObject *given[3], *out[4], *answer = NULL;
    double edge_length, *tangents, *position, *pull, *shear;
    const double *angles, *force, *start;
    Py_ssize_t edges;
    Arrays arrays = {.count = 0};
    if (!PyArg_ParseTuple(arguments, "nOOOdOOOO", &edges, &given[0], &given[1], &given[2], &edge_length, &out[0],
                          &out[1], &out[2], &out[3]) ||
        !within(edges, 1, MOST_SIZE, "edges"))
        return NULL;
    IN(angles, given[0], edges, 1);
    IN(force, given[1], edges, 2);
    IN(start, given[2], 2, 1);
    OUT(tangents, out[0], edges, 2);
    OUT(position, out[1], edges + 1, 2);
    OUT(pull, out[2], edges, 1);
    OUT(shear, out[3], edges, 1);
    Py_BEGIN_ALLOW_THREADS
    shape(edges, angles, force, start, edge_length, tangents, position, pull, shear);
    Py_END_ALLOW_THREADS
    answer = Py_NewRef(Py_None);
done:
    return finished(&arrays, answer);
}

static PyObject *py_second_variation(PyObject *module, PyObject *arguments)
{
    PyObject *given[5], *out[3], *answer = NULL;
    double straight, *diagonal, *off, *rows;
    const double *stiffness, *node_lengths, *edge_lengths, *pull, *tangents;
    int free_ends[2], held[2];
    Py_ssize_t edges;
    Arrays arrays = {.count = 0};
    if (!PyArg_ParseTuple(arguments, "nOOOOOppppdOOO", &edges, &given[0], &given[1], &given[2], &given[3], &given[4],
                          &free_ends[0], &free_ends[1], &held[0], &held[1], &straight, &out[0], &out[1], &out[2]) ||
        !within(edges, 1, MOST_SIZE, "edges"))
        return NULL;
    IN(stiffness, given[0], edges + 1, 1);
    IN(node_lengths, given[1], edges + 1, 1);
    IN(edge_lengths, given[2], edges, 1);
    IN(pull, given[3], edges, 1);
    IN(tangents, given[4], edges, 2);
    OUT(diagonal, out[0], edges, 1);
    OUT(off, out[1], edges - 1, 1);
    OUT(rows, out[2], held[0] + held[1], edges);
    Py_BEGIN_ALLOW_THREADS
    second_variation(edges, stiffness, node_lengths, edge_lengths, pull, tangents, free_ends, held, straight, diagonal,
                     off, rows);
    Py_END_ALLOW_THREADS
    answer = Py_NewRef(Py_None);
done:
    return finished(&arrays, answer);
}

static PyObject *py_sensitivities(PyObject *module, PyObject *arguments)
{
    PyObject *given[12], *out[3], *answer = NULL;
    double *angles, *moments, *position;
    RodAt rod;
    Arrays arrays = {.count = 0};
    if (!PyArg_ParseTuple(arguments, "nnOOOOOOOOOOOOdddppOOO", &rod.nodes, &rod.coefficients, &given[0], &given[1],
                          &given[2], &given[3], &given[4], &given[5], &given[6], &given[7], &given[8], &given[9],
                          &given[10], &given[11], &rod.length, &rod.start_moment, &rod.start_angle, &rod.heavy,
                          &rod.closing, &out[0], &out[1], &out[2]) ||
        !within(rod.nodes, 2, MOST_SIZE, "nodes") || !within(rod.coefficients, 1, MOST_UNKNOWNS, "coefficients"))
        return NULL;
    const Py_ssize_t nodes = rod.nodes, columns = rod.coefficients + 7 + rod.closing;
    IN(rod.stiffness, given[0], nodes, 1);
    IN(rod.moments, given[1], nodes, 1);
    IN(rod.all_angles, given[2], nodes + 1, 1);
    IN(rod.tangents, given[3], nodes - 1, 2);
    IN(rod.pull, given[4], nodes - 1, 1);
    IN(rod.shear, given[5], nodes - 1, 1);
    IN(rod.shares, given[6], nodes, 1);
    IN(rod.rest, given[7], nodes, 1);
    IN(rod.basis, given[8], nodes, rod.coefficients);
    IN(rod.e, given[9], 2, 1);
    if (rod.heavy) {
        IN(rod.carried_sums, given[10], nodes, 1);
        IN(rod.carried_slopes, given[11], nodes, rod.coefficients);
    }
    OUT(angles, out[0], nodes + 1, columns);
    OUT(moments, out[1], nodes, columns);
    OUT(position, out[2], 2 * nodes, columns);
    Py_BEGIN_ALLOW_THREADS
    sensitivities(&rod, columns, angles, moments, position);
    Py_END_ALLOW_THREADS
    answer = Py_NewRef(Py_None);
done:
    return finished(&arrays, answer);
}

static PyObject *py_weighted_gram(PyObject *module, PyObject *arguments)
{
    PyObject *given[3], *out, *answer = NULL;
    const double *J, *added, *weights;
    double *product;
    Py_ssize_t rows, columns;
    Arrays arrays = {.count = 0};
    if (!PyArg_ParseTuple(arguments, "nnOOOO", &rows, &columns, &given[0], &given[1], &given[2], &out) ||
        !within(rows, 1, MOST_SIZE, "rows") || !within(columns, 1, MOST_UNKNOWNS, "columns"))
        return NULL;
    IN(J, given[0], rows, columns);
    IN(added, given[1], rows, 1);
    IN(weights, given[2], rows, 1);
    OUT(product, out, columns, columns);
    Py_BEGIN_ALLOW_THREADS
    weighted_gram(rows, columns, J, added, weights, product);
    Py_END_ALLOW_THREADS
    answer = Py_NewRef(Py_None);
done:
    return finished(&arrays, answer);
}

static PyObject *py_largest_distance(PyObject *module, PyObject *arguments)
{
    PyObject *given[3], *answer = NULL;
    const double *points, *chain;
    double *room, distance;
    Py_ssize_t count, nodes;
    Arrays arrays = {.count = 0};
    if (!PyArg_ParseTuple(arguments, "nnOOO", &count, &nodes, &given[0], &given[1], &given[2]) ||
        !within(count, 1, MOST_SIZE, "points") || !within(nodes, 2, MOST_SIZE, "nodes"))
        return NULL;
    IN(points, given[0], count, 2);
    IN(chain, given[1], nodes, 2);
    OUT(room, given[2], count, 1);
    Py_BEGIN_ALLOW_THREADS
    distance = largest_distance(count, points, nodes, chain, room);
    Py_END_ALLOW_THREADS
    answer = PyFloat_FromDouble(distance);
done:
    return finished(&arrays, answer);
}

static PyObject *py_hermite(PyObject *module, PyObject *arguments)
{
    PyObject *given[3], *out[2], *answer = NULL;
    const double *position, *slopes, *s;
    double *places, *directions;
    Py_ssize_t nodes, count;
    Arrays arrays = {.count = 0};
    if (!PyArg_ParseTuple(arguments, "nnOOOOO", &nodes, &count, &given[0], &given[1], &given[2], &out[0], &out[1]) ||
        !within(nodes, 2, MOST_SIZE, "nodes") || !within(count, 0, MOST_SIZE, "places"))
        return NULL;
    IN(position, given[0], nodes, 2);
    IN(slopes, given[1], nodes, 2);
    IN(s, given[2], count, 1);
    OUT(places, out[0], count, 2);
    OUT(directions, out[1], count, 2);
    Py_BEGIN_ALLOW_THREADS
    hermite(nodes, position, slopes, count, s, places, directions);
    Py_END_ALLOW_THREADS
    answer = Py_NewRef(Py_None);
done:
    return finished(&arrays, answer);
}

static PyObject *py_interior_points(PyObject *module, PyObject *arguments)
{
    PyObject *given[8], *out[4], *answer = NULL;
    double accuracy, *x, *row_multipliers, *lower_multipliers, *upper_multipliers;
    int converged, iterations = 0;
    Quadratic q;
    Arrays arrays = {.count = 0};
    if (!PyArg_ParseTuple(arguments, "nnOOOOOOOOdOOOO", &q.unknowns, &q.rows, &given[0], &given[1], &given[2],
                          &given[3], &given[4], &given[5], &given[6], &given[7], &accuracy, &out[0], &out[1], &out[2],
                          &out[3]) ||
        !within(q.unknowns, 1, MOST_UNKNOWNS, "unknowns") || !within(q.rows, 0, MOST_UNKNOWNS, "rows"))
        return NULL;
    IN(q.hessian, given[0], q.unknowns, q.unknowns);
    IN(q.gradient, given[1], q.unknowns, 1);
    IN(q.lower, given[2], q.unknowns, 1);
    IN(q.upper, given[3], q.unknowns, 1);
    IN(q.A, given[4], q.rows, q.unknowns);
    IN(q.right, given[5], q.rows, 1);
    IN(q.price, given[6], q.rows, 1);
    IN(q.one_sided, given[7], q.rows, 1);
    OUT(x, out[0], q.unknowns, 1);
    OUT(row_multipliers, out[1], q.rows, 1);
    OUT(lower_multipliers, out[2], q.unknowns, 1);
    OUT(upper_multipliers, out[3], q.unknowns, 1);
    Py_BEGIN_ALLOW_THREADS
    converged = interior_points(&q, accuracy, x, row_multipliers, lower_multipliers, upper_multipliers, &iterations);
    Py_END_ALLOW_THREADS
    answer = converged < 0 ? PyErr_NoMemory() : Py_BuildValue("ii", converged, iterations);
done:
    return finished(&arrays, answer);
}

static PyObject *py_lowest_mode(PyObject *module, PyObject *arguments)
{
    PyObject *given[5], *out[2], *answer = NULL;
    double *mode, *multipliers, value = 0.0;
    Py_ssize_t edges, rows, polynomials;
    SecondVariation v;
    int found;
    Arrays arrays = {.count = 0};
    if (!PyArg_ParseTuple(arguments, "nnnOOOOOOO", &edges, &rows, &polynomials, &given[0], &given[1], &given[2],
                          &given[3], &given[4], &out[0], &out[1]) ||
        !within(edges, 2, MOST_SIZE, "edges") || !within(rows, 0, MOST_ROWS, "rows") ||
        !within(polynomials, 1, MOST_POLYNOMIALS, "polynomials"))
        return NULL;
    v.edges = edges;
    v.rows = (int)rows;
    v.polynomial_count = (int)polynomials;
    IN(v.diagonal, given[0], edges, 1);
    IN(v.off, given[1], edges - 1, 1);
    IN(v.lengths, given[2], edges, 1);
    IN(v.constraints, given[3], rows, edges);
    IN(v.polynomials, given[4], edges, polynomials);
    OUT(mode, out[0], edges, 1);
    OUT(multipliers, out[1], rows, 1);
    Py_BEGIN_ALLOW_THREADS
    found = lowest_mode(&v, mode, multipliers, &value);
    Py_END_ALLOW_THREADS
    if (found < 0)
        PyErr_NoMemory();
    else
        answer = found ? PyFloat_FromDouble(value) : Py_NewRef(Py_None);
done:
    return finished(&arrays, answer);
}

static PyMethodDef functions[] = {
    {"shoot", py_shoot, METH_VARARGS, NULL},
    {"shape", py_shape, METH_VARARGS, NULL},
    {"second_variation", py_second_variation, METH_VARARGS, NULL},
    {"sensitivities", py_sensitivities, METH_VARARGS, NULL},
    {"weighted_gram", py_weighted_gram, METH_VARARGS, NULL},
    {"largest_distance", py_largest_distance, METH_VARARGS, NULL},
    {"hermite", py_hermite, METH_VARARGS, NULL},
    {"lowest_mode", py_lowest_mode, METH_VARARGS, NULL},
    {"interior_points", py_interior_points, METH_VARARGS, NULL},
    {NULL, NULL, 0, NULL},
};

static struct PyModuleDef definition = {
    PyModuleDef_HEAD_INIT, "elastica_cad._native.loops", NULL, 0, functions, NULL, NULL, NULL, NULL,
};

PyMODINIT_FUNC PyInit_loops(void)
{
    return PyModuleDef_Init(&definition);
}
