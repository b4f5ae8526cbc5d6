"""What the program says in other languages: for each English template of a record the one of a language."""

import json
from functools import cache
from importlib.resources import files
from typing import Any

from elastica_cad.refusals import Wording

LANGUAGES = ("de", "zh-CN")


@cache
def catalogue(language: str) -> dict[str, str]:
    """What a language has for English templates; nothing for a language that is not known."""
    if language not in ("en", *LANGUAGES):
        return {}
    words: dict[str, str] = json.loads(
        files("elastica_cad.words").joinpath(f"{language}.json").read_text("utf-8")
    )
    return words


class Translated(Wording):
    """Sentences in one of the languages; what its catalogue does not hold is said in English.

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
        self._catalogue = catalogue("en") | catalogue(language)

    def template(self, text: str) -> str:
        """Return the template in the catalogue's language."""
        return self._catalogue.get(text, text)

    def format_field(self, value: Any, spec: str) -> str:
        """Words that the program chooses, such as "start", are in the catalogue too."""
        return super().format_field(self.template(value) if type(value) is str else value, spec)
