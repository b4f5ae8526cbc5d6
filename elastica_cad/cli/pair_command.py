"""`elastica pair`: a part, cut from a sheet, that rests in one drawn curve and in another."""

from pathlib import Path
from typing import Any

import click

from elastica_cad.cli.asking.asked_curves import asked_curves, unit_option
from elastica_cad.cli.asking.options import (
    LENGTH,
    asked_sheet,
    given_of,
    join_options,
    output_options,
    sheet_options,
)
from elastica_cad.cli.asking.settings import PairKeys, parsed_settings, set_option
from elastica_cad.cli.asking.strip_options import with_settings
from elastica_cad.cli.running.voice import answer, say, say_step, warn, wrote
from elastica_cad.errors import InputError
from elastica_cad.fabrication.drawings.cutting import DEFAULT_KERF_MM
from elastica_cad.fabrication.flexure_spec import FlexureSpec
from elastica_cad.files import read_curves
from elastica_cad.formats.design_files.kit_spec import Cutting
from elastica_cad.formats.design_files.pair_table import read_pair
from elastica_cad.formats.design_files.records import Reader
from elastica_cad.formats.design_files.tables import Table
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.kit.pair_kit import PairKit, write_pair

FILE = click.Path(path_type=Path)

_WISHES = (
    click.option("--first", "first_curve", metavar="N|ID", help="Which curve of FIRST, where it holds several."),
    click.option("--second", "second_curve", metavar="N|ID", help="Which curve of SECOND."),
    unit_option,
    sheet_options(required=False, use="Material, whose thickness is the depth of the part"),
    click.option("--match", type=click.Choice(["ends", "shape", "none"]),
                 help="Make both curves equally long: by bending them a little with their ends where they are, by "
                 "scaling, or not at all  [default: ends]."),
    click.option("--free", type=click.Choice(["first", "second"]), help="The state that needs no holding."),
    click.option("--ratio", type=float, help="Largest ratio of stiffness; 8 is a ratio of 2 in thickness."),
    click.option("--objective", type=click.Choice(["thickness", "ratio"]),
                 help="The thickest part that the strain allows, or the most even one  [default: thickness]."),
    click.option("--least-thickness", type=LENGTH, metavar="MM",
                 help="Thinnest place in the plane  [default: the most that the sheet's strain allows]."),
    click.option("--fillet", type=LENGTH, metavar="MM", help="Radius at the roots  [default: 1]."),
    click.option("--push-at", type=LENGTH, metavar="MM", help="Where it is pushed over  [default: its middle]."),
    click.option("--printed", is_flag=True, help="For a printer: 0.9 mm thick at least, not 0.8 as a laser cuts."),
    click.option("--ignore-limits", is_flag=True, help="Make it although it is too thin or touches itself."),
    click.option("--label", metavar="TEXT", help="Engraved on the first pad."),
    click.option("--name", help="What the files are called  [default: as FIRST]."),
    click.option("--kerf", type=LENGTH, default=DEFAULT_KERF_MM, metavar="MM",
                 help=f"Width of the cut  [default: {DEFAULT_KERF_MM:g}]."),
    set_option(PairKeys),
    output_options,
)  # fmt: skip

_OF_SPEC = ("match", "free", "objective", "least_thickness", "fillet", "push_at", "label")


@click.command()
@click.argument("first", type=FILE)
@click.argument("second", type=FILE, required=False)
@join_options(*_WISHES)
def pair(**chosen: Any) -> None:
    """Make a part from a sheet that rests in the curve of FIRST and in that of SECOND: a clip, a catch, a stand.

    The part is cut flat, as it is unloaded, and its thickness in the plane of the sheet varies along it. Where both
    curves have the same ends, directions there included, it is bistable and snaps from one to the other; else its
    end has two settings. A second drawing is the plate that holds it. FIRST may be a design file with a table
    [pair], which says all this.
    """
    path: Path = chosen["first"]
    settings = parsed_settings(chosen["settings"], PairKeys)
    if path.suffix == ".toml":
        if chosen["second"] is not None or chosen["sheet"] is not None:
            raise InputError("a design file names both curves and the sheet: give it alone")
        spec = read_pair(path, read_curves, settings)
    else:
        spec = _asked(chosen, settings)
    name = chosen["name"] or path.stem
    if matched := spec.matched:
        say(str(matched))
    say_step("looking for the rod that rests in both curves")
    _ = spec.pair
    say_step("following it from one state to the other")
    kit = PairKit(spec, spec.make(), name, Cutting(kerf=chosen["kerf"]))
    written = write_pair(kit, chosen["output"], force=chosen["force"])
    _tell(kit)
    answer({"pair": kit.report})
    wrote(written)


def _asked(chosen: dict[str, Any], settings: dict[str, Any]) -> FlexureSpec:
    if chosen["second"] is None or chosen["sheet"] is None:
        raise InputError("a part needs two curves and a sheet: elastica pair FIRST SECOND --sheet NAME")
    table = given_of(chosen, _OF_SPEC) | {flag: True for flag in ("printed", "ignore_limits") if chosen[flag]}
    table |= {} if chosen["ratio"] is None else {"limits": {"ratio": chosen["ratio"]}}
    given = Reader().given(PairKeys, Table(with_settings(table, settings), "", {}))
    return FlexureSpec(_curve(chosen, "first"), _curve(chosen, "second"), asked_sheet(chosen), **given)


def _curve(chosen: dict[str, Any], which: str) -> PlaneCurve:
    (asked,) = asked_curves(chosen[which], chosen["unit"], chosen[f"{which}_curve"], None)
    return asked.bendable(None)


def _tell(kit: PairKit) -> None:
    """What was made, in a few lines."""
    part, pair_ = kit.part, kit.part.pair
    low, high = part.thickness_range
    say(
        f"{kit.name}: {pair_.length:.2f} mm between its pads, {low:.2f} to {high:.2f} mm thick in the plane, "
        f"{part.sheet.thickness:g} mm deep"
    )
    first, second = (100 * one for one in part.strain)
    way = part.travel
    say(
        f"largest strain {first:.2f} % in the first state, {second:.2f} % in the second, "
        f"{100 * float(way.strain.max()):.2f} % on the way "
        f"({part.sheet.name} bears {100 * part.sheet.max_strain:.2f} %)"
    )
    stays = [f"margin {one.margin:.3g} ({one.word})" for one in pair_.stability]
    side = [one.word for one in part.sideways]
    say(f"first state {stays[0]}, second state {stays[1]}; sideways {side[0]} and {side[1]}")
    if pair_.bistable:
        at, _ = part.pushed
        back = part.travel_back
        returns = "" if back is None else f", back {back.largest_force:.3g} N"
        say(f"bistable: pushed at {at:.4g} mm it snaps at {way.largest_force:.3g} N{returns}")
        if way.snap is not None:
            say(
                f"from {way.snap:.3g} mm of travel on it goes by itself; {way.work:.3g} N mm were done by then"
            )
    else:
        say(f"two settings: its end is held with {way.largest_force:.3g} N at most on the way between them")
    say(f"what the model leaves out: it stretches by {part.stretch:.2g} mm at most")
    for warning in part.warnings:
        warn(f"Warning: {warning}.")
