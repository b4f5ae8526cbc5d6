"""Pictures of models and bodies in space. Patches of strips and holders are painted from far to near."""

from collections.abc import Iterator, Sequence
from itertools import pairwise
from math import ceil, dist
from textwrap import fill

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import counted, is_series, is_whole, numbers, require_number, several
from elastica_cad.errors import InputError
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.path import Line, Path
from elastica_cad.geometry.plane_points import (
    at_sign_changes,
    box_about,
    midpoints,
    numbers_in_groups,
    unit_vectors,
)
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.sheets import Color, sheet_color
from elastica_cad.model.assembly import HOLDERS, Holder, require_model, single_holders
from elastica_cad.model.fixtures import FIXTURE_COLOR, EndFixture
from elastica_cad.model.frames import Rib
from elastica_cad.model.interlocking import strip_thickness
from elastica_cad.model.model import Model
from elastica_cad.model.plates import BasePlate
from elastica_cad.plot.canvas import (
    INK,
    WIDTH_INCHES,
    Axes,
    Figure,
    Panel,
    hide_axes,
    new_page,
    paint_patches,
    show_box,
)
from elastica_cad.plot.strip_pictures import paint_flat
from elastica_cad.strip.pieces import EqualStrips
from elastica_cad.strip.solids import FlatSolid
from elastica_cad.strip.strip import Placed, Strip

APART_MM = 1e-7
"""Stations closer together than this, mm, are merged."""


def trapezoids(loops: Sequence[Path], stations: FloatArray, step: float) -> FloatArray:
    """Divide the area inside an odd number of loops into trapezoids with sides parallel to y.

    Trapezoids end at corners of the loops and at `stations`.

    Parameters
    ----------
    loops : sequence of Path
        Closed outline and holes, in any direction.
    stations : (k,) array
        Values of x, mm, at which trapezoids also end.
    step : float
        Length, mm, of the sides of the polygons that approximate curved loops.

    Returns
    -------
    (n, 2, 3) array
        Trapezoids: x, lower y and upper y, mm, of the left side and of the right side.

    Examples
    --------
    >>> plate = [Path.rectangle(10.0, 4.0), Path.rectangle(2.0, 2.0, corner=(4.0, 1.0))]
    >>> parts = trapezoids(plate, np.array([]), 1.0)
    >>> width, height = np.diff(parts[..., 0], axis=1)[:, 0], (parts[..., 2] - parts[..., 1]).mean(axis=1)
    >>> len(parts), float(width @ height)
    (4, 36.0)
    """
    polygons = [_polygon_of(loop, step) for loop in loops]
    ends = np.concatenate([np.stack([p, np.roll(p, -1, axis=0)], axis=1) for p in polygons])
    ends = ends[np.abs(ends[:, 1, 0] - ends[:, 0, 0]) > APART_MM]
    # lines: sides of the polygons that are not parallel to y, with their left and right ends (m, 2)
    order = ends[..., 0].argsort(axis=1)
    left, right = np.moveaxis(np.take_along_axis(ends, order[..., None], axis=1), 1, 0)
    slope = (right[:, 1] - left[:, 1]) / (right[:, 0] - left[:, 0])
    low, high = left[:, 0].min(), right[:, 0].max()
    cuts = np.unique(
        np.concatenate([left[:, 0], right[:, 0], stations[(stations > low) & (stations < high)]])
    )
    cuts = cuts[np.append(True, np.diff(cuts) > APART_MM)]
    middles = midpoints(cuts)
    # a slab is the area between neighbouring values of x, and a line crosses consecutive slabs
    first = middles.searchsorted(left[:, 0], side="right")
    count = middles.searchsorted(right[:, 0]) - first
    line = np.arange(len(left)).repeat(count)
    slab = numbers_in_groups(count) + first.repeat(count)
    order = np.lexsort((left[line, 1] + slope[line] * (middles[slab] - left[line, 0]), slab))
    # in each slab, consecutive lines bound a part of the area from below and from above
    below, above, slab = line[order[0::2]], line[order[1::2]], slab[order[0::2]]
    # consecutive slabs between the same two lines are joined to a trapezoid, but not across stations
    ends_here = np.zeros(len(cuts), dtype=bool)
    ends_here[cuts.searchsorted(stations, side="right") - 1] = True
    along = np.lexsort((slab, above, below))
    below, above, slab = below[along], above[along], slab[along]
    continues = (np.diff(below) == 0) & (np.diff(above) == 0) & (np.diff(slab) == 1) & ~ends_here[slab[1:]]
    begin = np.flatnonzero(np.append(True, ~continues))
    end = np.append(begin[1:], len(slab)) - 1
    below, above, x = below[begin], above[begin], np.stack([cuts[slab[begin]], cuts[slab[end] + 1]], axis=1)
    heights = (left[k, 1:] + slope[k, None] * (x - left[k, :1]) for k in (below, above))
    return np.stack([x, *heights], axis=-1)


