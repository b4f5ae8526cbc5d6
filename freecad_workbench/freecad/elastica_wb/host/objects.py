# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Helpers for document objects: existence, kind, proxies, view providers and sensors."""

from collections.abc import Callable
from typing import Any
from weakref import WeakMethod

import FreeCAD as App

FEATURES = "freecad.elastica_wb.features."

view_providers: dict[str, Callable[[Any], Any]] = {}
"""View provider of each kind of feature. The graphical interface fills it in."""


def lives(obj: Any) -> bool:
    """Return True if an object is in its document, not only in the undo history."""
    try:
        return obj.Document is not None and obj in obj.Document.Objects
    except (ReferenceError, RuntimeError):
        return False


def feature_kind(obj: Any) -> str:
    """Return the kind of a feature of this workbench, such as "Strip", or "" for other objects."""
    proxy = type(getattr(obj, "Proxy", None))
    return proxy.__name__.removesuffix("Feature") if proxy.__module__.startswith(FEATURES) else ""


def is_ours(obj: Any) -> bool:
    """Return True if an object is a feature of this workbench."""
    return feature_kind(obj) != ""


def is_strip(obj: Any) -> bool:
    """Return True if an object is a strip."""
    return feature_kind(obj) == "Strip"


def is_model(obj: Any) -> bool:
    """Return True if an object is a model."""
    return feature_kind(obj) == "Model"


def is_flexure(obj: Any) -> bool:
    """Return True if an object is a part with two states."""
    return feature_kind(obj) == "Flexure"


def is_flat(obj: Any) -> bool:
    """Return True if an object is the flat part of a strip."""
    return feature_kind(obj) == "Flat"


def is_plate(obj: Any) -> bool:
    """Return True if an object is a feature of a base plate or of ring plates."""
    return feature_kind(obj) in ("BasePlate", "Rings")


def is_sketch(obj: Any) -> bool:
    """Return True if an object is a sketch."""
    return obj is not None and bool(obj.isDerivedFrom("Sketcher::SketchObject"))


def document_lives(document: Any) -> bool:
    """Return True if a document is open."""
    try:
        return document.Name in App.listDocuments()
    except (ReferenceError, RuntimeError):
        return False


def sensor(kind: Any, callback: Callable[..., None]) -> Any:
    """Return a Coin sensor that calls a method without keeping the object of the method in memory.

    pivy never releases the function that a sensor calls. Without a weak reference, a card and its widgets
    would stay in memory, and PySide would reuse their wrappers for new widgets.
    """
    method = WeakMethod(callback)

    def call_method(*_: Any) -> None:
        call = method()
        if call is not None:
            call()

    return kind(call_method, None)


class Unsaved:
    """Base of proxies of objects and view providers. Files store only the class of a proxy."""

    def dumps(self) -> None:
        """Return None, because a proxy has no data to be saved."""

    def loads(self, state: Any) -> None:
        """Do nothing, because a proxy has no data."""

    __getstate__ = dumps
    __setstate__ = loads


def dress(obj: Any) -> None:
    """Give a feature its view provider, which a file of freecadcmd lacks."""
    make = view_providers.get(feature_kind(obj))
    if make is not None and isinstance(getattr(obj.ViewObject, "Proxy", None), (int, type(None))):
        make(obj.ViewObject)
