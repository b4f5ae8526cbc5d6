"""Every public callable is given nonsense: it answers, or refuses in one sentence of ours.

python -m tests.campaign.trust.nonsense --calls 20000 --seed 251125

Sound calls are those of the examples in docstrings; one argument or several are replaced. What has no example gets
nothing but nonsense. A seed and a number name a call: --only 4711 makes it again, with its traceback.
"""

import argparse
import contextlib
import importlib
import inspect
import io
import os
import random
import re
import resource
import signal
import sys
import tempfile
import traceback
import warnings
from collections import Counter
from enum import Enum

import numpy as np

from elastica_cad import ElasticaError
from tests.properties.test_public_doors import INNER, example_calls

FLOORS = (
    "geometry",
    "mechanics",
    "form_finding",
    "strip",
    "formats",
    "model",
    "pairs",
    "design",
    "plot",
    "paper",
)
FRONT_ENDS = ("build123d", "cadquery")
OF_BUILD123D = ("rotation", "align", "mode")  # passed on as they are, so it refuses them in its own words
LONGEST_S, MOST_MIB = 10, 1536
NONSENSE = (
    None, True, "", "x", b"x", -1, 0, 10**400, -1e-300, 1e300, float("nan"), float("inf"), 1j, object(), object,
    (), [], {}, (1, 2, 3), [None], ["a", "b"], [[1, 2], [3]], {"a": 1}, {1, 2}, range(3), slice(2),
    np.zeros(0), np.zeros((0, 2)), np.zeros((2, 2, 2)), np.ones(3), np.full((4, 2), np.nan), np.array(["a"]),
    np.array(1.0), np.array([None]), np.arange(6).reshape(3, 2), "birch-plywood-0.8", "nowhere.dxf", ElasticaError,
)  # fmt: skip


def public():
    """Public functions, classes and methods of public classes, by name: (callable, code, whether it has a self)."""
    found = {}
    for package in ("elastica_cad", *(f"elastica_cad.{one}" for one in FLOORS + FRONT_ENDS)):
        module = importlib.import_module(package)
        for name in module.__all__:
            value = getattr(module, name)
            if inspect.isfunction(value):
                found[f"{package}.{name}"] = value
            elif inspect.isclass(value) and not (
                issubclass(value, BaseException | Enum)
                or inspect.isabstract(value)
                or getattr(value, "_is_protocol", False)
            ):
                ours = "elastica_cad" in getattr(codes_of(value), "co_filename", "")
                if ours or hasattr(value, "__dataclass_fields__"):
                    found[f"{package}.{name}"] = value  # shapes of a CAD library are made by that
                for method, raw in vars(value).items():
                    if not method.startswith("_") and inspect.isfunction(getattr(raw, "__func__", raw)):
                        found[f"{package}.{name}.{method}"] = getattr(value, method)
    found = {
        name: value for name, value in found.items() if not name.endswith(tuple(f".{one}" for one in INNER))
    }
    by_place = {}  # what stands at the top and on its floor is asked once
    for name, value in found.items():
        by_place.setdefault(
            getattr(value, "__qualname__", name) + getattr(value, "__module__", ""), (name, value)
        )
    return dict(by_place.values())


def codes_of(value):
    """The code that runs when it is called."""
    inner = vars(value).get("__init__") if inspect.isclass(value) else value
    inner = inspect.unwrap(getattr(inner, "__func__", inner)) if inner is not None else None
    return getattr(inner, "__code__", None)


def arguments_of(value):
    """The names of its arguments."""
    try:
        return list(inspect.signature(value).parameters)
    except (TypeError, ValueError):
        return []


def sound_calls(wanted):
    """The arguments of the first three calls of each that the examples make, by code."""
    calls = {}
    for floor in FLOORS + FRONT_ENDS:
        for code, made in example_calls(floor, wanted, most=3).items():
            calls[code] = [*calls.get(code, ()), *made][:3]
    return calls


