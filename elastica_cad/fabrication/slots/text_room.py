"""Room for engraved texts: boxes about them, and the cuts that these keep off."""

from collections.abc import Sequence
from functools import cached_property

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.fabrication.drawings.lettering import Text, text_span, text_width
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.path_intersections import encloses, polylines_cross
from elastica_cad.geometry.paths.profile import Profile

CLEARANCE_MM = 0.5
"""Letters keep this far from every cut, so that no stroke is a notch."""

FLAT_MM = 0.02
"""Flatness of the cuts as letters see them: little beside their clearance."""


def text_box(text: Text, clearance: float = CLEARANCE_MM) -> FloatArray:
    """Corners (4, 2) of all strokes of a text with a clearance about them, anticlockwise."""
    long = text_width(text.text, text.height)
    low, high = text_span(text.text, text.height)
    flat = np.array([[0, low], [long, low], [long, high], [0, high]])
    flat = flat + clearance * np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
    c, s = np.cos(text.angle), np.sin(text.angle)
    return np.asarray(text.position + flat @ np.array([[c, s], [-s, c]]), dtype=float)


def boxes_meet(a: FloatArray, b: FloatArray) -> bool:
    """Do the bounds of two boxes overlap?"""
    return bool(np.all(a.min(axis=0) <= b.max(axis=0)) and np.all(a.max(axis=0) >= b.min(axis=0)))


def on_free_part(box: FloatArray, width: Profile) -> bool:
    """Does a box lie on the free part of a strip?"""
    x = np.linspace(box[:, 0].min(), box[:, 0].max(), 9)
    if x[0] < 0 or x[-1] > width.length:
        return False
    return bool(np.abs(box[:, 1]).max() < float(width(x).min()) / 2)


class Cuts:
    """What letters keep off: loops whose inside is cut out, lines, and all that is beyond the outline.

    Parameters
    ----------
    holes, lines : sequence of Path
    outline : Path, optional
    slots : sequence of (n, 2) array
        Points about what else is cut out.
    """

    def __init__(
        self,
        holes: Sequence[Path] = (),
        lines: Sequence[Path] = (),
        *,
        outline: Path | None = None,
        slots: Sequence[FloatArray] = (),
    ) -> None:
        self._outline = () if outline is None else (outline,)
        self._paths = (*self._outline, *holes, *lines)
        self._open = range(len(self._paths) - len(lines), len(self._paths))
        rims = [np.concatenate([points, points[:1]]) for points in slots]
        self._known: dict[int, FloatArray] = dict(enumerate(rims, start=len(self._paths)))

    @cached_property
    def _bounds(self) -> FloatArray:
        boxes = [path.bounds for path in self._paths]
        boxes += [np.array([rim.min(axis=0), rim.max(axis=0)]) for rim in self._known.values()]
        return np.array(boxes).reshape(-1, 2, 2)

    def clear_of(self, box: FloatArray) -> bool:
        """Does a box lie off all of them?"""
        low, high = box.min(axis=0), box.max(axis=0)
        met = np.all((self._bounds[:, 0] <= high) & (self._bounds[:, 1] >= low), axis=1)
        if self._outline and not met[0]:
            return False
        rim = np.concatenate([box, box[:1]])
        return not any(self._reaches(k, box, rim) for k in np.flatnonzero(met).tolist())

    def _reaches(self, k: int, box: FloatArray, rim: FloatArray) -> bool:
        line = self._points(k)
        if bool(np.any(np.all((line > box.min(axis=0)) & (line < box.max(axis=0)), axis=1))):
            return True
        if polylines_cross(rim, line) is not None:
            return True
        return k not in self._open and encloses(line, box[0]) != (k < len(self._outline))

    def _points(self, k: int) -> FloatArray:
        """Points along a line, around to the first where it is closed."""
        if k not in self._known:
            path = self._paths[k]
            points = path.points(FLAT_MM)
            self._known[k] = np.concatenate([points, points[:1]]) if path.closed else points
        return self._known[k]
