"""Bending forward with rails, pins, ties and loads between the ends."""

import numpy as np
import pytest
from scipy.optimize import brentq
from scipy.special import ellipe, ellipk

import elastica_cad as ec
from elastica_cad.errors import InputError
from elastica_cad.mechanics.bending import bend_path, has_snapped

WAVE = ec.PlaneCurve.spline(
    [(0, 0), (60, 60), (120, 10), (180, -40), (240, 5), (300, 60), (360, 0)], degree=5
)
DOWN, UP = ec.Gravity(1.0, (0, -1)), ec.Gravity(1.0, (0, 1))
SLIDES = ec.Supports("pinned", ec.End(x=False, angle=False))
SPAN, LOAD, BENDING = 1000.0, 1e-5, 1e6  # mm, N/mm, N mm2


def largest_move(first, second):
    return np.hypot(*(first.position - second.position).T).max()


def slat(gravity=DOWN, supports=SLIDES, load=LOAD):
    return ec.Rod.straight(
        SPAN, samples=101, supports=supports, bending_stiffness=BENDING, gravity=gravity,
        weight=ec.Weight(alpha=load),
    )  # fmt: skip


@pytest.fixture(scope="module")
def bow():
    flat = ec.Rod.straight(500.0, samples=401)
    curve = ec.bend(flat, end=(400.0, 0.0), supports=ec.Supports("pinned", "pinned")).curve
    return ec.optimal_rod(
        curve, supports=ec.Supports("free", "free"), between=ec.Tie(0, curve.length), samples=401
    )


@pytest.mark.parametrize(
    "between",
    [
        ec.Pin(200.0),
        ec.Rail(200.0),
        ec.Tie(60, 320),
        (ec.Pin(200.0), ec.Tie(60, 320)),
        (ec.Rail(150.0), ec.Rail(220.0)),
    ],
)
def test_a_design_rests_on_its_elements(between):
    rod = ec.optimal_rod(WAVE, between=between)
    rest = ec.bend(rod)
    assert largest_move(rest, rod) < 1e-5 * rod.length
    assert rest.between_forces == pytest.approx(
        rod.between_forces, abs=5e-3 * np.abs(rod.between_forces).max()
    )
    assert ec.stability(rest).margin == pytest.approx(ec.stability(rod).margin, rel=2e-3)
    assert largest_move(ec.bend(rest), rest) < 1e-9


@pytest.mark.parametrize("one_sided", [True, False])
def test_three_supports(one_sided):
    """Even load, small sag: 5/4 of the load of a span in the middle, 3/8 at the ends."""
    rest = ec.bend(slat(), between=ec.Rail(SPAN / 2, one_sided=one_sided))
    forces = BENDING * np.array([rest.force[0, 1], rest.between_forces[0, 1], -rest.force[-1, 1]])
    assert forces / (LOAD * SPAN / 2) == pytest.approx([3 / 8, 5 / 4, 3 / 8], rel=3e-4)
    assert ec.stability(rest).stable


def test_a_strip_lifts_off_a_rail_and_comes_back():
    held = ec.bend(slat(load=2e-3), between=ec.Rail(SPAN / 2))
    lifted, free = ec.bend(held, gravity=UP), ec.bend(slat(UP, load=2e-3))
    assert lifted.between_forces == pytest.approx(0.0, abs=0.0)
    assert largest_move(lifted, free) < 1e-6
    assert largest_move(ec.bend(lifted, gravity=DOWN), held) < 1e-6
    slot = ec.bend(slat(load=2e-3), between=ec.Rail(SPAN / 2, one_sided=False))
    assert ec.bend(slot, gravity=UP).position[50, 1] == pytest.approx(0.0, abs=4e-3)


def test_a_rail_and_a_pin_move_the_strip():
    for element in (ec.Rail, ec.Pin):
        rod = ec.optimal_rod(WAVE, between=element(200.0))
        at = WAVE.at([200.0]).position[0] + (0.5, 2.0)
        moved = ec.bend(rod, between=element((*at,)))
        reached = moved.curve.at(moved.between[0].s).position[0]
        assert reached == pytest.approx(at, abs=1e-3)
        assert 1.0 < largest_move(moved, rod) < 10.0
        assert element is ec.Rail or moved.between[0].s == pytest.approx(200.0)


