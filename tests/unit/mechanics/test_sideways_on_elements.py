"""Stability out of the plane on rails, pins and ties: closed forms, and a rod in space that shares no code."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

import elastica_cad as ec
from elastica_cad.mechanics.elements import ElementForce, Mount
from elastica_cad.mechanics.sideways import sideways_margin

WAVE = ec.PlaneCurve.spline(
    [(0, 0), (60, 60), (120, 10), (180, -40), (240, 5), (300, 60), (360, 0)], degree=5
)
EDGEWISE, TORSION = 20.0, 1.3  # over the stiffness in the plane


@pytest.fixture(scope="module")
def bow():
    bent = ec.bend(ec.Rod.straight(500.0), end=(400, 0), supports=ec.Supports("pinned", "pinned")).curve
    return ec.optimal_rod(bent, supports=ec.Supports("free", "free"), between=ec.Tie(0, bent.length))


def test_a_pin_doubles_the_wave_number_of_a_column():
    """Two spans, each clamped at one end and hinged at the other: tan x = x at x = 4.4934."""
    critical = 4 * 4.493409**2 * EDGEWISE
    column = ec.Rod.straight(1.0, samples=401)
    pin = ElementForce(ec.Pin(0.5), np.array([0.5]), np.zeros((1, 2)), Mount((0.5, 0.0)))

    def margin(push):
        held = replace(column, between=(pin,), force=np.tile([push, 0.0], (401, 1)))
        return sideways_margin(held, np.full(201, EDGEWISE), np.full(201, 1e4))

    assert margin(0.997 * critical) > 0 > margin(1.003 * critical)


def test_a_rail_stops_twist():
    """A straight strip without load: torsion between clamps, on half the length with a rail."""
    strip = ec.Rod.straight(1.0, samples=401)
    rail = ElementForce(ec.Rail(0.5, one_sided=False), np.array([0.5]), np.zeros((1, 2)), Mount((0.5, 0.0)))
    edgewise, torsion = np.full(201, 900.0), np.full(201, TORSION)
    alone = sideways_margin(strip, edgewise, torsion)
    assert alone == pytest.approx(np.pi**2 * TORSION, rel=1e-3)
    # the place of the rail is between two edges, so the modes of both halves are longer by one edge
    held = sideways_margin(replace(strip, between=(rail,)), edgewise, torsion)
    assert held == pytest.approx(4 * np.pi**2 * TORSION, rel=0.02)


@pytest.mark.parametrize(
    "between",
    [ec.Rail(200), ec.Pin(200), (ec.Rail(200), ec.Tie(40, 310)), (ec.Pin(150), ec.Tie(40, 310)), None],
)
def test_a_rod_in_space_has_the_same_margin(between, bow):
    rod = bow if between is None else ec.optimal_rod(WAVE, between=between)
    edges = 14
    s = np.linspace(0, rod.length, edges + 1)
    K = np.interp(s, rod.s, rod.stiffness)
    own = SpaceRod(rod, K).margin()
    assert sideways_margin(rod, EDGEWISE * K, TORSION * K) == pytest.approx(own, rel=0.04)


def test_a_slack_rail_does_not_hold():
    rod = ec.optimal_rod(WAVE, between=(ec.Rail(WAVE.inflections[0]), ec.Pin(200.0)))
    without = replace(rod, between=rod.between[1:])
    widths = np.full(201, EDGEWISE), np.full(201, TORSION)
    assert sideways_margin(rod, *widths) == pytest.approx(sideways_margin(without, *widths), rel=1e-6)


class SpaceRod:
    """Edges with frames in space: energy and constraints, whose second derivatives are finite differences."""

    STEP = 3e-4  # rad

    def __init__(self, rod, stiffness):
        self.rod, self.K, self.n = rod, stiffness, stiffness.size - 1
        self.edge = rod.length / self.n
        middle = (np.arange(self.n) + 0.5) * self.edge
        self.angles = np.interp(middle, rod.s, rod.angle)
        self.held = not rod.supports.is_free
        self.reference = self.frames(np.zeros(3 * self.n))

    def frames(self, turn):
        """Frames (n, 3, 3) after turns (3 n,): x and y out of the plane, then the angle in the plane."""
        turn = turn.reshape(-1, 3)
        return rotation(turn * (1, 1, 0)) @ rotation((turn[:, 2] + self.angles)[:, None] * (0, 0, 1))

    def place(self, frames, s):
        return self.edge * np.clip(s / self.edge - np.arange(self.n), 0, 1) @ frames[:, :, 0]

    def energy(self, frames):
        clamps = rotation(self.rod.angle[[0, -1], None] * (0, 0, 1))
        chain = np.concatenate([clamps[:1], frames, clamps[1:]])
        bend = np.stack([rotation_vector(a.T @ b) for a, b in pairwise(chain)])
        length = np.full(self.n + 1, self.edge)
        length[[0, -1]] /= 2
        terms = self.K / length * (bend**2 @ (TORSION, EDGEWISE, 1.0)) / 2
        return terms.sum() if self.held else terms[1:-1].sum()

    def constraints(self, frames):
        values = list(self.place(frames, self.rod.length)[:2]) if self.held else []
        for action in self.rod.between:
            places = [self.place(frames, s) for s in action.s]
            if isinstance(action.element, ec.Tie):
                values.append(np.linalg.norm(places[1] - places[0]))
            elif isinstance(action.element, ec.Pin):
                values += list(places[0][:2])
            else:
                angle = np.interp(action.s[0], self.rod.s, self.rod.angle)
                values.append(places[0][:2] @ (-np.sin(angle), np.cos(angle)))
        return np.array(values)

    def rows(self):
        """Linear constraints on the turns out of the plane."""
        middle = (np.arange(self.n) + 0.5) * self.edge
        across = np.column_stack([-np.sin(self.angles), np.cos(self.angles)])
        rows = [(self.edge * across).ravel()] if self.held else list(np.tile(np.eye(2), self.n))
        for action in self.rod.between:
            s = action.s[0]
            if isinstance(action.element, ec.Pin):
                rows.append((np.clip(s - middle + self.edge / 2, 0, self.edge)[:, None] * across).ravel())
            elif isinstance(action.element, ec.Rail):
                near = np.clip(1 - np.abs(s - middle) / self.edge, 0, 1)
                rows.append((near[:, None] * (across @ [[0, -1], [1, 0]])).ravel())
        return np.array(rows)

    def margin(self):
        n, d, unit = self.n, self.STEP, np.eye(3 * self.n)
        plane = [i for i in range(3 * n) if i % 3 == 2]
        out = [i for i in range(3 * n) if i % 3 < 2]

        def slopes(value):
            pairs = ((value(self.frames(d * unit[i])), value(self.frames(-d * unit[i]))) for i in plane)
            return np.array([(after - before) / (2 * d) for after, before in pairs])

        forces = np.linalg.lstsq(slopes(self.constraints), -slopes(self.energy), rcond=None)[0]

        def total(turn):
            frames = self.frames(turn)
            return self.energy(frames) + forces @ self.constraints(frames)

        start = total(np.zeros(3 * n))
        alone = {i: total(d * unit[i]) - start for i in out}  # even in each turn out of the plane
        second = np.array([
            [2 * alone[i] if i == j else total(d * (unit[i] + unit[j])) - start - alone[i] - alone[j] for j in out]
            for i in out
        ]) / d**2  # fmt: skip
        rows = self.rows()
        free = np.linalg.svd(rows)[2][len(rows) :]
        return np.linalg.eigvalsh(free @ second @ free.T)[0] / self.edge * self.rod.length**2


def rotation(vectors):
    """Rotations (k, 3, 3) about vectors (k, 3)."""
    angle = np.linalg.norm(vectors, axis=1)
    axis = vectors / np.maximum(angle, 1e-300)[:, None]
    cross = np.zeros((len(axis), 3, 3))
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        cross[:, i, j], cross[:, j, i] = -axis[:, k], axis[:, k]
    sine, cosine = np.sin(angle)[:, None, None], np.cos(angle)[:, None, None]
    return np.eye(3) + sine * cross + (1 - cosine) * (cross @ cross)


def rotation_vector(turn):
    axis = np.array([turn[2, 1] - turn[1, 2], turn[0, 2] - turn[2, 0], turn[1, 0] - turn[0, 1]]) / 2
    sine = np.linalg.norm(axis)
    return axis if sine < 1e-12 else axis * (np.arctan2(sine, (np.trace(turn) - 1) / 2) / sine)
