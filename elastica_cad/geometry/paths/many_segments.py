"""Many segments and paths at one go: points, parts, lengths, and polylines that follow them."""

from collections.abc import Iterator, Sequence

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.paths.chords import MOST_ROUNDS, PROBES, chord_errors, chord_points
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.segments import Segment, Spline
from elastica_cad.geometry.paths.spline_table import SplineTable
from elastica_cad.geometry.paths.trim import trim_segment

FEW = 8
"""Splines that are as fast one after the other."""


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
            self._tables.append(SplineTable.of([curves[i] for i in members]))

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
                    parts[i] = Spline(curve)
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
    total, owner = np.zeros(len(paths)), []
    for k, path in enumerate(paths):
        for segment in path.segments:
            if isinstance(segment, Spline) and not segment.curve.is_rational:
                owner.append(k)
            else:
                total[k] += segment.swept_area(path.start)
    starts = np.array([path.start for path in paths])
    for rows, table in _tables([spline.curve for spline in splines]):
        of_path = np.array(owner)[rows]
        np.add.at(total, of_path, table.swept_areas(starts[of_path]))
    return total


def polylines(paths: Sequence[Path], tolerance: float) -> list[FloatArray]:
    """The points (n, 2) of each path whose polyline stays within `tolerance` mm of it: see `Path.points`.

    Examples
    --------
    >>> [len(points) for points in polylines([Path.rectangle(4.0, 3.0)], 0.1)]
    [4]
    """
    splines = _splines(paths)
    if len(splines) < FEW:
        return [path.points(tolerance) for path in paths]
    chords: dict[int, FloatArray] = {}
    for rows, table in _tables([spline.curve for spline in splines]):
        for spline, points in zip((splines[i] for i in rows), _chords(table, tolerance), strict=True):
            chords[id(spline)] = points
    found = []
    for path in paths:
        parts = [
            (chords[id(segment)] if isinstance(segment, Spline) else chord_points(segment, tolerance))[:-1]
            for segment in path.segments
        ]
        points = np.concatenate(parts if path.closed else [*parts, path.end[None]])
        # a thin lens keeps its inside: `Path.points` sees to that
        found.append(points if len(points) > 2 else path.points(tolerance))
    return found


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


def _splines(paths: Sequence[Path]) -> list[Spline]:
    return [segment for path in paths for segment in path.segments if isinstance(segment, Spline)]


def _tables(curves: Sequence[PlaneCurve]) -> Iterator[tuple[list[int], SplineTable]]:
    """The curves in tables of one degree and of about as many knots, with their places in the list."""
    alike: dict[tuple[int, int], list[int]] = {}
    for i, curve in enumerate(curves):
        alike.setdefault((curve.degree, curve.knots.size.bit_length()), []).append(i)
    for rows in alike.values():
        yield rows, SplineTable.of([curves[i] for i in rows])


def _chords(table: SplineTable, tolerance: float) -> list[FloatArray]:
    """Points of each curve of a table: spans are halved until their probes lie near enough to their chords."""
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
    return _sorted(table, np.concatenate(kept_owner), np.concatenate(kept_u), np.concatenate(kept_points))


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


def _sorted(table: SplineTable, owner: IntArray, u: FloatArray, points: FloatArray) -> list[FloatArray]:
    """Points curve by curve in the order of the parameter, the last points added."""
    count = len(table.curves)
    last = np.ones(count)
    owner, u = np.concatenate([owner, np.arange(count)]), np.concatenate([u, last])
    points = np.concatenate([points, table.motion(np.arange(count), last)[0]])
    order = np.lexsort((u, owner))
    return np.split(points[order], np.cumsum(np.bincount(owner, minlength=count))[:-1])
