# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Pieces to be cut: one for every layer of a strip, every plate and every two-state part.

Later features of the document, such as a pocket or a cut, are not included.
"""

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import zip_longest
from typing import Any

from freecad.elastica_wb.curves.copies import BASE, COMPOUND, PATTERNS, not_repeated
from freecad.elastica_wb.features.baseplate import plates_of
from freecad.elastica_wb.features.flexure import flexure_of
from freecad.elastica_wb.features.model import model_of
from freecad.elastica_wb.features.proxy import why_skipped
from freecad.elastica_wb.features.strip import shown_strips, strip_of
from freecad.elastica_wb.host.objects import is_flat, is_flexure, is_model, is_plate, is_strip
from freecad.elastica_wb.host.refusal import FAILURES, explained
from freecad.elastica_wb.host.resources import translate
from freecad.elastica_wb.solving.verdicts import pre_bend_messages

from elastica_cad._text import distinct
from elastica_cad.errors import InputError, note, sentences
from elastica_cad.model.plates import numbered
from elastica_cad.strip.pieces import Piece, count_pieces
from elastica_cad.strip.strip import Placed, Strip, require_placed

CHANGED = {
    "Part::Cut": ("Base",),
    "Part::Common": ("Base", "Tool"),
    "Part::Fuse": ("Base", "Tool"),
    "Part::MultiCommon": ("Shapes",),
    "Part::MultiFuse": ("Shapes",),
    "Part::Fillet": ("Base",),
    "Part::Chamfer": ("Base",),
}
"""Names of the properties that contain the objects which an operation of the Part workbench changes."""

BODY = "PartDesign::Body"

SHOWN_BY = (BODY, BASE, COMPOUND, *PATTERNS)
"""Types that display the shape of another object unchanged. A later feature may change such an object
instead of the original."""


@dataclass(frozen=True)
class Cut:
    """A piece and its strip, which is None for a plate."""

    piece: Piece
    strip: Strip | None = None


def pre_bend_messages_of(cuts: Iterable[Cut]) -> list[str]:
    """Return instructions for pieces that must be pre-bent. Pieces with equal pre-bends share an instruction."""
    return pre_bend_messages((cut.piece.name, cut.strip) for cut in cuts if cut.strip is not None)


def cuts_of(sources: Iterable[Any]) -> list[Cut]:
    """Return the pieces to be cut for strips, models and base plates, including all copies.

    A selected strip is not counted again if its model, array or flat part is also selected.

    Raises
    ------
    InputError
        The sources contain nothing to cut, or an object that failed.
    """
    counts = counted(sources)
    parts = _numbered_parts(counts)
    cuts = [(cut, count) for obj, count in counts.items() for cut in _cuts(obj, parts)]
    if not cuts:
        raise InputError("there is nothing to cut: select strips, models or base plates")
    names = distinct(cut.piece.name for cut, _ in cuts)
    return [
        Cut(replace(cut.piece, name=name, count=count * cut.piece.count), cut.strip)
        for (cut, count), name in zip(cuts, names, strict=True)
    ]


def without_refused(sources: Iterable[Any]) -> tuple[list[Any], list[str]]:
    """Return the sources that can be cut, and a message on each source that failed.

    Raises
    ------
    InputError
        All sources failed, or a link is broken.
    """
    sources = list(sources)
    counted(sources)
    able, messages = [], []
    for obj in sources:
        try:
            cuts_of([obj])
            able.append(obj)
        except FAILURES as error:
            why = explained(error).refusal
            messages.append(note("{called} is left out: {problem}", called=obj.Label, problem=why))
    if not able:
        raise InputError(sentences(messages, "\n"))
    return able, messages


def counted(sources: Iterable[Any]) -> dict[Any, int]:
    """Return the number of copies of each strip, model and base plate among the sources."""
    standing: Counter[Any] = Counter()
    lying: Counter[Any] = Counter()
    for obj in not_repeated(sources):
        for original, *_ in shown_strips(obj):
            (lying if is_flat(original) else standing)[original] += 1
    counts = {obj: count for obj, count in standing.items() if is_cut(obj)}
    for flat, count in lying.items():
        obj = cut_for(flat)
        counts[obj] = max(count, counts.get(obj, 0))
    return counts


def cut_for(obj: Any) -> Any:
    """Return the object that is cut.

    For a flat part, return the model whose slots the part has, or the strip.
    """
    return (obj.Model or obj.Strip) if is_flat(obj) else obj


def is_cut(obj: Any) -> bool:
    """Return True if this object is a strip, a model, a base plate, rings, or a part with two states."""
    return is_strip(obj) or is_model(obj) or is_plate(obj) or is_flexure(obj)


def _numbered_parts(objects: Iterable[Any]) -> dict[Any, Any]:
    """Return the strips outside models, and the plates and spacers of base plates and rings.

    Their engraved numbers differ from each other and from those in models.
    """
    objects = [obj for obj in objects if not why_skipped(obj)]
    single = [obj for obj in objects if is_strip(obj)]
    in_models = [placed for obj in objects if is_model(obj) for placed in model_of(obj).placed]
    placed = require_placed([*in_models, *(Placed(strip_of(obj)) for obj in single)])
    parts = dict(zip(single, (item.strip for item in placed[len(in_models) :]), strict=True))
    plates = list[Any]()
    for obj in filter(is_plate, objects):
        parts[obj] = numbered(placed, plates_of(obj), plates)
        plates += parts[obj]
    return parts


def _cuts(obj: Any, parts: Mapping[Any, Any]) -> list[Cut]:
    lost = why_skipped(obj)
    if lost:
        raise InputError(lost)
    if is_model(obj):
        model = model_of(obj)
        strips = [part.strip for part in model.parts for _ in part.strip.layers]
        return [Cut(*fields) for fields in zip_longest(model.pieces, strips)]
    if is_plate(obj):
        return [Cut(piece) for piece in count_pieces(plate.piece for plate in parts[obj])]
    name = obj.EngravedText or obj.Label
    if is_flexure(obj):
        part = flexure_of(obj)
        drawings = {name: part.drawing(), f"{name} {translate('Elastica', 'holder')}": part.holder()}
        return [
            Cut(Piece(called, replace(drawing, name=called), part.sheet, obj.Quantity))
            for called, drawing in drawings.items()
        ]
    strip = parts[obj]
    cuts = []
    for layer, plain in zip(strip.layers, strip.drawings(), strict=False):
        drawing = replace(plain, name=layer.called(name))
        piece = Piece(drawing.name, drawing, layer.sheet, obj.Quantity, number=strip.number)
        cuts.append(Cut(piece, strip))
    return cuts


def later_features(obj: Any) -> str:
    """Return the labels of later features that change an object to be cut, or its flat part."""
    flat = [user for user in obj.InList if is_flat(user)]
    return ", ".join(dict.fromkeys(label for feature in (obj, *flat) for label in _later_labels(feature)))


def _later_labels(obj: Any) -> Iterator[str]:
    todo, visited = [obj], {obj}
    while todo:
        current = todo.pop(0)
        for user in current.InList:
            takes = _changes_shape(user, current)
            if user in visited or not (takes or user.TypeId in SHOWN_BY):
                continue
            visited.add(user)
            todo.append(user)
            # a strip in a body depends on the previous strip, but does not change that strip
            if takes and not (is_cut(user) or getattr(user, "Suppressed", False)):
                yield user.Label


def _changes_shape(user: Any, obj: Any) -> bool:
    if user.TypeId.startswith("PartDesign::") and user.TypeId not in SHOWN_BY:
        return getattr(user, "BaseFeature", None) == obj
    links = (getattr(user, name) for name in CHANGED.get(user.TypeId, ()))
    return any(obj in bases if isinstance(bases, list) else obj == bases for bases in links)
