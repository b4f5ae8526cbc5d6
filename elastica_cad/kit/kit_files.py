"""A kit written into one folder: all files together, or none."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cache, partial
from importlib.util import find_spec
from pathlib import Path
from typing import Any
from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

import numpy as np

from elastica_cad._process import rare_collections
from elastica_cad._values import and_more, counted, require_path, require_record
from elastica_cad.design.kit_spec import DEFAULT_CUTTING, Cutting, KitSpec
from elastica_cad.design.model_report import compose_start_page
from elastica_cad.errors import InputError, how_to_install, refusing_old_names
from elastica_cad.files import step_trouble
from elastica_cad.formats.write_files import check_folder, write_json, write_text, write_together
from elastica_cad.geometry.path import Path as ClosedPath
from elastica_cad.kit.cutting_files import Writer, cutting_files
from elastica_cad.kit.kit_contents import Kit, count_strips, kit_of
from elastica_cad.model.fixtures import EndFixture
from elastica_cad.model.model import Model
from elastica_cad.model.nesting import CutList, NestedSheet, Nesting, nest_pieces
from elastica_cad.strip.drawing import CUT_OUTER, SHEET, Drawing, LayeredPath
from elastica_cad.strip.holding_template import holding_template
from elastica_cad.strip.pieces import Piece, distinct, file_word
from elastica_cad.strip.uncuttable_parts import DEFAULT_LIMITS, FabricationLimits

PARTS, SHEETS, MODEL = "parts", "sheets", "model"
"""Folders of a kit; the start page, lists and the report lie beside them."""

START_PAGE = "index.html"

FRAME_MM = 4.0
"""Between a printed template and the frame that it is cut out by."""

LONGEST_TITLE = 90
"""Letters over a page that names all its parts; longer ones name the first."""

CUT_FROM = (".dxf", ".svg", ".stl")
"""Kinds of files that workshops make parts of."""


@dataclass(frozen=True)
class SavedKit:
    """The folder that `save_model` wrote; as text, where it is and what was left out.

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


def left_out(*, step: bool = True, pictures: bool = True, paper: bool = False) -> tuple[str, ...]:
    """Return a sentence for the files of each package that is missing, with how to install it."""
    drawn = " and ".join(kind for asked, kind in ((paper, "PDF"), (pictures, "pictures")) if asked)
    missing = [(drawn, "" if find_spec("matplotlib") else how_to_install("matplotlib"))]
    missing += [("STEP", step_trouble())] if step else []
    return tuple(f"not written: {kind}; to get it: {cure}" for kind, cure in missing if kind and cure)


def check_kit_folder(name: str, folder: str | Path, *, force: bool = False) -> None:
    """Refuse a folder that the kit of a model of this name cannot be written to, before the model is made.

    Raises
    ------
    InputError
        It cannot be written to, or lists of the kit exist in it, without `force`.
    """
    check_folder(folder, _lists(file_word(name)), force=force)


def write_kit(
    kit: Kit,
    folder: str | Path,
    *,
    step: bool = True,
    pictures: bool = True,
    parts: bool = True,
    archives: bool = False,
    force: bool = False,
    done: Callable[[str, int], None] | None = None,
) -> None:
    """Write all files of a kit; the assembly and the pictures where a CAD kernel and matplotlib are installed.

    Without `parts` only the nested sheets are drawn, not every part once more in files of its own. For a cutting
    service only the parts are drawn. With `archives` two ZIP files are written too: one of the drawings and blocks
    that are made, each part in one drawing, and one of what is not for a machine.
    `done` is called with the name of each file that has been written, and how many there are in all.

    Raises
    ------
    InputError
        Files that exist, without `force`.
    """
    parts = parts or kit.spec.cutting.service
    step, pictures = step and not step_trouble(), pictures and find_spec("matplotlib") is not None
    _plan(kit, step=step, pictures=pictures, parts=parts)
    if archives:
        kit.files.update(_archives(kit))
    with write_together(folder, kit.files, force=force) as workshop:
        for name, (_, write) in kit.files.items():
            write(workshop / name)
            if done is not None:
                done(name, len(kit.files))


def left_behind(kit: Kit, folder: str | Path) -> tuple[str, ...]:
    """Files among the parts and sheets in a folder that are none of the kit written there: an earlier run's."""
    return tuple(
        name
        for place in (PARTS, SHEETS)
        for name in sorted(f"{place}/{path.name}" for path in Path(folder, place).glob("*.*"))
        if name not in kit.files and Path(name).suffix in CUT_FROM
    )


