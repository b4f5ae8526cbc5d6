"""Sections of meshes: places, order, ties at vertices and edges, open and broken meshes."""

import numpy as np
import pytest
from scipy.spatial import cKDTree

from elastica_cad import Frame, InputError, PlaneCurve
from elastica_cad.form_finding import (
    Mesh,
    SectionLine,
    mesh_sections,
    parallel_planes,
    planes_along,
    radial_planes,
    remove_false_inflections,
    section_curves,
    smooth_polyline,
)
from elastica_cad.form_finding.section_lines import tidy_points

pytestmark = pytest.mark.core


def grid(x, y, z):
    """Triangles of a surface given on a grid of (m, n) points."""
    m, n = x.shape
    vertices = np.stack([x, y, z], axis=-1).reshape(-1, 3)
    i = (np.arange(m - 1)[:, None] * n + np.arange(n - 1)).ravel()
    return vertices, np.concatenate([np.stack([i, i + n, i + n + 1], 1), np.stack([i, i + n + 1, i + 1], 1)])


def sphere(radius=50.0, count=40):
    u, v = np.meshgrid(np.linspace(0, np.pi, count), np.linspace(0, 2 * np.pi, 2 * count), indexing="ij")
    x, y, z = np.sin(u) * np.cos(v), np.sin(u) * np.sin(v), np.cos(u)
    x[:, -1], y[:, -1] = x[:, 0], y[:, 0]
    x[[0, -1]] = y[[0, -1]] = 0.0
    vertices, faces = grid(radius * x, radius * y, radius * z)
    return vertices, faces


def cube(size=10.0):
    corners = np.array([(x, y, z) for x in (0, 1) for y in (0, 1) for z in (0, 1)]) * size
    quads = [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)]
    return corners, np.array([(q[0], q[i], q[i + 1]) for q in quads for i in (1, 2)])


UPRIGHT = Frame((0, 0, 0), (1, 0, 0), (0, 0, 1))


@pytest.mark.parametrize("height", [-40.0, -1e-13, 0.0, 1e-15, 17.3])
def test_a_sphere_gives_one_circle(height):
    """Also where a row of vertices lies in the plane, or nearly."""
    vertices, faces = sphere(count=41)
    (section,) = mesh_sections(vertices, faces, [Frame((0, 0, height))])
    line = section.line
    assert line.is_closed
    radius = np.hypot(*line.points.T)
    assert radius.max() <= np.sqrt(2500 - height**2) + 1e-9
    assert radius.min() > np.sqrt(2500 - height**2) * 0.995
    steps = np.diff(np.unwrap(np.arctan2(*line.points.T[::-1])))
    assert np.all(steps > 0)
    assert steps.sum() == pytest.approx(2 * np.pi)


def test_a_seam_that_rounding_left_open_is_sewn():
    """The last meridian lies a ten-thousandth of a millimetre off the first."""
    vertices, faces = sphere(count=41)
    vertices.reshape(41, 82, 3)[1:-1, -1, 1] += 1e-4
    (section,) = mesh_sections(vertices, faces, [Frame((0, 0, 17.3))])
    assert section.line.is_closed
    assert section.line.length == pytest.approx(2 * np.pi * np.sqrt(2500 - 17.3**2), rel=2e-3)


@pytest.mark.campaign
def test_points_lie_on_plane_and_edges():
    rng = np.random.default_rng(3)
    vertices, faces = sphere()
    for normal in rng.normal(size=(20, 3)):
        (frame,) = parallel_planes(rng.uniform(-20, 20, 3), normal, 0.0)
        line = mesh_sections(vertices, faces, [frame])[0].line
        places = line.places
        assert np.abs(frame.local(places)[:, 2]).max() < 1e-12
        edges = np.unique(
            np.sort(np.concatenate([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [0, 2]]]), 1), axis=0
        )
        a, b = vertices[edges[:, 0]], vertices[edges[:, 1]]
        step = b - a
        ok = (step**2).sum(1) > 0
        a, step = a[ok], step[ok]
        for place in places[::7]:
            u = np.clip(((place - a) * step).sum(1) / (step**2).sum(1), 0, 1)
            assert np.linalg.norm(a + u[:, None] * step - place, axis=1).min() < 1e-9


