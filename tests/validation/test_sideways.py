"""Leaving the plane: lateral buckling in closed form, shooting in space, finite elements of three styles."""

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_ivp
from scipy.linalg import eigh
from scipy.optimize import brentq
from scipy.sparse import lil_matrix
from scipy.sparse.linalg import spsolve
from scipy.special import ellipeinc, ellipj, ellipk

from elastica_cad import (
    End,
    Gravity,
    Laminated,
    Perforated,
    PlaneCurve,
    PointForce,
    Rod,
    Sheet,
    Strip,
    Supports,
    bend,
    bend_strip,
    make_strip,
    optimal_rod,
)
from elastica_cad.mechanics import LaminatedSection, sideways_stability
from elastica_cad.mechanics.sideways import SidewaysSection, sideways_margin, sideways_stability_of
from elastica_cad.strip.strip import strip_sideways

pytestmark = pytest.mark.core

LENGTH = 300.0
NODES = 601
A, C = 900.0, 1.4  # edgewise bending and torsion over bending in the plane
MEASURED = json.loads((Path(__file__).parents[1] / "campaign/finite_elements/measured.json").read_text())


def margin(rod, edgewise=A, torsion=C, nodes=201):
    return sideways_margin(rod, np.full(nodes, edgewise), np.full(nodes, torsion))


def loaded(moment, force, *, free=False):
    """A strip that its load holds straight, with given moments (a share of the length -> 1/mm) and forces."""
    ends = Supports(end=End(x=False, y=False, angle=False)) if free else Supports()
    rod = Rod.straight(1.0, samples=NODES, supports=ends)
    s = rod.s
    return replace(rod, moment=moment(s), force=np.column_stack([force(s)[0] + 0 * s, force(s)[1] + 0 * s]))


LATERAL = {
    "Prandtl 1899: pure bending, held at both ends against turning sideways and twist": (
        2 * np.pi, lambda M: loaded(lambda s: M + 0 * s, lambda s: (0.0, 0.0)),
    ),
    "Michell 1899: a cantilever with a load at its tip": (
        4.01260, lambda P: loaded(lambda s: P * (1 - s), lambda s: (0.0, -P), free=True),
    ),
    "Prandtl 1899: a cantilever under its own weight": (
        12.8527,
        lambda q: loaded(lambda s: q * (1 - s) ** 2 / 2, lambda s: (0.0, -q * (1 - s)), free=True),
    ),
}  # fmt: skip
"""Critical loads over the root of edgewise bending times torsion, and the strip under such a load."""


def critical_load(case):
    """Where the sideways margin is lost, in the same measure."""
    critical, rod = LATERAL[case]
    root = np.sqrt(A * C)
    return brentq(lambda load: margin(rod(load)), critical * root * 0.5, critical * root * 1.4) / root


@pytest.mark.parametrize("case", LATERAL)
def test_lateral_buckling_in_closed_form(case):
    assert critical_load(case) == pytest.approx(LATERAL[case][0], rel=1e-3)


def narrow_beam(load):
    """A beam of length 1 between clamps, held straight under a load in the middle."""
    return loaded(
        lambda s: load * (np.minimum(s, 1 - s) / 2 - 1 / 8), lambda s: (0.0, load / 2 * np.sign(0.5 - s))
    )


def critical_load_of_a_narrow_beam(edges=400):
    """Least P of GJ b'' + M (M b - m) / EI2 = 0, divided by the root of EI2 GJ.

    The moment M is P (s / 2 - 1 / 8). The clamps hold the twist b and the sideways angle.
    The constant m is the moment of a clamp.
    """
    h = 0.5 / edges
    s = h * np.arange(1, edges + 1)
    twist = (2 * np.eye(edges) - np.eye(edges, k=1) - np.eye(edges, k=-1)) / h
    weight = np.full(edges, h)
    twist[-1, -1], weight[-1] = 1 / h, h / 2
    moment = s / 2 - 1 / 8
    work = np.diag(weight * moment**2) - np.outer(weight * moment, weight * moment) / 0.5
    return eigh(work, twist, eigvals_only=True)[-1] ** -0.5


@pytest.mark.parametrize("torsion", [1.5, 0.25], ids=["isotropic", "plywood"])
@pytest.mark.parametrize(
    ("part", "word"), [(0.02, "ample"), (0.6, "ample"), (0.75, "low"), (1.05, "unstable")]
)
def test_the_rating_of_a_loaded_beam_follows_the_critical_load(torsion, part, word):
    """The rating does not depend on the unloaded margin, which is the twist: 15 and 2.5."""
    same = np.ones(201)
    section = SidewaysSection(0.01 * same, 0.001 * same, A * same, torsion * same)
    load = part * critical_load_of_a_narrow_beam() * np.sqrt(A * torsion)
    assert sideways_stability_of(narrow_beam(load), section).word == word


