"""A rod's rest shape as a spline of degree 4 with few control points, for further editing."""

from dataclasses import dataclass

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.errors import NotConvergedError
from elastica_cad.forming.dense import gram
from elastica_cad.forming.march import MarchedRod, StripGrid
from elastica_cad.geometry import PlaneCurve
from elastica_cad.mechanics import Rod

__all__ = ["editable_curve"]

DEGREE = 4
TOLERANCE = 1e-3  # mm between curve and rod
FAITHFUL = 4e-4  # relative error of the extremes of the stiffness that the curve asks for
LOOSE = 0.02  # and of the stiffness between
_REACH = 0.05  # curvature errors that extend this far weigh as much as the displacement they make
_SPANS, _MOST_SPANS = 24, 240
_STIFF = (1e-9, 1e-6, 1e-3, np.inf)  # against moving coefficients of the stiffness, tried in turn
_FINE = 4  # the continuous rod is extrapolated from 4 and 8 times as many edges


def editable_curve(rod: Rod, *, tangents: tuple[bool, bool] = (False, False)) -> PlaneCurve:
    """The spline of degree 4 that the continuous rod with the stiffness of a discrete one takes.

    The discrete rod of n edges is off the continuous one by O(1/n^2), which the curvature near inflections would
    show. So the continuous rod of the same stiffness through the same ends is computed first, and the spline
    fits its curvature as well as its position; at its inflections the spline meets it exactly, so that they lie on
    one line without weight (Theorem 1).

    Parameters
    ----------
    rod : Rod
        In balance.
    tangents : (bool, bool)
        Whether the start and the end keep the discrete rod's tangent exactly.

    Raises
    ------
    NotConvergedError
        The continuous rod or the fit did not reach its tolerance.
    """
    shape = _continuous(rod, tangents)
    edges = np.linspace(0, float(shape.s[-1]), _SPANS + 1)
    while edges.size <= _MOST_SPANS:
        curve = _fitted(shape, edges)
        error = _errors(curve, shape)
        if error.max() <= 1:
            return _in_millimetres(curve, rod)
        edges = _refined(edges, shape.s[1:-1][error > 1])
    raise NotConvergedError(
        f"the rest shape of {rod.length:.6g} mm cannot be written as a spline of degree 4 with {_MOST_SPANS} "
        "spans: use rod.curve, or fewer coefficients"
    )


def _refined(edges: FloatArray, places: FloatArray) -> FloatArray:
    """Halves the widest of the spans that hold `places` and their neighbours: jumps in width would ring."""
    width = np.diff(edges)
    bad = np.searchsorted(edges, places, side="right") - 1
    bad = np.unique(np.clip(np.concatenate([bad - 1, bad, bad + 1]), 0, width.size - 1))
    bad = bad[width[bad] > 0.6 * width[bad].max()]
    return np.sort(np.concatenate([edges, edges[bad] + width[bad] / 2]))