@pytest.mark.parametrize(
    ("at", "length"), [((5, 0, 0), 40.0), ((0, 0, 0), 40.0), ((10, 0, 0), 40.0), ((5, 5, 5), 40.0)]
)
def test_faces_in_the_plane(at, length):
    """A face in the plane counts with its outline, from either side."""
    vertices, faces = cube()
    (frame,) = parallel_planes(at, (1, 0, 0), 0.0)
    section = mesh_sections(vertices, faces, [frame])[0]
    assert section.line.length == pytest.approx(length)
    assert section.line.is_closed


def test_plane_through_edges_and_corners():
    """The diagonal plane of a cube runs along two edges and two face diagonals."""
    vertices, faces = cube()
    (frame,) = parallel_planes((0, 0, 0), (1, -1, 0), 0.0)
    line = mesh_sections(vertices, faces, [frame])[0].line
    assert line.length == pytest.approx(20 + 20 * np.sqrt(2))


def test_a_corner_that_touches_is_no_line():
    vertices, faces = cube()
    (frame,) = parallel_planes((0, 0, 0), (1, 1, 1), 0.0)
    section = mesh_sections(vertices, faces, [frame])[0]
    assert section.lines == ()
    assert section.reports[-1].endswith(
        "touches the mesh near (0, 0, 0) mm without cutting it: move the plane"
    )


def test_misses_are_reported_and_the_others_go_on():
    vertices, faces = sphere()
    sections = mesh_sections(vertices, faces, parallel_planes((0, 0, 0), (0, 1, 0), (-60, 0, 60)))
    assert [len(s.lines) for s in sections] == [0, 1, 0]
    assert sections[2].reports == (
        "section 3 at (0, 60, 0) mm: the plane misses the mesh by 10.1 mm: move the plane",
    )
    with pytest.raises(InputError, match=r"section 3 at .* misses"):
        _ = sections[2].line


def test_open_meshes_run_upwards_and_several_lines_are_reported():
    u, v = np.meshgrid(np.linspace(0, np.pi, 30), np.linspace(0, 30, 5), indexing="ij")
    vertices, faces = grid(-20 * np.cos(u), v, 20 * np.sin(u) ** 2 + 0.0)
    vertices[:, 2] += 0.01 * vertices[:, 0]
    line = mesh_sections(vertices, faces, [Frame((0, 11, 0), (1, 0, 0), (0, 0, 1))])[0].line
    assert not line.is_closed
    assert line.points[0] == pytest.approx([-20, -0.2])
    sections = mesh_sections(vertices, faces, [Frame((0, 0, 10.0))])
    assert len(sections[0].lines) == 2
    assert sections[0].reports[0].startswith("the mesh is open along 66 edges (near (")
    assert len(sections[0].reports[0]) < 250  # a few places, not all of them
    assert "section 1 consists of 2 separate lines" in sections[0].reports[1]


def test_an_edge_of_an_open_mesh_in_the_plane_is_kept():
    u, v = np.meshgrid(np.linspace(0, np.pi, 30), np.linspace(0, 30, 5), indexing="ij")
    vertices, faces = grid(-20 * np.cos(u), v, 20 * np.sin(u))
    for y in (0.0, 30.0):
        section = mesh_sections(vertices, faces, [Frame((0, y, 0), (1, 0, 0), (0, 0, 1))])[0]
        assert section.line.length == pytest.approx(20 * np.pi, rel=1e-3)
        assert "is exactly in the plane" in section.reports[1]


