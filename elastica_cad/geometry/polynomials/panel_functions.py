"""Piecewise polynomials over panels: their values at Gauss nodes, their Legendre series, integrals and extremes."""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from elastica_cad._types import BoolArray, FloatArray, IntArray

ORDER = 12  # Gauss nodes of a panel

DENSE_PARTS = 24
"""Number of parts of each panel at whose ends bounds are checked first."""

EXTREME_STEPS = 2
"""Steps of Halley's method from the nearest of those places to an extreme; two raise the error to the ninth
power."""

_REACH = 0.15  # from a place to the extreme that it lies next to
_NEAR_SHARE = (
    0.05  # of all that a function spans: extremes this near to its largest or least value are looked for
)

NODES, WEIGHTS = np.polynomial.legendre.leggauss(ORDER)
_DEGREES = np.arange(ORDER)
VANDER: FloatArray = np.asarray(np.polynomial.legendre.legvander(NODES, ORDER - 1), dtype=float)
TO_COEFFICIENTS = (VANDER * WEIGHTS[:, None]).T * (_DEGREES + 0.5)[:, None]


def _antiderivatives() -> tuple[FloatArray, FloatArray]:
    """Matrices (p, p) that integrate nodal values from -1 to each node, and from each node to 1."""
    longer = np.polynomial.legendre.legvander(NODES, ORDER)
    primitive = np.empty((ORDER, ORDER))
    primitive[:, 0] = NODES + 1
    for n in range(1, ORDER):
        primitive[:, n] = (longer[:, n + 1] - longer[:, n - 1]) / (2 * n + 1)
    left = primitive @ TO_COEFFICIENTS
    return left, WEIGHTS - left


LEFT, RIGHT = _antiderivatives()
SLOPES: FloatArray = np.zeros((ORDER, ORDER))
SLOPES[:-1] = np.polynomial.legendre.legder(np.eye(ORDER))
"""Legendre coefficients of the derivative from those of a function."""


def locate_in_panels(edges: FloatArray, places: FloatArray) -> tuple[IntArray, FloatArray]:
    """Between which edges (N + 1,) places (n,) lie, and where there, from -1 to 1."""
    panel = np.searchsorted(edges[1:-1], places, side="right")
    start, end = edges[panel], edges[panel + 1]
    return panel, np.minimum(np.maximum((2 * places - start - end) / (end - start), -1.0), 1.0)


