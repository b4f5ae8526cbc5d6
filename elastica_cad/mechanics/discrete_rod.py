"""The discrete rod of section 7.1: its equations, energy and second variation, and banded linear algebra."""

from dataclasses import dataclass, field
from functools import cached_property, lru_cache
from math import cos, nan, sin
from typing import NamedTuple, TypeAlias

import numpy as np

from elastica_cad import _native
from elastica_cad._compiled_scipy import lapack
from elastica_cad._types import FloatArray
from elastica_cad.errors import NotConvergedError
from elastica_cad.mechanics.bracing import Bracing
from elastica_cad.mechanics.loads import Supports

RANK_TOLERANCE = 1e-9
"""Relative tolerance for dependent rows; a straight rod has rank 1."""

_FEW = 40
"""Least number of edges for an iterative search of a mode; shorter rods use dense algebra."""

_SMOOTH = 10
"""Number of polynomials in the compiled code's first search for the lowest mode."""

_EPS = float(np.finfo(float).eps)


def solve_tridiagonal(diagonal: FloatArray, off: FloatArray, right: FloatArray) -> FloatArray:
    """Solve the symmetric tridiagonal system with pivoting; `right` is (n,) or (n, k)."""
    if diagonal.size == 1:
        return np.asarray(right / diagonal[0])
    solution, info = lapack().dgtsv(off, diagonal, off, right)[-2:]
    if info != 0:
        nudge = np.spacing(np.abs(diagonal).max())
        solution, info = lapack().dgtsv(off, diagonal + nudge, off, right)[-2:]
    if info != 0:
        raise NotConvergedError("the rod's stiffness matrix is singular: its shape is not isolated")
    return np.asarray(solution)


def solve_bordered(
    diagonal: FloatArray,
    off: FloatArray,
    rows: FloatArray,
    *,
    right: FloatArray,
    below: FloatArray,
    columns: FloatArray | None = None,
    corner: FloatArray | float = 0.0,
) -> tuple[FloatArray, FloatArray]:
    """Solve [[A, columns], [rows, corner]] (x, y) = (right, below) with A symmetric tridiagonal.

    Parameters
    ----------
    rows : (k, n) array
    right : (n,) array
    below : (k,) array
    columns : (n, k) array, optional
        Columns; by default the transposed rows.
    corner : (k, k) array, optional

    Returns
    -------
    x : (n,) array
    y : (k,) array
        Dependent rows are solved in the least-squares sense with the least y.
    """
    k = below.size
    if k == 0:
        return solve_tridiagonal(diagonal, off, right), np.zeros(0)
    both = np.empty((right.size, k + 1), order="F")
    both[:, 0] = right
    both[:, 1:] = rows.T if columns is None else columns
    solved = solve_tridiagonal(diagonal, off, both).T
    products = rows @ solved.T
    y = np.linalg.lstsq(products[:, 1:] - corner, products[:, 0] - below, rcond=1e-14)[0]
    return solved[0] - y @ solved[1:], np.asarray(y)


def orthonormal_rows(rows: FloatArray) -> FloatArray:
    """Return an orthonormal basis (r, n) of the span of `rows` (k, n) of rank r."""
    basis: list[FloatArray] = []
    for row in rows:
        size = float(np.linalg.norm(row))
        if size == 0:
            continue
        rest = row / size
        for _ in range(2):
            for q in basis:
                rest = rest - q.dot(rest) * q
        left = float(np.linalg.norm(rest))
        if left > RANK_TOLERANCE:
            basis.append(rest / left)
    return np.array(basis).reshape(len(basis), rows.shape[1])


def count_negative(diagonal: FloatArray, off: FloatArray, shift: float = 0.0) -> int:
    """Count the eigenvalues at or below `shift` of the symmetric tridiagonal matrix (Sturm count)."""
    if diagonal.size == 1:
        return int(diagonal[0] <= shift)
    reach = _reach(diagonal, off)
    if shift < -reach:
        return 0
    count, _, _, _, info = lapack().dstebz(
        diagonal, off, 1, -2 * reach - 1, shift, 1, 1, 8 * reach + 8 + abs(shift), b"E"
    )
    if info != 0:
        raise NotConvergedError("the Sturm count of the rod's second variation failed: its entries overflow")
    return int(count)


