"""Runs one page of the manual as its reader does: python run_page.py PAGE, in an empty folder.

A block after a line that names a file and ends in a colon ("Save as `arch.svg`:") is saved as that file, ```sh
blocks are typed, ```python blocks share their names, and a ```text block must be what the block before it printed;
`...` stands for further lines.
"""

import re
import subprocess
import sys
from collections.abc import Iterator
from contextlib import redirect_stdout
from dataclasses import dataclass
from io import StringIO
from pathlib import Path

FENCED = re.compile(
    r"(?P<lead>[^\n]*\n\s*)?^(?P<fence>`{3,})(?P<kind>[^\n]*)\n(?P<body>.*?)^(?P=fence)$",
    re.MULTILINE | re.DOTALL,
)
SAVED_AS = re.compile(r"`([\w-]+\.\w+)`[^`]*:\s*\Z")
NOT_FILES = ("sh", "python", "text")


@dataclass(frozen=True)
class Block:
    """A fenced block: its line, its language, its text, and the name of the file that it is saved as, if any."""

    line: int
    kind: str
    body: str
    file: str | None


def blocks(text: str) -> Iterator[Block]:
    """The blocks of a page in their order."""
    for found in FENCED.finditer(text):
        kind = found["kind"].strip()
        named = None if kind in NOT_FILES else SAVED_AS.search(found["lead"] or "")
        line = text[: found.start("fence")].count("\n") + 1
        yield Block(line, kind, found["body"], named and named[1])


def main(page: str) -> None:
    """Exit with the place of the first block that fails."""
    names, printed = {"__name__": "manual"}, ""
    for block in blocks(Path(page).read_text(encoding="utf-8")):
        if block.file:
            Path(block.file).write_text(block.body, encoding="utf-8")
        elif block.kind == "sh":
            printed = typed(block.body, block.line)
        elif block.kind == "python":
            stream = StringIO()
            with redirect_stdout(stream):
                exec(compile(block.body, f"{page}:{block.line}", "exec"), names)
            printed = stream.getvalue()
        elif block.kind == "text" and not same(block.body, printed):
            sys.exit(f"{page}:{block.line}: told\n{block.body}\nprinted\n{printed}")


def typed(commands: str, line: int) -> str:
    """What commands print; they must succeed."""
    done = subprocess.run(
        ["bash", "-euo", "pipefail", "-c", commands], capture_output=True, text=True, check=False
    )
    if done.returncode:
        sys.exit(f"line {line}: {commands}{done.stdout}{done.stderr}")
    return done.stdout


def same(message: str, printed: str) -> bool:
    """Equal line by line, but for what `...` stands for."""
    pattern = ".*".join(re.escape(part.strip("\n")) for part in message.strip().split("..."))
    return re.fullmatch(pattern + r"\s*", printed.strip(), re.DOTALL) is not None


if __name__ == "__main__":
    main(sys.argv[1])
