"""Small changes of the program that its tests should notice: seeded, one at a time, in a copy of the checkout.

python -m tests.campaign.trust.mutants --count 400 --seed 1 --minutes 120

A comparison turned, an operator swapped, a number moved, a condition negated. For each mutant the module's own
examples run, then tests that import it, those beside it and of its floor, until one fails; survivors are listed.
"""

import argparse
import ast
import json
import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path
from tempfile import TemporaryDirectory

ROOT = Path(__file__).resolve().parents[3]
FLOORS = ("geometry", "mechanics", "forming", "fabrication", "formats")
PATIENCE_S = 300
"""Processor seconds of one mutant's tests: a loop that a change made endless ends there."""

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


def changed(node, field):
    """Change the node in place and say how."""
    before = ast.unparse(node)
    if field == "op":
        node.op = SWAPS[type(node.op)]()
    elif field == "ops":
        node.ops[0] = SWAPS[type(node.ops[0])]()
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


def asked_tests(file):
    """The module itself (its examples), then tests of its floor that name it, then those of other floors."""
    module = ".".join(file.relative_to(ROOT).with_suffix("").parts)
    near = [module, module.rpartition(".")[0]]
    floor = file.relative_to(ROOT / "elastica_cad").parts[0]
    tests = sorted((ROOT / "tests").rglob("test_*.py"), key=lambda path: path.stat().st_size)
    tests = [
        path for path in tests if path.parts[len(ROOT.parts) + 1] in ("unit", "properties", "validation")
    ]
    direct = [path for path in tests if f"{near[0]} import" in path.read_text()]
    beside = [path for path in tests if f"{near[1]}." in path.read_text() and path not in direct]
    rest = [path for path in tests if path.parent.name == floor and path not in (*direct, *beside)]
    return [str(path.relative_to(ROOT)) for path in (file, *direct, *beside, *rest)]


def tried(copy, file, number):
    """What was changed, and the verdict: killed, survived or too long."""
    path, text = copy / file.relative_to(ROOT), file.read_text()
    tree = ast.parse(text)
    node, field = list(places(tree))[number]
    told = changed(node, field)
    path.write_text(ast.unparse(tree))
    words = [
        sys.executable,
        "-m",
        "pytest",
        "-q",
        "-x",
        "-n",
        "0",
        "-p",
        "no:cacheprovider",
        *asked_tests(file),
    ]
    try:
        done = subprocess.run(
            words, cwd=copy, capture_output=True, check=False, timeout=10 * PATIENCE_S,
            env={**os.environ, "PYTHONPATH": str(copy), "PYTHONDONTWRITEBYTECODE": "1"},
            preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (PATIENCE_S, PATIENCE_S)),
        )  # fmt: skip
        verdict = {0: "survived", -signal.SIGKILL: "too long"}.get(done.returncode, "killed")
    except subprocess.TimeoutExpired:
        verdict = "too long"
    finally:
        path.write_text(text)
    return {"file": str(file.relative_to(ROOT)), "change": told, "verdict": verdict}


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--count", type=int, default=400)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--minutes", type=float, default=600.0)
    parser.add_argument("--out", type=Path, default=Path("out/campaign"))
    asked = parser.parse_args()
    found, since = [], time.monotonic()
    asked.out.mkdir(parents=True, exist_ok=True)
    with TemporaryDirectory() as folder:
        copy = Path(folder, "copy")
        shutil.copytree(ROOT, copy, ignore=shutil.ignore_patterns(".git", ".venv*", "out", "__pycache__"))
        for file, number in mutants(asked.count, asked.seed):
            found.append(tried(copy, file, number))
            print(json.dumps(found[-1]), flush=True)
            (asked.out / f"mutants-{asked.seed}.json").write_text(json.dumps(found, indent=1) + "\n")
            if time.monotonic() - since > 60 * asked.minutes:
                break
    killed = sum(one["verdict"] != "survived" for one in found)
    print(f"{killed} of {len(found)} mutants are noticed")


if __name__ == "__main__":
    main()
