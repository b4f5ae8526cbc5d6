"""From any state of a discrete rod to an equilibrium: Newton, steps of load, descent of the energy."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.mechanics.balance import Balance, State
from elastica_cad.mechanics.banded import constrained_inertia, lowest_constrained, solve_bordered

__all__ = [
    "TOLERANCE",
    "Reached",
    "correct",
    "follow",
    "is_balanced",
    "newton_step",
    "relax",
    "trace",
    "unstable_modes",
]

TOLERANCE = 1e-10  # of the moments' size, and of the length
LARGEST_TURN = 0.5  # rad that one step of continuation may turn an edge
SMALL_TURN = 0.02  # rad; shorter steps may pass a crossing of branches
SADDLE_PUSH = 0.05  # rad along an unstable mode in each step of descent
CONVERGED = 1e-9  # rad: a Newton step that needs no other after it
LEAST_STEP = 1e-7

Gap = tuple[FloatArray, FloatArray]


@dataclass(frozen=True, eq=False)
class Reached:
    """Where a continuation came to: `fraction` 1 is the whole way."""

    state: State
    fraction: float
    steps: int

    @property
    def arrived(self) -> bool:
        """Was the whole way possible?"""
        return self.fraction >= 1.0


def is_balanced(balance: Balance, state: State) -> bool:
    """True when forces, moments and ends are right to the tolerance."""
    return balance.imbalance(state) <= TOLERANCE and balance.gap(state) <= TOLERANCE


def newton_step(balance: Balance, state: State, gap: Gap) -> State:
    """The step that cancels `gap` (imbalance, miss of the ends) to first order."""
    diagonal, off = balance.second_variation(state)
    rows = balance.constraint_rows(state)
    return State(*solve_bordered(diagonal, off, rows, right=-gap[0], below=-gap[1]))


def correct(
    balance: Balance,
    state: State,
    kept: Gap | None = None,
    *,
    turn: float = LARGEST_TURN,
    damping: float = 0.5,
    most: int = 12,
) -> tuple[State, int] | None:
    """Newton's method with line search; None when it does not converge nearby.

    A step is taken when the Newton step that would follow it is smaller (natural monotonicity: independent of
    units and of the number of edges), else halved.

    Parameters
    ----------
    kept : pair of arrays, optional
        Imbalance and gap that are to remain (artificial loads of a continuation).
    turn : float
        Largest turn of an edge on the way, rad.
    damping : float
        Smallest part of a step that is tried. A state that needs a smaller one is a long way off, and what is
        found then may lie on another branch of equilibria.

    Returns
    -------
    state, iterations
    """
    current = state
    step = newton_step(balance, current, _left(balance, current, kept))
    turned = _turned(step)
    for iteration in range(most):
        if not turned <= turn:
            return None
        factor = 1.0
        while True:
            trial = current.moved(step, factor)
            next_step = newton_step(balance, trial, _left(balance, trial, kept))
            next_turned = _turned(next_step)
            settled = next_turned < max(CONVERGED, min(SMALL_TURN / 4, 2 * turned))
            if settled or next_turned <= (1 - factor / 2) * turned:
                break
            factor /= 2
            if factor < damping:
                return None
        current, step, turned = trial, next_step, next_turned
        if float(np.abs(current.angles - state.angles).max()) > turn:
            return None
        if turned < CONVERGED:
            current = current.moved(step)
            size = _size(balance, current, _left(balance, current, kept))
            return (current, iteration + 1) if size < TOLERANCE else None
    return None


def follow(balance: Balance, state: State, *, turn: float = LARGEST_TURN) -> Reached:
    """Carry `state` over to an equilibrium of `balance`, keeping its imbalance as a load that fades away.

    Ends and angles then move in a straight line from where they are to where they shall be; weight, forces,
    stiffness and supports change in proportion. Steps adapt; a fold of the branch ends it.
    """
    if is_balanced(balance, state):
        return Reached(polished(balance, state), 1.0, 0)
    start = balance.residual(state)

    def kept(t: float) -> tuple[Balance, Gap]:
        return balance, ((1 - t) * start[0], (1 - t) * start[1])

    reached = trace(kept, state, turn=turn)
    if reached.arrived:
        return Reached(polished(balance, reached.state), 1.0, reached.steps)
    return reached


def trace(
    problem: Callable[[float], tuple[Balance, Gap | None]],
    state: State,
    *,
    start: float = 0.0,
    stop: float = 1.0,
    turn: float = LARGEST_TURN,
    least: float = LEAST_STEP,
) -> Reached:
    """Follow the equilibria of `problem(t)` from `state` at t = `start` towards `stop`, with adaptive steps.

    The number of unstable modes changes only where branches cross, and those are passed in small steps: so
    a long step that changes it has landed on another branch and is taken back.
    """
    t, step, count = start, stop - start, 0
    modes: int | None = None
    while t < stop:
        t_next = stop if t + step >= stop else t + step
        balance, kept = problem(t_next)
        found = correct(balance, state, kept, turn=turn)
        count += 1
        long = found is not None and float(np.abs(found[0].angles - state.angles).max()) > SMALL_TURN
        if long and modes is None:
            modes = unstable_modes(problem(t)[0], state)
        if found is None or (long and unstable_modes(balance, found[0]) != modes):
            step = (t_next - t) / (4 if t == start and count == 1 else 2)
            if step < least:
                return Reached(state, t, count)
            continue
        state, iterations = found
        modes = modes if long else None
        t = t_next
        step *= 2 if iterations <= 4 else 1
    return Reached(state, 1.0 if t >= stop else t, count)


def polished(balance: Balance, state: State) -> State:
    """Newton steps as long as they help: the rounding limit."""
    gap = balance.residual(state)
    size = _size(balance, state, gap)
    for _ in range(6):
        if size == 0:
            break
        trial = state.moved(newton_step(balance, state, gap))
        trial_gap = balance.residual(trial)
        trial_size = _size(balance, trial, trial_gap)
        if not trial_size < 0.5 * size:
            break
        state, gap, size = trial, trial_gap, trial_size
    return state


def relax(balance: Balance, state: State, *, most: int = 300) -> State | None:
    """Descend the energy to a stable equilibrium, the ends kept in place; None when that fails."""
    start = _with_ends_in_place(balance, state)
    if start is None:
        return None
    state = start
    for _ in range(most):
        gap = balance.residual(state)
        diagonal, off = balance.second_variation(state)
        rows = balance.constraint_rows(state)
        inertia = constrained_inertia(diagonal, off, rows)
        convex, push = diagonal, np.zeros_like(state.angles)
        if inertia:
            values, vectors = lowest_constrained(diagonal, off, rows)
            convex = diagonal + 2 * abs(values[0]) + 1e-3 * balance.edge_length / balance.length**2
            push = vectors[0] / np.abs(vectors[0]).max()
        step = State(*solve_bordered(convex, off, rows, right=-gap[0], below=-gap[1]))
        turned = float(np.abs(step.angles).max())
        if not np.isfinite(turned):
            return None
        if not inertia and turned < 1e-2:
            found = correct(balance, state)
            if found is not None and is_balanced(balance, found[0]) and not unstable_modes(balance, found[0]):
                return polished(balance, found[0])
        if inertia:  # along the unstable mode too, downhill: no saddle holds
            side = -1.0 if push @ gap[0] > 0 else 1.0
            step = State(step.angles + side * SADDLE_PUSH * push, step.reactions)
            turned = float(np.abs(step.angles).max())
        descended = _descended(balance, state, step, min(1.0, LARGEST_TURN / turned) if turned else 1.0)
        if descended is None:
            return None
        state = descended
    return None


def _descended(balance: Balance, state: State, step: State, factor: float) -> State | None:
    """Backtracking on the energy; the reactions are taken from the step."""
    before = balance.energy(state)
    least = 1e-12 * (abs(before) + 1 / balance.length)
    for _ in range(30):
        trial = _with_ends_in_place(
            balance, State(state.angles + factor * step.angles, state.reactions + factor * step.reactions)
        )
        if trial is not None and balance.energy(trial) < before + least:
            return trial
        factor /= 2
    return None


def _with_ends_in_place(balance: Balance, state: State) -> State | None:
    """The nearest angles (least squares) that bring the ends to their places."""
    for _ in range(60):
        miss = balance.residual(state)[1]
        if np.abs(miss).max(initial=0.0) <= 1e-12 * balance.length:
            return state
        rows = balance.constraint_rows(state)
        share = np.linalg.lstsq(rows @ rows.T, miss, rcond=1e-12)[0]
        step = rows.T @ share
        turned = float(np.abs(step).max())
        if not (np.isfinite(turned) and turned > 0):
            return None
        state = State(state.angles - min(1.0, LARGEST_TURN / turned) * step, state.reactions)
    return None


def unstable_modes(balance: Balance, state: State) -> int:
    """Number of unstable modes of a state: the inertia of its second variation on the constraints."""
    return constrained_inertia(*balance.second_variation(state), balance.constraint_rows(state))


def _turned(step: State) -> float:
    return float(np.abs(step.angles).max())


def _left(balance: Balance, state: State, kept: Gap | None) -> Gap:
    imbalance, miss = balance.residual(state)
    return (imbalance, miss) if kept is None else (imbalance - kept[0], miss - kept[1])


def _size(balance: Balance, state: State, gap: Gap) -> float:
    """Imbalance beyond rounding over the moments' size (a bend of 1e-3 rad at least), gap over the length."""
    unit = max(balance.scale(state), 1e-3 / balance.length)
    imbalance = max(float(np.abs(gap[0]).max()) - balance.noise(state), 0.0)
    return max(imbalance / unit, float(np.abs(gap[1]).max(initial=0.0)) / balance.length)
