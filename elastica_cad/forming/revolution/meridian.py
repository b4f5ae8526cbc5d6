"""Meridians of surfaces of revolution that equal strips tile without gaps (paper, section 9.4).

A strip closes the gap to its neighbours where its width is proportional to the distance from the axis; as the
width is the stiffness, Eq. 3 becomes <e1, gamma> kappa = a + <b, gamma>, which is integrated here.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import is_number
from elastica_cad.errors import InputError, NotConvergedError
from elastica_cad.forming.revolution.meridian_search import FoundMeridian, search_meridian
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.paths.point_distance import distances
from elastica_cad.geometry.paths.profile import Profile
from elastica_cad.geometry.paths.segments import Spline
from elastica_cad.geometry.polynomials.splines import finite
from elastica_cad.mechanics.rod.rod_record import Rod

ACCURACY = 1e-12
"""Relative tolerance of the integrator, of order 8."""

CURVE_TOLERANCE = 1e-10
"""Of the spline, in lengths of the meridian."""

NODES = 601  # of the rod
SOUGHT = 25
"""Points of a profile that the search looks at."""

ON_AXIS_SHARE = 1e-9
"""A last point nearer to the axis than this share of all points' size is meant to lie on it."""

MOST_TURNS = 20
"""A meridian that turns about more often within its length is no strip, and its integration takes too long."""

HOPELESS = "strips that tile a surface of revolution cannot follow them"
NEAR_AXIS_SHARE = 0.05  # of the largest distance from the axis
TO_THE_POLE = "; so near to the axis end them on it (x = 0), or on a ring farther away"
"""Said where the last point is nearer to the axis than a share of the farthest."""

NARROW_SHARE = 1e-3
"""A meridian nearer to the axis than this share of its largest distance has come to the pole."""


@dataclass(frozen=True, eq=False)
class Meridian:
    """A meridian in the half plane x > 0; the axis is x = 0.

    Attributes
    ----------
    a : float
    b : (2,) array
        x kappa = a + <b, gamma>; b in 1/mm, a without unit.
    curve : PlaneCurve
        mm.
    at_pole : bool
        Did it end because it came to the axis, or to the ring asked for?
    deviation : float
        Largest distance from the points it was sought through, mm; 0 where none were given.
    """

    a: float
    b: FloatArray
    curve: PlaneCurve
    at_pole: bool = False
    deviation: float = 0.0

    @property
    def ring(self) -> tuple[float, float]:
        """Distance of the start and of the end from the axis, mm."""
        t0, t1 = self.curve.domain
        return float(self.curve.evaluate(t0)[0]), float(self.curve.evaluate(t1)[0])

    @cached_property
    def distance(self) -> Profile:
        """Distance from the axis over arc length, mm."""
        return Profile.fit(lambda s: self.curve.at(s).position[:, 0], self.curve.length, tolerance=1e-7)

    def width(self, strips: int) -> Profile:
        """Width of each of so many strips, 2 tan(pi / strips) times the distance from the axis, mm."""
        if strips < 3:
            raise InputError(f"strips={strips}: a surface of revolution is tiled by 3 strips or more")
        return self.distance.scaled(2 * float(np.tan(np.pi / strips)))

    def to_ring(self, ring: float) -> "Meridian":
        """The same, but ended where its distance from the axis first falls to this, mm."""
        curve = self.curve
        end = _end(
            lambda s: curve.at(s).position[:, 0], curve.length, _floor(self.ring[0], curve.length, ring)
        )
        cut = PlaneCurve.fit_function(
            lambda s: curve.at(s).position, 0.0, end, tolerance=CURVE_TOLERANCE * curve.length, degree=5
        )
        return Meridian(self.a, self.b, cut, self.at_pole or end < curve.length, self.deviation)

    @cached_property
    def rod(self) -> Rod:
        """The strip's rod: its stiffness is the distance from the axis, its moment a + <b, gamma>."""
        nodes = self.curve.sample(NODES)
        x = nodes.position[:, 0]
        least = float(x.min())
        moment = (self.a + nodes.position @ self.b) / least
        size = float(np.abs(moment).max())
        off = float(np.abs(x / least * nodes.curvature - moment).max())
        force = np.broadcast_to(np.array([-self.b[1], self.b[0]]) / least, nodes.position.shape)
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
    """The meridian that starts at a point in a direction.

    Parameters
    ----------
    a : float
        Moment at the origin over stiffness and distance; no unit.
    b : (2,) array_like
        Its change, 1/mm. A multiple of (0, 1) lets one end turn freely about the axis (symmetric supports).
    start : (2,) array_like
        mm; the first number is the distance from the axis, positive.
    angle : float
        Of the tangent at the start against the direction away from the axis, rad.
    length : float
        mm; the meridian ends before where it comes to the axis.
    ring : float, optional
        It ends where its distance from the axis falls to this, mm; at a thousandth of its largest unless given
        (a strip has some width at the pole).

    Raises
    ------
    InputError
        Numbers that are not finite, a start on the axis, a length that is not positive, constants that make the
        meridian wind about.
    NotConvergedError
        The curvature grows without bounds.

    Examples
    --------
    >>> flat = meridian(0.0, (0, 0), (100, 0), np.pi / 2, 50)
    >>> flat.curve.is_straight, round(flat.curve.length, 6)
    (True, 50.0)
    """
    p = _numbers(a, b, start, angle, length)
    if not (p[3] > 0 and p[6] > 0):
        raise InputError(
            f"a meridian starts beside its axis and has a length: start x = {p[3]:g} mm, length = {p[6]:g} mm"
        )
    _refuse_winding(p)
    end, shape = _integrated(p[:6], p[6], _floor(float(p[3]), float(p[6]), ring))
    curve = PlaneCurve.fit_function(
        lambda s: shape(s)[:2].T, 0.0, end, tolerance=CURVE_TOLERANCE * float(p[6]), degree=5
    )
    return Meridian(float(p[0]), p[1:3], curve, at_pole=end < p[6])


