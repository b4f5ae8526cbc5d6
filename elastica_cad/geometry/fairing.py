"""Smoothing of curves with jumps of curvature, and of polylines in drawings.

The smooth curve c is the spline of degree 4 with simple knots that minimises

    integral of (n . (c - drawn))^2 ds + l^6 integral of (d kappa / ds)^2 ds,

where n is the normal of the drawn curve, s arc length, and kappa the curvature of c. The smoothing length l is
the largest for which c is within the tolerance. The slope of the curvature is linearised about the curve of the
previous iteration.
"""

from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from typing import Any

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.errors import InputError, NotConvergedError
from elastica_cad.geometry.path import distances, polyline_distances
from elastica_cad.geometry.plane_curve import CORNER_RAD, CurveSamples, PlaneCurve
from elastica_cad.geometry.plane_points import is_smooth_around, left_of
from elastica_cad.geometry.segments import Spline
from elastica_cad.geometry.splines import bezier_spans, closed_spline, fit_spline, smoothest_spline
from elastica_cad.geometry.tangent_healing import LARGEST_REMOVED_RAD, Healing, heal_tangents
from elastica_cad.refusals import Length

POLYLINE_DEGREE = 4
FIT_TOLERANCE = 0.05
"""Largest distance, mm, between a curve and the points to which it is fitted."""

CLOSED_DEGREE = 5
"""Degree of curves through closed points. FITPACK is less accurate for even degrees."""

SIDE_TOLERANCES = 20.0
"""Length of the sides at a corner of a polyline, as a multiple of the tolerance or the noise."""

_SAMPLES_PER_SIDE, _MOST_SAMPLES = 4, 4000


def fit_polyline(vertices: FloatArray, tolerance: float, noise: float = 0.0) -> tuple[PlaneCurve, float]:
    """Return the smooth curve within `tolerance` mm of polyline vertices (n, 2), and its distance from the sides.

    Raises
    ------
    NotConvergedError
        The vertices are too noisy for a smooth curve.

    Examples
    --------
    >>> angles = np.linspace(0, np.pi, 37)
    >>> curve, distance = fit_polyline(100 * np.column_stack([np.cos(angles), np.sin(angles)]), 0.05)
    >>> round(curve.length, 1), round(distance, 1)
    (314.2, 0.1)
    """
    curve = smooth_through(vertices, tolerance, noise)
    samples = curve.sample(min(_SAMPLES_PER_SIDE * len(vertices), _MOST_SAMPLES)).position
    return curve, float(polyline_distances(vertices, samples).max())


def allowed_distance(vertices: FloatArray) -> float:
    """Return the largest allowed distance, mm, between a smooth curve and a polyline with these vertices."""
    return max(0.5, 0.005 * float(np.ptp(vertices, axis=0).max()))


def smooth_through(points: FloatArray, tolerance: float, noise: float = 0.0) -> PlaneCurve:
    """Return the line through points (n, 2), or a spline if the points are not collinear.

    The distance of the spline from the points is at most `tolerance` mm. A spline through closed points is smooth
    where it starts and ends, and its mean distance from the points is their `noise`, mm.
    """
    if is_smooth_around(points, SIDE_TOLERANCES * max(tolerance, noise)):
        return PlaneCurve(*closed_spline(points, CLOSED_DEGREE, tolerance, noise), CLOSED_DEGREE)
    chord = points[-1] - points[0]
    x, y = chord / max(float(np.hypot(*chord)), 1e-300)
    along, across = ((points - points[0]) @ np.array([[x, -y], [y, x]])).T
    if np.abs(across).max() <= 1e-9 * np.abs(along).max() and np.all(np.diff(along) > 0):
        return PlaneCurve.line(points[0], points[-1])
    return PlaneCurve(*fit_spline(points, POLYLINE_DEGREE, tolerance), POLYLINE_DEGREE)


DEGREE = 4  # with simple knots, the curvature and its slope are continuous

USUAL, USUAL_SHARE = 0.1, 5e-4
"""Default limits of the movement of a curve by smoothing, in mm and as a fraction of the curve's length.

The smaller limit applies.
"""