def test_broken_meshes_are_described():
    vertices, faces = cube()
    worse = np.concatenate([faces, faces[:1], [[0, 0, 1]], [[0, 1, 7]]])
    worse[3] = worse[3][::-1]
    mesh = Mesh(vertices, worse)
    text = " ".join(mesh.reports)
    assert len(mesh.faces) == 13
    for words in (
        "no area",
        "there twice",
        "more than two faces meet",
        "opposite orientations",
        "is open along 1 edge ",
    ):
        assert words in text
    repeated = Mesh(vertices[faces].reshape(-1, 3), np.arange(36).reshape(-1, 3))  # as STL files are
    assert len(repeated.vertices) == 8
    (section,) = mesh_sections(
        vertices[faces].reshape(-1, 3), np.arange(36).reshape(-1, 3), [Frame((0, 0, 5))]
    )
    assert section.line.is_closed


@pytest.mark.parametrize(
    ("vertices", "faces", "words"),
    [
        (np.zeros((3, 2)), [[0, 1, 2]], r"vertices \(n, 3\)"),
        (np.eye(3), np.zeros((0, 3), int), "no triangles"),
        (np.eye(3), [[0, 1, 3]], "vertex 3, but the mesh has 3 vertices"),
        (np.eye(3), [[0.0, 1.0, 2.0]], "whole numbers"),
        (np.full((3, 3), np.nan), [[0, 1, 2]], "give finite coordinates"),
        (np.zeros((3, 3)), [[0, 1, 2]], "have zero area: export"),
    ],
)
def test_bad_meshes(vertices, faces, words):
    with pytest.raises(InputError, match=words):
        Mesh(vertices, faces)


def test_half_planes_about_an_axis():
    vertices, faces = sphere()
    planes = radial_planes((0, 0, 0), (0, 0, 1), 2 * np.pi * (np.arange(7) + 0.13) / 7)
    for section in mesh_sections(vertices, faces, planes, half=True):
        points = section.line.points
        assert points[:, 0].min() > -1e-9
        assert np.diff(points[:, 1]).min() > 0
        assert points[[0, -1]] == pytest.approx(np.array([[0, -50], [0, 50]]), abs=1e-9)


def test_planes_along_a_path():
    u = np.linspace(0, np.pi / 2, 400)
    frames = planes_along(np.column_stack([80 * np.cos(u), 80 * np.sin(u), 0 * u]), 9, ends=True)
    way = np.linspace(0, np.pi / 2, 9)
    for frame, angle in zip(frames, way, strict=True):
        assert frame.origin == pytest.approx([80 * np.cos(angle), 80 * np.sin(angle), 0], abs=1e-3)
        assert np.abs(frame.z_axis @ [-np.sin(angle), np.cos(angle), 0]) == pytest.approx(1, abs=1e-4)
        assert frame.y_axis @ [0, 0, 1] == pytest.approx(1)
    for words, arguments in (
        ("two different points", ([(0, 0, 0)] * 2, 2)),
        ("give a whole number of planes from 1", ([(0, 0, 0), (1, 0, 0)], 0)),
        ("right angles to the plane", ([(0, 0, 0), (0, 0, 1)], 2)),
    ):
        with pytest.raises(InputError, match=words):
            planes_along(*arguments)


def test_split_at_a_spine_and_at_points():
    vertices, faces = sphere()
    line = mesh_sections(vertices, faces, [Frame((0, 1.0, 0), (1, 0, 0), (0, 0, 1))])[0].line
    left, right = line.split_by((0, 0, 0), (1, 0, 0))
    for piece in (left, right):
        assert piece.points[[0, -1], 0] == pytest.approx([0, 0], abs=1e-12)
    assert left.length + right.length == pytest.approx(line.length)
    assert left.length == pytest.approx(line.length / 2, rel=1e-3)
    pieces = line.split_at([(50, 0), (0, 50), (-50, 0)])
    assert len(pieces) == 3
    assert sum(p.length for p in pieces) == pytest.approx(line.length)
    (untouched,) = line.split_by((0, 0, 90), (0, 0, 1))
    assert untouched is line
    with pytest.raises(InputError, match="split twice"):
        left.split_at([left.points[5], left.points[5]])
    assert len(left.split_at([left.points[5]])) == 2


