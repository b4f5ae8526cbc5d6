"""Surfaces of revolution in design files: a meridian by points, by a curve, by its constants."""

import re

import numpy as np
import pytest

import elastica_cad as ec
from elastica_cad import InputError, NotConvergedError
from elastica_cad.design import read_design
from elastica_cad.kit.kit_contents import kit_contents
from elastica_cad.translations import Translated

HEAD = 'schema = 1\nname = "vase"\nsheet = "card-200gsm"\n'
POINTS = "points = [[70, 0], [85, 16], [125, 55], [90, 115], [75, '100 + 40']]"


@pytest.fixture
def read(tmp_path):
    def written(text):
        path = tmp_path / "vase.toml"
        path.write_text(HEAD + text)
        return read_design(path, ec.read_curves)

    return written


def test_points_become_strips_and_rings(read):
    design = read(f"[revolution]\n{POINTS}\nstrips = 20\nrings = 'hdf-1.5'\n")
    assert design.reports == ()
    model = design.model()
    assert len(model.placed) == 20
    assert len(model.parts) == 1
    wanted = ec.meridian_through([(70, 0), (85, 16), (125, 55), (90, 115), (75, 140)])
    assert model.strips[0].rod.length == pytest.approx(wanted.curve.length)
    assert [plate.name for plate in model.plates] == ["ring-bottom", "ring-top"]
    pieces = kit_contents(model, design.kit).pieces
    assert [(piece.name, piece.count) for piece in pieces] == [
        ("strip 1", 20),
        ("ring-bottom", 1),
        ("ring-top", 1),
    ]


def test_a_gap_makes_two_rings_at_either_end(read):
    model = read(f"[revolution]\n{POINTS}\nstrips = 16\nrings = 'hdf-1.5'\ngap = 10\n").model()
    assert [plate.name for plate in model.plates] == [
        "ring-bottom", "ring-bottom-outer", "ring-top", "ring-top-outer",
    ]  # fmt: skip
    assert not ec.model.rocking_tabs(model.placed, model.plates)


@pytest.mark.parametrize(
    "ends", ["ends = { length = 27, width = 8 }\n", pytest.param("", marks=pytest.mark.campaign)]
)
def test_rings_that_are_too_small_for_inclined_tabs_get_the_least_opening(read, ends):
    def ball(radius, top=80):
        return read(
            "[revolution]\nsheet = 'polypropylene-0.6'\nrings = 'polypropylene-0.8'\nstrips = 16\ngap = 5\n"
            f"points = [[{radius}, 0], [100, 37], [120, 95], [114, 140], [{top}, 190]]\n{ends}"
        ).model()

    with pytest.raises(
        InputError, match="the load of the strip bends the tab of strip 1:1 too far"
    ) as refused:
        ball(55)
    assert "single plates" not in str(refused.value)
    new, top = re.search(
        r"the meridian to \((\d+), 0\) mm(?: and \((\d+), 190\))?", str(refused.value)
    ).groups()
    works = ball(new, top or 80)
    assert len(works.plates) == 4
    assert not ec.model.rocking_tabs(works.placed, works.plates)
    with pytest.raises(InputError):
        ball(int(new) - 1, int(top) - 1 if top else 80)


BODIES = {
    "egg": ("polypropylene-0.8", "mdf-3", 24, [[30, 0], [62, 35], [70, 75], [52, 125], [30, 165]]),
    "pear": ("polypropylene-0.8", "mdf-3", 12, [[15, 0], [75, 45], [68, 95], [40, 140], [15, 175]]),
    "bulb": (
        "birch-plywood-0.8",
        "birch-plywood-3",
        8,
        [[30, 0], [96, 120], [180, 255], [186, 375], [30, 495]],
    ),
}


