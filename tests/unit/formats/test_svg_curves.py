import gzip
import sys
from itertools import pairwise

import numpy as np
import pytest

from elastica_cad import InputError, MissingDependencyError, read_curves
from elastica_cad.files import read_drawing
from elastica_cad.geometry.plane_curve import split_at_corners

PX = 25.4 / 96


@pytest.fixture
def svg(tmp_path):
    """A function that writes a drawing and reads its curves back."""

    def read(body, head='width="200mm" height="100mm" viewBox="0 0 200 100"', **options):
        path = tmp_path / "drawn.svg"
        path.write_text(f'<svg xmlns="http://www.w3.org/2000/svg" {head}>{body}</svg>', encoding="utf-8")
        return read_curves(path, **options)

    return read


def path(d, **attributes):
    return f'<path d="{d}" {" ".join(f"{k}={v!r}" for k, v in attributes.items())}/>'


def test_cubic_is_exact_and_up_is_up(svg):
    (curve,) = svg(path("M 10 20 C 30 80 60 -10 90 40"))
    assert curve.degree == 3
    assert curve.control_points == pytest.approx(np.array([(10, -20), (30, -80), (60, 10), (90, -40)]))


def test_all_commands_absolute_and_relative_make_the_same_curve(svg):
    absolute = "M 10,10 L 20 10 H 40 V 30 C 40 50 60 50 60 30 S 80 10 80 30 Q 80 50 95 50 T 110 30 "
    absolute += "A 15 10 20 0 1 130 35"
    relative = "m10,10l10,0h20v20c0 20 20 20 20 0s20-20 20 0q0 20 15 20t15-20a15 10 20 01 20 5"
    (one,), (other,) = svg(path(absolute)), svg(path(relative))
    assert one.degree == 3
    assert other.length == pytest.approx(one.length, rel=1e-12)
    assert other.sample(50).position == pytest.approx(one.sample(50).position, abs=1e-9)
    at = np.array([b.t for b in one.breaks])
    joints = one.evaluate(at)
    for joint in [(20, -10), (40, -10), (40, -30), (60, -30), (80, -30), (95, -50), (110, -30)]:
        assert np.hypot(*(joints - joint).T).min() < 1e-12
    assert one.evaluate(one.domain[1]) == pytest.approx((130, -35))


def svg_arc(start, end, radii, rotation, flags, *, count=200):
    """Points on an arc by the formulae of the SVG standard, appendix B.2.4."""
    large, sweep = flags
    c, s = np.cos(rotation), np.sin(rotation)
    half = np.array([[c, s], [-s, c]]) @ ((np.array(start) - end) / 2)
    rx, ry = np.abs(radii) * max(1.0, np.hypot(half[0] / radii[0], half[1] / radii[1]))
    rest = max(0.0, 1 / ((half[0] / rx) ** 2 + (half[1] / ry) ** 2) - 1)
    centre = (1 if large != sweep else -1) * np.sqrt(rest) * np.array([rx * half[1] / ry, -ry * half[0] / rx])
    first = np.arctan2((half[1] - centre[1]) / ry, (half[0] - centre[0]) / rx)
    last = np.arctan2((-half[1] - centre[1]) / ry, (-half[0] - centre[0]) / rx)
    turn = (last - first) % (2 * np.pi) if sweep else -((first - last) % (2 * np.pi))
    t = first + np.linspace(0, turn, count)
    local = centre + np.column_stack([rx * np.cos(t), ry * np.sin(t)])
    return local @ np.array([[c, s], [-s, c]]) + (np.array(start) + end) / 2


@pytest.mark.parametrize("flags", [(0, 0), (0, 1), (1, 0), (1, 1)])
@pytest.mark.parametrize(("radii", "turned"), [((30, 30), 0), ((40, 25), 35), ((3, 2), 70), ((20, 60), -120)])
def test_arcs_follow_the_standard(svg, flags, radii, turned):
    (curve,) = svg(path(f"M 20 30 A {radii[0]} {radii[1]} {turned} {flags[0]} {flags[1]} 60 45"))
    expected = svg_arc((20, 30), (60, 45), radii, np.radians(turned), flags) * (1, -1)
    steps = np.hypot(*np.diff(expected, axis=0).T)
    assert curve.length == pytest.approx(steps.sum(), rel=1e-4)
    assert curve.evaluate(np.array(curve.domain)) == pytest.approx(expected[[0, -1]], abs=1e-10)
    dense = curve.sample(20001).position
    gaps = [np.hypot(*(dense - p).T).min() for p in expected]
    assert max(gaps) < curve.length / 20000


