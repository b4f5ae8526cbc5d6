import sys
from functools import partial

import ezdxf
import numpy as np
import pytest
from scipy.interpolate import BSpline, CubicSpline

from elastica_cad import Drawing, InputError, MissingDependencyError, Path, check_equilibrium, read_curves
from elastica_cad.files import read_drawing
from elastica_cad.formats import encode_dxf
from elastica_cad.geometry import Line
from elastica_cad.strip import MARK, LayeredPath

S_POINTS = np.array([(0, 0), (30, 40), (60, -40), (90, 10), (120, 0)], dtype=float)


@pytest.fixture
def drawing(tmp_path):
    """A function that draws into a new file's model space and reads its curves back."""

    def draw(what, *, units=4, version="R2010", **options):
        document = ezdxf.new(version, units=units)
        what(document.modelspace(), document)
        path = tmp_path / "drawn.dxf"
        document.saveas(path)
        return read_curves(path, **options)

    return draw


def spaced(curve, count=400):
    return curve.sample(count).position


def test_spline_comes_back_bit_by_bit(drawing):
    knots = [0, 0, 0, 0, 0.4, 1, 1, 1, 1]

    def draw(space, _):
        space.add_rational_spline(
            control_points=[(*p, 0) for p in S_POINTS], weights=[1, 2, 1, 0.5, 1], degree=3, knots=knots
        )

    (curve,) = drawing(draw)
    assert curve.degree == 3
    assert np.array_equal(curve.knots, knots)
    assert np.array_equal(curve.control_points, S_POINTS)
    assert np.array_equal(curve.weights, [1, 2, 1, 0.5, 1])


def test_unclamped_spline_keeps_its_knots(drawing):
    def draw(space, _):
        spline = space.add_spline()
        spline.dxf.degree = 3
        spline.control_points = [(*p, 0) for p in S_POINTS]
        spline.knots = np.arange(9.0)

    (curve,) = drawing(draw)
    assert np.array_equal(curve.knots, np.arange(9.0))
    assert curve.domain == (3.0, 5.0)


def test_spline_of_fit_points_passes_them(drawing):
    (curve,) = drawing(lambda space, _: space.add_spline([(*p, 0) for p in S_POINTS]))
    dense = spaced(curve, 20001)
    gaps = [np.hypot(*(dense - p).T).min() for p in S_POINTS]
    assert max(gaps) < 0.01
    assert curve.evaluate(curve.domain[0]) == pytest.approx(S_POINTS[0], abs=1e-9)


def test_arc_is_exact_and_anticlockwise(drawing):
    (curve,) = drawing(lambda space, _: space.add_arc((10, 20), 50, 350, 80))
    assert np.abs(np.hypot(*(spaced(curve) - (10, 20)).T) - 50).max() < 1e-12
    assert curve.length == pytest.approx(50 * np.pi / 2, rel=1e-12)
    assert curve.sample(5).curvature == pytest.approx(np.full(5, 1 / 50))


def test_mirrored_arc_lies_where_other_programs_draw_it(drawing):
    def draw(space, _):
        space.add_arc((10, 20), 50, 0, 90, dxfattribs={"extrusion": (0, 0, -1)})

    (curve,) = drawing(draw)
    ends = curve.evaluate(np.array(curve.domain))
    assert ends == pytest.approx(np.array([(-60, 20), (-10, 70)]), abs=1e-9)
    assert curve.sample(3).curvature == pytest.approx(np.full(3, -1 / 50))


@pytest.mark.parametrize("extrusion", [(0, 0, 1), (0, 0, -1)])
def test_ellipse_is_exact(drawing, extrusion):
    def draw(space, _):
        space.add_ellipse((5, 6), (8, 6), 0.4, 0.5, 3.0, dxfattribs={"extrusion": extrusion})

    (curve,) = drawing(draw)
    local = (spaced(curve) - (5, 6)) @ np.array([[0.8, -0.6], [0.6, 0.8]])
    assert np.abs((local[:, 0] / 10) ** 2 + (local[:, 1] / 4) ** 2 - 1).max() < 1e-12
    assert np.sign(curve.sample(3).curvature).tolist() == [extrusion[2]] * 3
    start = local[0] / (10, 4)
    assert np.arctan2(*start[::-1]) * extrusion[2] == pytest.approx(0.5)


