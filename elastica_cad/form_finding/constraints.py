"""Constraints of the nearest rod: limits to meet, and properties of the drawn curve to keep."""

from abc import ABC, abstractmethod
from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from math import hypot

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.errors import note
from elastica_cad.form_finding.limits import STRAIN, ActiveLimit, Places, Room
from elastica_cad.form_finding.rod_map import MappedRod, SectionScale, Sensitivities
from elastica_cad.geometry.plane_points import left_of
from elastica_cad.mechanics.discrete_rod import DiscreteRod
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.stability import stability

# largest number of rows of a constraint in a quadratic program, because the linear algebra library starts
# threads at 64 rows
MOST_ROWS = 56


@dataclass(frozen=True, kw_only=True)
class Constraint(ABC):
    """Constraint of the search for the nearest rod: k values that depend on the rod.

    The values are scaled so that a large violation is about 1.

    Attributes
    ----------
    active : ActiveLimit
        Name, limit, title, unit and sentence of the limit or kept property.
    one_sided : bool
        True if the values must be at least 0; False if they must be 0.
    penalty : float
        Upper bound of the penalty for a violation of 1.
    near_balance_only : bool
        True if the constraint is only meaningful for rods nearly in equilibrium.
    """

    active: ActiveLimit
    one_sided: bool = False
    penalty: float = 100.0
    near_balance_only: bool = False

    def slope(self, size: float) -> float:
        """Return the change of the values if the limit is relaxed by 1 in its unit."""
        return 1 / size if self.active.unit == "length" else 1 / (self.active.limit or 1.0)

    def binding(self, values: FloatArray, multipliers: FloatArray, size: float, per: float) -> ActiveLimit:
        """Return the effect of the constraint on the distance.

        `values` and `multipliers` (k,) belong to the nearest rod, `per` is the decrease of the distance, mm, by a
        unit decrease of the objective.
        """
        if self.one_sided:
            broken, total = np.maximum(-values, 0), float(np.abs(multipliers).sum())
        else:
            broken, total = np.abs(values), float(np.linalg.norm(multipliers))
        return replace(
            self.active, cost=per * total * self.slope(size), broken=float(broken.max(initial=0.0)),
            title=note(self.active.title),
        )  # fmt: skip

    @abstractmethod
    def values(self, rod: MappedRod) -> FloatArray:
        """Return the k values for a rod, as an array (k,)."""

    @abstractmethod
    def rows(self, sensitivities: Sensitivities) -> tuple[IntArray, FloatArray]:
        """Return the indices (j,) and derivatives (j, p) of the values that a step may violate.

        The derivatives are with respect to the p unknowns of the search.
        """