@pytest.mark.parametrize("shift", [0, 1e4])
def test_half_turn_is_exact(svg, shift):
    (curve,) = svg(path(f"M {shift} 0 A 30 30 0 0 1 {shift + 60} 0"))
    assert np.abs(np.hypot(*(curve.sample(99).position - (shift + 30, 0)).T) - 30).max() < 1e-9
    assert curve.at(np.array([15 * np.pi])).position[0] == pytest.approx((shift + 30, 30))


def test_transforms_apply_to_arcs_exactly(svg):
    inner = f'<g transform="scale(2 0.5)">{path("M 20 0 A 20 20 0 0 1 0 20")}</g>'
    body = f'<g transform="translate(10,5) skewX(30)">{inner}</g>'
    (curve,) = svg(body)
    x, y = (curve.sample(99).position * (1, -1) - (10, 5)).T
    x = (x - np.tan(np.radians(30)) * y) / 2
    assert np.abs(np.hypot(x, 2 * y) - 20).max() < 1e-9


@pytest.mark.parametrize(("head", "mm"), [
    ('width="200mm" height="100mm" viewBox="0 0 200 100"', 1.0),
    ('width="10in" height="5in" viewBox="0 0 100 50"', 2.54),
    ('width="96px" height="96px" viewBox="0 0 96 96"', PX),
    ('width="20cm" viewBox="-50,-50,400,100"', 0.5),
    ('width="100%" height="100%" viewBox="0 0 200 100"', PX),
    ('viewBox="0 0 200 100"', PX),
    ("", PX),
    ('width="400mm" height="100mm" viewBox="0 0 200 100"', 1.0),
    ('width="400mm" height="100mm" viewBox="0 0 200 100" preserveAspectRatio="xMidYMid slice"', 2.0),
    ('width="300MM" height="150Mm" viewBox="0 0 200 100"', 1.5),
    ('width="12IN" viewBox="0 0 120 100"', 2.54),
    ('width="300,5mm" height="150,25mm" viewBox="0 0 200 100"', 1.5025),
    ('width="25em" height="12.5EM" viewBox="0 0 200 100"', 2 * PX),
    ('width="50rem" viewBox="0 0 200 100"', 4 * PX),
    ('style="Width:26cm; height:13cm" viewBox="0 0 200 100"', 1.3),
    ('width="7mm" style="fill:none;width: 5in !important" viewBox="0 0 100 50"', 1.27),
    ('width="60vw" viewBox="0 0 200 100"', PX),
])  # fmt: skip
def test_size_of_the_drawing_gives_the_unit(svg, head, mm):
    (curve,) = svg(path("M 30 20 Q 60 80 90 20"), head)
    assert curve.control_points == pytest.approx(mm * np.array([(30, -20), (60, -80), (90, -20)]))


def test_unlike_scales_and_given_unit(svg):
    head = 'width="400mm" height="100mm" viewBox="0 0 200 100" preserveAspectRatio="none"'
    (curve,) = svg(path("M 30 20 Q 60 80 90 20"), head)
    assert curve.control_points == pytest.approx(np.array([(60, -20), (120, -80), (180, -20)]))
    (curve,) = svg(path("M 30 20 Q 60 80 90 20"), head, unit="in")
    assert curve.control_points == pytest.approx(25.4 * np.array([(30, -20), (60, -80), (90, -20)]))


def test_shapes_and_lengths_with_units(svg):
    circle, ellipse, line, rounded = svg(
        '<circle cx="40" cy="40" r="10"/><ellipse cx="100" cy="40" rx="20" ry="10"/>'
        '<line x1="0" y1="0" x2="3mm" y2="4mm"/><rect x="150" y="10" width="30" height="20" rx="5"/>',
        "",
    )
    assert circle.is_closed
    assert circle.length == pytest.approx(20 * np.pi * PX)
    assert circle.at(0).position[0] == pytest.approx(PX * np.array([50, -40])), (
        "SVG begins circles at three o'clock"
    )
    assert np.abs(np.hypot(*((ellipse.sample(99).position / PX - (100, -40)) / (20, 10)).T) - 1).max() < 1e-9
    assert line.length == pytest.approx(5.0, rel=1e-12)
    assert line.is_straight
    assert rounded.length == pytest.approx((2 * 20 + 2 * 10 + 10 * np.pi) * PX)
    assert not rounded.tangent_breaks


