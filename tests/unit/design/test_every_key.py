"""Every key of a design acts in a design of the table below. On other makers it acts, is refused or is noted."""

import copy
import hashlib
import math
import pickle
from itertools import pairwise

import pytest

from elastica_cad import InputError, PlaneCurve, read_curves, write_curves
from elastica_cad.design.design_file import design_of
from elastica_cad.design.design_schema import tables
from elastica_cad.design.model_tables import MAKERS, makers_using
from elastica_cad.design.pair_table import cutting_of, pair_of
from elastica_cad.design.strip_table import SHARED
from elastica_cad.errors import ElasticaError
from elastica_cad.formats.source_file import read_below
from elastica_cad.kit.kit import cutting_files
from elastica_cad.kit.kit_contents import kit_contents
from tests.dome import dome, obj_text

TABLES = tables()

CARD, WOOD, MDF = (
    {"sheet": "card-200gsm", "max_width": 20},
    {"sheet": "birch-plywood-0.8"},
    {"sheet": "mdf-3"},
)
ARC = {"ellipse": {"semi_axes": [90, 60], "start": 0.2, "end": 2.9}}
EVEN = {"ellipse": {"semi_axes": [90, 60], "start": 0.3, "end": math.pi - 0.3}}
ABOVE = {"ellipse": {"semi_axes": [90, 60], "above": 20}}
FLAT = {"ellipse": {"semi_axes": [90, 25], "start": 0.2, "end": 2.9}}
UPRIGHT = {"ellipse": {"semi_axes": [90, 60], "start": 0, "end": math.pi}}
LOOP = {"ellipse": {"semi_axes": [90, 60], "start": 0.2, "end": 0.2 + 2 * math.pi}}
HUMP = {"spline": [[0, 0], [20, 30], [50, 40], [80, 30], [100, 0]], "degree": 4}
NURBS = HUMP | {"degree": 3, "knots": [0, 0, 0, 0, 0.4, 1, 1, 1, 1], "weights": [1, 1, 1.1, 1, 1]}
LOW = {"spline": [[0, 0], [30, 20], [50, 24], [70, 20], [100, 0]], "degree": 4}
ARCH = [[0, 0], [27, 0], [53, 24], [105, 24], [123, 0], [150, 0]]
PROFILE = {"spline": [[70, 0], [90, 40], [95, 80], [80, 120]], "degree": 3}
POINTS = [[70, 0], [85, 16], [125, 55], [90, 115], [75, 140]]
MESH = {"mesh": "dome.obj", "tolerance": 0.3}
CUT = {"normal": [0, 1, 0], "offsets": [0]}


def strips(*curves, **top):
    """A design of strips with the keys `top`, None for a key to leave out, and a table for each curve."""
    keys = {key: value for key, value in (CARD | top).items() if value is not None}
    return keys | {"strips": [{"curve": curve} for curve in curves or [ARC]]}


def held(kind, curve=ARC, /, **keys):
    """A design of two strips side by side in a holder."""
    side = {"curve": curve, "count": 2, "origin": [0, "60 * i", 0]}
    table = keys if kind == "fixtures" else MDF | keys
    return CARD | WOOD | {"ends": {"length": 25}, "strips": [side], kind: table}


def revolved(**keys):
    """A design of a surface of revolution, through points unless the keys give it otherwise."""
    points = {} if {"curve", "a"} & set(keys) else {"points": POINTS}
    return {"revolution": {"sheet": "card-200gsm", "strips": 12} | points | keys}


def cut(**keys):
    """A design of strips along sections of a dome."""
    return CARD | {"limits": {}, "strips": [{"sections": MESH | keys}]}


def pair(**keys):
    """A design of a part with two states."""
    states = {"first": ARCH, "second": [[x, -0.8 * y] for x, y in ARCH]}
    return {
        "pair": {"sheet": "pom-3"}
        | {state: {"spline": at, "degree": 4} for state, at in states.items()}
        | keys
    }


FELT = {"thickness_mm": 0.3, "youngs_modulus_MPa": 2000, "density_kg_m3": 700, "max_strain": 0.02}

