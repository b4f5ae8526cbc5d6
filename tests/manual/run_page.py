"""Runs one page of the manual as its reader does: python run_page.py PAGE, in an empty folder.

Blocks with a caption are saved as the file that it names, ```sh blocks are typed, ```python blocks share their
names, and a ```text block must be what the block before it printed; `...` stands for further lines.
"""

import re
import subprocess
import sys
from contextlib import redirect_stdout
from io import StringIO
from pathlib import Path

BLOCK = re.compile(r"^(?P<fence>`{3,})(?P<kind>[^\n]*)\n(?P<body>.*?)^(?P=fence)$", re.MULTILINE | re.DOTALL)
CAPTION = re.compile(r"\A:caption: (\S+)\n+")


def main(page: str) -> None:
    """Exit with the place of the first block that fails."""
    text, names, printed = Path(page).read_text(encoding="utf-8"), {"__name__": "manual"}, ""
    for block in BLOCK.finditer(text):
        kind, body = block["kind"].strip(), block["body"]
        line = text[: block.start()].count("\n") + 1
        caption = CAPTION.match(body)
        if caption is not None:
            Path(caption[1]).write_text(body[caption.end() :], encoding="utf-8")
        elif kind == "sh":
            printed = typed(body, line)
        elif kind == "python":
            stream = StringIO()
            with redirect_stdout(stream):
                exec(compile(body, f"{page}:{line}", "exec"), names)
            printed = stream.getvalue()
        elif kind == "text" and not same(body, printed):
            sys.exit(f"{page}:{line}: told\n{body}\nprinted\n{printed}")


def typed(commands: str, line: int) -> str:
    """What commands print; they must succeed."""
    done = subprocess.run(
        ["bash", "-euo", "pipefail", "-c", commands], capture_output=True, text=True, check=False
    )
    if done.returncode:
        sys.exit(f"line {line}: {commands}{done.stdout}{done.stderr}")
    return done.stdout


def same(told: str, printed: str) -> bool:
    """Equal line by line, but for what `...` stands for."""
    pattern = ".*".join(re.escape(part.strip("\n")) for part in told.strip().split("..."))
    return re.fullmatch(pattern + r"\s*", printed.strip(), re.DOTALL) is not None


if __name__ == "__main__":
    main(sys.argv[1])
