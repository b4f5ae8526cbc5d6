"""Names of earlier versions that users type or store are still there."""

import pytest

from tests.house.kept_names import LISTS, names
from tests.house.name_lists import lost_names


@pytest.mark.parametrize("path", sorted(LISTS.glob("*.json")), ids=lambda path: path.stem)
def test_names_of_a_version_are_kept(path):
    assert lost_names(path, names()) == []


def test_each_place_is_listed():
    found = names()
    assert "elastica_cad.make_strip" in found["Python"]
    assert "elastica_cad.optimal_rod(between)" in found["Python"]
    assert "cadquery.register" in found["CAD libraries"]
    assert {"--units", "strip --sheet"} <= found["command line"]
    assert "point mass.mass" in found["design files"]
    assert "elastica-check/1 realizable" in found["JSON"]
