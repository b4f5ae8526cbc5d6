"""Design files: what they mean, and one clear sentence for each thing that is wrong in them."""

import tomllib

import numpy as np
import pytest

from elastica_cad import (
    InputError,
    Laminated,
    NotRealizable,
    Perforated,
    PlaneCurve,
    load_sheets,
    read_curves,
    read_model,
    write_curves,
)
from elastica_cad.design import read_design
from elastica_cad.design.records import parsed_line
from elastica_cad.design.tables import Slips
from elastica_cad.design.toml_text import toml_text
from elastica_cad.files import read_surface
from elastica_cad.kit.kit_contents import kit_contents
from elastica_cad.model import rocking_tabs
from elastica_cad.web.answers import answer

ARC = "curve.ellipse = { semi_axes = [90, 60], start = 0.2, end = 2.9 }"
HEAD = 'schema = 1\nsheet = "card-200gsm"\nmax_width = 20\n'


@pytest.fixture
def read(tmp_path):
    def of(text):
        path = tmp_path / "design.toml"
        path.write_text(text)
        return read_design(path, read_curves)

    return of


def test_defaults_stand_for_all_strips_and_can_be_changed(read):
    design = read(
        HEAD + f"ends.length = 8\n[[strips]]\n{ARC}\n[[strips]]\n{ARC}\n"
        'sheet = "birch-plywood-0.8"\nmax_width = "2 * 15"\nends = [{ length = 5 }, { length = 7, width = 24 }]\n'
    )
    first, second = design.model().strips
    assert (first.sheet.name, first.max_width, [tab.length for tab in first.ends]) == (
        "card-200gsm",
        20,
        [8, 8],
    )
    assert second.sheet.name == "birch-plywood-0.8"
    assert second.max_width == 30
    assert [(tab.length, tab.width) for tab in second.ends] == [(5, None), (7, 24)]
    assert (first.label, second.label, design.name) == ("S1", "S2", "design")


def test_the_former_key_of_a_section_is_still_read(read):
    rod, bar = 'kind = "rod", limits = [2, 5]', 'kind = "thickness", limits = [1, 4], width = 20'
    text = f'sheet = "pom-1"\nKEY = {{ {rod} }}\n[[strips]]\n{ARC}\n[[strips]]\n{ARC}\nKEY = {{ {bar} }}\n'
    now, before = (
        [entry.spec.section for entry in read(text.replace("KEY", key)).entries] for key in ("section", "law")
    )
    assert now == before
    assert [section.quantity for section in now] == ["diameter", "thickness"]
    assert answer({"do": "strip", "design": {"sheet": "pom-1", "law": {"kind": "rod", "limits": [2, 5]}, "strips": [
        {"curve": {"spline": [[0, 0], [60, 90], [140, 90], [200, 0]], "degree": 3}}]}})["length"] > 200  # fmt: skip
    with pytest.raises(InputError, match="unknown key 'law'; did you mean section"):
        read(text.replace("KEY", "section") + f"law = {{ {bar} }}\n")


def test_curves_get_the_length_of_the_design_or_their_own(read):
    spline = "curve = { spline = [[10, 20], [40, 80], [90, 90], [140, 20]], degree = 3 }"
    alone = read(HEAD + f"[[strips]]\n{spline}\n").entries[0].curve
    design = read(HEAD + f"length = 240\n[[strips]]\n{ARC}\n[[strips]]\n{spline}\nlength = '2 * 100'\n")
    first, second = (entry.curve for entry in design.entries)
    assert (first.length, second.length) == (pytest.approx(240), pytest.approx(200))
    assert second.control_points[0] == pytest.approx([10, 20])
    scale = 200 / alone.length
    turned = np.ptp(second.control_points, axis=0) / np.ptp(alone.control_points, axis=0)
    assert turned == pytest.approx([scale, scale])
    assert design.model().strips[1].rod.ratio == pytest.approx(
        read(HEAD + f"[[strips]]\n{spline}\n").model().strips[0].rod.ratio
    )
    with pytest.raises(InputError, match=r"length: the length of the curve is -3\.0"):
        read(HEAD + f"length = -3\n[[strips]]\n{ARC}\n")


def test_counted_strips_have_formulae_of_their_own(read):
    design = read(
        HEAD + '[let]\nradius = 100\nturn = "30 * degrees"\n[[strips]]\ncount = 3\nlabel = "R{i}"\n'
        'let = { v = "turn * (i - 1)" }\norigin = ["radius * cos(v)", "radius * sin(v)", 5]\n'
        'x_axis = ["cos(v)", "sin(v)", 0]\ncurve.ellipse = { semi_axes = ["50 + 5 * i", 40], end = "pi" }\n'
    )
    assert [entry.label for entry in design.entries] == ["R1", "R2", "R3"]
    third = design.entries[2]
    assert third.frame.origin == pytest.approx([50, 100 * np.sin(np.pi / 3), 5])
    assert third.curve.evaluate(third.curve.domain[0]) == pytest.approx([65, 0])


