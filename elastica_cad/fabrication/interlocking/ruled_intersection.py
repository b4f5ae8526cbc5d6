"""Curves along which two ruled surfaces meet, beyond their edges too.

gamma_a + v z_a = gamma_b + u z_b. Across both rulings, along n = z_a x z_b, only the two curves have a say:
<n, gamma_a(s_a)> = <n, gamma_b(s_b)> is a level set in the plane of (s_a, s_b), made of one branch for each pair
of stretches on which the two heights are monotone; v and u follow from what is left. With parallel rulings the
plane curves cross at points, each a whole ruling.
"""

from abc import abstractmethod
from collections.abc import Iterator
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Protocol

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.fabrication.interlocking.bracketed_zeros import bracketed_zeros
from elastica_cad.fabrication.interlocking.ruled_strip import InPlane, RuledStrip
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.paths.path_intersections import segment_crossings
from elastica_cad.geometry.paths.segments import Spline

PARALLEL_RAD = 2e-8
"""Rulings at less than this angle count as parallel: over 1 m they part by 20 nm."""

HEIGHT_ERROR = 1e-13
"""Newton's method ends where the two heights differ by less than this share of the longer strip: near rounding."""

MOST_STEPS = 30
"""Of Newton's method: six serve, and where surfaces touch it halves the error each step."""

SAME_HEIGHT = 1e-9
"""Nodes whose heights differ by less than this share of the longer strip are one: equal strips have theirs in
pairs, and between the two the way would stand still."""

LEVEL_SLOPE = 1e-12
"""A curve whose height has no larger slope anywhere is level: the rest is rounding."""

LEAST_SQUARED_SLOPE = 1e-14
"""Squared slope of the heights below which the surfaces touch; Newton's steps are kept short there."""


@dataclass(frozen=True, eq=False)
class IntersectionPoints:
    """Common points: arc lengths of both curves (n,), and how far along both rulings they lie (n,), mm.

    `on_curves` says where both curves are at these arc lengths.
    """

    s_a: FloatArray
    s_b: FloatArray
    v: FloatArray
    u: FloatArray
    on_curves: tuple[InPlane, InPlane]


class IntersectionCurve(Protocol):
    """A curve of common points over a parameter q between its first and last node."""

    @property
    @abstractmethod
    def nodes(self) -> FloatArray:
        """Places (k,) between which nothing but a crossing of an edge happens."""

    @abstractmethod
    def at(self, q: FloatArray) -> IntersectionPoints:
        """Common points at q (n,), to rounding error."""


def margins(strips: tuple[RuledStrip, RuledStrip], p: IntersectionPoints) -> FloatArray:
    """Distances (n, 4) from the upper and lower edge of the first strip, then of the second; negative outside."""
    w, x = strips[0].half_width(p.s_a), strips[1].half_width(p.s_b)
    return np.column_stack([w - p.v, w + p.v, x - p.u, x + p.u])


def intersect_surfaces(a: RuledStrip, b: RuledStrip) -> tuple[IntersectionCurve, ...]:
    """All curves in which the two surfaces, with rulings of any length, meet."""
    n = np.cross(a.axis, b.axis)
    if np.linalg.norm(n) < PARALLEL_RAD:
        return tuple(_rulings(a, b))
    heights = _Heights(a, b, n)
    return tuple(Branch(heights, s_a, s_b) for s_a, s_b in _chained(heights))


@dataclass(frozen=True, eq=False)
class Ruling:
    """Where the plane curves of strips with parallel rulings cross: q is v."""

    strips: tuple[RuledStrip, RuledStrip]
    s_a: float
    s_b: float
    offset: float  # from gamma_a to gamma_b along z_a
    sign: float  # z_b = sign * z_a
    reach: float

    @property
    def nodes(self) -> FloatArray:
        """From one end of the ruling to the other."""
        return np.linspace(-self.reach, self.reach, 9)

    def at(self, q: FloatArray) -> IntersectionPoints:
        """Points on the ruling."""
        s_a, s_b = np.full(q.size, self.s_a), np.full(q.size, self.s_b)
        on_curves = self.strips[0].in_plane(s_a), self.strips[1].in_plane(s_b)
        return IntersectionPoints(s_a, s_b, q, self.sign * (q - self.offset), on_curves)


