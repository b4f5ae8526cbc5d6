"""Everything that a model becomes, written into one folder: all files together, or none."""

import json
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from elastica_cad.errors import InputError, NotConvergedError
from elastica_cad.fabrication import (
    BasePlate,
    EndFixture,
    FlatSolid,
    HoldingTabs,
    Model,
    NestedSheet,
    Piece,
    Rib,
    cut_list,
    nested,
)
from elastica_cad.fabrication.pieces import file_word
from elastica_cad.fabrication.slot_effects import SlotEffect, slot_effect
from elastica_cad.files import save
from elastica_cad.formats import files_together
from elastica_cad.formats.design import Cutting, Design, Nesting
from elastica_cad.formats.model_report import model_report
from elastica_cad.mechanics import Sheet

__all__ = ["Kit", "SavedKit", "kit_of", "left_out", "save_model", "write_kit"]

Writer = Callable[[Path], None]


@dataclass(frozen=True, eq=False)
class Kit:
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
    effects: dict[str, SlotEffect] = field(default_factory=dict)
    """What its slots do to each part, by its name, where it was asked for."""
    notes: tuple[str, ...] = ()
    """Parts that find no shape with their slots."""


@dataclass(frozen=True)
class SavedKit:
    """What `save_model` wrote; as text, where it is and what was left out.

    Attributes
    ----------
    folder : Path
    files : tuple of str
        Names in the folder.
    left_out : tuple of str
        What was asked for and cannot be made here, and why.
    summary : str
        Strips and sheets in one line.
    """

    folder: Path
    files: tuple[str, ...]
    left_out: tuple[str, ...]
    summary: str

    def __fspath__(self) -> str:
        return str(self.folder)

    def __str__(self) -> str:
        return "\n".join((self.summary, *self.left_out, f"wrote {len(self.files)} files to {self.folder}"))


def left_out(*, step: bool = True, pictures: bool = True) -> tuple[str, ...]:
    """What of the assembly and the pictures cannot be written here, and which package would."""
    wanted = ((pictures, "matplotlib", "matplotlib", "pictures"), (step, "OCP", "build123d", "STEP"))
    return tuple(
        f"no {kind}: pip install {package}"
        for asked, module, package, kind in wanted
        if asked and find_spec(module) is None
    )


def kit_of(design: Design, made: Model, *, effects: bool = False) -> Kit:
    """Pieces, sheets, base and fixtures of a model; with `effects` also what slots do to its strips."""
    base, frame = design.base_plate(made), design.slotted_frame(made)
    strips = (*made.pieces, *design.extras())
    size, margin = design.nesting.sheet_size, design.nesting.margin
    kerf = design.cutting.kerf
    nests = list(nested(strips, sheet_size=size, margin=margin, kerf=kerf, name=f"{made.name}-nest"))
    pieces, plates = strips, []
    wanted: list[tuple[str, tuple[Sheet, Any, Nesting] | None, tuple[BasePlate | Rib, ...]]] = [
        ("base", design.base, () if base is None else (base,)),
        ("frame", design.frame, () if frame is None else (*frame.rails, *frame.ribs)),
    ]
    for what, made_of, found in wanted:
        if made_of is None:
            continue
        cut = [replace(plate.piece, name=f"{made.name}-{plate.name}") for plate in found]
        size, margin = made_of[2].sheet_size, made_of[2].margin
        nests += nested(cut, sheet_size=size, margin=margin, kerf=kerf, name=f"{made.name}-{what}-nest")
        pieces = (*pieces, *cut)
        plates += [(plate.name, plate.sheet, plate.solid) for plate in found]
    fixtures = () if design.fixtures is None else made.fixtures(**design.fixtures)
    bent, notes = _slot_effects(made) if effects else ({}, ())
    return Kit(design, made, pieces, tuple(nests), tuple(plates), fixtures, effects=bent, notes=notes)


def _slot_effects(made: Model) -> tuple[dict[str, SlotEffect], tuple[str, ...]]:
    """Of every different part with slots; and of those that fail, why."""
    found, notes = {}, []
    for part in made.parts:
        if part.strip.slots:
            try:
                found[part.name] = slot_effect(part.strip)
            except NotConvergedError as problem:
                notes.append(f"{part.name}: with its slots no shape near the design was found: {problem}")
    return found, tuple(notes)


def write_kit(
    kit: Kit,
    folder: str | Path,
    *,
    step: bool = True,
    pictures: bool = True,
    parts: bool = True,
    force: bool = False,
    done: Callable[[str, int], None] | None = None,
) -> None:
    """Write all files of a kit; the assembly and the pictures where a CAD kernel and matplotlib are installed.

    Without `parts` only the nested sheets are drawn, not every part once more in files of its own.
    `done` is called with the name of each file that has been written, and how many there are in all.

    Raises
    ------
    InputError
        Files that exist, without `force`.
    """
    step, pictures = step and find_spec("OCP") is not None, pictures and find_spec("matplotlib") is not None
    _plan(kit, step=step, pictures=pictures, parts=parts)
    with files_together(folder, kit.files, force=force) as workshop:
        for name, (_, write) in kit.files.items():
            write(workshop / name)
            if done is not None:
                done(name, len(kit.files))