def test_a_slat_of_plywood_with_8_kg_is_far_from_tipping():
    """The margin is small without a load too, because plywood is easy to twist."""
    sheet = replace(Sheet.named("birch-plywood-6"), thickness=8.0)
    slides = Supports(start=End(x=True, y=True, angle=True), end=End(x=False, y=True, angle=True))
    slat = Strip(Rod.straight(700.0, supports=slides), sheet, max_width=70.0)
    sag = bend_strip(slat, [{"loads": (PointForce(350, (0, -78.5)),)}]).sideways[-1]
    assert (sag.margin < 5, sag.word) == (True, "ample")


def test_a_column_and_a_shaft():
    """Twist alone: pi^2 GJ between clamps; Euler's column, edgewise: 4 pi^2 EI2."""
    assert abs(margin(Rod.straight(70.0)) - np.pi**2 * C) < 1e-3
    column = brentq(lambda P: margin(loaded(lambda s: 0 * s, lambda s: (P, 0.0)), 2.0, 50.0), 1.0, 200.0)
    assert abs(column - 8 * np.pi**2) < 0.02


def pushed_together(k):
    """A uniform strip clamped in line, its ends pushed together: four quarters of the elastica of modulus k."""
    u = np.linspace(0, 4 * ellipk(k**2), NODES)
    _, cn, _, amplitude = ellipj(u, k**2)
    points = LENGTH / u[-1] * np.column_stack([2 * ellipeinc(amplitude, k**2) - u, -2 * k * cn])
    angle = 2 * np.arcsin(k * ellipj(u, k**2)[0])
    straight = Rod.straight(LENGTH, samples=NODES)
    rod = bend(straight, start=points[0], end=points[-1], angles=(0.0, 0.0), guess=angle)
    assert np.abs(rod.position - points).max() < 0.01
    return rod


def turned_away(rod, edgewise, torsion):
    """How far the end strays sideways for what the start may add: a determinant, zero where the rod buckles.

    Kirchhoff's equations in space, integrated as an initial value problem.
    """
    stiffness = np.array([torsion, edgewise, 1.0])

    def end(extra):
        angle = rod.angle[0]
        frame = np.array([[np.cos(angle), np.sin(angle), 0], [-np.sin(angle), np.cos(angle), 0], [0, 0, 1.0]])
        pull = np.array([*-rod.force[0], extra[2]])
        first = np.concatenate([np.zeros(3), frame.ravel(), [extra[0], extra[1], rod.moment[0]]])

        def slope(_, y):
            d, m = y[3:12].reshape(3, 3), y[12:]
            turning = (d @ m / stiffness) @ d
            return np.concatenate([d[0], np.cross(turning, d).ravel(), -np.cross(d[0], pull)])

        return solve_ivp(slope, (0, rod.length), first, rtol=1e-10, atol=1e-12, method="DOP853").y[:, -1]

    columns = []
    for k, step in enumerate((1e-6, 1e-6, 1e-8)):
        extra = np.zeros(3)
        extra[k] = step
        apart = (end(extra) - end(-extra)) / (2 * step)
        columns.append([apart[2], apart[5], apart[8]])  # z, and the heights of tangent and normal
    return float(np.linalg.det(np.array(columns)))


@pytest.mark.parametrize(
    ("shear_ratio", "width", "between"),
    [(1 / 2.6, 5.0, (0.83, 0.89)), (0.25, 4.0, (0.8, 0.87))],
    ids=["isotropic", "with grain"],
)
def test_a_rod_in_space_buckles_where_the_margin_vanishes(shear_ratio, width, between):
    edgewise, torsion = (width / 0.8) ** 2, 4 * shear_ratio * (1 - 0.63 * 0.8 / width)
    by_margin, by_shooting = (
        brentq(at, *between, xtol=1e-5)
        for at in (
            lambda k: sideways_stability(pushed_together(k), width, 0.8, shear_ratio=shear_ratio).margin,
            lambda k: turned_away(pushed_together(k), edgewise, torsion),
        )
    )
    assert abs(by_margin - by_shooting) < 2e-3


