"""Where two strips that are slotted together run into each other away from their slots, at whatever angle.

Of two bodies that share material, an edge of one reaches into the other, or they lie face on face. Edges and faces
are divided where the depth, which changes by no more than the way between two places, may be larger than any found.
"""

from dataclasses import dataclass
from functools import cached_property, lru_cache
from itertools import product

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.fabrication.interlocking.flush_strips import Slab, nearest_places
from elastica_cad.fabrication.interlocking.ruled_strip import RuledStrip
from elastica_cad.fabrication.slots.slot import Slot, slot_cut
from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.geometry.boxes import box_about
from elastica_cad.geometry.curves.curve_derivatives import cross
from elastica_cad.geometry.paths.profile import Profile
from elastica_cad.geometry.paths.segments import Line, Segment

SHARED_MM = 0.05
"""Strips that reach less deep into each other only touch."""

LONG_MM = 16.0
"""Parts of edges and faces that are looked at first."""

FINE_MM = 0.1
"""Edges are followed to this: where two cross, the depth rises and falls with the way."""

SMOOTH_MM = 3.0
"""Faces are followed to this: where they meet they run alike, and the depth is level."""

STEEP = 1.25
"""More than the change of depth over the way in the flat pattern, in strips that bend and taper."""

BEND = 0.1
"""Curvature of two strips together, 1/mm, up to which faces that run alike somewhere are seen from beside it."""

ALIKE_RAD = 0.05
"""Faces that lie in each other are told where they run alike to this."""

DEEPER = 1.1
"""A deeper place is looked for where it may be deeper by this factor."""

MOUTH = 4.0
"""Widths of a slot by which it runs on beyond the edge: its sides reach the edge at different places."""

RIM_POINTS = 13
"""On each bent side of the polygons in place of slots."""

SIDES = (-1.0, 1.0)

_SIZES = 64  # of strips whose first parts are kept: each is compared with several others


@dataclass(frozen=True, eq=False)
class Collision:
    """Where two strips share material.

    Attributes
    ----------
    places : (float, float)
        Arc lengths of both, mm.
    depth : float
        How far one reaches into the other, mm.
    position : (3,) array
        In space, mm.
    """

    places: tuple[float, float]
    depth: float
    position: FloatArray


@dataclass(frozen=True, eq=False)
class SlotRims:
    """The slots of a strip, in its flat pattern: of strips that are cut alike the same."""

    slots: tuple[Slot, ...]
    width: Profile

    @cached_property
    def _rims(self) -> tuple[FloatArray, FloatArray]:
        """Where the sides of the polygons that slots take from the flat pattern begin and end (k, 2)."""
        rims = []
        for slot in self.slots:
            cut = slot_cut(slot, self.width, beyond=MOUTH * slot.width)
            rows = [segment.at(np.linspace(0, 1, _points_on(segment)))[:-1] for segment in cut.segments]
            rims.append(np.concatenate([*rows, cut.end[None]]))
        return np.concatenate(rims), np.concatenate([np.roll(rim, -1, axis=0) for rim in rims])

    def uncut(self, s: FloatArray, across: FloatArray) -> FloatArray:
        """How far places (n,) of the flat pattern are from the nearest slot, mm: negative within it."""
        if not self.slots:
            return np.full(s.size, np.inf)
        start, end = self._rims
        (x, y), (dx, dy) = start.T, (end - start).T
        left, down = s[:, None] - x, across[:, None] - y
        where = np.clip((left * dx + down * dy) / (dx**2 + dy**2), 0.0, 1.0)
        away = np.hypot(where * dx - left, where * dy - down).min(axis=1)
        # a line from the place to one side meets the sides of polygons around it an odd number of times
        rises = (down >= 0) != (down >= dy)
        beside = rises & ((left * dy < down * dx) == (dy > 0))
        return np.asarray(np.where(beside.sum(axis=1) % 2 == 1, -away, away), dtype=float)


@dataclass(frozen=True, eq=False)
class SlottedSlab:
    """A bent strip with its thickness and slots."""

    slab: Slab
    rims: SlotRims

    @classmethod
    def of(cls, ruled: RuledStrip, strip: Strip, rims: SlotRims | None = None) -> "SlottedSlab":
        """A strip as it is cut; `rims` of one that is cut alike are used again."""
        return cls(Slab.of(ruled, strip), rims or SlotRims(strip.slots, strip.width))


def _points_on(segment: Segment) -> int:
    return 2 if isinstance(segment, Line) else RIM_POINTS


def deepest_collision(first: SlottedSlab, second: SlottedSlab, room: float = 0.0) -> Collision | None:
    """Where two strips reach deepest into each other, `room` mm and more beside all slots.

    None where no deeper than `SHARED_MM`.
    """
    found = _deepest(first, second, room, SHARED_MM)
    other = _deepest(second, first, room, SHARED_MM if found is None else found.depth * DEEPER)
    return found if other is None else Collision(other.places[::-1], other.depth, other.position)


