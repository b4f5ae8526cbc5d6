"""Whatever the outline and the stiffness: ligaments and laminates meet the design, or a place is named."""

import re

import numpy as np
import pytest
from hypothesis import assume, given, reject, settings
from hypothesis import strategies as st

import elastica_cad as ec
from elastica_cad import InputError, Laminated, Perforated, Slot
from elastica_cad.mechanics import LaminatedSection

pytestmark = pytest.mark.core

CARD = ec.Sheet.named("card-200gsm")
PLY = ec.Sheet.named("birch-plywood-0.8")

lengths = st.floats(40.0, 600.0)
numbers = st.lists(st.floats(1.0, 4.0), min_size=4, max_size=7)


def profile(values, length, *, jump=False):
    """A smooth spline through values, or one with a jump half way."""
    n = len(values)
    if not jump:
        return ec.Profile.interpolate(np.linspace(0.0, length, n), values)
    knots = np.concatenate([np.repeat(0.0, 4), np.repeat(0.5 * length, 4), np.repeat(length, 4)])
    return ec.Profile(knots, [*values[:2], *values[:2], *values[-2:], *values[-2:]])


def made(rod, sheet, style, **options):
    """The strip, or None where it is refused with a place or a number of mm."""
    try:
        return ec.Strip(rod, sheet, style=style, **options)
    except InputError as refusal:
        if re.search(r"\d mm", str(refusal)):
            return None
        raise


@settings(max_examples=8, deadline=None)
@given(
    length=lengths,
    stiffness=numbers,
    outline=numbers,
    size=st.floats(4.0, 30.0),
    columns=st.integers(1, 4),
    rows=st.integers(1, 9),
    jump=st.booleans(),
)
def test_perforated_strips_leave_what_they_should(length, stiffness, outline, size, columns, rows, jump):
    try:
        rod = ec.Rod.straight(length, profile(stiffness, length, jump=jump))
        width = profile(size * np.array(outline), length)
    except InputError:
        reject()
    strip = made(rod, CARD, Perforated(width=width, columns=columns, rows=rows))
    assume(strip is not None)
    s = (np.arange(300) + 0.5) * length / 300
    left = strip.layers[0].material(s)
    wanted = strip.bending_stiffness * rod.profile(s) / CARD.bending_stiffness(1.0)
    off = np.abs(s - length / 2) > 1e-3 if jump else np.full(s.shape, True)
    # the sides end level beside the tabs
    assert (np.abs(left - wanted) < 1e-3 * wanted + 0.02)[off].all()
    assert (left / (2 * columns + 2)).min() > 0.5 * (1 - 1e-3)
    for hole in strip.holes:
        (x0, y0), (x1, y1) = hole.bounds
        assert hole.area > 0
        assert -1e-9 <= x0 < x1 <= length + 1e-9
        assert max(-y0, y1) < width.extremes[1] / 2


@settings(max_examples=8, deadline=None)
@given(
    length=lengths,
    stiffness=numbers,
    outline=numbers,
    size=st.floats(2.0, 30.0),
    swapped=st.booleans(),
)
def test_laminates_have_the_stiffness_they_should(length, stiffness, outline, size, swapped):
    base, backing = (PLY, CARD) if swapped else (CARD, PLY)
    try:
        rod = ec.Rod.straight(length, profile(stiffness, length))
        width = profile(size * np.array(outline), length)
    except InputError:
        reject()
    strip = made(rod, base, Laminated(width=width, backing=backing))
    assume(strip is not None)
    s = np.linspace(0.0, length, 300)
    w1, w2 = width(s), strip.layout.backing.width(s)
    assert w2.min() > 1.0 - 2e-5
    assert (w2 - w1).max() < 2e-5
    found = LaminatedSection(base, backing).on(w1).bending_stiffness(np.minimum(w1, w2))
    assert np.abs(found / (strip.bending_stiffness * rod.profile(s)) - 1).max() < 1e-4


@settings(max_examples=6, deadline=None)
@given(at=st.floats(4.0, 196.0), lean=st.floats(-0.9, 0.9), side=st.sampled_from(["upper", "lower"]))
def test_slots_anywhere_find_their_way_through_the_holes(at, lean, side):
    rod = ec.Rod.straight(200.0, [2.0, 1.0, 1.5, 1.0])
    slot = Slot(at, width=0.8, lean=lean, side=side)
    style = Perforated(width=24.0, columns=2, rows=5)
    strip = made(rod, CARD, style, slots=(slot,), ends=(ec.Tab(20.0), ec.Tab(20.0)))
    whole = ec.Strip(rod, CARD, style=style, ends=(ec.Tab(20.0), ec.Tab(20.0)))
    assert strip is not None
    lost = whole.outline.area - strip.outline.area
    assert lost > 0.8 * 12.0 * 0.99
    assert sum(hole.area for hole in strip.holes) < sum(hole.area for hole in whole.holes)
