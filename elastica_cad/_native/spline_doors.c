/* What Python sees of splines: of spline_fits.c, spline_points.c, curve_tables.c, curve_places.c,
   tangent_cones.c, and of cubics. */
#include "doors.h"

PyObject *py_cubic_extremes(PyObject *module, PyObject *arguments)
{
    PyObject *cubics, *ends, *answer = NULL;
    if (!PyArg_ParseTuple(arguments, "OO", &cubics, &ends))
        return NULL;
    Borrowed arrays = {.count = 0};
    const double *coefficients, *edges;
    double found[4];
    const Py_ssize_t pieces = array_size(ends) - 1;
    if (pieces < 1)
        return refused("a spline has one piece or more");
    BORROW(coefficients, cubics, 4 * pieces, "pieces");
    BORROW(edges, ends, pieces + 1, "edges");
    Py_BEGIN_ALLOW_THREADS
    cubic_extremes(pieces, coefficients, edges, found);
    Py_END_ALLOW_THREADS
    answer = Py_BuildValue("(dd)(dd)", found[0], found[1], found[2], found[3]);
done:
    give_back(&arrays);
    return answer;
}

PyObject *py_spline_motion(PyObject *module, PyObject *arguments)
{
    PyObject *of_splines[3], *numbers, *at, *out[2], *answer = NULL;
    SplineRows rows;
    if (!PyArg_ParseTuple(arguments, "n(OOO)OOOO", &rows.degree, &of_splines[0], &of_splines[1], &of_splines[2],
                          &numbers, &at, &out[0], &out[1]))
        return NULL;
    Borrowed arrays = {.count = 0};
    const Py_ssize_t knots = array_size(of_splines[0]), ends = array_size(of_splines[2]), places = array_size(at);
    rows.count = ends / 2;
    if (knots < 0 || places < 0 || rows.count < 1 || knots % rows.count || rows.degree < 1 ||
        rows.degree > MOST_DEGREE || knots / rows.count < 2 * rows.degree + 2)
        return refused("splines side by side have a degree of 1 to 32, and knots for one span or more");
    rows.knot_count = knots / rows.count;
    const int64_t *which;
    const double *u;
    double *position, *velocity;
    BORROW(rows.knots, of_splines[0], knots, "knots");
    BORROW(rows.points, of_splines[1], 3 * rows.count * (rows.knot_count - rows.degree - 1), "points");
    BORROW(rows.domain, of_splines[2], 2 * rows.count, "domain");
    BORROW_WHOLE(which, numbers, places, "which");
    BORROW(u, at, places, "u");
    BORROW_OUT(position, out[0], 2 * places, "position");
    BORROW_OUT(velocity, out[1], 2 * places, "velocity");
    if (!within(rows.count, places, which, "which"))
        goto done;
    Py_BEGIN_ALLOW_THREADS
    spline_motion(&rows, places, which, u, position, velocity);
    Py_END_ALLOW_THREADS
    answer = Py_NewRef(Py_None);
done:
    give_back(&arrays);
    return answer;
}

PyObject *py_extraction(PyObject *module, PyObject *arguments)
{
    PyObject *knots, *out, *answer = NULL;
    Py_ssize_t degree;
    if (!PyArg_ParseTuple(arguments, "nOO", &degree, &knots, &out))
        return NULL;
    Borrowed arrays = {.count = 0};
    const Py_ssize_t entries = array_size(knots);
    if (entries < 0 || degree < 1 || degree > MOST_DEGREE || entries % (2 * degree))
        return refused("spans have a degree of 1 to 32, and twice as many knots about each");
    const Py_ssize_t spans = entries / (2 * degree);
    const double *near;
    double *matrix;
    BORROW(near, knots, entries, "near");
    BORROW_OUT(matrix, out, spans * (degree + 1) * (degree + 1), "matrix");
    Py_BEGIN_ALLOW_THREADS
    extraction(spans, degree, near, matrix);
    Py_END_ALLOW_THREADS
    answer = Py_NewRef(Py_None);
done:
    give_back(&arrays);
    return answer;
}

