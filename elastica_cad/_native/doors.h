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

PyObject *py_legendre_sums(PyObject *module, PyObject *arguments);
PyObject *py_bernstein_sums(PyObject *module, PyObject *arguments);
PyObject *py_arc_lengths_at(PyObject *module, PyObject *arguments);
PyObject *py_parameters_at(PyObject *module, PyObject *arguments);
PyObject *py_speed_panels(PyObject *module, PyObject *arguments);
PyObject *py_evaluate_panels(PyObject *module, PyObject *arguments);
PyObject *py_extremes(PyObject *module, PyObject *arguments);
PyObject *py_vertex_exchange(PyObject *module, PyObject *arguments);

#endif
