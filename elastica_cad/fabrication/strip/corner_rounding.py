"""Rounded corners: arcs of a given radius in place of the corners of a closed path."""

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import InputError
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.segments import Arc, Segment, left_of, place
from elastica_cad.geometry.paths.trim import trim_segment

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
    segments = path.segments
    first = [0.0] * len(segments)
    last = [1.0] * len(segments)
    arcs: list[Arc | None] = []
    for i, before in enumerate(segments):
        k = (i + 1) % len(segments)
        corner = _corner(before, segments[k], radius)
        if corner is None:
            arcs.append(None)
            continue
        last[i], first[k] = corner[:2]
        arcs.append(corner[2])
    chain: list[Segment] = []
    for segment, u0, u1, arc in zip(segments, first, last, arcs, strict=True):
        if u0 > u1:
            raise _too_short(segment.at(0.5), radius)
        if (u1 - u0) * segment.length > CLOSE_MM:
            chain.append(trim_segment(segment, u0, u1))
        if arc is not None:
            chain.append(arc)
    return Path(chain, closed=True)


def _corner(before: Segment, after: Segment, radius: float) -> tuple[float, float, Arc] | None:
    """Where the arc leaves one segment and enters the next, and the arc; None where there is no corner."""
    s, t = before.tangent_at(1.0), after.tangent_at(0.0)
    turn = float(np.arctan2(s[0] * t[1] - s[1] * t[0], s @ t))
    if abs(turn) < SMOOTH_RAD:
        return None
    side = radius * np.sign(turn)
    reach = radius * np.tan(abs(turn) / 2)
    x = np.array([1 - reach / before.length, reach / after.length])
    for _ in range(MOST_STEPS):
        if not (0 <= x[0] <= 1 and 0 <= x[1] <= 1):
            raise _too_short(before.end, radius)
        near, far = before.motion_at(x[0]), after.motion_at(x[1])
        gap = _beside(*near, side) - _beside(*far, side)
        if np.abs(gap).max() < CLOSE_MM:
            return float(x[0]), float(x[1]), _arc(near, far)
        # the sides bend so little that their tangents serve for the Jacobian
        x = x - np.linalg.solve(np.column_stack([near[1], -far[1]]), gap)
    raise _too_short(before.end, radius)


def _beside(point: FloatArray, velocity: FloatArray, distance: float) -> FloatArray:
    return np.asarray(point + distance * left_of(velocity) / np.hypot(*velocity), dtype=float)


def _arc(near: tuple[FloatArray, FloatArray], far: tuple[FloatArray, FloatArray]) -> Arc:
    """From the point and velocity where it leaves one segment to those where it enters the next."""
    (start, s), (end, t) = near, far
    turn = float(np.arctan2(s[0] * t[1] - s[1] * t[0], s @ t))
    return Arc.from_bulge(start, end, np.tan(turn / 4))


def _too_short(at: FloatArray, radius: float) -> InputError:
    return InputError(
        f"a corner radius of {radius:g} mm does not fit the hole at {place(at)}: make it smaller"
    )