PyObject *py_fit_splines(PyObject *module, PyObject *arguments)
{
    PyObject *of_spans[3], *of_rule[3], *values, *room, *out[2], *answer = NULL;
    SplineFit fit;
    if (!PyArg_ParseTuple(arguments, "n(OOO)(OOO)OOOO", &fit.degree, &of_spans[0], &of_spans[1], &of_spans[2],
                          &of_rule[0], &of_rule[1], &of_rule[2], &values, &room, &out[0], &out[1]))
        return NULL;
    Borrowed arrays = {.count = 0};
    double *band, *coefficients, *errors;
    int fitted;
    const Py_ssize_t size = fit.degree + 1, spans = array_size(of_spans[0]), entries = array_size(room);
    const Py_ssize_t sites = array_size(of_rule[1]), probed = array_size(of_rule[2]), held = array_size(out[0]);
    if (fit.degree < 1 || fit.degree > MOST_DEGREE || spans < 1 || entries < size || sites < 1 || probed < 0 || held < 0)
        return refused("a fit has a degree of 1 to 32, and a span, a coefficient of it and a site or more");
    fit.spans = spans;
    fit.sites = sites;
    fit.probes = probed / size;
    fit.count = entries / size;
    fit.columns = held / fit.count;
    BORROW_WHOLE(fit.first, of_spans[0], spans, "first");
    BORROW(fit.widths, of_spans[1], spans, "widths");
    BORROW(fit.matrix, of_spans[2], spans * size * size, "matrix");
    BORROW(fit.inner, of_rule[0], sites * size, "inner");
    BORROW(fit.weight, of_rule[1], sites, "weight");
    BORROW(fit.probing, of_rule[2], fit.probes * size, "probing");
    BORROW(fit.samples, values, spans * (sites + fit.probes) * fit.columns, "samples");
    BORROW_OUT(band, room, fit.count * size, "band");
    BORROW_OUT(coefficients, out[0], fit.count * fit.columns, "coefficients");
    BORROW_OUT(errors, out[1], spans, "errors");
    if (!within(fit.count - fit.degree, spans, fit.first, "first"))
        goto done;
    Py_BEGIN_ALLOW_THREADS
    fitted = fit_splines(&fit, band, coefficients, errors);
    Py_END_ALLOW_THREADS
    answer = PyLong_FromLong(fitted);
done:
    give_back(&arrays);
    return answer;
}

PyObject *py_derivative_series(PyObject *module, PyObject *arguments)
{
    PyObject *of_pieces[5], *raises, *out, *answer = NULL;
    CurvePieces c;
    if (!PyArg_ParseTuple(arguments, "(nn)(OOOOO)OO", &c.degree, &c.numbers, &of_pieces[0], &of_pieces[1],
                          &of_pieces[2], &of_pieces[3], &of_pieces[4], &raises, &out))
        return NULL;
    Borrowed arrays = {.count = 0};
    const double *raised;
    double *series;
    const Py_ssize_t count = array_size(of_pieces[0]), entries = array_size(of_pieces[1]);
    if (c.degree < 1 || c.degree > MOST_DEGREE || c.numbers < 2 || c.numbers > 3 || count < 0 || entries < 0)
        return refused("curves have a degree of 1 to 32, and two or three numbers of a place");
    const Py_ssize_t size = c.degree + 1;
    Py_ssize_t raising = 0;
    for (Py_ssize_t k = 0; k < DERIVATIVES && k <= c.degree; k++)
        raising += size * (size - k);
    c.count = count;
    c.points = entries / 3;
    BORROW_WHOLE(c.first, of_pieces[0], count, "first");
    BORROW(c.control_points, of_pieces[1], 3 * c.points, "control_points");
    BORROW(c.matrix, of_pieces[2], count * size * size, "matrix");
    BORROW(c.widths, of_pieces[3], count, "widths");
    BORROW(c.origins, of_pieces[4], 2 * count, "origins");
    BORROW(raised, raises, raising, "raised");
    BORROW_OUT(series, out, count * size * DERIVATIVES * c.numbers, "series");
    if (!within(c.points - c.degree, count, c.first, "first"))
        goto done;
    Py_BEGIN_ALLOW_THREADS
    derivative_series(&c, raised, series);
    Py_END_ALLOW_THREADS
    answer = Py_NewRef(Py_None);
done:
    give_back(&arrays);
    return answer;
}