def test_polyline_with_arcs_is_an_exact_chain(drawing):
    rows = [(0, 0, 0), (100, 0, 1), (100, 60, 0), (20, 60, -np.tan(np.pi / 8)), (0, 80, 0), (0, 100, 0)]
    (curve,) = drawing(lambda space, _: space.add_lwpolyline(rows, format="xyb"))
    assert curve.length == pytest.approx(100 + 30 * np.pi + 80 + 20 * np.pi / 2 + 20, rel=1e-12)
    assert curve.degree == 2
    assert not curve.tangent_breaks
    at = curve.at(np.array([50.0, 100 + 15 * np.pi, 180 + 30 * np.pi + 1]))
    assert at.curvature == pytest.approx([0, 1 / 30, -1 / 20], abs=1e-9)
    assert at.position[1] == pytest.approx((130, 30), abs=1e-9)


def test_a_vertex_drawn_twice_counts_once(drawing):
    rows = [(0, 0, 0), (100, 0, 1), (100, 0, 1), (100, 60, 0), (20, 60, 0), (20, 60, 0)]
    (curve,) = drawing(lambda space, _: space.add_lwpolyline(rows, format="xyb"))
    assert curve.length == pytest.approx(100 + 30 * np.pi + 80, rel=1e-12)


def test_knots_that_go_back_by_rounding_are_mended(drawing):
    def draw(space, _):
        spline = space.add_spline()
        spline.dxf.degree = 3
        spline.control_points = [(*p, 0) for p in S_POINTS]
        spline.knots = [0, 0, 0, 0, 0.4, 1, 1 - 1e-12, 1, 1]

    (curve,) = drawing(draw)
    assert np.array_equal(curve.knots, [0, 0, 0, 0, 0.4, 1, 1, 1, 1])


def test_arcs_of_polylines_match_another_reading(drawing):
    """All bulges, more than half turns too, against ezdxf's own arc construction."""
    from ezdxf.math import bulge_to_arc

    for bulge in (1e-9, 1e-3, -0.2, 0.41, -0.9, 1.5, -8.0):
        (curve,) = drawing(
            lambda space, _, b=bulge: space.add_lwpolyline([(3, 4, b), (40, 9, 0)], format="xyb")
        )
        center, start, end, radius = bulge_to_arc((3, 4), (40, 9), bulge)
        assert curve.length == pytest.approx(radius * ((end - start) % (2 * np.pi)), rel=1e-6)
        assert curve.evaluate(np.array(curve.domain)) == pytest.approx(np.array([(3, 4), (40, 9)]), abs=1e-9)
        if abs(bulge) > 1e-6:
            assert np.abs(np.hypot(*(spaced(curve) - center).T) - radius).max() < 1e-9 * radius
        assert np.sign(curve.sample(3).curvature[1]) == np.sign(bulge)


@pytest.mark.parametrize("kind", ["lwpolyline", "polyline2d", "polyline3d"])
def test_plain_polyline_is_fitted(drawing, kind):
    v = np.linspace(0.2, 2.8, 120)
    points = np.column_stack([90 * np.cos(v), 60 * np.sin(v)])

    def draw(space, _):
        if kind == "polyline3d":
            space.add_polyline3d([(*p, 7.0) for p in points])
        else:
            getattr(space, f"add_{kind}")(points)

    (curve,) = drawing(draw, fit_tolerance=0.01)
    assert curve.degree == 4
    assert len(curve.control_points) < 25
    assert np.abs(np.hypot(*(spaced(curve) / (90, 60)).T) - 1).max() < 5e-4
    assert not curve.tangent_breaks


def test_loose_lines_of_an_exploded_polyline_are_fitted_as_one(drawing):
    v = np.linspace(0, 1.5, 60)
    points = np.column_stack([100 * np.cos(v), 100 * np.sin(v)])

    def draw(space, _):
        for i in (*range(0, 59, 2), *range(1, 59, 2)):
            space.add_line(points[i + i % 2], points[i + 1 - i % 2])

    (curve,) = drawing(draw)
    assert curve.length == pytest.approx(150, abs=0.05)
    assert np.abs(np.hypot(*spaced(curve).T) - 100).max() < 0.06


def chain(space, _=None, gap=0.0):
    spline = space.add_spline()
    spline.dxf.degree = 3
    spline.control_points = [(-50, 100 + gap, 0), (-80, 100 + gap, 0), (-100, 80, 0), (-150, 120, 0)]
    spline.knots = [0] * 4 + [1] * 4
    space.add_line((-50, 100), (0, 100))
    space.add_arc((0, 0), 100, 0, 90)