def _rulings(a: RuledStrip, b: RuledStrip) -> list[Ruling]:
    """Crossings of the two plane curves, both drawn in the plane of a."""
    sign = float(np.sign(a.axis @ b.axis))
    moved = Frame(a.frame.local(b.frame.origin), a.frame.axes @ b.frame.x_axis, a.frame.axes @ b.frame.y_axis)
    m = np.eye(3)
    m[:2] = np.column_stack([moved.x_axis[:2], moved.y_axis[:2], moved.origin[:2]])
    first, second = Spline(a.curve), Spline(b.curve.transformed(m))
    found = segment_crossings(first, second)
    offset = float(moved.origin[2])
    reach = a.width.extremes[1] + b.width.extremes[1] + abs(offset)
    x, y = np.array(found, dtype=float).reshape(-1, 2).T
    s_a = a.curve.arc_length(first.parameter(x)) * a.length / a.curve.length
    s_b = b.curve.arc_length(Spline(b.curve).parameter(y)) * b.length / b.curve.length
    return [Ruling((a, b), float(s), float(r), offset, sign, reach) for s, r in zip(s_a, s_b, strict=True)]


@dataclass(frozen=True, eq=False)
class _Heights:
    """The heights of both curves along n, and what follows from equal heights."""

    a: RuledStrip
    b: RuledStrip
    n: FloatArray

    @cached_property
    def up(self) -> FloatArray:
        """n brought to unit length."""
        return self.n / np.linalg.norm(self.n)

    def along(self, strip: RuledStrip, s: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Heights of one of the curves, from the origin of a's frame, and their slopes, (n,) each."""
        return self.above(strip, strip.in_plane(s))

    def above(self, strip: RuledStrip, places: InPlane) -> tuple[FloatArray, FloatArray]:
        """The same, for places on one of the curves."""
        across, base = self._ways[0 if strip is self.a else 1]
        position, tangent = places
        return position @ across + base, tangent @ across

    @cached_property
    def _ways(self) -> tuple[tuple[FloatArray, float], ...]:
        """How height grows along x and y of each frame, and the height of its origin."""
        origin = self.a.frame.origin
        return tuple(
            (strip.frame.axes[:2] @ self.up, float((strip.frame.origin - origin) @ self.up))
            for strip in (self.a, self.b)
        )

    def common(
        self, s_a: FloatArray, s_b: FloatArray, on_curves: tuple[InPlane, InPlane]
    ) -> IntersectionPoints:
        """v and u where the heights are equal: v z_a - u z_b leads from gamma_a to gamma_b."""
        gap = self.b.frame.point(on_curves[1][0]) - self.a.frame.point(on_curves[0][0])
        v, u = self._rulings @ gap.T
        return IntersectionPoints(s_a, s_b, v, u, on_curves)

    @cached_property
    def _rulings(self) -> FloatArray:
        """Rows (2, 3) whose products with the gap are v and u: the gap crossed with the other ruling, along n."""
        return np.cross([self.b.axis, self.a.axis], self.n) / (self.n @ self.n)


@dataclass(frozen=True, eq=False)
class Branch:
    """A connected part of the level set, drawn roughly by (s_a, s_b) at its nodes; q counts the nodes."""

    heights: _Heights
    s_a: FloatArray
    s_b: FloatArray

    @property
    def nodes(self) -> FloatArray:
        """0, 1, 2, ..."""
        return np.arange(self.s_a.size, dtype=float)

    def at(self, q: FloatArray) -> IntersectionPoints:
        """Newton's method across the level set, from between the nodes."""
        h = self.heights
        s_a, s_b = (np.interp(q, self.nodes, row) for row in (self.s_a, self.s_b))
        on_curves = h.a.in_plane(s_a), h.b.in_plane(s_b)
        tolerance = HEIGHT_ERROR * max(h.a.length, h.b.length)
        for _ in range(MOST_STEPS):
            (p, f), (r, g) = h.above(h.a, on_curves[0]), h.above(h.b, on_curves[1])
            gap = p - r
            if np.abs(gap).max(initial=0.0) <= tolerance:
                break
            step = gap / np.maximum(f**2 + g**2, LEAST_SQUARED_SLOPE)
            s_a, s_b = np.clip(s_a - step * f, 0.0, h.a.length), np.clip(s_b + step * g, 0.0, h.b.length)
            on_curves = h.a.in_plane(s_a), h.b.in_plane(s_b)
        return h.common(s_a, s_b, on_curves)


def _chained(heights: _Heights) -> list[tuple[FloatArray, FloatArray]]:
    """The level set as polylines (s_a, s_b), each as long as it goes."""
    first = _monotone(heights, heights.a)
    second = _monotone(heights, heights.b)
    pieces: list[tuple[FloatArray, FloatArray]] = []
    ends: list[list[tuple[str, int, int] | None]] = []
    level: list[tuple[FloatArray, FloatArray]] = []
    for k, (s_a, c_a) in enumerate(first):
        for m, (s_b, c_b) in enumerate(second):
            low, high = max(c_a.min(), c_b.min()), min(c_a.max(), c_b.max())
            if not low < high:
                level.extend(_level(s_a, c_a, s_b, c_b))
                continue
            inside = np.concatenate([c_a, c_b])
            room = SAME_HEIGHT * max(heights.a.length, heights.b.length)
            inside = np.sort(inside[(inside > low + room) & (inside < high - room)])
            c = np.concatenate([[low], inside[np.diff(inside, prepend=low) > room], [high]])
            pieces.append((_inverted(s_a, c_a, c), _inverted(s_b, c_b, c)))
            ends.append([_joint(k, c_a, m, c_b, bound) for bound in (low, high)])
    return [*level, *_joined(pieces, ends, len(first), len(second))]


def _level(
    s_a: FloatArray, c_a: FloatArray, s_b: FloatArray, c_b: FloatArray
) -> Iterator[tuple[FloatArray, FloatArray]]:
    """The way along a straight strip that keeps the height at which the other curve passes it."""
    if c_b[0] == c_b[-1] and c_a.min() < c_b[0] < c_a.max():
        yield np.repeat(_inverted(s_a, c_a, c_b[:1]), s_b.size), s_b
    if c_a[0] == c_a[-1] and c_b.min() < c_a[0] < c_b.max():
        yield s_a, np.repeat(_inverted(s_b, c_b, c_a[:1]), s_a.size)


def _monotone(heights: _Heights, strip: RuledStrip) -> list[tuple[FloatArray, FloatArray]]:
    """Stretches (s, height) between the places where the height turns."""
    s = strip.stations
    height, slope = heights.along(strip, s)
    if np.abs(slope).max() < LEVEL_SLOPE:
        return [(s, np.full(s.size, height.mean()))]
    turns = np.flatnonzero((slope[:-1] < 0) != (slope[1:] < 0))
    found = bracketed_zeros(
        lambda x: heights.along(strip, x)[1], s[turns], s[turns + 1], values=(slope[turns], slope[turns + 1])
    )
    top = heights.along(strip, found)[0]
    stretches = []
    stops = [-1, *turns.tolist(), s.size - 1]
    for i, (before, after) in enumerate(pairwise(stops)):
        row, c = s[before + 1 : after + 1], height[before + 1 : after + 1]
        if i > 0:
            row, c = np.append(found[i - 1], row), np.append(top[i - 1], c)
        if i < turns.size:
            row, c = np.append(row, found[i]), np.append(c, top[i])
        stretches.append((row, c))
    return stretches


def _inverted(s: FloatArray, c: FloatArray, at: FloatArray) -> FloatArray:
    """Arc lengths at given heights of a monotone stretch."""
    order = 1 if c[-1] > c[0] else -1
    return np.interp(at, c[::order], s[::order])


def _joint(k: int, c_a: FloatArray, m: int, c_b: FloatArray, bound: float) -> tuple[str, int, int] | None:
    """Which turn of which curve ends a piece at the height `bound`: the next piece goes on from there.

    Turns are counted as the stretches that begin with them.
    """
    as_a, as_b = bound in (c_a[0], c_a[-1]), bound in (c_b[0], c_b[-1])
    if as_a and as_b:
        return None  # the surfaces touch there: no way leads on
    if as_a:
        return "a", k if bound == c_a[0] else k + 1, m
    return "b", m if bound == c_b[0] else m + 1, k


def _joined(
    pieces: list[tuple[FloatArray, FloatArray]],
    ends: list[list[tuple[str, int, int] | None]],
    first: int,
    second: int,
) -> list[tuple[FloatArray, FloatArray]]:
    """Pieces that end at the same turn, put together."""
    counts = {"a": first, "b": second}
    homes: dict[tuple[str, int, int], list[int]] = {}
    for i, pair in enumerate(ends):
        for key in pair:
            if key is not None and 0 < key[1] < counts[key[0]]:
                homes.setdefault(key, []).append(i)
    left = set(range(len(pieces)))

    def grown(i: int, key: tuple[str, int, int] | None) -> list[tuple[FloatArray, FloatArray]]:
        """Pieces from the far end of the chain beyond `key` to it, in order towards piece i."""
        chain: list[tuple[FloatArray, FloatArray]] = []
        while key is not None:
            after = [j for j in homes.get(key, []) if j != i and j in left]
            if not after:
                break
            i = after[0]
            left.discard(i)
            s_a, s_b = pieces[i]
            way = 1 if ends[i][1] == key else -1
            chain.insert(0, (s_a[::way], s_b[::way]))
            key = ends[i][0 if way == 1 else 1]
        return chain

    chains = []
    while left:
        i = min(left)
        left.discard(i)
        before = grown(i, ends[i][0])
        after = [(s_a[::-1], s_b[::-1]) for s_a, s_b in reversed(grown(i, ends[i][1]))]
        rows = [*before, pieces[i], *after]
        chains.append(tuple(np.concatenate([rows[0][c], *(row[c][1:] for row in rows[1:])]) for c in (0, 1)))
    return [(s_a, s_b) for s_a, s_b in chains]
