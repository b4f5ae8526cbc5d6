"""Leaving a straight state on a chosen side: buckling by shortening and buckling under a dead load."""

from dataclasses import replace

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import InputError, NotConvergedError
from elastica_cad.mechanics.balance import Balance, State
from elastica_cad.mechanics.banded import lowest_constrained, solve_bordered
from elastica_cad.mechanics.continuation import (
    Reached,
    correct,
    follow,
    is_balanced,
    relax,
    trace,
    unstable_modes,
)

__all__ = ["from_straight", "is_straight", "stretched"]

STRAIGHT = 1e-7  # rad
LARGE_TURN = 0.5  # rad between the end angles, above which they decide the side
FIRST_CHORD = 0.9  # of the length: the first shortening away from the straight state


def is_straight(state: State) -> bool:
    """Do all edges point the same way?"""
    return float(np.ptp(state.angles)) < STRAIGHT


def stretched(balance: Balance, state: State) -> State:
    """The straight, unloaded state along the line between the ends, or along the one coordinate they hold."""
    chord = np.zeros(2)
    chord[list(balance.held)] = balance.chord
    angle = float(np.arctan2(chord[1], chord[0]))
    angle += 2 * np.pi * np.round((_direction(balance, state) - angle) / (2 * np.pi))
    return State(np.full(balance.edges, angle), np.zeros(len(balance.held)))


def from_straight(balance: Balance, state: State, side: int | None, mode: int) -> Reached:
    """The way from a straight state to an equilibrium, to the chosen side where it bends."""
    straight = State(np.full(balance.edges, _direction(balance, state)), state.reactions)
    if _must_shorten(balance, straight):
        turn = _turn(balance)
        if side is None and mode == 1 and abs(turn) > LARGE_TURN:
            middles = (np.arange(balance.edges) + 0.5) / balance.edges - 0.5
            arc = follow(balance, State(straight.angles + turn * middles, state.reactions))
            if arc.arrived and not unstable_modes(balance, arc.state):
                return arc
            rest = relax(balance, arc.state)
            if rest is not None:
                return Reached(rest, 1.0, arc.steps)
        return follow(balance, _buckled_by_shortening(balance, straight, side or 1, mode))
    found = follow(balance, straight)
    if side is not None and found.arrived and is_straight(found.state):
        return Reached(_buckled_by_load(balance, found.state, side, mode), 1.0, found.steps)
    return found


def _direction(balance: Balance, state: State) -> float:
    """Angle of the straight rod that the ends ask for: mean of the held angles, or the line between them."""
    held = [angle for angle in balance.ends if angle is not None]
    if held:
        return float(np.mean(held))
    chord = balance.end - balance.start
    own = float(state.angles.mean())
    if len(balance.held) < 2 or float(np.hypot(*chord)) < 1e-9 * balance.length:
        return own
    angle = float(np.arctan2(chord[1], chord[0]))
    angle += 2 * np.pi * float(np.round((own - angle) / (2 * np.pi)))
    return angle if abs(angle - own) < np.pi / 2 else own  # an end that goes past the start is pushed there


def _turn(balance: Balance) -> float:
    a, b = balance.ends
    return 0.0 if a is None or b is None else b - a


def _must_shorten(balance: Balance, state: State) -> bool:
    """True when a straight state has to bend before its ends can come to their places."""
    gap = balance.residual(state)[1]
    if np.abs(gap).max(initial=0.0) <= 1e-9 * balance.length:
        return False
    rows = balance.constraint_rows(state)
    normal = rows @ rows.T
    size = balance.edge_length**2 * balance.edges
    across = np.zeros_like(gap)
    if np.abs(normal).max() > 1e-12 * size:
        across += np.linalg.lstsq(normal, gap, rcond=1e-9)[0]
    return bool(np.abs(normal @ across - gap).max() > 1e-9 * balance.length)


