"""Strips in holders that leave them room: where they come to rest, and what keeps them as designed."""

import re
from dataclasses import replace

import numpy as np
import pytest
from scipy.optimize import nnls

from elastica_cad import (
    InputError,
    NotConvergedError,
    Perforated,
    Placed,
    PlaneCurve,
    Rod,
    Sheet,
    Slot,
    Strip,
    Tab,
    bend,
    meridian,
    meridian_through,
    optimal_rod,
    revolve,
    sheet_names,
)
from elastica_cad.mechanics import anticlastic_factor
from elastica_cad.model import (
    EndFixture,
    PlacedTab,
    add_feet,
    base_plate,
    held_shapes,
    holder_plays,
    plate_pair,
    rocking_tabs,
    slotted_frame,
    tab_seats,
)
from elastica_cad.model.held_tabs import seat_of
from elastica_cad.model.plate_pairs import end_plates
from elastica_cad.strip import MakingTolerance, TabSeat, compensate_widths
from elastica_cad.strip.as_made import stiffness_factors
from elastica_cad.strip.held_shape import LEAST_REPORTED_MM
from elastica_cad.strip.summary import accuracy_row
from elastica_cad.strip.tab_seats import lean_against, rest_in_seats

pytestmark = pytest.mark.core

PLY = Sheet.named("birch-plywood-0.8")
CARD = Sheet.named("card-200gsm")
MDF = Sheet.named("mdf-3")
NO_ERRORS = MakingTolerance(0.0, 0.0, 0.0, 0.0, 0.0)
ARCH = PlaneCurve.spline([(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)])


@pytest.fixture(scope="module")
def rod():
    return optimal_rod(ARCH, samples=201)


@pytest.fixture(scope="module")
def strip(rod):
    return Strip(rod, PLY, max_width=30.0, ends=(Tab(10), Tab(10)), label="A")


def test_how_far_a_tab_turns_in_a_pocket():
    """h / cos + L tan = h + 2 c where both corners touch."""
    low, high = TabSeat.pocket(10.0, 0.8, 0.15).turning
    assert low == pytest.approx(-high, abs=1e-12)
    assert 0.8 / np.cos(high) + 10.0 * np.tan(high) == pytest.approx(1.1, abs=2e-3)


def test_a_stiff_tab_rests_on_mouth_and_tip(rod):
    """Its moment turns it until it touches on both sides, twice the play over its length."""
    seat = TabSeat.pocket(10.0, 0.8, 0.15)
    found, (start, end) = rest_in_seats(rod, rod, (seat, seat))
    assert abs(end.turn) == pytest.approx(0.3 / 10, rel=0.02)
    assert abs(end.shift) == pytest.approx(0.15, rel=0.02)
    assert start.turn == pytest.approx(-end.turn, rel=1e-6)
    for pose, way in ((start, -1), (end, 1)):
        gaps = seat.gaps(pose.shift, pose.turn, way)
        assert gaps.min() > -1e-9
        assert np.sum(gaps < 1e-8) == 2
    # both supports push: the strip's moment is carried by two forces of opposite sense, each into its wall
    moment, force = found.moment[-1], -found.force[-1]
    left = np.array([-np.sin(found.angle[-1]), np.cos(found.angle[-1])])
    tip = -moment / 10.0
    mouth = float(force @ left) - tip
    assert tip * mouth < 0


def test_a_soft_tab_bends_between_mouth_and_tip(rod):
    """Held at two places it turns by M l / (3 E I) at the mouth."""
    edges = np.array([(0.0, 0.4001), (10.0, 0.4001)])  # a turned tab is thicker across, h / cos
    seat = TabSeat(edges, edges * (1, -1), 0.8)
    found, (_, end) = rest_in_seats(rod, rod, (None, seat), (np.inf, 2.0))
    assert abs(end.shift) < 2e-4
    assert end.turn == pytest.approx(-found.moment[-1] * 10.0 / (3 * 2.0), rel=0.01)


def test_no_neighbouring_pose_has_less_energy(rod):
    """The holders' forces do no work on any move that the walls allow."""
    seat = TabSeat.pocket(12.0, 0.8, 0.1)
    found, (_, end) = rest_in_seats(rod, rod, (None, seat))
    left = np.array([-np.sin(rod.angle[-1]), np.cos(rod.angle[-1])])
    gradient = np.array([-found.force[-1] @ left, found.moment[-1]])
    rng = np.random.default_rng(1)
    tried = 0
    for step in rng.normal(size=(400, 2)) * (1e-4, 1e-5):
        if seat.gaps(end.shift + step[0], end.turn + step[1], 1).min() > -1e-12:
            tried += 1
            assert gradient @ step > -1e-12
    assert tried > 20


