"""A kit: the files of a strip, a model or a flexure, and their report."""

from collections.abc import Callable, Sequence
from contextlib import nullcontext
from dataclasses import dataclass
from functools import partial
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from elastica_cad.design.kit_spec import Cutting
from elastica_cad.errors import Listed, how_to_install
from elastica_cad.files import save, step_trouble
from elastica_cad.formats.write_files import File, write_files
from elastica_cad.geometry.frame import Frame
from elastica_cad.mechanics.sheets import Sheet
from elastica_cad.plot.drawing_process import DrawingProcess, in_writing_order
from elastica_cad.strip.drawing import Drawing


@dataclass(frozen=True, eq=False)
class Kit:
    """Files to be written, and the content of the report, which is one of the files."""

    files: tuple[File, ...]
    report: dict[str, Any]

    def write(
        self,
        folder: str | Path,
        *,
        force: bool = False,
        done: Callable[[str, int], None] | None = None,
        process: DrawingProcess | None = None,
    ) -> tuple[Path, ...]:
        """Write all files, or none if an error occurs: see `write_files`.

        `process` is the process that draws the pictures.
        """
        drawn = nullcontext(in_writing_order(self.files)) if process is None else process.drawing(self.files)
        with drawn as files:
            write_files(files, folder, force=force, done=done)
        return tuple(Path(folder, file.name) for file in self.files)


def can_draw() -> bool:
    """Return True if matplotlib is installed, which pictures and PDF files need."""
    return find_spec("matplotlib") is not None


def left_out(
    *, step: bool = True, pictures: bool = True, paper: bool = False, blocks: Sequence[str] = ()
) -> tuple[str, ...]:
    """Return a sentence for each missing package, with the files that need it and how to install it.

    `blocks` are the names of printed blocks.
    """
    outputs = " and ".join(kind for requested, kind in ((paper, "PDF"), (pictures, "pictures")) if requested)
    missing = [(outputs, "" if can_draw() else how_to_install("matplotlib"))]
    solids = f"STEP and STL of {Listed(blocks)}" if blocks else "STEP"
    missing += [(solids, step_trouble())] if step else []
    return tuple(f"not written: {kind}; to get it: {cure}" for kind, cure in missing if kind and cure)


def cutting_files(
    drawing: Drawing, stem: str, cutting: Cutting, sheet: Sheet, description: str = ""
) -> tuple[File, ...]:
    """Return the DXF and SVG files of each part of a drawing.

    File names are numbered from the second part on.
    """
    options = cutting.options(sheet)
    return tuple(
        File(
            cutting.file_name(stem if number == 1 else f"{stem}-{number}", suffix),
            partial(save, part, **options),
            description,
        )
        for number, part in enumerate(cutting.drawings(drawing), start=1)
        for suffix in ("dxf", "svg")
    )


def save_solid(solid: Any, path: Path, *, bed: Frame | None = None) -> None:
    """Write a solid to an STL file. `bed` is the plane that becomes z = 0."""
    from elastica_cad.kernel.mesh_files import write_stl
    from elastica_cad.kernel.occt import make_solid

    write_stl(make_solid(solid), path, bed=bed)
