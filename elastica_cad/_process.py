"""The process itself: garbage collection and Ctrl-C during imports."""

import gc
import signal
from collections.abc import Iterator
from contextlib import contextmanager
from threading import current_thread, main_thread
from types import FrameType

RARE_COLLECTIONS = (200_000, 20, 20)
"""Thresholds of the garbage collector: a command ends before its cycles matter, a strip makes 100 000 objects."""


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


@contextmanager
def interrupts_held() -> Iterator[None]:
    """Hold back Ctrl-C during the block, and let it take effect behind the block.

    Some libraries catch every exception while they import others, so that Ctrl-C would be lost there.
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
