"""Cutting files of a drawing, as DXF and SVG, by their names."""

from collections.abc import Callable
from functools import partial
from pathlib import Path
from typing import TypeAlias

from elastica_cad.design.kit_spec import Cutting
from elastica_cad.files import save
from elastica_cad.mechanics.sheets import Sheet
from elastica_cad.strip.drawing import Drawing

Writer: TypeAlias = Callable[[Path], object]


def cutting_files(drawing: Drawing, stem: str, cutting: Cutting, sheet: Sheet) -> dict[str, Writer]:
    """Return the function that writes each file, by its name; parts after the first are numbered.

    Raises
    ------
    InputError
        A kerf that is not known, or a cut that a service does not take.
    """
    options, files = cutting.options(sheet), dict[str, Writer]()
    for number, part in enumerate(cutting.drawings(drawing), start=1):
        called = stem if number == 1 else f"{stem}-{number}"
        for suffix in ("dxf", "svg"):
            name = cutting.file_name(called, suffix)
            files[name] = partial(save, part, **options)
    return files
