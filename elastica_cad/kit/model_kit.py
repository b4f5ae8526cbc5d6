"""Kit of a model: nested sheets, parts, lists, report, assembly and pictures in one folder."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache, partial
from io import BytesIO
from pathlib import Path
from typing import TYPE_CHECKING, Any
from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

import numpy as np

from elastica_cad._text import distinct, file_word
from elastica_cad._values import and_more, counted, require_path, require_record
from elastica_cad.design.kit_spec import DEFAULT_CUTTING, Cutting, KitSpec
from elastica_cad.design.measuring_sheet import measuring_of, measuring_page
from elastica_cad.design.model_report import compose_start_page
from elastica_cad.errors import one_of_each
from elastica_cad.files import step_trouble
from elastica_cad.formats.write_files import File, check_folder, text_file, write_json, write_text
from elastica_cad.geometry.path import Path as ClosedPath
from elastica_cad.kit.kit import Kit, can_draw, cutting_files, left_out
from elastica_cad.kit.kit_contents import KitContents, count_strips, kit_contents
from elastica_cad.model.assembly import engraved_marks, single_holders
from elastica_cad.model.cut_rows import CutListRow
from elastica_cad.model.fixtures import EndFixture
from elastica_cad.model.model import Model
from elastica_cad.model.nesting import NestedSheet, Nesting, nest_pieces
from elastica_cad.strip.drawing import CUT_OUTER, SHEET, Drawing, LayeredPath
from elastica_cad.strip.holding_template import holding_template
from elastica_cad.strip.pieces import Piece, strip_pieces
from elastica_cad.strip.uncuttable_parts import DEFAULT_LIMITS, FabricationLimits

if TYPE_CHECKING:
    from elastica_cad.kernel.step_files import NamedShape

PARTS, SHEETS, MODEL = "parts", "sheets", "model"
"""Subfolders of a kit. The start page, the lists and the report are in the folder of the kit itself."""

START_PAGE = "index.html"

FRAME_MM = 4.0
"""Distance between a printed template and the cutting line around it, mm."""


@dataclass(frozen=True)
class SavedKit:
    """Result of `save_model`. `str()` returns a summary with the folder and the omitted files.

    Attributes
    ----------
    folder : Path
    files : tuple of str
        Names of the files, relative to the folder.
    left_out : tuple of str
        Sentences on requested files that could not be written, with the reason.
    summary : str
        Sentence with the numbers of strips and sheets.
    """

    folder: Path
    files: tuple[str, ...]
    left_out: tuple[str, ...]
    summary: str

    def __fspath__(self) -> str:
        return str(self.folder)

    def __str__(self) -> str:
        return "\n".join((self.summary, *self.left_out, f"wrote {len(self.files)} files to {self.folder}"))


def check_kit_folder(name: str, folder: str | Path, *, force: bool = False) -> None:
    """Raise InputError if the kit of a model with this name cannot be written to the folder.

    Call this function before the model is computed. A folder with the lists of a kit is refused without `force`.
    """
    check_folder(folder, _list_names(file_word(name)), force=force)


def model_kit(
    contents: KitContents,
    *,
    step: bool = True,
    pictures: bool = True,
    parts: bool = True,
    archives: bool = False,
) -> Kit:
    """Return the report and the files of a model, without files that require a missing package.

    Parameters
    ----------
    contents : KitContents
    step : bool
        If True, include the assembly and the blocks to be printed.
    pictures : bool
        If True, include the assembly sheet and pictures.
    parts : bool
        If True, include a file for every part. Files for a cutting service always contain every part, and no
        nested sheets.
    archives : bool
        If True, include two ZIP files. The first contains the files to cut or print, with every part once. The
        second contains all files except DXF and STL.
    """
    model, spec, cutting = contents.model, contents.spec, contents.spec.cutting
    parts, step, pictures = parts or cutting.service, step and not step_trouble(), pictures and can_draw()
    name, files = file_word(model.name), list[File]()
    blocks = (
        replace(row, file=f"{PARTS}/{row.file}" if step else "not written")
        for row in contents.cut_list.printed
    )
    listed = replace(
        contents.cut_list, rows=tuple(_rows_in_files(contents, parts=parts)), printed=tuple(blocks)
    )
    csv, txt, json, page = _list_names(name)
    if pictures:
        from elastica_cad.plot.assembly_sheet import save_assembly_sheet
        from elastica_cad.plot.canvas import draw_file
        from elastica_cad.plot.model_pictures import model as draw_model
        from elastica_cad.plot.strip_pictures import drawing as draw_nest

        draw_assembly = partial(
            save_assembly_sheet,
            model,
            holders=contents.holders,
            cut_list=listed,
            language=spec.language or "en",
        )
        files.append(File(f"{name}-assembly.pdf", draw_assembly, "assembly sheet"))
    if spec.pages and can_draw():
        files.append(
            File(
                f"{name}-pages.pdf",
                partial(_draw_pages, contents),
                "parts and templates at full size on paper",
            )
        )
    files += [text_file(csv, listed.csv, "cut list"), text_file(txt, str(listed), "cut list")]
    if step:
        from elastica_cad.kernel.mesh_files import write_glb
        from elastica_cad.kernel.step_files import model_shapes, write_step

        shapes = cache(partial(model_shapes, model, contents.holders))
        files += (
            File(
                f"{MODEL}/{name}.step",
                lambda path: write_step(shapes(), path, name=model.name),
                "assembly for CAD programs",
            ),
            File(
                f"{MODEL}/{name}.glb",
                lambda path: write_glb(shapes(), path, name=model.name),
                "assembly for browsers and phones",
            ),
        )
    if pictures:
        picture = partial(draw_file, partial(draw_model, model, holders=contents.holders))
        files.append(File(f"{MODEL}/{name}.png", picture, "picture of the model"))
    for stem, nest in () if cutting.service else _stems_of_nests(contents):
        if nest.sheet is not None:
            files += cutting_files(nest, stem, cutting, nest.sheet, "nested sheet")
        if pictures:
            files.append(
                File(f"{stem}.png", partial(draw_file, partial(draw_nest, nest)), "picture of a sheet")
            )
    # a model of rods has no sheets
    plans = _plans(contents) if pictures and cutting.service and contents.nests else ()
    for number, plan in enumerate(plans, start=1):
        drawn = partial(draw_file, partial(draw_nest, plan))
        files.append(
            File(f"{name}-plan-{number}.pdf", drawn, "plan: names, starts (1), ends (2) and slots of parts")
        )
    for stem, piece in _stems_of_parts(contents) if parts else ():
        if piece.is_rod and cutting.service:
            continue
        kind = "side view of a rod" if piece.is_rod else "part"
        files += cutting_files(piece.drawing, stem, cutting, piece.sheet, kind)
    if step:
        to_print, holders = contents.blocks, [*single_holders(contents.holders)]
        stems = distinct(file_word(block.label) for block in to_print)
        # the bodies of the holders come last in the assembly
        places = [k - len(holders) for k, holder in enumerate(holders) if isinstance(holder, EndFixture)]
        files += [
            File(f"{PARTS}/{stem}.stl", partial(_save_block, block, place, shapes), "block to print")
            for stem, block, place in zip(stems, to_print, places, strict=True)
        ]
    files.append(File(json, lambda path: write_json(path, report), "report"))
    files.append(File(page, lambda path: write_text(path, _start_page(contents, report)), "this page"))
    if archives:
        # one archive has the cut list and the files to cut or print, every part once; the other has all files
        # except DXF and STL
        names, place = [file.name for file in files], PARTS if cutting.service else SHEETS
        cut = [
            name
            for name in names
            if name in (csv, txt) or Path(name).match(f"{place}/*.dxf") or name.endswith(".stl")
        ]
        viewed = [file for file in names if not file.endswith((".dxf", ".stl"))]
        files += (
            File(
                f"{name}-cut.zip", lambda path: pack_files(path.parent, cut, path), "what is cut or printed"
            ),
            File(f"{name}-look.zip", lambda path: pack_files(path.parent, viewed, path), "what is looked at"),
        )
    report = contents.report | {"files": {file.name: file.description for file in files}}
    return Kit(tuple(files), report)


def left_behind(kit: Kit, folder: str | Path) -> tuple[str, ...]:
    """Return part and sheet files in a folder that are left over from an earlier run."""
    names = {file.name for file in kit.files}
    return tuple(
        name
        for place in (PARTS, SHEETS)
        for name in sorted(f"{place}/{path.name}" for path in Path(folder, place).glob("*.*"))
        if name not in names and name.endswith((".dxf", ".svg", ".stl"))
    )


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
    """Write the kit of a model to a folder.

    A kit has nested sheets and parts (DXF, SVG), cut list, report, assembly (STEP) and pictures.

    Parameters
    ----------
    model : Model
    folder : path-like
        Folder, which is created if necessary.
    sheet_size : (float, float)
        Size of the sheets, mm.
    margin : float
        Least distance between parts, mm.
    cutting : Cutting
        Options of the cutting files: kerf, curves, bridges, guide lines and recipient.
    step, pictures, parts : bool
        If True, write the assembly (needs a CAD kernel), the pictures (need matplotlib), or separate files of
        every part.
    force : bool
        If True, existing files are overwritten.
    done : callable, optional
        Function that is called with the name of each written file and the total number of files.
    shop : FabricationLimits
        Limits of the workshop.
    ignore_limits : bool
        If True, strips outside these limits are written too, and the report lists their faults.

    Returns
    -------
    SavedKit
        The folder and its files.

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
    require_record(model, Model, "The model", "a Model, such as Model([Placed(strip)])")
    folder = require_path(folder)
    check_kit_folder(model.name, folder, force=force)
    contents = kit_contents(model, spec, effects=True)
    kit = model_kit(contents, step=step, pictures=pictures, parts=parts)
    kit.write(folder, force=force, done=done)
    summary = f"{model.name}: {count_strips(model)} on {counted(len(contents.nests), 'sheet')}"
    missing = left_out(step=step, pictures=pictures, paper=bool(spec.pages), blocks=contents.names_of_blocks)
    return SavedKit(folder, tuple(file.name for file in kit.files), missing, summary)


