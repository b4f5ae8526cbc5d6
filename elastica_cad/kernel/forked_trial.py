"""Damaged files on which OpenCASCADE breaks down: a copy of the program tries them first."""

import faulthandler
import os
import signal
import sys
import warnings
from collections.abc import Callable
from contextlib import suppress

from elastica_cad.errors import InputError

LEAST_S, S_PER_MB = 5, 5
"""What a trial may take of the processor: ten times what sound files take."""

BUSY = 10
"""How many times as long by the clock, on a machine that has other things to do."""

PR_SET_PDEATHSIG = 1
"""Of Linux: the signal that a process gets when its parent ends."""


def try_in_a_copy(task: Callable[[], object], size: int = 0) -> None:
    """Run a task in a copy of this process, where the system makes copies; what it raises is left to the real run.

    The copy limits itself, so that it ends whatever becomes of this process; on Linux it ends with it.

    Parameters
    ----------
    task : callable
    size : int
        Of the file that it reads, bytes.

    Raises
    ------
    InputError
        The system ended the copy, or it ran too long.
    """
    if not hasattr(os, "fork"):
        return
    seconds = LEAST_S + S_PER_MB * size // 2**20
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", DeprecationWarning)  # of threads: the copy runs none but this one
        parent, copy = os.getpid(), os.fork()
    if not copy:
        with suppress(BaseException):
            _limit(parent, seconds)
            with suppress(Exception):
                task()
            os._exit(0)
        os._exit(1)
    try:
        status = os.waitpid(copy, 0)[1]
    except BaseException:  # Ctrl-C
        os.kill(copy, signal.SIGKILL)
        raise
    if os.WIFSIGNALED(status) and os.WTERMSIG(status) in (signal.SIGXCPU, signal.SIGALRM):
        raise InputError(f"OpenCASCADE has not read this file within {seconds} s: export its curves alone")
    if status:
        raise InputError("OpenCASCADE breaks down on this file, which is damaged: export it anew")


def _limit(parent: int, seconds: int) -> None:
    """Make this copy silent, and end it after a while, also in compiled loops, or with its parent on Linux."""
    import resource

    faulthandler.disable()
    silence = os.open(os.devnull, os.O_WRONLY)
    os.dup2(silence, 1)
    os.dup2(silence, 2)
    most = resource.getrlimit(resource.RLIMIT_CPU)[1]
    seconds = seconds if most == resource.RLIM_INFINITY else min(seconds, most)
    signal.signal(signal.SIGXCPU, signal.SIG_DFL)
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, most))
    signal.signal(signal.SIGALRM, signal.SIG_DFL)
    signal.alarm(BUSY * seconds)
    if sys.platform == "linux":
        import ctypes

        ctypes.CDLL(None).prctl(PR_SET_PDEATHSIG, signal.SIGKILL)
        if os.getppid() != parent:  # it has ended already
            os._exit(1)
