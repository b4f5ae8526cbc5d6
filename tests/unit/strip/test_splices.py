"""Strips longer than the stock: pieces that fit it, plates over the joints, and what these do to the shape."""

import json
import pathlib
import re
from dataclasses import replace

import numpy as np
import pytest
import shapely
from scipy.integrate import solve_ivp
from scipy.optimize import root

import elastica_cad as ec
from elastica_cad import InputError, Path
from elastica_cad.design.kit_spec import HolderSpec, KitSpec
from elastica_cad.geometry.path_intersections import clip_across
from elastica_cad.kit.kit_contents import kit_contents
from elastica_cad.mechanics import ThicknessLaw
from elastica_cad.model.nesting import Nesting
from elastica_cad.strip import CUT_INNER, CUT_OUTER, MARK, text_strokes
from elastica_cad.strip.layers import PLATE_CUT, PLATE_END, LapPlates
from elastica_cad.strip.makeable_strip import Splice, joined_within, splice, spliced
from tests.command_line import run

PLY = ec.Sheet.named("birch-plywood-4")
ARCH = ec.PlaneCurve.spline([(0, 0), (300, 900), (1500, 1400), (2700, 900), (3000, 0)])  # 3.7 m
WAVE = ec.PlaneCurve.spline([(0, 0), (700, 300), (1500, 0), (2300, -300), (3000, 0)])  # level in its middle


@pytest.fixture(scope="module")
def arch():
    return ec.make_strip(ARCH, PLY, max_width=120, label="A", shop=ec.FabricationLimits(stock=(4000, 1500)))


def test_pieces_and_plates_are_the_strip_cut_across(arch):
    joined = splice(arch, 1300.0, 80.0)
    *pieces, one, two = joined.pieces
    assert [piece.name for piece in joined.pieces] == ["A-1", "A-2", "A-3", "A-lap-1", "A-lap-2"]
    assert sum(piece.area for piece in pieces) == pytest.approx(arch.outline.area)
    assert max(piece.size[0] for piece in pieces) <= 1300
    for plate, at in zip((one, two), joined.plates.joints, strict=True):
        assert plate.size[0] == pytest.approx(80.0)
        assert plate.bounds.mean(axis=0)[0] == pytest.approx(at)
        assert plate.area == pytest.approx(
            np.mean(arch.width(np.linspace(at - 40, at + 40, 400))) * 80, rel=1e-4
        )
    other = splice(replace(arch, engrave="No. 7"), 1300.0, 80.0).pieces
    assert [piece.name for piece in other] == [piece.name for piece in joined.pieces]
    assert [piece.drawing.texts[0].text for piece in other[2:4]] == ["No. 7-3", "No. 7-lap-1"]
    (outline,) = pieces[1].drawing.on(CUT_OUTER)
    assert outline.has_splines  # as exact as the strip


def test_what_the_plates_do_is_bent_forward(arch):
    """Eight times as stiff under a plate, so a strip turns an eighth there: longer plates move it more."""
    moved = [splice(arch, 2200.0, lap).deviation for lap in (1.0, 40.0, 80.0, 160.0)]
    assert moved[0] < 0.1 + arch.deviation_as_built
    assert moved[0] < moved[1] < moved[2] < moved[3]
    joined = splice(arch, 2200.0, 80.0)
    (at,) = joined.plates.joints
    lost = 7 / 8 * np.ptp(np.interp([at - 40, at + 40], arch.rod.s, arch.rod.angle))
    assert 0.02 * lost * 1000 < joined.deviation < lost * 2000  # rad on arms of about a metre, both ends held
    assert "Cut in 2 pieces, joined" in str(joined)
    assert f"move its shape by {joined.deviation:.2g} mm" in str(joined)


