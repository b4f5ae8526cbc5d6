"""What both skins refuse, in the words and with the error type of a library of their kernel."""

import inspect

import numpy as np
import pytest
from OCP.BRep import BRep_Builder
from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeEdge
from OCP.BRepPrimAPI import BRepPrimAPI_MakeCone
from OCP.Geom import Geom_Hyperbola, Geom_Line
from OCP.GeomAPI import GeomAPI_PointsToBSpline
from OCP.gp import gp_Ax2, gp_Circ, gp_Dir, gp_Pnt
from OCP.TopoDS import TopoDS_Edge

from elastica_cad import MissingDependencyError, PlaneCurve, Slot
from elastica_cad.kernel import ocp_import
from tests.cad.libraries import bd, bd_strips, cq, cq_strips

try:
    from OCP.TColgp import TColgp_Array1OfPnt as Array1OfPnt
except ImportError:  # OCP 8
    from OCP.collections import Array1_gp_Pnt as Array1OfPnt

SHEET = "birch-plywood-0.8"


def line(a, b):
    return BRepBuilderAPI_MakeEdge(gp_Pnt(*a), gp_Pnt(*b)).Edge()


def circle(radius, first=0.0, last=2 * np.pi):
    return BRepBuilderAPI_MakeEdge(
        gp_Circ(gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), radius), first, last
    ).Edge()


def spline_through(places):
    points = Array1OfPnt(1, len(places))
    for i, place in enumerate(places, start=1):
        points.SetValue(i, gp_Pnt(*place))
    return GeomAPI_PointsToBSpline(points).Curve()


def helix():
    turns = np.linspace(0, 3, 20)
    return BRepBuilderAPI_MakeEdge(
        spline_through([(30 * np.cos(v), 30 * np.sin(v), 5 * v) for v in turns])
    ).Edge()


def degenerate():
    """The tip of a cone."""
    k = ocp_import.kernel()
    explorer = k.TopExp_Explorer(BRepPrimAPI_MakeCone(5, 0, 10).Shape(), k.TopAbs_ShapeEnum.TopAbs_EDGE)
    while not k.BRep_Tool.Degenerated_s(k.as_edge(explorer.Current())):
        explorer.Next()
    return k.as_edge(explorer.Current())


def trimmed_beyond(curve, last):
    """An edge as broken files have it: what trims it is beyond the curve's own range, or beyond floats."""
    builder, edge = BRep_Builder(), TopoDS_Edge()
    builder.MakeEdge(edge, curve, 1e-7)
    builder.Range(edge, 0.0, last)
    return edge


def spline_through_three_points():
    return spline_through([(0, 0, 0), (20, 5, 0), (40, 0, 0)])


REFUSED = {
    "a hyperbola beyond floats": (
        lambda: [trimmed_beyond(Geom_Hyperbola(gp_Ax2(), 1, 1), 1000.0)],
        {},
        "cannot evaluate the curve|a coordinate is nan mm",  # OpenCASCADE 7.9, 8
    ),
    "farther than any drawing": (
        lambda: [trimmed_beyond(Geom_Line(gp_Pnt(0, 0, 0), gp_Dir(1, 0, 0)), 1e90)],
        {},
        r"a coordinate is 1e\+90 mm",
    ),
    "trimmed beyond its end": (
        lambda: [trimmed_beyond(spline_through_three_points(), 3.0)],
        {},
        "cannot evaluate the curve",
    ),
    "no edge at all": (lambda: [], {}, "there is no edge: select at least one edge or wire"),
    "not plane": (
        lambda: [helix()],
        {},
        r"leaves its plane by [\d.]+ mm .*: project the curve onto a plane first$",
    ),
    "disjoint": (lambda: [line((0, 0, 0), (9, 0, 0)), line((20, 0, 0), (30, 0, 0))], {}, "2 separate chains"),
    "closed curve has a corner": (
        lambda: [line((0, 0, 0), (9, 0, 0)), line((9, 0, 0), (4, 5, 0)), line((4, 5, 0), (0, 0, 0))],
        {},
        "polyline of 3 straight pieces",
    ),
    "degenerate": (lambda: [degenerate()], {}, "degenerate"),
    "corner": (lambda: [line((0, 0, 0), (9, 0, 0)), line((9, 0, 0), (9, 5, 0))], {}, "corner of 90 degrees"),
    "too tight": (
        lambda: [circle(0.35, 0, 2)],
        {"max_width": 0.2, "ignore_limits": True},
        r"radius of the curve .* from its start is 0\.35 mm.*gentler curve",
    ),
    "slots that meet": (
        lambda: [circle(50, 0, 2)],
        {"slots": (Slot(at=50, width=4), Slot(at=52, width=4))},
        "slot",
    ),
    "no width": (lambda: [circle(50, 0, 2)], {"max_width": None}, "width"),
    "a width that is none": (lambda: [circle(50, 0, 2)], {"max_width": -3}, "width"),
}


