"""`elastica bow`: a rod or strip bent by a cord between its ends."""

from collections.abc import Iterable, Iterator, Mapping
from functools import partial
from math import isclose
from pathlib import Path
from typing import Any

import click
import numpy as np

from elastica_cad._values import plain_data
from elastica_cad.cli.element_options import LOADS, element_options, elements_of
from elastica_cad.cli.options import (
    LENGTH,
    Chosen,
    given_of,
    output_options,
    refuse_idle,
    requested_sheet,
    sheet_options,
    smooth_option,
)
from elastica_cad.cli.requested_curves import curve_options, requested_curves, which_options
from elastica_cad.cli.strip_options import typed_change
from elastica_cad.cli.suggestions import suggest_later
from elastica_cad.cli.voice import answer, say, say_rows, wrote
from elastica_cad.errors import Force, InputError, Length, Strain, number_text
from elastica_cad.files import save
from elastica_cad.form_finding.limits import FAR_SHARE, Limits
from elastica_cad.formats.json_curves import curves_json
from elastica_cad.formats.write_files import File, text_file, write_files
from elastica_cad.geometry.plane_points import norm
from elastica_cad.kit.kit import can_draw
from elastica_cad.mechanics.cross_sections import RoundLaw
from elastica_cad.mechanics.rod import csv_text
from elastica_cad.mechanics.sheets import ROD_KIND, Sheet, known_rods
from elastica_cad.mechanics.stability import SAFE_MARGIN, stability
from elastica_cad.model.batten import bench_drawing
from elastica_cad.model.bows import ENDS, SHORTER, Bow, bow, rise_of, room_for_hole
from elastica_cad.report_rows import Row, in_order, printed_table, warning_row
from elastica_cad.strip.outline import Tab
from elastica_cad.strip.strip_spec import StripSpec
from elastica_cad.strip.summary import cut_rows, farthest_move, load_rows, size_row, strain_rows
from elastica_cad.strip.travel import Travel

MPA_PER_GPA = 1000.0


class Diameters(click.ParamType):  # type: ignore[type-arg]  # no generic class before click 8.2
    """Diameter of a round rod, or its least and largest diameter: "8", "6:8", "1/4in:5/16in"."""

    name = "diameters"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """Return the least and the largest diameter, mm."""
        least, _, largest = str(value).partition(":")
        low = LENGTH.convert(least, param, ctx)
        return low, LENGTH.convert(largest, param, ctx) if largest else low


class Shortening(click.ParamType):  # type: ignore[type-arg]  # no generic class before click 8.2
    """Percentage or length of a cord: "5", "5%", "50mm"."""

    name = "shortening"

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> Any:
        """Return (fraction, 0) for a percentage, or (0, length in mm) for a length."""
        try:
            return float(str(value).removesuffix("%")) / 100, 0.0
        except ValueError:
            pass
        try:
            return 0.0, LENGTH.convert(value, param, ctx)
        except click.BadParameter:
            self.fail(f"{value!r} is neither a percentage nor a length. Write 5 or 50mm.", param, ctx)


