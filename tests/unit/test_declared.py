"""What is declared once arrives wherever it is read: in design files, options, forms, types and pages."""

import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Annotated, Literal

import pytest

from elastica_cad import InputError, StripSpec
from elastica_cad.declared import Option, declared, kind_of
from elastica_cad.design.records import Reader, described, parsed_line
from elastica_cad.design.strip_table import StripKeys
from elastica_cad.design.tables import Table

ROOT = Path(__file__).resolve().parents[2]


@dataclass(frozen=True)
class Ring:
    radius: Annotated[float, Option("Radius of the ring.", "mm", least=0)]
    side: Annotated[Literal["upper", "lower"], Option("Where it opens.")] = "upper"
    places: Annotated[tuple[tuple[float, float], ...], Option("Points on it.", "mm")] = ()
    inner: "Annotated[Ring | None, Option('A ring within.')]" = None


def ring_of(line):
    return Reader().record(Ring, Table(parsed_line(line, "ring"), "ring", {}))


def test_a_record_is_read_from_a_table_of_its_declared_fields():
    made = ring_of("radius = '2 * 5', places = [[0, 1], [2, 3]], inner = { radius = 1 }")
    assert made == Ring(10.0, places=((0, 1), (2, 3)), inner=Ring(1.0))


@pytest.mark.parametrize(
    ("line", "sentence"),
    [
        ("", "radius is missing. Add this key: radius of the ring"),
        ("radius = true", "radius is True. Write a number or a formula"),
        ("radius = 1, sied = 'upper'", "unknown key 'sied'; did you mean side"),
        ("radius = 1, side = 'left'", "side is 'left'. Use one of upper, lower"),
        ("radius = 1, places = [[1]]", r"places\[1\] is \[1\]. Write 2 numbers"),
        ("radius = 1, inner = { radius = 'a' }", "inner: radius: unknown name 'a'"),
    ],
)
def test_what_a_table_lacks_or_has_too_much_is_reported_at_its_place(line, sentence):
    with pytest.raises(InputError, match=f"ring: {sentence}"):
        ring_of(line)


def test_forms_know_all_fields_of_a_strip():
    fields = {one["name"]: one for one in described(StripKeys)}
    assert {one.name for one in declared(StripSpec)} <= set(fields)
    ratio = next(one for one in fields["limits"]["fields"] if one["name"] == "ratio")
    assert (ratio["kind"], ratio["least"], ratio["common"]) == ("number", 1, True)
    words = [one["word"] for one in fields["style"]["of"]]
    assert words == ["plain", "perforated", "laminated"]


def test_what_no_file_can_hold_is_declared_by_what_is_written():
    assert kind_of(float | None).name == "number"
    with pytest.raises(TypeError, match="set the type in files"):
        kind_of(3)


def test_typed_options_are_those_of_the_declarations(monkeypatch):
    monkeypatch.syspath_prepend(str(ROOT / "docs"))
    import generated_options

    assert generated_options.FILE.read_text(encoding="utf-8") == generated_options.text(), (
        "run: make generate"
    )
    assert sys.modules.pop("generated_options")


@pytest.mark.parametrize(
    ("line", "sentence"),
    [
        ("length = 1e6", "length is 1000000.0: give a number from 0 up to 10000, in mm"),
        ("name = '" + "A" * 101 + "'", "name is 'A.*': give a text of at most 100 characters"),
        ("places = [" + "1, " * 51 + "]", "places is .*: give a list of at most 50 elements"),
    ],
)
def test_a_table_refuses_what_is_larger_than_declared(line, sentence):
    @dataclass(frozen=True)
    class Part:
        length: Annotated[float, Option("Length.", "mm", least=0, most=10_000)] = 0.0
        name: Annotated[str, Option("Name.", most=100)] = ""
        places: Annotated[tuple[float, ...], Option("Places.", "mm", many=50)] = ()

    with pytest.raises(InputError, match=f"part: {sentence}"):
        Reader().record(Part, Table(parsed_line(line, "part"), "part", {}))


def test_keys_of_very_many_parts_are_refused_before_they_are_parsed():
    with pytest.raises(InputError, match="cannot be read"):
        parsed_line(".".join("a" * 100_000) + " = 1", "line")
