"""`elastica coupon`: draw a test strip of a sheet, or compute and keep the properties of a sheet from its droop."""

from dataclasses import replace
from functools import partial
from math import hypot
from typing import Any

import click

from elastica_cad._text import file_word, quote_words
from elastica_cad.cli.options import LENGTH, POINT, Chosen, given_of, output_options, refuse_idle
from elastica_cad.cli.suggestions import name_program, refuse_extra_words
from elastica_cad.cli.voice import answer, say, say_rows, wrote
from elastica_cad.errors import InputError, Length, note
from elastica_cad.files import save
from elastica_cad.formats.write_files import File, text_file, write_files
from elastica_cad.mechanics.calibration import calibrate_cantilever
from elastica_cad.mechanics.section_limits import OUTCOMES
from elastica_cad.mechanics.sheets import ROD_KIND, Sheet, library_folders, plausible_number, require_flat
from elastica_cad.report_rows import Row, warning_row
from elastica_cad.strip.coupon import coupon_drawing, coupon_overhang

LEAST_DROOP_MM = 10.0
"""Least useful droop, mm. Position and height of the clamp are uncertain by about half a mm."""


@click.command()
@click.argument("name_or_file", metavar="[NAME|FILE]", required=False)
@click.option("--sheet", metavar="NAME|FILE",
              help="The material, or a similar one; for others use --thickness and --density.")  # fmt: skip
@click.option("--overhang", type=LENGTH, metavar="MM", help="Longest free length [default: from the sheet].")
@click.option(
    "--width", type=LENGTH, default=20.0, show_default=True, metavar="MM", help="Width of the coupon."
)
@click.option(
    "--clamp", type=LENGTH, default=40.0, show_default=True, metavar="MM", help="Length of the clamped part."
)
@click.option("--measured", type=POINT, multiple=True, metavar="OVERHANG DROOP",
              help=("A measurement in mm: the free length, and how far its end hangs below the clamp; "
                    "repeatable."))  # fmt: skip
@click.option("--reading-error", type=LENGTH, default=0.5, show_default=True, metavar="MM",
              help="Standard deviation of both measurements.")  # fmt: skip
@click.option("--thickness", type=LENGTH, metavar="MM", help="Measured thickness [default: from the sheet].")
@click.option("--density", type=float, metavar="KG/M3", help="Measured density [default: from the sheet].")
@click.option("--least-radius", type=LENGTH, metavar="MM",
              help="Least radius that left no permanent bend [default: from the largest strain].")  # fmt: skip
@click.option("--grain", type=click.Choice(["along", "across", "none"]),
              help="Direction of the coupon relative to the grain [default: from the sheet].")  # fmt: skip
@click.option("--kind", type=click.Choice([kind for kind in OUTCOMES if kind != ROD_KIND]),
              help="Kind of material, which determines how it breaks [default: from the sheet].")  # fmt: skip
@click.option(
    "--kerf", type=LENGTH, metavar="MM", help="Measured width of the cut [default: from the sheet]."
)
@click.option("--name", help="Name of the measured sheet [default: my-NAME].")
@click.option("--keep", is_flag=True, help="Save the measured sheet in the library for all commands.")
@output_options
def coupon(name_or_file: str | None, **chosen: Any) -> None:
    """Write a test strip of a sheet, or compute the sheet's stiffness.

    NAME or FILE is the sheet, as with --sheet. The test strip (coupon) is written as DXF and SVG. The stiffness
    follows from its droop (--measured).

    Cut the coupon, clamp it level at the edge of a table up to one of its ticks, let the rest hang, and measure how
    far its end drops. Turn it over and measure again, because the mean cancels its curl. Then

    \b
      elastica coupon --sheet card-200gsm --measured 160 74 --measured 160 71
      elastica coupon --thickness 1.1 --density 720 --name felt          an unlisted sheet

    prints the stiffness and writes the sheet as NAME.toml, which all commands read by --sheet NAME.toml. With
    --keep the sheet is saved in the library, and its name is enough: --sheet NAME.
    """
    if name_or_file is not None and chosen["sheet"] is not None:
        refuse_extra_words([name_or_file])
    chosen["sheet"] = name_or_file or chosen["sheet"]
    refuse_idle(
        dict.fromkeys(("least_radius", "kerf", "grain", "kind", "keep", "reading_error"), ("measured",)),
        {"measured": ("overhang", "width", "clamp")},
    )
    sheet = require_flat(_sheet_of_coupon(chosen))
    if chosen["measured"]:
        _calibrate(sheet, chosen)
        return
    overhang = chosen["overhang"]
    drawing = coupon_drawing(sheet, overhang=overhang, width=chosen["width"], clamp=chosen["clamp"])
    files = [File(f"{file_word(drawing.name)}.{kind}", partial(save, drawing)) for kind in ("dxf", "svg")]
    written = write_files(files, chosen["output"], force=chosen["force"])
    answer({"sheet": sheet, "measured": None})
    wrote(written)
    free = coupon_overhang(sheet) if overhang is None else overhang
    options = given_of(chosen, ("sheet", "thickness", "density", "name"))
    if chosen["sheet"] is None:
        options["name"] = sheet.name
    typed = " ".join(
        f"--{option} {quote_words([value]) if isinstance(value, str) else f'{value:g}'}"
        for option, value in options.items()
    )
    say_rows(
        Row(
            "Next",
            f"cut the coupon, let {free:g} mm of it hang over an edge, measure the droop of its end in mm",
        ),
        Row("Then run", f"{name_program()} coupon {typed} --measured {free:g} DROOP"),
    )


