"""Bending of a strip that is also compressed along its length."""

from dataclasses import replace

import numpy as np
import pytest

import elastica_cad as ec
from elastica_cad.mechanics.bending import bend, has_snapped, state_of, system_of
from elastica_cad.mechanics.discrete_rod import Compression
from elastica_cad.mechanics.elements import ElementForce, Guide, Mount
from elastica_cad.mechanics.mounted_elements import mounted
from elastica_cad.mechanics.newton_continuation import correct
from tests.spring_chain import SpringChain

SHEET = ec.Sheet.named("birch-plywood-6")
SLAT = ec.PlaneCurve.spline([(0, 0), (130, 1), (270, 12), (400, 14), (530, 12), (670, 1), (800, 0)], degree=5)
RADIUS = 2.0  # radius of gyration of the sine arches, mm
SPAN, B = 800.0, 1e6


def guide(at, turn, point):
    """A guide along a direction at an angle, rad."""
    direction = (float(np.cos(turn)), float(np.sin(turn)))
    return ElementForce(Guide(direction), np.array([at]), np.zeros((1, 2)), Mount(point))


def slat(between=(), samples=81):
    return ec.make_strip(SLAT, SHEET, max_width=100, between=between, samples=samples)


def largest(rod, other):
    return float(np.hypot(*(rod.position - other).T).max())


def chain_of(rod):
    B = rod.bending_stiffness
    return SpringChain(
        rod.position, B / rod.compression.compliance, B * rod.stiffness, -B * rod.discrete.pull, rod.angle[[0, -1]]
    )  # fmt: skip


@pytest.mark.parametrize("between", [(), ec.Rail(400), (ec.Pin(300), ec.Tie(100, 700))])
def test_a_design_rests_where_it_is_drawn(between):
    strip = slat(between, samples=401)
    rest = bend(strip.rod_to_bend)
    assert largest(rest, strip.rod.position) < 1e-6 * strip.rod.length
    assert rest.between_forces == pytest.approx(strip.rod.between_forces, rel=5e-3, abs=1e-9)
    assert rest.curve.length == pytest.approx(strip.rod.length, rel=1e-6)
    again = bend(rest)
    assert largest(again, rest.position) < 1e-9


@pytest.mark.parametrize(("pinned", "newtons"), [(False, 40.0), (True, 80.0), (True, 400.0)])
def test_a_clamped_slat_is_a_chain_of_springs(pinned, newtons):
    """In a flat slat between clamps, the compression decides forces and sag: on a pin by factors."""
    at, accuracy = (20, 40), 1e-2 if pinned else 1e-3
    strip = slat((ec.Pin(SLAT.length / 2),) if pinned else ())
    rod = bend(strip.rod_to_bend)
    loaded = bend(rod, loads=ec.PointForce(float(rod.s[at[0]]), (0, -newtons)))
    nodes, reactions, unstable = chain_of(rod).rest({at[0]: (0, -newtons)}, at[1:] if pinned else ())
    assert largest(loaded, nodes) < accuracy * largest(rod, nodes)
    ends = rod.bending_stiffness * loaded.support_forces
    assert ends == pytest.approx(reactions[[0, -1]], abs=accuracy * np.abs(reactions).max())
    assert ec.stability(loaded).stable
    assert unstable == 0
    if pinned:
        push = rod.bending_stiffness * loaded.between_forces[0]
        assert push == pytest.approx(reactions[at[1]], abs=accuracy * np.abs(reactions).max())
        rigid = bend(replace(rod, compression=None), loads=ec.PointForce(float(rod.s[at[0]]), (0, -newtons)))
        assert np.hypot(*rigid.support_forces[0]) > 1.4 * np.hypot(*loaded.support_forces[0])


def test_a_flat_board_between_clamps_sags():
    """The board is as long as the distance of its ends, so only its stretch lets it sag."""
    board = ec.Strip(ec.Rod.straight(800.0, samples=81), SHEET, max_width=100.0).rod_to_bend
    sagging = bend(board, loads=ec.PointForce(400.0, (0, -80)))
    nodes, reactions, _ = chain_of(board).rest({40: (0, -80)})
    assert sagging.position[40, 1] == pytest.approx(nodes[40, 1], rel=1e-3)
    assert board.bending_stiffness * sagging.support_forces == pytest.approx(reactions[[0, -1]], rel=2e-3)


