"""Reading curves from files and saving drawings to them, the format taken from the file name."""

from pathlib import Path
from typing import Any

import numpy as np

from elastica_cad.errors import InputError, MissingDependencyError
from elastica_cad.fabrication import Drawing
from elastica_cad.formats import (
    FIT_TOLERANCE,
    JOIN_TOLERANCE,
    read_csv_curves,
    read_dxf_curves,
    read_json_curves,
    read_svg_curves,
    read_text_curves,
    write_drawing,
)
from elastica_cad.formats.opening import existing_file, millimetres, naming
from elastica_cad.formats.surfaces import Surface, mesh_surface
from elastica_cad.geometry import PlaneCurve

__all__ = ["CURVE_SUFFIXES", "read_curves", "read_surface", "save"]

KERNEL_SUFFIXES = (".step", ".stp", ".brep")
CURVE_SUFFIXES = (".dxf", ".svg", ".csv", ".txt", ".json", *KERNEL_SUFFIXES)


def read_curves(
    path: str | Path,
    *,
    tolerance: float = JOIN_TOLERANCE,
    fit_tolerance: float = FIT_TOLERANCE,
    unit: str | None = None,
) -> list[PlaneCurve]:
    """The curves drawn in a file, in mm.

    Splines, arcs and ellipses are kept exactly; pieces whose ends meet are joined to one curve; polylines and
    measured points are fitted. A closed curve is returned too, with equal ends.

    Parameters
    ----------
    path : str or Path
        .dxf; .svg (y turned up); .csv: measured points x, y; .txt: "degree count", then control points of a
        uniform unclamped spline; .json: as written by this program; .step, .stp, .brep: with build123d or
        CadQuery.
    tolerance : float
        Ends nearer than this are joined, mm.
    fit_tolerance : float
        Largest distance of measured points from their curve, mm.
    unit : str, optional
        Unit of the numbers in the file, "mm", "cm", "m", "in", "ft" or "px"; overrides what the file says.

    Returns
    -------
    list of PlaneCurve
        In the order of the file, never empty.

    Raises
    ------
    InputError
        A folder, a missing, empty or unknown file, nothing usable in it; the message names the file.
    MissingDependencyError
        The library that reads this format is not installed.

    Examples
    --------
    >>> from pathlib import Path
    >>> from tempfile import TemporaryDirectory
    >>> with TemporaryDirectory() as folder:
    ...     file = Path(folder, "arch.txt")
    ...     _ = file.write_text("2 3\\n0 0\\n50 80\\n100 0\\n")
    ...     round(read_curves(file)[0].length, 2)
    66.69
    """
    path = existing_file(path)
    suffix = path.suffix.lower()
    if suffix == ".dxf":
        return read_dxf_curves(path, tolerance=tolerance, fit_tolerance=fit_tolerance, unit=unit)
    if suffix == ".svg":
        return read_svg_curves(path, tolerance=tolerance, fit_tolerance=fit_tolerance, unit=unit)
    if suffix == ".csv":
        return read_csv_curves(path, fit_tolerance=fit_tolerance, unit=unit)
    if suffix == ".txt":
        return read_text_curves(path, unit=unit)
    if suffix == ".json":
        return read_json_curves(path, unit=unit)
    if suffix in CURVE_SUFFIXES:
        return _kernel_curves(path, unit)
    raise InputError(
        f"{path} ends in {suffix!r}, which is no curve file known here: use {', '.join(CURVE_SUFFIXES)}"
    )


def _kernel_curves(path: Path, unit: str | None) -> list[PlaneCurve]:
    """Curves of a STEP or BREP file, through the OCCT of an installed kernel."""
    try:
        from elastica_cad.step import read_step_curves
    except ImportError as error:
        raise _no_kernel(path) from error
    with naming(path):
        curves: list[PlaneCurve] = read_step_curves(path)
        if not curves:
            raise InputError("holds no plane curve: export the edges that the strips are to follow")
        to_mm = np.diag([millimetres(unit or "mm")] * 2 + [1.0])
        return curves if unit is None else [curve.transformed(to_mm) for curve in curves]


def read_surface(path: str | Path, *, unit: str | None = None, scale: float = 1.0) -> Surface:
    """The surface in a file, to be cut by planes: a mesh (.obj, .stl, .ply) or a CAD body (.step, .stp, .brep).

    Raises
    ------
    InputError
        A missing or unknown file, nothing to cut in it, or a mesh whose size asks for `unit`.
    MissingDependencyError
        Meshes need trimesh, CAD bodies a kernel.
    """
    if Path(path).suffix.lower() not in KERNEL_SUFFIXES:
        return mesh_surface(path, unit=unit, scale=scale)
    path = existing_file(path)
    try:
        from elastica_cad.shape_sections import shape_surface
        from elastica_cad.step import read_step_shape
    except ImportError as error:
        raise _no_kernel(path) from error
    with naming(path):
        return shape_surface(read_step_shape(path), millimetres(unit or "mm") * scale)


def _no_kernel(path: Path) -> MissingDependencyError:
    return MissingDependencyError(
        f'reading {path.name} needs a CAD kernel: pip install "elastica-cad[build123d]"'
    )


def save(drawing: Drawing, path: str | Path, **options: Any) -> Path:
    """Write a drawing for cutting; the suffix of `path`, .dxf or .svg, is the format.

    The options are those of `formats.write_drawing`: kerf, curves, tolerance, version, layers, force.

    Raises
    ------
    InputError
        As `formats.write_drawing`; no file is half written, none overwritten without `force=True`.
    """
    return write_drawing(drawing, path, **options)
