"""Stiffness of least ratio with which a rod is in equilibrium on a curve.

The ratio is the largest divided by the least stiffness along the rod. The rod has no weight, weight proportional to
its stiffness, weight in newtons, or the weight of a section.
"""

from dataclasses import dataclass, replace
from typing import NoReturn

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.errors import FieldName, InputError, Length, NotConvergedError, note, rounded_up
from elastica_cad.geometry.polynomials import PanelFunction
from elastica_cad.geometry.profile import Profile
from elastica_cad.mechanics.cross_sections import Section
from elastica_cad.mechanics.loads import STANDARD_GRAVITY_M_S2, ExcessCurvature, Gravity, Weight
from elastica_cad.mechanics.moment_conditions import (
    BOUNDED,
    NO_GAIN_SHARE,
    SMOOTHING_SHARE,
    BalancedStiffness,
    ConditionedRows,
    RodRequest,
    StateFamily,
    StiffnessFamily,
    largest_within,
    least_ratio,
    moment_rows,
    weighted_moment_rows,
)
from elastica_cad.mechanics.quadrature_panels import REFINEMENTS, CutCurve, Panels
from elastica_cad.mechanics.rod import DEFAULT_SAMPLES
from elastica_cad.mechanics.theorem1 import NotRealizable, refused

LEAST_SHARE = 1e-6
"""Least stiffness of a strip that can be built, as a fraction of its largest stiffness."""


class OverloadError(InputError):
    """Error if no stiffness within its limits carries the weight.

    Attributes
    ----------
    needed : float
        Least value, N mm2, of the largest bending stiffness with which a rod carries the weight.
    thickening : float or None
        Factor by which the sheet must be thicker to carry the weight within the same limits of width. None if no
        thickness carries it.
    """

    def __init__(self, needed: float, most: float, thickening: float | None) -> None:
        super().__init__(
            "The weight requires a bending stiffness of {needed:.4g} N mm2 at the stiffest place, but "
            "largest_stiffness is {most:.4g} N mm2. Increase largest_stiffness.",
            needed=rounded_up(needed, 4),
            most=most,
        )
        self.needed, self.thickening = needed, thickening


def balance_of(request: RodRequest) -> BalancedStiffness:
    """Return the stiffness K with the least ratio max K / min K for a request."""
    if request.section is not None:
        return _with_section(request, request.section)
    loaded = request.gravity is not None or request.point_forces
    return _with_weight(request) if loaded else balance_without_weight(request)


def balance_without_weight(request: RodRequest) -> BalancedStiffness:
    """Return the stiffness K with the least ratio max K / min K of a rod without weight (paper, Eq. 4)."""
    problem, numbers, cut = _weightless(request)
    state = problem.least(numbers, smooth=bool(request.elements))
    return replace(problem.balance(problem.steadied(state)), kinks=cut.kinks)


def ratio_within(request: RodRequest, most: float) -> float | None:
    """Return the least stiffness ratio of a weightless rod, or None if it is above `most` or no rod exists.

    `balance_of` takes longer, because it computes the reason why no rod exists.
    """
    problem, numbers, _ = _weightless(request)
    optimum = problem.ratio(numbers, most=most)
    return None if optimum is None or optimum[1] > most else optimum[1]


def _weightless(request: RodRequest) -> tuple[ConditionedRows, StateFamily, CutCurve]:
    """Return the conditions of a rod without weight, their solutions, and the finally cut curve.

    With rails, pins and ties, the curve is cut until the stiffness is resolved.
    """
    cut = request.cut
    for _ in range(REFINEMENTS):
        problem = ConditionedRows(request, cut.panels, moment_rows(cut.panels, request.units_on(cut.panels)))
        numbers = problem.homogeneous(loaded=False)
        # refine the intervals, because rails, pins and ties vary the stiffness strongly near zeros of the curvature
        finer = cut.for_stiffness(numbers.family.columns) if request.elements else None
        if finer is None:
            break
        cut = finer
    return problem, numbers, cut


