"""Everything that a part with two states becomes: cutting files, bodies, picture and report."""

from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cached_property
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np

from elastica_cad.defaults import LASER_KERF
from elastica_cad.design.kit_spec import Cutting
from elastica_cad.files import step_trouble
from elastica_cad.formats.write_files import write_json, write_together
from elastica_cad.forming.limits import FAR_SHARE
from elastica_cad.kit.cutting_files import Writer, cutting_files
from elastica_cad.pairs.flexure import Flexure
from elastica_cad.pairs.flexure_spec import FlexureSpec
from elastica_cad.refusals import Length, Refusal, note


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
    def files(self) -> dict[str, Writer]:
        """The function that writes each file, by its name, for all files that the installed packages can write."""
        part, files = self.part, dict[str, Writer]()
        for name, drawing in ((self.name, part.drawing()), (f"{self.name}-holder", part.holder())):
            files |= cutting_files(drawing, name, self.cutting, part.sheet)
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
        reports = [str(one) for one in self.warnings]
        return {
            "name": self.name,
            **told,
            **self.part.as_dict(),
            "reports": reports,
            "files": list(self.files),
        }

    @cached_property
    def warnings(self) -> tuple[Refusal, ...]:
        """What a user should know about the part, its curves and its cutting files."""
        return (*self._moved_far(), *self._cut_away(), *self.part.warnings)

    def _moved_far(self) -> Iterator[Refusal]:
        moved = (0.0, 0.0) if self.spec.matched is None else self.spec.matched.moved
        sizes = [np.hypot(*np.ptp(drawn.bounds, axis=0)) for drawn in self.spec.faired]
        share, far = max((far / size, far) for far, size in zip(moved, sizes, strict=True))
        if share > FAR_SHARE:
            yield note(
                "a curve was moved by up to {far}, {percent:.2g} % of its size, to make both equally long; the "
                "picture shows them dashed as they were drawn: draw both nearer to one length, or have them made "
                "equal in another way (--match)",
                severity="warning", far=Length(far), percent=100 * share,
            )  # fmt: skip

    def _cut_away(self) -> Iterator[Refusal]:
        sheet, thin = self.part.sheet, self.part.scale
        if self.part.printed or self.cutting.options(sheet)["kerf"]:
            return
        kerf = sheet.kerf or LASER_KERF
        left = max(thin - kerf, 0.0)
        yield note(
            "the files hold the part's own outline: a laser's cut of {kerf} leaves {left} of {thin} where it is "
            "thinnest, and {percent:.0f} % of the force: give the width of the cut (--kerf), unless the program of "
            "the laser makes up for it",
            severity="warning", kerf=Length(kerf), left=Length(left), thin=Length(thin),
            percent=100 * (left / thin) ** 3,
        )  # fmt: skip

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

        save_figure(pair_sheet(self.part, self.spec.faired), path)


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