Terms: TypeAlias = tuple[FloatArray, FloatArray]
"""Linear forms G (r, n) and symmetric, invertible coefficients C (r, r); the term G^t C G is added to a matrix."""


def _bordered(basis: FloatArray, terms: Terms | None) -> tuple[FloatArray, FloatArray]:
    """Return the border (k + r, n) of a matrix and its corner: 0 for constraints, -C^-1 for terms."""
    k = len(basis)
    if terms is None:
        return basis, np.zeros((k, k))
    forms, coefficients = terms
    corner = np.zeros((k + len(forms), k + len(forms)))
    corner[k:, k:] = -np.linalg.inv(coefficients)
    return np.concatenate([basis, forms]), corner


def constrained_inertia(
    diagonal: FloatArray, off: FloatArray, rows: FloatArray, shift: float = 0.0, terms: Terms | None = None
) -> int:
    """Count the eigenvalues below `shift` of the tridiagonal matrix A on the null space of `rows` (k, n).

    Sylvester's law on the bordered matrix: neg = neg(A - shift) + pos(S) - rank, S = C (A - shift)^-1 C^t. Terms
    that are added to A are more rows of the border, with minus their inverse coefficients in the corner.
    """
    constraints = orthonormal_rows(rows)
    basis, corner = _bordered(constraints, terms)
    if basis.shape[0] == 0:
        return count_negative(diagonal, off, shift)
    solved = solve_tridiagonal(diagonal - shift, off, basis.T).T
    reach = _reach(diagonal, off)
    if not np.abs(solved).max() * 16 * _EPS * reach < 1:
        # the matrix of an unbent rod between hinges is singular; this shift makes the count agree with the solution
        shift -= 64 * _EPS * reach
        solved = solve_tridiagonal(diagonal - shift, off, basis.T).T
    negative = count_negative(diagonal, off, shift)
    schur = basis @ solved.T - corner
    positive = int(np.count_nonzero(np.linalg.eigvalsh((schur + schur.T) / 2) > 0))
    of_terms = 0 if terms is None else int(np.count_nonzero(np.linalg.eigvalsh(terms[1]) > 0))
    return negative + positive - len(constraints) - of_terms


def lowest_constrained(
    diagonal: FloatArray, off: FloatArray, rows: FloatArray, count: int = 1, terms: Terms | None = None
) -> tuple[FloatArray, FloatArray]:
    """Return the lowest eigenpairs of the symmetric tridiagonal matrix A on the null space of `rows` (k, n).

    Method: Lanczos iteration on the inverse, shifted below the lowest eigenvalue. Each step is one positive
    definite tridiagonal solve. `terms` are added to A.

    Returns
    -------
    values : (count,) array
    vectors : (count, n) array
        Orthonormal, orthogonal to `rows`.
    """
    n = diagonal.size
    basis = orthonormal_rows(rows)
    rank = basis.shape[0]
    if n - rank < count:
        raise NotConvergedError(f"a rod of {n} edges has fewer than {count} free modes: use more samples")
    if n < _FEW:
        return _dense(diagonal, off, basis, count, terms)
    from scipy.sparse.linalg import LinearOperator, eigsh

    d, e, shift = _factored_below(diagonal, off, min(n, rank + count))
    if terms is not None:  # terms may lower the lowest eigenvalue
        step = _reach(diagonal, off) / n**2
        while constrained_inertia(diagonal, off, rows, shift, terms):
            shift, step = shift - step, 2 * step
        d, e, _ = lapack().dpttrf(diagonal - shift, off)
    border, corner = _bordered(basis, terms)
    solved = lapack().dpttrs(d, e, border.T)[0] if len(border) else border.T
    inner = np.linalg.inv(border @ solved - corner)

    def inverse(x: FloatArray) -> FloatArray:
        x = lapack().dpttrs(d, e, x - basis.T @ (basis @ x))[0]
        x = x - solved @ (inner @ (border @ x))
        return np.asarray(x - basis.T @ (basis @ x))

    # fixed start vector without symmetry, so that it has a component along every mode
    start = inverse(np.random.default_rng(0).normal(size=n))
    theta, vectors = eigsh(LinearOperator((n, n), inverse, dtype=float), count, which="LA", v0=start)
    return shift + 1 / theta[::-1], vectors.T[::-1]


