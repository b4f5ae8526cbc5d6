/* What the functions share that Python sees: each checks and borrows its arrays, runs a kernel without Python, and
   gives them back. */
#ifndef ELASTICA_DOORS_H
#define ELASTICA_DOORS_H

#include "kernels.h"

#define BORROW(target, object, size, name) \
    if ((target = borrow(&arrays, object, size, 0, name)) == NULL) goto done
#define BORROW_OUT(target, object, size, name) \
    if ((target = borrow(&arrays, object, size, 1, name)) == NULL) goto done
#define BORROW_WHOLE(target, object, size, name) \
    if ((target = borrow_whole(&arrays, object, size, 0, name)) == NULL) goto done
#define BORROW_WHOLE_OUT(target, object, size, name) \
    if ((target = borrow_whole(&arrays, object, size, 1, name)) == NULL) goto done

/* NULL with the error that is set, or else with this one. */
static inline PyObject *refused(const char *why)
{
    if (!PyErr_Occurred())
        PyErr_SetString(PyExc_ValueError, why);
    return NULL;
}

/* Are all indices those of one of `count` things? 0 with a Python error where one is not. */
static inline int within(Py_ssize_t count, Py_ssize_t places, const int64_t *indices, const char *name)
{
    for (Py_ssize_t i = 0; i < places; i++)
        if (indices[i] < 0 || indices[i] >= count) {
            PyErr_Format(PyExc_IndexError, "%s must be from 0 to %zd", name, count - 1);
            return 0;
        }
    return 1;
}

/* The three arrays of an arc length; 0 with a Python error where one does not fit. */
static inline int borrow_arc(Borrowed *arrays, PyObject **given, ArcLengths *arc)
{
    const Py_ssize_t ends = array_size(given[0]), entries = array_size(given[2]);
    if (ends < 2 || entries < ends - 1)
        return refused("an arc length has one panel or more") != NULL;
    arc->panels = ends - 1;
    arc->terms = entries / arc->panels;
    return (arc->t = borrow(arrays, given[0], ends, 0, "t")) && (arc->s = borrow(arrays, given[1], ends, 0, "s")) &&
           (arc->series = borrow(arrays, given[2], arc->panels * arc->terms, 0, "series"));
}

PyObject *py_locate(PyObject *module, PyObject *arguments);
PyObject *py_legendre_sums(PyObject *module, PyObject *arguments);
PyObject *py_bernstein_sums(PyObject *module, PyObject *arguments);
PyObject *py_curve_at(PyObject *module, PyObject *arguments);
PyObject *py_arc_lengths_at(PyObject *module, PyObject *arguments);
PyObject *py_parameters_at(PyObject *module, PyObject *arguments);
PyObject *py_speed_panels(PyObject *module, PyObject *arguments);
PyObject *py_resolve_panels(PyObject *module, PyObject *arguments);
PyObject *py_extremes(PyObject *module, PyObject *arguments);
PyObject *py_vertex_exchange(PyObject *module, PyObject *arguments);
PyObject *py_bernstein_roots(PyObject *module, PyObject *arguments);
PyObject *py_cubic_extremes(PyObject *module, PyObject *arguments);
PyObject *py_spline_motion(PyObject *module, PyObject *arguments);
PyObject *py_extraction(PyObject *module, PyObject *arguments);
PyObject *py_fit_splines(PyObject *module, PyObject *arguments);
PyObject *py_derivative_series(PyObject *module, PyObject *arguments);
PyObject *py_inverse_cells(PyObject *module, PyObject *arguments);
PyObject *py_quintics_at(PyObject *module, PyObject *arguments);
PyObject *py_nearest_on_quintics(PyObject *module, PyObject *arguments);
PyObject *py_spline_values(PyObject *module, PyObject *arguments);
PyObject *py_are_cones(PyObject *module, PyObject *arguments);
PyObject *py_tangent_angles(PyObject *module, PyObject *arguments);
PyObject *py_angles_at(PyObject *module, PyObject *arguments);
PyObject *py_near_pairs(PyObject *module, PyObject *arguments);
PyObject *py_chord_pairs(PyObject *module, PyObject *arguments);
PyObject *py_away_from_rims(PyObject *module, PyObject *arguments);

#endif
