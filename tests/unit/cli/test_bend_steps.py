"""`elastica bend` follows one path, whatever number of its shapes is listed: ends first, then the new loads."""

import json

import numpy as np
import pytest

import elastica_cad as ec
from elastica_cad.mechanics.bending import bend_path
from elastica_cad.strip.travel import bend_strip
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
    for answer in answers:
        load, sag = (np.array(answer["travel"][name]) for name in ("load_N", "sag_mm"))
        assert not sag[load == 0].any()  # the ends move, and nothing sags
        assert (sag[load > 0] > 0).all()
    ends = [answer["shapes"][-1] for answer in answers]
    for end in ends[1:]:
        assert end["size"] == pytest.approx(ends[0]["size"], rel=1e-7)
        assert end["margin"] == pytest.approx(ends[0]["margin"], rel=1e-6)


def random_move(seed):
    """Straight or arched strip whose end moves, with a rail, pin, cord or nothing, and perhaps a force."""
    rng = np.random.default_rng(seed)
    rod, side = ec.Rod.straight(300.0, samples=101), int(rng.choice([-1, 1]))
    if rng.random() < 0.5:
        rise, share = rng.uniform(20, 120), rng.uniform(0.6, 1.0)
        arch = ec.PlaneCurve.spline([(0, 0), (60, rise), (160, share * rise), (240, 0)], degree=3)
        rod, side = ec.optimal_rod(arch, samples=101), None
    move = rng.uniform(0.02, 0.2) * rod.length * np.array([-1.0, rng.uniform(-0.5, 0.5)])
    at = rng.uniform(0.3, 0.7, 3) * rod.length
    step = {
        "end": rod.position[-1] + move,
        "supports": ec.Supports("pinned", str(rng.choice(["pinned", "clamped"]))),
    }
    held = [(), ec.Rail(at[0]), ec.Pin(at[0]), ec.Tie(0.2 * rod.length, 0.8 * rod.length)][rng.integers(4)]
    step |= {"between": held, "loads": ec.PointForce(at[1], (0.0, -rng.uniform(0.02, 2.0)))}
    return ec.Strip(rod, "pom-2", max_width=20), step, side


@pytest.mark.parametrize("seed", range(10))
def test_random_moves_do_not_depend_on_the_number_of_steps(seed):
    strip, step, side = random_move(seed)
    one, several = (bend_strip(strip, [step], side=side, steps=steps) for steps in (1, 7))
    assert one.rods[-1].position == pytest.approx(several.rods[-1].position, abs=1e-6)
    assert [(k, event.kind) for k, event in one.leaps] == [(k, event.kind) for k, event in several.leaps]
    for name in ("snaps_at", "strained_at", "crosses_at"):
        assert getattr(one, name) == getattr(several, name)


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
