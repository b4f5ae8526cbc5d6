"""FreeCAD's own DXF reader sees the part that was written: same length of cut, same area."""

from itertools import pairwise

import FreeCAD as App
import Import
import numpy as np
import Part
import pytest

import elastica_cad as ec
from elastica_cad import Hole
from elastica_cad.strip import CUT_INNER, CUT_OUTER


@pytest.fixture
def strip():
    curve = ec.PlaneCurve.ellipse((0, 0), (200.0, 100.0), 0.0, 0.2, 2.9)
    tab = ec.Tab(12, corner_radius=3.0, holes=(Hole(6, 3.2),))
    return ec.Strip(
        ec.optimal_rod(curve), ec.Sheet.named("birch-plywood-0.8"), max_width=40.0, ends=(tab, tab)
    )


def loops(edges):
    """Closed wires of the edges that a reader found."""
    return [Part.Wire(chain) for chain in Part.sortEdges(edges)]


def enclosed(wire):
    """Area inside a wire by Gauss quadrature of x dy - y dx, span by span: exact where faces' areas are not."""
    u, w = np.polynomial.legendre.leggauss(12)
    total = 0.0
    for edge in wire.OrderedEdges:
        low, high = edge.ParameterRange
        inner = edge.Curve.getKnots() if hasattr(edge.Curve, "getKnots") else np.linspace(low, high, 9)
        spans = np.unique(np.clip([low, *inner, high], low, high))
        here = 0.0
        for a, b in pairwise(spans):
            for x, weight in zip(a + (b - a) * (1 + u) / 2, w * (b - a) / 2, strict=True):
                point, speed = edge.valueAt(x), edge.derivative1At(x)
                here += weight * (point.x * speed.y - point.y * speed.x) / 2
        total += here if edge.Orientation == "Forward" else -here
    return abs(total)


@pytest.fixture
def without_layers():
    """No layers of Draft are made: FreeCAD 1.0 asks for the view of each, and without a window there is none."""
    options = App.ParamGet("User parameter:BaseApp/Preferences/Mod/Draft")
    options.SetBool("dxfUseDraftVisGroups", False)
    yield
    options.RemBool("dxfUseDraftVisGroups")


@pytest.mark.campaign
@pytest.mark.usefixtures("without_layers")
@pytest.mark.parametrize("curves", ["spline", "arc", "polyline"])
def test_same_length_and_area(strip, curves, tmp_path):
    cuts = [item for item in strip.drawing().paths if item.layer in (CUT_OUTER, CUT_INNER)]
    drawing = ec.Drawing("part", tuple(cuts))
    path = tmp_path / "part.dxf"
    ec.save(drawing, path, curves=curves, tolerance=1e-4)
    document = App.newDocument("Reading")
    try:
        Import.readDXF(str(path), document.Name)
        edges = [edge for item in document.Objects if hasattr(item, "Shape") for edge in item.Shape.Edges]
        wires = loops(edges)
        assert len(wires) == len(cuts)
        assert all(wire.isClosed() for wire in wires)
        length = sum(wire.Length for wire in wires)
        areas = sorted(enclosed(wire) for wire in wires)
        faces = sorted(abs(Part.Face(wire).Area) for wire in wires)
    finally:
        App.closeDocument(document.Name)
    tolerance = 1e-6 if curves == "spline" else 1e-4
    assert length == pytest.approx(sum(item.path.length for item in cuts), rel=tolerance)
    expected = sorted(abs(item.path.area) for item in cuts)
    assert np.array(areas) == pytest.approx(np.array(expected), rel=tolerance)
    # OpenCASCADE integrates faces along splines of many spans less exactly than it measures lengths
    assert np.array(faces) == pytest.approx(np.array(expected), rel=3e-4)
