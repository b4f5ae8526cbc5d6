"""What of a path lies between two lines across."""

from collections.abc import Callable, Sequence
from itertools import pairwise

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import InputError
from elastica_cad.geometry.boxes import boxes_meet
from elastica_cad.geometry.paths.path import JOIN, Path
from elastica_cad.geometry.paths.path_intersections import encloses, segment_crossings
from elastica_cad.geometry.paths.segments import Line, Segment
from elastica_cad.geometry.paths.trim import trim_segment

FLAT_MM = 0.002
"""Flatness of loops where it is asked what lies inside them."""


def clip_across(path: Path, low: float, high: float) -> Path:
    """The part of a closed path with low <= x <= high, closed by straight lines; its curves stay exact.

    Raises
    ------
    InputError
        A line that meets the path more or less often than twice, so that there is not one part, or none.

    Examples
    --------
    >>> clip_across(Path.rectangle(40, 10), 5, 25).area
    200.0
    """
    runs = _runs_between(path, low, high)
    if not runs:
        raise InputError(
            f"nothing of the path lies between x = {low:g} and {high:g} mm: give places from "
            f"{path.bounds[0, 0]:g} to {path.bounds[1, 0]:g} mm"
        )
    if len(runs) > 1 and _meets(runs[-1][-1], runs[0][0]):
        runs[0] = runs.pop() + runs[0]
    chain: list[Segment] = []
    for run, following in zip(runs, [*runs[1:], runs[0]], strict=True):
        chain += run
        if not _meets(run[-1], following[0]):
            if abs(run[-1].end[0] - following[0].start[0]) > JOIN:
                raise InputError(f"the part between x = {low:g} and {high:g} mm is not in one piece")
            chain.append(Line(run[-1].end, following[0].start))
    return Path(chain, closed=True)


def trim_across(path: Path, low: float, high: float) -> tuple[Path, ...]:
    """The parts of an open path with low <= x <= high, in order.

    Examples
    --------
    >>> (part,) = trim_across(Path.polyline([(0, 0), (40, 10)]), 10, 30)
    >>> part.bounds.tolist()
    [[10.0, 2.5], [30.0, 7.5]]
    """
    return tuple(Path(run) for run in _runs_between(path, low, high))


def trim_off(path: Path, loops: Sequence[Path]) -> tuple[Path, ...]:
    """The parts of an open path that lie outside of closed ones, in order.

    Examples
    --------
    >>> parts = trim_off(Path.polyline([(-10, 5), (60, 5)]), [Path.rectangle(40, 10)])
    >>> [round(part.length, 9) for part in parts]
    [10.0, 20.0]
    """
    met = [one for one in loops if boxes_meet(one.bounds, path.bounds)]
    if not met:
        return (path,)
    walls = [segment for one in met for segment in one.segments]
    rims = [one.points(FLAT_MM) for one in met]
    kept = _runs(path, walls, lambda place: not any(encloses(rim, place) for rim in rims))
    return tuple(Path(run) for run in kept)


def _runs_between(path: Path, low: float, high: float) -> list[list[Segment]]:
    """Chains of a path's segments between two lines across, in order."""
    (left, bottom), (right, top) = path.bounds
    walls = [Line((x, bottom - 1), (x, top + 1)) for x in (low, high) if left + JOIN < x < right - JOIN]
    return _runs(path, walls, lambda place: low <= float(place[0]) <= high)


def _runs(path: Path, walls: Sequence[Segment], keeps: Callable[[FloatArray], bool]) -> list[list[Segment]]:
    """Chains of a path's segments, cut at `walls`, whose middles are kept, in order."""
    runs: list[list[Segment]] = [[]]
    for segment in path.segments:
        cuts = {u for wall in walls for u, _ in segment_crossings(segment, wall)}
        edges = np.unique([0.0, *(u for u in cuts if _is_within(segment, u)), 1.0])
        for u0, u1 in pairwise(edges.tolist()):
            if keeps(segment.at((u0 + u1) / 2)):
                runs[-1].append(trim_segment(segment, u0, u1))
            elif runs[-1]:
                runs.append([])
    return runs if runs[-1] else runs[:-1]


def _is_within(segment: Segment, u: float) -> bool:
    """Whether a place of a segment is none of its ends, which a line across may meet but for rounding."""
    gaps = np.array([segment.start, segment.end]) - segment.at(u)
    return 0 < u < 1 and bool(np.hypot(*gaps.T).min() > JOIN)


def _meets(before: Segment, after: Segment) -> bool:
    return float(np.hypot(*(before.end - after.start))) <= JOIN
