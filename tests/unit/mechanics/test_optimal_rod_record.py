"""The record that optimal_rod returns, its options, and weight in newtons against an initial-value solver."""

from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from elastica_cad import (
    Gravity,
    InputError,
    NotRealizable,
    PlaneCurve,
    PointMass,
    Profile,
    Rod,
    Supports,
    Weight,
    bend,
    check_equilibrium,
    optimal_rod,
)
from elastica_cad.mechanics.loads import STANDARD_GRAVITY_M_S2
from elastica_cad.mechanics.rod import DEFAULT_SAMPLES

pytestmark = pytest.mark.core

ELLIPSE = PlaneCurve.ellipse((0, 0), (200, 100), 0.2, 0.1, np.pi - 0.5)
WAVE = PlaneCurve.spline([(0, 0), (30, 40), (60, 5), (90, -40), (130, 0)])
ARCH = PlaneCurve.spline([(0, 0), (20, 30), (40, 60), (100, 60), (120, 30), (140, 0)])
OVERHANG = PlaneCurve.spline([(0, 0), (40, 0), (80, -10), (110, -30), (140, -50)])
LEANING = Gravity(96.0, (0.2, -1.0))


def arcs(*parts):
    """Arcs (radius, angle) joined smoothly, as one rational quadratic."""
    p, theta = np.zeros(2), 0.0
    points, weights, knots = [p], [1.0], [0.0] * 3
    for i, (radius, angle) in enumerate(parts):
        middle = p + radius * np.tan(angle / 2) * np.array([np.cos(theta), np.sin(theta)])
        theta += angle
        p = middle + radius * np.tan(angle / 2) * np.array([np.cos(theta), np.sin(theta)])
        points += [middle, p]
        weights += [np.cos(angle / 2), 1.0]
        knots += [i + 1.0] * 2
    return PlaneCurve(np.array([*knots, knots[-1]]), np.array(points), 2, np.array(weights))


def marched(rod):
    """Distance from the drawn curve, in lengths, of the shape integrated from the first end's values.

    With e up, M' = <b, gamma'> and b' = -(weight per length / B) R^t e; a point mass takes its weight off b.
    Returns the force b behind the last end too.
    """
    up = -np.array(rod.gravity.direction)
    turned = np.array([up[1], -up[0]])
    weight, B = rod.weight, rod.bending_stiffness

    def along(value, s):
        return value(s) if isinstance(value, Profile) else value

    def load(s):
        K = rod.profile(s)
        if weight is None:
            return K / rod.gravity.length**3
        return (along(weight.alpha, s) + along(weight.beta, s) * K) / B

    def rhs(s, y):
        c, sn = np.cos(y[2]), np.sin(y[2])
        moment = y[4] * c + y[5] * sn
        return [c, sn, y[3] / rod.profile(s) + rod.natural_curvature, moment, *(-load(s) * turned)]

    masses = () if weight is None else weight.masses
    y = np.array([*rod.position[0], rod.angle[0], rod.moment[0], rod.force[0, 1], -rod.force[0, 0]])
    worst, stops = 0.0, sorted({0.0, rod.length, *(m.at for m in masses)})
    for start, end in pairwise(stops):
        inside = (rod.s >= start) & (rod.s <= end)
        ask = np.append(rod.s[inside & (rod.s < end)], end)
        path = solve_ivp(rhs, (start, end), y, "DOP853", ask, rtol=1e-9, atol=1e-11, max_step=rod.length / 40)
        miss = path.y[:2, :-1].T - rod.position[inside & (rod.s < end)]
        worst = max(worst, np.hypot(*miss.T).max(initial=0.0))
        y = path.y[:, -1].copy()
        for mass in masses:
            if mass.at == end:
                y[4:] -= mass.mass * 1e-3 * STANDARD_GRAVITY_M_S2 / B * turned
    return max(worst, np.hypot(*(y[:2] - rod.position[-1]))) / rod.length, y[4:]


