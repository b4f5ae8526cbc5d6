"""`elastica bow`: a rod or strip that is held bent by a cord between its ends."""

from functools import partial
from pathlib import Path
from typing import Any

import click
import numpy as np

from elastica_cad.cli.options import (
    LENGTH,
    given_of,
    join_options,
    output_options,
    requested_sheet,
    sheet_options,
    smooth_option,
)
from elastica_cad.cli.requested_curves import RequestedCurve, curve_options, requested_curves, which_options
from elastica_cad.cli.strip_options import typed_change
from elastica_cad.cli.suggestions import suggest_later
from elastica_cad.cli.voice import answer, say_row, say_table, wrote
from elastica_cad.errors import InputError
from elastica_cad.files import save
from elastica_cad.formats.write_files import File, write_files, write_json, write_text
from elastica_cad.forming.limits import FAR_SHARE, Limits
from elastica_cad.kit.kit import can_draw
from elastica_cad.mechanics.rod import csv_text
from elastica_cad.mechanics.sheets import Sheet
from elastica_cad.mechanics.stability import stability
from elastica_cad.mechanics.stiffness_law import RoundLaw
from elastica_cad.model.batten import bench_drawing
from elastica_cad.model.bows import ENDS, SHORTER, Bow, bow, rise_of
from elastica_cad.report_rows import Row, in_order, warning_row
from elastica_cad.strip.outline import Tab
from elastica_cad.strip.strip_spec import StripSpec
from elastica_cad.strip.summary import size_row, strain_rows
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
        """Return the fraction and the length in mm, of which one is 0."""
        try:
            return float(str(value).removesuffix("%")) / 100, 0.0
        except ValueError:
            pass
        try:
            return 0.0, LENGTH.convert(value, param, ctx)
        except click.BadParameter:
            self.fail(f"{value!r} is neither a percentage nor a length. Write 5 or 50mm.", param, ctx)


_STOCK = (
    curve_options,
    which_options,
    click.option("--rod", type=Diameters(), metavar="DIAMETER|LEAST:LARGEST",
                 help="Round rod: its diameter, or the limits of a taper such as 6:8."),
    sheet_options(required=False, use="Material, for forces in newtons and the strain; with --max-width, "
                                      "the sheet of a strip"),
    click.option("--max-width", type=LENGTH, metavar="MM", help="Largest width of a strip cut from the sheet."),
    click.option("--min-width", type=LENGTH, metavar="MM",
                 help="Least width of the strip; equal to --max-width for a strip of constant width."),
    smooth_option,
    click.option("--nearest", is_flag=True, help="Change the curve as little as possible, for a varying section."),
    click.option("--shorter", type=Shortening(), multiple=True, metavar="PERCENT|LENGTH",
                 help="Add a row to the table, with the cord shorter by this percentage, or by this length with "
                      "its unit, such as 50mm; repeatable  [default: 2 5 10 20]"),
    output_options,
)  # fmt: skip


@click.command("bow")
@join_options(*_STOCK)
def bow_command(curve: Path, **chosen: Any) -> None:
    """Find the rod or strip that a cord between its ends bends into CURVE: length, cord, pull, end angles.

    A rod or strip of constant section becomes the even bow with the end points and the length of CURVE; its
    distance from CURVE is reported. A rod within limits, or a strip with --max-width alone, gets the taper that
    bends exactly into CURVE. CURVE must then run straight at both ends. A table lists pull, rise, strain and safety
    for shorter cords. Writes NAME-bow.csv (that table), NAME-bow.json, NAME-bow.png (needs matplotlib), and for a
    taper or a strip the drawing NAME-bow.dxf and NAME-bow.svg. The weight of the bow is neglected.

    \b
      elastica bow arch.dxf --rod 8                                   any material: pull per GPa
      elastica bow arch.dxf --rod 8 --sheet gfrp-1 -o out             newtons and safety
      elastica bow arch.dxf --rod 6:8 --sheet gfrp-1 --nearest        a tapered rod
      elastica bow arch.dxf --sheet pom-2 --max-width 20 --nearest    a strip
    """
    (requested,) = requested_curves(curve, chosen["unit"], chosen["number"], chosen["layer"])
    sheet, fields = _material(chosen)
    made = _made(requested, sheet, fields)
    shares = [0.0, *sorted({part + mm / made.cord for part, mm in chosen["shorter"]} or SHORTER)]
    shorter = made.shortened(shares)
    known = chosen["sheet"] is not None
    table = _table(shares, shorter, known=known)
    report = {
        "length_mm": made.length, "cord_mm": made.cord, "rise_mm": made.rise,
        "pull_N": made.pull if known else None,
        "pull_N_per_GPa": made.pull * MPA_PER_GPA / sheet.youngs_modulus, "end_angles": made.end_angles.tolist(),
        "deviation_mm": made.deviation, "ratio": made.strip.rod.ratio, "max_strain": made.strip.max_strain,
        "strain_limit": made.strip.strain_limit if known else None,
        "margin": stability(made.strip.rod).margin, "warnings": list(made.strip.warnings) if known else [],
        # JSON has no infinity: the safety of a straight rod becomes null
        "shorter": {name: [v if np.isfinite(v) else None for v in values] for name, values in table.items()},
    }  # fmt: skip
    written = _write(made, shorter, table, report, requested.name, chosen)
    answer({"bow": report})
    for row in in_order(_rows(made, known=known)):
        say_row(row)
    _print_table(table)
    wrote(written)


