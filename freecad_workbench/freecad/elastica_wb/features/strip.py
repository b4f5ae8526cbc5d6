# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""The strip as a parametric object, which follows a curve and stores the results in properties."""

from collections.abc import Iterator
from contextlib import suppress
from typing import Any, ClassVar
from weakref import WeakValueDictionary

import FreeCAD as App
from freecad.elastica_wb.curves.copies import Standing, copies, repeated
from freecad.elastica_wb.curves.sketch_curves import drawn_curve, renumbered
from freecad.elastica_wb.features.proxy import Feature, added, parents
from freecad.elastica_wb.features.strip_properties import (
    FOLLOW,
    PROPERTIES,
    STYLES,
    acting_lines,
    keep_fractions,
    show_idle,
    spec_of,
)
from freecad.elastica_wb.host import preferences
from freecad.elastica_wb.host.objects import is_sketch, is_strip
from freecad.elastica_wb.host.progress import in_background
from freecad.elastica_wb.host.property_table import put
from freecad.elastica_wb.host.refusal import FAILURES, explained
from freecad.elastica_wb.host.resources import translate
from freecad.elastica_wb.host.words import name_of
from freecad.elastica_wb.solving.strip_cache import (
    SEARCHING,
    bent_shape,
    find_rod,
    flat_shape,
    held_shape,
    judged,
    moved_by_smoothing,
    solve_strip,
)
from freecad.elastica_wb.solving.verdicts import is_bent_beforehand, strip_faults

from elastica_cad.design.reports import pre_bend_message
from elastica_cad.errors import (
    Change,
    ElasticaError,
    InputError,
    Length,
    Refusal,
    StrainError,
    note,
    sentences,
)
from elastica_cad.form_finding.nearest_record import NearestRod
from elastica_cad.mechanics.theorem1 import NotRealizable
from elastica_cad.strip.strip import Strip
from elastica_cad.strip.strip_spec import StripSpec
from elastica_cad.strip.suggestions import instruction
from elastica_cad.strip.summary import not_computed_row

BODY = "PartDesign::Body"

CHANGEABLE = ("smooth", "nearest", "between", "max_width", "thickness", "sheet")
DRAWN = ("point", "size")
"""Suggested changes of the drawing: "point" moves a control point, and "size" scales the curve.

`CHANGEABLE` has the fields of the strip that suggestions may change."""


_shown: WeakValueDictionary[str, Strip] = WeakValueDictionary()
"""Displayed strips, by the hash of their request."""

_nearest: WeakValueDictionary[str, NearestRod] = WeakValueDictionary()
"""Nearest rods of displayed strips whose curve was allowed to change, by the hash of their request."""


