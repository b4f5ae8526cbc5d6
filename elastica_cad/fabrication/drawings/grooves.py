"""Strokes of a text as grooves with straight walls, few of them, for bodies that are engraved."""

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.path_intersections import self_crossing

SHARPEST_TURN = np.radians(100.0)
"""Between two chords of one groove: beyond, its mitre would reach far."""

LEAST_SIDE = 0.1
"""Of a chord, what must stay of it between the mitres of its inner side."""


def grooves(stroke: Path, width: float, flatness: float) -> list[tuple[Path, tuple[Path, ...]]]:
    """Outlines and holes of the grooves that a tool of this width would leave along a stroke.

    Parameters
    ----------
    stroke : Path
        One of `text_strokes`; mm.
    width : float
        mm. Ends are square and stand out by half of it.
    flatness : float
        How far the chords may leave the stroke's arcs, mm.

    Returns
    -------
    list of (outline, holes)
        Anticlockwise polygons that do not cross themselves: a ring where a stroke ends where it began, several
        pieces that overlap where it crosses itself or turns sharply.

    Examples
    --------
    >>> [(outline, holes)] = grooves(Path.polygon([(0, 0), (4, 0), (4, 4), (0, 4)]), 1.0, 0.1)
    >>> outline.area, [hole.area for hole in holes]
    (25.0, [9.0])
    """
    points = stroke.points(flatness)
    # a dot is one chord, however short
    if stroke.closed or (len(points) > 2 and np.hypot(*(points[-1] - points[0])) < width * LEAST_SIDE):
        corners = points if stroke.closed else points[:-1]
        ring = _ring(corners, width)
        if ring is not None:
            return [ring]
        points = np.vstack([corners, corners[:1]])
    found, chain = [], points[:2]
    for point in points[2:]:
        longer = np.vstack([chain, point])
        if _band(longer, width) is None:
            found.append(chain)
            chain = longer[-2:]
        else:
            chain = longer
    bands = (_band(chain, width) for chain in (*found, chain))
    return [(Path.polygon(band), ()) for band in bands if band is not None]


def _band(points: FloatArray, width: float) -> FloatArray | None:
    """Corners of the groove about a chain of chords; None where they turn too sharply or it crosses itself."""
    along = _directions(np.diff(points, axis=0))
    sides = _mitres(along, points)
    if sides is None:
        return None
    left = np.vstack([_left(along[:1]), sides, _left(along[-1:])]) * width / 2
    centres = points.copy()
    centres[0] -= along[0] * width / 2
    centres[-1] += along[-1] * width / 2
    inner = centres + left, centres - left
    if not all(_goes_on(side, along) for side in inner):
        return None
    corners = np.vstack([inner[1], inner[0][::-1]])
    return corners if len(points) == 2 or self_crossing(corners, closed=True) is None else None


def _ring(corners: FloatArray, width: float) -> tuple[Path, tuple[Path, ...]] | None:
    """The groove about a closed polygon, as `_band`."""
    around = np.vstack([corners, corners[:1]])
    along = _directions(np.diff(around, axis=0))
    sides = _mitres(np.vstack([along[-1:], along]), np.vstack([corners[-1:], around]))
    if sides is None:
        return None
    left, right = corners + sides * width / 2, corners - sides * width / 2
    for side in (left, right):
        if not _goes_on(np.vstack([side, side[:1]]), along) or self_crossing(side, closed=True) is not None:
            return None
    paths = (path if path.area > 0 else path.reversed() for path in map(Path.polygon, (left, right)))
    inner, outer = sorted(paths, key=lambda path: path.area)
    return outer, (inner,)


def _directions(steps: FloatArray) -> FloatArray:
    return np.asarray(steps / np.hypot(*steps.T)[:, None])


def _left(along: FloatArray) -> FloatArray:
    return np.column_stack([-along[:, 1], along[:, 0]])


def _mitres(along: FloatArray, points: FloatArray) -> FloatArray | None:
    """To the left at every corner between chords, so long that both walls stay at distance one."""
    straight = np.sum(along[:-1] * along[1:], axis=1)
    if len(points) > 2 and straight.min() < np.cos(SHARPEST_TURN):
        return None
    normal = _left(along)
    return np.asarray((normal[:-1] + normal[1:]) / (1 + straight)[:, None])


def _goes_on(side: FloatArray, along: FloatArray) -> bool:
    """Does a wall keep the direction of every chord, and enough of its length?"""
    return bool(np.all(np.sum(np.diff(side, axis=0) * along, axis=1) > LEAST_SIDE))