def test_a_tab_wedged_between_one_edge_and_two_overlaps_none():
    """It turns far until its thickness wedges, which its walls bear by forces far above the strip's own."""
    bow = bend(Rod.straight(400.0, samples=41), end=(180.0, 0.0), angles=(0.4, -1.2), side=1)
    seat = TabSeat([(25.0, 0.7)], [(0.4, -0.7), (25.0, -0.74)], 1.38)
    found, (_, end) = rest_in_seats(bow, bow, (None, seat))
    assert abs(end.turn) > 0.2
    gaps = seat.gaps(end.shift, end.turn, 1)
    assert gaps.min() > -1e-7 * bow.length
    # pushes of the two edges that it lies against, and nothing else, balance force and moment
    left = np.array([-np.sin(bow.angle[-1]), np.cos(bow.angle[-1])])
    gradient = np.array([-found.force[-1] @ left, found.moment[-1]])
    touching = seat.slopes(end.shift, end.turn, 1)[gaps < 1e-6 * bow.length]
    assert len(touching) == 2
    assert np.linalg.solve(touching.T, gradient).min() > 0


@pytest.mark.parametrize(
    ("chord", "angles", "left", "right"),
    [
        (163, (0.2, 0.4), [(18, 0.55)], [(2, -0.94), (13, -1.28)]),
        (119, (0.8, 0.4), [(13, 0.98), (10, 1.05)], [(4, -1.29), (8, -0.84)]),
        (101, (1.1, 0.3), [(16, 0.97), (14, 0.61)], [(5, -1.27)]),
        (176, (0.5, 0.5), [(9, 0.93)], [(5, -0.58), (7, -0.73)]),
    ],
)
def test_a_wave_whose_tab_turns_about_single_edges_comes_to_rest(chord, angles, left, right):
    """Its steps had gone to and fro between two contacts, as the edges' own turning was not reckoned with."""
    wave = bend(Rod.straight(200.0, samples=41), end=(chord, 0.0), angles=angles)
    seat = TabSeat(left, right, 1.0)
    _, (_, end) = rest_in_seats(wave, wave, (None, seat))
    # bent forward again by itself, the strip presses on what its tab lies against and nowhere else
    across = np.array([-np.sin(angles[1]), np.cos(angles[1])])
    place = np.array([chord, 0.0]) + end.shift * across
    found = bend(wave, end=place, angles=(angles[0], angles[1] + end.turn))
    gradient = np.array([-found.force[-1] @ across, found.moment[-1]])
    gaps = seat.gaps(end.shift, end.turn, 1)
    assert gaps.min() > -1e-7 * wave.length
    touching = seat.slopes(end.shift, end.turn, 1)[gaps < 1e-5]
    pushes, rest = nnls(touching.T, gradient)
    assert rest < 1e-3 * np.abs(found.moment).max() / wave.length
    assert pushes.max() > 0


def test_a_tab_that_its_holder_has_no_room_for_is_named_by_how_much(rod):
    """Three slots of 0.9 mm for a tab of 0.8, that in the middle offset by 0.2: stiff, it lacks 0.1 mm."""
    seat = TabSeat(
        [(0, 0.45), (10, 0.25), (20, 0.45)], [(0, -0.45), (10, -0.65), (20, -0.45)], 0.8, "three slots"
    )
    words = r"^the tab at the end does not fit into .*slots: .* ([\d.]+) mm\. Increase the clearance$"
    with pytest.raises(NotConvergedError, match=words) as refused:
        rest_in_seats(rod, rod, (None, seat))
    assert float(re.match(words, str(refused.value))[1]) == pytest.approx(0.1, abs=0.002)
    _, (_, end) = rest_in_seats(rod, rod, (None, seat), (np.inf, 0.3))  # a soft one bends into them
    assert abs(end.shift) < 0.2


@pytest.mark.campaign
def test_play_moves_the_shape_and_a_leaning_pocket_makes_up_for_it(strip):
    length = strip.rod.length
    blocks = [EndFixture.of(strip, end) for end in ("start", "end")]
    straight = [replace(block, lean=(0.0, 0.0)) for block in blocks]
    free = strip.held(*(block.seat for block in straight))
    assert 1e-3 < free.deviation / length < 6e-3
    assert set(free.parts) >= {"loose tabs"}
    seats = [block.seat for block in blocks]
    leaned = strip.held(*seats)
    # the tab bends between the walls that it is pressed against: pockets for a stiff one left 2.9e-3
    assert leaned.deviation < 1e-4 * length