@pytest.mark.parametrize("name", BODIES)
def test_each_change_that_a_refusal_suggests_for_rings_works(read, name):
    sheet, rings, count, points = BODIES[name]

    def body(points, count):
        return read(
            f"[revolution]\nsheet = '{sheet}'\nrings = '{rings}'\nstrips = {count}\npoints = {points}\n"
        ).model()

    with pytest.raises(InputError) as refused:
        body(points, count)
    problem, tested = str(refused.value).split("A tested change makes strips and rings possible: ")
    assert "Make the tab" not in problem
    places = [[float(x), float(y)] for x, y in re.findall(r"\(([\d.]+), ([\d.]+)\)", tested)]
    assert places
    old, new = places[: len(places) // 2], places[len(places) // 2 :]
    assert (
        len(body([new[old.index(point)] if point in old else point for point in points], count).plates) == 2
    )
    for fewer in re.findall(r"use (\d+) strips", tested):
        assert len(body(points, int(fewer)).plates) == 2


def test_tabs_that_meet_in_a_ring_can_be_left_to_the_program(read):
    lamp = (
        "[revolution]\nsheet = 'polypropylene-0.8'\nstrips = 9\nrings = 'mdf-3'\n"
        "points = [[50, 0], [75, 40], [90, 90], [75, 140], [50, 180]]\n"
    )
    with pytest.raises(InputError, match=r"rings possible: leave out ends") as refused:
        read(f"{lamp}ends = {{ length = 9, width = 36 }}\n").model()
    assert [f"ring-{end}: the slots of" in str(refused.value) for end in ("bottom", "top")] == [True, True]
    assert "apart" not in str(refused.value)  # the axis and the number of strips fix their positions
    assert len(read(lamp).model().plates) == 2


SLIM = "[[50, 0], [60, 40], [64, 90], [60, 140], [50, 180]]"


@pytest.mark.parametrize(("count", "width"), [(12, 26), (14, 20), (26, 12)])
def test_the_largest_number_of_strips_that_works_is_suggested(read, count, width):
    def body(strips):
        return read(
            f"[revolution]\nsheet = 'polypropylene-0.8'\nrings = 'mdf-3'\nstrips = {strips}\n"
            f"points = {SLIM}\nends = {{ length = 9, width = {width} }}\n"
        ).model()

    with pytest.raises(InputError, match=r"use \d+ strips\.$") as refused:
        body(count)
    most = int(re.findall(r"use (\d+) strips", str(refused.value))[0])
    assert len(body(most).plates) == 2
    with pytest.raises(InputError):
        body(most + 1)


def test_only_tested_changes_are_named_as_tested(read, tmp_path):
    """The openings of a drawn profile are not tested."""
    profile = ec.meridian_through([(15, 0), (75, 45), (68, 95), (40, 140), (15, 175)])
    ec.write_curves([profile.curve], tmp_path / "profile.json")
    pear = "[revolution]\nsheet = 'polypropylene-0.8'\nrings = 'mdf-3'\nstrips = 30\n"
    with pytest.raises(InputError) as refused:
        read(f"{pear}curve = 'profile.json'\naxis_x = 0\n").model()
    assert "opening" not in str(refused.value)
    assert str(refused.value).endswith("within the strain limit: 27, 24, 21, 18, 15 and 12 strips.")


@pytest.mark.parametrize(
    ("gap", "advice"),
    [
        (7, "reduce the gap to 4 mm."),
        pytest.param(12, "let the strips meet the plate more steeply.", marks=pytest.mark.campaign),
    ],
)
def test_a_full_stop_precedes_the_tested_changes(read, gap, advice):
    bowl = (
        f"[revolution]\nsheet = 'polypropylene-0.8'\nrings = 'polypropylene-0.8'\ngap = {gap}\nstrips = 10\n"
        "points = [[55, 0], [75, 30], [82, 70], [68, 145], [40, 190]]\nends = { length = 35, width = 14 }\n"
    )
    with pytest.raises(InputError) as refused:
        read(bowl).model()
    assert f"{advice} " in str(refused.value)
    assert re.search(r"。(经试算|已试算)", Translated("zh-CN").sentence(refused.value.refusal))


def test_a_suggested_change_keeps_to_the_strain_limit(read):
    """Fewer strips are wider, and on tabs of the same width they exceed the limit."""

    def vase(strips):
        return read(
            f"[revolution]\nsheet = 'polypropylene-0.8'\nrings = 'mdf-3'\nstrips = {strips}\n"
            "points = [[50, 0], [69, 40], [74, 90], [69, 140], [50, 180]]\nends = { length = 9, width = 20 }\n"
        ).model()

    with pytest.raises(InputError, match="A tested change makes strips and rings possible") as refused:
        vase(14)
    assert not re.findall(r"use \d+ strips", str(refused.value))
    assert not vase(12).strips[0].strain_verdict.allowed


def test_no_tab_is_advised_that_is_wider_than_its_ring_allows(read):
    """The strip alone would need tabs almost as wide as its ends; neighbours leave less room in the ring."""
    bulb = (
        "[revolution]\nsheet = 'birch-plywood-0.8'\nstrips = 8\n"
        "points = [[30, 0], [96, 120], [180, 255], [186, 375], [30, 495]]\n"
    )
    narrow = "ends = [{ length = 8, width = 19 }, { length = 8, width = 12 }]\n"
    with pytest.raises(InputError, match="Make the tab at the start at least 24"):
        read(bulb + narrow).model()
    with pytest.raises(InputError, match="The ring has no room for a tab wider than 20") as refused:
        read(f"{bulb}{narrow}rings = 'birch-plywood-3'\n").model()
    assert "Make the tab" not in str(refused.value)


def test_the_opening_of_a_narrow_ring_follows_from_its_note(read):
    """A smaller border is the change that the note suggests."""
    vase = (
        "[revolution]\nsheet = 'polypropylene-0.8'\nstrips = 8\nrings = 'mdf-3'\n"
        "points = [[20, 0], [40, 40], [48, 90], [40, 140], [20, 180]]\n"
    )
    closed = kit_contents(read(vase).model())
    assert [ring.opening for ring in closed.model.plates] == [None, None]
    (note, *_) = (text for text in closed.notes if text.startswith("ring-bottom has no opening"))
    assert "border of 8 mm leave less than 20 mm free. For an opening, reduce the border" in note
    opened = kit_contents(read(f"{vase}border = 4\n").model())
    assert all(ring.radii[0] >= 10 for ring in opened.model.plates)
    assert not any("no opening" in text for text in opened.notes)


@pytest.mark.parametrize(("foot", "count"), [(62, 10), (61, 15)])
def test_default_tabs_leave_room_between_the_slots_that_follow_bent_tabs(read, foot, count):
    lamp = (
        f"[revolution]\nsheet = 'polypropylene-0.8'\nrings = 'polypropylene-0.8'\nstrips = {count}\ngap = 6\n"
        f"points = [[{foot}, 0], [77, 28], [85, 69], [70, 150], [42, 193]]\n"
    )
    for ring in read(lamp).model().plates:
        first, second = (slot.corners for slot in ring.slots[:2])
        sides = second[:, None] - first[None]
        assert np.hypot(*np.moveaxis(sides, -1, 0)).min() > 2


def test_tabs_below_the_lowest_ring_have_a_note(read):
    vase = (
        "[revolution]\nsheet = 'polypropylene-0.8'\nstrips = 12\nrings = 'mdf-3'\n"
        "points = [[60, 0], [85, 40], [100, 90], [85, 140], [60, 180]]\n"
    )

    def notes(more):
        return [text for text in kit_contents(read(vase + more).model()).notes if "tips of the tabs" in text]

    (single,), (double,) = notes(""), notes("gap = 6\n")
    assert single.startswith("ring-bottom: ")
    assert double.startswith("ring-bottom-outer: ")
    assert not notes("ends = { length = 3, width = 20 }\n")
    assert not any("horten" in text for text in (single, double))  # plates may need tabs of this length
    depths = [
        float(
            re.search(r"up to ([\d.]+) mm below", *notes(f"ends = {{ length = {length}, width = 20 }}\n"))[1]
        )
        for length in (14, 19)
    ]
    assert 0 < depths[1] - depths[0] < 5  # the tabs are inclined


def test_constants_and_other_strips_beside_it(read):
    """A globe of 80 mm: x kappa = x / 80; a strip of its own stands inside."""
    text = (
        "[revolution]\na = 0\nb = ['1 / 80', 0]\nstart = [80, 0]\nangle = 'pi / 2'\nlength = 400\nring = 35\n"
        "strips = 8\nends = { length = 5 }\n"
        "[[strips]]\nmax_width = 10\ncurve.ellipse = { semi_axes = [40, 40], start = 0.3, end = 2.8 }\n"
        "[extras]\ncoupon = true\n"
    )
    design = read(text)
    model = design.model()
    assert len(model.placed) == 9
    assert model.plates == ()
    globe = model.strips[0]
    assert np.hypot(*globe.rod.position.T) == pytest.approx(80, abs=1e-4)
    assert globe.ends[0].length == 5
    assert len(design.kit.extras(model)) == 1


def test_a_profile_says_how_far_it_was_left(read, tmp_path):
    x = np.linspace(0, np.pi, 40)
    drawn = ec.PlaneCurve.fit(np.column_stack([50 + 15 * np.sin(2 * x), 60 * x / np.pi]))
    ec.write_curves([drawn], tmp_path / "profile.json")
    design = read("[revolution]\ncurve = 'profile.json'\nstrips = 12\n")
    _, message = design.reports
    assert "mm from the drawn curve" in message
    assert design.model().reports == design.reports
    assert 0.1 < design.revolution.meridian.deviation < 3


@pytest.mark.parametrize(("size", "bulge", "reports"), [(1, 0, 0), (1, 0.4, 1), (0.1, 0, 0), (0.1, 2, 1)])
def test_a_meridian_close_to_its_points_is_not_reported(read, size, bulge, reports):
    ball = [
        [56, 19.54],
        [70, 33.43],
        [84.57, 59.22 + bulge],
        [90, 90],
        [84.57, 120.78],
        [70, 146.57],
        [56, 160.46],
    ]
    points = (size * np.array(ball)).tolist()
    design = read(f"[revolution]\nstrips = 12\npoints = {points}\n")
    assert len(design.reports) == reports


@pytest.mark.parametrize(
    "axis",
    [
        "axis_x = 120",
        "axis = { file = 'pot.svg', id = 'axis' }",
        "axis = { file = 'pot.svg', id = 'tilted' }",
    ],
)
def test_the_axis_is_where_it_is_drawn(read, tmp_path, axis):
    """The profile is on the left of its axis; the tilted axis meets it at the same height as the upright one."""
    (tmp_path / "pot.svg").write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" width="200mm" height="200mm" viewBox="0 0 200 200">'
        '<path id="axis" d="M 120 20 V 180"/><path id="tilted" d="M 140 180 L 100 20"/>'
        '<path id="profile" d="M 60 30 C 20 60 10 120 55 170"/></svg>'
    )
    design = read(f"[revolution]\ncurve = {{ file = 'pot.svg', id = 'profile' }}\n{axis}\nstrips = 12\n")
    curve = design.revolution.meridian.curve
    ends = np.array([[60, 30], [55, 170]]) - [120, 100]  # from the middle of the axis
    along = np.array([40, 160]) / np.hypot(40, 160) if "tilted" in axis else np.array([0, 1])
    radii = np.abs(ends @ [along[1], -along[0]])
    assert sorted(curve.at([0, curve.length]).position[:, 0]) == pytest.approx(sorted(radii), abs=0.5)
    assert not any("axis" in text for text in design.reports)


