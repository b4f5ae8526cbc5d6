"""Moves of control points as in the paper: to restore constraints, to reduce the stiffness ratio (section 7.2),
or to make the rod stable (section 6.4).
"""

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass
from enum import Enum

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import FloatArray, IntArray
from elastica_cad._values import is_number, is_whole, require_record
from elastica_cad.errors import InputError, NotConvergedError
from elastica_cad.form_finding.equilibrium_curve import BothEnds, EquilibriumCurve, collinear, kept
from elastica_cad.form_finding.quadratic_program import QuadraticProgram, solve_quadratic
from elastica_cad.geometry.control_point_constraints import (
    Constraint,
    InflectionsOnLine,
    curvature_rows,
    directed_rows,
    least_norm_newton,
)
from elastica_cad.geometry.path import largest_deviation
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.geometry.plane_points import left_of
from elastica_cad.geometry.polynomials import LEFT, WEIGHTS, PanelFunction
from elastica_cad.mechanics.equilibrium_check import largest_move
from elastica_cad.mechanics.loads import require_curve, require_ratio
from elastica_cad.mechanics.theorem1 import InflectionLine, NotRealizable

# weight of a displacement along the curve, relative to a displacement across the curve
_ALONG = 0.1
# in the norm of a move, a curvature change 1 / length counts like a move by this fraction of the length
_BEND = 0.005
# in the norm of a move, a doubled parametric speed counts like a move by this fraction of the length
_STRETCH = 0.05
# in the norm of a move, a change of the moment by its largest value counts like a move by this fraction of the
# length
_LINE_STEP = 0.02
# relative size of singular values below which conditions count as dependent
_RANK = 1e-11


