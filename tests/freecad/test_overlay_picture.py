"""What the overlay shows, as points: no window needed."""

from dataclasses import replace

import numpy as np
import pytest
from freecad.elastica_wb.live.curve_picture import comb_scale, curve_picture, width_lines
from freecad.elastica_wb.solving.strip_cache import solve_strip
from freecad.elastica_wb.solving.verdicts import Verdict, refusal_answer, strip_answer

from elastica_cad import NotRealizable, Perforated, PlaneCurve, Sheet, StripSpec, check_equilibrium

ARCH = PlaneCurve.spline([(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)])
WAVE = PlaneCurve.spline([(0, 0), (25, 55), (60, 45), (95, -50), (130, -40), (150, 0)])
SNAKE = PlaneCurve.spline([(0, 0), (40, 60), (80, -60), (120, 60), (160, -10), (200, 90)])


def picture_of(curve):
    return StripSpec(curve, Sheet.named("birch-plywood-0.8"), max_width=30.0)


def test_an_arch_has_a_comb_and_no_line():
    picture = curve_picture(ARCH, picture_of(ARCH))
    assert picture.realizable
    assert picture.line is None
    assert picture.on_line.shape == (0, 2)
    rim, *teeth = picture.comb
    samples = ARCH.sample(len(rim))
    height = np.hypot(*(rim - samples.position).T)
    assert height == pytest.approx(comb_scale(ARCH) * np.abs(samples.curvature))
    assert len(teeth) == len(rim)
    # the arch bends to the right, its comb stands on the outer side
    assert rim[len(rim) // 2, 1] > samples.position[len(rim) // 2, 1]


def test_a_wave_has_its_inflection_on_the_line():
    picture = curve_picture(WAVE, picture_of(WAVE))
    assert picture.realizable
    assert picture.on_line == pytest.approx(WAVE.at(WAVE.inflections).position)
    a, b = picture.line
    along, off = (b - a) / np.hypot(*(b - a)), picture.on_line[0] - a
    assert abs(along[0] * off[1] - along[1] * off[0]) < 1e-9
    assert picture.answer.sentence.endswith(".")


def test_inflections_off_the_line_say_how_far():
    picture = curve_picture(SNAKE, picture_of(SNAKE))
    check = check_equilibrium(SNAKE)
    assert len(check.inflections) >= 2
    assert picture.realizable is check.realizable is False
    off = {s: d for s, d in check.off_line if abs(d) > 1e-4 * check.length}
    assert len(picture.off_line) == len(off) >= 2
    assert [place for _, place in picture.labels] == pytest.approx(check.inflections), (
        "as the sentence has them"
    )
    assert picture.answer.sentence == check.reasons[0]


def test_the_comb_has_another_colour_where_the_sheet_bears_no_more():
    sharp = PlaneCurve.spline([(0, 0), (40, 60), (80, -60), (120, 60), (160, -10), (200, 90)])
    picture = curve_picture(sharp, picture_of(sharp))
    bend = 1 / picture_of(sharp).material.least_radius
    samples = sharp.sample(161)
    teeth = [line for line in picture.strained if len(line) == 2]
    beyond = np.abs(samples.curvature) > bend
    assert 0 < beyond.sum() < 161
    roots = [tuple(tooth[0]) for tooth in teeth if tuple(tooth[0]) in set(map(tuple, samples.position))]
    assert len(roots) == beyond.sum()
    assert curve_picture(ARCH.transformed(np.diag([2.0, 2.0, 1.0])), picture_of(ARCH)).strained == ()


def test_the_width_lies_along_the_curve():
    strip = solve_strip(picture_of(ARCH))
    left, right = width_lines(strip, 41)
    s = np.linspace(0, ARCH.length, 41)
    assert np.hypot(*(left - right).T) == pytest.approx(strip.width(s), abs=1e-6)
    assert (left + right) / 2 == pytest.approx(ARCH.sample(41).position, abs=1e-9)
    assert "20.8 to 30 mm wide" in strip_answer(strip).sentence


def test_an_even_width_is_reported_once():
    even = replace(picture_of(ARCH), style=Perforated(width=30.0), max_width=None)
    assert strip_answer(solve_strip(even)).sentence.startswith(
        "A flat strip can be bent into this curve: 30 mm wide, stiffness"
    )


def test_closed_curves_are_judged_like_others():
    wide, narrow = (PlaneCurve.ellipse((0, 0), axes) for axes in ((150, 120), (50, 30)))
    assert "can take this curve" in curve_picture(wide, picture_of(wide)).answer.sentence
    assert "would break" in curve_picture(narrow, picture_of(narrow)).answer.sentence


def test_bad_curves_are_one_sentence():
    with pytest.raises(NotRealizable) as caught:
        solve_strip(picture_of(SNAKE))
    assert refusal_answer(caught.value).sentence == caught.value.check.reasons[0]
    assert caught.value.check.reasons[0].startswith("The strip would break")
    assert caught.value.check.reasons[1:] == check_equilibrium(SNAKE).reasons


def test_straight_ends_are_tabs_in_the_overlay_too():
    straight = [(0, 0), (20, 0), (40, 0), (60, 0)], [(300, 150), (320, 150), (340, 150), (360, 150)]
    points = [*straight[0], (160, 0), (200, 150), *straight[1]]
    curve = PlaneCurve([*[0] * 4, *[1] * 3, *[3] * 3, *[4] * 4], points, 3)
    assert curve_picture(curve, picture_of(curve)).realizable
    assert not curve_picture(curve, picture_of(curve).changed(straight_ends=False)).realizable
    (turn,) = solve_strip(picture_of(curve)).rod.curve.inflections
    place = solve_strip(picture_of(curve)).rod.curve.at(np.array([turn])).position
    assert curve_picture(curve, picture_of(curve)).on_line == pytest.approx(place, abs=1e-6)


@pytest.mark.parametrize("heights", [(-28, -31, -35, 46, -34), (-42, 7, -22, -2, 13)])
def test_points_that_do_not_decide_are_no_verdict(heights):
    """Before and after a strip is made: the curve fitted to the first can be bent, that to the second cannot."""
    drawn = PlaneCurve.spline(np.column_stack([60.0 * np.arange(5), heights]))
    points = PlaneCurve.fit(drawn.sample(30).position.round(4))
    spec = replace(picture_of(points), sheet=Sheet.named("card-200gsm"), ignore_limits=True)
    answers = [curve_picture(points, spec).answer]
    try:
        answers.append(strip_answer(solve_strip(spec)))
    except NotRealizable as error:
        answers.append(refusal_answer(error))
    for answer in answers:
        assert answer.words == "undecided" or "tips over" in answer.words
        assert answer.verdict is Verdict.BREAKS
    assert "The points are too few" in answers[0].sentence
