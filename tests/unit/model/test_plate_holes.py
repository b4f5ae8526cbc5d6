"""Holes in plates and rings: for a lamp holder, for screws, and beside a bridge."""

import re
from dataclasses import replace

import numpy as np
import pytest

import elastica_cad as ec
from elastica_cad import InputError, Tab
from elastica_cad.design import read_design
from elastica_cad.geometry.path import Arc
from elastica_cad.model import PlateHoles, base_plate
from elastica_cad.model.plate_pairs import end_plates
from elastica_cad.plot.model_pictures import holder_patches
from elastica_cad.strip import text_strokes

POINTS = [(60, 0), (85, 40), (100, 90), (85, 140), (60, 180)]
DESIGN = f"""
name = "lamp"
[revolution]
sheet = "polypropylene-0.8"
strips = 12
points = {[list(point) for point in POINTS]}
rings = "mdf-3"
"""


@pytest.fixture(scope="module")
def ribs():
    bow = ec.PlaneCurve.spline([(60, 0), (90, 60), (90, 120), (60, 180)], degree=3)
    strip = replace(ec.make_strip(bow, "birch-plywood-0.8", max_width=20), ends=(Tab(14), Tab(14)))
    return ec.Model([ec.Placed(strip, (0, 0, 0), (1, 0, 0), (0, 0, 1))]).rotated(8).placed


def rings(placed, **holes):
    return end_plates(placed, "mdf-3", holes=PlateHoles(**holes))


def circles(plate):
    """Diameter of each round hole and the distance of its centre from the axis, in the order of the holes."""
    arcs = [hole.segments[0] for hole in plate.holes if len(hole.segments) == 1]
    return [(2 * arc.radius, float(np.hypot(*arc.center))) for arc in arcs if isinstance(arc, Arc)]


def test_the_hole_for_a_lamp_holder_is_in_the_middle_of_a_closed_ring(ribs):
    for ring, plain in zip(rings(ribs, bulb=40), end_plates(ribs, "mdf-3"), strict=True):
        assert circles(ring) == [(40, pytest.approx(0, abs=1e-9))]
        assert ring.opening is None
        material = plain.solid.volume + 3 * abs(plain.opening.area) - 3 * np.pi * 20**2
        assert ring.solid.volume == pytest.approx(material, rel=1e-12)


@pytest.mark.parametrize(("screws", "circle", "distance"), [(3, None, (40 + 4.2) / 2 + 8), (5, 62, 31)])
def test_screw_holes_are_evenly_on_their_circle(ribs, screws, circle, distance):
    ring, _ = rings(ribs, bulb=40, screws=screws, circle=circle)
    assert circles(ring)[1:] == [(4.2, pytest.approx(distance))] * screws
    centers = np.array([hole.segments[0].center for hole in ring.holes[1:]])
    steps = np.linalg.norm(centers - np.roll(centers, 1, axis=0), axis=1)
    assert steps == pytest.approx(2 * distance * np.sin(np.pi / screws))
    assert centers[0] == pytest.approx([distance, 0])


@pytest.mark.parametrize(("bulb", "bridge"), [(28, 14), (40, 9), (None, 12)])
def test_a_bridge_leaves_the_rest_of_the_opening_open(ribs, bulb, bridge):
    """The area outside of bar and hub, as an integral over the radius."""
    holes = {"bulb": bulb} if bulb else {"screws": 2, "circle": 30}
    (ring, _), (plain, _) = rings(ribs, bridge=bridge, **holes), end_plates(ribs, "mdf-3")
    outer = np.ptp(plain.opening.bounds[:, 0]) / 2
    hub = (bulb / 2 if bulb else 15 + 2.1) + bridge / 2
    r = np.linspace(hub, outer, 20_001)
    free = r * (2 * np.pi - 4 * np.arcsin(bridge / 2 / r))
    wanted = float(((free[1:] + free[:-1]) / 2 * np.diff(r)).sum())
    windows = [abs(hole.area) for hole in ring.holes if len(hole.segments) > 1]
    assert len(windows) == 2
    assert sum(windows) == pytest.approx(wanted, rel=1e-6)


