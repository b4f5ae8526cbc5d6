# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Properties as a table: added where missing, so that files of earlier versions gain the later ones."""

from collections.abc import Iterable
from contextlib import suppress
from dataclasses import dataclass
from typing import Any

import FreeCAD as App

OUTPUT, TRANSIENT = 8, 2  # FreeCAD's flags: a change asks for no recompute; not saved


@dataclass(frozen=True)
class Property:
    """One property of a feature; `default` is a value or, for enumerations, the list of choices."""

    kind: str
    name: str
    group: str
    help: str
    default: Any = None
    result: bool = False
    hidden: bool = False
    transient: bool = False

    @property
    def type_id(self) -> str:
        """FreeCAD's name of its type."""
        return f"App::Property{self.kind}"

    @property
    def translated_help(self) -> str:
        """What it means, in the user's language."""
        return str(App.Qt.translate("App::Property", self.help))


def ensure(obj: Any, table: Iterable[Property]) -> None:
    """Add the properties that are missing, change those whose type was another, set how the editor shows them."""
    for entry in table:
        kept = None
        if entry.name in obj.PropertiesList and obj.getTypeIdOfProperty(entry.name) != entry.type_id:
            kept = getattr(obj, entry.name)
            obj.removeProperty(entry.name)
        if entry.name not in obj.PropertiesList:
            flags = (OUTPUT if entry.result else 0) | (TRANSIENT if entry.transient else 0)
            obj.addProperty(entry.type_id, entry.name, entry.group, entry.translated_help, flags)
            if entry.default is not None:
                setattr(obj, entry.name, entry.default)
            if kept is not None:
                with suppress(TypeError, ValueError):
                    setattr(obj, entry.name, kept)
        obj.setEditorMode(entry.name, (1 if entry.result else 0) | (2 if entry.hidden else 0))


def put(obj: Any, **values: Any) -> None:
    """Set the properties whose value differs: an unchanged result leaves no trace in the undo history."""
    for name, value in values.items():
        present = getattr(obj, name)
        if getattr(present, "Value", present) != value:
            setattr(obj, name, value)