@refusing_old_names
def save_model(
    model: Model,
    folder: str | Path,
    *,
    sheet_size: tuple[float, float] = (600.0, 400.0),
    margin: float = 2.0,
    cutting: Cutting = DEFAULT_CUTTING,
    step: bool = True,
    pictures: bool = True,
    parts: bool = True,
    force: bool = False,
    done: Callable[[str, int], None] | None = None,
    shop: FabricationLimits = DEFAULT_LIMITS,
    ignore_limits: bool = False,
) -> SavedKit:
    """Write a model's nested sheets and parts (DXF, SVG), cut list, report, assembly (STEP) and pictures into a
    folder.

    Parameters
    ----------
    model : Model
    folder : path-like
        Made if need be.
    sheet_size : (float, float)
        Of the sheets that are cut, mm.
    margin : float
        Least distance between parts, mm.
    cutting : Cutting
        Kerf, curves, bridges, guide lines and recipient of the cutting files, from `elastica_cad.formats`.
    step, pictures, parts : bool
        Write the assembly (with a CAD kernel), the pictures (with matplotlib), every part in files of its own.
    force : bool
        Overwrite files that exist.
    done : callable, optional
        Called with the name of each file that has been written, and how many there are in all.
    shop : FabricationLimits
        What the workshop can make.
    ignore_limits : bool
        Write strips that it cannot, and say so in the report.

    Returns
    -------
    SavedKit
        The folder and its files.

    Raises
    ------
    InputError
        Parts larger than a sheet, strips that cannot be cut and handled, files that exist.

    Examples
    --------
    >>> from tempfile import TemporaryDirectory
    >>> from elastica_cad.model.model import Placed
    >>> from elastica_cad.strip.strip_spec import make_strip
    >>> from elastica_cad.geometry.plane_curve import PlaneCurve
    >>> arch = make_strip(PlaneCurve.arc((0, 0), 60, 0.3, 3.1), "birch-plywood-0.8", max_width=30, label="A")
    >>> model = Model([Placed(arch, (0, 0, 0), (1, 0, 0), (0, 0, 1))], name="arch")
    >>> with TemporaryDirectory() as folder:
    ...     print(save_model(model, folder, step=False, pictures=False).summary)
    arch: 1 strip on 1 sheet
    """
    require_record(cutting, Cutting, "cutting", "a Cutting, such as Cutting(kerf=0.15)")
    spec = KitSpec(Nesting(sheet_size, margin), cutting, shop=shop, ignore_limits=ignore_limits)
    if not isinstance(model, Model):
        raise InputError(
            "the model is a {name}: give a Model, such as Model([Placed(strip)])", name=type(model).__name__
        )
    folder = require_path(folder)
    check_kit_folder(model.name, folder, force=force)
    with rare_collections():
        kit = kit_of(model, spec, effects=True)
        write_kit(kit, folder, step=step, pictures=pictures, parts=parts, force=force, done=done)
    summary = f"{model.name}: {count_strips(model)} on {counted(len(kit.nests), 'sheet')}"
    return SavedKit(
        folder, tuple(kit.files), left_out(step=step, pictures=pictures, paper=bool(spec.pages)), summary
    )


def _lists(word: str) -> tuple[str, ...]:
    """The files of every kit: the cut list as a table and as text, the report, the start page."""
    return f"{word}-cut-list.csv", f"{word}-cut-list.txt", f"{word}.json", START_PAGE


