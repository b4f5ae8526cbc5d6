"""Checks of the numbers a curve is made of; each failure is one sentence."""

from collections.abc import Sequence

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import as_floats
from elastica_cad.errors import InputError
from elastica_cad.geometry.polynomials.knot_runs import knot_runs


def finite(name: str, values: ArrayLike | Sequence[float] | float) -> FloatArray:
    """A read-only float array of `values`; refuses what is no number, NaN and infinity."""
    given = as_floats(values)
    if given is None:
        raise InputError(f"{name} must be numbers")
    array = given.copy()
    if not np.isfinite(array).all():
        first = np.argwhere(~np.isfinite(array))[0].tolist()
        raise InputError(f"{name} holds NaN or infinite values, the first at index {first}")
    array.setflags(write=False)
    return array


def whole_degree(degree: int) -> int:
    """The degree as a plain int; refuses what is no whole number of 2 or more."""
    if isinstance(degree, bool) or not isinstance(degree, int | float | np.integer | np.floating):
        raise InputError(f"a curve needs degree 2 or more, not {degree!r}")
    if not (degree == np.floor(degree) and 2 <= degree < 100):
        raise InputError(f"a curve needs a whole degree of 2 or more, not {degree!r}")
    return int(degree)


SHORTEST_DOMAIN, FARTHEST_KNOT = 1e-9, 1e12
"""Of knots that are computed with."""


def check_knots(knots: FloatArray, count: int, degree: int) -> None:
    """Refuse a knot vector that does not fit the control points or breaks the curve apart."""
    if count < degree + 1:
        raise InputError(f"{count} control points are too few for degree {degree}: give {degree + 1} or more")
    if knots.shape != (count + degree + 1,):
        raise InputError(
            f"{count} control points of degree {degree} need {count + degree + 1} knots "
            f"(the full vector, end knots repeated), not {knots.size}"
        )
    down = np.flatnonzero(np.diff(knots) < 0)
    if down.size:
        raise InputError(f"knots must not decrease: knot {down[0] + 1} is less than knot {down[0]}")
    start, end = knots[degree], knots[-degree - 1]
    if not end > start:
        raise InputError("the knots leave no domain: the first and last inner knot coincide")
    if not (end - start >= SHORTEST_DOMAIN and np.abs(knots).max() <= FARTHEST_KNOT):
        raise InputError(
            f"the knots run from {start:.3g} to {end:.3g}, where cubes of differences overflow or vanish: scale "
            "them to 0..1"
        )
    values, counts = knot_runs(knots)
    inside = (values > start) & (values < end)
    if inside.any() and counts[inside].max() > degree:
        where = values[inside][counts[inside].argmax()]
        raise InputError(
            f"knot {where:g} is repeated {counts[inside].max()} times: "
            f"more than the degree {degree} breaks the curve apart"
        )
    if counts.max() > degree + 1:
        raise InputError(f"an end knot is repeated {counts.max()} times: degree {degree} allows {degree + 1}")
