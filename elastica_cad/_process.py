"""Handling of Ctrl-C during imports, and the command that starts a second process of this package."""

import signal
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from threading import current_thread, main_thread
from types import FrameType

PACKAGES = Path(__file__).parents[1]
"""Folder that contains this package. `python_command` adds it to `sys.path`, because a new Python process does not
search the folder of a checkout."""


def python_command(module: str, function: str) -> list[str]:
    """Return the command that calls a function of this package in a new Python process.

    Without the option -P, Python would search the working folder for modules first.
    """
    run = f"import sys; sys.path.append({str(PACKAGES)!r}); from {module} import {function}; {function}()"
    return [sys.executable, "-P", "-c", run]


@contextmanager
def interrupts_held() -> Iterator[None]:
    """Delay Ctrl-C until the end of a `with` block.

    Some libraries catch all exceptions during their imports, which would lose Ctrl-C.
    """
    before = signal.getsignal(signal.SIGINT)
    if before is None or current_thread() is not main_thread():
        yield
        return
    pressed: list[int] = []

    def note(number: int, _: FrameType | None) -> None:
        pressed.append(number)

    signal.signal(signal.SIGINT, note)
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, before)
        if pressed:
            signal.raise_signal(signal.SIGINT)