@dataclass(frozen=True, eq=False)
class CurveChanges:
    """First-order changes of an equilibrium curve as linear functions of r coordinates u.

    The norm of u is about the root mean square move of the curve. The scale of the moment is fixed, so that the
    stiffness K can increase or decrease.

    Parameters
    ----------
    state : EquilibriumCurve
        Curve with its equilibrium.
    constraints : sequence of Constraint
        Constraints in addition to inflections on a line.
    """

    state: EquilibriumCurve
    constraints: Sequence[Constraint]

    @cached_property
    def _t(self) -> FloatArray:
        """Parameters of the Gauss nodes, which are never at an inflection."""
        return self.state.balance.panels.t.ravel()

    @cached_property
    def distance_rows(self) -> FloatArray:
        """Matrix R (2 g, 2 m) for g Gauss nodes and m control points.

        If `move` contains the displacements x and y of all control points, the squared norm of R @ move is the
        weighted mean square displacement of the curve. The first g rows are displacements across the curve, the
        others displacements along the curve times `_ALONG`.
        """
        basis = self.state.curve.basis(self._t)
        return np.concatenate([directed_rows(basis, d) for d in self._frame])

    @cached_property
    def _tangent(self) -> FloatArray:
        d1 = self.state.curve.evaluate(self._t, 1)
        return np.asarray(d1 / np.linalg.norm(d1, axis=1, keepdims=True))

    @cached_property
    def _frame(self) -> tuple[FloatArray, FloatArray]:
        """Directions across and along the curve, times the weights of displacements."""
        along = self._root_weights * self._tangent
        return left_of(along), _ALONG * along

    @cached_property
    def _root_weights(self) -> FloatArray:
        panels = self.state.balance.panels
        return np.sqrt((panels.stretch * WEIGHTS).ravel() / self.state.curve.length)[:, None]

    def offsets(self, target: PlaneCurve) -> FloatArray:
        """Return the distances (2 g,) from `target` at equal parameters, weighted as in `distance_rows`."""
        off = self.state.curve.evaluate(self._t) - target.evaluate(self._t)
        return np.concatenate([(off * d).sum(axis=1) for d in self._frame])

    @cached_property
    def basis(self) -> FloatArray:
        """Matrix (2 m + 3, r). Each column is a change of curve and inflection line that the constraints allow.

        The first 2 m rows are changes of the m control points: x and y of the first point, then of the second
        point, and so on. The last three rows are changes of a, b_x and b_y of the line a + <b, x> = 0.
        """
        curve = self.state.curve
        a, b = self.state.line
        count = curve.control_points.size
        zeros = np.array([z.t for z in self.state.check.zeros])
        rows = [np.pad(c.equations(curve)[1], ((0, 0), (0, 3))) for c in self.constraints]
        if zeros.size:
            _, moved = InflectionsOnLine(a, b, zeros).equations(curve)
            rows.append(np.column_stack([moved, np.ones(zeros.size), curve.evaluate(zeros)]))
        position, length = curve.evaluate(self._t), curve.length
        size, centre = np.abs(a + position @ b).max(), position.mean(axis=0)
        # matrix from the scaled moment and its gradient at the curve's centre to a, b_x and b_y of the line
        line = np.array(
            [[1.0, -centre[0] / length, -centre[1] / length], [0, 1 / length, 0], [0, 0, 1 / length]]
        )
        line *= size / (_LINE_STEP * length)
        # fix the scale of the moment: the change of the scaled line is perpendicular to the scaled line
        inverse = np.linalg.inv(line)
        rows.append(np.concatenate([np.zeros(count), inverse @ [a, *b] @ inverse])[None])
        bends = curvature_rows(curve, self._t) * (self._root_weights * _BEND * length**2)
        d1, slope = curve.evaluate(self._t, 1), curve.basis(self._t, 1)
        stretch_weights = self._root_weights * (_STRETCH * length) / (d1**2).sum(axis=1, keepdims=True)
        stretches = np.concatenate([directed_rows(slope, d * stretch_weights) for d in (d1, left_of(d1))])
        metric = np.concatenate([self.distance_rows, bends, stretches])
        gram = metric.T @ metric
        gram.flat[:: count + 1] += 1e-12 * np.trace(gram)
        to_moves = np.zeros((count + 3, count + 3))
        to_moves[:count, :count] = np.linalg.inv(np.linalg.cholesky(gram)).T
        to_moves[count:, count:] = line
        scaled = np.concatenate(rows) @ to_moves
        scaled /= np.linalg.norm(scaled, axis=1, keepdims=True)
        _, sizes, vt = np.linalg.svd(scaled)
        rank = int((sizes > _RANK * sizes[0]).sum())
        return np.asarray(to_moves @ vt[rank:].T)

    @property
    def moves(self) -> FloatArray:
        """Moves (2 m, r) of the control points, in the rows of `basis`."""
        return self.basis[:-3]

    @cached_property
    def compliance(self) -> PanelFunction:
        """Derivatives (r,) of the compliance C = 1/K = kappa / M with respect to u, at fixed parameters.

        They are dC = (d kappa - C dM) / M, with curvature kappa and moment M. At an inflection, numerator and
        denominator are zero, and a polynomial through the Gauss nodes interpolates the quotient.
        """
        state, curve = self.state, self.state.curve
        _, b = state.line
        panels = state.balance.panels
        position = curve.evaluate(self._t)
        across = directed_rows(curve.basis(self._t), np.broadcast_to(b, position.shape))
        moment = np.column_stack([across, np.ones(len(position)), position]) @ self.basis
        kappa = curvature_rows(curve, self._t) @ self.moves
        K, M = (function.nodal.ravel() for function in (state.balance.stiffness, state.balance.moment))
        C, M = state.scale / K, M / state.scale
        change = (kappa - C[:, None] * moment) / M[:, None]
        return PanelFunction.through(change.reshape(*panels.t.shape, -1))

    @cached_property
    def _stretching(self) -> tuple[PanelFunction, FloatArray, FloatArray]:
        """Derivatives of arc lengths by the r coordinates u of a change of the curve.

        The function is measured from the left end of each panel. The arrays are measured from the start of the
        curve: to the left ends of the N panels (N, r), and to the end of the curve (r,).
        """
        panels, curve = self.state.balance.panels, self.state.curve
        rate = directed_rows(curve.basis(self._t, 1), self._tangent) @ self.moves
        rate = rate.reshape(*panels.t.shape, -1) * (np.diff(panels.edges) / 2)[:, None, None]
        within = np.einsum("ij,njr->nir", LEFT, rate)
        whole = np.cumsum(np.einsum("j,njr->nr", WEIGHTS, rate), axis=0)
        return (
            PanelFunction.through(within),
            np.concatenate([np.zeros((1, whole.shape[1])), whole[:-1]]),
            whole[-1],
        )

    @cached_property
    def margin(self) -> FloatArray:
        """Derivatives (r,) of the stability margin with respect to the parameters u, for a constant moment."""
        state, rod, nodes = self.state, self.state.rod, self.state.nodes
        panels, curve = state.balance.panels, state.curve
        panel, x = panels.locate(nodes.t)
        along, before, length = self._stretching
        d1 = curve.evaluate(nodes.t, 1)
        speed = np.linalg.norm(d1, axis=1)
        fractions = np.linspace(0.0, 1.0, nodes.t.size)
        # the nodes also move along the curve, because they remain at equal distances
        slide = (fractions[:, None] * length - before[panel] - along.at(panel, x)) / speed[:, None]
        half = (np.diff(panels.edges) / 2)[panel]
        K_slope = state.balance.stiffness.slope_at(panel, x) / (state.scale * half)
        K = -(rod.stiffness**2)[:, None] * self.compliance.at(panel, x) + K_slope[:, None] * slide
        moved = np.stack([curve.basis(nodes.t) @ self.moves[k::2] for k in (0, 1)], axis=1)
        moved += d1[:, :, None] * slide[:, None, :]
        edge = np.diff(nodes.position, axis=0)
        turning = left_of(edge) / (edge**2).sum(axis=1)[:, None]
        angles = np.einsum("nk,nkr->nr", turning, np.diff(moved, axis=0))
        db = self.basis[-2:]
        by = rod.margin_derivatives
        force = by.force.sum(axis=0) @ np.stack([-db[1], db[0]])
        return np.asarray(by.stiffness @ K + by.angles @ angles + force + by.length * length)


