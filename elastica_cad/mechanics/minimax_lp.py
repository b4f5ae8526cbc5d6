"""Linear programs with few unknowns for the least stiffness ratio, and for the smoothest stiffness near it."""

from dataclasses import dataclass
from typing import Any, NamedTuple

import numpy as np

from elastica_cad._compiled_scipy import svd
from elastica_cad._types import FloatArray
from elastica_cad.errors import NotConvergedError


class Exchange(NamedTuple):
    """Settings of the exchange method for linear programs, which `MinimaxProgram` describes.

    Attributes
    ----------
    most_rounds : int
        Largest number of times that a program is solved. Rows are added after each solution.
    first_rows : int
        Approximate number of samples of a long curve, at equal spacing, in the first program.
    first_step : int
        For a smooth stiffness, the first program contains every `first_step`-th sample of the curve.
    box : float
        Bound of the unknowns, which are scaled to about 1. The first vertex is at this bound.
    feasible : float
        Largest violation of a condition that counts as a rounding error. The violation is relative to 1, or to
        the ratio R if the condition contains R.
    pivot : float
        Least coefficient of a condition that may become inactive, as a fraction of the largest coefficient.
    most : int
        Largest number of exchanges, several times the usual number for four unknowns.
    most_steps : int
        Largest number of steps along edges in `least_variation`, several times the largest number seen.
    tilt : float
        Size of random shifts of the planes that `least_variation` describes. After the shifts, at most as many
        planes as unknowns meet in a point.
    """

    first_rows: int = 500
    first_step: int = 12
    most_rounds: int = 200
    box: float = 1e7
    feasible: float = 1e-10
    pivot: float = 1e-9
    most: int = 200
    most_steps: int = 2000
    tilt: float = 1e-9


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
    side_rows = np.zeros((0, m)) if side_rows is None else side_rows
    side_offset = np.zeros(len(side_rows)) if side_offset is None else side_offset
    if m == 0:
        fits = min(offset.min() - 1, side_offset.min(initial=0.0)) >= -METHOD.feasible
        return MinimaxSolution(np.zeros(0), float(offset.max()), offset) if fits else None
    if m == 1 and not len(side_rows) and not offset.any():
        return _solution_of_one_unknown(rows[:, 0])
    program = MinimaxProgram(rows)
    program.hold(side_rows, side_offset)
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
        # if the worst samples are already in the program, only rounding errors remain
        if step == 1 or holds or new == before:
            return MinimaxSolution(x, max(ratio, largest), values)
    raise unsettled(ratio)


def unsettled(ratio: float) -> NotConvergedError:
    """Return the error for a linear program that needs too many rounds."""
    return NotConvergedError(
        f"the linear program for the stiffness ratio did not converge in {METHOD.most_rounds} "
        f"rounds (ratio {ratio:.6g}): the curve has almost straight places; move its control "
        "points a little"
    )


