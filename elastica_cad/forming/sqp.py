"""Sequential quadratic programming with a trust region and an exact penalty: every iterate is a rod in balance."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.forming.constraints import Constraint
from elastica_cad.forming.distance import Distance, LocalModel
from elastica_cad.forming.march import MarchedRod, Sensitivities, StripGrid
from elastica_cad.forming.qp import QuadraticProgram, QuadraticSolution, solve_quadratic

__all__ = ["Outcome", "Problem", "lifted", "solve"]

STEPS = 80
SETTLED = 3e-4  # a step that promises less than this share of the distance ends the search
CLOSED = 1e-9  # what a limit that is touched keeps in hand
SMALLEST_RADIUS = 1e-7
_GOOD = 0.5  # share of the promised gain above which a step is taken as it is
_MENDING = 4  # Newton steps
_LOST = 3.0  # an angle that is still this wrong will not close
_TOUCHED = 1e-3
_DAMPING = 1e-9
_FAR = 20.0  # radius of the lifted steps
_CALM = 1e-6  # where several forces do, the start takes the least: the likeliest to be stable
_RESOLUTION = 1e-11  # of half the mean square distance: a micrometre on a strip of 300 mm


@dataclass(frozen=True, eq=False)
class Problem:
    """Minimise `distance` over z in a box under `constraints`.

    Attributes
    ----------
    lower, upper : (p,) arrays
        Equal where an unknown is given.
    scale : (p,) array
        Typical sizes of the unknowns.
    """

    grid: StripGrid
    distance: Distance
    constraints: tuple[Constraint, ...]
    lower: FloatArray
    upper: FloatArray
    scale: FloatArray

    def merit(self, rod: MarchedRod, values: Sequence[FloatArray], prices: Sequence[float]) -> float:
        """Distance and the price of what is broken."""
        return self.distance.value(rod) + sum(
            price * float(_broken(c, v).sum())
            for c, v, price in zip(self.constraints, values, prices, strict=True)
        )

    def values(self, rod: MarchedRod) -> list[FloatArray]:
        """Values of all constraints."""
        return [c.values(rod) for c in self.constraints]

    def violation(self, values: Sequence[FloatArray]) -> float:
        """The worst broken constraint."""
        return max(
            (float(_broken(c, v).max()) for c, v in zip(self.constraints, values, strict=True)), default=0.0
        )

    def with_length(self, length: float) -> "Problem":
        """The same with the length given, as far as it is allowed."""
        lower, upper, at = self.lower.copy(), self.upper.copy(), self.grid.unknowns.length
        lower[at] = upper[at] = np.clip(length, lower[at], upper[at])
        return replace(self, lower=lower, upper=upper)

    def eager(self) -> "Problem":
        """The same without the constraints that make no sense far from balance."""
        return replace(self, constraints=tuple(c for c in self.constraints if not c.patient))


@dataclass(frozen=True, eq=False)
class Outcome:
    """Where the search ended.

    Attributes
    ----------
    rod : MarchedRod
    distance, violation : float
    multipliers : tuple of (k,) arrays
        Of every constraint's values: d(distance) / d(value).
    at_lower, at_upper : (p,) arrays
        Multipliers of the box.
    iterations : int
    settled : bool
    """

    rod: MarchedRod
    distance: float
    violation: float
    multipliers: tuple[FloatArray, ...]
    at_lower: FloatArray
    at_upper: FloatArray
    iterations: int
    settled: bool


def lifted(
    problem: Problem, z: FloatArray, angles: FloatArray, moments: FloatArray, steps: int = 3
) -> FloatArray:
    """Unknowns of a rod near given angles (n+2,) and moments (n+1,) that are not in balance.

    Angles and moments are unknowns of their own here and the march is one more constraint, linearised about
    them: the start may be the wish itself, and the program is convex whatever the wish (the first step weighs
    the equation's error K kappa - M by its effect on the shape).
    """
    problem = problem.eager()
    for _ in range(steps):
        rod = problem.grid.guessed(z, angles, moments)
        sensitivities = problem.grid.sensitivities(rod, closing=True)
        model = problem.distance.model(rod, sensitivities)
        rows = _rows(problem, sensitivities)
        step, _ = _step(problem, z, model, rows, _FAR, _CALM)
        if step is None:
            break
        z = np.clip(z + step, problem.lower, problem.upper)
        angles = angles + sensitivities.angles @ np.append(step, 1.0)
        moments = moments + sensitivities.moments @ np.append(step, 1.0)
    return z


def solve(problem: Problem, z: FloatArray, *, steps: int = STEPS, radius: float = 1.0) -> Outcome:
    """The local minimum downhill from z.

    The Gauss-Newton model of the distance, linearised constraints with prices, a box of size `radius` (in
    scales), one quadratic program a step. A step that disappoints when marched is tried again with the whole
    rod following it; the merit's prices follow the multipliers (Powell's rule).
    """
    rod = problem.grid.rod(np.clip(z, problem.lower, problem.upper))
    if not np.isfinite(rod.moments[-1]):
        rod = problem.grid.rod(_slack(problem))
    values = problem.values(rod)
    prices = [0.0] * len(problem.constraints)
    found: tuple[_Rows, QuadraticSolution] | None = None
    settled, iteration = False, 0
    while iteration < steps and not settled and radius > SMALLEST_RADIUS:
        iteration += 1
        sensitivities = problem.grid.sensitivities(rod)
        model = problem.distance.model(rod, sensitivities)
        rows = _rows(problem, sensitivities, values)
        floor = SETTLED * problem.distance.value(rod) + _RESOLUTION
        accepted = False
        while not accepted and radius > SMALLEST_RADIUS:
            step, solution = _step(problem, rod.z, model, rows, radius)
            if step is None or solution is None:
                radius *= 0.25
                continue
            found = rows, solution
            prices = _prices(problem, rows, solution, prices)
            merit = problem.merit(rod, values, prices)
            promised = _promised(model, rows, step, np.array(prices))
            size = float(np.abs(step / problem.scale).max())
            settled = promised <= floor
            trial = problem.grid.rod(np.clip(rod.z + step, problem.lower, problem.upper))
            trial_values, trial_merit = _judged(problem, trial, prices)
            gain = (merit - trial_merit) / max(promised, 1e-300)
            if gain < _GOOD:
                mended = _mended(problem, rows, solution, sensitivities, step)
                if mended is not None:
                    mended_values, mended_merit = _judged(problem, mended, prices)
                    if mended_merit < trial_merit:
                        trial, trial_values, trial_merit = mended, mended_values, mended_merit
            gain = (merit - trial_merit) / max(promised, 1e-300)
            accepted = gain > 1e-4
            if accepted:
                rod, values = trial, trial_values
            if settled:
                break
            if gain > 0.75:
                radius = max(radius, min(5.0, 2 * size))
            elif gain < 0.25:
                radius = (0.5 if accepted else 0.3) * size
    rod = _closed(problem, rod, values)
    values = problem.values(rod)
    multipliers, low, high = _multipliers(problem, values, found)
    return Outcome(
        rod,
        problem.distance.value(rod),
        problem.violation(values),
        multipliers,
        low,
        high,
        iteration,
        settled,
    )


def _slack(problem: Problem) -> FloatArray:
    """Unknowns of a rod without forces: from here something can always be said."""
    u = problem.grid.unknowns
    z = np.zeros(u.count)
    z[u.stiffness], z[u.length] = 1.0, 1.0
    return np.clip(z, problem.lower, problem.upper)


@dataclass(frozen=True, eq=False)
class _Rows:
    """The constraints' rows that matter, stacked."""

    constraint: IntArray
    index: IntArray
    value: FloatArray
    jacobian: FloatArray
    price: FloatArray
    one_sided: FloatArray

    @property
    def keys(self) -> IntArray:
        """One number for each row, the same from rod to rod."""
        return self.constraint * 1_000_000 + self.index