@pytest.mark.parametrize("cord", [400.0, 350.0, 200.0])
def test_a_bow_with_a_shorter_cord(bow, cord):
    """Inflectional elastica in elliptic integrals: pull, rise and end angle."""
    m = brentq(lambda m: 2 * ellipe(m) / ellipk(m) - 1 - cord / 500.0, 1e-6, 0.99)
    bent = ec.bend(bow, between=ec.Tie(0, 500.0, length=cord))
    pull = np.hypot(*bent.between_forces[0]) * 500.0**2
    assert pull == pytest.approx(4 * ellipk(m) ** 2, rel=1e-5)
    chord = bent.position[-1] - bent.position[0]
    assert np.hypot(*chord) == pytest.approx(cord, rel=1e-8)
    along = chord / cord
    rise = np.abs((bent.position - bent.position[0]) @ [-along[1], along[0]]).max()
    assert rise / 500.0 == pytest.approx(np.sqrt(m) / ellipk(m), rel=1e-4)
    start = np.exp(1j * bent.angle[0]) / complex(*along)
    assert abs(np.angle(start)) == pytest.approx(2 * np.arcsin(np.sqrt(m)), rel=1e-4)
    assert ec.stability(bent).stable


def test_a_tie_becomes_slack_and_taut_again():
    arch = ec.bend(ec.Rod.straight(300.0, samples=301), end=(220.0, 0.0))
    tied = ec.bend(arch, between=ec.Tie(75.0, 225.0, length=100.0))
    assert np.hypot(*tied.between_forces[0]) > 1e-4
    places = tied.curve.at(tied.between[0].s).position
    assert np.hypot(*(places[1] - places[0])) == pytest.approx(100.0, rel=2e-5)
    closer = ec.bend(tied, end=(100.0, 0.0))
    assert np.all(closer.between_forces == 0)
    assert largest_move(closer, ec.bend(arch, end=(100.0, 0.0))) < 1e-6
    assert largest_move(ec.bend(closer, end=(220.0, 0.0)), tied) < 1e-6


def test_loads_replace_those_of_the_rod():
    """A cantilever: sag P L^3 / (3 E I), small."""
    clamped = ec.Supports("clamped", "free")
    rod = ec.Rod.straight(100.0, samples=201, supports=clamped, bending_stiffness=BENDING)
    pushed = ec.bend(rod, loads=ec.PointForce(100.0, (0, -0.01)))
    assert pushed.position[-1, 1] == pytest.approx(-0.01 * 100.0**3 / (3 * BENDING), rel=1e-4)
    hung = ec.bend(rod, gravity=ec.Gravity(1e5, (0, -1)), loads=ec.PointMass(100.0, 10 / 9.80665))
    assert hung.position[-1, 1] == pytest.approx(pushed.position[-1, 1], rel=1e-3)
    assert ec.bend(pushed, loads=()).position[-1, 1] == pytest.approx(0.0, abs=1e-9)
    with pytest.raises(InputError, match="Loads in newtons"):
        ec.bend(ec.Rod.straight(100.0), loads=ec.PointForce(50.0, (0, -1)))


def test_a_strip_lifts_off_its_rail_where_the_path_says_so():
    """With the rail as a slot, the shape at the end of the path would be an S."""
    points = [(0, 0), (150, 45), (300, 60), (450, 45), (600, 0)]
    curve = ec.PlaneCurve.spline(points, degree=4)
    rod = ec.optimal_rod(curve, between=ec.Rail(curve.length / 2), samples=201)
    closer = ec.bend(rod, end=(590.0, 0.0))
    assert np.all(closer.between_forces == 0)
    assert not closer.warnings
    assert closer.position[100, 1] > rod.position[100, 1] + 10
    assert ec.stability(closer).stable
    path = bend_path(rod, [{"end": (600.0, 0.0)}, {"loads": ()}, {"between": ()}])
    assert [len(one.between) for one in path] == [1, 1, 0]


