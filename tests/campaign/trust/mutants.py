"""Small changes of the program that its tests should notice: seeded, one at a time, in a copy of the checkout.

python -m tests.campaign.trust.mutants --count 400 --seed 1 --minutes 120

A comparison turned, an operator swapped, a number moved, a condition negated, a constant a hundred times as large.
For each mutant the tests that run its lines are asked, the quickest first, until one fails. What no quick test
notices is asked the bank of requests (`equivalent.py`) and meets more tests: what these miss too is equivalent
where all answers stay as they were, else a survivor, a hole in the tests. A run goes on where the record of its
seed ends. With --again survived those of the record are asked anew, the tests of --tests and the long look first.
"""

import argparse
import ast
import json
import random
import shutil
import signal
import sys
import time
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest

from tests.campaign.trust.changed_copy import in_copy
from tests.campaign.trust.changed_lines import lines_of
from tests.campaign.trust.covering_tests import ROOMS, Covering, gather
from tests.campaign.trust.equivalent import Bank, asked_bank, gather_bank
from tests.campaign.trust.verdicts import summary

ROOT = Path(__file__).resolve().parents[3]
FLOORS = ("geometry", "mechanics", "form_finding", "strip", "formats", "model", "pairs", "design")
FIRST_S, LONG_S = 5.0, 24.0
"""Processor seconds of the tests of a mutant as they take without a change: a quick look, then a long one."""

NAMED_S = 120.0
"""What tests that are named may take; more of it is for loops that a change made endless."""

LIBRARIES = (
    "numpy", "scipy.integrate", "scipy.interpolate", "scipy.linalg", "scipy.optimize", "scipy.sparse.linalg",
    "scipy.spatial", "scipy.sparse", "highspy", "ezdxf", "ezdxf.path", "shapely", "tinycss2", "cssselect2", "click",
    "trimesh", "coverage", "click.testing",
)  # fmt: skip
"""What tests load before they begin, loaded once for all mutants."""

UNITS = 100
"""A constant of a module is moved by so much, as a number in wrong units is: its half again is often as good."""

SWAPS = {
    ast.Add: ast.Sub, ast.Sub: ast.Add, ast.Mult: ast.Div, ast.Div: ast.Mult, ast.Lt: ast.GtE, ast.LtE: ast.Gt,
    ast.Gt: ast.LtE, ast.GtE: ast.Lt, ast.Eq: ast.NotEq, ast.NotEq: ast.Eq, ast.And: ast.Or, ast.Or: ast.And,
}  # fmt: skip


def places(tree):
    """What may be changed, outside of annotations, texts and messages."""
    idle = set()
    for node in ast.walk(tree):
        parts = []
        if isinstance(node, ast.Raise | ast.JoinedStr | ast.Assert):
            parts = [node]
        elif isinstance(node, ast.AnnAssign):
            parts = [node.annotation]
        elif isinstance(node, ast.FunctionDef):
            parts = [
                one.annotation for one in ast.walk(node.args) if isinstance(one, ast.arg) and one.annotation
            ]
            parts += [node.returns] if node.returns else []
        idle |= {id(below) for part in parts for below in ast.walk(part)}
    for node in ast.walk(tree):
        if id(node) in idle:
            continue
        if isinstance(node, ast.BinOp | ast.BoolOp) and type(node.op) in SWAPS:
            yield node, "op"
        elif isinstance(node, ast.Compare) and type(node.ops[0]) in SWAPS:
            yield node, "ops"
        elif isinstance(node, ast.Constant) and type(node.value) in (int, float):
            yield node, "value"
        elif isinstance(node, ast.If | ast.IfExp | ast.While):
            yield node, "test"


def changed(node, field, at_top=False):
    """Change the node in place, by UNITS where it is a constant of the module, and say how."""
    before = ast.unparse(node)
    if field == "op":
        node.op = SWAPS[type(node.op)]()
    elif field == "ops":
        node.ops[0] = SWAPS[type(node.ops[0])]()
    elif field == "value" and at_top and node.value:
        node.value *= UNITS
    elif field == "value":
        node.value = node.value + 1 if isinstance(node.value, int) else node.value * 1.5 + 1e-3
    else:
        node.test = ast.UnaryOp(ast.Not(), node.test)
    return f"line {node.lineno}: {before.splitlines()[0][:80]} -> {ast.unparse(node).splitlines()[0][:80]}"


