"""Bent strips as records, by numpy alone: every edge lies on the faces that use it, and the skin is closed."""

import numpy as np
import pytest

from elastica_cad import Frame, Hole, InputError, Path, PlaneCurve, Sheet, Strip, Tab, optimal_rod
from elastica_cad.geometry import Arc, Line
from elastica_cad.strip import BentSolid
from elastica_cad.strip.bent_boundary import (
    CylinderSurface,
    ExtrudedSurface,
    PlacedSegment,
    PlaneSurface,
    StraightTrace,
    bent_maps,
)
from elastica_cad.strip.flat_pattern import cut_across, on_segment
from elastica_cad.strip.outline import long_sides

pytestmark = pytest.mark.core

CURVES = {
    "arch": PlaneCurve.spline([(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)]),
    "cubic": PlaneCurve.spline([(0, 0), (20, 50), (60, 70), (110, 60), (140, 20), (150, 0)], degree=3),
    "S": PlaneCurve.spline([(0, 0), (50, 60), (100, 10), (150, -40), (200, 20)]),
}
ENDS = (Tab(12, holes=(Hole(6, 3.2),)), Tab(14, width=18, corner_radius=3))
PLACE = Frame((5.0, -7.0, 11.0), (2.0, -1.0, 2.0), (2.0, 2.0, -1.0))


def test_sides_are_splines_where_the_bent_strip_is_one():
    """Long sides and a line between them lie on the bent faces to rounding."""
    rod = optimal_rod(CURVES["arch"])
    (bent,) = bent_maps(rod, PLACE, 0.4)
    low, high = long_sides(Strip(rod, Sheet.named("birch-plywood-0.8"), max_width=24.0).width)
    sides = [low[0], high[0].reversed(), Line((0, 5), (rod.length, 7))]
    for side, curves in zip(
        sides, bent.curves([(one, *limits(one)) for one in sides], (-0.4, 0.4)), strict=True
    ):
        t = np.linspace(*limits(side), 57)
        exact = bent.points(on_segment(side, t), (-0.4, 0.4))
        for level, curve in enumerate(curves):
            found = de_boor(curve.knots, curve.control_points, curve.degree, t)
            assert np.abs(found - exact[:, level]).max() < 1e-11


@pytest.mark.parametrize("lead", [0.5, 40.0])
def test_a_bent_strip_has_faces_on_both_sides_of_a_jump_of_curvature(lead):
    """Two arcs of radius 80 and 50 mm. A single spline across their joint would need very many spans."""
    turn = lead / 80
    first = PlaneCurve.arc((0, 0), 80, 0, turn)
    second = PlaneCurve.arc((30 * np.cos(turn), 30 * np.sin(turn)), 50, turn, turn + 1.2)
    knots = np.concatenate([first.knots[:-1], second.knots[3:] + first.knots[-1]])
    points = np.concatenate([first.control_points, second.control_points[1:]])
    curve = PlaneCurve(knots, points, 2, np.concatenate([first.weights, second.weights[1:]]))
    before, after = bent_maps(optimal_rod(curve), PLACE, 0.4)
    assert before.knots[[0, -1]] == pytest.approx([0.0, lead])
    assert after.knots[[0, -1]] == pytest.approx([lead, lead + 60])
    assert max(before.knots.size, after.knots.size) < 60


def limits(segment):
    return (0.0, segment.length) if isinstance(segment, Line) else segment.curve.domain


def de_boor(knots, points, degree, t):
    """Values (n, d) of a B-spline, by its own recursion."""
    out = []
    for x in np.atleast_1d(t):
        k = int(np.clip(np.searchsorted(knots, x, side="right") - 1, degree, len(points) - 1))
        d = [np.array(points[j + k - degree], dtype=float) for j in range(degree + 1)]
        for r in range(1, degree + 1):
            for j in range(degree, r - 1, -1):
                low, high = knots[j + k - degree], knots[j + 1 + k - r]
                a = (x - low) / (high - low)
                d[j] = (1 - a) * d[j - 1] + a * d[j]
        out.append(d[degree])
    return np.array(out)


def on_curve(curve, t):
    if isinstance(curve, PlacedSegment):
        return curve.frame.point(on_segment(curve.segment, t))
    return de_boor(curve.knots, curve.control_points, curve.degree, t)


