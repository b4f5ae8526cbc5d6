#include "arrays.h"

static double nothing; /* where an empty array begins */

double *borrow(Borrowed *borrowed, PyObject *object, Py_ssize_t size, int writable, const char *name)
{
    Py_buffer *view = &borrowed->views[borrowed->count];
    int flags = PyBUF_C_CONTIGUOUS | PyBUF_FORMAT | (writable ? PyBUF_WRITABLE : 0);
    if (PyObject_GetBuffer(object, view, flags) != 0)
        return NULL;
    borrowed->count++;
    if (view->format == NULL || view->format[0] != 'd' || view->format[1] != '\0' || view->len / 8 != size) {
        PyErr_Format(PyExc_ValueError, "%s must be %zd contiguous float64 numbers", name, size);
        return NULL;
    }
    return size ? (double *)view->buf : &nothing;
}

Py_ssize_t array_size(PyObject *object)
{
    Py_buffer view;
    if (PyObject_GetBuffer(object, &view, PyBUF_C_CONTIGUOUS) != 0)
        return -1;
    Py_ssize_t size = view.len / 8;
    PyBuffer_Release(&view);
    return size;
}

void give_back(Borrowed *borrowed)
{
    for (int i = 0; i < borrowed->count; i++)
        PyBuffer_Release(&borrowed->views[i]);
    borrowed->count = 0;
}