def test_causes_are_listed_each_alone(rod):
    narrow = Strip(rod, PLY, max_width=30.0, ends=(Tab(10, width=10), Tab(10)))
    held = narrow.held()
    assert set(held.parts) == {"narrow tabs", "anticlastic bending"}
    assert held.parts["narrow tabs"] > 20 * held.parts["anticlastic bending"]
    assert narrow.held_deviation == held.deviation
    none = replace(PLY, poisson_ratio=0.0)
    plain = Strip(rod, none, max_width=30.0).held()
    assert not plain.parts
    assert plain.deviation < 2e-5 * rod.length
    style = Perforated(width=40, columns=2, rows=3)
    leaning = Strip(rod, none, max_width=30.0, style=style).held()
    assert leaning.parts["leaning ligaments"] > 1e-5 * rod.length
    layout = Strip(rod, none, max_width=30.0, style=style).layout
    share = stiffness_factors(rod, layout, (), (None, None))["leaning ligaments"]
    assert 0.98 < share.min() < share.max() < 1


@pytest.fixture(scope="module")
def lamp_strip():
    """A strip of a lamp and its seats in two pairs of rings."""
    profile = meridian_through([(60, 0), (85, 40), (100, 90), (85, 140), (60, 180)])
    lamp = revolve(profile, 12, sheet="polypropylene-0.8", rings="mdf-3", gap=10)
    seats = tab_seats(lamp.plates)
    return lamp.placed[0].strip, [seat_of(seats, lamp.placed[0], end) for end in ("start", "end")]


def test_wider_slots_turn_the_tabs_of_a_lamp(lamp_strip):
    """A slot 0.1 mm wider turns both tabs by 1.4 degrees, which moves the strip by 0.3 mm."""
    strip, seats = lamp_strip
    strip = replace(strip, tolerance=MakingTolerance(0.0, 0.0, 0.0, 0.1, 0.0))
    wide = strip.held(*(seat.loosened(0.1 * seat.cut) for seat in seats))
    assert np.degrees([wide.start.turn, wide.end.turn]) == pytest.approx([-1.4, 1.4], abs=0.05)
    made = strip.as_made.loaded
    angles = [
        float(a) + pose.turn for a, pose in zip(made.angle[[0, -1]], (wide.start, wide.end), strict=True)
    ]
    turned = bend(made, angles=tuple(angles))
    assert float(np.hypot(*(turned.position - made.position).T).max()) == pytest.approx(0.3, abs=0.02)
    result = strip.held(*seats)
    # the slots also let the ends shift by 0.04 mm
    assert result.sheet["wider slots"] == pytest.approx(0.34, abs=0.02)
    assert result.sheet["thinner tabs"] == 0.0
    (slots,) = (part for part in result.contributions if part.cause == "wider slots")
    assert (slots.mm, slots.key) == (result.sheet["wider slots"], "tolerance.kerf")
    assert "wider slots" not in strip.held().sheet
    assert replace(strip, tolerance=NO_ERRORS).held(*seats).sheet_adds == 0.0


@pytest.mark.parametrize(("kerf", "thinner"), [(0.05, 0.0), (0.0, 0.02), (0.1, 0.03)])
def test_errors_of_slots_are_as_large_as_in_slots_of_that_width(lamp_strip, kerf, thinner):
    strip, seats = lamp_strip
    strip = replace(strip, tolerance=MakingTolerance(thinner, 0.0, 0.0, kerf, 0.0))
    loose = [seat.loosened(kerf * seat.cut + thinner * seat.thickness) for seat in seats]
    held, wide = strip.held(*seats), strip.held(*loose)
    found = float(np.hypot(*(wide.rod.position - held.rod.position).T).max())
    assert held.sheet["wider slots"] + held.sheet["thinner tabs"] == pytest.approx(found, rel=1e-6)


