"""`elastica coupon`: a strip to cut, hang and measure, and the sheet properties from the measurement."""

from dataclasses import replace
from functools import partial
from math import hypot
from pathlib import Path
from typing import Any

import click

from elastica_cad._text import quote_words
from elastica_cad.cli.options import LENGTH, POINT, given_of, option_name, output_options
from elastica_cad.cli.suggestions import name_program
from elastica_cad.cli.voice import answer, say, warn, wrote
from elastica_cad.errors import InputError
from elastica_cad.files import save
from elastica_cad.formats.write_files import File, write_files, write_text
from elastica_cad.mechanics.calibration import Calibration, calibrate_cantilever
from elastica_cad.mechanics.section_limits import OUTCOMES
from elastica_cad.mechanics.sheets import Sheet, library_folders, plausible_number
from elastica_cad.strip.coupon import coupon_drawing, coupon_overhang

GUESSED_MPA, GUESSED_STRAIN = 4000.0, 0.004
"""Assumed modulus (between card and plywood) and strain limit of an unknown sheet, for the length of its coupon."""

LEAST_DROOP_MM = 10.0
"""Least useful droop, mm; position and level of the clamp are hardly known to half a mm."""

SIGMAS, LEAST_CONTRADICTION = 3.0, 0.1
"""Least difference of contradictory readings, in uncertainties and as a fraction."""


@click.command()
@click.option("--sheet", metavar="NAME|FILE",
              help="The material, or the one most like it; of others give --thickness and --density.")  # fmt: skip
@click.option("--overhang", type=LENGTH, metavar="MM", help="Longest free length [default: by the sheet].")
@click.option(
    "--width", type=LENGTH, default=20.0, show_default=True, metavar="MM", help="Width of the coupon."
)
@click.option(
    "--clamp", type=LENGTH, default=40.0, show_default=True, metavar="MM", help="Length to be clamped."
)
@click.option("--measured", type=POINT, multiple=True, metavar="OVERHANG DROOP",
              help="A reading, mm: free length, how far its end hangs below the clamp; repeatable.")  # fmt: skip
@click.option("--reading-error", type=LENGTH, default=0.5, show_default=True, metavar="MM",
              help="How exactly both were read (standard deviation).")  # fmt: skip
@click.option("--thickness", type=LENGTH, metavar="MM", help="Measured thickness [default: the sheet's].")
@click.option("--density", type=float, metavar="KG/M3", help="Measured density [default: the sheet's].")
@click.option("--least-radius", type=LENGTH, metavar="MM",
              help="Least radius that left no lasting bend [default: by the sheet's largest strain].")  # fmt: skip
@click.option("--grain", type=click.Choice(["along", "across", "none"]),
              help="How the coupon lies to the grain [default: as the sheet's].")  # fmt: skip
@click.option("--kind", type=click.Choice(list(OUTCOMES)),
              help="What it is made of, which says how it breaks [default: as the sheet's].")  # fmt: skip
@click.option("--kerf", type=LENGTH, metavar="MM", help="Width of the cut, measured [default: the sheet's].")
@click.option("--name", help="What to call the measured sheet [default: my-NAME].")
@click.option("--keep", is_flag=True, help="Write the measured sheet into the library, for every command.")
@output_options
def coupon(**chosen: Any) -> None:
    """Write a coupon of a sheet as DXF and SVG, or tell with --measured what its droop says.

    Cut the coupon, clamp it level at the edge of a table up to one of its ticks, let the rest hang, and read how
    far its end drops. Turn it over and read again: the mean cancels its own curl. Then

    \b
      elastica coupon --sheet card-200gsm --measured 160 74 --measured 160 71
      elastica coupon --thickness 1.1 --density 720 --name felt          a sheet that is in no list

    prints the stiffness and writes the sheet as NAME.toml, which every command takes: --sheet NAME.toml; with
    --keep it joins the library, and --sheet NAME is enough.
    """
    known, name = _known(chosen), chosen["name"]
    if name and ("/" in name or "\\" in name):
        raise InputError("the name {name!r} is to name a file too: leave out / and \\", name=name)
    if chosen["measured"]:
        _calibrate(known, chosen)
        return
    for option in ("least_radius", "kerf", "grain", "kind", "keep"):
        if chosen[option] is not None and chosen[option] is not False:
            raise InputError(
                "{option} belongs to a measurement: give --measured OVERHANG DROOP too",
                option=option_name(option),
            )
    overhang = chosen["overhang"]
    drawing = coupon_drawing(known, overhang=overhang, width=chosen["width"], clamp=chosen["clamp"])
    files = [File(f"{drawing.name}.{kind}", partial(save, drawing)) for kind in ("dxf", "svg")]
    written = write_files(files, chosen["output"], force=chosen["force"])
    answer({"sheet": known, "measured": None})
    wrote(written)
    free = coupon_overhang(known) if overhang is None else overhang
    given = given_of(chosen, ("sheet", "thickness", "density", "name"))
    if chosen["sheet"] is None:
        given["name"] = known.name
    typed = " ".join(
        f"--{option} {quote_words([value]) if isinstance(value, str) else f'{value:g}'}"
        for option, value in given.items()
    )
    say(f"next: cut it, hang {free:g} mm of it over an edge, read the droop of its end in mm, and")
    say(f"  {name_program()} coupon {typed} --measured {free:g} DROOP")


