"""Suggestions of two plates are followed: gap, length and width of the tabs are used as the message states them."""

import re
from dataclasses import replace

import numpy as np
import pytest

import elastica_cad as ec
from elastica_cad import InputError
from elastica_cad.model import revolve, rocking_tabs
from elastica_cad.model.assembly import engraved_marks
from elastica_cad.model.fixtures import tabs_to_hold
from elastica_cad.model.plate_pairs import end_plates, tab_plane
from elastica_cad.model.plates import base_plate, tips_below
from elastica_cad.strip.outline import Tab
from elastica_cad.strip.strip import Placed

LAMP = [(60, 0), (85, 40), (100, 90), (85, 140), (60, 180)]
POT = [(70, 0), (85, 16), (125, 55), (90, 115), (75, 140)]
CONE = [(60, 0), (80, 60), (95, 120), (105, 180)]
PLATES = r"plates \(gap = (\d+)\) and tabs ([\d.]+) mm long(?: and (\d+) mm wide)?"


def suggested_tab(found):
    length, width = found.groups()[-2:]
    return Tab(float(length), width=width and float(width))


LAMPS = [
    (LAMP, 1.0, 12, "polypropylene-0.8", "mdf-3"),
    (CONE, 1.0, 11, "birch-plywood-0.8", "mdf-3"),
    (POT, 1.8, 8, "polypropylene-0.8", "mdf-3"),
    (CONE, 0.6, 15, "card-200gsm", "hdf-1.5"),
    (CONE, 1.3, 12, "birch-plywood-0.8", "mdf-3"),
]


@pytest.mark.campaign
@pytest.mark.parametrize(("points", "scale", "count", "sheet", "rings"), LAMPS)
def test_rings_hold_the_tabs_that_the_message_suggests(points, scale, count, sheet, rings):
    meridian = ec.meridian_through([(scale * x, scale * y) for x, y in points])
    single = revolve(meridian, count, sheet=sheet, rings=rings)
    found = re.search(PLATES, rocking_tabs(single.placed, single.plates)[0])
    tab = suggested_tab(found)
    double = revolve(meridian, count, sheet=sheet, rings=rings, gap=float(found[1]), ends=(tab, tab))
    assert not rocking_tabs(double.placed, double.plates)
    assert {*double.strips[0].strain_warnings} <= {*single.strips[0].strain_warnings}


@pytest.mark.campaign
@pytest.mark.parametrize(
    ("points", "scale", "count", "sheet", "rings"),
    [(LAMP, 1.6, 9, "birch-plywood-0.8", "mdf-3"), (POT, 0.6, 20, "card-200gsm", "hdf-1.5")],
)
def test_no_tab_is_suggested_that_would_crack_or_stay_bent(points, scale, count, sheet, rings):
    meridian = ec.meridian_through([(scale * x, scale * y) for x, y in points])
    single = revolve(meridian, count, sheet=sheet, rings=rings)
    assert not re.search(PLATES, rocking_tabs(single.placed, single.plates)[0])


@pytest.mark.campaign
def test_a_strip_that_would_break_at_a_narrow_tab_gets_no_such_suggestion():
    small = ec.meridian_through([(0.6 * x, 0.6 * y) for x, y in LAMP])
    single = revolve(small, 12, sheet="birch-plywood-0.8", rings="birch-plywood-4")
    with pytest.raises(InputError, match="strain across the tab"):
        revolve(small, 12, sheet="birch-plywood-0.8", ends=(Tab(32, width=7), Tab(32, width=7)))
    assert not re.search(PLATES, rocking_tabs(single.placed, single.plates)[0])


def ribs(tab, count=8):
    """Strips around an axis, whose tabs lean inwards."""
    bow = ec.PlaneCurve.spline([(60, 0), (90, 60), (90, 120), (60, 180)], degree=3)
    rib = ec.make_strip(bow, "birch-plywood-0.8", max_width=20)
    rib = replace(rib, ends=(tab, tab))
    turn = 2 * np.pi * np.arange(count) / count
    return [Placed(rib, (0, 0, 0), (np.cos(t), np.sin(t), 0), (0, 0, 1)) for t in turn]


@pytest.mark.parametrize("gap", [7.0, 12.0, 25.0])
def test_a_tab_too_short_for_two_plates_follows_either_suggestion(gap):
    with pytest.raises(InputError, match="does not reach") as refused:
        end_plates(ribs(Tab(12)), "mdf-3", gap=gap)
    found = re.search(r"make the tab ([\d.]+) mm long(?: and (\d+) mm wide)?", str(refused.value))
    assert len(end_plates(ribs(suggested_tab(found)), "mdf-3", gap=gap)) == 4
    nearer = re.search(r"reduce the gap to (\d+) mm", str(refused.value))
    assert len(end_plates(ribs(Tab(12)), "mdf-3", gap=float(nearer[1]))) == 4


def test_no_longer_tab_is_suggested_where_the_second_ring_has_no_room_for_it():
    """The tabs lean inwards, so that slots of tabs as wide as the strips would meet in the second ring."""
    placed = ribs(Tab(12), count=14)
    with pytest.raises(InputError, match="does not reach") as refused:
        end_plates(placed, "mdf-3", gap=40.0)
    tab = suggested_tab(
        re.search(r"make the tab ([\d.]+) mm long(?: and (\d+) mm wide)?", str(refused.value))
    )
    with pytest.raises(InputError):
        end_plates(ribs(Tab(tab.length), count=14), "mdf-3", gap=40.0)
    assert len(end_plates(ribs(tab, count=14), "mdf-3", gap=40.0)) == 4


