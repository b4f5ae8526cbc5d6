"""Bending forward with rails, pins, ties and loads between the ends."""

from dataclasses import replace
from typing import get_args

import numpy as np
import pytest
from scipy.interpolate import BSpline
from scipy.optimize import brentq
from scipy.special import ellipe, ellipk

import elastica_cad as ec
from elastica_cad.errors import InputError
from elastica_cad.mechanics.bending import bend_path, has_snapped
from elastica_cad.mechanics.loads import EndName

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


NAMES = get_args(EndName)


def random_request(seed):
    """Return a straight or arched rod of 500 mm and keywords of `bend`: random supports, elements and loads."""
    random = np.random.default_rng(seed)
    ends = ("free", "free") if random.random() < 0.3 else random.choice(NAMES, 2)
    between = []
    for kind in random.choice(["pin", "rail", "slot", "tie"], random.integers(4), replace=False):
        at, end = sorted(random.uniform(0, 500, 2))
        if kind == "tie":
            between.append(ec.Tie(at, max(end, at + 60), length=max(end - at, 60) * random.uniform(0.9, 1)))
        else:
            between.append(ec.Pin(at) if kind == "pin" else ec.Rail(at, one_sided=kind == "rail"))
        if kind == "tie" and between[-1].end > 500:
            between.pop()
    forces = random.uniform(-0.02, 0.02, (random.integers(3), 2))
    loads = [ec.PointForce(at, force) for at, force in zip(random.uniform(0, 500, 2), forces, strict=False)]
    rod, side = ec.Rod.straight(500.0, samples=201), 1
    if [type(element) for element in between] != [ec.Tie]:
        rod, side = ec.bend(rod, end=(430.0, 0.0), supports=ec.Supports("pinned", "pinned")), None
    request = {"supports": ec.Supports(*ends), "between": between, "loads": loads, "side": side}
    if not loads and random.integers(2):
        request["gravity"] = ec.Gravity(300.0)
    return replace(rod, bending_stiffness=1e4), request


def point_of(rod, s):
    """Return a point of the rod, on the quadratic spline of its nodes."""
    edges = rod.s.size - 1
    nodes = np.vstack([2 * rod.position[:1] - rod.position[1:2], rod.position])
    nodes = np.vstack([nodes, 2 * nodes[-1:] - nodes[-2:-1]])
    return BSpline(np.arange(edges + 6) - 2.5, nodes, 2)(s * edges / rod.length)


def balance_of(rod):
    """Return the sums of forces and moments about the origin as fractions of the largest of them."""
    forces = [*zip(rod.support_forces, rod.position[[0, -1]], strict=True)]
    for action in (*rod.between, *rod.point_forces):
        forces += [(force, point_of(rod, s)) for s, force in zip(action.s, action.force, strict=True)]
    if rod.gravity is not None:
        weight = np.gradient(rod.s) * rod.stiffness / rod.gravity.length**3
        weight[[0, -1]] /= 2
        forces += zip(np.outer(weight, rod.gravity.direction), rod.position, strict=True)
    force, at = (np.array(column) for column in zip(*forces, strict=True))
    moments = np.array([*(at[:, 0] * force[:, 1] - at[:, 1] * force[:, 0]), -rod.moment[0], rod.moment[-1]])
    largest = max(np.abs(force).max(), 1e-15)
    return [*np.abs(force.sum(axis=0)) / largest, abs(moments.sum()) / max(np.abs(moments).max(), largest)]


@pytest.mark.parametrize("seed", range(12))
def test_forces_and_moments_add_up_or_the_supports_are_refused(seed):
    rod, request = random_request(seed)
    try:
        bent = ec.bend(rod, **request)
    except InputError as refused:
        held = ec.Supports(refused.refusal.values["start"], refused.refusal.values["end"])
        assert ec.bend(rod, **request | {"supports": held}).supports == held
        return
    assert np.max(balance_of(bent)) < 1e-6
    for action in bent.between:
        if isinstance(action.element, ec.Tie):
            chord = point_of(bent, action.s[1]) - point_of(bent, action.s[0])
            across = action.force[0] @ (-chord[1], chord[0]) / np.hypot(*chord)
            assert abs(across) <= 1e-6 * np.abs(bent.force).max()


@pytest.mark.parametrize("between", [ec.Tie(60.0, 240.0), ec.Rail(120.0)])
@pytest.mark.parametrize("supports", [("clamped", "clamped"), ("pinned", "pinned")])
def test_a_straight_strip_is_bent_while_something_holds_it(between, supports):
    """It is bent to its side although a rail or cord already touches it; the cord becomes slack."""
    rod = ec.Rod.straight(300.0, samples=101, supports=ec.Supports(*supports), bending_stiffness=1e4)
    bent = ec.bend(rod, end=(280, -5), side=1, between=between, loads=ec.PointForce(140.0, (0.0, -0.1)))
    assert np.max(balance_of(bent)) < 1e-6
    assert bent.position[:, 1].max() > 5
    assert bent.between[0].force.any() == isinstance(between, ec.Rail)