def _polygon_of(loop: Path, step: float, *, divide_lines: bool = False) -> FloatArray:
    """Return points (n, 2) of a polygon in place of a loop, about `step` apart on curves, if requested on lines."""
    # at least 4 sides replace an arc or spline, or 96 if this curve is a whole loop
    fewest, rows = 96 if len(loop.segments) == 1 else 4, []
    for segment in loop.segments:
        # the chord is a rough length of an arc or spline
        parts = ceil(dist(segment.start, segment.end) / step)
        if isinstance(segment, Line):
            parts = parts if divide_lines else 1
        else:
            parts = max(fewest, parts)
        rows.append(segment.at(np.linspace(0.0, 1.0, parts, endpoint=False)))
    return np.concatenate(rows)


def holder_patches(holders: Sequence[Holder], size: float) -> Iterator[tuple[FloatArray, Color]]:
    """Yield patches (n, 4, 3), at most `size` mm large, and the unshaded colour of each body of the holders.

    Slots are left out, because tabs fill them.
    """
    for holder in single_holders(holders):
        if isinstance(holder, EndFixture):
            for prism in holder.solid.added:
                yield _patches(prism, (prism.outline, *prism.holes), size), FIXTURE_COLOR
        else:
            solid, slots = holder.solid, 0 if isinstance(holder, Rib) else len(holder.slots)
            loops = (solid.outline, *solid.holes[slots:])
            yield _patches(solid, loops, size), sheet_color(holder.sheet)


def _patches(solid: FlatSolid, loops: Sequence[Path], size: float) -> FloatArray:
    """Return the faces of a flat solid as quadrilaterals (n, 4, 3), at most about `size` wide and high."""
    low, high = loops[0].bounds
    stations = np.linspace(low[0], high[0], int(np.ceil((high[0] - low[0]) / size)) + 1)
    flat = [part for slab in trapezoids(loops, stations, size) for part in _split(slab, size)]
    corners = np.array([[(a[0], a[1]), (b[0], b[1]), (b[0], b[2]), (a[0], a[2])] for a, b in flat])
    faces = solid.frame, solid.frame.shifted(z=solid.thickness)
    parts = [face.point(corners) for face in faces]
    for loop in loops:
        under, over = (face.point(_polygon_of(loop, size, divide_lines=True)) for face in faces)
        parts.append(np.stack([under, np.roll(under, -1, axis=0), np.roll(over, -1, axis=0), over], axis=1))
    return np.concatenate(parts)


def _split(slab: FloatArray, size: float) -> Iterator[FloatArray]:
    """Divide a trapezoid into parts at most `size` mm high. Its two parallel sides are rows x, lower y, upper y."""
    count = max(1, int(np.ceil((slab[:, 2] - slab[:, 1]).max() / size)))
    heights = slab[:, 1:2] + (slab[:, 2:] - slab[:, 1:2]) * np.linspace(0.0, 1.0, count + 1)
    for low, high in pairwise(heights.T):
        yield np.column_stack([slab[:, 0], low, high])


NAME_SPACE = 0.045
"""Space for the name of a flat part as a fraction of the longest part."""

LIGHT = np.array([0.35, -0.45, 0.82])
"""Direction to the light: above, to the left and in front."""


EDGE_MM = 0.5
"""Largest distance, mm, between outlines and the polylines drawn for them."""


