"""A smaller stiffness ratio by moving the control points of a drawn curve (paper, section 7.2)."""

from dataclasses import dataclass
from enum import Enum

from elastica_cad.forming.equilibrium_curve import BothEnds, kept
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.paths.point_distance import largest_deviation
from elastica_cad.mechanics.loads.arguments import require_curve, require_ratio
from elastica_cad.published.control_points import Bounds, RouteStep, move_within


class RatioStatus(Enum):
    """How `optimize_ratio` ended."""

    REACHED = "The stiffness ratio is within the target."
    UNREACHABLE = (
        "No small move of the control points lowers the stiffness ratio any further: give up the tangents or "
        "the length, allow a larger ratio, or give the curve more control points."
    )
    OUT_OF_STEPS = "The steps were used up before the target ratio was reached: allow more of them."


@dataclass(frozen=True, eq=False)
class OptimizedRatio:
    """What `optimize_ratio` found.

    Attributes
    ----------
    curve : PlaneCurve
        Same knots, control points moved; a strip can take it.
    ratio : float
        R = max K / min K of the continuous curve.
    deviation : float
        Largest distance of its points from the drawn curve, mm.
    status : RatioStatus
    iterations : int
        Steps tried.
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
    """Move the control points until the stiffness ratio is at most `target`, and the curve little else.

    Local step: the least total move from the drawn curve that brings R = max K / min K within the target to
    first order, in a trust region. Global step: the inflection line of least ratio (Eq. 4). The maximum and
    minimum are those of the continuous curve, so the target is hard.

    Parameters
    ----------
    curve : PlaneCurve
        One that a strip can take, or nearly so: inflections off the line are brought onto one first.
    target : float
        Largest ratio, at least 1.
    ends, tangents : bool or (bool, bool)
        Do end points and end tangents stay as they are drawn? Both, or (start, end).
    length : bool
        Does the arc length stay?

    Raises
    ------
    NotRealizable
        The drawn curve is far from all curves that a strip can take: use `nearest_rod` or `split`.
    InputError
        A target below 1, a straight, closed or kinked curve.

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
    found = route.state.curve
    return OptimizedRatio(
        found, route.state.ratio, largest_deviation(curve, found), status, route.iterations, route.history
    )
