"""Every constraint and measure against finite differences."""

from dataclasses import replace
from types import SimpleNamespace

import numpy as np
import pytest

from elastica_cad import Box, HalfPlane, Limits, PlaneCurve, Sheet, Supports
from elastica_cad.form_finding import constraints as kept
from elastica_cad.form_finding import constraints as limits
from elastica_cad.form_finding.curve_distance import (
    LargestDistance,
    MeanDistance,
    TargetCurve,
    measure_deviation,
)
from elastica_cad.form_finding.rod_map import SectionScale, StiffnessBasis, StripGrid
from elastica_cad.mechanics import PlainSection
from elastica_cad.mechanics.laminated_section import LaminatedSection

pytestmark = pytest.mark.core

EDGES = 81
CAST = Sheet("acrylic", 1.0, 3000.0, 1190.0, max_strain=0.2, poisson_ratio=0.37)
GLUED = LaminatedSection(CAST, CAST, 40.0, (0.0, 40.0))


@pytest.fixture(scope="module")
def grid():
    return StripGrid(StiffnessBasis(10).at(np.linspace(0, 1, EDGES + 1)), np.array([2.0, 5.0]))


@pytest.fixture(scope="module")
def z(grid):
    rng = np.random.default_rng(4)
    u = grid.unknowns
    z = np.zeros(u.count)
    z[u.stiffness] = 1 + rng.random(10)
    z[u.moment], z[u.force] = 3.0, (9.0, -12.0)
    z[u.position], z[u.angle], z[u.length] = (0.1, -0.1), 0.4, 1.05
    return z


def derivative(function, z, j, h=1e-5):  # rounding and curvature weigh alike
    e = h * np.eye(z.size)[j]
    return (function(z + e) - function(z - e)) / (2 * h)


def at_nodes(request):
    return [
        limits.AtNodes(active=limit.active, room=limit.room, size=100.0, origin=(1.0, 2.0))
        for limit in request.at_places(strain=False)
    ]


MARGIN = limits.margin_limit(5.0)
CONSTRAINTS = [
    kept.EndPosition(target=(0.5, 0.2)),
    kept.EndAngle(target=0.3),
    kept.EndMoment(scale=2.0),
    kept.EndForce(axis=0, scale=3.0),
    kept.EndForce(axis=1, scale=3.0),
    limits.MarginLimit(active=MARGIN),
    limits.MarginLimit(active=replace(limits.margin_limit(-2.0), name="margin of a rod with a pinned end")),
    *at_nodes(Limits(curvature=0.04, keep_out=[HalfPlane((0, 10), (0.3, 1)), Box((-500, -20), (40, 2))])),
    limits.StrainLimit(section=SectionScale(GLUED, 25e3, 8.0), strain=0.02, size=200.0),
    limits.LeastStiffness(),
    kept.InflectionLine(point=(0.2, 0.3), direction=(0.6, 0.8), scale=2.0),
    kept.MiddleOfMirror(centre=(0.2, 0.1), axis=(0.6, 0.8), angle=0.3, scale=4.0),
    kept.MiddleOfTurn(centre=(0.2, 0.1), scale=4.0),
]


@pytest.mark.parametrize("constraint", CONSTRAINTS, ids=lambda c: type(c).__name__)
def test_rows_are_derivatives(constraint, grid, z):
    if "pinned" in constraint.active.name:
        grid = replace(grid, supports=Supports("clamped", "pinned"))
    index, rows = constraint.rows(grid.sensitivities(grid.shoot(z)))
    assert index.size > 0
    for j in range(z.size):
        numeric = derivative(lambda q: constraint.values(grid.shoot(q))[index], z, j)
        np.testing.assert_allclose(rows[:, j], numeric, atol=1e-7 * max(1.0, np.abs(rows).max()))


@pytest.mark.parametrize("rest", [0.0, 1.5])
@pytest.mark.parametrize("kind", ["margin", "largest section"])
def test_rows_of_strips_that_follow_their_bend(kind, rest, grid, z):
    """By differences, which round off the kinks that a blank has where its bend changes sides."""
    section = SectionScale(PlainSection(CAST, 0.0, 60.0), CAST.bending_stiffness(40.0), 3.0)
    grid, of = replace(grid, natural_curvature=rest), {"section": section, "rest": rest, "size": 200.0}
    constraint = limits.FollowedMarginLimit(active=MARGIN, **of)
    if kind != "margin":
        constraint = limits.LargestSection(**of)
    index, rows = constraint.rows(grid.sensitivities(grid.shoot(z)))
    if kind == "margin":
        assert constraint.values(grid.shoot(z)) != limits.MarginLimit(active=MARGIN).values(grid.shoot(z))
    assert index.size > 0
    for j in range(z.size):
        numeric = derivative(lambda q: constraint.values(grid.shoot(q))[index], z, j)
        np.testing.assert_allclose(
            rows[:, j], numeric, atol=(4e-3 if rest else 2e-4) * max(1.0, np.abs(rows).max())
        )


