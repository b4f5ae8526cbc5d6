/* What Python sees of the kernels for rods and their programs, and the list of all. */
#include "doors.h"

static PyObject *py_shoot(PyObject *module, PyObject *arguments)
{
    PyObject *bends, *rests, *across, *along, *out_angles, *out_moments, *answer = NULL;
    double moment, angle, wound_up;
    if (!PyArg_ParseTuple(arguments, "OOOOdddOO", &bends, &rests, &across, &along, &moment, &angle, &wound_up,
                          &out_angles, &out_moments))
        return NULL;
    Borrowed arrays = {.count = 0};
    const double *bend, *rest, *pull_x, *pull_y;
    double *angles, *moments;
    const Py_ssize_t nodes = array_size(bends);
    if (nodes < 1)
        return refused("a rod has one node or more");
    BORROW(bend, bends, nodes, "bend");
    BORROW(rest, rests, nodes, "rest");
    BORROW(pull_x, across, nodes - 1, "pull_x");
    BORROW(pull_y, along, nodes - 1, "pull_y");
    BORROW_OUT(angles, out_angles, nodes + 1, "angles");
    BORROW_OUT(moments, out_moments, nodes, "moments");
    Py_BEGIN_ALLOW_THREADS
    shoot(nodes - 1, bend, rest, pull_x, pull_y, moment, angle, wound_up, angles, moments);
    Py_END_ALLOW_THREADS
    answer = Py_NewRef(Py_None);
done:
    give_back(&arrays);
    return answer;
}

static PyObject *py_shape(PyObject *module, PyObject *arguments)
{
    PyObject *given[3], *out[4], *answer = NULL;
    double edge;
    if (!PyArg_ParseTuple(arguments, "OOOdOOOO", &given[0], &given[1], &given[2], &edge, &out[0], &out[1], &out[2],
                          &out[3]))
        return NULL;
    Borrowed arrays = {.count = 0};
    const double *angles, *force, *start;
    double *tangents, *position, *pull, *shear;
    const Py_ssize_t n = array_size(given[0]);
    if (n < 1)
        return refused("a shape has one edge or more");
    BORROW(angles, given[0], n, "angles");
    BORROW(force, given[1], 2 * n, "force");
    BORROW(start, given[2], 2, "start");
    BORROW_OUT(tangents, out[0], 2 * n, "tangents");
    BORROW_OUT(position, out[1], 2 * n + 2, "position");
    BORROW_OUT(pull, out[2], n, "pull");
    BORROW_OUT(shear, out[3], n, "shear");
    Py_BEGIN_ALLOW_THREADS
    shape(n, angles, force, start, edge, tangents, position, pull, shear);
    Py_END_ALLOW_THREADS
    answer = Py_NewRef(Py_None);
done:
    give_back(&arrays);
    return answer;
}

static PyObject *py_second_variation(PyObject *module, PyObject *arguments)
{
    PyObject *given[5], *out[3], *answer = NULL;
    int free_ends[2], held[2];
    double straight;
    if (!PyArg_ParseTuple(arguments, "OOOOOppppdOOO", &given[0], &given[1], &given[2], &given[3], &given[4],
                          &free_ends[0], &free_ends[1], &held[0], &held[1], &straight, &out[0], &out[1], &out[2]))
        return NULL;
    Borrowed arrays = {.count = 0};
    const double *stiffness, *weights, *lengths, *pull, *tangents;
    double *diagonal, *off, *rows;
    const Py_ssize_t n = array_size(given[2]);
    if (n < 1)
        return refused("a rod has one edge or more");
    BORROW(stiffness, given[0], n + 1, "stiffness");
    BORROW(weights, given[1], n + 1, "node_lengths");
    BORROW(lengths, given[2], n, "edge_lengths");
    BORROW(pull, given[3], n, "pull");
    BORROW(tangents, given[4], 2 * n, "tangents");
    BORROW_OUT(diagonal, out[0], n, "diagonal");
    BORROW_OUT(off, out[1], n - 1, "off");
    BORROW_OUT(rows, out[2], (held[0] + held[1]) * n, "rows");
    Py_BEGIN_ALLOW_THREADS
    second_variation(n, stiffness, weights, lengths, pull, tangents, free_ends, held, straight, diagonal, off, rows);
    Py_END_ALLOW_THREADS
    answer = Py_NewRef(Py_None);
done:
    give_back(&arrays);
    return answer;
}

