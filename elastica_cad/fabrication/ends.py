"""The ends of a strip: tabs to hold it by, with holes, rounded or chamfered corners."""

from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import InputError
from elastica_cad.geometry import Arc, Line, Path

__all__ = ["Hole", "Tab"]


@dataclass(frozen=True)
class Hole:
    """A round hole in a tab.

    Parameters
    ----------
    at : float
        Distance of the centre from the end of the free part, mm, outward into the tab.
    diameter : float
        mm.
    across : float
        Distance from the centre line, mm, towards positive y.
    """

    at: float
    diameter: float
    across: float = 0.0


@dataclass(frozen=True)
class Tab:
    """A straight piece beyond the free part of the strip, by which the end is held.

    Parameters
    ----------
    length : float
        mm; 0 ends the strip square, without a tab.
    width : float, optional
        mm; the strip's own width at that end where not given.
    corner_radius, chamfer : float
        Rounding or chamfer of the two outer corners, mm (one or the other).
    holes : tuple of Hole
        Round holes.

    Raises
    ------
    InputError
        Sizes negative, corners larger than the tab, or holes that leave it.

    Examples
    --------
    >>> Tab(12, holes=(Hole(6, 3.2),)).length
    12
    """

    length: float
    width: float | None = None
    corner_radius: float = 0.0
    chamfer: float = 0.0
    holes: tuple[Hole, ...] = ()

    def __post_init__(self) -> None:
        sizes = {"length": self.length, "corner radius": self.corner_radius, "chamfer": self.chamfer}
        for name, value in sizes.items():
            if not (np.isfinite(value) and value >= 0):
                raise InputError(f"tab {name} is {value}: it must be 0 mm or more")
        if self.width is not None and not (np.isfinite(self.width) and self.width > 0):
            raise InputError(f"tab width is {self.width}: it must be positive, in mm")
        if self.corner_radius and self.chamfer:
            raise InputError("a tab has either a corner radius or a chamfer, not both")
        for hole in self.holes:
            r = hole.diameter / 2
            if r <= 0:
                raise InputError(f"hole diameter is {hole.diameter}: it must be positive, in mm")
            if hole.at - r <= 0 or hole.at + r >= self.length:
                raise InputError(
                    f"a {hole.diameter:g} mm hole {hole.at:g} mm into the tab does not fit its length of "
                    f"{self.length:g} mm: move it or lengthen the tab"
                )

    def mirrored(self) -> "Tab":
        """The tab of the strip turned over about its centre line."""
        return replace(self, holes=tuple(replace(hole, across=-hole.across) for hole in self.holes))

    def corners(self, width: float) -> tuple[Line | Arc, ...]:
        """The tab's rim seen from its free part, run outward, across and back (local frame: x outward).

        Goes from (0, -w/2) to (0, w/2), where w is the tab's width (`width`, the strip's, unless the tab has one).
        """
        w, length = self.width or width, self.length
        cut = self.corner_radius or self.chamfer
        if cut > length or 2 * cut > w:
            raise InputError(
                f"tab corners of {cut:g} mm do not fit a tab of {length:g} by {w:g} mm: make them smaller"
            )
        if length == 0:
            return _chain([(0.0, -w / 2), (0.0, w / 2)])
        if not cut:
            return _chain([(0.0, -w / 2), (length, -w / 2), (length, w / 2), (0.0, w / 2)])
        near, far = length - cut, w / 2 - cut
        if self.chamfer:
            return _chain(
                [(0.0, -w / 2), (near, -w / 2), (length, -far), (length, far), (near, w / 2), (0.0, w / 2)]
            )
        return (
            *_chain([(0.0, -w / 2), (near, -w / 2)]),
            Arc((near, -far), cut, -np.pi / 2, 0.0),
            *_chain([(length, -far), (length, far)]),
            Arc((near, far), cut, 0.0, np.pi / 2),
            *_chain([(near, w / 2), (0.0, w / 2)]),
        )

    def hole_paths(self, width: float) -> tuple[Path, ...]:
        """The holes as closed circles in the tab's frame; `width` as in `corners`."""
        w = self.width or width
        for hole in self.holes:
            if abs(hole.across) + hole.diameter / 2 >= w / 2:
                raise InputError(
                    f"a {hole.diameter:g} mm hole {hole.across:g} mm off the centre line breaks the edge of a "
                    f"{w:.4g} mm wide tab: make it smaller or the tab wider"
                )
        return tuple(Path.circle((hole.at, hole.across), hole.diameter / 2) for hole in self.holes)


def _chain(points: list[tuple[float, float]]) -> tuple[Line, ...]:
    """Lines between successive points, without the ones of no length."""
    rows: list[FloatArray] = [np.array(p) for p in points]
    return tuple(Line(p, q) for p, q in pairwise(rows) if np.any(p != q))
