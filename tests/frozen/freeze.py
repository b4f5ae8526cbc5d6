"""Answers of every front end to chosen requests, kept while the package is rearranged.

`python tests/frozen/freeze.py write` stores them in tests/frozen/answers.json, `compare` lists every difference.
Requests: rows of the contract table (which the other front ends answer alike, tests/contract), drawings, commands,
calls in Python, solids of both CAD libraries, refusals; drawn by seed where there are more than ten.
"""

import json
import random
import re
import sys
import tempfile
from contextlib import chdir
from pathlib import Path
from typing import Any

import numpy as np
from click.testing import CliRunner

import elastica_cad as ec
from elastica_cad.cli.commands import elastica

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT))
STORED = Path(__file__).with_name("answers.json")
CLOSE = 1e-4  # mm, and of any number its share
DRAWINGS = ("examples", "tests/data/public", "tests/data/damaged")
REFUSED = """
strip examples/arch/arch.dxf --sheet nothing
strip examples/arch/arch.dxf --sheet birch-plywood-0.8 --max-width 0
strip examples/arch/arch.dxf --sheet birch-plywood-0.8 --max-width 40 --set limits.ratio=0.5
strip examples/arch/arch.dxf --sheet pom-3 --max-width 40
check nothing.dxf
check pyproject.toml
model examples/arch/arch.dxf
bend examples/arch/arch.dxf --steps 0
sections examples/arch/arch.dxf --radial 16
coupon --sheet steel
"""
COMMANDS = """
sheets --json
bend examples/arch/arch.dxf --sheet birch-plywood-0.8 --max-width 40 --to 360 0 --steps 4 --json
coupon --sheet birch-plywood-0.8 --json
batten --length 2400 --camber 10 --at 40 --sheet pom-1 --stock 25 8 --json
check examples/arch/arch.dxf
help limits.ratio
model examples/pavilion/pavilion.toml --no-step --no-pictures --json
pair examples/two_states/clip.svg --sheet pom-3 --json
"""


def plain(value: Any) -> Any:
    """Numbers, texts, lists and tables only."""
    if isinstance(value, dict):
        return {str(key): plain(entry) for key, entry in value.items()}
    if isinstance(value, (list, tuple)):
        return [plain(entry) for entry in value]
    if isinstance(value, np.ndarray):
        return plain(value.tolist())
    if isinstance(value, (bool, str)) or value is None:
        return value
    return float(f"{float(value):.9g}")


def run(words: list[str], folder: Path) -> Any:
    """What a command prints and which cutting files it makes, names of the folder taken out."""
    with chdir(folder):
        done = CliRunner().invoke(elastica, words)
    out = done.stdout.replace(str(folder), "OUT").replace(str(ROOT), "ROOT")
    try:
        printed = json.loads(out)
    except ValueError:
        printed = re.sub(r"\d+\.\d{4,}", lambda match: f"{float(match.group()):.4g}", out).splitlines()
    made = {}
    for file in sorted(folder.rglob("*.dxf")):
        made[str(file.relative_to(folder))] = entities(file)
    errors = done.stderr.replace(str(folder), "OUT").replace(str(ROOT), "ROOT").splitlines()
    return plain({"exit": done.exit_code, "printed": printed, "errors": errors, "files": made})


def entities(file: Path) -> list[Any]:
    from tests.contract.answers import entities as numbers

    return [
        [kind, len(values), float(np.abs(values).sum()), float(values @ np.cos(np.arange(len(values))))]
        for kind, values in numbers(file)
        if "TEXT" not in kind
    ]


def contract() -> dict[str, Any]:
    from tests.contract.answers import in_python, strokes
    from tests.contract.table import REFUSED as REFUSED_ROWS
    from tests.contract.table import REQUESTS

    found: dict[str, Any] = {}
    for name, row in (REQUESTS | REFUSED_ROWS).items():
        made = in_python(row)
        if isinstance(made, ec.ElasticaError):
            found[name] = {"kind": getattr(made.refusal, "kind", ""), "message": str(made)}
        else:
            found[name] = {
                "ratio": made.rod.ratio,
                "mass": made.mass,
                "strain": made.max_strain,
                "length": made.rod.length,
                "strokes": [[kind, len(v), float(np.abs(v).sum())] for kind, v in strokes(made)],
            }
    return found


def drawings() -> dict[str, Any]:
    files = sorted(
        path
        for folder in DRAWINGS
        for path in (ROOT / folder).rglob("*")
        if path.suffix.lower() in {".dxf", ".svg", ".csv", ".json", ".txt"} and path.stat().st_size < 200_000
    )
    chosen = random.Random(67).sample(files, min(40, len(files)))
    with tempfile.TemporaryDirectory() as folder:
        return {
            str(path.relative_to(ROOT)): run(["check", str(path), "--json"], Path(folder)) for path in chosen
        }


