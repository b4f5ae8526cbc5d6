# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Objects and documents that the user may have deleted or closed meanwhile."""

from typing import Any

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
