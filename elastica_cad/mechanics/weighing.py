"""The stiffness of least ratio on a curve: supports and inflections as conditions, weight as a load."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import NoReturn

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.errors import InputError
from elastica_cad.geometry import Profile
from elastica_cad.mechanics.equilibrium import EquilibriumCheck, NotRealizable
from elastica_cad.mechanics.gravity import Gravity
from elastica_cad.mechanics.gravity_lp import largest_number
from elastica_cad.mechanics.loads import STANDARD_GRAVITY, Weight
from elastica_cad.mechanics.material_laws import MaterialLaw
from elastica_cad.mechanics.moment_rows import LineLoad, MomentRows, moment_rows
from elastica_cad.mechanics.panels import PanelFunction, Panels, cut_into_panels
from elastica_cad.mechanics.stiffness_family import (
    StiffnessFamily,
    dense_places,
    least_ratio,
    smoothest,
    wrong_places,
)
from elastica_cad.mechanics.supports import Supports

__all__ = ["BalancedStiffness", "balance_with_weight", "balance_without_weight"]

SMOOTHING = 0.01
"""How much ratio section 5.3 gives for smoothness."""

NO_GAIN = 1e-6
"""Relative gain in ratio below which a heavier strip is no better than a weightless one."""

ROUGH = 1e-9
"""Last Legendre coefficients of K in a panel, relative to K, that call for smaller panels."""

REFINEMENTS = 6

WIDEST = 1e10
"""A stiffness that may vary by this factor is beyond all strips, and beyond the numbers of a computer."""

RANK = 1e-7
"""Conditions that depend on each other to this accuracy count as dependent."""


@dataclass(frozen=True, eq=False)
class BalancedStiffness:
    """A stiffness in balance on a curve, least value about 1, as functions over panels.

    Attributes
    ----------
    stiffness, moment, force : PanelFunction
        K, M (1/mm) and b (1/mm2).
    bending_stiffness, weight
        B in N mm2 and the weight it goes with, where the weight is in newtons.
    kinks : sequence of (s, continuity)
        Places where the load or the material law makes K less smooth than the curve does.
    """

    panels: Panels
    stiffness: PanelFunction
    moment: PanelFunction
    force: PanelFunction
    bending_stiffness: float | None = None
    weight: Weight | None = None
    kinks: Sequence[tuple[float, int]] = ()


def balance_without_weight(
    check: EquilibriumCheck,
    supports: Supports,
    natural_curvature: float,
    *,
    law: MaterialLaw | None = None,
    nodes: FloatArray | None = None,
) -> BalancedStiffness:
    """Eq. 4 on the continuous curve, or with its ratio judged at the parameters `nodes` only."""
    cuts, kinks = _law_places(check, natural_curvature, law)
    panels = _panels(check, natural_curvature, law, cuts)
    problem = _Conditioned(check, supports, panels, moment_rows(panels), nodes)
    state = problem.least(problem.homogeneous(3), smooth=False)
    return replace(problem.balance(problem.steadied(state)), kinks=kinks)


def balance_with_weight(
    check: EquilibriumCheck,
    supports: Supports,
    natural_curvature: float,
    gravity: Gravity,
    *,
    law: MaterialLaw | None = None,
    weight: Weight | None = None,
    bending_stiffness: float | None = None,
    nodes: FloatArray | None = None,
) -> BalancedStiffness:
    """Eq. 6 on the continuous curve, with weight proportional to the stiffness, or in newtons."""
    cuts, kinks = _law_places(check, natural_curvature, law)
    load_cuts, load_kinks = _load_places(check, weight)
    cuts, kinks = [*cuts, *load_cuts], [*kinks, *load_kinks]
    panels = _panels(check, natural_curvature, law, cuts)
    if weight is None or weight.own:
        cuts = [*cuts, *_heavy_cuts(panels, gravity)]
        panels = _panels(check, natural_curvature, law, cuts)
    tau = None if bending_stiffness is None else 1 / bending_stiffness
    for _ in range(REFINEMENTS):
        load = _Load(check, supports, panels, gravity, weight, nodes)
        if weight is None:
            problem = load.against(0.0)
            balance = problem.balance(problem.least(problem.homogeneous(3)))
        else:
            tau = _least_compliance(load, weight) if tau is None else tau
            problem = load.against(tau)
            balance = problem.balance(problem.least(problem.at_compliance(tau)))
        rough = balance.stiffness.unresolved(ROUGH)
        if not rough.any():
            break
        cuts = [*cuts, *((panels.edges[1:] + panels.edges[:-1]) / 2)[rough]]
        panels = _panels(check, natural_curvature, law, cuts)
    if weight is None or tau is None:
        return replace(balance, kinks=kinks)
    beta = _raised(weight.beta, gravity.length**-3 / tau) if weight.own else weight.beta
    carried = replace(weight, beta=beta, own=False)
    return replace(balance, bending_stiffness=1 / tau, weight=carried, kinks=kinks)


@dataclass(frozen=True, eq=False)
class _Load:
    """A curve cut into panels, with the weight it is to carry."""

    check: EquilibriumCheck
    supports: Supports
    panels: Panels
    gravity: Gravity
    weight: Weight | None
    nodes: FloatArray | None

    def against(self, tau: float) -> "_Conditioned":
        """The problem with weights in newtons set against B = 1 / tau."""
        panels, weight = self.panels, self.weight
        proportional = self.gravity.length**-3
        own = np.full(panels.t.shape, proportional if weight is None or weight.own else 0.0)
        dead, points = np.zeros(panels.t.shape), np.zeros(panels.count + 1)
        if weight is not None:
            own += _along(weight.beta, panels.s) * tau
            dead = _along(weight.alpha, panels.s)
            for mass in weight.masses:
                points[int(np.abs(panels.edge_s - mass.at).argmin())] += mass.mass * 1e-3 * STANDARD_GRAVITY
        load = LineLoad(-np.asarray(self.gravity.direction), own, dead, points)
        return _Conditioned(self.check, self.supports, panels, moment_rows(panels, load), self.nodes)


@dataclass(frozen=True, eq=False)
class _Numbers:
    """A family of stiffnesses: state (M, b_x, b_y, tau) at the curve's end = fixed + basis @ free numbers."""

    family: StiffnessFamily
    basis: FloatArray
    fixed: FloatArray


