#include "arrays.h"

#include <string.h>

static double nothing; /* where an empty array begins */

/* Borrow `size` items of eight bytes of one of two formats. */
static void *borrow_items(Borrowed *borrowed, PyObject *object, Py_ssize_t size, int writable, const char *formats,
                          const char *kind, const char *name)
{
    Py_buffer *view = &borrowed->views[borrowed->count];
    int flags = PyBUF_C_CONTIGUOUS | PyBUF_FORMAT | (writable ? PyBUF_WRITABLE : 0);
    if (PyObject_GetBuffer(object, view, flags) != 0)
        return NULL;
    borrowed->count++;
    const char *format = view->format;
    if (format == NULL || strchr(formats, format[0]) == NULL || format[0] == '\0' || format[1] != '\0' ||
        view->itemsize != 8 || view->len / 8 != size) {
        PyErr_Format(PyExc_ValueError, "%s must be %zd contiguous %s numbers", name, size, kind);
        return NULL;
    }
    return size ? view->buf : &nothing;
}

double *borrow(Borrowed *borrowed, PyObject *object, Py_ssize_t size, int writable, const char *name)
{
    return borrow_items(borrowed, object, size, writable, "d", "float64", name);
}

int64_t *borrow_whole(Borrowed *borrowed, PyObject *object, Py_ssize_t size, int writable, const char *name)
{
    return borrow_items(borrowed, object, size, writable, "lq", "int64", name);
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