def test_chain_of_line_arc_and_spline_is_one_exact_curve_in_the_way_of_its_first_piece(drawing):
    (curve,) = drawing(chain)
    assert curve.degree == 3
    assert curve.evaluate(np.array(curve.domain)) == pytest.approx(np.array([(100, 0), (-150, 120)]))
    assert not curve.tangent_breaks
    joints = [(b.s, b.continuity) for b in curve.breaks]
    assert joints == [(pytest.approx(50 * np.pi), 1), (pytest.approx(50 * np.pi + 50), 1)]
    on_arc = curve.at(np.linspace(0, 50 * np.pi, 99)).position
    assert np.abs(np.hypot(*on_arc.T) - 100).max() < 1e-11
    u = np.linspace(0, 1, 33)
    bezier = [
        np.polynomial.Polynomial([(1 - x) ** 3, 3 * x * (1 - x) ** 2, 3 * x**2 * (1 - x), x**3]).coef
        for x in u
    ]
    on_spline = np.array(bezier) @ [(-50, 100), (-80, 100), (-100, 80), (-150, 120)]
    a, b = curve.breaks[1].t, curve.domain[1]
    assert curve.evaluate(a + u * (b - a)) == pytest.approx(on_spline, abs=1e-11)


def test_small_gaps_are_closed_without_turning_tangents_and_large_ones_left(drawing):
    (curve,) = drawing(lambda space, _: chain(space, gap=0.004))
    assert not curve.tangent_breaks
    assert curve.evaluate(curve.domain[1]) == pytest.approx((-150, 119.996))
    assert len(drawing(lambda space, _: chain(space, gap=0.03))) == 2
    assert len(drawing(lambda space, _: chain(space, gap=0.03), tolerance=0.05)) == 1


@pytest.mark.parametrize("gap", [1e-4, 1e-3, 4e-3, 9e-3])
@pytest.mark.parametrize("where", ["between the ends", "in the radius"])
def test_arcs_over_gaps_of_micrometres_make_no_step_to_speak_of(drawing, gap, where):
    turn, radius = (np.degrees(gap / 100), 100) if where == "between the ends" else (0, 100 + gap)

    def draw(space, _):
        space.add_arc((0, 0), 100, 80 + turn, 140)
        space.add_arc((0, 0), radius, 20, 80)

    (curve,) = drawing(draw)
    assert "width" not in str(check_equilibrium(curve))


def test_splines_of_unlike_degree_join_exactly(drawing):
    points = np.array([(120, 0), (150, 0), (170, 30), (200, 30), (230, 0), (250, 40)], dtype=float)

    def draw(space, _):
        for degree, control in ((3, S_POINTS), (4, points)):
            spline = space.add_spline()
            spline.dxf.degree = degree
            spline.control_points = [(*p, 0) for p in control]
            spline.knots = np.arange(len(control) + degree + 1.0) if degree == 4 else [0] * 4 + [1] + [2] * 4
        spline.knots = [0] * 5 + [1] + [2] * 5

    from scipy.interpolate import BSpline

    (curve,) = drawing(draw)
    assert curve.degree == 4
    assert [b.continuity for b in curve.breaks] == [2, 0, 3]  # cubic knot, corner, quartic knot
    u = np.linspace(0, 2, 41)
    t = [curve.domain[0], curve.breaks[1].t, curve.domain[1]]
    cubic = BSpline([0] * 4 + [1] + [2] * 4, S_POINTS, 3)(u)
    assert curve.evaluate(t[0] + u / 2 * (t[1] - t[0]), left=True) == pytest.approx(cubic, abs=1e-10)
    quartic = BSpline([0] * 5 + [1] + [2] * 5, points, 4)(u)
    assert curve.evaluate(t[1] + u / 2 * (t[2] - t[1])) == pytest.approx(quartic, abs=1e-10)


def test_junctions_of_three_ends_are_not_joined(drawing):
    def draw(space, _):
        for angle in (0.1, 2.1, 4.1):
            space.add_line((0, 0), (50 * np.cos(angle), 50 * np.sin(angle)))

    assert [c.length for c in drawing(draw)] == pytest.approx([50, 50, 50])


def test_what_is_drawn_twice_counts_once(drawing):
    def draw(space, _):
        space.add_arc((0, 0), 50, 0, 90)
        space.add_line((0, 0), (50, 0))
        space.add_line((50, 0), (0, 0))
        space.add_arc((0, 0), 50, 0, 90)

    (curve,) = drawing(draw)
    assert curve.length == pytest.approx(25 * np.pi + 50)