DESIGNS = {
    "arch": strips(),
    "named": strips(let={"w": 20}, max_width="w"),
    "perforated": strips(style={"kind": "perforated", "width": 24, "rows": 10}),
    "laminated": strips(style={"kind": "laminated", "width": 24, "backing": "card-200gsm"}),
    "gravity": strips(gravity={"length": 90, "direction": [0, -1]}),
    "mass": strips(gravity=True, loads=[{"at": 30, "mass": 2}]),
    "force": strips(loads=[{"at": 40, "force": [0, -0.001]}]),
    "weight": strips(gravity=True, loads={"alpha": 2e-5, "own": True}),
    "rail": strips(between=[{"kind": "rail", "at": 60}]),
    "pin": strips(between=[{"kind": "pin", "at": 60}]),
    "tie": strips(between=[{"kind": "tie", "start": 10, "end": 170}]),
    "tab": strips(ends={"length": 25, "width": 20}),
    "slotted tab": strips(
        ends={"length": 25, "width": 20, "t_slot": {"depth": 9, "screw": 2.2, "nut": [4, 2], "wall": 2}}
    ),
    "hole": strips(ends={"length": 12, "holes": [{"at": 5, "diameter": 2}]}),
    "loop": strips(LOOP),
    "blank": strips(natural_curvature={"stations": [0, 100, 211.22], "curvatures": [0.001, 0.002, 0.001]}),
    "drawn blank": strips(HUMP, natural_curvature={"curve": HUMP}),
    "thickness": strips(max_width=None, section={"kind": "thickness", "limits": [0.1, 3], "width": 20}),
    "rod": strips(max_width=None, section={"kind": "rod", "limits": [0.5, 3]}),
    "tube": strips(max_width=None, section={"kind": "tube", "limits": [0.5, 3], "bore": 0.5}),
    "leaves": strips(FLAT, max_width=None, limits={}, section={"kind": "leaves", "leaves": 4, "width": 20}),
    "slot": strips(ends={"length": 9, "width": 9})
    | {"strips": [{"curve": ARC, "slots": [{"at": 90, "width": 1.2, "depth": 4}]}]},
    "straight start": strips(
        {"x": "t", "y": "where(t < 20, 0, 5e-5 * (t - 20) ** 3)", "t": [0, 90], "breaks": [[20, 2]]}
    ),
    "limits": strips(limits={}, keep={}),
    "wall": strips(EVEN, limits={"keep_out": [{"point": [0, 55], "normal": [0, -1]}]}),
    "box": strips(limits={"keep_out": [{"lower": [-10, 55], "upper": [10, 90]}]}),
    "bounds": strips(limits={"stiffness_bounds": {"upper": 1.08}}),
    "hump": strips(HUMP),
    "nurbs": strips(NURBS),
    "above": strips(ABOVE),
    "formulae": strips({"x": "t", "y": "0.01 * t * (90 - t)", "t": [0, 90]}),
    "id": strips({"file": "two.svg", "id": "a"}),
    "layer": strips({"file": "two.svg", "layer": "L"}),
    "number": strips({"file": "two.json", "number": 1}),
    "corners": strips(
        HUMP
        | {
            "reshape": {
                "bottom_left": [0, 0],
                "bottom_right": [90, 0],
                "top_right": [90, 40],
                "top_left": [0, 40],
            }
        }
    ),
    "handles": strips(
        HUMP
        | {
            "reshape": {
                "handles": [[0, 0], [100, 0], [100, 40], [0, 40]],
                "to": [[0, 0], [100, 0], [100, 44], [0, 40]],
            }
        }
    ),
    "stock": strips(shop={"stock": [100, 100]}),
    "spliced": strips(shop={"stock": [150, 150], "lap": 40}),
    "crossing": CARD
    | {
        "interlock": {},
        "strips": [
            {"curve": LOW, "x_axis": [1, 0, 0], "y_axis": [0, 1, 0]},
            {"curve": LOW, "origin": [70, -30, 0], "x_axis": [0, 1, 0], "y_axis": [-1, 0, 0]},
        ],
    },
    "patterns": strips(patterns=[{"mirror": {"point": [0, -9, 0], "normal": [0, 1, 0]}}]),
    "rotated": strips(patterns=[{"rotate": {"count": 3, "point": [200, 0, 0]}}]),
    "repeated": strips(patterns=[{"repeat": {"count": 2, "step": [0, 90, 0]}}]),
    "felt": strips(sheet="felt", sheets={"felt": FELT}),
    "kerf": strips(sheet="felt", sheets={"felt": FELT | {"kerf_mm": 0.2}}, cut={"kerf": "sheet"}),
    "arcs": strips(cut={"curves": "arc"}),
    "grainy": strips(**WOOD, gravity=True),
    "points": revolved(),
    "falling": revolved(points=[[125, 0], [110, 40], [90, 80], [75, 120]]),
    "unlimited": revolved(shop={"stock": [100, 100]}),
    "profile": revolved(curve=PROFILE),
    "axis": revolved(curve=PROFILE, axis={"spline": [[5, 0], [5, 40], [5, 80]], "degree": 2}),
    "equation": revolved(a=0.2, b=[0, 0.01], start=[60, 0], angle=1.2, length=90),
    "narrowing": revolved(a=-1.5, b=[0, 0.03], start=[150, -11.5], angle=2.2, length=300),
    "ringed": revolved(rings="card-200gsm"),
    "paired": revolved(rings="card-200gsm", gap=6),
    "dome": cut(parallel=CUT),
    "domes": cut(mesh="domes.obj", parallel=CUT),
    "split dome": cut(parallel=CUT, split=[{"point": [20, 0, 0], "normal": [1, 0, 0]}]),
    "points of dome": cut(parallel=CUT, split=[{"points": [[0, 0, 80]]}]),
    "corners of dome": cut(parallel=CUT, split=[{"corners": 1}]),
    "counted": cut(parallel={"normal": [0, 1, 0], "count": 1}),
    "radial": cut(radial={"count": 2}),
    "angles": cut(radial={"angles": [0]}),
    "along": cut(along={"path": [[-40, 0, 0], [40, 0, 0]], "count": 2}),
    "base": held("base", UPRIGHT, height=-6),
    "base pair": held("base", UPRIGHT, height=-6, gap=6),
    "rings": held("rings"),
    "ring pair": held("rings", gap=6),
    "frame": held("frame"),
    "fixtures": held("fixtures"),
    "stand": held("stand"),
    "bulb": revolved(rings="card-200gsm", holes={"bulb": 30, "screws": 2, "circle": 60}),
    "pair": pair(),
    "even pair": pair(scale=2, second={"spline": [[x, -y] for x, y in ARCH], "degree": 4}),
    "thin": pair(least_thickness=0.5),
}
"""Small designs, which the rows below change."""