def test_split_at_corners():
    """Of an open line, whose pieces end where it does, and of a closed one."""
    bent = SectionLine(np.array([(0, 0), (10, 1), (20, 0), (20, 10), (21, 20), (20, 31)]), UPRIGHT, "roof")
    first, second = bent.split_at_corners(1.0)
    assert first.points.tolist() == [[0, 0], [10, 1], [20, 0]]
    assert second.points.tolist() == [[20, 0], [20, 10], [21, 20], [20, 31]]
    assert bent.split_at_corners(2.0) == (bent,)
    for corners in (
        [(0, 0), (5, 0), (9, 0), (9, 9), (0, 9), (0, 0)],
        [(0, 0), (9, 0), (9, 9), (0, 9), (0, 0)],
    ):
        sides = SectionLine(np.array(corners), UPRIGHT, "well").split_at_corners(1.0)
        assert sorted(side.length for side in sides) == [9, 9, 9, 9]


def test_smoothing_halves_a_wave_and_keeps_ends():
    x = np.linspace(0, 400, 4000)
    wave = np.column_stack([x, 0.05 * np.sin(2 * np.pi * x / 40)])
    after = smooth_polyline(wave, 40.0, count=800)
    inside = (after[:, 0] > 100) & (after[:, 0] < 300)
    assert np.abs(after[inside, 1]).max() == pytest.approx(0.025, rel=0.02)
    assert after[[0, -1]] == pytest.approx(wave[[0, -1]])


def test_false_inflections_go_and_true_ones_stay():
    x = np.linspace(-100, 100, 200)
    rng = np.random.default_rng(1)
    rough = np.column_stack([x, 30 * np.sin(x / 32) + rng.normal(0, 0.015, x.size)])
    curve = PlaneCurve.fit(rough[::3], tolerance=0.005)
    assert curve.inflections.size > 3
    simple = remove_false_inflections(curve)
    assert simple.inflections.size == 1
    assert simple.evaluate(simple.domain[0]) == pytest.approx(curve.evaluate(curve.domain[0]))
    place = np.abs(simple.at(simple.inflections).position[:, 0]).min()
    assert place < 4
    same = PlaneCurve.fit(np.column_stack([x, 30 * np.sin(x / 32)]), tolerance=1e-3)
    assert remove_false_inflections(same) is same


def test_closed_lines_are_refused_and_the_others_go_on():
    vertices, faces = sphere()
    sections = mesh_sections(vertices, faces, [UPRIGHT, Frame((0, 500, 0), (1, 0, 0), (0, 0, 1))])
    curves, reports = section_curves([*sections, *sections[0].line.split_by((0, 0, 0), (1, 0, 0))])
    assert len(curves) == 2
    assert any("closed" in text and text.startswith("section 1") for text in reports)
    assert any("misses" in text for text in reports)
    for found in curves:
        assert found.curve.length == pytest.approx(50 * np.pi, rel=2e-3)
        assert found.deviation < 0.3
        assert found.removed == 0
        assert found.curve.degree == 4


def test_a_line_in_space():
    line = SectionLine(np.array([[0.0, 0], [3, 4]]), Frame((1, 2, 3), (0, 1, 0), (0, 0, 1)), "l")
    assert line.places.tolist() == [[1, 2, 3], [1, 5, 7]]
    assert line.reversed().points.tolist() == [[3, 4], [0, 0]]


