# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Undo steps for all versions of FreeCAD, made by lines of Python that recorded macros contain.

Up to FreeCAD 1.1, a transaction belongs to the whole program. From FreeCAD 1.2, a transaction belongs to one
document.
"""

from collections.abc import Callable
from typing import Any

import FreeCAD as App
import FreeCADGui as Gui
from freecad.elastica_wb.recording import record_call


def open_step(document: Any, name: str) -> None:
    """Begin an undo step by a Python line that macros record."""
    record_call(document, "openTransaction", name)


def open_step_and(close_sketch: Callable[[], None], document: Any, name: str) -> None:
    """Begin an undo step, and close the open sketch in it."""
    # open the step first, because FreeCAD names a step "close the sketch" if no step is open
    open_step(document, name)
    close_sketch()
    if not active_step(document):  # FreeCAD 1.2 ends the step when the sketch closes
        open_step(document, name)


def close_step(document: Any, *, abort: bool = False) -> None:
    """End the undo step of a document, or with `abort` undo all its changes."""
    record_call(document, "abortTransaction" if abort else "commitTransaction")
    if not _has_steps_of_documents():
        # a step without changes is still open here, and FreeCAD would add later changes to it
        Gui.doCommand(f"App.closeActiveTransaction({abort})")


def active_step(document: Any) -> int:
    """Return FreeCAD's identifier of the undo step that records changes of a document, or 0."""
    if _has_steps_of_documents():
        return int(App.Document.getBookedTransactionID(document))
    return (App.getActiveTransaction() or ("", 0))[1]


def active_steps() -> dict[str, int]:
    """Return FreeCAD's identifiers of the undo steps of all open documents."""
    steps = {name: active_step(document) for name, document in App.listDocuments().items()}
    return {name: step for name, step in steps.items() if step}


def undo_new_steps(before: dict[str, int]) -> None:
    """Undo the steps that began after `active_steps` returned `before`."""
    for name, document in App.listDocuments().items():
        if active_step(document) not in (0, before.get(name)):
            close_step(document, abort=True)


def forget_step() -> None:
    """Abort the undo step of a closed document, unless FreeCAD has ended this step."""
    if not _has_steps_of_documents():
        App.closeActiveTransaction(True)


def _has_steps_of_documents() -> bool:
    return hasattr(App.Document, "getBookedTransactionID")