@dataclass(frozen=True, eq=False)
class _Conditioned:
    """Moment rows under the conditions of inflections and supports."""

    check: EquilibriumCheck
    supports: Supports
    panels: Panels
    rows: MomentRows
    nodes: FloatArray | None

    @property
    def conditions(self) -> FloatArray:
        """Rows (k, m) @ state = 0: no moment where no curvature, no force that no support gives."""
        at = [int(np.abs(self.panels.edges - z.t).argmin()) for z in self.check.zeros]
        found = [self.rows.edge_moment[at]]
        for end, force in zip(self.supports.ends, (self.rows.start_force, self.rows.end_force), strict=True):
            # lambda = R b: the force along x is -b_y, that along y is b_x
            found += [] if end.x else [force[1:2]]
            found += [] if end.y else [force[0:1]]
        return np.concatenate(found)

    @property
    def scale(self) -> FloatArray:
        """Sizes (m,) of the state's numbers."""
        size = np.full(self.rows.edge_moment.shape[1], 1 / self.check.length)
        size[0] = 1.0
        if size.size == 4:
            size[3] = 1 / np.abs(self.rows.edge_moment[:, 3]).max()
        return size

    def homogeneous(self, count: int) -> _Numbers:
        """All stiffnesses of the first `count` numbers of the state (3: without dead weight)."""
        basis = np.zeros((self.scale.size, count))
        basis[:count] = np.diag(self.scale[:count])
        free, _ = _solutions(self.conditions @ basis, np.zeros(len(self.conditions)))
        basis = basis @ free
        side = basis[3:4] if count == 4 and self.scale.size == 4 else None
        return _Numbers(
            StiffnessFamily(self.panels, PanelFunction.through(self.rows.stiffness @ basis), side_rows=side),
            basis,
            np.zeros(self.scale.size),
        )

    def at_compliance(self, tau: float) -> _Numbers:
        """All stiffnesses with least bending stiffness 1 / tau."""
        size = self.scale
        if size.size == 3:
            return self.homogeneous(3)
        basis, fixed = np.zeros((4, 3)), np.array([0.0, 0.0, 0.0, tau])
        basis[:3] = np.diag(size[:3])
        free, particular = _solutions(self.conditions @ basis, -self.conditions @ fixed)
        if particular is None:
            self.refuse(None)
        fixed, basis = fixed + basis @ particular, basis @ free
        offset = PanelFunction.through(self.rows.stiffness @ fixed)
        return _Numbers(
            StiffnessFamily(self.panels, PanelFunction.through(self.rows.stiffness @ basis), offset),
            basis,
            fixed,
        )

    def ratio(self, numbers: _Numbers) -> tuple[FloatArray, float] | None:
        """Free numbers of least ratio, and that ratio."""
        if numbers.family.freedom == 0 and numbers.family.offset is None:
            return None
        if numbers.family.freedom > 0:
            rows, _ = numbers.family.at(*dense_places(self.panels))
            sizes = np.abs(rows).sum(axis=1)
            if not sizes.max() < WIDEST * sizes.min():
                return None
        return least_ratio(numbers.family, self.places)

    @property
    def places(self) -> tuple[IntArray, FloatArray] | None:
        """Panels and places x of the nodes at which alone the ratio is judged, if so wished."""
        return None if self.nodes is None else self.panels.locate(self.nodes)

    def steadied(self, state: FloatArray) -> FloatArray:
        """A constant moment instead of `state` where that is as good: on arcs the program has many optima."""
        if self.check.zeros:
            return state
        rows = PanelFunction.through(self.rows.stiffness).at(*(self.places or dense_places(self.panels)))
        K, steady = rows @ state, np.abs(rows[:, 0])
        if steady.max() * K.min() > (1 + NO_GAIN) * K.max() * steady.min():
            return state
        return np.array([np.sign(rows[0, 0]), 0.0, 0.0])

    def least(self, numbers: _Numbers, *, smooth: bool = True) -> FloatArray:
        """The state (m,) at the curve's end of the least ratio, smoothed where inflections leave a choice."""
        found = self.ratio(numbers)
        if found is None:
            self.refuse(numbers.family)
        y, ratio = found
        choices = numbers.family.freedom - (numbers.family.offset is None)
        if smooth and self.check.zeros and choices > 0:
            y = smoothest(numbers.family, ratio * (1 + SMOOTHING))
        return np.asarray(numbers.fixed + numbers.basis @ y)

    def balance(self, state: FloatArray) -> BalancedStiffness:
        """The functions that a state at the curve's end belongs to."""
        K = self.rows.stiffness @ state
        return BalancedStiffness(
            self.panels,
            PanelFunction.through(K),
            PanelFunction.through(K * self.panels.curvature),
            PanelFunction.through(self.rows.force @ state),
        )

    def refuse(self, family: StiffnessFamily | None) -> NoReturn:
        """Raise `NotRealizable` with the reason and the places."""
        listed = ", ".join(f"{z.s:.4g}" for z in self.check.zeros)
        if family is None or (family.freedom == 0 and family.offset is None):
            reason = (
                "With this weight and these supports the moment cannot vanish in all places without "
                f"curvature (at {listed} mm) at once: move the inflections (nearest_rod does), or hold more "
                "at the ends."
            )
        else:
            wrong = wrong_places(family)
            where = f" near {_stretches(wrong, self.check.length)} mm" if wrong.size else ""
            reason = (
                f"With this weight and these supports the moment would have to act against the "
                f"curvature{where}, so no positive stiffness balances the curve: use a lighter or stiffer "
                "sheet, support the strip there, or change the curve."
            )
        raise NotRealizable(replace(self.check, realizable=False, reasons=(*self.check.reasons, reason)))


