"""Slots anywhere on any strip, against shapely's difference of polygons."""

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st
from shapely.geometry import LineString, Polygon

from elastica_cad import Rod, Sheet, Slot, Strip, Tab
from elastica_cad.strip.slots import slot_cut

CARD = Sheet.named("card-200gsm")
EXACT = 1e-4  # mm, of the polygons

widths = st.lists(st.floats(0.4, 1.0), min_size=3, max_size=6)
slots = st.lists(
    st.builds(
        Slot,
        at=st.floats(6.0, 94.0),
        width=st.floats(0.2, 3.0),
        depth=st.floats(0.5, 9.0),
        side=st.sampled_from(["upper", "lower"]),
        lean=st.floats(-0.7, 0.7),
        relief=st.sampled_from(["square", "round"]),
    ),
    min_size=1,
    max_size=4,
)


def strip(stiffness, *cuts):
    return Strip(Rod.straight(100.0, stiffness), CARD, max_width=30.0, slots=cuts, ends=(Tab(5), Tab(0)))


def polygon(path):
    return Polygon(path.points(EXACT))


@pytest.mark.campaign
@settings(max_examples=25, deadline=None)
@given(widths, slots)
def test_the_outline_is_the_whole_one_less_the_slots(stiffness, cuts):
    whole = polygon(strip(stiffness).outline)
    width = strip(stiffness).width
    holes = [Polygon(slot_cut(cut, width, beyond=30.0).points(EXACT)) for cut in cuts]
    rim = LineString(whole.exterior.coords)
    for i, hole in enumerate(holes):
        assume(not any(hole.buffer(0.05).intersects(other) for other in holes[:i]))
        assume(rim.intersection(hole).geom_type == "LineString")
    expected = whole
    for hole in holes:
        expected = expected.difference(hole)
    assume(expected.geom_type == "Polygon")
    outline = strip(stiffness, *cuts).outline
    found = polygon(outline)
    assert found.is_valid
    assert outline.area > 0
    assert found.symmetric_difference(expected).area < 10 * EXACT * outline.length
    ends = [*outline.segments[1:], outline.segments[0]]
    assert all(np.hypot(*(a.end - b.start)) < 1e-6 for a, b in zip(outline.segments, ends, strict=True))
    turned = strip(stiffness, *(cut.mirrored() for cut in cuts)).outline
    np.testing.assert_allclose(turned.area, outline.area, rtol=1e-9)
