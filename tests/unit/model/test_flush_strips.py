"""Strips that lie side by side in each other are told: by points of one body that are in the other."""

from math import cos, pi, sin, tan

import numpy as np
import pytest
from scipy.spatial import cKDTree

from elastica_cad import Model, Placed, PlaneCurve, Rod, Sheet, Strip, Tab, make_strip, optimal_rod
from elastica_cad.mechanics import RoundLaw, ThicknessLaw
from elastica_cad.model.collisions import missing_slots

pytestmark = pytest.mark.core

PLYWOOD = Sheet.named("birch-plywood-0.8")
ROD = optimal_rod(PlaneCurve.spline([(-75, 0), (-50, 60), (0, 95), (50, 60), (75, 0)]))
UP = (0, 0, 1)


def arch(label="", origin=(0, 0, 0), x_axis=(1, 0, 0), y_axis=UP, width=20.0):
    strip = Strip(ROD, PLYWOOD, max_width=width, ends=(Tab(0), Tab(0)), label=label)
    return Placed(strip, origin, x_axis, y_axis)


def depths(one, other, count=60_000):
    """How deep points of one body are in both, mm, negative where they are not; all sides but the ends count."""
    rng = np.random.default_rng(5)
    dense = np.linspace(0, ROD.length, 4001)
    curve = np.column_stack([np.interp(dense, ROD.s, x) for x in ROD.position.T])
    angle = np.interp(dense, ROD.s, ROD.angle)
    k = rng.integers(1, dense.size - 1, count)
    thick = one.strip.sheet.thickness
    room = np.array([one.strip.width(dense)[k], np.full(count, thick)]) / 2
    v, off = rng.uniform(-1, 1, (2, count)) * room
    normal = np.column_stack([-np.sin(angle[k]), np.cos(angle[k])])
    places = np.column_stack([curve[k] + off[:, None] * normal, v])
    own = (room - np.abs([v, off])).min(axis=0)
    x, y, z = other.frame.local(one.frame.point(places)).T
    away, nearest = cKDTree(curve).query(np.column_stack([x, y]))
    inner = (nearest > 0) & (nearest < dense.size - 1)
    there = np.minimum(other.strip.width(dense)[nearest] / 2 - np.abs(z), thick / 2 - away)
    return np.where(inner, np.minimum(own, there), -1.0)


def turned(degrees):
    return cos(np.radians(degrees)), sin(np.radians(degrees)), 0.0


PLACES = {
    "in one place": {},
    "half beside": {"origin": (0, 10, 0)},
    "a millimetre in": {"origin": (0, 19, 0)},
    "edge to edge": {"origin": (0, 20, 0)},
    "below": {"origin": (0, 0, -0.5)},
    "glued on at the top": {"origin": (0, 0, 3.0)},
    "turned about its top": {"x_axis": turned(0.5)},
    "turned beside": {"origin": (0, 15, 0), "x_axis": turned(0.9)},
    "turned far beside": {"origin": (0, 15, 0), "x_axis": turned(3.0)},
    "leaning out": {"origin": (0, 19.5, 0), "y_axis": (0, sin(0.03), cos(0.03))},
    "leaning in": {"origin": (0, 19.5, 0), "y_axis": (0, -sin(0.003), cos(0.003))},
    "across, in the top": {"origin": (0, 0, 0.5), "x_axis": (0, 1, 0)},
    "across, on the top": {"origin": (0, 0, 1.5), "x_axis": (0, 1, 0)},
    "the other way round": {"x_axis": (-1, 0, 0), "origin": (0, 12, 0)},
}


@pytest.mark.campaign
@pytest.mark.parametrize("place", PLACES)
def test_strips_that_lie_in_each_other_are_reported_and_others_are_not(place):
    placed = [arch("A"), arch("B", **PLACES[place])]
    deepest = max(depths(*placed).max(), depths(*placed[::-1]).max())
    result = missing_slots(placed)
    assert len(result) == (deepest > 0.05)


@pytest.mark.campaign
def test_places_at_random():
    """Within 2 degrees and some millimetres of each other; nearly all that is told or not is told by points."""
    rng = np.random.default_rng(11)
    found = []
    for _ in range(40):
        turn = np.linalg.qr(np.eye(3) + 0.03 * rng.normal(size=(3, 3)))[0]
        turn *= np.sign(np.diag(turn))
        shift = rng.normal(size=3) * (1.0, 12.0, 1.5)
        placed = [arch("A"), arch("B", shift, turn[0], turn[2])]
        deepest = max(depths(*placed).max(), depths(*placed[::-1]).max())
        result = missing_slots(placed)
        assert len(result) in ({1} if deepest > 0.15 else {0} if deepest < 0 else {0, 1})
        found.append(len(result))
    assert 8 < sum(found) < 35


def test_what_is_reported():
    placed = [arch("A"), arch("B", (0, 10, 0)), arch("C", (0, 25, 0)), arch("D", (0, 50, 0))]
    (message,) = missing_slots(placed, brief=True)
    assert message.startswith("the sheets of A (")
    assert "from its start) and B (" in message
    assert message.endswith(" overlap (and 1 more pair): move the strips apart, or make them narrower there")


@pytest.mark.campaign
@pytest.mark.parametrize("count", [3, 5, 12, 180])
@pytest.mark.parametrize("thickness", [0.4, 6.0])
def test_strips_about_an_axis_lie_edge_to_edge(count, thickness):
    sheet = PLYWOOD.with_thickness(thickness)
    wide = 2 * 60.0 * tan(pi / count)
    strip = Strip(Rod.straight(100.0), sheet, max_width=wide)
    model = Model([Placed(strip, origin=(60, 0, 0), x_axis=UP, y_axis=(1, 0, 0))]).rotated(count)
    assert missing_slots(model.placed) == ()


def test_leaves_on_each_other_are_not_reported():
    """Glued face to face they are as far apart as they are thick."""
    arc = PlaneCurve.arc((0, 0), 60.0, 0.5, 2.5)
    outer = PlaneCurve.arc((0, 0), 60.8, 0.5, 2.5)
    placed = [Placed(Strip(optimal_rod(c), PLYWOOD, max_width=20)) for c in (arc, outer)]
    assert missing_slots(placed) == ()
    inside = Placed(Strip(optimal_rod(PlaneCurve.arc((0, 0), 60.5, 0.5, 2.5)), PLYWOOD, max_width=20))
    assert len(missing_slots([placed[0], inside])) == 1


@pytest.mark.parametrize(("law", "inside", "beside"), [(ThicknessLaw, 19.0, 20.0), (RoundLaw, 0.5, 4.0)])
def test_battens_and_rods(law, inside, beside):
    """4 mm wide and more at the thickest, 1 mm at the thinnest."""
    glass = Sheet("glass", 3.0, 38000.0, density=1900.0, max_strain=0.02)
    sized = law(glass, 1.0, 4.0, width=20.0) if law is ThicknessLaw else law(glass, 1.0, 4.0)
    strip = make_strip(
        PlaneCurve.spline([(0, 0), (60, 120), (140, 160), (240, 120), (300, 0)]), glass, section=sized
    )
    for shift, count in ((inside, 1), (beside, 0)):
        placed = [Placed(strip), Placed(strip, (0, 0, shift))]
        assert len(missing_slots(placed)) == count
