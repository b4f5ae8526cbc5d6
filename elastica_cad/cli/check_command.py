"""`elastica check`: can this curve be bent from a flat strip?"""

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import Any

import click

from elastica_cad.cli.asking.asked_curves import (
    AskedCurve,
    asked_curves,
    curve_options,
    split_option,
    which_options,
)
from elastica_cad.cli.asking.options import smooth_option
from elastica_cad.cli.asking.support_options import support_options
from elastica_cad.cli.running.typed_command import MOST_CURES, cure_later, first_told, with_cure
from elastica_cad.cli.running.voice import answer, say_with_cure, voice, warn
from elastica_cad.errors import ElasticaError
from elastica_cad.formats.reports.check_report import report_check
from elastica_cad.forming.fairing_request import smooth_curve
from elastica_cad.forming.rounding_verdict import undecided_by_rounding
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
    asked = asked_curves(curve, unit, number, layer, every=True, split=split_corners)
    of_file, supports, worst, bad = list(voice().notes), Supports(start, end), 0, 0
    answers: list[dict[str, Any]] = []
    several = max(asked[0].count, len(asked)) > 1
    for one in asked:
        found = _judged(one, supports, natural_curvature, smooth, alone=not several)
        good = found["realizable"]
        cured = sum("cure" in told for told in answers)
        look: Callable[[], str] = str  # for no cure
        if not good and not one.drawn.problem and cured < MOST_CURES:
            asked_for = one.whole.curve, supports, natural_curvature, smooth, one.which
            look = partial(_cure, *asked_for)
        said = " ".join((found["advice"], *found.get("notes", ())))
        if "problem" in found:
            cure = look()
            bad += 1
            warn(with_cure(said, cure), told=bad <= MOST_CURES)
        else:
            head = f"{curve.name}, {one.drawn.called} of {one.count}:\n" if several else ""
            cure = say_with_cure(f"{head}{said}", look)
        found |= {"cure": cure} if cure else {}
        worst = max(worst, 0 if good else BAD_INPUT if "problem" in found else NOT_REALIZABLE)
        answers.append(found)
    if bad > MOST_CURES:
        warn(f"{bad} of {len(asked)} curves are no open, smooth curves{first_told(bad)}")
    answer([one | {"notes": [*of_file, *one.get("notes", ())]} for one in answers])
    if worst:
        ctx.exit(worst)


def _cure(*asked: Any) -> str:
    """As `cure_for_curve`, which imports all that makes strips."""
    from elastica_cad.cli.running.strip_cures import cure_for_curve

    return cure_for_curve(*asked)


def _judged(
    asked: AskedCurve,
    supports: Supports,
    natural_curvature: NaturalCurvature,
    smooth: float | None,
    *,
    alone: bool,
) -> dict[str, Any]:
    """The report on one curve; of one among several also where it is no open, smooth curve."""
    try:
        return _report(asked, supports, natural_curvature, smooth)
    except ElasticaError as problem:
        if not alone:
            return {"realizable": False, "problem": str(problem), "advice": f"{problem}."}
        if not asked.drawn.problem:
            cure_later(problem, partial(_cure, asked.curve, supports, natural_curvature, smooth, ()))
        raise


def _report(
    asked: AskedCurve, supports: Supports, natural_curvature: NaturalCurvature, smooth: float | None
) -> dict[str, Any]:
    drawn = asked.bendable(smooth)
    smoothing = smooth_curve(drawn, smooth, supports=supports)
    found = check_equilibrium(smoothing.curve, supports=supports, natural_curvature=natural_curvature)
    doubt = "" if natural_curvature else undecided_by_rounding(drawn, found.realizable, smooth, supports)
    report = report_check(found)
    if doubt:
        report["advice"] = f"{doubt} As it stands: {report['advice']}"
    return report | {"undecided": bool(doubt), "notes": list(smoothing.notes)}