@pytest.mark.parametrize(("gap", "key"), [(None, "gap"), (10, "clearance")])
def test_loose_tabs_are_named_with_their_key_and_their_effect(gap, key):
    """By the strip bent between ends that are turned as its tabs turn."""
    bow = optimal_rod(PlaneCurve.ellipse((0, 0), (75.0, 60.0), 0.0, -0.5, np.pi + 0.5), samples=201)
    strip = Strip(bow, PLY, max_width=30.0, ends=(Tab(30), Tab(30)), label="A", tolerance=NO_ERRORS)
    placed = inclined(strip)
    plates = [base_plate(placed, MDF)] if gap is None else plate_pair(placed, MDF, gap=gap)
    (held,) = held_shapes(placed, plates)
    (loose,) = (
        part for part in held.contributions if part.cause.startswith("tabs that turn in the slot of base")
    )
    assert loose.key == key
    made, ends = strip.as_made.loaded, []
    for k, pose in ((0, held.start), (-1, held.end)):
        left = np.array([-np.sin(made.angle[k]), np.cos(made.angle[k])])
        ends.append((made.position[k] + pose.shift * left, float(made.angle[k]) + pose.turn))
    (start, first), (end, last) = ends
    bent = bend(made, start=start, end=end, angles=(first, last))
    found = float(np.hypot(*(bent.position - made.position).T).max())
    assert loose.mm == held.parts["loose tabs"] == pytest.approx(found, rel=0.02, abs=2e-3)
    row = accuracy_row(held)
    if gap is None:
        assert held.contributions[0] is loose
        assert f"Largest contribution: {loose.sentence}" in row.text
        assert row.text.endswith("due to tabs that turn in the slot of base (gap)")


def inclined(strip):
    """The strip standing on the ground, its tabs at the angle of its curve."""
    return [Placed(strip, (0, 0, -strip.rod.position[0, 1]), (1, 0, 0), (0, 0, 1))]


@pytest.mark.campaign
def test_an_inclined_tab_rocks_in_one_plate_and_not_in_two():
    """Ends that lean inward: what the strip does to its tabs turns them upright, where a slot is widest."""
    bow = optimal_rod(PlaneCurve.ellipse((0, 0), (75.0, 60.0), 0.0, -0.5, np.pi + 0.5), samples=201)
    strip = Strip(bow, PLY, max_width=30.0, ends=(Tab(30), Tab(30)), label="A")
    placed = inclined(strip)
    single = base_plate(placed, MDF)
    (message,) = rocking_tabs(placed, [single])
    (rocked,) = held_shapes(placed, [single])
    # both ends are alike
    assert re.match(
        r"A \(and 1 more\): in the slot of base, the tab at the (start|end) of the strip can tip by ", message
    )
    upright, flatter = map(
        int, re.search(r"tip by (\d+) degrees towards .* (\d+) degrees in the opposite", message).groups()
    )
    assert upright > 10 > flatter
    assert f"the strip then deviates by up to {rocked.deviation:.2g} mm" in message
    assert "degrees" in holder_plays(placed, [single])[0]
    assert rocked.deviation > 5e-3 * bow.length
    pair = plate_pair(placed, MDF, gap=10)
    assert [plate.name for plate in pair] == ["base", "base-lower"]
    assert not rocking_tabs(placed, pair)
    (held,) = held_shapes(placed, pair)
    assert held.deviation < 5e-4 * bow.length
    assert "two plates (gap = 20) and tabs " in message
    long = float(message.split("plates (gap = 20) and tabs ")[1].split(" mm")[0])
    longer = inclined(replace(strip, ends=(Tab(long), Tab(long))))
    assert not rocking_tabs(longer, plate_pair(longer, MDF, gap=20))
    (seat,) = {seat.name for seat in tab_seats(pair).values()}
    assert seat == "slot of base and base-lower"


