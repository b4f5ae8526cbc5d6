"""Models and bodies in space, drawn from behind to before."""

from collections.abc import Sequence
from functools import lru_cache
from itertools import pairwise
from textwrap import fill

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import is_series, is_whole, numbers, require_number, several
from elastica_cad.errors import InputError
from elastica_cad.fabrication.drawings.sheet_colors import sheet_color
from elastica_cad.fabrication.holders.plates import BasePlate, Ring
from elastica_cad.fabrication.model.assembly import HOLDERS, Holder, require_model
from elastica_cad.fabrication.model.strip_model import Model
from elastica_cad.fabrication.placed_strip import Placed
from elastica_cad.fabrication.sheets.pieces import EqualStrips
from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.geometry.frame import Frame
from elastica_cad.mechanics.rod.rod_record import Rod
from elastica_cad.plot.canvas import INK, WIDTH_INCHES, Axes, Figure, Panel, new_page, paint_patches
from elastica_cad.plot.holder_pictures import holder_patches, level_plates
from elastica_cad.plot.slabs import trapezoids
from elastica_cad.plot.strip_pictures import paint_flat

FLAT_SHARE = 5e-4
"""Of a strip's length: how closely polygons follow its loops."""

RIM_SHARE, MODEL_RIM_SHARE = 0.035, 0.0015
"""Of the strip's width, and at most of the model's extent: the dark line along every edge."""

ON_PLANE_MM = 1e-6
"""What is nearer to a plane lies on it: rounding."""

HOLDER_PATCH_SHARE = 0.02
"""Of the model's extent: patches of what holds it, small enough to be sorted by their depth."""

OUTLINE_MM = 0.1
"""How closely polygons follow outlines that strips stand in."""

NAME_SHARE = 0.045
"""Of the longest flat part: room for its name."""

_FLATS = 64
"""Strips whose trapezoids are kept: a model is drawn as it stands and taken apart."""

LIGHT = np.array([0.35, -0.45, 0.82])
"""Towards the light: from above, the left and the front."""


def model(
    model: Model,
    *,
    holders: Sequence[Holder] = (),
    elevation: float = 25.0,
    azimuth: float = -60.0,
    flat: int = 0,
) -> Figure:
    """The bent strips of a model in the colours of their sheets, seen from two angles in degrees.

    Tabs, slots and holes are drawn; of a laminate its base. What holds the strips, besides the model's own plates,
    is drawn with its slots filled. So many different parts are shown as they are cut, in one scale of their own,
    below: the first, the last, and others between them.
    """
    require_model(model)
    if not (is_whole(flat) and flat >= 0):
        raise InputError(f"flat is {flat!r}: give a whole number of parts to show, 0 for none")
    held_by = (*model.plates, *several("holders", holders, Holder, HOLDERS))
    plates = level_plates(held_by)
    faces = [frame for plate in plates for frame in _faces(plate)]
    bent = np.concatenate([one.frame.point(one.strip.rod.position) for one in model.placed])
    rim = MODEL_RIM_SHARE * float(np.ptp(bent, axis=0).max())
    strips = [rule_strip(placed, faces, rim) for placed in model.placed]
    strips = [_outside(one, plates) for one in strips]
    size = HOLDER_PATCH_SHARE * float(np.ptp(bent, axis=0).max())
    drawn = [*strips, *((part, _lit(part) * color) for part, color in holder_patches(held_by, size))]
    patches, colors = (np.concatenate(part) for part in zip(*drawn, strict=True))
    count = f"{len(model.placed)} strips" if len(model.placed) > 1 else "1 strip"
    title = f"{fill(model.name, 90)}\n{count}"
    if flat < 1:
        return _seen(patches, colors, title, elevation, azimuth, faces=faces)
    chosen = np.unique(np.linspace(0, len(model.parts) - 1, flat).round().astype(int))
    parts = [model.parts[i] for i in chosen]
    longest = max(float(np.ptp(part.strip.outline.bounds, axis=0)[0]) for part in parts)
    return _seen(patches, colors, title, elevation, azimuth, (parts, longest), faces)


def bodies(
    meshes: Sequence[tuple[ArrayLike, ArrayLike, tuple[float, float, float]]],
    *,
    title: str = "",
    elevation: float = 25.0,
    azimuth: float = -60.0,
) -> Figure:
    """Closed triangle meshes in space, as `tessellate` of CAD kernels gives them.

    Parameters
    ----------
    meshes : sequence of (vertices (n, 3), triangles (m, 3), color)
        mm; rows of vertices, anticlockwise seen from outside; red, green, blue in 0..1.
    title : str
    elevation, azimuth : float
        Where the eye is, degrees.

    Raises
    ------
    InputError
        No meshes, or arrays of another shape.
    """
    patches, colors = [], []
    if not is_series(meshes) or not all(is_series(mesh) and len(tuple(mesh)) == 3 for mesh in meshes):
        raise InputError("meshes are a list of (vertices, triangles, color)")
    for vertices, triangles, color in meshes:
        points, rows = numbers(vertices, "vertices"), numbers(triangles, "triangles").astype(int)
        if points.ndim != 2 or points.shape[1] != 3 or rows.ndim != 2 or rows.shape[1] != 3:
            raise InputError("a mesh is vertices (n, 3) in mm and triangles (m, 3) of their rows")
        patches.append(points[rows])
        colors.append(np.tile(np.asarray(color, dtype=float), (len(rows), 1)))
    if not patches:
        raise InputError("there is nothing to draw: give one mesh or more")
    corners, tints = np.concatenate(patches), np.concatenate(colors)
    outward = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    faced = outward @ look_from(elevation, azimuth) > 0
    longest = float(np.ptp(corners.reshape(-1, 3), axis=0).max()) / 60
    corners, tints = _fine(corners[faced], tints[faced], longest)
    return _seen(corners, _lit(corners) * tints, title, elevation, azimuth)


