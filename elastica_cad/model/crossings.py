"""Crossings in space of two bent strips, taken as ruled surfaces.

Notation: strip a has a plane curve gamma_a with arc length s_a, and rulings in the direction z_a. Its points are
gamma_a(s_a) + v z_a. The points of strip b are gamma_b(s_b) + u z_b. The height of a point is its component along
n = z_a x z_b.

Where the strips meet, both curves have equal heights: <n, gamma_a(s_a)> = <n, gamma_b(s_b)>. The solutions
(s_a, s_b) are the level set, which consists of curves called branches. Each strip is divided into stretches of
monotone height. A stretch of strip a and a stretch of strip b share at most one branch. The other components of
gamma_a + v z_a = gamma_b + u z_b give v and u.

If the rulings are parallel, n is zero. A common ruling then passes through each crossing of the plane curves.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise
from typing import TypeAlias

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import BoolArray, FloatArray, IntArray
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.path import Spline
from elastica_cad.geometry.path_intersections import segment_crossings
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.geometry.plane_points import distinct, left_of, lengths_along, unit
from elastica_cad.geometry.profile import Profile
from elastica_cad.geometry.splines import SplineFunction

InPlane = tuple[FloatArray, FloatArray]
"""Points and unit tangents, (n, 2) each, of a strip's curve, in the plane of the curve."""


