"""A drawn curve that a strip can take, with its stiffness: the state of the routes that move control points.

Everything here is without weight and clamped at both ends, where Theorem 1 holds.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import TypeAlias

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.errors import InputError
from elastica_cad.geometry import CollinearInflections, EndPositions, EndTangents, FixedLength, PlaneCurve
from elastica_cad.geometry.constraints import Constraint
from elastica_cad.mechanics.discrete import Margin, constrained_margin
from elastica_cad.mechanics.equilibrium import EquilibriumCheck, NotRealizable, check_equilibrium
from elastica_cad.mechanics.rod import DEFAULT_SAMPLES
from elastica_cad.mechanics.stiffness_family import dense_places, extreme_places
from elastica_cad.mechanics.supports import Supports
from elastica_cad.mechanics.weighing import BalancedStiffness, balance_without_weight

__all__ = ["BothEnds", "EquilibriumCurve", "NodalRod", "collinear", "kept"]

_PARTS = 96  # of a panel: a step moves the extremes of K, and bounds hold at samples only

BothEnds: TypeAlias = "bool | tuple[bool, bool]"


@dataclass(frozen=True, eq=False)
class NodalRod:
    """The discrete rod of a curve (paper, section 7.1): what its stability depends on.

    Attributes
    ----------
    t : (n,) array
        Parameters of the nodes, uniform in arc length.
    position : (n, 2) array
        mm.
    stiffness : (n,) array
        K, least value of the curve 1.
    angles : (n - 1,) array
        Of the edges, rad.
    force : (n - 1, 2) array
        lambda of the edges, 1/mm2.
    edge_length : float
        mm.
    """

    t: FloatArray
    position: FloatArray
    stiffness: FloatArray
    angles: FloatArray
    force: FloatArray
    edge_length: float


@dataclass(frozen=True, eq=False)
class EquilibriumCurve:
    """A realizable curve with the stiffness of least ratio, scaled to a least value of 1.

    Attributes
    ----------
    check : EquilibriumCheck
    balance : BalancedStiffness
        Scaled by `scale`.
    places : (panel, x)
        Dense samples of the curve in order, with the extremes of K between them.
    scale : float
        What `balance` is divided by to make the least stiffness 1.
    """

    check: EquilibriumCheck
    balance: BalancedStiffness
    places: tuple[IntArray, FloatArray]
    scale: float

    @classmethod
    def of(
        cls, curve: PlaneCurve, supports: Supports | None = None, *, tolerance: float = 1e-9
    ) -> "EquilibriumCurve":
        """The state of a curve: Eq. 4 of the paper, on the continuous curve.

        Parameters
        ----------
        supports : Supports
            Clamped at both ends unless given.
        tolerance : float
            As in `check_equilibrium`.

        Raises
        ------
        NotRealizable, InputError
            As `check_equilibrium`; a straight curve too, which leaves nothing to optimise.
        """
        supports = supports or Supports()
        check = check_equilibrium(curve, supports, tolerance=tolerance)
        if not check.realizable:
            raise NotRealizable(check)
        if check.any_stiffness:
            raise InputError(
                "the curve is straight, so a strip of one width takes it: there is nothing to change"
            )
        balance = balance_without_weight(check, supports, 0.0)
        dense = dense_places(balance.panels, _PARTS)
        extremes = extreme_places(balance.stiffness)
        panel, x = (np.concatenate(pair) for pair in zip(dense, extremes, strict=True))
        order = np.lexsort((x, panel))
        places = (panel[order], x[order])
        least = float(balance.stiffness.at(*places).min())
        if least <= 0:
            raise NotRealizable(check)
        return cls(check, balance, places, least)

    @property
    def curve(self) -> PlaneCurve:
        """The curve, its inflections on one line to rounding error."""
        return self.check.curve

    @cached_property
    def line(self) -> tuple[float, FloatArray]:
        """a (1/mm) and b (2,) (1/mm2) of K kappa = a + <b, gamma>, Eq. 3."""
        first, left = np.array([0]), np.array([-1.0])
        b = self.balance.force.at(first, left)[0] / self.scale
        moment = float(self.balance.moment.at(first, left)[0]) / self.scale
        return moment - float(b @ self.balance.panels.edge_position[0]), np.asarray(b)

    @cached_property
    def stiffness(self) -> FloatArray:
        """K at `places`, least value 1."""
        return self.balance.stiffness.at(*self.places) / self.scale

    @property
    def ratio(self) -> float:
        """R = max K / min K of the continuous curve."""
        return float(self.stiffness.max())

    @cached_property
    def rod(self) -> NodalRod:
        """The discrete rod."""
        nodes = self.curve.sample(DEFAULT_SAMPLES)
        steps = np.diff(nodes.position, axis=0)
        angles = np.unwrap(np.arctan2(steps[:, 1], steps[:, 0]))
        panels = self.balance.panels
        K = self.balance.stiffness.at(*panels.locate(nodes.t)) / self.scale
        _, b = self.line
        force = np.tile([-b[1], b[0]], (angles.size, 1))  # lambda = R b
        return NodalRod(nodes.t, nodes.position, K, angles, force, self.curve.length / angles.size)

    @cached_property
    def stability(self) -> Margin:
        """The lowest eigenvalue of the second variation, and its mode."""
        rod = self.rod
        return constrained_margin(rod.stiffness, rod.angles, rod.force, rod.edge_length)

    @property
    def margin(self) -> float:
        """Stability margin, as `mechanics.stability` has it of `optimal_rod`: least nodal K is 1."""
        return self.stability.value / float(self.rod.stiffness.min())


def kept(curve: PlaneCurve, *, ends: BothEnds, tangents: BothEnds, length: bool) -> tuple[Constraint, ...]:
    """The constraints that keep what a curve has; `ends` and `tangents` at both ends, or (start, end)."""
    found: list[Constraint] = []
    at_start, at_end = _both(ends)
    if at_start or at_end:
        there = EndPositions.of(curve)
        found.append(EndPositions(there.start if at_start else None, there.end if at_end else None))
    at_start, at_end = _both(tangents)
    if at_start or at_end:
        along = EndTangents.of(curve)
        found.append(
            EndTangents(along.start_normal if at_start else None, along.end_normal if at_end else None)
        )
    if length:
        found.append(FixedLength(curve.length))
    return tuple(found)


def _both(ends: BothEnds) -> tuple[bool, bool]:
    return ends if isinstance(ends, tuple) else (ends, ends)


def collinear(curve: PlaneCurve) -> Sequence[Constraint]:
    """The constraint that the inflections of a curve lie on one line; none where two or fewer always do."""
    t = np.array([z.t for z in curve.curvature_zeros if z.kind == "crossing"])
    return [CollinearInflections(t)] if t.size > 2 else []
