# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""The table of a strip's options and results.

Most properties are made from the declared fields of a strip. Properties that do not match one field are declared
here.
"""

from collections.abc import Iterator

import FreeCAD as App
from freecad.elastica_wb.features.proxy import CONTAINERS
from freecad.elastica_wb.host.property_names import name_of
from freecad.elastica_wb.host.property_table import Property, declared_property, result

from elastica_cad.declared import Field, declared
from elastica_cad.defaults import MAX_WIDTH, RATIO, TAB_LENGTH
from elastica_cad.design.records import paths_of
from elastica_cad.design.strip_table import StripKeys

FORMS = ["Bent", "Flat"]
STYLES = ["Plain", "Perforated", "Laminated"]
FOLLOW = ["Exactly", "Nearest"]
ENDS = ["clamped", "pinned", "slide-x", "slide-y", "guided", "free"]
KEPT_ENDS = ["both", "start", "end", "none"]
TANGENT_ENDS = KEPT_ENDS[:3]

DEFAULTS = {"MaxWidth": MAX_WIDTH, "OuterWidth": MAX_WIDTH, "RatioLimit": RATIO}
"""Defaults of a new strip that differ from those of the fields."""

EXAMPLES = {
    "Law": 'kind = "thickness", limits = [3, 8], width = 20',
    "Slots": "at = 40, width = 1.2, side = 'lower'",
    "KeepOut": "point = [0, 0], normal = [0, 1]",
    "StiffnessBounds": "lower = 1, upper = [2, 3, 2]",
}
"""Examples for the lines of properties that hold tables, written as in a design file."""

OWN_BOXES = (
    "curve", "engrave", "sheet", "style", "compensate", "gravity", "loads", "supports", "natural_curvature", "ends",
    "limits.margin", "limits.strain", "limits.length", "limits.width", "keep.ends", "keep.tangents", "keep.line",
)  # fmt: skip
"""Keys that do not match a single property. `strip_request` reads them."""

OWN_TABLES = ("style", "limits", "keep")
"""Keys whose subkeys have properties."""

GROUPS = {"style": "Style", "limits": "Nearest", "keep": "Nearest", "curve": "Curve", "sheet": "Sheet",
          "widths": "Width", "ends": "Ends", "weight": "Mechanics"}  # fmt: skip


def _property_of(path: str, field: Field) -> Property:
    """Return the property of a key with a single value."""
    name = name_of(path)
    return declared_property(
        field, _group(path), name, given=DEFAULTS.get(name), example=EXAMPLES.get(name, "")
    )


def _group(path: str) -> str:
    table = path.partition(".")[0]
    return GROUPS.get(table) or GROUPS.get(paths_of(StripKeys)[table].asked.group, "Strip")


def _one_to_one() -> Iterator[tuple[str, Field]]:
    known, of_files = paths_of(StripKeys), {declared_field.name for declared_field in declared(StripKeys)}
    for path, field in known.items():
        table, _, key = path.rpartition(".")
        if path in OWN_BOXES or key in ("kind", "backing") or (table and table not in OWN_TABLES):
            continue
        if table or path not in (*OWN_TABLES, "shop", *of_files):
            yield path, field
    yield "shop.least_width", known["shop.least_width"]


FIELDS = dict(_one_to_one())
"""Fields of the keys that match a single property, by their paths."""

PROPERTIES = (
    Property("LinkSubGlobal", "Curve", "Curve", "Sketch, or edges of an object, that the strip follows"),
    Property("Enumeration", "Form", "Curve", "What the shape is: the strip as bent, or as cut", FORMS),
    Property("Enumeration", "Sheet", "Sheet", "Material the strip is cut from"),
    Property("Length", "Thickness", "Sheet", "Thickness of the sheet; measure yours", 1.0),
    Property(
        "String", "SheetData", "Sheet", "The sheet's numbers, so that the file opens anywhere", hidden=True
    ),
    Property("Bool", "Compensate", "Width", "Make up for slots, narrow tabs and holes in the widths"),
    Property(
        "Bool",
        "Anticlastic",
        "Width",
        "Make up for anticlastic bending in the widths, where the sheet's Poisson ratio is known",
        # off in files of earlier versions, so that their widths stay the same
    ),
    Property(
        "Length", "MaterialWidth", "Style", "Most of ligaments or backing, summed across; 0 for what fits"
    ),
    Property("Enumeration", "Style", "Style", "How stiffness becomes material", STYLES),
    Property("Enumeration", "Backing", "Style", "Sheet that is glued on in a laminated strip"),
    Property("String", "BackingData", "Style", "The backing's numbers", hidden=True),
    Property("Enumeration", "StartSupport", "Mechanics", "What holds the start of the curve", ENDS),
    Property("Enumeration", "EndSupport", "Mechanics", "What holds the end of the curve", ENDS),
    Property("Bool", "Gravity", "Mechanics", "Does the strip carry its own weight?"),
    Property(
        "Vector",
        "GravityDirection",
        "Mechanics",
        "Direction in space in which things fall",
        App.Vector(0, 0, -1),
    ),
    Property("Length", "GravityLength", "Mechanics", "Elasto-gravity length; 0 takes the sheet's"),
    Property("StringList", "Loads", "Mechanics", "Masses hung on the strip: at = 90, mass = 3 (mm, g)"),
    Property("String", "WeightLaw", "Mechanics", "All weight in newtons: alpha = 0.001, own = true"),
    Property("Float", "NaturalCurvature", "Mechanics", "Curvature of the strip before bending, 1/mm"),
    Property(
        "String",
        "Blank",
        "Mechanics",
        "Instead of it along the strip: stations = [0, 300], curvatures = [0, 0.01]",
    ),
    Property(
        "Enumeration",
        "Follow",
        "Nearest",
        "Follow the curve exactly, or the nearest one within limits",
        FOLLOW,
    ),
    Property("Float", "MarginLimit", "Nearest", "Least stability margin; 5 is safely stable", 5.0),
    Property("Float", "StrainLimit", "Nearest", "Largest strain in percent; 0 takes the sheet's"),
    Property("Bool", "LimitMargin", "Nearest", "Does MarginLimit count?", True),
    Property("Bool", "LimitStrain", "Nearest", "Does the strain limit count?", True),
    Property("Length", "LeastLength", "Nearest", "Least length; counts with MostLength"),
    Property("Length", "MostLength", "Nearest", "Largest length; 0 for no limits"),
    Property("Length", "MostWidth", "Nearest", "Largest width, which bounds the ratio; 0 for none"),
    Property("Enumeration", "KeepEnds", "Nearest", "Which ends stay where they are", KEPT_ENDS),
    Property("Bool", "KeepTangents", "Nearest", "Keep the tangents of both ends"),
    Property("Enumeration", "TangentEnds", "Nearest", "Whose tangents KeepTangents keeps", TANGENT_ENDS),
    Property("Bool", "KeepLine", "Nearest", "Keep inflections on the curve's inflection line"),
    Property("FloatList", "InflectionLine", "Nearest", "Two points of another line: x, y, x, y"),
    Property("Length", "StartTab", "Ends", "Length of the tab at the start", TAB_LENGTH),
    Property("Length", "EndTab", "Ends", "Length of the tab at the end", TAB_LENGTH),
    Property("Length", "TabRadius", "Ends", "Rounding of the tabs' corners"),
    Property("Length", "TabHole", "Ends", "Diameter of a hole in the middle of each tab; 0 for none"),
    Property("String", "StartTabKeys", "Ends", "The first tab in full: length = 12, chamfer = 2"),
    Property("String", "EndTabKeys", "Ends", "The last tab in full"),
    Property("Integer", "Quantity", "Ends", "How many of it are cut", 1),
    result("String", "Verdict", "Can a flat strip take the curve?"),
    result("StringList", "Reasons", "Why not, and what else to know"),
    result("StringList", "Fails", "Results that make the strip fail", hidden=True),
    result("Float", "Ratio", "Largest stiffness over least stiffness"),
    result("Float", "Margin", "Stability margin; positive means that it stays"),
    result("Length", "ConjugatePoint", "Where along the strip stability is lost; 0 where it is not"),
    result("Integer", "StrainUse", "Largest strain, in percent of what the sheet bears"),
    result("Float", "LargestStrain", "Largest strain of the skin, in percent"),
    result("Length", "Deviation", "Largest distance from the drawn curve"),
    result(
        "Length", "HeldDeviation", "Largest distance of the strip, as it is made and held, from its design"
    ),
    result(
        "Length",
        "ExpectedDeviation",
        "How far a real strip strays from its design, by the model, what that leaves open, and its sheet",
    ),
    result("String", "Held", "How it strays as made and held, and by what"),
    result(
        "Float",
        "SidewaysMargin",
        "Margin against tipping over sideways, positive where it stays in its plane; 0 where undecided",
    ),
    result("String", "Sideways", "Does it stay in the plane of its curve?"),
    result("Length", "Length", "Length of the free part along the curve"),
    result("Length", "NarrowestWidth", "Width of the narrowest place"),
    result("Float", "Mass", "Mass in grams"),
    result(
        "String", "MadeFrom", "Tells the request that the shape was made from", hidden=True, transient=True
    ),
    CONTAINERS,
    *(_property_of(*one) for one in FIELDS.items()),
)

NEAREST = tuple(
    entry
    for entry in PROPERTIES
    if (entry.group in ("Nearest", "Sheet") and entry.name != "Follow")
    or entry.name
    in (
        "Curve",
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
        CONTAINERS.name,
    )
)
"""Options and results of a separate nearest curve."""
