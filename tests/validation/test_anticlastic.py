"""Stiffening of wide strips against the plate strip solved as a boundary value problem across the width."""

import numpy as np
import pytest

from elastica_cad import InputError, Sheet
from elastica_cad.mechanics import LaminatedSection, anticlastic_factor
from elastica_cad.mechanics.laminated_section import laminate_factor
from elastica_cad.mechanics.sections import plate_width

pytestmark = pytest.mark.core


def moment_across(width, curvature, thickness, nu):
    """M / (E I kappa) from D v'''' = -E h kappa^2 v with free edges (E = 1), integrated stress by stress."""
    from scipy.integrate import solve_bvp

    D = thickness**3 / 12 / (1 - nu**2)
    half = width / 2

    def field(y, state):
        v, v1, v2, v3, _ = state
        return np.array(
            [
                v1,
                v2,
                v3,
                -thickness * curvature**2 / D * v,
                D * (curvature + nu * v2) + thickness * curvature * v**2,
            ]
        )

    def ends(a, b):
        return np.array([a[1], a[3], a[4], b[2] + nu * curvature, b[3]])

    y = np.linspace(0.0, half, 200)
    solved = solve_bvp(field, ends, y, np.zeros((5, y.size)), tol=1e-9, max_nodes=20000)
    assert solved.success
    return 2 * solved.y[4, -1] / (width * thickness**3 / 12 * curvature)


@pytest.mark.parametrize(
    ("width", "radius", "nu"),
    [(5.0, 200.0, 0.3), (12.0, 80.0, 0.3), (20.0, 60.0, 0.3), (40.0, 60.0, 0.45), (60.0, 40.0, 0.2)],
)
def test_factor_matches_the_boundary_value_problem(width, radius, nu):
    found = anticlastic_factor(width, 1 / radius, thickness=0.5, poisson_ratio=nu)
    assert found == pytest.approx(moment_across(width, 1 / radius, 0.5, nu), rel=1e-7)


def test_series_and_closed_form_agree_where_they_meet():
    x = np.array([0.3 - 1e-9, 0.3 + 1e-9])
    nu = 0.3
    width = x / (3 * (1 - nu**2)) ** 0.25
    low, high = anticlastic_factor(width, 1.0, thickness=1.0, poisson_ratio=nu)
    assert low == pytest.approx(high, abs=1e-12)
    assert low > 1.0


@pytest.mark.parametrize("nu", [0.0, 0.1, 0.3, 0.5])
def test_factor_grows_from_one_to_the_plate(nu):
    width = np.geomspace(1e-3, 1e5, 4001)
    factor = anticlastic_factor(width, -0.01, thickness=1.0, poisson_ratio=nu)
    assert factor[0] == pytest.approx(1.0, abs=1e-12)
    assert factor[-1] == pytest.approx(1 / (1 - nu**2), rel=1e-4)
    assert np.all(np.diff(width * factor) > 0)


def test_nothing_changes_without_lateral_contraction():
    wanted = np.array([15.0, 30.0, 19.5])
    assert plate_width(wanted, [0.1, 0.0, -0.2], thickness=0.5, poisson_ratio=0.0) == pytest.approx(wanted)


@pytest.mark.parametrize(
    ("changed", "message"),
    [
        ({"thickness": 0.0}, "thickness is 0.0: give a number above 0"),
        ({"poisson_ratio": 1.0}, "between 0 and 1"),
        ({"curvature": [0.1, np.inf]}, "curvature is not finite"),
    ],
)
def test_bad_input(changed, message):
    good = {"width": [1.0, 2.0], "curvature": [0.01, 0.02], "thickness": 0.5, "poisson_ratio": 0.3}
    with pytest.raises(InputError, match=message):
        anticlastic_factor(**{**good, **changed})


def test_width_must_be_positive():
    with pytest.raises(InputError, match="strip width is not positive"):
        anticlastic_factor([1.0, 0.0], 0.01, thickness=0.5, poisson_ratio=0.3)


def ply(thickness, poisson_ratio):
    return Sheet("ply", thickness, 9000.0, density=680.0, max_strain=0.02, poisson_ratio=poisson_ratio)


CURVATURES = np.array([1e-4, 3e-3, 1e-2, 3e-2])


@pytest.mark.parametrize(("backing", "h"), [(0.0, 0.8), (30.0, 1.3)], ids=["none", "full"])
def test_a_laminate_without_borders_is_one_sheet(backing, h):
    section = LaminatedSection(ply(0.8, 0.3), ply(0.5 if backing else 1e-3, 0.3))
    found = laminate_factor(30.0, backing or 15.0, CURVATURES, section)
    assert found == pytest.approx(
        anticlastic_factor(30.0, CURVATURES, thickness=h, poisson_ratio=0.3), abs=1e-3
    )


def test_borders_that_lie_off_the_axis_give_way():
    """By a share of E I that grows as kappa^2, up to all that their stress along the bend carries."""
    section = LaminatedSection(ply(0.5, 0.0), ply(0.5, 0.0))
    softer = 1 - laminate_factor(24.0, 12.0, CURVATURES, section)
    assert np.all(np.diff(softer) > 0)
    assert softer[0] * 100 == pytest.approx(1 - laminate_factor(24.0, 12.0, 1e-3, section)[0], rel=0.05)
    # without nu it does not matter which way
    assert laminate_factor(24.0, 12.0, -CURVATURES, section) == pytest.approx(1 - softer, abs=1e-12)
    # no softer than without all that its borders carry off the axis
    bare = section.on(12.0).bending_stiffness(12.0) + section.base.bending_stiffness(12.0)
    assert softer[-1] < 1 - bare / section.on(24.0).bending_stiffness(12.0)


def test_a_laminate_that_curls_is_softer_one_way():
    section = LaminatedSection(ply(0.5, 0.3), ply(0.5, 0.3))
    (inward, outward) = (laminate_factor(12.0, 6.0, sign * 0.02, section)[0] for sign in (1, -1))
    assert inward < 0.92
    assert outward > 1.05


@pytest.mark.parametrize("width", [3.0, 30.0, 400.0])
@pytest.mark.parametrize("share", [0.0, 0.3, 0.97, 1.0])
@pytest.mark.parametrize("thickness", [(0.2, 0.2), (0.2, 3.0), (3.0, 0.2)])
def test_laminates_are_as_their_section_says_where_they_are_straight(width, share, thickness):
    """In inflections, and beside them. Without nu nothing curls; with it the limit is that of a slight bend."""
    straight = np.array([0.0, 1e-12, 1e-9]) / width**2
    alike = LaminatedSection(*(ply(t, 0.0) for t in thickness))
    assert laminate_factor(width, share * width, straight, alike) == pytest.approx(1.0, abs=2e-3)
    curling = LaminatedSection(*(ply(t, nu) for t, nu in zip(thickness, (0.3, 0.1), strict=True)))
    factor = laminate_factor(width, share * width, straight, curling)
    slight = laminate_factor(width, share * width, 1e-4 * thickness[0] / width**2, curling)
    assert factor == pytest.approx(slight[0], abs=1e-3)
