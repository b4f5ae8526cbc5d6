"""The elastica between two clamps: a strip of given length whose ends are held at two places."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from math import radians

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad.errors import InputError
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.paths.profile import Profile
from elastica_cad.mechanics.bending.bend_forward import bend
from elastica_cad.mechanics.loads.gravity import Gravity
from elastica_cad.mechanics.loads.supports import Supports
from elastica_cad.mechanics.rod.rod_record import Rod

SPANS = 90  # of the drawn spline: a strip of even width then comes out even to 5e-4, its length to 1e-9
DEGREE = 5  # of the drawn spline
OFF_PLANE = 1e-6  # mm: how far points may lie off the plane of the curve
SAMPLES = 10 * SPANS + 1  # nodes: their places are wrong by the square of their distance, 1e-6 of the length


@dataclass(frozen=True, eq=False)
class ElasticaBetween:
    """A bent strip between two clamps, and which of the many it is.

    Attributes
    ----------
    rod : Rod
        In balance; `force` and `moment` at its ends are what the clamps bear.
    side : int
        +1 where its first bulge lies left of the way from start to end, -1 where right, 0 where it is straight.
    mode : int
        The buckling mode in which a straight strip was left; 1 is the stable one.
    """

    rod: Rod
    side: int
    mode: int

    @property
    def curve(self) -> PlaneCurve:
        """The shape as a smooth spline of degree 5, with as much curvature as the rod has moment."""
        return _smooth_curve(self.rod)

    @property
    def inflections(self) -> int:
        """How often the bend changes its side."""
        kappa = self.rod.curvature
        signs = np.sign(kappa[np.abs(kappa) > 1e-6 * np.abs(kappa).max(initial=0.0)])
        return int(np.count_nonzero(np.diff(signs)))

    def __str__(self) -> str:
        way = {1: "bulges to the left", -1: "bulges to the right", 0: "is straight"}[self.side]
        return f"the strip {way} of its chord, with {self.inflections} inflections (mode {self.mode})"


def elastica_between(
    start: ArrayLike,
    end: ArrayLike,
    length: float,
    *,
    angles: tuple[float | None, float | None] = (None, None),
    stiffness: "ArrayLike | Profile" = 1.0,
    gravity: Gravity | None = None,
    side: int = 1,
    mode: int = 1,
    samples: int = SAMPLES,
) -> ElasticaBetween:
    """The shape of a strip of given length between two points.

    The strip is laid straight from the start towards the end, pushed to its end and then turned to the angles, so
    that the branch of equilibria is the one by which hands would get there.

    Parameters
    ----------
    start, end : (2,) array_like
        mm.
    length : float
        Of the strip, mm: more than the distance of its ends.
    angles : pair of float or None
        Of the tangent at both ends, rad, whole turns not counted; None leaves the strip free to turn there.
    stiffness : float, (n,) array_like or Profile
        Of a tapered strip: stiffness at even stations, or over [0, length].
    gravity : Gravity, optional
        The strip's own weight.
    side : {+1, -1}
        To which side of the way from start to end the strip bulges first, left or right.
    mode : int
        Buckling mode; above 1 the shape is unstable as a rule.
    samples : int
        Nodes.

    Raises
    ------
    InputError
        A length that does not reach, ends at one place without angles.
    NotConvergedError
        As `bend`.

    Examples
    --------
    >>> found = elastica_between((0, 0), (70, 0), 100.0, angles=(0.0, 0.0))
    >>> round(float(found.rod.position[:, 1].max()), 1), found.side, found.inflections
    (31.4, 1, 2)
    """
    first, last = _point(start, "start"), _point(end, "end")
    near, far = _pair_of_angles(angles)
    if isinstance(length, bool) or not isinstance(length, float | int | np.number):
        raise InputError(f"length must be a number, mm, more than the distance of the ends, got {length!r}")
    chord = last - first
    distance = float(np.hypot(*chord))
    if not (np.isfinite(length) and length > distance > 0):
        raise InputError(
            f"a strip of {length:.6g} mm does not bend between ends {distance:.6g} mm apart: make it longer, and "
            "the ends two places"
        )
    if side not in (1, -1):
        raise InputError(f"side is {side!r}: give 1 for left of the way from start to end, -1 for right")
    along = float(np.arctan2(chord[1], chord[0]))
    supports = Supports(*("pinned" if angle is None else "clamped" for angle in (near, far)))
    rod = Rod.straight(
        length, stiffness, samples=samples, start=first, angle=along, gravity=None, supports=supports
    )
    bent = bend(rod, end=last, side=side, mode=mode)
    near, far = (None if angle is None else _nearest_turn(angle, along) for angle in (near, far))
    if near is not None or far is not None or gravity is not None:
        bent = bend(bent, end=last, angles=(near, far), gravity=gravity, settle=mode == 1)
    return ElasticaBetween(bent, _side(bent), mode)


def _smooth_curve(rod: Rod) -> PlaneCurve:
    """The spline through places to which a fine and a coarse rod lead, whose errors are as four to one.

    Where an end is free to turn its curvature is zero: the first three control points lie on a line.
    """
    from scipy.interpolate import make_interp_spline

    fine, coarse = (bend(rod, samples=10 * SPANS // every + 1).position for every in (1, 2))
    places = (4 * fine[::10] - coarse[::5]) / 3
    spline = make_interp_spline(np.linspace(0.0, rod.length, SPANS + 1), places, k=DEGREE)
    knots, points = np.array(spline.t), np.array(spline.c)
    for end, way, at in zip(rod.supports.ends, (1, -1), (0, -1), strict=True):
        if not end.angle:
            low, mid, high = (abs(knots[at + way * (DEGREE + k)] - knots[at]) for k in range(3))
            step = (points[at + way] - points[at]) / (mid - low)
            points[at + 2 * way] = points[at + way] + (high - low) * step
    return PlaneCurve(knots, points, DEGREE)


def _point(point: object, name: str) -> FloatArray:
    """Two numbers, or a point of a CAD library that has no z."""
    given = point.toTuple() if hasattr(point, "toTuple") else point
    try:
        place = np.array(list(given) if isinstance(given, Iterable) else (), dtype=float)
    except (TypeError, ValueError):
        place = np.array([])
    if place.shape == (3,) and abs(place[2]) <= OFF_PLANE:
        place = place[:2]
    if place.shape != (2,) or not np.all(np.isfinite(place)):
        raise InputError(f"{name} must be a point of the plane without z, two numbers, mm, got {given!r}")
    return place


def angles_in_rad(angles: object) -> tuple[float | None, float | None]:
    """Angles in degrees at start and end, None where the strip turns freely, as `elastica_between` takes them."""
    near, far = _pair_of_angles(angles)
    return None if near is None else radians(near), None if far is None else radians(far)


def _pair_of_angles(angles: object) -> tuple[float | None, float | None]:
    pair = angles if isinstance(angles, Sequence | np.ndarray) else ()
    if len(pair) != 2 or not all(
        angle is None or (isinstance(angle, float | int | np.number) and np.isfinite(angle)) for angle in pair
    ):
        raise InputError(
            f"angles must be two, at start and end, None where the strip turns freely, got {angles!r}"
        )
    near, far = pair
    return near, far


def _nearest_turn(angle: float, near: float) -> float:
    """The angle, or one that differs by whole turns, within half a turn of another."""
    return near + float(np.remainder(angle - near + np.pi, 2 * np.pi) - np.pi)


def _side(rod: Rod) -> int:
    """Which side of its chord the rod leaves first."""
    off = rod.position - rod.position[0]
    chord = off[-1] / np.hypot(*off[-1])
    heights = off @ np.array([-chord[1], chord[0]])
    far = np.flatnonzero(np.abs(heights) > 1e-6 * rod.length)
    return int(np.sign(heights[far[0]])) if far.size else 0
