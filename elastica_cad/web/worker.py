"""A process that answers questions of the page, one after the other: lines of JSON in, answers out.

An answer is its kind, `text` or `file`, its size in bytes, and then so many bytes. A worker that needs too much
memory refuses the question; one that takes too long is ended by the server, which starts another.
"""

import json
import sys
import traceback
from contextlib import suppress
from typing import Any

from elastica_cad.errors import ElasticaError
from elastica_cad.refusals import Refusal
from elastica_cad.web.answers import Download, answer

MOST_MEMORY = 3 * 2**30
"""Bytes of address space; a CAD kernel takes a third of that."""


def reply(line: bytes) -> tuple[bytes, bytes]:
    """Kind and content of the answer to one request; every fault becomes a sentence."""
    request: Any = None
    try:
        request = json.loads(line)
        found = answer(request)
    except ElasticaError as problem:
        found = {"refused": problem.refusal.record}
    except MemoryError:
        found = _refused("there is not enough memory for this: ask for less, such as fewer strips")
    except (
        Exception
    ):  # a page that is of another version, or nonsense: the next question is answered all the same
        traceback.print_exc()
        found = _refused("this design cannot be read: its values are of the wrong kind")
    known = request if isinstance(request, dict) else {}
    head = {name: known[name] for name in ("id", "do", "kind") if name in known}
    if isinstance(found, Download):
        return b"file", json.dumps(head | {"name": found.name}).encode() + b"\n" + found.content
    return b"text", json.dumps(head | found, allow_nan=False, default=str).encode()


def _refused(text: str) -> dict[str, Any]:
    return {"refused": Refusal("input", text).record}


def _limit_memory() -> None:
    with suppress(ImportError, OSError, ValueError):  # Windows has no such limit
        import resource

        resource.setrlimit(resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))


def main() -> None:
    """Answer until the input ends."""
    _limit_memory()
    out = sys.stdout.buffer
    sys.stdout = sys.stderr  # what a library prints is no answer
    for line in sys.stdin.buffer:
        kind, content = reply(line)
        out.write(b"%s %d\n" % (kind, len(content)) + content)
        out.flush()


if __name__ == "__main__":
    main()
