"""Rest shapes by Newton's method while supports or loads change, and branches of buckled shapes.

The path of a continuation leads from 0 (start) to 1 (required supports and loads).
"""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import Length, NotConvergedError
from elastica_cad.geometry.plane_points import angle_of, norm, unit_vectors
from elastica_cad.mechanics.discrete_rod import solve_bordered
from elastica_cad.mechanics.rod_system import Residual, RodState, Step

# largest relative error of moments and positions in a rest shape
TOLERANCE = 1e-10
# largest rotation of an edge in a step, at which linearised cos and sin are wrong by one eighth
LARGEST_TURN_RAD = 0.5
# largest rotation of an edge in a step of a descent that rails or ties may stop
WATCHED_TURN_RAD = 0.1
# largest rotation of an edge in a step near a crossing of two branches of equilibria
SMALL_TURN_RAD = 0.02
# rotation of all edges in the last Newton step; the next rotation would be about its square
CONVERGED_RAD = 1e-9
# least step, as a fraction of the path; the end of a branch is located with this accuracy
LEAST_STEP = 1e-7


@dataclass(frozen=True, eq=False)
class Reached:
    """Last state of a continuation, with the completed fraction of the path."""

    state: RodState
    fraction: float

    @property
    def arrived(self) -> bool:
        """True if the continuation reached the end of its path."""
        return self.fraction >= 1.0


def is_balanced(state: RodState) -> bool:
    """Return True if forces, moments and end positions are correct within `TOLERANCE`."""
    return state.imbalance <= TOLERANCE and state.gap <= TOLERANCE


def newton_step(state: RodState, residual: Residual) -> Step:
    """Return the Newton step that cancels `residual` to first order."""
    return _step_with_hessian(state, *state.discrete.hessian, residual)


def _step_with_hessian(state: RodState, diagonal: FloatArray, off: FloatArray, residual: Residual) -> Step:
    rows, below = state.rows, -residual.miss
    # without rails, pins and ties, all reactions are forces and need no scaling
    if not state.system.actions:
        return Step(
            *solve_bordered(diagonal, off, rows, right=-residual.imbalance, below=below, corner=state.corner)
        )
    # scale all unknowns to the unit of a force
    unit = np.where(state.places, 1.0, state.system.length**3)
    angles, reactions = solve_bordered(
        diagonal, off, unit[:, None] * rows, right=-residual.imbalance, below=unit * below,
        corner=unit[:, None] * state.corner * unit,
    )  # fmt: skip
    return Step(angles, unit * reactions)


def correct(
    state: RodState,
    kept: Residual | None = None,
    *,
    turn: float = LARGEST_TURN_RAD,
    damping: float = 0.5,
    most: int = 12,
) -> tuple[RodState, int] | None:
    """Return the solution near a state by Newton's method with line search, or None without convergence.

    A step is halved until the next Newton step is smaller. This test (natural monotonicity) is independent of units
    and of the number of edges.

    Parameters
    ----------
    kept : Residual, optional
        Imbalance of moments, and position errors, that remain in the solution; by default 0. A continuation
        reduces them in steps.
    turn : float
        Largest rotation of an edge, rad, in a step and in total.
    damping : float
        Smallest accepted fraction of a step. A smaller fraction means that the start is far from the
        solution, and that the result may be on another branch of equilibria.
    most : int
        Largest number of steps. The number of steps is returned with the solution.
    """
    current = state
    step = newton_step(current, _residual_beyond(current, kept))
    turned = _turned(step)
    for iteration in range(most):
        if not turned <= turn:
            return None
        factor = 1.0
        while True:
            trial = current.moved(step, factor)
            next_step = newton_step(trial, _residual_beyond(trial, kept))
            next_turned = _turned(next_step)
            # a small next step is accepted even if it is up to twice the present step
            settled = next_turned < max(CONVERGED_RAD, min(SMALL_TURN_RAD / 4, 2 * turned))
            if settled or next_turned <= (1 - factor / 2) * turned:
                break
            factor /= 2
            if factor < damping:
                return None
        current, step, turned = trial, next_step, next_turned
        if np.abs(current.angles - state.angles).max() > turn:
            return None
        if turned < CONVERGED_RAD:
            current = current.moved(step)
            size = _relative_error(current, _residual_beyond(current, kept))
            return (current, iteration + 1) if size < TOLERANCE else None
    return None


