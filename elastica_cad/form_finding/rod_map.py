"""Map from the unknowns (stiffness, start, length) to the rod, with derivatives.

The unit of length is the length of the target curve.
"""

from collections.abc import Callable, Hashable
from dataclasses import dataclass, field, replace
from typing import Any, NamedTuple, Self, TypeAlias, TypeVar, cast

import numpy as np

from elastica_cad import _native
from elastica_cad._cached_property import cached_property
from elastica_cad._compiled_scipy import lapack
from elastica_cad._types import FloatArray
from elastica_cad.errors import BareLength, InputError, Length
from elastica_cad.form_finding.limits import Limits
from elastica_cad.geometry.plane_points import cross, left_of
from elastica_cad.geometry.profile import Profile
from elastica_cad.geometry.splines import bezier_spans
from elastica_cad.mechanics.cross_sections import Section, scale_within
from elastica_cad.mechanics.discrete_rod import DiscreteRod, edge_forces, node_weights, shoot
from elastica_cad.mechanics.loads import Supports, Weight
from elastica_cad.mechanics.optimal_balance import tangent_weight
from elastica_cad.mechanics.rod import CurlingLaw, Rod


@dataclass(frozen=True)
class StiffnessBasis:
    """Basis of `count` cubic B-splines with uniform clamped knots over 0..1.

    Attributes
    ----------
    mirrored : bool
        True if each function and its mirror image have the same coefficient.
    """

    count: int
    mirrored: bool = False

    @property
    def knots(self) -> FloatArray:
        """Clamped knots of the B-splines."""
        return np.concatenate([np.zeros(3), np.linspace(0, 1, self.count - 2), np.ones(3)])

    def at(self, s: FloatArray) -> FloatArray:
        """Return the values (n, m) of the m basis functions at s (n,) in 0..1.

        If `mirrored`, the basis functions are sums of mirrored pairs, and m is half of `count`, rounded up.
        """
        basis = bezier_spans(self.knots, 3).basis(s.clip(0, 1))
        if not self.mirrored:
            return basis
        half = (self.count + 1) // 2
        mirror = basis[:, ::-1][:, :half].copy()
        if self.count % 2:
            mirror[:, -1] = 0  # the middle function is its own mirror image
        return basis[:, :half] + mirror

    def coefficients(self, z: FloatArray) -> FloatArray:
        """Return the coefficients (count,) of all B-splines. `z` begins with the independent coefficients."""
        m = self.count
        if not self.mirrored:
            return z[:m].copy()
        half = (m + 1) // 2
        return np.concatenate([z[:half], z[: m // 2][::-1]])


SAME_SCALE = 1e-5
"""Relative change of the scale below which the search is not repeated with the new scale."""


@dataclass(frozen=True, eq=False)
class SectionScale:
    """Relation between the bending stiffness E I and the relative stiffness K: E I = `scale` K.

    K is between 1 and `ratio`. E I is within the limits of the section.

    Attributes
    ----------
    family : Section
        Sections of all sizes, with the limits of the size.
    scale : float
        Bending stiffness for K = 1, N mm2.
    ratio : float
        Largest K.
    """

    family: Section
    scale: float
    ratio: float

    @classmethod
    def of(cls, family: Section, limits: Limits, *, heavy: bool) -> "SectionScale":
        """Return the relation between E I and K for a section.

        With one limit, the scale follows from it: the thinnest place has the least size, or the thickest place the
        largest. With both limits, a `heavy` rod gets the largest scale. Without weight, the shape does not depend
        on the scale, and the rod gets the least scale if thin sections withstand larger curvatures, else the
        largest.
        """
        least, largest = family.limits
        ratio = limits.largest_ratio
        if not np.isfinite(largest):
            return cls(family, float(family.bending_stiffness(least).max()), ratio)
        most = float(family.bending_stiffness(largest).min())
        if least > 0:
            low = float(family.bending_stiffness(least).max())
            if low > most:
                raise InputError(
                    "the {quantity} limits {least:g} and {largest:g} are too close together: set them "
                    "farther apart",
                    quantity=family.quantity,
                    least=BareLength(least),
                    largest=Length(largest),
                )
            ratio = min(ratio, most / low)
            # if stiffness and strain depend on the curvature, the scale is determined after the rod is known
            if not (heavy or family.follows_bend):
                thin, thick = cls(family, low, ratio).strain(np.array([1.0, most / low]), limits.strain)
                if thin < thick:
                    return cls(family, low, ratio)
        return cls(family, most / ratio, ratio)

    def grown(self, stiffness: FloatArray, bend: FloatArray, limits: Limits) -> Self:
        """Return a `SectionScale` with the largest scale that the section and the strain limit allow.

        `stiffness` (n,) is K at the nodes, and `bend` (n,) is the change of curvature there, 1/mm.
        """
        from scipy.optimize import brentq

        least, most = (
            pick(self.family.bending_stiffness(np.full(stiffness.size, limit)) / stiffness)
            for pick, limit in zip((np.max, np.min), self.family.limits, strict=True)
        )

        def room(log_scale: float) -> float:
            share = replace(self, scale=float(np.exp(log_scale))).strain(stiffness, limits.strain)
            return 1.0 - float((share * np.abs(bend)).max())

        low, high = np.log(min(least, self.scale)), np.log(max(most, self.scale))
        # without a sheet there is no strain limit; if even the least scale exceeds the limit, nothing changes
        if limits.sheet is None or room(high) >= 0:
            return replace(self, scale=float(np.exp(high)))
        return replace(self, scale=float(np.exp(brentq(room, low, high)))) if room(low) > 0 else self

    def bearing(self, bend: FloatArray, limits: Limits) -> Self | None:
        """Return a `SectionScale` with a smaller scale, so that the sections withstand the change of
        curvature `bend`.

        `bend` (n,) is in 1/mm. Return None if the scale need not or cannot be reduced.
        """
        least, largest = self.family.limits
        if limits.sheet is None or not (least > 0 and np.isfinite(largest)):
            return None
        low = float(self.family.bending_stiffness(least).max())
        # the largest section, for which K is `ratio`, withstands the bend if it is not stiffer than the even rod
        even = replace(self, scale=low).grown(np.ones(bend.size), bend, limits)
        scale = max(low, even.scale / self.ratio)
        return replace(self, scale=scale) if scale < self.scale * (1 - SAME_SCALE) else None

    def settled(self, bend: FloatArray, stiffness: FloatArray, rest: float | FloatArray) -> Self:
        """Return a `SectionScale` with the scale at which the largest section of the rod is as large as
        allowed.

        At the nodes, `stiffness` (n,) is K, `bend` (n,) is the change of curvature, and `rest` is the natural
        curvature, 1/mm. The result is this object if the scale does not change.
        """
        family = self.family.bent(bend, rest)
        scale = scale_within(family, stiffness)
        return self if abs(scale / self.scale - 1) < SAME_SCALE else replace(self, family=family, scale=scale)

    def largest(self, bend: FloatArray, rest: float | FloatArray) -> FloatArray:
        """Return the bending stiffness (n,), N mm2, of the largest allowed section at n nodes.

        `bend` (n,) is the change of curvature, and `rest` is the natural curvature, 1/mm.
        """
        return self.family.bent(bend, rest).bending_stiffness(np.full(bend.size, self.family.limits[1]))

    def weight(self, stiffness: FloatArray, *, size: float) -> tuple[FloatArray, FloatArray]:
        """Return the weight per length (n,) for the stiffness K (n,), and the derivative of the weight by K.

        The weight is divided by the scale and multiplied by the cube of `size`, mm.
        """
        slope, fixed = tangent_weight(self.family, self.scale * stiffness)
        over = size**3
        return (fixed / self.scale + slope * stiffness) * over, slope * over

    def carried_by(self, rod: Rod, stiffness: FloatArray) -> Rod:
        """Return the rod with this scale and, under gravity, with the weight for K (n,) at the nodes."""
        EI = self.scale * stiffness
        scaled = replace(rod, bending_stiffness=float(EI.min()), section=self.family)
        if rod.gravity is None:
            return scaled
        slope, fixed = tangent_weight(self.family, EI)
        alpha = Profile.interpolate(rod.s, fixed)
        return replace(scaled, weight=Weight(alpha, Profile.interpolate(rod.s, slope * EI.min())))

    def tangent(self, stiffness: FloatArray, bend: FloatArray, rest: float | FloatArray) -> FloatArray:
        """Return the derivative of the moment by the curvature (..., n), in the unit of the stiffness K (..., n).

        `bend` (..., n) is the change of curvature, and `rest` is the natural curvature, 1/mm.
        """
        family = self.family.bent(bend, rest)
        curl = family.curl(family.parameter(self.scale * stiffness))
        if curl is None:
            return stiffness
        return stiffness * CurlingLaw(curl, curl(bend + rest), rest).slope(bend)

    def strain(self, stiffness: FloatArray, limit: float | None) -> FloatArray:
        """Return the surface strain per change of curvature, mm, as a fraction of the allowed strain.

        The result (n,) is for sections with the relative stiffness K = `stiffness` (n,).
        """
        layers = self.family.strains(np.ones(stiffness.size), self.family.parameter(self.scale * stiffness))
        # a small part of the limit is a reserve for errors of the strain between nodes
        shares = [layer.strain / ((1 - 2e-5) * (limit or layer.limit)) for layer in layers]
        return np.asarray(np.max(shares, axis=0))


# names of cached properties of a rod that compiled code computes in one call
_SHAPE = "tangents", "position", "pull", "shear"

Value = TypeVar("Value")
WeightLaw: TypeAlias = Callable[[FloatArray], tuple[FloatArray, FloatArray]]


@dataclass(frozen=True)
class Unknowns:
    """Index of each unknown in the vector z (p,).

    Attributes
    ----------
    coefficients, count : int
        Number of coefficients of the stiffness K, and number p of unknowns.
    stiffness : slice
        Coefficients of the stiffness K.
    moment : int
        Moment at the first node.
    force : slice
        Force lambda before the first node, without the weight of the node.
    position : slice
        Position of the first node.
    angle, length : int
        Angle at the start, and length of the rod.
    """

    coefficients: int
    count: int
    stiffness: slice
    moment: int
    force: slice
    position: slice
    angle: int
    length: int


@dataclass(frozen=True, eq=False, kw_only=True)
class MappedRod(DiscreteRod):
    """Discrete rod for given unknowns, in equilibrium or nearly so.

    Attributes
    ----------
    z : (p,) array
        Unknowns.
    moments : (n+1,) array
        Moments at the nodes.
    all_angles : (n+2,) array
        Angles at the start, of the edges, and at the end.
    all_forces : (n+2, 2) array
        Force lambda before the first node, in the edges, and after the last node.
    length : float
        Length, as a multiple of the length of the target.
    memory : dict
        Cache of expensive results for this rod.
    """

    z: FloatArray
    moments: FloatArray
    all_angles: FloatArray
    all_forces: FloatArray
    length: float
    memory: dict[Hashable, Any] = field(default_factory=dict)

    def remembered(self, key: Hashable, compute: Callable[[], Value]) -> Value:
        """Return the cached result of `compute` for `key`."""
        if key not in self.memory:
            self.memory[key] = compute()
        return cast(Value, self.memory[key])


@dataclass(frozen=True, eq=False)
class Sensitivities:
    """Derivatives of angles, moments and positions of a rod with n edges by its p unknowns.

    The arrays can have one more column: the change that brings the rod into equilibrium.

    Attributes
    ----------
    angles : (n+2, p) array
    moments : (n+1, p) array
    position : (n+1, 2, p) array
    """

    grid: "StripGrid"
    rod: MappedRod
    angles: FloatArray
    moments: FloatArray
    position: FloatArray

    def of_weighted_forces(self, weights: FloatArray) -> FloatArray:
        """Return the derivatives, by p unknowns, of the sum of `weights` (n, 2) times the forces in the n edges.

        The force in edge i is lambda - L e sums_i, with the force lambda at the start, the length L, and the weight
        sums_i of a rod of length 1 up to node i (see `CarriedWeight`).
        """
        grid = self.grid
        u, out = grid.unknowns, np.zeros(self.angles.shape[1])
        out[u.force] = weights.sum(axis=0)
        if grid.heavy:
            pull = weights @ grid.e
            out[u.stiffness] = -self.rod.length * (pull @ self.carried.slopes[:-1])
            out[u.length] = -float(pull @ self.carried.sums[:-1])
        return out

    def last_load_row(self, axis: int) -> FloatArray:
        """Return the derivatives, by p unknowns, of the load on the last node along `axis` (0: x, 1: y).

        The load is -L e times the weight of this node alone, because e points up: see `of_weighted_forces`.
        """
        grid, carried = self.grid, self.carried
        u, out = grid.unknowns, np.zeros(self.angles.shape[1])
        out[u.stiffness] = -grid.e[axis] * self.rod.length * (carried.slopes[-1] - carried.slopes[-2])
        out[u.length] = -grid.e[axis] * float(carried.sums[-1] - carried.sums[-2])
        return out

    @property
    def carried(self) -> "CarriedWeight":
        """Weight of the rod up to each node, with its derivatives."""
        return self.grid.carried(self.rod)


class CarriedWeight(NamedTuple):
    """Integrated weight of a rod of length 1.

    `sums` (n+1,) is the weight up to and including each node. `slopes` (n+1, m) are its derivatives with respect
    to the m coefficients of K.
    """

    sums: FloatArray
    slopes: FloatArray


@dataclass(frozen=True, eq=False)
class StripGrid:
    """Nodes of the rods in a search: n edges of equal length, with a basis for the stiffness K.

    Parameters
    ----------
    basis : (n+1, m) array
        Values of the m basis functions of K at the nodes; their sum is 1.
    e : (2,) array
        Vector e of Eq. 5 of the paper, which points up, times the cube of the unit of length.
    weight : callable, optional
        Function of K (n+1,) that returns the weight per length q (n+1,), in units of `e`, and the derivative of q
        by K. By default q = K.
    natural_curvature : float or (n+1,) array
        Natural curvature times the unit of length.
    """

    basis: FloatArray
    e: FloatArray
    natural_curvature: float | FloatArray = 0.0
    supports: Supports = field(default_factory=Supports)
    weight: WeightLaw | None = None

    @property
    def edges(self) -> int:
        """Number n of edges."""
        return len(self.basis) - 1

    @cached_property
    def unknowns(self) -> Unknowns:
        """Index of each unknown in z."""
        m = self.basis.shape[1]
        return Unknowns(
            coefficients=m, count=m + 7, stiffness=slice(0, m), moment=m, force=slice(m + 1, m + 3),
            position=slice(m + 3, m + 5), angle=m + 5, length=m + 6,
        )  # fmt: skip

    @cached_property
    def shares(self) -> FloatArray:
        """Length (n+1,) that belongs to each node of a rod of length 1: half of each adjacent edge."""
        return node_weights(1 / self.edges, self.edges)

    @cached_property
    def running(self) -> FloatArray:
        """Integrals (n+1, m) of the basis functions up to and including each node, for a rod of length 1."""
        return (self.shares[:, None] * self.basis).cumsum(axis=0)

    def carried(self, rod: MappedRod) -> CarriedWeight:
        """Return the integrated weight of a rod, from a cache if possible."""

        def summed() -> CarriedWeight:
            if self.weight is None:
                return CarriedWeight((self.shares * rod.stiffness).cumsum(), self.running)
            q, slope = self.weight(rod.stiffness)
            by_coefficient = (self.shares * slope)[:, None] * self.basis
            return CarriedWeight((self.shares * q).cumsum(), by_coefficient.cumsum(axis=0))

        return rod.remembered("carried weight", summed)

    @cached_property
    def heavy(self) -> bool:
        """True if the rod has weight."""
        return bool(self.e.any())

    def shoot(self, z: FloatArray) -> MappedRod:
        """Return the rod in equilibrium for unknowns z. Its last moment is not finite if numbers overflow."""
        K, force, length = self._stiffness_forces_length(z)
        u = self.unknowns
        angles, moments = shoot(
            K, length * self.shares, force[1:-1], length / self.edges,
            moment=z[u.moment], angle=z[u.angle], natural_curvature=self.natural_curvature,
        )  # fmt: skip
        return self._assemble(z, angles, moments, K, force, length)

    def assemble(self, z: FloatArray, angles: FloatArray, moments: FloatArray) -> MappedRod:
        """Return a rod with given angles (n+2,) and moments (n+1,), which need not be in equilibrium."""
        return self._assemble(z, angles, moments, *self._stiffness_forces_length(z))

    def sensitivities(self, rod: MappedRod, *, to_equilibrium: bool = False) -> Sensitivities:
        """Return the derivatives of angles, moments and positions by the unknowns z.

        Each angle and each moment depends on the angle and the moment before it. Therefore all derivatives are
        solutions of one banded triangular system. With `to_equilibrium`, one more column is the change that brings
        the rod into equilibrium, to first order.
        """
        columns = self.unknowns.count + to_equilibrium
        if _native.compiled is None:
            return self._sensitivities_in_python(rod, columns, to_equilibrium)
        derivatives = _native.sensitivities(
            stiffness=rod.stiffness, moments=rod.moments, all_angles=rod.all_angles, tangents=rod.tangents,
            pull=rod.pull, shear=rod.shear, shares=self.shares, basis=self.basis, e=self.e,
            rest=np.broadcast_to(self.natural_curvature, self.shares.shape),
            carried=self.carried(rod) if self.heavy else None, length=rod.length,
            start_moment=rod.z[self.unknowns.moment], start_angle=rod.z[self.unknowns.angle],
            to_equilibrium=to_equilibrium,
        )  # fmt: skip
        return Sensitivities(self, rod, *derivatives)

    def _sensitivities_in_python(self, rod: MappedRod, columns: int, to_equilibrium: bool) -> Sensitivities:
        """Return the derivatives of a rod, as the compiled version does.

        With `to_equilibrium`, the last column is the change that brings the rod into equilibrium.
        """
        n, u = self.edges, self.unknowns
        K, M, T, length = rod.stiffness, rod.moments, rod.tangents, rod.length
        edge, w = length / n, length * self.shares

        # derivatives of angles and moments, in the order alpha_0, M_0, alpha_1, ..., M_n, alpha_{n+1}
        right = np.zeros((2 * n + 3, columns), order="F")
        drive_angle, drive_moment = right[0::2], right[1::2]
        drive_angle[0, u.angle] = drive_moment[0, u.moment] = 1
        np.multiply((-w * M / K**2)[:, None], self.basis, out=drive_angle[1:, u.stiffness])
        drive_angle[1:, u.length] = self.shares * (M / K + self.natural_curvature)
        drive_moment[1:, u.force] = edge * left_of(T)
        drive_moment[1:, u.length] = rod.shear / n
        if self.heavy:
            lift = cross(T, self.e)
            carried = self.carried(rod)
            np.multiply(
                (-edge * length * lift)[:, None], carried.slopes[:-1], out=drive_moment[1:, u.stiffness]
            )
            drive_moment[1:, u.length] -= edge * lift * carried.sums[:-1]
        if to_equilibrium:
            turned = rod.all_angles[:-1] + w * (M / K + self.natural_curvature)
            drive_angle[:, -1] = np.append(rod.z[u.angle], turned) - rod.all_angles
            drive_moment[:, -1] = np.append(rod.z[u.moment], M[:-1] + edge * rod.shear) - M
        # rows: the diagonal, which is 1 and not read, then the two diagonals below it
        band = np.zeros((3, 2 * n + 3))
        band[1, 2:-1:2] = edge * rod.pull  # minus the derivative of moment M_i by angle alpha_i
        band[1, 1::2] = -w / K
        band[2] = -1
        solved, _ = lapack().dtbtrs(band, right, uplo="L", diag="U", overwrite_b=1)
        angles, moments = solved[0::2], solved[1::2]
        position = np.zeros((n + 1, 2, columns))
        step = position[1:]
        # derivatives may overflow; `linearize` then returns None
        with np.errstate(over="ignore", invalid="ignore"):
            np.multiply((-edge * T[:, 1])[:, None], angles[1:-1], out=step[:, 0])
            np.multiply((edge * T[:, 0])[:, None], angles[1:-1], out=step[:, 1])
            step[:, :, u.length] += T / n
            step.cumsum(axis=0, out=step)
        position[:, 0, u.position.start] += 1
        position[:, 1, u.position.start + 1] += 1
        return Sensitivities(self, rod, angles, moments, position)

    def _stiffness_forces_length(self, z: FloatArray) -> tuple[FloatArray, FloatArray, float]:
        """Return K (n+1,) at the nodes, the forces (n+2, 2) before, in and after the n edges, and the length."""
        u = self.unknowns
        length = float(z[u.length])
        K = self.basis @ z[u.stiffness]
        force = np.empty((self.edges + 2, 2))
        if not self.heavy:
            force[:] = z[u.force]
            return K, force, length
        weight = K if self.weight is None else self.weight(K)[0]
        load = (-length * self.shares * weight)[:, None] * self.e
        force[0] = z[u.force]
        force[1:-1] = edge_forces(z[u.force] + load[0], load)
        force[-1] = force[-2] + load[-1]
        return K, force, length

    def _assemble(
        self, z: FloatArray, angles: FloatArray, moments: FloatArray, K: FloatArray, force: FloatArray,
        length: float,
    ) -> MappedRod:  # fmt: skip
        rod = MappedRod(
            K, angles[1:-1], force[1:-1], length / self.edges, self.supports, z[self.unknowns.position],
            z=z, moments=moments, all_angles=angles, all_forces=force, length=length,
        )  # fmt: skip
        if _native.compiled is not None:
            shape = _native.shape(rod.angles, rod.force, rod.start, length / self.edges)
            rod.__dict__.update(zip(_SHAPE, shape, strict=True))
        return rod
