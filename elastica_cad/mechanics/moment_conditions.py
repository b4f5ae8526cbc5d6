"""Stiffness of a rod that is in equilibrium on a drawn curve: linear equations, conditions and optimum.

On a drawn curve gamma, the equations of the rod (paper, Eqs. 3 and 5) are

    M' = <b, gamma'>,   b' = -(q K + p tau) R^t e,   K (kappa - kappa_0) = M.

M is the moment, K the stiffness, kappa the curvature and kappa_0 the natural curvature. R^t turns a vector
clockwise by 90 degrees, and b is the negative internal force turned by R^t. Here q is the weight per length and
stiffness (1/l_eg^3 with the elasto-gravity length l_eg), and p a weight per length that does not depend on K
(N/mm). Tau is the inverse of the least bending stiffness, and e a unit vector upwards.

M and b depend linearly on their values at the end of the curve, on tau and on the unknown forces between the ends.
One integration for each of these numbers is therefore enough.
"""

from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from typing import NoReturn

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._compiled_scipy import svd
from elastica_cad._types import FloatArray, IntArray
from elastica_cad._values import EqualByValue
from elastica_cad.errors import Length, Listed, NotConvergedError, Span, note
from elastica_cad.geometry.plane_curve import CurveSamples, PlaneCurve
from elastica_cad.geometry.plane_points import left_of, unit
from elastica_cad.geometry.polynomials import (
    LEFT,
    RIGHT,
    SLOPES,
    VANDER,
    WEIGHTS,
    PanelFunction,
    in_panels,
)
from elastica_cad.mechanics.cross_sections import Section
from elastica_cad.mechanics.elements import (
    Element,
    ElementForce,
    PlacedElement,
    PointForce,
    Tie,
    forces_of,
    place_elements,
    resultant,
    with_placed_masses,
)
from elastica_cad.mechanics.equilibrium_check import examine
from elastica_cad.mechanics.loads import Gravity, NaturalCurvature, PointMass, Supports, Weight
from elastica_cad.mechanics.minimax_lp import (
    METHOD,
    MinimaxProgram,
    largest_number,
    least_variation,
    minimax_ratio,
    unsettled,
)
from elastica_cad.mechanics.moment_curvature import MaterialLaw
from elastica_cad.mechanics.mounted_elements import ShapeOfRod, require_held
from elastica_cad.mechanics.quadrature_panels import CutCurve, Panels, nearest_of
from elastica_cad.mechanics.theorem1 import EquilibriumCheck, NotRealizable, refused


@dataclass(frozen=True, eq=False)
class MomentRows:
    """Stiffness, force and moment along a rod as linear functions of m unknowns, on N panels with p nodes each.

    The unknowns are (M, b_x, b_y) at the end of the curve, tau, and the unknown forces. M is the bending moment, b
    the negative internal force turned clockwise by 90 degrees, and tau the inverse of the least bending stiffness.
    The coefficients of tau are zero if the whole load is proportional to the stiffness.

    Attributes
    ----------
    stiffness : (N, p, m) array
        Coefficients of the stiffness K at the nodes of the panels.
    force : (N, p, 2, m) array
        Coefficients of b at the nodes.
    edge_moment : (N + 1, m) array
        Coefficients of M at the ends of the panels.
    start_force, end_force : (2, m) arrays
        Coefficients of b that the supports exert at the two ends.
    """

    stiffness: FloatArray
    force: FloatArray
    edge_moment: FloatArray
    start_force: FloatArray
    end_force: FloatArray

    @property
    def loaded(self) -> bool:
        """True if part of the load is not proportional to the stiffness."""
        return bool(self.force[..., 3].any() or self.start_force[:, 3].any())


def moment_rows(panels: Panels, units: FloatArray) -> MomentRows:
    """Return stiffness, force and moment along a curve as linear maps of the state at the end (paper, Eq. 3).

    The stiffness is the moment divided by the excess curvature kappa - kappa_0 (curvature minus natural curvature).
    At a zero of the excess curvature, the moment is set to exactly 0, so that the stiffness is not a quotient of
    rounding errors. The caller must require that the moment is 0 there: the rows of `edge_moment` contain its
    coefficients.

    Parameters
    ----------
    panels : Panels
        The curve, cut at the zeros of kappa - kappa_0.
    units : (N + 1, 2, u) array
        Forces x and y on the strip at the ends of the N panels that a unit value of each of the u unknowns causes.
    """
    count, order = panels.t.shape
    size = 4 + units.shape[2]
    edge_moment = np.zeros((count + 1, size))
    edge_moment[:, 0] = 1.0
    edge_moment[:, 1:3] = panels.edge_position - panels.edge_position[-1]
    # b beyond the start, on each panel, and beyond the end; without jumps it is (b_x, b_y), unknowns 1 and 2
    b = np.zeros((count + 2, 2, size))
    b[:] = np.eye(2, size, 1)
    for k in np.flatnonzero(units.any(axis=(1, 2))):
        # from the end of the curve towards its start, the force b jumps at each rail, pin and end of a tie
        step = left_of(units[k].T).T
        b[: k + 1, :, 4:] += step
        edge_moment[: k + 1, 4:] += (panels.edge_position[: k + 1] - panels.edge_position[k]) @ step
    # moment at a node = moment at one end of the panel (0 at a zero) + <b, vector from this end to the node>
    from_left = panels.zero_left
    vanishing = vanishing_at_zeros(panels, edge_moment)
    base = np.where(from_left[:, None], vanishing[:-1], vanishing[1:])
    step = np.where(from_left[:, None, None], panels.from_left, panels.from_right)
    rows = base[:, None, :] + step @ b[1:-1]
    rows /= np.where(panels.flat[:, None], 1.0, panels.curvature)[..., None]
    _continue_on_tails(rows, panels)
    return MomentRows(
        stiffness=rows, force=np.broadcast_to(b[1:-1, None], (count, order, 2, size)),
        edge_moment=edge_moment, start_force=b[0], end_force=b[-1],
    )  # fmt: skip