def test_polyline_is_fitted(svg):
    v = np.linspace(0, 1.5, 50)
    points = " ".join(f"{100 * np.cos(a):.4f},{100 * np.sin(a):.4f}" for a in v)
    for body in (f'<polyline points="{points}"/>', path("M " + points)):
        (curve,) = svg(body)
        assert curve.degree == 4
        assert np.abs(np.hypot(*curve.sample(200).position.T) - 100).max() < 0.06


def test_paths_that_meet_are_one_curve(svg):
    curves = svg(path("M 0 0 C 10 0 20 10 20 20") + path("M 50 60 C 40 60 20 40 20 20.004 m 50 0 l 5 5"))
    assert [c.degree for c in curves] == [3, 2]
    assert curves[0].evaluate(np.array(curves[0].domain)) == pytest.approx(np.array([(0, 0), (50, -59.996)]))


def test_what_is_not_shown_is_left_out(svg):
    body = (
        "<defs>" + path("M 0 0 L 5 5", id="d") + "</defs>" + path("M 0 0 L 7 7", display="none")
        + '<use href="#d" x="10"/><text>word</text>'
    )  # fmt: skip
    (curve,) = svg(body)
    assert curve.evaluate(np.array(curve.domain)) == pytest.approx(np.array([(10, 0), (15, -5)]))


def test_handles_drawn_in_make_straight_lines(svg):
    (curve,) = svg(path("M 0 0 Q 20 0 20 0 C 20 0 35 0 40 0") + path("M 0 50 C 0 50 90 50 90 50"))[:1]
    assert curve.is_straight
    assert curve.length == pytest.approx(40.0)


def test_cusp_is_listed_with_its_place(svg):
    with pytest.raises(
        InputError, match=r"drawn\.svg: .*has a cusp, and the curve has no tangent at \(30, 45\) mm"
    ):
        svg(path("M 0 0 C 60 60 0 60 60 0"))


def test_degenerate_segments_are_passed_over(svg):
    (curve,) = svg(path("M 0 0 L 0 0 C 0 0 0 0 0 0 A 0 5 0 0 1 10 0 C 10 0 20 0 20 0 Z M 3 3 Z", fill="none"))
    assert curve.length == pytest.approx(40.0)
    assert curve.is_closed


@pytest.mark.parametrize(("data", "words"), [
    (b"hello", "is not an SVG file"),
    (b"<html><body/></html>", "begins with <html>"),
    (b"<svg><path d='M 0 0 L 1 1'/>", "is not an SVG file"),
    (b"<svg xmlns='http://www.w3.org/2000/svg'><text>a</text></svg>", "has no curve"),
    (b"<svg><path d='M 0 0 L 10 10 L 3'/></svg>", "path data"),
    (b"\x00\x01\x02", "is not an SVG file"),
])  # fmt: skip
def test_other_files_get_one_sentence(tmp_path, data, words):
    file = tmp_path / "bad.svg"
    file.write_bytes(data)
    with pytest.raises(InputError, match=rf"bad\.svg: .*{words}") as caught:
        read_curves(file)
    assert "\n" not in str(caught.value)


def test_missing_library_is_said_in_one_sentence(svg, tmp_path, monkeypatch):
    svg(path("M 0 0 L 1 1"))
    monkeypatch.setitem(sys.modules, "cssselect2", None)
    for module in ("svg_curves", "svg_shapes", "svg_tree"):
        monkeypatch.delitem(sys.modules, f"elastica_cad.formats.{module}")
    with pytest.raises(MissingDependencyError, match=r"reading drawn\.svg needs cssselect2"):
        read_curves(tmp_path / "drawn.svg")


