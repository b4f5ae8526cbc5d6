# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Properties of a strip, and their conversion to the table of a design file, which the core reads."""

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import Any, TypeAlias, get_args

import FreeCAD as App
from freecad.elastica_wb.curves.sketch_curves import DrawnCurve, drawn_curve
from freecad.elastica_wb.host.property_table import (
    NOTHING,
    Property,
    declared_property,
    require_choices,
    result,
)
from freecad.elastica_wb.host.sheet_store import sheet_called
from freecad.elastica_wb.host.words import name_of

from elastica_cad.declared import Field, declared
from elastica_cad.defaults import MAX_WIDTH, RATIO, TAB_LENGTH
from elastica_cad.design.records import BY_KIND, Reader, names_of, parsed_line, paths_of, put, word_of
from elastica_cad.design.strip_table import StripKeys, read_fields, read_request, scaled_places
from elastica_cad.design.tables import Table
from elastica_cad.design.toml_text import toml_text
from elastica_cad.errors import FieldName, Force, InputError, Length, Mass, note
from elastica_cad.form_finding.limits import BOTH_ENDS
from elastica_cad.form_finding.rod_spec import RodSpec
from elastica_cad.mechanics.elements import Element, Pin, PointForce, Rail, Tie
from elastica_cad.mechanics.loads import EndName, Gravity, PointMass, Supports
from elastica_cad.mechanics.sheets import Sheet
from elastica_cad.strip.strip_spec import StripSpec, pull_in_plane
from elastica_cad.strip.styles import Style

FORMS = ["Bent", "Flat"]
STYLES = ["Plain", "Perforated", "Laminated"]
FOLLOW = ["Exactly", "Nearest"]
ENDS = list(get_args(EndName))
KEPT_ENDS = ["both", "start", "end", "none"]
TANGENT_ENDS = KEPT_ENDS[:3]

DEFAULTS = {"MaxWidth": MAX_WIDTH, "OuterWidth": MAX_WIDTH, "RatioLimit": RATIO}
"""Values of a new strip that differ from the defaults of the fields."""

EXAMPLES = {
    "Between": "kind = 'tie', start = 40, end = 310",
    "Law": 'kind = "thickness", limits = [3, 8], width = 20',
    "Slots": "at = 40, width = 1.2, side = 'lower'",
    "KeepOut": "point = [0, 0], normal = [0, 1]",
    "StiffnessBounds": "lower = 1, upper = [2, 3, 2]",
}
"""Examples for properties whose lines are tables of a design file."""

OWN_BOXES = (
    "curve", "smooth", "engrave", "sheet", "style", "compensate", "gravity", "loads", "supports",
    "natural_curvature", "ends",
    "limits.margin", "limits.strain", "limits.length", "limits.width", "keep.ends", "keep.tangents", "keep.line",
)  # fmt: skip
"""Keys that do not correspond to a single property. Special functions read them."""

OWN_TABLES = ("style", "limits", "keep")
"""Keys of a design file that are tables, and each of whose entries is a property in FreeCAD."""

GROUPS = {"style": "Style", "limits": "Nearest", "keep": "Nearest", "curve": "Curve", "sheet": "Sheet",
          "widths": "Width", "ends": "Ends", "weight": "Mechanics"}  # fmt: skip


def _group(path: str) -> str:
    table = path.partition(".")[0]
    return GROUPS.get(table) or GROUPS.get(paths_of(StripKeys)[table].option.group, "Strip")


def _single_fields() -> Iterator[tuple[str, Field]]:
    paths, of_files = paths_of(StripKeys), {declared_field.name for declared_field in declared(StripKeys)}
    for path, field in paths.items():
        table, _, key = path.rpartition(".")
        if path in OWN_BOXES or key in ("kind", "backing") or (table and table not in OWN_TABLES):
            continue
        if table or path not in (*OWN_TABLES, "shop", *of_files):
            yield path, field
    yield "shop.least_width", paths["shop.least_width"]


FIELDS = dict(_single_fields())
"""Fields of the keys that correspond to a single property, by the path of the key."""