PyObject *py_inverse_cells(PyObject *module, PyObject *arguments)
{
    PyObject *of_arc[3], *steps, *slopes, *out[2], *answer = NULL;
    if (!PyArg_ParseTuple(arguments, "OOOOOOO", &of_arc[0], &of_arc[1], &of_arc[2], &steps, &slopes, &out[0], &out[1]))
        return NULL;
    Borrowed arrays = {.count = 0};
    ArcLengths arc;
    const double *at_steps, *paces;
    double *meets, *cubics;
    const Py_ssize_t table = array_size(steps);
    if (table < 0 || !borrow_arc(&arrays, of_arc, &arc))
        goto done;
    const Py_ssize_t cells = table / arc.terms - 1;
    if (cells < 1) {
        refused("a panel has one cell or more");
        goto done;
    }
    BORROW(at_steps, steps, (cells + 1) * arc.terms, "at_steps");
    BORROW(paces, slopes, (cells + 1) * arc.terms, "paces");
    BORROW_OUT(meets, out[0], arc.panels * cells - 1, "meets");
    BORROW_OUT(cubics, out[1], 6 * arc.panels * cells, "cubics");
    Py_BEGIN_ALLOW_THREADS
    inverse_cells(&arc, cells, at_steps, paces, meets, cubics);
    Py_END_ALLOW_THREADS
    answer = Py_NewRef(Py_None);
done:
    give_back(&arrays);
    return answer;
}

/* The two arrays of a curve over arc length; 0 with a Python error where one does not fit. */
static int borrow_quintics(Borrowed *arrays, PyObject **given, Quintics *curve)
{
    curve->pieces = array_size(given[0]) - 1;
    if (curve->pieces < 1)
        return refused("a curve has one piece or more") != NULL;
    return (curve->nodes = borrow(arrays, given[0], curve->pieces + 1, 0, "nodes")) &&
           (curve->rows = borrow(arrays, given[1], 12 * curve->pieces, 0, "rows"));
}

PyObject *py_quintics_at(PyObject *module, PyObject *arguments)
{
    PyObject *of_curve[2], *lengths, *out[2], *answer = NULL;
    if (!PyArg_ParseTuple(arguments, "OOOOO", &of_curve[0], &of_curve[1], &lengths, &out[0], &out[1]))
        return NULL;
    Borrowed arrays = {.count = 0};
    Quintics curve;
    const double *s;
    double *points, *slopes;
    const Py_ssize_t count = array_size(lengths);
    if (count < 0 || !borrow_quintics(&arrays, of_curve, &curve))
        goto done;
    BORROW(s, lengths, count, "s");
    BORROW_OUT(points, out[0], 2 * count, "points");
    BORROW_OUT(slopes, out[1], 2 * count, "slopes");
    Py_BEGIN_ALLOW_THREADS
    quintics_at(&curve, count, s, points, slopes);
    Py_END_ALLOW_THREADS
    answer = Py_NewRef(Py_None);
done:
    give_back(&arrays);
    return answer;
}

PyObject *py_nearest_on_quintics(PyObject *module, PyObject *arguments)
{
    PyObject *of_curve[2], *of_stations[2], *asked, *out[3], *answer = NULL;
    double length;
    int steps;
    if (!PyArg_ParseTuple(arguments, "OO(OO)(di)OOOO", &of_curve[0], &of_curve[1], &of_stations[0], &of_stations[1],
                          &length, &steps, &asked, &out[0], &out[1], &out[2]))
        return NULL;
    Borrowed arrays = {.count = 0};
    Quintics curve;
    const double *station, *chain, *points;
    double *s, *places, *tangents;
    const Py_ssize_t stations = array_size(of_stations[0]), count = array_size(asked) / 2;
    if (stations < 1)
        return refused("a curve is sought from one station or more");
    if (!borrow_quintics(&arrays, of_curve, &curve))
        goto done;
    BORROW(station, of_stations[0], stations, "stations");
    BORROW(chain, of_stations[1], 2 * stations, "chain");
    BORROW(points, asked, 2 * count, "points");
    BORROW_OUT(s, out[0], count, "s");
    BORROW_OUT(places, out[1], 2 * count, "places");
    BORROW_OUT(tangents, out[2], 2 * count, "tangents");
    Py_BEGIN_ALLOW_THREADS
    nearest_on_quintics(&curve, stations, station, chain, length, steps, count, points, s, places, tangents);
    Py_END_ALLOW_THREADS
    answer = Py_NewRef(Py_None);
done:
    give_back(&arrays);
    return answer;
}