def _with_weight(request: RodRequest) -> BalancedStiffness:
    """Return the stiffness K with the least ratio max K / min K under weight (paper, Eq. 6)."""
    cut, gravity, weight = request.cut, request.gravity, request.weight
    if weight is None and request.forces:
        weight = Weight(own=gravity is not None)
    if gravity is not None and (weight is None or weight.own):
        cut = cut.for_weight(gravity)
    tau = None if request.bending_stiffness is None else 1 / request.bending_stiffness
    for _ in range(REFINEMENTS):
        load = WeightedPanels(request, cut.panels, gravity, weight)
        if request.largest_stiffness is not None and weight is not None:
            balance, tau = _within_stiffness(load, weight, request.largest_stiffness)
        else:
            if tau is None and weight is not None:
                tau = _least_compliance(load, weight)
            problem = load.against(tau or 0.0)
            numbers = problem.homogeneous(loaded=False) if tau is None else problem.at_compliance(tau)
            balance = problem.balance(problem.least(numbers))
        finer = cut.for_stiffness(balance.stiffness)
        if finer is None:
            break
        cut = finer
    if weight is None or tau is None:
        return replace(balance, kinks=cut.kinks)
    carried = None if gravity is None else carried_weight(weight, gravity, 1 / tau)
    return replace(balance, bending_stiffness=1 / tau, weight=carried, kinks=cut.kinks)


def carried_weight(weight: Weight, gravity: Gravity, bending_stiffness: float) -> Weight:
    """Return the weight. If `weight.own` is True, add the weight of the strip.

    `bending_stiffness` is the least bending stiffness of the strip, N mm2.
    """
    if not weight.own:
        return weight
    beta, own = weight.beta, bending_stiffness / gravity.length**3
    if isinstance(beta, Profile):
        return replace(weight, beta=replace(beta, coefficients=beta.coefficients + own), own=False)
    return replace(weight, beta=beta + own, own=False)


@dataclass(frozen=True, eq=False)
class WeightedPanels:
    """Curve cut into panels, with the weight of a rod on this curve.

    `gravity` and `weight` are those of `optimal_rod`. Without `weight`, the weight is proportional to the
    stiffness.
    """

    request: RodRequest
    panels: Panels
    gravity: Gravity | None
    weight: Weight | None

    def against(self, tau: float) -> "ConditionedRows":
        """Return the conditions of equilibrium for a weight in newtons and the least bending stiffness 1 / tau."""
        panels, weight = self.panels, self.weight
        proportional_weight = np.zeros(panels.t.shape)
        if self.gravity is not None and (weight is None or weight.own):
            proportional_weight += self.gravity.length**-3
        dead = np.zeros(panels.t.shape)
        if weight is not None:
            dead, per_stiffness = weight.along(panels.s)
            proportional_weight += per_stiffness * tau
        return self.carrying(proportional_weight, dead, self.points)

    @property
    def points(self) -> FloatArray:
        """Known forces (N + 1, 2), N, at the ends of the panels.

        Forces at held ends are left out, because they do not bend the rod.
        """
        points = np.zeros((self.panels.count + 1, 2))
        unit = 1e-3 * STANDARD_GRAVITY_M_S2 * self.down
        acting = [(mass.s, mass.mass * unit) for mass in self.request.masses]
        acting += [(float(force.s[0]), force.units[0, 0]) for force in self.request.forces]
        for s, newtons in acting:
            points[np.abs(self.panels.edge_s - s).argmin()] += newtons
        for at, end in zip((0, -1), self.request.supports.ends, strict=True):
            points[at] *= not (end.x and end.y)
        return points

    @property
    def down(self) -> FloatArray:
        """Direction of gravity (2,); without gravity an arbitrary direction."""
        return np.array([0.0, -1.0]) if self.gravity is None else np.asarray(self.gravity.direction)

    def carrying(self, own: FloatArray, dead: FloatArray, points: FloatArray) -> "ConditionedRows":
        """Return the conditions of equilibrium for the weights of `weighted_moment_rows`."""
        panels, units = self.panels, self.request.units_on(self.panels)
        with np.errstate(over="ignore", invalid="ignore"):
            rows = weighted_moment_rows(panels, units, -self.down, own, dead, points)
        if not np.isfinite(rows.stiffness).all():
            self.refuse()
        return ConditionedRows(self.request, panels, rows)

    def refuse(self) -> NoReturn:
        """Raise `NotRealizable` for a moment beyond the range of floating-point numbers."""
        check = self.request.check
        assert self.gravity is not None  # only weight makes moments that large
        reason = far_too_heavy(self.gravity, check.length)
        raise NotRealizable(refused(check, reason))


