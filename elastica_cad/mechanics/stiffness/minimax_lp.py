"""The smallest ratio of largest to least stiffness: a linear program in few numbers, by row generation."""

import threading
from dataclasses import dataclass
from typing import Any, Literal, Protocol, TypeAlias

import numpy as np

from elastica_cad._compiled_scipy import svd
from elastica_cad._types import FloatArray
from elastica_cad.errors import NotConvergedError
from elastica_cad.mechanics.stiffness.vertex_exchange import VertexExchange

Solver: TypeAlias = Literal["auto", "highspy", "scipy"]

_START_ROWS = 9  # along the curve, before violated rows are added
MAX_ROUNDS = 200  # of adding violated rows


@dataclass(frozen=True, eq=False)
class MinimaxSolution:
    """Answer of `minimax_ratio`.

    Attributes
    ----------
    x : (m,) array
        The unknown numbers.
    ratio : float
        R, the largest value; the least one is at least 1.
    values : (n,) array
        rows @ x + offset: the stiffness at all samples.
    rounds : int
        Linear programs solved.
    """

    x: FloatArray
    ratio: float
    values: FloatArray
    rounds: int


def minimax_ratio(
    rows: FloatArray,
    *,
    offset: FloatArray | None = None,
    side_rows: FloatArray | None = None,
    side_offset: FloatArray | None = None,
    tolerance: float = 1e-10,
    solver: Solver = "auto",
) -> MinimaxSolution | None:
    """Minimise R subject to 1 <= rows @ x + offset <= R (paper, Eq. 4), to global optimality.

    The optimum is fixed by a handful of samples. So a program starts with nine of them and gets the two most
    violated ones (one below 1, one above R) until none is left; each round starts from the last one's vertex.

    Parameters
    ----------
    rows : (n, m) array
        Stiffness at sample i is rows[i] @ x + offset[i]; m is small.
    offset : (n,) array, optional
        Zero unless given.
    side_rows : (k, m) array, optional
        Further conditions side_rows @ x + side_offset >= 0.
    side_offset : (k,) array, optional
        Zero unless given.
    tolerance : float
        Largest violation left, relative to the bound.
    solver
        "auto" exchanges conditions at a vertex (`VertexExchange`), and asks HiGHS where that comes to none:
        highspy where it is installed, else scipy's. "highspy" and "scipy" ask these at once.

    Returns
    -------
    MinimaxSolution or None
        None when no x makes every sample positive.

    Examples
    --------
    >>> import numpy as np
    >>> s = np.linspace(0, 1, 50)
    >>> round(minimax_ratio(np.column_stack([1 + s, 1 + s**2])).ratio, 6)
    2.0
    """
    n, m = rows.shape
    offset = np.zeros(n) if offset is None else offset
    if m == 0:
        fits = bool(offset.min() >= 1 - tolerance)
        return MinimaxSolution(np.zeros(0), float(offset.max()), offset, 0) if fits else None
    if m == 1 and side_rows is None and not offset.any():
        return _single(rows[:, 0])
    program = MinimaxProgram(rows, side_rows=side_rows, side_offset=side_offset, solver=solver)
    low = high = start_rows(n)
    asked_low, asked_high = set(low), set(high)
    for rounds in range(1, MAX_ROUNDS + 1):
        program.demand(rows[low], offset[low], rows[high], offset[high])
        answer = program.solve()
        if answer is None:
            return None
        x, ratio = answer
        values = rows @ x
        values += offset
        least, most = int(values.argmin()), int(values.argmax())
        # a sample that was asked for and still fails does so by the solver's own tolerance
        fails_low = values[least] < 1 - tolerance and least not in asked_low
        fails_high = values[most] > ratio + tolerance * max(1.0, ratio) and most not in asked_high
        if not (fails_low or fails_high):
            return MinimaxSolution(x, max(ratio, float(values[most])), values, rounds)
        low, high = [least] if fails_low else [], [most] if fails_high else []
        asked_low.update(low)
        asked_high.update(high)
    raise unsettled(ratio)


