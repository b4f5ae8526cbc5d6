"""Thousands of segments at one go: their points and derivatives, and the chords that follow them."""

from collections.abc import Callable, Hashable, Sequence
from typing import TypeAlias

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.geometry.paths.segments import (
    Arc,
    Line,
    Segment,
    Spline,
    first_places,
    halve_chords,
)

_Motion: TypeAlias = Callable[[IntArray, FloatArray, int], FloatArray]
"""Points (n, 2), or derivatives of that order by u, at places u (n,) of segments (n,) of one kind."""


class SegmentTable:
    """Segments of any kinds, evaluated together.

    Examples
    --------
    >>> table = SegmentTable([Line((0, 0), (4, 0)), Arc((0, 0), 2.0, 0.0, np.pi)])
    >>> table.at(np.array([0, 1]), np.array([0.5, 0.5])).round(6).tolist()
    [[2.0, 0.0], [0.0, 2.0]]
    """

    def __init__(self, segments: Sequence[Segment]) -> None:
        kinds: dict[Hashable, list[int]] = {}
        for i, segment in enumerate(segments):
            kinds.setdefault(_kind(segment), []).append(i)
        self._kind, self._number = np.empty((2, len(segments)), dtype=int)
        self._motions: list[_Motion] = []
        for k, members in enumerate(kinds.values()):
            self._kind[members], self._number[members] = k, np.arange(len(members))
            self._motions.append(_motion([segments[i] for i in members]))

    def at(self, which: IntArray, u: FloatArray, derivative: int = 0) -> FloatArray:
        """Points (n, 2), or first derivatives by u, mm, at places u (n,) in [0, 1] of segments (n,)."""
        found, kind = np.empty((which.size, 2)), self._kind[which]
        for k, motion in enumerate(self._motions):
            here = kind == k
            if here.any():
                found[here] = motion(self._number[which[here]], u[here], derivative)
        return found


def chords_of_all(segments: Sequence[Segment], tolerance: float) -> tuple[IntArray, FloatArray]:
    """The points of `chords` of every segment (n, 2), and the numbers (n,) of their segments."""
    places = [first_places(segment, tolerance) for segment in segments]
    which, u = np.repeat(np.arange(len(places)), [one.size for one in places]), np.concatenate(places)
    bent = np.array([isinstance(segment, Spline) for segment in segments])
    return halve_chords(SegmentTable(segments).at, which, u, bent[which], tolerance)[::2]


def _kind(segment: Segment) -> Hashable:
    """What segments have in common that are evaluated together: clamped splines without weights their degree."""
    if isinstance(segment, Spline):
        curve = segment.curve
        clamped = (curve.knots[0], curve.knots[-1]) == curve.domain
        return curve.degree if clamped and not curve.is_rational else segment
    return type(segment).__name__


def _motion(segments: Sequence[Segment]) -> _Motion:
    arcs = [segment for segment in segments if isinstance(segment, Arc)]
    if arcs:
        return _on_circles(arcs)
    lines = [segment for segment in segments if isinstance(segment, Line)]
    splines = [segment for segment in segments if isinstance(segment, Spline)]
    if lines:
        ends = [np.array([line.start, line.end]) for line in lines]
        return _on_splines([np.array([0.0, 0.0, 1.0, 1.0])] * len(lines), ends, 1)
    first = splines[0]
    if len(splines) == 1:
        return lambda _, u, derivative: first.velocity_at(u) if derivative else first.at(u)
    return _on_splines(
        [(one.curve.knots - one.curve.knots[0]) / np.ptp(one.curve.knots) for one in splines],
        [one.curve.control_points for one in splines],
        first.curve.degree,
    )


def _on_circles(arcs: Sequence[Arc]) -> _Motion:
    centers = np.array([arc.center for arc in arcs])
    radii, starts, sweeps = np.array([(arc.radius, arc.start_angle, arc.sweep) for arc in arcs]).T

    def motion(which: IntArray, u: FloatArray, derivative: int) -> FloatArray:
        angle = starts[which] + u * sweeps[which] + derivative * np.pi / 2
        out = np.column_stack([np.cos(angle), np.sin(angle)])
        out *= (radii[which] * sweeps[which] ** derivative)[:, None]
        return out if derivative else out + centers[which]

    return motion


def _on_splines(knots: Sequence[FloatArray], points: Sequence[FloatArray], degree: int) -> _Motion:
    """As one B-spline: the i-th, over clamped knots from 0 to 1, from 2 i to 2 i + 1, and nothing between."""
    from scipy.interpolate import BSpline

    nothing = np.zeros((degree + 1, 2))
    chain = [part for one in points for part in (one, nothing)][:-1]
    joined = BSpline(
        np.concatenate([2 * i + one for i, one in enumerate(knots)]), np.concatenate(chain), degree
    )

    def motion(which: IntArray, u: FloatArray, derivative: int) -> FloatArray:
        at = np.minimum(2.0 * which + u, np.nextafter(2.0 * which + 1, 0.0))
        return np.asarray(joined(at, nu=derivative), dtype=float)

    return motion