def far_too_heavy(gravity: Gravity, length: float) -> str:
    """Return the message for a curve of `length` mm whose weight is far too large for its stiffness."""
    return note(
        "The weight is far too large for the stiffness: the elasto-gravity length is {gravity_length}, and "
        "the curve is {length} long. Use a lighter or stiffer sheet, or check the units (the elasto-gravity "
        "length of card of 200 g/m2 is 96 mm).",
        gravity_length=Length(gravity.length), length=Length(length),
    )  # fmt: skip


def _least_compliance(load: WeightedPanels, weight: Weight) -> float:
    """Return tau, the inverse of the least bending stiffness, that minimises the stiffness ratio.

    If the ratio decreases with every decrease of tau, the result is the largest tau within 1 % of the best
    ratio.
    """
    if isinstance(weight.beta, Profile) or weight.beta:
        return _searched_compliance(load, weight)
    problem = load.against(1.0)
    _require_fixed_weight(problem, weight)
    # least ratio for tau = 0 (`light`), and over all tau (`heavy`); row 3 of the basis is tau
    light, numbers = problem.ratio(problem.homogeneous(loaded=False)), problem.homogeneous(loaded=True)
    heavy = problem.ratio(numbers)
    if heavy is None:
        problem.refuse(numbers.family)
    if light is None or heavy[1] < light[1] * (1 - NO_GAIN_SHARE):
        tau = float((numbers.basis @ heavy[0])[3])
    else:
        y = largest_within(numbers.family, numbers.basis[3], light[1] * (1 + SMOOTHING_SHARE))
        tau = float(numbers.basis[3] @ y)
    if tau <= 0:  # rounding errors of large coefficients can make tau negative
        load.refuse()
    return tau


def _require_fixed_weight(problem: ConditionedRows, weight: Weight) -> None:
    if not problem.rows.loaded:
        raise InputError(
            "the masses do not bend the rod, because a held end carries them or they are 0: hang them "
            "between the ends, or remove them"
            if weight.masses or problem.request.forces
            else "the weight is proportional to the stiffness, so it does not determine the bending stiffness. "
            "Give bending_stiffness, or remove `weight`"
        )


