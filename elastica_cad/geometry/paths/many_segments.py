"""Many segments and paths at one go: points, parts, lengths, and polylines that follow them."""

from collections.abc import Iterator, Sequence

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.paths.chords import (
    MOST_ROUNDS,
    PROBES,
    arc_parts,
    chord_errors,
    chord_points,
    require_tolerance_mm,
)
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.segments import Arc, Line, Segment, Spline
from elastica_cad.geometry.paths.spline_table import SplineTable
from elastica_cad.geometry.paths.trim import trim_segment
from elastica_cad.geometry.polynomials.circles import points_on_circles, swept_by
from elastica_cad.geometry.running_sums import numbers_in_groups

FEW = 8
"""Segments that are as fast one after the other."""


class ManySegments:
    """Lines, arcs and splines under their numbers; splines of one degree are worked on together."""

    def __init__(self, segments: Sequence[Segment]) -> None:
        self.segments = segments
        curves = {i: segment.curve for i, segment in enumerate(segments) if isinstance(segment, Spline)}
        self._table = np.full(len(segments), -1)
        self._row = np.zeros(len(segments), dtype=int)
        self._tables: list[SplineTable] = []
        for degree in sorted({curve.degree for curve in curves.values()}):
            members = [i for i, curve in curves.items() if curve.degree == degree]
            self._table[members], self._row[members] = len(self._tables), np.arange(len(members))
            self._tables.append(SplineTable([curves[i] for i in members]))

    def motion(self, which: IntArray, u: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Points and their derivatives by u (n, 2), mm, at places u (n,) in [0, 1] of segments (n,)."""
        position, velocity = np.empty((which.size, 2)), np.empty((which.size, 2))
        number = self._table[which]
        for i in np.flatnonzero(number < 0).tolist():
            position[i], velocity[i] = self.segments[int(which[i])].motion_at(float(u[i]))
        for k, table in enumerate(self._tables):
            mine = np.flatnonzero(number == k)
            if mine.size:
                position[mine], velocity[mine] = table.motion(self._row[which[mine]], u[mine])
        return position, velocity

    def trimmed(self, first: FloatArray, last: FloatArray) -> list[Segment | None]:
        """The parts between places first <= last (n,) of all segments; None where there is none."""
        parts: list[Segment | None] = [None] * len(self.segments)
        some, whole = first < last, (first == 0) & (last == 1)
        for i in np.flatnonzero(whole).tolist():
            parts[i] = self.segments[i]
        some &= ~whole
        for i in np.flatnonzero(some & (self._table < 0)).tolist():
            parts[i] = trim_segment(self.segments[i], float(first[i]), float(last[i]))
        for k, table in enumerate(self._tables):
            mine = np.flatnonzero(some & (self._table == k))
            if mine.size:
                rows = self._row[mine]
                low, high = table.domain[rows].T
                ends = (low * (1 - u) + high * u for u in (first[mine], last[mine]))
                for i, curve in zip(mine.tolist(), table.chosen(rows).trimmed(*ends), strict=True):
                    parts[i] = Spline.of_clamped(curve)
        return parts


def total_length(paths: Sequence[Path]) -> float:
    """Sum of the lengths of paths, mm; each path then knows its own.

    Examples
    --------
    >>> total_length([Path.rectangle(4.0, 3.0), Path.rectangle(1.0, 1.0)])
    18.0
    """
    unknown = [path for path in paths if "length" not in vars(path)]
    plain = [spline for spline in _splines(unknown) if not spline.curve.is_rational]
    if len(plain) >= FEW:
        known = dict[int, float]()
        for rows, table in _tables([spline.curve for spline in plain]):
            known.update(zip((id(plain[i]) for i in rows), table.lengths.tolist(), strict=True))
        for path in unknown:
            vars(path)["length"] = sum(known.get(id(one)) or one.length for one in path.segments)
    return sum(path.length for path in paths)


def areas(paths: Sequence[Path]) -> FloatArray:
    """The signed areas (n,) of closed paths, mm2: see `Path.area`; each path then knows its own.

    Examples
    --------
    >>> areas([Path.rectangle(4.0, 3.0), Path.rectangle(1.0, 1.0).reversed()]).tolist()
    [12.0, -1.0]
    """
    unknown = [path for path in paths if path.closed and "area" not in vars(path)]
    splines = [spline for spline in _splines(unknown) if not spline.curve.is_rational]
    if len(splines) >= FEW:
        for path, area in zip(unknown, _areas(unknown, splines).tolist(), strict=True):
            vars(path)["area"] = area
    return np.array([path.area for path in paths], dtype=float)


def _areas(paths: Sequence[Path], splines: Sequence[Spline]) -> FloatArray:
    """Areas (n,) of closed paths, their splines without weights in order at one go."""
    total, owner, starts = np.zeros(len(paths)), [], np.array([path.start for path in paths])
    plain, shapes = [], []
    for k, path in enumerate(paths):
        for segment in path.segments:
            if isinstance(segment, Spline):
                if segment.curve.is_rational:
                    total[k] += segment.swept_area(path.start)
                else:
                    owner.append(k)
            else:
                plain.append(k)
                turn = (segment.radius, segment.sweep) if isinstance(segment, Arc) else (0.0, 0.0)
                shapes.append((*segment.start, *segment.end, *turn))
    if plain:
        x, y, x1, y1, radius, sweep = np.array(shapes).T
        origins = starts[plain]
        np.add.at(
            total,
            plain,
            swept_by(np.array([x, y]).T - origins, np.array([x1, y1]).T - origins, radius, sweep),
        )
    for rows, table in _tables([spline.curve for spline in splines]):
        of_path = np.array(owner)[rows]
        np.add.at(total, of_path, table.swept_areas(starts[of_path]))
    return total


def bounds_of(paths: Sequence[Path]) -> FloatArray:
    """The boxes (n, 2, 2) of paths, mm: see `Path.bounds`; each path then knows its own.

    Examples
    --------
    >>> bounds_of([Path.rectangle(4.0, 3.0), Path.circle((0.0, 0.0), 1.0)])[0].tolist()
    [[0.0, 0.0], [4.0, 3.0]]
    """
    unknown = [path for path in paths if "bounds" not in vars(path)]
    if len(unknown) >= FEW:
        segments = [segment for path in unknown for segment in path.segments]
        begins = _begins([len(path.segments) for path in unknown])
        starts, ends = np.array([one.start for one in segments]), np.array([one.end for one in segments])
        low, high = np.minimum(starts, ends), np.maximum(starts, ends)
        arcs = [i for i, segment in enumerate(segments) if isinstance(segment, Arc)]
        if arcs:
            least, most = _boxes_of_arcs([one for one in segments if isinstance(one, Arc)])
            low[arcs], high[arcs] = np.minimum(low[arcs], least), np.maximum(high[arcs], most)
        boxes = np.stack([np.minimum.reduceat(low, begins), np.maximum.reduceat(high, begins)], axis=1)
        splines = [i for i, segment in enumerate(segments) if isinstance(segment, Spline)]
        if splines:
            hulls = [one.curve.control_points for one in segments if isinstance(one, Spline)]
            every, first = np.concatenate(hulls), _begins([len(hull) for hull in hulls])
            low[splines], high[splines] = np.minimum.reduceat(every, first), np.maximum.reduceat(every, first)
        # where the control points of a path reach no farther, its splines do not either
        sure = np.all(np.minimum.reduceat(low, begins) >= boxes[:, 0], axis=1)
        sure &= np.all(np.maximum.reduceat(high, begins) <= boxes[:, 1], axis=1)
        for path, box, is_sure in zip(unknown, boxes, sure.tolist(), strict=True):
            if is_sure:
                vars(path)["bounds"] = box
    return np.array([path.bounds for path in paths]).reshape(-1, 2, 2)


def _boxes_of_arcs(arcs: Sequence[Arc]) -> tuple[FloatArray, FloatArray]:
    """Lower left and upper right corners (n, 2): where arcs end, and where they turn."""
    center = np.array([arc.center for arc in arcs])
    radius, *ends = np.array([(arc.radius, arc.start_angle, arc.end_angle) for arc in arcs]).T
    low, high = np.minimum(*ends), np.maximum(*ends)
    quarters = np.pi / 2 * (np.ceil(low / (np.pi / 2))[:, None] + np.arange(5))
    angles = np.column_stack([low, high, np.where(quarters <= high[:, None], quarters, low[:, None])])
    points = points_on_circles(center[:, None], radius[:, None], angles)
    return points.min(axis=1), points.max(axis=1)


def _begins(counts: Sequence[int]) -> IntArray:
    """Where groups of so many begin that stand one behind the other."""
    return np.asarray(np.cumsum(counts) - counts)


def polylines(paths: Sequence[Path], tolerance: float) -> list[FloatArray]:
    """The points (n, 2) of each path whose polyline stays within `tolerance` mm of it: see `Path.points`.

    Examples
    --------
    >>> [len(points) for points in polylines([Path.rectangle(4.0, 3.0)], 0.1)]
    [4]
    """
    if sum(len(path.segments) for path in paths) < FEW:
        return [path.points(tolerance) for path in paths]
    counts, points = chords_of([segment for path in paths for segment in path.segments], tolerance)
    lengths = np.array([len(path.segments) for path in paths])
    sizes = np.add.reduceat(counts, np.cumsum(lengths) - lengths)
    found = []
    for path, own in zip(paths, np.split(points, np.cumsum(sizes)[:-1]), strict=True):
        whole = own if path.closed else np.concatenate([own, path.end[None]])
        # a thin lens keeps its inside: `Path.points` sees to that
        found.append(whole if len(whole) > 2 else path.points(tolerance))
    return found


def chords_of(segments: Sequence[Segment], tolerance: float) -> tuple[IntArray, FloatArray]:
    """Points on segments, one behind the other, whose chords stay within `tolerance` mm of them.

    Returns
    -------
    (m,) int array, (n, 2) array
        How many each segment has, and the points; its last one is left out, for there the next one begins.

    Examples
    --------
    >>> counts, points = chords_of(Path.rectangle(4.0, 3.0).segments, 0.1)
    >>> counts.tolist(), points[1].tolist()
    ([1, 1, 1, 1], [4.0, 0.0])
    """
    counts, parts = np.zeros(len(segments), dtype=int), list[tuple[IntArray, FloatArray]]()
    for which, own, points in _chords_by_kind(segments, require_tolerance_mm(tolerance)):
        counts[which] = own
        parts.append((which, points))
    begins = np.cumsum(counts) - counts
    rows = np.empty((int(counts.sum()), 2))
    for which, points in parts:
        rows[numbers_in_groups(counts[which]) + np.repeat(begins[which], counts[which])] = points
    return counts, rows


def _chords_by_kind(
    segments: Sequence[Segment], tolerance: float
) -> Iterator[tuple[IntArray, IntArray, FloatArray]]:
    """Numbers (k,) of segments of one kind, how many points each has, and these (n, 2) in order."""
    lines = [(i, segment.start) for i, segment in enumerate(segments) if isinstance(segment, Line)]
    if lines:
        yield np.array([i for i, _ in lines]), np.ones(len(lines), dtype=int), np.array([p for _, p in lines])
    arcs = [(i, segment) for i, segment in enumerate(segments) if isinstance(segment, Arc)]
    if arcs:
        yield np.array([i for i, _ in arcs]), *_arc_chords([arc for _, arc in arcs], tolerance)
    splines = [(i, segment) for i, segment in enumerate(segments) if isinstance(segment, Spline)]
    which = np.array([i for i, _ in splines])
    if len(splines) >= FEW:
        for rows, table in _tables([spline.curve for _, spline in splines]):
            yield which[rows], *_chords(table, tolerance)
    elif splines:
        points = [chord_points(spline, tolerance)[:-1] for _, spline in splines]
        yield which, np.array([len(own) for own in points]), np.concatenate(points)


def _arc_chords(arcs: Sequence[Arc], tolerance: float) -> tuple[IntArray, FloatArray]:
    """Of each arc how many points it has, without its last one, and all points."""
    center = np.array([arc.center for arc in arcs])
    radius, start_angle, sweep = np.array([(arc.radius, arc.start_angle, arc.sweep) for arc in arcs]).T
    counts = arc_parts(radius, sweep, tolerance).astype(int)
    each = np.repeat(np.arange(counts.size), counts)
    share = numbers_in_groups(counts) * (1.0 / np.maximum(counts, 1))[each]
    angle = start_angle[each] + sweep[each] * share
    return counts, points_on_circles(center[each], radius[each], angle)


def points_of(curves: Sequence[PlaneCurve], which: IntArray, t: FloatArray) -> FloatArray:
    """Points (n, 2) of curves (n,) at parameters (n,) of their own, mm.

    Examples
    --------
    >>> lines = [PlaneCurve.line((0.0, y), (2.0, y)) for y in (0.0, 1.0)]
    >>> points_of(lines, np.array([1, 0]), np.array([0.5, 0.25])).tolist()
    [[1.0, 1.0], [0.5, 0.0]]
    """
    points = np.empty((t.size, 2))
    if len(curves) < FEW:
        for k, curve in enumerate(curves):
            own = which == k
            points[own] = curve.evaluate(t[own])
        return points
    for rows, table in _tables(curves):
        place = np.full(len(curves), -1)
        place[rows] = np.arange(len(rows))
        own = place[which] >= 0
        row, (first, last) = place[which[own]], table.domain.T
        points[own] = table.motion(row, (t[own] - first[row]) / (last - first)[row])[0]
    return points


def bezier_points(curves: Sequence[PlaneCurve]) -> tuple[IntArray, FloatArray]:
    """Of curves of one degree how many spans each has, and the Bezier points of all, (k, degree + 1, 2), mm.

    Examples
    --------
    >>> counts, points = bezier_points([PlaneCurve.spline([(0, 0), (1, 2), (3, 2), (4, 0)], degree=2)])
    >>> counts.tolist(), points[:, -1].tolist()
    ([2], [[2.0, 2.0], [4.0, 0.0]])
    """
    counts, parts = np.zeros(len(curves), dtype=int), list[tuple[IntArray, FloatArray]]()
    for rows, table in _tables(curves):
        owner, pieces = table.bezier
        which = np.array(rows)[owner]
        counts += np.bincount(which, minlength=len(curves))
        parts.append((which, pieces[..., :2] / pieces[..., 2:]))
    order = np.argsort(np.concatenate([which for which, _ in parts]), kind="stable")
    return counts, np.concatenate([points for _, points in parts])[order]


def _splines(paths: Sequence[Path]) -> list[Spline]:
    return [segment for path in paths for segment in path.segments if isinstance(segment, Spline)]


def _tables(curves: Sequence[PlaneCurve]) -> Iterator[tuple[list[int], SplineTable]]:
    """The curves in tables of one degree and of about as many knots, with their places in the list."""
    alike: dict[tuple[int, int], list[int]] = {}
    for i, curve in enumerate(curves):
        alike.setdefault((curve.degree, curve.knots.size.bit_length()), []).append(i)
    for rows in alike.values():
        yield rows, SplineTable([curves[i] for i in rows])


def _chords(table: SplineTable, tolerance: float) -> tuple[IntArray, FloatArray]:
    """Of each curve of a table how many points it has, without its last one, and all points.

    Spans are halved until their probes lie near enough to their chords.
    """
    owner, low, high = _first_chords(table)
    kept_owner, kept_u, kept_points = [], [], []
    begins, ends = table.motion(owner, low)[0], table.motion(owner, high)[0]
    for _ in range(MOST_ROUNDS):
        probes = low[:, None] + (high - low)[:, None] * PROBES
        points = table.motion(np.repeat(owner, PROBES.size), probes.ravel())[0].reshape(*probes.shape, 2)
        bad = chord_errors(begins, ends, points) > 0.95 * tolerance
        good = ~bad
        kept_owner.append(owner[good])
        kept_u.append(low[good])
        kept_points.append(begins[good])
        if not bad.any():
            break
        middle = low[bad] + (high[bad] - low[bad]) / 2
        between = points[bad, PROBES.size // 2]
        owner = np.tile(owner[bad], 2)
        low, high = np.concatenate([low[bad], middle]), np.concatenate([middle, high[bad]])
        begins = np.concatenate([begins[bad], between])
        ends = np.concatenate([between, ends[bad]])
    else:
        kept_owner.append(owner)
        kept_u.append(low)
        kept_points.append(begins)
    owner, u = np.concatenate(kept_owner), np.concatenate(kept_u)
    order = np.lexsort((u, owner))
    return np.bincount(owner, minlength=len(table.curves)), np.concatenate(kept_points)[order]


def _first_chords(table: SplineTable) -> tuple[IntArray, FloatArray, FloatArray]:
    """From knot to knot, and cut in the middle: whose each is, and its ends u in [0, 1]."""
    row, start, _ = table.spans
    (first, last), each = table.domain.T, np.arange(len(table.curves))
    u = np.concatenate(
        [(start - first[row]) / (last - first)[row], np.full(each.size, 0.5), np.ones(each.size)]
    )
    owner = np.concatenate([row, each, each])
    order = np.lexsort((u, owner))
    u, owner = u[order], owner[order]
    spans = (owner[:-1] == owner[1:]) & (u[:-1] < u[1:])
    return owner[:-1][spans], u[:-1][spans], u[1:][spans]
