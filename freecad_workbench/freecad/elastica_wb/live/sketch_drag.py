# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Geometry of a sketch during a drag, computed from the points that the sketcher draws.

FreeCAD notifies observers of a drag only when the mouse is released.
"""

from collections.abc import Sequence
from typing import Any

import FreeCAD as App
import Part

# relative tolerance of equal points, which are drawn in single precision
NEAR = 1e-4
# largest distance, mm, of circles from their poles after the sketcher's solver has run
SOLVED_MM = 1e-2

POINTS = {
    "Part::GeomPoint": 1,
    "Part::GeomLineSegment": 2,
    "Part::GeomCircle": 1,
    "Part::GeomEllipse": 1,
    "Part::GeomArcOfCircle": 3,
    "Part::GeomArcOfEllipse": 3,
    "Part::GeomArcOfHyperbola": 3,
    "Part::GeomArcOfParabola": 3,
    "Part::GeomBSplineCurve": 2,
}
"""Number of points that the sketcher draws for each type of geometry."""


class Dragged:
    """Reconstruction of the geometry of a sketch from the drawn points.

    `usable` is False if the points are in an unknown order, or if a pole is not drawn as a point. Then the
    geometry is known only after the mouse is released.
    """

    def __init__(self, sketch: Any, points: Sequence[Sequence[float]]) -> None:
        self._geometry = list(sketch.Geometry)
        self._construction = [sketch.getConstruction(i) for i in range(len(self._geometry))]
        counts = [POINTS.get(g.TypeId, -1) for g in self._geometry]
        self.usable = False
        if -1 in counts:
            return
        self._first = [sum(counts[:i]) for i in range(len(counts))]
        self._poles = {
            i: self._pole_circles(i)
            for i, g in enumerate(self._geometry)
            if isinstance(g, Part.BSplineCurve) and not self._construction[i]
        }
        if any(None in circles for circles in self._poles.values()):
            return
        for shift in (1, 0):  # FreeCAD 1.1 does not draw the origin
            if sum(counts) + shift <= len(points) and self._fits(points, shift):
                self.usable, self._shift = True, shift
                return

    def geometry(self, points: Sequence[Sequence[float]]) -> list[Any]:
        """Return the geometry of the sketch with its points moved to the drawn positions."""
        moved = list(self._geometry)
        for i, geometry in enumerate(self._geometry):
            if self._construction[i]:
                continue
            if i in self._poles:
                moved[i] = geometry.copy()
                for k, circle in enumerate(self._poles[i], start=1):
                    moved[i].setPole(k, self._drawn(points, circle, 0))
            elif isinstance(geometry, Part.LineSegment):
                moved[i] = Part.LineSegment(*(self._drawn(points, i, k) for k in (0, 1)))
            elif isinstance(geometry, Part.ArcOfCircle):
                moved[i] = self._arc(points, i)
        return moved

    def _drawn(self, points: Sequence[Sequence[float]], geometry: int, number: int) -> App.Vector:
        x, y = points[self._shift + self._first[geometry] + number][:2]
        return App.Vector(x, y, 0)

    def _arc(self, points: Sequence[Sequence[float]], i: int) -> Any:
        start, end, center = (self._drawn(points, i, k) for k in (0, 1, 2))
        circle = Part.Circle(center, App.Vector(0, 0, 1), start.distanceToPoint(center))
        first, last = circle.parameter(start), circle.parameter(end)
        return Part.ArcOfCircle(circle, first, last if last > first else last + 6.283185307179586)

    def _pole_circles(self, spline: int) -> list[int | None]:
        pole_circles: list[int | None] = []
        used: set[int] = set()
        for pole in self._geometry[spline].getPoles():
            circles = {
                g.Center.distanceToPoint(pole): i
                for i, g in enumerate(self._geometry)
                if self._construction[i] and i not in used and isinstance(g, Part.Circle)
            }
            near = min(circles, default=SOLVED_MM)
            circle = circles[near] if near < SOLVED_MM else None
            pole_circles.append(circle)
            if circle is not None:
                used.add(circle)
        return pole_circles

    def _fits(self, points: Sequence[Sequence[float]], shift: int) -> bool:
        for i, circles in self._poles.items():
            for pole, circle in zip(self._geometry[i].getPoles(), circles, strict=True):
                x, y = points[shift + self._first[circle]][:2]
                if abs(x - pole.x) + abs(y - pole.y) > NEAR * (1 + pole.Length):
                    return False
        return True
