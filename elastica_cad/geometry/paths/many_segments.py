"""Many segments at one go, each at places of its own."""

from collections.abc import Sequence

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.geometry.paths.segments import Segment, Spline
from elastica_cad.geometry.paths.spline_table import SplineTable
from elastica_cad.geometry.paths.trim import trim_segment


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