def follow(state: RodState) -> Reached:
    """Continue from a state to an equilibrium by reducing the imbalance of the state to zero in adaptive steps.

    Errors of positions and angles of the ends, and the effects of new weight, forces, stiffness and supports
    decrease in the same proportion. The continuation ends early if the branch turns back.

    Along a branch, the number of unstable modes changes only at crossings with other branches. Small steps lead
    over these crossings. A long step that changes this number may have reached another branch, so it is shortened.
    """
    if is_balanced(state):
        return Reached(_polish(state), 1.0)
    start, t, step = state.residual, 0.0, 1.0
    modes: int | None = None
    while t < 1.0:
        t_next = min(t + step, 1.0)
        corrected = correct(state, Residual((1 - t_next) * start.imbalance, (1 - t_next) * start.miss))
        long = (
            corrected is not None and float(np.abs(corrected[0].angles - state.angles).max()) > SMALL_TURN_RAD
        )
        if long and modes is None:
            modes = state.discrete.unstable_modes
        if corrected is None or (long and corrected[0].discrete.unstable_modes != modes):
            # after a failed first attempt over the whole path, continue with a quarter
            step = (t_next - t) / (4 if (t, step) == (0.0, 1.0) else 2)
            if step < LEAST_STEP:
                return Reached(state, t)
            continue
        state, iterations = corrected
        modes = modes if long else None
        t = t_next
        step *= 2 if iterations <= 4 else 1
    return Reached(_polish(state), 1.0)


def _polish(state: RodState) -> RodState:
    # Newton steps as long as each at least halves the error
    size = _relative_error(state, state.residual)
    for _ in range(6):
        if size == 0:
            break
        trial = state.moved(newton_step(state, state.residual))
        trial_size = _relative_error(trial, trial.residual)
        if not trial_size < 0.5 * size:
            break
        state, size = trial, trial_size
    return state


def relax(state: RodState, stop: Callable[[RodState], bool] | None = None) -> RodState | None:
    """Return a stable equilibrium that minimises the energy with fixed ends, or None if the minimisation fails.

    The first state of the descent for which `stop` returns True is returned as it is.
    """
    start = _place_ends(state)
    if start is None:
        return None
    rest = _minimise_energy(start, np.inf, stop)
    # Newton's method may diverge at the kink beyond which a hardening material is much stiffer
    return _minimise_energy(start, np.pi, stop) if rest is None else rest


def _minimise_energy(
    state: RodState, astray: float, stop: Callable[[RodState], bool] | None
) -> RodState | None:
    """Minimise the energy by Newton steps with a positive definite Hessian; return None on failure.

    A step has two limits. If it turns an edge by more than `astray`, rad, it is computed again with more stiffness
    (`lift`), which also changes its direction. Then it is shortened to `LARGEST_TURN_RAD`, or to `WATCHED_TURN_RAD`
    if `stop` must see the states on the way.
    """
    system = state.system
    # added stiffness, 1/mm: a small fraction of the lowest eigenvalue of a straight rod of stiffness 1
    softest = 1e-3 * system.edge_length / system.length**2
    # a descent that succeeds takes fewer steps; without end is that of a strip that is pulled tight
    for _ in range(120):
        rod, residual = state.discrete, state.residual
        (diagonal, off), inertia = rod.hessian, rod.unstable_modes
        convex, push = diagonal, np.zeros_like(state.angles)
        if inertia:
            values, vectors = rod.lowest_modes()
            convex = diagonal + 2 * abs(values[0]) + softest
            push = vectors[0] / np.abs(vectors[0]).max()
        step, lift = _step_with_hessian(state, convex, off, residual), softest
        while _turned(step) > astray:
            step, lift = _step_with_hessian(state, convex + lift, off, residual), 10 * lift
        turned = _turned(step)
        if not np.isfinite(turned):
            return None
        # near the equilibrium, Newton's method replaces the minimisation
        if not inertia and turned < 1e-2:
            corrected = correct(state)
            if (
                corrected is not None
                and is_balanced(corrected[0])
                and not corrected[0].discrete.unstable_modes
            ):
                return _polish(corrected[0])
        # also step along the unstable mode, far beyond rounding errors, so that the minimisation does not end at a
        # saddle point
        if inertia:
            # the imbalance is the gradient of the energy, so step against it
            side = -1.0 if push @ residual.imbalance > 0 else 1.0
            step = Step(step.angles + side * 0.05 * push, step.reactions)
            turned = _turned(step)
        most = LARGEST_TURN_RAD if stop is None else WATCHED_TURN_RAD
        descended = _descend(state, step, min(1.0, most / turned) if turned else 1.0)
        if descended is None or (stop is not None and stop(descended)):
            return descended
        # a strip that is pulled tight comes to rest without an equilibrium
        if not inertia and descended.energy >= state.energy:
            return None
        state = descended
    return None


