# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""How features get their view providers and panels: the window, where there is one, registers what makes them."""

from collections.abc import Callable
from typing import Any

_registered: list[tuple[Callable[[Any, str], None], Callable[[Any], Any]]] = []


def register(dresser: Callable[[Any, str], None], panel: Callable[[Any], Any]) -> None:
    """`dresser(view provider, kind)` is told of every new feature; `panel(feature)` makes its panel."""
    _registered[:] = [(dresser, panel)]


def panel_of(obj: Any) -> Any:
    """Return the panel that edits a feature."""
    return _registered[0][1](obj)


def dress(obj: Any, kind: str) -> None:
    """Give a feature the view provider of its kind, where there is a window and it has none yet.

    A file that freecadcmd wrote holds no view providers.
    """
    if _registered and isinstance(getattr(obj.ViewObject, "Proxy", None), (int, type(None))):
        _registered[0][0](obj.ViewObject, kind)
