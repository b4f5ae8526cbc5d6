"""Cutting files of parametric strips: DXF, SVG, STEP and a cut list, together or not at all."""

import csv
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import FreeCAD as App
from freecad.elastica_wb.design import bent_shape, flat_shape
from freecad.elastica_wb.drawn import drawn_curve
from freecad.elastica_wb.features.strip import strip_of

from elastica_cad.errors import InputError, MissingDependencyError
from elastica_cad.fabrication import Strip, sheet_color
from elastica_cad.formats import files_together, write_drawing

__all__ = ["KINDS", "CutPart", "cut_parts", "write_cutting_files", "write_step"]

KINDS = ("dxf", "svg", "step", "csv")
COLUMNS = (
    "part", "quantity", "sheet", "thickness_mm", "length_mm", "least_width_mm", "largest_width_mm",
    "stiffness_ratio", "strain_percent", "mass_g", "file",
)  # fmt: skip


@dataclass(frozen=True, eq=False)
class CutPart:
    """A strip of the document, and what its files are called."""

    obj: Any
    strip: Strip
    quantity: int
    name: str


def cut_parts(strips: Iterable[Any]) -> list[CutPart]:
    """Names with material, thickness and quantity in them; every one once."""
    parts: list[CutPart] = []
    for obj in strips:
        strip = strip_of(obj)
        sheet = strip.sheet
        thickness = f"{sheet.thickness:g}mm"
        stem = f"{obj.EngravedText or obj.Label}-{sheet.name}-{thickness}-x{obj.Quantity}"
        stem = re.sub(r"[^\w.+-]+", "_", stem).strip("_")
        count = sum(part.name == stem or part.name.startswith(f"{stem}-no") for part in parts)
        parts.append(CutPart(obj, strip, obj.Quantity, f"{stem}-no{count + 1}" if count else stem))
    return parts


def write_cutting_files(
    strips: Sequence[Any],
    folder: str | Path,
    *,
    kinds: Iterable[str] = KINDS,
    kerf: float = 0.0,
    curves: str = "spline",
    tolerance: float = 0.02,
    version: str = "R2010",
    force: bool = False,
) -> list[Path]:
    """Write the files of strips into a folder.

    Raises
    ------
    InputError
        Nothing to write, files that are there already (without `force`), a strip in error.
    MissingDependencyError
        DXF without ezdxf.
    """
    parts, kinds = cut_parts(strips), list(kinds)
    if not parts or not kinds:
        raise InputError("there is nothing to write: choose strips and kinds of files")
    if "dxf" in kinds and find_spec("ezdxf") is None:
        raise MissingDependencyError(
            "DXF files need ezdxf: Elastica > Install missing libraries, or choose SVG"
        )
    names = [
        f"{stem}.{kind}"
        for part in parts
        for kind in ("dxf", "svg")
        if kind in kinds
        for stem in _stems(part)
    ]
    names += [f"{part.name}.step" for part in parts if "step" in kinds]
    names += ["cut-list.csv"] if "csv" in kinds else []
    options = {"kerf": kerf, "curves": curves, "tolerance": tolerance}
    with files_together(folder, names, force=force) as workshop:
        for part in parts:
            for stem, drawing in zip(_stems(part), part.strip.drawings(), strict=True):
                named = replace(drawing, name=stem)
                if "dxf" in kinds:
                    write_drawing(named, workshop / f"{stem}.dxf", version=version, **options)
                if "svg" in kinds:
                    write_drawing(named, workshop / f"{stem}.svg", **options)
            if "step" in kinds:
                write_step(part, workshop / f"{part.name}.step")
        if "csv" in kinds:
            _write_list(parts, workshop / "cut-list.csv")
    return [Path(folder) / name for name in names]


def _stems(part: CutPart) -> tuple[str, ...]:
    """File names of the layers without their endings."""
    return (part.name, f"{part.name}-backing")[: len(part.strip.layers)]


def write_step(part: CutPart, path: Path) -> None:
    """The flat part and the bent one, standing on its curve, named and coloured."""
    import Import

    document = App.newDocument("ElasticaExport", hidden=True, temp=True)
    try:
        objects = []
        shapes = [("flat", flat_shape(part.strip)), ("bent", bent_shape(part.strip))]
        if len(part.strip.layers) > 1:
            shapes.insert(1, ("backing", flat_shape(part.strip, 1)))
        for form, shape in shapes:
            body = document.addObject("Part::Feature", form)
            body.Label = f"{part.obj.EngravedText or part.obj.Label} {form}"
            body.Shape = shape.copy()
            if form == "bent":
                body.Placement = drawn_curve(part.obj.Curve, part.obj).world
            if App.GuiUp and body.ViewObject is not None:
                body.ViewObject.ShapeColor = sheet_color(part.strip.sheet)
            objects.append(body)
        document.recompute()
        Import.export(objects, str(path))
    finally:
        App.closeDocument(document.Name)


def _write_list(parts: Sequence[CutPart], path: Path) -> None:
    with path.open("w", newline="", encoding="utf-8") as file:
        writer = csv.writer(file)
        writer.writerow(COLUMNS)
        for part in parts:
            strip = part.strip
            low, high = strip.width.extremes
            numbers = (
                strip.sheet.thickness, strip.rod.length, low, high, strip.rod.ratio, 100 * strip.max_strain,
                strip.mass,
            )  # fmt: skip
            rounded = [f"{value:.6g}" for value in numbers]
            label = part.obj.EngravedText or part.obj.Label
            writer.writerow([label, part.quantity, strip.sheet.name, *rounded, part.name])