@pytest.mark.parametrize(
    ("units", "factor"),
    [
        (0, 1), (1, 25.4), (2, 304.8), (3, 1609344), (4, 1), (5, 10), (6, 1000), (7, 1e6), (8, 25.4e-6),
        (9, 0.0254), (10, 914.4), (11, 1e-7), (12, 1e-6), (13, 1e-3), (14, 100), (15, 1e4), (16, 1e5),
        (17, 1e12), (21, 1200 / 3937 * 1000),
    ],
)  # fmt: skip
def test_units_of_the_file_become_mm(drawing, units, factor):
    """The units of $INSUNITS as the DXF reference lists them, an arc of 300 mm radius in each."""
    (curve,) = drawing(lambda space, _: space.add_arc((0, 0), 300 / factor, 0, 90), units=units)
    assert curve.length == pytest.approx(150 * np.pi, rel=1e-9)


@pytest.mark.parametrize(("version", "measurement", "size", "mm"), [
    ("R2010", 0, 12.5, 25.4), ("R2010", 0, 39, 25.4), ("R2010", 0, 41, 1), ("R2010", 1, 12.5, 1),
    ("R12", None, 12.5, 1), ("R2000", 0, 400, 1),
])  # fmt: skip
def test_a_unit_that_the_file_does_not_name_is_assumed_and_reported(drawing, version, measurement, size, mm):
    """Inches only if the file itself says that it measures in inches, and is small."""

    def draw(space, document):
        space.add_line((100, 7), (100 + size, 8))
        if measurement is not None:
            document.header["$MEASUREMENT"] = measurement

    curves = drawing(draw, units=0, version=version)
    assert curves[0].length == pytest.approx(mm * np.hypot(size, 1))
    (message,) = curves.notes
    unit, other = ("in", "mm") if mm > 1 else ("mm", "in")
    assert f"its unit is assumed to be {unit}, because the file has no unit" in message
    assert f"set unit to the right unit, such as {other}" in message
    for given in ("mm", "in"):
        assert not drawing(draw, units=0, version=version, unit=given).notes


def test_own_files_of_the_oldest_version_say_their_unit(tmp_path):
    path = tmp_path / "own.dxf"
    line = Drawing("own", (LayeredPath(MARK, Path((Line((0, 0), (30, 40)),))),))
    path.write_bytes(encode_dxf(line, version="R12"))
    assert not read_curves(path).notes


def test_given_unit_overrides_the_file(drawing):
    (curve,) = drawing(lambda space, _: space.add_line((0, 0), (3, 4)), units=6, unit="in")
    assert curve.length == pytest.approx(127.0)
    with pytest.raises(InputError, match="unknown unit 'furlong': use one of mm, cm"):
        drawing(lambda space, _: space.add_line((0, 0), (3, 4)), unit="furlong")


def test_unit_that_nobody_knows(drawing):
    with pytest.raises(InputError, match=r"drawn\.dxf: has an unknown unit .*INSUNITS = 18.* set the unit"):
        drawing(lambda space, _: space.add_line((0, 0), (3, 4)), units=18)


def test_blocks_are_exploded_with_their_transforms(drawing):
    def draw(space, document):
        inner = document.blocks.new("inner")
        inner.add_arc((0, 0), 10, 0, 90)
        outer = document.blocks.new("outer")
        outer.add_blockref("inner", (100, 0), dxfattribs={"xscale": -2, "yscale": 1})
        space.add_blockref("outer", (0, 50), dxfattribs={"rotation": 90})
        space.add_blockref("inner", (500, 0), dxfattribs={"row_count": 2, "row_spacing": 40})

    curves = drawing(draw)
    assert len(curves) == 3
    ends = np.sort(curves[0].evaluate(np.array(curves[0].domain)), axis=0)
    assert ends == pytest.approx(np.array([(-10, 130), (0, 150)]), abs=1e-9)
    local = (spaced(curves[0]) - (0, 150)) / (10, 20)
    assert np.abs(np.hypot(*local.T) - 1).max() < 1e-9
    assert [c.bounds[0] for c in curves[1:]] == [pytest.approx((500, 0)), pytest.approx((500, 40))]