SHEET_PROPERTIES = (
    Property("Length", "Thickness", "Sheet", "Thickness of the sheet; measure yours", 1.0),
    Property(
        "String",
        "SheetData",
        "Sheet",
        "Data of the sheet, so that the file opens on every computer",
        hidden=True,
    ),
)

PROPERTIES = (
    Property("LinkSubGlobal", "Curve", "Curve", "Sketch, or edges of an object, that the strip follows"),
    Property("Length", "JoinGaps", "Curve", "Largest gap between ends of edges that is closed"),
    Property(
        "Length",
        "Smooth",
        "Curve",
        "Largest distance by which smoothing may move the curve; 0 removes only steps and corners, within 0.1 mm",
    ),
    Property("Bool", "AsDrawn", "Curve", "Keep the curve as drawn, if it is not smoothed"),
    Property("Enumeration", "Form", "Curve", "Shape of the feature: the strip as bent or as cut", FORMS),
    Property("Enumeration", "Sheet", "Sheet", "Material the strip is cut from"),
    *SHEET_PROPERTIES,
    Property("Bool", "Compensate", "Width", "Compensate slots, narrow tabs and holes in the widths"),
    Property(
        "Bool",
        "Anticlastic",
        "Width",
        "Compensate anticlastic bending in the widths if the sheet's Poisson ratio is known",
        # no default: files of earlier versions get the value False and keep their widths
    ),
    Property(
        "Length",
        "MaterialWidth",
        "Style",
        ("Largest total width of ligaments or backing; 0 for the largest that fits"),
    ),
    Property("Enumeration", "Style", "Style", "Style: plain, perforated or laminated", STYLES),
    Property("Enumeration", "Backing", "Style", "Sheet of the backing of a laminated strip"),
    Property("String", "BackingData", "Style", "Data of the backing's sheet", hidden=True),
    Property("Enumeration", "StartSupport", "Mechanics", "Support at the start of the curve", ENDS),
    Property("Enumeration", "EndSupport", "Mechanics", "Support at the end of the curve", ENDS),
    Property("Bool", "Gravity", "Mechanics", "Include the strip's own weight"),
    Property(
        "Vector",
        "GravityDirection",
        "Mechanics",
        "Direction of gravity in space",
        App.Vector(0, 0, -1),
    ),
    Property("Length", "GravityLength", "Mechanics", "Elasto-gravity length; 0 for the value of the sheet"),
    Property(
        "StringList",
        "Loads",
        "Mechanics",
        "Masses and forces on the strip: at = 90, mass = 3, or at = 90, force = [0, -1] (mm, g, N)",
    ),
    Property(
        "Length",
        "PlacesLength",
        "Mechanics",
        "Length of the curve to which the places of rails, ties and loads refer; 0 for the present length",
        result=True,
        hidden=True,
    ),
    Property("String", "WeightLaw", "Mechanics", "All weight in newtons: alpha = 0.001, own = true"),
    Property("Float", "NaturalCurvature", "Mechanics", "Curvature of the strip before bending, 1/mm"),
    Property(
        "String",
        "Blank",
        "Mechanics",
        "Curvature before bending that varies along the strip: stations = [0, 300], curvatures = [0, 0.01]",
    ),
    Property(
        "Enumeration",
        "Follow",
        "Nearest",
        "Follow the curve exactly, or the nearest one within limits",
        FOLLOW,
    ),
    Property(
        "Float",
        "MarginLimit",
        "Nearest",
        "Least stability margin. A strip is stable above 0, and safely stable from 5.",
        5.0,
    ),
    Property("Float", "StrainLimit", "Nearest", "Largest strain in percent; 0 for the limit of the sheet"),
    Property("Bool", "LimitMargin", "Nearest", "Apply the least stability margin", True),
    Property("Bool", "LimitStrain", "Nearest", "Apply the strain limit", True),
    Property("Length", "LeastLength", "Nearest", "Smallest length; applies together with the largest length"),
    Property("Length", "MostLength", "Nearest", "Largest length; 0 for no limits"),
    Property("Length", "MostWidth", "Nearest", "Largest width, which bounds the ratio; 0 for none"),
    Property("Enumeration", "KeepEnds", "Nearest", "Ends that keep their position", KEPT_ENDS),
    Property("Bool", "KeepTangents", "Nearest", "Keep the tangents of both ends"),
    Property("Enumeration", "TangentEnds", "Nearest", "Ends whose tangents are kept", TANGENT_ENDS),
    Property("Bool", "KeepLine", "Nearest", "Keep inflections on the curve's inflection line"),
    Property("FloatList", "InflectionLine", "Nearest", "Two points of another line: x, y, x, y"),
    Property("Length", "StartTab", "Ends", "Length of the tab at the start", TAB_LENGTH),
    Property("Length", "EndTab", "Ends", "Length of the tab at the end", TAB_LENGTH),
    Property("Length", "TabRadius", "Ends", "Rounding of the tabs' corners"),
    Property("Length", "TabHole", "Ends", "Diameter of a hole in the middle of each tab; 0 for none"),
    Property("String", "StartTabKeys", "Ends", "The first tab in full: length = 12, chamfer = 2"),
    Property("String", "EndTabKeys", "Ends", "The last tab in full"),
    Property("Integer", "Quantity", "Ends", "Number of copies to cut", 1),
    result("String", "Verdict", "Verdict on the strip and its curve"),
    result("StringList", "Reasons", "Reasons and remarks"),
    result("StringList", "Fails", "Results that make the strip fail", hidden=True),
    result("Float", "Ratio", "Largest stiffness over least stiffness", of=lambda strip: strip.rod.ratio),
    result("Float", "Margin", "Stability margin; positive means stable"),
    result("Length", "ConjugatePoint", "Place along the strip where stability is lost; 0 for a stable strip"),
    result(
        "Integer",
        "StrainUse",
        "Largest strain, in percent of the sheet's limit",
        of=lambda strip: strip.strain_verdict.percent,
    ),
    result(
        "Float",
        "LargestStrain",
        "Largest strain of the skin, in percent",
        of=lambda strip: 100 * strip.max_strain,
    ),
    result("Length", "Deviation", "Largest distance from the drawn curve"),
    result("Length", "HeldDeviation", "Largest deviation of the strip, as made and held, from its design"),
    result(
        "Length",
        "ExpectedDeviation",
        "Expected deviation of a real strip from its design, due to the model, its uncertainty and the sheet",
    ),
    result("String", "Held", "Deviation of the strip as made and held, with its causes"),
    result(
        "Float",
        "SidewaysMargin",
        "Sideways stability margin; positive means stable, 0 undecided",
        of=lambda strip: strip.sideways.margin if strip.sideways.decided else 0.0,
    ),
    result("String", "Sideways", "Sideways stability", of=lambda strip: str(strip.sideways)),
    result(
        "Length",
        "Length",
        "Length of the free part along the curve",
        of=lambda strip: strip.rod.length,
    ),
    result(
        "Length",
        "NarrowestWidth",
        "Width of the narrowest place",
        of=lambda strip: strip.width.extremes[0],
    ),
    result("Float", "Mass", "Mass in grams", of=lambda strip: strip.mass),
    result(
        "String",
        "MadeFrom",
        "Identifies the request from which the shape was made",
        hidden=True,
        transient=True,
    ),
    *(
        declared_property(field, _group(path), name, given=DEFAULTS.get(name), example=EXAMPLES.get(name, ""))
        for path, field, name in ((path, field, name_of(path)) for path, field in FIELDS.items())
    ),
)

