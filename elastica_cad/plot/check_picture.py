"""Picture of a check: the drawn curve, its inflections, the line through them, and its faults."""

from collections.abc import Sequence
from textwrap import fill

import numpy as np

from elastica_cad._values import require_record
from elastica_cad.errors import number_text
from elastica_cad.geometry.plane_points import box_about
from elastica_cad.mechanics.theorem1 import EquilibriumCheck, measured_points
from elastica_cad.plot.canvas import INK, Figure, new_page, show_box, write_beside
from elastica_cad.plot.strip_pictures import (
    FAINT,
    LINE,
    comb_tips,
    finish_axes,
    numbered_panel,
    paint_comb,
    paint_inflection_line,
)


def check(check: EquilibriumCheck) -> Figure:
    """Draw the curve of a check with its curvature comb, inflections, inflection line and faults.

    Noisy measured points are dots, and outliers have a ring. Positions are in mm along the curve from its
    start.

    Parameters
    ----------
    check : EquilibriumCheck
        Result of `check_equilibrium`, or attribute `check` of the exception `NotRealizable`.

    Raises
    ------
    MissingDependencyError
        matplotlib is not installed.
    """
    require_record(check, EquilibriumCheck, "what is drawn", "what check_equilibrium answers")
    curve = check.curve
    nodes = curve.survey
    tips, extent = comb_tips(nodes), float(np.ptp(nodes.position, axis=0).max())
    box = box_about(np.concatenate([nodes.position, tips]))
    size = 1.1 * np.maximum(box[1] - box[0], 0.3 * extent)
    title = fill(
        " ".join((*check.points_message, *check.reasons))
        if check.reasons and check.undecided is None
        else str(check),
        96,
    )
    figure, (axes,) = new_page([numbered_panel(size)], title)
    paint_comb(axes, nodes.position, tips)
    axes.plot(
        *nodes.position.T, color="#2e7d4f" if check.realizable and not check.undecided else INK, linewidth=2.2
    )
    measured, dots = measured_points(curve), ""
    if measured is not None:
        dots = "; the dots were measured"
        axes.plot(*measured.points.T, ".", color=INK, markersize=5, label="_measured points")
        for outlier in measured.outlier:
            ring = {"markersize": 16, "markerfacecolor": "none", "markeredgewidth": 1.6}
            axes.plot(*outlier.values["place"], "o", color="#c62828", label="_stands out", **ring)
    # label, colour, marker and arc lengths, mm, of each kind of place
    kinds: tuple[tuple[str, str, str, Sequence[float]], ...] = (
        ("inflections", LINE, "o", check.inflections),
        ("off the line", LINE, "D", [s for s, off in check.off_line if off > 1e-6 * check.length]),
        ("the line crosses here", FAINT, "X", check.crossings),
        ("the line touches here", FAINT, "P", check.touches),
        ("the curvature touches zero", "#b06a00", "s", check.curvature_touches),
        ("the curvature jumps", "#b06a00", "v", check.jumps),
        ("straight", "#b06a00", "|", [s for piece in check.flats for s in piece]),
    )
    for label, color, marker, places in kinds:
        if not places:
            continue
        points = curve.at(np.array(places)).position
        axes.plot(*points.T, marker, color=color, markersize=8, label=label)
        for s, point in zip(places, points, strict=True):
            write_beside(axes, number_text(s, ".4g"), point, (7, 6), color)
    reach = 0.06 * extent
    low, high = box.mean(axis=0) - size / 2, box.mean(axis=0) + size / 2
    paint_inflection_line(axes, check.line, low + reach, high - reach)
    show_box(axes, low, high)
    verdict = (
        "Undecided by these points" if check.undecided else
        "Can be bent" if check.realizable else
        "Cannot be bent"
    )  # fmt: skip
    finish_axes(axes, f"{verdict}: {number_text(check.length, '.4g')} mm; places in mm along it{dots}")
    return figure
