"""A bank of requests as users make them, and their answers as plain data: sentences, numbers, files.

The pages of the manual typed, the examples built, strips and nearest rods drawn at random, files of every format,
sound and broken. `equivalent.py` asks the bank with and without a change of the program.
"""

import hashlib
import io
import os
import random
import re
import runpy
import shlex
import warnings
from collections.abc import Callable, Iterator
from contextlib import redirect_stderr, redirect_stdout
from dataclasses import fields, is_dataclass
from enum import Enum
from pathlib import Path

import numpy as np

from tests.campaign.trust.command_lines import DRAWN, LINES
from tests.unit.design.test_design_schema import DESIGNS

ROOT = Path(__file__).resolve().parents[3]
PAGES = ("how_to", "tutorials", "explanation")
EXAMPLES = (
    "vase", "lantern", "shell", "revolution", "carpet", "projective", "spiral", "lamp", "facade", "robustness",
    "s_curve", "flower_pot", "horse",
)  # fmt: skip
RODS, STRIPS, FILES = 40, 60, 12
LOOKED_AT = 20  # curves of one file
WHOLE = 0.1  # share of the strips that are written as a whole kit
TEXTS = (".txt", ".csv", ".svg", ".dxf", ".json", ".toml", ".html", ".md", ".obj", ".step")
PICTURES = (".png", ".pdf")

PLAIN = ("--no-step", "--no-pictures")
"""Bodies and pictures of whole models take longest, and those of single strips show the same."""

Request = Callable[[Path], object]


def bank() -> dict[str, Request]:
    """All requests by name; each is asked in an empty folder."""
    pages = {
        f"page {page.stem}": lambda folder, page=page: typed_page(page)
        for room in PAGES
        for page in sorted((ROOT / "docs" / room).glob("*.md"))
    }
    templates = {
        f"design {kind}": lambda folder, kind=kind: [
            typed(["new", kind, "-q"]), typed(["model", f"{kind}.toml", "-o", "out", *PLAIN])
        ]
        for kind in ("arch", "lamp", "revolution", "sections")
    }  # fmt: skip
    lines = {f"command {n}": lambda folder, line=line: typed_line(line) for n, line in enumerate(LINES)}
    keyed = {f"keys {n}": lambda folder, n=n: keyed_design(n) for n in range(len(DESIGNS))}
    built = {f"example {name}": lambda folder, name=name: example(name) for name in EXAMPLES}
    rods = {f"rod {n}": lambda folder, n=n: rod(random.Random(f"bank {n}")) for n in range(RODS)}
    strips = {f"strip {n}": lambda folder, n=n: strip(random.Random(f"bank {n}")) for n in range(STRIPS)}
    return {**pages, **templates, **lines, **keyed, **built, **rods, **strips, **files()}


def files() -> dict[str, Request]:
    """Every sound file of every format, and some broken ones."""
    from tests.campaign.trust.corpus import SHARES

    return {
        f"file {kind} {n}": lambda folder, kind=kind, n=n: file(kind, n)
        for kind in SHARES
        for n in range(FILES)
    }


def answer(request: Request, folder: Path) -> object:
    """What a request gives, as plain data: its own answer, or how it was refused, and the files that it left."""
    os.chdir(folder)
    with warnings.catch_warnings(record=True) as warned:
        warnings.simplefilter("always")
        try:
            given = plain(request(folder))
        except Exception as problem:
            given = f"{type(problem).__name__}: {problem}"
    files = [path for path in sorted(folder.rglob("*")) if path.is_file() and path.suffix not in PICTURES]
    left = {str(path.relative_to(folder)): content(path) for path in files}
    result = [str(one.message) for one in warned]
    return {"given": given, "warned": result, "files": left}


def content(path: Path) -> str:
    """A text as it is, other files by their sum."""
    data = path.read_bytes()
    return data.decode(errors="replace") if path.suffix in TEXTS else hashlib.sha256(data).hexdigest()


def plain(value: object) -> object:
    """Numbers, texts, lists and tables of them; of a record its public fields that are data."""
    if value is None or isinstance(value, bool | int | float | str):
        return value
    if isinstance(value, np.generic | np.ndarray):
        return value.tolist()
    if isinstance(value, Enum):
        return value.name
    if isinstance(value, dict):
        return {str(key): plain(one) for key, one in value.items()}
    if isinstance(value, list | tuple):
        return [plain(one) for one in value]
    if is_dataclass(value) and not isinstance(value, type):
        names = (one.name for one in fields(value) if not one.name.startswith("_") and one.repr)
        return {name: plain(getattr(value, name)) for name in names}
    return type(value).__name__


def typed(words: list[str]) -> object:
    """A command of `elastica`, in this process: exit code and what it printed."""
    from elastica_cad.cli.commands import elastica

    out, err, code = io.StringIO(), io.StringIO(), 0
    with redirect_stdout(out), redirect_stderr(err):
        try:
            elastica.main(args=words, prog_name="elastica")
        except SystemExit as ended:
            code = ended.code
    return [code, out.getvalue(), err.getvalue()]


def typed_line(line: str) -> object:
    """A command where the drawings are that it names."""
    for name in (name for name in DRAWN if name in line):
        Path(name).write_text(DRAWN[name])
    return typed(shlex.split(line))


def keyed_design(number: int) -> object:
    """A design of those that together use every key."""
    from elastica_cad import PlaneCurve, write_curves
    from tests.campaign.trust.corpus import originals

    write_curves([PlaneCurve.arc((0, 0), 50, 0.2, 2.0)], "one.json")
    Path("two.svg").write_text(DRAWN["corners.svg"])
    Path("dome.obj").write_bytes(originals("obj")[0])
    Path("more.toml").write_text(DRAWN["felt.toml"])
    Path("design.toml").write_text(DESIGNS[number])
    return typed(["model", "design.toml", "-o", "out", *PLAIN])


