"""Tapered columns, cantilevers and springs against closed forms and printed tables of the literature.

Pages were read in public copies or are told by another program's tests; each test says which.
"""

from dataclasses import replace

import numpy as np
import pytest
from scipy.optimize import brentq
from scipy.special import jv, yv

from elastica_cad import End, Gravity, Profile, Rod, Sheet, Supports, Weight, bend, stability
from elastica_cad.mechanics import PlainSection, RoundLaw, ThicknessLaw

pytestmark = pytest.mark.core

CANTILEVER = Supports("clamped", "free")
HINGES = Supports("pinned", End(x=False, angle=False))
MATERIAL = Sheet("any", 1.0, 12000.0, density=1000.0, max_strain=0.01)
NARROW = 1e-7
"""A spring of uniform strength ends in a point: what is left of the stiffness there."""


def critical_factor(n, ratio):
    """P l^2 / (E I_2) of a column clamped at its thick end, E I = E I_2 (x/b)^n from b down to a, free there.

    x is counted in lengths l from where the taper would end. The load turns the bent column by P y, so that
    E I y'' + P y = 0 becomes (x/b)^n y'' + m y = 0 with y(a) = 0 where it is free, as y is counted from the load's
    line, and y'(b) = 0 where it is clamped. Solved by

        n = 2: x^(1/2) sin(beta log(x/a)), beta^2 = m b^2 - 1/4
        n = 4: x sin(m^(1/2) b^2 (1/a - 1/x))
        n = 1, 3: x^(1/2) Z_1(2 (m b^n)^(1/2) x^((2-n)/2)), Z_1 of Bessel's J_1 and Y_1

    The forms are those of Timoshenko and Gere, Theory of Elastic Stability, chapter 2, on bars of varying
    cross-section, after Dinnik; derived here, as no edition's page was at hand.
    """
    b = 1 / (1 - ratio ** (1 / n))
    a = b - 1

    def end_slope(m):
        if n == 2:
            beta = np.sqrt(complex(m * b**2 - 0.25))
            turn = beta * np.log(b / a)
            return float((np.sin(turn) / (2 * beta) + np.cos(turn)).real)
        if n == 4:
            turn = np.sqrt(m) * b**2 * (1 / a - 1 / b)
            return np.sin(turn) + np.sqrt(m) * b * np.cos(turn)
        step = 1e-6

        def y(x):
            u, v = (2 * np.sqrt(m * b**n) * z ** ((2 - n) / 2) for z in (x, a))
            return np.sqrt(x) * (jv(1, u) * yv(1, v) - yv(1, u) * jv(1, v))

        return (y(b + step) - y(b - step)) / (2 * step)

    return brentq(end_slope, 0.3, 2.6, xtol=1e-12)


def buckling(rod, around):
    """The end force, over the least stiffness, at which the margin of a straight rod vanishes."""

    def margin(load):
        return stability(bend(rod, force=(-load, 0.0), guess=rod)).margin

    return brentq(margin, 0.7 * around, 1.3 * around, rtol=1e-9)


@pytest.mark.parametrize("n", [1, 2, 3, 4])
@pytest.mark.parametrize("ratio", [0.1, 0.4, 0.8])
def test_tapered_columns(n, ratio):
    """Plates tapered in width (1), lattices (2), plates tapered in thickness (3), cones (4)."""
    exact = critical_factor(n, ratio)
    q = ratio ** (1 / n)
    profile = Profile.fit(lambda s: (1 - (1 - q) * s) ** n, 1.0, tolerance=1e-10)
    # the rod's least stiffness, at its tip, counts as 1
    coarse, fine = (
        buckling(Rod.straight(1.0, profile, samples=count, supports=CANTILEVER), exact / ratio)
        for count in (401, 801)
    )
    assert (4 * fine - coarse) / 3 * ratio == pytest.approx(exact, rel=2e-6)


def test_the_factors_are_those_of_the_tables():
    """To the digits that tables of tapered columns give, for I_1 / I_2 of 0.1, 0.5 and 0.9."""
    result = {2: (1.350, 2.023, 2.392), 4: (1.203, 2.002, 2.391)}
    for n, row in result.items():
        assert [critical_factor(n, ratio) for ratio in (0.1, 0.5, 0.9)] == pytest.approx(row, abs=6e-4)