PLATES = {
    "play": 0.6,
    "clearance": 0.3,
    "border": 20,
    "strips": "S1",
    "thickness": 3.4,
    "sheet_size": [400, 300],
    "margin": 9,
}

ROWS = [
    (
        "design",
        "arch",
        "",
        {
            "sheet": "pom-0.5",
            "max_width": 17,
            "style": {"kind": "perforated", "width": 24},
            "limits": {"curvature": 0.014},
            "gravity": True,
            "loads": [{"at": 20, "force": [0, -0.001]}],
            "between": [{"kind": "rail", "at": 60}],
            "supports!": ["clamped", "pinned"],
            "natural_curvature": 0.001,
            "samples": 151,
            "ends": {"length": 14},
            "engrave": "XYZ",
            "smooth": 0.5,
            "thickness": 0.35,
            "length": 150,
            "name": "other",
            "shop!": {"stock": [100, 100]},
            "creep": 0.5,
            "tolerance": {"clamps": 0.5},
            "patterns": [{"repeat": {"count": 2, "step": [0, 0, 100]}}],
            "nest": {"margin": 7},
            "cut": {"kerf": 0.3},
            "extras": {"coupon": True},
            "language": "de",
            "fixtures": {"wall": 3},
            "rings": MDF,
            "frame": MDF,
            "stand": MDF,
            "schema!": 2,
            "revolution": revolved()["revolution"],
            "strips": [{"curve": EVEN}],
            "sheets_file!": "none.toml",
            "base": MDF | {"height": 10},
        },
    ),
    ("design", "loop", "", {"seam_position": 12}),
    ("design", "pair", "", {"pair": pair(scale=1.1)["pair"]}),
    ("design", "straight start", "", {"straight_ends!": False}),
    ("design", "slot", "", {"compensate": True}),
    ("design", "limits", "", {"min_width": 19.5, "keep": {"length": True}}),
    ("design", "thickness", "", {"section": {"kind": "rod", "limits": [0.5, 3]}}),
    ("design", "stock", "", {"ignore_limits!": True}),
    ("design", "named", "", {"let": {"w": 15}}),
    ("design", "felt", "", {"sheets": {"felt": FELT | {"thickness_mm": 0.4}}}),
    ("design", "crossing", "", {"interlock": {"clearance": 0.3}}),
    (
        "strip",
        "arch",
        "strips.0",
        {
            "curve": HUMP,
            "slots": [{"at": 90, "width": 1.2, "depth": 4}],
            "label": "Q",
            "count": 2,
            "origin": [3, 0, 0],
            "x_axis": [0, 1, 0],
            "y_axis": [0, 1, 0],
        },
    ),
    ("strip", "named", "strips.0", {"let": {"w": 15}, "split": 2}),
    ("strip", "dome", "strips.0", {"sections": MESH | {"radial": {"count": 2}}}),
    ("style plain", "arch", "style", {"kind!": "perforated"}),
    (
        "style perforated",
        "perforated",
        "style",
        {
            "width": 26,
            "columns": 3,
            "rows": 12,
            "hole_ratio!": 0.02,
            "least_ligament": 1.9,
            "least_hole": 3,
            "corner_radius": 0.2,
            "sides": "arc",
        },
    ),
    (
        "style laminated",
        "laminated",
        "style",
        {"width": 26, "backing": "pom-0.5", "least_backing!": 23, "dots": 1.5},
    ),
    (
        "limits",
        "limits",
        "limits",
        {
            "ratio": 1.05,
            "margin": 60,
            "curvature": 0.014,
            "strain": 0.001,
            "width": [19.5, 20],
            "length": [240, 300],
            "keep_out": [{"point": [0, 50], "normal": [0, -1]}],
            "stiffness_bounds": {"upper": 1.05},
        },
    ),
    (
        "keep",
        "wall",
        "keep",
        {
            "ends": False,
            "tangents": True,
            "length": True,
            "symmetry": "mirror",
            "points": [30],
            "line": [[0, 0], [1, 0]],
        },
    ),
    ("gravity", "gravity", "gravity", {"length": 120, "direction": [0, 1]}),
    ("point mass", "mass", "loads.0", {"at": 60, "mass": 3}),
    ("point force", "force", "loads.0", {"at": 60, "force": [0.001, 0]}),
    (
        "weight",
        "weight",
        "loads",
        {"alpha": 3e-5, "beta": 1e-5, "masses": [{"at": 30, "mass": 1}], "own": False},
    ),
    ("element rail", "rail", "between.0", {"at": 70, "one_sided": False}),
    ("element pin", "pin", "between.0", {"at": 70, "hole": 3, "notch": 3}),
    ("element tie", "tie", "between.0", {"start": 20, "end": 150, "hole": 2, "notch": 2}),
    (
        "blank",
        "blank",
        "natural_curvature",
        {"curvatures": [0.001, 0.003, 0.001], "stations": [0, 120, 211.22]},
    ),
    (
        "drawn blank",
        "drawn blank",
        "natural_curvature",
        {"curve": HUMP | {"spline": [[x, -y] for x, y in HUMP["spline"]]}},
    ),
    (
        "tab",
        "tab",
        "ends",
        {
            "length": 20,
            "width": 9,
            "corner_radius": 1,
            "chamfer": 2,
            "taper": 3,
            "holes": [{"at": 5, "diameter": 2}],
            "t_slot": {"depth": 9, "screw": 2.2, "nut": [4, 2], "wall": 2},
        },
    ),
    ("tslot", "slotted tab", "ends.t_slot", {"depth": 8, "screw": 3, "nut": [5, 2], "wall": 2.5}),
    ("hole", "hole", "ends.holes.0", {"at": 6, "diameter": 3, "across": 2}),
    ("fabrication limits", "arch", "shop", {"least_width!": 19.9, "stock!": [100, 100]}),
    ("fabrication limits", "perforated", "shop", {"least_ligament!": 3}),
    ("fabrication limits", "rings", "shop", {"least_bridge!": 90}),
    ("fabrication limits", "spliced", "shop", {"lap": 45}),
    ("section thickness", "thickness", "section", {"limits": [0.2, 1], "width": 25}),
    ("section rod", "rod", "section", {"limits": [0.5, 2]}),
    ("section tube", "tube", "section", {"limits": [0.5, 2], "bore": 0.3}),
    ("section leaves", "leaves", "section", {"leaves": 2, "width": 25, "fewest": 2}),
    (
        "making tolerance",
        "grainy",
        "tolerance",
        {"thickness_wave": 0.09, "grain": "degrees", "clamps": 0.2, "kerf": 1, "modulus": 0.5},
    ),
    (
        "own sheet",
        "felt",
        "sheets.felt",
        {
            "thickness_mm": 0.4,
            "youngs_modulus_MPa": 3000,
            "density_kg_m3": 900,
            "max_strain": 0.01,
            "kerf_mm": 0.3,
            "poisson_ratio": 0.3,
            "grain": "along",
            "kind!": "rod",
            "source": "me",
            "thickness_range_mm": [0.28, 0.32],
            "youngs_modulus_range_MPa": [1500, 2500],
            "density_range_kg_m3": [500, 900],
            "max_strain_range": [0.01, 0.03],
            "least_width_mm!": 19.9,
            "least_ligament_mm": 3,
            "least_bridge_mm": 4,
            "stock_mm!": [100, 90],
            "shear_modulus_MPa": 100,
            "break_strain": 0.004,
            "nominal_poisson_ratio": 0.45,
        },
    ),
    ("own sheet", "kerf", "sheets.felt", {"kerf_mm": 0.3, "kerf_range_mm": [0.1, 0.5]}),
    (
        "interlock",
        "crossing",
        "interlock",
        {"clearance": 0.3, "fit": "paper", "relief": "round", "above": [0, 0, -1]},
    ),
    (
        "nesting",
        "arch",
        "nest",
        {"sheet_size": [300, 200], "margin": 9, "grain": "height", "edge": False, "price": [12, 1]},
    ),
    (
        "cutting",
        "arch",
        "cut",
        {
            "for": "service",
            "marks": False,
            "kerf": 0.4,
            "curves": "polyline",
            "version": "R12",
            "colors": "boxes",
            "stroke": 0.01,
            "holding": {"width": 0.4},
        },
    ),
    ("cutting", "arcs", "cut", {"tolerance": 0.5}),
    ("holding tabs", "arch", "cut.holding", {"width": 0.5, "spacing": 50, "least": 3, "inner": True}),
    ("extras", "arch", "extras", {"coupon": True, "reference_bar": 70, "pages": "A3"}),
    ("mirror pattern", "arch", "patterns.0", {"mirror": {"point": [0, -9, 0], "normal": [0, 1, 0]}}),
    ("rotate pattern", "arch", "patterns.0", {"rotate": {"count": 3, "point": [200, 0, 0]}}),
    ("repeat pattern", "arch", "patterns.0", {"repeat": {"count": 2, "step": [0, 90, 0]}}),
    ("mirror", "patterns", "patterns.0.mirror", {"point": [0, -12, 0], "normal": [0, 1, 0.1], "keep": False}),
    (
        "rotate",
        "rotated",
        "patterns.0.rotate",
        {"count": 4, "axis": [0, 0.1, 1], "point": [220, 0, 0], "step": 1.0},
    ),
    ("repeat", "repeated", "patterns.0.repeat", {"count": 3, "step": [0, 80, 0]}),
    (
        "curve of file",
        "id",
        "strips.0.curve",
        {"id": "b", "file!": "two.json", "unit!": "cm", "reshape": {"top_left": [0, 90]}},
    ),
    ("curve of file", "layer", "strips.0.curve", {"layer": "M"}),
    ("curve of file", "number", "strips.0.curve", {"number": 2}),
    (
        "curve of formulae",
        "formulae",
        "strips.0.curve",
        {
            "x": "1.1 * t",
            "y": "0.009 * t * (90 - t)",
            "t": [0, 80],
            "breaks": [[40, 0]],
            "reshape": {"top_left": [0, 30]},
        },
    ),
    (
        "curve of ellipse",
        "arch",
        "strips.0.curve",
        {"ellipse": EVEN["ellipse"], "reshape": {"top_left": [-90, 62]}},
    ),
    (
        "ellipse arc",
        "arch",
        "strips.0.curve.ellipse",
        {"semi_axes": [80, 60], "center": [5, 0], "rotation": 0.2, "start": 0.5, "end": 2.5},
    ),
    ("ellipse arc", "above", "strips.0.curve.ellipse", {"above": 25}),
    (
        "curve of spline",
        "nurbs",
        "strips.0.curve",
        {
            "spline": [[0, 0], [20, 30], [50, 44], [80, 30], [100, 0]],
            "knots": [0, 0, 0, 0, 0.5, 1, 1, 1, 1],
            "weights": [1, 1, 1.2, 1, 1],
            "reshape": {"top_left": [0, 42]},
        },
    ),
    ("curve of spline", "hump", "strips.0.curve", {"degree": 3}),
    (
        "reshape",
        "corners",
        "strips.0.curve.reshape",
        {"bottom_left": [5, 0], "bottom_right": [95, 0], "top_right": [95, 40], "top_left": [0, 45]},
    ),
    (
        "reshape",
        "handles",
        "strips.0.curve.reshape",
        {"handles": [[0, 0], [100, 0], [100, 50], [0, 40]], "to": [[0, 0], [110, 0], [100, 44], [0, 40]]},
    ),
    (
        "slot",
        "slot",
        "strips.0.slots.0",
        {"at": 80, "width": 2, "depth": 6, "side": "lower", "lean": 0.3, "relief": "round", "mate": "B"},
    ),
    ("half plane", "wall", "limits.keep_out.0", {"point": [0, 45], "normal": [0.2, -1]}),
    ("box", "box", "limits.keep_out.0", {"lower": [-10, 50], "upper": [40, 90]}),
    (
        "bounds along strip",
        "bounds",
        "limits.stiffness_bounds",
        {"lower": [1, 1, 1.06, 1, 1, 1, 1], "upper": 1.05},
    ),
    (
        "sections",
        "dome",
        "strips.0.sections",
        {
            "mesh!": "none.obj",
            "unit!": "cm",
            "scale": 0.5,
            "half": True,
            "split": [{"corners": 1}],
            "tolerance": 1,
            "wavelength": 30,
            "parallel": CUT | {"offsets": [20]},
            "radial!": {},
            "along!": {"path": [[0, 0, 0], [1, 0, 0]]},
        },
    ),
    ("sections", "domes", "strips.0.sections", {"longest": True}),
    (
        "parallel cuts",
        "dome",
        "strips.0.sections.parallel",
        {"normal": [1, 0, 0], "offsets": [0, 20], "point": [0, 10, 0], "up": [1, 0, 0]},
    ),
    ("parallel cuts", "counted", "strips.0.sections.parallel", {"count": 2}),
    (
        "radial cuts",
        "radial",
        "strips.0.sections.radial",
        {"count": 3, "point": [0, 5, 0], "axis": [0, 0.1, 1], "zero": [0, 1, 0]},
    ),
    ("radial cuts", "angles", "strips.0.sections.radial", {"angles": [0.2]}),
    (
        "along path",
        "along",
        "strips.0.sections.along",
        {"path": [[-50, 0, 0], [40, 0, 0]], "count": 3, "ends": True, "up": [0, 1, 0]},
    ),
    ("plane split", "split dome", "strips.0.sections.split.0", {"point": [30, 0, 0], "normal": [1, 0, 0.2]}),
    ("point split", "points of dome", "strips.0.sections.split.0", {"points": [[50, 0, 60]]}),
    ("corner split", "corners of dome", "strips.0.sections.split.0", {"corners": 0.001}),
    (
        "revolution",
        "points",
        "revolution",
        {
            "sheet": "pom-0.5",
            "points": [*POINTS[:2], [125, 50], *POINTS[3:]],
            "length": 150,
            "strips": 14,
            "thickness": 0.3,
            "ends": {"length": 9},
            "style!": {"kind": "perforated", "width": 24},
            "engrave": "A",
            "compensate": True,
            "creep": 0.5,
            "gravity": True,
            "loads": [{"at": 20, "force": [0.001, 0]}],
            "shop!": {"stock": [100, 100]},
            "rings": "card-200gsm",
        },
    ),
    ("revolution", "falling", "revolution", {"ring": 100}),
    ("revolution", "unlimited", "revolution", {"ignore_limits!": True}),
    (
        "revolution",
        "profile",
        "revolution",
        {"smooth": 0.5, "axis_x": 10, "curve": PROFILE | {"reshape": {"top_left": [72, 120]}}},
    ),
    ("revolution", "axis", "revolution", {"axis": {"spline": [[9, 0], [9, 40], [9, 80]], "degree": 2}}),
    (
        "revolution",
        "equation",
        "revolution",
        {"a": 0.3, "b": [0, 0.012], "start": [65, 0], "angle": 1.1, "length": 80},
    ),
    ("revolution", "ringed", "revolution", {"gap": 9, "border": 9, "holes": {"bulb": 40}}),
    ("revolution", "paired", "revolution", {"spacers": 3}),
    (
        "base",
        "base",
        "base",
        PLATES
        | {
            "slot_width": 3,
            "shape": "rectangle",
            "ends": "start",
            "name": "foot",
            "height": -4,
            "gap": 6,
            "feet": 9,
            "holes": {"bulb": 20},
            "sheet": "hdf-1.5",
        },
    ),
    ("base", "base pair", "base", {"spacers": 3}),
    (
        "rings",
        "rings",
        "rings",
        PLATES
        | {
            "shape": "hull",
            "ends": "start",
            "name": "foot",
            "gap": 6,
            "feet": 9,
            "holes": {"bulb": 20},
            "sheet": "hdf-1.5",
        },
    ),
    ("rings", "ring pair", "rings", {"spacers": 3}),
    (
        "frame of plates",
        "frame",
        "frame",
        PLATES | {"ribs": 2, "depth": 30, "tongue": 11, "gap": 6, "feet": 9, "sheet": "hdf-1.5"},
    ),
    (
        "fixtures",
        "fixtures",
        "fixtures",
        {
            "clearance": 0.3,
            "wall": 5,
            "foot": 30,
            "foot_height": 6,
            "screw": 4,
            "strips": "S1",
            "floor": -70,
            "ends": "start",
        },
    ),
    (
        "named stand",
        "stand",
        "stand",
        {
            "thickness": 3.4,
            "sheet_size": [400, 300],
            "margin": 9,
            "name": "foot",
            "strips": "S1",
            "sheet": "hdf-1.5",
        },
    ),
    (
        "plate holes",
        "bulb",
        "revolution.holes",
        {"bulb": 22, "bridge": 12, "screws": 3, "screw": 3, "circle": 46, "side": "top"},
    ),
    (
        "flexure spec",
        "pair",
        "pair",
        {
            "first!": HUMP,
            "second!": HUMP,
            "sheet": "pom-2",
            "scale": 1.1,
            "match!": "shape",
            "smooth": 0.4,
            "limits!": {"ratio": 1.01},
            "free!": "first",
            "least_thickness": 1.2,
            "pad": {"length": 30},
            "fillet": 1.5,
            "push_at": 60,
            "label": "CLIP",
            "first_state": "open",
            "second_state": "shut",
        },
    ),
    ("flexure spec", "even pair", "pair", {"objective": "ratio"}),
    ("flexure spec", "thin", "pair", {"ignore_limits!": True, "printed!": True}),
    ("pair limits", "pair", "pair.limits", {"ratio!": 1.01, "natural_curvature!": 1e-5, "bend!": 1e-5}),
    ("pad", "pair", "pair.pad", {"length": 30, "width": 14, "hole": 3, "inset": 4}),
]
"""Table of the keys, design, place of the table in it, and a value of each key with which it acts.

A key with a ! acts by a refusal, or in a design that is refused without it.
"""