class TestRecord:
    @pytest.mark.parametrize("gravity", [None, LEANING])
    def test_nodes(self, gravity):
        rod = optimal_rod(ELLIPSE, gravity)
        assert rod.s.size == DEFAULT_SAMPLES
        np.testing.assert_allclose(rod.s, np.linspace(0, ELLIPSE.length, rod.s.size), rtol=1e-12)
        drawn = ELLIPSE.sample(rod.s.size)
        np.testing.assert_allclose(rod.position, drawn.position, atol=1e-9)
        np.testing.assert_allclose(rod.curvature, drawn.curvature, rtol=1e-9)
        assert rod.stiffness.min() == 1.0
        np.testing.assert_allclose(rod.stiffness * rod.curvature, rod.moment, rtol=1e-9)
        assert rod.residual < 1e-10
        assert rod.curve is ELLIPSE

    def test_moment_is_force_times_lever(self):
        """M = a + <b, gamma> with lambda = R b."""
        rod = optimal_rod(WAVE)
        b = np.column_stack([rod.force[:, 1], -rod.force[:, 0]])
        assert np.ptp(b, axis=0) == pytest.approx([0, 0], abs=1e-15)
        lever = np.einsum("ni,ni->n", b, rod.position - rod.position[0])
        np.testing.assert_allclose(rod.moment, rod.moment[0] + lever, atol=1e-9 * np.abs(rod.moment).max())
        assert rod.check.line.distance(WAVE.at(WAVE.inflections).position) == pytest.approx(0, abs=1e-9)

    def test_force_grows_by_the_weight(self):
        """lambda' = load: the usual internal force has the other sign."""
        rod = optimal_rod(ELLIPSE, LEANING)
        load = rod.nodal_load
        cells = np.diff(rod.force, axis=0) - (load[1:] + load[:-1]) / 2
        assert np.abs(cells[1:-1]).max() < 1e-4 * np.abs(load).max()

    def test_profile_is_the_stiffness_between_the_nodes(self):
        rod = optimal_rod(WAVE)
        fine = optimal_rod(WAVE, samples=3001)
        scale = fine.stiffness[1500] / rod.profile(fine.s[1500])
        np.testing.assert_allclose(
            rod.profile(fine.s) * scale, fine.stiffness, atol=2e-6 * fine.stiffness.max()
        )
        assert max(rod.profile.extremes) / min(rod.profile.extremes) == pytest.approx(rod.ratio, rel=1e-9)

    @pytest.mark.parametrize("curve", [ELLIPSE, WAVE], ids=["ellipse", "wave"])
    def test_profile_is_light_and_its_extremes_are_exact(self, curve):
        rod = optimal_rod(curve)
        assert rod.profile.coefficients.size < 120
        fine = optimal_rod(curve, samples=20001)
        assert rod.ratio == pytest.approx(fine.stiffness.max() / fine.stiffness.min(), rel=1e-6)
        assert rod.ratio == pytest.approx(rod.stiffness.max(), rel=1e-4)

    def test_stiffness_at_an_inflection_is_the_limit(self):
        rod = optimal_rod(WAVE)
        (s,) = WAVE.inflections
        t = WAVE.parameter(np.array([s]))
        tangent = WAVE.evaluate(t, 1)[0] / np.hypot(*WAVE.evaluate(t, 1)[0])
        b = np.array([rod.force[0, 1], -rod.force[0, 0]])
        assert rod.profile(s) == pytest.approx(b @ tangent / WAVE.curvature_slope_at(t)[0], rel=1e-7)
        near = rod.profile(s + np.array([-1e-6, -1e-9, 0.0, 1e-9, 1e-6]))
        assert np.ptp(near) < 1e-5

    @pytest.mark.parametrize("samples", [2, -5, 2.5, 3.0, "7", np.nan, True])
    def test_samples_that_are_no_number_of_nodes(self, samples):
        with pytest.raises(InputError, match="give a whole number, 3 or more"):
            optimal_rod(ELLIPSE, samples=samples)

    def test_samples_are_the_only_places_judged(self):
        coarse = optimal_rod(ELLIPSE, samples=7)
        assert coarse.s.size == 7
        assert coarse.stiffness.max() < optimal_rod(ELLIPSE).ratio
        assert coarse.ratio >= optimal_rod(ELLIPSE).ratio - 1e-9

    def test_ratio_is_that_of_the_continuous_curve(self):
        rod = optimal_rod(ELLIPSE)
        s = np.linspace(0, ELLIPSE.length, 20001)
        K = rod.profile(s)
        assert K.max() / K.min() == pytest.approx(rod.ratio, rel=1e-7)

    def test_straight_rods(self):
        rod = optimal_rod(PlaneCurve.line((0, 0), (30, 40)))
        assert rod.ratio == 1.0
        assert not rod.moment.any()
        upright = optimal_rod(PlaneCurve.line((0, 0), (0, 100)), Gravity(96.0), samples=51)
        np.testing.assert_allclose(upright.force[:, 1], -upright.s / 96.0**3, atol=1e-15)

    def test_width_steps_where_the_curvature_jumps(self):
        rod = optimal_rod(arcs((100, 1.0), (60, 1.0)))
        assert rod.ratio == pytest.approx(100 / 60, rel=1e-6)
        assert rod.profile(np.array([99.0, 101.0])) == pytest.approx([100 / 60, 1.0], rel=1e-6)
        assert "jumps at 100 mm" in " ".join(rod.warnings)
        # the step is a short ramp, so that the outline stays one edge
        _, repeats = np.unique(rod.profile.knots[4:-4], return_counts=True)
        assert repeats.max() <= 3
        assert rod.profile(100.0) == pytest.approx((1 + 100 / 60) / 2, rel=1e-6)

    @pytest.mark.parametrize("seed", range(6))
    def test_many_steps(self, seed):
        rng = np.random.default_rng(seed)
        curve = PlaneCurve.spline(np.column_stack([np.arange(6) * 30.0, [0, 40, 62, 66, 50, 5 * seed]]), 2)
        curve = PlaneCurve(curve.knots, curve.control_points + rng.normal(size=(6, 2)), 2)
        rod = optimal_rod(curve)
        steps = [b.s for b in curve.breaks if b.continuity < 2]
        away = np.abs(rod.s[:, None] - np.array(steps)).min(axis=1) > 1e-4 * rod.length
        np.testing.assert_allclose(
            rod.profile(rod.s[away]), rod.stiffness[away], atol=2e-6 * rod.stiffness.max()
        )


