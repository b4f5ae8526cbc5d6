"""Process that answers requests of the page, lines of JSON, one after another.

An answer is its kind, `text` or `file`, its size in bytes, and its bytes. A worker that needs too much memory
returns an error. The server replaces a worker that takes too long.
"""

import json
import sys
import traceback
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any

from elastica_cad.errors import ElasticaError, InputError
from elastica_cad.refusals import Refusal, Wording
from elastica_cad.web.answers import Download, answer, refused
from elastica_cad.words import Translated

MOST_MEMORY = 3 * 2**30
"""Bytes of address space; a CAD kernel takes a third of that."""

CATALOGUES = {"de": "de", "zh": "zh-CN"}
"""Catalogues by the languages of the page besides English."""


def read_question(text: str | bytes) -> dict[str, Any]:
    """Return a request of the page from its JSON.

    Raises
    ------
    InputError
        The text is not JSON, or not a request of a page.
    """
    try:
        question = json.loads(text, parse_constant=_refuse_constant)
    except (ValueError, RecursionError):
        question = None
    kinds = {"do": str, "id": int, "kind": str, "language": str}
    if not isinstance(question, dict) or not all(
        isinstance(question.get(name, kind()), kind) for name, kind in kinds.items()
    ):
        raise InputError("The request is not from this page. Load the page again.")
    return question


def _refuse_constant(name: str) -> None:
    raise ValueError(name)  # refuse NaN and Infinity, which are not JSON


def head_of(question: Mapping[str, Any]) -> dict[str, Any]:
    """Return the keys with which the page matches an answer with its request."""
    return {name: question[name] for name in ("id", "do", "kind") if name in question}


def refused_answer(question: Mapping[str, Any], problem: ElasticaError) -> bytes:
    """Return the answer to a request that no worker can answer."""
    return json.dumps(head_of(question) | refused(problem)).encode()


def reply(line: bytes, saved: Path | None = None) -> tuple[bytes, bytes]:
    """Return kind and content of the answer to a request; errors become sentences.

    Parameters
    ----------
    line : bytes
    saved : Path, optional
        The design file of the studio.
    """
    request: dict[str, Any] = {}
    try:
        request = read_question(line)
        response = answer(request, saved)
    except ElasticaError as problem:
        response = refused(problem)
    except MemoryError:
        response = refused(InputError("There is not enough memory. Request less, such as fewer strips."))
    # the request of a page of another version, or an invalid text; later requests are still answered
    except Exception:
        traceback.print_exc()
        response = refused(
            InputError("The design cannot be read because values have the wrong type. Correct them.")
        )
    words, head = _PageWords(request.get("language", "en")), head_of(request)
    if isinstance(response, Download):
        return b"file", json.dumps(head | {"name": response.name}).encode() + b"\n" + response.content
    return b"text", json.dumps(head | _worded(response, words), allow_nan=False).encode()


class _PageWords(Translated):
    """Sentences in a language of the page, with fields called as the page labels them."""

    def __init__(self, language: str) -> None:
        super().__init__(CATALOGUES.get(language, "en"))
        self.point = "," if language == "de" else "."

    def field(self, name: str) -> str:
        """Return the label of a field in quotation marks."""
        label = name.rpartition(".")[2].replace("_", " ")
        words = self.template(f"page|{label}")
        words = self.template(label) if words.startswith("page|") else words
        return f"„{words}“" if self.point == "," else f"“{words}”"


def _worded(value: Any, words: Wording) -> Any:
    """Return the answer with every message as a sentence in the user's language."""
    if isinstance(value, Refusal):
        return words.sentence(value)
    if isinstance(value, dict):
        return {key: _worded(item, words) for key, item in value.items()}
    if isinstance(value, list) and value and isinstance(value[0], str | dict):
        return [_worded(item, words) for item in value]
    return value


def _limit_memory() -> None:
    with suppress(ImportError, OSError, ValueError):  # Windows has no limit of address space
        import resource

        resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))


def main() -> None:
    """Read requests line by line and answer them until the input ends; the argument is the design file."""
    _limit_memory()
    saved = Path(sys.argv[1]) if sys.argv[1:] else None
    out = sys.stdout.buffer
    sys.stdout = sys.stderr  # the output of a library must not be taken for an answer
    for line in sys.stdin.buffer:
        kind, content = reply(line, saved)
        out.write(b"%s %d\n" % (kind, len(content)) + content)
        out.flush()