def save_model(
    model: Model,
    folder: str | Path,
    *,
    sheet_size: tuple[float, float] = (600.0, 400.0),
    margin: float = 2.0,
    kerf: float | None = 0.0,
    holding: HoldingTabs | None = None,
    step: bool = True,
    pictures: bool = True,
    parts: bool = True,
    force: bool = False,
    done: Callable[[str, int], None] | None = None,
) -> SavedKit:
    """Nested sheets and parts (DXF, SVG), cut list, report, assembly (STEP) and pictures of a model.

    Parameters
    ----------
    model : Model
    folder : path-like
        Made if need be.
    sheet_size : (float, float)
        Of the sheets that are cut, mm.
    margin : float
        Least distance between parts, mm.
    kerf : float or None
        Width of the cut, mm; None for each sheet's own.
    holding : HoldingTabs, optional
        Bridges that hold parts in the sheet; none unless given.
    step, pictures, parts : bool
        Write the assembly (with a CAD kernel), the pictures (with matplotlib), every part in files of its own.
    force : bool
        Overwrite files that exist.
    done : callable, optional
        Called with the name of each file that has been written, and how many there are in all.

    Returns
    -------
    SavedKit
        The folder and its files; printed, a few lines for the one who waits.

    Raises
    ------
    InputError
        Parts larger than a sheet, files that exist.
    """
    cutting = Cutting(kerf=kerf, holding=holding)
    design = Design(name=model.name, wishes=(), nesting=Nesting(sheet_size, margin), cutting=cutting)
    kit = kit_of(design, model, effects=True)
    write_kit(kit, folder, step=step, pictures=pictures, parts=parts, force=force, done=done)
    count, unlike, sheets = len(model.placed), len(model.parts), len(kit.nests)
    summary = (
        f"{model.name}: {count} {'strip' if count == 1 else 'strips'} ({unlike} different) "
        f"on {sheets} {'sheet' if sheets == 1 else 'sheets'}"
    )
    return SavedKit(Path(folder), tuple(kit.files), left_out(step=step, pictures=pictures), summary)


def _plan(kit: Kit, *, step: bool, pictures: bool, parts: bool) -> None:
    """Say which files there will be, and how each is written."""
    name, files = file_word(kit.model.name), kit.files
    for nest in kit.nests:
        if nest.sheet is not None:
            _add_drawing(kit, file_word(nest.name), nest, nest.sheet, "nested sheet")
    on_sheets = {
        piece: f"{file_word(nest.name)}.{_suffix(kit)}" for nest in kit.nests for piece in nest.pieces
    }
    for piece in kit.pieces if parts else ():
        if any(file.casefold() == f"{piece.file_stem}.svg".casefold() for file in files):
            raise InputError(
                f"{piece.name}: another part would be written to {piece.file_stem}.svg too; choose labels that "
                "differ in more than capitals and signs"
            )
        _add_drawing(kit, piece.file_stem, piece.drawing, piece.sheet, "part")
    own = {piece.name: f"{piece.file_stem}.{_suffix(kit)}" for piece in kit.pieces}
    listed = cut_list(kit.pieces, own if parts else on_sheets)
    files[f"{name}-cut-list.csv"] = ("cut list", lambda path: _write_text(path, listed.csv))
    files[f"{name}-cut-list.txt"] = ("cut list", lambda path: _write_text(path, str(listed)))
    if step:
        files[f"{name}.step"] = ("assembly", lambda path: _write_step(kit, path))
    if pictures:
        files[f"{name}.png"] = ("picture of the model", lambda path: _draw_model(kit, path))
        for nest in kit.nests:
            files[f"{file_word(nest.name)}.png"] = ("picture of a sheet", _nest_picture(nest))
    files[f"{name}.json"] = ("report", lambda path: _write_report(kit, path))


def _suffix(kit: Kit) -> str:
    # R12 has no header for its unit, so the name says it
    return "mm.dxf" if kit.design.cutting.version == "R12" else "dxf"


def _add_drawing(kit: Kit, stem: str, drawing: Any, sheet: Sheet, what: str) -> None:
    """The drawing as DXF and SVG."""
    cutting = kit.design.cutting
    if cutting.kerf is None and sheet.kerf == 0:
        raise InputError(f"no kerf is known for {sheet.name}: give a number of mm instead of the word sheet")
    options: dict[str, Any] = {
        "kerf": sheet.kerf if cutting.kerf is None else cutting.kerf,
        "curves": cutting.curves,
        "tolerance": cutting.tolerance,
        "holding": cutting.holding,
    }
    dxf = f"{stem}.{_suffix(kit)}"
    kit.files[dxf] = (what, lambda path: _saved(drawing, path, version=cutting.version, **options))
    kit.files[f"{stem}.svg"] = (what, lambda path: _saved(drawing, path, **options))


def _saved(drawing: Any, path: Path, **options: Any) -> None:
    save(drawing, path, **options)


def _write_text(path: Path, text: str) -> None:
    path.write_text(text, encoding="utf-8", newline="\n")


def _write_report(kit: Kit, path: Path) -> None:
    kinds = {name: kind for name, (kind, _) in kit.files.items()}
    listed = cut_list(kit.pieces)
    report = model_report(
        kit.model,
        cut_list=listed,
        nests=kit.nests,
        files=kinds,
        effects=kit.effects,
        wishes=kit.design.wishes,
    )
    report["reports"] += kit.notes
    _write_text(path, json.dumps(report, indent=1) + "\n")


def _write_step(kit: Kit, path: Path) -> None:
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


def _draw_model(kit: Kit, path: Path) -> None:
    from elastica_cad import plot

    plot.save_figure(plot.model(kit.model), path)


def _nest_picture(nest: NestedSheet) -> Writer:
    def draw(path: Path) -> None:
        from elastica_cad import plot

        plot.save_figure(plot.drawing(nest), path)

    return draw
