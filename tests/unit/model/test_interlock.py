"""Slots of strips that cross: closed forms, patterns of crossings, sides, refusals."""

import re
from dataclasses import replace

import numpy as np
import pytest

from elastica_cad import (
    Frame,
    InputError,
    Laminated,
    Model,
    Placed,
    PlaneCurve,
    Profile,
    Rod,
    Sheet,
    Slot,
    Strip,
    optimal_rod,
)
from elastica_cad.model import slot_width
from elastica_cad.model.collisions import missing_slots
from elastica_cad.model.crossings import RuledStrip, strip_crossings, strips_may_meet
from elastica_cad.strip.pieces import cut_key

pytestmark = pytest.mark.core

CARD = Sheet.named("card-200gsm")
H = CARD.thickness


def flat(length=100.0, width=20.0, label="", **frame):
    return Placed(Strip(Rod.straight(length), CARD, max_width=width, label=label), **frame)


def turned(angle, at=(50.0, 0.0, 0.0), back=50.0, **options):
    """A flat strip in the xy plane that passes `at` at an angle, `back` mm after its start."""
    x = np.array([np.cos(angle), np.sin(angle), 0.0])
    return flat(origin=np.array(at) - back * x, x_axis=x, y_axis=np.cross([0, 0, 1], x), **options)


@pytest.mark.parametrize("degrees", [20, 45, 60, 89.999, 90, 120, 160])
def test_two_flat_strips_on_edge(degrees):
    """Parallel rulings: each is cut along one ruling, half way, as wide as the formula says."""
    phi = np.radians(degrees)
    model = Model([flat(label="A"), turned(phi, label="B", back=30.0)]).interlock(clearance=0.15)
    (joint,) = model.joints
    expected = H / np.sin(phi) + H * abs(1 / np.tan(phi)) + 0.15
    for strip, x, sign in zip(model.strips, (50.0, 30.0), (1, -1), strict=True):
        (slot,) = strip.slots
        np.testing.assert_allclose(slot.path[[0, -1]], [[x, 0.0], [x, sign * 10.0]], atol=1e-9)
        np.testing.assert_allclose(slot.widths, expected, rtol=1e-9)
        whole = replace(strip, slots=())
        assert whole.area - strip.area == pytest.approx(10 * expected, abs=1e-6)
    np.testing.assert_allclose(joint.position, (50, 0, 0), atol=1e-9)
    np.testing.assert_allclose(joint.angle, min(phi, np.pi - phi), rtol=1e-9)


@pytest.mark.parametrize("back", [20.0, 30.0, 62.5])
@pytest.mark.parametrize("width", [8.0, 16.0, 20.0, 33.0])
def test_edges_at_a_node_of_the_ruling(width, back):
    """Round sizes put the edges exactly where the search looks: the slot still ends on them."""
    first, second = flat(width=width, label="A"), turned(np.pi / 9, back=back, width=width, label="B")
    model = Model([first, second]).interlock(clearance=0.15)
    for strip in model.strips:
        (slot,) = strip.slots
        np.testing.assert_allclose(np.abs(slot.path[[0, -1], 1]), [0.0, width / 2], atol=1e-9)


def test_copies_with_one_label_are_reported_apart():
    model = Model([flat(label="A", origin=(-50, 0, 0))]).rotated(2, step=0.1)
    with pytest.raises(InputError, match=r"A \(strip 1\)"):
        model.interlock(clearance=50.0)
    lines = model.interlock().reports
    assert any("A (strip 1), A (strip 2): push" in line for line in lines)


def rotation(seed):
    return np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))[0]


def crossing_planes(seed):
    """Frames of two flat strips, the line in which their planes meet, and where on it either strip ends."""
    rng = np.random.default_rng(seed)
    while True:
        frames = []
        for _ in range(2):
            x, y, _ = np.linalg.qr(rng.normal(size=(3, 3)))[0]
            s, v = rng.uniform([40, -2], [60, 2])
            frames.append(Frame(-s * x - v * np.cross(x, y), x, y))
        along = np.cross(*(frame.y_axis for frame in frames))
        along /= np.linalg.norm(along)
        ends, inside = [], True
        for frame in frames:
            start, slope = frame.local((0, 0, 0))[2], frame.z_axis @ along
            ends.append(np.sort((np.array([-10, 10]) - start) / slope))
            inside &= np.abs(frame.x_axis @ along * ends[-1]).max() < 35
        phi = np.arccos(abs(frames[0].y_axis @ frames[1].y_axis))
        if inside and phi > np.radians(20):
            return frames, along, phi, ends