def _list_names(word: str) -> tuple[str, ...]:
    return f"{word}-cut-list.csv", f"{word}-cut-list.txt", f"{word}.json", START_PAGE


def _draw_pages(contents: KitContents, path: Path) -> None:
    """Write a PDF file that shows every part once, at full size, with the quantity. Small parts share pages.

    If the model has no holders, templates for holding strips and pages for measurements are added.
    """
    from elastica_cad.plot.template_pages import printed_size, save_templates

    paper, margin = str(contents.spec.pages), contents.spec.nesting.margin
    size = printed_size(paper)
    held_by_hand = not (contents.holders or contents.model.plates)
    pieces = (*contents.pieces, *(_templates(contents.model) if held_by_hand else ()))
    called = {
        piece.name: f"{piece.name} (cut {piece.count})" if piece.count > 1 else piece.name for piece in pieces
    }
    small, drawings = [], []
    for piece in pieces:
        if (np.sort(piece.size) + 2 * margin <= size).all():
            # paper has no grain, so parts may be rotated
            small.append(replace(piece, count=1, sheet=replace(piece.sheet, grain="none")))
        else:
            drawings.append(replace(piece.drawing, name=called[piece.name]))
    for nest in nest_pieces(small, sheet_size=size, margin=margin, kerf=0.0):
        cut = tuple(item for item in nest.paths if item.layer != SHEET)
        names = ", ".join(called[name] for name in nest.pieces)
        # a long title names only the first part
        if len(names) > 90:
            names = f"{called[nest.pieces[0]]}{and_more(nest.pieces)}"
        drawings.append(Drawing(names, cut, nest.texts))
    drawings += [
        measuring_page(part["name"], measuring_of(part["measuring"]))
        for part in (contents.report["parts"] if held_by_hand else ())
        if part["measuring"] is not None
    ]
    save_templates(drawings, path, title=f"{contents.model.name}: parts", paper=paper)


