"""Pairs of plates: the moved slots keep their bridges, and are where the loaded tabs are."""

from dataclasses import replace
from itertools import combinations

import numpy as np
import pytest

import elastica_cad as ec
from elastica_cad import InputError
from elastica_cad.model import plate_pair, revolve, slotted_frame
from elastica_cad.model.plate_pairs import end_plates
from elastica_cad.strip.outline import Tab
from elastica_cad.strip.strip import Placed

LEAST_MM = 2.0
FLAT = [(60, 0), (160, 60), (150, 200), (45, 380)]
STEEP = [(60, 0), (100, 60), (100, 200), (50, 380)]
SPHERE = [(60, 0), (103.9, 43.9), (120, 104), (103.9, 164.1), (60, 208)]


def lamp(curve, width, count=14):
    rib = ec.make_strip(ec.PlaneCurve.spline(curve, degree=3), "birch-plywood-0.8", max_width=18)
    rib = replace(rib, ends=(Tab(30, width=width), Tab(30, width=width)))
    turn = 2 * np.pi * np.arange(count) / count
    return [Placed(rib, (0, 0, 0), (np.cos(t), np.sin(t), 0), (0, 0, 1)) for t in turn]


def to_sides(points, loop):
    """Return the least distance of the sides of a polygon, at points along them, from the sides of another."""
    begin, side = loop, np.roll(loop, -1, axis=0) - loop
    steps = np.linspace(0, 1, 30)[:, None, None]
    points = (points + steps * (np.roll(points, -1, axis=0) - points)).reshape(-1, 2)
    away = points[:, None] - begin
    along = np.clip((away * side).sum(axis=-1) / (side * side).sum(axis=-1), 0, 1)
    return np.linalg.norm(away - along[..., None] * side, axis=-1).min()


def bridges(plate):
    """Return the least distance between slots, from slots to other cuts, and from slots to the edge."""
    slots = [slot.corners for slot in plate.slots]
    others = [path.points(0.1) for path in (plate.outline, plate.opening, *plate.holes) if path is not None]
    pairs = [*combinations(slots, 2), *((slot, other) for slot in slots for other in others)]
    return min(to_sides(p, q) for p, q in pairs)


def holds(make):
    """Return True if the plates can be made with sufficient bridges, or False if they are refused."""
    try:
        plates = make()
    except InputError:
        return False
    assert len(plates) > 1
    assert all(bridges(plate) >= LEAST_MM - 0.1 for plate in plates)
    return True


@pytest.mark.parametrize(
    ("curve", "width", "made"),
    [(FLAT, 12.5, False), (FLAT, 11, False), (FLAT, 10, False), (STEEP, 12.5, True), (STEEP, 10, True)],
)
def test_end_plates_keep_their_bridges(curve, width, made):
    assert holds(lambda: end_plates(lamp(curve, width), "hdf-1.5", gap=12.0, shape="ring")) is made


@pytest.mark.parametrize(("width", "gap", "made"), [(None, 8.0, False), (14.0, 5.0, True), (14.0, 6.0, True)])
def test_rings_of_a_revolution_keep_their_bridges(width, gap, made):
    ends = (Tab(20, width=width), Tab(20, width=width))
    assert holds(lambda: revolve(
        ec.meridian_through(SPHERE), 12, sheet="polypropylene-0.8", rings="polypropylene-0.8", gap=gap, ends=ends,
    ).plates) is made  # fmt: skip


@pytest.mark.parametrize(("curve", "made"), [(FLAT, False), (STEEP, True)])
def test_base_plates_keep_their_bridges(curve, made):
    assert holds(lambda: plate_pair(lamp(curve, 11), "hdf-1.5", gap=12.0, ends=["start"])) is made


@pytest.mark.parametrize(("apart", "made"), [(20, True), (16, True)])
def test_rails_of_frames_keep_their_bridges(apart, made):
    curve = ec.PlaneCurve.spline([(0, 0), (60, 60), (140, 60), (200, 0)], degree=3)
    arch = ec.make_strip(curve, "birch-plywood-0.8", max_width=12)
    arch = replace(arch, ends=(Tab(40), Tab(40)))
    placed = [Placed(arch, (0, apart * k, 0), (1, 0, 0), (0, 0, 1)) for k in range(4)]
    assert holds(lambda: slotted_frame(placed, "hdf-1.5", gap=12.0, tongue=20).rails) is made


def test_warnings_name_the_thin_bridges_of_the_second_plate():
    plates = end_plates(lamp(FLAT, 16), "hdf-1.5", gap=8.0, shape="ring", ignore_limits=True)
    outer = next(plate for plate in plates if plate.name == "ring-bottom-outer")
    assert bridges(outer) < LEAST_MM
    assert any("between the slot" in warning for warning in outer.warnings)


