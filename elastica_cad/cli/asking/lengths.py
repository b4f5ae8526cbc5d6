"""Lengths on the command line: numbers of mm, or of the unit they name."""

import re
from typing import Any

import click

from elastica_cad.formats.file_access.source_file import MILLIMETRES

UNITS = {"mm": 1.0, "inch": MILLIMETRES["in"]}
"""What `--units` may say, in mm."""

_NAMED = MILLIMETRES | {"inch": MILLIMETRES["in"], '"': MILLIMETRES["in"]}


class Length(click.ParamType):  # type: ignore[type-arg]  # no generic class before click 8.2
    """A length in mm: "38", "1.5in", "5/16in", "3.8cm"; without a unit it is of the command's `--units`.

    Parameters
    ----------
    positive : bool
        Refuse zero and less.
    words : tuple of str
        What may stand instead of a length.
    """

    name = "length"

    def __init__(self, *, positive: bool = False, words: tuple[str, ...] = ()) -> None:
        self.positive, self.words = positive, words

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> float | str:
        """The length in mm, or one of the words; a default is mm already."""
        if not isinstance(value, str):
            return float(value)
        if value in self.words:
            return value
        plain = UNITS[(ctx.params.get("units") if ctx else None) or "mm"]
        found = re.fullmatch(r"\s*([-+.\deE/ ]+?)\s*([a-z]+|\")\s*", value)
        number, scale = (value, plain) if found is None else (found[1], _NAMED.get(found[2], 0.0))
        try:
            length = scale * _number(number)
        except ValueError:
            scale = 0.0
        if not scale:
            known = ", ".join(["a number of mm", *(f"the word {word}" for word in self.words)])
            self.fail(
                f"{value!r} is no length: give {known}, or a length with its unit such as 1.5in or 4cm",
                param,
                ctx,
            )
        if self.positive and not length > 0:
            self.fail(f"{value} is no length above 0", param, ctx)
        return length


def _number(text: str) -> float:
    """Of digits, or of a fraction as on a folding rule: "5/16", "1 3/8", "1-3/8"."""
    parts = re.fullmatch(r"\s*(?:(\d+)[ -])?(\d+)/([1-9]\d*)\s*", text)
    return float(text) if parts is None else int(parts[1] or 0) + int(parts[2]) / int(parts[3])


LENGTH = Length()
POINT, SPACE_POINT = (LENGTH, LENGTH), (LENGTH, LENGTH, LENGTH)
