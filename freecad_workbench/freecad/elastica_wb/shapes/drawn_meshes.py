# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""The triangles by which a view draws a bent strip: known with its boundary, so that no mesher looks for them.

OpenCASCADE's takes a third to a half of a recompute: it walks through every span of the bent splines.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.fabrication.solids.boundary_records import Boundary, Edge, EdgeUse, Face, SpaceCurve
from elastica_cad.geometry.paths.segments import Line

TURN = 0.3  # rad between neighbouring chords of an edge: three fifths of what FreeCAD's views ask for
FEWEST, MOST = 65, 1025  # points of a bent edge; the least about as many as OpenCASCADE sets
SPARE = 1.3  # times what chords are off at their middles no triangle is off
ACROSS = 0.5  # of a chord: points that are joined lie no farther from straight across

_CORNERS = np.array([[0, 1, 2], [0, 2, 3]])
_SIDES = [(np.array([i, (i + 1) % 4]), np.array([(i + 1) % 4, i])) for i in range(4)]


@dataclass(frozen=True, eq=False)
class FaceMesh:
    """Triangles of one face.

    Attributes
    ----------
    points : (n, 3) array
        Nodes, mm.
    triangles : (k, 3) array
        Rows of nodes, anticlockwise as seen from the side to which the surface's normal points.
    edges : sequence of (edge, nodes)
        The nodes along each edge of the face, in the direction of the edge.
    """

    points: FloatArray
    triangles: IntArray
    edges: Sequence[tuple[int, IntArray]]


@dataclass(frozen=True, eq=False)
class Mesh:
    """Triangles of a whole boundary.

    Attributes
    ----------
    parameters : sequence of (n,) arrays
        Where along each edge its points are.
    faces : sequence of FaceMesh
    off : float
        How far the triangles stray from the boundary, mm.
    """

    parameters: Sequence[FloatArray]
    faces: Sequence[FaceMesh]
    off: float


def mesh_of(boundary: Boundary) -> Mesh | None:
    """The mesh of a boundary of faces between two chains of edges, as plain strips have; None of others."""
    bent = [i for i, edge in enumerate(boundary.edges) if isinstance(edge.curve, SpaceCurve)]
    straight = [edge.curve for edge in boundary.edges if not isinstance(edge.curve, SpaceCurve)]
    if not bent or not all(isinstance(curve.segment, Line) for curve in straight):
        return None
    if any(len(face.loops) != 1 for face in boundary.faces):
        return None
    places, points, off = _followed([boundary.edges[i] for i in bent])
    for at, end in ((0, "start"), (-1, "end")):  # where other edges meet them, to the last bit
        points[:, at] = boundary.vertices[[getattr(boundary.edges[i], end) for i in bent]]
    followed = dict(zip(bent, points, strict=True))
    faces = [_four_sided(face, boundary, followed) for face in boundary.faces]
    known = [face for face in faces if face is not None]
    if len(known) < len(faces):
        return None
    parameters = [np.array((edge.first, edge.last)) for edge in boundary.edges]
    for i, t in zip(bent, places, strict=True):
        parameters[i] = t
    return Mesh(parameters, known, off)


def _followed(edges: Sequence[Edge]) -> tuple[list[FloatArray], FloatArray, float]:
    """Parameters and points (k, n, 3) of bent edges, as many of each, and how far their chords are off, mm."""
    from scipy.interpolate import BSpline

    curves = [edge.curve for edge in edges if isinstance(edge.curve, SpaceCurve)]
    splines = [BSpline.construct_fast(one.knots, one.control_points, one.degree) for one in curves]
    count = FEWEST
    while True:
        places = [np.linspace(edge.first, edge.last, 2 * count - 1) for edge in edges]
        found = np.stack([spline(t) for spline, t in zip(splines, places, strict=True)])
        points, middles = found[:, ::2], found[:, 1::2]
        chords = points[:, 1:] - points[:, :-1]
        rise = middles - points[:, :-1] - chords / 2
        strays = np.sqrt(np.einsum("kij,kij->ki", rise, rise))
        size = np.sqrt(np.einsum("kij,kij->ki", chords, chords))
        # an arc rises by an eighth of chord times turn
        if count >= MOST or (8 * strays <= TURN * size).all():
            return [t[::2] for t in places], points, SPARE * float(strays.max())
        count = 2 * count - 1


def _four_sided(face: Face, boundary: Boundary, followed: dict[int, FloatArray]) -> FaceMesh | None:
    """A face between two chains of edges with as many points, that straight edges join at both ends."""
    (loop,) = face.loops
    straight = [i for i, use in enumerate(loop) if use.edge not in followed]
    if len(loop) == len(straight) == 4:
        corners = boundary.vertices[[_first_corner(use, boundary) for use in loop]]
        sides = [(use.edge, _SIDES[i][not use.forward]) for i, use in enumerate(loop)]
        return FaceMesh(corners, _CORNERS, sides)
    if len(straight) != 2:
        return None
    first, second = straight
    there, back = loop[first + 1 : second], (*loop[second + 1 :], *loop[:first])
    if not there or len(there) != len(back):
        return None
    rows = [_ordered(followed[use.edge], use.forward) for use in (*there, *back)]
    count, size = len(rows[0]) - 1, len(there) * (len(rows[0]) - 1) + 1
    parts = [*(row[:-1] for row in rows[: len(there)]), rows[len(there) - 1][-1:]]
    parts += [*(row[:-1] for row in rows[len(there) :]), rows[-1][-1:]]
    points = np.concatenate(parts)
    if len(there) > 1 and _leans(points[:size:count], points[size:][::-count]):
        return None
    edges = [
        (use.edge, _ordered(np.arange(k, k + count + 1), use.forward))
        for start, chain in ((0, there), (size, back))
        for k, use in zip(range(start, start + size - 1, count), chain, strict=True)
    ]
    ends = (loop[second], (size - 1, size)), (loop[first], (2 * size - 1, 0))
    edges += [(use.edge, _ordered(np.array(nodes), use.forward)) for use, nodes in ends]
    return FaceMesh(points, _rungs(size), edges)


@lru_cache(maxsize=16)
def _rungs(size: int) -> IntArray:
    """Triangles between points 0 .. size - 1 of one side and those that come back along the other."""
    ahead = np.arange(size)
    beside = 2 * size - 1 - ahead
    a, b, c, d = ahead[:-1], ahead[1:], beside[1:], beside[:-1]
    return np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])


def _leans(one: FloatArray, other: FloatArray) -> bool:
    """Do joints (k, 3) of two sides lie beside each other, rather than straight across as the sides' ends do?"""
    apart = other - one
    across = apart[0] / np.sqrt(apart[0] @ apart[0])
    along = np.sqrt((np.diff(one, axis=0) ** 2).sum(axis=1)).min() / (FEWEST - 1)
    beside = apart - (apart @ across)[:, None] * across
    return bool(np.sqrt((beside**2).sum(axis=1)).max() > ACROSS * along)


def _first_corner(use: EdgeUse, boundary: Boundary) -> int:
    edge = boundary.edges[use.edge]
    return edge.start if use.forward else edge.end


def _ordered(rows: FloatArray, forward: bool) -> FloatArray:
    return rows if forward else rows[::-1]
