"""Properties as a table: added where missing, so that files of earlier versions gain the later ones."""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from typing import Any

__all__ = ["Property", "ensure", "put"]

OUTPUT = 8  # Prop_Output: a change does not ask for a recompute


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


def ensure(obj: Any, table: Iterable[Property], defaults: Mapping[str, Any] | None = None) -> None:
    """Add the properties that are missing and set how the editor shows them."""
    given = defaults or {}
    for entry in table:
        if entry.name not in obj.PropertiesList:
            obj.addProperty(
                f"App::Property{entry.kind}",
                entry.name,
                entry.group,
                entry.help,
                OUTPUT if entry.result else 0,
            )
            if entry.default is not None:
                setattr(obj, entry.name, entry.default)
            if entry.name in given:
                setattr(obj, entry.name, given[entry.name])
        obj.setEditorMode(entry.name, (1 if entry.result else 0) | (2 if entry.hidden else 0))


def put(obj: Any, **values: Any) -> None:
    """Set the properties whose value differs: an unchanged result leaves no trace in the undo history."""
    for name, value in values.items():
        present = getattr(obj, name)
        if getattr(present, "Value", present) != value:
            setattr(obj, name, value)
