"""Moving the control points of a realizable curve until ratio and margin are within bounds.

The data flow of the paper's section 6.4, q -> curve -> (K, lambda) -> stability, with a convex program in
the place of its projected gradient: each step is the least total move from the drawn curve that meets the
bounds to first order within a trust region. After every step the constraints are enforced (Appendix C) and
the line of least ratio is found anew (the global step of section 7.2), so every iterate is an equilibrium.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.errors import InputError, NotConvergedError
from elastica_cad.forming.equilibrium_curve import EquilibriumCurve, collinear
from elastica_cad.forming.optimizer.quadratic_program import QuadraticProgram, solve_quadratic
from elastica_cad.geometry.curve_editing.control_point_constraints import Constraint, least_norm_newton
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.mechanics.theorem1.verdict import NotRealizable
from elastica_cad.published.curve_changes import CurveChanges

_PRICE = 0.1  # of a broken bound, against half the mean square distance in lengths: far above all multipliers
_ROW_PRICE = 10.0  # of a row of the step that cannot be met: above every bound's
_ACCURACY = 1e-12  # of a step, against the price: half a mean square distance of 1e-8 still counts
_MARGIN_UNIT = 50.0  # a margin missed by so much is badly missed
_COARSE = 3.0  # a step that takes the ratio this many times above where it is and may be is refused
_RATIO_PART, _MARGIN_PART = 0.9, 6.0  # aimed at in one step: of the present ratio, above the present margin
_RADIUS, _LARGEST_RADIUS, _SMALLEST_RADIUS = 0.01, 0.05, 1e-7  # of the trust region, in lengths of the curve
_SETTLED = 1e-3  # a step that promises less than this share of the distance ends the search
_RESOLUTION = 1e-12  # of half a mean square distance in lengths: smaller gains are rounding
_INSIDE = 1e-5  # aimed at inside the bounds, so that they hold between the samples too
_ENFORCED = 1e-11  # constraints missed by less hold, in lengths and radians
_ROUNDS = 12  # of adding the places where a step would break the bounds


@dataclass(frozen=True)
class Bounds:
    """Largest ratio and least margin (None: not asked for)."""

    ratio: float
    margin: float | None = None

    def broken(self, state: EquilibriumCurve) -> float:
        """What breaks the bounds, 0 when nothing does: 1/R - 1/R_now, and the margin in parts of a typical one."""
        excess = max(0.0, 1 / self.ratio - 1 / state.ratio)
        if self.margin is None:
            return excess
        return excess + max(0.0, (self.margin - state.margin) / _MARGIN_UNIT)

    def from_here(self, state: EquilibriumCurve) -> "Bounds":
        """What to aim at next: small parts of the way find the nearer ones of many minima."""
        ratio = max(self.ratio, _RATIO_PART * state.ratio)
        if self.margin is None:
            return Bounds(ratio)
        return Bounds(ratio, min(self.margin, state.margin + _MARGIN_PART))

    def inside(self) -> "Bounds":
        """A little stricter ones."""
        ratio = 1 + (self.ratio - 1) * (1 - _INSIDE)
        return Bounds(ratio, None if self.margin is None else self.margin + _INSIDE * _MARGIN_UNIT)


@dataclass(frozen=True)
class RouteStep:
    """One accepted curve on the way.

    Attributes
    ----------
    ratio : float
        R = max K / min K.
    margin : float or None
        Stability margin, where it was asked for.
    distance : float
        Root mean square distance from the drawn curve, mm.
    """

    ratio: float
    margin: float | None
    distance: float


@dataclass(frozen=True, eq=False)
class Route:
    """Where the search ended: the nearest curve within the bounds, or the one that breaks them least.

    Attributes
    ----------
    state : EquilibriumCurve
    within : bool
        Are the bounds met?
    settled : bool
        False when it ran out of steps.
    history : tuple of RouteStep
        The start and every accepted curve.
    iterations : int
        Steps tried.
    """

    state: EquilibriumCurve
    within: bool
    settled: bool
    history: tuple[RouteStep, ...]
    iterations: int


def move_within(
    curve: PlaneCurve, bounds: Bounds, constraints: Sequence[Constraint], *, max_steps: int
) -> Route:
    """The curve near `curve` whose ratio and margin are within bounds.

    Raises
    ------
    NotRealizable
        No strip can take the curve that this starts from, even once its inflections are on one line.
    """
    state = _started(curve, constraints)
    changes = CurveChanges(state, constraints)
    radius, settled, iterations = _RADIUS, False, 0
    distance = _half_square(changes, curve)
    history = [_route_step(state, distance, bounds)]
    while iterations < max_steps and not settled:
        iterations += 1
        aim = bounds.inside().from_here(state)
        step = _step(changes, changes.offsets(curve) / state.curve.length, aim, radius)
        gain = distance + _PRICE * aim.broken(state) - step.promised
        settled = gain <= _RESOLUTION + (_SETTLED * distance if bounds.broken(state) == 0 else 0.0)
        if settled:
            break
        moved = _moved(state.curve, step, constraints)
        if moved is not None:
            further = CurveChanges(moved, constraints)
            there = _half_square(further, curve)
            got = distance + _PRICE * (aim.broken(state) - aim.broken(moved)) - there
            coarse = moved.ratio > _COARSE * max(state.ratio, bounds.ratio)
            if got > 0.05 * gain and not coarse:
                state, changes, distance = moved, further, there
                history.append(_route_step(state, distance, bounds))
                radius = min(2 * radius, _LARGEST_RADIUS) if got > 0.7 * gain else radius
                continue
        radius = min(radius, step.size) / 3
        if radius < _SMALLEST_RADIUS:
            settled = True
    return Route(state, bounds.broken(state) == 0, settled, tuple(history), iterations)


def _route_step(state: EquilibriumCurve, half_square: float, bounds: Bounds) -> RouteStep:
    margin = None if bounds.margin is None else state.margin
    return RouteStep(state.ratio, margin, float(np.sqrt(2 * half_square)) * state.curve.length)


def _half_square(changes: CurveChanges, target: PlaneCurve) -> float:
    """Half the mean square distance, in lengths."""
    return 0.5 * float((changes.offsets(target) ** 2).sum()) / changes.state.curve.length**2


@dataclass(frozen=True, eq=False)
class _Step:
    """A move of the control points (m, 2), mm; its size in lengths; the merit that it promises."""

    points: FloatArray
    size: float
    promised: float


def _started(curve: PlaneCurve, constraints: Sequence[Constraint]) -> EquilibriumCurve:
    try:
        enforced, _ = least_norm_newton(curve, [*constraints, *collinear(curve)], tolerance=_ENFORCED)
    except NotConvergedError:
        enforced = curve
    return EquilibriumCurve.of(enforced)


def _moved(curve: PlaneCurve, step: _Step, constraints: Sequence[Constraint]) -> EquilibriumCurve | None:
    """The equilibrium after a step, or None where the step leaves the realizable curves."""
    try:
        moved = curve.with_control_points(curve.control_points + step.points)
        moved, _ = least_norm_newton(moved, [*constraints, *collinear(moved)], tolerance=_ENFORCED)
        return EquilibriumCurve.of(moved)
    except (NotRealizable, NotConvergedError, InputError):
        return None


def _step(changes: CurveChanges, offsets: FloatArray, aim: Bounds, radius: float) -> _Step:
    """The best step to first order.

    Unknowns: coordinates u of the move in lengths; the largest compliance c = 1 / min K; what is left of
    the two bounds.
    """
    length = changes.state.curve.length
    J = changes.distance_rows @ changes.basis[:-3]
    r = J.shape[1]
    C, dC = changes.watched()
    dC = dC * length
    H, g = np.zeros((r + 3, r + 3)), np.zeros(r + 3)
    H[:r, :r] = J.T @ J
    g[:r] = J.T @ offsets
    g[r + 1 :] = _PRICE
    lower = np.concatenate([np.full(r, -radius), [0.1, 0.0, 0.0]])
    upper = np.concatenate([np.full(r, radius), [10.0, 2.0, 1e4]])

    def soft(places: IntArray) -> tuple[FloatArray, FloatArray]:
        """R (C + dC u) - c + R s >= 0."""
        ones = np.ones((places.size, 1))
        rows = np.hstack([aim.ratio * dC[places], -ones, aim.ratio * ones, 0 * ones])
        return rows, -aim.ratio * C[places]

    def stiff(places: IntArray) -> tuple[FloatArray, FloatArray]:
        """c - (C + dC u) >= 0."""
        ones = np.ones((places.size, 1))
        return np.hstack([-dC[places], ones, 0 * ones, 0 * ones]), C[places]

    rows = [soft(_peaks(-C)), stiff(_peaks(C))]
    if aim.margin is not None:
        m, dm = changes.state.margin, changes.margin * length
        row = np.concatenate([dm, [m, 0.0, _MARGIN_UNIT]]) / _MARGIN_UNIT
        rows.append((row[None], np.array([aim.margin / _MARGIN_UNIT])))
    A, right = np.concatenate([a for a, _ in rows]), np.concatenate([b for _, b in rows])
    for _ in range(_ROUNDS):
        solution = solve_quadratic(
            QuadraticProgram(
                H, g, lower, upper, A, right, np.full(right.size, _ROW_PRICE), np.ones(right.size, dtype=bool)
            ),
            accuracy=_ACCURACY,
        )
        u, c, s = solution.x[:r], solution.x[r], solution.x[r + 1]
        there = C + dC @ u
        short = [
            (_peaks(c - aim.ratio * (there + s), above=1e-8), soft),
            (_peaks(there - c, above=1e-8), stiff),
        ]
        new = [make(places) for places, make in short if places.size]
        if not new:
            break
        A = np.concatenate([A, *(a for a, _ in new)])
        right = np.concatenate([right, *(b for _, b in new)])
    promised = 0.5 * float(((J @ u + offsets) ** 2).sum()) + _PRICE * float(solution.x[r + 1 :].sum())
    points = (changes.basis[:-3] @ u).reshape(-1, 2) * length
    return _Step(points, float(np.abs(u).max()), promised)


def _peaks(values: FloatArray, above: float = -np.inf) -> IntArray:
    """The highest eight local maxima of values (n,) that are above a level."""
    padded = np.concatenate([[-np.inf], values, [-np.inf]])
    found = np.flatnonzero((values >= padded[:-2]) & (values >= padded[2:]) & (values > above))
    return np.asarray(found[np.argsort(-values[found], kind="stable")[:8]])