static PyObject *py_sensitivities(PyObject *module, PyObject *arguments)
{
    PyObject *of_rod[6], *of_grid[4], *of_weight[2], *out[3], *answer = NULL;
    RodAt rod;
    if (!PyArg_ParseTuple(arguments, "OOOOOOOOOOOOdddppOOO", &of_rod[0], &of_rod[1], &of_rod[2], &of_rod[3],
                          &of_rod[4], &of_rod[5], &of_grid[0], &of_grid[1], &of_grid[2], &of_grid[3], &of_weight[0],
                          &of_weight[1], &rod.length, &rod.start_moment, &rod.start_angle, &rod.heavy, &rod.closing,
                          &out[0], &out[1], &out[2]))
        return NULL;
    Borrowed arrays = {.count = 0};
    double *angles, *moments, *position;
    const Py_ssize_t nodes = array_size(of_rod[0]), entries = array_size(of_grid[2]);
    if (nodes < 2 || entries < 0)
        return refused("a rod has two nodes or more");
    rod.edges = nodes - 1;
    rod.coefficients = entries / nodes;
    rod.columns = rod.coefficients + 7 + rod.closing;
    BORROW(rod.stiffness, of_rod[0], nodes, "stiffness");
    BORROW(rod.moments, of_rod[1], nodes, "moments");
    BORROW(rod.all_angles, of_rod[2], nodes + 1, "all_angles");
    BORROW(rod.tangents, of_rod[3], 2 * rod.edges, "tangents");
    BORROW(rod.pull, of_rod[4], rod.edges, "pull");
    BORROW(rod.shear, of_rod[5], rod.edges, "shear");
    BORROW(rod.shares, of_grid[0], nodes, "shares");
    BORROW(rod.rest, of_grid[1], nodes, "rest");
    BORROW(rod.basis, of_grid[2], nodes * rod.coefficients, "basis");
    BORROW(rod.e, of_grid[3], 2, "e");
    if (rod.heavy) {
        BORROW(rod.carried_sums, of_weight[0], nodes, "carried_sums");
        BORROW(rod.carried_slopes, of_weight[1], nodes * rod.coefficients, "carried_slopes");
    }
    BORROW_OUT(angles, out[0], (nodes + 1) * rod.columns, "angles");
    BORROW_OUT(moments, out[1], nodes * rod.columns, "moments");
    BORROW_OUT(position, out[2], 2 * nodes * rod.columns, "position");
    Py_BEGIN_ALLOW_THREADS
    sensitivities(&rod, angles, moments, position);
    Py_END_ALLOW_THREADS
    answer = Py_NewRef(Py_None);
done:
    give_back(&arrays);
    return answer;
}

static PyObject *py_weighted_gram(PyObject *module, PyObject *arguments)
{
    PyObject *matrix, *column, *shares, *out, *answer = NULL;
    if (!PyArg_ParseTuple(arguments, "OOOO", &matrix, &column, &shares, &out))
        return NULL;
    Borrowed arrays = {.count = 0};
    const double *J, *added, *weights;
    double *product;
    const Py_ssize_t rows = array_size(shares), entries = array_size(matrix);
    if (rows < 1 || entries < rows)
        return refused("there is no row to weigh, or no column");
    const Py_ssize_t columns = entries / rows;
    BORROW(J, matrix, rows * columns, "J");
    BORROW(added, column, rows, "added");
    BORROW(weights, shares, rows, "weights");
    BORROW_OUT(product, out, columns * columns, "product");
    Py_BEGIN_ALLOW_THREADS
    weighted_gram(rows, columns, J, added, weights, product);
    Py_END_ALLOW_THREADS
    answer = Py_NewRef(Py_None);
done:
    give_back(&arrays);
    return answer;
}

