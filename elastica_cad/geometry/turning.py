"""The turning angle as one continuous function, and the places where a curve has no direction."""

from dataclasses import dataclass

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.geometry.bernstein import product, split

__all__ = ["Sectors", "Turning", "hodograph", "sectors", "turning_table"]

_SLOWEST = 1e-9  # of the largest speed on the span; a curve slower than that stands still
_DEEPEST = 27  # halvings of a knot span; a direction that still is undecided there is a cusp


@dataclass(frozen=True, eq=False)
class Turning:
    """Sectors of the curve within which the tangent stays in an open half plane.

    Attributes
    ----------
    edges : (k + 1,) array
        Parameters t at which the sectors meet.
    axis : (k, 2) array
        Unit middle direction of each sector.
    angle : (k,) array
        Angle of that direction, continued from sector to sector.
    """

    edges: FloatArray
    axis: FloatArray
    angle: FloatArray

    def at(self, t: FloatArray, velocity: FloatArray, *, left: bool = False) -> FloatArray:
        """Angle (n,) of velocities (n, 2) at parameters (n,), without jumps of 2 pi."""
        sector = np.searchsorted(self.edges[1:-1], t, side="left" if left else "right")
        return np.asarray(self.angle[sector] + _signed_angle(self.axis[sector], velocity), dtype=float)


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
class Sectors:
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


def turning_table(sector: Sectors) -> Turning:
    """The turning angle of a curve without cusp; at a tangent break it jumps by the exterior angle."""
    first, last = _unit(sector.hodographs[:, 0]), _unit(sector.hodographs[:, -1])
    axis = _unit(first + last)
    to_end = _signed_angle(axis, last)
    to_start = _signed_angle(axis, first)
    across = _signed_angle(last[:-1], first[1:])
    steps = to_end[:-1] + across - to_start[1:]
    start = np.arctan2(first[0, 1], first[0, 0]) - to_start[0]
    angle = start + np.concatenate([[0.0], np.cumsum(steps)])
    return Turning(sector.edges, axis, angle)


def sectors(hodographs: FloatArray, edges: FloatArray) -> Sectors:
    """The sectors of pieces whose velocities have Bernstein coefficients (p, n, 2)."""
    part, low, width = hodographs, edges[:-1], np.diff(edges)
    size = np.linalg.norm(part, axis=-1)
    largest = size.max(axis=1)
    still = largest <= 1e-14 * largest.max()
    stopped = np.concatenate(
        [low[(size[:, 0] <= 1e-12 * largest) | still], (low + width)[size[:, -1] <= 1e-12 * largest]]
    )
    if stopped.size:
        return Sectors(edges, part, float(stopped.min()))
    starts, found = [], []
    slowest = _SLOWEST * largest
    for _ in range(_DEEPEST):
        if not low.size:
            break
        axis = _unit(part[:, 0]) + _unit(part[:, -1])
        along = np.einsum("pnk,pk->pn", part, axis)
        length = np.linalg.norm(part, axis=-1)
        decided = (along > 1e-9 * length).all(axis=1) & (length[:, [0, -1]].min(axis=1) > slowest)
        starts.append(low[decided])
        found.append(part[decided])
        rest = ~decided
        left, right = split(np.swapaxes(part[rest], 1, 2))
        part = np.swapaxes(np.concatenate([left, right]), 1, 2)
        width, slowest = np.tile(width[rest] / 2, 2), np.tile(slowest[rest], 2)
        low = np.concatenate([low[rest], low[rest] + width[: rest.sum()]])
    if low.size:
        return Sectors(edges, part, float((low + width / 2).min()))
    begin, coefficients = np.concatenate(starts), np.concatenate(found)
    order = np.argsort(begin, kind="stable")
    return Sectors(np.append(begin[order], edges[-1]), coefficients[order])


def _unit(v: FloatArray) -> FloatArray:
    length = np.linalg.norm(v, axis=-1, keepdims=True)
    return np.asarray(v / np.where(length > 0, length, 1.0))


def _signed_angle(u: FloatArray, v: FloatArray) -> FloatArray:
    """Angle from u to v in (-pi, pi], rows of (n, 2)."""
    cross = u[..., 0] * v[..., 1] - u[..., 1] * v[..., 0]
    return np.asarray(np.arctan2(cross, u[..., 0] * v[..., 0] + u[..., 1] * v[..., 1]))
