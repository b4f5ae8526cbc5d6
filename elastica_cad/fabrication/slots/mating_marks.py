"""Mating marks: beside every slot the name of the strip that goes in, at the ends their numbers; the label."""

from collections.abc import Iterator, Sequence
from itertools import product

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.fabrication.drawings.drawing import ENGRAVE, MARK
from elastica_cad.fabrication.drawings.lettering import LABEL_MM, LABEL_SHARE, Text, fit_label, text_width
from elastica_cad.fabrication.slots.slot import Slot, slot_rim
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.path_intersections import polylines_cross
from elastica_cad.geometry.paths.profile import Profile

LETTER_HEIGHTS_MM = (2.0, 1.5, 1.0)
"""Tried in turn; below 1 mm engraved letters run together."""

NUMBER_PLACES_MM = (2.0, 4.0, 7.0, 11.0)
"""From the end of the free part to its number, tried in turn: beside the holder's face, to be seen in place."""

CLEARANCE_MM = 0.5
"""Letters keep this far from every cut, so that no stroke is a notch."""

LABEL_SHARES = (1.0, 0.7, 0.5, 0.35)
"""Of the usual height of a label, tried in turn where cuts are in its way."""

LABEL_STEP_MM = 2.0
"""From one place of a label to the next that is tried."""

FLAT_MM = 0.02
"""Flatness of the cuts as letters see them: little beside their clearance."""


def mating_marks(
    slots: Sequence[Slot], width: Profile, others: Sequence[Path], taken: Sequence[Text] = ()
) -> tuple[Text, ...]:
    """The names of the mates, on the MARK layer, clear of all slots, of `others` and of other texts.

    Each stands at the inner end of its slot, or else beside the slot, as large as fits; where nothing fits the
    slot stays without.
    """
    cuts = [slot_rim(slot, width, beyond=slot.width) for slot in slots]
    lines = [*cuts, *(_line(path) for path in others)] if cuts else []
    boxes = [_box(text) for text in taken]
    marks = []
    for slot, cut in zip(slots, cuts, strict=True):
        for text in _choices(slot, cut, width) if slot.mate else ():
            box = _box(text)
            if _clear(box, width, boxes, lines):
                marks.append(text)
                boxes.append(box)
                break
    return tuple(marks)


def end_numbers(
    width: Profile, cuts: Sequence[Path], taken: Sequence[Text] = (), names: tuple[str, str] = ("1", "2")
) -> tuple[Text, ...]:
    """ "1" where the free part starts and "2" where it ends, as slots of bases call them, clear of cuts and texts.

    Other `names` stand for joints; an empty one, or one that finds no room, is left out.
    """
    lines, boxes, numbers = [_line(path) for path in cuts], [_box(text) for text in taken], []
    for number, end, way in ((names[0], 0.0, 1.0), (names[1], width.length, -1.0)):
        for height, off in product(LETTER_HEIGHTS_MM, NUMBER_PLACES_MM) if number else ():
            long = text_width(number, height)
            x = end + way * (off + max(height, long) / 2) - long / 2
            text = Text((float(x), -height / 2), number, height, layer=ENGRAVE)
            box = _box(text)
            if _clear(box, width, boxes, lines):
                numbers.append(text)
                break
    return tuple(numbers)


def label_off_cuts(label: str, width: Profile, cuts: Sequence[Path]) -> Text:
    """The label of a strip, along its middle line: as near to the middle as it lies off all cuts.

    Smaller where it must be; in the middle where there is no such place.
    """
    length = width.length
    if not cuts:
        return fit_label(label, (length / 2, 0.0), angle=0.0, room=length, across=float(width(length / 2)))
    lines = [_line(path) for path in cuts]
    steps = LABEL_STEP_MM * np.arange(1, max(int(length / 2 / LABEL_STEP_MM), 1))
    ways = [0.0, *(float(v) for step in steps for v in (step, -step))]

    def text(off: float, share: float) -> Text:
        x = length / 2 + off
        across = share * min(float(width(x)), LABEL_MM / LABEL_SHARE)
        return fit_label(label, (x, 0.0), angle=0.0, room=length, across=across)

    tried = (text(off, share) for share in LABEL_SHARES for off in ways)
    return next((one for one in tried if _clear(_box(one), width, (), lines)), text(0.0, 1.0))


