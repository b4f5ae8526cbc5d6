"""What a rod may not exceed: curvature, strain, keep-out regions, least stiffness, margin of stability."""

from dataclasses import dataclass

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.forming.limits import Box, HalfPlane
from elastica_cad.forming.nearest.constraints.constraint import Constraint, all_rows, thin_rows
from elastica_cad.forming.nearest.rod_map import MappedRod, Sensitivities
from elastica_cad.forming.section_scale import SectionScale
from elastica_cad.mechanics.rod.discrete_rod import DiscreteRod

_NEAR = 0.6  # of a limit: values within it enter the quadratic program, as a step may use them up
_STEP = 1e-5  # relative step of K for derivatives of strain
_ROOM = 0.01  # of the largest section's stiffness: a sharp bend may ask for as much more between nodes
_TANGENT_STEP = 1e-3  # of K, and of the largest bend, for derivatives of dM/dkappa: it rounds kinks off


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
        """Size of a badly missed margin."""
        return max(10.0, abs(self.limit))

    def disturbed(self, rod: MappedRod) -> DiscreteRod:
        """The rod as small disturbances feel it: with dM/dkappa, which is K by Hooke's law."""
        return rod

    def values(self, rod: MappedRod) -> FloatArray:
        """(mu - limit min K) / scale, (1,)."""
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
        return all_rows(row[None] / self.scale)

    def chained(self, rod: MappedRod, by_tangent: FloatArray) -> tuple[FloatArray, FloatArray | None]:
        """Derivatives by K and by M (n+1,) each, None for none, from those by dM/dkappa (n+1,)."""
        _ = rod
        return by_tangent.copy(), None


@dataclass(frozen=True, kw_only=True)
class FollowedMarginLimit(MarginLimit):
    """The same of sections that follow the bend.

    K is M / (kappa - kappa_0). A strip that stiffens as it is bent resists a disturbance by more, a blank that is
    bent straight by less.

    Attributes
    ----------
    section : SectionScale
    rest : float or (n+1,) array
        kappa_0 in lengths of the target.
    size : float
        That length, mm.
    """

    section: SectionScale
    rest: float | FloatArray
    size: float

    def disturbed(self, rod: MappedRod) -> DiscreteRod:
        """With dM/dkappa in place of K."""

        def felt() -> DiscreteRod:
            K = self.section.tangent(rod.stiffness, _bend(rod, self.size), self.rest / self.size)
            return DiscreteRod(K, rod.angles, rod.force, rod.edge_length, rod.supports, rod.start)

        found: DiscreteRod = rod.remembered((FollowedMarginLimit, id(self.section)), felt)
        return found

    def chained(self, rod: MappedRod, by_tangent: FloatArray) -> tuple[FloatArray, FloatArray | None]:
        """By differences: a width follows from K and bend, the slope from width and bend."""
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
    """Every node, as it is bent, no larger than the largest section; for scales that a margin was counted with."""

    section: SectionScale
    rest: float | FloatArray
    size: float
    name: str = "largest section"
    one_sided: bool = True
    price: float = 1.0

    def values(self, rod: MappedRod) -> FloatArray:
        """The stiffness of the largest section over that of the node, less 1 and some room, (n+1,)."""
        most = self.section.largest(_bend(rod, self.size), self.rest / self.size)
        return np.asarray(most / (self.section.scale * rod.stiffness) - 1 - _ROOM)

    def rows(self, sensitivities: Sensitivities) -> tuple[IntArray, FloatArray]:
        """The nodes that are nearly as large."""
        rod = sensitivities.rod
        values, K, bend = self.values(rod), rod.stiffness, _bend(rod, self.size)
        near = thin_rows(np.flatnonzero(values < _NEAR), -values)
        step = _TANGENT_STEP * float(np.abs(bend).max() or 1.0)
        more, less = (self.section.largest(bend + by, self.rest / self.size) for by in (step, -step))
        by_moment = (more - less) / (2 * step * K * self.size) / (self.section.scale * K)
        by_stiffness = -by_moment * rod.moments / K - (1 + _ROOM + values) / K
        rows = by_moment[near, None] * sensitivities.moments[near]
        basis = sensitivities.grid.basis[near]
        rows[:, sensitivities.grid.unknowns.stiffness] += by_stiffness[near, None] * basis
        return near, rows


def _bend(rod: MappedRod, size: float) -> FloatArray:
    """kappa - kappa_0 (n+1,), 1/mm, of a rod in lengths of `size` mm."""
    return np.asarray(rod.moments / rod.stiffness / size)


@dataclass(frozen=True, kw_only=True)
class CurvatureLimit(Constraint):
    """|M / K| at most `limit`, node by node."""

    limit: float
    name: str = "curvature"
    one_sided: bool = True
    price: float = 1.0

    def values(self, rod: MappedRod) -> FloatArray:
        """1 - |M / K| / limit, (n+1,)."""
        return np.asarray(1 - np.abs(rod.moments / rod.stiffness) / self.limit)

    def rows(self, sensitivities: Sensitivities) -> tuple[IntArray, FloatArray]:
        """The nodes that are bent most."""
        rod = sensitivities.rod
        values = self.values(rod)
        near = thin_rows(np.flatnonzero(values < 1 - _NEAR), -values)
        K, M = rod.stiffness[near, None], rod.moments[near, None]
        rows = -np.sign(M) / K * sensitivities.moments[near] / self.limit
        rows[:, sensitivities.grid.unknowns.stiffness] += (
            np.abs(M) / K**2 * sensitivities.grid.basis[near] / self.limit
        )
        return near, rows


@dataclass(frozen=True, kw_only=True)
class StrainLimit(Constraint):
    """The strain of every node at most its limit, whatever the section is there."""

    section: SectionScale
    strain: float | None
    size: float
    name: str = "strain"
    one_sided: bool = True
    price: float = 1.0

    def values(self, rod: MappedRod) -> FloatArray:
        """1 - strain / limit, (n+1,)."""
        return np.asarray(1 - self._share(rod.stiffness) * np.abs(rod.moments / rod.stiffness))

    def rows(self, sensitivities: Sensitivities) -> tuple[IntArray, FloatArray]:
        """The nodes that are strained most."""
        rod = sensitivities.rod
        values = self.values(rod)
        near = thin_rows(np.flatnonzero(values < 1 - _NEAR), -values)
        K, M = rod.stiffness, rod.moments
        share = self._share(K)
        slope = (self._share(K * (1 + _STEP)) - self._share(K * (1 - _STEP))) / (2 * _STEP * K)
        by_moment, by_stiffness = -np.sign(M) * share / K, np.abs(M) * (share / K - slope) / K
        rows = by_moment[near, None] * sensitivities.moments[near]
        basis = sensitivities.grid.basis[near]
        rows[:, sensitivities.grid.unknowns.stiffness] += by_stiffness[near, None] * basis
        return near, rows

    def _share(self, stiffness: FloatArray) -> FloatArray:
        return self.section.strain(stiffness, self.strain) / self.size


@dataclass(frozen=True, kw_only=True)
class KeepOut(Constraint):
    """Every node outside a region; the region is in millimetres, the rod in `size` from `origin`.

    Ends that are `kept` where they are do not count: on the border they would only fight what keeps them.
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
        """The nodes that may come near in one step."""
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
    """The least stiffness is 1, where lower bounds along the strip are meant in units of it."""

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
        return all_rows(row)
