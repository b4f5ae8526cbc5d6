"""How far a rod is from the wish: three measures and their local models for the solver."""

from dataclasses import dataclass
from typing import Protocol

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.forming.constraints import thinned
from elastica_cad.forming.dense import gram
from elastica_cad.forming.march import MarchedRod, Sensitivities
from elastica_cad.forming.wish import Wish

__all__ = ["ClosestDistance", "Distance", "LargestDistance", "LocalModel", "MeanDistance"]


@dataclass(frozen=True, eq=False)
class LocalModel:
    """value + h^T d + d^T H d / 2, plus the largest of peaks + peak_rows d where there are peaks.

    Attributes
    ----------
    value : float
    hessian, gradient : (p, p), (p,) arrays
    peaks, peak_rows : (k,), (k, p) arrays
        Empty for smooth measures.
    """

    value: float
    hessian: FloatArray
    gradient: FloatArray
    peaks: FloatArray
    peak_rows: FloatArray

    def at(self, step: FloatArray) -> float:
        """The distance that the model expects after a step (p,)."""
        smooth = self.value + float((self.gradient + 0.5 * (self.hessian @ step)) @ step)
        return smooth + (float((self.peaks + self.peak_rows @ step).max()) if self.peaks.size else 0.0)


class Distance(Protocol):
    """A measure: its value, and a convex model of it around a rod."""

    def value(self, rod: MarchedRod) -> float:
        """The number to be minimised, in lengths of the wish or their squares."""

    def model(self, rod: MarchedRod, sensitivities: Sensitivities) -> LocalModel:
        """Gauss-Newton model in the steps of the unknowns."""


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

    def value(self, rod: MarchedRod) -> float:
        """Half the mean square distance."""
        off = rod.position - self.targets
        return 0.5 * float(self.shares @ (off**2).sum(axis=1))

    def model(self, rod: MarchedRod, sensitivities: Sensitivities) -> LocalModel:
        """Gauss-Newton: J^T W J and J^T W r."""
        root = np.sqrt(self.shares)
        columns = sensitivities.position.shape[2]
        J = (sensitivities.position * root[:, None, None]).reshape(-1, columns)
        r = ((rod.position - self.targets) * root[:, None]).ravel()
        return _least_squares(J, r, rod.z.size)


@dataclass(frozen=True, eq=False)
class ClosestDistance:
    """Half the weighted mean square distance of the nodes from their nearest points on the wish.

    Attributes
    ----------
    wish : Wish
    shares : (n+1,) array
        Weights, sum 1.
    """

    wish: Wish
    shares: FloatArray

    def value(self, rod: MarchedRod) -> float:
        """Half the mean square distance."""
        off, _ = offsets(self.wish, rod)
        return 0.5 * float(self.shares @ (off**2).sum(axis=1))

    def model(self, rod: MarchedRod, sensitivities: Sensitivities) -> LocalModel:
        """Gauss-Newton across the wish; along it a node slides freely."""
        off, normal = offsets(self.wish, rod)
        root = np.sqrt(self.shares)
        J = _across(normal, sensitivities) * root[:, None]
        return _least_squares(J, (off * normal).sum(axis=1) * root, rod.z.size)


@dataclass(frozen=True, eq=False)
class LargestDistance:
    """The largest weighted distance of a node from its nearest point on the wish.

    Attributes
    ----------
    wish : Wish
    factors : (n+1,) array
        Weights, largest 1.
    """

    wish: Wish
    factors: FloatArray

    def value(self, rod: MarchedRod) -> float:
        """The largest distance."""
        off, _ = offsets(self.wish, rod)
        return float((self.factors * np.hypot(off[:, 0], off[:, 1])).max())

    def model(self, rod: MarchedRod, sensitivities: Sensitivities) -> LocalModel:
        """Every node that is at least half as far off as the worst is a peak."""
        _, normal = offsets(self.wish, rod)
        signed, far = self._peaks(rod)
        p = rod.z.size
        across = _across(normal, sensitivities)
        rows = (self.factors * np.sign(signed))[far, None] * across[far]
        peaks = np.abs(signed[far])
        if rows.shape[1] > p:
            peaks = peaks + rows[:, p]
        # the mean-square curvature only decides what the peaks leave open
        return LocalModel(0.0, 1e-3 / signed.size * gram(across[:, :p]), np.zeros(p), peaks, rows[:, :p])

    def _peaks(self, rod: MarchedRod) -> tuple[FloatArray, IntArray]:
        """Signed distances (n+1,) and the nodes that count."""
        off, normal = offsets(self.wish, rod)
        signed = self.factors * (off * normal).sum(axis=1)
        size = np.abs(signed)
        return signed, thinned(np.flatnonzero(size >= 0.5 * size.max()), size)


def offsets(wish: Wish, rod: MarchedRod) -> tuple[FloatArray, FloatArray]:
    """Offsets (n+1, 2) of the nodes from their feet on the wish, and unit normals there (past an end: along it)."""
    found: tuple[FloatArray, FloatArray] = rod.remembered("offsets", lambda: _offsets(wish, rod))
    return found


def _offsets(wish: Wish, rod: MarchedRod) -> tuple[FloatArray, FloatArray]:
    n = rod.position.shape[0] - 1
    feet = wish.feet(rod.position, np.linspace(0, 1, n + 1))
    position, direction = wish.at(feet)
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


def _least_squares(J: FloatArray, r: FloatArray, p: int) -> LocalModel:
    """Model of |r + J d|^2 / 2; a closing column of J belongs to r."""
    if J.shape[1] > p:
        r = r + J[:, p]
    joined = np.empty((J.shape[0], p + 1))
    joined[:, :p], joined[:, p] = J[:, :p], r
    product = gram(joined)
    return LocalModel(
        0.5 * float(product[p, p]), product[:p, :p], product[:p, p], np.zeros(0), np.zeros((0, p))
    )