/* The nine arrays of a quadratic program; 0 with a Python error where one does not fit. */
static int borrow_program(Borrowed *arrays, PyObject **given, Quadratic *q)
{
    const Py_ssize_t n = array_size(given[1]), m = array_size(given[5]);
    q->unknowns = n;
    q->rows = m;
    return n >= 0 && m >= 0 && (q->hessian = borrow(arrays, given[0], n * n, 0, "hessian")) &&
           (q->gradient = borrow(arrays, given[1], n, 0, "gradient")) &&
           (q->lower = borrow(arrays, given[2], n, 0, "lower")) &&
           (q->upper = borrow(arrays, given[3], n, 0, "upper")) &&
           (q->A = borrow(arrays, given[4], m * n, 0, "rows")) &&
           (q->right = borrow(arrays, given[5], m, 0, "right")) &&
           (q->price = borrow(arrays, given[6], m, 0, "price")) &&
           (q->one_sided = borrow(arrays, given[7], m, 0, "one_sided")) &&
           (q->fixed = borrow(arrays, given[8], n, 0, "fixed"));
}

static PyObject *py_largest_distance(PyObject *module, PyObject *arguments)
{
    PyObject *given, *line, *room, *answer = NULL;
    if (!PyArg_ParseTuple(arguments, "OOO", &given, &line, &room))
        return NULL;
    Borrowed arrays = {.count = 0};
    const double *points, *chain;
    double *bounds, distance;
    const Py_ssize_t count = array_size(room), entries = array_size(line);
    if (count < 1 || entries < 4)
        return refused("a distance asks for one point and two nodes or more");
    BORROW(points, given, 2 * count, "points");
    BORROW(chain, line, entries, "chain");
    BORROW_OUT(bounds, room, count, "bounds");
    Py_BEGIN_ALLOW_THREADS
    distance = largest_distance(count, points, entries / 2, chain, bounds);
    Py_END_ALLOW_THREADS
    answer = PyFloat_FromDouble(distance);
done:
    give_back(&arrays);
    return answer;
}

static PyObject *py_hermite(PyObject *module, PyObject *arguments)
{
    PyObject *given[3], *out[2], *answer = NULL;
    if (!PyArg_ParseTuple(arguments, "OOOOO", &given[0], &given[1], &given[2], &out[0], &out[1]))
        return NULL;
    Borrowed arrays = {.count = 0};
    const double *position, *slopes, *s;
    double *places, *directions;
    const Py_ssize_t entries = array_size(given[0]), count = array_size(given[2]);
    if (entries < 4 || entries % 2 || count < 0)
        return refused("cubics pass through two nodes or more");
    BORROW(position, given[0], entries, "position");
    BORROW(slopes, given[1], entries, "slopes");
    BORROW(s, given[2], count, "s");
    BORROW_OUT(places, out[0], 2 * count, "places");
    BORROW_OUT(directions, out[1], 2 * count, "directions");
    Py_BEGIN_ALLOW_THREADS
    hermite(entries / 2, position, slopes, count, s, places, directions);
    Py_END_ALLOW_THREADS
    answer = Py_NewRef(Py_None);
done:
    give_back(&arrays);
    return answer;
}

