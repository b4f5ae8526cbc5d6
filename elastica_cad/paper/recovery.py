"""Algorithms of the paper that move control points, to reduce the stiffness ratio (section 7.2) or to make the
rod stable (section 6.4)."""

from dataclasses import dataclass
from enum import Enum

from elastica_cad._values import is_number
from elastica_cad.errors import InputError
from elastica_cad.form_finding.equilibrium_curve import BothEnds, kept
from elastica_cad.geometry.path import largest_deviation
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.mechanics.loads import require_curve, require_ratio
from elastica_cad.paper.control_points import Bounds, Route, RouteStep, move_within


class RatioStatus(Enum):
    """Outcome of `optimize_ratio`."""

    REACHED = "The stiffness ratio is within the target."
    UNREACHABLE = (
        "No small move of the control points lowers the stiffness ratio any further: give up the tangents or "
        "the length, allow a larger ratio, or give the curve more control points."
    )
    OUT_OF_STEPS = "The steps were used up before the target ratio was reached: allow more of them."


@dataclass(frozen=True, eq=False)
class OptimizedRatio:
    """Result of `optimize_ratio`.

    Attributes
    ----------
    curve : PlaneCurve
        Realizable curve with the same knots and moved control points.
    ratio : float
        Ratio of largest to least stiffness of the continuous curve.
    deviation : float
        Largest distance of points of the curve from the drawn curve, mm.
    status : RatioStatus
    iterations : int
        Number of attempted steps.
    history : tuple of RouteStep
        Ratio and distance of the start and of every accepted step.
    """

    curve: PlaneCurve
    ratio: float
    deviation: float
    status: RatioStatus
    iterations: int
    history: tuple[RouteStep, ...]


def optimize_ratio(
    curve: PlaneCurve,
    target: float,
    *,
    ends: BothEnds = True,
    tangents: BothEnds = False,
    length: bool = False,
    max_steps: int = 100,
) -> OptimizedRatio:
    """Return the curve after the least move of its control points to a stiffness ratio of at most `target`.

    A local step reduces the ratio to the target and keeps the curve close to the drawn curve, to first order
    within a trust region. A global step finds the inflection line of least ratio (paper, Eq. 4). The ratio is
    that of the continuous curve, so the target is also a limit between samples.

    Parameters
    ----------
    curve : PlaneCurve
        Curve that is at least approximately realizable; its inflections are first moved onto a line.
    target : float
        Largest ratio, at least 1.
    ends, tangents : bool or (bool, bool)
        True to keep the drawn end points and the drawn end tangents, for both ends or for (start, end).
    length : bool
        True to keep the arc length.

    Raises
    ------
    NotRealizable
        The drawn curve is far from all shapes that a strip can have; use `nearest_rod` or `split`.
    InputError
        The target is below 1, or the curve is straight, closed or kinked.

    References
    ----------
    Paper, section 7.2.

    Examples
    --------
    >>> arch = PlaneCurve.spline([(0, 0), (0, 90), (50, 120), (100, 90), (100, 0)], degree=4)
    >>> found = optimize_ratio(arch, 1.2)
    >>> found.ratio <= 1.2, found.status.name
    (True, 'REACHED')
    """
    require_ratio(target, "target ratio")
    require_curve(curve)
    constraints = kept(curve, ends=ends, tangents=tangents, length=length)
    route = move_within(curve, Bounds(float(target)), constraints, max_steps=max_steps)
    if route.within:
        status = RatioStatus.REACHED
    else:
        status = RatioStatus.UNREACHABLE if route.settled else RatioStatus.OUT_OF_STEPS
    best = route.state.curve
    return OptimizedRatio(
        best, route.state.ratio, largest_deviation(curve, best), status, route.iterations, route.history
    )


