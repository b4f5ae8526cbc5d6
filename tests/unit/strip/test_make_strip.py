"""One call from a drawn curve to a strip."""

import pickle

import numpy as np
import pytest

from elastica_cad import Gravity, InputError, Keep, Laminated, PlaneCurve, Sheet, Tab, make_strip
from tests.refusals import refusal_test

pytestmark = pytest.mark.core

ARCH = PlaneCurve.spline([(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)])


def test_follows_a_realizable_curve_exactly():
    strip = make_strip(ARCH, "birch-plywood-0.8", max_width=30, label="A")
    assert strip.rod.curve is ARCH
    assert strip.width.extremes[1] == pytest.approx(30)
    assert strip.label == "A"


def test_gravity_is_the_sheets_own_or_any():
    sheet = Sheet.named("card-200gsm")
    assert make_strip(ARCH, sheet, max_width=20, gravity=True).rod.gravity == sheet.gravity()
    assert make_strip(ARCH, sheet, max_width=20, gravity=False).rod.gravity is None
    sideways = sheet.gravity((1.0, 0.0))
    assert make_strip(ARCH, sheet, max_width=20, gravity=sideways).rod.gravity is sideways


test_bad_input = refusal_test(
    [
        (lambda: make_strip(ARCH, 3, max_width=20), "the sheet is an int"),
        (lambda: make_strip(ARCH, "paper", max_width=20), "unknown sheet"),
    ]
)


class TestLaminateWithWeight:
    """Both layers weigh: the rod that stands upright is not the one of a plain strip."""

    STYLE = Laminated(width=20.0, backing=Sheet.named("card-200gsm"))
    ENDS = (Tab(0), Tab(0))

    def test_weight_of_both_layers(self):
        strip = make_strip(ARCH, "card-200gsm", style=self.STYLE, gravity=True, ends=self.ENDS)
        weightless = make_strip(ARCH, "card-200gsm", style=self.STYLE, ends=self.ENDS)
        start, end = strip.rod.force[[0, -1], 1] * strip.rod.bending_stiffness
        assert abs(end - start) == pytest.approx(strip.mass * 1e-3 * 9.80665, rel=2e-3)
        assert np.abs(strip.rod.stiffness - weightless.rod.stiffness).max() > 1e-3
        assert not any("optimal_laminate" in text for text in strip.warnings)

    def test_width_as_a_function(self):
        def width(s):
            return 18 + 0.02 * s

        style = Laminated(width=width, backing=Sheet.named("card-200gsm"))
        strip = make_strip(ARCH, "card-200gsm", style=style, gravity=True)
        assert strip.layout.backing.width(0.0) <= 18 + 1e-6

    @pytest.mark.parametrize("options", [{"keep": Keep()}, {"natural_curvature": 1e-3}])
    def test_follows_its_curve_exactly(self, options):
        with pytest.raises(InputError, match="a laminate can only be made for the drawn curve"):
            make_strip(ARCH, "card-200gsm", style=self.STYLE, gravity=True, **options)

    def test_gravity_of_another_sheet(self):
        with pytest.raises(InputError, match="Make this plane vertical"):
            make_strip(ARCH, "card-200gsm", style=self.STYLE, gravity=Gravity(50.0, (0, -1)))


def test_a_field_that_no_strip_has_is_named_with_the_nearest_that_it_has():
    with pytest.raises(
        TypeError, match=r"maxwidth is not an option of a strip: did you mean max_width\?"
    ) as result:
        make_strip(ARCH, "card-200gsm", maxwidth=30)
    assert isinstance(result.value, InputError)


def test_a_strip_travels_with_all_that_was_requested_of_it():
    """Workers hand strips back whose strains have been looked at."""
    strip = make_strip(ARCH, Sheet.named("birch-plywood-0.8"), max_width=40.0)
    result = strip.most_strained.largest
    again = pickle.loads(pickle.dumps(strip))
    assert again.most_strained.largest == result
    np.testing.assert_array_equal(again.table()["width_mm"], strip.table()["width_mm"])
