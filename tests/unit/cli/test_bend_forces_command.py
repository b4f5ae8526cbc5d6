"""`elastica bend` with a sheet and a width: newtons, strain and safety along a travel, as typed."""

import csv
import json
import re

import numpy as np
import pytest

from elastica_cad import Rod, Sheet, bend, bend_strip, make_strip, read_curves, stability_limit
from tests.command_line import run

ARCH = "0,0\n60,62\n120,95\n180,105\n240,95\n300,62\n360,0\n"


def test_a_spring_and_its_force_travel_curve(tmp_path):
    line = "bend --straight 120 --sheet spring-steel-0.2 --max-width 10 --to 110 0 --steps 5 -o out"
    made = run(line, cwd=tmp_path)
    rows = list(csv.DictReader((tmp_path / "out" / "straight-travel.csv").read_text().splitlines()))
    assert [round(float(row["travel_mm"]), 6) for row in rows] == [2.0, 4.0, 6.0, 8.0, 10.0]
    energy = [float(row["energy_Nmm"]) for row in rows]
    force = [float(row["force_along_N"]) for row in rows]
    # the work between two steps is what the energy grows by
    for k in range(1, 5):
        assert energy[k] - energy[k - 1] == pytest.approx((force[k] + force[k - 1]), rel=1e-3)
    titles, *_, last = [line.split("  ") for line in made.stdout.splitlines() if "stab" in line][:6]
    assert [text.strip() for text in titles if text][:3] == ["travel mm", "end force x N", "end force y N"]
    numbers = [float(text) for text in last if text and text.strip() != "stable"]
    assert numbers[:3] == [10, pytest.approx(float(rows[-1]["end_force_x_N"]), rel=5e-3), 0]
    assert {row["end_y_mm"] for row in rows} == {row["end_force_y_N"] for row in rows} == {"0"}, "no dust"
    assert (tmp_path / "out" / "straight-travel.png").stat().st_size > 10_000


def test_a_strain_beyond_the_sheet_is_reported(tmp_path):
    line = "bend --straight 60 --sheet acrylic-3 --max-width 10 --to 30 0 -o out"
    made = run(line, cwd=tmp_path)
    assert "the strain exceeds the limit of the material beyond" in made.stderr


def test_where_it_snaps_and_where_its_strain_is_too_much_is_reported_between_steps(tmp_path):
    (tmp_path / "arch.csv").write_text(ARCH)
    line = "bend arch.csv --sheet pom-1 --max-width 10 --to -100 0 --steps 4 -o out --json"
    made = run(line, cwd=tmp_path)
    answer, sheet = json.loads(made.stdout), Sheet.named("pom-1")
    strip = make_strip(read_curves(tmp_path / "arch.csv")[0], sheet, max_width=10.0)
    limit = stability_limit(strip.rod_to_bend, [(-100.0, 0.0)])
    assert answer["snaps_at"] == pytest.approx(460 * limit.parameter, rel=1e-3)
    strained = bend(strip.rod_to_bend, end=(360 - answer["strained_at"], 0.0))
    assert np.abs(strained.curvature).max() * sheet.thickness / 2 == pytest.approx(sheet.max_strain, rel=1e-3)
    assert any("the strip buckles at 417.9 mm of travel, and nothing" in note for note in answer["notes"])
    assert str(limit) == "stable up to 0.9085 on the path, where end is (-57.91, 0) mm: it buckles there"
    way = bend_strip(strip, [(-100.0, 0.0)])
    assert len(str(way).splitlines()) == 5, "titles, one step, where it snaps, crosses itself and is strained"
    assert repr(way) == "<Travel of 1 steps to 460 mm>"


def test_a_width_without_a_material(tmp_path):
    made = run("bend --straight 60 --max-width 10 --to 30 0", cwd=tmp_path, code=2)
    assert "Add --sheet" in made.stderr


def test_a_wide_spring_pushes_as_the_plate_that_it_becomes(tmp_path, wide_strips):
    """Straight it bends with E; where it is bent its edges alone curl across, and it is up to a tenth stiffer."""
    run("bend --straight 120 --sheet spring-steel-0.2 --max-width 20 --to 40 0 -o out", cwd=tmp_path)
    (row,) = csv.DictReader((tmp_path / "out" / "straight-travel.csv").read_text().splitlines())
    beam = bend(Rod.straight(120.0), end=(40.0, 0.0))
    strip = wide_strips.OwnStrip.cut(lambda s: np.full(np.shape(s), 20.0), Sheet.named("spring-steel-0.2"))
    own = strip.bent(beam, end=(40.0, 0.0))
    assert float(row["force_along_N"]) == pytest.approx(np.hypot(*own.force[-1]), rel=1e-3)
    assert float(row["end_moment_Nmm"]) == pytest.approx(own.moment[-1], rel=1e-3)
    flat = strip.stiffness(0.0) * np.hypot(*beam.force[-1])
    assert float(row["force_along_N"]) > 1.05 * flat


