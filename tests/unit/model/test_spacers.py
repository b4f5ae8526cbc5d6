"""Spacers between two plates, compared with shapely: positions, fit in their slots, and clearance."""

import re
from itertools import combinations

import numpy as np
import pytest
from shapely.geometry import MultiPoint, Polygon

import elastica_cad as ec
from elastica_cad import InputError, Tab
from elastica_cad.design import read_design
from elastica_cad.form_finding import meridian_through
from elastica_cad.kit.kit_contents import kit_contents
from elastica_cad.model import PlateHoles, add_spacers, plate_pair, revolve
from elastica_cad.model.plate_pairs import end_plates

GAP, MDF = 12.0, 3.0
BRIDGE = 3.0  # least material between cuts of MDF, mm
LAMP = [(60, 0), (85, 40), (100, 90), (85, 140), (60, 180)]


@pytest.fixture(scope="module")
def arches():
    """Four leaning arches, whose tabs are inclined in the plates."""
    curve = ec.PlaneCurve.spline([(0, 0), (20, 70), (150, 100), (200, 0)], degree=3)
    arch = ec.make_strip(curve, "birch-plywood-0.8", max_width=20, ends=(Tab(26), Tab(26)))
    return ec.Model([ec.Placed(arch, (0, 45 * k, 0), (1, 0, 0), (0, 0, 1)) for k in range(4)]).placed


@pytest.fixture(scope="module")
def lamp():
    profile = meridian_through(LAMP)
    return revolve(profile, 12, sheet="polypropylene-0.8", rings="mdf-3", gap=GAP, spacers=3)


def assert_spaced(first, second, spacers, placed):
    """The spacers fit both plates and nothing else is where they are."""
    plates, z = (first, second), first.frame.z_axis
    bodies = []
    for spacer in spacers:
        assert abs(spacer.frame.y_axis @ z) == pytest.approx(1)
        x, y = spacer.outline.points(0.01).T
        # the ends of the body are as high as the gap, and the tongues end at the outer faces
        assert np.ptp(y[np.isclose(x, x.max())]) == pytest.approx(GAP)
        assert np.ptp(y) == pytest.approx(GAP + 2 * MDF)
        tongue = np.ptp(x[np.isclose(y, y.max())])
        for plate in plates:
            heights = plate.frame.local(spacer.frame.point(np.column_stack([x, y, 0 * x])))[:, 2]
            near = heights[np.abs(heights + MDF / 2) < MDF]
            assert {*near.round(6)} <= {0.0, -MDF}
            cross = [spacer.frame.point((side * tongue / 2, 0, up * MDF / 2)) for side, up in SIDES]
            foot = Polygon(plate.frame.local(np.array(cross))[:, :2])
            slots = [Polygon(slot.corners) for slot in plate.slots if slot.tab is None]
            (slot,) = [slot for slot in slots if slot.intersects(foot)]
            assert slot.contains(foot)
            assert slot.area < 1.35 * foot.area
            others = [Polygon(each.corners) for each in plate.slots] + [
                Polygon(loop.points(0.01)) for loop in (*plate.holes, *filter(None, [plate.opening]))
            ]
            assert min(slot.distance(other) for other in others if not other.equals(slot)) >= BRIDGE - 0.02
            edge = Polygon(plate.outline.points(0.01))
            assert edge.contains(slot)
            assert edge.exterior.distance(slot) >= BRIDGE - 0.02
        corners = [spacer.frame.point((side * x.max(), 0, up * MDF / 2)) for side, up in SIDES]
        bodies.append(Polygon(first.frame.local(np.array(corners))[:, :2]))
    assert min(a.distance(b) for a, b in combinations(bodies, 2)) > BRIDGE
    tabs = {slot.tab.key: slot.tab for slot in first.slots if slot.tab is not None}
    for tab in tabs.values():  # the straight tab between the plates, seen along z
        along, across = np.meshgrid(np.linspace(0, tab.length, 200), tab.width / 2 * np.array([-1, 1]))
        body = tab.frame.point(np.column_stack([along.ravel(), across.ravel(), 0 * along.ravel()]))
        points = first.frame.local(body)
        inside = points[(points[:, 2] < -MDF) & (points[:, 2] > -MDF - GAP)]
        shadow = MultiPoint(inside[:, :2]).convex_hull
        assert min(body.distance(shadow) for body in bodies) > 1 + tab.thickness / 4
    for member in placed:
        points = first.frame.local(member.frame.point(member.strip.rod.position))
        assert not ((points[:, 2] < -MDF) & (points[:, 2] > -MDF - GAP)).any()


