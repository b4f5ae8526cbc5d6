"""Flat pattern for CAD kernels: smooth edges, divided at given stations."""

from bisect import bisect_left
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from itertools import count, groupby, pairwise
from math import ceil
from operator import itemgetter

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import InputError, Length
from elastica_cad.geometry.path import Arc, Line, Path, Segment, Spline
from elastica_cad.geometry.path_intersections import encloses
from elastica_cad.geometry.plane_curve import PlaneCurve, clamp_ends, line_crossings
from elastica_cad.geometry.plane_points import cross, norm
from elastica_cad.geometry.splines import (
    SplineFunction,
    adaptive_spline,
    greville,
    kinks,
    knot_runs,
    over_knots,
)
from elastica_cad.strip.outline import pace

SMOOTH = 2
"""Number of continuous derivatives inside an edge. Offsetting a face in a CAD kernel loses one derivative."""

RAMP_FRACTION = 2e-5
"""Length, relative to the extent in x, below which a piece between two kinks counts as a step of the width."""

SIDE_PIECES = 24
"""Number of edges of the long sides of a smoothed strip.

The second derivative of a smoothed width jumps a little at many knots, whose number changes with the curve. The
edges of a CAD model must keep their number and order, because dimensions and sketches refer to them."""

SIDE_DEGREE, SIDE_SPANS, SIDE_MM = 5, 48, 0.004
"""Degree and least number of spans of a smoothed side, and its largest distance from the drawing, mm."""


def in_smooth_pieces(path: Path, pieces: int = SIDE_PIECES) -> Path:
    """Return the loop with its splines divided at kinks.

    A step of the width becomes a line perpendicular to the strip.

    In a drawing, a side is a single spline, so that a laser cuts it without stopping. Its knots may be corners,
    and steep ramps replace steps of the width. But CAD kernels can fillet, offset and hollow only edges that are
    smooth inside. Areas do not change. Points move by at most half a ramp: 5e-6 of the length for the ramps of a
    `Profile`, and 1e-5 for the longest allowed ramp (`RAMP_FRACTION`).

    Parameters
    ----------
    pieces : int
        Number of edges of all sides together, if the second derivative of the sides jumps at so many knots or more.
        The sides are then approximated within `SIDE_MM` between steps, and kinks are rounded.

    Examples
    --------
    >>> knots = [0, 0, 0, 20, 20, 40, 40, 40]
    >>> side = Spline(PlaneCurve(knots, [(0, 0), (10, 0), (20, 0), (30, 2), (40, 4)], 2))
    >>> loop = Path([side, Line((40, 4), (0, 9)), Line((0, 9), (0, 0))], closed=True)
    >>> len(in_smooth_pieces(loop).segments)
    4
    """
    sides = [segment for segment in path.segments if isinstance(segment, Spline) and pace(segment)]
    curves = [side.curve for side in sides]
    soft, sharp = (sum(kinks(c.knots, c.degree, k).size for c in curves) for k in (SMOOTH, 1))
    each = ceil(pieces / len(sides)) if soft - sharp >= pieces else 0
    ramp = RAMP_FRACTION * float(np.ptp(path.bounds[:, 0]))
    divided = [_in_pieces(segment, ramp, each) for segment in path.segments]
    if sum(map(len, divided)) == len(path.segments) and not each:
        return path
    return Path([piece for pieces in divided for piece in pieces], path.closed)


MOST_SPANS = 6
"""Largest number of spans of an edge of a face with many edges.

OpenCASCADE computes the area of a face with a fixed number of points for each edge."""


def in_short_pieces(path: Path) -> Path:
    """Return the loop with its splines divided into pieces of at most `MOST_SPANS` spans.

    Examples
    --------
    >>> side = Spline(PlaneCurve.spline([(10.0 * k, k % 2) for k in range(20)], degree=3))
    >>> loop = Path([side, Line(side.end, (0, 9)), Line((0, 9), side.start)], closed=True)
    >>> len(in_short_pieces(loop).segments)
    5
    """
    pieces: list[Segment] = []
    for segment in path.segments:
        if isinstance(segment, Spline):
            knots = np.unique(segment.curve.knots).tolist()
            ends = pairwise([*knots[:-1:MOST_SPANS], knots[-1]])
            pieces += [Spline(segment.curve.trimmed(*piece)) for piece in ends]
        else:
            pieces.append(segment)
    return Path(pieces, path.closed)


