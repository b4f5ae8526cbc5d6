"""The turning angle as one continuous function, and the places where a curve has no direction."""

from dataclasses import dataclass

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.geometry.polynomials.bernstein import product, subdivide

_STANDSTILL_SHARE = 1e-9  # of the largest speed on the span; a curve slower than that stands still
_STILL_SPAN = 1e-14  # of the largest speed of all; a span that is nowhere faster is a point
_ALONG_SHARE = 1e-9  # of a velocity, that it has along the axis of its cone
_MOST_HALVINGS = 27  # halvings of a knot span; a direction that still is undecided there is a cusp


@dataclass(frozen=True, eq=False)
class TangentAngle:
    """Angle of the tangent over the cones of the curve, continued from one to the next.

    Attributes
    ----------
    edges : (k + 1,) array
        Parameters t at which the cones meet.
    axis : (k, 2) array
        Unit middle direction of each cone.
    angle : (k,) array
        Angle of that direction, continued from cone to cone.
    spread : float
        Between the least and the largest angle of the curve, rad, or a little more.
    """

    edges: FloatArray
    axis: FloatArray
    angle: FloatArray
    spread: float

    def at(self, t: FloatArray, velocity: FloatArray, *, left: bool = False) -> FloatArray:
        """Angle (n,) of velocities (n, 2) at parameters (n,), without jumps of 2 pi."""
        cone = np.searchsorted(self.edges[1:-1], t, side="left" if left else "right")
        return np.asarray(self.angle[cone] + turn_between(self.axis[cone], velocity), dtype=float)


def hodograph(bezier: FloatArray) -> FloatArray:
    """Bernstein coefficients (p, n, 2) along the velocity of homogeneous Bezier pieces (p, degree + 1, 3).

    The derivative by u times the squared weight: w P' - P w' (degree times left out).
    """
    a, b = bezier[:, :-1], bezier[:, 1:]
    if np.ptp(bezier[..., 2]) == 0:
        return np.asarray((b - a)[..., :2])
    aw, bw = a[..., 2], b[..., 2]
    return np.stack([product(aw, b[..., k]) - product(a[..., k], bw) for k in (0, 1)], axis=-1)


@dataclass(frozen=True, eq=False)
class TangentCones:
    """Parts of a curve within which the velocity stays in an open half plane.

    Attributes
    ----------
    edges : (k + 1,) array
        Parameters at which they meet.
    hodographs : (k, n, 2) array
        Bernstein coefficients along the velocity.
    standstill : float or None
        Parameter of the first place where the velocity vanishes (cusp, coincident control points); the other
        fields are of no use then.
    """

    edges: FloatArray
    hodographs: FloatArray
    standstill: float | None = None


def tabulate_tangent_angle(cones: TangentCones) -> TangentAngle:
    """The turning angle of a curve without cusp; at a tangent break it jumps by the exterior angle."""
    first, last = _unit(cones.hodographs[:, [0, -1]].swapaxes(0, 1))
    axis = _unit(first + last)
    # the velocity runs between its coefficients
    off_axis = turn_between(axis[:, None], cones.hodographs)
    to_start, to_end = off_axis[:, 0], off_axis[:, -1]
    across = turn_between(last[:-1], first[1:])
    angle = np.empty(len(axis))
    angle[0] = np.arctan2(first[0, 1], first[0, 0]) - to_start[0]
    angle[1:] = to_end[:-1] + across - to_start[1:]
    angle = angle.cumsum()
    reached = angle[:, None] + off_axis
    return TangentAngle(cones.edges, axis, angle, float(reached.max() - reached.min()))


def cut_into_tangent_cones(hodographs: FloatArray, edges: FloatArray) -> TangentCones:
    """The tangent cones of pieces whose velocities have Bernstein coefficients (p, n, 2)."""
    part, low, width = hodographs, edges[:-1], edges[1:] - edges[:-1]
    size = np.hypot(part[..., 0], part[..., 1])
    largest = size.max(axis=1)
    still = largest <= _STILL_SPAN * largest.max()
    stopped = np.concatenate(
        [low[(size[:, 0] <= 1e-12 * largest) | still], (low + width)[size[:, -1] <= 1e-12 * largest]]
    )
    if stopped.size:
        return TangentCones(edges, part, float(stopped.min()))
    starts: list[FloatArray] = []
    found: list[FloatArray] = []
    slowest = _STANDSTILL_SHARE * largest
    for _ in range(_MOST_HALVINGS):
        if not low.size:
            break
        axis = _unit(part[:, [0, -1]]).sum(axis=1)
        along = (part @ axis[:, :, None])[:, :, 0]
        decided = (along > _ALONG_SHARE * size).all(axis=1) & (size[:, [0, -1]].min(axis=1) > slowest)
        if not starts and decided.all():
            return TangentCones(edges, part)
        starts.append(low[decided])
        found.append(part[decided])
        rest = ~decided
        left, right = subdivide(np.swapaxes(part[rest], 1, 2))
        part = np.swapaxes(np.concatenate([left, right]), 1, 2)
        width, slowest = np.tile(width[rest] / 2, 2), np.tile(slowest[rest], 2)
        low = np.concatenate([low[rest], low[rest] + width[: rest.sum()]])
        size = np.hypot(part[..., 0], part[..., 1])
    if low.size:
        return TangentCones(edges, part, float((low + width / 2).min()))
    begin, coefficients = np.concatenate(starts), np.concatenate(found)
    order = np.argsort(begin, kind="stable")
    return TangentCones(np.append(begin[order], edges[-1]), coefficients[order])


def _unit(v: FloatArray) -> FloatArray:
    length = np.hypot(v[..., :1], v[..., 1:])
    return np.asarray(v / np.where(length > 0, length, 1.0))


def turn_between(u: FloatArray, v: FloatArray) -> FloatArray:
    """Angles (...,) from directions u to directions v (..., 2), rad in (-pi, pi], positive to the left."""
    cross = u[..., 0] * v[..., 1] - u[..., 1] * v[..., 0]
    return np.asarray(np.arctan2(cross, u[..., 0] * v[..., 0] + u[..., 1] * v[..., 1]))
