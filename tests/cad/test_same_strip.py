"""One curve through the core, build123d and CadQuery: one strip, whoever drew the edge."""

import build123d as bd
import cadquery as cq
import numpy as np
import pytest

from elastica_cad import build123d, cadquery
from elastica_cad.fabrication.strip.tabs import Tab
from elastica_cad.fabrication.strip_spec import make_strip
from elastica_cad.geometry.curves.plane_curve import PlaneCurve

POLES = [(0, 0), (30, 60), (80, 70), (140, 0)]
SHEET = "birch-plywood-0.8"
OPTIONS = {"max_width": 30, "ends": (Tab(10), Tab(10)), "label": "same"}


@pytest.fixture(scope="module")
def edges():
    drawn = bd.Edge.make_bezier(*POLES)
    return {"build123d": drawn, "cadquery": cq.Edge(drawn.wrapped)}


@pytest.fixture(scope="module")
def core():
    return make_strip(PlaneCurve.spline(POLES, degree=3), SHEET, **OPTIONS)


SKINS = {
    "build123d": lambda path: build123d.BentStrip(path, SHEET, **OPTIONS),
    "cadquery": lambda path: cadquery.bent_strip(path, SHEET, **OPTIONS),
}


@pytest.mark.parametrize("drawn_by", ["build123d", "cadquery"])
@pytest.mark.parametrize("skin", ["build123d", "cadquery"])
def test_same_to_rounding(skin, drawn_by, edges, core):
    """Also across: a build123d edge given to CadQuery's function and back."""
    strip = SKINS[skin](edges[drawn_by]).strip
    s = np.linspace(0, core.rod.length, 101)
    assert strip.rod.length == pytest.approx(core.rod.length, rel=1e-9)
    assert strip.width(s) == pytest.approx(core.width(s), rel=1e-9)
    assert strip.rod.position == pytest.approx(core.rod.position, abs=1e-9)
    assert strip.area == pytest.approx(core.area, rel=1e-9)


def test_step_goes_from_one_to_the_other(tmp_path, edges):
    """CadQuery's assembly read by build123d, and the other way round."""
    flat = cadquery.flat_strip(edges["build123d"], SHEET, **OPTIONS)
    cq.Assembly(name="all").add(flat, name="flat", color=cq.Color(1, 0, 0)).export(str(tmp_path / "cq.step"))
    read = bd.import_step(tmp_path / "cq.step")
    assert read.volume == pytest.approx(flat.Volume(), rel=1e-9)
    bent = SKINS["build123d"](edges["cadquery"])
    bd.export_step(bent, tmp_path / "bd.step")
    back = cq.importers.importStep(str(tmp_path / "bd.step"))
    assert back.val().Volume() == pytest.approx(bent.volume, rel=1e-9)
    assert "'same'" in (tmp_path / "bd.step").read_text()