def on_surface(surface, uv):
    if isinstance(surface, CylinderSurface):
        u, v = uv.T
        return surface.frame.point(
            np.column_stack([surface.radius * np.cos(u), surface.radius * np.sin(u), v])
        )
    if isinstance(surface, ExtrudedSurface):
        return on_curve(surface.profile, uv[:, 0]) + uv[:, 1:] * surface.profile.frame.z_axis
    rows, columns, _ = surface.control_points.shape
    points = []
    for u, v in uv:
        along = de_boor(surface.knots[0], surface.control_points.reshape(rows, -1), surface.degree[0], u)
        points.append(de_boor(surface.knots[1], along.reshape(columns, 3), surface.degree[1], v)[0])
    return np.array(points)


def traced(trace, t):
    if isinstance(trace, StraightTrace):
        return np.array(trace.origin) + t[:, None] * np.array(trace.direction)
    return on_segment(trace, t)


@pytest.fixture(params=sorted(CURVES))
def strip(request):
    return Strip(
        optimal_rod(CURVES[request.param]), Sheet.named("birch-plywood-0.8"), max_width=30, ends=ENDS
    )


def test_edges_lie_on_their_faces(strip):
    for boundary in (BentSolid.of(strip, PLACE).boundary, BentSolid.of(strip, PLACE).middle):
        for edge in boundary.edges:
            ends = on_curve(edge.curve, np.array([edge.first, edge.last]))
            assert np.abs(ends - boundary.vertices[[edge.start, edge.end]]).max() < 1e-9
        for face in boundary.faces:
            for use in (use for loop in face.loops for use in loop):
                edge = boundary.edges[use.edge]
                t = np.linspace(edge.first, edge.last, 4)
                points = on_curve(edge.curve, t)
                if isinstance(face.surface, PlaneSurface):
                    assert np.abs(face.surface.frame.local(points)[:, 2]).max() < 1e-9
                else:
                    assert np.abs(on_surface(face.surface, traced(use.trace, t)) - points).max() < 1e-7


def test_skin_is_closed_and_middle_is_not(strip):
    record = BentSolid.of(strip)
    assert record.boundary.is_closed
    assert not record.middle.is_closed


def test_centre_line_follows_the_rod(strip):
    s = np.linspace(0.0, strip.rod.length, 301)
    samples = strip.rod.curve.at(s)
    normal = np.column_stack([-np.sin(samples.angle), np.cos(samples.angle)])
    (bent,) = BentSolid.of(strip).maps[1:-1]
    for up in (-0.4, 0.0, 0.4):
        points = bent.points(np.column_stack([s, np.zeros_like(s)]), [up])[:, 0]
        assert np.abs(points[:, :2] - (samples.position - up * normal)).max() < 2e-6


def test_lines_straight_across_stay_lines():
    """Both sides of the flat pattern reach its end by sums of their own, which may differ in the last digit."""
    curve = PlaneCurve.spline([(0, 0), (25, 55), (60, 45), (95, -50), (130, -40), (150, 0)])
    for lift in range(12):
        rod = optimal_rod(curve.transformed(np.diag([1, 1 + 0.01 * lift, 1])))
        made = BentSolid.of(Strip(rod, Sheet.named("birch-plywood-0.8"), max_width=30))
        ends = made.boundary.vertices[[(edge.start, edge.end) for edge in made.boundary.edges]]
        across = np.abs(np.diff(ends, axis=1)[:, 0, :2]).max(axis=1) < 1e-6
        assert across.sum() == 8
        kinds = {type(made.boundary.edges[i].curve) for i in across.nonzero()[0]}
        assert kinds == {PlacedSegment}


def test_tabs_go_on_straight(strip):
    record = BentSolid.of(strip, PLACE)
    start, end = record.maps[0], record.maps[-1]
    curve, length = strip.rod.curve, strip.rod.length
    for frame, s in ((start, 0.0), (end, length)):
        at = curve.at(np.array([s]))
        assert frame.point((s, 0.0)) == pytest.approx(PLACE.point(at.position[0]), abs=1e-9)
        assert frame.x_axis == pytest.approx(
            PLACE.direction([np.cos(at.angle[0]), np.sin(at.angle[0])]), abs=1e-9
        )
        assert frame.y_axis == pytest.approx(PLACE.z_axis, abs=1e-12)


