"""Outlines of thick strokes, which drawing programs make of a line ("Stroke to Path", "Outline Stroke")."""

from collections.abc import Sequence

import numpy as np

from elastica_cad.formats.curve_files.edges import Edge

_SLENDER = 12.0  # least ratio of perimeter and width: a stroke is five times as long as it is wide, or longer
_MOST_SAMPLES = 8000
_EACH = 4  # samples in a width
_EVEN = 0.05  # of the width: how much it may differ along a stroke
_CAPS = (
    6.0  # widths: length of the outline, at both ends of the stroke together, where no opposite side is near
)


def stroke_width(run: Sequence[Edge], tolerance: float) -> float | None:
    """Return the width, mm, of the stroke whose outline a closed run of edges is; None of any other run.

    Examples
    --------
    >>> bar = Edge.polyline([(0, 0), (100, 0), (100, 4), (0, 4), (0, 0)])
    >>> round(stroke_width([bar], 0.01), 2), stroke_width([Edge.polyline(bar.points * (1, 10))], 0.01)
    (4.0, None)
    """
    if float(np.linalg.norm(run[0].start - run[-1].end)) > tolerance or run[0].points.shape[1] != 2:
        return None
    drawn = np.concatenate([edge.at(edge.stations()) for edge in run])
    drawn -= drawn[0]
    s = np.append(0.0, np.cumsum(np.hypot(*np.diff(drawn, axis=0).T)))
    area = abs(float(drawn[:-1, 0] @ drawn[1:, 1] - drawn[1:, 0] @ drawn[:-1, 1])) / 2
    width = (s[-1] - np.sqrt(max(s[-1] ** 2 - 16 * area, 0.0))) / 4  # of a rectangle
    if not _EACH * s[-1] / _MOST_SAMPLES < width < s[-1] / _SLENDER:
        return None
    from scipy.spatial import cKDTree

    count = int(np.ceil(_EACH * s[-1] / width))
    at = np.arange(count) / count * s[-1]
    points = np.column_stack([np.interp(at, s, x) for x in drawn.T])
    apart, near = cKDTree(points).query(points, k=6 * _EACH)
    between = np.abs(np.arange(count)[:, None] - near)
    opposite = np.where(np.minimum(between, count - between) > 2 * _EACH, apart, np.inf).min(axis=1)
    middle = float(np.median(opposite))
    even = np.abs(opposite - middle) <= _EVEN * middle
    return middle if np.isfinite(middle) and even.mean() >= 1 - _CAPS * width / s[-1] else None
