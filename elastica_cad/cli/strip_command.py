"""`elastica strip`: make the strip for a drawn curve, and write its files for a laser cutter."""

from collections.abc import Iterator, Mapping, Sequence
from contextlib import suppress
from dataclasses import replace
from functools import cache, partial
from pathlib import Path
from typing import Any

import click

from elastica_cad._text import quote_words
from elastica_cad.cli.options import Chosen
from elastica_cad.cli.requested_curves import (
    RequestedCurve,
    curve_argument,
    read_curves_with_note,
    requested_curves,
)
from elastica_cad.cli.settings import CommandKeys, FileKeys
from elastica_cad.cli.strip_options import (
    grouped,
    nearest_curve_line,
    spec_from_options,
    strip_options,
    table_of,
    typed_change,
    typed_in_two_steps,
)
from elastica_cad.cli.suggestions import (
    suggest_later,
    typed_length,
)
from elastica_cad.cli.voice import answer, cut_text, exit_code, say, say_rows, say_step, voice, warn, wrote
from elastica_cad.defaults import NOT_REALIZABLE
from elastica_cad.design.kit_spec import Cutting
from elastica_cad.design.records import Reader, require_keys
from elastica_cad.design.reports import pre_bend_message
from elastica_cad.design.strip_table import PLANE, clamped_at, split_curve
from elastica_cad.design.tables import Table
from elastica_cad.design.toml_text import seen_from, toml_text
from elastica_cad.errors import (
    Change,
    ElasticaError,
    InputError,
    Length,
    Listed,
    NotConvergedError,
    is_reported,
    note,
)
from elastica_cad.form_finding.rod_solution import solve_rod
from elastica_cad.formats.write_files import check_folder, text_file, write_files
from elastica_cad.geometry.plane_curve import PlaneCurve, split_at_corners
from elastica_cad.kit.kit import left_out
from elastica_cad.kit.strip_kit import StripFiles, StripResult
from elastica_cad.mechanics.elements import Pin
from elastica_cad.mechanics.theorem1 import outlier_message
from elastica_cad.mechanics.trials import not_tried
from elastica_cad.plot.drawing_process import DrawingProcess
from elastica_cad.report_rows import Row, in_order
from elastica_cad.strip.held_shape import about
from elastica_cad.strip.lettering import engraved_names
from elastica_cad.strip.makeable_strip import compensate_within
from elastica_cad.strip.strip import Strip
from elastica_cad.strip.strip_spec import StripSpec
from elastica_cad.strip.suggestions import try_change
from elastica_cad.strip.summary import NEAREST_SUPPORT, not_computed_row, size_row, strip_rows


class _Grouped(click.Command):
    def format_options(self, ctx: click.Context, formatter: click.HelpFormatter) -> None:
        for group, parameters in grouped(self.get_params(ctx)).items():
            rows = [
                row
                for parameter in parameters
                if isinstance(parameter, click.Option) and (row := parameter.get_help_record(ctx)) is not None
            ]
            if rows:
                with formatter.section(group.capitalize()):
                    formatter.write_dl(rows)


