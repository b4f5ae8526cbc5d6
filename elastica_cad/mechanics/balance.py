"""The discrete rod as a system of equations: what is given, what is sought, and how a `Rod` comes from it."""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import InputError
from elastica_cad.mechanics.discrete import (
    bending_moments,
    constraint_rows,
    edge_forces,
    edge_positions,
    held_angles,
    moment_imbalance,
    node_weights,
    second_variation,
    tangents,
)
from elastica_cad.mechanics.material_laws import MaterialLaw
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.supports import Supports

__all__ = ["Balance", "State", "edge_state"]

ROUNDING = float(np.finfo(float).eps)


@dataclass(frozen=True, eq=False)
class State:
    """Unknowns of a discrete rod: edge angles (n,), rad, and support reactions (p,), 1/mm2.

    The reactions are what both supports add to lambda along the coordinates that both ends hold.
    """

    angles: FloatArray
    reactions: FloatArray

    @cached_property
    def tangents(self) -> FloatArray:
        """Unit tangents of the edges (n, 2)."""
        return tangents(self.angles)

    def moved(self, step: "State", factor: float = 1.0) -> "State":
        """The state a `factor` of `step` further."""
        return State(self.angles + factor * step.angles, self.reactions + factor * step.reactions)


@dataclass(frozen=True, eq=False)
class Balance:
    """A discrete rod with all that is given; `residual` of a `State` is zero in equilibrium.

    Attributes
    ----------
    stiffness : (n+1,) array
        K at the nodes.
    edge_length : float
        mm.
    load : (n+1, 2) array
        Weight of each node over the least bending stiffness, 1/mm2.
    natural_curvature : float or (n+1,) array
        1/mm.
    supports : Supports
    start, end : (2,) arrays
        Positions of the ends, mm; a coordinate that the end leaves free is not used.
    end_angles : (2,) array
        alpha_0 and alpha_l, rad; one that is free is not used.
    force : (2,) array
        Dead force, along each coordinate at the end that leaves it free, 1/mm2.
    moments : (2,) array
        Counterclockwise moments applied at the start and at the end where the angle is free, 1/mm.
    law : MaterialLaw, optional
        M = K m(kappa - kappa_0) instead of K (kappa - kappa_0).
    """

    stiffness: FloatArray
    edge_length: float
    load: FloatArray
    natural_curvature: float | FloatArray
    supports: Supports
    start: FloatArray
    end: FloatArray
    end_angles: FloatArray
    force: FloatArray
    moments: FloatArray
    law: MaterialLaw | None = None

    @property
    def edges(self) -> int:
        """Number of edges n."""
        return self.stiffness.size - 1

    @property
    def length(self) -> float:
        """Length of the rod, mm."""
        return self.edges * self.edge_length

    @cached_property
    def weights(self) -> FloatArray:
        """Voronoi lengths of the nodes, mm."""
        return node_weights(self.edge_length, self.edges)

    @cached_property
    def held(self) -> tuple[int, ...]:
        """The coordinates (0: x, 1: y) held at both ends."""
        return tuple(i for i, both in enumerate(self.supports.transmits_force) if both)

    @cached_property
    def ends(self) -> tuple[float | None, float | None]:
        """Angles that the supports hold at the start and at the end; None where free."""
        a, b = held_angles(self.supports)
        return (float(self.end_angles[0]) if a else None, float(self.end_angles[1]) if b else None)

    @cached_property
    def given_force(self) -> FloatArray:
        """lambda of the edges (n, 2) without the reactions, 1/mm2."""
        first = np.zeros(2)
        start = self.supports.ends[0]
        for i, held_at_start in enumerate((start.x, start.y)):
            if i in self.held:
                continue
            if held_at_start:  # lambda of the last edge carries the last node's weight and the dead force
                first[i] = -self.force[i] - self.load[1:, i].sum()
            else:
                first[i] = self.force[i] + self.load[0, i]
        return edge_forces(first, self.load)

    @cached_property
    def chord(self) -> FloatArray:
        """Distance from start to end along the coordinates held at both ends (p,), mm."""
        return np.array([self.end[i] - self.start[i] for i in self.held])

    def edge_force(self, state: State) -> FloatArray:
        """lambda of the edges (n, 2), 1/mm2."""
        force = self.given_force.copy()
        for i, value in zip(self.held, state.reactions, strict=True):
            force[:, i] += value
        return force

    def node_moments(self, state: State) -> FloatArray:
        """M of the nodes (n+1,), 1/mm."""
        hooke = self._hooke_moments(state)
        if self.law is None:
            return hooke
        moments = self.stiffness * self.law.effective_curvature(hooke / self.stiffness)
        for node, held in zip((0, -1), self.ends, strict=True):
            if held is None:
                moments[node] = hooke[node]
        return moments

    def elastic_curvature(self, state: State) -> FloatArray:
        """kappa - kappa_0 of the nodes (n+1,), 1/mm; at an end free to turn what its moment asks for."""
        change = self._hooke_moments(state) / self.stiffness
        if self.law is not None:
            for node, held in zip((0, -1), self.ends, strict=True):
                if held is None:
                    change[node] = self.law.curvature(change[node])
        return change

    def _hooke_moments(self, state: State) -> FloatArray:
        """K (kappa - kappa_0) of the nodes (n+1,), 1/mm, and the given moments at ends free to turn."""
        return bending_moments(
            self.stiffness, state.angles, self.weights, ends=self.ends,
            natural_curvature=self.natural_curvature, end_moments=(-self.moments[0], self.moments[1]),
        )  # fmt: skip

    def residual(self, state: State) -> tuple[FloatArray, FloatArray]:
        """Moment imbalance of the edges (n,), 1/mm, and gap of the ends (p,), mm."""
        moments = self.node_moments(state)
        imbalance = moment_imbalance(
            moments, state.angles, self.edge_force(state), self.edge_length, T=state.tangents
        )
        reach = self.edge_length * state.tangents.sum(axis=0)
        return imbalance, np.array([reach[i] for i in self.held]) - self.chord

    def tangent_stiffness(self, state: State) -> FloatArray:
        """dM/dkappa of the nodes (n+1,): K unless a law says otherwise."""
        if self.law is None:
            return self.stiffness
        return self.stiffness * self.law.slope(self._hooke_moments(state) / self.stiffness)

    def second_variation(self, state: State) -> tuple[FloatArray, FloatArray]:
        """Tridiagonal Hessian of the energy: diagonal and off-diagonal, 1/mm."""
        return second_variation(
            self.tangent_stiffness(state),
            state.angles,
            self.edge_force(state),
            self.edge_length,
            self.supports,
            T=state.tangents,
        )

    def constraint_rows(self, state: State) -> FloatArray:
        """Derivative (p, n) of the gap in the angles, mm."""
        return constraint_rows(state.angles, self.edge_length, self.supports, T=state.tangents)

    def loaded(self, factor: float) -> "Balance":
        """The same rod under `factor` times its weight, dead force and moments."""
        return replace(
            self, load=factor * self.load, force=factor * self.force, moments=factor * self.moments
        )

    def energy(self, state: State) -> float:
        """Elastic and potential energy over the least bending stiffness, 1/mm; the reactions are left out."""
        change = self._hooke_moments(state) / self.stiffness
        stored = change**2 / 2 if self.law is None else self.law.energy(change)
        spring = self.stiffness * stored * self.weights
        work = 0.0
        for node, held, moment in zip((0, -1), self.ends, self.moments, strict=True):
            if held is None:
                spring[node] = 0.0
                work += float(moment * state.angles[node])
        # <lambda, gamma'> is minus the pull of the dead loads along each edge
        work -= self.edge_length * float(np.sum(self.given_force * state.tangents))
        return float(spring.sum()) - work

    def scale(self, state: State) -> float:
        """Size of the moments against which an imbalance is judged, 1/mm."""
        force = np.abs(self.edge_force(state)).max(initial=0.0)
        return float(max(np.abs(self.node_moments(state)).max(), force * self.length))

    def noise(self, state: State) -> float:
        """Imbalance that rounding of the angles makes, 1/mm."""
        turning = 1.0 + float(np.abs(state.angles).max())
        return 8 * ROUNDING * turning * float((self.stiffness / self.weights).max())

    def imbalance(self, state: State) -> float:
        """Largest moment imbalance over the moments' size; rounding of the angles is not counted."""
        largest = float(np.abs(self.residual(state)[0]).max())
        size = self.scale(state)
        if largest <= self.noise(state):
            return min(largest / size, 1e-12) if size > 0 else 0.0
        return largest / size

    def gap(self, state: State) -> float:
        """Distance by which the ends miss their places, over the length."""
        return float(np.abs(self.residual(state)[1]).max(initial=0.0)) / self.length

    def rod(self, state: State, like: Rod) -> Rod:
        """The `Rod` record of an equilibrium; profile, weight and names as in `like`."""
        moments = self.node_moments(state)
        edge = self.edge_force(state)
        force = np.empty((self.edges + 1, 2))
        force[1:-1] = (edge[:-1] + edge[1:]) / 2
        force[0] = edge[0] - self.load[0]
        force[-1] = edge[-1] + self.load[-1]
        angle = np.empty(self.edges + 1)
        angle[1:-1] = (state.angles[:-1] + state.angles[1:]) / 2
        curvature = self.elastic_curvature(state) + self.natural_curvature
        bend = self.weights * curvature
        angle[0] = state.angles[0] - bend[0]
        angle[-1] = state.angles[-1] + bend[-1]
        for node, held in zip((0, -1), self.ends, strict=True):
            if held is not None:
                angle[node] = held
        position = edge_positions(np.zeros(2), state.angles, self.edge_length)
        start = self.supports.ends[0]
        for i, held_at_start in enumerate((start.x, start.y)):
            position[:, i] += self.start[i] if held_at_start else self.end[i] - position[-1, i]
        return replace(
            like,
            s=np.linspace(0.0, self.length, self.edges + 1), position=position, angle=angle,
            curvature=curvature, stiffness=self.stiffness,
            moment=moments, force=force, supports=self.supports, residual=self.imbalance(state),
            natural_curvature=self.natural_curvature, shape=None, check=None, moved=0.0,
            warnings=(),
        )  # fmt: skip


def edge_state(rod: Rod) -> tuple[FloatArray, FloatArray]:
    """Edge angles (n-1,) and edge forces (n-1, 2) of a rod of n nodes."""
    steps = np.diff(rod.position, axis=0)
    if not np.all(np.any(steps != 0, axis=1)):
        at = float(rod.s[int(np.argmin(np.any(steps != 0, axis=1)))])
        raise InputError(f"two neighbouring nodes of the rod coincide at {at:.6g} mm")
    angles = np.arctan2(steps[:, 1], steps[:, 0])
    middle = (rod.angle[:-1] + rod.angle[1:]) / 2
    angles += 2 * np.pi * np.round((middle - angles) / (2 * np.pi))
    load = rod.nodal_load
    force = edge_forces(np.zeros(2), load)
    nodal = np.empty_like(rod.force)
    nodal[1:-1] = (force[:-1] + force[1:]) / 2
    nodal[0] = force[0] - load[0]
    nodal[-1] = force[-1] + load[-1]
    return angles, force + (rod.force - nodal).mean(axis=0)
