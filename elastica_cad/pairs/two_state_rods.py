"""Rods that have two drawn curves as rest shapes: their stiffness and natural curvature.

The rod with the least stiffness ratio and bend, or with the largest least thickness, is selected.
"""

from dataclasses import dataclass, field, replace
from functools import partial
from typing import Annotated, Literal, NoReturn, TypeAlias

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import is_one_of, require_positive, require_record
from elastica_cad.declared import Option
from elastica_cad.errors import InputError
from elastica_cad.geometry.plane_curve import CurvatureZero, PlaneCurve
from elastica_cad.geometry.polynomials import WEIGHTS, PanelFunction
from elastica_cad.geometry.profile import Profile
from elastica_cad.mechanics.least_ratio import rod_of_request, stiffness_profile
from elastica_cad.mechanics.loads import CurveOfRest, require_ratio, whole_number
from elastica_cad.mechanics.minimax_lp import METHOD, MinimaxProgram, unsettled
from elastica_cad.mechanics.moment_conditions import BOUNDED, BalancedStiffness, RodRequest, StiffnessFamily
from elastica_cad.mechanics.rod import DEFAULT_SAMPLES, Rod
from elastica_cad.mechanics.sideways import SidewaysStability, sideways_stability
from elastica_cad.mechanics.stability import Stability, stability
from elastica_cad.mechanics.theorem1 import EquilibriumCheck, NotRealizable, PairCheck
from elastica_cad.pairs.pair_check import PairedPanels, examine_pair

State: TypeAlias = Literal["first", "second"]
Objective: TypeAlias = Literal["ratio", "thickness"]

TANGENTS = 12
"""Number of tangents that replace the function K^(2/3) of the stiffness K in the first linear program."""

WIDEST_TANGENTS = 1e4
"""The first tangents are at stiffnesses up to this factor below and above a typical stiffness."""

SMOOTH = 4
"""A cubic spline of the stiffness has no kinks if the curve has this number of continuous derivatives."""


@dataclass(frozen=True)
class PairLimits:
    """Upper limits for a rod with two states; None for no limit.

    Attributes
    ----------
    ratio : float, optional
        Ratio of largest to least stiffness; 8 corresponds to a thickness ratio of 2 in a flexure.
    natural_curvature : float, optional
        Absolute curvature of the strip before bending, 1/mm.
    bend : float, optional
        Absolute change of curvature by bending in either state, 1/mm.
    """

    ratio: Annotated[
        float | None,
        Option(
            "Largest stiffness ratio; a ratio of 8 means that the thickness varies by a factor of 2.",
            least=1,
            common=True,
        ),
    ] = None
    natural_curvature: Annotated[
        float | None, Option("Largest natural curvature of the strip.", "1/mm", least=0)
    ] = None
    bend: Annotated[
        float | None,
        Option("Largest difference from the natural curvature in either state.", "1/mm", least=0),
    ] = None

    def __post_init__(self) -> None:
        if self.ratio is not None:
            require_ratio(self.ratio, "ratio")
        for name in ("natural_curvature", "bend"):
            if (value := getattr(self, name)) is not None:
                require_positive(value, name.replace("_", " "), "1/mm")


@dataclass(frozen=True, eq=False)
class TwoStateRod:
    """Rod that has two curves as rest shapes.

    Attributes
    ----------
    first, second : Rod
        Rod in each state, with the same n nodes, stiffness and natural curvature.
    check : PairCheck
    free : "first", "second" or None
        State in which no external forces act, if it was requested.
    """

    first: Rod
    second: Rod
    check: PairCheck = field(repr=False)
    free: State | None = None

    def __repr__(self) -> str:
        kind = "bistable" if self.bistable else "two settings"
        return f"<TwoStateRod of {self.length:.4g} mm, {kind}, ratio {self.ratio:.4g}>"

    @property
    def states(self) -> tuple[Rod, Rod]:
        """Rods of both states."""
        return self.first, self.second

    @property
    def length(self) -> float:
        """Length of the rod, mm."""
        return self.first.length

    @property
    def ratio(self) -> float:
        """Ratio of largest to least stiffness."""
        return self.first.ratio

    @property
    def natural_curvature(self) -> FloatArray:
        """Curvature (n,) of the unloaded strip at the nodes, 1/mm."""
        return np.broadcast_to(np.asarray(self.first.natural_curvature, dtype=float), self.first.s.shape)

    @property
    def bend(self) -> float:
        """Largest absolute change of curvature in both states, 1/mm."""
        return max(float(np.abs(rod.curvature - self.natural_curvature).max()) for rod in self.states)

    @property
    def bistable(self) -> bool:
        """True if both states fit the same clamps."""
        return self.check.bistable

    @cached_property
    def stability(self) -> tuple[Stability, Stability]:
        """Stability of both states in the plane."""
        return stability(self.first), stability(self.second)

    def sideways(
        self, depth: float, thickness: Profile | ArrayLike, *, poisson_ratio: float = 0.3
    ) -> tuple[SidewaysStability, SidewaysStability]:
        """Return the stability of both states against tipping out of the plane.

        `depth`, mm, is perpendicular to the plane. `thickness`, mm, is in the plane: a profile, a number, or
        values at equal distances.
        """
        first, second = (
            sideways_stability(rod, depth, thickness, poisson_ratio=poisson_ratio) for rod in self.states
        )
        return first, second


