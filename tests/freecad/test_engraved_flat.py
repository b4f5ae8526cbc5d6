"""The engraved text on the flat part, against the cutting file of the same strip."""

from itertools import pairwise

import pytest
from freecad.elastica_wb.cutting_files import write_cutting_files
from freecad.elastica_wb.features import flat, strip

from tests.freecad.features import change, new

ezdxf = pytest.importorskip("ezdxf")


@pytest.fixture
def lying(document, sketch):
    """The flat part of a strip."""
    return new(flat.create, document, new(strip.create, document, sketch))


def letters(shape):
    """Edges of a shape that bound no face."""
    bounds = {edge.hashCode() for face in shape.Faces for edge in face.Edges}
    return [edge for edge in shape.Edges if edge.hashCode() not in bounds]


def test_letters_are_those_of_the_cutting_file(lying, tmp_path):
    change(lying.Strip, EngravedText="AV 17")
    write_cutting_files([lying.Strip], tmp_path, kinds=["dxf"])
    (file,) = tmp_path.glob("*.dxf")
    strokes = ezdxf.readfile(file).modelspace().query('*[layer=="ENGRAVE"]')
    edges = letters(lying.Shape)
    assert {round(vertex.Z, 6) for edge in edges for vertex in edge.Vertexes} == {lying.Strip.Thickness.Value}
    paths = [ezdxf.path.make_path(stroke) for stroke in strokes]
    drawn = [point for path in paths for point in path.flattening(1e-4)]
    lengths = [a.distance(b) for path in paths for a, b in pairwise(path.flattening(1e-4))]
    assert sum(edge.Length for edge in edges) == pytest.approx(sum(lengths), rel=1e-4)
    box = lying.Shape.BoundBox
    assert box.XMin < min(point.x for point in drawn) + lying.Placement.Base.x < box.XMax
    assert len(lying.Shape.Solids) == 1


def test_a_backing_has_its_own_letters(lying):
    """Each layer lies on z = 0, and its letters are on its upper face."""
    change(lying.Strip, Style="Laminated", OuterWidth=28, Sheet="pom-0.5", Backing="pom-1", Anyway=True)
    change(lying, Layer="Backing")
    heights = {round(vertex.Z, 6) for edge in letters(lying.Shape) for vertex in edge.Vertexes}
    assert heights == {1.0}, lying.getStatusString()
