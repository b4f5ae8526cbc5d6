/* What Python sees of flat_places.c. */
#include "doors.h"

PyObject *py_near_pairs(PyObject *module, PyObject *arguments)
{
    PyObject *of_places[3], *ranges[2], *out[2], *answer = NULL;
    NearSearch search;
    if (!PyArg_ParseTuple(arguments, "(OOO)(OO)dOO", &of_places[0], &of_places[1], &of_places[2], &ranges[0],
                          &ranges[1], &search.reach, &out[0], &out[1]))
        return NULL;
    Borrowed arrays = {.count = 0};
    int64_t *lower, *higher;
    Py_ssize_t found;
    const Py_ssize_t room = array_size(out[0]);
    search.count = array_size(of_places[0]);
    if (search.count < 0 || room < 0)
        return refused("places are arrays, and so is the room for pairs");
    BORROW(search.x, of_places[0], search.count, "x");
    BORROW(search.y, of_places[1], search.count, "y");
    BORROW_WHOLE(search.number, of_places[2], search.count, "numbers");
    BORROW_WHOLE(search.first, ranges[0], search.count, "first");
    BORROW_WHOLE(search.end, ranges[1], search.count, "end");
    BORROW_WHOLE_OUT(lower, out[0], room, "lower");
    BORROW_WHOLE_OUT(higher, out[1], room, "higher");
    /* a range may be empty behind the last place */
    if (!within(search.count + 1, search.count, search.first, "first") ||
        !within(search.count + 1, search.count, search.end, "end"))
        goto done;
    Py_BEGIN_ALLOW_THREADS
    found = near_pairs(&search, room, lower, higher);
    Py_END_ALLOW_THREADS
    answer = PyLong_FromSsize_t(found);
done:
    give_back(&arrays);
    return answer;
}

PyObject *py_chord_pairs(PyObject *module, PyObject *arguments)
{
    PyObject *lines[2], *out[2], *answer = NULL;
    if (!PyArg_ParseTuple(arguments, "OOOO", &lines[0], &lines[1], &out[0], &out[1]))
        return NULL;
    Borrowed arrays = {.count = 0};
    const double *p, *q;
    int64_t *of_p, *of_q;
    Py_ssize_t found;
    const Py_ssize_t p_numbers = array_size(lines[0]), q_numbers = array_size(lines[1]), room = array_size(out[0]);
    if (p_numbers < 2 || q_numbers < 2 || room < 0)
        return refused("a polyline has one point or more");
    BORROW(p, lines[0], p_numbers / 2 * 2, "p");
    BORROW(q, lines[1], q_numbers / 2 * 2, "q");
    BORROW_WHOLE_OUT(of_p, out[0], room, "of_p");
    BORROW_WHOLE_OUT(of_q, out[1], room, "of_q");
    Py_BEGIN_ALLOW_THREADS
    found = chord_pairs(p_numbers / 2, p, q_numbers / 2, q, room, of_p, of_q);
    Py_END_ALLOW_THREADS
    answer = PyLong_FromSsize_t(found);
done:
    give_back(&arrays);
    return answer;
}

PyObject *py_away_from_rims(PyObject *module, PyObject *arguments)
{
    PyObject *of_sides[2], *of_places[2], *out, *answer = NULL;
    if (!PyArg_ParseTuple(arguments, "(OO)OOO", &of_sides[0], &of_sides[1], &of_places[0], &of_places[1], &out))
        return NULL;
    Borrowed arrays = {.count = 0};
    const double *start, *end, *along, *across;
    double *away;
    const Py_ssize_t numbers = array_size(of_sides[0]), sides = numbers / 2, count = array_size(of_places[0]);
    if (numbers < 0 || count < 0)
        return refused("sides and places are arrays");
    BORROW(start, of_sides[0], 2 * sides, "start");
    BORROW(end, of_sides[1], 2 * sides, "end");
    BORROW(along, of_places[0], count, "s");
    BORROW(across, of_places[1], count, "across");
    BORROW_OUT(away, out, count, "away");
    Py_BEGIN_ALLOW_THREADS
    away_from_rims(sides, start, end, count, along, across, away);
    Py_END_ALLOW_THREADS
    answer = Py_NewRef(Py_None);
done:
    give_back(&arrays);
    return answer;
}