def test_tabs_that_the_load_bends_get_the_length_of_the_bent_tab():
    """The straight tab would be long enough. The bent tab ends at the lower face of the second ring."""
    ball = ec.meridian_through([(60, 0), (103.9, 43.9), (120, 104), (103.9, 164.1), (60, 208)])

    def rings(tab, gap):
        return revolve(
            ball, 12, sheet="polypropylene-0.8", rings="polypropylene-0.8", gap=gap, ends=(tab, tab)
        )

    with pytest.raises(InputError, match="does not reach") as refused:
        rings(Tab(20, width=10), 6.0)
    found = re.search(r"make the tab ([\d.]+) mm long, or reduce the gap to (\d+) mm", str(refused.value))
    made = rings(Tab(float(found[1]), width=10), 6.0)
    assert len(made.plates) == 4
    assert not tips_below(made.plates[:2])
    assert tips_below(rings(Tab(float(found[1]) + 1, width=10), 6.0).plates[:2])
    assert len(rings(Tab(20, width=10), float(found[2])).plates) == 4


def test_where_no_longer_tab_fits_the_message_says_why():
    """The tabs could be longer, but the load would bend them too far. In single rings, they rock."""
    ball = ec.meridian_through([(60, 0), (103.9, 43.9), (120, 104), (103.9, 164.1), (60, 208)])

    def rings(length, gap=8.0):
        tabs = (Tab(length, width=10),) * 2
        return revolve(ball, 12, sheet="polypropylene-0.8", rings="birch-plywood-2", gap=gap, ends=tabs)

    result = (
        r"does not reach .*: with tabs ([\d.]+) mm long, there is another problem: .*: the load .* too far"
    )
    with pytest.raises(InputError, match=result) as refused:
        rings(10.0)
    longer = float(re.search(result, str(refused.value))[1])
    with pytest.raises(InputError, match="the load of the strip bends the tab of strip 1:1 too far"):
        rings(longer)
    single = rings(10.0, gap=None)
    assert rocking_tabs(single.placed, single.plates)
    assert "let the strips meet the plate more steeply" in str(refused.value)


@pytest.mark.parametrize(
    ("latitudes", "gap", "tabs"),
    [((30, 60), 12, (Tab(16, width=10),) * 2), ((60, 30), 12, None), ((60, 30), 6, (Tab(16, width=10),) * 2)],
)
def test_suggestions_hold_for_both_rings_of_a_revolution(latitudes, gap, tabs):
    """The tabs of the smaller ring lean more; without given tabs, the tabs depend on the gap."""
    turns = np.radians(np.linspace(-latitudes[0], latitudes[1], 5))
    ball = ec.meridian_through(120 * np.column_stack([np.cos(turns), np.sin(turns) - np.sin(turns[0])]))
    plastic = "polypropylene-0.8"

    def rings(gap=gap, ends=tabs):
        return revolve(ball, 12, sheet=plastic, rings=plastic, gap=gap, ends=ends)

    with pytest.raises(InputError, match=r"second plate|too far") as refused:
        rings()
    longer = re.search(r"make the tab ([\d.]+) mm long(?: and (\d+) mm wide)?", str(refused.value))
    nearer = re.search(r"reduce the gap to (\d+) mm", str(refused.value))
    assert longer or nearer or "let the strips meet the plate more steeply" in str(refused.value)
    if longer:
        length, width = longer.groups()
        ends = tuple(Tab(float(length), width=float(width) if width else tab.width) for tab in tabs)
        assert len(rings(ends=ends).plates) == 4
    assert len(rings(gap=float(nearer[1]) if nearer else None).plates) == (4 if nearer else 2)


@pytest.mark.parametrize("lean", [9.5, 12.0])
def test_flat_tabs_around_an_axis_are_refused_with_their_angle(lean):
    arch = ec.make_strip(
        ec.PlaneCurve.arc((60, 0), 80, np.pi / 2 - np.radians(lean), 2.6),
        "birch-plywood-0.8",
        max_width=12,
        ends=Tab(15),
    )
    turns = np.arange(7) * 2 * np.pi / 7
    placed = [Placed(arch, (0, 0, 0), (np.cos(t), np.sin(t), 0), (0, 0, 1)) for t in turns]
    with pytest.raises(
        InputError, match=f"ring: the tabs meet the plate at {lean:g} degrees, .* more than 15"
    ):
        tab_plane(tabs_to_hold(placed, ["start"]), "ring")


@pytest.mark.parametrize("label", ["R", "rib 4"])
def test_the_example_of_an_engraved_end_is_an_end_of_the_model(label):
    arch = ec.make_strip(
        ec.PlaneCurve.arc((0, 0), 60, 0.3, 2.8), "birch-plywood-0.8", max_width=12, ends=Tab(12), label=label
    )
    placed = [Placed(arch, (0, y, -17), (1, 0, 0), (0, 0, 1)) for y in (0, 60)]
    base = base_plate(placed, "mdf-3")
    assert any(f"such as {label}:1." in text for text in engraved_marks(ec.Model(placed), [base]))
