"""Writer of drawings as DXF files: R2000 to R2018 with ezdxf, R12 without a library."""

import io
import logging
import re
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from importlib import import_module
from math import degrees, pi
from textwrap import wrap
from threading import Lock
from typing import Any, Literal, TypeAlias, get_args

from elastica_cad._text import MADE_BY
from elastica_cad._types import FloatArray
from elastica_cad._values import require_record
from elastica_cad.errors import InputError, missing_library
from elastica_cad.formats.drawing_style import (
    LayerChoice,
    LayerStyle,
    check_curve_style,
    shape_paths,
    style_layers,
)
from elastica_cad.geometry.path import Arc, Path, Segment, Spline, trim_segment
from elastica_cad.strip.drawing import SHEET, Drawing

DxfVersion: TypeAlias = Literal["R12", "R2000", "R2004", "R2007", "R2010", "R2013", "R2018"]
DXF_VERSIONS: tuple[DxfVersion, ...] = get_args(DxfVersion)

# flag bits of a SPLINE
_CLOSED, _RATIONAL, _PLANAR = 1, 4, 8
_OPTIONS = Lock()

_COLOR_NUMBERS = {
    1: (255, 0, 0), 2: (255, 255, 0), 3: (0, 255, 0), 4: (0, 255, 255), 5: (0, 0, 255), 6: (255, 0, 255),
    7: (0, 0, 0), 8: (128, 128, 128), 9: (192, 192, 192), 30: (255, 127, 0), 140: (0, 191, 255), 200: (191, 0, 255),
}  # fmt: skip
"""Some of AutoCAD's colour numbers; 7 is black on white paper and white on a black screen."""


def encode_dxf(
    drawing: Drawing,
    *,
    curves: str = "spline",
    tolerance: float = 0.02,
    version: str = "R2010",
    layers: Mapping[str, LayerChoice] | str | None = None,
) -> bytes:
    """Return the bytes of a DXF file in mm. Equal drawings give equal bytes.

    A loop of lines and arcs is a closed polyline, or a CIRCLE. A loop that is a single spline is a closed
    SPLINE. A loop with splines and other segments is a GROUP of LINE, ARC and SPLINE in order, whose ends
    meet. With `curves` "arc" or "polyline", such a loop is a closed LWPOLYLINE; in R12, it is a closed POLYLINE.
    Entities are written in the order of machining: engraving, marks, inner cuts, outer cuts.

    Parameters
    ----------
    drawing : Drawing
    curves : str
        "spline" writes splines up to degree 3 exactly. Higher degrees become cubics, within the tolerance and
        within 0.001 mm. "bezier" writes splines with Bezier knots, which more programs read exactly. "exact"
        writes splines of all degrees unchanged. "arc" writes splines as tangent arcs. "polyline" writes
        splines and arcs as lines. R12 has no splines, so the first three mean "arc".
    tolerance : float
        Largest distance, mm, between a curve and its replacement.
    version : str
        One of `DXF_VERSIONS`. R12 is written without ezdxf; its header has no units, so a comment states mm.
    layers : mapping, optional
        Names and colours, see `style_layers`.

    Raises
    ------
    MissingDependencyError
        ezdxf is not installed.
    """
    curves = check_curve_style(curves)
    require_record(drawing, Drawing, "what is written", "a Drawing record")
    if not isinstance(version, str) or version not in DXF_VERSIONS:
        raise InputError(
            "{version!r} is not a supported DXF version: use one of {dxf_versions}",
            version=version,
            dxf_versions=", ".join(DXF_VERSIONS),
        )
    styles = style_layers(layers)
    old = version == "R12"
    if old:
        for style in styles.values():
            if not re.fullmatch(r"[A-Za-z0-9_$-]{1,31}", style.name):
                raise InputError(
                    "DXF R12 does not allow the layer name {name!r}: use up to 31 letters, digits, $, - and _",
                    name=style.name,
                )
        curves = "polyline" if curves == "polyline" else "arc"
    shown = {layer: styles[layer] for layer in drawing.layers}
    strokes = drawing.strokes
    shaped = shape_paths([stroke.path for stroke in strokes], curves, tolerance)
    named = [(styles[stroke.layer].name, path) for stroke, path in zip(strokes, shaped, strict=True)]
    if old:
        return _r12(named, shown, drawing.bounds)
    return _through_ezdxf(named, shown, drawing.bounds, version)