static PyObject *py_active_sets(PyObject *module, PyObject *arguments)
{
    PyObject *given[9], *guessed[4], *out[4], *answer = NULL;
    int most_guesses, patience, settled;
    Quadratic q;
    if (!PyArg_ParseTuple(arguments, "OOOOOOOOOOOOOiiOOOO", &given[0], &given[1], &given[2], &given[3], &given[4],
                          &given[5], &given[6], &given[7], &given[8], &guessed[0], &guessed[1], &guessed[2],
                          &guessed[3], &most_guesses, &patience, &out[0], &out[1], &out[2], &out[3]))
        return NULL;
    Borrowed arrays = {.count = 0};
    double *low, *high, *met, *broken, *x, *y, *at_lower, *at_upper;
    if (!borrow_program(&arrays, given, &q))
        goto done;
    const Py_ssize_t n = q.unknowns, m = q.rows;
    BORROW_OUT(low, guessed[0], n, "low");
    BORROW_OUT(high, guessed[1], n, "high");
    BORROW_OUT(met, guessed[2], m, "met");
    BORROW_OUT(broken, guessed[3], m, "broken");
    BORROW_OUT(x, out[0], n, "x");
    BORROW_OUT(y, out[1], m, "row_multipliers");
    BORROW_OUT(at_lower, out[2], n, "lower_multipliers");
    BORROW_OUT(at_upper, out[3], n, "upper_multipliers");
    Py_BEGIN_ALLOW_THREADS
    settled = active_sets(&q, low, high, met, broken, most_guesses, patience, x, y, at_lower, at_upper);
    Py_END_ALLOW_THREADS
    answer = settled < 0 ? PyErr_NoMemory() : PyLong_FromLong(settled);
done:
    give_back(&arrays);
    return answer;
}

static PyObject *py_interior_points(PyObject *module, PyObject *arguments)
{
    PyObject *given[9], *out[4], *answer = NULL;
    int status, iterations = 0;
    Quadratic q;
    InteriorSettings set;
    if (!PyArg_ParseTuple(arguments, "OOOOOOOOO(ddddddiiii)OOOO", &given[0], &given[1], &given[2], &given[3],
                          &given[4], &given[5], &given[6], &given[7], &given[8], &set.accuracy, &set.feasible,
                          &set.guess_at, &set.backoff, &set.centered, &set.rounding, &set.cycling,
                          &set.most_factorisations, &set.most_guesses, &set.patience, &out[0], &out[1], &out[2],
                          &out[3]))
        return NULL;
    Borrowed arrays = {.count = 0};
    double *x, *y, *at_lower, *at_upper;
    if (!borrow_program(&arrays, given, &q))
        goto done;
    BORROW_OUT(x, out[0], q.unknowns, "x");
    BORROW_OUT(y, out[1], q.rows, "row_multipliers");
    BORROW_OUT(at_lower, out[2], q.unknowns, "lower_multipliers");
    BORROW_OUT(at_upper, out[3], q.unknowns, "upper_multipliers");
    Py_BEGIN_ALLOW_THREADS
    status = interior_points(&q, &set, x, y, at_lower, at_upper, &iterations);
    Py_END_ALLOW_THREADS
    answer = status < 0 ? PyErr_NoMemory() : Py_BuildValue("ii", status, iterations);
done:
    give_back(&arrays);
    return answer;
}

static PyObject *py_lowest_mode(PyObject *module, PyObject *arguments)
{
    PyObject *given[5], *out[2], *answer = NULL;
    SecondVariation v;
    int found = 0;
    if (!PyArg_ParseTuple(arguments, "OOOOO(iidddd)OO", &given[0], &given[1], &given[2], &given[3], &given[4],
                          &v.smooth, &v.refinements, &v.rank_tolerance, &v.singular, &v.rounding, &v.settled, &out[0],
                          &out[1]))
        return NULL;
    Borrowed arrays = {.count = 0};
    double *mode, *multipliers, value = 0.0;
    const Py_ssize_t n = array_size(given[0]), entries = array_size(given[3]);
    if (n < 2 || entries < 0 || entries > 2 * n || v.smooth < 1 || v.smooth > 16)
        return refused("a mode has two edges or more, at most two rows and 16 polynomials");
    v.edges = n;
    v.rows = (int)(entries / n);
    BORROW(v.diagonal, given[0], n, "diagonal");
    BORROW(v.off, given[1], n - 1, "off");
    BORROW(v.lengths, given[2], n, "lengths");
    BORROW(v.constraints, given[3], v.rows * n, "constraint_rows");
    BORROW(v.polynomials, given[4], n * v.smooth, "polynomials");
    BORROW_OUT(mode, out[0], n, "mode");
    BORROW_OUT(multipliers, out[1], 2, "multipliers");
    Py_BEGIN_ALLOW_THREADS
    found = lowest_mode(&v, mode, multipliers, &value);
    Py_END_ALLOW_THREADS
    if (found < 0)
        PyErr_NoMemory();
    else
        answer = found ? PyFloat_FromDouble(value) : Py_NewRef(Py_None);
done:
    give_back(&arrays);
    return answer;
}

