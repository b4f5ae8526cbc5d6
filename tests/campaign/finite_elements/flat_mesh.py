"""Quadrilaterals on what leaves the laser: cut files (DXF) read by ezdxf, meshed by gmsh on their exact splines."""

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import Any, NamedTuple

import ezdxf
import gmsh
import numpy as np

__all__ = ["FlatMesh", "mesh_cut_files", "meshed"]

MEETS_MM = 1e-5
"""Ends of entities that come this near to each other are one point."""


@dataclass(frozen=True, eq=False)
class FlatMesh:
    """Second-order quadrilaterals in the plane of the sheet.

    Attributes
    ----------
    nodes : (n, 2) array
        mm, in the frame of the flat pattern.
    quads : (m, 8) int array
        Corners anticlockwise, then the middles of the sides, from the first on.
    layers : (m,) int array
        How many of the sheets, counted from the base, lie there.
    """

    nodes: np.ndarray
    quads: np.ndarray
    layers: np.ndarray


def mesh_cut_files(paths: Sequence[Path], *, size: float, at: Sequence[float] = ()) -> FlatMesh:
    """The sheets that are cut by DXF files and lie on each other, the base first.

    Parameters
    ----------
    size : float
        Length of the elements' sides, mm.
    at : sequence of float
        Stations, mm, across which a line of element sides runs: where the free part begins and ends.
    """
    gmsh.initialize(interruptible=False)
    try:
        gmsh.option.setNumber("General.Verbosity", 2)
        sheets = [(2, _surface(path)) for path in paths]
        low, high = np.array(gmsh.model.occ.getBoundingBox(*sheets[0])).reshape(2, 3)[:, 1] * 1.5
        lines = [(1, _line((x, low), (x, high))) for x in at]
        _, parts = gmsh.model.occ.fragment(sheets, lines)
        gmsh.model.occ.synchronize()
        surfaces = [{tag for dim, tag in part if dim == 2} for part in parts[: len(sheets)]]
        _remove_loose_lines()
        return meshed(surfaces, size)
    finally:
        gmsh.finalize()


def meshed(surfaces: Sequence[set[int]], size: float) -> FlatMesh:
    """The surfaces of each sheet, by their numbers in gmsh."""
    for name, value in {
        "Mesh.MeshSizeMin": 2 * size,
        "Mesh.MeshSizeMax": 2 * size,
        "Mesh.Algorithm": 6,
        "Mesh.RecombineAll": 1,
        "Mesh.RecombinationAlgorithm": 1,
        "Mesh.SubdivisionAlgorithm": 1,  # each into four, and triangles left over into three quadrilaterals
        "Mesh.ElementOrder": 2,
        "Mesh.SecondOrderIncomplete": 1,
    }.items():
        gmsh.option.setNumber(name, value)
    gmsh.model.mesh.generate(2)
    tags, points, _ = gmsh.model.mesh.getNodes()
    place = np.full(int(tags.max()) + 1, -1)
    place[tags.astype(int)] = np.arange(tags.size)
    nodes = points.reshape(-1, 3)[:, :2]
    quads, layers = [], []
    for surface in sorted(set.union(*surfaces)):
        kinds, _, corners = gmsh.model.mesh.getElements(2, surface)
        assert list(kinds) == [16], f"element kinds {kinds}: quadrilaterals of eight nodes are needed"
        rows = place[np.asarray(corners[0], dtype=int).reshape(-1, 8)]
        x, y = np.moveaxis(nodes[rows[:, [0, 1, 2, 3]]], 2, 0)
        clockwise = (x[:, 2] - x[:, 0]) * (y[:, 3] - y[:, 1]) < (x[:, 3] - x[:, 1]) * (y[:, 2] - y[:, 0])
        quads.append(np.where(clockwise[:, None], rows[:, [0, 3, 2, 1, 7, 6, 5, 4]], rows))
        layers.append(np.full(len(rows), sum(surface in sheet for sheet in surfaces)))
    used, rows = np.unique(np.concatenate(quads), return_inverse=True)
    return FlatMesh(nodes[used], rows.reshape(-1, 8), np.concatenate(layers))


def _remove_loose_lines() -> None:
    """Forget the ends of lines that pass the sheets."""
    for _, tag in gmsh.model.getEntities(1):
        if not gmsh.model.getAdjacencies(1, tag)[0].size:
            gmsh.model.removeEntities([(1, tag)], recursive=True)


