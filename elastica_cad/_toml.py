"""TOML that users write, parsed within bounds."""

import re
import tomllib
from typing import Any

DEEPEST_KEY = 30
"""Keys joined by dots: ten times what a design file needs. The parser's memory grows with their square."""

_TOO_DEEP = re.compile(
    rf"""(?<![\w-])(?:(?:[\w-]++|"[^"\n]*+"|'[^'\n]*+')[ \t]*+\.[ \t]*+){{{DEEPEST_KEY}}}"""
)


def parse_toml(text: str) -> dict[str, Any]:
    """Return the tables of a TOML text.

    Raises
    ------
    tomllib.TOMLDecodeError
        No TOML, or a key of more than `DEEPEST_KEY` parts.

    Examples
    --------
    >>> parse_toml("limits.ratio = 3.5")
    {'limits': {'ratio': 3.5}}
    """
    if match := _TOO_DEEP.search(text):
        line = text.count("\n", 0, match.start()) + 1
        raise tomllib.TOMLDecodeError(f"Key of more than {DEEPEST_KEY} parts (at line {line}, column 1)")
    return tomllib.loads(text)