def _in_pieces(segment: Segment, ramp: float, each: int) -> list[Segment]:
    """Return the smooth pieces of a segment. A side becomes `each` edges between its steps, if this is not 0."""
    if not isinstance(segment, Spline):
        return [segment]
    curve, even = segment.curve, pace(segment)  # `even` is (offset, speed) of a long side, and else None
    bends = kinks(curve.knots, curve.degree, SMOOTH).tolist()
    if not bends and not (even and each):
        return [segment]
    curve = clamp_ends(curve)
    first, last = curve.domain
    inner = [*_joints(even[1], bends, ramp)] if even else [(kink, kink, kink) for kink in bends]
    if even and each:
        # divide an approximated side only at ramps, which stand for steps of the width
        inner = [joint for joint in inner if joint[1] < joint[2]]
    joints = [(first, first, first), *inner, (last, last, last)]
    pieces: list[Segment] = []
    for (a, _, low), (b, high, _) in pairwise(joints):
        part = _extended(curve.trimmed(low, high), a, b)
        for piece in _approximated(part, *even, each) if even and each else [part]:
            pieces += _joined(pieces, piece)
    return pieces


def _joined(pieces: Sequence[Segment], part: PlaneCurve) -> list[Segment]:
    """Return the part as a spline that starts at the end of the pieces, or after a step."""
    if not pieces:
        return [Spline(part)]
    meeting = pieces[-1].end
    # a distance of up to 1e-5 mm is no step
    if norm(part.control_points[0] - meeting) > 1e-5:
        return [Line(meeting, part.control_points[0]), Spline(part)]
    met = np.vstack([meeting, part.control_points[1:]])
    return [Spline(PlaneCurve(part.knots, met, part.degree, part.weights))]


def _approximated(side: PlaneCurve, offset: float, speed: float, count: int) -> list[PlaneCurve]:
    """Return a side with x = offset + speed * parameter, approximated and divided into `count` edges.

    The edges have equal numbers of spans, because CAD kernels compute areas with a fixed number of points for each
    edge.
    """
    knots, y = adaptive_spline(
        SplineFunction(side.knots, side.control_points[:, 1], side.degree), side.domain,
        degree=SIDE_DEGREE, tolerance=SIDE_MM, knots=np.linspace(*side.domain, SIDE_SPANS + 1),
    )  # fmt: skip
    areas = knots[SIDE_DEGREE + 1 :] - knots[: -SIDE_DEGREE - 1]
    for end, beside in ((0, 1), (-1, -2)):
        # meet the exact end without changing the area
        y[beside] += (y[end] - side.control_points[end, 1]) * areas[end] / areas[beside]
        y[end] = side.control_points[end, 1]
    whole = PlaneCurve(
        knots, np.column_stack([offset + speed * greville(knots, SIDE_DEGREE), y]), SIDE_DEGREE
    )
    edges, _ = knot_runs(knots)
    ends = edges[np.linspace(0, edges.size - 1, count + 1).round().astype(int)].tolist()
    return [whole.trimmed(*piece) for piece in pairwise(ends)]


def _joints(speed: float, places: list[float], ramp: float) -> Iterator[tuple[float, float, float]]:
    """Yield (middle, first, last) of each group of kinks closer together than `ramp`, mm.

    `places` are the parameters of the kinks, in increasing order; the list is emptied. `speed` is the change of x
    per change of the parameter.
    """
    while places:
        first = last = places.pop(0)
        while places and (places[0] - last) * abs(speed) < ramp:
            last = places.pop(0)
        yield (first + last) / 2, first, last


def _extended(curve: PlaneCurve, first: float, last: float) -> PlaneCurve:
    """Return a clamped curve without weights, its end polynomials continued to the parameters `first` and `last`.

    The parts on both sides of a ramp between kinks then meet in its middle.
    """
    if (first, last) == curve.domain:
        return curve
    degree, knots = curve.degree, curve.knots.copy()
    knots[: degree + 1], knots[-degree - 1 :] = first, last
    points = over_knots(SplineFunction(curve.knots, curve.control_points, degree), knots, degree)
    return PlaneCurve(knots, points, degree)


