"""From any state of a discrete rod to an equilibrium: Newton, steps of load, descent of the energy."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.mechanics.rod.banded_matrices import lowest_constrained, solve_bordered
from elastica_cad.mechanics.rod.rod_system import Residual, RodState, RodSystem, Step

TOLERANCE = 1e-10  # of the moments' size, and of the length: what `bend` promises
LARGEST_TURN_RAD = 0.5  # of an edge in one step: cos and sin are then off their tangents by an eighth
SMALL_TURN_RAD = 0.02  # steps that turn no edge further may pass a crossing of branches
SADDLE_PUSH_RAD = (
    0.05  # along an unstable mode in each step of descent: well beyond rounding, well below a turn
)
ASTRAY_RAD = float(np.pi)  # of an edge: no way down is as long as that in one step
NEAR_REST_RAD = 1e-2  # a descent that turns no edge further has come to where Newton's method converges
CONVERGED_RAD = 1e-9  # a Newton step whose square, the next one, is below rounding
MOST_DESCENTS = 300  # steps down the energy
LEAST_STEP = 1e-7  # of the way: a fold is then met to a share no drawing shows


@dataclass(frozen=True, eq=False)
class Reached:
    """Where a continuation came to: `fraction` 1 is the whole way."""

    state: RodState
    fraction: float
    steps: int

    @property
    def arrived(self) -> bool:
        """Was the whole way possible?"""
        return self.fraction >= 1.0


def is_balanced(state: RodState) -> bool:
    """True when forces, moments and ends are right to the tolerance."""
    return state.imbalance <= TOLERANCE and state.gap <= TOLERANCE


def _newton_step(state: RodState, residual: Residual) -> Step:
    """The step that cancels `residual` to first order."""
    rod = state.discrete
    return Step(
        *solve_bordered(*rod.hessian, rod.constraint_rows, right=-residual.imbalance, below=-residual.miss)
    )


def correct(
    state: RodState,
    kept: Residual | None = None,
    *,
    turn: float = LARGEST_TURN_RAD,
    damping: float = 0.5,
    most: int = 12,
) -> tuple[RodState, int] | None:
    """Newton's method with line search; None when it does not converge nearby.

    A step is taken when the Newton step that would follow it is smaller (natural monotonicity: independent of
    units and of the number of edges), else halved.

    Parameters
    ----------
    kept : Residual, optional
        Imbalance and miss of the ends that are to remain (artificial loads of a continuation).
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
    step = _newton_step(current, _remaining(current, kept))
    turned = _turned(step)
    for iteration in range(most):
        if not turned <= turn:
            return None
        factor = 1.0
        while True:
            trial = current.moved(step, factor)
            next_step = _newton_step(trial, _remaining(trial, kept))
            next_turned = _turned(next_step)
            settled = next_turned < max(CONVERGED_RAD, min(SMALL_TURN_RAD / 4, 2 * turned))
            if settled or next_turned <= (1 - factor / 2) * turned:
                break
            factor /= 2
            if factor < damping:
                return None
        current, step, turned = trial, next_step, next_turned
        if float(np.abs(current.angles - state.angles).max()) > turn:
            return None
        if turned < CONVERGED_RAD:
            current = current.moved(step)
            size = _size(current, _remaining(current, kept))
            return (current, iteration + 1) if size < TOLERANCE else None
    return None


def follow(state: RodState) -> Reached:
    """Carry a state over to an equilibrium of its system, keeping its imbalance as a load that fades away.

    Ends and angles then move in a straight line from where they are to where they shall be; weight, forces,
    stiffness and supports change in proportion. Steps adapt; a fold of the branch ends it.
    """
    if is_balanced(state):
        return Reached(_polish(state), 1.0, 0)
    start = state.residual

    def kept(t: float) -> tuple[RodSystem, Residual]:
        return state.system, Residual((1 - t) * start.imbalance, (1 - t) * start.miss)

    reached = trace(kept, state)
    if reached.arrived:
        return Reached(_polish(reached.state), 1.0, reached.steps)
    return reached


def trace(
    problem: Callable[[float], tuple[RodSystem, Residual | None]],
    state: RodState,
    *,
    start: float = 0.0,
) -> Reached:
    """Follow the equilibria of `problem(t)` from `state` at t = `start` towards t = 1, with adaptive steps.

    The number of unstable modes changes only where branches cross, and those are passed in small steps: so
    a long step that changes it has landed on another branch and is taken back.
    """
    t, step, count = start, 1.0 - start, 0
    modes: int | None = None
    while t < 1.0:
        t_next = min(t + step, 1.0)
        system, kept = problem(t_next)
        found = correct(state.under(system), kept)
        count += 1
        long = found is not None and float(np.abs(found[0].angles - state.angles).max()) > SMALL_TURN_RAD
        if long and modes is None:
            modes = state.under(problem(t)[0]).discrete.unstable_modes
        if found is None or (long and found[0].discrete.unstable_modes != modes):
            step = (t_next - t) / (4 if t == start and count == 1 else 2)
            if step < LEAST_STEP:
                return Reached(state, t, count)
            continue
        state, iterations = found
        modes = modes if long else None
        t = t_next
        step *= 2 if iterations <= 4 else 1
    return Reached(state, 1.0, count)