@pytest.mark.campaign
def test_plates_do_not_weigh_what_they_are_stiff():
    """An arch under its own weight, eight times as stiff within its plates and no heavier, shot by scipy."""
    shop = ec.FabricationLimits(stock=(2200, 1500), lap=120.0)
    heavy = ec.make_strip(ARCH, "birch-plywood-6", max_width=200, gravity=True, shop=shop)
    (at,) = heavy.plates.joints
    rod, sheet, held = heavy.rod, heavy.sheet, heavy.reactions()
    per_width = sheet.density * 9.80665e-9 * sheet.thickness  # N/mm2
    EI = sheet.youngs_modulus * sheet.thickness**3 / 12

    def shot(unknown, **options):
        def along(s, state):
            _, _, angle, moment, weight = state
            width = heavy.width(s)
            carries = PLATE_CUT * 6 / 2 < abs(s - at) < 60 - PLATE_END * 6
            stiff = EI * width * (8.0 if carries else 1.0)
            cos, sin = np.cos(angle), np.sin(angle)
            return cos, sin, moment / stiff, sin * unknown[1] - cos * (unknown[2] + weight), per_width * width

        start = (*rod.position[0], rod.angle[0], unknown[0] * 1000, 0.0)
        return solve_ivp(along, (0, rod.length), start, rtol=1e-7, atol=1e-7, max_step=4.0, **options)

    def missed(unknown):
        x, y, angle = shot(unknown).y[:3, -1]
        return x - rod.position[-1, 0], y - rod.position[-1, 1], 1000 * (angle - rod.angle[-1])

    guess = [-held.start_moment / 1000, *(-held.start_force)]
    found = root(missed, guess, options={"eps": 1e-6})
    assert found.success, found.message
    x, y = shot(found.x, t_eval=rod.s).y[:2]
    moved = float(np.hypot(x - rod.position[:, 0], y - rod.position[:, 1]).max())
    assert heavy.held().parts["plates"] == pytest.approx(moved, rel=0.05)
    assert heavy.held_deviation == pytest.approx(moved, rel=0.05)  # as made and held: plates and all else


def test_plates_move_a_strip_as_finite_elements_have_it():
    """Two pieces, the base cut through: tests/campaign/finite_elements/joined.py."""
    measured = pathlib.Path(__file__).parents[2] / "campaign/finite_elements/measured.json"
    rows = {row["name"]: row for row in json.loads(measured.read_text(encoding="utf-8"))["joined"]}
    arch = ec.PlaneCurve.spline([(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)], degree=4)
    arch = arch.transformed(np.diag([1.0, 1.0, arch.length / 300]))
    for name, nu, width, joint in (("arch, nu 0", 0.0, 30.0, 150.0), ("arch, nu 0.3", 0.3, 20.0, 110.0)):
        sheet = ec.Sheet("ply", 0.8, 9000.0, 680.0, max_strain=0.02, poisson_ratio=nu)
        bare = ec.make_strip(arch, sheet, max_width=width, ignore_limits=True, compensate=False)
        joined = replace(bare, plates=LapPlates((joint,), rows[name]["lap"]))
        assert joined.held_deviation / 300 == pytest.approx(rows[name]["strayed"], rel=0.02)


@pytest.mark.campaign
def test_what_is_warned_of_plates_is_what_the_report_says_of_the_strip(tmp_path):
    """`elastica strip --set shop.lap`: one figure in the sentence and the report; --compensate makes up for it."""
    (tmp_path / "arch.csv").write_text("0,0\n200,700\n1000,1050\n2100,800\n2600,0\n")
    command = [
        "strip",
        str(tmp_path / "arch.csv"),
        "--sheet",
        "birch-plywood-6",
        "--max-width",
        "400",
        "--nearest",
        "--set",
        "shop.lap=120",
        "--set",
        "shop.stock=[2000,1500]",
        "-o",
        str(tmp_path / "out"),
        "--force",
        "--json",
    ]
    result = {}
    for more in ((), ("--compensate",)):
        done = run(*command, *more)
        (report,) = json.loads(done.stdout)["strips"]
        (sentence,) = (text for text in report["warnings"] if text.startswith("Cut in 2 pieces"))
        result[more] = held = report["held"]
        left = held["deviation"] if more else held["parts"]["plates"]
        assert sentence.endswith(f"move its shape by {left:.2g} mm.")
    request, better = result.values()
    assert request["deviation"] == pytest.approx(request["parts"]["plates"], rel=0.1)
    assert better["deviation"] < request["deviation"] / 4