def _made_by() -> list[str]:
    """Return the running command as comment lines of at most 250 characters, because old readers allow 255."""
    return wrap(MADE_BY.get(), 250)


def _through_ezdxf(
    paths: Sequence[tuple[str, Path]], styles: Mapping[str, LayerStyle], bounds: FloatArray, version: str
) -> bytes:
    """Return the bytes of a DXF file of R2000 or later. The segments of a path are a group."""
    with _plain_ezdxf() as ezdxf:
        document = ezdxf.new(version, setup=False, units=ezdxf.units.MM)
        for layer, style in styles.items():
            row = document.layers.add(style.name, color=_nearest_color_number(style.rgb))
            row.rgb = style.rgb
            # the border of a sheet is visible, but not cut
            row.dxf.plot = int(layer != SHEET)
        space, groups = document.modelspace(), document.rootdict["ACAD_GROUP"]
        for layer, path in paths:
            entities = [*_entities(space, path, {"layer": layer})]
            if len(entities) > 1:
                # `document.groups.new` is slow, because it compares each name with all others
                group = document.objects.add_dxf_object_with_reactor("GROUP", {"owner": groups.dxf.handle})
                groups.add(f"LOOP_{len(groups) + 1}", group)
                group.set_data(entities)
        (left, low), (right, high) = bounds.tolist()
        space.reset_extents((left, low, 0.0), (right, high, 0.0))
        document.header["$EXTMIN"], document.header["$EXTMAX"] = (left, low, 0.0), (right, high, 0.0)
        # height of the view, with a margin, in a window about twice as wide as high
        height = 1.1 * max(high - low, (right - left) / 2)
        document.set_modelspace_vport(height, ((left + right) / 2, (low + high) / 2))
        # ezdxf stores the classes of a version in a set, so their order differs between runs
        document.classes.add_required_classes(document.dxfversion)
        document.classes.classes = dict(sorted(document.classes.classes.items()))
        stream = io.StringIO("".join(f"999\n{line}\n" for line in _made_by()))
        stream.seek(0, io.SEEK_END)
        document.write(stream)
        return bytes(document.encode(stream.getvalue()))


def _entities(space: Any, path: Path, on: dict[str, Any]) -> Iterator[Any]:
    """Add the entities of a path to the model space, and yield them: a circle, a polyline, or each segment."""
    if circle := _circle(path):
        yield space.add_circle(circle.center, circle.radius, on)
    elif not path.has_splines:
        polyline = space.add_lwpolyline((), close=path.closed, dxfattribs=on)
        # all vertices at once, because `add_lwpolyline` copies the earlier vertices for each of them
        polyline.lwpoints.extend([(x, y, 0.0, 0.0, bulge) for x, y, bulge in _vertices_with_bulges(path)])
        yield polyline
    else:
        for segment in path.segments:
            if isinstance(segment, Spline):
                curve, alone = segment.curve, path.closed and len(path.segments) == 1
                spline = space.add_spline(degree=curve.degree, dxfattribs=on)
                spline.control_points, spline.knots = curve.control_points, curve.knots
                spline.weights = () if curve.weights is None else curve.weights
                rational = 0 if curve.weights is None else _RATIONAL
                spline.dxf.flags = _PLANAR | rational | (_CLOSED if alone else 0)
                yield spline
            elif isinstance(segment, Arc):
                yield space.add_arc(segment.center, segment.radius, *_angles(segment), dxfattribs=on)
            else:
                yield space.add_line(segment.start, segment.end, on)


@contextmanager
def _plain_ezdxf() -> Iterator[Any]:
    """Import ezdxf without time stamps, random identifiers and log, which would make files irreproducible."""
    try:
        ezdxf = import_module("ezdxf")
    except ImportError:
        raise missing_library("writing DXF needs ezdxf", "ezdxf") from None
    logger = logging.getLogger("ezdxf")
    with _OPTIONS:
        before, level = ezdxf.options.write_fixed_meta_data_for_testing, logger.level
        ezdxf.options.write_fixed_meta_data_for_testing = True
        logger.setLevel(logging.ERROR)
        try:
            yield ezdxf
        finally:
            ezdxf.options.write_fixed_meta_data_for_testing = before
            logger.setLevel(level)


