"""Strips whose stiffness is a thickness or a diameter, and heavy strips that bend as plates."""

import dataclasses

import numpy as np
import pytest

from elastica_cad import (
    Frame,
    Hole,
    InputError,
    Keep,
    Limits,
    Model,
    Placed,
    PlaneCurve,
    PointMass,
    Sheet,
    Slot,
    StripSpec,
    Tab,
    make_strip,
    optimal_rod,
)
from elastica_cad.mechanics import LeavesLaw, PlainSection, RoundLaw, ThicknessLaw
from elastica_cad.model import EndFixture, LeafStack
from elastica_cad.strip import BentSolid, FlatSolid
from elastica_cad.strip.solids import bent_sheets
from tests.refusals import refusal_test

pytestmark = pytest.mark.core

GLASS = Sheet("glass", 3.0, 38000.0, density=1900.0, max_strain=0.02)
CARD = Sheet.named("card-200gsm")
ARCH = PlaneCurve.spline([(0, 0), (60, 120), (140, 160), (240, 120), (300, 0)])
THICKNESS = ThicknessLaw(GLASS, 1.0, 4.0, width=20.0)
ROD = RoundLaw(GLASS, 1.0, 4.0)
TUBE = RoundLaw(GLASS, 1.0, 4.0, bore=0.6)
PLY = Sheet.named("birch-plywood-3")


@pytest.mark.parametrize("law", [THICKNESS, ROD, TUBE], ids=["thickness", "rod", "tube"])
@pytest.mark.parametrize(
    "options", [{}, {"gravity": True}, {"limits": Limits(margin=2.0)}], ids=["light", "heavy", "near"]
)
def test_the_size_gives_the_stiffness_and_the_strip_its_shape(law, options):
    strip = make_strip(ARCH, GLASS, section=law, **options)
    table = strip.table()
    size = table[f"{law.quantity}_mm"]
    EI = law.bending_stiffness(size)
    assert table["moment_Nmm"] == pytest.approx(EI * table["curvature_1_per_mm"], rel=1e-4, abs=1e-3)
    assert size.max() == pytest.approx(4.0, rel=1e-3)
    assert table["strain"] == pytest.approx(size / 2 * np.abs(table["curvature_1_per_mm"]))
    assert strip.held_deviation < 1e-5 * strip.rod.length
    assert strip.max_strain == pytest.approx(table["strain"].max(), rel=1e-3)


def test_the_body_is_as_thick_as_the_law_says_and_weighs_what_the_strip_does():
    strip = make_strip(ARCH, GLASS, section=THICKNESS)
    flat, (bent,) = FlatSolid.of(strip), BentSolid.layers(strip)
    assert flat.volume == pytest.approx(strip.mass / GLASS.density * 1e6, rel=1e-6)
    assert bent.volume == pytest.approx(flat.volume, rel=1e-6)  # faces off a curve: Pappus
    points = flat.outline.segments[3].curve.at(np.array([50.0, 200.0])).position
    assert -2 * points[:, 1] == pytest.approx(strip.layout.size(points[:, 0]), rel=1e-6)
    frame = Frame((5.0, 6.0, 7.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0))
    (placed,) = BentSolid.layers(strip, frame)
    assert frame.local(placed.joints["end"].origin) == pytest.approx([300.0, 0.0, 0.0], abs=1e-9)
    assert FlatSolid.of(strip).joints["end"].origin[0] == pytest.approx(strip.rod.length)


def test_a_radius_below_half_the_thickness_has_no_body():
    bow = PlaneCurve.ellipse((0, 0), (3.0, 3.2), start=0.0, end=np.pi)
    strip = make_strip(bow, GLASS, section=ThicknessLaw(GLASS, 1.0, 8.0, width=20.0), ignore_limits=True)
    with pytest.raises(InputError, match="radius below half its thickness"):
        BentSolid.layers(strip)


@pytest.mark.parametrize(("law", "faces"), [(ROD, 8), (TUBE, 14)], ids=["rod", "tube"])
def test_a_round_body_is_closed_and_as_thick_as_the_law_says(law, faces):
    strip = make_strip(ARCH, GLASS, section=law)
    for body in (FlatSolid.of(strip), *BentSolid.layers(strip)):
        skin = body.boundary
        assert skin.is_closed
        assert len(skin.faces) == faces
    points = FlatSolid.of(strip).boundary.faces[2].surface.control_points
    # the ring's first row lies off the axis by the radius
    assert np.abs(points[0, :, 2] - 2.0).max() == pytest.approx(2.0, rel=1e-3)


