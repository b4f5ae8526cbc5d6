"""Everything that one strip becomes: its cutting files, bodies, picture and report."""

import os
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from elastica_cad.design.kit_spec import Cutting
from elastica_cad.design.reports import report_strip
from elastica_cad.design.strip_request import request_record
from elastica_cad.errors import InputError
from elastica_cad.files import save, step_trouble
from elastica_cad.formats.write_files import write_json, write_text, write_together
from elastica_cad.forming.nearest_record import NearestRod
from elastica_cad.geometry.frame import Frame
from elastica_cad.kit.cutting_files import cutting_files
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.stability import Stability, stability
from elastica_cad.model.batten import bench_csv, bench_drawing
from elastica_cad.strip.drawing import Drawing
from elastica_cad.strip.holding_template import holding_template
from elastica_cad.strip.makeable_strip import spliced
from elastica_cad.strip.slots import Cuts, end_numbers
from elastica_cad.strip.strip import Strip
from elastica_cad.strip.strip_spec import StripSpec

UPRIGHT = Frame(y_axis=(0.0, 0.0, 1.0))
"""The plane of a curve that says none, as screens show it."""


@dataclass(frozen=True)
class StripFiles:
    """Which files of one strip are asked for, beside the cut pattern and the report.

    Attributes
    ----------
    cutting : Cutting
        How the cut pattern is written.
    paper : str or None
        Size of the pages of a template, "A4"; None for no template.
    glb : bool
        A model for browsers and phones too.
    step, pictures : bool
        The flat and the bent strip, and its picture, where libraries for them are installed.
    """

    cutting: Cutting = field(default_factory=Cutting)
    paper: str | None = None
    glb: bool = False
    step: bool = True
    pictures: bool = True