class TestCutAcross:
    """The flat pattern cut at stations: areas add up, seams are shared, holes stay with their region."""

    @staticmethod
    def area(region):
        total = 0.0
        for piece in (piece for loop in region.loops for piece in loop):
            t = np.linspace(piece.first, piece.last, 401)
            x, y = on_segment(piece.segment, t if piece.forward else t[::-1]).T
            total += 0.5 * float(np.sum(x[:-1] * y[1:] - x[1:] * y[:-1]))
        return total

    @pytest.mark.parametrize("stations", [(0.0,), (-5.0, 0.0, 30.0), (10.0, 20.0, 59.0)])
    def test_areas_add_up(self, stations):
        outline = Path.rectangle(70, 20, corner=(-10, -10))
        holes = [Path.circle((0, 0), 4), Path.circle((20, 3), 2), Path.rectangle(6, 2, corner=(27, -6))]
        pattern = cut_across(outline, holes, stations)
        whole = 1400 - 20 * np.pi - 12
        assert sum(self.area(region) for region in pattern.regions) == pytest.approx(whole, abs=2e-2)
        assert {region.interval for region in pattern.regions} == set(range(len(stations) + 1))

    def test_a_fork_gives_two_regions_beyond_the_station(self):
        corners = [(0, 0), (40, 0), (40, 4), (10, 4), (10, 6), (40, 6), (40, 10), (0, 10)]
        pattern = cut_across(Path.polygon(corners), [Path.circle((35, 2), 1)], (20.0,))
        beyond = [region for region in pattern.regions if region.interval == 1]
        assert sorted(len(region.loops) for region in beyond) == [1, 2]
        assert sorted(self.area(region) for region in beyond) == pytest.approx([80 - np.pi, 80], abs=1e-2)

    def test_a_hole_across_the_station_becomes_part_of_both_rims(self):
        pattern = cut_across(Path.rectangle(40, 20), [Path.circle((20, 10), 5)], (20.0,))
        assert [len(region.loops) for region in pattern.regions] == [1, 1]
        seams = [p.number for r in pattern.regions for loop in r.loops for p in loop if p.seam]
        assert sorted(seams) == sorted([*set(seams)] * 2)

    def test_a_hole_from_a_station_past_the_next_parts_the_strip(self):
        """Its tip is a corner of both halves; each half is a region that comes there once."""
        diamond = Path.polygon([(10, 10), (30, 5), (50, 10), (30, 15)])
        pattern = cut_across(Path.rectangle(60, 20), [diamond], (10.0, 20.0))
        between = [region for region in pattern.regions if region.interval == 1]
        assert len(between) == 2
        for region in between:
            (loop,) = region.loops
            corners = [piece.start for piece in loop]
            assert len(set(corners)) == len(corners)

    def test_direction_of_the_loops_does_not_matter(self):
        arc = Path((Arc((20, 10), 5, 0.0, -2 * np.pi),), closed=True)
        one = cut_across(Path.rectangle(40, 20).reversed(), [arc], (20.0,))
        assert all(self.area(region) > 0 for region in one.regions)

    def test_loops_that_cross_are_refused(self):
        with pytest.raises(InputError, match="cross"):
            cut_across(Path.rectangle(40, 20), [Path.rectangle(10, 30, corner=(15, 5))], (20.0,))


class TestFrames:
    def test_there_and_back(self):
        points = np.array([[1.0, 2.0, 3.0], [-4.0, 0.5, 2.0]])
        assert PLACE.local(PLACE.point(points)) == pytest.approx(points)
        inner = Frame((1, 2, 3), (0, 1, 0), (0, 0, 1))
        assert inner.within(PLACE).point(points) == pytest.approx(PLACE.point(inner.point(points)))
        assert np.linalg.det(PLACE.axes) == pytest.approx(1)

    @pytest.mark.parametrize(
        "axes", [((1, 0, 0), (1, 1, 0)), ((0, 0, 0), (0, 1, 0)), ((1, 0, np.nan), (0, 1, 0))]
    )
    def test_bad_axes(self, axes):
        with pytest.raises(InputError, match="frame"):
            Frame((0, 0, 0), *axes)


def test_lines_on_a_seam_belong_to_one_side():
    """A tab narrower than the strip: the step lies on the station, and is a wall of the strip's side only."""
    corners = [(0, -10), (30, -10), (30, 10), (0, 10), (0, 4), (-8, 4), (-8, -4), (0, -4)]
    pattern = cut_across(Path.polygon(corners), [], (0.0,))
    tab, body = pattern.regions
    assert [len(loop) for region in (tab, body) for loop in region.loops] == [4, 6]
    assert sum(isinstance(p.segment, Line) and p.seam for p in tab.loops[0]) == 1


@pytest.mark.parametrize("name", CURVES)
def test_joints_of_the_bent_strip_are_the_ends_of_its_curve(name):
    curve = CURVES[name]
    strip = Strip(optimal_rod(curve), Sheet.named("birch-plywood-0.8"), max_width=20, ends=ENDS)
    joints = BentSolid.of(strip, frame=PLACE).joints
    for end, place in zip(("start", "end"), curve.sample(2).position, strict=True):
        assert joints[end].origin == pytest.approx(PLACE.point(place), abs=1e-6)