OWN = {
    (table, key.rstrip("!")): (name, path, key, value)
    for table, name, path, keys in ROWS
    for key, value in keys.items()
}


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """Folder with the files that the designs name."""
    folder = tmp_path_factory.mktemp("designs")
    write_curves([PlaneCurve.arc((0, 0), radius, 0.2, 2.0) for radius in (50, 60)], folder / "two.json")
    bow = '<path id="{0}" fill="none" stroke="black" d="M 0 {1} C 10 {2} 60 {2} 90 {1}"/>'
    layer = '<g id="{0}" inkscape:groupmode="layer" inkscape:label="{0}">{1}</g>'
    layers = layer.format("L", bow.format("a", 50, 20)) + layer.format("M", bow.format("b", 80, 60))
    (folder / "two.svg").write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" '
        f'width="100mm" height="100mm" viewBox="0 0 100 100">{layers}</svg>'
    )
    points, faces = dome()
    (folder / "dome.obj").write_text(obj_text(points, faces))
    small = obj_text(points / 2 + (300, 0, 0), faces + len(points))
    (folder / "domes.obj").write_text(f"{obj_text(points, faces)}\n{small}")
    return folder


def changed(design, path, value):
    """A copy of a design with a value at a dotted path. Missing tables and lists of one table are made."""
    design = inner = copy.deepcopy(design)
    steps = [int(step) if step.isdigit() else step for step in path.split(".")]
    for step, after in pairwise(steps):
        if isinstance(step, str):
            inner = inner.setdefault(step, [{}] if isinstance(after, int) else {})
        else:
            inner = inner[step]
    inner[steps[-1]] = value
    return design