def _stopped() -> NotConvergedError:
    """The error of a library that comes to no answer, as where the stiffest place is 1e8 times the softest."""
    return NotConvergedError(
        "the linear program for the stiffness ratio comes to no answer: stiff and soft places would be too far "
        "apart; use a lighter or stiffer sheet, support the strip, or change the curve"
    )


def start_rows(count: int) -> list[int]:
    """Which of so many samples to start with."""
    return (np.arange(_START_ROWS) * (count - 1) // (_START_ROWS - 1)).tolist()


def unsettled(ratio: float) -> NotConvergedError:
    """The error of rows that are generated without end."""
    return NotConvergedError(
        f"the linear program for the stiffness ratio did not settle in {MAX_ROUNDS} rounds (ratio "
        f"{ratio:.6g}): the curve has almost straight places; move its control points a little"
    )


class MinimaxProgram:
    """Minimise R subject to demands on stiffnesses rows @ x + offset, which are added between solutions.

    Parameters
    ----------
    samples : (n, m) array
        Rows of the kind that will be demanded: they tell the sizes of the unknowns.
    side_rows, side_offset : (k, m), (k,) arrays, optional
        Further conditions side_rows @ x + side_offset >= 0.
    """

    def __init__(
        self,
        samples: FloatArray,
        *,
        side_rows: FloatArray | None = None,
        side_offset: FloatArray | None = None,
        solver: Solver = "auto",
    ) -> None:
        self.basis = _conditioned(samples)
        self.program = _program(solver, self.basis.shape[1])
        if side_rows is not None:
            offset = np.zeros(len(side_rows)) if side_offset is None else side_offset
            self.program.add(side_rows @ self.basis, offset, len(side_rows))

    def demand(
        self, low: FloatArray, low_offset: FloatArray, high: FloatArray, high_offset: FloatArray
    ) -> None:
        """From now on 1 <= low @ x + low_offset, and high @ x + high_offset <= R."""
        rows = np.concatenate([low, high]) @ self.basis
        self.program.add(rows, np.concatenate([low_offset - 1, high_offset]), len(low))

    def solve(self) -> tuple[FloatArray, float] | None:
        """x and R, or None when no x meets the demands."""
        answer = self.program.solve()
        return None if answer is None else (self.basis @ answer[:-1], float(answer[-1]))


def _single(row: FloatArray) -> MinimaxSolution | None:
    """One unknown is a scale: nothing to optimise."""
    low, high = row.min(), row.max()
    if low > 0:
        return MinimaxSolution(np.array([1 / low]), float(high / low), row / low, 0)
    if high < 0:
        return MinimaxSolution(np.array([1 / high]), float(low / high), row / high, 0)
    return None


def _conditioned(rows: FloatArray) -> FloatArray:
    """Columns (m, k) that span the unknowns such that stiffness is of order 1 for coefficients of order 1."""
    thinned = rows[:: max(1, len(rows) // 64)]
    _, size, vt = svd(thinned, full_matrices=False)
    keep = size > 1e-13 * size[0] if size[0] > 0 else np.ones(size.size, dtype=bool)
    return np.asarray(vt[keep].T * (np.sqrt(len(thinned)) / np.where(size[keep] > 0, size[keep], 1.0)))


class _Program(Protocol):
    """Minimise R over (x, R), rows being added between solutions."""

    def add(self, rows: FloatArray, offset: FloatArray, low: int) -> None:
        """Demand rows @ x + offset >= 0 of the first `low` rows and rows @ x + offset <= R of the others."""

    def solve(self) -> FloatArray | None:
        """(x, R), or None when infeasible."""


def _program(solver: Solver, unknowns: int) -> _Program:
    return _QuickProgram(unknowns) if solver == "auto" else _library_program(solver, unknowns)


class _QuickProgram:
    """By exchanging vertices; where that comes to none, by a library, which also says whether there is any."""

    def __init__(self, unknowns: int) -> None:
        self.unknowns = unknowns
        self.program: _Program = VertexExchange(unknowns)
        self.added: list[tuple[FloatArray, FloatArray, int]] = []

    def add(self, rows: FloatArray, offset: FloatArray, low: int) -> None:
        self.added.append((rows, offset, low))
        self.program.add(rows, offset, low)

    def solve(self) -> FloatArray | None:
        answer = self.program.solve()
        if answer is None and isinstance(self.program, VertexExchange):
            self.program = _library_program("auto", self.unknowns)
            for demands in self.added:
                self.program.add(*demands)
            answer = self.program.solve()
        return answer


def _library_program(solver: Solver, unknowns: int) -> _Program:
    # a missing module is looked for only once: the search takes longer than the program
    if solver == "scipy" or (solver == "auto" and hasattr(_local, "without_highs")):
        return _ScipyProgram(unknowns)
    try:
        return _HighsProgram(unknowns)
    except ImportError:
        if solver == "highspy":
            raise
        _local.without_highs = True
        return _ScipyProgram(unknowns)


_local = threading.local()


def _highs() -> Any:
    """One silent HiGHS a thread: making one costs as much as solving."""
    if not hasattr(_local, "highs"):
        import highspy

        # what Highs puts on top, callbacks, has it print its name before it can be silenced
        _local.highs = highspy.Highs.__bases__[0]()
        for name, value in {
            "output_flag": False, "presolve": "off", "solver": "simplex", "parallel": "off",
            "primal_feasibility_tolerance": 1e-10, "dual_feasibility_tolerance": 1e-10,
        }.items():  # fmt: skip
            _local.highs.setOptionValue(name, value)
        _local.optimal, _local.infeasible = (
            highspy.HighsModelStatus.kOptimal,
            (highspy.HighsModelStatus.kInfeasible, highspy.HighsModelStatus.kUnboundedOrInfeasible),
        )
    return _local.highs


class _HighsProgram:
    def __init__(self, unknowns: int) -> None:
        self.highs = _highs()
        self.highs.clearModel()
        self.columns = unknowns + 1
        free = np.full(self.columns, np.inf)
        self.highs.addVars(self.columns, -free, free)
        self.highs.changeColCost(unknowns, 1.0)

    def add(self, rows: FloatArray, offset: FloatArray, low: int) -> None:
        count = len(rows)
        matrix = np.zeros((count, self.columns))
        matrix[:, :-1] = rows
        matrix[low:, -1] = -1.0
        lower, upper = -offset, -offset
        lower[low:], upper[:low] = -np.inf, np.inf
        entry = np.arange(matrix.size, dtype=np.int32)
        self.highs.addRows(
            count, lower, upper, matrix.size, entry[:: self.columns], entry % self.columns, matrix.ravel()
        )

    def solve(self) -> FloatArray | None:
        status = self._run()
        if status != _local.optimal and status not in _local.infeasible:
            # where stiffnesses are 1e8 apart, rounding that a warm start carries along is lost by a fresh one
            self.highs.clearSolver()
            status = self._run()
        if status == _local.optimal:
            return np.array(self.highs.getSolution().col_value)
        if status in _local.infeasible:
            return None
        raise _stopped()

    def _run(self) -> Any:
        self.highs.run()
        return self.highs.getModelStatus()


class _ScipyProgram:
    """The same rounds with `scipy.optimize.linprog`, from scratch each time."""

    def __init__(self, unknowns: int) -> None:
        self.matrix = np.zeros((0, unknowns + 1))
        self.limit = np.zeros(0)

    def add(self, rows: FloatArray, offset: FloatArray, low: int) -> None:
        above = np.arange(len(rows)) >= low
        matrix = np.column_stack([np.where(above[:, None], rows, -rows), np.where(above, -1.0, 0.0)])
        self.matrix = np.vstack([self.matrix, matrix])
        self.limit = np.concatenate([self.limit, np.where(above, -offset, offset)])

    def solve(self) -> FloatArray | None:
        from scipy.optimize import linprog

        cost = np.zeros(self.matrix.shape[1])
        cost[-1] = 1.0
        options = {
            "presolve": False, "primal_feasibility_tolerance": 1e-10, "dual_feasibility_tolerance": 1e-10
        }  # fmt: skip
        result = linprog(cost, self.matrix, self.limit, bounds=(None, None), method="highs", options=options)
        if result.status == 0:
            return np.asarray(result.x, dtype=float)
        if result.status == 2:
            return None
        raise _stopped()
