"""The parametric strip: follows a sketch, stands on its curve, says in its properties what it found."""

from collections.abc import Iterable
from dataclasses import replace
from typing import Any

import FreeCAD as App
from freecad.elastica_wb import preferences
from freecad.elastica_wb.design import Wish, bent_shape, flat_shape, judged, nearest, solved
from freecad.elastica_wb.drawn import DrawnCurve, drawn_curve, frame_of, is_sketch
from freecad.elastica_wb.features.properties import Property, ensure, put
from freecad.elastica_wb.library import sheet_called, sheet_list

from elastica_cad.errors import ElasticaError, InputError
from elastica_cad.fabrication import Hole, Strip, Tab, sheet_color
from elastica_cad.geometry import PlaneCurve
from elastica_cad.mechanics import Gravity, NotRealizable, Sheet, Supports

__all__ = ["FORMS", "StripFeature", "create", "hide_failed", "is_strip", "strip_of", "wish_of"]

FORMS = ["Bent", "Flat"]
FOLLOW = ["Exactly", "Nearest"]
ENDS = ["clamped", "pinned", "slide-x", "slide-y", "guided", "free"]
BODY = "PartDesign::Body"

PROPERTIES = (
    Property("LinkSub", "Curve", "Curve", "Sketch, or edges of an object, that the strip follows"),
    Property("Enumeration", "Form", "Curve", "What the shape is: the strip as bent, or as cut", FORMS),
    Property("Enumeration", "Sheet", "Sheet", "Material the strip is cut from"),
    Property("Length", "Thickness", "Sheet", "Thickness of the sheet; measure yours", 1.0),
    Property(
        "String",
        "SheetData",
        "Sheet",
        "The sheet's numbers, so that the file opens anywhere",
        "",
        hidden=True,
    ),
    Property("Length", "MaxWidth", "Width", "Width of the widest place; 0 leaves it to MinWidth", 30.0),
    Property(
        "Length", "MinWidth", "Width", "Width of the narrowest place, or a limit for it; 0 for none", 0.0
    ),
    Property("Enumeration", "StartSupport", "Mechanics", "What holds the start of the curve", ENDS),
    Property("Enumeration", "EndSupport", "Mechanics", "What holds the end of the curve", ENDS),
    Property("Bool", "Gravity", "Mechanics", "Does the strip carry its own weight?", False),
    Property(
        "Vector",
        "GravityDirection",
        "Mechanics",
        "Direction in space in which things fall",
        App.Vector(0, 0, -1),
    ),
    Property("Float", "NaturalCurvature", "Mechanics", "Curvature of the strip before bending, 1/mm", 0.0),
    Property("Integer", "Samples", "Mechanics", "Nodes of the rod; 0 chooses", 0),
    Property(
        "Enumeration",
        "Follow",
        "Nearest",
        "Follow the curve exactly, or the nearest one within limits",
        FOLLOW,
    ),
    Property("Float", "RatioLimit", "Nearest", "Largest stiffness ratio; 0 for none", 3.5),
    Property("Float", "MarginLimit", "Nearest", "Least stability margin; 5 is safely stable", 5.0),
    Property("Float", "StrainLimit", "Nearest", "Largest strain in percent; 0 takes the sheet's", 0.0),
    Property("Bool", "KeepTangents", "Nearest", "Keep the tangents of both ends", False),
    Property("Bool", "KeepLength", "Nearest", "Keep the length", False),
    Property("Length", "StartTab", "Ends", "Length of the tab at the start", 10.0),
    Property("Length", "EndTab", "Ends", "Length of the tab at the end", 10.0),
    Property("Length", "TabRadius", "Ends", "Rounding of the tabs' corners", 0.0),
    Property("Length", "TabHole", "Ends", "Diameter of a hole in the middle of each tab; 0 for none", 0.0),
    Property("String", "EngravedText", "Ends", "Text engraved on the strip", ""),
    Property("Integer", "Quantity", "Ends", "How many of it are cut", 1),
    Property("String", "Verdict", "Result", "Can a flat strip take the curve?", "", result=True),
    Property("StringList", "Reasons", "Result", "Why not, and what else to know", [], result=True),
    Property("Float", "Ratio", "Result", "Largest stiffness over least stiffness", 0.0, result=True),
    Property("Float", "Margin", "Result", "Stability margin; positive means that it stays", 0.0, result=True),
    Property(
        "Length",
        "ConjugatePoint",
        "Result",
        "Where along the strip stability is lost; 0 where it is not",
        0.0,
        result=True,
    ),
    Property(
        "Percent", "StrainUse", "Result", "Largest strain, in percent of what the sheet bears", 0, result=True
    ),
    Property("Float", "LargestStrain", "Result", "Largest strain of the skin, in percent", 0.0, result=True),
    Property("Length", "Deviation", "Result", "Largest distance from the drawn curve", 0.0, result=True),
    Property("Length", "Length", "Result", "Length of the free part along the curve", 0.0, result=True),
    Property("Length", "NarrowestWidth", "Result", "Width of the narrowest place", 0.0, result=True),
    Property("Float", "Mass", "Result", "Mass in grams", 0.0, result=True),
    Property(
        "Bool", "HiddenByError", "Result", "Hidden until the curve can be bent again", False, hidden=True
    ),
)


