"""The record of stability, and where stable rods are lost."""

from dataclasses import replace

import numpy as np
import pytest

from elastica_cad import (
    Gravity,
    InputError,
    NotConvergedError,
    PointForce,
    PointMass,
    Rod,
    Supports,
    Weight,
    bend,
    stability,
    stability_limit,
)

pytestmark = pytest.mark.core


def test_straight_rods_have_dependent_constraints():
    for angle in (0.0, 0.7, np.pi / 2):
        found = stability(Rod.straight(50.0, angle=angle))
        assert found.stable
        assert found.margin == pytest.approx(4 * np.pi**2, rel=1e-4)
        assert found.conjugate_point is None


def test_it_is_shown_in_a_line():
    """Without the hundreds of numbers of its mode and determinant."""
    assert len(repr(stability(Rod.straight(100.0)))) < 200


@pytest.mark.parametrize("angle", [0.0, np.pi / 2, -np.pi / 2, np.pi, 2 * np.pi])
def test_a_straight_rod_whose_end_slides_across_it_sways(angle):
    """A margin of pi^2, whatever rounding leaves of the cosine of a right angle: held in both it would be four."""
    across = "slide-y" if abs(np.cos(angle)) > 0.5 else "slide-x"
    along = np.array([np.cos(angle), np.sin(angle)])
    rod = Rod.straight(100.0, angle=angle, start=(50.0, 70.0), supports=Supports("clamped", across))
    found = stability(rod)
    assert found.margin == pytest.approx(np.pi**2, rel=1e-5)
    assert found.stable
    pushed = bend(rod, end=rod.position[0] + 70.0 * along)
    assert stability(pushed).stable
    swayed = np.hypot(*(pushed.position[-1] - pushed.position[0] - 70.0 * along))
    assert swayed == pytest.approx(62.86, abs=0.01)


@pytest.mark.parametrize("taper", [1.0, np.linspace(1.0, 3.0, 201)])
def test_a_straight_rod_between_hinges_rests(taper):
    """Its turn as a whole costs nothing, and its ends do not allow it: 9.87 for an even one."""
    rod = Rod.straight(100.0, taper, angle=0.4, supports=Supports("pinned", "pinned"))
    found = stability(rod)
    assert found.stable
    assert found.negative == 0
    if np.ndim(taper) == 0:
        assert found.margin == pytest.approx(np.pi**2, rel=1e-4)


@pytest.mark.parametrize(("pressure", "negative"), [(39.0, 0), (40.0, 1), (85.0, 2), (160.0, 3)])
def test_straight_strut_under_pressure(pressure, negative):
    """Clamped buckling loads 39.48, 80.76, 157.9 (pi^2 times 4, 8.18, 16)."""
    rod = replace(Rod.straight(1.0, samples=401), force=np.tile([pressure, 0.0], (401, 1)))
    found = stability(rod)
    assert found.negative == negative
    assert found.stable is (negative == 0)


def test_record_of_an_unstable_rod():
    rod = bend(Rod.straight(100.0, samples=201), end=(70.0, 0.0), mode=2)
    found = stability(rod)
    assert not found.stable
    assert not found.borderline
    assert found.mode.shape == (201,)
    assert np.abs(found.mode).max() == 1.0
    assert found.mode[[0, -1]] == pytest.approx([0.0, 0.0])
    assert 0 < found.conjugate_point < 100
    assert found.determinant.shape == found.determinant_s.shape == (201,)
    i = int(np.searchsorted(found.determinant_s, found.conjugate_point))
    assert found.determinant[i - 2] * found.determinant[i + 1] < 0


def test_conjugate_point_from_the_other_end_when_only_the_start_is_clamped():
    supports = Supports("clamped", "pinned")
    rod = bend(Rod.straight(1.0, samples=301, supports=supports), end=(0.7, 0.0), mode=2)
    found = stability(rod)
    assert found.started_from == "end"
    assert found.negative == 1
    mirrored = bend(Rod.straight(1.0, samples=301, supports=supports.reversed()), end=(0.7, 0.0), mode=2)
    twin = stability(mirrored)
    assert twin.started_from == "start"
    assert twin.conjugate_point == pytest.approx(1 - found.conjugate_point, abs=1e-6)


def test_pinned_ends_have_no_conjugate_point_to_speak_of():
    rod = bend(Rod.straight(1.0, samples=101, supports=Supports("pinned", "pinned")), end=(0.7, 0.0), mode=2)
    found = stability(rod)
    assert found.started_from is None
    assert found.conjugate_point is None
    assert found.determinant.size == 0
    assert not found.stable


def test_unbent_rods_are_refused():
    rod = bend(Rod.straight(1.0, samples=101), end=(0.7, 0.0)).with_stiffness(np.linspace(1, 5, 101))
    with pytest.raises(InputError, match="pass the result of `bend`"):
        stability(rod)


def test_heavy_tension_does_not_upset_the_determinant():
    """Pulled hard, the Jacobi fields grow by e^50 and Z drowns in rounding: the verdict stands."""
    rod = Rod.straight(1.0, samples=401, supports=Supports("clamped", "free"))
    found = stability(bend(rod, gravity=Gravity(0.07)))
    assert found.stable


def test_margin_falls_with_weight_on_top():
    arch = bend(Rod.straight(1.0, samples=201), end=(0.9, 0.0))
    margins = [stability(bend(arch, gravity=Gravity(q ** (-1 / 3)))).margin for q in (1.0, 10.0, 40.0)]
    assert margins[0] > margins[1] > margins[2] > 0


