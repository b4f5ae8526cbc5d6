"""The rim of a flat part: two long sides from a width, and the tabs at both ends."""

from collections.abc import Iterable
from dataclasses import replace
from math import dist

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.fabrication.strip.tabs import Hole, Tab
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.profile import Profile
from elastica_cad.geometry.paths.segments import Arc, Line, Segment, Spline
from elastica_cad.geometry.polynomials.splines import greville, knot_runs

Ends = tuple[Tab, Tab]

SHOULDER_MM = 1e-3
"""A tab that differs less in width is as wide as the strip: no tool cuts such shoulders, kernels trip over them."""

MEETING_MM = 1e-9
"""Ends nearer than this meet: rounding."""

EVEN = 1e-10
"""Share of its size by which a spline's x may stray from running evenly: rounding."""


def flat_rim(width: Profile, ends: Ends) -> Path:
    """The closed outer loop, anticlockwise, of a strip of full width `width` (mm) with its tabs.

    Its long sides are B-splines whose x control points are the Greville abscissae of the knots, so that y(x)
    is exactly half the width.
    """
    pieces = _pieces(width)
    lower = [_side(piece, -0.5) for piece in pieces]
    upper = [_side(piece, 0.5, backward=True) for piece in reversed(pieces)]
    start, end = _end_widths(width)
    near_tab, far_tab = (_flush(tab, at) for tab, at in zip(ends, (start, end), strict=True))
    far, near = _placed(far_tab.corners(end), width.length, 1), _placed(near_tab.corners(start), 0.0, -1)
    return Path(close_chain([*lower, *far, *upper, *near]), closed=True)


def long_sides(width: Profile) -> tuple[list[Spline], list[Spline]]:
    """The lower and the upper long side from start to end, each in the pieces between the width's jumps."""
    pieces = _pieces(width)
    lower, upper = ([_side(piece, factor) for piece in pieces] for factor in (-0.5, 0.5))
    return lower, upper


def end_holes(width: Profile, ends: Ends) -> tuple[Path, ...]:
    """The round holes of both tabs as closed loops in the frame of the strip."""
    start, end = _end_widths(width)
    first = [path.transformed(_frame(0.0, -1)) for path in ends[0].hole_paths(start)]
    last = [path.transformed(_frame(width.length, 1)) for path in ends[1].hole_paths(end)]
    return (*first, *last)


def fix_tab_widths(width: Profile, ends: Ends) -> Ends:
    """The tabs with the width that they have on a strip of full width `width`, written into them."""
    start, end = ends
    first, last = _end_widths(width)
    return replace(start, width=start.width or first), replace(end, width=end.width or last)


def add_register_holes(width: Profile, ends: Ends, diameter: float) -> Ends:
    """The tabs with a hole in the middle of each that has none and is long and wide enough for it."""
    start, end = (
        tab
        if tab.holes or tab.length < 2 * diameter or tab.depth_at(tab.length / 2, 0.0, wide) < diameter
        else replace(tab, holes=(Hole(tab.length / 2, diameter),))
        for tab, wide in zip(ends, _end_widths(width), strict=True)
    )
    return start, end


def graph(knots: FloatArray, values: FloatArray, degree: int = 3, *, backward: bool = False) -> Spline:
    """The spline function with these coefficients (m,) as a curve over x, from its start or from its end."""
    return graphs(knots, values[None], degree, backward=backward)[0]


def graphs(knots: FloatArray, values: FloatArray, degree: int = 3, *, backward: bool = False) -> list[Spline]:
    """The spline functions with these rows (n, m) of coefficients over clamped knots, each as `graph`."""
    points = np.empty((*values.shape, 2))
    points[..., 0], points[..., 1] = greville(knots, degree), values
    if backward:
        knots, points = knots[0] + knots[-1] - knots[::-1], points[:, ::-1]
    return [Spline(PlaneCurve(knots, row, degree)) for row in points]


def pace(segment: Segment) -> tuple[float, float] | None:
    """(offset, speed) where x = offset + speed * parameter along the whole segment, else None."""
    if isinstance(segment, Line):
        return float(segment.start[0]), float((segment.end[0] - segment.start[0]) / segment.length)
    if not isinstance(segment, Spline) or segment.curve.is_rational:
        return None
    x, sites = segment.curve.control_points[:, 0], greville(segment.curve.knots, segment.curve.degree)
    speed = float((x[-1] - x[0]) / (sites[-1] - sites[0]))
    offset = float(x[0] - speed * sites[0])
    stray = np.abs(offset + speed * sites - x).max()
    return (offset, speed) if speed and stray <= EVEN * max(1.0, np.abs(x).max()) else None


def close_chain(segments: Iterable[Segment]) -> tuple[Segment, ...]:
    """The closed chain, with a line wherever two neighbours do not meet, as at a step of the width."""
    chain: list[Segment] = []
    for segment in segments:
        if chain and not _meet(chain[-1], segment):
            chain.append(Line(chain[-1].end, segment.start))
        chain.append(segment)
    if not _meet(chain[-1], chain[0]):
        chain.append(Line(chain[-1].end, chain[0].start))
    return tuple(chain)


def _meet(before: Segment, after: Segment) -> bool:
    return dist(before.end.tolist(), after.start.tolist()) <= MEETING_MM


def _pieces(width: Profile) -> list[Profile]:
    """The profile cut at its jumps (interior knots of multiplicity degree + 1)."""
    k = width.degree
    knots, counts = knot_runs(width.knots)
    cuts = knots[(counts > k) & (knots > knots[0]) & (knots < knots[-1])]
    if not cuts.size:
        return [width]
    pieces, first = [], 0
    for cut in [*cuts, None]:
        last = width.coefficients.size if cut is None else int(np.searchsorted(width.knots, cut))
        pieces.append(Profile(width.knots[first : last + k + 1], width.coefficients[first:last], k))
        first = last
    return pieces


def _side(width: Profile, factor: float, *, backward: bool = False) -> Spline:
    """One long side: the graph of `factor` times the width."""
    return graph(width.knots, factor * width.coefficients, width.degree, backward=backward)


def _flush(tab: Tab, width: float) -> Tab:
    """The tab without shoulders too small to cut (their ends would be one point in a file), or of no length."""
    small = tab.width is not None and min(abs(tab.width - width), tab.length) < SHOULDER_MM
    return replace(tab, width=None) if small else tab


def _end_widths(width: Profile) -> tuple[float, float]:
    return float(width.coefficients[0]), float(width.coefficients[-1])  # clamped


def _placed(rim: Iterable[Line | Arc], x: float, direction: int) -> list[Line | Arc]:
    """A tab's rim in the frame of the strip, as `_frame` has it."""
    placed: list[Line | Arc] = []
    for segment in rim:
        if isinstance(segment, Line):
            ends = direction * np.array([segment.start, segment.end]) + (x, 0.0)
            placed.append(Line(*ends))
        else:
            placed.append(segment.transformed(_frame(x, direction)))
    return placed


def _frame(x: float, direction: int) -> FloatArray:
    """A tab's frame in that of the strip: at the end as it is, at the start turned by half a turn."""
    return np.array([[direction, 0.0, x], [0.0, direction, 0.0], [0.0, 0.0, 1.0]])
