"""`elastica coupon`: a strip to cut, hang and measure, and what the measurement says of the sheet."""

from dataclasses import replace
from pathlib import Path

import click

from elastica_cad.cli.options import output_options
from elastica_cad.errors import InputError
from elastica_cad.fabrication.sheets.coupon import coupon_drawing
from elastica_cad.files import save
from elastica_cad.formats.file_access.file_transaction import write_together
from elastica_cad.mechanics.material.sheet import Sheet
from elastica_cad.mechanics.studies.calibration import calibrate_cantilever


@click.command()
@click.option("--sheet", required=True, metavar="NAME", help="The material, or the one most like it.")
@click.option("--overhang", type=float, metavar="MM", help="Longest free length [default: by the sheet].")
@click.option(
    "--width", type=float, default=20.0, show_default=True, metavar="MM", help="Width of the coupon."
)
@click.option(
    "--clamp", type=float, default=40.0, show_default=True, metavar="MM", help="Length to be clamped."
)
@click.option("--measured", type=(float, float), multiple=True, metavar="OVERHANG DROOP",
              help="A reading, mm: free length, how far its end hangs below the clamp; repeatable.")  # fmt: skip
@click.option("--reading-error", type=float, default=0.5, show_default=True, metavar="MM",
              help="How exactly both were read (standard deviation).")  # fmt: skip
@click.option("--thickness", type=float, metavar="MM", help="Measured thickness [default: the sheet's].")
@click.option("--density", type=float, metavar="KG/M3", help="Measured density [default: the sheet's].")
@click.option("--least-radius", type=float, metavar="MM",
              help="Least radius that left no lasting bend [default: by the sheet's largest strain].")  # fmt: skip
@click.option("--name", help="What to call the measured sheet [default: my-NAME].")
@output_options
def coupon(
    sheet: str,
    overhang: float | None,
    width: float,
    clamp: float,
    measured: tuple[tuple[float, float], ...],
    reading_error: float,
    thickness: float | None,
    density: float | None,
    least_radius: float | None,
    name: str | None,
    force: bool,
    output: Path,
) -> None:
    """Write a coupon of a sheet as DXF and SVG, or tell with --measured what its droop says.

    Cut the coupon, clamp it level at the edge of a table up to one of its ticks, let the rest hang, and read how
    far its end drops. Turn it over and read again: the mean cancels its own curl. Then

    \b
      elastica coupon --sheet card-200gsm --measured 160 74 --measured 160 71

    prints the stiffness and writes the sheet as NAME.toml, to be named as sheets_file in a design.
    """
    known = Sheet.named(sheet)
    if measured:
        if name and ("/" in name or "\\" in name):
            raise InputError(f"the name {name!r} is to name a file too: leave out / and \\")
        if thickness is not None:
            known = replace(known, thickness=thickness, thickness_range=None)
        if density is not None:
            known = replace(known, density=density, density_range=None)
        _calibrate(known, measured, reading_error, least_radius, name or f"my-{sheet}", output, force)
        return
    for value, option in (
        (thickness, "--thickness"),
        (density, "--density"),
        (least_radius, "--least-radius"),
    ):
        if value is not None:
            raise InputError(f"{option} belongs to a measurement: give --measured OVERHANG DROOP too")
    drawing = coupon_drawing(known, overhang=overhang, width=width, clamp=clamp)
    names = [f"{drawing.name}.dxf", f"{drawing.name}.svg"]
    with write_together(output, names, force=force) as workshop:
        for file in names:
            save(drawing, workshop / file)
    for file in names:
        click.echo(f"wrote {output / file}")


def _calibrate(
    sheet: Sheet,
    measured: tuple[tuple[float, float], ...],
    reading_error: float,
    least_radius: float | None,
    name: str,
    output: Path,
    force: bool,
) -> None:
    """Print what the readings say and write the sheet."""
    result = calibrate_cantilever(
        [reading[0] for reading in measured],
        [reading[1] for reading in measured],
        reading_error=reading_error,
        thickness=sheet.thickness,
        density=sheet.density,
    )
    limit = {"max_strain": sheet.max_strain} if least_radius is None else {"least_radius": least_radius}
    own = result.sheet(
        name, **limit, kerf=sheet.kerf, poisson_ratio=sheet.poisson_ratio, grain=sheet.grain, kind=sheet.kind
    )
    file = f"{name}.toml"
    with write_together(output, [file], force=force) as workshop:
        (workshop / file).write_text(own.toml(), encoding="utf-8")
    click.echo(str(result))
    click.echo(f"(in the list: {sheet.elasto_gravity_length:.2f} mm, E {sheet.youngs_modulus:.0f} MPa)\n")
    click.echo(own.toml())
    click.echo(f"wrote {output / file}")
