"""How widths must change for a strip that strays to come back to its design, to first order."""

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.fabrication.holding.lap_joint import closes
from elastica_cad.geometry.polynomials.splines import bezier_spans
from elastica_cad.mechanics.rod.banded_matrices import solve_tridiagonal
from elastica_cad.mechanics.rod.rod_record import Rod

SPACING_SHARE = 1 / 24  # of the length: between knots of a correction, so that outlines stay smooth
SIZE = 1e-2  # the same of the coefficients themselves: of many changes that serve, the smallest


def width_basis(s: FloatArray, *, closed: bool = False) -> FloatArray:
    """Cubic B-splines (n, m) at even stations s (n,) of a strip; of a closed one both ends share theirs."""
    pieces = round(1 / SPACING_SHARE)
    knots = np.concatenate([np.zeros(3), np.linspace(0.0, s[-1], pieces + 1), np.full(3, s[-1])])
    one = np.eye(pieces + 3)
    if closed:
        one[0, -1] = 1.0
        one = one[:, 1:]
    return np.asarray(bezier_spans(knots, 3).basis(s) @ one)


def correct_widths(
    made: Rod,
    drift: FloatArray,
    basis: FloatArray,
    kept: FloatArray,
    *,
    damping: float,
    smoothing: float,
    largest: float,
) -> FloatArray:
    """Coefficients (m,) of the change of width that takes a drift back, to first order.

    A change f of the width changes moment and weight by M f and p f at the same shape; the shape answers by
    H d(alpha) + C^t d(lambda) = -d(imbalance), C d(alpha) = 0, with the Hessian H of the discrete energy (paper,
    section 7.1) and the rows C of the ends. Many changes leave the shape alone (all that keep K kappa = M0 + <b,
    gamma>); the smallest and smoothest one is taken.

    Parameters
    ----------
    made : Rod
        As made and held, in balance.
    drift : (n, 2) array
        Of its nodes from the design, mm.
    basis : (n, m) array
        Of the changes: see `width_basis`. Of a closed strip only its shape counts, not where it lies.
    kept : (m,) array
        Coefficients of the change that the rod has already.
    smoothing : float
        Weight of the second differences of the coefficients against the drift that is left.
    damping : float
        Weight of the step against the drift, relative: larger for shorter steps.
    largest : float
        No coefficient goes beyond it.
    """
    rod, n = made.discrete, made.s.size
    diagonal, off = rod.hessian
    moment = made.moment[:, None] * basis
    load = np.zeros((n - 1, basis.shape[1], 2))
    load[1:] = np.cumsum(made.nodal_load[1:-1, None, :] * basis[1:-1, :, None], axis=0)
    tangents = rod.tangents
    shear = load[..., 1] * tangents[:, None, 0] - load[..., 0] * tangents[:, None, 1]
    lengths = rod.edge_lengths[:, None]
    imbalance = moment[:-1] - moment[1:] + lengths * shear
    rows = rod.constraint_rows
    answers = solve_tridiagonal(diagonal, off, np.hstack([-imbalance, rows.T]))
    free, forced = answers[:, : basis.shape[1]], answers[:, basis.shape[1] :]
    turned = free - forced @ np.linalg.solve(rows @ forced, rows @ free) if len(rows) else free
    normals = np.column_stack([-tangents[:, 1], tangents[:, 0]])
    moved = np.cumsum(lengths[..., None] * turned[..., None] * normals[:, None, :], axis=0)
    A, left = np.moveaxis(moved, 1, 2).reshape(-1, basis.shape[1]), drift[1:].ravel()
    if closes(made):
        A, left = _without_motion(made.position[1:], A), _without_motion(made.position[1:], left)
    scale = float(np.abs(A).max()) * np.sqrt(len(A))
    one = np.eye(basis.shape[1])
    bends = np.diff(one, n=2, axis=0)
    # the step is damped; the whole change is to be small and smooth
    whole = np.concatenate([smoothing * bends, SIZE * one])
    system = np.concatenate([A, damping * scale * one, scale * whole])
    wanted = np.concatenate([-left, np.zeros(len(one)), -scale * whole @ kept])
    step = np.linalg.lstsq(system, wanted, rcond=None)[0]
    if np.abs(kept + step).max() > largest:
        from scipy.optimize import lsq_linear

        bounds = (-largest - kept, largest - kept)
        step = lsq_linear(system, wanted, bounds, method="bvls").x
    return np.asarray(kept + step)


def _without_motion(position: FloatArray, moves: FloatArray) -> FloatArray:
    """Moves (2 n, ...) of points (n, 2) without what shifts and turns them all."""
    x, y = (position - position.mean(axis=0)).T
    one, none = np.ones(x.size), np.zeros(x.size)
    rigid = np.array([np.column_stack(row).ravel() for row in ((one, none), (none, one), (-y, x))])
    rigid /= np.linalg.norm(rigid, axis=1)[:, None]
    return np.asarray(moves - rigid.T @ (rigid @ moves))