def test_a_strip_on_a_rail_under_a_mass():
    """The strip as built keeps its rail; a slat that is bent further takes loads in newtons."""
    points = [(0, 0), (150, 45), (300, 60), (450, 45), (600, 0)]
    curve = ec.PlaneCurve.spline(points, degree=4)
    rod = ec.optimal_rod(curve, between=ec.Rail(curve.length / 2), samples=201)
    strip = ec.Strip(rod, "birch-plywood-4", max_width=60.0)
    assert strip.deviation_as_built < 0.01
    loaded = ec.bend(strip.rod_to_bend, loads=ec.PointForce(curve.length / 4, (0, -20.0)))
    sag = rod.position[:, 1] - loaded.position[:, 1]
    assert 1.0 < sag.max() < 3.0
    doubled = ec.bend(strip.rod_to_bend, loads=ec.PointForce(curve.length / 4, (0, -40.0)))
    assert (rod.position[:, 1] - doubled.position[:, 1]).max() == pytest.approx(2 * sag.max(), rel=0.1)


def test_two_free_ends_need_an_element(bow):
    with pytest.raises(InputError, match="free to move along x"):
        ec.bend(bow, between=())


def test_a_strip_that_is_pulled_off_its_rail_snaps_where_the_rail_lets_go():
    """A force at the rail replaces the force of the rail; the strip alone is unstable there."""
    rod = ec.bend(ec.optimal_rod(WAVE, between=ec.Rail(200.0), loads=ec.PointForce(200.0, (0, 1e-9)),
                                 bending_stiffness=1e4, samples=201))  # fmt: skip
    push = 1e4 * rod.between_forces[0]
    held = ec.bend(rod, loads=ec.PointForce(200.0, 0.9 * push))
    assert largest_move(held, rod) < 1e-3 * rod.length
    assert 1e4 * held.between_forces[0] == pytest.approx(0.1 * push, rel=0.02, abs=2e-3 * np.hypot(*push))
    snapped = ec.bend(rod, loads=ec.PointForce(200.0, 2 * push))
    assert not snapped.between_forces.any()
    assert has_snapped(snapped)
    assert ec.stability(snapped).stable
    assert snapped.warnings[0].values["percent"] == pytest.approx(50.0, abs=1.0)


def test_a_pin_out_of_reach_is_refused():
    rod = ec.optimal_rod(WAVE, between=ec.Pin(200.0), samples=201)
    point = WAVE.at([200.0]).position[0]
    tangent = np.array([np.cos(WAVE.at([200.0]).angle[0]), np.sin(WAVE.at([200.0]).angle[0])])
    slack = 200.0 - np.hypot(*point)
    assert ec.bend(rod, between=ec.Pin(tuple(point + 0.5 * slack * tangent))).between_forces.size
    with pytest.raises(InputError, match=r"are 205 mm apart, but the strip between them is only 200 mm long"):
        ec.bend(rod, between=ec.Pin(tuple(205 * point / np.hypot(*point))))


def test_a_straight_strip_under_a_shorter_cord_needs_a_side():
    slides = ec.Supports("pinned", ec.End(x=False, angle=False))
    with pytest.raises(InputError, match=r"could bend it to either side. Set side to the side"):
        ec.bend(ec.Rod.straight(300.0, samples=101, supports=slides), between=ec.Tie(0, 300, length=280))


@pytest.mark.parametrize("side", [1, -1])
@pytest.mark.parametrize("share", [0.99, 0.8, 0.4])
def test_a_batten_tied_inside_becomes_the_inflectional_elastica(side, share):
    """In elliptic integrals: chord over length 2 E / K - 1, pull 4 K^2 E I / L^2, end angle 2 asin(k)."""
    m = brentq(lambda m: 2 * ellipe(m) / ellipk(m) - 1 - share, 1e-9, 0.99)
    free, flat = ec.Supports("free", "free"), ec.Rod.straight(1200.0, samples=601)
    rod = ec.bend(flat, between=ec.Tie(240, 960, length=720 * share), supports=free, side=side)
    assert rod.between[0].size * 720**2 == pytest.approx(4 * ellipk(m) ** 2, rel=1e-4)
    assert rod.angle[0] == pytest.approx(side * 2 * np.arcsin(np.sqrt(m)), rel=1e-3)
    assert np.abs(rod.moment[rod.s < 237]).max() < 1e-9
    assert ec.stability(rod).stable
