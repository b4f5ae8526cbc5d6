"""One call from a drawn curve to a strip."""

import pytest

from elastica_cad.errors import InputError
from elastica_cad.fabrication.making import make_strip
from elastica_cad.forming import Limits
from elastica_cad.geometry import PlaneCurve
from elastica_cad.mechanics import Sheet

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


def test_bad_input():
    with pytest.raises(InputError, match="not int"):
        make_strip(ARCH, 3, max_width=20)
    with pytest.raises(InputError, match="unknown sheet"):
        make_strip(ARCH, "paper", max_width=20)
    with pytest.raises(InputError, match="natural curvature"):
        make_strip(ARCH, "card-200gsm", max_width=20, natural_curvature=0.01, limits=Limits(ratio=3))
