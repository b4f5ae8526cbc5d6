"""The JSON schema of design files and their reader take and refuse the same, in an editor's own checker."""

import copy
import json
import re
import subprocess
import sysconfig
import tomllib
from pathlib import Path

import pytest

from elastica_cad import InputError, PlaneCurve, read_curves, write_curves
from elastica_cad.design import read_design
from elastica_cad.design.design_schema import SCHEMA_FILE, design_schema, tables
from elastica_cad.design.pair_table import read_pair
from tests.dome import dome, obj_text

ROOT = Path(__file__).resolve().parents[3]
TABLES = tables()
TAPLO = Path(sysconfig.get_path("scripts")) / "taplo"

HEAD = 'schema = 1\nsheet = "card-200gsm"\nmax_width = 20\n'
ARC = "curve.ellipse = { semi_axes = [90, 60], start = 0.2, end = 2.9 }\n"
ONE = HEAD + "[[strips]]\n" + ARC
SPLIT = (
    HEAD
    + '[[strips]]\n[strips.sections]\nmesh = "dome.obj"\nparallel = { normal = [0, 1, 0], offsets = [0] }\n'
)
DESIGNS = [
    ONE.replace("[[", """
name = "all"
language = "de"
length = 200
thickness = 0.3
min_width = 2
gravity = true
supports = ["clamped", "pinned"]
natural_curvature = 0
ends.length = 12
ends.width = 9
ends.corner_radius = 1
ends.chamfer = 0
ends.taper = 0
ends.holes = [{ at = 5, diameter = 2, across = 0 }]
smooth = 0
shop = { least_width = 1, least_ligament = 0.5, least_bridge = 1, stock = [900, 600], lap = 40 }
tolerance = { thickness_wave = 0.02, grain = "degrees", clamps = 0.01, kerf = 0.1, modulus = 0.2 }
compensate = false
engrave = ""
straight_ends = false
creep = 0.1
ignore_limits = true
[let]
a = "2 * 3"
[limits]
ratio = 9
margin = 1
curvature = 1
strain = true
length = [10, 900]
width = [1, 30]
keep_out = [{ point = [0, -90], normal = [0, 1] }, { lower = [500, 0], upper = [600, 9] }]
stiffness_bounds = { lower = 1, upper = [9, 9] }
[keep]
ends = true
tangents = [true, false]
length = false
points = [30]
line = [[0, 0], [1, 0]]
[interlock]
clearance = 0.1
fit = "paper"
relief = "round"
above = [0, 0, 1]
[nest]
sheet_size = [600, 400]
margin = 2
grain = "height"
edge = false
price = [12.5, 0.8]
[cut]
for = "workshop"
marks = false
colors = "boxes"
stroke = 0.01
kerf = "sheet"
curves = "arc"
tolerance = 0.05
version = "R12"
holding = { width = 0.4, spacing = 90, least = 2, inner = true }
[extras]
pages = "A4"
coupon = true
reference_bar = 80
[[patterns]]
mirror = { point = [0, 0, 0], normal = [1, 0, 0], keep = true }
[[patterns]]
rotate = { count = 3, axis = [0, 0, 1], point = [0, 0, 0], step = "30 * degrees" }
[[patterns]]
repeat = { count = 2, step = [0, 0, 100] }
[[strips]]
label = "T{i}"
engrave = "No. 7"
length = 120
count = 2
let = { v = "i" }
origin = ["v", 0, 0]
x_axis = [1, 0, 0]
y_axis = [0, 0, 1]
slots = [{ at = 40, width = 1.2, depth = 4, side = "upper", lean = 0, relief = "square", mate = "B" }]
[strips.curve]
spline = [[0, 0], [20, 30], [50, 40], [80, 30], [100, 0]]
degree = 4
reshape = { handles = [[0, 0], [9, 0], [9, 9], [0, 9]], to = [[0, 0], [9, 0], [9, 8], [0, 9]] }
[["""),
    HEAD + '[keep]\nsymmetry = "mirror"\nline = true\n[[strips]]\ngravity = [0, 0, -1]\n'
    "ends = [{ length = 5 }, { length = 14, width = 20, "
    "t_slot = { depth = 9, screw = 2.2, nut = [4, 2], wall = 2 } }]\n"
    'curve = { file = "one.json", number = 1, unit = "mm", reshape = { bottom_left = [0, 0], '
    "bottom_right = [90, 0], top_right = [90, 50], top_left = [0, 40] } }\n",
    HEAD + '[[strips]]\ncurve = "one.json"\ngravity = { length = 90, direction = [0, -1] }\n'
    "loads = { alpha = 0.001, beta = 0, own = true, masses = [{ at = 9, mass = 1 }] }\n",
    ONE + "loads = [{ at = 30, mass = 2 }]\ngravity = true\n",
    ONE + 'between = [{ at = 30, one_sided = false }, { kind = "rail", at = 20 }, { kind = "pin", at = 60 }, '
    '{ kind = "tie", start = 10, end = 70 }]\nloads = [{ at = 40, force = [0, -0.001] }]\n',
    ONE + 'between = [{ kind = "pin", at = 60, hole = 2, notch = 0 }, { kind = "tie", start = 10, end = 70, '
    "hole = 0, notch = 2 }]\n",
    ONE + "limits = { strain = 0.01 }\nkeep = { ends = [true, false], tangents = true }\n",
    HEAD + '[[strips]]\ncurve = { file = "two.svg", id = "a" }\nsplit = 2\n',
    HEAD + '[[strips]]\ncurve = { file = "two.svg", layer = "L" }\n',
    HEAD + "[[strips]]\ncurve = { x = 't', y = '0.01 * t * (90 - t)', t = [0, 90], breaks = [[40, 3]] }\n",
    ONE + "natural_curvature = { stations = [0, 50, 50, 211], curvatures = [0, 0.001, 0.002, 0] }\n",
    ONE + "natural_curvature.curve.spline = [[0, 0], [60, 20], [130, 30], [170, 26], [204, 20]]\n",
    HEAD + "[[strips]]\ncurve = { spline = [[0, 0], [20, 30], [50, 40], [80, 30], [100, 0]], degree = 3, "
    "knots = [0, 0, 0, 0, 0.4, 1, 1, 1, 1], weights = [1, 1, 2, 1, 1] }\n",
    HEAD + "[[strips]]\ncurve.ellipse = { center = [0, 9], semi_axes = [90, 60], rotation = 0.1, above = 0 }\n",
    ONE.replace("2.9 }", "6.483185307179586 }") + 'style = { kind = "plain" }\nseam_position = 10\n',
    ONE.replace("max_width = 20\n", "") + 'section = { kind = "thickness", limits = [1, 3], width = 20 }\n',
    ONE.replace("max_width = 20\n", "") + 'samples = 201\nsection = { kind = "rod", limits = [1, 3] }\n',
    ONE.replace("max_width = 20\n", "") + 'section = { kind = "tube", limits = [1, 3], bore = 0.5 }\n',
    ONE.replace("max_width = 20\n", "")
    + 'limits = { ratio = 30 }\nsection = { kind = "leaves", leaves = 4, fewest = 2, width = 20 }\n',
    ONE + 'style = { kind = "perforated", width = 24, columns = 2, rows = 9, hole_ratio = 0.8, '
    'least_ligament = 0.6, least_hole = 1, corner_radius = 0, sides = "arc" }\n',
    ONE + 'style = { kind = "laminated", width = 24, backing = "card-200gsm", least_backing = 1, dots = 1 }\n',
    SPLIT.replace("offsets = [0]", "offsets = [0, 20], point = [0, 0, 0], up = [0, 0, 1]")
    + 'unit = "mm"\nhalf = false\nlongest = true\nsplit = [{ corners = 1 }, { points = [[0, 0, 80]] }, '
    "{ point = [0, 0, 0], normal = [1, 0, 0] }]\ntolerance = 0.3\nwavelength = 5\n",
    SPLIT.replace("offsets = [0]", "count = 2") + "scale = 0.5\nsplit = { corners = 1 }\n",
    SPLIT.replace("parallel = { normal = [0, 1, 0], offsets = [0] }",
                  "radial = { point = [0, 0, 0], axis = [0, 0, 1], zero = [1, 0, 0], angles = [0.1, 1] }"),
    SPLIT.replace("parallel = { normal = [0, 1, 0], offsets = [0] }", "radial = { count = 2 }"),
    SPLIT.replace("parallel = { normal = [0, 1, 0], offsets = [0] }",
                  "along = { path = [[-40, 0, 0], [40, 0, 0]], count = 2, ends = true, up = [0, 0, 1] }"),
    ONE.replace("card-200gsm", "felt").replace("[[", """
sheets_file = "more.toml"
[sheets.felt]
thickness_mm = 1
youngs_modulus_MPa = 20
density_kg_m3 = 300
max_strain = 0.1
break_strain = 0.2
kerf_mm = 0.2
poisson_ratio = 0.3
grain = "along"
kind = "felt"
source = "measured"
thickness_range_mm = [0.9, 1.1]
youngs_modulus_range_MPa = [15, 25]
density_range_kg_m3 = [250, 350]
max_strain_range = [0.08, 0.12]
kerf_range_mm = [0.1, 0.3]
least_width_mm = 2
least_ligament_mm = 1
least_bridge_mm = 2
stock_mm = [900, 600]
shear_modulus_MPa = 620
[["""),
    ONE.replace("card-200gsm", "felt").replace("[[", """
[sheets.felt]
thickness_mm = 1
youngs_modulus_MPa = 20
density_kg_m3 = 300
max_strain = 0.1
nominal_poisson_ratio = 0.3
[["""),
    ONE + """
[[base]]
strips = "S*"
sheet = "mdf-3"
thickness = 3.2
sheet_size = [600, 400]
margin = 3
height = 0
shape = "ring"
name = "foot"
ends = "start"
play = 0.4
clearance = 0.1
border = 9
gap = 10
spacers = 3
slot_width = 1
[[base]]
sheet = "mdf-3"
feet = 9
holes = { bulb = 29 }
[rings]
strips = ["S*"]
sheet = "mdf-3"
thickness = 3
sheet_size = [600, 400]
margin = 3
shape = "ring"
name = "ring"
ends = "end"
holes = { bulb = 29, bridge = 12, screws = 3, screw = 3.2, circle = 46, side = "top" }
play = 0.4
clearance = 0.1
border = 9
gap = 10
spacers = 3
[frame]
strips = "S*"
sheet = "mdf-3"
thickness = 3
sheet_size = [600, 400]
margin = 3
ribs = 2
depth = 15
tongue = 9
play = 0.4
clearance = 0.1
border = 9
gap = 10
feet = 9
[fixtures]
strips = "S*"
floor = -60
ends = "start"
clearance = 0.1
wall = 3
foot = 20
foot_height = 4
screw = 3.2
[stand]
name = "foot"
strips = "S*"
sheet = "mdf-3"
thickness = 3
sheet_size = [600, 400]
margin = 3
""",
    'schema = 1\n[revolution]\nsheet = "card-200gsm"\nthickness = 0.3\nstrips = 12\ngap = 9\nspacers = 3\n'
    "border = 6\nrings = 'card-200gsm'\nends = { length = 9 }\nholes = { bulb = 40 }\n"
    "shop = { least_width = 1 }\nignore_limits = true\na = 0.2\nb = [0, 0.01]\nstart = [60, 0]\n"
    "angle = 1.2\nlength = 90\nring = 10\n",
    'schema = 1\n[revolution]\nsheet = "card-200gsm"\n'
    'points = [[70, 0], [85, 16], [125, 55], [90, 115], [75, 140]]\n',
    'schema = 1\n[revolution]\nsheet = "card-200gsm"\n'
    'curve = { spline = [[70, 0], [90, 40], [95, 80], [80, 120]], degree = 3 }\naxis_x = 10\nsmooth = 0.5\n'
    'style = { kind = "perforated", width = 30 }\nengrave = "A"\ncompensate = true\ncreep = 0.5\ngravity = true\n'
    'loads = [{ at = 20, mass = 3 }]\n',
    'schema = 1\n[revolution]\nsheet = "card-200gsm"\n'
    'curve = { spline = [[70, 0], [90, 40], [95, 80], [80, 120]], degree = 3 }\n'
    'axis = { spline = [[10, 0], [10, 45], [10, 90]], degree = 2 }\n',
    """schema = 1
[pair]
first = { spline = [[0, 0], [60, 40], [120, 0]], degree = 2 }
second = { spline = [[0, 0], [60, -30], [120, 0]], degree = 2 }
sheet = "pom-3"
objective = "ratio"
""",
    """schema = 1
[pair]
first = { spline = [[0, 0], [27, 0], [53, 24], [105, 24], [123, 0], [150, 0]], degree = 4 }
second = { spline = [[0, 0], [27, 0], [53, -20], [105, -20], [123, 0], [150, 0]], degree = 4 }
sheet = "pom-3"
match = "ends"
scale = 1.1
smooth = 0.1
free = "first"
least_thickness = 1.0
fillet = 1.5
push_at = 70
printed = true
label = "CLIP"
ignore_limits = true
first_state = "open"
second_state = "closed"

[pair.limits]
ratio = 8
natural_curvature = 0.05
bend = 0.05

[pair.pad]
length = 20
width = 12
hole = 4.3
inset = 5
""",
]  # fmt: skip

