"""The strip turns with its curve: slots open on the same edge however the curve is placed."""

import numpy as np
import pytest

from elastica_cad import Frame, InputError, Slot
from tests.cad.libraries import bd, bd_strips, cq, cq_strips

POINTS = [(0, 0), (40, 40), (90, 50), (140, 0)]
OPTIONS = {"max_width": 30, "slots": (Slot(60, 1.5, 5),)}
SHEET = "birch-plywood-0.8"


@pytest.fixture(scope="module")
def arch():
    return bd.Edge.make_spline(POINTS)


@pytest.fixture(scope="module")
def home(arch):
    """The strip of the curve as drawn, on xy and upright."""

    return {
        name: bd_strips.BentStrip(getattr(bd.Plane, name) * arch, SHEET, **OPTIONS) for name in ("XY", "XZ")
    }


@pytest.mark.build123d
class TestBuild123d:
    @staticmethod
    def center(body, back):
        """Centre of gravity in the curve's own coordinates: the slot pulls it to the other edge."""

        return np.array([*(back.inverse() * bd.Pos(*body.center())).position])

    @pytest.mark.parametrize("angle", range(0, 360, 72))
    @pytest.mark.parametrize("axis", ["X", "Y", "Z"])
    def test_turned_by_location(self, arch, home, angle, axis):
        turn = bd.Location((7, -3, 11), tuple(angle * float(axis == a) for a in "XYZ"))
        for name, there in home.items():
            body = bd_strips.BentStrip(turn * (getattr(bd.Plane, name) * arch), SHEET, **OPTIONS)
            at_home = self.center(there, bd.Location())
            assert self.center(body, turn) == pytest.approx(at_home, abs=1e-5), (name, angle)

    @pytest.mark.parametrize("angle", range(0, 360, 72))
    def test_turned_for_good(self, arch, angle):
        """A copy whose geometry was turned, without a location to tell: upright curves keep their side."""
        from OCP.BRepBuilderAPI import BRepBuilderAPI_Transform

        upright = bd.Plane.XZ * arch
        bodies = []
        for turn in (bd.Location(), bd.Location((0, 0, 0), (0, 0, angle))):
            shape = (turn * upright).wrapped
            place = shape.Location().Transformation()
            edge = BRepBuilderAPI_Transform(arch.wrapped, place, True).Shape()
            bodies.append((turn, bd_strips.BentStrip(bd.Edge(edge), SHEET, **OPTIONS)))
        (_, first), (turn, second) = bodies
        at_home = self.center(first, bd.Location())
        assert self.center(second, turn) == pytest.approx(at_home, abs=1e-5)

    def test_both_sides_of_a_plane(self, arch):
        sides = []
        for plane in (bd.Plane.XZ, -bd.Plane.XZ):
            body = bd_strips.BentStrip(plane * arch, SHEET, **OPTIONS)
            sides.append((body.center() - plane.origin).dot(plane.z_dir))
        assert sides[0] == pytest.approx(sides[1], abs=1e-6)
        assert sides[0] < -1e-3  # the slot is on the upper edge, where z is

    def test_plane_says_otherwise(self, arch, home):
        body = bd_strips.BentStrip(arch, SHEET, plane=-bd.Plane.XY, **OPTIONS)
        there = home["XY"]
        assert pytest.approx(-there.center().Z, abs=1e-6) == body.center().Z
        with pytest.raises(InputError, match="away from the plane that was given"):
            bd_strips.BentStrip(arch, SHEET, plane=bd.Plane.XY.offset(3), **OPTIONS)
        with pytest.raises(InputError, match="Pass a CAD library's Plane"):
            bd_strips.BentStrip(arch, SHEET, plane="XY", **OPTIONS)

    def test_polar_array(self, arch):
        """PolarLocations: all of them the same way round."""

        heights = []
        for place in bd.PolarLocations(100, 8):
            body = bd_strips.BentStrip(place * (bd.Plane.XZ * arch), SHEET, **OPTIONS)
            across = bd.Location(place.position, place.orientation).inverse() * bd.Pos(*body.center())
            heights.append(across.position.Y)
        assert heights == pytest.approx([heights[0]] * 8, abs=1e-5)


@pytest.mark.cadquery
class TestCadQuery:
    @pytest.mark.campaign
    def test_turned(self):
        arch = cq.Edge.makeSpline([cq.Vector(*p) for p in POINTS])
        upright = cq.Location((0, 0, 0), (1, 0, 0), 90)
        there = cq_strips.bent_strip(arch.moved(upright), SHEET, **OPTIONS).Center()
        for angle in range(0, 360, 24):
            turn = cq.Location((0, 0, 0), (0, 0, 1), angle)
            body = cq_strips.bent_strip(arch.moved(turn * upright), SHEET, **OPTIONS)
            back = (turn.inverse * cq.Location(body.Center())).toTuple()[0]
            assert back == pytest.approx(there.toTuple(), abs=1e-5)

    def test_workplane_knows_its_side(self):
        cq_strips.register()
        for name in ("XZ", "ZX"):
            work = cq.Workplane(name)
            body = work.spline(POINTS).elasticStrip(SHEET, form="bent", **OPTIONS).val()
            assert body.Center().dot(work.plane.zDir) < -1e-3


def test_mirrored(measure):
    """A curve and its mirror image: frames are right-handed, and the free part lies on each."""
    from elastica_cad import PlaneCurve, Sheet, Strip, optimal_rod
    from elastica_cad.formats.edges import Edge
    from elastica_cad.formats.placed_curve import placed_curve
    from elastica_cad.kernel import occt
    from elastica_cad.strip import BentSolid

    curve = PlaneCurve.spline([(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)])
    place = Frame((1, 2, 3), (2, 0, 1), (-1, 0, 2))
    for mirror in (np.eye(3), np.diag([-1.0, 1, 1]), np.diag([1.0, -1, 1]), np.diag([1.0, 1, -1])):
        points = place.point(curve.control_points) @ mirror
        found, frame = placed_curve([Edge(curve.knots, points, curve.degree)])
        assert np.linalg.det(frame.axes) == pytest.approx(1)
        strip = Strip(optimal_rod(found), Sheet.named(SHEET), max_width=20)
        body = occt.make_solid(BentSolid.of(strip, frame))
        assert measure.distance(body, points[[0, -1]]) < 1e-5
