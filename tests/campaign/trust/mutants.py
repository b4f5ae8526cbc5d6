"""Small changes of the program that its tests should notice: seeded, one at a time, in a copy of the checkout.

python -m tests.campaign.trust.mutants --count 400 --seed 1 --minutes 120

A comparison turned, an operator swapped, a number moved, a condition negated, a constant a hundred times as large.
For each mutant the tests that run its lines are asked, the quickest first, until one fails; survivors are listed.
A run goes on where the record of its seed ends.
"""

import argparse
import ast
import json
import os
import random
import resource
import shutil
import signal
import sys
import time
from importlib import import_module
from pathlib import Path
from tempfile import TemporaryDirectory

import pytest

from tests.campaign.trust.covering_tests import Covering, gather

ROOT = Path(__file__).resolve().parents[3]
FLOORS = ("geometry", "mechanics", "forming", "fabrication", "formats")
FIRST_S, LONG_S = 6.0, 60.0
"""Processor seconds of the tests of a mutant as they take without a change: a quick look, then a long one."""

PATIENCE_S = 200
"""Processor seconds at which a loop that a change made endless ends."""

LIBRARIES = (
    "numpy", "scipy.integrate", "scipy.interpolate", "scipy.linalg", "scipy.optimize", "scipy.sparse.linalg",
    "scipy.spatial", "highspy", "ezdxf", "shapely", "svgelements", "click",
)  # fmt: skip
"""What tests load before they begin, loaded once for all mutants."""

FAILED = 99
"""Exit code of a process that ended otherwise than by pytest's own."""

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


def tried(copy, file, number, covering):
    """What was changed, and the verdict: killed, survived, too long, or run by no test."""
    path, text = copy / file.relative_to(ROOT), file.read_text()
    tree = ast.parse(text)
    node, field = list(places(tree))[number]
    last = node.end_lineno if field != "test" else node.test.end_lineno
    tests = covering.of(file.relative_to(ROOT), node.lineno, last)
    told = changed(node, field, at_top=any(node in ast.walk(one) for one in tree.body if _is_constant(one)))
    verdict = "survived"
    path.write_text(ast.unparse(tree))
    for seconds in (FIRST_S, LONG_S) if tests else ():
        verdict = asked_tests(copy, covering.within(tests, seconds))
        if verdict != "survived":
            break
    path.write_text(text)
    return {"file": str(file.relative_to(ROOT)), "change": told, "tests": len(tests), "verdict": verdict}


def asked_tests(copy, tests):
    """How the tests end in the changed copy, in a process that has the libraries loaded but nothing of ours."""
    child = os.fork()
    if not child:
        code = FAILED
        try:
            code = _run(copy, tests)
        finally:
            os._exit(code)
    end = time.monotonic() + 10 * PATIENCE_S
    while not (done := os.waitpid(child, os.WNOHANG))[0]:
        if time.monotonic() > end:
            os.kill(child, signal.SIGKILL)
            done = os.waitpid(child, 0)
            break
        time.sleep(0.02)
    code = os.waitstatus_to_exitcode(done[1])
    return {0: "survived", -signal.SIGKILL: "too long"}.get(code, "killed")


def _run(copy, tests):
    """The code with which pytest ends the tests, in this process."""
    resource.setrlimit(resource.RLIMIT_CPU, (PATIENCE_S, PATIENCE_S))
    os.chdir(copy)
    os.environ["PYTHONPATH"] = sys.path[0] = str(copy)
    for name in [name for name in sys.modules if name.partition(".")[0] in ("tests", "elastica_cad")]:
        del sys.modules[name]
    sys.dont_write_bytecode = True
    nowhere = os.open(os.devnull, os.O_RDWR)
    for stream in (0, 1, 2):
        os.dup2(nowhere, stream)
    words = ["-q", "-x", "-n", "0", "-p", "no:cacheprovider", "--rootdir", str(copy), *tests]
    return int(pytest.main(words))


def _is_constant(node):
    """A number of the module that has a name of its own."""
    return isinstance(node, ast.Assign | ast.AnnAssign)


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--count", type=int, default=400)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--minutes", type=float, default=600.0)
    parser.add_argument("--out", type=Path, default=Path("out/campaign"))
    parser.add_argument("--covering", type=Path, help="what an earlier run found out about tests and lines")
    asked = parser.parse_args()
    asked.out.mkdir(parents=True, exist_ok=True)
    log, since = asked.out / f"mutants-{asked.seed}.json", time.monotonic()
    found = json.loads(log.read_text()) if log.exists() else []
    for library in LIBRARIES:
        import_module(library)
    with TemporaryDirectory() as folder:
        copy = Path(folder, "copy")
        shutil.copytree(ROOT, copy, ignore=shutil.ignore_patterns(".git", ".venv*", "out", "__pycache__"))
        if asked.covering is None:
            asked.covering = Path(folder, "covering")
            gather(copy, asked.covering, FLOORS)
        covering = Covering(asked.covering)
        sound = covering.within(sorted(covering.seconds, key=covering.seconds.__getitem__), LONG_S)
        if asked_tests(copy, sound) != "survived":
            sys.exit("tests fail without any change: mend them first")
        for file, number in mutants(asked.count, asked.seed)[len(found) :]:
            found.append(tried(copy, file, number, covering))
            print(json.dumps(found[-1]), flush=True)
            log.write_text(json.dumps(found, indent=1) + "\n")
            if time.monotonic() - since > 60 * asked.minutes:
                break
    killed = sum(one["verdict"] != "survived" for one in found)
    print(f"{killed} of {len(found)} mutants are noticed")


if __name__ == "__main__":
    main()