def _continue_on_tails(stiffness: FloatArray, panels: Panels) -> None:
    """Set the stiffness (N, p, m) of straight tails to its value where the bent part begins."""
    bent = np.flatnonzero(~panels.flat)
    ends = PanelFunction.through(stiffness[bent[[0, -1]]]).at(np.arange(2), np.array([-1.0, 1.0]))
    stiffness[: bent[0]], stiffness[bent[-1] + 1 :] = ends


def vanishing_at_zeros(panels: Panels, edge_moment: FloatArray) -> FloatArray:
    """Return the moments at the ends of panels, with exact zeros where the strip has its natural curvature.

    Rounding errors at these zeros would be large compared with the moment nearby. The errors are interpolated
    linearly between the zeros and subtracted.
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
    return edge_moment - traces


def weighted_moment_rows(
    panels: Panels, units: FloatArray, up: FloatArray, own: FloatArray, dead: FloatArray, points: FloatArray
) -> MomentRows:
    """Return the linear maps of `moment_rows` for a rod with weight and known forces (paper, Eq. 5).

    The equations of the rod are integrated from the end of the curve to its start, panel by panel. Only `own` is
    divided by the least bending stiffness. In the equations, `dead` and `points` are multiplied by the unknown tau.
    The coefficients are not finite if the weight is far too large.

    Parameters
    ----------
    up : (2,) array
        Unit vector against gravity.
    own : (N, p) array
        Weight per length for a relative stiffness of 1, divided by the least bending stiffness, 1/mm3. For a
        strip of one sheet, the value is 1/l_eg^3 with the elasto-gravity length l_eg.
    dead : (N, p) array
        Weight per length that does not depend on the stiffness, N/mm.
    points : (N + 1, 2) array
        Known forces on the strip at the ends of the panels, N.
    """
    count, order = panels.t.shape
    # unknowns at an end of a panel: moment, two force components, and the inverse stiffness tau
    total = 4 + units.shape[2]
    # jumps of b at the ends of the panels
    steps = np.zeros((count + 1, 2, total))
    steps[:, :, 3] = left_of(points)
    steps[:, :, 4:] = left_of(units.swapaxes(1, 2)).swapaxes(1, 2)
    G = np.array([up[1], -up[0]])  # the upward unit vector, turned clockwise by 90 degrees
    left, zero = panels.zero_left, panels.zero_left | panels.zero_right
    # each panel is computed from its near end: the left end if this is a zero, or else the right end
    local = np.where(left[:, None, None], panels.from_left, panels.from_right)
    integral = np.where(left[:, None, None], -LEFT, RIGHT) * panels.stretch[:, None, :]
    lever = local @ G
    # K kappa - kernel @ (own K) = known @ (M, b_x, b_y, tau at the near end) at the nodes of a panel
    kernel = integral * (lever[:, :, None] - lever[:, None, :])
    matrix = -kernel * own[:, None, :]
    matrix[:, np.arange(order), np.arange(order)] += np.where(panels.flat[:, None], 1.0, panels.curvature)
    known = np.zeros((count, order, 4))
    known[~zero, :, 0] = 1.0  # the moment at a zero is 0
    known[..., 1:3] = local
    known[..., 3] = np.einsum("nij,nj->ni", kernel, dead)
    stiffness = np.linalg.solve(matrix, known)
    weight = own[..., None] * stiffness
    weight[..., 3] += dead
    shares = WEIGHTS * panels.stretch
    # integrate each panel from its right end, or from its left end if the left end is a zero
    sign = np.where(left, -1.0, 1.0)
    far = np.where(left[:, None, None], panels.from_right, panels.from_left) @ G
    # matrices (N, 4, 4) from (M, b_x, b_y, tau) at the near end to the far end, then from the right to the left end
    chord = np.diff(panels.edge_position, axis=0) * -sign[:, None]
    transfer = np.tile(np.eye(4), (count, 1, 1))
    transfer[:, 0, 1:3] = chord
    transfer[:, 0] -= np.einsum("n,ni,nim->nm", sign, shares * far, weight)
    transfer[:, 1:3] += np.einsum("n,k,ni,nim->nkm", sign, G, shares, weight)
    backward = transfer.copy()
    backward[left] = np.linalg.inv(transfer[left])
    near = np.empty((count, 4, total))
    edge_moment = np.empty((count + 1, total))
    state = np.eye(4, total)
    for k in range(count, 0, -1):
        state[1:3] += steps[k]
        edge_moment[k] = state[0]
        before = backward[k - 1] @ state
        near[k - 1] = before if left[k - 1] else state
        state = before
    edge_moment[0] = state[0]
    stiffness = stiffness @ near
    _continue_on_tails(stiffness, panels)
    weight = weight @ near
    force = near[:, None, 1:3, :] + np.einsum("k,nij,njm->nikm", G, integral, weight)
    return MomentRows(
        stiffness=stiffness, force=force, edge_moment=edge_moment,
        start_force=state[1:3] + steps[0], end_force=np.eye(2, total, 1),
    )  # fmt: skip


_SLOPES_AT_NODES = VANDER @ SLOPES

# fraction by which the stiffness may exceed its bounds in the linear program of least ratio
_SETTLED = 1e-9

_SAME = 4 * float(np.finfo(float).eps)
"""Relative difference below which solutions of a linear program are equal."""

# rounding error of a sum, relative to the sum of the absolute values of its terms
_ROUNDING = 16 * float(np.finfo(float).eps)

BOUNDED = 1e-7
"""Fraction by which a smooth stiffness may exceed its bounds: the accuracy of the linear program."""

CHOSEN = 1e-5
"""Fraction by which a smooth stiffness may exceed bounds that `SMOOTHING_SHARE` has widened."""


@dataclass(frozen=True, eq=False)
class StiffnessFamily:
    """Stiffnesses K = rows @ y + offset with free parameters y (d,), as polynomials on each of N panels.

    At each point of the curve, the rows are d numbers and the offset is one number.

    Attributes
    ----------
    panels : Panels
    columns : PanelFunction
        Coefficients (N, p, d + 1) of the polynomials: the first d columns are the rows, the last is the offset.
    conditions : (k, d + 1) array
        Conditions conditions @ (y, 1) >= 0, each for the whole rod.
    sides : tuple of PanelFunction
        Further conditions side @ y >= 0 at every point of the curve, with coefficients (N, p, d) of `side`.
    """

    panels: Panels
    columns: PanelFunction
    conditions: FloatArray
    sides: tuple[PanelFunction, ...] = ()

    @classmethod
    def through(
        cls,
        panels: Panels,
        rows: FloatArray,
        offset: FloatArray | float = 0.0,
        conditions: FloatArray | None = None,
        sides: tuple[PanelFunction, ...] = (),
    ) -> "StiffnessFamily":
        """Return the stiffnesses for given rows (N, p, d) and offset (N, p) at the nodes of the panels."""
        columns = np.insert(rows, rows.shape[2], offset, axis=2)
        if conditions is None:
            conditions = np.zeros((0, columns.shape[2]))
        return cls(panels, PanelFunction.through(columns), conditions, sides)

    @property
    def freedom(self) -> int:
        """Number d of free parameters."""
        return int(self.columns.coefficients.shape[2]) - 1

    @property
    def is_homogeneous(self) -> bool:
        """True if the offset is 0, so that every multiple of a stiffness is in the family."""
        return not self.columns.coefficients[..., -1].any()

    @cached_property
    def dense(self) -> FloatArray:
        """Values (n, d + 1) of the columns at the sample points `Panels.dense_places`."""
        return self.columns.dense

    def extremes(self, y: FloatArray) -> FloatArray:
        """Return the columns at the extremes of the stiffness for parameters y, and at the samples nearby."""
        K = self.columns.combined(np.append(y, 1.0))
        return self.columns.at(*K.extreme_places)


def _rows_and_offset(columns: FloatArray) -> tuple[FloatArray, FloatArray]:
    # split columns (n, d + 1) into rows (n, d) and offset (n,)
    return columns[:, :-1], columns[:, -1]


def least_ratio(
    family: StiffnessFamily,
    places: tuple[IntArray, FloatArray] | None = None,
    tolerance: float = _SETTLED,
    most: float = np.inf,
) -> tuple[FloatArray, float] | None:
    """Return the parameters y (d,) of the stiffness with the least ratio R, and R.

    The least R for which some y keeps 1 <= K <= R and satisfies the conditions of the family is computed. Return
    None if there is no such y. The result can also be None if R is above `most`.

    With `places` (panels and coordinates x), the bounds hold at these samples, and `family.sides` are ignored. By
    default, the bounds hold on the continuous curve. Extremes of the stiffness are then added to the linear program
    until the stiffness exceeds its bounds by at most the relative `tolerance`.
    """
    if places is not None:
        samples = family.columns.at(*places)
    elif family.freedom == 0 or (family.freedom == 1 and family.is_homogeneous and not family.sides):
        # a single free parameter only scales the stiffness, so the extremes have fixed positions
        samples = np.concatenate([family.dense, family.extremes(np.ones(family.freedom))])
    else:
        return _continuous_ratio(family, tolerance, most)
    rows, offset = _rows_and_offset(samples)
    side_rows, side_offset = _rows_and_offset(family.conditions)
    solution = minimax_ratio(rows, offset=offset, side_rows=side_rows, side_offset=side_offset)
    return None if solution is None else (solution.x, solution.ratio)


def _continuous_ratio(
    family: StiffnessFamily, tolerance: float, most: float
) -> tuple[FloatArray, float] | None:
    """Return what `least_ratio` returns on the continuous curve."""
    rows, offset = _rows_and_offset(family.dense)
    sides = [side.dense for side in family.sides]
    program = MinimaxProgram(np.concatenate([rows, *sides]), most=most)
    program.hold(*_rows_and_offset(family.conditions))
    program.demand(rows, offset, rows, offset)
    for side in sides:
        program.hold(side, np.zeros(len(side)))
    before = np.full(family.freedom, np.nan)
    for _ in range(METHOD.most_rounds):
        answer = program.solve()
        if answer is None:
            return None
        y, ratio = answer
        rows, offset = _rows_and_offset(family.extremes(y))
        values = rows @ y + offset
        rounded: FloatArray | float = 0.0
        if np.abs(y - before).max() <= _SAME * np.abs(y).max():
            # the solution has converged to the accuracy of the solver
            tolerance = BOUNDED
            # allow for rounding errors of `rows` @ `y`, because large terms may cancel
            rounded = _ROUNDING * (np.abs(rows) @ np.abs(y))
        before = y
        low = (values < 1 - tolerance - rounded).nonzero()[0]
        high = (values > ratio * (1 + tolerance) + rounded).nonzero()[0]
        broken = [side.at(*side.combined(y).extreme_places) for side in family.sides]
        broken = [more[more @ y < -tolerance * ratio] for more in broken]
        if not (low.size or high.size or any(map(len, broken))):
            if values.min() <= 0:  # rounding errors are as large as the least stiffness
                return None
            # K may be slightly below 1
            return y, float(max(values.max() / min(1.0, values.min()), ratio))
        program.demand(rows[low], offset[low], rows[high], offset[high])
        for more in broken:
            program.hold(more, np.zeros(len(more)))
    raise unsettled(ratio)


def _smoothest(
    family: StiffnessFamily,
    ratio: float,
    start: FloatArray,
    places: tuple[IntArray, FloatArray] | None = None,
    *,
    tolerance: float = BOUNDED,
    keep_largest: bool = False,
) -> FloatArray:
    """Return the parameters y of the smoothest stiffness K between 1 and `ratio` (paper, section 5.3).

    K is bounded at the samples `places`, or by default everywhere. The parameters `start` are a feasible
    solution. With `keep_largest`, K remains `ratio` where `start` gives `ratio`.
    """
    panels = family.panels
    count, order = panels.t.shape
    # changes of the slope of the stiffness at nodes (d/ds = (d/dx) / stretch) and between panels
    slope = in_panels(_SLOPES_AT_NODES, family.columns.coefficients) / panels.stretch[..., None]
    slopes = PanelFunction.through(slope)
    bend = in_panels(_SLOPES_AT_NODES, slopes.coefficients) * WEIGHTS[:, None]
    before, after = slopes.where_panels_meet
    bends, bend_offset = _rows_and_offset(np.concatenate([bend.reshape(count * order, -1), after - before]))
    pins = np.zeros((0, family.freedom + 1))
    if keep_largest:
        pins = family.extremes(start) if places is None else family.columns.at(*places)
        pins = pins[pins @ np.append(start, 1.0) > ratio * (1 - BOUNDED)]
        # at these places, the stiffness must be at least that for `start`
        pins[:, -1] = 1.0 - pins[:, :-1] @ start

    def smoothest(samples: FloatArray) -> FloatArray:
        rows, offset = _rows_and_offset(np.concatenate([samples, pins]))
        sides = _rows_and_offset(family.conditions)
        return least_variation(rows, offset, bends, bend_offset, ratio, start, sides)

    return (
        smoothest(family.columns.at(*places))
        if places is not None
        else _bounded(family, ratio, smoothest, tolerance)
    )


def largest_within(family: StiffnessFamily, number: FloatArray, ratio: float) -> FloatArray:
    """Return the parameters y that maximise number @ y for a stiffness rows @ y between 1 and `ratio`."""
    sides = family.conditions[:, :-1]
    return _bounded(family, ratio, lambda samples: largest_number(samples[:, :-1], number, ratio, sides))


def _bounded(
    family: StiffnessFamily,
    ratio: float,
    best: Callable[[FloatArray], FloatArray],
    tolerance: float = BOUNDED,
) -> FloatArray:
    """Return the parameters y from `best` for which the stiffness K is between 1 and `ratio` on the whole curve.

    The function `best` keeps K = samples @ (y, 1) within the bounds. Extremes of K are added as
    samples until K exceeds its bounds by at most the relative `tolerance`.
    """
    samples = family.dense[:: METHOD.first_step]
    for _ in range(METHOD.most_rounds):
        y = best(samples)
        more = family.extremes(y)
        K = more @ np.append(y, 1.0)
        if K.min() >= 1 - tolerance and K.max() <= ratio * (1 + tolerance):
            return y
        samples = np.concatenate([samples, more])
    raise unsettled(ratio)


def find_violations(family: StiffnessFamily) -> FloatArray:
    """Return the arc lengths (k,), mm, of the samples that prevent a stiffness that is positive everywhere.

    With no free parameter, these are the samples at which the stiffness is not positive. With a single parameter
    and no offset, the stiffness has its less frequent sign there. Otherwise they limit how large the least
    stiffness can be, and the result is empty if the linear program has no solution.
    """
    from scipy.optimize import linprog

    panel, x = family.panels.dense_places()
    rows, offset = _rows_and_offset(family.dense)
    s = family.panels.arc_length(panel, x)
    d = family.freedom
    if d == 0:
        return s[offset <= 0]
    size = np.maximum(np.abs(rows).max(axis=1), 1e-300)
    if d == 1 and family.is_homogeneous:
        sign = rows[:, 0] > 0
        return np.asarray(s[sign != (sign.mean() >= 0.5)])
    # maximise the least stiffness, scaled at each sample, over parameters y from -1 to 1; samples with a
    # multiplier other than 0 limit it
    scaled = rows / size[:, None]
    sides, side_offset = _rows_and_offset(family.conditions)
    matrix = np.column_stack([-np.concatenate([scaled, sides]), np.repeat([1.0, 0.0], [len(s), len(sides)])])
    bounds = [(-1.0, 1.0)] * d + [(None, None)]
    right = np.concatenate([offset / size, side_offset])
    result = linprog(np.append(np.zeros(d), -1.0), matrix, right, bounds=bounds, method="highs")
    if result.status != 0:
        return np.zeros(0)
    return np.asarray(s[np.abs(result.ineqlin.marginals[: len(s)]) > 1e-9])


SMOOTHING_SHARE = 0.01
"""Relative increase of the stiffness ratio that is accepted for a smoother stiffness (paper, section 5.3)."""

NO_GAIN_SHARE = 1e-6
"""Smaller relative reductions of the stiffness ratio are neglected."""

WIDEST_RATIO = 1e10
"""Largest stiffness ratio in computations, far above the ratio of any strip."""

LARGEST_LOAD = 1e3
"""Ratio of the stiffness that the load requires to the largest allowed stiffness.

