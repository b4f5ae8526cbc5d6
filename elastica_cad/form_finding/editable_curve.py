"""Rest shape of a rod as a spline of degree 4 with few control points, for further editing."""

from collections.abc import Iterable, Iterator
from contextlib import suppress
from dataclasses import dataclass, replace

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import Length, NotConvergedError
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.geometry.plane_points import left_of, norm, unit_vectors
from elastica_cad.geometry.splines import bezier_spans, clamped_knots, spline_through
from elastica_cad.mechanics.bending import bend, has_snapped
from elastica_cad.mechanics.rod import Rod

DEGREE = 4  # least degree for which the curvature has a continuous derivative
STRAIGHT_RAD = 1e-9  # largest change of direction along a rod, rad, that is only a rounding error
# largest distance between curve and rod, mm; less than the repeatability of a laser cutter
TOLERANCE_MM = 1e-3
# largest relative error of the least and the largest stiffness, small enough for the rod to meet its limits
FAITHFUL = 3e-4
LOOSE = 0.02  # largest relative error of the stiffness away from its smallest and largest value
# fraction of the largest curvature below which rounding errors dominate the computed stiffness
UNBENT_SHARE = 2e-3
# initial and largest number of knot spans: few initially, because users edit the control points
_FIRST_SPANS, _MOST_SPANS = 24, 240
# inflections closer to an end than this fraction of the rod's length count as inflections at the end
_SAME_LENGTHS = 1e-6
# the two rods of the extrapolation have 4 and 8 times as many edges as the given rod
_FINER = 4


def editable_curve(rod: Rod) -> PlaneCurve:
    """Return the shape of a discrete rod as a spline of degree 4.

    The discretisation error O(1/n^2) of a rod with n edges would disturb the curvature near inflections. Therefore
    the spline is fitted to position and curvature of the continuous rod with the same stiffness and ends. The
    spline contains the inflections exactly, so that they are on one line if the rod has no weight (paper,
    Theorem 1).

    Parameters
    ----------
    rod : Rod
        Rod in equilibrium.

    Raises
    ------
    NotConvergedError
        The continuous rod or the fit did not reach its tolerance.
    """
    if np.abs(rod.curvature).max() * rod.length < STRAIGHT_RAD:
        return PlaneCurve.line(rod.position[0], rod.position[-1], degree=DEGREE)
    shape = _continuous(rod)
    edges = np.linspace(0, float(shape.s[-1]), _FIRST_SPANS + 1)
    least, best = np.inf, None
    # shorter knot spans, as fractions of the length, are near rounding errors
    while edges.size <= _MOST_SPANS and np.diff(edges).min() > 1e-3:
        curve = _fitted(shape, edges)
        error = _errors(curve, shape)
        if error.max() < least:
            least, best = error.max(), curve
        if least <= 1:
            break
        # halve the wide ones of the spans that are too inexact, and of the spans beside them
        width = np.diff(edges)
        bad = edges.searchsorted(shape.s[error > 1], side="right") - 1
        bad = np.unique(np.concatenate([bad - 1, bad, bad + 1]).clip(0, width.size - 1))
        bad = bad[width[bad] > 0.6 * width[bad].max()]
        edges = np.sort(np.concatenate([edges, edges[bad] + width[bad] / 2]))
    # accept the best fit if its error is at most twice the tolerance
    if best is None or least > 2.0:
        raise NotConvergedError(
            "the bent curve, {length:.6g} long, is too complex for a spline of degree 4 with {most_spans} "
            "spans: use `rod.curve`, or compute the rod with fewer `coefficients`",
            length=Length(rod.length),
            most_spans=_MOST_SPANS,
        )
    return _in_millimetres(best, rod)


