# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Features and documents: whether they exist, their proxies and view providers, and sensors without references."""

from collections.abc import Callable
from typing import Any
from weakref import WeakMethod

import FreeCAD as App

FEATURES = "freecad.elastica_wb.features."

view_providers: dict[str, Callable[[Any], Any]] = {}
"""Makers of view providers by kind of feature. The graphical interface fills it."""


def lives(obj: Any) -> bool:
    """Return True if an object is in its document. Objects that only the undo history holds do not count."""
    try:
        return obj.Document is not None and obj in obj.Document.Objects
    except (ReferenceError, RuntimeError):
        return False


def is_ours(obj: Any) -> bool:
    """Return True if an object is a feature of this workbench. No feature module is imported for this."""
    return type(getattr(obj, "Proxy", None)).__module__.startswith(FEATURES)


def document_lives(document: Any) -> bool:
    """Return True if a document is open."""
    try:
        return document.Name in App.listDocuments()
    except (ReferenceError, RuntimeError):
        return False


def sensor(kind: Any, told: Callable[..., None]) -> Any:
    """Return a Coin sensor that calls a method only as long as the method's object is referenced elsewhere.

    pivy never releases the function that a sensor calls. A card and its widgets would stay in memory, and PySide
    would reuse their wrappers for new widgets at the same addresses.
    """
    method = WeakMethod(told)

    def tell(*_: Any) -> None:
        call = method()
        if call is not None:
            call()

    return kind(tell, None)


class Unsaved:
    """A proxy of an object or a view provider. A file stores only its class."""

    def dumps(self) -> None:
        """Return None: there is nothing to save."""

    def loads(self, state: Any) -> None:
        """Do nothing: there is nothing to load."""

    __getstate__ = dumps
    __setstate__ = loads


def dress(obj: Any, kind: str) -> None:
    """Give a feature the view provider of its kind, if there is a window and it has no view provider.

    A file that freecadcmd wrote holds no view providers.
    """
    if kind in view_providers and isinstance(getattr(obj.ViewObject, "Proxy", None), (int, type(None))):
        view_providers[kind](obj.ViewObject)
