"""What `help` says of the classes and functions of both libraries, as people call it."""

import pydoc
from itertools import pairwise

import pytest

from elastica_cad.kernel.strip_body import BendOptions
from elastica_cad.kernel.strip_on_path import BlockOptions
from elastica_cad.kernel.strip_options import FixtureSizes, StripOptions
from tests.cad.libraries import cq, cq_strips

STRIP = {"path", "sheet", "max_width", *StripOptions.__annotations__}
BLOCK = {"end", *BlockOptions.__annotations__}


def help_of(thing):
    """The keywords that help lists, each with what it says."""
    lines = pydoc.render_doc(thing, renderer=pydoc.plaintext).replace("|  ", "").splitlines()
    found = {}
    for line, below in pairwise(lines):
        names, between, _ = line.strip().partition(" : ")
        if between:
            found |= {name: below.strip() for name in names.split(", ")}
    return found


def assert_listed(things):
    for thing, keywords in things:
        listed = help_of(thing)
        assert keywords - listed.keys() == set(), thing
        for name in {"max_width", "min_width", "seam_position", *FixtureSizes.__annotations__} & keywords:
            assert "mm" in listed[name], (thing, name)
    assert "degrees" in help_of(things[-1][0])["angles"]


@pytest.mark.build123d
def test_help_in_build123d():
    from elastica_cad import build123d as lib

    assert_listed([
        (lib.StripOutline, STRIP), (lib.FlatStrip, STRIP), (lib.BentStrip, STRIP), (lib.elastic_strip, STRIP),
        (lib.EndFixture, STRIP | BLOCK), (lib.section_strips, STRIP - {"path"} | {"body", "planes", "half"}),
        (lib.Slider, {"rib", "end"}), (lib.AngleSlider, {"rib", "angle"}),
        (lib.model_compound, {"model", "others"}),
        (lib.Elastica, {"start", "end", "length", "angles", "stiffness", "gravity", "force", "side", "buckling"}),
        (lib.BentStrip.fixture, BLOCK - {"end"}), (lib.BentStrip.bent, {*BendOptions.__annotations__}),
    ])  # fmt: skip
    assert "on the block" in help_of(lib.EndFixture)["engrave"]


@pytest.mark.cadquery
def test_help_in_cadquery():
    from elastica_cad import cadquery as lib

    lib.register()
    assert_listed([
        (lib.strip_outline, STRIP), (lib.flat_strip, STRIP), (lib.bent_strip, STRIP),
        (cq.Workplane.elasticStrip, STRIP - {"path"} | {"form"}), (cq.Sketch.elasticStrip, STRIP - {"path"}),
        (lib.end_fixture, STRIP | BLOCK), (lib.section_strips, STRIP - {"path"} | {"body", "planes", "half"}),
        (lib.Slider, {"rib", "end", "angle"}), (lib.model_assembly, {"model", "others"}),
        (lib.elastica, {"start", "end", "length", "angles", "stiffness", "gravity", "force", "side", "buckling"}),
        (lib.StripSolid.fixture, BLOCK - {"end"}), (lib.StripSolid.bent, {*BendOptions.__annotations__}),
    ])  # fmt: skip
    assert "on the block" in help_of(lib.end_fixture)["engrave"]


@pytest.mark.cadquery
def test_the_old_name_of_what_is_engraved_on_a_block_is_refused():
    edge = cq.Edge.makeSpline([cq.Vector(0, 0), cq.Vector(60, 50), cq.Vector(120, 0)])
    with pytest.raises(TypeError, match=r"Pass engrave="):
        cq_strips.end_fixture(edge, "card-200gsm", max_width=20, number="7")
