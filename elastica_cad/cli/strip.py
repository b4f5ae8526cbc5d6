"""`elastica strip`: from a drawn curve to the files that a laser cutter needs."""

import json
from collections.abc import Callable
from dataclasses import dataclass, fields, replace
from importlib.util import find_spec
from itertools import islice
from pathlib import Path
from typing import Any, TypeVar

import click

from elastica_cad.cli.options import curve_options, holding_option, pick_curve, support_options
from elastica_cad.cli.wish import WishOptions, wish_options
from elastica_cad.errors import InputError
from elastica_cad.fabrication import HoldingTabs, Strip, Tab
from elastica_cad.fabrication.lettering import engravable
from elastica_cad.files import save
from elastica_cad.formats import files_together, strip_report
from elastica_cad.forming import NearestRod
from elastica_cad.forming.advice import advised
from elastica_cad.mechanics import Rod, Sheet, Stability, Supports, optimal_rod, stability

__all__ = ["strip"]

F = TypeVar("F", bound=Callable[..., Any])

MOST_ADVICE = 1  # sentences after a success; each costs a solve or two


@dataclass(frozen=True)
class _Cut:
    """How the cutting files are written."""

    kerf: str
    curves: str
    tolerance: float
    dxf_version: str
    force: bool
    output: Path
    holding: float | None

    def width_burnt(self, sheet: Sheet) -> float:
        """The kerf in mm: a number, or the sheet's own."""
        if self.kerf == "sheet":
            if sheet.kerf == 0:
                raise InputError(f"no kerf is known for {sheet.name}: give your own, e.g. --kerf 0.15")
            return sheet.kerf
        try:
            return float(self.kerf)
        except ValueError:
            raise InputError(f"--kerf {self.kerf!r} is neither a number of mm nor the word sheet") from None


def _cut_options(function: F) -> F:
    added = [
        click.option("--kerf", default="0", metavar="MM|sheet", show_default=True,
                     help="Width that the laser burns away; `sheet`: the sheet's. Most shops add it themselves."),
        click.option("--curves", type=click.Choice(["spline", "arc", "polyline"]), default="spline",
                     show_default=True, help="How curved edges are written."),
        click.option("--tolerance", type=float, default=0.02, show_default=True, metavar="MM",
                     help="Largest error of arcs and polylines."),
        click.option("--dxf-version", default="R2010", show_default=True,
                     help="R12, R2000, R2004, R2007, R2010, R2013 or R2018."),
        holding_option,
        click.option("--force", is_flag=True, help="Overwrite files that exist."),
        click.option("-o", "--output", type=click.Path(path_type=Path), default=Path(), help="Folder for files."),
    ]  # fmt: skip
    for option in reversed(added):
        function = option(function)
    return function


@click.command()
@curve_options
@click.option("--curve", "number", type=int, metavar="N", help="Which curve of the file, counted from 1.")
@click.option("--sheet", required=True, metavar="NAME", help="Material; `elastica sheets` lists them.")
@click.option("--max-width", type=float, metavar="MM", help="Width of the widest place.")
@click.option("--min-width", type=float, metavar="MM", help="Width of the narrowest place (or its limit).")
@support_options
@click.option("--gravity", is_flag=True, help="Let the strip carry its own weight.")
@click.option("--down", type=(float, float), default=(0.0, -1.0), show_default=True, metavar="X Y",
              help="The direction in which things fall, in the drawing.")  # fmt: skip
@wish_options
@click.option("--tab", type=float, default=10.0, show_default=True, metavar="MM", help="Length of both tabs.")
@click.option("--tab-radius", type=float, default=0.0, metavar="MM", help="Rounding of the tabs' corners.")
@click.option("--label", help="Text engraved on the strip [default: the file's name].")
@click.option("--samples", type=int, help="Number of samples along the curve [default: chosen].")
@click.option("--strict", is_flag=True, help="Exit with 1 when the strain is beyond what the sheet bears.")
@_cut_options
@click.pass_context
def strip(ctx: click.Context, /, **chosen: Any) -> None:
    """Make the strip that bends into the curve in CURVE, and write its cutting files.

    Writes NAME.dxf and NAME.svg (the cut pattern), NAME.json (the report), NAME.png (the picture; needs
    matplotlib) and NAME.step (flat and bent strip; needs build123d or CadQuery); NAME is that of the file read.

    The curve is taken exactly as drawn, or refused. With --nearest, --ratio, --stable, --margin or --keep-strain
    the strip may leave it, as little as it must.
    """
    cut = _picked(_Cut, chosen)
    sheet = Sheet.named(chosen["sheet"])
    if chosen["max_width"] is None and chosen["min_width"] is None:
        raise InputError("say how wide the strip may be: --max-width MM, or --min-width MM")
    rod, near = _rod(chosen, _picked(WishOptions, chosen), sheet)
    path, number = chosen["curve"], chosen["number"]
    name = path.stem if number is None else f"{path.stem}-{number}"
    tab = Tab(chosen["tab"], corner_radius=chosen["tab_radius"])
    made = Strip(
        rod, sheet, max_width=chosen["max_width"], min_width=chosen["min_width"], ends=(tab, tab),
        label=engravable(name) if chosen["label"] is None else chosen["label"],
    )  # fmt: skip
    verdict = stability(rod)
    written = _write_files(made, name, path, cut, near, verdict)
    _tell(made, near, verdict, written)
    if chosen["strict"] and made.max_strain > sheet.max_strain:
        ctx.exit(1)