@pytest.mark.parametrize(("turned", "scales"), [(45, (1, 3, 1)), (30, (2.5, -1, 1)), (-70, (1, 0.2, 0))])
def test_turned_blocks_within_unequally_scaled_blocks_are_sheared(drawing, turned, scales):
    def draw(space, document):
        inner = document.blocks.new("inner", base_point=(5, 7))
        spline = inner.add_spline()
        spline.dxf.degree = 4
        spline.control_points = [(*p, 0) for p in S_POINTS]
        spline.knots = [0] * 5 + [1] * 5
        outer = document.blocks.new("outer")
        outer.add_blockref("inner", (3, 4), dxfattribs={"rotation": turned})
        names = ("xscale", "yscale", "zscale")
        space.add_blockref("outer", (10, 20), dxfattribs=dict(zip(names, scales, strict=True)))

    (curve,) = drawing(draw)
    cos, sin = np.cos(np.radians(turned)), np.sin(np.radians(turned))
    placed = ((S_POINTS - (5, 7)) @ [(cos, sin), (-sin, cos)] + (3, 4)) * scales[:2] + (10, 20)
    assert np.abs(curve.control_points - placed).max() < 1e-9


@pytest.mark.parametrize(("angle", "axis"), [(0.5, 0), (0.9, 1), (-0.01, 1)])
def test_planes_within_a_degree_of_horizontal_keep_x_and_y(drawing, angle, axis):
    cos, sin = np.cos(np.radians(angle)), np.sin(np.radians(angle))
    points = [(x, y * cos, y * sin) if axis == 0 else (x * cos, y, x * sin) for x, y in S_POINTS]

    def draw(space, _):
        spline = space.add_spline()
        spline.dxf.degree = 4
        spline.control_points = points
        spline.knots = [0] * 5 + [1] * 5

    (curve,) = drawing(draw)
    assert np.abs(curve.control_points - S_POINTS).max() < 2e-4 * 120


def test_heights_of_some_hundredths_are_noise(drawing):
    def draw(space, _):
        spline = space.add_spline()
        spline.dxf.degree = 4
        spline.control_points = [(x, y, 0.02 * (-1) ** i) for i, (x, y) in enumerate(S_POINTS)]
        spline.knots = [0] * 5 + [1] * 5

    (curve,) = drawing(draw)
    assert np.array_equal(curve.control_points, S_POINTS)


def test_inner_knots_of_full_multiplicity_join_where_the_control_points_coincide(drawing):
    first = np.array([(0, 0), (20, 30), (40, 30), (60, 0)], dtype=float)
    second = np.array([(60, 0), (75, -22.5), (100, -30), (130, -30)])

    def draw(gap, space, _):
        spline = space.add_spline()
        spline.dxf.degree = 3
        spline.control_points = [(*p, 0) for p in [*first, *(second + np.array([0, gap]))]]
        spline.knots = [0] * 4 + [1] * 4 + [2] * 4

    (curve,) = drawing(partial(draw, 0))
    assert np.abs(curve.evaluate([0.5, 1, 1.5]) - [(30, 22.5), (60, 0), (89.375, -23.4375)]).max() < 1e-9
    with pytest.raises(InputError, match="repeated 4 times"):
        drawing(partial(draw, 1))


@pytest.mark.parametrize("multiplicity", [1, 2])
def test_periodic_splines_with_the_knots_of_one_period_close(drawing, multiplicity):
    corners = np.array([(0, 0), (100, -20), (160, 50), (120, 90), (40, 120), (-10, 80)], dtype=float)
    poles = corners[: 7 - multiplicity]
    single = [*[0, 1, 2.5, 3, 4, 6][: len(poles) + 1 - multiplicity], 7.0]

    def draw(space, _):
        spline = space.add_spline()
        spline.dxf.degree = 3
        spline.control_points = [(*p, 0) for p in poles]
        spline.knots = np.repeat(single, [multiplicity, *[1] * (len(single) - 2), multiplicity])
        spline.closed = True

    (curve,) = drawing(draw)
    knots = np.repeat(single, [multiplicity, *[1] * (len(single) - 2), multiplicity])[:-multiplicity]
    period = single[-1] - single[0]
    around = np.concatenate([knots - period, knots, knots + period])
    start = len(knots) + multiplicity - 1 - 3
    other = BSpline(around[start : start + len(poles) + 7], np.vstack([poles, poles[:3]]), 3)
    at = np.linspace(single[0], single[-1], 50)
    places = curve.evaluate(np.linspace(*curve.domain, 50))
    assert np.abs(places - other(at))[:-1].max() < 1e-9
    assert np.linalg.norm(places[0] - places[-1]) < 1e-9


