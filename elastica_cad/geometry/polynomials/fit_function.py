"""Splines that follow a given function to a tolerance, with knots where they are needed."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np

from elastica_cad._compiled_scipy import lapack
from elastica_cad._native import MOST_DEGREE, kernels
from elastica_cad._types import BoolArray, FloatArray, IntArray
from elastica_cad._values import is_whole, numbers, require_positive
from elastica_cad.errors import InputError, NotConvergedError, quoted
from elastica_cad.geometry.polynomials.bernstein import binomials, scaled_bernstein
from elastica_cad.geometry.polynomials.bezier_pieces import bezier_pieces, extraction
from elastica_cad.geometry.polynomials.gauss_rule import gauss_rule
from elastica_cad.geometry.polynomials.knot_runs import knot_repeats
from elastica_cad.geometry.running_sums import numbers_in_groups

_PROBES = np.array([0.02, 0.11, 0.27, 0.43, 0.58, 0.72, 0.88, 0.98])
"""Places of a span at which the error is measured, in shares of the span: none is a site of the fit."""

_MOST_DEGREE = 12
"""Of the splines that follow functions."""

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
    spans = _Spans.between(domains, breaks, [np.asarray(own, dtype=float) for own in begun], degree)
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


def _break_orders(breaks: Sequence[tuple[float, int]], domain: tuple[float, float]) -> dict[float, int]:
    """Least continuity at each break inside the domain; breaks too close to be told apart count as one."""
    length = domain[1] - domain[0]
    order: dict[float, int] = {}
    last = domain[0]
    for place, continuity in sorted(breaks):
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


def _checked_breaks(breaks: Sequence[tuple[float, int]]) -> list[tuple[float, int]]:
    """Breaks as pairs of a place and a whole number."""
    rows = numbers(breaks, "breaks")
    if rows.size and rows.shape[1:] != (2,):
        raise InputError("breaks are pairs of a place and how often the function can be differentiated there")
    return [(place, int(continuity)) for place, continuity in rows.tolist()]


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
    values = numbers(function(x.ravel()), "values of a function")
    if values.shape[:1] != (x.size,):
        raise InputError(f"a function along the curve must give a value for each of {x.size} places")
    if not np.isfinite(values).all():
        first = np.argwhere(~np.isfinite(values.reshape(x.size, -1)).all(axis=1))[0, 0]
        raise InputError(f"the function is not finite at {x.ravel()[first]:.6g}")
    return values.reshape(*x.shape, *values.shape[1:])


def _refuse_endless(spans: "_Spans", bad: BoolArray, error: FloatArray, tolerance: float) -> None:
    """A domain of too many spans, or of one too narrow for its length, cannot be followed."""
    length = spans.high[np.append(spans.begin[1:], 0) - 1] - spans.low[spans.begin]
    too_narrow = bad & (spans.widths < _NARROWEST_SHARE * length[spans.owner])
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


@dataclass(frozen=True, eq=False)
class _Spans:
    """Knot spans (p,) of splines side by side: from where to where each runs, and whose it is.

    `repeats` (p,) is how often the knot at its start stands there.
    """

    low: FloatArray
    high: FloatArray
    owner: IntArray
    repeats: IntArray
    degree: int

    @classmethod
    def between(
        cls,
        domains: Sequence[tuple[float, float]],
        breaks: Sequence[tuple[float, int]],
        inside: Sequence[FloatArray],
        degree: int,
    ) -> "_Spans":
        """Those between breaks and further knots inside of each domain."""
        edges, repeats = [], []
        for (first, last), knots in zip(domains, inside, strict=True):
            order = _break_orders(breaks, (first, last))
            own = _with_knots(np.array([first, *sorted(order), last]), knots)
            edges.append(own)
            repeats.append(knot_repeats(own, order, degree)[:-1])
        return cls(
            np.concatenate([own[:-1] for own in edges]),
            np.concatenate([own[1:] for own in edges]),
            np.repeat(np.arange(len(edges)), [own.size - 1 for own in edges]),
            np.concatenate(repeats),
            degree,
        )

    @cached_property
    def widths(self) -> FloatArray:
        """Lengths (p,)."""
        return np.asarray(self.high - self.low)

    @cached_property
    def begin(self) -> IntArray:
        """The first span (k,) of each owner."""
        return np.flatnonzero(np.append(True, self.owner[1:] != self.owner[:-1]))

    @cached_property
    def knots(self) -> FloatArray:
        """Those of all owners, one behind the other."""
        starts, ends = np.arange(self.low.size) + self.owner, np.append(self.begin[1:], self.low.size) - 1
        edges = np.empty(self.low.size + ends.size)
        counts = np.full(edges.size, self.degree + 1)
        edges[starts], counts[starts] = self.low, self.repeats
        edges[starts[ends] + 1] = self.high[ends]
        return edges.repeat(counts)

    @cached_property
    def _last_knots(self) -> IntArray:
        """The last knot (p,) at the start of each span."""
        return np.cumsum(self.repeats) - 1 + self.owner * (self.degree + 1)

    @cached_property
    def first(self) -> IntArray:
        """The first coefficient (p,) that acts on each span."""
        return self._last_knots - self.degree - self.owner * (self.degree + 1)

    @cached_property
    def matrix(self) -> FloatArray:
        """See `Spans.matrix`."""
        reach = np.arange(1 - self.degree, self.degree + 1)[:, None]
        return extraction(self.knots[self._last_knots + reach])

    @property
    def count(self) -> int:
        """Number of coefficients of all."""
        return int(self.first[-1]) + self.degree + 1

    def of_owner(self, k: int) -> slice:
        """The spans of one owner."""
        return slice(self.begin[k], self.begin[k + 1] if k + 1 < len(self.begin) else None)

    def own(self, k: int) -> slice:
        """The coefficients of one owner."""
        own = self.first[self.of_owner(k)]
        return slice(own[0], own[-1] + self.degree + 1)

    def own_knots(self, k: int) -> slice:
        """The knots of one owner."""
        own = self._last_knots[self.of_owner(k)]
        return slice(own[0] - self.degree, own[-1] + self.degree + 2)

    def largest(self, values: FloatArray) -> FloatArray:
        """The largest (k,) of the values (p, ...) of each owner."""
        return np.maximum.reduceat(values.reshape(self.low.size, -1).max(axis=1), self.begin)

    def of_owners(self, chosen: BoolArray) -> "_Spans":
        """Those of the chosen owners (k,) alone, numbered anew."""
        kept = chosen[self.owner]
        owner = (np.cumsum(chosen) - 1)[self.owner[kept]]
        return _Spans(self.low[kept], self.high[kept], owner, self.repeats[kept], self.degree)

    def with_wide_neighbours(self, bad: IntArray) -> IntArray:
        """Bad spans and those beside them that are far wider: a narrow one can't mend what a wide one imposes."""
        beside, narrow = np.concatenate([bad - 1, bad + 1]), np.tile(bad, 2)
        inside = (beside >= 0) & (beside < self.low.size)
        beside, narrow = beside[inside], narrow[inside]
        wide = self.widths[beside] > _WIDER_TIMES * self.widths[narrow]
        cut = np.zeros(self.low.size, dtype=bool)
        cut[bad] = True
        cut[beside[wide & (self.owner[beside] == self.owner[narrow])]] = True
        return cut.nonzero()[0]

    def cut(self, parts: IntArray) -> "_Spans":
        """Each cut into so many equal parts."""
        number = numbers_in_groups(parts)
        low = number * (self.widths / parts).repeat(parts) + self.low.repeat(parts)
        high, repeats = self.high.repeat(parts), self.repeats.repeat(parts)
        inner = number[1:] > 0
        high[:-1][inner] = low[1:][inner]
        repeats[1:][inner] = 1
        return _Spans(low, high, self.owner.repeat(parts), repeats, self.degree)