_GRAIN = {"along": "along its grain", "across": "across its grain", "none": "without a grain"}


def _warn_of_contradiction(measured: tuple[tuple[float, float], ...], result: Calibration) -> None:
    """Tell of two readings that differ by more than errors of reading explain."""
    found = sorted(zip(result.readings, result.reading_uncertainties, measured, strict=True))
    (low, low_error, near), (high, high_error, far) = found[0], found[-1]
    if high - low > max(SIGMAS * hypot(low_error, high_error), LEAST_CONTRADICTION * low):
        warn(
            f"two readings contradict each other: a droop of {near[1]:g} mm over {near[0]:g} mm makes the "
            f"elasto-gravity length {low:.4g} mm, one of {far[1]:g} mm over {far[0]:g} mm makes it {high:.4g} mm: "
            "measure again, with the other face up where the sheet is curved"
        )


def _known(chosen: dict[str, Any]) -> Sheet:
    """Return the named sheet with the measured thickness and density, or an assumed sheet if it is unknown."""
    thickness, density = chosen["thickness"], chosen["density"]
    for option, value, key in (
        ("--thickness", thickness, "thickness_mm"),
        ("--density", density, "density_kg_m3"),
    ):
        if value is not None:
            plausible_number(value, key, option)
    if chosen["sheet"] is None:
        if thickness is None or density is None:
            raise InputError(
                "name the material most like yours with --sheet NAME, or give --thickness MM and --density KG/M3 "
                "of one that is in no list"
            )
        return Sheet(
            chosen["name"] or "my-sheet",
            thickness=thickness,
            density=density,
            youngs_modulus=GUESSED_MPA,
            max_strain=GUESSED_STRAIN,
        )
    found = Sheet.named(chosen["sheet"])
    if thickness is not None:  # it is still that material, by its name
        found = replace(found.with_thickness(thickness), name=found.name)
    return found if density is None else replace(found, density=density, density_range=None)


def _kept() -> Path:
    """Return the folder of the user's library."""
    places = library_folders()
    if not places:
        raise InputError(
            "--keep needs a place for settings, and there is no home folder: name a folder in the variable "
            "ELASTICA_SHEETS, or leave out --keep"
        )
    folder = next((place for place in places if place.suffix != ".toml"), None)
    if folder is None:
        raise InputError("--keep needs a folder: the variable ELASTICA_SHEETS names files only")
    return folder


def _calibrate(sheet: Sheet, chosen: dict[str, Any]) -> None:
    """Print the result of the readings, with the listed values of a known sheet, and write the sheet."""
    measured, least_radius, listed = chosen["measured"], chosen["least_radius"], chosen["sheet"] is not None
    name, output = chosen["name"] or f"my-{sheet.name}", _kept() if chosen["keep"] else chosen["output"]
    result = calibrate_cantilever(
        [reading[0] for reading in measured],
        [reading[1] for reading in measured],
        reading_error=chosen["reading_error"],
        thickness=sheet.thickness,
        density=sheet.density,
    )
    own = {key: getattr(sheet, key) for key in ("grain", "kerf", "kind", "poisson_ratio", "shear_modulus")}
    own |= given_of(chosen, ("grain", "kerf", "kind"))
    limit: dict[str, Any] = (
        {"max_strain": sheet.max_strain} if least_radius is None else {"least_radius": least_radius}
    )
    found = _as_readings_tell(result.sheet(name, **limit, **own))
    file = File(f"{name}.toml", lambda path: write_text(path, found.toml()))
    (written,) = write_files([file], output, force=chosen["force"])
    answer({"sheet": found, "measured": result})
    say(str(result))
    _warn_of_contradiction(measured, result)
    if (least := min(abs(droop) for _, droop in measured)) < LEAST_DROOP_MM:
        warn(
            f"a droop of {least:g} mm says little of the stiffness: hang more of it, so that it droops "
            f"{LEAST_DROOP_MM:g} mm at least"
        )
    if listed and least_radius is None and found.grain != sheet.grain:
        warn(
            f"the largest strain, {100 * sheet.max_strain:.2g} %, is that of {sheet.name}, which is bent "
            f"{_GRAIN[sheet.grain]}: measure how tightly yours bends, then --least-radius MM"
        )
    if listed:
        say(f"(in the list: {sheet.elasto_gravity_length:.2f} mm, E {sheet.youngs_modulus:.0f} MPa)")
    elif least_radius is None:
        say(
            f"largest strain {100 * sheet.max_strain:.2g} %: a guess; measure how tightly it bends, then "
            "--least-radius MM"
        )
    say("")
    say(found.toml())
    wrote([written])
    known_as = name if output in library_folders() else written
    say(f"every command takes it: --sheet {quote_words([str(known_as)])}")


def _as_readings_tell(sheet: Sheet) -> Sheet:
    """Return the sheet with its modulus rounded to six digits, more than readings can determine."""
    given = (sheet.youngs_modulus, *(sheet.youngs_modulus_range or ()))
    E, *limits = (float(f"{modulus:.6g}") for modulus in given)
    return replace(sheet, youngs_modulus=E, youngs_modulus_range=(limits[0], limits[1]) if limits else None)
