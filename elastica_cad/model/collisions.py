"""Collisions between strips of a model outside their slots, and contact of a strip with itself.

Collisions are detected at sample points. If two bodies overlap, an edge of one body is inside the other, or
two faces overlap. Edges have many samples. Faces have few samples, because the depth of an overlap varies
little over a face.
"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, replace
from itertools import combinations

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import FloatArray, IntArray
from elastica_cad._values import and_more
from elastica_cad.errors import Length, Point, note
from elastica_cad.geometry.plane_points import dot, left_of, near_pairs, norm, turns_along, unit_vectors
from elastica_cad.model.crossings import RuledStrip, strip_crossings, strips_may_meet
from elastica_cad.model.interlocking import (
    SHALLOW_RAD,
    TOUCHING_RAD,
    Joint,
    place_between,
    slot_width,
    strip_thickness,
)
from elastica_cad.strip.slots import slot_cut
from elastica_cad.strip.strip import Placed, Strip, strip_names

SHARED_MM = 0.05
"""Largest overlap, mm, of slotted strips that counts as contact."""

EDGES_TOUCH_MM = 0.1
"""Largest permitted overlap, mm, of strips that meet edge to edge. Such an overlap can be filed off."""

INSCRIBED_SQUARE = np.sqrt(0.5)
"""Side of the inscribed square that replaces a round section, divided by the diameter."""

Places = tuple[float, float]


@dataclass(frozen=True, eq=False)
class Collision:
    """Position at which two strips overlap.

    Attributes
    ----------
    places : (float, float)
        Arc lengths of the position on both strips, mm.
    depth : float
        Depth of the overlap, mm.
    position : (3,) array
        Position in space, mm.
    """

    places: Places
    depth: float
    position: FloatArray


@dataclass(frozen=True, eq=False)
class Body:
    """Bent strip without tabs: ruled middle surface, thickness (mm), and the strip with its slots."""

    ruled: RuledStrip
    thickness: float
    strip: Strip

    @classmethod
    def of(cls, placed: Placed) -> "Body":
        """Return the body of a placed strip. A tapered strip has its least thickness everywhere.

        A round section is replaced by its inscribed square.
        """
        strip = placed.strip
        ruled = RuledStrip(strip.rod.curve, placed.frame, strip.width)
        for quantity, size in strip.tapered.items():
            thinnest = float(size.extremes[0])
            if quantity == "thickness":
                return cls(ruled, thinnest, strip)
            width = replace(ruled.width, coefficients=INSCRIBED_SQUARE * ruled.width.coefficients)
            return cls(replace(ruled, width=width), INSCRIBED_SQUARE * thinnest, strip)
        return cls(ruled, strip_thickness(strip), strip)

    def samples(self, inset: float) -> tuple[FloatArray, FloatArray, FloatArray, FloatArray]:
        """Return sample points of edges and faces in the flat pattern, `inset` mm inside the outline.

        The result has arc lengths (n,), distances (n,) from the centre line, and points and tangents of the
        curve, (n, 2) each.
        """
        length = self.ruled.length
        first, last = min(inset, length / 2), max(length - inset, length / 2)
        widest = self.ruled.width.extremes[1]
        # distances between samples along edges and on faces, mm
        (along, ends), face = (
            (_evenly_spaced(first, last, pitch), _evenly_spaced(-1.0, 1.0, 2 * pitch / widest))
            for pitch in (0.2, 2.0)
        )
        # long edges, both ends, and faces; distances from the centre line are fractions of half the width
        grids = (along, [-1.0, 1.0]), ([first, last], ends), face
        s, share = np.concatenate([np.reshape(np.meshgrid(x, y), (2, -1)) for x, y in grids], axis=1)
        return s, share * np.maximum(self.ruled.half_width(s) - inset, 0.0), *self.ruled.in_plane(s)

    def stations_near(self, points: FloatArray, reach: float) -> tuple[IntArray, FloatArray]:
        """Return the indices (k,) of the points (n, 2) that may be within `reach` mm of the curve.

        Also return the arc lengths (k,) of the stations nearest to these points.
        """
        stations = self.ruled.stations
        line = self.ruled.in_plane(stations)[0]
        i, k = near_pairs(points, line, reach + float(np.diff(stations).max()))
        # of each point, take the pair with the nearest station
        order = np.lexsort((norm(points[i] - line[k]), i))
        first = order[np.diff(i[order], prepend=-1) > 0]
        return i[first], stations[k[first]]

    def nearest(self, points: FloatArray, s: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Return arc lengths (n,), points and tangents of the curve where it is nearest to points (n, 2).

        The search starts at the arc lengths `s`.
        """
        # three Newton steps, which start at near stations
        for _ in range(3):
            place, tangent = self.ruled.in_plane(s)
            s = (s + dot(points - place, tangent)).clip(0.0, self.ruled.length)
        return s, *self.ruled.in_plane(s)

    @cached_property
    def _slot_polygons(self) -> list[FloatArray]:
        # each slot is extended beyond the edge of its strip by four times its width
        cuts = (slot_cut(slot, self.strip.width, beyond=4.0 * slot.width) for slot in self.strip.slots)
        return [cut.points(0.002) for cut in cuts]

    def distance_from_slots(self, s: FloatArray, across: FloatArray) -> FloatArray:
        """Return distances (n,), mm, of points of the flat pattern from the nearest slot, negative in a slot."""
        away = np.full(s.size, np.inf)
        for rim in self._slot_polygons:
            (x, y), (dx, dy) = rim.T, (np.roll(rim, -1, axis=0) - rim).T
            left, down = s[:, None] - x, across[:, None] - y
            where = ((left * dx + down * dy) / (dx**2 + dy**2)).clip(0.0, 1.0)
            off = np.hypot(where * dx - left, where * dy - down).min(axis=1)
            # a ray from a point inside a polygon crosses an odd number of sides
            beside = ((down >= 0) != (down >= dy)) & ((left * dy < down * dx) == (dy > 0))
            away = np.minimum(away, np.where(beside.sum(axis=1) % 2 == 1, -off, off))
        return away


