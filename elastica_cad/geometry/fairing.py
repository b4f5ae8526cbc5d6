"""Smoothing of curves: jumps of curvature, and polylines of drawings.

The fair curve c is the spline of degree 4 with simple knots that minimises

    integral of (n . (c - drawn))^2 ds + l^6 integral of (d kappa / ds)^2 ds,

its ends and end tangents as drawn (and ends without curvature where that is asked for), with the largest length l
for which it stays within the tolerance; of a closed curve it is periodic. The slope of the curvature is linearised
about the curve of the round before; all systems are sparse.

Corners so slight that a strip may round them are taken out before, by turning handles.
"""

from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass
from typing import Any

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.errors import InputError, NotConvergedError
from elastica_cad.geometry.path import distances
from elastica_cad.geometry.plane_curve import CORNER_RAD, CurveSamples, PlaneCurve
from elastica_cad.geometry.plane_points import lengths_along
from elastica_cad.geometry.segments import Spline
from elastica_cad.geometry.splines import bezier_spans, fit_spline, smoothest_spline
from elastica_cad.geometry.tangent_healing import SURE, Healing, heal_tangents
from elastica_cad.refusals import Length

POLYLINE_DEGREE = 4
FIT_TOLERANCE = 0.05
"""Distance, mm, of a curve from the points that it is fitted to."""

_EACH_SIDE = 4  # samples of the curve for each side


def fit_polyline(vertices: FloatArray, tolerance: float) -> tuple[PlaneCurve, float]:
    """Return the smooth curve within `tolerance` mm of the vertices (n, 2), and its distance from the sides.

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
    curve = smooth_through(vertices, tolerance)
    return curve, _distance_from_sides(curve, vertices)


def allowed_distance(vertices: FloatArray) -> float:
    """Return the distance, mm, up to which a smooth curve counts as what a polyline with these vertices means."""
    return max(0.5, 0.005 * float(np.ptp(vertices, axis=0).max()))


def smooth_through(points: FloatArray, tolerance: float) -> PlaneCurve:
    """Return the line through points (n, 2) that are in line, else the spline within `tolerance` mm of them."""
    chord = points[-1] - points[0]
    x, y = chord / max(float(np.hypot(*chord)), 1e-300)
    along, across = ((points - points[0]) @ np.array([[x, -y], [y, x]])).T
    if np.abs(across).max() <= 1e-9 * np.abs(along).max() and np.all(np.diff(along) > 0):
        return PlaneCurve.line(points[0], points[-1])
    return PlaneCurve(*fit_spline(points, POLYLINE_DEGREE, tolerance), POLYLINE_DEGREE)


def _distance_from_sides(curve: PlaneCurve, vertices: FloatArray) -> float:
    """Return the largest distance of the curve from the sides near the same fraction of the length."""
    places = lengths_along(vertices)
    count = _EACH_SIDE * len(places)
    positions = curve.sample(count).position
    side = np.searchsorted(places, places[-1] * np.linspace(0, 1, count)[1:-1], side="right") - 1
    nearest = np.full(count - 2, np.inf)
    for offset in (-1, 0, 1):
        index = np.clip(side + offset, 0, len(places) - 2)
        start, way = vertices[index], vertices[index + 1] - vertices[index]
        out = positions[1:-1] - start
        fraction = np.clip((out * way).sum(axis=1) / (way**2).sum(axis=1), 0, 1)
        nearest = np.minimum(nearest, np.linalg.norm(out - fraction[:, None] * way, axis=1))
    return float(nearest.max())


DEGREE = 4  # whose curvature and its slope are continuous at simple knots

USUAL, USUAL_SHARE = 0.1, 5e-4
"""Largest distance by which a curve is smoothed by default: in mm, and as a fraction of its length."""

_EACH = 5  # sites in a span
_FEWEST, _MOST = 24, 768  # spans
_ROUNDS = 3  # rounds: what is found moves the sites of the next
_HALVINGS = 14  # of the range of smoothing weights
_USED = 0.96  # of the tolerance at the sites: what is between them is measured afterwards
_SLIDE = 1e4  # weight of sliding along the curve, beside moving across it
_FINE = 1.5  # spans in the length over which curvature is evened out
_DENSE = 8  # points in a span when the distance is measured


@dataclass(frozen=True, eq=False)
class Fairing:
    """A fair curve beside the drawn one.

    Attributes
    ----------
    curve : PlaneCurve
        Degree 4, simple knots: curvature and its slope are continuous.
    moved : float
        Largest distance of either curve from the other, mm, by dense sampling.
    tolerance : float
        What was allowed, mm.
    """

    curve: PlaneCurve
    moved: float
    tolerance: float


def may_step(curve: PlaneCurve) -> bool:
    """Return True if the curvature jumps, or its slope at an inflection: the width of a strip may step there.

    A curve with corners or straight pieces is no candidate for smoothing: the corners are refused, and the straight
    pieces are meant to be straight.
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
    """Largest distance in mm by which a curve is smoothed by default."""
    return min(USUAL, USUAL_SHARE * curve.length)


