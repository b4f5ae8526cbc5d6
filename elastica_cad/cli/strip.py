"""`elastica strip`: from a drawn curve to the files that a laser cutter needs."""

import json
from dataclasses import replace
from importlib.util import find_spec
from pathlib import Path

import click

from elastica_cad.cli.options import curve_options, pick_curve, support_options, supports_of
from elastica_cad.errors import InputError
from elastica_cad.fabrication import Strip, Tab
from elastica_cad.files import save
from elastica_cad.formats import files_together, strip_report
from elastica_cad.mechanics import Rod, Sheet, optimal_rod

__all__ = ["strip"]


@click.command()
@curve_options
@click.option("--curve", "number", type=int, metavar="N", help="Which curve of the file, counted from 1.")
@click.option(
    "--sheet", "sheet_name", required=True, metavar="NAME", help="Material; `elastica sheets` lists them."
)
@click.option("--max-width", type=float, metavar="MM", help="Width of the widest place.")
@click.option(
    "--min-width", type=float, metavar="MM", help="Width of the narrowest place (or a limit for it)."
)
@support_options
@click.option("--gravity", is_flag=True, help="Let the strip carry its own weight.")
@click.option("--down", type=(float, float), default=(0.0, -1.0), show_default=True, metavar="X Y",
              help="The direction in which things fall, in the drawing.")  # fmt: skip
@click.option("--tab", type=float, default=10.0, show_default=True, metavar="MM", help="Length of both tabs.")
@click.option("--tab-radius", type=float, default=0.0, metavar="MM", help="Rounding of the tabs' corners.")
@click.option("--label", help="Text engraved on the strip [default: the file's name].")
@click.option("--kerf", default="0", metavar="MM|sheet", show_default=True,
              help="Width that the laser burns away; `sheet` takes the sheet's. Most shops add it themselves.")  # fmt: skip
@click.option("--curves", type=click.Choice(["spline", "arc", "polyline"]), default="spline", show_default=True,
              help="How curved edges are written.")  # fmt: skip
@click.option("--tolerance", type=float, default=0.02, show_default=True, metavar="MM",
              help="Largest error of arcs and polylines.")  # fmt: skip
@click.option(
    "--dxf-version", default="R2010", show_default=True, help="R12, R2000, R2004, R2007, R2010, R2013, R2018."
)
@click.option("--samples", type=int, help="Number of samples along the curve [default: chosen].")
@click.option("--strict", is_flag=True, help="Exit with 1 when the strain is beyond what the sheet bears.")
@click.option("--force", is_flag=True, help="Overwrite files that exist.")
@click.option("-o", "--output", type=click.Path(path_type=Path), default=Path(), help="Folder for the files.")
@click.pass_context
def strip(
    ctx: click.Context,
    curve: Path,
    unit: str | None,
    number: int | None,
    sheet_name: str,
    max_width: float | None,
    min_width: float | None,
    start: str,
    end: str,
    natural_curvature: float,
    gravity: bool,
    down: tuple[float, float],
    tab: float,
    tab_radius: float,
    label: str | None,
    kerf: str,
    curves: str,
    tolerance: float,
    dxf_version: str,
    samples: int | None,
    strict: bool,
    force: bool,
    output: Path,
) -> None:
    """Make the strip that bends into the curve in CURVE, and write its cutting files.

    Writes NAME.dxf and NAME.svg (the cut pattern), NAME.json (the report), NAME.png (the picture; needs matplotlib)
    and NAME.step (flat and bent strip; needs build123d or CadQuery), NAME being the name of the file read.
    """
    sheet = Sheet.named(sheet_name)
    kerf_mm = _kerf(kerf, sheet)
    drawn = pick_curve(curve, number, unit)
    rod = optimal_rod(
        drawn,
        gravity=sheet.gravity(down) if gravity else None,
        supports=supports_of(start, end),
        natural_curvature=natural_curvature,
        samples=samples,
    )
    name = curve.stem if number is None else f"{curve.stem}-{number}"
    ends = (Tab(tab, corner_radius=tab_radius), Tab(tab, corner_radius=tab_radius))
    made = Strip(
        rod,
        sheet,
        max_width=max_width,
        min_width=min_width,
        ends=ends,
        label=name if label is None else label,
    )
    written = _write_files(
        made, name, output, force=force, version=dxf_version, kerf=kerf_mm, curves=curves, tolerance=tolerance
    )
    _tell(made, rod, written)
    if strict and made.max_strain > sheet.max_strain:
        ctx.exit(1)


def _kerf(text: str, sheet: Sheet) -> float:
    """The kerf in mm: a number, or the sheet's own."""
    if text == "sheet":
        return sheet.kerf
    try:
        return float(text)
    except ValueError:
        raise InputError(f"--kerf {text!r} is neither a number of mm nor the word sheet") from None


def _write_files(
    made: Strip,
    name: str,
    folder: Path,
    *,
    force: bool,
    version: str,
    kerf: float,
    curves: str,
    tolerance: float,
) -> list[Path]:
    """Write every file that the installed libraries allow: all of them, or after any error none."""
    kinds = ["dxf", "svg", "json"]
    kinds += ["png"] if find_spec("matplotlib") else []
    kinds += ["step"] if find_spec("OCP") else []
    names = {kind: f"{name}.{kind}" for kind in kinds}
    drawing = replace(made.drawing(), name=name)
    with files_together(folder, names.values(), force=force) as workshop:
        save(drawing, workshop / names["dxf"], version=version, kerf=kerf, curves=curves, tolerance=tolerance)
        save(drawing, workshop / names["svg"], kerf=kerf, curves=curves, tolerance=tolerance)
        if "png" in names:
            from elastica_cad.plot import save_figure, strip_sheet

            save_figure(strip_sheet(made), workshop / names["png"])
        if "step" in names:
            from elastica_cad.occt import write_strip_step

            write_strip_step(made, workshop / names["step"])
        report = strip_report(made, name=name, files=names)
        (workshop / names["json"]).write_text(json.dumps(report, indent=1) + "\n", encoding="utf-8")
    return [folder / file for file in names.values()]


def _tell(made: Strip, rod: Rod, written: list[Path]) -> None:
    """What was made, in a few lines."""
    low, high = made.width.extremes
    click.echo(f"{made.label or 'strip'}: {rod.length:.2f} mm long, {low:.2f} to {high:.2f} mm wide, "
               f"stiffness ratio {rod.ratio:.4g}, {made.mass:.3g} g")  # fmt: skip
    click.echo(f"largest strain {100 * made.max_strain:.2f} % at {made.max_strain_at:.1f} mm "
               f"({made.sheet.name} bears {100 * made.sheet.max_strain:.2f} %)")  # fmt: skip
    for warning in made.warnings:
        click.echo(f"Warning: {warning}", err=True)
    for kind, package in (("png", "matplotlib"), ("step", "build123d")):
        if not any(path.suffix == f".{kind}" for path in written):
            click.echo(f"no .{kind}: it needs {package} (pip install {package})")
    for path in written:
        click.echo(f"wrote {path}")
