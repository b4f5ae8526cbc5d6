"""The smooth curve of a discrete rod: as long as the rod, with its end positions and end angles."""

from collections.abc import Callable
from functools import lru_cache
from typing import TypeAlias

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.polynomials.spline_fits import adaptive_spline
from elastica_cad.geometry.polynomials.splines import bezier_spans, spline_through
from elastica_cad.mechanics.rod.discrete_rod import tangents

Angle: TypeAlias = Callable[[FloatArray], FloatArray]

EVEN_EDGES = 1e-7  # of an edge: nodes that are samples of a curve are closer than that by (kappa h)^2 / 24
TANGENT_RAD = 1e-8  # how closely the spline follows the tangent: over the length, far below a micrometre
DEGREE = 5  # curvature with two derivatives, which checks of equilibrium look at
MOST_SPANS, NODES_PER_SPAN = 24, 6  # of the spline that corrects the angle: at most, at least
REACH_LENGTHS = (
    0.05  # in lengths: changes of curvature over that distance weigh as much as the displacement they make
)
NEWTON_STEPS, MET = 8, 1e-13  # at most; of angles in rad and of the end over the length: rounding
GAUSS_POINTS, GAUSS_WEIGHTS = np.polynomial.legendre.leggauss(6)


def has_even_edges(s: FloatArray, position: FloatArray) -> bool:
    """Are all edges of the polygon of nodes as long as the arc length between them?"""
    h = np.diff(s)
    return bool(np.all(np.abs(np.hypot(*np.diff(position, axis=0).T) - h) <= EVEN_EDGES * h))


def integrate_edges(s: FloatArray, position: FloatArray, angle: FloatArray) -> PlaneCurve:
    """The spline of unit speed that follows the edges of a discrete rod.

    The edges of a discrete rod (paper, section 7.1) are tangents of a smooth curve in their middles. A curve of
    the polygon's own length passes the nodes at h^2 |kappa| / 24 on their inner side: this one integrates a quintic
    spline through the edge angles. That is h^2 |kappa'| / 8 off the held angles; of all smooth turns that meet
    them and the end position, the one that displaces the curve least is added.

    Parameters
    ----------
    s : (n,) array
        Arc lengths of the nodes, mm, uniform.
    position : (n, 2) array
        Nodes, mm, with edges as long as their arc lengths.
    angle : (n,) array
        rad; the ends are held.

    Returns
    -------
    PlaneCurve
        Degree 5, its parameter is arc length (to 1e-8).

    Examples
    --------
    >>> s = np.linspace(0.0, 30.0, 61)
    >>> middles = (s[:-1] + s[1:]) / 20
    >>> steps = 0.5 * np.column_stack([np.cos(middles), np.sin(middles)])
    >>> nodes = np.concatenate([np.zeros((1, 2)), np.cumsum(steps, axis=0)])
    >>> curve = integrate_edges(s, nodes, s / 10)
    >>> off = np.hypot(*(curve.at(s).position - nodes).T).max()
    >>> round(curve.length, 7), bool(off < 3 * 0.5**2 / 10 / 24)
    (30.0, True)
    """
    edge = edge_angles(position, angle)
    if edge.size == 1:
        knots = np.repeat(s, DEGREE + 1)
        return PlaneCurve(knots, np.linspace(position[0], position[1], DEGREE + 1), DEGREE)
    degree = min(DEGREE, edge.size - 1)
    through = spline_through((s[:-1] + s[1:]) / 2, edge, degree)
    turn = _least_turn(s, position, angle[[0, -1]], through)
    length = float(s[-1])

    def tangent(at: FloatArray) -> FloatArray:
        return tangents(through(at) + turn(at))

    knots, rows = adaptive_spline(tangent, (0.0, length), degree=DEGREE - 1, tolerance=TANGENT_RAD)
    reach = (knots[DEGREE:] - knots[:-DEGREE]) / DEGREE  # of a basis function's integral
    points = position[0] + np.pad(np.cumsum(reach[:, None] * rows, axis=0), ((1, 0), (0, 0)))
    return PlaneCurve(np.pad(knots, 1, mode="edge"), points, DEGREE)


def _least_turn(s: FloatArray, position: FloatArray, held: FloatArray, angle: Angle) -> Angle:
    """The spline to be added to `angle` (rad over arc length) for the ends to be met, moving the nodes least."""
    length, h = float(s[-1]), np.diff(s)[:, None]
    weight = h * GAUSS_WEIGHTS / 2
    knots, places, basis, at_ends, bend = _turn_basis(length, h.size)
    c = np.zeros(basis.shape[-1])
    for _ in range(NEWTON_STEPS):
        alpha = angle(places) + basis @ c
        T = tangents(alpha.ravel()).reshape(*places.shape, 2)
        N = np.stack([-T[..., 1], T[..., 0]], axis=-1)
        missed = position[1:] - position[0] - np.cumsum(np.einsum("eg,egk->ek", weight, T), axis=0)
        moves = np.cumsum(np.matmul((weight[..., None] * N).transpose(0, 2, 1), basis), axis=0)
        across = N[:, -1]
        rows = np.concatenate([np.einsum("ek,ekm->em", across, moves), bend])
        wanted = np.concatenate([np.einsum("ek,ek->e", across, missed), -np.einsum("em,m->e", bend, c)])
        held_rows = np.concatenate([at_ends, moves[-1] / length])
        held_by = np.concatenate([held - angle(s[[0, -1]]) - at_ends @ c, missed[-1] / length])
        if np.abs(held_by).max() < MET:
            break
        # by einsum, as the threads of BLAS would cost ten times the product
        square = np.einsum("ri,rj->ij", rows, rows) / length**2 / h.size
        pull = np.einsum("ri,r->i", rows, wanted) / length**2 / h.size
        corner = np.zeros((held_by.size,) * 2)
        system = np.block([[square, held_rows.T], [held_rows, corner]])
        right = np.concatenate([pull, held_by])
        c = c + np.linalg.lstsq(system, right, rcond=1e-13)[0][: c.size]
    from scipy.interpolate import BSpline

    turn: Angle = BSpline(knots, c, DEGREE)
    return turn


@lru_cache(maxsize=4)
def _turn_basis(length: float, edges: int) -> tuple[FloatArray, ...]:
    """Knots, Gauss points, and the turn's splines there, at the ends, and their differences between nodes."""
    s = np.linspace(0.0, length, edges + 1)
    h = length / edges
    spans = max(1, min(MOST_SPANS, edges // NODES_PER_SPAN))
    knots = np.pad(np.linspace(0.0, length, spans + 1), DEGREE, mode="edge")
    places = s[:-1, None] + h * (1 + GAUSS_POINTS) / 2
    turns = bezier_spans(knots, DEGREE)
    between = np.diff(turns.basis(s), axis=0) / h * (REACH_LENGTHS * length) ** 2
    at_places = turns.basis(places.ravel()).reshape(*places.shape, -1)
    return knots, places, at_places, turns.basis(s[[0, -1]]), between


def edge_angles(position: FloatArray, angle: FloatArray) -> FloatArray:
    """Angles (n,) of the edges between nodes (n + 1, 2), on the turn of the nodes' angles (n + 1,)."""
    edge = np.arctan2(*np.diff(position, axis=0).T[::-1])
    middle = (angle[:-1] + angle[1:]) / 2
    return np.asarray(edge + 2 * np.pi * np.round((middle - edge) / (2 * np.pi)))
