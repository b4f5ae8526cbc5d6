"""Tabs with T-slots and tapers: exact areas, sound files, bodies that hold the screw."""

from dataclasses import dataclass, fields, replace

import numpy as np
import pytest
import shapely

from elastica_cad import Hole, InputError, Rod, Sheet, Strip, Tab
from elastica_cad.model import EndFixture
from elastica_cad.strip import FlatSolid, TSlot
from elastica_cad.strip.outline import lines_through
from elastica_cad.strip.uncuttable_parts import find_strip_faults

PLY = Sheet.named("birch-plywood-3")


def strip(tab, width=30.0):
    return Strip(Rod.straight(100.0), PLY, max_width=width, ends=(tab, tab), label="T")


@pytest.mark.parametrize("rim", [{}, {"corner_radius": 3.0}, {"chamfer": 3.0}, {"taper": 4.0}])
@pytest.mark.parametrize("deep", [6.6, 12.0])
def test_a_t_slot_takes_its_area_away(rim, deep, check_drawing):
    slot = TSlot(deep)
    plain, cut = strip(Tab(20, **rim)), strip(Tab(20, t_slot=slot, **rim))
    gone = deep * 3.2 + (5.6 - 3.2) * 2.6
    assert plain.area - cut.area == pytest.approx(2 * gone)
    assert cut.outline.area > 0
    check_drawing(cut.drawing())


def test_a_taper_makes_a_trapezium():
    assert strip(Tab(10, taper=4)).area == pytest.approx(30 * 100 + 2 * 10 * (30 + 22) / 2)


def test_a_chamfer_cuts_two_corners_of_a_tab():
    assert strip(Tab(10, chamfer=3)).area == pytest.approx(30 * 100 + 2 * (10 * 30 - 3**2))


def test_the_slot_lies_in_the_middle_of_the_edge():
    outline = strip(Tab(20, t_slot=TSlot(12, screw=4.0, nut=(7.0, 3.2), wall=5.0))).outline
    corners = {tuple(np.round(segment.start, 9)) for segment in outline.segments}
    for sign in (-1, 1):
        for x, y in ((20, 2), (15, 2), (15, 3.5), (11.8, 3.5), (11.8, 2), (8, 2)):
            assert (100.0 + x, sign * float(y)) in corners
            assert (-float(x), sign * float(y)) in corners


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: TSlot(-1), "T-slot depth is -1: give a number above 0, in mm"),
        (lambda: TSlot(10, nut=(3.0, 2.0)), "slips through the slot"),
        (lambda: TSlot(5), "is too shallow for its nut, which reaches 6.6 mm deep"),
        (lambda: Tab(10, t_slot=TSlot(10)), "does not fit a tab 10 mm long"),
        (lambda: Tab(10, taper=2, chamfer=1), "cannot have a corner radius or a chamfer"),
        (lambda: Tab(10, taper=-2), "tab taper is -2"),
        (
            lambda: strip(Tab(20, t_slot=TSlot(12)), width=5.0).outline,
            "wider than the tab's outer edge of 5 mm",
        ),
        (lambda: strip(Tab(10, taper=15)).outline, "a taper of 15 mm on each side is too large"),
        (
            lambda: strip(Tab(20, t_slot=TSlot(12), holes=(Hole(10, 3),))).holes,
            "cuts the edge of a tab 30 mm wide",
        ),
    ],
)
def test_what_does_not_fit_is_refused(make, message):
    with pytest.raises(InputError, match=message):
        make()


@dataclass(frozen=True)
class HookedTab(Tab):
    """A tab with a notch in one side, which no list knows."""

    notch: float = 0.0

    def corners(self, width):
        across = [
            (0, -width / 2),
            (self.length, -width / 2),
            (self.length, width / 2),
            (15, width / 2),
            (15, width / 2 - self.notch),
            (10, width / 2 - self.notch),
            (10, width / 2),
            (0, width / 2),
        ]
        return lines_through(across)


def test_a_new_kind_of_tab_is_cut_and_checked():
    hooked = HookedTab(20, notch=18.9)
    for ends in ((hooked, Tab(0)), (Tab(0), hooked), (hooked, Tab(20, chamfer=0.5))):
        made = Strip(Rod.straight(100.0), PLY, max_width=20.0, ends=ends)
        assert made.area == pytest.approx(20 * (100 + sum(tab.length for tab in ends)) - 5 * 18.9, abs=0.3)
        assert any("only 1.1 mm wide" in fault.what for fault in find_strip_faults(made)), ends
    holed = HookedTab(20, notch=5.0, holes=(Hole(12, 3, 7),))
    with pytest.raises(InputError, match="cuts the edge of a tab 20 mm wide"):
        Strip(Rod.straight(100.0), PLY, max_width=20.0, ends=(holed, Tab(0))).drawing()


@pytest.mark.parametrize("field", fields(Tab)[1:], ids=lambda field: field.name)
def test_a_tab_of_any_shape_is_not_plain(field):
    values = {"width": 8.0, "holes": (Hole(6, 3),), "t_slot": TSlot(10)}
    tab = Tab(20, **{field.name: values.get(field.name, 2.0)})
    assert tab != tab.plain == Tab(20)


def test_holes_beside_or_behind_the_slot_stay():
    tab = Tab(20, t_slot=TSlot(10), holes=(Hole(5, 3), Hole(14, 3, 8)))
    assert len(strip(tab).holes) == 4


def test_the_screw_goes_through_the_wall_of_the_block():
    fixture = EndFixture.of(strip(Tab(20, t_slot=TSlot(12))), "end")
    round_ones = [
        prism
        for prism in fixture.solid.removed
        if isinstance(prism, FlatSolid) and prism.outline.segments[0].length == pytest.approx(3.2 * np.pi)
    ]
    (drill,) = round_ones
    assert drill.frame.origin == pytest.approx(fixture.tab.tip)
    assert drill.frame.z_axis == pytest.approx(fixture.tab.frame.x_axis)
    assert drill.thickness > fixture.clearance + fixture.wall


@pytest.mark.parametrize(("wide", "drawn"), [(8.0, 8.0), (40.0, 40.0), (30.0004, 30.0), (None, 30.0)])
def test_a_tab_is_as_wide_as_requested_but_for_shoulders_that_nobody_can_cut(wide, drawn):
    made = strip(Tab(20, width=wide))
    assert made.area == pytest.approx(30 * 100 + 2 * 20 * drawn)
    points = made.outline.points(0.1)
    for beyond in (points[:, 0] < -1, points[:, 0] > 101):
        assert np.ptp(points[beyond, 1]) == pytest.approx(drawn)


@pytest.mark.parametrize("gap", [-0.5, 0.5])
def test_holes_of_a_tab_that_meet_are_refused(gap):
    """They were cut as two loops over each other."""
    one = Hole(5.0, 4.0, -2.0)  # 5 mm from the middle of the other
    holes = (one, replace(one, at=9.0, across=1.0, diameter=6.0 - 2 * gap))
    if gap < 0:
        with pytest.raises(InputError, match="5 and 9 mm from the start of the tab, overlap: move one"):
            Tab(20.0, holes=holes)
    else:
        one, other = (shapely.Polygon(p.points(1e-4)) for p in Tab(20.0, holes=holes).hole_paths(20.0))
        assert one.distance(other) == pytest.approx(gap, abs=1e-3)