@pytest.mark.parametrize(
    "options",
    [{"max_width": 20.0}, {"slots": (Slot(40.0, 1.2),)}, {"ends": (Tab(10, holes=(Hole(5, 3),)), Tab(10))}],
    ids=["width", "slots", "tabs"],
)
def test_what_a_law_leaves_no_room_for_is_refused(options):
    with pytest.raises(InputError, match="sets the width and thickness of the whole strip"):
        StripSpec(ARCH, GLASS, section=THICKNESS, **options)


test_refusals = refusal_test(
    [
        (
            lambda: StripSpec(ARCH, CARD, section=THICKNESS),
            "section .* uses the sheet glass, but the strip uses card-200gsm",
        ),
        (lambda: make_strip(ARCH, LEAF, section=LEAVES), r"use the nearest curve \(limits\)"),
        (lambda: LeafStack(make_strip(ARCH, GLASS, section=THICKNESS)), "the strip has no plies"),
        (
            lambda: EndFixture.of(make_strip(ARCH, LEAF, section=LEAVES, keep=Keep()), "start"),
            "clamp the ends of the stack",
        ),
    ]
)


def test_a_mass_hangs_on_a_tapered_strip():
    strip = make_strip(ARCH, GLASS, section=THICKNESS, gravity=True, loads=(PointMass(150.0, 200.0),))
    pull = strip.reactions()
    total = (strip.rod.length * 0 + strip.mass - strip.layout.section.weight_per_length(
        strip.layout.size([0.0, strip.rod.length])).sum() * 10 / 9.80665e-3 + 200.0) * 9.80665e-3  # fmt: skip
    assert pull.start_force[1] + pull.end_force[1] == pytest.approx(total, rel=1e-3)


@pytest.mark.parametrize("limits", [(0.0, 40.0), (20.0, np.inf)], ids=["widest", "narrowest"])
def test_a_wide_heavy_strip_carries_its_weight_as_a_plate(limits):
    """With the stiffness of a beam the strip as made strays ten times as far."""
    half = ARCH.transformed(np.diag([0.5, 0.5, 1.0]))
    plate = make_strip(half, CARD, gravity=True, section=PlainSection(CARD, *limits))
    widest = float(plate.width.extremes[1])
    beam = make_strip(half, CARD, gravity=True, max_width=widest)
    assert widest == pytest.approx(40.0, rel=1e-4) or plate.width.extremes[0] == pytest.approx(20.0, rel=1e-4)
    assert plate.held_deviation < 1e-5 * plate.rod.length
    assert beam.held_deviation > 10 * plate.held_deviation


LEAF = Sheet("ash leaf", 0.6, 12000.0, density=680.0, max_strain=0.02)
LEAVES = LeavesLaw(LEAF, 4, 20.0)


def test_a_strip_of_leaves_is_cut_and_laid_leaf_by_leaf():
    strip = make_strip(ARCH, LEAF, section=LEAVES, keep=Keep(), ends=(Tab(10), Tab(5)), label="bow")
    section, length = strip.layout.section, strip.rod.length
    table = strip.table()
    assert table["thickness_mm"] == pytest.approx(0.6 * section.counts(strip.rod.s))
    assert [layer.name for layer in strip.layers][:2] == ["", "leaf 2"]
    for layer, leaf in zip(strip.layers, section.leaves, strict=True):
        (left, low), (right, high) = layer.outline.bounds
        assert (high - low, layer.low) == (20.0, pytest.approx(0.6 * (leaf.number - 1)))
        assert left == pytest.approx(leaf.start if leaf.start else -10.0)
        assert right == pytest.approx(leaf.end if leaf.end < length else length + 5.0)
    assert strip.mass == pytest.approx(sum(layer.area for layer in strip.layers) * 0.6 * 680e-6)
    flat, bent = FlatSolid.layers(strip), BentSolid.layers(strip)
    assert len(flat) == len(bent) == len(strip.layers) == len(bent_sheets(strip))
    for one, other, layer in zip(flat, bent, strip.layers, strict=True):
        assert one.volume == pytest.approx(layer.area * 0.6)
        assert other.boundary.is_closed
        assert other.heights == pytest.approx((layer.low - 0.3, layer.high - 0.3))
    assert strip.held().parts == {
        "ends of leaves": pytest.approx(1.217, rel=0.03)
    }  # bent in CalculiX, nu = 0
    assert strip.max_strain <= LEAF.max_strain
    assert strip.end_thicknesses == pytest.approx(tuple(0.6 * section.counts([0.0, length])))
    stack = LeafStack(strip)
    assert stack.cut_list.mass == pytest.approx(strip.mass)
    assert len(stack.drawing.on("CUT_OUTER")) == len(section.leaves)
    marks = [path.bounds[0, 0] for path in stack.drawing.on("MARK")]
    assert set(np.round(marks, 6)) <= {round(s, 6) for leaf in section.leaves for s in (leaf.start, leaf.end)}
    assert len(marks) >= section.steps.size


