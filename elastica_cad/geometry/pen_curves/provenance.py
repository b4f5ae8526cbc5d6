"""Where a drawn curve's numbers come from: how exact they are, and where the drawing program shows them."""

from dataclasses import dataclass, replace

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad.geometry.pen_curves.measured_points import MeasuredPoints
from elastica_cad.geometry.pen_curves.tangent_healing import Turn
from elastica_cad.refusals import Point, note


@dataclass(frozen=True, eq=False)
class Provenance:
    """What a file says about a curve beside its numbers.

    Parameters
    ----------
    rounding : float
        How far a coordinate may be from what was drawn by the number of its digits alone, mm; 0: not at all.
    healed : float
        How far the curve was moved to take rounding out of its tangents, mm.
    undecided : tuple of Turn
        Turns of the tangent that may be corners and may be rounding.
    place : (3, 3) array, optional
        From millimetres to the coordinates that the drawing program shows.
    unit : str
        What those coordinates are called: "mm", "user units".
    name, layer : str
        What the file calls the curve and its layer; empty when it has no name for them.
    holes : tuple of (float, float, float)
        Circles drawn on a straight first or last piece of the curve: centre and diameter, mm.
    measured : MeasuredPoints, optional
        The points that the whole curve was fitted to.
    vertices : (n, 2) array, optional
        The vertices of the drawn polyline that the whole curve is, if it has corners, mm.
    """

    rounding: float = 0.0
    healed: float = 0.0
    undecided: tuple[Turn, ...] = ()
    place: FloatArray | None = None
    unit: str = "mm"
    name: str = ""
    layer: str = ""
    holes: tuple[tuple[float, float, float], ...] = ()
    measured: MeasuredPoints | None = None
    vertices: FloatArray | None = None

    def shown(self, point: ArrayLike) -> str:
        """A point (2,) in mm as the drawing program shows it.

        Examples
        --------
        >>> Provenance(place=np.diag([2.0, -2.0, 1.0]), unit="user units").shown((10, 5))
        '(20, -10) user units'
        """
        x, y = np.asarray(point, dtype=float)
        if self.place is not None:
            x, y, w = self.place @ (x, y, 1.0)
            x, y = x / w, y / w
        x, y = (round(float(v), 6) + 0.0 for v in (x, y))
        if self.unit == "mm":
            return note("{place:.6g}", place=Point((x, y)))
        return note("({x:.6g}, {y:.6g}) {unit}", x=x, y=y, unit=self.unit)

    def transformed(self, matrix: FloatArray) -> "Provenance":
        """The record of the curve's image under a 3 x 3 map; of a projective one the digits say nothing."""
        m = np.asarray(matrix, dtype=float)
        if m[2, :2].any():
            return replace(self, rounding=0.0, place=None, holes=(), measured=None, vertices=None)
        linear = m[:2, :2] / m[2, 2]
        stretch = float(np.linalg.norm(linear, 2))
        place = (np.eye(3) if self.place is None else self.place) @ np.linalg.inv(m)
        holes = tuple((*(m @ (x, y, 1.0))[:2] / m[2, 2], stretch * size) for x, y, size in self.holes)
        offset = m[:2, 2] / m[2, 2]
        measured = self.measured and MeasuredPoints(
            self.measured.points @ linear.T + offset,
            stretch * self.measured.waver,
            stretch * self.measured.least,
            stretch * self.measured.rounding,
        )
        return replace(
            self,
            rounding=self.rounding * stretch,
            healed=self.healed * stretch,
            place=np.asarray(place),
            holes=tuple((float(x), float(y), float(size)) for x, y, size in holes),
            measured=measured,
            vertices=None if self.vertices is None else self.vertices @ linear.T + offset,
        )

    def reversed(self) -> "Provenance":
        """The record of the curve run from its other end."""
        measured = self.measured and replace(self.measured, points=self.measured.points[::-1])
        vertices = None if self.vertices is None else self.vertices[::-1]
        return replace(self, measured=measured, vertices=vertices)

    def of_part(self) -> "Provenance":
        """The record of a part of the curve: the points were of the whole."""
        return replace(self, measured=None, vertices=None)