def _judged(problem: Problem, rod: MarchedRod, prices: Sequence[float]) -> tuple[list[FloatArray], float]:
    """Values and merit; infinite merit for a rod that has wound up beyond all measure."""
    if not np.isfinite(rod.moments[-1]):
        return [], np.inf
    values = problem.values(rod)
    return values, problem.merit(rod, values, prices)


def _broken(constraint: Constraint, values: FloatArray) -> FloatArray:
    return np.maximum(-values, 0.0) if constraint.one_sided else np.abs(values)


def _rows(
    problem: Problem,
    sensitivities: Sensitivities,
    values: Sequence[FloatArray] | None = None,
    which: Sequence[int] | None = None,
) -> _Rows:
    """Rows of the constraints numbered `which` (all unless given); their `values` if they are at hand."""
    p = sensitivities.rod.z.size
    parts: list[tuple[FloatArray | IntArray, ...]] = []
    for k in range(len(problem.constraints)) if which is None else which:
        constraint = problem.constraints[k]
        value = constraint.values(sensitivities.rod) if values is None else values[k]
        index, jacobian = constraint.rows(sensitivities)
        at = value[index] + (jacobian[:, p] if jacobian.shape[1] > p else 0.0)
        same = np.ones(index.size)
        parts.append(
            (k * same, index, at, jacobian[:, :p], constraint.price * same, constraint.one_sided * same)
        )
    if not parts:
        none, empty = np.zeros(0), np.zeros(0, dtype=int)
        return _Rows(empty, empty, none, np.zeros((0, p)), none, none)
    number, index, at, jacobian, price, one_sided = (
        np.concatenate(part) for part in zip(*parts, strict=True)
    )
    return _Rows(number.astype(int), index.astype(int), at, jacobian, price, one_sided)


