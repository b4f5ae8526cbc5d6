"""Fewest supports that split a curve into realizable pieces (paper, section 4.3, Locality)."""

from bisect import bisect_left
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import as_floats, is_whole
from elastica_cad.errors import InputError, Length, Listed, note, quoted
from elastica_cad.form_finding.equilibrium_curve import EquilibriumCurve
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.mechanics.equilibrium_check import examine
from elastica_cad.mechanics.loads import (
    End,
    Supports,
    require_curve,
    require_ratio,
    require_supports,
    require_tolerance,
)
from elastica_cad.mechanics.theorem1 import EquilibriumCheck, NotRealizable, examine_curvature, lengths

MOST_STRIPS = 1000
"""Largest number of strips into which a curve can be split."""

_SHORTEST_SHARE = 1e-4  # parameter range below which a part counts as empty, as a fraction of the whole range
# number of positions that are tried for each support, between its first and its last possible position
_CHOICES = 5
_ROUNDS = 2  # number of grids of positions; each grid is finer than the grid before


@dataclass(frozen=True, eq=False)
class Splitting:
    """Result of `split`; `str()` describes the result in a sentence.

    Attributes
    ----------
    pieces : tuple of PlaneCurve
        Exact parts of the curve between its ends and the supports.
    supports : tuple of float
        Arc lengths of the supports, mm. Each support holds position and angle.
    ranges : tuple of (float, float)
        Least and largest arc length at which each support can be placed without more supports, mm.
    ratios : tuple of float
        For each piece, the least possible ratio of largest to least stiffness.
    """

    pieces: tuple[PlaneCurve, ...]
    supports: tuple[float, ...]
    ranges: tuple[tuple[float, float], ...]
    ratios: tuple[float, ...]

    def __str__(self) -> str:
        count, ratios = len(self.supports), Listed(map(float, self.ratios))
        return note(
            "The curve needs no support: a flat strip can take it, with a stiffness ratio of {ratios:.3g}."
            if not count
            else "1 support, {places} from the start, splits the curve into 2 strips that can be made, with "
            "stiffness ratios of {ratios:.3g}."
            if count == 1
            else "{count} supports, {places} from the start, split the curve into {strips} strips that can be "
            "made, with stiffness ratios of {ratios:.3g}.",
            count=count, places=lengths(self.supports), strips=count + 1, ratios=ratios,
        )  # fmt: skip


def split(
    curve: PlaneCurve,
    *,
    ratio: float | None = None,
    supports: Supports | None = None,
    places: ArrayLike | None = None,
    tolerance: float = 1e-4,
    count: int | None = None,
) -> Splitting:
    """Return the fewest supports along a curve that make every piece realizable, with the least ratios.

    The pieces are separate strips, which are clamped at the supports. For one strip with rails, pins or cords
    between its ends, pass `between` to `optimal_rod` instead.

    A part of a realizable curve is realizable too, with the same inflection line and at most the same stiffness
    ratio. Therefore the number of pieces is least if each piece is as long as possible, which gives the last
    possible position of each support. The same search from the other end gives the first possible positions. Within
    these ranges, the supports are placed so that the sum of the squared ratios is least.

    Parameters
    ----------
    ratio : float, optional
        Largest stiffness ratio of each piece; by default there is no limit.
    supports : Supports
        Supports of the ends of the whole curve; by default both are clamped.
    places : (k,) array_like, optional
        Possible arc lengths of supports, mm; by default any.
    tolerance : float
        Distance below which inflections of a piece are on one line, as a fraction of the whole curve's length.
    count : int, optional
        Number of pieces, by default the least. Additional supports, anywhere, divide the longest pieces equally.

    Raises
    ------
    InputError
        The curve needs more than `count` pieces.
    NotRealizable
        No number of supports is sufficient, because the curvature touches zero, or because there are too few
        `places`.

    References
    ----------
    Paper, Theorem 1 and section 4.3.

    Examples
    --------
    >>> points = [(0, 0), (20, 60), (50, -60), (80, 60), (100, 80), (160, -90), (190, 20)]
    >>> found = split(PlaneCurve.spline(points, degree=4))
    >>> len(found.pieces) == len(found.supports) + 1
    True
    """
    if ratio is not None:
        require_ratio(ratio, "ratio")
    require_tolerance(tolerance)
    require_curve(curve)
    cut = _Cut(curve, ratio, require_supports(supports), _parameters(curve, places), tolerance)
    latest = _forwards(cut)
    ranges = [(min(a, b), b) for a, b in zip(_earliest(cut, latest), latest, strict=True)]
    least = len(latest) + 1
    if count is not None and not (is_whole(count) and least <= count <= MOST_STRIPS):
        raise InputError(
            "The curve cannot be split into {count} strips. Split it into a whole number of strips, {least} to "
            "{most}.",
            count=quoted(count), least=least, most=MOST_STRIPS,
        )  # fmt: skip
    more = (count or least) - least
    # with more supports, each support can be earlier and later
    low, high = curve.domain
    first, last = [low] * more + [a for a, _ in ranges], [b for _, b in ranges] + [high] * more
    placed = _divided(cut, _placed(cut, latest, ranges), more)
    pairs = list(pairwise([low, *placed, high]))
    s = curve.arc_length(np.array(placed))
    spans = curve.arc_length(np.array([*zip(first, last, strict=True)]).reshape(-1, 2))
    return Splitting(
        tuple(cut.piece(*pair) for pair in pairs),
        tuple(s.tolist()),
        tuple((float(a), float(b)) for a, b in spans),
        tuple(cut.ratio_of(*pair) for pair in pairs),
    )