class MinimaxProgram:
    """Linear program: minimise R subject to bounds on rows @ x + offset.

    Bounds can be added between solutions. The method is Stiefel's exchange method, which is the dual simplex
    method for few unknowns and many rows. The current vertex has the least R under its active conditions. In
    each step the most violated condition becomes active, and the condition whose multiplier would become
    negative first becomes inactive. If the exchange fails, the solver HiGHS is used.

    Sources: Stiefel, "Uber diskrete und lineare Tschebyscheff-Approximationen", Numer. Math. 1 (1959); Lemke, "The
    dual method of solving the linear programming problem", Naval Res. Logist. Q. 1 (1954).

    Parameters
    ----------
    samples : (n, m) array
        Typical rows of the bounds, which determine the scaling of the unknowns.
    most : float
        Largest useful R. There is no solution if R must be larger. With a finite limit, HiGHS is not used.
    """

    def __init__(self, samples: FloatArray, *, most: float = np.inf) -> None:
        self.most = most
        self.basis = _conditioned(samples)
        unknowns = self.basis.shape[1]
        # rows @ (x, R) >= limits: first -METHOD.box <= x <= METHOD.box and R >= 0; the solver starts at the vertex
        # x = -METHOD.box, R = 0
        box = np.eye(unknowns + 1)
        self.rows = np.concatenate([box, -box[:-1]])
        self.limits = np.full(2 * unknowns + 1, -METHOD.box)
        self.limits[unknowns] = 0.0
        self.active = np.arange(unknowns + 1)

    def demand(
        self, low: FloatArray, low_offset: FloatArray, high: FloatArray, high_offset: FloatArray
    ) -> None:
        """Add the conditions 1 <= low @ x + low_offset and high @ x + high_offset <= R."""
        share = np.repeat([0.0, 1.0], [len(low), len(high)])
        self._add(np.concatenate([low, -high]), np.concatenate([low_offset - 1, -high_offset]), share)

    def hold(self, rows: FloatArray, offset: FloatArray) -> None:
        """Add the conditions rows @ x + offset >= 0."""
        self._add(rows, offset, np.zeros(len(rows)))

    def _add(self, rows: FloatArray, offset: FloatArray, share: FloatArray) -> None:
        """Add the conditions rows @ x + offset + share * R >= 0."""
        more = np.concatenate([rows @ self.basis, share[:, None]], axis=1)
        self.rows = np.concatenate([self.rows, more])
        self.limits = np.concatenate([self.limits, -offset])

    def solve(self) -> tuple[FloatArray, float] | None:
        """Return x and R, or None if no x satisfies the conditions with R up to `most`."""
        answer = self._exchanged()
        if answer is None and self.most == np.inf:
            boxes = 2 * self.basis.shape[1] + 1
            answer = _by_highs(self.rows[boxes:], self.limits[boxes:])
        if answer is None or answer[-1] > self.most:
            return None
        return self.basis @ answer[:-1], float(answer[-1])

    def _exchanged(self) -> FloatArray | None:
        """Return the optimal vertex (x, R), or None if the program is unbounded, infeasible or degenerate.

        R is the objective. The search also ends at the first vertex with R above `most`, because R never
        decreases.
        """
        active, unknowns = self.active, self.basis.shape[1]
        rows, limits = self.rows[active], self.limits[active]
        for _ in range(METHOD.most):
            try:
                inverse = np.linalg.inv(rows)
            except np.linalg.LinAlgError:
                return None
            vertex = inverse.dot(limits)  # `dot` is twice as fast as `@` for such small arrays
            # iterative refinement removes rounding errors
            vertex += inverse.dot(limits - rows.dot(vertex))
            if vertex[-1] > self.most:
                return np.asarray(vertex)
            excess = self.rows.dot(vertex) - self.limits
            if vertex[-1] > 1:  # violations of conditions that contain R are relative to R
                excess /= 1 + self.rows[:, -1] * (vertex[-1] - 1)
            worst = int(excess.argmin())
            if excess[worst] >= -METHOD.feasible:
                # at a bound -METHOD.box or METHOD.box of an unknown, the program is unbounded
                boxed = (active < 2 * unknowns + 1) & (active != unknowns)
                return vertex if not boxed.any() and np.isfinite(vertex).all() else None
            # coefficients of the active conditions in the new condition (`parts`) and in R (`share`)
            parts, share = self.rows[worst].dot(inverse), inverse[-1]
            leaving = (parts > METHOD.pivot * np.abs(parts).max()).nonzero()[0]
            if leaving.size == 0:
                return None
            out = leaving[(share[leaving] / parts[leaving]).argmin()]
            active[out], rows[out], limits[out] = worst, self.rows[worst], self.limits[worst]
        return None


def _solution_of_one_unknown(row: FloatArray) -> MinimaxSolution | None:
    """Return the x for which the least of row x is 1, or None if the row has a zero or both signs."""
    low, high = row.min(), row.max()
    if low <= 0 <= high:
        return None
    least = low if low > 0 else high
    values = row / least
    return MinimaxSolution(np.array([1 / least]), float(values.max()), values)