NEAREST = tuple(
    entry
    for entry in PROPERTIES
    if (entry.group in ("Nearest", "Sheet") and entry.name != "Follow")
    or entry.name
    in (
        "Curve",
        "JoinGaps",
        "LeastWidth",
        "StartSupport",
        "EndSupport",
        "Gravity",
        "GravityDirection",
        "GravityLength",
        "NaturalCurvature",
        "Blank",
        "Ratio",
        "Deviation",
    )
)
"""Options and results of the nearest curve as a separate feature."""


# largest and smallest accepted length, mm; all foils are thicker than the smallest
LONGEST_MM, THINNEST_MM = 1e5, 1e-3
BLANK_LINE = "stations = [0, 300], curvatures = [0, 0.01]"
MASS_LINE, WEIGHT_LINE, TAB_LINE = "at = 90, mass = 3", "alpha = 1, own = true", "length = 12, chamfer = 2"
LENGTHS = tuple(p.name for p in PROPERTIES if p.kind == "Length" and not p.result)

SHEET, BACKING = "sheet", "backing"
"""Keys of the sheets in the table of a strip. The document stores the data of both sheets."""


def spec_of(obj: Any, drawn: DrawnCurve | None = None) -> StripSpec:
    """Return the `StripSpec` that the properties define. Properties without effect are ignored.

    `drawn` is the curve of the strip, if it has already been read.

    Raises
    ------
    InputError
        A size is far out of range: a typing error, or a wrong unit.
    """
    drawn = drawn or drawn_curve(obj.Curve, obj)
    _refuse_slips(obj, drawn)
    sheets = {SHEET: sheet_of(obj)}
    style, nearest, weight = style_of(obj), obj.Follow == "Nearest", obj.WeightLaw.strip()
    if style == "Laminated":
        sheets[BACKING] = sheet_called(obj.Backing, obj.BackingData)
    fields = {path: field for path, field in FIELDS.items() if _has_effect(obj, path, nearest=nearest)}
    values = {
        # a section replaces the default style, which is plain
        "style.kind": None if style == "Plain" else style.lower(),
        "style.backing": BACKING if style == "Laminated" else None,
        "max_width": None if style == "Plain" else obj.MaterialWidth.Value or None,
        "shop.least_ligament": obj.LeastLigament.Value if style == "Perforated" else None,
        # True for all effects, False for none, None for anticlastic bending only
        "compensate": None
        if obj.Law.strip() or (obj.Anticlastic and not obj.Compensate)
        else bool(obj.Compensate),
        "smooth": obj.Smooth.Value or (0.0 if obj.AsDrawn else None),
        "loads": parsed_line(weight, "WeightLaw", WEIGHT_LINE)
        if weight
        else _lines(obj.Loads, "Loads", MASS_LINE) or None,
        "ends": [_tab(obj, side) for side in ("Start", "End")],
    }
    table = _design_table(obj, drawn, fields, values | (_limits(obj) if nearest else {}))
    if before := obj.PlacesLength.Value:
        table = Table(table.data | scaled_places(table.data, drawn.curve.length / before), "", {})
    return read_request(table, Reader(sheets), drawn.curve, drawn.plane)