def _factored_below(diagonal: FloatArray, off: FloatArray, last: int) -> tuple[FloatArray, FloatArray, float]:
    """Return D and L of L D L^T for the matrix minus a shift, and the shift.

    The shift is below the lowest eigenvalue; its distance follows from the spread of the first `last` eigenvalues.
    """
    reach = _reach(diagonal, off)
    tolerance = 0.01 * reach / diagonal.size**2
    lowest = lapack().dstebz(diagonal, off, 2, 0.0, 0.0, 1, last, tolerance, b"E")[1]
    step = 0.3 * (lowest[last - 1] - lowest[0]) + 10 * tolerance
    shift = lowest[0] - step
    d, e, info = lapack().dpttrf(diagonal - shift, off)
    # by rounding the matrix is not positive definite: lower the shift
    while info != 0 and shift > -2 * reach - step:
        step *= 2
        shift -= step
        d, e, info = lapack().dpttrf(diagonal - shift, off)
    if info != 0:
        raise NotConvergedError(
            "The stability is undecided, because the second variation of the rod has "
            "numbers that are not finite. Check its stiffness and its load."
        )
    return d, e, shift


class ConstrainedMode(NamedTuple):
    """Lowest eigenvalue mu of A v = mu W v on C v = 0, with v (n,), and nu (k,) of A v - mu W v = C^t nu."""

    value: float
    mode: FloatArray
    multipliers: FloatArray


def lowest_weighted(
    diagonal: FloatArray, off: FloatArray, lengths: FloatArray, rows: FloatArray, terms: Terms | None = None
) -> ConstrainedMode:
    """Return the lowest mode of a tridiagonal matrix A with weights `lengths` (n,) where `rows` (k, n) vanish.

    v^t W v = 1, its largest entry positive. `terms` are added to A.
    """
    if _native.compiled is not None and diagonal.size >= _FEW and terms is None and len(rows) <= 2:
        lowest = _native.lowest_mode(diagonal, off, lengths, rows, _polynomials(diagonal.size))
        if lowest is not None:
            return ConstrainedMode(*lowest)
    root = np.sqrt(lengths)
    scaled = None if terms is None else (terms[0] / root, terms[1])
    values, vectors = lowest_constrained(
        diagonal / lengths, off / (root[:-1] * root[1:]), rows / root, terms=scaled
    )
    v = vectors[0] / root
    v = v if v[np.argmax(np.abs(v))] > 0 else -v
    if not len(rows):
        return ConstrainedMode(float(values[0]), v, np.zeros(0))
    left = diagonal * v - values[0] * lengths * v
    left[1:] += off * v[:-1]
    left[:-1] += off * v[1:]
    if terms is not None:
        left += terms[0].T @ (terms[1] @ (terms[0] @ v))
    per_length = rows / lengths
    nu = np.linalg.lstsq(per_length @ rows.T, per_length @ left, rcond=1e-14)[0]
    return ConstrainedMode(float(values[0]), v, nu)


@lru_cache(maxsize=4)
def _polynomials(n: int) -> FloatArray:
    """Return orthonormal polynomials (n, _SMOOTH) on n equal steps; cached, because their computation is slow."""
    powers = np.polynomial.legendre.legvander(np.linspace(-1, 1, n), _SMOOTH - 1)
    return np.asarray(np.linalg.qr(powers)[0])