def message_of(make, name):
    shapes, options, says = REFUSED[name]
    with pytest.raises(ValueError, match=says) as caught:
        make(shapes(), **{"max_width": 20, **options})
    assert "\n" not in str(caught.value).strip()


@pytest.mark.build123d
@pytest.mark.parametrize("name", sorted(REFUSED))
def test_build123d(name):
    message_of(
        lambda shapes, **options: bd_strips.BentStrip([bd.Edge(e) for e in shapes], SHEET, **options), name
    )


@pytest.mark.cadquery
@pytest.mark.parametrize("name", sorted(REFUSED))
def test_cadquery(name):
    message_of(
        lambda shapes, **options: cq_strips.bent_strip([cq.Edge(e) for e in shapes], SHEET, **options), name
    )


@pytest.mark.build123d
def test_build123d_signatures():
    from elastica_cad import build123d

    for name in ("StripOutline", "FlatStrip", "BentStrip", "EndFixture"):
        called_as(getattr(build123d, name).__init__, ["self", "path", "sheet"], {"max_width"})
    called_as(build123d.elastic_strip, ["path", "sheet"], {"max_width", "form", "mode"})
    assert inspect.signature(build123d.elastic_strip).parameters["path"].default is None
    with pytest.raises(TypeError, match="widht"):
        build123d.FlatStrip(PlaneCurve.arc((0, 0), 50, 0, 2), SHEET, widht=3)


@pytest.mark.cadquery
def test_cadquery_signatures():
    from elastica_cad import cadquery

    for name in ("strip_outline", "flat_strip", "bent_strip", "end_fixture"):
        called_as(getattr(cadquery, name), ["path", "sheet"], {"max_width"})
    cadquery.register()
    called_as(cq.Workplane.elasticStrip, ["self", "sheet"], {"max_width", "form"})
    called_as(cq.Sketch.elasticStrip, ["self", "sheet"], {"max_width"})


@pytest.mark.build123d
def test_calls_that_do_not_fit_name_what_users_call():
    from elastica_cad import build123d

    rib = build123d.BentStrip(PlaneCurve.arc((0, 0), 50, 0, 2), SHEET, max_width=5, ignore_limits=True)
    for call, message in (
        (lambda: build123d.BentStrip(rib, SHEET, 20), "BentStrip: takes path and sheet by position.*max_width="),
        (build123d.FlatStrip, "FlatStrip: missing a required argument: 'path'"),
        (lambda: build123d.elastic_strip(rib, SHEET, 20), "elastic_strip: .*max_width="),
        (lambda: rib.bent((1, 2)), r"BentStrip\.bent: takes no argument by position.*end="),
        (lambda: rib.fixture("start", 1), r"BentStrip\.fixture: takes end by position.*clearance="),
        (build123d.FlexurePart, "FlexurePart: missing a required argument: 'flexure'"),
    ):  # fmt: skip
        with pytest.raises(TypeError, match=message):
            call()
    for name in ("FlexurePart", "Elastica"):
        assert "args" not in inspect.signature(getattr(build123d, name)).parameters


@pytest.mark.cadquery
def test_calls_that_do_not_fit_in_cadquery():
    from elastica_cad import cadquery

    cadquery.register()
    work = cq.Workplane().moveTo(0, 0).lineTo(50, 0)
    with pytest.raises(TypeError, match=r"Workplane\.elasticStrip: takes sheet by position.*max_width="):
        work.elasticStrip(SHEET, 20)
    with pytest.raises(TypeError, match=r"Sketch\.elasticStrip: missing a required argument: 'sheet'"):
        cq.Sketch().elasticStrip()


def called_as(function, positional, keywords):
    """The fixed names: positional ones in order, then keywords."""
    parameters = inspect.signature(function).parameters.values()
    assert [p.name for p in parameters if p.kind is p.POSITIONAL_OR_KEYWORD] == positional
    assert keywords <= {p.name for p in parameters if p.kind is p.KEYWORD_ONLY}


@pytest.mark.parametrize("skin", [pytest.param("build123d", marks=pytest.mark.build123d),
                                  pytest.param("cadquery", marks=pytest.mark.cadquery)])  # fmt: skip
def test_unknown_kernel_through_a_skin(skin, monkeypatch):
    """A line of OpenCASCADE's Python face that is not known is an ImportError that says what to do."""
    import OCP

    module = __import__(f"elastica_cad.{skin}", fromlist=["x"])
    ocp_import.kernel.cache_clear()
    monkeypatch.setattr(OCP, "__version__", "11.0")
    make = module.FlatStrip if skin == "build123d" else module.flat_strip
    try:
        with pytest.raises(
            ImportError, match=r"OCP 11\.0 .* Install a release of build123d or cadquery"
        ) as caught:
            make(__import__(skin).Edge(circle(50, 0, 2)), SHEET, max_width=20)
    finally:
        ocp_import.kernel.cache_clear()
    assert isinstance(caught.value, MissingDependencyError)