def two_state_rod(
    first: PlaneCurve,
    second: PlaneCurve,
    *,
    limits: PairLimits | None = None,
    free: State | None = None,
    objective: Objective = "ratio",
    samples: int | None = None,
) -> TwoStateRod:
    """Return the rod that has two curves as rest shapes, with a suitable natural curvature.

    Parameters
    ----------
    first, second : PlaneCurve
        Curves, mm. The relative difference of their lengths is at most 1e-4 (`matched_pair` makes them equal).
        The second curve is scaled to the length of the first.
    limits : PairLimits, optional
        Upper limits of ratio, natural curvature and bend along both curves.
    free : "first" or "second", optional
        State in which no external forces act. Its curve is the shape of the unloaded rod, and the rod is the
        `optimal_rod` for the other curve.
    objective : "ratio" or "thickness"
        "ratio" minimises the stiffness ratio and, among all rods with this ratio, the largest change of curvature.
        "thickness" maximises the least thickness of a flexure for a given strain. The stiffness of a flexure is
        proportional to the cube of its thickness.
    samples : int, optional
        Number of nodes of both states; by default 601.

    Raises
    ------
    NotRealizable
        No rod within the limits has both rest shapes; `check` of the error states why and where.

    References
    ----------
    Paper, Theorem 1 and Eq. 4, for differences of curvatures and moments: see `check_pair`.

    Examples
    --------
    >>> from elastica_cad.mechanics.least_ratio import optimal_rod
    >>> arch = PlaneCurve.spline([(0, 0), (30, 14), (70, 14), (100, 0)], degree=3)
    >>> clip = two_state_rod(arch, arch.transformed(np.diag([1.0, -1.0, 1.0])))
    >>> round(clip.ratio / optimal_rod(arch).ratio, 6)
    1.0
    """
    limits = PairLimits() if limits is None else limits
    require_record(limits, PairLimits, "limits", "a PairLimits record, or None")
    count = DEFAULT_SAMPLES if samples is None else whole_number(samples, "samples", 3)
    for name, value, known in (
        ("free", free, (None, "first", "second")),
        ("objective", objective, ("ratio", "thickness")),
    ):
        if not is_one_of(value, known):
            raise InputError(f"{name} is {value!r}: give one of {', '.join(map(repr, known))}")
    check, paired, least = examine_pair(first, second)
    if free is not None:
        return _refuse_beyond_limits(limits, _with_free_state(check, free, count))
    if not check.realizable:
        raise NotRealizable(check)
    if paired is None or least is None:
        return _refuse_beyond_limits(limits, _with_free_state(check, "first", count))
    if objective == "thickness":
        numbers = _thickest(paired, limits)
    else:
        numbers = _least(paired, least, limits)
    return _refuse_beyond_limits(limits, _rod_of(paired, numbers, count))


def _least(paired: PairedPanels, least: FloatArray, limits: PairLimits) -> FloatArray:
    """Return the moment parameters (6,) with the least stiffness ratio within the limits.

    If several parameters have this ratio, return those for which the largest change of
    curvature in both states is least.
    """
    numbers = np.append(paired.basis @ least, 0.0)
    if limits.natural_curvature is not None or limits.bend is not None:
        basis = paired.solutions
        sides = tuple(PanelFunction.through(rows @ basis) for rows in _limit_rows(paired, limits))
        K = paired.stiffness_rows @ basis
        ratio_numbers = paired.least_ratio(StiffnessFamily.through(paired.panels, K, sides=sides))
        if ratio_numbers is None:
            _refuse(
                paired.check, limits, _rod_of(paired, _least_bend(paired, numbers, None), DEFAULT_SAMPLES)
            )
        numbers = basis @ ratio_numbers
    return _least_bend(paired, numbers, limits.natural_curvature)


