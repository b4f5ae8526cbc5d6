"""Both plates of a pair keep the least bridge between their slots, after the slots are moved against the load."""

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


@pytest.mark.parametrize(("width", "gap", "made"), [(None, 8.0, False), (14.0, 6.0, True), (14.0, 8.0, True)])
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
    plates = end_plates(lamp(FLAT, 11), "hdf-1.5", gap=12.0, shape="ring", ignore_limits=True)
    outer = next(plate for plate in plates if plate.name == "ring-bottom-outer")
    assert bridges(outer) < LEAST_MM
    assert any("between the slot" in warning for warning in outer.warnings)