def test_a_drawing_in_metres_is_as_large_as_it_says(svg):
    (curve,) = svg(
        path("M 0.01 0.02 C 0.03 0.08 0.06 0.01 0.09 0.04"),
        'width="200mm" height="100mm" viewBox="0 0 0.2 0.1"',
    )
    wanted = np.array([(10, -20), (30, -80), (60, -10), (90, -40)])
    assert curve.control_points == pytest.approx(wanted)


def test_a_shallow_curve_is_no_straight_line(svg):
    """300 mm with a rise of 0.15 mm is a curve that somebody drew."""
    (curve,) = svg(
        path("M 0 50 C 100 50.2 200 50.2 300 50"), 'width="300mm" height="100mm" viewBox="0 0 300 100"'
    )
    assert not curve.is_straight
    assert np.ptp(curve.sample(101).position[:, 1]) == pytest.approx(0.15, abs=1e-6)


@pytest.mark.parametrize(
    ("d", "joints"),
    [
        ("M 0 0 L 40 0 L 40 30 L 90 60", [("", "J1"), ("J1", "J2"), ("J2", "")]),
        ("M 0 0 L 40 0 L 40 30 Z", [("J3", "J1"), ("J1", "J2"), ("J2", "J3")]),
    ],
)
def test_pieces_between_corners_are_counted_and_say_where_they_meet(svg, tmp_path, d, joints):
    svg(path(d))
    (whole,) = read_drawing(tmp_path / "drawn.svg").curves
    pieces = whole.split(split_at_corners)
    assert [(one.piece, one.pieces) for one in pieces] == [(1, 3), (2, 3), (3, 3)]
    assert [one.joints for one in pieces] == joints
    assert sum(one.curve.length for one in pieces) == pytest.approx(whole.curve.length)
    for before, after in pairwise(pieces):
        assert before.curve.sample(2).position[-1] == pytest.approx(after.curve.sample(2).position[0])


ILLUSTRATOR = """<?xml version="1.0" encoding="utf-8"?>
<!-- Generator: Adobe Illustrator 27.0.0, SVG Export Plug-In . SVG Version: 6.00 Build 0)  -->
<svg version="1.1" id="Layer_1" xmlns="http://www.w3.org/2000/svg" x="0px" y="0px" {size}
   viewBox="0 0 595.28 841.89" xml:space="preserve">
<path id="rib" d="M85.04,425.2c0-226.77,340.16-283.47,396.85-0.01"/>
</svg>"""


@pytest.mark.parametrize("size", ["", 'width="595.28px" height="841.89px"'])
def test_illustrator_counts_in_points(tmp_path, size):
    """An A4 page of 595.28 by 841.89 points: its curves came out a quarter too small, without a word."""
    file = tmp_path / "rib.svg"
    file.write_text(ILLUSTRATOR.format(size=size))
    found = read_curves(file)
    assert found[0].control_points[0] == pytest.approx(
        (30, -150), abs=0.01
    )  # mm, as the ruler of Illustrator says
    assert found.notes == (found.file.unit.note,)
    assert "set unit to px" in found.file.unit.note
    pixels = read_curves(file, unit="px")
    assert pixels[0].length == pytest.approx(0.75 * found[0].length)
    assert pixels.notes == ()


def test_illustrator_is_believed_where_it_says_mm(tmp_path):
    file = tmp_path / "rib.svg"
    file.write_text(ILLUSTRATOR.format(size='width="210mm" height="297mm"'))
    found = read_curves(file)
    assert found[0].control_points[0] == pytest.approx((30, -150), abs=0.01)
    assert found.notes == ()


