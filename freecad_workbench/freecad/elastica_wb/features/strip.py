# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""The parametric strip: follows a sketch, stands on its curve, says in its properties what it found."""

from collections.abc import Iterable
from typing import Any

import FreeCAD as App
from freecad.elastica_wb.curves.sketch_curves import drawn_curve, is_sketch
from freecad.elastica_wb.features.property_table import ensure, put
from freecad.elastica_wb.features.strip_properties import FORMS, PROPERTIES
from freecad.elastica_wb.features.strip_request import spec_of
from freecad.elastica_wb.host import preferences
from freecad.elastica_wb.host.refusal import FAILURES, explained, refused
from freecad.elastica_wb.host.sheet_store import sheet_called, sheet_list
from freecad.elastica_wb.host.user_units import worded
from freecad.elastica_wb.host.view_providers import dress
from freecad.elastica_wb.solving.strip_cache import bent_shape, find_nearest, flat_shape, judged, solve_strip

from elastica_cad.errors import ElasticaError, InputError
from elastica_cad.fabrication.drawings.sheet_colors import sheet_color
from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.mechanics.theorem1.verdict import NotRealizable

__all__ = ["FORMS", "StripFeature", "create", "hide_failed", "is_stale", "is_strip", "spec_of", "strip_of"]

BODY = "PartDesign::Body"


class StripFeature:
    """Proxy of a strip; it keeps nothing, everything lives in the properties."""

    def __init__(self, obj: Any) -> None:
        obj.Proxy = self
        self._ensure(obj)

    def onDocumentRestored(self, obj: Any) -> None:
        """Bring a file of an earlier version up to date."""
        self._ensure(obj)
        dress(obj, "Strip")

    def onChanged(self, obj: Any, name: str) -> None:
        """A newly chosen sheet brings its thickness, and its numbers into the document."""
        if name == "Curve" and "Restore" not in obj.State and "Containers" in obj.PropertiesList:
            put(obj, Containers=_containers(obj))
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
            spec = spec_of(obj, drawn)
            strip = solve_strip(spec)
            shape = bent_shape(strip) if obj.Form == "Bent" else flat_shape(strip)
            made_from = _mark(obj, drawn, spec)
        except FAILURES as error:
            told = explained(error)
            _tell_error(obj, told)
            raise refused(obj, told) from None
        if "AddSubShape" in obj.PropertiesList:  # what PartDesign's patterns repeat
            obj.AddSubShape = shape
        obj.Shape = shape
        if obj.Form == "Bent":
            obj.Placement = drawn.placement
        put(obj, MadeFrom=made_from)
        _tell_results(obj, strip, find_nearest(spec.rod_spec).deviation if spec.may_change else None)

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
    obj = document.addObject("PartDesign::FeatureAdditivePython" if body else "Part::FeaturePython", "Strip")
    StripFeature(obj)
    if group is not None and (body or group.TypeId != BODY):
        group.addObject(obj)
    obj.Curve = (sketch, list(edges))
    obj.MaxWidth = obj.OuterWidth = preferences.get("MaxWidth")
    obj.StartTab = obj.EndTab = preferences.get("TabLength")
    dress(obj, "Strip")
    if App.GuiUp:
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
    return solve_strip(spec_of(obj, drawn_curve(obj.Curve, obj)))


def is_stale(obj: Any, changed: set[str]) -> bool:
    """Was the shape made from another request? `changed` names the objects that are not as they were."""
    source = obj.Curve[0] if obj.Curve else None
    touched = {obj.Name, *(one.Name for one in (source, *_parents(source)) if one is not None)}
    if not touched & changed:
        return False
    try:
        drawn = drawn_curve(obj.Curve, obj)
        return bool(obj.MadeFrom != _mark(obj, drawn, spec_of(obj, drawn)))
    except FAILURES:
        return True


def _mark(obj: Any, drawn: Any, spec: Any) -> str:
    """What tells a request from others, within one run of FreeCAD."""
    return f"{hash((spec, obj.Form, tuple(drawn.placement.toMatrix().A))):x}"


def _parents(source: Any) -> list[Any]:
    """The containers that an object moves with, inside out."""
    found: list[Any] = []
    while source is not None:
        source = source.getParentGeoFeatureGroup()
        found.append(source)
    return found[:-1]


def _containers(obj: Any) -> list[Any]:
    """Containers that move the curve and not the strip: it is made anew where they move."""
    source = obj.Curve[0] if obj.Curve else None
    own = [obj, *_parents(obj)]
    return [one for one in _parents(source) if one not in own]


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
        StrainUse=round(100 * strip.max_strain / strip.strain_limit),
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
    put(obj, Verdict=verdict, Reasons=[worded(reason) for reason in reasons], MadeFrom="")
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
