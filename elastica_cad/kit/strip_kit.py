"""Kit of a strip: cutting files, bodies, picture and report."""

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from functools import partial
from pathlib import Path

from elastica_cad._cached_property import cached_property
from elastica_cad.design.kit_spec import Cutting
from elastica_cad.design.reports import report_strip
from elastica_cad.design.strip_request import request_record
from elastica_cad.files import save, step_trouble
from elastica_cad.form_finding.nearest_record import NearestRod
from elastica_cad.formats.write_files import File, text_file, write_json
from elastica_cad.geometry.frame import Frame
from elastica_cad.kit.kit import Kit, can_draw, cutting_files, save_solid
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.stability import Stability, stability
from elastica_cad.strip.drawing import Drawing
from elastica_cad.strip.holding_template import holding_template
from elastica_cad.strip.makeable_strip import spliced
from elastica_cad.strip.strip import Placed, Strip
from elastica_cad.strip.strip_spec import StripSpec

UPRIGHT = Frame(y_axis=(0.0, 0.0, 1.0))
"""Default plane of a curve in space: upright, with y upwards."""


@dataclass(frozen=True)
class StripFiles:
    """Request for the files of a strip. Cutting files and report are always included.

    Attributes
    ----------
    cutting : Cutting
        Options of the cutting files.
    paper : str or None
        Paper size of a printed template, such as "A4", or None for no template.
    glb, stl : bool
        If True, write the bent strip as a GLB file for browsers and phones, or as an STL file for 3D printing.
    step, pictures : bool
        If True, write the flat and the bent strip as a STEP file, or a picture, if the required packages are
        installed.
    """

    cutting: Cutting = field(default_factory=Cutting)
    paper: str | None = None
    glb: bool = False
    step: bool = True
    pictures: bool = True
    stl: bool = False


@dataclass(frozen=True, eq=False)
class StripResult:
    """A strip with its request and the result of the search for its rod.

    Attributes
    ----------
    spec : StripSpec
        Request for the strip.
    found : Rod or NearestRod
        Result of `solve_rod` for the request.
    strip : Strip
        Strip that the request makes from this result.
    name : str
        Stem of the names of the files.
    """

    spec: StripSpec
    found: Rod | NearestRod
    strip: Strip
    name: str

    @property
    def near(self) -> NearestRod | None:
        """Rod with the nearest possible curve, or None if the curve was not allowed to change."""
        return self.found if isinstance(self.found, NearestRod) else None

    @cached_property
    def stability(self) -> Stability:
        """Stability of the rest shape."""
        return stability(self.strip.rod)

    def kit(self, request: StripFiles) -> Kit:
        """Return the report and the requested files, without files that require a missing package.

        The description of a file is its kind, such as "dxf", or "backing dxf" for the backing of a laminate.
        """
        strip, name, cutting, files = self.strip, self.name, request.cutting, list[File]()
        # the files for a service have cuts only, so drawings to look at are PDF files
        pictures, looked_at = request.pictures and can_draw(), cutting.service and can_draw()
        for number, (layer, pattern) in enumerate(zip(strip.layers, self.patterns, strict=True)):
            # for each separate part of the layer, a DXF file and an SVG file
            for place, file in enumerate(cutting_files(pattern, pattern.name, cutting, layer.sheet)):
                words = (layer.name, str(1 + place // 2) if place > 1 else "", ("dxf", "svg")[place % 2])
                files.append(replace(file, description=" ".join(filter(None, words))))
            if number == 0:
                files.append(File(f"{name}.json", lambda path: write_json(path, report), "json"))
        if not strip.is_closed:
            template = holding_template(strip)
            files += self._drawn("holding", template, request, pdf=bool(request.paper) or looked_at)
        printed = self.patterns[0]
        if strip.layout.size is not None:
            from elastica_cad.model.batten import bench_csv, bench_drawing

            side = bench_drawing(strip)
            files.append(text_file(f"{name}-bench.csv", bench_csv(strip), "bench csv"))
            files += self._drawn("side", side, request, pdf=pictures or looked_at)
            printed = replace(side, name=name) if strip.layout.stack else printed
        # by suffix: whether the file is written, and the function that writes it
        more: dict[str, tuple[object, Callable[[Path], object]]] = {
            "png": (pictures, self._picture()),
            "pdf": (request.paper, partial(_write_drawing, printed, "pdf", request)),
            "step": (request.step and not step_trouble(), partial(save, strip, frame=self.spec.frame)),
            "stl": (request.stl, self._write_stl),
            "glb": (request.glb, self._write_glb),
        }
        files += [
            File(f"{name}.{kind}", write, kind) for kind, (requested, write) in more.items() if requested
        ]
        report = report_strip(
            strip,
            name=name,
            files={file.description: file.name for file in files},
            near=self.near,
            stability=self.stability,
            smoothing=self.spec.rod_spec.smoothing,
        )
        report["request"] = request_record(self.spec, strip)
        report |= {"joints": strip.joints} if any(strip.joints) else {}
        return Kit(tuple(files), report)

    def _drawn(self, name: str, drawing: Drawing, request: StripFiles, *, pdf: bool) -> list[File]:
        cutting, drawing = request.cutting, replace(drawing, name=f"{self.name}-{name}")
        kinds = (*(() if cutting.service else ("dxf", "svg")), *(("pdf",) if pdf else ()))
        return [
            File(
                cutting.file_name(f"{self.name}-{name}", kind),
                partial(_write_drawing, drawing, kind, request),
                f"{name} {kind}",
            )
            for kind in kinds
        ]

    @cached_property
    def patterns(self) -> tuple[Drawing, ...]:
        """Drawing of each layer, with the file name as its name."""
        joined = spliced(self.strip, self.spec.shop)
        drawings = self.strip.drawings() if joined is None else joined.drawings
        return tuple(
            replace(drawing, name=layer.called(self.name))
            for drawing, layer in zip(drawings, self.strip.layers, strict=True)
        )

    def _picture(self) -> Callable[[Path], object]:
        """Return a function that draws the picture. Unpickling the function imports no kits and designs."""
        from elastica_cad.plot.canvas import draw_file
        from elastica_cad.plot.strip_pictures import strip_sheet

        target = None if self.near is None else self.near.target
        return partial(draw_file, partial(strip_sheet, self.strip, wish=target))

    def _write_stl(self, path: Path) -> None:
        from elastica_cad.strip.solids import BentSolid

        save_solid(BentSolid.layers(self.strip)[0], path)

    def _write_glb(self, path: Path) -> None:
        from elastica_cad.kernel.mesh_files import write_glb
        from elastica_cad.kernel.step_files import model_shapes
        from elastica_cad.model.model import Model

        frame = self.spec.frame or UPRIGHT
        placed = Placed(self.strip, frame.origin, frame.x_axis, frame.y_axis)
        write_glb(model_shapes(Model((placed,), self.name)), path, name=self.name)


def _write_drawing(drawing: Drawing, kind: str, request: StripFiles, path: Path) -> None:
    if kind == "pdf":
        from elastica_cad.plot.template_pages import save_template

        save_template(drawing, path, paper=request.paper or "A4")
    else:
        version = {"version": request.cutting.version} if kind == "dxf" else {}
        save(drawing, path, **version)
