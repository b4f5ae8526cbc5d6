"""`elastica check`: can this curve be bent from a flat strip?"""

from pathlib import Path
from typing import Any

import click

from elastica_cad.cli.options import (
    bendable_curve,
    curve_options,
    drawn_curves,
    smooth_option,
    split_option,
    support_options,
    which_options,
)
from elastica_cad.cli.running.typed_command import MOST_CURES
from elastica_cad.cli.running.voice import answer, say, warn
from elastica_cad.errors import ElasticaError
from elastica_cad.formats.curve_files.drawn_file import DrawnCurve
from elastica_cad.formats.reports.check_report import report_check
from elastica_cad.forming.rounding_verdict import undecided_by_rounding
from elastica_cad.forming.smoothing import smooth_curve
from elastica_cad.mechanics.loads.rest_curvature import NaturalCurvature
from elastica_cad.mechanics.loads.supports import EndName, Supports
from elastica_cad.mechanics.theorem1.equilibrium_check import check_equilibrium

NOT_REALIZABLE, BAD_INPUT = 1, 2


@click.command()
@curve_options
@which_options
@split_option
@support_options
@smooth_option
@click.pass_context
def check(
    ctx: click.Context,
    curve: Path,
    unit: str | None,
    number: str | None,
    layer: str | None,
    split_corners: bool,
    start: EndName,
    end: EndName,
    natural_curvature: NaturalCurvature,
    smooth: float | None,
) -> None:
    """Tell whether the curves in CURVE can be bent from a flat strip, and if not, where and why.

    A curve can be bent when one straight line meets it exactly in its inflections and is tangent to it in none
    of them. Every curve is judged for itself. Exit code 1 when any cannot be bent, 2 when any is no open,
    smooth curve.
    """
    drawing = drawn_curves(curve, unit, number, layer)
    supports, worst = Supports(start, end), 0
    answers: list[tuple[DrawnCurve, dict[str, Any]]] = []
    judged = [
        (whole, one)
        for whole in drawing.chosen(number, layer)
        for one in (whole.split_at_corners() if split_corners else (whole,))
    ]
    several = max(len(drawing), len(judged)) > 1
    for whole, one in judged:
        try:
            found, good = _judged(curve, one, len(drawing), supports, natural_curvature, smooth)
        except ElasticaError as problem:
            if not several:
                if not one.problem:
                    problem.add_note(_cure(one.curve, supports, natural_curvature, smooth, ()))
                raise
            found, good = {"realizable": False, "problem": str(problem), "advice": f"{problem}."}, False
            worst = BAD_INPUT
        cured = sum("cure" in told for _, told in answers)
        if not good and not one.problem and cured < MOST_CURES:
            which = ("--curve", str(one.number)) if len(drawing) > 1 else ()
            cure = _cure(whole.curve, supports, natural_curvature, smooth, which)
            found |= {"cure": cure} if cure else {}
        worst = max(worst, 0 if good else NOT_REALIZABLE)
        answers.append((one, found))
        head = f"{curve.name}, {one.called} of {len(drawing)}:\n" if several else ""
        said = " ".join(filter(None, (found["advice"], *found.get("notes", ()), found.get("cure", ""))))
        if "problem" in found:
            warn(said)
        else:
            say(f"{head}{said}")
    answer([found for _, found in answers])
    if worst:
        ctx.exit(worst)


def _cure(*asked: Any) -> str:
    """As `cure_for_curve`, which imports all that makes strips."""
    from elastica_cad.cli.running.strip_cures import cure_for_curve

    return cure_for_curve(*asked)


def _judged(
    path: Path,
    one: DrawnCurve,
    count: int,
    supports: Supports,
    natural_curvature: NaturalCurvature,
    smooth: float | None,
) -> tuple[dict[str, Any], bool]:
    """The report on one curve, and whether it can be bent."""
    drawn = bendable_curve(path, one, count)
    smoothing = smooth_curve(drawn, smooth, supports=supports)
    found = check_equilibrium(smoothing.curve, supports=supports, natural_curvature=natural_curvature)
    doubt = "" if natural_curvature else undecided_by_rounding(drawn, found.realizable, smooth, supports)
    report = report_check(found)
    if doubt:
        report["advice"] = f"{doubt} As it stands: {report['advice']}"
    return report | {"undecided": bool(doubt), "notes": list(smoothing.notes)}, found.realizable
