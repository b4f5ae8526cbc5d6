"""Balance of a drawn curve as a linear map, its conditions, and the best stiffness that satisfies them.

On a drawn curve the rod's equations (paper, Eqs. 3 and 5)

    M' = <b, gamma'>,   b' = -(q K + p tau) R^t e,   K (kappa - kappa_0) = M

are linear in the state (M, b) at the end of the curve, so a single march for each of the three numbers is enough.
Here q is the weight per stiffness (1/l_eg^3), p a dead weight (N/mm), and tau the inverse of the least bending
stiffness; e points up. Rods without weight have constant b, and M = a + <b, gamma>.
"""

from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import NoReturn

import numpy as np

from elastica_cad._compiled_scipy import svd
from elastica_cad._types import FloatArray, IntArray
from elastica_cad._values import EqualByValue
from elastica_cad.errors import NotConvergedError
from elastica_cad.geometry.plane_curve import CurveSamples, PlaneCurve
from elastica_cad.geometry.polynomials import (
    DENSE_PARTS,
    LEFT,
    RIGHT,
    SLOPES,
    VANDER,
    WEIGHTS,
    PanelFunction,
    in_panels,
)
from elastica_cad.mechanics.equilibrium_check import examine
from elastica_cad.mechanics.loads import Gravity, NaturalCurvature, PointMass, Supports, Weight
from elastica_cad.mechanics.minimax_lp import (
    METHOD,
    MinimaxProgram,
    MinimaxSolution,
    largest_number,
    least_variation,
    minimax_ratio,
    start_rows,
    unsettled,
)
from elastica_cad.mechanics.moment_curvature import MaterialLaw
from elastica_cad.mechanics.quadrature_panels import CutCurve, Panels
from elastica_cad.mechanics.stiffness_law import BoundedLaw
from elastica_cad.mechanics.theorem1 import EquilibriumCheck, NotRealizable
from elastica_cad.refusals import Length, Listed, Span, note


@dataclass(frozen=True, eq=False)
class LineLoad:
    """Weight along a curve cut into panels.

    Attributes
    ----------
    up : (2,) array
        Unit vector against gravity.
    own : (N, p) array
        Weight per stiffness over the least bending stiffness, 1/mm3: 1/l_eg^3 for a plain strip.
    dead : (N, p) array
        Weight per length that does not depend on the stiffness, N/mm.
    points : (N + 1,) array
        Point weights at the panel ends, N.
    """

    up: FloatArray
    own: FloatArray
    dead: FloatArray
    points: FloatArray

    @property
    def is_proportional(self) -> bool:
        """Return True if the whole weight is proportional to the stiffness."""
        return not (self.dead.any() or self.points.any())


@dataclass(frozen=True, eq=False)
class MomentRows:
    """Rod as a linear map of the m numbers (M, b_x, b_y, and tau with dead weight) at the end of the curve.

    Attributes
    ----------
    stiffness : (N, p, m) array
        K at the nodes of the panels.
    force : (N, p, 2, m) array
        b at the nodes.
    edge_moment : (N + 1, m) array
        M at the panel ends.
    start_force, end_force : (2, m) arrays
        b of the supports at the two ends.
    """

    stiffness: FloatArray
    force: FloatArray
    edge_moment: FloatArray
    start_force: FloatArray
    end_force: FloatArray


def moment_rows(panels: Panels, load: LineLoad | None = None) -> MomentRows:
    """Return stiffness, force and moment along a curve as linear maps of its end state (paper, Eqs. 3 and 5).

    The equations of the rod are integrated from the end of the curve to its start, panel by panel. At a zero of
    kappa - kappa_0 the moment is set to zero, so K is the limit there and not a quotient of rounding errors. The
    caller must constrain the state accordingly: the rows of `edge_moment` at the zeros must give 0.

    Parameters
    ----------
    panels : Panels
        The curve, cut at its zeros.
    load : LineLoad, optional
        Weight along the curve; none by default.

    Returns
    -------
    MomentRows
        Rows of m = 3 numbers (M, b_x, b_y), or m = 4 with tau if part of the load is not proportional to the
        stiffness.
    """
    if load is None:
        return _weightless(panels)
    with np.errstate(over="ignore", invalid="ignore"):  # a weight far too large overflows; the caller checks
        return _weighted(panels, load)


