"""Long sides of strips where they meet the tabs."""

import numpy as np
import pytest

import elastica_cad as ec
from elastica_cad.geometry.path import Spline

POM = ec.Sheet.named("pom-1")


@pytest.fixture(scope="module", params=range(12))
def curve(request):
    rng = np.random.default_rng(request.param)
    x = np.linspace(0.0, 300.0, 5)
    y = np.concatenate([[0.0], rng.uniform(20.0, 110.0, 3), [rng.uniform(-20.0, 20.0)]])
    return ec.PlaneCurve.spline(np.column_stack([x, y]), degree=3)


def corners(outline):
    """Sine of the turn between each long side and the tab beside it."""
    pairs = zip(outline.segments, [*outline.segments[1:], outline.segments[0]], strict=True)
    turns = []
    for before, after in pairs:
        if isinstance(before, Spline) != isinstance(after, Spline):
            t, u = before.tangent_at(1.0), after.tangent_at(0.0)
            turns.append(abs(float(t[0] * u[1] - t[1] * u[0])))
    return turns


def test_sides_meet_tabs_without_a_slight_corner(curve):
    """CAD kernels fail to chamfer edges that meet at a slight corner."""
    rod = ec.nearest_rod(curve, ec.Limits(ratio=4.0)).rod
    strip = ec.Strip(rod, POM, max_width=24.0)
    assert len(corners(strip.outline)) == 4
    assert all(turn < 1e-7 or turn > 0.14 for turn in corners(strip.outline))


def test_level_ends_change_the_width_little_and_only_there(curve):
    rod = ec.nearest_rod(curve, ec.Limits(ratio=4.0)).rod
    strip, bare = (ec.Strip(rod, POM, max_width=24.0, ends=(tab, tab)) for tab in (ec.Tab(10.0), ec.Tab(0.0)))
    assert strip.width.coefficients == pytest.approx(bare.width.coefficients)
    upper = next(
        part.curve for part in strip.outline.segments if isinstance(part, Spline) and part.start[1] > 0
    )
    points = upper.sample(4001).position
    off = np.abs(points[:, 1] - strip.width(points[:, 0]) / 2)
    assert off.max() < 0.01
    assert off[400:-400].max() < 0.002
    assert len(strip.outline.segments) == len(bare.outline.segments) + 4
