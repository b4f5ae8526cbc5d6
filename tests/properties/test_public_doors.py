"""Every public function is given things of another kind in place of each argument: it answers in one sentence.

The examples in the docstrings are the sound calls that this begins with.
"""

import contextlib
import doctest
import importlib
import inspect
import io
import pkgutil
import sys
import warnings

import pytest

import elastica_cad
from elastica_cad import ElasticaError

pytestmark = pytest.mark.core

FLOORS = ("geometry", "mechanics", "form_finding", "strip", "model", "pairs")
ODD = (None, "x", object(), 10**400, (1, 2, 3))
INNER = {
    "Box.clearance", "CollinearInflections.equations",
    "DiscreteRod.moment_imbalance", "EndPositions.equations", "EndTangents.equations", "FixedLength.equations",
    "HalfPlane.clearance", "InflectionsOnLine.equations", "LaidLeaves.strains",
    "Laminated.bounded", "PerforatedSection.strains",
    "PlainSection.strains", "PlaneCurve.basis", "PlaneCurve.derivatives",
    "SmoothJoints.equations",
    "Strip.breadth", "TSlot.side", "Tab.depth_at", "TabSeat.bends", "TabSeat.gaps", "TabSeat.moved",
    "TabSeat.slopes", "Travel.words",
}  # fmt: skip
"""What the house calls in its loops with what it has checked."""


def public_names(floor):
    """Public functions and methods of public records, by their code; answers are made by nobody else."""
    found = {}
    package = importlib.import_module(f"elastica_cad.{floor}")
    for name in package.__all__:
        value = getattr(package, name)
        if inspect.isfunction(value):
            found[inspect.unwrap(value).__code__] = name, lambda _own, value=value: value
        elif inspect.isclass(value):
            for method, raw in vars(value).items():
                function = getattr(raw, "__func__", raw)
                if method.startswith("_") or not inspect.isfunction(function):
                    continue
                code = inspect.unwrap(function).__code__
                found[code] = f"{name}.{method}", lambda own, method=method: getattr(own, method)
    return {code: known for code, known in found.items() if known[0] not in INNER}


def example_calls(floor, wanted, most=1):
    """The arguments of the first calls of each that the examples make, by code."""
    calls = {}

    def watch(frame, event, _argument):
        if event == "call" and frame.f_code in wanted:
            code = frame.f_code
            kept = calls.setdefault(code, [])
            if len(kept) < most:
                names = code.co_varnames[: code.co_argcount + code.co_kwonlyargcount]
                kept.append({name: frame.f_locals[name] for name in names if name in frame.f_locals})
                if code.co_flags & inspect.CO_VARKEYWORDS:
                    more = code.co_varnames[len(names) + bool(code.co_flags & inspect.CO_VARARGS)]
                    kept[-1] |= frame.f_locals[more]

    package = importlib.import_module(f"elastica_cad.{floor}")
    modules = (one.name for one in pkgutil.walk_packages(package.__path__, f"{package.__name__}."))
    for tests in (package, *map(importlib.import_module, modules)):
        sys.setprofile(watch)
        try:
            with contextlib.redirect_stdout(io.StringIO()):
                doctest.testmod(tests)
        finally:
            sys.setprofile(None)
    return calls


def calls_with(function, arguments, name, odd):
    """The call with one argument replaced."""
    given = {**arguments, name: odd}
    positional, keywords = [], {}
    for key, one in inspect.signature(function).parameters.items():
        if one.kind in (one.VAR_POSITIONAL, one.VAR_KEYWORD) or key not in given:
            continue
        if one.kind is one.KEYWORD_ONLY:
            keywords[key] = given[key]
        else:
            positional.append(given[key])
    others = given.keys() - inspect.signature(function).parameters.keys() - {"self", "cls"}
    function(*positional, **keywords, **{key: given[key] for key in others})


@pytest.mark.campaign
@pytest.mark.parametrize("floor", FLOORS)
def test_one_sentence_whatever_is_given(floor, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    wanted = public_names(floor)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        calls = example_calls(floor, wanted)
    assert len(calls) > 6
    wrong = []
    for code, (arguments,) in calls.items():
        name, bound = wanted[code]
        own = arguments.get("self", arguments.get("cls"))
        function = bound(own)
        for argument in set(arguments) - {"self", "cls"}:
            for odd in ODD:
                try:
                    calls_with(function, arguments, argument, odd)
                except ElasticaError:
                    continue
                except Exception as error:
                    wrong.append((name, argument, odd if odd != 10**400 else "10**400", type(error).__name__))
    assert not wrong, "\n".join(map(str, sorted(map(str, wrong))))


def test_the_front_door_has_them_all():
    assert set(FLOORS) < set(elastica_cad.__all__)
