"""Slots: narrow cuts that let strips interlock, open at the edge of the flat pattern."""

from dataclasses import dataclass, replace
from typing import Literal

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import is_number, is_one_of, numbers
from elastica_cad.errors import InputError
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.profile import Profile
from elastica_cad.geometry.paths.segments import Arc, Line, Segment, Spline, left_of
from elastica_cad.geometry.polynomials.spline_function import SplineFunction, spline_through
from elastica_cad.geometry.running_sums import lengths_along

STRAIGHT_MM = 1e-7
"""Sides that bend less than this are lines: a tenth of what drawings tell apart."""

CLEARANCE_MM = 0.1
"""Usually added to the width of a slot: a laser-cut sheet then slides in and stays."""

Side = Literal["upper", "lower"]
Relief = Literal["square", "round"]


def _center_line(path: object, widths: object, here: str) -> tuple[FloatArray, FloatArray]:
    rows, across = numbers(path, f"{here}: path"), numbers(widths, f"{here}: widths")
    if rows.ndim != 2 or rows.shape[1] != 2 or len(rows) < 2 or across.shape != (len(rows),):
        raise InputError(f"{here}: path has two or more rows (x, y), widths one number for each")
    return rows, across


@dataclass(frozen=True, eq=False)
class Slot:
    """A slot from inside the strip to its edge.

    Parameters
    ----------
    at : float
        Arc length of the inner end of its centre line, mm.
    width : float
        Across the slot, mm; of a slot along a `path` the width at the inner end.
    depth : float, optional
        From the edge of the strip to the inner end, measured across the strip, mm; to the centre line of the
        strip where not given.
    side : "upper" or "lower"
        The edge on which it opens: y > 0 or y < 0 of the flat pattern.
    lean : float
        Angle of the centre line to the strip's ruling, rad: outward it moves towards larger x where positive.
    relief : "square" or "round"
        The inner end: straight across, or a half circle beyond it.
    mate : str
        What goes in here; written beside the slot.
    path : (k, 2) array, optional
        Centre line in the flat pattern from the inner end to the edge, mm, in place of depth and lean.
    widths : (k,) array, optional
        Width at every point of `path`, mm.

    Raises
    ------
    InputError
        Sizes that are not positive, a path without its widths.

    Examples
    --------
    >>> Slot(40.0, width=1.2, depth=5.0, side="lower").mirrored().side
    'upper'
    """

    at: float
    width: float
    depth: float | None = None
    side: Side = "upper"
    lean: float = 0.0
    relief: Relief = "square"
    mate: str = ""
    path: FloatArray | None = None
    widths: FloatArray | None = None

    def __post_init__(self) -> None:
        for name in ("at", "width", "lean", *(() if self.depth is None else ("depth",))):
            if not is_number(getattr(self, name)):
                raise InputError(f"slot {name} is {getattr(self, name)!r}: it must be a finite number")
        here = f"slot at {self.at:.6g} mm"
        if self.width <= 0 or (self.depth is not None and self.depth <= 0):
            raise InputError(f"{here}: width and depth must be positive, in mm")
        if not (is_one_of(self.side, ("upper", "lower")) and is_one_of(self.relief, ("square", "round"))):
            raise InputError(
                f'{here}: side is "upper" or "lower" and relief "square" or "round", not {self.side!r} and '
                f"{self.relief!r}"
            )
        if abs(self.lean) >= np.pi / 2:
            raise InputError(f"{here}: lean is {self.lean:g} rad: it must stay within a quarter turn")
        if (self.path is None) != (self.widths is None):
            raise InputError(f"{here}: path and widths go together")
        if self.path is not None:
            path, widths = (array.copy() for array in _center_line(self.path, self.widths, here))
            if not np.all(np.isfinite(path)) or not np.all(widths > 0):
                raise InputError(f"{here}: path and widths must be finite, widths positive, in mm")
            for name, array in (("path", path), ("widths", widths)):
                array.setflags(write=False)
                object.__setattr__(self, name, array)

    @classmethod
    def along(
        cls, path: ArrayLike, widths: ArrayLike, *, side: Side, relief: Relief = "square", mate: str = ""
    ) -> "Slot":
        """A slot along a centre line (k, 2) from its inner end to the edge, as wide as `widths` (k,) say."""
        rows, across = _center_line(path, widths, "slot along a path")
        return cls(
            float(rows[0, 0]), float(across[0]), side=side, relief=relief, mate=mate, path=rows, widths=across
        )

    def mirrored(self) -> "Slot":
        """The slot of the strip turned over about its centre line (y to -y)."""
        path = None if self.path is None else self.path * (1.0, -1.0)
        return replace(self, side="lower" if self.side == "upper" else "upper", path=path)

    def center_line(self, width: Profile) -> tuple[FloatArray, FloatArray]:
        """Points (k, 2) from the inner end to the edge and widths (k,), in a strip of that width, mm."""
        if self.path is not None and self.widths is not None:
            return self.path, self.widths
        sign = 1.0 if self.side == "upper" else -1.0
        half = float(width(np.clip(self.at, 0.0, width.length))) / 2
        depth = half if self.depth is None else self.depth
        outward = np.array([np.sin(self.lean), sign * np.cos(self.lean)])
        inner = np.array([self.at, sign * (half - depth)])
        return np.array([inner, inner + outward * depth / np.cos(self.lean)]), np.full(2, self.width)