def test_a_point_is_passed_at_its_foot(grid, z):
    """On the rod the foot does not matter; beside it the row holds for the foot that is found."""
    rod = grid.shoot(z)
    constraint = kept.Through(target=tuple(rod.position[30]), place=30 / EDGES)
    assert abs(constraint.values(rod)[0]) < 1e-14
    _, rows = constraint.rows(grid.sensitivities(rod))
    for j in range(z.size):
        numeric = derivative(lambda q: constraint.values(grid.shoot(q)), z, j)
        np.testing.assert_allclose(rows[:, j], numeric, atol=1e-7)


def test_feet_of_points_beside_a_rod_are_those_of_its_cubics(grid, z):
    """Each of two points has its own foot, told once for a rod; numpy's polynomials say where it is."""
    rod = grid.shoot(z)
    for k, aside in ((20, 0.01), (45, -0.02)):
        nodes = np.arange(k - 1, k + 3)
        cubics = [np.polynomial.Polynomial.fit(range(4), rod.position[nodes, i], 3) for i in (0, 1)]
        on, along = (np.array([c(1.3) for c in part]) for part in (cubics, [c.deriv() for c in cubics]))
        normal = np.array([-along[1], along[0]]) / np.hypot(*along)
        constraint = kept.Through(target=tuple(on + aside * normal), place=k / EDGES)
        for _ in range(2):
            np.testing.assert_allclose(constraint.values(rod), [-aside], atol=1e-12)


@pytest.fixture(scope="module")
def wish():
    return TargetCurve.of(PlaneCurve.spline([(0, 0), (30, 50), (60, 45), (80, -10), (130, 0)], degree=4))


def test_the_mean_distance_has_a_gradient(grid, z, wish):
    rod = grid.shoot(z)
    shares = np.full(EDGES + 1, 1 / (EDGES + 1))
    distance = MeanDistance(wish.at(np.linspace(0, 1, EDGES + 1)), shares)
    gradient = distance.model(rod, grid.sensitivities(rod, to_equilibrium=True)).gradient
    for j in range(z.size):
        numeric = derivative(lambda q: distance.value(grid.shoot(q)), z, j)
        np.testing.assert_allclose(gradient[j], numeric, atol=2e-7 * max(1, np.abs(gradient).max()))


def test_the_largest_distance_is_the_highest_peak(grid, z, wish):
    rod = grid.shoot(z)
    distance = LargestDistance(wish, np.ones(EDGES + 1))
    model = distance.model(rod, grid.sensitivities(rod, to_equilibrium=True))
    top = int(np.argmax(model.peaks))
    assert model.peaks[top] == pytest.approx(distance.value(rod), rel=1e-12)
    for j in range(z.size):
        numeric = derivative(lambda q: distance.value(grid.shoot(q)), z, j)
        np.testing.assert_allclose(
            model.peak_rows[top, j], numeric, atol=1e-6 * np.abs(model.peak_rows).max()
        )


def test_a_box_pushes_out_through_its_nearest_side_and_round_its_corners():
    value, gradient = Box((0, 0), (10, 4)).clearance(
        np.array([[5.0, 1.0], [5.0, 3.5], [13.0, 8.0], [-2.0, 1.0]])
    )
    np.testing.assert_allclose(value, [-1.0, -0.5, 5.0, 2.0])
    np.testing.assert_allclose(gradient, [[0, -1], [0, 1], [0.6, 0.8], [-1, 0]])


def test_the_largest_distance_of_a_short_rod_is_that_of_the_far_end_of_the_curve(wish):
    """Each node is near the curve, but not each point of the curve is near the rod."""
    half = SimpleNamespace(position=wish.at(np.linspace(0, 0.5, EDGES + 1)))
    end = np.hypot(*(wish.position[501:] - half.position[-1]).T).max()
    largest = LargestDistance(wish, np.ones(EDGES + 1)).value(half)
    assert largest == pytest.approx(end, rel=1e-3)
    assert measure_deviation(wish, half.position * wish.size + wish.origin) == pytest.approx(
        end * wish.size, rel=1e-3
    )
