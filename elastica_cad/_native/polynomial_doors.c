/* What Python sees of the kernels for piecewise polynomials and for small linear programs. */
#include "doors.h"

PyObject *py_locate(PyObject *module, PyObject *arguments)
{
    PyObject *ends, *at, *out[2], *answer = NULL;
    int to_left;
    double low;
    if (!PyArg_ParseTuple(arguments, "OpdOOO", &ends, &to_left, &low, &at, &out[0], &out[1]))
        return NULL;
    Borrowed arrays = {.count = 0};
    const double *edges, *places;
    double *x;
    int64_t *piece;
    const Py_ssize_t pieces = array_size(ends) - 1, count = array_size(at);
    if (pieces < 1 || count < 0)
        return refused("places are looked for between two edges or more");
    BORROW(edges, ends, pieces + 1, "edges");
    BORROW(places, at, count, "places");
    BORROW_WHOLE_OUT(piece, out[0], count, "piece");
    BORROW_OUT(x, out[1], count, "x");
    Py_BEGIN_ALLOW_THREADS
    locate(pieces, edges, to_left, low, count, places, piece, x);
    Py_END_ALLOW_THREADS
    answer = Py_NewRef(Py_None);
done:
    give_back(&arrays);
    return answer;
}

PyObject *py_legendre_sums(PyObject *module, PyObject *arguments)
{
    PyObject *series, *panels, *at, *out, *answer = NULL;
    Py_ssize_t count, order;
    if (!PyArg_ParseTuple(arguments, "O(nn)OOO", &series, &count, &order, &panels, &at, &out))
        return NULL;
    Borrowed arrays = {.count = 0};
    const Py_ssize_t places = array_size(at), values = array_size(out);
    if (places < 0 || values < 0 || order < 1 || order > MOST_ORDER || (places && values % places))
        return refused("sums of Legendre series of at most 32 terms need places, and room for as many values at each");
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

/* The series of pieces whose sizes are known; 0 with a Python error where they do not fit. */
static int borrow_pieces(Borrowed *arrays, PyObject *series, BernsteinPieces *pieces)
{
    if (pieces->degree < 0 || pieces->degree > MOST_DEGREE || pieces->count < 1 || pieces->first < 0 ||
        pieces->columns < 0 || pieces->first + pieces->columns > pieces->width)
        return refused("pieces are of a degree of at most 32, and have the columns that are asked for") != NULL;
    const Py_ssize_t size = pieces->count * (pieces->degree + 1) * pieces->width;
    return (pieces->series = borrow(arrays, series, size, 0, "series")) != NULL;
}

PyObject *py_bernstein_sums(PyObject *module, PyObject *arguments)
{
    PyObject *series, *which, *at, *out, *answer = NULL;
    BernsteinPieces pieces;
    if (!PyArg_ParseTuple(arguments, "O(nnnn)OOO", &series, &pieces.count, &pieces.degree, &pieces.width,
                          &pieces.first, &which, &at, &out))
        return NULL;
    Borrowed arrays = {.count = 0};
    const Py_ssize_t places = array_size(at), values = array_size(out);
    if (places < 0 || values < 0 || (places && values % places))
        return refused("sums of Bernstein polynomials need places, and room for as many values at each");
    pieces.columns = places ? values / places : 0;
    const double *u;
    const int64_t *piece;
    double *sums;
    if (!borrow_pieces(&arrays, series, &pieces))
        goto done;
    BORROW_WHOLE(piece, which, places, "piece");
    BORROW(u, at, places, "u");
    BORROW_OUT(sums, out, places * pieces.columns, "values");
    if (!within(pieces.count, places, piece, "piece"))
        goto done;
    Py_BEGIN_ALLOW_THREADS
    bernstein_sums(places, &pieces, piece, u, sums);
    Py_END_ALLOW_THREADS
    answer = Py_NewRef(Py_None);
done:
    give_back(&arrays);
    return answer;
}

PyObject *py_curve_at(PyObject *module, PyObject *arguments)
{
    PyObject *series, *ends, *seen_from, *at, *out, *answer = NULL;
    BernsteinPieces pieces = {.first = 0};
    int to_left;
    if (!PyArg_ParseTuple(arguments, "O(nnn)OpOOO", &series, &pieces.count, &pieces.degree, &pieces.width, &ends,
                          &to_left, &seen_from, &at, &out))
        return NULL;
    Borrowed arrays = {.count = 0};
    const double *edges, *origins, *t;
    double *values;
    pieces.degree -= 1; /* the series has a term more */
    const Py_ssize_t places = array_size(at), entries = array_size(out);
    if (places < 0 || entries < 2 * places || (places && entries % places))
        return refused("a curve has places, and room for two numbers or more at each");
    pieces.columns = places ? entries / places : 2;
    if (!borrow_pieces(&arrays, series, &pieces))
        goto done;
    BORROW(edges, ends, pieces.count + 1, "edges");
    BORROW(origins, seen_from, 2 * pieces.count, "origins");
    BORROW(t, at, places, "t");
    BORROW_OUT(values, out, places * pieces.columns, "values");
    Py_BEGIN_ALLOW_THREADS
    curve_at(&pieces, edges, to_left, origins, places, t, values);
    Py_END_ALLOW_THREADS
    answer = Py_NewRef(Py_None);
done:
    give_back(&arrays);
    return answer;
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

PyObject *py_speed_panels(PyObject *module, PyObject *arguments)
{
    PyObject *series, *ends, *of_how[3], *out[2], *answer = NULL;
    SpeedPanels how;
    BernsteinPieces pieces = {.columns = 2};
    Py_ssize_t found;
    if (!PyArg_ParseTuple(arguments, "O(nnnn)OOOO(dddd)OO", &series, &pieces.count, &pieces.degree, &pieces.width,
                          &pieces.first, &ends, &of_how[0], &of_how[1], &of_how[2], &how.fine, &how.noise,
                          &how.narrowest, &how.short_share, &out[0], &out[1]))
        return NULL;
    Borrowed arrays = {.count = 0};
    const double *edges;
    double *starts, *lengths;
    const Py_ssize_t order = array_size(of_how[0]), room = array_size(out[0]);
    if (order < 3 || order > MOST_ORDER || room < 1)
        return refused("the speed has 3 to 32 coefficients on a panel, and there is room for one panel or more");
    how.order = (int)order;
    if (!borrow_pieces(&arrays, series, &pieces))
        goto done;
    BORROW(edges, ends, pieces.count + 1, "edges");
    BORROW(how.shares, of_how[0], order, "shares");
    BORROW(how.to_series, of_how[1], order * order, "to_series");
    BORROW(how.integrate, of_how[2], order * (order + 1), "integrate");
    BORROW_OUT(starts, out[0], room, "starts");
    BORROW_OUT(lengths, out[1], room * (order + 1), "lengths");
    Py_BEGIN_ALLOW_THREADS
    found = speed_panels(&how, &pieces, edges, room, starts, lengths);
    Py_END_ALLOW_THREADS
    answer = found == -2 ? PyErr_NoMemory() : PyLong_FromSsize_t(found);
done:
    give_back(&arrays);
    return answer;
}

PyObject *py_resolve_panels(PyObject *module, PyObject *arguments)
{
    PyObject *series, *ends, *of_rule[4], *of_cut[5], *of_nodes[7], *answer = NULL;
    PanelRule rule;
    CutPanels cut;
    PanelLimits limits;
    PanelNodes out;
    BernsteinPieces pieces = {.columns = 6};
    if (!PyArg_ParseTuple(arguments, "O(nnnn)O(OOOO)(OOOOO)d(ddd)(OOOOOOO)", &series, &pieces.count, &pieces.degree,
                          &pieces.width, &pieces.first, &ends, &of_rule[0], &of_rule[1], &of_rule[2], &of_rule[3],
                          &of_cut[0], &of_cut[1], &of_cut[2], &of_cut[3], &of_cut[4], &cut.rest, &limits.resolved,
                          &limits.noise, &limits.narrow, &of_nodes[0], &of_nodes[1], &of_nodes[2], &of_nodes[3],
                          &of_nodes[4], &of_nodes[5], &of_nodes[6]))
        return NULL;
    Borrowed arrays = {.count = 0};
    const double *edges;
    const Py_ssize_t order = array_size(of_rule[0]), count = array_size(of_cut[0]);
    const Py_ssize_t room = array_size(of_nodes[0]);
    cut.count = count;
    cut.zeros_count = array_size(of_cut[4]);
    if (order < 2 || order > MOST_ORDER || count < 0 || cut.zeros_count < 0 || room < 0)
        return refused("a rule has 2 to 32 nodes");
    rule.order = (int)order;
    if (!borrow_pieces(&arrays, series, &pieces))
        goto done;
    BORROW(edges, ends, pieces.count + 1, "edges");
    BORROW(rule.nodes, of_rule[0], order, "nodes");
    BORROW(rule.left, of_rule[1], order * order, "left");
    BORROW(rule.right, of_rule[2], order * order, "right");
    BORROW(rule.last, of_rule[3], 2 * order, "last");
    BORROW(cut.left, of_cut[0], count, "left");
    BORROW(cut.right, of_cut[1], count, "right");
    BORROW(cut.zero_left, of_cut[2], count, "zero_left");
    BORROW(cut.zero_right, of_cut[3], count, "zero_right");
    BORROW(cut.zeros, of_cut[4], cut.zeros_count, "zeros");
    BORROW_OUT(out.left, of_nodes[0], room, "left");
    BORROW_OUT(out.zero_left, of_nodes[1], room, "zero_left");
    BORROW_OUT(out.zero_right, of_nodes[2], room, "zero_right");
    BORROW_OUT(out.t, of_nodes[3], room * order, "t");
    BORROW_OUT(out.velocity, of_nodes[4], 2 * room * order, "velocity");
    BORROW_OUT(out.stretch, of_nodes[5], room * order, "stretch");
    BORROW_OUT(out.kappa, of_nodes[6], room * order, "curvature");
    Py_ssize_t found;
    Py_BEGIN_ALLOW_THREADS
    found = resolve_panels(&rule, &pieces, edges, &cut, &limits, room, &out);
    Py_END_ALLOW_THREADS
    answer = PyLong_FromSsize_t(found);
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

PyObject *py_bernstein_roots(PyObject *module, PyObject *arguments)
{
    PyObject *polynomials, *levels, *out[3], *answer = NULL;
    RootSearch search;
    if (!PyArg_ParseTuple(arguments, "OO(iddddd)OOO", &polynomials, &levels, &search.most_cuts, &search.gentle,
                          &search.blur, &search.splits[0], &search.splits[1], &search.splits[2], &out[0], &out[1], &out[2]))
        return NULL;
    Borrowed arrays = {.count = 0};
    const double *coefficients, *noise;
    double *places;
    int64_t *piece, *sharp;
    const Py_ssize_t entries = array_size(polynomials), count = array_size(levels), room = array_size(out[0]);
    if (entries < 0 || count < 1 || room < 0 || entries < count || entries / count > MOST_DEGREE + 1 ||
        search.most_cuts < 0 || search.most_cuts > MOST_CUTS)
        return refused("zeros are those of one polynomial or more of a degree of at most 32, cut at most 48 times");
    search.count = count;
    search.degree = entries / count - 1;
    BORROW(coefficients, polynomials, count * (search.degree + 1), "coefficients");
    BORROW(noise, levels, count, "noise");
    BORROW_WHOLE_OUT(piece, out[0], room, "piece");
    BORROW_WHOLE_OUT(sharp, out[1], room, "sharp");
    BORROW_OUT(places, out[2], 2 * room, "places");
    Py_ssize_t found;
    Py_BEGIN_ALLOW_THREADS
    found = bernstein_roots(&search, coefficients, noise, room, piece, sharp, places);
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
