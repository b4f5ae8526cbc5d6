"""The parametric strip: follows a sketch, stands on its curve, says in its properties what it found."""

from collections.abc import Iterable
from typing import Any

import FreeCAD as App
from freecad.elastica_wb import preferences
from freecad.elastica_wb.design import bent_shape, flat_shape, judged, nearest, solved
from freecad.elastica_wb.drawn import drawn_curve, is_sketch
from freecad.elastica_wb.features.asked import FORMS, PROPERTIES, wish_of
from freecad.elastica_wb.features.properties import ensure, put
from freecad.elastica_wb.features.refusal import FAILURES, explained, refused
from freecad.elastica_wb.library import sheet_called, sheet_list
from freecad.elastica_wb.units import worded

from elastica_cad.errors import ElasticaError, InputError
from elastica_cad.fabrication import Strip, sheet_color
from elastica_cad.mechanics import NotRealizable

__all__ = ["FORMS", "StripFeature", "create", "hide_failed", "is_strip", "strip_of", "wish_of"]

BODY = "PartDesign::Body"


class StripFeature:
    """Proxy of a strip; it keeps nothing, everything lives in the properties."""

    def __init__(self, obj: Any) -> None:
        obj.Proxy = self
        self._ensure(obj)

    def onDocumentRestored(self, obj: Any) -> None:
        """Bring a file of an earlier version up to date."""
        self._ensure(obj)

    def onChanged(self, obj: Any, name: str) -> None:
        """A newly chosen sheet brings its thickness, and its numbers into the document."""
        kept = {"Sheet": "SheetData", "Backing": "BackingData"}.get(name)
        if kept is None or "Restore" in obj.State or kept not in obj.PropertiesList:
            return
        try:
            sheet = sheet_called(getattr(obj, name), getattr(obj, kept))
        except InputError:
            return  # the next recompute says it
        put(obj, **{kept: sheet.toml()})
        if name == "Sheet":
            put(obj, Thickness=sheet.thickness)

    def execute(self, obj: Any) -> None:
        """Make the shape and tell the results, or fail with a sentence and keep the last good shape."""
        try:
            drawn = drawn_curve(obj.Curve, obj)
            wish = wish_of(obj, drawn)
            strip = solved(drawn.curve, wish)
            shape = bent_shape(strip) if obj.Form == "Bent" else flat_shape(strip)
        except FAILURES as error:
            told = explained(error)
            _tell_error(obj, told)
            raise refused(obj, told) from None
        obj.Shape = shape
        if obj.Form == "Bent":
            obj.Placement = drawn.placement
        _tell_results(obj, strip, nearest(drawn.curve, wish).deviation if wish.nearest else None)

    def dumps(self) -> None:
        """Nothing to save."""

    def loads(self, state: Any) -> None:
        """Nothing to load."""

    __getstate__ = dumps
    __setstate__ = loads

    @staticmethod
    def _ensure(obj: Any) -> None:
        known = {name: getattr(obj, name) for name in ("Sheet", "Backing") if name in obj.PropertiesList}
        ensure(obj, PROPERTIES)
        for name in ("Sheet", "Backing"):
            chosen = known.get(name) or preferences.default_sheet()
            setattr(obj, name, list(dict.fromkeys([*sheet_list(), chosen])))
            setattr(obj, name, chosen)


def create(document: Any, sketch: Any, edges: tuple[str, ...] = ()) -> Any:
    """The parametric strip that follows a sketch, or edges of an object; recompute the document to see it."""
    group = sketch.getParentGeoFeatureGroup()
    body = group is not None and group.TypeId == BODY and not _solids(group)
    obj = document.addObject("PartDesign::FeaturePython" if body else "Part::FeaturePython", "Strip")
    StripFeature(obj)
    if group is not None and (body or group.TypeId != BODY):
        group.addObject(obj)
    obj.Curve = (sketch, list(edges))
    obj.MaxWidth = obj.OuterWidth = preferences.get("MaxWidth")
    obj.StartTab = obj.EndTab = preferences.get("TabLength")
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


def _solids(body: Any) -> bool:
    shape = getattr(body, "Shape", None)
    return shape is not None and not shape.isNull() and bool(shape.Solids)


def _tell_results(obj: Any, strip: Strip, changed: float | None) -> None:
    """Write what was found; `changed`, mm, tells how far a nearest curve is from the drawn one."""
    rod, found = strip.rod, judged(strip.rod)
    notes = list(strip.warnings)
    if found is not None and not found.stable:
        where = (
            "" if found.conjugate_point is None else f" (conjugate point at {found.conjugate_point:.4g} mm)"
        )
        notes.append(f"it does not stay in this shape: the stability margin is {found.margin:.3g}{where}")
    taken = "this curve" if changed is None else f"a curve {changed:.3g} mm from this one"
    put(
        obj,
        Verdict=worded(f"A flat strip takes {taken}{', with remarks' if notes else ''}."),
        Reasons=[worded(note) for note in notes],
        Ratio=rod.ratio,
        Margin=0.0 if found is None else found.margin,
        ConjugatePoint=0.0 if found is None or found.conjugate_point is None else found.conjugate_point,
        LargestStrain=100 * strip.max_strain,
        StrainUse=min(100, round(100 * strip.max_strain / strip.sheet.max_strain)),
        Deviation=rod.moved if changed is None else changed,
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
    put(obj, Verdict=verdict, Reasons=[worded(reason) for reason in reasons])
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