@click.command(cls=_Grouped)
@curve_argument()
@strip_options
@click.pass_context
def strip(ctx: click.Context, /, **chosen: Any) -> None:
    """Make the strip that bends into a curve, and its cutting files.

    Writes NAME.dxf and NAME.svg (the cut pattern), NAME.json (the report), NAME.png (the picture; needs
    matplotlib) and NAME.step (flat and bent strip; needs build123d or CadQuery); NAME is the name of CURVE.
    NAME-backing.dxf and .svg are the backing of a laminate.

    The strip takes the curve exactly as drawn, or there is an error. Only where the curvature or its slope jumps,
    so that the outline would have steps or corners, the curve is smoothed within 0.1 mm and a note is printed
    (--smooth 0: no smoothing). With --nearest, --ratio, --stable, --margin, --keep-strain or another limit the
    strip may deviate from the curve, as little as possible.

    Set all other keys of a design file with --set KEY=VALUE, such as --set limits.curvature=0.02. `elastica help`
    lists the keys, `elastica help KEY` explains a key.
    """
    table = table_of(chosen)
    reader, below = Reader(), Table(table, "", {})
    cutting: Cutting = reader.record(Cutting, below.table("cut"))
    file_keys: FileKeys = reader.record(FileKeys, below.table("files"))
    files = StripFiles(cutting, file_keys.paper, file_keys.glb, chosen["step"], chosen["pictures"])
    which = table.get("curve", {})
    read_once = cache(read_curves_with_note)  # all strips may have the same natural curvature
    splits: list[dict[str, Any]] = []

    def divide(curve: PlaneCurve) -> Sequence[PlaneCurve]:
        say_step("splitting the curve")
        require_keys(CommandKeys, keys := Table(table, "", {}))
        found = split_curve(keys, spec_from_options(curve, "", table, read_once))
        splits.append({"supports": found.supports, "ranges": found.ranges, "ratios": found.ratios})
        say_rows(Row("Split", str(found)))
        return found.pieces

    curves = requested_curves(
        chosen["curve"],
        chosen["unit"],
        chosen["number"],
        which.get("layer"),
        every=chosen["every"],
        split=divide if "split" in table else split_at_corners if which.get("split_corners") else None,
        how="--curve 1 .. --curve {count} or --curve ID, or all with --all",
    )
    if design := chosen["save_design"]:
        output = chosen["output"].resolve()
        if design.resolve() in (output, *output.parents):
            raise InputError("{path} is a folder: give the name of a file in it", path=design)
        check_folder(design.parent, [design.name], force=chosen["force"])
    # `wrong` counts curves without a strip, and strips with too large a strain
    reports, solved, wrong, worst = [], list[RequestedCurve](), 0, NOT_REALIZABLE
    # labels of strips and their warnings, by the template of the warning
    alike = dict[str, list[tuple[str, Row]]]()
    strict = table.get("files", {}).get("strict", False)
    brief = len(curves) > 1 and not voice().verbose
    engraved = engraved_names(requested.label for requested in curves)
    for requested in curves:
        try:
            if len(curves) == 1:
                suggest_later(
                    partial(_nearest_request, requested, table),
                    partial(typed_in_two_steps, requested.name),
                    ["nearest_curve", "max_width"],
                )
            spec = spec_from_options(requested.curve, requested.label, table, read_once)
            if table.get("label"):
                spec = spec.changed(label=f"{spec.label}{requested.drawn.suffix}")
            if splits:
                spec = clamped_at(requested.drawn.joints, spec)
            if spec.engrave is None and spec.label == requested.label != engraved[spec.label]:
                spec = spec.changed(engrave=engraved[spec.label])
            if len(curves) == 1:
                suggest_later(partial(_refused_request, spec), typed_change)
            spec.require_size()
            _require_files(requested, chosen, files.cutting, spec)
            result = _solve(requested, spec, unmarked=files.cutting.service)
            say_step(f"writing the files of {requested.name}")
            kit = result.kit(files)
            places = [chosen["output"] / file.name for file in kit.files]
            if design and design.resolve() in [path.resolve() for path in (requested.path, *places)]:
                raise InputError(
                    "{design} is also the drawn curve or a file of the strip. Choose another name for the "
                    "design, such as {other}.",
                    design=design,
                    other=design.with_name("design.toml"),
                )
            if shared := sorted({*map(str, places)} & {*voice().files}):
                raise InputError(
                    "{path} is already a file of another curve. Rename one of the two curves in the drawing, or "
                    "write one of them to another folder with --curve and -o.",
                    path=shared[0],
                )
            written = kit.write(
                chosen["output"], force=chosen["force"], process=ctx.find_object(DrawingProcess)
            )
            voice().notes.extend(text for text in result.strip.warnings if not is_reported(text))
            if brief:
                _report_briefly(result, requested, written, alike)
            else:
                _report(result, requested, written, files.cutting, several=len(curves) > 1)
            reports.append(kit.report)
            solved.append(requested)
            wrong += strict and not result.strip.strain_verdict.allowed
        except ElasticaError as problem:
            for outlier in () if requested.drawn.problem else outlier_message(requested.curve):
                if outlier not in str(problem):
                    warn(outlier)
            if len(curves) == 1 and not chosen["every"]:
                raise
            wrong, worst = wrong + 1, max(worst, exit_code(problem))
            called, message = requested.drawn.called, str(problem)
            warn(message if called in message else f"{called}: {message}")
    answer({"strips": reports, "splits": splits})
    for (label, row), *others in alike.values():
        more = (
            f" The same holds for {Listed(name for name, _ in others)}, with other numbers." if others else ""
        )
        say_rows(replace(row, text=f"{label}: {row.text}{more}"))
    if brief:
        cut = Listed(f"{requested.name}.dxf" for requested in solved)
        marked = f" (cut: {cut})" if solved else ""
        say_rows(Row("Files", f"{len(voice().files)} in {chosen['output']}{marked}"))
    if design and solved:
        wrote([_save_design(design, solved, table, force=chosen["force"])])
        if solved[1:] and "origin" not in table:
            text = "The saved design has all strips in one plane, as drawn. Set `origin` of each strip to move it."
            say_rows(Row("Note", text))
    if reports:
        say(*left_out(step=files.step, pictures=files.pictures))
    if wrong:
        if len(curves) > 1:
            less = f"; {design} leaves them out" if design and solved != list(curves) else ""
            warn(f"{wrong} of {len(curves)} curves cannot be made with these options{less}.")
        ctx.exit(worst)


