"""Straight first and last pieces of a drawn curve are the strip's tabs, with the circles drawn on them as holes."""

import subprocess

import ezdxf
import numpy as np
import pytest

import elastica_cad as ec
from elastica_cad.cli import main
from elastica_cad.design.kit_spec import HolderSpec, KitSpec
from elastica_cad.kit.kit_contents import kit_contents
from elastica_cad.kit.model_kit import model_kit
from elastica_cad.model.assembly import assembly_parts, list_assembly_steps
from elastica_cad.strip.holding_template import ends_message, held_ends, holding_template

BENT = [(60, 0), (110, 0), (160, 120), (250, 150), (340, 120), (390, 0), (440, 0)]


@pytest.fixture(scope="module")
def arch(tmp_path_factory):
    """As a maker draws it: straight run-ins with two screw holes each."""
    path = tmp_path_factory.mktemp("arch") / "arch.dxf"
    document = ezdxf.new(units=4)
    space = document.modelspace()
    space.add_line((0, 0), (60, 0))
    space.add_open_spline(BENT, degree=3)
    space.add_line((440, 0), (500, 0))
    for x in (20, 40, 460, 480):
        space.add_circle((x, 0), 2.5)
    document.saveas(path)
    return path


def test_straight_ends_become_tabs_of_that_length_with_holes_where_circles_are_drawn(arch):
    (curve,) = ec.read_curves(arch)
    strip = ec.make_strip(curve, "birch-plywood-0.8", max_width=80)
    bent = ec.make_strip(ec.PlaneCurve.spline(BENT, degree=3), "birch-plywood-0.8", max_width=80)
    assert [tab.length for tab in strip.ends] == [60, 60]
    assert [[(hole.at, hole.diameter) for hole in tab.holes] for tab in strip.ends] == [
        [(40, 5), (20, 5)],
        [(20, 5), (40, 5)],
    ]
    assert strip.rod.length == pytest.approx(bent.rod.length, abs=1e-6)
    assert np.allclose(strip.width.extremes, bent.width.extremes, atol=1e-6)
    assert len(strip.holes) == 4
    (message,) = (
        warning for warning in strip.warnings if "straight over its first 60 mm and its last 60 mm" in warning
    )
    assert message.endswith("Circles drawn on the tabs became holes: 4.")


def test_a_curve_that_is_to_be_bent_whole_is_refused_as_theorem_1_says(arch):
    (curve,) = ec.read_curves(arch)
    with pytest.raises(ec.NotRealizable):
        ec.make_strip(curve, "birch-plywood-0.8", max_width=80, straight_ends=False)


def test_an_end_that_may_turn_keeps_its_straight_piece(arch):
    (curve,) = ec.read_curves(arch)
    spec = ec.StripSpec(curve, "birch-plywood-0.8", max_width=80, supports=ec.Supports("pinned", "clamped"))
    assert spec.run_ins.lengths == (0, 60)
    assert [tab.length for tab in spec.tabs] == [10, 60]


def test_circles_move_with_the_curve(arch):
    (curve,) = ec.read_curves(arch)
    turn = np.array([[0, -2, 7], [2, 0, 5], [0, 0, 1.0]])
    tabs = ec.StripSpec(curve.transformed(turn), "birch-plywood-0.8", max_width=80).tabs
    assert [(hole.at, hole.diameter) for hole in tabs[0].holes] == [(80, 10), (40, 10)]


def test_the_holding_template_shows_where_the_ends_and_the_screws_are(arch):
    (curve,) = ec.read_curves(arch)
    strip = ec.make_strip(curve, "birch-plywood-0.8", max_width=80, label="A1")
    first, last = held_ends(strip)
    assert first.position == pytest.approx([60, 0], abs=1e-9)
    assert last.tip == pytest.approx([500, 0], abs=1e-9)
    assert "ends 380.0 mm apart where the bend begins (500.0 mm from tip to tip);" in ends_message(strip)
    drawing = holding_template(strip)
    curve_drawn = drawing.on("ENGRAVE")[0]
    assert np.abs(curve_drawn.points(0.01)[:, 1].max() - strip.rod.position[:, 1].max()) < 0.02
    axes = [path.bounds for path in drawing.on("MARK")]
    assert {round(float(box[0, 0])) for box in axes if np.ptp(box[:, 0]) < 1e-6} == {
        20,
        40,
        60,
        440,
        460,
        480,
    }
    lettered = [text.text for text in drawing.texts]
    assert "bend lines 380.0 mm apart, tips 500.0 mm" in lettered
    assert "end (2): strip straight ahead, hole at x 400.0, y 0.0, hole at x 420.0, y 0.0" in lettered


