/* Arrays as Python hands them over: contiguous numbers of eight bytes, borrowed while a kernel runs. */
#ifndef ELASTICA_ARRAYS_H
#define ELASTICA_ARRAYS_H

#include <Python.h>

#include <stdint.h>

#ifdef _MSC_VER
#define restrict __restrict
#endif

#define MOST_ARRAYS 24

/* Loops that a processor with wide registers runs with them: the same sums in the same order, so the same digits. */
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__gnu_linux__)
#define WIDE __attribute__((target_clones("avx2", "default")))
#else
#define WIDE
#endif

typedef struct {
    Py_buffer views[MOST_ARRAYS];
    int count;
} Borrowed;

/* The numbers of `object`, which must hold `size` of them; NULL with a Python error where it does not. */
double *borrow(Borrowed *borrowed, PyObject *object, Py_ssize_t size, int writable, const char *name);

/* The same for whole numbers of eight bytes, numpy's own for places in arrays. */
int64_t *borrow_whole(Borrowed *borrowed, PyObject *object, Py_ssize_t size, int writable, const char *name);

/* How many numbers an array holds; -1 with a Python error where it is none. */
Py_ssize_t array_size(PyObject *object);

void give_back(Borrowed *borrowed);

#endif
