"""Strips as they are asked for at every door: fields of `StripSpec`, typed options, keys of a design file,
properties in FreeCAD. What the doors must agree on is what the fields ask for."""

from dataclasses import dataclass, field, fields, is_dataclass
from typing import Any

import numpy as np

from elastica_cad.fabrication.slots.slot import Slot
from elastica_cad.fabrication.strip.lamination import Laminated
from elastica_cad.fabrication.strip.perforation import Perforated
from elastica_cad.fabrication.strip.tabs import Hole, Tab
from elastica_cad.forming.limits import HalfPlane, Keep, Limits
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.mechanics.loads.rest_curvature import RestCurvature
from elastica_cad.mechanics.loads.supports import Supports
from elastica_cad.mechanics.loads.weight import PointMass
from elastica_cad.mechanics.material.sheet import Sheet
from elastica_cad.mechanics.material.tapered_sections import ThicknessLaw

CARD = Sheet.named("card-200gsm")
ARCH = [(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)]
BOW = [(0, 0), (40, 50), (110, 60), (150, 0)]
OVAL = [(0, 0), (80, 0), (160, 120), (0, 360), (-160, 120), (-80, 0), (0, 0)]
WAVE = [(0, 0), (20, 90), (60, -60), (90, 95), (120, -20), (150, 0)]


@dataclass(frozen=True)
class Asked:
    """One strip at all doors. Curves are Bezier curves, which every kernel keeps as they are."""

    fields: dict[str, Any]
    options: str
    keys: str
    properties: dict[str, Any] = field(default_factory=dict)
    points: list[tuple[float, float]] = field(default_factory=lambda: ARCH)
    sheet: str = "card-200gsm"

    @property
    def curve(self) -> PlaneCurve:
        return PlaneCurve.spline(self.points, degree=len(self.points) - 1)


FREE = {"LimitMargin": False, "LimitStrain": False}
NEAREST = {"Follow": "Nearest", "RatioLimit": 0.0, **FREE}
DOWN = {"Gravity": True, "GravityDirection": (0, -1, 0)}
LAMINATED = {"Style": "Laminated", "OuterWidth": 24.0, "Backing": "card-200gsm"}
LAMINATE_KEYS = "style = { kind = 'laminated', width = 24, backing = 'card-200gsm' }\n"
LAMINATE_OPTIONS = "--style laminated --outer-width 24 --backing card-200gsm"
LAMINATE = Laminated(width=24.0, backing=CARD)

