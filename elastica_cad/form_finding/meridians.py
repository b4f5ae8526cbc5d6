"""Meridians of surfaces of revolution that consist of equal strips (paper, section 9.4)."""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.polynomial import chebyshev

from elastica_cad._cached_property import cached_property
from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import is_number, pair, require_number
from elastica_cad.errors import InputError, Length, NotConvergedError
from elastica_cad.geometry.path import Spline, distances
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.geometry.plane_points import left_of, midpoints, norm, unit_vectors
from elastica_cad.geometry.profile import Profile
from elastica_cad.geometry.splines import finite, fit_spline
from elastica_cad.mechanics.loads import whole_number
from elastica_cad.mechanics.rod import Rod

SEARCH_NODES = 96
"""Approximate number of nodes on the whole meridian."""

FEWEST = 8  # least number of nodes between two given points
STARTS = 30
"""Number of initial guesses of a and b: one guess by regression, the others random.

A meridian satisfies distance from the axis * curvature = a + <b, point>.
"""

STEPS = 40  # largest number of steps of Newton's method
LEAST_SHARE = 1e-3
"""Least fraction of a Newton step that is tried before the search ends."""

SOLVED = 1e-11  # residual below which the equations count as solved, for points scaled to an extent of 1

GOOD = 1e-7
"""Residual below which a meridian is accepted, as a fraction of the extent of the points."""

ROUGH = 1e-2
"""Residual between nodes above which more nodes are useless, because there is no meridian."""

FINER = 3
"""Largest number of times that the number of nodes is doubled."""

BETWEEN = 8
"""Number of points between two nodes at which the residual is checked."""

SETTLED = 1e-10
"""Relative change in a step at which the least-squares iteration ends."""


@dataclass(frozen=True, eq=False)
class FoundMeridian:
    """Result of the search: a meridian as a piecewise polynomial.

    Attributes
    ----------
    a : float
    b : (2,) array
        Parameters of the meridian: distance from the axis * curvature = a + <b, point>.
    points : (n, 2) array
        Points of the meridian from its start, at the given points or nearest to them.
    lengths : (n - 1,) array
        Arc lengths between successive points.
    series : (n - 1, 2, m) array
        Chebyshev coefficients of the two components of the unit tangent in each piece.
    """

    a: float
    b: FloatArray
    points: FloatArray
    lengths: FloatArray
    series: FloatArray

    @property
    def length(self) -> float:
        """Length of the whole meridian."""
        return float(self.lengths.sum())

    def position(self, s: FloatArray) -> FloatArray:
        """Return the points (n, 2) at arc lengths (n,) from the start."""
        marks = np.append(0.0, self.lengths.cumsum())
        piece = (marks.searchsorted(s, side="right") - 1).clip(0, len(self.lengths) - 1)
        places = np.empty((np.size(s), 2))
        for k in np.unique(piece):
            here = piece == k
            station = 2 * (s[here] - marks[k]) / self.lengths[k] - 1
            moved = chebyshev.chebval(station, chebyshev.chebint(self.series[k].T, lbnd=-1))
            places[here] = self.points[k] + self.lengths[k] / 2 * moved.T
        return places

    @cached_property
    def missed(self) -> float:
        """Largest residual of the equation of the meridian, and of unit speed, along the curve.

        If the curve crosses the axis, its distance beyond the axis counts as a residual."""
        if not (self.lengths > 0).all():
            return np.inf
        station = np.linspace(-1.0, 1.0, BETWEEN * self.series.shape[2])
        worst = 0.0
        for start, length, series in zip(self.points, self.lengths, self.series.swapaxes(1, 2), strict=False):
            c, s = chebyshev.chebval(station, series)
            c_slope, s_slope = chebyshev.chebval(station, chebyshev.chebder(series))
            moved = chebyshev.chebval(station, chebyshev.chebint(series, lbnd=-1))
            x, y = start[:, None] + length / 2 * moved
            off = x * (c * s_slope - s * c_slope) * 2 / length - (self.a + self.b[0] * x + self.b[1] * y)
            worst = max(worst, *(float(each.max()) for each in (np.abs(off), np.abs(c**2 + s**2 - 1), -x)))
        return worst / max(1.0, abs(self.a) + float(np.abs(self.b).sum()))


