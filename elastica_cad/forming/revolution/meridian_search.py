"""The search for the meridian through given points: all of it at once, by collocation.

From one end to the other a meridian may grow exponentially with its constants, so that shooting gets lost between
the points. Here the angle at Chebyshev nodes between every two points is unknown, besides the lengths, the points
on the meridian and a, b of x kappa = a + <b, gamma>, and Newton's method mends them together.

At the pole x = 0 the equation says nothing of the curvature, and all but one in a family of solutions wind without
end: a + <b, gamma> must vanish there, and its slope gives the curvature, kappa <e1, t> = <b, t> (de l'Hospital).
"""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.polynomial import chebyshev

from elastica_cad._types import FloatArray
from elastica_cad.errors import InputError, NotConvergedError
from elastica_cad.geometry.curves.plane_curve import PlaneCurve

EXACT_POINTS = 5
"""a, b and the start in space and direction, but for sliding along: so many points fix a meridian; one less where
the last is its pole, which takes two freedoms."""

NODES = 96
"""About so many along the whole meridian, at least `FEWEST` between two points."""

FEWEST = 8  # nodes between two points
STARTS = 30
"""First guesses of a and b that are tried: the regression's, then others of its size, always the same."""

STEPS = 40  # of Newton's method
LEAST_SHARE = 1e-3
"""Of a step; where less of it would be needed the search leads nowhere."""

SOLVED = 1e-11  # equations missed by less, for points of size 1, hold
LONGEST = 1.5
"""A meridian longer than this times the smooth curve through the points winds about between them."""

GOOD = 1e-7
"""Equations missed by more than this share of the size were not solved."""

ROUGH = 1e-2
"""What misses the equations between the nodes by more is no meridian seen too coarsely, but none at all."""

FINER = 3
"""How often nodes are doubled where they are too far apart."""

BETWEEN = 8
"""Places in the room of a node at which a solution is looked at between the nodes."""

STUCK = 0.1
"""Where twice the nodes leave more than this share of what was missed with fewer, still more lead nowhere."""

SETTLED = 1e-10
"""Least squares end where a step changes nothing by more than this share of the size."""


@dataclass(frozen=True, eq=False)
class FoundMeridian:
    """What the search found.

    Attributes
    ----------
    a : float
    b : (2,) array
    points : (n, 2) array
        Places on the meridian, those sought or the nearest to them; the first is its start.
    lengths : (n - 1,) array
        Arc lengths between them.
    series : (n - 1, 2, m) array
        Of every piece the Chebyshev coefficients of the tangent's components.
    """

    a: float
    b: FloatArray
    points: FloatArray
    lengths: FloatArray
    series: FloatArray

    @property
    def length(self) -> float:
        """Of the whole meridian."""
        return float(self.lengths.sum())

    def position(self, s: FloatArray) -> FloatArray:
        """Places (n, 2) at arc lengths (n,) from the start."""
        marks = np.append(0.0, np.cumsum(self.lengths))
        piece = np.clip(np.searchsorted(marks, s, side="right") - 1, 0, len(self.lengths) - 1)
        places = np.empty((np.size(s), 2))
        for k in np.unique(piece):
            here = piece == k
            station = 2 * (s[here] - marks[k]) / self.lengths[k] - 1
            moved = [chebyshev.chebval(station, chebyshev.chebint(row, lbnd=-1)) for row in self.series[k]]
            places[here] = self.points[k] + self.lengths[k] / 2 * np.column_stack(moved)
        return places

    @cached_property
    def missed(self) -> float:
        """By how much the curve anywhere misses x kappa = a + <b, gamma> and unit speed, or crosses the axis."""
        if not np.all(self.lengths > 0):
            return np.inf
        station = np.linspace(-1.0, 1.0, BETWEEN * self.series.shape[2])
        worst = 0.0
        for start, length, rows in zip(self.points, self.lengths, self.series, strict=False):
            c, s = (chebyshev.chebval(station, row) for row in rows)
            c_slope, s_slope = (chebyshev.chebval(station, chebyshev.chebder(row)) for row in rows)
            x, y = (
                p + length / 2 * chebyshev.chebval(station, chebyshev.chebint(row, lbnd=-1))
                for p, row in zip(start, rows, strict=True)
            )
            off = x * (c * s_slope - s * c_slope) * 2 / length - (self.a + self.b[0] * x + self.b[1] * y)
            worst = max(worst, *(float(each.max()) for each in (np.abs(off), np.abs(c**2 + s**2 - 1), -x)))
        return worst / max(1.0, abs(self.a) + float(np.abs(self.b).sum()))