def model_answer(design, folder, *, effects):
    """What a design of strips or of a surface of revolution makes, as data."""
    requested = design_of(design, folder / "design.toml", read_curves)
    model, kit = requested.model(), requested.kit
    contents = kit_contents(model, kit, entries=requested.entries, effects=effects)
    placed = [
        (place.strip.rod.curve.control_points, place.frame.origin, place.frame.axes) for place in model.placed
    ]
    nests = [
        (nest.name, nest.sheet_size, nest.counts, nest.share, len(nest.paths)) for nest in contents.nests
    ]
    pieces = [(piece.name, piece.count, piece.sheet, piece.drawing) for piece in contents.pieces]
    cutting = kit.cutting.options(model.strips[0].sheet) | {
        "for": kit.cutting.recipient,
        "name": kit.cutting.file_name("", "dxf"),
    }
    ranges = [strip.sheet for strip in model.strips]
    report = {key: value for key, value in contents.report.items() if key not in ("versions", "schema")}
    return (
        report,
        model.name,
        placed,
        nests,
        pieces,
        cutting,
        kit.pages,
        kit.language,
        [vars(block) for block in contents.blocks],
        ranges,
        str(contents.cut_list),
    )


FILES = {
    "workshop": {},
    "old": {"version": "R12"},
    "arcs": {"curves": "arc"},
    "service": {"for": "service"},
    "splines": {"for": "service", "curves": "spline"},
}
"""Tables `cut` for different lines in the files."""

