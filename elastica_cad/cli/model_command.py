"""`elastica model`: make the model of a design file, with all files that are needed to build it."""

import re
from collections.abc import Iterator
from dataclasses import fields, replace
from functools import partial
from itertools import count
from pathlib import Path
from typing import TYPE_CHECKING

import click

from elastica_cad._values import counted
from elastica_cad.cli.options import output_options
from elastica_cad.cli.settings import parsed_settings, set_option
from elastica_cad.cli.suggestions import suggest_later
from elastica_cad.cli.voice import answer, say, say_rows, say_step, voice, warn
from elastica_cad.design.design_file import Design, read_design
from elastica_cad.design.model_tables import DesignKeys
from elastica_cad.errors import (
    ElasticaError,
    InputError,
    Length,
    Listed,
    Mass,
    Refusal,
    Severity,
    is_reported,
    note,
    one_of_each,
    sentences,
)
from elastica_cad.files import read_curves, read_surface
from elastica_cad.form_finding.nearest_record import Status
from elastica_cad.formats.drawn_file import CurveList
from elastica_cad.kit.kit import Kit, left_out
from elastica_cad.kit.kit_contents import KitContents, count_strips, far_parts, kit_contents, require_sizes
from elastica_cad.kit.model_kit import START_PAGE, check_kit_folder, left_behind, model_kit
from elastica_cad.mechanics.stability import SAFE_MARGIN, stability
from elastica_cad.plot.drawing_process import DrawingProcess, in_writing_order
from elastica_cad.report_rows import Row, warning_row
from elastica_cad.strip.held_shape import about
from elastica_cad.strip.pieces import EqualStrips
from elastica_cad.strip.strip_spec import StripSpec

if TYPE_CHECKING:
    from elastica_cad.strip.suggestions import Suggestion
from elastica_cad.strip.summary import NEAREST_SUPPORT, accuracy_row, hold_row, size_row, stability_row


@click.command()
@click.argument("design", type=click.Path(path_type=Path))
@click.option(
    "--step/--no-step", default=True, help="Write the bent strips as STEP (needs build123d or CadQuery)."
)
@click.option(
    "--pictures/--no-pictures", default=True, help="Draw the model and the sheets (needs matplotlib)."
)
@click.option("--parts/--no-parts", default=True, help="Also draw every part in separate files.")
@click.option(
    "--zip",
    "archives",
    is_flag=True,
    help="Also write two ZIP files: one to cut or print, one to view.",
)
@click.option(
    "--effects/--no-effects",
    default=True,
    help="Compute the shape of every strip with its slots, and report their effect.",
)
@set_option(DesignKeys)
@click.option(
    "--nearest", is_flag=True, help=("Allow every strip to deviate from its curve, as little as possible.")
)
@click.option(
    "--ignore-limits", is_flag=True, help="Write parts that cannot be cut or handled, with a warning."
)
@click.option(
    "--below",
    type=click.Path(path_type=Path),
    multiple=True,
    metavar="FOLDER",
    help="Allow the design to read files in this folder too, besides its own folder and the working folder.",
)
@output_options
def model(
    design: Path,
    output: Path,
    step: bool,
    pictures: bool,
    parts: bool,
    archives: bool,
    effects: bool,
    settings: tuple[str, ...],
    nearest: bool,
    ignore_limits: bool,
    below: tuple[Path, ...],
    force: bool,
) -> None:
    """Make a whole model from the design file DESIGN (TOML).

    Writes into a folder: nested sheets, a DXF and an SVG per part, the requested base plate and fixtures, the cut
    list (CSV and text), a report (JSON), the assembly (STEP) and pictures. All files are written, or none. For the
    nested sheets alone, the fastest options are --no-parts --no-effects --no-pictures --no-step.
    """
    changes = parsed_settings(settings, DesignKeys)
    say_step("reading the design")
    requested = read_design(design, _read_with_note, read_surface, below=below, changes=changes)
    if requested.kit.cutting.service and not parts:
        raise InputError(
            'With cut.for = "service" only the separate parts are written, and --no-parts '
            "leaves them out. Leave out --no-parts."
        )
    requested = requested.nearest() if nearest else requested
    requested = requested.with_limits_ignored() if ignore_limits else requested
    check_kit_folder(requested.name, output, force=force)
    suggest_later(partial(_refused_request, requested), _design_line, FIELDS)
    strips, files = count(1), count(1)

    def written(_: str, total: int) -> None:
        # called after each file, to announce the next
        if (number := next(files)) < total:
            say_step(f"writing {in_writing_order(kit.files)[number].name}", number + 1, total)

    try:
        require_sizes(requested.entries, requested.kit)
        result = requested.model(
            lambda label: say_step(f"made strip {label}", next(strips), len(requested.entries))
        )
        say_step("laying parts on sheets" + (", bending strips with their slots" if effects else ""))
        contents = kit_contents(result, requested.kit, entries=requested.entries, effects=effects)
    except ElasticaError:
        # print assumptions, such as the position of the axis, because an assumption may cause the error
        say_rows(*(warning_row(text, "Note") for text in requested.reports))
        raise
    kit = model_kit(contents, step=step, pictures=pictures, parts=parts, archives=archives)
    say_step(f"writing {in_writing_order(kit.files)[0].name}", 1, len(kit.files))
    kit.write(
        output,
        force=force,
        done=written,
        process=click.get_current_context().find_object(DrawingProcess),
    )
    _report(contents, kit, output)
    blocks, paper = contents.names_of_blocks, bool(requested.kit.pages)
    say(*left_out(step=step, pictures=pictures, paper=paper, blocks=blocks))
    if blocks and not step:
        say(f"not written: STL of {Listed(blocks)}; to get it: leave out --no-step")