def test_what_is_engraved_is_each_strips_own(read):
    """Strips that are made alike are made once, and each has its own text."""
    marked = f"[[strips]]\nlabel = 'A'\n{ARC}\n[[strips]]\nlabel = 'B'\nengrave = 'No. 7'\n{ARC}\n"
    assert [strip.engraved for strip in read(HEAD + marked).model().strips] == ["A", "No. 7"]


def test_an_ellipse_above_the_ground_ends_on_it(read):
    design = read(
        HEAD
        + "[[strips]]\ncurve.ellipse = { center = [3, 20], semi_axes = [75, 112.5], rotation = 0.7, above = 1 }\n"
    )
    (entry,) = design.entries
    assert entry.frame.origin.tolist() == [0, 0, 0]
    ends = entry.curve.evaluate(np.array(entry.curve.domain))
    assert ends[:, 1] == pytest.approx([1, 1], abs=1e-9)
    inside = entry.curve.sample(101).position[1:-1]
    assert inside[:, 1].min() > 1
    c, s = np.cos(0.7), np.sin(0.7)
    x, y = ((inside - (3, 20)) @ np.array([[c, -s], [s, c]])).T
    assert (x / 75) ** 2 + (y / 112.5) ** 2 == pytest.approx(np.ones(99))


def test_curves_from_formulae_follow_them(read):
    design = read(
        HEAD
        + '[[strips]]\nlet.r = 40\ncurve = { x = "r * cos(t)", y = "r * sin(t) + where(t < 1, 0, (t - 1)**3)", '
        't = [0.1, "pi - 0.2"], breaks = [[1, 2]] }\n'
    )
    (entry,) = design.entries
    t = np.linspace(0.1, np.pi - 0.2, 400)
    truth = np.column_stack([40 * np.cos(t), 40 * np.sin(t) + np.where(t < 1, 0, (t - 1) ** 3)])
    assert np.abs(entry.curve.evaluate(t) - truth).max() < 1e-5


def test_curves_from_files_and_control_points(read, tmp_path):
    arc = PlaneCurve.arc((0, 0), 50, 0.2, 2.0)
    write_curves([arc, PlaneCurve.arc((0, 0), 60, 0.2, 2.0)], tmp_path / "two.json")
    write_curves([arc], tmp_path / "one.json")
    design = read(
        HEAD + '[[strips]]\ncurve = "one.json"\n[[strips]]\ncurve = { file = "two.json", number = 2 }\n'
        '[[strips]]\ncurve = { spline = [[0, 0], [20, "15 * 2"], [50, 40], [80, 30], [100, 0]] }\n'
    )
    lengths = [entry.curve.length for entry in design.entries]
    assert lengths[:2] == pytest.approx([90, 108])
    assert design.entries[2].curve.degree == 4


def test_gravity_falls_in_space(read):
    design = read(
        HEAD + f"gravity = true\n[[strips]]\n{ARC}\n[[strips]]\ny_axis = [0, 1, 0]\n{ARC}\n"
        f"[[strips]]\ngravity = [0, 1, 0]\ny_axis = [0, 1, 0]\n{ARC}\n"
        f'[[strips]]\ny_axis = [0, "sin(30 * degrees)", "cos(30 * degrees)"]\n{ARC}\n'
    )
    upright, lying, sideways, leaning = (entry.spec.gravity_in_plane for entry in design.entries)
    assert upright.direction == (0, -1)
    assert lying is None
    assert sideways.direction == (0, 1)
    assert leaning.e == pytest.approx(upright.e * np.cos(np.pi / 6))


def test_limits_make_a_nearest_rod(read):
    wave = "spline = [[0, 0], [40, 90], [80, 20], [120, -70], [170, 0], [200, 60]]"
    hill = 'x = "50 * t", y = "40 * sin(t) + 6 * t ** 1.6", t = [0.1, 7.8]'
    with pytest.raises(NotRealizable, match=r"^hill: "):
        read(HEAD + f'[[strips]]\nlabel = "hill"\ncurve = {{ {hill} }}\n').model()
    text = HEAD + f"limits = {{ ratio = 3.0 }}\nkeep = {{ ends = true }}\n[[strips]]\ncurve = {{ {wave} }}\n"
    (strip,) = read(text).model().strips
    assert strip.rod.ratio <= 3.0 + 1e-6


def test_styles(read):
    design = read(
        HEAD.replace("max_width = 20\n", "")
        + f'[[strips]]\nstyle = {{ kind = "perforated", width = 24, columns = 2 }}\n{ARC}\n'
        f'[[strips]]\nstyle = {{ kind = "laminated", width = 20, backing = "card-200gsm" }}\n{ARC}\n'
        "[[strips]]\ngravity = true\n"
        f'style = {{ kind = "laminated", width = 20, backing = "card-200gsm" }}\n{ARC}\n'
    )
    model = design.model()
    kinds = [type(strip.style) for strip in model.strips]
    assert kinds == [Perforated, Laminated, Laminated]
    assert [piece.name for piece in model.pieces] == ["S1", "S2", "S2-backing", "S3", "S3-backing"]
    assert model.strips[2].rod.ratio != pytest.approx(model.strips[1].rod.ratio, rel=1e-3)


