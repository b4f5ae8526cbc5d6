"""B-splines with knots and coefficients: Bezier pieces, basis functions, interpolation, fits to a tolerance."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from math import ceil, cos, pi

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._compiled_scipy import lapack
from elastica_cad._types import ArrayLike, FloatArray, IntArray
from elastica_cad._values import as_floats, is_number, is_whole, numbers, require_positive
from elastica_cad.errors import InputError, Length, NotConvergedError, Point, quoted
from elastica_cad.geometry.plane_points import (
    FEWEST_AROUND,
    begun_at,
    distinct,
    dot,
    homogeneous,
    lengths_along,
    midpoints,
    norm,
    numbers_in_groups,
    project,
    thinned,
    unit_vectors,
)
from elastica_cad.geometry.polynomials import bernstein_values, gauss_rule, raise_degree

SHORTEST_DOMAIN, FARTHEST_KNOT = 1e-9, 1e12
"""Least length of a domain, and largest absolute value of a knot."""


def knot_runs(knots: FloatArray) -> tuple[FloatArray, IntArray]:
    """Return the distinct values (k,) of ascending knots, and their multiplicities (k,).

    Examples
    --------
    >>> places, counts = knot_runs(np.array([0.0, 0.0, 1.0, 2.0, 2.0]))
    >>> places.tolist(), counts.tolist()
    ([0.0, 1.0, 2.0], [2, 1, 2])
    """
    rises = np.ones(knots.size + 1, dtype=bool)
    np.not_equal(knots[1:], knots[:-1], out=rises[1:-1])
    first = rises.nonzero()[0]
    return knots[first[:-1]], np.diff(first)


def clamped_knots(edges: FloatArray, continuity: Mapping[float, int], degree: int) -> FloatArray:
    """Return the clamped knots (m,) of a spline on the spans between edges (k,).

    `continuity` contains the number of continuous derivatives at some edges.

    Examples
    --------
    >>> clamped_knots(np.array([0.0, 1.0, 2.0]), {1.0: 0}, 2).tolist()
    [0.0, 0.0, 0.0, 1.0, 1.0, 2.0, 2.0, 2.0]
    """
    counts = np.ones(edges.size, dtype=int)
    repeats = [min(max(degree - order, 1), degree + 1) for order in continuity.values()]
    counts[edges.searchsorted(list(continuity))] = repeats
    counts[[0, -1]] = degree + 1
    return edges.repeat(counts)


def kinks(knots: FloatArray, degree: int, continuity: int) -> FloatArray:
    """Return the inner knots (k,) at which a spline has fewer than `continuity` continuous derivatives.

    Examples
    --------
    >>> kinks(np.array([0.0, 0.0, 0.0, 1.0, 2.0, 2.0, 3.0, 3.0, 3.0]), 2, 1).tolist()
    [2.0]
    """
    places, counts = knot_runs(knots)
    start, end = float(knots[degree]), float(knots[-degree - 1])
    return places[(counts > degree - continuity) & (places > start) & (places < end)]


def is_clamped(knots: FloatArray, degree: int) -> bool:
    """Return True if a spline begins at its first control point and ends at its last."""
    return bool(knots[0] == knots[degree] and knots[-1] == knots[-degree - 1])


def greville(knots: FloatArray, degree: int) -> FloatArray:
    """Return the Greville abscissae (..., m) of knot vectors (..., m + degree + 1).

    A spline whose coefficients are its Greville abscissae is the identity function.
    """
    count = knots.shape[-1] - degree - 1
    total = sum((knots[..., i : i + count] for i in range(2, degree + 1)), start=knots[..., 1 : count + 1])
    return total / degree


def finite(name: str, values: ArrayLike | Sequence[float] | float) -> FloatArray:
    """Return a read-only float array of `values`. Refuse NaN, infinity and other types."""
    given = as_floats(values)
    if given is None:
        raise InputError(f"{name} cannot be read: give numbers")
    array = given.copy()
    if not np.isfinite(array).all():
        first = np.argwhere(~np.isfinite(array))[0].tolist()
        raise InputError(
            f"{name} holds NaN or infinite values, the first at index {first}: give finite numbers"
        )
    array.setflags(write=False)
    return array


def whole_degree(degree: int) -> int:
    """Return the degree as an int. Refuse all values except integers of at least 2."""
    if isinstance(degree, bool) or not isinstance(degree, int | float | np.integer | np.floating):
        raise InputError(f"the degree of a curve is {degree!r}: use 2 or more")
    if not (degree == np.floor(degree) and 2 <= degree < 100):
        raise InputError(f"the degree of a curve is {degree!r}: use a whole number, 2 or more")
    return int(degree)


@lru_cache(maxsize=64)
def check_knots(written: bytes, count: int, degree: int) -> None:
    """Refuse a knot vector that is not valid for a curve with `count` control points.

    The knots are passed as bytes, because arrays cannot be keys of the cache.
    """
    knots = np.frombuffer(written)
    if count < degree + 1:
        raise InputError(f"{count} control points are too few for degree {degree}: give {degree + 1} or more")
    if knots.shape != (count + degree + 1,):
        raise InputError(
            f"{knots.size} knots do not fit {count} control points of degree {degree}: give "
            f"{count + degree + 1} knots (the full vector, end knots repeated)"
        )
    down = np.flatnonzero(np.diff(knots) < 0)
    if down.size:
        raise InputError(f"knot {down[0] + 1} is less than knot {down[0]}: give knots that do not decrease")
    start, end = knots[degree], knots[-degree - 1]
    if not end > start:
        raise InputError(
            "the first and the last knot of the domain are equal, so the spline has no length: give "
            "different knots"
        )
    if not (end - start >= SHORTEST_DOMAIN and np.abs(knots).max() <= FARTHEST_KNOT):
        raise InputError(
            f"the knots run from {start:.3g} to {end:.3g}, too small or too large for the computation: "
            "scale them to 0..1"
        )
    values, counts = knot_runs(knots)
    inside = (values > start) & (values < end)
    if inside.any() and counts[inside].max() > degree:
        where = values[inside][counts[inside].argmax()]
        raise InputError(
            f"knot {where:g} is repeated {counts[inside].max()} times, which breaks the curve apart: repeat "
            f"it at most {degree} times (the degree)"
        )
    if counts.max() > degree + 1:
        raise InputError(
            f"an end knot is repeated {counts.max()} times: repeat it at most {degree + 1} times (degree + 1)"
        )


@dataclass(frozen=True, eq=False)
class Spans:
    """Knot spans of positive length of a B-spline basis inside its domain.

    Attributes
    ----------
    count : int
        Number m of control points.
    edges : (p + 1,) array
        Increasing parameters at the ends of the spans.
    first : (p,) int array
        Index of the first of the degree + 1 control points that affect each span.
    matrix : (p, degree + 1, degree + 1) array
        Matrices that convert the B-spline control points of a span to its Bezier control points.
    """

    count: int
    edges: FloatArray
    first: IntArray
    matrix: FloatArray

    @property
    def degree(self) -> int:
        """Polynomial degree of the basis."""
        return int(self.matrix.shape[-1]) - 1

    @cached_property
    def columns(self) -> IntArray:
        """Indices (p, degree + 1) of the control points that affect each span."""
        return self.first[:, None] + np.arange(self.degree + 1)

    @cached_property
    def widths(self) -> FloatArray:
        """Lengths (p,) of the spans in the parameter."""
        return np.diff(self.edges)

    def bezier(self, control_points: FloatArray) -> FloatArray:
        """Return the Bezier control points (p, degree + 1, ...) of the spline with `control_points` (m, ...)."""
        local = control_points[self.columns]
        pieces = self.matrix @ local.reshape(*local.shape[:2], -1)
        return pieces.reshape(local.shape)

    def locate(self, t: FloatArray, *, left: bool = False) -> tuple[IntArray, FloatArray]:
        """Return the span index and the local coordinate u in [0, 1] of parameters t (n,).

        At an edge, the span on the right is returned, or with `left` the span on the left.
        """
        index = self.edges[1:-1].searchsorted(t, side="left" if left else "right")
        return index, np.minimum(np.maximum((t - self.edges[index]) / self.widths[index], 0.0), 1.0)

    def basis(self, t: FloatArray, derivative: int = 0) -> FloatArray:
        """Return derivatives (n, m) of the given order of all m basis functions at parameters t (n,)."""
        local, index = self.local_basis(t, derivative)
        out = np.zeros((t.size, self.count))
        out[np.arange(t.size)[:, None], self.columns[index]] = local
        return out

    def local_basis(self, t: FloatArray, derivative: int = 0) -> tuple[FloatArray, IntArray]:
        """Return the nonzero basis functions or their derivatives (n, degree + 1), and the span indices (n,)."""
        index, u = self.locate(t)
        bernstein = bernstein_values(self.degree, u, derivative) / self.widths[index][:, None] ** derivative
        return np.einsum("ni,nij->nj", bernstein, self.matrix[index]), index


def bezier_spans(knots: FloatArray, degree: int) -> Spans:
    """Return the spans of a B-spline basis with a full knot vector (m + degree + 1,), clamped or not.

    Bezier point j of the span [a, b] is the blossom (polar form) of degree - j arguments a and j arguments b.
    """
    return _spans(np.asarray(knots, dtype=float).tobytes(), degree)


@lru_cache(maxsize=256)
def _spans(written: bytes, degree: int) -> Spans:
    """Return the spans of knots that are passed as bytes, because arrays cannot be keys of the cache."""
    knots = np.frombuffer(written)
    span = (knots[degree + 1 : -degree] > knots[degree : -degree - 1]).nonzero()[0] + degree
    # knots (2 degree, p) around the p spans; `ends` (2, p) are the start and end of each span
    near = knots[span + np.arange(1 - degree, degree + 1)[:, None]]
    ends, size = near[degree - 1 : degree + 1], degree + 1
    # axes: row of the triangle, Bezier point j, factor of each control point, span
    points = np.broadcast_to(np.eye(size)[:, None, :, None], (size, 1, size, 1))
    for level in range(1, size):
        low, high = near[level - 1 : degree], near[degree : degree + size - level]
        # blossom argument: the start of the span for Bezier points j < level, the end of the span for others
        shares = ((ends[:, None] - low) / (high - low))[(np.arange(size) >= level).astype(int)]
        shares = shares.swapaxes(0, 1)[:, :, None]
        points = points[:-1] * (1 - shares) + points[1:] * shares
    matrix = np.broadcast_to(points[0], (size, size, span.size)).transpose(2, 0, 1)
    edges = np.concatenate([ends[0], ends[1, -1:]])
    first, matrix = span - degree, np.ascontiguousarray(matrix)
    for shared in (edges, first, matrix):
        shared.setflags(write=False)
    return Spans(knots.size - size, edges, first, matrix)


@dataclass(frozen=True, eq=False)
class SplineFunction:
    """Spline function with a full, clamped knot vector (m + degree + 1,) and coefficients (m, ...).

    This class replaces `BSpline` of SciPy, whose import takes longer than all computations with it in a command.

    Examples
    --------
    >>> parabola = SplineFunction(np.repeat([0.0, 2.0], 3), np.array([0.0, 0.0, 4.0]), 2)
    >>> parabola(np.array([1.0, 3.0])).tolist(), float(parabola(np.array(1.0), 1))
    ([1.0, 9.0], 2.0)
    """

    knots: FloatArray
    coefficients: FloatArray
    degree: int

    def __call__(self, x: FloatArray, derivative: int = 0) -> FloatArray:
        """Return values or derivatives at x of any shape. Beyond the ends, the end pieces are extrapolated."""
        if derivative > self.degree:
            return np.zeros((*x.shape, *self.coefficients.shape[1:]))
        rows, u, width = self._at(x)
        for k in range(derivative):
            rows = (rows[1:] - rows[:-1]) * ((self.degree - k) / width)
        while len(rows) > 1:  # de Casteljau's algorithm
            rows = rows[:-1] + (rows[1:] - rows[:-1]) * u
        return np.asarray(rows[0])

    def value_and_slope(self, x: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return values and first derivatives at x, in half the time of two calls."""
        rows, u, width = self._at(x)
        while len(rows) > 2:
            rows = rows[:-1] + (rows[1:] - rows[:-1]) * u
        step = rows[1] - rows[0]
        return rows[0] + step * u, step * (self.degree / width)

    def _at(self, x: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Return the coefficients, local coordinates and widths of the pieces that contain x.

        The coefficients are Bezier rows (degree + 1, ...), with the shape of x after the first axis. The others
        have axes of length 1 appended, so that they can be multiplied with a row.
        """
        spans = self._spans
        index = spans.edges[1:-1].searchsorted(x, side="right")
        after = x.shape + (1,) * (self.coefficients.ndim - 1)
        width = spans.widths[index].reshape(after)
        return self._rows.take(index, axis=1), (x - spans.edges[index]).reshape(after) / width, width

    def integral(self) -> "SplineFunction":
        """Return the integral of the spline function from the start of its domain."""
        size = self.degree + 1
        steps = (self.knots[size:] - self.knots[:-size]) / size
        sums = (steps * self.coefficients.T).T.cumsum(axis=0)
        rows = np.concatenate([np.zeros_like(sums[:1]), sums])
        return SplineFunction(np.pad(self.knots, 1, mode="edge"), rows, size)

    @property
    def pieces(self) -> FloatArray:
        """Bezier coefficients (p, degree + 1, ...) on each span."""
        return self._spans.bezier(self.coefficients)

    @cached_property
    def _spans(self) -> Spans:
        return bezier_spans(self.knots, self.degree)

    @cached_property
    def _rows(self) -> FloatArray:
        # `pieces` with the degree as the first axis: (degree + 1, p, ...)
        return np.ascontiguousarray(self.pieces.swapaxes(0, 1))


def spline_through(x: FloatArray, values: FloatArray, degree: int) -> SplineFunction:
    """Return the spline function through values (n, ...) at increasing x (n,).

    A cubic spline has no knots at the second and the second last x. A quintic spline has no knots at the two x next
    to each end. A spline of even degree is a single polynomial through degree + 1 values.

    Examples
    --------
    >>> cubic = spline_through(np.arange(4.0), np.arange(4.0) ** 3 + 1, 3)
    >>> cubic.knots.tolist(), cubic.coefficients.round(9).tolist()
    ([0.0, 0.0, 0.0, 0.0, 3.0, 3.0, 3.0, 3.0], [1.0, 1.0, 1.0, 28.0])
    """
    beside = (degree + 1) // 2
    inner = x[beside:-beside] if degree % 2 else x[:0]
    knots = np.concatenate([x[:1].repeat(degree + 1), inner, x[-1:].repeat(degree + 1)])
    return SplineFunction(knots, interpolated(x, values, knots, degree), degree)


def interpolation_sites(knots: FloatArray, degree: int) -> FloatArray:
    """Return parameters (m,) for interpolation with clamped knots: the Greville abscissae, with exact ends."""
    sites = greville(knots, degree)
    sites[[0, -1]] = knots[[0, -1]]
    return sites


def interpolated(sites: FloatArray, values: FloatArray, knots: FloatArray, degree: int) -> FloatArray:
    """Return coefficients (m, ...) of the spline with the given knots and with values (m, ...) at sites (m,)."""
    spans = bezier_spans(knots, degree)
    return solved(spans, *spans.local_basis(sites), values)


def over_knots(spline: Callable[[FloatArray], FloatArray], knots: FloatArray, degree: int) -> FloatArray:
    """Return the coefficients (m, ...) of a spline function with other clamped knots, which contain its own.

    Knots and degree determine splines of which the function is one, so its interpolation is exact.
    """
    sites = interpolation_sites(knots, degree)
    return interpolated(sites, spline(sites), knots, degree)


def solved(spans: Spans, basis: FloatArray, index: IntArray, values: FloatArray) -> FloatArray:
    """Return the coefficients (m, ...) of the spline with given values (m, ...) at m parameters.

    Parameter i is in the span index[i], and row i of `basis` (m, degree + 1) contains the nonzero basis functions.

    Raises
    ------
    NotConvergedError
        The rows do not determine the spline.
    """
    columns = spans.columns[index]
    # band storage of LAPACK: element (i, j) is in row 2 degree + i - j, and the first `degree` rows are workspace
    bands = np.zeros((3 * spans.degree + 1, spans.count), order="F")
    bands[2 * spans.degree + np.arange(spans.count)[:, None] - columns, columns] = basis
    right = values.reshape(spans.count, -1)
    *_, solution, info = lapack().dgbsv(spans.degree, spans.degree, bands, right, overwrite_ab=True)
    if info:
        raise NotConvergedError(
            "No spline has these values, because its places are too close together. Give fewer places."
        )
    return np.ascontiguousarray(solution).reshape(values.shape)


def unit_circle_arc(start: float, end: float) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return knots, control points (m, 2) and weights (m,) of an arc of the unit circle as a quadratic spline.

    Segments of at most a quarter turn are joined by double knots at their angles. The middle control point of a
    segment of angle 2 h has the weight cos h (Piegl and Tiller, The NURBS Book, section 7.3).
    """
    # the factor prevents a further segment because of rounding errors
    count = max(1, ceil(abs(end - start) / (pi / 2) * (1 - 1e-12)))
    half = (end - start) / count / 2
    angle = start + half * np.arange(2 * count + 1)
    weights = np.ones(angle.size)
    weights[1::2] = cos(half)
    points = unit_vectors(angle) / weights[:, None]
    joints = np.linspace(0.0, abs(end - start), count + 1)
    knots = np.concatenate([[0.0], joints.repeat(2), [joints[-1]]])
    return knots, points, weights


def elevate_degree(
    knots: FloatArray, control_points: FloatArray, degree: int, weights: FloatArray | None = None
) -> tuple[FloatArray, FloatArray, FloatArray | None]:
    """Return knots, control points and weights of the same clamped spline with its degree raised by 1.

    The degree of every Bezier piece is raised, and equal control points of neighbouring pieces are merged. All
    inner knots become knots of multiplicity degree + 1, which does not change the curve.

    Examples
    --------
    >>> knots, points, _ = elevate_degree(np.repeat([0.0, 1.0], 3), np.array([(0, 0), (3, 6), (6, 0)]), 2)
    >>> points.tolist()
    [[0.0, 0.0], [2.0, 4.0], [4.0, 4.0], [6.0, 0.0]]
    """
    spans = bezier_spans(knots, degree)
    pieces = spans.bezier(homogeneous(control_points, weights))
    raised = raise_degree(pieces.swapaxes(1, 2)).swapaxes(1, 2)
    rows = np.concatenate([raised[0], *(piece[1:] for piece in raised[1:])])
    new_knots = np.pad(spans.edges.repeat(degree + 1), 1, mode="edge")
    return new_knots, project(rows), None if weights is None else rows[:, 2]


_PROBES = np.array([0.02, 0.11, 0.27, 0.43, 0.58, 0.72, 0.88, 0.98])
"""Fractions of a knot span at which the error is measured, away from the interpolation points."""

_MOST_DEGREE = 12

_MOST_SPANS = 3000

_NARROWEST_SHARE = 1e-9
"""Least width of a knot span, as a fraction of the domain."""

_SAME_BREAK_SHARE = 1e-10  # breaks closer than this fraction of the domain count as equal
# breaks with a continuous slope count as equal if they are closer than this fraction of the domain
_ALIKE = 1e-7
# a knot span that is this many times wider than a neighbour with a large error is divided too
_WIDER_TIMES = 8.0

_CORRECTIONS = 2
"""Number of corrections for each knot vector. A correction moves all parameters to the nearest curve points."""

# least number of points from which noise is separated from shape
_ENOUGH_FOR_NOISE = 100
# penalty that has no visible effect, but determines the coefficients where there are no data
_LEAST_PENALTY = 1e-11


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
    """Return knots and coefficients (m, ...) of a clamped spline within `tolerance` of a function on `domain`.

    Parameters
    ----------
    function : callable
        Function of x (k,) that returns values (k,) or (k, q). The function is evaluated only inside the spans,
        so that a value at a break has no effect.
    tolerance : float
        Largest error of a value, measured between the interpolation points.
    breaks : sequence of (x, continuity)
        Values of x at which the function has only `continuity` continuous derivatives; -1 means a jump. The breaks
        become knots with the corresponding multiplicity.
    knots : (k,) array_like
        Initial knots in addition to the breaks; further knots are inserted where the error is too large.
    rounding : float
        Relative rounding error of the values of the function, which limits the tolerance.

    Raises
    ------
    NotConvergedError
        The function has a jump or kink that is not in `breaks`, or noise above the tolerance.
    """
    require_positive(tolerance, "the tolerance of a fit", "the unit of the values")
    if not callable(function):
        raise InputError(f"the function is {quoted(function)}: give a function of the arc length")
    if not (is_whole(degree) and 1 <= degree <= _MOST_DEGREE):
        raise InputError(f"the degree of a spline is {degree!r}: use 1 to {_MOST_DEGREE}")
    rows = numbers(breaks, "breaks")
    if rows.size and rows.shape[1:] != (2,):
        raise InputError(
            "`breaks` cannot be read: give pairs of a place and the number of continuous derivatives there"
        )
    edges, order = _first_edges(domain, rows.tolist(), np.asarray(knots, dtype=float))
    sites, weight = gauss_rule(degree + 3)
    while True:
        low, widths = edges[:-1], np.diff(edges)
        full = clamped_knots(edges, order, degree)
        # rows are spans; the columns are Gauss nodes for the fit, then probes for the error
        x = low[:, None] + widths[:, None] * np.concatenate([(1 + sites) / 2, _PROBES])
        values = sampled(function, x)
        # `_nearest` squares its weights, so it minimises the integral of the squared error by Gauss's rule
        weights = np.sqrt(widths[:, None] * weight)
        spans = bezier_spans(full, degree)
        coefficients = _nearest(spans, x[:, : sites.size], values[:, : sites.size], weights)
        probed = SplineFunction(full, coefficients, degree)(x[:, sites.size :])
        error = np.abs(probed - values[:, sites.size :]).reshape(low.size, -1).max(axis=1)
        accepted = max(tolerance, rounding * float(np.abs(values).max()))
        # a steep part causes errors beside it, so divide the worst spans first
        bad = error > max(accepted, 0.05 * float(error.max()))
        if not bad.any():
            return full, coefficients
        narrow = bad & (np.diff(edges) < _NARROWEST_SHARE * (edges[-1] - edges[0]))
        if narrow.any() or edges.size + np.count_nonzero(bad) > _MOST_SPANS:
            at = np.where(bad, error, 0.0).argmax()
            raise NotConvergedError(
                f"no spline approximates the function within {tolerance:g}: near {edges[at]:.6g} the error "
                f"stays {error[at]:.3g}; give this place in `breaks`, or set a larger tolerance"
            )
        parts = np.ones(low.size, dtype=int)
        # narrow spans cannot compensate for wide spans, so the wide neighbours of bad spans are divided too
        worst = bad.copy()
        worst[1:] |= bad[:-1] & (widths[1:] > _WIDER_TIMES * widths[:-1])
        worst[:-1] |= bad[1:] & (widths[:-1] > _WIDER_TIMES * widths[1:])
        # the error of a span is proportional to width^(degree + 1)
        parts[worst] = np.clip((error[worst] / accepted) ** (1 / (degree + 1)), 2, 8)
        start = low.repeat(parts) + numbers_in_groups(parts) * (widths / parts).repeat(parts)
        edges = np.append(start, edges[-1])


def _first_edges(
    domain: tuple[float, float], breaks: Sequence[tuple[float, int]], knots: FloatArray
) -> tuple[FloatArray, dict[float, int]]:
    """Return the initial edges (k,), and a dict from the x of a break to its number of continuous derivatives.

    Breaks that are too close count as one break, with the smallest of their numbers.
    """
    first, last = domain
    length, order, latest = last - first, dict[float, int](), first
    for place, continuity in sorted(breaks):
        if not first + _SAME_BREAK_SHARE * length < place < last - _SAME_BREAK_SHARE * length:
            continue
        before = order.get(latest)
        apart = _ALIKE if before is not None and max(before, continuity) > 0 else _SAME_BREAK_SHARE
        if before is not None and place - latest <= apart * length:
            if continuity >= before:
                continue
            del order[latest]
        order[place] = int(continuity)
        latest = place
    edges = np.array([first, *sorted(order), last])
    inside = distinct(knots[(knots > first) & (knots < last)])
    after = edges.searchsorted(inside)
    apart = np.minimum(inside - edges[after - 1], edges[after] - inside)
    return np.sort(np.concatenate([edges, inside[apart > _NARROWEST_SHARE * length]])), order


def sampled(function: Callable[[FloatArray], FloatArray], x: FloatArray) -> FloatArray:
    """Return the values (p, k, ...) of a function at x (p, k). Refuse values that are not finite."""
    values = numbers(function(x.ravel()), "values of a function")
    if values.shape[:1] != (x.size,):
        raise InputError(
            "a function along the curve gives the wrong number of values: give a value for each of "
            f"{x.size} places"
        )
    if not np.isfinite(values).all():
        first = np.argwhere(~np.isfinite(values.reshape(x.size, -1)).all(axis=1))[0, 0]
        raise InputError(
            f"the function is not finite at {x.ravel()[first]:.6g}: give a function with finite values"
        )
    return values.reshape(*x.shape, *values.shape[1:])


def _nearest(spans: Spans, x: FloatArray, values: FloatArray, weights: FloatArray) -> FloatArray:
    """Return the coefficients (m, ...) of the spline that approximates values at x by weighted least squares.

    x and the weights have the shape (p, k), the values (p, k, ...). Errors are multiplied by their weights and then
    squared. This replaces `make_lsq_spline` of SciPy, whose import is slow.
    """
    basis, index = spans.local_basis(x.ravel())
    first, weight = spans.first[index], weights.ravel()[:, None]
    rows, targets = basis * weight, values.reshape(x.size, -1) * weight
    order = range(rows.shape[1])
    # lower band storage of LAPACK: element (i, j) of the normal matrix is in row i - j and column j
    band = np.zeros((rows.shape[1], spans.count))
    right = np.zeros((spans.count, targets.shape[1]))
    for a in order:
        for b in order[a:]:
            band[b - a] += np.bincount(first + a, rows[:, a] * rows[:, b], spans.count)
        for column in range(targets.shape[1]):
            right[:, column] += np.bincount(first + a, rows[:, a] * targets[:, column], spans.count)
    _, solution, info = lapack().dpbsv(band, right, lower=1)
    if info:
        raise NotConvergedError(
            "No spline follows the function, because its places are too close together. Set a larger tolerance."
        )
    return np.asarray(solution.reshape(spans.count, *values.shape[2:]), dtype=float)


def fit_spline(
    points: ArrayLike, degree: int, tolerance: float, smoothing: float | None = None
) -> tuple[FloatArray, FloatArray]:
    """Return knots and control points of a clamped spline whose distance from `points` is at most `tolerance`.

    Knots are added where points are too far from the spline. Between iterations, every point gets the
    parameter of the nearest point of the spline. The correlation of the remaining deviations of neighbouring
    points separates noise from shape. Shape is approximated within a third of the tolerance, so that the
    curvature is accurate. Noise is removed by the largest penalty on the third derivative that hardly increases
    the mean distance. If no such spline is within the tolerance, the points are interpolated.
    """
    data = distinct_points(points)
    _check_options(degree, tolerance, smoothing)
    ends = np.repeat([0.0, 1.0], degree + 1)
    if len(data) == 2:
        u = np.linspace(0.0, 1.0, degree + 1)[:, None]
        return ends, data[0] * (1 - u) + data[1] * u
    if len(data) <= degree:
        return _through(data, degree)
    inner, t = np.empty(0), _chord_parameters(data)
    before, aim = np.inf, tolerance
    while True:
        problem = _Problem(np.sort(np.concatenate([ends, inner])), degree, data)
        try:
            control, t = problem.solved(t, max(_LEAST_PENALTY, (smoothing or 0.0) * problem.scale))
        except np.linalg.LinAlgError:
            return _through(data, degree)
        error = problem.distance(control, t)
        worst, alike = error.max(), problem.likeness(control, t)
        if worst <= tolerance:
            # enough points for each control point for a fit within a third of the tolerance
            ample = len(data) >= 4 * len(control)
            aim = tolerance / 3 if alike > 0.5 and ample and not smoothing else tolerance
        # with a given smoothing, further knots may not reduce the error
        if worst <= aim or (smoothing and worst > 0.95 * before):
            break
        added = _new_knots(problem.spans.edges, t, error, aim)
        crowded = len(control) + added.size > len(data) / 2 + degree
        many = len(data) >= _ENOUGH_FOR_NOISE
        noisy = many and alike < 0.2 and np.median(error) > tolerance / 3
        if not added.size or crowded or noisy:
            if worst <= tolerance:
                break
            # the linear system of an interpolation is dense
            if many and (alike < 0.2 or len(data) > 1000):
                far, typical = error.argmax(), float(np.sqrt((error**2).mean()))
                raise NotConvergedError(
                    "the points have noise of {typical:.2g} about a smooth curve, up to {worst:.2g} (at {place}), "
                    "more than the tolerance of {tolerance:g}: set a tolerance of about {enough:.1g} or a "
                    "smoothing, or remove outliers",
                    typical=Length(typical), worst=Length(error[far]), place=Point(data[far]),
                    tolerance=Length(tolerance), enough=Length(1.5 * error[far]),
                )  # fmt: skip
            return _through(data, degree)
        before = worst
        inner = np.concatenate([inner, added])
    if smoothing is None and alike <= 0.5:
        mean = float(np.sqrt((problem.distance(control, t) ** 2).mean()))
        # a smoother curve may be a little farther from the points
        control = _smoothed(problem, control, t, tolerance, 1.1 * mean)
    return problem.knots, control


def smoothest_spline(points: ArrayLike, degree: int, tolerance: float) -> tuple[FloatArray, FloatArray]:
    """Return knots and control points of the smoothest clamped spline within `tolerance` of `points` (n, 2).

    The spline has about one knot for each point. The penalty on its third derivative is the largest with
    which all points are within the tolerance. With increasing tolerance, the spline changes from interpolation to
    a parabola, without oscillations. For 100 points or more, `fit_spline` is used.
    """
    data = distinct_points(points)
    if not degree < len(data) < _ENOUGH_FOR_NOISE:
        return fit_spline(data, degree, tolerance)
    _check_options(degree, tolerance, None)
    t = _chord_parameters(data)
    problem = _Problem(_knots_for(t, degree), degree, data)
    return problem.knots, _smoothed(problem, problem.fitted(t, _LEAST_PENALTY), t, tolerance, np.inf)


NOISE_SPARE, FREEDOM = 1.3, 18
"""The mean square distance of a closed spline from n points is the squared noise times 1.3 n / (n + 18).

A spline near few points follows a part of their noise. A spline near many points would show waves if its distance
were less than the noise.
"""


def closed_spline(
    points: FloatArray, degree: int, tolerance: float, noise: float = 0.0
) -> tuple[FloatArray, FloatArray]:
    """Return knots and control points of the smooth closed spline near closed points (n, 2).

    The spline is smooth where it starts and ends, and does not depend on the first of the points. Its root mean
    square distance from the points is their noise (mm, a standard deviation), but at least so small that points
    without noise are within `tolerance` mm (Dierckx, Curve and Surface Fitting with Splines, 1993, section 6.2).
    """
    from scipy.interpolate import splev, splprep

    count = len(points) - 1
    noise *= np.sqrt(NOISE_SPARE * count / (count + FREEDOM))
    # a closer curve would hardly be better
    mean = max(noise, tolerance * min(0.02, 1 / np.sqrt(count)))
    first = int(np.lexsort(points[:-1].T)[0])  # a start that depends on the shape alone
    around = begun_at(points, first)
    # points are left out if the mean distance from them is more than a tenth of their spacing
    crowd = ceil(mean / 0.1 * count / lengths_along(points)[-1])
    step = max(1, min(crowd, count // FEWEST_AROUND))
    some = thinned(around, step)
    # `periodic` is the tuple (knots, coefficients, degree); `places` are the parameters of the points in 0..1
    (periodic, places), *_ = splprep(
        some.T, s=(len(some) - 1) * mean**2, k=degree, per=True, quiet=2, full_output=True
    )
    # parameter of the first of the given points, where the clamped spline starts
    start = np.interp(count - first, thinned(np.arange(count + 1.0), step), places)
    near = np.sort((periodic[0][degree : -degree - 1] - start) % 1.0)
    inner = near[(near > _SAME_BREAK_SHARE) & (near < 1 - _SAME_BREAK_SHARE)]
    knots = clamped_knots(np.concatenate([[0.0], inner, [1.0]]), {}, degree)
    sites = interpolation_sites(knots, degree)
    values = np.column_stack(splev((sites + start) % 1.0, periodic))
    return knots, interpolated(sites, values, knots, degree)


class _Problem:
    """Least-squares problem for the control points of a spline with given knots.

    The data are points (n, 2) at parameters t (n,) from 0 to 1, and control points are (m, 2).
    """

    def __init__(self, knots: FloatArray, degree: int, data: FloatArray) -> None:
        self.knots = knots
        self.spans = bezier_spans(knots, degree)
        self.data = data
        gram = _derivative_gram(self.spans)
        self.scale = float(gram.trace())
        # with the trace n, a factor of the penalty has the same effect for all knots and numbers of points
        self.penalty = gram * (data.shape[0] / self.scale)
        # latest parameters and their basis (n, m), which several methods need
        self._latest: tuple[FloatArray, FloatArray] = (np.empty(0), np.empty((0, 0)))

    def solved(self, t: FloatArray, weight: float) -> tuple[FloatArray, FloatArray]:
        """Return the fitted control points, and the parameters after `_CORRECTIONS` corrections."""
        control = self.fitted(t, weight)
        for _ in range(_CORRECTIONS):
            t = self.feet(control, t)
            control = self.fitted(t, weight)
        return control, t

    def fitted(self, t: FloatArray, weight: float) -> FloatArray:
        """Return the control points (m, 2) of the least-squares spline for data at parameters t (n,).

        The spline passes through the first and the last point. `weight` is the factor of the penalty.
        """
        basis = self._basis(t)
        edges = self.spans.edges
        from_ends = np.minimum(t / (edges[1] - edges[0]), (1 - t) / (edges[-1] - edges[-2]))
        # Least squares alone would be inaccurate in the first and last knot span. A weight that increases towards
        # the ends as the Chebyshev weight does, 1 / sqrt(distance), makes the errors there as small as elsewhere.
        weighted = basis.T * (1 / np.sqrt(from_ends.clip(1e-3, 1.0)))
        normal = weighted @ basis + weight * self.penalty
        ends = self.data[[0, -1]]
        right = weighted @ self.data - normal[:, [0, -1]] @ ends
        inner: FloatArray = np.linalg.solve(normal[1:-1, 1:-1], right[1:-1])
        return np.concatenate([ends[:1], inner, ends[1:]])

    def _basis(self, t: FloatArray) -> FloatArray:
        if self._latest[0] is not t:
            self._latest = t, self.spans.basis(t)
        return self._latest[1]

    def _gap(self, control: FloatArray, t: FloatArray) -> FloatArray:
        return self.data - self._basis(t) @ control

    def feet(self, control: FloatArray, t: FloatArray) -> FloatArray:
        """Return the parameters of the curve points nearest to the data, by a single Gauss-Newton step from t."""
        gap = self._gap(control, t)
        velocity = self.spans.basis(t, 1) @ control
        gap[[0, -1]] = 0.0
        speed2 = dot(velocity, velocity)
        step = dot(gap, velocity) / np.maximum(speed2, 1e-12 * speed2.max())
        moved = t + step
        if (np.diff(moved) > 0).all() and moved[0] >= 0 and moved[-1] <= 1:
            return np.asarray(moved)
        # parameters must keep their order
        reach = 0.4 * np.diff(t, prepend=0.0, append=1.0)
        return np.asarray(t + np.clip(step, -reach[:-1], reach[1:]))

    def distance(self, control: FloatArray, t: FloatArray) -> FloatArray:
        return norm(self._gap(control, t))

    def likeness(self, control: FloatArray, t: FloatArray) -> float:
        """Return the correlation of the deviations of neighbouring points: 0 for noise, 1 for a missed shape."""
        gap = self._gap(control, t)
        total = float((gap**2).sum())
        return float((gap[1:] * gap[:-1]).sum()) / total if total > 0 else 0.0


def _smoothed(
    problem: _Problem, control: FloatArray, t: FloatArray, tolerance: float, mean: float
) -> FloatArray:
    """Return the control points of the smoothest spline.

    The largest error is at most `tolerance`, and the root mean square error at most `mean`.
    """
    # bisection of the logarithm of the penalty; `control` is the smoothest spline that is close enough
    low, high = np.log10(_LEAST_PENALTY), 6.0
    for _ in range(12):
        middle = (low + high) / 2
        try:
            candidate = problem.fitted(t, 10.0**middle)
        except np.linalg.LinAlgError:
            high = middle
            continue
        error = problem.distance(candidate, t)
        if error.max() <= tolerance and np.sqrt((error**2).mean()) <= mean:
            low, control = middle, candidate
        else:
            high = middle
    return control


def _check_options(degree: int, tolerance: float, smoothing: float | None) -> None:
    if degree not in (3, 4, 5):
        raise InputError(f"the degree of a fitted curve is {degree!r}: use 3, 4 or 5")
    require_positive(tolerance, "the tolerance of a fit")
    if smoothing is not None and not (is_number(smoothing) and smoothing >= 0):
        raise InputError(f"the smoothing of a fit is {smoothing!r}: use 0 or more")


def _through(data: FloatArray, degree: int) -> tuple[FloatArray, FloatArray]:
    """Return knots and control points of the interpolating spline with the least integral of (d3/dt3)^2."""
    t = _chord_parameters(data)
    knots = _knots_for(t, degree)
    spans = bezier_spans(knots, degree)
    gram, basis = _derivative_gram(spans), spans.basis(t)
    n, m = basis.shape
    gram = gram / gram.trace()
    # minimum with equality constraints: the lower rows of the solution are Lagrange multipliers
    saddle = np.block([[gram, basis.T], [basis, np.zeros((n, n))]])
    right = np.concatenate([np.zeros((m, 2)), data - data[0]])
    try:
        solution = np.linalg.solve(saddle, right)
    except np.linalg.LinAlgError:
        solution = np.linalg.lstsq(saddle, right, rcond=1e-15)[0]
    control: FloatArray = solution[:m] + data[0]
    control[[0, -1]] = data[[0, -1]]
    return knots, control


def _knots_for(t: FloatArray, degree: int) -> FloatArray:
    """Return knots at the points, or between the points for even degrees, to avoid oscillations of the spline."""
    inner = t[1:-1] if degree % 2 else midpoints(t)
    return np.concatenate([np.zeros(degree + 1), inner, np.ones(degree + 1)])


def distinct_points(points: ArrayLike) -> FloatArray:
    """Return the points (n, 2) to fit, without equal neighbours."""
    data = finite("points", points)
    if data.ndim != 2 or data.shape[1] != 2:
        raise InputError(f"points to fit have the shape {data.shape}: give rows of x, y, shape (n, 2)")
    moved = norm(np.diff(data, axis=0)) > 1e-12 * np.abs(data).max(initial=0.0)
    data = data[np.append(True, moved)] if len(data) > 1 else data
    if len(data) < 2:
        raise InputError("there are fewer than two different points to fit: give at least two")
    return data


def _chord_parameters(data: FloatArray) -> FloatArray:
    chord = lengths_along(data)
    return np.asarray(chord / chord[-1])


def _derivative_gram(spans: Spans) -> FloatArray:
    """Return the integrals (m, m) of products of the third derivatives of the basis functions."""
    x, w = gauss_rule(spans.degree - 2)
    half = spans.widths[:, None] / 2
    t = (spans.edges[:-1, None] + half * (1 + x)).ravel()
    rows = spans.basis(t, 3) * np.sqrt(half * w).reshape(-1, 1)
    return rows.T @ rows


def _new_knots(edges: FloatArray, t: FloatArray, error: FloatArray, tolerance: float) -> FloatArray:
    """Return the knots to add: one in each span with an error (n,) at t (n,) above the tolerance.

    A knot is in the middle of the span or, if the span has few data, in the middle of the data.
    """
    span = (edges.searchsorted(t, side="right") - 1).clip(0, edges.size - 2)
    worst = np.zeros(edges.size - 1)
    np.maximum.at(worst, span, error)
    added = []
    for i in (-worst).argsort(kind="stable"):
        inside = np.sort(t[span == i])
        if worst[i] <= tolerance or inside.size < 2:
            continue
        half = inside.size // 2
        many = inside.size >= 8
        added.append((edges[i] + edges[i + 1]) / 2 if many else (inside[half - 1] + inside[half]) / 2)
    return np.array(added)