def test_a_sheet_with_grain_twists_by_its_own_shear_modulus():
    """Plywood resists twist with a seventh of what a sheet without grain of its E would; its strips say so."""
    birch = Sheet.named("birch-plywood-0.8")
    assert birch.shear_ratio == pytest.approx(620 / 9250)
    arch = PlaneCurve.spline([(0, 0), (150, 300), (350, 400), (600, 300), (750, 0)])
    own, even = (
        make_strip(arch, sheet, max_width=60).sideways.margin
        for sheet in (birch, replace(birch, shear_modulus=None))
    )
    assert own < even / 4


def arc(degrees):
    turn = np.radians(degrees)
    angle = np.linspace(0, turn, NODES)
    points = LENGTH / turn * np.column_stack([np.sin(angle), 1 - np.cos(angle)])
    straight = Rod.straight(LENGTH, samples=NODES)
    return bend(straight, start=points[0], end=points[-1], angles=(0.0, turn), guess=angle)


def test_the_sign_is_that_of_finite_elements():
    """Of sixteen plain strips: where the rod decides, the lowest eigenvalue out of the plane has its sign."""
    decided = 0
    for case in MEASURED["sideways"]:
        name, width = case["name"], case["width"]
        if not name.startswith(("arc", "ends")):
            continue
        rod = (
            arc(float(name.split()[2]))
            if name.startswith("arc")
            else pushed_together(float(name.split("=")[1]))
        )
        found = sideways_stability(rod, width, 0.8, poisson_ratio=0.3)
        if found.decided:
            decided += 1
            assert (found.margin > 0) == (case["sideways"] > 0), name
    assert decided >= 13


def even_strip(thickness, style, width):
    """A straight strip of a style, as uniform as it can be."""
    sheet = Sheet("known", thickness, 9000.0, 700.0, max_strain=0.02, poisson_ratio=0.3)
    return Strip(Rod.straight(LENGTH), sheet, max_width=width, style=style)


def holes(width, rows):
    return Perforated(width=width, columns=1, rows=rows, least_ligament=0.2, least_hole=0.2)


def backed(width):
    return Laminated(
        width=width, backing=Sheet("known", 0.5, 9000.0, 700.0, 0.02, poisson_ratio=0.3), dots=0.0
    )


STYLED = {
    "perforated, 12 rows": (0.8, holes(12.0, 12), 5.0),
    "perforated, 10 rows": (0.8, holes(20.0, 10), 8.0),
    "laminated, backing 5 mm": (0.5, backed(8.0), 5.0),
    "laminated, backing 12 mm": (0.5, backed(20.0), 12.0),
}
"""Thickness, style, material or backing, mm."""


def test_of_strips_with_holes_and_of_laminates_too():
    cases = [case for case in MEASURED["sideways"] if case["name"].split(", ends")[0] in STYLED]
    for case in cases:
        strip = even_strip(*STYLED[case["name"].split(", ends")[0]])
        found = strip_sideways(pushed_together(float(case["name"].split("=")[1])), strip.layout)
        assert found.decided, case["name"]
        assert (found.margin > 0) == (case["sideways"] > 0), case["name"]
        assert found.word == case["told"]
    assert sum(case["sideways"] < 0 for case in cases) == 2
    assert len(cases) == 6


def test_bounds_leave_some_strips_with_holes_undecided_and_say_why():
    layout = even_strip(*STYLED["perforated, 12 rows"]).layout
    found = strip_sideways(pushed_together(0.85), layout)
    assert found.margin < 0 < found.most
    assert (found.decided, found.word) == (False, "undecided")
    assert "it is uncertain whether the strip tips over" in found.meaning
    wide = strip_sideways(pushed_together(0.85), even_strip(0.8, holes(60.0, 6), 20.0).layout)
    assert "too wide for its length and bend" in wide.meaning


def test_both_bounds_of_a_strip_without_holes_are_that_of_a_solid_one():
    one, width = np.ones(3), np.array([20.0, 30.0, 40.0])
    least, most = SidewaysSection.perforated(
        one, width, width, 0 * one, ligaments=1, thickness=0.8, shear_ratio=1 / 2.6
    )
    solid = SidewaysSection.rectangle(one, width, 0.8 * one, 1 / 2.6)
    assert least.torsion == pytest.approx(solid.torsion)
    assert least.edgewise == pytest.approx(solid.edgewise)
    assert most.edgewise == pytest.approx(solid.edgewise)
    assert most.torsion == pytest.approx(solid.torsion, rel=0.03)
    assert np.all(most.torsion > solid.torsion)


