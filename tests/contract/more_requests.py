"""Requests beyond those of `table`: pairs of supports, and fields that meet in other ways. A campaign asks them.

A row may be refused: then all front ends must refuse it alike.
"""

from itertools import product

from elastica_cad import Keep, Laminated, Limits, PointMass, Supports
from elastica_cad.mechanics import RestCurvature, ThicknessLaw
from tests.contract.table import (
    ARCH,
    BOW,
    CARD,
    DOWN_IN_FREECAD,
    HINGED,
    NEAREST_IN_FREECAD,
    OVAL,
    WAVE,
    Request,
)

PAIRS = (
    ("clamped", "clamped"), ("clamped", "pinned"), ("pinned", "clamped"), ("pinned", "pinned"),
    ("clamped", "slide-x"), ("slide-y", "clamped"), ("slide-x", "slide-y"), ("guided", "clamped"),
    ("clamped", "guided"), ("clamped", "free"), ("free", "clamped"),
)  # fmt: skip

LAMINATE = Laminated(width=24.0, backing=CARD)
LAMINATE_OPTIONS = "--style laminated --outer-width 24 --set style.backing=card-200gsm"
LAMINATE_KEYS = "style = { kind = 'laminated', width = 24, backing = 'card-200gsm' }\n"
LAMINATE_IN_FREECAD = {"Style": "Laminated", "OuterWidth": 24.0, "Backing": "card-200gsm"}
BATTEN = "kind = 'thickness', limits = [0.1, 0.5], width = 12"
WIDE, WIDE_OPTION, WIDE_KEY, WIDE_IN_FREECAD = (
    {"max_width": 20.0},
    "--max-width 20",
    "max_width = 20\n",
    {"MaxWidth": 20.0},
)

