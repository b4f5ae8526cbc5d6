"""`elastica strip`: from a drawn curve to the files that a laser cutter needs."""

import json
from collections.abc import Callable, Mapping
from contextlib import suppress
from dataclasses import replace
from functools import partial
from importlib.util import find_spec
from itertools import islice
from pathlib import Path
from typing import Any

import click

from elastica_cad.cli.options import (
    CHOICE,
    bendable_curve,
    curve_options,
    drawn_curves,
    file_stem,
    holding_option,
    join_options,
    output_options,
    split_option,
    which_options,
)
from elastica_cad.cli.running.lengths import LENGTH, Length
from elastica_cad.cli.running.strip_cures import cure_for
from elastica_cad.cli.running.typed_command import MOST_CURES, say_with_cure
from elastica_cad.cli.running.voice import answer, say, say_step, warn, wrote
from elastica_cad.cli.strip_options import spec_from_options, strip_options
from elastica_cad.errors import ElasticaError, InputError, NotConvergedError, NotMetError, how_to_install
from elastica_cad.fabrication.drawings.bridges import HoldingTabs
from elastica_cad.fabrication.drawings.lettering import engravable
from elastica_cad.fabrication.makeability.splices import spliced
from elastica_cad.fabrication.model.strip_model import Model
from elastica_cad.fabrication.placed_strip import Placed
from elastica_cad.fabrication.slots.mating_marks import end_numbers
from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.fabrication.strip_spec import StripSpec
from elastica_cad.files import save
from elastica_cad.formats.curve_files.drawn_file import DrawnCurve
from elastica_cad.formats.design_files.kit_spec import Cutting
from elastica_cad.formats.file_access.file_transaction import write_together
from elastica_cad.formats.reports.strip_report import report_strip
from elastica_cad.forming.nearest.advice import advise
from elastica_cad.forming.nearest.nearest_record import NearestRod
from elastica_cad.forming.rounding_verdict import undecided_by_rounding
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.frame import Frame
from elastica_cad.mechanics.stability.stability_verdict import Stability, stability
from elastica_cad.mechanics.theorem1.verdict import NotRealizable

MOST_ADVICE = 1
"""Sentences after a success; each costs a solve or two."""


_CUT = (
    click.option("--kerf", type=Length(words=("sheet",)), default=0.0, metavar="MM|sheet", show_default=True,
                 help="Width that the laser burns away; `sheet`: the sheet's. Most shops add it themselves."),
    click.option("--curves", type=click.Choice(["spline", "arc", "polyline"]), default="spline",
                 show_default=True, help="How curved edges are written."),
    click.option("--tolerance", type=LENGTH, default=0.02, show_default=True, metavar="MM",
                 help="Largest error of arcs and polylines."),
    click.option("--dxf-version", default="R2010", show_default=True,
                 help="R12, R2000, R2004, R2007, R2010, R2013 or R2018."),
    holding_option,
    click.option("--paper", type=click.Choice(["A4", "A3", "A2", "A1", "A0", "letter", "tabloid"]),
                 help="Write NAME.pdf too: full size on this paper, tiles with marks to join them by."),
    click.option("--glb", is_flag=True,
                 help="Write NAME.glb too: the bent strip for browsers, phones and Blender (needs build123d)."),
    output_options,
)  # fmt: skip


def _cutting(chosen: Mapping[str, Any]) -> Cutting:
    """How the options ask for cutting files to be written."""
    width = None if chosen["kerf"] == "sheet" else chosen["kerf"]
    holding = chosen["holding"]
    bridges = None if holding is None else HoldingTabs(holding)
    return Cutting(width, chosen["curves"], chosen["tolerance"], chosen["dxf_version"], bridges)


