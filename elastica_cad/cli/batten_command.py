"""`elastica batten`: taper a batten so that it bends deepest at the requested position when its ends are
pressed.
"""

from functools import partial
from pathlib import Path
from typing import Any

import click
import numpy as np

from elastica_cad._text import file_word
from elastica_cad._types import FloatArray
from elastica_cad._units import MM_PER_INCH
from elastica_cad._values import plain_data
from elastica_cad.cli.options import (
    LENGTH,
    POINT,
    Chosen,
    output_options,
    refuse_idle,
    requested_sheet,
    sheet_options,
)
from elastica_cad.cli.voice import answer, say, say_rows, wrote
from elastica_cad.errors import InputError, Length, Mass, Share, Strain, rounded_up
from elastica_cad.files import save, step_trouble
from elastica_cad.formats.write_files import File, text_file, write_files, write_json
from elastica_cad.geometry.plane_points import norm
from elastica_cad.kit.kit import can_draw, left_out
from elastica_cad.mechanics.cross_sections import MOST_LEAVES, RoundLaw, ThicknessLaw
from elastica_cad.mechanics.rod import camber_of
from elastica_cad.model.batten import BattenSpec, bench_csv, bench_drawing
from elastica_cad.report_rows import Row, printed_table, warning_row
from elastica_cad.strip.strip import Strip

MOST_STATIONS = 1000