_GRAIN = {"along": "along its grain", "across": "across its grain", "none": "without a grain"}


def _sheet_of_coupon(chosen: Chosen) -> Sheet:
    """Return the sheet of the coupon.

    Without a name of a known sheet, modulus and strain limit are assumed.
    """
    thickness, density = chosen["thickness"], chosen["density"]
    if thickness is not None:
        plausible_number(thickness, "thickness_mm", "--thickness")
    if density is not None:
        plausible_number(density, "density_kg_m3", "--density")
    if chosen["sheet"] is None:
        if thickness is None or density is None:
            raise InputError(
                "The material is missing. Name the most similar one with --sheet NAME, or set --thickness MM "
                "and --density KG/M3."
            )
        # modulus and strain limit are assumed, for the length of the coupon
        return Sheet(
            chosen["name"] or "my-sheet",
            thickness=thickness,
            density=density,
            youngs_modulus=4000.0,
            max_strain=0.004,
        )
    sheet = Sheet.named(chosen["sheet"])
    if thickness is not None:  # keep the measured thickness out of the name
        sheet = replace(sheet.with_thickness(thickness), name=sheet.name)
    return sheet if density is None else replace(sheet, density=density, density_range=None)


def _calibrate(sheet: Sheet, chosen: Chosen) -> None:
    """Compute the properties of a sheet from measured droops, write its file, and print them with warnings."""
    measured, least_radius = chosen["measured"], chosen["least_radius"]
    is_listed, name = chosen["sheet"] is not None, chosen["name"] or f"my-{sheet.name}"
    places, output = library_folders(), chosen["output"]
    if chosen["keep"]:
        if not places:
            raise InputError(
                "--keep needs a folder for settings, but there is no home folder. Set the variable "
                "ELASTICA_SHEETS to a folder, or leave out --keep."
            )
        output = next((place for place in places if place.suffix != ".toml"), None)
        if output is None:
            raise InputError(
                "--keep needs a folder, but the variable ELASTICA_SHEETS names only files. Add a folder to it."
            )
    result = calibrate_cantilever(
        *zip(*measured, strict=True),
        reading_error=chosen["reading_error"],
        thickness=sheet.thickness,
        density=sheet.density,
    )
    properties = {
        key: getattr(sheet, key) for key in ("grain", "kerf", "kind", "poisson_ratio", "shear_modulus")
    } | given_of(chosen, ("grain", "kerf", "kind"))
    limit: dict[str, Any] = (
        {"max_strain": sheet.max_strain} if least_radius is None else {"least_radius": least_radius}
    )
    # the sheet has a modulus of six digits
    measured_sheet = result.sheet(name, **limit, **properties)
    moduli = (measured_sheet.youngs_modulus, *(measured_sheet.youngs_modulus_range or ()))
    E, *limits = (float(f"{modulus:.6g}") for modulus in moduli)
    measured_sheet = replace(
        measured_sheet, youngs_modulus=E, youngs_modulus_range=(limits[0], limits[1]) if limits else None
    )
    (written,) = write_files(
        [text_file(f"{file_word(name)}.toml", measured_sheet.toml())], output, force=chosen["force"]
    )
    answer({"sheet": measured_sheet, "measured": result})
    say_rows(*(Row("Measured", line) for line in str(result).split("\n")))
    readings = sorted(zip(result.readings, result.reading_uncertainties, measured, strict=True))
    # smallest and largest elasto-gravity length with their standard errors, mm, and their (overhang, droop)
    (low, low_error, short), (high, high_error, long) = readings[0], readings[-1]
    # more than three standard deviations of the difference, and than a tenth of the smaller reading
    if high - low > max(3.0 * hypot(low_error, high_error), 0.1 * low):
        _warn_row(
            "Readings",
            f"Two measurements contradict each other: a droop of {short[1]:g} mm over {short[0]:g} mm gives an "
            f"elasto-gravity length of {Length(low)}, a droop of {long[1]:g} mm over {long[0]:g} mm gives "
            f"{Length(high)}. Measure again; if the sheet is curved, turn it over.",
        )
    if (least := min(abs(droop) for _, droop in measured)) < LEAST_DROOP_MM:
        _warn_row(
            "Readings",
            f"A droop of {least:g} mm is too small for an accurate stiffness. Let more of the coupon hang, until "
            f"it droops at least {LEAST_DROOP_MM:g} mm.",
        )
    if is_listed and least_radius is None and measured_sheet.grain != sheet.grain:
        _warn_row(
            "Strain",
            f"The largest strain, {100 * sheet.max_strain:.2g} %, is from {sheet.name}, which is bent "
            f"{_GRAIN[sheet.grain]}. Measure how tightly your sheet bends, and add --least-radius MM.",
        )
    if is_listed:
        text = "elasto-gravity length {length:.3g}, E {modulus:.3g} MPa"
        length, modulus = Length(sheet.elasto_gravity_length), sheet.youngs_modulus
        say_rows(Row("Listed", note(text, length=length, modulus=modulus)))
    elif least_radius is None:
        _warn_row(
            "Strain",
            f"The largest strain, {100 * sheet.max_strain:.2g} %, is a guess. Measure how tightly the sheet bends, "
            "and add --least-radius MM.",
        )
    say("", measured_sheet.toml())
    wrote([written])
    known_as = name if output in places else written
    say_rows(Row("Next", f"use the sheet in any command: --sheet {quote_words([str(known_as)])}"))


def _warn_row(label: str, text: str) -> None:
    say_rows(warning_row(text, label))
