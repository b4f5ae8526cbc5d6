"""Names and colours that a user gives to a strip are kept by every body that is made from it."""

import copy
import pickle

import pytest

import elastica_cad as ec
from elastica_cad import InputError, Laminated, Model, Sheet, Tab
from elastica_cad.mechanics.sheets import sheet_color
from tests.cad.conftest import CURVES
from tests.cad.libraries import bd, bd_strips, cq, cq_strips

CURVE = CURVES["cubic arch"]
OPTIONS = {"max_width": 10, "ends": (Tab(12), Tab(12)), "label": "A1"}
RED = (0.8, 0.1, 0.2, 0.5)
GLUED = {"style": Laminated(width=24.0, backing=Sheet.named("birch-plywood-0.8")), "ignore_limits": True}


def numbers(color):
    return pytest.approx(color, abs=1e-6)


@pytest.mark.build123d
def test_names_and_colors_given_later_in_build123d():
    rib = bd_strips.BentStrip(CURVE, "pom-0.5", **OPTIONS)
    slider = rib.slider(end=tuple(rib.rod.position[-1] - (10, 0)))
    rib.label, rib.color = "left", bd.Color(*RED)
    twin = copy.copy(rib)
    made = [
        rib.flat, rib.bent(), rib.bent(angles=(None, 10)), rib.outline, slider.bent(5.0), bd_strips.FlatStrip(rib),
        rib.layers[0], rib.assembly.children[0], (bd.Pos(1, 2, 3) * rib).flat,
    ]  # fmt: skip
    assert {body.label for body in made} == {"left"}
    assert rib.strip.label == twin.placed.strip.label == "left"
    assert rib.placed.strip is twin.placed.strip
    for body in made:
        assert tuple(body.color) == numbers(RED)
    other = bd_strips.BentStrip(CURVE, "pom-0.5", **OPTIONS)
    whole = bd_strips.model_compound(Model([rib.placed, other.placed]))
    assert [child.label for child in whole.children] == ["left", "A1"]
    assert tuple(whole.children[0].color) == numbers(RED)
    assert tuple(whole.children[1].color)[:3] == numbers(sheet_color("pom-0.5"))
    fixture = rib.fixture()
    fixture.label = "block"
    assert (fixture.flat.label, tuple(fixture.color)[:3]) == ("left", numbers((0.30, 0.36, 0.42)))
    assert fixture.flat.label == fixture.strip.label == "left"


@pytest.mark.build123d
def test_layers_with_names_and_colors_pickle_in_build123d():
    rib = bd_strips.BentStrip(CURVE, "birch-plywood-0.8", label="L", color="red", **GLUED)
    for body in (*rib.layers, rib.backing, copy.deepcopy(rib.layers[0])):
        read = pickle.loads(pickle.dumps(body))
        assert (read.label, tuple(read.color)) == (body.label, numbers(tuple(body.color)))
    assert [tuple(layer.color)[:3] == (1, 0, 0) for layer in rib.layers] == [True, False]
    child = bd_strips.model_compound(Model([rib.placed])).children[0]
    assert tuple(pickle.loads(pickle.dumps(child)).children[0].color) == numbers((1, 0, 0, 1))


@pytest.mark.cadquery
def test_names_and_colors_given_later_in_cadquery():
    rib = cq_strips.bent_strip(CURVE, "pom-0.5", **OPTIONS)
    slider = rib.slider(end=tuple(rib.rod.position[-1] - (10, 0)))
    rib.label, rib.color = "left", cq.Color(*RED)
    made = [
        rib.flat, rib.bent(), rib.bent(angles=(None, 10)), rib.outline, slider.bent(5.0), cq_strips.flat_strip(rib),
        rib.moved(cq.Location((1, 2, 3))).flat, pickle.loads(pickle.dumps(rib)).flat,
    ]  # fmt: skip
    assert {body.label for body in (*made, *rib.layers)} == {"left"}
    for body in made:
        assert body.color.toTuple() == numbers(RED)
    other = cq_strips.bent_strip(CURVE, "pom-0.5", **OPTIONS)
    whole = cq_strips.model_assembly(Model([rib.placed, other.placed]))
    assert [child.name for child in whole.children] == ["left", "A1"]
    assert whole.children[0].color.toTuple() == rib.assembly.children[0].color.toTuple() == numbers(RED)
    assert whole.children[1].color.toTuple()[:3] == numbers(sheet_color("pom-0.5"))
    fixture = rib.fixture()
    fixture.label = "block"
    assert (fixture.flat.label, fixture.color.toTuple()[:3]) == ("left", numbers((0.30, 0.36, 0.42)))


@pytest.mark.cadquery
def test_layers_with_names_pickle_in_cadquery():
    rib = cq_strips.bent_strip(CURVE, "birch-plywood-0.8", label="L", **GLUED)
    for body in (*rib.layers, copy.deepcopy(rib.layers[1])):
        read = pickle.loads(pickle.dumps(body))
        assert (read.label, read.color.toTuple()) == (body.label, body.color.toTuple())


@pytest.mark.build123d
@pytest.mark.cadquery
def test_color_is_an_option_of_both_libraries():
    bent, face = bd_strips.BentStrip, cq_strips.strip_outline
    for color in (
        "steelblue",
        "#4682b4",
        (0.2745098, 0.5098039, 0.7058824),
        bd.Color("steelblue"),
        cq.Color("steelblue"),
    ):
        assert tuple(bent(CURVE, "pom-0.5", color=color, **OPTIONS).color)[:3] == numbers(
            tuple(bd.Color("steelblue"))[:3]
        )
        assert face(CURVE, "pom-0.5", color=color, **OPTIONS).color.toTuple()[:3] == numbers(
            tuple(bd.Color("steelblue"))[:3]
        )
    rib = bent(CURVE, "pom-0.5", color="red", **OPTIONS)
    assert tuple(rib.fixture(color="blue").color) == (0, 0, 1, 1)
    assert tuple(bd_strips.FlatStrip(rib, color="blue").color) == (0, 0, 1, 1)
    for wrong in ("rad", (1, 2), (0, 0, 7), 3):
        with pytest.raises(ValueError, match=r"color is .* Pass a CAD library's Color"):
            bent(CURVE, "pom-0.5", color=wrong, **OPTIONS)


@pytest.mark.build123d
@pytest.mark.parametrize("form", ["bent", "flat"])
def test_bodies_are_saved_at_their_position_with_names_and_colors(tmp_path, form):
    rib = bd.Pos(5, 6, 7) * bd_strips.BentStrip(CURVE, "birch-plywood-0.8", label="L", color="red", **GLUED)
    body = getattr(rib, form) if form == "flat" else rib
    for suffix in ("dxf", "svg", "step", "stl", "glb"):
        ec.save(body, tmp_path / f"rib.{suffix}")
    read = bd.import_step(tmp_path / "rib.step")
    assert tuple(read.center()) == pytest.approx(tuple(body.center()), abs=1e-3)
    assert read.volume == pytest.approx(body.volume, rel=1e-5)
    if form == "bent":
        assert [child.label for child in read.children] == ["L", "L_backing"]  # as build123d reads names
    assert (
        pytest.approx(body.bounding_box().max.Z, abs=0.05)
        == bd.import_stl(tmp_path / "rib.stl").bounding_box().max.Z
    )
    ec.save(rib.strip, tmp_path / "strip.dxf")
    assert (tmp_path / "strip.dxf").read_bytes() == (tmp_path / "rib.dxf").read_bytes()
    with pytest.raises(InputError, match="is a block, which has no flat pattern"):
        ec.save(rib.fixture(), tmp_path / "block.svg")