def vase(count=60):
    """A wave of revolution, whose second inflection lies near its rim."""
    z, u = np.meshgrid(np.linspace(0, 200, count), np.linspace(0, 2 * np.pi, 81), indexing="ij")
    r = 60 + 25 * np.sin(2 * np.pi * z / 200 + 0.4)
    return grid(r * np.cos(u), r * np.sin(u), z)


def test_a_gentle_end_is_no_scatter():
    """Its last 16 mm turn by less than 4 degrees, as designed: kept, in words that say so."""
    sections = mesh_sections(*vase(), radial_planes((0, 0, 0), (0, 0, 1), (0.0, 0.5)), half=True)
    curves, reports = section_curves(sections)
    assert len(curves) == 2
    assert not any("scatter" in text for text in reports)
    result = [text for text in reports if text.startswith("section 1: ") and "(212 to" in text]
    assert result
    assert result[0].endswith("was not changed")
    assert curves[0].curve.inflections.size == 2


def test_a_curve_far_from_its_section_is_reported():
    t = np.linspace(0, np.pi, 200)
    arch = SectionLine(100 * np.column_stack([-np.cos(t), np.sin(t)]), UPRIGHT, "arch")
    near, far = (section_curves([arch], wavelength=wavelength) for wavelength in (20.0, 1e6))
    assert near[1] == ()
    assert far[0][0].deviation > 1.0
    (message,) = far[1]
    assert message.startswith(f"arch: the curve is {far[0][0].deviation:.3g} mm from the section at (")
    assert "waves shorter than 1000000 mm" in message


def test_waves_longer_than_the_line_leave_a_parabola():
    x = np.linspace(-50, 50, 300)
    even = smooth_polyline(np.column_stack([x, np.cos(x / 20)]), 1e9)
    assert np.abs(np.diff(even[:, 1], 3)).max() < 1e-6


def test_a_corner_that_cannot_be_followed_is_named():
    x = np.arange(1200) / 10
    saw = SectionLine(np.column_stack([x, np.where(np.arange(1200) % 4 < 2, 0.0, 0.1)]), UPRIGHT, "saw")
    curves, (message,) = section_curves([saw], tolerance=1e-3)
    assert curves == ()
    assert message.startswith(
        "saw: no smooth curve stays within the tolerance of 0.001 mm, because the section has a corner of 45 "
    )
    assert "Split the section at its corners" in message


@pytest.mark.parametrize(
    ("wishes", "words"),
    [
        ({"tolerance": "a"}, "tolerance is 'a': give a number above 0"),
        ({"tolerance": np.nan}, "tolerance is nan"),
        ({"wavelength": None}, "wavelength is None"),
        ({"false_turn": np.nan}, "false_turn is nan: give an angle"),
        ({"false_turn": -0.1}, "false_turn is -0.1"),
    ],
)
def test_bad_wishes(wishes, words):
    with pytest.raises(InputError, match=words):
        section_curves([], **wishes)


@pytest.mark.parametrize(
    ("call", "words"),
    [
        (lambda: planes_along([(0, 0, 0), (9, 0, 0)], 2.5), r"count is 2\.5: give a whole number of planes"),
        (lambda: planes_along([(0, 0, 0), (9, 0, 0)], "2"), "count is '2'"),
        (lambda: parallel_planes((0, 0, 0), (0, 1, 0), "abc"), "offsets is 'abc': give numbers"),
        (
            lambda: parallel_planes((0, 0, 0), (0, 1, 0), [[1, 2]]),
            r"offsets has the shape \(1, 2\): give a number or a list",
        ),
        (lambda: radial_planes((0, 0, 0), (0, 0, 1), None), "angles is nan: give finite numbers"),
        (
            lambda: mesh_sections(*cube(), UPRIGHT),
            "planes are a Frame: give a sequence of Frames, with a single plane in a list",
        ),
        (lambda: mesh_sections(*cube(), None), "planes are a NoneType"),
        (lambda: mesh_sections(*cube(), [UPRIGHT, 3]), "sequence of Frames"),
    ],
)
def test_bad_planes(call, words):
    with pytest.raises(InputError, match=words):
        call()