CASES = {
    "proportional": (ELLIPSE, {}),
    "dead, B given": (ELLIPSE, {"weight": Weight(alpha=1e-3), "bending_stiffness": 2000.0}),
    "dead and own, B given": (ELLIPSE, {"weight": Weight(1e-3, 1e-3), "bending_stiffness": 2000.0}),
    "lamp holder": (ELLIPSE, {
        "weight": Weight(own=True, masses=(PointMass(120.0, 20.0),)), "bending_stiffness": 2000.0,
    }),
    "two lamps, B sought": (ELLIPSE, {
        "weight": Weight(own=True, masses=(PointMass(120.0, 20.0), PointMass(250.0, 10.0))),
    }),
    "dead, B sought": (ELLIPSE, {"weight": Weight(alpha=1e-3)}),
    "own in newtons, B sought": (ELLIPSE, {"weight": Weight(beta=1e-3)}),
    "profile": (ELLIPSE, {
        "weight": Weight(Profile.interpolate([0.0, 100.0, ELLIPSE.length], [1e-3, 2e-3, 1e-3])),
        "bending_stiffness": 3000.0,
    }),
    "inflection": (WAVE, {}),
    "inflection and lamp, B sought": (WAVE, {"weight": Weight(own=True, masses=(PointMass(40.0, 20.0),))}),
    "pinned": (ARCH, {"supports": Supports("pinned", "pinned")}),
    "pinned with lamp": (ARCH, {
        "supports": Supports("pinned", "pinned"), "weight": Weight(1e-3, masses=(PointMass(90.0, 10.0),)),
        "bending_stiffness": 1000.0,
    }),
    "hanging from one end": (OVERHANG, {
        "gravity": Gravity(96.0), "supports": Supports("clamped", "free"),
        "weight": Weight(own=True, masses=(PointMass(OVERHANG.length, 10.0),)),
    }),
    "naturally curved": (ELLIPSE, {"natural_curvature": 0.002}),
}  # fmt: skip


