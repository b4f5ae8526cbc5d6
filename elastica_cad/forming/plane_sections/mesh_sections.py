"""Sections of triangle meshes by planes: ordered lines in the planes' own frames.

A vertex in the plane counts as lying on one side of it, as if the plane were moved aside by less than any
number (simulation of simplicity): every face that has corners on both sides is then crossed at two of its
edges, edges are told apart by their vertices alone, and the pieces chain up without comparing places. The
points themselves are those of the plane as it is.
"""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from elastica_cad._types import ArrayLike, BoolArray, FloatArray, IntArray
from elastica_cad.errors import InputError
from elastica_cad.forming.plane_sections.section_lines import (
    IN_PLANE,
    PlaneSection,
    collect_section,
    place_in_words,
)
from elastica_cad.forming.plane_sections.triangle_mesh import Mesh
from elastica_cad.geometry.frame import Frame

APART = 1e-10
"""Neighbouring points of a section nearer than this share of the size are one."""


def mesh_sections(
    vertices: ArrayLike, faces: ArrayLike, planes: Sequence[Frame], *, half: bool = False
) -> tuple[PlaneSection, ...]:
    """Sections of a triangle mesh, open or closed, by a family of planes; no vertex is moved.

    Parameters
    ----------
    vertices, faces : (n, 3) and (m, 3) array_like
        The mesh, mm; see `Mesh`.
    planes : sequence of Frame
        From `parallel_planes`, `radial_planes`, `planes_along`, or by hand.
    half : bool
        Only what lies at x >= 0 of each frame: half planes about an axis.

    Returns
    -------
    tuple of PlaneSection
        One a plane, in order; a plane that misses gives a section without lines and a sentence that says so.

    Raises
    ------
    InputError
        A mesh that is none, see `Mesh`; planes that are not a sequence of frames.

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
    found = [_section(mesh, frame, half, f"section {i + 1}") for i, frame in enumerate(planes)]
    if mesh.reports and found:
        found[0] = replace(found[0], reports=(*mesh.reports, *found[0].reports))
    return tuple(found)


def refuse_odd_planes(planes: object) -> None:
    """Raise where planes are not a sequence of frames."""
    if not (isinstance(planes, Sequence) and all(isinstance(frame, Frame) for frame in planes)):
        raise InputError(
            f"planes must be a sequence of Frames, not {type(planes).__name__}: put one in a list"
        )


def _section(mesh: Mesh, frame: Frame, half: bool, name: str) -> PlaneSection:
    local = frame.local(mesh.vertices)
    height = np.where(np.abs(local[:, 2]) <= IN_PLANE * mesh.size, 0.0, local[:, 2])
    chains = _chained(mesh, local, height, height >= 0)
    reports: list[str] = []
    if np.any(height == 0):
        other = _chained(mesh, local, height, height > 0)
        one, two = _total(chains), _total(other)
        if abs(one - two) > 1e-9 * mesh.size:
            chains = chains if one > two else other
            at = frame.point(local[height == 0][0, :2])
            reports.append(
                f"{name}: an edge or a face of the mesh lies in the plane, near {place_in_words(at)}; the section "
                f"follows the longer of its two sides ({max(one, two):.6g} against {min(one, two):.6g} mm)"
            )
    found = collect_section(
        name, frame, chains, half=half, apart=APART * mesh.size, missed=lambda: _missing(mesh, local, height)
    )
    return replace(found, reports=(*reports, *found.reports))


def _missing(mesh: Mesh, local: FloatArray, height: FloatArray) -> str:
    """How a plane comes to cut nothing."""
    used = np.unique(mesh.faces)
    low, high = float(local[used, 2].min()), float(local[used, 2].max())
    if low > 0 or high < 0:
        return f"misses the mesh by {min(abs(low), abs(high)):.4g} mm"
    touched = used[height[used] == 0]
    if touched.size and (low == 0 or high == 0):
        return f"touches the mesh near {place_in_words(mesh.vertices[touched[0]])} and cuts nothing: shift it"
    return "misses the mesh"


def _chained(mesh: Mesh, local: FloatArray, height: FloatArray, above: BoolArray) -> list[FloatArray]:
    """Lines (k, 2) through the crossed faces, where `above` tells the sides of the vertices apart."""
    side = above[mesh.faces]
    faces = mesh.faces[side.any(axis=1) & ~side.all(axis=1)]
    if not len(faces):
        return []
    corner = above[faces]
    alone = np.argmax(corner == (corner.sum(axis=1) == 1)[:, None], axis=1)
    rows = np.arange(len(faces))
    tip = faces[rows, alone]
    edges = np.stack([np.sort([tip, faces[rows, (alone + k) % 3]], axis=0).T for k in (1, 2)], axis=1)
    nodes, index = np.unique(edges.reshape(-1, 2), axis=0, return_inverse=True)
    a, b = nodes.T
    share = height[a] / (height[a] - height[b])
    points = local[a, :2] + share[:, None] * (local[b, :2] - local[a, :2])
    points[share == 1] = local[b[share == 1], :2]
    return [points[chain] for chain in _walks(index.reshape(-1, 2).astype(np.intp), len(nodes))]


def _walks(links: IntArray, count: int) -> list[list[int]]:
    """Chains of nodes that links (m, 2) make; they end at nodes of one link, or of more than two."""
    at: list[list[int]] = [[] for _ in range(count)]
    for k, (a, b) in enumerate(links.tolist()):
        at[a].append(k)
        at[b].append(k)
    used = np.zeros(len(links), dtype=bool)
    ends = [node for node in range(count) if len(at[node]) != 2]
    walks = []
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
    return sum(float(np.linalg.norm(np.diff(chain, axis=0), axis=1).sum()) for chain in chains)
