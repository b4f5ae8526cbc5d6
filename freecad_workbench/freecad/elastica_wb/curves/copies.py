# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""What links, arrays, clones and containers show: the originals, and where each copy of them stands."""

from collections.abc import Iterable, Iterator
from typing import Any

import FreeCAD as App
from freecad.elastica_wb.curves.sketch_curves import container, link_target

from elastica_cad.errors import InputError

Standing = tuple[Any, App.Placement]

SAME = App.Vector(1, 1, 1)


def copies(obj: Any) -> Iterator[Standing]:
    """The originals that an object shows, each with the place in the document of its shape without its placement.

    Raises
    ------
    InputError
        One of them is shown in another size.
    """
    yield from _copies(obj, _place(obj))


def originals(obj: Any) -> list[Any]:
    """What an object shows in the end, each once; everything but links, arrays, clones and containers is itself."""
    parts = _parts(obj)
    if parts is None:
        return [obj]
    return list(dict.fromkeys(one for part, _ in parts for one in originals(part)))


def contents(obj: Any) -> list[Any]:
    """An object, or what is inside a container: what else shows copies stays as it is."""
    return [one for one, _ in _inside(obj)] if _is_container(obj) else [obj]


def not_repeated(objects: Iterable[Any]) -> list[Any]:
    """Objects but those that others among them show in their place: bases of Draft's arrays, strips of models."""
    objects = list(objects)
    shown = [one.Base for one in objects if _is_draft(one, "Array")]
    shown += [strip for one in objects for strip in getattr(one, "Strips", ())]
    return [one for one in objects if one not in shown]


def _copies(obj: Any, place: App.Placement) -> Iterator[Standing]:
    parts = _parts(obj)
    if parts is None:
        yield obj, place
        return
    if _size(obj) != SAME:
        raise InputError(
            f"{obj.Label} is scaled, and a strip of another size bends otherwise: set its Scale to 1"
        )
    for part, where in parts:
        yield from _copies(part, place * where)


def _place(obj: Any) -> App.Placement:
    if obj.TypeId == "App::LinkElement":
        array = next(user for user in obj.InList if obj in getattr(user, "ElementList", ()))
        return _place(array) * obj.Placement
    return container(obj) * _own(obj)


def _own(obj: Any) -> App.Placement:
    return getattr(obj, "Placement", App.Placement())


def _parts(obj: Any) -> list[Standing] | None:
    """What an object shows, each at its place in it; None where that is itself."""
    if _is_container(obj):
        inside = _inside(obj)
        kept = not_repeated(one for one, _ in inside)
        return [(one, where) for one, where in inside if one in kept]
    if _is_draft(obj, "Clone"):
        if len(obj.Objects) == 1:  # it keeps no place of its original
            return [(obj.Objects[0], App.Placement())]
        return [(one, _own(one)) for one in obj.Objects]
    if obj.TypeId == "App::LinkGroup":
        return [(one, _own(one)) for one in obj.ElementList]
    is_array = _is_draft(obj, "Array")
    shown = obj.Base if is_array else link_target(obj)
    if shown is None:
        return None
    if is_array and not hasattr(obj, "LinkTransform"):  # it keeps shapes only
        inner = obj.Placement.inverse()
        return [(shown, inner * one.Placement) for one in obj.Shape.childShapes()]
    own = shown.Placement if obj.LinkTransform else App.Placement()
    elements = [one.Placement for one in getattr(obj, "ElementList", ())]
    places = elements or getattr(obj, "PlacementList", ()) or [App.Placement()]
    return [(shown, place * own) for place in places]


def _inside(group: Any) -> list[Standing]:
    """What is in a container and in those in it, each at its place there."""
    found: list[Standing] = []
    for child in group.Group:
        own = _own(child)
        found += (
            [(one, own * where) for one, where in _inside(child)] if _is_container(child) else [(child, own)]
        )
    return found


def _size(obj: Any) -> App.Vector:
    if _is_draft(obj, "Clone"):
        return obj.Scale
    return obj.ScaleVector * obj.Scale if hasattr(obj, "ScaleVector") else SAME


def _is_container(obj: Any) -> bool:
    return bool(obj.hasExtension("App::GroupExtension"))


def _is_draft(obj: Any, kind: str) -> bool:
    """Is it an array or a clone of FreeCAD's Draft workbench, whose kinds of arrays are `Array`, `PathArray`...?"""
    found = getattr(getattr(obj, "Proxy", None), "Type", None)
    return isinstance(found, str) and found.endswith(kind)
