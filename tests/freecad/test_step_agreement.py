"""The STEP file that FreeCAD writes and the one that build123d's OpenCASCADE writes hold the same strip."""

import Part
import pytest
from freecad.elastica_wb.cutting_files import write_cutting_files
from freecad.elastica_wb.features import strip

from elastica_cad.kernel.step_files import write_strip_step
from tests.freecad.features import change

WAVE = [(0, 0), (40, 60), (80, -60), (120, 0)]


def solids(path):
    shape = Part.Shape()
    shape.read(str(path))
    return sorted(shape.Solids, key=lambda solid: solid.BoundBox.ZLength)


def distance(edge, point, t):
    """From an edge to a point, mm.

    The nearest place that OpenCASCADE finds strays by 1e-7 mm where an edge is flat: it is asked at t as well.
    """
    return min((edge.valueAt(t) - point).Length, edge.distToShape(Part.Vertex(point))[0])


@pytest.mark.parametrize(
    ("points", "degree"), [([(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)], 4), (WAVE, 3)]
)
def test_same_strip(document, drawn, tmp_path, points, degree):
    feature = strip.create(document, drawn(points, degree))
    change(feature, TabHole=3, Anyway=True)
    (ours,) = write_cutting_files([feature], tmp_path, kinds=("step",))
    theirs = tmp_path / "core.step"
    write_strip_step(strip.strip_of(feature), theirs)
    pairs = list(zip(solids(ours), solids(theirs), strict=True))
    assert len(pairs) == 2
    for a, b in pairs:
        assert a.isValid()
        assert a.Volume == pytest.approx(b.Volume, rel=1e-6)
        assert a.Area == pytest.approx(b.Area, rel=1e-6)
        assert len(a.Faces) == len(b.Faces)
        # outlines: the long edges of one lie on the other
        edges = sorted(a.Edges, key=lambda edge: -edge.Length)[:4]
        for edge in edges:
            first, last = edge.ParameterRange
            for share in (0.07, 0.31, 0.5, 0.77, 0.96):
                t = first + share * (last - first)
                assert min(distance(other, edge.valueAt(t), t) for other in b.Edges) < 1e-9