def _plan(kit: Kit, *, step: bool, pictures: bool, parts: bool) -> None:
    """Say which files there will be, and how each is written."""
    name, files, cutting = file_word(kit.model.name), kit.files, kit.spec.cutting
    listed = kit.cut_list.in_files(_homes(kit, parts=parts))
    table, text, report, page = _lists(name)
    if pictures:
        files[f"{name}-assembly.pdf"] = ("assembly sheet", lambda path: _draw_assembly(kit, listed, path))
    if kit.spec.pages and find_spec("matplotlib"):
        files[f"{name}-pages.pdf"] = ("parts at full size on paper", lambda path: _draw_pages(kit, path))
    files[table] = ("cut list", lambda path: write_text(path, listed.csv))
    files[text] = ("cut list", lambda path: write_text(path, str(listed)))
    if step:
        files.update(_assemblies(kit, f"{MODEL}/{name}"))
    if pictures:
        files[f"{MODEL}/{name}.png"] = ("picture of the model", lambda path: _draw_model(kit, path))
    for nest in () if cutting.service else kit.nests:
        stem = f"{SHEETS}/{file_word(nest.name)}"
        if nest.sheet is not None:
            files |= _told("nested sheet", cutting_files(nest, stem, cutting, nest.sheet))
        if pictures:
            files[f"{stem}.png"] = ("picture of a sheet", _nest_picture(nest))
    for piece in kit.pieces if parts else ():
        stem = f"{PARTS}/{piece.file_stem}"
        if any(file.casefold() == cutting.file_name(stem, "svg").casefold() for file in files):
            raise InputError(
                "{name}: another part would be written to {file_stem}.svg too; choose labels that "
                "differ in more than capitals and signs",
                name=piece.name,
                file_stem=piece.file_stem,
            )
        files |= _told("part", cutting_files(piece.drawing, stem, cutting, piece.sheet))
    if step:
        files.update(_blocks(kit))
    files[report] = ("report", lambda path: write_json(path, kit_report(kit)))
    files[page] = ("this page", lambda path: write_text(path, _start_page(kit)))


def _draw_pages(kit: Kit, path: Path) -> None:
    """Every part once at full size, small ones of a sheet together; a page tells how often each is needed.

    Where the model has no part that holds its strips, a template to hold each by is printed after them.
    """
    from elastica_cad.plot.template_pages import printed_size, save_templates

    paper, margin = str(kit.spec.pages), kit.spec.nesting.margin
    size = printed_size(paper)
    pieces = (*kit.pieces, *_templates(kit))
    called = {
        piece.name: f"{piece.name} (cut {piece.count})" if piece.count > 1 else piece.name for piece in pieces
    }
    small, drawings = [], []
    for piece in pieces:
        if np.all(np.sort(piece.size) + 2 * margin <= size):
            small.append(replace(piece, count=1, sheet=replace(piece.sheet, grain="none")))  # none on paper
        else:
            drawings.append(replace(piece.drawing, name=called[piece.name]))
    for nest in nest_pieces(small, sheet_size=size, margin=margin, kerf=0.0):
        cut = tuple(one for one in nest.paths if one.layer != SHEET)
        names = ", ".join(called[name] for name in nest.pieces)
        if len(names) > LONGEST_TITLE:
            names = f"{called[nest.pieces[0]]}{and_more(nest.pieces)}"
        drawings.append(Drawing(names, cut, nest.texts))
    save_templates(drawings, path, title=f"{kit.model.name}: parts", paper=paper)


def _templates(kit: Kit) -> list[Piece]:
    """The holding template of each strip of a model that holds none of them, in a frame to cut out."""
    if kit.holders or kit.model.plates:
        return []
    found = []
    for part in kit.model.parts:
        if part.strip.is_closed:
            continue
        drawn = holding_template(part.strip.labelled(part.name))
        (x, y), high = drawn.bounds
        width, height = high - (x, y) + 2 * FRAME_MM
        frame = ClosedPath.rectangle(width, height, corner=(x - FRAME_MM, y - FRAME_MM))
        framed = replace(drawn, paths=(LayeredPath(CUT_OUTER, frame), *drawn.paths))
        found.append(Piece(drawn.name, framed, replace(part.strip.sheet, name="paper")))
    return found


def _homes(kit: Kit, *, parts: bool) -> dict[str, str]:
    """The file that each piece is cut from: its own, or that of its sheet."""
    named = kit.spec.cutting.file_name
    if parts:
        return {piece.name: f"{PARTS}/{named(piece.file_stem, 'dxf')}" for piece in kit.pieces}
    return {
        piece: f"{SHEETS}/{named(file_word(nest.name), 'dxf')}" for nest in kit.nests for piece in nest.pieces
    }


def _start_page(kit: Kit) -> str:
    """What was made, in sentences, with links."""
    listed = kit.cut_list
    lines = [
        f"{count_strips(kit.model)}; {counted(listed.count, 'piece')}, "
        f"{listed.cut_length / 1000:.1f} m of cuts, {listed.mass:.0f} g.",
        *(
            f"{nest.name}: {_taken(len(nest.pieces))} {100 * nest.share:.0f} % of a sheet of "
            f"{nest.sheet_size[0]:g} by {nest.sheet_size[1]:g} mm."
            for nest in kit.nests
        ),
        *_block_lines(kit),
        "Ends are numbered: end 1 is where a strip's label begins, end 2 where it ends; slot A:1 takes end 1 of A."
        if not kit.spec.cutting.service
        else "Nothing is written on the parts: write the name of its file on each when they arrive.",
    ]
    files = {file: what for file, (what, _) in kit.files.items() if file != START_PAGE}
    return compose_start_page(kit.model.name, lines, kit_report(kit)["reports"], files)