def _seen(
    patches: FloatArray,
    colors: FloatArray,
    title: str,
    elevation: float,
    azimuth: float,
    flat: tuple[Sequence[EqualStrips], float] | None = None,
    faces: Sequence[Frame] = (),
) -> Figure:
    """Patches (n, k, 3) painted from the farthest to the nearest, and flat parts with the longest one's length.

    What lies on the eye's side of a face is painted after all that lies on its other side.
    """
    toward = look_from(elevation, azimuth)
    plane = patches @ screen_of(elevation, azimuth)
    middle = patches.mean(axis=1)
    before = [_height(middle, face) * np.sign(face.z_axis @ toward) > ON_PLANE_MM for face in faces]
    order = np.lexsort([middle @ toward, *before])
    size = np.maximum(np.ptp(plane.reshape(-1, 2), axis=0), 1e-9)
    tall = float(np.clip(WIDTH_INCHES * size[1] / size[0], 2.0, 9.0 if flat is None else 6.0))
    below = 0.0 if flat is None else WIDTH_INCHES * _flat_height(*flat) / (1.04 * flat[1])
    extent = " by ".join(f"{d:.0f}" for d in np.ptp(patches.reshape(-1, 3), axis=0))
    headed = f"{title}, {extent} mm" if title else f"{extent} mm"
    figure, (axes, *lower) = new_page([Panel(tall), *([] if flat is None else [Panel(below)])], headed)
    if flat is not None:
        _draw_flats(lower[0], *flat)
    paint_patches(axes, plane[order], colors[order])
    axes.autoscale_view()
    axes.set_aspect("equal")
    axes.set_axis_off()
    return figure


def _flat_height(parts: Sequence[EqualStrips], longest: float) -> float:
    """Of the flat parts one above the other with their names between them, mm."""
    return sum(float(np.ptp(part.strip.outline.bounds, axis=0)[1]) + NAME_SHARE * longest for part in parts)


def _draw_flats(axes: Axes, parts: Sequence[EqualStrips], longest: float) -> None:
    """Parts as they are cut, one above the other, each named."""
    y = 0.0
    for part in parts:
        strip = part.strip
        (left, bottom), (right, top) = strip.outline.bounds
        y -= NAME_SHARE * longest
        sheets = " on ".join(layer.sheet.name for layer in reversed(strip.layers))
        times = "" if part.count == 1 else f", {part.count} times"
        text = f"{part.name}{times}: {right - left:.0f} by {top - bottom:.0f} mm, {sheets}"
        axes.text(0.0, y + 0.2 * NAME_SHARE * longest, text, fontsize=9, color=INK, va="bottom")
        paint_flat(axes, strip, (-left, y - top))
        y -= top - bottom
    axes.set_xlim(-0.02 * longest, 1.02 * longest)
    axes.set_ylim(y - 0.005 * longest, 0.0)
    axes.set_aspect("equal")
    axes.set_axis_off()


def look_from(elevation: float, azimuth: float) -> FloatArray:
    """Unit vector from the scene to the eye."""
    e, a = np.radians(
        [require_number(elevation, "elevation", "degrees"), require_number(azimuth, "azimuth", "degrees")]
    )
    return np.array([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)])


def screen_of(elevation: float, azimuth: float) -> FloatArray:
    """Unit vectors to the right and upwards in the picture, as columns (3, 2)."""
    right = np.array([-np.sin(np.radians(azimuth)), np.cos(np.radians(azimuth)), 0.0])
    return np.column_stack([right, np.cross(look_from(elevation, azimuth), right)])


def _lit(patches: FloatArray) -> FloatArray:
    """Brightness (n, 1) of patches by their slope to the light, the same on both sides."""
    normal = np.cross(patches[:, 2] - patches[:, 0], patches[:, -1] - patches[:, 1])
    normal = normal / np.maximum(np.linalg.norm(normal, axis=1), 1e-300)[:, None]
    return np.asarray(0.6 + 0.4 * np.abs(normal @ LIGHT)[:, None], dtype=float)


