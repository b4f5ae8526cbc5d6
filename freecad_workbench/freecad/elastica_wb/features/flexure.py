# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Two-state parts, with two drawn curves as rest shapes, and their holders as parametric objects."""

from dataclasses import dataclass
from typing import Any, ClassVar

import Part
from freecad.elastica_wb.curves.part_shapes import make_solid
from freecad.elastica_wb.curves.sketch_curves import drawn_curve, renumbered
from freecad.elastica_wb.features.proxy import Feature, added
from freecad.elastica_wb.features.strip_properties import SHEET_PROPERTIES, sheet_of, value_of_field
from freecad.elastica_wb.host.progress import in_background
from freecad.elastica_wb.host.property_table import Property, declared_property, put, result
from freecad.elastica_wb.host.resources import QT_TRANSLATE_NOOP, translate
from freecad.elastica_wb.host.sheet_store import sheet_list
from freecad.elastica_wb.solving.strip_cache import remembered

from elastica_cad.declared import Field, Record
from elastica_cad.design.records import Reader, idle_keys, paths_of
from elastica_cad.design.records import put as put_key
from elastica_cad.design.tables import Table
from elastica_cad.errors import ElasticaError, note
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.path import Path
from elastica_cad.geometry.plane_points import box_about
from elastica_cad.mechanics.theorem1 import NotRealizable
from elastica_cad.pairs.flexure import CentreLine, Flexure
from elastica_cad.pairs.flexure_spec import FlexureSpec
from elastica_cad.strip.flat_pattern import in_short_pieces
from elastica_cad.strip.solids import FlatSolid

FORMS = ["Everything", "First state", "Second state", "As cut", "Holder"]
USUAL_SHEET = "pom-2"
"""Sheet of a new part. It is thick and allows large strains."""

# distance, mm, between the states and the part as cut
GAP_MM = 10.0
SEARCHING = QT_TRANSLATE_NOOP("Elastica", "Searching the part with two states")


@dataclass(frozen=True)
class FlexureKeys:
    """Keys of a two-state part for which the feature has properties."""

    BESIDE: ClassVar[Record] = FlexureSpec
    WITHOUT: ClassVar[tuple[str, ...]] = ("first", "second", "scale", "sheet", "first_state", "second_state")


NAMES = {
    "label": "EngravedText", "ignore_limits": "Anyway", "limits.ratio": "RatioLimit",
    "limits.natural_curvature": "NaturalCurvatureLimit", "limits.bend": "BendLimit",
}  # fmt: skip
"""Names, by key, of properties that strips also have. All other names are derived from the keys."""

FIELDS: dict[str, tuple[str, Field]] = {
    NAMES.get(path) or path.title().replace("_", "").replace(".", ""): (path, field)
    for path, field in paths_of(FlexureKeys).items()
    if path not in ("pad", "limits")
}
"""Key and declared field by the name of the property, such as PadLength."""


class FlexureFeature(Feature):
    """A part with two states, in the plane of the first curve. Both states start in the same clamp."""

    properties = (
        Property("LinkSubGlobal", "Curve", "Curve", "Sketch or edges with the first state"),
        Property("LinkSubGlobal", "SecondCurve", "Curve", "Sketch or edges with the second state"),
        Property("Enumeration", "Form", "Curve", "What the feature shows", FORMS),
        Property("Enumeration", "Sheet", "Sheet", "Material the part is cut from"),
        *SHEET_PROPERTIES,
        Property("Integer", "Quantity", "Part", "Number of copies to cut", 1),
        *(declared_property(field, "Part", name) for name, (_, field) in FIELDS.items()),
        result("String", "Verdict", "Verdict on the part and its curves"),
        result("StringList", "Reasons", "Reasons and remarks"),
        result("Bool", "Bistable", "True if the part snaps between its states in the same clamps"),
        result("Float", "LargestForce", "Largest force between the states, N"),
        result("Length", "SnapTravel", "Travel of the pushed point at which the part snaps; 0 for none"),
        result("Length", "Length", "Length between the pads along the curve"),
        result("Length", "ThinnestPlace", "Least thickness in the plane"),
        result("Length", "ThickestPlace", "Largest thickness in the plane"),
        result("Float", "LargestStrain", "Largest strain of the skin, in percent"),
    )
    sheets: ClassVar = {"Sheet": "SheetData"}
    deciding = ("Free",)

    def show_idle(self, obj: Any) -> None:
        """Make the properties read-only that have no effect, such as PushAt if the ends are free."""
        idle = idle_keys(FlexureKeys, _table_of(obj))
        for name, (path, _) in FIELDS.items():
            obj.setEditorMode(name, int(path in idle))

    def make(self, obj: Any) -> None:
        """Set the shape and the results."""
        part = flexure_of(obj)
        shapes = [make_solid(solid) for _, solid in solids_of(part, obj.Form)]
        obj.Shape = shapes[0] if len(shapes) == 1 else Part.Compound(shapes)
        # only the user places the part as cut
        if obj.Form != "As cut":
            obj.Placement = drawn_curve(obj.Curve, obj).placement
        obj.setEditorMode("PushAt", int(not part.pair.bistable))
        travel = part.travel
        put(
            obj,
            Verdict=(
                note("This part rests in both curves and snaps between them.")
                if part.bistable
                else note("The end of this part can be clamped in two positions.")
                if not part.pair.bistable
                else note("This part does not rest in both curves.")
            ),
            Reasons=[*renumbered(obj), *part.warnings],
            Bistable=part.bistable,
            LargestForce=travel.largest_force,
            SnapTravel=(travel.snap or 0.0) if part.pair.bistable else 0.0,
            Length=part.pair.length,
            ThinnestPlace=part.thickness_range[0],
            ThickestPlace=part.thickness_range[1],
            LargestStrain=100 * max(*part.strain, part.travel_strain),
        )

    def show_error(self, obj: Any, error: ElasticaError) -> None:
        """Replace the results by the error."""
        refused = isinstance(error, NotRealizable)
        reasons = error.check.reasons if refused else [str(error)]
        verdict = note("No part rests in both curves.") if refused else note("There is no part.")
        put(obj, Verdict=verdict, Reasons=list(reasons))


