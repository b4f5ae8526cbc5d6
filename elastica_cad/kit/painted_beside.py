"""Pictures painted by a copy of this process, while it writes everything else."""

import sys
import threading
import warnings
from collections.abc import Callable, Collection, Iterator
from contextlib import contextmanager, suppress

from elastica_cad._process import await_copy, begin_copy, end_copy, usable_processors

LONGEST_S = 120.0
"""How long a copy is waited for: one that hangs is ended, and its pictures are painted here."""


@contextmanager
def painted_beside(painters: Collection[Callable[[], object]]) -> Iterator[Callable[[], bool]]:
    """A copy that paints for the time of the block; what waits for it, and says whether all is painted.

    False where there is no copy, as on one processor, and where it failed: then one paints for oneself, and is told
    what is wrong.
    """
    waiting = [begin_copy(lambda: _paint(painters))] if painters and _may_copy() else []
    has_painted = False

    def are_painted() -> bool:
        nonlocal has_painted
        if waiting:
            with suppress(ChildProcessError):
                has_painted = await_copy(waiting.pop(), LONGEST_S) == 0
        return has_painted

    try:
        yield are_painted
    finally:
        for copy in waiting:
            end_copy(copy)


def _may_copy() -> bool:
    """Would a copy spare time, and is it safe? Locks that other threads hold would stay locked in it for ever."""
    return sys.platform == "linux" and usable_processors() > 1 and threading.active_count() == 1


def _paint(painters: Collection[Callable[[], object]]) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error", UserWarning)  # nobody would read them here
        for paint in painters:
            paint()