def _limit_rows(paired: PairedPanels, limits: PairLimits) -> list[FloatArray]:
    """Return arrays of rows (N, p, 6) that express the limits as rows @ numbers >= 0, at p nodes of N panels.

    State i has the moment M_i and the curvature kappa_i, and K is the stiffness. A limit k of the natural curvature
    requires |kappa_1 K - M_1| <= k K, and a limit c of the bend |M_i| <= c K. The rows are divided by k or c.
    """
    K, limited = paired.stiffness_rows, list[FloatArray]()
    if (most := limits.natural_curvature) is not None:
        natural = paired.check.first.curvature_at(paired.panels.t)[..., None] * K - paired.moments[0]
        limited.append(natural / most)
    if (most := limits.bend) is not None:
        limited += [moment / most for moment in paired.moments]
    return [K + sign * rows for rows in limited for sign in (1, -1)]


def _least_bend(paired: PairedPanels, numbers: FloatArray, most_natural: float | None) -> FloatArray:
    """Return moment parameters (6,) with the same stiffness and the least bend.

    The bend is the largest change of curvature in both states. Usually only a_1 has no effect on the stiffness. For
    congruent or mirrored curves, more parameters have no effect, and several rods have the least bend. Then the
    natural curvature nearest to the mean of both curvatures is selected.
    """
    panels, size = paired.panels, paired.check.length
    K = paired.stiffness_rows @ numbers
    idle = paired.idle
    step = size * (paired.moments[0] @ idle) / K[..., None]
    d = size * panels.curvature
    # changes of curvature in the first state, times the length
    excess = size * (paired.moments[0] @ numbers) / K
    kappa = size * paired.check.first.curvature_at(panels.t)
    # changes of curvature in the first state (part 0) and in the second (part d), with both signs
    functions = [(sign * step, sign * (excess - part)) for sign in (1.0, -1.0) for part in (0.0, d)]
    bounds = [] if most_natural is None else [
        (sign * step, size * most_natural + sign * (excess - kappa)) for sign in (1.0, -1.0)
    ]  # fmt: skip
    answer = _least_bound(functions, bounds)
    if idle.shape[1] > 1:
        weight = np.sqrt(panels.stretch * WEIGHTS)
        rows = (step * weight[..., None]).reshape(-1, idle.shape[1])
        middle = np.asarray(np.linalg.lstsq(rows, ((d / 2 - excess) * weight).ravel(), rcond=None)[0])
        answer = _towards(answer, middle, functions, bounds)
    return numbers + idle @ answer


# pairs of rows (N, p, r) and offset (N, p), for the values rows @ z + offset at the nodes of the panels
Bounded: TypeAlias = "list[tuple[FloatArray, FloatArray]]"


def _least_bound(functions: Bounded, bounds: Bounded) -> FloatArray:
    """Return the z (r,) within the bounds at which the largest function is least.

    Each function or bound is a pair (rows, offset) with the value rows @ z + offset. The values of bounds
    must be at least 0.
    """
    step = PanelFunction.through(functions[0][0]).dense
    # functions have only upper bounds, so `demand` gets no lower bounds
    program, none = MinimaxProgram(step), step[:0]
    demand, hold = partial(program.demand, none, none[:, 0]), program.hold
    conditions = [
        (PanelFunction.through(rows), PanelFunction.through(offset), require)
        for require, pairs in ((demand, functions), (hold, bounds))
        for rows, offset in pairs
    ]
    for rows, offset, require in conditions:
        require(rows.dense, offset.dense)
    for _ in range(METHOD.most_rounds):
        answer = program.solve()
        if answer is None:  # only z = 0 satisfies the bounds, except for rounding errors
            return np.zeros(none.shape[1])
        z, most = answer
        settled = True
        for rows, offset, require in conditions:
            place = PanelFunction(rows.coefficients @ z + offset.coefficients).extreme_places
            more, beside = rows.at(*place), offset.at(*place)
            values = more @ z + beside
            wrong = values < -BOUNDED * most if require is hold else values > most * (1 + BOUNDED)
            if wrong.any():
                settled = False
                require(more[wrong], beside[wrong])
        if settled:
            return z
    raise unsettled(most)


