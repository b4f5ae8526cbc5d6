"""`elastica model`: from a design file to a folder with everything that is needed to build it."""

import json
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import click

from elastica_cad.errors import InputError
from elastica_cad.fabrication import (
    BasePlate,
    EndFixture,
    FlatSolid,
    Model,
    NestedSheet,
    Piece,
    Rib,
    cut_list,
    nested,
)
from elastica_cad.files import read_curves, save
from elastica_cad.formats import files_together
from elastica_cad.formats.design import Design, Nesting, read_design
from elastica_cad.formats.model_report import model_report
from elastica_cad.mechanics import Sheet

__all__ = ["model"]

Writer = Callable[[Path], None]

MOST_SAID = 6
"""Notes that are printed; the report holds all."""


@dataclass(frozen=True, eq=False)
class _Kit:
    """Everything that a design becomes."""

    design: Design
    model: Model
    pieces: tuple[Piece, ...]
    nests: tuple[NestedSheet, ...]
    plates: tuple[tuple[str, Sheet, FlatSolid], ...]
    """Base, rails and ribs in space: name, material, body."""
    fixtures: tuple[EndFixture, ...]
    files: dict[str, tuple[str, Writer]] = field(default_factory=dict)
    """What each file is and how it is written, by its name."""


@click.command()
@click.argument("design", type=click.Path(path_type=Path))
@click.option("-o", "--output", type=click.Path(path_type=Path), default=Path(), help="Folder for all files.")
@click.option("--step/--no-step", default=True, help="Write the bent strips as STEP (needs a CAD kernel).")
@click.option(
    "--pictures/--no-pictures", default=True, help="Draw the model and the sheets (needs matplotlib)."
)
@click.option("--force", is_flag=True, help="Overwrite files that exist.")
def model(design: Path, output: Path, step: bool, pictures: bool, force: bool) -> None:
    """Make a whole model from the design file DESIGN (TOML).

    Writes into one folder: nested sheets, one DXF and SVG per part, the base plate and fixtures where asked for,
    the cut list (CSV and text), a report (JSON), the assembly (STEP) and pictures. All files appear together when
    everything has succeeded, or none.
    """
    read = read_design(design, read_curves)
    with click.progressbar(length=len(read.wishes) + 1, label="strips", item_show_func=str) as bar:
        made = read.model(lambda label: bar.update(1, label))
        bar.update(1, "nesting")
        kit = _kit(read, made)
    _plan(kit, step and find_spec("OCP") is not None, pictures and find_spec("matplotlib") is not None)
    with (
        files_together(output, kit.files, force=force) as workshop,
        click.progressbar(kit.files.items(), label="files ", item_show_func=_name_of) as files,
    ):
        for name, (_, write) in files:
            write(workshop / name)
    _tell(kit, output, step=step, pictures=pictures)


def _name_of(item: tuple[str, tuple[str, Writer]] | None) -> str:
    return item[0] if item else ""


def _kit(design: Design, made: Model) -> _Kit:
    """Pieces, sheets, base and fixtures of a model."""
    base, frame = design.base_plate(made), design.slotted_frame(made)
    strips = (*made.pieces, *design.extras())
    size, margin = design.nesting.sheet_size, design.nesting.margin
    nests = list(nested(strips, sheet_size=size, margin=margin, name=f"{made.name}-nest"))
    pieces, plates = strips, []
    wanted: list[tuple[str, tuple[Sheet, Any, Nesting] | None, tuple[BasePlate | Rib, ...]]] = [
        ("base", design.base, () if base is None else (base,)),
        ("frame", design.frame, () if frame is None else (*frame.rails, *frame.ribs)),
    ]
    for what, made_of, found in wanted:
        if made_of is None:
            continue
        cut = [replace(plate.piece, name=f"{made.name}-{plate.name}") for plate in found]
        nests += nested(
            cut, sheet_size=made_of[2].sheet_size, margin=made_of[2].margin, name=f"{made.name}-{what}-nest"
        )
        pieces = (*pieces, *cut)
        plates += [(plate.name, plate.sheet, plate.solid) for plate in found]
    fixtures = () if design.fixtures is None else made.fixtures(**design.fixtures)
    return _Kit(design, made, pieces, tuple(nests), tuple(plates), fixtures)


