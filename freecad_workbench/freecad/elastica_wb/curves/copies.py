# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Originals of links, arrays, clones, mirror images and containers, with the placement of every copy."""

from collections.abc import Iterable, Iterator
from typing import Any

import FreeCAD as App
from freecad.elastica_wb.curves.sketch_curves import container, link_target
from freecad.elastica_wb.host.refusal import broken_link_message, is_broken_link

from elastica_cad.errors import FieldName, InputError

Standing = tuple[Any, App.Placement, bool]
Shown = tuple[Any, App.Matrix]

MIRRORING = "Part::Mirroring"
COMPOUND = "Part::Compound"
BASE = "PartDesign::FeatureBase"
"""Type of the first feature of a body, if the body was made from another object."""

PATTERNS = tuple(
    f"PartDesign::{kind}"
    for kind in ("Mirrored", "LinearPattern", "PolarPattern", "Scaled", "MultiTransform")
)
"""Types that repeat features inside a body. Only copies that touch the solid are fused to it."""

COPYING = ("App::Link", "App::LinkGroup", MIRRORING, COMPOUND, BASE, *PATTERNS)
"""Built-in types of FreeCAD that display copies of other objects."""

MEMBERS = {"App::LinkGroup": "ElementList", COMPOUND: "Links"}
"""Names of the properties with the members of groups, by type."""

SAME = App.Vector(1, 1, 1)
AXES = (App.Vector(1, 0, 0), App.Vector(0, 1, 0), App.Vector(0, 0, 1))
TURNED_OVER = App.Matrix(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1)
"""Matrix that maps z to -z. A mirror image is made by this matrix and then moved."""


def copies(obj: Any) -> Iterator[Standing]:
    """Yield each copy that an object displays: its original, its placement, and True for a mirror image.

    The placement, in document coordinates, replaces the original's placement. A mirror image is mapped from z
    to -z before it is placed. Patterns in a body yield no copies, because they form a single solid with their
    originals.

    Raises
    ------
    InputError
        An original is scaled, or a link is broken.
    """
    for original, place in _copies(obj, _place(obj).toMatrix()):
        is_image = place.determinant() < 0
        yield original, App.Placement(place * TURNED_OVER if is_image else place), is_image


def turned_over(place: App.Placement) -> App.Placement:
    """Mirror the placement of a body in the plane z = 0.

    The shape of the body must also be mapped from z to -z.
    """
    return App.Placement(TURNED_OVER * place.toMatrix() * TURNED_OVER)


def originals(obj: Any) -> list[Any]:
    """Return the originals that an object displays. An object without originals is its own original."""
    if obj.TypeId in PATTERNS:
        return repeated(obj)
    parts = _parts(obj)
    if parts is None:
        return [obj]
    return list(dict.fromkeys(original for part, _ in parts for original in originals(part)))


def repeated(obj: Any) -> list[Any]:
    """Return the features that a pattern of a body repeats, or [] for other objects."""
    if obj.TypeId not in PATTERNS or getattr(obj, "Suppressed", False):
        return []
    # a pattern without originals repeats the preceding feature in FreeCAD 1.x
    return list(obj.Originals or filter(None, [obj.BaseFeature]))


def contents(obj: Any) -> list[Any]:
    """Return the objects inside a container, or the object if it is not a container."""
    return [content for content, _ in _inside(obj)] if _is_container(obj) else [obj]


def not_repeated(objects: Iterable[Any]) -> list[Any]:
    """Remove objects that another object of the list displays.

    Examples are the originals of Draft arrays and bodies, the strips of models, and the members of Part
    compounds.
    """
    objects = list(objects)
    repeated_shapes = [item.Base for item in objects if _is_draft(item, "Array")]
    repeated_shapes += [item.BaseFeature for item in objects if item.TypeId == BASE]
    repeated_shapes += [member for item in objects if item.TypeId == COMPOUND for member in item.Links]
    repeated_shapes += [strip for item in objects for strip in getattr(item, "Strips", ())]
    return [item for item in objects if item not in repeated_shapes]


