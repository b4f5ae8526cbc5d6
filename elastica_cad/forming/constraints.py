"""Constraints on a nearest rod: limits and kept properties, with their values and derivatives."""

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from math import hypot

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.forming.limits import Box, HalfPlane
from elastica_cad.forming.rod_map import MappedRod, SectionScale, Sensitivities
from elastica_cad.geometry.plane_points import left_of
from elastica_cad.mechanics.discrete_rod import DiscreteRod

# largest number of rows of a constraint in a program; from 64 on, factorisations start threads
MOST_ROWS = 56


@dataclass(frozen=True, kw_only=True)
class Constraint(ABC):
    """Values that a search keeps at 0, or nonnegative if `one_sided`; a badly violated value is of order 1.

    Attributes
    ----------
    name : str
        Name in messages.
    one_sided : bool
        True if the values must be at least 0 instead of 0.
    price : float
        Largest cost of violating one value by 1.
    near_balance_only : bool
        True if the constraint is only meaningful near balance.
    """

    name: str
    one_sided: bool = False
    price: float = 100.0
    near_balance_only: bool = False

    @abstractmethod
    def values(self, rod: MappedRod) -> FloatArray:
        """All values (k,)."""

    @abstractmethod
    def rows(self, sensitivities: Sensitivities) -> tuple[IntArray, FloatArray]:
        """Indices (j,) and derivatives (j, p) of the values that a step from this rod may violate."""


