"""Strips that are slotted together and collide beside their slots are told: by points of one body in the other.

A strip that touches itself is reported with both places.
"""

import numpy as np
import pytest

from elastica_cad import InputError, PlaneCurve, make_strip
from elastica_cad.design.kit_spec import KitSpec
from elastica_cad.kit.kit_contents import kit_contents
from elastica_cad.model.collisions import missing_slots, self_contact

COLLIDING = (12, 32, 44, 62, 71, 76, 96, 98, 118)
"""Edges in faces, ends in faces, faces in faces, edges across edges."""

APART = (5, 6, 8, 10, 15, 17, 29, 37)


@pytest.mark.parametrize("seed", COLLIDING)
def test_what_is_reported_is_in_both(seed, slotted_pairs):
    model = slotted_pairs.pair(seed)
    (result,) = missing_slots(model.placed, model.joints)
    place = np.array(result.values["place"])
    for placed, s in zip(model.placed, (result.values["s"], result.values["r"]), strict=True):
        around = place + np.random.default_rng(1).uniform(-0.15, 0.15, (4000, 3))
        inside = slotted_pairs.depths(placed, around) > 0
        assert inside.any()
        middle = placed.frame.point(placed.strip.rod.curve.at(np.array([s])).position)[0]
        assert abs((middle - place) @ placed.frame.x_axis) < 5
    both = np.all([slotted_pairs.depths(placed, around) > 0 for placed in model.placed], axis=0)
    assert both.any()


@pytest.mark.parametrize("seed", [12, 44, 76, 98, 118])
def test_how_deep_they_run(seed, slotted_pairs):
    model = slotted_pairs.pair(seed)
    a, b = model.placed
    depth = missing_slots(model.placed, model.joints)[0].values["depth"]
    assert depth == pytest.approx(max(slotted_pairs.shared(a, b), slotted_pairs.shared(b, a)), rel=0.12)


@pytest.mark.campaign
@pytest.mark.parametrize("clearance", [0.0, 0.1, 0.5])
@pytest.mark.parametrize("seed", APART)
def test_what_lies_in_its_slots_is_not_reported(seed, clearance, slotted_pairs):
    model = slotted_pairs.pair(seed, clearance=clearance)
    a, b = model.placed
    assert max(slotted_pairs.shared(a, b), slotted_pairs.shared(b, a)) < 0.06
    assert missing_slots(model.placed, model.joints) == ()


def test_slots_of_the_papers_width_are_requested_away_from_them_only(slotted_pairs):
    for seed, count in ((5, 0), (8, 0), (76, 1)):
        model = slotted_pairs.pair(seed, fit="paper")
        assert len(missing_slots(model.placed, model.joints)) == count


def test_kits_tell(slotted_pairs):
    model = slotted_pairs.pair(76)
    (result,) = (
        text
        for text in kit_contents(model, KitSpec(ignore_limits=True), effects=False).notes
        if "outside the slots" in text
    )
    assert result.values["depth"] > 0


def test_faces_that_bend_away_from_each_other_ask_for_no_width(slotted_pairs):
    """Where they do not meet, the search ends among numbers: numpy's warnings are errors here."""
    model = slotted_pairs.pair(231172)
    assert len(model.joints) == 2
    assert all(np.isfinite(slot.widths).all() for joint in model.joints for slot in joint.slots)
    with pytest.raises(InputError, match="move them apart"):
        slotted_pairs.pair(231102)


def test_a_strip_touches_itself_where_its_curve_crosses():
    """A loop that is the same when mirrored: both places have the same distance from its ends."""
    loop = PlaneCurve.spline(
        [(0, 0), (140, 40), (150, 150), (60, 180), (-30, 150), (-20, 40), (120, 0)], degree=4
    )
    strip = make_strip(loop, "card-200gsm", max_width=20)
    first, second = self_contact(strip)
    x, _ = strip.rod.curve.at(np.array([first, second])).position.T
    assert x == pytest.approx([60.0, 60.0], abs=0.05)
    assert first + second == pytest.approx(strip.rod.length, abs=0.1)
