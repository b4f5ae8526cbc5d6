"""Writer of curves to files that `read_curves` and CAD programs can read."""

import os
import warnings
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import require_path, several
from elastica_cad.defaults import UNKNOWN_WIDTH
from elastica_cad.errors import ElasticaError, InputError, Length, Refusal, note
from elastica_cad.form_finding.fairing_request import smooth_curve
from elastica_cad.formats.chains import curve_from_points, curve_from_run
from elastica_cad.formats.drawing_files import encode_svg
from elastica_cad.formats.drawing_style import EXACT, shape_paths
from elastica_cad.formats.dxf_drawing import encode_dxf
from elastica_cad.formats.edges import Edge
from elastica_cad.formats.json_curves import curves_json
from elastica_cad.formats.write_files import check_target, write_atomically
from elastica_cad.geometry.fairing import two_sided_distance
from elastica_cad.geometry.path import Arc, Line, Spline
from elastica_cad.geometry.path import Path as Chain
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.mechanics.least_ratio import optimal_rod
from elastica_cad.strip.drawing import MARK, Drawing, LayeredPath

WRITTEN_SUFFIXES = (".dxf", ".svg", ".json", ".csv")

_TOLERANCE_MM = 1e-3
"""Largest distance, mm, between a curve and the cubics or arcs that replace it in a file."""

_MOST_POINTS = 1001
"""Largest number of points in a CSV file. A curve of less than 1 m has a point every mm."""


class FitWarning(UserWarning):
    """Warning that a file contains an approximation of a curve."""


def write_curves(
    curves: Sequence[PlaneCurve],
    path: str | os.PathLike[str],
    *,
    version: str = "R2010",
    force: bool = False,
) -> Path:
    """Write drawn curves, mm, as .dxf, .svg, .json or .csv.

    DXF keeps degree, knots and weights of every spline. JSON stores the exact numbers, and SVG stores cubics
    to 1e-12 mm. In SVG, weighted splines and higher degrees become cubics. In DXF R12, curves become arcs.
    These cubics and arcs are accurate to 0.001 mm. CSV contains points. A `FitWarning` reports the distance
    between a curve and its replacement, and the largest change of strip width. Two curves of a DXF or SVG
    whose ends meet are read back as a single curve.

    Parameters
    ----------
    curves : sequence of PlaneCurve
    path : path-like
        The suffix selects the format.
    version : str
        DXF version, R12 to R2018.
    force : bool
        Overwrite a file of that name.

    Raises
    ------
    MissingDependencyError
        The file is a DXF, and ezdxf is not installed.

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
        raise InputError("{path}: there are no curves to write. Give at least one curve", path=path)
    if suffix not in WRITTEN_SUFFIXES:
        raise InputError(
            "{path} cannot be written as curves: end its name with {written_suffixes}",
            path=path,
            written_suffixes=", ".join(WRITTEN_SUFFIXES),
        )
    # below, `held` are the curves that are read again from the file
    if suffix == ".json":
        return write_atomically(path, curves_json(curves).encode(), force)
    if suffix == ".csv":
        sampled = [curve.sample(min(int(curve.length) + 101, _MOST_POINTS)).position for curve in curves]
        texts = ("".join(f"{x:.9f},{y:.9f}\n" for x, y in points) for points in sampled)
        content = "\n\n".join(f"x_mm,y_mm\n{text}" for text in texts).encode()
        held = [curve_from_points(points) for points in sampled]
    else:
        chains = [Chain((Spline(curve),), closed=curve.is_closed) for curve in curves]
        drawing = Drawing(Path(path).stem, tuple(LayeredPath(MARK, chain) for chain in chains))
        style = "arc" if version == "R12" and suffix == ".dxf" else EXACT
        content = (
            encode_svg(drawing, curves=style, tolerance=_TOLERANCE_MM)
            if suffix == ".svg"
            else encode_dxf(drawing, curves=style, tolerance=_TOLERANCE_MM, version=version)
        )
        shaped = shape_paths(chains, style, _TOLERANCE_MM, rational=suffix != ".svg")
        held = [_read_again(chain) for chain in shaped]
    written = write_atomically(path, content, force)
    for number, (drawn, fitted) in enumerate(zip(curves, held, strict=True), start=1):
        if fitted is not drawn and (told := _fit_note(Path(path).name, number, drawn, fitted)):
            warnings.warn(told, FitWarning, stacklevel=2)
    return written


def _read_again(chain: Chain) -> PlaneCurve:
    # the curve that `read_curves` makes of a written path
    if len(chain.segments) == 1 and isinstance(chain.segments[0], Spline):
        return chain.segments[0].curve
    return curve_from_run([_edge(segment) for segment in chain.segments])


def _edge(segment: Line | Arc | Spline) -> Edge:
    if isinstance(segment, Line):
        return Edge.polyline([segment.start, segment.end])
    curve = segment.as_spline().curve if isinstance(segment, Arc) else segment.curve
    return Edge(curve.knots, curve.control_points, curve.degree, curve.weights)


def _fit_note(file: str, number: int, drawn: PlaneCurve, fitted: PlaneCurve) -> Refusal | None:
    """Return a warning about a copy that differs from its curve, or None for differences that no one can cut."""
    far = Length(two_sided_distance(drawn, fitted))
    before, after = _widths(drawn), _widths(fitted)
    if before is None or after is None:
        return note(
            "The copy of curve {number} in {file} differs from the curve by up to {far:.2g}. No strip can "
            "take this curve."
            if before is None else
            "The copy of curve {number} in {file} differs from the curve by up to {far:.2g}, and a strip "
            "cannot take this copy. Use JSON, which stores the exact curve.",
            file=file, number=number, far=far, severity="warning",
        )  # fmt: skip
    change = Length(float(np.abs(after - before).max()))
    if max(far, change) < _TOLERANCE_MM:
        return None
    return note(
        "The copy of curve {number} in {file} differs from the curve by up to {far:.2g}. The widths of a "
        "{widest} wide strip change by up to {change:.2g}.",
        file=file, number=number, far=far, widest=Length(UNKNOWN_WIDTH), change=change, severity="warning",
    )  # fmt: skip


def _widths(curve: PlaneCurve) -> FloatArray | None:
    """Return strip widths (n,), mm, at equal distances along a curve, or None if no strip takes this curve."""
    try:
        rod = optimal_rod(smooth_curve(curve).curve)
    except ElasticaError:
        return None
    return rod.profile(np.linspace(0.0, rod.length, 401)) * (UNKNOWN_WIDTH / rod.ratio)
