"""Closed outlines as measured points: one smooth curve, wherever they begin, and advice that was tried."""

import re

import numpy as np
import pytest

from elastica_cad import PlaneCurve, StripSpec, check_equilibrium, read_curves
from elastica_cad.files import read_drawing
from elastica_cad.geometry.measured_points import estimate_noise
from elastica_cad.geometry.path import Spline, distances
from tests.command_line import run, suggested_commands

pytestmark = pytest.mark.core


def around(angles, *radii):
    return np.column_stack([np.cos(angles), np.sin(angles)]) * radii


def rounded_rectangle(long, wide, radius):
    centres = np.array([(1, 1), (-1, 1), (-1, -1), (1, -1)]) * (long - radius, wide - radius)
    corner = np.linspace(0, np.pi / 2, 200)
    return np.concatenate(
        [centre + around(corner + k * np.pi / 2, radius, radius) for k, centre in enumerate(centres)]
    )


def outline(kind, rng):
    """A dense closed polyline of a shape of random size."""
    angle, size = np.linspace(0, 2 * np.pi, 4000, endpoint=False), rng.uniform(80, 180)
    radii = {
        "guitar": 1 + 0.08 * np.cos(angle) + 0.25 * np.cos(2 * angle),
        "bean": 1 - 0.35 * np.exp(-(((angle - np.pi) / 0.6) ** 2)),
    }
    match kind:
        case "circle":
            line = around(angle, size, size)
        case "ellipse":
            line = around(angle, size, rng.uniform(0.55, 0.95) * size)
        case "rounded rectangle":
            line = rounded_rectangle(size, 0.7 * size, rng.uniform(0.2, 0.6) * size)
        case _:
            line = around(angle, size, 0.8 * size) * radii[kind][:, None]
    return np.concatenate([line, line[:1]])