def meridian_through(points: ArrayLike | PlaneCurve, *, ring: float | None = None) -> Meridian:
    """The meridian through up to five points where there is one, or as near to points as there is (a profile).

    a, b, the start and the first direction give a meridian five freedoms, so five points fix it; four where the
    last is its pole, on the axis. Where none passes them without winding about, and for more points, the squares
    of the distances are made least; `deviation` says how far the farthest is off.

    Parameters
    ----------
    points : (n, 2) array_like or PlaneCurve
        In order, mm, at x > 0, the last perhaps on the axis, where the surface then closes at the pole; or a whole
        profile. The meridian starts at the first point, or near it, and ends at the last one's place.
    ring : float, optional
        As in `meridian`: where a surface that closes at the pole is to end.

    Raises
    ------
    InputError
        Fewer than three points, some on or beyond the axis, two alike.
    NotConvergedError
        No meridian near the points.

    Examples
    --------
    >>> vase = meridian_through([(60, 0), (80, 50), (70, 80), (55, 110), (50, 150)])
    >>> vase.deviation < 1e-6
    True
    """
    if isinstance(points, PlaneCurve):
        points = points.sample(SOUGHT).position
    data = _profile(points)
    size = float(np.linalg.norm(np.ptp(data, axis=0)))
    chosen = np.unique(np.linspace(0, len(data) - 1, min(len(data), SOUGHT)).round().astype(int))
    try:
        found = search_meridian(data[chosen] / size)
        if not found.points[0, 0] > 0:
            raise NotConvergedError("the nearest meridian begins beyond the axis")
        length, start = found.length * size, float(found.points[0, 0]) * size
        end = _end(lambda s: size * found.position(s / size)[:, 0], length, _floor(start, length, ring))
        curve = _curve(found, size, end)
    except NotConvergedError as problem:
        way_out = TO_THE_POLE if data[-1, 0] < NEAR_AXIS_SHARE * data[:, 0].max() else ""
        raise NotConvergedError(f"{problem}: {HOPELESS}{way_out}") from problem
    closes = end < length
    if len(chosen) == len(data):
        gaps = np.hypot(*(size * found.points - data).T)
    else:
        gaps = distances(Spline(_curve(found, size, length)), data)
    if not gaps.max() <= 0.25 * size:
        raise NotConvergedError(
            f"no meridian comes nearer than {gaps.max():.3g} mm to point {int(gaps.argmax()) + 1}: {HOPELESS}"
        )
    return Meridian(found.a, found.b / size, curve, closes, float(gaps.max()))


