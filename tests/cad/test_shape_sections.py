"""Sections of CAD bodies: exact against closed forms."""

from types import SimpleNamespace

import numpy as np
import pytest

from elastica_cad import InputError
from elastica_cad.form_finding import parallel_planes, radial_planes, section_curves
from elastica_cad.kernel.shape_sections import shape_sections


@pytest.fixture(scope="module")
def bodies():
    from OCP.BRepPrimAPI import BRepPrimAPI_MakeSphere, BRepPrimAPI_MakeTorus

    return BRepPrimAPI_MakeSphere(50.0).Shape(), BRepPrimAPI_MakeTorus(60.0, 20.0).Shape()


def test_a_ball_gives_circles(bodies):
    heights = np.array([-49.0, -10.0, 0.0, 30.0])
    for section, height in zip(
        shape_sections(bodies[0], parallel_planes((0, 0, 0), (0, 1, 0), heights)), heights, strict=True
    ):
        line = section.line
        assert line.is_closed
        assert np.hypot(*line.points.T) == pytest.approx(np.sqrt(2500 - height**2), abs=1e-6)
        left, _ = line.split_by((0, 0, 0), (1, 0, 0))
        (curve,), reports = section_curves([left], tolerance=0.02)
        assert reports == ()
        assert curve.curve.length == pytest.approx(np.pi * np.sqrt(2500 - height**2), rel=1e-3)


def test_several_lines_and_misses_are_reported(bodies):
    ring, missed = shape_sections(
        bodies[1],
        [
            *radial_planes((0, 0, 0), (0, 0, 1), 0.3),
            *parallel_planes((0, 0, 30), (0, 0, 1), 0.0, up=(0, 1, 0)),
        ],
    )
    assert len(ring.lines) == 2
    assert "consists of 2 separate lines" in ring.reports[0]
    assert missed.lines == ()
    assert "misses the shape" in missed.reports[0]
    for nothing in (None, SimpleNamespace(wrapped=None), object()):
        with pytest.raises(InputError, match="no shape to cut"):
            shape_sections(nothing, [])
    with pytest.raises(InputError, match="sequence of Frames"):
        shape_sections(bodies[0], ring.frame)


@pytest.mark.campaign
def test_cuts_through_freeform_faces_have_few_points():
    """A loft, whose sections the kernel would else trace as polylines of ten thousand points."""
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeEdge, BRepBuilderAPI_MakeWire
    from OCP.BRepOffsetAPI import BRepOffsetAPI_ThruSections
    from OCP.gp import gp_Ax2, gp_Dir, gp_Elips, gp_Pnt

    loft = BRepOffsetAPI_ThruSections(True)
    for height, a, b in ((0, 60, 60), (80, 90, 50), (160, 40, 40)):
        ring = gp_Elips(gp_Ax2(gp_Pnt(0, 0, height), gp_Dir(0, 0, 1)), a, b)
        loft.AddWire(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(ring).Edge()).Wire())
    frames = [
        *parallel_planes((0, 0, 0), (0, 0, 1), (1.0, 80.0), up=(0, 1, 0)),
        *radial_planes((0, 0, 0), (0, 0, 1), (0.7, 2.0)),
    ]
    sections = shape_sections(loft.Shape(), frames, half=False)
    assert [section.line.is_closed for section in sections] == [True] * 4
    assert max(len(section.line.points) for section in sections) < 3000
    x, y = sections[1].line.points.T
    assert (x / 90) ** 2 + (y / 50) ** 2 == pytest.approx(np.ones(x.size), abs=1e-5)
    chords = np.linalg.norm(np.diff(sections[1].line.points, axis=0), axis=1)
    assert chords.max() < 2.0
    halves = shape_sections(loft.Shape(), frames[2:], half=True)
    curves, _ = section_curves(
        [piece for half in halves for piece in half.line.split_at_corners(np.radians(30))], tolerance=0.05
    )
    assert len(curves) == 6
    for curve in curves:
        assert curve.deviation < 0.05


def test_a_section_of_many_edges_keeps_its_corners():
    from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeFace, BRepBuilderAPI_MakePolygon
    from OCP.BRepPrimAPI import BRepPrimAPI_MakePrism
    from OCP.gp import gp_Pnt, gp_Vec

    t = np.linspace(0, np.pi, 61)
    polygon = BRepBuilderAPI_MakePolygon()
    for u in t:
        polygon.Add(gp_Pnt(50 * float(np.cos(u)), 0.0, 50 * float(np.sin(u))))
    polygon.Close()
    face = BRepBuilderAPI_MakeFace(polygon.Wire()).Face()
    trough = BRepPrimAPI_MakePrism(face, gp_Vec(0, 100, 0)).Shape()
    (section,) = shape_sections(trough, parallel_planes((0, 0, 0), (0, 1, 0), 40.0))
    assert len(section.line.points) < 2000
    assert section.line.length == pytest.approx(100 + 60 * 100 * np.sin(np.pi / 120), abs=1e-3)
    round_part, flat_part = sorted(
        section.line.split_at_corners(np.radians(60)), key=lambda line: -line.length
    )
    assert flat_part.length == pytest.approx(100.0, abs=1e-3)
    assert round_part.length > 157.0
