"""Linear programs with few unknowns for the least stiffness ratio, and for the smoothest stiffness near it."""

from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from elastica_cad._compiled_scipy import svd
from elastica_cad._types import FloatArray
from elastica_cad.errors import NotConvergedError


class Exchange(NamedTuple):
    """Settings of the exchange method, and of rows that are added to a linear program.

    Attributes
    ----------
    start_rows, most_rounds : int
        Number of samples in the first round, and largest number of rounds, if rows are added between solutions.
    first_rows : int
        Number of uniform samples of a long curve from which a program starts.
    box : float
        Bound of the scaled unknowns, which are of order 1; the bounds define the first vertex.
    feasible : float
        Largest violation of a condition that counts as a rounding error. It is relative to 1, or to the ratio R if
        the condition contains R.
    pivot : float
        Least coefficient, as a fraction of the largest, of a condition that may become inactive.
    most : int
        Largest number of exchanges, several times the usual number for four unknowns.
    """

    start_rows: int = 9
    first_rows: int = 500
    most_rounds: int = 200
    box: float = 1e7
    feasible: float = 1e-10
    pivot: float = 1e-9
    most: int = 200


METHOD = Exchange()


@dataclass(frozen=True, eq=False)
class MinimaxSolution:
    """Result of `minimax_ratio`.

    Attributes
    ----------
    x : (m,) array
        Unknowns.
    ratio : float
        Ratio R: largest value of the stiffness; the least value is at least 1.
    values : (n,) array
        Stiffness rows @ x + offset at all samples.
    """

    x: FloatArray
    ratio: float
    values: FloatArray


