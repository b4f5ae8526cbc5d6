"""The stiffness of least ratio on a curve, without weight, with its own, and with weights in newtons."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import NoReturn

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import InputError, NotConvergedError
from elastica_cad.geometry.paths.profile import Profile
from elastica_cad.mechanics.loads.gravity import Gravity
from elastica_cad.mechanics.loads.rest_curvature import NaturalCurvature
from elastica_cad.mechanics.loads.supports import Supports
from elastica_cad.mechanics.loads.weight import STANDARD_GRAVITY_M_S2, PointMass, Weight
from elastica_cad.mechanics.material.moment_curvature import MaterialLaw
from elastica_cad.mechanics.stiffness.curve_cuts import REFINEMENTS, CutCurve
from elastica_cad.mechanics.stiffness.moment_conditions import (
    NO_GAIN_SHARE,
    SMOOTHING_SHARE,
    BalancedStiffness,
    ConditionedRows,
)
from elastica_cad.mechanics.stiffness.moment_rows import LineLoad, moment_rows
from elastica_cad.mechanics.stiffness.quadrature_panels import Panels
from elastica_cad.mechanics.stiffness.stiffness_family import largest_within
from elastica_cad.mechanics.theorem1.verdict import EquilibriumCheck, NotRealizable

COMPLIANCE_STEP = 0.2
"""Of log(1 / B), on the way to lighter rods."""

FITTED_SHARE = 1e-3
"""Of the largest stiffness: what is left for finer panels and for the spline that the width is."""

BEYOND = 1e6
"""Times the stiffness that there is room for: more is as bad."""


def balance_without_weight(
    check: EquilibriumCheck,
    supports: Supports,
    natural_curvature: NaturalCurvature,
    *,
    law: MaterialLaw | None = None,
    nodes: FloatArray | None = None,
) -> BalancedStiffness:
    """Eq. 4 on the continuous curve, or with its ratio judged at the parameters `nodes` only."""
    cut = CutCurve.where_kinked(check, natural_curvature, law)
    problem = ConditionedRows(check, supports, cut.panels, moment_rows(cut.panels), nodes)
    state = problem.least(problem.homogeneous(3), smooth=False)
    return replace(problem.balance(problem.steadied(state)), kinks=cut.kinks)


def balance_with_weight(
    check: EquilibriumCheck,
    supports: Supports,
    natural_curvature: NaturalCurvature,
    gravity: Gravity,
    *,
    law: MaterialLaw | None = None,
    weight: Weight | None = None,
    bending_stiffness: float | None = None,
    largest_stiffness: float | None = None,
    nodes: FloatArray | None = None,
) -> BalancedStiffness:
    """Eq. 6 on the continuous curve, with weight proportional to the stiffness, or in newtons."""
    cut = CutCurve.where_kinked(check, natural_curvature, law, weight)
    if weight is None or weight.own:
        cut = cut.for_weight(gravity)
    tau = None if bending_stiffness is None else 1 / bending_stiffness
    for _ in range(REFINEMENTS):
        load = WeightedPanels(check, supports, cut.panels, gravity, weight, nodes)
        if weight is None:
            problem = load.against(0.0)
            balance = problem.balance(problem.least(problem.homogeneous(3)))
        else:
            if tau is None:
                tau = _least_compliance(load, weight)
                tau = tau if largest_stiffness is None else _compliance_within(load, tau, largest_stiffness)
            problem = load.against(tau)
            balance = problem.balance(problem.least(problem.at_compliance(tau)))
        finer = cut.for_stiffness(balance.stiffness)
        if finer is None:
            break
        cut = finer
    if weight is None or tau is None:
        return replace(balance, kinks=cut.kinks)
    beta = _raised(weight.beta, gravity.length**-3 / tau) if weight.own else weight.beta
    carried = replace(weight, beta=beta, own=False)
    return replace(balance, bending_stiffness=1 / tau, weight=carried, kinks=cut.kinks)


@dataclass(frozen=True, eq=False)
class WeightedPanels:
    """A curve cut into panels, with the weight it is to carry."""

    check: EquilibriumCheck
    supports: Supports
    panels: Panels
    gravity: Gravity
    weight: Weight | None
    nodes: FloatArray | None

    def against(self, tau: float) -> "ConditionedRows":
        """The problem with weights in newtons set against B = 1 / tau."""
        panels, weight = self.panels, self.weight
        proportional = self.gravity.length**-3
        own = np.full(panels.t.shape, proportional if weight is None or weight.own else 0.0)
        dead = np.zeros(panels.t.shape)
        if weight is not None:
            dead, per_stiffness = weight.along(panels.s)
            own += per_stiffness * tau
        points = point_weights(panels, () if weight is None else weight.masses, self.supports)
        return self.carrying(own, dead, points)

    def carrying(self, own: FloatArray, dead: FloatArray, points: FloatArray) -> "ConditionedRows":
        """The problem with weights at the nodes and ends of the panels: see `LineLoad`."""
        panels = self.panels
        rows = moment_rows(panels, LineLoad(-np.asarray(self.gravity.direction), own, dead, points))
        if not np.all(np.isfinite(rows.stiffness)):
            self.refuse()
        return ConditionedRows(self.check, self.supports, panels, rows, self.nodes)

    def refuse(self) -> NoReturn:
        """Raise `NotRealizable`: the moment grows along the curve beyond what numbers can tell."""
        reason = far_too_heavy(self.gravity, self.check.length)
        raise NotRealizable(replace(self.check, realizable=False, reasons=(reason,)))


def far_too_heavy(gravity: Gravity, length: float) -> str:
    """What is told of a curve of `length` mm that its weight bends beyond what numbers can tell."""
    return (
        "The weight is far too much for the stiffness (a gravity length of "
        f"{gravity.length:.4g} mm on a curve of {length:.4g} mm): use a lighter or "
        "stiffer sheet, or look at the units (200 gsm card: 96 mm)."
    )


def point_weights(panels: Panels, masses: Sequence[PointMass], supports: Supports) -> FloatArray:
    """Newtons (N + 1,) hung on the ends of the panels; those at an end that is held in place bend nothing."""
    points = np.zeros(panels.count + 1)
    for mass in masses:
        points[int(np.abs(panels.edge_s - mass.at).argmin())] += mass.mass * 1e-3 * STANDARD_GRAVITY_M_S2
    points[[0, -1]] *= [not (end.x and end.y) for end in supports.ends]
    return points


def _least_compliance(load: WeightedPanels, weight: Weight) -> float:
    """tau = 1 / B of least ratio; where lighter is always better, the largest within 1 % of the best."""
    if isinstance(weight.beta, Profile) or weight.beta:
        return _searched_compliance(load, weight)
    problem = load.against(1.0)
    if problem.scale.size == 3:
        if weight.masses:
            raise InputError(
                "what is hung on the rod bends it nowhere (a held end carries it, or its mass is 0): hang it "
                "between the ends, or leave it out"
            )
        raise InputError(
            "the weight is proportional to the stiffness, so every bending stiffness will do: leave "
            "`weight` out, or give bending_stiffness"
        )
    light, numbers = problem.ratio(problem.homogeneous(3)), problem.homogeneous(4)
    heavy = problem.ratio(numbers)
    if heavy is None:
        problem.refuse(numbers.family)
    if light is None or heavy[1] < light[1] * (1 - NO_GAIN_SHARE):
        tau = float((numbers.basis @ heavy[0])[3])
    else:
        try:
            y = largest_within(numbers.family, numbers.basis[3], light[1] * (1 + SMOOTHING_SHARE))
            tau = float(numbers.basis[3] @ y)
        except NotConvergedError:
            load.refuse()
    if tau <= 0:  # rounding, of rows that grow beyond their digits
        load.refuse()
    return tau


def _searched_compliance(load: WeightedPanels, weight: Weight) -> float:
    """The same where an own weight in newtons makes tau enter twice: by search along tau."""
    from scipy.optimize import brentq, minimize_scalar

    def ratio(logarithm: float) -> float:
        return _ratio_at(load, float(np.exp(logarithm)))

    s = np.linspace(0.0, load.check.length, 101)
    newtons = float(replace(weight, own=False).lumped(s, np.ones(101), np.full(101, s[1])).sum())
    weightless = load.against(0.0)
    light = weightless.ratio(weightless.homogeneous(3))
    bent = float(np.abs(weightless.panels.curvature).max())
    trial = np.log(bent / (newtons * load.check.length)) + np.linspace(-8.0, 4.0, 25)
    ratios = np.array([ratio(x) for x in trial])
    best = int(ratios.argmin())
    if not np.isfinite(ratios[best]):
        weightless.refuse(None)
    if light is None or ratios[best] < light[1] * (1 - NO_GAIN_SHARE):
        bounds = (trial[max(best - 1, 0)], trial[min(best + 1, 24)])
        found = minimize_scalar(ratio, bounds=bounds, method="bounded", options={"xatol": 1e-6})
        return float(np.exp(found.x if found.fun <= ratios[best] else trial[best]))
    limit = light[1] * (1 + SMOOTHING_SHARE)
    within = int(np.flatnonzero(ratios <= limit)[-1])
    if within == 24:
        return float(np.exp(trial[-1]))
    low, high = trial[within], trial[within + 1]
    return float(np.exp(brentq(lambda x: min(ratio(x), 2 * limit) - limit, low, high, xtol=1e-6)))


def _ratio_at(load: WeightedPanels, tau: float) -> float:
    """The least ratio of a rod of B = 1 / tau; infinite where none carries the weight."""
    try:
        problem = load.against(tau)
        found = problem.ratio(problem.at_compliance(tau))
    except NotRealizable:
        return np.inf
    return np.inf if found is None else found[1]


def _compliance_within(load: WeightedPanels, tau: float, most: float) -> float:
    """The compliance next to that of least ratio whose rod is nowhere stiffer than `most`, N mm2.

    The least largest stiffness is the ratio over tau, whose ratio is convex in tau: it falls up to one place and
    rises behind it. Where it stays above `most`, that place is taken.
    """
    from scipy.optimize import brentq, minimize_scalar

    # where inflections leave a choice, the smoothest stiffness takes its share
    room = most / (1 + FITTED_SHARE) / (1 + SMOOTHING_SHARE if load.check.zeros else 1)

    def over(logarithm: float) -> float:
        """log of the largest stiffness over the room for it."""
        stiffest = _ratio_at(load, float(np.exp(logarithm))) / np.exp(logarithm)
        return float(np.log(min(stiffest / room, BEYOND)))

    start = before = float(np.log(tau))
    last = over(start)
    if last <= 0:
        return tau
    while True:
        after = before + COMPLIANCE_STEP
        here = over(after)
        if here <= 0:
            return float(np.exp(brentq(over, before, after, xtol=1e-6)))
        if here >= last:
            break
        before, last = after, here
    around = (max(before - COMPLIANCE_STEP, start), after)
    lowest = minimize_scalar(over, bounds=around, method="bounded", options={"xatol": 1e-6})
    if lowest.fun <= 0:
        return float(np.exp(brentq(over, around[0], lowest.x, xtol=1e-6)))
    return float(np.exp(lowest.x if lowest.fun < over(start) else start))


def _raised(value: float | Profile, step: float) -> float | Profile:
    if isinstance(value, Profile):
        return Profile(value.knots, value.coefficients + step, value.degree)
    return value + step
