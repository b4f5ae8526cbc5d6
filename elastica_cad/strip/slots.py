"""Slots of interlocking strips, and positions of engraved texts clear of slots and holes."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import islice, pairwise, product
from operator import attrgetter, itemgetter
from typing import Annotated, Literal, TypeAlias

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import numbers
from elastica_cad.declared import Option, require_declared
from elastica_cad.errors import BareLength, InputError, Length, note
from elastica_cad.geometry.path import Arc, Line, Path, Segment, Spline, trim_segment
from elastica_cad.geometry.path_intersections import Chords, chord_crossings, encloses, polylines_cross
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.geometry.plane_points import (
    box_about,
    boxes_meet,
    left_of,
    lengths_along,
    norm,
    place,
    rotated,
)
from elastica_cad.geometry.profile import Profile
from elastica_cad.geometry.splines import spline_through
from elastica_cad.strip.drawing import ENGRAVE, MARK
from elastica_cad.strip.lettering import (
    LABEL_MM,
    LABEL_SHARE,
    LEAST_LABEL_MM,
    Text,
    centred_text,
    engravable,
    fit_label,
    text_span,
    text_width,
)

Side = Literal["upper", "lower"]
Relief = Literal["square", "round"]


def _center_line(path: object, widths: object, here: str) -> tuple[FloatArray, FloatArray]:
    rows, across = numbers(path, f"{here}: path"), numbers(widths, f"{here}: widths")
    if rows.ndim != 2 or rows.shape[1] != 2 or len(rows) < 2 or across.shape != (len(rows),):
        raise InputError(
            f"{here}: path and widths do not match; give two or more rows (x, y), and a width for each row"
        )
    return rows, across


@dataclass(frozen=True, eq=False)
class Slot:
    """Slot that begins inside a strip and opens at an edge of the strip.

    Parameters
    ----------
    at : float
        Arc length of the strip, mm, at the inner end of the slot's centre line.
    width : float
        Width of the slot, mm. If the slot follows a `path`, its width at the inner end.
    depth : float, optional
        Distance across the strip from its edge to the inner end of the slot, mm; by default to the centre line of
        the strip.
    side : "upper" or "lower"
        Edge of the flat pattern at which the slot opens: y > 0 or y < 0.
    lean : float
        Angle between the slot's centre line and the direction across the strip, rad. If `lean` is positive, x
        increases from the inner end to the edge. In `elastica_cad.build123d` and `elastica_cad.cadquery`, `lean`
        is in degrees.
    relief : "square" or "round"
        Shape of the inner end. A round end is a semicircle that extends beyond `depth`.
    mate : str
        Name of the part that is inserted in the slot, engraved beside it.
    path : (k, 2) array, optional
        Points of the slot's centre line in the flat pattern, from the inner end to the edge, mm. `path` replaces
        `depth` and `lean`.
    widths : (k,) array, optional
        Width at every point of `path`, mm.

    Examples
    --------
    >>> Slot(40.0, width=1.2, depth=5.0, side="lower").mirrored().side
    'upper'
    """

    at: Annotated[float, Option("Place along the strip.", "mm")]
    width: Annotated[float, Option("Width of the slot.", "mm", above=0)]
    depth: Annotated[
        float | None, Option("Depth from the edge; by default to the centre line.", "mm", above=0)
    ] = None
    side: Annotated[Side, Option("Edge at which the slot opens.")] = "upper"
    lean: Annotated[float, Option("Angle to the direction across the strip.", "rad")] = 0.0
    relief: Annotated[Relief, Option("Shape of the inner end.")] = "square"
    mate: Annotated[str, Option("Name of the inserted part, engraved beside the slot.")] = ""
    path: FloatArray | None = None
    widths: FloatArray | None = None

    def __post_init__(self) -> None:
        require_declared(Slot, vars(self), "slot")
        here = note("slot at {at}", at=Length(self.at))
        # a lean in degrees is accepted here: see `require_rad`
        if abs(self.lean) >= 90.0:
            raise InputError(
                f"{here}: lean (the angle of the slot) is {self.lean:g}; give less than a quarter turn"
            )
        if (self.path is None) != (self.widths is None):
            raise InputError(f"{here}: path or widths are missing; give both")
        if self.path is not None:
            path, widths = (array.copy() for array in _center_line(self.path, self.widths, here))
            if not np.isfinite(path).all() or not (widths > 0).all():
                raise InputError(
                    f"{here}: path or widths cannot be used; give finite numbers in mm, and positive widths"
                )
            for name, array in (("path", path), ("widths", widths)):
                array.setflags(write=False)
                object.__setattr__(self, name, array)

    @classmethod
    def along(
        cls, path: ArrayLike, widths: ArrayLike, *, side: Side, relief: Relief = "square", mate: str = ""
    ) -> "Slot":
        """Return a slot with the centre line `path` (k, 2) from inner end to edge, and `widths` (k,), mm."""
        rows, across = _center_line(path, widths, "slot along a path")
        return cls(
            float(rows[0, 0]), float(across[0]), side=side, relief=relief, mate=mate, path=rows, widths=across
        )

    def require_rad(self) -> None:
        """Raise InputError for an inclination of 90 degrees or more, which was probably given in degrees."""
        if abs(self.lean) >= np.pi / 2:
            raise InputError(
                "The lean of the slot {at} from the start is {lean:g} rad, a quarter turn or more. Pass "
                "radians, such as numpy.radians({lean:g}).",
                at=Length(self.at),
                lean=self.lean,
            )

    def mirrored(self) -> "Slot":
        """Return the slot of the strip turned over about its centre line (y to -y)."""
        path = None if self.path is None else self.path * (1.0, -1.0)
        return replace(self, side="lower" if self.side == "upper" else "upper", path=path)

    def center_line(self, width: Profile) -> tuple[FloatArray, FloatArray]:
        """Return points (k, 2) of the centre line from inner end to edge, and widths of the slot (k,), mm.

        `width` is the width of the strip.
        """
        if self.path is not None and self.widths is not None:
            return self.path, self.widths
        sign = 1.0 if self.side == "upper" else -1.0
        half = float(width(np.clip(self.at, 0.0, width.length))) / 2
        depth = half if self.depth is None else self.depth
        outward = np.array([np.sin(self.lean), sign * np.cos(self.lean)])
        inner = np.array([self.at, sign * (half - depth)])
        return np.array([inner, inner + outward * depth / np.cos(self.lean)]), np.full(2, self.width)


def slot_cut(slot: Slot, width: Profile, *, beyond: float) -> Path:
    """Return the cut of a slot as an open path: from outside the edge around the inner end and back.

    Parameters
    ----------
    slot : Slot
    width : Profile
        Full width of the strip.
    beyond : float
        Length of the straight extension of the sides beyond the end of the centre line, mm.
    """
    points, widths = slot.center_line(width)
    t = lengths_along(points)
    degree = min(3, len(points) - 1)
    tangents = spline_through(t, points, degree)(t, 1)
    aside = (widths / 2 / norm(tangents))[:, None] * left_of(tangents)
    both = points - aside, points + aside  # seen from the inner end, the right and the left side
    sides = spline_through(t, np.hstack(both), degree)
    right, left = (
        _side(side, sides.knots, controls, beyond)
        for side, controls in zip(both, np.hsplit(sides.coefficients, 2), strict=True)
    )
    first, last = both[0][0], both[1][0]
    end = Arc.from_bulge(first, last, -1.0) if slot.relief == "round" else Line(first, last)
    return Path([*(segment.reversed() for segment in reversed(right)), end, *left])


def _side(points: FloatArray, knots: FloatArray, controls: FloatArray, beyond: float) -> list[Segment]:
    """Return a side of a slot through `points` (n, 2), mm, from its inner end to `beyond` mm outside the edge."""
    chord = points[-1] - points[0]
    off = (points - points[0]) @ left_of(chord) / norm(chord)
    # such a side is drawn as a line
    straight = len(points) == 2 or np.abs(off).max() < 1e-7
    if not straight and len(points) < 4:
        raise InputError("a bent slot has too few points along its centre line: give four or more")
    ahead = chord if straight else controls[-1] - controls[-2]
    onward = points[-1] + ahead * beyond / norm(ahead)
    if straight:
        return [Line(points[0], onward)]
    return [Spline(PlaneCurve(knots, controls, 3)), Line(points[-1], onward)]


FLAT_MM = 1e-3
"""Chord error, mm, of the polylines that are tested for crossings. Cutting machines have larger errors."""

SAME_POINT_MM = 1e-9

_Place: TypeAlias = tuple[int, float]
"""Index of a segment in a chain, and a parameter on it."""


@dataclass(frozen=True, eq=False)
class _Opening:
    """Opening of a slot in the outline.

    The cut leaves the outline at `out` and returns to it at `back`. `cut` are its segments in between, and `points`
    (k, 2), mm, are points along them.
    """

    slot: Slot
    out: _Place
    back: _Place
    cut: tuple[Segment, ...]
    points: FloatArray


def cut_slots(
    outline: Path, holes: Sequence[Path], slots: Sequence[Slot], width: Profile, *, name: str
) -> Path:
    """Return the outline with its slots.

    Parameters
    ----------
    outline, holes : Path
        Closed loops of the flat pattern, the outline anticlockwise.
    slots : sequence of Slot
    width : Profile
        Full width of the strip.
    name : str
        Name of the part in messages, or "".
    """
    if not slots:
        return outline
    edge = _Edge(outline)
    try:
        openings = sorted((edge.opening(slot, width) for slot in slots), key=attrgetter("out"))
        _refuse_meetings(openings, holes)
        # openings are in the order of the outline, so the next cut must begin after this cut has returned
        for before, after in pairwise(openings):
            if after.out < before.back:
                raise InputError(_meeting(before.slot, after.slot))
    except InputError as problem:
        raise problem.at(strip=name) from None
    chain: list[Segment] = []
    # the part of the outline before each opening, and the cut
    for before, after in zip([openings[-1], *openings[:-1]], openings, strict=True):
        chain += [*_between(outline.segments, before.back, after.out), *after.cut]
    return Path(chain, closed=True)


class _Edge:
    """Edge of a strip at which slots open, as chords with their boxes for fast comparison.

    `chords` has the polyline of each segment. `low` and `high` (m, 2) are the corners of the boxes of all m chords,
    and `owner` (m,) is the index of the segment of each chord.
    """

    def __init__(self, outline: Path) -> None:
        self.chords = [Chords.of(segment) for segment in outline.segments]
        begins, ends = (
            np.concatenate([c.points[part] for c in self.chords]) for part in (slice(-1), slice(1, None))
        )
        self.low, self.high = np.minimum(begins, ends) - FLAT_MM, np.maximum(begins, ends) + FLAT_MM
        self.owner = np.arange(len(self.chords)).repeat([len(c.points) - 1 for c in self.chords])

    def opening(self, slot: Slot, width: Profile) -> _Opening:
        """Return where a slot opens at the edge, extended beyond it until both its sides meet the edge."""
        crossings: list[tuple[_Place, _Place]] = []
        chords: list[Chords] = []
        # multiples of the slot's width; a slot that is not perpendicular to the edge needs a longer extension
        for reach in (1.0, 4.0, 16.0):
            chords = [Chords.of(part) for part in slot_cut(slot, width, beyond=reach * slot.width).segments]
            crossings = self._crossings(chords)
            if len(crossings) > 1:
                break
        if len(crossings) != 2:
            low, high = float(self.low[:, 0].min()), float(self.high[:, 0].max())
            if not low < slot.at < high:
                raise InputError(
                    "the slot {at:.6g} from the start is not on the strip, which extends with its tabs from "
                    "{low:.4g} to {high:.4g}: move the slot",
                    at=Length(slot.at),
                    low=BareLength(low),
                    high=Length(high),
                )
            raise InputError(
                "the slot at {at} does not open at the edge: make it deeper or move it"
                if len(crossings) < 2
                else "the slot at {at} cuts through to another edge: make it shallower or narrower or move it",
                at=Length(slot.at),
            )
        # in the order of the cut; `a` and `b` are the places of the two crossings on the cut
        (first, a), (second, b) = sorted(crossings, key=itemgetter(1))
        points = np.concatenate([c.points for c in chords[a[0] : b[0] + 1]])
        return _Opening(slot, first, second, tuple(_between([c.segment for c in chords], a, b)), points)

    def _crossings(self, cut: Sequence[Chords]) -> list[tuple[_Place, _Place]]:
        """Return the pairs (place on the edge, place on the cut) at which they cross, each once."""
        crossings: list[tuple[_Place, _Place]] = []
        for k, chords in enumerate(cut):
            low, high = chords.points.min(axis=0) - FLAT_MM, chords.points.max(axis=0) + FLAT_MM
            near = ((self.low <= high) & (self.high >= low)).all(axis=1)
            for i in dict.fromkeys(self.owner[near].tolist()):
                for u, v in chord_crossings(self.chords[i], chords):
                    point = chords.segment.at(v)
                    known = (cut[j].segment.at(w) for _, (j, w) in crossings)
                    if all(norm(other - point) > SAME_POINT_MM for other in known):
                        crossings.append(((i, u), (k, v)))
        return crossings


def _between(chain: Sequence[Segment], start: _Place, end: _Place) -> list[Segment]:
    # return the part of a chain between two places. If `end` is before `start`, it passes the chain's end
    (i, u), (j, v) = start, end
    if i == j and u <= v:
        return _piece(chain[i], u, v)
    middle = [chain[k % len(chain)] for k in range(i + 1, j + (len(chain) if j <= i else 0))]
    return [*_piece(chain[i], u, 1.0), *middle, *_piece(chain[j], 0.0, v)]


def _piece(segment: Segment, u0: float, u1: float) -> list[Segment]:
    # return the part of a segment between two parameters, from 0 to 1, or nothing if it is a point
    if u1 - u0 < 1e-6 and norm(segment.at(u1) - segment.at(u0)) < SAME_POINT_MM:
        return []
    return [trim_segment(segment, u0, u1)]


def _refuse_meetings(openings: Sequence[_Opening], holes: Sequence[Path]) -> None:
    """Refuse slots that meet each other or a hole."""
    cuts = [opening.points for opening in openings]
    boxes = [box_about(cut) for cut in cuts]
    for i, opening in enumerate(openings):
        for j in range(i):
            if boxes_meet(boxes[i], boxes[j]) and polylines_cross(cuts[i], cuts[j]) is not None:
                raise InputError(_meeting(openings[j].slot, opening.slot))
        for hole in holes:
            if not boxes_meet(boxes[i], hole.bounds):
                continue
            at = polylines_cross(cuts[i], hole.closed_points(FLAT_MM))
            if at is not None:
                raise InputError(
                    "the slot {at:.6g} from the start meets a hole at {at_2}: move one of them",
                    at=Length(opening.slot.at),
                    at_2=place(at),
                )


def _meeting(a: Slot, b: Slot) -> str:
    return note(
        "the slots {one} and {other} from the start touch: move them apart, or make them narrower or shallower",
        one=Length(a.at), other=Length(b.at),
    )  # fmt: skip


TEXT_DISTANCE_MM = 0.5
"""Distance of letters from every cut, mm, because a stroke at an edge would act as a notch."""


def _text_box(text: Text, distance: float = TEXT_DISTANCE_MM) -> FloatArray:
    """Return the corners (4, 2) of the box around a text, anticlockwise, enlarged by `distance`, mm."""
    long = text.length
    low, high = text_span(text.text, text.height)
    flat = np.array([[0, low], [long, low], [long, high], [0, high]])
    flat = flat + distance * np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
    return text.position + rotated(flat, text.angle)


class Cut:
    """Line that engraved letters avoid.

    `gone` is the side of a closed line on which there is no material: "inside" or "outside".
    """

    def __init__(self, line: Path, gone: str = "") -> None:
        self.line, self.gone = line, gone

    @cached_property
    def points(self) -> FloatArray:
        """Points (k, 2) along the line; for a loop the first point is repeated at the end."""
        # this chord error is small compared with `TEXT_DISTANCE_MM`
        points = self.line.points(0.02)
        return np.concatenate([points, points[:1]]) if self.gone or self.line.closed else points

    def reaches(self, box: FloatArray, edge: FloatArray) -> bool:
        """Return True if this cut line crosses a box (4, 2), or if there is no material in the box.

        `edge` (5, 2) is the closed polyline around the box.
        """
        low, high = box_about(box)
        if np.any(np.all((self.points > low) & (self.points < high), axis=1)):
            return True
        if polylines_cross(edge, self.points) is not None:
            return True
        return bool(self.gone) and encloses(self.points, box[0]) == (self.gone == "inside")


class Cuts:
    """Cuts and lines that letters avoid: holes, slots, marks, and the outline."""

    def __init__(
        self,
        holes: Sequence[Path] = (),
        lines: Sequence[Path] = (),
        *,
        rim: Cut | None = None,
        slots: Sequence[Cut] = (),
    ) -> None:
        self._rim = rim
        self._cuts = [*slots] if rim is None else [rim, *slots]
        self._cuts += [Cut(hole, "inside") for hole in holes]
        self._cuts += [Cut(line) for line in lines]
        self._bounds = np.array([cut.line.bounds for cut in self._cuts]).reshape(-1, 2, 2)

    def clear_of(self, box: FloatArray) -> bool:
        """Return True if a box (4, 2) is clear of all cuts and lines."""
        bounds = box_about(box)
        if self._rim and not boxes_meet(self._rim.line.bounds, bounds):
            return False
        edge = np.concatenate([box, box[:1]])
        met = np.flatnonzero(boxes_meet(self._bounds, bounds)).tolist()
        return not any(self._cuts[k].reaches(box, edge) for k in met)


LETTER_HEIGHTS_MM = (2.0, 1.5, 1.0)
"""Heights of letters, mm, in the order in which they are tried. Engraved letters below 1 mm are not legible."""

LABEL_SHARES = (1.0, 0.7, 0.5, 0.35, 0.25)
"""Heights of a label, as fractions of the usual height, in the order in which they are tried."""

LABEL_DISTANCES_MM = (TEXT_DISTANCE_MM, 0.0)
"""Distances of a label from cuts, mm, in the order in which they are tried. A label on a very narrow strip
may touch a cut."""


def mating_marks(
    slots: Sequence[tuple[Slot, Cut]],
    width: Profile,
    holes: Sequence[Path],
    marks: Sequence[Path],
    taken: Sequence[Text],
) -> tuple[Text, ...]:
    """Return the names of the inserted parts, engraved at their slots, clear of cuts, `marks` and other texts.

    A name is at the inner end of its slot or beside the slot, as large as possible. A name that does not
    fit is omitted. If equal parts go into all slots, their name is engraved once. `slots` has each slot with its
    cut line, and `taken` are the texts that are there already.
    """
    cuts = Cuts(holes, marks, slots=[rim for _, rim in slots])
    boxes = [box_about(_text_box(text)) for text in taken]
    texts = list[Text]()
    alike = len({slot.mate for slot, _ in slots}) == 1
    for slot, rim in slots:
        if texts and alike:
            break
        for text in _choices(slot, rim.points, width) if slot.mate else ():
            box = _text_box(text)
            if _clear(box, width, boxes, cuts):
                texts.append(text)
                boxes.append(box_about(box))
                break
    return tuple(texts)


def end_numbers(
    width: Profile, cuts: Cuts, taken: Sequence[Text], names: tuple[str, str] = ("1", "2")
) -> tuple[Text, ...]:
    """Return the texts "1" and "2" at the start and end of the bent part, clear of cuts and texts.

    The slots that hold the ends have the same numbers. `names` replaces the texts, for example at joints.
    Empty names, and names that do not fit, are omitted.
    """
    boxes, numbers = [box_about(_text_box(text)) for text in taken], []
    for number, end, direction in ((names[0], 0.0, 1.0), (names[1], width.length, -1.0)):
        # at these distances from the end, mm, holders do not cover the number
        for height, off in product(LETTER_HEIGHTS_MM, (2.0, 4.0, 7.0, 11.0)) if number else ():
            long = text_width(number, height)
            x = end + direction * (off + max(height, long) / 2) - long / 2
            text = Text((x, -height / 2), number, height, layer=ENGRAVE)
            if _clear(_text_box(text), width, boxes, cuts):
                numbers.append(text)
                break
    return tuple(numbers)


def label_off_cuts(
    label: str, width: Profile, cuts: Cuts, span: tuple[float, float] | None = None
) -> tuple[Text, ...]:
    """Return the label on the centre line of a strip, as large as possible and clear of all cuts.

    Of places for equally large letters, the nearest to the middle is chosen. The label is omitted if no place is
    clear for letters of `LEAST_LABEL_MM`. `span` is the allowed range along the strip, mm; by default the whole
    bent part.
    """
    low, high = span or (0.0, width.length)
    # places are at least 2 mm apart, at most 100 on each side of the middle
    step = max(2.0, (high - low) / 2 / 100)
    steps = step * np.arange(1, max(int((high - low) / 2 / step), 1))
    places = (low + high) / 2 + np.append(0.0, np.column_stack([steps, -steps]))
    along = max(text_width(engravable(label), 1.0), 1e-9)
    largest = np.minimum(LABEL_SHARE * width(places), min(LABEL_MM, 0.8 * (high - low) / along))
    heights = np.outer(LABEL_SHARES, largest).ravel()
    # `heights` has all places for each fraction in turn; the largest come first, rounded to 0.1 mm
    order = [int(k) for k in (-heights.round(1)).argsort(kind="stable") if heights[k] >= LEAST_LABEL_MM]
    tried = (
        (centred_text(label, (float(places[k % places.size]), 0.0), float(heights[k]), np.inf), near)
        for near in LABEL_DISTANCES_MM
        for k in order
    )
    clear = (text for text, near in tried if _clear(_text_box(text, near), width, (), cuts))
    return tuple(islice(clear, 1))


def label_on_tabs(label: str, tabs: Sequence[tuple[float, float, float]], cuts: Cuts) -> Text:
    """Return the label across one of the `tabs` (start x, end x and width, mm), clear of all cuts.

    If necessary, the label is smaller or beside the middle of the tab. If no position is clear, the label is in
    the middle of the first tab.
    """

    def text(tab: tuple[float, float, float], share: float, place: float, side: float) -> Text:
        low, high, wide = tab
        across = 2 * min(place, 1 - place) * (high - low)
        center = (low + place * (high - low), side * wide / 4)
        room = wide / 2 if side else wide
        return fit_label(label, center, angle=np.pi / 2, room=share * room, across=share * across)

    places = ((0.5, 0.0), (0.5, 1.0), (0.5, -1.0), (0.25, 0.0), (0.75, 0.0))
    tried = (
        (text(tab, share, *at), near)
        for near in LABEL_DISTANCES_MM
        for share in LABEL_SHARES
        for tab in tabs
        for at in places
    )
    clear = (candidate for candidate, near in tried if cuts.clear_of(_text_box(candidate, near)))
    return next(clear, text(tabs[0], 1.0, 0.5, 0.0))


def _clear(box: FloatArray, width: Profile, taken: Sequence[FloatArray], cuts: Cuts) -> bool:
    # return True if a box (4, 2) is on the bent part, clear of all cuts and of the bounds `taken` of texts
    bounds = box_about(box)
    x = np.linspace(bounds[0, 0], bounds[1, 0], 9)
    if x[0] < 0 or x[-1] > width.length or np.abs(bounds[:, 1]).max() >= width(x).min() / 2:
        return False
    return not (taken and boxes_meet(np.array(taken), bounds).any()) and cuts.clear_of(box)


def _choices(slot: Slot, cut: FloatArray, width: Profile) -> Iterator[Text]:
    """Yield texts with the name of the other strip, large letters first, beyond and beside the slot."""
    points, _ = slot.center_line(width)
    inward = -1.0 if slot.side == "upper" else 1.0
    end = cut[:, 1].min() if inward < 0 else cut[:, 1].max()
    inside = np.abs(cut[:, 1]) < float(width(np.clip(slot.at, 0.0, width.length))) / 2
    low, high = cut[inside, 0].min(), cut[inside, 0].max()
    middle, mate = points[:, 1].mean(), engravable(slot.mate)
    for height in LETTER_HEIGHTS_MM:
        long, room = text_width(mate, height), TEXT_DISTANCE_MM + height / 2
        for x, y in (
            (points[0, 0], end + inward * 1.5 * room),
            (high + TEXT_DISTANCE_MM + 0.6 * long, middle),
            (low - TEXT_DISTANCE_MM - 0.6 * long, middle),
        ):
            yield Text((x - long / 2, y - height / 2), mate, height, layer=MARK)
