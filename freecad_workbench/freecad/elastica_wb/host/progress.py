# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Work that may take long: in a thread of its own, with a progress bar that can be cancelled."""

import time
from collections.abc import Callable, Sequence
from concurrent.futures import Future, ThreadPoolExecutor
from typing import Any, TypeVar

import FreeCAD as App

from elastica_cad.errors import NotConvergedError

__all__ = ["Step", "begun", "go_on", "in_steps", "patiently"]

Step = Callable[[int], bool]
"""Told how much is done; says whether to go on."""

Answer, Item = TypeVar("Answer"), TypeVar("Item")

QUIET_S = 0.5  # s before anything is shown
PULSE_S = 0.02  # s

_workers = ThreadPoolExecutor(max_workers=2, thread_name_prefix="elastica")


def begun(work: Callable[..., Answer], *arguments: Any) -> "Future[Answer]":
    """Start work beside the window; ask the future for its answer later."""
    return _workers.submit(work, *arguments)


def patiently(title: str, work: Callable[..., Answer], *arguments: Any) -> Answer:
    """The answer of work that may take seconds; after half a second the user can cancel.

    Raises
    ------
    NotConvergedError
        The user cancelled.
    """
    if not App.GuiUp:
        return work(*arguments)
    future = begun(work, *arguments)
    end = time.monotonic() + QUIET_S
    while not future.done() and time.monotonic() < end:
        time.sleep(PULSE_S / 10)
    if not future.done():
        _wait_with_bar(title, future)
    return future.result()


def _wait_with_bar(title: str, future: "Future[Any]") -> None:
    import FreeCADGui as Gui
    from freecad.elastica_wb.host.qt import QtCore, QtWidgets
    from freecad.elastica_wb.host.resources import tr

    bar = QtWidgets.QProgressDialog(tr(title), tr("Cancel"), 0, 0, Gui.getMainWindow())
    bar.setWindowModality(QtCore.Qt.WindowModal)
    bar.setMinimumDuration(0)
    bar.show()
    try:
        while not future.done():
            QtWidgets.QApplication.processEvents()
            time.sleep(PULSE_S)
            if bar.wasCanceled():
                future.cancel()
                raise NotConvergedError(f"{title}: stopped; change the curve or the limits to try again")
    finally:
        bar.close()


def go_on(step: Step | None, done: int, stopped: str) -> None:
    """Tell how much is done.

    Raises
    ------
    NotConvergedError
        The user said stop; with what that leaves.
    """
    if step is not None and not step(done):
        raise NotConvergedError(f"stopped: {stopped}")


def in_steps(title: str, items: Sequence[Item], work: Callable[[Item], Answer]) -> list[Answer]:
    """The answers of work on many things, one by one in this thread; after half a second the user can cancel.

    Raises
    ------
    NotConvergedError
        The user cancelled.
    """
    if not App.GuiUp or len(items) < 2:
        return [work(item) for item in items]
    import FreeCADGui as Gui
    from freecad.elastica_wb.host.qt import QtCore, QtWidgets
    from freecad.elastica_wb.host.resources import tr

    bar = QtWidgets.QProgressDialog(tr(title), tr("Cancel"), 0, len(items), Gui.getMainWindow())
    bar.setWindowModality(QtCore.Qt.WindowModal)
    bar.setMinimumDuration(int(1000 * QUIET_S))
    answers = []
    try:
        for done, item in enumerate(items):
            bar.setValue(done)
            QtWidgets.QApplication.processEvents()
            if bar.wasCanceled():
                raise NotConvergedError(f"{title}: stopped; recompute to try again")
            answers.append(work(item))
    finally:
        bar.close()
        bar.deleteLater()
    return answers