def _least_compliance(load: _Load, weight: Weight) -> float:
    """tau = 1 / B of least ratio; where lighter is always better, the largest within 1 % of the best."""
    if isinstance(weight.beta, Profile) or weight.beta:
        return _searched_compliance(load, weight)
    problem = load.against(1.0)
    if problem.scale.size == 3:
        raise InputError(
            "the weight is proportional to the stiffness, so every bending stiffness will do: leave "
            "`weight` out, or give bending_stiffness"
        )
    light, numbers = problem.ratio(problem.homogeneous(3)), problem.homogeneous(4)
    heavy = problem.ratio(numbers)
    if heavy is None:
        problem.refuse(numbers.family)
    tau = float((numbers.basis @ heavy[0])[3])
    if light is None or heavy[1] < light[1] * (1 - NO_GAIN):
        return tau
    rows, _ = numbers.family.at(*dense_places(numbers.family.panels))
    return largest_number(rows, numbers.basis[3], light[1] * (1 + SMOOTHING))


def _searched_compliance(load: _Load, weight: Weight) -> float:
    """The same where an own weight in newtons makes tau enter twice: by search along tau."""
    from scipy.optimize import brentq, minimize_scalar

    def ratio(logarithm: float) -> float:
        tau = float(np.exp(logarithm))
        try:
            problem = load.against(tau)
            found = problem.ratio(problem.at_compliance(tau))
        except NotRealizable:
            return np.inf
        return np.inf if found is None else found[1]

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
    if light is None or ratios[best] < light[1] * (1 - NO_GAIN):
        bounds = (trial[max(best - 1, 0)], trial[min(best + 1, 24)])
        found = minimize_scalar(ratio, bounds=bounds, method="bounded", options={"xatol": 1e-6})
        return float(np.exp(found.x if found.fun <= ratios[best] else trial[best]))
    limit = light[1] * (1 + SMOOTHING)
    within = int(np.flatnonzero(ratios <= limit)[-1])
    if within == 24:
        return float(np.exp(trial[-1]))
    low, high = trial[within], trial[within + 1]
    return float(np.exp(brentq(lambda x: min(ratio(x), 2 * limit) - limit, low, high, xtol=1e-6)))


