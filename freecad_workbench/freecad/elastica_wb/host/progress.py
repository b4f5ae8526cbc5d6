# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Work that may take long: FreeCAD's own progress bar, and Escape stops it."""

import time
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from contextlib import contextmanager
from typing import Any, TypeVar

import FreeCAD as App

from elastica_cad.errors import NotConvergedError
from elastica_cad.refusals import note

Step = Callable[[int], bool]
"""Told how much is done; says whether to go on."""

Answer, Item = TypeVar("Answer"), TypeVar("Item")

QUIET_S = 0.5  # s before anything is shown
PULSE_S = 0.02  # s

_workers = ThreadPoolExecutor(max_workers=2, thread_name_prefix="elastica")


def begun(work: Callable[..., Answer], *arguments: Any) -> "Future[Answer]":
    """Start work in a thread, and return its future."""
    return _workers.submit(work, *arguments)


@contextmanager
def progress(title: str, count: int = 0) -> Iterator[Step]:
    """FreeCAD's progress bar while something of `count` parts is done; its step says False after Escape.

    FreeCAD takes the mouse and the keys meanwhile, here as in a recompute, whose bar this one then is.
    """
    if not App.GuiUp:
        yield lambda _done: True
        return
    import FreeCADGui as Gui
    from freecad.elastica_wb.host.qt import EscapeKey, QtWidgets
    from freecad.elastica_wb.host.resources import translate

    bar, escape, began = App.Base.ProgressIndicator(), EscapeKey(), time.monotonic()
    shown = 0

    def step(done: int) -> bool:
        nonlocal shown
        while shown < done or not count:
            bar.next()
            shown += 1
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
    """The answer of work that may take seconds, in a thread of its own; after half a second the user can stop it.

    Raises
    ------
    NotConvergedError
        The user stopped it.
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
    """Tell how much is done.

    Raises
    ------
    NotConvergedError
        The user said stop; with what that leaves.
    """
    if step is not None and not step(done):
        raise NotConvergedError("stopped: {why}", why=note(stopped))


def in_steps(title: str, items: Sequence[Item], work: Callable[[Item], Answer]) -> list[Answer]:
    """The answers of work on many things, one by one in this thread; the user can stop between them.

    Raises
    ------
    NotConvergedError
        The user stopped it.
    """
    answers = []
    with progress(title, len(items)) as step:
        for done, item in enumerate(items):
            go_on(step, done, "recompute to try again")
            answers.append(work(item))
    return answers
