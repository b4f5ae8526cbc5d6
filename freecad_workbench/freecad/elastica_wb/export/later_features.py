# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""What goes on after a strip in the document, as a pocket or a cut does: no cutting file holds it."""

from collections.abc import Iterator
from typing import Any

from freecad.elastica_wb.curves.copies import BASE, COMPOUND, PATTERNS
from freecad.elastica_wb.features.flat import is_flat
from freecad.elastica_wb.features.pieces import is_cut
from freecad.elastica_wb.host.resources import translate

CHANGED = {
    "Part::Cut": ("Base",),
    "Part::Common": ("Base", "Tool"),
    "Part::Fuse": ("Base", "Tool"),
    "Part::MultiCommon": ("Shapes",),
    "Part::MultiFuse": ("Shapes",),
    "Part::Fillet": ("Base",),
    "Part::Chamfer": ("Base",),
}
"""Where operations of the Part workbench keep what they make into another shape."""

BODY = "PartDesign::Body"

SHOWN_BY = (BODY, BASE, COMPOUND, *PATTERNS)
"""What shows shapes as they are: a change may follow behind it."""


def tell_later_features(obj: Any) -> list[str]:
    """A sentence where features go on after a strip, a model or a plate, or after its flat part."""
    flat = [user for user in obj.InList if is_flat(user)]
    later = list(dict.fromkeys(label for one in (obj, *flat) for label in _later(one)))
    if not later:
        return []
    words = translate(
        "Elastica",
        "{strip} is followed by {later}, which these files leave out: make it in the strip itself "
        "(slots, tabs, holes), or draw it into the files",
    )
    return [words.format(strip=obj.Label, later=", ".join(later))]


def _later(obj: Any) -> Iterator[str]:
    """Labels of the features that make another shape of an object's, those that come first before the others."""
    todo, seen = [obj], {obj}
    while todo:
        one = todo.pop(0)
        for user in one.InList:
            takes = _takes(user, one)
            if user in seen or not (takes or user.TypeId in SHOWN_BY):
                continue
            seen.add(user)
            todo.append(user)
            # the next strip of a body goes on after the one before, too
            if takes and not (is_cut(user) or getattr(user, "Suppressed", False)):
                yield user.Label


def _takes(user: Any, obj: Any) -> bool:
    """Does a feature begin with an object's shape to make another one of it?"""
    if user.TypeId.startswith("PartDesign::") and user.TypeId not in SHOWN_BY:
        return getattr(user, "BaseFeature", None) == obj
    kept = (getattr(user, name) for name in CHANGED.get(user.TypeId, ()))
    return any(obj in one if isinstance(one, list) else obj == one for one in kept)
