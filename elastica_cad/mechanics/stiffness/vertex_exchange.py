"""Linear programs in a few numbers: from vertex to vertex, one condition exchanged at a time."""

from math import isfinite

import numpy as np

from elastica_cad._types import FloatArray

_BOX = 1e7
"""Size that unknowns of order 1 are held below at first, so that there is a vertex to start from."""

_FEASIBLE = 1e-10
"""Lack of a condition that is rounding: of 1, or of R where the condition holds R."""

_PIVOT = 1e-9
"""Share of the largest component below which a condition cannot leave a vertex."""

_CORRECTED = 1e-13
"""Share of the numbers at a vertex that its conditions may lack, after they have corrected it."""

_MOST_EXCHANGES = 200  # several times what a program in four numbers takes

_NO_VERTEX, _FOUND, _WORN = 0, 1, 2
"""How exchanges end: with none, with the one that is sought, or with an inverse that has lost digits."""


class VertexExchange:
    """Minimise R over (x, R), conditions being added between solutions.

    Stiefel's exchange method, the dual simplex of a program with few unknowns and many rows: a vertex of which R is
    the least under its own conditions takes in the condition that it violates most, and gives up the one whose
    multiplier would turn negative first. The inverse of the conditions at the vertex follows the exchange; they
    correct the vertex themselves, and where that leaves more than rounding the inverse is made anew.

    Sources: Stiefel, "Uber diskrete und lineare Tschebyscheff-Approximationen", Numer. Math. 1 (1959); Lemke, "The
    dual method of solving the linear programming problem", Naval Res. Logist. Q. 1 (1954).
    """

    def __init__(self, unknowns: int) -> None:
        count = unknowns + 1
        # R >= 0 and -x <= box: the first vertex; x <= box holds the unknowns from the other side
        box = np.eye(count)
        self.rows = np.concatenate([box, -box[:-1]])
        self.limits = np.concatenate([np.full(unknowns, -_BOX), [0.0], np.full(unknowns, -_BOX)])
        self.active = np.arange(count, dtype=np.intp)
        self.inverse = box

    def add(self, rows: FloatArray, offset: FloatArray, low: int) -> None:
        """Demand rows @ x + offset >= 0 of the first `low` rows and rows @ x + offset <= R of the others."""
        count = len(self.rows)
        middle = count + low
        demands = np.empty((count + len(rows), self.rows.shape[1]))
        demands[:count], demands[count:middle, :-1] = self.rows, rows[:low]
        np.negative(rows[low:], out=demands[middle:, :-1])
        demands[count:middle, -1], demands[middle:, -1] = 0.0, 1.0
        self.rows, self.limits = demands, np.concatenate([self.limits, -offset[:low], offset[low:]])

    def solve(self) -> FloatArray | None:
        """(x, R), or None where this method comes to no vertex of all conditions: an unbounded program, none at all
        that meets them, or one that is all but degenerate."""
        unknowns = self.rows.shape[1] - 1
        for _ in range(_MOST_EXCHANGES):
            ended, vertex = self._exchanged()
            if ended != _WORN:
                break
            try:
                self.inverse = _inverse(self.rows[self.active])
            except np.linalg.LinAlgError:
                return None
        boxed = any(row < 2 * unknowns + 1 and row != unknowns for row in self.active.tolist())
        return vertex if ended == _FOUND and not boxed and all(map(isfinite, vertex.tolist())) else None

    def _exchanged(self) -> tuple[int, FloatArray]:
        """How the exchanges end from where they stand, and the vertex where they do."""
        holds_largest = self.rows[:, -1]
        active = self.active
        rows, limits = self.rows[active], self.limits[active]
        for _ in range(_MOST_EXCHANGES):
            inverse = self.inverse
            vertex = inverse @ limits
            vertex += inverse @ (limits - rows @ vertex)  # to rounding of the conditions themselves
            excess = self.rows @ vertex - self.limits
            if vertex[-1] > 1:
                excess /= 1.0 + holds_largest * (vertex[-1] - 1.0)
            worst = int(excess.argmin())
            if not excess[worst] < -_FEASIBLE:
                lack = np.abs(limits - rows @ vertex).max()
                return (_FOUND if lack <= _CORRECTED * np.abs(vertex).max() else _WORN), vertex
            # the entering row is so much of each active one; R is the sum of the active ones by `share`
            parts, share = self.rows[worst] @ inverse, inverse[-1]
            leaving = (parts > _PIVOT * np.abs(parts).max()).nonzero()[0]
            if leaving.size == 0:
                return _NO_VERTEX, vertex
            out = leaving[(share[leaving] / parts[leaving]).argmin()]
            active[out], rows[out], limits[out] = worst, self.rows[worst], self.limits[worst]
            column = inverse[:, out] / parts[out]
            self.inverse = inverse - column[:, None] * parts
            self.inverse[:, out] = column
        return _NO_VERTEX, vertex


def _inverse(matrix: FloatArray) -> FloatArray:
    """The inverse of a small matrix, one column at a time.

    For several columns at once OpenBLAS wakes its threads, which takes forty times as long as the solution, and
    where others compute too milliseconds.
    """
    size = len(matrix)
    columns = np.linalg.solve(np.broadcast_to(matrix, (size, size, size)), np.eye(size)[:, :, None])
    return np.asarray(columns[:, :, 0].T)