def thin_rows(indices: IntArray, urgency: FloatArray) -> IntArray:
    """Return at most MOST_ROWS of `indices`: peaks of `urgency` (n,), then the remaining ones at equal steps.

    A step may violate a row that was left out. The next program then includes it as a peak.
    """
    if indices.size <= MOST_ROWS:
        return indices
    high = np.concatenate([[-np.inf], urgency, [-np.inf]])
    peak = (urgency >= high[:-2]) & (urgency >= high[2:])
    kept = np.zeros(indices.size, dtype=bool)
    kept[np.flatnonzero(peak[indices])[: MOST_ROWS // 2]] = True
    others = np.flatnonzero(~kept)
    kept[others[:: -(-others.size // (MOST_ROWS - kept.sum()))]] = True
    return indices[kept]


def _all_rows(rows: FloatArray) -> tuple[IntArray, FloatArray]:
    """Every row, with its index."""
    return np.arange(rows.shape[0]), rows


@dataclass(frozen=True, kw_only=True)
class EndPosition(Constraint):
    """The last node is at `target`."""

    name: str = "end position"
    target: tuple[float, float] = (0.0, 0.0)

    def values(self, rod: MappedRod) -> FloatArray:
        """Gap (2,)."""
        return np.asarray(rod.position[-1] - np.asarray(self.target))

    def rows(self, sensitivities: Sensitivities) -> tuple[IntArray, FloatArray]:
        """Both."""
        return _all_rows(sensitivities.position[-1])


@dataclass(frozen=True, kw_only=True)
class EndAngle(Constraint):
    """The angle of the end is `target`."""

    name: str = "end tangent"
    target: float = 0.0

    def values(self, rod: MappedRod) -> FloatArray:
        """Difference (1,), rad."""
        return rod.all_angles[-1:] - self.target

    def rows(self, sensitivities: Sensitivities) -> tuple[IntArray, FloatArray]:
        """Row of the only value."""
        return _all_rows(sensitivities.angles[-1:])


@dataclass(frozen=True, kw_only=True)
class EndMoment(Constraint):
    """No moment at an end that is free to turn."""

    name: str = "free end angle"
    scale: float = 1.0

    def values(self, rod: MappedRod) -> FloatArray:
        """M_n (1,)."""
        return rod.moments[-1:] / self.scale

    def rows(self, sensitivities: Sensitivities) -> tuple[IntArray, FloatArray]:
        """Row of the only value."""
        return _all_rows(sensitivities.moments[-1:] / self.scale)


@dataclass(frozen=True, kw_only=True)
class EndForce(Constraint):
    """No force along an `axis` (0: x, 1: y) in which the end is free."""

    name: str = "free end position"
    axis: int = 0
    scale: float = 1.0

    def values(self, rod: MappedRod) -> FloatArray:
        """lambda after the last node (1,)."""
        return rod.all_forces[-1:, self.axis] / self.scale

    def rows(self, sensitivities: Sensitivities) -> tuple[IntArray, FloatArray]:
        """Row of the force of the last edge and the load of the last node.

        Both are linear in z except in the length."""
        rod = sensitivities.rod
        n = rod.tangents.shape[0]
        weights = np.zeros((n, 2))
        weights[-1, self.axis] = 1
        row = sensitivities.along_forces(weights)
        row += sensitivities.last_load_row(self.axis)
        return _all_rows(row[None] / self.scale)


@dataclass(frozen=True, kw_only=True)
class Through(Constraint):
    """The rod passes through `target`, near the fraction `place` (0..1) of its length."""

    name: str = "points"
    target: tuple[float, float] = (0.0, 0.0)
    place: float = 0.5

    def values(self, rod: MappedRod) -> FloatArray:
        """Distance across the rod (1,)."""
        share, nodes, normal = self._foot(rod)
        off = share @ rod.position[nodes] - np.asarray(self.target)
        return np.array([normal @ off])

    def rows(self, sensitivities: Sensitivities) -> tuple[IntArray, FloatArray]:
        """Row of the only value."""
        share, nodes, normal = self._foot(sensitivities.rod)
        return _all_rows(np.einsum("i,k,ikp->p", share, normal, sensitivities.position[nodes])[None])

    def _foot(self, rod: MappedRod) -> tuple[FloatArray, slice, FloatArray]:
        """Return the nearest cubic through four nodes: its weights at the foot, the nodes, and the normal."""
        foot: tuple[FloatArray, slice, FloatArray] = rod.remembered(
            self, lambda: self._find_foot(rod.position)
        )
        return foot

    def _find_foot(self, position: FloatArray) -> tuple[FloatArray, slice, FloatArray]:
        n = position.shape[0] - 1
        window = np.arange(n + 1)
        window = window[np.abs(window / n - self.place) < 0.15]
        off = position[window] - np.asarray(self.target)
        nearest = int(window[np.argmin((off**2).sum(axis=1))])
        first = int(np.clip(nearest - 1, 0, n - 3))
        nodes = slice(first, first + 4)
        off = position[nodes] - np.asarray(self.target)
        u = float(nearest - first)
        for _ in range(8):
            share, slope = _cubic_shares(u)
            along = slope @ off
            u -= float(along @ (share @ off) / (along @ along))
            u = min(max(u, -0.5 if first == 0 else 0.0), 3.0)
        share, slope = _cubic_shares(u)
        x, y = slope @ off
        return share, nodes, np.array([-y, x]) / hypot(x, y)


@dataclass(frozen=True, kw_only=True)
class InflectionLine(Constraint):
    """M vanishes on the line through `point` along `direction`: without weight M = a + <b, gamma>."""

    name: str = "inflection line"
    point: tuple[float, float] = (0.0, 0.0)
    direction: tuple[float, float] = (1.0, 0.0)
    scale: float = 1.0

    def values(self, rod: MappedRod) -> FloatArray:
        """Moment at the point, and its change along the line (2,)."""
        (fx, fy), (x, y), (u, v) = rod.all_forces[0], self.point - rod.position[0], self.direction
        return np.array([rod.moments[0] + fy * x - fx * y, fy * u - fx * v]) / self.scale

    def rows(self, sensitivities: Sensitivities) -> tuple[IntArray, FloatArray]:
        """Both."""
        rod = sensitivities.rod
        u = sensitivities.grid.unknowns
        rows = np.zeros((2, sensitivities.angles.shape[1]))
        b = np.array([rod.all_forces[0, 1], -rod.all_forces[0, 0]])
        off = np.asarray(self.point) - rod.position[0]
        rows[0, u.moment] = 1
        rows[0, u.force] = [-off[1], off[0]]
        rows[0, u.position] = -b
        rows[1, u.force] = [-self.direction[1], self.direction[0]]
        return _all_rows(rows / self.scale)


@dataclass(frozen=True, kw_only=True)
class MiddleOfMirror(Constraint):
    """Mirror symmetry: the middle crosses the axis at a right angle and carries no force along it."""

    name: str = "symmetry"
    centre: tuple[float, float] = (0.0, 0.0)
    axis: tuple[float, float] = (0.0, 1.0)
    angle: float = 0.0
    scale: float = 1.0

    def values(self, rod: MappedRod) -> FloatArray:
        """Distance from the axis, angle, force (3,)."""
        nodes, edges = _middle(rod)
        normal = left_of(self.axis)
        off = rod.position[nodes].mean(axis=0) - np.asarray(self.centre)
        turn = rod.angles[edges].mean() - self.angle
        return np.array([normal @ off, turn, rod.force[edges].mean(axis=0) @ self.axis / self.scale])

    def rows(self, sensitivities: Sensitivities) -> tuple[IntArray, FloatArray]:
        """All three."""
        rod = sensitivities.rod
        nodes, edges = _middle(rod)
        normal = left_of(self.axis)
        weights = np.zeros_like(rod.tangents)
        weights[edges] = np.asarray(self.axis) / len(edges) / self.scale
        return _all_rows(
            np.array(
                [
                    normal @ sensitivities.position[nodes].mean(axis=0),
                    sensitivities.angles[1:-1][edges].mean(axis=0),
                    sensitivities.along_forces(weights),
                ]
            )
        )


@dataclass(frozen=True, kw_only=True)
class MiddleOfTurn(Constraint):
    """Symmetry under half a turn: the middle is at the centre and carries no moment."""

    name: str = "symmetry"
    centre: tuple[float, float] = (0.0, 0.0)
    scale: float = 1.0

    def values(self, rod: MappedRod) -> FloatArray:
        """Distances and moment (3,)."""
        nodes, _ = _middle(rod)
        off = rod.position[nodes].mean(axis=0) - np.asarray(self.centre)
        return np.append(off, rod.moments[nodes].mean() / self.scale)

    def rows(self, sensitivities: Sensitivities) -> tuple[IntArray, FloatArray]:
        """All three."""
        rod = sensitivities.rod
        nodes, _ = _middle(rod)
        moment = sensitivities.moments[nodes].mean(axis=0) / self.scale
        return _all_rows(np.vstack([sensitivities.position[nodes].mean(axis=0), moment]))


def _middle(rod: MappedRod) -> tuple[Sequence[int], Sequence[int]]:
    """Return the indices of the one or two nodes, and of the one or two edges, at the middle of the rod."""
    n = rod.tangents.shape[0]
    nodes, edges = {n // 2, (n + 1) // 2}, {(n - 1) // 2, n // 2}
    return sorted(nodes), sorted(edges)


_CUBIC = np.linalg.inv(np.vander(np.arange(4.0), increasing=True))
"""Coefficients of the cubic through values at 0, 1, 2, 3."""


def _cubic_shares(u: float) -> tuple[FloatArray, FloatArray]:
    """Shares (4,) of the nodes 0, 1, 2, 3 in their cubic's value at u, and in its slope."""
    return np.array([1, u, u**2, u**3]) @ _CUBIC, np.array([0, 1, 2 * u, 3 * u**2]) @ _CUBIC


_NEAR = 0.6  # fraction of a limit; nearer values enter the quadratic program, because a step may reach them
_STEP = 1e-5  # relative step of K for derivatives of strain
_ROOM = 0.01  # reserve for a sharp bend between nodes, as a fraction of the largest stiffness
_TANGENT_STEP = 1e-3  # relative step of K and bend for derivatives of dM/dkappa; it smooths kinks


@dataclass(frozen=True, kw_only=True)
class MarginLimit(Constraint):
    """Stability margin, for least stiffness 1, at least `limit`."""

    limit: float
    name: str = "margin"
    one_sided: bool = True
    price: float = 1.0
    near_balance_only: bool = True

    @property
    def scale(self) -> float:
        """Difference from the required margin that counts as a large violation."""
        return max(10.0, abs(self.limit))

    def disturbed(self, rod: MappedRod) -> DiscreteRod:
        """Return the rod with the stiffness dM/dkappa for small disturbances, which is K for Hooke's law."""
        return rod

    def values(self, rod: MappedRod) -> FloatArray:
        """Return the margin above its limit, (mu - limit min K) / scale, as an array (1,)."""
        mu = self.disturbed(rod).margin.value
        return np.array([(mu - self.limit * rod.stiffness.min()) / self.scale])

    def rows(self, sensitivities: Sensitivities) -> tuple[IntArray, FloatArray]:
        """Chain rule from K, angles, forces and length to z."""
        rod, d = sensitivities.rod, self.disturbed(sensitivities.rod).margin_derivatives
        u = sensitivities.grid.unknowns
        row = d.angles @ sensitivities.angles[1:-1] + sensitivities.along_forces(d.force)
        by_stiffness, by_moment = self.chained(rod, d.stiffness)
        if by_moment is not None:
            row += by_moment @ sensitivities.moments
        by_stiffness[int(np.argmin(rod.stiffness))] -= self.limit
        row[u.stiffness] += by_stiffness @ sensitivities.grid.basis
        row[u.length] += d.length
        return _all_rows(row[None] / self.scale)

    def chained(self, rod: MappedRod, by_tangent: FloatArray) -> tuple[FloatArray, FloatArray | None]:
        """Convert derivatives by dM/dkappa (n+1,) to derivatives by K and, if M has an effect, by M (n+1,)."""
        _ = rod
        return by_tangent.copy(), None


@dataclass(frozen=True, kw_only=True)
class FollowedMarginLimit(MarginLimit):
    """Limit of the stability margin for sections that change as the strip bends.

    K is M / (kappa - kappa_0). A strip that stiffens as it bends resists a disturbance more than K, and a pre-bent
    strip that is bent straight resists less.

    Attributes
    ----------
    section : SectionScale
    rest : float or (n+1,) array
        kappa_0 in lengths of the target.
    size : float
        Length of the target, mm.
    """

    section: SectionScale
    rest: float | FloatArray
    size: float

    def disturbed(self, rod: MappedRod) -> DiscreteRod:
        """Return the rod with dM/dkappa instead of K."""

        def felt() -> DiscreteRod:
            K = self.section.tangent(rod.stiffness, _bend(rod, self.size), self.rest / self.size)
            return DiscreteRod(K, rod.angles, rod.force, rod.edge_length, rod.supports, rod.start)

        rod_felt: DiscreteRod = rod.remembered((FollowedMarginLimit, id(self.section)), felt)
        return rod_felt

    def chained(self, rod: MappedRod, by_tangent: FloatArray) -> tuple[FloatArray, FloatArray | None]:
        """Use finite differences: K and bend determine the width, and width and bend determine dM/dkappa."""
        K, bend = rod.stiffness, _bend(rod, self.size)
        step = _TANGENT_STEP * float(np.abs(bend).max() or 1.0)
        by_K, by_step = np.array([_TANGENT_STEP, -_TANGENT_STEP, 0, 0]), np.array([0, 0, step, -step])
        stiffer, softer, more, less = self.section.tangent(
            K * (1 + by_K[:, None]), bend + by_step[:, None], self.rest / self.size
        )
        by_stiffness = by_tangent * (stiffer - softer) / (2 * _TANGENT_STEP * K)
        by_moment = by_tangent * (more - less) / (2 * step * K * self.size)
        return by_stiffness - by_moment * rod.moments / K, by_moment


@dataclass(frozen=True, kw_only=True)
class LargestSection(Constraint):
    """No node of the bent strip exceeds the largest section, at the fixed scale for which a margin was computed."""

    section: SectionScale
    rest: float | FloatArray
    size: float
    name: str = "largest section"
    one_sided: bool = True
    price: float = 1.0

    def values(self, rod: MappedRod) -> FloatArray:
        """Largest possible stiffness over the stiffness of each node, minus 1 and a reserve, (n+1,)."""
        most = self.section.largest(_bend(rod, self.size), self.rest / self.size)
        return np.asarray(most / (self.section.scale * rod.stiffness) - 1 - _ROOM)

    def rows(self, sensitivities: Sensitivities) -> tuple[IntArray, FloatArray]:
        """The nodes whose section is nearly as large as allowed."""
        rod = sensitivities.rod
        values, K, bend = self.values(rod), rod.stiffness, _bend(rod, self.size)
        near = thin_rows(np.flatnonzero(values < _NEAR), -values)
        step = _TANGENT_STEP * float(np.abs(bend).max() or 1.0)
        more, less = (self.section.largest(bend + by, self.rest / self.size) for by in (step, -step))
        by_moment = (more - less) / (2 * step * K * self.size) / (self.section.scale * K)
        by_stiffness = -by_moment * rod.moments / K - (1 + _ROOM + values) / K
        return near, _nodal_rows(sensitivities, near, by_moment, by_stiffness)


def _nodal_rows(
    sensitivities: Sensitivities, near: IntArray, by_moment: FloatArray, by_stiffness: FloatArray
) -> FloatArray:
    """Rows (j, p) of values at nodes, from their derivatives (n+1,) by the M and K of the same node."""
    grid, rows = sensitivities.grid, by_moment[near, None] * sensitivities.moments[near]
    rows[:, grid.unknowns.stiffness] += by_stiffness[near, None] * grid.basis[near]
    return np.asarray(rows)


def _bend(rod: MappedRod, size: float) -> FloatArray:
    """kappa - kappa_0 (n+1,), 1/mm, of a rod in lengths of `size` mm."""
    return np.asarray(rod.moments / rod.stiffness / size)


@dataclass(frozen=True, kw_only=True)
class BendLimit(Constraint):
    """The bend |M / K| of every node is within its limit."""

    one_sided: bool = True
    price: float = 1.0

    @abstractmethod
    def share(self, stiffness: FloatArray) -> FloatArray:
        """Return 1 / limit of the bend (n+1,), mm, at nodes with K (n+1,)."""

    def values(self, rod: MappedRod) -> FloatArray:
        """1 - bend / limit, (n+1,)."""
        return np.asarray(1 - self.share(rod.stiffness) * np.abs(rod.moments / rod.stiffness))

    def rows(self, sensitivities: Sensitivities) -> tuple[IntArray, FloatArray]:
        """The nodes that are bent most."""
        rod = sensitivities.rod
        values = self.values(rod)
        near = thin_rows(np.flatnonzero(values < 1 - _NEAR), -values)
        K, M = rod.stiffness, rod.moments
        share = self.share(K)
        slope = (self.share(K * (1 + _STEP)) - self.share(K * (1 - _STEP))) / (2 * _STEP * K)
        by_stiffness = np.abs(M) * (share / K - slope) / K
        return near, _nodal_rows(sensitivities, near, -np.sign(M) * share / K, by_stiffness)


@dataclass(frozen=True, kw_only=True)
class CurvatureLimit(BendLimit):
    """|M / K| at most `limit`, node by node."""

    limit: float
    name: str = "curvature"

    def share(self, stiffness: FloatArray) -> FloatArray:
        """See `BendLimit`; here for all kinds of sections."""
        return np.full(stiffness.shape, 1 / self.limit)


@dataclass(frozen=True, kw_only=True)
class StrainLimit(BendLimit):
    """The strain of every node is within its limit, for all kinds of sections."""

    section: SectionScale
    strain: float | None
    size: float
    name: str = "strain"

    def share(self, stiffness: FloatArray) -> FloatArray:
        """See `BendLimit`."""
        return self.section.strain(stiffness, self.strain) / self.size


@dataclass(frozen=True, kw_only=True)
class KeepOut(Constraint):
    """All nodes are outside a region; the region is in mm, the rod in units of `size` from `origin`.

    Ends with a kept position are left out, because on the border both constraints would conflict.
    """

    region: HalfPlane | Box
    size: float
    origin: tuple[float, float]
    kept: tuple[bool, bool] = (False, False)
    name: str = "keep-out"
    one_sided: bool = True

    def values(self, rod: MappedRod) -> FloatArray:
        """Clearances (n+1,)."""
        return self._clearance(rod)[0]

    def rows(self, sensitivities: Sensitivities) -> tuple[IntArray, FloatArray]:
        """Nodes that one step may bring near the region."""
        rod = sensitivities.rod
        value, gradient = self._clearance(rod)
        near = thin_rows(np.flatnonzero(value < 0.1), -value)
        d = sensitivities.position[near]
        return near, gradient[near, 0, None] * d[:, 0] + gradient[near, 1, None] * d[:, 1]

    def _clearance(self, rod: MappedRod) -> tuple[FloatArray, FloatArray]:
        value, gradient = self.region.clearance(rod.position * self.size + np.asarray(self.origin))
        value = value / self.size
        value[[0, -1]] = np.where(self.kept, 1.0, value[[0, -1]])
        return value, gradient


@dataclass(frozen=True, kw_only=True)
class LeastStiffness(Constraint):
    """The least stiffness is 1. It is the unit of the lower bounds along the strip."""

    name: str = "stiffness bounds"
    one_sided: bool = True
    price: float = 1.0

    def values(self, rod: MappedRod) -> FloatArray:
        """1 - min K, (1,); the box keeps it from growing."""
        return np.array([1 - rod.stiffness.min()])

    def rows(self, sensitivities: Sensitivities) -> tuple[IntArray, FloatArray]:
        """The softest node."""
        grid, rod = sensitivities.grid, sensitivities.rod
        row = np.zeros((1, sensitivities.angles.shape[1]))
        row[0, grid.unknowns.stiffness] = -grid.basis[int(np.argmin(rod.stiffness))]
        return _all_rows(row)
