"""The line of Theorem 1: which lines meet a curve in its inflections and nowhere else."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.geometry.curves.curve_records import CurvatureZero
from elastica_cad.geometry.curves.line_intersections import line_crossings
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.curves.view_angles import find_view_angles
from elastica_cad.mechanics.loads.rest_curvature import ExcessCurvature

SAME_PLACE_SHARE = 1e-6
"""Places along the curve nearer than this, in lengths of the curve, are the same inflection."""

WIDEST_RATIO = 1e4
"""Ratio of stiffness from which on no strip can be made, by far: such a curve lies on the border of what is
realizable, and whether it is inside is then a question of rounding."""

TANGENT_RAD = 1e-6
"""Sine of the angle between line and curve below which they count as tangent."""

_AT_ZERO_SHARE = 1e-4  # nearer to a zero of the curvature, in lengths, K is a quotient of two small numbers
_TURNS = 67  # of a line about the only inflection, tried


@dataclass(frozen=True)
class InflectionLine:
    """A line, zero of a + <b, x>, with |b| = 1.

    Attributes
    ----------
    point : (2,) tuple
        A point of it, mm.
    direction : (2,) tuple
        Unit vector along it.
    """

    point: tuple[float, float]
    direction: tuple[float, float]

    @property
    def b(self) -> FloatArray:
        """Unit normal (2,): the direction turned left."""
        return np.array([-self.direction[1], self.direction[0]])

    @property
    def a(self) -> float:
        """Constant of a + <b, x>, mm."""
        return -float(self.b @ np.asarray(self.point))

    def distance(self, position: FloatArray) -> FloatArray:
        """Signed distances (n,) of points (n, 2), mm."""
        return np.asarray((np.asarray(position) - np.asarray(self.point)) @ self.b)

    def as_dict(self) -> dict[str, Any]:
        """For reports."""
        return {
            "point": list(self.point),
            "direction": list(self.direction),
            "a": self.a,
            "b": self.b.tolist(),
        }


@dataclass(frozen=True)
class LineMeeting:
    """A place (mm) where a line meets the curve and must not; kind "crossing", "touch" or "tangent"."""

    s: float
    kind: str


@dataclass(frozen=True)
class SeparatingLine:
    """The lines through one inflection that meet the curve nowhere else.

    Attributes
    ----------
    line : InflectionLine or None
        The middle one; None when there is none.
    spread : float
        Angle, rad, under which the curve is seen from its inflection once the part that bends the other way
        is mirrored there; below pi there are such lines.
    places : (float, float)
        Arc lengths of the two places that bound the lines, mm.
    """

    line: InflectionLine | None
    spread: float
    places: tuple[float, float]


def fit_inflection_line(points: FloatArray, normal: FloatArray | None = None) -> InflectionLine:
    """The line nearest to points (k, 2) in least squares; with a given normal only its place is free."""
    centre = points.mean(axis=0)
    if normal is None:
        _, _, vt = np.linalg.svd(points - centre)
        normal = vt[1]
    normal = normal / np.hypot(*normal)
    if normal[1] < 0 or (normal[1] == 0 and normal[0] > 0):
        normal = -normal
    return InflectionLine((float(centre[0]), float(centre[1])), (float(normal[1]), -float(normal[0])))


def line_meetings(
    curve: PlaneCurve, line: InflectionLine, zeros: Sequence[CurvatureZero]
) -> tuple[LineMeeting, ...]:
    """Places where the line violates condition (1) of Theorem 1.

    These are meetings elsewhere than in a zero of the curvature, tangency in a zero, and zeros in which the
    curve goes to the wrong side: the moment a + <b, gamma> must have one and the same sign relation to the
    curvature everywhere.
    """
    near = SAME_PLACE_SHARE * curve.length
    bad: list[LineMeeting] = []
    t = np.array([z.t for z in zeros])
    tangent = np.asarray(curve.evaluate(t, 1)).reshape(-1, 2)
    sine = tangent @ line.b / np.hypot(tangent[:, 0], tangent[:, 1])
    turned = np.array([(z.after or -z.before) for z in zeros]) * sine
    majority = 1.0 if (turned > 0).sum() * 2 >= turned.size else -1.0
    for zero, rate, turn in zip(zeros, sine, turned, strict=True):
        if abs(rate) < TANGENT_RAD:
            bad.append(LineMeeting(zero.s, "tangent"))
        elif turn * majority < 0:
            bad.append(LineMeeting(zero.s, "crossing"))
    places = np.array([z.s for z in zeros])
    for meeting in line_crossings(curve, line.a, line.b):
        if meeting.kind == "flat":
            bad.append(LineMeeting(meeting.s, "touch"))
        elif not places.size or np.abs(places - meeting.s).min() > near:
            bad.append(LineMeeting(meeting.s, "touch" if meeting.kind == "touch" else "crossing"))
    return tuple(sorted(set(bad), key=lambda m: m.s))


def widest_place(
    excess: ExcessCurvature,
    line: InflectionLine,
    zeros: Sequence[CurvatureZero],
    spare: float,
) -> float | None:
    """Where (mm) the stiffness would exceed the least by `WIDEST_RATIO`; None where it need not.

    K = distance from the line / (kappa - kappa_0); in a zero its limit, the sine of the angle between curve and
    line over the slope of the curvature. With one zero the line may turn by `spare` rad either way about it.
    """
    curve, kappa = excess.curve, excess.survey
    nodes = curve.survey
    s_zero, t_zero = np.array([z.s for z in zeros]), np.array([z.t for z in zeros])
    clear = np.abs(nodes.s[:, None] - s_zero).min(axis=1) > _AT_ZERO_SHARE * curve.length
    clear &= kappa != 0
    tangent = np.asarray(curve.evaluate(t_zero, 1)).reshape(-1, 2)
    tangent /= np.hypot(tangent[:, 0], tangent[:, 1])[:, None]
    slope = excess.slope_at(t_zero, left=bool(t_zero[-1] >= curve.domain[1]))
    s = np.concatenate([nodes.s[clear], s_zero])
    arm = np.concatenate(
        [(nodes.position[clear] - np.asarray(line.point)) / kappa[clear, None], tangent / slope[:, None]]
    )
    turns = np.linspace(-spare, spare, _TURNS)[1:-1] if spare > 0 else np.zeros(1)
    along, across = np.asarray(line.direction), line.b
    normals = np.cos(turns)[:, None] * across + np.sin(turns)[:, None] * along
    K = np.abs(arm @ normals.T)
    ratios = K.max(axis=0) / np.maximum(K.min(axis=0), 1e-300)
    best = int(np.argmin(ratios))
    return float(s[int(np.argmax(K[:, best]))]) if ratios[best] > WIDEST_RATIO else None


def find_separating_line(curve: PlaneCurve, zero: CurvatureZero, curvature_sign: int) -> SeparatingLine:
    """Lines through the only zero of kappa - kappa_0 that have each side of the curve where its bending asks.

    With p the inflection, M = <b, gamma - p> must have the sign of kappa - kappa_0, so all directions
    sign(kappa - kappa_0) (gamma - p) must lie in the open half plane <b, .> > 0. They form one continuous
    angle along the curve (its limit at p is the tangent), and there is such a b if and only if it spreads
    less than pi.

    Parameters
    ----------
    curvature_sign : int
        Sign of kappa - kappa_0 after the zero; at the end of the curve minus the sign before it.
    """
    views = find_view_angles(curve, zero.t)
    if views is None:
        return SeparatingLine(None, np.pi, (zero.s, zero.s))
    low, high = (float(s) for s in np.sort(curve.arc_length(np.array([views.low_t, views.high_t]))))
    spread = views.high - views.low
    if spread >= np.pi - TANGENT_RAD:
        return SeparatingLine(None, spread, (low, high))
    middle = (views.low + views.high) / 2
    x, y = curve.evaluate(zero.t)
    # along the middle direction turned right by a quarter, so that its normal b is that direction
    direction = curvature_sign * np.array([np.sin(middle), -np.cos(middle)])
    line = InflectionLine((float(x), float(y)), (float(direction[0]), float(direction[1])))
    return SeparatingLine(line, spread, (low, high))
