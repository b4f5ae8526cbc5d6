"""The flat part: widths, outline, tabs, strain, mass and reactions."""

from dataclasses import replace

import numpy as np
import pytest

import elastica_cad as ec
from elastica_cad import Hole, InputError
from elastica_cad.errors import StrainError
from elastica_cad.mechanics import RestCurvature
from elastica_cad.model import base_plate, slotted_frame
from elastica_cad.strip.coupon import coupon_drawing
from elastica_cad.strip.suggestions import suggest
from tests.refusals import refusal_test

pytestmark = pytest.mark.core
CARD = ec.Sheet.named("card-200gsm")


def tapered(length=100.0):
    s = np.linspace(0.0, length, 201)
    return ec.Rod.straight(length, 1 + (s / length) ** 2)


def test_width_is_proportional_to_stiffness():
    rod = tapered()
    strip = ec.Strip(rod, CARD, max_width=20.0)
    assert strip.width(rod.s) == pytest.approx(10.0 * rod.stiffness, rel=1e-9)
    assert ec.Strip(rod, CARD, min_width=7.0).width(0.0) == pytest.approx(7.0)


def test_outline_is_one_closed_anticlockwise_loop_with_two_splines():
    strip = ec.Strip(
        tapered(), CARD, max_width=20.0, ends=(ec.Tab(5), ec.Tab(8, width=6.0, corner_radius=1.0))
    )
    outline = strip.outline
    assert outline.closed
    assert sum(type(segment).__name__ == "Spline" for segment in outline.segments) == 2
    for here, following in zip(outline.segments, (*outline.segments[1:], outline.segments[0]), strict=True):
        assert here.end == pytest.approx(following.start, abs=1e-9)
    free = 10.0 * 100 * (1 + 1 / 3)
    assert outline.area == pytest.approx(free + 5 * 10 + 8 * 6 - (2 - np.pi / 2), rel=1e-9)


def test_holes_and_mass():
    tab = ec.Tab(10, holes=(Hole(5, 3.0),))
    strip = ec.Strip(ec.Rod.straight(100.0), CARD, max_width=20.0, ends=(tab, tab))
    assert len(strip.holes) == 2
    centres = sorted(float(np.mean(hole.bounds, axis=0)[0]) for hole in strip.holes)
    assert centres == pytest.approx([-5.0, 105.0])
    area = 120 * 20 - 2 * np.pi * 1.5**2
    assert strip.mass == pytest.approx(area * CARD.thickness * CARD.density * 1e-6)


def test_strain_of_an_arc_is_half_thickness_over_radius():
    strip = ec.Strip(ec.optimal_rod(ec.PlaneCurve.arc((0, 0), 50.0, 0.0, 2.0)), CARD, max_width=20.0)
    assert strip.max_strain == pytest.approx(CARD.thickness / 2 / 50.0)


def test_strain_counts_from_what_each_node_keeps():
    """A strip that was bent beyond its limit has a natural curvature of its own at each node."""
    drawn = ec.optimal_rod(ec.PlaneCurve.ellipse((0, 0), (60, 40), start=-0.5, end=1.0), samples=801)
    half = replace(drawn, natural_curvature=drawn.curvature / 2)
    fresh, kept = (ec.Strip(rod, CARD, max_width=20) for rod in (drawn, half))
    assert kept.max_strain == pytest.approx(fresh.max_strain / 2, rel=1e-4)
    assert kept.max_strain_at == pytest.approx(fresh.max_strain_at, abs=drawn.s[1])


def test_strain_beyond_the_limit_warns_with_place_and_radius():
    ply = ec.Sheet.named("birch-plywood-0.8")
    strip = ec.Strip(ec.optimal_rod(ec.PlaneCurve.arc((0, 0), 20.0, 0.0, 2.0)), ply, max_width=10.0)
    (text,) = strip.warnings
    assert "20 mm" in text
    assert ply.name in text


