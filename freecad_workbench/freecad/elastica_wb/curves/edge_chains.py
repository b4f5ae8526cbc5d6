# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Grouping of the edges of an object in chains, one for each curve that a strip can follow."""

from collections.abc import Iterable, Sequence
from math import pi, radians
from typing import Any

import FreeCAD as App
import Part
from freecad.elastica_wb.curves.sketch_curves import edge_called

# largest gap, mm, between connected edges
MEET_MM = 1e-4
# ends of curves in a sketch that are closer than this, mm, are probably meant to meet
MEANT_MM = 0.5
# a turn larger than this, rad, is a corner
SMOOTH_RAD = radians(5.0)
# an edge of a sketch belongs to a drawn curve if it is closer than this, mm, to the middle of the curve
DRAWN_MM = 1e-5

Edges = Sequence[tuple[str, Any]]
End = tuple[App.Vector, App.Vector]


def chains_of(source: Any, names: Sequence[str]) -> list[tuple[str, ...]]:
    """Return the names of edges, grouped in chains."""
    return _chained([(name, edge_called(source, name)) for name in names], MEET_MM)


def curves_in(sketch: Any, picked: Sequence[str] = ()) -> list[tuple[str, ...]]:
    """Return the edge names of each curve in a sketch, or only of curves with edges in `picked`.

    A single picked edge selects its chain up to the next corners. Several picked edges of a chain form a
    curve without the other edges of the chain. For a sketch with a single curve, the names are ().
    """
    edges = [(f"Edge{i + 1}", edge) for i, edge in enumerate(Part.getShape(sketch).Edges)]
    whole = _chained(edges, MEANT_MM)
    chains = []
    for chain in whole if picked else ():
        picked_names = [name for name in chain if name in picked]
        if len(picked_names) == 1:
            smooth = _chained([(name, edge) for name, edge in edges if name in chain], MEANT_MM, SMOOTH_RAD)
            chains += [names for names in smooth if picked_names[0] in names]
        else:
            chains += _chained([(name, edge) for name, edge in edges if name in picked_names], MEANT_MM)
    chains = chains or whole
    return [()] if len(whole) < 2 and chains == whole else chains


def curves_of_geometry(geometry: Iterable[Any]) -> list[tuple[str, ...]]:
    """Return the names of the edges of each curve formed by geometry of FreeCAD's Part module."""
    return _chained([(f"Edge{i + 1}", item.toShape()) for i, item in enumerate(geometry)], MEANT_MM)


def edges_drawn(sketch: Any, names: Iterable[str]) -> list[str]:
    """Convert the names of edges picked in an open sketch to the names of edges of the sketch's shape.

    Edges in an open sketch are numbered with the construction geometry, which is not part of the shape.
    """
    edges, converted = Part.getShape(sketch).Edges, []
    for number in (int(name[len("Edge") :]) - 1 for name in names):
        item = sketch.Geometry[number]
        middle = sketch.Placement.multVec(item.value((item.FirstParameter + item.LastParameter) / 2))
        near = [edge.distToShape(Part.Vertex(middle))[0] < DRAWN_MM for edge in edges]
        if any(near) and not sketch.getConstruction(number):
            converted.append(f"Edge{near.index(True) + 1}")
    return converted


def _chained(edges: Edges, gap: float, turn: float = pi) -> list[tuple[str, ...]]:
    chains: list[tuple[list[str], list[End]]] = []
    for name, edge in edges:
        first, last = edge.ParameterRange
        out = ((edge.valueAt(first), edge.tangentAt(first) * -1), (edge.valueAt(last), edge.tangentAt(last)))
        names, ends = [name], list(out)
        for other in [
            chain
            for chain in chains
            if any(
                p.distanceToPoint(q) <= gap and along.getAngle(onward * -1) <= turn
                for p, along in out
                for q, onward in chain[1]
            )
        ]:
            chains.remove(other)
            names, ends = other[0] + names, other[1] + ends
        chains.append((names, ends))
    return [tuple(names) for names, _ in chains]