@click.command("bow")
@curve_options
@which_options
@click.option(
    "--rod",
    type=Diameters(),
    metavar="DIAMETER|LEAST:LARGEST",
    help="Round rod: its diameter, or the limits of a taper such as 6:8.",
)
@sheet_options(
    required=False,
    use="Material, for forces in newtons and the strain; with --max-width, the sheet of a strip",
)
@click.option("--max-width", type=LENGTH, metavar="MM", help="Largest width of a strip cut from the sheet.")
@click.option(
    "--min-width",
    type=LENGTH,
    metavar="MM",
    help="Least width of the strip; equal to --max-width for a strip of constant width.",
)
@click.option(
    "--hole",
    type=LENGTH,
    default=0.0,
    metavar="MM",
    help="Diameter of the hole in the strip for the cord, at each end of the cord; 0 for none. The "
    "tabs are outside the holes.",
)
@smooth_option
@click.option(
    "--nearest", is_flag=True, help="Change the curve as little as possible, for a varying section."
)
@click.option(
    "--shorter",
    type=Shortening(),
    multiple=True,
    metavar="PERCENT|LENGTH",
    help="Row of the table, with the cord shorter by this percentage, or by this length with its "
    "unit, such as 50mm; repeatable; replaces the default rows  [default: 2 5 10 20]",
)
@element_options(LOADS)
@output_options
def bow_command(curve: Path, **chosen: Any) -> None:
    """Find the rod or strip that a cord bends into a curve.

    The results are its length, the cord, its pull and the end angles. A rod or strip of constant section
    becomes the even bow with the end points and the length of CURVE; its distance from CURVE is reported. A rod
    within limits, or a strip with --max-width alone, gets the taper that bends exactly into CURVE. CURVE must
    then run straight at both ends. A table lists pull, rise, strain and safety for shorter cords. Writes
    NAME-bow.csv (that table), NAME-bow.json, NAME-bow.png (needs matplotlib), and for a taper or a strip the
    drawing NAME-bow.dxf and NAME-bow.svg. The weight of the bow is neglected, unless --point-mass or --point-force
    loads the bow: the ends then stand at the distance of the cord, and y is upward.

    \b
      elastica bow arch.dxf --rod 8                                   pull of glass and carbon rods
      elastica bow arch.dxf --rod 8 --sheet gfrp-1 -o out             newtons and safety
      elastica bow arch.dxf --rod 8 --sheet gfrp-1 --point-mass 200 1kg   sag and safety under a load
      elastica bow arch.dxf --rod 6:8 --sheet gfrp-1 --nearest        a tapered rod
      elastica bow arch.dxf --sheet pom-2 --max-width 20 --nearest    a strip
    """
    (requested,) = requested_curves(curve, chosen["unit"], chosen["number"], chosen["layer"])
    sheet, fields = material_and_section(chosen)
    drawn = requested.bendable(fields["smooth"]) if "smooth" in fields else requested.curve
    near = fields | room_for_hole(chosen["hole"], sheet, **fields)
    suggest_later(lambda _: StripSpec(drawn, sheet, supports=ENDS, **near), typed_change, ["nearest"])
    result = bow(drawn, sheet, label=requested.label, hole=chosen["hole"], **fields)
    # the option may give fractions or lengths of the cord; the other number of each pair is 0
    fractions = [0.0, *sorted({part + mm / result.cord for part, mm in chosen["shorter"]} or SHORTER)]
    shorter = result.shortened(fractions)
    in_newtons = chosen["sheet"] is not None
    loads = elements_of(chosen, LOADS)
    under = result.under(loads) if loads else None
    loaded = under and _loaded_report(result, under)
    table: dict[str, Any] = {
        "shorter_percent": [100 * fraction for fraction in fractions],
        "cord_mm": norm(shorter.end),
        "pull_N" if in_newtons else "pull_N_per_GPa": norm(shorter.end_force),
        "rise_mm": [rise_of(rod) for rod in shorter.rods],
        "strain_percent": 100 * shorter.strain,
        **({"safety": shorter.safety} if in_newtons else {}),
        "margin": shorter.margin,
    }
    report = {
        "length_mm": Length(result.length), "cord_mm": Length(result.cord), "rise_mm": Length(result.rise),
        "pull_N": Force(result.pull) if in_newtons else None,
        "pull_N_per_GPa": Force(result.pull * MPA_PER_GPA / sheet.youngs_modulus),
        "end_angles": result.end_angles.tolist(), "deviation_mm": Length(result.deviation),
        "ratio": result.strip.rod.ratio, "max_strain": Strain(result.strip.max_strain),
        "strain_limit": Strain(result.strip.strain_limit) if in_newtons else None,
        "margin": stability(result.strip.rod).margin, "warnings": list(result.strip.warnings) if in_newtons else [],
        "shorter": plain_data(table), "loaded": loaded,
    }  # fmt: skip
    written = _write(result, shorter, table, report, requested.name, chosen)
    answer({"bow": report})
    say_rows(*in_order(_rows(result, report)))
    if under and loaded:
        say_rows(*load_rows(under.rods[0]), *_loaded_rows(loaded))
    _print_table(table)
    contents = {".csv": "the table", ".json": "all numbers and the curve", ".dxf": "drawing at full size"}
    wrote(written, contents)