def torsion_by_differences(section, base_width, backing_width, cell=0.05):
    """G J, N mm2, of two glued rectangles: Prandtl's stress function on a grid, div(grad phi / G) = -2."""
    sheets = section.base, section.backing
    rows = [round(sheet.thickness / cell) for sheet in sheets]
    across = round(base_width / cell)
    margin = round((base_width - backing_width) / 2 / cell)
    softness = np.zeros((sum(rows), across))  # of cells, 1/G; 0 outside
    for k, (sheet, first) in enumerate(zip(sheets, (0, rows[0]), strict=True)):
        side = slice(margin, across - margin) if k else slice(None)
        softness[first : first + rows[k], side] = 2 * (1 + sheet.poisson_ratio) / sheet.youngs_modulus
    around = np.pad(softness, 1)
    cells = [around[1:, 1:], around[1:, :-1], around[:-1, 1:], around[:-1, :-1]]
    inside = np.all([c > 0 for c in cells], axis=0)  # nodes with material all round
    number = np.full(inside.shape, -1)
    number[inside] = np.arange(inside.sum())
    matrix = lil_matrix((inside.sum(),) * 2)
    for i, j in np.argwhere(inside):
        upper, left = around[i, j : j + 2], around[i : i + 2, j]
        lower, right = around[i + 1, j : j + 2], around[i : i + 2, j + 1]
        links = ((i - 1, j, upper), (i + 1, j, lower), (i, j - 1, left), (i, j + 1, right))
        me = number[i, j]
        for k, m, between in links:
            matrix[me, me] += between.mean()
            if number[k, m] >= 0:
                matrix[me, number[k, m]] -= between.mean()
    phi = spsolve(matrix.tocsr(), np.full(inside.sum(), 2 * cell**2))
    return 2 * phi.sum() * cell**2


@pytest.mark.parametrize(
    ("backing", "widths"), [(9000.0, (8.0, 5.0)), (3000.0, (8.0, 5.0)), (9000.0, (10.0, 10.0))]
)
def test_torsion_of_laminates_by_prandtls_stress_function(backing, widths):
    sheets = [Sheet("known", 0.5, E, 700.0, max_strain=0.02, poisson_ratio=0.3) for E in (9000.0, backing)]
    section, (base, glued) = LaminatedSection(*sheets), widths
    B = float(section.on(base).bending_stiffness(glued))
    found = SidewaysSection.laminated(np.ones(1), B, np.full(1, base), np.full(1, glued), section)
    assert found.torsion[0] * B == pytest.approx(torsion_by_differences(section, base, glued), rel=0.04)


def test_the_word_follows_the_margin_and_wide_strips_are_left_undecided():
    rod = pushed_together(0.9)
    assert sideways_stability(rod, 5.0, 0.8).word == "unstable"
    assert sideways_stability(rod, 80.0, 0.8).word == "undecided"
    assert sideways_stability(pushed_together(0.4), 5.0, 0.8).word == "ample"


def test_a_strip_is_as_safe_drawn_from_either_end():
    """A cantilever under its weight, wider at its clamp: free at its last end, or at its first."""
    free, wide = End(x=False, y=False, angle=False), np.linspace(8.0, 4.0, 101)
    margins = []
    for ends, stiffness in ((Supports(end=free), wide), (Supports(start=free), wide[::-1])):
        rod = bend(Rod.straight(200.0, stiffness, gravity=Gravity(150.0, (0, -1)), supports=ends))
        margins.append(sideways_stability(rod, stiffness, 0.8).margin)
    assert margins[1] == pytest.approx(margins[0], rel=1e-6)
    assert margins[0] > 0


def test_the_margin_of_a_turned_strip_is_the_same_to_rounding():
    """-12.068 by dense algebra; without the ends -22.096, which rounding of a pole had made of it in one of ten."""
    heights = [
        42.476739602762166,
        -28.367895078279286,
        -60.37919586545773,
        10.700435306983838,
        66.58040767549467,
    ]
    points = np.column_stack([np.linspace(0.0, 300.0, 5), heights])
    weights = [
        3.483323807649257,
        3.9521342501036805,
        0.3421936017489547,
        3.0826448687053127,
        0.3968261557642031,
    ]
    rng = np.random.default_rng(0)
    for turn, shift in zip(rng.uniform(0.0, 6.3, 100), rng.uniform(-500.0, 500.0, (100, 2)), strict=True):
        c, s = np.cos(turn), np.sin(turn)
        curve = PlaneCurve([0] * 5 + [1] * 5, points @ [[c, s], [-s, c]] + shift, 4, weights)
        rod = optimal_rod(curve.reversed())
        found = sideways_stability(rod, 12 * rod.stiffness / rod.stiffness.max(), 0.8)
        assert found.margin == pytest.approx(-12.068, rel=1e-4)