def test_plates_that_would_lie_on_a_slot_are_laid_elsewhere(arch):
    shop = ec.FabricationLimits(stock=(2200, 1500), lap=80.0)
    joined = joined_within(arch, shop)
    (at,) = joined.plates.joints
    assert spliced(joined, shop).plates.joints == (at,)
    crossed = replace(joined, slots=(ec.Slot(at, 4.0),))
    (other,) = spliced(crossed, shop).plates.joints
    assert abs(other - at) > 40
    assert joined_within(crossed, shop).plates.joints == (other,)
    assert joined_within(joined, ec.FabricationLimits(stock=(4000, 1500))).plates is None


def test_joints_lie_where_the_strip_turns_least():
    """At the inflection of a wave, where a stiffer place changes nothing."""
    wave = ec.make_strip(WAVE, PLY, max_width=120, shop=ec.FabricationLimits(stock=(4000, 1500)))
    (middle,) = wave.rod.curve.inflections
    (at,) = splice(wave, 2600.0, 80.0).plates.joints
    assert at == pytest.approx(middle, abs=20)


def test_joints_keep_off_slots(arch):
    (at,) = splice(arch, 2200.0, 80.0).plates.joints
    slotted = ec.Strip(arch.rod, PLY, max_width=120, slots=(ec.Slot(at, 4.2),), label="A")
    (moved,) = splice(slotted, 2200.0, 80.0).plates.joints
    assert abs(moved - at) > 44


def test_perforated_strips_are_solid_under_their_plates():
    """Holes under a plate stay uncut, the others go with their piece, and what that stiffens is bent forward."""
    style = ec.Perforated(width=120.0, columns=2, least_ligament=2.0)
    strip = ec.make_strip(ARCH, PLY, style=style, label="A", shop=ec.FabricationLimits(stock=(4000, 1500)))
    joined = splice(strip, 2200.0, 80.0)
    one, two, plate = joined.pieces
    (at,) = joined.plates.joints
    assert not plate.drawing.on(CUT_INNER)
    assert plate.area == pytest.approx(80 * 120.0)
    spans = [hole.bounds[:, 0] for hole in strip.holes]
    under = [low < at + 40 and high > at - 40 for low, high in spans]
    assert any(under)
    assert len([*one.drawing.on(CUT_INNER), *two.drawing.on(CUT_INNER)]) == len(spans) - sum(under)
    for piece, side in ((one, -1), (two, 1)):
        for hole in piece.drawing.on(CUT_INNER):
            assert np.all(side * (hole.bounds[:, 0] - at) >= 40)
    assert str(joined).endswith(f"Number of holes that are omitted under the plates: {sum(under)}.")
    plain = ec.make_strip(ARCH, PLY, max_width=120, shop=ec.FabricationLimits(stock=(4000, 1500)))
    assert joined.deviation > splice(plain, 2200.0, 80.0).deviation > 0.1


def laminated(**more):
    style = ec.Laminated(width=60.0, backing=ec.Sheet.named("birch-plywood-0.8"))
    shop = ec.FabricationLimits(stock=(4000, 1500))
    return ec.make_strip(ARCH, "birch-plywood-0.8", **({"style": style, "label": "A", "shop": shop} | more))


def test_layers_of_a_laminate_are_staggered():
    """Each is cut elsewhere, under plates of its own, and the pieces of a layer are what it was."""
    strip = laminated()
    joined = splice(strip, 2200.0, 16.0)
    (base,), (backing,) = joined.plates.joints, joined.plates.backing_joints
    assert abs(base - backing) >= 16
    names = [["A-1", "A-2", "A-lap-1"], ["A-backing-1", "A-backing-2", "A-backing-lap-1"]]
    assert [[piece.name for piece in layer] for layer in joined.layer_pieces.values()] == names
    for layer, pieces in zip(strip.layers, joined.layer_pieces.values(), strict=True):
        *cut, plate = pieces
        assert sum(piece.area for piece in cut) == pytest.approx(layer.area)
        assert plate.size[0] == pytest.approx(16.0)
        assert {piece.sheet for piece in pieces} == {layer.sheet}
    assert (
        f"Cut in pieces: A, joined {base:.0f} mm from the start and A-backing, joined {backing:.0f} mm from"
        in str(joined)
    )
    assert [drawing.name for drawing in joined.drawings] == ["A", "A-backing"]


