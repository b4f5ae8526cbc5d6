"""The weight of strips that are designed without it: the warning, and its number against other equations."""

import re

import numpy as np
import pytest
from scipy.integrate import cumulative_trapezoid, solve_bvp

import elastica_cad as ec
from elastica_cad.mechanics import trials
from tests.command_line import run

ARCH = [(50, 0), (250, 300), (950, 300), (1150, 0)]
SVG = """<svg xmlns="http://www.w3.org/2000/svg" width="1200mm" height="400mm" viewBox="0 0 1200 400">
<path d="M 50 350 C 250 50 950 50 1150 350" fill="none" stroke="black"/></svg>"""
STANDS = "if the curve stands upright"


def gentle_csv(folder):
    """Write a wavy curve of 1.5 m that rises 48 mm."""
    x = np.linspace(0, 1500, 51)
    y = 40 * np.sin(np.pi * x / 1500) + 8 * np.sin(np.pi * x / 300)
    lines = [f"{a:.3f},{b:.3f}" for a, b in zip(x, y, strict=True)]
    (folder / "gentle.csv").write_text("\n".join(["x,y", *lines]) + "\n")


def sagged(strip):
    """Return how far the strip moves, mm, by the boundary value problem of an inextensible rod with its weight."""
    sheet, s, place = strip.sheet, strip.rod.s, strip.rod.position
    B = sheet.youngs_modulus * sheet.thickness**3 / 12 * strip.width(s)
    load = sheet.density * 1e-9 * 9.80665 * sheet.thickness * strip.width(s)
    hung = cumulative_trapezoid(load, s, initial=0)
    theta = np.unwrap(strip.rod.angle)
    moment = B * np.gradient(theta, s)

    def slopes(at, state, force):
        _, _, angle, moment = state
        up = force[1] + np.interp(at, s, hung)
        bend = moment / np.interp(at, s, B)
        return np.array([np.cos(angle), np.sin(angle), bend, force[0] * np.sin(angle) - up * np.cos(angle)])

    def ends(first, last, force):
        return np.concatenate(
            [first[:2] - place[0], last[:2] - place[-1], [first[2] - theta[0], last[2] - theta[-1]]]
        )

    first = np.vstack([place.T, theta, moment])
    solution = solve_bvp(slopes, ends, s, first, p=np.zeros(2), tol=1e-6, max_nodes=20000)
    assert solution.success, solution.message
    return float(np.hypot(*(solution.sol(s)[:2] - place.T)).max())


def test_the_strip_command_states_how_far_the_weight_moves_a_long_arch(tmp_path):
    (tmp_path / "arch.svg").write_text(SVG)
    options = "--sheet birch-plywood-0.8 --max-width 60"
    printed = run(f"strip arch.svg {options} -o out", cwd=tmp_path).output
    strip = ec.make_strip(ec.PlaneCurve.spline(ARCH, degree=3), "birch-plywood-0.8", max_width=60)
    far = float(re.search(r"moves the strip by ([\d.]+) mm .* set --gravity", printed).group(1))
    assert far == pytest.approx(sagged(strip), rel=0.05)
    assert STANDS not in run(f"strip arch.svg {options} --gravity -o heavy", cwd=tmp_path).output


def test_the_weight_of_a_curve_of_very_many_pieces_has_one_sentence(tmp_path, monkeypatch):
    monkeypatch.setattr(trials, "MOST_PIECES", 0)
    (tmp_path / "arch.svg").write_text(SVG)
    options = "--sheet birch-plywood-0.8 --max-width 60 --no-step --no-pictures"
    printed = run(f"strip arch.svg {options} -o out", cwd=tmp_path).output
    assert STANDS not in printed
    assert re.search(r"The effect of the weight is not computed, because the curve has \d+ pieces", printed)


def test_a_suggestion_that_collapses_under_its_weight_states_it(tmp_path):
    gentle_csv(tmp_path)
    options = "gentle.csv --sheet birch-plywood-0.8 --max-width 120"
    advice = run("check gentle.csv", cwd=tmp_path, code=None).output
    assert "collapses under its own weight if it stands upright" in advice
    printed = run(f"strip {options} --nearest --stable -o out", cwd=tmp_path).output
    carried = float(re.search(r"the strip collapses under ([\d.]+) % of its weight", printed).group(1))
    assert 5 <= carried <= 30
    printed = run("bend out/gentle.json --gravity -o bent", cwd=tmp_path).output
    (snaps_at,) = re.findall(r"snaps into another shape \w+ ([\d.]+) %", printed)
    assert float(snaps_at) == pytest.approx(carried, abs=1)
    assert re.findall(r"Stability +(.*)", printed) == ["snaps on the way; the shape is stable in its plane"]


@pytest.mark.parametrize("frame", [None, ec.Frame(x_axis=(1, 0, 0), y_axis=(0, 0, 1))])
def test_upright_strips_are_warned_of(frame):
    curve = ec.PlaneCurve.spline(ARCH, degree=3)
    strip = ec.make_strip(curve, "birch-plywood-0.8", max_width=60, frame=frame)
    assert any(STANDS in text for text in strip.warnings)


def test_hinges_give_way_to_less_weight_than_clamps():
    """The whole strip weighs less than E I / length^2, below which strips with clamped ends have no warning."""
    hinged = ec.Supports("pinned", "pinned")
    bow = ec.bend(ec.Rod.straight(400, samples=201), end=(0, 320), supports=hinged).curve
    for supports in (hinged, None):
        strip = ec.make_strip(bow, "birch-plywood-0.8", max_width=15, supports=supports)
        assert any(STANDS in text for text in strip.warnings) == (supports is hinged)


def test_level_strips_small_strips_and_bows_have_no_warning():
    curve = ec.PlaneCurve.spline(ARCH, degree=3)
    level = ec.make_strip(curve, "birch-plywood-0.8", max_width=60, frame=ec.Frame())
    small = ec.make_strip(curve.transformed(np.diag([0.3, 0.3, 1])), "birch-plywood-0.8", max_width=20)
    glass = ec.Sheet("glass", 8.0, 38000.0, density=1900.0, max_strain=0.02)
    bow = ec.bow(ec.PlaneCurve.arc((0, 0), 5000, 0.6 * np.pi, 0.4 * np.pi), glass, max_width=30, min_width=30)
    for strip in (level, small, bow.strip):
        assert not any(STANDS in text for text in strip.warnings)


def test_a_straight_strip_between_its_ends_cannot_sag():
    straight = ec.Rod.straight(1500, [1, 1, 1])
    spec = ec.StripSpec(straight.curve, "birch-plywood-0.8", max_width=40)
    assert not any(STANDS in text for text in spec.make().warnings)
