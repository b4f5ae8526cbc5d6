"""How often this process looks for cycles of objects that refer to each other."""

import gc
from collections.abc import Iterator
from contextlib import contextmanager

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
