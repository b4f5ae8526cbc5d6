# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Parametric curves: nearest curve, curve of a strip with moved ends, and sections of bodies."""

import math
from typing import Any, ClassVar

import FreeCAD as App
import Part
from freecad.elastica_wb.curves.part_shapes import spline_geometry
from freecad.elastica_wb.curves.plane_sections import (
    AXES,
    CLOSED,
    FAMILIES,
    Family,
    box_of,
    curves_of,
    cut,
    path_points,
    section_sketches,
)
from freecad.elastica_wb.curves.sketch_curves import container, curve_into, drawn_curve, renumbered
from freecad.elastica_wb.features.proxy import REPORTS, Feature, added
from freecad.elastica_wb.features.strip import strip_of
from freecad.elastica_wb.features.strip_properties import NEAREST, nearest_spec_of
from freecad.elastica_wb.host.objects import is_sketch, is_strip
from freecad.elastica_wb.host.progress import in_background, progress
from freecad.elastica_wb.host.property_table import Property, put, result
from freecad.elastica_wb.host.resources import QT_TRANSLATE_NOOP, translate
from freecad.elastica_wb.host.words import report
from freecad.elastica_wb.solving.strip_cache import SEARCHING, find_nearest_now, nearest_to_drag

from elastica_cad.errors import FieldName, InputError, Listed, note, sentences
from elastica_cad.form_finding.section_lines import AT_TWO_PLACES, SectionCurve
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.mechanics.bending import Leg, inaccuracies, path_legs
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.stability import stability

MOVES = ("StartX", "StartY", "EndX", "EndY", "StartAngle", "EndAngle")
ORANGE = (0.9, 0.4, 0.0)


class NearestFeature(Feature):
    """The curve nearest to a drawn curve among the curves that a strip can take within limits."""

    properties = (*NEAREST, REPORTS)
    sheets: ClassVar = {"Sheet": "SheetData"}

    def make(self, obj: Any) -> None:
        """Set the shape to the nearest curve."""
        curve = drawn_curve(obj.Curve, obj)
        near = in_background(SEARCHING, find_nearest_now, nearest_spec_of(obj, curve))
        obj.Shape = spline_geometry(near.curve).toShape()
        obj.Placement = curve.placement
        limits = Listed(
            note("{limit} ({given:.3g})", limit=note(b.name), given=b.limit) if b.limit else note(b.name)
            for b in near.binding[:3]
        )
        reports = [
            *renumbered(obj),
            note(near.status.value),
            *([note("These limits prevent a nearer curve: {limits}.", limits=limits)] if limits else []),
        ]
        put(obj, Deviation=near.deviation, Ratio=near.rod.ratio, Reports=reports)


class BentFeature(Feature):
    """The curve of a strip with displaced and rotated ends."""

    properties = (
        Property("LinkGlobal", "Strip", "Bent", "Strip to bend"),
        Property("Distance", "StartX", "Bent", "Displacement of the start along x"),
        Property("Distance", "StartY", "Bent", "Displacement of the start along y"),
        Property("Distance", "EndX", "Bent", "Displacement of the end along x"),
        Property("Distance", "EndY", "Bent", "Displacement of the end along y"),
        Property("Angle", "StartAngle", "Bent", "Rotation of the start"),
        Property("Angle", "EndAngle", "Bent", "Rotation of the end"),
        result("Length", "LargestMove", "Largest displacement of the curve"),
        result("Float", "Margin", "Stability margin; positive means stable"),
        REPORTS,
    )

    def make(self, obj: Any) -> None:
        """Set the shape to the curve of the bent strip."""
        if not is_strip(obj.Strip):
            raise InputError("The strip is missing. Choose a strip in {box}.", box=FieldName("Strip"))
        rest = strip_of(obj.Strip).rod_to_bend
        leg = way(rest, {name: getattr(obj, name).Value for name in MOVES})
        rod = leg.rod(1.0)
        obj.Shape = spline_geometry(rod.curve).toShape()
        obj.Placement = drawn_curve(obj.Strip.Curve, obj).placement
        reports = [*leg.warnings, *inaccuracies(rod)]
        put(obj, LargestMove=largest_move(rest, rod), Margin=stability(rod).margin, Reports=reports)