PyObject *py_spline_values(PyObject *module, PyObject *arguments)
{
    PyObject *breaks, *coefficients, *places, *out, *answer = NULL;
    if (!PyArg_ParseTuple(arguments, "OOOO", &breaks, &coefficients, &places, &out))
        return NULL;
    Borrowed arrays = {.count = 0};
    SplinePieces spline = {.pieces = array_size(breaks) - 1};
    const double *x;
    double *values;
    const Py_ssize_t entries = array_size(coefficients), count = array_size(places);
    if (spline.pieces < 1 || entries < 0 || count < 0)
        return refused("a spline has one piece or more");
    spline.degree = entries / spline.pieces - 1;
    if (spline.degree < 0 || spline.degree > MOST_DEGREE)
        return refused("the pieces of a spline have the degree 0 to 32");
    BORROW(spline.edges, breaks, spline.pieces + 1, "edges");
    BORROW(spline.coefficients, coefficients, spline.pieces * (spline.degree + 1), "coefficients");
    BORROW(x, places, count, "x");
    BORROW_OUT(values, out, count, "values");
    Py_BEGIN_ALLOW_THREADS
    spline_values(&spline, count, x, values);
    Py_END_ALLOW_THREADS
    answer = Py_NewRef(Py_None);
done:
    give_back(&arrays);
    return answer;
}

/* The velocities of parts; 0 with a Python error where there are none. */
static int borrow_hodographs(Borrowed *arrays, PyObject *given, Py_ssize_t parts, Hodographs *into)
{
    const Py_ssize_t numbers = array_size(given);
    if (parts < 1 || numbers < 2 * parts)
        return refused("a curve has one part or more, each with a velocity") != NULL;
    into->count = parts;
    into->order = numbers / (2 * parts);
    return (into->velocities = borrow(arrays, given, 2 * parts * into->order, 0, "hodographs")) != NULL;
}

PyObject *py_are_cones(PyObject *module, PyObject *arguments)
{
    PyObject *velocities, *answer = NULL;
    Py_ssize_t parts;
    ConeLimits limits;
    if (!PyArg_ParseTuple(arguments, "On(ddd)", &velocities, &parts, &limits.still, &limits.slow, &limits.along))
        return NULL;
    Borrowed arrays = {.count = 0};
    Hodographs curve;
    int are;
    if (!borrow_hodographs(&arrays, velocities, parts, &curve))
        goto done;
    Py_BEGIN_ALLOW_THREADS
    are = are_cones(&curve, &limits);
    Py_END_ALLOW_THREADS
    answer = PyBool_FromLong(are);
done:
    give_back(&arrays);
    return answer;
}

PyObject *py_tangent_angles(PyObject *module, PyObject *arguments)
{
    PyObject *velocities, *out[2], *answer = NULL;
    if (!PyArg_ParseTuple(arguments, "OOO", &velocities, &out[0], &out[1]))
        return NULL;
    Borrowed arrays = {.count = 0};
    Hodographs curve;
    double *axis, *angle, spread;
    const Py_ssize_t parts = array_size(out[1]);
    if (!borrow_hodographs(&arrays, velocities, parts, &curve))
        goto done;
    BORROW_OUT(axis, out[0], 2 * parts, "axis");
    BORROW_OUT(angle, out[1], parts, "angle");
    Py_BEGIN_ALLOW_THREADS
    spread = tangent_angles(&curve, axis, angle);
    Py_END_ALLOW_THREADS
    answer = PyFloat_FromDouble(spread);
done:
    give_back(&arrays);
    return answer;
}

PyObject *py_angles_at(PyObject *module, PyObject *arguments)
{
    PyObject *given[3], *at, *velocities, *out, *answer = NULL;
    int to_left;
    if (!PyArg_ParseTuple(arguments, "(OOO)pOOO", &given[0], &given[1], &given[2], &to_left, &at, &velocities, &out))
        return NULL;
    Borrowed arrays = {.count = 0};
    TangentAngles tabulated = {.count = array_size(given[2])};
    const double *t, *velocity;
    double *angles;
    const Py_ssize_t places = array_size(at);
    if (tabulated.count < 1 || places < 0)
        return refused("a curve has one part or more");
    BORROW(tabulated.edges, given[0], tabulated.count + 1, "edges");
    BORROW(tabulated.axis, given[1], 2 * tabulated.count, "axis");
    BORROW(tabulated.angle, given[2], tabulated.count, "angle");
    BORROW(t, at, places, "t");
    BORROW(velocity, velocities, 2 * places, "velocity");
    BORROW_OUT(angles, out, places, "angles");
    Py_BEGIN_ALLOW_THREADS
    angles_at(&tabulated, to_left, places, t, velocity, angles);
    Py_END_ALLOW_THREADS
    answer = Py_NewRef(Py_None);
done:
    give_back(&arrays);
    return answer;
}