@pytest.mark.parametrize(
    ("axes", "sheet", "length"), [((50, 90), CARD, 30), ((300, 240), Sheet.named("hdf-1.5"), 40)]
)
def test_tabs_bend_between_two_plates_where_straight_ones_would_run_into_them(axes, sheet, length):
    """As drawn straight, a tab runs into the plates; loaded it bends, and its mouth is where it was designed.

    The tab is a beam of Hermite elements here, that two edges push; the strip's end load is known.
    """
    bow = optimal_rod(PlaneCurve.ellipse((0, 0), axes, 0.0, -0.5, np.pi + 0.5), samples=201)
    strip = Strip(bow, sheet, max_width=30.0, ends=(Tab(length), Tab(length)), label="A")
    placed = inclined(strip)
    (seat,) = {
        key: seat
        for key, seat in tab_seats(plate_pair(placed, MDF, gap=10)).items()
        if key == _key_of_end(placed[0])
    }.values()
    half, design = sheet.thickness / 2, strip.as_made.loaded
    straight = -float(seat.gaps(0.0, 0.0, 1).min())
    assert straight > 0.3
    walls = np.concatenate([seat.left, seat.right])
    x = np.unique(np.round([0.0, *walls[walls[:, 0] > 0, 0]], 9))  # a slot may begin beside the strip
    stiffness = np.zeros((2 * x.size, 2 * x.size))
    for i, h in enumerate(np.diff(x)):
        element = np.array(
            [[12, 6 * h, -12, 6 * h], [6 * h, 4 * h * h, -6 * h, 2 * h * h], [-12, -6 * h, 12, -6 * h],
             [6 * h, 2 * h * h, -6 * h, 4 * h * h]]
        ) / h**3  # fmt: skip
        stiffness[2 * i : 2 * i + 4, 2 * i : 2 * i + 4] += strip.as_made.tab_ratios(design)[1] * element
    # the far edge of the first plate on the left pushes right, the near edge of the second one pushes left
    first = seat.left[seat.left[:, 0] < x[-1] / 2][-1]
    second = seat.right[seat.right[:, 0] > x[-1] / 2][0]
    touched = [2 * int(np.abs(x - place[0]).argmin()) for place in (first, second)]
    load = np.zeros(2 * x.size)
    left = np.array([-np.sin(design.angle[-1]), np.cos(design.angle[-1])])
    load[:2] = design.force[-1] @ left, -design.moment[-1]
    held = [first[1] - half, second[1] + half]
    free = np.setdiff1d(np.arange(2 * x.size), touched)
    q = np.zeros(2 * x.size)
    q[touched] = held
    q[free] = np.linalg.solve(
        stiffness[np.ix_(free, free)], load[free] - stiffness[np.ix_(free, touched)] @ held
    )
    pushes = (stiffness @ q - load)[touched]
    assert pushes[0] < 0 < pushes[1]
    assert abs(q[0]) < 0.005 * straight
    assert abs(q[1]) < 0.005 * np.abs(q[1::2]).max()
    sides = ((seat.left, 1.0), (seat.right, -1.0))
    room = [
        s * (place[1] - q[2 * int(np.abs(x - place[0]).argmin())]) - half
        for side, s in sides
        for place in side
    ]
    assert min(room) > -0.005 * straight


def _key_of_end(one):
    return PlacedTab.of(one.strip, "end", one.frame).key


def test_feet_stand_on_the_plate_and_lie_along_the_tab():
    bow = optimal_rod(PlaneCurve.ellipse((0, 0), (75.0, 60.0), 0.0, -0.5, np.pi + 0.5), samples=201)
    strip = Strip(bow, PLY, max_width=30.0, ends=(Tab(15), Tab(15)), label="A")
    placed = inclined(strip)
    plate, *feet = add_feet([base_plate(placed, MDF)], 8.0)
    assert [foot.name for foot in feet] == ["foot-A-1a", "foot-A-1b", "foot-A-2a", "foot-A-2b"]
    assert plate.glued
    assert not tab_seats([plate])
    assert not rocking_tabs(placed, [plate])
    for foot, slot in zip(feet, np.repeat(plate.slots, 2), strict=True):
        corners = foot.frame.point(foot.outline.points(1e-3))
        heights, off = plate.frame.local(corners)[:, 2], slot.tab.frame.local(corners)[:, 2]
        assert heights.max() == pytest.approx(-3.0)  # the plate's back
        assert np.sum(heights > -3.0 - 1e-6) >= 2
        assert np.sum(np.abs(np.abs(off) - 0.4) < 1e-6) >= 2  # the tab's face
        assert np.abs(off).min() > 0.4 - 1e-6
        assert np.ptp(corners @ slot.tab.frame.y_axis) < 1e-9
    with pytest.raises(InputError, match="too short to glue feet to: make it"):
        add_feet([base_plate(inclined(replace(strip, ends=(Tab(6), Tab(6)))), MDF)], 8.0)


def test_feet_of_copies_are_equal_and_others_of_their_name_have_a_number():
    bow = optimal_rod(PlaneCurve.ellipse((0, 0), (75.0, 60.0), 0.0, -0.5, np.pi + 0.5), samples=201)
    strip = Strip(bow, PLY, max_width=30.0, ends=(Tab(15), Tab(15)), label="A")
    longer = replace(strip, ends=(Tab(10), Tab(15)))
    height = -bow.position[0, 1]
    placed = [
        Placed(one, (0, 40 * i, height), (1, 0, 0), (0, 0, 1)) for i, one in enumerate((strip, strip, longer))
    ]
    _, *feet = add_feet([base_plate(placed, MDF)], 8.0)
    names = [foot.name for foot in feet]
    assert names[:4] == names[4:8] == ["foot-A-1a", "foot-A-1b", "foot-A-2a", "foot-A-2b"]
    assert names[8:] == ["foot-A-1a-2", "foot-A-1b-2", "foot-A-2a", "foot-A-2b"]
    assert feet[8].label.text == "foot-A-1a-2"