class TestWeight:
    @pytest.mark.parametrize("name", CASES)
    def test_marched_from_one_end_it_follows_the_curve(self, name):
        curve, options = CASES[name]
        rod = optimal_rod(curve, **{"gravity": LEANING, **options})
        assert rod.stiffness.min() == 1.0
        assert rod.residual < 1e-8
        miss, _ = marched(rod)
        assert miss < 1e-6

    def test_a_strip_that_is_the_better_the_stiffer_gives_a_hundredth_of_its_ratio(self):
        arch = PlaneCurve.spline([(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)])
        gravity = Gravity(200.0, (0.6, -0.8))
        light = optimal_rod(arch, gravity)
        rod = optimal_rod(arch, gravity, weight=Weight(2e-4, own=True))
        # on the continuous curve: bounded at samples only, the ratio exceeds it by 4e-5
        assert rod.ratio == pytest.approx(1.01 * light.ratio, rel=1e-8)

    def test_given_bending_stiffness_is_kept(self):
        rod = optimal_rod(ELLIPSE, LEANING, weight=Weight(1e-3, 1e-3), bending_stiffness=2000.0)
        assert rod.bending_stiffness == pytest.approx(2000.0, rel=1e-4)
        assert rod.weight.beta == pytest.approx(1e-3 * rod.bending_stiffness / 2000.0)

    def test_own_weight_in_newtons_is_the_proportional_one(self):
        light = optimal_rod(ELLIPSE, LEANING)
        own = optimal_rod(ELLIPSE, LEANING, weight=Weight(own=True), bending_stiffness=1234.0)
        assert own.ratio == pytest.approx(light.ratio, rel=1e-9)
        assert own.weight.beta == pytest.approx(own.bending_stiffness / 96.0**3)
        assert not own.weight.own
        np.testing.assert_allclose(own.force, light.force, rtol=1e-7)
        np.testing.assert_allclose(own.nodal_load, light.nodal_load, rtol=1e-7)

    def test_free_end_carries_its_mass_only(self):
        curve, options = CASES["hanging from one end"]
        rod = optimal_rod(curve, **options)
        _, behind = marched(rod)
        assert behind == pytest.approx([0, 0], abs=1e-9)

    @pytest.mark.parametrize("supports", [Supports("clamped", "free"), Supports("free", "clamped")])
    def test_free_end_under_its_own_weight_only_is_explained(self, supports):
        """Even a strip that hangs so is no drawing to start from: its end curvature is all but zero."""
        gravity = Gravity(96.0)
        hanging = bend(Rod.straight(100.0, samples=101, gravity=gravity, supports=supports))
        for curve in (hanging.curve, OVERHANG):
            with pytest.raises(NotRealizable, match=r"is free, and near a free end a drawn curve"):
                optimal_rod(curve, gravity, supports)
            with pytest.raises(
                NotRealizable, match="Use nearest_rod for the nearest curve of a hanging strip"
            ):
                optimal_rod(curve, gravity, supports, weight=Weight(1e-3, masses=(PointMass(50.0, 1.0),)))

    def test_own_weight_alone_fixes_the_curvature_at_a_free_end(self):
        """kappa = cos(alpha) u^2 / (2 l^3), whatever the stiffness: what the refusal says."""
        for K in (1.0, np.linspace(3.0, 1.0, 801), np.linspace(1.0, 2.0, 801)):
            rod = Rod.straight(
                100.0, K, samples=801, gravity=Gravity(80.0), supports=Supports("clamped", "free")
            )
            rod = bend(rod)
            u = rod.length - rod.s
            at = (u > 1.0) & (u < 3.0)
            request = -np.cos(rod.angle[-1]) * u**2 / (2 * 80.0**3)
            np.testing.assert_allclose(rod.curvature[at], request[at], rtol=0.04)

    def test_sought_bending_stiffness_is_the_best(self):
        """Neither a stiffer nor a softer strip has a smaller ratio (without the smoothing of section 5.3)."""
        options = {"weight": Weight(own=True, masses=(PointMass(100.0, 30.0),))}
        best = optimal_rod(ELLIPSE, LEANING, **options)
        for factor in (0.7, 0.9, 1.1, 1.4):
            other = optimal_rod(
                ELLIPSE, LEANING, **options, bending_stiffness=best.bending_stiffness * factor
            )
            assert other.ratio >= best.ratio * (1 - 1e-9)

    def test_where_lighter_is_better_the_least_within_a_per_cent(self):
        light = optimal_rod(ELLIPSE).ratio
        for weight in (Weight(alpha=1e-3), Weight(beta=1e-3)):
            rod = optimal_rod(ELLIPSE, LEANING, weight=weight)
            assert rod.ratio == pytest.approx(1.01 * light, rel=1e-4)

    def test_too_heavy_says_where(self):
        with pytest.raises(NotRealizable, match=r"the moment near .* mm would bend") as caught:
            optimal_rod(WAVE, Gravity(9.0))
        assert not caught.value.check.realizable
        assert caught.value.check.zeros

    def test_straight_piece_sags(self):
        with pytest.raises(NotRealizable, match="sags"):
            optimal_rod(PlaneCurve.line((0, 0), (100, 0)), Gravity(96.0))

    def test_third_inflection_is_one_condition_too_many(self):
        x = np.linspace(-1.0, 7.0, 300)
        curve = PlaneCurve.fit(np.column_stack([100 * x, 40 * np.sin(x)]), degree=5, tolerance=1e-3)
        with pytest.raises(NotRealizable, match="cannot be 0 at every inflection"):
            optimal_rod(curve, Gravity(200.0))


