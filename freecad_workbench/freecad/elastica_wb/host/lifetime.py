# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Objects and documents that may be gone or not be ours, what files keep of proxies, sensors that keep nothing."""

from collections.abc import Callable
from typing import Any
from weakref import WeakMethod

import FreeCAD as App

FEATURES = "freecad.elastica_wb.features."


def lives(obj: Any) -> bool:
    """Is it still in its document? What the undo history keeps is not."""
    try:
        return obj.Document is not None and obj in obj.Document.Objects
    except (ReferenceError, RuntimeError):
        return False


def is_ours(obj: Any) -> bool:
    """Is it a feature of this workbench? Asked without importing what makes them."""
    return type(getattr(obj, "Proxy", None)).__module__.startswith(FEATURES)


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


class Unsaved:
    """A proxy of an object or of a view provider, of which a file keeps the class alone."""

    def dumps(self) -> None:
        """Return None: there is nothing to save."""

    def loads(self, state: Any) -> None:
        """Do nothing: there is nothing to load."""

    __getstate__ = dumps
    __setstate__ = loads