def nonsense_call(value, sound, dice):
    """The callable with arguments of which some are nonsense, and those by name."""
    try:
        parameters = inspect.signature(value).parameters.values()
    except (TypeError, ValueError):
        parameters = ()
    named = [one for one in parameters if one.kind not in (one.VAR_POSITIONAL, one.VAR_KEYWORD)]
    given = dict(dice.choice(sound)) if sound else {}
    if inspect.isclass(value) or isinstance(getattr(value, "__self__", None), type):
        given.pop("self", None), given.pop("cls", None)
    known = [one.name for one in named if one.name in given and one.name != "self"]
    free = [one.name for one in named if one.name not in ("self", *OF_BUILD123D)]
    odd = {
        name: dice.choice(NONSENSE)
        for name in dice.sample(free, min(len(free), dice.choice((1, 1, 1, 2, 3))))
    }
    if not known:
        odd |= {
            one.name: dice.choice(NONSENSE)
            for one in named
            if one.default is one.empty and one.name not in given
        }
    given |= odd
    positional, keywords = [], {}
    for one in named:
        if one.name in given:
            if one.kind is one.KEYWORD_ONLY or len(positional) < named.index(one):
                keywords[one.name] = given[one.name]
            else:
                positional.append(given[one.name])
    return (lambda: value(*positional, **keywords)), odd


class TooLongError(BaseException):
    """Raised by the alarm."""


def answer_to(call):
    """ "" where the call answers or is refused in a sentence of ours; else what it ends in."""

    def ring(*_):
        raise TooLongError

    signal.signal(signal.SIGALRM, ring)
    signal.alarm(LONGEST_S)
    try:
        with contextlib.redirect_stdout(io.StringIO()), warnings.catch_warnings():
            warnings.simplefilter("ignore")
            call()
    except ElasticaError as error:
        return "" if str(error).strip() else "an empty sentence"
    except TypeError as error:  # Python's own words about arguments are clear
        return "" if "argument" in str(error) and "()" in str(error) else message_of(error)
    except ValueError as error:  # and those about build123d's enumerations
        return "" if re.search(r" is not a valid [A-Z]\w*$", str(error)) else message_of(error)
    except TooLongError as error:
        return message_of(error)
    except Exception as error:
        return message_of(error)
    finally:
        signal.alarm(0)
    return ""


def message_of(error):
    place = traceback.extract_tb(error.__traceback__)[-1]
    ours = [one for one in traceback.extract_tb(error.__traceback__) if "elastica_cad" in one.filename]
    at = ours[-1] if ours else place
    return f"{type(error).__name__}: {str(error)[:80]!r} at {os.path.basename(at.filename)}:{at.lineno}"


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--calls", type=int, default=20000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--only", type=int)
    parser.add_argument("--match", default="")
    arguments = parser.parse_args()
    sys.modules.setdefault("__main__", sys.modules[__name__])
    os.chdir(tempfile.mkdtemp())
    callables = {name: one for name, one in public().items() if arguments.match in name}
    sound = sound_calls({codes_of(one) for one in callables.values()} - {None})
    # a method needs something sound that it is a method of
    names = sorted(
        n for n, one in callables.items() if codes_of(one) in sound or "self" not in arguments_of(one)
    )
    print(
        f"{len(names)} public callables, {sum(codes_of(callables[n]) in sound for n in names)} with a sound call"
    )
    wrong, first = Counter(), {}
    for number in range(arguments.calls) if arguments.only is None else [arguments.only]:
        dice = random.Random(f"{arguments.seed} {number}")
        name = names[number % len(names)]
        call, odd = nonsense_call(callables[name], sound.get(codes_of(callables[name]), ()), dice)
        if arguments.only is not None:
            print(name, odd)
            call()
            return
        if ended := answer_to(call):
            key = f"{name}: {ended.split(' at ')[-1] if ' at ' in ended else ended}"
            wrong[key] += 1
            first.setdefault(key, f"#{number} {str({k: repr(v)[:40] for k, v in odd.items()})[:150]} {ended}")
    most = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024
    for key, count in sorted(wrong.items()):
        print(f"{count:5} {key} {first[key]}")
    print(f"{arguments.calls} calls; {sum(wrong.values())} wrong; {most:.0f} MiB of memory")
    sys.exit(bool(wrong) or most > MOST_MIB)


if __name__ == "__main__":
    main()
