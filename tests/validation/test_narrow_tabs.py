"""Corners beside narrow tabs: the model and its open part beside finite elements of strips drawn by a seed."""

import json
from pathlib import Path

import numpy as np
import pytest

from elastica_cad.mechanics import crack_energy
from elastica_cad.strip.as_made import idle_length
from tests.campaign.finite_elements.drawn_requests import tab_requests

pytestmark = pytest.mark.core

MEASURED = Path(__file__).parents[1] / "campaign/finite_elements/measured.json"
REQUESTS = dict(tab_requests())


@pytest.fixture(scope="module")
def rows():
    return {row["name"]: row for row in json.loads(MEASURED.read_text(encoding="utf-8"))["tabs"]}


@pytest.mark.parametrize("name", REQUESTS)
def test_model_and_open_part_cover_finite_elements_by_at_most_twice(name, rows):
    held, row = REQUESTS[name].make().held(), rows[name]
    strayed = row["strayed"] * row["length"]
    assert strayed <= held.deviation + held.open <= 2 * strayed
    assert abs(held.deviation - strayed) <= held.open


def half_plane(nu, ratio):
    """Moment over |k| slope of waves exp(i k y) on the edge of a plate, from its four equations, for E h^3 = 12.

    E across follows from E / G = ratio, and nu is the geometric mean of both ratios.
    """
    r = np.sqrt(2 * (1 + nu) / ratio)
    along, across, cross = np.array([1.0, r**2, nu * r]) / (1 - nu**2)
    twist = 1 / ratio
    decays = np.sqrt(np.roots([along, -2 * (cross + 2 * twist), across]).astype(complex))
    shears = along * decays**3 - (cross + 4 * twist) * decays
    part = np.array([1.0, -shears[0] / shears[1]])
    return float(((part @ (along * decays**2 - cross)) / (part @ decays)).real)


@pytest.mark.parametrize(("nu", "grain"), [(0.0, 1.0), (0.3, 1.0), (0.1, 2.6), (0.2, 0.9), (0.45, 4.0)])
def test_the_energy_of_a_crack_is_that_of_a_half_plane(nu, grain):
    expected = (
        np.pi / 2 / half_plane(nu, 2 * (1 + nu) * grain**2 * (1 + 1e-6))
    )  # equal roots are another case
    assert crack_energy(nu, grain) == pytest.approx(expected, rel=1e-5)


def test_short_idle_corners_add_their_depth_squared_over_the_width():
    assert idle_length(20.0, 19.0, 0.0) == pytest.approx(0.5**2 / 20.0, rel=5e-3)
    assert idle_length(20.0, 4.0, 1.0) > 1.1 * idle_length(20.0, 4.0, 0.1)