def _evenly_spaced(low: float, high: float, pitch: float) -> FloatArray:
    return np.linspace(low, high, max(2, int(np.ceil((high - low) / pitch)) + 1))


def deepest_collision(
    first: Body,
    second: Body,
    slot_distance: float = 0.0,
    least: float = SHARED_MM,
    *,
    is_flush: bool = False,
) -> Collision | None:
    """Return the deepest overlap of two strips, or None if no depth exceeds `least`, mm.

    Only places at least `slot_distance` mm away from all slots count. `is_flush` is True for strips side by side,
    without slots.
    """
    in_second, in_first = (
        _deepest_sample(a, b, slot_distance, least, is_flush=is_flush)
        for a, b in ((first, second), (second, first))
    )
    if in_first is not None and (in_second is None or in_first.depth > in_second.depth):
        return Collision(in_first.places[::-1], in_first.depth, in_first.position)
    return in_second


def _deepest_sample(
    a: Body, b: Body, slot_distance: float, least: float, *, is_flush: bool
) -> Collision | None:
    """Return the sample of strip `a` that is deepest inside strip `b`, or None if no depth exceeds `least`, mm.

    Samples are slightly below both faces of `a`. If the strips are flush (side by side), samples are on the
    middle surface of `a`.
    """
    inset = least if is_flush else min(least / 2, a.thickness / 4, b.thickness / 4)
    heights = [0.0] if is_flush else [inset - a.thickness / 2, a.thickness / 2 - inset]
    # distance, mm, of a sample from the middle surface of `b` at which the strips touch
    thick = (a.thickness + b.thickness) / 2 if is_flush else b.thickness / 2
    s, across, place, tangent = a.samples(inset)
    left = left_of(tangent)
    place = np.concatenate([place + height * left for height in heights])
    s, across, left = (np.concatenate([rows] * len(heights)) for rows in (s, across, left))
    local = b.ruled.frame.local(a.ruled.frame.point(place) + across[:, None] * a.ruled.axis)
    low, high = b.ruled.box + thick * np.array([[-1.0, -1.0, 0.0], [1.0, 1.0, 0.0]])
    inner = np.flatnonzero(np.all((local > low) & (local < high), axis=1))
    near, stations = b.stations_near(local[inner, :2], thick)
    s, across, left, local = (rows[inner[near]] for rows in (s, across, left, local))
    if not s.size:
        return None
    foot, there, along = b.nearest(local[:, :2], stations)
    gap = local[:, :2] - there
    # depths below the ends, and below the faces and long edges, of `b`
    ends = np.minimum(foot, b.ruled.length - foot) - np.abs(dot(gap, along))
    depth = np.minimum(thick - norm(gap), b.ruled.half_width(foot) - np.abs(local[:, 2]))
    depth = np.minimum(depth, ends) + (0.0 if is_flush else inset)
    if is_flush:
        # strips side by side have almost parallel faces
        facing = (a.ruled.frame.direction(left) * b.ruled.normal(along)).sum(axis=1)
        depth[np.abs(facing) < np.cos(SHALLOW_RAD)] = -np.inf
    else:
        # near a slot of either strip, the depth is at most the distance from the slot
        inner = np.flatnonzero(depth > least)
        for body, x, y in ((a, s, across), (b, foot, local[:, 2])):
            depth[inner] = np.minimum(
                depth[inner], body.distance_from_slots(x[inner], y[inner]) - slot_distance + inset
            )
    k = int(depth.argmax())
    if depth[k] <= least:
        return None
    return Collision((float(s[k]), float(foot[k])), float(depth[k]), b.ruled.frame.point(local[k]))


