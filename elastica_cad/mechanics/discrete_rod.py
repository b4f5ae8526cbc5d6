"""Discrete rod of the paper's section 7.1: equations, energy, second variation, and banded linear algebra."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from functools import lru_cache
from math import cos, nan, sin
from typing import NamedTuple

import numpy as np

from elastica_cad import _native
from elastica_cad._cached_property import cached_property
from elastica_cad._compiled_scipy import lapack
from elastica_cad._types import FloatArray
from elastica_cad.errors import NotConvergedError
from elastica_cad.geometry.plane_points import cross, dot, midpoints, unit_vectors
from elastica_cad.mechanics.bracing import Bracing, bracing_of
from elastica_cad.mechanics.elements import ElementForce
from elastica_cad.mechanics.loads import Supports, turning_nodes, whole_number

RANK_TOLERANCE = 1e-9
"""A constraint is linearly dependent if less than this fraction of its norm is independent of the others."""

_SMOOTH = 10
"""Number of smooth trial modes with which compiled code starts the search for the lowest mode."""

_EPS = float(np.finfo(float).eps)


def solve_tridiagonal(diagonal: FloatArray, off: FloatArray, right: FloatArray) -> FloatArray:
    """Solve a symmetric tridiagonal system with pivoting; the right-hand side `right` is (n,) or (n, k)."""
    if diagonal.size == 1:
        return np.asarray(right / diagonal[0])
    solution, info = lapack().dgtsv(off, diagonal, off, right)[-2:]
    if info != 0:  # the matrix is singular: change it by a rounding error
        nudge = np.spacing(np.abs(diagonal).max())
        solution, info = lapack().dgtsv(off, diagonal + nudge, off, right)[-2:]
    if info != 0:
        raise NotConvergedError(
            "the rod has no definite shape, because neighbouring shapes are also in equilibrium. Hold one "
            "more position or angle of an end"
        )
    return np.asarray(solution)


def solve_bordered(
    diagonal: FloatArray,
    off: FloatArray,
    rows: FloatArray,
    *,
    right: FloatArray,
    below: FloatArray,
    corner: FloatArray | float = 0.0,
) -> tuple[FloatArray, FloatArray]:
    """Solve [[A, rows.T], [rows, corner]] (x, y) = (right, below) with a symmetric tridiagonal matrix A (n, n).

    Parameters
    ----------
    rows : (k, n) array
    right : (n,) array
    below : (k,) array
    corner : (k, k) array, optional

    Returns
    -------
    x : (n,) array
    y : (k,) array
        Least-squares solution of least norm if the rows are linearly dependent.
    """
    k = below.size
    if k == 0:
        return solve_tridiagonal(diagonal, off, right), np.zeros(0)
    both = np.empty((right.size, k + 1), order="F")
    both[:, 0] = right
    both[:, 1:] = rows.T
    # x = A^-1 right - A^-1 rows.T y, inserted in the last rows of the system
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
        for _ in range(2):  # the second time removes rounding errors
            for q in basis:
                rest = rest - q.dot(rest) * q
        remainder = float(np.linalg.norm(rest))
        if remainder > RANK_TOLERANCE:
            basis.append(rest / remainder)
    return np.array(basis).reshape(len(basis), rows.shape[1])


def count_negative(diagonal: FloatArray, off: FloatArray, shift: float = 0.0) -> int:
    """Return the number of eigenvalues at or below `shift` of a symmetric tridiagonal matrix (Sturm count)."""
    if diagonal.size == 1:
        return int(diagonal[0] <= shift)
    reach = _reach(diagonal, off)
    if shift < -reach:
        return 0
    # range 1 means the eigenvalues in (lower limit, shift]; only their number is needed, so the tolerance is wider
    # than this interval
    count, _, _, _, info = lapack().dstebz(
        diagonal, off, 1, -2 * reach - 1, shift, 1, 1, 8 * reach + 8 + abs(shift), b"E"
    )
    if info != 0:
        raise NotConvergedError(
            "the stability of the rod cannot be computed, because the numbers become too large: check the "
            "stiffness and the load of the rod"
        )
    return int(count)


class Terms(NamedTuple):
    """Matrix -G^t D^-1 G that is added to a matrix A (n, n).

    The sum is the Schur complement of D in the larger matrix [[A, G^t], [G, D]], which is used instead.

    For an added matrix G^t C G, D is -C^-1. For a constraint G h = 0 with a compliance, D is -compliance.

    Attributes
    ----------
    rows : (r, n) array
        Linear forms G.
    corner : (r, r) array
        Symmetric matrix D.
    below : int
        Number of negative eigenvalues of the larger matrix if A - G^t D^-1 G is positive definite.
    """

    rows: FloatArray
    corner: FloatArray
    below: int

    @classmethod
    def of(cls, rows: FloatArray, coefficients: FloatArray) -> "Terms":
        """Return the terms G^t C G with `rows` G (r, n) and invertible `coefficients` C (r, r)."""
        positive = np.count_nonzero(np.linalg.eigvalsh(coefficients) > 0)
        return cls(rows, -np.asarray(np.linalg.inv(coefficients)), int(positive))

    def on(self, vector: FloatArray) -> FloatArray:
        """Return the product of the added matrix -G^t D^-1 G and a vector (n,)."""
        return -self.rows.T @ np.linalg.solve(self.corner, self.rows @ vector)


def _border_of(basis: FloatArray, terms: Terms | None) -> tuple[FloatArray, FloatArray]:
    """Return the rows that border a matrix (`basis`, and below it the rows of `terms`), and their corner.

    The corner is 0 for the rows of `basis`, which are constraints, and D for those of `terms`.
    """
    k = len(basis)
    if terms is None:
        return basis, np.zeros((k, k))
    corner = np.zeros((k + len(terms.rows), k + len(terms.rows)))
    corner[k:, k:] = terms.corner
    return np.concatenate([basis, terms.rows]), corner


def constrained_inertia(
    diagonal: FloatArray, off: FloatArray, rows: FloatArray, shift: float = 0.0, terms: Terms | None = None
) -> int:
    """Count the eigenvalues below `shift` of the tridiagonal matrix A on the null space of `rows` (k, n).

    By Sylvester's law for the bordered matrix, the number is neg(A - shift) + pos(S) - rank(C). Here C = `rows`,
    S = C (A - shift)^-1 C^t, and neg and pos are numbers of negative and positive eigenvalues. The `terms` are
    added to A by further rows of C and their corner in S: see `Terms`.
    """
    constraints = orthonormal_rows(rows)
    basis, corner = _border_of(constraints, terms)
    if len(basis) == 0:
        return count_negative(diagonal, off, shift)
    solved = solve_tridiagonal(diagonal - shift, off, basis.T).T
    reach = _reach(diagonal, off)
    if not np.abs(solved).max() * 16 * _EPS * reach < 1:
        # lower the shift if A - shift is almost singular, because rounding errors may change the count
        shift -= 64 * _EPS * reach
        solved = solve_tridiagonal(diagonal - shift, off, basis.T).T
    negative = count_negative(diagonal, off, shift)
    schur = basis @ solved.T - corner
    positive = int(np.count_nonzero(np.linalg.eigvalsh((schur + schur.T) / 2) > 0))
    return negative + positive - len(constraints) - (0 if terms is None else terms.below)


def lowest_constrained(
    diagonal: FloatArray, off: FloatArray, rows: FloatArray, count: int = 1, terms: Terms | None = None
) -> tuple[FloatArray, FloatArray]:
    """Return the lowest eigenpairs of the symmetric tridiagonal matrix A on the null space of `rows` (k, n).

    The method is Lanczos iteration on the inverse of A, shifted below the lowest eigenvalue. `terms` are
    added to A.

    Returns
    -------
    values : (count,) array
    vectors : (count, n) array
        Orthonormal eigenvectors, orthogonal to `rows`.
    """
    n = diagonal.size
    basis = orthonormal_rows(rows)
    rank = len(basis)
    if n - rank < count:
        raise NotConvergedError(f"a rod of {n} segments is too coarse for {count} modes: use more samples")
    d, e, shift = _factored_below(diagonal, off, min(n, rank + count))
    if terms is not None:  # the added terms may lower the lowest eigenvalue below the shift
        step = _reach(diagonal, off) / n**2
        while constrained_inertia(diagonal, off, rows, shift, terms):
            shift, step = shift - step, 2 * step
        d, e, _ = lapack().dpttrf(diagonal - shift, off)
    theta, vectors = largest_of_inverse(lambda x: lapack().dpttrs(d, e, x)[0], n, basis, count, terms)
    return shift + 1 / theta, vectors


def largest_of_inverse(
    solve: Callable[[FloatArray], FloatArray],
    n: int,
    basis: FloatArray,
    count: int = 1,
    terms: Terms | None = None,
) -> tuple[FloatArray, FloatArray]:
    """Return the largest eigenvalues (count,) and eigenvectors (count, n) of the inverse of a matrix.

    The method is Lanczos iteration with full orthogonalisation, which takes about 14 steps for one mode. `solve`
    applies the inverse of the positive definite matrix (n, n) to arrays (n,) or (n, k). `terms` are added to
    the matrix, which is restricted to the null space of the orthonormal rows `basis` (r, n).
    """
    border, corner = _border_of(basis, terms)
    solved = solve(border.T) if len(border) else border.T
    inner = np.linalg.inv(border @ solved - corner)

    def inverse(x: FloatArray) -> FloatArray:
        x = solve(x - basis.T @ (basis @ x))
        x = x - solved @ (inner @ (border @ x))
        return x - basis.T @ (basis @ x)

    # ARPACK is not used, because its package is slow to load and its calls wake threads of BLAS
    # diagonal and off-diagonal of the Lanczos matrix, and its vectors; the newest `beyond` also bounds the errors
    along: list[float] = []
    beyond: list[float] = []
    steps = np.empty((0, n))
    # fixed start vector without symmetry, so that it has a component along every mode
    x = inverse(np.modf(np.arange(1, n + 1) * 5**0.5)[0])
    while True:
        steps = np.vstack([steps, x / np.linalg.norm(x)])
        x = inverse(steps[-1])
        along.append(float(steps[-1] @ x))
        for _ in range(2):  # the second time removes rounding errors
            x = x - (steps @ x) @ steps
        theta, shares, _ = lapack().dstev(along, beyond or along)
        beyond.append(float(np.linalg.norm(x)))
        errors = beyond[-1] * np.abs(shares[-1, -count:])
        settled = len(steps) >= count and not errors.max() > _EPS * theta[-1]
        if settled or len(steps) == n - len(basis):
            return theta[: -count - 1 : -1], shares.T[: -count - 1 : -1] @ steps  # the largest first


def _factored_below(diagonal: FloatArray, off: FloatArray, last: int) -> tuple[FloatArray, FloatArray, float]:
    """Return D, L and a shift below all eigenvalues of a tridiagonal matrix A, with A - shift = L D L^T.

    The shift is below the lowest eigenvalue by 0.3 times the distance to eigenvalue number `last`, or by more if
    rounding errors require it.
    """
    reach = _reach(diagonal, off)
    tolerance = 0.01 * reach / diagonal.size**2
    lowest = lapack().dstebz(diagonal, off, 2, 0.0, 0.0, 1, last, tolerance, b"E")[1]
    step = 0.3 * (lowest[last - 1] - lowest[0]) + 10 * tolerance
    shift = lowest[0] - step
    d, e, info = lapack().dpttrf(diagonal - shift, off)
    while info != 0 and shift > -2 * reach - step:
        step *= 2
        shift -= step
        d, e, info = lapack().dpttrf(diagonal - shift, off)
    if info != 0:
        raise NotConvergedError(
            "The stability is undecided, because the computation gives numbers that are not finite. Check "
            "the stiffness and the load of the rod."
        )
    return d, e, shift


def lowest_weighted(
    diagonal: FloatArray, off: FloatArray, lengths: FloatArray, rows: FloatArray, terms: Terms | None = None
) -> tuple[float, FloatArray, FloatArray]:
    """Return the lowest mode v of a tridiagonal matrix A with weights W = `lengths`, subject to `rows` @ v = 0.

    `terms` are added to A.

    Returns
    -------
    value : float
        Eigenvalue mu in A v = mu W v + rows^t nu.
    mode : (n,) array
        Mode v, scaled to v^t W v = 1. Its entry of largest absolute value is positive.
    multipliers : (k,) array
        Multipliers nu of the constraints `rows` (k, n).
    """
    # compiled code searches for the lowest mode of rods with enough edges
    if _native.compiled is not None and diagonal.size >= 40 and terms is None and len(rows) <= 2:
        lowest = _native.lowest_mode(diagonal, off, lengths, rows, _polynomials(diagonal.size))
        if lowest is not None:
            return lowest
    root = np.sqrt(lengths)
    scaled = None if terms is None else terms._replace(rows=terms.rows / root)
    values, vectors = lowest_constrained(
        diagonal / lengths, off / (root[:-1] * root[1:]), rows / root, terms=scaled
    )
    # the search was for root * v, whose weights are 1
    v = vectors[0] / root
    v = v if v[np.abs(v).argmax()] > 0 else -v
    if not len(rows):
        return float(values[0]), v, np.zeros(0)
    residual = diagonal * v - values[0] * lengths * v
    residual[1:] += off * v[:-1]
    residual[:-1] += off * v[1:]
    if terms is not None:
        residual += terms.on(v)
    per_length = rows / lengths
    nu = np.linalg.lstsq(per_length @ rows.T, per_length @ residual, rcond=1e-14)[0]
    return float(values[0]), v, nu


@lru_cache(maxsize=4)
def _polynomials(n: int) -> FloatArray:
    # orthonormal trial modes (n, _SMOOTH): polynomials of the edge number
    powers = np.polynomial.legendre.legvander(np.linspace(-1, 1, n), _SMOOTH - 1)
    return np.linalg.qr(powers)[0]


def _reach(diagonal: FloatArray, off: FloatArray) -> float:
    # bound of the absolute eigenvalues of a tridiagonal matrix (Gershgorin)
    return float(np.abs(diagonal).max() + 2 * np.abs(off).max(initial=0.0))


# largest angle of an edge, above which cos and sin are inaccurate; no strip has so many turns
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
    """Return the angles and moments of a discrete rod in equilibrium that starts with `moment` and `angle`.

    The angles alpha and moments M follow from

        alpha_{i+1} = alpha_i + w_i (M_i / K_i + kappa_0),   M_{i+1} = M_i + l <b_{i+1}, T(alpha_{i+1})>,

    where T is the unit tangent and b is the force lambda turned by -90 degrees. These angles make the discrete
    energy stationary (paper, section 7.1).

    Parameters
    ----------
    stiffness, w : (n+1,) arrays
        Stiffness K and Voronoi lengths (mm) of the nodes.
    force : (n, 2) array
        Force lambda of the edges: the negative internal force over the least bending stiffness, 1/mm2.
    edge_length : float
        Edge length l, mm.
    moment, angle : float
        Moment M_0 divided by the least bending stiffness, 1/mm, and angle alpha_0, rad, at the start.
    natural_curvature : float or (n+1,) array
        Curvature kappa_0 of the unloaded rod, 1/mm.

    Returns
    -------
    angles : (n+2,) array
        alpha_0, the n edge angles, and the angle at the end; NaN from the first angle beyond `_WOUND_UP_RAD`.
    moments : (n+1,) array
        Bending moments of the nodes divided by the least bending stiffness, 1/mm.
    """
    bends, rests = w / stiffness, np.ascontiguousarray(np.broadcast_to(w * natural_curvature, w.shape))
    across, along = edge_length * force[:, 1], -edge_length * force[:, 0]
    if _native.compiled is None:
        # a node adds bend M + rest to the angle; an edge adds pull_x cos(angle) + pull_y sin(angle) to the moment M
        M, alpha = float(moment), float(angle)
        n, (bend, rest) = bends.size - 1, (bends.tolist(), rests.tolist())
        pull_x, pull_y = across.tolist(), along.tolist()
        angles, moments = [alpha], [M]
        for i in range(n):  # plain floats are twenty times faster here than arrays
            alpha += bend[i] * M + rest[i]
            if not -_WOUND_UP_RAD < alpha < _WOUND_UP_RAD:
                alpha = M = nan
            M += pull_x[i] * cos(alpha) + pull_y[i] * sin(alpha)
            angles.append(alpha)
            moments.append(M)
        angles.append(alpha + bend[n] * M + rest[n])
        return np.array(angles), np.array(moments)
    return _native.shoot(bends, rests, across, along, float(moment), float(angle), _WOUND_UP_RAD)


def node_weights(edge_length: float | FloatArray, edges: int) -> FloatArray:
    """Return the Voronoi lengths w (n+1,) of the nodes, mm: half the sum of the adjacent edge lengths."""
    half = np.empty(edges)
    half[:] = edge_length
    half /= 2
    w = np.zeros(edges + 1)
    w[:-1] = half
    w[1:] += half
    return w


def edge_positions(start: FloatArray, tangents: FloatArray, edge_length: float | FloatArray) -> FloatArray:
    """Return the nodes (n+1, 2), mm, of a chain of edges that begins at `start`. `tangents` are (n, 2)."""
    position = np.empty((len(tangents) + 1, 2))
    position[0] = start
    np.cumsum(np.reshape(edge_length, (-1, 1)) * tangents, axis=0, out=position[1:])
    position[1:] += start
    return position


def edge_forces(first: FloatArray, load: FloatArray) -> FloatArray:
    """Return the forces lambda of all edges (n, 2), 1/mm2, from the first edge's force (2,) and loads (n+1, 2).

    Lambda is the negative internal force, with lambda_{i+1} = lambda_i + q_i for the nodal load q_i. The weight is
    q_i = -w_i K_i e, with Voronoi length w_i, stiffness K_i and a vector e against gravity.
    """
    force = np.empty((len(load) - 1, 2))
    force[0] = first
    load[1:-1].cumsum(axis=0, out=force[1:])
    force[1:] += first
    return force


def nodal_forces(edges: FloatArray, load: FloatArray) -> FloatArray:
    """Return the forces lambda at the nodes (n+1, 2), from those of the edges (n, 2) and the nodal loads (n+1, 2).

    The force at an inner node is the mean of its two edges. At an end it is the force of the support.
    """
    return np.concatenate([edges[:1] - load[0], midpoints(edges), edges[-1:] + load[-1]])


def bending_moments(
    stiffness: FloatArray,
    angles: FloatArray,
    w: FloatArray,
    *,
    ends: tuple[float | None, float | None],
    natural_curvature: float | FloatArray = 0.0,
    end_moments: tuple[float, float] = (0.0, 0.0),
) -> FloatArray:
    """Return the bending moments of all nodes (n+1,) divided by the least bending stiffness, 1/mm.

    The moments are M_i = K_i ((alpha_{i+1} - alpha_i) / w_i - kappa_0), with stiffness K_i, angles alpha_i, Voronoi
    lengths w_i and natural curvature kappa_0.

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
class Compression:
    """Axial elasticity of the n edges of a rod.

    An edge has its nominal length under the force of the designed shape. Another force lambda (the negative
    internal force) multiplies this length by 1 - c (<lambda, T> - p), where T is the direction of the edge.

    Attributes
    ----------
    compliance : (n,) array
        Compliance c, mm2: least bending stiffness divided by the axial stiffness E A.
    pull : (n,) array
        Force component p = <lambda, T> in the designed shape, 1/mm2.
    """

    compliance: FloatArray
    pull: FloatArray

    def stretched(self, directions: FloatArray, force: FloatArray) -> FloatArray:
        """Return the edge vectors (n, 2) under a force (n, 2), divided by the nominal edge length."""
        return directions * (1 - self.compliance * (dot(force, directions) - self.pull))[:, None]

    def resampled(self, edges: int) -> "Compression":
        """Return the axial elasticity interpolated to `edges` edges of equal length."""
        old, new = ((np.arange(n) + 0.5) / n for n in (self.pull.size, edges))
        return Compression(np.interp(new, old, self.compliance), np.interp(new, old, self.pull))

    def scaled(self, least: float) -> "Compression":
        """Return the axial elasticity for a rod whose least bending stiffness is `least` times as large."""
        return Compression(self.compliance * least, self.pull / least)


