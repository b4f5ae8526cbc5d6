"""What kernels did to the bodies of the bank, kept in a file beside this one, and told as docs/kernels.md."""

import json
import re
from collections import Counter
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import Any

__all__ = ["KEPT", "PAGE", "keep", "kept", "written"]

KEPT = Path(__file__).with_name("solids.json")
PAGE = Path(__file__).resolve().parents[2] / "docs" / "kernels.md"
STYLES = ("plain", "held", "slotted", "perforated", "laminated")
CURVES = 30  # of the bank

MEANT = {
    "volume": "volume, as the CAD program shows it",
    "fillet": "fillet 0.2 mm, long edges, bent",
    "chamfer": "chamfer 0.2 mm, long edges, bent",
    "fillet flat": "fillet 0.2 mm, all round, flat",
    "chamfer flat": "chamfer 0.2 mm, all round, flat",
    "offset": "outline offset by 0.1 mm",
    "inset": "outline offset by -0.1 mm",
    "shell": "shell of 0.15 mm, bent",
    "shell flat": "shell of 0.15 mm, flat",
    "boolean": "boolean: a box cut out, bent",
    "mirror": "mirror, bent",
    "split": "split by a plane, bent",
    "mesh": "mesh by gmsh, worst quality (SICN) at least 0.3 of 1, bent",
    "STEP": "STEP written and read again, bent",
    "BOP": "the check that precedes boolean operations, bent",
}
"""What each operation of `operations.py` does, in the order of the tables."""

HEAD = """# Bodies in three CAD programs

If you go on with the body of a strip in CAD, which operations work? The tables count how often an operation of
build123d, CadQuery or FreeCAD succeeds on such bodies. All three programs use the CAD kernel OpenCASCADE, in
different versions. The strips have thirty curves, each in five styles. "29/30" means that the operation succeeded
on 29 of 30 bodies. If the second number is smaller than 30, the other bodies have not been tried yet. The
resulting body must be valid, and its volume must be right where the volume is known. An operation that takes more
than 10 s of processor time (shells 20 s, meshes and checks 60 s) counts as failed. *Bent* and *flat* mean the body
of the bent strip and of the flat part. `make campaign-solids` writes this page.

An operation that fails is repeated on simpler bodies. They have the same faces, but their long sides are drawn
anew, as splines through 9, 17, 25, 40 and 90 points. If the operation also fails on a simpler body, the cause is
OpenCASCADE, not this program. These failures are in the column *simpler body fails too*. All other failures are
in the column *ours only*, and are listed at the end.

The styles are: plain; held (wide tabs with holes); slotted (two slots); perforated (8 diamond holes); laminated
(the backing, which is the glued layer). For CadQuery, meshes, STEP files and checks are not repeated, because its
bodies are those of build123d 0.12 in the same version of OpenCASCADE.
"""


def kept() -> list[dict[str, Any]]:
    """One record a body: program, style, curve, day, what succeeded, and of what failed both answers."""
    return json.loads(KEPT.read_text()) if KEPT.exists() else []


def keep(rows: Iterable[dict[str, Any]]) -> None:
    """Put answers of `solids.py` in the file, in place of older ones to the same question; write the page anew."""
    bodies = {_key(body): body for body in kept()}
    for row in rows:
        blank = {name: row[name] for name in ("program", "style", "curve")} | {"ok": [], "failed": {}}
        body = bodies.setdefault(_key(row), blank)
        operation = row["operation"]
        body["day"] = max(row["day"], body.get("day", ""))
        body["ok"] = [name for name in body["ok"] if name != operation]
        body["failed"].pop(operation, None)
        if row["answer"] == "ok":
            body["ok"].append(operation)
        else:
            body["failed"][operation] = [_short(row["answer"]), _short(row["plain"])]
    result = sorted(bodies.values(), key=_key)
    KEPT.write_text("[\n" + ",\n".join(map(json.dumps, result)) + "\n]\n")
    PAGE.write_text(written(result))


def _key(row: dict[str, Any]) -> tuple[str, str, str]:
    return row["program"], row["style"], row["curve"]


def _short(answer: str) -> str:
    """An answer without the advice that kernels add, and without what breaks a table."""
    return re.split(r"[,\n|]", answer)[0].strip()


def written(bodies: Sequence[dict[str, Any]]) -> str:
    """The page."""
    lines = [HEAD]
    for program in dict.fromkeys(body["program"] for body in bodies):
        mine = [body for body in bodies if body["program"] == program]
        days = sorted({body["day"] for body in mine})
        request = sum(len(body["ok"]) + len(body["failed"]) for body in mine)
        when = days[0] if len(days) == 1 else f"{days[0]} to {days[-1]}"
        lines += [
            f"## {program}",
            "",
            f"{request} operations on {len(mine)} of {CURVES * len(STYLES)} bodies, {when}.",
        ]
        lines += ["", *_counted(mine), ""]
    ours = [
        (MEANT[operation], body["style"], body["curve"], body["program"], answer)
        for body in bodies
        for operation, (answer, _) in body["failed"].items()
        if _is_ours(body, operation)
    ]
    head = ("operation", "style", "curve", "program", "answer")
    order = list(MEANT.values())
    ours.sort(key=lambda row: (order.index(row[0]), *row[1:]))
    result = _table(head, ours, words=len(head)) if ours else ["None."]
    lines += ["## Failures on bodies of this program only", "", *result]
    return "\n".join(lines) + "\n"


def _is_ours(body: dict[str, Any], operation: str) -> bool:
    """No plain body fails too, or the body itself is at fault: its holes and tabs are those of the plain ones."""
    return body["failed"][operation][1] == "ok" or "volume" in body["failed"]


def _counted(bodies: Sequence[dict[str, Any]]) -> list[str]:
    """A line an operation: succeeded of asked in every style, and who fails."""
    rows = []
    for operation, meant in MEANT.items():
        good = Counter(body["style"] for body in bodies if operation in body["ok"])
        bad = Counter(body["style"] for body in bodies if operation in body["failed"])
        plain = Counter(_is_ours(body, operation) for body in bodies if operation in body["failed"])
        cells = [f"{good[s]}/{good[s] + bad[s]}" if good[s] + bad[s] else "" for s in STYLES]
        if any(cells):
            rows.append((meant, *cells, str(plain[False]), str(plain[True])))
    return _table(("operation", *STYLES, "simpler body fails too", "ours only"), rows)


def _table(head: Sequence[str], rows: Iterable[Sequence[str]], words: int = 1) -> list[str]:
    marks = ["---" if i < words else "---:" for i in range(len(head))]
    return [f"| {' | '.join(row)} |" for row in (head, marks, *rows)]
