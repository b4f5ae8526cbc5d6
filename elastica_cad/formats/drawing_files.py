"""Writers of drawings: SVG files in mm, and DXF or SVG by the suffix of the file name."""

import os
from collections.abc import Callable, Mapping
from pathlib import Path as FilePath

import numpy as np

from elastica_cad._text import MADE_BY, html_text
from elastica_cad._types import FloatArray
from elastica_cad._values import require_flag, require_path, require_positive, require_record
from elastica_cad.defaults import KERF, STROKE
from elastica_cad.errors import InputError
from elastica_cad.formats.drawing_style import (
    EXACT,
    LayerChoice,
    check_curve_style,
    shape_paths,
    style_layers,
)
from elastica_cad.formats.dxf_drawing import encode_dxf
from elastica_cad.formats.write_files import check_target, write_atomically
from elastica_cad.geometry.path import Arc, Line, Path, Segment
from elastica_cad.geometry.plane_points import project
from elastica_cad.strip.drawing import LAYERS, MARK, Drawing, HoldingTabs, add_holding_tabs, compensate_kerf

_DECIMALS, _EXACT_DECIMALS = 6, 12
"""Decimals of coordinates, mm: in a drawing for a machine, and in a curve that is read again.

A curve needs more decimals, because strip widths depend on the second differences of its coordinates."""


def path_data(path: Path, origin: FloatArray, decimals: int = _DECIMALS) -> str:
    """Return the d attribute of a path of lines, arcs and clamped polynomial splines of degree 2 and 3.

    Parameters
    ----------
    path : Path
    origin : (2,) array
        The upper left corner of the sheet, mm. In SVG, y points downward.
    decimals : int
        Number of decimals of the coordinates.

    Examples
    --------
    >>> path_data(Path.rectangle(40, 10), np.array([-1.0, 11.0]))
    'M1,11L41,11L41,1L1,1Z'
    """
    # omit a closing line, which the SVG command Z draws
    closing = path.closed and isinstance(path.segments[-1], Line)
    drawn = path.segments[:-1] if closing else path.segments
    left, top = origin.tolist()

    def place(point: list[float]) -> str:
        return f"{_shortest_text(point[0] - left, decimals)},{_shortest_text(top - point[1], decimals)}"

    strokes = [f"M{place(path.start.tolist())}", *(_stroke(segment, place) for segment in drawn)]
    return "".join([*strokes, "Z" if path.closed else ""])


def _shortest_text(value: float, decimals: int = _DECIMALS) -> str:
    short = f"{value:.{decimals}f}".rstrip("0").rstrip(".")
    return "0" if short == "-0" else short


def _stroke(segment: Segment, place: Callable[[list[float]], str]) -> str:
    """Return the part of SVG path data that draws a segment from its start."""
    if isinstance(segment, Line):
        return f"L{place(segment.end.tolist())}"
    if isinstance(segment, Arc):
        radius, turns = _shortest_text(segment.radius), "0" if segment.sweep > 0 else "1"
        # SVG defines an arc by its ends, which makes almost full circles inaccurate
        long = abs(segment.sweep) > np.pi * (1 + 1e-9)
        ends = segment.at(np.array([0.5, 1.0] if long else [1.0])).tolist()
        return "".join(f"A{radius} {radius} 0 0 {turns} {place(end)}" for end in ends)
    letter = {2: "Q", 3: "C"}[segment.curve.degree]
    _, control = segment.curve.bezier_table
    pieces = project(control[:, 1:]).tolist()
    return "".join(letter + " ".join(map(place, piece)) for piece in pieces)


_MARGIN_MM = 1.0
"""Space around the drawing, mm. Without this space, strokes at the edge would be cut off."""