@dataclass(frozen=True, eq=False)
class PanelFunction:
    """A piecewise polynomial: Legendre coefficients (N, p, ...) over the panels."""

    coefficients: FloatArray

    @classmethod
    def through(cls, values: FloatArray) -> "PanelFunction":
        """The interpolant of nodal values (N, p, ...)."""
        return cls(in_panels(TO_COEFFICIENTS, values))

    def at(self, panel: IntArray, x: FloatArray) -> FloatArray:
        """Values (n, ...) at places x (n,) of panels (n,)."""
        own = self.coefficients[panel].swapaxes(0, 1)
        places = x.reshape(x.size, *[1] * (own.ndim - 2))
        return np.asarray(np.polynomial.legendre.legval(places, own, tensor=False))

    def in_every_panel(self, basis: FloatArray) -> FloatArray:
        """Values (N, k, ...) at the same places of every panel, from their `legendre_basis` (k, p)."""
        return in_panels(basis, self.coefficients)

    def slope_at(self, panel: IntArray, x: FloatArray) -> FloatArray:
        """Derivatives by x (n, ...)."""
        return PanelFunction(in_panels(SLOPES, self.coefficients)).at(panel, x)

    def unresolved(self, tolerance: float) -> BoolArray:
        """Panels (N,) whose last coefficients exceed `tolerance` times the largest one."""
        size = np.abs(self.coefficients)
        return np.asarray(size[:, -2:].max(axis=1) > tolerance * size.max(axis=1))

    @property
    def nodal(self) -> FloatArray:
        """Values (N, p, ...) at the nodes of the panels."""
        return in_panels(VANDER, self.coefficients)

    @property
    def where_panels_meet(self) -> tuple[FloatArray, FloatArray]:
        """Values (N - 1, ...) before and after the places where panels meet."""
        at_ends = self.in_every_panel(_ENDS_BASIS)
        return at_ends[:-1, 1], at_ends[1:, 0]

    @property
    def dense(self) -> FloatArray:
        """Values (n, ...) at `Panels.dense_places`."""
        values = self.in_every_panel(_DENSE_BASIS)
        return values.reshape(values.shape[0] * values.shape[1], *values.shape[2:])

    @property
    def extremes(self) -> FloatArray:
        """Values at the local extremes near the largest and least one, and at the samples beside them."""
        return self.at(*self.extreme_places)

    @property
    def extreme_places(self) -> tuple[IntArray, FloatArray]:
        """Panels and places x of those samples and extremes."""
        panel, sample, x = self.found_extremes
        return np.concatenate([panel, panel]), np.concatenate([_DENSE[sample], x])

    @property
    def found_extremes(self) -> tuple[IntArray, IntArray, FloatArray]:
        """Panels (n,) of the local extremes near the largest and least value, the samples of `dense_places` in
        them (n,) that each was found from, and the places x (n,), by Halley's method.
        """
        table = self.in_every_panel(_DENSE_BASIS)
        extreme = np.zeros_like(table, dtype=bool)
        middle, before, after = table[:, 1:-1], table[:, :-2], table[:, 2:]
        extreme[:, 1:-1] = ((middle >= before) & (middle >= after)) | ((middle <= before) & (middle <= after))
        low, high = table.min(), table.max()
        band = _NEAR_SHARE * (high - low)
        near = extreme & ((table > high - band) | (table < low + band))
        # the worst samples stay in, ends of panels among them
        near.flat[[table.argmin(), table.argmax()]] = True
        panel, sample = near.nonzero()
        own, start = self.coefficients[panel], _DENSE[sample]
        x, slopes = start, _DENSE_SLOPES[sample]
        lower, upper = np.maximum(start - _REACH, -1.0), np.minimum(start + _REACH, 1.0)
        for step in range(EXTREME_STEPS):
            if step:
                slopes = (legendre_basis(x) @ _ALL_SLOPES).reshape(-1, 3, ORDER)
            first, second, third = (slopes @ own[:, :, None])[:, :, 0].T
            # Halley's step: Newton's, with the third derivative taken in
            bend = 2 * second * second - first * third
            step_by = np.divide(-2 * first * second, bend, out=np.zeros_like(x), where=bend != 0)
            x = np.minimum(np.maximum(x + step_by, lower), upper)
        return panel, sample, x

    def combined(self, numbers: FloatArray) -> "PanelFunction":
        """The last axis contracted with `numbers`."""
        return PanelFunction(self.coefficients @ numbers)


def legendre_basis(x: FloatArray) -> FloatArray:
    """Values (n, p) of the Legendre polynomials at x (n,)."""
    return np.asarray(np.polynomial.legendre.legvander(x, ORDER - 1), dtype=float)


def in_panels(matrix: FloatArray, values: FloatArray) -> FloatArray:
    """A matrix (k, p) applied to the p nodal values or coefficients (N, p, ...) of every panel: (N, k, ...)."""
    if values.ndim == 2:
        return np.asarray(values @ matrix.T)
    flat = matrix @ values.reshape(*values.shape[:2], -1)
    return np.asarray(flat.reshape(len(values), len(matrix), *values.shape[2:]))


def lobatto_places(parts: int) -> FloatArray:
    """Places (parts + 1,) from -1 to 1, closer towards the ends."""
    inner = np.cos(np.pi * (np.arange(1, parts)[::-1] / parts))
    return np.concatenate([[-1.0], inner, [1.0]])


_DENSE = lobatto_places(DENSE_PARTS)
_DENSE_BASIS = legendre_basis(_DENSE)
_ENDS_BASIS = legendre_basis(np.array([-1.0, 1.0]))
_ALL_SLOPES = np.concatenate([np.linalg.matrix_power(SLOPES, k) for k in (1, 2, 3)], axis=1)
_DENSE_SLOPES = (_DENSE_BASIS @ _ALL_SLOPES).reshape(-1, 3, ORDER)
"""First, second and third derivatives by x, of every Legendre polynomial."""


@lru_cache(maxsize=64)
def gauss_rule(count: int) -> tuple[FloatArray, FloatArray]:
    """Places and weights (count,) of the Gauss rule over [-1, 1], read-only."""
    places, weights = np.polynomial.legendre.leggauss(count)
    places.setflags(write=False)
    weights.setflags(write=False)
    return places, weights
