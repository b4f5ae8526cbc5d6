"""Damaged files on which OpenCASCADE breaks down: a copy of the program tries them first."""

import os
import signal
import time
from collections.abc import Callable

from elastica_cad._process import begin_copy
from elastica_cad.errors import InputError

LONGEST_S = 120.0
"""Of a trial: no drawing of curves takes so long."""


def try_in_a_copy(task: Callable[[], object]) -> None:
    """Run a task in a copy of this process, where the system makes copies; what it raises is left to the real run.

    Raises
    ------
    InputError
        The copy was ended by the system, or ran too long.
    """
    if not hasattr(os, "fork"):
        return
    copy = begin_copy(task)
    end, pause = time.monotonic() + LONGEST_S, 1e-3
    try:
        while True:
            ended, status = os.waitpid(copy, os.WNOHANG)
            if ended:
                copy = 0
                break
            if time.monotonic() > end:
                raise InputError(
                    f"OpenCASCADE has not read this file within {LONGEST_S:g} s: export its curves alone"
                )
            time.sleep(pause)
            pause = min(2 * pause, 0.05)
    finally:
        if copy:
            os.kill(copy, signal.SIGKILL)
            os.waitpid(copy, 0)
    if os.WIFSIGNALED(status):
        raise InputError("OpenCASCADE breaks down on this file, which is damaged: export it anew")
