"""From the flat pattern into space: centre line and normal of a bent strip as one spline of arc length."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Any

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.errors import InputError, NotConvergedError
from elastica_cad.fabrication.solids.boundary_records import SpaceCurve, SpaceSurface
from elastica_cad.fabrication.solids.pattern_strips import on_segment
from elastica_cad.fabrication.strip.flat_outline import pace
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.paths.segments import Segment, Spline
from elastica_cad.geometry.polynomials.splines import (
    clamped_knots,
    interpolated,
    interpolation_sites,
    knot_runs,
)
from elastica_cad.geometry.running_sums import numbers_in_groups, turns_along
from elastica_cad.mechanics.rod.rod_record import Rod

DEGREE = 5  # of the bent faces
POSITION_TOLERANCE = 1e-6  # mm, of the centre line
SURFACE_TOLERANCE = 5e-8  # mm, of edges drawn on the bent faces
MOST_SPANS = 4000  # of one face: more mean a curve that cannot be followed
PROBES = np.array([0.06, 0.27, 0.5, 0.73, 0.94])  # places in a span where the error is measured
LEAST_SPANS = 3  # of an edge: kernels walk from knot to knot, and fillets of one or two spans break off
MOST_PARTS = 4  # that a span is cut into at a time
SPARE = 1.1  # parts for every one that the error asks for
FIRST_TURN = 0.2  # rad, of the spans that are tried first

Shape = Callable[[FloatArray], tuple[FloatArray, FloatArray]]


@dataclass(frozen=True, eq=False)
class BentMap:
    """The map (x, y, up) -> space of a stretch of the strip on which the curvature has no jump.

    A flat point goes to C(x) - up N(x) + y Z: C the centre line, N its left normal, Z across. C and N share
    one B-spline basis, so faces offset by half the thickness and the ruled sides between them are exact.

    Attributes
    ----------
    knots, coefficients
        Clamped, degree 5; (m, 4) rows hold C and N in the plane of the curve.
    frame : Frame
        The plane of the curve in space.
    """

    knots: FloatArray
    coefficients: FloatArray
    frame: Frame

    def frame_at(self, x: float) -> Frame:
        """The tangent plane at arc length x, with its own x running on as arc length."""
        row = self._spline(np.array(x))
        normal = row[2:] / np.hypot(*row[2:])
        origin = self.frame.point(row[:2])
        tangent = self.frame.direction([normal[1], -normal[0]])
        return Frame(origin, tangent, self.frame.z_axis).shifted(x=-x)

    def points(self, flat: FloatArray, heights: Sequence[float]) -> FloatArray:
        """Points in space (k, levels, 3) of flat points (k, 2) at several heights above the middle, mm."""
        rows = self._spline(flat[:, 0])
        local = np.empty((len(flat), len(heights), 3))
        for level, up in enumerate(heights):
            local[:, level, :2] = rows[:, :2] - up * rows[:, 2:]
        local[:, :, 2] = flat[:, 1:]
        return self.frame.point(local.reshape(-1, 3)).reshape(local.shape)

    def curves(
        self, parts: Sequence[tuple[Segment, float, float]], heights: Sequence[float]
    ) -> list[list[SpaceCurve]]:
        """What becomes of flat segments between two parameters, of each at several heights in one basis.

        Exact where x runs evenly along the segment (long sides, lines); others are fitted to 5e-8 mm.
        """
        found = []
        for segment, first, last in parts:
            even = pace(segment)

            def values(t: FloatArray, segment: Segment = segment) -> FloatArray:
                return self.points(on_segment(segment, t), heights).reshape(len(t), -1)

            if even is None:
                spans, degree = np.linspace(first, last, 9), DEGREE
                knots, rows = _fitted(values, spans, {}, np.full(3 * len(heights), SURFACE_TOLERANCE))
            else:
                knots, degree = self._common_knots(segment, even, (first, last))
                sites = interpolation_sites(knots, degree)
                rows = interpolated(sites, values(sites), knots, degree)
            found.append(
                [SpaceCurve(knots, rows[:, k : k + 3], degree) for k in range(0, 3 * len(heights), 3)]
            )
        return found

    def surface(self, low: float, high: float, up: float) -> SpaceSurface:
        """The bent face at the height `up`, from y = `low` to `high`; (u, v) are the flat (x, y)."""
        plane = self.coefficients[:, :2] - up * self.coefficients[:, 2:]
        local = np.empty((len(plane), 2, 3))
        local[:, :, :2] = plane[:, None]
        local[:, :, 2] = low, high
        points = self.frame.point(local.reshape(-1, 3)).reshape(local.shape)
        return SpaceSurface((self.knots, np.array([low, low, high, high])), points, (DEGREE, 1))

    @property
    def curvature(self) -> tuple[FloatArray, FloatArray]:
        """Arc lengths and curvature of the centre line, nine to a span."""
        edges = np.unique(self.knots)
        s = np.linspace(edges[:-1], edges[1:], 9).ravel()
        along, turn = np.split(self._spline(s, 1), 2, axis=1)
        return s, -(turn * along).sum(axis=1) / (along**2).sum(axis=1)

    @cached_property
    def _smoothness(self) -> tuple[FloatArray, IntArray]:
        """Interior knots with the continuity there."""
        knots, counts = knot_runs(self.knots)
        return knots[1:-1], DEGREE - counts[1:-1]

    @cached_property
    def _rows(self) -> Any:
        from scipy.interpolate import BSpline

        return BSpline.construct_fast(self.knots, self.coefficients, DEGREE)  # made of numbers that are sound

    def _spline(self, s: FloatArray, derivative: int = 0) -> FloatArray:
        return np.asarray(self._rows(s, derivative), dtype=float)

    def _common_knots(
        self, segment: Segment, even: tuple[float, float], limits: tuple[float, float]
    ) -> tuple[FloatArray, int]:
        """Knots in the parameter of a segment with even x in which both its shape and the map are splines."""
        (offset, speed), (first, last) = even, limits
        t, continuity = self._smoothness
        t, degree = (t - offset) / speed, DEGREE
        if isinstance(segment, Spline):
            knots, counts = knot_runs(segment.curve.knots)
            degree = max(degree, segment.curve.degree)
            t = np.concatenate([t, knots])
            continuity = np.concatenate([continuity, segment.curve.degree - counts])
        near = 1e-9 * (last - first)
        order = np.argsort(t)
        order = order[(t[order] > first + near) & (t[order] < last - near)]
        t, continuity = t[order], continuity[order]
        if t.size:
            apart = np.flatnonzero(np.diff(t, prepend=first) >= near)
            t, continuity = t[apart], np.minimum.reduceat(continuity, apart)
        if t.size < LEAST_SPANS - 1:
            t, continuity = _in_thirds(np.array([first, *t, last]), continuity, degree)
        inner = np.repeat(t, np.minimum(degree - continuity, degree))
        return np.concatenate([np.full(degree + 1, first), inner, np.full(degree + 1, last)]), degree


def _in_thirds(edges: FloatArray, continuity: IntArray, degree: int) -> tuple[FloatArray, IntArray]:
    """Interior knots with their continuity where every span is cut into three, smoothly."""
    thirds = edges[:-1, None] + np.diff(edges)[:, None] * [0, 1 / 3, 2 / 3]
    smoothness = np.full(thirds.shape, degree - 1)
    smoothness[1:, 0] = continuity
    return thirds.ravel()[1:], smoothness.ravel()[1:]


def bent_maps(rod: Rod, frame: Frame, reach: float) -> tuple[BentMap, ...]:
    """Maps of the stretches between jumps of curvature, from the start of the rod to its end.

    `reach` is how far faces lie off the centre line, mm.

    Raises
    ------
    InputError
        The radius is smaller than the reach somewhere.
    NotConvergedError
        The curve is too wild to be followed to 1e-6 mm.
    """
    shape, breaks = _shape_of(rod)
    cuts = [0.0, *(s for s, continuity in breaks if continuity < 2), rod.length]
    tolerance = np.array([POSITION_TOLERANCE] * 2 + [SURFACE_TOLERANCE / reach] * 2)

    def values(s: FloatArray) -> FloatArray:
        position, tangent = shape(s)
        return np.column_stack([position, -tangent[:, 1], tangent[:, 0]])

    maps = []
    for a, b in pairwise(cuts):
        inner = {s: min(c, DEGREE) for s, c in breaks if a < s < b}
        spans = _first_spans(rod, np.array([a, *inner, b]))
        knots, rows = _fitted(values, spans, {s: c - 1 for s, c in inner.items()}, tolerance)
        maps.append(BentMap(knots, rows, frame))
    _refuse_tight(maps, reach)
    return tuple(maps)


def _refuse_tight(maps: Sequence[BentMap], reach: float) -> None:
    for bent in maps:
        s, kappa = bent.curvature
        i = int(np.argmax(np.abs(kappa)))
        if abs(kappa[i]) * reach >= 1:
            raise InputError(
                f"the radius at {s[i]:.4g} mm is {1 / abs(kappa[i]):.4g} mm, but the strip's face lies "
                f"{reach:g} mm off the curve and would fold over: take a thinner sheet or a gentler curve"
            )


def _shape_of(rod: Rod) -> tuple[Shape, list[tuple[float, int]]]:
    """Position and unit tangent over the rod's arc length, and the breaks of the curve as (s, continuity)."""
    curve = rod.curve
    scale = curve.length / rod.length

    def drawn(s: FloatArray) -> tuple[FloatArray, FloatArray]:
        position, velocity = curve.position_and_velocity(curve.parameter(s * scale))
        return position, velocity / np.hypot(velocity[:, 0], velocity[:, 1])[:, None]

    breaks = [(b.s / scale, _smoothness(curve, b.t, b.continuity)) for b in curve.breaks]
    return drawn, [(float(s), c) for s, c in breaks if 0 < s < rod.length and c < DEGREE - 1]


