# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""The table of what a strip is asked for, and of what it answers."""

import FreeCAD as App
from freecad.elastica_wb.features.proxy import CONTAINERS
from freecad.elastica_wb.host.property_table import Property

FORMS = ["Bent", "Flat"]
STYLES = ["Plain", "Perforated", "Laminated"]
FOLLOW = ["Exactly", "Nearest"]
ENDS = ["clamped", "pinned", "slide-x", "slide-y", "guided", "free"]
HOLE_SIDES = ["spline", "arc"]
KEPT_ENDS = ["both", "start", "end", "none"]
TANGENT_ENDS = KEPT_ENDS[:3]
SYMMETRIES = ["none", "mirror", "turn"]

PROPERTIES = (
    Property("LinkSubGlobal", "Curve", "Curve", "Sketch, or edges of an object, that the strip follows"),
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
    Property(
        "Length",
        "LeastWidth",
        "Width",
        "Narrowest strip, tab or tongue that the workshop can make; 0 for what the sheet takes",
        0.0,
    ),
    Property(
        "Length",
        "Smooth",
        "Curve",
        "How far the curve may be moved to smooth its curvature; 0 follows it as drawn",
        0.0,
    ),
    Property("Length", "Joint", "Tabs", "Where a closed strip is joined, along its curve; 0 chooses", 0.0),
    Property("Bool", "Compensate", "Width", "Make up for slots, narrow tabs and holes in the widths", False),
    Property(
        "Bool",
        "Anticlastic",
        "Width",
        "Make up for anticlastic bending in the widths, where the sheet's Poisson ratio is known",
        False,  # in files of earlier versions, whose widths stay
    ),
    Property("Float", "Creep", "Sheet", "Creep factor of the sheet in the long run; 0 leaves creep out", 0.0),
    Property(
        "String",
        "Tolerance",
        "Sheet",
        "What is off in sheet, cut and clamps, rad and mm: thickness_wave = 0.01, grain = 0.035, clamps = 0.0087, "
        "kerf = 0.05",
        "",
    ),
    Property(
        "String",
        "Law",
        "Width",
        'Taper: kind = "thickness", limits = [3, 8], width = 20; or "rod", "tube"',
        "",
    ),
    Property("Bool", "Anyway", "Width", "Make a strip that cannot be cut or handled, and say so", False),
    Property(
        "Length",
        "MaterialWidth",
        "Style",
        "Most of ligaments or backing, summed across; 0 for what fits",
        0.0,
    ),
    Property("Enumeration", "Style", "Style", "How stiffness becomes material", STYLES),
    Property("Length", "OuterWidth", "Style", "Width of the outline, perforated or laminated", 30.0),
    Property("Integer", "Columns", "Style", "Holes side by side in a perforated strip", 2),
    Property("Integer", "Rows", "Style", "Holes one after the other; 0 chooses", 0),
    Property("Float", "HoleRatio", "Style", "Largest share of the width that holes take", 0.85),
    Property("Length", "LeastLigament", "Style", "Narrowest ligament between holes", 0.5),
    Property("Length", "LeastHole", "Style", "Widest place of the narrowest hole", 1.0),
    Property("Length", "HoleRadius", "Style", "Rounding of the holes' corners", 0.0),
    Property("Enumeration", "HoleSides", "Style", "What the sides of holes are made of", HOLE_SIDES),
    Property("Enumeration", "Backing", "Style", "Sheet that is glued on in a laminated strip"),
    Property("String", "BackingData", "Style", "The backing's numbers", "", hidden=True),
    Property("Length", "LeastBacking", "Style", "Narrowest backing of a laminated strip", 1.0),
    Property("Length", "Dots", "Style", "Holes in the tabs that align the layers; 0 for none", 1.0),
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
    Property("Length", "GravityLength", "Mechanics", "Elasto-gravity length; 0 takes the sheet's", 0.0),
    Property("StringList", "Loads", "Mechanics", "Masses hung on the strip: at = 90, mass = 3 (mm, g)", []),
    Property("String", "WeightLaw", "Mechanics", "All weight in newtons: alpha = 0.001, own = true", ""),
    Property("Float", "NaturalCurvature", "Mechanics", "Curvature of the strip before bending, 1/mm", 0.0),
    Property(
        "String",
        "Blank",
        "Mechanics",
        "Instead of it along the strip: stations = [0, 300], curvatures = [0, 0.01]",
        "",
    ),
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
    Property("Bool", "LimitMargin", "Nearest", "Does MarginLimit count?", True),
    Property("Bool", "LimitStrain", "Nearest", "Does the strain limit count?", True),
    Property("Float", "CurvatureLimit", "Nearest", "Largest curvature, 1/mm; 0 for none", 0.0),
    Property("Length", "LeastLength", "Nearest", "Least length; counts with MostLength", 0.0),
    Property("Length", "MostLength", "Nearest", "Largest length; 0 for no limits", 0.0),
    Property("Length", "MostWidth", "Nearest", "Largest width, which bounds the ratio; 0 for none", 0.0),
    Property("StringList", "KeepOut", "Nearest", "Ground and boxes: point = [0, 0], normal = [0, 1]", []),
    Property("String", "StiffnessBounds", "Nearest", "Along the strip: lower = 1.5, upper = [2, 3, 2]", ""),
    Property("Enumeration", "KeepEnds", "Nearest", "Which ends stay where they are", KEPT_ENDS),
    Property("Bool", "KeepTangents", "Nearest", "Keep the tangents of both ends", False),
    Property("Enumeration", "TangentEnds", "Nearest", "Whose tangents KeepTangents keeps", TANGENT_ENDS),
    Property("Bool", "KeepLength", "Nearest", "Keep the length", False),
    Property("Enumeration", "KeepSymmetry", "Nearest", "Mirror image or half turn that stays", SYMMETRIES),
    Property("FloatList", "KeepPoints", "Nearest", "Places along the curve that it still passes, mm", []),
    Property("Bool", "KeepLine", "Nearest", "Keep inflections on the curve's inflection line", False),
    Property("FloatList", "InflectionLine", "Nearest", "Two points of another line: x, y, x, y", []),
    Property("Length", "StartTab", "Ends", "Length of the tab at the start", 10.0),
    Property("Length", "EndTab", "Ends", "Length of the tab at the end", 10.0),
    Property("Length", "TabRadius", "Ends", "Rounding of the tabs' corners", 0.0),
    Property("Length", "TabHole", "Ends", "Diameter of a hole in the middle of each tab; 0 for none", 0.0),
    Property("String", "StartTabKeys", "Ends", "The first tab in full: length = 12, chamfer = 2", ""),
    Property("String", "EndTabKeys", "Ends", "The last tab in full", ""),
    Property("StringList", "Slots", "Ends", "Slots: at = 40, width = 1.2, side = 'lower'", []),
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
        "Integer", "StrainUse", "Result", "Largest strain, in percent of what the sheet bears", 0, result=True
    ),
    Property("Float", "LargestStrain", "Result", "Largest strain of the skin, in percent", 0.0, result=True),
    Property("Length", "Deviation", "Result", "Largest distance from the drawn curve", 0.0, result=True),
    Property(
        "Length",
        "HeldDeviation",
        "Result",
        "Largest distance of the strip, as it is made and held, from its design",
        0.0,
        result=True,
    ),
    Property(
        "Length",
        "ExpectedDeviation",
        "Result",
        "How far a real strip strays from its design, by the model, what that leaves open, and its sheet",
        0.0,
        result=True,
    ),
    Property("String", "Held", "Result", "How it strays as made and held, and by what", "", result=True),
    Property(
        "Float",
        "SidewaysMargin",
        "Result",
        "Margin against tipping over sideways, positive where it stays in its plane; 0 where undecided",
        0.0,
        result=True,
    ),
    Property("String", "Sideways", "Result", "Does it stay in the plane of its curve?", "", result=True),
    Property("Length", "Length", "Result", "Length of the free part along the curve", 0.0, result=True),
    Property("Length", "NarrowestWidth", "Result", "Width of the narrowest place", 0.0, result=True),
    Property("Float", "Mass", "Result", "Mass in grams", 0.0, result=True),
    Property(
        "String",
        "MadeFrom",
        "Result",
        "Tells the request that the shape was made from",
        "",
        result=True,
        hidden=True,
        transient=True,
    ),
    CONTAINERS,
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
"""What a nearest curve by itself is asked for, and answers."""
