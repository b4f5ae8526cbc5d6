"""A strip whose end slides along a line: its shapes, the place of its end, and an animation."""

from dataclasses import dataclass
from functools import cached_property
from os import PathLike
from pathlib import Path as FilePath

import numpy as np

from elastica_cad._counts import told_apart
from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import is_number, require_record
from elastica_cad.errors import InputError
from elastica_cad.fabrication.drawings.sheet_colors import sheet_color
from elastica_cad.fabrication.model.assembly import layer_names
from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.formats.file_access.write_files import write_atomically
from elastica_cad.formats.surface_files.animated_glb import MovingMesh, encode_animation
from elastica_cad.geometry.frame import Frame
from elastica_cad.kernel.meshes.skin_mesh import skin_meshes
from elastica_cad.kernel.strip_body import Point, StripBody
from elastica_cad.mechanics.bending.bend_forward import bend, bend_path
from elastica_cad.mechanics.rod.rod_record import Rod

STATIONS = 24
"""Shapes along the way that are found first, each from the one before; others begin at the nearest of them."""


@dataclass(frozen=True, eq=False)
class Travel:
    """The way of a strip's end from where it is to another point, straight, its direction held.

    Parameters
    ----------
    strip : Strip
    frame : Frame
        The plane of its curve.
    end : (2,) array_like
        Where the end goes, mm, in that plane.

    Raises
    ------
    InputError
        The end is there already, or the point is farther from the start than the strip is long.

    Examples
    --------
    >>> from elastica_cad.mechanics.material.sheet import Sheet
    >>> arch = bend(Rod.straight(100.0, samples=101), end=(90.0, 0.0))
    >>> travel = Travel(Strip(arch, Sheet.named("pom-0.5"), max_width=10), Frame(), (70.0, 0.0))
    >>> travel.length, bool(abs(travel.rod(20.0).position[:, 1].max() - 31.4) < 0.1)
    (20.0, True)
    """

    strip: Strip
    frame: Frame
    end: ArrayLike

    def __post_init__(self) -> None:
        point = np.asarray(self.end, dtype=float)
        if point.shape != (2,) or not np.all(np.isfinite(point)):
            raise InputError(
                f"the end of a travel is {self.end!r}: give two numbers, mm, in the curve's plane"
            )
        object.__setattr__(self, "end", point)
        if self.length < 1e-6:
            raise InputError("the end of the strip is there already: give another point for it to go to")
        apart = float(np.hypot(*(point - self._rod.position[0])))
        if apart > self._rod.length:
            far, long = told_apart(apart, self._rod.length, ".4g")
            raise InputError(
                f"the travel ends {far} mm from the start of a strip that is {long} mm long: "
                "give a nearer point"
            )

    @property
    def _rod(self) -> Rod:
        return self.strip.rod

    @property
    def _way(self) -> FloatArray:
        return np.asarray(self.end - self._rod.position[-1])

    @property
    def length(self) -> float:
        """How far the end goes, mm."""
        return float(np.hypot(*self._way))

    @property
    def place(self) -> Frame:
        """Where the end is at first: x along the travel, z across the strip."""
        x = self.frame.direction(self._way / self.length)
        at = self.frame.point(self._rod.position[-1])
        return Frame(at, x, np.cross(self.frame.z_axis, x))

    @cached_property
    def _stations(self) -> tuple[Rod, ...]:
        """Where a shape on the way is found from: the first is the design as it begins to bend."""
        return (self.strip.rod_to_bend, *self.rods(STATIONS + 1)[1:])

    def rods(self, frames: int) -> tuple[Rod, ...]:
        """The shapes at even places of the way, both its ends among them, each found from the one before."""
        if not isinstance(frames, int) or frames < 2:
            raise InputError(f"a travel of {frames} frames shows no motion: give a whole number, 2 or more")
        shares = np.linspace(0.0, 1.0, frames)[1:, None]
        return (self._rod, *bend_path(self.strip.rod_to_bend, self._rod.position[-1] + shares * self._way))

    def rod(self, position: float) -> Rod:
        """The shape with the end `position` mm along the way, found from the nearest station."""
        share = position / self.length if is_number(position) else np.nan
        if not -1e-9 <= share <= 1 + 1e-9:
            told = f"{position:g}" if is_number(position) else repr(position)
            raise InputError(f"position is {told} mm: the travel goes from 0 to {self.length:.4g} mm")
        near = self._stations[round(share * STATIONS)]
        return bend(near, end=self._rod.position[-1] + share * self._way)

    def write_glb(
        self,
        path: str | PathLike[str],
        *,
        frames: int = STATIONS + 1,
        seconds: float = 4.0,
        force: bool = False,
    ) -> None:
        """Write the way there and back as an animation, for browsers, phones and Blender.

        Parameters
        ----------
        frames : int
            Shapes on the way there; what lies between two is blended.
        seconds : float
            There and back.
        force : bool
            Write over a file that is there.

        Raises
        ------
        InputError
            Fewer than two frames, no time, a name without .glb, or a file that is there already or cannot be
            written.
        """
        if FilePath(path).suffix.lower() != ".glb":
            raise InputError(
                f"{FilePath(path).name}: animations are written as binary glTF: name the file .glb"
            )
        if not (is_number(seconds) and seconds > 0):
            raise InputError(
                f"an animation of {seconds!r} s shows nothing: give a positive number of seconds"
            )
        rods = self.rods(frames)
        names = layer_names(self.strip.label or "strip", self.strip)
        moving = []
        for skin, name, layer in zip(skin_meshes(self.strip), names, self.strip.layers, strict=True):
            shapes = [skin.bent(rod, self.frame) for rod in rods]
            points, normals = (np.array(rows) for rows in zip(*shapes, strict=True))
            moving.append(MovingMesh(name, sheet_color(layer.sheet), points, normals, skin.triangles))
        write_atomically(path, encode_animation(moving, seconds), force=force)


def travel_of(rib: StripBody, end: Point) -> Travel:
    """The travel of a bent body's end to a point in space, or to two numbers in the body's `frame`, mm.

    Raises
    ------
    InputError
        A body that is not bent, a point off the plane in which it bends, or as `Travel`.
    """
    require_record(rib, StripBody, "what slides", "a bent strip")
    if rib._made.home is None:
        raise InputError("the end of a strip slides when it is bent: take its body .bent() first")
    return Travel(rib.strip, rib.frame, rib._in_plane(end, "end"))
