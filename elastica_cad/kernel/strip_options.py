"""Typed options for the CAD libraries, generated from the fields of `StripSpec` by `make generate`."""

from typing import TYPE_CHECKING, Annotated, Any, TypedDict

if TYPE_CHECKING:
    from collections.abc import Sequence

    from elastica_cad.form_finding.limits import Keep, Limits
    from elastica_cad.kernel.strip_body import Point
    from elastica_cad.mechanics.cross_sections import Section
    from elastica_cad.mechanics.elements import Pin, PointForce, Rail, Tie
    from elastica_cad.mechanics.loads import Gravity, PointMass, RestCurvature, Supports, Weight
    from elastica_cad.strip.held_shape import MakingTolerance
    from elastica_cad.strip.outline import Tab
    from elastica_cad.strip.slots import Slot
    from elastica_cad.strip.styles import Style
    from elastica_cad.strip.uncuttable_parts import FabricationLimits


class StripOptions(TypedDict, total=False):
    """Options of every function in addition to path, sheet and max_width: see `StripSpec`.

    `gravity` may also be a vector of the CAD library, which is a direction in space.
    """

    plane: Annotated[
        "Any",
        "Plane of the curve, with z towards the strip's upper edge: a plane of the library, or a `Frame`.",
    ]
    color: Annotated[
        "Any", "Screen colour of the body: a colour of the library, or red, green and blue from 0 to 1."
    ]
    min_width: Annotated["float | None", "Width of the narrowest place, or its limit (mm)."]
    style: Annotated["Style", "Style: one sheet, a sheet with holes, or two glued sheets."]
    limits: Annotated[
        "Limits | None",
        "Limits that the strip must meet; the curve changes as little as possible to meet them.",
    ]
    keep: Annotated["Keep | None", "Properties of the curve that stay when it changes."]
    gravity: Annotated[
        "Gravity | bool | Sequence[float] | Point | None",
        "Own weight of the strip: true, the direction of gravity, or also its elasto-gravity length.",
    ]
    loads: Annotated[
        "PointMass | PointForce | Sequence[PointMass | PointForce] | Weight",
        "Masses and forces on the strip, or its weight in newtons, own weight included.",
    ]
    between: Annotated[
        "Rail | Pin | Tie | Sequence[Rail | Pin | Tie]",
        "Rails, pins and ties that hold the strip between its ends.",
    ]
    supports: Annotated["Supports", "Supports of the start and the end of the curve."]
    natural_curvature: Annotated[
        "float | RestCurvature",
        "Curvature before bending: a number, stations, or the curve of a pre-bent strip (1/mm).",
    ]
    samples: Annotated["int | None", "Number of nodes of the rod; chosen automatically by default."]
    ends: Annotated[
        "Tab | Sequence[Tab]",
        "Tab for both ends, or one for the start and one for the end; by default, a free end has no tab.",
    ]
    seam_position: Annotated[
        "float | None",
        "Place of the joint of a closed strip along its curve; by default where it is bent least (mm).",
    ]
    straight_ends: Annotated[
        "bool", "Use straight first and last pieces of the curve as tabs; if false, bend the whole curve."
    ]
    slots: Annotated["Slot | Sequence[Slot]", "Slots from the edge."]
    label: Annotated["str", "Name of the strip, which is engraved on it."]
    engrave: Annotated["str | None", "Text engraved in place of the label; empty for none."]
    smooth: Annotated[
        "float | None", "Largest distance by which smoothing may move the curve; 0 keeps it as drawn (mm)."
    ]
    shop: Annotated["FabricationLimits", "Limits of the workshop."]
    compensate: Annotated[
        "bool | None", "Correct the widths for slots and narrow tabs too, not only for anticlastic bending."
    ]
    creep: Annotated["float", "Long-term creep factor of the sheet; 0 for no creep."]
    section: Annotated[
        "Section | None",
        "Section: thickness, diameter of a rod or tube, or number of plies varies instead of the width.",
    ]
    ignore_limits: Annotated["bool", "Make a strip even if it cannot be cut or handled, with a warning."]
    tolerance: Annotated[
        "MakingTolerance",
        "Assumed errors of sheet, cut and clamps. The expected accuracy of the strip is computed from them.",
    ]


class FixtureSizes(TypedDict, total=False):
    """Sizes of an end fixture: see `model.EndFixture`."""

    clearance: Annotated["float", "Clearance around the tab in its pocket (mm)."]
    wall: Annotated["float", "Thickness around the pocket (mm)."]
    foot: Annotated["float", "Width of the foot on each side of the block; 0 for no foot (mm)."]
    foot_height: Annotated["float", "Height of the foot (mm)."]
    screw: Annotated["float", "Diameter of the screw holes in the foot; 0 for no holes (mm)."]