def nearest_spec_of(obj: Any, drawn: DrawnCurve) -> RodSpec:
    """Return the `RodSpec` for the nearest rod within limits, even if the strip follows the curve exactly."""
    limits = {path: field for path, field in FIELDS.items() if path.startswith(("limits.", "keep."))}
    table = _design_table(obj, drawn, limits, _limits(obj))
    fields = read_fields(table, Reader({SHEET: sheet_of(obj)}))
    gravity, _ = pull_in_plane(fields.get("gravity"), sheet_of(obj), drawn.plane)
    return RodSpec(
        drawn.curve, gravity, fields.get("supports", Supports()), fields.get("natural_curvature", 0.0),
        limits=fields["limits"], keep=fields["keep"],
    )  # fmt: skip


Acting: TypeAlias = Element | PointForce | PointMass


def is_load(item: Acting) -> bool:
    """Return True for a load, False for a rail, pin or tie."""
    return not isinstance(item, Element)


def keys_of(item: Acting) -> tuple[str, ...]:
    """Return the names of the fields that contain positions."""
    return ("start", "end") if isinstance(item, Tie) else ("at",)


def places_of(item: Acting) -> list[Any]:
    """Return the positions of a rail, pin, tie or load: mm along the curve, or points (x, y)."""
    return [getattr(item, key) for key in keys_of(item)]


def acting_lines(items: Iterable[Acting]) -> dict[str, list[str]]:
    """Return the values of the properties Between and Loads: a line for each rail, pin, tie or load."""
    lines: dict[str, list[str]] = {"Between": [], "Loads": []}
    for item in items:
        kind = word_of(type(item))
        table = {} if kind in (None, "rail") else {"kind": kind}
        fields = {field.name: field.default for field in declared(type(item))}
        table |= {name: getattr(item, name) for name, usual in fields.items() if getattr(item, name) != usual}
        lines["Loads" if is_load(item) else "Between"].append(_line(table))
    return lines


