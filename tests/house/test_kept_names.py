"""Names of earlier versions that users type or store are still there."""

import json

import pytest

from tests.house.kept_names import LISTS, names


@pytest.mark.parametrize("version", [path.stem for path in sorted(LISTS.glob("*.json"))])
def test_names_of_a_version_are_kept(version):
    earlier, now = json.loads((LISTS / f"{version}.json").read_text(encoding="utf-8")), names()
    lost = [f"{place}: {name}" for place, kept in earlier.items() for name in kept if name not in now[place]]
    assert lost == []


def test_each_place_is_listed():
    found = names()
    assert "elastica_cad.make_strip" in found["Python"]
    assert "elastica_cad.optimal_rod(between)" in found["Python"]
    assert "cadquery.register" in found["CAD libraries"]
    assert {"--units", "strip --sheet"} <= found["command line"]
    assert "point mass.mass" in found["design files"]
    assert "elastica-check/1 realizable" in found["JSON"]