def test_reactions_balance():
    """Without weight the supports' forces and moments cancel (statics, computed from end positions only)."""
    curve = ec.PlaneCurve.ellipse((0, 0), (200.0, 100.0), 0.0, 0.1, 2.8)
    rod = ec.optimal_rod(curve)
    r = ec.Strip(rod, CARD, max_width=20.0).reactions()
    assert r.start_force + r.end_force == pytest.approx([0, 0], abs=1e-12)
    arm = rod.position[-1] - rod.position[0]
    torque = r.start_moment + r.end_moment + arm[0] * r.end_force[1] - arm[1] * r.end_force[0]
    assert torque == pytest.approx(0.0, abs=1e-6 * abs(r.end_moment))


@pytest.mark.parametrize(
    ("options", "words"),
    [
        ({}, "max_width or min_width"),
        ({"max_width": 0.0}, "a number above 0"),
        ({"max_width": float("nan")}, "a number above 0"),
        ({"max_width": 10.0, "min_width": 9.0}, "less than min_width"),
        ({"max_width": 10.0, "ends": (ec.Tab(5, corner_radius=6.0), ec.Tab(5))}, "corners"),
        ({"max_width": 10.0, "ends": (ec.Tab(5, holes=(Hole(2.5, 4.9),)), ec.Tab(5))}, None),
    ],
)
def test_bad_sizes_are_refused_in_one_sentence(options, words):
    if words is None:
        with pytest.raises(InputError, match="cuts the edge"):
            _ = ec.Strip(ec.Rod.straight(100.0), CARD, max_width=4.0, ends=options["ends"]).holes
        return
    with pytest.raises(InputError, match=words):
        _ = ec.Strip(tapered(), CARD, **options).outline


@pytest.mark.parametrize("least", np.round(np.linspace(10.1, 40.0, 23), 3).tolist())
def test_the_max_width_that_is_reported_will_do(least):
    """It had been rounded to the nearest figure: half of the time the same refusal followed."""
    rod = ec.Rod.straight(100.0, np.linspace(1, 1.0413, 201))
    with pytest.raises(InputError, match="less than min_width") as refusal:
        ec.Strip(rod, CARD, max_width=10.0, min_width=least)
    result = float(str(refusal.value).split("set max_width to ")[1].split(" mm")[0])
    assert ec.Strip(rod, CARD, max_width=result, min_width=least).width.extremes[0] < 1.001 * least


test_refusals = refusal_test(
    [
        (lambda: ec.Tab(5, holes=(Hole(1.0, 3.0),)), "does not fit"),
        (lambda: ec.Strip(ec.Rod.straight(100.0), CARD, max_width=20.0, engrave="漢"), "no '漢'"),
    ]
)


def test_as_built_is_bent_on_finer_nodes_than_the_design():
    """A design on too few nodes balances on them, but not between."""
    points = [(0, 40), (9, 92), (92, 172), (188, -14), (308, -14), (368, 112), (451, 60), (460, 26)]
    limits = ec.Limits(ratio=3.0, margin=5.0)
    rod = ec.nearest_rod(ec.PlaneCurve.spline(points), limits, gravity=CARD.gravity(), samples=101).rod
    assert np.abs(ec.bend(rod).position - rod.position).max() < 1e-3
    assert ec.Strip(rod, CARD, max_width=17.4).deviation_as_built > 0.1


@pytest.mark.parametrize(
    ("names", "engraved"),
    [
        ({"label": "A1"}, ["A1"]),
        ({"label": "Träger"}, ["Trager"]),
        ({"label": "A1", "engrave": "No. 7"}, ["No. 7"]),
        ({"label": "A1", "engrave": ""}, []),
    ],
)
def test_what_is_engraved_is_the_label_unless_reported(names, engraved):
    strip = ec.Strip(ec.Rod.straight(100.0), CARD, max_width=20.0, **names)
    assert strip.drawing().name == names["label"]
    assert [text.text for text in strip.drawing().texts] == engraved


@pytest.mark.parametrize(("label", "told"), [("A1", "<Strip 'A1' of "), ("", "<Strip of ")])
def test_a_strip_says_its_name_sheet_and_size(label, told):
    strip = ec.Strip(ec.Rod.straight(100.0), CARD, max_width=20.0, label=label)
    assert repr(strip).startswith(f"{told}{CARD.name}, 100 mm long, 20 ")