def test_the_axis_that_is_assumed_is_reported(read, tmp_path):
    ec.write_curves([ec.PlaneCurve.fit([(50, 0), (62, 20), (64, 40), (55, 60)])], tmp_path / "profile.json")
    (message, *_) = read("[revolution]\ncurve = 'profile.json'\nstrips = 12\n").reports
    assert "x = 0 of the drawing" in message
    assert "129 mm wide" in message


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("strips = 20", "Add one of the keys 'points' and 'curve', or the keys a, b"),
        (f"{POINTS}\na = 3", "Add one of the keys 'points'"),
        ("a = 3", r"revolution: b is missing"),
        ("points = 3", "points is not a list of points"),
        ("points = [[1, 2], [3, 4]]", "revolution: the meridian cannot be read: give at least three points"),
        ("points = [[70, 0], [-125, 55], [90, 115]]", "revolution: point 2 at"),
        (f"{POINTS}\naxis_x = 5", "axis_x has no effect without curve. Set curve, or leave out axis_x"),
        (f"{POINTS}\nring = 500", "revolution: the radius `ring` is 500"),
        (f"{POINTS}\nrings = 'gold'", "revolution: rings: unknown sheet 'gold'"),
        (f"{POINTS}\nstrip = 3", "did you mean strips"),
    ],
)
def test_what_makes_no_surface_is_reported(read, text, sentence):
    with pytest.raises(InputError, match=sentence) as refused:
        read(f"[revolution]\n{text}\n")
    assert "vase.toml" in str(refused.value)


