"""Room for engraved texts: boxes about them, and the cuts that these keep off."""

from collections.abc import Sequence
from functools import cached_property

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.fabrication.drawings.lettering import Text, text_span
from elastica_cad.geometry.boxes import box_about, boxes_meet
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.path_intersections import encloses, polylines_cross
from elastica_cad.geometry.paths.profile import Profile

CLEARANCE_MM = 0.5
"""Letters keep this far from every cut, so that no stroke is a notch."""

FLAT_MM = 0.02
"""Flatness of the cuts as letters see them: little beside their clearance."""


def text_box(text: Text, clearance: float = CLEARANCE_MM) -> FloatArray:
    """Corners (4, 2) of all strokes of a text with a clearance about them, anticlockwise."""
    long = text.length
    low, high = text_span(text.text, text.height)
    flat = np.array([[0, low], [long, low], [long, high], [0, high]])
    flat = flat + clearance * np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
    c, s = np.cos(text.angle), np.sin(text.angle)
    return np.asarray(text.position + flat @ np.array([[c, s], [-s, c]]), dtype=float)


def on_free_part(box: FloatArray, width: Profile) -> bool:
    """Does a box lie on the free part of a strip?"""
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
        """Does it run through a box, or leave it no material?"""
        low, high = box_about(box)
        if bool(np.any(np.all((self.points > low) & (self.points < high), axis=1))):
            return True
        if polylines_cross(rim, self.points) is not None:
            return True
        return bool(self.gone) and encloses(self.points, box[0]) == (self.gone == "inside")


class Cuts:
    """What letters keep off: loops and slots whose inside is cut out, lines, and all that is beyond the outline."""

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
        """Does a box lie off all of them?"""
        bounds = box_about(box)
        if self._outline and not boxes_meet(self._outline.line.bounds, bounds):
            return False
        rim = _around(box)
        met = np.flatnonzero(boxes_meet(self._bounds, bounds)).tolist()
        return not any(self._cuts[k].reaches(box, rim) for k in met)


def _around(points: FloatArray) -> FloatArray:
    return np.concatenate([points, points[:1]])
