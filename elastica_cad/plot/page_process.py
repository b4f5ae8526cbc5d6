"""A page painted in a process beside this one, which loads matplotlib while this one reads and solves.

Loading matplotlib takes longer than making a strip. The process is there for one page: it is handed a record,
gives back a PNG file's bytes, and writes nothing itself. Where it can't be had, or dies, one paints for oneself.
"""

import gc
import os
import pickle
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from importlib.util import find_spec
from threading import Thread
from typing import TYPE_CHECKING, Any, Protocol

from elastica_cad._process import usable_processors

if TYPE_CHECKING:
    from elastica_cad.plot.canvas import Figure

LOOK_S = 0.1
"""Between two looks at whether a page is painted: time limits and Ctrl-C are heeded then."""

_WHOLE = (b"\x89PNG\r\n\x1a\n", b"IEND\xaeB`\x82")
"""How PNG files begin and end."""


class Page(Protocol):
    """A record that can be painted, and pickled."""

    def figure(self) -> "Figure":
        """The page, painted."""


class PageProcess:
    """The process, begun as this is made; use `page_process`.

    Raises
    ------
    OSError
        This system makes none.
    """

    def __init__(self) -> None:
        code = f"import sys; sys.path[:] = {sys.path!r}; from {__name__} import _serve; _serve()"
        apart: dict[str, Any] = {"start_new_session": True}  # Ctrl-C is for this process alone
        if sys.platform == "win32":
            apart = {"creationflags": subprocess.CREATE_NEW_PROCESS_GROUP | subprocess.CREATE_NO_WINDOW}
        self._process = subprocess.Popen(
            [sys.executable, "-c", code],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            **apart,
        )

    @property
    def pid(self) -> int | None:
        """Its number in the system, while it is there."""
        return self._process.pid if self._process.returncode is None else None

    def begin(self, page: Page) -> Callable[[], bytes | None] | None:
        """Hand over the one page it is there for; what waits for its bytes, which are None where it has died.

        None where it has had a page, or has died already.
        """
        pipe, self._process.stdin = self._process.stdin, None
        if pipe is None:
            return None
        try:
            with pipe:
                pickle.dump(page, pipe)
        except OSError:  # nobody reads any more
            return None
        return self._painted

    def end(self) -> None:
        """End it, whatever it does."""
        self._process.kill()
        for pipe in (self._process.stdin, self._process.stdout):
            if pipe is not None:
                with suppress(OSError):
                    pipe.close()
        self._process.wait()

    def _painted(self) -> bytes | None:
        while True:
            try:
                png, _ = self._process.communicate(timeout=LOOK_S)
            except subprocess.TimeoutExpired:
                continue
            begins, ends = _WHOLE
            return bytes(png) if png.startswith(begins) and png.endswith(ends) else None


@contextmanager
def page_process() -> Iterator[PageProcess | None]:
    """The process for the time of the block; None where it would spare nothing or can't be had."""
    frozen = getattr(sys, "frozen", False) or not sys.executable  # that is no Python there
    begun = None
    if not frozen and usable_processors() > 1 and find_spec("matplotlib") is not None:
        with suppress(OSError):
            begun = PageProcess()
    try:
        yield begun
    finally:
        if begun is not None:
            begun.end()


def _serve() -> None:
    """What the process does: load, take a page from standard input, give its PNG file to standard output."""
    gc.disable()
    taken: list[bytes] = []

    def listen() -> None:
        taken.append(sys.stdin.buffer.read())
        if not taken[0]:  # whoever asked is gone, or needs no page
            os._exit(0)

    listener = Thread(target=listen, daemon=True)
    listener.start()
    import matplotlib.backends.backend_agg
    import matplotlib.figure  # noqa: F401
    from PIL import Image

    import elastica_cad.plot.strip_page  # noqa: F401
    from elastica_cad.plot.canvas import draw_png

    Image.preinit()
    listener.join()
    page: Page = pickle.loads(taken[0])  # of its own kind, from the process that began this one
    with suppress(OSError):  # nobody waits any more
        sys.stdout.buffer.write(draw_png(page.figure()))
        sys.stdout.buffer.flush()
    os._exit(0)  # without taking down all that was loaded, while somebody waits
