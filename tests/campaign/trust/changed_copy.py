"""A process that runs a changed copy of the checkout: the libraries loaded, nothing of ours, and never endless."""

import os
import resource
import signal
import sys
import time
from collections.abc import Callable
from pathlib import Path

SLOWER, MORE_S = 4, 20
"""So many times as long as without a change a work may take, and so many seconds more: then its loop is endless."""

FAILED = 99
"""Exit code of a process that ended otherwise than by what it ran."""


def in_copy(copy: Path, work: Callable[[], int], seconds: float, compiled: bool = False) -> int:
    """The code that the work gives in the copy; that of a signal where it was ended, as `os` tells it.

    `seconds` is what it takes of the processor without a change. What is compiled is kept only if `compiled`, as a
    change must not outlive its file.
    """
    child = os.fork()
    if not child:
        code = FAILED
        try:
            limit = int(SLOWER * seconds + MORE_S)
            resource.setrlimit(resource.RLIMIT_CPU, (limit, limit))
            _enter(copy)
            sys.dont_write_bytecode = not compiled
            code = work()
        finally:
            os._exit(code)
    end = time.monotonic() + 10 * (SLOWER * seconds + MORE_S)
    while not (done := os.waitpid(child, os.WNOHANG))[0]:
        if time.monotonic() > end:
            os.kill(child, signal.SIGKILL)
            done = os.waitpid(child, 0)
            break
        time.sleep(0.02)
    return os.waitstatus_to_exitcode(done[1])


def _enter(copy: Path) -> None:
    os.chdir(copy)
    os.environ["PYTHONPATH"] = sys.path[0] = str(copy)
    for name in [name for name in sys.modules if name.partition(".")[0] in ("tests", "elastica_cad")]:
        del sys.modules[name]
    nowhere = os.open(os.devnull, os.O_RDWR)
    for stream in (0, 1, 2):
        os.dup2(nowhere, stream)
