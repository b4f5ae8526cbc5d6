"""Join the separate edges of a file to chains, and the edges of each chain to a curve."""

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise
from math import dist
from typing import TypeAlias

import numpy as np

from elastica_cad._types import BoolArray, FloatArray
from elastica_cad._values import SEEN_APART, distinct_digits
from elastica_cad.errors import InputError, Length, NotConvergedError
from elastica_cad.formats.edges import Edge, Run, Source, reverse_run, sample_run, size_of
from elastica_cad.formats.source_file import MOST_PIECES, check_count, check_size, check_tolerance
from elastica_cad.geometry.fairing import (
    FIT_TOLERANCE,
    SIDE_TOLERANCES,
    allowed_distance,
    fit_polyline,
    largest_distance,
    smooth_through,
)
from elastica_cad.geometry.measured_points import REPORTED_MM, MeasuredPoints, Provenance
from elastica_cad.geometry.path import nearest_by_sampling
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.geometry.plane_points import (
    begun_at,
    box_about,
    corner_points,
    is_closed,
    lengths_along,
    near_pairs,
    norm,
    project,
    sharp_points,
)
from elastica_cad.geometry.splines import bezier_spans, interpolation_sites, knot_runs
from elastica_cad.geometry.tangent_healing import heal_tangents

# largest gap, mm, between joined ends, because many files have only three decimals
JOIN_TOLERANCE = 0.01
# largest gap reported as a possible joint: in mm, and as a fraction of the smaller curve
NEAR_MM, NEAR_SHARE = 3.0, 0.1
# largest gap closed as a rounding error: in mm, and as a fraction of the smaller curve
DIGIT_MM, DIGIT_SHARE = 0.5, 0.01
# largest number of ends, of all layers, at a place where ends are joined
_MOST_ENDS = 50

# position in a run: index of the edge, and parameter on the edge
_Place: TypeAlias = tuple[int, float]

# index of a run, and its end: 0 for the start, 1 for the end
_End: TypeAlias = tuple[int, int]


@dataclass(frozen=True, eq=False)
class JoinedRuns:
    """Chains of edges, with a record of how they were joined.

    Attributes
    ----------
    chains : list of Run
    overlaps : tuple of (Source, Source, str)
        A shape, a shape at least as long that overlaps it, and the result. A coinciding shape is "left out" if
        layer and name are equal, and "kept" if they differ. Shapes that overlap in part are "joined" to their
        union. If layers or names differ, or if a third shape meets the joint, these shapes are unchanged
        ("in part").
    closed : tuple of float
        Widths, mm, of the gaps that were closed because rounding of coordinates in the file explains them.
    widest : float
        Largest gap, mm, that may be closed: the tolerance, or more if the coordinates are rounded coarsely.
    """

    chains: list[Run]
    overlaps: tuple[tuple[Source, Source, str], ...] = ()
    closed: tuple[float, ...] = ()
    widest: float = 0.0


def join_runs(
    runs: Iterable[Sequence[Edge]], tolerance: float = JOIN_TOLERANCE, *, corners: bool = True
) -> JoinedRuns:
    """Join runs of edges wherever exactly two ends are within `tolerance` mm of each other.

    A chain has the direction of its first edge in the file. Ends on different layers are not joined. Where three
    or more ends meet, none are joined, because the path of the strip is ambiguous. A named shape is not joined to
    other shapes. Of coinciding edges, the longer edge is used. Edges shorter than the tolerance are ignored.
    Finally, chains are joined across gaps of one unit of the last digit in the file.

    Parameters
    ----------
    corners : bool
        If True, also join ends where the direction turns by more than 1 degree.
    """
    check_tolerance(tolerance, "tolerance for joining")
    long = [tuple(run) for run in runs if size_of(run) > tolerance]
    if len(long) < 2:
        return JoinedRuns(long)
    distinct, overlaps = _without_overlaps(long, tolerance)
    chains, _ = _joined_runs(distinct, np.full(2 * len(distinct), tolerance / 2), corners=corners)
    reach = np.maximum(_digits_of_ends(chains), tolerance / 2)
    chains, closed = _joined_runs(chains, reach, corners=corners)
    return JoinedRuns(chains, overlaps, closed, 2 * float(reach.max()))