def _towards(start: FloatArray, goal: FloatArray, functions: Bounded, bounds: Bounded) -> FloatArray:
    """Go from `start` towards `goal` as far as bounds hold and the largest value does not increase."""
    values = [(rows @ start + offset, rows @ (goal - start)) for rows, offset in functions]
    most = max(float(value.max()) for value, _ in values) * (1 + BOUNDED)
    # what is left of each limit at `start`, and how much of it the whole way to `goal` uses
    reserves = [(most - value, change) for value, change in values]
    reserves += [
        (np.maximum(rows @ start + offset, 0.0), -(rows @ (goal - start))) for rows, offset in bounds
    ]
    share = 1.0
    for left, change in reserves:
        rising = change > 0
        share = min(share, float((left[rising] / change[rising]).min(initial=1.0)))
    return start + share * (goal - start)


def _thickest(paired: PairedPanels, limits: PairLimits) -> FloatArray:
    """Return the moment parameters (6,) of the flexure with the largest least thickness at a given strain.

    A section with moment M, stiffness K and thickness h ~ K^(1/3) has the strain |M| h / (2 K) ~ |M| K^(-2/3),
    which is scaled to at most 1. The convex problem is to maximise k subject to K >= k and |M_i| <= K^(2/3) in both
    states i. A linear program replaces the power by tangents. More tangents are added until k converges.
    """
    from scipy.optimize import linprog

    panels, size, basis = paired.panels, paired.check.length, paired.solutions
    # a flexure evaluates the strain at its own nodes
    place = panels.locate(paired.check.first.parameter(np.linspace(0.0, size, 301)))

    def rows_of(values: FloatArray) -> FloatArray:
        return PanelFunction.through(values @ basis).at(*place)

    K = rows_of(paired.stiffness_rows)
    M = np.concatenate([size * rows_of(moment) for moment in paired.moments])
    # scale the unknowns, of which some change only the moments
    scale = np.abs(K).max(axis=0)
    scale = np.where(scale > 1e-12 * scale.max(), scale, np.abs(M).max(axis=0))
    K, M = K / scale, M / scale
    stiff, count = np.concatenate([K, K]), K.shape[1]

    def conditions(rows: FloatArray, share: float = 0.0, right: FloatArray | float = 0.0) -> FloatArray:
        """Return the conditions rows @ numbers + share k <= right, with the right-hand sides in the last column."""
        return np.column_stack([rows, np.full(len(rows), share), np.full(len(rows), right)])

    def tangents(at: FloatArray) -> FloatArray:
        """Return conditions that limit |M| by the tangents of K^(2/3) at the stiffnesses `at`."""
        slope, offset = (2 / 3 * at ** (-1 / 3))[:, None] * stiff, at ** (2 / 3) / 3
        return np.concatenate([conditions(M - slope, 0.0, offset), conditions(-M - slope, 0.0, offset)])

    # k <= K and |M_1 - M_2| = K d <= 2 K^(2/3), so k <= (2 / d)^3 at the largest curvature difference d
    most = (2 / max(float(np.abs(size * panels.curvature).max()), 1e-12)) ** 3
    table = [conditions(-K, 1.0)]
    table += [conditions(-rows_of(rows) / scale) for rows in _limit_rows(paired, limits)]
    if limits.ratio is not None:
        table.append(conditions(K, -limits.ratio))
    first = np.geomspace(most / WIDEST_TANGENTS, most * WIDEST_TANGENTS, TANGENTS)
    table += [tangents(np.full(len(stiff), k)) for k in first]
    before = np.inf
    for _ in range(30):
        rows = np.concatenate(table)
        result = linprog(
            -np.eye(count + 1)[-1], rows[:, :-1], rows[:, -1], bounds=(None, None), method="highs"
        )
        if result.status != 0 or not result.x[-1] > 0:
            _refuse(paired.check, limits, None)
        least, numbers = float(result.x[-1]), result.x[:-1]
        # the least stiffness has converged
        if abs(before / least - 1) < 1e-6:
            break
        before = least
        table.append(tangents(np.maximum(stiff @ numbers, least)))
    return np.asarray(basis @ (numbers / scale))