def mutants(count, seed):
    """Files with places, as many from each floor."""
    rng, found = random.Random(seed), []
    for floor in FLOORS:
        files = sorted((ROOT / "elastica_cad" / floor).rglob("*.py"))
        known = [(file, k) for file in files for k, _ in enumerate(places(ast.parse(file.read_text())))]
        found += rng.sample(known, count // len(FLOORS))
    rng.shuffle(found)
    return found


def tried(copy, file, number, known, look=FIRST_S, named=()):
    """What was changed, and the verdict: killed, too long, equivalent, or survived, and what the bank said.

    The tests of a first look of so many seconds are asked before the bank, and before them those that are named.
    """
    path, text = copy / file.relative_to(ROOT), file.read_text()
    tree = ast.parse(text)
    node, field = list(places(tree))[number]
    lines = lines_of(ROOT, file.relative_to(ROOT), tree, node)
    tests = known.covering.of(file.relative_to(ROOT), lines)
    message = changed(
        node, field, at_top=any(node in ast.walk(one) for one in tree.body if _is_constant(one))
    )
    path.write_text(ast.unparse(tree))
    try:
        first = [*named, *known.covering.within(tests, look)]
        verdict, result = _judged(copy, first, look + NAMED_S * bool(named), tests, known, lines)
    finally:
        path.write_text(text)
    place = {"file": str(file.relative_to(ROOT)), "number": number, "change": message}
    return {**place, "tests": len(tests), "verdict": verdict, **({"bank": result} if result else {})}


def _judged(copy, first, seconds, tests, known, lines):
    """The verdict, and what the bank said where it was asked."""
    if first and (verdict := asked_tests(copy, first, seconds)) != "survived":
        return verdict, ""
    equal, text = asked_bank(copy, known.bank, lines)
    more = [test for test in known.covering.within(tests, LONG_S) if test not in first]
    if more and (verdict := asked_tests(copy, more, LONG_S)) != "survived":
        return verdict, text
    return "equivalent" if equal else "survived", text


def asked_tests(copy, tests, seconds):
    """How the tests end in the changed copy."""
    words = ["-q", "-x", "-n", "0", "-p", "no:cacheprovider", "--rootdir", str(copy), *tests]
    code = in_copy(copy, lambda: int(pytest.main(words)), seconds)
    return {0: "survived", -signal.SIGKILL: "too long"}.get(code, "killed")


def _is_constant(node):
    """A number of the module that has a name of its own."""
    return isinstance(node, ast.Assign | ast.AnnAssign)


@dataclass(frozen=True)
class Known:
    """What is known of the program without a change."""

    covering: Covering
    bank: Bank


def known_of(copy, folder):
    """Gathered into the folder, or found there from an earlier run of the same program."""
    covering, bank = folder / "covering", folder / "bank"
    if not (covering / "seconds.json").exists():
        gather(copy, covering, FLOORS)
    gather_bank(copy, Bank(bank))
    return Known(Covering(covering), Bank(bank))


def asked_again(copy, found, known, named, verdicts):
    """The record with those of some verdicts tried anew, each as it is tried, beside its first verdict."""
    for place, one in enumerate(found):
        if one["verdict"] in verdicts:
            found[place] = tried(copy, ROOT / one["file"], one["number"], known, LONG_S, named)
            if found[place]["change"] != one["change"]:
                sys.exit(f"{one['file']} is no longer as it was: {one['change']}")
            found[place]["first"] = one.get("first", one["verdict"])
            yield found[place]


def asked_first(copy, found, known, count, seed):
    """The record, which grows by the mutants that it lacks, each as it is tried."""
    for file, number in mutants(count, seed)[len(found) :]:
        found.append(tried(copy, file, number, known))
        yield found[-1]


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--count", type=int, default=400)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument(
        "--minutes", type=float, default=600.0, help="for the mutants, after 40 minutes that find their tests"
    )
    parser.add_argument("--out", type=Path, default=Path("out/campaign"))
    parser.add_argument(
        "--known", type=Path, help="where what is known without a change is kept for other runs"
    )
    parser.add_argument(
        "--again", nargs="+", metavar="VERDICT", help="ask those of the record anew: survived ..."
    )
    parser.add_argument("--tests", nargs="*", default=(), help="with --again: tests that are asked first")
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)
    log = arguments.out / f"mutants-{arguments.seed}.json"
    found = json.loads(log.read_text()) if log.exists() else []
    for library in LIBRARIES:
        import_module(library)
    with TemporaryDirectory() as folder:
        copy = Path(folder, "copy")
        shutil.copytree(ROOT, copy, ignore=shutil.ignore_patterns(".git", ".venv*", "out", "__pycache__"))
        known = known_of(copy, (arguments.known or Path(folder)).resolve())
        covering = known.covering
        sound = covering.within(sorted(covering.seconds, key=covering.seconds.__getitem__), LONG_S)
        rooms = [*ROOMS, *(f"elastica_cad/{floor}" for floor in FLOORS)]
        in_copy(
            copy, lambda: int(pytest.main(["-q", "-n", "0", "--collect-only", *rooms])), 60.0, compiled=True
        )
        if asked_tests(copy, [*arguments.tests, *sound], NAMED_S) != "survived":
            sys.exit("tests fail without any change: mend them first")
        if arguments.again:
            turns = asked_again(copy, found, known, arguments.tests, arguments.again)
        else:
            turns = asked_first(copy, found, known, arguments.count, arguments.seed)
        since = time.monotonic()
        for one in turns:
            print(json.dumps(one), flush=True)
            log.write_text(json.dumps(found, indent=1) + "\n")
            if time.monotonic() - since > 60 * arguments.minutes:
                break
    print(summary(found))


if __name__ == "__main__":
    main()