def test_patterns_are_cut_once(read):
    design = read(
        HEAD + f"[[strips]]\n{ARC}\norigin = [200, 0, 0]\n"
        "[[patterns]]\nrotate = { count = 5 }\n[[patterns]]\nrepeat = { count = 2, step = [0, 0, 100] }\n"
        "[[patterns]]\nmirror = { point = [1000, 0, 0], normal = [1, 0, 0] }\n"
    )
    model = design.model()
    assert len(model.placed) == 20
    assert [piece.count for piece in model.pieces] == [20]


@pytest.mark.parametrize("sign", ["\\n", "\\u202e", "\\u2028"])
def test_a_refused_label_is_named_in_one_line(read, sign):
    with pytest.raises(InputError) as refused:
        read(HEAD + f'[[strips]]\n{ARC}label = "a{sign}b"\n')
    assert str(refused.value).isprintable()


def test_own_sheets_extras_and_base(read):
    sheet = (
        "[sheets.felt]\nthickness_mm = 1\nyoungs_modulus_MPa = 20\ndensity_kg_m3 = 300\nmax_strain = 0.1\n"
    )
    design = read(
        HEAD.replace("card-200gsm", "felt") + "nest.sheet_size = [500, 300]\n"
        f"[[strips]]\n{ARC}\n{sheet}[extras]\ncoupon = true\nreference_bar = 80\n"
        '[base]\nsheet = "mdf-3"\nheight = 11\nsheet_size = [900, 400]\n[cut]\nkerf = "sheet"\n'
    )
    assert design.entries[0].sheet.name == "felt"
    assert [piece.name for piece in design.kit.extras(design.model())] == ["coupon", "reference-bar"]
    assert design.kit.cutting.kerf is None
    assert design.kit.nesting.sheet_size == (500, 300)
    (base,), _ = design.kit.holders[0].made(design.model())
    assert base.frame.origin[2] == 11
    assert len(base.slots) == 2
    assert design.kit.holders[0].nesting.sheet_size == (900, 400)


def test_frames_and_fixtures(read):
    design = read(
        HEAD
        + f"ends.length = 16\n[[strips]]\ncount = 3\nlabel = 'F{{i}}'\norigin = [0, '50 * i', 0]\n{ARC}\n"
        "[frame]\nsheet = 'mdf-3'\nribs = 2\ndepth = 15\n[fixtures]\nwall = 3\nfloor = -60\n"
    )
    model = design.model()
    plates, fixtures = (holder.made(model)[0] for holder in design.kit.holders)
    assert [plate.name for plate in plates] == ["rail-start", "rail-end", "rib-1", "rib-2"]
    assert [fixture.engrave for fixture in fixtures] == ["F1:1", "F1:2", "F2:1", "F2:2", "F3:1", "F3:2"]
    assert all(fixture.wall == 3 and fixture.floor.origin[2] == -60 for fixture in fixtures)


RIB = "curve.spline = [[60, 0], [90, 60], [90, 120], [60, 180]]\ncurve.degree = 3\n"
AROUND = (
    "[[strips]]\ncount = 6\nlabel = 'R{i}'\nlet.t = '60 * i * degrees'\nx_axis = ['cos(t)', 'sin(t)', 0]\n"
    f"y_axis = [0, 0, 1]\n{RIB}"
)


@pytest.mark.parametrize(
    ("asked", "wanted"),
    [
        ("[base]\nsheet = 'mdf-3'\ngap = 10\n", ["base", "base-lower"]),
        ("[rings]\nsheet = 'mdf-3'\nends = 'start'\ngap = 10\n", ["ring", "ring-outer"]),
        (
            "[base]\nsheet = 'mdf-3'\nfeet = 8\n",
            ["base", "foot-S1-1a", "foot-S1-1b", "foot-S1-2a", "foot-S1-2b"],
        ),
    ],
)
def test_holders_that_leave_a_leaning_tab_no_angle(read, asked, wanted):
    design = read(
        HEAD + "ends = { length = 30 }\n[[strips]]\nsheet = 'birch-plywood-0.8'\ny_axis = [0, 0, 1]\n"
        "curve.ellipse = { semi_axes = [80, 60], start = -0.5, end = 3.6 }\norigin = [0, 0, 28]\n" + asked
    )
    model = design.model()
    holders, _ = design.kit.holders[0].made(model)
    assert [holder.name for holder in holders] == wanted
    assert not rocking_tabs(model.placed, holders)