_SAMPLES_PER_SPAN = 5
_FEWEST_SPANS, _MOST_SPANS = 24, 768
_LINEARISATIONS = 3
_HALVINGS = 14
# samples must be within this fraction of the tolerance, because the curve may be farther away between samples
_USED = 0.96
_SLIDE = 1e4  # weight of squared distances along the drawn curve; those normal to the curve have the weight 1
_FINE = 1.5  # least ratio of the smoothing length to the length of a knot span
_DENSE = 8  # number of points in each knot span at which the distance is measured


@dataclass(frozen=True, eq=False)
class Fairing:
    """Smooth curve close to a drawn curve.

    Attributes
    ----------
    curve : PlaneCurve
        Spline of degree 4 with simple knots, so that its curvature and the slope of its curvature are continuous.
    moved : float
        Largest distance between the smooth and the drawn curve, mm, at dense samples.
    tolerance : float
        Largest allowed distance, mm.
    """

    curve: PlaneCurve
    moved: float
    tolerance: float


def may_step(curve: PlaneCurve) -> bool:
    """Return True if the width of a strip with this curve may have a step.

    The width has a step if the curvature jumps, or if the slope of the curvature jumps at an inflection. The
    result is False for curves with corners or straight pieces, because they are not smoothed.
    """
    breaks = curve.breaks if curve.seam is None else (curve.seam, *curve.breaks)
    rough = [b for b in breaks if b.continuity <= 2]
    if not rough or curve.has_corners or any(zero.kind == "flat" for zero in curve.curvature_zeros):
        return False
    if any(b.continuity <= 1 for b in rough):
        return True
    zeros = np.array([z.t for z in curve.curvature_zeros])
    near = 1e-9 * np.ptp(np.array(curve.domain))
    return any(np.abs(zeros - b.t).min(initial=np.inf) <= near for b in rough)


def usual_tolerance(curve: PlaneCurve) -> float:
    """Return the default largest distance, mm, between a curve and its smooth curve."""
    return min(USUAL, USUAL_SHARE * curve.length)


