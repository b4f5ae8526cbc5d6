"""Meridians of surfaces of revolution that equal strips tile without gaps (paper, section 9.4).

A strip closes the gap to its neighbours where its width is proportional to the distance from the axis; as the
width is the stiffness, Eq. 3 becomes <e1, gamma> kappa = a + <b, gamma>, which is integrated here.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad.errors import InputError, NotConvergedError
from elastica_cad.geometry import PlaneCurve, Profile
from elastica_cad.mechanics import Rod

__all__ = ["Meridian", "meridian", "meridian_through"]

ACCURACY = 1e-12
"""Relative tolerance of the integrator, of order 8."""

CURVE_TOLERANCE = 1e-10
"""Of the spline, in lengths of the meridian."""

NODES = 601
NARROW = 1e-3
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
        Numbers that are not finite, a start on the axis, a length that is not positive.
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
    floor = NARROW * (p[3] + p[6]) if ring is None else float(ring)
    if not (np.isfinite(floor) and 0 < floor < p[3]) and ring is not None:
        raise InputError(f"ring={ring}: it must be positive and smaller than the start's {p[3]:g} mm")
    floor = min(floor, p[3] / 2) if ring is None else floor
    end, shape = _integrated(p[:6], p[6], floor)
    curve = PlaneCurve.fit_function(
        lambda s: shape(s)[:2].T, 0.0, end, tolerance=CURVE_TOLERANCE * float(p[6]), degree=5
    )
    return Meridian(float(p[0]), p[1:3], curve, at_pole=end < p[6])


def meridian_through(points: ArrayLike) -> Meridian:
    """The meridian through three or four points as a rule, or as near to more (a profile) as there is one.

    a, b, the first direction and the places along the meridian are sought together, by least squares.

    Parameters
    ----------
    points : (n, 2) array_like
        In order, mm, at x > 0; the meridian starts at the first and ends at the last one's place.

    Raises
    ------
    InputError
        Fewer than three points, or some on the axis.
    NotConvergedError
        No meridian near the points.

    Examples
    --------
    >>> vase = meridian_through([(60, 0), (80, 50), (55, 110), (50, 150)])
    >>> vase.deviation < 1e-6
    True
    """
    from scipy.optimize import least_squares

    data = np.asarray(points, dtype=float)
    if data.ndim != 2 or data.shape[1] != 2 or len(data) < 3 or not np.all(np.isfinite(data)):
        raise InputError("a meridian is sought through three points (x, y) or more, mm")
    if data[:, 0].min() <= 0:
        i = int(np.argmin(data[:, 0]))
        raise InputError(
            f"point {i + 1} at {data[i].tolist()} lies on or beyond the axis x = 0: keep x positive"
        )
    size = float(np.linalg.norm(np.ptp(data, axis=0)))
    given = data / size
    guess = _first_guess(given)

    def off(unknown: FloatArray) -> FloatArray:
        places = np.cumsum(np.exp(unknown[4:]))
        try:
            _, shape = _integrated(np.array([*unknown[:3], *given[0], unknown[3]]), float(places[-1]), 1e-3)
        except NotConvergedError:
            return np.full(2 * len(given) - 2, 10.0)
        return np.asarray((shape(places)[:2].T - given[1:]).ravel())

    found = least_squares(off, guess, xtol=1e-14, ftol=1e-14, gtol=1e-14, x_scale="jac", max_nfev=400)
    gaps = np.hypot(*off(found.x).reshape(-1, 2).T) * size
    if gaps.max() > 0.25 * size:
        raise NotConvergedError(
            f"no meridian comes nearer than {gaps.max():.3g} mm to point {int(gaps.argmax()) + 2}: strips that "
            "tile a surface of revolution cannot follow these points"
        )
    a, b1, b2, angle = found.x[:4]
    length = float(np.exp(found.x[4:]).sum()) * size
    made = meridian(a, np.array([b1, b2]) / size, data[0], angle, length)
    return Meridian(made.a, made.b, made.curve, made.at_pole, float(gaps.max()))


def _first_guess(points: FloatArray) -> FloatArray:
    """a, b, angle and logarithms of the steps from a smooth curve through the points."""
    curve = PlaneCurve.fit(points, degree=4, tolerance=1e-3)
    at = curve.sample(200)
    rows = np.column_stack([np.ones(200), at.position])
    line = np.linalg.lstsq(rows, at.position[:, 0] * at.curvature, rcond=None)[0]
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    if steps.min() == 0:
        raise InputError("two neighbouring points of the meridian are the same: leave one out")
    return np.concatenate([line, [at.angle[0]], np.log(steps * curve.length / steps.sum())])


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

    at_axis.__dict__.update(terminal=True, direction=-1.0)
    scale = max(length, 1e-300)
    found = solve_ivp(
        slope, (0.0, length), p[3:6], method="DOP853", rtol=ACCURACY, atol=ACCURACY * scale, dense_output=True,
        events=at_axis, max_step=length / 40,
    )  # fmt: skip
    if not found.success:
        raise NotConvergedError(
            f"the meridian bends without bounds after {found.t[-1]:.4g} mm, beside the axis: end it there"
        )
    return float(found.t[-1]), found.sol


def _numbers(a: float, b: ArrayLike, start: ArrayLike, angle: float, length: float) -> FloatArray:
    b, start = np.asarray(b, dtype=float), np.asarray(start, dtype=float)
    if b.shape != (2,) or start.shape != (2,):
        raise InputError("a meridian needs b and start as two numbers each")
    numbers = np.array([float(a), *b, *start, float(angle), float(length)])
    if not np.all(np.isfinite(numbers)):
        raise InputError(f"the numbers of a meridian must be finite: {numbers.tolist()}")
    return numbers