def _line(table: Mapping[str, Any]) -> str:
    return ", ".join(toml_text(table).splitlines())


def keep_fractions(obj: Any, drawn: DrawnCurve) -> None:
    """Scale the positions of ties and loads with the length of the curve."""
    length, before = drawn.curve.length, obj.PlacesLength.Value
    if before == length:
        return
    if before:
        for key, name in (("between", "Between"), ("loads", "Loads")):
            tables = _lines(getattr(obj, name), name, EXAMPLES.get(name, MASS_LINE))
            setattr(obj, name, [_line(table) for table in scaled_places({key: tables}, length / before)[key]])
    obj.PlacesLength = length


def acting_words(item: Acting, places: Sequence[float]) -> str:
    """Describe a rail, pin, tie or load in words. `places` are its positions, mm along the curve."""
    at = {"at": Length(places[0])}
    match item:
        case Rail(one_sided=True):
            return note("Rail at {at:.4g}", **at)
        case Rail():
            return note("Slot at {at:.4g}", **at)
        case Pin():
            return note("Pin at {at:.4g}", **at)
        case Tie():
            return note("Tie from {at:.4g} to {end:.4g}", **at, end=Length(places[1]))
        case PointForce(force=(x, y)):
            return note("Force at {at:.4g}: {x:.3g} along x, {y:.3g} along y", **at, x=Force(x), y=Force(y))
        case _:
            return note("Mass at {at:.4g}: {mass:.4g}", **at, mass=Mass(item.mass))


def _design_table(
    obj: Any, drawn: DrawnCurve, fields: Mapping[str, Field], further: Mapping[str, Any]
) -> Table:
    """Return the table of a design file. `further` has computed values by path."""
    table: dict[str, Any] = {}
    values = {
        "sheet": SHEET,
        "supports": [obj.StartSupport, obj.EndSupport],
        "natural_curvature": parsed_line(obj.Blank, "Blank", BLANK_LINE)
        if obj.Blank.strip()
        else obj.NaturalCurvature or None,
        "gravity": _gravity(obj, drawn),
    }
    single = ((path, value_of_field(obj, name_of(path), field)) for path, field in fields.items())
    for path, value in (*single, *values.items(), *further.items()):
        if value is not None:
            put(table, path, list(value) if isinstance(value, tuple) else value)
    return Table(table, "", {})


def style_of(obj: Any) -> str:
    """Return the style of a strip. A section has no other style than "Plain"."""
    return "Plain" if obj.Law.strip() else str(obj.Style)


def _has_effect(obj: Any, path: str, *, nearest: bool) -> bool:
    table, _, key = path.rpartition(".")
    if table == "style":
        return key in names_of(BY_KIND[Style][style_of(obj).lower()])
    if table in ("limits", "keep"):
        return nearest
    if obj.Law.strip() and path in FIELDS["section"].option.replaces:
        return False
    if path == "max_width":
        return bool(obj.Style == "Plain")
    return path != "samples" or not nearest


def show_idle(obj: Any) -> None:
    """Make the properties read-only that have no effect beside the present values of others, such as Style."""
    nearest, with_section = obj.Follow == "Nearest", bool(obj.Law.strip())
    idle = {name_of(path) for path in FIELDS if not _has_effect(obj, path, nearest=nearest)}
    if not nearest:
        idle |= {entry.name for entry in PROPERTIES if entry.group == "Nearest" and entry.name != "Follow"}
    if with_section:
        idle |= {"Compensate", "Anticlastic", "Style"}
    if style_of(obj) == "Plain":
        idle.add("MaterialWidth")
    if style_of(obj) != "Laminated":
        idle.add("Backing")
    if not obj.Gravity:
        idle |= {"GravityDirection", "GravityLength"}
    if obj.Blank.strip():
        idle.add("NaturalCurvature")
    for entry in PROPERTIES:
        if not (entry.result or entry.hidden):
            obj.setEditorMode(entry.name, int(entry.name in idle))