@pytest.mark.parametrize("seed", range(10))
def test_two_planes_in_space(seed):
    """Flat strips anywhere: the crossing is a piece of the line in which their planes meet."""
    frames, along, phi, ends = crossing_planes(seed)
    low, high = max(e[0] for e in ends), min(e[1] for e in ends)
    placed = [
        flat(origin=f.origin, x_axis=f.x_axis, y_axis=f.y_axis, label=name)
        for f, name in zip(frames, "AB", strict=True)
    ]
    (joint,) = Model(placed).interlock(clearance=0.1).joints
    np.testing.assert_allclose(joint.position, (low + high) / 2 * along, atol=1e-7)
    ways = []
    for frame, slot, (first, last) in zip(frames, joint.slots, ends, strict=True):
        local = np.column_stack([slot.path[:, 0], np.zeros(len(slot.path)), slot.path[:, 1]])
        x = frame.point(local) @ along
        np.testing.assert_allclose(frame.point(local), x[:, None] * along, atol=1e-8)
        assert x[0] == pytest.approx((low + high) / 2, abs=1e-7)
        assert min(abs(x[-1] - first), abs(x[-1] - last)) < 1e-7
        np.testing.assert_allclose(slot.widths, H / np.sin(phi) + H / np.tan(phi) + 0.1, rtol=1e-9)
        ways.append(np.sign(x[-1] - x[0]))
    assert ways[0] == -ways[1]  # from opposite ends of the line


def test_formula_of_the_width():
    phi = np.radians([30.0, 90.0])
    np.testing.assert_allclose(
        slot_width(phi, own=0.5, other=0.2, clearance=0.1), [0.4 + 0.5 * np.sqrt(3) + 0.1, 0.3]
    )
    np.testing.assert_allclose(slot_width(phi, own=0.5, other=0.2, clearance=0.1, fit="paper"), [0.5, 0.3])


def arch(height, width=80.0):
    return PlaneCurve.spline([(0, 0), (0, height), (width / 2, 1.4 * height), (width, height), (width, 0)])


def brute(a, b, count=1500):
    """Pairs (s_a, s_b) at which rulings of a pierce b within both widths, found by sampling."""
    first, second = a.curve.sample(count), b.curve.sample(count)
    points, ruling = b.frame.local(a.frame.point(first.position)), b.frame.axes @ a.axis
    normal = np.array([-ruling[1], ruling[0]])
    side = (second.position @ normal)[None] - (points[:, :2] @ normal)[:, None]
    k, j = np.nonzero(side[:, :-1] * side[:, 1:] < 0)
    f = (side[k, j] / (side[k, j] - side[k, j + 1]))[:, None]
    met = second.position[j] * (1 - f) + second.position[j + 1] * f
    v = ((met - points[k, :2]) @ ruling[:2]) / (ruling[:2] @ ruling[:2])
    u = points[k, 2] + v * ruling[2]
    s_b = second.s[j] * (1 - f[:, 0]) + second.s[j + 1] * f[:, 0]
    inside = (np.abs(v) < a.width(first.s[k]) / 2) & (np.abs(u) < b.width(s_b) / 2)
    return np.column_stack([first.s[k], s_b])[inside]


def ruled(curve, frame, width):
    return RuledStrip(curve, frame, Profile.interpolate([0.0, curve.length], [width, width]))


