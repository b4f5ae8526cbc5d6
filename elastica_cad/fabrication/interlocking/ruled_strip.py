"""A bent strip as a ruled surface: its curve in space, and rulings as long as the strip is wide."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any

import numpy as np

from elastica_cad._types import BoolArray, FloatArray
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.paths.profile import Profile

STATIONS = 400
"""Least number of samples of a strip from which crossings are found; between them it is known to 1e-5 mm."""

_TABLES = 128  # curves whose tables are kept: equal strips share theirs, as do crossings and collisions
_ROUNDING = 1e-12  # of places: strips as thin as a line may meet in spite of it

InPlane = tuple[FloatArray, FloatArray]
"""Points and unit tangents (n, 2) of a strip's curve in its own plane."""


@dataclass(frozen=True, eq=False)
class RuledStrip:
    """The surface gamma(s) + v z, |v| <= width(s) / 2: curve in the plane of `frame`, rulings along its z.

    Parameters
    ----------
    curve : PlaneCurve
    frame : Frame
    width : Profile
        Full width over arc length, mm.
    """

    curve: PlaneCurve
    frame: Frame
    width: Profile

    @property
    def length(self) -> float:
        """Length of the strip, mm."""
        return self.width.length

    @property
    def axis(self) -> FloatArray:
        """Direction of the rulings (3,)."""
        return self.frame.z_axis

    @property
    def stations(self) -> FloatArray:
        """Arc lengths (n,) dense enough to find crossings from."""
        return np.asarray(self._spline.x)

    def half_width(self, s: FloatArray) -> FloatArray:
        """Half the width (n,) at arc lengths (n,), mm."""
        return self.width(s) / 2

    def motion(self, s: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Points of the curve in space and unit tangents, (n, 3) each, at arc lengths (n,)."""
        p, d = self.in_plane(s)
        return self.frame.point(p), self.frame.direction(d)

    def normal(self, tangent: FloatArray) -> FloatArray:
        """Unit normals of the surface (n, 3), to the left of the curve, for its tangents (n, 2) in its plane."""
        return self.frame.direction(np.column_stack([-tangent[:, 1], tangent[:, 0]]))

    @cached_property
    def box(self) -> FloatArray:
        """[[low], [high]] (2, 3) of a box around the surface in its own frame, mm."""
        reach = self.width.extremes[1] / 2
        low, high = self.curve.bounds
        return np.array([[*low, -reach], [*high, reach]])

    def in_plane(self, s: FloatArray) -> InPlane:
        """Points and tangents at arc lengths (n,)."""
        return self._spline(s), self._spline(s, 1)

    @property
    def _spline(self) -> Any:
        return _over_arc_length(self.curve, self.length)


def strips_may_meet(strips: Sequence[RuledStrip], rooms: FloatArray | None = None) -> BoolArray:
    """Which strips (n, n) are not clearly apart, each with `rooms` (n,) mm about it, seen in the frame of either.

    A box around one strip then meets that around the other.
    """
    rooms = np.zeros(len(strips)) if rooms is None else rooms
    axes, origins, boxes = (
        np.array(rows).reshape(-1, *shape)
        for rows, shape in (
            ([strip.frame.axes for strip in strips], (3, 3)),
            ([strip.frame.origin for strip in strips], (3,)),
            ([strip.box for strip in strips], (2, 3)),
        )
    )
    centers = origins + (boxes.mean(axis=1)[:, None] @ axes)[:, 0]
    sizes = (boxes[:, 1] - boxes[:, 0]) / 2
    rooms = rooms + _ROUNDING * (np.abs(centers).max(initial=0.0) + sizes.max(initial=0.0))
    seen = np.empty((len(strips), len(strips)), dtype=bool)
    for own, box, room, sees, origin in zip(axes, boxes, rooms, seen, origins, strict=True):
        center = (centers - origin) @ own.T
        half = (np.abs(own @ np.swapaxes(axes, 1, 2)) @ sizes[..., None])[..., 0] + (rooms + room)[:, None]
        sees[:] = np.all((box[0] <= center + half) & (box[1] >= center - half), axis=1)
    return np.asarray(seen & seen.T)


@lru_cache(maxsize=_TABLES)
def _over_arc_length(curve: PlaneCurve, length: float) -> Any:
    """Cubic spline of a curve over arc lengths that end at `length`, with the curve's own tangents at its nodes."""
    from scipy.interpolate import CubicHermiteSpline

    panels = curve.smooth_panels
    each = -(-STATIONS // (panels.size - 1))
    inner = (panels[:-1, None] + np.diff(panels)[:, None] * np.arange(each) / each).ravel()
    t = np.append(inner, panels[-1])
    way = curve.evaluate(t, 1)
    return CubicHermiteSpline(
        curve.arc_length(t) * length / curve.length, curve.evaluate(t), way / np.hypot(*way.T)[:, None]
    )
