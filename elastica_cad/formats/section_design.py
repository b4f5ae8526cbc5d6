"""A design file for strips along sections, written down so that it can be changed and made again."""

import json
import re
from collections.abc import Mapping
from typing import Any

__all__ = ["section_design"]


def section_design(name: str, sections: Mapping[str, Any], strips: Mapping[str, Any]) -> str:
    """The text of a design file whose strips follow sections of a surface.

    Parameters
    ----------
    name : str
        Of the model.
    sections : mapping
        The table `sections`, as `sections_of` reads it.
    strips : mapping
        Keys for all strips: sheet, max_width, limits and so on.

    Examples
    --------
    >>> print(section_design("pot", {"mesh": "pot.obj", "radial": {"count": 8}}, {"sheet": "card-200gsm"}))
    schema = 1
    name = "pot"
    sheet = "card-200gsm"
    <BLANKLINE>
    [[strips]]
    label = "S{i}"
    <BLANKLINE>
    [strips.sections]
    mesh = "pot.obj"
    radial = { count = 8 }
    <BLANKLINE>
    """
    head = {"schema": 1, "name": name, **strips}
    parts = [head, {"label": "S{i}"}, sections]
    titles = ["", "\n[[strips]]\n", "\n[strips.sections]\n"]
    return "".join(
        title + "".join(f"{_key(key)} = {_value(value)}\n" for key, value in part.items())
        for title, part in zip(titles, parts, strict=True)
    )


def _key(key: str) -> str:
    return key if re.fullmatch(r"[A-Za-z0-9_-]+", key) else json.dumps(key)


def _value(value: Any) -> str:
    """A value as TOML writes it: JSON's words for all but tables."""
    if isinstance(value, Mapping):
        return "{ " + ", ".join(f"{_key(key)} = {_value(one)}" for key, one in value.items()) + " }"
    if isinstance(value, list | tuple):
        return "[" + ", ".join(_value(one) for one in value) + "]"
    return json.dumps(value, ensure_ascii=False)
