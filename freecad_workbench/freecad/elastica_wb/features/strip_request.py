# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""What the properties of a strip ask for, as the core's request."""

from dataclasses import replace
from typing import Any

from freecad.elastica_wb.curves.sketch_curves import DrawnCurve
from freecad.elastica_wb.features.strip_properties import PROPERTIES
from freecad.elastica_wb.host.property_table import require_choices
from freecad.elastica_wb.host.sheet_store import sheet_called

from elastica_cad.errors import InputError
from elastica_cad.fabrication.makeability.shop import LEAST_LIGAMENT_MM, Shop
from elastica_cad.fabrication.slots.slot import Slot
from elastica_cad.fabrication.strip.lamination import Laminated
from elastica_cad.fabrication.strip.outline import Hole, Tab
from elastica_cad.fabrication.strip.perforation import Perforated
from elastica_cad.fabrication.strip.styles import PLAIN, Style
from elastica_cad.fabrication.strip_checks import AskedGravity
from elastica_cad.fabrication.strip_spec import StripSpec
from elastica_cad.formats.design_files.records import Reader, blank, read_line
from elastica_cad.forming.limits import BOTH_ENDS, Box, HalfPlane, Keep, Limits, bounds_along_strip
from elastica_cad.forming.rod_spec import RodSpec
from elastica_cad.mechanics.loads.gravity import Gravity
from elastica_cad.mechanics.loads.rest_curvature import NaturalCurvature
from elastica_cad.mechanics.loads.supports import Supports
from elastica_cad.mechanics.loads.weight import PointMass, Weight
from elastica_cad.mechanics.material.sheet import Sheet
from elastica_cad.mechanics.material.stiffness_law import BoundedLaw
from elastica_cad.refusals import Length, note

LONGEST_MM, THINNEST_MM = 1e6, 1e-3  # a kilometre; thinner than any foil
MOST_SAMPLES = 20000  # a second's work
LAW_LINE, BLANK_LINE = (
    'kind = "thickness", limits = [3, 8], width = 20',
    "stations = [0, 300], curvatures = [0, 0.01]",
)
MASS_LINE, WEIGHT_LINE = "at = 90, mass = 3", "alpha = 1, own = true"
KEEP_OUT_LINE, BOUNDS_LINE = "point = [0, 0], normal = [0, 1]", "lower = 1, upper = [2, 3, 2]"
TAB_LINE = "length = 12, chamfer = 2"
LENGTHS = tuple(p.name for p in PROPERTIES if p.kind == "Length" and not p.result)


def spec_of(obj: Any, drawn: DrawnCurve) -> StripSpec:
    """What the properties ask for; what belongs to another style, or to the nearest curve only, is left out.

    Raises
    ------
    InputError
        Numbers that no strip has: a slip of the keyboard, or another unit.
    """
    _refuse_slips(obj, drawn)
    sheet, nearest = _sheet(obj), obj.Follow == "Nearest"
    backing = sheet_called(obj.Backing, obj.BackingData) if obj.Style == "Laminated" else None
    width = obj.MaxWidth.Value if obj.Style == "Plain" else obj.MaterialWidth.Value
    law = None
    if obj.Law.strip():
        law = read_line(obj.Law, "Law", BoundedLaw, Reader(sheet=sheet), example=LAW_LINE)
    return StripSpec(
        drawn.curve,
        sheet,
        drawn.plane,
        max_width=width or None if law is None else None,  # a law has its own limits
        min_width=obj.MinWidth.Value or None if law is None else None,
        style=_style(obj, backing),
        limits=_limits(obj, sheet) if nearest else None,
        keep=_keep(obj) if nearest else None,
        gravity=_gravity(obj, drawn),
        loads=_loads(obj),
        supports=Supports(obj.StartSupport, obj.EndSupport),
        natural_curvature=_natural_curvature(obj),
        samples=None if nearest else obj.Samples or None,
        ends=_ends(obj),
        joint=obj.Joint.Value or None,
        slots=_lines(obj.Slots, "Slots", Slot),
        label=obj.EngravedText,
        smooth=obj.Smooth.Value or None,
        shop=_shop(obj),
        compensate=True if obj.Compensate else None if obj.Anticlastic else False,
        creep=obj.Creep,
        law=law,
        ignore_limits=obj.Anyway,
    )


def nearest_spec_of(obj: Any, drawn: DrawnCurve) -> RodSpec:
    """The rod nearest to the curve within the limits, also where the strip is to follow its curve exactly."""
    sheet, supports = _sheet(obj), Supports(obj.StartSupport, obj.EndSupport)
    plain = StripSpec(drawn.curve, sheet, drawn.plane, max_width=1.0, gravity=_gravity(obj, drawn))
    return RodSpec(
        drawn.curve, plain.gravity_in_plane, supports, _natural_curvature(obj),
        limits=_limits(obj, sheet), keep=_keep(obj),
    )  # fmt: skip


def _refuse_slips(obj: Any, drawn: DrawnCurve) -> None:
    require_choices(obj, PROPERTIES)
    lengths = {name: getattr(obj, name).Value for name in LENGTHS}
    for name, value in (lengths | {"the length of the curve": drawn.curve.length}).items():
        if value > LONGEST_MM:
            raise InputError(
                "{name} is {size}, more than a kilometre: is its unit right?",
                name=note(name),
                size=Length(value),
            )
    if 0 < lengths["Thickness"] < THINNEST_MM:
        raise InputError(
            "the thickness of the sheet is {thickness}, less than any foil's: is its unit right?",
            thickness=Length(lengths["Thickness"]),
        )
    if obj.Samples > MOST_SAMPLES:
        raise InputError(
            "{samples} samples are asked for: {most} are the most, 0 chooses",
            samples=obj.Samples,
            most=MOST_SAMPLES,
        )