def _panels(
    check: EquilibriumCheck, natural_curvature: float, law: MaterialLaw | None, cuts: Sequence[float]
) -> Panels:
    zeros = [z.t for z in check.zeros]
    return cut_into_panels(check.curve, zeros, cuts=cuts, natural_curvature=natural_curvature, law=law)


def _heavy_cuts(panels: Panels, gravity: Gravity) -> FloatArray:
    """Parameters at which to cut panels longer than sqrt(kappa l_eg^3), on which a heavy K varies."""
    steep = np.sqrt(gravity.length**-3 / np.abs(panels.curvature).max(axis=1))
    parts = np.clip(np.ceil(np.diff(panels.edge_s) * steep / 2), 1, 50).astype(int)
    edges = panels.edges
    inner = [np.linspace(a, b, n + 1)[1:-1] for a, b, n in zip(edges[:-1], edges[1:], parts, strict=True)]
    return np.concatenate(inner)


def _law_places(
    check: EquilibriumCheck, natural_curvature: float, law: MaterialLaw | None
) -> tuple[list[float], list[tuple[float, int]]]:
    """Parameters at which the material law is not smooth, and the kinks (s, continuity) of K there."""
    found = [
        (place, continuity)
        for curvature, continuity in (() if law is None else law.kinks)
        for side in (-curvature, curvature)
        for place in check.curve.curvature_equals(natural_curvature + side)
    ]
    return [place.t for place, _ in found], [(place.s, continuity) for place, continuity in found]


def _load_places(
    check: EquilibriumCheck, weight: Weight | None
) -> tuple[list[float], list[tuple[float, int]]]:
    """Parameters at which panels must end, and kinks (s, continuity) of the stiffness that the load makes."""
    if weight is None:
        return [], []
    length = check.length
    kinks: list[tuple[float, int]] = []
    for mass in weight.masses:
        if not (np.isfinite(mass.mass) and 0 <= mass.at <= length):
            raise InputError(
                f"point mass of {mass.mass:.6g} g at {mass.at:.6g} mm does not lie on the curve of "
                f"{length:.6g} mm"
            )
        kinks.append((mass.at, 0))
    for part in (weight.alpha, weight.beta):
        if isinstance(part, Profile):
            if not np.isclose(part.length, length, rtol=1e-6):
                raise InputError(f"a weight profile is {part.length:.6g} mm long, the curve {length:.6g} mm")
            kinks += [(float(s), 1) for s in np.unique(part.knots)]
    kinks = [(s, c) for s, c in kinks if 0 < s < length]
    return [float(t) for t in check.curve.parameter(np.array([s for s, _ in kinks]))], kinks


def _raised(value: float | Profile, step: float) -> float | Profile:
    if isinstance(value, Profile):
        return Profile(value.knots, value.coefficients + step, value.degree)
    return value + step


def _along(value: float | Profile, s: FloatArray) -> FloatArray:
    return value(s) if isinstance(value, Profile) else np.full(s.shape, float(value))


def _solutions(matrix: FloatArray, right: FloatArray) -> tuple[FloatArray, FloatArray | None]:
    """Null space (m, d) of matrix (k, m), and a solution of matrix @ x = right where there is one."""
    count = matrix.shape[1]
    size = np.maximum(np.abs(matrix).max(axis=1), np.abs(right)) if len(matrix) else np.ones(0)
    size = np.where(size > 0, size, 1.0)
    u, sigma, vt = (
        np.linalg.svd(matrix / size[:, None]) if len(matrix) else (np.eye(0), np.zeros(0), np.eye(count))
    )
    rank = int((sigma > RANK * max(1.0, sigma.max(initial=0.0))).sum())
    inner = (u.T @ (right / size))[:rank] / sigma[:rank]
    x = vt[:rank].T @ inner
    residual = np.abs(matrix @ x - right) / size
    return vt[rank:].T, x if residual.max(initial=0.0) <= 10 * RANK else None


def _stretches(s: FloatArray, length: float) -> str:
    """Places, those closer than a twentieth of the length put together."""
    s = np.sort(np.round(s, 6))
    groups = np.split(s, np.flatnonzero(np.diff(s) > length / 20) + 1)
    return ", ".join(
        f"{g[0]:.4g}" if np.ptp(g) < length / 200 else f"{g[0]:.4g} to {g[-1]:.4g}" for g in groups
    )