def commands() -> dict[str, Any]:
    found = {}
    for line in COMMANDS.strip().splitlines():
        with tempfile.TemporaryDirectory() as folder:
            words = [str(ROOT / word) if word.startswith("examples/") else word for word in line.split()]
            if words[0] in {"coupon", "batten", "model", "pair"}:
                words += ["-o", f"{folder}/out"]
            found[line] = run(words, Path(folder))
    return found


def refusals() -> dict[str, Any]:
    found = {}
    for line in REFUSED.strip().splitlines():
        with tempfile.TemporaryDirectory() as folder:
            words = [
                str(ROOT / word) if word.startswith(("examples/", "py")) else word for word in line.split()
            ]
            found[line] = run([*words, "--json"], Path(folder))
    return found


def python() -> dict[str, Any]:
    from elastica_cad import forming, mechanics

    arch = ec.PlaneCurve.spline([(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)])
    wave = ec.PlaneCurve.spline([(0, 0), (20, 90), (60, -60), (90, 95), (120, -20), (150, 0)])
    sheet = ec.Sheet.named("birch-plywood-0.8")
    rod = ec.optimal_rod(arch)
    heavy = ec.optimal_rod(arch, gravity=ec.Sheet.named("card-200gsm").gravity())
    near = ec.nearest_rod(wave, limits=ec.Limits(ratio=3.5))
    firm = ec.nearest_rod(wave, limits=ec.Limits(ratio=3.5, margin=5.0))
    bent = ec.bend(rod, end=(130.0, 5.0))
    strip = ec.make_strip(arch, sheet, max_width=30.0)
    samples = np.linspace(0.0, 1.0, 9)
    return {
        "curve": [arch.length, arch.inflections, wave.inflections],
        "check": [str(ec.check_equilibrium(arch)), str(ec.check_equilibrium(wave))],
        "rod": [rod.ratio, rod.force, np.quantile(rod.stiffness, samples), rod.length],
        "heavy": [heavy.ratio, heavy.force],
        "nearest": [near.rod.ratio, near.deviation, str(near.status)],
        "firm": [firm.rod.ratio, firm.deviation, ec.stability(firm.rod).margin],
        "bent": [bent.position[len(bent.position) // 2], bent.force],
        "stability": [ec.stability(rod).margin, ec.stability(rod).stable],
        "strip": [strip.max_strain, strip.mass, strip.width.extremes, str(strip)],
        "split": str(ec.split(wave)),
        "public": [mechanics.elastica_between.__name__, forming.mesh_sections.__name__],
    }


def solids() -> dict[str, Any]:
    import build123d as bd
    import cadquery as cq

    from elastica_cad import build123d, cadquery
    from tests.contract.table import REQUESTS
    from tests.contract.test_front_ends import drawn_fields, edge, frame

    found = {}
    for name in random.Random(67).sample(sorted(REQUESTS), 10):
        row = REQUESTS[name]
        for kind in ("FlatStrip", "BentStrip"):
            made = getattr(build123d, kind)(edge(row), row.material, plane=frame(row), **drawn_fields(row))
            box = made.bounding_box()
            found[f"{name}: build123d {kind}"] = [
                made.volume,
                made.area,
                [*box.min],
                [*box.max],
                len(made.faces()),
            ]
        drawn = cq.Edge(edge(row).wrapped)
        made = cadquery.flat_strip(drawn, row.material, plane=frame(row), **drawn_fields(row))
        found[f"{name}: cadquery"] = [made.Volume(), made.Area(), len(made.Faces()), bool(bd)]
    return found


def different(path: str, old: Any, new: Any) -> list[str]:
    """Every place where two answers differ."""
    if isinstance(old, dict) and isinstance(new, dict):
        return [
            line
            for key in sorted({*old, *new})
            for line in different(f"{path} / {key}", old.get(key), new.get(key))
        ]
    if isinstance(old, list) and isinstance(new, list) and len(old) == len(new):
        return [
            line
            for i, (a, b) in enumerate(zip(old, new, strict=True))
            for line in different(f"{path}[{i}]", a, b)
        ]
    if isinstance(old, float) and isinstance(new, float):
        return [] if abs(old - new) <= CLOSE * max(1.0, abs(old)) else [f"{path}: {old} -> {new}"]
    return [] if old == new else [f"{path}: {old!r} -> {new!r}"[:400]]


def main(mode: str) -> int:
    answers = {
        part.__name__: plain(part()) for part in (contract, drawings, commands, refusals, python, solids)
    }
    if mode == "write":
        STORED.write_text(json.dumps(answers, indent=0, ensure_ascii=False, sort_keys=True), encoding="utf-8")
        return 0
    lines = different("", json.loads(STORED.read_text(encoding="utf-8")), json.loads(json.dumps(answers)))
    print(*lines[:80], f"{len(lines)} differences", sep="\n")
    return bool(lines)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