def create(
    document: Any, first: Any, first_edges: tuple[str, ...], second: Any, second_edges: tuple[str, ...]
) -> Any:
    """Make a two-state part from two curves, without recomputing the document."""
    curves = {"Curve": (first, list(first_edges)), "SecondCurve": (second, list(second_edges))}
    label = f"{first.Label} {translate('Elastica', 'two states')}"
    usual = {"Sheet": USUAL_SHEET} if USUAL_SHEET in sheet_list() else {}
    return added(document, "Flexure", FlexureFeature, [first, second], Label=label, **curves, **usual)


def spec_of(obj: Any) -> FlexureSpec:
    """Return the `FlexureSpec` that the properties define. Properties without effect are ignored."""
    first, second = (drawn_curve(link, obj).curve for link in (obj.Curve, obj.SecondCurve))
    table = _table_of(obj)
    acting = {key: table.raw(key) for key in table.data.keys() - idle_keys(FlexureKeys, table)}
    return FlexureSpec(first, second, sheet_of(obj), **Reader().given(FlexureKeys, Table(acting, "", {})))


def _table_of(obj: Any) -> Table:
    table: dict[str, Any] = {}
    for name, (path, field) in FIELDS.items():
        value = value_of_field(obj, name, field)
        if value is not None:
            put_key(table, path, value)
    return Table(table, "", {})


def flexure_of(obj: Any) -> Flexure:
    """Return the `Flexure` record of a feature."""
    return in_background(SEARCHING, _flexure, spec_of(obj))


@remembered
def _flexure(spec: FlexureSpec) -> Flexure:
    part = spec.make()
    # warnings and forces are slow, so the part computes and caches them here, in the background
    _ = part.warnings, part.force_text
    return part


def solids_of(part: Flexure, form: str = FORMS[0]) -> list[tuple[str, FlatSolid]]:
    """Return the named bodies for a value of the property Form, in the plane of the first curve.

    The holder is below the states, and the part as cut is in front of the states.
    """
    depth = part.sheet.thickness
    states = [part.line_through(rest.position) for rest in part.rests]
    low, _ = box_about(part.rods[0].position)
    top = part.outline.points(depth)[:, 1].max()
    flat = Frame((float(low[0]), float(low[1] - GAP_MM - part.pad_width - top), 0.0))
    solids = dict(
        zip(
            FORMS[1:],
            (
                *(_bent(part, line) for line in states),
                FlatSolid(
                    in_short_pieces(part.outline), part.holes, depth, Frame() if form == "As cut" else flat
                ),
                part.holder_solid,
            ),
            strict=True,
        )
    )
    return list(solids.items()) if form == FORMS[0] else [(form, solids[form])]


def _bent(part: Flexure, line: CentreLine) -> FlatSolid:
    holes = [Path.circle(place, part.pad.hole / 2) for place in part.hole_places(line).reshape(-1, 2)]
    return FlatSolid(in_short_pieces(part.outline_along(line)), tuple(holes), part.sheet.thickness)