def coarse_curves(rod: Rod, spans: Iterable[int]) -> Iterator[PlaneCurve]:
    """Yield the shape of a rod as splines with only these numbers of equal knot spans.

    Their inflections are on one line. They only approximate the rod and may violate limits that the rod meets. A
    spline with too few spans for the inflections is left out.

    Raises
    ------
    NotConvergedError
        The continuous rod was not found.
    """
    shape = _continuous(rod)
    for count in spans:
        with suppress(np.linalg.LinAlgError):
            yield _in_millimetres(_fitted(shape, np.linspace(0, float(shape.s[-1]), count + 1)), rod)


@dataclass(frozen=True, eq=False)
class _Shape:
    """Values of a continuous rod at n evenly spaced stations, in units of its length `size`, mm.

    `rest` (n,) is the natural curvature, and `stiffness` (n,) is relative. `inflections` (j,) are the arc lengths
    where the moment is 0, including ends that are free to turn.
    """

    s: FloatArray
    position: FloatArray
    angle: FloatArray
    curvature: FloatArray
    stiffness: FloatArray
    rest: FloatArray
    inflections: FloatArray
    size: float

    def at(self, s: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        # positions (k, 2), angles (k,) and curvatures (k,) at arc lengths (k,)
        values = spline_through(self.s, np.column_stack([self.position, self.angle, self.curvature]), 5)(s)
        return values[:, :2], values[:, 2], values[:, 3]

    def slope(self, s: FloatArray) -> FloatArray:
        return spline_through(self.s, self.curvature, 5)(s, 1)


def _continuous(rod: Rod) -> _Shape:
    """Return the continuous rod, extrapolated from rods with 4 and 8 times as many edges.

    The error for n edges is a power series in 1/n^2.
    """
    from scipy.interpolate import make_interp_spline
    from scipy.optimize import brentq

    plain, edges = replace(rod, section=None, law=None), rod.s.size - 1
    a, b = (bend(plain, samples=factor * edges + 1) for factor in (_FINER, 2 * _FINER))
    if has_snapped(a) or has_snapped(b):
        raise NotConvergedError(
            "the ends of the rod cannot be reached with finer steps, because the rod is close to snapping: "
            "use more samples"
        )
    position, angle, curvature, K = (
        (4 * getattr(b, name)[::2] - getattr(a, name)) / 3
        for name in ("position", "angle", "curvature", "stiffness")
    )
    s, size = np.linspace(0, 1, K.size), rod.length
    kappa_0 = np.broadcast_to(rod.natural_curvature, rod.s.shape)
    kappa_0 = np.interp(s, rod.s / size, kappa_0)
    change = curvature - kappa_0
    spline = make_interp_spline(s, change, k=5)
    # arc lengths at which the quintic spline through the change of curvature is 0
    where = np.flatnonzero(change[:-1] * change[1:] < 0)
    bends = np.array([brentq(spline, s[i], s[i + 1], xtol=1e-15) for i in where])
    start, end = rod.supports.ends
    # at an end that is free to turn, drop nearby zeros of the moment, which are rounding errors of the zero
    # at the end
    bends = bends[(start.angle | (bends > _SAME_LENGTHS)) & (end.angle | (bends < 1 - _SAME_LENGTHS))]
    bends = np.concatenate([s[:1][: not start.angle], bends, s[-1:][: not end.angle]])
    position = (position - position[0]) / size
    return _Shape(s, position, angle, curvature * size, K, kappa_0 * size, bends, size)


def _fitted(shape: _Shape, edges: FloatArray) -> PlaneCurve:
    """Return the least-squares spline for position and curvature, with the distinct knots `edges`.

    The spline is exact at ends and inflections. At inflections, the derivative of the curvature is exact too,
    because it determines the stiffness there.
    """
    knots = clamped_knots(edges, {}, DEGREE)
    spline = bezier_spans(knots, DEGREE).basis
    gauss, share = np.polynomial.legendre.leggauss(5)
    half = np.diff(edges)[:, None] / 2
    s = (edges[:-1, None] + half + half * gauss).ravel()
    root = np.sqrt(half * share)
    position, angle, kappa = shape.at(s)
    normal = left_of(unit_vectors(angle))
    typical = float(np.sqrt((kappa**2).mean())) + 1e-6
    # errors of the curvature have a weight, the square of a twentieth of the rod's length
    w = root.ravel() * 0.05**2 * typical / (np.abs(kappa) + 0.1 * typical)
    # least squares A X = B for the control points X (m, 2): positions, then second derivatives
    A = np.vstack([root.ravel()[:, None] * spline(s), w[:, None] * spline(s, 2)])
    B = np.vstack([root.ravel()[:, None] * position, (w * kappa)[:, None] * normal])
    ends, bends = edges[[0, -1]], shape.inflections
    # omit inflections close to an end or to each other, because they would need more control points
    apart = np.diff(np.concatenate([ends[:1], bends, ends[1:]])) > 2 * np.diff(edges).max()
    inner = bends[apart[:-1] & apart[1:]]
    there, turned, _ = shape.at(np.concatenate([ends, inner]))
    bent, rest = shape.at(bends)[1], np.interp(bends, shape.s, shape.rest)[:, None]
    along = unit_vectors(turned)
    across = left_of(along[2:])
    # if the strip has a rest curvature, the spline parameter at inflections must be the arc length
    paced = inner[: inner.size * bool(rest.any())]
    # constraints C X = D: positions, tangents, and second and third derivatives at inflections. By Frenet's
    # formulas these are rest * normal, and slope of the curvature * normal - rest^2 * tangent
    C = np.vstack(
        [
            spline(np.concatenate([ends, inner])),
            spline(np.concatenate([ends, paced]), 1),
            spline(bends, 2),
            spline(inner, 3),
        ]
    )
    slope, rest_curvature = shape.slope(inner)[:, None], np.interp(inner, shape.s, shape.rest)[:, None]
    turns = rest * left_of(unit_vectors(bent))
    D = np.vstack([there, along[: 2 + paced.size], turns, slope * across - rest_curvature**2 * along[2:]])
    return PlaneCurve(knots, _constrained_least_squares(A, B, C, D), DEGREE)


def _constrained_least_squares(A: FloatArray, B: FloatArray, C: FloatArray, D: FloatArray) -> FloatArray:
    """Return X that minimises |A X - B| subject to C X = D. A^T A must be banded, as for B-splines."""
    from scipy.linalg import cho_solve_banded, cholesky_banded

    m = A.shape[1]
    both = np.hstack([A, B])
    joined = both.T @ both
    band = np.zeros((DEGREE + 1, m))
    for k in range(DEGREE + 1):
        band[k, : m - k] = np.diagonal(joined[:m, :m], -k)
    # regularise the matrix by more than rounding errors, but without visible effect
    band[0] += 1e-14 * band[0].max()
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
    """Return the errors (n,) of a curve, each as a multiple of its tolerance.

    They are the largest of the errors of position, of the least and largest stiffness, and of the stiffness
    elsewhere. The stiffness is that with which a rod of this curve has the moments of the given rod.
    """
    s, kappa, K = shape.s, shape.curvature - shape.rest, shape.stiffness
    off = norm(curve.evaluate(s) - shape.position) * shape.size / TOLERANCE_MM
    near = np.abs(kappa) < UNBENT_SHARE * np.abs(kappa).max()
    with np.errstate(divide="ignore", invalid="ignore"):
        needed = np.where(near, K, K * kappa / (curve.curvature_at(s) - shape.rest))
    beyond = np.maximum(needed / shape.stiffness.max() - 1, 1 - needed / shape.stiffness.min()) / FAITHFUL
    beyond = np.where(needed > 0, beyond, np.inf)
    return np.asarray(
        np.nan_to_num(np.maximum.reduce([off, beyond, np.abs(needed / K - 1) / LOOSE]), nan=0.0)
    )


def _in_millimetres(curve: PlaneCurve, rod: Rod) -> PlaneCurve:
    return PlaneCurve(curve.knots * rod.length, curve.control_points * rod.length + rod.position[0], DEGREE)