def _fitted(spans: _Spans, samples: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Coefficients (m, ...) of the splines nearest to samples (p, k, ...), and their errors (p,) at the probes."""
    degree, count = spans.degree, spans.count
    _, weight = gauss_rule(degree + 3)
    _, inner, probing = _places(degree)
    if kernels is None or degree > MOST_DEGREE:
        coefficients = _least_squares(spans, samples[:, : weight.size], inner, weight)
        return coefficients, _largest_errors(spans, coefficients, samples[:, weight.size :], probing)
    coefficients, error = np.empty((count, *samples.shape[2:])), np.empty(spans.low.size)
    first, band = np.ascontiguousarray(spans.first, dtype=np.intp), np.empty((count, degree + 1))
    of_spans, rule = (first, spans.widths, spans.matrix), (inner, weight, probing)
    values = np.ascontiguousarray(samples)
    if not kernels.fit_splines(degree, of_spans, rule, values, band, coefficients, error):
        raise _no_site()
    return coefficients, error


def _least_squares(spans: _Spans, values: FloatArray, inner: FloatArray, weight: FloatArray) -> FloatArray:
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
        raise _no_site()
    return np.asarray(solution, dtype=float).reshape(count, *values.shape[2:])


def _no_site() -> np.linalg.LinAlgError:
    return np.linalg.LinAlgError("a span of the spline holds no place of the fit")


def _largest_errors(
    spans: _Spans, coefficients: FloatArray, values: FloatArray, probing: FloatArray
) -> FloatArray:
    pieces = bezier_pieces(coefficients, spans.first, spans.matrix)
    approximate = probing @ pieces.reshape(*pieces.shape[:2], -1)
    error = np.abs(approximate - values.reshape(approximate.shape))
    return np.asarray(error.reshape(len(error), -1).max(axis=1))