@dataclass(frozen=True, eq=False)
class _Cut:
    """A curve to split, and the requirements for its pieces. All positions are parameters of the curve."""

    curve: PlaneCurve
    ratio: float | None
    supports: Supports
    places: FloatArray | None
    tolerance: float

    def piece(self, start: float, end: float) -> PlaneCurve:
        if (start, end) == self.curve.domain:
            return self.curve
        return self.curve.trimmed(start, end)

    def ratio_of(self, start: float, end: float) -> float:
        """Return the least stiffness ratio of a piece; infinite if no strip can take it."""
        try:
            piece, held, tolerance = self._held(start, end)
            if piece.is_straight:
                return 1.0
            return EquilibriumCurve.of(piece, held, tolerance=tolerance).ratio
        except (NotRealizable, InputError):
            return np.inf

    def _held(self, start: float, end: float) -> tuple[PlaneCurve, Supports, float]:
        """Return a piece with its supports, clamped at each cut, and the tolerance as a fraction of its length."""
        low, high = self.curve.domain
        first, last = self.supports.ends
        piece = self.piece(start, end)
        held = Supports(first if start == low else End(), last if end == high else End())
        return piece, held, self.tolerance * self.curve.length / piece.length

    def choices(self, first: float, last: float, known: float) -> FloatArray:
        # positions (k,) to try for a support between `first` and `last`, and the position `known`
        if self.places is None:
            return np.unique(np.append(np.linspace(first, last, _CHOICES), known))
        inside = self.places[(self.places >= first) & (self.places <= last)]
        few = inside[np.linspace(0, inside.size - 1, _CHOICES).round().astype(int)] if inside.size else inside
        return np.unique(np.append(few, known))

    @property
    def short(self) -> float:
        low, high = self.curve.domain
        return _SHORTEST_SHARE * (high - low)

    @property
    def least(self) -> float:
        """Least parameter range of a piece between two supports."""
        return 100 * self.short

    def takes(self, start: float, end: float) -> bool:
        """Return True if a strip can take the piece within the stiffness ratio.

        A very short piece counts as possible.
        """
        if end - start < self.short:
            return True
        if self.ratio is not None:
            return self.ratio_of(start, end) <= self.ratio
        try:
            piece, held, tolerance = self._held(start, end)
            if piece.is_closed:
                return False
            return examine(piece, held, tolerance=tolerance).realizable
        except InputError:
            return False

    @cached_property
    def marks(self) -> FloatArray:
        """Positions where a piece may have to end: corners, curvature jumps, ends of straight parts, curve end."""
        marks = [corner.t for corner in self.curve.tangent_breaks]
        for zero in self.curve.curvature_zeros:
            if zero.kind in ("flat", "jump"):
                marks += [zero.t, zero.t_end]
        low, high = self.curve.domain
        return np.unique(np.array([t for t in (*marks, high) if low < t <= high]))

    def reach(self, start: float) -> float:
        """Return the end of the longest possible piece from `start`, or `start` if there is none."""
        # a piece from `start` can end at `near`, but not at `far`, unless both are the same
        near, far = start, self.curve.domain[1]
        for mark in self.marks[self.marks > start]:
            if not self.takes(start, float(mark)):
                far = float(mark)
                break
            near = far = float(mark)
        if self.places is not None:
            if near == self.curve.domain[1]:
                return near
            # find the last given place that the piece reaches; it reaches `near`, but not `far`
            offered = self.places[(self.places > start) & (self.places < far)]
            count = bisect_left(offered, True, key=lambda place: not self.takes(start, float(place)))
            return float(offered[count - 1]) if count else start
        sure = near
        while far - near > self.short / 10:
            middle = (near + far) / 2
            near, far = (middle, far) if self.takes(start, middle) else (near, middle)
        # end at the mark if the piece passes the mark by less than `least`, which is a numerical error
        return near if near - sure > self.least else sure

    def turned(self, t: FloatArray) -> FloatArray:
        """Return the parameters of the same positions on the reversed curve, in increasing order."""
        return np.asarray((self.curve.knots[0] + self.curve.knots[-1] - t)[::-1])