def test_slots_of_two_plates_are_offset_by_the_gap(rod):
    strip = Strip(rod, PLY, max_width=30.0, ends=(Tab(30), Tab(30)), label="A")
    placed = inclined(strip)
    upper, lower = plate_pair(placed, MDF, gap=12)
    for first, second, angle in zip(upper.slots, lower.slots, rod.angle[[0, -1]], strict=True):
        along = (second.corners.mean(axis=0) - first.corners.mean(axis=0))[0]
        # slots lean against their load by less than a millimetre
        assert along == pytest.approx(-15.0 / np.tan(angle), abs=1.0)


@pytest.mark.parametrize("play", [0.1, 0.3, 0.5, 0.65])
@pytest.mark.parametrize("stiffness", [0.3, 0.9, 2.0])
def test_a_seat_that_leans_leaves_the_loaded_tab_as_designed(play, stiffness):
    bow = optimal_rod(PlaneCurve.ellipse((0, 0), (75.0, 60.0), 0.0, -0.5, np.pi + 0.5), samples=201)
    seat = TabSeat.pocket(length=13, thickness=0.25, clearance=play)
    for index in (0, 1):
        lean = lean_against(bow, index, seat, stiffness)
        left = lean_against(bow, index, seat.moved(lean.shift, lean.turn), stiffness)
        assert abs(left.shift) < 1e-4
        assert abs(left.turn) < 1e-5


def test_a_tab_too_short_for_the_lower_plate_is_refused_with_its_length(strip):
    placed = inclined(strip)
    with pytest.raises(InputError, match=r"make the tab ([\d.]+) mm long") as refused:
        plate_pair(placed, MDF, gap=10)
    needed = float(str(refused.value).split("make the tab ")[1].split(" ")[0])
    longer = replace(strip, ends=(Tab(needed), Tab(needed)))
    assert len(plate_pair(inclined(longer), MDF, gap=10)) == 2


@pytest.mark.campaign
def test_two_rings_hold_a_surface_of_revolution_at_its_angle():
    profile = meridian_through([(70, 0), (85, 16), (125, 55), (90, 115), (75, 140)])
    single = revolve(profile, 16, sheet="card-200gsm", rings="hdf-1.5")
    assert len(rocking_tabs(single.placed, single.plates)) == 2
    pair = revolve(profile, 16, sheet="card-200gsm", rings="hdf-1.5", gap=10)
    assert [ring.name for ring in pair.plates] == [
        "ring-bottom", "ring-bottom-outer", "ring-top", "ring-top-outer",
    ]  # fmt: skip
    assert not rocking_tabs(pair.placed, pair.plates)
    assert pair.held()[0].deviation < 0.25 * single.held()[0].deviation
    assert pair.held()[0].deviation < 1e-3 * profile.rod.length
    with pytest.raises(InputError, match=r"make the tab ([\d.]+) mm long"):
        revolve(
            profile,
            16,
            sheet="card-200gsm",
            rings="hdf-1.5",
            gap=10,
            ends=(Tab(10, width=18), Tab(10, width=18)),
        )


@pytest.mark.parametrize("kind", ["base", "pair", "feet", "frame", "fixtures", "rings", "cap", "ends"])
def test_holders_with_play_say_what_play_they_leave(kind):
    bow = optimal_rod(PlaneCurve.ellipse((0, 0), (75.0, 60.0), 0.0, -0.5, np.pi + 0.5), samples=201)
    strip = Strip(bow, PLY, max_width=30.0, ends=(Tab(40), Tab(40)), label="A")
    placed = inclined(strip)
    if kind in ("rings", "cap"):
        points = [(70, 0), (85, 16), (125, 55), (90, 115), (75, 140)]
        profile = (
            meridian_through(points)
            if kind == "rings"
            else meridian(0.0, (1 / 300, 0), (300, 0), np.pi / 2, 900, ring=25)
        )
        turned = revolve(profile, 12, sheet="card-200gsm", rings="hdf-1.5" if kind == "rings" else "mdf-3")
        placed, holders = turned.placed, turned.plates
    else:
        holders = {
            "base": lambda: [base_plate(placed, MDF)],
            "pair": lambda: plate_pair(placed, MDF, gap=10),
            "feet": lambda: add_feet([base_plate(placed, MDF)], 8.0),
            "frame": lambda: slotted_frame(placed, MDF).rails,
            "fixtures": lambda: [EndFixture.of(strip, end, placed[0].frame) for end in ("start", "end")],
            "ends": lambda: end_plates(placed, MDF, together=True),
        }[kind]()
    message = "; ".join(holder_plays(placed, holders))
    names = {
        "base": ["base"],
        "frame": ["rail-start", "rail-end"],
        "rings": ["ring-bottom", "ring-top"],
        "cap": ["ring-bottom"],
        "ends": ["ring"],
    }
    assert re.findall(r"In the slot of (\S+), a tab can .*?degrees", message) == names.get(kind, [])
    assert bool(message) == (kind in names)
    assert "shift by 0 mm" not in message


