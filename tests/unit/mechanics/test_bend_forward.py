"""What bend does with ends, loads, supports and bad input."""

from dataclasses import replace

import numpy as np
import pytest

from elastica_cad import (
    End,
    Gravity,
    InputError,
    PointForce,
    PointMass,
    Profile,
    Rod,
    Supports,
    Tie,
    Weight,
    bend,
    stability,
)
from elastica_cad.mechanics import PolynomialLaw, bend_path
from elastica_cad.mechanics.bending import snap_percent

pytestmark = pytest.mark.core

CANTILEVER = Supports("clamped", "free")


def test_end_moment_makes_an_arc():
    for moment in (2.0, -4 * np.pi):
        rod = bend(Rod.straight(1.0, samples=201, supports=CANTILEVER), moment=moment)
        assert rod.curvature == pytest.approx(np.full(201, moment), abs=1e-9)
        assert rod.angle[-1] == pytest.approx(moment)
    start = bend(Rod.straight(1.0, samples=201, supports=Supports("free", "clamped")), moment=2.0)
    assert start.angle[0] == pytest.approx(2.0)
    assert start.moment == pytest.approx(np.full(201, -2.0), abs=1e-9)


def test_natural_curvature_makes_an_arc():
    rod = bend(Rod.straight(1.0, samples=101, natural_curvature=3.0, supports=CANTILEVER))
    assert rod.curvature == pytest.approx(np.full(101, 3.0), abs=1e-9)
    assert np.abs(rod.moment).max() < 1e-9


def test_force_is_minus_the_internal_force_and_balances_the_weight():
    gravity = Gravity(70.0, (0.3, -1.0))
    rod = bend(Rod.straight(100.0, [1.0, 2.0, 1.0], samples=151, gravity=gravity), end=(60.0, 20.0))
    assert rod.force[-1] - rod.force[0] == pytest.approx(rod.nodal_load.sum(axis=0))
    b = rod.force @ np.array([[0.0, -1.0], [1.0, 0.0]])  # R^t lambda
    slope = np.gradient(rod.moment, rod.s)
    tangent = np.column_stack([np.cos(rod.angle), np.sin(rod.angle)])
    assert slope[5:-5] == pytest.approx(np.sum(b * tangent, axis=1)[5:-5], abs=2e-6)


def test_dead_force_at_the_end_is_minus_lambda_there_and_is_kept():
    rod = bend(Rod.straight(1.0, samples=101, supports=CANTILEVER), force=(0.3, -2.0))
    assert rod.force[-1] == pytest.approx([-0.3, 2.0])
    again = bend(rod, angles=(0.4, None))
    assert again.force[-1] == pytest.approx([-0.3, 2.0])
    start = bend(Rod.straight(1.0, samples=101, supports=Supports("free", "clamped")), force=(0.3, -2.0))
    assert start.force[0] == pytest.approx([0.3, -2.0])
    assert start.position[0, 1] < -0.4


def test_what_a_right_angle_leaves_of_a_force_is_none():
    """Pulled along the slider's way, by the cosine and sine of that way."""
    rod = Rod.straight(100.0, samples=101, supports=Supports("clamped", "slide-y"))
    way = np.array([np.cos(np.pi / 2), np.sin(np.pi / 2)]) * 1e-4
    pulled = bend(rod, end=(90.0, 0.0), force=way)
    assert way[0] != 0
    assert pulled.position == pytest.approx(bend(rod, end=(90.0, 0.0), force=(0.0, 1e-4)).position)
    with pytest.raises(InputError, match="a force along x has no effect"):
        bend(rod, end=(90.0, 0.0), force=(1e-9, 1e-4))


def test_ends_angles_and_residual():
    rod = bend(
        Rod.straight(100.0, [1.0, 3.0], samples=101), start=(5.0, 6.0), end=(60.0, 40.0), angles=(0.2, 1.0)
    )
    assert rod.position[[0, -1]] == pytest.approx(np.array([[5.0, 6.0], [60.0, 40.0]]), abs=1e-8)
    assert rod.angle[[0, -1]] == pytest.approx([0.2, 1.0])
    assert rod.residual < 1e-10
    assert rod.s[-1] == pytest.approx(100.0)