class TestBadInput:
    @pytest.mark.parametrize(("options", "message"), [
        ({"samples": 2}, "whole number, 3 or more"),
        ({"weight": Weight(1.0)}, "needs a direction: set gravity too"),
        ({"bending_stiffness": 5.0}, "pass weight"),
        ({"gravity": LEANING, "weight": Weight(1.0), "bending_stiffness": -5.0}, "give a number above 0"),
        ({"gravity": LEANING, "weight": Weight(own=True)}, "it does not determine the bending stiffness"),
        ({"gravity": LEANING, "weight": Weight(masses=(PointMass(1e4, 1.0),))}, "is not on the curve"),
        ({"gravity": LEANING, "weight": Weight(masses=(PointMass(0.0, 9.0),))}, "do not bend .* hang them"),
        ({"gravity": LEANING, "weight": Weight(masses=(PointMass(ELLIPSE.length, 9.0),))}, "do not bend the rod"),
        ({"gravity": LEANING, "weight": Weight(Profile.interpolate([0, 5], [1, 1]))}, "profile is 5 mm long"),
        ({"natural_curvature": np.inf}, "finite number"),
    ])  # fmt: skip
    def test_one_clear_sentence(self, options, message):
        with pytest.raises(InputError, match=message):
            optimal_rod(ELLIPSE, **options)

    def test_not_realizable_carries_the_check(self):
        supports = Supports("pinned", "clamped")
        with pytest.raises(NotRealizable) as caught:
            optimal_rod(ELLIPSE, supports=supports)
        assert caught.value.check.reasons == check_equilibrium(ELLIPSE, supports).reasons


def test_a_mass_on_a_held_end_bends_nothing():
    carried = optimal_rod(ARCH, LEANING, weight=Weight(1e-5))
    hung = optimal_rod(ARCH, LEANING, weight=Weight(1e-5, masses=(PointMass(ARCH.length, 50.0),)))
    assert hung.ratio == pytest.approx(carried.ratio, rel=1e-9)
    assert hung.bending_stiffness == pytest.approx(carried.bending_stiffness, rel=1e-9)


def test_a_rod_says_whether_it_carries_its_weight():
    light, heavy = optimal_rod(ARCH), optimal_rod(ARCH, gravity=LEANING)
    assert repr(light) == f"<Rod of {light.length:.4g} mm, ratio {light.ratio:.4g}, {light.s.size} nodes>"
    assert repr(heavy).endswith(" nodes, with weight>")


@pytest.mark.parametrize(("peak", "end"), [(60, 10), (70, 0)])
def test_where_the_moment_acts_against_the_curvature_is_reported(peak, end):
    """Three inflections leave the moment of a given weight no choice: M0, F x r and the moment of what follows."""
    points = [(0, 0), (30, 60), (60, -60 if end else -50), (90, peak), (120, -60 if end else -50), (150, end)]
    curve = PlaneCurve.spline(points, degree=4)
    with pytest.raises(NotRealizable) as result:
        optimal_rod(curve, Gravity(100.0), weight=Weight(alpha=0.1), bending_stiffness=1e4)
    nodes = curve.sample(4001)
    s, (x, y), step = nodes.s, nodes.position.T, nodes.s[1]

    def following(f):
        return np.append(np.cumsum(((f[1:] + f[:-1]) / 2 * step)[::-1])[::-1], 0.0)

    own = x * following(np.ones_like(x)) - following(x)
    terms = np.column_stack([np.ones_like(x), x, y])
    at = [np.abs(s - zero.s).argmin() for zero in curve.curvature_zeros]
    wrong = (own - terms @ np.linalg.solve(terms[at], own[at])) * nodes.curvature < 0
    wrong[at] = wrong[np.array(at) + 3]
    edges = s[np.flatnonzero(np.diff(np.concatenate([[False], wrong, [False]]).astype(int))).clip(max=4000)]
    (reason,) = result.value.check.reasons
    assert np.concatenate(reason.values["stretches"]) == pytest.approx(edges, abs=0.5)
    assert "-" not in f"{reason.values['stretches']}"


def test_a_turned_drawing_gives_the_same_strip_where_a_step_of_the_curvature_decides():
    """The step alone makes a ratio of 5, whatever the moment: of these strips one is taken, however it is drawn."""
    knots, weights = [0, 0, 0, 0.5, 1, 1, 1], [1.149, 0.2406, 0.5931, 0.2995]
    points = np.array([(151.461, 25.412), (172.261, 80.962), (66.593, 57.153), (3.727, 4.13)])
    rods = []
    for turn in np.linspace(0.0, 6.0, 7):
        c, s = np.cos(turn), np.sin(turn)
        rods.append(optimal_rod(PlaneCurve(knots, points @ [[c, s], [-s, c]], 2, weights)))
    assert rods[0].shape.breaks[0].continuity == 1
    for rod in rods[1:]:
        assert rod.stiffness == pytest.approx(rods[0].stiffness, rel=1e-6)
