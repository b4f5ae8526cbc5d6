# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Writing of the cutting files of a document: DXF, SVG, STEP, nested sheets and cut list."""

import csv
import io
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from functools import partial
from importlib import import_module
from importlib.util import find_spec
from itertools import count, zip_longest
from pathlib import Path
from typing import Any

import FreeCAD as App
from freecad.elastica_wb.curves.part_shapes import make_solid
from freecad.elastica_wb.curves.sketch_curves import container, drawn_curve, frame_of
from freecad.elastica_wb.features.baseplate import plates_of
from freecad.elastica_wb.features.fixtures import block_shape, blocks_for
from freecad.elastica_wb.features.flexure import flexure_of
from freecad.elastica_wb.features.flexure import solids_of as flexure_solids
from freecad.elastica_wb.features.model import model_of, solids_of
from freecad.elastica_wb.features.pieces import Cut, counted, cuts_of, later_features
from freecad.elastica_wb.features.strip import strip_of
from freecad.elastica_wb.host.objects import is_flexure, is_model, is_plate
from freecad.elastica_wb.host.progress import Step, go_on
from freecad.elastica_wb.host.resources import translate
from freecad.elastica_wb.host.words import Unit, Words, user_language
from freecad.elastica_wb.solving.strip_cache import bent_shape, flat_shape

from elastica_cad._text import distinct, file_word
from elastica_cad.design.kit_spec import Cutting
from elastica_cad.design.reports import pre_bend_message
from elastica_cad.errors import InputError
from elastica_cad.formats.write_files import File, write_files, write_text
from elastica_cad.kit.kit import cutting_files
from elastica_cad.mechanics.sheets import sheet_color
from elastica_cad.model.cut_rows import cut_list
from elastica_cad.model.fixtures import FIXTURE_COLOR, EndFixture
from elastica_cad.model.nesting import nest_pieces
from elastica_cad.strip.solids import FlatSolid, frame_beside


def later_feature_messages(obj: Any) -> list[str]:
    """Return a warning if a later feature of a body changes the object, because the files omit this change."""
    words = translate(
        "Elastica",
        "The cutting files show {strip} without {later}, a later feature of its body. Use the slots, tabs "
        "and holes of the strip instead, or draw the change in the files.",
    )
    later = later_features(obj)
    return [words.format(strip=obj.Label, later=later)] if later else []


KINDS = ("dxf", "svg", "step", "csv", "nest")


def cutting_of(*, version: str = "R2010", **options: Any) -> Cutting:
    """Return the options of cutting files. Without ezdxf, the DXF version is R12."""
    return Cutting(version=version if find_spec("ezdxf") else "R12", **options)


def write_cutting_files(
    sources: Sequence[Any],
    folder: str | Path,
    *,
    kinds: Iterable[str] = KINDS,
    sheet_size: tuple[float, float] = (600.0, 400.0),
    cutting: Cutting | None = None,
    force: bool = False,
    step: Step | None = None,
) -> list[Path]:
    """Write the files of strips, models and base plates into a folder.

    `step` is called with the number of written files. If `step` returns False, no file remains.

    Raises
    ------
    InputError
        A file exists and `force` is False, a strip failed, or a piece is larger than the sheet.
    NotConvergedError
        The user stopped the work: `step` returned False.
    """
    kinds, cuts, cutting = list(kinds), cuts_of(sources), cutting or cutting_of()
    if not kinds:
        raise InputError("there is nothing to write: choose kinds of files")
    pieces = [cut.piece for cut in cuts]
    drawings = [(piece.file_stem, piece.drawing, piece.sheet) for piece in pieces]
    if "nest" in kinds:
        nests = nest_pieces(pieces, sheet_size=sheet_size, kerf=cutting.kerf)
        drawings += [(file_word(nest.name), nest, nest.sheet) for nest in nests]
    stems = distinct(stem for stem, *_ in drawings)
    flat = [kind for kind in ("dxf", "svg") if kind in kinds]
    files = [
        file
        for stem, (_, drawing, sheet) in zip(stems, drawings, strict=True)
        for file in cutting_files(replace(drawing, name=stem), stem, cutting, sheet)
        if file.name.rpartition(".")[2] in kinds
    ]
    sources = list(counted(sources))
    bodies = dict(zip(distinct(file_word(obj.Label) for obj in sources), sources, strict=True))
    if "step" in kinds:
        files += [File(f"{word}.step", partial(_write_step, obj)) for word, obj in bodies.items()]
    if "csv" in kinds:
        kind = flat[0] if flat else "dxf"
        cut_from = {
            piece.name: cutting.file_name(stem, kind) for stem, piece in zip(stems, pieces, strict=False)
        }
        blocks = {block.tab.key: (block, word) for word, obj in bodies.items() for block in blocks_for(obj)}
        cut_from |= {
            block.label: f"{word}.step" if "step" in kinds else "" for block, word in blocks.values()
        }
        printed = [block for block, _ in blocks.values()]
        files.append(
            File("cut-list.csv", lambda path: write_text(path, _cut_list_csv(cuts, printed, cut_from)))
        )
        files += [
            File(f"{word}-travel.csv", partial(write_text, text=flexure_of(obj).force_csv()))
            for word, obj in bodies.items()
            if is_flexure(obj)
        ]
    numbers = count()
    done = lambda *_: go_on(step, next(numbers), "no file was written")  # noqa: E731
    return list(write_files(files, folder, force=force, done=done))