class StripFeature(Feature):
    """The proxy of a parametric strip."""

    properties = PROPERTIES
    sheets: ClassVar = {"Sheet": "SheetData", "Backing": "BackingData"}
    deciding = ("Style", "Law", "Follow", "Gravity", "Blank")

    def __init__(self, obj: Any) -> None:
        super().__init__(obj)
        obj.Anticlastic = True

    def show_idle(self, obj: Any) -> None:
        """Make the properties read-only that have no effect beside the present values of others, such as Style."""
        show_idle(obj)

    def onDocumentRestored(self, obj: Any) -> None:
        """Update a file of an earlier version.

        There a strip beyond the limits was only a warning, and a curve whose outline has only corners was kept.
        """
        lacks_override, lacks_choice = (name not in obj.PropertiesList for name in ("Anyway", "AsDrawn"))
        super().onDocumentRestored(obj)
        if lacks_choice:
            obj.AsDrawn = obj.Deviation.Value == 0
        if lacks_override:
            obj.Anyway = obj.StrainUse >= 100

    def onChanged(self, obj: Any, name: str) -> None:
        """Set PlacesLength to 0 after a change of ties or loads.

        PlacesLength is the length of the curve for which the positions of ties and loads were set. With 0, the
        positions refer to the current curve and are not scaled.
        """
        super().onChanged(obj, name)
        if (
            name in ("Between", "Loads")
            and "Restore" not in obj.State
            and not obj.Document.Transacting  # undo and redo restore PlacesLength themselves
            and "PlacesLength" in obj.PropertiesList
        ):
            put(obj, PlacesLength=0.0)

    def make(self, obj: Any) -> None:
        """Set the shape and the results."""
        drawn = drawn_curve(obj.Curve, obj)
        spec = spec_of(obj, drawn)
        keep_fractions(obj, drawn)
        strip = solve_strip(spec)
        shape = bent_shape(strip) if obj.Form == "Bent" else flat_shape(strip)
        made_from = _hash_of_request(obj, drawn, spec)
        if hasattr(obj, "AddSubShape"):  # patterns of PartDesign repeat this shape
            obj.AddSubShape = shape
        obj.Shape = shape
        _shown[made_from] = strip
        if obj.Form == "Bent":
            obj.Placement = drawn.placement
        if obj.MadeFrom != made_from:
            put(
                obj,
                MadeFrom=made_from,
                HeldDeviation=0.0,
                ExpectedDeviation=0.0,
                Held="",
            )
        near = _nearest_of(spec)
        if near is not None:
            _nearest[made_from] = near
        _show_results(obj, strip, near, moved_by_smoothing(spec), renumbered(obj))

    def failed(self, obj: Any, error: ElasticaError) -> None:
        """Show the error. While the sketch is open, no feature is hidden."""
        if is_edited(obj):
            self.show_error(obj, error)
        else:
            super().failed(obj, error)

    def show_error(self, obj: Any, error: ElasticaError) -> None:
        """Replace the results by the error."""
        reasons, verdict = [str(error)], "There is no strip."
        if isinstance(error, NotRealizable):
            bent = "A pre-bent strip cannot take this curve."
            verdict = bent if error.check.bent_beforehand else "A flat strip cannot take this curve."
            reasons = list(error.check.reasons)
        elif isinstance(error, StrainError):
            bent = "A pre-bent strip would break on this curve."
            verdict = bent if obj.NaturalCurvature else "A flat strip would break on this curve."
            put(obj, StrainUse=error.refusal.values["percent"])
        put(
            obj,
            Verdict=verdict,
            Reasons=reasons,
            MadeFrom="",
            Held="",
            Sideways="",
        )


def create(document: Any, sketch: Any, edges: tuple[str, ...] = ()) -> Any:
    """Make a strip that follows a sketch or edges of an object, without recomputing the document."""
    group = sketch.getParentGeoFeatureGroup()
    in_body = group is not None and group.TypeId == BODY and not group.Shape.Solids
    type_id = "PartDesign::FeatureAdditivePython" if in_body else "Part::FeaturePython"
    properties: dict[str, Any] = {
        **dict.fromkeys(("MaxWidth", "OuterWidth"), preferences.get("MaxWidth")),
        **dict.fromkeys(("StartTab", "EndTab"), preferences.get("TabLength")),
    }
    # FreeCAD forbids equal labels, so the label of the sketch is used only if the user chose it
    if is_sketch(sketch) and sketch.Label != sketch.Name:
        properties["Label"] = f"{sketch.Label} {translate('Elastica', 'strip')}"
    curve = (sketch, list(edges))
    return added(document, "Strip", StripFeature, [sketch], type_id=type_id, Curve=curve, **properties)


def shown_strips(obj: Any) -> Iterator[Standing]:
    """Yield the strips that an object displays, with the placement of each copy.

    Raises
    ------
    InputError
        An original is scaled, a link is broken, or a pattern in a body repeats a strip and fuses the copies.
    """
    for standing in copies(obj):
        strip = next(filter(is_strip, repeated(standing[0])), None)
        if strip is not None:
            raise InputError(
                "{pattern} joins the copies of {strip} into one body, and loses copies that do not touch "
                "it. Delete {pattern}, and repeat the strip by an array of the workbench Draft.",
                pattern=standing[0].Label,
                strip=strip.Label,
            )
        yield standing


def strip_of(obj: Any) -> Strip:
    """Return the `Strip` record of a strip feature."""
    return solve_strip(spec_of(obj))