def points_of(seed):
    """Points (n, 2) of an outline, rounded to a grid, from any start, with the first one repeated or not."""
    rng = np.random.default_rng(seed)
    kind = ("circle", "ellipse", "rounded rectangle", "guitar", "bean")[seed % 5]
    line, grid = outline(kind, rng), rng.choice([0.1, 0.5, 1.0])
    s = np.append(0.0, np.cumsum(np.hypot(*np.diff(line, axis=0).T)))
    count = int(rng.integers(12 if kind in ("circle", "ellipse") else 32, 60))
    at = (np.linspace(0, s[-1], count, endpoint=False) + rng.uniform(0, s[-1])) % s[-1]
    points = (np.column_stack([np.interp(at, s, x) for x in line.T]) / grid).round() * grid
    return kind, grid, np.concatenate([points, points[: seed // 5 % 2]])


def written(path, points):
    np.savetxt(path, points, delimiter=",", fmt="%.6g")
    return path


def farthest(points, curve):
    return float(distances(Spline(curve), np.asarray(points, dtype=float)).max())


CIRCLE_12 = around(np.arange(13) * np.pi / 6, 100, 100).round()
ELLIPSE = around(np.arange(24) * np.pi / 12, 120, 90)


@pytest.mark.parametrize(("points", "far", "ratio"), [
    (CIRCLE_12, 0.38, 1.05), ([*ELLIPSE.round(), ELLIPSE[0]], 0.45, 1.15), (ELLIPSE.round(1), 0.1, 1.05),
    ([*(2 * ELLIPSE).round() / 2, ELLIPSE[0]], 0.31, 1.1),
])  # fmt: skip
def test_rounded_points_give_a_closed_strip_without_an_option(tmp_path, points, far, ratio):
    (curve,) = read_curves(written(tmp_path / "outline.csv", points))
    assert curve.is_closed
    assert not curve.has_corners
    assert farthest(points, curve) <= far
    assert str(check_equilibrium(curve)).endswith("it has no inflections.")
    strip = StripSpec(curve, "birch-plywood-0.8", max_width=20).make()
    exact = np.ptp(points, axis=0).max() ** 3 / np.ptp(points, axis=0).min() ** 3
    assert strip.rod.ratio == pytest.approx(exact, rel=ratio - 1)


def test_the_noise_of_a_coarse_circle_is_its_rounding():
    """Differences of even orders were as large as the sagitta: 1 mm of noise, on open arcs too."""
    assert 0.1 < estimate_noise(CIRCLE_12) < 0.4
    assert 0.1 < estimate_noise(around(np.arange(15) * np.pi / 12, 100, 100).round()) < 0.4
    exact = around(np.arange(41) * np.pi / 20, 100, 100)
    for noise in (0.1, 1.0):
        noisy = exact + noise * np.random.default_rng(2).normal(size=exact.shape)
        assert estimate_noise([*noisy[:-1], noisy[0]]) == pytest.approx(noise, rel=0.3)


@pytest.mark.parametrize("seed", [1, 8, 13])
def test_the_curve_does_not_depend_on_the_first_point(tmp_path, seed):
    _, _, points = points_of(seed)
    ring = points[: len(np.unique(points, axis=0))]
    first, other = (
        read_curves(written(tmp_path / "outline.csv", np.roll(ring, shift, axis=0)))[0] for shift in (0, 5)
    )
    assert farthest(other.sample(400).position, first) < 1e-6
    assert other.at([0.0]).position[0] == pytest.approx(ring[-5], abs=2.0)
    assert other.length == pytest.approx(first.length, abs=1e-6)


def test_a_gap_of_one_step_is_closed_and_said_and_a_larger_one_is_not(tmp_path):
    for left_out, closed in ((1, True), (2, False), (4, False)):
        file = read_drawing(written(tmp_path / "c.csv", CIRCLE_12[:-left_out]))
        assert file.curves[0].curve.is_closed == closed
        assert any("curve 1 is closed" in text for text in file.notes) == closed
    halved = np.insert(CIRCLE_12[:-1], 1, CIRCLE_12[:2].mean(axis=0), axis=0)
    assert not read_curves(written(tmp_path / "c.csv", halved))[0].is_closed


def test_an_outline_with_one_corner_is_smooth_where_it_begins(tmp_path):
    """A drop begins anywhere; its only corner is its tip."""
    arc = around(np.radians(np.arange(-120, 121, 10)), 60, 60)
    drop = np.concatenate(
        [np.linspace((-120, 0), arc[0], 9)[:-1], arc, np.linspace(arc[-1], (-120, 0), 9)[1:-1]]
    )
    (curve,) = read_curves(
        written(tmp_path / "drop.csv", np.roll([*drop], 9, axis=0)[[*range(len(drop)), 0]])
    )
    assert curve.tangent_breaks == ()
    assert curve.at([0.0]).position[0] == pytest.approx((-120, 0), abs=0.1)
    assert np.degrees(abs(curve.seam_turn)) == pytest.approx(120, abs=3)


@pytest.mark.parametrize("degree", [3, 4, 5])
def test_a_closed_fit_is_smooth_all_round_and_as_near_as_reported(degree):
    points = around(np.linspace(0, 2 * np.pi, 200), 120, 90)
    points[-1] = points[0]
    curve = PlaneCurve.fit(points + 0.0, degree, tolerance=0.01)
    assert curve.is_closed
    assert curve.seam.continuity == degree - 1
    assert farthest(points, curve) <= 0.01


def test_smoothing_a_polygon_of_a_drawing_leaves_no_corner_at_its_start(tmp_path):
    """The advised distance made a corner where the polygon begins, and then advised itself."""
    corners = " ".join(f"{x:.3f},{y:.3f}" for x, y in 150 + around(np.arange(14) * np.pi / 7, 120, 120))
    (tmp_path / "polygon.svg").write_text(
        '<svg xmlns="http://www.w3.org/2000/svg" width="300mm" height="300mm" viewBox="0 0 300 300">'
        f'<polygon points="{corners}"/></svg>'
    )
    refused = run("check polygon.svg", cwd=tmp_path, code=2)
    (advised,) = re.findall(r"set --smooth to about ([\d.]+) mm to smooth it", refused.output)
    run("check polygon.svg --smooth", advised, cwd=tmp_path)


def test_a_command_for_another_program_has_no_option_that_it_lacks(tmp_path):
    """`strip` has no --picture."""
    written(tmp_path / "bean.csv", points_of(4)[2])
    checked = run("check bean.csv --picture bean.png", cwd=tmp_path, code=1)
    (command, *_) = suggested_commands(checked.output)
    assert "--picture" not in command
    run(f"{command} --no-step --no-pictures", cwd=tmp_path)


def typed_again(points, folder):
    """Return the exit codes of check and strip. Every command and number that they print must run."""
    written(folder / "outline.csv", points)
    words = "outline.csv --no-step --no-pictures --sheet birch-plywood-0.8 --max-width 25"
    results = [
        run(words, cwd=folder, code=None) for words in ("check outline.csv", f"strip {words} -o strip")
    ]
    output = "".join(result.output for result in results)
    for command in suggested_commands(output):
        run(f"{command} --no-step --no-pictures --force", cwd=folder)
    advice = re.sub(r"^Change .*", "", output, flags=re.MULTILINE)
    for option, number in re.findall(r"[sS]et (--[\w-]+) to ([\d.]+)", advice):
        run("check outline.csv", option, number, cwd=folder)
    assert "`elastica" not in advice
    return [result.exit_code for result in results]


def agreed(seed, folder):
    kind, grid, points = points_of(seed)
    codes = typed_again(points, folder)
    (curve,) = read_curves(folder / "outline.csv")
    assert curve.is_closed
    assert not curve.has_corners
    assert farthest(points, curve) <= 2 * grid
    if kind in ("circle", "ellipse"):
        assert codes == [0, 0]


@pytest.mark.parametrize("seed", [1, 4])
def test_a_closed_outline_is_a_strip_or_gets_commands_that_run(tmp_path, seed):
    agreed(seed, tmp_path)


@pytest.mark.campaign
@pytest.mark.parametrize("seed", range(100, 140))
def test_closed_outlines_are_strips_or_get_commands_that_run(tmp_path, seed):
    agreed(seed, tmp_path)


@pytest.mark.parametrize("grid", [0.1, 0.5, 1.0])
@pytest.mark.parametrize(("count", "wide"), [(9, 55), (10, 50), (12, 50)])
def test_an_ellipse_of_few_points_has_no_corner_at_its_ends(tmp_path, count, wide, grid):
    angle = np.linspace(0, 2 * np.pi, count, endpoint=False) + 0.6
    points = (around(angle, 100, wide) / grid).round() * grid
    file = tmp_path / "ellipse.csv"
    np.savetxt(file, points, delimiter=",")
    (curve,) = read_curves(file)
    assert not curve.has_corners
    assert distances(Spline(curve), points).max() < 2 * grid
    assert check_equilibrium(curve).realizable