Above this ratio, the linear program is rescaled.
"""

RANK_SHARE = 1e-7
"""Relative tolerance for linearly dependent conditions."""


@dataclass(frozen=True, eq=False)
class BalancedStiffness:
    """Stiffness for which a curve is a rest shape, with its moment and force, as functions over panels.

    Attributes
    ----------
    stiffness, moment, force : PanelFunction
        Stiffness K, moment M (1/mm) and force b (1/mm2), divided by the least bending stiffness, so that
        the least K is about 1. The force b satisfies dM/ds = <b, T> for the unit tangent T.
    bending_stiffness, weight
        Least bending stiffness B, N mm2, and the weight of a strip with this B; None if not computed.
    kinks : sequence of (s, continuity)
        Arc lengths s, mm, at which loads, material law or natural curvature make K less smooth than the curve,
        each with the number of continuous derivatives of K.
    between : tuple of ElementForce
        Rails, pins and ties with their forces, 1/mm2.
    """

    panels: Panels
    stiffness: PanelFunction
    moment: PanelFunction
    force: PanelFunction
    bending_stiffness: float | None = None
    weight: Weight | None = None
    kinks: Sequence[tuple[float, int]] = ()
    between: tuple[ElementForce, ...] = ()


@dataclass(frozen=True, eq=False)
class StateFamily:
    """Stiffnesses of a rod in equilibrium with free parameters y.

    The m unknowns that `MomentRows` describes are fixed (m,) + basis (m, d) @ y. `family` has their stiffnesses.
    """

    family: StiffnessFamily
    basis: FloatArray
    fixed: FloatArray


@dataclass(frozen=True, eq=False)
class RodRequest(EqualByValue):
    """Request for a rod whose rest shape is a curve; `optimal_rod` describes the attributes.

    `known_check` is the result of an earlier check of the curve, or None. Masses are in `weight`, other loads in
    `point_forces`. Positions of rails, pins, ties and point forces are along the curve `drawn`, or along `curve` if
    `drawn` is None.
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
    section: Section | None = None
    known_check: EquilibriumCheck | None = None
    between: tuple[Element, ...] = ()
    point_forces: tuple[PointForce, ...] = ()
    drawn: PlaneCurve | None = None

    def __post_init__(self) -> None:
        if not self.between:
            self.supports.require_held()
        if self.weight is not None and self.weight.masses:
            placed = with_placed_masses(self.weight, self.drawn or self.curve, self.curve)
            object.__setattr__(self, "weight", placed)

    @property
    def curve_to_bend(self) -> PlaneCurve:
        """Curve that is the requested rest shape."""
        return self.curve

    @cached_property
    def check(self) -> EquilibriumCheck:
        """Result of the check of Theorem 1; under forces between the ends, inflections need not be on a line."""
        return self.known_check or self.examined()

    def examined(self, tolerance: float = 1e-4) -> EquilibriumCheck:
        """Check the curve, and move it by at most `tolerance` times its length to make it realizable."""
        curve = self.curve_to_bend
        # with weight, the part between a free end and an element is not straight
        placed = [
            PlacedElement.on(element, self.drawn or curve, curve)
            for elements in ((self.between, self.point_forces) if self.gravity is None else ())
            for element in elements
        ]
        return examine(
            curve, self.supports, self.natural_curvature, tolerance, heavy=not self.needs_line,
            stations=[s for element in placed for s in element.s.tolist()],
        )  # fmt: skip

    @property
    def needs_line(self) -> bool:
        """True if the inflections must be on a line: without weight, point forces, rails, pins and ties."""
        return self.gravity is None and not self.between and not self.point_forces

    @cached_property
    def elements(self) -> tuple[PlacedElement, ...]:
        """Rails, pins and ties with their positions on the checked curve."""
        placed, curve = self._placed(self.between), self.check.curve
        if placed:
            # the weight counts as a unit force at the start: only a load of exactly 0 needs no support
            at = curve.at(np.array([0.0, *(force.s[0] for force in self.forces)])).position
            weight = (0.0, 0.0) if self.gravity is None else self.gravity.direction
            forces = np.array([weight, *(force.units[0, 0] for force in self.forces)])
            nodes, edge_length = self.nodes, curve.length / (len(self.nodes.s) - 1)
            shape = ShapeOfRod(np.diff(nodes.position, axis=0) / edge_length, edge_length, at[0])
            require_held(self.supports, placed, shape, resultant(at - at[0], forces, curve.length))
        return placed

    @cached_property
    def forces(self) -> tuple[PlacedElement, ...]:
        """Point forces with their positions on the checked curve."""
        return self._placed(self.point_forces)

    def _placed(self, elements: Sequence[Element | PointForce]) -> tuple[PlacedElement, ...]:
        joints = [zero.s for zero in self.check.zeros if zero.kind == "flat"]
        return place_elements(elements, self.drawn or self.curve, self.check.curve, self.supports, joints)

    def units_on(self, panels: Panels) -> FloatArray:
        """Return the forces (N + 1, 2, u) of rails, pins and ties on the strip at the ends of panels.

        The last index selects the unknown that is 1 while the other unknowns are 0.
        """
        units = np.zeros((panels.count + 1, 2, sum(element.unknowns for element in self.elements)))
        first = 0
        for element in self.elements:
            for s, forces in zip(element.s, element.units.swapaxes(0, 1), strict=True):
                at = np.abs(panels.edge_s - s).argmin()
                units[at, :, first : first + element.unknowns] += forces.T
            first += element.unknowns
        return units

    @cached_property
    def nodes(self) -> CurveSamples:
        """Samples of the curve at the nodes of the rod."""
        curve = self.check.curve
        return curve.survey if self.samples is None else curve.sample(self.samples)

    @property
    def masses(self) -> tuple[PointMass, ...]:
        """Point masses on the rod."""
        return () if self.weight is None else self.weight.masses

    @property
    def cut(self) -> CutCurve:
        """Curve, cut where the natural curvature, the material law or the load is not smooth."""
        stations = [s for element in (*self.elements, *self.forces) for s in element.s.tolist()]
        return CutCurve.where_kinked(self.check, self.natural_curvature, self.law, self.weight, stations)


