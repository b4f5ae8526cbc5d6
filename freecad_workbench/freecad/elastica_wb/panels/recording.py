# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""What a macro records of our work: calls and values that can be played again."""

from collections.abc import Callable
from typing import Any

import FreeCAD as App
import FreeCADGui as Gui

import __main__

MADE = "elastica_made"
"""Name, in macros and in the console, of what was made last."""


def recorded(make: Callable[..., Any], *arguments: Any, **options: Any) -> Any:
    """What a function of a module makes, asked for in a line that a macro keeps."""
    Gui.addModule(make.__module__)
    given = [*map(_written, arguments), *(f"{name}={_written(value)}" for name, value in options.items())]
    Gui.doCommand(f"{MADE} = {make.__module__}.{make.__name__}({', '.join(given)})")
    return getattr(__main__, MADE)


def record_value(obj: Any, name: str, value: Any) -> None:
    """Set a property in a line that a macro keeps."""
    Gui.doCommand(f"{_written(obj)}.{name} = {_written(value)}")


def record_recompute(document: Any) -> None:
    """Recompute in a line that a macro keeps."""
    Gui.doCommand(f"{_written(document)}.recompute()")


def _written(value: Any) -> str:
    """An expression that a macro understands."""
    if isinstance(value, App.Document):
        return "App.ActiveDocument" if value is App.ActiveDocument else f"App.getDocument({value.Name!r})"
    if isinstance(value, App.DocumentObject):
        return f"{_written(value.Document)}.getObject({value.Name!r})"
    if isinstance(value, list):
        return f"[{', '.join(map(_written, value))}]"
    if isinstance(value, tuple):
        return f"({''.join(f'{_written(item)}, ' for item in value)})"
    return repr(value)
