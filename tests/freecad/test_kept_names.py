"""Properties and commands of earlier versions are still there, with their types."""

import pytest

from tests.freecad.kept_names import LISTS, names
from tests.house.name_lists import lost_names


@pytest.mark.parametrize("path", sorted(LISTS.glob("*.json")), ids=lambda path: path.stem)
def test_names_of_a_version_are_kept(path):
    assert lost_names(path, names()) == []


def test_each_place_is_listed():
    listed = names()
    assert "StripFeature.MaxWidth (App::PropertyLength)" in listed["properties"]
    assert "Elastica_Strip" in listed["commands"]