WRONG = {"wrong": [True]}
"""No key has such a value."""


def reference(fragment):
    return fragment["$ref"].removeprefix("#/definitions/") if "$ref" in fragment else None


def fits(fragment, value):
    """Is this what the value was meant as? Tables are told by their keys."""
    if "anyOf" in fragment:
        return any(fits(one, value) for one in fragment["anyOf"])
    if (name := reference(fragment)) is not None:
        kinds = TABLES[name].get("kind", ({},))[0].get("enum")
        return (
            isinstance(value, dict)
            and set(value) <= set(TABLES[name])
            and (not kinds or value.get("kind", kinds[0]) in kinds)
        )
    return (
        isinstance(value, list)
        and fragment.get("type") == "array"
        and all(fits(fragment["items"], one) or not isinstance(one, dict) for one in value)
    )


def keys_in(fragment, value, path=()):
    """Every key that stands in a design, as (table, key, place); tables themselves with None for the key."""
    if "anyOf" in fragment:
        for one in fragment["anyOf"]:
            if fits(one, value):
                yield from keys_in(one, value, path)
                return
    elif (name := reference(fragment)) is not None:
        yield name, None, path
        for key, inner in value.items():
            yield name, key, (*path, key)
            yield from keys_in(TABLES[name][key][0], inner, (*path, key))
    elif fragment.get("type") == "array" and isinstance(value, list):
        for i, one in enumerate(value):
            yield from keys_in(fragment["items"], one, (*path, i))
    elif isinstance(fragment.get("additionalProperties"), dict) and isinstance(value, dict):
        for key, one in value.items():
            yield from keys_in(fragment["additionalProperties"], one, (*path, key))


