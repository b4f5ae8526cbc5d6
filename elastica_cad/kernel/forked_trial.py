"""Damaged files on which OpenCASCADE breaks down: a copy of the program tries them first."""

import os
from collections.abc import Callable

from elastica_cad._process import await_copy, begin_copy
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
    status = await_copy(begin_copy(task), LONGEST_S)
    if status is None:
        raise InputError(
            f"OpenCASCADE has not read this file within {LONGEST_S:g} s: export its curves alone"
        )
    if os.WIFSIGNALED(status):
        raise InputError("OpenCASCADE breaks down on this file, which is damaged: export it anew")
