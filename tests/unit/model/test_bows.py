"""Bows under a cord: even ones against elliptic integrals, tapered ones against the program with a tie."""

import numpy as np
import pytest
from scipy.optimize import brentq
from scipy.special import ellipe, ellipk

import elastica_cad as ec
from elastica_cad.mechanics import RoundLaw
from elastica_cad.model.batten import bench_drawing
from elastica_cad.model.bows import bow
from elastica_cad.strip.holding_template import held_ends, holding_template

E, DIAMETER = 38000.0, 8.0
GLASS = ec.Sheet("glass", DIAMETER, E, density=1900.0, max_strain=0.02)
EVEN = RoundLaw(GLASS, DIAMETER, DIAMETER)


def elastica(cord, length):
    """Pull over E I, rise and end angle of the inflectional elastica between its end inflections."""
    m = brentq(lambda m: 2 * ellipe(m) / ellipk(m) - 1 - cord / length, 1e-9, 0.99)
    return (2 * ellipk(m) / length) ** 2, length * np.sqrt(m) / ellipk(m), 2 * np.arcsin(np.sqrt(m))


def drawn(cord, length, rng):
    """A lopsided curve of this length between two points at this distance, turned at random."""
    skew = rng.uniform(0.2, 0.8)

    def through(height):
        points = [(0, 0), (skew * cord, 1.3 * height), (0.6 * cord, height), (cord, 0)]
        return ec.PlaneCurve.spline(points, degree=3)

    height = brentq(lambda height: through(height).length - length, 1e-3 * length, 2 * length)
    angle = rng.uniform(-3, 3)
    turn = np.array([[np.cos(angle), -np.sin(angle), 50], [np.sin(angle), np.cos(angle), -20], [0, 0, 1]])
    return through(height).transformed(turn)


@pytest.mark.parametrize("seed", range(10))
def test_an_even_bow_is_the_inflectional_elastica(seed):
    rng = np.random.default_rng(seed)
    length, share = rng.uniform(200, 2000), rng.uniform(0.2, 0.98)
    curve = drawn(share * length, length, rng)
    made = bow(curve, GLASS, section=EVEN)
    pull, rise, angle = elastica(made.cord, curve.length)
    assert made.cord == pytest.approx(share * length, rel=1e-9)
    assert made.length == pytest.approx(curve.length, rel=1e-12)
    assert made.pull == pytest.approx(pull * E * np.pi * DIAMETER**4 / 64, rel=1e-6)
    assert made.rise == pytest.approx(rise, rel=1e-6)
    assert made.end_angles == pytest.approx([angle, -angle], rel=1e-6)
    shorter = made.shortened([0.1])
    pull, _, _ = elastica(0.9 * made.cord, curve.length)
    # a shorter cord also compresses the rod along its length
    assert np.hypot(*shorter.end_force[0]) == pytest.approx(pull * E * np.pi * DIAMETER**4 / 64, rel=1e-4)


@pytest.mark.parametrize("side", [1, -1])
def test_the_bow_bulges_as_the_drawn_curve(side):
    made = bow(
        ec.PlaneCurve.spline([(0, 0), (60, 150 * side), (200, 150 * side), (300, 0)], degree=3),
        GLASS,
        section=EVEN,
    )
    assert made.strip.rod.position[1200, 1] * side > 50
    assert made.end_angles[0] * side > 0
    assert made.deviation < 20


def test_a_strip_of_constant_width_is_an_even_bow():
    arc = ec.PlaneCurve.arc((0, 0), 300, 2.5, 0.6)
    made = bow(arc, "birch-plywood-0.8", max_width=15, min_width=15)
    sheet = ec.Sheet.named("birch-plywood-0.8")
    pull, rise, _ = elastica(made.cord, arc.length)
    assert made.strip.width.extremes == (15, 15)
    assert made.pull == pytest.approx(pull * sheet.youngs_modulus * 15 * 0.8**3 / 12, rel=0.02)
    assert made.rise == pytest.approx(rise, rel=1e-3)


def test_a_shorter_cord_is_a_shorter_tie():
    """The bow between pins against the rod with free ends and a tie of given length."""
    made = bow(ec.PlaneCurve.arc((0, 0), 300, 2.5, 0.6), GLASS, section=EVEN)
    curve = made.strip.rod.curve
    tied = ec.optimal_rod(curve, supports=ec.Supports("free", "free"), between=ec.Tie(0, curve.length))
    shorter = made.shortened([0.05, 0.2])
    for k, share in enumerate((0.05, 0.2)):
        bent = ec.bend(tied, between=ec.Tie(0, curve.length, length=(1 - share) * made.cord))
        pull = np.hypot(*bent.between_forces[0]) * made.strip.bending_stiffness
        assert np.hypot(*shorter.end_force[k]) == pytest.approx(pull, rel=1e-4)


