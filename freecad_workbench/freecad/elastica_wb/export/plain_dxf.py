# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Cutting files; where ezdxf is missing, DXF of version R12: closed polylines of lines and arcs on layers, mm."""

from collections.abc import Iterator, Mapping, Sequence
from importlib.util import find_spec
from pathlib import Path as FilePath

import numpy as np

from elastica_cad.fabrication.drawings.cutting import compensate_kerf
from elastica_cad.fabrication.drawings.drawing import Drawing
from elastica_cad.formats.drawing_files.curve_style import shape_paths
from elastica_cad.formats.drawing_files.layers import LayerStyle, style_layers
from elastica_cad.formats.drawing_files.write_drawing import write_drawing
from elastica_cad.formats.file_access.atomic_write import write_atomically
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.segments import Arc, Segment
from elastica_cad.geometry.paths.trim import trim_segment

KERF_TOLERANCE_MM = 0.001  # finer than any cut: what is left of it is the tolerance of curves
HALF_TURN = np.pi * (1 + 1e-9)  # longest arc of one bulge
INKS = {(255, 0, 0): 1, (255, 255, 0): 2, (0, 255, 0): 3, (0, 255, 255): 4, (0, 0, 255): 5, (255, 0, 255): 6}
"""AutoCAD's numbers of the pure colours; 7 is the ink of the screen."""


def write_cut(
    drawing: Drawing, path: FilePath, *, kerf: float, curves: str, tolerance: float, version: str
) -> FilePath:
    """Write a drawing as DXF or SVG, as `write_drawing` does; without ezdxf a DXF is `plain_dxf`."""
    if path.suffix.lower() == ".dxf" and find_spec("ezdxf") is None:
        cut = compensate_kerf(drawing, kerf, tolerance=min(tolerance, KERF_TOLERANCE_MM))
        text = plain_dxf(cut, curves=curves, tolerance=tolerance)
        return write_atomically(path, text.encode("ascii"), True)
    return write_drawing(
        drawing, path, kerf=kerf, curves=curves, tolerance=tolerance, version=version, force=True
    )


def plain_dxf(drawing: Drawing, *, curves: str = "arc", tolerance: float = 0.02) -> str:
    """A drawing as the text of a DXF file of version R12, which knows no splines: they become arcs, or lines."""
    styles = style_layers()
    style = "polyline" if curves == "polyline" else "arc"
    bounds = drawing.bounds
    groups = [
        (999, "all lengths in mm"),
        *_section("HEADER", _header(bounds)),
        *_section("TABLES", _layers(styles, drawing.layers)),
        *_section("ENTITIES", _entities(drawing, styles, style, tolerance)),
        (0, "EOF"),
    ]
    return "".join(f"{code:>3}\n{_written(value)}\n" for code, value in groups)


Group = tuple[int, str | int | float]


def _section(name: str, groups: Iterator[Group]) -> Iterator[Group]:
    yield 0, "SECTION"
    yield 2, name
    yield from groups
    yield 0, "ENDSEC"


def _header(bounds: np.ndarray) -> Iterator[Group]:
    yield 9, "$ACADVER"
    yield 1, "AC1009"
    yield 9, "$INSUNITS"
    yield 70, 4
    for name, (x, y) in zip(("$EXTMIN", "$EXTMAX"), bounds.tolist(), strict=True):
        yield 9, name
        yield from ((10, x), (20, y), (30, 0.0))


def _layers(styles: Mapping[str, LayerStyle], layers: Sequence[str]) -> Iterator[Group]:
    yield from ((0, "TABLE"), (2, "LAYER"), (70, len(layers)))
    for layer in layers:
        style = styles[layer]
        yield from ((0, "LAYER"), (2, style.name), (70, 0), (62, INKS.get(style.rgb, 7)), (6, "CONTINUOUS"))
    yield 0, "ENDTAB"


def _entities(
    drawing: Drawing, styles: Mapping[str, LayerStyle], curves: str, tolerance: float
) -> Iterator[Group]:
    shaped = shape_paths([stroke.path for stroke in drawing.strokes], curves, tolerance)
    for stroke, path in zip(drawing.strokes, shaped, strict=True):
        yield from _entity(path, styles[stroke.layer].name)


def _entity(path: Path, layer: str) -> Iterator[Group]:
    first = path.segments[0]
    if len(path.segments) == 1 and isinstance(first, Arc) and first.is_circle:
        x, y = first.center
        yield from ((0, "CIRCLE"), (8, layer), (10, float(x)), (20, float(y)), (30, 0.0), (40, first.radius))
        return
    pieces = [piece for segment in path.segments for piece in _halves(segment)]
    yield from ((0, "POLYLINE"), (8, layer), (66, 1), (70, int(path.closed)), (10, 0.0), (20, 0.0), (30, 0.0))
    for piece in pieces:
        yield from _vertex(layer, piece.start, piece.bulge if isinstance(piece, Arc) else 0.0)
    if not path.closed:
        yield from _vertex(layer, path.end, 0.0)
    yield from ((0, "SEQEND"), (8, layer))


def _vertex(layer: str, place: np.ndarray, bulge: float) -> Iterator[Group]:
    x, y = place
    yield from ((0, "VERTEX"), (8, layer), (10, float(x)), (20, float(y)), (30, 0.0), (42, float(bulge)))


def _halves(segment: Segment) -> list[Segment]:
    """An arc of more than half a turn in two, so that its bulge stays moderate."""
    if isinstance(segment, Arc) and abs(segment.sweep) > HALF_TURN:
        return [trim_segment(segment, 0.0, 0.5), trim_segment(segment, 0.5, 1.0)]
    return [segment]


def _written(value: str | int | float) -> str:
    return f"{value:.15g}" if isinstance(value, float) else str(value)
