"""Reader of curves in DXF files: arcs and splines without approximation, and the unit, stated or assumed."""

import re
import struct
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Set
from contextlib import suppress
from dataclasses import replace
from itertools import islice
from math import prod, radians
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._units import look_up_unit
from elastica_cad.errors import InputError, missing_library, note, quoted
from elastica_cad.formats.drawn_file import DrawnFile, ReadUnit, collect_curves
from elastica_cad.formats.edges import Edge, Run, Source
from elastica_cad.formats.placed_curve import flatten_run
from elastica_cad.formats.source_file import (
    MOST_SHAPES,
    UNIT,
    check_count,
    check_degree,
    check_places,
    half_last_place,
    quiet_log,
)
from elastica_cad.geometry.measured_points import Provenance

if TYPE_CHECKING:
    from ezdxf.document import Drawing


# largest depth of nested blocks; deeper nesting is an error or an attack
DEEPEST_BLOCK = 20

ODDITIES = (ValueError, TypeError, LookupError, AttributeError, ArithmeticError, AssertionError)
"""Exceptions that ezdxf raises for truncated or corrupt entities."""

MODEL_SPACE = np.eye(4)

_CURVES = {"LINE", "ARC", "CIRCLE", "ELLIPSE", "SPLINE", "HELIX", "LWPOLYLINE", "POLYLINE"}

_PLACES = re.compile(rb"^[ \t]*(?:1[0-8]|2[0-8]|40)[ \t]*\r?\n[ \t]*([-+0-9.eE]+)[ \t]*\r?$", re.MULTILINE)
_UNDECODED = re.compile("[\udc80-\udcff]")
_SECTION = re.compile(rb"^[ \t]*2[ \t]*\r?\n[ \t]*(BLOCKS|ENTITIES)[ \t]*\r?$", re.MULTILINE)


def _dxf_rounding(path: Path) -> float:
    """Return half a unit of the last decimal of the coordinates, or 0 without coordinates.

    Coordinates have the group codes 10 to 28 and 40.
    """
    data = path.read_bytes()
    if data.startswith(b"AutoCAD Binary DXF"):
        return 0.0
    begins = [section.end() for section in _SECTION.finditer(data)]
    ends = [data.find(b"ENDSEC", begin) for begin in begins]
    spans = [(begin, len(data) if end < 0 else end) for begin, end in zip(begins, ends, strict=True)]
    numbers = (
        match[1].decode("ascii") for span in reversed(spans) for match in _PLACES.finditer(data, *span)
    )
    return half_last_place(islice(numbers, 20_000))  # more would be slow


def _check_depth(depth: int) -> None:
    if depth > DEEPEST_BLOCK:
        raise InputError(
            "blocks are nested more than {deepest_block} deep: explode them before export",
            deepest_block=DEEPEST_BLOCK,
        )


def _count(document: "Drawing", layout: Any, known: dict[str, int], depth: int) -> int:
    """Return the number of entities of a layout with expanded blocks, at most 10^9.

    `known` has the numbers of the blocks counted so far, by name.
    """
    _check_depth(depth)
    from ezdxf.lldxf.const import DXFError

    total = 0
    for entity in layout:
        if entity.dxftype() != "INSERT":
            total += 1
            continue
        name = str(entity.dxf.get("name", "")) if entity.dxf.is_supported("name") else ""
        if name not in known:
            block = document.blocks.get(name)
            known[name] = 0 if block is None else _count(document, block, known, depth + 1)
        try:
            times = prod(max(1, int(entity.dxf.get(name, 1))) for name in ("row_count", "column_count"))
        except (*ODDITIES, DXFError):
            times = 1
        total = min(total + times * max(1, known[name]), 10**9)
    return total


_INSUNITS = {
    0: 1.0, 1: 25.4, 2: 304.8, 3: 1609344.0, 4: 1.0, 5: 10.0, 6: 1000.0, 7: 1e6, 8: 25.4e-6, 9: 0.0254, 10: 914.4,
    11: 1e-7, 12: 1e-6, 13: 1e-3, 14: 100.0, 15: 1e4, 16: 1e5, 17: 1e12, 21: 1.2e6 / 3937,
}  # fmt: skip
"""Millimetres in each unit number of $INSUNITS; 0 is "no unit"."""

_NAMES = {1: "in", 2: "ft", 4: "mm", 5: "cm", 6: "m"}
"""Names of the usual units, by their numbers in $INSUNITS."""