def _dense(
    diagonal: FloatArray, off: FloatArray, basis: FloatArray, count: int, terms: Terms | None
) -> tuple[FloatArray, FloatArray]:
    full = np.diag(diagonal) + np.diag(off, 1) + np.diag(off, -1)
    if terms is not None:
        full += terms[0].T @ terms[1] @ terms[0]
    free = (
        np.linalg.svd(basis, full_matrices=True)[2][basis.shape[0] :] if basis.size else np.eye(diagonal.size)
    )
    values, vectors = np.linalg.eigh(free @ full @ free.T)
    return values[:count], (free.T @ vectors[:, :count]).T


def _reach(diagonal: FloatArray, off: FloatArray) -> float:
    return float(np.abs(diagonal).max() + 2 * np.abs(off).max(initial=0.0))


# largest angle of an edge; no strip is wound so far, and cos and sin lose ten digits there
_WOUND_UP_RAD = 1e6


def shoot(
    stiffness: FloatArray,
    w: FloatArray,
    force: FloatArray,
    edge_length: float,
    *,
    moment: float,
    angle: float,
    natural_curvature: float | FloatArray = 0.0,
) -> tuple[FloatArray, FloatArray]:
    """Return angles and moments of the discrete rod in balance that starts with `moment` and `angle`.

    alpha_{i+1} = alpha_i + w_i (M_i / K_i + kappa_0),  M_{i+1} = M_i + l <b_{i+1}, T(alpha_{i+1})>: the
    stationarity of the discrete energy (paper, section 7.1) read from left to right, so the moment imbalance
    of `DiscreteRod.moment_imbalance` vanishes to rounding error.

    Parameters
    ----------
    stiffness, w : (n+1,) arrays
        K and Voronoi lengths (mm) of the nodes.
    force : (n, 2) array
        lambda of the edges, 1/mm2; b = R^t lambda.
    edge_length : float
        mm.
    moment, angle : float
        M_0, 1/mm, and the held angle alpha_0 at the start, rad.
    natural_curvature : float or (n+1,) array
        kappa_0, 1/mm.

    Returns
    -------
    angles : (n+2,) array
        alpha_0, the n edge angles, and the angle at the end; NaN from the first angle beyond `_WOUND_UP_RAD`.
    moments : (n+1,) array

    Examples
    --------
    A quarter circle: a constant moment and no force.

    >>> from elastica_cad.mechanics.discrete_rod import node_weights
    >>> angles, moments = shoot(
    ...     np.ones(5), node_weights(0.25, 4), np.zeros((4, 2)), 0.25, moment=np.pi / 2, angle=0.0
    ... )
    >>> round(float(angles[-1]), 6)
    1.570796
    """
    bends, rests = w / stiffness, np.ascontiguousarray(np.broadcast_to(w * natural_curvature, w.shape))
    across, along = edge_length * force[:, 1], -edge_length * force[:, 0]
    if _native.compiled is None:
        return _shoot_in_python(bends, rests, across, along, float(moment), float(angle))
    return _native.shoot(bends, rests, across, along, float(moment), float(angle), _WOUND_UP_RAD)


def _shoot_in_python(
    bends: FloatArray, rests: FloatArray, across: FloatArray, along: FloatArray, M: float, alpha: float
) -> tuple[FloatArray, FloatArray]:
    n, (bend, rest) = bends.size - 1, (bends.tolist(), rests.tolist())
    pull_x, pull_y = across.tolist(), along.tolist()
    angles, moments = [alpha], [M]
    for i in range(n):  # plain floats, because array expressions for each step are twenty times slower
        alpha += bend[i] * M + rest[i]
        if not -_WOUND_UP_RAD < alpha < _WOUND_UP_RAD:
            alpha = M = nan
        M += pull_x[i] * cos(alpha) + pull_y[i] * sin(alpha)
        angles.append(alpha)
        moments.append(M)
    angles.append(alpha + bend[n] * M + rest[n])
    return np.array(angles), np.array(moments)


def tangents(angles: FloatArray) -> FloatArray:
    """Return the unit tangents T(alpha) = (cos alpha, sin alpha), (n, 2)."""
    T = np.empty((angles.size, 2))
    np.cos(angles, out=T[:, 0])
    np.sin(angles, out=T[:, 1])
    return T