def leaning_row():
    """Arches side by side whose tabs lean to the plane that holds them."""
    bows = [
        optimal_rod(PlaneCurve.ellipse((0, 0), (90.0 - 6 * i, 60.0), 0.0, -0.5, np.pi + 0.5), samples=201)
        for i in range(3)
    ]
    strips = [
        Strip(bow, PLY, max_width=16.0, ends=(Tab(30), Tab(30)), label=f"H{i}") for i, bow in enumerate(bows)
    ]
    return [Placed(strip, (0, 45.0 * i, 0), (1, 0, 0), (0, 0, 1)) for i, strip in enumerate(strips)]


@pytest.mark.campaign
def test_plates_of_ends_come_in_pairs_too():
    placed = leaning_row()
    single, pair = (end_plates(placed, MDF, together=True, gap=gap) for gap in (None, 10.0))
    assert rocking_tabs(placed, single)
    assert [plate.name for plate in pair] == ["ring", "ring-outer"]
    assert not rocking_tabs(placed, pair)
    assert max(shape.deviation for shape in held_shapes(placed, pair)) < 5e-4 * placed[0].strip.rod.length


def test_a_frame_of_double_rails_whose_ribs_keep_the_gap():
    placed = leaning_row()
    frame = slotted_frame(placed, MDF, ribs=3, gap=10.0)
    assert [rail.name for rail in frame.rails] == [
        "rail-start", "rail-end", "rail-start-outer", "rail-end-outer",
    ]  # fmt: skip
    for first, second in zip(frame.rails[:2], frame.rails[2:], strict=True):
        assert first.frame.local(second.frame.origin)[2] == pytest.approx(-13.0)
        for rib in frame.ribs:
            corners = first.frame.local(rib.frame.point(rib.outline.points(1e-3)))
            near = corners[np.hypot(*(corners - first.frame.local(_middle(first, rib))).T[:2]) < 13.0]
            heights = set(np.round(near[:, 2], 6).tolist())
            # through the first rail, a step at its back, through the second, a shoulder behind that
            assert {0.0, -3.0, -16.0} <= heights
            steps = near[np.abs(near[:, 2] + 3.0) < 1e-6]
            slot = next(slot for slot in first.slots if slot.name == rib.name)
            assert slot.size[0] < np.ptp(steps @ (steps[-1] - steps[0])) / np.linalg.norm(
                steps[-1] - steps[0]
            )
    assert not rocking_tabs(placed, [frame])
    assert max(shape.deviation for shape in held_shapes(placed, [frame])) < 1e-3 * placed[0].strip.rod.length


def _middle(rail, rib):
    """The middle of a rib's slot in a rail, in space."""
    slot = next(slot for slot in rail.slots if slot.name == rib.name)
    return rail.frame.point([*slot.corners.mean(axis=0), 0.0])


TABS = (Tab(10, width=10), Tab(10, width=10))
SLOTS = (Slot(60.0, width=1.0), Slot(120.0, width=1.0, side="lower"))


@pytest.mark.parametrize(
    "options", [{"ends": TABS}, {"slots": SLOTS}, {}], ids=["narrow tabs", "slots", "anticlastic"]
)
def test_widths_that_make_up_bring_the_strip_back(rod, options):
    strip = Strip(rod, replace(PLY, poisson_ratio=0.3), max_width=30.0, **options)
    better = compensate_widths(strip)
    assert strip.held_deviation > 1e-4 * rod.length
    assert better.held_deviation < 0.2 * strip.held_deviation
    assert better.held().parts == pytest.approx(
        strip.held().parts
    )  # causes, not what the correction leaves of them
    causes = [part.cause for part in better.held().contributions]
    assert "effects that the widths do not compensate" in causes
    assert better.width.extremes[1] == pytest.approx(30.0, abs=1e-4)
    assert better.rod is strip.rod