@pytest.mark.parametrize("height", [0.0, 12.0])
def test_a_flat_helix_is_read_as_its_spline(drawing, height):
    def draw(space, _):
        helix = space.add_helix(40, height / 2, 2)
        if not height:
            helix.control_points = [
                (p[0] * (1 + i / 9), p[1] * (1 + i / 9), 0) for i, p in enumerate(helix.control_points)
            ]
        space.add_arc((500, 0), 50, 0, 90)

    assert len(drawing(draw)) == (1 if height else 2)


def test_a_drawing_of_autocad_is_named(tmp_path):
    path = tmp_path / "renamed.dxf"
    path.write_bytes(b"AC1027\0\0" + bytes(200))
    with pytest.raises(InputError, match="DWG"):
        read_curves(path)


def test_names_of_layers_in_other_encodings_are_readable(tmp_path):
    document = ezdxf.new("R2010", units=4)
    document.modelspace().add_arc((0, 0), 50, 0, 90, dxfattribs={"layer": "Kantexx"})
    path = tmp_path / "drawn.dxf"
    document.saveas(path)
    path.write_bytes(path.read_bytes().replace(b"Kantexx", "Kante\xfc".encode("cp1252")))
    assert [one.layer for one in read_drawing(path).chosen(None, "Kante\xfc")] == ["Kante\xfc"]


def test_upright_plane_is_read_with_z_up(drawing):
    def draw(space, _):
        spline = space.add_spline()
        spline.dxf.degree = 4
        spline.control_points = [(x, 30.0, y) for x, y in S_POINTS]
        spline.knots = [0] * 5 + [1] * 5

    (curve,) = drawing(draw)
    assert curve.control_points == pytest.approx(S_POINTS, abs=1e-9)


def test_curve_at_any_height_over_the_plane(drawing):
    (curve,) = drawing(lambda space, _: space.add_arc((0, 0, 77), 50, 0, 90))
    assert np.abs(np.hypot(*spaced(curve).T) - 50).max() < 1e-12


def test_spline_off_its_plane_is_reported_how_far(drawing):
    def draw(space, _):
        spline = space.add_spline()
        spline.dxf.degree = 4
        spline.control_points = [(x, y, x * y / 30) for x, y in S_POINTS]
        spline.knots = [0] * 5 + [1] * 5

    with pytest.raises(
        InputError, match=r"drawn\.dxf: a curve leaves its plane by [\d.]+ mm .*project the curve"
    ):
        drawing(draw)


def test_full_circle_and_closed_polyline_come_back_closed(drawing):
    def draw(space, _):
        space.add_circle((0, 0), 20)
        space.add_lwpolyline([(100, 0), (140, 0), (140, 30), (100, 30)], close=True)

    circle, frame = drawing(draw)
    assert circle.is_closed
    assert circle.length == pytest.approx(40 * np.pi)
    assert frame.is_closed
    assert frame.length == pytest.approx(140)  # corners stay corners
    assert len(frame.tangent_breaks) == 3


def test_version_without_units_header(drawing):
    (curve,) = drawing(
        lambda space, _: space.add_polyline2d([(0, 0, 1), (30, 0, 0)], format="xyb"), version="R12"
    )
    assert curve.length == pytest.approx(15 * np.pi)


def test_file_without_curves_says_what_it_holds(drawing):
    def draw(space, _):
        space.add_text("hello")
        space.add_point((1, 2))
        space.add_point((3, 2))

    with pytest.raises(InputError, match=r"drawn\.dxf: has no curve .*\(found only 2 POINT, 1 TEXT\)"):
        drawing(draw)
    with pytest.raises(InputError, match="has no curve"):
        drawing(lambda space, _: None)


@pytest.mark.parametrize(
    "data", [b"hello\n", b"\x00\x01\x02" * 50, b"0\nSECTION\n2\nENTITIES\n0\n", b"  \n \n"]
)
def test_other_files_are_no_dxf_files(tmp_path, data):
    path = tmp_path / "bad.dxf"
    path.write_bytes(data)
    with pytest.raises(InputError, match=r"bad\.dxf: (is not a readable DXF file|has no curve)"):
        read_curves(path)


def test_damaged_number_is_not_guessed(drawing, tmp_path, capfd):
    drawing(lambda space, _: space.add_line((0, 0), (123.75, 4)))
    path = tmp_path / "drawn.dxf"
    path.write_bytes(path.read_bytes().replace(b"123.75", b"12x.75"))
    with pytest.raises(InputError, match=r"drawn\.dxf: is damaged .*12x\.75.* near line \d+"):
        read_curves(path)
    assert capfd.readouterr() == ("", "")