def own_weight_factor(n, p, samples):
    """m of a column clamped at its foot, E I ~ (1 - s)^n and weight ~ (1 - s)^p, that buckles under m E I / l^2."""
    left = 1 - np.linspace(0.0, 1.0, samples)
    EI = np.maximum(left**n, 1e-4)  # of the foot 1
    share = Profile.interpolate(1 - left, left**p * (p + 1))  # its whole is 1
    line = Rod.straight(
        1.0, EI, samples=samples, angle=np.pi / 2, supports=CANTILEVER, gravity=Gravity(1.0), weight=Weight(),
        bending_stiffness=float(EI.min()),
    )  # fmt: skip

    def margin(whole):
        heavy = replace(line, weight=Weight(alpha=share.scaled(whole)))
        return stability(bend(heavy, guess=heavy)).margin

    return brentq(margin, 4.0, 20.0, rtol=1e-6)


@pytest.mark.parametrize(("n", "p", "printed"), [(0, 0, 7.84), (1, 0, 5.78), (0, 1, 16.1), (1, 1, 13.0)])
def test_columns_that_buckle_under_their_own_weight(n, p, printed):
    """Timoshenko, Theory of Elastic Stability, pages 138 and 139: m in (Q)cr = m E I / l^2, Q the whole weight.

    Page and values as the tests of NREL's pBEAM quote them (src/runTests/testBeam.cpp, "buckling_tapered").
    """
    last_digit = 0.01 if printed < 10 else 0.1
    assert own_weight_factor(n, p, 401) == pytest.approx(printed, abs=last_digit / 2)


def test_the_strongest_column():
    """4/3 of the load of an even rod of the same volume (Keller 1960, Arch. Rational Mech. Anal. 5, 275-285).

    Clausen's shape (Über die Form architektonischer Säulen, 1849, 279-294): area A ~ sin^2 theta at
    s = (theta - sin(2 theta) / 2) / pi, and E I ~ A^2. It buckles as y = sin^3 theta: ds / dtheta is
    (2 / pi) sin^2 theta, so y' = (3 pi / 2) cos theta, y'' = -(3 pi^2 / 4) / sin theta, and A^2 y'' + m y = 0 all
    along with m = 3 pi^2 / 4. An even rod of the mean area 3/4 has m = (3/4)^2 pi^2; the quotient is 4/3.
    """
    theta = np.linspace(0.0, np.pi, 200001)
    s = (theta - np.sin(2 * theta) / 2) / np.pi
    law = RoundLaw(MATERIAL, 0.1, 10.0)
    nodes = np.linspace(0.0, 1.0, 1601)
    area = np.maximum(np.interp(nodes, s, np.sin(theta) ** 2), 2e-3)
    diameter = np.sqrt(4 * area / np.pi)
    K = law.bending_stiffness(diameter)
    even = float(law.bending_stiffness(np.sqrt(4 * 0.75 / np.pi)))  # the mean of sin^2 theta over s is 3/4
    load = buckling(Rod.straight(1.0, K, samples=1601, supports=HINGES), 4 / 3 * np.pi**2 * even / K.min())
    assert load * K.min() / (np.pi**2 * even) == pytest.approx(4 / 3, rel=2e-4)


def tip(K, load=1e-5, samples=801):
    """Deflection of the tip of a cantilever over P L^3 / (E I) of the root for a small load, and the rod."""
    rod = bend(Rod.straight(1.0, K, samples=samples, supports=CANTILEVER), force=(0.0, -load))
    root = float(rod.stiffness[0])
    return -float(rod.position[-1, 1]) / load * root, rod


@pytest.mark.parametrize("n", [1, 2, 3, 4])
@pytest.mark.parametrize("ratio", [0.2, 0.6])
def test_tapered_cantilevers(n, ratio):
    """Linear theory: the moment P (1 - s) turns each piece by P (1 - s) / E I, which moves the tip by 1 - s of it.

    So the deflection is P l^3 / (E I of the root) times the integral of (1 - s)^2 / (1 - (1 - q) s)^n. I varies as
    (1 + K x / l)^n, as in the tables of tapered beams of Roark's Formulas for Stress and Strain, whose page was not
    at hand: the integral is worked out below.
    """
    q = ratio ** (1 / n)
    c = 1 - q

    def primitive(u):
        """Of (u - q)^2 / u^n, where u = 1 - c s and (1 - s) = (u - q) / c."""
        terms = ((1.0, 2 - n), (-2 * q, 1 - n), (q**2, -n))
        return sum(k * (np.log(u) if p == -1 else u ** (p + 1) / (p + 1)) for k, p in terms)

    exact = (primitive(1.0) - primitive(q)) / c**3
    profile = Profile.fit(lambda s: (1 - c * s) ** n, 1.0, tolerance=1e-10)
    coarse, fine = (tip(profile, samples=count)[0] for count in (401, 801))
    assert (4 * fine - coarse) / 3 == pytest.approx(exact, rel=1e-6)