def _step(
    problem: Problem, z: FloatArray, model: LocalModel, rows: _Rows, radius: float, damping: float = _DAMPING
) -> tuple[FloatArray | None, QuadraticSolution | None]:
    """The step of the quadratic program within `radius` scales, and its solution in scales."""
    s = problem.scale
    p = z.size
    hessian = model.hessian * np.outer(s, s)
    hessian[np.diag_indices(p)] += damping * max(float(np.diag(hessian).max()), 1e-12)
    lower = np.maximum((problem.lower - z) / s, -radius)
    upper = np.minimum((problem.upper - z) / s, radius)
    jacobian, value = rows.jacobian * s, rows.value
    gradient, price, one_sided = model.gradient * s, rows.price, rows.one_sided > 0
    if model.peaks.size:
        # one more unknown t >= every peak; its rows cannot be worth breaking
        k, top = model.peaks.size, float(model.peaks.max())
        grown = np.zeros((p + 1, p + 1))
        grown[:p, :p] = hessian
        hessian, gradient = grown, np.append(gradient, 1.0)
        lower, upper = np.append(lower, -2 * top - 1e-9), np.append(upper, 2 * top + 1e-9)
        jacobian = np.block([[jacobian, np.zeros((value.size, 1))], [-model.peak_rows * s, np.ones((k, 1))]])
        value = np.append(value, top - model.peaks)
        price = np.append(price, np.full(k, 10.0))
        one_sided = np.append(one_sided, np.ones(k, dtype=bool))
    solution = solve_quadratic(
        QuadraticProgram(hessian, gradient, lower, upper, jacobian, -value, price, one_sided)
    )
    if not np.all(np.isfinite(solution.x)):
        return None, None
    return solution.x[:p] * s, solution


def _promised(model: LocalModel, rows: _Rows, step: FloatArray, prices: FloatArray) -> float:
    """What the local model expects a step to gain."""
    gain = -float(model.gradient @ step + 0.5 * step @ model.hessian @ step)
    if model.peaks.size:
        gain += float(model.peaks.max() - (model.peaks + model.peak_rows @ step).max())
    after = rows.value + rows.jacobian @ step
    if not rows.value.size:
        return gain
    return gain + float(prices[rows.constraint] @ (_cost(rows, rows.value) - _cost(rows, after)))


def _cost(rows: _Rows, value: FloatArray) -> FloatArray:
    return np.where(rows.one_sided > 0, np.maximum(-value, 0.0), np.abs(value))


def _prices(
    problem: Problem, rows: _Rows, solution: QuadraticSolution, before: Sequence[float]
) -> list[float]:
    """Prices for the merit: half as much again as the multipliers, falling step by step (Powell's rule)."""
    y = np.abs(solution.row_multipliers[: rows.value.size])
    prices = []
    for k, price in enumerate(before):
        largest = 1.5 * float(y[rows.constraint == k].max(initial=0.0))
        prices.append(min(problem.constraints[k].price, max(largest, 0.1 * price)))
    return prices


