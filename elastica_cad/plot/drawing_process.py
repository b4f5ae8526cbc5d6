"""Drawing of pictures in a second process, which imports matplotlib while the command computes.

Importing matplotlib takes as long as computing a strip. Without a second process, or if the second process
ends early, pictures are drawn in the first process.
"""

import os
import pickle
import subprocess
import sys
import warnings
from collections.abc import Iterator, Sequence
from contextlib import contextmanager, suppress
from dataclasses import replace
from functools import partial
from importlib.util import find_spec
from pathlib import Path
from tempfile import TemporaryDirectory
from threading import Thread
from typing import IO, TYPE_CHECKING, cast

from elastica_cad._process import python_command
from elastica_cad._text import MADE_BY

if TYPE_CHECKING:
    from elastica_cad.formats.write_files import File


PICTURES = (".png", ".pdf")
"""Suffixes of the files that the second process draws."""


class DrawingProcess:
    """Second process, which imports matplotlib while the command computes, and then draws the command's pictures.

    The constructor starts the process, and `end` kills it.

    Raises
    ------
    OSError
        The system does not start a process.
    """

    def __init__(self) -> None:
        self._process = subprocess.Popen(
            python_command("elastica_cad.plot.drawing_process", "serve"),
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            # Ctrl-C reaches only this process, which then ends the second process
            start_new_session=True,
            creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0),
        )
        self._input = cast(IO[bytes], self._process.stdin)
        self._output = cast(IO[bytes], self._process.stdout)
        self._folder = TemporaryDirectory()

    @property
    def pid(self) -> int:
        """Process number of the second process."""
        return self._process.pid

    @contextmanager
    def drawing(self, files: "Sequence[File]") -> "Iterator[Sequence[File]]":
        """Let the second process draw the pictures among `files`, which the `with` block writes.

        Yields the files in the order of writing. Pictures follow other files, because they are drawn meanwhile.
        Archives are last, because they contain the other files. Writing a picture waits for the second process.
        If the second process has ended, the first process draws the picture.
        """
        pictures = [file for file in files if file.name.endswith(PICTURES)]
        tasks = [(Path(self._folder.name, Path(file.name).name), file.write) for file in pictures]
        # use a thread, because the second process reads the request only after importing matplotlib
        Thread(target=self._send, args=(pickle.dumps((MADE_BY.get(), tasks)),), daemon=True).start()
        try:
            yield [
                replace(file, write=partial(self._receive, file)) if file in pictures else file
                for file in in_writing_order(files)
            ]
        except BaseException:
            self.end()
            raise

    def end(self) -> None:
        """Kill the second process."""
        self._process.kill()
        self._process.wait()
        for pipe in (self._input, self._output):
            with suppress(OSError):  # closing the pipe fails if the process has not read a request
                pipe.close()
        self._folder.cleanup()

    def _send(self, request: bytes) -> None:
        with suppress(OSError, ValueError):  # the process may have ended
            self._input.write(request)
            self._input.flush()

    def _receive(self, file: "File", path: Path) -> None:
        try:
            content = pickle.load(self._output)
        except (
            EOFError,
            OSError,
            ValueError,
            pickle.UnpicklingError,
        ):  # the second process has ended, so draw the picture here
            file.write(path)
        else:
            path.write_bytes(content)


def in_writing_order(files: "Sequence[File]") -> "list[File]":
    """Return the files with pictures after other files, and archives last."""
    return sorted(files, key=lambda file: (file.name.endswith(".zip"), file.name.endswith(PICTURES)))


@contextmanager
def drawing_process(words: Sequence[str]) -> Iterator[DrawingProcess | None]:
    """Start the second process for a command that draws pictures, and end it after the `with` block.

    Yields None if the command draws no pictures, matplotlib is not installed, there is only one processor, or
    the system cannot start a process.
    """
    draws = {"strip", "pair", "model"} & {*words} and not {"--no-pictures", "--help", "-h"} & {*words}
    processors = len(os.sched_getaffinity(0)) if hasattr(os, "sched_getaffinity") else os.cpu_count() or 1
    process = None
    if draws and processors > 1 and find_spec("matplotlib") is not None:
        with suppress(OSError):
            process = DrawingProcess()
    try:
        yield process
    finally:
        if process is not None:
            process.end()


def serve() -> None:
    """Run the second process: import the drawing functions, then draw the pictures requested by standard
    input.
    """
    warnings.simplefilter("ignore")
    import matplotlib.backends.backend_agg
    import matplotlib.figure  # noqa: F401
    from PIL import Image

    import elastica_cad.plot.strip_pictures  # noqa: F401

    Image.preinit()
    with suppress(EOFError):  # the command has ended
        while True:
            command, pictures = pickle.load(sys.stdin.buffer)
            MADE_BY.set(command)
            for path, draw in pictures:
                draw(path)
                pickle.dump(path.read_bytes(), sys.stdout.buffer)
                sys.stdout.buffer.flush()
                path.unlink()