def fair_curve(curve: PlaneCurve, tolerance: float, unbent: tuple[bool, bool] = (False, False)) -> Fairing:
    """Return the smoothest curve within `tolerance` mm of a curve, with the same ends and end tangents.

    A closed curve is also smoothed where it starts and ends, and none of its points is fixed.

    Parameters
    ----------
    unbent : (bool, bool)
        Flags for the start and the end: True if the curvature must be 0 there.

    Examples
    --------
    >>> import numpy as np
    >>> pen = PlaneCurve(np.repeat([0.0, 1.0, 2.0], [4, 3, 4]),
    ...                  [(0, 0), (0, 60), (40, 100), (100, 100), (150, 100), (200, 70), (200, 0)], 3)
    >>> fair = fair_curve(pen, 0.1)
    >>> [b.continuity for b in pen.breaks], fair.moved <= 0.1, min(b.continuity for b in fair.curve.breaks) >= 3
    ([1], True, True)
    """
    if not (np.isfinite(tolerance) and tolerance > 0):
        raise InputError(f"the smoothing distance is {tolerance!r} mm: give a positive distance, such as 0.1")
    if curve.has_corners:
        raise InputError(
            "a curve with corners cannot be smoothed: round the corners, or cut the curve at the corners"
        )
    spans = int(np.clip(4 * len(curve.breaks), _FEWEST_SPANS, _MOST_SPANS // 4))
    best: Fairing | None = None
    while spans <= _MOST_SPANS:
        fairing, length = _fitted(curve, tolerance, spans, unbent)
        if fairing is not None:
            if best is None or fairing.moved <= tolerance:
                best = fairing
            if length * spans >= _FINE * curve.length:
                return fairing
        spans *= 2
    if best is None:
        raise InputError(
            "jumps of the curvature cannot be smoothed within {tolerance}: set a smoothing distance of about "
            "{tolerance_2} or more",
            tolerance=Length(tolerance),
            tolerance_2=Length(2 * tolerance),
        )
    return best


def _fitted(
    curve: PlaneCurve, tolerance: float, spans: int, unbent: tuple[bool, bool]
) -> tuple[Fairing | None, float]:
    """Return the smoothest spline within the tolerance, or None, and its smoothing length."""
    problem = _Problem(curve, spans, unbent)
    points = problem.start()
    within: FloatArray | None = None
    reached = 0.0
    for _ in range(_LINEARISATIONS):
        slope = problem.slope_rows(points)
        low, high = np.log(problem.width / 4), np.log(curve.length)
        latest: FloatArray | None = None
        for _ in range(_HALVINGS):
            middle = (low + high) / 2
            tried = problem.solved(slope, float(np.exp(6 * middle)))
            if problem.off(tried) <= _USED * tolerance:
                low, latest = middle, tried
            else:
                high = middle
        if latest is None:
            break
        within, reached, points = latest, float(np.exp(low)), latest
    if within is None:
        return None, 0.0
    try:
        fair = PlaneCurve(problem.knots, within, DEGREE)
    except InputError:
        return None, 0.0
    moved = two_sided_distance(curve, fair, _DENSE * spans)
    return (Fairing(fair, moved, tolerance), reached) if moved <= tolerance else (None, 0.0)


class _Problem:
    """Least squares problem for a given number of knot spans.

    The unknowns are x and y of each free control point. On an open curve, the control points at the ends are
    fixed. On a closed curve, the last control points repeat the first.
    """

    def __init__(self, curve: PlaneCurve, spans: int, unbent: tuple[bool, bool]) -> None:
        from scipy.sparse import vstack

        length = curve.length
        edges = np.linspace(0.0, length, spans + 1)
        self.width = length / spans
        beyond = self.width * np.arange(1, DEGREE + 1) * curve.is_closed
        self.knots = np.concatenate([edges[0] - beyond[::-1], edges, edges[-1] + beyond])
        self.spans = bezier_spans(self.knots, DEGREE)
        local = (np.arange(_SAMPLES_PER_SPAN) + 0.5) / _SAMPLES_PER_SPAN
        self.s = (edges[:-1, None] + self.width * local).ravel()
        samples = curve.at(self.s)
        self.data = samples.position
        self.along = np.column_stack([np.cos(samples.angle), np.sin(samples.angle)])
        self.across = left_of(self.along)
        self.basis = [self.spans.local_basis(self.s, k)[0] for k in range(4)]
        self.support = np.repeat(self.spans.first, _SAMPLES_PER_SPAN)[:, None] + np.arange(DEGREE + 1)
        self.held = np.zeros((self.spans.count, 2))
        if curve.is_closed:
            places = np.arange(self.spans.count) % spans
        else:
            places = self._hold_ends(curve.at(np.array([0.0, length])), unbent)
        self.chosen = self._choice(places)
        both = vstack([self._rows(self.across, 0), np.sqrt(_SLIDE) * self._rows(self.along, 0)])
        target = [(self.data * v).sum(axis=1) for v in (self.across, np.sqrt(_SLIDE) * self.along)]
        self.data_part = self._normal_equations(both, np.concatenate(target))

    def _hold_ends(self, ends: CurveSamples, unbent: tuple[bool, bool]) -> IntArray:
        """Fix the end control points. Return the index of each control point among the unknowns, -1 if fixed."""
        step = self.width / DEGREE * np.column_stack([np.cos(ends.angle), np.sin(ends.angle)])
        first, last = (3 if is_unbent else 2 for is_unbent in unbent)
        # on a straight line with constant speed, the first control points are 0, 1 and 3 times `step` from the end
        reach = np.array([0.0, 1.0, 3.0])[:, None]
        self.held[:first] = (ends.position[0] + reach * step[0])[:first]
        self.held[-last:] = (ends.position[1] - reach * step[1])[:last][::-1]
        places = np.arange(self.spans.count) - first
        places[-last:] = -1
        return np.maximum(places, -1)

    @staticmethod
    def _choice(places: IntArray) -> Any:
        from scipy.sparse import csr_matrix

        sought = np.flatnonzero(places >= 0)
        row = (2 * sought[:, None] + np.arange(2)).ravel()
        column = (2 * places[sought][:, None] + np.arange(2)).ravel()
        size = 2 * places.size, 2 * (int(places.max()) + 1)
        return csr_matrix((np.ones(row.size), (row, column)), shape=size)

    def _rows(self, direction: FloatArray, derivative: int) -> Any:
        """Return the sparse matrix (n, 2 m) of one component of a derivative of the curve at its n samples.

        The matrix converts m control points to the scalar products of `direction` (n, 2) and the derivatives of
        order `derivative`.
        """
        from scipy.sparse import csr_matrix

        numbers = self.basis[derivative][:, :, None] * direction[:, None, :]
        columns = 2 * self.support[:, :, None] + np.arange(2)
        starts = np.arange(len(numbers) + 1) * 2 * (DEGREE + 1)
        return csr_matrix((numbers.ravel(), columns.ravel(), starts), shape=(len(numbers), self.held.size))

    def _values(self, points: FloatArray, derivative: int) -> FloatArray:
        return np.asarray(np.einsum("nk,nkd->nd", self.basis[derivative], points[self.support]))

    def _normal_equations(self, rows: Any, target: FloatArray) -> tuple[Any, FloatArray]:
        sought = rows @ self.chosen
        return sought.T @ sought, sought.T @ (target - rows @ self.held.ravel())

    def start(self) -> FloatArray:
        """Return control points close to the drawn curve, smoothed by a small penalty on the third derivative."""
        rows = self._rows(self.across, 3)
        return self.solved(self._normal_equations(rows, np.zeros(self.s.size)), self.width**6 / 64)

    def slope_rows(self, points: FloatArray) -> tuple[Any, FloatArray]:
        """Return the normal equations of zero curvature slope, linearised about the curve of `points`.

        If the curve moves by a vector d, its curvature slope changes by n . d''' - 3 kappa t . d'' - 2 kappa' t .
        d' - 2 kappa^2 n . d', with unit tangent t, unit normal n and curvature kappa. The speed is near 1.
        """
        d1, d2, d3 = (self._values(points, k) for k in (1, 2, 3))
        speed = np.hypot(d1[:, 0], d1[:, 1])
        t = d1 / speed[:, None]
        n = left_of(t)
        kappa = (d2 * n).sum(axis=1) / speed**2
        slope = ((d3 * n).sum(axis=1) / speed**2 - 3 * kappa * (d2 * t).sum(axis=1) / speed) / speed
        rows = (
            self._rows(n, 3)
            - self._rows(3 * kappa[:, None] * t, 2)
            - self._rows(2 * slope[:, None] * t, 1)
            - self._rows(2 * kappa[:, None] ** 2 * n, 1)
        )
        return self._normal_equations(rows, rows @ points.ravel() - slope)

    def solved(self, slope: tuple[Any, FloatArray], weight: float) -> FloatArray:
        """Return the control points (m, 2) that minimise squared distance + `weight` * squared curvature slope."""
        from scipy.sparse.linalg import spsolve

        matrix, right = (data + weight * part for data, part in zip(self.data_part, slope, strict=True))
        unknowns = spsolve(matrix.tocsc(), right, permc_spec="NATURAL")
        return np.asarray(self.held + (self.chosen @ unknowns).reshape(-1, 2), dtype=float)

    def off(self, points: FloatArray) -> float:
        return float(np.abs(((self._values(points, 0) - self.data) * self.across).sum(axis=1)).max())


def two_sided_distance(first: PlaneCurve, other: PlaneCurve, count: int = 2000) -> float:
    """Return the largest distance between two curves, mm, at `count` points of each curve.

    The points are at equal distances and at all knots.
    """
    return max(largest_distance(_points(first, count), other), largest_distance(_points(other, count), first))


def _points(curve: PlaneCurve, count: int) -> FloatArray:
    s = np.union1d(np.linspace(0.0, curve.length, count), [b.s for b in curve.breaks])
    return curve.evaluate(curve.parameter(np.clip(s, 0.0, curve.length)))


def largest_distance(points: FloatArray, curve: PlaneCurve) -> float:
    """Return the largest distance, mm, of points (n, 2) from a curve."""
    return float(distances(Spline(curve), points).max())


PER_ROUNDING = 2 * np.sqrt(2.0)
"""Largest error of the vector between two points, as a multiple of the rounding error of a coordinate."""

CORNER_SHARE = 0.5
"""Fraction of the allowed distance for removing corners. The rest is for smoothing the curvature."""

POLYLINE_SHARE = 0.1
"""Largest smoothing distance suggested for a polyline, as a fraction of its size."""

WORTH_SHARE = 1e-3
"""Largest smoothing distance suggested for a spline, as a fraction of its length. It is hardly visible."""


def round_corners(curve: PlaneCurve, smooth: float) -> tuple[PlaneCurve, float]:
    """Return the curve without slight corners, and the largest distance, mm, by which it was moved.

    Corners remain if they are above 5 degrees, or if their removal would move the curve by more than half of
    `smooth` (mm). A curve that was fitted to noisy points is fitted again, within `smooth` of each point. A
    polyline becomes the smooth curve through its vertices, if the curve is within `smooth` of the sides.

    Examples
    --------
    >>> kinked = PlaneCurve([0] * 4 + [1] * 3 + [2] * 4,
    ...                     [(0, 0), (20, 20), (40, 30), (60, 30), (80, 30.02), (100, 20), (120, 0)], 3)
    >>> smooth, moved = round_corners(kinked, 0.1)
    >>> len(kinked.tangent_breaks), len(smooth.tangent_breaks), round(moved, 4)
    (1, 0, 0.01)
    """
    provenance = curve.provenance
    if provenance is not None and provenance.measured is not None and provenance.measured.is_noisy:
        fitted = PlaneCurve(*smoothest_spline(provenance.measured.points, DEGREE, smooth), DEGREE)
        moved = largest_distance(provenance.measured.points, fitted)
        return fitted.drawn_as(provenance.of_part()), moved
    if not curve.has_corners or curve.degree < 2:
        return curve, 0.0
    if provenance is not None and provenance.vertices is not None:
        fitted, moved = fit_polyline(provenance.vertices, FIT_TOLERANCE)
        return (fitted.drawn_as(provenance.of_part()), moved) if moved <= smooth else (curve, 0.0)
    healing = _healed(curve, CORNER_SHARE * smooth)
    if not healing.healed:
        return curve, 0.0
    rounded = PlaneCurve(healing.knots, healing.control_points, healing.degree, healing.weights)
    return rounded.drawn_as(provenance), healing.moved


def smooth_for_corners(curve: PlaneCurve) -> float | None:
    """Return a smoothing distance, mm, rounded to one digit, with which `round_corners` removes all corners.

    For a spline, the distance is at least the default smoothing distance, and at most a thousandth of the length.
    For a polyline, the limit is a tenth of the size. The result is None if the curve has no corners, or if the
    limit is too small to remove them.

    Examples
    --------
    >>> kinked = PlaneCurve([0] * 4 + [1] * 3 + [2] * 4,
    ...                     [(0, 0), (20, 20), (40, 30), (60, 30), (80, 30.02), (100, 20), (120, 0)], 3)
    >>> smooth_for_corners(kinked)
    0.06
    """
    provenance = curve.provenance
    if provenance is not None and provenance.vertices is not None:
        with suppress(NotConvergedError):
            needed = round_corners(curve, POLYLINE_SHARE * np.ptp(provenance.vertices, axis=0).max())[1]
            return _one_figure(1.01 * needed, np.ceil) if needed else None
        return None
    corners = [corner.angle for corner in curve.tangent_breaks]
    if abs(curve.seam_turn) > CORNER_RAD:
        corners.append(curve.seam_turn)
    if not corners or curve.degree < 2 or max(map(abs, corners)) > LARGEST_REMOVED_RAD:
        return None
    most = WORTH_SHARE * curve.length
    healing = _healed(curve, CORNER_SHARE * most)
    if len(healing.healed) < len(corners):
        return None
    # add 5 %, because `moved` is estimated with the sine of an angle, which is smaller than the angle
    needed = 1.05 * healing.moved / CORNER_SHARE
    offered = max(_one_figure(needed, np.ceil), _one_figure(usual_tolerance(curve), np.floor))
    return offered if offered <= most and not round_corners(curve, offered)[0].has_corners else None


def _one_figure(x: float, rounded: Callable[[float], float]) -> float:
    step = 10.0 ** np.floor(np.log10(x))
    return float(f"{rounded(x / step) * step:.1g}")


def _healed(curve: PlaneCurve, reach: float) -> Healing:
    return heal_tangents(
        curve.knots, curve.control_points, curve.degree, curve.weights, rounding=reach / PER_ROUNDING
    )