# penalty of a violated bound, relative to half the mean square distance from the drawn curve
_PENALTY = 0.1
# a missing stability margin is divided by this value to obtain its violation
_MARGIN_UNIT = 50.0
# aims of a step: factor on the present stiffness ratio, and addition to the present stability margin
_RATIO_PART, _MARGIN_PART = 0.9, 6.0
# initial, largest and smallest radius of the trust region, as a fraction of the curve's length
_RADIUS, _LARGEST_RADIUS, _SMALLEST_RADIUS = 0.01, 0.05, 1e-7
# a search ends at a smaller predicted gain of a step, as a fraction of half the mean square distance
_SETTLED = 1e-3
# relative distance from the bounds at the samples, so that bounds also hold between the samples
_INSIDE = 1e-5
_ENFORCED = 1e-11
"""Largest error of a satisfied constraint, as a fraction of the length of the curve or in rad."""

# largest number of rounds that add samples where a step would violate the bounds
_ROUNDS = 12


@dataclass(frozen=True)
class Bounds:
    """Largest stiffness ratio and least stability margin (None for no bound)."""

    ratio: float
    margin: float | None = None

    def broken(self, state: EquilibriumCurve) -> float:
        """Return the violation of the bounds.

        The violation of the ratio is 1/bound - 1/ratio. The missing margin divided by `_MARGIN_UNIT` is added.
        """
        excess = max(0.0, 1 / self.ratio - 1 / state.ratio)
        if self.margin is None:
            return excess
        return excess + max(0.0, (self.margin - state.margin) / _MARGIN_UNIT)

    def from_here(self, state: EquilibriumCurve) -> "Bounds":
        """Return bounds for the next step, between the present values and these bounds.

        Such small steps lead to the nearest of many minima.
        """
        ratio = max(self.ratio, _RATIO_PART * state.ratio)
        if self.margin is None:
            return Bounds(ratio)
        return Bounds(ratio, min(self.margin, state.margin + _MARGIN_PART))

    def inside(self) -> "Bounds":
        """Return slightly stricter bounds, so that these bounds are also satisfied between the samples."""
        ratio = 1 + (self.ratio - 1) * (1 - _INSIDE)
        return Bounds(ratio, None if self.margin is None else self.margin + _INSIDE * _MARGIN_UNIT)