def _parameters(curve: PlaneCurve, places: ArrayLike | None) -> FloatArray | None:
    """Return the parameters of the places inside the curve, in increasing order, for arc lengths in mm."""
    if places is None:
        return None
    values = as_floats(places)
    if values is None:
        raise InputError(f"places are {places!r}: give arc lengths in mm")
    s = np.unique(values)
    if not np.isfinite(s).all():
        raise InputError("places of supports are not finite: give arc lengths in mm")
    t = curve.parameter(s)
    low, high = curve.domain
    return t[(t > low) & (t < high)]


def _forwards(cut: _Cut) -> list[float]:
    """Return the fewest possible supports, each as late along the curve as possible."""
    start, high = cut.curve.domain
    supports: list[float] = []
    while not cut.takes(start, high):
        # a closed curve needs at least one support before its end, far enough that the rest does not count as
        # empty (`short`)
        end = min(cut.reach(start), high - 10 * cut.short)
        if end <= start:
            raise NotRealizable(_stuck(cut, start))
        supports.append(end)
        start = end
    return supports


def _earliest(cut: _Cut, latest: Sequence[float]) -> Sequence[float]:
    """Return as many supports as `latest`, each as early as possible, searched from the curve's end."""
    curve = cut.curve
    places = None if cut.places is None else cut.turned(cut.places)
    mirrored = _Cut(curve.reversed(), cut.ratio, cut.supports.reversed(), places, cut.tolerance)
    try:
        earliest = cut.turned(np.array(_forwards(mirrored))).tolist()
    except NotRealizable:
        return latest
    # rounding errors can change the number of supports; the earliest positions are then unknown
    return earliest if len(earliest) == len(latest) else latest


def _stuck(cut: _Cut, place: float) -> EquilibriumCheck:
    """Return the refused check of a curve from which no piece can start at the parameter `place`."""
    curve = cut.curve
    s = float(curve.arc_length(np.array(place)))
    limit = "" if cut.ratio is None else note(" within a stiffness ratio of {ratio:g}", ratio=cut.ratio)
    reason = note(
        "Supports do not help {s} from the start: no strip can begin there{limit}."
        if cut.places is None
        else "Supports do not help {s} from the start: no strip can reach from there to the next given "
        "place{limit}. Give another place between them.",
        s=Length(s),
        limit=limit,
    )
    try:
        why = examine_curvature(curve, cut.supports).reasons
    except InputError:
        why = ()
    return EquilibriumCheck(
        False, (reason, *why), (), curve.length, curve, inflections=tuple(curve.inflections)
    )


def _placed(cut: _Cut, latest: Sequence[float], ranges: Sequence[tuple[float, float]]) -> list[float]:
    """Return the positions of supports, within their ranges, with the least sum of squared stiffness ratios.

    The minimum is a shortest path on a grid of positions. The grid is then refined around the path.
    """
    places = list(latest)
    spans = list(ranges)
    for _ in range(_ROUNDS if cut.places is None else 1):
        stages = [cut.choices(*span, at) for span, at in zip(spans, places, strict=True)]
        places = _shortest_path(cut, stages) or places
        cells = [(last - first) / (_CHOICES - 1) for first, last in spans]
        spans = [
            (max(first, at - cell), min(last, at + cell))
            for (first, last), at, cell in zip(ranges, places, cells, strict=True)
        ]
    return places


def _divided(cut: _Cut, supports: Sequence[float], more: int) -> Sequence[float]:
    """Return the supports and `more` supports that divide the longest pieces equally."""
    low, high = cut.curve.domain
    ends = cut.curve.arc_length(np.array([low, *supports, high]))
    parts = np.ones(len(supports) + 1, int)
    for _ in range(more):
        parts[(np.diff(ends) / parts).argmax()] += 1
    pieces = zip(pairwise(ends), parts, strict=True)
    s = [np.linspace(start, end, count, endpoint=False) for (start, end), count in pieces]
    return cut.curve.parameter(np.concatenate(s)[1:]).tolist() if more else supports


def _shortest_path(cut: _Cut, stages: Sequence[FloatArray]) -> list[float]:
    """Return one position from each array of `stages`, with the least sum of squared stiffness ratios.

    The list is empty if every choice has a piece that no strip can take.
    """
    low, high = cut.curve.domain
    chain = [np.array([low]), *stages, np.array([high])]
    # least sum up to each position of a stage, and for each position the index of the best position before it
    total, comes_from = np.zeros(1), []
    for before, after in pairwise(chain):
        cost = np.full((before.size, after.size), np.inf)
        for i, j in np.ndindex(*cost.shape):
            if after[j] - before[i] > cut.least and np.isfinite(total[i]):
                cost[i, j] = total[i] + cut.ratio_of(float(before[i]), float(after[j])) ** 2
        comes_from.append(cost.argmin(axis=0))
        total = cost.min(axis=0)
    chosen: list[float] = []
    at = 0
    if not np.isfinite(total[0]):
        return chosen
    for stage, best in zip(reversed(stages), reversed(comes_from[1:]), strict=True):
        at = best[at]
        chosen.append(float(stage[at]))
    return chosen[::-1]