def _taken(pieces: int) -> str:
    return f"{counted(pieces, 'piece')} {'takes' if pieces == 1 else 'take'}"


def _block_lines(kit: Kit) -> list[str]:
    """How many blocks are printed, and from which files."""
    count = len(_printed(kit))
    if not count:
        return []
    files = [file for file in kit.files if file.endswith(".stl")]
    blocks = f"{counted(count, 'block')} to print"
    if not files:
        return [f"{blocks}: without STEP files they are left out."]
    return [f"{blocks}: {files[0]}{f' to {files[-1]}' if count > 1 else ''}, foot down."]


def _told(kind: str, files: dict[str, Writer]) -> dict[str, tuple[str, Writer]]:
    """The files, each with what it is."""
    return {name: (kind, write) for name, write in files.items()}


def _archives(kit: Kit) -> dict[str, tuple[str, Writer]]:
    """What is cut or printed, each part in one drawing, and what is looked at."""
    name, place = file_word(kit.model.name), PARTS if kit.spec.cutting.service else SHEETS
    made = [file for file in kit.files if file.endswith(".stl") or Path(file).match(f"{place}/*.dxf")]
    seen = [file for file in kit.files if not file.endswith((".dxf", ".stl"))]
    return {
        f"{name}-cut.zip": ("what is cut or printed", partial(_pack, made)),
        f"{name}-look.zip": ("what is looked at", partial(_pack, seen)),
    }


def _pack(files: Sequence[str], path: Path) -> None:
    """Write files that lie beside the archive into it, by their names and without the time."""
    with ZipFile(path, "w") as archive:
        for name in files:
            entry = ZipInfo(name)
            entry.external_attr = 0o644 << 16  # else nobody but root may read what Unix unpacks
            archive.writestr(entry, (path.parent / name).read_bytes(), ZIP_DEFLATED)


def kit_report(kit: Kit) -> dict[str, Any]:
    """All numbers of a kit, as its report file has them."""
    return kit.report | {"files": {name: kind for name, (kind, _) in kit.files.items()}}


def _assemblies(kit: Kit, stem: str) -> dict[str, tuple[str, Writer]]:
    """The files that a CAD kernel writes, and how; the bodies are made once for all."""
    from elastica_cad.kernel.mesh_files import write_glb
    from elastica_cad.kernel.step_files import model_shapes, write_step

    shapes = cache(lambda: model_shapes(kit.model, kit.holders))
    name = kit.model.name
    return {
        f"{stem}.step": ("assembly for CAD programs", lambda path: write_step(shapes(), path, name=name)),
        f"{stem}.glb": (
            "assembly for browsers and phones",
            lambda path: write_glb(shapes(), path, name=name),
        ),
    }


def _blocks(kit: Kit) -> dict[str, tuple[str, Writer]]:
    """Each block to print, as it stands on the printer's bed."""
    blocks = _printed(kit)
    stems = distinct(file_word(block.label) for block in blocks)
    return {
        f"{PARTS}/{stem}.stl": ("block to print", partial(_write_block, block))
        for stem, block in zip(stems, blocks, strict=True)
    }


def _printed(kit: Kit) -> list[EndFixture]:
    return [holder for holder in kit.holders if isinstance(holder, EndFixture)]


def _write_block(block: EndFixture, path: Path) -> None:
    from elastica_cad.kernel.mesh_files import write_stl
    from elastica_cad.kernel.occt import make_solid

    write_stl(make_solid(block.solid), path, bed=block.ground)


def _draw_assembly(kit: Kit, listed: CutList, path: Path) -> None:
    from elastica_cad.plot.assembly_sheet import save_assembly_sheet

    save_assembly_sheet(kit.model, path, holders=kit.holders, cut_list=listed)


def _draw_model(kit: Kit, path: Path) -> None:
    from elastica_cad.plot.canvas import save_figure
    from elastica_cad.plot.model_pictures import model

    save_figure(model(kit.model, holders=kit.holders), path)


def _nest_picture(nest: NestedSheet) -> Writer:
    def draw(path: Path) -> None:
        from elastica_cad.plot.canvas import save_figure
        from elastica_cad.plot.strip_pictures import drawing

        save_figure(drawing(nest), path)

    return draw
