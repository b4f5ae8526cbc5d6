"""Curves written to files that `read_curves` and CAD programs read again."""

import os
from collections.abc import Sequence
from pathlib import Path

from elastica_cad._values import require_path, several
from elastica_cad.errors import InputError
from elastica_cad.fabrication.drawings.drawing import MARK, Drawing, LayeredPath
from elastica_cad.formats.curve_files.json_curves import curves_json
from elastica_cad.formats.drawing_files.drawing_style import EXACT
from elastica_cad.formats.drawing_files.dxf_drawing import encode_dxf
from elastica_cad.formats.drawing_files.svg_drawing import encode_svg
from elastica_cad.formats.file_access.write_files import check_target, write_atomically
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.paths.path import Path as Chain
from elastica_cad.geometry.paths.segments import Spline

WRITTEN_SUFFIXES = (".dxf", ".svg", ".json")


def write_curves(curves: Sequence[PlaneCurve], path: str | os.PathLike[str], *, force: bool = False) -> Path:
    """Write drawn curves, mm, as .dxf, .svg or .json.

    DXF keeps degree, knots and weights of every spline, JSON every bit; SVG knows cubics without weights only and
    stays within 0.001 mm. In a DXF or SVG two curves whose ends meet are read back as one.

    Parameters
    ----------
    curves : sequence of PlaneCurve
    path : path-like
        Its suffix is the format.
    force : bool
        Overwrite a file of that name.

    Raises
    ------
    InputError
        No curves, an unknown suffix, a file that can't be made.
    MissingDependencyError
        DXF without ezdxf.

    Examples
    --------
    >>> from tempfile import TemporaryDirectory
    >>> arch = PlaneCurve.arc((0, 0), 80, 0.3, 2.8)
    >>> with TemporaryDirectory() as folder:
    ...     write_curves([arch], folder + "/arch.json").name
    'arch.json'
    """
    curves = several("curves", curves, PlaneCurve, "PlaneCurve")
    suffix = require_path(path).suffix.lower()
    check_target(path, force=force)
    if not curves:
        raise InputError("{path}: there are no curves to write", path=path)
    if suffix == ".json":
        return write_atomically(path, curves_json(curves).encode(), force)
    if suffix not in WRITTEN_SUFFIXES:
        raise InputError(
            "{path} can't be written as curves: end its name with {written_suffixes}",
            path=path,
            written_suffixes=", ".join(WRITTEN_SUFFIXES),
        )
    drawn = tuple(LayeredPath(MARK, Chain((Spline(curve),), closed=curve.is_closed)) for curve in curves)
    drawing = Drawing(Path(path).stem, drawn)
    encode = encode_svg if suffix == ".svg" else encode_dxf
    return write_atomically(path, encode(drawing, curves=EXACT), force)
