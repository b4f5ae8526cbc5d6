"""Drawings that nearly say what is meant: gaps, shapes drawn twice, points that waver."""

import numpy as np
import pytest

from elastica_cad import optimal_rod, read_curves
from elastica_cad.form_finding import smooth_curve


@pytest.fixture
def drawing(tmp_path):
    """Read a DXF file that a function draws in model space."""
    ezdxf = pytest.importorskip("ezdxf")

    def read(draw, unit=4):
        document = ezdxf.new("R2010")
        document.header["$INSUNITS"] = unit
        draw(document.modelspace())
        document.saveas(tmp_path / "a.dxf")
        return read_curves(tmp_path / "a.dxf")

    return read


def _arcs(gap, radius=2.513, layers="00"):
    """Two arcs about one centre whose middle ends are `gap` apart."""
    turn = np.degrees(gap / radius)

    def draw(space):
        for layer, start, end in zip(layers, (10.123, 60.123 + turn), (60.123, 130.456), strict=True):
            space.add_arc((0.117, 0.354), radius, start, end, dxfattribs={"layer": layer})

    return draw


@pytest.mark.parametrize(
    ("unit", "radius", "gap"), [(1, 2.513, 0.001), (1, 5.117, 0.0013), (5, 9.873, 0.0014)]
)
def test_gaps_of_one_unit_of_the_last_digit_are_closed(drawing, unit, radius, gap):
    curves = drawing(_arcs(gap, radius), unit)
    assert len(curves) == 1
    assert not curves[0].has_corners
    assert (
        "gaps as small as the last digit of the numbers in the file were closed: 1, the widest"
        in curves.notes[0]
    )


@pytest.mark.parametrize("millimetres", [0.2, 1.7, 2.9])
def test_wider_gaps_are_named_with_their_distance(drawing, millimetres):
    curves = drawing(_arcs(millimetres, 73.125))
    assert len(curves) == 2
    assert f"end {millimetres:.2g} mm apart" in curves.notes[0]
    assert len(drawing(_arcs(millimetres, 73.125, layers="AB")).notes) == 0


@pytest.mark.parametrize("part", [(20, 50), (0, 55), (31, 70), (14, 184), (0, 188.5)])
def test_of_shapes_that_lie_on_each_other_the_longer_one_counts(drawing, part):
    whole = 70 if part[1] <= 70 else 188.505
    curves = drawing(lambda space: (space.add_arc((0, 0), 90, *part), space.add_arc((0, 0), 90, 0, whole)))
    assert [curve.length for curve in curves] == pytest.approx([90 * np.radians(whole)])
    assert curves.notes == (
        "drawn twice, so the longer shape is used: ARC 2F (layer 0) lies on ARC 30 (layer 0)",
    )


def test_a_curve_drawn_twice_is_reported_in_whatever_form(drawing):
    half = [(-40, 0, -1), (40, 0, 0)]
    spline = drawing(
        lambda space: (space.add_lwpolyline(half, format="xyb"), space.add_arc((0, 0), 40, 0, 180))
    )
    assert len(spline) == 1
    assert spline.notes[0].startswith("drawn twice, so the longer shape is used")
    two = drawing(
        lambda space: [
            space.add_arc((0, 0), 40, 0, 90, dxfattribs={"layer": layer}) for layer in ("CUT", "BEND")
        ]
    )
    assert len(two) == 2
    assert two.notes[0].startswith("drawn twice with different layers or names, so both are used")


@pytest.mark.parametrize("ends", [((0, 60), (47, 130)), ((47, 130), (0, 60)), ((0, 129.9), (0.1, 130))])
def test_shapes_that_overlap_in_part_become_their_union(drawing, ends):
    curves = drawing(lambda space: [space.add_arc((5, 7), 90, *angles) for angles in ends])
    assert [curve.length for curve in curves] == pytest.approx([90 * np.radians(130)], rel=1e-7)
    assert np.hypot(*(curves[0].sample(401).position - (5, 7)).T) == pytest.approx(90, abs=1e-5)
    assert not curves[0].has_corners
    (text,) = curves.notes
    assert text.startswith("partly drawn twice, so the two shapes are joined into one curve: ARC ")