def test_a_board_is_compressed_before_it_bends():
    """It buckles at the load of Euler, 4 pi^2 E I / L^2, not at the first push."""
    strip = ec.Strip(ec.Rod.straight(800.0, samples=81), SHEET, max_width=100.0)
    euler = 4 * np.pi**2 * strip.bending_stiffness / 800**2
    axial = SHEET.youngs_modulus * 600.0
    push = 0.5 * euler * 800 / axial
    pushed, bent = (bend(strip.rod_to_bend, end=(800 - times * push, 0.0)) for times in (1, 8))
    assert np.ptp(pushed.position[:, 1]) < 1e-9
    assert strip.bending_stiffness * pushed.support_forces[0, 0] == pytest.approx(euler / 2, rel=1e-9)
    assert strip.bending_stiffness * bent.support_forces[0, 0] == pytest.approx(euler, rel=2e-3)
    rise = 2 / np.pi * np.sqrt((8 * push - euler * 800 / axial) * 800)
    assert np.ptp(bent.position[:, 1]) == pytest.approx(rise, rel=2e-3)


def sine_arch(rise):
    """Return a pinned arch without stress, its load as a sine, and the closed form of the load at which it snaps.

    With the height b sin(pi x / L) under the load q sin(pi x / L) and k = pi / L: q = E I k^4 (a - b) + E A k^4 / 4
    (a^2 - b^2) b. The load has a maximum at b^2 = (a^2 - 4 r^2) / 3, and the arch tips at b^2 = a^2 - 16 r^2.
    """
    x, k = np.linspace(0, SPAN, 2001), np.pi / SPAN
    s = np.append(0.0, np.cumsum(np.hypot(np.diff(x), np.diff(rise * np.sin(k * x)))))
    at = np.interp(np.linspace(0, s[-1], 101), s, x)
    bent = -rise * k**2 * np.sin(k * at) / (1 + (rise * k * np.cos(k * at)) ** 2) ** 1.5
    flat = ec.Rod.straight(
        s[-1], samples=101, supports=ec.Supports("pinned", "pinned"), natural_curvature=bent, bending_stiffness=B
    )  # fmt: skip
    arch = bend(flat, end=(SPAN, 0.0))
    arch = replace(arch, compression=Compression(np.full(100, RADIUS**2), arch.discrete.pull))
    places = (np.arange(40) + 0.5) / 40 * s[-1]
    lowest = np.sqrt(max((rise**2 - 4 * RADIUS**2) / 3, rise**2 - 16 * RADIUS**2))
    snap = B * k**4 * ((rise - lowest) + (rise**2 - lowest**2) * lowest / (4 * RADIUS**2))

    def loaded(fraction):
        shares = fraction * snap * np.sin(k * np.interp(places, s, x)) * SPAN / 40
        loads = [
            ec.PointForce(float(place), (0.0, -float(share)))
            for place, share in zip(places, shares, strict=True)
        ]
        return bend(arch, loads=loads)

    return loaded


@pytest.mark.parametrize("rise", [4, 6, 12])
def test_a_sine_arch_snaps_at_the_load_of_the_closed_form(rise):
    loaded = sine_arch(rise * RADIUS)
    assert ec.stability(loaded(0.985)).stable
    over = loaded(1.015)
    assert has_snapped(over) or not ec.stability(over).stable


def test_a_snapped_arch_rests_where_the_closed_form_says():
    """At a rise of 4 r and the load 8 E I k^4 r the other root of the cubic is b = -4 r."""
    over = sine_arch(4 * RADIUS)(1.0 + 1e-3)
    assert has_snapped(over)
    assert ec.stability(over).stable
    assert over.position[50, 1] == pytest.approx(-4 * RADIUS, rel=3e-3)