ASKED = {
    "nearest and curved before": Asked(
        {"max_width": 20.0, "natural_curvature": 0.002, "limits": Limits(ratio=3.0)},
        "--max-width 20 --natural-curvature 0.002 --ratio 3",
        "max_width = 20\nnatural_curvature = 0.002\nlimits.ratio = 3",
        NEAREST | {"RatioLimit": 3.0, "NaturalCurvature": 0.002},
    ),
    "plain": Asked({"max_width": 20.0}, "--max-width 20", "max_width = 20"),
    "narrowest": Asked(
        {"min_width": 9.0}, "--min-width 9", "min_width = 9", {"MaxWidth": 0.0, "MinWidth": 9.0}
    ),
    "samples": Asked(
        {"max_width": 20.0, "samples": 201}, "--max-width 20 --samples 201", "max_width = 20\nsamples = 201",
        {"Samples": 201},
    ),
    "perforated": Asked(
        {"style": Perforated(width=24.0, columns=2, rows=6, hole_ratio=0.8, least_ligament=0.7, least_hole=1.2,
                             corner_radius=0.2, sides="arc")},
        "--style perforated --outer-width 24 --columns 2 --rows 6 --hole-ratio 0.8 --least-ligament 0.7 "
        "--least-hole 1.2 --corner-radius 0.2 --sides arc",
        "style = { kind = 'perforated', width = 24, columns = 2, rows = 6, hole_ratio = 0.8, "
        "least_ligament = 0.7, least_hole = 1.2, corner_radius = 0.2, sides = 'arc' }",
        {"Style": "Perforated", "OuterWidth": 24.0, "Columns": 2, "Rows": 6, "HoleRatio": 0.8,
         "LeastLigament": 0.7, "LeastHole": 1.2, "HoleRadius": 0.2, "HoleSides": "arc"},
    ),
    "laminated": Asked(
        {"style": Laminated(width=24.0, backing=CARD, least_backing=2.0, dots=2.0)},
        f"{LAMINATE_OPTIONS} --least-backing 2 --dots 2",
        LAMINATE_KEYS.replace(" }", ", least_backing = 2, dots = 2 }"),
        LAMINATED | {"LeastBacking": 2.0, "Dots": 2.0},
    ),
    "laminated with weight": Asked(
        {"style": LAMINATE, "gravity": (0.0, -1.0)},
        f"{LAMINATE_OPTIONS} --gravity",
        f"{LAMINATE_KEYS}gravity = true",
        LAMINATED | DOWN,
    ),
    "laminated with a lamp": Asked(
        {"style": LAMINATE, "gravity": (0.0, -1.0), "loads": (PointMass(60.0, 2.0),)},
        f"{LAMINATE_OPTIONS} --gravity --hang 60 2",
        f"{LAMINATE_KEYS}gravity = true\nloads = [{{ at = 60, mass = 2 }}]",
        LAMINATED | DOWN | {"Loads": ["at = 60, mass = 2"]},
    ),
    "weight": Asked(
        {"max_width": 20.0, "gravity": (0.6, -0.8)}, "--max-width 20 --gravity --down 0.6 -0.8",
        "max_width = 20\ngravity = [0.6, 0, -0.8]", {"Gravity": True, "GravityDirection": (0.6, -0.8, 0)},
    ),
    "hung": Asked(
        {"gravity": (0.0, -1.0), "loads": (PointMass(90.0, 0.03), PointMass(40.0, 0.01))},
        "--gravity --hang 90 0.03 --hang 40 0.01",
        "gravity = true\nloads = [{ at = 90, mass = 0.03 }, { at = 40, mass = 0.01 }]",
        {"MaxWidth": 0.0, **DOWN, "Loads": ["at = 90, mass = 0.03", "at = 40, mass = 0.01"]},
    ),
    "nearest within limits": Asked(
        {"max_width": 20.0, "limits": Limits(ratio=3.0, margin=2.0, curvature=0.08, length=(150, 400)),
         "keep": Keep(tangents=(True, False))},
        "--max-width 20 --ratio 3 --margin 2 --max-curvature 0.08 --length-range 150 400 --keep-tangent start",
        "max_width = 20\nlimits = { ratio = 3, margin = 2, curvature = 0.08, length = [150, 400] }\n"
        "keep = { tangents = [true, false] }",
        NEAREST | {"RatioLimit": 3.0, "MarginLimit": 2.0, "LimitMargin": True, "CurvatureLimit": 0.08,
                   "LeastLength": 150.0, "MostLength": 400.0, "KeepTangents": True, "TangentEnds": "start"},
        WAVE,
    ),
    "nearest with ground": Asked(
        {"max_width": 20.0, "keep": Keep(points=(40.0,)),
         "limits": Limits(sheet=CARD, width=(6, 20), keep_out=(HalfPlane((0, -1), (0, 1)),),
                          stiffness_bounds=(None, (3.0, 2.5, 3.0)))},
        "--max-width 20 --keep-strain --width-range 6 20 --keep-point 40 "
        "--keep-out 'point = [0, -1], normal = [0, 1]' --stiffness-bounds 'upper = [3, 2.5, 3]'",
        "max_width = 20\nkeep.points = [40]\nlimits = { strain = true, width = [6, 20], "
        "keep_out = [{ point = [0, -1], normal = [0, 1] }], stiffness_bounds = { upper = [3, 2.5, 3] } }",
        NEAREST | {"LimitStrain": True, "LeastWidth": 6.0, "MostWidth": 20.0, "KeepPoints": [40.0],
                   "KeepOut": ["point = [0, -1], normal = [0, 1]"], "StiffnessBounds": "upper = [3, 2.5, 3]"},
    ),
    "compensated": Asked(
        {"max_width": 20.0, "ends": (Tab(12, width=8), Tab(8)), "compensate": True},
        "--max-width 20 --start-tab 'length = 12, width = 8' --end-tab 'length = 8' --compensate",
        "max_width = 20\nends = [{ length = 12, width = 8 }, { length = 8 }]\ncompensate = true",
        {"StartTabKeys": "length = 12, width = 8", "EndTabKeys": "length = 8", "Compensate": True},
    ),
    "as a plate": Asked({"max_width": 20.0}, "--max-width 20", "max_width = 20", sheet="pom-0.5"),
    "as a plate with weight": Asked(
        {"min_width": 12.0, "gravity": (0.0, -1.0)}, "--min-width 12 --gravity", "min_width = 12\ngravity = true",
        {"MaxWidth": 0.0, "MinWidth": 12.0, **DOWN}, sheet="pom-0.5",
    ),
    "as a plate near a curve": Asked(
        {"max_width": 20.0, "gravity": (0.0, -1.0), "limits": Limits(ratio=1.3)},
        "--max-width 20 --gravity --ratio 1.3", "max_width = 20\ngravity = true\nlimits.ratio = 1.3",
        NEAREST | DOWN | {"RatioLimit": 1.3}, sheet="pom-0.5",
    ),
    "as a beam": Asked(
        {"max_width": 20.0, "compensate": False}, "--max-width 20 --no-compensate",
        "max_width = 20\ncompensate = false", {"Anticlastic": False}, sheet="pom-0.5",
    ),
    "closed": Asked(
        {"max_width": 20.0, "ends": (Tab(8), Tab(8)), "joint": 60.0},
        "--max-width 20 --tab 8 --joint 60",
        "max_width = 20\nends = { length = 8 }\njoint = 60",
        {"StartTab": 8.0, "EndTab": 8.0, "Joint": 60.0},
        OVAL,
    ),
    "closed within limits": Asked(
        {"max_width": 20.0, "joint": 60.0, "limits": Limits(ratio=9.0)},
        "--max-width 20 --joint 60 --ratio 9",
        "max_width = 20\njoint = 60\nlimits.ratio = 9",
        NEAREST | {"RatioLimit": 9.0, "Joint": 60.0},
        OVAL,
    ),
    "closed where it is bent least": Asked({"max_width": 20.0}, "--max-width 20", "max_width = 20", {}, OVAL),
    "slotted": Asked(
        {"max_width": 20.0, "ends": (Tab(12, chamfer=2, holes=(Hole(6, 3),)), Tab(8, corner_radius=1)),
         "slots": (Slot(40.0, 1.2, side="lower"), Slot(80.0, 1.5, 4.0, lean=0.1, relief="round", mate="B"))},
        "--max-width 20 --start-tab 'length = 12, chamfer = 2, holes = [{ at = 6, diameter = 3 }]' "
        "--end-tab 'length = 8, corner_radius = 1' --slot \"at = 40, width = 1.2, side = 'lower'\" "
        "--slot \"at = 80, width = 1.5, depth = 4, lean = 0.1, relief = 'round', mate = 'B'\"",
        "max_width = 20\nends = [{ length = 12, chamfer = 2, holes = [{ at = 6, diameter = 3 }] }, "
        "{ length = 8, corner_radius = 1 }]\nslots = [{ at = 40, width = 1.2, side = 'lower' }, "
        "{ at = 80, width = 1.5, depth = 4, lean = 0.1, relief = 'round', mate = 'B' }]",
        {"StartTabKeys": "length = 12, chamfer = 2, holes = [{ at = 6, diameter = 3 }]",
         "EndTabKeys": "length = 8, corner_radius = 1",
         "Slots": ["at = 40, width = 1.2, side = 'lower'",
                   "at = 80, width = 1.5, depth = 4, lean = 0.1, relief = 'round', mate = 'B'"]},
    ),
    "tapered": Asked(
        {"law": ThicknessLaw(CARD, 0.1, 0.5, width=12.0)},
        "--law 'kind = \"thickness\", limits = [0.1, 0.5], width = 12'",
        "law = { kind = 'thickness', limits = [0.1, 0.5], width = 12 }",
        {"Law": "kind = 'thickness', limits = [0.1, 0.5], width = 12"},
    ),
    "tapered with weight": Asked(
        {"law": ThicknessLaw(CARD, 0.1, 0.5, width=12.0), "gravity": (0.0, -1.0)},
        "--law 'kind = \"thickness\", limits = [0.1, 0.5], width = 12' --gravity",
        "law = { kind = 'thickness', limits = [0.1, 0.5], width = 12 }\ngravity = true",
        {"Law": "kind = 'thickness', limits = [0.1, 0.5], width = 12", **DOWN},
    ),
    "natural curvature": Asked(
        {"max_width": 20.0, "natural_curvature": 0.002}, "--max-width 20 --natural-curvature 0.002",
        "max_width = 20\nnatural_curvature = 0.002", {"NaturalCurvature": 0.002},
    ),
    "bent beforehand": Asked(
        {"max_width": 20.0, "natural_curvature": RestCurvature.linear([0, 90, 201.5], [0.002, -0.003, 0.001])},
        "--max-width 20 --natural-curvature 'stations = [0, 90, 201.5], curvatures = [0.002, -0.003, 0.001]'",
        "max_width = 20\nnatural_curvature = { stations = [0, 90, 201.5], curvatures = [0.002, -0.003, 0.001] }",
        {"Blank": "stations = [0, 90, 201.5], curvatures = [0.002, -0.003, 0.001]"},
    ),
}  # fmt: skip