def test_rings_and_bases_for_some_of_the_strips(read):
    design = read(
        HEAD + f"ends.length = 12\n{AROUND}[rings]\nsheet = 'hdf-1.5'\n"
        "[[base]]\nsheet = 'hdf-1.5'\nstrips = ['R1', 'R2', 'R3']\nends = 'start'\n"
        "[[base]]\nsheet = 'card-200gsm'\nstrips = 'R[456]'\nname = 'foot'\nshape = 'ring'\n"
    )
    model = design.model()
    plates = [plate for holder in design.kit.holders for plate in holder.made(model)[0]]
    assert [plate.name for plate in plates] == ["base-1", "foot", "ring-bottom", "ring-top"]
    assert [slot.name for slot in plates[0].slots] == ["R1:1", "R2:1", "R3:1"]
    assert [slot.name for slot in plates[2].slots] == [f"R{i}:1" for i in range(1, 7)]
    for ring in plates[2:]:
        inner, outer = ring.opening.bounds, ring.outline.bounds
        assert np.all(inner[0] > outer[0] + 16)
        assert np.all(inner[1] < outer[1] - 16)
        x, y = np.concatenate([slot.corners for slot in ring.slots]).T
        assert np.hypot(x, y).max() < outer[1].max() - 7.9
    (holder,) = read(HEAD + f"{AROUND}[rings]\nsheet = 'hdf-1.5'\nstrips = 'Q*'\n").kit.holders
    with pytest.raises(InputError, match=r"rings: there is no strip Q\*. Use one of R1, R2"):
        holder.made(model)


def test_bases_of_one_sheet_are_laid_on_the_same(read):
    options = (("left", "12", "hdf-1.5"), ("right", "34", "hdf-1.5"), ("back", "56", "card-200gsm"))
    tables = "".join(
        f"[[base]]\nsheet = '{sheet}'\nstrips = 'R[{which}]'\nends = 'start'\nname = '{name}'\n"
        for name, which, sheet in options
    )
    design = read(HEAD + f"ends.length = 12\n{AROUND}{tables}")
    kit = kit_contents(design.model(), design.kit)
    laid = {nest.name: list(nest.pieces) for nest in kit.nests[1:]}
    assert laid == {
        "design-left-right-nest-1-hdf-1.5": ["design-left", "design-right"],
        "design-back-nest-1-card-200gsm": ["design-back"],
    }
    roomy = tables.replace("name = 'left'", "name = 'left'\nsheet_size = [700, 400]")
    apart = read(HEAD + f"ends.length = 12\n{AROUND}{roomy}")
    assert [nest.name for nest in kit_contents(apart.model(), apart.kit).nests[1:]] == [
        "design-left-nest-1-hdf-1.5",
        "design-right-nest-1-hdf-1.5",
        "design-back-nest-1-card-200gsm",
    ]


@pytest.mark.parametrize(
    ("width", "apart"),
    [("max_width = 30", 50), ("style = { kind = 'perforated', width = 24 }", 44), ("min_width = 5", 20)],
)
def test_copies_of_a_part_without_places_are_20_mm_apart(read, width, apart):
    copies = f"[[strips]]\ncount = 3\nlabel = 'A'\n{ARC}\n"
    entries = read(f'schema = 1\nsheet = "card-200gsm"\n{width}\n{copies}').entries
    assert [entry.frame.origin[1] for entry in entries] == pytest.approx([0, -apart, -2 * apart])


def test_copies_with_different_labels_share_their_cuts(read):
    arches = f"[[strips]]\ncount = 2\nlabel = 'A{{i}}'\norigin = [0, '50 * i', 0]\n{ARC}\n"
    first, second = read(HEAD + arches).model().strips
    assert first.layers is second.layers
    assert (first.label, second.label) == ("A1", "A2")


def test_a_stand_is_the_simplest_holder_that_takes_all_tabs(read):
    arches = f"[[strips]]\ncount = 3\nlabel = 'A{{i}}'\norigin = [0, '50 * i', 0]\n{ARC}\n"
    turned = arches.replace("end = 2.9", "end = 2.9, rotation = '0.12 * i'")
    for strips, text, names in (
        (arches, "stands on one plate", ["base"]),
        (AROUND, "held by two plates", ["ring-bottom", "ring-top"]),
        (turned, "held by a slotted frame", ["rail-start", "rail-end", "rib-1", "rib-2", "rib-3"]),
    ):
        design = read(HEAD + f"ends.length = 9\n{strips}[stand]\nsheet = 'hdf-1.5'\n")
        plates, sentence = design.kit.holders[0].made(design.model())
        assert [plate.name for plate in plates] == names
        assert sentence.endswith(text)
    wave = "{x = 't', y = '40 * sin(t / 40)', t = [0, '80 * pi']}"  # one tab up, one down: a slot a plate
    alone = read(HEAD + f"ends.length = 9\n[[strips]]\ncurve = {wave}\n[stand]\nsheet = 'hdf-1.5'\n")
    blocks, sentence = alone.kit.holders[0].made(alone.model())
    assert len(blocks) == 2
    assert "printed blocks hold all ends" in sentence
    bare = read(HEAD + f"ends.length = 0\n{arches}[stand]\nsheet = 'hdf-1.5'\n")
    (holder,), model = bare.kit.holders, bare.model()
    with pytest.raises(InputError, match="strips without tabs cannot be held"):
        holder.made(model)


