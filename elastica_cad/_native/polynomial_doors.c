/* What Python sees of the kernels for piecewise polynomials and for small linear programs. */
#include "doors.h"

/* Are all indices those of one of `count` things? 0 with a Python error where one is not. */
static int within(Py_ssize_t count, Py_ssize_t places, const int64_t *indices, const char *name)
{
    for (Py_ssize_t i = 0; i < places; i++)
        if (indices[i] < 0 || indices[i] >= count) {
            PyErr_Format(PyExc_IndexError, "%s must be from 0 to %zd", name, count - 1);
            return 0;
        }
    return 1;
}

PyObject *py_legendre_sums(PyObject *module, PyObject *arguments)
{
    PyObject *series, *panels, *at, *out, *answer = NULL;
    Py_ssize_t count, order;
    if (!PyArg_ParseTuple(arguments, "O(nn)OOO", &series, &count, &order, &panels, &at, &out))
        return NULL;
    Borrowed arrays = {.count = 0};
    const Py_ssize_t places = array_size(at), values = array_size(out);
    if (places < 0 || values < 0 || order < 1 || (places && values % places))
        return refused("sums of Legendre series need places, and room for as many values at each");
    const Py_ssize_t columns = places ? values / places : 0;
    const double *coefficients, *x;
    const int64_t *panel;
    double *sums;
    BORROW(coefficients, series, places ? count * order * columns : array_size(series), "coefficients");
    BORROW_WHOLE(panel, panels, places, "panel");
    BORROW(x, at, places, "x");
    BORROW_OUT(sums, out, places * columns, "values");
    if (!within(count, places, panel, "panel"))
        goto done;
    Py_BEGIN_ALLOW_THREADS
    legendre_sums(places, order, columns, coefficients, panel, x, sums);
    Py_END_ALLOW_THREADS
    answer = Py_NewRef(Py_None);
done:
    give_back(&arrays);
    return answer;
}

PyObject *py_bernstein_sums(PyObject *module, PyObject *arguments)
{
    PyObject *series, *which, *at, *out, *answer = NULL;
    BernsteinPieces pieces;
    Py_ssize_t count;
    if (!PyArg_ParseTuple(arguments, "O(nnnn)OOO", &series, &count, &pieces.degree, &pieces.width, &pieces.first,
                          &which, &at, &out))
        return NULL;
    Borrowed arrays = {.count = 0};
    const Py_ssize_t places = array_size(at), values = array_size(out);
    if (places < 0 || values < 0 || (places && values % places) || pieces.degree < 0 || pieces.degree > MOST_DEGREE)
        return refused("sums of Bernstein polynomials need places, room for as many values at each, and a degree "
                       "of at most 32");
    pieces.columns = places ? values / places : 0;
    if (pieces.first < 0 || pieces.first + pieces.columns > pieces.width)
        return refused("there are not so many columns");
    const double *u;
    const int64_t *piece;
    double *sums;
    BORROW(pieces.series, series, count * (pieces.degree + 1) * pieces.width, "series");
    BORROW_WHOLE(piece, which, places, "piece");
    BORROW(u, at, places, "u");
    BORROW_OUT(sums, out, places * pieces.columns, "values");
    if (!within(count, places, piece, "piece"))
        goto done;
    Py_BEGIN_ALLOW_THREADS
    bernstein_sums(places, &pieces, piece, u, sums);
    Py_END_ALLOW_THREADS
    answer = Py_NewRef(Py_None);
done:
    give_back(&arrays);
    return answer;
}

/* The three arrays of an arc length; 0 with a Python error where one does not fit. */
static int borrow_arc(Borrowed *arrays, PyObject **given, ArcLengths *arc)
{
    const Py_ssize_t ends = array_size(given[0]), entries = array_size(given[2]);
    if (ends < 2 || entries < ends - 1)
        return refused("an arc length has one panel or more") != NULL;
    arc->panels = ends - 1;
    arc->terms = entries / arc->panels;
    return (arc->t = borrow(arrays, given[0], ends, 0, "t")) && (arc->s = borrow(arrays, given[1], ends, 0, "s")) &&
           (arc->series = borrow(arrays, given[2], arc->panels * arc->terms, 0, "series"));
}

PyObject *py_arc_lengths_at(PyObject *module, PyObject *arguments)
{
    PyObject *of_arc[3], *at, *out, *answer = NULL;
    if (!PyArg_ParseTuple(arguments, "OOOOO", &of_arc[0], &of_arc[1], &of_arc[2], &at, &out))
        return NULL;
    Borrowed arrays = {.count = 0};
    ArcLengths arc;
    const double *t;
    double *s;
    const Py_ssize_t places = array_size(at);
    if (places < 0 || !borrow_arc(&arrays, of_arc, &arc))
        goto done;
    BORROW(t, at, places, "parameters");
    BORROW_OUT(s, out, places, "arc lengths");
    Py_BEGIN_ALLOW_THREADS
    arc_lengths_at(&arc, places, t, s);
    Py_END_ALLOW_THREADS
    answer = Py_NewRef(Py_None);
done:
    give_back(&arrays);
    return answer;
}

