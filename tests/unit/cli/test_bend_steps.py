"""`elastica bend` follows one path, whatever number of its shapes is listed: ends first, then the new loads."""

import json

import numpy as np
import pytest

import elastica_cad as ec
from elastica_cad.mechanics.bending import bend_path
from tests.command_line import run

HUNG = "--hold-start pinned --hold-end pinned --side left --sheet spring-steel-0.5 --max-width 20"


@pytest.fixture(autouse=True)
def without_pictures(monkeypatch):
    """As without matplotlib, for speed."""
    monkeypatch.setattr("elastica_cad.cli.bend_command.can_draw", lambda: False)


def bent(options, folder):
    return json.loads(run(f"bend {options} --json --force", cwd=folder).stdout)


def hung(mass, folder, steps=1):
    return bent(f"--straight 300 {HUNG} --to 280 0 --point-mass 150 {mass} --steps {steps}", folder)


def test_a_mass_is_hung_on_the_strip_that_stands(tmp_path):
    """Own steps of the load: the strip bent up carries 1.2 kg, and snaps under 1.23 kg."""
    light, heavy = hung("1.2kg", tmp_path), hung("3kg", tmp_path)
    assert light["snaps_at"] is None
    assert light["shapes"][-1]["size"][1] > 40
    assert heavy["snaps_at"] == pytest.approx(12.04, abs=0.02)
    strip = ec.Strip(ec.Rod.straight(300, supports=ec.Supports("pinned", "pinned")), "spring-steel-0.5", 20)
    up = ec.bend(strip.rod_to_bend, end=(280, 0), side=1)
    heights = []
    for newtons in (11.9, 12.2):
        loads = [ec.PointForce(150, (0, -part * newtons)) for part in np.linspace(0, 1, 41)[1:]]
        heights.append(bend_path(up, [{"loads": load} for load in loads])[-1].position[:, 1].max())
    assert heights[0] > 40 > heights[1]


def test_the_number_of_steps_only_lists(tmp_path):
    answers = [hung("3kg", tmp_path, steps) for steps in (1, 7, 60)]
    assert [len(answer["shapes"]) for answer in answers] == [2, 14, 120]
    assert len({round(answer["snaps_at"], 6) for answer in answers}) == 1
    ends = [answer["shapes"][-1] for answer in answers]
    for end in ends[1:]:
        assert end["size"] == pytest.approx(ends[0]["size"], rel=1e-7)
        assert end["margin"] == pytest.approx(ends[0]["margin"], rel=1e-6)


def test_the_load_and_its_sag_are_the_axes(tmp_path):
    """A cantilever under a force at its end: sag F L^3 / (3 E I), from a row without load on."""
    line = "--straight 200 --sheet pom-2 --max-width 20 --hold-end free --point-force 200 0 -0.02 --steps 4"
    travel = bent(line, tmp_path)["travel"]
    printed = run(f"bend {line} --force", cwd=tmp_path).stdout
    load, sag = (np.array(travel[name]) for name in ("load_N", "sag_mm"))
    assert load == pytest.approx([0, 0.005, 0.01, 0.015, 0.02])
    assert sag[1:] / load[1:] == pytest.approx(np.full(4, sag[-1] / load[-1]), rel=2e-3)
    sheet = ec.Sheet.named("pom-2")
    law = ec.Strip(ec.Rod.straight(200), sheet, 20).bending_stiffness
    assert sag[-1] == pytest.approx(0.02 * 200**3 / (3 * law), rel=2e-2)
    assert "load N" in printed
    assert "sag mm" in printed


def test_a_clamped_beam_under_a_mass_in_its_middle(tmp_path):
    """The stiffness of a beam between clamps that may approach each other is 192 E I / L^3."""
    line = "--straight 400 --sheet spring-steel-0.5 --max-width 20 --hold-end slide-x"
    one, two = (bent(f"{line} --point-mass 200 {mass}", tmp_path) for mass in (1, 2))
    B = ec.Strip(ec.Rod.straight(400), "spring-steel-0.5", 20).bending_stiffness
    more = two["travel"]["sag_mm"][-1] - one["travel"]["sag_mm"][-1]
    assert more == pytest.approx(9.80665e-3 * 400**3 / (192 * B), rel=2e-2)