def label_on_tabs(label: str, tabs: Sequence[tuple[float, float, float]], cuts: Sequence[Path]) -> Text:
    """The label across one of the `tabs`, each the x where it begins, where it ends, and its width, off all cuts.

    Smaller or beside the middle where it must be; in the middle of the first where there is no such place.
    """
    lines = [_line(path) for path in cuts]

    def text(tab: tuple[float, float, float], share: float, place: float, side: float) -> Text:
        low, high, wide = tab
        across = 2 * min(place, 1 - place) * (high - low)
        center = (low + place * (high - low), side * wide / 4)
        room = wide / 2 if side else wide
        return fit_label(label, center, angle=np.pi / 2, room=room, across=share * across)

    places = ((0.5, 0.0), (0.5, 1.0), (0.5, -1.0), (0.25, 0.0), (0.75, 0.0))
    tried = (text(tab, share, *at) for share in LABEL_SHARES for tab in tabs for at in places)
    return next((one for one in tried if _off(_box(one), (), lines)), text(tabs[0], 1.0, 0.5, 0.0))


def _clear(box: FloatArray, width: Profile, boxes: Sequence[FloatArray], lines: Sequence[FloatArray]) -> bool:
    """Does a box lie on the free part, off other boxes and off lines?"""
    return _on_strip(box, width) and _off(box, boxes, lines)


def _off(box: FloatArray, boxes: Sequence[FloatArray], lines: Sequence[FloatArray]) -> bool:
    """Does a box lie off other boxes and off lines?"""
    if any(_meet(box, other) for other in boxes):
        return False
    rim = np.concatenate([box, box[:1]])
    return not any(_within(line, box) or polylines_cross(rim, line) is not None for line in lines)


def _choices(slot: Slot, cut: FloatArray, width: Profile) -> Iterator[Text]:
    """Texts beyond the inner end, then on either side of the slot, the largest first."""
    points, _ = slot.center_line(width)
    inward = -1.0 if slot.side == "upper" else 1.0
    end = cut[:, 1].min() if inward < 0 else cut[:, 1].max()
    if slot.relief == "round":
        end += inward * slot.width / 2
    inside = np.abs(cut[:, 1]) < float(width(np.clip(slot.at, 0.0, width.length))) / 2
    low, high = cut[inside, 0].min(), cut[inside, 0].max()
    middle = points[:, 1].mean()
    for height in LETTER_HEIGHTS_MM:
        long, room = text_width(slot.mate, height), CLEARANCE_MM + height / 2
        for x, y in (
            (points[0, 0], end + inward * 1.5 * room),
            (high + CLEARANCE_MM + 0.6 * long, middle),
            (low - CLEARANCE_MM - 0.6 * long, middle),
        ):
            corner = (float(x - long / 2), float(y - height / 2))
            yield Text(position=corner, text=slot.mate, height=height, layer=MARK)


def _box(text: Text) -> FloatArray:
    """Corners (4, 2) of a text with its clearance, anticlockwise."""
    long = text_width(text.text, text.height)
    flat = np.array([[0, 0], [long, 0], [long, text.height], [0, text.height]])
    flat = flat + CLEARANCE_MM * np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
    c, s = np.cos(text.angle), np.sin(text.angle)
    return np.asarray(text.position + flat @ np.array([[c, s], [-s, c]]), dtype=float)


def _on_strip(box: FloatArray, width: Profile) -> bool:
    """Does the box lie on the free part?"""
    x = np.linspace(box[:, 0].min(), box[:, 0].max(), 9)
    if x[0] < 0 or x[-1] > width.length:
        return False
    return bool(np.abs(box[:, 1]).max() < float(width(x).min()) / 2)


def _meet(a: FloatArray, b: FloatArray) -> bool:
    """Do the bounds of two boxes overlap?"""
    return bool(np.all(a.min(axis=0) <= b.max(axis=0)) and np.all(a.max(axis=0) >= b.min(axis=0)))


def _within(line: FloatArray, box: FloatArray) -> bool:
    """Does a line have points in an upright box?"""
    return bool(np.any(np.all((line > box.min(axis=0)) & (line < box.max(axis=0)), axis=1)))


def _line(path: Path) -> FloatArray:
    """Points along a path, around to the first where it is closed."""
    points = path.points(FLAT_MM)
    return np.concatenate([points, points[:1]]) if path.closed else points