def valid_request(obj: Any) -> StripSpec | None:
    """Return the `StripSpec`, or None if properties are not valid. The strip may still be impossible."""
    try:
        spec = spec_of(obj)
    except FAILURES:
        return None
    return spec if obj.MaxWidth.Value > 0 or obj.MinWidth.Value > 0 else None


def suggestions(obj: Any) -> dict[str, dict[str, Any]]:
    """Return suggested changes that need no search: a text, and new values of properties.

    A change follows the advice of a message, joins edges that do not meet, or ignores a limit.
    """
    changes: list[Change] = []
    spec = None
    try:
        spec = spec_of(obj)
        strip = solve_strip(spec)
        remarks = [record for record in strip.warnings if isinstance(record, Refusal)]
        changes += (change for record in remarks for change in record.all_changes if _may_help(spec, change))
        nearest = Change("nearest", True)
        if any(fault.curve_helps for fault in strip_faults(strip)) and _may_help(spec, nearest):
            changes.append(nearest)
    except FAILURES as error:
        refusal = explained(error).refusal
        changes += refusal.all_changes if spec is None else ()
        changes += [Change("ignore_limits", True)] if "ignore_limits" in refusal.fields else []
    texts = {"join": note("Join the ends"), "ignore_limits": note("Make it anyway")}
    values = {texts.get(change.field) or instruction(change): values_of(obj, change) for change in changes}
    return {text: value for text, value in values.items() if value}


def changeable(obj: Any) -> tuple[str, ...]:
    """Return the fields that suggestions may change.

    If the strip follows all edges of a sketch, changes of the drawing (`DRAWN`) are included.
    """
    source, edges = obj.Curve or (None, ())
    return (*CHANGEABLE, *(DRAWN if is_sketch(source) and not any(edges) else ()))


def values_of(obj: Any, change: Change) -> dict[str, Any]:
    """Return new values of properties for a suggested change, or {} if the strip has no such property."""
    match change:
        case Change("max_width", width):
            return {"MaxWidth" if obj.Style == STYLES[0] else "MaterialWidth": width}
        case Change("nearest", False):
            return {"Follow": FOLLOW[0]}
        case Change("elements"):
            return acting_lines(())
        case Change("nearest"):
            has_width = obj.MaxWidth.Value or obj.MinWidth.Value
            # no ratio limit, because the suggestion was found without a limit
            return {"Follow": FOLLOW[1], "RatioLimit": 0.0} if obj.Follow == FOLLOW[0] and has_width else {}
        case Change("join", gap):
            return {"JoinGaps": gap}
        case Change("between", element):
            return {"Between": [*obj.Between, *acting_lines([element])["Between"]]}
    name = name_of(change.field)
    return {name: change.value} if name in obj.PropertiesList else {}


def _may_help(spec: StripSpec, change: Change) -> bool:
    """Return True if the strip can be made after a change.

    A change to True or False is not tested and counts as possible, except the nearest curve for a strip with
    rails, pins, ties or point forces.
    """
    if change.field == "nearest" and (spec.between or spec.rod_spec.point_forces):
        return False  # `nearest_rod` ignores rails, pins, ties and point forces
    if isinstance(change.value, bool):
        return True
    with suppress(ElasticaError):
        changed = spec.with_change(change)
        return changed is None or bool(solve_strip(changed))
    return False


def shown_strip(obj: Any) -> Strip:
    """Return the strip from which the current shape was made. If the strip is unknown, compute it."""
    return _shown.get(obj.MadeFrom) or strip_of(obj)


def shown_nearest(obj: Any) -> NearestRod | None:
    """Return the nearest rod from which the current shape was made, or None if the drawn curve was kept."""
    if obj.MadeFrom in _shown:
        return _nearest.get(obj.MadeFrom)
    return _nearest_of(spec_of(obj))


def _nearest_of(spec: StripSpec) -> NearestRod | None:
    return in_background(SEARCHING, find_rod, spec.rod_spec) if spec.may_change else None