def test_free_coordinates_take_what_equilibrium_gives():
    rod = bend(Rod.straight(1.0, samples=201, supports=Supports("clamped", "slide-x")), end=(99.0, 0.3))
    assert rod.position[-1, 1] == pytest.approx(0.3)
    assert 0.9 < rod.position[-1, 0] < 0.97
    assert rod.force[:, 0] == pytest.approx(np.zeros(201), abs=1e-9)


def test_supports_may_be_released():
    arch = bend(Rod.straight(1.0, samples=201), end=(0.6, 0.0))
    pinned = bend(arch, supports=Supports("pinned", "pinned"))
    assert pinned.moment[[0, -1]] == pytest.approx([0.0, 0.0])
    assert stability(pinned).stable
    free = bend(pinned, supports=Supports("clamped", "free"), angles=(0.5, None))
    assert free.position[-1] == pytest.approx([np.cos(0.5), np.sin(0.5)])


def test_side_and_mode():
    straight = Rod.straight(1.0, samples=201)
    left, right = (bend(straight, end=(0.8, 0.0), side=side) for side in (1, -1))
    assert left.position[100, 1] > 0.2
    assert right.position == pytest.approx(left.position * [1, -1], abs=1e-9)
    second = bend(straight, end=(0.8, 0.0), mode=2)
    assert second.position[100, 1] == pytest.approx(0.0, abs=1e-9)
    assert second.position[50, 1] > 0.1
    assert stability(second).negative == 1


def test_letting_an_unstable_mode_go():
    second = bend(Rod.straight(1.0, samples=201), end=(0.8, 0.0), mode=2)
    first = bend(second, settle=True)
    assert stability(first).stable
    assert np.abs(first.position[100, 1]) > 0.2


def test_closed_loop_and_coil():
    ring = bend(Rod.straight(1.0, samples=201), end=(0.0, 0.0), angles=(0.0, 2 * np.pi))
    assert ring.curvature == pytest.approx(np.full(201, 2 * np.pi), rel=1e-3)
    coil = bend(Rod.straight(1.0, samples=201), end=(0.1, 0.0), angles=(0.0, 4 * np.pi))
    assert coil.angle[-1] == pytest.approx(4 * np.pi)


def test_straight_rods_stay_straight_when_they_can():
    for turned in (np.pi / 2, 5 * np.pi / 2, -7 * np.pi / 2):
        rod = bend(Rod.straight(1.0, samples=51), end=(0.0, 1.0), angles=(turned, turned))
        assert rod.position[-1] == pytest.approx([0.0, 1.0])
        assert rod.angle == pytest.approx(np.full(51, turned))
        assert np.abs(rod.moment).max() == 0.0


def test_rough_shapes_are_reported():
    """An arc of 3 rad between neighbouring edges is no arc any more."""
    fine, rough = (bend(Rod.straight(1.0, samples=n, supports=CANTILEVER), moment=10.0) for n in (51, 6))
    assert fine.warnings == ()
    assert "use more samples" in rough.warnings[0]
    assert bend(rough).angle == pytest.approx(rough.angle)


def test_snap_is_reported():
    arch = bend(Rod.straight(1.0, samples=201), end=(0.9, 0.0))
    turned = bend(arch, angles=(-0.9, 0.9))
    assert stability(turned).stable
    assert "snaps" in turned.warnings[0]
    assert turned.position[100, 1] < 0


@pytest.mark.campaign
def test_a_hardening_rod_snaps_on_any_number_of_nodes():
    """The jump begins with a kink at a clamp, all the stiffer the finer the nodes. Steps by hand leap there too."""
    law = PolynomialLaw(0.085, 0.1, curvature_scale=0.05)
    profile = Profile.interpolate([0.0, 31.187, 62.374], [1.463, 1.188, 2.576])
    margins = []
    for samples in (151, 301):
        rod = Rod.straight(62.374, profile, samples=samples, law=law)
        rod = bend(rod, end=(50.85, 2.56), angles=(0.1184, 0.9364), side=1)
        assert "the strip snaps into another shape after 62" in rod.warnings[0]
        margins.append(stability(rod).margin)
    assert margins[0] == pytest.approx(margins[1], rel=1e-3)


