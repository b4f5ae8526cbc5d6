"""Engraved texts where there is room: labels, the names of mates beside slots, the numbers of ends."""

from collections.abc import Iterator, Sequence
from functools import cached_property
from itertools import product

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.fabrication.drawings.drawing import ENGRAVE, MARK
from elastica_cad.fabrication.drawings.lettering import (
    LABEL_MM,
    LABEL_SHARE,
    Text,
    engravable,
    fit_label,
    text_span,
    text_width,
)
from elastica_cad.fabrication.slots.slot import Slot, slot_cut
from elastica_cad.geometry.boxes import box_about, boxes_meet
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.path_intersections import encloses, polylines_cross
from elastica_cad.geometry.paths.profile import Profile

TEXT_DISTANCE_MM = 0.5
"""Distance of letters from every cut, mm, so that no stroke is a notch."""

FLAT_MM = 0.02
"""Flatness of the cuts when letters are placed; it is small beside their distance."""


def _text_box(text: Text, distance: float = TEXT_DISTANCE_MM) -> FloatArray:
    """Corners (4, 2) of all strokes of a text, moved out by `distance` mm, anticlockwise."""
    long = text.length
    low, high = text_span(text.text, text.height)
    flat = np.array([[0, low], [long, low], [long, high], [0, high]])
    flat = flat + distance * np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
    c, s = np.cos(text.angle), np.sin(text.angle)
    return np.asarray(text.position + flat @ np.array([[c, s], [-s, c]]), dtype=float)


def _on_free_part(box: FloatArray, width: Profile) -> bool:
    """Whether a box lies on the free part of a strip."""
    x = np.linspace(box[:, 0].min(), box[:, 0].max(), 9)
    if x[0] < 0 or x[-1] > width.length:
        return False
    return bool(np.abs(box[:, 1]).max() < float(width(x).min()) / 2)


class _Cut:
    """A line that letters keep off; of a loop also the side where no material is, "inside" or "outside"."""

    def __init__(self, line: Path, gone: str = "") -> None:
        self.line, self.gone = line, gone

    @cached_property
    def points(self) -> FloatArray:
        """Along the line, of a loop back to the first."""
        points = self.line.points(FLAT_MM)
        return _around(points) if self.gone or self.line.closed else points

    def reaches(self, box: FloatArray, rim: FloatArray) -> bool:
        """Whether the cut runs through a box, or leaves no material there."""
        low, high = box_about(box)
        if bool(np.any(np.all((self.points > low) & (self.points < high), axis=1))):
            return True
        if polylines_cross(rim, self.points) is not None:
            return True
        return bool(self.gone) and encloses(self.points, box[0]) == (self.gone == "inside")


class Cuts:
    """Places that letters avoid: loops and slots whose inside is cut out, lines, and all that is outside the
    outline."""

    def __init__(
        self,
        holes: Sequence[Path] = (),
        lines: Sequence[Path] = (),
        *,
        outline: Path | None = None,
        slots: Sequence[Path] = (),
    ) -> None:
        self._outline = None if outline is None else _Cut(outline, "outside")
        self._cuts = [] if self._outline is None else [self._outline]
        self._cuts += [_Cut(hole, "inside") for hole in (*holes, *slots)]
        self._cuts += [_Cut(line) for line in lines]
        self._bounds = np.array([cut.line.bounds for cut in self._cuts]).reshape(-1, 2, 2)

    def clear_of(self, box: FloatArray) -> bool:
        """Whether a box avoids all of them."""
        bounds = box_about(box)
        if self._outline and not boxes_meet(self._outline.line.bounds, bounds):
            return False
        rim = _around(box)
        met = np.flatnonzero(boxes_meet(self._bounds, bounds)).tolist()
        return not any(self._cuts[k].reaches(box, rim) for k in met)


def _around(points: FloatArray) -> FloatArray:
    return np.concatenate([points, points[:1]])


LETTER_HEIGHTS_MM = (2.0, 1.5, 1.0)
"""Heights of letters that are tried in this order; below 1 mm engraved letters run together."""

NUMBER_PLACES_MM = (2.0, 4.0, 7.0, 11.0)
"""Distances of a number from the end of the free part, tried in this order, so that it can be seen beside the
holder."""

LABEL_SHARES = (1.0, 0.7, 0.5, 0.35, 0.25)
"""Shares of the usual height of a label, tried in this order where cuts are in its way."""

LABEL_STEP_MM, LABEL_STEPS = 2.0, 100
"""Distance between the places that are tried for a label, and their number to either side; with more, the
distance is larger."""

