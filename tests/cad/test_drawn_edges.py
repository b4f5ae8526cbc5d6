"""Edges and wires of OpenCASCADE become exact plane curves, or are refused in one sentence."""

from itertools import pairwise

import numpy as np
import pytest
from OCP.BRepBuilderAPI import BRepBuilderAPI_MakeEdge, BRepBuilderAPI_MakeWire, BRepBuilderAPI_Transform
from OCP.Geom import Geom_Ellipse, Geom_OffsetCurve
from OCP.gp import gp_Ax1, gp_Ax2, gp_Circ, gp_Dir, gp_Elips, gp_Lin, gp_Pnt, gp_Trsf, gp_Vec

from elastica_cad import Frame, InputError, Path, PlaneCurve
from elastica_cad.geometry import Line, Spline
from elastica_cad.kernel import occt
from elastica_cad.kernel.drawn_edges import drawn_edges, plane_curve

XY = gp_Ax2(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1))


def line(a, b):
    return BRepBuilderAPI_MakeEdge(gp_Pnt(*a), gp_Pnt(*b)).Edge()


def arc(radius, first, last, axes=XY):
    return BRepBuilderAPI_MakeEdge(gp_Circ(axes, radius), first, last).Edge()


def wire(*edges):
    made = BRepBuilderAPI_MakeWire()
    for edge in edges:
        made.Add(edge)
    return made.Wire()


def moved(shape, axis, angle, shift=(0, 0, 0)):
    turn, slide = gp_Trsf(), gp_Trsf()
    turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(*axis)), angle)
    slide.SetTranslation(gp_Vec(*shift))
    return BRepBuilderAPI_Transform(shape, slide.Multiplied(turn), True).Shape()


def test_a_spline_comes_back_exactly(curve):
    """Poles, knots, weights and degree, through an edge of the kernel and back."""
    back, frame = plane_curve(occt.make_wire(Path([Spline(curve)])))
    assert back.degree == curve.degree
    assert np.array_equal(back.control_points, curve.control_points)
    assert back.weights == pytest.approx(curve.weights) if curve.weights is not None else back.weights is None
    assert back.knots == pytest.approx(curve.knots)
    assert frame.axes == pytest.approx(np.eye(3), abs=0)


def test_lines_arcs_ellipses():
    quarter = BRepBuilderAPI_MakeEdge(gp_Elips(XY, 20, 10), 0, np.pi / 2).Edge()
    for edge, length in (
        (line((0, 0, 0), (30, 40, 0)), 50.0),
        (arc(10, 0.2, 4.0), 38.0),
        (quarter, PlaneCurve.ellipse((0, 0), (20, 10), 0, 0, np.pi / 2).length),
    ):
        assert plane_curve(edge)[0].length == pytest.approx(length, rel=1e-12)


def test_offset_curve():
    ellipse = Geom_Ellipse(gp_Elips(XY, 40, 25))
    offset = Geom_OffsetCurve(ellipse, 3.0, gp_Dir(0, 0, 1))
    curve, _ = plane_curve(BRepBuilderAPI_MakeEdge(offset, 0.0, 2.0).Edge())
    v = np.linspace(0, 2, 7)
    base = np.column_stack([40 * np.cos(v), 25 * np.sin(v)])
    tangent = np.column_stack([-40 * np.sin(v), 25 * np.cos(v)])
    tangent /= np.linalg.norm(tangent, axis=1)[:, None]
    wanted = base + 3 * np.column_stack([tangent[:, 1], -tangent[:, 0]])
    drawn = curve.evaluate(np.linspace(*curve.domain, 20001))
    assert max(np.min(np.hypot(*(drawn - p).T)) for p in wanted) < 3e-3  # half a step of the samples
    assert curve.sample(2).position == pytest.approx(wanted[[0, -1]], abs=2e-6)


def test_tangent_edges_are_joined_whatever_their_order():
    first, second = line((-30, 10, 0), (0, 10, 0)), arc(10, np.pi / 2 - 1, np.pi / 2)
    for shape in (wire(first, second), [first, second], [first, second.Reversed()]):
        curve, _ = plane_curve(shape)
        assert curve.length == pytest.approx(40)
        assert curve.sample(2).position[0] == pytest.approx((-30, 10))