@pytest.mark.parametrize(
    ("version", "size", "unit"),
    [
        ("0.48.4 r9939", 'width="744.09448" height="1052.3622"', 25.4 / 90),
        ("0.48.4 r9939", 'width="210mm" height="297mm"', 25.4 / 90),
        ("0.91 r13725", 'width="744.09448" height="1052.3622" viewBox="0 0 744.09448 1052.3622"', 25.4 / 90),
        ("0.91 r13725", 'width="210mm" height="297mm" viewBox="0 0 210 297"', 1.0),
        ("0.92.3 (2405546, 2018-03-11)", 'width="793.70081" height="1122.5197"', 25.4 / 96),
        (
            "1.2.2 (b0a8486541, 2022-12-01)",
            'width="793.7" height="1122.5" viewBox="0 0 793.7 1122.5"',
            25.4 / 96,
        ),
    ],
)
def test_old_inkscape_has_ninety_pixels_to_the_inch(tmp_path, version, size, unit):
    """An A4 page of 744.09 by 1052.36 pixels: its curves came out a sixteenth too small, without a word."""
    file = tmp_path / "arch.svg"
    names = 'xmlns="http://www.w3.org/2000/svg" xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape"'
    file.write_text(
        f'<svg {names} {size} inkscape:version="{version}"><path d="M 100,400 A 60,60 0 0 1 220,400"/></svg>'
    )
    found = read_curves(file)
    assert found[0].length == pytest.approx(60 * np.pi * unit)
    old = unit == 25.4 / 90
    assert [("90 to the inch" in note and "set unit to px" in note) for note in found.notes] == [True] * old
    assert read_curves(file, unit="px")[0].length == pytest.approx(60 * np.pi * 25.4 / 96)


@pytest.mark.parametrize(
    ("symbol", "clone", "corners"),
    [
        # where (0, 0) and (240, 160) of the symbol lie, mm; the first four as Inkscape 1.2 shows them
        ('viewBox="0 0 240 180" width="120" height="90"', 'transform="translate(5,5)"', [(5, 5), (125, 85)]),
        ('viewBox="0 0 240 180"', 'x="10" y="20" width="120" height="90"', [(10, 20), (130, 100)]),
        ('viewBox="0 0 240 180" preserveAspectRatio="none"', 'x="10" y="20" width="120" height="180"',
         [(10, 20), (130, 180)]),
        ('viewBox="0 0 240 180"', 'x="10" y="20"', [(10, 89.75), (220, 229.75)]),
        ('viewBox="20 10 240 180" preserveAspectRatio="xMinYMax slice"', 'width="120" height="180"',
         [(-20, -10), (220, 150)]),
        ('viewBox="0 0 240 180"', 'width="50%" height="25%"', [(3, 0), (102, 66)]),
        ("", 'x="10" y="20" width="50" height="50"', [(10, 20), (250, 180)]),
    ],
)  # fmt: skip
def test_a_symbol_is_shown_in_the_box_of_its_clone(tmp_path, symbol, clone, corners):
    page = 'width="210mm" height="297mm" viewBox="0 0 210 297"'
    file = tmp_path / "symbol.svg"
    file.write_text(
        f'<svg xmlns="http://www.w3.org/2000/svg" {page}><defs><symbol id="s" {symbol}>'
        f'<path d="M 0 0 C 60 100 180 160 240 160"/></symbol></defs><use href="#s" {clone}/></svg>'
    )
    (curve,) = read_curves(file)
    ends = curve.sample(2).position * (1, -1)
    np.testing.assert_allclose(ends, corners, atol=1e-6)


def test_the_pixels_of_affinity_are_reported(tmp_path):
    """It writes no size; its pixels are those of the document, at 300 DPI a third of what is taken."""
    file = tmp_path / "affinity.svg"
    head = 'width="100%" height="100%" viewBox="0 0 2480 3508" xmlns:serif="http://www.serif.com/"'
    body = '<path d="M336.22,1889.76C336.22,472.441 2698.43,472.441 2698.43,1889.76"/>'
    file.write_text(f'<svg {head} xmlns="http://www.w3.org/2000/svg">{body}</svg>')
    assert "the DPI of its document" in read_drawing(file).unit.note
    file.write_text(
        f'<svg {head.replace("100%", "210mm", 1)} xmlns="http://www.w3.org/2000/svg">{body}</svg>'
    )
    assert "the DPI of its document" not in read_drawing(file).unit.note