def assembled_box(strips: Sequence[tuple[Strip, FloatArray]], holders: Sequence[Holder]) -> FloatArray:
    """Return the smallest and largest coordinates (2, 3), mm, of an assembled model.

    The strips, with the patches (n, 4, 3) of their middle surfaces, are measured with their thickness.
    """
    corners = list[FloatArray]()
    for strip, patches in strips:
        tapered = [float(size.extremes[1]) for size in strip.tapered.values()]
        half = max([strip_thickness(strip), *tapered]) / 2 * _normals_of(patches)[:, None]
        corners += [(patches - half).reshape(-1, 3), (patches + half).reshape(-1, 3)]
    for holder in single_holders(holders):
        for solid in holder.solid.added if isinstance(holder, EndFixture) else (holder.solid,):
            points = solid.outline.points(EDGE_MM)
            corners += [solid.frame.shifted(z=height).point(points) for height in (0.0, solid.thickness)]
    return box_about(np.concatenate(corners))


def size_text(size: FloatArray) -> str:
    """Return lengths in whole millimetres, joined as in "322 x 322 x 345"."""
    return " x ".join(f"{length:.0f}" for length in size)


def model(
    model: Model,
    *,
    holders: Sequence[Holder] = (),
    elevation: float = 25.0,
    azimuth: float = -60.0,
    flat: int = 0,
) -> Figure:
    """Draw the bent strips of a model in the colours of their sheets. `elevation` and `azimuth` are in degrees.

    Strips have their tabs, slots and holes. Of a laminate, only the base is drawn. `holders` are drawn in
    addition to the plates of the model. Plates have their holes but no slots. `flat` is the number of different
    flat parts that are drawn below at a common scale, including the first and the last part.
    """
    require_model(model)
    if not (is_whole(flat) and flat >= 0):
        raise InputError(f"flat (number of flat parts to draw) is {flat!r}. Use a whole number, 0 for none.")
    held_by = (*model.plates, *several("holders", holders, Holder, HOLDERS))
    plates = (holder for holder in single_holders(held_by) if isinstance(holder, BasePlate))
    faces = [plate.frame.shifted(z=z) for plate in plates for z in (0.0, -plate.sheet.thickness)]
    bent = np.concatenate([member.frame.point(member.strip.rod.position) for member in model.placed])
    size = float(np.ptp(bent, axis=0).max())
    strips = [rule_strip(placed, 0.0015 * size, faces) for placed in model.placed]
    # the depth of a small patch hardly varies, so the depth of its middle decides the order
    holding = ((part, lit(part) * color) for part, color in holder_patches(held_by, 0.02 * size))
    patches, colors = map(np.concatenate, zip(*strips, *holding, strict=True))
    drawn = [(placed.strip, part) for placed, (part, _) in zip(model.placed, strips, strict=True)]
    extent = np.ptp(assembled_box(drawn, held_by), axis=0)
    title = f"{fill(model.name, 90)}\n{counted(len(model.placed), 'strip')}"
    chosen = np.unique(np.linspace(0, len(model.parts) - 1, flat).round().astype(int))
    shown = [model.parts[i] for i in chosen]
    return _figure(patches, colors, title, extent, elevation, azimuth, shown, faces)


def bodies(
    meshes: Sequence[tuple[ArrayLike, ArrayLike, tuple[float, float, float]]],
    *,
    title: str = "",
    elevation: float = 25.0,
    azimuth: float = -60.0,
) -> Figure:
    """Draw closed triangle meshes in space. CAD kernels return such meshes from `tessellate`.

    Parameters
    ----------
    meshes : sequence of (vertices (n, 3), triangles (m, 3), color)
        Vertices, mm. Triangles are three indices of vertices, anticlockwise seen from outside. A color is red,
        green and blue, from 0 to 1.
    title : str
    elevation, azimuth : float
        Direction of the viewer, degrees.
    """
    patches, colors = [], []
    if not is_series(meshes) or not all(is_series(mesh) and len(tuple(mesh)) == 3 for mesh in meshes):
        raise InputError("The meshes cannot be read. Pass a list of (vertices, triangles, color).")
    for vertices, triangles, color in meshes:
        points, rows = numbers(vertices, "vertices"), numbers(triangles, "triangles").astype(int)
        if points.ndim != 2 or points.shape[1] != 3 or rows.ndim != 2 or rows.shape[1] != 3:
            raise InputError(
                "A mesh cannot be read. Pass vertices (n, 3) in mm and triangles (m, 3) of row numbers."
            )
        patches.append(points[rows])
        colors.append(np.tile(np.asarray(color, dtype=float), (len(rows), 1)))
    if not patches:
        raise InputError("There is nothing to draw. Pass at least one mesh.")
    corners, tints = np.concatenate(patches), np.concatenate(colors)
    outward = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    faced = outward @ look_from(elevation, azimuth) > 0
    longest = float(np.ptp(corners.reshape(-1, 3), axis=0).max()) / 60
    corners, tints = _fine(corners[faced], tints[faced], longest)
    extent = np.ptp(corners.reshape(-1, 3), axis=0)
    return _figure(corners, lit(corners) * tints, title, extent, elevation, azimuth)