static PyMethodDef functions[] = {
    {"locate", py_locate, METH_VARARGS, NULL},
    {"legendre_sums", py_legendre_sums, METH_VARARGS, NULL},
    {"bernstein_sums", py_bernstein_sums, METH_VARARGS, NULL},
    {"curve_at", py_curve_at, METH_VARARGS, NULL},
    {"arc_lengths_at", py_arc_lengths_at, METH_VARARGS, NULL},
    {"parameters_at", py_parameters_at, METH_VARARGS, NULL},
    {"speed_panels", py_speed_panels, METH_VARARGS, NULL},
    {"resolve_panels", py_resolve_panels, METH_VARARGS, NULL},
    {"extremes", py_extremes, METH_VARARGS, NULL},
    {"vertex_exchange", py_vertex_exchange, METH_VARARGS, NULL},
    {"bernstein_roots", py_bernstein_roots, METH_VARARGS, NULL},
    {"cubic_extremes", py_cubic_extremes, METH_VARARGS, NULL},
    {"spline_motion", py_spline_motion, METH_VARARGS, NULL},
    {"extraction", py_extraction, METH_VARARGS, NULL},
    {"fit_splines", py_fit_splines, METH_VARARGS, NULL},
    {"derivative_series", py_derivative_series, METH_VARARGS, NULL},
    {"inverse_cells", py_inverse_cells, METH_VARARGS, NULL},
    {"quintics_at", py_quintics_at, METH_VARARGS, NULL},
    {"nearest_on_quintics", py_nearest_on_quintics, METH_VARARGS, NULL},
    {"spline_values", py_spline_values, METH_VARARGS, NULL},
    {"are_cones", py_are_cones, METH_VARARGS, NULL},
    {"tangent_angles", py_tangent_angles, METH_VARARGS, NULL},
    {"angles_at", py_angles_at, METH_VARARGS, NULL},
    {"near_pairs", py_near_pairs, METH_VARARGS, NULL},
    {"chord_pairs", py_chord_pairs, METH_VARARGS, NULL},
    {"away_from_rims", py_away_from_rims, METH_VARARGS, NULL},
    {"shoot", py_shoot, METH_VARARGS, NULL},
    {"shape", py_shape, METH_VARARGS, NULL},
    {"second_variation", py_second_variation, METH_VARARGS, NULL},
    {"sensitivities", py_sensitivities, METH_VARARGS, NULL},
    {"weighted_gram", py_weighted_gram, METH_VARARGS, NULL},
    {"largest_distance", py_largest_distance, METH_VARARGS, NULL},
    {"hermite", py_hermite, METH_VARARGS, NULL},
    {"active_sets", py_active_sets, METH_VARARGS, NULL},
    {"lowest_mode", py_lowest_mode, METH_VARARGS, NULL},
    {"interior_points", py_interior_points, METH_VARARGS, NULL},
    {NULL, NULL, 0, NULL},
};

static struct PyModuleDef definition = {
    PyModuleDef_HEAD_INIT, "elastica_cad._native.kernels", NULL, 0, functions, NULL, NULL, NULL, NULL,
};

PyMODINIT_FUNC PyInit_kernels(void)
{
    return PyModuleDef_Init(&definition);
}
