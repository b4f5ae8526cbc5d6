"""Moves of a single control point: the small move that makes a curve possible, and the farthest possible drag."""

from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass
from functools import partial
from typing import TypeVar

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import ElasticaError
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.geometry.plane_points import norm, unit_vectors
from elastica_cad.mechanics.loads import ExcessCurvature, NaturalCurvature, Supports
from elastica_cad.mechanics.moment_conditions import RodRequest
from elastica_cad.mechanics.optimal_balance import ratio_within
from elastica_cad.mechanics.support_search import MOST_RATIO

Found = TypeVar("Found")

MOST_POINTS = 30
"""Largest number of control points of a curve whose points are moved."""

DIRECTIONS = 16
"""Number of evenly spaced directions in which a control point is moved."""

SHARES = (0.1, 0.25, 0.5, 1.0)
"""Distances by which a control point is moved, as fractions of the largest allowed distance."""

ON_LINE = 3
"""Number of inflections that moving a single control point can bring onto a common line."""

TO_LINE, TO_RATIO = 14, 4
"""Numbers of bisections: to bring inflections onto a line, and to reduce the stiffness ratio to its limit."""

ROUNDING = 1e-5
"""Precision of a moved control point, as a fraction of the length of the curve."""

ALL_DIRECTIONS = slice(3)
"""Directions in which `move_while_possible` searches: straight to the end point, along x and along y."""


def move_one_point(
    curve: PlaneCurve,
    farthest: float,
    supports: Supports | None = None,
    natural_curvature: NaturalCurvature = 0.0,
) -> Iterator[tuple[int, PlaneCurve]]:
    """Yield possible curves that differ from an impossible curve in one control point.

    Every inner control point is moved in 16 directions by four distances, small moves first, and then each end. If
    three inflections become collinear between two of these distances, bisection finds the distance. A curve is
    possible if a rod without weight has a stiffness ratio up to 8. The stability of the rod is not computed.

    Parameters
    ----------
    curve : PlaneCurve
        Impossible curve, mm. There is no result for a closed curve, a curve that was fitted to points, or a curve
        with more than 30 control points.
    farthest : float
        Largest distance, mm, between the drawn and the possible curve; three times this value if an end is moved.
    supports : Supports, optional
        By default both ends are clamped.
    natural_curvature : float or RestCurvature
        Curvature of the unloaded strip, 1/mm.

    Yields
    ------
    index, curve : int, PlaneCurve
        Index of the control point, from 0, and the possible curve.

    Examples
    --------
    >>> points = [(0, 20), (60, 20), (120, 40), (180, -20), (240, 50), (300, -50)]
    >>> curve = PlaneCurve.spline(points, degree=5)
    >>> index, moved = next(move_one_point(curve, farthest=10))
    >>> index, moved.control_points[index].round().tolist()
    (3, [180.0, 6.0])
    """
    points, provenance = curve.control_points, curve.provenance
    if (
        len(points) > MOST_POINTS
        or curve.is_closed
        or (provenance is not None and provenance.measured is not None)
    ):
        return

    def possible(move: _Move, share: float) -> bool:
        with suppress(ElasticaError):
            request = RodRequest(
                move.at(share), supports=supports or Supports(), natural_curvature=natural_curvature
            )
            return ratio_within(request, MOST_RATIO) is not None
        return False

    directions = unit_vectors(2 * np.pi * np.arange(DIRECTIONS) / DIRECTIONS)
    weights = curve.basis(np.linspace(*curve.domain, 201)).max(
        axis=0
    )  # largest value of the basis function of each control point
    ends = 0, len(points) - 1
    inner = range(1, len(points) - 1)
    zeros = [zero.t for zero in ExcessCurvature(curve, natural_curvature).zeros]

    def may_help(index: int) -> bool:
        # inflections beyond the reach of a control point stay where they are
        low, high = curve.knots[index], curve.knots[index + curve.degree + 1]
        return sum(not low <= t <= high for t in zeros) <= ON_LINE

    # ends may move farther than inner control points
    for indices, reach in ((inner, farthest), (ends, 3.0 * farthest)):
        moves = [
            _Move(curve, index, direction * reach / weights[index], natural_curvature)
            for index in filter(may_help, indices)
            for direction in directions
        ]
        # last tried fraction of each move, with the signed area of its three inflections
        before = [(0.0, move.side(0.0)[1]) for move in moves]
        for share in SHARES:
            results = []
            for k, move in enumerate(moves):
                (last, side), (count, now) = before[k], move.side(share)
                before[k] = share, now
                if side * now < 0:  # the inflections were on one line between the two fractions
                    least = _bisected(last, share, TO_LINE, partial(move.is_beside, now))
                    if possible(move, least):
                        results.append((least, move))
                elif count < ON_LINE and possible(move, share):
                    least = _bisected(last, share, TO_RATIO, partial(possible, move))
                    results.append((least, move))
            for least, move in sorted(results, key=lambda pair: pair[0]):
                yield move.index, move.at(least)