@pytest.mark.parametrize(
    ("view", "corners"),
    [
        # where (0, 0) and (100, 50) of the inner drawing lie; all but the last two as Inkscape 1.2 shows them
        ('x="10%" y="10%" width="50%" height="50%" viewBox="0 0 100 100"', [(45, 10), (95, 35)]),
        ('x="10%" y="10%" width="50%" height="50%" viewBox="0 0 100 100" preserveAspectRatio="none"',
         [(20, 10), (120, 35)]),
        ('x="5" y="6" width="50%" height="50%"', [(5, 6), (105, 56)]),
        ('x="5%" y="6%"', [(10, 6), (110, 56)]),
        ('viewBox="0 0 100 100"', [(50, 0), (150, 50)]),
        ('transform="translate(1 2)" x="10" y="10" width="50" height="50" viewBox="10 20 100 100"',
         [(6, 2), (56, 27)]),
        ('width="50%" height="50%" viewBox="0 0 100 100" preserveAspectRatio="xMaxYMin slice"',
         [(0, 0), (100, 50)]),
    ],
)  # fmt: skip
def test_percentages_of_nested_drawings_are_of_the_drawing_around(svg, view, corners):
    """They had been taken of each other's side, and a place without a viewBox not at all."""
    body = path("M 0 0 C 30 50 70 0 100 50")
    (curve,) = svg(f"<svg {view}>{body}</svg>")
    np.testing.assert_allclose(curve.sample(2).position * (1, -1), corners, atol=1e-9)


@pytest.mark.parametrize(
    ("shape", "box"),
    [  # left, top, width and height as Inkscape 1.2 shows them, mm
        ('<line x1="10%" y1="10%" x2="90%" y2="80%"/>', (20, 10, 160, 70)),
        ('<circle cx="50%" cy="50%" r="10%"/>', (84.1886, 34.1886, 31.6228, 31.6228)),
        ('<rect x="10%" y="10%" width="50%" height="50%" rx="5"/>', (20, 10, 100, 50)),
        ('<svg x="10" y="10" width="100" height="50" viewBox="0 0 50 50"><line x1="10%" y1="10%" x2="90%" '
         'y2="80%"/></svg>', (40, 15, 40, 35)),
        ('<defs><path id="p" d="M 0 0 C 10 50 20 0 30 50"/></defs><use href="#p" x="10%" y="5%"/>',
         (20, 5, 30, 50)),
        ('<svg x="30" y="40"><ellipse rx="10" ry="20"/></svg>', (20, 20, 20, 40)),
    ],
)  # fmt: skip
def test_percentages_of_shapes_are_of_width_and_height(svg, shape, box):
    (curve,) = svg(shape)
    points = curve.sample(2001).position * (1, -1)
    np.testing.assert_allclose([*points.min(axis=0), *np.ptp(points, axis=0)], box, atol=2e-3)


@pytest.mark.parametrize(
    ("size", "own", "corners"),
    [
        ("", "", [(15, 27), (65, 52)]),
        ('width="20" height="20"', "", [(15, 27), (35, 37)]),
        ('width="20" height="20"', 'preserveAspectRatio="xMinYMid slice"', [(15, 27), (35, 37)]),
        ('width="20"', "", [(15, 42), (35, 52)]),
    ],
)
def test_a_clone_of_a_nested_drawing_has_its_own_size(svg, size, own, corners):
    """SVG 2, 5.6.2: width and height of the clone come in place of those of the drawing, x and y on top."""
    inner = f'<svg id="n" x="5" y="7" width="50" height="50" viewBox="0 0 100 100" {own}>'
    body = (
        f'<defs>{inner}{path("M 0 0 C 30 50 70 0 100 50")}</svg></defs><use href="#n" x="10" y="20" {size}/>'
    )
    (curve,) = svg(body)
    np.testing.assert_allclose(curve.sample(2).position * (1, -1), corners, atol=1e-9)


def test_clones_are_found_by_their_own_id(tmp_path):
    """A clone had the id of its original: neither could be chosen by it."""
    arch = 'd="M 0 0 C 30 50 70 0 100 50"'
    file = tmp_path / "clones.svg"
    file.write_text(
        f'<svg xmlns="http://www.w3.org/2000/svg" width="200mm" height="100mm" viewBox="0 0 200 100">'
        f'<path id="arch" {arch}/><use id="use1" href="#arch" x="200"/><use href="#arch" x="400"/>'
        f'<defs><g id="pair"><path id="one" {arch}/><use id="inner" href="#arch" y="100"/></g></defs>'
        f'<use id="use2" href="#pair" y="300"/></svg>'
    )
    drawing = read_drawing(file)
    assert [one.name for one in drawing] == ["arch", "use1/arch", "arch", "use2/one", "use2/arch"]
    for request, start in (
        ("use1", (200, 0)),
        ("one", (0, -300)),
        ("use2/arch", (0, -400)),
        ("4", (0, -300)),
    ):
        assert drawing.one(request, None, "--curve").curve.sample(2).position[0] == pytest.approx(start)
    assert len(drawing.chosen("arch")) == 2
    with pytest.raises(
        InputError, match=r"contains 2 curves: choose a curve with --curve.*4 \(use2/one\), 5"
    ):
        drawing.one("use2", None, "--curve")


