"""Stability of a rod: its margin, its conjugate points, and a summary in words."""

from bisect import bisect_left
from dataclasses import dataclass, field, replace
from typing import Literal

import numpy as np

from elastica_cad._compiled_scipy import lapack
from elastica_cad._types import FloatArray
from elastica_cad._values import numbers, require_record
from elastica_cad.errors import InputError, NotConvergedError, note
from elastica_cad.geometry.plane_points import angle_of, at_sign_changes, left_of, midpoints
from elastica_cad.mechanics.discrete_rod import (
    DiscreteRod,
    constrained_inertia,
    lowest_constrained,
    solve_bordered,
)
from elastica_cad.mechanics.loads import turning_nodes
from elastica_cad.mechanics.rod import Rod, require_rod


@dataclass(frozen=True, eq=False)
class Determinant:
    """Stability determinant Z along a rod (paper, Fig. 9).

    Attributes
    ----------
    s : (n+1,) array
        Midpoints of the edges and the end of the rod, mm from the start.
    value : (n+1,) array
        Values of Z. The sign changes of Z are the conjugate points, except for rounding errors near s = 0,
        where Z has a zero of high order.
    fields : (n+2, 1+p) array
        Solutions zeta, eta_1, .. eta_p of the Jacobi equation on the edges, with a fictitious edge before the first
        and after the last edge. There are p coordinates that both ends hold.
    integrals : (n, p, 1+p) array
        Integrals M_i and N_ij of the paper up to the end of each edge.
    """

    s: FloatArray
    value: FloatArray
    fields: FloatArray
    integrals: FloatArray

    @property
    def sign_changes(self) -> FloatArray:
        """Arc lengths (k,), mm, at which the determinant Z changes its sign.

        Sign changes before the first zero of the Jacobi solution zeta are omitted, because they are rounding
        errors.
        """
        beyond = np.flatnonzero(self.fields[1:, 0] <= 0)
        # before the first zero of the Jacobi solution zeta, the rod is stable even if its end is free to move
        first = max(int(beyond[0]) - 1, 0) if beyond.size else self.s.size
        return at_sign_changes(self.value[first:], self.s[first:])


def stability_determinant(rod: DiscreteRod) -> Determinant:
    """Return the stability determinant from the start of the rod, by the discrete Jacobi recursion.

    The recursion is described in the paper, section 7.1. If the angle is free at the start, the solution zeta
    starts with the slope 0. The determinant has rows only for coordinates that both ends hold.

    Examples
    --------
    A straight, unloaded cantilever has no conjugate point.

    >>> from elastica_cad.mechanics.loads import Supports
    >>> rod = DiscreteRod(np.ones(51), np.zeros(50), np.zeros(2), 1.0, Supports("free", "clamped"))
    >>> stability_determinant(rod).sign_changes.size
    0
    """
    require_record(rod, DiscreteRod, "the rod", "a DiscreteRod, such as Rod.discrete")
    n, rows, lengths = rod.angles.size, rod.constraint_rows, rod.edge_lengths
    right = np.zeros((n + 1, 1 + len(rows)))
    # the Jacobi solution zeta (paper, Eq. 7) at the first edge: its distance from a held start (slope 1), or 1 if
    # the start is free to turn
    right[0] = rod.node_lengths[0] if rod.held_angles[0] else 1.0
    right[1:, 1:] = -rows.T
    fields = np.zeros((n + 2, right.shape[1]))
    fields[1:] = _solve_recursion(rod, right)
    integrals = (rows.T[:, :, None] * fields[1:-1, None, :]).cumsum(axis=0)
    Z = _stability_matrices(fields, integrals)
    ends = lengths.cumsum()
    return Determinant(np.append(ends - lengths / 2, ends[-1]), np.linalg.det(Z), fields, integrals)