KEYS = {"nearest": f"`limits = {{{{ margin = {SAFE_MARGIN:g} }}}}`", "lap": "`shop = {{ lap = {value:g} }}`"}
"""Lines of a design file that make a suggested change, by field. For other fields the line is FIELD = VALUE."""

FIELDS = ("nearest", "lap", "max_width", "smooth", "thickness")
"""Fields that can be changed by a line in the table of a strip."""


def _refused_request(design: Design, problem: ElasticaError) -> StripSpec | None:
    specs = [entry.spec for entry in design.entries if entry.called == problem.refusal.where.get("strip")]
    return specs[0] if len(specs) == 1 else None


def _design_line(suggestion: "Suggestion") -> str:
    lines = sentences(
        (
            KEYS.get(change.field, "`{field} = {value:g}`").format(field=change.field, value=change.value)
            for change in (suggestion.change, suggestion.width)
            if change is not None
        ),
        " and ",
    )
    return f"{lines} in the table of strip {suggestion.requests[0].label}"


def _read_with_note(path: Path, *, unit: str | None = None) -> CurveList:
    curves = read_curves(path, unit=unit)
    message = f"{path.name}: {curves.file.unit.note}"
    # print the note once, because several strips may use the same file
    if curves.file.unit.note and message not in voice().notes:
        warn(message)
    return curves