def test_counts_and_hopeless_points(read):
    for count in (2, 5000):
        with pytest.raises(InputError, match=f"strips is {count}: give a whole number from 3 up to 1000"):
            read(f"[revolution]\n{POINTS}\nstrips = {count}\n").model()
    with pytest.raises(NotConvergedError, match=r"vase\.toml: revolution: .*no meridian"):
        read("[revolution]\npoints = [[50, 0], [60, 50], [50, 1e-6], [60, 51]]\n")
    with pytest.raises(InputError, match="has no strips"):
        read("")


BODY = f"[revolution]\n{POINTS}\nstrips = 20\n"


def strip_of(read, top="", inside=""):
    return read(f"{top}\n{BODY}{inside}\n").model().strips[0]


@pytest.mark.parametrize("inside", [False, True])
@pytest.mark.parametrize(
    "key",
    ["engrave = 'X'", "creep = 0.4", "gravity = true\nloads = [{ at = 60, mass = 3 }]", "length = 150",
     "style = { kind = 'perforated', width = 40, columns = 3 }", "compensate = true"],
)  # fmt: skip
def test_keys_of_a_strip_act_at_the_top_and_below_the_heading(read, key, inside):
    plain, changed = strip_of(read), strip_of(read, *(("", key) if inside else (key,)))
    assert changed.drawing() != plain.drawing() or changed.rod.gravity or changed.creep
    if "engrave" in key:
        assert changed.engraved == "X"
    if "creep" in key:
        assert changed.crept is not None
    if "length" in key:
        assert changed.rod.length == pytest.approx(150, rel=1e-6)
        assert changed.width(75.0) / changed.width(0.0) == pytest.approx(
            plain.width(plain.rod.length / 2) / plain.width(0.0), rel=1e-6
        )


