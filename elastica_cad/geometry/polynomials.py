"""Polynomials in Bernstein form with all their roots, and piecewise polynomials over panels.

Notation: polynomials (k, n+1) are k rows of Bernstein coefficients of degree n on [0, 1]. A function on N panels
has p = `ORDER` values at nodes, or Legendre coefficients, in each panel. Panel coordinates x are from -1 to 1.
"""

from dataclasses import dataclass
from functools import lru_cache
from math import comb
from typing import TypeAlias

import numpy as np

from elastica_cad._types import BoolArray, FloatArray, IntArray


@lru_cache(maxsize=64)
def binomials(degree: int) -> FloatArray:
    """Return binomial coefficients (degree + 1,): factors from `scaled_bernstein` to Bernstein polynomials."""
    return np.array([comb(degree, i) for i in range(degree + 1)], dtype=float)


_SPLIT = 0.46875
"""Fraction at which an interval is divided, exact in binary.

The fraction is not 0.5, because polynomials of symmetric curves often have zeros at 0.5.
"""


def scaled_bernstein(degree: int, u: FloatArray) -> FloatArray:
    """Return u^i (1 - u)^(degree - i), (n, degree + 1): Bernstein polynomials without binomial factors."""
    powers = np.empty((degree + 1, 2, u.size))
    powers[0] = 1.0
    if degree:
        powers[1, 0] = u
        np.subtract(1.0, u, out=powers[1, 1])
    for k in range(2, degree + 1):
        np.multiply(powers[k - 1], powers[1], out=powers[k])
    return (powers[:, 0] * powers[::-1, 1]).T


def bernstein_values(degree: int, u: FloatArray, derivative: int) -> FloatArray:
    """Return derivatives (n, degree + 1) of the Bernstein polynomials at local coordinates (n,)."""
    if derivative > degree:
        return np.zeros((u.size, degree + 1))
    values = np.ones((1, u.size))
    for _ in range(degree - derivative):
        raised = np.empty((len(values) + 1, u.size))
        raised[0], raised[-1] = values[0] * (1 - u), values[-1] * u
        raised[1:-1] = values[1:] + (values[:-1] - values[1:]) * u
        values = raised
    for k in range(degree - derivative + 1, degree + 1):
        values = k * np.diff(values, axis=0, prepend=0.0, append=0.0) * -1.0
    return np.ascontiguousarray(values.T)


def sums_in_pieces(basis: FloatArray, series: FloatArray, piece: IntArray) -> FloatArray:
    """Return values (n, c) of polynomials with coefficients `series` (p, degree + 1, c), in pieces `piece` (n,).

    `basis` contains the values of `scaled_bernstein` at the local coordinates.
    """
    return np.asarray(np.einsum("nj,njc->nc", basis, series.take(piece, axis=0)))


def product(a: FloatArray, b: FloatArray) -> FloatArray:
    """Return the coefficients (..., m+n+1) of the product of polynomials (..., m+1) and (..., n+1)."""
    m, n = a.shape[-1] - 1, b.shape[-1] - 1
    terms = (a * binomials(m))[..., :, None] * (b * binomials(n))[..., None, :]
    return terms.reshape(*terms.shape[:-2], -1) @ _gathered(m, n) / binomials(m + n)


@lru_cache(maxsize=256)
def _gathered(m: int, n: int) -> FloatArray:
    """Return the matrix that adds the products a_i b_j with i + j = k to coefficient k."""
    i, j = np.indices((m + 1, n + 1)).reshape(2, -1)
    matrix = np.zeros((i.size, m + n + 1))
    matrix[np.arange(i.size), i + j] = 1.0
    return matrix


def raise_degree(c: FloatArray) -> FloatArray:
    """Convert coefficients (..., n+1) of polynomials of degree n to coefficients (..., n+2) of degree n + 1."""
    n = c.shape[-1]
    weight = np.arange(n + 1) / n
    padded = np.concatenate([c[..., :1], c, c[..., -1:]], axis=-1)
    return np.asarray(padded[..., :-1] * weight + padded[..., 1:] * (1 - weight))


