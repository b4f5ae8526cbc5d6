# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""What links, arrays, clones, images and containers show: the originals, and where each copy of them stands."""

from collections.abc import Iterable, Iterator
from typing import Any

import FreeCAD as App
from freecad.elastica_wb.curves.sketch_curves import container, link_target
from freecad.elastica_wb.host.refusal import is_broken_link, told_of_broken_link

from elastica_cad.errors import InputError

Standing = tuple[Any, App.Placement, bool]
Shown = tuple[Any, App.Matrix]

MIRRORING = "Part::Mirroring"
COMPOUND = "Part::Compound"
BASE = "PartDesign::FeatureBase"
"""What a body begins with that was made from an object outside."""

PATTERNS = tuple(
    f"PartDesign::{kind}"
    for kind in ("Mirrored", "LinearPattern", "PolarPattern", "Scaled", "MultiTransform")
)
"""What repeats features inside a body: one solid with them, or left out where it does not touch."""

COPYING = ("App::Link", "App::LinkGroup", MIRRORING, COMPOUND, BASE, *PATTERNS)
"""Kinds of objects of FreeCAD itself, not made in Python, that may show copies."""

SAME = App.Vector(1, 1, 1)
AXES = (App.Vector(1, 0, 0), App.Vector(0, 1, 0), App.Vector(0, 0, 1))
TURNED_OVER = App.Matrix(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1)
"""z to -z: an image is what is turned over so, moved as it is."""


def copies(obj: Any) -> Iterator[Standing]:
    """The originals that an object shows, each with the place in the document of its shape without its placement.

    An image stands at the place of its original after z -> -z, and says so. A body's pattern is no copy: it is one
    solid with what it repeats.

    Raises
    ------
    InputError
        One of them is shown in another size, or is a link to what is not there.
    """
    for one, place in _copies(obj, _place(obj).toMatrix()):
        is_image = place.determinant() < 0
        yield one, App.Placement(place * TURNED_OVER if is_image else place), is_image


def turned_over(place: App.Placement) -> App.Placement:
    """Return the placement of a body's image under z -> -z, itself turned over in the same way."""
    return App.Placement(TURNED_OVER * place.toMatrix() * TURNED_OVER)


def originals(obj: Any) -> list[Any]:
    """Return the objects that an object shows in the end, each once; an object that is no copy or container is
    itself.
    """
    if obj.TypeId in PATTERNS:
        return repeated(obj)
    parts = _parts(obj)
    if parts is None:
        return [obj]
    return list(dict.fromkeys(one for part, _ in parts for one in originals(part)))


def repeated(obj: Any) -> list[Any]:
    """Return the features that a body's pattern repeats; none for all other objects."""
    if obj.TypeId not in PATTERNS or getattr(obj, "Suppressed", False):
        return []
    return list(obj.Originals or filter(None, [obj.BaseFeature]))  # newer releases repeat all before it, too


def contents(obj: Any) -> list[Any]:
    """An object, or what is inside a container: what else shows copies stays as it is."""
    return [one for one, _ in _inside(obj)] if _is_container(obj) else [obj]


def not_repeated(objects: Iterable[Any]) -> list[Any]:
    """Objects but those that others among them show in their place: what arrays of Draft and bodies are based on,
    strips of models, what Part's compounds hold.
    """
    objects = list(objects)
    shown = [one.Base for one in objects if _is_draft(one, "Array")]
    shown += [one.BaseFeature for one in objects if one.TypeId == BASE]
    shown += [held for one in objects if one.TypeId == COMPOUND for held in one.Links]
    shown += [strip for one in objects for strip in getattr(one, "Strips", ())]
    return [one for one in objects if one not in shown]


def _copies(obj: Any, place: App.Matrix) -> Iterator[Shown]:
    parts = _parts(obj)
    if parts is None:
        if is_broken_link(obj):
            raise InputError(told_of_broken_link(obj))
        yield obj, place
        return
    if _size(obj) != SAME:
        raise InputError(
            "{object} is scaled, and a strip of another size bends otherwise: set its Scale to 1",
            object=obj.Label,
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


def _parts(obj: Any) -> list[Shown] | None:
    """What an object shows, each at its place in it; None where that is itself."""
    if obj.TypeId == MIRRORING:
        return [(obj.Source, _mirror(obj) * _own(obj.Source).toMatrix())] if obj.Source else None
    placed = _placed_parts(obj)
    return None if placed is None else [(one, where.toMatrix()) for one, where in placed]


def _mirror(obj: Any) -> App.Matrix:
    """The mirror of a `Part::Mirroring`, before its own placement."""
    normal = App.Vector(obj.Normal).normalize()
    rows = [axis - normal * (2 * normal.dot(axis)) for axis in AXES]
    shift = normal * (2 * normal.dot(obj.Base))
    numbers = [(*row, moved) for row, moved in zip(rows, shift, strict=True)]
    return App.Matrix(*(number for row in numbers for number in row), 0, 0, 0, 1)


def _placed_parts(obj: Any) -> list[tuple[Any, App.Placement]] | None:
    """What an object shows as it is, not mirrored."""
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
    if obj.TypeId == COMPOUND:
        return [(one, _own(one)) for one in obj.Links]
    if obj.TypeId == BASE:
        return [(obj.BaseFeature, App.Placement())] if obj.BaseFeature else None
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


def _inside(group: Any) -> list[tuple[Any, App.Placement]]:
    """What is in a container and in those in it, each at its place there."""
    found: list[tuple[Any, App.Placement]] = []
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
