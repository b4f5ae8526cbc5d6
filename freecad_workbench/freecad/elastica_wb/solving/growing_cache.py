# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""A cache of as many answers as the open documents have use for."""

from collections import OrderedDict
from collections.abc import Callable, Hashable
from functools import wraps
from threading import Lock
from typing import Any, TypeVar

import FreeCAD as App

LEAST = 64  # answers that are kept whatever is open
PER_OBJECT = 2  # answers for each object of the documents: the present one and the one before, for undo

Answer = TypeVar("Answer")


def growing_cache(work: Callable[..., Answer]) -> Callable[..., Answer]:
    """Remember answers by their arguments; the oldest go first. Failures are not remembered."""
    kept: OrderedDict[Hashable, Any] = OrderedDict()
    most = LEAST
    lock = Lock()  # panels ask from threads of their own

    @wraps(work)
    def ask(*arguments: Any) -> Answer:
        with lock:
            if arguments in kept:
                kept.move_to_end(arguments)
                return kept[arguments]
        answer = work(*arguments)
        nonlocal most
        with lock:
            kept[arguments] = answer
            if len(kept) > most:  # a long list of objects takes long to get: not for every answer
                room = _room()
                most = room + LEAST
                while len(kept) > room:
                    kept.popitem(last=False)
        return answer

    return ask


def _room() -> int:
    """How many answers the open documents have use for."""
    return max(LEAST, PER_OBJECT * sum(len(one.Objects) for one in App.listDocuments().values()))
