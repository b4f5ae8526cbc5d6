"""Rounded corners: arcs of a given radius in place of the corners of closed paths."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.errors import InputError
from elastica_cad.geometry.paths.many_segments import ManySegments
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.segments import Arc, Segment, Spline, place

SMOOTH_RAD = 0.02
"""Corners that turn by less stay: fitted sides meet so."""

MOST_STEPS = 40
"""Of the search for an arc's ends: the sides bend little, so few serve."""

CLOSE_MM = 1e-9
"""The arc's two centres agree to this: rounding."""


def round_corners(path: Path, radius: float) -> Path:
    """The closed path with an arc of `radius` mm, tangent to both sides, in place of every corner.

    Raises
    ------
    InputError
        The sides at a corner are too short for the radius; says where.

    Examples
    --------
    >>> plate = round_corners(Path.rectangle(10, 6), 1.0)
    >>> round(plate.area - (60 - 4), 6)  # four squares less, four quarter circles more
    3.141593
    """
    return round_all_corners([path], radius)[0]


def round_all_corners(paths: Sequence[Path], radius: float) -> list[Path]:
    """The same of many closed paths, their corners searched at one go. Errors as `round_corners`."""
    segments = [segment for path in paths for segment in path.segments]
    if not segments:
        return []
    following = np.arange(1, len(segments) + 1)
    ends = np.cumsum([len(path.segments) for path in paths])
    following[ends - 1] = np.concatenate([[0], ends[:-1]])
    many = ManySegments(segments)
    corners = _corners(many, following, radius)
    first, last = np.zeros(len(segments)), np.ones(len(segments))
    last[corners.before], first[following[corners.before]] = corners.leaving, corners.entering
    if (first > last).any():
        raise _too_short(segments[int(np.argmax(first - last))].at(0.5), radius)
    sizes = np.array([_size(segment) for segment in segments])
    last = np.where((last - first) * sizes > CLOSE_MM, last, first)
    parts = many.trimmed(first, last)
    arcs = dict(zip(corners.before.tolist(), corners.arcs, strict=True))
    rounded, begin = [], 0
    for end in ends.tolist():
        chain = [one for i in range(begin, end) for one in (parts[i], arcs.get(i)) if one is not None]
        rounded.append(Path(chain, closed=True))
        begin = end
    return rounded


@dataclass(frozen=True, eq=False)
class _Corners:
    """Segments (k,) that end in a corner, where the arc leaves them and enters the next, and the arcs."""

    before: IntArray
    leaving: FloatArray
    entering: FloatArray
    arcs: list[Arc]


def _corners(many: ManySegments, following: IntArray, radius: float) -> _Corners:
    every = np.arange(following.size)
    (at, s), (_, t) = many.motion(every, np.ones(every.size)), many.motion(following, np.zeros(every.size))
    turn = _turn(s, t)
    before = np.flatnonzero(np.abs(turn) >= SMOOTH_RAD)
    after, at, turn = following[before], at[before], turn[before]
    side = (radius * np.sign(turn))[:, None]
    reach = radius * np.tan(np.abs(turn) / 2)
    x = np.column_stack([1 - reach / _length(s[before]), reach / _length(t[before])])
    x = np.minimum(np.maximum(x, 0.0), 1.0)
    open_ = np.arange(before.size)
    ends = np.empty((4, before.size, 2))
    for _ in range(MOST_STEPS):
        outside = ((x[open_] < 0) | (x[open_] > 1)).any(axis=1)
        if outside.any():
            raise _too_short(at[open_[outside][0]], radius)
        near, far = many.motion(before[open_], x[open_, 0]), many.motion(after[open_], x[open_, 1])
        ends[:, open_] = *near, *far
        gap = _beside(*near, side[open_]) - _beside(*far, side[open_])
        apart = np.abs(gap).max(axis=1) >= CLOSE_MM
        if not apart.any():
            break
        # the sides bend so little that their tangents serve for the Jacobian
        v, w, gap = near[1][apart], far[1][apart], gap[apart]
        open_ = open_[apart]
        determinant = v[:, 1] * w[:, 0] - v[:, 0] * w[:, 1]
        x[open_, 0] -= (gap[:, 1] * w[:, 0] - gap[:, 0] * w[:, 1]) / determinant
        x[open_, 1] -= (v[:, 0] * gap[:, 1] - v[:, 1] * gap[:, 0]) / determinant
    else:
        raise _too_short(at[open_[0]], radius)
    start, leaving, end, entering = ends
    bulges = np.tan(_turn(leaving, entering) / 4)
    arcs = [Arc.from_bulge(a, b, float(bulge)) for a, b, bulge in zip(start, end, bulges, strict=True)]
    return _Corners(before, x[:, 0], x[:, 1], arcs)


def _turn(s: FloatArray, t: FloatArray) -> FloatArray:
    """Angles (n,) from directions s to directions t (n, 2)."""
    return np.asarray(np.arctan2(s[:, 0] * t[:, 1] - s[:, 1] * t[:, 0], (s * t).sum(axis=1)))


def _length(v: FloatArray) -> FloatArray:
    return np.asarray(np.hypot(v[:, 0], v[:, 1]))


def _beside(points: FloatArray, velocities: FloatArray, distance: FloatArray) -> FloatArray:
    """Points (n, 2) moved to the left of their velocities by distances (n, 1)."""
    left = np.column_stack([-velocities[:, 1], velocities[:, 0]])
    return np.asarray(points + distance * left / _length(velocities)[:, None], dtype=float)


def _size(segment: Segment) -> float:
    """mm, of a spline not less than its length."""
    if isinstance(segment, Spline):
        return float(_length(np.diff(segment.curve.control_points, axis=0)).sum())
    return segment.length


def _too_short(at: FloatArray, radius: float) -> InputError:
    return InputError(
        f"a corner radius of {radius:g} mm does not fit the hole at {place(at)}: make it smaller"
    )
