"""Strings of TOML, and a parser for TOML from users, with limited memory."""

import json
import re
import tomllib
from typing import Any

DEEPEST_KEY = 30
"""Largest number of parts of a dotted key, ten times what a design file needs. The memory of the parser grows
with the square of this number.
"""

_TOO_DEEP = re.compile(
    rf"""(?<![\w-])(?:(?:[\w-]++|"[^"\n]*+"|'[^'\n]*+')[ \t]*+\.[ \t]*+){{{DEEPEST_KEY}}}"""
)


def parse_toml(text: str) -> dict[str, Any]:
    """Return the tables of a TOML text.

    Raises
    ------
    tomllib.TOMLDecodeError
        The text is not TOML, or a key has more than `DEEPEST_KEY` parts.

    Examples
    --------
    >>> parse_toml("limits.ratio = 3.5")
    {'limits': {'ratio': 3.5}}
    """
    if match := _TOO_DEEP.search(text):
        line = text.count("\n", 0, match.start()) + 1
        raise tomllib.TOMLDecodeError(f"Key of more than {DEEPEST_KEY} parts (at line {line}, column 1)")
    return tomllib.loads(text)


def toml_string(text: str) -> str:
    """Return the text as a basic string of TOML.

    Examples
    --------
    >>> print(toml_string('plywood 1/32"'))
    "plywood 1/32\\""
    """
    # a string of JSON, apart from the only control character that JSON allows
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")