def determinant_gradient(
    rod: DiscreteRod, *, weights: FloatArray, moments: FloatArray, load_slope: FloatArray | None = None
) -> FloatArray:
    """Return the gradient of a weighted sum of the stability determinant with respect to the nodal stiffness.

    The method is the adjoint method (paper, Appendix B). The rod remains in equilibrium while the stiffness K
    changes: its ends are held, and its angles and forces change. If the weights are positive only near a
    conjugate point sigma (or interpolate Z there), the result is dZ/dK at sigma times a positive factor. A step
    along it moves sigma towards the end of the rod. The result is exact for Hooke's law. If the stiffness depends
    on the curvature, the change of dM/dkappa with the shape is neglected.

    Parameters
    ----------
    rod : DiscreteRod
        Rod in equilibrium.
    weights : (n+1,) array
        Weights of the determinant Z at the midpoints of the edges and at the end.
    moments : (n+1,) array
        Bending moments of the nodes divided by the least bending stiffness, 1/mm.
    load_slope : (n+1, 2) array, optional
        Derivative of the weight of each node with respect to its stiffness K, 1/mm2. The derivative is load / K if
        the weight is proportional to K.
    """
    require_record(rod, DiscreteRod, "the rod", "a DiscreteRod")
    for name, values in (("weights", weights), ("moments", moments)):
        if numbers(values, name).shape != (rod.angles.size + 1,):
            raise InputError(
                f"{name} cannot be used: give an array ({rod.angles.size + 1},), with a number "
                "for each node of the rod"
            )
    n, lengths, T, rows = rod.angles.size, rod.edge_lengths, rod.tangents, rod.constraint_rows
    z = stability_determinant(rod)
    X, p = z.fields, z.fields.shape[1] - 1

    # propagate the derivatives back through the determinants and integrals
    G = weights[:, None, None] * _cofactors(_stability_matrices(X, z.integrals))
    suffix = G[:0:-1, 1:].cumsum(axis=0)[::-1]  # each term is in the integrals of all following edges
    per_field = G[:, 0].copy()
    per_field[:-1] += np.einsum("kp,kpm->km", rows.T, suffix)
    per_row = np.einsum("kpm,km->kp", suffix, X[1:-1])

    # propagate the derivatives back through the recursion
    adjoint = np.zeros((n + 2, 1 + p))
    adjoint[1:-1] = _solve_recursion(rod, per_field, transposed=True)[1:]
    per_spring = np.einsum("km,km->k", np.diff(adjoint, axis=0), np.diff(X, axis=0))
    per_pull = -np.einsum("km,km->k", adjoint[1:-1], X[1:-1])
    per_row -= adjoint[1:-1, 1:]

    # derivatives with respect to angles and forces, for a constant stiffness
    held = list(rod.held)
    per_angle = per_pull * lengths * rod.shear - lengths * np.einsum("kp,kp->k", per_row, T[:, held])
    per_force = (per_pull * lengths)[:, None] * T

    # propagate the derivatives back through the equations of equilibrium, whose Jacobian is symmetric
    y, _ = solve_bordered(*rod.hessian, rows, right=per_angle, below=per_force[:, held].sum(axis=0))
    per_force -= (lengths * y)[:, None] * left_of(T)
    gradient = per_spring / rod.node_lengths - moments / rod.stiffness * np.diff(y, prepend=0.0, append=0.0)
    gradient[turning_nodes(rod.supports)] = 0.0
    if load_slope is not None:
        start_holds, end_holds = rod.supports.held[:2], rod.supports.held[3:5]
        # a load changes the force in all following edges, or in all preceding edges if only the start holds the rod
        per_load = np.concatenate([per_force[::-1].cumsum(axis=0)[::-1], np.zeros((1, 2))])
        per_load -= per_load[0] * (start_holds & ~end_holds)
        per_load[0, start_holds] = 0.0
        gradient += np.einsum("kp,kp->k", load_slope, per_load)
    return np.asarray(gradient, dtype=float)


def conjugate_point(rod: DiscreteRod) -> float | None:
    """Return the first isoperimetric conjugate point from the start of the rod, mm, or None.

    The point is the length s of the shortest piece [0, s] of the rod that is not stable if the piece is clamped
    at s. The method is bisection on the number of unstable modes of the piece, which excludes the zero of the
    determinant at s = 0.
    """
    require_record(rod, DiscreteRod, "the rod", "a DiscreteRod, such as Rod.discrete")
    if not rod.held_angles[1]:
        raise InputError(
            "The conjugate point (the length at which the rod becomes unstable) can be computed only if the "
            "angle at the end of the rod is held, but this angle is free. If the angle at the start is held, "
            "reverse the rod."
        )
    (diagonal, off), rows, lengths = rod.hessian, rod.constraint_rows, rod.edge_lengths
    if diagonal.size <= len(rows) or not rod.unstable_modes:
        return None
    # number of edges of the shortest unstable piece that begins at the start
    count = bisect_left(
        range(diagonal.size), True,
        key=lambda k: k > len(rows) and bool(constrained_inertia(diagonal[:k], off[: k - 1], rows[:, :k])),
    )  # fmt: skip
    ends = lengths.cumsum()
    # entry k - 1 is the position of the clamp of a piece with k edges
    place = np.append(ends[:-1] + lengths[1:] / 2, ends[-1])
    if count == 1:
        return float(place[0])
    lower, upper = (
        float(lowest_constrained(diagonal[:k], off[: k - 1], rows[:, :k])[0][0]) if k > len(rows) else np.inf
        for k in (count - 1, count)
    )
    fraction = (
        1.0 if not np.isfinite(lower) or lower <= upper else float(np.clip(lower / (lower - upper), 0, 1))
    )
    return float(place[count - 2] + fraction * (place[count - 1] - place[count - 2]))


