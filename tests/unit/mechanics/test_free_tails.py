"""Strips with free ends beyond their outermost tie, pin or rail, which are straight there."""

import numpy as np
import pytest

import elastica_cad as ec

FREE = ec.Supports("free", "free")
# the first and last three control points are collinear, so the curvature is 0 at both ends
POINTS = np.array(
    [(0, 0), (60, 60), (120, 120), (250, 210), (400, 240), (550, 210), (680, 120), (740, 60), (800, 0)], float
)
BENT = ec.PlaneCurve.spline(POINTS, degree=4)
START, END = 200.0, 150.0
P, Q = START, START + BENT.length


def with_tails(start=START, end=END, *, bend=0.0):
    """Return the arch of `POINTS` with tails that are straight or parabolas of a curvature `bend`, 1/mm."""
    pieces = []
    for size, point, toward in ((start, BENT.control_points[0], -1), (end, BENT.control_points[-1], 1)):
        k = np.arange(5)[:, None]
        along, left = toward * np.array([1.0, -toward]) / np.sqrt(2), np.array([1.0, toward]) / np.sqrt(2)
        pieces.append(point + size * k / 4 * along + bend * size**2 / 2 * k * (k - 1) / 12 * left)
    knots = np.concatenate([np.full(5, -1.0), np.zeros(4), BENT.knots[5:-5], np.ones(4), np.full(5, 2.0)])
    return ec.PlaneCurve(knots, np.concatenate([pieces[0][:0:-1], BENT.control_points, pieces[1][1:]]), 4)


TAILED = with_tails()


def chain_under_a_cord(rod, edges=160):
    """Return angles of edges, pull and lowest mode of a chain of rotary springs whose cord has a given length."""
    p, q = rod.between[0].s
    length, h = rod.between[0].distance_on(rod.curve), rod.length / edges
    ends = h * np.arange(edges)
    held = np.clip((q - ends) / h, 0, 1) - np.clip((p - ends) / h, 0, 1)
    spring = np.interp(ends[1:], rod.s, rod.stiffness) / h
    steps = np.diff(np.eye(edges), axis=0)
    bending = steps.T @ (spring[:, None] * steps)
    angle = 0.95 * np.interp(ends + h / 2, rod.s, rod.angle) + 0.03
    pull = 0.0
    for _ in range(12):
        along = np.column_stack([np.cos(angle), np.sin(angle)])
        left = np.column_stack([-along[:, 1], along[:, 0]])
        chord = h * held @ along
        size = np.hypot(*chord)
        u = chord / size
        across = np.array([-u[1], u[0]])
        slope, turning = h * held * (left @ u), h * held * (left @ across)
        hessian = bending + pull * (np.outer(turning, turning) / size - np.diag(h * held * (along @ u)))
        fixed = np.array([slope, left @ across])  # the cord, and the direction of the whole chain
        matrix = np.block([[hessian, fixed.T], [fixed, np.zeros((2, 2))]])
        right = np.concatenate([-bending @ angle - pull * slope, [length - size, 0.0]])
        step = np.linalg.solve(matrix, right)
        angle, pull = angle + step[:edges], pull + step[edges]
    allowed = np.linalg.svd(fixed)[2][2:].T
    lowest = np.linalg.eigvalsh(allowed.T @ hessian @ allowed)[0] / h * rod.length**2
    return angle, pull, lowest


def test_a_strip_tied_inside_takes_the_curve_as_an_independent_chain_does():
    rod = ec.optimal_rod(TAILED, supports=FREE, between=ec.Tie(P, Q))
    alone = ec.optimal_rod(BENT, supports=FREE, between=ec.Tie(0, BENT.length))
    assert rod.ratio == pytest.approx(alone.ratio, rel=1e-9)
    assert rod.length == pytest.approx(P + BENT.length + END)
    outside = (rod.s < P) | (rod.s > Q)
    assert np.ptp(rod.stiffness[rod.s < P]) < 1e-9 * rod.ratio
    assert np.abs(rod.moment[outside]).max() == 0.0
    assert not rod.warnings
    angle, pull, lowest = chain_under_a_cord(rod)
    assert pull == pytest.approx(rod.between[0].size, rel=2e-4)
    middles = (np.arange(angle.size) + 0.5) * rod.length / angle.size
    off = angle - rod.curve.at(middles).angle
    assert np.ptp(off) < 1e-4
    assert ec.stability(rod).margin == pytest.approx(lowest, rel=2e-3)


@pytest.mark.parametrize(
    "between",
    [
        (ec.Pin(P), ec.Pin(Q)),
        (ec.Rail(P), ec.Pin(600.0), ec.Rail(Q)),
        (ec.Tie(P, 700.0), ec.Tie(300.0, Q)),
    ],
)
def test_the_outermost_element_may_be_of_any_kind(between):
    rod = ec.optimal_rod(TAILED, supports=FREE, between=between)
    assert rod.residual < 1e-10
    again = ec.bend(rod)
    assert np.hypot(*(again.position - rod.position).T).max() < 3e-6 * rod.length


