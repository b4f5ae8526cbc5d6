"""Splines that follow a given function to a tolerance, with knots where they are needed."""

from collections.abc import Callable, Sequence
from functools import lru_cache

import numpy as np

from elastica_cad._compiled_scipy import lapack
from elastica_cad._types import BoolArray, FloatArray, IntArray
from elastica_cad._values import is_whole, numbers, require_positive
from elastica_cad.errors import InputError, NotConvergedError, quoted
from elastica_cad.geometry.polynomials.bernstein import binomials, scaled_bernstein
from elastica_cad.geometry.polynomials.bezier_pieces import bezier_pieces
from elastica_cad.geometry.polynomials.gauss_rule import gauss_rule
from elastica_cad.geometry.polynomials.spline_spans import NARROWEST_SHARE, SplineSpans

_PROBES = np.array([0.02, 0.11, 0.27, 0.43, 0.58, 0.72, 0.88, 0.98])
"""Places of a span at which the error is measured, in shares of the span: none is a site of the fit."""

_MOST_DEGREE = 12
"""Of the splines that follow functions."""

_MOST_SPANS = 3000
"""A function that needs more cannot be followed."""

_REFINED_SHARE = 0.05
"""Spans whose error is above this share of the largest are refined in one round."""


def adaptive_spline(
    function: Callable[[FloatArray], FloatArray],
    domain: tuple[float, float],
    *,
    degree: int,
    tolerance: float,
    breaks: Sequence[tuple[float, int]] = (),
    knots: FloatArray | Sequence[float] = (),
    rounding: float = 1e-13,
) -> tuple[FloatArray, FloatArray]:
    """Knots and coefficients (m, ...) of a clamped spline within `tolerance` of a function on `domain`.

    Parameters
    ----------
    function : callable
        Maps places (k,) to values (k,) or (k, q); it is asked strictly inside the spans only, so that the
        value at a break does not matter.
    tolerance : float
        Largest error of a value, checked between the sites of the fit.
    breaks : sequence of (place, continuity)
        Places where the function is only `continuity` times differentiable, -1 where it jumps: they become
        knots of the matching multiplicity.
    knots : (k,) array_like
        Where to begin with knots besides the breaks; more come where they are needed.
    rounding : float
        Relative error of the function's values; nothing closer is asked for.

    Raises
    ------
    InputError
        When the function is not finite.
    NotConvergedError
        When it cannot be followed: an undeclared jump or kink, or noise above the tolerance.
    """
    require_positive(tolerance, "the tolerance of a fit", "the unit of the values")
    if not callable(function):
        raise InputError(
            f"what is followed is {quoted(function)}: give a function of the places along the curve"
        )
    if not (is_whole(degree) and 1 <= degree <= _MOST_DEGREE):
        raise InputError(f"a function is followed by a spline of degree 1 to {_MOST_DEGREE}, not {degree!r}")
    found = adaptive_splines(
        function,
        [domain],
        degree=degree,
        tolerance=tolerance,
        breaks=_checked_breaks(breaks),
        knots=[knots],
        rounding=rounding,
    )
    return found[0]