class TestLimits:
    def test_a_lopsided_arch_snaps_through_under_a_lamp(self):
        rod = Rod.straight(
            100.0, samples=201, gravity=Gravity(1.0), weight=Weight(masses=(PointMass(45.0, 1.0),)),
            bending_stiffness=500.0,
        )  # fmt: skip
        arch = bend(rod, end=(90.0, 0.0))
        limit = stability_limit(arch, [200.0])
        assert limit.kind == "snap"
        assert stability(limit.before).margin == pytest.approx(0.0, abs=0.05)
        assert limit.before.residual < 1e-9
        assert stability(limit.after).stable
        assert limit.after.position[100, 1] < 0 < limit.before.position[100, 1]
        near = replace(rod, weight=Weight(masses=(PointMass(45.0, 0.999 * limit.at["load"]),)))
        held = bend(near, end=(90.0, 0.0), guess=limit.before)
        assert not held.warnings
        assert stability(held).stable

    def test_turning_both_clamps_of_an_arch(self):
        arch = bend(Rod.straight(1.0, samples=201), end=(0.9, 0.0))
        limit = stability_limit(arch, [{"angles": (-1.0, 1.0)}])
        assert limit.kind == "bifurcation"
        assert limit.at["angles"] == pytest.approx((-limit.parameter, limit.parameter), rel=1e-5)
        assert stability(limit.before).stable
        assert np.all(np.diff(limit.parameters) >= 0)
        assert limit.margins[0] == pytest.approx(stability(arch).margin)

    @pytest.mark.parametrize("nodes", [21, 1601])
    def test_turning_one_clamp_of_an_arch_comes_to_a_fold(self, nodes):
        """Continuation by arc length with an integrator of scipy has the fold at 0.565 rad, with any nodes."""
        arch = bend(Rod.straight(100.0, samples=nodes), end=(90.0, 0.0))
        limit = stability_limit(arch, [{"angles": (0.0, 3.0)}])
        assert limit.kind == "snap"
        assert limit.at["angles"][1] == pytest.approx(0.565, rel=0.025)

    def test_load_factors_begin_at_the_load_that_the_rod_carries(self):
        """A column of its own weight, 1 / 1.3 of the one that buckles it: w L^3 / (E I) = 7.837."""
        column = Rod.straight(
            100.0, angle=np.pi / 2, supports=Supports("clamped", "free"),
            gravity=Gravity(100.0 * (1.3 / 7.837) ** (1 / 3)),
        )  # fmt: skip
        standing = bend(column)
        limit = stability_limit(standing, [2.0])
        assert limit.at["load"] == pytest.approx(1.3, rel=1e-3)
        assert limit.parameter == pytest.approx(0.3, abs=2e-3)
        assert limit.margins[0] == pytest.approx(stability(standing).margin)

    def test_stable_all_along(self):
        arch = bend(Rod.straight(1.0, samples=101), end=(0.9, 0.0))
        limit = stability_limit(arch, [(0.8, 0.0), (0.6, 0.1), (0.3, 0.1)])
        assert limit.parameter is None
        assert limit.kind is None
        assert limit.before.position[-1] == pytest.approx([0.3, 0.1])
        assert set(np.round(limit.parameters, 9)) >= {0.0, 1.0, 2.0, 3.0}

    def test_a_moment_on_the_free_end_bends_a_cantilever_to_an_arc(self):
        """A single number is the moment on the last end: over a stiffness of 1 that is its curvature."""
        held = Rod.straight(100.0, supports=Supports("clamped", "free"))
        limit = stability_limit(held, [{"moment": 0.05}])
        assert limit.kind is None
        assert limit.at["moment"] == pytest.approx((0.0, 0.05))
        assert limit.before.curvature == pytest.approx(np.full(held.s.size, 0.05), abs=1e-9)
        twice = stability_limit(limit.before, [2.0])
        assert twice.before.curvature == pytest.approx(np.full(held.s.size, 0.1), abs=1e-9)

    def test_unstable_from_the_start(self):
        rod = bend(Rod.straight(1.0, samples=101), end=(0.9, 0.0), mode=2)
        with pytest.raises(InputError, match="unstable at the start"):
            stability_limit(rod, [(0.5, 0.0)])

    def test_bad_paths(self):
        arch = bend(Rod.straight(1.0, samples=101), end=(0.9, 0.0))
        for path, message in (
            ([2.0], "the rod has no load"),
            ([(1.0, 2.0, 3.0)], "shape"),
            ([{"supports": Supports()}], "`supports` cannot change"),
            ([-1.0], "a load factor is -1.0: give a finite number, 0 or more"),
            ([{"load": -1.0}], "a load factor is -1.0"),
            ([(1.3, 0.0)], "apart"),
        ):
            with pytest.raises((InputError, NotConvergedError), match=message):
                stability_limit(arch, path)


@pytest.mark.parametrize(("share", "rating"), [(0.0, "stable"), (0.35, "stable"), (0.8, "close to snapping")])
def test_a_column_is_close_to_snapping_only_near_its_buckling_load(share, rating):
    """Its margin without a load is pi^2 / 4, below the limit of 5 of other strips."""
    column = Rod.straight(240.0, bending_stiffness=900.0, angle=np.pi / 2)
    push = share * np.pi**2 / 4 * 900.0 / 240.0**2
    rest = bend(column, supports=Supports("clamped", "free"), loads=PointForce(240.0, (0.0, -push)))
    assert stability(rest).margin == pytest.approx((1 - share) * np.pi**2 / 4, rel=1e-4)
    assert stability(rest).rating == rating


def test_hinged_ends_that_nearly_meet_are_close_to_snapping():
    rest = bend(Rod.straight(240.0), end=(16.0, 0.0), supports=Supports("pinned", "pinned"))
    assert 0 < stability(rest).margin < 2
    assert stability(rest).rating == "close to snapping"
