"""The report of a strip that is planed or turned tells the body that it has, not the sheet that was named."""

from inspect import signature

import pytest

from elastica_cad import PlaneCurve, Sheet, make_strip
from elastica_cad.design import report_strip
from elastica_cad.design.strip_request import RECORDS
from elastica_cad.mechanics import Leaf, RoundLaw, ThicknessLaw
from elastica_cad.mechanics.cross_sections import SECTION_KINDS

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
    answer = report_strip(make_strip(ARCH, GLASS, section=law), name="T", files={})
    (layer,) = answer["layers"]
    assert layer["mass"] == answer["mass"]
    assert layer["thickness"] == pytest.approx(4.0, rel=1e-3)
    assert layer["sheet"] == "glass"


@pytest.mark.parametrize("kind", SECTION_KINDS)
def test_each_family_of_sections_takes_another_sheet_and_is_read_from_reports(kind):
    thin, thick = Sheet.named("birch-plywood-0.8"), Sheet.named("birch-plywood-3")
    values = {"limits": (1.0, 4.0), "width": 20.0, "bore": 0.5, "leaves": 4, "fewest": 1}
    make = SECTION_KINDS[kind]
    section = make(thin, **{name: values[name] for name in [*signature(make).parameters][1:]})
    assert section.with_sheet(thick).sheet == thick
    finished = section.laid([Leaf(1, 0.0, 100.0)]) if kind == "leaves" else section
    assert any(isinstance(finished, record) for record in RECORDS.values())