@click.command()
@sheet_options(required=True)
@click.option("--length", type=LENGTH, required=True, metavar="MM", help="Length of the batten.")
@click.option(
    "--camber", type=float, required=True, metavar="PERCENT", help=("Depth of the camber, in % of the chord.")
)
@click.option(
    "--at",
    type=float,
    default=50.0,
    show_default=True,
    metavar="PERCENT",
    help="Position of the deepest point, in % of the chord from the start.",
)
@click.option(
    "--stock",
    type=POINT,
    metavar="WIDTH THICKNESS",
    help=("Width and thickness of the strip, which is planed in thickness."),
)
@click.option(
    "--rod",
    type=LENGTH,
    metavar="DIAMETER",
    help=("Diameter of a round rod instead of a strip; it is turned or sanded."),
)
@click.option(
    "--bore",
    type=float,
    default=0.0,
    metavar="SHARE",
    help=("For a tube: inner diameter divided by outer diameter."),
)
@click.option(
    "--least", type=LENGTH, metavar="MM", help="Least thickness  [default: a quarter of the stock]."
)
@click.option(
    "--full",
    type=float,
    default=0.0,
    show_default=True,
    metavar="PERCENT",
    help="Part of the length at the thick end that keeps the full size, in %; the rest is tapered.",
)
@click.option(
    "--lying",
    type=click.Choice(["up", "down"]),
    help="Include the weight in the design, for a level chord and a bulge in this direction.",
)
@click.option(
    "--weight", is_flag=True, help=("Report also the camber under its own weight with a level chord.")
)
@click.option(
    "--leaves",
    type=click.IntRange(2, MOST_LEAVES),
    metavar="N",
    help=("Glue the strip from N equal plies instead of planing it; the report lists where each ply ends."),
)
@click.option(
    "--stations",
    type=click.IntRange(2, MOST_STATIONS),
    default=11,
    show_default=True,
    metavar="N",
    help="Number of rows of the table, evenly spaced.",
)
@click.option(
    "--every",
    type=LENGTH,
    metavar="MM",
    help=("Distance between rows of the table, instead of their number."),
)
@click.option("--name", default="batten", show_default=True, help="Name of the files.")
@click.option(
    "--paper",
    type=click.Choice(["A4", "A3", "A2", "A1", "A0", "letter", "tabloid"]),
    default="A4",
    show_default=True,
    help="Paper of the print at full size.",
)
@output_options
def batten(**chosen: Any) -> None:
    """Taper a batten that bends to a wanted depth (camber).

    The ends are pinned and pressed together until the camber is reached. The camber, which is the depth of the
    bend, and its place (--at) are in percent of the chord, the distance between the ends of the bent batten. Writes
    NAME.csv (sizes in mm and inch, strain, safety), NAME.svg and NAME.dxf (the side view at full size), NAME.json,
    NAME.pdf (the same on pages; needs matplotlib) and NAME.step (flat and bent; needs build123d or CadQuery). With
    --leaves drawings and bodies show the plies, and NAME.csv is their cut list. A batten for a drawn curve is a
    strip: elastica strip sheer.csv --set 'section = {kind = "thickness", limits = [4, 18], width = 30}'.

    \b
      elastica batten --sheet pom-1 --length 2400 --camber 10 --at 40 --stock 25 8 --least 3 -o out
    """
    spec = BattenSpec(
        chosen["length"],
        chosen["camber"] / 100,
        chosen["at"] / 100,
        _stock(chosen),
        chosen["name"],
        chosen["full"] / 100,
        chosen["lying"],
    )
    stations = _stations(chosen)
    result = spec.make()
    if chosen["leaves"] is None:
        strip, table = result.strip, result.table(stations)
        report = _quantities(strip) | {
            "lying": spec.lying, "warnings": list(strip.warnings), "table": plain_data(table),
        }  # fmt: skip
        if chosen["weight"]:
            report["camber_with_weight"] = {
                side: dict(
                    zip(("camber", "camber_place"), result.camber_with_weight(bulging=side), strict=True)
                )
                for side in ("up", "down")
            }
        s, s_inch, _, _, sizes, inch, strain, safety = table.values()
        name = spec.stock.quantity
        columns: dict[str, Any] = {
            "at_mm": s, "at_inch": s_inch, f"{name}_mm": sizes, f"{name}_inch": inch,
            "strain_percent": 100 * strain, "safety": safety,
        }  # fmt: skip
        size = f"ends {report['chord_mm']:.1f} apart"
        more = chosen["lying"] and f", level under its own weight and bulging {chosen['lying']}"
    else:
        glued = result.of_leaves(chosen["leaves"])
        strip, section = result.strip_of(glued), glued.section
        report = _quantities(strip) | {
            "deviation_mm": Length(glued.deviation), "settled": glued.settled,
            "leaf_thickness_mm": Length(strip.sheet.thickness), "leaf_width_mm": section.width,
            "leaves": [
                {"leaf": name, "start_mm": leaf.start, "end_mm": leaf.end, "length_mm": leaf.length}
                for name, leaf in zip(section.names, glued.leaves, strict=True)
            ],
        }  # fmt: skip
        lengths = np.array([leaf.length for leaf in glued.leaves])
        columns = {
            "ply": section.names, "from_mm": [leaf.start for leaf in glued.leaves],
            "to_mm": [leaf.end for leaf in glued.leaves], "length_mm": lengths, "inch": lengths / MM_PER_INCH,
        }  # fmt: skip
        size = f"{chosen['leaves']} plies of {report['leaf_thickness_mm']:.4g}"
        more = f"; the glued plies are at most {report['deviation_mm']:.2g} from the planed batten"
    written = _write(strip, stations, report, chosen)
    answer({"batten": report})
    if not report.get("settled", True):
        say_rows(
            warning_row(
                "the search for the ends of the plies stopped early; other ends may come nearer to the "
                "planed batten"
            )
        )
    chord, depth, place = report["chord_mm"], report["camber"], report["camber_place"]
    deep = f"{Length(depth * chord):.1f} ({depth:.4g} of the chord)"
    say_rows(
        Row("Size", f"{report['length_mm']:.1f} long, {size}, {report['mass_g']:.4g}"),
        Row("Camber", f"{deep} at {Length(place * chord):.1f} ({place:.4g}) along the chord{more or ''}"),
        *map(warning_row, strip.warnings),
        Row("Force", f"{report['end_force_N']} at each end, pushed towards the other end"),
        Row(
            "Strain",
            f"{report['max_strain']:.2f} at {strip.max_strain_at:.0f} mm; {strip.sheet.name} allows "
            f"{report['strain_limit']:.2f}",
        ),
    )
    say(*printed_table(columns))
    for side, bow in report.get("camber_with_weight", {}).items():
        camber = f"{Share(bow['camber']):.4g} at {Share(bow['camber_place']):.4g} of the chord"
        say_rows(
            Row(
                "Weight",
                f"with its ends level and its bulge {side}, the batten has a camber of {camber} under "
                "its own weight",
            )
        )
    contents = {".csv": "table", ".svg": "drawing", ".dxf": "drawing", ".pdf": "print", ".step": "bodies"}
    wrote(written, contents)
    say(*left_out(pictures=False, paper=True))


