"""Keys by their path: lengths with a unit in `--set`, and the explanation of every key by `elastica help`."""

import pytest

from elastica_cad import InputError
from elastica_cad.cli.help_command import _explanation
from elastica_cad.cli.pair_command import PairKeys
from elastica_cad.cli.settings import BentKeys, CommandKeys, parsed_settings
from elastica_cad.cli.strip_options import typed_name
from elastica_cad.design.model_tables import DesignKeys
from elastica_cad.design.records import paths_of
from tests.command_line import run


@pytest.mark.parametrize(
    ("typed", "table"),
    [
        ("cut.kerf=0.006in", {"cut": {"kerf": 0.1524}}),
        ("cut.kerf=sheet", {"cut": {"kerf": "sheet"}}),
        ("max_width=4cm", {"max_width": 40}),
        ("max_width=1 1/2 in", {"max_width": 38.1}),
        ("smooth=0.001ft", {"smooth": 0.3048}),
        ('ends={length="5/16in", width=9}', {"ends": {"length": 7.9375, "width": 9}}),
        ('slots=[{at="4cm", width="1mm"}]', {"slots": [{"at": 40, "width": 1}]}),
        ("label=5mm", {"label": "5mm"}),
        ("max_width=2 * 10", {"max_width": "2 * 10"}),
        ('law.limits=["2mm", 5]', {"section": {"limits": [2, 5]}}),
    ],
)
def test_a_length_may_have_a_unit(typed, table):
    def rounded(value):
        if isinstance(value, dict):
            return {key: rounded(item) for key, item in value.items()}
        return [rounded(item) for item in value] if isinstance(value, list) else (
            value if isinstance(value, str) else pytest.approx(value)
        )  # fmt: skip

    assert parsed_settings([typed], CommandKeys) == rounded(table)


@pytest.mark.parametrize(
    ("typed", "record"),
    [
        ("limits.ratio=3mm", CommandKeys),
        ("natural_curvature=1in", BentKeys),
        ("rings.holes.screws=3cm", DesignKeys),
    ],
)
def test_a_unit_of_another_number_is_refused(typed, record):
    with pytest.raises(InputError, match="is not a length"):
        parsed_settings([typed], record)


def test_sizes_of_sheets_may_have_units():
    (size,) = parsed_settings(['nest.sheet_size=["2ft", 300]'], DesignKeys).values()
    assert size == {"sheet_size": [pytest.approx(609.6), 300]}


@pytest.mark.parametrize("key", ["law", "section"])
def test_a_key_is_explained_by_its_former_name_too(key):
    assert run("help", f"{key}.kind").stdout.startswith("section.kind\n")


@pytest.mark.parametrize("record", [CommandKeys, DesignKeys, BentKeys, PairKeys])
def test_every_key_is_explained(record):
    for path, field in paths_of(record).items():
        assert _explanation(path, typed_name(path)).startswith(f"{path}\n"), field
