"""Text files that are the same on every system: UTF-8, lines ended by line feeds."""

import json
from pathlib import Path
from typing import Any


def write_text(path: Path, text: str) -> None:
    """Write a text.

    Examples
    --------
    >>> from tempfile import TemporaryDirectory
    >>> with TemporaryDirectory() as folder:
    ...     write_text(Path(folder, "a.txt"), "8 µm\\n")
    ...     Path(folder, "a.txt").read_bytes()
    b'8 \\xc2\\xb5m\\n'
    """
    path.write_text(text, encoding="utf-8", newline="\n")


def write_json(path: Path, record: Any) -> None:
    """Write a record as JSON."""
    write_text(path, json.dumps(record, indent=1) + "\n")
