"""`elastica pair`: a part, cut from a sheet, with two drawn curves as rest shapes."""

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Any, ClassVar

import click

from elastica_cad._text import file_word
from elastica_cad.cli.options import (
    Chosen,
    given_of,
    join_options,
    option_of,
    output_options,
    requested_sheet,
    sheet_options,
)
from elastica_cad.cli.requested_curves import RequestedCurve, requested_curves, unit_option
from elastica_cad.cli.settings import parsed_settings, set_option
from elastica_cad.cli.strip_options import with_settings
from elastica_cad.cli.voice import answer, cut_text, say, say_rows, say_step, wrote
from elastica_cad.declared import Option, Record, declared
from elastica_cad.defaults import KERF
from elastica_cad.design.design_file import name_of_files, parse_design
from elastica_cad.design.kit_spec import PairCutting, cutting_keys
from elastica_cad.design.pair_table import cutting_of, pair_of
from elastica_cad.design.records import Reader
from elastica_cad.design.tables import Table, merged
from elastica_cad.errors import InputError, rounded_up
from elastica_cad.files import read_curves
from elastica_cad.formats.source_file import require_file
from elastica_cad.geometry.plane_curve import split_at_corners
from elastica_cad.kit.kit import left_out
from elastica_cad.kit.pair_kit import MadePair
from elastica_cad.mechanics.sheets import Sheet
from elastica_cad.pairs.flexure import Flexure
from elastica_cad.pairs.flexure_spec import FlexureSpec
from elastica_cad.pairs.summary import pair_rows
from elastica_cad.plot.drawing_process import DrawingProcess
from elastica_cad.report_rows import Row, in_order, warning_row

FILE = click.Path(path_type=Path)


@dataclass(frozen=True)
class PairKeys:
    """Options of `elastica pair` that describe the part."""

    BESIDE: ClassVar[Record] = FlexureSpec
    WITHOUT: ClassVar[tuple[str, ...]] = ("first", "second", "sheet")
    cut: Annotated[Any, Option("Settings of cutting files.", group="files", written=PairCutting)] = None


_COMMON_OPTIONS = [entry for entry in declared(FlexureSpec) if entry.option.common and entry.name != "sheet"]


@click.command()
@click.argument("first", type=FILE)
@click.argument("second", type=FILE, required=False)
@join_options(
    click.option("--first", "first_curve", metavar="N|ID", help=("Curve of FIRST, if the file has several: "
                                                                 "number or id.")),
    click.option("--second", "second_curve", metavar="N|ID", help=("Curve of SECOND, or the second curve of "
                                                                   "FIRST: number or id.")),
    unit_option,
    sheet_options(required=False, use="Material, whose thickness is the depth of the part"),
    *(option_of(entry, default=entry.default if entry.kind.name == "choice" else "") for entry in _COMMON_OPTIONS),
    click.option("--ratio", type=float,
                 help="Largest stiffness ratio of the part; 8 is a ratio of 2 in thickness."),
    click.option("--name", help="Name of the files  [default: as FIRST]."),
    option_of(cutting_keys()["kerf"], default=f"{KERF:g}"),
    set_option(PairKeys),
    output_options,
)  # fmt: skip
def pair(**chosen: Any) -> None:
    """Make a part with two rest shapes: a clip, a catch, a stand.

    The shapes are the curves of FIRST and SECOND. Without SECOND, both curves are in FIRST. The part is cut
    flat in its unloaded shape, and its thickness in the plane of the sheet varies along it. If the ends of both
    curves agree in position and direction, the part is bistable and snaps between them; otherwise one end is
    moved between two positions. NAME-holder.dxf is the plate that holds the part. FIRST may also be a design
    file with a table [pair], which names the curves, the sheet and all options.
    """
    path: Path = chosen["first"]
    table = given_of(chosen, (entry.name for entry in _COMMON_OPTIONS))
    table |= {} if chosen["ratio"] is None else {"limits": {"ratio": chosen["ratio"]}}
    table["cut"] = given_of(chosen, ["kerf"])
    settings = with_settings(table, parsed_settings(chosen["settings"], PairKeys))
    cut = settings.pop("cut")
    if path.suffix == ".toml":
        if given_of(chosen, ("second", "first_curve", "second_curve", "unit", "sheet", "thickness")):
            raise InputError(
                "A design file names both curves and the sheet. Leave out the other arguments and options."
            )
        changes = {key: values for key, values in (("pair", settings), ("cut", cut)) if values}
        design = merged(parse_design(require_file(path)), changes)
        spec, cutting = pair_of(design, path, read_curves), cutting_of(design, str(path))
        name = name_of_files(Table(design, str(path), {}), path)
    else:
        spec, name, cutting = _spec_of(chosen, settings), path.stem, cutting_of({"cut": cut})
    name = file_word(chosen["name"] or name)
    # raise the error for an unknown kerf before the long computation
    cut_as = cut_text(cutting.options(Sheet.of(spec.sheet))["kerf"])
    if spec.scale != 1:
        say_rows(Row("Scale", f"both curves are made {spec.scale:g} times as large as read"))
    if matched := spec.matched:
        say_rows(Row("Curves", str(matched)))
    say_step("looking for the rod that rests in both curves")
    _ = spec.pair
    say_step("following it from one state to the other")
    result = MadePair(spec, _made(spec), name, cutting)
    process = click.get_current_context().find_object(DrawingProcess)
    written = result.kit.write(chosen["output"], force=chosen["force"], process=process)
    say_rows(*in_order([*pair_rows(result.part), *map(warning_row, result.warnings)]))
    answer({"pair": result.kit.report})
    wrote(
        written,
        {
            f"{name}.dxf": cut_as,
            f"{name}-holder.dxf": f"holder, {cut_as}",
            f"{name}-holder.stl": "print, holder"
            if result.part.pair.bistable
            else "print, holder without the names of the settings",
        },
    )
    say(*left_out(blocks=(name, f"{name}-holder")))