NAMESPACES = (
    'xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" xmlns:serif="http://www.serif.com/" '
    'width="200mm" viewBox="0 0 200 100"'
)


@pytest.mark.parametrize(("first", "second", "names"), [
    ('id="a"', 'id="b"', ["a", "b"]),
    ('id="rib-1"', 'id="rib-2"', ["rib-1", "rib-2"]),
    ('id="path7" inkscape:label="Left"', 'id="path9" inkscape:label="Right"', ["Left", "Right"]),
    ('id="path7" inkscape:label="1"', 'id="path9" inkscape:label="2"', ["1", "2"]),
    ('id="rib_x5F_a" data-name="rib_a"', 'id="rib_x5F_b" data-name="rib_b"', ["rib_a", "rib_b"]),
    ('id="rib-1" serif:id="rib 1"', 'id="rib-2" serif:id="rib 2"', ["rib 1", "rib 2"]),
    ('id="rib"', 'id="path12"', ["rib", "path12"]),
    ('id="rib" inkscape:label="rib"', 'id="rib-3" inkscape:label="rib"', ["rib", "rib"]),
    ('id="path7"', 'id="path9-1-6"', ["path7"]),
    ('id="Path_17" data-name="Path 17"', 'id="Path_18" data-name="Path 18"', ["Path_17"]),
    ('id="XMLID_5_"', 'id="XMLID_6_"', ["XMLID_5_"]),
    ('id="Pfad_1_"', 'id="Pfad_2_"', ["Pfad_1_"]),
    ('id="Vector"', 'id="Vector_2"', ["Vector"]),
    ('id="Path"', 'id="Path-Copy-2"', ["Path"]),
    ('id="2F"', 'id="30"', ["2F"]),
    ('id="SPLINE_2F"', 'id="LINE-30"', ["SPLINE_2F"]),
    ('id="_2183914512"', 'id="_2183914560"', ["_2183914512"]),
    ('id="6fa459ea-ee8a-3ca4-894e-db77e160355e"', "", ["6fa459ea-ee8a-3ca4-894e-db77e160355e"]),
    ("", "", [""]),
])  # fmt: skip
def test_shapes_with_names_are_not_joined(svg, first, second, names):
    """Names are labels, and ids that no drawing program made."""
    body = f'<path {first} d="M0 0 C 20 40 60 40 90 9"/><path {second} d="M90 9 C 110 -10 150 -20 180 0"/>'
    read = svg(body, NAMESPACES)
    assert [one.name for one in read.file] == names
    assert len(read.notes) == (len(names) > 1)


def test_touching_shapes_with_names_are_reported_in_one_line(svg):
    """A path of two pieces is one shape; two shapes of different names that lie on each other stay two."""
    rib = 'd="M0 0 C 20 40 60 40 90 9 M90 9 C 110 -10 150 -20 180 0"'
    ends = ["0 0 C 20 -40 30 -40", "180 0 C 190 50 195 50", "0 0 C 20 -60 30 -60"]
    others = "".join(f'<path id="side{k}" d="M{end} {20 + 9 * k} 90"/>' for k, end in enumerate(ends))
    read = svg(f'<path id="rib" {rib}/><path id="twin" {rib}/>{others}', NAMESPACES)
    assert [one.name for one in read.file] == ["rib", "twin", "side0", "side1", "side2"]
    message, twice = read.notes
    assert "curve 1 (rib) and curve 2 (twin)" in message
    assert twice == "drawn twice with different layers or names, so both are used: twin lies on rib"
    assert "and 2 more. To make one strip" in message
    assert "combine them into one path in the drawing program, or remove their names" in message


