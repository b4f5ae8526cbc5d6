"""Files that are being written, told from those that a killed program has left: a living writer holds a lock."""

import os
import shutil
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from typing import BinaryIO

if sys.platform != "win32":  # there a file that is open cannot be removed
    import fcntl

LOCK = ".lock"
"""The file in a workshop folder that its writer holds."""

YOUNG_S = 60.0
"""A workshop without its lock is left alone so long: its writer may be about to take it."""


@contextmanager
def open_held(path: Path) -> Iterator[BinaryIO]:
    """A new file, open for writing and held until the block ends, even where it closes the file before."""
    with path.open("xb") as file:
        if sys.platform == "win32":
            yield file
            return
        held = os.dup(file.fileno())
        try:
            fcntl.flock(held, fcntl.LOCK_EX)
            yield file
        finally:
            os.close(held)


@contextmanager
def take_turn(folder: Path) -> Iterator[None]:
    """Wait until no other writer moves files into a folder."""
    if sys.platform == "win32":
        yield
    else:
        handle = os.open(folder, os.O_RDONLY)
        try:
            fcntl.flock(handle, fcntl.LOCK_EX)
            yield
        finally:
            os.close(handle)


def remove_left_behind(folder: Path, pattern: str) -> None:
    """Remove files and workshop folders of this pattern whose writers are gone."""
    for path in folder.glob(pattern):
        with suppress(OSError):
            held = path / LOCK if path.is_dir() else path
            if not held.exists():
                if time.time() - path.stat().st_mtime > YOUNG_S:
                    shutil.rmtree(path)
            elif _is_free(held):
                shutil.rmtree(path) if path.is_dir() else path.unlink()


def _is_free(path: Path) -> bool:
    with path.open("r+b") as file:
        if sys.platform != "win32":
            try:
                fcntl.flock(file, fcntl.LOCK_EX | fcntl.LOCK_NB)
            except BlockingIOError:
                return False
        return True
