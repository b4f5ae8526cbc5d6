"""The line of Theorem 1: which lines meet a curve in its inflections and nowhere else."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.geometry import CurvatureZero, PlaneCurve, line_crossings

__all__ = ["InflectionLine", "LineMeeting", "Pencil", "fitted_line", "line_meetings", "pencil_of_lines"]

SAME_PLACE = 1e-6
"""Places along the curve nearer than this, in lengths of the curve, are the same inflection."""

TANGENT = 1e-6
"""Sine of the angle between line and curve below which they count as tangent."""


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
class Pencil:
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


def fitted_line(points: FloatArray, normal: FloatArray | None = None) -> InflectionLine:
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
    near = SAME_PLACE * curve.length
    bad: list[LineMeeting] = []
    t = np.array([z.t for z in zeros])
    tangent = np.asarray(curve.evaluate(t, 1)).reshape(-1, 2)
    sine = tangent @ line.b / np.hypot(tangent[:, 0], tangent[:, 1])
    turned = np.array([(z.after or -z.before) for z in zeros]) * sine
    majority = 1.0 if (turned > 0).sum() * 2 >= turned.size else -1.0
    for zero, rate, turn in zip(zeros, sine, turned, strict=True):
        if abs(rate) < TANGENT:
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


def pencil_of_lines(curve: PlaneCurve, zero: CurvatureZero, curvature_sign: int) -> Pencil:
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
    view = _View(curve, zero, curvature_sign)
    (s_low, low), (s_high, high) = view.extreme(-1.0), view.extreme(1.0)
    places = (min(s_low, s_high), max(s_low, s_high))
    if high - low >= np.pi - TANGENT:
        return Pencil(None, high - low, places)
    middle = (low + high) / 2
    x, y = view.point
    line = InflectionLine((float(x), float(y)), (float(np.sin(middle)), -float(np.cos(middle))))
    return Pencil(line, high - low, places)


@dataclass(frozen=True, eq=False)
class _View:
    """The curve as seen from one of its inflections."""

    curve: PlaneCurve
    zero: CurvatureZero
    sign: int

    @property
    def point(self) -> FloatArray:
        return np.asarray(self.curve.evaluate(np.array(self.zero.t)))

    def angle(self, s: FloatArray) -> FloatArray:
        """Continuous angle (n,) of sign(kappa - kappa_0)(gamma - p), near the tangent's at the inflection."""
        away = np.sign(s - self.zero.s) * self.sign
        tangent = np.asarray(self.curve.evaluate(np.array(self.zero.t), 1)) * self.sign
        v = (np.asarray(self.curve.evaluate(self.curve.parameter(s))) - self.point) * away[:, None]
        v[np.abs(s - self.zero.s) < 1e-7 * self.curve.length] = tangent
        angle = np.arctan2(tangent[0] * v[:, 1] - tangent[1] * v[:, 0], v @ tangent)
        # unwrapped both ways from the inflection, where the angle is small
        first = int(np.searchsorted(s, self.zero.s))
        before, after = np.unwrap(angle[:first][::-1])[::-1], np.unwrap(angle[first:])
        return np.asarray(np.concatenate([before, after]) + np.arctan2(tangent[1], tangent[0]))

    def extreme(self, side: float) -> tuple[float, float]:
        """Place and value of the largest side * angle, closed in on from samples."""
        s = np.linspace(0.0, self.curve.length, 2001)
        theta = self.angle(s)
        for _ in range(4):
            at = int(np.argmax(side * theta))
            best = float(theta[at])
            s = np.linspace(s[max(at - 1, 0)], s[min(at + 1, s.size - 1)], 65)
            theta = self.angle(s)
            turns = (best - theta[int(np.argmax(side * theta))]) / (2 * np.pi)
            theta += 2 * np.pi * np.round(turns)
        at = int(np.argmax(side * theta))
        return float(s[at]), float(theta[at])
