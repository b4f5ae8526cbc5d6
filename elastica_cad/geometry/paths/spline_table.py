"""Splines of one degree side by side: evaluated and trimmed at one go, each at places of its own."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.geometry.curves.arc_length import arc_lengths
from elastica_cad.geometry.curves.curve_derivatives import cross, quotient
from elastica_cad.geometry.curves.graph_areas import area_beside_graph
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.polynomials.bezier_pieces import extraction
from elastica_cad.geometry.polynomials.gauss_rule import gauss_rule

LONG = 32
"""Knots of a curve that is asked for its area by itself first: short ones come in thousands."""

SAME_KNOT = 1e-12
"""Share of the domain within which a place is a knot: spans of rounding size are never made."""


@dataclass(frozen=True, eq=False)
class SplineTable:
    """n curves of the same degree, the tables of shorter ones filled up behind their ends.

    Attributes
    ----------
    curves : sequence of PlaneCurve
        At least one.
    """

    curves: Sequence[PlaneCurve]

    @cached_property
    def knots(self) -> FloatArray:
        """Rows (n, k), infinite behind the last."""
        sizes = np.array([curve.knots.size for curve in self.curves])
        knots = np.full((sizes.size, sizes.max()), np.inf)
        knots[np.arange(sizes.max()) < sizes[:, None]] = np.concatenate(
            [curve.knots for curve in self.curves]
        )
        return knots

    @cached_property
    def points(self) -> FloatArray:
        """Rows x w, y w, w of each, (n, m, 3)."""
        sizes = np.array([len(curve.control_points) for curve in self.curves])
        points = np.ones((sizes.size, self.knots.shape[1] - self.degree - 1, 3))
        own = np.arange(points.shape[1]) < sizes[:, None]
        points[own, :2] = np.concatenate([curve.control_points for curve in self.curves])
        for row, curve in zip(points, self.curves, strict=True):
            if curve.weights is not None:
                row[: curve.weights.size, 2] = curve.weights
        points[..., :2] *= points[..., 2:]
        return points

    @cached_property
    def domain(self) -> FloatArray:
        """Of each, (n, 2)."""
        last = np.isfinite(self.knots).sum(axis=1) - self.degree - 1
        return np.column_stack([self.knots[:, self.degree], self.knots[np.arange(last.size), last]])

    @property
    def degree(self) -> int:
        """Of every curve."""
        return self.curves[0].degree

    def chosen(self, rows: IntArray) -> "SplineTable":
        """Some of the curves."""
        known = {name: rows_of[rows] for name, rows_of in vars(self).items() if name != "curves"}
        return SplineTable._of_known([self.curves[i] for i in rows], known)

    @classmethod
    def _of_known(cls, curves: Sequence[PlaneCurve], known: dict[str, FloatArray]) -> "SplineTable":
        """A table of which some is known by name."""
        made = cls(curves)
        vars(made).update(known)
        return made

    def motion(self, which: IntArray, u: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Points and their derivatives by u (n, 2) at places u (n,) in [0, 1] of curves (n,)."""
        p, (first, last) = self.degree, self.domain[which].T
        t = first * (1 - u) + last * u
        last_span = (self.knots < self.domain[:, 1:]).sum(axis=1)[which]
        span = np.minimum((self.knots[which] <= t[:, None]).sum(axis=1), last_span) - 1
        near, points = self._acting(which, span)
        *_, last_but_one, whole = _de_boor(near, points, t)
        (a, b), (point,) = last_but_one, whole
        slope = (b - a) * (p / (near[p] - near[p - 1]))
        position, velocity = quotient([point[:2], slope[:2]], [point[2], slope[2]])
        return position.T, velocity.T * (last - first)[:, None]

    def _acting(self, which: IntArray, span: IntArray) -> tuple[FloatArray, FloatArray]:
        """What acts on spans (n,) of curves (n,): knots (2 degree, n), and points (degree + 1, 3, n)."""
        p, count = self.degree, self.points.shape[1]
        near = self.knots[which, span + np.arange(1 - p, p + 1)[:, None]]
        # places run along the last axis: numpy is slow where that is short
        columns = np.ascontiguousarray(self.points.reshape(-1, 3).T)
        rows = which * count + span + np.arange(-p, 1)[:, None]
        return near, np.ascontiguousarray(columns[:, rows].transpose(1, 0, 2))

    @property
    def spans(self) -> tuple[IntArray, FloatArray, FloatArray]:
        """Of all curves, row by row: whose each is (k,), its first parameter (k,) and its width (k,)."""
        row, column = self._places_of_spans
        low = self.knots[row, column]
        return row, low, self.knots[row, column + 1] - low

    @property
    def bezier(self) -> tuple[IntArray, FloatArray]:
        """Of all spans, row by row: whose each is (k,), and its Bezier points x w, y w, w, (k, degree + 1, 3)."""
        row, column = self._places_of_spans
        near, points = self._acting(row, column)
        return row, extraction(near) @ np.ascontiguousarray(points.transpose(2, 0, 1))

    @property
    def _places_of_spans(self) -> tuple[IntArray, IntArray]:
        """Rows and columns (k,) of the knots at which spans begin."""
        low, high = self.knots[:, :-1], self.knots[:, 1:]
        row, column = np.nonzero((low < high) & (low >= self.domain[:, :1]) & (high <= self.domain[:, 1:]))
        return row, column

    @property
    def lengths(self) -> FloatArray:
        """Arc lengths (n,) of curves without weights, mm, to rounding error.

        Velocities of a span are polynomials of degree p - 1: p places tell them, and these all others.
        """
        nodes = gauss_rule(self.degree)[0]
        row, start, width = self.spans
        (first, _), size = self.domain.T, np.ptp(self.domain, axis=1)
        u = (start[:, None] - first[row, None] + width[:, None] * (1 + nodes) / 2) / size[row, None]
        velocity = self.motion(np.repeat(row, nodes.size), u.ravel())[1].reshape(row.size, nodes.size, 2)
        velocity *= (width / size[row] / 2)[:, None, None]
        powers = np.linalg.inv(np.vander(nodes, increasing=True)) @ velocity

        def speed(span: IntArray, x: FloatArray) -> FloatArray:
            v = powers[span, -1].T
            for k in range(nodes.size - 2, -1, -1):
                v = v * x + powers[span, k].T
            return np.asarray(np.hypot(*v))

        whole, each = np.full(row.size, 2.0), np.arange(row.size)
        lengths = arc_lengths(speed, each, -whole / 2, whole, whole)
        return np.asarray(np.bincount(row, lengths, minlength=len(self.curves)), dtype=float)

    def swept_areas(self, origin: FloatArray) -> FloatArray:
        """Signed areas (n,) swept by the rays from `origin` to curves without weights, mm2, to rounding error.

        `origin` is one place (2,), or that of each curve (n, 2).
        """
        origins = np.broadcast_to(origin, (len(self.curves), 2))
        areas = np.full(len(self.curves), np.nan)
        for i, curve in enumerate(self.curves):
            found = area_beside_graph(curve, origins[i]) if curve.knots.size > LONG else None
            if found is not None:
                areas[i] = found
        others = np.isnan(areas).nonzero()[0]
        if others.size:
            rest = self if others.size == areas.size else self.chosen(others)
            areas[others] = rest._integrated_areas(origins[others])
        return areas

    def _integrated_areas(self, origin: FloatArray) -> FloatArray:
        """The same, of any curves.

        x y' - y x' is of degree 2 p - 1 at most, so p nodes of Gauss a span are exact.
        """
        x, weight = gauss_rule(self.degree)
        row, start, width = self.spans
        half = width / 2
        first, size = self.domain[row, 0], np.ptp(self.domain[row], axis=1)
        u = (start[:, None] - first[:, None] + half[:, None] * (1 + x)) / size[:, None]
        which = np.repeat(row, x.size)
        point, velocity = self.motion(which, u.ravel())
        shares = ((half / size)[:, None] * weight).ravel() * cross(point - origin[which], velocity)
        return np.asarray(0.5 * np.bincount(which, shares, minlength=len(self.curves)), dtype=float)

    def trimmed(self, start: FloatArray, end: FloatArray) -> list[PlaneCurve]:
        """The parts between parameters start < end (n,) as clamped curves (Boehm's knot insertion)."""
        p, each = self.degree, np.arange(len(self.curves))
        start, end = self._snapped(start), self._snapped(end)
        points = self.points.copy()
        last = (self.knots < end[:, None]).sum(axis=1) - 1
        for r, row in enumerate(_de_boor(*self._acting(each, last), end), 1):
            points[each, last - p + r] = row[0].T
        knots = np.minimum(self.knots, end[:, None])
        first = (knots <= start[:, None]).sum(axis=1) - 1
        cut = self._of_known(self.curves, {"knots": knots, "points": points, "domain": self.domain})
        for r, row in enumerate(_de_boor(*cut._acting(each, first), start), 1):
            points[each, first - r] = row[-1].T
        knots = np.maximum(knots, start[:, None])
        places = zip(self.curves, knots, points, (first - p).tolist(), last.tolist(), strict=True)
        return [_clamped(curve, own[i : k + p + 2], rows[i : k + 1]) for curve, own, rows, i, k in places]

    def _snapped(self, t: FloatArray) -> FloatArray:
        """The knots that places (n,) lie at but for rounding, else the places."""
        gap = np.abs(self.knots - t[:, None])
        nearest = np.arange(t.size), gap.argmin(axis=1)
        near = gap[nearest] <= SAME_KNOT * (self.domain[:, 1] - self.domain[:, 0])
        return np.where(near, self.knots[nearest], t)


def _de_boor(near: FloatArray, points: FloatArray, t: FloatArray) -> list[FloatArray]:
    """De Boor's triangle at parameters (n,): its rows (degree, 3, n) to (1, 3, n), from what acts there."""
    degree, rows = len(points) - 1, [points]
    for level in range(1, degree + 1):
        low, high = near[level - 1 : degree], near[degree : 2 * degree - level + 1]
        share = ((t - low) / (high - low))[:, None]
        rows.append(rows[-1][:-1] * (1 - share) + rows[-1][1:] * share)
    return rows[1:]


def _clamped(curve: PlaneCurve, knots: FloatArray, points: FloatArray) -> PlaneCurve:
    w = points[:, 2]
    weights = None if curve.weights is None else w.copy()
    return PlaneCurve.of_sound(knots.copy(), points[:, :2] / w[:, None], curve.degree, weights)
