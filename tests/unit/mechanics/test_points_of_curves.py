"""Verdicts on points that were sampled from curves, against the verdicts on those curves."""

import json
import re
from dataclasses import asdict

import numpy as np
import pytest

from elastica_cad import InputError, NotRealizable, PlaneCurve, check_equilibrium, optimal_rod, read_curves
from elastica_cad.design import report_check
from elastica_cad.formats.chains import curve_from_points
from elastica_cad.geometry.measured_points import MeasuredPoints

pytestmark = pytest.mark.core

UNDECIDED = "The points are too few or too inexact to decide whether a strip can take the curve"


def drawn(rng):
    """A curve over 4 to 7 control points of random height, across 100 to 400 mm."""
    count = int(rng.integers(4, 8))
    x = np.linspace(0, rng.uniform(100, 400), count) + rng.normal(0, 5, count)
    y = rng.normal(0, rng.uniform(20, 80), count)
    degree = int(rng.integers(3, 6)) if count > 5 else 3
    return PlaneCurve.spline(np.column_stack([x, y]), degree=degree)


def sampled(heights, count=30, step=60.0, degree=4):
    """Points with 4 decimals on the curve over control points of these heights."""
    control = np.column_stack([step * np.arange(len(heights)), heights])
    return PlaneCurve.spline(control, degree=degree).sample(count).position.round(4)


CAN, CANNOT = (-10, -40, 8, -19, 26), (-42, 7, -22, -2, 13)
"""Heights of curves on the border: of the curves fitted to 30 points the first can be bent, the second not."""


@pytest.mark.campaign
@pytest.mark.parametrize("seed", [64, 65, 66])
def test_no_verdict_from_points_contradicts_that_on_the_curve(seed):
    """Of 150 curves; at most a tenth of the verdicts is undecided."""
    rng, undecided = np.random.default_rng(seed), 0
    for _ in range(150):
        curve = drawn(rng)
        points = curve.sample(int(rng.choice([60, 100, 150]))).position.round(int(rng.integers(2, 7)))
        check = check_equilibrium(PlaneCurve.fit(points))
        undecided += check.undecided is not None
        assert check.undecided or check.realizable == check_equilibrium(curve).realizable
    assert undecided <= 15


@pytest.mark.parametrize("heights", [CAN, CANNOT])
def test_both_numbers_are_in_every_form_of_an_undecided_verdict(heights):
    check = check_equilibrium(PlaneCurve.fit(sampled(heights)))
    found = check.undecided
    can, cannot = (found.fit, found.other) if heights == CAN else (found.other, found.fit)
    assert (can.realizable, cannot.realizable, cannot.inflections) == (True, False, 2)
    assert can.inflections < 2
    assert max(can.distance, cannot.distance) < 0.05
    assert str(check).startswith(UNDECIDED)
    assert check.details[0].startswith("The points are exact to 0.001 mm only. ")
    assert {int(one) for one in re.findall(r"inflections: (\d)", check.details[0])} == {can.inflections, 2}
    answer = json.loads(json.dumps(report_check(check)))["undecided"]
    assert answer["other"] == asdict(found.other)
    assert check.as_dict()["undecided"] == answer
    assert "<b>undecided</b>" in check._repr_html_()
    assert repr(check).startswith("<EquilibriumCheck undecided")


def test_a_rod_of_undecided_points_is_warned_of():
    rod = optimal_rod(PlaneCurve.fit(sampled(CAN)))
    assert UNDECIDED in rod.warnings[0]
    with pytest.raises(NotRealizable, match=UNDECIDED) as refused:
        optimal_rod(PlaneCurve.fit(sampled(CANNOT)))
    assert refused.value.details == refused.value.check.details


SHARP = [
    ([(4, -1), (31, -64), (44, -39), (75, -19), (102, -3), (126, -19), (151, -102)], 3),
    ([(3, 22), (23, -111), (42, -38), (78, -15), (96, 146), (128, 52)], 4),
]
"""Curves with one inflection and bends that 20 points cannot follow."""