def test_only_causes_that_the_correction_changes_are_named(rod):
    """Not tabs that lack next to nothing of the width, nor holders, for which no width is corrected."""
    strip = Strip(rod, replace(PLY, poisson_ratio=0.0), max_width=30.0, slots=SLOTS)
    narrower = replace(strip, ends=tuple(Tab(10, width=width - 0.2) for width in strip.end_widths))
    held = compensate_widths(narrower).held(start=TabSeat.pocket(10.0, 0.8, 0.1))
    assert 0 < held.parts["narrow tabs"] < LEAST_REPORTED_MM < held.parts["loose tabs"]
    assert held.made_up_for == ("slots",)


def test_a_correction_that_changes_nothing_is_left_out(rod):
    strip = Strip(rod, replace(CARD, poisson_ratio=0.05), max_width=30.0)
    assert 0 < strip.held_deviation < LEAST_REPORTED_MM
    better = compensate_widths(strip)
    assert better is strip
    assert better.held().made_up_for == ()


def test_a_heavy_strip_carries_the_weight_of_its_corrected_widths():
    """Checked by bending anew what is cut: its own E I and its own newtons, not those of the design."""
    arch = PlaneCurve.spline([(0, 0), (50, 60), (100, 10), (150, -40), (200, 20)])
    heavy = optimal_rod(arch, CARD.gravity(), samples=201)
    better = compensate_widths(
        Strip(heavy, CARD, max_width=60.0, ends=(Tab(10, width=30), Tab(10, width=30)))
    )
    made = better.as_made.rest()
    h, nu = CARD.thickness, CARD.poisson_ratio
    width = better.width(made.s)
    EI = CARD.youngs_modulus * h**3 / 12 * width
    EI *= anticlastic_factor(width, heavy.curvature, thickness=h, poisson_ratio=nu)
    inner = slice(60, -60)  # away from the corners beside the tabs
    assert made.bending_stiffness * made.stiffness[inner] == pytest.approx(EI[inner], rel=2e-3)
    newtons = CARD.density * 1e-9 * 9.80665 * h * width
    load = made.bending_stiffness * -made.nodal_load[:, 1] / made.node_lengths
    assert load[inner] == pytest.approx(newtons[inner], rel=2e-3)
    assert better.held_deviation < 5e-4 * heavy.length


LIBRARY = sorted(map(Sheet.named, sheet_names()), key=lambda sheet: -sheet.thickness)
ALIKE = {sheet.poisson_ratio: sheet for sheet in LIBRARY}
"""The thinnest sheet of the library for each of their Poisson numbers."""


@pytest.mark.parametrize("heavy", [False, True], ids=["light", "heavy"])
@pytest.mark.parametrize("nu", sorted(ALIKE))
def test_stiffening_across_is_made_up_for_wherever_the_poisson_number_is_known(nu, heavy):
    hoop = PlaneCurve.ellipse((0, 0), (50, 120), 0, -0.4, np.pi + 0.4)
    strip = Strip(optimal_rod(hoop, ALIKE[nu].gravity() if heavy else None), ALIKE[nu], max_width=30.0)
    better = compensate_widths(strip)
    assert nu > 0
    assert strip.held().parts["anticlastic bending"] > 5e-5 * strip.rod.length
    assert better.held_deviation < 0.2 * strip.held_deviation


def test_widths_change_more_sharply_where_smooth_ones_leave_too_much():
    """Slots on either side of an inflection. What is left are kinks, which smooth widths can't take back."""
    curve = PlaneCurve.spline([(0, 0), (50, 60), (100, 10), (150, -40), (200, 20)])
    scaled = curve.transformed(np.diag([1.0, 1.0, curve.length / 300.0]))
    slots = (Slot(105.0, width=1.0), Slot(210.0, width=1.0, side="lower"))
    strip = Strip(optimal_rod(scaled), PLY, max_width=30.0, slots=slots)
    assert strip.held_deviation > 4e-3 * 300
    assert compensate_widths(strip).held_deviation < 1e-3 * 300


def test_a_strip_that_strays_little_is_left_alone(rod):
    strip = Strip(rod, replace(PLY, poisson_ratio=0.0), max_width=30.0)
    assert compensate_widths(strip) is strip
