"""Strips whose curve may change to meet limits (needs HiGHS)."""

from dataclasses import replace

import pytest

from elastica_cad import (
    InputError,
    Keep,
    Limits,
    NotConvergedError,
    NotRealizable,
    Perforated,
    PlaneCurve,
    Sheet,
    make_strip,
    nearest_rod,
)

ARCH = PlaneCurve.spline([(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)])
WAVE = PlaneCurve.spline([(0, 0), (20, 50), (50, -40), (80, 55), (110, -30), (140, 0)], degree=4)


def _pieces(poles):
    """Return the curve of cubic Bezier pieces."""
    count = (len(poles) - 1) // 3
    inner = [knot for knot in range(1, count) for _ in range(3)]
    return PlaneCurve([0] * 4 + inner + [count] * 4, poles, 3)


def test_limits_allow_the_curve_to_move():
    with pytest.raises(NotRealizable):
        make_strip(WAVE, "card-200gsm", max_width=20)
    strip = make_strip(WAVE, "card-200gsm", max_width=20, limits=Limits(ratio=4.0))
    assert strip.rod.ratio <= 4.0 * (1 + 1e-6)
    assert strip.rod.position[0] == pytest.approx(WAVE.sample(2).position[0], abs=1e-3)


def test_keep_alone_requests_the_nearest_rod_too():
    assert make_strip(ARCH, "card-200gsm", max_width=20, keep=Keep(ends=True)).rod.curve is not ARCH


def test_both_widths_bound_the_ratio():
    """Equal ones ask for an even strip; a least width above the largest is the user's, not the sheet's."""
    even = make_strip(ARCH, "card-200gsm", max_width=20, min_width=20, limits=Limits())
    assert even.width.extremes == pytest.approx((20, 20))
    with pytest.raises(InputError, match="min_width is 25 mm, more than max_width"):
        make_strip(ARCH, "card-200gsm", max_width=20, min_width=25, limits=Limits())


@pytest.mark.parametrize(
    "options", [{"max_width": 30}, {"max_width": 8}, {"min_width": 8}, {"min_width": 21}]
)
def test_widths_stay_within_the_limit_width(options):
    """A strip of 30 mm had been made under limits that end at 20 mm."""
    with pytest.raises(InputError, match=r"_width is \d+ mm, outside the limits of the width, 10 to 20 mm"):
        make_strip(ARCH, "card-200gsm", **options, limits=Limits(width=(10, 20)))


@pytest.mark.parametrize("options", [{"max_width": 15.0}, {"min_width": 14.0}])
def test_a_limit_width_bounds_both_places(options):
    """With the widest place of 15 mm, the quotient of the limits alone had left 7.5 mm at the narrowest."""
    strip = make_strip(WAVE, "card-200gsm", **options, limits=Limits(width=(10, 20)))
    low, high = strip.width.extremes
    assert low >= 10 * (1 - 1e-5)
    assert high <= 20 * (1 + 1e-5)
    assert (
        make_strip(ARCH, "card-200gsm", style=Perforated(40.0), limits=Limits(width=(10, 20))).rod.ratio
        <= 2.001
    )


@pytest.mark.parametrize("margin", [None, 5.0])
@pytest.mark.parametrize(
    ("poles", "width"),
    [
        ("5,-88 33,-18 69,34 99,79 134,80 155,36 187,42 230,0 261,-13", 12),
        ("3,-29 66,-39 118,78 168,96 214,9 267,30 314,-72 379,13 446,-5", 20),
        ("4,-7 43,-55 76,-8 117,-26 153,67 195,62 242,-59 296,-118 329,-16", 20),
    ],
)
def test_a_steel_strip_is_not_narrower_than_the_workshop_can_cut(poles, width, margin):
    """The widths that correct anticlastic bending had been up to 1 % below the 3 mm of the sheet."""
    curve = PlaneCurve.spline([tuple(map(float, pole.split(","))) for pole in poles.split()], degree=3)
    strip = make_strip(curve, "spring-steel-0.2", max_width=width, limits=Limits(margin=margin))
    assert 3 <= strip.width.extremes[0] < 3.3