def bent_tab(strip, tab, rings, gap):
    """Return points (r, z) (n, 2), mm, along a loaded tab from its root, and its angles (n,) to the plate.

    The tab is an elastica, integrated from the load at its root. The far edge of the first plate and the near edge
    of the second plate press against it.
    """
    loaded, half = strip.as_made.loaded, strip.sheet.thickness / 2
    ratio, begin = strip.as_made.tab_ratios(loaded)[0], loaded.angle[0]
    s = np.linspace(0, tab.length, 2000)
    angle = np.full(s.size, begin)
    for _ in range(40):
        points = np.cumsum(np.column_stack([-np.cos(angle), -np.sin(angle)]), axis=0) * s[1]
        upper, lower = (points[:, 1] + side * half * np.cos(angle) for side in (1, -1))
        first = s[np.argmax(upper <= -rings.thickness)]
        second = s[np.argmax(lower <= -rings.thickness - gap)]
        moment = (loaded.moment[0] + loaded.force[0][1] * points[:, 0]) / ratio
        after = np.interp(first, s, moment) * np.clip((second - s) / (second - first), 0, 1)
        bend = np.cumsum(np.where(s < first, moment, after)) * s[1]
        angle = (angle + begin - bend) / 2
    return points, angle


@pytest.mark.parametrize(
    ("lean", "gap", "rings", "width"),
    [(60, 6.0, "polypropylene-0.8", 14), (50, 8.0, "hdf-1.5", 16), (30, 12.0, "mdf-3", 30)],
)
def test_slots_are_where_the_bent_tab_is(lean, gap, rings, width):
    """Slots of a sphere, whose tabs lean by `lean` degrees, are as wide as the bent tab and its clearance."""
    turns = np.radians(np.linspace(-lean, lean, 5))
    points = 120 * np.column_stack([np.cos(turns), np.sin(turns) + np.sin(turns[-1])])
    sheet, tab = ec.Sheet.named(rings), Tab(30, width=width)
    ball = revolve(
        ec.meridian_through(points), 12, sheet="polypropylene-0.8", rings=sheet, gap=gap, ends=(tab, tab)
    )
    center, angle = bent_tab(ball.strips[0], tab, sheet, gap)
    across = 0.4 * np.column_stack([-np.sin(angle), np.cos(angle)])
    for ring, top in zip(ball.plates[:2], (0.0, -sheet.thickness - gap), strict=True):
        heights = np.linspace(top - sheet.thickness, top, 20)
        faces = []
        for face in (center + across, center - across):
            # beside its root, the tab continues into the strip
            r, z = np.concatenate([face[:1] - 5 * (center[1] - center[0]) / 0.015, face]).T
            faces.append(points[0, 0] + np.interp(heights, z[::-1], r[::-1]))
        radii = np.sort(np.abs(ring.slots[0].corners[:, 0]))[[0, -1]]
        gaps = np.array([faces[0].min() - radii[0], radii[1] - faces[1].max()])
        assert gaps.min() > -0.05
        assert gaps.sum() == pytest.approx(0.1, abs=0.1)
    assert center[-1, 1] < -2 * sheet.thickness - gap


@pytest.mark.parametrize(("gap", "length"), [(None, 8.0), (6.0, (2 * 1.5 + 6) / np.sin(np.radians(40)) + 2)])
def test_default_tabs_are_8_mm_long_or_extend_2_mm_beyond_the_second_ring(gap, length):
    """The tabs of this sphere lean by 40 degrees to the rings, which are 1.5 mm thick."""
    turns = np.radians(np.linspace(-50, 50, 5))
    points = 120 * np.column_stack([np.cos(turns), np.sin(turns) + np.sin(turns[-1])])
    ball = revolve(ec.meridian_through(points), 12, sheet="polypropylene-0.8", rings="hdf-1.5", gap=gap)
    assert [tab.length for tab in ball.strips[0].ends] == pytest.approx([length] * 2, rel=1e-5)


@pytest.mark.parametrize(
    ("rings", "gap", "length", "width"),
    [
        ("hdf-1.5", 7, 22, 12),
        ("hdf-1.5", 8, 23, 7),
        ("hdf-1.5", 10, 27, 12),
        ("polypropylene-0.8", 10, 30, 10),
    ],
)
def test_a_tab_that_the_load_bends_too_far_for_two_rings_is_refused(rings, gap, length, width):
    """Its slots had moved by tens of millimetres, or the tab ended before the second ring."""
    tab = Tab(length, width=width)
    with pytest.raises(InputError, match="bends the tab of strip 1:1 too far"):
        revolve(
            ec.meridian_through(SPHERE), 12, sheet="polypropylene-0.8", rings=rings, gap=gap, ends=(tab, tab)
        )
