"""Catalogues of translations, by the English template.

Keys of texts of the page are "page|TEXT". Keys of headings of the assembly sheet are "sheet|TEXT".
"""

import json
from functools import cache
from importlib.resources import files
from typing import Any, Literal, TypeAlias

from elastica_cad.errors import Wording

LANGUAGES = ("de", "zh-CN")

Language: TypeAlias = Literal["en", "de", "zh-CN"]
"""English, or a language with a catalogue."""


@cache
def catalogue(language: str) -> dict[str, str]:
    """Return the translations by their English texts, or {} for a language without a catalogue."""
    if language not in LANGUAGES:
        return {}
    words: dict[str, str] = json.loads(
        files("elastica_cad.translations").joinpath(f"{language}.json").read_text("utf-8")
    )
    return words


class Translated(Wording):
    """Sentences in a language, or in English if they are not in its catalogue.

    Parameters
    ----------
    language : str
        "en" or one of `LANGUAGES`.

    Examples
    --------
    >>> Translated("de").template("the sheet bears {strain}") == "the sheet bears {strain}"  # no such sentence
    True
    """

    def __init__(self, language: str) -> None:
        self._catalogue = catalogue(language)

    def template(self, text: str) -> str:
        """Return the template in the catalogue's language."""
        return self._catalogue.get(text, text)

    def format_field(self, value: Any, spec: str) -> str:
        """Format a value. Words that the program chooses, such as "start", are translated."""
        return super().format_field(self.template(value) if type(value) is str else value, spec)