def value_of_field(obj: Any, name: str, field: Field) -> Any:
    """Return the value of a property as in a design file, or None if the property is not set."""
    value = getattr(obj, name)
    value = getattr(value, "Value", value)
    if field.option.unit == "rad":
        value = math.radians(value)
    if field.kind.name == "list" and field.kind.of[0].name != "number":
        return _lines(value, name, EXAMPLES.get(name, "")) or None
    if field.kind.name in ("table", "list", "either"):
        return (
            parsed_line(value, name, EXAMPLES.get(name, "")) if isinstance(value, str) else list(value)
        ) or None
    return None if field.default is None and value in (0, NOTHING) and value is not False else value


def _lines(lines: Iterable[str], name: str, example: str) -> list[dict[str, Any]]:
    return [parsed_line(line, name, example) for line in lines if line.strip()]


def _refuse_slips(obj: Any, drawn: DrawnCurve) -> None:
    require_choices(obj, PROPERTIES)
    lengths = {FieldName(name): getattr(obj, name).Value for name in LENGTHS}
    for name, value in (lengths | {note("the length of the curve"): drawn.curve.length}).items():
        if value > LONGEST_MM:
            raise InputError(
                "{name} is {size}, more than a hundred metres. Check its unit.",
                name=name,
                size=Length(value),
            )
    if 0 < lengths["Thickness"] < THINNEST_MM:
        raise InputError(
            "The thickness of the sheet is {thickness}, less than any foil. Check its unit.",
            thickness=Length(lengths["Thickness"]),
        )


def sheet_of(obj: Any) -> Sheet:
    """Return the sheet with the measured thickness.

    If this is not the nominal thickness, the result has no `thickness_range`.
    """
    sheet, thickness = sheet_called(obj.Sheet, obj.SheetData), obj.Thickness.Value
    if sheet.thickness == thickness:
        return sheet
    return replace(sheet, thickness=thickness, thickness_range=None)


def _gravity(obj: Any, drawn: DrawnCurve) -> Any:
    if not obj.Gravity:
        return None
    direction = list(obj.GravityDirection)
    if not any(direction):
        raise InputError("the direction of gravity is zero: give a vector such as (0, 0, -1)")
    if not obj.GravityLength.Value:
        return direction
    felt = Gravity.in_plane(obj.GravityLength.Value, direction, drawn.plane.x_axis, drawn.plane.y_axis)
    return None if felt is None else {"length": felt.length, "direction": list(felt.direction)}


def _limits(obj: Any) -> dict[str, Any]:
    line = list(obj.InflectionLine)
    return {
        "limits.margin": obj.MarginLimit if obj.LimitMargin else None,
        "limits.strain": (obj.StrainLimit / 100 or True) if obj.LimitStrain else None,
        "limits.length": _range(obj, "Length"),
        "limits.width": _range(obj, "Width"),
        "keep.ends": BOTH_ENDS[obj.KeepEnds],
        "keep.tangents": BOTH_ENDS[obj.TangentEnds] if obj.KeepTangents else False,
        "keep.line": [line[:2], line[2:]] if line else obj.KeepLine or None,
    }


def _range(obj: Any, kind: str) -> list[float] | None:
    least, most = getattr(obj, f"Least{kind}").Value, getattr(obj, f"Most{kind}").Value
    if not most:
        return None
    if not 0 < least <= most:
        raise InputError(
            "{low} is {least:g} and {high} is {most:g}. Set both: {low} above 0 and at most {high}.",
            low=FieldName(f"Least{kind}"),
            high=FieldName(f"Most{kind}"),
            least=Length(least),
            most=Length(most),
        )
    return [least, most]


def _tab(obj: Any, side: str) -> dict[str, Any]:
    keys, length = getattr(obj, f"{side}TabKeys"), getattr(obj, f"{side}Tab").Value
    hole = obj.TabHole.Value
    if keys.strip():
        return parsed_line(keys, f"{side}TabKeys", TAB_LINE)
    if not length:
        return {"length": 0.0}
    holes = {"holes": [{"at": length / 2, "diameter": hole}]} if hole else {}
    return {"length": length, "corner_radius": obj.TabRadius.Value, **holes}