def _rod_of(paired: PairedPanels, numbers: FloatArray, samples: int) -> TwoStateRod:
    """Return the rod whose stiffness and moments the `numbers` determine, scaled to a least stiffness of 1."""
    check, panels, size = paired.check, paired.panels, paired.check.length
    nodes = check.first.survey if samples == DEFAULT_SAMPLES else check.first.sample(samples)
    other = check.second.at(np.minimum(nodes.s, check.second.length))
    place = panels.locate(nodes.t)
    stiffness = PanelFunction.through(paired.stiffness_rows @ numbers)
    moments = [PanelFunction.through(rows @ numbers) for rows in paired.moments]
    K = stiffness.at(*place)
    least = float(K.min())
    if least <= 0:
        text = (
            "The stiffness would be 0 between two places where the curvatures are equal. Move these places "
            "apart."
        )
        raise NotRealizable(replace(check, realizable=False, reasons=(text,)))
    K = K / least
    nodal = [moment.at(*place) / least for moment in moments]
    rest = nodes.curvature - nodal[0] / K
    curve_check = EquilibriumCheck(
        realizable=True, reasons=(), warnings=(), length=size, curve=check.first, bent_beforehand=True,
        zeros=tuple(CurvatureZero(z.s, z.t, "crossing", z.s, z.t, z.before, z.after) for z in check.zeros),
    )  # fmt: skip
    kinks = [(jump.s, jump.continuity - 2) for jump in check.second.breaks if jump.continuity < SMOOTH]
    force = [numbers[1:3] / size / least, numbers[3:5] / size / least]
    # `stiffness_profile` does not use the moment and the force
    balance = BalancedStiffness(panels, stiffness, moments[0], moments[0], kinks=kinks)
    profile = stiffness_profile(curve_check, balance, 1 / least)
    first, second = (
        Rod(
            s=nodes.s, position=at.position, angle=at.angle, curvature=at.curvature, stiffness=K, moment=moment,
            force=np.tile([-b[1], b[0]], (K.size, 1)), profile=profile, natural_curvature=rest, shape=curve,
            residual=float(np.abs(K * (at.curvature - rest) - moment).max() / max(np.abs(moment).max(), 1e-300)),
        )
        for at, moment, b, curve in zip((nodes, other), nodal, force, (check.first, check.second), strict=True)
    )  # fmt: skip
    return TwoStateRod(first, second, check)


def _with_free_state(check: PairCheck, free: State, samples: int) -> TwoStateRod:
    """Return the rod with one curve as its natural shape, so that this state needs no clamps and has no moment."""
    natural, held = (check.first, check.second) if free == "first" else (check.second, check.first)
    count = None if samples == DEFAULT_SAMPLES else samples
    bent = rod_of_request(RodRequest(held, natural_curvature=CurveOfRest.of(natural), samples=count))
    at = natural.at(np.minimum(bent.s, natural.length))
    none = np.zeros(bent.s.size)
    bent = replace(bent, natural_curvature=at.curvature, check=None)
    loose = replace(
        bent, position=at.position, angle=at.angle, curvature=at.curvature, moment=none,
        force=np.zeros_like(bent.force), residual=0.0, shape=natural, warnings=(), moved=0.0,
    )  # fmt: skip
    states = (loose, bent) if free == "first" else (bent, loose)
    return TwoStateRod(*states, replace(check, realizable=True, reasons=()), free)


def _refuse_beyond_limits(limits: PairLimits, pair: TwoStateRod) -> TwoStateRod:
    natural = float(np.abs(pair.natural_curvature).max())
    reached = (pair.ratio, limits.ratio), (natural, limits.natural_curvature), (pair.bend, limits.bend)
    # the linear program has an accuracy of 1e-6
    if any(most is not None and value > most * (1 + 1e-6) for value, most in reached):
        _refuse(pair.check, limits, pair)
    return pair


def _refuse(check: PairCheck, limits: PairLimits, pair: TwoStateRod | None) -> NoReturn:
    """Raise `NotRealizable` for limits that no rod meets.

    `pair` is the rod without the limits, if it is known.
    """
    wanted = [
        template.format(value)
        for template, value in (
            ("a ratio of at most {:.4g}", limits.ratio),
            ("a natural curvature of at most {:.4g} 1/mm", limits.natural_curvature),
            ("a bend of at most {:.4g} 1/mm", limits.bend),
        )
        if value is not None
    ]
    limited = f" with {', '.join(wanted)}" if wanted else ""
    reason = f"No strip{limited} can rest in both curves."
    if pair is not None:
        natural = float(np.abs(pair.natural_curvature).max())
        reason += (
            f" The strip with the least ratio has a ratio of {pair.ratio:.4g}, a natural curvature of up to "
            f"{natural:.4g} 1/mm and a bend of up to {pair.bend:.4g} 1/mm."
        )
    reason += " Raise the limits, or draw the two curves closer to each other."
    raise NotRealizable(replace(check, realizable=False, reasons=(reason,)))
