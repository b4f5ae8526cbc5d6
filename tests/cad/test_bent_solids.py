"""Bent strips as OpenCASCADE sees them: valid, closed, with the area and the place they must have."""

import numpy as np
import pytest

from elastica_cad import (
    InputError,
    Limits,
    Path,
    Perforated,
    PlaneCurve,
    Profile,
    Rod,
    Sheet,
    Strip,
    Tab,
    bend,
    nearest_rod,
    optimal_rod,
)
from elastica_cad.geometry import Arc, Line, Spline
from elastica_cad.kernel import occt
from elastica_cad.strip import BentSolid, FlatSolid


def flat_area(outline, holes):
    return abs(outline.area) - sum(abs(hole.area) for hole in holes)


def check(record, flat, thickness, measure):
    """Closed, valid, the middle surface as large as the flat pattern, and the volume that goes with it."""
    assert record.boundary.is_closed
    solid = occt.make_solid(record)
    assert measure.is_valid(solid)
    assert measure.area(occt.make_boundary(record.middle)) == pytest.approx(flat, rel=1e-6)
    assert measure.volume(solid) == pytest.approx(flat * thickness, rel=1e-6)
    return solid


def test_every_curve_and_every_end(curve, ends, card, tilted, measure):
    strip = Strip(optimal_rod(curve), card, max_width=30, ends=ends)
    record = BentSolid.of(strip, tilted)
    solid = check(record, strip.area, card.thickness, measure)
    assert measure.distance(occt.make_boundary(record.middle), strip_points(strip, tilted)) < 1e-5
    s = strip.rod.length * np.array([0.1, 0.55])
    samples = strip.rod.curve.at(s)
    normal = np.column_stack([-np.sin(samples.angle), np.cos(samples.angle)])
    half = strip.width(s) / 2
    for across, off in ((-1, 1), (0, -1), (1, 1)):
        plane = samples.position + off * card.thickness / 2 * normal
        points = tilted.point(np.column_stack([plane, across * half]))
        assert measure.distance(solid, points) < 1e-5