def changed(data, path, value):
    """A copy with another value in that place."""
    data = copy.deepcopy(data)
    inner = data
    for step in path[:-1]:
        inner = inner[step]
    inner[path[-1]] = value
    return data


def as_toml(value):
    if isinstance(value, dict):
        return "{" + ", ".join(f"{json.dumps(key)} = {as_toml(one)}" for key, one in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(as_toml(one) for one in value) + "]"
    return json.dumps(value)


def written(data):
    return f"#:schema {SCHEMA_FILE}\n" + "".join(f"{key} = {as_toml(one)}\n" for key, one in data.items())


@pytest.fixture
def folder(tmp_path):
    """Where designs lie: with their schema, and the files that they name."""
    (tmp_path / SCHEMA_FILE).write_text(json.dumps(design_schema()))
    write_curves([PlaneCurve.arc((0, 0), 50, 0.2, 2.0)], tmp_path / "one.json")
    bow = '<path id="{0}" fill="none" stroke="black" d="M 0 {1} C 10 {2} 60 {2} 90 {1}"/>'
    (tmp_path / "two.svg").write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" '
        'width="100mm" height="100mm" viewBox="0 0 100 100">'
        '<g id="L" inkscape:groupmode="layer" inkscape:label="L">'
        f"{bow.format('a', 50, 20)}</g>{bow.format('b', 80, 60)}</svg>"
    )
    (tmp_path / "more.toml").write_text(
        "[sheets.more]\nthickness_mm = 1\nyoungs_modulus_MPa = 20\ndensity_kg_m3 = 300\nmax_strain = 0.1\n"
    )
    (tmp_path / "dome.obj").write_text(obj_text(*dome()))
    return tmp_path


