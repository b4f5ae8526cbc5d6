"""Shapes and animation of a strip whose end slides along a line or rotates."""

from dataclasses import dataclass
from os import PathLike
from pathlib import Path as FilePath

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import ArrayLike, FloatArray, IntArray
from elastica_cad._values import distinct_digits, is_number, require_record
from elastica_cad.errors import InputError
from elastica_cad.formats.animated_glb import MovingMesh, encode_animation
from elastica_cad.formats.write_files import write_atomically
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.geometry.plane_points import left_of, norm, unit_vectors
from elastica_cad.kernel.mesh_files import face_triangles
from elastica_cad.kernel.occt import make_solid
from elastica_cad.kernel.strip_body import Point, StripBody, end_angles
from elastica_cad.mechanics.bending import Leg, path_legs
from elastica_cad.mechanics.least_ratio import optimal_rod
from elastica_cad.mechanics.rod import Rod
from elastica_cad.model.assembly import layer_names
from elastica_cad.strip.layers import Layer
from elastica_cad.strip.solids import BentSolid, bent_colors, centred_thickness
from elastica_cad.strip.strip import Strip

TURN_RAD = 2.5
"""Angle, rad, of the circular arc into which a strip is bent for meshing, so that its tabs do not meet."""


@dataclass(frozen=True, eq=False)
class SkinMesh:
    """Triangle mesh of a flat strip.

    Attributes
    ----------
    places : (n, 3) array
        Corners: x along the strip, y across it, and height above mid-thickness, mm.
    normals : (n, 3) array
        Outward unit normals at the corners, in the same axes.
    triangles : (m, 3) array of int
        Indices of the corners of each triangle, anticlockwise as seen from outside. The faces of the strip have
        separate corners.
    """

    places: FloatArray
    normals: FloatArray
    triangles: IntArray

    def bent(self, rod: Rod, frame: Frame) -> tuple[FloatArray, FloatArray]:
        """Return the corners and normals (n, 3) in space after the strip is bent to the shape of `rod`.

        The x and y axes of `frame` are the axes of the curve's plane.
        """
        from scipy.interpolate import CubicHermiteSpline

        x, y, up = self.places.T
        s = np.clip(x, 0.0, rod.length)
        along = unit_vectors(np.interp(s, rod.s, rod.angle))
        right = -left_of(along)  # the upper face of the flat strip is to the right of the curve
        course = CubicHermiteSpline(rod.s, rod.position, unit_vectors(rod.angle))
        plane = course(s) + (x - s)[:, None] * along + up[:, None] * right
        facing = self.normals[:, :1] * along + self.normals[:, 2:] * right
        turned = np.column_stack([facing, self.normals[:, 1]])
        return frame.point(np.column_stack([plane, y])), frame.direction(turned)


def skin_meshes(strip: Strip) -> tuple[SkinMesh, ...]:
    """Return the surface mesh of each sheet of the flat strip. The base of a laminate is first.

    Each sheet is meshed while bent to a circular arc, so that the mesh has many corners along the strip, and the
    mesh is then unrolled.
    """
    radius = strip.rod.length / TURN_RAD
    circle = optimal_rod(PlaneCurve.arc((0.0, 0.0), radius, 0.0, TURN_RAD))
    half = centred_thickness(strip) / 2
    return tuple(
        _skin_mesh(layer, circle, radius, (layer.low - half, layer.high - half)) for layer in strip.layers
    )


def _skin_mesh(layer: Layer, circle: Rod, radius: float, heights: tuple[float, float]) -> SkinMesh:
    """Return the surface mesh of a layer, unrolled from a strip that was bent to a circle of this radius, mm.

    The circle makes the mesh fine along the strip, as its later shapes need.
    """
    body = make_solid(BentSolid.wrapped(circle, layer.outline, layer.holes, heights=heights))
    places: list[FloatArray] = []
    normals, triangles = [], []
    # this distance gives about 80 segments along the strip
    for points, corners in face_triangles(body, chord=5e-5 * circle.length, turn=1.0):
        flat = _unrolled(points, radius)
        triangles.append(corners + sum(len(rows) for rows in places))
        places.append(flat)
        # unit normals at the corners: means of the adjacent triangles, weighted by their areas
        a, b, c = flat[corners.T]
        sums = np.zeros_like(flat)
        np.add.at(sums, corners.T, np.cross(b - a, c - a))
        normals.append(np.asarray(sums / np.maximum(np.linalg.norm(sums, axis=1), 1e-30)[:, None]))
    return SkinMesh(np.concatenate(places), np.concatenate(normals), np.concatenate(triangles))