def _digits_of_ends(chains: Sequence[Run]) -> FloatArray:
    """Return the largest rounding error, mm, of the start and end of each of n chains (2 n,)."""
    known = [edge.source.rounding for run in chains for edge in run if edge.source and edge.source.rounding]
    sizes = np.repeat([size_of(run) for run in chains], 2)
    # largest error of an end point; 1.1 allows for rounded angles
    digit = 1.1 * np.sqrt(2.0) * min(known, default=0.0)
    return np.asarray(np.minimum(digit, np.minimum(DIGIT_MM, DIGIT_SHARE * sizes) / 2))


def _joined_runs(
    runs: Sequence[Run], reach: FloatArray, *, corners: bool
) -> tuple[list[Run], tuple[float, ...]]:
    """Join n runs to chains. Return the chains and the widths of the closed gaps.

    Two ends are joined if their distance is less than the sum of their `reach` (2 n,), mm.
    """
    partner = _partners(runs, reach, corners=corners)
    ends = _ends(runs).reshape(len(runs), 2, -1)
    chains, used, gaps = [], [False] * len(runs), []
    for first in range(len(runs)):
        if used[first]:
            continue
        forward = _follow_joints(first, 1, partner, used)
        backward = _follow_joints(first, 0, partner, used)
        # each run, with the end at which the chain leaves it: 1, or 0 (its start) if the run is reversed
        walk = [(i, 1 - side) for i, side in reversed(backward)] + [(first, 1)] + forward
        chains.append(tuple(e for i, side in walk for e in (runs[i] if side else reverse_run(runs[i]))))
        gaps += [dist(ends[i, side], ends[j, 1 - last]) for (i, side), (j, last) in pairwise(walk)]
    return chains, tuple(gaps)


def holes_on_chains(chains: Sequence[Run]) -> tuple[list[Run], list[list[Run]]]:
    """Separate drawn holes from curves. A hole is a circle on the straight end of an open chain.

    Returns
    -------
    chains : list of runs
        The chains that are not holes.
    holes : list of lists of runs
        The holes of each chain.
    """
    ended = [k for k, run in enumerate(chains) if len(run) > 1 and not _is_loop(run)]
    # for each circle, the chains on whose ends it is
    homes = {
        i: [k for k in ended if any(_is_on_edge(*circle, chains[k][end]) for end in (0, -1))]
        for i, chain in enumerate(chains)
        if (circle := _circle(chain))
    }
    curves = [i for i in range(len(chains)) if not homes.get(i)]
    return [chains[i] for i in curves], [[chains[j] for j in homes if i in homes[j]] for i in curves]


def _is_on_edge(centre: FloatArray, diameter: float, edge: Edge) -> bool:
    """Return True if a whole circle is between the ends of a line, at most a tenth of its diameter aside."""
    chord, out = edge.end - edge.start, centre - edge.start
    length = float(np.linalg.norm(chord))
    unit = chord / max(length, 1e-300)
    along = float(out @ unit)
    aside = float(np.linalg.norm(out - along * unit))
    is_inside = diameter / 2 < along < length - diameter / 2
    return len(edge.points) == 2 and is_inside and aside <= 0.1 * diameter


def _is_loop(run: Run) -> bool:
    return bool(np.linalg.norm(run[-1].end - run[0].start) <= JOIN_TOLERANCE)


def _circle(run: Run) -> tuple[FloatArray, float] | None:
    """Return the centre and the diameter of a run that is a full circle, else None."""
    if any(edge.degree < 2 or edge.weights is None for edge in run) or not _is_loop(run):
        return None
    points = sample_run(run, 9)
    centre = box_about(points).mean(axis=0)
    away = np.linalg.norm(points - centre, axis=1)
    return (centre, 2 * float(away.mean())) if np.ptp(away) <= JOIN_TOLERANCE else None