def test_the_sharpest_corner_of_a_section_is_listed_with_its_place():
    rng = np.random.default_rng(3)
    x = np.arange(400) / 10
    rough = np.column_stack([x, 0.02 * rng.random(400)])
    rough[200:, 1] += 3 * (x[200:] - 20)
    curves, (message,) = section_curves([SectionLine(rough, UPRIGHT, "roof")], tolerance=1e-3)
    assert curves == ()
    step = np.diff(rough, axis=0)
    turns = np.abs(np.diff(np.arctan2(step[:, 1], step[:, 0])))
    x, y, z = UPRIGHT.point(rough[1 + turns.argmax()])
    assert f"a corner of {np.degrees(turns.max()):.3g} degrees at ({x:.4g}, {y:.4g}, {z:.4g}) mm" in message


@pytest.mark.parametrize("end", [(-60.0, 5.0), (60.0, 5.0), (20.0, 40.0), (-20.0, 40.0)])
@pytest.mark.parametrize("start", [(-30.0, 5.0), (30.0, 5.0)])
@pytest.mark.parametrize("way", [1, -1])
def test_a_section_runs_up_and_a_level_one_to_the_right(start, end, way):
    drawn = np.linspace(start, end, 9)[::way]
    run = tidy_points(drawn, 1e-6)
    assert (run[-1, 1], run[-1, 0]) > (run[0, 1], run[0, 0])
    assert sorted(map(tuple, run)) == sorted(map(tuple, drawn))


@pytest.mark.parametrize("middle", [(0.0, 30.0), (5.0, -10.0)])
def test_the_ends_of_a_line_and_not_its_middle_determine_its_direction(middle):
    points = np.array([(0.0, 0.0), middle, (10.0, 10.0)])
    assert tidy_points(points, 1e-6) == pytest.approx(points)
    assert tidy_points(points[::-1], 1e-6) == pytest.approx(points)


def drum(radius=50.0, height=120.0, sides=24):
    """A cylinder with lids, as coarse as STL files are: its sections have vertices at the corners alone."""
    u, r = np.meshgrid(np.linspace(0, 2 * np.pi, sides + 1), [0, radius, radius, 0])
    return grid(r * np.cos(u), r * np.sin(u), np.array([0, 0, height, height])[:, None] + 0 * u)


def test_corners_of_coarse_meshes_are_named_and_split():
    (section,) = mesh_sections(*drum(), radial_planes((0, 0, 0), (0, 0, 1), 0.1), half=True)
    curves, reports = section_curves([section])
    assert curves == ()
    assert "a corner of 90 degrees" in reports[-1]
    assert "Split the section at its corners" in reports[-1]
    curves, _ = section_curves(section.line.split_at_corners(1.0))
    assert sorted(round(found.curve.length) for found in curves) == [50, 50, 120]


@pytest.mark.parametrize("wavelength", [0.0, 90.0])
def test_the_reported_distance_holds_both_ways_and_between_vertices(wavelength):
    """Beside the nearest of some thousand points on either line."""
    angles = np.linspace(0, 3, 13) + np.random.default_rng(0).uniform(-0.05, 0.05, 13)
    line = SectionLine(60 * np.column_stack([-np.cos(angles), np.sin(angles)]), UPRIGHT, "coarse")
    ((found,), _) = section_curves([line], wavelength=wavelength)
    drawn = found.curve.evaluate(np.linspace(*found.curve.domain, 4001))
    at = np.linspace(0, 12, 4001)
    lines = np.column_stack([np.interp(at, np.arange(13), column) for column in line.points.T])
    apart = max(cKDTree(one).query(other)[0].max() for one, other in ((drawn, lines), (lines, drawn)))
    assert found.deviation == pytest.approx(apart, abs=0.01)
