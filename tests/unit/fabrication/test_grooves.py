"""Grooves of engraved strokes: as wide as the tool, as long as the stroke and its square ends."""

import numpy as np
import pytest
import shapely

from elastica_cad.fabrication.drawings.grooves import grooves
from elastica_cad.geometry.paths.path import Path

WIDTHS = (0.4, 1.0, 1.5)


def area(found):
    """What is taken away, overlaps once."""
    shells = [shapely.Polygon(one.points(1e-3), [h.points(1e-3) for h in holes]) for one, holes in found]
    assert all(shell.is_valid for shell in shells)
    return shapely.union_all(shells)


@pytest.mark.parametrize("width", WIDTHS)
def test_a_straight_groove_is_a_rectangle(width):
    found = grooves(Path.polyline([(2, 1), (14, 6)]), width, 0.1)
    assert len(found) == 1
    assert area(found).area == pytest.approx((13 + width) * width)


@pytest.mark.parametrize("width", WIDTHS)
def test_a_bent_groove_follows_its_stroke(width):
    points = [(0, 0), (10, 0), (17, 7), (17, 20)]
    taken = area(grooves(Path.polyline(points), width, 0.1))
    wanted = shapely.LineString(points).buffer(width / 2, cap_style="square", join_style="mitre")
    assert taken.symmetric_difference(wanted).area < 1e-6


@pytest.mark.parametrize("width", WIDTHS)
def test_a_stroke_that_turns_back_takes_several_grooves(width):
    points = [(0, 0), (12, 0), (2, 5), (12, 10)]
    found = grooves(Path.polyline(points), width, 0.1)
    assert len(found) == 3
    taken, line = area(found), shapely.LineString(points)
    assert taken.covers(line.buffer(width / 2 - 1e-6, cap_style="flat", join_style="bevel"))
    assert line.buffer(width, cap_style="square").covers(taken)


@pytest.mark.parametrize("width", WIDTHS)
def test_a_ring_keeps_its_island(width):
    corners = 8 * np.array([(np.cos(a), np.sin(a)) for a in 2 * np.pi * np.arange(12) / 12])
    [(outline, holes)] = grooves(Path.polygon(corners), width, 0.1)
    assert len(holes) == 1
    ring = shapely.Polygon(corners).exterior.buffer(width / 2, join_style="mitre")
    assert outline.area - holes[0].area == pytest.approx(ring.area, rel=1e-9)