def _searched_compliance(load: WeightedPanels, weight: Weight) -> float:
    """Return tau, 1/(N mm2), by a search, because with `beta` the ratio is not a linear program in tau.

    `_least_compliance` explains the choice of tau.
    """
    from scipy.optimize import brentq, minimize_scalar

    def ratio(logarithm: float) -> float:
        tau = float(np.exp(logarithm))
        try:
            problem = load.against(tau)
            optimum = problem.ratio(problem.at_compliance(tau))
        except NotRealizable:
            return np.inf
        return np.inf if optimum is None else optimum[1]

    s = np.linspace(0.0, load.request.check.length, 101)
    newtons = float(replace(weight, own=False).lumped(s, np.ones(101), np.full(101, s[1])).sum())
    weightless = load.against(0.0)
    light = weightless.ratio(weightless.homogeneous(loaded=False))
    bent = float(np.abs(weightless.panels.curvature).max())
    # the curvature is tau times the moment, which is at most about newtons * length
    # logarithms of tau
    trial = np.log(bent / (newtons * load.request.check.length)) + np.linspace(-8.0, 4.0, 25)
    ratios = np.array([ratio(x) for x in trial])
    best = int(ratios.argmin())
    if not np.isfinite(ratios[best]):
        weightless.refuse(None)
    if light is None or ratios[best] < light[1] * (1 - NO_GAIN_SHARE):
        bounds = (trial[max(best - 1, 0)], trial[min(best + 1, 24)])
        minimum = minimize_scalar(ratio, bounds=bounds, method="bounded", options={"xatol": 1e-6})
        return float(np.exp(minimum.x if minimum.fun <= ratios[best] else trial[best]))
    # each decrease of tau lowers the ratio, towards that without weight: take the largest tau within the limit
    limit = light[1] * (1 + SMOOTHING_SHARE)
    within = np.flatnonzero(ratios <= limit)[-1]
    if within == 24:
        return float(np.exp(trial[-1]))
    low, high = trial[within], trial[within + 1]
    # brentq needs a finite value where no rod exists
    return float(np.exp(brentq(lambda x: min(ratio(x), 2 * limit) - limit, low, high, xtol=1e-6)))


def _within_stiffness(load: WeightedPanels, weight: Weight, most: float) -> tuple[BalancedStiffness, float]:
    """Return the stiffness of least ratio with the largest value `most`, N mm2, and 1 / its least value.

    The method iterates, because a weight proportional to the stiffness depends on the least value.
    """
    least = max(load.request.least_stiffness or 0.0, LEAST_SHARE * most) * (1 + BOUNDED)
    most /= 1 + BOUNDED
    tau = 1 / most
    for _ in range(MOST_ROUNDS):
        problem = load.against(tau)
        _require_fixed_weight(problem, weight)
        stiffest = problem.stiffest(most, least)
        if stiffest is None:
            raise _overload(load, problem, least, most)
        before, (state, tau) = tau, stiffest
        if not weight.beta or abs(tau / before - 1) < SETTLED_SHARE:
            return problem.balance(state), tau
    raise NotConvergedError(
        "the computation of weight and stiffness did not converge: set `bending_stiffness`"
    )


def _overload(load: WeightedPanels, problem: ConditionedRows, least: float, most: float) -> OverloadError:
    """Return the error of a load that needs more stiffness than `most`, with a remedy by a thicker sheet."""
    bound = max(least, LEAST_SHARE * problem.load_stiffness)
    numbers = problem.at_compliance(1 / bound)
    needed = problem.ratio(numbers)
    if needed is None:
        problem.refuse(numbers.family)
    try:
        thickening = _thickening_factor(load, least, most)
    except NotConvergedError:  # suggest no thicker sheet
        thickening = None
    return OverloadError(bound * needed[1], most, thickening)


def _thickening_factor(load: WeightedPanels, least: float, most: float) -> float | None:
    """Return the factor on the thickness with which the sheet carries the weight at the same widths, or None."""
    factor = 1.0
    for _ in range(MOST_ROUNDS):
        # the stiffness grows with the cube of the thickness, the weight of the sheet in proportion to it
        thick = replace(load, gravity=load.gravity and load.gravity.scaled(factor**-2))
        problem = thick.against(1 / (factor**3 * least))
        light, numbers = problem.ratio(problem.homogeneous(loaded=False)), problem.homogeneous(loaded=True)
        if light is None or light[1] * (1 + FIT_SHARE) >= most / least:
            return None
        tau = numbers.basis[3] @ largest_within(numbers.family, numbers.basis[3], most / least)
        before, factor = factor, float(1 / (tau * least)) ** (1 / 3)
        if abs(factor / before - 1) < FIT_SHARE:
            break
    return factor


MOST_ROUNDS = 40
"""Largest number of linear programs in the search for a section."""