class StripFeature:
    """Proxy of a strip; it keeps nothing, everything lives in the properties."""

    def __init__(self, obj: Any) -> None:
        obj.Proxy = self
        self._ensure(obj)

    def onDocumentRestored(self, obj: Any) -> None:
        """Bring a file of an earlier version up to date."""
        self._ensure(obj)

    def onChanged(self, obj: Any, name: str) -> None:
        """A newly chosen sheet brings its thickness."""
        if name != "Sheet" or "Restore" in obj.State or "SheetData" not in obj.PropertiesList:
            return
        try:
            sheet = sheet_called(obj.Sheet, obj.SheetData)
        except InputError:
            return  # the next recompute says it
        put(obj, Thickness=sheet.thickness, SheetData=sheet.toml())

    def execute(self, obj: Any) -> None:
        """Make the shape and tell the results, or fail with a sentence and keep the last good shape."""
        try:
            drawn = drawn_curve(obj.Curve, obj)
            strip = solved(drawn.curve, wish_of(obj, drawn))
            shape = bent_shape(strip) if obj.Form == "Bent" else flat_shape(strip)
        except ElasticaError as error:
            _tell_error(obj, error)
            raise ValueError(str(error)) from None
        obj.Shape = shape.copy()
        if obj.Form == "Bent":
            obj.Placement = drawn.placement
        _tell_results(obj, strip, drawn.curve)

    def dumps(self) -> None:
        """Nothing to save."""

    def loads(self, state: Any) -> None:
        """Nothing to load."""

    __getstate__ = dumps
    __setstate__ = loads

    @staticmethod
    def _ensure(obj: Any) -> None:
        fresh = "Sheet" not in obj.PropertiesList
        ensure(obj, PROPERTIES)
        chosen = preferences.default_sheet() if fresh else obj.Sheet
        obj.Sheet = list(dict.fromkeys([*sheet_list(), chosen]))
        obj.Sheet = chosen
        obj.setEditorMode("Placement", 0)


def create(document: Any, sketch: Any, edges: tuple[str, ...] = ()) -> Any:
    """The parametric strip that follows a sketch, or edges of an object; recompute the document to see it."""
    group = sketch.getParentGeoFeatureGroup()
    body = group is not None and group.TypeId == BODY and not _solids(group)
    obj = document.addObject("PartDesign::FeaturePython" if body else "Part::FeaturePython", "Strip")
    StripFeature(obj)
    if group is not None and (body or group.TypeId != BODY):
        group.addObject(obj)
    obj.Curve = (sketch, list(edges))
    obj.EngravedText = ""
    if App.GuiUp:
        from freecad.elastica_wb.features.views import StripView

        StripView(obj.ViewObject)
        obj.ViewObject.ShapeColor = sheet_color(sheet_called(obj.Sheet))
    return obj


def is_strip(obj: Any) -> bool:
    """Is this object a parametric strip?"""
    return isinstance(getattr(obj, "Proxy", None), StripFeature)


def strip_of(obj: Any) -> Strip:
    """The core's strip behind a parametric strip.

    Raises
    ------
    ElasticaError
        The curve cannot be bent as asked.
    """
    drawn = drawn_curve(obj.Curve, obj)
    return solved(drawn.curve, wish_of(obj, drawn))