def test_a_layer_that_fits_its_stock_stays_whole():
    joined = splice(laminated(), 2200.0, 16.0, backing_stock=4000.0)
    assert joined.plates.backing_joints == ()
    assert str(joined).startswith(
        f"Cut in pieces: A, joined {joined.plates.joints[0]:.0f} mm from the start. The plates"
    )
    assert [piece.name for piece in joined.layer_pieces["A-backing"]] == ["A-backing-1"]


def test_three_glued_sheets_are_as_stiff_as_one_of_thrice_the_thickness():
    """A short plate takes from the turn what it makes stiffer: 1 - 8/27 on two full layers, 1 - 1/8 on one."""
    style = ec.Laminated(width=lambda s: 60.0 + 0 * s, backing=ec.Sheet.named("birch-plywood-0.8"))
    bow = ec.PlaneCurve.fit([(500 * np.sin(a), 500 * np.cos(a)) for a in np.linspace(-1, 1, 81)])
    plain = ec.make_strip(bow, "birch-plywood-0.8", max_width=60)
    glued = ec.make_strip(bow, "birch-plywood-0.8", style=style)
    at = plain.rod.length / 2
    one = Splice(plain, LapPlates((at,), 8.0)).deviation
    for plates in (LapPlates((at,), 8.0), LapPlates((), 8.0, (at,))):
        assert Splice(glued, plates).deviation / one == pytest.approx((1 - 8 / 27) / (1 - 1 / 8), rel=1e-2)


def test_marks_of_the_backing_go_on_across_the_pieces():
    wave = ec.PlaneCurve.spline([(0, 0), (300, 900), (1500, 400), (2700, 900), (3000, 0)])
    strip = ec.make_strip(
        wave, "birch-plywood-0.8", label="A", shop=ec.FabricationLimits(stock=(6000, 1500)),
        style=ec.Laminated(width=60.0, backing=ec.Sheet.named("birch-plywood-1.5")),
        limits=ec.Limits(ratio=8.0), keep=ec.Keep(),
    )  # fmt: skip
    joined = splice(strip, 2200.0, 30.0)
    whole = sum(path.length for path in strip.drawing().on(MARK))
    plates = sum(0.8 * strip.width(at + side * 15.0) for at in joined.plates.joints for side in (-1, 1))
    cut = sum(path.length for piece in joined.layer_pieces["A"] for path in piece.drawing.on(MARK))
    assert cut == pytest.approx(whole + plates)


def test_tapered_strips_are_refused_with_the_reason():
    law = ThicknessLaw(PLY, 3.0, 8.0, width=40.0)
    strip = ec.make_strip(ARCH, PLY, section=law, label="A")
    with pytest.raises(InputError, match=r"would have to taper too\. Use a larger stock"):
        splice(strip, 2200.0, 80.0)


@pytest.mark.campaign
@pytest.mark.parametrize("style", ["perforated", "laminated"])
def test_the_door_takes_laps_for_every_style(style, tmp_path, check_drawing_file):
    """As typed: the refusal's own command makes the strip, and each sheet's file holds its pieces."""
    ec.write_curves([ARCH], tmp_path / "arch.dxf")
    words = [
        "strip",
        str(tmp_path / "arch.dxf"),
        "--set",
        "shop.stock=[2500,1250]",
        "-o",
        str(tmp_path / "out"),
    ]
    words += ["--style", style, "--outer-width", "60", "--sheet"]
    words += {
        "perforated": [
            "birch-plywood-4",
            "--set",
            "style.columns=1",
            "--set",
            "style.least_ligament=4",
            "--set",
            "shop.least_ligament=4",
        ],
        "laminated": ["birch-plywood-0.8", "--set", "style.backing=birch-plywood-1.5"],
    }[style]
    refused = run(*words, code=1)
    lap = {"perforated": "80", "laminated": "16"}[style]
    assert re.search(rf"\(the curve as drawn.*--set shop.lap={lap}`", refused.stderr)
    run(*words, "--set", f"shop.lap={lap}")
    files = ["arch.dxf", "arch-backing.dxf"] if style == "laminated" else ["arch.dxf"]
    for file in files:
        curves = check_drawing_file(tmp_path / "out" / file)
        assert sum(curve.layer == CUT_OUTER for curve in curves) == 3


