"""Triangle meshes with merged vertices, and their plane sections as ordered lines.

A vertex in the plane counts as a vertex on one side (simulation of simplicity). So every face with vertices on both
sides is crossed at two edges. Pieces of a section are joined by the vertices of these edges, not by coordinates.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from elastica_cad._types import ArrayLike, BoolArray, FloatArray, IntArray
from elastica_cad._values import is_number, with_article
from elastica_cad.errors import InputError, Length, Listed, Point, note
from elastica_cad.form_finding.section_lines import IN_PLANE, PlaneSection, collect_section, place_in_words
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.plane_points import lengths_along

FARTHEST_MM = 1e9
"""Largest coordinate, mm."""


@dataclass(frozen=True, eq=False)
class Mesh:
    """An open or closed triangle mesh in space.

    Coincident vertices are merged, because files often repeat them. Border vertices closer than 1e-5 of the extent
    of the borders are merged too, because of rounding errors. Triangles without area and repeated triangles are
    removed. `reports` lists the defects of the mesh; none of them prevents a section.

    Parameters
    ----------
    vertices : (n, 3) array_like
        Vertices, mm.
    faces : (m, 3) array_like of int
        Indices of the vertices of each triangle. The orientation has no effect.

    Examples
    --------
    >>> square = Mesh([(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0)], [(0, 1, 2), (0, 2, 3), (2, 2, 1)])
    >>> square.faces.shape[0], square.reports[0]
    (2, '1 of 3 triangles has no area: left out (the first at (1, 0.666667, 0) mm)')
    """

    vertices: FloatArray
    faces: IntArray
    reports: tuple[str, ...] = ()

    def __init__(self, vertices: ArrayLike, faces: ArrayLike) -> None:
        points, rows = _checked(vertices, faces)
        points, index = np.unique(points + 0.0, axis=0, return_inverse=True)
        rows = _with_merged_cracks(points, index.reshape(-1)[rows])
        a, b, c = points[rows].swapaxes(0, 1)
        keep = np.cross(b - a, c - a).any(axis=1) & (rows != np.roll(rows, 1, axis=1)).all(axis=1)
        reports = _complaint(points, rows[~keep], len(rows), "has no area", "have no area", ": left out")
        remaining = rows[keep]
        _, first = np.unique(np.sort(remaining, axis=1), axis=0, return_index=True)
        again = np.delete(remaining, first, axis=0)
        reports += _complaint(
            points, again, len(rows), "is there twice", "are there twice", ": left out once"
        )
        remaining = remaining[np.sort(first)]
        if not len(remaining):
            raise InputError("all triangles of the mesh have zero area: export the mesh again")
        directed = _sides(remaining)
        edges, side, faces_at = np.unique(
            np.sort(directed, axis=1), axis=0, return_inverse=True, return_counts=True
        )
        # 0 if the two triangles at an edge run along it in opposite directions, as they should
        sense = np.bincount(side.reshape(-1), weights=np.where(directed[:, 0] < directed[:, 1], 1.0, -1.0))
        defects = (
            ("the mesh is open along {edges} (near {places}), so sections end there", edges[faces_at == 1]),
            (
                "more than two faces meet at {edges} (near {places}): sections are split there",
                edges[faces_at > 2],
            ),
            (
                "adjacent faces have opposite orientations along {edges} (near {places}): this does not change "
                "the sections",
                edges[(faces_at == 2) & (sense != 0)],
            ),
        )
        reports += [
            note(
                template,
                edges="1 edge" if len(found) == 1 else f"{len(found)} edges",
                places=_places(points, found),
            )
            for template, found in defects
            if len(found)
        ]
        vars(self).update(vertices=points, faces=remaining, reports=tuple(reports))

    @property
    def size(self) -> float:
        """Diagonal of the bounding box, mm."""
        return float(np.linalg.norm(np.ptp(self.vertices[np.unique(self.faces)], axis=0)))

    def scaled(self, factor: float) -> "Mesh":
        """Return the mesh with all coordinates multiplied by `factor`."""
        if not (is_number(factor) and factor > 0):
            raise InputError(f"the scale of the mesh is {factor!r}: give a positive number")
        return Mesh(self.vertices * factor, self.faces)


def _checked(vertices: ArrayLike, faces: ArrayLike) -> tuple[FloatArray, IntArray]:
    try:
        points, rows = np.asarray(vertices, dtype=float), np.asarray(faces)
    except (TypeError, ValueError, OverflowError):
        raise InputError(
            "the mesh is not two arrays of numbers: give vertices (n, 3) and triangles (m, 3)"
        ) from None
    if points.ndim != 2 or points.shape[1] != 3 or rows.ndim != 2 or rows.shape[1] != 3:
        raise InputError(
            f"the mesh has arrays of shape {points.shape} and {rows.shape}: give vertices (n, 3) and "
            "triangles (m, 3), and divide larger faces into triangles"
        )
    if not (points.size and rows.size):
        raise InputError("the mesh has no triangles to cut: export the mesh again")
    if not np.issubdtype(rows.dtype, np.integer):
        raise InputError(
            "the triangles of the mesh are not rows of whole numbers: give the indices of three vertices, "
            "from 0, in each row"
        )
    if not np.isfinite(points).all():
        bad = int(np.isfinite(points).all(axis=1).argmin())
        raise InputError(f"vertex {bad} of the mesh is {points[bad].tolist()}: give finite coordinates")
    largest = float(np.abs(points).max())
    if largest > FARTHEST_MM:
        bad = int(np.abs(points).max(axis=1).argmax())
        raise InputError(
            (
                "vertex {bad} of the mesh is {far} from the origin: correct the unit or the scale, or repair the "
                "mesh"
            ),
            bad=bad,
            far=Length(largest),
        )
    if rows.min() < 0 or rows.max() >= len(points):
        raise InputError(
            f"a triangle has vertex {rows.max() if rows.min() >= 0 else rows.min()}, but the mesh has "
            f"{len(points)} vertices: give indices from 0 to {len(points) - 1}"
        )
    return points, rows.astype(np.intp)


def _with_merged_cracks(points: FloatArray, rows: IntArray) -> IntArray:
    """Return the triangles with nearby vertices of open borders merged, which would interrupt a section."""
    edges, count = np.unique(np.sort(_sides(rows), axis=1), axis=0, return_counts=True)
    # vertices of sides that belong to one triangle only
    border = np.unique(edges[(count == 1) & (edges[:, 0] != edges[:, 1])])
    if not border.size:
        return rows
    from scipy.sparse import coo_array
    from scipy.sparse.csgraph import connected_components
    from scipy.spatial import cKDTree

    # merge vertices of borders that are closer than this fraction of the extent of the borders
    width = 1e-5 * float(np.linalg.norm(np.ptp(points[border], axis=0)))
    pairs = cKDTree(points[border]).query_pairs(width, output_type="ndarray")
    if not len(pairs):
        return rows
    links = coo_array((np.ones(len(pairs)), pairs.T), shape=(border.size, border.size))
    _, piece = connected_components(links, directed=False)
    _, first = np.unique(piece, return_index=True)
    merged = np.arange(len(points))
    merged[border] = border[first[piece]]
    return merged[rows]


def _sides(rows: IntArray) -> IntArray:
    """Return the two vertices of each side (3 m, 2) of triangles (m, 3)."""
    return rows[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2)


def _complaint(
    points: FloatArray, rows: IntArray, total: int, singular: str, many: str, then: str
) -> list[str]:
    return [
        note(
            "{count} of {total} triangles {what}{then} (the first at {place:.6g})",
            count=len(rows), total=total, what=singular if len(rows) == 1 else many, then=then, place=place,
        )
        for place in _places(points, rows[:1])
    ]  # fmt: skip


def _places(points: FloatArray, edges: Sequence[IntArray] | IntArray) -> Listed:
    return Listed(Point(points[edge].mean(axis=0).round(6) + 0.0) for edge in edges[:3])


APART = 1e-10
"""Distance below which neighbouring points of a section are merged, as a fraction of the size of the mesh."""


def mesh_sections(
    vertices: ArrayLike, faces: ArrayLike, planes: Sequence[Frame], *, half: bool = False
) -> tuple[PlaneSection, ...]:
    """Return the sections of an open or closed triangle mesh by a family of planes.

    Parameters
    ----------
    vertices, faces : (n, 3) and (m, 3) array_like
        Vertices, mm, and faces of the mesh: see `Mesh`.
    planes : sequence of Frame
        Planes, such as the results of `parallel_planes`, `radial_planes` and `planes_along`.
    half : bool
        If True, only the part with x >= 0 in each frame is returned, for half planes about an axis.

    Returns
    -------
    tuple of PlaneSection
        A section for each plane, in order. If a plane misses the mesh, its section has no lines, and a message.

    Examples
    --------
    >>> corners = [(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
    >>> quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    >>> cube = [(q[0], q[i], q[i + 1]) for q in quads for i in (1, 2)]
    >>> section, = mesh_sections(corners, cube, [Frame((0, 0, 0.5))])
    >>> section.line.is_closed, section.line.length
    (True, 4.0)
    """
    mesh = Mesh(vertices, faces)
    refuse_odd_planes(planes)
    sections = [
        _section(mesh, frame, half, note("section {number}", number=i + 1)) for i, frame in enumerate(planes)
    ]
    if mesh.reports and sections:
        sections[0] = replace(sections[0], reports=(*mesh.reports, *sections[0].reports))
    return tuple(sections)


def refuse_odd_planes(planes: object) -> None:
    """Raise InputError if the planes are not a sequence of frames."""
    if not (isinstance(planes, Sequence) and all(isinstance(frame, Frame) for frame in planes)):
        raise InputError(
            f"planes are {with_article(type(planes))}: give a sequence of Frames, with a single plane in a list"
        )


def _section(mesh: Mesh, frame: Frame, half: bool, name: str) -> PlaneSection:
    """Return the section of a mesh by the plane of a frame.

    Vertices in the plane count as above. If the section is longer with them below, this section is used.
    """
    # vertices (n, 3) in the axes of the plane, and their heights (n,) above it, without rounding errors around 0
    local = frame.local(mesh.vertices)
    height = np.where(np.abs(local[:, 2]) <= IN_PLANE * mesh.size, 0.0, local[:, 2])
    chains = _chained(mesh, local, height, height >= 0)
    reports: list[str] = []
    if np.any(height == 0):
        other = _chained(mesh, local, height, height > 0)
        total, other_total = _total(chains), _total(other)
        if abs(total - other_total) > 1e-9 * mesh.size:
            chains = chains if total > other_total else other
            at = frame.point(local[height == 0][0, :2])
            reports.append(note(
                "{name}: near {place} an edge or a face of the mesh is exactly in the plane, so the section "
                "is ambiguous. The longer of two possible sections is used ({longer:.6g}, not {shorter:.6g})",
                name=name, place=place_in_words(at), longer=Length(max(total, other_total)),
                shorter=Length(min(total, other_total)),
            ))  # fmt: skip
    section = collect_section(
        name,
        frame,
        chains,
        half=half,
        apart=APART * mesh.size,
        missed=lambda: _reason_for_no_section(mesh, local, height),
    )
    return replace(section, reports=(*reports, *section.reports))


def _reason_for_no_section(mesh: Mesh, local: FloatArray, height: FloatArray) -> str:
    """Return why a plane has no section: it misses or only touches the mesh.

    `local` (n, 3) and `height` (n,) are as in `_section`.
    """
    used = np.unique(mesh.faces)
    low, high = float(local[used, 2].min()), float(local[used, 2].max())
    if low > 0 or high < 0:
        return note("misses the mesh by {far}: move the plane", far=Length(min(abs(low), abs(high))))
    touched = used[height[used] == 0]
    if touched.size and (low == 0 or high == 0):
        return note(
            "touches the mesh near {place} without cutting it: move the plane",
            place=place_in_words(mesh.vertices[touched[0]]),
        )
    return note("misses the mesh")


def _chained(mesh: Mesh, local: FloatArray, height: FloatArray, above: BoolArray) -> list[FloatArray]:
    """Return the lines in which the faces meet the plane, as chains of points (k, 2).

    `local` (n, 3) are the vertices in the axes of the plane, and `height` (n,) is their height above it. `above`
    (n,) is True for vertices that count as above the plane, also if their height is 0.
    """
    side = above[mesh.faces]
    faces = mesh.faces[side.any(axis=1) & ~side.all(axis=1)]
    if not len(faces):
        return []
    corner = above[faces]
    # the place (0, 1 or 2) in each face of the vertex that is alone on its side; the two edges there are crossed
    alone = (corner == (corner.sum(axis=1) == 1)[:, None]).argmax(axis=1)
    rows = np.arange(len(faces))
    tip = faces[rows, alone]
    edges = np.stack([np.sort([tip, faces[rows, (alone + k) % 3]], axis=0).T for k in (1, 2)], axis=1)
    # neighbouring faces share an edge, and so a point of the section: `nodes` are the vertices of each such edge
    nodes, index = np.unique(edges.reshape(-1, 2), axis=0, return_inverse=True)
    a, b = nodes.T
    share = height[a] / (height[a] - height[b])
    points = local[a, :2] + share[:, None] * (local[b, :2] - local[a, :2])
    points[share == 1] = local[b[share == 1], :2]
    return [points[chain] for chain in _walks(index.reshape(-1, 2).astype(np.intp), len(nodes))]


def _walks(links: IntArray, count: int) -> list[list[int]]:
    """Return chains of nodes that follow the links (m, 2).

    The chains end at nodes that do not have two links.
    """
    # indices of the links at each node
    at: list[list[int]] = [[] for _ in range(count)]
    for k, (a, b) in enumerate(links.tolist()):
        at[a].append(k)
        at[b].append(k)
    used = np.zeros(len(links), dtype=bool)
    ends = [node for node in range(count) if len(at[node]) != 2]
    walks = []
    # open chains first, one for each link at an end; the links that remain are closed chains
    for start in [*(node for node in ends for _ in at[node]), *range(count)]:
        walk, node = [start], start
        while True:
            onward = next((k for k in at[node] if not used[k]), None)
            if onward is None:
                break
            used[onward] = True
            a, b = links[onward].tolist()
            node = b if a == node else a
            walk.append(node)
            if len(at[node]) != 2:
                break
        if len(walk) > 1:
            walks.append(walk)
    return walks


def _total(chains: Sequence[FloatArray]) -> float:
    return sum(float(lengths_along(chain)[-1]) for chain in chains)