@pytest.mark.parametrize(("control", "degree"), SHARP)
def test_inflections_that_the_points_do_not_require_refuse_no_curve(control, degree):
    curve = PlaneCurve.spline(control, degree=degree)
    assert check_equilibrium(curve).realizable
    points = curve.sample(20).position.round(4)
    assert MeasuredPoints.of(points).bend_changes == 1
    check = check_equilibrium(PlaneCurve.fit(points))
    found = check.undecided
    assert (found.fit.realizable, found.other.realizable) == (False, False)
    assert found.fit.inflections >= found.other.inflections + 2
    assert (
        f"has {found.fit.inflections} inflections; another curve that fits them too has" in check.details[0]
    )


def test_a_corner_where_the_points_also_begin():
    lap = [(x, 0.02 * x * (90 - x)) for x in range(0, 91, 5)]
    curve = curve_from_points(np.array(10 * lap))
    with pytest.raises(InputError, match="has corners"):
        check_equilibrium(curve)


def test_required_inflections_are_decided():
    x = np.linspace(0, 660, 30)
    points = np.column_stack([x, 20 * np.sin(x / 60) + x**2 / 5000]).round(3)
    assert MeasuredPoints.of(points).bend_changes == 3
    check = check_equilibrium(PlaneCurve.fit(points))
    assert not check.realizable
    assert check.undecided is None


@pytest.mark.parametrize("count", [20, 60, 300])
def test_a_clear_curve_is_decided(count):
    x = np.linspace(0, 400, count)
    points = np.column_stack([x, 40 * np.sin(x / 70)]).round(3)
    assert check_equilibrium(PlaneCurve.fit(points)).undecided is None
    assert check_equilibrium(PlaneCurve.fit(points[:, :1] * (1.0, 0.5))).undecided is None


def test_a_spline_through_few_points_does_not_oscillate():
    """Of degree 4 with a knot at each point it had 9 inflections."""
    points = sampled((-62, -13, 19, -8, 44, -22, 18), 20, 30.0, 3)
    assert len(PlaneCurve.fit(points, tolerance=1e-6).inflections) == 3


def test_a_bend_of_few_points_is_no_corner_for_sure(tmp_path):
    """Its points turn by 60 degrees, and by 20 beside that; those of a corner between straight lines do not."""
    turns = np.radians([0, 0, 0, 0, 2, 20, 60, 20, 2, 0, 0, 0])
    heading = np.cumsum(turns)
    bend = np.cumsum(10 * np.column_stack([np.cos(heading), np.sin(heading)]), axis=0)
    sharp = np.array([(0, 0), (10, 0), (20, 0), (30, 0), (30, 10), (30, 20), (30, 30.0)])
    message = "the points turn by 60 degrees at .*, but are too few to distinguish a corner from a tight bend"
    with pytest.raises(ValueError, match=message):
        check_equilibrium(curve_from_points(bend))
    with pytest.raises(ValueError, match="the curve has a corner 30 mm from its start"):
        check_equilibrium(curve_from_points(sharp))
    file = tmp_path / "bend.csv"
    np.savetxt(file, bend, "%.3f", ",")
    with pytest.raises(ValueError, match=message):
        check_equilibrium(read_curves(file)[0])


def test_the_place_of_several_corners_is_that_of_the_sharpest():
    corners = np.array([(0, 0), (30, 0), (60, 3), (90, 3), (90, 33.0)])
    points = np.insert(corners, range(1, 5), (corners[:-1] + corners[1:]) / 2, axis=0)
    curve = PlaneCurve(np.repeat(np.arange(5), [3, 2, 2, 2, 3]), points, 2)
    with pytest.raises(ValueError, match=r"The sharpest, of 90 degrees, is at \(90, 3\) mm"):
        check_equilibrium(curve)