@pytest.mark.campaign
def test_a_file_cut_short_anywhere_is_refused_in_words_or_read(drawing, tmp_path, capfd):
    drawing(lambda space, _: space.add_arc((0, 0), 50, 10, 120))
    path = tmp_path / "drawn.dxf"
    whole = path.read_bytes()
    unread, named = 0, 0
    for size in np.linspace(1, len(whole) - 1, 40).astype(int):
        path.write_bytes(whole[:size])
        try:
            (curve,) = read_curves(path)
        except InputError as error:
            unread += 1
            named += str(error).startswith(str(path))
        else:
            assert curve.length == pytest.approx(50 * np.radians(110))
    assert named == unread > 20
    assert capfd.readouterr() == ("", "")


def test_pieces_of_no_length_are_reported(drawing):
    with pytest.raises(InputError, match=r"has no curve .*\(found only 1 LINE of no length\)"):
        drawing(lambda space, _: space.add_line((3, 3), (3, 3)))


@pytest.mark.parametrize(
    ("draw", "note"),
    [
        (lambda space, _: space.add_line((200, 0), (200, 0)), "1 LINE of no length"),
        (lambda space, _: space.add_circle((200, 0), 0), "1 CIRCLE of no length"),
        (lambda space, _: space.add_lwpolyline([(200, 0)]), "1 LWPOLYLINE of no length"),
        (lambda space, _: space.add_polyline2d([(7, 7), (7, 7)]), "1 POLYLINE of no length"),
        (
            lambda space, _: space.add_blockref("none", (0, 0)),
            "1 INSERT of a block that the file does not hold",
        ),
        (lambda _, document: document.paperspace().add_line((0, 0), (99, 0)), "1 on paper layout Layout1"),
    ],
)
def test_what_is_not_read_is_named(drawing, draw, note):
    def also(space, document):
        space.add_arc((0, 0), 50, 10, 120)
        draw(space, document)

    (found,) = drawing(also).notes
    assert note in found


def test_nan_in_a_file_is_refused(drawing):
    def draw(space, _):
        space.add_lwpolyline([(0, 0), (10, float("nan")), (20, 0)])

    with pytest.raises(InputError, match=r"drawn\.dxf: .*finite|drawn\.dxf: is not a DXF file"):
        drawing(draw)


def test_missing_library_is_said_in_one_sentence(drawing, tmp_path, monkeypatch):
    drawing(lambda space, _: space.add_line((0, 0), (1, 1)))
    monkeypatch.setitem(sys.modules, "ezdxf", None)
    with pytest.raises(MissingDependencyError, match=r"reading drawn\.dxf needs ezdxf.*pip install ezdxf"):
        read_curves(tmp_path / "drawn.dxf")


def test_what_a_drawing_hides_is_left_out_and_reported(drawing):
    """Guide lines on a layer that is off, or frozen, were curves among the others."""

    def draw(space, document):
        for name in ("guides", "Frost"):
            document.layers.add(name)
        document.layers.get("guides").off()
        document.layers.get("Frost").freeze()
        block = document.blocks.new("rib")
        block.add_arc((0, 0), 50, 0, 180)  # on the layer of the block
        block.add_arc((0, 0), 30, 0, 180, dxfattribs={"layer": "Cut"})
        space.add_arc((0, 0), 100, 0, 180, dxfattribs={"layer": "Cut"})
        space.add_arc((0, 0), 90, 0, 180, dxfattribs={"layer": "GUIDES"})
        space.add_arc((0, 0), 80, 0, 180, dxfattribs={"invisible": 1})
        space.add_blockref("rib", (300, 0), dxfattribs={"layer": "guides"})
        space.add_blockref("rib", (600, 0), dxfattribs={"layer": "frost"})

    found = drawing(draw)
    assert [curve.length for curve in found] == pytest.approx([100 * np.pi, 30 * np.pi])
    (note,) = found.notes
    for hidden in (
        "1 hidden on layer 0",
        "1 hidden on layer GUIDES",
        "1 hidden on layer guides",
        "1 hidden on layer frost",
    ):
        assert hidden in note


def test_a_drawing_that_hides_all_says_where(drawing):
    def draw(space, document):
        document.layers.add("guides").off()
        space.add_arc((0, 0), 90, 0, 180, dxfattribs={"layer": "guides"})

    with pytest.raises(InputError, match="found only 1 hidden on layer guides"):
        drawing(draw)


