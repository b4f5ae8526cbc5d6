"""A bent strip as a ruled surface: its curve in space, and rulings as long as the strip is wide."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np

from elastica_cad._types import BoolArray, FloatArray
from elastica_cad.errors import NotConvergedError
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.paths.profile import Profile
from elastica_cad.refusals import Length

STATIONS = 400
"""Least number of samples of a strip from which crossings are found."""

CURVE_ERROR = 1e-13
"""Error of the curve over arc length, relative to its length."""

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
        return self.quintics[0]

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
        nodes, c = self.quintics
        k = nodes[1:-1].searchsorted(s, side="right")
        # as wide as the rows: twice as fast as to stretch it
        u = np.repeat(s - nodes.take(k), 2).reshape(-1, 2)
        rows = c.take(k, axis=1)
        point, slope = rows[5] * u + rows[4], rows[5]
        for row in rows[3::-1]:  # Horner's scheme, for both at once
            slope *= u
            slope += point
            point *= u
            point += row
        return point, slope

    @cached_property
    def quintics(self) -> tuple[FloatArray, FloatArray]:
        """The curve over arc length: nodes (n + 1,) and quintic pieces (6, n, 2) in s - node."""
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
def _over_arc_length(curve: PlaneCurve, length: float) -> tuple[FloatArray, FloatArray]:
    """A curve over arc lengths that end at `length`: nodes (n + 1,) and quintic pieces (6, n, 2) in s - node."""
    count = STATIONS
    while count < 64 * STATIONS:
        nodes, pieces = _quintics(curve, count)
        if _error(curve, nodes, pieces) <= CURVE_ERROR * curve.length:
            scale = length / curve.length
            powers = scale ** (1.0 - np.arange(6))[:, None, None]
            return curve.arc_length(nodes) * scale, pieces * powers
        count *= 2
    raise NotConvergedError(
        "the curve of a strip {length:.6g} long is too wild to be followed: smooth it", length=Length(length)
    )


def _quintics(curve: PlaneCurve, count: int) -> tuple[FloatArray, FloatArray]:
    """Parameters of the nodes, and Hermite quintics with the curve's position, tangent and curvature there."""
    panels = curve.smooth_panels
    each = max(1, -(-count // (panels.size - 1)))
    inner = (panels[:-1, None] + np.diff(panels)[:, None] * np.arange(each) / each).ravel()
    t = np.append(inner, panels[-1])
    h = np.diff(curve.arc_length(t))[:, None]
    p = curve.evaluate(t)
    d0, c0 = _turning(curve, t[:-1], left=False)
    d1, c1 = _turning(curve, t[1:], left=True)
    gap, turn, change = p[1:] - p[:-1] - h * d0 - h**2 / 2 * c0, h * (d1 - d0 - h * c0), h**2 * (c1 - c0)
    rows = (
        p[:-1], d0, c0 / 2,
        (10 * gap - 4 * turn + change / 2) / h**3,
        (-15 * gap + 7 * turn - change) / h**4,
        (6 * gap - 3 * turn + change / 2) / h**5,
    )  # fmt: skip
    return t, np.array(rows)


def _turning(curve: PlaneCurve, t: FloatArray, *, left: bool) -> tuple[FloatArray, FloatArray]:
    """Unit tangents and their derivatives by arc length (n, 2)."""
    d = curve.evaluate(t, 1, left=left)
    d = d / np.hypot(*d.T)[:, None]
    return d, curve.curvature_at(t, left=left)[:, None] * np.stack([-d[:, 1], d[:, 0]], axis=1)


def _error(curve: PlaneCurve, t: FloatArray, pieces: FloatArray) -> float:
    """Largest distance from the curve, measured between the nodes, mm."""
    middle = (t[:-1] + t[1:]) / 2
    u = (curve.arc_length(middle) - curve.arc_length(t[:-1]))[:, None]
    points = sum(row * u**k for k, row in enumerate(pieces))
    return float(np.abs(points - curve.evaluate(middle)).max())