def _weightless(panels: Panels) -> MomentRows:
    count, order = panels.t.shape
    reach = panels.edge_position - panels.edge_position[-1]
    edge_moment = np.ones((count + 1, 3))
    edge_moment[:, 1:] = reach
    # M at a node = M at the panel's near end + <b, step>; at a zero the first term vanishes
    from_left = panels.zero_left
    vanishing = vanishing_at_zeros(panels, edge_moment)
    base = np.where(from_left[:, None], vanishing[:-1], vanishing[1:])
    step = np.where(from_left[:, None, None], panels.from_left, panels.from_right)
    rows = np.empty((count, order, 3))
    rows[..., 0] = base[:, :1]
    np.add(base[:, None, 1:], step, out=rows[..., 1:])
    rows /= panels.curvature[..., None]
    constant = np.eye(2, 3, 1)
    return MomentRows(
        stiffness=rows,
        force=np.broadcast_to(constant, (count, order, 2, 3)),
        edge_moment=edge_moment, start_force=constant, end_force=constant,
    )  # fmt: skip


def vanishing_at_zeros(panels: Panels, edge_moment: FloatArray) -> FloatArray:
    """Return the moment at the panel ends, with exact zeros instead of rounding errors where it must vanish.

    The errors are interpolated linearly between the zeros of kappa - kappa_0 and subtracted, because next to a zero
    they would be large relative to M.
    """
    vanishes = np.zeros(panels.count + 1, dtype=bool)
    vanishes[:-1] = panels.zero_left
    vanishes[1:] |= panels.zero_right
    zeros = vanishes.nonzero()[0]
    if not zeros.size:
        return edge_moment
    traces, at = np.empty_like(edge_moment), panels.edge_s[zeros]
    for number, column in enumerate(edge_moment[zeros].T):
        traces[:, number] = np.interp(panels.edge_s, at, column)
    return np.asarray(edge_moment - traces)


def _weighted(panels: Panels, load: LineLoad) -> MomentRows:
    count, order = panels.t.shape
    size = 3 if load.is_proportional else 4
    G = np.array([load.up[1], -load.up[0]])  # R^t e
    left, zero = panels.zero_left, panels.zero_left | panels.zero_right
    local = np.where(left[:, None, None], panels.from_left, panels.from_right)
    integral = np.where(left[:, None, None], -LEFT, RIGHT) * panels.stretch[:, None, :]
    lever = local @ G
    kernel = integral * (lever[:, :, None] - lever[:, None, :])
    matrix = -kernel * load.own[:, None, :]
    matrix[:, np.arange(order), np.arange(order)] += panels.curvature
    known = np.zeros((count, order, size))
    known[~zero, :, 0] = 1.0
    known[..., 1:3] = local
    if size == 4:
        known[..., 3] = np.einsum("nij,nj->ni", kernel, load.dead)
    stiffness = np.linalg.solve(matrix, known)
    weight = load.own[..., None] * stiffness
    if size == 4:
        weight[..., 3] += load.dead
    shares = WEIGHTS * panels.stretch
    # the state at the far end of each panel from the near one: right to left, except beside a zero on the
    # left
    sign = np.where(left, -1.0, 1.0)
    far = np.where(left[:, None, None], panels.from_right, panels.from_left) @ G
    chord = np.diff(panels.edge_position, axis=0) * -sign[:, None]
    transfer = np.tile(np.eye(size), (count, 1, 1))
    transfer[:, 0, 1:3] = chord
    transfer[:, 0] -= np.einsum("n,ni,nim->nm", sign, shares * far, weight)
    transfer[:, 1:3] += np.einsum("n,k,ni,nim->nkm", sign, G, shares, weight)
    backward = transfer.copy()
    backward[left] = np.linalg.inv(transfer[left])
    near = np.empty((count, size, size))
    edge_moment = np.empty((count + 1, size))
    state = np.eye(size)
    for k in range(count, 0, -1):
        state = _past_point(state, load.points[k], G)
        edge_moment[k] = state[0]
        before = backward[k - 1] @ state
        near[k - 1] = before if left[k - 1] else state
        state = before
    edge_moment[0] = state[0]
    first = _past_point(state, load.points[0], G)
    stiffness = stiffness @ near
    weight = weight @ near
    force = near[:, None, 1:3, :] + np.einsum("k,nij,njm->nikm", G, integral, weight)
    end = np.eye(size)
    return MomentRows(
        stiffness=stiffness, force=force, edge_moment=edge_moment, start_force=first[1:3], end_force=end[1:3]
    )