def _figure(
    patches: FloatArray,
    colors: FloatArray,
    title: str,
    extent: FloatArray,
    elevation: float,
    azimuth: float,
    flat: Sequence[EqualStrips] = (),
    faces: Sequence[Frame] = (),
) -> Figure:
    """Paint patches (n, k, 3) from the farthest to the nearest, and flat parts below them at a common scale.

    Patches in front of a plate's face are painted after patches behind the face. If patches were sorted only
    by depth, tabs would have ragged edges in their slots.
    """
    toward = look_from(elevation, azimuth)
    plane = patches @ screen_of(elevation, azimuth)
    middle = patches.mean(axis=1)
    # for each face: patches behind it (-1), on it (0), in front of it (1)
    # heights are rounded, so that a patch on the face has the height 0
    sides = [
        np.sign(np.round((middle - face.origin) @ face.z_axis, 6)) * np.sign(face.z_axis @ toward)
        for face in faces
    ]
    # the last key counts first: sides of faces before depth
    order = np.lexsort([middle @ toward, *sides])
    size = np.maximum(np.ptp(plane.reshape(-1, 2), axis=0), 1e-9)
    tall = float(np.clip(WIDTH_INCHES * size[1] / size[0], 2.0, 6.0 if flat else 9.0))
    panels, headed = [Panel(tall)], f"{title}, {size_text(extent)} mm" if title else f"{size_text(extent)} mm"
    if flat:
        lengths, widths = np.transpose([np.ptp(part.strip.outline.bounds, axis=0) for part in flat])
        longest = float(lengths.max())
        tall = float(widths.sum()) + NAME_SPACE * longest * len(flat)
        panels.append(Panel(WIDTH_INCHES * tall / (1.04 * longest)))
    figure, (axes, *lower) = new_page(panels, headed)
    for below in lower:
        _draw_flats(below, flat, longest)
    paint_patches(axes, plane[order], colors[order])
    axes.autoscale_view()
    hide_axes(axes)
    return figure


def _draw_flats(axes: Axes, parts: Sequence[EqualStrips], longest: float) -> None:
    """Draw the flat strips below each other with their names and sizes.

    `longest` is the length of the longest, mm.
    """
    y = 0.0
    for part in parts:
        strip = part.strip
        (left, bottom), (right, top) = strip.outline.bounds
        y -= NAME_SPACE * longest
        sheets = " on ".join(layer.sheet.name for layer in reversed(strip.layers))
        times = "" if part.count == 1 else f", {part.count} times"
        text = f"{part.name}{times}: {right - left:.0f} by {top - bottom:.0f} mm, {sheets}"
        axes.text(0.0, y + 0.2 * NAME_SPACE * longest, text, fontsize=9, color=INK, va="bottom")
        paint_flat(axes, strip, (-left, y - top))
        y -= top - bottom
    show_box(axes, (-0.02 * longest, y - 0.005 * longest), (1.02 * longest, 0.0))
    hide_axes(axes)


def look_from(elevation: float, azimuth: float) -> FloatArray:
    """Return the unit vector (3,) from the scene to the eye for angles in degrees."""
    e, a = np.radians(
        [require_number(elevation, "elevation", "degrees"), require_number(azimuth, "azimuth", "degrees")]
    )
    return np.array([np.cos(e) * np.cos(a), np.cos(e) * np.sin(a), np.sin(e)])


