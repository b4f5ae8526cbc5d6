"""Strokes of a text in pieces that keep apart, as of stencils: engraved bodies then have few faces."""

from collections.abc import Iterator, Sequence

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import InputError
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.segments import Arc, Line, Segment

LEAST, STUB = 0.55, 0.38
"""Length of what is left of a piece beside others, in widths: of one of three widths or more a stub stays."""

LEAST_TURN = 1e-6
"""Arcs about one centre go on in each other within this, mm and rad."""

STATIONS = 200
"""Places along a piece at which it is asked whether it keeps off the others."""

SIDES = np.array([-0.5, -0.25, 0.0, 0.25, 0.5])
"""Across a piece, in widths."""


def stencil_strokes(strokes: Sequence[Path], width: float, gap: float) -> list[Line | Arc]:
    """Lines and arcs that follow strokes of this width and leave a gap wherever two would touch.

    Parameters
    ----------
    strokes : sequence of Path
        Those of `text_strokes`: lines and arcs, mm.
    width, gap : float
        mm.

    Returns
    -------
    list of Line and Arc
        What others would divide is left whole, and those end before it; crumbs are left out.

    Examples
    --------
    >>> tee = [Path.polyline([(0, 6), (4, 6)]), Path.polyline([(2, 0), (2, 6)])]
    >>> [round(float(piece.length), 1) for piece in stencil_strokes(tee, 0.6, 0.2)]
    [4.0, 5.5]
    """
    segments = [segment for stroke in strokes for segment in _joined(stroke.segments)]
    near = _neighbours(segments, 2 * (width + gap))
    left = [
        _long(_clear(one, [segments[i] for i in rest], width, gap), one, width)
        for one, rest in zip(segments, near, strict=True)
    ]
    shares = [
        sum(part.length for part in parts) / one.length for one, parts in zip(segments, left, strict=True)
    ]
    ranks = sorted(range(len(segments)), key=lambda i: (len(left[i]) == 1, shares[i]))
    kept: dict[int, list[Line | Arc]] = {}
    for rank in ranks:
        one = segments[rank]
        pieces = _clear(one, [piece for i in near[rank] for piece in kept.get(i, ())], width, gap)
        kept[rank] = [one] if pieces == [one] else _long(pieces, one, width)
    return [piece for pieces in kept.values() for piece in pieces]


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
    ends = np.array([segment.start, segment.end])
    return np.array([ends.min(axis=0), ends.max(axis=0)])


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
            last = Arc(last.center, last.radius, last.start_angle, last.end_angle + segment.sweep)
            continue
        if last is not None:
            yield last
        last = segment
    if last is not None:
        yield last


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