@pytest.mark.parametrize("seed", range(20))
def test_all_crossings_are_found_and_exact(seed):
    """Random pairs of bent strips: every crossing that sampling sees, and both patterns meet in space."""
    rng = np.random.default_rng(seed)
    a = ruled(arch(rng.uniform(30, 60)), Frame(x_axis=(1, 0, 0), y_axis=(0, 0, 1)), 24.0)
    angle = rng.uniform(-0.3, 0.3) if seed % 2 else rng.uniform(-2, 2)
    x = np.array([np.cos(angle), np.sin(angle), 0.0])
    up = np.array([0.0, 0.0, 1.0])
    tilt = rng.uniform(-0.3, 0.3)
    y = np.cos(tilt) * up + np.sin(tilt) * np.cross(up, x)
    at = np.array([*rng.uniform(-15, 15, 2), rng.uniform(-5, 5)])
    b = ruled(arch(rng.uniform(30, 60)), Frame(at, x, y), 20.0)
    found = strip_crossings(a, b)
    seen = brute(a, b)
    for crossing in found:
        p = crossing.at(np.linspace(0, 1, 21))
        for strip, rows in zip((a, b), (p.first, p.second), strict=True):
            position = strip.frame.point(strip.curve.at(rows[:, 0]).position) + rows[:, 1:] * strip.axis
            np.testing.assert_allclose(position, p.position, atol=1e-9)
        room = [
            strip.width(rows[:, 0]) / 2 - np.abs(rows[:, 1])
            for strip, rows in zip((a, b), (p.first, p.second), strict=True)
        ]
        assert min(r.min() for r in room) > -1e-9
        ends = [min(r[i] for r in room) for i in (0, -1)]
        for i, end in zip((0, -1), ends, strict=True):
            at_end = any(
                min(rows[i, 0], strip.length - rows[i, 0]) < 1e-4
                for strip, rows in zip((a, b), (p.first, p.second), strict=True)
            )
            assert abs(end) < 1e-8 or at_end
        if crossing.length > 1:
            assert np.hypot(*(seen - [p.first[10, 0], p.second[10, 0]]).T).min() < 1
    for s_a, s_b in seen:
        gaps = []
        for crossing in found:
            p = crossing.at(np.linspace(0, 1, 201))
            gaps.append(np.hypot(p.first[:, 0] - s_a, p.second[:, 0] - s_b).min())
        assert min(gaps, default=np.inf) < 0.6


@pytest.mark.parametrize("way", [1, -1])
@pytest.mark.parametrize("lean", [0.0, 1e-8, 1e-6, 1e-3])
def test_two_circles(way, lean):
    """Arcs with (nearly) parallel rulings, alike or opposed, cross where the circles do, over the common width."""
    a = ruled(PlaneCurve.arc((0, 0), 50, 0.2, 2.9), Frame(), 20.0)
    y = (0, way * np.cos(lean), way * np.sin(lean))
    b = ruled(
        PlaneCurve.arc((0, 0), 50, *((0.2, 2.9) if way > 0 else (-0.2, -2.9))),
        Frame((20, 0, 1), (1, 0, 0), y),
        16.0,
    )
    (crossing,) = strip_crossings(a, b)
    p = crossing.at(np.array([0.0, crossing.middle, 1.0]))
    np.testing.assert_allclose(p.first[1, 0], 50 * (np.arccos(0.2) - 0.2), atol=30 * lean + 1e-9)
    np.testing.assert_allclose(np.sort(p.position[:, 2]), [-7, 1, 9], atol=60 * lean + 2e-6)
    np.testing.assert_allclose(p.angle, np.arccos(1 - 0.4**2 / 2), atol=3 * lean + 1e-9)
    assert crossing.length == pytest.approx(16, abs=10 * lean + 4e-6)


def test_crossing_the_crest_is_one_crossing():
    """A flat strip leans into the crest of an arch: its height turns along the crossing."""
    a = ruled(PlaneCurve.arc((0, 0), 50, 0.3, np.pi - 0.3), Frame(y_axis=(0, 0, 1)), 60.0)
    x = np.array([0.02, 1.0, 0.15]) / np.linalg.norm([0.02, 1.0, 0.15])
    y = np.cross(np.cross(x, (0, 0, 1)), x)
    roof = Frame((0, 0, 49), x, y / np.linalg.norm(y))
    b = ruled(PlaneCurve.line((-80, 0), (80, 0)), roof, 70.0)
    crossings = strip_crossings(a, b)
    for crossing in crossings:
        p = crossing.at(np.linspace(0, 1, 50)).position
        np.testing.assert_allclose(np.hypot(p[:, 0], p[:, 2]), 50, atol=1e-9)
        np.testing.assert_allclose((p - roof.origin) @ roof.y_axis, 0, atol=1e-9)
    heights = np.concatenate([c.at(np.linspace(0, 1, 50)).position[:, 0] for c in crossings])
    assert len(crossings) == len(brute_runs(a, b))
    assert heights.min() < 0 < heights.max()