def minimax_ratio(
    rows: FloatArray,
    *,
    offset: FloatArray | None = None,
    side_rows: FloatArray | None = None,
    side_offset: FloatArray | None = None,
) -> MinimaxSolution | None:
    """Return the global minimum of R subject to 1 <= rows @ x + offset <= R (paper, Eq. 4).

    Parameters
    ----------
    rows : (n, m) array
        The stiffness at sample i is rows[i] @ x + offset[i]; the number m of unknowns is small.
    offset : (n,) array, optional
        By default zero.
    side_rows : (k, m) array, optional
        Further conditions side_rows @ x + side_offset >= 0.
    side_offset : (k,) array, optional
        By default zero.
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
        allowed = side_offset is None or bool(side_offset.min(initial=0.0) >= -METHOD.feasible)
        fits = allowed and bool(offset.min() >= 1 - METHOD.feasible)
        return MinimaxSolution(np.zeros(0), float(offset.max()), offset) if fits else None
    if m == 1 and side_rows is None and not offset.any():
        return _single(rows[:, 0])
    program = MinimaxProgram(rows, side_rows=side_rows, side_offset=side_offset)
    step = max(1, n // METHOD.first_rows)
    new: Any = slice(None, None, step)
    for _ in range(METHOD.most_rounds):
        program.demand(rows[new], offset[new], rows[new], offset[new])
        answer = program.solve()
        if answer is None:
            return None
        x, ratio = answer
        values = rows @ x + offset
        before, new = new, [int(values.argmin()), int(values.argmax())]
        least, largest = values[new].tolist()
        holds = least >= 1 - METHOD.feasible and largest <= ratio + METHOD.feasible * max(1.0, ratio)
        if step == 1 or holds or new == before:
            return MinimaxSolution(x, max(ratio, largest), values)
    raise unsettled(ratio)


def start_rows(count: int) -> list[int]:
    """Return the indices of `METHOD.start_rows` evenly distributed samples of `count` samples."""
    return (np.arange(METHOD.start_rows) * (count - 1) // (METHOD.start_rows - 1)).tolist()


def unsettled(ratio: float) -> NotConvergedError:
    """Return the error for a linear program that needs too many rounds of additional rows."""
    return NotConvergedError(
        f"the linear program for the stiffness ratio did not converge in {METHOD.most_rounds} "
        f"rounds (ratio {ratio:.6g}): the curve has almost straight places; move its control "
        "points a little"
    )


class MinimaxProgram:
    """Linear program: minimise R subject to bounds on rows @ x + offset.

    Bounds can be added between solutions. The method is Stiefel's exchange method, which is the dual simplex
    method for
    few unknowns and many rows. The current vertex has the least R under its active conditions. In each step the
    most
    violated condition becomes active, and the condition whose multiplier would become negative first becomes
    inactive. If
    this fails, HiGHS solves the program or finds it infeasible.

    Sources: Stiefel, "Uber diskrete und lineare Tschebyscheff-Approximationen", Numer. Math. 1 (1959); Lemke, "The
    dual method of solving the linear programming problem", Naval Res. Logist. Q. 1 (1954).

    Parameters
    ----------
    samples : (n, m) array
        Typical rows of the bounds; they determine the scaling of the unknowns.
    side_rows, side_offset : (k, m), (k,) arrays, optional
        Further conditions side_rows @ x + side_offset >= 0.
    """

    def __init__(
        self,
        samples: FloatArray,
        *,
        side_rows: FloatArray | None = None,
        side_offset: FloatArray | None = None,
    ) -> None:
        self.basis = _conditioned(samples)
        unknowns = self.basis.shape[1]
        # the conditions are rows @ (x, R) >= limits; R >= 0 and -box <= x define the first vertex, and x <=
        # box follows
        box = np.eye(unknowns + 1)
        self.rows = np.concatenate([box, -box[:-1]])
        self.limits = np.full(2 * unknowns + 1, -METHOD.box)
        self.limits[unknowns] = 0.0
        self.active = np.arange(unknowns + 1)
        if side_rows is not None:
            self.hold(side_rows, np.zeros(len(side_rows)) if side_offset is None else side_offset)

    def demand(
        self, low: FloatArray, low_offset: FloatArray, high: FloatArray, high_offset: FloatArray
    ) -> None:
        """Add the rows 1 <= low @ x + low_offset and high @ x + high_offset <= R."""
        share = np.repeat([0.0, 1.0], [len(low), len(high)])
        self._add(np.concatenate([low, -high]), np.concatenate([low_offset - 1, -high_offset]), share)

    def hold(self, rows: FloatArray, offset: FloatArray) -> None:
        """Add the rows rows @ x + offset >= 0."""
        self._add(rows, offset, np.zeros(len(rows)))

    def _add(self, rows: FloatArray, offset: FloatArray, share: FloatArray) -> None:
        """Add the conditions rows @ x + offset + share * R >= 0, with 0 or 1 for each row in `share`."""
        more = np.concatenate([rows @ self.basis, share[:, None]], axis=1)
        self.rows = np.concatenate([self.rows, more])
        self.limits = np.concatenate([self.limits, -offset])

    def solve(self) -> tuple[FloatArray, float] | None:
        """Return x and R, or None if no x satisfies the conditions."""
        answer = self._exchanged()
        if answer is None:
            boxes = 2 * self.basis.shape[1] + 1
            answer = _by_highs(self.rows[boxes:], self.limits[boxes:])
        return None if answer is None else (self.basis @ answer[:-1], float(answer[-1]))

    def _exchanged(self) -> FloatArray | None:
        """Return the vertex (x, R), or None if the program is unbounded, infeasible or almost degenerate."""
        active, unknowns = self.active, self.basis.shape[1]
        rows, limits = self.rows[active], self.limits[active]
        for _ in range(METHOD.most):
            try:
                inverse = np.linalg.inv(rows)
            except np.linalg.LinAlgError:
                return None
            vertex = inverse.dot(limits)  # `dot` takes half the time of `@` for arrays of this size
            # one step of iterative refinement reduces the error to rounding errors
            vertex += inverse.dot(limits - rows.dot(vertex))
            excess = self.rows.dot(vertex) - self.limits
            if vertex[-1] > 1:
                excess /= 1 + self.rows[:, -1] * (vertex[-1] - 1)
            worst = int(excess.argmin())
            if excess[worst] >= -METHOD.feasible:
                boxed = (active < 2 * unknowns + 1) & (active != unknowns)
                return vertex if not boxed.any() and np.isfinite(vertex).all() else None
            # coefficients of the entering row, and of R (`share`), in terms of the active rows
            parts, share = self.rows[worst].dot(inverse), inverse[-1]
            leaving = (parts > METHOD.pivot * np.abs(parts).max()).nonzero()[0]
            if leaving.size == 0:
                return None
            out = leaving[(share[leaving] / parts[leaving]).argmin()]
            active[out], rows[out], limits[out] = worst, self.rows[worst], self.limits[worst]
        return None


def _single(row: FloatArray) -> MinimaxSolution | None:
    """Return the solution for a single unknown, which only scales the stiffness."""
    low, high = row.min(), row.max()
    if low > 0:
        return MinimaxSolution(np.array([1 / low]), float(high / low), row / low)
    if high < 0:
        return MinimaxSolution(np.array([1 / high]), float(low / high), row / high)
    return None


def _conditioned(rows: FloatArray) -> FloatArray:
    """Return columns (m, k) that scale the unknowns: coefficients of order 1 then give stiffnesses of order 1."""
    thinned = rows[:: max(1, len(rows) // 64)]
    _, size, vt = svd(thinned, full_matrices=False)
    keep = size > 1e-13 * size[0] if size[0] > 0 else np.ones(size.size, dtype=bool)
    return np.asarray(vt[keep].T * (np.sqrt(len(thinned)) / np.where(size[keep] > 0, size[keep], 1.0)))


def _by_highs(rows: FloatArray, limits: FloatArray) -> FloatArray | None:
    """Return (x, R) with the least R subject to rows @ (x, R) >= limits, or None if there is none.

    The solver is HiGHS; in FreeCAD it is the HiGHS of SciPy.
    """
    tolerances = {"primal_feasibility_tolerance": 1e-10, "dual_feasibility_tolerance": 1e-10}
    count, columns = rows.shape
    try:
        import highspy
    except ImportError:
        from scipy.optimize import linprog

        cost, options = np.eye(columns)[-1], {"presolve": False, **tolerances}
        result = linprog(cost, -rows, -limits, bounds=(None, None), method="highs", options=options)
        if result.status == 0:
            return np.asarray(result.x, dtype=float)
        infeasible = result.status == 2
    else:
        # use the base class of Highs, because Highs prints a banner before output can be switched off
        highs = highspy.Highs.__bases__[0]()
        silent = {"output_flag": False, "presolve": "off", "solver": "simplex", "parallel": "off"}
        for name, value in {**silent, **tolerances}.items():
            highs.setOptionValue(name, value)
        free, entry = np.full(columns, np.inf), np.arange(rows.size, dtype=np.int32)
        highs.addVars(columns, -free, free)
        highs.changeColCost(columns - 1, 1.0)
        highs.addRows(
            count, limits, np.full(count, np.inf), rows.size, entry[::columns], entry % columns, rows.ravel()
        )
        highs.run()
        status, known = highs.getModelStatus(), highspy.HighsModelStatus
        if status == known.kOptimal:
            return np.array(highs.getSolution().col_value)
        infeasible = status in (known.kInfeasible, known.kUnboundedOrInfeasible)
    if infeasible:
        return None
    raise NotConvergedError(
        "no stiffness keeps the curve under this weight, because the ratio of largest to smallest stiffness "
        "would be too large. Use a lighter or stiffer sheet, support the strip, or change the curve"
    )


def least_variation(
    rows: FloatArray,
    offset: FloatArray,
    bends: FloatArray,
    bend_offset: FloatArray,
    largest: float,
    sides: tuple[FloatArray, FloatArray] | None = None,
) -> FloatArray:
    """Return the x that minimises sum |bends @ x + bend_offset| subject to 1 <= rows @ x + offset <= largest.

    If `bends` contain the second derivative K'' of the stiffness times the length of each sample, the sum is the
    total variation of K' (paper, section 5.3).

    Parameters
    ----------
    rows, offset : (n, m) and (n,) arrays
        The stiffness at the samples is rows @ x + offset.
    bends, bend_offset : (k, m) and (k,) arrays
        Terms of the sum.
    sides : (j, m) and (j,) arrays, optional
        Rows and offsets of further conditions rows @ x + offset >= 0.
    """
    from scipy.optimize import linprog

    side_rows, side_offset = (np.zeros((0, bends.shape[1])), np.zeros(0)) if sides is None else sides
    if bends.shape[1] == 1 and not len(side_rows):
        return _least_variation_of_one(rows[:, 0], offset, bends[:, 0], bend_offset, largest)
    basis = _conditioned(rows)
    rows, bends = rows @ basis, bends @ basis
    size = np.abs(bends).max() or 1.0
    bends, bend_offset = bends / size, bend_offset / size
    # the dual program has a row for each unknown, and the unknowns are the multipliers of its solution
    matrix = np.concatenate([bends, -rows, rows, -side_rows @ basis]).T
    cost = -np.concatenate([bend_offset, 1 - offset, offset - largest, -side_offset])
    bounds = np.zeros((cost.size, 2))
    bounds[:, 1] = np.inf
    bounds[: len(bends)] = -1.0, 1.0
    result = linprog(cost, A_eq=matrix, b_eq=np.zeros(len(matrix)), bounds=bounds, method="highs",
                     options={"presolve": False})  # fmt: skip
    if result.status != 0:
        raise NotConvergedError(f"the second phase for a smooth stiffness stopped: {result.message}")
    return np.asarray(basis @ result.eqlin.marginals, dtype=float)


def _least_variation_of_one(
    row: FloatArray, offset: FloatArray, bend: FloatArray, bend_offset: FloatArray, largest: float
) -> FloatArray:
    """Return the solution for a single number x.

    It is the weighted median of the zeros of the terms, clipped to the bounds.
    """
    counts = bend != 0
    zeros, steep = -bend_offset[counts] / bend[counts], np.abs(bend[counts])
    order = np.argsort(zeros)
    passed = np.cumsum(steep[order])
    best = float(zeros[order][np.searchsorted(passed, passed[-1] / 2)]) if zeros.size else 0.0
    moves = row != 0
    bounds = np.sort([(1 - offset[moves]) / row[moves], (largest - offset[moves]) / row[moves]], axis=0)
    low, high = float(bounds[0].max()), float(bounds[1].min())
    return np.array([min(max(best, low), high) if low <= high else (low + high) / 2])


def largest_number(rows: FloatArray, number: FloatArray, largest: float, side_rows: FloatArray) -> FloatArray:
    """Return the x that maximises number @ x subject to 1 <= rows @ x <= largest and side_rows @ x >= 0."""
    from scipy.optimize import linprog

    basis = _conditioned(rows)
    rows, cost = rows @ basis, number @ basis
    matrix = np.concatenate([-rows, rows, -side_rows @ basis])
    limit = np.repeat([-1.0, largest, 0.0], [len(rows), len(rows), len(side_rows)])
    result = linprog(-cost / np.abs(cost).max(), matrix, limit, bounds=(None, None), method="highs")
    if result.status != 0:
        raise NotConvergedError(f"the linear program for the bending stiffness stopped: {result.message}")
    return np.asarray(basis @ result.x, dtype=float)