@click.command()
@curve_options
@which_options
@click.option("--all", "every", is_flag=True, help="A strip for every curve of the file, each for itself.")
@split_option
@strip_options
@click.option("--strict", is_flag=True, help="Exit with 1 when the strain is beyond what the sheet bears.")
@join_options(*_CUT)
@click.pass_context
def strip(ctx: click.Context, /, **chosen: Any) -> None:
    """Make the strip that bends into the curve in CURVE, and write its cutting files.

    Writes NAME.dxf and NAME.svg (the cut pattern), NAME.json (the report), NAME.png (the picture; needs
    matplotlib) and NAME.step (flat and bent strip; needs build123d or CadQuery); NAME is that of the file read.
    NAME-backing.dxf and .svg are what is glued on a laminate. --glb and --paper add a model and a template.

    --split-corners makes a strip of every piece between corners, NAME-1, NAME-2 ..., whose ends carry the same J1
    where they meet.

    The curve is taken exactly as drawn, or refused; only a pen curve whose curvature jumps from piece to piece is
    made fair within 0.1 mm or so, which is told (--smooth 0 leaves it alone). With --nearest, --ratio, --stable,
    --margin, --keep-strain or another limit the strip may leave it, as little as it must.

    KEYS are written as in a design file: 'at = 40, width = 1.2'.
    """
    path, number, layer = chosen["curve"], chosen["number"], chosen["layer"]
    every, split = chosen["every"], chosen["split_corners"]
    drawing = drawn_curves(path, chosen["unit"], number, layer)
    asked = drawing.chosen(number, layer) if every else (drawing.one(number, layer, CHOICE),)
    parts = [(whole, one) for whole in asked for one in (whole.split_at_corners() if split else (whole,))]
    reports, wrong, refused = [], 0, 0
    for whole, one in parts:
        piece = one.piece if one.pieces > 1 else None
        which = ("--curve", str(one.number)) if every and len(drawing) > 1 else ()
        cure = partial(cure_for, which=which, whole=whole.curve if piece else None)
        name = file_stem(path, str(one.number) if every else number, piece)
        try:
            report, good = _one_strip(one, len(drawing), name, chosen, cure if refused < MOST_CURES else None)
            reports.append(report)
            wrong += not good
        except ElasticaError as problem:
            if len(parts) == 1 and not every:
                raise
            wrong, refused = wrong + 1, refused + 1
            warn(f"{'' if one.called in str(problem) else f'{one.called}: '}{say_with_cure(problem)}")
    answer({"strips": reports})
    if refused > MOST_CURES:
        warn(
            f"commands that work were looked for only for the first {MOST_CURES}; --curve N tells that of another"
        )
    if wrong:
        if len(parts) > 1:
            warn(f"{wrong} of {len(parts)} curves made no strip as asked")
        ctx.exit(1)


def _one_strip(
    one: DrawnCurve, count: int, name: str, chosen: dict[str, Any], cure: Callable[[StripSpec], str] | None
) -> tuple[dict[str, Any], bool]:
    """The report on the strip of one curve, whose files are written, and whether it is as good as asked.

    A refusal ends with what `cure` tells of the request.
    """
    cutting = _cutting(chosen)
    drawn = bendable_curve(chosen["curve"], one, count, may_change=True)
    label = engravable(name) if chosen["label"] is None else chosen["label"]
    spec = spec_from_options(drawn, label, chosen)
    if not spec.may_change:
        try:
            bendable_curve(chosen["curve"], one, count)
        except InputError as problem:
            problem.add_note("" if cure is None else cure(spec))
            raise
    made, near = _made(spec, drawn, cure)
    verdict = stability(made.rod)
    say_step(f"writing the files of {name}")
    written, report = _write_files(made, spec, name, chosen, cutting, near, verdict, one.joints)
    _tell(made, near, verdict, written)
    for joint, end in zip(one.joints, ("starts", "ends"), strict=True):
        if joint:
            say(f"it {end} at the corner {joint}, where the strip with the same number goes on")
    return report, not (chosen["strict"] and made.max_strain > made.sheet.max_strain)


def _made(
    spec: StripSpec, drawn: PlaneCurve, cure: Callable[[StripSpec], str] | None
) -> tuple[Strip, NearestRod | None]:
    """The strip; a refusal says whether the file's digits decide it, and ends with the command that would work."""
    near = None
    say_step("looking for the nearest curve that can be made" if spec.may_change else "finding the widths")
    try:
        found = spec.rod_spec.solve()
        near = found if isinstance(found, NearestRod) else None
        return spec.make(found), near
    except (NotRealizable, NotConvergedError, InputError) as problem:
        told: ElasticaError = problem
        if isinstance(problem, NotRealizable):
            doubt = undecided_by_rounding(drawn, False, spec.smooth, spec.supports)
            if doubt:
                told = InputError(f"{doubt} As it stands: {problem}")
        if near is not None and isinstance(problem, NotConvergedError):
            told = NotMetError(str(problem))
        told.add_note("" if cure is None else cure(spec))
        raise told from problem.__cause__


