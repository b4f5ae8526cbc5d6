# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Long computations with a progress bar, which the Escape key stops."""

import time
from collections.abc import Callable, Iterator
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import contextmanager
from typing import Any, TypeVar

import FreeCAD as App

from elastica_cad.errors import NotConvergedError, note

Step = Callable[[int], bool]
"""Function that receives the number of finished parts of the work, and returns False if the user stops
the work."""

Answer = TypeVar("Answer")

# time, s, before the progress bar appears
QUIET_S = 0.5
# time, s, between checks whether the work has ended
PULSE_S = 0.02

_workers = ThreadPoolExecutor(max_workers=2, thread_name_prefix="elastica")


def begun(work: Callable[..., Answer], *arguments: Any) -> "Future[Answer]":
    """Start a function in another thread and return its future."""
    return _workers.submit(work, *arguments)


@contextmanager
def progress(title: str, count: int = 0) -> Iterator[Step]:
    """Show a progress bar for work of `count` parts, or of unknown length if `count` is 0.

    The yielded `Step` returns False after the Escape key. FreeCAD blocks mouse and keyboard
    meanwhile. The bar replaces the progress bar of a recompute.
    """
    if not App.GuiUp:
        yield lambda _done: True
        return
    import FreeCADGui as Gui
    from freecad.elastica_wb.host.qt import EscapeKey, QtWidgets
    from freecad.elastica_wb.host.resources import translate

    bar, escape, began = App.Base.ProgressIndicator(), EscapeKey(), time.monotonic()
    steps = 0

    def step(done: int) -> bool:
        nonlocal steps
        while steps < done or not count:
            bar.next()
            steps += 1
            if not count:
                break
        if not count or time.monotonic() - began > QUIET_S:
            Gui.getMainWindow().statusBar().showMessage(
                f"{translate('Elastica', title)} ({translate('Elastica', 'Escape stops it')})"
            )
        QtWidgets.QApplication.processEvents()
        return not escape.pressed

    bar.start(translate("Elastica", title), count)
    escape.watch()
    try:
        yield step
    finally:
        escape.leave()
        bar.stop()
        Gui.getMainWindow().statusBar().clearMessage()


def in_background(title: str, work: Callable[..., Answer], *arguments: Any) -> Answer:
    """Run a function in another thread and return its result. After half a second the user can stop the
    function.

    Raises
    ------
    NotConvergedError
        The user stopped the work.
    """
    if not App.GuiUp:
        return work(*arguments)
    future = begun(work, *arguments)
    end = time.monotonic() + QUIET_S
    while not future.done() and time.monotonic() < end:
        time.sleep(PULSE_S / 10)
    if not future.done():
        with progress(title) as step:
            while not future.done():
                time.sleep(PULSE_S)
                if not step(0):
                    future.cancel()
                    raise NotConvergedError(
                        "{title}: stopped; change the curve or the limits to try again", title=title
                    )
    return future.result()


def go_on(step: Step | None, done: int, stopped: str) -> None:
    """Report the number of finished parts to `step`.

    Raises
    ------
    NotConvergedError
        The user stopped the work. The message is `stopped`.
    """
    if step is not None and not step(done):
        raise NotConvergedError("stopped: {why}", why=note(stopped))
