"""`elastica strip`: from a drawn curve to the files that a laser cutter needs."""

from collections.abc import Iterable, Mapping, Sequence
from contextlib import suppress
from functools import partial
from itertools import islice
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
from elastica_cad.cli.asking.options import LENGTH, Length, holding_option, join_options, output_options
from elastica_cad.cli.asking.strip_options import spec_from_options, strip_options
from elastica_cad.cli.running.suggestions import (
    MOST_REFUSALS,
    changed_requests,
    first_that_holds,
    first_told,
    option_words,
    suggest_later,
    typed_line,
)
from elastica_cad.cli.running.voice import answer, say, say_step, warn, wrote
from elastica_cad.errors import Change, ElasticaError, NotConvergedError, how_to_install
from elastica_cad.fabrication.drawings.cutting import HoldingTabs
from elastica_cad.fabrication.holding.held_shape import two_digits
from elastica_cad.fabrication.makeability.makeable_strip import compensate_within
from elastica_cad.fabrication.strip_spec import StripSpec
from elastica_cad.files import step_trouble
from elastica_cad.formats.design_files.kit_spec import Cutting
from elastica_cad.formats.reports.strip_report import tell_blank
from elastica_cad.geometry.curves.plane_curve import split_at_corners
from elastica_cad.kit.strip_kit import StripFiles, StripKit, write_strip

STRAYED_SHARE = 3e-4
"""Of the length: a strip that strays more as it is made is told what other widths would do."""

MOST_PIECES = 8
"""Of a curve that is cut at its corners to see whether strips take them."""

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
    click.option("--step/--no-step", default=True,
                 help="Write NAME.step: the flat and the bent strip (needs a CAD kernel)."),
    click.option("--pictures/--no-pictures", default=True, help="Draw NAME.png (needs matplotlib)."),
    click.option("--glb", is_flag=True,
                 help="Write NAME.glb too: the bent strip for browsers, phones and Blender (needs build123d)."),
    output_options,
)  # fmt: skip


def _files(chosen: Mapping[str, Any]) -> StripFiles:
    """Which files the options ask for."""
    width = None if chosen["kerf"] == "sheet" else chosen["kerf"]
    bridges = None if chosen["holding"] is None else HoldingTabs(chosen["holding"])
    cutting = Cutting(width, chosen["curves"], chosen["tolerance"], chosen["dxf_version"], bridges)
    return StripFiles(cutting, chosen["paper"], chosen["glb"], chosen["step"], chosen["pictures"])


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
    curves = asked_curves(
        chosen["curve"],
        chosen["unit"],
        chosen["number"],
        chosen["layer"],
        every=chosen["every"],
        split=chosen["split_corners"],
    )
    reports, wrong, refused = [], 0, 0
    for asked in curves:
        try:
            spec = spec_from_options(asked.curve, asked.name, chosen)
            if len(curves) == 1:
                suggest_later(partial(_suggestion, spec, asked, chosen))
            kit = _made(asked, spec, _files(chosen))
            say_step(f"writing the files of {asked.name}")
            written = write_strip(kit, chosen["output"], force=chosen["force"], kept=asked.path)
            _tell(kit, written)
            reports.append(kit.report)
            wrong += chosen["strict"] and not kit.strip.strain_verdict.allowed
        except ElasticaError as problem:
            if len(curves) == 1 and not chosen["every"]:
                raise
            wrong, refused = wrong + 1, refused + 1
            called, said = asked.drawn.called, str(problem)
            warn(said if called in said else f"{called}: {said}", told=refused <= MOST_REFUSALS)
    answer({"strips": reports})
    if wrong:
        if len(curves) > 1:
            warn(f"{wrong} of {len(curves)} curves made no strip as asked{first_told(refused)}")
        ctx.exit(1)


def _made(asked: AskedCurve, spec: StripSpec, files: StripFiles) -> StripKit:
    """The strip of one curve."""
    say_step("looking for the nearest curve that can be made" if spec.may_change else "finding the widths")
    if not spec.may_change:
        _ = asked.bendable(spec.smooth)
    found = spec.rod_spec.solve()
    return StripKit(spec, found, spec.make(found), asked.name, asked.drawn.joints, files)