def _write_files(
    made: Strip,
    spec: StripSpec,
    name: str,
    chosen: Mapping[str, Any],
    cutting: Cutting,
    near: NearestRod | None,
    verdict: Stability,
    joints: tuple[str, str],
) -> tuple[list[Path], dict[str, Any]]:
    """Write every file that the installed libraries allow: all of them, or after any error none.

    Ends of a piece between corners are engraved with the names of the `joints`.
    """
    # R12 has no header for its unit, so the name says it
    names = {"dxf": f"{name}-mm.dxf" if cutting.version == "R12" else f"{name}.dxf"}
    names |= {kind: f"{name}.{kind}" for kind in ("svg", "json")}
    if len(made.layers) > 1:
        names |= {
            f"backing {kind}": names[kind].replace(name, f"{name}-backing", 1) for kind in ("dxf", "svg")
        }
    names |= {"png": f"{name}.png"} if find_spec("matplotlib") else {}
    names |= {"pdf": f"{name}.pdf"} if chosen["paper"] else {}
    names |= {"step": f"{name}.step"} if find_spec("OCP") else {}
    names |= {"glb": f"{name}.glb"} if chosen["glb"] else {}
    drawn_in, folder = chosen["curve"], chosen["output"]
    written = [folder / file for file in names.values()]
    if any(path.exists() and path.samefile(drawn_in) for path in written):
        raise InputError(f"{drawn_in} holds the drawn curve and is kept: name another folder, e.g. -o out")
    joined = spliced(made, spec.shop)
    drawings = made.drawings() if joined is None else (joined.drawing,)
    if any(joints) and joined is None:
        base, cuts = drawings[0], (*made.holes, made.outline)
        marks = end_numbers(made.width, cuts, base.texts, joints)
        drawings = (replace(base, texts=(*base.texts, *marks)), *drawings[1:])
    with write_together(folder, names.values(), force=chosen["force"]) as workshop:
        for layer, drawing, prefix in zip(made.layers, drawings, ("", "backing "), strict=False):
            called = replace(drawing, name=f"{name}-{prefix}".rstrip("- "))
            options = cutting.options(layer.sheet)
            save(called, workshop / names[f"{prefix}dxf"], version=cutting.version, **options)
            save(called, workshop / names[f"{prefix}svg"], **options)
        if "png" in names:
            from elastica_cad.plot.canvas import save_figure
            from elastica_cad.plot.strip_pictures import strip_sheet

            drawn_curve = None if near is None else near.target
            save_figure(strip_sheet(made, wish=drawn_curve), workshop / names["png"])
        if chosen["paper"]:
            from elastica_cad.plot.template_pages import save_template

            save_template(replace(drawings[0], name=name), workshop / names["pdf"], paper=chosen["paper"])
        if "step" in names:
            from elastica_cad.kernel.step_files import write_strip_step

            write_strip_step(made, workshop / names["step"], frame=spec.frame)
        if chosen["glb"]:
            from elastica_cad.kernel.glb_files import write_glb
            from elastica_cad.kernel.step_files import model_shapes

            frame = spec.frame or Frame(y_axis=(0.0, 0.0, 1.0))  # upright, as screens show it
            placed = Placed(made, frame.origin, frame.x_axis, frame.y_axis)
            write_glb(model_shapes(Model((placed,), name)), workshop / names["glb"], name=name)
        report = report_strip(
            made, name=name, files=names, near=near, stability=verdict, smoothing=spec.rod_spec.smoothing
        )
        report |= {"joints": joints} if any(joints) else {}
        (workshop / names["json"]).write_text(json.dumps(report, indent=1) + "\n", encoding="utf-8")
    return written, report


def _tell(made: Strip, near: NearestRod | None, verdict: Stability, written: list[Path]) -> None:
    """What was made, in a few lines."""
    rod, (low, high) = made.rod, made.width.extremes
    say(f"{made.label or 'strip'}: {rod.length:.2f} mm long, {low:.2f} to {high:.2f} mm wide, "
               f"stiffness ratio {rod.ratio:.4g}, {made.mass:.3g} g")  # fmt: skip
    say(f"largest strain {100 * made.max_strain:.2f} % at {made.max_strain_at:.1f} mm "
               f"({made.sheet.name} bears {100 * made.sheet.max_strain:.2f} %)")  # fmt: skip
    if near is not None:
        say(f"largest distance from the drawn curve {near.deviation:.2f} mm. {near.status.value}")
        for advice in islice(advise(near), MOST_ADVICE):
            say(advice)
    said = f"margin {verdict.margin:.3g} ({verdict.word}): {verdict.meaning}"
    if verdict.stable:
        say(f"stable, {said}")
    else:
        warn(f"Warning: {said}. --stable finds the nearest that stays.")
    sideways = made.sideways
    if sideways is not None and sideways.word in ("unstable", "low"):
        warn(f"Warning: sideways margin {sideways.margin:.3g} ({sideways.word}): {sideways.meaning}.")
    elif sideways is not None:
        say(f"sideways {sideways.word}: {sideways.meaning}")
    with suppress(NotConvergedError):
        if made.crept is not None:
            say(str(made.crept))
    with suppress(NotConvergedError):
        say(str(made.held()))
    for warning in made.warnings:
        if near is not None and warning == near.status.value:
            continue  # told with the distance
        warn(f"Warning: {warning}")
    for kind, package in (("png", "matplotlib"), ("step", "build123d")):
        if not any(path.suffix == f".{kind}" for path in written):
            say(f"no .{kind}: it needs {package} ({how_to_install(package)})")
    wrote(written)