def test_overlapping_lines_polylines_and_arcs_of_a_ring_become_one_curve(drawing):
    line = drawing(lambda space: [space.add_line((x, x), (x + 60, x + 60)) for x in (0, 40, 93)])
    assert [curve.length for curve in line] == pytest.approx([153 * np.sqrt(2)])
    ring = drawing(lambda space: [space.add_arc((0, 0), 50, *at) for at in ((10, 220), (180, 50))])
    assert [curve.length for curve in ring] == pytest.approx([100 * np.pi])
    assert ring[0].is_closed
    chain = [(0, 0), (50, 0, -0.3), (90, 10, 0), (140, 10)]
    union = drawing(
        lambda space: (space.add_lwpolyline(chain, format="xyb"), space.add_line((100, 10), (220, 10)))
    )
    alone = drawing(lambda space: space.add_lwpolyline(chain, format="xyb"))
    assert [curve.length for curve in union] == pytest.approx([alone[0].length + 80])


def test_parts_of_one_spline_that_overlap_become_the_spline(drawing):
    whole = np.array([(0, 0), (40, 80), (140, 80), (180, 0)], float)

    def part(low, high):
        return [sum(w * p for w, p in zip(np.convolve(np.convolve(*pair[:2]), pair[2]), whole, strict=True))
                for pair in ([(1 - t, t) for t in ends] for ends in (
                    (low, low, low), (low, low, high), (low, high, high), (high, high, high)))]  # fmt: skip

    curves = drawing(lambda space: [space.add_open_spline(part(*at)) for at in ((0, 0.6), (0.45, 1))])
    assert [curve.length for curve in curves] == pytest.approx([228.1001], abs=1e-3)


@pytest.mark.parametrize("layers", ["AB", "00"])
def test_overlapping_shapes_of_two_layers_or_with_a_third_at_their_ends_are_reported_and_kept(
    drawing, layers
):
    def draw(space):
        for layer, angles in zip(layers, ((0, 60), (47, 130)), strict=True):
            space.add_arc((0, 0), 90, *angles, dxfattribs={"layer": layer})
        if layers == "00":
            angle = np.radians(60)
            end = 90 * np.array([np.cos(angle), np.sin(angle)])
            space.add_line(end, 2 * end)

    curves = drawing(draw)
    assert len(curves) == 2
    assert sum("partly drawn twice, and both shapes are used" in text for text in curves.notes) == 1


def test_shapes_that_touch_or_cross_do_not_overlap(drawing):
    curves = drawing(
        lambda space: [
            space.add_line(start, end)
            for start, end in [
                ((0, 0), (60, 0)),
                ((30, 0), (30, 40)),
                ((60, 0), (60, 40)),
                ((0, 30), (70, 30)),
            ]
        ]
    )
    assert curves.notes == ()


@pytest.mark.parametrize(("count", "radius", "decimals"), [(150, 100, 5), (120, 60, 4)])
def test_a_spline_through_very_many_points_is_smoothed_as_its_note_says(drawing, count, radius, decimals):
    angles = np.linspace(0, 2.5, count)
    points = np.round(radius * np.column_stack([np.cos(angles), np.sin(angles)]), decimals)
    (curve,) = drawing(lambda space: space.add_spline(fit_points=points.tolist()))
    assert optimal_rod(curve).ratio > 30
    smoothing = smooth_curve(curve)
    (message,) = smoothing.notes
    assert "so the curve was smoothed" in message
    assert optimal_rod(smoothing.curve).ratio < 1.1


def test_a_smooth_dense_spline_has_no_noise(drawing):
    angles = np.linspace(0, 2.5, 80)
    points = 100 * np.column_stack([np.cos(angles), np.sin(angles)])
    along = [(-points[0, 1], points[0, 0]), (-points[-1, 1], points[-1, 0])]

    def draw(space):
        spline = space.add_spline(fit_points=points.tolist())
        spline.dxf.start_tangent, spline.dxf.end_tangent = along

    (curve,) = drawing(draw)
    assert curve.provenance.measured is None


def test_points_read_with_a_ruler_have_its_noise(tmp_path):
    x = np.linspace(0, 176, 9)
    rows = [f"{a:.0f},{b:.0f}" for a, b in zip(x, 57 * np.sin(np.pi * x / 176), strict=True)]
    (tmp_path / "ruler.csv").write_text("\n".join(rows))
    (curve,) = read_curves(tmp_path / "ruler.csv")
    (message,) = smooth_curve(curve).notes
    reach = curve.provenance.measured.reach
    assert f"set smooth to about {reach:g} mm" in message
    assert optimal_rod(smooth_curve(curve, reach).curve).ratio < 0.7 * optimal_rod(curve).ratio
