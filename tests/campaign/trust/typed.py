"""Mutated drawings, tables, designs, reports and meshes through the commands that a person types.

python -m tests.campaign.trust.typed --files 2000 --seed 1 --minutes 60

Judged as `commands` judges; a run that prints nothing for 10 s, or takes more than 1.5 GB, is a fault, too.
"""

import random
import re
import shutil
from functools import cache
from pathlib import Path
from tempfile import TemporaryDirectory

from tests.campaign.trust import commands
from tests.campaign.trust.corpus import SHARES, originals
from tests.campaign.trust.mutations import mutated
from tests.campaign.trust.numbered_cases import arguments, run_cases

BOW = b"2 4\n0 0\n40 60\n90 60\n130 0\n"
STRIP = "strip {} --sheet birch-plywood-0.8 --max-width 20 -o out --no-pictures --no-step"
SECTIONS = "sections {} --unit mm --radial 4 --sheet card-200gsm -o out"
MODEL = "model {} -o out --no-pictures --no-step"
CURVES = ("check {}", "check {} --json", STRIP, STRIP + " --all", "reshape {} --top-right 120 80 -o out")
TYPED = {
    "toml": (MODEL, MODEL + " --no-effects", MODEL + " --json"),
    "report": ("compare {}", "compare {} measured.toml", "check {}", "bend {} --to 70 0 -o out"),
    "measured": ("compare report.json {}",),
    "sheets": ("sheets {}", STRIP.format("bow.txt").replace("birch-plywood-0.8", "{}")),
    "path": ("sections bowl.obj --unit mm --along {} --count 4 -o out",),
    "obj": (SECTIONS,), "stl": (SECTIONS,), "ply": (SECTIONS,),
}  # fmt: skip
SHARE = SHARES | {
    "toml": 14,
    "report": 14,
    "measured": 4,
    "sheets": 4,
    "path": 3,
    "obj": 4,
    "stl": 3,
    "ply": 3,
}
SUFFIX = {"report": "json", "measured": "toml", "sheets": "toml", "path": "csv"}


@cache
def written() -> dict[str, tuple[bytes, ...]]:
    """What the commands write that they also read, and a path through a mesh."""
    coupon = "coupon --sheet card-200gsm --measured 160 74 --measured 160 71 -o out"
    with TemporaryDirectory() as base:
        folder = Path(base)
        commands.begin(folder, "sections", "arch")
        (folder / "bow.txt").write_bytes(BOW)
        for words in (STRIP.format("bow.txt"), "compare out/bow.json", coupon):
            ended = commands.run(words.split(), folder, typed=False)
            assert ended[0] == 0, ended
        files = {
            path.name: path.read_bytes()
            for path in (*folder.iterdir(), *(folder / "out").iterdir())
            if path.is_file()
        }
    return {
        "report": (files["bow.json"],),
        "measured": (re.sub(rb"(?m)^# (?=\w+ = )", b"", files["bow-measured.toml"]),),
        "sheets": (files["my-card-200gsm.toml"],),
        "path": (b"0,0,-30\n5,3,-10\n0,9,10\n3,2,30\n",),
        "bowl": (files["bowl.obj"],),
        "arch": (files["arch.dxf"],),
    }


def made(seed: int, number: int, folder: Path) -> tuple[str, list[str]]:
    """How the command on one file ended, and what is wrong with that."""
    rng = random.Random(f"{seed} {number}")
    kind = rng.choices(list(SHARE), list(SHARE.values()))[0]
    sound = written().get(kind) or originals(kind)
    for path in folder.iterdir():
        shutil.rmtree(path) if path.is_dir() else path.unlink()
    (folder / "bow.txt").write_bytes(BOW)
    for name, of in (
        ("report.json", "report"),
        ("measured.toml", "measured"),
        ("bowl.obj", "bowl"),
        ("arch.dxf", "arch"),
    ):
        (folder / name).write_bytes(written()[of][0])
    file = f"case.{SUFFIX.get(kind, kind)}"
    (folder / file).write_bytes(mutated(rng, kind, rng.choice(sound), rng.choice(sound)))
    words = rng.choice(TYPED.get(kind, CURVES)).format(file).split()
    ended = commands.run(words, folder, typed=number % 33 == 0)
    wrong = commands.judged(words, folder, ended)
    return f"code {ended[0]}", [f"{kind}: {' '.join(words)}", *wrong] if wrong else []


def main() -> None:
    request = arguments(__doc__ or "", "files", 2000, minutes=60.0)
    written()
    with TemporaryDirectory() as folder:
        run_cases(request, "typed", "files", lambda seed, number: made(seed, number, Path(folder)))


if __name__ == "__main__":
    main()