PyObject *py_parameters_at(PyObject *module, PyObject *arguments)
{
    PyObject *of_arc[3], *of_cells[2], *at, *out, *answer = NULL;
    InverseCells cells;
    if (!PyArg_ParseTuple(arguments, "OOOOOddOO", &of_arc[0], &of_arc[1], &of_arc[2], &of_cells[0], &of_cells[1],
                          &cells.step_from_cubic, &cells.last_step, &at, &out))
        return NULL;
    Borrowed arrays = {.count = 0};
    ArcLengths arc;
    const double *s;
    double *t;
    const Py_ssize_t places = array_size(at), met = array_size(of_cells[0]);
    if (places < 0 || met < 0 || !borrow_arc(&arrays, of_arc, &arc))
        goto done;
    cells.of_each = (met + 1) / arc.panels;
    BORROW(cells.meets, of_cells[0], arc.panels * cells.of_each - 1, "meets");
    BORROW(cells.cubics, of_cells[1], 6 * (met + 1), "cubics");
    BORROW(s, at, places, "arc lengths");
    BORROW_OUT(t, out, places, "parameters");
    Py_BEGIN_ALLOW_THREADS
    parameters_at(&arc, &cells, places, s, t);
    Py_END_ALLOW_THREADS
    answer = Py_NewRef(Py_None);
done:
    give_back(&arrays);
    return answer;
}

PyObject *py_extremes(PyObject *module, PyObject *arguments)
{
    PyObject *series, *of_search[3], *room, *out[3], *answer = NULL;
    ExtremeSearch search;
    if (!PyArg_ParseTuple(arguments, "OOOO(idd)OOOO", &series, &of_search[0], &of_search[1], &of_search[2],
                          &search.steps, &search.band, &search.reach, &room, &out[0], &out[1], &out[2]))
        return NULL;
    Borrowed arrays = {.count = 0};
    const double *coefficients;
    double *table, *x;
    int64_t *panel, *sample;
    const Py_ssize_t basis = array_size(of_search[0]), entries = array_size(series);
    search.samples = array_size(of_search[1]);
    if (entries < 1 || basis < 1 || search.samples < 2 || basis / search.samples > MOST_ORDER)
        return refused("extremes are looked for in one panel or more, of an order of at most 32");
    search.order = basis / search.samples;
    const Py_ssize_t panels = entries / search.order, count = panels * search.samples;
    BORROW(coefficients, series, panels * search.order, "coefficients");
    BORROW(search.basis, of_search[0], search.samples * search.order, "basis");
    BORROW(search.places, of_search[1], search.samples, "places");
    BORROW(search.slopes, of_search[2], search.order * search.order, "slopes");
    BORROW_OUT(table, room, count, "table");
    BORROW_WHOLE_OUT(panel, out[0], count, "panel");
    BORROW_WHOLE_OUT(sample, out[1], count, "sample");
    BORROW_OUT(x, out[2], count, "x");
    Py_ssize_t found;
    Py_BEGIN_ALLOW_THREADS
    found = extremes(&search, panels, coefficients, table, panel, sample, x);
    Py_END_ALLOW_THREADS
    answer = PyLong_FromSsize_t(found);
done:
    give_back(&arrays);
    return answer;
}

PyObject *py_vertex_exchange(PyObject *module, PyObject *arguments)
{
    PyObject *matrix, *right, *conditions, *inverted, *out, *answer = NULL;
    FewNumbers program;
    if (!PyArg_ParseTuple(arguments, "OO(iddd)OOO", &matrix, &right, &program.most_exchanges, &program.feasible,
                          &program.pivot, &program.corrected, &conditions, &inverted, &out))
        return NULL;
    Borrowed arrays = {.count = 0};
    double *inverse, *vertex;
    int64_t *active;
    int ended;
    const Py_ssize_t n = array_size(out);
    program.numbers = n;
    program.conditions = array_size(right);
    if (n < 1 || n > MOST_NUMBERS || program.conditions < n)
        return refused("a program has 1 to 16 numbers, and no fewer conditions");
    BORROW(program.rows, matrix, program.conditions * n, "rows");
    BORROW(program.limits, right, program.conditions, "limits");
    BORROW_WHOLE_OUT(active, conditions, n, "active");
    BORROW_OUT(inverse, inverted, n * n, "inverse");
    BORROW_OUT(vertex, out, n, "vertex");
    if (!within(program.conditions, n, active, "active"))
        goto done;
    Py_BEGIN_ALLOW_THREADS
    ended = vertex_exchange(&program, active, inverse, vertex);
    Py_END_ALLOW_THREADS
    answer = PyLong_FromLong(ended);
done:
    give_back(&arrays);
    return answer;
}
