"""Sections of triangle meshes by planes: ordered lines in the planes' own frames.

A vertex in the plane counts as lying on one side of it, as if the plane were moved aside by less than any
number (simulation of simplicity): every face that has corners on both sides is then crossed at two of its
edges, edges are told apart by their vertices alone, and the pieces chain up without comparing places. The
points themselves are those of the plane as it is.
"""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from elastica_cad._types import ArrayLike, BoolArray, FloatArray, IntArray
from elastica_cad.errors import InputError
from elastica_cad.forming.mesh import Mesh
from elastica_cad.geometry import Frame

__all__ = ["Section", "SectionLine", "mesh_sections", "refuse_odd_planes", "right_half", "tidied"]

IN_PLANE = 1e-12
"""Vertices nearer to the plane than this share of the mesh's size lie in it: rounding."""

APART = 1e-10
"""Neighbouring points of a section nearer than this share of the size are one."""


@dataclass(frozen=True, eq=False)
class SectionLine:
    """One line of a section.

    Open ones run from their lower end (y), at equal height from the left one; closed ones anticlockwise from
    their lowest point, which is repeated at the end.

    Attributes
    ----------
    points : (n, 2) array
        In the coordinates of the frame, mm.
    frame : Frame
    name : str
        What messages call it.
    """

    points: FloatArray
    frame: Frame
    name: str

    @property
    def is_closed(self) -> bool:
        """Does it come back to its start?"""
        return bool(np.all(self.points[0] == self.points[-1]))

    @property
    def length(self) -> float:
        """mm."""
        return float(np.linalg.norm(np.diff(self.points, axis=0), axis=1).sum())

    @property
    def places(self) -> FloatArray:
        """The points in space (n, 3), mm."""
        return self.frame.point(self.points)

    def reversed(self) -> "SectionLine":
        """The same line run from its other end."""
        return replace(self, points=self.points[::-1])

    def split_at(self, points: ArrayLike) -> tuple["SectionLine", ...]:
        """The pieces between the places nearest to `points` (k, 2): k + 1 of an open line, k of a closed one.

        Raises
        ------
        InputError
            No points, or two with the same place.
        """
        wanted = np.atleast_2d(np.asarray(points, dtype=float))
        if wanted.shape[1] != 2 or not np.all(np.isfinite(wanted)):
            raise InputError(f"{self.name} is split at points (k, 2) of its plane, mm")
        return self._split(np.sort([_nearest(self.points, p) for p in wanted]))

    def split_by(self, point: ArrayLike, normal: ArrayLike) -> tuple["SectionLine", ...]:
        """The pieces on either side of the plane through `point` (3,) across `normal` (3,): a spine.

        The line itself where the plane misses it.
        """
        n, p = np.asarray(normal, dtype=float), np.asarray(point, dtype=float)
        if n.shape != (3,) or p.shape != (3,) or not np.any(n) or not np.all(np.isfinite([n, p])):
            raise InputError("a spine is a point and a normal of three numbers, the normal not zero")
        height = (self.places - p) @ (n / np.linalg.norm(n))
        height = np.where(np.abs(height) <= IN_PLANE * np.abs(self.places).max(), 0.0, height)
        above = height >= 0
        i = np.flatnonzero(above[:-1] != above[1:])
        cuts = i + height[i] / (height[i] - height[i + 1])
        if not self.is_closed:  # a plane through its end does not split it
            cuts = cuts[(cuts > 0) & (cuts < len(self.points) - 1)]
        return self._split(cuts) if cuts.size else (self,)

    def split_at_corners(self, turn: float) -> tuple["SectionLine", ...]:
        """The pieces between corners that turn by more than `turn`, rad; the line itself where it has none.

        Raises
        ------
        InputError
            An angle that is not between 0 and pi.
        """
        if not 0 < turn < np.pi:
            raise InputError(f"corners turn by an angle between 0 and pi rad, not {turn!r}")
        points = np.concatenate([self.points, self.points[1:2]]) if self.is_closed else self.points
        step = np.diff(points, axis=0)
        cross = step[:-1, 0] * step[1:, 1] - step[:-1, 1] * step[1:, 0]
        turned = np.abs(np.arctan2(cross, (step[:-1] * step[1:]).sum(axis=1)))
        corners = 1.0 + np.flatnonzero(turned > turn)
        if self.is_closed:
            corners %= len(self.points) - 1
        return self._split(np.sort(corners)) if corners.size else (self,)

    def _split(self, cuts: FloatArray) -> tuple["SectionLine", ...]:
        """Pieces between cuts, in points and shares of the way to the next."""
        last = len(self.points) - 1
        index = np.arange(last + 1)
        at = np.column_stack([np.interp(cuts, index, column) for column in self.points.T])
        cuts = np.unique(cuts)
        if len(cuts) < len(at) or (not self.is_closed and (cuts[0] <= 0 or cuts[-1] >= last)):
            raise InputError(f"{self.name} is split twice at one place, or at its very end: move the points")
        marks = np.concatenate([[0], cuts, [last]])
        points = [
            np.concatenate([[start], self.points[(index > a) & (index < b)], [end]])
            for a, b, start, end in zip(
                marks[:-1], marks[1:], [self.points[0], *at], [*at, self.points[-1]], strict=True
            )
        ]
        if self.is_closed:
            points = [np.concatenate([points[-1][:-1], points[0]]), *points[1:-1]]
        points = [p[np.append(True, np.any(np.diff(p, axis=0) != 0, axis=1))] for p in points]
        return tuple(
            replace(self, points=p, name=f"{self.name}, piece {k + 1}")
            for k, p in enumerate(points)
            if len(p) > 1
        )


