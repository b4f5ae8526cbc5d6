"""Strips that stray, as a boundary value problem of their own: moments by the bend that each place comes to."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.interpolate import RectBivariateSpline
from scipy.optimize import root

from elastica_cad import Laminated, PlaneCurve, Sheet, make_strip
from elastica_cad.mechanics import LaminatedSection
from elastica_cad.mechanics.laminated_section import laminate_factor
from elastica_cad.strip.layers import PLATE_CUT, PLATE_END, LapPlates

pytestmark = pytest.mark.core

LENGTH = 300.0
AGREES = 0.005
"""Of the deviation that is told."""

DRAWN = {
    "arch": [(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)],
    "sharp S": [(0, 0), (30, 80), (120, 60), (130, -20), (180, -30)],
    "flat S": [(0, 0), (40, 40), (100, 40), (120, -10), (180, -60), (260, 0)],
    "S": [(0, 0), (50, 60), (100, 10), (150, -40), (200, 20)],
}
CARD = replace(Sheet.named("card-200gsm"), poisson_ratio=0.3)
PLY = Sheet("ply", 0.5, 9000.0, 680.0, max_strain=0.02, poisson_ratio=0.3)
BARE = Sheet("bare ply", 0.5, 9000.0, 680.0, max_strain=0.02, poisson_ratio=0.0)


def drawn(name, length):
    curve = PlaneCurve.spline(DRAWN[name], degree=4)
    return curve.transformed(np.diag([1.0, 1.0, curve.length / length]))


def strays(shape, design):
    return float(np.hypot(*(shape - design).T).max())


WIDE = {  # sheet, curve, length and widest place in mm, under its weight?
    "aluminium, arch": ("aluminium-6061-0.5", "arch", 300.0, 25.0, False),
    "aluminium, S": ("aluminium-6061-0.5", "sharp S", 300.0, 30.0, False),
    "aluminium, heavy S": ("aluminium-6061-0.5", "S", 900.0, 50.0, True),
    "steel, arch": ("spring-steel-0.5", "arch", 300.0, 25.0, False),
    "steel, S": ("spring-steel-0.5", "flat S", 300.0, 30.0, False),
    "steel, heavy S": ("spring-steel-0.5", "S", 900.0, 80.0, True),
    "acrylic, arch": ("acrylic-2", "arch", 500.0, 62.5, False),
    "acrylic, S": ("acrylic-2", "sharp S", 500.0, 75.0, False),
    "acrylic, heavy arch": ("acrylic-2", "arch", 900.0, 75.0, True),
    "acrylic, heavy S": ("acrylic-2", "S", 900.0, 125.0, True),
}


@pytest.mark.parametrize("case", WIDE)
def test_a_wide_strip_strays_as_its_bend_stiffens_it(case, wide_strips):
    name, curve, length, width, heavy = WIDE[case]
    sheet = Sheet.named(name)
    made = make_strip(
        drawn(curve, length), sheet, max_width=width, gravity=heavy, compensate=False, ignore_limits=True
    )
    own = wide_strips.OwnStrip.cut(made.width, sheet, heavy=heavy).bent(made.rod)
    # the sides end level beside the tabs, which moves the strip by less than 0.5 um
    assert made.held_deviation == pytest.approx(strays(own.position, made.rod.position), rel=AGREES, abs=5e-4)


@pytest.mark.parametrize(
    ("curve", "sheet", "width"), [("arch", BARE, 24.0), ("arch", PLY, 12.0), ("S", PLY, 12.0)]
)
def test_a_laminate_strays_as_its_borders_give_way(curve, sheet, width, wide_strips):
    style = Laminated(width=width, backing=sheet, dots=0.0)
    made = make_strip(
        drawn(curve, LENGTH), sheet, style=style, max_width=0.85 * width, compensate=False, ignore_limits=True
    )
    section, backing = LaminatedSection(sheet, sheet), made.layout.backing.width
    low, high = backing.extremes
    widths = np.linspace(0.99 * low, min(1.01 * high, width), 40)
    kappa = np.linspace(-1.5, 1.5, 121) * np.abs(made.rod.curvature).max()
    table = np.array([laminate_factor(width, wide, kappa, section) for wide in widths])
    factor = RectBivariateSpline(widths, kappa, table)
    own = wide_strips.OwnStrip(
        lambda s: section.on(np.full(s.size, width)).bending_stiffness(backing(s)),
        lambda s, kappa: factor(backing(s), kappa, grid=False),
    ).bent(made.rod)
    assert made.held_deviation == pytest.approx(strays(own.position, made.rod.position), rel=AGREES)


@pytest.mark.parametrize(("curve", "phi"), [("arch", 2.5), ("S", 0.8), ("sharp S", 0.8)])
def test_a_strip_whose_widths_count_on_its_curl_sags_as_that_follows(curve, phi, wide_strips):
    """In the long run, under its weight: of a modulus 1 + phi times smaller, its shape across as it comes."""
    made = make_strip(
        drawn(curve, LENGTH),
        CARD,
        max_width=45.0,
        gravity=True,
        creep=phi,
        compensate=None,
        ignore_limits=True,
    )
    own = wide_strips.OwnStrip.cut(made.width, CARD, heavy=True, softer=1 + phi).bent(made.rod)
    found = made.crept
    assert found.sag == pytest.approx(strays(own.position, made.rod.position), rel=AGREES)
    assert found.exact


@pytest.mark.parametrize(("nu", "width"), [(0.0, 30.0), (0.3, 20.0), (0.3, 60.0)])
def test_a_strip_under_a_plate_is_twice_as_thick(nu, width, wide_strips):
    """Shot from its start, over each end of what carries of the plate, where it curls less as it is thicker."""
    ply = Sheet("ply", 0.8, 9000.0, 680.0, max_strain=0.02, poisson_ratio=nu)
    bare = make_strip(drawn("arch", LENGTH), ply, max_width=width, compensate=False, ignore_limits=True)
    joined = replace(bare, plates=LapPlates((110.0,), 60.0))
    h, EI, rod = ply.thickness, ply.youngs_modulus * ply.thickness**3 / 12, bare.rod
    near, far = PLATE_CUT * h / 2, 30.0 - PLATE_END * h
    ends = [0.0, 110 - far, 110 - near, 110 + near, 110 + far, rod.length]

    def shot(unknown, at=()):
        state, shape = [*rod.position[0], rod.angle[0], unknown[0]], []
        for k, (low, high) in enumerate(pairwise(ends)):
            layers = 1 + k % 2

            def along(s, state, layers=layers):
                _, _, angle, moment = state
                wide, cos, sin = bare.width(s), np.cos(angle), np.sin(angle)
                kappa = wide_strips.bend_by(
                    1000 * moment / (EI * layers**3 * wide),
                    lambda kappa: wide_strips.ashwell(wide, kappa, layers * h, nu),
                )
                return cos, sin, kappa, sin * unknown[1] - cos * unknown[2]

            run = solve_ivp(along, (low, high), state, rtol=1e-9, atol=1e-9, dense_output=True)
            state = run.y[:, -1]
            shape.append(run.sol(at[(at >= low) & (at < high)])[:2].T if len(at) else [])
        return state, shape

    def missed(unknown):
        x, y, angle, _ = shot(unknown)[0]
        return x - rod.position[-1, 0], y - rod.position[-1, 1], 1000 * (angle - rod.angle[-1])

    held = bare.reactions()
    found = root(missed, [-held.start_moment / 1000, *(-held.start_force / 1000)], tol=1e-10)
    assert found.success, found.message
    shape = np.concatenate(shot(found.x, rod.s)[1])
    result = joined.held_deviation
    assert result == pytest.approx(strays(shape, rod.position[: len(shape)]), rel=1e-2)