def subdivide(c: FloatArray, u: float = 0.5) -> tuple[FloatArray, FloatArray]:
    """Return the coefficients (..., n+1) of polynomials on the parts [0, u] and [u, 1] of their interval."""
    left, right = np.empty(c.shape), np.empty(c.shape)
    for k in range(c.shape[-1]):  # de Casteljau's algorithm
        left[..., k], right[..., -1 - k] = c[..., 0], c[..., -1]
        c = c[..., :-1] * (1 - u) + c[..., 1:] * u
    return left, right


def subdivide_pieces(bezier: FloatArray, u: float = 0.5) -> tuple[FloatArray, FloatArray]:
    """Cut Bezier pieces at u. Return the control points (..., n+1, d) of both parts."""
    left, right = subdivide(bezier.swapaxes(-1, -2), u)
    return left.swapaxes(-1, -2), right.swapaxes(-1, -2)


def value_and_slope(c: FloatArray, u: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return the values and derivatives (k,) of polynomials (k, n+1) at u (k,)."""
    degree = c.shape[-1] - 1
    if degree == 0:
        return c[:, 0].copy(), np.zeros(len(c))
    u = u[:, None]
    for _ in range(degree - 1):
        c = c[:, :-1] + (c[:, 1:] - c[:, :-1]) * u
    step = c[:, 1] - c[:, 0]
    return c[:, 0] + step * u[:, 0], degree * step


def without_end_roots(c: FloatArray, noise: FloatArray, which: BoolArray) -> tuple[FloatArray, BoolArray]:
    """Divide out the zeros of polynomials (k, n+1) at 0 and 1; also return flags (k, 2) of the ends with zeros.

    Values up to `noise` (k,) count as zero. Only polynomials whose flag in `which` (k,) is True are changed.
    """
    c, zero = c.copy(), np.zeros((len(c), 2), dtype=bool)
    ends = np.abs(c[:, [0, -1]]) <= noise[:, None]
    for i in (ends.any(axis=1) & which).nonzero()[0].tolist():
        for side in (0, 1):
            # -side is the index of the first or of the last coefficient
            for _ in range(c.shape[1] - 1):
                if abs(c[i, -side]) > noise[i]:
                    break
                c[i] = divide_out_end_root(c[i], at_end=bool(side))
                zero[i, side] = True
    return c, zero


def divide_out_end_root(c: FloatArray, *, at_end: bool) -> FloatArray:
    """Divide polynomials in u that have a zero at u = 0 by u.

    With `at_end`, divide polynomials that have a zero at u = 1 by 1 - u. The quotient has as many Bernstein
    coefficients (..., n+1) as the polynomial, and the same sign inside (0, 1).
    """
    return c @ _division(c.shape[-1] - 1, at_end) if c.shape[-1] > 1 else c


@lru_cache(maxsize=64)
def _division(n: int, at_end: bool) -> FloatArray:
    # matrix (n + 1, n + 1) of `divide_out_end_root`: rows are the quotients of each Bernstein polynomial
    index = np.arange(n)
    unit = np.eye(n + 1)
    return raise_degree(unit[:, :-1] * n / (n - index) if at_end else unit[:, 1:] * n / (index + 1))


@dataclass(frozen=True)
class Root:
    """Zero of a polynomial strictly inside the interval (0, 1).

    Attributes
    ----------
    piece : int
        Index of the polynomial in an array of polynomials.
    u : float
        Coordinate of the zero in (0, 1).
    crossing : bool
        True if the sign changes, False if the polynomial only touches zero.
    """

    piece: int
    u: float
    crossing: bool


_MOST_HALVINGS = 48
"""Largest number of halvings of an interval, which is then as short as rounding errors.

All zeros in the remaining interval count as one zero.
"""

_GENTLE, _BLUR = 10.0, 4.0
"""Factors that detect a multiple zero. The rounding error, divided by the largest coefficient, is e^3.

A zero may be multiple if its slope, divided by the largest coefficient, is below `_GENTLE` e^2. Rounding moves a
multiple zero by up to `_BLUR` e. A zero of a derivative is then more accurate.
"""

_EPS = float(np.finfo(float).eps)


_Event: TypeAlias = tuple[int, float, float, bool]
"""Index of a polynomial, start and end of an interval, and True if the interval is a single point."""


def roots(c: FloatArray, noise: FloatArray) -> list[Root]:
    """Return all zeros in the open interval (0, 1) of polynomials (k, n+1), in order.

    The number of sign changes of the Bernstein coefficients is an upper bound of the number of zeros
    (Descartes). The interval is divided until each part has at most one zero, or only coefficients below the
    rounding errors `noise` (k,). Zeros that cannot be separated count as one zero. This zero is a crossing if the
    signs before and after it differ, else a touch. The first and last coefficient must exceed the rounding errors
    (see `divide_out_end_root`).
    """
    events = _merged(sorted(_events(c, noise)))
    zeros = []
    # an interval of rounding errors has a multiple root, which is a crossing if the signs on both sides differ
    for k, (piece, a, b, sharp) in enumerate(events):
        if sharp:
            zeros.append(Root(piece, a, True))
            continue
        before = events[k - 1][2] if k and events[k - 1][0] == piece else 0.0
        after = events[k + 1][1] if k + 1 < len(events) and events[k + 1][0] == piece else 1.0
        sides = np.array([(before + a) / 2, (b + after) / 2])
        values, _ = value_and_slope(np.tile(c[piece], (2, 1)), sides)
        crossing = bool(values[0] * values[1] < 0)
        zeros.append(Root(piece, _multiple_root(c[piece], a, b, crossing=crossing), crossing))
    return zeros


def _events(c: FloatArray, noise: FloatArray) -> list[_Event]:
    """Return intervals with one sign change each, and intervals in which all values are rounding errors."""
    piece = np.arange(len(c))
    part, low, width = c, np.zeros(len(c)), np.ones(len(c))
    events: list[_Event] = []
    for depth in range(_MOST_HALVINGS + 1):
        if not piece.size:
            break
        sign = np.where(np.abs(part) > noise[piece, None], np.sign(part), 0.0)
        some = (sign != 0).any(axis=1)
        changes, blurred = _variations(sign)
        single = some & (changes == 1) & (sign[:, 0] * sign[:, -1] < 0)
        none = some & (changes == 0) & ~blurred
        cluster = ~some if depth < _MOST_HALVINGS else ~(single | none)
        # starts and ends inside each part, as fractions of the part
        sharp = _enclosed(part[single], noise[piece[single]])
        for i, start, end in zip(single.nonzero()[0].tolist(), *sharp, strict=True):
            place, length = float(low[i]), float(width[i])
            events.append((int(piece[i]), place + length * start, place + length * end, start == end))
        for i in cluster.nonzero()[0].tolist():
            events.append((int(piece[i]), float(low[i]), float(low[i] + width[i]), False))
        rest = ~(single | none | cluster)
        part, piece = np.concatenate(subdivide(part[rest], _SPLIT)), np.tile(piece[rest], 2)
        low, width = low[rest], width[rest]
        low = np.concatenate([low, low + width * _SPLIT])
        width = np.concatenate([width * _SPLIT, width * (1 - _SPLIT)])
    return events


def interior_roots(c: FloatArray) -> list[Root]:
    """Return zeros of polynomials (k, n+1) in (0, 1), except of polynomials that are zero everywhere."""
    noise = 32 * _EPS * np.abs(c).max(axis=1)
    noise = np.maximum(noise, 1e-15 * np.abs(c).max(initial=0.0))
    c, _ = without_end_roots(c, noise, np.ones(len(c), dtype=bool))
    nonzero = np.flatnonzero(np.abs(c).max(axis=1) > noise)
    return [
        Root(int(nonzero[root.piece]), root.u, root.crossing) for root in roots(c[nonzero], noise[nonzero])
    ]


def _variations(sign: FloatArray) -> tuple[IntArray, BoolArray]:
    """Count the sign changes (k,) in each row, ignoring zeros. Also return flags (k,) of the rows with zeros."""
    blurred = (sign == 0).any(axis=1)
    if blurred.any():
        sign = sign.copy()
        for j in range(1, sign.shape[1]):
            sign[:, j] = np.where(sign[:, j] == 0, sign[:, j - 1], sign[:, j])
    return (sign[:, :-1] * sign[:, 1:] < 0).sum(axis=1), blurred


def _enclosed(c: FloatArray, noise: FloatArray) -> tuple[list[float], list[float]]:
    """Return start and end of an interval around the only sign change of each polynomial.

    The interval is a single point, unless the zero may be a multiple zero.
    """
    largest = np.abs(c).max(axis=1, initial=0.0)
    u, slope = _crossings(c, largest)
    blur = np.cbrt(noise / largest)
    reach = np.where(np.abs(slope) <= _GENTLE * blur**2 * largest, _BLUR * blur, 0.0)
    return np.maximum(u - reach, 0.0).tolist(), np.minimum(u + reach, 1.0).tolist()


def _crossings(c: FloatArray, largest: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return the coordinates (k,) of the only sign change of each polynomial, and the slopes (k,) there."""
    low, high = np.zeros(len(c)), np.ones(len(c))
    u, slope = c[:, 0] / (c[:, 0] - c[:, -1]), np.zeros(len(c))
    rising = c[:, -1] > 0
    with np.errstate(divide="ignore", invalid="ignore"):
        for _ in range(80):
            value, slope = value_and_slope(c, u)
            # True if the zero is before u
            beyond = (value > 0) == rising
            low, high = np.where(beyond, low, u), np.where(beyond, u, high)
            newton = u - value / slope
            following = np.where((newton > low) & (newton < high), newton, (low + high) / 2)
            open_ = (np.abs(value) > _EPS * largest) & (np.abs(following - u) > 4e-16)
            if not open_.any():
                break
            u = np.where(open_, following, u)
    return u, slope


def _merged(events: list[_Event]) -> list[_Event]:
    """Join close intervals of the same polynomial. Two single points are not joined."""
    merged: list[_Event] = []
    for piece, a, b, sharp in events:
        if merged and merged[-1][0] == piece and not (sharp and merged[-1][3]):
            _, a0, b0, _ = merged[-1]
            if a <= b0 + max(b0 - a0, b - a):
                merged[-1] = (piece, a0, max(b, b0), False)
                continue
        merged.append((piece, a, b, sharp))
    return merged


def _multiple_root(c: FloatArray, a: float, b: float, *, crossing: bool) -> float:
    """Return the multiple zero in [a, b]: a zero of the first derivative, or of the second if the sign changes."""
    # differences of Bernstein coefficients are those of the derivative, except for a factor
    derivative = np.diff(c, 2 if crossing and c.size > 2 else 1)
    middle, reach = (a + b) / 2, 2 * (b - a) + 1e-12
    u = middle
    for _ in range(4):
        value, slope = value_and_slope(derivative[None], np.array([u]))
        if slope[0] == 0:
            break
        u = float(np.clip(u - value[0] / slope[0], max(0.0, middle - reach), min(1.0, middle + reach)))
    return u


ORDER = 12  # number of Gauss nodes of a panel

DENSE_PARTS = 24
"""Number of parts of a panel. The ends of the parts are the samples at which bounds are checked first."""

_REACH = 0.15  # largest distance, in the panel coordinate, between a local extreme and its nearest sample
# an extreme is computed if it differs from the largest or smallest sample by less than this fraction of the
# difference between these two samples
_NEAR_SHARE = 0.05

NODES, WEIGHTS = np.polynomial.legendre.leggauss(ORDER)
_DEGREES = np.arange(ORDER)
VANDER: FloatArray = np.asarray(np.polynomial.legendre.legvander(NODES, ORDER - 1), dtype=float)
TO_COEFFICIENTS = (VANDER * WEIGHTS[:, None]).T * (_DEGREES + 0.5)[:, None]


_INTEGRALS = np.polynomial.legendre.legint(np.eye(ORDER), lbnd=-1)
LEFT: FloatArray = np.polynomial.legendre.legvander(NODES, ORDER) @ _INTEGRALS @ TO_COEFFICIENTS
RIGHT = WEIGHTS - LEFT
"""Matrices (p, p) that integrate nodal values: from -1 to each node, and from each node to 1."""

SLOPES: FloatArray = np.zeros((ORDER, ORDER))
SLOPES[:-1] = np.polynomial.legendre.legder(np.eye(ORDER))
"""Matrix that converts Legendre coefficients of a function to Legendre coefficients of the derivative."""


def locate_in_panels(edges: FloatArray, places: FloatArray) -> tuple[IntArray, FloatArray]:
    """Return the indices (n,) of the panels that contain positions (n,), and the panel coordinates (n,)."""
    panel = edges[1:-1].searchsorted(places, side="right")
    start, end = edges[panel], edges[panel + 1]
    return panel, np.minimum(np.maximum((2 * places - start - end) / (end - start), -1.0), 1.0)


@dataclass(frozen=True, eq=False)
class PanelFunction:
    """Function that is a polynomial on each of N panels, with p Legendre coefficients each: (N, p, ...)."""

    coefficients: FloatArray

    @classmethod
    def through(cls, values: FloatArray) -> "PanelFunction":
        """Return the function with given values (N, p, ...) at the nodes."""
        return cls(in_panels(TO_COEFFICIENTS, values))

    def at(self, panel: IntArray, x: FloatArray) -> FloatArray:
        """Return values (n, ...) at coordinates x (n,) in the panels with indices `panel` (n,)."""
        coefficients = self.coefficients[panel].swapaxes(0, 1)
        places = x.reshape(x.size, *[1] * (coefficients.ndim - 2))
        return np.asarray(np.polynomial.legendre.legval(places, coefficients, tensor=False))

    def in_every_panel(self, basis: FloatArray) -> FloatArray:
        """Return values (N, k, ...) at k coordinates of every panel; `basis` is their `legendre_basis`."""
        return in_panels(basis, self.coefficients)

    def slope_at(self, panel: IntArray, x: FloatArray) -> FloatArray:
        """Return derivatives d/dx (n, ...) at coordinates x (n,) in the panels with indices `panel` (n,)."""
        return PanelFunction(in_panels(SLOPES, self.coefficients)).at(panel, x)

    def unresolved(self, tolerance: float) -> BoolArray:
        """Return flags (N,) for panels whose last coefficients exceed `tolerance` times the largest coefficient."""
        size = np.abs(self.coefficients).reshape(*self.coefficients.shape[:2], -1).max(axis=2, initial=0.0)
        return np.asarray(size[:, -2:].max(axis=1) > tolerance * size.max(axis=1))

    @property
    def nodal(self) -> FloatArray:
        """Values (N, p, ...) at the nodes of the panels."""
        return in_panels(VANDER, self.coefficients)

    @property
    def where_panels_meet(self) -> tuple[FloatArray, FloatArray]:
        """Values (N - 1, ...) just before and just after the edges between panels."""
        at_ends = self.in_every_panel(_ENDS_BASIS)
        return at_ends[:-1, 1], at_ends[1:, 0]

    @property
    def dense(self) -> FloatArray:
        """Values (n, ...) at the sample points `Panels.dense_places`."""
        return np.concatenate(self.in_every_panel(_DENSE_BASIS))

    @property
    def extremes(self) -> FloatArray:
        """Values at the local extremes near the largest and smallest value, and at the samples next to them."""
        return self.at(*self.extreme_places)

    @property
    def extreme_places(self) -> tuple[IntArray, FloatArray]:
        """Panels and panel coordinates of the values in `extremes`."""
        panel, sample, x = self.found_extremes
        return np.concatenate([panel, panel]), np.concatenate([_DENSE[sample], x])

    @property
    def found_extremes(self) -> tuple[IntArray, IntArray, FloatArray]:
        """Panels, nearest samples and coordinates x, (n,) each, of extremes near the largest or smallest value."""
        table = self.in_every_panel(_DENSE_BASIS)
        extreme = np.zeros_like(table, dtype=bool)
        middle, before, after = table[:, 1:-1], table[:, :-2], table[:, 2:]
        extreme[:, 1:-1] = ((middle >= before) & (middle >= after)) | ((middle <= before) & (middle <= after))
        low, high = table.min(), table.max()
        band = _NEAR_SHARE * (high - low)
        near = extreme & ((table > high - band) | (table < low + band))
        # add the largest and the smallest sample, which may be at the end of a panel
        near.flat[[table.argmin(), table.argmax()]] = True
        panel, sample = near.nonzero()
        coefficients, start = self.coefficients[panel], _DENSE[sample]
        x, slopes = start, _DENSE_SLOPES[sample]
        lower, upper = np.maximum(start - _REACH, -1.0), np.minimum(start + _REACH, 1.0)
        # each step of Halley's method reduces the error to about its third power
        for step in range(2):
            if step:
                slopes = (legendre_basis(x) @ _ALL_SLOPES).reshape(-1, 3, ORDER)
            first, second, third = (slopes @ coefficients[:, :, None])[:, :, 0].T
            # find a zero of the first derivative by Halley's method, which also needs the third derivative
            bend = 2 * second * second - first * third
            step_by = np.divide(-2 * first * second, bend, out=np.zeros_like(x), where=bend != 0)
            x = np.minimum(np.maximum(x + step_by, lower), upper)
        return panel, sample, x

    def combined(self, numbers: FloatArray) -> "PanelFunction":
        """Return the sum of the functions on the last axis, weighted by `numbers`."""
        return PanelFunction(self.coefficients @ numbers)


def legendre_basis(x: FloatArray) -> FloatArray:
    """Return values (n, p) of the Legendre polynomials at x (n,)."""
    return np.asarray(np.polynomial.legendre.legvander(x, ORDER - 1), dtype=float)


def in_panels(matrix: FloatArray, values: FloatArray) -> FloatArray:
    """Return products (N, k, ...) of a matrix (k, p) with values or coefficients (N, p, ...) of each panel."""
    if values.ndim == 2:
        return values @ matrix.T
    flat = matrix @ values.reshape(*values.shape[:2], -1)
    return flat.reshape(len(values), len(matrix), *values.shape[2:])


def lobatto_places(parts: int) -> FloatArray:
    """Return coordinates (parts + 1,) from -1 to 1 that are denser towards the ends."""
    return np.concatenate([[-1.0], np.cos(np.pi * (np.arange(1, parts)[::-1] / parts)), [1.0]])


_DENSE = lobatto_places(DENSE_PARTS)
_DENSE_BASIS = legendre_basis(_DENSE)
_ENDS_BASIS = legendre_basis(np.array([-1.0, 1.0]))
# the matrices of the first, second and third derivative side by side, (p, 3 p); at the samples as (n, 3, p)
_ALL_SLOPES = np.concatenate([np.linalg.matrix_power(SLOPES, k) for k in (1, 2, 3)], axis=1)
_DENSE_SLOPES = (_DENSE_BASIS @ _ALL_SLOPES).reshape(-1, 3, ORDER)


@lru_cache(maxsize=64)
def gauss_rule(count: int) -> tuple[FloatArray, FloatArray]:
    """Return the nodes and weights (count,) of the Gauss rule over [-1, 1] as read-only arrays."""
    places, weights = np.polynomial.legendre.leggauss(count)
    places.setflags(write=False)
    weights.setflags(write=False)
    return places, weights
