"""Bodies of strips that close, in build123d and CadQuery: a ring and its lap, fit to be cut."""

import build123d as bd
import cadquery as cq
import pytest

from elastica_cad import build123d, cadquery
from elastica_cad.strip.solids import GLUE_MM

SHEET = "birch-plywood-0.8"
AT_THE_JOINT = (20, 20, 30)  # mm: reaches over the width of the strip


def test_a_ring_and_its_lap_in_build123d():
    circle = bd.Edge.make_circle(60)
    body = build123d.BentStrip(circle, SHEET, max_width=20, label="R")
    ring, lap = body.solids()
    assert body.is_valid
    assert ring.is_valid
    assert lap.is_valid
    flat = build123d.FlatStrip(circle, SHEET, max_width=20)
    # the lap lies one thickness farther in, so it is as much shorter
    assert ring.volume + lap.volume * 60 / 59.2 == pytest.approx(flat.volume, rel=1e-4)
    assert lap.distance_to(ring) == pytest.approx(GLUE_MM, abs=1e-6)
    cut = ring - bd.Pos(60, 0, 0) * bd.Box(*AT_THE_JOINT)
    assert cut.is_valid
    assert cut.volume == pytest.approx(ring.volume * (1 - 2 * 9.55 / 377), rel=0.01)


def test_a_ring_and_its_lap_in_cadquery():
    circle = cq.Edge.makeCircle(60)
    body = cadquery.bent_strip(circle, SHEET, max_width=20, label="R")
    assert body.isValid()
    assert [solid.label for solid in body.layers] == ["R", "R lap"]
    assert len(body.assembly.children) == 2
    for end in ("start", "end"):
        assert body.end_face(end).Center().toTuple() == pytest.approx((60, 0, 0), abs=0.02)
    left = body.cut(cq.Solid.makeBox(*AT_THE_JOINT, cq.Vector(50, -10, -15)))
    assert left.isValid()