def material_and_section(chosen: Chosen) -> tuple[Sheet, dict[str, Any]]:
    """Return the material and the fields of `bow`.

    Without --sheet, the modulus is 1 GPa, for forces in N per GPa.
    """
    needs = dict.fromkeys(("thickness", "max_width", *LOADS), ("sheet",))
    refuse_idle(needs | dict.fromkeys(("hole", "min_width"), ("max_width",)))
    rod, widest, least = chosen["rod"], chosen["max_width"], chosen["min_width"]
    if (rod is None) == (widest is None):
        raise InputError(
            "The section of the bow is missing. Add --rod DIAMETER, or --max-width MM for a strip."
        )
    fields: dict[str, Any] = given_of(chosen, ["smooth"]) | (
        {"limits": Limits(margin=SAFE_MARGIN)} if chosen["nearest"] else {}
    )
    if fields and (widest == least if rod is None else rod[0] == rod[1]):
        raise InputError("--nearest and --smooth apply to a varying section only. Leave out these options.")
    if rod is None:
        sheet = requested_sheet(chosen)
        if sheet.kind == ROD_KIND:
            raise InputError(
                "{sheet} is a rod, so no strip can be cut from it. Use --rod DIAMETER instead of --max-width.",
                sheet=sheet.name,
            )
        return sheet, fields | {"max_width": widest, "min_width": least}
    # without a material, only forces per GPa are reported, so any density and strain limit will do
    sheet = (
        Sheet("a rod", rod[1], MPA_PER_GPA, density=1000.0, max_strain=0.4)
        if chosen["sheet"] is None
        else requested_sheet(chosen)
    )
    return sheet, fields | {"section": RoundLaw(sheet, *rod), "ends": (Tab(0.0), Tab(0.0))}


def _rows(result: Bow, report: Mapping[str, Any]) -> list[Row]:
    """Return the rows of the report.

    Without a Young's modulus, the force of the cord is stated for known kinds of rods.
    """
    strip, pull = result.strip, report["pull_N"]
    angles = dict.fromkeys(f"{angle:.1f}" for angle in np.degrees(np.abs(result.end_angles)))
    rods = known_rods() if pull is None else {}
    per_rod = [f"{_newtons(result.pull, rod):.2g} as a {name}" for name, rod in rods.items()]
    force = pull or f"{', '.join(per_rod)} ({report['pull_N_per_GPa']} per GPa of Young's modulus)"
    shape = f"rise {report['rise_mm']:.1f}; ends at {' and '.join(angles)} degrees to the cord"
    verdict = stability(strip.rod)
    rows = [
        Row("Size", f"{report['length_mm']:.1f} long, {strip.breadth('.1f')}") if rods else size_row(strip),
        _curve_row(result, report["deviation_mm"]),
        Row("Cord", f"{report['cord_mm']:.1f} long, pulls with {force}; {shape}"),
        Row("Stability", f"{verdict.rating} in its plane; sideways not computed")
        if verdict.rating == "stable"
        else warning_row(verdict.rating, "Stability"),
    ]
    if rods:
        limits = [f"a {name} allows {Strain(rod.max_strain):.2f}" for name, rod in rods.items()]
        largest = f"{report['max_strain']:.2f} at {strip.max_strain_at:.0f} mm from the start"
        return [*rows, Row("Strain", "; ".join([largest, *limits]))]
    warnings = [warning_row(text) for text in strip.warnings if text not in strip.strain_warnings]
    return [*rows, *strain_rows(strip), *cut_rows(result.pattern), *warnings]


def _loaded_report(result: Bow, loaded: Travel) -> dict[str, Any]:
    design = result.strip.rod
    distance, at, direction = farthest_move(design, loaded.rods[0])
    # the cord pulls with the part of the end force along the line between the ends
    return {
        "moved_mm": Length(distance), "moved_at_mm": Length(at), "moved_to": direction,
        "pull_N": Force(-loaded.end_force[0] @ design.chord / result.cord),
        "max_strain": Strain(loaded.strain[0]), "safety": float(loaded.safety[0]),
        "margin": loaded.verdicts[0].margin, "warnings": list(loaded.warnings),
    }  # fmt: skip