def thin_rows(indices: IntArray, urgency: FloatArray) -> IntArray:
    """Return at most MOST_ROWS of the `indices` into `urgency` (n,), such as violations of a limit at n nodes.

    Up to half of the result are local maxima of `urgency`, and the others are evenly spaced. If a step violates
    the limit at an omitted index, the index is a local maximum in the next call.
    """
    if indices.size <= MOST_ROWS:
        return indices
    high = np.concatenate([[-np.inf], urgency, [-np.inf]])
    peak = (urgency >= high[:-2]) & (urgency >= high[2:])
    selected = np.zeros(indices.size, dtype=bool)
    selected[np.flatnonzero(peak[indices])[: MOST_ROWS // 2]] = True
    remaining = np.flatnonzero(~selected)
    selected[remaining[:: -(-remaining.size // (MOST_ROWS - selected.sum()))]] = True
    return indices[selected]


def _all_rows(rows: FloatArray) -> tuple[IntArray, FloatArray]:
    # all values with their indices, for constraints with few values
    return np.arange(len(rows)), rows


@dataclass(frozen=True, kw_only=True)
class EndPosition(Constraint):
    """Condition that the last node of the rod is at `target`."""

    active: ActiveLimit = ActiveLimit("end position", unit="length")
    target: tuple[float, float] = (0.0, 0.0)

    def values(self, rod: MappedRod) -> FloatArray:
        """Return the position (2,) of the last node relative to the target."""
        return np.asarray(rod.position[-1] - self.target)

    def rows(self, sensitivities: Sensitivities) -> tuple[IntArray, FloatArray]:
        """Return the indices and the derivatives of both coordinates: see `Constraint.rows`."""
        return _all_rows(sensitivities.position[-1])


@dataclass(frozen=True, kw_only=True)
class EndAngle(Constraint):
    """Condition that the angle at the end of the rod is `target`, rad."""

    active: ActiveLimit = ActiveLimit("end tangent", unit="angle")
    target: float = 0.0

    def values(self, rod: MappedRod) -> FloatArray:
        """Return the difference between the end angle and the target (1,), rad."""
        return rod.all_angles[-1:] - self.target

    def rows(self, sensitivities: Sensitivities) -> tuple[IntArray, FloatArray]:
        """Return the index and the derivatives of the end angle: see `Constraint.rows`."""
        return _all_rows(sensitivities.angles[-1:])


@dataclass(frozen=True, kw_only=True)
class EndMoment(Constraint):
    """Condition that the moment is 0 at an end that is free to turn."""

    active: ActiveLimit = ActiveLimit("free end angle")
    scale: float = 1.0

    def values(self, rod: MappedRod) -> FloatArray:
        """Return the moment at the last node divided by `scale` (1,)."""
        return rod.moments[-1:] / self.scale

    def rows(self, sensitivities: Sensitivities) -> tuple[IntArray, FloatArray]:
        """Return the index and the derivatives of the scaled moment: see `Constraint.rows`."""
        return _all_rows(sensitivities.moments[-1:] / self.scale)


@dataclass(frozen=True, kw_only=True)
class EndForce(Constraint):
    """Condition that the force at the end is 0 along an `axis` (0: x, 1: y) along which the end can move."""

    active: ActiveLimit = ActiveLimit("free end position")
    axis: int = 0
    scale: float = 1.0

    def values(self, rod: MappedRod) -> FloatArray:
        """Return the force at the end along the axis, divided by `scale` (1,)."""
        return rod.all_forces[-1:, self.axis] / self.scale

    def rows(self, sensitivities: Sensitivities) -> tuple[IntArray, FloatArray]:
        """Return the index and the derivatives of the scaled force: see `Constraint.rows`."""
        weights = np.zeros_like(sensitivities.rod.tangents)
        weights[-1, self.axis] = 1
        row = sensitivities.of_weighted_forces(weights)
        row += sensitivities.last_load_row(self.axis)
        return _all_rows(row[None] / self.scale)


@dataclass(frozen=True, kw_only=True)
class Through(Constraint):
    """Condition that the rod passes through `target`, near the fraction `place` (0..1) of the rod's length."""

    active: ActiveLimit = ActiveLimit("points", title="the kept points", unit="length")
    target: tuple[float, float] = (0.0, 0.0)
    place: float = 0.5

    def values(self, rod: MappedRod) -> FloatArray:
        """Return the signed distance of the rod from the target, along the normal of the rod (1,)."""
        share, nodes, normal = self._foot(rod)
        return np.array([normal @ (share @ rod.position[nodes] - self.target)])

    def rows(self, sensitivities: Sensitivities) -> tuple[IntArray, FloatArray]:
        """Return the index and the derivatives of the signed distance: see `Constraint.rows`."""
        share, nodes, normal = self._foot(sensitivities.rod)
        return _all_rows(np.einsum("i,k,ikp->p", share, normal, sensitivities.position[nodes])[None])

    def _foot(self, rod: MappedRod) -> tuple[FloatArray, slice, FloatArray]:
        return rod.remembered(self, lambda: self._find_foot(rod.position))

    def _find_foot(self, position: FloatArray) -> tuple[FloatArray, slice, FloatArray]:
        """Return the point of the rod nearest to the target: weights of four nodes, these nodes, and the normal.

        The rod is a cubic through these nodes. The point is within 0.15 of `place`.
        """
        n = len(position) - 1
        # nodes near `place`, because the rod may pass the target more than once
        window = np.arange(n + 1)
        window = window[np.abs(window / n - self.place) < 0.15]
        off = position[window] - self.target
        nearest = int(window[(off**2).sum(axis=1).argmin()])
        first = int(np.clip(nearest - 1, 0, n - 3))
        nodes = slice(first, first + 4)
        off = position[nodes] - self.target
        u = float(nearest - first)
        for _ in range(8):
            share, slope = _cubic_weights(u)
            along = slope @ off
            u -= float(along @ (share @ off) / (along @ along))
            u = min(max(u, -0.5 if first == 0 else 0.0), 3.0)
        share, slope = _cubic_weights(u)
        x, y = slope @ off
        return share, nodes, np.array([-y, x]) / hypot(x, y)


@dataclass(frozen=True, kw_only=True)
class InflectionLine(Constraint):
    """Condition that the moment is 0 on the line through `point` along `direction`.

    Without weight, the moment is an affine function of the position in the whole plane.
    """

    active: ActiveLimit = ActiveLimit("inflection line", title="the inflection line")
    point: tuple[float, float] = (0.0, 0.0)
    direction: tuple[float, float] = (1.0, 0.0)
    scale: float = 1.0

    def values(self, rod: MappedRod) -> FloatArray:
        """Return the moment at `point` and its derivative along the line, both divided by `scale` (2,)."""
        (fx, fy), (x, y), (u, v) = rod.all_forces[0], self.point - rod.position[0], self.direction
        return np.array([rod.moments[0] + fy * x - fx * y, fy * u - fx * v]) / self.scale

    def rows(self, sensitivities: Sensitivities) -> tuple[IntArray, FloatArray]:
        """Return the indices and the derivatives of both values: see `Constraint.rows`."""
        rod = sensitivities.rod
        u = sensitivities.grid.unknowns
        rows = np.zeros((2, sensitivities.angles.shape[1]))
        b = np.array([rod.all_forces[0, 1], -rod.all_forces[0, 0]])  # gradient of the moment in the plane
        off = self.point - rod.position[0]
        rows[0, u.moment] = 1
        rows[0, u.force] = left_of(off)
        rows[0, u.position] = -b
        rows[1, u.force] = [-self.direction[1], self.direction[0]]
        return _all_rows(rows / self.scale)


@dataclass(frozen=True, kw_only=True)
class MiddleOfMirror(Constraint):
    """Condition that the rod is symmetric about an axis.

    The middle of the rod then crosses the axis at a right angle, and the force there is normal to the axis.
    """

    active: ActiveLimit = ActiveLimit("symmetry", title="the symmetry")
    centre: tuple[float, float] = (0.0, 0.0)
    axis: tuple[float, float] = (0.0, 1.0)
    angle: float = 0.0
    scale: float = 1.0

    def values(self, rod: MappedRod) -> FloatArray:
        """Return the distance from the axis, the error of the angle, and the scaled force along the axis (3,)."""
        nodes, edges = _middle(rod)
        normal = left_of(self.axis)
        off = rod.position[nodes].mean(axis=0) - self.centre
        turn = rod.angles[edges].mean() - self.angle
        return np.array([normal @ off, turn, rod.force[edges].mean(axis=0) @ self.axis / self.scale])

    def rows(self, sensitivities: Sensitivities) -> tuple[IntArray, FloatArray]:
        """Return the indices and the derivatives of all three values: see `Constraint.rows`."""
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
                    sensitivities.of_weighted_forces(weights),
                ]
            )
        )


@dataclass(frozen=True, kw_only=True)
class MiddleOfTurn(Constraint):
    """Condition that the rod is symmetric under rotation by 180 degrees.

    The middle of the rod is then at the centre, and the moment there is 0.
    """

    active: ActiveLimit = ActiveLimit("symmetry", title="the symmetry")
    centre: tuple[float, float] = (0.0, 0.0)
    scale: float = 1.0

    def values(self, rod: MappedRod) -> FloatArray:
        """Return the two offsets of the middle from the centre, and the scaled moment there (3,)."""
        nodes, _ = _middle(rod)
        off = rod.position[nodes].mean(axis=0) - self.centre
        return np.append(off, rod.moments[nodes].mean() / self.scale)

    def rows(self, sensitivities: Sensitivities) -> tuple[IntArray, FloatArray]:
        """Return the indices and the derivatives of all three values: see `Constraint.rows`."""
        nodes, _ = _middle(sensitivities.rod)
        moment = sensitivities.moments[nodes].mean(axis=0) / self.scale
        return _all_rows(np.vstack([sensitivities.position[nodes].mean(axis=0), moment]))


def _middle(rod: MappedRod) -> tuple[Sequence[int], Sequence[int]]:
    # indices of the one or two nodes, and of the one or two edges, nearest to the middle of the rod
    n = len(rod.tangents)
    return sorted({n // 2, (n + 1) // 2}), sorted({(n - 1) // 2, n // 2})


_CUBIC = np.linalg.inv(np.vander(np.arange(4.0), increasing=True))
"""Matrix (4, 4) that maps values at 0, 1, 2, 3 to the coefficients of the cubic through them."""


def _cubic_weights(u: float) -> tuple[FloatArray, FloatArray]:
    # weights (4,) of the values at 0, 1, 2, 3 in the cubic at u, and the derivatives of the weights by u
    return np.array([1, u, u**2, u**3]) @ _CUBIC, np.array([0, 1, 2 * u, 3 * u**2]) @ _CUBIC


# values above this fraction of a limit enter the quadratic program, because a step may violate the limit
_NEAR = 0.6
_STEP = 1e-5  # relative change of the stiffness in finite differences of the strain
# reserve in `LargestSection.values`, because the curvature can be larger between nodes
_SAFETY_SHARE = 0.01
# relative change of stiffness and curvature in finite differences; smaller changes could fall on a kink
_TANGENT_STEP = 1e-3


def margin_limit(least: float) -> ActiveLimit:
    """Return the words and the value of a limit of the stability margin."""
    return ActiveLimit(
        "margin", least, title="the stability margin", unit="number", sentence=_margin_sentence
    )


def _margin_sentence(limit: float, rod: Rod) -> str:
    rating = stability(rod)
    return note(
        "The stability margin is {margin:.3g} ({word}), below the limit of {limit:.3g}.",
        limit=limit, margin=rating.margin, word=note(rating.rating),
    )  # fmt: skip


@dataclass(frozen=True, kw_only=True)
class MarginLimit(Constraint):
    """Condition that the stability margin, divided by the least stiffness, is at least `limit`."""

    one_sided: bool = True
    penalty: float = 1.0
    near_balance_only: bool = True

    @property
    def limit(self) -> float:
        """Least stability margin."""
        return self.active.limit or 0.0

    @property
    def scale(self) -> float:
        """Difference between limit and margin that is scaled to a violation of 1."""
        return max(10.0, abs(self.limit))

    def slope(self, size: float) -> float:  # noqa: ARG002 - a margin has no unit
        """Return the change of the value by a unit change of the limit."""
        return 1 / self.scale

    def disturbed(self, rod: MappedRod) -> DiscreteRod:
        """Return the rod with its tangent stiffness: the derivative of the moment by the curvature.

        The tangent stiffness resists small disturbances. For Hooke's law it equals the stiffness.
        """
        return rod

    def values(self, rod: MappedRod) -> FloatArray:
        """Return (margin - limit times least stiffness) / scale, as an array (1,)."""
        return np.array([(self.disturbed(rod).margin.value - self.limit * rod.stiffness.min()) / self.scale])

    def rows(self, sensitivities: Sensitivities) -> tuple[IntArray, FloatArray]:
        """Return the index and the derivatives of the scaled margin: see `Constraint.rows`."""
        # `d` has the derivatives of the margin by angles and forces of edges, stiffness at nodes, and length
        rod, d = sensitivities.rod, self.disturbed(sensitivities.rod).margin_derivatives
        u = sensitivities.grid.unknowns
        row = d.angles @ sensitivities.angles[1:-1] + sensitivities.of_weighted_forces(d.force)
        by_stiffness, by_moment = self.chained(rod, d.stiffness)
        if by_moment is not None:
            row += by_moment @ sensitivities.moments
        by_stiffness[rod.stiffness.argmin()] -= self.limit
        row[u.stiffness] += by_stiffness @ sensitivities.grid.basis
        row[u.length] += d.length
        return _all_rows(row[None] / self.scale)

    def chained(
        self,
        rod: MappedRod,  # noqa: ARG002 - used by `FollowedMarginLimit`
        by_tangent: FloatArray,
    ) -> tuple[FloatArray, FloatArray | None]:
        """Convert derivatives (n+1,) by the tangent stiffness to derivatives by stiffness and by moment.

        `by_tangent` are the derivatives of the margin by the tangent stiffness. The second result is None if
        the moment has no effect.
        """
        return by_tangent.copy(), None


@dataclass(frozen=True, kw_only=True)
class FollowedMarginLimit(MarginLimit):
    """Limit of the stability margin for sections whose stiffness depends on the curvature.

    The margin depends on the tangent stiffness. The tangent stiffness exceeds the stiffness if a strip stiffens
    as it bends, and is less if a pre-bent strip is bent straight.

    Attributes
    ----------
    rest : float or (n+1,) array
        Natural curvature times the length of the target.
    size : float
        Length of the target, the unit of length of the search, mm.
    """

    section: SectionScale
    rest: float | FloatArray
    size: float

    def disturbed(self, rod: MappedRod) -> DiscreteRod:
        """Return the rod with its tangent stiffness in place of its stiffness."""

        def with_tangent_stiffness() -> DiscreteRod:
            K = self.section.tangent(rod.stiffness, _bend(rod, self.size), self.rest / self.size)
            return DiscreteRod(K, rod.angles, rod.force, rod.edge_length, rod.supports, rod.start)

        return rod.remembered((FollowedMarginLimit, id(self.section)), with_tangent_stiffness)

    def chained(self, rod: MappedRod, by_tangent: FloatArray) -> tuple[FloatArray, FloatArray | None]:
        """Convert derivatives by the tangent stiffness to derivatives by stiffness and by moment."""
        K, bend = rod.stiffness, _bend(rod, self.size)
        step = _TANGENT_STEP * float(np.abs(bend).max() or 1.0)
        # four rows of finite differences: K larger and smaller, then the bend larger and smaller
        by_K, by_step = np.array([_TANGENT_STEP, -_TANGENT_STEP, 0, 0]), np.array([0, 0, step, -step])
        stiffer, softer, more, less = self.section.tangent(
            K * (1 + by_K[:, None]), bend + by_step[:, None], self.rest / self.size
        )
        by_stiffness = by_tangent * (stiffer - softer) / (2 * _TANGENT_STEP * K)
        by_moment = by_tangent * (more - less) / (2 * step * K * self.size)
        # the bend is M / K, so that K acts through the bend too
        return by_stiffness - by_moment * rod.moments / K, by_moment


@dataclass(frozen=True, kw_only=True)
class LargestSection(Constraint):
    """Condition that no section of the bent strip exceeds the largest section that its limits allow."""

    section: SectionScale
    rest: float | FloatArray
    size: float
    active: ActiveLimit = ActiveLimit("largest section")
    one_sided: bool = True
    penalty: float = 1.0

    def values(self, rod: MappedRod) -> FloatArray:
        """Return allowed stiffness / present stiffness - 1 - reserve at the nodes (n+1,)."""
        most = self.section.largest(_bend(rod, self.size), self.rest / self.size)
        return most / (self.section.scale * rod.stiffness) - 1 - _SAFETY_SHARE

    def rows(self, sensitivities: Sensitivities) -> tuple[IntArray, FloatArray]:
        """Return indices and derivatives of the values at nodes near the largest section: see `Constraint.rows`."""
        rod = sensitivities.rod
        values, K, bend = self.values(rod), rod.stiffness, _bend(rod, self.size)
        near = thin_rows(np.flatnonzero(values < _NEAR), -values)
        step = _TANGENT_STEP * float(np.abs(bend).max() or 1.0)
        more, less = (self.section.largest(bend + by, self.rest / self.size) for by in (step, -step))
        # the allowed stiffness depends on the bend M / K, and the present stiffness is `scale` K
        by_moment = (more - less) / (2 * step * K * self.size) / (self.section.scale * K)
        by_stiffness = -by_moment * rod.moments / K - (1 + _SAFETY_SHARE + values) / K
        return near, _nodal_rows(sensitivities, near, by_moment, by_stiffness)


def _nodal_rows(
    sensitivities: Sensitivities, near: IntArray, by_moment: FloatArray, by_stiffness: FloatArray
) -> FloatArray:
    # derivatives (j, p) at j nodes `near`, from those (n+1,) by the moment and by the stiffness K at the node
    grid, rows = sensitivities.grid, by_moment[near, None] * sensitivities.moments[near]
    rows[:, grid.unknowns.stiffness] += by_stiffness[near, None] * grid.basis[near]
    return np.asarray(rows)


def _bend(rod: MappedRod, size: float) -> FloatArray:
    """Return the change of curvature at the nodes (n+1,), 1/mm. `size` is the unit of length of the rod, mm."""
    return rod.moments / rod.stiffness / size


@dataclass(frozen=True, kw_only=True)
class StrainLimit(Constraint):
    """Condition that the strain at every node is within its limit."""

    section: SectionScale
    strain: float | None
    size: float
    active: ActiveLimit = STRAIN
    one_sided: bool = True
    penalty: float = 1.0

    def share(self, stiffness: FloatArray) -> FloatArray:
        """Return the strain, divided by the strain limit, for a curvature changed by 1 / length of the target.

        The result (n+1,) is for nodes of this `stiffness` (n+1,).
        """
        return self.section.strain(stiffness, self.strain) / self.size

    def values(self, rod: MappedRod) -> FloatArray:
        """Return 1 - strain / limit at the nodes (n+1,)."""
        return 1 - self.share(rod.stiffness) * np.abs(rod.moments / rod.stiffness)

    def rows(self, sensitivities: Sensitivities) -> tuple[IntArray, FloatArray]:
        """Return the indices and derivatives of the values at nodes near the limit: see `Constraint.rows`."""
        rod = sensitivities.rod
        values = self.values(rod)
        near = thin_rows(np.flatnonzero(values < 1 - _NEAR), -values)
        K, M = rod.stiffness, rod.moments
        share = self.share(K)
        slope = (self.share(K * (1 + _STEP)) - self.share(K * (1 - _STEP))) / (2 * _STEP * K)
        by_stiffness = np.abs(M) * (share / K - slope) / K
        return near, _nodal_rows(sensitivities, near, -np.sign(M) * share / K, by_stiffness)


@dataclass(frozen=True, kw_only=True)
class AtNodes(Constraint):
    """Condition that all nodes meet a limit of places, which is given in mm.

    Positions of the rod are relative to `origin`, in units of `size`, mm. `rest` is the curvature before bending,
    in units of 1 / `size`.
    """

    room: Callable[[Places], Room]
    size: float
    rest: FloatArray | float = 0.0
    origin: tuple[float, float] = (0.0, 0.0)
    kept: tuple[bool, bool] = (False, False)
    one_sided: bool = True

    def values(self, rod: MappedRod) -> FloatArray:
        """Return the values of the limit at the nodes (n+1,)."""
        return self._at_nodes(rod)[0]

    def rows(self, sensitivities: Sensitivities) -> tuple[IntArray, FloatArray]:
        """Return the indices and derivatives of the values at nodes near the limit: see `Constraint.rows`."""
        rod = sensitivities.rod
        values, by_position, by_bend = self._at_nodes(rod)
        near = thin_rows(
            np.flatnonzero(values < (0.1 if self.active.unit == "length" else 1 - _NEAR)), -values
        )
        by_moment = by_bend / self.size / rod.stiffness
        rows = _nodal_rows(sensitivities, near, by_moment, -by_moment * rod.moments / rod.stiffness)
        return near, rows + np.einsum("ik,ikp->ip", by_position[near], sensitivities.position[near])

    def _at_nodes(self, rod: MappedRod) -> Room:
        s, position = np.linspace(0.0, self.size, rod.stiffness.size), rod.position * self.size + self.origin
        bend = _bend(rod, self.size)
        return self.room(Places(self.size, s, position, bend, bend + self.rest / self.size, self.kept))


@dataclass(frozen=True, kw_only=True)
class LeastStiffness(Constraint):
    """Condition that the least stiffness of the rod is 1, so that bounds are multiples of the least stiffness."""

    active: ActiveLimit = ActiveLimit("stiffness bounds", title="the stiffness bounds")
    one_sided: bool = True
    penalty: float = 1.0

    def values(self, rod: MappedRod) -> FloatArray:
        """Return 1 minus the least stiffness (1,).

        The constraint requires values of at least 0. The bounds of the coefficients keep the value at most 0.
        """
        return np.array([1 - rod.stiffness.min()])

    def rows(self, sensitivities: Sensitivities) -> tuple[IntArray, FloatArray]:
        """Return the index and the derivatives of the value: see `Constraint.rows`."""
        grid, rod = sensitivities.grid, sensitivities.rod
        row = np.zeros((1, sensitivities.angles.shape[1]))
        row[0, grid.unknowns.stiffness] = -grid.basis[rod.stiffness.argmin()]
        return _all_rows(row)
