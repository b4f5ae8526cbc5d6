"""Masses hung on a strip of a given width: the least ratio that carries them, by statics and linprog."""

from contextlib import nullcontext
from itertools import cycle, islice

import numpy as np
import pytest
from scipy.optimize import linprog

from elastica_cad import (
    InputError,
    NotRealizable,
    PlaneCurve,
    PointMass,
    Sheet,
    StripSpec,
    Weight,
    bend,
    make_strip,
    optimal_rod,
)
from elastica_cad.form_finding.rod_solution import solve_rod
from elastica_cad.mechanics import ThicknessLaw
from elastica_cad.mechanics.loads import STANDARD_GRAVITY_M_S2

pytestmark = pytest.mark.core

BIRCH = Sheet.named("birch-plywood-0.8")
ARCH = PlaneCurve.fit([(0, 0), (60, 62), (120, 95), (180, 105), (240, 95), (300, 62), (360, 0)])
SKEW = PlaneCurve.fit([(0, 0), (60, 90), (150, 120), (240, 80), (320, 0)])
WIDTH, PLACE = 40.0, 200.0


def ratio_by_statics(curve, grams, most):
    """Least ratio of E I at 4001 places below `most`: moments of a clamped arch with a load, weightless itself."""
    s = np.linspace(0, curve.length, 4001)
    x, y = curve.evaluate(curve.parameter(s)).T
    x_load = float(np.interp(PLACE, s, x))
    newtons = grams * 1e-3 * STANDARD_GRAVITY_M_S2
    kappa = curve.curvature_at(curve.parameter(s))
    free = np.column_stack([np.ones(s.size), x, y]) / kappa[:, None]
    loaded = -newtons * np.maximum(x - x_load, 0.0) / kappa
    # E I = free @ numbers + loaded lies between the least, which is made large, and the most
    rows = np.block([[free, np.zeros((s.size, 1))], [-free, np.ones((s.size, 1))]])
    found = linprog([0, 0, 0, -1], rows, np.concatenate([most - loaded, loaded]), bounds=(None, None))
    assert found.status == 0, found.message
    return most / found.x[3]


@pytest.mark.parametrize(("curve", "grams"), [(ARCH, 16), (ARCH, 97), (ARCH, 150), (SKEW, 16), (SKEW, 56)])
def test_the_least_ratio_that_carries_a_mass_within_a_width(curve, grams):
    most = BIRCH.bending_stiffness(WIDTH)
    weight = Weight(masses=(PointMass(PLACE, grams),), own=False)
    free = optimal_rod(curve, BIRCH.gravity(), weight=weight)
    assert free.bending_stiffness * free.ratio > 1.3 * most, "it asks for more width"
    rod = optimal_rod(curve, BIRCH.gravity(), weight=weight, largest_stiffness=most)
    assert 0.985 * most < rod.bending_stiffness * rod.ratio <= most
    expected = ratio_by_statics(curve, grams, most)
    assert rod.ratio == pytest.approx(expected, rel=5e-3)
    assert rod.ratio > 0.999 * expected
    assert rod.ratio > free.ratio


@pytest.mark.parametrize("curve", [ARCH, SKEW])
def test_a_strip_with_its_mass_comes_to_rest_in_its_curve(curve):
    strip = make_strip(curve, BIRCH, max_width=WIDTH, gravity=True, loads=[PointMass(PLACE, 16)])
    assert strip.width.extremes[1] <= WIDTH
    assert strip.width.extremes[1] > 0.98 * WIDTH
    rod = strip.rod
    rest = bend(rod, start=rod.position[0], end=rod.position[-1])
    assert np.abs(rest.position - rod.position).max() < 0.02


def test_a_mass_that_no_width_carries_is_reported_the_least_that_would():
    """The least width and the least thickness are limits: a little less is refused, too."""
    load = {"gravity": True, "loads": [PointMass(PLACE, 300)]}
    with pytest.raises(InputError, match="No strip between 3 mm and 40 mm wide carries this load") as refused:
        make_strip(ARCH, BIRCH, max_width=WIDTH, **load)
    width, thickness = (change.value for change in refused.value.refusal.changes)
    for share, carried in ((1.0, True), (0.999, False)):
        for sheet, largest in ((BIRCH, share * width), (BIRCH.with_thickness(share * thickness), WIDTH)):
            with nullcontext() if carried else pytest.raises(InputError, match="carries this load"):
                spec = StripSpec(ARCH, sheet, max_width=largest, **load)
                # `make` refuses this strip, because it breaks without its mass
                assert spec.bend(solve_rod(spec.rod_spec)).width.extremes[0] >= 3.0