WITHOUT_EFFECT = {"marks": ("service", "splines"), "tolerance": ("workshop", "splines")}
"""Tables of `FILES` beside which a key is refused, because it would not change the files."""


def files_of(design, folder):
    """The bytes of the cutting files of the only strip of a design, or the text of its refusal."""
    requested = read(design, folder)
    if isinstance(requested, str):
        return requested
    (strip,), cutting = requested.model().strips, requested.kit.cutting
    files = cutting_files(strip.drawing(), "strip", cutting, strip.sheet)
    return {file.name: file.write(folder / file.name).read_bytes() for file in files}


@pytest.mark.parametrize("key", sorted(TABLES["cutting"]))
@pytest.mark.parametrize("cut_for", FILES)
def test_a_key_of_the_cutting_files_changes_them_or_is_refused(cut_for, key, tmp_path):
    """The strip has guide lines at its tabs."""
    design = changed(DESIGNS["tab"], "cut", FILES[cut_for] | {"kerf": 0.2})
    (tmp_path / "after").mkdir()
    before = files_of(design, tmp_path)
    after = files_of(changed(design, f"cut.{key}", OWN["cutting", key][3]), tmp_path / "after")
    assert key in FILES[cut_for] or after != before
    assert not isinstance(before, str)
    assert ("has no effect without" in after) == (cut_for in WITHOUT_EFFECT.get(key, ()))


