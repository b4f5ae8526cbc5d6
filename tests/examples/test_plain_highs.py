"""The paper's programs written out give the same ratios as ours, light and heavy."""

import runpy

import pytest

import elastica_cad as ec


@pytest.fixture(scope="module")
def plain(project_root):
    return runpy.run_path(str(project_root / "docs" / "plain_highs.py"))


@pytest.mark.campaign
@pytest.mark.parametrize("gravity", [None, ec.Gravity(90.0), ec.Gravity(150.0, (0.6, -0.8))])
def test_same_ratios(plain, gravity):
    limits = ec.Limits(ratio=2.5, margin=5.0)
    curves = [
        ec.PlaneCurve.spline([(0, 0), (20, 70), (60, 90), (110, 60), (120, 0)]),
        ec.PlaneCurve.spline([(0, 0), (40, 40), (80, -40), (120, 30), (160, 0)]),
    ]
    rods = [near.rod for near in ec.nearest_rods(curves, limits, gravity=gravity)]
    ours, plainly, apart = plain["race"](rods)
    # all meet their rows to some 1e-10 only, which a wave under a slanted weight makes a hundredfold of
    assert apart < 5e-8
    assert min(ours, plainly) > 0
    for rod in rods:
        assert 1 < plain["plain"](*plain["samples"](rod)) <= rod.ratio * (1 + 5e-8)