ON_SEAM = 1e-7  # largest distance, mm, between a station line and a point on it


@dataclass(frozen=True, eq=False)
class SegmentPart:
    """Part of a segment in the direction of its loop.

    Attributes
    ----------
    segment : Segment
        The segment; arcs are anticlockwise.
    first, last : float
        Range of the segment's parameter: the distance for lines, the angle for arcs, the parameter of the curve
        for splines.
    forward : bool
        True if the loop follows increasing parameters.
    start, end : int
        Indices of the corners at start and end, in the direction of the loop.
    number : int
        Index of the piece. The two sides of a seam have the same index.
    seam : bool
        True for a piece on the line between two regions, which is not an edge of the pattern.
    """

    segment: Segment
    first: float
    last: float
    forward: bool
    start: int
    end: int
    number: int
    seam: bool = False


@dataclass(frozen=True, eq=False)
class Region:
    """Connected part of the pattern between two stations. `interval` is the number of stations before the part."""

    interval: int
    loops: tuple[tuple[SegmentPart, ...], ...]


@dataclass(frozen=True, eq=False)
class CutPattern:
    """A flat pattern divided into regions. `points` (k, 2), mm, are the corners to which the pieces refer."""

    points: FloatArray
    regions: tuple[Region, ...]


def on_segment(segment: Segment, t: FloatArray) -> FloatArray:
    """Return points (..., 2) of a segment at parameters `t` (...), as defined in `SegmentPart`."""
    if isinstance(segment, Spline):
        return segment.curve.evaluate(t)
    if isinstance(segment, Arc):
        return segment.at((t - segment.start_angle) / segment.sweep)
    return segment.at(t / segment.length)


def parameter_range(segment: Segment) -> tuple[float, float]:
    """Return the parameters of the ends of a segment, as defined in `SegmentPart`."""
    if isinstance(segment, Arc):
        return segment.start_angle, segment.end_angle
    return segment.curve.domain if isinstance(segment, Spline) else (0.0, segment.length)


def cut_across(outline: Path, holes: Sequence[Path], stations: Sequence[float]) -> CutPattern:
    """Divide the flat pattern at the lines x = station.

    Parameters
    ----------
    outline, holes : Path
        Closed loops; the holes are inside the outline.
    stations : sequence of float
        Positions of the lines, mm, in increasing order.
    """
    cutter = _Cutter(list(map(float, stations)))
    cutter.add(outline, backward=outline.area < 0)
    for hole in holes:
        cutter.add(hole, backward=hole.area > 0)
    return cutter.result()