def wish_of(obj: Any, drawn: DrawnCurve) -> Wish:
    """What the properties ask for."""
    sheet = replace_thickness(sheet_called(obj.Sheet, obj.SheetData), obj.Thickness.Value)
    return Wish(
        sheet=sheet,
        max_width=obj.MaxWidth.Value or None,
        min_width=obj.MinWidth.Value or None,
        supports=Supports(obj.StartSupport, obj.EndSupport),
        gravity=_gravity(obj, sheet, drawn.world) if obj.Gravity else None,
        natural_curvature=obj.NaturalCurvature,
        samples=obj.Samples or None,
        ends=(_tab(obj, obj.StartTab.Value), _tab(obj, obj.EndTab.Value)),
        label=obj.EngravedText,
        nearest=obj.Follow == "Nearest",
        ratio=obj.RatioLimit or None,
        margin=obj.MarginLimit,
        strain=obj.StrainLimit / 100 or None,
        tangents=obj.KeepTangents,
        keeps_length=obj.KeepLength,
    )


def replace_thickness(sheet: Sheet, thickness: float) -> Sheet:
    """The sheet as measured; its range then speaks of another sheet and is left out."""
    return (
        sheet if sheet.thickness == thickness else replace(sheet, thickness=thickness, thickness_range=None)
    )


def _tab(obj: Any, length: float) -> Tab:
    hole = obj.TabHole.Value
    holes = (Hole(length / 2, hole),) if hole and length else ()
    return Tab(length, corner_radius=obj.TabRadius.Value if length else 0.0, holes=holes)


def _gravity(obj: Any, sheet: Sheet, world: App.Placement) -> Gravity | None:
    direction = tuple(obj.GravityDirection)
    if not any(direction):
        raise InputError("the direction of gravity is zero: give a vector such as (0, 0, -1)")
    plane = frame_of(world)
    return Gravity.in_plane(sheet.elasto_gravity_length, direction, plane.x_axis, plane.y_axis)


def _solids(body: Any) -> bool:
    shape = getattr(body, "Shape", None)
    return shape is not None and not shape.isNull() and bool(shape.Solids)


def _tell_results(obj: Any, strip: Strip, curve: PlaneCurve) -> None:
    rod, found = strip.rod, judged(strip.rod)
    near = obj.Follow == "Nearest"
    deviation = nearest(curve, wish_of(obj, drawn_curve(obj.Curve, obj))).deviation if near else rod.moved
    notes = list(strip.warnings)
    if found is not None and not found.stable:
        where = (
            "" if found.conjugate_point is None else f" (conjugate point at {found.conjugate_point:.4g} mm)"
        )
        notes.append(f"it does not stay in this shape: the stability margin is {found.margin:.3g}{where}")
    taken = f"a curve {deviation:.3g} mm from this one" if near else "this curve"
    put(
        obj,
        Verdict=f"A flat strip takes {taken}{', with remarks' if notes else ''}.",
        Reasons=notes,
        Ratio=rod.ratio,
        Margin=0.0 if found is None else found.margin,
        ConjugatePoint=0.0 if found is None or found.conjugate_point is None else found.conjugate_point,
        LargestStrain=100 * strip.max_strain,
        StrainUse=min(100, round(100 * strip.max_strain / strip.sheet.max_strain)),
        Deviation=deviation,
        Length=rod.length,
        NarrowestWidth=strip.width.extremes[0],
        Mass=strip.mass,
    )
    if obj.HiddenByError:
        obj.HiddenByError = False
        obj.Visibility = True


def _tell_error(obj: Any, error: ElasticaError) -> None:
    reasons = list(error.check.reasons) if isinstance(error, NotRealizable) else [str(error)]
    verdict = (
        "A flat strip cannot take this curve." if isinstance(error, NotRealizable) else "There is no strip."
    )
    put(obj, Verdict=verdict, Reasons=reasons)
    if obj.Visibility and not is_edited(obj):
        obj.HiddenByError = True
        obj.Visibility = False


def hide_failed(strips: Iterable[Any]) -> None:
    """Hide the strips whose shape is not that of their curve any more."""
    for obj in strips:
        if "Invalid" in obj.State and obj.Visibility:
            obj.HiddenByError = True
            obj.Visibility = False


def is_edited(obj: Any) -> bool:
    """Is the sketch behind it open for editing? Then hiding would only flicker."""
    if not App.GuiUp or obj.Curve is None or not is_sketch(obj.Curve[0]):
        return False
    import FreeCADGui as Gui

    shown = Gui.getDocument(obj.Document.Name).getInEdit()
    return shown is not None and shown.Object == obj.Curve[0]