@pytest.mark.parametrize(
    ("stock", "lap", "words"),
    [(1300.0, 500.0, r"plates 500 mm long \(lap\)"), (1300.0, -1.0, r"plates -1 mm long \(lap\)")],
)
def test_laps_that_cannot_be(arch, stock, lap, words):
    with pytest.raises(InputError, match=words):
        splice(arch, stock, lap)


def test_only_where_it_is_needed(arch):
    assert spliced(arch, ec.FabricationLimits(stock=(4000, 1500), lap=80)) is None
    assert spliced(arch, ec.FabricationLimits(stock=(2500, 1250))) is None
    assert spliced(arch, ec.FabricationLimits(stock=(2500, 1250), lap=80)) is not None
    with pytest.raises(InputError, match="larger than the stock of 2500 x 1250 mm"):
        ec.make_strip(ARCH, PLY, max_width=120, shop=ec.FabricationLimits(stock=(2500, 1250)))
    made = ec.make_strip(ARCH, PLY, max_width=120, shop=ec.FabricationLimits(stock=(2500, 1250), lap=80))
    assert any(text.startswith("Cut in 2 pieces") for text in made.warnings)


@pytest.mark.campaign
def test_the_commands_cut_and_nest_pieces(tmp_path, check_drawing_file):
    """The refusal tells the command with shop.lap; a kit nests the pieces on sheets of the stock."""
    ec.write_curves([ARCH], tmp_path / "arch.dxf")
    words = ["strip", str(tmp_path / "arch.dxf"), "--sheet", "birch-plywood-4", "--max-width", "120"]
    words += ["--set", "shop.stock=[2500,1250]", "-o", str(tmp_path / "out")]
    refused = run(*words, code=1)
    assert re.search(r"\(the curve as drawn.*--set shop.lap=80`", refused.stderr)
    run(*words, "--set", "shop.lap=80")
    curves = check_drawing_file(tmp_path / "out" / "arch.dxf")
    assert sum(curve.layer == CUT_OUTER for curve in curves) == 3
    (tmp_path / "arch.toml").write_text(
        'schema = 1\nname = "kit"\nsheet = "birch-plywood-4"\nmax_width = 120\n'
        "shop = { stock = [2500, 1250], lap = 80 }\nnest.sheet_size = [2500, 1250]\n"
        '[[strips]]\nlabel = "A"\ncurve = "arch.dxf"\n'
    )
    run("model", tmp_path / "arch.toml", "-o", tmp_path / "kit", "--no-step", "--no-pictures")
    report = json.loads((tmp_path / "kit" / "kit.json").read_text())
    (sheet,) = report["sheets"]
    assert sheet["pieces"] == {"A-1": 1, "A-2": 1, "A-lap-1": 1}


def test_clips_of_simple_paths():
    plate = Path.rectangle(40, 10)
    assert clip_across(plate, -np.inf, 15).bounds.tolist() == [[0, 0], [15, 10]]
    assert clip_across(plate, 15, np.inf).area == pytest.approx(250)
    assert clip_across(plate, -5, 50).area == pytest.approx(400)
    assert clip_across(Path.circle((0, 0), 5), 0, 10).area == pytest.approx(np.pi * 12.5)


def polygon(path):
    return shapely.Polygon(path.points(1e-3))


MATES = ("gjpq", "gjqp")