def test_the_first_small_movement_decides_to_which_side_a_rail_pushes():
    """Turned by 0.8 rad at once or in many steps, the arch leaves the bar that it touched."""
    arch = ec.bend(ec.Rod.straight(100.0, samples=101), end=(80, 0))
    arch = ec.bend(arch, supports=ec.Supports("clamped", "pinned"))
    turns = arch.angle[0] - 0.8 * np.linspace(0, 1, 101)[1:]
    steps = [{"angles": (turn, None)} for turn in turns]
    slow = bend_path(arch, [steps[0] | {"between": ec.Rail(70.0)}, *steps[1:]])[-1]
    once = ec.bend(arch, angles=(turns[-1], None), between=ec.Rail(70.0))
    assert largest_move(once, slow) < 1e-6
    assert not once.between[0].force.any()


def test_a_strip_that_would_be_pulled_tight_over_a_slot_is_refused():
    arch = ec.bend(ec.Rod.straight(300.0, samples=101), end=(200, 0))
    x, y = arch.position[50]
    slot = ec.Rail((float(x), float(y)), one_sided=False)
    assert np.hypot(x, y) + np.hypot(270 - x, y) > 300 > np.hypot(x, y) + np.hypot(215 - x, y)
    with pytest.raises(InputError, match=r"must be at least 3.* over the rails to .* only 300 mm long"):
        ec.bend(arch, end=(270, 0), between=slot)
    assert ec.bend(arch, end=(215, 0), between=slot).between[0].size > 0


@pytest.mark.parametrize(
    ("between", "supports"),
    [
        (ec.Pin(400.0), ("pinned", "free")),
        ((ec.Pin(0.0), ec.Pin(400.0)), ("free", "free")),
        ((ec.Pin(0.0), ec.Rail(400.0)), ("free", "free")),
        (ec.Rail(250.0), ("roller-x", "roller-y")),
        (ec.Pin(250.0), ("roller-x", "free")),
    ],
)
def test_supports_are_judged_together_with_rails_and_pins(between, supports):
    arch = ec.bend(
        ec.Rod.straight(500.0, samples=101), end=(430, 0), supports=ec.Supports("pinned", "pinned")
    )
    rod, load = replace(arch, bending_stiffness=1e4), ec.PointForce(200.0, (0, -0.01))
    bent = ec.bend(rod, supports=ec.Supports(*supports), between=between, loads=load)
    assert np.max(balance_of(bent)) < 1e-6
    drawn = ec.PlaneCurve.line((0, 0), (500, 0))
    assert ec.optimal_rod(drawn, supports=ec.Supports(*supports), between=between).ratio == 1.0


@pytest.mark.parametrize(
    ("between", "loads", "supports", "expected"),
    [
        (ec.Tie(0.0, 500.0, length=480.0), (0, -0.01), ("free", "free"), ("pinned", "roller-x")),
        (ec.Tie(40.0, 460.0, length=400.0), (0.02, 0), ("free", "free"), ("pinned", "roller-x")),
        (ec.Tie(40.0, 460.0, length=400.0), None, ("pinned", "free"), ("pinned", "roller-x")),
        ((ec.Rail(100.0), ec.Rail(400.0)), (0, -0.01), ("free", "free"), ("roller-y", "free")),
        (ec.Pin(100.0), (0, -0.01), ("free", "free"), ("roller-x", "free")),
        ((), (0, -0.01), ("pinned", "free"), ("pinned", "roller-x")),
        ((), None, ("guided", "roller-y"), ("guided", "pinned")),
    ],
)
def test_a_rod_that_nothing_holds_is_refused_with_the_fewest_supports(between, loads, supports, expected):
    rod = replace(ec.Rod.straight(500.0, samples=101), bending_stiffness=1e4)
    load = () if loads is None else ec.PointForce(200.0, loads)
    request = {"between": between, "loads": load, "side": None if between == () else 1}
    with pytest.raises(InputError, match="is free to") as refused:
        ec.bend(rod, supports=ec.Supports(*supports), **request)
    values = refused.value.refusal.values
    assert (values["start"], values["end"]) == expected
    assert np.max(balance_of(ec.bend(rod, supports=ec.Supports(*expected), **request))) < 1e-6


def test_a_bow_needs_no_support_under_loads_that_balance_each_other():
    rod = replace(ec.Rod.straight(500.0, samples=101), bending_stiffness=1e4)
    request = {
        "supports": ec.Supports("free", "free"),
        "between": ec.Tie(0.0, 500.0, length=450.0),
        "side": 1,
    }
    loads = [ec.PointForce(at, (0, force)) for at, force in ((100, 0.005), (250, -0.01), (400, 0.005))]
    bent = ec.bend(rod, loads=loads, **request)
    assert np.max(balance_of(bent)) < 1e-6
    with pytest.raises(InputError, match="free to move"):
        ec.bend(rod, loads=[*loads[:1], ec.PointForce(400, (0, -0.005))], **request)


# pi^2, and the first root of tan x = x squared
@pytest.mark.parametrize(("end", "load"), [("roller-x", np.pi**2), ("slide-x", 20.1907)])
@pytest.mark.parametrize("side", [1, -1])
def test_a_cord_buckles_a_straight_strip_in_the_first_mode_of_its_supports(end, load, side):
    rod = ec.Rod.straight(500.0, samples=401, supports=ec.Supports("pinned", end))
    bent = ec.bend(rod, between=ec.Tie(0.0, 500.0, length=499.0), side=side)
    assert bent.between[0].size * 500**2 == pytest.approx(load, rel=3e-3)
    assert np.sign(bent.position[200, 1]) == side
    assert ec.stability(bent).stable