def _templates(model: Model) -> list[Piece]:
    """Return framed paper templates for holding the strips of a model, to be nested like parts."""
    templates = []
    for part in model.parts:
        if part.strip.is_closed:
            continue
        template = holding_template(part.strip.labelled(part.name))
        (x, y), high = template.bounds
        width, height = high - (x, y) + 2 * FRAME_MM
        frame = ClosedPath.rectangle(width, height, corner=(x - FRAME_MM, y - FRAME_MM))
        framed = replace(template, paths=(LayeredPath(CUT_OUTER, frame), *template.paths))
        templates.append(Piece(template.name, framed, replace(part.strip.sheet, name="paper")))
    return templates


def _plans(contents: KitContents) -> tuple[NestedSheet, ...]:
    """Return pages with each part once, and with the texts that a cutting service does not engrave."""
    parts = [
        replace(part, strip=replace(part.strip.labelled(part.name), unmarked=False))
        for part in contents.model.parts
    ]
    strips, nesting = strip_pieces(parts, numbered=True), contents.spec.nesting
    shown = {piece.name: replace(piece, count=1) for piece in (*contents.pieces, *strips)}
    return nest_pieces(
        [piece for piece in shown.values() if not piece.is_rod],
        sheet_size=tuple(np.max([nest.sheet_size for nest in contents.nests], axis=0)),
        margin=nesting.margin, grain=nesting.grain, kerf=0.0, edge=False, name=f"{contents.model.name}-plan",
    )  # fmt: skip