def _surface(path: Path) -> int:
    """The sheet within the outer loop of a cut file, without what its inner loops take."""
    drawn = ezdxf.readfile(path).modelspace()
    outer, inner = (_loops([entity for entity in drawn if entity.dxf.layer == layer])
                    for layer in ("CUT_OUTER", "CUT_INNER"))  # fmt: skip
    assert len(outer) == 1, f"{path}: one outer loop is needed, {len(outer)} found"
    return gmsh.model.occ.addPlaneSurface([*outer, *inner])


def _loops(entities: Sequence[Any]) -> list[int]:
    """Curve loops of entities, joined where their ends meet."""
    points: dict[tuple[int, int], int] = {}

    def point(xyz: Any) -> int:
        key = (round(xyz[0] / MEETS_MM), round(xyz[1] / MEETS_MM))
        for i in (0, 1, -1):  # a rounding edge between them
            for j in (0, 1, -1):
                if (key[0] + i, key[1] + j) in points:
                    return points[key[0] + i, key[1] + j]
        return points.setdefault(key, gmsh.model.occ.addPoint(xyz[0], xyz[1], 0.0))

    open_curves, loops = [], []
    pieces = [piece for entity in entities for piece in _pieces(entity)]
    for piece in pieces:
        curve, first, last = _curve(piece, point)
        if first == last:
            loops.append(gmsh.model.occ.addCurveLoop([curve]))
        else:
            open_curves.append((curve, first, last))
    while open_curves:
        curve, start, end = open_curves.pop()
        chain = [curve]
        while end != start:
            found = next(one for one in open_curves if end in one[1:])
            open_curves.remove(found)
            chain.append(found[0])
            end = found[2] if found[1] == end else found[1]
        loops.append(gmsh.model.occ.addCurveLoop(chain))
    return loops


class _Spline(NamedTuple):
    """A B-spline without corners."""

    degree: int
    knots: np.ndarray
    controls: np.ndarray

    def dxftype(self) -> str:
        """As entities have it."""
        return "SPLINE"


def _pieces(entity: Any) -> list[Any]:
    """Lines, arcs and splines without corners: on an edge that turns, elements would cut the corner."""
    if entity.dxftype() in ("LWPOLYLINE", "POLYLINE"):
        return list(entity.virtual_entities())
    if entity.dxftype() != "SPLINE":
        return [entity]
    assert not len(entity.weights), "cut files hold splines without weights"
    p, knots, controls = entity.dxf.degree, np.round(entity.knots, 9), np.array(entity.control_points)
    values, counts = np.unique(knots, return_counts=True)
    corners = [value for value, times in zip(values[1:-1], counts[1:-1], strict=True) if times >= p]
    found = []
    for low, high in pairwise([values[0], *corners, values[-1]]):
        inside = knots[(knots > low) & (knots < high)]
        first = np.searchsorted(knots, low, side="right") - p - 1
        own = np.concatenate([np.full(p + 1, low), inside, np.full(p + 1, high)])
        found.append(_Spline(p, own, controls[first : first + own.size - p - 1]))
    return found


def _curve(entity: Any, point: Any) -> tuple[int, int, int]:
    """The gmsh curve of one entity, and the points at its ends."""
    occ = gmsh.model.occ
    match entity.dxftype():
        case "LINE":
            ends = point(entity.dxf.start), point(entity.dxf.end)
            return occ.addLine(*ends), *ends
        case "CIRCLE":
            x, y, _ = entity.dxf.center
            return occ.addCircle(x, y, 0.0, entity.dxf.radius), 0, 0
        case "ARC":
            ends = point(entity.start_point), point(entity.end_point)
            x, y, _ = entity.dxf.center
            return occ.addCircleArc(ends[0], occ.addPoint(x, y, 0.0), ends[1]), *ends
        case "SPLINE":
            ends = point(entity.controls[0]), point(entity.controls[-1])
            inner = [occ.addPoint(x, y, 0.0) for x, y, _ in entity.controls[1:-1]]
            knots, times = np.unique(entity.knots, return_counts=True)
            shape = {"degree": entity.degree, "knots": list(knots), "multiplicities": [int(n) for n in times]}
            return occ.addBSpline([ends[0], *inner, ends[1]], **shape), *ends
    raise AssertionError(f"a cut file holds no {entity.dxftype()}")


def _line(a: tuple[float, float], b: tuple[float, float]) -> int:
    occ = gmsh.model.occ
    return int(occ.addLine(occ.addPoint(*a, 0.0), occ.addPoint(*b, 0.0)))
