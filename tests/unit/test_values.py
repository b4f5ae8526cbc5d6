"""The checks that public callables share, on what a fuzz of nonsense had found them to answer otherwise."""

import dataclasses

import numpy as np
import pytest

import elastica_cad as ec
from elastica_cad._values import alike, is_number, is_one_of, is_series, require_flag, several
from elastica_cad.geometry import Line
from elastica_cad.mechanics import InflectionLine, PlainSection, elastica_between
from elastica_cad.model import LeafStack, base_plate, interlock
from elastica_cad.strip import PrismSolid, TabSeat

TWO, NONE, ONE, TABLE = np.ones(2), np.zeros(0), np.array(1.0), np.ones((2, 2, 2))
SHEET = ec.Sheet.named("card-200gsm")
CURVE = ec.PlaneCurve.arc((0, 0), 60, 0.3, 3.1)
ROD = ec.Rod.straight(100.0, samples=51)

CALLS = {
    "truth of an array": lambda: ec.Path.polyline([(0, 0), (1, 0)], closed=TWO),
    "truth of none": lambda: ec.Keep(symmetry=NONE),
    "side of a curve": lambda: CURVE.curvature_at(0.5, left=TWO),
    "iteration": lambda: ec.Keep(ends=ONE),
    "regions": lambda: ec.Limits(keep_out=ONE),
    "slot along": lambda: ec.Slot.along(0, TABLE, side="upper"),
    "slot side": lambda: ec.Slot(10, 1, side=TWO),
    "grain": lambda: ec.Sheet("x", 1, 3000, 600, 0.01, grain=TWO),
    "ragged stations": lambda: dataclasses.replace(ROD, s=[[1, 2], [3]]),
    "no strip": lambda: LeafStack(None),
    "prisms": lambda: PrismSolid(NONE),
    "seat": lambda: TabSeat(True, True, 1.0),
    "fit": lambda: interlock([], fit=TWO),
    "shape of a plate": lambda: base_plate([], SHEET, shape=TWO),
    "laid out": lambda: ec.Plain().laid_out(None, SHEET, max_width=10),
    "width laid out": lambda: ec.Plain().laid_out(ROD, SHEET, max_width="x"),
    "velocity": lambda: Line((0, 0), (1, 0)).velocity_at([[1, 2], [3]]),
    "points": lambda: InflectionLine((0, 0), (1, 0)).distance((1, 2, 3)),
    "shapes": lambda: PlainSection(SHEET, 0, 40).bent([1, 2, 3], [1, 2]),
    "side of a rod": lambda: ec.bend(ROD, side=TWO),
    "angles": lambda: elastica_between((0, 0), (90, 0), 100.0, angles=ONE),
    "overflow": lambda: elastica_between((0, 0), (90, 0), 1e300),
}


@pytest.mark.parametrize("call", CALLS.values(), ids=CALLS)
def test_nonsense_is_refused_in_a_sentence(call):
    with pytest.raises(ec.InputError):
        call()


def test_a_curvature_beyond_all_is_nowhere():
    assert CURVE.curvature_equals(1e99) == ()


def test_what_is_what():
    assert [is_number(value) for value in (1e100, 1e101, 10**400, np.inf, True)] == [True, *4 * [False]]
    assert [is_series(value) for value in ("ab", ONE, TWO, (), 3)] == [False, False, True, True, False]
    assert is_one_of(1, (1, -1))
    assert not is_one_of(TWO, (1, -1))
    assert require_flag(np.True_, "x") is True
    assert several("x", ONE, np.ndarray, "array") == (ONE,)
    with pytest.raises(ec.InputError, match="do not match"):
        alike(a=[1, 2, 3], b=[1, 2])
