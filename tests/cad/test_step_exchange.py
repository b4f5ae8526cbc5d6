"""Bodies that go from CadQuery to build123d and back, as edges and as STEP."""

import build123d as bd
import cadquery as cq
import pytest

from elastica_cad import Tab, build123d, cadquery

SHEET = "birch-plywood-0.8"
OPTIONS = {"max_width": 30, "ends": (Tab(10), Tab(10)), "label": "same"}


def test_step_goes_from_one_to_the_other(tmp_path):
    """CadQuery's assembly read by build123d, and the other way round; the curve is of the other library too."""
    drawn = bd.Edge.make_bezier((0, 0), (30, 60), (80, 70), (140, 0))
    flat = cadquery.flat_strip(drawn, SHEET, **OPTIONS)
    cq.Assembly(name="all").add(flat, name="flat", color=cq.Color(1, 0, 0)).export(str(tmp_path / "cq.step"))
    read = bd.import_step(tmp_path / "cq.step")
    assert read.volume == pytest.approx(flat.Volume(), rel=1e-9)
    bent = build123d.BentStrip(cq.Edge(drawn.wrapped), SHEET, **OPTIONS)
    assert bent.strip is flat.strip
    bd.export_step(bent, tmp_path / "bd.step")
    back = cq.importers.importStep(str(tmp_path / "bd.step"))
    assert back.val().Volume() == pytest.approx(bent.volume, rel=1e-9)
    assert "'same'" in (tmp_path / "bd.step").read_text()