def _solve_recursion(rod: DiscreteRod, right: FloatArray, *, transposed: bool = False) -> FloatArray:
    """Solve the Jacobi recursion (a triangular system with three bands) for the values zeta_1 .. zeta_{n+1}."""
    spring = rod.stiffness / rod.node_lengths
    if not rod.held_angles[0]:
        spring[0] = 0.0
    band = np.zeros((3, rod.angles.size + 1))
    band[0, 0] = 1.0
    band[0, 1:] = spring[1:]
    band[1, :-1] = rod.edge_length * rod.pull - spring[:-1] - spring[1:]
    band[2, :-2] = spring[1:-1]
    solution, info = lapack().dtbtrs(band, right, uplo="L", trans="T" if transposed else "N")
    if info != 0 or not np.isfinite(solution).all():
        raise InputError(
            "the conjugate point (the length at which the rod becomes unstable) cannot be computed, because the "
            "tension in the rod is too large. Reduce the load"
        )
    return np.asarray(solution)


def _stability_matrices(fields: FloatArray, integrals: FloatArray) -> FloatArray:
    """Return the matrices (n + 1, m, m) whose determinants show conjugate points.

    Row 0 has the `fields` at the end of each part of the rod; the other rows have the `integrals` up to there.
    """
    n, _, m = integrals.shape
    Z = np.empty((n + 1, m, m))
    Z[:, 0] = fields[1:]
    Z[0, 1:] = 0.0
    Z[1:, 1:] = integrals
    return Z


def _cofactors(Z: FloatArray) -> FloatArray:
    """Return cofactor matrices (k, m, m) for m <= 3, which are exact even if the determinant is 0."""
    m = Z.shape[1]
    padded = np.tile(np.eye(3), (len(Z), 1, 1))
    padded[:, :m, :m] = Z
    return np.cross(padded[:, [1, 2, 0]], padded[:, [2, 0, 1]])[:, :m, :m]


# least margin of a rod that remains stable if it is cut and mounted inaccurately
SAFE_MARGIN = 5.0
# least margin of a rod that is rated stable, as a fraction of its margin when straight, without forces
UNLOADED_SHARE = 0.5


@dataclass(frozen=True, eq=False)
class Stability:
    """Result of `stability`.

    Attributes
    ----------
    stable : bool
        True if every small disturbance that the supports allow increases the energy.
    margin : float
        Lowest value of int (K h'^2 - <lambda, gamma'> h^2) ds / int h^2 ds, times length^2, over the changes
        h of the tangent's angle that the supports allow. K is the stiffness dM/dkappa, lambda the negative
        internal force, and gamma' the tangent. Positive means stable. Margins of different rods are
        comparable.
    mode : (n,) array
        Changes of angle at the nodes in the lowest mode, in which the rod buckles first; the largest is 1.
    negative : int
        Number of unstable modes.
    conjugate_point : float or None
        First isoperimetric conjugate point, mm of arc length from the start of the rod. None if the rod is stable.
        None also if the angle is free at both ends or the rod has rails, pins or ties, because the point is not
        defined then.
    started_from : {"start", "end"} or None
        End from which the conjugate point is computed; from the other end it has a different position.
    determinant_s, determinant : (n,) arrays
        Arc lengths from the start, mm, and stability determinant Z (paper, Fig. 9); empty if not defined. Z has a
        zero of high order at `started_from`.
    borderline : bool
        True if the margin is smaller than its rounding error; `stable` is then False.
    safe : float
        Least margin that is rated stable: `SAFE_MARGIN`, or half the margin of the straight rod without forces if
        this is less. It is less for a rod with a free end: there a margin below 5 does not mean that it can snap.
    """

    stable: bool
    margin: float
    mode: FloatArray = field(repr=False)
    negative: int
    conjugate_point: float | None
    started_from: Literal["start", "end"] | None
    determinant_s: FloatArray = field(repr=False)
    determinant: FloatArray = field(repr=False)
    borderline: bool
    safe: float = SAFE_MARGIN

    def __str__(self) -> str:
        return note(
            "{word} (stability margin {margin:.3g}): {meaning}",
            word=note(self.rating), margin=self.margin, meaning=note(self.meaning),
        )  # fmt: skip

    @property
    def word(self) -> Literal["unstable", "low", "ample"]:
        """Rating of the margin by the limits 0 and `safe`: unstable, low or ample."""
        if not self.stable:
            return "unstable"
        return "low" if self.margin < self.safe else "ample"

    @property
    def rating(self) -> str:
        """Rating of the margin as shown to users."""
        return {"unstable": "unstable", "low": "close to snapping", "ample": "stable"}[self.word]

    @property
    def meaning(self) -> str:
        """Practical meaning of the margin, in a sentence."""
        return {
            "unstable": "the strip is in equilibrium, but any push makes it snap into another shape",
            "low": "the strip keeps its shape, but a push, a loose clamp or an inaccurate cut can make it "
            "snap",
            "ample": "the strip keeps its shape, and springs back when pushed",
        }[self.word]


