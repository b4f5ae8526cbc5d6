"""Typed options of the CAD libraries: made by `make generate` from the fields of `StripSpec`."""

from typing import TYPE_CHECKING, Any, TypedDict

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

    plane: Any
    """Plane of the curve, with z towards the strip's upper edge: a plane of the library, or a `Frame`."""
    min_width: "float | None"
    """Width of the narrowest place, or its limit (mm)."""
    style: "Style"
    """Style that realizes the stiffness."""
    limits: "Limits | None"
    """Limits within which the curve may change; the change is as small as possible."""
    keep: "Keep | None"
    """Properties that a curve keeps when it changes."""
    gravity: "Gravity | bool | Sequence[float] | Point | None"
    """Weight of the strip: true, a direction of gravity, or a `Gravity`."""
    loads: "PointMass | Sequence[PointMass] | Weight"
    """Masses hung on the strip, or all weight in newtons."""
    supports: "Supports"
    """Supports of the start and the end of the curve."""
    natural_curvature: "float | RestCurvature"
    """Curvature of the strip before bending, or a pre-bent strip (1/mm)."""
    samples: "int | None"
    """Number of nodes of the rod; by default it is chosen automatically."""
    ends: "Tab | Sequence[Tab]"
    """Tab of both ends, or the tabs of start and end."""
    seam_position: "float | None"
    """Position of the joint of a closed strip along its curve; by default where it is bent least (mm)."""
    straight_ends: "bool"
    """Straight first and last pieces of the curve become the tabs; false: the whole curve is bent."""
    slots: "Slot | Sequence[Slot]"
    """Slots from the edge."""
    label: "str"
    """Name of the strip, which is engraved on it."""
    engrave: "str | None"
    """Text engraved instead of the label; empty for no text."""
    smooth: "float | None"
    """Largest movement of the curve for smoothing; 0 follows it exactly as drawn (mm)."""
    shop: "FabricationLimits"
    """Limits of the workshop."""
    compensate: "bool | None"
    """Compensate slots, narrow tabs and bending by the widths; by default anticlastic bending alone."""
    creep: "float"
    """Long-term creep factor of the sheet; 0 for no creep."""
    law: "BoundedLaw | None"
    """Stiffness law instead of width: thickness, a rod, a tube, or glued plies."""
    ignore_limits: "bool"
    """Make a strip beyond the limits of the workshop, with warnings."""
    tolerance: "MakingTolerance"
    """Tolerances of sheet, cut and clamps; their effect is reported."""


class FixtureSizes(TypedDict, total=False):
    """Sizes of an end fixture; see `model.EndFixture`."""

    clearance: "float"
    """Room around the tab in its pocket (mm)."""
    wall: "float"
    """Thickness around the pocket (mm)."""
    foot: "float"
    """Width of the foot; 0 for none (mm)."""
    foot_height: "float"
    """Height of the foot (mm)."""
    screw: "float"
    """Diameter of the screw holes in the foot; 0 for none (mm)."""