@pytest.mark.parametrize("seed", range(10))
def test_pieces_of_slotted_strips_have_all_that_the_strip_has(seed):
    """Against shapely: leaning slots stay clear of plates, names of pieces and mates stand on what is left."""
    rng = np.random.default_rng(seed)
    slots = tuple(
        ec.Slot(
            x,
            4.0,
            24.0,
            lean=float(rng.uniform(-1.2, 1.2)),
            side=str(rng.choice(["upper", "lower"])),
            mate=name,
        )
        for x, name in zip(
            np.arange(150.0, 1000.0, 140.0) + rng.uniform(-15, 15, 7), (*MATES * 3, MATES[0]), strict=True
        )
    )
    rod = ec.Rod.straight(1100.0, rng.uniform(1.0, 1.6, 4))
    strip = ec.Strip(rod, PLY, max_width=60.0, slots=slots, label="pergola-north-west")
    joined = splice(strip, 520.0, 30.0)
    pieces = joined.pieces[:-2]
    drawings = [piece.drawing for piece in joined.pieces]
    loops = [polygon(drawing.on(CUT_OUTER)[0]) for drawing in drawings]
    bare = polygon(replace(strip, slots=()).outline)
    for at, plate in zip(joined.plates.joints, loops[len(pieces) :], strict=True):
        covered = bare.intersection(shapely.box(at - 15, -99, at + 15, 99))
        assert plate.symmetric_difference(covered).area < 0.2
    for drawing, loop in zip(drawings, loops, strict=True):
        for text in drawing.texts:
            strokes = shapely.MultiLineString([stroke.points(0.05) for stroke in text_strokes(text)])
            assert loop.contains(strokes), text
    assert sum(text.text in MATES for drawing in drawings for text in drawing.texts) == len(slots)
    assert sum(loop.area for loop in loops[: len(pieces)]) == pytest.approx(
        polygon(strip.outline).area, rel=1e-5
    )


def test_plates_of_perforated_strips_are_named_whatever_their_ends_round_to():
    rod = ec.Rod.straight(1000.0, [1, 2, 1])
    strip = ec.Strip(rod, PLY, style=ec.Perforated(width=60.0), label="A")
    for lap in np.random.default_rng(1).uniform(60.0, 80.0, 20).tolist():
        assert {text.text for piece in splice(strip, 560.0, lap).pieces for text in piece.drawing.texts} == {
            "A-1",
            "A-2",
            "A-lap-1",
        }


def test_plates_of_a_strip_without_tabs_move_it_as_much():
    """Across a bare end there is no material to measure: the deviation had been no number."""
    rod = ec.optimal_rod(ARCH)
    held, bare = (ec.Strip(rod, PLY, max_width=120.0, ends=(tab, tab)) for tab in (ec.Tab(10.0), ec.Tab(0.0)))
    plates = LapPlates((1500.0,), 80.0)
    moved = [Splice(strip, plates).deviation for strip in (held, bare)]
    assert moved[1] == pytest.approx(moved[0], rel=1e-3)


def test_ends_of_a_strip_in_pieces_are_numbered_as_those_of_a_whole_one():
    """Slots of bases are named for the ends that they take; pieces had no numbers, nor the names of joints."""
    strip = ec.Strip(ec.Rod.straight(1000.0), PLY, max_width=40.0, label="A")
    joined = replace(splice(strip, 600.0, 60.0), ends=("1", "2"))
    numbers = {piece.name: [text.text for text in piece.drawing.texts[1:]] for piece in joined.pieces}
    assert numbers == {"A-1": ["1"], "A-2": ["2"], "A-lap-1": []}
    for piece in joined.pieces:
        loop = polygon(piece.drawing.on(CUT_OUTER)[0])
        for text in piece.drawing.texts:
            assert loop.contains(shapely.MultiLineString([one.points(0.05) for one in text_strokes(text)]))
    places = [text.position[0] for piece in joined.pieces for text in piece.drawing.texts[1:]]
    assert 0 < places[0] < 12
    assert 988 < places[1] < 1000

    drawn = ec.Rod.straight(1000.0)
    placed = ec.Placed(replace(strip, rod=drawn), (0, 0, 0), (1, 0, 0), (0, 0, 1))
    spec = KitSpec(
        holders=(HolderSpec("fixtures"),),
        nesting=Nesting(sheet_size=(700.0, 400.0)),
        shop=ec.FabricationLimits(stock=(700.0, 400.0), lap=60.0),
    )
    pieces = kit_contents(ec.Model([placed]), spec, effects=False).pieces
    result = {piece.name: [text.text for text in piece.drawing.texts] for piece in pieces}
    assert result == {"A-1": ["A-1", "1"], "A-2": ["A-2", "2"], "A-lap-1": ["A-lap-1"]}