@dataclass
class _Cutter:
    """Divides loops of a flat pattern at stations.

    `loops` and `chains` are the closed and open runs of pieces, by the index of the interval between stations.
    `seams` has the number and the line of each piece along a station line, by its lower and its upper corner.
    `numbers` yields the next unused number of a piece.
    """

    stations: list[float]
    points: list[FloatArray] = field(default_factory=list)
    loops: dict[int, list[list[SegmentPart]]] = field(default_factory=dict)
    chains: dict[int, list[list[SegmentPart]]] = field(default_factory=dict)
    seams: dict[tuple[int, int], tuple[int, Line]] = field(default_factory=dict)
    numbers: Iterator[int] = field(default_factory=count)

    def add(self, path: Path, *, backward: bool) -> None:
        """Split a closed loop at the stations. `backward` reverses the loop."""
        parts = [part for segment in path.segments for part in self._split(segment, len(path.segments) == 1)]
        if backward:
            parts = [(segment, a, b, not forward) for segment, a, b, forward in reversed(parts)]
        first = len(self.points)
        corners = [*range(first, first + len(parts)), first]
        pieces: list[tuple[int, SegmentPart]] = []
        for (segment, a, b, forward), (i, j) in zip(parts, pairwise(corners), strict=True):
            self.points.append(on_segment(segment, np.array(a if forward else b)))
            piece = SegmentPart(segment, a, b, forward, i, j, next(self.numbers))
            pieces.append((self._interval(piece), piece))
        intervals = [interval for interval, _ in pieces]
        if len(set(intervals)) == 1:
            self.loops.setdefault(intervals[0], []).append([piece for _, piece in pieces])
            return
        # begin at a change of the interval, so that no chain is divided at the start of the loop
        turn = next(k for k in range(len(pieces)) if intervals[k] != intervals[k - 1])
        for interval, run in groupby(pieces[turn:] + pieces[:turn], key=itemgetter(0)):
            self.chains.setdefault(interval, []).append([piece for _, piece in run])

    def result(self) -> CutPattern:
        """Return the regions between the stations, with their open chains closed along the station lines."""
        points = np.array(self.points)
        upward = points[:, 1].argsort(kind="stable")
        on_seam = [upward[np.abs(points[upward, 0] - x) < ON_SEAM].tolist() for x in self.stations]
        regions: list[Region] = []
        for interval in sorted({*self.loops, *self.chains}):
            loops = [*self.loops.get(interval, []), *self._closed(interval, on_seam)]
            regions += [Region(interval, tuple(map(tuple, group))) for group in self._grouped(loops)]
        used = [piece.number for region in regions for loop in region.loops for piece in loop if piece.seam]
        # every seam must have a region on both sides
        if len(used) != 2 * len(set(used)):
            raise InputError(
                "holes, slots or edges of the flat part touch where a tab begins: move the holes and "
                "slots there apart"
            )
        return CutPattern(points, tuple(regions))

    def _split(self, segment: Segment, alone: bool) -> Iterator[tuple[Segment, float, float, bool]]:
        """Yield (segment, first, last, forward) for each part between stations, as in `SegmentPart`.

        A segment that is `alone` in its loop has at least two parts, so that no edge begins and ends at one corner.
        """
        # clockwise arcs are reversed, because the parameter of a part must increase
        forward = not (isinstance(segment, Arc) and segment.sweep < 0)
        segment = segment if forward else segment.reversed()
        a, b = parameter_range(segment)
        cuts = sorted({t for x in self.stations for t in _crossings(segment, x) if a < t < b})
        if alone and not cuts:
            cuts = [(a + b) / 2]
        ranges = list(pairwise([a, *cuts, b]))
        for low, high in ranges if forward else reversed(ranges):
            yield segment, low, high, forward

    def _interval(self, piece: SegmentPart) -> int:
        """Return the interval of a piece; on a station line, the interval to the left of the piece's direction."""
        segment, stations = piece.segment, self.stations
        if not isinstance(segment, Line):
            middle = float(on_segment(segment, np.array((piece.first + piece.last) / 2))[0])
        else:
            (x, y), (to_x, to_y) = segment.start.tolist(), segment.end.tolist()
            middle = x + (to_x - x) * (piece.first + piece.last) / 2 / segment.length
            rises = (to_y > y) == piece.forward
            for k, station in enumerate(stations):
                if abs(station - middle) < ON_SEAM:
                    return k + (0 if rises else 1)
        return bisect_left(stations, middle)

    def _closed(self, interval: int, on_seam: list[list[int]]) -> list[list[SegmentPart]]:
        """Return the loops of an interval that its chains form with seams along the station lines."""
        chains = list(self.chains.get(interval, []))
        loops: list[list[SegmentPart]] = []
        while chains:
            loop = chains.pop(0)
            while loop[-1].end != loop[0].start:
                row, step = self._run(loop[-1].end, interval, on_seam)
                # follow the station line until a chain, or this loop, starts
                starts = {chain[0].start: chain for chain in chains} | {loop[0].start: []}
                k = row.index(loop[-1].end)
                while row[k] not in starts:
                    k += step
                    if not 0 <= k < len(row):
                        raise InputError(
                            "outlines of the flat part cross at x = {points:.6g} along the strip: "
                            "move the holes and slots there apart",
                            points=Length(self.points[loop[-1].end][0]),
                        )
                    loop.append(self._seam(row[k - step], row[k], step > 0))
                chain = starts[row[k]]
                if chain:
                    chains.remove(chain)
                    loop += chain
            loops += _split_at_repeated_corners(loop)
        return loops

    def _run(self, corner: int, interval: int, on_seam: list[list[int]]) -> tuple[list[int], int]:
        """Return the corners on the station line through `corner`, and a direction: 1 (up) or -1 (down).

        `on_seam` has the corners on each station line, in the order of y. The direction is that in which the
        boundary of the part with the index `interval` follows the line: the part is on its left.
        """
        for row, step in ((interval, 1), (interval - 1, -1)):
            if 0 <= row < len(on_seam) and corner in on_seam[row]:
                return on_seam[row], step
        raise InputError(
            "an outline of the flat part is open at x = {points:.6g} along the strip: move the holes "
            "and slots there apart",
            points=Length(self.points[corner][0]),
        )

    def _seam(self, start: int, end: int, upward: bool) -> SegmentPart:
        # return the piece between two corners of a station line; regions on both sides share its line and number
        low, high = (start, end) if upward else (end, start)
        if (low, high) not in self.seams:
            self.seams[low, high] = next(self.numbers), Line(self.points[low], self.points[high])
        number, line = self.seams[low, high]
        return SegmentPart(line, 0.0, line.length, upward, start, end, number, seam=True)

    def _grouped(self, loops: list[list[SegmentPart]]) -> list[list[list[SegmentPart]]]:
        """Return each outline (an anticlockwise loop) with the holes inside it."""
        polygons = [_polygon(loop) for loop in loops]
        areas = [cross(polygon, np.roll(polygon, -1, axis=0)).sum() for polygon in polygons]
        outer = [k for k, area in enumerate(areas) if area > 0]
        groups = {k: [loops[k]] for k in outer}
        # every other loop is a hole
        for k, polygon in enumerate(polygons):
            if k not in groups:
                home = next((o for o in outer if encloses(polygons[o], polygon[0])), outer[0])
                groups[home].append(loops[k])
        return list(groups.values())


