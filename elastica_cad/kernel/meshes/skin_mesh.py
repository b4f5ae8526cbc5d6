"""The skin of a strip as triangles over its flat pattern, which take any shape that the strip is bent into."""

from dataclasses import dataclass

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.fabrication.solids.strip_solids import BentSolid, centred_thickness
from elastica_cad.fabrication.strip.strip_layers import Layer
from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.frame import Frame
from elastica_cad.kernel.meshes.face_triangles import face_triangles
from elastica_cad.kernel.occt import make_solid
from elastica_cad.mechanics.rod.rod_record import Rod
from elastica_cad.mechanics.stiffness.optimal_rod import optimal_rod

TURN_RAD = 2.5
"""Of the circle that a strip is bent into to be meshed: any that keeps the tabs apart."""

CHORD = 5e-5
"""How far triangles leave that circle, over the strip's length: some eighty of them along it."""


@dataclass(frozen=True, eq=False)
class SkinMesh:
    """Triangles over a flat strip.

    Attributes
    ----------
    places : (n, 3) array
        x along the strip, y across, height off the middle of its thickness, mm.
    normals : (n, 3) array
        Outward, in the same axes.
    triangles : (m, 3) array of int
        Anticlockwise from outside; faces of the strip have corners of their own.
    """

    places: FloatArray
    normals: FloatArray
    triangles: IntArray

    def bent(self, rod: Rod, frame: Frame) -> tuple[FloatArray, FloatArray]:
        """Points and normals (n, 3) in space of the strip bent into the rod's curve, drawn in `frame`."""
        from scipy.interpolate import CubicHermiteSpline

        x, y, up = self.places.T
        s = np.clip(x, 0.0, rod.length)
        angle = np.interp(s, rod.s, rod.angle)
        along = np.column_stack([np.cos(angle), np.sin(angle)])
        right = np.column_stack([along[:, 1], -along[:, 0]])
        course = CubicHermiteSpline(
            rod.s, rod.position, np.column_stack([np.cos(rod.angle), np.sin(rod.angle)])
        )
        plane = course(s) + (x - s)[:, None] * along + up[:, None] * right
        facing = self.normals[:, :1] * along + self.normals[:, 2:] * right
        turned = np.column_stack([facing, self.normals[:, 1]])
        return frame.point(np.column_stack([plane, y])), frame.direction(turned)


def skin_meshes(strip: Strip) -> tuple[SkinMesh, ...]:
    """The skins of the sheets of a strip, the base first."""
    radius = strip.rod.length / TURN_RAD
    circle = optimal_rod(PlaneCurve.arc((0.0, 0.0), radius, 0.0, TURN_RAD))
    half = centred_thickness(strip) / 2
    return tuple(
        _skin_mesh(layer, circle, radius, (layer.low - half, layer.high - half)) for layer in strip.layers
    )


def _skin_mesh(layer: Layer, circle: Rod, radius: float, heights: tuple[float, float]) -> SkinMesh:
    """Meshed on a circle, where every point tells its place in the flat pattern."""
    body = make_solid(BentSolid.wrapped(circle, layer.outline, layer.holes, heights=heights))
    places: list[FloatArray] = []
    normals, triangles = [], []
    for points, corners in face_triangles(body, chord=CHORD * circle.length, turn=1.0):
        flat = _unrolled(points, radius)
        triangles.append(corners + sum(len(rows) for rows in places))
        places.append(flat)
        normals.append(_normals(flat, corners))
    return SkinMesh(np.concatenate(places), np.concatenate(normals), np.concatenate(triangles))


def _unrolled(points: FloatArray, radius: float) -> FloatArray:
    """Along, across and height of points of a strip that is bent into a circle about the origin."""
    flat = np.column_stack([points[:, 2]] * 3)
    turn = np.arctan2(points[:, 1], points[:, 0])
    # a tab goes on straight: what lies on it turns by less than nothing, or by more than the circle
    for end, way in ((0.0, -1.0), (TURN_RAD, 1.0)):
        along = np.array([-np.sin(end), np.cos(end)])
        beyond = way * (points[:, :2] @ along)
        off = points[:, :2] @ (along[1], -along[0]) - radius
        on_tab = (way * (turn - end) > 0) & (np.abs(off) < radius / 2) & (beyond > 0)
        flat[on_tab, 0] = end * radius + way * beyond[on_tab]
        flat[on_tab, 2] = off[on_tab]
        turn[on_tab] = np.nan
    bent = np.isfinite(turn)
    flat[bent, 0] = turn[bent] * radius
    flat[bent, 2] = np.hypot(*points[bent, :2].T) - radius
    return flat


def _normals(places: FloatArray, corners: IntArray) -> FloatArray:
    """At every corner the mean of its triangles, by area."""
    a, b, c = (places[corners[:, i]] for i in range(3))
    found = np.zeros_like(places)
    for i in range(3):
        np.add.at(found, corners[:, i], np.cross(b - a, c - a))
    return np.asarray(found / np.maximum(np.linalg.norm(found, axis=1), 1e-30)[:, None])