SETTLED_SHARE = 1e-7
"""The iteration for weight and E I stops when E I changes by a smaller fraction.

The relative error of the weight is about the square of this fraction.
"""

TANGENT_STEP = 1e-4
"""Relative change of E I in the finite difference for the derivative of the weight per length."""

FIT_SHARE = 1e-5
"""Largest accepted relative violation of the limits of E I."""

HOPELESS_SHARE = 1e-4
"""The iteration stops if E I falls below this fraction of the E I of the least section."""

WIDEST_REACH = 0.1
"""Largest root mean square change of E I in a step of a descent, as a fraction of the limit of E I."""

MOST_STEPS = 150

SHORTER, LONGER = 0.5, 1.2
"""Factors on the largest step of a descent: after a reversal of direction, and after any other step."""

LONGEST_JUMP = float(np.log(4.0))
"""Largest change of the natural logarithm of a scale by extrapolation."""


def _with_section(request: RodRequest, section: Section) -> BalancedStiffness:
    """Return the stiffness K with the least ratio max K / min K, scaled to the limits of a section.

    Each iteration linearises the weight at the last E I, solves the linear program in the relative stiffness
    K (paper, Eq. 6), and updates the scale. The result is a local optimum, because the full problem is not
    linear.
    """
    excess, gravity = ExcessCurvature(request.check.curve, request.natural_curvature), request.gravity
    if gravity is None:
        balance = balance_without_weight(request)
        bent = _bent(section, balance.panels, excess)
        return _within_limits(
            replace(balance, bending_stiffness=_fitting_scale(bent, balance.stiffness)), bent
        )
    # the section determines the weight per length, so only the masses remain
    request = replace(request, weight=Weight(masses=request.masses))
    bent = section.bent(0.0)
    # first guess of the elasto-gravity length: its cube is E I over the weight per length
    cube = float(bent.bending_stiffness(bent.deciding_limit) / bent.weight_per_length(bent.deciding_limit))
    heavy = replace(gravity, length=cube ** (1 / 3))
    cut = request.cut.for_weight(heavy)
    for _ in range(REFINEMENTS):
        load = WeightedPanels(request, cut.panels, heavy, request.weight)
        bent = _bent(section, cut.panels, excess)
        balance = _converged_balance(load, bent)
        finer = cut.for_stiffness(balance.stiffness)
        if finer is None:
            break
        cut = finer
    return replace(_within_limits(balance, bent), kinks=cut.kinks)


def _bent(section: Section, panels: Panels, excess: ExcessCurvature) -> Section:
    return section.bent(panels.curvature, excess.rest_at(panels.t))


