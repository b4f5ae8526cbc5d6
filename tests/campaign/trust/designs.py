"""Design files changed at random by meaning: keys that the schema knows added, numbers changed, keys taken away.

python -m tests.campaign.trust.designs --designs 2000 --seed 1 --minutes 60

`elastica model` makes each as if typed, judged as `commands` judges; drawings are judged as `written` judges.
"""

import json
import random
import shutil
import tomllib
from collections.abc import Iterator
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from tests.campaign.trust import commands, written
from tests.campaign.trust.numbered_cases import arguments, run_cases

KINDS = ("arch", "arch", "arch", "lamp", "pavilion", "revolution", "sections")
FEWER = {
    "lamp": ("revolution", "strips"), "revolution": ("revolution", "strips"), "pavilion": ("let", "strips"),
    "sections": ("strips", 0, "sections", "radial", "count"),
}  # fmt: skip
"""Where a kind of design says how many strips it has: fewer are made sooner."""

SIZES = (0, 1, 2, 3, 5, 8, 12, 20, 40, 100, 0.1, 0.3, 0.5, 1.5, -1, -5, 1e-9, 1e6)
TEXTS = ("birch-plywood-0.8", "card-200gsm", "hdf-1.5", "mdf-3", "i", "L/2", "2*3", "A{i}", "x")
FACTORS = (0.7, 0.8, 0.9, 1.1, 1.2, 1.4, 2, 0.5, 10, 0.1, 0, -1, 1000)
KEY_SHARE = 0.3
"""Of the keys of a new table, those that are given without being required."""


class Schema:
    """The schema that editors read, by which keys are drawn."""

    def __init__(self, file: Path) -> None:
        self.whole = json.loads(file.read_text(encoding="utf-8"))

    def meant(self, part: dict[str, Any]) -> dict[str, Any]:
        """A part without references."""
        while "$ref" in part or "allOf" in part:
            known = self.whole["definitions"]
            part = part["allOf"][0] if "allOf" in part else known[part["$ref"].rpartition("/")[2]]
        return part

    def drawn(self, rng: random.Random, part: dict[str, Any]) -> Any:
        """A value that a key may have, most of them of the right kind."""
        part = self.meant(part)
        if "anyOf" in part:
            return self.drawn(rng, rng.choice(part["anyOf"]))
        if "enum" in part or "const" in part:
            return rng.choice(part.get("enum", [part.get("const")]))
        kind = part.get("type", "number")
        if isinstance(kind, list):
            kind = kind[0] if rng.random() < 0.8 else rng.choice(kind)
        if kind == "object":
            request = part.get("required", ())
            return {
                key: self.drawn(rng, value)
                for key, value in part.get("properties", {}).items()
                if key in request or rng.random() < KEY_SHARE
            }
        if kind == "array":
            items, least = part.get("items", {}), part.get("minItems", 1)
            return [self.drawn(rng, items) for _ in range(rng.randint(least, max(least, 3)))]
        if kind == "boolean":
            return rng.random() < 0.7
        if kind == "string":
            return rng.choice(TEXTS)
        number = rng.choice(SIZES) if rng.random() < 0.25 else round(rng.uniform(0.2, 30), 2)
        return int(number) if kind == "integer" else number

    def tables(self, value: Any, part: dict[str, Any]) -> Iterator[tuple[dict[str, Any], dict[str, Any]]]:
        """All tables of a design with their part of the schema."""
        part = self.meant(part)
        kind = "array" if isinstance(value, list) else "object"
        fits = [one for one in map(self.meant, part.get("anyOf", [part])) if one.get("type") == kind]
        if not fits:
            return
        if isinstance(value, dict) and value and "properties" in fits[0]:
            yield value, fits[0]
        inner = value.items() if isinstance(value, dict) else enumerate(value)
        for key, one in inner:
            below = fits[0].get("items") if kind == "array" else fits[0].get("properties", {}).get(key)
            if isinstance(one, dict | list) and below:
                yield from self.tables(one, below)


def numbers(value: Any) -> Iterator[tuple[Any, Any]]:
    """Where in a design there are numbers: what holds them, and the key or place."""
    for key, one in value.items() if isinstance(value, dict) else enumerate(value):
        if isinstance(one, int | float) and not isinstance(one, bool):
            yield value, key
        elif isinstance(one, dict | list):
            yield from numbers(one)


def change(rng: random.Random, design: dict[str, Any], schema: Schema) -> str:
    """One change of a design, in words."""
    tables = list(schema.tables(design, schema.whole))
    table, part = rng.choice(tables)
    what = rng.random()
    if what < 0.65:
        key = rng.choice(sorted(part["properties"]))
        table[key] = schema.drawn(rng, part["properties"][key])
        return f"{key} = {table[key]!r}"
    if what < 0.9:
        holder, place = rng.choice(list(numbers(design)))
        before = holder[place]
        holder[place] = type(before)(rng.choice(FACTORS) * before)
        return f"{place}: {before} to {holder[place]}"
    key = rng.choice(list(table))
    del table[key]
    return f"without {key}"


def toml(value: Any) -> str:
    """A value as TOML has it."""
    if isinstance(value, dict):
        return "{" + ", ".join(f"{json.dumps(key)} = {toml(one)}" for key, one in value.items()) + "}"
    if isinstance(value, list):
        return "[" + ", ".join(map(toml, value)) + "]"
    return json.dumps(value, ensure_ascii=False)


def made(seed: int, number: int, folder: Path) -> tuple[str, list[str]]:
    """How one design ended, and what is wrong with that."""
    rng = random.Random(f"{seed} {number}")
    kind = rng.choice(KINDS)
    shutil.rmtree(folder / "out", ignore_errors=True)
    commands.begin(folder, kind)
    design = tomllib.loads((folder / f"{kind}.toml").read_text(encoding="utf-8"))
    if kind in FEWER:
        *way, last = FEWER[kind]
        table = design
        for key in way:
            table = table[key]
        table[last] = rng.randint(2, 8)
    schema = Schema(folder / "elastica.schema.json")
    changes = [change(rng, design, schema) for _ in range(rng.choice((1, 1, 2, 2, 3, 4)))]
    lines = [f"{json.dumps(key)} = {toml(value)}\n" for key, value in design.items()]
    (folder / "design.toml").write_text("".join(lines), encoding="utf-8")
    text = ["model", "design.toml", "-o", "out", "--no-pictures"]
    text += ["--no-step"] if rng.random() < 0.75 else []
    text += ["--no-effects"] if rng.random() < 0.3 else []
    ended = commands.run(text, folder, typed=False)
    wrong = commands.judged(text, folder, ended)
    # without a margin pieces lie edge to edge, as it was asked
    close = any(table.get("margin") == 0 for table, _ in schema.tables(design, schema.whole))
    for file in sorted((folder / "out").rglob("*.dxf")) if ended[0] == 0 else ():
        found = written.faults(file)
        wrong += [f"{file.name}: {fault}" for fault in found if not (close and fault == written.TOUCHING)]
    return f"code {ended[0]}", [f"{kind}: {'; '.join(changes)}", *wrong] if wrong else []


def main() -> None:
    request = arguments(__doc__ or "", "designs", 2000, minutes=60.0)
    with TemporaryDirectory() as folder:
        run_cases(request, "designs", "designs", lambda seed, number: made(seed, number, Path(folder)))


if __name__ == "__main__":
    main()
