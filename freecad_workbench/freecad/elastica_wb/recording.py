# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Recording of actions in macros: function calls and values of properties."""

from collections.abc import Callable
from typing import Any

import FreeCAD as App
import FreeCADGui as Gui

import __main__
from elastica_cad.geometry.plane_curve import PlaneCurve

MADE = "elastica_made"
"""Name of the last result in macros and in the console."""


def recorded(make: Callable[..., Any], *arguments: Any, **options: Any) -> Any:
    """Call a function by a Python line that macros record, and return its result."""
    # Gui.addModule does not record modules that are already loaded
    Gui.doCommand(f"import {make.__module__}")
    if any(isinstance(argument, PlaneCurve) for argument in arguments):
        Gui.doCommand("import elastica_cad")
    arguments_text = [
        *map(_expression, arguments),
        *(f"{name}={_expression(value)}" for name, value in options.items()),
    ]
    Gui.doCommand(f"{MADE} = {make.__module__}.{make.__name__}({', '.join(arguments_text)})")
    return getattr(__main__, MADE)


def record_value(obj: Any, name: str, value: Any) -> None:
    """Set a property by a Python line that macros record."""
    Gui.doCommand(f"{_expression(obj)}.{name} = {_expression(value)}")


def record_call(obj: Any, method: str, *arguments: Any) -> None:
    """Call a method of a document or of an object by a Python line that macros record."""
    Gui.doCommand(f"{_expression(obj)}.{method}({', '.join(map(_expression, arguments))})")


def record_recompute(document: Any) -> None:
    """Recompute a document by a Python line that macros record."""
    record_call(document, "recompute")


def _expression(value: Any) -> str:
    if isinstance(value, App.Document):
        return "App.ActiveDocument" if value is App.ActiveDocument else f"App.getDocument({value.Name!r})"
    if isinstance(value, App.DocumentObject):
        return f"{_expression(value.Document)}.getObject({value.Name!r})"
    if isinstance(value, PlaneCurve):
        weights = None if value.weights is None else value.weights.tolist()
        numbers = (value.knots.tolist(), value.control_points.tolist(), value.degree, weights)
        return f"elastica_cad.PlaneCurve{numbers!r}"
    if isinstance(value, list):
        return f"[{', '.join(map(_expression, value))}]"
    if isinstance(value, tuple):
        return f"({''.join(f'{_expression(item)}, ' for item in value)})"
    return repr(value)
