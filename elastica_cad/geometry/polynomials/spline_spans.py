"""Knot spans of many splines side by side, that are fitted at one go."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from elastica_cad._types import BoolArray, FloatArray, IntArray
from elastica_cad.geometry.polynomials.bezier_pieces import extraction
from elastica_cad.geometry.polynomials.knot_runs import knot_repeats
from elastica_cad.geometry.running_sums import numbers_in_groups

NARROWEST_SHARE = 1e-9
"""Of the domain: no span is cut to less."""

_SAME_BREAK_SHARE = 1e-10  # of the domain: breaks no farther apart are one
_ALIKE = (
    1e-7  # the same where the slope goes on in one of them: the span between them could not be solved for
)
_WIDER_TIMES = 8.0  # than its neighbour: cut with it


@dataclass(frozen=True, eq=False)
class SplineSpans:
    """Knot spans (p,) of splines side by side: from where to where each runs, and whose it is.

    `repeats` (p,) is how often the knot at its start stands there.
    """

    low: FloatArray
    high: FloatArray
    owner: IntArray
    repeats: IntArray
    degree: int

    @classmethod
    def between(
        cls,
        domains: Sequence[tuple[float, float]],
        breaks: Sequence[tuple[float, int]],
        inside: Sequence[FloatArray],
        degree: int,
    ) -> "SplineSpans":
        """Those between breaks and further knots inside of each domain."""
        edges, repeats = [], []
        for (first, last), knots in zip(domains, inside, strict=True):
            order = _break_orders(breaks, (first, last))
            own = _with_knots(np.array([first, *sorted(order), last]), knots)
            edges.append(own)
            repeats.append(knot_repeats(own, order, degree)[:-1])
        return cls(
            np.concatenate([own[:-1] for own in edges]),
            np.concatenate([own[1:] for own in edges]),
            np.repeat(np.arange(len(edges)), [own.size - 1 for own in edges]),
            np.concatenate(repeats),
            degree,
        )

    @cached_property
    def widths(self) -> FloatArray:
        """Lengths (p,)."""
        return np.asarray(self.high - self.low)

    @cached_property
    def begin(self) -> IntArray:
        """The first span (k,) of each owner."""
        if self.owner[-1] == 0:  # the only one
            return np.zeros(1, dtype=np.intp)
        return np.flatnonzero(np.append(True, self.owner[1:] != self.owner[:-1]))

    @cached_property
    def knots(self) -> FloatArray:
        """Those of all owners, one behind the other."""
        starts, ends = np.arange(self.low.size) + self.owner, np.append(self.begin[1:], self.low.size) - 1
        edges = np.empty(self.low.size + ends.size)
        counts = np.full(edges.size, self.degree + 1)
        edges[starts], counts[starts] = self.low, self.repeats
        edges[starts[ends] + 1] = self.high[ends]
        return edges.repeat(counts)

    @cached_property
    def first(self) -> IntArray:
        """The first coefficient (p,) that acts on each span."""
        return np.cumsum(self.repeats, dtype=np.intp) - (self.degree + 1)

    @cached_property
    def _last_knots(self) -> IntArray:
        """The last knot (p,) at the start of each span."""
        return self.first + self.degree + self.owner * (self.degree + 1)

    @cached_property
    def matrix(self) -> FloatArray:
        """See `Spans.matrix`."""
        reach = np.arange(1 - self.degree, self.degree + 1)[:, None]
        return extraction(self.knots[self._last_knots + reach])

    @property
    def count(self) -> int:
        """Number of coefficients of all."""
        return int(self.first[-1]) + self.degree + 1

    def of_owner(self, k: int) -> slice:
        """The spans of one owner."""
        return slice(self.begin[k], self.begin[k + 1] if k + 1 < len(self.begin) else None)

    def own(self, k: int) -> slice:
        """The coefficients of one owner."""
        own = self.first[self.of_owner(k)]
        return slice(own[0], own[-1] + self.degree + 1)

    def own_knots(self, k: int) -> slice:
        """The knots of one owner."""
        own = self._last_knots[self.of_owner(k)]
        return slice(own[0] - self.degree, own[-1] + self.degree + 2)

    def largest(self, values: FloatArray) -> FloatArray:
        """The largest (k,) of the values (p, ...) of each owner."""
        return np.maximum.reduceat(values.reshape(self.low.size, -1).max(axis=1), self.begin)

    def of_owners(self, chosen: BoolArray) -> "SplineSpans":
        """Those of the chosen owners (k,) alone, numbered anew."""
        kept = chosen[self.owner]
        owner = (np.cumsum(chosen) - 1)[self.owner[kept]]
        return SplineSpans(self.low[kept], self.high[kept], owner, self.repeats[kept], self.degree)

    def with_wide_neighbours(self, bad: IntArray) -> IntArray:
        """Bad spans and those beside them that are far wider: a narrow one can't mend what a wide one imposes."""
        beside, narrow = np.concatenate([bad - 1, bad + 1]), np.tile(bad, 2)
        inside = (beside >= 0) & (beside < self.low.size)
        beside, narrow = beside[inside], narrow[inside]
        wide = self.widths[beside] > _WIDER_TIMES * self.widths[narrow]
        cut = np.zeros(self.low.size, dtype=bool)
        cut[bad] = True
        cut[beside[wide & (self.owner[beside] == self.owner[narrow])]] = True
        return cut.nonzero()[0]

    def cut(self, parts: IntArray) -> "SplineSpans":
        """Each cut into so many equal parts."""
        number = numbers_in_groups(parts)
        low = number * (self.widths / parts).repeat(parts) + self.low.repeat(parts)
        high, repeats = self.high.repeat(parts), self.repeats.repeat(parts)
        inner = number[1:] > 0
        high[:-1][inner] = low[1:][inner]
        repeats[1:][inner] = 1
        return SplineSpans(low, high, self.owner.repeat(parts), repeats, self.degree)


def _break_orders(breaks: Sequence[tuple[float, int]], domain: tuple[float, float]) -> dict[float, int]:
    """Least continuity at each break inside the domain; breaks too close to be told apart count as one."""
    length = domain[1] - domain[0]
    order: dict[float, int] = {}
    last = domain[0]
    for place, continuity in sorted(breaks):
        if not domain[0] + _SAME_BREAK_SHARE * length < place < domain[1] - _SAME_BREAK_SHARE * length:
            continue
        before = order.get(last)
        if (
            before is None
            or place - last > (_ALIKE if max(before, continuity) > 0 else _SAME_BREAK_SHARE) * length
        ):
            order[place] = continuity
            last = place
        elif continuity < before:
            # the rougher of the two is where it is
            del order[last]
            order[place] = continuity
            last = place
    return order


def _with_knots(edges: FloatArray, knots: FloatArray) -> FloatArray:
    """The edges and those knots that lie between them, none next to an edge."""
    knots = knots[(knots > edges[0]) & (knots < edges[-1])]
    after = np.searchsorted(edges, knots)
    apart = np.minimum(edges[after] - knots, knots - edges[after - 1])
    both = np.sort(np.concatenate([edges, knots[apart > NARROWEST_SHARE * (edges[-1] - edges[0])]]))
    kept = np.ones(both.size, dtype=bool)
    np.greater(both[1:], both[:-1], out=kept[1:])
    return np.asarray(both[kept])
