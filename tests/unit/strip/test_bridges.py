"""Holding tabs: bridges in closed cuts, and nothing else moved."""

import numpy as np
import pytest

import elastica_cad as ec
from elastica_cad import Drawing, InputError
from elastica_cad.formats import write_drawing
from elastica_cad.strip import HoldingTabs, LayeredPath, add_holding_tabs

CARD = ec.Sheet.named("card-200gsm")


def held(path, layer="CUT_OUTER", **options):
    return add_holding_tabs(Drawing("part", [LayeredPath(layer, path)]), HoldingTabs(**options)).paths


def gaps(pieces):
    return [
        float(np.hypot(*(after.path.start - before.path.end)))
        for before, after in zip(pieces, (*pieces[1:], pieces[0]), strict=True)
    ]


def test_a_rectangle_is_bridged_off_its_corners():
    pieces = held(ec.Path.rectangle(100.0, 20.0), width=1.0, spacing=60.0)
    assert len(pieces) == 4
    assert gaps(pieces) == pytest.approx([1.0] * 4)
    corners = np.array([(0, 0), (100, 0), (100, 20), (0, 20)])
    for piece in pieces:
        assert not piece.path.closed
        for end in (piece.path.start, piece.path.end):
            assert np.hypot(*(corners - end).T).min() > 0.4
    assert sum(piece.path.length for piece in pieces) == pytest.approx(240.0 - 4.0)


def test_a_circle_and_a_spline_lose_the_width_only():
    pieces = held(ec.Path.circle((3.0, 4.0), 20.0), width=2.0, least=3, spacing=1e3)
    assert sum(piece.path.length for piece in pieces) == pytest.approx(40 * np.pi - 6.0)
    strip = ec.Strip(ec.Rod.straight(200.0, [1, 3, 2, 3, 1]), CARD, max_width=40.0)
    pieces = held(strip.outline, width=0.8, spacing=90.0)
    assert sum(piece.path.length for piece in pieces) == pytest.approx(
        strip.outline.length - 0.8 * len(pieces), rel=1e-9
    )
    assert gaps(pieces) == pytest.approx([0.8] * len(pieces), rel=1e-2)


def test_inner_cuts_and_marks_stay_unless_requested():
    loop = ec.Path.rectangle(50.0, 10.0)
    assert held(loop, "CUT_INNER", spacing=40.0)[0].path is loop
    assert len(held(loop, "CUT_INNER", spacing=40.0, inner=True)) == 3
    assert held(loop, "MARK")[0].path is loop


def test_written_after_the_kerf(tmp_path, check_drawing_file):
    drawing = Drawing("part", [LayeredPath("CUT_OUTER", ec.Path.circle((0, 0), 30.0))])
    for suffix in (".dxf", ".svg"):
        file = write_drawing(drawing, tmp_path / f"part{suffix}", kerf=0.2, holding=HoldingTabs(width=1.0))
        curves = check_drawing_file(file, open_cuts=True)
        assert len(curves) == 2
        assert sum(curve.length for curve in curves) == pytest.approx(2 * np.pi * 30.1 - 2.0, rel=1e-4)
        assert not any(curve.closed for curve in curves)


def test_refusals():
    with pytest.raises(InputError, match="too short"):
        held(ec.Path.circle((0, 0), 0.3), width=0.5)
    for options in ({"width": 0.0}, {"spacing": np.inf}, {"least": 0}):
        with pytest.raises(InputError):
            HoldingTabs(**options)


def test_a_bridge_that_would_fall_on_a_corner_moves_off_it():
    corners = np.array(
        [(0, 0), (60, 0), (60, 20), (0, 20)]
    )  # every second bridge would have its middle on one
    pieces = held(ec.Path.rectangle(60.0, 20.0), width=1.0, least=4, spacing=500.0)
    assert len(pieces) == 4
    for before, after in zip(pieces, (*pieces[1:], pieces[0]), strict=True):
        bridge = np.array([before.path.end, after.path.start])
        assert np.hypot(*np.diff(bridge, axis=0)[0]) == pytest.approx(1.0)
        assert np.hypot(*(corners - bridge.mean(axis=0)).T).min() >= 1.0 - 1e-9
