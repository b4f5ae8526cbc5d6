# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""View providers and panels of features. The graphical interface registers the functions that make them."""

from collections.abc import Callable
from typing import Any

_registered: list[tuple[Callable[[Any, str], None], Callable[[Any], Any]]] = []


def register(dresser: Callable[[Any, str], None], panel: Callable[[Any], Any]) -> None:
    """Register `dresser(view provider, kind)` for new features, and `panel(feature)`, which makes a panel."""
    _registered[:] = [(dresser, panel)]


def panel_of(obj: Any) -> Any:
    """Return the panel that edits a feature."""
    return _registered[0][1](obj)


def dress(obj: Any, kind: str) -> None:
    """Give a feature the view provider of its kind, if there is a window and it has no view provider.

    A file that freecadcmd wrote holds no view providers.
    """
    if _registered and isinstance(getattr(obj.ViewObject, "Proxy", None), (int, type(None))):
        _registered[0][0](obj.ViewObject, kind)
