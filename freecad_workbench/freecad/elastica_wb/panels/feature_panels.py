# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Definitions of the panels of all features."""

from collections.abc import Callable, Iterable
from typing import Any

from freecad.elastica_wb.curves.plane_sections import FAMILIES
from freecad.elastica_wb.features.baseplate import BasePlateFeature, RingsFeature
from freecad.elastica_wb.features.curves import (
    NearestFeature,
    SectionFeature,
    draw_into,
    nearest_sketch,
    section_sketches_of,
)
from freecad.elastica_wb.features.fixtures import FixturesFeature
from freecad.elastica_wb.features.flat import FlatFeature
from freecad.elastica_wb.features.flexure import FlexureFeature, flexure_of
from freecad.elastica_wb.features.model import ModelFeature
from freecad.elastica_wb.features.nest import NestFeature
from freecad.elastica_wb.features.strip import shown_strip, suggestions
from freecad.elastica_wb.features.strip_properties import PROPERTIES
from freecad.elastica_wb.host.charts import line_chart
from freecad.elastica_wb.host.objects import feature_kind
from freecad.elastica_wb.host.resources import QT_TRANSLATE_NOOP, translate
from freecad.elastica_wb.host.words import shown_unit, worded
from freecad.elastica_wb.panels.bend import BendPanel
from freecad.elastica_wb.panels.panel import Panel
from freecad.elastica_wb.panels.property_panel import Layout, PropertyPanel
from freecad.elastica_wb.solving.verdicts import pre_bend_messages
from freecad.elastica_wb.strip_report import strip_rows

from elastica_cad.errors import Length, note
from elastica_cad.pairs.flexure import Flexure
from elastica_cad.pairs.summary import pair_rows
from elastica_cad.report_rows import Row


def _has_value(name: str, *values: object) -> Callable[[Any], bool]:
    return lambda obj: getattr(obj, name) in values


def _has_tabs(obj: Any) -> bool:
    return bool(obj.StartTab.Value or obj.EndTab.Value)


def _force_chart(part: Flexure) -> Any:
    travel, size, name = part.travel, 1.0, note("rotation of the end (degrees)")
    if travel.unit == "mm":
        unit = shown_unit()
        size, name = unit.size, note("travel ({unit})", unit=unit.name)
    names, snap = (
        (worded(name), worded(note("force (N)"))),
        None if travel.snap is None else travel.snap / size,
    )
    return line_chart((travel.travel / size).tolist(), travel.force.tolist(), names, snap)