def test_path_gives_a_family_with_reactions():
    ends = np.column_stack([np.linspace(0.95, 0.5, 10), np.linspace(0.0, 0.2, 10)])
    rods = bend_path(Rod.straight(1.0, samples=101), ends, side=-1)
    assert [tuple(rod.position[-1].round(9)) for rod in rods] == [tuple(end.round(9)) for end in ends]
    assert all(rod.position[50, 1] < 0.1 for rod in rods)
    assert all(np.hypot(*rod.force[0]) > 1 for rod in rods)
    twisted = bend_path(rods[-1], [{"angles": (0.1, 0.0)}, {"angles": (0.2, 0.0), "end": (0.6, 0.2)}])
    assert twisted[-1].angle[0] == pytest.approx(0.2)


def test_weight_laws_in_newtons():
    """A lamp of 20 g at the tip, nothing else: the dead load of Mattiasson's table at P L^2 / B = 2."""
    B = 20e-3 * 9.80665 * 100.0**2 / 2
    weight = Weight(masses=(PointMass(100.0, 20.0),))
    rod = Rod.straight(
        100.0, samples=801, supports=CANTILEVER, gravity=Gravity(1.0), weight=weight, bending_stiffness=B
    )
    bent = bend(rod)
    assert -bent.position[-1, 1] / 100 == pytest.approx(0.493457, abs=2e-6)


def test_samples_change_and_guess():
    arch = bend(Rod.straight(1.0, [1.0, 2.0], samples=101), end=(0.6, 0.0))
    fine = bend(arch, samples=401)
    assert fine.s.size == 401
    assert fine.position[::4] == pytest.approx(arch.position, abs=2e-4)
    assert fine.stiffness.min() == 1.0
    down = bend(arch, guess=-arch.angle)
    assert down.position == pytest.approx(arch.position * [1, -1], abs=1e-8)
    assert bend(Rod.straight(1.0, [1.0, 2.0], samples=201), end=(0.6, 0.0), guess=down).position[100, 1] < 0


def test_new_stiffness_bends_again():
    arch = bend(Rod.straight(1.0, samples=201), end=(0.6, 0.0))
    changed = arch.with_stiffness(1 + arch.s)
    again = bend(changed)
    assert again.residual < 1e-10
    assert np.abs(again.position - arch.position).max() > 1e-3


STRAIGHT = Rod.straight(100.0, samples=51)
BAD = {
    "neither elements nor keep": (STRAIGHT, {"end": (90.0, 0.0), "between": "kept"}, "between"),
    "farther apart": (STRAIGHT, {"end": (120.0, 0.0)}, r"120 mm apart.*100 mm long"),
    "taut": (STRAIGHT, {"angles": (0.5, 0.5)}, "as far apart as the rod is long"),
    "taut and heavy": (STRAIGHT, {"gravity": Gravity(96.0)}, "as far apart as the rod is long"),
    "one number": (STRAIGHT, {"end": 3.0}, "end cannot be .*: give two finite numbers"),
    "nan": (STRAIGHT, {"start": (np.nan, 0.0)}, "start cannot be .*: give two finite numbers"),
    "three angles": (STRAIGHT, {"angles": (0.0, 1.0, 2.0)}, "angles are .*: give two numbers"),
    "infinite angle": (STRAIGHT, {"angles": (0.0, np.inf)}, "angles are .*: give finite numbers"),
    "angle of a pin": (
        STRAIGHT, {"angles": (0.0, 1.0), "supports": Supports("clamped", "pinned")}, "leaves the angle free"
    ),
    "useless force": (STRAIGHT, {"force": (1.0, 0.0)}, "both ends are held along x"),
    "useless moment": (STRAIGHT, {"moment": 1.0}, "the support holds the angle"),
    "which moment": (STRAIGHT, {"moment": 1.0, "supports": Supports("pinned", "pinned")}, "give both moments"),
    "moment shape": (STRAIGHT, {"moment": (1.0, 2.0, 3.0)}, "one number or two"),
    "gravity": (STRAIGHT, {"gravity": 9.81}, "Gravity record"),
    "side": (STRAIGHT, {"side": 2}, "side is 2: give"),
    "mode": (STRAIGHT, {"mode": 0}, "mode is .*: give a whole number"),
    "guess": (STRAIGHT, {"guess": [0.0, 1.0], "end": (60.0, 0.0)}, "`guess` has the shape"),
    "samples": (STRAIGHT, {"samples": 2}, "samples is 2: give a whole number, 4 or more"),
    "unloaded column": (
        Rod.straight(1.0, samples=51, supports=CANTILEVER), {"force": (-1.0, 0.0), "side": 1}, "too small"
    ),
}  # fmt: skip