def test_a_heavy_strip_of_leaves_carries_them():
    soft = Sheet("soft leaf", 0.6, 900.0, density=1150.0, max_strain=0.05)
    strip = make_strip(
        ARCH, soft, section=LeavesLaw(soft, 4, 20.0), keep=Keep(), gravity=True, ends=(Tab(0), Tab(0))
    )
    pull = strip.reactions()
    assert pull.start_force[1] + pull.end_force[1] == pytest.approx(strip.mass * 9.80665e-3, rel=1e-5)


@pytest.mark.parametrize("law", [THICKNESS, ROD, TUBE], ids=["thickness", "rod", "tube"])
def test_a_tapered_strip_stays_in_its_plane_by_its_own_sizes(law):
    """The sheet's thickness says nothing: a material ten times as thick is judged the same."""
    thick = dataclasses.replace(GLASS, thickness=30.0)
    one, other = (
        make_strip(ARCH, sheet, section=dataclasses.replace(law, sheet=sheet)).sideways
        for sheet in (GLASS, thick)
    )
    assert one == other
    assert one.decided
    assert make_strip(ARCH, GLASS, section=law).end_thicknesses[0] != 3.0


@pytest.mark.parametrize("law", [THICKNESS, ROD, TUBE], ids=["thickness", "rod", "tube"])
def test_the_cut_list_names_stock_of_which_it_can_be_worked(law):
    strip = make_strip(ARCH, GLASS, section=law, label="T")
    (row,) = Model([Placed(strip)]).cut_list().rows
    assert row.thickness == pytest.approx(
        4.0, rel=1e-3
    )  # as thick as it ever is, not as the sheet that was named
    assert row.sheet == "glass-4"
    assert row.mass == pytest.approx(strip.mass)
    assert "_4mm_" in row.file


def test_tapers_that_differ_are_no_equal_parts():
    lean = PlaneCurve.spline([(0, 0), (30, 150), (140, 160), (240, 100), (300, 0)])
    first = make_strip(ARCH, GLASS, section=THICKNESS)
    length = first.rod.length / make_strip(lean, GLASS, section=THICKNESS).rod.length
    other = make_strip(lean.transformed(np.diag([length, length, 1.0])), GLASS, section=THICKNESS)
    assert other.rod.length == pytest.approx(first.rod.length)  # one outline for both: a rectangle
    assert Model([Placed(first), Placed(first, (0, 0, 50))]).cut_list().rows[0].count == 2
    parts = Model([Placed(first), Placed(other, (0, 0, 50))]).parts
    assert [part.count for part in parts] == [1, 1]


@pytest.mark.campaign
@pytest.mark.parametrize("ratio", [None, 3.0, 8.0])
@pytest.mark.parametrize("gravity", [None, True], ids=["light", "heavy"])
@pytest.mark.parametrize(
    "law", [ThicknessLaw(PLY, 1.0, 3.0, width=20.0), RoundLaw(PLY, 1.0, 3.0)], ids=["strip", "rod"]
)
def test_a_near_taper_bears_its_bend(law, gravity, ratio):
    """The thinnest section bears the sharpest bend of the arch, the thickest does not: in between lies a taper."""
    made = make_strip(ARCH, PLY, section=law, gravity=gravity, limits=Limits(ratio=ratio))
    s = np.linspace(0.0, made.rod.length, 2001)
    size, bend = made.layout.size(s), np.abs(made.rod.bend_at(s))
    sharpest = np.abs(ARCH.sample(2001).curvature).max()
    assert 0.5 * 1.0 * sharpest < PLY.max_strain < 0.5 * 3.0 * sharpest
    assert np.abs(made.rod.position - ARCH.sample(made.rod.s.size).position).max() < 1e-3
    assert (0.5 * size * bend).max() <= PLY.max_strain * (1 + 1e-4)
    assert not any("strain" in text for text in made.warnings)
    if (
        gravity is None
    ):  # it may be of any size: the thickest that bears the bend, as even as the curve lets it be
        assert made.rod.ratio == pytest.approx(optimal_rod(ARCH).ratio, rel=0.01)
        assert (0.5 * size * bend).max() == pytest.approx(PLY.max_strain, rel=1e-4)
