"""What is kept of the drawn curve: ends, tangents, points, symmetry, the inflection line."""

from collections.abc import Sequence
from dataclasses import dataclass
from math import hypot

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.forming.nearest.constraints.constraint import Constraint, all_rows
from elastica_cad.forming.nearest.rod_map import MappedRod, Sensitivities


@dataclass(frozen=True, kw_only=True)
class EndPosition(Constraint):
    """The last node lies at `target`."""

    name: str = "end position"
    target: tuple[float, float] = (0.0, 0.0)

    def values(self, rod: MappedRod) -> FloatArray:
        """Gap (2,)."""
        return np.asarray(rod.position[-1] - np.asarray(self.target))

    def rows(self, sensitivities: Sensitivities) -> tuple[IntArray, FloatArray]:
        """Both."""
        return all_rows(sensitivities.position[-1])


@dataclass(frozen=True, kw_only=True)
class EndAngle(Constraint):
    """The end's angle is `target`."""

    name: str = "end tangent"
    target: float = 0.0

    def values(self, rod: MappedRod) -> FloatArray:
        """Difference (1,), rad."""
        return rod.all_angles[-1:] - self.target

    def rows(self, sensitivities: Sensitivities) -> tuple[IntArray, FloatArray]:
        """The one."""
        return all_rows(sensitivities.angles[-1:])


@dataclass(frozen=True, kw_only=True)
class EndMoment(Constraint):
    """No moment at an end that is free to turn."""

    name: str = "free end angle"
    scale: float = 1.0

    def values(self, rod: MappedRod) -> FloatArray:
        """M_n (1,)."""
        return rod.moments[-1:] / self.scale

    def rows(self, sensitivities: Sensitivities) -> tuple[IntArray, FloatArray]:
        """The one."""
        return all_rows(sensitivities.moments[-1:] / self.scale)


@dataclass(frozen=True, kw_only=True)
class EndForce(Constraint):
    """No force along an `axis` (0: x, 1: y) that the end leaves free."""

    name: str = "free end position"
    axis: int = 0
    scale: float = 1.0

    def values(self, rod: MappedRod) -> FloatArray:
        """lambda at the very end (1,)."""
        return rod.all_forces[-1:, self.axis] / self.scale

    def rows(self, sensitivities: Sensitivities) -> tuple[IntArray, FloatArray]:
        """The one: the last edge's force and the last node's load, both linear in z but for the length."""
        rod = sensitivities.rod
        n = rod.tangents.shape[0]
        weights = np.zeros((n, 2))
        weights[-1, self.axis] = 1
        row = sensitivities.along_forces(weights)
        row += sensitivities.last_load_row(self.axis)
        return all_rows(row[None] / self.scale)


@dataclass(frozen=True, kw_only=True)
class Through(Constraint):
    """The rod passes through `target`, first sought `place` (0..1) of its length from the start."""

    name: str = "points"
    target: tuple[float, float] = (0.0, 0.0)
    place: float = 0.5

    def values(self, rod: MappedRod) -> FloatArray:
        """Distance across the rod (1,)."""
        share, nodes, normal = self._foot(rod)
        off = share @ rod.position[nodes] - np.asarray(self.target)
        return np.array([normal @ off])

    def rows(self, sensitivities: Sensitivities) -> tuple[IntArray, FloatArray]:
        """The one."""
        share, nodes, normal = self._foot(sensitivities.rod)
        return all_rows(np.einsum("i,k,ikp->p", share, normal, sensitivities.position[nodes])[None])

    def _foot(self, rod: MappedRod) -> tuple[FloatArray, slice, FloatArray]:
        """The cubic through four nodes that passes nearest: its shares at the foot, the nodes, the normal there."""
        found: tuple[FloatArray, slice, FloatArray] = rod.remembered(
            self, lambda: self._find_foot(rod.position)
        )
        return found

    def _find_foot(self, position: FloatArray) -> tuple[FloatArray, slice, FloatArray]:
        n = position.shape[0] - 1
        window = np.arange(n + 1)
        window = window[np.abs(window / n - self.place) < 0.15]
        off = position[window] - np.asarray(self.target)
        nearest = int(window[np.argmin((off**2).sum(axis=1))])
        first = int(np.clip(nearest - 1, 0, n - 3))
        nodes = slice(first, first + 4)
        x, y = (position[nodes] - np.asarray(self.target)).T.tolist()
        u = float(nearest - first)
        share, slope = _lagrange(u)
        for _ in range(8):  # plain floats: arrays of four would cost fifty times as much
            along, across = _summed(slope, x), _summed(slope, y)
            u -= (along * _summed(share, x) + across * _summed(share, y)) / (along * along + across * across)
            u = min(max(u, -0.5 if first == 0 else 0.0), 3.0)
            share, slope = _lagrange(u)
        along, across = _summed(slope, x), _summed(slope, y)
        return np.array(share), nodes, np.array([-across, along]) / hypot(along, across)


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
        return all_rows(rows / self.scale)


@dataclass(frozen=True, kw_only=True)
class MiddleOfMirror(Constraint):
    """The middle stands on the axis, across it, and carries no force along it: one half mirrors the other."""

    name: str = "symmetry"
    centre: tuple[float, float] = (0.0, 0.0)
    axis: tuple[float, float] = (0.0, 1.0)
    angle: float = 0.0
    scale: float = 1.0

    def values(self, rod: MappedRod) -> FloatArray:
        """Distance from the axis, angle, force (3,)."""
        nodes, edges = _middle(rod)
        normal = np.array([-self.axis[1], self.axis[0]])
        off = rod.position[nodes].mean(axis=0) - np.asarray(self.centre)
        turn = rod.angles[edges].mean() - self.angle
        return np.array([normal @ off, turn, rod.force[edges].mean(axis=0) @ self.axis / self.scale])

    def rows(self, sensitivities: Sensitivities) -> tuple[IntArray, FloatArray]:
        """All three."""
        rod = sensitivities.rod
        nodes, edges = _middle(rod)
        normal = np.array([-self.axis[1], self.axis[0]])
        weights = np.zeros_like(rod.tangents)
        weights[edges] = np.asarray(self.axis) / len(edges) / self.scale
        return all_rows(
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
    """The middle stands in the centre and carries no moment: one half is the other turned by half a turn."""

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
        return all_rows(np.vstack([sensitivities.position[nodes].mean(axis=0), moment]))


def _middle(rod: MappedRod) -> tuple[Sequence[int], Sequence[int]]:
    """Indices of the nodes and of the edges around the middle of the rod, each one or two."""
    n = rod.tangents.shape[0]
    nodes, edges = {n // 2, (n + 1) // 2}, {(n - 1) // 2, n // 2}
    return sorted(nodes), sorted(edges)


def _lagrange(u: float) -> tuple[list[float], list[float]]:
    """Shares of the nodes 0, 1, 2, 3 in their cubic's value at u, and in its slope."""
    a, b, c, d = u, u - 1, u - 2, u - 3
    share = [-b * c * d / 6, a * c * d / 2, -a * b * d / 2, a * b * c / 6]
    slope = [
        -(b * c + b * d + c * d) / 6, (a * c + a * d + c * d) / 2,
        -(a * b + a * d + b * d) / 2, (a * b + a * c + b * c) / 6,
    ]  # fmt: skip
    return share, slope


def _summed(factors: list[float], values: list[float]) -> float:
    a, b, c, d = factors
    x, y, z, w = values
    return a * x + b * y + c * z + d * w