def typed_page(page: Path) -> object:
    """A page of the manual as its reader types it: its files saved, its `elastica` commands, its Python."""
    from tests.manual.run_page import blocks

    result, names = [], {"__name__": "manual"}
    for block in blocks(page.read_text(encoding="utf-8")):
        if block.file:
            Path(block.file).write_text(block.body, encoding="utf-8")
        elif block.kind == "sh":
            result += [typed(words) for words in commands(block.body)]
        elif block.kind == "python":
            result.append(run_block(block.body, names))
    return result


def commands(body: str) -> Iterator[list[str]]:
    """The `elastica` commands of a block, without pictures and bodies."""
    for line in body.replace("\\\n", " ").splitlines():
        words = shlex.split(re.split(r"\s(?:[0-9]?>|\|)", line)[0])
        if words[:1] == ["elastica"]:
            more = PLAIN if words[1] == "model" else ()
            yield [*words[1:], *(one for one in more if one not in words)]


def run_block(body: str, names: dict[str, object]) -> str:
    """What a block of Python prints, or how it ends."""
    stream = io.StringIO()
    with redirect_stdout(stream):
        try:
            exec(compile(body, "page", "exec"), names)
        except Exception as problem:
            print(f"{type(problem).__name__}: {problem}")
    return stream.getvalue()


def example(name: str) -> object:
    """An example as its script builds it: every part drawn, and its strips in numbers."""
    import elastica_cad as ec

    made = runpy.run_path(str(ROOT / "examples" / name / f"{name}.py"))["build"]()
    parts = list(made.values()) if isinstance(made, dict) else made
    models = parts if isinstance(parts, list | tuple) else [parts]
    result: list[object] = []
    for number, model in enumerate(models):
        if not isinstance(model, ec.Model):
            result.append(plain(model))
            continue
        for part, placed in enumerate(model.parts):
            for layer, drawing in enumerate(placed.strip.drawings()):
                ec.save(drawing, f"{number}-{part}-{layer}.dxf")
            result.append(strip_numbers(placed.strip))
    return result


def rod_numbers(rod) -> object:
    """A rod at its nodes."""
    names = ("s", "position", "angle", "curvature", "stiffness", "force")
    return {name: plain(getattr(rod, name)) for name in names}


def strip_numbers(strip) -> object:
    """What a strip says of itself."""
    return {"rod": rod_numbers(strip.rod), "warnings": plain(strip.warnings), "text": str(strip)}


def rod(rng: random.Random) -> object:
    """A nearest rod as somebody might ask for it, with what it advises and whether it stays."""
    import elastica_cad as ec
    from tests.campaign.trust.met_checks import request

    points, limits, keep, weight, measure = request(rng)
    gravity = None if weight is None else ec.Gravity(weight, (0, -1))
    curve = ec.PlaneCurve.spline(points, degree=3)
    near = ec.nearest_rod(curve, ec.Limits(**limits), ec.Keep(**keep), gravity, measure=measure)
    result = [near.status, near.deviation, near.mean_deviation, str(near), [str(one) for one in near.binding]]
    result += [str(ec.check_equilibrium(curve))]
    if near.found is not None:
        result += [rod_numbers(near.rod), str(ec.stability(near.rod))]
    return result


def strip(rng: random.Random) -> object:
    """A strip of any style, its drawings in lines and arcs, and its sheets."""
    import elastica_cad as ec
    from elastica_cad.model import nest_pieces
    from elastica_cad.strip.pieces import strip_pieces
    from tests.campaign.trust.written import STOCK_MM, strip_of

    made = strip_of(rng)
    for number, drawing in enumerate(made.drawings()):
        for curves, kerf, kind in (("spline", 0.0, "dxf"), ("arc", 0.15, "dxf"), ("spline", 0.3, "svg")):
            ec.save(drawing, f"{number}-{curves}-{kerf}.{kind}", kerf=kerf, curves=curves)
    model = ec.Model([ec.Placed(made)])
    for number, sheet in enumerate(nest_pieces(strip_pieces(model.parts), sheet_size=STOCK_MM)):
        ec.save(sheet, f"nest-{number}.dxf")
    if rng.random() < WHOLE:
        ec.save_model(model, "kit", step=False, pictures=False, ignore_limits=True)
    return strip_numbers(made)


def file(kind: str, number: int) -> object:
    """A sound file, or a broken one, as its reader gives it."""
    import elastica_cad as ec
    from elastica_cad.design import read_design
    from elastica_cad.files import read_drawing, read_surface
    from tests.campaign.trust.corpus import originals
    from tests.campaign.trust.mutations import mutated

    sound, rng = originals(kind), random.Random(f"bank {number}")
    data = mutated(rng, kind, rng.choice(sound), rng.choice(sound))
    if number < min(len(sound), FILES // 2):
        data = sound[number]
    path = Path(f"one.{kind}")
    path.write_bytes(data)
    if kind == "toml":
        model = read_design(path, ec.read_curves, read_surface).model()
        return [strip_numbers(one.strip) for one in model.parts]
    if kind in ("obj", "stl", "ply"):
        return plain(read_surface(path, unit="mm"))
    drawn = read_drawing(path)
    result: list[object] = [drawn.skipped]
    for one in drawn.curves[:LOOKED_AT]:
        result.append([one.number, one.name, one.layer, one.problem])
        if not one.problem:
            result.append([plain(one.curve.sample(50).position), str(ec.check_equilibrium(one.curve))])
    for suffix in ("svg", "dxf", "json"):
        ec.write_curves([one.curve for one in drawn.curves if not one.problem], f"again.{suffix}")
    return result