@dataclass(frozen=True, eq=False)
class _Shape:
    """A continuous rod at uniform stations, in lengths of the discrete one.

    s, angle, curvature, stiffness (k,), position (k, 2); inflections are station-free: (s, position, angle).
    """

    s: FloatArray
    position: FloatArray
    angle: FloatArray
    curvature: FloatArray
    stiffness: FloatArray
    inflections: FloatArray
    size: float

    def at(self, s: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Position, angle, curvature at arc lengths s, by cubic splines through the stations."""
        from scipy.interpolate import make_interp_spline

        table = np.column_stack([self.position, self.angle, self.curvature])
        values = make_interp_spline(self.s, table, k=5)(s)
        return values[:, :2], values[:, 2], values[:, 3]

    def slope(self, s: FloatArray) -> FloatArray:
        """Derivative of the curvature at arc lengths s."""
        from scipy.interpolate import make_interp_spline

        return np.asarray(make_interp_spline(self.s, self.curvature, k=5)(s, nu=1))


def _continuous(rod: Rod, tangents: tuple[bool, bool]) -> _Shape:
    """The continuous rod nearest to the discrete one with the same ends (and tangents, where asked)."""
    size = rod.length
    n = rod.s.size - 1
    e = np.zeros(2) if rod.gravity is None else rod.gravity.e * size**3
    coarse, middle, fine = (_grid(rod, n * k, e) for k in (1, _FINE, 2 * _FINE))
    u = coarse.unknowns
    z = np.concatenate(
        [
            rod.profile.coefficients, [rod.moment[0] * size], rod.force[0] * size**2,
            np.zeros(2), [rod.angle[0], 1.0],
        ]
    )  # fmt: skip
    target = (rod.position - rod.position[0]) / size
    start, end = rod.supports.ends
    fixed = [u.position.start, u.position.start + 1]
    fixed += [u.angle] if tangents[0] else []
    fixed += [] if start.angle else [u.moment]
    fixed += [u.force.start + axis for axis, held in enumerate((start.x, start.y)) if not held]
    # coefficients that touch neither extreme may give way a little, so that the shape stays on the nodes
    c, room = rod.profile.coefficients, 1e-3 * np.ptp(rod.profile.coefficients)
    fixed += np.flatnonzero((c < c.min() + room) | (c > c.max() - room)).tolist()
    free = np.setdiff1d(np.arange(u.count), fixed)
    for stiff in _STIFF:
        part = free if np.isfinite(stiff) else free[free >= u.moment]
        found = _closed(rod, (coarse, middle, fine), z, part, stiff, target, tangents)
        if found is not None:
            return _shape(found, (middle.rod(found), fine.rod(found)), size, middle.natural_curvature)
    raise NotConvergedError(
        "the continuous rod does not reach the ends of the discrete one: it is about to snap; use more samples"
    )


def _closed(
    rod: Rod, grids: tuple[StripGrid, StripGrid, StripGrid], z: FloatArray, free: IntArray, stiff: float,
    target: FloatArray, tangents: tuple[bool, bool],
) -> FloatArray | None:  # fmt: skip
    """Unknowns of the continuous rod nearest to `target` that meets the ends; None without convergence.

    Newton's method with the sensitivities of the coarse rod; positions by Richardson's extrapolation.
    """
    coarse, middle, fine = grids
    u, m = coarse.unknowns, free.size
    hinged = not rod.supports.ends[1].angle
    z = z.copy()
    for _ in range(12):
        d = coarse.sensitivities(coarse.rod(z))
        J = d.position.reshape(-1, u.count)[:, free]
        exact = [d.position[-1]] + [d.angles[-1:]] * tangents[1] + [d.moments[-1:]] * hinged
        C = np.concatenate(exact)[:, free]
        scale = np.sqrt((J**2).sum(axis=0))
        J, C = J / scale, C / scale
        a, b = middle.rod(z), fine.rod(z)
        position = (4 * b.position[:: 2 * _FINE] - a.position[::_FINE]) / 3
        missing = [position[-1] - target[-1]]
        if tangents[1]:
            missing.append(np.atleast_1d((4 * b.angles[-1] - a.angles[-1]) / 3 - rod.angle[-1]))
        if hinged:
            missing.append(np.atleast_1d((4 * b.moments[-1] - a.moments[-1]) / 3))
        gap = np.concatenate(missing)
        normal = gram(J) + np.diag(np.where(free < u.moment, min(stiff, 1.0), 1e-14))
        system = np.block([[normal, C.T], [C, np.zeros((gap.size, gap.size))]])
        step = np.linalg.lstsq(system, np.concatenate([-J.T @ (position - target).ravel(), -gap]), rcond=1e-15)[0]
        size = float(np.abs(step[:m]).max())
        if not np.isfinite(size):
            return None
        z[free] += step[:m] / scale
        if size < 1e-11 and np.abs(gap).max() < 1e-11:
            return z
    return z if np.abs(gap).max() < 1e-9 and size < 1e-6 else None


def _grid(rod: Rod, edges: int, e: FloatArray) -> StripGrid:
    from scipy.interpolate import BSpline

    profile = rod.profile
    x = np.clip(np.linspace(0, 1, edges + 1), 0, 1)
    basis = BSpline.design_matrix(x, profile.knots / profile.length, profile.degree).toarray()
    kappa_0 = np.asarray(rod.natural_curvature, dtype=float) * rod.length
    if kappa_0.ndim:
        kappa_0 = np.interp(x, np.linspace(0, 1, kappa_0.size), kappa_0)
    return StripGrid(np.asarray(basis), e, kappa_0)


def _shape(z: FloatArray, rods: tuple[MarchedRod, MarchedRod], size: float, natural: float | FloatArray) -> _Shape:
    """Richardson's extrapolation of positions and moments; angles by Hermite from the edges' mean."""
    a, b = rods
    position = (4 * b.position[::2] - a.position) / 3
    moment = (4 * b.moments[::2] - a.moments) / 3
    angle = (4 * _nodal(b)[::2] - _nodal(a)) / 3
    s = np.linspace(0, 1, position.shape[0])
    K = a.stiffness
    kappa = moment / K + natural
    return _Shape(s * z[-1], position, angle, kappa, K, _zeros(s * z[-1], kappa), size)


def _nodal(rod: MarchedRod) -> FloatArray:
    """Angles at the nodes: the ends', and the mean of the two edges that meet."""
    inner = (rod.angles[1:-2] + rod.angles[2:-1]) / 2
    return np.concatenate([rod.angles[:1], inner, rod.angles[-1:]])


def _zeros(s: FloatArray, kappa: FloatArray) -> FloatArray:
    """Arc lengths where the curvature changes sign, not at the very ends."""
    from scipy.interpolate import make_interp_spline
    from scipy.optimize import brentq

    spline = make_interp_spline(s, kappa, k=5)
    where = np.flatnonzero(kappa[:-1] * kappa[1:] < 0)
    return np.array([brentq(spline, s[i], s[i + 1], xtol=1e-15) for i in where])


def _fitted(shape: _Shape, edges: FloatArray) -> PlaneCurve:
    """Least squares for position and curvature over given knots, exact at the ends and the inflections.

    At an inflection also the slope of the curvature is met, which is what the stiffness there is made of.
    """
    from scipy.interpolate import BSpline

    knots = np.concatenate([np.full(DEGREE, edges[0]), edges, np.full(DEGREE, edges[-1])])
    spline = BSpline(knots, np.eye(edges.size - 1 + DEGREE), DEGREE)
    gauss, share = np.polynomial.legendre.leggauss(5)
    half = np.diff(edges)[:, None] / 2
    s = (edges[:-1, None] + half + half * gauss).ravel()
    root = np.sqrt(half * share)
    position, angle, kappa = shape.at(s)
    normal = np.column_stack([-np.sin(angle), np.cos(angle)])
    typical = float(np.sqrt(np.mean(kappa**2))) + 1e-6
    w = root.ravel() * _REACH**2 * typical / (np.abs(kappa) + 0.1 * typical)
    A = np.vstack([root.ravel()[:, None] * spline(s), w[:, None] * spline(s, 2)])
    B = np.vstack([root.ravel()[:, None] * position, (w * kappa)[:, None] * normal])
    ends, bends = edges[[0, -1]], shape.inflections
    # beside an end the end's own rows leave no freedom for more than the zero of the curvature
    inner = bends[np.abs(bends[:, None] - ends).min(axis=1, initial=np.inf) > 2 * np.diff(edges).max()]
    there, turned, _ = shape.at(np.concatenate([ends, inner]))
    along = np.column_stack([np.cos(turned), np.sin(turned)])
    across = np.column_stack([-along[2:, 1], along[2:, 0]])
    C = np.vstack([spline(np.concatenate([ends, inner])), spline(ends, 1), spline(bends, 2), spline(inner, 3)])
    slope = shape.slope(inner)[:, None]
    D = np.vstack([there, along[:2], np.zeros((bends.size, 2)), slope * across])
    return PlaneCurve(knots, _constrained_least_squares(A, B, C, D), DEGREE)


def _constrained_least_squares(A: FloatArray, B: FloatArray, C: FloatArray, D: FloatArray) -> FloatArray:
    """X that minimises |A X - B| subject to C X = D; A^T A has the band of the splines."""
    from scipy.linalg import cho_solve_banded, cholesky_banded

    m = A.shape[1]
    joined = gram(np.hstack([A, B]))
    band = np.zeros((DEGREE + 1, m))
    for k in range(DEGREE + 1):
        band[k, : m - k] = np.diagonal(joined[:m, :m], -k)
    factor = cholesky_banded(band, lower=True)
    size = np.linalg.norm(C, axis=1)[:, None]
    C, D = C / size, D / size
    X = cho_solve_banded((factor, True), joined[:m, m:])
    Y = cho_solve_banded((factor, True), C.T)
    schur = C @ Y
    for _ in range(3):
        X = X + Y @ np.linalg.solve(schur, D - C @ X)
    return np.asarray(X)


def _errors(curve: PlaneCurve, shape: _Shape) -> FloatArray:
    """The worst error at the inner stations, in tolerances: of position, of the stiffness that the curve asks
    for, and, stricter, of its extremes."""
    s, kappa, K = shape.s[1:-1], shape.curvature[1:-1], shape.stiffness[1:-1]
    off = np.hypot(*(curve.evaluate(s) - shape.position[1:-1]).T) * shape.size / TOLERANCE
    near = np.abs(s[:, None] - shape.inflections).min(axis=1, initial=np.inf) < 1e-3 * s[-1]
    with np.errstate(divide="ignore", invalid="ignore"):
        asked = np.where(near, K, K * kappa / curve.curvature_at(s))
    beyond = np.maximum(asked / shape.stiffness.max() - 1, 1 - asked / shape.stiffness.min()) / FAITHFUL
    beyond = np.where(asked > 0, beyond, np.inf)
    return np.nan_to_num(np.maximum.reduce([off, beyond, np.abs(asked / K - 1) / LOOSE]), nan=0.0)


def _in_millimetres(curve: PlaneCurve, rod: Rod) -> PlaneCurve:
    return PlaneCurve(curve.knots * rod.length, curve.control_points * rod.length + rod.position[0], DEGREE)
