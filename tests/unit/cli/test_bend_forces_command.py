"""`elastica bend` with a sheet and a width: newtons, strain and safety along a travel, as typed."""

import csv
import subprocess
import sys

import pytest


def typed(line, cwd):
    return subprocess.run(
        [sys.executable, "-m", "elastica_cad", *line.split()],
        cwd=cwd,
        capture_output=True,
        text=True,
        check=False,
    )


def test_a_spring_and_its_force_travel_curve(tmp_path):
    line = "bend --straight 120 --sheet spring-steel-0.2 --max-width 10 --to 110 0 --steps 5 -o out"
    made = typed(line, tmp_path)
    assert made.returncode == 0, made.stderr
    rows = list(csv.DictReader((tmp_path / "out" / "straight-travel.csv").read_text().splitlines()))
    assert [round(float(row["travel_mm"]), 6) for row in rows] == [2.0, 4.0, 6.0, 8.0, 10.0]
    energy = [float(row["energy_Nmm"]) for row in rows]
    force = [float(row["force_along_N"]) for row in rows]
    # the work between two steps is what the energy grows by
    for k in range(1, 5):
        assert energy[k] - energy[k - 1] == pytest.approx((force[k] + force[k - 1]), rel=1e-3)
    assert f"travel 10 mm: end pushed by ({float(rows[-1]['end_force_x_N']):.4g}, 0) N" in made.stdout
    assert "safety" in made.stdout
    assert {row["end_y_mm"] for row in rows} == {row["end_force_y_N"] for row in rows} == {"0"}, "no dust"
    assert (tmp_path / "out" / "straight-travel.png").stat().st_size > 10_000


def test_a_strain_beyond_the_sheet_is_told(tmp_path):
    line = "bend --straight 60 --sheet acrylic-3 --max-width 10 --to 30 0 -o out"
    made = typed(line, tmp_path)
    assert made.returncode == 0
    assert "strained beyond what the sheet bears" in made.stderr


def test_a_width_without_a_material(tmp_path):
    made = typed("bend --straight 60 --max-width 10 --to 30 0", tmp_path)
    assert made.returncode == 2
    assert "add --sheet" in made.stderr