def brute_runs(a, b):
    """Sampled crossings put into groups."""
    seen = brute(a, b)
    groups = []
    for row in seen[np.argsort(seen[:, 0])]:
        for group in groups:
            if np.hypot(*(np.array(group) - row).T).min() < 1.5:
                group.append(row)
                break
        else:
            groups.append([row])
    return groups


def test_a_strip_that_runs_into_another_lengthwise_is_refused():
    """The arch's rulings lie along the wall: no slot of the wall could open at its edge."""
    rod = optimal_rod(arch(40))
    strip = Strip(rod, CARD, max_width=20, label="A")
    wall = turned(np.pi / 2, at=(40, 0, 40), label="B")
    with pytest.raises(
        InputError, match=r"A and B cross .* mm from the start of A, but one of these strips ends"
    ) as refused:
        Model([Placed(strip, (0, 0, 0), (1, 0, 0), (0, 0, 1)), wall]).interlock()
    place = float(re.search(r"cross (\S+) mm", str(refused.value))[1])
    assert rod.curve.at(place).position[0, 0] == pytest.approx(40.0, abs=0.5)


def test_egg_crate_is_cut_the_same_way_throughout():
    rows = [
        flat(label=f"R{i}", origin=(0, 20 * i, 0), x_axis=(1, 0, 0), y_axis=(0, 1, 0)) for i in range(1, 4)
    ]
    columns = [
        flat(label=f"C{i}", origin=(25 * i, 0, 0), x_axis=(0, 1, 0), y_axis=(-1, 0, 0), width=20 + 3 * i)
        for i in range(1, 4)
    ]
    model = Model([*rows, *columns]).interlock()
    assert len(model.joints) == 9
    assert [slot.side for strip in model.strips for slot in strip.slots] == ["upper"] * 9 + ["lower"] * 9
    assert model.reports == (
        "assemble in the order R1 ... R3, C1 ... C3: push each strip onto the strips before it",
    )
    below = Model([*rows, *columns]).interlock(above=(0, 0, -1))
    assert {slot.side for slot in below.strips[0].slots} == {"lower"}
    some = Model([*rows, *columns]).interlock(pairs=[(3, 0), (0, 3), (1, 4)])
    assert [joint.members for joint in some.joints] == [(0, 3), (1, 4)]
    assert below.strips[0].slots[0].mate == "C1"


def test_narrow_through_wide_goes_to_the_edge_of_the_wide():
    model = Model([flat(width=10, label="A"), turned(np.pi / 2, width=30, label="B")]).interlock()
    a, b = model.strips
    assert a.slots[0].path[[0, -1], 1] == pytest.approx([0, 5])
    assert b.slots[0].path[[0, -1], 1] == pytest.approx([0, -15])


def test_overlap_is_cut_from_either_edge():
    """Strips that overlap by 4 mm: each has 2 mm cut from the edge that lies in the other."""
    upper = turned(np.pi / 2, at=(50, 0, 16), label="B")
    for above in ((0, 0, 1), (0, 0, -1)):
        model = Model([flat(label="A"), upper]).interlock(above=above)
        a, b = model.strips
        assert a.slots[0].path[[0, -1], 1] == pytest.approx([8, 10])
        assert b.slots[0].path[[0, -1], 1] == pytest.approx([-8, -10])


def test_a_strip_held_from_both_edges_is_reported():
    """The last strip lies between one above and one below: it cannot simply be pushed on."""
    over = turned(np.pi / 2, at=(30, 0, 16), label="A")
    under = turned(np.pi / 2, at=(70, 0, -16), label="B")
    last = Model([over, under, flat(label="C")]).interlock()
    assert last.reports[-1].endswith("thread C into place, because their slots enter from both edges")
    assert sorted(slot.side for slot in last.strips[2].slots) == ["lower", "upper"]
    first = Model([flat(label="C"), over, under]).interlock()
    assert "into place" not in first.reports[-1]


