"""Properties and commands of earlier versions are still there, with their types."""

import json

import pytest

from tests.freecad.kept_names import LISTS, names


@pytest.mark.parametrize("version", [path.stem for path in sorted(LISTS.glob("*.json"))])
def test_names_of_a_version_are_kept(version):
    earlier, now = json.loads((LISTS / f"{version}.json").read_text(encoding="utf-8")), names()
    lost = [
        f"{place}: {name}" for place, listed in earlier.items() for name in listed if name not in now[place]
    ]
    assert lost == []


def test_each_place_is_listed():
    listed = names()
    assert "StripFeature.MaxWidth (App::PropertyLength)" in listed["properties"]
    assert "Elastica_Strip" in listed["commands"]