def pair_answer(design, folder):
    """What a design of a part with two states makes, as data."""
    spec = pair_of(design, folder / "design.toml", read_curves)
    part = spec.make()
    return (
        part.drawing(),
        part.holder(),
        part.sheet,
        part.label,
        part.state_labels,
        part.push_at,
        part.solid,
        cutting_of(design),
    )


def answer(design, folder, *, effects=False):
    """A digest of what a design makes, or the text of its refusal."""
    try:
        with read_below(folder, folder):
            made = (
                pair_answer(design, folder)
                if "pair" in design
                else model_answer(design, folder, effects=effects)
            )
    except ElasticaError as refused:
        return str(refused)
    return hashlib.sha256(pickle.dumps(made)).digest()


@pytest.fixture(scope="module")
def base(folder):
    """Function that returns the answer of a design of `DESIGNS`, computed once."""
    known = {}

    def answer_of(name, *, effects):
        if (name, effects) not in known:
            known[name, effects] = answer(DESIGNS[name], folder, effects=effects)
        return known[name, effects]

    return answer_of


def test_every_declared_key_has_a_row():
    shared = {(table, key) for table in ("strip",) for key in SHARED}
    chosen = {(table, "kind") for table in TABLES if " " in table}  # the other tables of a family choose it
    wanted = {(table, key) for table, keys in TABLES.items() for key in keys} - shared - chosen
    assert sorted(wanted - set(OWN)) == []
    assert sorted(set(OWN) - {(table, key) for table, keys in TABLES.items() for key in keys}) == []


SLOW = ("flexure spec", "pair limits", "pad")
"""Tables of a part with two states, whose path from one state to the other takes a second."""


@pytest.mark.parametrize(
    ("table", "key"),
    [pytest.param(*row, marks=pytest.mark.campaign if row[0] in SLOW else ()) for row in OWN],
)
def test_a_key_acts(table, key, base, folder):
    name, path, marked, value = OWN[table, key]
    effects = table == "making tolerance" or (key == "tolerance" and table == "design")
    before = base(name, effects=effects)
    after = answer(changed(DESIGNS[name], f"{path}.{key}".strip("."), value), folder, effects=effects)
    assert after != before
    refused = [text for text in (before, after) if isinstance(text, str)]
    assert bool(refused) == marked.endswith("!"), refused
    assert not any("unknown key" in text or "no effect" in text for text in refused)


MAKING = {
    "strips": ("arch", "a surface of revolution"),
    "revolution": ("points", "a surface of revolution"),
    "pair": ("pair", "a part with two states"),
}
"""Design with one maker of each kind, and the name of the other maker in messages."""

VALUES = {key: OWN["design", key][3] for key in SHARED}


def read(design, folder):
    """Request of a design, or the text of its refusal."""
    try:
        with read_below(folder, folder):
            if "pair" in design:
                return pair_of(design, folder / "design.toml", read_curves)
            return design_of(design, folder / "design.toml", read_curves)
    except InputError as refused:
        return str(refused)


