"""How curves are written: as splines, arcs or polylines."""

from collections.abc import Iterable

from elastica_cad._values import is_number
from elastica_cad.errors import InputError
from elastica_cad.geometry.paths.approximations import as_arcs, as_cubics, as_polyline
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.segments import require_tolerance_mm

CURVES = ("spline", "arc", "polyline")

EXACT = "exact"
"""Splines of any degree as they are: for curves that a CAD program is to read, not a machine."""

_SPLINE_TOLERANCE_MM = 1e-3
"""Splines cost few bytes: approximated ones stay this near even where a coarser tolerance is given."""

FINEST_MM = 1e-5
"""Finer arcs and polylines would only fill the disk."""


def check_curve_style(curves: str) -> str:
    """The mode, refused unless it is one of `CURVES` or `EXACT`."""
    if not isinstance(curves, str) or curves not in (*CURVES, EXACT):
        raise InputError(f"curves is {curves!r}: use one of {', '.join(CURVES)}")
    return curves


def shape_paths(paths: Iterable[Path], curves: str, tolerance: float, *, rational: bool = True) -> list[Path]:
    """The paths as a file holds them: splines of degree 3 at most (`rational` where allowed), arcs, or lines.

    With `EXACT` splines of any degree stay, where the file knows weights.
    """
    if not is_number(tolerance):
        raise InputError(f"the tolerance is {tolerance!r}: give a number of mm, such as 0.02")
    if curves == EXACT and rational:
        return list(paths)
    if 0 < tolerance < FINEST_MM and curves not in ("spline", EXACT):
        raise InputError(
            f"the tolerance is {tolerance:g} mm: no machine cuts so finely, give {FINEST_MM:g} or more"
        )
    if curves in ("spline", EXACT):
        finest = _SPLINE_TOLERANCE_MM if curves == EXACT else min(tolerance, _SPLINE_TOLERANCE_MM)
        require_tolerance_mm(finest)
        return [as_cubics(path, finest, rational=rational) if path.has_splines else path for path in paths]
    return [(as_arcs if curves == "arc" else as_polyline)(path, tolerance) for path in paths]