class SectionFeature(Feature):
    """Smooth curves along which planes cut bodies, surfaces and meshes. Strips can follow these curves."""

    properties = (
        Property("LinkListGlobal", "Sources", "Section", "Bodies, surfaces and meshes that are cut"),
        Property("Enumeration", "Family", "Section", "Arrangement of the planes", list(FAMILIES)),
        Property("Integer", "Count", "Section", "Number of planes", 5),
        Property(
            "Enumeration",
            "Axis",
            "Section",
            "Axis perpendicular to the planes, or common to the half planes",
            list(AXES),
        ),
        Property("Distance", "ThroughX", "Section", "Point on the axis of half planes: x"),
        Property("Distance", "ThroughY", "Section", "Point on the axis of half planes: y"),
        Property("Distance", "ThroughZ", "Section", "Point on the axis of half planes: z"),
        Property("Angle", "Sweep", "Section", "Angle over which half planes are spread", 360.0),
        Property("LinkSubGlobal", "Path", "Section", "Sketch, wire or edges perpendicular to the planes"),
        Property("Enumeration", "Closed", "Section", "Treatment of closed lines", list(CLOSED)),
        Property("Length", "Tolerance", "Section", "Largest distance of a curve from the section", 0.05),
        Property("Length", "Waves", "Section", "Shortest wavelength that is kept; 0 keeps all waves"),
        result("Integer", "Curves", "Number of curves"),
        REPORTS,
    )

    def make(self, obj: Any) -> None:
        """Set the shape to the smoothed sections of the sources."""
        sections, remarks = _cut_sources(obj)
        curves = [curve for _, body_curves in sections for curve in body_curves]
        if not curves and not remarks:
            raise InputError("The planes do not meet the object. Move the planes, or add planes.")
        if not curves and all(AT_TWO_PLACES in remark.all_changes for remark in remarks):
            raise InputError(
                "Every section is a closed line, but a strip has two ends. Choose how to divide the lines in "
                "{box}.",
                box=FieldName("Closed"),
            )
        if not curves:
            raise InputError(sentences(remarks))
        shapes = [spline_geometry(curve.curve, curve.frame).toShape() for curve in curves]
        whole = Part.Compound(shapes)
        whole.Placement = container(obj).inverse()
        obj.Shape = whole
        put(obj, Curves=len(curves), Reports=remarks)


def _add_curve(document: Any, name: str, proxy: type[Feature], sources: list[Any], **properties: Any) -> Any:
    obj = added(document, name, proxy, sources, **properties)
    if App.GuiUp:
        obj.ViewObject.LineColor, obj.ViewObject.LineWidth = ORANGE, 3
    return obj


def nearest(document: Any, source: Any, edges: tuple[str, ...] = ()) -> Any:
    """Make the nearest curve of a sketch or of edges, without recomputing the document."""
    label = f"{source.Label} {translate('Elastica', 'nearest')}"
    return _add_curve(document, "Nearest", NearestFeature, [source], Label=label, Curve=(source, list(edges)))


def bent(document: Any, strip: Any, **moves: float) -> Any:
    """Make the curve that a strip takes with its ends moved.

    `moves` are displacements (mm) and angles (degrees), named as in `MOVES`.
    """
    label = f"{strip.Label} {translate('Elastica', 'bent further')}"
    return _add_curve(document, "Bent", BentFeature, [strip], Label=label, Strip=strip, **moves)


def section(document: Any, sources: list[Any], path: tuple[Any, tuple[str, ...]] | None = None) -> Any:
    """Make sections of bodies perpendicular to an axis or along a path, without recomputing the document."""
    label = f"{sources[0].Label} {translate('Elastica', 'curves')}"
    obj = _add_curve(document, "Section", SectionFeature, sources, Label=label, Sources=sources)
    for axis, value in zip(AXES, box_of(sources[0]).Center, strict=True):
        # FreeCAD's boxes of curved bodies are a few hundredths of a mm too large
        setattr(obj, f"Through{axis}", round(value, 1))
    if path is not None:
        obj.Path, obj.Family = (path[0], list(path[1])), FAMILIES[2]
    return obj