@pytest.mark.parametrize("supports", [("clamped", "clamped"), ("pinned", "clamped"), (None, "clamped")])
def test_the_matrix_of_newton_is_the_derivative_of_the_residual(supports):
    strip = slat((ec.Rail(400), ec.Pin(200), ec.Tie(100, 700)), samples=21)
    held = tuple(ec.End(x=False, angle=False) if end is None else end for end in supports)
    rod = replace(strip.rod_to_bend, supports=ec.Supports(*held))
    elements = (*mounted(rod, None), guide(610.0, 0.7, (600.0, 8.0)))
    state = state_of(rod, replace(system_of(rod, rod), actions=elements))
    rng = np.random.default_rng(5)
    n, k = state.angles.size, state.reactions.size
    at = state.angles + 0.02 * rng.normal(size=n), state.reactions + 1e-5 * rng.normal(size=k)

    def residual(x):
        return np.concatenate(state.system.state(at[0] + x[:n], at[1] + x[n:]).residual)

    there = state.system.state(*at)
    diagonal, off = there.discrete.hessian
    matrix = np.block([
        [np.diag(diagonal) + np.diag(off, 1) + np.diag(off, -1), there.rows.T], [there.rows, there.corner],
    ])  # fmt: skip
    for j in range(n + k):
        size = 1e-6 if j < n else 1e-8
        step = np.where(np.arange(n + k) == j, size, 0.0)
        change = (residual(step) - residual(-step)) / (2 * size)
        assert change == pytest.approx(matrix[:, j], abs=2e-5 * np.abs(matrix[:, j]).max())


@pytest.mark.parametrize(
    ("start", "elastic"),
    [("clamped", True), (ec.End(x=False, angle=False), True), (ec.End(x=False, angle=False), False)],
)
def test_two_guides_across_each_other_hold_as_a_pin(start, elastic):
    rod = slat((ec.Pin(300),)).rod_to_bend
    rod = replace(
        rod, supports=ec.Supports(start, "clamped"), compression=rod.compression if elastic else None
    )
    (pin,) = mounted(rod, None)
    x, y = pin.mounting.point
    pin = replace(pin, mount=Mount((x + 0.02, y + 0.5)))
    guides = tuple(guide(float(pin.s[0]), turn, pin.mounting.point) for turn in (0.4, 0.4 + np.pi / 2))
    states = [
        correct(state_of(rod, replace(system_of(rod, rod), actions=actions)))[0]
        for actions in ((pin,), guides)
    ]
    pinned, guided = states
    assert guided.angles == pytest.approx(pinned.angles, abs=1e-9)
    force = pinned.actions[0].force[0]
    assert sum(action.force[0] for action in guided.actions) == pytest.approx(force, rel=1e-6)
    assert np.linalg.norm(force) > 1e-6
    assert guided.discrete.margin.value == pytest.approx(pinned.discrete.margin.value, rel=1e-6)


@pytest.mark.parametrize("rail", [False, True])
def test_unstable_modes_are_those_of_the_matrix(rail):
    """Each force of a support lowers one eigenvalue of the bordered matrix, and each slide raises none."""
    between = (ec.Pin(200), *((ec.Rail(500, one_sided=False),) if rail else ()), ec.Tie(100, 700))
    rod = slat(between, samples=41).rod_to_bend
    for push in (0.0, 2e-4, 1e-3):
        elements = (*mounted(rod, None), guide(610.0, 0.7, (600.0, 8.0)))
        state = state_of(rod, replace(system_of(rod, rod), actions=elements))
        pushed = state.reactions + np.where(np.arange(state.reactions.size) == 0, push, 0.0)
        state = state.system.state(state.angles, pushed)
        (diagonal, off), rows = state.discrete.hessian, state.rows
        unit = np.where(state.places, 1.0, rod.length**3)
        matrix = np.block([
            [np.diag(diagonal) + np.diag(off, 1) + np.diag(off, -1), (unit[:, None] * rows).T],
            [unit[:, None] * rows, unit[:, None] * state.corner * unit],
        ])  # fmt: skip
        negative = int(np.count_nonzero(np.linalg.eigvalsh(matrix) < 0))
        assert state.discrete.unstable_modes == negative - int(state.places.sum())
