"""Moment rows under the conditions that inflections and supports make, and the best stiffness they leave."""

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from functools import cached_property
from typing import NoReturn

import numpy as np

from elastica_cad._compiled_scipy import svd
from elastica_cad._types import FloatArray, IntArray
from elastica_cad.errors import NotConvergedError
from elastica_cad.geometry.polynomials.panel_functions import PanelFunction
from elastica_cad.mechanics.loads.supports import Supports
from elastica_cad.mechanics.loads.weight import Weight
from elastica_cad.mechanics.stiffness.moment_rows import MomentRows
from elastica_cad.mechanics.stiffness.quadrature_panels import Panels
from elastica_cad.mechanics.stiffness.stiffness_family import (
    StiffnessFamily,
    find_violations,
    least_ratio,
    smoothest,
)
from elastica_cad.mechanics.theorem1.verdict import EquilibriumCheck, NotRealizable

SMOOTHING_SHARE = 0.01
"""How much ratio section 5.3 gives for smoothness."""

NO_GAIN_SHARE = 1e-6
"""Relative gain in ratio that counts as none."""

WIDEST_RATIO = 1e10
"""Ratio of stiffness that no strip can have, and that leaves double precision no digits."""

RANK_SHARE = 1e-7
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


@dataclass(frozen=True, eq=False)
class StateFamily:
    """A family of stiffnesses: state (M, b_x, b_y, tau) at the curve's end = fixed + basis @ free numbers."""

    family: StiffnessFamily
    basis: FloatArray
    fixed: FloatArray


@dataclass(frozen=True, eq=False)
class ConditionedRows:
    """Moment rows under the conditions of inflections and supports."""

    check: EquilibriumCheck
    supports: Supports
    panels: Panels
    rows: MomentRows
    nodes: FloatArray | None

    @cached_property
    def conditions(self) -> FloatArray:
        """Rows (k, m) @ state = 0: no moment where no curvature, no force that no support gives."""
        t = np.array([z.t for z in self.check.zeros])
        found = [self.rows.edge_moment[np.abs(self.panels.edges - t[:, None]).argmin(axis=1)]]
        for end, force in zip(self.supports.ends, (self.rows.start_force, self.rows.end_force), strict=True):
            # lambda = R b: the force along x is -b_y, that along y is b_x
            found += [] if end.x else [force[1:2]]
            found += [] if end.y else [force[0:1]]
        return np.concatenate(found)

    @cached_property
    def scale(self) -> FloatArray:
        """Sizes (m,) of the state's numbers."""
        size = np.full(self.rows.edge_moment.shape[1], 1 / self.check.length)
        size[0] = 1.0
        if size.size == 4:
            size[3] = 1 / np.abs(self.rows.edge_moment[:, 3]).max()
        return size

    def homogeneous(self, count: int) -> StateFamily:
        """All stiffnesses of the first `count` numbers of the state (3: without dead weight)."""
        basis = np.zeros((self.scale.size, count))
        np.fill_diagonal(basis, self.scale[:count])
        basis = basis @ _null_space(self.conditions @ basis)
        side = basis[3:4] if count == 4 and self.scale.size == 4 else None
        return StateFamily(
            StiffnessFamily(self.panels, PanelFunction.through(self.rows.stiffness @ basis), side_rows=side),
            basis,
            np.zeros(self.scale.size),
        )

    def at_compliance(self, tau: float) -> StateFamily:
        """All stiffnesses with least bending stiffness 1 / tau."""
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
        """Free numbers of least ratio, and that ratio."""
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
        """Panels and places x of the nodes at which alone the ratio is judged, where that is asked for."""
        return None if self.nodes is None else self.panels.locate(self.nodes)

    def steadied(self, state: FloatArray) -> FloatArray:
        """Of many optima one that no turn of the drawing changes.

        On arcs a constant moment; the smoothest stiffness where a step of the curvature alone decides the ratio.
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
        with suppress(NotConvergedError):  # any optimum will do
            return numbers.basis @ smoothest(numbers.family, float(steps.max()) * (1 + NO_GAIN_SHARE))
        return state

    def least(self, numbers: StateFamily, *, smooth: bool = True) -> FloatArray:
        """The state (m,) at the curve's end of the least ratio, smoothed where inflections leave a choice."""
        found = self.ratio(numbers)
        if found is None:
            self.refuse(numbers.family)
        y, ratio = found
        choices = numbers.family.freedom - (numbers.family.offset is None)
        if smooth and self.check.zeros and choices > 0:
            y = smoothest(numbers.family, ratio * (1 + SMOOTHING_SHARE), self.places)
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
            wrong = find_violations(family)
            where = f" near {_stretches(wrong, self.check.length)} mm" if wrong.size else ""
            reason = (
                f"With this weight and these supports the moment would have to act against the "
                f"curvature{where}, so no positive stiffness balances the curve: use a lighter or stiffer "
                "sheet, support the strip there, or change the curve."
            )
        raise NotRealizable(replace(self.check, realizable=False, reasons=(*self.check.reasons, reason)))


def _null_space(matrix: FloatArray) -> FloatArray:
    """Null space (m, d) of matrix (k, m)."""
    if not len(matrix):
        return np.eye(matrix.shape[1])
    size = np.abs(matrix).max(axis=1)
    _, sigma, vt = svd(matrix / np.where(size > 0, size, 1.0)[:, None])
    return np.asarray(vt[_rank(sigma) :].T)


def _rank(sigma: FloatArray) -> int:
    """How many singular values (falling) belong to conditions that do not depend on others."""
    return int(np.count_nonzero(sigma > RANK_SHARE * max(1.0, sigma[0])))


def _solutions(matrix: FloatArray, right: FloatArray) -> tuple[FloatArray, FloatArray | None]:
    """Null space (m, d) of matrix (k, m), and a solution of matrix @ x = right where there is one."""
    count = matrix.shape[1]
    size = np.maximum(np.abs(matrix).max(axis=1), np.abs(right)) if len(matrix) else np.ones(0)
    size = np.where(size > 0, size, 1.0)
    u, sigma, vt = (
        np.linalg.svd(matrix / size[:, None]) if len(matrix) else (np.eye(0), np.zeros(0), np.eye(count))
    )
    rank = _rank(sigma) if len(matrix) else 0
    inner = (u.T @ (right / size))[:rank] / sigma[:rank]
    x = vt[:rank].T @ inner
    residual = np.abs(matrix @ x - right) / size
    return vt[rank:].T, x if residual.max(initial=0.0) <= 10 * RANK_SHARE else None


def _stretches(s: FloatArray, length: float) -> str:
    """Places, those closer than a twentieth of the length put together."""
    s = np.sort(np.round(s, 6)) + 0.0  # no -0
    groups = np.split(s, np.flatnonzero(np.diff(s) > length / 20) + 1)
    return ", ".join(
        f"{g[0]:.4g}" if np.ptp(g) < length / 200 else f"{g[0]:.4g} to {g[-1]:.4g}" for g in groups
    )