@dataclass(frozen=True, eq=False)
class _Overlap:
    """Overlap of two strips that are side by side, slotted into each other, or at an angle."""

    names: tuple[str, str]
    places: Places
    is_flush: bool = False
    beside_slots: Collision | None = None

    def message(self, more: str = "") -> str:
        (a, b), (s, r) = self.names, map(Length, self.places)
        if self.beside_slots is not None:
            return note(
                "outside the slots that join them, {a} ({s} from its start) overlaps {b} ({r} from its "
                "start) by {depth:.2g}, near {place}{more}. Turn or move one of the strips, or make them "
                "narrower there",
                a=a, s=s, depth=Length(self.beside_slots.depth), b=b, r=r, more=more,
                place=Point(self.beside_slots.position),
            )  # fmt: skip
        if self.is_flush:
            return note(
                "the sheets of {a} ({s} from its start) and {b} ({r} from its start) overlap{more}: move "
                "the strips apart, or make them narrower there",
                a=a, s=s, b=b, r=r, more=more,
            )  # fmt: skip
        return note(
            "{a} ({s} from its start) passes through {b} ({r} from its start){more}: cut slots (interlock), "
            "move the strips apart, or make them narrower there",
            a=a, s=s, b=b, r=r, more=more,
        )  # fmt: skip


def missing_slots(
    placed: Sequence[Placed], joints: Iterable[Joint] = (), *, brief: bool = False
) -> tuple[str, ...]:
    """Return a sentence for each pair of strips that overlap outside slots. Tabs are ignored.

    The sentence names the first crossing of the strips or, if they are side by side, their deepest overlap.
    For strips with a joint in `joints`, the sentence names their deepest overlap beside the slots. With
    `brief`, only the first sentence is returned, with the number of other pairs.

    Examples
    --------
    >>> missing_slots([])
    ()
    """
    meetings = _overlaps(placed, joints)
    if brief:
        return tuple(meeting.message(and_more(meetings, "pair")) for meeting in meetings[:1])
    return tuple(meeting.message() for meeting in meetings)


def _overlaps(placed: Sequence[Placed], joints: Iterable[Joint]) -> list[_Overlap]:
    """Return the overlaps of all pairs of strips.

    Slotted pairs with the same cuts and position are computed once.
    """
    names, bodies = strip_names(placed), [Body.of(strip) for strip in placed]
    widths = [member.strip.width for member in placed]
    # strips edge to edge may overlap by EDGES_TOUCH_MM
    narrower = [
        replace(body.ruled, width=replace(width, coefficients=width.coefficients - 2 * EDGES_TOUCH_MM))
        for body, width in zip(bodies, widths, strict=True)
    ]
    meeting = strips_may_meet(narrower, np.array([strip_thickness(member.strip) / 2 for member in placed]))
    # for each slotted pair of strips, the least distance, mm, from slots at which overlaps are reported
    slotted: dict[tuple[int, int], float] = {}
    for joint in joints:
        slot_distance = 0.0
        # these slots are too narrow, so overlaps within the width of an exact slot are ignored
        if joint.fit == "paper":
            thick = max(strip_thickness(placed[i].strip) for i in joint.members)
            slot_distance = float(slot_width(np.array(joint.angle[0]), own=thick, other=thick, clearance=0.0))
        slotted[joint.members] = max(slot_distance, slotted.get(joint.members, 0.0))
    meetings = []
    clear: set[tuple[float, ...]] = set()
    for i, j in combinations(range(len(placed)), 2):
        pair, strips = (names[i], names[j]), (placed[i].strip, placed[j].strip)
        if (i, j) in slotted:
            # strips with the same cut share their layers, so their `id` identifies the cut
            cut = (id(strip.layers) for strip in strips)
            alike = *cut, slotted[i, j], *place_between(placed[i].frame, placed[j].frame)
            if alike in clear:
                continue
            if (hit := deepest_collision(bodies[i], bodies[j], slotted[i, j])) is None:
                clear.add(alike)
            else:
                meetings.append(_Overlap(pair, hit.places, beside_slots=hit))
        elif meeting[i, j]:
            if (places := _crossing_without_slot(strips, (narrower[i], narrower[j]))) is not None:
                meetings.append(_Overlap(pair, places))
                continue
            least = min(EDGES_TOUCH_MM, bodies[i].thickness / 2, bodies[j].thickness / 2)
            hit = deepest_collision(bodies[i], bodies[j], least=least, is_flush=True)
            if hit is not None and not _has_slot_at(strips, *np.array(hit.places)[:, None]):
                meetings.append(_Overlap(pair, hit.places, is_flush=True))
    return meetings


