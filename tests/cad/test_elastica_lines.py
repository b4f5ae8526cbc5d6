"""The curve between two clamps as a line object and an edge, and strips that are made on it."""

import warnings

import numpy as np
import pytest

from elastica_cad import InputError
from elastica_cad.kernel.strip_body import StripWarning, end_angles
from tests.cad.libraries import bd, bd_strips, cq, cq_strips


@pytest.mark.build123d
class TestBuild123d:
    def test_length_ends_and_tangents(self):
        line = bd_strips.Elastica((0, 0), (60, 20), 110, angles=(60, -80))
        assert line.length == pytest.approx(110, abs=1e-3)
        assert tuple(line @ 1)[:2] == pytest.approx((60, 20), abs=1e-3)
        for u, angle in ((0, 60), (1, -80)):
            tangent = line % u
            assert np.degrees(np.arctan2(tangent.Y, tangent.X)) == pytest.approx(angle, abs=0.1)
        assert line.branch.side == 1

    def test_in_a_sketch_and_on_another_plane(self):
        with bd.BuildSketch() as sketch:
            with bd.BuildLine():
                arch = bd_strips.Elastica((0, 0), (70, 0), 100)
                bd.Line(arch @ 1, arch @ 0)
            bd.make_face()
        assert sketch.sketch.area > 1000
        with bd.BuildLine(bd.Plane.XZ) as upright:
            bd_strips.Elastica((0, 0), (70, 0), 100)
        box = upright.line.bounding_box()
        assert pytest.approx(0, abs=1e-6) == box.size.Y
        assert box.max.Z > 25

    def test_a_force_bends_a_free_end_and_a_strip_stands_on_it(self):
        line = bd_strips.Elastica((0, 0), None, 200, angles=(0, None), force=(0, 1 / 200**2))
        assert line.length == pytest.approx(200, abs=1e-3)
        assert tuple(line @ 1)[:2] == pytest.approx((200 * (1 - 0.05643), 200 * 0.30172), abs=5e-3)
        rib = bd_strips.BentStrip(line, "pom-0.5", max_width=12, compensate=False)
        assert rib.volume == pytest.approx(0.5 * 12 * 220, rel=3e-4)

    def test_a_strip_of_even_width_takes_it(self):
        line = bd_strips.Elastica((0, 0), (160, 0), 220, angles=(40, -40))
        strip = bd_strips.BentStrip(line, "card-200gsm", max_width=20).strip
        low, high = strip.width.extremes
        assert high / low < 1 + 1e-3

    @pytest.mark.parametrize("length", [172.0, 200.0, 241.0])
    def test_a_strip_takes_it_as_it_is_between_parallel_clamps(self, length):
        """Its inflections are at knots, where the curvature is a rounding error: this was taken for a kink."""
        line = bd_strips.Elastica((0, 0), (160, 0), length, angles=(0, 0))
        rib = bd_strips.BentStrip(line, "pom-0.5", max_width=10, ignore_limits=True, compensate=False)
        assert rib.rod.length == pytest.approx(length, abs=1e-3)
        assert rib.deviation < 1e-3
        assert not any("Smoothing" in text for text in rib.warnings)
        assert rib.strip.width.extremes == pytest.approx((10, 10), rel=1e-3)

    def test_bodies_weigh_as_their_sheet(self):
        """A pinned end once rippled the width by a tenth, and kernels then missed 2 % of the volume."""

        line = bd_strips.Elastica((0, 0), (60, 20), 100, angles=(30, None)).edge()
        rib = bd_strips.BentStrip(line, "pom-0.5", max_width=12, compensate=False)
        assert rib.flat.volume == pytest.approx(0.5 * 12 * 120, rel=1e-4)
        assert rib.volume == pytest.approx(0.5 * 12 * 120, rel=1e-4)

    def test_refused(self):
        with pytest.raises(InputError, match="longer"):
            bd_strips.Elastica((0, 0), (70, 0), 60)
        with pytest.raises(InputError, match="buckling is 0: give"):
            bd_strips.Elastica((0, 0), (70, 0), 100, buckling=0)
        with pytest.raises(InputError, match="1 mm apart in z"):
            bd_strips.Elastica((0, 0, 1), (70, 0, 0), 100)
        with pytest.raises(InputError, match="length is None: give"):
            bd_strips.Elastica((0, 0), (70, 0))

    def test_a_plane_beside_the_workplane(self):
        line = bd_strips.Elastica((0, 0, 5), bd.Location((70, 0, 5)), 100)
        assert [line.position_at(u).Z for u in (0, 0.4, 1)] == pytest.approx([5, 5, 5])
        with bd.BuildLine(bd.Plane.XZ) as drawn:
            free = bd_strips.Elastica((0, 0, 5), length=100, angles=(30, None))
        assert tuple(drawn.line.edge().position_at(0)) == pytest.approx((0, -5, 0))
        assert repr(free).startswith("<Elastica of 100 mm: ")


@pytest.mark.cadquery
def test_cadquery_edge():
    edge = cq_strips.elastica((0, 0), (160, 0), 220, angles=(40, -40), side=1)
    assert isinstance(edge, cq.Edge)
    assert edge.Length() == pytest.approx(220, abs=1e-3)
    assert cq_strips.bent_strip(edge, "card-200gsm", max_width=20).isValid()
    free = cq_strips.elastica((0, 0), None, 200, angles=(0, None), force=(0, 1 / 200**2))
    assert free.endPoint().toTuple()[:2] == pytest.approx((200 * (1 - 0.05643), 200 * 0.30172), abs=5e-3)


@pytest.mark.build123d
def test_bodies_are_bent_by_degrees_as_lines_are():
    rib = bd_strips.BentStrip(
        bd_strips.Elastica((0, 0), (160, 0), 200, angles=(50, -50)).edge(), "pom-0.5", max_width=10
    )
    assert np.degrees(rib.bent(angles=(40, -40)).rod.angle[[0, -1]]) == pytest.approx([40, -40])
    with pytest.raises(InputError, match=r"angles are \(400, 0\): give degrees from -360 to 360"):
        rib.bent(angles=(400, 0))
    with pytest.warns(StripWarning, match=r"Angles are in degrees, and 0\.8, -0\.8 is small"):
        rib.bent(angles=(0.8, -0.8))


@pytest.mark.parametrize("angles", [(0, 0), (5, -5), (0.5, 30), (None, 0)])
def test_degrees_are_not_taken_for_radians(angles):
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        end_angles(angles)
