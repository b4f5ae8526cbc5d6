"""Worker process that answers requests of the page one after another, in the language of the page.

Each request is a line of JSON. An answer consists of its kind (`text` or `file`), its size in bytes, and its
contents. If a computation needs too much memory, the answer is an error.
"""

import json
import sys
import traceback
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any

from elastica_cad.errors import ElasticaError, InputError, Refusal, Wording
from elastica_cad.translations import Translated
from elastica_cad.web.answers import CATALOGUES, Download, answer, refused

MOST_MEMORY = 3 * 2**30
"""Largest address space of a worker, bytes. A CAD kernel needs a third of this size."""


def read_question(text: str | bytes) -> dict[str, Any]:
    """Parse a request of the page from JSON."""
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
    raise ValueError(name)  # NaN and Infinity are not JSON


def _head_of(question: Mapping[str, Any]) -> dict[str, Any]:
    """Return the keys of a request that are repeated in the answer, so that the page can match them."""
    return {name: question[name] for name in ("id", "do", "kind") if name in question}


def reply(line: bytes, saved: Path | None = None) -> tuple[bytes, bytes]:
    """Return the kind and contents of the answer to a request. An error is answered by its message.

    Parameters
    ----------
    line : bytes
        The request as JSON.
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
    # a wrong request of an old page must not end the worker
    except Exception:
        traceback.print_exc()
        response = refused(
            InputError("The design cannot be read because values have the wrong type. Correct them.")
        )
    if isinstance(response, Download):
        head = json.dumps(_head_of(request) | {"name": response.name}).encode()
        return b"file", head + b"\n" + response.content
    return b"text", text_answer(request, response)


def text_answer(request: Mapping[str, Any], response: Any) -> bytes:
    """Return an answer as JSON, in the language of the page."""
    words = _PageWords(request.get("language", "en"))
    return json.dumps(_head_of(request) | _translated(response, words), allow_nan=False).encode()


class _PageWords(Translated):
    """Words of the page's language, with names of fields as the page labels them."""

    def __init__(self, language: str) -> None:
        super().__init__(CATALOGUES.get(language, "en"))
        self.point = "," if language == "de" else "."

    def field(self, name: str) -> str:
        label = name.rpartition(".")[2].replace("_", " ")
        words = self.template(f"page|{label}")
        words = self.template(label) if words.startswith("page|") else words
        return f"„{words}“" if self.point == "," else f"“{words}”"


def _translated(value: Any, words: Wording) -> Any:
    """Return an answer with all sentences in the language of the page."""
    if isinstance(value, Refusal):
        return words.sentence(value)
    if isinstance(value, dict):
        return {key: _translated(item, words) for key, item in value.items()}
    # long lists of points contain no sentences
    if isinstance(value, list) and value and isinstance(value[0], str | dict):
        return [_translated(item, words) for item in value]
    return value


def main() -> None:
    """Read requests line by line and answer them until the input ends.

    The argument of the process is the design file.
    """
    # ignore errors on Windows, which cannot limit the address space
    with suppress(ImportError, OSError, ValueError):
        import resource

        resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))
    saved = Path(sys.argv[1]) if sys.argv[1:] else None
    out = sys.stdout.buffer
    # keep the output of libraries apart from the answers
    sys.stdout = sys.stderr
    for line in sys.stdin.buffer:
        kind, content = reply(line, saved)
        out.write(b"%s %d\n" % (kind, len(content)) + content)
        out.flush()