def near_ends(chains: Sequence[Run], tolerance: float) -> list[tuple[float, int, int, FloatArray]]:
    """Return pairs of unjoined ends that nearly meet: distance (mm), indices of both chains, position.

    The distance is at most 3 mm and at most a tenth of the length of the smaller chain. The list is sorted
    by distance. Ends of chains that run side by side are not listed. Ends within `tolerance` are listed if
    they were not joined because a shape has a name.
    """
    if len(chains) < 2:
        return []
    ends = _ends(chains)
    sizes = [size_of(chain) for chain in chains]
    pairs = []
    for a, b in sorted(np.transpose(near_pairs(ends, ends, NEAR_MM)).tolist()):
        if a >= b:
            continue
        i, j = a // 2, b // 2
        apart = float(np.linalg.norm(ends[a] - ends[b]))
        source, other = _source_of(chains[i]), _source_of(chains[j])
        apart_drawn = apart > tolerance or source.is_named or other.is_named
        near = i != j and apart_drawn and apart <= NEAR_SHARE * min(sizes[i], sizes[j])
        if not near or source.layer != other.layer:
            continue
        # curves that turn by more than 160 degrees where they meet run side by side
        alongside = np.cos(np.radians(160.0))
        if apart <= tolerance or _cosine_of_turn(chains, divmod(a, 2), divmod(b, 2)) > alongside:
            pairs.append((apart, i, j, ends[a]))
    return sorted(pairs, key=lambda pair: pair[0])


def _follow_joints(first: int, side: int, partner: dict[_End, _End], used: list[bool]) -> list[_End]:
    """Follow the joints from one end of the run `first`, and return the runs in order.

    `side` is this end: 0 for the start, 1 for the end. Each entry has the index of a run, and the end at which
    the chain leaves this run.
    """
    used[first] = True
    path: list[_End] = []
    here = (first, side)
    while here in partner:
        i, entered = partner[here]
        if used[i]:
            break
        used[i] = True
        here = (i, 1 - entered)
        path.append(here)
    return path


def _source_of(run: Sequence[Edge]) -> Source:
    return run[0].source or Source()


def _ends(runs: Sequence[Run]) -> FloatArray:
    # start and end of each of n runs in turn, (2 n, d)
    return np.array([point for run in runs for point in (run[0].start, run[-1].end)])


