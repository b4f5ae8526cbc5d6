"""Formulae: arithmetic and nothing else."""

import math

import numpy as np
import pytest

from elastica_cad import InputError
from elastica_cad.design.tables import CONSTANTS, FUNCTIONS, Formula

pytestmark = pytest.mark.core


@pytest.mark.parametrize(
    ("text", "value"),
    [
        ("1 + 2 * 3", 7.0),
        ("-2 ** 2", -4.0),
        ("(1 - x) / 4 % 2", -0.25 % 2),
        ("60 * degrees", np.pi / 3),
        ("atan2(x, 1) + hypot(3, 4)", np.arctan2(2, 1) + 5),
        ("where(x < 3, x ** 0.5, 1 / 0)", 2**0.5),
        ("min(x, 1) + max(x, 1) + floor(2.7) + sign(-3)", 4.0),
        ("where(x >= 2, 1, 0)", 1.0),
    ],
)
def test_arithmetic(text, value):
    assert Formula(text)(x=2.0) == pytest.approx(value, rel=1e-15)


def test_arrays_are_computed_element_by_element():
    t = np.linspace(0, 6, 50)
    spiral = Formula("t * where(t < 3, cos(t), sin(t)) + a")
    assert np.array_equal(spiral({"a": 1.0}, t=t), t * np.where(t < 3, np.cos(t), np.sin(t)) + 1.0)
    assert spiral.names == {"t", "a"}


@pytest.mark.parametrize("nested", ["where(1 < {}, 2, 0)", "where({} > 1, 2, 0)", "abs({} + 0)"])
def test_thirty_levels_are_not_too_deep(nested):
    """Two nodes a level, on either side of a comparison: sixty are taken."""
    text = "x"
    for _ in range(29):
        text = nested.replace("{}", text)
    assert Formula(text)(x=2.0) == 2.0


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("__import__('os').system('true')", "character 1: only numbers, names"),
        ("__import__('os')", "unknown function '__import__' at character 1"),
        ("eval(x)", "unknown function 'eval' at character 1"),
        ("2 * sinn(x)", "unknown function 'sinn' at character 5 of '2 \\* sinn\\(x\\)'; did you mean sin"),
        ("2 * radius", "unknown name 'radius' at character 5"),
        ("x.real", "character 1: only numbers"),
        ("[x][0]", "only numbers"),
        ("x if x else 1", "only numbers"),
        ("lambda: x", "only numbers"),
        ("'a' * 3", "'a' is not a number"),
        ("True", "True is not a number"),
        ("1j", "is not a number"),
        ("x ^ 2", r"write \*\* for powers"),
        ("x // 2", "this operator is not known"),
        ("sin", "sin is a function; write its arguments"),
        ("sin(1, 2)", "sin takes 1 argument"),
        ("where(x, 1)", "where takes 3 arguments"),
        ("sin(x=1)", "only numbers"),
        ("sin(*x)", "character 5: only numbers"),
        ("1 < x < 3", "only numbers"),
        ("x and 1", "only numbers"),
        ("(y := 1)", "only numbers"),
        ("1 +", "cannot be read at"),
        ("", "cannot be read at"),
        ("x; x", "cannot be read at character 2"),
        ("1 / 0", "is not finite"),
        ("sqrt(-x)", "is not finite"),
        ("9 ** 9 ** 9 ** 9", "is not finite"),
        ("9" * 400, r"limit of 1e\+300"),
        ("-" * 500 + "1", "nested too deeply"),
        ("1+" * 150 + "1", "nested too deeply"),
        ("2*(" * 70 + "x" + ")" * 70, "nested too deeply"),
        ("abs(" * 70 + "x" + ")" * 70, "nested too deeply"),
        ("where(1 < " * 70 + "x" + ", x, x)" * 70, "nested too deeply"),
        ("(" * 500 + "1", "cannot be read at"),
        ("1 + " * 1000 + "1", "4001 characters is too long"),
        ("\x00", "cannot be read as a formula"),
        ("1 + \x00", "cannot be read as a formula"),
        ("1 + \ud800", "cannot be read as a formula"),
        ("degrees" * 250, "unknown name 'degrees"),
        ("'" + "degrees" * 250 + "'", "is not a number"),
        ("1 / " + "0" * 1500, "is not finite"),
    ],
)
def test_whatever_is_no_arithmetic_is_refused(text, message):
    with pytest.raises(InputError, match=message) as caught:
        Formula(text, "design.toml: strips[3]: x")(x=2.0)
    assert str(caught.value).startswith("design.toml: strips[3]: x")
    assert "\n" not in str(caught.value)
    assert len(str(caught.value)) < 600


def test_names_of_functions_and_constants_do_not_clash():
    assert not set(CONSTANTS) & set(FUNCTIONS)
    for name, (function, count) in FUNCTIONS.items():
        arguments = ", ".join(["0.5"] * count)
        assert Formula(f"{name}({arguments})")() == pytest.approx(float(function(*[0.5] * count)))


def test_functions_take_as_many_arguments_as_those_of_python():
    """A wrong number of arguments is refused before anything is computed."""
    alike = {name: getattr(math, name) for name in FUNCTIONS if hasattr(math, name)} | {"abs": abs}
    assert len(alike) > 10
    for name, function in alike.items():
        counts = {"atan2": 2, "hypot": 2}
        count = counts.get(name, 1)
        assert Formula(f"{name}({', '.join(['0.5'] * count)})")() == pytest.approx(function(*[0.5] * count))
        with pytest.raises(InputError, match=f"{name} takes {count} argument"):
            Formula(f"{name}({', '.join(['0.5'] * (count + 1))})")
