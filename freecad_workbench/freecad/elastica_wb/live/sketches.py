# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""The open sketch, the strips that follow it, and the state of the overlay that a sketch stores."""

from collections.abc import Callable
from typing import Any

import FreeCAD as App
import FreeCADGui as Gui
from freecad.elastica_wb.host import preferences
from freecad.elastica_wb.host.objects import is_sketch, is_strip, lives
from freecad.elastica_wb.host.qt import when_free

MEMORY = "ElasticaLive"
"""Property of a sketch that stores whether its overlay is on."""

KEEP = "ElasticaKeep"
"""Property of a sketch that stores whether dragging stops where the strip can no longer be made."""

listeners: list[Callable[[bool], None]] = []
"""Functions called with True when an overlay starts, and with False when it ends."""


def edited_sketch() -> Any:
    """Return the sketch that is open for editing, or None."""
    provider = Gui.ActiveDocument.getInEdit() if Gui.ActiveDocument else None
    source = getattr(provider, "Object", None)
    return source if is_sketch(source) else None


def is_sketch_open() -> bool:
    """Return True if a sketch is open for editing."""
    return edited_sketch() is not None


def followers(sketch: Any) -> list[Any]:
    """Return the strips that follow a sketch."""
    return [obj for obj in sketch.InList if is_strip(obj) and obj.Curve and obj.Curve[0] is sketch]


def remember(sketch: Any, on: bool, name: str = MEMORY) -> None:
    """Store a state in a property of the sketch, by default whether the overlay is on."""
    if name not in sketch.PropertiesList:
        words = {
            MEMORY: App.Qt.translate("App::Property", "Show live feedback while this sketch is open"),
            KEEP: App.Qt.translate("App::Property", "Stop dragged poles where the strip can be made"),
        }
        no_recompute = 8
        sketch.addProperty("App::PropertyBool", name, "Elastica", words[name], no_recompute)
    setattr(sketch, name, on)


def wants_overlay(sketch: Any) -> bool:
    """Return True if the overlay of a sketch starts when the sketch is opened.

    This is stored in the sketch. By default, it is True if a strip follows the sketch. If the preference
    LiveMode is off, no overlay starts.
    """
    if not preferences.get("LiveMode"):
        return False
    if MEMORY in sketch.PropertiesList:
        return bool(getattr(sketch, MEMORY))
    return bool(followers(sketch))


def recompute(strips: list[Any]) -> None:
    """Recompute strips and the features that depend on them, but no other objects."""
    alive = [strip for strip in strips if lives(strip)]
    if not alive:
        return
    document = alive[0].Document
    if document.Recomputing:
        when_free(lambda: recompute(alive))
        return
    for strip in alive:
        strip.touch()
    document.recompute(alive)