def _deepest(one: SlottedSlab, other: SlottedSlab, room: float, least: float) -> Collision | None:
    """Where edges and faces of one strip reach more than `least` mm into another."""
    a, b, found = one.slab, other.slab, None
    inset = min(SHARED_MM / 2, a.thickness / 4, b.thickness / 4)
    wanted = least - inset
    box = box_about(b.rows[1]) + b.thickness * np.array([[-0.5], [0.5]])
    half, wide = (body.ruled.width.extremes[1] / 2 for body in (a, b))
    parts = _first_parts(a.ruled.length, a.ruled.width.extremes[1])
    while parts.size:
        s, across, local, normals = _places(a, b.ruled, parts, inset)
        reach = STEEP * np.hypot(parts[:, 3], parts[:, 4] * half)
        within = np.minimum(local[:, :2] - box[0], box[1] - local[:, :2]).min(axis=1)
        near = np.minimum(within, wide - np.abs(local[:, 2])) + reach > wanted
        parts, s, across, local, normals, reach = (x[near] for x in (parts, s, across, local, normals, reach))
        if not parts.size:
            break
        foot, depth, facing = _within(b, local, normals)
        is_edge = (parts[:, 3] == 0) | (parts[:, 4] == 0)
        near = (depth + reach > wanted) & (is_edge | (facing < ALIKE_RAD + BEND * reach))
        parts, s, across, local, reach, foot, depth = (
            x[near] for x in (parts, s, across, local, reach, foot, depth)
        )
        if not parts.size:
            break
        inner = np.flatnonzero(depth > wanted)
        for body, x, y in ((one, s, across), (other, foot, local[:, 2])):
            depth[inner] = np.minimum(depth[inner], body.rims.uncut(x[inner], y[inner]) - room)
        k = int(np.argmax(depth))
        if depth[k] > wanted:
            position = b.ruled.frame.point(local[k, :2]) + local[k, 2] * b.ruled.axis
            found = Collision((float(s[k]), float(foot[k])), float(depth[k]) + inset, position)
            wanted = DEEPER * found.depth - inset
        parts = _divided(parts[depth + reach > wanted], a.ruled)
    return found


@lru_cache(maxsize=_SIZES)
def _first_parts(length: float, width: float) -> FloatArray:
    """Parts (n, 5) of faces and edges of a strip of this length and greatest width, mm; not to be written on.

    Station, place across as share of the half width, face (-1 or 1), and half of how far they reach along and
    across; edges reach one way only.
    """
    along, across = (max(1, int(np.ceil(size / LONG_MM))) for size in (length, width))
    s, share = (np.arange(along) + 0.5) * length / along, (2 * np.arange(across) + 1.0) / across - 1.0
    long, wide = (length / along / 2,), (1.0 / across,)
    rows = [
        *product(s, share, SIDES, long, wide),
        *product(s, SIDES, SIDES, long, (0.0,)),
        *product((0.0, length), share, SIDES, (0.0,), wide),
    ]
    parts = np.array(rows)
    parts.setflags(write=False)
    return parts


def _places(
    slab: Slab, other: RuledStrip, parts: FloatArray, inset: float
) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
    """The middles of parts, a little within the body: in the flat pattern, (n,) and (n,), and in the other's frame,
    (n, 3), with normals."""
    ruled = slab.ruled
    s = np.clip(parts[:, 0], inset, ruled.length - inset)
    across = parts[:, 1] * np.maximum(ruled.half_width(s) - inset, 0.0)
    points, tangents = ruled.in_plane(s)
    left = np.column_stack([-tangents[:, 1], tangents[:, 0]])
    points = points + parts[:, 2:3] * (slab.thickness / 2 - inset) * left
    turn = other.frame.axes @ ruled.frame.axes.T
    local = other.frame.local(ruled.frame.point(points)) + across[:, None] * turn[:, 2]
    return s, across, local, left @ turn[:, :2].T


def _within(slab: Slab, points: FloatArray, normals: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Arc lengths (n,) beside which points (n, 3) of a strip's frame lie, how deep in it, and at what angle."""
    strip = slab.ruled
    foot, (place, tangent) = nearest_places(strip, slab.rows, points[:, :2])
    gap = points[:, :2] - place
    away, beyond = np.hypot(*gap.T), np.abs((gap * tangent).sum(axis=1))
    ends = np.minimum(foot, strip.length - foot) - beyond
    depth = np.minimum(slab.thickness / 2 - away, strip.half_width(foot) - np.abs(points[:, 2]))
    alike = np.abs(cross(tangent, normals))
    return foot, np.minimum(depth, ends), np.arccos(np.minimum(alike, 1.0))


def _divided(parts: FloatArray, ruled: RuledStrip) -> FloatArray:
    """Quarters of what is not fine yet: of edges along them, of faces both ways."""
    long, wide = parts[:, 3], parts[:, 4] * ruled.half_width(parts[:, 0])
    is_face = (long > 0) & (wide > 0)
    kept = 2 * np.maximum(long, wide) > np.where(is_face, SMOOTH_MM, FINE_MM)
    parts, is_face = parts[kept], is_face[kept]
    quarters = [
        _shifted(parts[chosen], np.array(steps), factor)
        for chosen, steps, factor in (
            (is_face, [*product((-0.5, 0.5), repeat=2)], 0.5),
            (~is_face, [(x, x) for x in (-0.75, -0.25, 0.25, 0.75)], 0.25),
        )
    ]
    return np.concatenate(quarters)


def _shifted(parts: FloatArray, steps: FloatArray, factor: float) -> FloatArray:
    """Copies of parts, each moved by steps (k, 2) of half its size along and across, and smaller by a factor."""
    copies = np.tile(parts, (len(steps), 1))
    copies[:, :2] += np.repeat(steps, len(parts), axis=0) * copies[:, 3:]
    copies[:, 3:] *= factor
    return copies
