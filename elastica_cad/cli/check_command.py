"""`elastica check`: check whether a flat strip can take a curve, and name sheets that fit."""

from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from itertools import chain, count, groupby
from math import ceil
from pathlib import Path
from typing import TYPE_CHECKING, Any, cast

import click
import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad.cli.element_options import ELEMENTS, element_options, elements_of
from elastica_cad.cli.options import LENGTH, refuse_idle, requested_sheet, sheet_options, smooth_option
from elastica_cad.cli.requested_curves import (
    RequestedCurve,
    curve_options,
    natural_curvature_of,
    requested_curves,
    split_option,
    support_options,
    which_options,
)
from elastica_cad.cli.suggestions import (
    LOOKING,
    Cure,
    cures_of,
    suggest_later,
    typed_length,
)
from elastica_cad.cli.voice import answer, exit_code, say, say_rows, say_step, voice, warn, wrote
from elastica_cad.defaults import NOT_REALIZABLE
from elastica_cad.design.check_report import PlainData, report_check
from elastica_cad.errors import Change, ElasticaError, InputError, Length, Refusal, note, rounded_up
from elastica_cad.form_finding.rod_solution import accepted_rod, solve_rod
from elastica_cad.form_finding.rod_spec import RodSpec
from elastica_cad.form_finding.straight_ends import StraightEnds
from elastica_cad.geometry.plane_curve import split_at_corners
from elastica_cad.mechanics.elements import Pin, Rail, Tie
from elastica_cad.mechanics.loads import EndName, NaturalCurvature, Supports, require_supports
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.section_limits import unit_question
from elastica_cad.mechanics.sheets import Sheet, sheets_for_curve
from elastica_cad.mechanics.stability import stability
from elastica_cad.mechanics.theorem1 import EquilibriumCheck, NotRealizable, measured_points
from elastica_cad.mechanics.trials import not_tried
from elastica_cad.report_rows import Row, warning_row
from elastica_cad.strip.curve_check import common_request

if TYPE_CHECKING:
    from elastica_cad.strip.strip_spec import StripSpec
    from elastica_cad.strip.suggestions import Suggestion

MOST_SHEETS = 3
"""Largest number of sheets that are listed without -v."""

WIDE_MM = 40.0
"""Width of the widest place, mm, in the example that explains a ratio of widths."""


@click.command()
@curve_options
@which_options
@split_option
@support_options
@element_options(ELEMENTS)
@smooth_option
@sheet_options(required=False, use="Material to check, and to use in suggested changes")
@click.option(
    "--max-width",
    type=LENGTH,
    metavar="MM",
    help="Largest width in suggested changes  [default: a twelfth of the length, from 8 to 120 mm]",
)
@click.option(
    "--picture",
    type=click.Path(path_type=Path),
    metavar="FILE",
    help="Draw the curve with its inflections, their line and the faults in place (PNG, SVG or PDF).",
)
@click.option("--force", is_flag=True, help="Overwrite the picture if it exists.")
@click.pass_context
def check(
    ctx: click.Context,
    /,
    curve: Path,
    unit: str | None,
    number: str | None,
    layer: str | None,
    split_corners: bool,
    start: EndName,
    end: EndName,
    natural_curvature: Any,
    smooth: float | None,
    picture: Path | None,
    force: bool,
    **others: Any,
) -> None:
    """Check whether flat strips can be bent into the curves in CURVE.

    A strip can take a curve if a straight line meets the curve exactly in its inflections and is not tangent to it
    there. Rails, pins and ties (--rail 200) make more curves possible. Every curve is checked separately. Exit code
    1 if a curve is impossible for strips or undecided because of its points; 2 if a curve is not open and smooth.
    """
    requested = requested_curves(
        curve, unit, number, layer, every=True, split=split_at_corners if split_corners else None
    )
    bent, several = natural_curvature_of(natural_curvature), len(requested) > 1
    between = elements_of(others, ELEMENTS)
    supports = require_supports(Supports(start, end), between=bool(between))
    refuse_idle({"thickness": ("sheet",)})
    sheet = requested_sheet(others) if others["sheet"] else None
    checks = [
        _Check(drawn, supports, bent, smooth, not several, between, sheet, others["max_width"])
        for drawn in requested
    ]
    of_file, worst = list(voice().notes), 0
    answers: list[PlainData] = []
    if picture is not None:
        if several:
            raise InputError(
                "A picture shows a single curve, but the file has {count}. Choose a curve with --curve.",
                count=len(requested),
            )
        verdict = checks[0].verdict
        _draw(checks[0].rod if between and verdict.realizable else verdict, picture, force=force)
    # following curves with equal rows are printed once
    for rows, alike in groupby(
        ((check, *check.judged()) for check in checks),
        key=lambda judged: _rows(judged[1]),
    ):
        judged, reports, codes = zip(*alike, strict=True)
        first, last, answered = judged[0].requested, judged[-1].requested, reports[-1]
        if "problem" in answered:
            warn(answered["advice"])
        else:
            if max(first.count, len(requested)) > 1:
                which = (
                    first.drawn.called if first is last else f"{first.drawn.called} to {last.drawn.called}"
                )
                say(f"{curve.name}, {which} of {first.count}:")
            say_rows(*rows, is_answer=True)
        if not (answered["realizable"] or several or voice().quiet):
            answered["cures"] = judged[0].cures()
            say_rows(*(Row("Change", cure["text"]) for cure in answered["cures"]))
        if (
            not codes[-1]
            and not (several or voice().quiet or picture)
            and (larger := judged[0].enlarging(answered))
        ):
            say_rows(Row("Change", larger))
        worst = max(worst, *codes)
        answers.extend(reports)
    answer([report | {"notes": [*of_file, *report.get("notes", ())]} for report in answers])
    if worst:
        ctx.exit(worst)


