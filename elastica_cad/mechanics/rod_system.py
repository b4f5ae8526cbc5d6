"""Equations of a discrete rod (`RodSystem`), and values of its unknowns (`RodState`)."""

from dataclasses import dataclass, replace
from typing import NamedTuple

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import FloatArray
from elastica_cad.geometry.plane_points import dot, midpoints, unit_vectors
from elastica_cad.mechanics.discrete_rod import (
    Compression,
    DiscreteRod,
    bending_moments,
    edge_forces,
    nodal_forces,
    node_weights,
)
from elastica_cad.mechanics.elements import ElementForce, at_ends, lumped
from elastica_cad.mechanics.loads import Supports, turning_nodes
from elastica_cad.mechanics.moment_curvature import MaterialLaw
from elastica_cad.mechanics.mounted_elements import ElementEquations, MountedElements
from elastica_cad.mechanics.rod import Rod

ROUNDING = float(np.finfo(float).eps)


class Step(NamedTuple):
    """Change of the unknowns of a discrete rod.

    The unknowns are the edge angles (n,), rad, and the reactions (p,), as in `RodState`.
    """

    angles: FloatArray
    reactions: FloatArray


class Residual(NamedTuple):
    """Residuals of a discrete rod, which are zero in equilibrium.

    `imbalance` (n,) contains the imbalance of moments of the edges, 1/mm. `miss` (p,) contains the errors of ends
    and of rails, pins and ties: position errors, mm, and forces, 1/mm2 (see `ElementEquations`).
    """

    imbalance: FloatArray
    miss: FloatArray