def read_dxf_drawing(
    file: Path, *, tolerance: float, fit_tolerance: float, unit: str | None, corners: bool = True
) -> DrawnFile:
    """Read the curves of a DXF file with handles and layers, in mm; the arguments are those of `read_drawing`.

    LINE, ARC, CIRCLE, ELLIPSE, SPLINE and polylines of the model space are read, including those in blocks.
    Arcs and splines are read exactly, and a curve is fitted to a polyline without arcs. The unit is the
    file's $INSUNITS. Without $INSUNITS the unit is mm, or inches if $MEASUREMENT is 0 and the curves are
    smaller than 40 units; the report states this.

    Raises
    ------
    MissingDependencyError
        ezdxf is not installed.
    """
    document = _opened(file)
    check_count(
        _count(document, document.modelspace(), {}, 0),
        MOST_SHAPES,
        "entities, including those of its blocks",
        "leave out blocks, or explode one of them",
    )
    scale, known = (look_up_unit(unit), ReadUnit.requested(unit)) if unit else _unit_of(document, file)
    rounding = scale * _dxf_rounding(file)
    skipped = Counter(
        f"on paper layout {layout.name}"
        for layout in document.layouts
        for entity in layout
        if layout.is_any_paperspace and entity.dxftype() in _CURVES
    )
    shown = Provenance(
        place=np.diag([1 / scale, 1 / scale, 1.0]), unit="mm" if scale == 1 else "drawing units"
    )
    # `check_places` refuses values that overflow
    with np.errstate(over="ignore", invalid="ignore"):
        drawn = collect_curves(
            file, _runs(document, scale, rounding, skipped), skipped, tolerance=tolerance, flat=flatten_run,
            nothing="has no curve in its model space: draw a SPLINE, ARC, ELLIPSE, LINE or polyline there",
            fit_tolerance=fit_tolerance, shown=shown, corners=corners,
        )  # fmt: skip
    return replace(drawn, unit=known)


def _runs(document: "Drawing", scale: float, rounding: float, skipped: Counter[str]) -> Iterator[Run]:
    """Yield the edges, mm, of every curve. Other and unreadable entities are counted in `skipped`."""
    from ezdxf.lldxf.const import DXFError

    bad: list[InputError] = []
    good = 0
    frozen = {str(layer.dxf.name).lower() for layer in document.layers if layer.is_frozen()}
    off = {str(layer.dxf.name).lower() for layer in document.layers if layer.is_off()}
    # a block is hidden if its layer is frozen, but not if its layer is off
    hidden = {True: frozen, False: frozen | off}
    for entity, placement, layer in _entities(document.modelspace(), 0, skipped, hidden):
        kind = entity.dxftype()
        try:
            run = _run(entity)
            if run is None:
                skipped[kind] += 1
                continue
            handle = str(entity.dxf.get("handle") or "")
            linear, offset = scale * placement[:3, :3], scale * placement[:3, 3]
            digit = rounding * float(np.linalg.norm(placement[:3, :3], axis=0).max())
            source = Source(f"{kind} {handle}".rstrip(), _decoded_name(layer), digit, handle)
            mapped = tuple(edge.mapped(linear, offset, source) for edge in run)
            for edge in mapped:
                check_places(edge.points)
        except InputError as error:
            bad.append(error)
            skipped[f"{kind} that cannot be read ({error})"] += 1
            continue
        except (*ODDITIES, DXFError):
            bad.append(InputError("has a {thing} that is incomplete or invalid: draw it again", thing=kind))
            skipped[f"{kind} that breaks off or makes no sense"] += 1
            continue
        good += 1
        if any(edge.size for edge in mapped):
            yield mapped
        else:
            skipped[f"{kind} of no length"] += 1
    if bad and not good:
        raise bad[0]


def _decoded_name(name: str) -> str:
    """Return a name in which bytes that are not UTF-8 are decoded as Windows-1252."""
    return (
        name.encode("utf-8", "surrogateescape").decode("cp1252", "replace")
        if _UNDECODED.search(name)
        else name
    )