def _curve(found: FoundMeridian, size: float, end: float) -> PlaneCurve:
    """The meridian in mm up to an arc length."""
    tolerance = CURVE_TOLERANCE * found.length * size
    return PlaneCurve.fit_function(
        lambda s: size * found.position(s / size), 0.0, end, tolerance=tolerance, degree=5
    )


def _floor(start: float, length: float, ring: float | None) -> float:
    """The distance from the axis at which a meridian ends, mm."""
    if ring is None:
        return min(NARROW_SHARE * (start + length), start / 2)
    if not (is_number(ring) and 0 < ring < start):
        raise InputError(f"ring={ring}: it must be positive and smaller than the start's {start:g} mm")
    return float(ring)


def _end(distance: Callable[[FloatArray], FloatArray], length: float, floor: float) -> float:
    """Arc length at which the distance from the axis comes down to `floor`, or the whole length, mm."""
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


def _profile(points: ArrayLike) -> FloatArray:
    """Points (n, 2) that a meridian can be sought through."""
    data = finite("the points of a meridian", points)
    if data.ndim != 2 or data.shape[1] != 2 or len(data) < 3:
        raise InputError("a meridian is sought through three points (x, y) or more, mm")
    if abs(data[-1, 0]) < ON_AXIS_SHARE * np.ptp(data):
        data = np.append(data[:-1], [[0.0, data[-1, 1]]], axis=0)
    beyond = np.append(data[:-1, 0] <= 0, data[-1, 0] < 0)
    if beyond.any():
        i = int(np.argmax(beyond))
        raise InputError(
            f"point {i + 1} at {data[i].tolist()} lies on or beyond the axis x = 0: keep x positive (the last may "
            "lie on it)"
        )
    return data


def _integrated(
    p: FloatArray, length: float, floor: float
) -> tuple[float, Callable[[FloatArray], FloatArray]]:
    """Arc length of the end, and (x, y, angle) (3, n) as a function of arc length."""
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
    found = solve_ivp(
        slope, (0.0, length), p[3:6], method="DOP853", rtol=ACCURACY, atol=ACCURACY * scale, dense_output=True,
        events=(at_axis, winding), max_step=length / 40,
    )  # fmt: skip
    if not found.success:
        raise NotConvergedError(
            f"the meridian bends without bounds after {found.t[-1]:.4g} mm, beside the axis: end it there"
        )
    if found.t_events[1].size:
        raise InputError(
            f"the meridian turns {MOST_TURNS} times about within {found.t[-1]:.4g} mm of its {length:g} mm: make "
            "a and b smaller, or end it before"
        )
    return float(found.t[-1]), found.sol


def _refuse_winding(p: FloatArray) -> None:
    """Constants with which a meridian bends, or waves, far within its length."""
    a, b, start, length = p[0], p[1:3], p[3:5], p[6]
    with np.errstate(over="ignore"):
        bending = abs(a + b @ start) / start[0]
        waving = np.sqrt(np.hypot(*b) / (start[0] + length))
        most = max(bending, waving)
        too_much = most * length > 2 * np.pi * MOST_TURNS
    if too_much:
        raise InputError(
            f"a={a:g}, b=({b[0]:g}, {b[1]:g}) bend the meridian from its start to a radius of about {1 / most:.2g} "
            f"mm, against its length of {length:g} mm: make a and b smaller (a has no unit, b is in 1/mm)"
        )


def _numbers(a: float, b: ArrayLike, start: ArrayLike, angle: float, length: float) -> FloatArray:
    try:
        b, start = np.asarray(b, dtype=float), np.asarray(start, dtype=float)
        a, angle, length = float(a), float(angle), float(length)
    except (TypeError, ValueError, OverflowError):
        raise InputError("a meridian is made of numbers: a, angle and length, b and start") from None
    if b.shape != (2,) or start.shape != (2,):
        raise InputError("a meridian needs b and start as two numbers each")
    numbers = np.array([a, *b, *start, angle, length])
    if not np.all(np.isfinite(numbers)):
        raise InputError(f"the numbers of a meridian must be finite: {numbers.tolist()}")
    return numbers