def _r12(paths: Sequence[tuple[str, Path]], styles: Mapping[str, LayerStyle], bounds: FloatArray) -> bytes:
    """Return the bytes of a DXF R12 file, which has no $INSUNITS; a comment states the unit."""
    # group code and value; 999 is a comment
    tags: list[tuple[int, object]] = [(999, line) for line in ("all lengths in mm", *_made_by())]
    tags += [(0, "SECTION"), (2, "HEADER"), (9, "$ACADVER"), (1, "AC1009")]
    for name, corner in zip(("$EXTMIN", "$EXTMAX"), bounds.tolist(), strict=True):
        tags += [(9, name), *_at(10, corner)]
    tags += [(0, "ENDSEC"), (0, "SECTION"), (2, "TABLES"), (0, "TABLE"), (2, "LAYER"), (70, len(styles))]
    for style in styles.values():
        tags += [
            (0, "LAYER"),
            (2, style.name),
            (70, 0),
            (62, _nearest_color_number(style.rgb)),
            (6, "CONTINUOUS"),
        ]
    tags += [(0, "ENDTAB"), (0, "ENDSEC"), (0, "SECTION"), (2, "ENTITIES")]
    for layer, path in paths:
        tags += _r12_entities(path, (8, layer))
    tags += [(0, "ENDSEC"), (0, "EOF")]
    return "".join(f"{code:>3}\n{value}\n" for code, value in tags).encode("ascii", "replace")


def _r12_entities(path: Path, layer: tuple[int, object]) -> Iterator[tuple[int, object]]:
    """Yield the tags of a path: a circle, or a polyline whose arcs are bulges."""
    if circle := _circle(path):
        yield from ((0, "CIRCLE"), layer, *_at(10, circle.center), (40, float(circle.radius)))
    else:
        yield from ((0, "POLYLINE"), layer, (66, 1), *_at(10, (0.0, 0.0)), (70, int(path.closed)))
        for x, y, bulge in _vertices_with_bulges(path):
            yield from ((0, "VERTEX"), layer, *_at(10, (x, y)), (42, bulge))
        yield from ((0, "SEQEND"), layer)


def _at(code: int, point: FloatArray | Sequence[float]) -> list[tuple[int, object]]:
    # tags of a point: the group codes of y and z are those of x plus 10 and 20
    x, y = point
    return [(code, float(x)), (code + 10, float(y)), (code + 20, 0.0)]


def _circle(path: Path) -> Arc | None:
    first = path.segments[0]
    return first if len(path.segments) == 1 and isinstance(first, Arc) and first.is_circle else None


def _angles(arc: Arc) -> tuple[float, float]:
    """Return the start and end angle, degrees, of the arc in anticlockwise direction."""
    first, last = sorted((degrees(arc.start_angle), degrees(arc.end_angle)))
    return first, last


def _vertices_with_bulges(path: Path) -> list[tuple[float, float, float]]:
    # x and y of each vertex, and the bulge of the side after it
    segments = [piece for segment in path.segments for piece in _up_to_half_turns(segment)]
    rows = [(*part.start.tolist(), float(part.bulge) if isinstance(part, Arc) else 0.0) for part in segments]
    return rows if path.closed else [*rows, (*path.end.tolist(), 0.0)]


def _up_to_half_turns(segment: Segment) -> list[Segment]:
    """Return the segment; an arc of more than 180 degrees is halved, because its bulge would be large."""
    if isinstance(segment, Arc) and abs(segment.sweep) > pi * (1 + 1e-9):
        return [trim_segment(segment, 0.0, 0.5), trim_segment(segment, 0.5, 1.0)]
    return [segment]


def _nearest_color_number(rgb: tuple[int, int, int]) -> int:
    return min(
        _COLOR_NUMBERS,
        key=lambda ink: sum((a - b) ** 2 for a, b in zip(_COLOR_NUMBERS[ink], rgb, strict=True)),
    )
