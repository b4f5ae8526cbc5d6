"""Slots cut into the outline of a flat pattern: the loop is opened exactly where each slot meets its edge."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import InputError
from elastica_cad.fabrication.slots.slot import Slot, slot_cut
from elastica_cad.geometry.boxes import box_about, boxes_meet
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.path_intersections import Chords, chord_crossings, polylines_cross
from elastica_cad.geometry.paths.profile import Profile
from elastica_cad.geometry.paths.segments import Segment, place, trim_segment

FLAT_MM = 1e-3
"""Of the polylines by which loops are told apart: less than any machine resolves."""

SAME_POINT_MM = 1e-9
"""Points nearer than this are one: rounding of sizes up to some metres."""

SAME_PARAMETER = 1e-6
"""Places of a segment nearer than this may be one; their distance decides."""

REACHES = (1.0, 4.0, 16.0)
"""In widths of the slot: how far its sides are drawn on, until they meet the edge."""


@dataclass(frozen=True)
class _Place:
    """A place on a chain: segment and its u in [0, 1]."""

    segment: int
    u: float


@dataclass(frozen=True, eq=False)
class _Opening:
    """Where a slot's cut leaves the outline, where it comes back, the cut between, and points along it."""

    slot: Slot
    out: _Place
    back: _Place
    cut: tuple[Segment, ...]
    points: FloatArray


def cut_slots(
    outline: Path, holes: Sequence[Path], slots: Sequence[Slot], width: Profile, *, name: str = "strip"
) -> Path:
    """The outline with its slots.

    Parameters
    ----------
    outline, holes : Path
        Closed loops of the flat pattern, the outline anticlockwise.
    slots : sequence of Slot
    width : Profile
        Full width of the strip.
    name : str
        What messages call the part.

    Raises
    ------
    InputError
        A slot that does not open at the edge, cuts the strip through, or meets a hole or another slot.
    """
    if not slots:
        return outline
    edge = _Edge(outline)
    openings = sorted(
        (edge.opening(slot, width, name) for slot in slots), key=lambda o: (o.out.segment, o.out.u)
    )
    _refuse_meetings(openings, holes, name)
    for before, after in zip(openings, [*openings[1:], openings[0]], strict=True):
        wraps = after is openings[0]
        if not wraps and (after.out.segment, after.out.u) < (before.back.segment, before.back.u):
            raise InputError(_meeting(name, before.slot, after.slot))
    return Path(edge.spliced(openings), closed=True)


class _Edge:
    """The outline, ready to be crossed by many slots."""

    def __init__(self, outline: Path) -> None:
        self.segments = outline.segments
        self.chords = [Chords.of(segment) for segment in self.segments]
        begins, ends = (
            np.concatenate([c.points[part] for c in self.chords]) for part in (slice(-1), slice(1, None))
        )
        self.low, self.high = np.minimum(begins, ends) - FLAT_MM, np.maximum(begins, ends) + FLAT_MM
        self.owner = np.repeat(np.arange(len(self.chords)), [len(c.points) - 1 for c in self.chords])

    def opening(self, slot: Slot, width: Profile, name: str) -> _Opening:
        """Where the slot meets the edge; its sides are drawn on until they do."""
        crossings: list[tuple[_Place, _Place]] = []
        chords: list[Chords] = []
        for reach in REACHES:
            chords = [Chords.of(part) for part in slot_cut(slot, width, beyond=reach * slot.width).segments]
            crossings = self._crossings(chords)
            if len(crossings) > 1:
                break
        if len(crossings) != 2:
            low, high = float(self.low[:, 0].min()), float(self.high[:, 0].max())
            if not low < slot.at < high:
                raise InputError(
                    f"{name}: the slot at {slot.at:.6g} mm is not on the strip, which goes from {low:.4g} to "
                    f"{high:.4g} mm with its tabs: move it"
                )
            fault = "does not open at the edge" if len(crossings) < 2 else "cuts through to another edge"
            raise InputError(
                f"{name}: the slot at {slot.at:.6g} mm {fault}: make it "
                f"{'deeper' if len(crossings) < 2 else 'shallower or narrower'} or move it"
            )
        (first, a), (second, b) = sorted(crossings, key=lambda pair: (pair[1].segment, pair[1].u))
        points = np.concatenate([c.points for c in chords[a.segment : b.segment + 1]])
        cut = _between([c.segment for c in chords], a, b)
        return _Opening(slot, first, second, tuple(cut), points)

    def _crossings(self, cut: Sequence[Chords]) -> list[tuple[_Place, _Place]]:
        found: list[tuple[_Place, _Place]] = []
        for k, chords in enumerate(cut):
            low, high = chords.points.min(axis=0) - FLAT_MM, chords.points.max(axis=0) + FLAT_MM
            near = ((self.low <= high) & (self.high >= low)).all(axis=1)
            # chords of a segment follow one another
            for i in dict.fromkeys(self.owner[near].tolist()):
                for u, v in chord_crossings(self.chords[i], chords):
                    point = chords.segment.at(v)
                    if all(
                        np.hypot(*(cut[p.segment].segment.at(p.u) - point)) > SAME_POINT_MM for _, p in found
                    ):
                        found.append((_Place(i, u), _Place(k, v)))
        return found

    def spliced(self, openings: Sequence[_Opening]) -> list[Segment]:
        """The whole loop: edge from the end of each slot to the start of the next, then that slot's cut."""
        chain: list[Segment] = []
        for before, after in zip([openings[-1], *openings[:-1]], openings, strict=True):
            chain += _between(self.segments, before.back, after.out)
            chain += after.cut
        return chain


def _between(chain: Sequence[Segment], start: _Place, end: _Place) -> list[Segment]:
    """The part of a chain from one place on to another, past its end and on from its start if need be."""
    if start.segment == end.segment and start.u <= end.u:
        return _piece(chain[start.segment], start.u, end.u)
    following = range(start.segment + 1, end.segment + (len(chain) if end.segment <= start.segment else 0))
    middle = [chain[i % len(chain)] for i in following]
    return [*_piece(chain[start.segment], start.u, 1.0), *middle, *_piece(chain[end.segment], 0.0, end.u)]


def _piece(segment: Segment, u0: float, u1: float) -> list[Segment]:
    """The segment between two parameters; nothing where they differ by rounding only."""
    if u1 - u0 < SAME_PARAMETER and np.hypot(*(segment.at(u1) - segment.at(u0))) < SAME_POINT_MM:
        return []
    return [trim_segment(segment, u0, u1)]


def _refuse_meetings(openings: Sequence[_Opening], holes: Sequence[Path], name: str) -> None:
    cuts = [opening.points for opening in openings]
    boxes = [box_about(cut) for cut in cuts]
    for i, opening in enumerate(openings):
        for j in range(i):
            if not boxes_meet(boxes[i], boxes[j]):
                continue
            if polylines_cross(cuts[i], cuts[j]) is not None:
                raise InputError(_meeting(name, openings[j].slot, opening.slot))
        for hole in holes:
            if not boxes_meet(boxes[i], hole.bounds):
                continue
            loop = hole.points(FLAT_MM)
            at = polylines_cross(cuts[i], np.concatenate([loop, loop[:1]]))
            if at is not None:
                raise InputError(
                    f"{name}: the slot at {opening.slot.at:.6g} mm meets a hole at {place(at)}: "
                    "move one of them"
                )


def _meeting(name: str, a: Slot, b: Slot) -> str:
    return (
        f"{name}: the slots at {a.at:.6g} mm and {b.at:.6g} mm meet: move them apart, or make "
        "them narrower or shallower"
    )