@dataclass(frozen=True, eq=False)
class StripKit:
    """One strip with the answer it was made from, and the files that describe it.

    Attributes
    ----------
    spec : StripSpec
        The request.
    found : Rod or NearestRod
        The answer of its `rod_spec`.
    strip : Strip
        What `spec` makes of that.
    name : str
        What its files are called.
    joints : (str, str)
        Names of the corners at its ends where another strip goes on; empty elsewhere.
    asked : StripFiles
    """

    spec: StripSpec
    found: Rod | NearestRod
    strip: Strip
    name: str
    joints: tuple[str, str] = ("", "")
    asked: StripFiles = field(default_factory=StripFiles)

    @property
    def near(self) -> NearestRod | None:
        """The nearest rod, or None where the curve was not allowed to change."""
        return self.found if isinstance(self.found, NearestRod) else None

    @cached_property
    def stability(self) -> Stability:
        """Whether the rest shape is stable, and by how much."""
        return stability(self.strip.rod)

    @property
    def files(self) -> dict[str, str]:
        """The name of each file by its kind, for all kinds that the installed packages can write."""
        return {kind: name for kind, (name, _) in self.writers.items()}

    @cached_property
    def writers(self) -> dict[str, tuple[str, Callable[[Path], object]]]:
        """The name of each file and what writes it, by its kind; "backing dxf" is of a layer that is glued on."""
        asked, strip, files = self.asked, self.strip, dict[str, tuple[str, Callable[[Path], object]]]()
        drawable = find_spec("matplotlib") is not None
        pictures, looked_at = asked.pictures and drawable, asked.cutting.service and drawable
        for number, (layer, pattern) in enumerate(zip(strip.layers, self.patterns, strict=True)):
            cut = cutting_files(pattern, pattern.name, asked.cutting, layer.sheet)
            for place, (name, write) in enumerate(cut.items()):  # DXF and SVG of each part
                words = (layer.name, str(1 + place // 2) if place > 1 else "", ("dxf", "svg")[place % 2])
                files[" ".join(filter(None, words))] = name, write
            if number == 0:
                files["json"] = f"{self.name}.json", lambda path: write_json(path, self.report)
        if not strip.is_closed:
            files |= self._drawn("holding", holding_template, pdf=bool(asked.paper) or looked_at)
        if strip.layout.size is not None:
            files["bench csv"] = f"{self.name}-bench.csv", lambda path: write_text(path, bench_csv(strip))
            files |= self._drawn("side", bench_drawing, pdf=pictures or looked_at)
        more = {
            "png": (pictures, self._draw_picture),
            "pdf": (asked.paper, self._draw_template),
            "step": (asked.step and not step_trouble(), self._write_step),
            "glb": (asked.glb, self._write_glb),
        }
        return files | {
            kind: (f"{self.name}.{kind}", write) for kind, (wanted, write) in more.items() if wanted
        }

    def _drawn(
        self, name: str, made: Callable[[Strip], Drawing], *, pdf: bool
    ) -> dict[str, tuple[str, Callable[[Path], object]]]:
        """One of the drawings that are written beside the cut pattern, in each kind of file."""
        cutting = self.asked.cutting
        kinds = (*(() if cutting.service else ("dxf", "svg")), *(("pdf",) if pdf else ()))
        return {
            f"{name} {kind}": (
                cutting.file_name(f"{self.name}-{name}", kind),
                partial(self._write_drawing, made, kind),
            )
            for kind in kinds
        }

    @cached_property
    def drawings(self) -> tuple[Drawing, ...]:
        """The cut pattern of each layer; ends where another strip goes on are engraved with the joint's name."""
        strip, joined = self.strip, spliced(self.strip, self.spec.shop)
        if joined is not None:
            return replace(joined, ends=self.joints).drawings
        drawings = strip.drawings()
        if any(self.joints):
            base, cuts = drawings[0], Cuts(strip.holes, outline=strip.outline)
            marks = end_numbers(strip.width, cuts, base.texts, self.joints)
            drawings = (replace(base, texts=(*base.texts, *marks)), *drawings[1:])
        return drawings

    @cached_property
    def patterns(self) -> tuple[Drawing, ...]:
        """The drawing of each layer to be cut, named as its file."""
        named = zip(self.drawings, self.strip.layers, strict=True)
        return tuple(replace(drawing, name=layer.called(self.name)) for drawing, layer in named)

    @cached_property
    def report(self) -> dict[str, Any]:
        """All that was asked and found, ready for JSON."""
        report = report_strip(
            self.strip,
            name=self.name,
            files=self.files,
            near=self.near,
            stability=self.stability,
            smoothing=self.spec.rod_spec.smoothing,
        )
        report["request"] = request_record(self.spec, self.strip)
        return report | ({"joints": self.joints} if any(self.joints) else {})

    def _write_drawing(self, made: Callable[[Strip], Drawing], kind: str, path: Path) -> None:
        drawing = replace(made(self.strip), name=path.stem)
        if kind == "pdf":
            from elastica_cad.plot.template_pages import save_template

            save_template(drawing, path, paper=self.asked.paper or "A4")
        else:
            version = {"version": self.asked.cutting.version} if kind == "dxf" else {}
            save(drawing, path, **version)

    def _draw_picture(self, path: Path) -> None:
        from elastica_cad.plot.canvas import save_figure
        from elastica_cad.plot.strip_pictures import strip_sheet

        save_figure(strip_sheet(self.strip, wish=None if self.near is None else self.near.target), path)

    def _draw_template(self, path: Path) -> None:
        from elastica_cad.plot.template_pages import save_template

        drawing = bench_drawing(self.strip) if self.strip.layout.stack else self.patterns[0]
        save_template(drawing, path, paper=str(self.asked.paper))

    def _write_step(self, path: Path) -> None:
        from elastica_cad.kernel.step_files import write_strip_step

        write_strip_step(self.strip, path, frame=self.spec.frame)

    def _write_glb(self, path: Path) -> None:
        from elastica_cad.kernel.mesh_files import write_glb
        from elastica_cad.kernel.step_files import model_shapes
        from elastica_cad.model.model import Model
        from elastica_cad.strip.strip import Placed

        frame = self.spec.frame or UPRIGHT
        placed = Placed(self.strip, frame.origin, frame.x_axis, frame.y_axis)
        write_glb(model_shapes(Model((placed,), self.name)), path, name=self.name)


def write_strip(
    kit: StripKit, folder: Path, *, force: bool = False, kept: Path | None = None
) -> tuple[Path, ...]:
    """Write all files of a strip, or after any error none; where they are.

    Raises
    ------
    InputError
        Files that exist, without `force`; or one of them is `kept`, which holds the drawn curve.
    """
    written = tuple(folder / file for file in kit.files.values())
    if kept is not None and any(os.path.exists(path) and path.samefile(kept) for path in written):
        raise InputError(
            "{kept} holds the drawn curve and is kept: name another folder, e.g. -o out", kept=kept
        )
    with write_together(folder, kit.files.values(), force=force) as workshop:
        for file, write in kit.writers.values():
            write(workshop / file)
    return written