def _fine(triangles: FloatArray, colors: FloatArray, longest: float) -> tuple[FloatArray, FloatArray]:
    """Triangles halved across their longest edge until none is longer than `longest`, to be sorted by depth."""
    while True:
        edges = np.linalg.norm(np.roll(triangles, -1, axis=1) - triangles, axis=2)
        large = edges.max(axis=1) > longest
        if not large.any():
            return triangles, colors
        turn = (np.argmax(edges[large], axis=1)[:, None] + np.arange(3)) % 3
        a, b, c = np.moveaxis(np.take_along_axis(triangles[large], turn[..., None], axis=1), 1, 0)
        middle = (a + b) / 2
        halves = [np.stack([a, middle, c], axis=1), np.stack([middle, b, c], axis=1)]
        triangles = np.concatenate([triangles[~large], *halves])
        colors = np.concatenate([colors[~large], colors[large], colors[large]])


def rule_strip(
    placed: Placed, faces: Sequence[Frame] = (), rim_most: float = np.inf
) -> tuple[FloatArray, FloatArray]:
    """The strip in space with tabs, slots and holes: patches (n, 4, 3) with dark rims, and colours (n, 3)."""
    strip = placed.strip
    rod = strip.rod
    (first, low), (last, high) = strip.outline.bounds
    crossings = _crossings(placed, faces, (first, last))
    flat = _flat(strip, tuple(crossings.tolist()))
    across = np.diff(flat[..., 1:], axis=-1)
    rim = np.minimum(min(RIM_SHARE * (high - low), rim_most), across / 4)
    heights = [flat[..., 1:2], flat[..., 1:2] + rim, flat[..., 2:] - rim, flat[..., 2:]]
    along = _bent(rod, flat[..., 0])
    lines = [placed.frame.point(np.concatenate([along, y], axis=-1)) for y in heights]
    bands = [np.stack([a[:, 0], a[:, 1], b[:, 1], b[:, 0]], axis=1) for a, b in pairwise(lines)]
    lit = _lit(bands[1]) * np.array(sheet_color(strip.sheet))
    return np.concatenate(bands), np.concatenate([0.45 * lit, lit, 0.45 * lit])


@lru_cache(maxsize=_FLATS)
def _flat(strip: Strip, crossings: tuple[float, ...]) -> FloatArray:
    """Its trapezoids, cut at even stations and at crossings, arc lengths in mm."""
    (first, _), (last, _) = strip.outline.bounds
    stations = np.concatenate([np.linspace(0.0, strip.rod.length, 81), crossings])
    half = FLAT_SHARE * (last - first) / 2
    flat = trapezoids((strip.outline, *strip.holes), stations, half, blur=half)
    flat.setflags(write=False)
    return flat


def _faces(plate: BasePlate | Ring) -> tuple[Frame, Frame]:
    """The planes of both faces of a plate."""
    return plate.frame, plate.frame.shifted(z=-plate.sheet.thickness)


def _height(points: FloatArray, face: Frame) -> FloatArray:
    """Of points (n, 3) above a plane, mm."""
    return np.asarray((points - face.origin) @ face.z_axis, dtype=float)


def _crossings(placed: Placed, faces: Sequence[Frame], ends: tuple[float, float]) -> FloatArray:
    """Arc lengths at which the middle of a strip, tabs included, goes through planes."""
    rod = placed.strip.rod
    x = np.unique([*ends, *rod.s])
    points, found = placed.frame.point(_bent(rod, x)), []
    for face in faces:
        h = _height(points, face)
        i = np.flatnonzero(h[:-1] * h[1:] < 0)
        found.append(x[i] - h[i] * (x[i + 1] - x[i]) / (h[i + 1] - h[i]))
    return np.concatenate([np.empty(0), *found])


def _outside(
    drawn: tuple[FloatArray, FloatArray], plates: Sequence[BasePlate | Ring]
) -> tuple[FloatArray, FloatArray]:
    """Patches of a strip without those that lie within a plate, in its slots."""
    from matplotlib.path import Path as Polygon

    patches, colors = drawn
    for plate in plates:
        place = plate.frame.local(patches.mean(axis=1))
        inside = (place[:, 2] < 0) & (place[:, 2] > -plate.sheet.thickness)
        outline = Polygon(plate.solid.outline.points(OUTLINE_MM))
        inside[inside] = outline.contains_points(place[inside][:, :2])
        if isinstance(plate, Ring):
            inside &= np.hypot(place[:, 0], place[:, 1]) > plate.radii[0]
        patches, colors = patches[~inside], colors[~inside]
    return patches, colors


def _bent(rod: Rod, x: FloatArray) -> FloatArray:
    """Where the centre line (..., 2) goes at arc lengths x; tabs go on straight along the end tangents."""
    inside = np.clip(x, 0.0, rod.length)
    points = np.stack([np.interp(inside, rod.s, column) for column in rod.position.T], axis=-1)
    angle = np.where(x < 0, rod.angle[0], rod.angle[-1])
    return np.asarray(points + (x - inside)[..., None] * np.stack([np.cos(angle), np.sin(angle)], axis=-1))