def _opened(path: Path) -> "Drawing":
    """Return the document, repaired if necessary. Refuse a file in which numbers had to be guessed."""
    try:
        from ezdxf import recover
        from ezdxf.audit import AuditError
        from ezdxf.filemanagement import readfile
        from ezdxf.lldxf.const import DXFError
    except ImportError as error:
        raise missing_library(f"reading {path.name} needs ezdxf", "ezdxf") from error
    with path.open("rb") as opened:
        if re.match(rb"AC10\d\d", opened.read(6)):
            raise InputError("This is a DWG file, not a DXF file. Save the drawing as DXF.")
    # exceptions of ezdxf for truncated or corrupt files
    damage = (*ODDITIES, DXFError, OSError, struct.error, StopIteration)
    with quiet_log("ezdxf"):
        try:
            document = readfile(str(path))
            document.modelspace()
        except damage:
            pass
        else:
            return document
        try:
            document, audit = recover.readfile(str(path))
            document.modelspace()
        except damage as error:
            raise InputError(
                "is not a readable DXF file: export the file again, as DXF R2000 or later"
            ) from error
    guessed = [entry for entry in audit.errors if entry.code == AuditError.INVALID_FLOATING_POINT_VALUE]
    if guessed:
        message = re.sub(
            '"(.*)"(?= near line)', lambda match: quoted(match[1]), guessed[0].message, flags=re.DOTALL
        )
        raise InputError("is damaged ({said}): export the file again", said=message)
    return document


def _unit_of(document: "Drawing", file: Path) -> tuple[float, ReadUnit]:
    """Return the size of the unit, mm, with its source, or with a note if it is assumed."""
    code = _unit_code(document)
    with file.open("rb") as opened:
        if code:
            name = _NAMES.get(code, f"{_INSUNITS[code]:g} mm")
            return _INSUNITS[code], ReadUnit(name, "stated", "$INSUNITS")
        # comment in R12 files of this package, because R12 has no $INSUNITS
        if b"all lengths in mm" in opened.read(200):
            return 1.0, ReadUnit("mm", "stated", "a comment")
    unit, other, reason = "mm", "in", note("the file has no unit ($INSUNITS)")
    if document.header.get("$MEASUREMENT") == 0:
        with np.errstate(over="ignore", invalid="ignore"), suppress(InputError):
            points = [edge.points for run in _runs(document, 1.0, 0.0, Counter()) for edge in run]
            size = float(np.ptp(np.concatenate(points), axis=0).max()) if points else 0.0
            # in mm, the drawing would be smaller than any strip
            if 0 < size < 40:
                unit, other = "in", "mm"
                reason = note(
                    "the file has no unit, $MEASUREMENT = 0 means inches, and a size of {size:.3g} inches is "
                    "likely",
                    size=size,
                )
    assumed = note(
        "its unit is assumed to be {unit}, because {reason}; if that is wrong, set {field} to the right unit, "
        "such as {other}",
        field=UNIT, unit=unit, reason=reason, other=other,
    )  # fmt: skip
    return look_up_unit(unit), ReadUnit(unit, note=assumed)


def _unit_code(document: "Drawing") -> int:
    """Return the code of the unit, $INSUNITS; 0 means none."""
    try:
        code = int(document.header.get("$INSUNITS", 0))
    except (TypeError, ValueError, OverflowError):
        code = -1
    if code not in _INSUNITS:
        raise InputError(
            "has an unknown unit ($INSUNITS = {given}): set the unit ({field})",
            field=UNIT,
            given=code if -1 < code < 1000 else "no number from 0 to 21",
        )
    return code


def _entities(
    layout: Iterable[Any],
    depth: int,
    skipped: Counter[str],
    hidden: Mapping[bool, Set[str]],
    placement: FloatArray = MODEL_SPACE,
    outer: str = "0",
) -> Iterator[tuple[Any, FloatArray, str]]:
    """Yield the entities of a layout and of its blocks with their placement (4, 4) and layer.

    An entity on layer 0 of a block takes the layer of the insertion. Hidden entities are counted in
    `skipped`; `hidden` has the lower-case names of the layers that hide blocks (True) and other entities (False).
    Placements of nested blocks are matrices, because unequal scales and rotations combine to a
    shear.
    """
    from ezdxf.lldxf.const import DXFError

    for entity in layout:
        layer = str(entity.dxf.get("layer", "0")) if entity.dxf.is_supported("layer") else "0"
        layer = outer if layer == "0" and depth else layer
        is_block = entity.dxftype() == "INSERT"
        is_invisible = entity.dxf.is_supported("invisible") and entity.dxf.get("invisible", 0)
        if is_invisible or layer.lower() in hidden[is_block]:
            skipped[f"hidden on layer {layer}"] += 1
        elif not is_block:
            if not (depth and entity.dxftype() == "ATTDEF"):
                yield entity, placement, layer
        else:
            _check_depth(depth + 1)
            try:
                block = entity.block()
                if block is None:
                    skipped["INSERT of a block that the file does not hold"] += 1
                    continue
                copies = list(entity.multi_insert()) if entity.mcount > 1 else [entity]
                placements = [np.array(list(copy.matrix44().rows())).T for copy in copies]
            except (*ODDITIES, DXFError):
                skipped["INSERT that makes no sense"] += 1
                continue
            for inner in placements:
                yield from _entities(block, depth + 1, skipped, hidden, placement @ inner, layer)