@dataclass(frozen=True, eq=False)
class Margin:
    """Stability margin: lowest eigenvalue of the second variation for changes that the supports allow.

    Attributes
    ----------
    value : float
        Lowest value of length^2 int (K h'^2 - <lambda, gamma'> h^2) ds / int h^2 ds for changes h of the
        tangent's angle. K is the stiffness, lambda the negative internal force, and gamma' the tangent.
    mode : (n,) array
        Lowest mode h at the edges, scaled to int h^2 ds = 1; unit 1/sqrt(mm).
    multipliers : (2,) array
        Multipliers nu of the constraints on x and y, see `DiscreteRod.margin_derivatives`. The multiplier is zero
        for a coordinate that is not held at both ends, and for axially elastic rods.
    """

    value: float
    mode: FloatArray
    multipliers: FloatArray


@dataclass(frozen=True, eq=False)
class MarginDerivatives:
    """Partial derivatives of the stability margin.

    Attributes
    ----------
    stiffness : (n+1,) array
        Derivatives with respect to the nodal stiffness.
    force : (n, 2) array
        Derivatives with respect to the force lambda of each edge, mm2.
    angles : (n,) array
        Derivatives with respect to the angle of each edge.
    length : float
        Derivative with respect to the total length, 1/mm, if all edges are scaled, and stiffness, angles and force
        stay the same.
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
        Stiffness at the nodes: dM/dkappa if the material does not obey Hooke's law.
    angles : (n,) array
        Edge angles, rad.
    force : (n, 2) or (2,) array
        Force lambda of the edges: the negative internal force over the least bending stiffness, 1/mm2.
    edge_length : float or (n,) array
        Length of the edges, mm.
    supports : Supports
        By default both ends are clamped.
    start : (2,) array
        Position of the first node, mm.
    bracing : sequence of ElementForce or None
        Taut rails, pins and ties that support the rod between its ends; None for a rod without them.
    compression : Compression or None
        Axial elasticity of the edges; None for a rod that bends only.

    Examples
    --------
    A straight rod without load: the lowest mode is the lowest sine of mean zero.

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
    bracing: Sequence[ElementForce] | None = None
    compression: Compression | None = None

    @cached_property
    def _brace(self) -> Bracing | None:
        """Contribution of rails, pins and ties to the second variation."""
        return None if self.bracing is None else bracing_of(
            self.bracing, tangents=self.tangents, edge_length=float(self.edge_lengths[0]),
            supports=self.supports, directions=None if self.compression is None else self.directions,
        )  # fmt: skip

    @cached_property
    def edge_lengths(self) -> FloatArray:
        """Length of every edge (n,), mm."""
        return np.full(self.angles.size, self.edge_length, dtype=float)

    @cached_property
    def node_lengths(self) -> FloatArray:
        """Half the sum of the edge lengths at each node (n+1,), mm."""
        return node_weights(self.edge_length, self.angles.size)

    @cached_property
    def directions(self) -> FloatArray:
        """Unit tangents of the edges (n, 2)."""
        return unit_vectors(self.angles)

    @cached_property
    def tangents(self) -> FloatArray:
        """Edge vectors (n, 2) divided by the nominal edge length; unit vectors without axial elasticity."""
        if self.compression is None:
            return self.directions
        return self.compression.stretched(self.directions, self.force)

    @cached_property
    def position(self) -> FloatArray:
        """Nodes (n+1, 2), mm."""
        return edge_positions(self.start, self.tangents, self.edge_length)

    @cached_property
    def pull(self) -> FloatArray:
        """Component (n,), 1/mm2, of the force lambda along each edge: the negative tension."""
        return dot(self.force, self.tangents)

    @cached_property
    def shear(self) -> FloatArray:
        """Component (n,), 1/mm2, of the force lambda normal to each edge: the slope of the bending moment."""
        return cross(self.tangents, self.force)

    @cached_property
    def shortening(self) -> FloatArray:
        """Shortening c l (n,), mm3, of each edge under a force of 1/mm2, with compliance c and edge length l."""
        assert self.compression is not None
        return self.edge_length * self.compression.compliance

    @cached_property
    def sideways_pull(self) -> FloatArray:
        """Derivative (n,), 1/mm2, of the axial component of the force in each edge by the edge angle."""
        return cross(self.directions, self.force)

    @cached_property
    def held(self) -> tuple[int, ...]:
        """Coordinates (0: x, 1: y) that both supports hold."""
        return tuple(i for i, both in enumerate(self.supports.transmits_force) if both)

    @property
    def held_angles(self) -> tuple[bool, bool]:
        """Flags for the start and the end: True if the support holds the tangent."""
        start, end = self.supports.ends
        return start.angle, end.angle

    @cached_property
    def hessian(self) -> tuple[FloatArray, FloatArray]:
        """Tridiagonal Hessian H of the energy by the edge angles: diagonal (n,) and off-diagonal (n-1,), 1/mm.

        An edge has the length l_i, tangent T_i, force lambda_i and change of angle h_i. A node has the stiffness
        K_i and Voronoi length w_i. The matrix H is defined by

            h^t H h = sum_i K_i (h_{i+1} - h_i)^2 / w_i - sum_i l_i <lambda_i, T_i> h_i^2.

        At an end with a held angle, h_0 or h_{n+1} is 0. At an end with a free angle, the term of the end node is
        omitted. An axially elastic edge of compliance c adds -c l_i <lambda_i, R T_i>^2 h_i^2, where R turns a
        vector by 90 degrees.
        """
        spring = self.stiffness / self.node_lengths
        spring[turning_nodes(self.supports)] = 0.0
        diagonal = spring[:-1] + spring[1:] - self.edge_length * self.pull
        if self.compression is not None:
            diagonal -= self.shortening * self.sideways_pull**2
        return diagonal, -spring[1:-1]

    @cached_property
    def constraint_rows(self) -> FloatArray:
        """Derivatives C (p, n), mm, of the position of the end by the edge angles.

        There is a row for each coordinate, x or y, that both supports hold. The columns are l_i (-sin alpha_i,
        cos alpha_i), with edge length l_i and angle alpha_i. The row of an axis parallel to a straight rod is zero.
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
        """Number of unstable modes: negative eigenvalues of the Hessian under the constraints."""
        rows, terms = self._braced(self.constraint_rows)
        return constrained_inertia(*self.hessian, rows, terms=terms)

    def lowest_modes(self, count: int = 1) -> tuple[FloatArray, FloatArray]:
        """Return the lowest eigenvalues (count,) and modes (count, n) of the Hessian under the constraints."""
        whole_number(count, "count", 1)
        rows, terms = self._braced(self.constraint_rows)
        return lowest_constrained(*self.hessian, rows, count, terms)

    @cached_property
    def margin(self) -> Margin:
        """Stability margin; positive means stable. The computation takes O(n) operations."""
        lengths = self.edge_lengths
        diagonal, off, rows = self._second_variation
        value, mode, multipliers = lowest_weighted(diagonal, off, lengths, *self._braced(rows))
        nu = np.zeros(2)  # the rows of the held coordinates are first, then those of the bracing
        if self.compression is None:
            nu[list(self.held)] = multipliers[: len(self.held)]
        return Margin(value * float(lengths.sum()) ** 2, mode, nu)

    @cached_property
    def margin_derivatives(self) -> MarginDerivatives:
        """Derivatives of the lowest eigenvalue mu of H v = mu W v + C^t nu with v^t W v = 1 and C v = 0.

        H is the Hessian, W the diagonal matrix of edge lengths, and nu are the multipliers of the constraints C.
        The derivatives are d(mu) = v^t dH v - mu v^t dW v - 2 nu^t dC v.
        """
        v, nu, lengths = self.margin.mode, self.margin.multipliers, self.edge_lengths
        total = float(lengths.sum())
        square = total**2 * lengths * v**2
        per_stiffness = (total * np.diff(v, prepend=0.0, append=0.0)) ** 2 / self.node_lengths
        per_stiffness[turning_nodes(self.supports)] = 0.0
        per_force = -square[:, None] * self.tangents
        per_angle = -square * self.shear + 2 * total**2 * lengths * v * (self.tangents @ nu)
        per_length = 2 / total * float((per_force * self.force).sum())
        return MarginDerivatives(per_stiffness, per_force, per_angle, per_length)

    @property
    def _second_variation(self) -> tuple[FloatArray, FloatArray, FloatArray]:
        # diagonal and off-diagonal of `hessian`, and `constraint_rows`
        if _native.compiled is None or self.compression is not None:
            return *self.hessian, self.constraint_rows
        start, end = self.held_angles
        return _native.second_variation(
            self.stiffness, self.node_lengths, self.edge_lengths, self.pull, self.tangents,
            free_ends=(not start, not end), held=(0 in self.held, 1 in self.held), straight=RANK_TOLERANCE,
        )  # fmt: skip

    def _braced(self, rows: FloatArray) -> tuple[FloatArray, Terms | None]:
        """Return the constraints on changes of the edge angles, and the terms that are added to the Hessian.

        `rows` (p, n) are those of `constraint_rows`. For an axially elastic rod, terms replace the constraints.
        A strain of an edge moves the end along the edge, which adds n columns, as in `brace.rows`.
        """
        brace, terms = self._brace, None
        if self.compression is not None:  # n columns for the angles, and n for the strains
            rows = np.concatenate([rows, self.edge_length * self.directions.T[list(self.held)]], axis=1)
        if brace is not None:
            rows = np.concatenate([rows, brace.rows])
            terms = Terms.of(brace.terms, brace.coefficients) if len(brace.terms) else None
        if self.compression is None:
            return rows, terms
        return np.zeros((0, self.angles.size)), self._elastic_terms(rows, terms)

    def _elastic_terms(self, rows: FloatArray, terms: Terms | None) -> Terms | None:
        """Return the terms for the constraints and bracing of an axially elastic rod; the strains are eliminated.

        Changes h of the edge angles and e of the strains change the energy by h^t H h + 2 h^t X e + e^t Y e. H is
        the Hessian at constant strains. X = l <lambda, R T> and Y = l / c are diagonal, with edge length l, force
        lambda, tangent T and compliance c. R turns a vector by 90 degrees.
        """
        n, held = self.angles.size, orthonormal_rows(rows)
        both, corner = _border_of(held, terms)
        if not len(both):
            return None
        more = both[:, n:] * self.shortening / self.edge_length
        return Terms(
            both[:, :n] - more * self.sideways_pull, corner - more / self.edge_length @ both[:, n:].T,
            len(held) + (0 if terms is None else terms.below),
        )  # fmt: skip

    def moment_imbalance(self, moments: FloatArray) -> FloatArray:
        """Return the moment imbalance of the edges (n,), 1/mm: the gradient of the energy by the edge angles."""
        return moments[:-1] - moments[1:] + self.edge_length * self.shear

    def reversed(self) -> "DiscreteRod":
        """Return the rod with its nodes numbered from the other end, without bracing and axial elasticity."""
        force = np.broadcast_to(self.force, self.tangents.shape)
        return DiscreteRod(
            self.stiffness[::-1], self.angles[::-1] + np.pi, -force[::-1], self.edge_lengths[::-1],
            self.supports.reversed(), self.position[-1],
        )  # fmt: skip