def adaptive_splines(
    function: Callable[[FloatArray], FloatArray],
    domains: Sequence[tuple[float, float]],
    *,
    degree: int,
    tolerance: float,
    breaks: Sequence[tuple[float, int]] = (),
    knots: Sequence[FloatArray | Sequence[float]] = (),
    rounding: float = 1e-13,
) -> list[tuple[FloatArray, FloatArray]]:
    """The same on many domains, each by itself, at one go; `knots` to begin with are those of each, or of none."""
    if not domains:
        return []
    places, *_ = _places(degree)
    begun = knots if len(knots) else [()] * len(domains)
    spans = SplineSpans.between(domains, breaks, [np.asarray(own, dtype=float) for own in begun], degree)
    samples = _sampled(function, spans.low, spans.high, places)
    names = np.arange(len(domains))
    found = dict[int, tuple[FloatArray, FloatArray]]()
    while True:
        coefficients, error = _fitted(spans, samples)
        accepted = np.maximum(tolerance, rounding * spans.largest(np.abs(samples)))
        # a steep place spoils its neighbourhood too: only the worst is refined before the rest is judged
        bad = error > np.maximum(accepted, _REFINED_SHARE * spans.largest(error))[spans.owner]
        is_open = np.zeros(names.size, dtype=bool)
        is_open[spans.owner[bad]] = True
        for k in np.flatnonzero(~is_open).tolist():
            found[int(names[k])] = spans.knots[spans.own_knots(k)], coefficients[spans.own(k)]
        if not bad.any():
            return [found[k] for k in range(len(domains))]
        if not is_open.all():
            left = is_open[spans.owner]
            names, accepted, bad, error = names[is_open], accepted[is_open], bad[left], error[left]
            spans, samples = spans.of_owners(is_open), samples[left]
        _refuse_endless(spans, bad, error, tolerance)
        worst = spans.with_wide_neighbours(np.flatnonzero(bad))
        parts = np.ones(bad.size, dtype=int)
        parts[worst] = _parts(error[worst] / accepted[spans.owner[worst]], degree)
        spans = spans.cut(parts)
        samples, fresh = samples.repeat(parts, axis=0), (parts > 1).repeat(parts)
        samples[fresh] = _sampled(function, spans.low[fresh], spans.high[fresh], places)


def fit_spans(
    function: Callable[[FloatArray], FloatArray],
    low: FloatArray,
    high: FloatArray,
    *,
    degree: int,
    tolerance: float,
    rounding: float = 1e-13,
) -> tuple[FloatArray, IntArray]:
    """Coefficients (p, degree + 1, q) of one polynomial on each domain from low to high (p,), at one go.

    They are those of `adaptive_spline` where it takes no knots inside. The second array (p,) says into how many
    even parts it cuts each domain first: 1 where it takes none.
    """
    sites, weight = gauss_rule(degree + 3)
    places, inner, probing = _places(degree)
    samples = _sampled(function, low, high, places)
    weighted = (weight[:, None] * inner).T
    coefficients = np.linalg.solve(weighted @ inner, weighted) @ samples[:, : sites.size]
    error = np.abs(probing @ coefficients - samples[:, sites.size :]).max(axis=(1, 2))
    accepted = np.maximum(tolerance, rounding * np.abs(samples).max(axis=(1, 2)))
    return coefficients, np.where(error <= accepted, 1, _parts(error / accepted, degree))


def _checked_breaks(breaks: Sequence[tuple[float, int]]) -> list[tuple[float, int]]:
    """Breaks as pairs of a place and a whole number."""
    rows = numbers(breaks, "breaks")
    if rows.size and rows.shape[1:] != (2,):
        raise InputError("breaks are pairs of a place and how often the function can be differentiated there")
    return [(place, int(continuity)) for place, continuity in rows.tolist()]


def _sampled(
    function: Callable[[FloatArray], FloatArray], low: FloatArray, high: FloatArray, places: FloatArray
) -> FloatArray:
    """Values (p, k, q) at relative places (k,) of p spans."""
    x = low[:, None] + (high - low)[:, None] * places
    values = numbers(function(x.ravel()), "values of a function")
    if values.shape[:1] != (x.size,):
        raise InputError(f"a function along the curve must give a value for each of {x.size} places")
    if not np.isfinite(values).all():
        first = np.argwhere(~np.isfinite(values.reshape(x.size, -1)).all(axis=1))[0, 0]
        raise InputError(f"the function is not finite at {x.ravel()[first]:.6g}")
    return values.reshape(*x.shape, *values.shape[1:])


