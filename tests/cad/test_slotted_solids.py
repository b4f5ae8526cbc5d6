"""Strips slotted into each other, as OpenCASCADE sees them bent in space."""

import numpy as np
import pytest

from elastica_cad import Model, Placed, PlaneCurve, Rod, Sheet, Slot, Strip, optimal_rod
from elastica_cad.kernel import occt
from elastica_cad.strip import BentSolid

CARD = Sheet.named("card-200gsm")


def common_volume(model, measure):
    """Volume that the first two strips of a model share, mm3."""
    from OCP.BRepAlgoAPI import BRepAlgoAPI_Common
    from OCP.TopTools import TopTools_ListOfShape

    solids = []
    for placed in model.placed[:2]:
        record = BentSolid.of(placed.strip, placed.frame)
        solid = occt.make_solid(record)
        assert record.boundary.is_closed
        assert measure.is_valid(solid)
        solids.append(solid)
    shared = BRepAlgoAPI_Common()
    for give, solid in zip((shared.SetArguments, shared.SetTools), solids, strict=True):
        shapes = TopTools_ListOfShape()
        shapes.Append(solid)
        give(shapes)
    # the ends of two slots touch: without a tolerance, rounding leaves slivers between them
    shared.SetFuzzyValue(1e-6)
    shared.Build()
    return measure.volume(shared.Shape(), bent=False)


def test_slots_of_every_kind_reach_the_solid(measure):
    slots = (Slot(60, 1.0, 5), Slot(90, 1.5, 6, side="lower", relief="round"), Slot(110, 2.0, lean=-0.4))
    curve = PlaneCurve.spline([(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)])
    strip = Strip(optimal_rod(curve), CARD, max_width=30, slots=slots)
    record = BentSolid.of(strip)
    solid = occt.make_solid(record)
    assert measure.is_valid(solid)
    assert measure.volume(solid) == pytest.approx(strip.area * CARD.thickness, rel=1e-6)
    assert measure.area(occt.make_boundary(record.middle)) == pytest.approx(strip.area, rel=1e-6)


def arch_and_wall(angle, sheet="birch-plywood-0.8"):
    """An arch of plywood 0.8 mm thick, and a flat strip that passes it at an angle, as thick unless told."""
    ply = Sheet.named("birch-plywood-0.8")
    curve = PlaneCurve.arc((0, 0), 80, 0.4, np.pi - 0.4)
    arch = Placed(Strip(optimal_rod(curve), ply, max_width=20), (0, 0, 0), (1, 0, 0), (0, 1, 0))
    x = np.array([-np.sin(angle), np.cos(angle), 0.0])
    along = np.array([0.0, 80.0, 3.0]) - 30 * x
    tilt = 0.2 * np.array([0.0, 0.0, 1.0]) + np.cross([0, 0, 1], x)
    wall = Placed(Strip(Rod.straight(60.0), Sheet.named(sheet), max_width=22), along, x, tilt)
    return Model([arch, wall])


@pytest.mark.campaign
def test_exact_slots_let_the_other_strip_through(measure):
    """At 45 degrees: whole strips collide, slots of the paper's width still do, exact ones do not."""
    model = arch_and_wall(np.radians(45))
    assert common_volume(model, measure) > 10
    assert common_volume(model.interlock(clearance=0.0, fit="paper"), measure) > 1
    assert common_volume(model.interlock(clearance=0.1), measure) < 1e-6


@pytest.mark.campaign
@pytest.mark.parametrize("degrees", [45, 60])
def test_a_thick_strip_passes_one_that_is_bent_across_the_slot(degrees, measure):
    """3 mm through a radius of 80 mm: over half the slot's width the arch falls away by 0.15 mm and shifts it."""
    model = arch_and_wall(np.radians(degrees), "mdf-3")
    assert common_volume(model, measure) > 50
    slotted = model.interlock(clearance=0.1)
    assert common_volume(slotted, measure) < 1e-6
    angle = slotted.joints[0].angle[0]
    flat = 3.0 / np.sin(angle) + 0.8 / np.tan(angle) + 0.1
    assert 0 < slotted.strips[0].slots[0].widths.max() - flat < 0.35


@pytest.mark.campaign
@pytest.mark.parametrize("first", [0, 4, 9])
def test_neighbours_of_the_pavilion_do_not_collide(first, pavilion, measure):
    """With two, three and one bent slots between them, down to ten degrees: the two bent strips share nothing."""
    slotted = pavilion(11).interlock(clearance=0.1)
    pair = Model(slotted.placed[first : first + 2])
    assert common_volume(pair, measure) < 1e-6
