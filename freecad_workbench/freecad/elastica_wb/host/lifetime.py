# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Objects and documents that may be gone or not be ours, and what files keep of proxies."""

from typing import Any

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


class Unsaved:
    """A proxy of an object or of a view provider, of which a file keeps the class alone."""

    def dumps(self) -> None:
        """Return None: there is nothing to save."""

    def loads(self, state: Any) -> None:
        """Do nothing: there is nothing to load."""

    __getstate__ = dumps
    __setstate__ = loads
