"""Realizable curve with its stiffness, for methods that move the control points of a curve.

The strip has no weight, as Theorem 1 of the paper requires.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import FloatArray, IntArray
from elastica_cad._values import require_flag
from elastica_cad.errors import InputError
from elastica_cad.geometry.control_point_constraints import (
    CollinearInflections,
    Constraint,
    EndPositions,
    EndTangents,
    FixedLength,
)
from elastica_cad.geometry.plane_curve import CurveSamples, PlaneCurve
from elastica_cad.geometry.plane_points import angle_of, left_of
from elastica_cad.mechanics.discrete_rod import DiscreteRod
from elastica_cad.mechanics.equilibrium_check import examine
from elastica_cad.mechanics.loads import Supports
from elastica_cad.mechanics.moment_conditions import BalancedStiffness, RodRequest
from elastica_cad.mechanics.optimal_balance import balance_without_weight
from elastica_cad.mechanics.rod import DEFAULT_SAMPLES
from elastica_cad.mechanics.theorem1 import EquilibriumCheck, NotRealizable

# number of stations in each panel (an interval of the curve) at which the stiffness is computed to find its
# minimum
_PARTS = 96

BothEnds: TypeAlias = "bool | tuple[bool, bool]"


@dataclass(frozen=True, eq=False)
class EquilibriumCurve:
    """Realizable curve with the stiffness of least ratio (largest / least), scaled to a least value of 1.

    Attributes
    ----------
    balance : BalancedStiffness
        Moments, forces and stiffness before the division by `scale`.
    places : pair of arrays
        Panel indices, and positions -1..1 in the panels, of closely spaced stations and the stiffness extremes.
    scale : float
        Least stiffness of `balance`.
    """

    check: EquilibriumCheck
    balance: BalancedStiffness
    places: tuple[IntArray, FloatArray]
    scale: float

    @classmethod
    def of(
        cls, curve: PlaneCurve, supports: Supports | None = None, *, tolerance: float = 1e-9
    ) -> "EquilibriumCurve":
        """Return the equilibrium state of a continuous curve (Eq. 4 of the paper).

        Parameters
        ----------
        supports : Supports
            By default both ends are clamped.
        tolerance : float
            Largest distance of the inflections from a line, as in `check_equilibrium`.

        Raises
        ------
        NotRealizable, InputError
            See `check_equilibrium`. Closed curves and straight curves are refused too.
        """
        supports = supports or Supports()
        if curve.is_closed:
            raise InputError(
                "the curve is closed, and moving its control points would open it: leave a gap between its ends, "
                "or cut it in pieces"
            )
        check = examine(curve, supports, tolerance=tolerance)
        if not check.realizable:
            raise NotRealizable(check)
        if check.any_stiffness:
            raise InputError(
                "the curve is straight, so any strip of one width already has this shape: draw a bent curve"
            )
        balance = balance_without_weight(RodRequest(curve, supports=supports, known_check=check))
        dense = balance.panels.dense_places(_PARTS)
        panel, x = (
            np.concatenate(pair) for pair in zip(dense, balance.stiffness.extreme_places, strict=True)
        )
        order = np.lexsort((x, panel))
        places = (panel[order], x[order])
        least = float(balance.stiffness.at(*places).min())
        if least <= 0:
            raise NotRealizable(check)
        return cls(check, balance, places, least)

    @property
    def curve(self) -> PlaneCurve:
        """The curve, with its inflections moved onto one line."""
        return self.check.curve

    @cached_property
    def line(self) -> tuple[float, FloatArray]:
        """Coefficients a, 1/mm, and b (2,), 1/mm2: moment / least stiffness = a + <b, position> (paper, Eq. 3)."""
        first, left = np.array([0]), np.array([-1.0])
        b = self.balance.force.at(first, left)[0] / self.scale
        moment = float(self.balance.moment.at(first, left)[0]) / self.scale
        return moment - float(b @ self.balance.panels.edge_position[0]), np.asarray(b)

    @cached_property
    def stiffness(self) -> FloatArray:
        """Stiffness at the stations `places`, scaled to a minimum of 1."""
        return self.balance.stiffness.at(*self.places) / self.scale

    @property
    def ratio(self) -> float:
        """Ratio of largest to least stiffness of the continuous curve."""
        return float(self.stiffness.max())

    @cached_property
    def nodes(self) -> CurveSamples:
        """Nodes of the discrete rod: evenly spaced points of the curve."""
        return self.curve.sample(DEFAULT_SAMPLES)

    @cached_property
    def rod(self) -> DiscreteRod:
        """Discrete rod of section 7.1 of the paper."""
        nodes = self.nodes
        angles = np.unwrap(angle_of(np.diff(nodes.position, axis=0)))
        K = self.balance.stiffness.at(*self.balance.panels.locate(nodes.t)) / self.scale
        _, b = self.line
        # force lambda, which is perpendicular to b (paper, Eq. 4)
        force = np.tile(left_of(b), (angles.size, 1))
        return DiscreteRod(K, angles, force, self.curve.length / angles.size, start=nodes.position[0])

    @property
    def margin(self) -> float:
        """Stability margin (see `mechanics.stability`), divided by the least stiffness at the nodes."""
        return self.rod.margin.value / float(self.rod.stiffness.min())


def kept(curve: PlaneCurve, *, ends: BothEnds, tangents: BothEnds, length: bool) -> tuple[Constraint, ...]:
    """Return the constraints that keep the ends, the end tangents or the length of a curve.

    `ends` and `tangents` are True, False or a pair (start, end).
    """
    constraints: list[Constraint] = []
    if any(held := _both(ends)):
        constraints.append(EndPositions.of(curve, held))
    if any(held := _both(tangents)):
        constraints.append(EndTangents.of(curve, held))
    if require_flag(length, "length"):
        constraints.append(FixedLength(curve.length))
    return tuple(constraints)


def _both(ends: BothEnds) -> tuple[bool, bool]:
    both = ends if isinstance(ends, tuple) else (ends, ends)
    if len(both) != 2 or not all(isinstance(end, bool) for end in both):
        raise InputError(f"`ends` or `tangents` is {ends!r}: give True, False or a pair of these")
    return both


def collinear(curve: PlaneCurve) -> Sequence[Constraint]:
    """Return the constraint that all inflections are on one line; an empty list for two or fewer inflections."""
    t = np.array([z.t for z in curve.curvature_zeros if z.kind == "crossing"])
    return [CollinearInflections(t)] if t.size > 2 else []
