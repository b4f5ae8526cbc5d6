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
from typing import TypeAlias

import numpy as np

from elastica_cad._compiled_scipy import lapack
from elastica_cad._types import FloatArray
from elastica_cad.errors import InputError, Length, NotConvergedError
from elastica_cad.geometry.path import Spline, distances, polyline_distances
from elastica_cad.geometry.plane_curve import CORNER_RAD, PlaneCurve
from elastica_cad.geometry.plane_points import dot, is_smooth_around, left_of, norm, unit_vectors
from elastica_cad.geometry.splines import bezier_spans, closed_spline, fit_spline, smoothest_spline
from elastica_cad.geometry.tangent_healing import LARGEST_REMOVED_RAD, Healing, heal_tangents

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
    x, y = chord / max(float(norm(chord)), 1e-300)
    along, across = ((points - points[0]) @ np.array([[x, -y], [y, x]])).T
    if np.abs(across).max() <= 1e-9 * np.abs(along).max() and (np.diff(along) > 0).all():
        return PlaneCurve.line(points[0], points[-1])
    return PlaneCurve(*fit_spline(points, POLYLINE_DEGREE, tolerance), POLYLINE_DEGREE)


DEGREE = 4  # with simple knots, the curvature and its slope are continuous

USUAL, USUAL_SHARE = 0.1, 5e-4
"""Default limits of the movement of a curve by smoothing, in mm and as a fraction of the curve's length.

The smaller limit applies.
"""