def _made(requested: RequestedCurve, sheet: Sheet, fields: dict[str, Any]) -> Bow:
    """Return the bow. If the curve is refused, suggest the nearest curve."""
    curve = requested.bendable(fields["smooth"]) if "smooth" in fields else requested.curve

    suggest_later(lambda _: StripSpec(curve, sheet, supports=ENDS, **fields), typed_change, ["nearest"])
    return bow(curve, sheet, label=requested.label, **fields)


def _material(chosen: dict[str, Any]) -> tuple[Sheet, dict[str, Any]]:
    """Return the sheet and the fields of the request. Without --sheet, the material has a modulus of 1 GPa."""
    rod, widest, least = chosen["rod"], chosen["max_width"], chosen["min_width"]
    if (rod is None) == (widest is None):
        raise InputError(
            "The section of the bow is missing. Add --rod DIAMETER, or --max-width MM for a strip."
        )
    fields: dict[str, Any] = given_of(chosen, ["smooth"]) | (
        {"limits": Limits()} if chosen["nearest"] else {}
    )
    if fields and (widest == least if rod is None else rod[0] == rod[1]):
        raise InputError("--nearest and --smooth apply to a varying section only. Leave out these options.")
    if rod is None:
        if chosen["sheet"] is None:
            raise InputError("--max-width needs a sheet, which sets the thickness. Add --sheet NAME.")
        return requested_sheet(chosen), fields | {"max_width": widest, "min_width": least}
    if least is not None:
        raise InputError("--min-width applies to strips only. Use --rod LEAST:LARGEST.")
    sheet = (
        Sheet("a rod", rod[1], MPA_PER_GPA, density=1.0, max_strain=1.0)
        if chosen["sheet"] is None
        else requested_sheet(chosen)
    )
    return sheet, fields | {"law": RoundLaw(sheet, *rod), "ends": (Tab(0.0), Tab(0.0))}


def _rows(made: Bow, *, known: bool) -> list[Row]:
    strip, (start, end) = made.strip, np.degrees(made.end_angles)
    force = f"{made.pull:.3g} N" if known else f"{made.pull:.3g} N per GPa of Young's modulus"
    shape = f"rise {made.rise:.1f} mm; ends at {start:.1f} and {end:.1f} degrees"
    verdict = stability(strip.rod)
    rows = [
        size_row(strip) if known else Row("Size", f"{made.length:.1f} mm long, {strip.breadth('.1f')}"),
        _curve_row(made),
        Row("Cord", f"{made.cord:.1f} mm long, pulls with {force}; {shape}"),
        Row("Stability", f"{verdict.rating} in its plane")
        if verdict.rating == "stable"
        else warning_row(verdict.rating, "Stability"),
    ]
    if not known:
        return [*rows, Row("Strain", f"{100 * strip.max_strain:.2f} % at {strip.max_strain_at:.0f} mm")]
    reported = {*strip.strain_warnings}
    others = [warning_row(text) for text in strip.warnings if text not in reported]
    return [*rows, *strain_rows(strip), *others]


def _curve_row(made: Bow) -> Row:
    """Return the row with the distance from the drawn curve. It is a warning if this exceeds `FAR_SHARE`."""
    text = f"at most {made.deviation:.3g} mm from the drawn curve"
    if made.deviation <= FAR_SHARE * made.length:
        return Row("Curve", text)
    return warning_row(f"{text}. Draw a curve that is more like an arch.", "Curve")


def _table(shares: list[float], shorter: Travel, *, known: bool) -> dict[str, Any]:
    """Return the columns of the table: cord, pull, rise, strain and safety.

    Pull and safety require a known material.
    """
    cord = np.hypot(*shorter.end.T)
    return {
        "shorter_percent": [100 * share for share in shares],
        "cord_mm": cord.tolist(),
        "pull_N" if known else "pull_N_per_GPa": np.hypot(*shorter.end_force.T).tolist(),
        "rise_mm": [rise_of(rod) for rod in shorter.rods],
        "strain_percent": (100 * shorter.strain).tolist(),
        **({"safety": shorter.safety.tolist()} if known else {}),
        "margin": shorter.margin.tolist(),
    }


def _print_table(table: dict[str, Any]) -> None:
    formats = {
        "shorter_percent": "g",
        "cord_mm": ".1f",
        "rise_mm": ".1f",
        "strain_percent": ".2f",
        "safety": ".2f",
    }
    say_table(
        {
            name.replace("_per_", "/").replace("_percent", " %").replace("_", " "): [
                f"{value:{formats.get(name, '.3g')}}" for value in values
            ]
            for name, values in table.items()
            if name != "margin"
        }
    )


def _write(
    made: Bow,
    shorter: Travel,
    table: dict[str, Any],
    report: dict[str, Any],
    name: str,
    chosen: dict[str, Any],
) -> tuple[Path, ...]:
    stem, strip = f"{name}-bow", made.strip
    files = [
        File(f"{stem}.csv", lambda path: write_text(path, csv_text(table))),
        File(f"{stem}.json", lambda path: write_json(path, report)),
    ]
    rod = chosen["rod"]
    if rod is None or rod[0] < rod[1]:
        drawing = bench_drawing(strip) if rod else strip.drawing()
        files += [File(f"{stem}.{kind}", partial(save, drawing)) for kind in ("dxf", "svg")]
    if can_draw():
        from elastica_cad.plot.bow_picture import bow as draw_bow
        from elastica_cad.plot.canvas import save_figure

        files.append(File(f"{stem}.png", lambda path: save_figure(draw_bow(made, shorter), path)))
    return write_files(files, chosen["output"], force=chosen["force"])
