"""Parts with two states against a solver of extensible rods and plane finite elements of the tests' own."""

from pathlib import Path

import numpy as np
import pytest

from elastica_cad import Flexure, NotRealizable, PlaneCurve, read_curves
from elastica_cad.design.pair_table import read_pair
from elastica_cad.pairs import FlexureSpec
from tests.extensible_rod import ExtensibleRod
from tests.two_states import drawn_pairs

EXAMPLES = Path(__file__).parents[2] / "examples" / "two_states"


def arches(up: float, down: float, thickness: float | None = None, **options) -> Flexure:
    """Two arches of these heights on 150 mm."""
    x = 150 * np.array([0, 0.18, 0.35, 0.7, 0.82, 1])
    curves = (PlaneCurve.spline(np.column_stack([x, [0, 0, y, y, 0, 0]]), degree=4) for y in (up, -down))
    return FlexureSpec(*curves, "pom-3", least_thickness=thickness, ignore_limits=True, **options).make()


def solver(part: Flexure, back: bool):
    """The part as a rod of length 1, pushed from a state, and the angles of this state and of the other."""
    rods, (at, way) = part.rods[::-1] if back else part.rods, part.pushed
    start, L = rods[0], part.pair.length
    natural, profile = part.pair.natural_curvature * L, part.pair.first.profile
    rod = ExtensibleRod(
        lambda s: profile(s * L),
        lambda s: np.interp(s * L, start.s, natural),
        lambda s: 12 * (L / part.scale) ** 2 * profile(s * L) ** (1 / 3),
        start.angle[[0, -1]],
        (start.position[-1] - start.position[0]) / L,
        at / L,
        (-way if back else way) / np.hypot(*way),
    )
    return rod, [lambda s, rod=rod: np.interp(s * L, rod.s, rod.angle) for rod in rods]


def require_as_solved(part: Flexure):
    """Rests, whether there are two, forces and snaps."""
    L, unit = part.pair.length, part.bending_stiffness / part.pair.length**2
    rod, angles = solver(part, back=False)
    s = part.rests[0].s / L
    places = [L * rod.position(*rod.rest(angle), s) + part.rods[0].position[0] for angle in angles]
    for place, rest in zip(places, part.rests, strict=True):
        assert np.hypot(*(place - rest.position).T).max() < 2e-4 * L
    assert part.bistable == (np.hypot(*(places[0] - places[1]).T).max() > 1e-3 * L)
    assert (part.travel_back is not None) == part.bistable
    for back, way in enumerate((part.travel, part.travel_back)):
        if way is None:
            continue
        rod, angles = solver(part, bool(back))
        travel, push = rod.pushed(angles[0], way.travel[-1] / L)
        assert way.largest_force == pytest.approx(unit * push.max(), rel=0.02)
        assert (way.snap is None) == (push[-1] > 0)
        if way.snap is not None:
            assert way.snap == pytest.approx(travel[-1] * L, abs=0.01 * way.travel[-1])


def test_a_shallow_part_snaps_as_an_extensible_rod():
    require_as_solved(arches(5, 4, 2.0))


@pytest.mark.campaign
@pytest.mark.parametrize(
    ("up", "down", "thickness"),
    [(8, 6.5, None), (8, 6.5, 1.72), (6, 5, 2.6), (4, 3, 1.5), (8, 3, 2.5), (7, 7, None), (3, 2.5, 2.0)],
)
def test_shallow_parts_snap_as_extensible_rods(up, down, thickness):
    require_as_solved(arches(up, down, thickness))


@pytest.mark.campaign
@pytest.mark.parametrize(("modes", "bend"), [(2, 1.2), (2, 2.0), (3, 1.2)])
def test_random_parts_snap_as_extensible_rods(modes, bend):
    count = 0
    for points in drawn_pairs(64, 16, modes, same_clamps=True, bend=bend):
        curves = (PlaneCurve.fit(150 * one, degree=5, tolerance=1e-4) for one in points)
        try:
            part = FlexureSpec(*curves, "pom-3", ignore_limits=True).make()
        except NotRealizable:
            continue
        if all(found.stable for found in part.pair.stability) and part.scale > 0.1:
            require_as_solved(part)
            count += 1
    assert count >= 10


def roots(part: Flexure, folder: Path, states=(0, 1)):
    """Strains by plane elements over those of the report, of the states at rest."""
    from tests.campaign.finite_elements.plane_parts import plane_part

    plane = plane_part(part, folder)
    for i in states:
        s, strain = plane.strain(plane.rest(part.states[i]))
        near = (s > -3) & (s < part.pair.length + 3)
        yield part.strain[i] / np.abs(strain[near]).max()


@pytest.mark.campaign
@pytest.mark.parametrize(
    ("up", "down", "thickness", "fillet"),
    [(24, 20, 1.1, 1.0), (8, 6.5, 1.7, 1.0), (20, 25, 2.5, 1.0), (12, 12, 1.2, 0.3), (30, 15, 1.3, 2.0)],
)
def test_strain_at_the_roots_is_that_of_finite_elements(up, down, thickness, fillet, tmp_path):
    pytest.importorskip("gmsh")
    for ratio in roots(arches(up, down, thickness, fillet=fillet), tmp_path):
        assert 0.98 < ratio < 1.1


@pytest.mark.campaign
@pytest.mark.parametrize("name", ["stand", "clip"])
def test_strain_of_the_examples_is_that_of_finite_elements(name, tmp_path):
    pytest.importorskip("gmsh")
    part = read_pair(EXAMPLES / f"{name}.toml", read_curves).make()
    for ratio in roots(part, tmp_path):
        assert 0.98 < ratio < 1.1


@pytest.mark.campaign
def test_strain_and_force_on_the_way_are_those_of_finite_elements(tmp_path):
    pytest.importorskip("gmsh")
    from tests.campaign.finite_elements.plane_parts import plane_part

    part = read_pair(EXAMPLES / "clip.toml", read_curves).make()
    way, plane = part.travel, plane_part(part, tmp_path)
    k = np.flatnonzero(way.travel < way.snap)[2::8]
    shapes = [part.line_through(position) for position in way.position[k]]
    pushes, nodes = plane.pushed(part.states[0], shapes, way.travel[k])
    assert pushes == pytest.approx(way.force[k], rel=0.02, abs=0.02 * way.largest_force)
    for result, found in zip(way.strain[k], nodes, strict=True):
        s, strain = plane.strain(found)
        root = (np.abs(s) < 3) | (np.abs(s - part.pair.length) < 3)
        assert 0.98 < result / np.abs(strain[root]).max() < 1.1