@dataclass(frozen=True, eq=False)
class ConditionedRows:
    """Moment and stiffness as linear functions of m unknowns, and conditions at the inflections and supports."""

    request: RodRequest
    panels: Panels
    rows: MomentRows

    @property
    def check(self) -> EquilibriumCheck:
        """Result of the check of Theorem 1 on the curve."""
        return self.request.check

    @cached_property
    def conditions(self) -> FloatArray:
        """Matrix C (k, m) of the conditions C x = 0 on the m unknowns x that `MomentRows` describes.

        The moment is zero at inflections, and the force is zero along coordinates that an end leaves free. A rail,
        pin or tie at an inflection exerts no force normal to the strip, because the stiffness would jump there.
        """
        t = np.array([z.t for z in self.check.zeros])
        at = nearest_of(self.panels.edges, t)
        rows = [self.rows.edge_moment[at]]
        # exclude the starts of straight tails, where an element may push although the stiffness does not jump
        flat = np.array([zero.kind == "flat" for zero in self.check.zeros], dtype=bool)
        inner = (at > 0) & (at < self.panels.count) & ~flat
        if self.request.elements and inner.any():
            across = left_of(unit(self.check.curve.evaluate(t[inner], 1)))
            normal = np.zeros((len(across), self.scale.size))
            units = self.request.units_on(self.panels)[at[inner]]
            normal[:, 4:] = np.einsum("kc,kcu->ku", across, units)
            rows.append(normal[normal.any(axis=1)])
        forces = self.rows.start_force, self.rows.end_force
        for end, force in zip(self.request.supports.ends, forces, strict=True):
            # the x component of the force is -b_y, and its y component is b_x
            rows += [] if end.x else [force[1:2]]
            rows += [] if end.y else [force[0:1]]
        return np.concatenate(rows)

    @cached_property
    def scale(self) -> FloatArray:
        """Orders of magnitude (m,) of the unknowns."""
        size = np.full(self.rows.edge_moment.shape[1], 1 / self.check.length)
        size[0] = 1.0
        moment = self.rows.stiffness[..., 3:] * self.panels.curvature[..., None]
        reached = np.abs(moment).max(axis=(0, 1))
        size[3:] = 1 / np.where(reached > 0, reached, self.check.length)
        return size

    @cached_property
    def pushed(self) -> IntArray:
        """Indices (k,) of the unknowns that must be 0 or more: the pulls of ties, because a cord cannot push."""
        kinds = [
            isinstance(placed.element, Tie)
            for placed in self.request.elements
            for _ in range(placed.unknowns)
        ]
        return 4 + np.flatnonzero(kinds)

    def homogeneous(self, *, loaded: bool) -> StateFamily:
        """Return all stiffnesses in equilibrium, with any positive multiple of the known loads or without loads."""
        basis = np.diag(self.scale)
        if not loaded:
            basis = np.delete(basis, 3, axis=1)  # unknown 3 is tau
        basis = basis @ null_space(self.conditions @ basis)
        sides = np.append(self.pushed, 3) if loaded else self.pushed
        return self._states(basis, np.zeros(self.scale.size), sides)

    def _states(self, basis: FloatArray, fixed: FloatArray, sides: IntArray) -> StateFamily:
        """Return the stiffnesses for the unknowns fixed + basis @ y. Those with indices `sides` are 0 or more."""
        conditions = (np.column_stack([basis, fixed]) / self.scale[:, None])[sides]
        K, offset = self.rows.stiffness @ basis, self.rows.stiffness @ fixed
        return StateFamily(StiffnessFamily.through(self.panels, K, offset, conditions), basis, fixed)

    def at_compliance(self, tau: float) -> StateFamily:
        """Return all stiffnesses in equilibrium for the least bending stiffness 1 / tau."""
        basis = np.delete(np.diag(self.scale), 3, axis=1)
        fixed = tau * np.eye(self.scale.size)[3]
        free, particular = _solutions(self.conditions @ basis, -self.conditions @ fixed)
        if particular is None:
            self.refuse(None)
        return self._states(basis @ free, fixed + basis @ particular, self.pushed)

    def ratio(
        self, numbers: StateFamily, tolerance: float = _SETTLED, most: float = np.inf
    ) -> tuple[FloatArray, float] | None:
        """Return the parameters with the least stiffness ratio, and the ratio.

        Return None if no stiffness exists. The result can also be None if the ratio is above `most`.
        """
        if numbers.family.freedom > 0:
            sizes = np.abs(numbers.family.dense[:, :-1]).sum(axis=1)
            if not sizes.max() < WIDEST_RATIO * sizes.min():
                return None
        return least_ratio(numbers.family, self.places, tolerance, most)

    @property
    def places(self) -> tuple[IntArray, FloatArray] | None:
        """Panels and coordinates x of the nodes, or None if the ratio is evaluated on the whole curve."""
        everywhere = self.request.samples is None or self.request.largest_stiffness is not None
        return None if everywhere else self.panels.locate(self.request.nodes.t)

    def steadied(self, state: FloatArray) -> FloatArray:
        """Return optimal unknowns that do not depend on the rotation of the drawing.

        If a constant moment is optimal, as for arcs, it is chosen. If a single jump of the curvature determines the
        ratio, the optimum with the smoothest stiffness is chosen.
        """
        if self.check.zeros:
            return state
        table = PanelFunction.through(self.rows.stiffness)
        rows = table.dense if self.places is None else table.at(*self.places)
        # the optimal stiffness, and the stiffness under a constant moment, which may have the same ratio
        K, steady = rows @ state, np.abs(rows[:, 0])
        if steady.max() * K.min() <= (1 + NO_GAIN_SHARE) * K.max() * steady.min():
            return np.asarray(np.sign(rows[0, 0]) * np.eye(state.size)[0])
        before, after = table.combined(state).where_panels_meet
        steps = np.maximum(after / before, before / after)
        if self.places is not None or not steps.size or steps.max() < (1 - NO_GAIN_SHARE) * K.max() / K.min():
            return state
        numbers = self.homogeneous(loaded=False)
        # any optimum is acceptable if the smoothest stiffness is not found
        with suppress(NotConvergedError):
            start = np.asarray(np.linalg.lstsq(numbers.basis, state, rcond=None)[0], dtype=float)
            y = _smoothest(numbers.family, float(steps.max()) * (1 + NO_GAIN_SHARE), start)
            return numbers.basis @ y
        return state

    def least(self, numbers: StateFamily, *, smooth: bool = True) -> FloatArray:
        """Return the unknowns (m,) for the least stiffness ratio.

        If inflections allow several optima, the result is the optimum with the smoothest stiffness.
        """
        choices = numbers.family.freedom - numbers.family.is_homogeneous
        smooth = smooth and bool(self.check.zeros) and choices > 0
        optimum = self.ratio(numbers, CHOSEN / 2 if smooth else _SETTLED)
        if optimum is None:
            self.refuse(numbers.family)
        y, ratio = optimum
        if smooth:
            y = _smoothest(numbers.family, ratio * (1 + SMOOTHING_SHARE), y, self.places, tolerance=CHOSEN)
        return numbers.fixed + numbers.basis @ y

    @property
    def load_stiffness(self) -> float:
        """Order of magnitude of the bending stiffness that the known loads require, N mm2."""
        return float(np.abs(self.rows.stiffness @ self.at_compliance(1.0).fixed).max())

    def stiffest(self, most: float, least: float) -> tuple[FloatArray, float] | None:
        """Return the unknowns (m,) and 1 / B with the largest B for stiffnesses E I from B to `most`, N mm2.

        If inflections allow several stiffnesses from `least` to `most`, the result is the smoothest stiffness.
        The result is None if no stiffness within these limits is in equilibrium.
        """
        numbers = self.at_compliance(1 / most)
        # to maximise the least K (at most 1), minimise the largest 1 + (1 - K) / size
        size = max(1.0, self.load_stiffness / (LARGEST_LOAD * most))
        conditions = numbers.family.conditions.copy()
        conditions[:, -1] /= size
        rows, offset = (self.rows.stiffness @ part for part in (numbers.basis, numbers.fixed))
        turned = StiffnessFamily.through(self.panels, -rows, 1 + (1 - offset) / size, conditions)
        solution = least_ratio(turned, self.places)
        if solution is None:
            return None
        softest, y = 1 + size * (1 - solution[1]), size * solution[0]
        if softest < least / most * (1 - BOUNDED):
            return None
        # a lower B allows a larger ratio most / B, and so a smoother stiffness
        trade = 1.0
        if self.check.zeros and numbers.family.freedom > 0:
            trade = max(1.0, min(1 + SMOOTHING_SHARE, softest * most / least))
        tau, y = trade / (softest * most), y * trade / softest
        numbers = self.at_compliance(tau)
        if trade > 1:
            y = _smoothest(numbers.family, trade / softest, y, self.places, keep_largest=True)
        return numbers.fixed + numbers.basis @ y, tau

    def balance(self, state: FloatArray) -> BalancedStiffness:
        """Return the stiffness, moment and force for given values (m,) of the unknowns."""
        K = self.rows.stiffness @ state
        return BalancedStiffness(
            self.panels,
            PanelFunction.through(K),
            PanelFunction.through(K * self.panels.curvature),
            PanelFunction.through(self.rows.force @ state),
            between=forces_of(self.request.elements, state[4:]),
        )

    def refuse(self, family: StiffnessFamily | None) -> NoReturn:
        """Raise `NotRealizable` with the reason and with positions on the curve."""
        held = bool(self.request.elements or self.request.forces)
        if family is None or (family.freedom == 0 and family.is_homogeneous):
            reason = note(
                "With these supports, rails, pins, ties and loads, the moment cannot be 0 at every inflection "
                "({places} from the start). Move or add a rail, pin or tie."
                if held
                else "With this weight and these supports, the moment cannot be 0 at every inflection ({places} "
                "from the start). Take the nearest curve that a strip can take, move the inflections, or clamp "
                "the ends.",
                places=Listed(Length(z.s) for z in self.check.zeros),
            )
        else:
            near = stretches(find_violations(family), self.check.length)
            reason = note(
                "With these supports, rails, pins, ties and loads, the moment near {stretches} would bend the "
                "strip to the other side. Move or add a rail, pin or tie, there or elsewhere."
                if held and near else
                "With these supports, rails, pins, ties and loads, the moment would bend the strip to the "
                "other side. Move or add a rail, pin or tie." if held else
                "With this weight and these supports, the moment near {stretches} would bend the strip to the "
                "other side. Use a lighter or stiffer sheet, support the strip there, "
                "or change the curve." if near else
                "With this weight and these supports, the moment would bend the strip to the other side. "
                "Use a lighter or stiffer sheet, support the strip, or change the curve.",
                stretches=near,
            )  # fmt: skip
        raise NotRealizable(refused(self.check, reason))