def node_weights(edge_length: float | FloatArray, edges: int) -> FloatArray:
    """Return Voronoi lengths w (n+1,): half the sum of the incident edge lengths, mm."""
    half = np.empty(edges)
    half[:] = edge_length
    half /= 2
    w = np.zeros(edges + 1)
    w[:-1] = half
    w[1:] += half
    return w


def edge_positions(start: FloatArray, tangents: FloatArray, edge_length: float | FloatArray) -> FloatArray:
    """Return the nodes gamma (n+1, 2) of the chain of edges along `tangents` (n, 2) from `start`, mm."""
    position = np.empty((tangents.shape[0] + 1, 2))
    position[0] = start
    np.cumsum(np.reshape(edge_length, (-1, 1)) * tangents, axis=0, out=position[1:])
    position[1:] += start
    return position


def edge_forces(first: FloatArray, load: FloatArray) -> FloatArray:
    """Return lambda of all edges (n, 2), 1/mm2, from lambda of the first edge and the nodal loads (n+1, 2).

    lambda_{i+1} = lambda_i + q_i; with weight q_i = -w_i K_i e, b_{i+1} = b_i - w_i K_i R^t e.
    """
    force = np.empty((load.shape[0] - 1, 2))
    force[0] = first
    np.cumsum(load[1:-1], axis=0, out=force[1:])
    force[1:] += first
    return force


def bending_moments(
    stiffness: FloatArray,
    angles: FloatArray,
    w: FloatArray,
    *,
    ends: tuple[float | None, float | None],
    natural_curvature: float | FloatArray = 0.0,
    end_moments: tuple[float, float] = (0.0, 0.0),
) -> FloatArray:
    """Return the moments M_i = K_i ((alpha_{i+1} - alpha_i) / w_i - kappa_0) of all nodes (n+1,), 1/mm.

    Parameters
    ----------
    ends : pair of float or None
        Angles alpha_0 and alpha_{n+1} held by the supports, or None for a free angle.
    end_moments : pair of float
        Moments M_0 and M_n at ends with a free angle.
    """
    M = np.empty(stiffness.size)
    np.subtract(angles[1:], angles[:-1], out=M[1:-1])
    M[0] = angles[0] - (angles[0] if ends[0] is None else ends[0])
    M[-1] = (angles[-1] if ends[1] is None else ends[1]) - angles[-1]
    M /= w
    M -= natural_curvature
    M *= stiffness
    if ends[0] is None:
        M[0] = end_moments[0]
    if ends[1] is None:
        M[-1] = end_moments[1]
    return M


@dataclass(frozen=True, eq=False)
class Margin:
    """Lowest eigenvalue of the second variation on the tangent space of the end constraints.

    Attributes
    ----------
    value : float
        The eigenvalue of h -> int K h'^2 - <lambda, gamma'> h^2 against int h^2, times length^2.
    mode : (n,) array
        Lowest mode h at the edges, scaled to int h^2 = 1; unit 1/sqrt(mm).
    multipliers : (2,) array
        nu of H v - mu W v = C^t nu, for x and y; zero for a coordinate that is not held at both ends.
    """

    value: float
    mode: FloatArray
    multipliers: FloatArray


@dataclass(frozen=True, eq=False)
class MarginDerivatives:
    """Partial derivatives of the margin.

    Attributes
    ----------
    stiffness : (n+1,) array
        With respect to the nodal K.
    force : (n, 2) array
        With respect to each edge's lambda, mm2.
    angles : (n,) array
        With respect to each edge's angle.
    length : float
        With respect to the total length if all edges are scaled and K, angles and lambda stay, 1/mm.
    """

    stiffness: FloatArray
    force: FloatArray
    angles: FloatArray
    length: float


