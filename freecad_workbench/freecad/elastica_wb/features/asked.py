"""What a strip is asked for: the table of its properties, and the wish that they make."""

from dataclasses import replace
from typing import Any

import FreeCAD as App
from freecad.elastica_wb.design import StyleChoice, Wish
from freecad.elastica_wb.drawn import DrawnCurve, frame_of
from freecad.elastica_wb.features.properties import Property
from freecad.elastica_wb.library import sheet_called

from elastica_cad.errors import InputError
from elastica_cad.fabrication import Hole, Tab
from elastica_cad.mechanics import Gravity, Sheet, Supports

__all__ = ["FORMS", "PROPERTIES", "wish_of"]

FORMS = ["Bent", "Flat"]
STYLES = ["Plain", "Perforated", "Laminated"]
FOLLOW = ["Exactly", "Nearest"]
ENDS = ["clamped", "pinned", "slide-x", "slide-y", "guided", "free"]

LONGEST, THINNEST = 1e6, 1e-3  # mm
MOST_SAMPLES = 20000  # a second's work

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
    Property("Enumeration", "Style", "Style", "How stiffness becomes material", STYLES),
    Property("Length", "OuterWidth", "Style", "Width of the outline, perforated or laminated", 30.0),
    Property("Integer", "Columns", "Style", "Holes side by side in a perforated strip", 2),
    Property("Integer", "Rows", "Style", "Holes one after the other; 0 chooses", 0),
    Property("Enumeration", "Backing", "Style", "Sheet that is glued on in a laminated strip"),
    Property("String", "BackingData", "Style", "The backing's numbers", "", hidden=True),
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


def wish_of(obj: Any, drawn: DrawnCurve) -> Wish:
    """What the properties ask for.

    Raises
    ------
    InputError
        Numbers that no strip has: a slip of the keyboard, or another unit.
    """
    _sensible(obj, drawn)
    sheet = _measured(sheet_called(obj.Sheet, obj.SheetData), obj.Thickness.Value)
    return Wish(
        sheet=sheet,
        max_width=obj.MaxWidth.Value or None if obj.Style == "Plain" else None,
        min_width=obj.MinWidth.Value or None,
        style=_style(obj),
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


def _sensible(obj: Any, drawn: DrawnCurve) -> None:
    lengths = {p.name: getattr(obj, p.name).Value for p in PROPERTIES if p.kind == "Length" and not p.result}
    for name, value in (lengths | {"the length of the curve": drawn.curve.length}).items():
        if value > LONGEST:
            raise InputError(f"{name} is {value:.4g} mm, more than a kilometre: is its unit right?")
    if 0 < lengths["Thickness"] < THINNEST:
        raise InputError(
            f"the thickness of the sheet is {lengths['Thickness']:.4g} mm, less than any foil's: is its unit right?"
        )
    if obj.Samples > MOST_SAMPLES:
        raise InputError(f"{obj.Samples} samples are asked for: {MOST_SAMPLES} are the most, 0 chooses")


def _style(obj: Any) -> StyleChoice:
    if obj.Style == "Perforated":
        return StyleChoice("Perforated", obj.OuterWidth.Value, obj.Columns, obj.Rows or None)
    if obj.Style == "Laminated":
        return StyleChoice(
            "Laminated", obj.OuterWidth.Value, backing=sheet_called(obj.Backing, obj.BackingData)
        )
    return StyleChoice()


def _measured(sheet: Sheet, thickness: float) -> Sheet:
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
