"""A budget of time and memory: long work ends with a sentence, and what was done before is kept."""

import ctypes
import os
import sys
import threading
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from elastica_cad.errors import ElasticaError

USUAL_S, USUAL_MIB = 3600.0, 8192.0
"""Far more than any example takes."""

LOOK_S = 0.2
"""Between two looks at clock and memory."""

GRACE_S = 15.0
"""How long a library may go on that does not hear; then the program ends, and the next run clears up behind it."""


class _Ended(BaseException):
    """Raised in the main thread from outside; nothing on the way catches it."""


class OutOfBudgetError(ElasticaError):
    """The time or the memory that a command may take is used up."""


@contextmanager
def spend(seconds: float, mib: float, *, beside: Callable[[], int | None] | None = None) -> Iterator[None]:
    """Run the block within limits of time and memory; `beside` tells the number of a process that shares them.

    Raises
    ------
    OutOfBudgetError
        It took more, or asked for more than there is.
    """
    done, said, worker = threading.Event(), list[str](), threading.get_ident()

    def look() -> None:
        end = time.monotonic() + seconds
        while not done.wait(min(LOOK_S, seconds)):
            if time.monotonic() > end:
                said.append(
                    f"this takes longer than {seconds:g} s: ask for less at a time (a smaller drawing, fewer "
                    "strips, looser limits), or give it more with --seconds"
                )
            elif (used := resident_mib() + resident_mib(beside and beside())) > mib:
                said.append(
                    f"this takes more than {mib:g} MB of memory ({used:.0f} MB now): ask for less at a time, or "
                    "give it more with --memory"
                )
            else:
                continue
            ctypes.pythonapi.PyThreadState_SetAsyncExc(ctypes.c_ulong(worker), ctypes.py_object(_Ended))
            if not done.wait(GRACE_S):
                sys.stderr.write(f"Error: {said[0]}\n")
                sys.stderr.flush()
                os._exit(2)
            return

    watcher = threading.Thread(target=look, daemon=True)
    try:
        try:
            watcher.start()  # a budget of next to nothing ends it here
            yield
        finally:
            done.set()
            if watcher.is_alive():  # Ctrl-C may have come before it was
                watcher.join()
        if said:  # it came where Python ignores exceptions, as in a destructor
            raise OutOfBudgetError(said[0])
    except _Ended:
        if not said:  # it is meant for a block around this one
            raise
        raise OutOfBudgetError(said[0]) from None
    except MemoryError:
        raise OutOfBudgetError(
            "there is not enough memory for this: ask for less at a time, such as fewer strips or samples"
        ) from None


def resident_mib(process: int | str | None = "self") -> float:
    """Memory that a process uses now; 0 where the system does not say, or there is none."""
    if process is None:
        return 0.0
    try:
        with open(f"/proc/{process}/statm", encoding="ascii") as file:
            return int(file.read().split()[1]) * os.sysconf("SC_PAGE_SIZE") / 2**20
    except (OSError, ValueError, IndexError):
        return 0.0