@dataclass(frozen=True, eq=False)
class _Check:
    """A curve to check, with its options. `smooth` is the largest movement by smoothing, mm.

    `alone` is True if the command checks only this curve; an error of the curve is then an error of the command.
    Without `sheet` and `max_width`, suggested changes are tested with a usual sheet and width.
    """

    requested: RequestedCurve
    supports: Supports
    natural_curvature: NaturalCurvature
    smooth: float | None
    alone: bool
    between: tuple[Rail | Pin | Tie, ...]
    sheet: Sheet | None
    max_width: float | None

    @cached_property
    def ends(self) -> StraightEnds:
        return StraightEnds.of(self.requested.bendable(self.smooth), self.supports, self.natural_curvature)

    @cached_property
    def spec(self) -> RodSpec:
        return RodSpec(
            self.ends.bent,
            supports=self.supports,
            natural_curvature=self.natural_curvature,
            smooth=self.smooth,
            between=self.between,
        )

    @cached_property
    def rod(self) -> Rod:
        return accepted_rod(solve_rod(self.spec))

    @cached_property
    def verdict(self) -> EquilibriumCheck:
        """Result of the check. With rails, pins or ties, a linear program decides."""
        check = self.spec.check
        if not self.between:
            return check
        # a linear program checks curves with rails, pins or ties, and gives the reasons
        try:
            warnings = self.rod.warnings
        except NotRealizable as problem:
            return cast(EquilibriumCheck, problem.check)
        undecided = str(check.undecided)
        return replace(check, warnings=tuple(text for text in warnings if text != undecided))

    def judged(self) -> tuple[PlainData, int]:
        """Return the report on the curve, and the exit code."""
        try:
            report = self._report()
        except ElasticaError as problem:
            if not self.alone:
                refused = {
                    "realizable": False,
                    "problem": str(problem),
                    "advice": f"{str(problem).rstrip('.')}.",
                }
                return refused, exit_code(problem)
            if not self.requested.drawn.problem:
                suggest_later(self.request, self.typed)
            raise
        return report, 0 if report["realizable"] and not report.get("undecided") else NOT_REALIZABLE

    def _report(self) -> PlainData:
        """Return the report of the check as plain data, with the advice and, for a possible curve, its sheets."""
        verdict, smoothing = self.verdict, self.spec.smoothing
        outcome = self._smoothed()
        report = report_check(verdict)
        if not verdict.undecided:
            report["advice"] = " ".join([*outcome, report["advice"]])
        # the check already reports noise
        of_curve = (message for message in smoothing.notes if message not in smoothing.noise)
        of_ends = [self.ends.message] if self.ends else []
        report["notes"] = [*outcome, *verdict.details, *of_ends, *of_curve]
        if verdict.realizable:
            tried = None if self.sheet is None else [self.sheet]
            ratio, curve = self.rod.ratio, smoothing.curve
            scaled_sheets = sheets_for_curve(curve, self.natural_curvature, tried)
            sheets = [{"name": sheet.sheet.name, "scale": sheet.scale} for sheet in scaled_sheets]
            question = unit_question(scaled_sheets[0].scale, curve.length)
            report |= {
                "ratio": ratio,
                "sheets": sheets,
                "unit_question": question,
                "advice_on_sheets": [_widths_row(ratio).text, _sheets_row(sheets, question).text],
            }
            report |= _report_on_elements(self.rod) if self.between else {}
        return report

    def _smoothed(self) -> tuple[Refusal, ...]:
        """Return a sentence on whether a strip can take the smoothed curve, for refused noisy points."""
        points = measured_points(self.verdict.curve)
        if self.verdict.realizable or points is None or points.outlier or not_tried(self.requested.curve):
            return ()
        fair = False
        with suppress(ElasticaError):
            fair = replace(self, smooth=points.reach).verdict.realizable
        return (note(
            (
                "No strip can take this curve as drawn, but a strip can take the curve smoothed within "
                "{reach}."
            ) if fair else
            "No strip can take this curve, even if it is smoothed within {reach}.",
            reach=Length(points.reach),
        ),)  # fmt: skip

    def request(self, problem: ElasticaError) -> "StripSpec | None":
        # request of a usual strip for which changes are tested, or None if no change is known or options settle it
        settled = self.natural_curvature or self.smooth is not None
        if settled or not problem.refusal.changes:
            return None
        return common_request(
            self.requested.curve,
            self.supports,
            between=self.between,
            sheet=self.sheet,
            max_width=self.max_width,
        )

    def cures(self) -> list[Cure]:
        problem = NotRealizable(self.verdict)
        spec = self.request(problem)
        if spec is None:
            return []
        say_step(LOOKING)
        return cures_of(spec, problem, self.typed, assumed=" ".join(self._assumed(spec)))

    def _assumed(self, spec: "StripSpec") -> list[str]:
        """Return the options of sheet and width that the user has not set, as words of a command line."""
        sheet = [] if self.sheet else ["--sheet", spec.material.name]
        return sheet + ([] if self.max_width else ["--max-width", typed_length(cast(float, spec.max_width))])

    def enlarging(self, report: PlainData) -> str:
        """Return how to enlarge a curve that is too tight for all sheets, after a test, or ""."""
        least = report["sheets"][0]
        if (
            least["scale"] <= 1
            or report["unit_question"]
            or self.smooth is not None
            or self.natural_curvature
            or self.between
        ):
            return ""
        if reason := not_tried(self.requested.curve):
            return reason
        # the narrowest place of the suggested strip is at least 5 mm wide
        spec = common_request(self.requested.curve, self.supports).changed(
            sheet=least["name"], max_width=rounded_up(max(WIDE_MM, 5.0 * report["ratio"]), 3)
        )
        from elastica_cad.strip.suggestions import try_change

        # slightly larger, because the strain of the finished strip differs slightly
        larger = try_change(spec, Change("size", rounded_up(1.002 * least["scale"], 4)))
        return "" if larger is None else f"Enlarge the curve for {least['name']}: {self.typed(larger)}."

    def typed(self, suggestion: "Suggestion") -> str:
        """Return the command that makes the strip with a suggested change."""
        from elastica_cad.cli.strip_options import typed_change

        words = self._assumed(suggestion.requests[0])
        folders = chain(["out"], (f"out-{k}" for k in count(2)))
        unused = next(name for name in folders if not Path(name).exists())
        change = typed_change(suggestion, *words, "-o", unused, instead="strip")
        if change == suggestion.title:
            return change
        return f"{change}, or with another sheet, width and folder"