STRAIGHT_AT_ENDS = [(0, 0), (60, 90), (120, 180), (580, 180), (640, 90), (700, 0)]


def test_a_tapered_bow_is_the_rod_with_a_tie_between_free_ends():
    curve = ec.PlaneCurve.spline(STRAIGHT_AT_ENDS, degree=4)
    sheet = ec.Sheet("bendy", 1.0, 10000.0, density=700.0, max_strain=0.05)
    made = bow(curve, sheet, max_width=30)
    assert made.deviation < 0.2  # the jumps of its third derivative are smoothed
    drawn = made.strip.rod.shape
    tied = ec.optimal_rod(drawn, supports=ec.Supports("free", "free"), between=ec.Tie(0, drawn.length))
    pull = np.hypot(*tied.between_forces[0]) * 10000.0 * 30 / tied.ratio / 12
    assert made.pull == pytest.approx(pull, rel=1e-4)
    assert made.strip.rod.ratio == pytest.approx(tied.ratio, rel=1e-4)


def test_a_tapered_bow_runs_straight_at_both_ends():
    arc = ec.PlaneCurve.arc((0, 0), 300, 2.5, 0.6)
    with pytest.raises(ec.NotRealizable, match="free to turn, so the curvature there must be 0"):
        bow(arc, "birch-plywood-0.8", max_width=60)
    near = bow(arc, "birch-plywood-0.8", max_width=60, limits=ec.Limits())
    assert 0.01 < near.deviation < 10


@pytest.mark.parametrize(
    ("points", "problem"),
    [([(0, 0), (50, 0), (100, 0)], "straight"), ([(0, 0), (90, 10), (50, 90), (0, 0)], "closed")],
)
def test_a_cord_bends_open_arches_only(points, problem):
    with pytest.raises(ec.InputError, match=f"The curve is {problem}"):
        bow(ec.PlaneCurve.spline(points, degree=2), GLASS, section=EVEN)


@pytest.mark.parametrize("share", [-0.1, 1.0, np.nan])
def test_a_cord_keeps_some_length(share):
    made = bow(ec.PlaneCurve.arc((0, 0), 300, 2.5, 0.6), GLASS, section=EVEN)
    with pytest.raises(ec.InputError, match="The cord cannot be shortened by"):
        made.shortened([share])


def test_an_even_bow_has_no_limits():
    with pytest.raises(ec.InputError, match="limits is not an option of a bow of constant section"):
        bow(ec.PlaneCurve.arc((0, 0), 300, 2.5, 0.6), GLASS, section=EVEN, limits=ec.Limits())


def test_the_sheets_of_an_even_rod_name_its_diameter_and_its_angles():
    """A rod of one diameter is not turned, and its pinned ends are shown with the angles at which they rest."""
    law = RoundLaw(ec.Sheet.named("glass-rod-4"), 4.0, 4.0)
    curve = ec.PlaneCurve.spline([(0, 0), (150, 110), (310, 150), (470, 110), (620, 0)])
    rod = ec.make_strip(
        curve,
        law.sheet,
        section=law,
        limits=ec.Limits(ratio=1.0),
        supports=ec.Supports("pinned", "pinned"),
        label="P",
    )
    lines = [text.text for text in bench_drawing(rod).texts]
    assert "round, 4 mm in diameter" in " ".join(lines)
    assert not any("turn it" in line for line in lines)
    (start,) = (text.text for text in holding_template(rod).texts if text.text.startswith("start (1): "))
    assert start == f"start (1): strip {held_ends(rod)[0].tilt:.1f} degrees to the left, free to turn"


def test_the_strain_warning_of_a_rod_mentions_no_sheet():
    arc = ec.PlaneCurve.arc((0, 0), 150, 0.8 * np.pi, 0.2 * np.pi)
    rod = bow(arc, GLASS, section=RoundLaw(GLASS, DIAMETER, DIAMETER)).strip
    (message,) = rod.strain_warnings
    assert "Use thinner material, or a radius of at least" in message
    assert "sheet" not in message