def fair_curve(curve: PlaneCurve, tolerance: float, unbent: tuple[bool, bool] = (False, False)) -> Fairing:
    """The curve with its curvature evened out as far as `tolerance` (mm) allows, ends and end tangents kept.

    A closed curve is as fair where it closes as elsewhere, and nothing of it is kept.

    Parameters
    ----------
    unbent : (bool, bool)
        Is the curvature to vanish at the start, at the end?

    Raises
    ------
    InputError
        A curve with corners, a tolerance that is not positive, or so small that no spline of some
        hundred pieces can even out the jumps.

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
        raise InputError(
            f"a curve is made fair within a positive distance, not {tolerance!r} mm: give 0.1, for one"
        )
    if curve.has_corners:
        raise InputError("a curve with corners cannot be made fair: round the corners, or cut it at them")
    spans = int(np.clip(4 * len(curve.breaks), _FEWEST, _MOST // 4))
    best: Fairing | None = None
    while spans <= _MOST:
        found, length = _fitted(curve, tolerance, spans, unbent)
        if found is not None:
            if best is None or found.moved <= tolerance:
                best = found
            if length * spans >= _FINE * curve.length:
                return found
        spans *= 2
    if best is None:
        raise InputError(
            "the jumps of the curvature cannot be evened out within {tolerance}: allow more, at "
            "least {tolerance_2}",
            tolerance=Length(tolerance),
            tolerance_2=Length(2 * tolerance),
        )
    return best


def _fitted(
    curve: PlaneCurve, tolerance: float, spans: int, unbent: tuple[bool, bool]
) -> tuple[Fairing | None, float]:
    """The fairest spline of so many spans within the tolerance, if any, and its length of evening out."""
    problem = _Problem(curve, spans, unbent)
    points = problem.start()
    within: FloatArray | None = None
    reached = 0.0
    for _ in range(_ROUNDS):
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
    """The least squares problem for one number of spans.

    Its unknowns are x and y of the control points that are sought, one after the other: all of an open curve but
    those at its ends that are held, and of a closed one those of one turn, as its last ones are the first again.
    """

    def __init__(self, curve: PlaneCurve, spans: int, unbent: tuple[bool, bool]) -> None:
        from scipy.sparse import vstack

        length = curve.length
        edges = np.linspace(0.0, length, spans + 1)
        self.width = length / spans
        beyond = self.width * np.arange(1, DEGREE + 1) * curve.is_closed
        self.knots = np.concatenate([edges[0] - beyond[::-1], edges, edges[-1] + beyond])
        self.spans = bezier_spans(self.knots, DEGREE)
        local = (np.arange(_EACH) + 0.5) / _EACH
        self.s = (edges[:-1, None] + self.width * local).ravel()
        drawn = curve.at(self.s)
        self.data = drawn.position
        self.along = np.column_stack([np.cos(drawn.angle), np.sin(drawn.angle)])
        self.across = np.column_stack([-self.along[:, 1], self.along[:, 0]])
        self.basis = [self.spans.local_basis(self.s, k)[0] for k in range(4)]
        self.support = np.repeat(self.spans.first, _EACH)[:, None] + np.arange(DEGREE + 1)
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
        """Hold the control points that keep ends and end tangents; which unknown (m,) each is, -1 for these."""
        step = self.width / DEGREE * np.column_stack([np.cos(ends.angle), np.sin(ends.angle)])
        first, last = (3 if one else 2 for one in unbent)
        # a straight line of even speed has its control points there
        reach = np.array([0.0, 1.0, 3.0])[:, None]
        self.held[:first] = (ends.position[0] + reach * step[0])[:first]
        self.held[-last:] = (ends.position[1] - reach * step[1])[:last][::-1]
        places = np.arange(self.spans.count) - first
        places[-last:] = -1
        return np.maximum(places, -1)

    @staticmethod
    def _choice(places: IntArray) -> Any:
        """Matrix (2 m, k) from the unknowns to those control points that are not held, x and y in turn."""
        from scipy.sparse import csr_matrix

        sought = np.flatnonzero(places >= 0)
        row = (2 * sought[:, None] + np.arange(2)).ravel()
        column = (2 * places[sought][:, None] + np.arange(2)).ravel()
        size = 2 * places.size, 2 * (int(places.max()) + 1)
        return csr_matrix((np.ones(row.size), (row, column)), shape=size)

    def _rows(self, direction: FloatArray, derivative: int) -> Any:
        """The sparse matrix (n, 2 m) that takes control points to direction . c^(derivative) at the sites."""
        from scipy.sparse import csr_matrix

        numbers = self.basis[derivative][:, :, None] * direction[:, None, :]
        columns = 2 * self.support[:, :, None] + np.arange(2)
        starts = np.arange(len(numbers) + 1) * 2 * (DEGREE + 1)
        return csr_matrix((numbers.ravel(), columns.ravel(), starts), shape=(len(numbers), self.held.size))

    def _values(self, points: FloatArray, derivative: int) -> FloatArray:
        """Derivative (n, 2) of the curve at the sites."""
        return np.asarray(np.einsum("nk,nkd->nd", self.basis[derivative], points[self.support]))

    def _normal_equations(self, rows: Any, target: FloatArray) -> tuple[Any, FloatArray]:
        """Matrix and right-hand side for the unknowns of least squares of rows @ points - target."""
        sought = rows @ self.chosen
        return sought.T @ sought, sought.T @ (target - rows @ self.held.ravel())

    def start(self) -> FloatArray:
        """The spline nearest to the drawn curve."""
        rows = self._rows(self.across, 3)
        return self.solved(self._normal_equations(rows, np.zeros(self.s.size)), self.width**6 / 64)

    def slope_rows(self, points: FloatArray) -> tuple[Any, FloatArray]:
        """Normal equations of the slope of the curvature, linearised about the curve of `points`.

        With unit tangent t, unit normal n and a speed near 1, a change d of the curve changes d kappa / ds by
        n . d''' - 3 kappa t . d'' - 2 kappa' t . d' - 2 kappa^2 n . d'.
        """
        d1, d2, d3 = (self._values(points, k) for k in (1, 2, 3))
        speed = np.hypot(d1[:, 0], d1[:, 1])
        t = d1 / speed[:, None]
        n = np.column_stack([-t[:, 1], t[:, 0]])
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
        """Control points (m, 2) of least squares of distance and slope."""
        from scipy.sparse.linalg import spsolve

        matrix, right = (data + weight * part for data, part in zip(self.data_part, slope, strict=True))
        found = spsolve(matrix.tocsc(), right, permc_spec="NATURAL")
        return np.asarray(self.held + (self.chosen @ found).reshape(-1, 2), dtype=float)

    def off(self, points: FloatArray) -> float:
        """Largest distance across the drawn curve at the sites, mm."""
        return float(np.abs(((self._values(points, 0) - self.data) * self.across).sum(axis=1)).max())


def two_sided_distance(one: PlaneCurve, other: PlaneCurve, count: int = 2000) -> float:
    """Largest distance of a point of either curve from the other curve, mm, over `count` points of each.

    Points are taken at equal distances and at all knots.
    """
    return max(_farthest(_points(one, count), other), _farthest(_points(other, count), one))


def _points(curve: PlaneCurve, count: int) -> FloatArray:
    s = np.union1d(np.linspace(0.0, curve.length, count), [b.s for b in curve.breaks])
    return curve.evaluate(curve.parameter(np.clip(s, 0.0, curve.length)))


def _farthest(points: FloatArray, curve: PlaneCurve) -> float:
    """Largest distance of points (n, 2) from a curve, mm."""
    return float(distances(Spline(curve), points).max())


PER_ROUNDING = 2 * np.sqrt(2.0)
"""Largest distance between the end of a handle and its node that rounding of all coordinates by 1 causes."""

SMOOTHING_SHARE = 0.5
"""Share of the allowed distance that may be used for smoothing; the rest is left for making the curvature fair."""

POLYLINE_SHARE = 0.1
"""Largest `smooth` that is suggested for a polyline, as a fraction of its size."""

WORTH_SHARE = 1e-3
"""Largest move, as a share of the length, that is suggested; larger ones would change the drawing visibly."""


def round_corners(curve: PlaneCurve, smooth: float) -> tuple[PlaneCurve, float]:
    """The curve without slight corners, and how far, mm, it was moved at most to take them out.

    Corners of more than 5 degrees stay, and those for which it would move by more than half of `smooth` (mm).
    A curve that was fitted to points that waver is fitted to them anew, within `smooth` of each. A polyline becomes
    the smooth curve through its vertices, if that stays within `smooth` of the sides.

    Examples
    --------
    >>> kinked = PlaneCurve([0] * 4 + [1] * 3 + [2] * 4,
    ...                     [(0, 0), (20, 20), (40, 30), (60, 30), (80, 30.02), (100, 20), (120, 0)], 3)
    >>> smooth, moved = round_corners(kinked, 0.1)
    >>> len(kinked.tangent_breaks), len(smooth.tangent_breaks), round(moved, 4)
    (1, 0, 0.01)
    """
    drawn = curve.provenance
    if drawn is not None and drawn.measured is not None and drawn.measured.wavers:
        fitted = PlaneCurve(*smoothest_spline(drawn.measured.points, DEGREE, smooth), DEGREE)
        moved = _farthest(drawn.measured.points, fitted)
        return fitted.drawn_as(drawn.of_part()), moved
    if not curve.has_corners or curve.degree < 2:
        return curve, 0.0
    if drawn is not None and drawn.vertices is not None:
        fitted, moved = fit_polyline(drawn.vertices, FIT_TOLERANCE)
        return (fitted.drawn_as(drawn.of_part()), moved) if moved <= smooth else (curve, 0.0)
    healing = _healed(curve, SMOOTHING_SHARE * smooth)
    if not healing.healed:
        return curve, 0.0
    rounded = PlaneCurve(healing.knots, healing.control_points, healing.degree, healing.weights)
    return rounded.drawn_as(drawn), healing.moved


def smooth_for_corners(curve: PlaneCurve) -> float | None:
    """The `smooth`, mm, of one figure, with which `round_corners` takes out all corners; None if it is no detail
    of a spline.

    It is at least the usual smoothing distance, at most a thousandth of the length.

    Examples
    --------
    >>> kinked = PlaneCurve([0] * 4 + [1] * 3 + [2] * 4,
    ...                     [(0, 0), (20, 20), (40, 30), (60, 30), (80, 30.02), (100, 20), (120, 0)], 3)
    >>> smooth_for_corners(kinked)
    0.06
    """
    drawn = curve.provenance
    if drawn is not None and drawn.vertices is not None:
        with suppress(NotConvergedError):
            needed = round_corners(curve, POLYLINE_SHARE * np.ptp(drawn.vertices, axis=0).max())[1]
            return _one_figure(1.01 * needed, np.ceil) if needed else None
        return None
    corners = [one.angle for one in curve.tangent_breaks]
    if abs(curve.seam_turn) > CORNER_RAD:
        corners.append(curve.seam_turn)
    if not corners or curve.degree < 2 or max(map(abs, corners)) > SURE:
        return None
    most = WORTH_SHARE * curve.length
    healing = _healed(curve, SMOOTHING_SHARE * most)
    if len(healing.healed) < len(corners):
        return None
    needed = 1.05 * healing.moved / SMOOTHING_SHARE  # the bound of a turn is of sines
    offered = max(_one_figure(needed, np.ceil), _one_figure(usual_tolerance(curve), np.floor))
    return offered if offered <= most and not round_corners(curve, offered)[0].has_corners else None


def _one_figure(x: float, rounded: Callable[[float], float]) -> float:
    step = 10.0 ** np.floor(np.log10(x))
    return float(f"{rounded(x / step) * step:.1g}")


def _healed(curve: PlaneCurve, reach: float) -> Healing:
    """Remove the corners that can be removed without moving the end of any handle farther than `reach`, mm."""
    return heal_tangents(
        curve.knots, curve.control_points, curve.degree, curve.weights, rounding=reach / PER_ROUNDING
    )
