"""`elastica bend NAME-bent.json`: a bent strip is bent further from its last shape."""

import json

import numpy as np
import pytest

from elastica_cad import read_curves
from tests.command_line import run

ARCH = "0,0\n60,62\n120,95\n180,105\n240,95\n300,62\n360,0\n"
SHEET = "arch.csv --sheet pom-1 --set samples=201"
POM = f"{SHEET} --max-width 12"


@pytest.fixture(scope="module")
def desk(tmp_path_factory):
    folder = tmp_path_factory.mktemp("desk")
    (folder / "arch.csv").write_text(ARCH)
    return folder


@pytest.fixture(autouse=True)
def without_pictures(monkeypatch):
    """As without matplotlib, for speed."""
    monkeypatch.setattr("elastica_cad.cli.bend_command.can_draw", lambda: False)


def bent(line, cwd):
    return json.loads(run(f"bend {line} --json --force", cwd=cwd).stdout)


STRIPS = {
    "loaded": f"{POM} --tie 60 300 --pin 220 --point-mass 100 5 --point-force 250 0 -0.05",
    "rail": f"{POM} --rail 180 --point-mass 180 30",
    "pre-bent": f"{POM} --set natural_curvature=0.002 --gravity",
    "perforated": f"{SHEET} --set style.kind=perforated --set style.width=40",
    "backed": f"{SHEET} --set style.kind=laminated --set style.width=30 --set style.backing=pom-0.5",
    "rod": "arch.csv --rod 3 --sheet gfrp-1 --point-mass 150 50",
    "drawn shape": "arch.csv",
    "even shape": "arch.csv --even",
    "shape": "--straight 360 --side left --to 340 0",
    "wide spring": "--straight 360 --sheet spring-steel-0.2 --max-width 40 --side left --to 350 0",
}


@pytest.mark.parametrize("kind", STRIPS)
def test_a_strip_goes_on_from_its_last_shape(desk, kind):
    """In two commands, the strip comes to the shape and forces of one command."""
    line, to = STRIPS[kind], 365 if kind == "rail" else 330
    name = "straight" if "--straight" in line else "arch"
    bent(f"{line} -o a", desk)
    further = bent(f"a/{name}-bent.json --to {to} 0 -o b", desk)
    direct = bent(f"{line.partition(' --to')[0]} --to {to} 0 -o c", desk)
    compare(direct, further, rel=1e-5)
    one, other = (
        read_curves(desk / path)[-1] for path in (f"b/{name}-bent-bent.json", f"c/{name}-bent.json")
    )
    assert np.abs(one.sample(101).position - other.sample(101).position).max() < 1e-3


def compare(expected, obtained, rel):
    (one,), (other,) = expected["shapes"][-1:], obtained["shapes"][-1:]
    for key in ("start", "end", "angles", "size", "largest_curvature", "margin"):
        assert other[key] == pytest.approx(one[key], rel=rel, abs=1e-5), key
    for element, same in zip(one["between"], other["between"], strict=True):
        assert same["kind"] == element["kind"]
        assert np.array(same["force"]) == pytest.approx(np.array(element["force"]), rel=100 * rel, abs=1e-6)
    if expected["travel"] is not None:
        for key in ("end_force_x_N", "end_force_y_N", "end_moment_Nmm", "energy_Nmm", "safety"):
            last = expected["travel"][key][-1]
            assert obtained["travel"][key][-1] == pytest.approx(last, rel=10 * rel, abs=1e-4), key


def test_loads_and_elements_of_a_bent_strip_are_replaced_and_its_weight_is_added(desk):
    bent(f"{POM} --rail 150 --point-force 200 0 -0.05 -o a", desk)
    freed = bent("a/arch-bent.json --release --point-force 200 0 -0.05 -o b", desk)
    assert [element["kind"] for element in freed["shapes"][0]["between"]] == ["point force"]
    bent(f"{POM} -o a", desk)
    heavy, direct = (
        bent("a/arch-bent.json --gravity -o b", desk),
        bent(f"{POM} --point-mass 200 0 -o c", desk),
    )
    assert heavy["travel"]["start_force_y_N"] == pytest.approx(direct["travel"]["start_force_y_N"], rel=1e-4)


@pytest.mark.parametrize(
    "option", ["--sheet pom-1", "--max-width 9", "--curve 1", "--rod 3", "--set samples=9", "--nearest"]
)
def test_options_of_the_design_are_refused(desk, option):
    bent(f"{POM} -o a", desk)
    refused = run(f"bend a/arch-bent.json {option} -o b", cwd=desk, code=2).stderr
    assert f"The strip is already bent, so {option.split()[0]} has no effect." in " ".join(refused.split())


def test_a_damaged_bent_strip_is_refused_and_other_commands_read_its_curves(desk):
    bent(f"{POM} --to 350 0 --steps 2 -o a", desk)
    assert "Read" in run("check a/arch-bent.json --curve 2", cwd=desk).stdout
    data = json.loads((desk / "a/arch-bent.json").read_text())
    data["bent"]["rod"]["record"] = "os"
    (desk / "bad.json").write_text(json.dumps(data))
    assert "The record `bent` of the report cannot be read" in run("bend bad.json", cwd=desk, code=2).stderr
    del data["bent"]
    (desk / "old.json").write_text(json.dumps(data))
    assert bent("old.json --curve 2 --to 340 0 -o b", desk)["travel"] is None