def screen_of(elevation: float, azimuth: float) -> FloatArray:
    """Return unit vectors to the right and upwards in the picture, as columns (3, 2), for angles in degrees."""
    right = np.array([-np.sin(np.radians(azimuth)), np.cos(np.radians(azimuth)), 0.0])
    return np.column_stack([right, np.cross(look_from(elevation, azimuth), right)])


def lit(patches: FloatArray) -> FloatArray:
    """Return the brightness (n, 1) of patches from their angle to the light.

    Both sides are equally bright.
    """
    return np.asarray(0.6 + 0.4 * np.abs(_normals_of(patches) @ LIGHT)[:, None], dtype=float)


def _normals_of(patches: FloatArray) -> FloatArray:
    """Return the unit normals (n, 3) of patches (n, 3 or 4, 3)."""
    normal = np.cross(patches[:, 2] - patches[:, 0], patches[:, -1] - patches[:, 1])
    return np.asarray(normal / np.maximum(np.linalg.norm(normal, axis=1), 1e-300)[:, None])


def _fine(triangles: FloatArray, colors: FloatArray, longest: float) -> tuple[FloatArray, FloatArray]:
    """Return triangles whose sides are at most `longest`, divided at the middle of their longest side."""
    while True:
        edges = np.linalg.norm(np.roll(triangles, -1, axis=1) - triangles, axis=2)
        large = edges.max(axis=1) > longest
        if not large.any():
            return triangles, colors
        # start each triangle a, b, c at its longest side
        turn = (edges[large].argmax(axis=1)[:, None] + np.arange(3)) % 3
        a, b, c = np.moveaxis(np.take_along_axis(triangles[large], turn[..., None], axis=1), 1, 0)
        middle = (a + b) / 2
        halves = [np.stack([a, middle, c], axis=1), np.stack([middle, b, c], axis=1)]
        triangles = np.concatenate([triangles[~large], *halves])
        colors = np.concatenate([colors[~large], colors[large], colors[large]])


def rule_strip(
    placed: Placed, rim_most: float = np.inf, faces: Sequence[Frame] = ()
) -> tuple[FloatArray, FloatArray]:
    """Return patches (n, 4, 3) of a strip in space, with tabs, slots, holes and dark rims, and colours (n, 3).

    Rims are at most `rim_most` mm wide. Patches are split where the strip crosses one of the `faces`.
    """
    strip = placed.strip
    rod = strip.rod
    (first, low), (last, high) = strip.outline.bounds
    # arc lengths; tabs are outside 0..length
    x = np.unique([first, *rod.s, last])
    stations = [np.linspace(0.0, rod.length, 81)]
    for face in faces:
        height = (placed.frame.point(_bent(rod, x)) - face.origin) @ face.z_axis
        stations.append(at_sign_changes(height, x))
    # for both sides of a trapezoid: x, lower y and upper y
    flat = trapezoids((strip.outline, *strip.holes), np.concatenate(stations), (last - first) / 40)
    across = np.diff(flat[..., 1:], axis=-1)
    # width (n, 2, 1) of the dark line along edges
    rim = np.minimum(min(0.035 * (high - low), rim_most), across / 4)
    heights = [flat[..., 1:2], flat[..., 1:2] + rim, flat[..., 2:] - rim, flat[..., 2:]]
    along = _bent(rod, flat[..., 0])
    # four lines in space across each trapezoid, from bottom to top, bound three bands: rim, middle, rim
    lines = [placed.frame.point(np.concatenate([along, y], axis=-1)) for y in heights]
    bands = [np.stack([a[:, 0], a[:, 1], b[:, 1], b[:, 0]], axis=1) for a, b in pairwise(lines)]
    shade = lit(bands[1]) * np.array((placed.color or sheet_color(strip.sheet))[:3])
    return np.concatenate(bands), np.concatenate([0.45 * shade, shade, 0.45 * shade])


def _bent(rod: Rod, x: FloatArray) -> FloatArray:
    # points (..., 2) of the bent centre line at arc lengths x; the tabs beyond the ends are straight
    inside = np.clip(x, 0.0, rod.length)
    points = np.stack([np.interp(inside, rod.s, column) for column in rod.position.T], axis=-1)
    angle = np.where(x < 0, rod.angle[0], rod.angle[-1])
    return points + (x - inside)[..., None] * unit_vectors(angle)
