"""Splines that follow a given function to a tolerance, with knots where they are needed."""

from collections.abc import Callable, Sequence
from functools import lru_cache

import numpy as np

from elastica_cad._compiled_scipy import lapack
from elastica_cad._types import FloatArray, IntArray
from elastica_cad.errors import InputError, NotConvergedError
from elastica_cad.geometry.polynomials.bernstein import binomials, scaled_bernstein
from elastica_cad.geometry.polynomials.bezier_pieces import Spans, bezier_spans
from elastica_cad.geometry.polynomials.gauss_rule import gauss_rule
from elastica_cad.geometry.polynomials.knot_runs import clamped_knots

_PROBES = np.array([0.02, 0.11, 0.27, 0.43, 0.58, 0.72, 0.88, 0.98])
"""Places of a span at which the error is measured, in shares of the span: none is a site of the fit."""

_MOST_SPANS = 3000
"""A function that needs more cannot be followed."""

_REFINED_SHARE = 0.05
"""Spans whose error is above this share of the largest are refined in one round."""

_NARROWEST_SHARE = 1e-9  # of the domain
_SAME_BREAK_SHARE = 1e-10  # of the domain: breaks no farther apart are one
_ALIKE = (
    1e-7  # the same where the slope goes on in one of them: the span between them could not be solved for
)
_WIDER_TIMES = 8.0  # than its neighbour: cut with it


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
    order = _break_orders(breaks, domain)
    edges = _with_knots(np.array([domain[0], *sorted(order), domain[1]]), np.asarray(knots, dtype=float))
    sites, weight = gauss_rule(degree + 3)
    places, inner, probing = _places(degree)
    samples = _sampled(function, edges[:-1], edges[1:], places)
    while True:
        repeated = clamped_knots(edges, order, degree)
        spans = bezier_spans(repeated, degree)
        coefficients = _least_squares(spans, samples[:, : sites.size], inner, weight)
        error = _largest_errors(spans, coefficients, samples[:, sites.size :], probing)
        accepted = max(tolerance, rounding * float(np.abs(samples).max()))
        # a steep place spoils its neighbourhood too: only the worst is refined before the rest is judged
        bad = np.flatnonzero(error > max(accepted, _REFINED_SHARE * error.max()))
        if not bad.size:
            return repeated, coefficients
        worst = int(bad[error[bad].argmax()])
        too_narrow = np.diff(edges)[bad].min() < _NARROWEST_SHARE * (edges[-1] - edges[0])
        if too_narrow or edges.size + bad.size > _MOST_SPANS:
            raise NotConvergedError(
                f"no spline follows the function to {tolerance:g}: near {edges[worst]:.6g} the error stays "
                f"{error[worst]:.3g}; declare the break there or ask for less"
            )
        bad = _with_wide_neighbours(bad, np.diff(edges))
        parts = _parts(error[bad] / accepted, degree)
        edges, samples = _refined(function, edges, samples, bad, parts=parts, places=places)


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


def _break_orders(breaks: Sequence[tuple[float, int]], domain: tuple[float, float]) -> dict[float, int]:
    """Least continuity at each break inside the domain; breaks too close to be told apart count as one."""
    length = domain[1] - domain[0]
    order: dict[float, int] = {}
    last = domain[0]
    for place, continuity in sorted((float(s), int(c)) for s, c in breaks):
        if not domain[0] + _SAME_BREAK_SHARE * length < place < domain[1] - _SAME_BREAK_SHARE * length:
            continue
        before = order.get(last)
        if (
            before is None
            or place - last > (_ALIKE if max(before, continuity) > 0 else _SAME_BREAK_SHARE) * length
        ):
            order[place] = continuity
            last = place
        elif continuity < before:
            # the rougher of the two is where it is
            del order[last]
            order[place] = continuity
            last = place
    return order


def _with_knots(edges: FloatArray, knots: FloatArray) -> FloatArray:
    """The edges and those knots that lie between them, none next to an edge."""
    knots = knots[(knots > edges[0]) & (knots < edges[-1])]
    after = np.searchsorted(edges, knots)
    apart = np.minimum(edges[after] - knots, knots - edges[after - 1])
    both = np.sort(np.concatenate([edges, knots[apart > _NARROWEST_SHARE * (edges[-1] - edges[0])]]))
    return np.asarray(both[np.append(True, both[1:] > both[:-1])])


def _sampled(
    function: Callable[[FloatArray], FloatArray], low: FloatArray, high: FloatArray, places: FloatArray
) -> FloatArray:
    """Values (p, k, q) at relative places (k,) of p spans."""
    x = low[:, None] + (high - low)[:, None] * places
    values = np.asarray(function(x.ravel()), dtype=float)
    if values.shape[:1] != (x.size,):
        raise InputError(f"a function along the curve must give a value for each of {x.size} places")
    if not np.isfinite(values).all():
        first = np.argwhere(~np.isfinite(values.reshape(x.size, -1)).all(axis=1))[0, 0]
        raise InputError(f"the function is not finite at {x.ravel()[first]:.6g}")
    return values.reshape(*x.shape, *values.shape[1:])


def _refined(
    function: Callable[[FloatArray], FloatArray],
    edges: FloatArray,
    samples: FloatArray,
    bad: IntArray,
    *,
    parts: IntArray,
    places: FloatArray,
) -> tuple[FloatArray, FloatArray]:
    """Bad spans cut into equal parts; values are asked for on the new spans only."""
    fresh = [np.linspace(edges[i], edges[i + 1], n + 1) for i, n in zip(bad, parts, strict=True)]
    low = np.concatenate([f[:-1] for f in fresh])
    high = np.concatenate([f[1:] for f in fresh])
    kept = np.delete(np.arange(edges.size - 1), bad)
    values = np.concatenate([samples[kept], _sampled(function, low, high, places)])
    order = np.argsort(np.concatenate([edges[kept], low]))
    return np.append(np.concatenate([edges[kept], low])[order], edges[-1]), values[order]


def _with_wide_neighbours(bad: IntArray, width: FloatArray) -> IntArray:
    """Bad spans and those beside them that are far wider: a narrow span can't mend what a wide one imposes."""
    beside = np.concatenate([bad - 1, bad + 1])
    inside = (beside >= 0) & (beside < width.size)
    beside, narrow = beside[inside], np.tile(bad, 2)[inside]
    cut = np.zeros(width.size, dtype=bool)
    cut[bad] = True
    cut[beside[width[beside] > _WIDER_TIMES * width[narrow]]] = True
    return cut.nonzero()[0]


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
    basis = scaled_bernstein(degree, places) * binomials(degree)
    return places, basis[: sites.size], basis[sites.size :]


def _least_squares(spans: Spans, values: FloatArray, inner: FloatArray, weight: FloatArray) -> FloatArray:
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
    spans: Spans, coefficients: FloatArray, values: FloatArray, probing: FloatArray
) -> FloatArray:
    pieces = spans.bezier(coefficients)
    approximate = probing @ pieces.reshape(*pieces.shape[:2], -1)
    error = np.abs(approximate - values.reshape(approximate.shape))
    return np.asarray(error.reshape(len(error), -1).max(axis=1))