def test_the_change_of_width_and_thickness_has_the_digits_of_the_message():
    with pytest.raises(InputError) as refused:
        solve_rod(
            StripSpec(ARCH, BIRCH, max_width=WIDTH, gravity=True, loads=[PointMass(PLACE, 300)]).rod_spec
        )
    width, thickness = (change.value for change in refused.value.refusal.changes)
    assert f"Set max_width to {width} mm or more, or use a sheet {thickness} mm thick" in str(refused.value)


@pytest.mark.parametrize("least", [3.0, 7.0])
def test_a_least_width_alone_is_the_width_at_the_narrowest_place(least):
    strip = make_strip(ARCH, BIRCH, min_width=least, gravity=True, loads=[PointMass(PLACE, 1)])
    assert least <= strip.width.extremes[0] < least * (1 + 1e-5)


@pytest.mark.parametrize("given", [0.0, -1.0, np.nan])
def test_a_largest_stiffness_is_positive(given):
    weight = Weight(masses=(PointMass(PLACE, 16),), own=False)
    with pytest.raises(InputError, match=r"largest_stiffness is .*: give a number above 0, in N mm2"):
        optimal_rod(ARCH, BIRCH.gravity(), weight=weight, largest_stiffness=given)
    with pytest.raises(InputError, match="largest_stiffness applies only to rods with a weight in newtons"):
        optimal_rod(ARCH, BIRCH.gravity(), largest_stiffness=100.0)


def test_a_largest_stiffness_beside_what_settles_the_stiffness_is_refused():
    """It had been taken, and ignored."""
    request = {"weight": Weight(masses=(PointMass(PLACE, 16),), own=True), "largest_stiffness": 1e4}
    with pytest.raises(InputError, match="`bending_stiffness` already sets the stiffness"):
        optimal_rod(ARCH, BIRCH.gravity(), bending_stiffness=1e3, **request)
    with pytest.raises(InputError, match="leave out `bending_stiffness`, `largest_stiffness` and `law`"):
        optimal_rod(ARCH, BIRCH.gravity(), section=ThicknessLaw(BIRCH, 2, 8, width=20), **request)


DOWN = (0.3, -1.0)
CARD = Sheet.named("card-200gsm")
DRAWN = PlaneCurve([0, 0, 0, 0, 1, 1, 1, 1], [(20, 20), (20, 140), (220, 140), (220, 20)], 3)
"""The arch of the manual, docs/how_to/carry.md."""


def made(curve, at, grams, width, **fields):
    load = {"gravity": DOWN, "loads": [PointMass(at, grams)], "compensate": False, "ignore_limits": True}
    return make_strip(curve, CARD, max_width=width, **{**load, **fields})


def arches(seed):
    """Curves without an inflection, each with the place of a mass."""
    rng = np.random.default_rng(seed)
    while True:
        x = np.linspace(0, 300, rng.integers(5, 7))
        y = 120 * np.sin(np.pi * x / 300) * rng.uniform(0.6, 1.4, x.size)
        curve = PlaneCurve.spline(np.column_stack([x + rng.uniform(-15, 15, x.size), y]))
        if not len(curve.inflections):
            yield curve, rng.uniform(0.2, 0.8) * curve.length


def waves(seed):
    """S-curves with one inflection each, and a mass at it or beside it."""
    rng = np.random.default_rng(seed)
    beside = cycle([0.0, 0.002, -0.01, 0.3, -1.0, 30.0])
    x = np.linspace(0, 300, 7)
    while True:
        y = rng.uniform(40, 90) * np.sin(2 * np.pi * x / 300) + rng.uniform(-10, 10, x.size)
        curve = PlaneCurve.spline(np.column_stack([x, y]), degree=5)
        if len(curve.inflections) == 1:
            yield curve, float(curve.inflections[0]) + next(beside)


def ratios(curve, at, grams_per_mm, widths):
    """Ratios of strips whose masses are in proportion to their widths; infinite where a wider one is needed."""
    for width in widths:
        try:
            strip = made(curve, at, grams_per_mm * width, width)
        except InputError as refused:
            if refused.refusal.changes[0].value <= width:
                raise
            yield np.inf
            continue
        assert width - 1e-4 * width < strip.width.extremes[1] <= width
        yield strip.rod.ratio


@pytest.mark.parametrize("samples", [51, 201])
def test_few_nodes_do_not_widen_a_strip(samples):
    strip = made(DRAWN, 150.0, 1.0, 30.0, samples=samples)
    assert 30 - 1e-4 < strip.width.extremes[1] <= 30


@pytest.mark.parametrize("kind", [arches, waves])
def test_the_ratio_depends_on_mass_over_width_alone(kind):
    curve, at = next(kind(3))
    narrow, wide = ratios(curve, at, 4e-4, (5.0, 960.0))
    assert wide == pytest.approx(narrow, rel=1e-6)


