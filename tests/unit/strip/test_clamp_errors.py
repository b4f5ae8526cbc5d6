"""Strips that a small error of a clamp lets snap, against the boundary value problem of the rod."""

import json
import re

import numpy as np
import pytest
from scipy.integrate import solve_bvp

import elastica_cad as ec
from elastica_cad.design.measuring_sheet import measuring_of
from elastica_cad.design.reports import report_strip
from elastica_cad.kit.kit_contents import kit_contents
from elastica_cad.strip.summary import strip_rows
from tests.command_line import run

POLES = [
    (0, -10.7),
    (50, -24.9),
    (100, -9.7),
    (150, -0.3),
    (200, 0.3),
    (250, -24.7),
    (300, 14.6),
    (350, -8.4),
]
SHEET, WIDTH = "polypropylene-0.6", 30


def moved(strip, turn):
    """Return how far the strip moves, mm, if its end is turned by `turn` rad. Infinite if no shape is near."""
    s, place = strip.rod.s, strip.rod.position
    B = strip.sheet.youngs_modulus * strip.sheet.thickness**3 / 12 * strip.width(s)
    theta = np.unwrap(strip.rod.angle)
    moment = B * np.gradient(theta, s)

    def slopes(at, state, force):
        _, _, angle, moment = state
        bend = moment / np.interp(at, s, B)
        return np.array(
            [np.cos(angle), np.sin(angle), bend, force[0] * np.sin(angle) - force[1] * np.cos(angle)]
        )

    def ends(first, last, force):
        angles = [first[2] - theta[0], last[2] - theta[-1] - turn]
        return np.concatenate([first[:2] - place[0], last[:2] - place[-1], angles])

    start = np.vstack([place.T, theta, moment])
    force = np.linalg.lstsq(
        np.stack([np.sin(theta), -np.cos(theta)], axis=1), np.gradient(moment, s), rcond=None
    )[0]
    solution = solve_bvp(slopes, ends, s, start, p=force, tol=1e-5, max_nodes=20000)
    if not solution.success:
        return np.inf
    return float(np.hypot(*(solution.sol(s)[:2] - place.T)).max())


def test_a_strip_that_snaps_at_an_error_of_a_clamp_is_not_called_stable(tmp_path):
    points = "\n".join(f"{x} {y}" for x, y in POLES)
    (tmp_path / "wave.txt").write_text(f"4 {len(POLES)}\n{points}\n")
    options = f"wave.txt --sheet {SHEET} --max-width {WIDTH}"
    refused = run(f"strip {options} -o out", cwd=tmp_path, code=None).output
    changes = re.findall(r"^Change +(.*)", refused, re.M)
    assert changes[0].startswith("Rest the strip on a rail")
    assert "the strip snaps at a small error of a clamp" in changes[-1]
    printed = run(f"strip {options} --nearest --stable -o out", cwd=tmp_path).output
    ((text, turn),) = re.findall(
        r"! Stability (close to snapping: .* clamp at its end is turned by ([\d.]+) degrees.*)", printed
    )
    report = json.loads((tmp_path / "out/wave.json").read_text())
    assert report["stability"]["word"] == "low"
    assert text.startswith(report["stability"]["meaning"])
    assert report["stability"]["meaning"] in report["warnings"]
    assert re.search(r"^Accuracy +not computed, because the strip can snap", printed, re.M)
    assert report["held"] is None
    (curve,) = ec.read_curves(tmp_path / "wave.txt")
    spec = ec.StripSpec(curve, SHEET, max_width=WIDTH, limits=ec.Limits(margin=5.0), keep=ec.Keep())
    strip = spec.make()
    assert moved(strip, np.radians(float(turn) / 4)) < 1
    assert moved(strip, np.radians(4 * float(turn))) > 5


@pytest.mark.parametrize("rise", [40.0, 150.0])
def test_arches_stay_stable_under_usual_errors(rise):
    strip = ec.make_strip(
        ec.PlaneCurve.spline([(0, 0), (100, rise), (300, rise), (400, 0)], degree=3), SHEET, max_width=WIDTH
    )
    rows = {row.label: row.text for row in strip_rows(strip)}
    assert rows["Stability"].startswith("stable")
    assert rows["Accuracy"].startswith("about")


def test_no_accuracy_is_stated_of_an_unstable_strip():
    wave = ec.PlaneCurve.spline([(0, 0), (80, 120), (140, -120), (220, 140), (300, -80), (380, 20)], degree=4)
    strip = ec.StripSpec(wave, SHEET, max_width=20, limits=ec.Limits(ratio=5.0)).make()
    rows = {row.label: row.text for row in strip_rows(strip)}
    assert rows["Stability"].startswith("unstable")
    assert rows["Accuracy"] == "not computed, because the strip can snap into another shape"
    assert report_strip(strip, name="wave", files={})["held"] is None
    contents = kit_contents(ec.Model([ec.Placed(strip)]), effects=True)
    assert not contents.held
    assert "not computed for strips that can snap into another shape" in " ".join(contents.notes)
    measuring = measuring_of(contents.report["parts"][0]["measuring"])
    odd = measuring.expected | {"height_1": 190.0, "height_2": -160.0, "height_3": 185.0}
    assert "may have snapped into another shape" in measuring.compare(odd)[0].text
