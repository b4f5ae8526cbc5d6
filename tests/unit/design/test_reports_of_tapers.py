"""The report of a strip that is planed or turned tells the body that it has, not the sheet that was named."""

import pytest

from elastica_cad import PlaneCurve, Sheet, make_strip
from elastica_cad.design import report_strip
from elastica_cad.mechanics import RoundLaw, ThicknessLaw

ARCH = PlaneCurve.spline([(0, 0), (60, 120), (140, 160), (240, 120), (300, 0)])
GLASS = Sheet("glass", 3.0, 38000.0, density=1900.0, max_strain=0.02)


@pytest.mark.parametrize(
    "law",
    [
        ThicknessLaw(GLASS, 1.0, 4.0, width=20.0),
        RoundLaw(GLASS, 1.0, 4.0),
        RoundLaw(GLASS, 1.0, 4.0, bore=0.6),
    ],
    ids=["thickness", "rod", "tube"],
)
def test_its_layer_weighs_what_it_weighs_and_is_as_thick_as_it_ever_is(law):
    told = report_strip(make_strip(ARCH, GLASS, section=law), name="T", files={})
    (layer,) = told["layers"]
    assert layer["mass"] == told["mass"]
    assert layer["thickness"] == pytest.approx(4.0, rel=1e-3)
    assert layer["sheet"] == "glass"