def _run(entity: Any) -> Run | None:
    """Return the edges of an entity in the coordinates of its block, or None if it is not a curve."""
    kind = entity.dxftype()
    if kind == "LINE":
        return (Edge.polyline([entity.dxf.start, entity.dxf.end]),)
    if kind in ("ARC", "CIRCLE"):
        return (_circle(entity, full=kind == "CIRCLE"),)
    if kind == "ELLIPSE":
        angles = _arc_angles(entity.dxf.start_param, entity.dxf.end_param)
        return (Edge.arc(entity.dxf.center, entity.dxf.major_axis, entity.minor_axis, *angles),)
    # a flat HELIX is a spiral in a plane
    if kind == "SPLINE" or (
        kind == "HELIX" and abs(entity.dxf.turns * entity.dxf.turn_height) <= 1e-6 * abs(entity.dxf.radius)
    ):
        return (_spline(entity),)
    if kind == "LWPOLYLINE":
        rows = [(x, y, entity.dxf.elevation, bulge) for x, y, bulge in entity.get_points("xyb")]
        return _polyline(rows, closed=entity.closed, to_world=entity.ocs().to_wcs)
    if kind == "POLYLINE" and (entity.is_2d_polyline or entity.is_3d_polyline):
        vertices = [
            v for v in entity.vertices if not v.dxf.flags & 16
        ]  # flag 16 marks control points, which are not on the curve
        places = [(v.dxf.location, v.dxf.get("bulge", 0.0)) for v in vertices]
        if entity.is_3d_polyline:
            return _polyline([(*p, 0.0) for p, _ in places], closed=entity.is_closed, to_world=np.asarray)
        rows = [(p.x, p.y, entity.dxf.elevation.z, bulge) for p, bulge in places]
        return _polyline(rows, closed=entity.is_closed, to_world=entity.ocs().to_wcs)
    return None


def _circle(entity: Any, *, full: bool) -> Edge:
    to_world, radius = entity.ocs().to_wcs, entity.dxf.radius
    start, end = (0.0, 360.0) if full else (entity.dxf.start_angle, entity.dxf.end_angle)
    x_axis, y_axis = radius * np.array(to_world((1, 0, 0))), radius * np.array(to_world((0, 1, 0)))
    return Edge.arc(to_world(entity.dxf.center), x_axis, y_axis, *_arc_angles(radians(start), radians(end)))


def _arc_angles(start: float, end: float) -> tuple[float, float]:
    # anticlockwise from start to end, rad; equal angles are a full turn
    sweep = (end - start) % (2 * np.pi)
    return start, start + (sweep if sweep > 1e-12 else 2 * np.pi)


def _spline(entity: Any) -> Edge:
    """Return a SPLINE as an edge, also if it is periodic or defined by fit points."""
    if not len(entity.control_points):
        return _spline_through_fit_points(entity)
    points = np.array([tuple(p) for p in entity.control_points], dtype=float)
    weights = np.array(entity.weights, dtype=float) if len(entity.weights) else None
    knots = np.array(entity.knots, dtype=float)
    degree = int(entity.dxf.degree)
    check_degree(degree)
    backwards = np.maximum.accumulate(knots) - knots
    # knots with too few decimals may decrease slightly
    if knots.size and backwards.max() <= 1e-9 * np.ptp(knots):
        knots = knots + backwards
    if weights is not None and len(weights) != len(points):
        # let `Edge` raise the error for a wrong number of weights
        return Edge(knots, points, degree, weights)
    poles = points if weights is None else np.column_stack([points, weights])
    knots, poles = _without_doubled_poles(*_full_period(knots, poles, degree, entity.closed), degree)
    return Edge(knots, poles[:, :3], degree, None if weights is None else poles[:, 3])


def _full_period(
    knots: FloatArray, poles: FloatArray, degree: int, closed: bool
) -> tuple[FloatArray, FloatArray]:
    """Return the full knots and control points of a periodic spline, of which the file stores a single
    period.

    OpenCASCADE writes such files. Control points at the start are repeated at the end. Other splines are
    returned unchanged.
    """
    count = len(poles)
    # multiplicity of the first knot
    first = int(np.count_nonzero(knots == knots[0])) if knots.size else 0
    if not closed or first > degree or count < 2 or knots.size != count + first:
        return knots, poles
    # each knot of the full vector is the knot `place` of the stored period, moved by `turns` periods
    turns, place = np.divmod(np.arange(count + 2 * degree + 1) - degree + first - 1, count)
    return knots[place] + turns * np.ptp(knots), poles[np.arange(count + degree) % count]