def _partners(runs: Sequence[Run], reach: FloatArray, *, corners: bool) -> dict[_End, _End]:
    """Return the partner of each end (run, side) that touches exactly one other end.

    Ends touch if their distance is at most the sum of their `reach` (2 n,), mm. They must be on one layer, and a
    named shape touches no other shape.
    """
    ends = _ends(runs)
    sources = [_source_of(run) for run in runs]
    groups = [(source.layer, source if source.is_named else None) for source in sources]
    number = {group: k for k, group in enumerate(groups)}
    group = np.repeat([number[group] for group in groups], 2)
    # the cells around an end are larger than the place where ends are joined
    i, j = near_pairs(ends, ends, 2 * float(reach.max()), most=4 * _MOST_ENDS)
    apart = np.linalg.norm(ends[i] - ends[j], axis=1)
    crowd = np.bincount(i[apart <= reach[i] + reach.max()], minlength=len(ends))
    touching = (apart <= reach[i] + reach[j]) & (group[i] == group[j]) & (crowd[i] <= _MOST_ENDS)
    i, j = i[touching], j[touching]
    # an end that touches exactly one other end counts twice, because it also touches itself
    paired = np.bincount(i, minlength=len(ends)) == 2
    partners = {}
    single = paired[i] & paired[j] & (i // 2 != j // 2)
    for pair in zip(i[single].tolist(), j[single].tolist(), strict=True):
        end, other = (divmod(k, 2) for k in pair)
        # ends are tangent if their directions differ by less than 1 degree
        if corners or _cosine_of_turn(runs, end, other) > np.cos(np.radians(1.0)):
            partners[end] = other
    return partners


def _cosine_of_turn(runs: Sequence[Run], first: _End, other: _End) -> float:
    # both directions point out of their runs, so they are opposite where one run continues the other
    tangents = []
    for i, side in (first, other):
        edge = (reverse_run(runs[i]) if side == 0 else runs[i])[-1]
        low, high = edge.spans.edges[-2:]
        before, end = edge.at([high - 1e-4 * (high - low), high])
        tangents.append((end - before) / max(float(np.linalg.norm(end - before)), 1e-300))
    return float(-tangents[0] @ tangents[1])


class _RunIndex:
    """Ends and bounding boxes of n runs, sorted along the longer axis of the drawing, to find overlaps.

    Attributes
    ----------
    ends : (n, 2, d) array
        Start and end of each run.
    sizes : (n,) array
        Lengths of the runs.
    lows, highs : (n, d) array
        Corners of the boxes, enlarged by the tolerance.
    axis : int
        Longer axis of the drawing.
    sorted, along : (n,) array
        Runs in the order of their middles along this axis, and the coordinates of these middles.
    by_length, rank : (n,) int array
        Runs from the longest to the shortest, and the place of each run in this order.
    """

    def __init__(self, runs: Sequence[Run], tolerance: float) -> None:
        """Sort the runs by their middles along the longer axis, to find those near a run, and by length."""
        self.runs, self.tolerance = runs, tolerance
        self.ends = _ends(runs).reshape(len(runs), 2, -1)
        self.sizes = np.array([sum(edge.length for edge in run) for run in runs])
        boxes = np.array([box_about(np.concatenate([edge.points for edge in run])) for run in runs])
        self.lows, self.highs = boxes[:, 0] - tolerance, boxes[:, 1] + tolerance
        middles = self.ends.mean(axis=1)
        self.axis = int(np.ptp(middles, axis=0).argmax())
        self.sorted = middles[:, self.axis].argsort()
        self.along = middles[self.sorted, self.axis]
        self.by_length = np.argsort(-self.sizes.round(6), kind="stable")
        self.rank = np.argsort(self.by_length)

    def touching(self, j: int) -> Iterator[tuple[int, bool, bool]]:
        """Yield the index of each shorter run that touches run j, with two flags.

        The first flag is True if both ends are on run j. The second is True if a part may coincide with run j.
        """
        ends, low, high = self.ends, self.lows[j], self.highs[j]
        reach = (dist(low, high) + self.sizes[j]) / 2
        middle = (low + high)[self.axis] / 2
        near = self.sorted[slice(*self.along.searchsorted([middle - reach, middle + reach]))]
        near = np.sort(near[self.rank[near] > self.rank[j]])
        inside = np.all((ends[near] >= low) & (ends[near] <= high), axis=2)
        # flags (k, 2, 2) for the ends of k near runs and the ends of run j: False where two ends meet
        apart = np.linalg.norm(ends[near][:, :, None] - ends[j], axis=3) > self.tolerance
        candidate = inside.all(axis=1) | (inside & apart.all(axis=2)).any(axis=1)
        near, apart = near[candidate], apart[candidate]
        touching = _on_run(ends[near].reshape(-1, ends.shape[2]), self.runs[j], self.tolerance).reshape(-1, 2)
        ends_on = np.all((ends[j] >= self.lows[near, None]) & (ends[j] <= self.highs[near, None]), axis=2)
        partly = (touching[:, :, None] & ends_on[:, None] & apart).any(axis=(1, 2))
        yield from zip(near.tolist(), touching.min(axis=1).tolist(), partly.tolist(), strict=True)


def _without_overlaps(
    runs: Sequence[Run], tolerance: float
) -> tuple[list[Run], tuple[tuple[Source, Source, str], ...]]:
    """Remove runs and parts of runs that overlap longer runs. Return all other runs, and the overlaps.

    Overlaps of runs with different layers or names are only reported.
    """
    index, sources = _RunIndex(runs, tolerance), [_source_of(run) for run in runs]
    # layer of each run, and its name, or False without a name
    called = [(source.layer, source.is_named and source.name) for source in sources]
    in_part: list[tuple[int, int]] = []
    dropped: set[int] = set()
    overlaps = []
    for j in index.by_length.tolist():
        if j in dropped:
            continue
        for i, both, partly in index.touching(j):
            if i in dropped:
                continue
            if both and _on_run(_sample_points(runs[i]), runs[j], tolerance).all():
                same = called[i] == called[j]
                overlaps.append((sources[i], sources[j], "left out" if same else "kept"))
                if same:
                    dropped.add(i)
            elif partly:
                in_part.append((i, j))
    # first and last place of the part of a run that remains
    limits: dict[int, list[_Place]] = {}
    # ignore shorter common parts, which are due to rounding
    least = max(tolerance, 2 * float(_digits_of_ends(runs).max()))
    alone = _ends([runs[i] for i in range(len(runs)) if i not in dropped])
    for i, j in in_part:
        cuts = [] if {i, j} & dropped else _common_parts(runs[i], runs[j], tolerance, least)
        for side, place, met in cuts:
            # at the ends of the common part, only the end of its own run is found, unless a third run meets it
            meeting = (np.linalg.norm(alone - end, axis=1) <= tolerance for end in (index.ends[i, side], met))
            is_union = called[i] == called[j] and max(map(np.count_nonzero, meeting)) == 1
            overlaps.append((sources[i], sources[j], "joined" if is_union else "in part"))
            if is_union:
                first, last = limits.setdefault(i, [*_end_places(runs[i])])
                limits[i] = [first, min(last, place)] if side else [max(first, place), last]
    cut = [
        _part_between(run, *limits[i]) if i in limits else run
        for i, run in enumerate(runs)
        if i not in dropped
    ]
    return [run for run in cut if size_of(run) > tolerance], tuple(overlaps)


def _common_parts(
    run: Run, longer: Run, tolerance: float, least: float
) -> list[tuple[int, _Place, FloatArray]]:
    """Return the end parts of a run, longer than `least` mm, that coincide with an end part of a longer run.

    Each entry contains the end of the run (0 or 1), the position of an end of the longer run on the run, and
    the point (d,) there.
    """
    parts = []
    on_run = [(place, end) for end in _ends([longer]) if (place := _nearest_place(end, run, tolerance))]
    for side in (0, 1):
        for place, end in sorted(on_run, key=lambda met: met[0], reverse=bool(side)):
            first, last = _end_places(run)
            common = _part_between(run, place, last) if side else _part_between(run, first, place)
            if size_of(common) > least and _on_run(_sample_points(common), longer, tolerance).all():
                parts.append((side, place, end))
                break
    return parts


def _end_places(run: Run) -> tuple[_Place, _Place]:
    return (0, float(run[0].spans.edges[0])), (len(run) - 1, float(run[-1].spans.edges[-1]))


def _nearest_place(point: FloatArray, run: Run, tolerance: float) -> _Place | None:
    # the place on a run nearest to a point (d,), or None if it is farther than the tolerance
    nearest = [(*_nearest(edge, point[None]), k) for k, edge in enumerate(run)]
    away, t, k = min((float(away[0]), float(t[0]), k) for away, t, k in nearest)
    return (k, t) if away <= tolerance else None


def _part_between(run: Run, first: _Place, last: _Place) -> Run:
    """Return the part of a run between two places, each an edge and a parameter."""
    parts = []
    for k in range(first[0], last[0] + 1):
        low, high = run[k].spans.edges[[0, -1]]
        low, high = first[1] if k == first[0] else low, last[1] if k == last[0] else high
        if low < high:
            knots, points = _clamped(run[k], run[k].degree, low, high)
            weights = None if run[k].weights is None else points[:, -1]
            parts.append(Edge(knots, project(points), run[k].degree, weights, run[k].source))
    return tuple(parts)


def _on_run(points: FloatArray, run: Run, tolerance: float) -> BoolArray:
    """Return flags (n,): True for points on the run, within `tolerance`, mm."""
    is_near = np.zeros(len(points), dtype=bool)
    for edge in run:
        low, high = edge.points.min(axis=0) - tolerance, edge.points.max(axis=0) + tolerance
        near = np.flatnonzero(~is_near & np.all((points >= low) & (points <= high), axis=1))
        is_near[near] = _nearest(edge, points[near])[0] <= tolerance
    return is_near


def _nearest(edge: Edge, points: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return distances (n,), mm, of points (n, d) from an edge, and the nearest parameters (n,)."""
    if not len(points):
        return np.zeros(0), np.zeros(0)
    stations = edge.stations()
    line = edge.at(stations)
    nearest = np.array([np.linalg.norm(line - point, axis=1).argmin() for point in points])
    low, high = stations[np.maximum(nearest - 1, 0)], stations[np.minimum(nearest + 1, len(stations) - 1)]
    return nearest_by_sampling(
        lambda t: edge.at(t.ravel()).reshape(*t.shape, -1), points, low, high, rounds=10
    )


def _sample_points(run: Run) -> FloatArray:
    """Return points along the run, enough to distinguish runs with the same ends."""
    return np.concatenate([e.at(np.linspace(e.spans.edges[0], e.spans.edges[-1], 9)) for e in run])


def curve_from_run(
    run: Sequence[Edge],
    *,
    tolerance: float = JOIN_TOLERANCE,
    fit_tolerance: float = FIT_TOLERANCE,
    shown: Provenance | None = None,
    holes: Sequence[Run] = (),
) -> PlaneCurve:
    """Make one curve from consecutive edges in the plane.

    If all edges are straight, a curve is fitted to their vertices. Otherwise a curve is fitted to each polyline,
    and arcs and splines are converted exactly and raised to a common degree. Gaps up to `tolerance` mm are
    closed by moving whole edges, so that tangents do not turn. Corners that rounding of the coordinates explains
    are removed. `PlaneCurve.breaks` returns the continuity at the joints.

    Parameters
    ----------
    shown : Provenance, optional
        Template for the provenance of the curve: it describes how the drawing program displays points.
    holes : sequence of runs
        Circles drawn on the straight ends of the curve, in its plane.
    """
    sources = [edge.source for edge in run if edge.source is not None]
    first = sources[0] if sources else Source()
    check_size(np.concatenate([edge.points for edge in run]), in_file=bool(sources))
    # four vertices count as one piece: see `MOST_PIECES`
    check_count(
        sum(edge.spans.widths.size if edge.degree > 1 else len(edge.points) // 4 for edge in run),
        MOST_PIECES,
        "pieces in one curve",
        "simplify the curve (Inkscape: Path > Simplify), or cut it in parts",
    )
    drawn = replace(
        shown or Provenance(),
        rounding=max((source.rounding for source in sources), default=0.0),
        name=first.name,
        layer=first.layer,
        holes=tuple((float(x), float(y), size) for (x, y), size in filter(None, map(_circle, holes))),
    )
    if all(edge.degree == 1 for edge in run):
        vertices = np.concatenate([run[0].points, *(edge.points[1:] for edge in run[1:])])
        return curve_from_points(vertices, tolerance=fit_tolerance, drawn=drawn, sides=True)
    dust = 1e-9 * size_of(run)  # shorter edges are rounding errors
    pieces = [_fitted_if_polyline(edge, fit_tolerance) for edge in run if edge.size > dust]
    exact = [part for edge in pieces for part in _with_handles(edge)]
    whole = exact[0] if len(exact) == 1 else _joined(exact, tolerance)
    measured = _interpolated_points(whole, drawn.rounding) if len(exact) == 1 else None
    healing = heal_tangents(whole.knots, whole.points, whole.degree, whole.weights, rounding=drawn.rounding)
    drawn = replace(drawn, measured=measured, undecided=healing.undecided)
    curve = PlaneCurve(healing.knots, healing.control_points, healing.degree, healing.weights, drawn)
    if not healing.healed:
        return curve
    t = whole.stations()
    points = whole.at(t)
    away = norm(points - curve.evaluate(t))
    # `away` compares points at equal parameters; the distances to the nearest points are smaller
    moved = largest_distance(points[away >= away.max() / 2], curve)
    return curve.drawn_as(replace(drawn, healed=moved))


def _interpolated_points(edge: Edge, rounding: float) -> MeasuredPoints | None:
    """Return the points that a dense spline interpolates, or None if the curvature is smooth.

    Noise of the points, or zero curvature at an end, is invisible in the curve but changes the strip widths.
    """
    knots = edge.spans.edges
    inner = edge.knots[edge.degree + 1 : -edge.degree - 1]
    if (
        edge.degree != 3
        or edge.weights is not None
        or len(inner) < 50  # a spline through measured points has more
        or np.any(np.diff(inner) == 0)
    ):
        return None
    curve = PlaneCurve(edge.knots, edge.points, edge.degree)
    curvature = curve.curvature_at(knots)
    # noise varies the curvature by more than a fifth from knot to knot
    rough = np.abs(np.diff(curvature, 2)).max() > 0.2 * np.abs(curvature).max()
    return MeasuredPoints.of(edge.at(knots), REPORTED_MM, rounding) if rough else None


def curve_from_points(
    points: FloatArray,
    *,
    tolerance: float = FIT_TOLERANCE,
    drawn: Provenance | None = None,
    noise: float = 0.0,
    sides: bool = False,
) -> PlaneCurve:
    """Return a curve within `tolerance` mm of points (n, 2), or a line if they are collinear.

    Corners are preserved; see `PlaneCurve.tangent_breaks`. A corner is a turn by more than 50 degrees (up to 80 in
    a closed outline of few points) between two straight pieces that are long compared with the tolerance and the
    noise. The provenance of the curve states the noise of the points, at least `noise` mm. If no smooth curve
    follows noisy points, the curve is a polyline. With `sides`, the points are vertices of a drawn polyline. If
    the curve is more than `allowed_distance` from the polyline, the curve is cut at every turn of more than 5
    degrees.
    """
    if not np.all(np.isfinite(points)):
        raise InputError("a point has a coordinate that is not a finite number: export the file again")
    # closer points differ by rounding only
    apart = 1e-13 * np.abs(points).max(initial=0.0)
    points = points[np.append(True, np.any(np.abs(np.diff(points, axis=0)) > apart, axis=1))[: len(points)]]
    if len(points) < 2:
        raise InputError("a curve has fewer than two different points: draw the curve again, or leave it out")
    drawn = drawn or Provenance()
    measured = MeasuredPoints.of(points, noise, drawn.rounding)
    noise, is_noisy = measured.noise, measured.is_noisy
    corners = corner_points(points, SIDE_TOLERANCES * max(tolerance, noise))
    if corners:
        measured = replace(measured, noise=0.0)  # noise cannot be distinguished from corners
    if is_closed(points):
        if corners:  # begin at a corner, because the curve is smooth at other points
            first = corners.pop(0)
            points = begun_at(points, first)
            corners = [corner - first for corner in corners]
        else:
            measured = replace(measured, is_smoothed=not measured.outlier)
    cuts = [0, *corners, len(points) - 1]
    is_noisy = is_noisy and len(cuts) == 2
    allowed = allowed_distance(points) if sides and not is_noisy else np.inf
    try:
        pieces = [
            piece
            for i, j in pairwise(cuts)
            for piece in _smooth_pieces(points[i : j + 1], tolerance, allowed, noise)
        ]
    except NotConvergedError:
        if not is_noisy:
            raise
        pieces = [_polyline(points)]
    if len(pieces) == 1:
        near = allowed_distance(points)
        if tolerance > near:
            _require_distance(largest_distance(points, pieces[0]), near)
        return pieces[0].drawn_as(replace(drawn, measured=measured))
    whole = _joined([Edge(c.knots, c.control_points, c.degree) for c in pieces], 0.0)
    drawn = replace(drawn, vertices=points) if sides else replace(drawn, measured=measured)
    return PlaneCurve(whole.knots, whole.points, whole.degree, provenance=drawn)


def _require_distance(distance: float, allowed: float) -> None:
    if distance > allowed * (1 + SEEN_APART):
        distance, allowed = distinct_digits(distance, allowed, ".3g")
        raise InputError(
            "the fitted curve deviates from the drawing by {distance:g}, more than {allowed:g}: draw a "
            "spline, or more points where the drawing bends",
            distance=Length(distance),
            allowed=Length(allowed),
        )


def _polyline(points: FloatArray) -> PlaneCurve:
    # straight sides as pieces of degree 2, each with the middle of the side as its inner control point
    knots = np.repeat(lengths_along(points), 2)
    control = np.insert(points, slice(1, None), (points[:-1] + points[1:]) / 2, axis=0)
    return PlaneCurve(np.pad(knots, 1, mode="edge"), control, 2)


def _smooth_pieces(points: FloatArray, tolerance: float, allowed: float, noise: float) -> list[PlaneCurve]:
    """Return a smooth curve through points, cut at turns of more than 5 degrees if it misses the polyline.

    It misses the polyline if it is farther than `allowed`, mm, from its sides. `allowed` is infinite if the points
    are not vertices of a drawn polyline, or are noisy.
    """
    if len(points) == 2 or np.isinf(allowed):
        return [smooth_through(points, tolerance, noise)]
    curve, distance = fit_polyline(points, tolerance, noise)
    corners = sharp_points(points, 5.0) if distance > allowed else []
    if not corners:
        _require_distance(distance, allowed)
        return [curve]
    cuts = sorted({0, *corners, len(points) - 1})
    # only closed curves use the noise, and these pieces are open; without sharp turns they follow the polyline
    return [smooth_through(points[i : j + 1], tolerance) for i, j in pairwise(cuts)]


_OFF_MM, _OFF_SHARE = 0.004, 2e-5
"""Limit of the displacement that makes the end curvature of a curve finite: in mm, and as a fraction of its
size."""


def _with_handles(edge: Edge) -> list[Edge]:
    """Replace the ends of a cubic Bezier piece at which the curvature is infinite, within 0.004 mm of the
    curve.

    The curvature is infinite if the first two control points are equal. The first part of such a curve has
    control points a, a, c, d. This part is replaced by the parabola a, c, d, which has the same ends and end
    tangents.

    Examples
    --------
    >>> pieces = _with_handles(Edge.bezier([(0, 0), (0, 0), (80, 80), (180, 0)]))
    >>> [piece.points.shape for piece in pieces]
    [(3, 2), (4, 2)]
    """
    if edge.weights is not None or edge.points.shape != (4, 2):
        return [edge]
    if np.array_equal(edge.points[2], edge.points[3]) and not np.array_equal(edge.points[0], edge.points[1]):
        return [part.reversed() for part in reversed(_with_handles(edge.reversed()))]
    start, handle, third, end = edge.points
    toward = third - start
    if not np.array_equal(start, handle) or not toward.any() or np.array_equal(third, end):
        return [edge]
    cubic_term = end - start - 3 * toward
    aside = abs(float(toward[0] * cubic_term[1] - toward[1] * cubic_term[0])) / float(np.hypot(*toward))
    # the distance between parabola and cubic is at most 0.0214 of the distance of d from the line through a and c
    t = min(1.0, np.cbrt(min(_OFF_MM, _OFF_SHARE * edge.size) / max(0.0214 * aside, 1e-300)))
    joint = start + 3 * t**2 * toward + t**3 * cubic_term
    first = replace(Edge.bezier([start, start + t**2 * toward, joint]), source=edge.source)
    if t == 1:
        return [first]
    beyond = third + t * (end - third)
    after = start + t * toward + t * (beyond - start - t * toward)
    return [first, replace(Edge.bezier([joint, after, beyond, end]), source=edge.source)]


def _fitted_if_polyline(edge: Edge, fit_tolerance: float) -> Edge:
    if edge.degree > 1 or len(edge.points) == 2:
        return edge
    curve = curve_from_points(edge.points, tolerance=fit_tolerance, sides=True)
    return Edge(curve.knots, curve.control_points, curve.degree, curve.weights)


def _joined(edges: Sequence[Edge], tolerance: float) -> Edge:
    """Return the joined edges as a B-spline with nearly unit speed, and knots of full multiplicity at joints."""
    degree = max(2, *(edge.degree for edge in edges))
    knots, homogeneous = np.zeros(1), np.empty((0, 3))
    for edge in edges:
        inner_knots, rows = _clamped(edge, degree)
        length = float(np.linalg.norm(np.diff(edge.at(edge.stations()), axis=0), axis=1).sum())
        inner_knots = (inner_knots[1:-1] - inner_knots[0]) * (length / np.ptp(inner_knots))
        if len(homogeneous):
            last = homogeneous[-1]
            # pieces share a control point at the joint: give it one weight, then move the whole edge by the gap
            rows = rows * (last[-1] / rows[0, -1])
            gap = (last - rows[0])[:-1] / last[-1]
            rows = (rows + np.append(gap, 0.0) * rows[:, -1:])[1:]
            inner_knots = inner_knots[degree:]
        knots = np.concatenate([knots, knots[-1] + inner_knots])
        homogeneous = np.concatenate([homogeneous, rows])
    knots = np.append(knots, knots[-1])
    points, weights = project(homogeneous), homogeneous[:, -1]
    if np.linalg.norm(points[-1] - points[0]) <= tolerance:
        points[-1] = points[0]
    return Edge(knots, points, degree, weights)


def _clamped(
    edge: Edge, degree: int, low: float = -np.inf, high: float = np.inf
) -> tuple[FloatArray, FloatArray]:
    """Return a part of an edge as a clamped spline of degree `degree`: knots and homogeneous control points.

    `degree` is not less than the degree of the edge, so interpolation at the Greville abscissae is exact.
    """
    first, last = np.clip(edge.spans.edges[[0, -1]], low, high)
    inner = edge.knots[(edge.knots > first) & (edge.knots < last)]
    values, counts = knot_runs(inner)
    counts = np.minimum(counts, edge.degree) + degree - edge.degree
    knots = np.concatenate([np.full(degree + 1, first), np.repeat(values, counts), np.full(degree + 1, last)])
    if knots.size == edge.knots.size and np.array_equal(knots, edge.knots):
        return knots, edge.homogeneous
    sites = interpolation_sites(knots, degree)
    target = edge.spans.basis(sites) @ edge.homogeneous
    return knots, np.asarray(np.linalg.solve(bezier_spans(knots, degree).basis(sites), target), dtype=float)