def _crossing_without_slot(
    strips: tuple[Strip, Strip], surfaces: tuple[RuledStrip, RuledStrip]
) -> Places | None:
    """Return the places, mm along both strips, at which they cross at an angle without a slot, or None."""
    for crossing in strip_crossings(*surfaces):
        _, _, points = crossing.course
        if points.angle.max() < TOUCHING_RAD or crossing.length < strip_thickness(strips[0]):
            continue
        if not _has_slot_at(strips, points.first[:, 0], points.second[:, 0]):
            return float(points.first[:, 0].mean()), float(points.second[:, 0].mean())
    return None


def _has_slot_at(strips: tuple[Strip, Strip], first: FloatArray, second: FloatArray) -> bool:
    # `first` and `second` (n,) are arc lengths, mm, of the overlap on both strips
    return any(
        abs(slot.at - np.clip(slot.at, stations.min(), stations.max())) < slot.width + strip_thickness(strip)
        for strip, stations in zip(strips, (first, second), strict=True)
        for slot in strip.slots
    )


def self_contact(strip: Strip) -> Places | None:
    """Return the two arc lengths, mm, at which the bent strip touches itself, or None without contact.

    Arc lengths on tabs are below 0 or above the length. Contact in the lap of a closed strip or at a slot is
    ignored.

    Examples
    --------
    >>> from elastica_cad.mechanics.sheets import Sheet
    >>> from elastica_cad.mechanics.rod import Rod
    >>> self_contact(Strip(Rod.straight(100), Sheet.named("card-200gsm"), max_width=20)) is None
    True
    """
    rod, turned = strip.rod, turns_along(strip.rod.angle)
    # a curve turns by at least half a turn before it meets itself
    if np.ptp(rod.angle) < np.pi:
        return None
    size = strip.layout.size
    thickness = strip.layers[-1].high if size is None else float(size.extremes[1])
    start, end = (0.0, 0.0) if strip.is_closed else (tab.length for tab in strip.ends)
    long = rod.length + start + end
    # samples a quarter of the thickness apart, or farther apart on a long strip
    count = min(20_000, int(long / (0.25 * thickness)) + 2)
    s = np.linspace(-start, rod.length + end, count)
    inner = s.clip(0.0, rod.length)
    x, y, angle, turn = (np.interp(inner, rod.s, row) for row in (*rod.position.T, rod.angle, turned))
    middle = np.column_stack([x, y]) + (s - inner)[:, None] * unit_vectors(angle)
    pairs = np.transpose(near_pairs(middle, middle, max(thickness, long / count)))
    # neighbouring samples are always close; between places of contact, the curve turns
    between = np.abs(np.diff(turn[pairs], axis=1)[:, 0])
    if strip.is_closed:
        between = np.minimum(between, turned[-1] - between)
    pairs = pairs[between > np.pi / 2]
    if not len(pairs):
        return None
    first, second = np.sort(s[pairs[norm(middle[pairs[:, 1]] - middle[pairs[:, 0]]).argmin()]])
    if any(
        abs(slot.at - place) < slot.width + thickness for slot in strip.slots for place in (first, second)
    ):
        return None
    return float(first), float(second)
