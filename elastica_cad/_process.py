"""This process: how many processors it may use, how often it looks for cycles, and copies of it."""

import faulthandler
import gc
import os
import signal
import time
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress

RARE_COLLECTIONS = (200_000, 20, 20)
"""Thresholds of the garbage collector: a command ends before its cycles matter, a strip makes 100 000 objects."""


def usable_processors() -> int:
    """How many this process may use."""
    return len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1


@contextmanager
def rare_collections() -> Iterator[None]:
    """Rare ones for the time of the block: kits of thousands of holes would be looked through again and again.

    Examples
    --------
    >>> with rare_collections():
    ...     gc.get_threshold()
    (200000, 20, 20)
    """
    before = gc.get_threshold()
    gc.set_threshold(*RARE_COLLECTIONS)
    try:
        yield
    finally:
        gc.set_threshold(*before)


def begin_copy(task: Callable[[], object]) -> int:
    """The number of a copy that does a task in silence; it ends with 0, or with 1 where the task failed."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", DeprecationWarning)  # of threads: the copy runs none but this one
        copy = os.fork()
    if copy:
        return copy
    failed = 1
    with suppress(BaseException):
        faulthandler.disable()
        silence = os.open(os.devnull, os.O_WRONLY)
        os.dup2(silence, 1)
        os.dup2(silence, 2)
        task()
        failed = 0
    os._exit(failed)


def await_copy(copy: int, longest_s: float) -> int | None:
    """The status that a copy ends with; None where it took longer, and was ended.

    Raises
    ------
    ChildProcessError
        Somebody else has waited for it, so that nobody knows how it ended.
    """
    end, pause = time.monotonic() + longest_s, 1e-3
    try:
        while time.monotonic() < end:
            ended, status = os.waitpid(copy, os.WNOHANG)
            if ended:
                copy = 0
                return status
            time.sleep(pause)
            pause = min(2 * pause, 0.02)
        return None
    except ChildProcessError:
        copy = 0
        raise
    finally:
        if copy:
            end_copy(copy)


def end_copy(copy: int) -> None:
    """End a copy, whatever it does."""
    with suppress(ProcessLookupError, ChildProcessError):
        os.kill(copy, signal.SIGKILL)
        os.waitpid(copy, 0)
