"""How far a rod is from the target curve: three measures and their local models for the optimiser."""

from dataclasses import dataclass
from functools import cached_property
from typing import Protocol

import numpy as np

from elastica_cad._compiled_scipy import lapack
from elastica_cad._native import kernels
from elastica_cad._types import FloatArray, IntArray
from elastica_cad.forming.nearest.constraints.constraint import thin_rows
from elastica_cad.forming.nearest.rod_map import MappedRod, Sensitivities
from elastica_cad.forming.nearest.target_curve import TargetCurve, even_steps, hermite
from elastica_cad.forming.optimizer.nonlinear_program import LocalModel

_MOST_EXACT = 8  # points whose distance is computed from all chords before a search tree is cheaper


class Distance(Protocol):
    """A measure: its value, and a convex model of it around a rod."""

    def value(self, rod: MappedRod) -> float:
        """The number to be minimised, in lengths of the target or their squares."""

    def model(self, rod: MappedRod, sensitivities: Sensitivities) -> LocalModel:
        """Gauss-Newton model in the steps of the unknowns; the derivatives come with their closing column."""


@dataclass(frozen=True, eq=False)
class MeanDistance:
    """Half the weighted mean square distance, arc length against arc length.

    Attributes
    ----------
    targets : (n+1, 2) array
        Where each node should lie.
    shares : (n+1,) array
        Weights, sum 1.
    """

    targets: FloatArray
    shares: FloatArray

    def value(self, rod: MappedRod) -> float:
        """Half the mean square distance."""
        found: float = rod.remembered(self, lambda: self._value(rod.position))
        return found

    def _value(self, position: FloatArray) -> float:
        off = position - self.targets
        return 0.5 * float(self.shares @ (off**2).sum(axis=1))

    def model(self, rod: MappedRod, sensitivities: Sensitivities) -> LocalModel:
        """Gauss-Newton: J^T W J and J^T W r."""
        J = sensitivities.position.reshape(-1, sensitivities.position.shape[2])
        return _least_squares(J, (rod.position - self.targets).ravel(), self._shares_of_coordinates)

    @cached_property
    def _shares_of_coordinates(self) -> FloatArray:
        return np.repeat(self.shares, 2)


@dataclass(frozen=True, eq=False)
class ClosestDistance:
    """Half the weighted mean square distance of the nodes from their nearest points on the target.

    Attributes
    ----------
    target : TargetCurve
    shares : (n+1,) array
        Weights, sum 1.
    """

    target: TargetCurve
    shares: FloatArray

    def value(self, rod: MappedRod) -> float:
        """Half the mean square distance."""
        off, _ = offsets(self.target, rod)
        return 0.5 * float(self.shares @ (off**2).sum(axis=1))

    def model(self, rod: MappedRod, sensitivities: Sensitivities) -> LocalModel:
        """Gauss-Newton across the target; along it a node slides freely."""
        off, normal = offsets(self.target, rod)
        return _least_squares(_across(normal, sensitivities), (off * normal).sum(axis=1), self.shares)


@dataclass(frozen=True, eq=False)
class LargestDistance:
    """The largest weighted distance of a node from its nearest point on the target.

    Attributes
    ----------
    target : TargetCurve
    factors : (n+1,) array
        Weights, largest 1.
    """

    target: TargetCurve
    factors: FloatArray

    def value(self, rod: MappedRod) -> float:
        """The largest distance."""
        off, _ = offsets(self.target, rod)
        return float((self.factors * np.hypot(off[:, 0], off[:, 1])).max())

    def model(self, rod: MappedRod, sensitivities: Sensitivities) -> LocalModel:
        """Every node that is at least half as far off as the worst is a peak."""
        _, normal = offsets(self.target, rod)
        signed, far = self._peaks(rod)
        p = rod.z.size
        across = _across(normal, sensitivities)
        slopes = self.factors[far, None] * across[far]
        at = signed[far] + slopes[:, p]  # a node near the target may change sides
        rows = np.sign(at)[:, None] * slopes[:, :p]
        # the mean-square curvature only decides what the peaks leave open
        return LocalModel(
            0.0, 1e-3 / signed.size * across[:, :p].T @ across[:, :p], np.zeros(p), np.abs(at), rows
        )

    def _peaks(self, rod: MappedRod) -> tuple[FloatArray, IntArray]:
        """Signed distances (n+1,) and the nodes that count."""
        off, normal = offsets(self.target, rod)
        signed = self.factors * (off * normal).sum(axis=1)
        size = np.abs(signed)
        return signed, thin_rows(np.flatnonzero(size >= 0.5 * size.max()), size)


