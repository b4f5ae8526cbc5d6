"""Strokes of a text in pieces that keep apart, as of stencils, or go on in each other: few faces for a letter."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from math import atan2, dist
from typing import TypeAlias

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import InputError
from elastica_cad.geometry.boxes import box_about
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.segments import Arc, Line, Segment

Joints: TypeAlias = dict[tuple[int, int], float]
"""Of two segments, by number, the first of which ends where the second starts and goes on: the turn, rad."""

LEAST, STUB = 0.55, 0.38
"""Length of what is left of a piece beside others, in widths: of one of three widths or more a stub stays."""

LEAST_TURN = 1e-6
"""Arcs about one centre go on in each other within this, mm and rad."""

SMOOTH = 1e-9
"""Turn from one segment to the next, rad, that is none: ends of grooves must meet without slivers."""

SHARPEST_MITRE = 1.8
"""Turn, rad, up to which two lines meet in a mitre: a sharper one has a long tip."""

STATIONS = 200
"""Places along a piece at which it is asked whether it keeps off the others."""

SIDES = np.array([-0.5, -0.25, 0.0, 0.25, 0.5])
"""Across a piece, in widths."""


@dataclass(frozen=True)
class StencilPiece:
    """A line or an arc of a stroke, and how it goes on.

    Attributes
    ----------
    way : Line or Arc
        mm.
    turns : pair of float or None
        At its start and its end: None where it ends; else the turn to the left, rad, to the piece that goes on
        there, 0 where that is smooth.
    """

    way: Line | Arc
    turns: tuple[float | None, float | None] = (None, None)


def stencil_strokes(strokes: Sequence[Path], width: float, gap: float) -> list[StencilPiece]:
    """Lines and arcs that follow strokes of this width, and leave a gap wherever two touch that do not go on.

    Parameters
    ----------
    strokes : sequence of Path
        Those of `text_strokes`: lines and arcs, mm.
    width, gap : float
        mm.

    Returns
    -------
    list of StencilPiece
        What others would divide is left whole, and those end before it; crumbs are left out. Segments of a stroke
        that are tangent go on in each other, as do lines at no sharp corner.

    Examples
    --------
    >>> tee = [Path.polyline([(0, 6), (4, 6)]), Path.polyline([(2, 0), (2, 6)])]
    >>> [round(float(piece.way.length), 1) for piece in stencil_strokes(tee, 0.6, 0.2)]
    [4.0, 5.5]
    >>> [corner, _] = stencil_strokes([Path.polyline([(0, 6), (0, 0), (4, 0)])], 0.6, 0.2)
    >>> round(corner.turns[1], 4)
    1.5708
    """
    segments, joints = _segments(strokes, width)
    near = _neighbours(segments, 2 * (width + gap))
    others = [[i for i in rest if not {(k, i), (i, k)} & joints.keys()] for k, rest in enumerate(near)]
    left = [
        _long(_clear(one, [segments[i] for i in rest], width, gap), one, width)
        for one, rest in zip(segments, others, strict=True)
    ]
    shares = [
        sum(part.length for part in parts) / one.length for one, parts in zip(segments, left, strict=True)
    ]
    ranks = sorted(range(len(segments)), key=lambda i: (len(left[i]) == 1, shares[i]))
    kept: dict[int, list[Line | Arc]] = {}
    for rank in ranks:
        one = segments[rank]
        pieces = _clear(one, [piece for i in others[rank] for piece in kept.get(i, ())], width, gap)
        kept[rank] = [one] if pieces == [one] else _long(pieces, one, width)
    return _going_on(segments, joints, kept)


def _segments(strokes: Sequence[Path], width: float) -> tuple[list[Line | Arc], Joints]:
    """All segments, and which go on in each other."""
    segments: list[Line | Arc] = []
    joints: Joints = {}
    for stroke in strokes:
        mine = _in_one(list(_joined(stroke.segments)))
        first = len(segments)
        segments += mine
        for k, one in enumerate(mine):
            after = (k + 1) % len(mine)
            turn = _turn(one, mine[after], width) if len(mine) > 1 else None
            if turn is not None:
                joints[first + k, first + after] = turn
    return segments, joints


def _in_one(segments: list[Line | Arc]) -> list[Line | Arc]:
    """The segments of a closed stroke that is begun in the middle of an arc, with that arc as one."""
    first, last = segments[0], segments[-1]
    if len(segments) > 1 and isinstance(first, Arc) and isinstance(last, Arc) and _goes_on(last, first):
        return [_prolonged(last, first), *segments[1:-1]]
    return segments


def _turn(one: Line | Arc, after: Line | Arc, width: float) -> float | None:
    """The turn from a segment to that which follows, if grooves along them can go on in each other."""
    if not _same(one.end, after.start):
        return None
    (a, b), (c, d) = one.tangent_at(1.0).tolist(), after.tangent_at(0.0).tolist()
    turn = atan2(a * d - b * c, a * c + b * d)
    if abs(turn) < SMOOTH:
        return 0.0
    lines = isinstance(one, Line) and isinstance(after, Line)
    long = min(one.length, after.length) > width
    return turn if lines and long and abs(turn) < SHARPEST_MITRE else None


def _going_on(
    segments: Sequence[Line | Arc], joints: Joints, kept: dict[int, list[Line | Arc]]
) -> list[StencilPiece]:
    """What is kept, with the turns where both of two that go on in each other still reach their joint."""
    reached = {
        (one, after)
        for one, after in joints
        if any(_same(piece.end, segments[one].end) for piece in kept[one])
        and any(_same(piece.start, segments[after].start) for piece in kept[after])
    }
    before = {after: joints[one, after] for one, after in reached}
    following = {one: joints[one, after] for one, after in reached}
    found = []
    for number, pieces in kept.items():
        whole = segments[number]
        for piece in pieces:
            turns = (
                before.get(number) if _same(piece.start, whole.start) else None,
                following.get(number) if _same(piece.end, whole.end) else None,
            )
            found.append(StencilPiece(piece, turns))
    return found


def _same(a: FloatArray, b: FloatArray) -> bool:
    return dist(a, b) < LEAST_TURN


def _neighbours(segments: Sequence[Line | Arc], reach: float) -> list[list[int]]:
    """Of each segment the others that may lie within this reach: a long text has few of them near."""
    corners = np.array([_box(segment) for segment in segments]).reshape(-1, 2, 2)
    low, high = corners[:, 0], corners[:, 1]
    met: FloatArray = np.all((low[:, None] < high + reach) & (low < high[:, None] + reach), axis=2)
    np.fill_diagonal(met, False)
    return [np.flatnonzero(row).tolist() for row in met]


def _box(segment: Line | Arc) -> FloatArray:
    """Least and largest x and y of a line, or of the circle of an arc."""
    if isinstance(segment, Arc):
        return np.array([segment.center - segment.radius, segment.center + segment.radius])
    return box_about(np.array([segment.start, segment.end]))


def _long(pieces: Sequence[Line | Arc], whole: Line | Arc, width: float) -> list[Line | Arc]:
    """The pieces of a whole one that are no crumbs."""
    least = (STUB if whole.length > 3 * width else LEAST) * width
    return [piece for piece in pieces if piece.length > least]


def _joined(segments: Sequence[Segment]) -> Iterator[Line | Arc]:
    """Lines and arcs, those about one centre as one."""
    last: Line | Arc | None = None
    for segment in segments:
        if not isinstance(segment, Line | Arc):
            raise InputError("a stroke of a letter is made of lines and arcs: leave splines out")
        if isinstance(last, Arc) and isinstance(segment, Arc) and _goes_on(last, segment):
            last = _prolonged(last, segment)
            continue
        if last is not None:
            yield last
        last = segment
    if last is not None:
        yield last


def _prolonged(arc: Arc, by: Arc) -> Arc:
    return Arc(arc.center, arc.radius, arc.start_angle, arc.end_angle + by.sweep)


def _goes_on(a: Arc, b: Arc) -> bool:
    same = np.hypot(*(a.center - b.center)) + abs(a.radius - b.radius) < LEAST_TURN
    return bool(same and a.sweep * b.sweep > 0 and np.hypot(*(a.end - b.start)) < LEAST_TURN)


def _clear(segment: Line | Arc, others: Sequence[Line | Arc], width: float, gap: float) -> list[Line | Arc]:
    """The parts of a segment that keep off the others."""
    u = np.linspace(0.0, 1.0, STATIONS + 1)
    along = segment.tangent_at(u)
    left = np.column_stack([-along[:, 1], along[:, 0]])
    points = segment.at(u)[:, None] + SIDES[:, None] * width * left[:, None]
    free = np.ones(len(u), dtype=bool)
    for other in others:
        free &= ~_inside(points, other, width / 2 + gap, gap).any(axis=1)
    if free.all():
        return [segment]
    steps = np.flatnonzero(np.diff(np.concatenate([[False], free, [False]]).astype(int)))
    return [_part(segment, u[first], u[last - 1]) for first, last in steps.reshape(-1, 2) if last - first > 1]


def _inside(points: FloatArray, piece: Line | Arc, across: float, beyond: float) -> FloatArray:
    """Are points nearer to a piece than this across it, and beyond its ends?"""
    if isinstance(piece, Line):
        along = (piece.end - piece.start) / piece.length
        off = points - piece.start
        s, t = off @ along, off @ np.array([-along[1], along[0]])
    else:
        off = points - piece.center
        t = np.hypot(off[..., 0], off[..., 1]) - piece.radius
        turn = np.arctan2(off[..., 1], off[..., 0]) - piece.start_angle
        way = np.sign(piece.sweep)
        middle = abs(piece.sweep) / 2
        s = ((way * turn - middle + np.pi) % (2 * np.pi) - np.pi + middle) * piece.radius
    return np.asarray((np.abs(t) < across) & (s > -beyond) & (s < piece.length + beyond))


def _part(segment: Line | Arc, first: float, last: float) -> Line | Arc:
    if isinstance(segment, Line):
        return Line(segment.at(first), segment.at(last))
    start, sweep = segment.start_angle, segment.sweep
    return Arc(segment.center, segment.radius, start + first * sweep, start + last * sweep)