def stability(rod: Rod) -> Stability:
    """Return the stability of a rest shape with its weight, supports, rails, pins and ties.

    Two independent methods must agree: the number of negative eigenvalues of the constrained second variation
    (LDL^t), and its lowest eigenvalue (inverse iteration).
    The result also contains the stability determinant of the Jacobi equation (paper, section 6.2). The
    determinant is valid with weight too, because weight changes only the force. All methods use the stiffness
    dM/dkappa (`Rod.tangent_stiffness`). For a wide strip (`section`) that becomes stiffer when it is bent, it
    is up to a tenth more than M / kappa.

    Parameters
    ----------
    rod : Rod
        Rod in equilibrium, from `optimal_rod`, `bend` or `nearest_rod`.

    Raises
    ------
    NotConvergedError
        The two methods disagree.

    Examples
    --------
    >>> from elastica_cad.mechanics.rod import Rod
    >>> from elastica_cad.mechanics.bending import bend
    >>> arch = bend(Rod.straight(100.0, samples=101), end=(70.0, 0.0))
    >>> stability(arch).stable
    True
    """
    require_rod(rod, "stability")
    if rod.residual > 0.05:
        raise InputError(
            f"the rod is not in equilibrium (residual {rod.residual:.2g}): pass the result of `bend`"
        )
    discrete = rod.discrete
    negative, margin = discrete.unstable_modes, discrete.margin
    scale = float(np.abs(discrete.hessian[0]).max()) * discrete.angles.size * rod.length
    borderline = abs(margin.value) <= 64 * float(np.finfo(float).eps) * scale
    if not borderline and (negative == 0) != (margin.value > 0):
        raise NotConvergedError(
            "The stability is undecided, because two computations disagree: {negative} unstable modes, but "
            "a margin of {given:.6g}. Compute the rod with more nodes.",
            negative=negative,
            given=margin.value,
        )

    started_from: Literal["start", "end"] | None = None
    place, s, value = None, np.zeros(0), np.zeros(0)
    if any(discrete.held_angles) and discrete.bracing is None:
        # the conjugate point needs a held angle at the end that is not the starting point
        started_from = "start" if discrete.held_angles[1] else "end"
        counted = discrete if started_from == "start" else discrete.reversed()
        z = stability_determinant(counted)
        place, s, value = conjugate_point(counted), z.s, z.value
    if started_from == "end":
        place = None if place is None else rod.length - place
        s, value = rod.length - s[::-1], value[::-1]
    turning = turning_nodes(discrete.supports)
    # the mode is 0 at an end with a held angle
    nodal = np.pad(midpoints(margin.mode), 1)
    nodal[turning] = margin.mode[turning]
    return Stability(
        stable=negative == 0 and not borderline, margin=margin.value, mode=nodal / nodal[np.abs(nodal).argmax()],
        negative=negative, conjugate_point=place, started_from=started_from, determinant_s=s,
        determinant=value, borderline=borderline, safe=_safe_margin(discrete),
    )  # fmt: skip


def _safe_margin(rod: DiscreteRod) -> float:
    if rod.bracing is not None or not 0 < rod.margin.value < SAFE_MARGIN:
        return SAFE_MARGIN
    # the margin of the straight rod matters only in this case; see `Stability.safe`
    chord = rod.position[-1] - rod.position[0]
    straight = replace(rod, angles=np.full(rod.angles.size, angle_of(chord)), force=np.zeros_like(rod.force))
    return min(SAFE_MARGIN, UNLOADED_SHARE * straight.margin.value)