def _rows(report: PlainData) -> list[Row]:
    """Return the rows of the report. An undecided check has the notes as details."""
    notes = [text for text in report.get("notes", ()) if text not in report["advice"]]
    if report.get("undecided"):
        verdict = Row("Verdict", report["advice"], notes, "error")
    else:
        text = " ".join([report["advice"], *notes])
        verdict = Row("Verdict", text, severity="note" if report["realizable"] else "error")
    return [
        verdict,
        *(
            [_widths_row(report["ratio"]), _sheets_row(report["sheets"], report["unit_question"])]
            if "ratio" in report
            else []
        ),
        *([_stability_row(report)] if "stability" in report else []),
    ]


def _widths_row(ratio: float) -> Row:
    if ratio < 1.005:  # no visible difference
        return Row("Widths", "the same along the whole strip")
    example = f"{WIDE_MM:g} and {WIDE_MM / ratio:.3g} mm"
    text = (
        f"the strip varies in width: its widest place is {ratio:.3g} times as wide as its narrowest, "
        f"e.g. {example}"
    )
    if WIDE_MM / ratio >= 1.0:  # mm; no narrower strip can be cut
        return Row("Widths", text)
    advice = "Draw another curve, or take the nearest curve (--nearest of `elastica strip`)"
    return warning_row(f"{text}, which is too narrow to cut. {advice}", "Widths")