def _smoothness(curve: PlaneCurve, t: float, continuity: int) -> int:
    """Continuity of the shape at a knot, which a curve's parameter may understate (an arc made of pieces)."""
    if continuity >= 2:
        return continuity
    t0, t1 = curve.domain
    sides = np.array([t - 1e-9 * (t1 - t0), t + 1e-9 * (t1 - t0)])
    kappa, slope = curve.curvature_at(sides), curve.curvature_slope_at(sides)
    reach = 1e-6 * curve.length
    if abs(np.diff(kappa)[0]) > 1e-6 * max(np.abs(kappa).max(), 1 / curve.length):
        return 1
    return 2 if abs(np.diff(slope)[0]) * reach > 1e-9 * max(np.abs(kappa).max(), 1 / curve.length) else 3


def _first_spans(rod: Rod, edges: FloatArray) -> FloatArray:
    """Every stretch divided so that no span turns by much more than 0.2 rad."""
    at = np.interp(edges, rod.s, turns_along(rod.angle))
    rows = [
        np.linspace(a, b, 1 + max(2, int(np.ceil((v - u) / FIRST_TURN))))[:-1]
        for a, b, u, v in zip(edges[:-1], edges[1:], at[:-1], at[1:], strict=True)
    ]
    return np.concatenate([*rows, edges[-1:]])