def _unrolled(points: FloatArray, radius: float) -> FloatArray:
    """Convert points (n, 3) of a strip bent into an arc to (along, across, height), mm, in the flat strip.

    The centre of the arc is the origin.
    """
    # z is across the strip; the other two columns are replaced below
    flat = np.column_stack([points[:, 2]] * 3)
    turn = np.arctan2(points[:, 1], points[:, 0])
    # tabs are straight, and their points have angles outside the arc
    for end, sign in ((0.0, -1.0), (TURN_RAD, 1.0)):
        along = np.array([-np.sin(end), np.cos(end)])
        beyond = sign * (points[:, :2] @ along)
        off = points[:, :2] @ (along[1], -along[0]) - radius
        on_tab = (sign * (turn - end) > 0) & (np.abs(off) < radius / 2) & (beyond > 0)
        flat[on_tab, 0] = end * radius + sign * beyond[on_tab]
        flat[on_tab, 2] = off[on_tab]
        turn[on_tab] = np.nan  # these points are done
    bent = np.isfinite(turn)
    flat[bent, 0] = turn[bent] * radius
    flat[bent, 2] = norm(points[bent, :2]) - radius
    return flat


@dataclass(frozen=True, eq=False)
class Travel:
    """Path of the end of a strip: a translation along a line, or a rotation in place.

    Parameters
    ----------
    strip : Strip
    frame : Frame
        Plane of the curve of the strip.
    end : (2,) array_like, optional
        Final position of the end after a translation, mm, in the plane of the curve.
    angle : float, optional
        Final direction of the end after a rotation, rad. Full turns along the strip are included, as in `bend`.

    Examples
    --------
    >>> from elastica_cad.mechanics.bending import bend
    >>> from elastica_cad.mechanics.sheets import Sheet
    >>> arch = bend(Rod.straight(100.0, samples=101), end=(90.0, 0.0))
    >>> travel = Travel(Strip(arch, Sheet.named("pom-0.5"), max_width=10), Frame(), (70.0, 0.0))
    >>> travel.length, bool(abs(travel.rod(20.0).position[:, 1].max() - 31.4) < 0.1)
    (20.0, True)
    """

    strip: Strip
    frame: Frame
    end: ArrayLike | None = None
    angle: float | None = None

    def __post_init__(self) -> None:
        if (self.end is None) == (self.angle is None):
            raise InputError("The travel needs a point or an angle, but not both. Pass one of them.")
        if self.end is not None:
            point = np.asarray(self.end, dtype=float)
            if point.shape != (2,) or not np.all(np.isfinite(point)):
                raise InputError(
                    f"The end of a travel is {self.end!r}. Use two numbers in mm, in the plane of the curve."
                )
            object.__setattr__(self, "end", point)
            apart = float(norm(point - self._rod.position[0]))
            if apart > self._rod.length:
                far, long = distinct_digits(apart, self._rod.length, ".4g")
                raise InputError(
                    f"The travel ends {far} mm from the start of a strip that is {long} mm long. Choose a "
                    "nearer point."
                )
        if self.length < 1e-6:
            raise InputError("The end of the strip is already in this position. Pass another position.")

    @property
    def _rod(self) -> Rod:
        return self.strip.rod

    @property
    def _way(self) -> FloatArray:
        return np.asarray(self.end - self._rod.position[-1])

    @property
    def _turn(self) -> float:
        return 0.0 if self.angle is None else float(self.angle - self._rod.angle[-1])

    @property
    def length(self) -> float:
        """Distance of the translation, mm, or angle of the rotation, degrees."""
        size = norm(self._way) if self.angle is None else abs(np.degrees(self._turn))
        # round the range, so that a CAD joint accepts the final angle
        return round(float(size), 9)

    @property
    def unit(self) -> str:
        """Unit of `length` and of positions on the path: "mm" or "degrees"."""
        return "mm" if self.angle is None else "degrees"

    @property
    def place(self) -> Frame:
        """Frame of the end before the travel, with the z axis across the strip.

        The x axis is along the translation or, for a rotation about z, along the strip.
        """
        along = self._way / self.length if self.angle is None else unit_vectors(self._rod.angle[-1])
        x, z = self.frame.direction(along), self.frame.z_axis * (-1.0 if self._turn < 0 else 1.0)
        return Frame(self.frame.point(self._rod.position[-1]), x, np.cross(z, x))

    @cached_property
    def _leg(self) -> Leg:
        step = {"end": self.end} if self.angle is None else {"angles": (None, float(self.angle))}
        (leg,) = path_legs(self.strip.rod_to_bend, [step])
        return leg

    def rods(self, frames: int) -> tuple[Rod, ...]:
        """Return `frames` shapes in equal steps of the path, including both ends."""
        if not isinstance(frames, int) or frames < 2:
            raise InputError(f"`frames` is {frames}, too few for a motion. Use a whole number, 2 or more.")
        return (self._rod, *map(self._leg.rod, np.linspace(0.0, 1.0, frames)[1:].tolist()))

    def rod(self, position: float) -> Rod:
        """Return the rod in its shape at a position on the path, mm or degrees."""
        share = position / self.length if is_number(position) else np.nan
        if not -1e-9 <= share <= 1 + 1e-9:
            requested = f"{position:g}" if is_number(position) else repr(position)
            raise InputError(
                f"position is {requested} {self.unit}, outside the travel. Use 0 to {self.length:.4g} {self.unit}."
            )
        return self._leg.rod(min(max(share, 0.0), 1.0))

    def write_glb(
        self,
        path: str | PathLike[str],
        *,
        frames: int = 25,
        seconds: float = 4.0,
        color: tuple[float, ...] | None = None,
        force: bool = False,
    ) -> None:
        """Write an animation of the path and back as a GLB file, for browsers, phones and Blender.

        Parameters
        ----------
        frames : int
            Number of shapes on the path to its end. Viewers interpolate between them.
        seconds : float
            Duration of the path and back, s.
        color : tuple of float, optional
            Colour of the base sheet: red, green and blue from 0 to 1. By default it is the colour of its material.
        force : bool
            If True, an existing file is overwritten.
        """
        if FilePath(path).suffix.lower() != ".glb":
            raise InputError(
                f"{FilePath(path).name} is not a name of a binary glTF file. Use a name ending in .glb."
            )
        if not (is_number(seconds) and seconds > 0):
            raise InputError(f"`seconds` is {seconds!r}. Use a positive number of seconds.")
        rods = self.rods(frames)
        names = layer_names(self.strip.label or "strip", self.strip)
        moving = []
        colors = bent_colors(self.strip, color)
        for skin, name, of_sheet in zip(skin_meshes(self.strip), names, colors, strict=True):
            shapes = [skin.bent(rod, self.frame) for rod in rods]
            points, normals = (np.array(rows) for rows in zip(*shapes, strict=True))
            moving.append(MovingMesh(name, of_sheet[:3], points, normals, skin.triangles))
        write_atomically(path, encode_animation(moving, seconds), force=force)


def travel_of(rib: StripBody, end: Point | None, angle: float | None) -> Travel:
    """Return the travel of the end of a bent body to a point, mm, or to an angle, degrees.

    A point is in space, or two coordinates in the `frame` of the body. The angle is measured in this frame.
    """
    require_record(rib, StripBody, "what slides", "a bent strip")
    if rib._made.home is None:
        raise InputError("Only a bent strip has a sliding end. Call .bent() first.")
    point = None if end is None else rib._in_plane(end, "end")
    return Travel(rib.strip, rib.frame, point, end_angles((None, angle))[1])
