# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Bodies made of prisms, with their engraving taken out as a few prisms instead of many that overlap."""

from collections.abc import Sequence
from typing import Any

import FreeCAD as App
import numpy as np
import Part
from freecad.elastica_wb.shapes.part_shapes import make_face, make_solid

from elastica_cad.fabrication.solids.prisms import PrismSolid
from elastica_cad.fabrication.solids.strip_solids import FlatSolid

MANY_PRISMS = 4  # prisms on one plane that are put together before they are taken away


def make_block(record: PrismSolid) -> Part.Shape:
    """As `shapes.make_solid`: strokes of letters overlap, and OpenCASCADE unites faces faster than bodies."""
    first, *rest = (make_solid(prism) for prism in record.added)
    whole = first.multiFuse(rest) if rest else first
    holes = [solid for prisms in _on_one_plane(record.removed) for solid in _united(prisms)]
    return whole.cut(holes) if holes else whole


def _on_one_plane(prisms: Sequence[FlatSolid]) -> list[list[FlatSolid]]:
    """The prisms by plane and thickness."""
    groups: dict[Any, list[FlatSolid]] = {}
    for prism in prisms:
        numbers = np.concatenate([prism.frame.origin, *prism.frame.axes[:2], [prism.thickness]])
        groups.setdefault(tuple(numbers.round(9).tolist()), []).append(prism)
    return list(groups.values())


def _united(prisms: Sequence[FlatSolid]) -> list[Part.Shape]:
    """Solids without common parts that fill the same space as prisms on one plane."""
    if len(prisms) < MANY_PRISMS:
        return [make_solid(prism) for prism in prisms]
    way = App.Vector(*(prisms[0].frame.z_axis * prisms[0].thickness).tolist())
    faces = [make_face(p.outline, p.holes, p.frame) for p in prisms]
    pieces = faces[0].multiFuse(faces[1:]).Faces
    wholes = [Part.makeShell(lot).removeSplitter() for lot in _joined(pieces)]
    return [face.extrude(way) for whole in wholes for face in whole.Faces]


def _joined(faces: Sequence[Part.Face]) -> list[list[Part.Face]]:
    """Faces that share edges, each lot apart from the others: only such are made one."""
    lots: list[tuple[set[int], list[Part.Face]]] = []
    for face in faces:
        edges, members = {edge.hashCode() for edge in face.Edges}, [face]
        for lot in [lot for lot in lots if lot[0] & edges]:
            lots.remove(lot)
            edges |= lot[0]
            members += lot[1]
        lots.append((edges, members))
    return [members for _, members in lots]