@pytest.mark.parametrize("start", ["clamped", "pinned"])
def test_taut_along_the_one_coordinate_that_both_ends_hold(start):
    """Free to slide across, but as far apart along as the rod is long: only a straight rod fits."""
    taut = bend(Rod.straight(100.0, samples=61), supports=Supports(start, "slide-y"))
    assert np.ptp(taut.position[:, 1]) < 1e-9
    assert stability(taut).stable
    with pytest.raises(InputError, match="as far apart as the rod is long"):
        bend(taut, gravity=Gravity(70.0))
    assert bend(taut, end=(99.9, 0.0), gravity=Gravity(70.0)).residual < 1e-9


@pytest.mark.parametrize("name", BAD)
def test_bad_input_is_one_sentence(name):
    rod, options, message = BAD[name]
    with pytest.raises(InputError, match=message) as raised:
        bend(rod, **options)
    assert isinstance(raised.value, ValueError)
    assert "\n" not in str(raised.value)


def test_bad_paths():
    for path, message in (
        ([(1.0, 2.0, 3.0)], "shape"),
        ([{"ends": (1.0, 2.0)}], "unknown entry 'ends'"),
        ("nonsense", "the path cannot be read: give a sequence of"),
    ):
        with pytest.raises(InputError, match=message):
            bend_path(STRAIGHT, path)


def test_a_slack_of_rounding_size_has_a_shape():
    """A slack of 1e-9 of the length moves the middle by 2 sqrt(1e-9) / pi of it."""
    bent = bend(Rod.straight(1.0, samples=201), end=(1 - 1e-9, 0.0))
    assert bent.position[:, 1].max() == pytest.approx(2e-9**0.5 * 2**0.5 / np.pi, rel=1e-3)


def test_the_force_at_a_snap_does_not_depend_on_the_end_of_the_path():
    """An arch whose end slides across has gone up or down before it is pushed, and snaps at 10.246 E I / L^2."""
    arch = bend(Rod.straight(100.0, samples=201), end=(95, 0), side=1)
    slides = Supports(end=End(x=True, y=False, angle=True))
    up = bend(arch, supports=slides, force=(0, 1e-4))
    pushed = [bend(up, force=(0, -size / 1e4)) for size in (16, 20, 40)]
    shares = [snap_percent(rod) / 100 for rod in pushed]
    forces = [share * (size + 1) - 1 for size, share in zip((16, 20, 40), shares, strict=True)]
    stepped = bend_path(up, [{"force": (0, -size / 1e4)} for size in np.arange(0.0, 12.0, 0.25)])
    first = next(k for k, rod in enumerate(stepped) if rod.position[-1, 1] < 0)
    assert forces == pytest.approx([forces[0]] * 3, rel=1e-3)
    assert 0.25 * (first - 1) < forces[0] < 0.25 * first


@pytest.mark.parametrize("places", [(0.0, 300.0), (0.0, 299.9), (0.4, 299.5), (1.0, 298.4), (5.0, 290.0)])
def test_the_cord_of_a_free_strip_balances_alone_near_its_ends(places):
    bow = bend(
        Rod.straight(300.0, samples=201), supports=Supports("free", "free"), side=1,
        between=Tie(*places, length=250.0),
    )  # fmt: skip
    pull = np.hypot(*bow.between_forces[0])
    assert pull > 0
    assert bow.support_forces == pytest.approx(np.zeros((2, 2)), abs=1e-6 * pull)


@pytest.mark.parametrize("at", [300.0, 299.9, 298.9, 290.0])
def test_a_force_at_a_free_end_is_carried_by_the_other_end(at):
    beam = replace(Rod.straight(300.0, samples=201), bending_stiffness=1e5)
    held = bend(beam, supports=Supports("clamped", "free"), loads=PointForce(at, (0.0, -0.3)))
    forces = 1e5 * held.support_forces
    assert forces == pytest.approx(np.array([(0.0, 0.3), (0.0, 0.0)]), abs=1e-8)
    x = np.interp(at, held.s, held.position[:, 0])
    assert 1e5 * held.moment[0] == pytest.approx(-0.3 * x, rel=1e-3)