HINGED = [(0, 0), (25, 30), (50, 60), (100, 60), (125, 30), (150, 0)]
"""Without curvature at both ends, as hinges need it."""

HELD = (
    ("clamped", "clamped"), ("clamped", "pinned"), ("pinned", "clamped"), ("pinned", "pinned"),
    ("clamped", "slide-x"), ("slide-y", "clamped"), ("slide-x", "slide-y"), ("guided", "clamped"),
    ("clamped", "guided"), ("clamped", "free"), ("free", "clamped"),
)  # fmt: skip
for start, end in HELD:
    for shape, points in (("hinged", HINGED), ("bow", BOW)):
        ASKED[f"{shape}, {start} to {end}"] = Asked(
            {"max_width": 20.0, "supports": Supports(start, end)},
            f"--max-width 20 --start {start} --end {end}",
            f"max_width = 20\nsupports = ['{start}', '{end}']",
            {"StartSupport": start, "EndSupport": end},
            points,
        )

REFUSED = {
    "no width": Asked({}, "", "", {"MaxWidth": 0.0}),
    "too narrow": Asked(
        {"max_width": 20.0, "min_width": 19.9}, "--max-width 20 --min-width 19.9",
        "max_width = 20\nmin_width = 19.9", {"MinWidth": 19.9},
    ),
    "not realizable": Asked({"max_width": 20.0}, "--max-width 20", "max_width = 20", points=WAVE),
    "laminate with weight within limits": Asked(
        {"style": LAMINATE, "gravity": (0.0, -1.0), "limits": Limits(ratio=3.0)},
        f"{LAMINATE_OPTIONS} --gravity --ratio 3", f"{LAMINATE_KEYS}gravity = true\nlimits.ratio = 3",
        LAMINATED | DOWN | NEAREST | {"RatioLimit": 3.0},
    ),
    "hung without gravity": Asked(
        {"max_width": 20.0, "loads": (PointMass(90.0, 3.0),)}, "--max-width 20 --hang 90 3",
        "max_width = 20\nloads = [{ at = 90, mass = 3 }]", {"Loads": ["at = 90, mass = 3"]},
    ),
    "hung within limits": Asked(
        {"max_width": 20.0, "gravity": (0.0, -1.0), "loads": (PointMass(90.0, 3.0),), "limits": Limits(ratio=3.0)},
        "--max-width 20 --gravity --hang 90 3 --ratio 3",
        "max_width = 20\ngravity = true\nlimits.ratio = 3\nloads = [{ at = 90, mass = 3 }]",
        NEAREST | DOWN | {"RatioLimit": 3.0, "Loads": ["at = 90, mass = 3"]},
    ),
    "limits that cannot be met": Asked(
        {"max_width": 20.0, "limits": Limits(curvature=1e-3), "keep": Keep(tangents=True, length=True)},
        "--max-width 20 --max-curvature 0.001 --keep-tangents --keep-length",
        "max_width = 20\nlimits.curvature = 0.001\nkeep = { tangents = true, length = true }",
        NEAREST | {"CurvatureLimit": 1e-3, "KeepTangents": True, "KeepLength": True},
    ),
    "joined but open": Asked(
        {"max_width": 20.0, "joint": 60.0}, "--max-width 20 --joint 60", "max_width = 20\njoint = 60",
        {"Joint": 60.0},
    ),
    "slot off the strip": Asked(
        {"max_width": 20.0, "slots": (Slot(900.0, 1.2),)}, "--max-width 20 --slot 'at = 900, width = 1.2'",
        "max_width = 20\nslots = [{ at = 900, width = 1.2 }]", {"Slots": ["at = 900, width = 1.2"]},
    ),
}  # fmt: skip


def loop_numbers(strip: Any) -> list[Any]:
    """All that is cut of a strip: of every layer the kinds of its segments, then their numbers in one array."""
    loops = [loop for layer in strip.layers for loop in (layer.outline, *layer.holes)]
    return [[type(one).__name__ for loop in loops for one in loop.segments], np.array(_numbers(loops))]


def _numbers(value: Any) -> list[float]:
    if is_dataclass(value):
        return [number for one in fields(value) for number in _numbers(getattr(value, one.name))]
    if isinstance(value, list | tuple | np.ndarray):
        return [number for one in value for number in _numbers(one)]
    return [float(value)] if isinstance(value, float | int | np.number) else []