class RecoveryStatus(Enum):
    """Outcome of `recover_stability`."""

    STABLE = "The curve is stable with the margin asked for, within the stiffness ratio."
    BARELY_STABLE = (
        "The curve is stable, but not with the margin asked for: allow a larger stiffness ratio, or give up "
        "the tangents or the length."
    )
    UNSTABLE = (
        "The curve cannot be made stable by small moves of its control points: allow a larger stiffness ratio, "
        "give up the tangents or the length, or support the strip in between."
    )
    TOO_STIFF = (
        "The stiffness ratio cannot be brought within its limit by small moves of the control points: allow a "
        "larger one, or give up the tangents or the length."
    )
    OUT_OF_STEPS = "The steps were used up on the way: allow more of them."


@dataclass(frozen=True, eq=False)
class RecoveredStability:
    """Result of `recover_stability`.

    Attributes
    ----------
    curve : PlaneCurve
        Realizable curve with the same knots and moved control points.
    margin : float
        Stability margin as in `stability`; positive means stable.
    ratio : float
        Ratio of largest to least stiffness of the continuous curve.
    deviation : float
        Largest distance of points of the curve from the drawn curve, mm.
    status : RecoveryStatus
    iterations : int
        Number of attempted steps.
    history : tuple of RouteStep
        Ratio, margin and distance of the start and of every accepted step.
    """

    curve: PlaneCurve
    margin: float
    ratio: float
    deviation: float
    status: RecoveryStatus
    iterations: int
    history: tuple[RouteStep, ...]


def recover_stability(
    curve: PlaneCurve,
    *,
    R_max: float = 3.0,
    margin: float = 5.0,
    ends: BothEnds = True,
    tangents: BothEnds = True,
    length: bool = True,
    max_steps: int = 100,
) -> RecoveredStability:
    """Return the curve whose control points are moved as little as possible to a stable rest shape.

    As in Algorithm 2 of the paper, stiffness, force and stability are computed from the control points, and
    every intermediate curve is an equilibrium. The paper moves the conjugate point beyond the end. Here the
    lowest eigenvalue of the second variation is increased to `margin`, because it is a smooth function near
    the limit of stability. The ratio of the continuous curve is bounded.

    Parameters
    ----------
    curve : PlaneCurve
        Curve that is at least approximately realizable; its inflections are first moved onto a line.
    R_max : float
        Largest stiffness ratio, at least 1; the bound prevents flat points at inflections.
    margin : float
        Least stability margin. A rod is stable above 0, and safely stable from 5.
    ends, tangents : bool or (bool, bool)
        True to keep the drawn end points and the drawn end tangents, for both ends or for (start, end).
    length : bool
        True to keep the arc length.

    Raises
    ------
    NotRealizable
        The drawn curve is far from all shapes that a strip can have; use `nearest_rod` or `split`.
    InputError
        The ratio is below 1, the margin is not a number, or the curve is straight, closed or kinked.

    References
    ----------
    Paper, section 6.4.

    Examples
    --------
    >>> arch = PlaneCurve.spline([(0, 0), (0, 90), (50, 120), (100, 90), (100, 0)], degree=4)
    >>> recover_stability(arch).status.name
    'STABLE'
    """
    require_ratio(R_max, "R_max")
    if not is_number(margin):
        raise InputError(
            f"margin (the least stability margin) is {margin!r}: give a number, such as 5; "
            "0 is the limit of stability"
        )
    require_curve(curve)
    constraints = kept(curve, ends=ends, tangents=tangents, length=length)
    route = move_within(curve, Bounds(float(R_max), float(margin)), constraints, max_steps=max_steps)
    state = route.state
    return RecoveredStability(
        state.curve, state.margin, state.ratio, largest_deviation(curve, state.curve), _status(route, R_max),
        route.iterations, route.history,
    )  # fmt: skip


def _status(route: Route, R_max: float) -> RecoveryStatus:
    if route.within:
        return RecoveryStatus.STABLE
    if not route.settled:
        return RecoveryStatus.OUT_OF_STEPS
    if route.state.ratio > R_max:
        return RecoveryStatus.TOO_STIFF
    return RecoveryStatus.BARELY_STABLE if route.state.margin > 0 else RecoveryStatus.UNSTABLE
