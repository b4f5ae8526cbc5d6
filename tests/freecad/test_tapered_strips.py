"""A strip whose law is a thickness or a diameter, in FreeCAD: solid, valid, as heavy as the core's."""

import pytest
from freecad.elastica_wb.features import strip
from freecad.elastica_wb.features.flat import layers_of

from elastica_cad import PlaneCurve, Sheet, make_strip
from elastica_cad.mechanics import RoundLaw, ThicknessLaw
from tests.freecad.features import change

POINTS = [(0, 0), (60, 120), (140, 160), (240, 120), (300, 0)]
POM = Sheet.named("pom-1")
LAWS = {
    'kind = "thickness", limits = [0.5, 3], width = 12': ThicknessLaw(POM, 0.5, 3.0, width=12.0),
    'kind = "rod", limits = [0.5, 3]': RoundLaw(POM, 0.5, 3.0),
    'kind = "tube", limits = [0.5, 3], bore = 0.5': RoundLaw(POM, 0.5, 3.0, bore=0.5),
}


@pytest.mark.parametrize("form", ["Bent", "Flat"])
@pytest.mark.parametrize("law", LAWS)
def test_the_body_is_that_of_the_law(law, form, document, drawn):
    feature = strip.create(document, drawn(POINTS, 4))
    change(feature, Sheet="pom-1", Law=law, Form=form)
    assert feature.State == ["Up-to-date"], feature.getStatusString()
    ours = make_strip(PlaneCurve.spline(POINTS, degree=4), POM, section=LAWS[law])
    assert feature.Shape.isValid()
    assert feature.Shape.ShapeType == "Solid"
    assert feature.Shape.Volume == pytest.approx(ours.mass / POM.density * 1e6, rel=1e-4)


def test_a_law_that_no_strip_has_is_reported(document, drawn):
    feature = strip.create(document, drawn(POINTS, 4))
    change(feature, Sheet="pom-1", Law='kind = "rod", limits = [3, 1]')
    assert "diameter limits are 3 and 1 mm" in feature.getStatusString()


def test_a_law_that_cannot_be_read_is_shown_how(document, drawn):
    feature = strip.create(document, drawn(POINTS, 4))
    change(feature, Sheet="pom-1", Law="thickness")
    shown = feature.getStatusString().partition("such as ")[2].rstrip(".")
    feature.Law = shown.replace("[3, 8]", "[0.5, 3]")  # as thick as the curve can be
    document.recompute()
    assert feature.State == ["Up-to-date"], feature.getStatusString()


@pytest.mark.campaign
def test_leaves_are_a_compound_of_bodies(document, drawn):
    leaf = 'kind = "leaves", leaves = 4, width = 12'
    feature = strip.create(document, drawn(POINTS, 4))
    feature.Sheet, feature.Law, feature.Follow = "birch-plywood-0.8", leaf, "Nearest"
    feature.LimitMargin, feature.RatioLimit = False, 0.0
    for form in ("Bent", "Flat"):
        change(feature, Form=form)
        assert feature.State == ["Up-to-date"], feature.getStatusString()
        assert feature.Shape.isValid()
        assert len(feature.Shape.Solids) > 1
        assert feature.Shape.Volume == pytest.approx(
            sum(solid.Volume for solid in feature.Shape.Solids), rel=1e-3
        )


def test_properties_of_a_kind_not_chosen_are_grey_and_without_effect(document, drawn):
    feature = strip.create(document, drawn(POINTS, 4))
    names = {
        "MaxWidth",
        "Compensate",
        "OuterWidth",
        "Columns",
        "Backing",
        "RatioLimit",
        "KeepLine",
        "KeepPoints",
        "Slots",
        "Law",
        "Style",
        "GravityLength",
        "NaturalCurvature",
    }

    def grey():
        return {name for name in names if "ReadOnly" in feature.getEditorMode(name)}

    exact = {"OuterWidth", "Columns", "Backing", "RatioLimit", "KeepLine", "KeepPoints"}
    assert grey() == exact | {"GravityLength"}
    change(feature, Gravity=True, Blank="stations = [0, 400], curvatures = [0, 0]")
    assert grey() == exact | {"NaturalCurvature"}
    names -= {"GravityLength", "NaturalCurvature"}
    change(feature, Gravity=False, Blank="")
    change(feature, Sheet="pom-1", Style="Perforated", Follow="Nearest", LimitMargin=False)
    assert grey() == {"MaxWidth", "Backing"}
    change(feature, Style="Plain", Follow="Exactly", Compensate=True, Law='kind = "rod", limits = [0.5, 3]')
    assert grey() == exact | {"MaxWidth", "Compensate", "Slots", "Style"}
    assert feature.State == ["Up-to-date"], feature.getStatusString()
    rod = feature.Shape.Volume
    change(
        feature, Columns=3, RatioLimit=1.5, MaxWidth=9, KeepPoints=[5000.0], Slots=["at = 60, width = 1.2"]
    )
    assert feature.Shape.Volume == pytest.approx(rod, rel=1e-12)
    for style in ("Perforated", "Laminated"):
        change(feature, Style=style)
        assert feature.Shape.Volume == pytest.approx(rod, rel=1e-12)
        assert grey() == exact | {"MaxWidth", "Compensate", "Slots", "Style"}
        assert len(layers_of(feature)) == 1
    change(feature, Law="", Style="Plain")
    assert grey() == exact
