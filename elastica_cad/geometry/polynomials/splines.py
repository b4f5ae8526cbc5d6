"""B-splines by knots and coefficients: what knots are sound, Bezier pieces, basis functions, interpolation."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from math import ceil, cos, pi
from typing import Any

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray, IntArray
from elastica_cad._values import as_floats
from elastica_cad.errors import InputError
from elastica_cad.geometry.polynomials.bernstein import bernstein_values

SHORTEST_DOMAIN, FARTHEST_KNOT = 1e-9, 1e12
"""Shortest domain and largest knot with which splines are computed."""


def knot_runs(knots: FloatArray) -> tuple[FloatArray, IntArray]:
    """The distinct knots (k,) of a vector that never falls, and how often each stands there (k,).

    Examples
    --------
    >>> places, counts = knot_runs(np.array([0.0, 0.0, 1.0, 2.0, 2.0]))
    >>> places.tolist(), counts.tolist()
    ([0.0, 1.0, 2.0], [2, 1, 2])
    """
    rises = np.ones(knots.size + 1, dtype=bool)
    np.not_equal(knots[1:], knots[:-1], out=rises[1:-1])
    first = rises.nonzero()[0]  # of every run, and the end of the last one
    counts = first[1:] - first[:-1]
    return knots[first[:-1]], counts


def clamped_knots(edges: FloatArray, continuity: Mapping[float, int], degree: int) -> FloatArray:
    """Knots (m,) of a spline over the spans between edges (k,), as smooth at some of these as `continuity` says.

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


def greville(knots: FloatArray, degree: int) -> FloatArray:
    """Greville abscissae (..., m) of knot vectors (..., m + degree + 1): with these as x a spline draws itself.

    Examples
    --------
    >>> greville(np.array([0.0, 0.0, 0.0, 1.0, 2.0, 2.0, 2.0]), 2).tolist()
    [0.0, 0.5, 1.5, 2.0]
    """
    count = knots.shape[-1] - degree - 1
    total = sum((knots[..., i : i + count] for i in range(2, degree + 1)), start=knots[..., 1 : count + 1])
    return np.asarray(total / degree, dtype=float)


def finite(name: str, values: ArrayLike | Sequence[float] | float) -> FloatArray:
    """A read-only float array of `values`; refuses what is no number, NaN and infinity."""
    given = as_floats(values)
    if given is None:
        raise InputError("{name} must be numbers", name=name)
    array = given.copy()
    if not np.isfinite(array).all():
        first = np.argwhere(~np.isfinite(array))[0].tolist()
        raise InputError(
            "{name} holds NaN or infinite values, the first at index {first}", name=name, first=first
        )
    array.setflags(write=False)
    return array


def whole_degree(degree: int) -> int:
    """The degree as a plain int; refuses what is no whole number of 2 or more."""
    if isinstance(degree, bool) or not isinstance(degree, int | float | np.integer | np.floating):
        raise InputError("a curve needs degree 2 or more, not {degree!r}", degree=degree)
    if not (degree == np.floor(degree) and 2 <= degree < 100):
        raise InputError("a curve needs a whole degree of 2 or more, not {degree!r}", degree=degree)
    return int(degree)


def check_knots(knots: FloatArray, count: int, degree: int) -> None:
    """Refuse a knot vector that does not fit the control points or breaks the curve apart."""
    _check_knots(knots.tobytes(), count, degree)


@lru_cache(maxsize=64)
def _check_knots(written: bytes, count: int, degree: int) -> None:
    """The same of knots as bytes: curves side by side have the same."""
    knots = np.frombuffer(written)
    if count < degree + 1:
        raise InputError(
            "{count} control points are too few for degree {degree}: give {degree_2} or more",
            count=count,
            degree=degree,
            degree_2=degree + 1,
        )
    if knots.shape != (count + degree + 1,):
        raise InputError(
            "{count} control points of degree {degree} need {given} knots (the full vector, end "
            "knots repeated), not {size}",
            count=count,
            degree=degree,
            given=count + degree + 1,
            size=knots.size,
        )
    down = np.flatnonzero(np.diff(knots) < 0)
    if down.size:
        raise InputError(
            "knots must not decrease: knot {given} is less than knot {down}", given=down[0] + 1, down=down[0]
        )
    start, end = knots[degree], knots[-degree - 1]
    if not end > start:
        raise InputError("the knots leave no domain: the first and last inner knot coincide")
    if not (end - start >= SHORTEST_DOMAIN and np.abs(knots).max() <= FARTHEST_KNOT):
        raise InputError(
            "the knots run from {start:.3g} to {end:.3g}, where cubes of differences overflow or "
            "vanish: scale them to 0..1",
            start=start,
            end=end,
        )
    values, counts = knot_runs(knots)
    inside = (values > start) & (values < end)
    if inside.any() and counts[inside].max() > degree:
        where = values[inside][counts[inside].argmax()]
        raise InputError(
            "knot {place:g} is repeated {most} times: more than the degree {degree} breaks the curve apart",
            place=where,
            most=counts[inside].max(),
            degree=degree,
        )
    if counts.max() > degree + 1:
        raise InputError(
            "an end knot is repeated {most} times: degree {degree} allows {degree_2}",
            most=counts.max(),
            degree=degree,
            degree_2=degree + 1,
        )


