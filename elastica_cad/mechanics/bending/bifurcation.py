"""Leaving a straight state on a chosen side: buckling by shortening and buckling under a dead load."""

from dataclasses import replace

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import InputError, NotConvergedError
from elastica_cad.mechanics.bending.newton_continuation import (
    Reached,
    correct,
    follow,
    is_balanced,
    relax,
    trace,
)
from elastica_cad.mechanics.rod.banded_matrices import lowest_constrained, solve_bordered
from elastica_cad.mechanics.rod.rod_system import RodState, RodSystem, Step

STRAIGHT_RAD = 1e-7  # between the edges: what a drawing to a micrometre shows of a strip of ten metres
DECIDING_TURN_RAD = 0.5  # between the held end angles, above which they decide the side
FIRST_CHORD = 0.9  # of the length: the first shortening away from the straight state
LOAD_RESOLUTION = 1e-7  # of the full load, to which the buckling load is bisected
AMPLITUDES_RAD = (0.2, 0.05, 0.01, 0.002)  # of the buckled shape, tried in turn: the largest that converges


def is_straight(state: RodState) -> bool:
    """Do all edges point the same way?"""
    return float(np.ptp(state.angles)) < STRAIGHT_RAD


def stretch(state: RodState) -> RodState:
    """The straight, unloaded state along the line between the ends, or along the one coordinate they hold."""
    system, chord = state.system, np.zeros(2)
    chord[list(system.held)] = system.chord
    angle = _on_turn_of(_direction(state), chord)
    return system.state(np.full(system.edges, angle))


def leave_straight(state: RodState, side: int | None, mode: int) -> Reached:
    """The way from a straight state to an equilibrium, to the chosen side where it bends."""
    system = state.system
    straight = system.state(np.full(system.edges, _direction(state)), state.reactions)
    if _must_shorten(straight):
        a, b = system.held_angles
        turn = 0.0 if a is None or b is None else b - a
        if side is None and mode == 1 and abs(turn) > DECIDING_TURN_RAD:
            middles = (np.arange(system.edges) + 0.5) / system.edges - 0.5
            arc = follow(system.state(straight.angles + turn * middles, state.reactions))
            if arc.arrived and not arc.state.discrete.unstable_modes:
                return arc
            rest = relax(arc.state)
            if rest is not None:
                return Reached(rest, 1.0, arc.steps)
        return follow(_buckle_by_shortening(straight, side or 1, mode).under(system))
    found = follow(straight)
    if side is not None and found.arrived and is_straight(found.state):
        return Reached(_buckle_by_load(found.state, side, mode), 1.0, found.steps)
    return found


def _direction(state: RodState) -> float:
    """Angle of the straight rod that the ends ask for: mean of the held angles, or the line between them."""
    system = state.system
    held = [angle for angle in system.held_angles if angle is not None]
    if held:
        return float(np.mean(held))
    chord, own = system.end - system.start, float(state.angles.mean())
    if len(system.held) < 2 or float(np.hypot(*chord)) < 1e-9 * system.length:
        return own
    angle = _on_turn_of(own, chord)
    return angle if abs(angle - own) < np.pi / 2 else own  # an end that goes past the start is pushed there


def _on_turn_of(own: float, chord: FloatArray) -> float:
    """The angle of `chord` that lies within half a turn of `own`."""
    angle = float(np.arctan2(chord[1], chord[0]))
    return angle + 2 * np.pi * float(np.round((own - angle) / (2 * np.pi)))


def _must_shorten(state: RodState) -> bool:
    """True when a straight state has to bend before its ends can come to their places."""
    system, miss = state.system, state.residual.miss
    if np.abs(miss).max(initial=0.0) <= 1e-9 * system.length:
        return False
    rows = state.discrete.constraint_rows
    normal = rows @ rows.T
    size = system.edge_length**2 * system.edges
    across = np.zeros_like(miss)
    if np.abs(normal).max() > 1e-12 * size:
        across += np.linalg.lstsq(normal, miss, rcond=1e-9)[0]
    return bool(np.abs(normal @ across - miss).max() > 1e-9 * system.length)