def test_equal_curves_are_solved_once(read):
    design = read(
        HEAD
        + "[[strips]]\ncount = 6\ncurve.ellipse = { semi_axes = [75, 90], rotation = 'pi * i', above = 5 }\n"
        'label = "E{i}"\n'
    )
    done = []
    strips = design.model(done.append).strips
    assert done == ["E1", "E2", "E3", "E4", "E5", "E6"]
    assert len({id(strip.rod) for strip in strips}) == 1
    assert [strip.label for strip in strips] == done


BAD = {
    "schema = 2": "schema is 2, but this version reads only schema 1",
    "schema = 1\nshet = 1": "unknown key 'shet'; did you mean sheet",
    "schema = 1\nstrips = 3": "strips is 3. Write a list of tables",
    "schema = 1": "has no strips",
    "schema = 1\n[[strips]]\ncolour = 1": r"strips\[1\]: unknown key 'colour'",
    "schema = 1\n[[strips]]\nfile = 'a.dxf'": r"strips\[1\]: unknown key 'file'; did you mean curve",
    "schema = 1\n[[strips]]\ncurve = 'x.dxf'": r"\(S1\): sheet is missing",
    HEAD + "[[strips]]": r"strips\[1\] \(S1\): curve is missing",
    HEAD + "[[strips]]\nlabel = 'A7'\ncurve = 'none.dxf'": r"\(A7\): curve: the file .*none\.dxf",
    HEAD + "[[strips]]\ncurve = { x = 't', y = 't * radius', t = [0, 1] }": "unknown name 'radius' at character 5",
    HEAD + "[[strips]]\ncurve = { x = 't', y = 'open(t)', t = [0, 1] }": "unknown function 'open' at character 1",
    HEAD + "[[strips]]\ncurve = { x = 't', t = [0, 1] }": "curve: y is missing. Add this key: formula in t",
    HEAD + "[[strips]]\ncurve = { x = 't', y = '0', t = [1, 0] }": "is not a range",
    HEAD + "[[strips]]\ncurve = {}": "needs exactly one of the keys 'file', 'x'",
    HEAD + "[[strips]]\ncurve.ellipse = { semi_axes = [1, 2], above = 3 }": "Choose a height between -2 and 2",
    HEAD + "[[strips]]\ncurve.ellipse = { semi_axes = [1, 2], above = 1, start = 1 }": "no effect beside above",
    HEAD + "[[strips]]\ncount = 2.5\n" + ARC: "count is 2.5. Use a whole number",
    HEAD + 2 * ("[[strips]]\nlabel = 'A'\n" + ARC + "\n"): "two strips have the label 'A'",
    HEAD + "[[strips]]\ncount = 2\nlabel = 'A'\nsmooth = 'i'\n" + ARC: "two strips have the label 'A'",
    HEAD + "[[strips]]\nx_axis = [0, 0, 1]\n" + ARC: r"strips\[1\] \(S1\): frame x_axis and y_axis",
    HEAD + "[[strips]]\norigin = [0, 0]\n" + ARC: "origin is .* Write 3 numbers",
    HEAD + "gravity = 'down'\n[[strips]]\n" + ARC: "gravity is 'down'. Write 3 numbers",
    HEAD + "supports = ['nailed', 'pinned']\n[[strips]]\n" + ARC: r"supports\[1\] is 'nailed'. Use one of clamped",
    HEAD + "style.kind = 'woven'\n[[strips]]\n" + ARC: "kind is 'woven'. Use one of plain",
    HEAD + "limits.ratio = 0.5\n[[strips]]\n" + ARC: "limits: ratio is 0.5: give a number from 1",
    HEAD + "ends.length = -1\n[[strips]]\n" + ARC: "ends: length is -1.0: give",
    HEAD + "let.a-b = 1\n[[strips]]\n" + ARC: "'a-b' is not a valid name",
    HEAD + "base.sheet = 'stone'\n[[strips]]\n" + ARC: "base: sheet: unknown sheet 'stone'",
    HEAD + "[[patterns]]\nspin = 1\n[[strips]]\n" + ARC: "unknown key 'spin'",
    HEAD + "cut.version = 'R99'\n[[strips]]\n" + ARC: "version is 'R99'. Use one of R12",
    HEAD + "[[strips]]\ncount = 1e6\n" + ARC: "count is 1000000, above the limit of 10000",
    HEAD + "min_width = 1e200\n[[strips]]\n" + ARC: "min_width is 1e.200. Use a finite number of at most 1e.09",
    HEAD + "min_width = nan\n[[strips]]\n" + ARC: "min_width is nan. Use a finite number",
    HEAD + f"let.a = {'9' * 400}\n[[strips]]\n" + ARC: "let.a is a whole number of many digits. Use",
    HEAD + "let.a = '10 ** 300'\n[[strips]]\n" + ARC: "let.a is 1e.300. Use a finite number",
    HEAD + "[[strips]]\nlabel = 'A'\ncurve.spline = [[0, 0], [50, 40], [100, 0]]\n": (
        r"design.toml: strips\[1\] \(A\): curve: 3 control points are too few for degree 4"
    ),
    "a = [": "is not a (valid )?TOML file",
    HEAD + "min_width = 2,5\n": "write decimals with a point, 2.5",
    HEAD + '[[strips]]\ncurve = "C:\\Users\\anna\\a.csv"\n': "write / in place of",
    HEAD + "[let.höhe]\n": "put names with letters beyond a-z in quotes",
}  # fmt: skip