@dataclass(frozen=True, eq=False)
class Spans:
    """The non-empty knot spans of a B-spline basis inside its domain.

    Attributes
    ----------
    count : int
        Number m of control points.
    edges : (p + 1,) array
        Ends of the spans in the parameter t, increasing.
    first : (p,) int array
        Index of the first of the degree + 1 control points that act on each span.
    matrix : (p, degree + 1, degree + 1) array
        Bezier control points of a span = matrix @ its B-spline control points.
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
    def widths(self) -> FloatArray:
        """Lengths (p,) of the spans in the parameter."""
        return np.asarray(self.edges[1:] - self.edges[:-1])

    def bezier(self, control_points: FloatArray) -> FloatArray:
        """Bezier control points (p, degree + 1, ...) of the spline with `control_points` (m, ...)."""
        local = control_points[self.first[:, None] + np.arange(self.degree + 1)]
        pieces = self.matrix @ local.reshape(*local.shape[:2], -1)
        return np.asarray(pieces.reshape(local.shape), dtype=float)

    def locate(self, t: FloatArray, *, left: bool = False) -> tuple[IntArray, FloatArray]:
        """Span index and local coordinate u in [0, 1] of parameters (n,); at an edge the right span."""
        index = np.searchsorted(self.edges[1:-1], t, side="left" if left else "right")
        u = (t - self.edges[index]) / self.widths[index]
        return index, np.minimum(np.maximum(u, 0.0), 1.0)

    def basis(self, t: FloatArray, derivative: int = 0) -> FloatArray:
        """Values (n, m) of the d-th derivative of all m basis functions at parameters (n,)."""
        local, index = self.local_basis(t, derivative)
        out = np.zeros((t.size, self.count))
        columns = self.first[index][:, None] + np.arange(self.degree + 1)
        out[np.arange(t.size)[:, None], columns] = local
        return out

    def local_basis(self, t: FloatArray, derivative: int = 0) -> tuple[FloatArray, IntArray]:
        """The degree + 1 basis functions that do not vanish (n, degree + 1), and the span index (n,)."""
        index, u = self.locate(t)
        width = self.widths[index]
        bernstein = bernstein_values(self.degree, u, derivative) / width[:, None] ** derivative
        return np.asarray(np.einsum("ni,nij->nj", bernstein, self.matrix[index])), index


def bezier_spans(knots: FloatArray, degree: int) -> Spans:
    """Bezier extraction of a B-spline basis with a full knot vector (m + degree + 1,), clamped or not.

    Bezier point j of the span [a, b] is the blossom at a (degree - j times) and b (j times).
    """
    return _spans(np.asarray(knots, dtype=float).tobytes(), degree)


@lru_cache(maxsize=64)
def _spans(written: bytes, degree: int) -> Spans:
    """The spans of knots as bytes: curves side by side and their moved copies have the same."""
    knots = np.frombuffer(written)
    span = (knots[degree + 1 : -degree] > knots[degree : -degree - 1]).nonzero()[0] + degree
    near = knots[span + np.arange(1 - degree, degree + 1)[:, None]]
    ends, size = near[degree - 1 : degree + 1], degree + 1
    # the spans run along the last axis
    points = np.broadcast_to(np.eye(size)[:, None, :, None], (size, 1, size, 1))
    for level in range(1, size):
        low, high = near[level - 1 : degree], near[degree : degree + size - level]
        # argument `level` of the blossom is a of the first Bezier points, b of the others
        shares = ((ends[:, None] - low) / (high - low))[(np.arange(size) >= level).astype(int)]
        shares = shares.swapaxes(0, 1)[:, :, None]
        points = points[:-1] * (1 - shares) + points[1:] * shares
    matrix = np.broadcast_to(points[0], (size, size, span.size)).transpose(2, 0, 1)
    edges = np.concatenate([ends[0], ends[1, -1:]])
    first, matrix = span - degree, np.ascontiguousarray(matrix)
    for shared in (edges, first, matrix):
        shared.setflags(write=False)
    return Spans(knots.size - size, edges, first, matrix)


def spline_through(x: FloatArray, values: FloatArray, degree: int) -> Any:
    """The `scipy.interpolate.BSpline` of odd degree through values (n, ...) at increasing x (n,).

    A cubic one has no knots at the places next to its ends, so that it is one polynomial there, a quintic one none
    at the two next to them. Of even degree it is the one polynomial through degree + 1 places.

    Examples
    --------
    >>> cubic = spline_through(np.arange(4.0), np.arange(4.0) ** 3 + 1, 3)
    >>> cubic.t.tolist(), cubic.c.round(9).tolist()
    ([0.0, 0.0, 0.0, 0.0, 3.0, 3.0, 3.0, 3.0], [1.0, 1.0, 1.0, 28.0])
    """
    from scipy.interpolate import make_interp_spline

    beside = (degree + 1) // 2
    inner = x[beside:-beside] if degree % 2 else x[:0]
    knots = np.concatenate([np.repeat(x[:1], degree + 1), inner, np.repeat(x[-1:], degree + 1)])
    return make_interp_spline(x, values, k=degree, t=knots)


def interpolation_sites(knots: FloatArray, degree: int) -> FloatArray:
    """Places (m,) for interpolation with clamped knots: the Greville abscissae, with both ends exact."""
    sites = greville(knots, degree)
    sites[[0, -1]] = knots[[0, -1]]
    return sites


def interpolated(sites: FloatArray, values: FloatArray, knots: FloatArray, degree: int) -> FloatArray:
    """Coefficients (m, ...) of the spline over given knots that has `values` (m, ...) at `sites` (m,)."""
    from scipy.interpolate import make_interp_spline

    return np.asarray(make_interp_spline(sites, values, k=degree, t=knots).c, dtype=float)


def unit_circle_arc(start: float, end: float) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Knots, control points (m, 2) and weights (m,) of degree 2 for the unit circle from angle start to end.

    Segments of at most a quarter turn, joined by double knots at the angles where they meet; the middle
    control point of a segment of angle 2 h has weight cos h (Piegl and Tiller, The NURBS Book, section 7.3).
    """
    count = max(1, ceil(abs(end - start) / (pi / 2) * (1 - 1e-12)))
    half = (end - start) / count / 2
    angle = start + half * np.arange(2 * count + 1)
    weights = np.ones(angle.size)
    weights[1::2] = cos(half)
    points = np.stack([np.cos(angle), np.sin(angle)], axis=1) / weights[:, None]
    joints = np.linspace(min(start, end), max(start, end), count + 1) - min(start, end)
    knots = np.concatenate([[0.0], np.repeat(joints, 2), [joints[-1]]])
    return knots, points, weights


