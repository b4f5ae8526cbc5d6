"""The record of what was read of a drawing."""

import numpy as np
import pytest

from elastica_cad import InputError, read_curves
from elastica_cad.files import read_drawing
from elastica_cad.formats.drawn_file import ReadReport, ReadUnit

SPLINE = [(0, 0), (40, 80), (140, 80), (180, 0)]


@pytest.fixture
def dxf(tmp_path):
    """Write a DXF file that a function draws in model space, and return its path."""
    ezdxf = pytest.importorskip("ezdxf")

    def write(draw, unit=4):
        document = ezdxf.new("R2010")
        document.header["$INSUNITS"] = unit
        draw(document.modelspace())
        document.saveas(tmp_path / "a.dxf")
        return tmp_path / "a.dxf"

    return write


@pytest.mark.parametrize(("unit", "line"), [
    (4, "180.0 x 60.0 mm (unit from the file), 1 spline, read without approximation"),
    (1, "4572.0 x 1524.0 mm (unit: in, from the file), 1 spline, read without approximation"),
    (0, "180.0 x 60.0 mm (unit assumed), 1 spline, read without approximation"),
])  # fmt: skip
def test_a_spline_is_read_exactly_in_the_unit_of_its_file(dxf, unit, line):
    drawing = read_drawing(dxf(lambda space: space.add_open_spline(SPLINE), unit))
    assert str(drawing.report()) == line


def test_the_size_of_a_curve_with_corners_reaches_to_its_corners(dxf):
    corners = [(0, 0), (97.3, 131.7), (203.1, -17.9)]
    drawing = read_drawing(dxf(lambda space: [space.add_line(*corners[k : k + 2]) for k in (0, 1)]))
    assert drawing.report().size == pytest.approx((203.1, 149.6))


def test_a_unit_that_an_option_gives_is_stated(dxf):
    report = read_drawing(dxf(lambda space: space.add_open_spline(SPLINE)), unit="cm").report()
    assert (report.unit.name, report.unit.known) == ("cm", "stated")
    assert report.size == pytest.approx((1800, 600))


def test_joined_and_turned_curves_are_reported(dxf):
    upright = [(x, 0, y) for x, y in SPLINE]

    def draw(space):
        space.add_open_spline(upright)
        space.add_line((180, 0, 0), (220, 0, -80))

    report = read_drawing(dxf(draw)).report()
    assert report.done == ("joined", "turned")
    assert report.kinds == {"spline": 1, "line": 1}
    assert report.distance < 1e-3


def test_pieces_of_one_entity_are_not_reported_as_joined(dxf):
    """A polyline of a line, a half circle and a line is a single entity of the drawing."""
    points = [(0, 0, 0), (60, 0, 1), (60, 40, 0), (0, 40, 0)]
    report = read_drawing(dxf(lambda space: space.add_lwpolyline(points, format="xyb"))).report()
    assert "joined" not in report.done


@pytest.mark.parametrize(
    "shape", ['circle cx="0" cy="0" r="10.3"', 'ellipse cx="150" cy="120" rx="120" ry="90"']
)
def test_a_closed_shape_of_an_svg_file_is_one_arc(shape, tmp_path):
    path = tmp_path / "ring.svg"
    path.write_text(f'<svg xmlns="http://www.w3.org/2000/svg"><{shape}/></svg>', encoding="utf-8")
    assert read_drawing(path).report().kinds == {"arc": 1}


def test_the_distance_of_a_fitted_polyline_is_that_of_its_facets(dxf):
    angles = np.linspace(0, np.pi, 37)
    facets = 120 * np.column_stack([np.cos(angles), np.sin(angles)])
    report = read_drawing(dxf(lambda space: space.add_lwpolyline(facets))).report()
    assert report.done == ("fitted",)
    assert report.distance == pytest.approx(120 * (1 - np.cos(np.pi / 72)), rel=0.5)


def test_a_report_is_of_the_chosen_curves(dxf):
    drawing = read_drawing(dxf(lambda space: (space.add_open_spline(SPLINE), space.add_circle((900, 0), 50))))
    assert drawing.report(drawing.chosen("1")).size == pytest.approx((180, 60))


def test_points_are_counted_and_their_unit_is_assumed(tmp_path):
    file = tmp_path / "a.csv"
    file.write_text("\n".join(f"{x:.2f},{50 * np.sin(x / 60):.2f}" for x in range(0, 181, 9)))
    assert str(read_drawing(file).report()).startswith("180.0 x 50.0 mm (unit assumed), 21 points, fitted, ")


def test_a_fit_that_leaves_the_points_by_far_is_refused(tmp_path):
    noise = np.random.default_rng(7).uniform(-3, 3, 61)
    rows = [
        f"{x:.2f},{40 * np.sin(x / 60) + off:.2f}" for x, off in zip(range(0, 181, 3), noise, strict=True)
    ]
    file = tmp_path / "a.csv"
    file.write_text("\n".join(rows))
    with pytest.raises(InputError, match=r"deviates from the drawing by \S+ mm, more than 0\.9 mm"):
        read_curves(file, fit_tolerance=4)
    assert len(read_curves(file)) == 1


def test_corners_rounded_at_joints_are_not_called_smoothing():
    line = str(ReadReport((100.0, 50.0), ReadUnit(), {"spline": 2}, ("smoothed",), 0.03))
    assert "small corners at joints rounded, within 0.03 mm of the drawing" in line