def _polish(state: RodState) -> RodState:
    """Newton steps as long as they help: the rounding limit."""
    size = _size(state, state.residual)
    for _ in range(6):
        if size == 0:
            break
        trial = state.moved(_newton_step(state, state.residual))
        trial_size = _size(trial, trial.residual)
        if not trial_size < 0.5 * size:
            break
        state, size = trial, trial_size
    return state


def relax(state: RodState) -> RodState | None:
    """Descend the energy to a stable equilibrium, the ends kept in place; None when that fails."""
    start = _place_ends(state)
    if start is None:
        return None
    found = _come_to_rest(start, np.inf)
    # beside a kink, which a material that hardens makes a thousand times as stiff, Newton's steps go astray
    return _come_to_rest(start, ASTRAY_RAD) if found is None else found


def _come_to_rest(state: RodState, astray: float) -> RodState | None:
    """The descent, with steps that turn no edge by more than `astray`, before they are shortened."""
    system = state.system
    softest = 1e-3 * system.edge_length / system.length**2
    for _ in range(MOST_DESCENTS):
        rod, residual = state.discrete, state.residual
        (diagonal, off), rows, inertia = rod.hessian, rod.constraint_rows, rod.unstable_modes
        convex, push = diagonal, np.zeros_like(state.angles)
        if inertia:
            values, vectors = lowest_constrained(diagonal, off, rows)
            convex = diagonal + 2 * abs(values[0]) + softest
            push = vectors[0] / np.abs(vectors[0]).max()
        step, lift = _downhill(convex, off, rows, residual), softest
        while _turned(step) > astray:
            step, lift = _downhill(convex + lift, off, rows, residual), 10 * lift
        turned = _turned(step)
        if not np.isfinite(turned):
            return None
        if not inertia and turned < NEAR_REST_RAD:
            found = correct(state)
            if found is not None and is_balanced(found[0]) and not found[0].discrete.unstable_modes:
                return _polish(found[0])
        if inertia:  # along the unstable mode too, downhill: a descent does not end at a saddle
            side = -1.0 if push @ residual.imbalance > 0 else 1.0
            step = Step(step.angles + side * SADDLE_PUSH_RAD * push, step.reactions)
            turned = _turned(step)
        descended = _descend(state, step, min(1.0, LARGEST_TURN_RAD / turned) if turned else 1.0)
        if descended is None:
            return None
        state = descended
    return None


def _downhill(diagonal: FloatArray, off: FloatArray, rows: FloatArray, residual: Residual) -> Step:
    return Step(*solve_bordered(diagonal, off, rows, right=-residual.imbalance, below=-residual.miss))


def _descend(state: RodState, step: Step, factor: float) -> RodState | None:
    """Backtracking on the energy; the reactions are taken from the step."""
    least = 1e-12 * (abs(state.energy) + 1 / state.system.length)
    for _ in range(30):
        trial = _place_ends(state.moved(step, factor))
        if trial is not None and trial.energy < state.energy + least:
            return trial
        factor /= 2
    return None


def _place_ends(state: RodState) -> RodState | None:
    """The nearest angles (least squares) that bring the ends to their places."""
    for _ in range(60):
        miss = state.residual.miss
        if np.abs(miss).max(initial=0.0) <= 1e-12 * state.system.length:
            return state
        rows = state.discrete.constraint_rows
        share = np.linalg.lstsq(rows @ rows.T, miss, rcond=1e-12)[0]
        step = rows.T @ share
        turned = float(np.abs(step).max())
        if not (np.isfinite(turned) and turned > 0):
            return None
        state = state.system.state(state.angles - min(1.0, LARGEST_TURN_RAD / turned) * step, state.reactions)
    return None


def _turned(step: Step) -> float:
    return float(np.abs(step.angles).max())


def _remaining(state: RodState, kept: Residual | None) -> Residual:
    """The residual without what is kept."""
    imbalance, miss = state.residual
    return state.residual if kept is None else Residual(imbalance - kept.imbalance, miss - kept.miss)


def _size(state: RodState, residual: Residual) -> float:
    """Imbalance beyond rounding over the moments' size (a bend of 1e-3 rad at least), miss over the length."""
    length = state.system.length
    unit = max(state.scale, 1e-3 / length)
    imbalance = max(float(np.abs(residual.imbalance).max()) - state.noise, 0.0)
    return max(imbalance / unit, float(np.abs(residual.miss).max(initial=0.0)) / length)
