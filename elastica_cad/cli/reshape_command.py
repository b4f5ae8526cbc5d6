"""`elastica reshape`: deform a curve by a map that does not change whether a flat strip can take the curve."""

import warnings
from collections.abc import Sequence
from functools import partial
from pathlib import Path
from typing import Any

import click
import numpy as np

from elastica_cad._text import file_word
from elastica_cad.cli.options import LENGTH, POINT, option_name, output_options, refuse_idle
from elastica_cad.cli.requested_curves import UNIT, curve_argument, drawn_curves, which_options
from elastica_cad.cli.suggestions import typed_length
from elastica_cad.cli.voice import answer, say, say_rows, warn, wrote
from elastica_cad.defaults import BAD_INPUT, NOT_REALIZABLE
from elastica_cad.design.drawn_curves import CORNERS, map_corners
from elastica_cad.errors import InputError, Point, Severity
from elastica_cad.form_finding.rod_spec import RodSpec
from elastica_cad.formats.curve_writer import FitWarning, write_curves
from elastica_cad.formats.write_files import File, write_files
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.geometry.plane_points import box_around
from elastica_cad.geometry.projective_maps import four_point_map
from elastica_cad.mechanics.least_ratio import optimal_rod
from elastica_cad.mechanics.theorem1 import require_bendable
from elastica_cad.report_rows import Row, warning_row


@click.command()
@curve_argument()
@which_options
@click.option("--unit", type=UNIT, help="Unit of the numbers in the file.")
@click.option(
    "--bottom-left",
    type=POINT,
    metavar="X Y",
    help="New position of this corner of the frame, the upright rectangle around the curves, mm.",
)
@click.option("--bottom-right", type=POINT, metavar="X Y", help="New position of that corner, mm.")
@click.option("--top-right", type=POINT, metavar="X Y", help="New position of that corner, mm.")
@click.option("--top-left", type=POINT, metavar="X Y", help="New position of that corner, mm.")
@click.option("--handle", "handles", type=(LENGTH,) * 4, multiple=True, metavar="X Y TO_X TO_Y",
              help="Instead of corners, four times: a place of the drawing, and its new position, mm.")  # fmt: skip
@output_options
@click.pass_context
def reshape(
    ctx: click.Context,
    /,
    curve: Path,
    number: str | None,
    layer: str | None,
    unit: str | None,
    handles: tuple[tuple[float, float, float, float], ...],
    force: bool,
    output: Path,
    **corners: tuple[float, float] | None,
) -> None:
    """Stretch and skew curves by moving the corners of their frame.

    The frame is the upright rectangle around the curves in CURVE. --handle moves four other places
    instead of the corners.

    \b
      elastica reshape wave.dxf --top-right 265 190 --top-left 20 130
      elastica reshape wave.dxf --handle 0 0 0 0 --handle 300 0 300 0 --handle 300 90 280 120 --handle 0 90 0 90

    The map is projective: lines stay lines. So inflections on a line stay on a line, and if a strip can take the
    curve, a strip can take the new curve. Other corners stay in place. Writes NAME-reshaped.dxf (exact splines with
    weights), .svg (cubics, within 0.001 mm) and .json (exact). Exit code 1 if no strip can take a curve, which no
    such map changes; 2 if a curve cannot be read and is left out, which a line says.
    """
    refuse_idle({}, {"handles": CORNERS})
    drawing, chosen = drawn_curves(curve, unit, number, layer)
    for drawn_curve in chosen if len(chosen) > 1 else ():
        if drawn_curve.problem:
            text = f"{curve.name}, {drawn_curve.called} of {len(drawing)} is left out: {drawn_curve.problem}"
            say_rows(warning_row(text, "Left out"))
    originals = [drawn_curve.curve for drawn_curve in chosen if not drawn_curve.problem] or [chosen[0].curve]
    moved = {name: place for name, place in corners.items() if place is not None}
    if moved:
        matrix = map_corners(originals, moved)
    elif not handles:
        low, (right, top) = box_around(np.array([original.bounds for original in originals]))
        raise InputError(
            "The new shape is missing. Give a new position of a corner of the frame around the curve "
            "({options}), such as --top-right {x} {y}. The frame reaches from {low} to {high}.",
            options=", ".join(map(option_name, CORNERS)),
            x=typed_length(round(float(right + 0.1 * (right - low[0])), 1)),
            y=typed_length(round(float(top), 1)),
            low=Point(low),
            high=Point((right, top)),
        )
    elif len(handles) != 4:
        raise InputError(
            "--handle moves 4 places at once, but is given {count} times. Give 4 places of the drawing, each with "
            "its new position: --handle X Y TO_X TO_Y.",
            count=len(handles),
        )
    else:
        matrix = four_point_map([handle[:2] for handle in handles], [handle[2:] for handle in handles])
    changed = [drawn_curve.transformed(matrix) for drawn_curve in originals]
    name = f"{file_word(curve.stem)}-reshaped"
    files = [File(f"{name}.{kind}", partial(_write_curves, changed)) for kind in ("dxf", "svg", "json")]
    written = write_files(files, output, force=force)
    reports = []
    for count, pair in enumerate(zip(originals, changed, strict=True), start=1):
        if len(originals) > 1:
            say(f"curve {count} of {len(originals)}:")
        reports.append(
            {word: _strip_data(shape) for word, shape in zip(("before", "after"), pair, strict=True)}
        )
        for word, verdict in reports[-1].items():
            severity: Severity = "note" if verdict["realizable"] else "error"
            say_rows(Row(word.capitalize(), _sentence(verdict), severity=severity), is_answer=True)
    answer({"map": matrix, "curves": reports})
    wrote(written)
    bad = [i for i, report in enumerate(reports) if not report["after"]["realizable"]]
    if bad:
        text = "Moving these corners cannot make the curve possible for a strip. Redraw the curve."
        say_rows(warning_row(text, "Change"))
    left_out = len(originals) < len(chosen)
    if bad or left_out:
        ctx.exit(BAD_INPUT if left_out else NOT_REALIZABLE)


def _write_curves(curves: Sequence[PlaneCurve], path: Path) -> None:
    with warnings.catch_warnings(record=True) as fits:
        warnings.simplefilter("always", FitWarning)
        write_curves(curves, path)
    for fit in fits:
        warn(str(fit.message))


def _strip_data(curve: PlaneCurve) -> dict[str, Any]:
    """Return the length of a curve and whether a strip can take it, with the least ratio or the reasons."""
    measured = {"length": curve.length, "realizable": False, "inflections": (), "ratio": None}
    try:
        require_bendable(curve)
    except InputError as problem:
        return measured | {"reasons": (str(problem),)}
    spec = RodSpec(curve)
    check = spec.check
    return measured | {
        "inflections": check.inflections,
        "realizable": check.realizable,
        "reasons": check.reasons,
        "ratio": optimal_rod(spec.smoothing.curve, check=check).ratio if check.realizable else None,
    }


def _sentence(verdict: dict[str, Any]) -> str:
    at = ", ".join(f"{s:.1f}" for s in verdict["inflections"])
    shape = f"{verdict['length']:.2f} mm long, {f'inflections at {at} mm' if at else 'no inflection'}"
    if not verdict["realizable"]:
        return f"{shape}; no strip can take it: {verdict['reasons'][0]}"
    return f"{shape}; a strip can take it, stiffness ratio {verdict['ratio']:.4g}"