@pytest.mark.parametrize("text", BAD)
def test_bad_designs_are_reported_in_one_sentence(read, text):
    with pytest.raises(InputError, match=BAD[text]) as caught:
        read(text)
    assert "design.toml" in str(caught.value)
    assert "\n" not in str(caught.value)


def test_missing_designs_are_reported(tmp_path):
    with pytest.raises(InputError, match="cannot be read"):
        read_design(tmp_path / "none.toml", read_curves)


def test_faults_of_a_strip_name_it(read):
    with pytest.raises(InputError, match=r"^thin: .*min_width"):
        read(HEAD + f"min_width = 19.9\n[[strips]]\nlabel = 'thin'\n{ARC}\n").model()


def test_faults_of_two_strips_are_reported_together(read):
    faults = "".join(f"[[strips]]\nlabel = '{name}'\nmin_width = 19.9\n{ARC}\n" for name in ("thin", "lean"))
    with pytest.raises(InputError, match=r"(?s)thin: .*min_width.*lean: .*min_width"):
        read(HEAD + faults).model()


DOME = 'sections = { mesh = "dome.obj", tolerance = 0.2, '


@pytest.fixture
def dome(tmp_path):
    """A half ellipsoid of 100, 100 and 80 mm, as triangles."""
    up, around = np.meshgrid(np.linspace(0, np.pi / 2, 41), np.linspace(0, 2 * np.pi, 81), indexing="ij")
    points = np.stack(
        [100 * np.cos(up) * np.cos(around), 100 * np.cos(up) * np.sin(around), 80 * np.sin(up)], -1
    )
    points[:, -1], points[-1] = points[:, 0], (0, 0, 80)  # the seam and the top close
    corner = (np.arange(40)[:, None] * 81 + np.arange(80)).ravel()
    faces = np.stack([corner, corner + 1, corner + 82, corner + 81], -1) + 1
    lines = [f"v {x} {y} {z}" for x, y, z in points.reshape(-1, 3)] + [
        f"f {a} {b} {c} {d}" for a, b, c, d in faces
    ]
    (tmp_path / "dome.obj").write_text("\n".join(lines))


def test_sections_of_a_mesh_become_strips(dome, read):
    head = HEAD + 'limits = { ratio = 20 }\nlet.span = "2 * 30"\n[[strips]]\nlabel = "D{i}"\n'
    design = read(head + DOME + 'parallel = { normal = [0, 1, 0], offsets = ["-span", 0, "span", 150] } }\n')
    assert [entry.label for entry in design.entries] == ["D1", "D2", "D3"]
    assert any("section 4" in text and "misses" in text for text in design.reports)
    for entry, y in zip(design.entries, (-60, 0, 60), strict=True):
        places = entry.frame.point(entry.curve.sample(50).position)
        assert places[:, 1] == pytest.approx(np.full(50, y))
        off = (places[:, 0] ** 2 + y**2) / 100**2 + (places[:, 2] / 80) ** 2
        assert off == pytest.approx(np.ones(50), abs=0.01)
    around = read(
        head + DOME + 'scale = 0.5, radial = { count = 3 } }\nlet.half = "i / 2"\nmax_width = "9 + half"\n'
    )
    assert [entry.spec.max_width for entry in around.entries] == [9.5, 10, 10.5]
    assert around.entries[1].frame.x_axis == pytest.approx([-0.5, np.sqrt(3) / 2, 0])
    assert around.entries[0].curve.length == pytest.approx(141.8 / 2, rel=0.01)
    bow = read(head + DOME + "along = { path = [[-40, 0, 0], [40, 0, 0]], count = 2, ends = true } }\n")
    assert [entry.frame.origin[0] for entry in bow.entries] == pytest.approx([-40, 40])
    model = read(head + DOME + "parallel = { normal = [0, 1, 0], offsets = [0, 150] } }\n").model()
    assert len(model.placed) == 1
    assert any("misses" in text for text in model.reports)


@pytest.mark.parametrize(
    ("wrong", "message"),
    [
        ('sections = { mesh = "none.obj", radial = {} }', "the file"),
        ('sections = { mesh = "dome.obj" }', "Add one of the keys 'radial', 'parallel' and 'along'"),
        (DOME + "radial = { axis = [0, 0, 0] } }", r"sections: axis"),
        (DOME + "parallel = { normal = [0, 0, 1], offsets = [] } }", "none is given"),
        (DOME + "radial = { count = 3, angles = [0, 1] } }", "count has no effect beside angles"),
        (DOME + "parallel = { normal = [0, 1, 0], offsets = [500] } }", "no plane gives a strip: .*misses"),
        (DOME + "parallel = { normal = [0, 0, 1], offsets = [20], up = [0, 1, 0] } }", "closed"),
        (DOME + "scale = 0, radial = {} }", "give a number above 0"),
        (DOME + "radial = {} }\ncount = 3", "count has no effect beside sections"),
        (DOME + "radial = { cuont = 3 } }", "did you mean count"),
        (
            DOME + "parallel = { normal = [0, 1, 0], count = 1e9 } }",
            "count is 1e.09, above the limit of 10000",
        ),
    ],
)
def test_sections_refuse_in_words(dome, read, wrong, message):
    with pytest.raises(InputError, match=message):
        read(HEAD + "[[strips]]\n" + wrong + "\n")