def test_arches_that_lie_on_each_other_at_the_top_touch():
    """Where one runs over the other both lie flat: no slot, and no strip too short for one."""
    rod = optimal_rod(PlaneCurve.spline([(-75, 0), (-50, 60), (0, 95), (50, 60), (75, 0)]))
    arches = [
        Placed(Strip(rod, CARD, max_width=16.0, label=name), x_axis=x, y_axis=(0, 0, 1))
        for name, x in (("A", (1, 0, 0)), ("B", (0, 1, 0)))
    ]
    with pytest.raises(
        InputError,
        match=r"A and B do not cross .* but touch along a line: move the strips apart, or turn one",
    ):
        Model(arches).interlock()


def test_equal_arches_are_slotted_where_they_run_down_side_by_side():
    """Their heights are those of one curve: the way along the crossing had stood still between every two nodes."""
    rod = optimal_rod(PlaneCurve.spline([(-200, 0), (-150, 120), (0, 220), (150, 120), (200, 0)]))
    a, b = (
        Placed(Strip(rod, CARD, max_width=30.0, label=name), origin=origin, x_axis=x, y_axis=(0, 0, 1))
        for name, x, origin in (("A", (1, 0, 0), (0, 150, 0)), ("B", (0, 1, 0), (-150, 0, 0)))
    )
    crossings = strip_crossings(
        *(RuledStrip(one.strip.rod.curve, one.frame, one.strip.width) for one in (a, b))
    )
    (crossing,) = crossings
    points = crossing.at(crossing.evenly(-0.5, 0.5, 0.5)).position
    steps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    assert steps.max() < 1.2 * steps.min()
    model = Model([a, b]).interlock()
    for strip in model.strips:
        steps = np.hypot(*np.diff(strip.slots[0].path, axis=0).T)
        assert steps.max() < 1.5 * steps.min()
        assert strip.outline.closed


def test_strips_that_run_through_each_other_are_reported_and_neighbours_that_touch_are_not():
    """Twelve strips about an axis: a little narrower than there is room for, just so wide, a millimetre wider."""
    rod = Rod.straight(100.0)
    room = 2 * 30.0 * np.tan(np.pi / 12)
    for wide, result in ((room - 0.01, 0), (room, 0), (room + 1.0, 12)):
        strip = Strip(rod, CARD, max_width=wide)
        model = Model([Placed(strip, origin=(30, 0, 0), x_axis=(0, 0, 1), y_axis=(1, 0, 0))]).rotated(12)
        assert len(missing_slots(model.placed)) == result
        assert len(missing_slots(model.placed, brief=True)) == min(1, result)
    assert missing_slots(model.placed, brief=True)[0].endswith(
        "(and 11 more pairs): cut slots (interlock), move the strips apart, or make them narrower there"
    )


def test_shallow_angles_are_reported():
    model = Model([flat(label="A"), turned(np.radians(10), label="B")]).interlock()
    assert "A and B cross at an angle of 10 degrees, 50 mm from the start of A" in model.reports[0]


@pytest.mark.parametrize(
    ("placed", "options", "message"),
    [
        (
            [flat(label="A"), flat(label="B")],
            {},
            "A and B do not cross 0 mm from the start of A, but touch along a line",
        ),
        ([flat(label="A"), turned(np.radians(0.5), label="B")], {}, "but touch along a line"),
        (
            [flat(label="A"), turned(1.0, label="B")],
            {"clearance": 25.0},
            "clearance of 25 mm is more than the width of A",
        ),
        ([flat(label="A"), turned(1.0, label="B")], {"clearance": -1.0}, "clearance is -1"),
        ([flat(label="A"), turned(1.0, label="B")], {"fit": "loose"}, "fit is"),
        ([flat(label="A"), turned(1.0, label="B")], {"pairs": [(0, 2)]}, "pair"),
        ([flat(label="A"), turned(1.0, label="B")], {"above": (0, 0, 0)}, "above"),
        ([flat(label="A"), turned(1.4, label="B"), turned(1.7, label="C")], {}, "A: the slots 50 mm"),
        ([flat(), turned(1.4), turned(1.7)], {}, "strip 1: "),
    ],
)
def test_refused(placed, options, message):
    with pytest.raises(InputError, match=message):
        Model(placed).interlock(**options)


