"""Everything that a part with two states becomes: cutting files, bodies, picture and report."""

from collections.abc import Callable
from dataclasses import dataclass, field
from functools import cached_property
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from elastica_cad.fabrication.drawings.drawing import Drawing
from elastica_cad.fabrication.flexure import Flexure
from elastica_cad.fabrication.flexure_spec import FlexureSpec
from elastica_cad.files import save, step_trouble
from elastica_cad.formats.design_files.kit_spec import Cutting
from elastica_cad.formats.file_access.write_files import write_json, write_together


@dataclass(frozen=True, eq=False)
class PairKit:
    """One part, what was asked for it, and its files.

    Attributes
    ----------
    spec : FlexureSpec
    part : Flexure
    name : str
        What its files are called.
    cutting : Cutting
        How the cutting files are written.
    step, pictures : bool
        Bodies and the picture, where libraries for them are installed.
    """

    spec: FlexureSpec
    part: Flexure
    name: str
    cutting: Cutting = field(default_factory=Cutting)
    step: bool = True
    pictures: bool = True

    @cached_property
    def files(self) -> dict[str, Callable[[Path], object]]:
        """The function that writes each file, by its name, for all files that the installed packages can write."""
        part, options = self.part, self.cutting.options(self.part.sheet)

        def cut(drawing: Drawing) -> Callable[[Path], object]:
            return lambda path: save(drawing, path, **options)

        files: dict[str, Callable[[Path], object]] = {}
        for name, drawing in ((self.name, part.drawing()), (f"{self.name}-holder", part.holder())):
            files |= {f"{name}.{kind}": cut(drawing) for kind in ("dxf", "svg")}
        if self.step and not step_trouble():
            files |= {f"{self.name}.step": self._write_step, f"{self.name}.stl": self._write_stl}
        if self.pictures and find_spec("matplotlib"):
            files[f"{self.name}.png"] = self._draw
        files[f"{self.name}.json"] = lambda path: write_json(path, self.report)
        return files

    @cached_property
    def report(self) -> dict[str, Any]:
        """All that was asked and found, ready for JSON."""
        matched = self.spec.matched
        told = {} if matched is None else {"moved_mm": list(matched.moved)}
        return {"name": self.name, **told, **self.part.as_dict(), "files": list(self.files)}

    def _write_step(self, path: Path) -> None:
        from elastica_cad.kernel.occt import make_solid
        from elastica_cad.kernel.step_files import NamedShape, write_step

        write_step([NamedShape(self.name, make_solid(self.part.solid))], path, name=self.name)

    def _write_stl(self, path: Path) -> None:
        from elastica_cad.kernel.mesh_files import write_stl
        from elastica_cad.kernel.occt import make_solid

        write_stl(make_solid(self.part.solid), path)

    def _draw(self, path: Path) -> None:
        from elastica_cad.plot.canvas import save_figure
        from elastica_cad.plot.pair_pictures import pair_sheet

        save_figure(pair_sheet(self.part), path)


def write_pair(kit: PairKit, folder: Path, *, force: bool = False) -> tuple[Path, ...]:
    """Write all files of a part, or after any error none; where they are.

    Raises
    ------
    InputError
        Files that exist, without `force`.
    """
    with write_together(folder, kit.files, force=force) as workshop:
        for file, write in kit.files.items():
            write(workshop / file)
    return tuple(folder / file for file in kit.files)
