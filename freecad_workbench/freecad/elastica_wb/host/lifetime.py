# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Objects and documents that the user may have deleted or closed meanwhile; sensors that keep nothing alive."""

from collections.abc import Callable
from typing import Any
from weakref import WeakMethod

import FreeCAD as App


def lives(obj: Any) -> bool:
    """Is it still in its document? What the undo history keeps is not."""
    try:
        return obj.Document is not None and obj in obj.Document.Objects
    except (ReferenceError, RuntimeError):
        return False


def document_lives(document: Any) -> bool:
    """Is it still open?"""
    try:
        return document.Name in App.listDocuments()
    except (ReferenceError, RuntimeError):
        return False


def sensor(kind: Any, told: Callable[..., None]) -> Any:
    """A sensor of Coin that calls a method for as long as its object is used elsewhere.

    pivy never lets go of what a sensor calls: with it a card and its widgets would stay in memory, and PySide would
    take their faces for those of the next widgets at their addresses.
    """
    method = WeakMethod(told)

    def tell(*_: Any) -> None:
        call = method()
        if call is not None:
            call()

    return kind(tell, None)
