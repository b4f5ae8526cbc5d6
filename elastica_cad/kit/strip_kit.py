"""Everything that one strip becomes: its cutting files, bodies, picture and report."""

import os
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from importlib.util import find_spec
from pathlib import Path
from typing import Any

from elastica_cad.errors import InputError
from elastica_cad.fabrication.bench import bench_csv, bench_drawing
from elastica_cad.fabrication.drawings.drawing import Drawing
from elastica_cad.fabrication.holders.holding_template import holding_template
from elastica_cad.fabrication.makeability.makeable_strip import spliced
from elastica_cad.fabrication.slots.marks import Cuts, end_numbers
from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.fabrication.strip_spec import StripSpec
from elastica_cad.files import save, step_trouble
from elastica_cad.formats.design_files.kit_spec import Cutting
from elastica_cad.formats.file_access.write_files import write_json, write_text, write_together
from elastica_cad.formats.reports.strip_report import report_strip
from elastica_cad.forming.nearest.nearest_record import NearestRod
from elastica_cad.geometry.frame import Frame
from elastica_cad.mechanics.rod.rod_record import Rod
from elastica_cad.mechanics.stability.stability_verdict import Stability, stability

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

    @cached_property
    def files(self) -> dict[str, str]:
        """The name of each file by its kind, for all kinds that the installed packages can write."""
        # R12 has no header for its unit, so the name says it
        dxf = f"{self.name}-mm.dxf" if self.asked.cutting.version == "R12" else f"{self.name}.dxf"
        names = {"dxf": dxf} | {kind: f"{self.name}.{kind}" for kind in ("svg", "json")}
        cuts = {kind: names[kind] for kind in ("dxf", "svg")}
        for layer in self.strip.layers[1:]:
            glued = layer.called(self.name)
            names |= {
                f"{layer.name} {kind}": file.replace(self.name, glued, 1) for kind, file in cuts.items()
            }
        if not self.strip.is_closed:
            held = {"holding dxf": f"{self.name}-holding.dxf", "holding svg": f"{self.name}-holding.svg"}
            names |= held | ({"holding pdf": f"{self.name}-holding.pdf"} if self.asked.paper else {})
        if self.strip.layout.size is not None:
            names["bench csv"] = f"{self.name}-bench.csv"
            kinds = ("dxf", "svg", *(["pdf"] if self.asked.pictures and find_spec("matplotlib") else []))
            names |= {f"side {kind}": f"{self.name}-side.{kind}" for kind in kinds}
        more = {
            "png": self.asked.pictures and find_spec("matplotlib"),
            "pdf": self.asked.paper,
            "step": self.asked.step and not step_trouble(),
            "glb": self.asked.glb,
        }
        return names | {kind: f"{self.name}.{kind}" for kind, asked in more.items() if asked}

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
        return report | ({"joints": self.joints} if any(self.joints) else {})


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
        for kind, file in kit.files.items():
            writer_of(kit, kind)(kit, workshop / file)
    return written


def _write_dxf(kit: StripKit, path: Path, layer: int = 0) -> None:
    drawing, options = _pattern(kit, layer)
    save(drawing, path, version=kit.asked.cutting.version, **options)


def _write_svg(kit: StripKit, path: Path, layer: int = 0) -> None:
    drawing, options = _pattern(kit, layer)
    save(drawing, path, **options)


def _pattern(kit: StripKit, layer: int) -> tuple[Drawing, dict[str, Any]]:
    """What is cut of one layer, and how its file is to be written."""
    sheet = kit.strip.layers[layer].sheet
    return kit.patterns[layer], kit.asked.cutting.options(sheet)


def writer_of(kit: StripKit, kind: str) -> Callable[[StripKit, Path], None]:
    """What writes a kind of file; "backing dxf" and the like are of a layer that is glued on."""
    if kind in WRITERS:
        return WRITERS[kind]
    name, _, kind = kind.rpartition(" ")
    if name == "holding":
        return partial(_write_drawing, lambda kit: holding_template(kit.strip), kind=kind)
    if name == "side":
        return partial(_write_drawing, lambda kit: bench_drawing(kit.strip), kind=kind)
    number = [layer.name for layer in kit.strip.layers].index(name)
    return partial({"dxf": _write_dxf, "svg": _write_svg}[kind], layer=number)


def _write_drawing(made: Callable[[StripKit], Drawing], kit: StripKit, path: Path, kind: str) -> None:
    """One of the drawings that are written beside the cut pattern."""
    drawing = replace(made(kit), name=path.stem)
    if kind == "pdf":
        from elastica_cad.plot.template_pages import save_template

        save_template(drawing, path, paper=kit.asked.paper or "A4")
    else:
        version = {"version": kit.asked.cutting.version} if kind == "dxf" else {}
        save(drawing, path, **version)


def _draw_picture(kit: StripKit, path: Path) -> None:
    from elastica_cad.plot.canvas import save_figure
    from elastica_cad.plot.strip_pictures import strip_sheet

    save_figure(strip_sheet(kit.strip, wish=None if kit.near is None else kit.near.target), path)


def _draw_template(kit: StripKit, path: Path) -> None:
    from elastica_cad.plot.template_pages import save_template

    drawing = bench_drawing(kit.strip) if kit.strip.layout.stack else _pattern(kit, 0)[0]
    save_template(drawing, path, paper=str(kit.asked.paper))


def _write_step(kit: StripKit, path: Path) -> None:
    from elastica_cad.kernel.step_files import write_strip_step

    write_strip_step(kit.strip, path, frame=kit.spec.frame)


def _write_glb(kit: StripKit, path: Path) -> None:
    from elastica_cad.fabrication.model.strip_model import Model
    from elastica_cad.fabrication.placed_strip import Placed
    from elastica_cad.kernel.mesh_files import write_glb
    from elastica_cad.kernel.step_files import model_shapes

    frame = kit.spec.frame or UPRIGHT
    placed = Placed(kit.strip, frame.origin, frame.x_axis, frame.y_axis)
    write_glb(model_shapes(Model((placed,), kit.name)), path, name=kit.name)


WRITERS: Mapping[str, Callable[[StripKit, Path], None]] = {
    "dxf": _write_dxf,
    "svg": _write_svg,
    "png": _draw_picture,
    "pdf": _draw_template,
    "step": _write_step,
    "glb": _write_glb,
    "bench csv": lambda kit, path: write_text(path, bench_csv(kit.strip)),
    "json": lambda kit, path: write_json(path, kit.report),
}
"""How each kind of file is written."""