def _save_design(
    path: Path, curves: Sequence[RequestedCurve], table: Mapping[str, Any], *, force: bool
) -> Path:
    """Write a design file with the strips of a command, and return its path."""
    own = ("slots", "split", *PLANE)
    shared = {key: value for key, value in table.items() if key not in ("curve", "files", "label", *own)}
    own_keys = {key: value for key, value in table.items() if key in own}
    # the pieces of a split curve are strips of one table
    tables = {requested.drawn.number if "split" in table else requested: requested for requested in curves}
    strips = [
        {
            "label": table.get("label", requested.label.removesuffix(requested.drawn.suffix)),
            "curve": _curve_keys(requested, path.parent),
            **own_keys,
        }
        for requested in tables.values()
    ]
    text = toml_text({"schema": 1, **shared, "strips": strips})
    write_files([text_file(path.name, text)], path.parent, force=force)
    return path


def _curve_keys(requested: RequestedCurve, folder: Path) -> dict[str, Any]:
    unit = {"unit": requested.unit} if requested.unit else {}
    which: dict[str, Any] = {"id": requested.own} if requested.alone else {"number": requested.drawn.number}
    return {"file": seen_from(requested.path, folder), **(which if requested.count > 1 else {}), **unit}


def _solve(requested: RequestedCurve, spec: StripSpec, *, unmarked: bool) -> StripResult:
    """Return the strip for a curve. A curve with corners is refused first, unless it may change."""
    say_step("looking for the nearest curve that can be made" if spec.may_change else "finding the widths")
    if not spec.may_change:
        _ = requested.bendable(spec.smooth)
    rod = solve_rod(spec.rod_spec)
    strip = spec.make(rod)
    strip = replace(strip, unmarked=unmarked, joints=requested.drawn.joints)
    return StripResult(spec, rod, strip, requested.name)


def _nearest_request(
    requested: RequestedCurve, table: Mapping[str, Any], problem: ElasticaError
) -> StripSpec | None:
    """Return the request without its rails, pins, ties and loads if these exclude a nearest curve."""
    if "nearest_curve" not in {change.field for change in problem.refusal.changes}:
        return None
    without = {key: value for key, value in table.items() if key not in ("between", "loads")}
    return spec_from_options(requested.curve, requested.label, without)


def _refused_request(spec: StripSpec, problem: ElasticaError) -> StripSpec | None:
    return spec if problem.refusal.changes else None


def _require_files(requested: RequestedCurve, chosen: Chosen, cutting: Cutting, spec: StripSpec) -> None:
    """Raise InputError, before the strip is made, for files that cannot be written or cut."""
    folder: Path = chosen["output"]
    names = [f"{requested.name}.json", *(cutting.file_name(requested.name, kind) for kind in ("dxf", "svg"))]
    places = [folder / name for name in (*names, f"{requested.name}.step")]
    if requested.path.resolve() in [place.resolve() for place in places]:
        raise InputError(
            "{kept} contains the drawn curve and is not overwritten. Choose another folder, such as -o out.",
            kept=requested.path,
        )
    check_folder(folder, names, force=chosen["force"])
    cutting.options(spec.material)