def _descend(state: RodState, step: Step, factor: float) -> RodState | None:
    # halve the step until the energy decreases, or increases by at most a rounding error
    least = 1e-12 * (abs(state.energy) + 1 / state.system.length)
    for _ in range(30):
        trial = _place_ends(state.moved(step, factor))
        if trial is not None and trial.energy < state.energy + least:
            return trial
        factor /= 2
    return None


def _place_ends(state: RodState) -> RodState | None:
    """Turn the edges of the discrete rod as little as possible to fit its supports and ties, or return None.

    Unknowns that move an element or the rod (arc lengths, cord angles, translations) change too; forces change only
    if the edges are axially elastic.
    """
    moves = np.logical_not(state.places)
    unit = np.where(moves, state.system.length**2, 1.0)
    softness = 0.0 if state.system.compression is None else 1 / state.system.length
    for _ in range(60):
        miss = np.where(moves, 0.0, state.residual.miss)
        if state.missed(miss) <= 1e-12:
            return state
        rows = np.where(moves[:, None], 0.0, state.rows)
        matrix = rows @ rows.T - np.where(moves[:, None] == moves, 0.0, unit[:, None] * state.corner * unit)
        if softness:
            matrix -= softness * np.where(moves[:, None] | moves, 0.0, state.corner)
        share = np.linalg.lstsq(matrix, miss, rcond=1e-12)[0]
        step = Step(-rows.T @ share, np.where(moves, unit, softness) * share)
        turned = _turned(step)
        if not np.isfinite(turned) or (not step.reactions.any() and turned == 0):
            return None
        state = state.moved(step, min(1.0, LARGEST_TURN_RAD / turned) if turned else 1.0)
    return None


def _turned(step: Step) -> float:
    return float(np.abs(step.angles).max())


def _residual_beyond(state: RodState, kept: Residual | None) -> Residual:
    imbalance, miss = state.residual
    return state.residual if kept is None else Residual(imbalance - kept.imbalance, miss - kept.miss)


def _relative_error(state: RodState, residual: Residual) -> float:
    """Return the larger of the relative errors of moments and positions.

    Errors of moments are divided by the size of the moments, but at least by the moment of a bend of 1e-3 rad.
    """
    unit = max(state.scale, 1e-3 / state.system.length)
    imbalance = max(float(np.abs(residual.imbalance).max()) - state.noise, 0.0)
    return max(imbalance / unit, state.missed(residual.miss))


# largest difference of edge angles of a straight rod; it moves an end by a micrometre in 10 m
STRAIGHT_RAD = 1e-7


def is_straight(state: RodState) -> bool:
    """Return True if all edges have the same direction within `STRAIGHT_RAD`."""
    return float(np.ptp(state.angles)) < STRAIGHT_RAD


