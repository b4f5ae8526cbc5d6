"""Cutting files: a drawing, with kerf on request, in the format that the file name asks for."""

import os
from collections.abc import Mapping
from pathlib import Path as FilePath

from elastica_cad._values import require_flag, require_path
from elastica_cad.errors import InputError
from elastica_cad.fabrication.drawings.cutting import (
    DEFAULT_KERF_MM,
    HoldingTabs,
    add_holding_tabs,
    compensate_kerf,
)
from elastica_cad.fabrication.drawings.drawing import LAYERS, MARK, Drawing
from elastica_cad.formats.drawing_files.drawing_style import LayerChoice
from elastica_cad.formats.drawing_files.dxf_drawing import encode_dxf
from elastica_cad.formats.drawing_files.svg_drawing import encode_svg
from elastica_cad.formats.file_access.write_files import check_target, write_atomically

DRAWING_SUFFIXES = (".dxf", ".svg")

_KERF_TOLERANCE_MM = 1e-4
"""Of offsets by half the kerf: a hundredth of what a laser repeats."""


def write_drawing(
    drawing: Drawing,
    path: str | os.PathLike[str],
    *,
    kerf: float = DEFAULT_KERF_MM,
    curves: str = "spline",
    tolerance: float = 0.02,
    version: str = "R2010",
    layers: Mapping[str, LayerChoice] | str | None = None,
    holding: HoldingTabs | None = None,
    marks: bool = True,
    force: bool = False,
) -> FilePath:
    """Write a drawing for a laser cutter as .dxf or .svg.

    Parameters
    ----------
    drawing : Drawing
    path : path-like
        Its suffix is the format.
    kerf : float
        Width of the cut, mm: closed outer loops grow by half of it, inner ones shrink. Cutting services often
        do this themselves, so the default is 0; it may be negative.
    curves : str
        "spline", "bezier", "arc" or "polyline".
    tolerance : float
        Largest distance, mm, of a replaced curve from the true one.
    version : str
        DXF version, R12 to R2018.
    layers : mapping or str, optional
        From a layer to a name, or to a name and a colour "#rrggbb"; or a scheme of colours, "boxes" or "lightburn".
    holding : HoldingTabs, optional
        Bridges that hold parts in the sheet; none unless given.
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
    InputError
        An unknown suffix or option, an empty drawing, a kerf too wide for a loop, a file that can't be made.
    MissingDependencyError
        DXF without ezdxf.
    """
    if not isinstance(drawing, Drawing):
        raise InputError(
            "a {name} is no drawing: give a strip, or what a .drawing() makes", name=type(drawing).__name__
        )
    suffix = require_path(path).suffix.lower()
    check_target(path, force=force)
    if suffix not in DRAWING_SUFFIXES:
        raise InputError(
            "{path} can't be written as a drawing: end its name with .dxf or .svg; pictures are drawn by ec.plot, "
            "and ec.save(strip, ...) writes the STEP file of a strip",
            path=path,
        )
    require_flag(marks, "marks")
    drawing = drawing if marks else drawing.only(*(layer for layer in LAYERS if layer != MARK))
    cut = compensate_kerf(drawing, kerf, tolerance=min(tolerance, _KERF_TOLERANCE_MM))
    if holding is not None:
        cut = add_holding_tabs(cut, holding)
    if suffix == ".svg":
        content = encode_svg(cut, curves=curves, tolerance=tolerance, layers=layers)
    else:
        content = encode_dxf(cut, curves=curves, tolerance=tolerance, version=version, layers=layers)
    return write_atomically(path, content, force)