def search_meridian(points: FloatArray) -> FoundMeridian:
    """The meridian through three to five points, or by least squares of the distances where there is none or more.

    Parameters
    ----------
    points : (n, 2) array
        In order, of size about 1, x >= 0; where the last has x = 0 it is the pole.

    Raises
    ------
    InputError
        Two neighbouring points are the same.
    NotConvergedError
        The search ended beside every meridian.
    """
    if np.linalg.norm(np.diff(points, axis=0), axis=1).min() == 0:
        raise InputError("two neighbouring points of the meridian are the same: leave one out")
    closes = bool(points[-1, 0] == 0)
    equations = _Equations(len(points), closes, max(FEWEST, -(-NODES // (len(points) - 1))))
    guess, length = _first_guess(points, equations)
    with np.errstate(over="ignore", invalid="ignore"):
        unknown = _through(points, equations, guess, length) if len(points) <= EXACT_POINTS - closes else None
        exact, places = unknown is not None, points
        if unknown is None:
            places, unknown = _nearest(points, equations, points, guess)
        found, off, before = equations.curve(unknown, places), equations.missed(unknown, places), np.inf
        for _ in range(FINER):
            if found.missed < GOOD or not found.missed < ROUGH or GOOD < off > STUCK * before:
                break
            finer = _Equations(len(points), closes, 2 * equations.nodes)
            unknown, equations = equations.at(finer.stations, unknown), finer
            mended = _newton(points, equations, unknown) if exact else None
            if mended is None:
                places, mended = _nearest(points, equations, places, unknown)
            unknown = mended
            found, off, before = equations.curve(unknown, places), equations.missed(unknown, places), off
    if not (found.missed < GOOD and off < GOOD):
        raise NotConvergedError("no meridian was found near these points")
    return found


class _Equations:
    """x kappa = a + <b, gamma> at the nodes, pieces that end at the next point, angles that go on.

    Unknown are, piece by piece, the angles at the nodes and the length, then a and b.
    """

    def __init__(self, points: int, closes: bool, nodes: int) -> None:
        self.pieces, self.closes, self.nodes = points - 1, closes, nodes
        n = nodes
        self.stations = -np.cos(np.pi * np.arange(n + 1) / n)
        self.series = np.linalg.inv(chebyshev.chebvander(self.stations, n))
        unit = np.eye(n + 1)
        integral = [chebyshev.chebval(self.stations, chebyshev.chebint(row, lbnd=-1)) for row in unit]
        slope = [chebyshev.chebval(self.stations, chebyshev.chebder(row)) for row in unit]
        self.integral, self.slope = (
            np.column_stack(integral) @ self.series,
            np.column_stack(slope) @ self.series,
        )
        self.width = n + 2
        self.count = self.pieces * self.width + 3

    def parts(self, unknown: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Angles (pieces, nodes + 1), lengths (pieces,), and a, b (3,)."""
        pieces = unknown[:-3].reshape(self.pieces, self.width)
        return pieces[:, :-1], pieces[:, -1], unknown[-3:]

    def at(self, stations: FloatArray, unknown: FloatArray) -> FloatArray:
        """The unknowns with the angles at other stations."""
        angles, lengths, constants = self.parts(unknown)
        moved = chebyshev.chebval(stations, self.series @ angles.T)
        return np.concatenate([np.column_stack([moved, lengths]).ravel(), constants])

    def curve(self, unknown: FloatArray, points: FloatArray) -> FoundMeridian:
        """The meridian of the unknowns."""
        angles, lengths, constants = self.parts(unknown)
        tangents = np.stack([np.cos(angles), np.sin(angles)], axis=1)
        return FoundMeridian(float(constants[0]), constants[1:], points, lengths, tangents @ self.series.T)

    def off(self, unknown: FloatArray, points: FloatArray) -> FloatArray:
        """By how much the equations are missed (m,)."""
        angles, lengths, (a, b1, b2) = self.parts(unknown)
        half = lengths[:, None] / 2
        x = points[:-1, :1] + half * (np.cos(angles) @ self.integral.T)
        y = points[:-1, 1:] + half * (np.sin(angles) @ self.integral.T)
        balance = x * (angles @ self.slope.T) - half * (a + b1 * x + b2 * y)
        ends = np.column_stack([x[:, -1], y[:, -1]]) - points[1:]
        joints = angles[1:, 0] - angles[:-1, -1]
        rows = [balance[:, 1:].ravel(), ends.ravel(), joints]
        if self.closes:
            last, turning = angles[-1, -1], self.slope[-1] @ angles[-1]
            rows.append([turning * np.cos(last) - half[-1, 0] * (b1 * np.cos(last) + b2 * np.sin(last))])
        return np.concatenate(rows)

    def missed(self, unknown: FloatArray, points: FloatArray) -> float:
        """By how much they are missed at most."""
        return float(np.abs(self.off(unknown, points)).max())

    def slopes(self, unknown: FloatArray, points: FloatArray) -> FloatArray:
        """Derivatives (m, count + 2 n) by the unknowns and by the points."""
        angles, lengths, (a, b1, b2) = self.parts(unknown)
        n, wide, total = self.nodes, self.width, self.pieces
        rows = np.zeros((total * (n + 3) - 1 + self.closes, self.count + 2 * total + 2))
        for i in range(total):
            half, turning = lengths[i] / 2, self.slope @ angles[i]
            along, up = self.integral @ np.cos(angles[i]), self.integral @ np.sin(angles[i])
            x, y = points[i, 0] + half * along, points[i, 1] + half * up
            x_angle = -half * self.integral * np.sin(angles[i])
            y_angle = half * self.integral * np.cos(angles[i])
            own, ends = slice(i * n, (i + 1) * n), total * n + 2 * i
            first, last, point = i * wide, i * wide + n + 1, self.count + 2 * i
            by_angle = x[:, None] * self.slope + turning[:, None] * x_angle
            rows[own, first:last] = (by_angle - half * (b1 * x_angle + b2 * y_angle))[1:]
            by_length = turning * along - (a + b1 * x + b2 * y) - half * (b1 * along + b2 * up)
            rows[own, last] = by_length[1:] / 2
            rows[own, self.count - 3 : self.count] = -half * np.column_stack([np.ones(n), x[1:], y[1:]])
            rows[own, point] = (turning - half * b1)[1:]
            rows[own, point + 1] = -half * b2
            rows[ends, first:last], rows[ends + 1, first:last] = x_angle[-1], y_angle[-1]
            rows[ends : ends + 2, last] = along[-1] / 2, up[-1] / 2
            rows[ends : ends + 2, point : point + 4] = np.hstack([np.eye(2), -np.eye(2)])
            if i:
                joint = total * (n + 2) + i - 1
                rows[joint, first], rows[joint, first - 2] = 1.0, -1.0
        if self.closes:
            # half, turning, first and last are the last piece's
            c, s = np.cos(angles[-1, -1]), np.sin(angles[-1, -1])
            rows[-1, first:last] = self.slope[-1] * c
            rows[-1, last - 1] -= turning[-1] * s + half * (b2 * c - b1 * s)
            rows[-1, last] = -(b1 * c + b2 * s) / 2
            rows[-1, self.count - 2 : self.count] = -half * c, -half * s
        return rows


def _first_guess(points: FloatArray, equations: _Equations) -> tuple[FloatArray, float]:
    """The unknowns of a smooth curve through the points, a and b by regression; and its length."""
    curve = PlaneCurve.fit(points, degree=4, tolerance=1e-4)
    s = np.linspace(0.0, curve.length, 4001)
    line = curve.at(s).position
    at = np.sort([s[int(np.argmin(np.hypot(*(line - p).T)))] for p in points])
    at[0], at[-1] = 0.0, curve.length
    middles, halves = (at[1:] + at[:-1]) / 2, np.diff(at) / 2
    angles = [curve.at(m + h * equations.stations).angle for m, h in zip(middles, halves, strict=True)]
    even = curve.sample(200)
    rows = np.column_stack([np.ones(200), even.position])
    constants = np.linalg.lstsq(rows, even.position[:, 0] * even.curvature, rcond=None)[0]
    pieces = np.column_stack([angles, 2 * halves])
    return np.concatenate([pieces.ravel(), constants]), curve.length


def _through(
    points: FloatArray, equations: _Equations, guess: FloatArray, length: float
) -> FloatArray | None:
    """The unknowns of the meridian through all points that winds the least, if one was found."""
    best, shortest = None, LONGEST * length
    chance, size = np.random.default_rng(0), float(np.abs(guess[-3:]).max())
    for trial in range(STARTS):
        start = guess.copy()
        if trial:
            start[-3:] = size * chance.normal(size=3)
        found = _newton(points, equations, start)
        if found is None:
            continue
        curve = equations.curve(found, points)
        if curve.length < shortest and curve.missed < ROUGH:
            best, shortest = found, curve.length
            if shortest < 1.1 * length:
                break
    return best


def _newton(points: FloatArray, equations: _Equations, unknown: FloatArray) -> FloatArray | None:
    """Newton's method with the least steps where equations are fewer than unknowns."""
    for _ in range(STEPS):
        missed = equations.off(unknown, points)
        size = float(np.linalg.norm(missed))
        if size < SOLVED:
            return unknown
        slopes = equations.slopes(unknown, points)[:, : equations.count]
        step = _least_step(slopes, -missed)
        share = _most(equations, unknown, step)
        # written so that a step to nowhere (not a number) is halved too
        while not (
            float(np.linalg.norm(equations.off(unknown + share * step, points))) <= (1 - 1e-4 * share) * size
        ):
            share /= 2
            if share < LEAST_SHARE:
                return None
        unknown = unknown + share * step
    return None


def _nearest(
    points: FloatArray, equations: _Equations, places: FloatArray, unknown: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Places on the meridian nearest to the points, in the sum of squares, and its unknowns.

    Gauss and Newton with the equations as constraints: each step solves for the places that the linear model
    brings nearest to the points, and is shortened until distance and missed equations together fall.
    """
    count = equations.count
    on_axis = np.zeros((int(equations.closes), count + 2 * len(points)))
    on_axis[:, -2] = 1.0
    weight = 10.0
    for _ in range(2 * STEPS):
        missed = np.append(equations.off(unknown, places), np.zeros(len(on_axis)))
        slopes = np.concatenate([equations.slopes(unknown, places), on_axis])
        m, n = slopes.shape
        system: FloatArray = np.zeros((n + m, n + m))
        system[:n, :n].flat[:: n + 1] = np.append(np.full(count, SETTLED), np.ones(n - count))
        system[n:, :n], system[:n, n:] = slopes, slopes.T
        right = np.concatenate([np.zeros(count), (points - places).ravel(), -missed])
        solved = _least_step(system, right)
        step, move = solved[:count], solved[count:n].reshape(-1, 2)
        weight = max(weight, 2 * float(np.abs(solved[n:]).max()))

        def merit(u: FloatArray, p: FloatArray, weight: float = weight) -> float:
            return float(((p - points) ** 2).sum() / 2 + weight * np.abs(equations.off(u, p)).sum())

        share, before = _most(equations, unknown, step), merit(unknown, places)
        while share > LEAST_SHARE and not merit(unknown + share * step, places + share * move) <= before:
            share /= 2
        unknown, places = unknown + share * step, places + share * move
        if share * max(float(np.abs(move).max()), float(np.abs(missed).max())) < SETTLED:
            break
    return places, unknown


def _least_step(system: FloatArray, right: FloatArray) -> FloatArray:
    """The solution of linear equations (m, n), m <= n, of several the smallest."""
    try:
        if system.shape[0] == system.shape[1]:
            return np.asarray(np.linalg.solve(system, right))
        across, corner = np.linalg.qr(system.T)
        return np.asarray(across @ np.linalg.solve(corner.T, right))
    except np.linalg.LinAlgError:
        return np.asarray(np.linalg.lstsq(system, right, rcond=1e-13)[0])


def _most(equations: _Equations, unknown: FloatArray, step: FloatArray) -> float:
    """The largest share of a step, up to 1, that leaves all lengths positive."""
    lengths, change = equations.parts(unknown)[1], equations.parts(step)[1]
    shrinking = change < 0
    return min(1.0, 0.7 * float((lengths[shrinking] / -change[shrinking]).min())) if shrinking.any() else 1.0