def stretch(state: RodState) -> RodState:
    """Return the straight, unloaded state in the direction from start to end.

    If both ends hold only x or only y, the direction is along this axis.
    """
    system, chord = state.system, np.zeros(2)
    chord[list(system.held)] = system.chord
    return system.state(np.full(system.edges, _nearest_angle(_direction(state), chord)))


def leave_straight(state: RodState, side: int, mode: int) -> Reached:
    """Continue from a straight state to an equilibrium, bent to `side` if the ends must approach each other."""
    system = state.system
    straight = system.state(np.full(system.edges, _direction(state)), state.reactions)
    if must_shorten(straight):
        return follow(_buckle_by_shortening(straight, side, mode).under(system))
    return follow(straight)


def _direction(state: RodState) -> float:
    """Return the angle of the straight rod: the mean held angle, or else the angle of the chord."""
    system = state.system
    held = [angle for angle in system.held_angles if angle is not None]
    if held:
        return float(np.mean(held))
    chord, present = system.end - system.start, float(state.angles.mean())
    if len(system.held) < 2 or norm(chord) < 1e-9 * system.length:
        return present
    angle = _nearest_angle(present, chord)
    return angle if abs(angle - present) < np.pi / 2 else present


def _nearest_angle(near: float, chord: FloatArray) -> float:
    """Return the angle of `chord`, rad, plus the whole turns that bring it nearest to `near`."""
    angle = float(angle_of(chord))
    return angle + 2 * np.pi * float(np.round((near - angle) / (2 * np.pi)))


def must_shorten(state: RodState) -> bool:
    """Return True if a straight state must bend before its ends can reach their positions."""
    system = state.system
    miss = state.residual.miss[: len(system.held)]
    if np.abs(miss).max(initial=0.0) <= 1e-9 * system.length:
        return False
    rows = state.discrete.constraint_rows
    normal = rows @ rows.T
    size = system.edge_length**2 * system.edges
    # small rotations of the edges move an end only across the rod; errors that they can remove require no bend
    across = np.zeros_like(miss)
    if np.abs(normal).max() > 1e-12 * size:
        across += np.linalg.lstsq(normal, miss, rcond=1e-9)[0]
    return bool(np.abs(normal @ across - miss).max() > 1e-9 * system.length)


def _buckle_by_shortening(state: RodState, side: int, mode: int) -> RodState:
    """Return the unloaded rod, buckled because its ends are moved slightly towards each other."""
    system, angle = state.system, float(state.angles[0])
    length, edge = system.length, system.edge_length
    tangent = unit_vectors(angle)
    # the ends of the first buckled rod are far apart
    chord = length * min(max(float(np.linalg.norm(system.chord)) / length, 0.9), 1 - 1e-12)
    first = replace(
        system, load=np.zeros_like(system.load), natural_curvature=0.0, force=np.zeros(2),
        moments=np.zeros(2), start=np.zeros(2), end=chord * tangent, end_angles=np.full(2, angle),
    )  # fmt: skip
    # the straight rod buckles under the pressure lambda = eigenvalue / edge length
    values, shapes = first.state(state.angles).discrete.lowest_modes(mode)
    pressure, shape = float(values[-1]) / edge, shapes[-1] * side * np.sign(first_bulge(shapes[-1]))
    # an edge at the angle a to the chord is shorter by edge * a^2 / 2 along it
    amplitude = np.sqrt(2 * (length - chord) / (edge * float(shape @ shape)))
    guess = first.state(state.angles + amplitude * shape, pressure * tangent[list(system.held)])
    corrected = correct(guess, turn=2.0, damping=1 / 64, most=40)
    if corrected is None:
        raise NotConvergedError(
            "the straight rod of {length:.6g} could not be buckled in mode {mode}: use more "
            "samples, or a lower mode",
            length=Length(length),
            mode=mode,
        )
    return corrected[0]


def first_bulge(turns: FloatArray) -> float:
    """Return the signed size of the first bulge that turns (n,) of the edges cause, positive to the left."""
    bulge = np.cumsum(turns)
    return float(bulge[(np.abs(bulge) > 0.3 * np.abs(bulge).max()).argmax()])