def _split_at_repeated_corners(loop: Sequence[SegmentPart]) -> Iterator[list[SegmentPart]]:
    """Yield loops that visit each corner once, from a loop that may visit a corner several times."""
    walk: list[SegmentPart] = []
    for piece in loop:
        walk.append(piece)
        back = next((k for k, side in enumerate(walk) if side.start == piece.end), None)
        if back is not None:
            yield walk[back:]
            del walk[back:]


def _crossings(segment: Segment, x: float) -> list[float]:
    """Return the parameters, without the ends, at which a segment crosses the line at x."""
    if isinstance(segment, Line):
        a, b = float(segment.start[0]) - x, float(segment.end[0]) - x
        return [segment.length * a / (a - b)] if min(abs(a), abs(b)) > ON_SEAM and a * b < 0 else []
    if isinstance(segment, Arc):
        ratio = (x - segment.center[0]) / segment.radius
        if abs(ratio) >= 1 - 1e-12:
            return []
        turn = float(np.arccos(ratio))
        whole = 2 * np.pi * np.arange(-2, 3)
        angles = np.concatenate([turn + whole, -turn + whole])
        margin = ON_SEAM / segment.radius
        return [float(t) for t in angles if segment.start_angle + margin < t < segment.end_angle - margin]
    # a spline is inside the convex hull of its control points
    across = segment.curve.control_points[:, 0] - x
    if across.min() > -ON_SEAM or across.max() < ON_SEAM:
        return []
    roots = line_crossings(segment.curve, -x, (1.0, 0.0))
    ends = np.array([segment.start, segment.end])
    crossings = [float(root.t) for root in roots if root.kind == "crossing"]
    points = [on_segment(segment, np.array(t)) for t in crossings]
    return [t for t, p in zip(crossings, points, strict=True) if norm(ends - p).min() > ON_SEAM]


def _polygon(loop: Sequence[SegmentPart]) -> FloatArray:
    """Return points (n, 2) along a loop, enough to find what it encloses."""
    rows = []
    for piece in loop:
        count = 2 if isinstance(piece.segment, Line) else 33
        ends = (piece.first, piece.last) if piece.forward else (piece.last, piece.first)
        rows.append(on_segment(piece.segment, np.linspace(*ends, count)[:-1]))
    return np.concatenate(rows)