def _without_doubled_poles(
    knots: FloatArray, poles: FloatArray, degree: int
) -> tuple[FloatArray, FloatArray]:
    """Remove inner knots of multiplicity degree + 1 at which two control points coincide."""
    if knots.size != len(poles) + degree + 1:
        return knots, poles
    inner = range(degree + 1, len(poles))
    doubled = [i for i in inner if knots[i] == knots[i + degree] and np.array_equal(poles[i - 1], poles[i])]
    return np.delete(knots, doubled), np.delete(poles, doubled, axis=0)


def _spline_through_fit_points(entity: Any) -> Edge:
    """Return the cubic spline through the fit points, with the end tangents of the entity or zero end curvature.

    A closed spline has neither, because it is smooth where it starts and ends.
    """
    if len(entity.fit_points) < 2:
        raise InputError("a SPLINE has neither control points nor fit points: draw the SPLINE again")
    points = np.array([tuple(p) for p in entity.fit_points], dtype=float)
    if entity.closed and len(points) > 2:
        around = points if np.array_equal(points[0], points[-1]) else np.vstack([points, points[:1]])
        return _cubic_spline(around, "periodic")
    # order of the derivative that is given at each end, and its value
    ends = []
    for name in ("start_tangent", "end_tangent"):
        along = np.array(tuple(entity.dxf.get(name) or (0.0, 0.0, 0.0)), dtype=float)
        length = float(np.linalg.norm(along))
        ends.append([(1, along / length) if length > 0 else (2, np.zeros(3))])
    return _cubic_spline(points, ends)


def _cubic_spline(points: FloatArray, ends: Any) -> Edge:
    """Return the cubic spline through points, parametrised by chord lengths. `ends` is scipy's `bc_type`."""
    from scipy.interpolate import make_interp_spline

    chords = np.linalg.norm(np.diff(points, axis=0), axis=1)
    apart = chords > 0
    chords_needed, places = (3, "three") if isinstance(ends, str) else (1, "two")
    if np.count_nonzero(apart) < chords_needed:
        raise InputError(
            "a SPLINE has fewer than {places} different fit points: draw the SPLINE again", places=places
        )
    at = np.append(0.0, np.cumsum(chords[apart]))
    spline = make_interp_spline(at, points[np.append(True, apart)], k=3, bc_type=ends)
    return Edge(spline.t, spline.c, 3)


def _polyline(rows: list[tuple[float, float, float, float]], *, closed: bool, to_world: Any) -> Run:
    """Return a single edge for a polyline without bulges. With bulges, return a line or arc for each side."""
    if closed and len(rows) > 1:
        rows = [*rows, rows[0]]
    if len(rows) < 2:
        return ()
    vertices = np.array([row[:3] for row in rows], dtype=float)
    bulges = np.array([row[3] for row in rows[:-1]], dtype=float)
    if not bulges.any():
        return (Edge.polyline([tuple(to_world(v)) for v in vertices]),)
    edges = []
    for p, q, bulge in zip(vertices[:-1], vertices[1:], bulges, strict=True):
        if not np.any(p != q):
            continue
        edge = _arc_of_bulge(p, q, float(bulge)) if bulge else Edge.polyline([p, q])
        edges.append(replace(edge, points=np.array([tuple(to_world(v)) for v in edge.points])))
    return tuple(edges)


def _arc_of_bulge(p: FloatArray, q: FloatArray, bulge: float) -> Edge:
    """Return the arc from p to q; `bulge` is the tangent of a quarter of the turn, positive to the left."""
    chord = q - p
    left = np.array([-chord[1], chord[0], 0.0])
    sweep = 4 * np.arctan(bulge)
    # the centre of a flat arc is too far away to be computed accurately
    if abs(sweep) <= np.pi / 2:
        middle = (p + q) / 2 - left * np.tan(sweep / 2) / 2
        return replace(Edge.bezier([p, middle, q]), weights=np.array([1.0, np.cos(sweep / 2), 1.0]))
    center = (p + q) / 2 + left * (1 - bulge**2) / (4 * bulge)
    arm = p - center
    return Edge.arc(center, arm, np.array([-arm[1], arm[0], 0.0]), 0.0, sweep)