def _past_point(state: FloatArray, newtons: float, G: FloatArray) -> FloatArray:
    """Return the state before a point weight from the state after it: b grows by the weight times R^t e."""
    if newtons == 0:
        return state
    state = state.copy()
    state[1:3, 3] += newtons * G
    return state


_SLOPES_AT_NODES = VANDER @ SLOPES

_SETTLED = 1e-9  # relative change of the least ratio that ends the iteration

_SAME = 4 * float(np.finfo(float).eps)
"""Relative difference between two solutions of a program whose vertex was reached by different paths."""

_ROUNDING = 16 * float(np.finfo(float).eps)  # of the terms of a sum: three factors and a series

BOUNDED = 1e-7
"""Relative excess over its bounds that a smooth stiffness may have: the accuracy of its linear program."""


@dataclass(frozen=True, eq=False)
class StiffnessFamily:
    """K = rows @ y + offset with d free numbers y, as piecewise polynomials over panels.

    Attributes
    ----------
    panels : Panels
    rows : PanelFunction
        Coefficients (N, p, d).
    offset : PanelFunction or None
        Coefficients (N, p); None when K is homogeneous in y.
    side_rows, side_offset : (k, d), (k,) arrays or None
        Conditions side_rows @ y + side_offset >= 0; an offset of None is 0.
    sides : tuple of PanelFunction
        More conditions of that kind, all along the curve: coefficients (N, p, d), without an offset.
    """

    panels: Panels
    rows: PanelFunction
    offset: PanelFunction | None = None
    side_rows: FloatArray | None = None
    side_offset: FloatArray | None = None
    sides: tuple[PanelFunction, ...] = ()

    @property
    def freedom(self) -> int:
        """Number of free numbers."""
        return int(self.rows.coefficients.shape[2])

    def at(self, panel: IntArray, x: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return rows (n, d) and offsets (n,) at places x (n,) of panels (n,)."""
        offset = np.zeros(len(x)) if self.offset is None else self.offset.at(panel, x)
        return self.rows.at(panel, x), offset

    @cached_property
    def dense(self) -> tuple[FloatArray, FloatArray]:
        """Rows and offsets at `Panels.dense_places`."""
        rows = self.rows.dense
        return rows, np.zeros(len(rows)) if self.offset is None else self.offset.dense

    def extremes(self, y: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return rows and offsets at the extremes of K of the numbers y, and at adjacent samples."""
        panel, sample, x = self.stiffness(y).found_extremes
        rows, offset = self.dense
        beside = panel * (DENSE_PARTS + 1) + sample
        rows = np.concatenate([rows[beside], self.rows.at(panel, x)])
        if self.offset is None:
            return rows, np.zeros(len(rows))
        return rows, np.concatenate([offset[beside], self.offset.at(panel, x)])

    def stiffness(self, y: FloatArray) -> PanelFunction:
        """Return K of the numbers y."""
        K = self.rows.combined(y)
        return K if self.offset is None else PanelFunction(K.coefficients + self.offset.coefficients)


def least_ratio(
    family: StiffnessFamily, places: tuple[IntArray, FloatArray] | None = None
) -> tuple[FloatArray, float] | None:
    """Return the numbers y of least ratio R, or None if no stiffness is positive everywhere.

    By default R is that of the continuous curve, unless `places` (panel, x) fix the samples. Extremes of K between
    the samples are computed from its polynomials and added to the program until R converges.
    """
    if places is not None:
        solution = _sampled(family, *family.at(*places))
    elif family.freedom == 0 or (family.freedom == 1 and family.offset is None and not family.sides):
        # no free number, or a number that only scales K: the places of the extremes are fixed
        rows, offset = family.dense
        more, more_offset = family.extremes(np.ones(family.freedom))
        solution = _sampled(family, np.concatenate([rows, more]), np.concatenate([offset, more_offset]))
    else:
        return _continuous_ratio(family)
    return None if solution is None else (solution.x, solution.ratio)


def _sampled(family: StiffnessFamily, rows: FloatArray, offset: FloatArray) -> MinimaxSolution | None:
    return minimax_ratio(rows, offset=offset, side_rows=family.side_rows, side_offset=family.side_offset)


def _continuous_ratio(family: StiffnessFamily) -> tuple[FloatArray, float] | None:
    """Return the least R; each iteration adds all local extremes that exceed it."""
    rows, offset = family.dense
    sides = [side.dense for side in family.sides]
    program = MinimaxProgram(
        np.concatenate([rows, *sides]), side_rows=family.side_rows, side_offset=family.side_offset
    )
    tolerance = _SETTLED
    program.demand(rows, offset, rows, offset)
    for side in sides:
        program.hold(side, np.zeros(len(side)))
    before = np.full(family.freedom, np.nan)
    for _ in range(METHOD.most_rounds):
        answer = program.solve()
        if answer is None:
            return None
        y, ratio = answer
        rows, offset = family.extremes(y)
        values = rows @ y + offset
        rounded: FloatArray | float = 0.0
        if np.abs(y - before).max() <= _SAME * np.abs(y).max():
            # what is beyond its bounds still is so by the solver's own tolerance
            tolerance = BOUNDED
            rounded = _ROUNDING * (np.abs(rows) @ np.abs(y))  # or because large terms cancel
        before = y
        low = (values < 1 - tolerance - rounded).nonzero()[0]
        high = (values > ratio * (1 + tolerance) + rounded).nonzero()[0]
        broken = [side.at(*side.combined(y).extreme_places) for side in family.sides]
        broken = [more[more @ y < -tolerance * ratio] for more in broken]
        if not (low.size or high.size or any(map(len, broken))):
            if values.min() <= 0:  # all that would be positive drowns in rounding
                return None
            return y, float(max(values.max() / min(1.0, values.min()), ratio))
        program.demand(rows[low], offset[low], rows[high], offset[high])
        for more in broken:
            program.hold(more, np.zeros(len(more)))
    raise unsettled(ratio)


def _smoothest(
    family: StiffnessFamily,
    ratio: float,
    places: tuple[IntArray, FloatArray] | None = None,
    kept: FloatArray | None = None,
) -> FloatArray:
    """Return the numbers y of least total variation of K' with K between 1 and `ratio` (paper, section 5.3).

    As in `least_ratio`, K is bounded on the continuous curve unless `places` (panel, x) fix the samples. Places
    where K of the numbers `kept` equals `ratio` keep this value.
    """
    panels = family.panels
    count, order = panels.t.shape
    # d/ds = d/dx / stretch, twice; jumps of K' at the panel ends count too
    columns = family.rows.coefficients
    if family.offset is not None:
        columns = np.concatenate([columns, family.offset.coefficients[..., None]], axis=2)
    slope = in_panels(_SLOPES_AT_NODES, columns) / panels.stretch[..., None]
    slopes = PanelFunction.through(slope)
    bend = in_panels(_SLOPES_AT_NODES, slopes.coefficients) * WEIGHTS[:, None]
    before, after = slopes.where_panels_meet
    bends = np.concatenate([bend.reshape(count * order, -1), after - before])
    d = family.freedom
    bend_offset = bends[:, d] if family.offset is not None else np.zeros(len(bends))
    pins, pin_offset = np.zeros((0, d)), np.zeros(0)
    if kept is not None:
        pins, pin_offset = family.extremes(kept) if places is None else family.at(*places)
        pins = pins[pins @ kept + pin_offset > ratio * (1 - BOUNDED)]
        pin_offset = 1.0 - pins @ kept  # 1 <= pins @ y + pin_offset: no less than now

    def smoothest(rows: FloatArray, offset: FloatArray) -> FloatArray:
        rows, offset = np.concatenate([rows, pins]), np.concatenate([offset, pin_offset])
        return least_variation(rows, offset, bends[:, :d], bend_offset, ratio)

    return smoothest(*family.at(*places)) if places is not None else _bounded(family, ratio, smoothest)


def largest_within(family: StiffnessFamily, number: FloatArray, ratio: float) -> FloatArray:
    """Return the y that maximises number @ y with K between 1 and `ratio`, for a family without offset."""
    return _bounded(family, ratio, lambda rows, _: largest_number(rows, number, ratio))


def _bounded(
    family: StiffnessFamily, ratio: float, best: Callable[[FloatArray, FloatArray], FloatArray]
) -> FloatArray:
    """Return the best numbers y with K between 1 and `ratio` on the continuous curve.

    `best` returns y for given rows and offsets. The extremes of the resulting K are added until K is within bounds.
    """
    rows, offset = family.dense
    first = start_rows(len(rows))
    rows, offset = rows[first], offset[first]
    for _ in range(METHOD.most_rounds):
        y = best(rows, offset)
        more, more_offset = family.extremes(y)
        K = more @ y + more_offset
        if K.min() >= 1 - BOUNDED and K.max() <= ratio * (1 + BOUNDED):
            return y
        rows, offset = np.concatenate([rows, more]), np.concatenate([offset, more_offset])
    raise unsettled(ratio)


def find_violations(family: StiffnessFamily) -> FloatArray:
    """Return the arc lengths (k,), mm, where no choice of the numbers makes K positive everywhere.

    With a single free number these are the stretches of the rarer sign. Otherwise they are the samples that limit
    the largest possible least value of K.
    """
    from scipy.optimize import linprog

    panel, x = family.panels.dense_places()
    rows, offset = family.dense
    s = family.panels.arc_length(panel, x)
    d = family.freedom
    if d == 0:
        return np.asarray(s[offset <= 0])
    size = np.maximum(np.abs(rows).max(axis=1), 1e-300)
    if d == 1 and family.offset is None:
        sign = rows[:, 0] > 0
        return np.asarray(s[sign != (sign.mean() >= 0.5)])
    scaled = rows / size[:, None]
    matrix = np.column_stack([-scaled, np.ones(len(s))])
    bounds = [(-1.0, 1.0)] * d + [(None, None)]
    result = linprog(np.append(np.zeros(d), -1.0), matrix, offset / size, bounds=bounds, method="highs")
    if result.status != 0:
        return np.zeros(0)
    return np.asarray(s[np.abs(result.ineqlin.marginals) > 1e-9])


SMOOTHING_SHARE = 0.01
"""Share of the ratio that section 5.3 trades for smoothness."""

NO_GAIN_SHARE = 1e-6
"""Relative gain in ratio that is neglected."""

WIDEST_RATIO = 1e10
"""Largest stiffness ratio in computations; no strip can have it."""

LARGEST_LOAD = 1e3
"""Largest fixed weight, in multiples of the largest stiffness, of a program that is not scaled by the weight."""

RANK_SHARE = 1e-7
"""Relative tolerance for linearly dependent conditions."""


@dataclass(frozen=True, eq=False)
class BalancedStiffness:
    """Stiffness in balance on a curve, least value about 1, as functions over panels.

    Attributes
    ----------
    stiffness, moment, force : PanelFunction
        K, M (1/mm) and b (1/mm2).
    bending_stiffness, weight
        B in N mm2 and the corresponding weight, if the weight is in newtons.
    kinks : sequence of (s, continuity)
        Places where the load or the material law makes K less smooth than the curve.
    """

    panels: Panels
    stiffness: PanelFunction
    moment: PanelFunction
    force: PanelFunction
    bending_stiffness: float | None = None
    weight: Weight | None = None
    kinks: Sequence[tuple[float, int]] = ()


@dataclass(frozen=True, eq=False)
class StateFamily:
    """Family of stiffnesses: state (M, b_x, b_y, tau) at the curve's end = fixed + basis @ free numbers."""

    family: StiffnessFamily
    basis: FloatArray
    fixed: FloatArray


@dataclass(frozen=True, eq=False)
class RodRequest(EqualByValue):
    """Request for a rod that rests in a curve. `optimal_rod` describes the fields.

    `known_check` is the check of the curve if it exists already.
    """

    curve: PlaneCurve
    gravity: Gravity | None = None
    supports: Supports = field(default_factory=Supports)
    natural_curvature: NaturalCurvature = 0.0
    samples: int | None = None
    weight: Weight | None = None
    bending_stiffness: float | None = None
    largest_stiffness: float | None = None
    least_stiffness: float | None = None
    law: MaterialLaw | None = None
    section: BoundedLaw | None = None
    known_check: EquilibriumCheck | None = None

    @property
    def curve_to_bend(self) -> PlaneCurve:
        """Curve that the rod follows."""
        return self.curve

    @cached_property
    def check(self) -> EquilibriumCheck:
        """Theorem 1 on the curve that is bent; a strip that feels its weight needs no line."""
        if self.known_check is not None:
            return self.known_check
        heavy = self.gravity is not None
        return examine(self.curve_to_bend, self.supports, self.natural_curvature, heavy=heavy)

    @cached_property
    def nodes(self) -> CurveSamples:
        """Curve at the nodes of the rod; if `samples` is given, the ratio is evaluated only there."""
        curve = self.check.curve
        return curve.survey if self.samples is None else curve.sample(self.samples)

    @property
    def masses(self) -> tuple[PointMass, ...]:
        """Point masses on the rod."""
        return () if self.weight is None else self.weight.masses

    @property
    def cut(self) -> CutCurve:
        """Curve cut where the natural curvature, the material law or the load is not smooth."""
        return CutCurve.where_kinked(self.check, self.natural_curvature, self.law, self.weight)


@dataclass(frozen=True, eq=False)
class ConditionedRows:
    """Moment rows under the conditions of inflections and supports."""

    request: RodRequest
    panels: Panels
    rows: MomentRows

    @property
    def check(self) -> EquilibriumCheck:
        """Verdict of Theorem 1 on the curve."""
        return self.request.check

    @cached_property
    def conditions(self) -> FloatArray:
        """Rows (k, m) @ state = 0: no moment where no curvature, no force that no support gives."""
        t = np.array([z.t for z in self.check.zeros])
        rows = [self.rows.edge_moment[np.abs(self.panels.edges - t[:, None]).argmin(axis=1)]]
        forces = self.rows.start_force, self.rows.end_force
        for end, force in zip(self.request.supports.ends, forces, strict=True):
            # lambda = R b: the force along x is -b_y, that along y is b_x
            rows += [] if end.x else [force[1:2]]
            rows += [] if end.y else [force[0:1]]
        return np.concatenate(rows)

    @cached_property
    def scale(self) -> FloatArray:
        """Sizes (m,) of the state's numbers."""
        size = np.full(self.rows.edge_moment.shape[1], 1 / self.check.length)
        size[0] = 1.0
        if size.size == 4:
            size[3] = 1 / np.abs(self.rows.edge_moment[:, 3]).max()
        return size

    def homogeneous(self, count: int) -> StateFamily:
        """Return all stiffnesses of the first `count` numbers of the state (3: without dead weight)."""
        basis = np.zeros((self.scale.size, count))
        np.fill_diagonal(basis, self.scale[:count])
        basis = basis @ null_space(self.conditions @ basis)
        side = basis[3:4] if count == 4 and self.scale.size == 4 else None
        return StateFamily(
            StiffnessFamily(self.panels, PanelFunction.through(self.rows.stiffness @ basis), side_rows=side),
            basis,
            np.zeros(self.scale.size),
        )

    def at_compliance(self, tau: float) -> StateFamily:
        """Return all stiffnesses with least bending stiffness 1 / tau."""
        size = self.scale
        if size.size == 3:
            return self.homogeneous(3)
        basis, fixed = np.zeros((4, 3)), np.array([0.0, 0.0, 0.0, tau])
        np.fill_diagonal(basis, size[:3])
        free, particular = _solutions(self.conditions @ basis, -self.conditions @ fixed)
        if particular is None:
            self.refuse(None)
        fixed, basis = fixed + basis @ particular, basis @ free
        offset = PanelFunction.through(self.rows.stiffness @ fixed)
        return StateFamily(
            StiffnessFamily(self.panels, PanelFunction.through(self.rows.stiffness @ basis), offset),
            basis,
            fixed,
        )

    def ratio(self, numbers: StateFamily) -> tuple[FloatArray, float] | None:
        """Return the free numbers of least ratio, and the ratio."""
        if numbers.family.freedom == 0 and numbers.family.offset is None:
            return None
        if numbers.family.freedom > 0:
            rows, _ = numbers.family.dense
            sizes = np.abs(rows).sum(axis=1)
            if not sizes.max() < WIDEST_RATIO * sizes.min():
                return None
        return least_ratio(numbers.family, self.places)

    @property
    def places(self) -> tuple[IntArray, FloatArray] | None:
        """Panels and places x of the nodes if the ratio is evaluated only at nodes, otherwise None."""
        everywhere = self.request.samples is None or self.request.largest_stiffness is not None
        return None if everywhere else self.panels.locate(self.request.nodes.t)

    def steadied(self, state: FloatArray) -> FloatArray:
        """Return the optimum that does not change when the drawing is rotated.

        For arcs it has a constant moment. If a step of the curvature alone decides the ratio, it is the _smoothest
        stiffness.
        """
        if self.check.zeros:
            return state
        table = PanelFunction.through(self.rows.stiffness)
        rows = table.dense if self.places is None else table.at(*self.places)
        K, steady = rows @ state, np.abs(rows[:, 0])
        if steady.max() * K.min() <= (1 + NO_GAIN_SHARE) * K.max() * steady.min():
            return np.array([np.sign(rows[0, 0]), 0.0, 0.0])
        before, after = table.combined(state).where_panels_meet
        steps = np.maximum(after / before, before / after)
        if self.places is not None or not steps.size or steps.max() < (1 - NO_GAIN_SHARE) * K.max() / K.min():
            return state
        numbers = self.homogeneous(3)
        with suppress(NotConvergedError):  # any optimum is acceptable
            return numbers.basis @ _smoothest(numbers.family, float(steps.max()) * (1 + NO_GAIN_SHARE))
        return state

    def least(self, numbers: StateFamily, *, smooth: bool = True) -> FloatArray:
        """Return the end state (m,) of least ratio, smoothed if inflections leave a choice."""
        optimum = self.ratio(numbers)
        if optimum is None:
            self.refuse(numbers.family)
        y, ratio = optimum
        choices = numbers.family.freedom - (numbers.family.offset is None)
        if smooth and self.check.zeros and choices > 0:
            y = _smoothest(numbers.family, ratio * (1 + SMOOTHING_SHARE), self.places)
        return np.asarray(numbers.fixed + numbers.basis @ y)

    def _offset(self, tau: float) -> FloatArray:
        """Return K (N, p) at the nodes of the particular solution with least bending stiffness 1 / tau."""
        return np.asarray(self.rows.stiffness @ self.at_compliance(tau).fixed)

    @property
    def load_stiffness(self) -> float:
        """Size of the bending stiffness that the fixed weight requires, N mm2."""
        return float(np.abs(self._offset(1.0)).max())

    def stiffest(self, most: float, least: float) -> tuple[FloatArray, float] | None:
        """Return the state (m,) and tau that maximise the least E I for the largest E I `most`, N mm2.

        The result is smoothed if inflections leave a choice, with stiffnesses from `least` to `most`. The result is
        None if no stiffness within these limits balances the curve.
        """
        family = self.at_compliance(1 / most).family
        # for rows K <= 1: the largest 1 + 1 / size - K / size is minimal where the least K is maximal
        size = max(1.0, self.load_stiffness / (LARGEST_LOAD * most))
        turned = StiffnessFamily(
            self.panels,
            PanelFunction(-family.rows.coefficients),
            PanelFunction.through(1 + (1 - self._offset(1 / most)) / size),
        )
        solution = least_ratio(turned, self.places)
        if solution is None:
            return None
        softest, y = 1 + size * (1 - solution[1]), size * solution[0]
        if softest < least / most * (1 - BOUNDED):
            return None
        trade = 1.0
        if self.check.zeros and family.freedom > 0:
            trade = max(1.0, min(1 + SMOOTHING_SHARE, softest * most / least))
        tau, y = trade / (softest * most), y * trade / softest
        numbers = self.at_compliance(tau)
        if trade > 1:
            y = _smoothest(numbers.family, trade / softest, self.places, kept=y)
        return numbers.fixed + numbers.basis @ y, tau

    def balance(self, state: FloatArray) -> BalancedStiffness:
        """Return the balance with a given end state."""
        K = self.rows.stiffness @ state
        return BalancedStiffness(
            self.panels,
            PanelFunction.through(K),
            PanelFunction.through(K * self.panels.curvature),
            PanelFunction.through(self.rows.force @ state),
        )

    def refuse(self, family: StiffnessFamily | None) -> NoReturn:
        """Raise `NotRealizable` with the reason and the places."""
        if family is None or (family.freedom == 0 and family.offset is None):
            reason = note(
                "With this weight and these supports, the moment cannot be 0 at all places of zero curvature "
                "(at {places}). Use the nearest curve, move the inflections, or hold more at the ends.",
                places=Listed(Length(z.s) for z in self.check.zeros),
            )
        else:
            wrong = find_violations(family)
            near = stretches(wrong, self.check.length)
            reason = note(
                "With this weight and these supports, the moment would have to act against the curvature "
                "near {stretches}, which no positive stiffness allows. Use a lighter or stiffer sheet, "
                "support the strip there, or change the curve." if near else
                "With this weight and these supports, the moment would have to act against the curvature, "
                "which no positive stiffness allows. Use a lighter or stiffer sheet, support the strip, or "
                "change the curve.",
                stretches=near,
            )  # fmt: skip
        raise NotRealizable(replace(self.check, realizable=False, reasons=(*self.check.reasons, reason)))


def null_space(matrix: FloatArray) -> FloatArray:
    """Return the null space (m, d) of matrix (k, m)."""
    if not len(matrix):
        return np.eye(matrix.shape[1])
    size = np.abs(matrix).max(axis=1)
    _, sigma, vt = svd(matrix / np.where(size > 0, size, 1.0)[:, None])
    return np.asarray(vt[_rank(sigma) :].T)


def _rank(sigma: FloatArray) -> int:
    """Return the number of linearly independent conditions from the sorted singular values."""
    return int(np.count_nonzero(sigma > RANK_SHARE * max(1.0, sigma[0])))


def _solutions(matrix: FloatArray, right: FloatArray) -> tuple[FloatArray, FloatArray | None]:
    """Return the null space (m, d) of matrix (k, m), and a solution of matrix @ x = right or None."""
    count = matrix.shape[1]
    size = np.abs(matrix).max(axis=1, initial=0.0)
    size = np.where(size > 0, size, np.abs(right))
    size = np.where(size > 0, size, 1.0)
    largest = max(1.0, float(np.abs(right / size).max(initial=0.0)))
    u, sigma, vt = (
        np.linalg.svd(matrix / size[:, None]) if len(matrix) else (np.eye(0), np.zeros(0), np.eye(count))
    )
    rank = _rank(sigma) if len(matrix) else 0
    inner = (u.T @ (right / size))[:rank] / sigma[:rank]
    x = vt[:rank].T @ inner
    residual = np.abs(matrix @ x - right) / size
    return vt[rank:].T, x if residual.max(initial=0.0) <= 10 * RANK_SHARE * largest else None


def stretches(s: FloatArray, length: float) -> Listed:
    """List places; places closer than a twentieth of the length are merged."""
    s = np.sort(np.round(s, 6)) + 0.0  # no -0
    groups = np.split(s, np.flatnonzero(np.diff(s) > length / 20) + 1) if s.size else ()
    return Listed(
        Length(g[0]) if np.ptp(g) < length / 200 else Span((Length(g[0]), Length(g[-1]))) for g in groups
    )