def _conditioned(rows: FloatArray) -> FloatArray:
    """Return a basis (m, k) of the unknowns in which coefficients near 1 give stiffnesses near 1."""
    thinned = rows[:: max(1, len(rows) // 64)]
    _, size, vt = svd(thinned, full_matrices=False)
    keep = size > 1e-13 * size[0] if size[0] > 0 else np.ones(size.size, dtype=bool)
    return np.asarray(vt[keep].T * (np.sqrt(len(thinned)) / np.where(size[keep] > 0, size[keep], 1.0)))


def _by_highs(rows: FloatArray, limits: FloatArray) -> FloatArray | None:
    """Minimise R subject to rows @ (x, R) >= limits with HiGHS; return (x, R), or None if infeasible."""
    tolerances = {"primal_feasibility_tolerance": 1e-10, "dual_feasibility_tolerance": 1e-10}
    count, columns = rows.shape
    try:
        import highspy
    except ImportError:
        from scipy.optimize import linprog

        cost = np.eye(columns)[-1]
        for presolve in (False, True):
            options = {"presolve": presolve, **tolerances}
            result = linprog(cost, -rows, -limits, bounds=(None, None), method="highs", options=options)
            if result.status == 0:
                return np.asarray(result.x, dtype=float)
            if result.status == 2:
                return None
    else:
        # `Highs` prints a banner, its base class does not
        highs = highspy.Highs.__bases__[0]()
        silent = {"output_flag": False, "solver": "simplex", "parallel": "off"}
        for name, value in {**silent, **tolerances}.items():
            highs.setOptionValue(name, value)
        free, entry = np.full(columns, np.inf), np.arange(rows.size, dtype=np.int32)
        starts = entry[::columns].copy()  # highspy 1.7 reads a view as if it were contiguous
        highs.addVars(columns, -free, free)
        highs.changeColCost(columns - 1, 1.0)
        highs.addRows(count, limits, np.full(count, np.inf), rows.size, starts, entry % columns, rows.ravel())
        statuses = highspy.HighsModelStatus
        for presolve in (False, True):
            highs.setOptionValue("presolve", "on" if presolve else "off")
            highs.clearSolver()
            highs.run()
            status = highs.getModelStatus()
            if status == statuses.kOptimal:
                return np.array(highs.getSolution().col_value)
            if status in (statuses.kInfeasible, statuses.kUnboundedOrInfeasible):
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
    start: FloatArray,
    sides: tuple[FloatArray, FloatArray] | None = None,
) -> FloatArray:
    """Return the x that minimises sum |bends @ x + bend_offset| subject to 1 <= rows @ x + offset <= largest.

    If a term is the second derivative K'' of the stiffness times the length of a sample, the sum is the total
    variation of K' (paper, section 5.3). A plane contains the x for which a term is zero or a condition is an
    equation. In a vertex, m planes meet. Each step follows the steepest edge of a vertex while the sum decreases.

    Parameters
    ----------
    rows, offset : (n, m) and (n,) arrays
        The stiffness at the samples is rows @ x + offset.
    bends, bend_offset : (k, m) and (k,) arrays
        Terms of the sum.
    start : (m,) array
        Unknowns x that satisfy the conditions.
    sides : (j, m) and (j,) arrays, optional
        Rows and offsets of further conditions rows @ x + offset >= 0.

    References
    ----------
    Barrodale and Roberts, "An improved algorithm for discrete l1 linear approximation", SIAM J. Numer. Anal. 10
    (1973).
    """
    side_rows, side_offset = (np.zeros((0, bends.shape[1])), np.zeros(0)) if sides is None else sides
    basis, terms = _conditioned(rows), len(bends)
    planes = np.concatenate([bends, rows, -rows, side_rows]) @ basis
    limits = np.concatenate([bend_offset, offset - 1, largest - offset, side_offset])
    # scale conditions to norm 1, and all terms by the same number
    size = np.linalg.norm(planes, axis=1)
    size[:terms] = size[:terms].max()
    size[size == 0] = 1.0
    planes, limits = planes / size[:, None], limits / size
    x = np.linalg.lstsq(basis, start, rcond=None)[0]
    # make the start feasible, then shift all planes so that at most m planes meet in a point
    limits[terms:] += np.maximum(-(planes[terms:] @ x + limits[terms:]), 0.0)
    shifted = limits.size - len(side_rows)
    limits[:shifted] += METHOD.tilt * np.random.default_rng(0).uniform(1.0, 2.0, shifted)
    # start in a vertex of m auxiliary planes, which are neither terms nor conditions
    active, normals = np.full(x.size, -1), np.eye(x.size)
    for _ in range(METHOD.most_steps):
        values = planes @ x + limits
        values[terms:] = np.maximum(values[terms:], 0.0)
        values[active[active >= 0]] = 0.0
        edges = np.linalg.inv(normals)
        slopes = np.sign(values[:terms]) @ planes[:terms] @ edges
        # slopes of the objective along both directions of each edge
        changes = np.array([slopes, -slopes]) + ((active >= 0) & (active < terms))
        changes[1, active >= terms] = np.inf  # this direction would violate the condition
        steepness = changes / np.linalg.norm(edges, axis=0)
        back, out = divmod(int(steepness.argmin()), x.size)
        if steepness[back, out] >= -METHOD.feasible * terms:
            return basis @ x
        step = edges[:, out] * (1 - 2 * back)
        rates = planes @ step
        rates[active[active >= 0]] = 0.0
        rates[np.abs(rates) < METHOD.pivot * np.linalg.norm(step)] = 0.0
        meets = (values * rates < 0).nonzero()[0]
        meets = np.append(meets[meets < terms], terms + (rates[terms:] < 0).nonzero()[0])
        meets = meets[(np.abs(values[meets] / rates[meets])).argsort()]
        # beyond each plane of a term, the slope of the sum is larger by `gains`; a condition ends the step
        gains = np.where(meets < terms, 2 * np.abs(rates[meets]), np.inf)
        turns = (changes[back, out] + gains.cumsum() >= 0).nonzero()[0]
        if not turns.size:
            break
        active[out] = meets[turns[0]]
        x = x - values[active[out]] / rates[active[out]] * step
        normals[out] = planes[active[out]]
    raise NotConvergedError(
        "the linear program that smooths the stiffness did not converge: draw a smoother curve"
    )


def largest_number(rows: FloatArray, number: FloatArray, largest: float, side_rows: FloatArray) -> FloatArray:
    """Return the x that maximises number @ x subject to 1 <= rows @ x <= largest and side_rows @ x >= 0."""
    from scipy.optimize import linprog

    basis = _conditioned(rows)
    rows, cost = rows @ basis, number @ basis
    matrix = np.concatenate([-rows, rows, -side_rows @ basis])
    limit = np.repeat([-1.0, largest, 0.0], [len(rows), len(rows), len(side_rows)])
    result = linprog(-cost / np.abs(cost).max(), matrix, limit, bounds=(None, None), method="highs")
    if result.status != 0:
        raise NotConvergedError(
            f"the linear program for the bending stiffness stopped ({result.message}): draw a smoother curve"
        )
    return np.asarray(basis @ result.x, dtype=float)