def _mended(
    problem: Problem, rows: _Rows, solution: QuadraticSolution, sensitivities: Sensitivities, step: FloatArray
) -> MarchedRod | None:
    """Where the step leads when the whole rod follows it, not only its start; None when that does not close.

    Angles and moments take their linear change, then Newton steps bring the rod into balance and, by least
    changes of the unknowns that are free, what is touched to where the quadratic program thought it. A rod
    that is sensitive to its start stands far larger steps so than marched from there (and no Maratos effect).
    """
    y = solution.row_multipliers[: rows.value.size]
    touched = (rows.one_sided == 0) | (y > 1e-6 * rows.price)
    s, grid, before = problem.scale, problem.grid, sensitivities.rod
    p = s.size
    z = np.clip(before.z + step, problem.lower, problem.upper)
    free = np.minimum(z - problem.lower, problem.upper - z) > 1e-6 * s
    aim, wanted = (rows.value + rows.jacobian @ step)[touched], rows.keys[touched]
    asked = np.unique(rows.constraint[touched]).tolist()
    angles = before.angles + sensitivities.angles @ step
    moments = before.moments + sensitivities.moments @ step
    for _ in range(_MENDING):
        now = grid.guessed(z, angles, moments)
        d = grid.sensitivities(now, closing=True)
        late = float(np.abs(d.angles[:, -1]).max())
        if not late < _LOST:
            return None
        change = np.zeros(p + 1)
        change[-1] = 1.0
        if wanted.size:
            here = _rows(problem, d, which=asked)
            _, a, b = np.intersect1d(wanted, here.keys, return_indices=True)
            jacobian = (here.jacobian[b] * s)[:, free]
            change[:-1][free] = np.linalg.lstsq(jacobian, aim[a] - here.value[b], rcond=1e-10)[0] * s[free]
        z = np.clip(z + change[:-1], problem.lower, problem.upper)
        angles, moments = angles + d.angles @ change, moments + d.moments @ change
        if late < 1e-9:
            break
    return grid.rod(z)


def _closed(problem: Problem, rod: MarchedRod, values: list[FloatArray]) -> MarchedRod:
    """Newton's method on the equalities and on the limits that are touched, by least steps of what is free."""
    s = problem.scale
    for _ in range(6):
        rows = _rows(problem, problem.grid.sensitivities(rod), values)
        touched = (rows.one_sided == 0) | (rows.value < _TOUCHED)
        if not touched.any():
            return rod
        aim = np.where(rows.one_sided > 0, np.maximum(CLOSED - rows.value, 0.0), -rows.value)
        worst = float(np.abs(aim[touched]).max())
        if worst > 1e-3 or worst < 1e-14:
            return rod
        slack = 1e-6 * s
        free = (rod.z - problem.lower > slack) & (problem.upper - rod.z > slack)
        jacobian = (rows.jacobian * s)[np.ix_(touched, free)]
        step = np.linalg.lstsq(jacobian, aim[touched], rcond=1e-10)[0]
        z = rod.z.copy()
        z[free] += step * s[free]
        trial = problem.grid.rod(np.clip(z, problem.lower, problem.upper))
        if not np.isfinite(trial.moments[-1]):
            return rod
        trial_values = problem.values(trial)
        if problem.violation(trial_values) >= problem.violation(values) and worst < 1e-10:
            return rod
        if problem.violation(trial_values) > 2 * problem.violation(values) + 1e-12:
            return rod
        rod, values = trial, trial_values
    return rod


def _multipliers(
    problem: Problem, values: Sequence[FloatArray], found: tuple[_Rows, QuadraticSolution] | None
) -> tuple[tuple[FloatArray, ...], FloatArray, FloatArray]:
    """d(distance) / d(value) of every constraint and of the box, from the last quadratic program."""
    p = problem.scale.size
    out = [np.zeros_like(v) for v in values]
    if found is None:
        return tuple(out), np.zeros(p), np.zeros(p)
    rows, solution = found
    for k, i, y in zip(rows.constraint, rows.index, solution.row_multipliers, strict=False):
        out[k][i] = y
    return (
        tuple(out),
        solution.lower_multipliers[:p] / problem.scale,
        solution.upper_multipliers[:p] / problem.scale,
    )