@pytest.mark.parametrize("again", [False, True])
def test_a_closed_spline_of_fit_points_closes_smoothly(drawing, again):
    """It ended at its last point, a quarter of the ring short."""
    places = [(100.0, 0.0), (0.0, 80.0), (-100.0, 0.0), (0.0, -80.0)]

    def draw(space, _):
        spline = space.add_spline([(*p, 0) for p in [*places, *places[: int(again)]]])
        spline.closed = True

    (curve,) = drawing(draw)
    assert curve.is_closed
    assert len(curve.inflections) == 0
    assert curve.length == pytest.approx(559.5, abs=0.1)
    dense = spaced(curve, 4001)
    for place in places:
        assert np.min(np.linalg.norm(dense - place, axis=1)) < 0.2
    ends = curve.sample(2)
    assert ends.curvature[0] == pytest.approx(ends.curvature[-1])
    assert np.cos(ends.angle[0]) == pytest.approx(np.cos(ends.angle[-1]))


@pytest.mark.parametrize("given", ["", "start", "end", "start end"])
def test_a_spline_of_fit_points_keeps_each_tangent_that_is_given(drawing, given):
    """One tangent alone was dropped; both or none are as ezdxf has them, which follows BricsCAD."""
    along = {"start": (0.0, 3.0, 0.0), "end": (0.2, -1.0, 0.0)}
    tools = []

    def draw(space, _):
        spline = space.add_spline([(*p, 0) for p in S_POINTS])
        for name in given.split():
            spline.dxf.set(f"{name}_tangent", along[name])
        tools.append(spline.construction_tool())

    (curve,) = drawing(draw)
    for name, station in (("start", 0.0), ("end", curve.length)):
        there = curve.at(np.array([station]))
        if name in given:
            angle = np.arctan2(along[name][1], along[name][0])
            assert there.angle[0] == pytest.approx(angle, abs=1e-9)
        else:
            assert there.curvature[0] == pytest.approx(0, abs=1e-9)
    chords = np.append(0, np.cumsum(np.hypot(*np.diff(S_POINTS, axis=0).T)))
    ends = [(1, np.divide(v, np.hypot(*v[:2]))[:2]) if k in given else (2, (0, 0)) for k, v in along.items()]
    oracle = CubicSpline(chords, S_POINTS, bc_type=ends)(np.linspace(0, chords[-1], 50))
    for points in [oracle, *([tools[0].points(np.linspace(0, 1, 50))] if given in ("", "start end") else [])]:
        assert spaced_like(curve, points)


def spaced_like(curve, points):
    """Does the curve pass all these points (n, 2 or more), mm?"""
    dense = spaced(curve, 40001)
    return all(np.hypot(*(dense - tuple(p)[:2]).T).min() < curve.length / 40000 for p in points)


@pytest.mark.parametrize(("points", "words"), [
    ([(5, 5), (5, 5)], "fewer than two different fit points: draw the SPLINE again"),
    ([(5, 5), (9, 5), (5, 5)], "fewer than three different fit points: draw the SPLINE again"),
])  # fmt: skip
def test_fit_points_that_do_not_differ_are_reported(drawing, points, words):
    def draw(space, _):
        space.add_spline([(*p, 0) for p in points]).closed = len(points) > 2

    with pytest.raises(InputError, match=words):
        drawing(draw)


def test_a_fit_point_drawn_twice_counts_once(drawing):
    """ezdxf divides by the distance of two."""
    once, twice = (
        drawing(lambda space, _, k=k: space.add_spline(np.repeat(S_POINTS, k, axis=0)))[0] for k in (1, 2)
    )
    assert np.array_equal(once.control_points, twice.control_points)


@pytest.mark.parametrize(("knots", "weights", "words"), [
    (np.linspace(0, 1, 8), (), r"has 8 knots, but needs 9 in increasing order: draw the spline again"),
    (np.zeros(9), (), r"has no length: draw the spline again"),
    (np.linspace(0, 1, 9), (1, 1), r"needs 5 positive finite weights, or none: draw the spline again"),
])  # fmt: skip
def test_numbers_of_a_spline_that_do_not_fit_are_listed_with_what_to_do(drawing, knots, weights, words):
    def draw(space, _):
        spline = space.add_spline()
        spline.dxf.degree = 3
        spline.control_points = [(*p, 0) for p in S_POINTS]
        spline.knots, spline.weights = knots, weights

    with pytest.raises(InputError, match=words):
        drawing(draw)