@dataclass(frozen=True, eq=False)
class Section:
    """What one plane cuts out of a mesh.

    Attributes
    ----------
    name : str
        "section 3" after its place in the family.
    frame : Frame
    lines : tuple of SectionLine
        The longest first; none where the plane misses.
    reports : tuple of str
        What is worth knowing, one sentence each, the section and the place named.
    """

    name: str
    frame: Frame
    lines: tuple[SectionLine, ...]
    reports: tuple[str, ...] = ()

    @property
    def line(self) -> SectionLine:
        """The only line.

        Raises
        ------
        InputError
            None, or several: choose from `lines`.
        """
        if len(self.lines) != 1:
            reason = self.reports[0] if self.reports else f"{self.name} has {len(self.lines)} lines"
            raise InputError(f"{reason}: choose from its lines")
        return self.lines[0]


def mesh_sections(
    vertices: ArrayLike, faces: ArrayLike, planes: Sequence[Frame], *, half: bool = False
) -> tuple[Section, ...]:
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
    tuple of Section
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


def _section(mesh: Mesh, frame: Frame, half: bool, name: str) -> Section:
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
                f"{name}: an edge or a face of the mesh lies in the plane, near {_place(at)}; the section "
                f"follows the longer of its two sides ({max(one, two):.6g} against {min(one, two):.6g} mm)"
            )
    if half:
        chains = [part for chain in chains for part in right_half(chain)]
    small = APART * mesh.size
    lines = [tidied(chain, small) for chain in chains]
    lines = sorted((line for line in lines if len(line) > 1), key=lambda line: -_length(line))
    if not lines:
        reports.append(f"{name} at {_place(frame.origin)}: the plane {_missing(mesh, local, height)}")
    elif len(lines) > 1:
        starts = "; ".join(_place(frame.point(line[0])) for line in lines[:3])
        reports.append(f"{name} falls into {len(lines)} lines, starting at {starts}")
    names = [name] if len(lines) == 1 else [f"{name}, line {k + 1}" for k in range(len(lines))]
    made = tuple(SectionLine(line, frame, n) for line, n in zip(lines, names, strict=True))
    return Section(name, frame, made, tuple(reports))


def _missing(mesh: Mesh, local: FloatArray, height: FloatArray) -> str:
    """How a plane comes to cut nothing."""
    used = np.unique(mesh.faces)
    low, high = float(local[used, 2].min()), float(local[used, 2].max())
    if low > 0 or high < 0:
        return f"misses the mesh by {min(abs(low), abs(high)):.4g} mm"
    touched = used[height[used] == 0]
    if touched.size and (low == 0 or high == 0):
        return f"touches the mesh near {_place(mesh.vertices[touched[0]])} and cuts nothing: shift it"
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


def right_half(points: FloatArray) -> list[FloatArray]:
    """The parts of a line with x >= 0."""
    closed = bool(np.all(points[0] == points[-1]))
    x = points[:, 0]
    if np.all(x >= 0):
        return [points]
    if closed:  # begin on the other side, so that no part runs over the seam
        shift = int(np.argmin(x[:-1]))
        points = np.concatenate([points[shift:-1], points[: shift + 1]])
        x = points[:, 0]
    parts: list[list[FloatArray]] = []
    for i in range(len(points)):
        if i and (x[i] >= 0) != (x[i - 1] >= 0):
            u = x[i - 1] / (x[i - 1] - x[i])
            cut = np.array([0.0, points[i - 1, 1] + u * (points[i, 1] - points[i - 1, 1])])
            if x[i] >= 0:
                parts.append([cut])
            else:
                parts[-1].append(cut)
        if x[i] >= 0:
            if not parts:
                parts.append([])
            parts[-1].append(points[i])
    return [np.array(part) for part in parts]


def tidied(points: FloatArray, small: float) -> FloatArray:
    """Without repeated points, run the agreed way round."""
    closed = bool(np.all(points[0] == points[-1])) and len(points) > 2
    keep = np.append(True, np.linalg.norm(np.diff(points, axis=0), axis=1) > small)
    points = points[keep]
    if closed and len(points) > 1:
        if np.linalg.norm(points[-1] - points[0]) <= small:
            points = points[:-1]
        if len(points) < 3:
            return points[:1]
        x, y = points.T
        if np.sum(x * np.roll(y, -1) - y * np.roll(x, -1)) < 0:
            points = points[::-1]
        points = np.roll(points, -int(np.lexsort(points.T)[0]), axis=0)
        return np.concatenate([points, points[:1]])
    if len(points) > 1:
        first, last = points[0], points[-1]
        level = abs(first[1] - last[1]) <= 1e-9 * np.abs(points).max()
        if (last[0] < first[0]) if level else (last[1] < first[1]):
            points = points[::-1]
    return points


def _nearest(points: FloatArray, place: FloatArray) -> float:
    """Where on the polyline the point nearest to a place lies, in points and shares of the way to the next."""
    step = np.diff(points, axis=0)
    u = np.clip(((place - points[:-1]) * step).sum(axis=1) / (step**2).sum(axis=1), 0.0, 1.0)
    off = np.linalg.norm(points[:-1] + u[:, None] * step - place, axis=1)
    i = int(np.argmin(off))
    return i + float(u[i])


def _length(points: FloatArray) -> float:
    return float(np.linalg.norm(np.diff(points, axis=0), axis=1).sum())


def _total(chains: Sequence[FloatArray]) -> float:
    return sum(_length(chain) for chain in chains)


def _place(point: FloatArray) -> str:
    return "(" + ", ".join(f"{v:.4g}" for v in np.asarray(point).round(9) + 0.0) + ") mm"
