"""The functions of which the stiffness along a rod is a sum: cubic B-splines, in mirrored pairs where asked."""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.geometry.polynomials.splines import bezier_spans


@dataclass(frozen=True)
class StiffnessBasis:
    """`count` cubic B-splines with uniform clamped knots over 0..1.

    Attributes
    ----------
    count : int
    mirrored : bool
        Each function and its mirror image share one coefficient.
    """

    count: int
    mirrored: bool = False

    @property
    def knots(self) -> FloatArray:
        """Of the splines, clamped."""
        return np.concatenate([np.zeros(3), np.linspace(0, 1, self.count - 2), np.ones(3)])

    def at(self, s: FloatArray) -> FloatArray:
        """Values of the functions, or of their pairs, at s (n,) in 0..1."""
        return self._paired(spline_basis(s, self.count))

    def at_nodes(self, nodes: int) -> FloatArray:
        """Values at so many places at equal distances, both ends included."""
        return self._paired(_nodal_basis(nodes, self.count))

    def coefficients(self, z: FloatArray) -> FloatArray:
        """The coefficient (count,) of every function, from unknowns that begin with those that are free."""
        m = self.count
        if not self.mirrored:
            return z[:m].copy()
        half = (m + 1) // 2
        return np.concatenate([z[:half], z[: m // 2][::-1]])

    def _paired(self, basis: FloatArray) -> FloatArray:
        if not self.mirrored:
            return basis
        half = (self.count + 1) // 2
        mirror = basis[:, ::-1][:, :half].copy()
        if self.count % 2:
            mirror[:, -1] = 0
        return np.asarray(basis[:, :half] + mirror)


def spline_basis(x: FloatArray, count: int) -> FloatArray:
    """Values (n, count) of the cubic B-splines with uniform clamped knots at x (n,) in 0..1."""
    return bezier_spans(StiffnessBasis(count).knots, 3).basis(np.clip(x, 0, 1))


@lru_cache(maxsize=16)
def _nodal_basis(nodes: int, count: int) -> FloatArray:
    basis = spline_basis(np.linspace(0, 1, nodes), count)
    basis.flags.writeable = False
    return basis