_SAMPLES_PER_SPAN = 5
_FEWEST_SPANS, _MOST_SPANS = 24, 768
_LINEARISATIONS, _MOST_TRIALS = 3, 14
_CLOSE = 0.004  # the distance is at most this fraction below its limit
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
    spans, length = int(np.clip(4 * len(curve.breaks), _FEWEST_SPANS, _MOST_SPANS // 4)), 0.0
    best: Fairing | None = None
    while spans <= _MOST_SPANS:
        fairing, length = _fitted(curve, tolerance, spans, unbent, length)
        best = fairing or best
        # knots are close enough if the smoothing length spans 1.5 of them; skip numbers that would not be enough
        if length * spans >= _FINE * curve.length:
            break
        spans *= 2
        while 0 < length * spans < _FINE * curve.length and 2 * spans <= _MOST_SPANS:
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
    curve: PlaneCurve, tolerance: float, spans: int, unbent: tuple[bool, bool], guess: float
) -> tuple[Fairing | None, float]:
    """Return the smoothest spline within the tolerance, or None, and its smoothing length.

    The search begins at the smoothing length `guess`.
    """
    problem = _Problem(curve, spans, unbent)
    points, length = problem.start(), guess
    within: FloatArray | None = None
    for _ in range(_LINEARISATIONS):
        # the curve may be farther away between the samples
        latest, reached = problem.smoothest(problem.slope_rows(points), length, 0.96 * tolerance)
        if latest is None:
            break
        within = points = latest
        length = reached
    if within is None:
        return None, 0.0
    try:
        fair = PlaneCurve(problem.knots, within, DEGREE)
    except InputError:
        return None, 0.0
    s = np.union1d(np.linspace(0.0, curve.length, _DENSE * spans), [knot.s for knot in curve.breaks])
    moved = float(norm(fair.evaluate(s) - curve.at(s).position).max())
    return (Fairing(fair, moved, tolerance), length) if moved <= tolerance else (None, 0.0)


NormalEquations: TypeAlias = tuple[FloatArray, FloatArray]
"""Lower band (rows, k) of a symmetric matrix (k, k), and right side (k,)."""


class _Problem:
    """Least squares problem for a given number of knot spans.

    The unknowns are x and y of each free control point. On an open curve, the control points at the ends are
    fixed. On a closed curve, the last control points repeat the first. Samples are indexed by span and number n
    in the span; a span has 5 control points, so 10 coordinates.

    Attributes
    ----------
    width : float
        Length of a knot span, mm.
    data, across : (spans, n, 2) array
        Points of the drawn curve, mm, and its unit normals.
    basis : list of (spans, n, 5) array
        Basis functions and their derivatives of order 1 to 3 at the samples.
    support : (spans, 5) int array
        Control points of each span.
    held : (m, 2) array
        Fixed control points, mm; rows of free control points are 0.
    places : (m,) int array
        Number of each control point among the free ones; -1 if it is fixed.
    columns : (spans, 10) int array
        Unknowns of each span; negative for fixed coordinates.
    lower, cells, band
        Elements of the matrices (10, 10) of all spans that are in the lower triangle, their positions in the
        flat band matrix, and the shape of the band matrix.
    data_part : NormalEquations
        Normal equations of the squared distance from the drawn curve.
    """

    def __init__(self, curve: PlaneCurve, spans: int, unbent: tuple[bool, bool]) -> None:
        self.length = curve.length
        edges = np.linspace(0.0, self.length, spans + 1)
        self.width = self.length / spans
        beyond = self.width * np.arange(1, DEGREE + 1) * curve.is_closed
        self.knots = np.concatenate([edges[0] - beyond[::-1], edges, edges[-1] + beyond])
        s = edges[:-1, None] + self.width * ((np.arange(_SAMPLES_PER_SPAN) + 0.5) / _SAMPLES_PER_SPAN)
        samples = curve.at(s.ravel())
        self.data = samples.position.reshape(*s.shape, 2)
        along = unit_vectors(samples.angle).reshape(*s.shape, 2)
        self.across = left_of(along)
        basis = bezier_spans(self.knots, DEGREE)
        self.basis = [basis.local_basis(s.ravel(), k)[0].reshape(*s.shape, -1) for k in range(4)]
        self.support = basis.columns
        self.held = np.zeros((basis.count, 2))
        if curve.is_closed:
            place = np.arange(basis.count) % spans
            # neighbours stay close together if both halves of the curve are numbered in turn
            self.places = np.minimum(2 * place, 2 * (spans - place) - 1)
        else:
            ends = curve.at(np.array([0.0, self.length]))
            step = self.width / DEGREE * unit_vectors(ends.angle)
            # two fixed control points keep an end and its tangent; a third makes the curvature 0
            first, last = (3 if is_unbent else 2 for is_unbent in unbent)
            # on a straight line with constant speed, the first control points are 0, 1 and 3 `step` from the end
            reach = np.array([0.0, 1.0, 3.0])[:, None]
            self.held[:first] = (ends.position[0] + reach * step[0])[:first]
            self.held[-last:] = (ends.position[1] - reach * step[1])[:last][::-1]
            # index of each control point among the unknowns, -1 if it is fixed
            places = np.arange(len(self.held)) - first
            places[-last:] = -1
            self.places = np.maximum(places, -1)
        self.columns = (2 * self.places[self.support][..., None] + np.arange(2)).reshape(spans, -1)
        size = int(self.columns.max()) + 1
        row, column = self.columns[:, :, None], self.columns[:, None, :]
        self.lower = (row >= column) & (column >= 0)
        self.cells = ((row - column) * size + column)[self.lower]
        self.band = int(self.cells.max()) // size + 1, size
        # weight of squared distances along the drawn curve; those normal to the curve have the weight 1
        slide = np.sqrt(1e4) * along
        self.data_part = self._normal_equations(
            np.concatenate([self._rows(self.across, 0), self._rows(slide, 0)], axis=1),
            np.concatenate([dot(self.data, self.across), dot(self.data, slide)], axis=1),
        )

    def _rows(self, direction: FloatArray, derivative: int) -> FloatArray:
        """Return the matrices (spans, n, 10) of one component of a derivative of the curve at n samples.

        They convert the control points of each span to the scalar products of `direction` (spans, n, 2) and the
        derivatives of order `derivative`.
        """
        numbers = self.basis[derivative][..., None] * direction[..., None, :]
        return numbers.reshape(*direction.shape[:2], -1)

    def _values(self, points: FloatArray, derivative: int) -> FloatArray:
        # derivatives (spans, n, 2) of the curve at the samples
        return self.basis[derivative] @ points[self.support]

    def _applied(self, rows: FloatArray, points: FloatArray) -> FloatArray:
        # values (spans, n) of the matrices from `_rows` for control points (m, 2)
        return (rows @ points[self.support].reshape(len(rows), -1, 1))[..., 0]

    def _normal_equations(self, rows: FloatArray, target: FloatArray) -> NormalEquations:
        # least squares of rows (spans, n, 10) times unknowns minus target (spans, n)
        transposed, free = rows.transpose(0, 2, 1), self.columns >= 0
        sums = transposed @ (target - self._applied(rows, self.held))[..., None]
        band = np.bincount(self.cells, (transposed @ rows)[self.lower], self.band[0] * self.band[1])
        right = np.bincount(self.columns[free], sums[free].ravel(), self.band[1])
        return np.asarray(band.reshape(self.band), dtype=float), np.asarray(right, dtype=float)

    def start(self) -> FloatArray:
        """Return control points close to the drawn curve, smoothed by a small penalty on the third derivative."""
        rows = self._rows(self.across, 3)
        return self._solved(self._normal_equations(rows, np.zeros(rows.shape[:2])), self.width**6 / 64)

    def slope_rows(self, points: FloatArray) -> NormalEquations:
        """Return the normal equations of zero curvature slope, linearised about the curve of `points`.

        If the curve moves by a vector d, its curvature slope changes by n . d''' - 3 kappa t . d'' - 2 kappa' t .
        d' - 2 kappa^2 n . d', with unit tangent t, unit normal n and curvature kappa. The speed is near 1.
        """
        d1, d2, d3 = (self._values(points, k) for k in (1, 2, 3))
        speed = norm(d1)
        t = d1 / speed[..., None]
        n = left_of(t)
        kappa = dot(d2, n) / speed**2
        slope = (dot(d3, n) / speed**2 - 3 * kappa * dot(d2, t) / speed) / speed
        rows = (
            self._rows(n, 3)
            - self._rows(3 * kappa[..., None] * t, 2)
            - self._rows(2 * slope[..., None] * t + 2 * kappa[..., None] ** 2 * n, 1)
        )
        return self._normal_equations(rows, self._applied(rows, points) - slope)

    def smoothest(
        self, slope: NormalEquations, guess: float, limit: float
    ) -> tuple[FloatArray | None, float]:
        """Return control points with the largest smoothing length within the limit, or None, and this length.

        The secant method finds the length, because the logarithms of length and distance are nearly proportional.
        """
        low, high = np.log(self.width / 4), np.log(self.length)
        trial = float(np.clip(np.log(max(guess, 1e-300)), low, high))
        within: FloatArray | None = None
        # usual relative growth of the distance with the relative growth of the smoothing length
        before, rise = None, 3.0
        for _ in range(_MOST_TRIALS):
            # the weight is the sixth power of the smoothing length, of which `trial` is the logarithm
            points = self._solved(slope, float(np.exp(6 * trial)))
            off = np.abs(dot(self._values(points, 0) - self.data, self.across)).max()
            excess = float(np.log(off / limit + 1e-12))
            if excess <= 0:
                low, within = trial, points
            else:
                high = trial
            if -_CLOSE <= excess <= 0 or high - low < _CLOSE / 10:
                break
            if before is not None:
                rise = (excess - before[1]) / (trial - before[0])
            before = trial, excess
            trial -= (excess + _CLOSE / 2) / rise if rise else np.nan
            if not low < trial < high:
                trial = (low + high) / 2
        return within, float(np.exp(low))

    def _solved(self, slope: NormalEquations, weight: float) -> FloatArray:
        """Return the control points (m, 2) that minimise squared distance + `weight` * squared curvature slope.

        They are not numbers if the weight is so large that the distances vanish in its rounding errors.
        """
        band, right = (data + weight * part for data, part in zip(self.data_part, slope, strict=True))
        _, unknowns, failed = lapack().dpbsv(band, right, lower=1)
        points, free = self.held.copy(), self.places >= 0
        points[free] = np.nan if failed else unknowns.reshape(-1, 2)[self.places[free]]
        return points


def two_sided_distance(first: PlaneCurve, other: PlaneCurve, count: int = 2000) -> float:
    """Return the largest distance between two curves, mm, at `count` points of each curve.

    The points are at equal distances and at all knots.
    """
    return max(largest_distance(_points(first, count), other), largest_distance(_points(other, count), first))


def _points(curve: PlaneCurve, count: int) -> FloatArray:
    s = np.union1d(np.linspace(0.0, curve.length, count), [b.s for b in curve.breaks])
    return curve.evaluate(curve.parameter(s.clip(0.0, curve.length)))


def largest_distance(points: FloatArray, curve: PlaneCurve) -> float:
    """Return the largest distance, mm, of points (n, 2) from a curve."""
    return float(distances(Spline(curve), points).max())


CORNER_SHARE = 0.5
"""Fraction of the allowed distance for removing corners. The rest is for smoothing the curvature."""


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
    if not curve.has_corners:
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
            # a tenth of the size is the largest smoothing distance that is suggested
            needed = round_corners(curve, 0.1 * np.ptp(provenance.vertices, axis=0).max())[1]
            return _one_figure(1.01 * needed, np.ceil) if needed else None
        return None
    corners = [corner.angle for corner in curve.tangent_breaks]
    if abs(curve.seam_turn) > CORNER_RAD:
        corners.append(curve.seam_turn)
    if not corners or max(map(abs, corners)) > LARGEST_REMOVED_RAD:
        return None
    # a smoothing distance that is hardly visible
    most = 1e-3 * curve.length
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
    """Remove the corners that disappear if ends of handles move by at most `reach`, mm."""
    # the vector between two points has an error of up to 2 sqrt(2) times that of a coordinate
    return heal_tangents(
        curve.knots, curve.control_points, curve.degree, curve.weights, rounding=reach / (2 * np.sqrt(2.0))
    )
