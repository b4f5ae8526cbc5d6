"""Holes and notches for cords and lugs: where they are, how the strip compensates them, and what is refused."""

import re

import numpy as np
import pytest

import elastica_cad as ec
from elastica_cad.errors import InputError
from elastica_cad.strip.element_cuts import ElementCut, lengths_added_by_cuts
from elastica_cad.strip.summary import cut_rows

WAVE = ec.PlaneCurve.spline(
    [(0, 0), (60, 60), (120, 10), (180, -40), (240, 5), (300, 60), (360, 0)], degree=5
)
SHEET = "birch-plywood-0.8"


def strip_of(*elements, **options):
    return ec.make_strip(WAVE, SHEET, **{"max_width": 40, "between": elements} | options)


def test_the_strip_has_a_hole_at_a_pin_and_notches_at_both_ends_of_a_tie():
    strip = strip_of(ec.Pin(200, hole=5), ec.Tie(40, 310, notch=3))
    (hole,) = strip.holes
    assert hole.bounds == pytest.approx(np.array([[197.5, -2.5], [202.5, 2.5]]))
    net, width = strip.layers[0].material([40, 200, 310]), strip.width([40, 200, 310])
    assert width - net == pytest.approx([6, 5, 6], abs=1e-3)
    alone = ec.Strip(strip.rod, SHEET, max_width=40)
    assert [(slot.at, slot.side) for slot in alone.slots] == [(slot.at, slot.side) for slot in strip.slots]
    assert len(strip.mirrored().slots) == len(strip.slots) == 4


@pytest.mark.parametrize("cut", [{"hole": 4}, {"hole": 8}, {"notch": 2.5}])
def test_a_widening_compensates_the_cuts(cut):
    plain, tied = strip_of(ec.Rail(200), ec.Tie(40, 310)), strip_of(ec.Rail(200), ec.Tie(40, 310, **cut))
    assert tied.width(175) == pytest.approx(float(plain.width(175)), rel=1e-6)  # away from the cuts
    # in a beam of the widths, the cuts bend as much as the widenings do less
    for at, added in lengths_added_by_cuts(tied.rod, tied.width, tied.sheet):
        s = np.linspace(at - 40, min(at + 40, tied.rod.length), 4001)
        saved = np.trapezoid(1 - plain.width(s) / tied.width(s), s)
        assert saved == pytest.approx(added, rel=2e-3)
    assert tied.deviation_as_built < 0.25


@pytest.mark.parametrize(
    ("share", "poisson", "plate"), [(0.2, 0.0, 0.0549), (0.2, 0.3, 0.0588), (0.4, 0.3, 0.2651)]
)
def test_a_hole_bends_as_in_plate_elements(share, poisson, plate):
    """`plate`: length that a hole adds to a strip 1 wide, by the grid of finite_elements/idle_corners.py."""
    sheet = ec.Sheet("even", 1.0, 12.0, density=1000.0, max_strain=0.01, poisson_ratio=poisson)
    added = ElementCut(200, hole=share, notch=0, noun="").added_length(1.0, sheet)
    assert added == pytest.approx(plate, rel=0.05)  # the grid draws the circle in 24 steps


@pytest.mark.parametrize(
    ("elements", "message"),
    [
        ((ec.Pin(200, hole=70),), "are 70 mm wide in total"),
        ((ec.Tie(40, 310, notch=20),), "are 40 mm wide in total"),
        (
            (ec.Rail(200), ec.Tie(40, 90, hole=4), ec.Pin(93, hole=4)),
            "90 mm and 93 mm from the start overlap",
        ),
        ((ec.Pin(200, hole=12),), "between a hole and the edge"),
    ],
)
def test_cuts_without_room_are_refused(elements, message):
    shop = ec.FabricationLimits(least_bridge=15, least_width=15)
    with pytest.raises(InputError, match=message):
        strip_of(*elements, shop=shop)


@pytest.mark.parametrize("cut", [{"hole": -1}, {"notch": "wide"}, {"hole": 3, "notch": 3}])
def test_a_cut_of_no_size_or_of_both_kinds_is_refused(cut):
    with pytest.raises(InputError, match=r"hole|notch"):
        ec.Tie(40, 310, **cut)


def test_a_hole_at_a_free_end_needs_a_tab():
    bow = ec.bend(ec.Rod.straight(500.0), end=(400.0, 0.0), supports=ec.Supports("pinned", "pinned")).curve
    request = {"supports": ec.Supports("free", "free"), "between": ec.Tie(0, bow.length, hole=3)}
    assert len(ec.make_strip(bow, SHEET, max_width=20, ends=ec.Tab(8), **request).holes) == 2
    with pytest.raises(InputError, match="extends beyond the end of the strip"):
        ec.make_strip(bow, SHEET, max_width=20, ends=ec.Tab(0), **request)


def test_a_brittle_sheet_may_crack_beside_a_hole_at_a_sharp_bend():
    warned = [str(warning) for warning in strip_of(ec.Rail(200), ec.Tie(40, 310, hole=4)).strain_warnings]
    assert any(
        "At 310 mm from the start, the edge of the hole or notch for the tie" in text for text in warned
    )
    assert not strip_of(ec.Rail(200), ec.Tie(40, 310)).strain_warnings


def test_a_cord_that_crosses_the_strip_is_reported():
    (warning,) = strip_of(ec.Rail(200), ec.Tie(40, 310)).warnings
    assert "from 40 mm to 310 mm crosses the strip 107 mm from its start. Use two cords" in warning
    chord = WAVE.at([40.0, 310.0]).position
    crossing = WAVE.at([107.0]).position[0] - chord[0]
    along = np.diff(chord, axis=0)[0]
    assert abs(crossing[0] * along[1] - crossing[1] * along[0]) / np.hypot(*along) < 2
    assert not any("crosses" in text for text in strip_of(ec.Rail(200), ec.Tie(60, 120)).warnings)


def test_notches_that_are_too_close_for_two_cords_are_reported():
    made = strip_of(ec.Rail(200), ec.Tie(40, 310, notch=4))
    (warning,) = [text for text in map(str, made.warnings) if "two cords" in text]
    numbers = re.search(r"107 mm from its start, .* are ([\d.]+) apart there .* is ([\d.]+) mm wide", warning)
    gap, wide = map(float, numbers.groups())
    bottoms = made.width(np.array([40.0, 310.0])) - 8
    assert bottoms.min() - 0.1 <= gap <= bottoms.max() + 0.1 < wide
    assert wide == pytest.approx(made.width(107.0), rel=0.01)


def test_the_place_of_a_hole_is_rounded_once():
    made = strip_of(ec.Rail(200), ec.Tie(82.5362, 310, hole=3), ends=(ec.Tab(40.0), ec.Tab(40.0)))
    (row,) = cut_rows(made)
    assert "holes of 3 mm at 123 and 350 mm" in row.text
