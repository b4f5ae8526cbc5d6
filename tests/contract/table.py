"""Requests for one strip in the words of every front end, and requests that all of them refuse.

Each row says the same thing four times: the fields of `StripSpec`, which build123d and CadQuery take too; options
of `elastica strip`; keys of a strip in a design file; properties of a strip in FreeCAD. All must give the same
cuts, or the same refusal. Together the rows name every field of a strip, every style, law, kind of support and
limit, and all that a curve may keep.
"""

from dataclasses import dataclass
from typing import Any

from elastica_cad import (
    Box,
    FabricationLimits,
    Frame,
    Gravity,
    HalfPlane,
    Hole,
    Keep,
    Laminated,
    Limits,
    Perforated,
    PlaneCurve,
    PointForce,
    PointMass,
    Rail,
    Sheet,
    Slot,
    Supports,
    Tab,
    Tie,
    Weight,
)
from elastica_cad.mechanics import LeavesLaw, RestCurvature, RoundLaw, ThicknessLaw
from elastica_cad.strip import TSlot

Points = list[tuple[float, float]]
"""Control points of a clamped uniform spline, mm."""

ARCH: Points = [(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)]
BOW: Points = [(0, 0), (40, 50), (110, 60), (150, 0)]
WAVE: Points = [(0, 0), (20, 90), (60, -60), (90, 95), (120, -20), (150, 0)]
OVAL: Points = [(0, 0), (80, 0), (160, 120), (0, 360), (-160, 120), (-80, 0), (0, 0)]
TALL: Points = [(0, 0), (10, 90), (140, 90), (150, 0)]
HINGED: Points = [(0, 0), (25, 30), (50, 60), (100, 60), (125, 30), (150, 0)]
"""Not curved at its ends, as hinges need it."""
PEN: Points = [(0, 0), (0, 60), (40, 100), (100, 100), (150, 100), (200, 70), (200, 0)]
PEN_KNOTS = (0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 2.0, 2.0, 2.0, 2.0)
"""Two pieces of a pen tool, whose curvature jumps: the outline of the strip would step."""

CARD = Sheet.named("card-200gsm")


@dataclass(frozen=True, eq=False)
class Request:
    """One strip in four ways of asking. A curve whose degree is not given is one Bezier curve."""

    fields: dict[str, Any]
    options: str
    keys: str
    properties: dict[str, Any]
    points: Points
    sheet: str = "card-200gsm"
    thickness: float | None = None
    degree: int | None = None
    knots: tuple[float, ...] | None = None

    @property
    def curve(self) -> PlaneCurve:
        if self.knots is not None:
            return PlaneCurve(self.knots, self.points, self.degree)
        return PlaneCurve.spline(self.points, degree=self.degree or len(self.points) - 1)

    @property
    def material(self) -> Sheet:
        sheet = Sheet.named(self.sheet)
        return sheet if self.thickness is None else sheet.with_thickness(self.thickness)


DOWN_IN_FREECAD = {"Gravity": True, "GravityDirection": (0, -1, 0)}
NEAREST_IN_FREECAD = {"Follow": "Nearest", "RatioLimit": 0.0, "LimitMargin": False, "LimitStrain": False}
"""FreeCAD limits ratio, margin and strain unless it is told otherwise."""