def _loaded_rows(loaded: Mapping[str, Any]) -> Iterator[Row]:
    yield Row(
        "Movement",
        f"under the loads, the bow moves by at most {loaded['moved_mm']:.2g}: the point "
        f"{loaded['moved_at_mm']:.0f} along it, {loaded['moved_to']}",
    )
    yield (
        Row("Cord", f"under the loads, pulls with {loaded['pull_N']}")
        if loaded["pull_N"] > 0
        else warning_row(
            "slack under the loads, because the ends move towards each other. Reduce the loads.", "Cord"
        )
    )
    safety = number_text(loaded["safety"])
    yield Row("Strain", f"under the loads, at most {loaded['max_strain']}, safety {safety}")
    yield from map(warning_row, loaded["warnings"])


def _curve_row(result: Bow, far: Length) -> Row:
    """Return the row on the distance of the bow from the drawn curve, a warning if it is large."""
    # only a rod has a section here, which prescribes its diameter
    noun = "strip" if result.strip.layout.size is None else "rod"
    even = (
        f"; a {noun} of constant section cannot follow it exactly"
        if isclose(result.strip.rod.ratio, 1)
        else ""
    )
    text = f"the bent {noun} is at most {far} from the drawn curve{even}"
    if far <= FAR_SHARE * result.length:
        return Row("Curve", text)
    return warning_row(f"{text}. Draw a curve that is more like an arch.", "Curve")


def _print_table(table: dict[str, Any]) -> None:
    """Print the table. Without a sheet, the pull of a rod of each known material replaces the pull per GPa.

    A pull, or the safety with a sheet, is marked if the strain is above the limit of the material.
    """
    columns: dict[str, Any] = {}
    for name, values in table.items():
        if name == "pull_N_per_GPa":
            for material, rod in known_rods().items():
                pulls = [number_text(_newtons(pull, rod)) for pull in values]
                over = np.greater(table["strain_percent"], 100 * rod.max_strain)
                columns[f"{material.removeprefix('pultruded ')}_N"] = _marked(pulls, over)
        elif name == "safety":
            columns[name] = _marked((f"{value:.2f}" for value in values), np.less(values, 1))
        elif name == "shorter_percent":
            columns["cord_shorter_percent"] = [f"{value:g}" for value in values]
        elif name != "margin":
            columns[name] = values
    lines = [*printed_table(columns)]
    say(f"If you shorten the cord{' (!: above the strain limit)' if '!' in ''.join(lines) else ''}:", *lines)


def _marked(cells: Iterable[str], over: Iterable[bool]) -> list[str]:
    return ["! " * bool(marked) + cell for cell, marked in zip(cells, over, strict=True)]


def _newtons(pull: float, rod: Sheet) -> Force:
    """Return the pull of a rod of a known material from the pull, N, for a Young's modulus of 1 GPa."""
    return Force(pull * rod.youngs_modulus / MPA_PER_GPA)


def _write(
    result: Bow,
    shorter: Travel,
    table: dict[str, Any],
    report: dict[str, Any],
    name: str,
    chosen: Chosen,
) -> tuple[Path, ...]:
    """Write the table, the report, the drawings and, if matplotlib is installed, the picture.

    A round rod has no drawing.
    """
    stem, strip = f"{name}-bow", result.strip
    files = [
        text_file(f"{stem}.csv", csv_text(table)),
        text_file(f"{stem}.json", curves_json([strip.rod.curve], **report)),
    ]
    rod = chosen["rod"]
    if rod is None or rod[0] < rod[1]:
        drawing = bench_drawing(strip) if rod else result.pattern.drawing()
        files += [File(f"{stem}.{kind}", partial(save, drawing)) for kind in ("dxf", "svg")]
    if can_draw():
        from elastica_cad.plot.bow_picture import bow as draw_bow
        from elastica_cad.plot.canvas import save_figure

        files.append(File(f"{stem}.png", lambda path: save_figure(draw_bow(result, shorter), path)))
    return write_files(files, chosen["output"], force=chosen["force"])