@pytest.mark.parametrize("wrong", ['origin = ["radius", 0, 0]', "ends = { length = 'radius' }"])
def test_the_place_is_named_once(read, wrong):
    with pytest.raises(InputError) as refused:
        read(HEAD + f"[[strips]]\n{wrong}\n{ARC}\n")
    assert str(refused.value).count("strips[1]") == 1


def test_files_are_read_below_the_folder_of_the_design(tmp_path, monkeypatch):
    """A design from elsewhere reads nothing of yours: no path, no link leads out, unless its folder is named."""
    home, secret = tmp_path / "from elsewhere", tmp_path / "yours"
    for folder in (home / "curves", secret):
        folder.mkdir(parents=True)
        (folder / "arch.csv").write_text("".join(f"{x},{0.02 * x * (90 - x):.3f}\n" for x in range(0, 91, 5)))
    (secret / "mine.toml").write_text("no sheets")
    (home / "link.csv").symlink_to(secret / "arch.csv")
    monkeypatch.chdir(home)
    design = home / "design.toml"

    def request_of(lines, **options):
        design.write_text(HEAD + f"[[strips]]\n{lines}\n")
        return read_design(design, read_curves, **options)

    assert request_of('curve = "curves/arch.csv"').entries
    for path in ("../yours/arch.csv", str(secret / "arch.csv"), "link.csv", "curves/../../yours/arch.csv"):
        with pytest.raises(
            InputError, match=r"is outside .*from elsewhere, but a design reads only files in"
        ):
            request_of(f'curve = "{path}"')
        assert request_of(f'curve = "{path}"', below=[secret]).entries
    with pytest.raises(InputError, match="is outside"):
        request_of('curve = "curves/arch.csv"\nsheet = "../yours/mine.toml"')
    monkeypatch.chdir(tmp_path)
    assert request_of('curve = "../yours/arch.csv"').entries


def test_a_pipe_is_no_file(tmp_path):
    import os

    os.mkfifo(tmp_path / "arch.csv")
    with pytest.raises(InputError, match="is a device or a pipe, not a file"):
        read_curves(tmp_path / "arch.csv")


def test_all_slips_are_reported():
    slips = Slips()
    for number in range(12):
        slips.add(f"strip {number}: " + "an unknown key of the curve; " * 12 + "leave it out")
    assert [f"strip {number}: " in slips.text for number in range(12)] == [True] * 12
    assert slips.text.count(" Also: ") == 11


def test_a_key_in_capitals_is_reported_as_it_is_written(tmp_path):
    design = tmp_path / "loud.toml"
    design.write_text('SCHEMA = 1\nSHEET = "card-200gsm"\n' + "z" * 400 + " = 1\n")
    with pytest.raises(
        InputError, match=r"'SCHEMA'; did you mean schema\?.*'SHEET'; did you mean sheet"
    ) as result:
        read_design(design, read_curves)
    assert "z" * 61 not in str(result.value)


def test_a_design_of_a_windows_editor_is_read(tmp_path):
    """A byte order mark before the first line, and line ends of two bytes: `Invalid statement (at line 1 ...)`."""
    design = tmp_path / "design.toml"
    text = HEAD + "[[strips]]\n" + ARC
    design.write_bytes(b"\xef\xbb\xbf" + text.replace("\n", "\r\n").encode())
    assert len(read_design(design, read_curves).entries) == 1
    design.write_bytes(text.encode("utf-16"))
    with pytest.raises(InputError, match="Save it as UTF-8 text"):
        read_design(design, read_curves)


def test_lists_nested_a_thousand_deep_are_refused(tmp_path):
    """They had ended in a traceback."""
    path = tmp_path / "deep.toml"
    path.write_text("a = " + 1000 * "[" + 1000 * "]")
    with pytest.raises(InputError, match="nests lists or tables too deep"):
        read_design(path, read_curves)
    path.write_text("[sheets.a]\nkerf_mm = " + 1000 * "[" + 1000 * "]")
    with pytest.raises(InputError, match="nests lists or tables too deep"):
        load_sheets(path)
    with pytest.raises(InputError, match=r"cannot be read\. Write keys and values"):
        parsed_line("at = " + 1000 * "[" + 1000 * "]", "--slot")


def test_dates_are_quoted_as_the_file_has_them(tmp_path):
    path = tmp_path / "dates.toml"
    path.write_text("schema = 1\nsheet = 2020-01-02\n[[strips]]\n")
    with pytest.raises(InputError, match="sheet is 2020-01-02"):
        read_design(path, read_curves)