def test_a_crossing_at_the_end_of_a_strip_is_refused():
    tilted = flat(label="B", origin=(50, 0.0, 0), x_axis=(0, 1, 0), y_axis=(-np.cos(0.2), 0, np.sin(0.2)))
    moved = Placed(tilted.strip, tilted.origin - 0.5 * np.array([0, 1, 0]), tilted.x_axis, tilted.y_axis)
    leaning = flat(label="A", y_axis=(0, np.cos(0.3), np.sin(0.3)))
    with pytest.raises(InputError, match="ends too close"):
        Model([leaning, moved]).interlock()


def test_strips_apart_stay_whole():
    model = Model([flat(label="A"), turned(1.0, at=(50, 0, 21), label="B")])
    joined = model.interlock()
    assert joined.joints == ()
    assert joined.reports == ("no strips cross, so no slots were cut",)
    assert [strip.slots for strip in joined.strips] == [(), ()]


def test_a_laminate_is_as_thick_as_its_layers():
    paper = Sheet(
        "paper", thickness=0.1, youngs_modulus=CARD.youngs_modulus, density=CARD.density, max_strain=0.01
    )
    rod = optimal_rod(PlaneCurve.line((0, 0), (100, 0)))
    double = Strip(rod, CARD, max_width=20, style=Laminated(width=20.0, backing=paper), label="A")
    model = Model([Placed(double), turned(np.pi / 2, label="B")]).interlock(clearance=0.0)
    assert [float(strip.slots[0].width) for strip in model.strips] == pytest.approx([0.2, 0.3])


def test_slots_that_were_there_stay():
    model = Model([flat(label="A"), turned(1.0, label="B")])
    first = replace(model.strips[0], slots=(Slot(20, 1.0, 3.0),))
    joined = model.with_strips([first, model.strips[1]]).interlock()
    assert [slot.at for slot in joined.strips[0].slots] == [20, pytest.approx(50)]


def test_strips_that_are_slotted_alike_have_one_key():
    rod = Rod.straight(100.0)
    ribs = [
        Placed(
            Strip(rod, CARD, max_width=20, label=f"R{k}"), (0, 30 * k * (1 + 1e-15), 0), (1, 0, 0), (0, 1, 0)
        )
        for k in range(3)
    ]
    rails = [
        Placed(
            Strip(Rod.straight(90.0), CARD, max_width=20, label=f"L{k}"), (x, -15, 0), (0, 1, 0), (-1, 0, 0)
        )
        for k, x in enumerate((20.0, 70.0))
    ]
    first, *others = Model([*ribs, *rails]).interlock(above=(0, 0, 1)).strips[:3]
    for other, label in zip(others, ("R1", "R2"), strict=True):
        assert other.label == label
        assert [slot.mate for slot in other.slots] == ["L0", "L1"]
        assert cut_key(other) == cut_key(first)
    assert cut_key(replace(first, creep=0.1)) != cut_key(first)
    turned_over = replace(first, slots=tuple(slot.mirrored() for slot in first.slots))
    assert cut_key(turned_over) != cut_key(first)
    farther = tuple(replace(slot, path=slot.path + np.array([1e-5, 0.0])) for slot in first.slots)
    assert cut_key(replace(first, slots=farther)) != cut_key(first)


def test_strips_that_are_clearly_apart_are_listed_with_their_room():
    strips = [
        RuledStrip(one.strip.rod.curve, one.frame, one.strip.width)
        for one in (flat(), flat(origin=(0, 3, 0)), turned(1.0), flat(origin=(0, 0, 50)))
    ]
    assert strips_may_meet(strips).tolist() == [
        [True, False, True, False],
        [False, True, True, False],
        [True, True, True, False],
        [False, False, False, True],
    ]
    assert strips_may_meet(strips, np.array([2.0, 1.0, 0.0, 0.0]))[0, 1]
    assert not strips_may_meet(strips, np.array([2.0, 0.9, 0.0, 0.0]))[0, 1]
