"""Errors carry a record: template, typed values, places and changes; old names of options say what they are now."""

import json
import pickle
from concurrent.futures import ProcessPoolExecutor
from multiprocessing import get_context

import numpy as np
import pytest

from elastica_cad import InputError, NotConvergedError, NotRealizable, PlaneCurve, check_equilibrium
from elastica_cad.errors import (
    Angle,
    Change,
    Degrees,
    Energy,
    Force,
    Length,
    Listed,
    Mass,
    Moment,
    Point,
    Strain,
    note,
    sentences,
)
from elastica_cad.report_rows import printed_table
from elastica_cad.translations import Translated
from tests.command_line import run

WAVE = [(0, 0), (20, 50), (50, -40), (80, 55), (110, -30), (140, 0)]  # no strip takes it
FAR = InputError(
    "the ends are {distance} apart: bring them closer",
    distance=Length(1234.5),
    where={"field": "end"},
    changes=[Change("end", (90.0, 0.0))],
)


def test_a_template_is_filled_and_its_values_keep_their_types():
    assert str(FAR) == "the ends are 1234 mm apart: bring them closer"
    assert FAR.refusal.text == "the ends are {distance} apart: bring them closer"
    assert FAR.refusal.values["distance"] == 1234.5
    assert FAR.refusal.kind == "input"
    assert FAR.refusal.severity == "error"
    assert str(InputError("write {i} for the count")) == "write {i} for the count"


@pytest.mark.parametrize(
    ("value", "english", "german"),
    [
        (Force(12.345), "12.3 N", "12,3 N"),
        (Moment(0.125), "0.125 N mm", "0,125 N mm"),
        (Energy(2.5), "2.5 mJ", "2,5 mJ"),
        (Degrees(-7.25), "-7.25 degrees", "-7,25 Grad"),
        (Angle(np.pi / 6), "30 degrees", "30 Grad"),
        (Mass(999), "999 g", "999 g"),
        (Mass(1234), "1.23 kg", "1,23 kg"),
        (Strain(0.0048), "0.48 %", "0,48 %"),
    ],
)
def test_a_number_has_the_unit_of_its_kind_in_every_language(value, english, german):
    words = Translated("de")
    words.point = ","
    message = note("it is {value}", value=value)
    assert (str(message), str(value)) == (f"it is {english}", english)
    assert words.sentence(message) == f"it is {german}"
    assert json.loads(json.dumps(message.record["values"])) == {"value": pytest.approx(value.shown[0])}


def test_a_column_is_headed_and_rounded_by_the_unit_in_its_name():
    table = {
        "rise_mm": [1, 23.456],
        "strain_percent": [0.5, 1 / 3],
        "safety": [np.inf, 2],
        "state": ["a", "b"],
    }
    assert [*printed_table(table)] == [
        "rise mm  strain %  safety  state",
        "   1.00     0.500       -      a",
        "  23.46     0.333    2.00      b",
    ]


def test_a_place_is_added_once_and_leaves_the_text():
    problem = NotConvergedError("no rest shape").at(strip="A1").at(strip="A1", file="kit.toml")
    assert str(problem) == "kit.toml: A1: no rest shape"
    assert problem.refusal.text == "no rest shape"


@pytest.mark.parametrize("kind", [InputError, NotRealizable])
def test_errors_are_pickled_with_their_records(kind):
    wave = PlaneCurve.spline(WAVE, degree=4)
    problem = FAR if kind is InputError else NotRealizable(check_equilibrium(wave))
    again = pickle.loads(pickle.dumps(problem.at(strip="A1")))
    assert type(again) is kind
    assert isinstance(again, ValueError)
    assert str(again) == str(problem)
    assert again.refusal == problem.refusal
    assert again.refusal.changes


def test_an_option_is_named_that_other_commands_call_otherwise():
    text = run("strip", "a.dxf", "--name", "x", code=2).output
    assert text.endswith("--name is called --label.\n")


def test_sentences_that_are_put_together_can_be_taken_apart():
    near = note("it rests {far} away", far=Length(1.234), severity="warning")
    both = sentences([near, "", note("it is heavy")])
    assert both == "it rests 1.23 mm away; it is heavy"
    again = pickle.loads(pickle.dumps(both))
    assert again == both
    assert again.values["part0"].values["far"] == 1.234
    assert again.values["part0"].severity == "warning"
    assert sentences([near]) is near
    assert InputError(near).refusal.values == near.values


def test_a_small_length_has_three_digits_too():
    assert f"{Length(0.000123456)}" == "0.000123 mm"


def refuse(number):
    """What a worker answers, and what it raises for odd numbers."""
    if number % 2:
        raise NotRealizable(check_equilibrium(PlaneCurve.spline(WAVE, degree=4)))
    return note("at {places}, near {place}", places=Listed([Length(number), Length(7)]), place=Point((1, 2)))


def test_a_whole_number_has_no_exponent():
    assert note("{modulus:g} N/mm2, {force:.2g} N", modulus=12_000_000, force=120) == "12000000 N/mm2, 120 N"


def test_a_process_pool_returns_records_whole():
    with ProcessPoolExecutor(1, get_context("spawn")) as pool:
        even, odd = pool.submit(refuse, 2), pool.submit(refuse, 3)
        assert even.result() == refuse(2)
        assert even.result().values["places"] == (2, 7)
        with pytest.raises(NotRealizable) as raised:
            odd.result()
    again = raised.value.refusal
    with pytest.raises(NotRealizable) as here:
        refuse(3)
    assert again.record == here.value.refusal.record
    assert again.kind == "not realizable"
    assert again.changes == (Change("nearest", True),)