REQUESTS = {
    "plain, of a measured sheet, with equal tabs": Request(
        {"max_width": 20.0, "creep": 0.8, "supports": Supports("slide-x", "slide-y"),
         "ends": (Tab(8, corner_radius=1), Tab(8, corner_radius=1))},
        """--thickness 0.3 --max-width 20 --set creep=0.8 --start slide-x --end slide-y
           --tab 8 --set ends.corner_radius=1""",
        """thickness = 0.3
           max_width = 20
           creep = 0.8
           supports = ["slide-x", "slide-y"]
           ends = { length = 8, corner_radius = 1 }""",
        {"Thickness": 0.3, "MaxWidth": 20.0, "Creep": 0.8, "StartSupport": "slide-x",
         "EndSupport": "slide-y", "StartTab": 8.0, "EndTab": 8.0, "TabRadius": 1.0},
        BOW, thickness=0.3,
    ),
    "narrower than can be handled, of a faired curve": Request(
        {"min_width": 1.5, "ignore_limits": True, "smooth": 0.5, "shop": FabricationLimits(least_width=2.0)},
        "--min-width 1.5 --ignore-limits --set smooth=0.5 --set shop.least_width=2",
        """min_width = 1.5
           ignore_limits = true
           smooth = 0.5
           shop = { least_width = 2 }""",
        {"MaxWidth": 0.0, "MinWidth": 1.5, "Anyway": True, "Smooth": 0.5, "LeastWidth": 2.0},
        [(0, 0), (30, 60), (75, 75), (120, 60), (150, 0)], degree=2,
    ),
    "slotted, with tabs of all kinds": Request(
        {"max_width": 20.0,
         "ends": (Tab(12, chamfer=2, holes=(Hole(6, 3, across=1),)),
                  Tab(22, width=18, taper=1, t_slot=TSlot(9, screw=3, nut=(5, 2), wall=3))),
         "slots": (Slot(40.0, 1.2, side="lower"), Slot(80.0, 1.5, 4.0, lean=0.1, relief="round", mate="B"))},
        """--max-width 20
           --set 'ends = [{ length = 12, chamfer = 2, holes = [{ at = 6, diameter = 3, across = 1 }] },
           { length = 22, width = 18, taper = 1, t_slot = { depth = 9, screw = 3, nut = [5, 2], wall = 3 } }]'
           --set 'slots = [{ at = 40, width = 1.2, side = "lower" },
              { at = 80, width = 1.5, depth = 4, lean = 0.1, relief = "round", mate = "B" }]'""",
        """max_width = 20
           ends = [{ length = 12, chamfer = 2, holes = [{ at = 6, diameter = 3, across = 1 }] },
                   { length = 22, width = 18, taper = 1, \
                     t_slot = { depth = 9, screw = 3, nut = [5, 2], wall = 3 } }]
           slots = [{ at = 40, width = 1.2, side = "lower" },
                    { at = 80, width = 1.5, depth = 4, lean = 0.1, relief = "round", mate = "B" }]""",
        {"MaxWidth": 20.0,
         "StartTabKeys": "length = 12, chamfer = 2, holes = [{ at = 6, diameter = 3, across = 1 }]",
         "EndTabKeys": "length = 22, width = 18, taper = 1, "
                       "t_slot = { depth = 9, screw = 3, nut = [5, 2], wall = 3 }",
         "Slots": ['at = 40, width = 1.2, side = "lower"',
                   'at = 80, width = 1.5, depth = 4, lean = 0.1, relief = "round", mate = "B"']},
        ARCH,
    ),
    "perforated, rolled beforehand, guided at its start": Request(
        {"style": Perforated(width=24.0, columns=2, rows=6, hole_ratio=0.72, least_ligament=0.4, least_hole=1.2,
                             corner_radius=0.1, sides="arc"),
         "shop": FabricationLimits(least_ligament=0.4), "natural_curvature": 0.002,
         "supports": Supports("guided", "clamped"),
         "ends": (Tab(12, holes=(Hole(6, 3),)), Tab(8, holes=(Hole(4, 3),)))},
        """--style perforated --outer-width 24 --set style.columns=2 --set style.rows=6
           --set style.hole_ratio=0.72 --set style.least_ligament=0.4 --set shop.least_ligament=0.4
           --set style.least_hole=1.2 --set style.corner_radius=0.1 --set style.sides=arc
           --natural-curvature 0.002 --start guided --end clamped
           --set 'ends = [{ length = 12, holes = [{ at = 6, diameter = 3 }] },
              { length = 8, holes = [{ at = 4, diameter = 3 }] }]'""",
        """style = { kind = "perforated", width = 24, columns = 2, rows = 6, hole_ratio = 0.72, \
least_ligament = 0.4, least_hole = 1.2, corner_radius = 0.1, sides = "arc" }
           shop.least_ligament = 0.4
           natural_curvature = 0.002
           supports = ["guided", "clamped"]
           ends = [{ length = 12, holes = [{ at = 6, diameter = 3 }] },
                   { length = 8, holes = [{ at = 4, diameter = 3 }] }]""",
        {"Style": "Perforated", "OuterWidth": 24.0, "Columns": 2, "Rows": 6, "HoleRatio": 0.72,
         "LeastLigament": 0.4, "LeastHole": 1.2, "HoleRadius": 0.1, "HoleSides": "arc", "NaturalCurvature": 0.002,
         "StartSupport": "guided", "EndSupport": "clamped", "StartTab": 12.0, "EndTab": 8.0, "TabHole": 3.0},
        BOW,
    ),
    "laminated, masses hung on it": Request(
        {"style": Laminated(width=24.0, backing=CARD, least_backing=2.0, dots=2.0), "gravity": (0.6, -0.8),
         "loads": (PointMass(60.0, 2.0), PointMass(90.0, 1.0))},
        """--style laminated --outer-width 24 --set style.backing=card-200gsm --set style.least_backing=2
           --set style.dots=2
           --gravity --down 0.6 -0.8 --set 'loads = [{ at = 60, mass = 2 }, { at = 90, mass = 1 }]'""",
        """style = { kind = "laminated", width = 24, backing = "card-200gsm", least_backing = 2, dots = 2 }
           gravity = [0.6, 0, -0.8]
           loads = [{ at = 60, mass = 2 }, { at = 90, mass = 1 }]""",
        {"Style": "Laminated", "OuterWidth": 24.0, "Backing": "card-200gsm", "LeastBacking": 2.0, "Dots": 2.0,
         "Gravity": True, "GravityDirection": (0.6, -0.8, 0), "Loads": ["at = 60, mass = 2", "at = 90, mass = 1"]},
        ARCH,
    ),
    "a rail, a cord and a force": Request(
        {"max_width": 20.0, "between": (Rail((70.0, 60.0)), Tie(40.0, 150.0)),
         "loads": (PointForce(75.0, (0.0, -0.01)),)},
        """--max-width 20 --set 'loads = [{ at = 75, force = [0, -0.01] }]'
           --set 'between = [{ at = [70, 60] }, { kind = "tie", start = 40, end = 150 }]'""",
        """max_width = 20
           between = [{ at = [70, 60] }, { kind = "tie", start = 40, end = 150 }]
           loads = [{ at = 75, force = [0, -0.01] }]""",
        {"MaxWidth": 20.0, "Between": ["at = [70, 60]", "kind = 'tie', start = 40, end = 150"],
         "Loads": ["at = 75, force = [0, -0.01]"]},
        ARCH,
    ),
    "all weight in newtons": Request(
        {"max_width": 20.0, "gravity": Gravity(300.0, (0.0, -1.0)),
         "loads": Weight(1e-4, 1e-6, (PointMass(60.0, 0.1),), own=True)},
        """--max-width 20 --gravity --set gravity.length=300
           --set 'loads = { alpha = 1e-4, beta = 1e-6, own = true, masses = [{ at = 60, mass = 0.1 }] }'""",
        """max_width = 20
           gravity = { length = 300 }
           loads = { alpha = 1e-4, beta = 1e-6, own = true, masses = [{ at = 60, mass = 0.1 }] }""",
        {"MaxWidth": 20.0, **DOWN_IN_FREECAD, "GravityLength": 300.0,
         "WeightLaw": "alpha = 1e-4, beta = 1e-6, own = true, masses = [{ at = 60, mass = 0.1 }]"},
        ARCH,
    ),
    "widths made for narrow tabs, weight and anticlastic bending": Request(
        {"max_width": 20.0, "gravity": True, "ends": (Tab(12, width=8), Tab(8)), "compensate": True},
        "--max-width 20 --gravity --set 'ends = [{ length = 12, width = 8 }, { length = 8 }]' --compensate",
        """max_width = 20
           gravity = true
           ends = [{ length = 12, width = 8 }, { length = 8 }]
           compensate = true""",
        {"MaxWidth": 20.0, **DOWN_IN_FREECAD, "StartTabKeys": "length = 12, width = 8", "EndTabKeys": "length = 8",
         "Compensate": True},
        ARCH, sheet="pom-0.5",
    ),
    "closed, joined where it is told, widths in proportion to the stiffness": Request(
        {"max_width": 20.0, "seam_position": 60.0, "ends": (Tab(8), Tab(8)), "compensate": False},
        "--max-width 20 --set seam_position=60 --tab 8 --no-compensate",
        """max_width = 20
           seam_position = 60
           ends = { length = 8 }
           compensate = false""",
        {"MaxWidth": 20.0, "Joint": 60.0, "StartTab": 8.0, "EndTab": 8.0, "Anticlastic": False},
        OVAL, sheet="pom-0.5",
    ),
    "a batten planed thinner": Request(
        {"section": ThicknessLaw(CARD, 0.1, 0.5, width=12.0)},
        """--set 'section = { kind = "thickness", limits = [0.1, 0.5], width = 12 }'""",
        """section = { kind = "thickness", limits = [0.1, 0.5], width = 12 }""",
        {"Law": 'kind = "thickness", limits = [0.1, 0.5], width = 12'},
        ARCH,
    ),
    "a round rod, of a blank whose curvature varies": Request(
        {"section": RoundLaw(CARD, 2.0, 8.0), "samples": 101,
         "natural_curvature": RestCurvature.linear([0, 90, 202.2], [0.002, -0.003, 0.001])},
        """--set 'section = { kind = "rod", limits = [2, 8] }' --set samples=101
           --natural-curvature 'stations = [0, 90, 202.2], curvatures = [0.002, -0.003, 0.001]'""",
        """section = { kind = "rod", limits = [2, 8] }
           samples = 101
           natural_curvature = { stations = [0, 90, 202.2], curvatures = [0.002, -0.003, 0.001] }""",
        {"Law": 'kind = "rod", limits = [2, 8]', "Samples": 101,
         "Blank": "stations = [0, 90, 202.2], curvatures = [0.002, -0.003, 0.001]"},
        ARCH,
    ),
    "a tube under its weight, lying on its side in space": Request(
        {"section": RoundLaw(CARD, 0.2, 0.8, bore=0.7), "gravity": (0.0, 0.0, -1.0),
         "frame": Frame((5.0, -7.0, 11.0), (0.0, 0.0, 1.0), (0.0, 1.0, 0.0))},
        """--set 'section = { kind = "tube", limits = [0.2, 0.8], bore = 0.7 }' --gravity --set gravity=[0,0,-1]
           --set origin=[5,-7,11] --set x_axis=[0,0,1] --set y_axis=[0,1,0]""",
        """section = { kind = "tube", limits = [0.2, 0.8], bore = 0.7 }
           gravity = [0, 0, -1]
           origin = [5, -7, 11]
           x_axis = [0, 0, 1]
           y_axis = [0, 1, 0]""",
        {"Law": 'kind = "tube", limits = [0.2, 0.8], bore = 0.7', "Gravity": True, "GravityDirection": (0, 0, -1)},
        ARCH,
    ),
    "glued leaves near a curve, its tangents kept": Request(
        {"section": LeavesLaw(CARD, 4, 12.0, fewest=2), "limits": Limits(), "keep": Keep(tangents=True)},
        """--set 'section = { kind = "leaves", leaves = 4, fewest = 2, width = 12 }' --nearest --keep-tangents""",
        """section = { kind = "leaves", leaves = 4, fewest = 2, width = 12 }
           limits = {}
           keep = { tangents = true }""",
        {**NEAREST_IN_FREECAD, "Law": 'kind = "leaves", leaves = 4, fewest = 2, width = 12', "KeepTangents": True},
        HINGED,
    ),
    "near a curve, free at its end": Request(
        {"max_width": 20.0, "supports": Supports("clamped", "free"), "gravity": (0.0, -1.0),
         "limits": Limits(ratio=3.0), "keep": Keep(tangents=(True, False))},
        "--max-width 20 --start clamped --end free --gravity --ratio 3 --set keep.tangents=[true,false]",
        """max_width = 20
           supports = ["clamped", "free"]
           gravity = true
           limits = { ratio = 3 }
           keep = { tangents = [true, false] }""",
        {"MaxWidth": 20.0, "StartSupport": "clamped", "EndSupport": "free", "EndTab": 0, **DOWN_IN_FREECAD,
         **NEAREST_IN_FREECAD, "RatioLimit": 3.0, "KeepTangents": True, "TangentEnds": "start"},
        WAVE,
    ),
    "near a curve, above the ground and beside a box": Request(
        {"max_width": 20.0, "supports": Supports("slide-y", "pinned"), "keep": Keep(points=(40.0,)),
         "limits": Limits(sheet=CARD, width=(14, 20),
                          keep_out=(HalfPlane((0, -1), (0, 1)), Box((60, 55), (90, 95))),
                          stiffness_bounds=((1, 1, 1.1, 1.1), (3, 2, 3)))},
        """--max-width 20 --start slide-y --end pinned --set keep.points=[40] --keep-strain
           --set limits.width=[14,20]
           --set 'limits.keep_out = [{ point = [0, -1], normal = [0, 1] }, { lower = [60, 55], upper = [90, 95] }]'
           --set 'limits.stiffness_bounds = { lower = [1, 1, 1.1, 1.1], upper = [3, 2, 3] }'""",
        """max_width = 20
           supports = ["slide-y", "pinned"]
           keep = { points = [40] }
           limits.strain = true
           limits.width = [14, 20]
           limits.keep_out = [{ point = [0, -1], normal = [0, 1] }, { lower = [60, 55], upper = [90, 95] }]
           limits.stiffness_bounds = { lower = [1, 1, 1.1, 1.1], upper = [3, 2, 3] }""",
        {"MaxWidth": 20.0, "StartSupport": "slide-y", "EndSupport": "pinned", **NEAREST_IN_FREECAD,
         "KeepPoints": [40.0], "LimitStrain": True, "LeastWidth": 14.0, "MostWidth": 20.0,
         "KeepOut": ["point = [0, -1], normal = [0, 1]", "lower = [60, 55], upper = [90, 95]"],
         "StiffnessBounds": "lower = [1, 1, 1.1, 1.1], upper = [3, 2, 3]"},
        ARCH,
    ),
    "near a curve, stable, its inflections on a line": Request(
        {"max_width": 20.0, "supports": Supports("pinned", "clamped"), "natural_curvature": 0.002,
         "limits": Limits(margin=9.0), "keep": Keep(line=((0, 20), (150, 25)))},
        """--max-width 20 --start pinned --end clamped --natural-curvature 0.002 --margin 9
           --set keep.line=[[0,20],[150,25]]""",
        """max_width = 20
           supports = ["pinned", "clamped"]
           natural_curvature = 0.002
           limits = { margin = 9 }
           keep = { line = [[0, 20], [150, 25]] }""",
        {"MaxWidth": 20.0, "StartSupport": "pinned", "EndSupport": "clamped", "NaturalCurvature": 0.002,
         **NEAREST_IN_FREECAD, "LimitMargin": True, "MarginLimit": 9.0, "InflectionLine": [0.0, 20.0, 150.0, 25.0]},
        WAVE,
    ),
    "near a curve, of the same length, within a strain, its end let go": Request(
        {"max_width": 20.0, "limits": Limits(sheet=CARD, strain=0.003),
         "keep": Keep(ends=(True, False), length=True)},
        "--max-width 20 --set limits.strain=0.003 --keep-ends start --keep-length",
        """max_width = 20
           limits = { strain = 0.003 }
           keep = { ends = [true, false], length = true }""",
        {"MaxWidth": 20.0, **NEAREST_IN_FREECAD, "LimitStrain": True, "StrainLimit": 0.3, "KeepEnds": "start",
         "KeepLength": True},
        WAVE,
    ),
    "near a curve, symmetric, shorter and less curved": Request(
        {"max_width": 20.0, "limits": Limits(curvature=0.02, length=(200, 220)),
         "keep": Keep(symmetry="mirror", tangents=True)},
        "--max-width 20 --set limits.curvature=0.02 --set limits.length=[200,220] --set keep.symmetry=mirror "
        "--keep-tangents",
        """max_width = 20
           limits = { curvature = 0.02, length = [200, 220] }
           keep = { symmetry = "mirror", tangents = true }""",
        {"MaxWidth": 20.0, **NEAREST_IN_FREECAD, "CurvatureLimit": 0.02, "LeastLength": 200.0, "MostLength": 220.0,
         "KeepSymmetry": "mirror", "KeepTangents": True},
        TALL,
    ),
    "a pen curve, smoothed": Request(
        {"max_width": 20.0}, "--max-width 20", "max_width = 20", {"MaxWidth": 20.0}, PEN, degree=3, knots=PEN_KNOTS
    ),
    "a cubic whose curvature is continuous": Request(
        {"max_width": 20.0}, "--max-width 20", "max_width = 20", {"MaxWidth": 20.0}, ARCH, degree=3
    ),
}  # fmt: skip