def null_space(matrix: FloatArray) -> FloatArray:
    """Return the null space (m, d) of matrix (k, m)."""
    return _solutions(matrix, np.zeros(len(matrix)))[0]


def _solutions(matrix: FloatArray, right: FloatArray) -> tuple[FloatArray, FloatArray | None]:
    """Return the null space (m, d) of matrix (k, m), and a solution x of matrix @ x = right, or None."""
    count = matrix.shape[1]
    size = np.abs(matrix).max(axis=1, initial=0.0)
    size = np.where(size > 0, size, np.abs(right))
    size = np.where(size > 0, size, 1.0)
    largest = max(1.0, float(np.abs(right / size).max(initial=0.0)))
    u, sigma, vt = svd(matrix / size[:, None]) if len(matrix) else (np.eye(0), np.zeros(0), np.eye(count))
    rank = int(np.count_nonzero(sigma > RANK_SHARE * sigma.max(initial=1.0)))
    x = vt[:rank].T @ ((u.T @ (right / size))[:rank] / sigma[:rank])
    residual = np.abs(matrix @ x - right) / size
    return vt[rank:].T, x if residual.max(initial=0.0) <= 10 * RANK_SHARE * largest else None


def stretches(s: FloatArray, length: float) -> Listed:
    """Return ranges of arc length for a message; positions closer than a twentieth of the length are merged."""
    s = np.sort(np.round(s, 6)) + 0.0  # turn -0.0 into 0.0
    groups = np.split(s, np.flatnonzero(np.diff(s) > length / 20) + 1) if s.size else ()
    return Listed(
        Length(g[0]) if np.ptp(g) < length / 200 else Span((Length(g[0]), Length(g[-1]))) for g in groups
    )