def _rows_on_compensation(result: StripResult) -> Iterator[Row]:
    """Yield the suggestion to compensate the widths, if that makes the strip clearly more accurate."""
    strip = result.strip
    if result.spec.compensate or result.spec.section is not None:
        return
    with suppress(NotConvergedError):
        if not not_computed_row(strip) and strip.held_deviation > 3e-4 * strip.rod.length:
            if reason := not_tried(strip.rod.curve):
                yield Row("Change", reason)
                return
            better = compensate_within(strip, result.spec.shop)
            # compensation reduces the computed deviation, but it can increase the expected deviation, which
            # includes errors of the sheet and of the cut; a fifth less is worth a suggestion
            if (
                better.correction is not None
                and better.held_deviation < strip.held_deviation / 2
                and (expected := better.held().expected) < 0.8 * strip.held().expected
            ):
                yield Row(
                    "Change",
                    "use --compensate to correct the widths: the strip is then accurate to about "
                    f"{about(expected)}",
                )


def _support_row(result: StripResult) -> Row:
    """Return the row with the command that supports a strip of a nearest curve by a pin, if a pin works."""
    curve = result.strip.rod.curve
    for fraction in (1 / 2, 1 / 3, 2 / 3):
        place = round(fraction * curve.length)
        fields = {"curve": curve, "between": (Pin(place),)}
        if suggestion := try_change(result.spec, Change("nearest_curve", fields), widths=2):
            line = nearest_curve_line(result.name, suggestion, "--pin", typed_length(place))
            text = f"to support this strip between its ends ({suggestion.effect}): `{line}`, or elsewhere"
            return Row("Change", text)
    return NEAREST_SUPPORT


def _stable_rows(result: StripResult, requested: RequestedCurve) -> Iterator[Row]:
    # limits cannot be combined with rails, pins, ties and point forces
    if not (result.stability.stable or result.strip.rod.acting):
        options = quote_words([*requested.which, "--stable"])
        yield Row("Change", f"use {options} for the nearest stable curve")


def _joined(strip: Strip) -> str:
    joints = [*filter(None, strip.joints)]
    return f"joined at {Listed(joints)}" if joints else ""


def _report_briefly(
    result: StripResult,
    requested: RequestedCurve,
    written: Sequence[Path],
    alike: dict[str, list[tuple[str, Row]]],
) -> None:
    """Print size and deviation of a strip.

    Collect its warnings in `alike`, so that equal warnings are printed once.
    """
    strip, near = result.strip, result.near
    for row in _rows(result):
        if row.stops:
            alike.setdefault(getattr(row.text, "text", row.text), []).append((strip.label, row))
    moved = "" if near is None else f"; at most {Length(near.deviation)} from the drawn curve"
    label = f"{strip.number} = {strip.label}" if strip.number else strip.label
    text = "; ".join(filter(None, [f"{size_row(strip).text}{moved}", _joined(strip)]))
    say_rows(Row(label, text), *_stable_rows(result, requested))
    voice().files += map(str, written)


def _rows(result: StripResult) -> tuple[Row, ...]:
    rows, verdict = strip_rows(result.strip, result.near, result.stability), result.strip.strain_verdict
    if verdict.allowed or verdict.refused:
        return rows
    return tuple(
        replace(row, text=note(
            "{text} The files are written anyway, because the whole strip is not likely to break.", text=row.text
        ))
        if row.stops and row.text in result.strip.strain_warnings else row
        for row in rows
    )  # fmt: skip


def _report(
    result: StripResult,
    requested: RequestedCurve,
    written: Sequence[Path],
    cutting: Cutting,
    *,
    several: bool,
) -> None:
    """Print the rows on a strip, and its files. `several` is True if the command makes several strips."""
    strip, tabs = result.strip, result.spec.tabs_message
    ends = [Row("Ends", text) for text in (pre_bend_message(strip), tabs, _joined(strip)) if text]
    other = [
        _support_row(result) if row is NEAREST_SUPPORT else row
        for row in (*_rows(result), *_stable_rows(result, requested))
        if row.text != tabs
    ]
    say_rows(*in_order([*other, *ends, *([] if several else _rows_on_compensation(result))]))
    kerf, grain = cutting.options(strip.sheet)["kerf"], strip.sheet.grain
    if kerf_note := cutting.kerf_note([strip.sheet]):
        say_rows(Row("Kerf", kerf_note))
    along = "" if grain == "none" else f"; grain {grain} the strip"
    wrote(
        written,
        {
            f"{result.name}.dxf": f"{cut_text(kerf)}{along}",
            f"{result.name}-holding.dxf": "template to hold the strip",
        },
    )