def _refuse_endless(spans: SplineSpans, bad: BoolArray, error: FloatArray, tolerance: float) -> None:
    """A domain of too many spans, or of one too narrow for its length, cannot be followed."""
    length = spans.high[np.append(spans.begin[1:], 0) - 1] - spans.low[spans.begin]
    too_narrow = bad & (spans.widths < NARROWEST_SHARE * length[spans.owner])
    too_many = np.bincount(spans.owner) + 1 + np.bincount(spans.owner[bad]) > _MOST_SPANS
    given_up = np.flatnonzero(bad & (too_narrow | too_many[spans.owner]))
    if given_up.size:
        own = np.flatnonzero(bad & (spans.owner == spans.owner[given_up[0]]))
        worst = int(own[error[own].argmax()])
        raise NotConvergedError(
            f"no spline follows the function to {tolerance:g}: near {spans.low[worst]:.6g} the error stays "
            f"{error[worst]:.3g}; declare the break there or ask for less"
        )


def _parts(excess: FloatArray, degree: int) -> IntArray:
    """How many parts a span needs when the error falls with the power degree + 1 of its width; 2 to 8."""
    return np.asarray(np.clip(np.floor(excess ** (1 / (degree + 1))), 2, 8), dtype=int)


@lru_cache(maxsize=16)
def _places(degree: int) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Where in a span a function is asked, in shares of it, and Bernstein polynomials (k, degree + 1) there.

    The polynomials are apart for the sites of the fit and for the probes.
    """
    sites, _ = gauss_rule(degree + 3)
    places = np.concatenate([(1 + sites) / 2, _PROBES])
    basis = np.ascontiguousarray(scaled_bernstein(degree, places) * binomials(degree))
    return places, basis[: sites.size], basis[sites.size :]


def _fitted(spans: SplineSpans, samples: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Coefficients (m, ...) of the splines nearest to samples (p, k, ...), and their errors (p,) at the probes."""
    degree = spans.degree
    _, weight = gauss_rule(degree + 3)
    _, inner, probing = _places(degree)
    coefficients = _least_squares(spans, samples[:, : weight.size], inner, weight)
    return coefficients, _largest_errors(spans, coefficients, samples[:, weight.size :], probing)


def _least_squares(
    spans: SplineSpans, values: FloatArray, inner: FloatArray, weight: FloatArray
) -> FloatArray:
    """Coefficients (m, ...) of the spline nearest in mean square to values (p, k, ...) at the sites of spans."""
    degree, count = spans.degree, spans.count
    basis = inner @ spans.matrix
    weighted = (basis * (spans.widths[:, None] * weight)[..., None]).swapaxes(1, 2)
    gram = weighted @ basis
    right = weighted @ values.reshape(*values.shape[:2], -1)
    banded = np.zeros((degree + 1, count), order="F")
    total = np.zeros((count, right.shape[2]))
    # no two spans begin at the same control point, and mostly each at the next
    first, gaps = spans.first, spans.first[-1] - spans.first[0] > len(spans.first) - 1
    acting = [first + i if gaps else slice(first[0] + i, first[-1] + i + 1) for i in range(degree + 1)]
    for i in range(degree + 1):
        total[acting[i]] += right[:, i]
        for j in range(i, degree + 1):
            banded[degree - (j - i), acting[j]] += gram[:, i, j]
    _, solution, info = lapack().dpbsv(banded, total)
    if info != 0:
        raise np.linalg.LinAlgError("a span of the spline holds no place of the fit")
    return np.asarray(solution, dtype=float).reshape(count, *values.shape[2:])


def _largest_errors(
    spans: SplineSpans, coefficients: FloatArray, values: FloatArray, probing: FloatArray
) -> FloatArray:
    pieces = bezier_pieces(coefficients, spans.first, spans.matrix)
    approximate = probing @ pieces.reshape(*pieces.shape[:2], -1)
    error = np.abs(approximate - values.reshape(approximate.shape))
    return np.asarray(error.reshape(len(error), -1).max(axis=1))