def elevate_degree(
    knots: FloatArray, control_points: FloatArray, degree: int, weights: FloatArray | None = None
) -> tuple[FloatArray, FloatArray, FloatArray | None]:
    """Knots, control points and weights of the same clamped spline with one degree more.

    Every piece is raised as a Bezier piece, and control points are joined where pieces meet: knots that had
    multiplicity degree have degree + 1; knots of lower multiplicity become full ones, which leaves the curve as it
    is.

    Examples
    --------
    >>> knots, points, _ = elevate_degree(np.repeat([0.0, 1.0], 3), np.array([(0, 0), (3, 6), (6, 0)]), 2)
    >>> points.tolist()
    [[0.0, 0.0], [2.0, 4.0], [4.0, 4.0], [6.0, 0.0]]
    """
    spans = bezier_spans(knots, degree)
    w = np.ones(len(control_points)) if weights is None else weights
    pieces = spans.bezier(np.column_stack([control_points * w[:, None], w]))
    share = np.arange(1, degree + 1)[:, None] / (degree + 1)
    inner = share * pieces[:, :-1] + (1 - share) * pieces[:, 1:]
    raised = np.concatenate([pieces[:, :1], inner, pieces[:, -1:]], axis=1)
    rows = np.concatenate([raised[0], *(piece[1:] for piece in raised[1:])])
    edges = spans.edges
    new_knots = np.concatenate([edges[:1], np.repeat(edges, degree + 1), edges[-1:]])
    points = rows[:, :2] / rows[:, 2:]
    return new_knots, points, None if weights is None else rows[:, 2]