@pytest.mark.parametrize("key", SHARED)
@pytest.mark.parametrize("maker", MAKERS)
def test_a_key_at_the_top_acts_on_a_maker_or_is_refused(maker, key, folder):
    """It is the same at the top and in the maker's own table."""
    name, called = MAKING[maker]
    design, path = copy.deepcopy(DESIGNS[name]), {"strips": "strips.0"}.get(maker, maker)
    own = changed(design, f"{path}.{key}", VALUES[key])
    if key == "sheet" and maker != "strips":
        del design[maker]["sheet"]
    at_top = changed(design, key, VALUES[key])
    top, below = read(at_top, folder), read(own, folder)
    if maker not in makers_using(key):
        assert f"{key} has no effect on {called}. Leave out {key}." in top
        assert f"unknown key {key!r}" in below or key == "limits"
    elif isinstance(top, str):
        assert key in top
        assert isinstance(below, str)
    elif maker == "pair":
        assert top == below
    else:
        assert repr(top.revolution) == repr(below.revolution)
        assert [entry.spec for entry in top.entries] == [entry.spec for entry in below.entries]


@pytest.mark.parametrize("key", [key for key in SHARED if "revolution" not in makers_using(key)])
def test_a_note_names_the_maker_that_does_not_use_a_key(key, folder):
    name = {"section": "thickness", "seam_position": "loop"}.get(key, "arch")
    value = {"supports": ["clamped", "clamped"], "max_width": 20}.get(key, VALUES[key])
    both = changed(DESIGNS[name] | revolved(), key, value)
    if key == "section":
        both.pop("max_width", None)
    listed = [
        text for text in read(both, folder).reports if "have no effect on a surface of revolution" in text
    ]
    assert len(listed) == 1
    assert key in listed[0]


def test_a_strip_with_a_section_leaves_the_widths_to_the_others(folder):
    """A key that another key of the same table replaces is used by the other strips alone."""
    design = strips(ARC, ARC, max_width=20)
    design["strips"][1] |= {
        "section": {"kind": "thickness", "limits": [0.1, 3], "width": 20},
        "ends": {"length": 9},
    }
    made = read(design, folder)
    assert [entry.spec.max_width for entry in made.entries] == [20, None]
    assert any("no effect on strips[2]: max_width" in text for text in made.reports)


@pytest.mark.parametrize(
    ("design", "place"),
    [
        (
            strips(max_width=20, section={"kind": "rod", "limits": [0.5, 3]}),
            "max_width has no effect beside section",
        ),
        (changed(DESIGNS["dome"], "strips.0.count", 2), "count has no effect beside sections"),
        (changed(DESIGNS["dome"], "length", 90), "length has no effect beside sections"),
        (changed(DESIGNS["points"], "revolution.gap", 9), "gap has no effect without rings"),
        (changed(DESIGNS["points"], "revolution.angle", 1), "angle has no effect without a"),
        (changed(DESIGNS["rings"], "rings.spacers", 3), "spacers has no effect without gap"),
        (changed(DESIGNS["thickness"], "compensate", True), "compensate has no effect beside section"),
        (
            changed(DESIGNS["thickness"], "style", {"kind": "perforated", "width": 24}),
            "style has no effect beside section",
        ),
        (
            changed(DESIGNS["thickness"], "strips.0.slots", [{"at": 90, "width": 1}]),
            "slots has no effect beside section",
        ),
        (
            changed(DESIGNS["arch"], "cut", {"tolerance": 0.02}),
            "tolerance has no effect without curves = arc or polyline",
        ),
        (
            changed(DESIGNS["arch"], "cut", {"marks": True, "for": "service"}),
            "marks has no effect without for = workshop",
        ),
        (changed(DESIGNS["pair"], "nest", {}), "nest has no effect on a part with two states"),
        (
            changed(changed(DESIGNS["pair"], "pair.free", "second"), "pair.objective", "ratio"),
            "objective has no effect beside free",
        ),
        (
            changed(DESIGNS["pair"], "strips", [{"curve": ARC}]),
            "strips has no effect on a part with two states",
        ),
        (changed(DESIGNS["pair"], "sheet", 5), "sheet is 5"),
        (changed(DESIGNS["pair"], "schema", 2), "schema is 2"),
        (changed(DESIGNS["arch"], "name", "x" * 61), "at most 60 characters"),
    ],
)
def test_a_key_of_a_kind_that_is_not_chosen_is_refused(design, place, folder):
    assert place in read(design, folder)


def test_a_part_with_two_states_has_no_guide_lines_to_leave_out():
    with pytest.raises(InputError, match="unknown key 'marks'"):
        cutting_of({"cut": {"marks": False}})


@pytest.mark.parametrize(
    ("name", "path"),
    [
        ("equation", "revolution.angle"),
        ("angles", "strips.0.sections.radial.angles.0"),
        ("grainy", "tolerance.grain"),
        ("grainy", "tolerance.clamps"),
    ],
)
def test_a_number_of_degrees_is_not_taken_for_radians(name, path, folder):
    refused = read(changed(DESIGNS[name], path, 30), folder)
    assert "30" in refused
    assert refused.endswith("in rad")
    assert not isinstance(read(changed(DESIGNS[name], path, "30*degrees"), folder), str)