def strip_points(strip, frame):
    return frame.point(strip.rod.position[:: len(strip.rod.s) // 4])


def test_volume_is_that_of_a_ring_segment(measure, card):
    """On an arc the solid lies between two circles: area of the ring times the width."""
    radius, turn, width = 40.0, 2.0, 12.0
    strip = Strip(
        optimal_rod(PlaneCurve.arc((0, 0), radius, 0, turn)), card, max_width=width, ends=(Tab(0), Tab(0))
    )
    h = card.thickness
    ring = turn / 2 * ((radius + h / 2) ** 2 - (radius - h / 2) ** 2)
    assert measure.volume(occt.make_solid(BentSolid.of(strip))) == pytest.approx(ring * width, rel=1e-7)


HOLES = {
    "round": [Path.circle((70, 3), 4)],
    "slot": [Path.rectangle(20, 1.2, corner=(50, -0.6)), Path.rectangle(1.2, 9, corner=(100, -4))],
    "diamond": [Path.polygon([(90, 0), (100, -4), (110, 0), (100, 4)])],
    "spline": [
        Path(
            [
                Spline(PlaneCurve.spline([(60, 0), (62, -9), (78, -9), (80, 0)], degree=3)),
                Spline(PlaneCurve.spline([(80, 0), (75, 7), (64, 6), (60, 0)], degree=3)),
            ],
            closed=True,
        )
    ],
    "on the start": [Path.circle((0, 0), 3), Path.rectangle(6, 2, corner=(-3, 5))],
    "touching the start from inside": [Path.rectangle(6, 2, corner=(0, 1))],
}


@pytest.mark.parametrize("name", sorted(HOLES))
def test_holes_lie_wrapped_on_the_bent_face(name, arch_strip, measure):
    holes = (*arch_strip.holes, *HOLES[name])
    h = arch_strip.sheet.thickness
    record = BentSolid.wrapped(arch_strip.rod, arch_strip.outline, holes, heights=(-h / 2, h / 2))
    check(record, flat_area(arch_strip.outline, holes), h, measure)


def test_slots_open_at_the_edge(arch_strip, measure):
    """A slot cut into a straight-sided strip from one side, another across its end."""
    rod, h = arch_strip.rod, 0.8
    length = rod.length
    corners = [(-10, -9), (60, -9), (60, 0), (61, 0), (61, -9), (length + 10, -9), (length + 10, -1),
               (length - 15, -1), (length - 15, 1), (length + 10, 1), (length + 10, 9), (-10, 9)]  # fmt: skip
    outline = Path.polygon(corners)
    record = BentSolid.wrapped(rod, outline, heights=(-h / 2, h / 2))
    check(record, outline.area, h, measure)


def test_jumps_of_curvature_and_of_width(card, measure):
    """Two arcs of different radius that meet tangentially, and a width that steps where they meet."""
    turn = 1.1
    first, second = Arc((0, 0), 50, np.pi, np.pi - turn), Arc((0, 0), 90, 0, 1)
    meet = np.array(first.end)
    direction = meet / 50
    second = Arc(meet - 90 * direction, 90, np.pi - turn, np.pi - turn - 0.8)
    knots = np.array([0, 0, 0, 1, 1, 2, 2, 2.0])
    a, b = first.as_spline().curve, second.as_spline().curve
    assert a.control_points.shape == b.control_points.shape == (3, 2)
    points = np.vstack([a.control_points, b.control_points[1:]])
    weights = np.concatenate([a.weights / a.weights[-1], b.weights[1:] / b.weights[0]])
    curve = PlaneCurve(knots, points, 2, weights)
    strip = Strip(optimal_rod(curve), card, max_width=20)
    record = BentSolid.of(strip)
    solid = check(record, strip.area, card.thickness, measure)
    assert measure.distance(solid, strip_points(strip, record.frame)) < 1e-6


def test_rod_without_a_drawn_curve(card, measure):
    """A rod bent forward has nodes only; its solid passes them to 1e-4 mm."""
    straight = Rod.straight(150.0, Profile.interpolate([0, 75, 150], [1, 1.6, 1]))
    rod = bend(straight, start=(0, 0), end=(120, 0), angles=(0.9, -0.9))
    assert rod.shape is None
    strip = Strip(rod, card, max_width=20)
    record = BentSolid.of(strip)
    check(record, strip.area, card.thickness, measure)
    assert measure.distance(occt.make_boundary(record.middle), strip_points(strip, record.frame)) < 1e-4
    for name, angle, sign in (("start", rod.angle[0], -1), ("end", rod.angle[-1], 1)):
        tangent = [sign * np.cos(angle), sign * np.sin(angle), 0]
        assert record.joints[name].x_axis == pytest.approx(tangent, abs=1e-7)


def test_nearest_rod(card, measure):
    """A rod of few nodes: still the flat area to 1e-6 and the rod's end tangents; h^2 kappa / 24 off its nodes."""
    wave = PlaneCurve.spline([(0, 0), (20, 50), (50, -40), (80, 55), (110, -30), (140, 0)], degree=4)
    rod = nearest_rod(wave, Limits(ratio=4.0)).rod
    strip = Strip(rod, card, max_width=20)
    record = BentSolid.of(strip)
    check(record, strip.area, card.thickness, measure)
    sag = rod.s[1] ** 2 * np.abs(rod.curvature).max() / 24
    assert measure.distance(occt.make_boundary(record.middle), strip_points(strip, record.frame)) < 3 * sag
    outward = [np.cos(rod.angle[-1]), np.sin(rod.angle[-1]), 0]
    assert record.joints["end"].x_axis == pytest.approx(outward, abs=1e-7)


def test_straight_rod(card, measure):
    strip = Strip(Rod.straight(100, [1, 2, 1.5]), card, max_width=20)
    check(BentSolid.of(strip), strip.area, card.thickness, measure)


def test_tabs_are_planes_and_their_holes_cylinders(arch_strip, measure):
    from OCP.GeomAbs import GeomAbs_SurfaceType

    faces = measure.faces(occt.make_solid(BentSolid.of(arch_strip)))
    radii = sorted(
        f.Cylinder().Radius() for f in faces if f.GetType() == GeomAbs_SurfaceType.GeomAbs_Cylinder
    )
    assert radii == pytest.approx([1, 1, 1, 1, 1.6, 1.6, 3, 3])


def test_flat_solid(arch_strip, tilted, measure):
    record = FlatSolid.of(arch_strip, tilted)
    solid = occt.make_solid(record)
    assert measure.is_valid(solid)
    assert measure.volume(solid, bent=False) == pytest.approx(arch_strip.area * 0.8, rel=1e-4)
    face = occt.make_face(arch_strip.outline, arch_strip.holes, tilted)
    assert measure.area(face) == pytest.approx(arch_strip.area, rel=1e-9)
    corner = tilted.point([-12, 0, 0.4])
    assert measure.distance(solid, [corner]) < 1e-9


def test_outline_stays_few_exact_edges(arch_strip):
    """A plain strip with two tabs: at most 12 edges, the long sides one spline each."""
    strip = Strip(arch_strip.rod, arch_strip.sheet, max_width=30, ends=(Tab(10), Tab(10)))
    record = BentSolid.of(strip)
    assert len(strip.outline.segments) <= 12
    assert sum(isinstance(segment, Spline) for segment in strip.outline.segments) == 2
    assert sum(isinstance(segment, Line) for segment in strip.outline.segments) == 6
    assert len(record.boundary.faces) == 3 * 2 + 8


def test_joints_stand_on_the_strip(arch_strip, tilted):
    record = BentSolid.of(arch_strip, tilted)
    curve = arch_strip.rod.curve
    for name, s, sign in (("start", 0.0, -1), ("end", curve.length, 1)):
        at = curve.at(np.array([s]))
        joint = record.joints[name]
        assert joint.origin == pytest.approx(tilted.point(at.position[0]), abs=1e-9)
        tangent = tilted.direction([np.cos(at.angle[0]), np.sin(at.angle[0])])
        assert joint.x_axis == pytest.approx(sign * tangent, abs=1e-9)
    flat = FlatSolid.of(arch_strip, tilted)
    holes = {f"hole{number}{face}" for number in (1, 2, 3) for face in ("", ":top", ":bottom")}
    assert set(flat.joints) == set(record.joints) == {"start", "end", *holes}
    for body in (flat, record):
        for face, side in (("top", 1), ("bottom", -1)):
            middle, there = body.joints["hole2"], body.joints[f"hole2:{face}"]
            assert middle.local(there.origin) == pytest.approx([0, 0, side * 0.4], abs=1e-12)
            assert there.z_axis == pytest.approx(side * middle.z_axis)
    assert flat.joints["hole1"].origin == pytest.approx(tilted.point([-6, 0, 0.4]))


class TestBadInput:
    def test_radius_below_half_the_thickness(self, card):
        strip = Strip(optimal_rod(PlaneCurve.arc((0, 0), 0.35, 0, 2)), card, max_width=3)
        with pytest.raises(
            InputError, match=r"radius of the curve .* mm from its start is 0\.35 mm.*thinner sheet"
        ):
            BentSolid.of(strip)

    def test_hole_that_leaves_the_strip(self, arch_strip):
        holes = [Path.rectangle(10, 20, corner=(-5, 5))]
        with pytest.raises(InputError, match="cross"):
            BentSolid.wrapped(arch_strip.rod, arch_strip.outline, holes, heights=(-0.4, 0.4))

    def test_open_outline(self):
        with pytest.raises(InputError, match="must be closed"):
            FlatSolid(Path([Line((0, 0), (1, 0))]), (), 1.0)

    def test_no_thickness(self):
        with pytest.raises(InputError, match="thickness is 0"):
            FlatSolid(Path.rectangle(10, 5), (), 0.0)


def test_holes_that_begin_on_a_joint_of_arcs_and_reach_the_next(measure):
    """The strip hangs together at the tip of a hole only: two faces meet there, not one that is pinched."""
    knots, points = [0.0, 0.0, 0.0], [np.zeros(2)]
    weights, at, angle = [1.0], np.zeros(2), 1.2
    for radius, degrees in ((40, 50), (80, 60), (30, 40)):
        first, sweep = angle + np.pi / 2, np.radians(degrees)
        center = at + radius * np.array([np.sin(angle), -np.cos(angle)])
        arc = PlaneCurve.arc(center, radius, first, first - sweep)
        points += list(arc.control_points[1:])
        weights += list(arc.weights[1:] / arc.weights[0] * weights[-1])
        knots += [knots[-1] + 1.0] * 2
        angle, at = angle - sweep, arc.control_points[-1]
    curve = PlaneCurve(np.array([*knots, knots[-1]]), np.array(points), 2, np.array(weights))
    style = Perforated(width=30.0, columns=1, rows=2, least_ligament=0.2, least_hole=0.2)
    strip = Strip(optimal_rod(curve), Sheet.named("birch-plywood-0.8"), style=style)
    body = occt.make_solid(BentSolid.of(strip))
    assert measure.is_valid(body)
    assert measure.volume(body) == pytest.approx(FlatSolid.of(strip).volume, rel=1e-6)