LABEL_DISTANCES_MM = (TEXT_DISTANCE_MM, 0.0)
"""Clearances that are tried in this order: on a very narrow strip any label is near the edges."""


def mating_marks(
    slots: Sequence[Slot],
    width: Profile,
    holes: Sequence[Path],
    marks: Sequence[Path] = (),
    taken: Sequence[Text] = (),
) -> tuple[Text, ...]:
    """The names of the mates, on the MARK layer, clear of all slots, holes, `marks` and of other texts.

    Each stands at the inner end of its slot, or else beside the slot, as large as fits; where nothing fits the
    slot stays without.
    """
    rims = [slot_cut(slot, width, beyond=slot.width) for slot in slots]
    cuts = Cuts(holes, marks, slots=rims)
    boxes = [box_about(_text_box(text)) for text in taken]
    found = []
    for slot, rim in zip(slots, rims, strict=True):
        for text in _choices(slot, rim.points(FLAT_MM), width) if slot.mate else ():
            box = _text_box(text)
            if _clear(box, width, boxes, cuts):
                found.append(text)
                boxes.append(box_about(box))
                break
    return tuple(found)


def end_numbers(
    width: Profile, cuts: Cuts, taken: Sequence[Text] = (), names: tuple[str, str] = ("1", "2")
) -> tuple[Text, ...]:
    """ "1" where the free part starts and "2" where it ends, as slots of bases call them, clear of cuts and texts.

    Other `names` stand for joints; an empty one, or one that finds no room, is left out.
    """
    boxes, numbers = [box_about(_text_box(text)) for text in taken], []
    for number, end, way in ((names[0], 0.0, 1.0), (names[1], width.length, -1.0)):
        for height, off in product(LETTER_HEIGHTS_MM, NUMBER_PLACES_MM) if number else ():
            long = text_width(number, height)
            x = end + way * (off + max(height, long) / 2) - long / 2
            text = Text((float(x), -height / 2), number, height, layer=ENGRAVE)
            if _clear(_text_box(text), width, boxes, cuts):
                numbers.append(text)
                break
    return tuple(numbers)


def label_off_cuts(label: str, width: Profile, cuts: Cuts, span: tuple[float, float] | None = None) -> Text:
    """The label of a strip, along its middle line: as near to the middle as it lies on the strip and off all cuts.

    Smaller where it must be; in the middle where there is no such place. `span` is where it may stand, mm along the
    strip; the whole free part unless given.
    """
    low, high = span or (0.0, width.length)
    length = high - low
    step = max(LABEL_STEP_MM, length / 2 / LABEL_STEPS)
    steps = step * np.arange(1, max(int(length / 2 / step), 1))
    ways = [0.0, *(float(v) for off in steps for v in (off, -off))]

    def text(off: float, share: float) -> Text:
        x = low + length / 2 + off
        across = share * min(float(width(x)), LABEL_MM / LABEL_SHARE)
        return fit_label(label, (x, 0.0), angle=0.0, room=share * length, across=across)

    tried = (
        (text(off, share), near) for near in LABEL_DISTANCES_MM for share in LABEL_SHARES for off in ways
    )
    clear = (one for one, near in tried if _clear(_text_box(one, near), width, (), cuts))
    return next(clear, text(0.0, 1.0))


def label_on_tabs(label: str, tabs: Sequence[tuple[float, float, float]], cuts: Cuts) -> Text:
    """The label across one of the `tabs`, each the x where it begins, where it ends, and its width, off all cuts.

    Smaller or beside the middle where it must be; in the middle of the first where there is no such place.
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
    clear = (one for one, near in tried if cuts.clear_of(_text_box(one, near)))
    return next(clear, text(tabs[0], 1.0, 0.5, 0.0))


def _clear(box: FloatArray, width: Profile, taken: Sequence[FloatArray], cuts: Cuts) -> bool:
    """Whether a box, given by its corners, lies on the free part and avoids other boxes (2, 2) and cuts."""
    if not _on_free_part(box, width) or (taken and boxes_meet(np.array(taken), box_about(box)).any()):
        return False
    return cuts.clear_of(box)


def _choices(slot: Slot, cut: FloatArray, width: Profile) -> Iterator[Text]:
    """Texts beyond the inner end, then on either side of the slot, the largest first."""
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
            corner = (float(x - long / 2), float(y - height / 2))
            yield Text(position=corner, text=mate, height=height, layer=MARK)
