# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""What must be cut for features: a piece with its drawing for every sheet of a strip, every plate, every part."""

from collections.abc import Iterable
from dataclasses import replace
from typing import Any

from freecad.elastica_wb.features.baseplate import is_base_plate, plate_of
from freecad.elastica_wb.features.model import is_model, model_of
from freecad.elastica_wb.features.strip import is_strip, strip_of

from elastica_cad.errors import InputError
from elastica_cad.fabrication.sheets.pieces import Piece, distinct


def pieces_of(sources: Iterable[Any]) -> list[Piece]:
    """What must be cut for strips, models and base plates; strips of a model that is there too count once.

    Raises
    ------
    InputError
        None of these among the sources, or one of them in error.
    """
    sources = list(sources)
    in_models = [strip for model in sources if is_model(model) for strip in model.Strips]
    pieces: list[Piece] = []
    for obj in sources:
        if is_model(obj):
            pieces += model_of(obj).pieces
        elif is_base_plate(obj):
            pieces.append(replace(plate_of(obj).piece, name=obj.Label))
        elif is_strip(obj) and obj not in in_models:
            pieces += _strip_pieces(obj)
    if not pieces:
        raise InputError("there is nothing to cut: select strips, models or base plates")
    names = distinct(piece.name for piece in pieces)
    return [replace(piece, name=name) for piece, name in zip(pieces, names, strict=True)]


def _strip_pieces(obj: Any) -> list[Piece]:
    strip, name = strip_of(obj), obj.EngravedText or obj.Label
    names = [layer.called(name) for layer in strip.layers]
    return [
        Piece(called, replace(drawing, name=called), layer.sheet, obj.Quantity)
        for called, drawing, layer in zip(names, strip.drawings(), strip.layers, strict=False)
    ]