def _buckled_by_shortening(balance: Balance, state: State, side: int, mode: int) -> State:
    """The unloaded straight rod, its ends pushed a little towards each other, in buckling mode `mode`."""
    angle = float(state.angles[0])
    tangent = np.array([np.cos(angle), np.sin(angle)])
    # what is to be reached along the held coordinates decides how far the first push goes
    wanted = float(np.linalg.norm(balance.chord))
    chord = balance.length * min(max(wanted / balance.length, FIRST_CHORD), 1 - 1e-12)
    first = replace(
        balance, load=np.zeros_like(balance.load), natural_curvature=0.0, force=np.zeros(2),
        moments=np.zeros(2), start=np.zeros(2), end=chord * tangent, end_angles=np.full(2, angle),
    )  # fmt: skip
    straight = State(state.angles, np.zeros(len(balance.held)))
    pressure, shape = _mode(first, straight, mode)
    shape = _sided(shape, side)
    amplitude = np.sqrt(2 * (balance.length - chord) / (balance.edge_length * float(shape @ shape)))
    for _ in range(8):
        short = balance.length - balance.edge_length * float(np.cos(amplitude * shape).sum())
        slope = balance.edge_length * float(shape @ np.sin(amplitude * shape))
        amplitude -= (short - (balance.length - chord)) / slope
    guess = State(state.angles + amplitude * shape, pressure * tangent[list(balance.held)])
    found = correct(first, guess, turn=2.0, damping=1 / 64, most=40)
    if found is None:
        raise NotConvergedError(
            f"the straight rod of {balance.length:.6g} mm could not be buckled in mode {mode}"
        )
    return found[0]


def _buckled_by_load(balance: Balance, state: State, side: int, mode: int) -> State:
    """The equilibrium under the full dead load that branches off the straight state in mode `mode`.

    Raises
    ------
    InputError
        When the load is too small to buckle the rod in this mode.
    """

    def modes(factor: float) -> int:
        return unstable_modes(loaded(factor), scaled(factor))

    def loaded(factor: float) -> Balance:
        return balance.loaded(factor)

    def scaled(factor: float) -> State:
        return State(state.angles, factor * state.reactions)

    if modes(1.0) < mode:
        raise InputError(
            f"the load is too small to buckle the straight rod in mode {mode}: "
            "leave out side, or raise the load or the length"
        )
    low, high = 0.0, 1.0
    while high - low > 1e-7:
        middle = (low + high) / 2
        low, high = (low, middle) if modes(middle) >= mode else (middle, high)
    shape = _sided(_mode(loaded(high), scaled(high), mode)[1], side)
    shape = shape / np.abs(shape).max()
    for amplitude in (0.2, 0.05, 0.01, 0.002):
        found = _at_amplitude(balance, scaled(high), shape, amplitude, high)
        if found is None or found[1] >= 1.0:
            continue
        reached = trace(lambda f: (loaded(f), None), found[0], start=found[1])
        if reached.arrived and is_balanced(balance, reached.state):
            return reached.state
    raise NotConvergedError(
        f"the straight rod of {balance.length:.6g} mm could not be buckled in mode {mode}"
    )


def _at_amplitude(
    balance: Balance, straight: State, shape: FloatArray, amplitude: float, factor: float
) -> tuple[State, float] | None:
    """Equilibrium whose part along `shape` is given, and the load factor that it needs (Newton)."""
    state = State(straight.angles + amplitude * shape, straight.reactions)
    for _ in range(25):
        now = balance.loaded(factor)
        imbalance, miss = now.residual(state)
        rows = now.constraint_rows(state)
        per_factor = balance.loaded(1.0).residual(state)[0] - balance.loaded(0.0).residual(state)[0]
        columns = np.column_stack([rows.T, per_factor])
        off_shape = float(shape @ (state.angles - straight.angles)) - amplitude * float(shape @ shape)
        angles, border = solve_bordered(
            *now.second_variation(state), np.vstack([rows, shape]), columns=columns,
            right=-imbalance, below=-np.append(miss, off_shape),
        )  # fmt: skip
        state = state.moved(State(angles, border[:-1]))
        factor += float(border[-1])
        if np.abs(angles).max() < 1e-10:
            return state, factor
        if not np.isfinite(factor) or np.abs(state.angles - straight.angles).max() > 4 * amplitude:
            return None
    return None


def _mode(balance: Balance, state: State, mode: int) -> tuple[float, FloatArray]:
    """The `mode`-th eigenvalue (1/mm2) of the second variation per length, and its mode."""
    diagonal, off = balance.second_variation(state)
    values, vectors = lowest_constrained(
        diagonal / balance.edge_length, off / balance.edge_length, balance.constraint_rows(state), mode
    )
    return float(values[mode - 1]), vectors[mode - 1]


def _sided(shape: FloatArray, side: int) -> FloatArray:
    """The mode with its first lobe to the left (side +1) or right (-1) of the direction of travel."""
    bulge = np.cumsum(shape)
    first = int(np.argmax(np.abs(bulge) > 0.3 * np.abs(bulge).max()))
    return shape if side * bulge[first] > 0 else -shape