def test_weight_and_loads_move_the_strips_and_are_reported(read):
    """The widths stay those of touching strips; the force at the top and the bottom is the whole weight."""
    plain = strip_of(read)
    model = read(f"gravity = [0, 0, -1]\nloads = [{{ at = 60, mass = 20 }}]\n{BODY}").model()
    strip = model.strips[0]
    assert strip.width(strip.rod.s) == pytest.approx(plain.width(plain.rod.s))
    hung = (strip.layers[0].area * 1e-9 * strip.sheet.thickness * strip.sheet.density + 0.020) * 9.80665
    up = strip.reactions().start_force[1] + strip.reactions().end_force[1]
    assert up == pytest.approx(hung, rel=1e-3)
    far = np.hypot(*(strip.rod.position - plain.rod.position).T).max()
    moved, apart = model.reports
    assert moved == f"The weight and the loads move the strips by up to {far:.2g} mm from the meridian."
    assert "do not touch everywhere" in apart


def test_a_load_that_the_strips_cannot_carry_is_refused(read):
    """Forces towards the axis press the shallow bulge through; a small part of them does not."""

    def barrel(force):
        body = "points = [[300, 0], [313, 100], [317, 200], [313, 300], [300, 400]]\nstrips = 40\n"
        return read(f"loads = [{{ at = 200, force = [{force}, 0] }}]\n[revolution]\n{body}").model()

    with pytest.raises(
        InputError, match=r"of their weight and loads, the strips snap into another"
    ) as refused:
        barrel(-0.02)
    carried = float(re.search(r"Under ([\d.]+) %", str(refused.value))[1]) / 100
    assert barrel(-0.02 * 0.95 * carried).strips[0].rod.discrete.unstable_modes == 0
    with pytest.raises(InputError):
        barrel(-0.02 * 1.05 * carried)


def test_compensated_strips_are_no_wider_than_touching_strips(read):
    sheet = "sheet = 'polypropylene-0.8'\n"
    drawn, model = strip_of(read, inside=sheet), read(f"compensate = true\n{BODY}{sheet}").model()
    strip = model.strips[0]
    assert strip.held_deviation < drawn.held_deviation / 4
    gaps = drawn.width(drawn.rod.s) - strip.width(drawn.rod.s)
    assert gaps.min() == pytest.approx(0, abs=1e-3)
    assert f"gaps are up to {gaps.max():.2g} mm wide, and overlaps up to 0 mm" in model.reports[0]
    narrow = read(f"compensate = true\n{BODY}ends = {{ length = 8, width = 15 }}\n").model()
    assert narrow.reports[0] == "No correction of the widths makes the strips more accurate."