SIDES = ((-1, -1), (1, -1), (1, 1), (-1, 1))


@pytest.mark.parametrize("count", [2, 3, 5])
def test_spacers_fit_between_the_plates_of_a_base(count, arches):
    plates, spacers = add_spacers(arches, plate_pair(arches, "mdf-3", gap=GAP), count)
    assert len(spacers) == count
    assert_spaced(*plates, spacers, arches)
    assert {spacer.name for spacer in spacers} == {"base-spacer"}


def assert_rings_with_spacers(rings, spacers, placed):
    assert len(spacers) == 6
    for k in (0, 2):
        mine = [spacer for spacer in spacers if spacer.name == f"{rings[k].name}-spacer"]
        assert_spaced(*rings[k : k + 2], mine, placed)
        feet = MultiPoint([spacer.frame.origin[:2] for spacer in mine])
        assert feet.convex_hull.contains(MultiPoint([(0, 0)]))


def test_the_rings_of_a_lamp_are_as_wide_as_their_spacers_need(lamp):
    """The spacers are inside the slots, so only the openings are smaller than without spacers."""
    rings, spacers = lamp.plates[:4], lamp.plates[4:]
    assert_rings_with_spacers(rings, spacers, lamp.placed)
    plain = revolve(meridian_through(LAMP), 12, sheet="polypropylene-0.8", rings="mdf-3", gap=GAP).plates
    for ring, wide in zip(plain, rings, strict=True):
        assert wide.radii[1] == pytest.approx(ring.radii[1])
        slots = np.concatenate([slot.corners for slot in wide.slots if slot.tab is None])
        # half the length of a slot makes its middle nearer to the axis than its corners
        assert wide.radii[0] == pytest.approx(np.hypot(*slots.T).min() - BRIDGE, abs=1.5)
        assert wide.radii[0] > 0.7 * ring.radii[0]
        assert [text.text for text in wide.drawing.texts] == [ring.name]


@pytest.mark.parametrize("border", [8, 34])
def test_end_plates_of_any_border_are_rings_with_spacers(lamp, border):
    ends = end_plates(lamp.placed, "mdf-3", gap=GAP, border=border)
    rings, spacers = add_spacers(lamp.placed, ends, 3)
    assert_rings_with_spacers(rings, spacers, lamp.placed)
    assert all(ring.is_round for ring in (*ends, *rings))
    assert all(ring.name in [text.text for text in ring.drawing.texts] for ring in rings)


def test_spacers_are_outside_the_slots_where_the_opening_would_be_lost():
    narrow = meridian_through([(x - 35, y) for x, y in LAMP])
    small = revolve(narrow, 8, **SMALL).plates
    spaced = revolve(narrow, 8, spacers=3, **SMALL).plates
    for ring, wide in zip(small, spaced, strict=False):
        assert ring.radii[0] > 10
        assert wide.radii[0] == pytest.approx(ring.radii[0])
        assert wide.radii[1] > ring.radii[1] + 1


SMALL = {"sheet": "polypropylene-0.8", "rings": "mdf-3", "gap": 6.0}


def test_a_closed_ring_says_so(lamp):
    _, outer, *_ = end_plates(lamp.placed, "mdf-3", gap=GAP, border=44)
    (note,) = outer.warnings
    assert re.match(
        r"ring-bottom-outer has no opening, because .* border of 44 mm leave less than 20 mm free", note
    )


def test_spacers_keep_clear_of_holes(arches):
    pair = end_plates(
        arches, "mdf-3", together=True, gap=GAP, shape="hull", holes=PlateHoles(bulb=40, screws=4)
    )
    plates, spacers = add_spacers(arches, pair, 3)
    assert_spaced(*plates, spacers, arches)


