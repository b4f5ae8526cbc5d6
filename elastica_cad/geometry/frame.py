"""Position and orientation of planes in space."""

from dataclasses import dataclass
from math import hypot, isfinite

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import as_floats, numbers, require_number, require_record
from elastica_cad.errors import InputError

_PARTS = ("origin", "x_axis", "y_axis")


@dataclass(frozen=True, eq=False)
class Frame:
    """Plane in space with its origin and axes.

    Parameters
    ----------
    origin : (3,) array_like
        Origin of the plane, mm.
    x_axis, y_axis : (3,) array_like
        Perpendicular directions; they are normalised.

    Examples
    --------
    >>> upright = Frame(x_axis=(1, 0, 0), y_axis=(0, 0, 1))
    >>> upright.point([2.0, 3.0]).tolist()
    [2.0, 0.0, 3.0]
    """

    origin: FloatArray
    x_axis: FloatArray
    y_axis: FloatArray

    def __init__(
        self,
        origin: ArrayLike = (0.0, 0.0, 0.0),
        x_axis: ArrayLike = (1.0, 0.0, 0.0),
        y_axis: ArrayLike = (0.0, 1.0, 0.0),
    ) -> None:
        rows = [_row(name, v) for name, v in zip(_PARTS, (origin, x_axis, y_axis), strict=True)]
        sizes = [hypot(*row.tolist()) for row in rows[1:]]
        if min(sizes) == 0 or abs(rows[1] @ rows[2]) > 1e-9 * sizes[0] * sizes[1]:
            raise InputError(
                "frame x_axis and y_axis are not at right angles: give two directions at right angles to "
                "each other"
            )
        for name, row, size in zip(_PARTS, rows, (1.0, *sizes), strict=True):
            scaled = row / size
            scaled.setflags(write=False)
            vars(self)[name] = scaled

    @property
    def z_axis(self) -> FloatArray:
        """Unit normal of the plane: the cross product of x_axis and y_axis."""
        normal: FloatArray = self.axes[2]
        return normal

    @cached_property
    def axes(self) -> FloatArray:
        """The three unit axes as rows (3, 3)."""
        a, b, c = self.x_axis.tolist()
        d, e, f = self.y_axis.tolist()
        rows = np.array([(a, b, c), (d, e, f), (b * f - c * e, c * d - a * f, a * e - b * d)])
        rows.setflags(write=False)
        return rows

    def point(self, local: ArrayLike) -> FloatArray:
        """Return points in space (..., 3), mm, for local coordinates (..., 2) or (..., 3), mm."""
        return self.origin + self.direction(local)

    def direction(self, local: ArrayLike) -> FloatArray:
        """Return vectors in space (..., 3) for local components (..., 2) or (..., 3)."""
        local = numbers(local, "local coordinates")
        if local.shape[-1:] not in ((2,), (3,)):
            raise InputError(
                f"local coordinates have the shape {local.shape}: give rows of two or three numbers"
            )
        return local @ self.axes[: local.shape[-1]]

    def local(self, points: ArrayLike) -> FloatArray:
        """Return local coordinates (..., 3), mm, of points in space (..., 3), mm."""
        points = numbers(points, "points in space")
        if points.shape[-1:] != (3,):
            raise InputError(f"points in space have the shape {points.shape}: give rows of three numbers")
        return (points - self.origin) @ self.axes.T

    def within(self, outer: "Frame") -> "Frame":
        """Convert this frame from coordinates in `outer` to coordinates in space."""
        require_record(outer, Frame, "the outer frame", "a Frame")
        return Frame(outer.point(self.origin), outer.direction(self.x_axis), outer.direction(self.y_axis))

    def carried(self, home: "Frame", now: "Frame") -> "Frame":
        """Return the frame after the rigid motion that moves the frame `home` to `now`."""
        for frame in (home, now):
            require_record(frame, Frame, "what a frame is carried with", "a Frame")
        axes = (home.axes @ axis for axis in (self.x_axis, self.y_axis))
        return Frame(home.local(self.origin), *axes).within(now)

    def shifted(self, x: float = 0.0, y: float = 0.0, z: float = 0.0) -> "Frame":
        """Return the frame with its origin moved along its axes, mm."""
        for axis, shift in zip("xyz", (x, y, z), strict=True):
            require_number(shift, f"the shift along {axis}", "mm")
        origin = self.point((x, y, z))
        _require_finite("origin", origin)
        frame = Frame(origin, self.x_axis, self.y_axis)
        vars(frame)["axes"] = self.axes
        return frame


def frame_or_plain(frame: Frame | None) -> Frame:
    """Return the frame, or the xy plane for None. Refuse other types."""
    if frame is None:
        return Frame()
    require_record(frame, Frame, "the frame", "a Frame")
    return frame


def _row(name: str, given: ArrayLike) -> FloatArray:
    row = as_floats(given)
    if row is None:
        raise InputError(f"frame {name} is {given!r}: give three finite numbers")
    _require_finite(name, row)
    return row.copy()


def _require_finite(name: str, row: FloatArray) -> None:
    if row.shape != (3,) or not all(map(isfinite, row.tolist())):
        raise InputError(f"frame {name} is {row.tolist()}: give three finite numbers")
