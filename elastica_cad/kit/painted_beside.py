"""Pictures painted by a copy of this process, while it writes everything else."""

import os
import signal
import sys
import threading
import time
import warnings
from collections.abc import Callable, Collection, Iterator
from contextlib import contextmanager, suppress

from elastica_cad._process import begin_copy, usable_processors

LONGEST_S = 120.0
"""How long a copy is waited for: one that hangs is ended, and its pictures are painted here."""


@contextmanager
def painted_beside(painters: Collection[Callable[[], object]]) -> Iterator[Callable[[], bool]]:
    """A copy that paints for the time of the block; what waits for it, and says whether all is painted.

    False where there is no copy, as on one processor, and where it failed: then one paints for oneself, and is told
    what is wrong.
    """
    copy = _Copy(begin_copy(lambda: _paint(painters)) if painters and _may_copy() else 0)
    try:
        yield copy.has_painted
    finally:
        copy.end()


class _Copy:
    """Waits for the process of a number, 0 for none."""

    def __init__(self, number: int) -> None:
        self._number = number
        self._painted = False

    def has_painted(self) -> bool:
        """Has it done its work? Waits until it has ended."""
        end, pause = time.monotonic() + LONGEST_S, 1e-3
        while self._number and time.monotonic() < end:
            if not self._ended(os.WNOHANG):
                time.sleep(pause)
                pause = min(2 * pause, 0.02)
        self.end()
        return self._painted

    def end(self) -> None:
        """End it, whatever it does."""
        if self._number:
            with suppress(OSError):
                os.kill(self._number, signal.SIGKILL)
            self._ended(0)

    def _ended(self, how: int) -> bool:
        try:
            ended, status = os.waitpid(self._number, how)
        except ChildProcessError:  # somebody else has waited for it: nobody knows how it ended
            ended, status = self._number, 1
        if ended:
            self._number, self._painted = 0, status == 0
        return bool(ended)


def _may_copy() -> bool:
    """Would a copy spare time, and is it safe? Locks that other threads hold would stay locked in it for ever."""
    return sys.platform == "linux" and usable_processors() > 1 and threading.active_count() == 1


def _paint(painters: Collection[Callable[[], object]]) -> None:
    with warnings.catch_warnings():
        warnings.simplefilter("error", UserWarning)  # nobody would read them here
        for paint in painters:
            paint()