def refused_by_editor(folder):
    """Names of the designs that taplo, which editors ask, does not take."""
    done = subprocess.run(
        [TAPLO, "lint", *sorted(one.name for one in folder.glob("d-*.toml"))],
        cwd=folder, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert "schema" in done.stderr or not done.returncode, done.stderr
    # its threads write into each other's lines, so files are known by their names alone
    return set(re.findall(r"d-[^/\s\":]+\.toml", done.stderr))


def read(path, data):
    """What a file asks for: a model, or a part with two states."""
    return read_pair(path, read_curves) if "pair" in data else read_design(path, read_curves)


def test_reader_and_editor_agree_on_every_key(folder):
    designs = [tomllib.loads(text) for text in DESIGNS]
    root = {"$ref": "#/definitions/design"}
    message, mutants = {}, {}
    for i, data in enumerate(designs):
        (folder / f"d-{i}.toml").write_text(written(data))
        read(folder / f"d-{i}.toml", data)
        for name, key, path in keys_in(root, data):
            if (name, key) in message:
                continue
            message[name, key] = path
            other = changed(data, (*path, "zzz"), 1) if key is None else changed(data, path, WRONG)
            mutants[f"d-{name.replace(' ', '-')}-{key}.toml"] = other
    request = {id(TABLES[name][key]) for name, key in message if key is not None}  # tables share entries
    assert [
        (name, key) for name, keys in TABLES.items() for key in keys if id(keys[key]) not in request
    ] == []
    assert set(TABLES) == {name for name, _ in message}
    assert refused_by_editor(folder) == set()
    read_anyway = []
    for name, data in mutants.items():
        (folder / name).write_text(written(data))
        try:
            read(folder / name, data)
        except InputError:
            continue
        read_anyway.append(name)
    assert read_anyway == []
    assert set(mutants) - refused_by_editor(folder) == set()


def test_templates_examples_and_pages_are_valid(folder):
    texts = [path.read_text() for path in (ROOT / "elastica_cad" / "cli" / "templates").glob("*.toml")]
    assert all(text.startswith(f"#:schema {SCHEMA_FILE}\n") for text in texts)
    texts += [path.read_text() for path in (ROOT / "examples").rglob("*.toml")]
    for page in (ROOT / "docs").rglob("*.md"):
        for block in page.read_text(encoding="utf-8").split("```")[1::2]:
            body = block.partition("\n")[2].lstrip()
            if "toml" in block.partition("\n")[0] and "schema = 1" in body:
                texts.append(body)
    for i, text in enumerate(texts):
        line = "" if text.startswith("#:schema") else f"#:schema {SCHEMA_FILE}\n"
        (folder / f"d-{i}.toml").write_text(line + text)
    assert len(texts) > 5
    assert refused_by_editor(folder) == set()
