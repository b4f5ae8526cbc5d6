"""Conversion of tables to the text of a design file."""

import json
import os
import re
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from elastica_cad._toml import toml_string


def toml_text(table: Mapping[str, Any]) -> str:
    """Return a table as TOML.

    A list of tables becomes [[NAME]], and a table inside the list becomes [NAME.KEY]. Other values are inline.

    Examples
    --------
    >>> print(toml_text({"schema": 1, "strips": [{"label": "A", "curve": {"file": "a.dxf"}}]}))
    schema = 1
    <BLANKLINE>
    [[strips]]
    label = "A"
    <BLANKLINE>
    [strips.curve]
    file = "a.dxf"
    <BLANKLINE>
    """
    text = "".join(_line(key, value) for key, value in table.items() if not is_tables(value))
    for name, rows in table.items():
        for row in rows if is_tables(rows) else ():
            text += f"\n[[{name}]]\n"
            text += "".join(_line(key, value) for key, value in row.items() if not isinstance(value, Mapping))
            for key, value in row.items():
                if isinstance(value, Mapping):
                    text += f"\n[{name}.{toml_key(key)}]\n" + "".join(_line(*pair) for pair in value.items())
    return text


def is_tables(value: Any) -> bool:
    """Return True for a list of tables."""
    return isinstance(value, list) and bool(value) and all(isinstance(row, Mapping) for row in value)


def _line(key: str, value: Any) -> str:
    return f"{toml_key(key)} = {_value(value)}\n"


def toml_key(key: str) -> str:
    """Return a key as TOML, in quotes if necessary."""
    return key if re.fullmatch(r"[A-Za-z0-9_-]+", key) else toml_string(key)


def _value(value: Any) -> str:
    if isinstance(value, Mapping):
        return "{ " + ", ".join(f"{toml_key(key)} = {_value(item)}" for key, item in value.items()) + " }"
    if isinstance(value, list | tuple):
        return "[" + ", ".join(_value(item) for item in value) + "]"
    return toml_string(value) if isinstance(value, str) else json.dumps(value)


def seen_from(path: str | Path, folder: Path) -> str:
    """Return the path of a file relative to a folder, or its absolute path on another drive."""
    try:
        return Path(os.path.relpath(path, folder)).as_posix()
    except ValueError:  # no relative path exists between drives
        return Path(path).resolve().as_posix()