def encode_svg(
    drawing: Drawing,
    *,
    curves: str = "spline",
    tolerance: float = 0.02,
    layers: Mapping[str, LayerChoice] | str | None = None,
    stroke: float = STROKE,
) -> bytes:
    """Return the bytes of an SVG file in mm. Equal drawings give equal bytes.

    Each layer is a group, in the order of machining, and each loop is a <path>. On the sheet, y points
    upward. Arcs and polynomial splines up to degree 3 are exact.

    Parameters
    ----------
    drawing : Drawing
    curves : str
        "spline" and "bezier" write Bezier curves, "arc" writes arcs, and "polyline" writes lines. Bezier
        curves approximate weighted splines and degrees above 3 to the tolerance, at most 0.001 mm.
    tolerance : float
        Largest distance, mm, between a curve and its replacement.
    layers : mapping, optional
        Names and colours, see `style_layers`.
    stroke : float
        Width of the lines, mm. Laser programs recognize thin strokes as cuts.

    Examples
    --------
    >>> from elastica_cad.strip.drawing import CUT_OUTER, LayeredPath
    >>> from elastica_cad.geometry.path import Path
    >>> plate = Drawing("plate", [LayeredPath(CUT_OUTER, Path.rectangle(40, 10))])
    >>> 'width="42mm" height="12mm"' in encode_svg(plate).decode()
    True
    """
    require_record(drawing, Drawing, "what is written", "a Drawing record")
    curves = check_curve_style(curves)
    styles = style_layers(layers)
    require_positive(stroke, "stroke", "mm")
    (left, low), (right, high) = drawing.bounds
    width, height = _shortest_text(right - left + 2 * _MARGIN_MM), _shortest_text(high - low + 2 * _MARGIN_MM)
    shaped = shape_paths([item.path for item in drawing.strokes], curves, tolerance, rational=False)
    decimals = _EXACT_DECIMALS if curves == EXACT else _DECIMALS
    corner = np.array([left - _MARGIN_MM, high + _MARGIN_MM])
    rows = [
        '<?xml version="1.0" encoding="UTF-8"?>',
        '<svg xmlns="http://www.w3.org/2000/svg" version="1.1" '
        'xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" '
        f'width="{width}mm" height="{height}mm" viewBox="0 0 {width} {height}">',
        f"<title>{html_text(drawing.name)}</title>",
    ]
    if command := MADE_BY.get():
        rows.append(f"<desc>{html_text(command)}</desc>")
    for layer in LAYERS:
        paths = [path for item, path in zip(drawing.strokes, shaped, strict=True) if item.layer == layer]
        if not paths:
            continue
        style = styles[layer]
        key, label = html_text(style.name.replace(" ", "_")), html_text(style.name)
        rows.append(
            f'<g id="{key}" inkscape:groupmode="layer" inkscape:label="{label}" '
            f'fill="none" stroke="{style.color}" stroke-width="{stroke:g}">'
        )
        rows.extend(f'<path d="{path_data(path, corner, decimals)}"/>' for path in paths)
        rows.append("</g>")
    rows.append("</svg>\n")
    return "\n".join(rows).encode()


DRAWING_SUFFIXES = (".dxf", ".svg")


def write_drawing(
    drawing: Drawing,
    path: str | os.PathLike[str],
    *,
    kerf: float = KERF,
    curves: str = "spline",
    tolerance: float = 0.02,
    version: str = "R2010",
    layers: Mapping[str, LayerChoice] | str | None = None,
    stroke: float = STROKE,
    holding: HoldingTabs | None = None,
    marks: bool = True,
    force: bool = False,
) -> FilePath:
    """Write a drawing for a laser cutter as .dxf or .svg.

    Parameters
    ----------
    drawing : Drawing
    path : path-like
        The suffix selects the format.
    kerf : float
        Width of the cut, mm. Closed outer loops grow by half the kerf, and inner loops shrink by half the
        kerf. Cutting services often compensate the kerf themselves, so the default is 0. A negative kerf
        reverses the offsets.
    curves : str
        "spline", "bezier", "arc" or "polyline".
    tolerance : float
        Largest distance, mm, between a curve and its replacement.
    version : str
        DXF version, R12 to R2018.
    layers : mapping or str, optional
        Mapping from a layer to a name, or to a name and a colour "#rrggbb". Or the name of a colour scheme:
        "boxes", "lightburn".
    stroke : float
        Width of the lines of an SVG file, mm.
    holding : HoldingTabs, optional
        Bridges that hold parts in the sheet; none by default.
    marks : bool
        False leaves out guide lines and the names of mating strips.
    force : bool
        Overwrite a file of that name.

    Returns
    -------
    pathlib.Path
        The file written.

    Raises
    ------
    MissingDependencyError
        The file is a DXF, and ezdxf is not installed.
    """
    require_record(drawing, Drawing, "the drawing", "a strip, or the result of its .drawing()")
    suffix = require_path(path).suffix.lower()
    check_target(path, force=force)
    if suffix not in DRAWING_SUFFIXES:
        raise InputError(
            "{path} cannot be written as a drawing: end its name with .dxf or .svg, or use ec.plot for "
            "pictures and ec.save(strip, ...) for a STEP file",
            path=path,
        )
    require_flag(marks, "marks")
    drawing = drawing if marks else drawing.only(*(layer for layer in LAYERS if layer != MARK))
    # a hundredth of the repeatability of a laser, mm
    cut = compensate_kerf(drawing, kerf, tolerance=min(tolerance, 1e-4))
    if holding is not None:
        cut = add_holding_tabs(cut, holding)
    if suffix == ".svg":
        content = encode_svg(cut, curves=curves, tolerance=tolerance, layers=layers, stroke=stroke)
    else:
        content = encode_dxf(cut, curves=curves, tolerance=tolerance, version=version, layers=layers)
    return write_atomically(path, content, force)
