"""Feet: small plates glued behind a slotted plate, against both faces of a tab, that hold it at its angle."""

from collections.abc import Iterator, Sequence
from dataclasses import replace

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import is_number, several
from elastica_cad.errors import InputError
from elastica_cad.fabrication.drawings.drawing import ENGRAVE, SAME_MM
from elastica_cad.fabrication.drawings.lettering import Text, text_width
from elastica_cad.fabrication.holders.base_plate import BasePlate
from elastica_cad.fabrication.holders.slotted_frame import Rib
from elastica_cad.fabrication.sheets.pieces import distinct
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.paths.path import Path

LEAST_GLUED_MM = 4.0
"""Of a tab behind its plate: less is no joint."""

FOOT_LABEL_MM = 3.0
"""Height of a foot's name, where there is room."""


def add_feet(plates: Sequence[BasePlate], size: float) -> tuple[BasePlate | Rib, ...]:
    """Plates whose tabs are glued, and the feet that set their angle: two for every tab, of the plate's sheet.

    A foot stands square to plate and tab; one of its sides lies on the plate's back, one along the tab. Feet of
    equal strips are equal and share a name; others of that name have a number behind it.

    Parameters
    ----------
    size : float
        How far feet reach along the tab, and over the plate beside the slot, mm.

    Raises
    ------
    InputError
        A tab that does not reach far enough behind its plate to be glued, with the length it needs.
    """
    plates = several("plates", plates, BasePlate, "BasePlate")
    if not (is_number(size) and size >= LEAST_GLUED_MM):
        raise InputError(f"feet are {size!r} mm: make them {LEAST_GLUED_MM:g} mm or larger")
    glued = tuple(replace(plate, glued=True) for plate in plates)
    return (*glued, *_distinctly_named([foot for plate in plates for foot in _feet(plate, size)]))


def _feet(plate: BasePlate, size: float) -> Iterator[Rib]:
    thickness = plate.sheet.thickness
    for slot in plate.slots:
        tab = slot.tab
        if tab is None:
            continue
        # profile: x out along the tab, y off its upper side; the plate's back is where n p = low
        profile = Frame(tab.frame.origin, tab.frame.x_axis, tab.frame.z_axis)
        n = np.array([plate.frame.z_axis @ profile.x_axis, plate.frame.z_axis @ profile.y_axis])
        low = float((plate.frame.origin - profile.origin) @ plate.frame.z_axis) - thickness
        walls = profile.local(plate.frame.point(np.column_stack([slot.corners, np.full(4, -thickness)])))
        level = np.array([-n[1], n[0]]) / np.hypot(*n) * np.sign(n[0])  # along the plate's back, towards +y
        for side, called in ((1.0, "a"), (-1.0, "b")):
            face = side * tab.thickness / 2
            begin = (low - n[1] * face) / n[0]
            reach = min(size, tab.length - begin)
            if reach < LEAST_GLUED_MM:
                raise InputError(
                    f"{plate.name}: the tab of {tab.name} is too short to glue feet to: make it "
                    f"{np.ceil(begin + LEAST_GLUED_MM):.0f} mm long"
                )
            corner = np.array([begin, face])
            past = float(((walls[:, :2] - corner) @ (side * level)).max())
            beside = corner + side * level * (max(past, 0.0) + size)
            corners = np.array([corner, corner + reach * np.array([1.0, 0.0]), beside])
            outline = Path.polygon(corners if side > 0 else corners[::-1])
            name = f"foot-{slot.name.replace(':', '-')}{called}"
            yield Rib(name, plate.sheet, profile, outline, _label(name, corners))


def _distinctly_named(feet: Sequence[Rib]) -> Iterator[Rib]:
    """The feet, those of one name and another shape called by another name; copies of a strip have equal feet."""
    shapes: list[tuple[str, FloatArray]] = []
    places: list[int] = []
    for foot in feet:
        corners = foot.outline.points(SAME_MM)
        alike = (
            i
            for i, (name, known) in enumerate(shapes)
            if name == foot.name and known.shape == corners.shape and np.abs(known - corners).max() < SAME_MM
        )
        place = next(alike, len(shapes))
        if place == len(shapes):
            shapes.append((foot.name, corners))
        places.append(place)
    names = distinct(name for name, _ in shapes)
    for foot, place in zip(feet, places, strict=True):
        name, (own, corners) = names[place], shapes[place]
        yield foot if name == own else replace(foot, name=name, label=_label(name, corners))


def _label(name: str, corners: np.ndarray) -> Text:
    """The name in the middle of a triangle, as large as fits."""
    sides = np.roll(corners, -1, axis=0) - corners
    (ux, uy), (vx, vy) = sides[:2]
    inner = abs(ux * vy - uy * vx) / np.hypot(*sides.T).sum()  # radius of the circle inscribed
    height = min(FOOT_LABEL_MM, inner / 2)
    height *= min(1.0, 1.6 * inner / text_width(name, height))
    x, y = corners.mean(axis=0) - np.array([text_width(name, height), height]) / 2
    return Text((float(x), float(y)), name, height, 0.0, ENGRAVE)
