"""Smooth paths with few decimals: the same verdict wherever rounding cannot change it, an honest one elsewhere."""

from pathlib import Path

import numpy as np
import pytest

from elastica_cad import InputError, check_equilibrium, read_curves
from elastica_cad.files import read_drawing
from elastica_cad.form_finding import smooth_curve
from elastica_cad.mechanics.theorem1 import require_bendable

pytest.importorskip("cssselect2")

ARCH = [(20, 150), (20, 95.3), (63.1, 50.2), (118.4, 50.2), (171.7, 50.2), (216.9, 88.1), (220.4, 151.3)]
WAVE = [(10, 100), (52.3, 31.4), (91.8, 22.6), (133.2, 61.1), (164.25, 89.975), (201.7, 141.9), (271.1, 88.8)]
HOOK = [(0, 0), (0, 41.3), (22.2, 71.7), (60.4, 71.7), (87.3, 71.7), (104.4, 53.1), (104.4, 31.1),
        (104.4, 11.7), (91.3, 1.2), (72.1, 1.2)]  # fmt: skip
UNITS = {"mm": 1.0, "px": 25.4 / 96, "pt": 25.4 / 72}


def turned(points, degrees):
    c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
    return np.array(points) @ np.array([[c, s], [-s, c]]) + 300.0


def drawing(folder, points, decimals, unit="mm", relative=False):
    """An SVG file that holds one path of cubics, its numbers with so many decimals of the unit."""
    places = np.asarray(points, dtype=float) / UNITS[unit]
    command = "C"
    rows = places[1:]
    if relative:
        command = "c"
        starts = np.repeat(places[:-1:3], 3, axis=0)
        rows = places[1:] - starts
    numbers = [" ".join(f"{v:.{decimals}f}" for v in row) for row in rows]
    data = f"M {' '.join(f'{v:.{decimals}f}' for v in places[0])} {command} {' '.join(numbers)}"
    size = f'width="900{unit}" height="900{unit}" viewBox="0 0 900 900"'
    path = Path(folder, "drawn.svg")
    path.write_text(f'<svg xmlns="http://www.w3.org/2000/svg" {size}><path id="p1" d="{data}"/></svg>')
    return path


@pytest.mark.campaign
@pytest.mark.parametrize("unit", UNITS)
@pytest.mark.parametrize(("points", "inflections"), [(ARCH, 0), (WAVE, 1), (HOOK, 0)])
@pytest.mark.parametrize("degrees", [0, 17])
def test_the_verdict_is_the_same_at_every_number_of_decimals(tmp_path, points, inflections, unit, degrees):
    for decimals in range(7):
        for relative in (False, True):
            (curve,) = read_curves(drawing(tmp_path, turned(points, degrees), decimals, unit, relative))
            require_bendable(curve)
            smoothing = smooth_curve(curve)
            check = check_equilibrium(smoothing.curve)
            assert check.realizable
            assert len(check.inflections) == inflections
            rounding = 0.5 * 10.0**-decimals * UNITS[unit]
            assert curve.provenance.rounding == pytest.approx(rounding, rel=0.01)
            assert curve.provenance.healed <= 2 * np.sqrt(2) * rounding
            assert smoothing.moved <= max(0.1, rounding) + 1e-12


def test_a_turn_that_digits_explain_but_no_eye_is_undecided(tmp_path):
    points = [(0, 0), (20, 30), (49.3, 39.3), (50, 40), (50.8, 40.6), (80, 50), (100, 50)]
    (curve,) = read_curves(drawing(tmp_path, points, 1))
    with pytest.raises(InputError, match=r"at \(50, 40\) mm.*a corner or a rounding error.*more decimals"):
        require_bendable(curve)
    (curve,) = read_curves(drawing(tmp_path, points, 5))
    with pytest.raises(InputError, match=r"has a corner .* from its start"):
        require_bendable(curve)


def test_real_corners_stay_refused_with_the_place_as_drawn(tmp_path):
    points = [(10, 60), (20, 20), (40, 20), (60, 20), (60, 40), (60, 60), (90, 80)]
    for decimals in range(7):
        (curve,) = read_curves(drawing(tmp_path, points, decimals, "px"))
        with pytest.raises(InputError, match=r"has a corner .* from its start") as caught:
            require_bendable(curve)
        assert "user units" in str(caught.value)
        x, y = curve.provenance.place[:2, :2] @ curve.evaluate(np.array(curve.tangent_breaks[0].t))
        assert (x, y) == pytest.approx(np.array([60, 20]) / UNITS["px"], abs=0.5)