def _suggestion(spec: StripSpec, asked: AskedCurve, chosen: Mapping[str, Any], problem: ElasticaError) -> str:
    """The command that makes a strip of this request after all, with the least change."""

    def requests(change: Change) -> Sequence[StripSpec]:
        if change.field == "split_corners":
            pieces = split_at_corners(spec.curve)
            drawn = spec.curve.degree > 1  # straight strips are not what a row of points means
            apart = drawn and 1 < len(pieces) <= MOST_PIECES and not (spec.slots or spec.may_change)
            return [spec.changed(curve=piece) for piece in pieces] if apart else []
        return changed_requests(spec, change)

    if not problem.refusal.changes or _is_taken(asked, chosen):
        return ""
    found = ((change, option_words(change)) for change in problem.refusal.changes)
    return first_that_holds(
        (f"`{typed_line(*words)}`", partial(requests, change)) for change, words in found if words
    )


def _is_taken(asked: AskedCurve, chosen: Mapping[str, Any]) -> bool:
    """Do files stand where this command would write? It is refused then, whatever is changed."""
    folder: Path = chosen["output"]
    there = next(one for one in (folder.absolute(), *folder.absolute().parents) if one.exists())
    if not there.is_dir():
        return True
    names = [folder / f"{asked.name}.{kind}" for kind in ("dxf", "svg", "json", "png", "step")]
    names = [name for name in names if name.exists()]
    return any(name.samefile(asked.path) for name in names) or bool(names and not chosen["force"])


def _tell_compensation(kit: StripKit) -> None:
    """What other widths would leave, where the strip strays more than it needs."""
    made = kit.strip
    if (
        kit.spec.compensate
        or kit.spec.law is not None
        or made.held_deviation <= STRAYED_SHARE * made.rod.length
    ):
        return
    better = compensate_within(made, kit.spec.shop)
    if better.correction is not None and better.held_deviation < made.held_deviation / 2:
        left = two_digits(better.held().expected)
        say(
            f"--compensate makes up for that in the widths: about {left} mm are left, sheet and model included"
        )


def _tell(kit: StripKit, written: Iterable[Path]) -> None:
    """What was made, in a few lines."""
    made, near, verdict = kit.strip, kit.near, kit.stability
    rod = made.rod
    say(f"{made.label or 'strip'}: {rod.length:.2f} mm long, {made.breadth()}, "
               f"stiffness ratio {rod.ratio:.4g}, {made.mass_told}")  # fmt: skip
    say(f"largest strain {100 * made.max_strain:.2f} % at {made.max_strain_at:.1f} mm "
               f"({made.most_strained.name} bears {100 * made.strain_limit:.2f} %)")  # fmt: skip
    if made.backing_side:
        say(made.backing_side)
    if near is not None:
        from elastica_cad.forming.nearest.nearest_record import advise

        say(f"largest distance from the drawn curve {near.deviation:.2f} mm. {near.status.value}")
        for advice in islice(advise(near), MOST_ADVICE):
            say(advice)
    said = f"margin {verdict.margin:.3g} ({verdict.word}): {verdict.meaning}"
    if verdict.stable:
        say(f"stable, {said}")
    else:
        warn(f"Warning: {said}. --stable finds the nearest that stays.")
    if made.sideways.needs_guiding:
        warn(f"Warning: {made.sideways}.")
    else:
        say(str(made.sideways))
    with suppress(NotConvergedError):
        if made.crept is not None:
            say(str(made.crept))
    with suppress(NotConvergedError):
        say(str(made.held()))
        _tell_compensation(kit)
    if made.joint:
        say(made.joint)
    if blank := tell_blank(made):
        say(blank)
    for warning in made.warnings:
        if near is not None and warning == near.status.value:
            continue  # told with the distance
        warn(f"Warning: {warning}")
    if kit.asked.pictures and "png" not in kit.files:
        say(f"no .png: it needs matplotlib ({how_to_install('matplotlib')})")
    if kit.asked.step and "step" not in kit.files:
        say(f"no .step: it needs build123d ({step_trouble()})")
    wrote(written)
    for joint, end in zip(kit.joints, ("starts", "ends"), strict=True):
        if joint:
            say(f"it {end} at the corner {joint}, where the strip with the same number goes on")
