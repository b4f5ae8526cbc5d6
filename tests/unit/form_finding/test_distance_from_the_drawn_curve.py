"""The distance of a nearest rod from a curve that was smoothed first."""

import pytest
from scipy.spatial import cKDTree

import elastica_cad as ec
from elastica_cad.errors import Change
from elastica_cad.form_finding.rod_solution import solve_rod
from elastica_cad.strip.strip_spec import StripSpec

POINTS = [(0, 0), (60, 90), (120, -40), (190, 70), (250, 20), (300, 60)]


@pytest.mark.parametrize("sheet", ["pom-0.5", "spring-steel-0.5"])
def test_it_is_that_from_the_curve_as_drawn(sheet):
    curve = ec.PlaneCurve.spline(POINTS, degree=3)
    spec = StripSpec(curve, sheet, max_width=30).with_change(Change("nearest", True))
    assert spec.rod_spec.smoothing.moved > 0.01
    near = solve_rod(spec.rod_spec)
    drawn = curve.sample(40001).position
    rod = ec.PlaneCurve.fit(near.rod.position, degree=4, tolerance=1e-4).sample(40001).position
    farthest = max(cKDTree(a).query(b)[0].max() for a, b in ((drawn, rod), (rod, drawn)))
    assert near.deviation == pytest.approx(farthest, abs=5e-3)