def test_a_cantilever_of_a_textbook():
    """Yang, Finite Element Structural Analysis, page 180: I falls in a line from 9 I to I, a load P at the tip.

    The tip moves by 0.051166 P L^3 / (E I) and turns by 0.090668 P L^2 / (E I). Page and values as the tests of
    NREL's pBEAM quote them (src/runTests/testBeam.cpp, "tapered_deflections").
    """
    load = 1e-5
    moved, turned = [], []
    for samples in (401, 801):
        taper = 9 - 8 * np.linspace(0.0, 1.0, samples)
        rod = bend(Rod.straight(1.0, taper, samples=samples, supports=CANTILEVER), force=(0.0, -load))
        moved.append(-float(rod.position[-1, 1]) / load)
        turned.append(-float(rod.angle[-1]) / load)
    for (coarse, fine), printed in ((moved, 0.051166), (turned, 0.090668)):
        assert (4 * fine - coarse) / 3 == pytest.approx(printed, abs=6e-7)


TABULATED = {
    "parabola": 8.0,  # Hicks, page 54: width constant, depth by a parabola
    "triangular": 6.0,  # Hicks, page 55; Machinery's Handbook, page 345: depth constant, plan a triangle
}


@pytest.mark.parametrize("kind", TABULATED)
def test_springs_of_uniform_strength_as_tabulated(kind):
    """Deflection over P l^3 / (E b h^3) and stress over P l / (b h^2) of cantilevers of uniform strength.

    Hicks, Civil Engineering Formulas, figure 2.17 "Beams of uniform strength (in bending)", pages 54 and 55;
    Machinery's Handbook, 31st edition, table 3a "Beams of Uniform Strength Throughout Their Length", page 271
    (shapes, stress), and table 19 "Formulas for Flat Springs", page 345 (t^3 = 6 P L^3 / (E b y) of the triangle).
    """
    b, h, length, load = 20.0, 4.0, 300.0, 1e-4
    nodes = np.linspace(0.0, 1.0, 4001)
    left = np.maximum(1 - nodes, 1e-6)
    if kind == "parabola":
        law = ThicknessLaw(MATERIAL, 1e-4, 10.0, width=b)
        size = h * np.sqrt(left)
    else:
        law = PlainSection(
            Sheet("any", h, 12000.0, density=1000.0, max_strain=0.01, poisson_ratio=0.0), 1e-5, b
        )
        size = b * left
    EI = law.bending_stiffness(size)
    straight = Rod.straight(length, EI, samples=nodes.size, supports=CANTILEVER)
    rod = bend(straight, force=(0.0, -load / float(EI.min())))
    deflection = -float(rod.position[-1, 1]) / (load * length**3 / (12000.0 * b * h**3))
    assert deflection == pytest.approx(TABULATED[kind], rel=1e-3)
    stress = 12000.0 * law.strains(rod.curvature, size)[0].strain / (load * length / (b * h**2))
    assert stress[nodes < 0.98] == pytest.approx(6.0, rel=2e-3)


@pytest.mark.parametrize("kind", ["triangular", "parabola of third order", "parabola"])
def test_springs_of_uniform_strength(kind):
    """Timoshenko, Strength of Materials, on beams of constant strength: a cantilever with a load at its tip.

    The strain is M t / (2 E I) and I ~ w t^3, M ~ 1 - s. Triangular in plan: w ~ 1 - s gives constant strain and
    an arc of a circle, the integral of (1 - s) being 1/2: P L^3 / (2 E I). The same curvature comes of a thickness
    ~ (1 - s)^(1/3); the same strain of one ~ (1 - s)^(1/2), whose curvature ~ (1 - s)^(-1/2) moves the tip by the
    integral of (1 - s)^(1/2): 2 P L^3 / (3 E I).
    """
    nodes = np.linspace(0.0, 1.0, 4001)
    left = np.maximum(1 - nodes, NARROW)
    law = ThicknessLaw(MATERIAL, 1e-4, 10.0, width=10.0)
    power = {"triangular": 0.0, "parabola of third order": 1 / 3, "parabola": 1 / 2}[kind]
    thickness = left**power
    width = left if kind == "triangular" else np.ones_like(left)
    K = width * law.bending_stiffness(thickness)
    deflection, rod = tip(K, load=1e-5 / NARROW ** (1 if kind == "triangular" else 3 * power), samples=4001)
    exact = 2 / 3 if kind == "parabola" else 1 / 2
    assert deflection == pytest.approx(exact, rel=1e-3)
    inner = nodes < 0.98
    strain = (law.strains(rod.curvature, thickness)[0].strain if power else np.abs(rod.curvature))[inner]
    even = strain if kind != "parabola of third order" else np.abs(rod.curvature)[inner]
    assert np.ptp(even) < 1e-3 * even.mean()