def _fitted(
    function: Callable[[FloatArray], FloatArray],
    edges: FloatArray,
    smooth: Mapping[float, int],
    tolerance: FloatArray,
) -> tuple[FloatArray, FloatArray]:
    """Knots and coefficients of a degree-5 spline through `function`, spans divided to meet `tolerance`."""
    from scipy.interpolate import BSpline

    while True:
        knots = clamped_knots(edges, smooth, DEGREE)
        sites = interpolation_sites(knots, DEGREE)
        probes = (edges[:-1, None] + np.diff(edges)[:, None] * PROBES).ravel()
        values = function(np.concatenate([sites, probes]))
        rows = interpolated(sites, values[: sites.size], knots, DEGREE)
        excess = (
            np.abs(BSpline.construct_fast(knots, rows, DEGREE)(probes) - values[sites.size :]) / tolerance
        )
        excess = excess.reshape(edges.size - 1, -1).max(axis=1)
        bad = excess > 1
        if not bad.any():
            return knots, rows
        if edges.size > MOST_SPANS:
            at = float(edges[:-1][bad][0])
            raise NotConvergedError(
                f"the bent strip cannot follow its curve near {at:.6g} mm: the curve changes too fast there; "
                "smooth it"
            )
        # the error falls with the power degree + 1 of the width
        parts = np.where(bad, np.clip(np.ceil(SPARE * excess ** (1 / (DEGREE + 1))), 2, MOST_PARTS), 1)
        edges = _divided(edges, parts.astype(int))


def _divided(edges: FloatArray, parts: IntArray) -> FloatArray:
    """The edges (n + 1,) with every span cut into as many equal parts as `parts` (n,) says."""
    width = np.repeat(np.diff(edges) / parts, parts)
    return np.append(np.repeat(edges[:-1], parts) + numbers_in_groups(parts) * width, edges[-1])