def _picked(record: type[Any], chosen: dict[str, Any]) -> Any:
    """The record whose fields are named like the options."""
    return record(**{field.name: chosen[field.name] for field in fields(record)})


def _rod(chosen: dict[str, Any], wish: WishOptions, sheet: Sheet) -> tuple[Rod, NearestRod | None]:
    """The rod that takes the drawn curve, or the nearest one where the curve may change."""
    drawn = pick_curve(chosen["curve"], chosen["number"], chosen["unit"])
    gravity = sheet.gravity(chosen["down"]) if chosen["gravity"] else None
    supports = Supports(chosen["start"], chosen["end"])
    if not wish.asked:
        if wish.keep_tangents or wish.keep_length:
            raise InputError(
                "--keep-tangents and --keep-length are for a curve that may change: add --nearest"
            )
        rod = optimal_rod(
            drawn, gravity, supports, natural_curvature=chosen["natural_curvature"], samples=chosen["samples"]
        )
        return rod, None
    if chosen["samples"] is not None:
        raise InputError("--samples takes the curve as drawn: do without --nearest and the limits")
    if chosen["natural_curvature"]:
        raise InputError("--natural-curvature takes the curve as drawn: do without --nearest and the limits")
    near = wish.fulfilled(drawn, sheet, gravity, supports)
    return near.rod, near


def _write_files(
    made: Strip, name: str, drawn_in: Path, cut: _Cut, near: NearestRod | None, verdict: Stability
) -> list[Path]:
    """Write every file that the installed libraries allow: all of them, or after any error none."""
    # R12 has no header for its unit, so the name says it
    names = {"dxf": f"{name}-mm.dxf" if cut.dxf_version == "R12" else f"{name}.dxf"}
    names |= {kind: f"{name}.{kind}" for kind in ("svg", "json")}
    names |= {"png": f"{name}.png"} if find_spec("matplotlib") else {}
    names |= {"step": f"{name}.step"} if find_spec("OCP") else {}
    written = [cut.output / file for file in names.values()]
    if any(path.exists() and path.samefile(drawn_in) for path in written):
        raise InputError(f"{drawn_in} holds the drawn curve and is kept: name another folder, e.g. -o out")
    drawing = replace(made.drawing(), name=name)
    drawn: dict[str, Any] = {
        "kerf": cut.width_burnt(made.sheet), "curves": cut.curves, "tolerance": cut.tolerance,
        "holding": None if cut.holding is None else HoldingTabs(cut.holding),
    }  # fmt: skip
    with files_together(cut.output, names.values(), force=cut.force) as workshop:
        save(drawing, workshop / names["dxf"], version=cut.dxf_version, **drawn)
        save(drawing, workshop / names["svg"], **drawn)
        if "png" in names:
            from elastica_cad.plot import save_figure, strip_sheet

            wish = None if near is None else near.wish
            save_figure(strip_sheet(made, wish=wish), workshop / names["png"])
        if "step" in names:
            from elastica_cad.step import write_strip_step

            write_strip_step(made, workshop / names["step"])
        report = strip_report(made, name=name, files=names, near=near, stability=verdict)
        (workshop / names["json"]).write_text(json.dumps(report, indent=1) + "\n", encoding="utf-8")
    return written


def _tell(made: Strip, near: NearestRod | None, verdict: Stability, written: list[Path]) -> None:
    """What was made, in a few lines."""
    rod, (low, high) = made.rod, made.width.extremes
    click.echo(f"{made.label or 'strip'}: {rod.length:.2f} mm long, {low:.2f} to {high:.2f} mm wide, "
               f"stiffness ratio {rod.ratio:.4g}, {made.mass:.3g} g")  # fmt: skip
    click.echo(f"largest strain {100 * made.max_strain:.2f} % at {made.max_strain_at:.1f} mm "
               f"({made.sheet.name} bears {100 * made.sheet.max_strain:.2f} %)")  # fmt: skip
    if near is not None:
        click.echo(f"largest distance from the drawn curve {near.deviation:.2f} mm. {near.status.value}")
        for advice in islice(advised(near), MOST_ADVICE):
            click.echo(advice)
    if verdict.stable:
        click.echo(f"stable, margin {verdict.margin:.3g}")
    else:
        click.echo("Warning: this shape is in balance but will not stay: it snaps into another one. "
                   "--stable finds the nearest that stays.", err=True)  # fmt: skip
    for warning in made.warnings:
        click.echo(f"Warning: {warning}", err=True)
    for kind, package in (("png", "matplotlib"), ("step", "build123d")):
        if not any(path.suffix == f".{kind}" for path in written):
            click.echo(f"no .{kind}: it needs {package} (pip install {package})")
    for path in written:
        click.echo(f"wrote {path}")