def test_a_curve_is_chosen_by_label_and_by_id(svg):
    body = "".join(
        f'<path id="path{7 + k}" inkscape:label="{label}" d="M0 {k} C 20 {40 + k} 60 {40 + k} 90 {k}"/>'
        for k, label in enumerate(("3", "Rib 2", "1"))
    )
    file = svg(body, NAMESPACES).file
    for request, number in (("3", 1), ("1", 3), ("path8", 2), ("Rib 2", 2), ("2", 2)):
        assert file.one(request, None, "").number == number


def test_clones_of_a_shape_with_a_name_are_not_joined(svg):
    half = 'd="M0 0 C 20 40 60 40 90 9"'
    for name, count in (("half", 2), ("path3", 1)):
        clone = f'<use id="use3" href="#{name}" transform="matrix(-1 0 0 1 180 0)"/>'
        assert len(svg(f'<path id="{name}" {half}/>{clone}', NAMESPACES)) == count


def test_what_is_within_something_invisible_is_left_out(svg):
    arch = "M 0 0 C 30 50 70 0 100 50"
    hidden = f'<g visibility="hidden">{path(arch)}<g style="visibility:visible">{path("M 0 9 Q 50 0 90 9")}</g></g>'
    sheet = f'<style>.away {{ visibility: hidden }}</style><g class="away">{path(arch)}</g>'
    found = svg(hidden + sheet)
    assert len(found) == 1
    assert found.notes == ("left out because they are not curves: 2 hidden or empty shape",)


def test_a_packed_drawing_is_unpacked(tmp_path):
    text = f'<svg xmlns="http://www.w3.org/2000/svg" width="100">{path("M 0 0 C 30 50 70 0 100 50")}</svg>'
    for name in ("arch.svgz", "arch.svg"):
        (tmp_path / name).write_bytes(gzip.compress(text.encode()))
        (curve,) = read_curves(tmp_path / name)
        assert curve.control_points[-1] == pytest.approx((100 * PX, -50 * PX))
    (tmp_path / "plain.svgz").write_text(text)
    assert len(read_curves(tmp_path / "plain.svgz")) == 1
    for broken in (gzip.compress(text.encode())[:-12], b"\x1f\x8bnothing"):
        (tmp_path / "broken.svgz").write_bytes(broken)
        with pytest.raises(
            InputError, match=r"broken\.svgz: is compressed and cannot be unpacked: save the file again"
        ):
            read_curves(tmp_path / "broken.svgz")
    (tmp_path / "large.svgz").write_bytes(gzip.compress(bytes(2**20), 9) * 65)
    with pytest.raises(InputError, match="more than 64 MB when unpacked"):
        read_curves(tmp_path / "large.svgz")


@pytest.mark.parametrize(
    ("size", "told"),
    [
        ("", True),
        ('width="300" height="200"', True),
        ('width="300px" height="200px"', True),
        ('width="100%"', True),
        ('width="300mm" height="200mm"', False),
        ('width="300MM" height="200MM"', False),
        ('width="300,0mm"', False),
        ('style="width:300mm"', False),
    ],
)
def test_a_size_without_a_unit_is_reported(tmp_path, size, told):
    """A script's drawing in millimetres would be cut at a quarter of its size, within what is usual for a strip."""
    file = tmp_path / "arch.svg"
    file.write_text(
        f'<svg xmlns="http://www.w3.org/2000/svg" {size} viewBox="0 0 300 200">'
        '<path d="M 10,150 A 140,140 0 0 1 290,150"/></svg>'
    )
    found = read_curves(file)
    assert found[0].length == pytest.approx(140 * np.pi * (25.4 / 96 if told else 1))
    assert ["no unit" in note and "set unit to mm" in note for note in found.notes] == [True] * told
    assert not read_curves(file, unit="mm").notes


@pytest.mark.parametrize("size", ["60vw", "30ex", "20em", "7furlong"])
def test_a_size_of_another_unit_is_named(svg, size):
    (message,) = svg(path("M 0 0 C 30 50 70 0 100 50"), f'width="{size}" viewBox="0 0 300 200"').notes
    assert f"its size, '{size}', is not in a unit of length" in message
    assert "set unit to mm" in message


def test_lengths_of_shapes_have_units_in_any_writing(svg):
    (curve,) = svg('<line x1="1CM" y1="0" x2="30,5mm" y2="0"/>')
    assert curve.length == pytest.approx(20.5 / PX)
