"""Kerf: cut loops moved by half the width of the cut, as the last step before a file is written."""

import numpy as np

from elastica_cad._values import is_number, require_record
from elastica_cad.errors import InputError
from elastica_cad.fabrication.drawings.drawing import CUT_INNER, CUT_OUTER, Drawing, LayeredPath
from elastica_cad.geometry.paths.offset import offset_path
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.path_intersections import polylines_cross
from elastica_cad.geometry.paths.segments import place

WIDEST_KERF_MM = 15.0
"""A router's bit of half an inch is 12.7 mm wide."""


def compensate_kerf(drawing: Drawing, kerf: float, *, tolerance: float = 1e-4) -> Drawing:
    """The drawing as the tool must run so that the parts come out as drawn.

    Closed loops on CUT_OUTER move outward by kerf / 2, those on CUT_INNER inward; a negative kerf moves them
    the other way. Open cuts, engraving and marks stay.

    Parameters
    ----------
    drawing : Drawing
    kerf : float
        Width of the cut, mm.
    tolerance : float
        Largest error of a moved spline, mm; lines and arcs are exact.

    Raises
    ------
    InputError
        A kerf wider than that of any tool; a loop is swallowed by the cut, or moved loops cross or touch each
        other.

    Examples
    --------
    >>> plate = Drawing("plate", [LayeredPath(CUT_OUTER, Path.circle((0, 0), 10))])
    >>> compensate_kerf(plate, 0.2).paths[0].path.segments[0].radius
    10.1
    """
    if not is_number(kerf):
        raise InputError(f"the kerf is {kerf!r}: it must be a finite number of mm, 0 for none")
    require_record(drawing, Drawing, "what is cut", "a Drawing record")
    if abs(kerf) > WIDEST_KERF_MM:
        raise InputError(
            f"the kerf is {kerf:g} mm, wider than the cut of any tool: give the width of the cut in mm, such as "
            "0.15 for a laser"
        )
    if kerf == 0:
        return drawing
    sides = {CUT_OUTER: kerf / 2, CUT_INNER: -kerf / 2}
    moved = []
    loops = []
    for item in drawing.paths:
        if item.layer in sides and item.path.closed:
            loops.append(_moved(item, sides[item.layer], kerf, tolerance))
            moved.append(LayeredPath(item.layer, loops[-1]))
        else:
            moved.append(item)
    _refuse_overlaps(loops, kerf, tolerance)
    return Drawing(drawing.name, tuple(moved), drawing.texts)


def _moved(item: LayeredPath, distance: float, kerf: float, tolerance: float) -> Path:
    try:
        return offset_path(item.path, distance, tolerance=tolerance)
    except InputError as error:
        raise InputError(f"a kerf of {kerf:g} mm is too wide for a loop on {item.layer}: {error}") from error


def _refuse_overlaps(loops: list[Path], kerf: float, tolerance: float) -> None:
    if len(loops) < 2:
        return
    bounds = np.array([loop.bounds for loop in loops])
    low, high = bounds[:, 0], bounds[:, 1]
    order = np.argsort(low[:, 0], kind="stable")
    outlines: dict[int, np.ndarray] = {}

    def outline(i: int) -> np.ndarray:
        if i not in outlines:
            points = loops[i].points(tolerance)
            outlines[i] = np.concatenate([points, points[:1]])
        return outlines[i]

    for k, i in enumerate(order):
        rest = order[k + 1 :]
        rest = rest[: np.searchsorted(low[rest, 0], high[i, 0], side="right")]
        for j in rest[(low[rest, 1] <= high[i, 1]) & (high[rest, 1] >= low[i, 1])]:
            crossing = polylines_cross(outline(int(i)), outline(int(j)))
            if crossing is not None:
                raise InputError(
                    f"with a kerf of {kerf:g} mm two cut loops meet at {place(crossing)}: move them apart "
                    "there or use a smaller kerf"
                )
