"""A process that answers questions of the page, one after the other: lines of JSON in, answers out.

An answer is its kind, `text` or `file`, its size in bytes, and then so many bytes. A worker that needs too much
memory refuses the question; one that takes too long is ended by the server, which starts another.
"""

import json
import sys
import traceback
from collections.abc import Mapping
from contextlib import suppress
from functools import cache
from typing import Any

from elastica_cad.errors import ElasticaError
from elastica_cad.refusals import Refusal, Wording
from elastica_cad.web.answers import Download, answer
from elastica_cad.words import Translated

MOST_MEMORY = 3 * 2**30
"""Bytes of address space; a CAD kernel takes a third of that."""

FREECAD_NAMES = ("MaxWidth", "MinWidth", "LeastWidth", "Anyway", "NaturalCurvature", "HoleRatio")
GERMAN_NAMES = (
    "größte Breite",
    "kleinste Breite",
    "Werkstatt",
    "Grenzen übergehen",
    "Vorkrümmung",
    "Lochanteil",
)
CHINESE_NAMES = ("最大宽度", "最小宽度", "车间", "忽略限制", "初始曲率", "孔比例")
"""Names of fields in catalogues, and in the page."""


def reply(line: bytes) -> tuple[bytes, bytes]:
    """Return kind and content of the answer to one request; every error becomes a sentence."""
    request: Any = None
    try:
        request = json.loads(line)
        found = answer(request)
    except ElasticaError as problem:
        found = _refused(problem.refusal)
    except MemoryError:
        found = _refused("there is not enough memory for this: ask for less, such as fewer strips")
    except (
        Exception
    ):  # a page that is of another version, or nonsense: the next question is answered all the same
        traceback.print_exc()
        found = _refused("this design cannot be read: its values are of the wrong kind")
    known = request if isinstance(request, dict) else {}
    words = wording_of(str(known.get("language", "en")))
    head = {name: known[name] for name in ("id", "do", "kind") if name in known}
    if isinstance(found, Download):
        return b"file", json.dumps(head | {"name": found.name}).encode() + b"\n" + found.content
    return b"text", json.dumps(head | _worded(found, words), allow_nan=False).encode()


class _PageWords(Translated):
    """Sentences with the names of fields that the page shows, where catalogues have those of FreeCAD."""

    def __init__(self, language: str, names: Mapping[str, str]) -> None:
        super().__init__(language)
        self._names, self.point = names, "," if language == "de" else "."

    def template(self, text: str) -> str:
        """From the catalogue."""
        said = super().template(text)
        for shown, name in self._names.items():
            said = said.replace(shown, name)
        return said


@cache
def wording_of(language: str) -> Wording:
    """How the page speaks a language: "de", "zh", or else English."""
    match language:
        case "de":
            return _PageWords("de", dict(zip(FREECAD_NAMES, GERMAN_NAMES, strict=True)))
        case "zh":
            return _PageWords("zh-CN", dict(zip(FREECAD_NAMES, CHINESE_NAMES, strict=True)))
    return Wording()


def _worded(value: Any, words: Wording) -> Any:
    """The same with every record of a sentence as the sentence in the user's language."""
    if isinstance(value, Refusal):
        return words.sentence(value)
    if isinstance(value, dict):
        return {key: _worded(one, words) for key, one in value.items()}
    if isinstance(value, list) and value and isinstance(value[0], str | dict):
        return [_worded(one, words) for one in value]
    return value


def _refused(text: str) -> dict[str, Any]:
    return {"refused": {"message": text if isinstance(text, Refusal) else Refusal("input", text)}}


def _limit_memory() -> None:
    with suppress(ImportError, OSError, ValueError):  # Windows has no such limit
        import resource

        resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))


def main() -> None:
    """Read requests line by line and answer them until the input ends."""
    _limit_memory()
    out = sys.stdout.buffer
    sys.stdout = sys.stderr  # what a library prints is no answer
    for line in sys.stdin.buffer:
        kind, content = reply(line)
        out.write(b"%s %d\n" % (kind, len(content)) + content)
        out.flush()
