"""Every table and every fenced block of the manual, of README, CONTRIBUTING and the workbench's README."""

import re
from dataclasses import dataclass
from pathlib import Path

from tests.manual.run_page import FENCED, Block
from tests.manual.run_page import blocks as blocks_of

ROOT = Path(__file__).resolve().parents[2]
WRITTEN_WHOLE = ROOT / "docs" / "reference"  # by `make generate`
PAGES = [
    *sorted(path for path in (ROOT / "docs").rglob("*.md") if WRITTEN_WHOLE not in path.parents),
    *(ROOT / name for name in ("README.md", "CONTRIBUTING.md", "SECURITY.md", "freecad_workbench/README.md")),
]
RULE = re.compile(r"\|[ :|-]*-[ :|-]*\|")


@dataclass(frozen=True)
class Table:
    """One table: its page as a path from the repository, the cells of its head, those of its rows."""

    page: str
    head: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]


def tables() -> list[Table]:
    """All tables, in the order of the pages."""
    found = []
    for page in PAGES:
        lines = FENCED.sub(r"\g<lead>", page.read_text(encoding="utf-8")).split("\n")
        for number, line in enumerate(lines):
            if RULE.fullmatch(line):
                end = next(
                    k
                    for k in range(number + 1, len(lines) + 1)
                    if not "".join(lines[k : k + 1]).startswith("|")
                )
                rows = tuple(cells(row) for row in lines[number + 1 : end])
                found.append(Table(page.relative_to(ROOT).as_posix(), cells(lines[number - 1]), rows))
    return found


def cells(line: str) -> tuple[str, ...]:
    """What stands between the bars."""
    return tuple(cell.strip() for cell in line.strip().removeprefix("|").removesuffix("|").split("|"))


def blocks() -> list[tuple[str, Block]]:
    """All fenced blocks with their pages, in the order of the pages."""
    return [
        (page.relative_to(ROOT).as_posix(), block)
        for page in PAGES
        for block in blocks_of(page.read_text(encoding="utf-8"))
    ]


def quoted(cell: str) -> list[str]:
    """What a cell has between backticks."""
    return re.findall(r"`([^`]+)`", cell)