LAYOUTS = {
    "Strip": Layout(
        QT_TRANSLATE_NOOP("Elastica", "Strip"),
        "Elastica_Strip",
        "Edit strip",
        {
            QT_TRANSLATE_NOOP("Elastica", "Sheet and width"): (
                "Sheet",
                "Thickness",
                "MaxWidth",
                "MinWidth",
                "Smooth",
                "AsDrawn",
                "Anyway",
            ),
            QT_TRANSLATE_NOOP("Elastica", "Style"): (
                "Style",
                "OuterWidth",
                "Columns",
                "Rows",
                "Backing",
                "Form",
            ),
            QT_TRANSLATE_NOOP("Elastica", "Nearest curve"): (
                "Follow",
                "RatioLimit",
                "MarginLimit",
                "StrainLimit",
                "KeepTangents",
                "KeepLength",
            ),
            QT_TRANSLATE_NOOP("Elastica", "Ends and weight"): (
                "StartSupport",
                "EndSupport",
                "Gravity",
                "StartTab",
                "EndTab",
                "TabRadius",
                "TabHole",
                "EngravedText",
                "Quantity",
            ),
        },
        PROPERTIES,
        {
            "AsDrawn": lambda obj: not obj.Smooth.Value,
            "TabRadius": _has_tabs,
            "TabHole": _has_tabs,
        },
        "Curve",
        strip_rows,
        suggestions=suggestions,
        footnote=lambda obj: obj.Held,
    ),
    "Model": Layout(
        QT_TRANSLATE_NOOP("Elastica", "Model"),
        "Elastica_Interlock",
        "Edit model",
        {QT_TRANSLATE_NOOP("Elastica", "Slots"): ("Interlock", "Clearance", "Fit", "Relief")},
        ModelFeature.properties,
        dict.fromkeys(("Clearance", "Fit", "Relief"), _has_value("Interlock", True)),
        results=lambda obj: (Row(translate("Elastica", "Joints"), str(obj.Joints), ("Joints",)),),
        footnote=lambda obj: "\n".join(obj.Overlaps),
    ),
    "Flat": Layout(
        QT_TRANSLATE_NOOP("Elastica", "Flat part"),
        "Elastica_Flat",
        "Edit flat part",
        {QT_TRANSLATE_NOOP("Elastica", "Flat part"): ("Layer",)},
        FlatFeature.properties,
        footnote=lambda obj: "\n".join(
            map(worded, pre_bend_messages([(obj.Strip.Label, shown_strip(obj.Strip))]))
        ),
    ),
    "Fixtures": Layout(
        QT_TRANSLATE_NOOP("Elastica", "End fixtures"),
        "Elastica_Fixtures",
        "Edit fixtures",
        {
            QT_TRANSLATE_NOOP("Elastica", "Printed blocks"): (
                "Clearance",
                "Wall",
                "Foot",
                "FootHeight",
                "Screw",
            )
        },
        FixturesFeature.properties,
        {name: lambda obj: bool(obj.Foot.Value) for name in ("FootHeight", "Screw")},
    ),
    "BasePlate": Layout(
        QT_TRANSLATE_NOOP("Elastica", "Base plate"),
        "Elastica_Fixtures",
        "Edit base plate",
        {QT_TRANSLATE_NOOP("Elastica", "Base plate"): ("Sheet", "Play", "Clearance", "Border", "Outline")},
        BasePlateFeature.properties,
    ),
    "Rings": Layout(
        QT_TRANSLATE_NOOP("Elastica", "Rings"),
        "Elastica_Fixtures",
        "Edit rings",
        {
            QT_TRANSLATE_NOOP("Elastica", "Rings"): (
                "Sheet",
                "Ends",
                "Gap",
                "Outline",
                "Play",
                "Clearance",
                "Border",
            )
        },
        RingsFeature.properties,
    ),
    "Nest": Layout(
        QT_TRANSLATE_NOOP("Elastica", "Nest on sheets"),
        "Elastica_Nest",
        "Edit nest",
        {QT_TRANSLATE_NOOP("Elastica", "Sheets"): ("SheetWidth", "SheetHeight", "Margin")},
        NestFeature.properties,
        results=lambda obj: (Row(translate("Elastica", "Sheets"), str(obj.Sheets), ("Sheets",)),),
        footnote=lambda obj: "\n".join(obj.LeftOut),
    ),
    "Nearest": Layout(
        QT_TRANSLATE_NOOP("Elastica", "Nearest curve"),
        "Elastica_Nearest",
        "Nearest curve to sketch",
        {
            QT_TRANSLATE_NOOP("Elastica", "Limits"): (
                "Sheet",
                "Thickness",
                "RatioLimit",
                "LimitMargin",
                "MarginLimit",
                "LimitStrain",
                "StrainLimit",
            ),
            QT_TRANSLATE_NOOP("Elastica", "Keep"): ("KeepEnds", "KeepTangents", "KeepLength", "KeepSymmetry"),
            QT_TRANSLATE_NOOP("Elastica", "Ends and weight"): ("StartSupport", "EndSupport", "Gravity"),
        },
        NearestFeature.properties,
        {"MarginLimit": lambda obj: obj.LimitMargin, "StrainLimit": lambda obj: obj.LimitStrain},
        "Curve",
        lambda obj: (
            Row(
                translate("Elastica", "Largest distance"),
                note("{far}", far=Length(obj.Deviation.Value)),
                ("Deviation",),
            ),
            Row(translate("Elastica", "Stiffness ratio"), note("{ratio:.3g}", ratio=obj.Ratio), ("Ratio",)),
        ),
        (
            (QT_TRANSLATE_NOOP("Elastica", "Draw it into the sketch"), draw_into),
            (QT_TRANSLATE_NOOP("Elastica", "Make a sketch to edit"), nearest_sketch),
        ),
    ),
    "Section": Layout(
        QT_TRANSLATE_NOOP("Elastica", "Section into curves"),
        "Elastica_Section",
        "Section into curves",
        {
            QT_TRANSLATE_NOOP("Elastica", "Planes"): (
                "Family",
                "Axis",
                "Count",
                "ThroughX",
                "ThroughY",
                "ThroughZ",
                "Sweep",
            ),
            QT_TRANSLATE_NOOP("Elastica", "Curves"): ("Closed", "Tolerance", "Waves"),
        },
        SectionFeature.properties,
        {
            "Axis": _has_value("Family", *FAMILIES[:2]),
            "Path": _has_value("Family", FAMILIES[2]),
            **dict.fromkeys(("ThroughX", "ThroughY", "ThroughZ", "Sweep"), _has_value("Family", FAMILIES[1])),
        },
        "Path",
        lambda obj: (Row(translate("Elastica", "Curves"), str(obj.Curves), ("Curves",)),),
        ((QT_TRANSLATE_NOOP("Elastica", "Make sketches to edit"), section_sketches_of),),
    ),
    "Flexure": Layout(
        QT_TRANSLATE_NOOP("Elastica", "Two-state part"),
        "Elastica_Flexure",
        "Two-state part",
        {
            QT_TRANSLATE_NOOP("Elastica", "Sheet"): ("Sheet", "Thickness", "Printed", "Form"),
            QT_TRANSLATE_NOOP("Elastica", "Curves"): ("Match", "Smooth", "Free", "Objective"),
            QT_TRANSLATE_NOOP("Elastica", "Part"): (
                "LeastThickness",
                "PushAt",
                "Fillet",
                "PadLength",
                "PadWidth",
                "PadHole",
                "PadInset",
                "Anyway",
                "EngravedText",
                "Quantity",
            ),
        },
        FlexureFeature.properties,
        results=lambda obj: pair_rows(flexure_of(obj)),
        picture=lambda obj: _force_chart(flexure_of(obj)),
    ),
}
"""Definition of the panel for each kind of feature."""


def panel_of(obj: Any, others: Iterable[Any] = ()) -> Panel:
    """Return the panel of a feature, which also edits the features `others` of the same kind."""
    if feature_kind(obj) == "Bent":
        return BendPanel(obj.Strip, obj)
    return PropertyPanel(obj, LAYOUTS[feature_kind(obj)], others)