def _cut_list_csv(cuts: Sequence[Cut], blocks: Sequence[EndFixture], files: Mapping[str, str]) -> str:
    text = cut_list((*(cut.piece for cut in cuts), *blocks), files).csv
    blanks = ["" if cut.strip is None else pre_bend_message(cut.strip) for cut in cuts]
    if not any(blanks):
        return text
    stream = io.StringIO()
    words = Words(user_language(), Unit("mm", 1.0), ".")
    column = ["bent_beforehand", *map(words.sentence, blanks)]
    rows = zip_longest(csv.reader(io.StringIO(text)), column, fillvalue="")
    csv.writer(stream, lineterminator="\n").writerows([*row, blank] for row, blank in rows)
    return stream.getvalue()


def _write_step(obj: Any, path: Path) -> None:
    # only the module of the graphical interface writes colours
    exporter = import_module("ImportGui" if App.GuiUp else "Import")
    document = App.newDocument("ElasticaExport", hidden=True, temp=True)
    try:
        whole = document.addObject("App::Part", "Whole")
        whole.Label = obj.Label
        blocks = [(block.label, block_shape(block)) for block in blocks_for(obj)]
        block_bodies = [(name, shape, shape.Placement, None) for name, shape in blocks]
        for name, shape, placement, sheet in (*_bodies(obj), *block_bodies):
            body = whole.newObject("Part::Feature", "Body")
            body.Label = name
            body.Shape = shape
            body.Placement = placement
            if App.GuiUp and body.ViewObject is not None:
                body.ViewObject.ShapeColor = FIXTURE_COLOR if sheet is None else sheet_color(sheet)
        document.recompute()
        exporter.export([whole], str(path))
    finally:
        App.closeDocument(document.Name)


def _bodies(obj: Any) -> list[tuple[str, Any, App.Placement, Any]]:
    if is_model(obj):
        # the shape in FreeCAD may be older than the drawings
        model = model_of(obj)
        solids = solids_of(model, obj.getGlobalPlacement() * container(obj).inverse())
        return [
            (model.name_of(i), solid, solid.Placement, strip.sheet)
            for i, (strip, solid) in enumerate(zip(model.strips, solids, strict=True))
        ]
    if is_flexure(obj):
        part, name = flexure_of(obj), obj.EngravedText or obj.Label
        world = drawn_curve(obj.Curve, obj).world
        return [
            (f"{name} {translate('Elastica', form)}", make_solid(solid), world, part.sheet)
            for form, solid in flexure_solids(part)
        ]
    if is_plate(obj):
        solids = [(plate, make_solid(plate.solid)) for plate in plates_of(obj)]
        return [(plate.name, solid, solid.Placement, plate.sheet) for plate, solid in solids]
    strip, name = strip_of(obj), obj.EngravedText or obj.Label
    world = drawn_curve(obj.Curve, obj).world
    lying = FlatSolid.layers(strip, frame_beside(strip, frame_of(world)))
    flat = [
        (
            f"{name} {word}",
            flat_shape(strip, i),
            App.Placement(App.Vector(*lying[i].frame.origin), App.Rotation()),
            layer.sheet,
        )
        for i, (word, layer) in enumerate(zip(("flat", "backing"), strip.layers, strict=False))
    ]
    return [*flat, (f"{name} bent", bent_shape(strip), world, strip.sheet)]