def _sheets_row(sheets: Sequence[PlainData], question: str) -> Row:
    """Return the row on sheets that fit. It names first, for each kind, the sheet closest to its strain limit.

    `question` asks about the unit if the size is improbable.
    """
    if question:
        return warning_row(f"none at this size. {question}", "Sheets")
    # `sheets` are sorted by `scale`, to which the curve must at least be enlarged for the sheet, so the last sheet
    # that fits is closest to its limit
    tightest_first = [Sheet.named(sheet["name"]) for sheet in sheets if sheet["scale"] <= 1][::-1]
    # the tightest sheet of each kind
    of_kind = {sheet.kind: sheet for sheet in tightest_first[::-1]}
    each_kind_first = sorted(tightest_first, key=lambda sheet: of_kind[sheet.kind] is not sheet)
    fitting = [sheet.name for sheet in each_kind_first]
    larger = [f"{sheet['name']} at {ceil(100 * sheet['scale'])} %" for sheet in sheets if sheet["scale"] > 1]
    details = [f"All: {', '.join(fitting)}."] if fitting else []
    details += [f"If the curve is enlarged: {', '.join(larger)}."] if larger else []
    return Row(
        "Sheets",
        _first_names(fitting, "those closest to their strain limit, one of each kind; thinner ones are safer")
        if fitting
        else f"none at this size; if the curve is enlarged, {_first_names(larger, 'the least enlarged')}",
        details,
    )


def _first_names(names: Sequence[str], order: str) -> str:
    shown = ", ".join(names[:MOST_SHEETS])
    if not names[MOST_SHEETS:]:
        return shown
    return f"any of {len(names)}, e.g. {shown} ({order}; -v lists all)"


def _draw(verdict: EquilibriumCheck | Rod, path: Path, *, force: bool) -> None:
    from elastica_cad.plot.canvas import save_figure
    from elastica_cad.plot.check_picture import check as draw_check
    from elastica_cad.plot.strip_pictures import rod as draw_rod

    figure = draw_rod(verdict) if isinstance(verdict, Rod) else draw_check(verdict)
    save_figure(figure, path, force=force)
    wrote([path])


def _report_on_elements(rod: Rod) -> PlainData:
    """Return the stability of a strip on rails, pins or ties, and the side of each bar."""
    verdict, sides = stability(rod), []
    for action in rod.between:
        if isinstance(action.element, Rail):
            angle = rod.curve.at(action.s).angle
            # a rail on the right pushes the strip to the left
            presses_left = action.force[0] @ (-np.sin(angle[0]), np.cos(angle[0])) > 0
            sides.append({"at": action.s[0], "side": "right" if presses_left else "left"})
    report = {"stability": {"word": verdict.word, "margin": verdict.margin}, "bars": sides}
    return report | {"advice_on_elements": _stability_row(report).text}


def _stability_row(report: PlainData) -> Row:
    bars = [
        f"the rail at {bar['at']:.4g} mm is on the {bar['side']} of the strip, seen from its start"
        for bar in report["bars"]
    ]
    word = report["stability"]["word"]
    text = {"unstable": "unstable: the strip snaps into another shape", "low": "close to snapping"}
    return Row(
        "Stability", "; ".join([text.get(word, "stable in its plane"), *bars]),
        severity="note" if word == "ample" else "warning",
    )  # fmt: skip