@pytest.mark.parametrize(
    ("axis", "angle", "x_axis", "y_axis"),
    [
        ((1, 0, 0), np.pi / 2, (1, 0, 0), (0, 0, 1)),
        ((1, 1, 1), 2 * np.pi / 3, (0, 1, 0), (0, 0, 1)),
        ((0, 0, 1), 0.4, (1, 0, 0), (0, 1, 0)),
    ],
    ids=["xz", "yz", "turned in xy"],
)
def test_plane_is_found_with_up_as_y(axis, angle, x_axis, y_axis):
    drawn = moved(arc(10, 0.2, 2.0), axis, angle, (1, 2, 3))
    curve, frame = plane_curve(drawn)
    assert frame.x_axis == pytest.approx(x_axis)
    assert frame.y_axis == pytest.approx(y_axis)
    ends = frame.point(curve.sample(2).position)
    circle = np.array([[10 * np.cos(v), 10 * np.sin(v), 0] for v in (0.2, 2.0)])
    place = gp_Trsf()
    place.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(*axis)), angle)
    wanted = [gp_Pnt(*p).Transformed(place) for p in circle]
    assert ends == pytest.approx(np.array([(p.X() + 1, p.Y() + 2, p.Z() + 3) for p in wanted]))


def test_curve_and_frame_put_the_curve_back(curve, tilted):
    drawn = occt.make_wire(Path([Spline(curve)]), tilted)
    found, frame = plane_curve(drawn)
    s = np.linspace(0, curve.length, 7)
    assert frame.point(found.at(s).position) == pytest.approx(tilted.point(curve.at(s).position), abs=1e-9)


HELIX = [(10 * np.cos(v), 10 * np.sin(v), 2 * v) for v in np.linspace(0, 4, 5)]


class TestRefused:
    @pytest.mark.parametrize(
        ("shape", "says"),
        [
            (lambda: wire(*(line(a, b) for a, b in pairwise(HELIX))), "polyline of 4 straight pieces"),
            (lambda: [line((0, 0, 0), (1, 0, 0)), line((5, 0, 0), (9, 0, 0))], "2 separate chains"),
            (lambda: [line((0, 0, 0), (9, 0, 0)), line((9, 0, 0), (9, 5, 0))], r"90 degrees at \(9, 0, 0\)"),
            (lambda: [], "there is no edge"),
            (lambda: 7, "an object of type int is not an edge or wire"),
            (lambda: [line((0, 0, 0), (1, 0, 0)), "x"], "of type str is not an edge"),
            (lambda: BRepBuilderAPI_MakeEdge(gp_Lin(gp_Pnt(0, 0, 0), gp_Dir(1, 0, 0))).Edge(), "infinitely long"),
        ],
    )  # fmt: skip
    def test_with_a_reason(self, shape, says):
        with pytest.raises(InputError, match=says):
            plane_curve(shape())

    def test_a_space_curve_says_how_far_it_leaves_its_plane(self):
        with pytest.raises(InputError, match=r"leaves its plane by .* mm"):
            plane_curve([arc(10, 0, 1.5), tilted_continuation()])

    def test_a_degenerate_edge(self):
        """The tip of a cone is an edge without a curve."""
        from OCP.BRepPrimAPI import BRepPrimAPI_MakeCone

        with pytest.raises(InputError, match="degenerate"):
            drawn_edges(BRepPrimAPI_MakeCone(5, 0, 10).Shape())


def tilted_continuation():
    """An arc that goes on along the end tangent of arc(10, 0, 1.5), in a plane tilted about that tangent."""
    end = np.array([10 * np.cos(1.5), 10 * np.sin(1.5), 0])
    tangent = np.array([-np.sin(1.5), np.cos(1.5), 0])
    inward = np.cos(0.5) * -end / 10 + np.sin(0.5) * np.array([0, 0, 1.0])
    center = end + 10 * inward
    axes = gp_Ax2(gp_Pnt(*center), gp_Dir(*np.cross(-inward, tangent)), gp_Dir(*-inward))
    return arc(10, 0, 1, axes)


def test_face_with_a_hole(measure):
    face = occt.make_face(Path.rectangle(30, 20), [Path.circle((10, 10), 3)], Frame((0, 0, 5)))
    assert measure.is_valid(face)
    assert measure.area(face, bent=False) == pytest.approx(600 - 9 * np.pi)


def test_open_wire_of_lines_and_clockwise_arcs(measure):
    from elastica_cad.geometry import Arc

    path = Path([Line((0, 0), (10, 0)), Arc((10, -5), 5, np.pi / 2, 0)])
    curve, _ = plane_curve(occt.make_wire(path))
    assert curve.length == pytest.approx(path.length)
    assert curve.sample(2).position[-1] == pytest.approx((15, -5))