def test_one_sentence_if_there_is_no_room(lamp, arches):
    with pytest.raises(
        InputError, match=r"ring-bottom: there is room for \d+ spacers .* Use fewer spacers\.$"
    ):
        add_spacers(lamp.placed, end_plates(lamp.placed, "mdf-3", gap=GAP), 50)
    with pytest.raises(
        InputError, match=r"base: there is room for \d+ .* fewer spacers, or a border of more"
    ):
        add_spacers(arches[:1], plate_pair(arches[:1], "mdf-3", gap=GAP), 50)


def angles_between(plate):
    """Angles, degrees, between the slots of neighbouring spacers, seen from the middle of the tabs."""
    middles = {
        held: np.array([slot.corners.mean(axis=0) for slot in plate.slots if (slot.tab is None) != held])
        for held in (False, True)
    }
    x, y = (middles[False] - middles[True].mean(axis=0)).T
    angles = np.sort(np.degrees(np.arctan2(y, x)))
    return np.diff([*angles, angles[0] + 360])


@pytest.mark.parametrize(
    ("count", "widest", "holes"),
    [
        (2, 200, {"bulb": 10, "bridge": 14}),
        (3, 140, {"bulb": 10, "bridge": 12}),
        (3, 140, {"bulb": 40, "bridge": 16, "side": "top"}),
        (3, 140, {}),
        (4, 110, {"bulb": 10, "bridge": 8}),
    ],
)
def test_spacers_of_rings_are_around_the_axis_and_keep_the_bridge(count, widest, holes):
    profile = LAMP if count < 4 else [*LAMP[:-1], (48, 180)]  # rings of unequal sizes
    given = PlateHoles(**holes) if holes else None
    options = {"sheet": "polypropylene-0.8", "rings": "mdf-3", "gap": GAP, "holes": given}
    rings = revolve(meridian_through(profile), 12, spacers=count, **options).plates[:4]
    for ring in rings:
        assert angles_between(ring).max() < widest
        windows = [hole for hole in ring.holes if len(hole.segments) > 1]
        assert len(windows) == (2 if given and given.is_in(ring.name) else 0)
        assert ring.opening_radius > 15
        assert ring.warnings == ()


def test_spacers_almost_in_a_line_are_reported_with_a_border_that_spreads_them():
    curve = ec.PlaneCurve.spline([(0, 0), (20, 70), (150, 100), (200, 0)], degree=3)
    arch = ec.make_strip(curve, "birch-plywood-0.8", max_width=20, ends=(Tab(26, width=8),) * 2)
    placed = [ec.Placed(arch, (0, 0, 0), (1, 0, 0), (0, 0, 1))]
    (first, _), _ = add_spacers(placed, plate_pair(placed, "mdf-3", gap=GAP, border=4), 3)
    (advice,) = [re.search(r"almost in a line, .* border of (\d+) mm\.", text) for text in first.warnings]
    pair = plate_pair(placed, "mdf-3", gap=GAP, border=float(advice[1]))
    (wide, _), _ = add_spacers(placed, pair, 3)
    assert wide.warnings == ()
    assert angles_between(wide).max() < 175


def test_spacers_need_two_plates(arches):
    with pytest.raises(InputError, match=r"spacers needs two plates .* Set gap"):
        add_spacers(arches, end_plates(arches, "mdf-3", together=True), 3)


def test_spacers_are_pieces_of_the_kit(tmp_path):
    path = tmp_path / "lamp.toml"
    path.write_text(
        f'name = "lamp"\n[revolution]\nsheet = "polypropylene-0.8"\nstrips = 12\nrings = "mdf-3"\n'
        f"points = {[list(point) for point in LAMP]}\ngap = {GAP}\nspacers = 3\n"
    )
    design = read_design(path, ec.read_curves)
    kit = kit_contents(design.model(), design.kit)
    rows = {row.part: row for row in kit.cut_list.rows}
    assert rows["ring-bottom-spacer"].count == rows["ring-top-spacer"].count == 3
    assert rows["ring-top-spacer"].like == "ring-bottom-spacer"
    assert sum(nest.pieces.count("ring-top-spacer") for nest in kit.nests) == 3