REFUSED = {
    "no width": Request({}, "", "", {"MaxWidth": 0.0}, ARCH),
    "a curve that no strip takes": Request(
        {"max_width": 20.0, "supports": Supports("clamped", "slide-x")}, "--max-width 20 --end slide-x",
        'max_width = 20\nsupports = ["clamped", "slide-x"]', {"MaxWidth": 20.0, "EndSupport": "slide-x"}, HINGED,
    ),
    "narrower than the workshop can": Request(
        {"min_width": 1.5, "shop": FabricationLimits(least_width=2.0)}, "--min-width 1.5 --set shop.least_width=2",
        "min_width = 1.5\nshop = { least_width = 2 }", {"MaxWidth": 0.0, "MinWidth": 1.5, "LeastWidth": 2.0}, ARCH,
    ),
    "perforated, with larger holes than are let": Request(
        {"max_width": 8.0, "style": Perforated(width=24.0, hole_ratio=0.6)},
        "--max-width 8 --style perforated --outer-width 24 --set style.hole_ratio=0.6",
        """max_width = 8
           style = { kind = "perforated", width = 24, hole_ratio = 0.6 }""",
        {"MaterialWidth": 8.0, "Style": "Perforated", "OuterWidth": 24.0, "HoleRatio": 0.6}, ARCH,
    ),
    "laminated, with a narrower backing than is let": Request(
        {"style": Laminated(width=24.0, backing=CARD, least_backing=23.0)},
        "--style laminated --outer-width 24 --set style.backing=card-200gsm --set style.least_backing=23",
        """style = { kind = "laminated", width = 24, backing = "card-200gsm", least_backing = 23 }""",
        {"Style": "Laminated", "OuterWidth": 24.0, "Backing": "card-200gsm", "LeastBacking": 23.0}, ARCH,
    ),
    "masses without gravity": Request(
        {"max_width": 20.0, "loads": (PointMass(90.0, 3.0),)}, "--max-width 20 "
        "--set 'loads = [{ at = 90, mass = 3 }]'",
        "max_width = 20\nloads = [{ at = 90, mass = 3 }]", {"MaxWidth": 20.0, "Loads": ["at = 90, mass = 3"]}, ARCH,
    ),
    "limits that cannot be met together": Request(
        {"max_width": 20.0, "supports": Supports("free", "clamped"), "gravity": True, "limits": Limits(ratio=3.0),
         "keep": Keep(tangents=(False, True))},
        "--max-width 20 --start free --gravity --ratio 3 --set keep.tangents=[false,true]",
        """max_width = 20
           supports = ["free", "clamped"]
           gravity = true
           limits = { ratio = 3 }
           keep = { tangents = [false, true] }""",
        {"MaxWidth": 20.0, "StartSupport": "free", **DOWN_IN_FREECAD, **NEAREST_IN_FREECAD, "RatioLimit": 3.0,
         "KeepTangents": True, "TangentEnds": "end"},
        WAVE,
    ),
    "joined, though the curve is open": Request(
        {"max_width": 20.0, "seam_position": 60.0}, "--max-width 20 --set seam_position=60",
        "max_width = 20\nseam_position = 60",
        {"MaxWidth": 20.0, "Joint": 60.0}, ARCH,
    ),
    "a slot beside the strip": Request(
        {"max_width": 20.0, "slots": (Slot(900.0, 1.2),)}, "--max-width 20 "
        "--set 'slots = [{ at = 900, width = 1.2 }]'",
        "max_width = 20\nslots = [{ at = 900, width = 1.2 }]",
        {"MaxWidth": 20.0, "Slots": ["at = 900, width = 1.2"]}, ARCH,
    ),
    "a tab too narrow for the moment of its end": Request(
        {"max_width": 30.0, "ends": (Tab(12, width=3), Tab(12))},
        "--max-width 30 --set 'ends = [{ length = 12, width = 3 }, { length = 12 }]'",
        "max_width = 30\nends = [{ length = 12, width = 3 }, { length = 12 }]",
        {"MaxWidth": 30.0, "StartTabKeys": "length = 12, width = 3", "EndTabKeys": "length = 12"}, ARCH,
        sheet="birch-plywood-0.8",
    ),
}  # fmt: skip
