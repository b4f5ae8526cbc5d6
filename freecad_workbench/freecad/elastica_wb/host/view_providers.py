# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""How features get their view providers: the window, where there is one, registers what makes them."""

from collections.abc import Callable
from typing import Any

__all__ = ["dress", "register"]

_dressers: list[Callable[[Any, str], None]] = []


def register(dresser: Callable[[Any, str], None]) -> None:
    """`dresser(view provider, kind)` is told of every new feature."""
    _dressers[:] = [dresser]


def dress(obj: Any, kind: str) -> None:
    """Give a feature the view provider of its kind, where there is a window and it has none yet.

    A file that freecadcmd wrote holds no view providers.
    """
    if _dressers and isinstance(getattr(obj.ViewObject, "Proxy", None), (int, type(None))):
        _dressers[0](obj.ViewObject, kind)