@dataclass(frozen=True)
class RouteStep:
    """Accepted curve of a search.

    Attributes
    ----------
    ratio : float
        Ratio of largest to least stiffness.
    margin : float or None
        Stability margin, if it has a bound.
    distance : float
        Root mean square distance from the drawn curve, mm.
    """

    ratio: float
    margin: float | None
    distance: float


def _move_within(
    curve: PlaneCurve, bounds: Bounds, constraints: Sequence[Constraint], *, max_steps: int
) -> tuple[EquilibriumCurve, bool, int, tuple[RouteStep, ...]]:
    """Return the curve near `curve` whose stiffness ratio and stability margin are within bounds.

    If no such curve is found, return the curve with the least violation. The other results are True if the search
    converged within the allowed steps, the number of attempted steps, and the start with all accepted curves.

    Raises
    ------
    NotRealizable
        No strip can take the initial curve, even after its inflections were moved onto a line.
    """
    if not (is_whole(max_steps) and max_steps >= 1):
        raise InputError(f"max_steps is {max_steps!r}: allow at least one step")
    start = curve
    with suppress(NotConvergedError):
        start, _ = least_norm_newton(curve, [*constraints, *collinear(curve)], tolerance=_ENFORCED)
    state = EquilibriumCurve.of(start)
    changes = CurveChanges(state, constraints)
    radius, settled, iterations = _RADIUS, False, 0
    distance = _half_square(changes, curve)
    history = [_route_step(state, distance, bounds)]
    while iterations < max_steps and not settled:
        iterations += 1
        aim = bounds.inside().from_here(state)
        points, size, promised = _step(changes, changes.offsets(curve) / state.curve.length, aim, radius)
        gain = distance + _PENALTY * aim.broken(state) - promised
        # a smaller gain is a rounding error
        settled = gain <= 1e-12 + (_SETTLED * distance if bounds.broken(state) == 0 else 0.0)
        if settled:
            break
        moved = _state_after(state.curve, points, constraints)
        if moved is not None:
            further = CurveChanges(moved, constraints)
            new_distance = _half_square(further, curve)
            achieved = distance + _PENALTY * (aim.broken(state) - aim.broken(moved)) - new_distance
            coarse = moved.ratio > 3.0 * max(state.ratio, bounds.ratio)
            # trust region: accept a step with a small part of the predicted gain, and widen it after a good step
            if achieved > 0.05 * gain and not coarse:
                state, changes, distance = moved, further, new_distance
                history.append(_route_step(state, distance, bounds))
                radius = min(2 * radius, _LARGEST_RADIUS) if achieved > 0.7 * gain else radius
                continue
        radius = min(radius, size) / 3
        if radius < _SMALLEST_RADIUS:
            settled = True
    return state, settled, iterations, tuple(history)


def _route_step(state: EquilibriumCurve, half_square: float, bounds: Bounds) -> RouteStep:
    margin = None if bounds.margin is None else state.margin
    return RouteStep(state.ratio, margin, float(np.sqrt(2 * half_square)) * state.curve.length)


def _half_square(changes: CurveChanges, target: PlaneCurve) -> float:
    return 0.5 * float((changes.offsets(target) ** 2).sum()) / changes.state.curve.length**2


def _state_after(
    curve: PlaneCurve, points: FloatArray, constraints: Sequence[Constraint]
) -> EquilibriumCurve | None:
    try:
        moved = curve.with_control_points(curve.control_points + points)
        moved, _ = least_norm_newton(moved, [*constraints, *collinear(moved)], tolerance=_ENFORCED)
        return EquilibriumCurve.of(moved)
    except (NotRealizable, NotConvergedError, InputError):
        return None