@pytest.mark.campaign
def test_ratios_of_twenty_curves_depend_on_mass_over_width_alone():
    """From 0.01 g to 10 t and from 5 to 1,000 mm wide; most of the pairs are far too heavy and refused."""
    carried = 0
    for curve, at in (*islice(arches(64), 12), *islice(waves(64), 8)):
        for grams_per_mm in 10.0 ** np.arange(-5, 4.1, 0.5):
            widths = [w for w in (5.0, 13.7, 60.0, 1000.0) if 0.0099 < grams_per_mm * w < 1.01e7]
            found = np.array(list(ratios(curve, at, grams_per_mm, widths)))
            assert np.isinf(found).all() or np.ptp(found) <= 1e-6 * found.min()
            carried += np.isfinite(found).sum()
    assert carried > 250


@pytest.mark.parametrize(
    ("grams", "narrowest"), [(0.01, 20.574), (40, 22.013), (400, 12.553)], ids=["light", "middle", "heavy"]
)
def test_widths_of_the_manual_under_loads_of_any_scale(grams, narrowest):
    """The narrowest place by a linear program on samples, extrapolated from 800, 1,600 and 3,200 of them."""
    for scale in (1, 16):
        load = {"gravity": True, "loads": [PointMass(150, scale * grams)]}
        strip = make_strip(DRAWN, BIRCH, min_width=12 * scale, max_width=30 * scale, **load)
        assert np.array(strip.width.extremes) / scale == pytest.approx([narrowest, 30.0], abs=0.02)


def test_a_narrowest_width_alone_is_kept_under_a_load():
    strip = make_strip(DRAWN, BIRCH, min_width=18, gravity=True, loads=[PointMass(150, 40)])
    assert strip.width.extremes[0] == pytest.approx(18, rel=1e-5)


@pytest.mark.parametrize("apart", [0.0, 1e-6, 1e-3, 0.01, 0.1])
def test_a_mass_next_to_an_inflection_is_carried_as_one_at_it(apart):
    """Within 0.1 mm of it but not at it, no width had been found."""
    curve, at = next(waves(64))
    before, there, after = (made(curve, at + side * apart, 6e-3, 60).rod.ratio for side in (-1, 0, 1))
    assert before <= there * (1 + 1e-9)
    assert after >= there * (1 - 1e-9)
    assert after - before < 0.01 * there


def test_a_curve_that_only_its_load_holds_has_the_widths_of_the_load():
    points = [(0, -33.8), (50, -0.9), (100, -22.9), (150, -29.4), (200, 0.5), (250, 22.8), (300, -16.4)]
    curve = PlaneCurve.spline(points)
    with pytest.raises(NotRealizable):
        optimal_rod(curve, CARD.gravity())
    strip = made(curve, 210.0, 5.0, 600, gravity=True)
    assert 1 < strip.width.extremes[1] < 590
    result = [
        warning for warning in strip.warnings if "The load on the strip determines its width" in warning
    ]
    assert len(result) == 1
    heavier = made(curve, 210.0, 7.5, 600, gravity=True)
    assert heavier.width.extremes[1] == pytest.approx(1.5 * strip.width.extremes[1], rel=1e-6)


def test_an_upright_strip_is_as_wide_as_requested_under_its_load():
    line = PlaneCurve.line((0, 0), (0, 200))
    strip = make_strip(
        line, BIRCH, max_width=20, gravity=True, loads=[PointMass(100, 20)], straight_ends=False
    )
    assert strip.width.extremes == pytest.approx((20, 20))


def test_a_least_stiffness_is_a_limit_beside_the_largest():
    weight = Weight(masses=(PointMass(PLACE, 16),), own=True)
    with pytest.raises(InputError, match="Pass `largest_stiffness`"):
        optimal_rod(ARCH, BIRCH.gravity(), weight=weight, least_stiffness=1e3)
    with pytest.raises(
        InputError, match=r"requires a bending stiffness of .* but largest_stiffness is 1001 N mm2"
    ):
        optimal_rod(ARCH, BIRCH.gravity(), weight=weight, least_stiffness=1e3, largest_stiffness=1001)


def test_a_weight_that_goes_with_the_stiffness_is_carried_within_the_largest():
    most = BIRCH.bending_stiffness(WIDTH)
    light = optimal_rod(ARCH, BIRCH.gravity(), weight=Weight(1e-3), largest_stiffness=most)
    rod = optimal_rod(ARCH, BIRCH.gravity(), weight=Weight(1e-3, 1e-4), largest_stiffness=most)
    same = optimal_rod(ARCH, BIRCH.gravity(), weight=rod.weight, bending_stiffness=rod.bending_stiffness)
    assert rod.bending_stiffness * rod.ratio == pytest.approx(most, rel=1e-5)
    assert same.ratio == pytest.approx(rod.ratio, rel=1e-6)
    assert rod.ratio != pytest.approx(light.ratio, rel=1e-4)