def test_a_jump_of_curvature_counts_with_both_sides():
    """The largest strain of a curve of degree 2 had changed by 0.3 % where it was run from the other end."""
    angles = np.linspace(0.2, 2.6, 7)
    radii = 100 + np.random.default_rng(0).uniform(-8, 8, 7)
    points = np.column_stack([-radii * np.cos(angles), radii * np.sin(angles)])
    drawn = ec.PlaneCurve(np.array([0.0, 0, 0, 1, 2, 3, 4, 5, 5, 5]), points, 2)
    there, back = (
        ec.Strip(ec.optimal_rod(curve), CARD, max_width=20.0) for curve in (drawn, drawn.reversed())
    )
    assert there.max_strain == pytest.approx(back.max_strain, rel=1e-12)
    assert there.max_strain_at == pytest.approx(there.rod.length - back.max_strain_at)


def _made_of(sheet):
    """Return functions that make each kind of flat part of a sheet."""
    rod = ec.optimal_rod(ec.PlaneCurve.ellipse((0, 0), (100, 60), start=0.2, end=2.9))
    placed = [
        ec.Placed(ec.Strip(rod, "birch-plywood-0.8", max_width=20), (0, y, -7), (1, 0, 0), (0, 0, 1))
        for y in (0, 50, 100)
    ]
    return {
        "strip": lambda: ec.Strip(rod, sheet, max_width=8),
        "perforated": lambda: ec.Strip(rod, sheet, style=ec.Perforated(width=60, columns=9, rows=1)),
        "backing": lambda: ec.Laminated(width=20, backing=sheet),
        "coupon": lambda: coupon_drawing(ec.Sheet.of(sheet)),
        "plate": lambda: base_plate(placed, sheet),
        "frame": lambda: slotted_frame(placed, sheet),
    }


@pytest.mark.parametrize("part", ["strip", "perforated", "backing", "coupon", "plate", "frame"])
def test_no_flat_part_is_cut_from_a_rod(part):
    with pytest.raises(ec.InputError, match="glass-rod-4 is a rod, so no flat part can be cut from it"):
        _made_of("glass-rod-4")[part]()


@pytest.mark.parametrize("unit_mm", [10.0, 25.4, 1000.0])
def test_the_unit_of_a_curve_is_requested_where_it_is_far_too_small(unit_mm):
    arch = ec.PlaneCurve.spline([(0, 0), (60, 120), (140, 150), (240, 100), (300, 0)])
    small = arch.transformed(np.diag([1 / unit_mm, 1 / unit_mm, 1.0]))
    with pytest.raises(InputError, match="was the curve drawn in cm, inches or metres"):
        ec.make_strip(small, "birch-plywood-0.8", max_width=40 / unit_mm)
    tight = ec.PlaneCurve.spline([(0, 0), (200, 0), (220, 10), (200, 20), (0, 20)])
    with pytest.raises(InputError, match="The strain is") as refused:
        ec.make_strip(tight, "birch-plywood-0.8", max_width=40)
    assert "inches" not in str(refused.value)


ARCH = ec.PlaneCurve.spline([(0, 0), (60, 120), (140, 150), (240, 100), (300, 0)])


@pytest.mark.parametrize("unit_mm", [10.0, 25.4, 1000.0])
def test_a_curve_in_another_unit_is_not_to_be_drawn_larger(unit_mm):
    small = ARCH.transformed(np.diag([1, 1, unit_mm]))
    spec = ec.StripSpec(small, "birch-plywood-0.8", max_width=40 / unit_mm)
    with pytest.raises(StrainError, match="inches") as refused:
        spec.make()
    assert "size" not in [suggestion.change.field for suggestion in suggest(spec, refused.value)]


@pytest.mark.parametrize("curvature", [1.25, -3.0, 1e9, RestCurvature.linear([0, 200, 400], [0, 1.3, 0])])
def test_a_strip_is_not_pre_bent_to_a_radius_of_its_thickness(curvature):
    arch = ec.PlaneCurve.spline([(0, 0), (60, 120), (140, 150), (240, 100), (300, 0)])
    with pytest.raises(InputError, match=r"pre-bent to a radius of .* thickness of the sheet, 0.8 mm"):
        ec.StripSpec(arch, "birch-plywood-0.8", max_width=40, natural_curvature=curvature)
    ec.StripSpec(arch, "birch-plywood-0.8", max_width=40, natural_curvature=1.2)