@dataclass(frozen=True, eq=False)
class DiscreteRod:
    """Shape of a discrete rod with its forces; derived quantities are computed on first use.

    Attributes
    ----------
    stiffness : (n+1,) array
        K at the nodes; dM/dkappa where the material does not follow Hooke's law.
    angles : (n,) array
        Edge angles, rad.
    force : (n, 2) or (2,) array
        lambda of the edges, 1/mm2 (minus the usual internal force).
    edge_length : float or (n,) array
        mm.
    supports : Supports
        By default both ends are clamped.
    start : (2,) array
        Position of the first node, mm.
    bracing : Bracing or None
        Elements between the ends.

    Examples
    --------
    A straight rod without load: its margin is that of the lowest sine of mean zero.

    >>> rod = DiscreteRod(np.ones(201), np.zeros(200), np.zeros(2), 0.5)
    >>> round(rod.margin.value / np.pi**2, 3), rod.unstable_modes
    (4.0, 0)
    """

    stiffness: FloatArray
    angles: FloatArray
    force: FloatArray
    edge_length: float | FloatArray
    supports: Supports = field(default_factory=Supports)
    start: FloatArray = field(default_factory=lambda: np.zeros(2))
    bracing: Bracing | None = None

    @cached_property
    def edge_lengths(self) -> FloatArray:
        """Length of every edge (n,), mm."""
        return np.full(self.angles.size, self.edge_length, dtype=float)

    @cached_property
    def node_lengths(self) -> FloatArray:
        """Voronoi lengths w (n+1,) of the nodes, mm."""
        return node_weights(self.edge_length, self.angles.size)

    @cached_property
    def tangents(self) -> FloatArray:
        """Unit tangents T of the edges (n, 2)."""
        return tangents(self.angles)

    @cached_property
    def position(self) -> FloatArray:
        """Nodes (n+1, 2), mm."""
        return edge_positions(self.start, self.tangents, self.edge_length)

    @cached_property
    def pull(self) -> FloatArray:
        """<lambda, T> of the edges (n,), 1/mm2: minus the axial force."""
        return np.asarray(self.force[..., 0] * self.tangents[:, 0] + self.force[..., 1] * self.tangents[:, 1])

    @cached_property
    def shear(self) -> FloatArray:
        """<b, T> of the edges (n,), 1/mm2: the slope of the moment, b = R^t lambda."""
        return np.asarray(self.force[..., 1] * self.tangents[:, 0] - self.force[..., 0] * self.tangents[:, 1])

    @cached_property
    def held(self) -> tuple[int, ...]:
        """Coordinates (0: x, 1: y) that are held at both ends."""
        return tuple(i for i, both in enumerate(self.supports.transmits_force) if both)

    @property
    def held_angles(self) -> tuple[bool, bool]:
        """Flags for the start and the end: True if the support holds the tangent."""
        start, end = self.supports.ends
        return start.angle, end.angle

    @cached_property
    def hessian(self) -> tuple[FloatArray, FloatArray]:
        """Tridiagonal Hessian H of the energy in the edge angles: diagonal (n,), off-diagonal (n-1,), 1/mm.

        h^t H h = sum_i K_i (h_{i+1} - h_i)^2 / w_i - sum_i l_i <lambda_i, T_i> h_i^2, with h_0 = h_{n+1} = 0
        if the angle is held; the term of the end node is left out if the angle is free.
        """
        spring = self.stiffness / self.node_lengths
        self._drop_free(spring)
        return spring[:-1] + spring[1:] - self.edge_length * self.pull, -spring[1:-1]

    @cached_property
    def constraint_rows(self) -> FloatArray:
        """Rows C (p, n), mm, of d(gamma_l - gamma_0) = C d(alpha), for the coordinates held at both ends.

        C = l_i (-sin alpha_i, cos alpha_i). Rows along a straight rod vanish to first order and are left out.
        """
        sides = (-1, self.tangents[:, 1]), (1, self.tangents[:, 0])
        rows = np.zeros((len(self.held), self.angles.size))
        for row, i in zip(rows, self.held, strict=True):
            sign, side = sides[i]
            if np.abs(side).max() > RANK_TOLERANCE:
                np.multiply(sign * self.edge_length, side, out=row)
        return rows

    @cached_property
    def unstable_modes(self) -> int:
        """Number of unstable modes: the inertia of the Hessian on the constraints."""
        rows, terms = self._braced(self.constraint_rows)
        return constrained_inertia(*self.hessian, rows, terms=terms)

    def lowest_modes(self, count: int = 1) -> tuple[FloatArray, FloatArray]:
        """Return the lowest eigenvalues (count,) and modes (count, n) of the Hessian on the constraints."""
        rows, terms = self._braced(self.constraint_rows)
        return lowest_constrained(*self.hessian, rows, count, terms)

    @cached_property
    def margin(self) -> Margin:
        """Stability margin, O(n); positive means stable."""
        lengths = self.edge_lengths
        diagonal, off, rows = self._second_variation
        lowest = lowest_weighted(diagonal, off, lengths, *self._braced(rows))
        nu = np.zeros(2)
        nu[list(self.held)] = lowest.multipliers[: len(self.held)]
        return Margin(lowest.value * float(lengths.sum()) ** 2, lowest.mode, nu)

    @cached_property
    def margin_derivatives(self) -> MarginDerivatives:
        """Derivatives of the lowest eigenvalue mu of H v = mu W v + C^t nu, with v^t W v = 1 and C v = 0.

        They are d(mu) = v^t dH v - mu v^t dW v - 2 nu^t dC v, where nu are the multipliers of the constraints C.
        """
        v, nu, lengths = self.margin.mode, self.margin.multipliers, self.edge_lengths
        total = float(lengths.sum())
        square = total**2 * lengths * v**2
        per_stiffness = np.empty(v.size + 1)
        per_stiffness[0], per_stiffness[-1] = v[0], v[-1]
        np.subtract(v[1:], v[:-1], out=per_stiffness[1:-1])
        per_stiffness *= per_stiffness
        per_stiffness *= total**2
        per_stiffness /= self.node_lengths
        self._drop_free(per_stiffness)
        per_force = -square[:, None] * self.tangents
        per_angle = -square * self.shear + 2 * total**2 * lengths * v * (self.tangents @ nu)
        per_length = 2 / total * float((per_force * self.force).sum())
        return MarginDerivatives(per_stiffness, per_force, per_angle, per_length)

    @property
    def _second_variation(self) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Diagonal (n,) and off-diagonal (n-1,) of the Hessian, and rows (p, n) of the constraints."""
        if _native.compiled is None:
            return *self.hessian, self.constraint_rows
        start, end = self.held_angles
        return _native.second_variation(
            self.stiffness, self.node_lengths, self.edge_lengths, self.pull, self.tangents,
            free_ends=(not start, not end), held=(0 in self.held, 1 in self.held), straight=RANK_TOLERANCE,
        )  # fmt: skip

    def _braced(self, rows: FloatArray) -> tuple[FloatArray, Terms | None]:
        """Return the constraints of ends and elements, and the terms of the elements."""
        if self.bracing is None:
            return rows, None
        terms = (self.bracing.terms, self.bracing.coefficients) if len(self.bracing.terms) else None
        return np.concatenate([rows, self.bracing.rows]), terms

    def moment_imbalance(self, moments: FloatArray) -> FloatArray:
        """Return M_{i-1} - M_i + l_i <b_i, T_i> of the edges (n,), 1/mm: the gradient of the energy."""
        return np.asarray(moments[:-1] - moments[1:] + self.edge_length * self.shear)

    def reversed(self) -> "DiscreteRod":
        """Return the same rod, numbered from its end."""
        force = np.broadcast_to(self.force, self.tangents.shape)
        return DiscreteRod(
            self.stiffness[::-1], self.angles[::-1] + np.pi, -force[::-1], self.edge_lengths[::-1],
            self.supports.reversed(), self.position[-1],
        )  # fmt: skip

    def _drop_free(self, per_node: FloatArray) -> None:
        """Set the values at end nodes with a free angle to zero."""
        for node, held in zip((0, -1), self.held_angles, strict=True):
            if not held:
                per_node[node] = 0.0
