"""Strips that nothing was fitted to: what is told of them, beside what finite elements found."""

import json
from pathlib import Path

import pytest

from tests.campaign.finite_elements.drawn_requests import requests_drawn

MEASURED = Path(__file__).parents[1] / "campaign/finite_elements/measured.json"


@pytest.fixture(scope="module")
def rows():
    return {row["name"]: row for row in json.loads(MEASURED.read_text(encoding="utf-8"))["drawn"]}


@pytest.fixture(scope="module")
def requests():
    return dict(requests_drawn())


def test_all_of_them_stray_as_reported(rows):
    assert len({name.removesuffix(", made up for") for name in rows}) == 12
    assert all(abs(row["strayed"] - row["told"]) <= row["open"] for row in rows.values())


@pytest.mark.campaign
@pytest.mark.parametrize("name", ["plain, even", "slotted, ply", "tabbed, even", "tabbed, ply"])
def test_a_strip_is_reported_as_it_was_measured(name, rows, requests):
    held = requests[name].changed(compensate=False).make().held()
    found, length = rows[name]["strayed"], rows[name]["length"]
    assert abs(held.deviation - found * length) <= held.open
    assert 1 / 1.6 < found * length / held.deviation < 1.6