def test_an_end_that_no_part_of_a_model_holds_is_reported_and_has_no_figure():
    curve = ec.PlaneCurve.spline([(0, 0), (20, 100), (120, 180), (220, 50)], degree=3)
    strip = ec.make_strip(curve, "birch-plywood-0.8", max_width=40, label="UP")
    model = ec.Model([ec.Placed(strip, (0, 0, 0), (1, 0, 0), (0, 0, 1))], name="up")
    base = model.base_plate(ec.Sheet.named("mdf-3"))
    (step,) = list_assembly_steps(model, [base])
    assert step.ends == (
        "slot UP:1 of base",
        "hold at (220.0, 0.0, 50.0), 65.2 degrees to the right (downward)",
    )
    spec = KitSpec(holders=(HolderSpec("base", ec.Sheet.named("mdf-3")),))
    kit = kit_contents(model, spec, effects=True)
    assert kit.held == {}
    assert any("nothing holds its end (2)" in note for note in kit.notes)
    assert not any("nothing holds" in note for note in kit_contents(model, KitSpec(), effects=True).notes)


@pytest.mark.parametrize("start", [0, -400])
def test_the_side_to_which_an_end_leans_does_not_depend_on_the_position_of_the_strip(start):
    curve = ec.PlaneCurve.spline([(start, 0), (start, 80), (start + 120, 120), (start + 200, 50)], degree=3)
    strip = ec.make_strip(curve, "birch-plywood-0.8", max_width=30)
    (step,) = list_assembly_steps(ec.Model([ec.Placed(strip, (0, 0, 0), (1, 0, 0), (0, 0, 1))]), [])
    first, last = step.ends
    assert first.endswith("degrees to the left (upward)")
    assert last.endswith("degrees to the right (downward)")


def test_copies_of_a_strip_share_their_solids():
    strip = ec.make_strip(ec.PlaneCurve.arc((0, 0), 60, 0.1, 3.0), "birch-plywood-0.8", max_width=20)
    places = [ec.Placed(strip, (0, y, 0), (1, 0, 0), (0, 0, 1)) for y in (0, 30)]
    first, second = assembly_parts(places)
    assert first.solids is second.solids
    assert (first.name, second.name) == ("strip 1", "strip 2")


def test_the_command_check_draws_and_judges_what_is_bent(arch, tmp_path, capsys):
    words = ["--natural-curvature", "0.0005", "--picture", str(tmp_path / "arch.png")]
    with pytest.raises(SystemExit, match="0"):
        main(["check", str(arch), *words])
    assert "straight over its first 60 mm" in capsys.readouterr().out
    assert (tmp_path / "arch.png").stat().st_size > 10_000


def test_parts_that_fit_share_a_page(tmp_path):
    arch = ec.PlaneCurve.spline([(0, 0), (30, 60), (90, 60), (120, 0)], degree=3)
    strips = [
        ec.make_strip(arch, "card-200gsm", max_width=width, label=f"A{width}") for width in (20, 24, 28)
    ]
    placed = [ec.Placed(strip, (0, 50 * k, 0), (1, 0, 0), (0, 0, 1)) for k, strip in enumerate(strips)]
    kit = kit_contents(ec.Model(placed, name="class"), KitSpec(pages="A4"))
    model_kit(kit, step=False, pictures=False, parts=False).write(tmp_path)
    strips, templates = "A20, A24, A28", "A20 template, A24 template"
    last = "A28 template"
    assert titles(tmp_path / "class-pages.pdf") == [strips, templates, last], "for card and for paper"
    base = HolderSpec("base", ec.Sheet.named("mdf-3"))
    held = kit_contents(
        ec.Model(placed, name="held"), KitSpec(pages="A4", holders=(base,), ignore_limits=True)
    )
    model_kit(held, step=False, pictures=False, parts=False).write(tmp_path / "held")
    assert not any("template" in title for title in titles(tmp_path / "held" / "held-pages.pdf"))


def titles(pdf):
    """What each page of a PDF is called, as Poppler reads it."""
    message = subprocess.run(["pdftotext", pdf, "-"], capture_output=True, text=True, check=True).stdout
    return [page.partition(" print ")[0].strip() for page in message.split("\f") if page]