MORE_REQUESTS = {
    f"{shape}, {start} to {end}": Request(
        WIDE | {"supports": Supports(start, end)},
        f"{WIDE_OPTION} --start {start} --end {end}",
        f"{WIDE_KEY}supports = ['{start}', '{end}']",
        WIDE_IN_FREECAD | {"StartSupport": start, "EndSupport": end},
        points,
    )
    for (start, end), (shape, points) in product(PAIRS, (("hinged", HINGED), ("bow", BOW)))
} | {
    "laminated": Request({"style": LAMINATE}, LAMINATE_OPTIONS, LAMINATE_KEYS, LAMINATE_IN_FREECAD, ARCH),
    "laminated with weight": Request(
        {"style": LAMINATE, "gravity": (0.0, -1.0)}, f"{LAMINATE_OPTIONS} --gravity",
        f"{LAMINATE_KEYS}gravity = true",
        LAMINATE_IN_FREECAD | DOWN_IN_FREECAD, ARCH,
    ),
    "laminated with weight within limits": Request(
        {"style": LAMINATE, "gravity": (0.0, -1.0), "limits": Limits(ratio=3.0)},
        f"{LAMINATE_OPTIONS} --gravity --ratio 3", f"{LAMINATE_KEYS}gravity = true\nlimits.ratio = 3",
        LAMINATE_IN_FREECAD | DOWN_IN_FREECAD | NEAREST_IN_FREECAD | {"RatioLimit": 3.0}, ARCH,
    ),
    "plain with weight aslant": Request(
        WIDE | {"gravity": (0.6, -0.8)}, f"{WIDE_OPTION} --gravity --down 0.6 -0.8",
        f"{WIDE_KEY}gravity = [0.6, 0, -0.8]",
        WIDE_IN_FREECAD | {"Gravity": True, "GravityDirection": (0.6, -0.8, 0)}, ARCH,
    ),
    "as wide as masses ask for": Request(
        {"gravity": (0.0, -1.0), "loads": (PointMass(90.0, 0.03), PointMass(40.0, 0.01))},
        "--gravity --set 'loads = [{ at = 90, mass = 0.03 }, { at = 40, mass = 0.01 }]'",
        "gravity = true\nloads = [{ at = 90, mass = 0.03 }, { at = 40, mass = 0.01 }]",
        {"MaxWidth": 0.0, **DOWN_IN_FREECAD, "Loads": ["at = 90, mass = 0.03", "at = 40, mass = 0.01"]}, ARCH,
    ),
    "masses within limits": Request(
        WIDE | {"gravity": (0.0, -1.0), "loads": (PointMass(90.0, 3.0),), "limits": Limits(ratio=3.0)},
        f"{WIDE_OPTION} --gravity --set 'loads = [{{ at = 90, mass = 3 }}]' --ratio 3",
        f"{WIDE_KEY}gravity = true\nlimits.ratio = 3\nloads = [{{ at = 90, mass = 3 }}]",
        WIDE_IN_FREECAD | NEAREST_IN_FREECAD | DOWN_IN_FREECAD
        | {"RatioLimit": 3.0, "Loads": ["at = 90, mass = 3"]},
        ARCH,
    ),
    "near a curve and rolled beforehand": Request(
        WIDE | {"natural_curvature": 0.002, "limits": Limits(ratio=3.0)},
        f"{WIDE_OPTION} --natural-curvature 0.002 --ratio 3",
        f"{WIDE_KEY}natural_curvature = 0.002\nlimits.ratio = 3",
        WIDE_IN_FREECAD | NEAREST_IN_FREECAD | {"RatioLimit": 3.0, "NaturalCurvature": 0.002}, ARCH,
    ),
    "within many limits": Request(
        WIDE | {"limits": Limits(ratio=3.0, margin=2.0, curvature=0.08, length=(150, 400)),
                "keep": Keep(tangents=(True, False))},
        f"{WIDE_OPTION} --ratio 3 --margin 2 --set limits.curvature=0.08 --set limits.length=[150,400] "
        f"--set keep.tangents=[true,false]",
        f"{WIDE_KEY}limits = {{ ratio = 3, margin = 2, curvature = 0.08, length = [150, 400] }}\n"
        "keep = { tangents = [true, false] }",
        WIDE_IN_FREECAD | NEAREST_IN_FREECAD
        | {"RatioLimit": 3.0, "MarginLimit": 2.0, "LimitMargin": True, "CurvatureLimit": 0.08, "LeastLength": 150.0,
           "MostLength": 400.0, "KeepTangents": True, "TangentEnds": "start"},
        WAVE,
    ),
    "within limits that exclude each other": Request(
        WIDE | {"limits": Limits(curvature=1e-3), "keep": Keep(tangents=True, length=True)},
        f"{WIDE_OPTION} --set limits.curvature=0.001 --keep-tangents --keep-length",
        f"{WIDE_KEY}limits.curvature = 0.001\nkeep = {{ tangents = true, length = true }}",
        WIDE_IN_FREECAD | NEAREST_IN_FREECAD | {"CurvatureLimit": 1e-3, "KeepTangents": True, "KeepLength": True},
        ARCH,
    ),
    "a wave that no strip takes": Request(WIDE, WIDE_OPTION, WIDE_KEY, WIDE_IN_FREECAD, WAVE),
    "wider at its narrowest than it may be": Request(
        WIDE | {"min_width": 19.9}, f"{WIDE_OPTION} --min-width 19.9", f"{WIDE_KEY}min_width = 19.9",
        WIDE_IN_FREECAD | {"MinWidth": 19.9}, ARCH,
    ),
    "wide": Request(WIDE, WIDE_OPTION, WIDE_KEY, WIDE_IN_FREECAD, ARCH, sheet="pom-0.5"),
    "wide, as if it were narrow": Request(
        WIDE | {"compensate": False}, f"{WIDE_OPTION} --no-compensate", f"{WIDE_KEY}compensate = false",
        WIDE_IN_FREECAD | {"Anticlastic": False}, ARCH, sheet="pom-0.5",
    ),
    "wide with weight": Request(
        {"min_width": 12.0, "gravity": (0.0, -1.0)}, "--min-width 12 --gravity", "min_width = 12\ngravity = true",
        {"MaxWidth": 0.0, "MinWidth": 12.0, **DOWN_IN_FREECAD}, ARCH, sheet="pom-0.5",
    ),
    "wide with weight near a curve": Request(
        WIDE | {"gravity": (0.0, -1.0), "limits": Limits(ratio=1.3)}, f"{WIDE_OPTION} --gravity --ratio 1.3",
        f"{WIDE_KEY}gravity = true\nlimits.ratio = 1.3",
        WIDE_IN_FREECAD | NEAREST_IN_FREECAD | DOWN_IN_FREECAD | {"RatioLimit": 1.3}, ARCH, sheet="pom-0.5",
    ),
    "closed where it is bent least": Request(WIDE, WIDE_OPTION, WIDE_KEY, WIDE_IN_FREECAD, OVAL),
    "closed within limits": Request(
        WIDE | {"seam_position": 60.0, "limits": Limits(ratio=9.0)},
        f"{WIDE_OPTION} --set seam_position=60 --ratio 9",
        f"{WIDE_KEY}seam_position = 60\nlimits.ratio = 9",
        WIDE_IN_FREECAD | NEAREST_IN_FREECAD | {"RatioLimit": 9.0, "Joint": 60.0}, OVAL,
    ),
    "a batten under its weight": Request(
        {"section": ThicknessLaw(CARD, 0.1, 0.5, width=12.0), "gravity": (0.0, -1.0)},
        f'--set "section = {{ {BATTEN} }}" --gravity',
        f"section = {{ {BATTEN} }}\ngravity = true", {"Law": BATTEN, **DOWN_IN_FREECAD}, ARCH,
    ),
    "plain, of a blank whose curvature varies": Request(
        WIDE | {"natural_curvature": RestCurvature.linear([0, 90, 201.5], [0.002, -0.003, 0.001])},
        f"{WIDE_OPTION} --natural-curvature 'stations = [0, 90, 201.5], curvatures = [0.002, -0.003, 0.001]'",
        f"{WIDE_KEY}natural_curvature = {{ stations = [0, 90, 201.5], curvatures = [0.002, -0.003, 0.001] }}",
        WIDE_IN_FREECAD | {"Blank": "stations = [0, 90, 201.5], curvatures = [0.002, -0.003, 0.001]"}, ARCH,
    ),
}  # fmt: skip