def show_held(obj: Any) -> None:
    """Write into the results how far the strip in its holders deviates from its curve.

    The computation takes as long as all other results together, so it follows the recompute. Strips with
    rails, pins, ties or point forces have no such result, nor have strips that can snap into another shape.
    """
    if obj.Held or not obj.MadeFrom or "Invalid" in obj.State:
        return
    try:
        strip = strip_of(obj)
        if not_computed_row(strip):
            return
        shape = held_shape(strip)
        message = (
            note(
                "With its ends held in these positions, the strip takes a shape far from its design. Hold "
                "the ends nearer to their designed positions."
            )
            if shape is None
            else str(shape)
        )
    except ElasticaError as error:
        shape, message = None, str(error)
    distances = (0.0, 0.0) if shape is None else (shape.deviation, shape.expected)
    put(obj, HeldDeviation=distances[0], ExpectedDeviation=distances[1], Held=message)


def is_stale(obj: Any, changed: set[str]) -> bool:
    """Return True if the shape is outdated. `changed` contains the names of changed objects."""
    source = obj.Curve[0] if obj.Curve else None
    touched = {
        watched.Name for watched in (obj, *parents(obj), source, *parents(source)) if watched is not None
    }
    if not touched & changed:
        return False
    if "Invalid" in obj.State:  # an undo restores the earlier results, but not the state of the feature
        return True
    try:
        drawn = drawn_curve(obj.Curve, obj)
        return bool(obj.MadeFrom != _hash_of_request(obj, drawn, spec_of(obj, drawn)))
    except FAILURES:
        return True


def _hash_of_request(obj: Any, drawn: Any, spec: Any) -> str:
    """Return a hash of a request that is valid only in the current session of FreeCAD."""
    return f"{hash((spec, obj.Form, tuple(drawn.placement.toMatrix().A))):x}"


def _show_results(
    obj: Any, strip: Strip, near: NearestRod | None, smoothed: float, remarks: list[str]
) -> None:
    """Write the results with further remarks. Smoothing moved the curve by `smoothed` mm."""
    rod, stability, sideways = strip.rod, judged(strip.rod), strip.sideways
    faults, bent, refused = list(strip_faults(strip)), is_bent_beforehand(strip), strip.strain_verdict.refused
    notes = [
        *remarks,
        *(fault.sentence for fault in faults),
        *filter(None, [pre_bend_message(strip), strip.backing_side]),
        *strip.warnings,
        *([] if sideways.word == "ample" else [str(sideways)]),
    ]
    words = [fault.words for fault in faults if not (refused and fault.number == "LargestStrain")]
    fails = note("The strip fails: {faults}.", faults=sentences(words, "; ")) if words else ""
    verdict = "" if faults else note(
        "A pre-bent strip can be bent into this curve." if bent else "A flat strip can be bent into this curve."
    )  # fmt: skip
    if not faults and rod.check is not None and rod.check.undecided is not None:
        verdict = rod.check.verdict
    if near is not None:
        verdict = note(
            "A pre-bent strip cannot take this curve, but it can take a curve at most {far} from it."
            if bent else
            "A flat strip cannot take this curve, but it can take a curve at most {far} from it.",
            far=Length(near.deviation),
        )  # fmt: skip
    if refused:
        breaks = note(
            "A pre-bent strip would break on this curve."
            if bent
            else "A flat strip would break on this curve."
        )
        fails, verdict = breaks, fails
    put(
        obj,
        Verdict=sentences([fails, verdict], " "),
        Reasons=list(dict.fromkeys(notes)),
        Fails=[fault.number for fault in faults],
        Margin=0.0 if stability is None else stability.margin,
        ConjugatePoint=0.0 if stability is None else stability.conjugate_point or 0.0,
        Deviation=rod.moved + smoothed if near is None else near.deviation,
        **{entry.name: entry.of(strip) for entry in PROPERTIES if entry.of is not None},
    )


def is_edited(obj: Any) -> bool:
    """Return True if the sketch of the strip is open. Hiding the strip would then cause flicker."""
    if not App.GuiUp or obj.Curve is None or not is_sketch(obj.Curve[0]):
        return False
    import FreeCADGui as Gui

    edited = Gui.getDocument(obj.Document.Name).getInEdit()
    return edited is not None and edited.Object == obj.Curve[0]