def _stems_of_parts(contents: KitContents) -> Iterator[tuple[str, Piece]]:
    stems = distinct(piece.file_stem for piece in contents.pieces)
    yield from zip((f"{PARTS}/{stem}" for stem in stems), contents.pieces, strict=True)


def _stems_of_nests(contents: KitContents) -> Iterator[tuple[str, NestedSheet]]:
    stems = distinct(file_word(nest.name) for nest in contents.nests)
    yield from zip((f"{SHEETS}/{stem}" for stem in stems), contents.nests, strict=True)


def _rows_in_files(contents: KitContents, *, parts: bool) -> Iterator[CutListRow]:
    """Yield the rows of the cut list with the files that are written."""
    # name of the file of the nested sheet that contains each piece
    sheets = {piece: stem for stem, nest in _stems_of_nests(contents) for piece in nest.pieces}
    no_file = not parts or contents.spec.cutting.service
    for (stem, piece), row in zip(_stems_of_parts(contents), contents.cut_list.rows, strict=True):
        name = contents.spec.cutting.file_name(stem if parts else sheets.get(piece.name, ""), "dxf")
        number = "" if contents.spec.cutting.service else row.number
        yield replace(row, file="" if piece.is_rod and no_file else name, number=number)


def _start_page(contents: KitContents, report: Mapping[str, Any]) -> str:
    listed = contents.cut_list
    lines = [
        f"{count_strips(contents.model)}; {counted(listed.count, 'piece')}, "
        f"{listed.cut_length / 1000:.1f} m of cuts, {listed.mass:.0f} g.",
        *(
            f"{nest.name}: {counted(len(nest.pieces), 'piece')} {'take' if nest.pieces[1:] else 'takes'} "
            f"{100 * nest.share:.0f} % of a sheet of "
            f"{nest.sheet_size[0]:g} by {nest.sheet_size[1]:g} mm."
            for nest in contents.nests
        ),
        *(
            f"To buy: {item}{'; saw from each, mm: ' * bool(item.sawn)}{'; '.join(item.sawn)}."
            for item in listed.stock
        ),
        *_block_lines(contents, report["files"]),
        *["Nothing is written on the parts: write the name of its file on each when they arrive."]
        * contents.spec.cutting.service,
        " ".join(engraved_marks(contents.model, (*contents.model.plates, *contents.holders))),
    ]
    files = {file: what for file, what in report["files"].items() if file != START_PAGE}
    return compose_start_page(contents.model.name, lines, [*one_of_each(report["reports"])], files)


def _block_lines(contents: KitContents, files: Iterable[str]) -> list[str]:
    """Return the line on printed blocks and their files; none without blocks."""
    count = len(contents.blocks)
    if not count:
        return []
    files = [file for file in files if file.endswith(".stl")]
    blocks = f"{counted(count, 'block')} to print"
    if not files:
        return [f"{blocks}: without STEP files they are left out."]
    return [f"{blocks}: {files[0]}{f' to {files[-1]}' if count > 1 else ''}, foot down."]


def pack_files(folder: Path, names: Sequence[str], target: Path | BytesIO) -> None:
    """Write files of a folder to a ZIP archive."""
    with ZipFile(target, "w") as archive:
        for name in names:
            entry = ZipInfo(name)
            # without this mode, only root could read the unpacked files on Unix
            entry.external_attr = 0o644 << 16
            archive.writestr(entry, (folder / name).read_bytes(), ZIP_DEFLATED)


def _save_block(block: EndFixture, place: int, shapes: "Callable[[], list[NamedShape]]", path: Path) -> None:
    from elastica_cad.kernel.mesh_files import write_stl

    write_stl(shapes()[place].shape, path, bed=block.ground)
