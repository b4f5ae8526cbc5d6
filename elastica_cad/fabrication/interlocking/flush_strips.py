"""Where bent strips lie in each other's thickness: side by side their middle surfaces need not cross."""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from elastica_cad._types import BoolArray, FloatArray
from elastica_cad.fabrication.interlocking.interlock import SHALLOW_RAD, strip_thickness
from elastica_cad.fabrication.interlocking.ruled_strip import InPlane, RuledStrip
from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.geometry.boxes import box_about

ROWS = 200
"""Rulings of a strip that are looked for in another: an overlap between two of them is missed."""

ACROSS = np.array([-1.0, -0.5, 0.0, 0.5, 1.0])
"""Places on a ruling, from edge to edge: of two strips whose edges overlap, one has an edge in the other."""

FOOT_STEPS = 3
"""Newton's steps from the nearest station of a curve to its nearest place."""

INSCRIBED = np.sqrt(0.5)
"""Of a round rod's diameter, the side of the square in it."""


@dataclass(frozen=True, eq=False)
class Slab:
    """A bent strip with its thickness, mm, half of it on either side of the ruled surface."""

    ruled: RuledStrip
    thickness: float

    @classmethod
    def of(cls, ruled: RuledStrip, strip: Strip) -> "Slab":
        """A strip, everywhere as thick as where it is thinnest; of a round rod the square in it."""
        for quantity, size in strip.tapered.items():
            thinnest = float(size.extremes[0])
            if quantity == "thickness":
                return cls(ruled, thinnest)
            width = replace(ruled.width, coefficients=INSCRIBED * ruled.width.coefficients)
            return cls(replace(ruled, width=width), INSCRIBED * thinnest)
        return cls(ruled, strip_thickness(strip))

    @cached_property
    def rows(self) -> tuple[FloatArray, FloatArray]:
        """Stations (n,) all along the strip, and the places (n, 2) of its curve there."""
        stations = np.linspace(0.0, self.ruled.length, ROWS)
        return stations, self.ruled.in_plane(stations)[0]


def flush_overlap(first: Slab, second: Slab, least: float) -> tuple[float, float] | None:
    """Arc lengths of both, mm, where they lie in each other by more than `least` mm; None where they do not.

    Strips thinner than twice that are asked by half their thickness. Where the surfaces do not run nearly the
    same way, strips cross or lie edge to edge, which is not asked here.
    """
    thin = min(first.thickness, second.thickness)
    reach = (first.thickness + second.thickness) / 2 - min(least, thin / 2)
    found = _nearest(first.ruled, second.ruled, reach, least)
    if found is None:
        other = _nearest(second.ruled, first.ruled, reach, least)
        found = None if other is None else other[::-1]
    return found


def _nearest(a: RuledStrip, b: RuledStrip, reach: float, inset: float) -> tuple[float, float] | None:
    """Arc lengths where the first strip comes nearest to the second's surface, of places within reach."""
    s, stations = _alike(a, b, inset), _alike(b, a, inset)
    s = s[a.half_width(s) > 0]
    if not (s.size and stations.size):
        return None
    across = np.multiply.outer(a.half_width(s), ACROSS)
    middle, tangent = a.in_plane(s)
    points = b.frame.local(a.frame.point(middle)[:, None] + across[..., None] * a.axis)
    curve = b.in_plane(stations)[0]
    low, high = box_about(curve) + np.array([[-reach], [reach]])
    near = np.all((points[..., :2] > low) & (points[..., :2] < high), axis=2)
    near &= np.abs(points[..., 2]) < b.half_width(stations).max()
    row = np.nonzero(near)[0]
    points = points[near]
    if not row.size:
        return None
    foot, (places, tangents) = nearest_places(b, (stations, curve), points[:, :2])
    distance = np.hypot(*(points[:, :2] - places).T)
    normals = a.normal(tangent)[row], b.normal(tangents)
    facing = np.abs((normals[0] * normals[1]).sum(axis=1)) > np.cos(SHALLOW_RAD)
    on_it = (foot > inset) & (foot < b.length - inset) & (np.abs(points[:, 2]) < b.half_width(foot))
    distance = np.where(facing & on_it, distance, np.inf)
    k = int(np.argmin(distance))
    return (float(s[row[k]]), float(foot[k])) if distance[k] < reach else None


def _alike(strip: RuledStrip, other: RuledStrip, inset: float) -> FloatArray:
    """Stations (n,) of the first at which its surface may run nearly as the other's does somewhere."""
    s = np.linspace(min(inset, strip.length / 2), max(strip.length - inset, strip.length / 2), ROWS)
    # normals lie across both rulings where they are equal; each is as far from that as its tangent goes along it
    along = strip.motion(s)[1] @ np.cross(strip.axis, other.axis)
    kept: BoolArray = np.abs(along) <= np.sin(SHALLOW_RAD)
    return s[kept]


def nearest_places(
    strip: RuledStrip, rows: tuple[FloatArray, FloatArray], points: FloatArray
) -> tuple[FloatArray, InPlane]:
    """Arc lengths (n,) of the places of the curve nearest to points (n, 2) of its plane, and its motion there.

    Steps begin at the nearest of `rows`: stations and the places of the curve there.
    """
    stations, curve = rows
    s = stations[((curve**2).sum(axis=1) - 2 * points @ curve.T).argmin(axis=1)]
    for _ in range(FOOT_STEPS):
        place, tangent = strip.in_plane(s)
        s = np.clip(s + ((points - place) * tangent).sum(axis=1), 0.0, strip.length)
    return s, strip.in_plane(s)