def test_a_count_of_strips_with_one_label_is_so_many_of_the_same_part(read):
    design = read(HEAD + "[[strips]]\ncount = 6\nlabel = 'S'\n" + ARC)
    (part,) = design.model().parts
    assert (part.name, len(part.members)) == ("S", 6)
    places = [placed.frame.origin for placed in design.model().placed]
    assert np.linalg.norm(np.diff(places, axis=0), axis=1).min() >= 20  # they stand behind each other


def test_the_version_of_the_keys_may_be_left_out(tmp_path):
    (tmp_path / "arch.toml").write_text(
        'sheet = "card-200gsm"\nmax_width = 20\n[[strips]]\nlabel = "A"\n'
        "curve = { spline = [[0, 0], [30, 60], [70, 60], [100, 0]], degree = 3 }\n"
    )
    assert [strip.label for strip in read_model(tmp_path / "arch.toml").strips] == ["A"]


def test_the_name_of_a_curve_may_contain_the_number_of_the_strip(tmp_path):
    """One table takes rib1 and rib2 from a drawing, in this order."""
    arcs = "".join(
        f'<path id="rib{k}" d="M 0 0 C 20 -{height} 80 -{height} 100 0"/>' for k, height in ((2, 60), (1, 40))
    )
    size = 'width="100mm" height="100mm" viewBox="0 0 100 100"'
    (tmp_path / "ribs.svg").write_text(f'<svg xmlns="http://www.w3.org/2000/svg" {size}>{arcs}</svg>')
    (tmp_path / "ribs.toml").write_text(
        HEAD + '[[strips]]\ncount = 2\nlabel = "R{i}"\ncurve = { file = "ribs.svg", id = "rib{i}" }\n'
    )
    first, second = read_design(tmp_path / "ribs.toml", read_curves).entries
    assert (first.label, second.label) == ("R1", "R2")
    assert np.ptp(first.curve.bounds, axis=0)[1] == pytest.approx(30, rel=1e-3)
    assert np.ptp(second.curve.bounds, axis=0)[1] == pytest.approx(45, rel=1e-3)


@pytest.mark.parametrize("count", [3, 40])
def test_each_file_is_read_once(dome, tmp_path, count):
    """Curves, unloaded curves and meshes that several strips name are read from their files once."""
    arc = PlaneCurve.spline([(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)])
    for name in ("arch", "blank"):
        write_curves([arc], tmp_path / f"{name}.json")
    shared = f'count = {count}\ncurve = "arch.json"\nnatural_curvature.curve = "blank.json"\n'
    cuts = [f"{DOME}parallel = {{ normal = [0, 1, 0], offsets = [{y}] }} }}" for y in (5, 10)]
    tables = [*(f'label = "{name}{{i}}"\n{shared}' for name in "AB"), *cuts]
    (tmp_path / "many.toml").write_text(
        HEAD + "limits = {}\n" + "".join(f"[[strips]]\n{t}\n" for t in tables)
    )
    reads = []

    def noted(read):
        def reader(path, **options):
            reads.append(path.name)
            return read(path, **options)

        return reader

    design = read_design(tmp_path / "many.toml", noted(read_curves), noted(read_surface))
    assert len(design.entries) == 2 * count + 2
    assert sorted(reads) == ["arch.json", "blank.json", "dome.obj"]


@pytest.mark.parametrize(
    ("keys", "named"),
    [
        (r'curve = "rib\rib.svg"', r"curve: the file \"rib\rib.svg\""),
        (r'curve = { file = "a\new\bow.dxf" }', r"curve: the file \"a\new\bow.dxf\""),
        (
            rf'{ARC}{chr(10)}natural_curvature.curve = "x\f.csv"',
            r"natural_curvature: curve: the file \"x\f.csv\"",
        ),
        (r'sections = { mesh = "my\table.obj", radial = {} }', r"sections: the file \"my\table.obj\""),
        (rf'{ARC}{chr(10)}sheet = "lib\test.toml:felt"', r"sheet: the file \"lib\test.toml\""),
        (r"curve = 'rib\arch.svg'", r"curve: the file \"rib\\arch.svg\""),
    ],
)
def test_a_backslash_in_the_name_of_a_file_is_named(read, keys, named):
    with pytest.raises(InputError) as refused:
        read(f"{HEAD}[[strips]]\n{keys}\n")
    assert f"{named} does not exist. Write / in place of \\." in str(refused.value).replace('"', r"\"")


def test_a_backslash_in_the_name_of_a_file_of_sheets_is_named(read):
    with pytest.raises(
        InputError, match=r'sheets_file: the file "a\\nb\.toml" does not exist. Write / in place'
    ):
        read(f'sheets_file = "a\\nb.toml"\n{HEAD}[[strips]]\n{ARC}\n')


def test_a_table_is_read_as_written_whatever_characters_it_has():
    signs = "".join(map(chr, [*range(0x3000), 0xFEFF, 0x1F44D, 0x10FFFF]))
    table = {"name": signs, "strips": [{"label": "left", "curve": {signs: signs}}]}
    assert tomllib.loads(toml_text(table)) == table