def test_a_clamped_strip_with_one_straight_free_end():
    wave = with_tails(end=150.0)
    half = wave.trimmed(0.5, 2.0)
    rod = ec.optimal_rod(half, supports=ec.Supports("clamped", "free"), between=ec.Rail((800, 0)))
    assert rod.residual < 1e-10
    assert rod.moment[rod.s > rod.between[0].s[0]].max() == 0.0


def test_a_place_given_to_a_millimetre_is_moved_to_the_end_of_the_straight_piece():
    rod = ec.optimal_rod(TAILED, supports=FREE, between=ec.Tie(201, 1147))
    assert rod.between[0].s == pytest.approx([P, Q], abs=1e-6)


def test_an_almost_straight_tail_is_straightened():
    rod = ec.optimal_rod(with_tails(bend=2e-6), supports=FREE, between=ec.Tie(P, Q))
    assert 0.01 < rod.moved < 0.1
    assert np.abs(rod.curvature[rod.s < P]).max() < 1e-12


@pytest.mark.parametrize(
    ("curve", "tie", "message"),
    [
        (TAILED, (230, Q), "The start is free, so the strip is straight .* at 230 mm.* or load to 200 mm"),
        (
            TAILED,
            (180, Q),
            "the place 200 mm from its start, but the element or load at 180 mm would bend this part",
        ),
        (TAILED, (P, 1200), "between its free end and the place 1146.* mm .* load at 1200 mm"),
        (with_tails(bend=1e-4), (P, Q), "from a straight line .allowed: 0.12 mm.. Draw this part straight"),
        (ec.PlaneCurve.ellipse((0, 0), (200, 100), start=0, end=np.pi), (90, 394), "The end is free"),
    ],
)
def test_impossible_tails_are_refused_with_the_reason(curve, tie, message):
    with pytest.raises(ec.NotRealizable, match=message):
        ec.optimal_rod(curve, supports=FREE, between=ec.Tie(*tie))


def test_a_bend_that_jumps_at_the_tie_is_refused():
    arc = ec.PlaneCurve.spline([(0, 0), (100, 150), (300, 150), (400, 0)], degree=3)
    knots = np.concatenate([np.full(4, -1.0), np.zeros(3), np.full(4, 1.0)])
    line = np.array([(-120, -180), (-80, -120), (-40, -60)], float)
    curve = ec.PlaneCurve(knots, np.concatenate([line, arc.control_points]), 3)
    tail = float(np.hypot(120, 180))
    with pytest.raises(ec.NotRealizable, match=r"the bent part, 216.* it jumps to -0.00"):
        ec.optimal_rod(curve, supports=FREE, between=ec.Tie(tail, curve.length))


def drawn_bow(third):
    """Return straight tails of 200 mm and two cubics, whose third control point is at the height `third`."""
    left = np.array([(0, 0), (57, 35), (113, 70), (170, 105), (340, 210), (420, third), (520, third)], float)
    right = left[-2::-1] * (-1, 1) + (1040, 0)
    knots = np.repeat([-1.0, 0.0, 0.5, 1.0, 2.0], [4, 3, 3, 3, 4])
    return ec.PlaneCurve(knots, np.concatenate([left, right]), 3)


def test_a_small_bend_at_the_tie_is_noise_of_the_drawing():
    tail = float(np.hypot(170, 105))
    for third in (260.0, 259.5, 259.0):  # 259.41 is collinear with the tail
        curve = drawn_bow(third)
        rod = ec.optimal_rod(curve, supports=FREE, between=ec.Tie(tail, curve.length - tail))
        assert rod.moved < 1e-4 * curve.length
        assert np.abs(rod.curvature[[0, -1]]).max() < 1e-12
        far = [np.hypot(*(curve.sample(4001).position - place).T).min() for place in rod.position]
        assert max(far) < 1.1e-4 * curve.length + 0.01


@pytest.mark.parametrize("samples", [201, 601])
def test_a_bent_batten_that_is_written_and_read_needs_one_width(samples, tmp_path):
    flat = ec.Rod.straight(1200.0, samples=samples)
    bent = ec.bend(flat, between=ec.Tie(243, 955, length=600), supports=FREE, side=1)
    ec.write_curves([bent.curve], tmp_path / "bent.json")
    (curve,) = ec.read_curves(tmp_path / "bent.json")
    assert np.hypot(*(curve.at(bent.s).position - bent.position).T).max() < 1e-5 * curve.length
    rod = ec.optimal_rod(curve, supports=FREE, between=ec.Tie(243, 955))
    assert rod.ratio < 1.001
    assert rod.between[0].size == pytest.approx(bent.between[0].size, rel=1e-3)


@pytest.mark.parametrize("ends", [("clamped", "free"), ("free", "clamped")])
def test_the_spline_of_a_bent_batten_matches_its_clamped_end(ends):
    flat = ec.Rod.straight(1200.0, samples=401, supports=ec.Supports(*ends))
    rod = ec.bend(flat, between=ec.Tie(300, 955, length=600), side=1)
    held = ends.index("clamped")
    samples = rod.curve.at(rod.s)
    assert samples.position[-held] == pytest.approx(rod.position[-held], abs=1e-9)
    assert samples.angle[-held] == pytest.approx(rod.angle[-held], abs=1e-12)
    assert np.hypot(*(samples.position - rod.position).T).max() < 2e-6 * rod.length