def way(rest: Rod, change: dict[str, float]) -> Leg:
    """Return the shapes of the rod `rest` while its ends are displaced (mm) and rotated (degrees).

    The keys of `change` are the names in `MOVES`.
    """
    angles = [
        float(rest.angle[i]) + math.radians(change[name]) if support.angle else None
        for i, name, support in zip((0, -1), MOVES[4:], rest.supports.ends, strict=True)
    ]
    (leg,) = path_legs(rest, [{
        "start": rest.position[0] + (change["StartX"], change["StartY"]),
        "end": rest.position[-1] + (change["EndX"], change["EndY"]),
        "angles": angles,
    }])  # fmt: skip
    return leg


def largest_move(rest: Rod, rod: Rod) -> float:
    """Return the largest distance between corresponding points of two rods, mm."""
    return max(math.hypot(x, y) for x, y in rod.position - rest.position)


def draw_into(obj: Any) -> None:
    """Replace the curve in a sketch by its nearest curve, and delete the feature."""
    (sketch, edges), curve = obj.Curve, _curve_to_drag(obj)
    if not is_sketch(sketch):
        raise InputError(
            "No curve can be drawn in {object}, which is not a sketch. Choose a sketch.", object=sketch.Label
        )
    if any(edges):
        raise InputError(
            '{object} has other curves, which would be replaced too. Press the button "Make a sketch to edit".',
            object=sketch.Label,
        )
    obj.Document.removeObject(obj.Name)
    curve_into(sketch, curve)


def nearest_sketch(obj: Any) -> None:
    """Replace a nearest curve by an editable sketch that no longer depends on the drawn curve."""
    curve, document = _curve_to_drag(obj), obj.Document
    sketch = document.addObject("Sketcher::SketchObject", "Nearest")
    group = obj.getParentGeoFeatureGroup()
    if group is not None:
        group.addObject(sketch)
    sketch.Label, sketch.Placement = f"{obj.Label} {translate('Elastica', 'sketch')}", obj.Placement
    document.removeObject(obj.Name)
    curve_into(sketch, curve)


def section_sketches_of(obj: Any) -> None:
    """Replace sections by editable sketches that no longer depend on the bodies."""
    sections, _ = _cut_sources(obj)
    document = obj.Document
    document.removeObject(obj.Name)
    for body, curves in sections:
        section_sketches(document, body, curves)


def _curve_to_drag(obj: Any) -> PlaneCurve:
    spec = nearest_spec_of(obj, drawn_curve(obj.Curve, obj))
    found = in_background(SEARCHING, nearest_to_drag, spec)
    if found.cost:
        report(found.cost, obj.Label)
    return found.curve


def _cut_sources(obj: Any) -> tuple[list[tuple[Any, list[SectionCurve]]], list[str]]:
    if not obj.Sources:
        raise InputError(
            "there is nothing to cut: choose a body, a surface or a mesh in {box}", box=FieldName("Sources")
        )
    source, names = obj.Path or (None, ())
    along = obj.Family == FAMILIES[2] and source is not None
    family = Family(
        obj.Family,
        obj.Count,
        obj.Axis,
        [getattr(obj, f"Through{axis}").Value for axis in AXES],
        obj.Sweep.Value,
        path_points(source, [name for name in names if name]) if along else None,
    )
    sections, remarks = [], []
    with progress(QT_TRANSLATE_NOOP("Elastica", "Cutting"), 2 * obj.Count * len(obj.Sources)) as step:
        for k, body in enumerate(obj.Sources):
            done = 2 * k * obj.Count
            cuts = cut(body, family, lambda i, done=done: step(done + i))
            curves, messages = curves_of(
                cuts,
                tolerance=obj.Tolerance.Value,
                waves=obj.Waves.Value,
                closed=obj.Closed,
                step=lambda i, done=done + obj.Count: step(done + i),
            )
            sections.append((body, curves))
            remarks += messages
    return sections, remarks
