"""The turning angle as one continuous function, and the places where a curve has no direction."""

from dataclasses import dataclass

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.geometry.bernstein import product, split

__all__ = ["Turning", "hodograph", "turning_table", "zero_speed"]

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
        sector = np.searchsorted(self.edges, t, side="left" if left else "right") - 1
        sector = np.clip(sector, 0, self.angle.size - 1)
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


def zero_speed(hodographs: FloatArray, edges: FloatArray) -> float | None:
    """Parameter of the first place where the velocity vanishes (cusp, coincident control points), or None."""
    return _sectors(hodographs, edges)[0]


def turning_table(hodographs: FloatArray, edges: FloatArray) -> Turning:
    """Sectors of a curve without cusp; at a tangent break the angle jumps by the exterior angle."""
    _, low, coefficients = _sectors(hodographs, edges)
    first, last = _unit(coefficients[:, 0]), _unit(coefficients[:, -1])
    axis = _unit(first + last)
    to_end = _signed_angle(axis, last)
    to_start = _signed_angle(axis, first)
    across = _signed_angle(last[:-1], first[1:])
    steps = to_end[:-1] + across - to_start[1:]
    start = np.arctan2(first[0, 1], first[0, 0]) - to_start[0]
    angle = start + np.concatenate([[0.0], np.cumsum(steps)])
    return Turning(np.append(low, edges[-1]), axis, angle)


def _sectors(hodographs: FloatArray, edges: FloatArray) -> tuple[float | None, FloatArray, FloatArray]:
    """Place of zero speed or None; else starts (k,) and hodographs (k, n, 2) of the sectors."""
    part, low, width = hodographs, edges[:-1], np.diff(edges)
    size = np.linalg.norm(part, axis=-1)
    largest = size.max(axis=1)
    still = largest <= 1e-14 * largest.max()
    stopped = np.concatenate(
        [low[(size[:, 0] <= 1e-12 * largest) | still], (low + width)[size[:, -1] <= 1e-12 * largest]]
    )
    if stopped.size:
        return float(stopped.min()), low, part
    starts, sectors = [], []
    slowest = _SLOWEST * largest
    for _ in range(_DEEPEST):
        if not low.size:
            break
        axis = _unit(part[:, 0]) + _unit(part[:, -1])
        along = np.einsum("pnk,pk->pn", part, axis)
        length = np.linalg.norm(part, axis=-1)
        decided = (along > 1e-9 * length).all(axis=1) & (length[:, [0, -1]].min(axis=1) > slowest)
        starts.append(low[decided])
        sectors.append(part[decided])
        rest = ~decided
        left, right = split(np.swapaxes(part[rest], 1, 2))
        part = np.swapaxes(np.concatenate([left, right]), 1, 2)
        width, slowest = np.tile(width[rest] / 2, 2), np.tile(slowest[rest], 2)
        low = np.concatenate([low[rest], low[rest] + width[: rest.sum()]])
    if low.size:
        return float((low + width / 2).min()), low, part
    begin, coefficients = np.concatenate(starts), np.concatenate(sectors)
    order = np.argsort(begin, kind="stable")
    return None, begin[order], coefficients[order]


def _unit(v: FloatArray) -> FloatArray:
    length = np.linalg.norm(v, axis=-1, keepdims=True)
    return np.asarray(v / np.where(length > 0, length, 1.0))


def _signed_angle(u: FloatArray, v: FloatArray) -> FloatArray:
    """Angle from u to v in (-pi, pi], rows of (n, 2)."""
    cross = u[..., 0] * v[..., 1] - u[..., 1] * v[..., 0]
    return np.asarray(np.arctan2(cross, u[..., 0] * v[..., 0] + u[..., 1] * v[..., 1]))