def tangent_weight(section: Section, bending_stiffness: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Linearise the weight per length of a section, N/mm, at the bending stiffnesses E I (n,), N mm2.

    Return its slope (n,) by E I, and its constant part (n,).
    """
    below, at, above = (
        section.weight_per_length(section.parameter(bending_stiffness * (1 + step)))
        for step in (-TANGENT_STEP, 0.0, TANGENT_STEP)
    )
    slope = (above - below) / (2 * TANGENT_STEP * bending_stiffness)
    return slope, at - slope * bending_stiffness


def _converged_balance(load: WeightedPanels, section: Section) -> BalancedStiffness:
    """Return the stiffness in equilibrium with the weight per length of a section, which is not linear in E I.

    Each round replaces the weight by its tangent at the E I of the round before.
    """
    points = load.points
    assert load.gravity is not None
    proportional_weight = np.full(load.panels.t.shape, load.gravity.length**-3)
    light = load.carrying(proportional_weight, np.zeros(proportional_weight.shape), 0.0 * points)
    balance = light.balance(light.least(light.homogeneous(loaded=False)))
    scale = _fitting_scale(section, balance.stiffness)
    EI = scale * balance.stiffness.nodal
    change = np.inf
    history: list[float] = []
    for _ in range(MOST_ROUNDS):
        tangent = tangent_weight(section, EI)
        problem = load.carrying(*tangent, points)
        try:
            state = problem.least(problem.at_compliance(1 / scale))
        except (NotConvergedError, NotRealizable) as error:
            # the weight is the cause, because `light` has a solution; a stiffness that still grows many times over
            # says nothing about the curve
            if isinstance(error, NotRealizable) and not 10 < change < np.inf:
                raise
            raise _unsettled(section, change) from error
        balance = problem.balance(state)
        next_EI = scale * balance.stiffness.nodal
        tried, scale = scale, _fitting_scale(section, balance.stiffness)
        change, EI = max(float(np.abs(next_EI / EI - 1).max()), abs(scale / tried - 1)), next_EI
        if change < SETTLED_SHARE:
            return replace(balance, bending_stiffness=tried, weight=_weight(load, tangent, tried))
        least, _ = section.limits
        if least > 0 and (EI / section.bending_stiffness(least)).min() < HOPELESS_SHARE:
            raise _unsettled(section, change)
        history.append(np.log(scale))
        if len(history) == 3:
            scale = float(np.exp(extrapolated(*history)))
            history.clear()
    return _balance_by_descent(load, section, tried * state[:3], EI)


def _balance_by_descent(
    load: WeightedPanels, section: Section, state: FloatArray, EI: FloatArray
) -> BalancedStiffness:
    """Return the stiffness in equilibrium that fits a section, by a descent in short steps.

    If the section has an upper limit, the least E I is maximised. If it has none, the largest E I is minimised.
    The steps become shorter after each reversal, because linear programs oscillate if the optimum is not at a
    vertex. `state` is the moment (N mm) and force (N) at the end of the curve, an array (3,).
    """
    deciding, points = section.deciding_limit, load.points
    limit, scale = section.bending_stiffness(deciding), float(section.bending_stiffness(deciding).min())
    # with -1, the least E I is maximised; with 1, the largest E I is minimised
    sense = -1.0 if np.isfinite(section.limits[1]) else 1.0
    reach, before = WIDEST_REACH, np.zeros(EI.shape)
    for _ in range(MOST_STEPS):
        tangent = tangent_weight(section, EI)
        problem = load.carrying(*tangent, points)
        numbers = problem.at_compliance(1 / scale)
        # the parameters for which the unknowns are nearest to the present state
        off = np.append(state / scale, 1 / scale) - numbers.fixed
        size = np.abs(numbers.basis).max(axis=1, initial=0.0) + np.abs(numbers.fixed)
        here = np.linalg.lstsq(numbers.basis / size[:, None], off / size, rcond=None)[0]
        # values of the family, at least 1 within the limit: E I / limit, or 2 - E I / limit for an upper limit
        share = sense * scale / limit
        rows, offset = (problem.rows.stiffness @ part for part in (numbers.basis, numbers.fixed))
        family = StiffnessFamily.through(load.panels, rows * share[..., None], offset * share + (1.0 - sense))
        optimum = _best_numbers_near(family, here, reach, problem.places)
        if optimum is None:
            break
        unknowns = numbers.fixed + numbers.basis @ optimum
        moved = scale * problem.rows.stiffness @ unknowns
        step = moved / EI - 1
        EI = np.maximum(moved, HOPELESS_SHARE * limit)  # an intermediate E I may be too small, or negative
        state = scale * unknowns[:3]
        if np.abs(step).max() < SETTLED_SHARE:
            weight = _weight(load, tangent, scale)
            return replace(problem.balance(unknowns), bending_stiffness=scale, weight=weight)
        reach = SHORTER * reach if (step * before).sum() < 0 else min(LONGER * reach, WIDEST_REACH)
        before = step
    raise _unsettled(section, np.inf)


def _best_numbers_near(
    family: StiffnessFamily, here: FloatArray, reach: float, places: tuple[IntArray, FloatArray] | None
) -> FloatArray | None:
    """Return the parameters near `here` that minimise the largest stiffness of the family, or None.

    The root mean square change of the values is at most `reach`. If there is no solution, this limit is increased,
    up to 64-fold.
    """
    rows = family.dense[:, :-1]
    _, sizes, ways = np.linalg.svd(rows, full_matrices=False)
    # the norm of moves @ (parameters - here) is the root mean square change of the values
    moves = sizes[:, None] * ways / np.sqrt(len(rows))
    moves = np.concatenate([moves, -moves])
    for factor in (1.0, 4.0, 16.0, 64.0):
        conditions = np.column_stack([moves, factor * reach - moves @ here])
        solution = least_ratio(replace(family, conditions=conditions), places)
        if solution is not None:
            return solution[0]
    return None


def _unsettled(section: Section, change: float) -> NotConvergedError:
    moves = (
        note(" (the stiffness still changes by {change:.2g})", change=change) if np.isfinite(change) else ""
    )
    return NotConvergedError(
        "the iteration of weight and {quantity} did not converge{moves}. Without weight the rod takes this "
        "curve. Use a stiffer or lighter material, or support the rod",
        quantity=section.quantity,
        moves=moves,
    )


def extrapolated(first: float, second: float, third: float) -> float:
    """Return the limit of a sequence of logarithms from its last three terms, by Aitken's method.

    If the logarithms do not converge geometrically, the last logarithm is returned. The limit differs
    from the last logarithm by at most `LONGEST_JUMP`.
    """
    step, before = third - second, second - first
    if before == 0 or not -0.9 < step / before < 0.99:
        return third
    return third + float(np.clip(step**2 / (before - step), -LONGEST_JUMP, LONGEST_JUMP))


def _fitting_scale(section: Section, stiffness: PanelFunction) -> float:
    """Return the factor B, N mm2, with which the bending stiffness B K just fits the limits of a section.

    The largest section is at the upper limit or, without an upper limit, the least section at the lower limit.
    """
    share = PanelFunction.through(stiffness.nodal / section.bending_stiffness(section.deciding_limit))
    extremes = share.extremes
    return 1 / float(extremes.max() if np.isfinite(section.limits[1]) else extremes.min())


def _weight(load: WeightedPanels, tangent: tuple[FloatArray, FloatArray], scale: float) -> Weight:
    """Return the linearised weight along the rod, for the least bending stiffness `scale`, N mm2."""
    s = np.linspace(0.0, load.request.check.length, DEFAULT_SAMPLES)
    place = load.panels.locate(load.request.check.curve.parameter(s))
    slope, fixed = (PanelFunction.through(values).at(*place) for values in tangent)
    return Weight(Profile.interpolate(s, fixed), Profile.interpolate(s, scale * slope), load.request.masses)


def _within_limits(balance: BalancedStiffness, section: Section) -> BalancedStiffness:
    EI = (balance.bending_stiffness or 1.0) * balance.stiffness.nodal
    refuse_below_limits(section, EI, balance.panels.s)
    return balance


def refuse_below_limits(section: Section, bending_stiffness: FloatArray, s: FloatArray) -> None:
    """Refuse bending stiffnesses, N mm2, at arc lengths `s` of the same shape, mm, that need too small sections."""
    least, largest = section.limits
    sizes = section.parameter(bending_stiffness)
    # a section may be smaller than its limit by a fraction that is not visible in four digits
    if sizes.min() < least * (1 - 5e-4):
        raise InputError(
            "with the largest {quantity} of {largest:g}, the curve requires a {quantity} of {given:.4g} at "
            "{s:.4g} from its start, but the limits allow no less than {least:g}. Widen the limits, or use "
            "the nearest possible curve ({field})",
            field=FieldName("limits"),
            quantity=section.quantity,
            given=Length(float(sizes.min())),
            s=Length(float(s.flat[sizes.argmin()])),
            largest=Length(largest),
            least=Length(least),
        )