WAVES = _pieces(
    [(0, 0), (38, 0), (52, 62), (92, 62), (132, 62), (140, -12), (180, -12), (232, -12), (240, 112),
     (300, 112), (358, 112), (372, -2), (420, -2), (450, -2), (472, 30), (490, 40)]
)  # fmt: skip


def test_a_stable_strip_is_not_narrower_than_the_workshop_can_cut():
    """The search with a margin narrows the whole strip by 1 % or more, and the strip was refused as too narrow."""
    strip = make_strip(WAVES, "pom-1", max_width=43, limits=Limits(margin=5.0))
    assert 3 <= strip.width.extremes[0] < 3.3
    assert strip.width.extremes[1] <= 43


@pytest.mark.parametrize(("sheet", "least"), [("pom-1", 7), ("spring-steel-0.2", 4)])
def test_a_stable_strip_is_not_narrower_than_its_least_width(sheet, least):
    bend = _pieces(
        [(140, 0), (118, 55), (30, 55), (30, -20), (30, -105), (155, -80), (155, -165), (155, -250),
         (45, -250), (20, -185)]
    )  # fmt: skip
    strip = make_strip(bend, sheet, min_width=least, limits=Limits(margin=5.0))
    assert strip.width.extremes[0] == pytest.approx(least, rel=1e-5)


def test_a_stable_strip_may_be_narrower_than_without_the_margin():
    """With a margin, the search kept the narrowest place of the strip without it, 3.26 mm."""
    poles = [(62, -30), (118, 40), (190, -35), (254, -59), (328, 65), (398, 6), (462, 38)]
    strip = make_strip(
        PlaneCurve.spline(poles, degree=3), "spring-steel-0.2", max_width=25, limits=Limits(margin=5.0)
    )
    assert 3 <= strip.width.extremes[0] < 3.3


def test_limits_of_another_thickness_are_refused():
    thin = Sheet.named("card-200gsm")
    with pytest.raises(
        InputError, match=r"the limits are for card-200gsm, 0\.2 mm thick, but the strip is of birch-ply"
    ):
        make_strip(ARCH, "birch-plywood-0.8", max_width=20, limits=Limits(sheet=thin))
    other = replace(thin, max_strain=1.1 * thin.max_strain)
    assert make_strip(ARCH, thin, max_width=20, limits=Limits(sheet=other)).rod.ratio > 1


@pytest.mark.campaign
def test_limits_that_no_rod_meets():
    """A strip this straight cannot span an arch whose ends must keep their steep tangents: say what would help."""
    limits, keep = Limits(curvature=1e-3), Keep(ends=True, tangents=True)
    with pytest.raises(NotConvergedError) as refused:
        make_strip(ARCH, "card-200gsm", max_width=20, limits=limits, keep=keep)
    card = Sheet.named("card-200gsm")  # whose strain and least width are kept too
    implied = replace(limits, sheet=card, ratio=20 / card.least_width)
    text, expected = str(refused.value), str(nearest_rod(ARCH, implied, keep))
    assert text == expected.replace(
        "the ratio limit",
        "the ratio of largest to least width, now 13.3 (max_width; min_width or shop.least_width)",
    )
    assert "radius" in text


def test_a_search_that_keeps_the_width_at_nodes_gives_a_strip():
    """Between them its stiffness rises by 1e-4 at a joint of the curve, and the strip was refused as too wide."""
    knots, poles = (
        [0, 0, 0, 0, 1, 1, 1, 2, 2, 2, 2],
        [(20, 0), (60, 70), (100, 70), (140, 0), (180, -70), (220, -70)],
    )
    wave, sheet = PlaneCurve(knots, [*poles, (260, 0)], 3), Sheet.named("pom-1")
    strip = make_strip(wave, sheet, max_width=20, gravity=sheet.gravity(), limits=Limits(ratio=3), smooth=0.6)
    assert strip.width.extremes[1] == pytest.approx(20, rel=1e-5)
    assert strip.rod.ratio < 3