def slot_cut(slot: Slot, width: Profile, *, beyond: float) -> Path:
    """The open path that a cutter follows: from outside the edge inward, about the inner end, and out again.

    Parameters
    ----------
    slot : Slot
    width : Profile
        Full width of the strip.
    beyond : float
        How far the sides run on, straight, beyond the end of the centre line, mm.
    """
    right, left = _sides(slot, width)
    first, last = right.points[0], left.points[0]
    end = Arc.from_bulge(first, last, -1.0) if slot.relief == "round" else Line(first, last)
    inward = [segment.reversed() for segment in reversed(right.drawn(beyond))]
    return Path([*inward, end, *left.drawn(beyond)])


def _left_of(tangents: FloatArray) -> FloatArray:
    """Unit normals (k, 2) to the left of tangents (k, 2)."""
    normals = np.stack([-tangents[:, 1], tangents[:, 0]], axis=1)
    return np.asarray(normals / np.hypot(*tangents.T)[:, None], dtype=float)


@dataclass(frozen=True, eq=False)
class _Side:
    """A side of a slot from its inner end: points (n, 2), their spline where it is bent, the way on at its end."""

    points: FloatArray
    direction: FloatArray
    bent: Spline | None = None

    def drawn(self, beyond: float) -> list[Segment]:
        """The side, and straight on by `beyond` mm."""
        onward = self.points[-1] + self.direction * beyond / np.hypot(*self.direction)
        if self.bent is None:
            return [Line(self.points[0], onward)]
        return [self.bent, Line(self.points[-1], onward)]


def _sides(slot: Slot, width: Profile) -> tuple[_Side, _Side]:
    """The right and the left side, seen outward."""
    points, widths = slot.center_line(width)
    t = lengths_along(points)
    degree = min(3, len(points) - 1)  # of a spline through them
    tangents = SplineFunction.of(*spline_through(t, points, degree), degree)(t, 1)
    normals = _left_of(tangents)
    right, left = (points + sign * widths[:, None] / 2 * normals for sign in (-1, 1))
    knots, controls = spline_through(t, np.hstack([right, left]), degree)
    return _side(right, knots, controls[:, :2]), _side(left, knots, controls[:, 2:])


def _side(points: FloatArray, knots: FloatArray, controls: FloatArray) -> _Side:
    """A side through points in order: straight where they lie on a line."""
    chord = points[-1] - points[0]
    off = (points - points[0]) @ left_of(chord) / np.hypot(*chord)
    if len(points) == 2 or np.abs(off).max() < STRAIGHT_MM:
        return _Side(points, chord)
    if len(points) < 4:
        raise InputError("a bent slot needs four points or more along its centre line")
    return _Side(points, controls[-1] - controls[-2], Spline(PlaneCurve(knots, controls, 3)))