def test_transforms_and_view_boxes_scale_the_bound(tmp_path):
    data = "M 0 0 C 10.12 20.34 30.56 20.78 40.91 10.11"
    head = 'width="100mm" height="100mm" viewBox="0 0 10 10"'
    body = f'<g transform="scale(3)"><path d="{data}"/></g>'
    (tmp_path / "a.svg").write_text(f'<svg xmlns="http://www.w3.org/2000/svg" {head}>{body}</svg>')
    (curve,) = read_curves(tmp_path / "a.svg")
    assert curve.provenance.rounding == pytest.approx(0.005 * 3 * 10)
    moved = curve.transformed(np.diag([2.0, 2.0, 1.0]))
    assert moved.provenance.rounding == pytest.approx(0.3)
    assert moved.reversed().provenance.rounding == pytest.approx(0.3)


def test_arcs_splines_and_kernel_numbers_are_taken_exactly_as_drawn(tmp_path):
    ezdxf = pytest.importorskip("ezdxf")
    document = ezdxf.new()
    space = document.modelspace()
    space.add_arc((0, 0), 50, 10, 170)
    space.add_open_spline([(0, 100), (40, 180), (90, 190), (130, 120), (190, 100)], degree=3)
    space.add_line((300, 0), (350, 0))
    space.add_arc((350, 40), 40, 270, 350)
    document.saveas(tmp_path / "a.dxf")
    for curve in read_curves(tmp_path / "a.dxf"):
        assert smooth_curve(curve).curve is curve
        assert smooth_curve(curve).moved == 0
    arc, *_ = read_curves(tmp_path / "a.dxf")
    assert smooth_curve(arc, 0.2).moved <= 0.2
    assert smooth_curve(arc, 0.2).curve is not arc


def test_pen_curves_of_a_dxf_are_faired_and_healed_by_the_digits_of_its_text(tmp_path):
    ezdxf = pytest.importorskip("ezdxf")
    document = ezdxf.new()
    points = np.round(turned(WAVE, 17), 2)
    for piece in (points[:4], points[3:]):
        document.modelspace().add_open_spline([(*p, 0) for p in piece], degree=3)
    document.saveas(tmp_path / "pen.dxf")
    (curve,) = read_curves(tmp_path / "pen.dxf", unit="mm")
    assert curve.provenance.rounding == pytest.approx(0.005)
    assert 0 < curve.provenance.healed < 0.015
    assert check_equilibrium(smooth_curve(curve).curve).realizable


def test_points_of_text_files_know_their_digits(tmp_path):
    (tmp_path / "a.csv").write_text(
        "\n".join(f"{x:.2f}, {0.01 * x * (100 - x):.2f}" for x in range(0, 101, 4))
    )
    (tmp_path / "a.txt").write_text("3 5\n0 0\n10.5 20.5\n30 40\n60.5 30\n90 0\n")
    assert read_curves(tmp_path / "a.csv")[0].provenance.rounding == pytest.approx(0.005)
    assert read_curves(tmp_path / "a.txt", unit="cm")[0].provenance.rounding == pytest.approx(0.5)


def test_a_bad_curve_does_not_spoil_the_others(tmp_path):
    good = "M 0 0 C 10 20 40 20 50 0"
    body = (
        f'<path id="good" d="{good}"/><path id="broken" d="M 0 0 C 1 2"/>'
        '<path id="cusp" d="M 200 0 C 200 0 200 0 250 40 C 250 40 250 40 290 0"/><text>A</text>'
    )
    (tmp_path / "a.svg").write_text(f'<svg xmlns="http://www.w3.org/2000/svg">{body}</svg>')
    curves = read_curves(tmp_path / "a.svg")
    file = read_drawing(tmp_path / "a.svg")
    assert len(curves) + len(file.bad) == len(file)
    assert curves[0].provenance.name == "good"
    assert any("broken" in name for name in file.skipped)
    assert file.skipped["text"] == 1
    assert any("text" in note for note in curves.notes)
    (tmp_path / "b.svg").write_text('<svg><path d="M 0 0 C 1 2"/></svg>')
    with pytest.raises(InputError, match="incomplete or invalid"):
        read_curves(tmp_path / "b.svg")