def _buckle_by_shortening(state: RodState, side: int, mode: int) -> RodState:
    """The unloaded straight rod, its ends pushed a little towards each other, in buckling mode `mode`."""
    system, angle = state.system, float(state.angles[0])
    length, edge = system.length, system.edge_length
    tangent = np.array([np.cos(angle), np.sin(angle)])
    # the distance asked for along the held coordinates decides how far the first push goes
    wanted = float(np.linalg.norm(system.chord))
    chord = length * min(max(wanted / length, FIRST_CHORD), 1 - 1e-12)
    first = replace(
        system, load=np.zeros_like(system.load), natural_curvature=0.0, force=np.zeros(2),
        moments=np.zeros(2), start=np.zeros(2), end=chord * tangent, end_angles=np.full(2, angle),
    )  # fmt: skip
    pressure, shape = _mode(first.state(state.angles), side, mode)
    amplitude = np.sqrt(2 * (length - chord) / (edge * float(shape @ shape)))
    for _ in range(8):
        short = length - edge * float(np.cos(amplitude * shape).sum())
        slope = edge * float(shape @ np.sin(amplitude * shape))
        amplitude -= (short - (length - chord)) / slope
    guess = first.state(state.angles + amplitude * shape, pressure * tangent[list(system.held)])
    found = correct(guess, turn=2.0, damping=1 / 64, most=40)
    if found is None:
        raise _not_buckled(length, mode)
    return found[0]


def _buckle_by_load(state: RodState, side: int, mode: int) -> RodState:
    """The equilibrium under the full dead load that branches off the straight state in mode `mode`.

    Raises
    ------
    InputError
        When the load is too small to buckle the rod in this mode.
    """
    system = state.system

    def scaled(factor: float) -> RodState:
        return system.loaded(factor).state(state.angles, factor * state.reactions)

    def modes(factor: float) -> int:
        return scaled(factor).discrete.unstable_modes

    if modes(1.0) < mode:
        raise InputError(
            f"the load is too small to buckle the straight rod in mode {mode}: "
            "leave out side, or raise the load or the length"
        )
    low, high = 0.0, 1.0
    while high - low > LOAD_RESOLUTION:
        middle = (low + high) / 2
        low, high = (low, middle) if modes(middle) >= mode else (middle, high)
    shape = _mode(scaled(high), side, mode)[1]
    shape = shape / np.abs(shape).max()
    for amplitude in AMPLITUDES_RAD:
        found = _reach_amplitude(system, scaled(high), shape, amplitude, high)
        if found is None or found[1] >= 1.0:
            continue
        reached = trace(lambda f: (system.loaded(f), None), found[0], start=found[1])
        if reached.arrived and is_balanced(reached.state.under(system)):
            return reached.state.under(system)
    raise _not_buckled(system.length, mode)


def _reach_amplitude(
    system: RodSystem, straight: RodState, shape: FloatArray, amplitude: float, factor: float
) -> tuple[RodState, float] | None:
    """Equilibrium whose part along `shape` is given, and the load factor that it needs (Newton)."""
    state = straight.moved(Step(shape, np.zeros_like(straight.reactions)), amplitude)
    for _ in range(25):
        now = state.under(system.loaded(factor))
        rows = now.discrete.constraint_rows
        per_factor = (
            state.under(system).residual.imbalance - state.under(system.loaded(0.0)).residual.imbalance
        )
        off_shape = float(shape @ (state.angles - straight.angles)) - amplitude * float(shape @ shape)
        angles, border = solve_bordered(
            *now.discrete.hessian, np.vstack([rows, shape]), columns=np.column_stack([rows.T, per_factor]),
            right=-now.residual.imbalance, below=-np.append(now.residual.miss, off_shape),
        )  # fmt: skip
        state = now.moved(Step(angles, border[:-1]))
        factor += float(border[-1])
        if np.abs(angles).max() < 1e-10:
            return state, factor
        if not np.isfinite(factor) or np.abs(state.angles - straight.angles).max() > 4 * amplitude:
            return None
    return None


def _mode(state: RodState, side: int, mode: int) -> tuple[float, FloatArray]:
    """The `mode`-th eigenvalue (1/mm2) of the second variation per length, and its mode.

    Its first lobe lies to the left (side +1) or right (-1) of the direction of travel.
    """
    (diagonal, off), edge = state.discrete.hessian, state.system.edge_length
    values, vectors = lowest_constrained(diagonal / edge, off / edge, state.discrete.constraint_rows, mode)
    shape = vectors[mode - 1]
    bulge = np.cumsum(shape)
    first = int(np.argmax(np.abs(bulge) > 0.3 * np.abs(bulge).max()))
    return float(values[mode - 1]), shape if side * bulge[first] > 0 else -shape


def _not_buckled(length: float, mode: int) -> NotConvergedError:
    return NotConvergedError(
        f"the straight rod of {length:.6g} mm could not be buckled in mode {mode}: "
        "use more samples, or a lower mode"
    )