@dataclass(frozen=True, eq=False)
class RuledStrip:
    """Surface of a bent strip: the points gamma(s) + v z with |v| <= width(s) / 2.

    The curve gamma is in the plane of `frame`. The rulings are parallel to z, the z axis of `frame`.

    Parameters
    ----------
    curve : PlaneCurve
    frame : Frame
    width : Profile
        Full width, mm, as a function of arc length.
    """

    curve: PlaneCurve
    frame: Frame
    width: Profile

    @property
    def length(self) -> float:
        """Length of the strip, mm."""
        return self.width.length

    @property
    def axis(self) -> FloatArray:
        """Direction of the rulings (3,)."""
        return self.frame.z_axis

    @property
    def stations(self) -> FloatArray:
        """Arc lengths (n,) at which the search for crossings starts."""
        # inner knots occur twice, and the first and last knot four times
        return self._spline.knots[2:-2:2]

    def half_width(self, s: FloatArray) -> FloatArray:
        """Return half the width (n,), mm, at arc lengths (n,)."""
        return self.width(s) / 2

    def motion(self, s: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return points of the curve in space and unit tangents, (n, 3) each, at arc lengths (n,)."""
        p, d = self.in_plane(s)
        return self.frame.point(p), self.frame.direction(d)

    def normal(self, tangent: FloatArray) -> FloatArray:
        """Return unit normals (n, 3), to the left of the curve, for tangents (n, 2) in the plane of the curve."""
        return self.frame.direction(left_of(tangent))

    @cached_property
    def box(self) -> FloatArray:
        """Low and high corner (2, 3), mm, of the bounding box of the surface in `frame`."""
        reach = self.width.extremes[1] / 2
        low, high = self.curve.bounds
        return np.array([[*low, -reach], [*high, reach]])

    def in_plane(self, s: FloatArray) -> InPlane:
        """Return points and unit tangents, in the plane of the curve, at arc lengths (n,)."""
        return self._spline.value_and_slope(s)

    @property
    def _spline(self) -> SplineFunction:
        return _spline_over_arc_length(self.curve, self.length)


def strips_may_meet(strips: Sequence[RuledStrip], extensions: FloatArray | None = None) -> BoolArray:
    """Return a matrix (n, n) that is False for each pair of strips whose bounding boxes do not overlap.

    Each box is first extended on all sides by `extensions` (n,), mm. Two boxes are compared along the axes of
    both strips.
    """
    extensions = np.zeros(len(strips)) if extensions is None else extensions
    axes, origins, boxes = (
        np.array(rows).reshape(-1, *shape)
        for rows, shape in (
            ([strip.frame.axes for strip in strips], (3, 3)),
            ([strip.frame.origin for strip in strips], (3,)),
            ([strip.box for strip in strips], (2, 3)),
        )
    )
    centers = origins + (boxes.mean(axis=1)[:, None] @ axes)[:, 0]
    sizes = (boxes[:, 1] - boxes[:, 0]) / 2
    # boxes without thickness can overlap in spite of rounding
    extensions = extensions + 1e-12 * (np.abs(centers).max(initial=0.0) + sizes.max(initial=0.0))
    overlaps = np.empty((len(strips), len(strips)), dtype=bool)
    for box_axes, box, extension, sees, origin in zip(
        axes, boxes, extensions, overlaps, origins, strict=True
    ):
        # centres and half sizes (n, 3) of the extended boxes of all strips along the axes of this box
        center = (centers - origin) @ box_axes.T
        half = (np.abs(box_axes @ np.swapaxes(axes, 1, 2)) @ sizes[..., None])[..., 0] + (
            extensions + extension
        )[:, None]
        sees[:] = np.all((box[0] <= center + half) & (box[1] >= center - half), axis=1)
    return overlaps & overlaps.T


@lru_cache(maxsize=128)
def _spline_over_arc_length(curve: PlaneCurve, length: float) -> SplineFunction:
    """Return the curve as a cubic spline of the arc length of a strip of this length, mm."""
    panels = curve.smooth_panels
    # with 400 samples or more, interpolation is accurate to 1e-5 mm
    t = _subdivided(panels, -(-400 // (panels.size - 1)))
    s, points, velocity = curve.arc_length(t) * length / curve.length, curve.evaluate(t), curve.evaluate(t, 1)
    ahead, thirds = unit(velocity), np.diff(s)[:, None] / 3
    # inner control points (n, 2, 2) of the cubic piece between each two samples
    handles = np.stack([points[:-1] + thirds * ahead[:-1], points[1:] - thirds * ahead[1:]], axis=1)
    coefficients = np.concatenate([points[:1], handles.reshape(-1, 2), points[-1:]])
    return SplineFunction(np.pad(np.repeat(s, 2), 2, mode="edge"), coefficients, 3)


def _subdivided(places: FloatArray, parts: int) -> FloatArray:
    """Return places (n,), and between them the places that divide each interval into `parts` equal parts."""
    inner = places[:-1, None] + np.diff(places)[:, None] * np.arange(parts) / parts
    return np.append(inner, places[-1])


def _bracketed_zeros(
    function: Callable[[FloatArray], FloatArray],
    low: FloatArray,
    high: FloatArray,
    *,
    values: tuple[FloatArray, FloatArray],
) -> FloatArray:
    """Return a zero in each of n intervals (low, high), at whose ends the function has opposite signs.

    All intervals are solved together by the false position method of Anderson and Bjorck (BIT 13, 1973).
    """
    if not low.size:
        return low
    # f and g are the values at `low` and `high`, and h is the value at the newest point `root`
    f, g = values
    root, h = high, g
    # a few steps usually suffice
    for _ in range(80):
        # 1e-11 mm is the rounding error in a model of 10 m
        moving = np.abs(h) > 1e-11
        if not np.any(moving & (np.abs(high - low) > 1e-15 * np.maximum(np.abs(high), np.abs(low)))):
            break
        slope = np.where(g != f, g - f, 1.0)
        root = np.where(moving, high - g * (high - low) / slope, root)
        h = function(root)
        crossed = np.sign(h) * np.sign(g) <= 0
        ratio = 1.0 - h / np.where(g != 0, g, 1.0)
        low, f = np.where(crossed, high, low), np.where(crossed, g, f * np.where(ratio > 0, ratio, 0.5))
        high, g = root, h
    return root


PARALLEL_RAD = 2e-8
"""Largest angle, rad, at which rulings count as parallel. Over 1 m, their distance then changes by 20 nm."""


@dataclass(frozen=True, eq=False)
class IntersectionPoints:
    """Common points of two surfaces: arc lengths on both curves (n,) and distances along both rulings (n,), mm.

    `on_curves` has the points and tangents of both curves at these arc lengths.
    """

    s_a: FloatArray
    s_b: FloatArray
    v: FloatArray
    u: FloatArray
    on_curves: tuple[InPlane, InPlane]


def margins(strips: tuple[RuledStrip, RuledStrip], p: IntersectionPoints) -> FloatArray:
    """Return distances (n, 4), mm, from the upper and lower edges of both strips, negative outside a strip."""
    w, x = strips[0].half_width(p.s_a), strips[1].half_width(p.s_b)
    return np.column_stack([w - p.v, w + p.v, x - p.u, x + p.u])


@dataclass(frozen=True, eq=False)
class Ruling:
    """Intersection line of two strips with parallel rulings.

    A point on the line is given by q, its distance along the ruling of the first strip, mm.
    """

    strips: tuple[RuledStrip, RuledStrip]
    s_a: float
    s_b: float
    offset: float  # distance from the first to the second curve along the first strip's ruling, mm
    sign: float  # +1 if the rulings of both strips have equal directions, -1 if they are opposite
    reach: float  # bound on |q|, mm, that is beyond the edges of both strips

    @property
    def nodes(self) -> FloatArray:
        """Parameters q of points along the ruling, from end to end."""
        return np.linspace(-self.reach, self.reach, 9)

    def at(self, q: FloatArray) -> IntersectionPoints:
        """Return the points with the parameters q on this ruling."""
        s_a, s_b = np.full(q.size, self.s_a), np.full(q.size, self.s_b)
        on_curves = self.strips[0].in_plane(s_a), self.strips[1].in_plane(s_b)
        return IntersectionPoints(s_a, s_b, q, self.sign * (q - self.offset), on_curves)


def _rulings(a: RuledStrip, b: RuledStrip) -> list[Ruling]:
    """Return the crossings of strips with parallel rulings, which are lines along the rulings."""
    sign = float(np.sign(a.axis @ b.axis))
    moved = Frame(a.frame.local(b.frame.origin), a.frame.axes @ b.frame.x_axis, a.frame.axes @ b.frame.y_axis)
    # map (3, 3) from the plane of the curve of b to the plane of the curve of a, for points (x, y, 1)
    m = np.eye(3)
    m[:2] = np.column_stack([moved.x_axis[:2], moved.y_axis[:2], moved.origin[:2]])
    first, second = Spline(a.curve), Spline(b.curve.transformed(m))
    crossings = segment_crossings(first, second)
    offset = float(moved.origin[2])
    reach = a.width.extremes[1] + b.width.extremes[1] + abs(offset)
    # parameters (n,) of the splines of a and b, from 0 to 1
    x, y = np.array(crossings, dtype=float).reshape(-1, 2).T
    s_a = a.curve.arc_length(first.parameter(x)) * a.length / a.curve.length
    s_b = b.curve.arc_length(second.parameter(y)) * b.length / b.curve.length
    return [Ruling((a, b), float(s), float(r), offset, sign, reach) for s, r in zip(s_a, s_b, strict=True)]


@dataclass(frozen=True, eq=False)
class _Heights:
    """Heights of the curves of two strips along the normal n of both rulings."""

    a: RuledStrip
    b: RuledStrip
    n: FloatArray

    def above(self, strip: RuledStrip, places: InPlane) -> tuple[FloatArray, FloatArray]:
        """Return heights (n,) of a curve above the origin of strip a, and derivatives (n,) by arc length."""
        across, base = self._height_coefficients[0 if strip is self.a else 1]
        position, tangent = places
        return position @ across + base, tangent @ across

    @cached_property
    def _height_coefficients(self) -> tuple[tuple[FloatArray, float], ...]:
        origin, up = self.a.frame.origin, self.n / np.linalg.norm(self.n)
        return tuple(
            (strip.frame.axes[:2] @ up, float((strip.frame.origin - origin) @ up))
            for strip in (self.a, self.b)
        )


@dataclass(frozen=True, eq=False)
class Branch:
    """Curve along which both strips have equal heights, given by nodes: pairs of arc lengths (s_a, s_b).

    The parameter q has the value k at node k.
    """

    heights: _Heights
    s_a: FloatArray
    s_b: FloatArray

    @property
    def nodes(self) -> FloatArray:
        """Parameters of the nodes: 0, 1, 2, ..."""
        return np.arange(self.s_a.size, dtype=float)

    def at(self, q: FloatArray) -> IntersectionPoints:
        """Return common points at parameters q. Newton's method starts on the lines between nodes."""
        h = self.heights
        s_a, s_b = (np.interp(q, self.nodes, row) for row in (self.s_a, self.s_b))
        on_curves = h.a.in_plane(s_a), h.b.in_plane(s_b)
        tolerance = 1e-13 * max(h.a.length, h.b.length)
        for _ in range(30):
            (p, f), (r, g) = h.above(h.a, on_curves[0]), h.above(h.b, on_curves[1])
            if np.abs(p - r).max(initial=0.0) <= tolerance:
                break
            # the divisor is limited, because both slopes are 0 where the surfaces touch
            step = (p - r) / np.maximum(f**2 + g**2, 1e-14)
            s_a, s_b = (s_a - step * f).clip(0.0, h.a.length), (s_b + step * g).clip(0.0, h.b.length)
            on_curves = h.a.in_plane(s_a), h.b.in_plane(s_b)
        # gap = v z_a - u z_b
        gap = h.b.frame.point(on_curves[1][0]) - h.a.frame.point(on_curves[0][0])
        v, u = np.cross([h.b.axis, h.a.axis], h.n) / (h.n @ h.n) @ gap.T
        return IntersectionPoints(s_a, s_b, v, u, on_curves)


IntersectionCurve: TypeAlias = Branch | Ruling
"""Curve along which two surfaces intersect. Between two nodes, the curve may still cross edges of the strips."""

_Course: TypeAlias = tuple[FloatArray, FloatArray]
"""Arc lengths (n,) on strip a and on strip b along a line of equal height."""

_Extreme: TypeAlias = tuple[str, int, int]
"""Strip with a height extreme ("a" or "b"), its stretch that begins there, and the other strip's stretch."""


def _level_set(heights: _Heights) -> list[_Course]:
    """Return the curves of equal height on both strips, each as arc lengths on strip a and on strip b."""
    # each stretch has arc lengths s and heights c
    first = _monotone_stretches(heights, heights.a)
    second = _monotone_stretches(heights, heights.b)
    pieces: list[_Course] = []
    ends: list[list[_Extreme | None]] = []
    level: list[_Course] = []
    for k, (s_a, c_a) in enumerate(first):
        for m, (s_b, c_b) in enumerate(second):
            low, high = max(c_a.min(), c_b.min()), min(c_a.max(), c_b.max())
            if not low < high:
                # the height is constant on one of the two stretches: the arc length on the other one is constant
                if c_b[0] == c_b[-1] and c_a.min() < c_b[0] < c_a.max():
                    level.append((_arc_lengths_at(s_a, c_a, c_b[:1]).repeat(s_b.size), s_b))
                if c_a[0] == c_a[-1] and c_b.min() < c_a[0] < c_b.max():
                    level.append((s_a, _arc_lengths_at(s_b, c_b, c_a[:1]).repeat(s_a.size)))
                continue
            inside = np.concatenate([c_a, c_b])
            # nodes closer together in height are merged
            least = 1e-9 * max(heights.a.length, heights.b.length)
            inside = np.sort(inside[(inside > low + least) & (inside < high - least)])
            c = np.concatenate([[low], inside[np.diff(inside, prepend=low) > least], [high]])
            pieces.append((_arc_lengths_at(s_a, c_a, c), _arc_lengths_at(s_b, c_b, c)))
            ends.append([_extreme_at_end(k, c_a, m, c_b, bound) for bound in (low, high)])
    return [*level, *_joined(pieces, ends, len(first), len(second))]


def _monotone_stretches(heights: _Heights, strip: RuledStrip) -> list[tuple[FloatArray, FloatArray]]:
    """Return arc lengths and heights of the stretches of a strip between extremes of the height."""
    s = strip.stations
    height, slope = heights.above(strip, strip.in_plane(s))
    # a level curve has one height, except for rounding
    if np.abs(slope).max() < 1e-12:
        return [(s, np.full(s.size, height.mean()))]
    turns = np.flatnonzero((slope[:-1] < 0) != (slope[1:] < 0))
    zeros = _bracketed_zeros(
        lambda x: heights.above(strip, strip.in_plane(x))[1],
        s[turns],
        s[turns + 1],
        values=(slope[turns], slope[turns + 1]),
    )
    top, _ = heights.above(strip, strip.in_plane(zeros))
    s, height = np.insert(s, turns + 1, zeros), np.insert(height, turns + 1, top)
    stops = [0, *(turns + 1 + np.arange(turns.size)).tolist(), s.size - 1]
    return [(s[i : j + 1], height[i : j + 1]) for i, j in pairwise(stops)]


def _arc_lengths_at(s: FloatArray, c: FloatArray, at: FloatArray) -> FloatArray:
    order = 1 if c[-1] > c[0] else -1
    return np.interp(at, c[::order], s[::order])


def _extreme_at_end(k: int, c_a: FloatArray, m: int, c_b: FloatArray, bound: float) -> _Extreme | None:
    """Return the height extreme at which a line of equal height ends, or None where the surfaces touch.

    The line is on stretch k of strip a, with heights c_a, and on stretch m of strip b, with heights c_b. It ends at
    the height `bound`. The result has the strip with the extreme ("a" or "b"), the index of its stretch that
    begins there, and the index of the other strip's stretch.
    """
    as_a, as_b = bound in (c_a[0], c_a[-1]), bound in (c_b[0], c_b[-1])
    if as_a and as_b:
        return None
    if as_a:
        return "a", k if bound == c_a[0] else k + 1, m
    return "b", m if bound == c_b[0] else m + 1, k


def _joined(
    pieces: list[_Course],
    ends: list[list[_Extreme | None]],
    count_a: int,
    count_b: int,
) -> list[_Course]:
    """Join the pieces that meet at a height extreme of a strip.

    `ends` has the extremes at the low and the high end of each piece. `count_a` and `count_b` are the numbers of
    stretches of the strips a and b.
    """
    counts = {"a": count_a, "b": count_b}
    pieces_at: dict[_Extreme, list[int]] = {}
    for i, pair in enumerate(ends):
        for key in pair:
            # before the first and after the last stretch the strip ends, so nothing continues
            if key is not None and 0 < key[1] < counts[key[0]]:
                pieces_at.setdefault(key, []).append(i)
    unused = set(range(len(pieces)))

    def pieces_beyond(i: int, key: _Extreme | None) -> list[_Course]:
        """Return the pieces that continue piece i beyond its end `key`, the last first, directed towards i."""
        chain: list[_Course] = []
        while key is not None:
            after = [j for j in pieces_at.get(key, []) if j != i and j in unused]
            if not after:
                break
            i = after[0]
            unused.discard(i)
            s_a, s_b = pieces[i]
            # a piece runs from its low to its high end
            step = 1 if ends[i][1] == key else -1
            chain.insert(0, (s_a[::step], s_b[::step]))
            key = ends[i][0 if step == 1 else 1]
        return chain

    chains: list[_Course] = []
    while unused:
        i = min(unused)
        unused.discard(i)
        before = pieces_beyond(i, ends[i][0])
        after = [(s_a[::-1], s_b[::-1]) for s_a, s_b in reversed(pieces_beyond(i, ends[i][1]))]
        rows = [*before, pieces[i], *after]
        s_a, s_b = (np.concatenate([rows[0][c], *(row[c][1:] for row in rows[1:])]) for c in (0, 1))
        chains.append((s_a, s_b))
    return chains


LENGTH_POINTS = 33
"""Number of points of the polyline that gives the length of a crossing with an error of 0.1 %."""


@dataclass(frozen=True, eq=False)
class CrossingPoints:
    """Points that two strips have in common.

    Attributes
    ----------
    first, second : (n, 2) arrays
        Points in the flat patterns of both strips: arc length, and distance from the centre line, mm.
    position : (n, 3) array
        Points in space, mm.
    angle : (n,) array
        Angles between the two surfaces, rad, from 0 to pi / 2.
    """

    first: FloatArray
    second: FloatArray
    position: FloatArray
    angle: FloatArray


@dataclass(frozen=True, eq=False)
class Crossing:
    """Line along which two strips cross. The line is equally long in space and in both flat patterns.

    Attributes
    ----------
    strips : pair of RuledStrip
    locus : Branch or Ruling
        Intersection curve of both surfaces, of which the crossing is a part.
    start, end : float
        Values of the intersection curve's parameter q at both ends of the crossing.
    """

    strips: tuple[RuledStrip, RuledStrip]
    locus: IntersectionCurve
    start: float
    end: float

    def at(self, x: FloatArray) -> CrossingPoints:
        """Return the points at parameters x (n,). Points with x outside 0..1 are beyond the ends."""
        a, b = self.strips
        p = self.locus.at(self.start + x * (self.end - self.start))
        (place, tangent), (_, other) = p.on_curves
        normals = a.normal(tangent), b.normal(other)
        # compute the tangent of half the angle, which is accurate for every angle
        apart, together = np.linalg.norm([normals[0] - normals[1], normals[0] + normals[1]], axis=2)
        return CrossingPoints(
            np.column_stack([p.s_a, p.v]),
            np.column_stack([p.s_b, p.u]),
            a.frame.point(place) + p.v[:, None] * a.axis,
            2 * np.arctan2(np.minimum(apart, together), np.maximum(apart, together)),
        )

    @cached_property
    def course(self) -> tuple[FloatArray, FloatArray, CrossingPoints]:
        """Samples of the crossing: parameters x (n,) from 0 to 1, lengths (n,) from the start, mm, and points."""
        nodes = (self.locus.nodes - self.start) / (self.end - self.start)
        x = distinct(np.concatenate([np.linspace(0.0, 1.0, LENGTH_POINTS), nodes[(nodes > 0) & (nodes < 1)]]))
        points = self.at(x)
        return x, lengths_along(points.position), points

    @property
    def length(self) -> float:
        """Length of the crossing, mm."""
        return float(self.course[1][-1])

    @cached_property
    def middle(self) -> float:
        """Parameter x at half the length of the crossing."""
        x, along, _ = self.course
        k = int(along.searchsorted(along[-1] / 2)) - 1
        # change of x per mm of the crossing
        pace = float((x[k + 1] - x[k]) / (along[k + 1] - along[k]))
        half = along[-1] / 2 - along[k]
        middle = float(x[k]) + pace * half
        # two secant steps are enough, because the length is smooth between nodes
        for _ in range(2):
            done = lengths_along(self.at(np.linspace(x[k], middle, 5)).position)[-1]
            middle += (half - done) * pace
        return float(middle)

    def evenly(self, start: float, end: float, pitch: float) -> FloatArray:
        """Return parameters x of 6 to 65 points from `start` to `end`, if possible at most `pitch` mm apart."""
        x, along, _ = self.course
        if min(start, end) < 0 or max(start, end) > 1:
            x = np.linspace(min(start, end), max(start, end), LENGTH_POINTS)
            along = lengths_along(self.at(x).position)
        low, high = np.interp([start, end], x, along)
        count = int(np.clip(abs(high - low) / pitch, 5, 64)) + 1
        return np.concatenate([[start], np.interp(np.linspace(low, high, count)[1:-1], along, x), [end]])

    def beyond(self, which: int, end: int) -> float | None:
        """Return the parameter x at which the extended crossing reaches a long edge of strip `which` (0 or 1).

        The crossing is extended beyond its start (`end` 0) or its end (`end` 1). Return None if the strip ends
        before its long edge is reached.
        """
        origin, step = (self.start, -1) if end == 0 else (self.end, 1)
        nodes = self.locus.nodes
        q = np.concatenate([[origin], nodes[(nodes - origin) * step > 0][::step]])
        m = margins(self.strips, self.locus.at(q))[:, 2 * which : 2 * which + 2]
        # the crossing ends on the edge
        if m[0].min() < 1e-8:
            return float(end)
        outside = np.flatnonzero(m.min(axis=1) < 0)
        if not outside.size:
            return None
        i, side = int(outside[0]), int(m[outside[0]].argmin())
        sides, values = np.array([2 * which + side]), (m[[i - 1], side], m[[i], side])
        root = float(_edge_crossings(self.strips, self.locus, (q[[i - 1]], q[[i]]), sides, values)[0])
        return (root - self.start) / (self.end - self.start)


def strip_crossings(a: RuledStrip, b: RuledStrip) -> tuple[Crossing, ...]:
    """Return all lines along which two bent strips cross.

    Points are computed by Newton's method to rounding error. A line ends at an edge or end of one of the
    strips.
    """
    n = np.cross(a.axis, b.axis)
    curves: Sequence[IntersectionCurve]
    if np.linalg.norm(n) < PARALLEL_RAD:
        curves = _rulings(a, b)
    else:
        heights = _Heights(a, b, n)
        curves = [Branch(heights, s_a, s_b) for s_a, s_b in _level_set(heights)]
    return tuple(
        Crossing((a, b), curve, *run) for curve in curves for run in _ranges_inside_strips((a, b), curve)
    )


def _ranges_inside_strips(
    strips: tuple[RuledStrip, RuledStrip], locus: IntersectionCurve
) -> list[tuple[float, float]]:
    """Return the ranges of the parameter q of an intersection curve that are inside both strips."""
    # each of four intervals between two nodes is searched for a strip edge
    q = _subdivided(locus.nodes, 4)
    m = margins(strips, locus.at(q))  # distances (n, 4), mm, from the four edges
    i, side = np.nonzero(np.sign(m[:-1]) * np.sign(m[1:]) < 0)
    on_edge = q[(m == 0).any(axis=1)]
    edges = _edge_crossings(strips, locus, (q[i], q[i + 1]), side, (m[i, side], m[i + 1, side]))
    cuts = distinct(np.concatenate([q[[0, -1]], on_edge, edges]))
    inside = margins(strips, locus.at((cuts[:-1] + cuts[1:]) / 2)).min(axis=1) > 0
    # 1 where a range inside both strips starts, -1 where it ends
    steps = np.diff(np.pad(inside.astype(int), 1))
    return [*zip(cuts[steps > 0].tolist(), cuts[steps < 0].tolist(), strict=True)]


def _edge_crossings(
    strips: tuple[RuledStrip, RuledStrip],
    locus: IntersectionCurve,
    between: tuple[FloatArray, FloatArray],
    sides: IntArray,
    values: tuple[FloatArray, FloatArray],
) -> FloatArray:
    """Return parameters q (n,) at which the intersection curve crosses an edge, one in each interval.

    `between` has the start and the end of each interval. `sides` (n,) selects the edge by its column of
    `margins`, and `values` has these margins at both ends of the intervals.
    """
    rows = np.arange(sides.size)
    return _bracketed_zeros(lambda q: margins(strips, locus.at(q))[rows, sides], *between, values=values)
