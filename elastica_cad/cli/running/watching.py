"""Remaking when a file changes: the command runs again whenever one of the files that it read is saved."""

import time
from collections.abc import Callable
from pathlib import Path

from elastica_cad.errors import InputError
from elastica_cad.formats.file_access.source_file import FileMark, mark_file, note_reads

LOOK_S = 0.2
"""Between two looks at the files: soon enough for people, nothing for the machine."""

GONE_LOOKS = 5
"""How long a file may be gone while a program replaces it."""


def remake_on_change(make: Callable[[], None], tell: Callable[[str], None]) -> None:
    """Run `make`, and again after every change of a file that it read, until the user interrupts.

    Files that programs replace, or are still writing, are waited for; changes while `make` runs count too.

    Raises
    ------
    InputError
        It read no file.
    """
    try:
        while True:
            with note_reads() as read:
                make()
            if not read:
                raise InputError("there is nothing to watch: no file was read")
            tell(f"watching {', '.join(path.name for path in read)}: save to run again, Ctrl-C to end")
            _wait_for_change(read)
    except KeyboardInterrupt:
        tell("no longer watching")


def _wait_for_change(read: dict[Path, FileMark]) -> None:
    """Until a file is another than the one that was read, and all are at rest."""
    before, still = read, 0
    while True:
        time.sleep(LOOK_S)
        now = {path: mark_file(path) for path in read}
        still = still + 1 if now == before else 0
        gone = any(was and not mark for mark, was in zip(now.values(), read.values(), strict=True))
        if now != read and still >= (GONE_LOOKS if gone else 1):
            return
        before = now