@pytest.mark.parametrize("gravity", [False, True])
def test_a_drawn_strip_is_as_wide_as_the_strip_that_is_made_of_it(tmp_path, gravity):
    (tmp_path / "arch.csv").write_text(ARCH)
    weight = " --gravity" if gravity else ""
    line = f"bend arch.csv --sheet acrylic-2 --max-width 40 --to 250 0 -o out{weight}"
    run(line, cwd=tmp_path)
    (row,) = csv.DictReader((tmp_path / "out" / "arch-travel.csv").read_text().splitlines())
    (curve,) = read_curves(tmp_path / "arch.csv")
    moved = bend_strip(make_strip(curve, "acrylic-2", max_width=40.0, gravity=gravity), [(250.0, 0.0)])
    assert float(row["force_along_N"]) == pytest.approx(moved.force_along[0], rel=1e-4)
    assert float(row["energy_Nmm"]) == pytest.approx(moved.energy[0], rel=1e-4)


def test_other_keys_of_the_strip_are_set(tmp_path):
    (tmp_path / "arch.csv").write_text(ARCH)
    line = "bend arch.csv --sheet pom-1 --to 300 0 --set max_width=12 --set samples=301 -o out --json"
    answer = json.loads(run(line, cwd=tmp_path).stdout)
    strip = make_strip(read_curves(tmp_path / "arch.csv")[0], "pom-1", max_width=12.0, samples=301)
    moved = bend_strip(strip, [(300.0, 0.0)])
    assert answer["travel"]["force_along_N"] == pytest.approx(moved.force_along.tolist(), rel=1e-4)


@pytest.mark.parametrize(
    ("words", "says"),
    [
        ("--set samples=301", "--set has no effect without --sheet. Add --sheet"),
        (
            "--sheet pom-1 --max-width 10 --set max_width=12",
            "--max-width and --set max_width set the same value",
        ),
        ("--sheet pom-1 --set max_widht=12", "did you mean max_width?"),
        (
            "--sheet pom-1 --ratio 3",
            "use --set limits.ratio=VALUE instead of --ratio: `elastica help limits.ratio`",
        ),
    ],
)
def test_settings_are_refused_in_a_sentence(words, says, tmp_path):
    (tmp_path / "arch.csv").write_text(ARCH)
    made = run(f"bend arch.csv --to 300 0 {words}", cwd=tmp_path, code=2)
    assert says in made.stderr


LOW = "0,0\n50,14\n100,24\n150,28\n200,24\n250,14\n300,0\n"
TURNED = "--sheet pom-0.5 --max-width 10 --start-angle -40 --end-angle 40"


@pytest.mark.parametrize("to", ["--start-angle -40 --end-angle 40", "--end-angle 60 --to 260 30"])
def test_the_share_at_which_it_snaps_is_of_the_whole_movement(tmp_path, to):
    """However many steps it is made of; by turn where only the ends turn."""
    (tmp_path / "low.csv").write_text(LOW)
    shares = []
    for steps in (1, 6):
        made = run(f"bend low.csv {to} --steps {steps} -o out --force", cwd=tmp_path)
        shares += [
            float(one)
            for one in re.findall(r"the strip snaps into another shape after ([\d.]+) %", made.stderr)[:1]
        ]
    assert shares == pytest.approx([shares[0]] * 2, abs=0.3)


def test_places_of_a_turn_are_in_degrees(tmp_path):
    (tmp_path / "low.csv").write_text(LOW)
    made = run(f"bend low.csv {TURNED} --steps 6 -o out --json", cwd=tmp_path)
    answer = json.loads(made.stdout)
    assert sum("snaps into another shape" in note for note in answer["notes"]) == 1
    printed = run("bend low.csv --start-angle -40 --end-angle 40 -o out --force", cwd=tmp_path).output
    (share,) = re.findall(r"the strip snaps into another shape after ([\d.]+) %", printed)
    whole = answer["travel"]["turn_deg"][-1]
    assert answer["unit"] == "deg"
    assert set(answer["travel"]["travel_mm"]) == {0.0}
    assert answer["snaps_at"] == pytest.approx(float(share) / 100 * whole, rel=0.01)
    assert any(f"shape at {answer['snaps_at']:.4g} degrees of turn" in one for one in answer["notes"])
    assert not any("of travel" in one or "force falls" in one for one in answer["notes"])
    step = bend_strip(make_strip(read_curves(tmp_path / "low.csv")[0], "pom-0.5", max_width=10.0), [{}])
    assert step.unit == "%"