def _search_meridian(points: FloatArray) -> FoundMeridian:
    """Return the meridian through three to five points (n, 2), or the nearest meridian.

    For more than five points (four, if the last is on the axis), or if no meridian passes through the points, the
    sum of squared distances is minimised. The points are scaled to an extent of about 1, and the axis is x = 0.
    """
    if norm(np.diff(points, axis=0)).min() == 0:
        raise InputError("two adjacent points of the meridian are equal: remove one of them")
    closes = bool(points[-1, 0] == 0)
    equations = _Equations(len(points), closes, max(FEWEST, -(-SEARCH_NODES // (len(points) - 1))))
    guess, length = _first_guess(points, equations)
    with np.errstate(over="ignore", invalid="ignore"):
        # five points determine a meridian, or four if the last point is on the axis
        unknown = _through(points, equations, guess, length) if len(points) <= 5 - closes else None
        exact, places = unknown is not None, points
        if unknown is None:
            places, unknown = _nearest(points, equations, points, guess)
        curve, off, before = equations.curve(unknown, places), equations.missed(unknown, places), np.inf
        for _ in range(FINER):
            # double the number of nodes again only if the last doubling reduced the residual to a tenth
            if curve.missed < GOOD or not curve.missed < ROUGH or GOOD < off > 0.1 * before:
                break
            finer = _Equations(len(points), closes, 2 * equations.nodes)
            unknown, equations = equations.at(finer.stations, unknown), finer
            mended = _newton(points, equations, unknown) if exact else None
            if mended is None:
                places, mended = _nearest(points, equations, places, unknown)
            unknown = mended
            curve, off, before = equations.curve(unknown, places), equations.missed(unknown, places), off
    if not (curve.missed < GOOD and off < GOOD):
        raise NotConvergedError(
            "no meridian (profile of the surface) was found near these points. Move the points onto a "
            "smoother curve"
        )
    return curve


class _Equations:
    """Equations of a meridian with one piece between each pair of successive points.

    At the nodes, distance from the axis * curvature = a + <b, point>. Each piece ends at the next point, and the
    angle is continuous. The unknowns are the nodal angles and the length of each piece, followed by a and b (2).
    `closes` is True if the last point is on the axis.

    Attributes
    ----------
    stations : (nodes + 1,) array
        Coordinates of the nodes of a piece, from -1 to 1.
    series, integral, slope : (nodes + 1, nodes + 1) array
        Matrices from values at the nodes to Chebyshev coefficients, to integrals from -1 and to derivatives.
    width, count : int
        Number of unknowns of a piece, and of all unknowns.
    """

    def __init__(self, points: int, closes: bool, nodes: int) -> None:
        self.pieces, self.closes, self.nodes = points - 1, closes, nodes
        n = nodes
        self.stations = -np.cos(np.pi * np.arange(n + 1) / n)
        self.series = np.linalg.inv(chebyshev.chebvander(self.stations, n))
        self.integral = chebyshev.chebval(self.stations, chebyshev.chebint(self.series, lbnd=-1)).T
        self.slope = chebyshev.chebval(self.stations, chebyshev.chebder(self.series)).T
        self.width = n + 2
        self.count = self.pieces * self.width + 3

    def parts(self, unknown: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Split the vector of unknowns into angles (pieces, nodes + 1), lengths (pieces,) and constants (3,).

        The constants are a and the two components of b in the equation of the meridian, a + <b, point>.
        """
        pieces = unknown[:-3].reshape(self.pieces, self.width)
        return pieces[:, :-1], pieces[:, -1], unknown[-3:]

    def at(self, stations: FloatArray, unknown: FloatArray) -> FloatArray:
        """Return the unknowns for other nodes of the pieces, at `stations` from -1 to 1."""
        angles, lengths, constants = self.parts(unknown)
        moved = chebyshev.chebval(stations, self.series @ angles.T)
        return np.concatenate([np.column_stack([moved, lengths]).ravel(), constants])

    def curve(self, unknown: FloatArray, points: FloatArray) -> FoundMeridian:
        angles, lengths, constants = self.parts(unknown)
        tangents = unit_vectors(angles).swapaxes(1, 2)
        return FoundMeridian(float(constants[0]), constants[1:], points, lengths, tangents @ self.series.T)

    def off(self, unknown: FloatArray, points: FloatArray) -> FloatArray:
        """Return the residuals: balance at the nodes, ends of the pieces, joints, and turning at the axis."""
        angles, lengths, (a, b1, b2) = self.parts(unknown)
        half = lengths[:, None] / 2
        x = points[:-1, :1] + half * (np.cos(angles) @ self.integral.T)
        y = points[:-1, 1:] + half * (np.sin(angles) @ self.integral.T)
        # the balance times half the length; its first node is left out, as a slope of degree n - 1 has n conditions
        balance = x * (angles @ self.slope.T) - half * (a + b1 * x + b2 * y)
        ends = np.column_stack([x[:, -1], y[:, -1]]) - points[1:]
        rows = [balance[:, 1:].ravel(), ends.ravel(), angles[1:, 0] - angles[:-1, -1]]
        if self.closes:
            # on the axis, the balance does not contain the curvature, but its derivative by arc length does
            last, turning = angles[-1, -1], self.slope[-1] @ angles[-1]
            rows.append([turning * np.cos(last) - half[-1, 0] * (b1 * np.cos(last) + b2 * np.sin(last))])
        return np.concatenate(rows)

    def missed(self, unknown: FloatArray, points: FloatArray) -> float:
        # largest residual
        return float(np.abs(self.off(unknown, points)).max())

    def slopes(self, unknown: FloatArray, points: FloatArray) -> FloatArray:
        """Return the derivatives of the residuals `off` by the unknowns, and by the coordinates of the points.

        The columns are the `count` unknowns, then x and y of each point.
        """
        angles, lengths, (a, b1, b2) = self.parts(unknown)
        n, wide, total = self.nodes, self.width, self.pieces
        rows = np.zeros((total * (n + 3) - 1 + self.closes, self.count + 2 * total + 2))
        for i in range(total):
            half, turning = lengths[i] / 2, self.slope @ angles[i]
            along, up = self.integral @ np.cos(angles[i]), self.integral @ np.sin(angles[i])
            x, y = points[i, 0] + half * along, points[i, 1] + half * up
            x_angle = -half * self.integral * np.sin(angles[i])
            y_angle = half * self.integral * np.cos(angles[i])
            nodal, ends = slice(i * n, (i + 1) * n), total * n + 2 * i
            first, last, point = i * wide, i * wide + n + 1, self.count + 2 * i
            by_angle = x[:, None] * self.slope + turning[:, None] * x_angle
            rows[nodal, first:last] = (by_angle - half * (b1 * x_angle + b2 * y_angle))[1:]
            by_length = turning * along - (a + b1 * x + b2 * y) - half * (b1 * along + b2 * up)
            rows[nodal, last] = by_length[1:] / 2
            rows[nodal, self.count - 3 : self.count] = -half * np.column_stack([np.ones(n), x[1:], y[1:]])
            rows[nodal, point] = (turning - half * b1)[1:]
            rows[nodal, point + 1] = -half * b2
            rows[ends, first:last], rows[ends + 1, first:last] = x_angle[-1], y_angle[-1]
            rows[ends : ends + 2, last] = along[-1] / 2, up[-1] / 2
            rows[ends : ends + 2, point : point + 4] = np.hstack([np.eye(2), -np.eye(2)])
            if i:
                joint = total * (n + 2) + i - 1
                rows[joint, first], rows[joint, first - 2] = 1.0, -1.0
        if self.closes:
            c, s = np.cos(angles[-1, -1]), np.sin(angles[-1, -1])
            rows[-1, first:last] = self.slope[-1] * c
            rows[-1, last - 1] -= turning[-1] * s + half * (b2 * c - b1 * s)
            rows[-1, last] = -(b1 * c + b2 * s) / 2
            rows[-1, self.count - 2 : self.count] = -half * c, -half * s
        return rows


def _first_guess(points: FloatArray, equations: _Equations) -> tuple[FloatArray, float]:
    """Return a start for Newton's method, from a spline through the points, and the length of the spline.

    The unit of length is the extent of all points. The start has angles and length of each piece, as in
    `_Equations`, followed by a and b. These constants are those of the least-squares fit x kappa = a + <b, p> at
    points p of the spline.
    """
    curve = PlaneCurve(*fit_spline(points, 4, 1e-4), 4)
    s = np.linspace(0.0, curve.length, 4001)
    line = curve.at(s).position
    at = np.sort([s[norm(line - p).argmin()] for p in points])
    at[0], at[-1] = 0.0, curve.length
    middles, halves = midpoints(at), np.diff(at) / 2
    angles = [curve.at(m + h * equations.stations).angle for m, h in zip(middles, halves, strict=True)]
    even = curve.sample(200)
    rows = np.column_stack([np.ones(200), even.position])
    constants = np.linalg.lstsq(rows, even.position[:, 0] * even.curvature, rcond=None)[0]
    return np.concatenate([np.column_stack([angles, 2 * halves]).ravel(), constants]), curve.length


def _through(
    points: FloatArray, equations: _Equations, guess: FloatArray, length: float
) -> FloatArray | None:
    """Return the shortest solution through the points, for several guesses of a and b, or None."""
    # a meridian that is much longer than a smooth curve through the points makes extra turns
    best, shortest = None, 1.5 * length
    chance, size = np.random.default_rng(0), float(np.abs(guess[-3:]).max())
    for trial in range(STARTS):
        start = guess.copy()
        if trial:
            start[-3:] = size * chance.normal(size=3)
        solution = _newton(points, equations, start)
        if solution is None:
            continue
        curve = equations.curve(solution, points)
        if curve.length < shortest and curve.missed < ROUGH:
            best, shortest = solution, curve.length
            if shortest < 1.1 * length:
                break
    return best


def _newton(points: FloatArray, equations: _Equations, unknown: FloatArray) -> FloatArray | None:
    """Return the solution from a guess, by Newton's method with shortened steps, or None."""
    for _ in range(STEPS):
        missed = equations.off(unknown, points)
        size = np.linalg.norm(missed)
        if size < SOLVED:
            return unknown
        step = _least_step(equations.slopes(unknown, points)[:, : equations.count], -missed)
        share = _largest_fraction(equations, unknown, step)
        # `not` makes the condition true for NaN, so that a step to NaN is halved
        while not (
            np.linalg.norm(equations.off(unknown + share * step, points)) <= (1 - 1e-4 * share) * size
        ):
            share /= 2
            if share < LEAST_SHARE:
                return None
        unknown = unknown + share * step
    return None


def _nearest(
    points: FloatArray, equations: _Equations, places: FloatArray, unknown: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Return points (n, 2) and unknowns of `_Equations` for the meridian nearest to given points.

    The method is Gauss-Newton, with the equations as constraints. A step is halved until the sum of squared
    distances and weighted residuals decreases.
    """
    count = equations.count
    # a last point on the axis remains there: its x, the second last column, does not change
    on_axis = np.zeros((int(equations.closes), count + 2 * len(points)))
    on_axis[:, -2] = 1.0
    weight = 10.0
    for _ in range(2 * STEPS):
        missed = np.append(equations.off(unknown, places), np.zeros(len(on_axis)))
        slopes = np.concatenate([equations.slopes(unknown, places), on_axis])
        m, n = slopes.shape
        # conditions of the constrained minimum, for a step of the unknowns, moves of the points and m multipliers;
        # a tiny weight on the unknowns makes their step unique
        system: FloatArray = np.zeros((n + m, n + m))
        system[:n, :n].flat[:: n + 1] = np.append(np.full(count, SETTLED), np.ones(n - count))
        system[n:, :n], system[:n, n:] = slopes, slopes.T
        right = np.concatenate([np.zeros(count), (points - places).ravel(), -missed])
        solved = _least_step(system, right)
        step, move = solved[:count], solved[count:n].reshape(-1, 2)
        # with a weight above all multipliers, the constrained minimum is also a minimum of the merit
        weight = max(weight, 2 * float(np.abs(solved[n:]).max()))

        def merit(u: FloatArray, p: FloatArray, weight: float = weight) -> float:
            return float(((p - points) ** 2).sum() / 2 + weight * np.abs(equations.off(u, p)).sum())

        share, before = _largest_fraction(equations, unknown, step), merit(unknown, places)
        while share > LEAST_SHARE and not merit(unknown + share * step, places + share * move) <= before:
            share /= 2
        unknown, places = unknown + share * step, places + share * move
        if share * max(np.abs(move).max(), np.abs(missed).max()) < SETTLED:
            break
    return places, unknown


def _least_step(system: FloatArray, right: FloatArray) -> FloatArray:
    """Return the least step that solves a linear system with at least as many unknowns as rows."""
    try:
        if len(system) == system.shape[1]:
            return np.asarray(np.linalg.solve(system, right))
        across, corner = np.linalg.qr(system.T)
        return across @ np.linalg.solve(corner.T, right)
    except np.linalg.LinAlgError:
        return np.asarray(np.linalg.lstsq(system, right, rcond=1e-13)[0])


def _largest_fraction(equations: _Equations, unknown: FloatArray, step: FloatArray) -> float:
    """Return a fraction of a step, at most 1, for which all lengths remain positive."""
    lengths, change = equations.parts(unknown)[1], equations.parts(step)[1]
    shrinking = change < 0
    return min(1.0, 0.7 * float((lengths[shrinking] / -change[shrinking]).min(initial=np.inf)))


ACCURACY = 1e-12
"""Relative tolerance of the integrator, which is of order 8."""

NODES = 601
SOUGHT = 25
"""Number of points of a profile curve that the search uses."""

MOST_TURNS = 20
"""Largest number of turns of a meridian; more are useless for a strip and slow to integrate."""

HOPELESS = "the strips of a surface of revolution cannot follow these points"
TO_THE_POLE = ". So near to the axis, end the points on it (x = 0), or on a ring farther away"


@dataclass(frozen=True, eq=False)
class Meridian:
    """A meridian in the half plane x > 0 of a surface of revolution about the axis x = 0.

    Attributes
    ----------
    a : float
    b : (2,) array
        Parameters of the meridian: distance from the axis * curvature = a + <b, point>. a is dimensionless, and b
        is in 1/mm.
    curve : PlaneCurve
        Curve of the meridian, mm.
    at_pole : bool
        True if the meridian ends at the axis or at the requested ring.
    deviation : float
        Largest distance from the given points, mm; 0 if no points were given.
    """

    a: float
    b: FloatArray
    curve: PlaneCurve
    at_pole: bool = False
    deviation: float = 0.0

    @property
    def ring(self) -> tuple[float, float]:
        """Distances of the start and the end from the axis, mm."""
        t0, t1 = self.curve.domain
        return float(self.curve.evaluate(t0)[0]), float(self.curve.evaluate(t1)[0])

    @cached_property
    def distance(self) -> Profile:
        """Distance from the axis as a function of the arc length, mm."""
        return Profile.fit(lambda s: self.curve.at(s).position[:, 0], self.curve.length, tolerance=1e-7)

    def width(self, strips: int) -> Profile:
        """Return the width of one of `strips` equal strips, mm, as a function of the arc length.

        The width is 2 tan(pi / strips) times the distance from the axis.
        """
        whole_number(strips, "the number of strips of a surface of revolution", 3)
        return self.distance.scaled(2 * float(np.tan(np.pi / strips)))

    def to_ring(self, ring: float) -> "Meridian":
        """Return the part of the meridian that ends where the distance from the axis falls to `ring`, mm."""
        curve = self.curve
        end = _end(
            lambda s: curve.at(s).position[:, 0],
            curve.length,
            _distance_at_end(self.ring[0], curve.length, ring),
        )
        cut = _fitted(lambda s: curve.at(s).position, end, curve.length)
        return replace(self, curve=cut, at_pole=self.at_pole or end < curve.length)

    @cached_property
    def rod(self) -> Rod:
        """Rod of one strip of the surface.

        The stiffness is proportional to the distance from the axis. The moment is proportional to a + <b, point>
        (paper, Eq. 4).
        """
        nodes = self.curve.sample(NODES)
        x = nodes.position[:, 0]
        least = float(x.min())
        moment = (self.a + nodes.position @ self.b) / least
        size = float(np.abs(moment).max())
        off = float(np.abs(x / least * nodes.curvature - moment).max())
        force = np.broadcast_to(left_of(self.b) / least, nodes.position.shape)
        return Rod(
            s=nodes.s, position=nodes.position, angle=nodes.angle, curvature=nodes.curvature, stiffness=x / least,
            moment=moment, force=force, profile=self.distance.scaled(1 / least), shape=self.curve,
            residual=off / size if size > 0 else off,
        )  # fmt: skip


def meridian(
    a: float,
    b: ArrayLike,
    start: ArrayLike,
    angle: float,
    length: float,
    *,
    ring: float | None = None,
) -> Meridian:
    """Return the meridian with a given start point and direction.

    Parameters
    ----------
    a : float
        Dimensionless parameter of the equation distance from the axis * curvature = a + <b, point>.
    b : (2,) array_like
        Parameter of the same equation, 1/mm. For supports that are symmetric about the axis, b is a multiple of
        (0, 1).
    start : (2,) array_like
        Start point, mm. Its first coordinate is the distance from the axis, which must be positive.
    angle : float
        Angle of the tangent at the start, from the direction away from the axis, rad.
    length : float
        Length, mm. The meridian ends earlier if it reaches the axis.
    ring : float, optional
        Distance from the axis, mm, at which the meridian ends. The default is a small fraction of the size of the
        meridian, because strips need some width at the end.

    Raises
    ------
    NotConvergedError
        The curvature increases without limit.

    Examples
    --------
    >>> flat = meridian(0.0, (0, 0), (100, 0), np.pi / 2, 50)
    >>> flat.curve.is_straight, round(flat.curve.length, 6)
    (True, 50.0)
    """
    rows = [a], pair(b, "b of a meridian"), pair(start, "start of a meridian"), [angle, length]
    p = np.array([require_number(number, "a number of a meridian") for row in rows for number in row])
    if not (p[3] > 0 and p[6] > 0):
        raise InputError(
            "the meridian starts at x = {p:g} and is {p_2:g} long: give positive numbers, in mm",
            p=Length(p[3]),
            p_2=Length(p[6]),
        )
    _refuse_winding(p)
    end, shape = _integrated(p[:6], p[6], _distance_at_end(float(p[3]), float(p[6]), ring))
    curve = _fitted(lambda s: shape(s)[:2].T, end, float(p[6]))
    return Meridian(float(p[0]), p[1:3], curve, at_pole=end < p[6])


def meridian_through(points: ArrayLike | PlaneCurve, *, ring: float | None = None) -> Meridian:
    """Return the meridian through up to five points, or the nearest meridian to a profile.

    Five points determine a meridian, or four points if the last point is on the axis. For more points, or if every
    meridian through the points has extra turns, the sum of squared distances is minimised. `deviation` is then the
    largest distance.

    Parameters
    ----------
    points : (n, 2) array_like or PlaneCurve
        Points in order with x > 0, mm, or a profile curve. If the last point is on the axis x = 0, the surface
        closes there. The meridian starts near the first point and ends near the last point.
    ring : float, optional
        Distance from the axis, mm, at which a surface that closes on the axis ends: see `meridian`.

    Raises
    ------
    NotConvergedError
        There is no meridian near the points.

    Examples
    --------
    >>> vase = meridian_through([(60, 0), (80, 50), (70, 80), (55, 110), (50, 150)])
    >>> vase.deviation < 1e-6
    True
    """
    if isinstance(points, PlaneCurve):
        points = points.sample(SOUGHT).position
    data = _checked_points(points)
    size = float(norm(np.ptp(data, axis=0)))
    chosen = np.unique(np.linspace(0, len(data) - 1, min(len(data), SOUGHT)).round().astype(int))
    try:
        shape = _search_meridian(data[chosen] / size)
        if not shape.points[0, 0] > 0:
            raise NotConvergedError(
                "the nearest meridian (profile of the surface) begins beyond the axis. Move its first point "
                "away from the axis"
            )
        length, start = shape.length * size, float(shape.points[0, 0]) * size

        def position(s: FloatArray) -> FloatArray:
            return size * shape.position(s / size)

        end = _end(lambda s: position(s)[:, 0], length, _distance_at_end(start, length, ring))
        curve = _fitted(position, end, length)
    except NotConvergedError as problem:
        # the last point is near the axis, compared with the largest distance from it
        advice = TO_THE_POLE if data[-1, 0] < 0.05 * data[:, 0].max() else ""
        raise NotConvergedError(f"{HOPELESS}: {problem}{advice}") from problem
    closes = end < length
    if len(chosen) == len(data):
        gaps = norm(size * shape.points - data)
    else:
        gaps = distances(Spline(_fitted(position, length, length)), data)
    if not gaps.max() <= 0.25 * size:
        raise NotConvergedError(
            "{hopeless}: every meridian (profile of the surface) is at least {most} from point number "
            "{given}. Move this point",
            most=Length(gaps.max()),
            given=int(gaps.argmax()) + 1,
            hopeless=HOPELESS,
        )
    return Meridian(shape.a, shape.b / size, curve, closes, float(gaps.max()))


def _fitted(position: Callable[[FloatArray], FloatArray], end: float, length: float) -> PlaneCurve:
    """Return the curve up to the arc length `end`, mm, of a meridian of the given length, mm."""
    return PlaneCurve.fit_function(position, 0.0, end, tolerance=1e-10 * length, degree=5)


def _distance_at_end(start: float, length: float, ring: float | None) -> float:
    # distance from the axis, mm, at which the meridian ends; `start` is its distance at the start
    if ring is None:
        # a thousandth of the size of the meridian
        return min(1e-3 * (start + length), start / 2)
    if not (is_number(ring) and 0 < ring < start):
        raise InputError(
            "the radius `ring` is {ring}: give a number above 0 and below {start:g}, the radius at the start",
            ring=ring,
            start=Length(start),
        )
    return float(ring)


def _end(distance: Callable[[FloatArray], FloatArray], length: float, floor: float) -> float:
    """Return the arc length, mm, at which the distance from the axis falls to `floor`, or the whole length."""
    from scipy.optimize import brentq

    s = np.linspace(0.0, length, 2001)
    low = np.flatnonzero(distance(s) <= floor)
    if not low.size or low[0] == 0:
        return float(s[-1])
    return float(
        brentq(
            lambda at: float(distance(np.array([at]))[0]) - floor,
            s[low[0] - 1],
            s[low[0]],
            xtol=1e-12 * length,
        )
    )


def _checked_points(points: ArrayLike) -> FloatArray:
    data = finite("the points of a meridian", points)
    if data.ndim != 2 or data.shape[1] != 2 or len(data) < 3:
        raise InputError("the meridian cannot be read: give at least three points (x, y), in mm")
    # move a last point onto the axis if its distance from the axis is a rounding error
    if abs(data[-1, 0]) < 1e-9 * np.ptp(data):
        data = np.append(data[:-1], [[0.0, data[-1, 1]]], axis=0)
    beyond = np.append(data[:-1, 0] <= 0, data[-1, 0] < 0)
    if beyond.any():
        i = int(beyond.argmax())
        raise InputError(
            f"point {i + 1} at {data[i].tolist()} is on or beyond the axis x = 0: keep x positive "
            "(the last point may be on the axis)"
        )
    return data


def _integrated(
    p: FloatArray, length: float, floor: float
) -> tuple[float, Callable[[FloatArray], FloatArray]]:
    """Return the arc length of the end, and a function that returns x, y and angle (3, n) at n arc lengths.

    The parameters p (6,) are a, b (2), the start (2) and the angle there. The meridian ends at the distance `floor`
    from the axis.
    """
    from scipy.integrate import solve_ivp

    a, b1, b2 = p[:3]

    def slope(_: float, state: FloatArray) -> list[float]:
        x, y, angle = state
        return [float(np.cos(angle)), float(np.sin(angle)), float((a + b1 * x + b2 * y) / x)]

    def at_axis(_: float, state: FloatArray) -> float:
        return float(state[0] - floor)

    def winding(_: float, state: FloatArray) -> float:
        return 2 * np.pi * MOST_TURNS - abs(float(state[2] - p[5]))

    at_axis.__dict__.update(terminal=True, direction=-1.0)
    winding.__dict__.update(terminal=True)
    scale = max(length, 1e-300)
    solution = solve_ivp(
        slope, (0.0, length), p[3:6], method="DOP853", rtol=ACCURACY, atol=ACCURACY * scale, dense_output=True,
        events=(at_axis, winding), max_step=length / 40,
    )  # fmt: skip
    if not solution.success:
        raise NotConvergedError(
            (
                "the curvature of the meridian grows without limit {t:.4g} from its start, close to the "
                "axis: end the meridian there"
            ),
            t=Length(solution.t[-1]),
        )
    if solution.t_events[1].size:
        raise InputError(
            "the meridian makes {most_turns} turns in the first {t:.4g} of its length of {length:g}: make a "
            "and b smaller, or the meridian shorter",
            most_turns=MOST_TURNS,
            t=Length(solution.t[-1]),
            length=Length(length),
        )
    return float(solution.t[-1]), solution.sol


def _refuse_winding(p: FloatArray) -> None:
    """Refuse a meridian that may make more than `MOST_TURNS` turns.

    Its parameters p are a, b (2), the start (2), the angle there, and the length.
    """
    a, b, start, length = p[0], p[1:3], p[3:5], p[6]
    with np.errstate(over="ignore"):
        bending = abs(a + b @ start) / start[0]
        most = max(bending, np.sqrt(norm(b) / (start[0] + length)))
        too_much = most * length > 2 * np.pi * MOST_TURNS
    if too_much:
        raise InputError(
            "with a={a:g} and b=({b:g}, {b_2:g}), the meridian is bent at its start to a radius of about "
            "{most}, too small for its length of {length:g}. Make a and b smaller (a has no unit, b is in "
            "1/mm)",
            a=a,
            b=b[0],
            b_2=b[1],
            most=Length(1 / most),
            length=Length(length),
        )
