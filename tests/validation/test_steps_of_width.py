"""Corners beside a step of the width carry nothing: told beside 3D finite elements, and made up for."""

import json
from pathlib import Path

import numpy as np
import pytest

from elastica_cad import Profile
from elastica_cad.strip import compensate_widths
from tests.campaign.finite_elements.cases import CASES

pytestmark = pytest.mark.core

STEPPED = {(case.group, case.name): case for case in CASES if case.group.startswith("steps of width")}
MEASURED = json.loads(
    (Path(__file__).parents[1] / "campaign/finite_elements/measured.json").read_text(encoding="utf-8")
)


def rows(widths):
    return [row for row in MEASURED[widths] if row["group"].startswith("steps of width")]


@pytest.mark.parametrize("row", rows("plain widths"), ids=lambda row: f"{row['group']}, {row['name']}")
def test_reported_as_finite_elements_have_it(row):
    spec = STEPPED[row["group"], row["name"]].spec
    held = spec.changed(compensate=False).make().held()
    assert held.parts["steps of width"] == max(held.parts.values())
    assert held.deviation == pytest.approx(row["strayed"] * row["length"], abs=held.open)
    usual = spec.make().held()
    assert set(usual.parts) == {"steps of width"}
    better = compensate_widths(spec.changed(compensate=False).make())
    assert better.held_deviation < 0.25 * held.deviation


@pytest.mark.parametrize("row", rows("compensated"), ids=lambda row: f"{row['group']}, {row['name']}")
def test_widths_make_up_for_them(row):
    assert row["strayed"] < 5e-4


def test_a_strip_without_steps_has_no_such_cause():
    arch = next(case for case in CASES if case.curve == "arch").spec
    assert "steps of width" not in arch.make().held().parts


def test_steps_of_a_profile():
    """Ramps that stand for steps, whatever knots lie in them; a gentle slope is none."""
    steep = [(99.9995, 0), (100.0, 1), (100.0005, 0), (150.0, 0), (160.0, 0)]
    profile = Profile.fit(
        lambda s: np.interp(s, [99.9995, 100.0005], [1.0, 2.0]), 200.0, breaks=steep, tolerance=1e-6
    )
    assert profile.steps == ((99.9995, 100.0005),)
    assert Profile.interpolate([0.0, 1.0, 2.0], [1.0, 2.0, 3.0]).steps == ()