def _step(
    changes: CurveChanges, offsets: FloatArray, aim: Bounds, radius: float
) -> tuple[FloatArray, float, float]:
    """Return the step within `radius` that has the least objective to first order.

    The results are the displacements (m, 2) of the control points, mm, their size relative to the length, and the
    predicted objective.

    The objective is half the mean square distance from the drawn curve, divided by the squared length, plus
    penalties for violations of the bounds `aim`. `offsets` (2 g,) are `CurveChanges.offsets` divided by the length.

    The unknowns are the coordinates u of the move divided by the length, the largest compliance c = 1 / min
    K, and the slacks of the two bounds.
    """
    length = changes.state.curve.length
    J = changes.distance_rows @ changes.moves
    r = J.shape[1]
    # compliances 1/K (n,) at the samples of the state, and their derivatives (n, r)
    C, dC = 1 / changes.state.stiffness, length * changes.compliance.at(*changes.state.places)
    # objective x^t H x / 2 + g x of the unknowns x
    H, g = np.zeros((r + 3, r + 3)), np.zeros(r + 3)
    H[:r, :r] = J.T @ J
    g[:r] = J.T @ offsets
    g[r + 1 :] = _PENALTY
    lower = np.concatenate([np.full(r, -radius), [0.1, 0.0, 0.0]])
    upper = np.concatenate([np.full(r, radius), [10.0, 2.0, 1e4]])

    ones, zeros = np.ones(C.size), np.zeros(C.size)
    # the compliance C + dC u after the move u is at least c / R - s for the largest ratio R, the largest compliance
    # c and the slack s, and at most c; the right-hand sides are in the last columns
    soft = np.column_stack([aim.ratio * dC, -ones, aim.ratio * ones, zeros, -aim.ratio * C])
    stiff = np.column_stack([-dC, ones, zeros, zeros, C])
    conditions = np.concatenate([soft[_peaks(-C)], stiff[_peaks(C)]])
    if aim.margin is not None:
        m, dm = changes.state.margin, changes.margin * length
        row = np.concatenate([dm, [m, 0.0, _MARGIN_UNIT, aim.margin]]) / _MARGIN_UNIT
        conditions = np.concatenate([conditions, row[None]])
    for _ in range(_ROUNDS):
        rows, right = conditions[:, :-1], conditions[:, -1]
        # the linear conditions have larger penalties than the bounds
        penalty, one_sided = np.full(right.size, 10.0), np.ones(right.size, dtype=bool)
        solution = solve_quadratic(
            QuadraticProgram(H, g, lower, upper, rows, right, penalty, one_sided), accuracy=1e-12
        )
        u, c, s = solution.x[:r], solution.x[r], solution.x[r + 1]
        compliances = C + dC @ u
        low = _peaks(c - aim.ratio * (compliances + s), above=1e-8)
        high = _peaks(compliances - c, above=1e-8)
        if not (low.size or high.size):
            break
        conditions = np.concatenate([conditions, soft[low], stiff[high]])
    promised = 0.5 * float(((J @ u + offsets) ** 2).sum()) + _PENALTY * float(solution.x[r + 1 :].sum())
    return (changes.moves @ u).reshape(-1, 2) * length, float(np.abs(u).max()), promised


def _peaks(values: FloatArray, above: float = -np.inf) -> IntArray:
    """Return the indices of the eight highest local maxima of values (n,) above a level."""
    padded = np.concatenate([[-np.inf], values, [-np.inf]])
    peaks = np.flatnonzero((values >= padded[:-2]) & (values >= padded[2:]) & (values > above))
    return peaks[np.argsort(-values[peaks], kind="stable")[:8]]


@dataclass(frozen=True, eq=False)
class EnforcedCurve:
    """Result of `enforce_constraints`.

    Attributes
    ----------
    curve : PlaneCurve
        Curve that satisfies the constraints.
    residuals : tuple of float
        Norm of the residuals at the start and after every step, mm.
    moved : float
        Largest distance between points of both curves at the same parameter, mm.
    """

    curve: PlaneCurve
    residuals: tuple[float, ...]
    moved: float