def move_while_possible(
    start: FloatArray,
    end: FloatArray,
    possible: Callable[[FloatArray], Found | None],
    step: float,
    halvings: int,
    directions: slice = ALL_DIRECTIONS,
) -> Found | None:
    """Return the result of `possible` for a possible place that is close to an impossible `end`.

    Places are tried along the straight line to `end`, and then along x and y if no place is possible. The search
    stops within `step` of the limit of the possible places, or after `halvings` trials. To reach the limit, repeat
    the call from the result.

    Parameters
    ----------
    start, end : ndarray, shape (2,) or (n, 2)
        Possible start and impossible end: one place each, or n places that move together.
    possible : callable
        Returns a result for a possible place, and None for an impossible place.
    step : float
        Distance below which two places count as the same.
    halvings : int
        Largest number of trials after the first in each direction.
    directions : slice
        Directions that are tried: 0 is the straight line, 1 its longer and 2 its shorter component along x or y.

    Examples
    --------
    >>> def within(place):
    ...     return place if np.hypot(*place) < 10 else None
    >>> move_while_possible(np.zeros(2), np.array([30.0, 40.0]), within, 0.1, 9).round(1).tolist()
    [6.0, 8.0]
    """
    displacement = end - start
    axes = np.eye(2)[(-np.abs(displacement).reshape(-1, 2).max(axis=0)).argsort()]
    for along in (displacement, *(displacement * axis for axis in axes))[directions]:
        size = float(norm(along).max())
        if size <= step:
            continue
        if along is not displacement and (best := possible(start + along)) is not None:
            return best
        low, high, best = step, size, possible(start + step / size * along)
        for _ in range(halvings if best is not None else 0):
            if high - low <= step:
                break
            middle = float(np.sqrt(low * high))
            result = possible(start + middle / size * along)
            low, high, best = (low, middle, best) if result is None else (middle, high, result)
        if best is not None:
            return best
    return None


@dataclass(frozen=True)
class _Move:
    """Move of the control point `index` of a curve along `step` (2,), mm."""

    curve: PlaneCurve
    index: int
    step: FloatArray
    natural_curvature: NaturalCurvature

    def at(self, share: float) -> PlaneCurve:
        points = self.curve.control_points.copy()
        # round to a power of ten, so that the coordinates have few digits
        unit = 10 ** np.floor(np.log10(ROUNDING * self.curve.length))
        points[self.index] = np.round((points[self.index] + share * self.step) / unit) * unit
        return self.curve.with_control_points(points)

    def side(self, share: float) -> tuple[int, float]:
        """Return the number of inflections after a move by `share` times the step, and a signed area, mm2.

        Three inflections form a triangle with this area; for another number of inflections the area is 0.
        """
        try:
            moved = self.at(share)
            zeros = ExcessCurvature(moved, self.natural_curvature).zeros
        except ElasticaError:
            return ON_LINE + 1, 0.0
        if len(zeros) != ON_LINE:
            return len(zeros), 0.0
        a, b, c = moved.evaluate([zero.t for zero in zeros])
        return ON_LINE, float(np.linalg.det([b - a, c - a])) / 2

    def is_beside(self, side: float, share: float) -> bool:
        return self.side(share)[1] * side > 0


def _bisected(low: float, high: float, times: int, reached: Callable[[float], bool]) -> float:
    """Return a value just above the point at which `reached` becomes True."""
    for _ in range(times):
        middle = (low + high) / 2
        low, high = (low, middle) if reached(middle) else (middle, high)
    return high