def _report(contents: KitContents, kit: Kit, output: Path) -> None:
    """Print the rows on a model. Strips whose size and accuracy are equal have one row."""
    answer(kit.report | {"folder": output})
    voice().files += [str(output / file.name) for file in kit.files]
    model, cut_list, held = contents.model, contents.cut_list, contents.held or {}
    if scaled := [entry for entry in contents.entries if entry.scale != 1]:
        factors = Listed(f"{entry.label} to {100 * entry.scale:.4g} %" for entry in scaled)
        say_rows(Row("Scale", f"curves resized to the lengths in the design: {factors} of the drawn size"))
    # parts by the text and the severity of their row
    sizes: dict[tuple[str, Severity], list[EqualStrips]] = {}
    for part in model.parts:
        shape = held.get(model.single_name_of(part.members[0]))
        accuracy = "" if shape is None else f"; accurate to about {about(shape.expected)}"
        judged = stability_row(part.strip, stability(part.strip.rod))
        used, word = 100 * part.strip.strain_verdict.used, re.split("[:;]", judged.text)[0]
        text = f"{size_row(part.strip).text}; strain {used:.0f} % of the limit, {word}{accuracy}"
        sizes.setdefault((text, judged.severity), []).append(part)
    for (text, severity), parts in sizes.items():
        count, names = sum(part.count for part in parts), [part.name for part in parts]
        label = f"{names[0]} x {count}" if count > 1 else names[0]
        # only -v shows details
        details = [f"{part.name}: {hold_row(part.strip).text}" for part in parts if voice().verbose]
        more = [f"These are {', '.join(names)}.", *details] if names[1:] else details
        say_rows(Row(label, text, more, severity))
    joints = f", {counted(len(model.joints), 'joint')}" if model.joints else ""
    pieces = "" if cut_list.count == len(model.placed) else (
        f"{counted(cut_list.count, 'piece')} of {counted(cut_list.shapes, 'shape')}, "
    )  # fmt: skip
    say_rows(
        Row(
            "Model",
            f"{model.name}: {count_strips(model)}{joints}; {pieces}{cut_list.cut_length / 1000:.1f} m of "
            f"cuts, {Mass(cut_list.mass)}",
        )
    )
    if deviations := contents.deviations:
        farthest = max(deviations, key=lambda name: deviations[name])
        text = f"{farthest} is farthest from its drawn curve: {Length(deviations[farthest])}"
        say_rows(Row("Curves", text))
    if held:
        worst = max(held, key=lambda name: held[name].expected)
        row = accuracy_row(held[worst])
        say_rows(replace(row, text=f"{worst} deviates most: {row.text}"))
        if row.severity == "warning" and worst in contents.deviations:
            say_rows(NEAREST_SUPPORT)
    _print_notes(contents, kit, output)
    details = [
        f"{nest.name}: {counted(len(nest.pieces), 'piece')}, {100 * nest.share:.0f} % of the sheet"
        f"{nest.grain and f', {nest.grain}'}"
        for nest in contents.nests
    ]
    sawn = [f"saw from one rod, mm: {line}" for item in cut_list.stock for line in item.sawn]
    start = [f"; open {output / START_PAGE} first" for file in kit.files if file.name == START_PAGE]
    say_rows(
        Row("To buy", "; ".join(map(str, cut_list.stock)), [*details, *sawn]),
        Row("Files", f"{len(kit.files)} in {output}{''.join(start)}"),
    )


def _print_notes(contents: KitContents, kit: Kit, output: Path) -> None:
    """Print the most important notes, one of each kind, and where to find the others."""
    model = contents.model
    messages = [*contents.notes, *model.reports, *_warnings(contents)]
    if old := left_behind(kit, output):
        messages.append(
            f"{output} holds files of an earlier run that do not belong to this model "
            f"({old[0]}{' and others' if old[1:] else ''}). Delete them, or choose an empty folder."
        )
    # the report contains all notes
    printed = messages if voice().verbose else list(one_of_each(messages))[:6]
    if messages:
        warn("Before you cut:", in_notes=False)
    say_rows(*(warning_row(text, "Note") for text in printed))
    strips = [part.strip for part in model.parts]
    unstable = dict.fromkeys(
        strip.label for strip in strips if not (strip.rod.acting or stability(strip.rod).stable)
    )
    requested = {entry.label for entry in contents.entries}
    if labels := [label for label in unstable if label in requested]:
        change = f"set limits.margin = {SAFE_MARGIN:g} in the table of {Listed(labels)}"
        say_rows(Row("Change", f"{change} for the nearest stable curve"))
    named = set[str]().union(*(text.fields for text in printed if isinstance(text, Refusal)))
    if keys := sorted(named & {key.name for key in fields(StripSpec)}):
        warn(
            f"Keys of the design file: {Listed(keys)}. `elastica help {keys[0]}` explains it.",
            in_notes=False,
        )
    if len(messages) > len(printed):
        warn(f"All {len(messages)} notes are in {model.name}.json, or printed with -v.", in_notes=False)


def _warnings(contents: KitContents) -> Iterator[Refusal]:
    """Yield the warnings about strips, except those to which another note already has a remedy."""
    model = contents.model
    far = far_parts(model, contents.deviations)
    for part in model.parts:
        for text in part.strip.warnings:
            if text == Status.FAR.value and part in far:
                continue  # another note already names this strip and a remedy
            if voice().verbose or is_reported(text):
                warning = text if isinstance(text, Refusal) else note(text, severity="warning")
                yield warning.at(strip=part.name)