def test_a_bridge_without_a_hub_carries_nothing_if_the_screws_are_in_the_rim(ribs):
    few = ribs[::4]
    ring, _ = end_plates(few, "mdf-3", border=16, holes=PlateHoles(bridge=10, screws=1, circle=98))
    inner = np.ptp(end_plates(few, "mdf-3", border=16)[0].opening.bounds[:, 0]) / 2
    assert circles(ring)[0][1] - 2.1 > inner
    assert [len(hole.segments) for hole in ring.holes] == [1, 2, 2]


@pytest.mark.parametrize(
    ("holes", "message"),
    [
        ({"bulb": 125}, "the hole of 125 mm at .* and the slot of .* overlap"),
        ({"bulb": 160}, "the hole of 160 mm at .* and the edge overlap"),
        ({"bulb": 30, "screws": 3, "circle": 32}, "the hole of 30 mm at .* and the hole of 4.2 mm at .* overlap"),
        ({"screws": 3, "circle": 60}, "the hole of 4.2 mm at .* and the opening overlap"),
        ({"screws": 16, "circle": 118}, "the hole of 4.2 mm at .* and the slot of .* overlap"),
        ({"bulb": 112}, "mm between the slot of .* and the hole of 112 mm .*needs at least 3 mm.* Use small"),
        ({"bulb": 30, "bridge": 4}, "only .* mm between the hole of 30 mm at .* and the opening beside the bridge"),
        ({"bulb": 40, "screws": 3, "circle": 48}, r"only 1\.9.* 40 mm at \(0, 0\) mm and .* at \(-12, 20\.78\) mm"),
        ({"bulb": 40, "side": "start"}, "holes.side is start, but the plates are ring-bottom, ring-top"),
        ({}, "There is no hole. Set holes.bulb or holes.screws"),
        ({"screws": 3}, "Set holes.circle"),
    ],
)  # fmt: skip
def test_holes_that_cannot_be_cut_are_refused(ribs, holes, message):
    with pytest.raises(InputError, match=message):
        rings(ribs, **holes)


def test_only_one_side_may_have_the_holes(ribs):
    four = end_plates(ribs, "mdf-3", gap=4, holes=PlateHoles(bulb=30, side="top"))
    assert {ring.name: len(ring.holes) for ring in four} == {
        "ring-bottom": 0, "ring-bottom-outer": 0, "ring-top": 1, "ring-top-outer": 1
    }  # fmt: skip


def test_the_name_of_a_plate_is_clear_of_its_holes(ribs):
    ring, _ = rings(ribs, bulb=60, screws=3)
    strokes = [stroke for text in ring.drawing.texts[-1:] for stroke in text_strokes(text)]
    points = np.concatenate([stroke.points(0.05) for stroke in strokes])
    assert ring.drawing.texts[-1].text == ring.name
    for hole in ring.holes:
        arc = hole.segments[0]
        assert np.hypot(*(points - arc.center).T).min() > arc.radius + 0.4


def test_a_base_plate_has_a_hole_too(ribs):
    plate = base_plate(ribs, "mdf-3", holes=PlateHoles(bulb=29, screws=2, screw=3))
    assert circles(plate) == [(29, pytest.approx(0, abs=1e-6)), *[(3, pytest.approx(28))] * 2]


@pytest.mark.campaign
def test_a_cap_is_drilled_beside_the_seats_of_its_tabs():
    meridian = ec.meridian(0.0, (1 / 300, 0), (300, 0), np.pi / 2, 900, ring=25)
    options = {"sheet": "card-200gsm", "rings": "mdf-3"}
    _, cap = ec.revolve(meridian, 12, holes=PlateHoles(bulb=28, side="top"), **options).plates
    assert circles(cap)[-1] == (28, 0)
    with pytest.raises(InputError, match=r"the hole of 60 mm at .* mm and the seat of a tab overlap"):
        ec.revolve(meridian, 12, holes=PlateHoles(bulb=60, side="top"), **options)
    with pytest.raises(InputError, match="Pass a PlateHoles"):
        ec.revolve(meridian, 12, holes=28, **options)