@pytest.mark.parametrize(("sheet", "told"), [("card-200gsm", True), ("polypropylene-0.8", False)])
def test_the_weight_of_strips_without_gravity_is_reported_if_it_matters(read, sheet, told):
    """The movement is that of the same design with its weight."""
    body = f"{BODY}sheet = '{sheet}'\n"
    light, heavy = read(body).model(), read(f"gravity = true\n{body}").model()
    far = np.hypot(*(heavy.strips[0].rod.position - light.strips[0].rod.position).T).max()
    weights = [text for text in light.reports if text.startswith("The weight of the strip")]
    assert len(weights) == told == (far > 1e-3 * light.strips[0].rod.length)
    assert all(f"moves the strip by {far:.2g} mm if the curve stands upright" in text for text in weights)
    assert not any(text.startswith("The weight of the strip") for text in heavy.reports)


def test_a_drawn_profile_is_smoothed(read, tmp_path):
    drawn = ec.PlaneCurve.spline([(70, 0), (110, 20), (125, 60), (90, 90), (80, 140)], degree=2)
    ec.write_curves([drawn], tmp_path / "profile.json")
    profile = "[revolution]\ncurve = 'profile.json'\naxis_x = 0\nstrips = 20\n"
    lengths = [read(f"smooth = {mm}\n{profile}").revolution.meridian.curve.length for mm in (0, 3)]
    assert lengths[0] != pytest.approx(lengths[1], rel=1e-6)


@pytest.mark.parametrize(
    ("top", "inside", "message"),
    [
        (
            "max_width = 20\nlimits = {}",
            "",
            "max_width has no effect on a surface of revolution.*max_width and limits",
        ),
        ("natural_curvature = 0.01", "", "Leave out natural_curvature"),
        ("smooth = 1", "", "smooth has no effect without curve. Set curve, or leave out smooth"),
        ("", "max_width = 20", "unknown key 'max_width'"),
        ("gravity = 'zzz'", "", "gravity is 'zzz'"),
        ("gravity = 'zzz'", "gravity = true", "gravity is 'zzz'"),
        ("creep = -1", "creep = 1", "creep"),
        ("gravity = [1, 0, 0]", "", "must act along the axis"),
        ("gravity = [0, 0.1, -1]", "", "must act along the axis"),
        ("loads = [{ at = 50, mass = 500 }]", "", "A point mass needs gravity"),
        ("loads = [{ at = 50, force = [1, 0] }]\ncreep = 1", "", "cannot be combined with creep"),
        ("style = { kind = 'perforated', width = 30 }", "", r"width is 40\.03 mm. Set style.width"),
        ("", "smooth = 1", "smooth has no effect without curve"),
    ],
)
def test_keys_without_effect_on_touching_strips_are_refused(read, top, inside, message):
    with pytest.raises(InputError, match=message):
        read(f"{top}\n{BODY}{inside}\n").model()


ARCH = "[[strips]]\nlabel = 'A'\ncurve = { spline = [[0, 0], [50, 60], [100, 0]], degree = 2 }\n"


def test_a_note_names_keys_that_only_the_other_strips_use(read):
    design = read(f"max_width = 20\nsmooth = 0.1\ncreep = 0.3\n{BODY}{ARCH}")
    assert design.reports[0] == (
        "These keys at the top of the design have no effect on a surface of revolution: max_width and smooth."
    )
    assert [strip.creep for strip in design.model().strips] == [0.3] * 21


@pytest.mark.parametrize(
    "key", ["gravity = 'zzz'", "max_width = -3", "limits = { ratio = 0.5 }", "section = 3"]
)
def test_a_value_that_all_strips_override_is_checked(read, key):
    name = key.split()[0]
    own = {
        "gravity": "false",
        "max_width": "20",
        "limits": "{}",
        "section": "{ kind = 'rod', limits = [3, 4] }",
    }[name]
    with pytest.raises(InputError, match=f"{name}"):
        read(f"{key}\n{ARCH}{'' if 'w' in name else 'max_width = 20'}\n{name} = {own}\n")
    formula = (
        f"max_width = '2 * half'\n{ARCH}max_width = 20\n{ARCH.replace('A', 'B')}max_width = 9\nlet.half = 5\n"
    )
    assert len(read(formula).entries) == 2