def _sheet(obj: Any) -> Sheet:
    """The sheet as measured; its range is of another sheet then, and is left out."""
    sheet, thickness = sheet_called(obj.Sheet, obj.SheetData), obj.Thickness.Value
    if sheet.thickness == thickness:
        return sheet
    return replace(sheet, thickness=thickness, thickness_range=None)


def _shop(obj: Any) -> Shop:
    """Limits of the workshop; ligaments are as fine as the style is told to make them."""
    ligament = obj.LeastLigament.Value if obj.Style == "Perforated" else LEAST_LIGAMENT_MM
    return Shop(least_width=obj.LeastWidth.Value or None, least_ligament=ligament)


def _style(obj: Any, backing: Sheet | None) -> Style:
    if obj.Style == "Perforated":
        return Perforated(
            width=obj.OuterWidth.Value,
            columns=obj.Columns,
            rows=obj.Rows or None,
            hole_ratio=obj.HoleRatio,
            least_ligament=obj.LeastLigament.Value,
            least_hole=obj.LeastHole.Value,
            corner_radius=obj.HoleRadius.Value,
            sides=obj.HoleSides,
        )
    if backing is not None:
        return Laminated(
            width=obj.OuterWidth.Value,
            backing=backing,
            least_backing=obj.LeastBacking.Value,
            dots=obj.Dots.Value,
        )
    return PLAIN


def _gravity(obj: Any, drawn: DrawnCurve) -> AskedGravity:
    """Where the strip's weight falls in space."""
    if not obj.Gravity:
        return None
    direction = tuple(obj.GravityDirection)
    if not any(direction):
        raise InputError("the direction of gravity is zero: give a vector such as (0, 0, -1)")
    if not obj.GravityLength.Value:
        return direction
    return Gravity.in_plane(obj.GravityLength.Value, direction, drawn.plane.x_axis, drawn.plane.y_axis)


def _natural_curvature(obj: Any) -> NaturalCurvature:
    if obj.Blank.strip():
        return read_line(obj.Blank, "Blank", blank, example=BLANK_LINE)
    curvature: float = obj.NaturalCurvature
    return curvature


def _loads(obj: Any) -> tuple[PointMass, ...] | Weight:
    if obj.WeightLaw:
        return read_line(obj.WeightLaw, "WeightLaw", Weight, example=WEIGHT_LINE)
    return _lines(obj.Loads, "Loads", PointMass, example=MASS_LINE)


def _limits(obj: Any, sheet: Sheet) -> Limits:
    bounds = obj.StiffnessBounds
    return Limits(
        ratio=obj.RatioLimit or None,
        margin=obj.MarginLimit if obj.LimitMargin else None,
        curvature=obj.CurvatureLimit or None,
        sheet=sheet if obj.LimitStrain else None,
        strain=obj.StrainLimit / 100 or None if obj.LimitStrain else None,
        length=_range(obj, "Length"),
        width=_range(obj, "Width"),
        keep_out=_walls(obj.KeepOut),
        stiffness_bounds=read_line(bounds, "StiffnessBounds", bounds_along_strip, example=BOUNDS_LINE)
        if bounds
        else None,
    )


def _range(obj: Any, kind: str) -> tuple[float, float] | None:
    """Least and most, mm; none where there is no most."""
    least, most = getattr(obj, f"Least{kind}").Value, getattr(obj, f"Most{kind}").Value
    if not most:
        return None
    if not 0 < least <= most:
        raise InputError(
            "Least{name} is {least:g} and Most{name} is {most:g}: give both, the least above 0 "
            "and not above the most",
            name=kind,
            least=Length(least),
            most=Length(most),
        )
    return least, most


def _keep(obj: Any) -> Keep:
    line = tuple(obj.InflectionLine)
    return Keep(
        ends=BOTH_ENDS[obj.KeepEnds],
        tangents=BOTH_ENDS[obj.TangentEnds] if obj.KeepTangents else False,
        length=obj.KeepLength,
        symmetry=None if obj.KeepSymmetry == "none" else obj.KeepSymmetry,
        points=tuple(obj.KeepPoints),
        line=(line[:2], line[2:]) if line else obj.KeepLine or None,
    )


def _ends(obj: Any) -> tuple[Tab, Tab]:
    tabs = []
    for side in ("Start", "End"):
        keys = getattr(obj, f"{side}TabKeys")
        length = getattr(obj, f"{side}Tab").Value
        tabs.append(read_line(keys, f"{side}TabKeys", Tab, example=TAB_LINE) if keys else _tab(obj, length))
    return tabs[0], tabs[1]


def _tab(obj: Any, length: float) -> Tab:
    hole = obj.TabHole.Value
    holes = (Hole(length / 2, hole),) if hole and length else ()
    return Tab(length, corner_radius=obj.TabRadius.Value if length else 0.0, holes=holes)


def _lines(lines: list[str], where: str, record: Any, *, example: str = "") -> tuple[Any, ...]:
    """The records of all lines that are not empty."""
    return tuple(read_line(line, where, record, example=example) for line in lines if line.strip())


def _walls(lines: list[str]) -> tuple[HalfPlane | Box, ...]:
    kept = (line for line in lines if line.strip())
    return tuple(
        read_line(line, "KeepOut", Box if "lower" in line else HalfPlane, example=KEEP_OUT_LINE)
        for line in kept
    )