def _plan(kit: _Kit, step: bool, pictures: bool) -> None:
    """Say which files there will be, and how each is written."""
    name, files = kit.model.name, kit.files
    for nest in kit.nests:
        if nest.sheet is not None:
            _add_drawing(kit, nest.name, nest, nest.sheet, "nested sheet")
    for piece in kit.pieces:
        _add_drawing(kit, piece.file_stem, piece.drawing, piece.sheet, "part")
    listed = cut_list(kit.pieces, {piece.name: f"{piece.file_stem}.{_suffix(kit)}" for piece in kit.pieces})
    files[f"{name}-cut-list.csv"] = ("cut list", lambda path: _write_text(path, listed.csv))
    files[f"{name}-cut-list.txt"] = ("cut list", lambda path: _write_text(path, str(listed)))
    if step:
        files[f"{name}.step"] = ("assembly", lambda path: _write_step(kit, path))
    if pictures:
        files[f"{name}.png"] = ("picture of the model", lambda path: _draw_model(kit, path))
        for nest in kit.nests:
            files[f"{nest.name}.png"] = ("picture of a sheet", _nest_picture(nest))
    files[f"{name}.json"] = ("report", lambda path: _write_report(kit, path))


def _suffix(kit: _Kit) -> str:
    # R12 has no header for its unit, so the name says it
    return "mm.dxf" if kit.design.cutting.version == "R12" else "dxf"


def _add_drawing(kit: _Kit, stem: str, drawing: Any, sheet: Sheet, what: str) -> None:
    """The drawing as DXF and SVG."""
    cutting = kit.design.cutting
    if cutting.kerf is None and sheet.kerf == 0:
        raise InputError(f"no kerf is known for {sheet.name}: give a number of mm instead of the word sheet")
    options: dict[str, Any] = {
        "kerf": sheet.kerf if cutting.kerf is None else cutting.kerf,
        "curves": cutting.curves,
        "tolerance": cutting.tolerance,
    }
    dxf = f"{stem}.{_suffix(kit)}"
    kit.files[dxf] = (what, lambda path: _saved(drawing, path, version=cutting.version, **options))
    kit.files[f"{stem}.svg"] = (what, lambda path: _saved(drawing, path, **options))


def _saved(drawing: Any, path: Path, **options: Any) -> None:
    save(drawing, path, **options)


def _write_text(path: Path, text: str) -> None:
    path.write_text(text, encoding="utf-8", newline="\n")


def _write_report(kit: _Kit, path: Path) -> None:
    kinds = {name: kind for name, (kind, _) in kit.files.items()}
    report = model_report(kit.model, cut_list=cut_list(kit.pieces), nests=kit.nests, files=kinds)
    _write_text(path, json.dumps(report, indent=1) + "\n")


def _write_step(kit: _Kit, path: Path) -> None:
    from elastica_cad.fabrication import sheet_color
    from elastica_cad.occt import make_solid
    from elastica_cad.step import Part, model_parts, write_step

    parts = model_parts(kit.model)
    parts += [Part(name, make_solid(solid), sheet_color(sheet)) for name, sheet, solid in kit.plates]
    parts += [
        Part(f"fixture {fixture.number}", make_solid(fixture.solid), (0.35, 0.4, 0.5))
        for fixture in kit.fixtures
    ]
    write_step(parts, path, name=kit.model.name)


def _draw_model(kit: _Kit, path: Path) -> None:
    from elastica_cad import plot

    plot.save_figure(plot.model(kit.model), path)


def _nest_picture(nest: NestedSheet) -> Writer:
    def draw(path: Path) -> None:
        from elastica_cad import plot

        plot.save_figure(plot.drawing(nest), path)

    return draw


def _tell(kit: _Kit, output: Path, *, step: bool, pictures: bool) -> None:
    """What was made, in a few lines."""
    listed = cut_list(kit.pieces)
    strips = f"{len(kit.model.placed)} strips ({len(kit.model.parts)} different)"
    click.echo(f"{kit.model.name}: {strips}, {len(kit.model.joints)} joints; {listed.count} pieces, "
               f"{listed.cut_length / 1000:.1f} m of cuts, {listed.mass:.0f} g")  # fmt: skip
    for nest in kit.nests:
        click.echo(
            f"{nest.name}: {len(nest.pieces)} pieces, {100 * nest.filled / nest.used:.0f} % of the rows used"
        )
    warnings = [f"{part.name}: {text}" for part in kit.model.parts for text in part.strip.warnings]
    said = list(dict.fromkeys((*warnings, *kit.model.reports)))
    for text in said[:MOST_SAID]:
        click.echo(f"Note: {text}", err=True)
    if len(said) > MOST_SAID:
        click.echo(f"Note: {len(said) - MOST_SAID} more in {kit.model.name}.json", err=True)
    for asked, package, kind in ((pictures, "matplotlib", "pictures"), (step, "build123d", "STEP")):
        if asked and find_spec("OCP" if package == "build123d" else package) is None:
            click.echo(f"no {kind}: pip install {package}")
    click.echo(f"wrote {len(kit.files)} files to {output}")