def enforce_constraints(
    curve: PlaneCurve,
    *,
    line: InflectionLine | None = None,
    ends: BothEnds = True,
    tangents: BothEnds = True,
    length: bool = True,
    like: PlaneCurve | None = None,
    tolerance: float = 1e-10,
    max_steps: int = 30,
) -> EnforcedCurve:
    """Move control points as little as possible, so that inflections are collinear and constraints are satisfied.

    Parameters
    ----------
    line : InflectionLine, optional
        Line for the inflections; by default the nearest line. Two inflections or fewer need no line.
    ends, tangents : bool or (bool, bool)
        True to keep the end points and the end tangents of `like`, for both ends or for (start, end).
    length : bool
        True to keep the arc length of `like`.
    like : PlaneCurve, optional
        Curve whose ends, tangents and length are restored; by default `curve` itself.
    tolerance : float
        Norm of all residuals, relative to the size of the curve, at which the iteration stops.

    Raises
    ------
    NotConvergedError
        The constraints contradict each other, or the number of inflections changes.

    References
    ----------
    Paper, Appendix C (underdetermined Newton).

    Examples
    --------
    >>> wave = PlaneCurve.spline([(0, 0), (20, 60), (40, -60), (60, 62), (80, -55), (100, 0)], degree=4)
    >>> enforced = enforce_constraints(wave)
    >>> abs(enforced.curve.length - wave.length) < 1e-6
    True
    """
    require_curve(curve)
    if like is not None:
        require_curve(like)
    require_record(line, InflectionLine | None, "line", "an InflectionLine, or None")
    if not (is_number(tolerance) and tolerance > 0):
        raise InputError(f"tolerance is {tolerance!r}: give a number above 0")
    constraints: list[Constraint] = [
        *kept(curve if like is None else like, ends=ends, tangents=tangents, length=length)
    ]
    if line is None:
        constraints += collinear(curve)
    else:
        t = np.array([z.t for z in curve.curvature_zeros if z.kind == "crossing"])
        if t.size:
            constraints.append(InflectionsOnLine(line.a, line.b, t))
    moved, residuals = least_norm_newton(curve, constraints, tolerance=tolerance, max_steps=max_steps)
    before, after = _inflections(curve), _inflections(moved)
    if after.size > before.size and (line is not None or after.size > 2):
        places = ", ".join(f"{s:.4g}" for s in after)
        raise NotConvergedError(
            f"the moved curve has {after.size} inflections (at {places} mm) instead of {before.size}: "
            "switch off `ends`, `tangents` or `length`, or use nearest_rod"
        )
    return EnforcedCurve(moved, residuals, largest_move(curve, moved))


def _inflections(curve: PlaneCurve) -> FloatArray:
    return np.array([z.s for z in curve.curvature_zeros if z.kind == "crossing"])


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
    bounds = Bounds(float(target))
    state, settled, iterations, history = _move_within(curve, bounds, constraints, max_steps=max_steps)
    if bounds.broken(state) == 0:
        status = RatioStatus.REACHED
    else:
        status = RatioStatus.UNREACHABLE if settled else RatioStatus.OUT_OF_STEPS
    deviation = largest_deviation(curve, state.curve)
    return OptimizedRatio(state.curve, state.ratio, deviation, status, iterations, history)


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
    bounds = Bounds(float(R_max), float(margin))
    state, settled, iterations, history = _move_within(curve, bounds, constraints, max_steps=max_steps)
    if bounds.broken(state) == 0:
        status = RecoveryStatus.STABLE
    elif not settled:
        status = RecoveryStatus.OUT_OF_STEPS
    elif state.ratio > R_max:
        status = RecoveryStatus.TOO_STIFF
    else:
        status = RecoveryStatus.BARELY_STABLE if state.margin > 0 else RecoveryStatus.UNSTABLE
    deviation = largest_deviation(curve, state.curve)
    return RecoveredStability(state.curve, state.margin, state.ratio, deviation, status, iterations, history)
