"""Sections of CAD bodies: exact against closed forms."""

import numpy as np
import pytest

pytest.importorskip("OCP")

from elastica_cad.errors import InputError
from elastica_cad.forming import parallel_planes, radial_planes, section_curves
from elastica_cad.shape_sections import shape_sections


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


def test_several_lines_and_misses_are_told(bodies):
    ring, missed = shape_sections(
        bodies[1],
        [
            *radial_planes((0, 0, 0), (0, 0, 1), 0.3),
            *parallel_planes((0, 0, 30), (0, 0, 1), 0.0, up=(0, 1, 0)),
        ],
    )
    assert len(ring.lines) == 2
    assert "falls into 2 lines" in ring.reports[0]
    assert missed.lines == ()
    assert "misses the shape" in missed.reports[0]
    with pytest.raises(InputError, match="no shape"):
        shape_sections(None, [])