def _quantities(strip: Strip) -> dict[str, Any]:
    rod, (depth, place) = strip.rod, camber_of(strip.rod)
    return {
        "length_mm": Length(rod.length), "chord_mm": Length(norm(rod.chord)),
        "camber": Share(depth), "camber_place": Share(place),
        "end_force_N": strip.reactions().sizes[0][0], "mass_g": Mass(strip.mass),
        "max_strain": Strain(strip.max_strain), "strain_limit": Strain(strip.strain_limit),
    }  # fmt: skip


def _stock(chosen: Chosen) -> ThicknessLaw | RoundLaw:
    """Return the section of the batten's stock: a strip of varying thickness, or a rod of varying diameter.

    The least size is a quarter of the largest by default.
    """
    refuse_idle(
        {"bore": ("rod",), "leaves": ("stock",)},
        {"leaves": ("stations", "every", "weight"), "every": ("stations",)},
    )
    sheet, strip, rod = requested_sheet(chosen), chosen["stock"], chosen["rod"]
    if (strip is None) == (rod is None):
        raise InputError(
            "The material of the batten is missing. Add --stock WIDTH THICKNESS for a strip, or --rod DIAMETER."
        )
    largest = rod if strip is None else strip[1]
    least = 0.25 * largest if chosen["least"] is None else chosen["least"]
    # the thinnest place of a stack is one ply
    if chosen["leaves"] is not None:
        least = max(least, largest / chosen["leaves"])
    if strip is not None:
        return ThicknessLaw(sheet, least, largest, width=strip[0])
    return RoundLaw(sheet, least, largest, bore=chosen["bore"])


def _stations(chosen: Chosen) -> FloatArray:
    """Return the arc lengths, mm, of the rows of the table."""
    length, every = chosen["length"], chosen["every"]
    if every is None:
        return np.linspace(0.0, length, chosen["stations"])
    if not length / MOST_STATIONS <= every <= length:
        raise InputError(
            "--every is {every:g}. Choose {least:g} to {length:g}, the length of the batten.",
            every=Length(every),
            least=Length(rounded_up(length / MOST_STATIONS, 3)),
            length=Length(length),
        )
    return np.unique(np.append(np.arange(0.0, length, every), length))


def _write(strip: Strip, stations: FloatArray, report: dict[str, Any], chosen: Chosen) -> tuple[Path, ...]:
    """Write the table, the drawings and, if their libraries are installed, the PDF and the STEP file."""
    name, drawing = file_word(chosen["name"]), bench_drawing(strip, stations)
    files = [
        text_file(f"{name}.csv", bench_csv(strip, stations)),
        *(File(f"{name}.{kind}", partial(save, drawing)) for kind in ("svg", "dxf")),
        File(f"{name}.json", lambda path: write_json(path, report)),
    ]
    if can_draw():
        from elastica_cad.plot.template_pages import save_template

        files.append(File(f"{name}.pdf", partial(save_template, drawing, paper=chosen["paper"])))
    if not step_trouble():
        from elastica_cad.kernel.step_files import write_strip_step

        files.append(File(f"{name}.step", partial(write_strip_step, strip)))
    return write_files(files, chosen["output"], force=chosen["force"])