@dataclass(frozen=True, eq=False)
class RodSystem:
    """Discrete rod with its loads and supports.

    Forces and moments are divided by the least bending stiffness.

    Attributes
    ----------
    stiffness : (n+1,) array
        Relative stiffness K at the nodes.
    edge_length : float
        Length of an edge, mm.
    load : (n+1, 2) array
        Weight of each node, 1/mm2.
    natural_curvature : float or (n+1,) array
        Curvature kappa_0 of the unloaded rod, 1/mm.
    supports : Supports
    start, end : (2,) arrays
        Positions of the ends, mm; coordinates that are free are ignored.
    end_angles : (2,) array
        Angles of the tangent at start and end, rad; angles that are free are ignored.
    force : (2,) array
        Dead force, 1/mm2. Each component acts at the end at which its coordinate is free.
    moments : (2,) array
        Counterclockwise moments at ends with a free angle, 1/mm.
    law : MaterialLaw, optional
        Material law for the moment K m(kappa - kappa_0) instead of K (kappa - kappa_0).
    actions : tuple of ElementForce
        Mounted rails, pins and ties, with initial values of their forces.
    compression : Compression, optional
        Axial elasticity of the edges.
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
    actions: tuple[ElementForce, ...] = ()
    compression: Compression | None = None

    @property
    def edges(self) -> int:
        """Number of edges."""
        return self.stiffness.size - 1

    @property
    def length(self) -> float:
        """Length of the rod, mm."""
        return self.edges * self.edge_length

    @cached_property
    def node_lengths(self) -> FloatArray:
        """Half the sum of the edge lengths at each node (n+1,), mm."""
        return node_weights(self.edge_length, self.edges)

    @cached_property
    def held(self) -> tuple[int, ...]:
        """Coordinates (0: x, 1: y) that both supports hold."""
        return tuple(i for i, both in enumerate(self.supports.transmits_force) if both)

    @cached_property
    def held_angles(self) -> tuple[float | None, float | None]:
        """Held angles at the start and at the end, or None for a free angle."""
        a, b = (
            float(v) if end.angle else None
            for end, v in zip(self.supports.ends, self.end_angles, strict=True)
        )
        return a, b

    @cached_property
    def given_force(self) -> FloatArray:
        """Force lambda of the edges (n, 2) without reactions, 1/mm2."""
        # the last edge carries the weight of the last node and the dead force; the force of the first edge follows
        # from the loads if only one end holds a coordinate, and is an unknown reaction if both hold it
        from_end, from_start = -self.force - self.load[1:].sum(axis=0), self.force + self.load[0]
        first = np.where(self.supports.held[:2], from_end, from_start)
        first[list(self.held)] = 0.0
        return edge_forces(first, self.load)

    @cached_property
    def chord(self) -> FloatArray:
        """Required end position minus start position, mm, for the coordinates that both ends hold."""
        return np.array([self.end[i] - self.start[i] for i in self.held])

    @cached_property
    def elements(self) -> MountedElements:
        """Rails, pins and ties, and their equations."""
        return MountedElements(
            self.actions, self.supports, np.where(self.supports.held[:2], self.start, self.end),
            self.load.sum(axis=0) + self.force, self.edge_length,
        )  # fmt: skip

    def state(self, angles: FloatArray, reactions: FloatArray | None = None) -> "RodState":
        """Return the state with edge angles (n,), rad, and given reactions, as in `RodState`.

        By default the reactions of the supports are 0, and the unknowns of rails, pins and ties have their initial
        values.
        """
        if reactions is None:
            reactions = np.zeros(len(self.held))
        if reactions.size == len(self.held):
            reactions = np.concatenate([reactions, self.elements.first(unit_vectors(angles))])
        return RodState(self, angles, reactions)

    def loaded(self, factor: float) -> "RodSystem":
        """Return the system with weight, dead force and moments multiplied by `factor`."""
        return replace(
            self, load=factor * self.load, force=factor * self.force, moments=factor * self.moments
        )


@dataclass(frozen=True, eq=False)
class RodState:
    """Values of the unknowns of a discrete rod; derived quantities are computed once.

    Attributes
    ----------
    system : RodSystem
    angles : (n,) array
        Edge angles, rad.
    reactions : (p,) array
        First the support reactions: contributions to the force lambda, 1/mm2, along the coordinates that both ends
        hold. Then the unknowns of rails, pins and ties, as in `ElementEquations`.
    """

    system: RodSystem
    angles: FloatArray
    reactions: FloatArray

    def moved(self, step: Step, factor: float = 1.0) -> "RodState":
        """Return the state after `factor` times `step`."""
        return RodState(
            self.system, self.angles + factor * step.angles, self.reactions + factor * step.reactions
        )

    def under(self, system: RodSystem) -> "RodState":
        """Return the state of another system with the same angles and reactions."""
        return self if system is self.system else RodState(system, self.angles, self.reactions)

    @cached_property
    def discrete(self) -> DiscreteRod:
        """Discrete rod of this state, with its tangent stiffness and its edge forces."""
        system, force = self.system, self.system.given_force.copy()
        # the first reactions are those of the supports
        for i, value in zip(system.held, self.reactions, strict=False):
            force[:, i] += value
        K = system.stiffness
        if system.law is not None:
            K = K * self._lawful[1]
        if system.actions:
            force += system.elements.force(self.actions, self.angles.size)
        return DiscreteRod(
            K, self.angles, force, system.edge_length, system.supports, bracing=self.actions or None,
            compression=system.compression,
        )  # fmt: skip

    @property
    def _numbers(self) -> FloatArray:
        # unknowns of rails, pins and ties
        return self.reactions[len(self.system.held) :]

    @cached_property
    def _equations(self) -> ElementEquations:
        return self.system.elements.equations(self.discrete.tangents, self._numbers, self.actions)

    @cached_property
    def actions(self) -> tuple[ElementForce, ...]:
        """Taut rails, pins and ties with their forces and arc lengths."""
        return self.system.elements.solved(self._numbers)

    @cached_property
    def rows(self) -> FloatArray:
        """Derivatives (p, n) of the errors `residual.miss` with respect to the edge angles."""
        rows = np.concatenate([self.discrete.constraint_rows, self._equations.rows])
        if self._pulls is not None:
            rows -= self._pulls * self.discrete.shortening * self.discrete.sideways_pull
        return rows

    @cached_property
    def _pulls(self) -> FloatArray | None:
        """Derivatives (p, n) of the axial forces by the p reactions, or None without axial elasticity."""
        rod, held = self.discrete, list(self.system.held)
        if rod.compression is None:
            return None
        along = dot(rod.tangents, rod.directions)
        return np.concatenate([rod.directions.T[held], self._equations.pulls / along])

    @cached_property
    def corner(self) -> FloatArray:
        """Derivatives (p, p) of the errors `residual.miss` with respect to the reactions."""
        held, size = len(self.system.held), self.reactions.size
        corner = np.zeros((size, size))
        corner[held:, held:] = self._equations.corner
        if self._pulls is not None:
            corner -= (self._pulls * self.discrete.shortening) @ self._pulls.T
        return corner

    @cached_property
    def places(self) -> FloatArray:
        """Flags (p,): True for a position error in `residual.miss`, False for a force."""
        held = np.ones(len(self.system.held), dtype=bool)
        return np.concatenate([held, self._equations.places])

    def missed(self, miss: FloatArray) -> float:
        """Return the largest relative error in `miss` (p,).

        Position errors are relative to the length, and force errors to the size of the moments.
        """
        length = self.system.length
        unit = np.where(self.places, length, max(self.scale, 1e-3 / length) / length)
        return float(np.abs(miss / unit).max(initial=0.0))

    @cached_property
    def moments(self) -> FloatArray:
        """Bending moments of the nodes (n+1,) divided by the least bending stiffness, 1/mm."""
        system, hooke = self.system, self._hooke_moments
        if system.law is None:
            return hooke
        moments, turning = system.stiffness * self._lawful[0], turning_nodes(system.supports)
        moments[turning] = hooke[turning]
        return moments

    @cached_property
    def _hooke_moments(self) -> FloatArray:
        """Bending moments (n+1,) by Hooke's law, 1/mm; at ends that are free to turn, the applied moments."""
        system = self.system
        return bending_moments(
            system.stiffness, self.angles, system.node_lengths, ends=system.held_angles,
            natural_curvature=system.natural_curvature,
            end_moments=(-system.moments[0], system.moments[1]),
        )  # fmt: skip

    @cached_property
    def _lawful(self) -> tuple[FloatArray, FloatArray]:
        """Moment / initial stiffness at the nodes (n+1,), 1/mm, and its derivative by the curvature."""
        law, change = self.system.law, self.change
        return (change, np.ones_like(change)) if law is None else law.with_slope(change)

    @cached_property
    def change(self) -> FloatArray:
        """Curvature minus natural curvature at the nodes (n+1,), 1/mm."""
        return self._hooke_moments / self.system.stiffness

    @cached_property
    def residual(self) -> Residual:
        """Imbalance of moments, and errors of ends, rails, pins and ties."""
        system, rod = self.system, self.discrete
        reach = system.edge_length * rod.tangents.sum(axis=0)
        miss = np.concatenate([reach[list(system.held)] - system.chord, self._equations.residual])
        return Residual(rod.moment_imbalance(self.moments), miss)

    @cached_property
    def energy(self) -> float:
        """Elastic energy and potential energy of the loads, divided by the least bending stiffness, 1/mm."""
        system = self.system
        change = self.change
        stored = change**2 / 2 if system.law is None else system.law.energy(change)
        spring = system.stiffness * stored * system.node_lengths
        work = 0.0
        rod, compression = self.discrete, system.compression
        if compression is not None:
            more = dot(rod.force, rod.directions) - compression.pull
            work -= float(rod.shortening @ (more**2 / 2 + compression.pull * more))
        turning = turning_nodes(system.supports)
        spring[turning] = 0.0
        work += float(system.moments[turning] @ self.angles[turning])
        # per length, the dead loads do the work -<lambda, T>, with their force lambda and the unit tangent T
        work -= system.edge_length * float((system.given_force * self.discrete.tangents).sum())
        work += float(system.elements.load @ system.elements.shift(self._numbers))
        return float(spring.sum()) - work

    @cached_property
    def scale(self) -> float:
        """Moment, 1/mm, by which an imbalance of moments is divided."""
        force = np.abs(self.discrete.force).max(initial=0.0)
        return float(max(np.abs(self.moments).max(), force * self.system.length))

    @cached_property
    def noise(self) -> float:
        """Imbalance of moments, 1/mm, that rounding errors of the angles can cause."""
        turning = 1.0 + float(np.abs(self.angles).max())
        return 8 * ROUNDING * turning * float((self.system.stiffness / self.system.node_lengths).max())

    @property
    def imbalance(self) -> float:
        """Largest imbalance of moments divided by `scale`; at most 1e-12 if it is a rounding error."""
        largest, size = float(np.abs(self.residual.imbalance).max()), self.scale
        if largest <= self.noise:
            return min(largest / size, 1e-12) if size > 0 else 0.0
        return largest / size

    @property
    def gap(self) -> float:
        """Largest relative error of the positions and forces of ends, rails, pins and ties."""
        return self.missed(self.residual.miss)

    @property
    def position(self) -> FloatArray:
        """Positions of the nodes (n+1, 2), mm."""
        elements, position = self.system.elements, self.discrete.position
        from_end = elements.from_end * position[-1]
        return np.asarray(position + elements.anchor - from_end + elements.shift(self._numbers))

    def rod(self, like: Rod) -> Rod:
        """Return the `Rod` of this equilibrium, with the profile, weight and section of `like`."""
        system, n = self.system, self.system.edges
        # forces of rails, pins and ties less than two edges from an end act partly on the end node
        load = system.load + lumped(self.actions, n + 1, system.length)
        force = nodal_forces(self.discrete.force, load)
        # `Rod.force` at an end includes the forces of elements exactly there
        force[[0, -1]] += at_ends(system.length, (*self.actions, *like.point_forces)) * [[1.0], [-1.0]]
        change = self.change.copy()
        turning = turning_nodes(system.supports)
        if system.law is not None and turning:
            # at ends that are free to turn, compute the curvature from the applied moment
            effective = np.zeros_like(change)
            effective[turning] = change[turning]
            change[turning] = system.law.curvature(effective)[turning]
        curvature = change + system.natural_curvature
        bend = system.node_lengths * curvature
        angle = np.empty(n + 1)
        angle[1:-1] = midpoints(self.angles)
        for node, sign in ((0, -1), (-1, 1)):
            held = system.held_angles[node]
            angle[node] = self.angles[node] + sign * bend[node] if held is None else held
        return replace(
            like, s=np.linspace(0.0, system.length, n + 1), position=self.position, angle=angle,
            curvature=curvature, stiffness=system.stiffness, moment=self.moments, force=force,
            supports=system.supports, residual=self.imbalance, natural_curvature=system.natural_curvature,
            law=system.law, shape=None, check=None, moved=0.0, warnings=(),
        )  # fmt: skip