def _copies(obj: Any, place: App.Matrix) -> Iterator[Shown]:
    parts = _parts(obj)
    if parts is None:
        if is_broken_link(obj):
            raise InputError(broken_link_message(obj))
        yield obj, place
        return
    if _size(obj) != SAME:
        raise InputError(
            "{object} is scaled, but a strip of another size bends differently. Set {box} to 1.",
            object=obj.Label,
            box=FieldName("Scale"),
        )
    for part, where in parts:
        yield from _copies(part, place * where)


def _place(obj: Any) -> App.Placement:
    if obj.TypeId == "App::LinkElement":
        array = next(user for user in obj.InList if obj in getattr(user, "ElementList", ()))
        return _place(array) * obj.Placement
    return container(obj) * _placement_of(obj)


def _placement_of(obj: Any) -> App.Placement:
    return getattr(obj, "Placement", App.Placement())


def _parts(obj: Any) -> list[Shown] | None:
    if obj.TypeId == MIRRORING:
        return [(obj.Source, _mirror(obj) * _placement_of(obj.Source).toMatrix())] if obj.Source else None
    placed = _placed_parts(obj)
    return None if placed is None else [(part, where.toMatrix()) for part, where in placed]


def _mirror(obj: Any) -> App.Matrix:
    normal = App.Vector(obj.Normal).normalize()
    rows = [axis - normal * (2 * normal.dot(axis)) for axis in AXES]
    shift = normal * (2 * normal.dot(obj.Base))
    numbers = [(*row, moved) for row, moved in zip(rows, shift, strict=True)]
    return App.Matrix(*(number for row in numbers for number in row), 0, 0, 0, 1)


def _placed_parts(obj: Any) -> list[tuple[Any, App.Placement]] | None:
    if _is_container(obj):
        inside = _inside(obj)
        single = not_repeated(part for part, _ in inside)
        return [(part, where) for part, where in inside if part in single]
    is_clone = _is_draft(obj, "Clone")
    if is_clone and len(obj.Objects) == 1:  # such a clone ignores the placement of the original
        return [(obj.Objects[0], App.Placement())]
    members = "Objects" if is_clone else MEMBERS.get(obj.TypeId)
    if members is not None:
        return [(part, _placement_of(part)) for part in getattr(obj, members)]
    if obj.TypeId == BASE:
        return [(obj.BaseFeature, App.Placement())] if obj.BaseFeature else None
    is_array = _is_draft(obj, "Array")
    target = obj.Base if is_array else link_target(obj)
    if target is None:
        return None
    if is_array and not hasattr(obj, "LinkTransform"):  # an array without links stores copies of the shape
        inner = obj.Placement.inverse()
        return [(target, inner * part.Placement) for part in obj.Shape.childShapes()]
    inner_place = target.Placement if obj.LinkTransform else App.Placement()
    elements = [part.Placement for part in getattr(obj, "ElementList", ())]
    places = elements or getattr(obj, "PlacementList", ()) or [App.Placement()]
    return [(target, place * inner_place) for place in places]


def _inside(group: Any) -> list[tuple[Any, App.Placement]]:
    contained: list[tuple[Any, App.Placement]] = []
    for child in group.Group:
        place = _placement_of(child)
        contained += (
            [(content, place * where) for content, where in _inside(child)]
            if _is_container(child)
            else [(child, place)]
        )
    return contained


def _size(obj: Any) -> App.Vector:
    if _is_draft(obj, "Clone"):
        return obj.Scale
    return obj.ScaleVector * obj.Scale if hasattr(obj, "ScaleVector") else SAME


def _is_container(obj: Any) -> bool:
    return bool(obj.hasExtension("App::GroupExtension"))


def _is_draft(obj: Any, kind: str) -> bool:
    """Return True if the type of a Draft object ends in `kind`: "Array" includes "PathArray"."""
    type_name = getattr(getattr(obj, "Proxy", None), "Type", None)
    return isinstance(type_name, str) and type_name.endswith(kind)