def test_a_design_file_declares_the_holes(tmp_path):
    path = tmp_path / "lamp.toml"
    path.write_text(f'{DESIGN}[revolution.holes]\nbulb = "20 + 20"\nbridge = 12\nside = "top"\n')
    bottom, top = read_design(path, ec.read_curves).model().plates
    assert (bottom.holes, circles(top)) == ((), [(40, 0)])
    path.write_text(f"{DESIGN}[revolution.holes]\nbulbs = 40\n")
    with pytest.raises(InputError, match="bulbs"):
        read_design(path, ec.read_curves)


def test_a_bridge_without_effect_is_reported(ribs):
    wide = {"bulb": 70, "bridge": 30}
    filled, plain = rings(ribs, side="top", **wide), rings(ribs, bulb=20, bridge=10)
    text = "the bridge has no effect"
    assert filled[0].warnings == ()
    (advice,) = (re.search(f"{text}, .* Use a bridge (\\d+) mm wide", note) for note in filled[1].warnings)
    narrow = rings(ribs, side="top", bulb=70, bridge=int(advice[1]))[1]
    assert narrow.warnings == ()
    assert sum(len(hole.segments) > 1 for hole in narrow.holes) == 2
    assert [ring.warnings for ring in plain] == [(), ()]
    arch = ec.make_strip(
        ec.PlaneCurve.arc((0, -18), 60, 0.3, 2.8), "birch-plywood-0.8", max_width=20, ends=Tab(12)
    )
    base = base_plate(
        [ec.Placed(arch, (0, 0, 0), (1, 0, 0), (0, 0, 1))], "mdf-3", holes=PlateHoles(bulb=10, bridge=5)
    )
    assert text in base.warnings[0]


def test_the_names_of_tabs_are_beside_the_holes(ribs):
    """A screw hole close inside the first slot: the name of its tab is outside the slot."""
    slot = rings(ribs, bulb=40)[0].slots[0]
    radius = float(np.hypot(*slot.corners.mean(axis=0)))
    for screws in range(1, 9):
        ring, _ = rings(ribs, screws=screws, circle=2 * radius - 14, screw=4.0, bulb=10)
        for text in ring.drawing.texts:
            letters = np.concatenate([stroke.points(0.2) for stroke in text_strokes(text)])
            for hole in ring.holes:
                arc = hole.segments[0]
                assert np.linalg.norm(letters - arc.center, axis=1).min() > arc.radius


def test_the_picture_of_a_model_has_the_holes_of_its_rings(ribs):
    top, bottom = rings(ribs, bulb=40), rings(ribs, bulb=12)
    areas = []
    for plates in (top, bottom):
        ((patches, _),) = holder_patches(plates[:1], 5.0)
        level = patches[np.ptp(patches[:, :, 2], axis=1) < 1e-9]
        diagonals = np.cross(level[:, 2] - level[:, 0], level[:, 3] - level[:, 1])
        areas.append(float(np.abs(diagonals[:, 2]).sum()) / 4)  # of both faces
    assert areas[1] - areas[0] == pytest.approx(np.pi * (20**2 - 6**2), rel=0.03)


def test_gores_without_holders_have_no_tabs(tmp_path):
    path = tmp_path / "globe.toml"
    for rest, length in (("", 0.0), ("[fixtures]\n", 10.0)):
        path.write_text(DESIGN.replace('rings = "mdf-3"\n', rest))
        (strip,) = {id(strip): strip for strip in read_design(path, ec.read_curves).model().strips}.values()
        assert {end.length > 0 for end in strip.ends} == {length > 0}