def offsets(target: TargetCurve, rod: MappedRod) -> tuple[FloatArray, FloatArray]:
    """Offsets (n+1, 2) of the nodes from their feet on the target, and unit normals there.

    Past an end the normal points along the offset.
    """
    found: tuple[FloatArray, FloatArray] = rod.remembered(target, lambda: _offsets(target, rod))
    return found


def _offsets(target: TargetCurve, rod: MappedRod) -> tuple[FloatArray, FloatArray]:
    n = rod.position.shape[0] - 1
    feet = target.feet(rod.position, even_steps(n + 1))
    position, direction = target.at(feet)
    off = rod.position - position
    normal = np.column_stack([-direction[:, 1], direction[:, 0]])
    normal /= np.hypot(normal[:, 0], normal[:, 1])[:, None]
    size = np.hypot(off[:, 0], off[:, 1])
    past = ((feet <= 0) | (feet >= 1)) & (size > 0)
    normal[past] = off[past] / size[past, None]
    return off, normal


def _across(normal: FloatArray, sensitivities: Sensitivities) -> FloatArray:
    """Derivatives (n+1, p) of the nodes' displacements along `normal`."""
    d = sensitivities.position
    return np.asarray(normal[:, 0, None] * d[:, 0] + normal[:, 1, None] * d[:, 1])


def _least_squares(J: FloatArray, r: FloatArray, shares: FloatArray) -> LocalModel:
    """Model of half the mean square of r + J d, weighted by `shares` (k,); the closing column of J belongs to r."""
    p = J.shape[1] - 1
    A = J.copy()
    A[:, -1] += r
    product = (A * shares[:, None]).T @ A
    return LocalModel(
        0.5 * float(product[p, p]), product[:p, :p], product[:p, p], np.zeros(0), np.zeros((0, p))
    )


def measure_deviation(target: TargetCurve, nodes: FloatArray) -> float:
    """Largest distance between the curve and the smooth curve through `nodes` (n, 2), in lengths, either way."""
    other = _through(nodes, target.position.shape[0])
    return max(_largest_distance(target.position, other), _largest_distance(other, target.position))


def _through(nodes: FloatArray, count: int) -> FloatArray:
    """Points (count, 2) at equal steps along the cubic spline through `nodes` (n, 2).

    It has no knots next to its ends.
    """
    n = nodes.shape[0]
    right = np.empty_like(nodes)
    right[1:-1] = 3 * (nodes[2:] - nodes[:-2])
    steps = nodes[[1, 2, -2, -1]] - nodes[[0, 1, -3, -2]]
    right[0], right[-1] = (5 * steps[0] + steps[1]) / 2, (5 * steps[3] + steps[2]) / 2
    diagonal, above = np.full(n, 4.0), np.ones(n - 1)
    diagonal[[0, -1]] = 1.0
    above[0] = 2.0
    *_, slopes, _ = lapack().dgtsv(above[::-1], diagonal, above, right)
    return hermite(nodes, slopes, even_steps(count))[0]


def _largest_distance(points: FloatArray, chain: FloatArray) -> float:
    """The largest distance of `points` from the nearest chord of a fine chain of points.

    Where the chain runs beside them, distances from chords near by are upper bounds, and the largest is exact if
    no chord at all is nearer.
    """
    if kernels is not None:
        return kernels.largest_distance(
            np.ascontiguousarray(points), np.ascontiguousarray(chain), np.empty(len(points))
        )
    last = chain.shape[0] - 2
    chords = np.diff(chain, axis=0)
    squares = np.maximum((chords**2).sum(axis=1), 1e-300)
    k = np.minimum(np.arange(points.shape[0]), last)
    for _ in range(3):
        ahead = ((points - chain[k]) * chords[k]).sum(axis=1) / squares[k]
        k = np.clip(k + np.floor(ahead).astype(int), 0, last)

    def beside(points: FloatArray, k: IntArray | slice) -> FloatArray:
        off, chord = points - chain[:-1][k], chords[k]
        off = off - np.clip((off * chord).sum(axis=1) / squares[k], 0, 1)[:, None] * chord
        return np.asarray(np.hypot(off[:, 0], off[:, 1]))

    bounds = beside(points, k)
    for _ in range(_MOST_EXACT):
        farthest = int(np.argmax(bounds))
        exact = float(beside(points[farthest], slice(None)).min())
        if exact >= bounds[farthest] * (1 - 1e-12):
            return exact
        bounds[farthest] = exact
    from scipy.spatial import cKDTree

    _, nearest = cKDTree(chain).query(points)
    for k in (np.maximum(nearest - 1, 0), np.minimum(nearest, last)):
        bounds = np.minimum(bounds, beside(points, k))
    return float(bounds.max())
