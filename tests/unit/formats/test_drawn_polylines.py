"""Polylines of drawings: smooth where the smooth curve stays near the drawn sides, with corners elsewhere."""

from itertools import pairwise

import ezdxf
import numpy as np
import pytest

from elastica_cad import InputError, read_curves
from elastica_cad.geometry.fairing import round_corners
from elastica_cad.mechanics.theorem1 import require_bendable


def read(tmp_path, vertices, kind):
    vertices = np.asarray(vertices, dtype=float)
    if kind == "svg":
        path = tmp_path / "drawn.svg"
        points = " ".join(f"{x:.9g},{y:.9g}" for x, y in vertices)
        path.write_text(
            f'<svg xmlns="http://www.w3.org/2000/svg" width="500mm" height="500mm" viewBox="0 0 500 500">'
            f'<polyline points="{points}" fill="none" stroke="black"/></svg>'
        )
    else:
        document = ezdxf.new("R2010", units=4)
        space = document.modelspace()
        if kind == "lines":
            for start, end in pairwise(vertices):
                space.add_line(start, end)
        else:
            space.add_lwpolyline(vertices)
        path = tmp_path / "drawn.dxf"
        document.saveas(path)
    (curve,) = read_curves(path)
    return curve


def arc(turn, facets, radius=100.0):
    angles = np.linspace(0, np.radians(turn), facets + 1)
    return radius * np.column_stack([np.sin(angles), 1 - np.cos(angles)])


@pytest.mark.parametrize("kind", ["svg", "polyline", "lines"])
@pytest.mark.parametrize("turn", [30, 40, 49])
def test_chamfers_are_corners(tmp_path, kind, turn):
    cos, sin = np.cos(np.radians(turn)), np.sin(np.radians(turn))
    vertices = np.array([(10, 10), (90, 10), (90 + 60 * cos, 10 + 60 * sin), (170 + 60 * cos, 10 + 60 * sin)])
    curve = read(tmp_path, vertices, kind)
    assert np.abs(np.degrees([abs(corner.angle) for corner in curve.tangent_breaks]) - turn).max() < 1e-3
    assert curve.length == pytest.approx(220, abs=1e-4)
    with pytest.raises(InputError, match="set smooth to") as refused:
        require_bendable(curve)
    smooth = refused.value.refusal.changes[0].value
    rounded, moved = round_corners(curve, smooth)
    assert not rounded.has_corners
    assert 0.5 < moved <= smooth
    assert round_corners(curve, moved / 2)[0].has_corners


@pytest.mark.parametrize("kind", ["svg", "polyline", "lines"])
@pytest.mark.parametrize(("turn", "facets"), [(180, 36), (90, 36), (120, 400)])
def test_facets_of_an_arc_are_smooth(tmp_path, kind, turn, facets):
    curve = read(tmp_path, arc(turn, facets) + 10, kind)
    assert not curve.tangent_breaks
    assert curve.length == pytest.approx(100 * np.radians(turn), rel=1e-3)


def test_an_arc_of_facets_stays_smooth_beside_a_corner(tmp_path):
    vertices = np.vstack([arc(90, 40), [(160, 100), (160, 300)]])
    curve = read(tmp_path, vertices, "polyline")
    turns = np.degrees([abs(corner.angle) for corner in curve.tangent_breaks])
    assert turns == pytest.approx([90, 90], abs=2)
