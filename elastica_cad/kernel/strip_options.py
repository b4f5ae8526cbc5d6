"""Typed options of the CAD libraries: made by `make generate` from the fields of `StripSpec`."""

from typing import TYPE_CHECKING, Annotated, Any, TypedDict

if TYPE_CHECKING:
    from collections.abc import Sequence

    from elastica_cad.forming.limits import Keep, Limits
    from elastica_cad.kernel.strip_body import Point
    from elastica_cad.mechanics.loads import Gravity, PointMass, RestCurvature, Supports, Weight
    from elastica_cad.mechanics.stiffness_law import BoundedLaw
    from elastica_cad.strip.held_shape import MakingTolerance
    from elastica_cad.strip.outline import Tab
    from elastica_cad.strip.slots import Slot
    from elastica_cad.strip.styles import Style
    from elastica_cad.strip.uncuttable_parts import FabricationLimits


class StripOptions(TypedDict, total=False):
    """Options of every function besides path, sheet and max_width; see `StripSpec`.

    `gravity` may also be a vector of the library, a direction in space.
    """

    plane: Annotated[
        "Any",
        "Plane of the curve, with z towards the strip's upper edge: a plane of the library, or a `Frame`.",
    ]
    min_width: Annotated["float | None", "Width of the narrowest place, or its limit (mm)."]
    style: Annotated["Style", "How stiffness becomes material."]
    limits: Annotated["Limits | None", "The curve may change, as little as these limits ask for."]
    keep: Annotated["Keep | None", "What a curve that may change keeps."]
    gravity: Annotated[
        "Gravity | bool | Sequence[float] | Point | None",
        "The strip carries its own weight: true, the direction in which it falls, or a length of its own.",
    ]
    loads: Annotated[
        "PointMass | Sequence[PointMass] | Weight", "Masses hung on the strip, or all weight in newtons."
    ]
    supports: Annotated["Supports", "What holds the start and the end of the curve."]
    natural_curvature: Annotated[
        "float | RestCurvature",
        "Curvature of the strip before it is bent, or a blank that is bent beforehand (1/mm).",
    ]
    samples: Annotated["int | None", "Nodes of the rod; chosen unless given."]
    ends: Annotated["Tab | Sequence[Tab]", "Tab of both ends, or the two of start and end."]
    seam_position: Annotated[
        "float | None",
        "Where a closed strip is joined, along its curve; where it is bent least unless given (mm).",
    ]
    straight_ends: Annotated[
        "bool", "Straight first and last pieces of the curve become the tabs; false: the whole curve is bent."
    ]
    slots: Annotated["Slot | Sequence[Slot]", "Slots from the edge."]
    label: Annotated["str", "Name of the strip, which is engraved on it."]
    engrave: Annotated["str | None", "Text engraved in place of the label; empty for none."]
    smooth: Annotated[
        "float | None", "How far the curve may be moved to become fair; 0 follows it exactly as drawn (mm)."
    ]
    shop: Annotated["FabricationLimits", "What the workshop can make."]
    compensate: Annotated[
        "bool | None",
        "Make up in the widths for slots, narrow tabs and bending; unless given for anticlastic bending alone.",
    ]
    creep: Annotated["float", "Creep factor of the sheet in the long run; 0 leaves creep out."]
    law: Annotated[
        "BoundedLaw | None",
        "What stiffness is made of in place of width: thickness, a rod, a tube, or glued leaves.",
    ]
    ignore_limits: Annotated["bool", "Make a strip that cannot be cut or handled, and say so."]
    tolerance: Annotated["MakingTolerance", "What is off in sheet, cut and clamps; what that adds is told."]


class FixtureSizes(TypedDict, total=False):
    """Sizes of an end fixture; see `model.EndFixture`."""

    clearance: Annotated["float", "Room around the tab in its pocket (mm)."]
    wall: Annotated["float", "Thickness around the pocket (mm)."]
    foot: Annotated["float", "Width of the foot; 0 for none (mm)."]
    foot_height: Annotated["float", "Height of the foot (mm)."]
    screw: Annotated["float", "Diameter of the screw holes in the foot; 0 for none (mm)."]