def _made(spec: FlexureSpec) -> Flexure:
    """Return the part. If it must be enlarged, the error names the needed --scale."""
    try:
        return spec.make()
    except InputError as problem:
        if (share := problem.refusal.values.get("share")) is None:
            raise
        raise InputError(
            "{problem}. Add --scale {scale} to enlarge the curves.",
            problem=problem.refusal, scale=rounded_up(spec.scale * share),
        ) from problem  # fmt: skip


def _spec_of(chosen: Chosen, settings: dict[str, Any]) -> FlexureSpec:
    """Return the request. The states are named as the curves in the file, if these have different names."""
    if chosen["sheet"] is None:
        raise InputError("The sheet is missing. Run elastica pair FIRST SECOND --sheet NAME.")
    first, second = _curves(chosen)
    names = (first.drawn.chosen_name, second.drawn.chosen_name)
    if names[0] != names[1]:
        settings = dict(zip(("first_state", "second_state"), names, strict=True)) | settings
    fields = Reader().given(PairKeys, Table(settings, "", {}))
    return FlexureSpec(first.bendable(None), second.bendable(None), requested_sheet(chosen), **fields)


def _curves(chosen: Chosen) -> tuple[RequestedCurve, RequestedCurve]:
    """Return the two curves: of one file with two curves, of two files, or as chosen."""
    path, unit = chosen["first"], chosen["unit"]
    if chosen["second"] is None and chosen["first_curve"] is None and chosen["second_curve"] is None:
        # both curves may be drawn as one curve with a corner
        curves = requested_curves(path, unit, None, None, every=True, split=split_at_corners, corners=False)
        if len(curves) != 2:
            raise InputError(
                "A part with two states needs two curves, but {path} has {count}. Choose two curves with "
                "--first and --second, or name two files.",
                path=path,
                count=len(curves),
            )
        return curves[0], curves[1]

    def curve_of(file: Path, which: str) -> RequestedCurve:
        how = f"--{which} 1 .. --{which} {{count}}, or --{which} ID"
        (requested,) = requested_curves(file, unit, chosen[f"{which}_curve"], None, corners=False, how=how)
        return requested

    return curve_of(path, "first"), curve_of(chosen["second"] or path, "second")
