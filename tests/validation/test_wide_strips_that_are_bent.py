"""Wide strips led elsewhere, against shapes, forces, margins and limits of scipy with a moment of their own."""

from dataclasses import replace

import numpy as np
import pytest

from elastica_cad import (
    InputError,
    PlaneCurve,
    Profile,
    Rod,
    Sheet,
    Strip,
    bend,
    bend_strip,
    make_strip,
    stability,
    stability_limit,
)
from elastica_cad.mechanics import (
    Imperfection,
    PlainSection,
    ToleranceRanges,
    bend_path,
    perturb_rod,
    tolerance_study,
)
from elastica_cad.mechanics.rod import CurlingLaw, resample
from elastica_cad.mechanics.sections import SheetCurl
from elastica_cad.mechanics.sideways import SidewaysSection, sideways_stability_of, stations_of_sideways
from elastica_cad.strip.strip import strip_sideways

pytestmark = pytest.mark.core

AGREES = 0.001
"""Of forces and of how far a strip is moved; they had been 1 to 10 % and 0.03 to 0.45 % off."""

DRAWN = {
    "arch": [(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)],
    "S": [(0, 0), (50, 60), (100, 10), (150, -40), (200, 20)],
}
STRIPS = {  # length, thickness and widest place in mm, Poisson's ratio
    "narrow": (300.0, 0.8, 20.0, 0.3),
    "wide": (300.0, 0.8, 60.0, 0.3),
    "thick": (900.0, 3.0, 60.0, 0.3),
    "stubborn": (300.0, 2.0, 40.0, 0.37),
}


def ply(thickness, nu):
    return Sheet("ply", thickness, 9000.0, 680.0, max_strain=0.05, poisson_ratio=nu)


def made_of(curve, length, thickness, width, nu, **more):
    drawn = PlaneCurve.spline(DRAWN[curve], degree=4)
    drawn = drawn.transformed(np.diag([1.0, 1.0, drawn.length / length]))
    return make_strip(drawn, ply(thickness, nu), max_width=width, ignore_limits=True, **more)


def on_the_way(rod, share):
    """The end brought to a share of its distance from the start."""
    return rod.position[0] + share * (rod.position[-1] - rod.position[0])


@pytest.mark.parametrize("strip", STRIPS)
@pytest.mark.parametrize(("curve", "share"), [("arch", 0.5), ("arch", 1.2), ("S", 0.25)])
def test_a_strip_whose_end_is_led_elsewhere(curve, share, strip, wide_strips):
    made = made_of(curve, *STRIPS[strip])
    end = on_the_way(made.rod, share)
    bent = bend(made.rod, end=end)
    own = wide_strips.OwnStrip.cut(made.width, made.sheet).bent(bent, end=end)
    moved = np.hypot(*(own.position - made.rod.position).T).max()
    assert np.hypot(*(bent.position - own.position).T).max() < 2e-4 * moved
    B = made.bending_stiffness
    assert B * bent.moment == pytest.approx(own.moment, abs=AGREES * np.abs(own.moment).max())
    assert -B * bent.force == pytest.approx(own.force, abs=AGREES * np.abs(own.force).max())
    assert bent.curvature == pytest.approx(own.curvature, abs=AGREES * np.abs(own.curvature).max())


def test_every_step_of_a_path_reports_newtons_and_millijoules(wide_strips):
    made = made_of("arch", *STRIPS["stubborn"])
    ends = [on_the_way(made.rod, share) for share in (0.8, 0.6, 0.4)]
    travel = bend_strip(made, ends)
    # the strip is also compressed along its length
    assert travel.rods[1].position == pytest.approx(bend_path(made.rod, ends)[1].position, abs=5e-3)
    strip = wide_strips.OwnStrip.cut(made.width, made.sheet)
    for k, end in enumerate(ends):
        own = strip.bent(travel.rods[k], end=end)
        assert travel.end_force[k] == pytest.approx(own.force[-1], abs=AGREES * np.hypot(*own.force[-1]))
        assert travel.end_moment[k] == pytest.approx(own.moment[-1], rel=AGREES)
    # what the hand puts in is what the strip stores
    fine = bend_strip(made, [on_the_way(made.rod, share) for share in np.linspace(0.99, 0.4, 60)])
    work = np.sum((fine.force_along[1:] + fine.force_along[:-1]) / 2 * np.diff(fine.travel))
    assert fine.energy[-1] - fine.energy[0] == pytest.approx(work, rel=2e-4)


@pytest.mark.parametrize(("curve", "strip"), [("arch", "thick"), ("arch", "stubborn"), ("S", "narrow")])
def test_its_margin_is_that_of_what_a_small_bend_more_takes(curve, strip, wide_strips):
    """By dM/dkappa, which is up to 8 % more than M/kappa; of the design, and led elsewhere."""
    made = made_of(curve, *STRIPS[strip])
    own, B = wide_strips.OwnStrip.cut(made.width, made.sheet), made.bending_stiffness
    for rod in (made.rod, bend(made.rod, end=on_the_way(made.rod, 0.8))):
        margin = own.margin(rod.s, own.bent(rod, end=rod.position[-1]), B)
        assert stability(rod).margin == pytest.approx(margin, rel=AGREES)


def test_its_conjugate_point_is_where_a_shorter_piece_would_give(wide_strips):
    """An S pushed together in its second mode, which does not stay."""
    sheet = ply(2.0, 0.37)
    flat = Rod.straight(300.0, [3.0, 1.0, 1.5], samples=601, section=PlainSection(sheet, 0.0, 40.0))
    bent = bend(flat, end=(210.0, 0.0), mode=2)
    found = stability(bent)
    assert not found.stable
    strip = Strip(flat, sheet)
    own = wide_strips.OwnStrip.cut(strip.width, sheet)
    shape = own.bent(bent, end=bent.position[-1])
    assert found.margin == pytest.approx(own.margin(bent.s, shape, strip.bending_stiffness), rel=AGREES)
    place = own.conjugate_point(bent.s, shape, strip.bending_stiffness)
    assert found.conjugate_point == pytest.approx(place, rel=AGREES)


def test_the_load_that_makes_it_snap(wide_strips):
    """An arch of acrylic under its own weight, 30 times as heavy."""
    drawn = PlaneCurve.spline(DRAWN["arch"], degree=4)
    drawn = drawn.transformed(np.diag([1.0, 1.0, drawn.length / 900.0]))
    made = make_strip(drawn, "acrylic-2", max_width=75.0, gravity=True, ignore_limits=True)
    found = stability_limit(made.rod, [60.0])
    assert found.kind == "snap"
    own = wide_strips.OwnStrip.cut(made.width, made.sheet, heavy=True)
    limit = own.limit(
        made.rod, near_limit(made, found, wide_strips), lambda t: (t, made.rod.position[-1]), found.at["load"]
    )
    assert found.at["load"] == pytest.approx(limit, rel=AGREES)


@pytest.mark.campaign
def test_the_way_on_which_it_gives(wide_strips):
    """An S whose end is pushed towards its start turns over."""
    made = made_of("S", *STRIPS["stubborn"])
    way = made.rod.position[0] + [1.0, 1.0] - made.rod.position[-1]
    found = stability_limit(made.rod, [{"end": made.rod.position[-1] + way}])
    limit = wide_strips.OwnStrip.cut(made.width, made.sheet).limit(
        made.rod,
        near_limit(made, found, wide_strips),
        lambda t: (1.0, made.rod.position[-1] + t * way),
        found.parameter,
    )
    assert found.parameter == pytest.approx(limit, rel=AGREES)


def near_limit(made, found, wide_strips):
    rod, B = found.before, made.bending_stiffness
    return wide_strips.Bent(rod.position, rod.angle, rod.curvature, B * rod.moment, -B * rod.force)


def test_a_flat_strip_stiffens_as_it_is_bent(wide_strips):
    """Straight at first, so E I is that of a beam; pushed together it is a plate's where it is sharply bent."""
    sheet = ply(1.0, 0.3)
    flat = Rod.straight(400.0, [1.0, 2.0, 1.0], samples=401, section=PlainSection(sheet, 0.0, 60.0))
    bent = bend(flat, end=(200.0, 0.0))
    strip = Strip(flat, sheet)
    own = wide_strips.OwnStrip.cut(strip.width, sheet).bent(bent, end=bent.position[-1])
    assert np.hypot(*(bent.position - own.position).T).max() < 0.01
    push = np.hypot(*own.force[0])
    assert strip.bending_stiffness * np.hypot(*bent.force[0]) == pytest.approx(push, rel=AGREES)
    assert flat.with_stiffness(flat.stiffness).bending_law is not None
    even = replace(flat, section=None)
    assert strip.bending_stiffness * np.hypot(*bend(even, end=(200.0, 0.0)).force[0]) < 0.96 * push


@pytest.mark.parametrize("samples", [151, 1201])
def test_it_can_be_put_on_other_nodes(samples):
    made = made_of("S", *STRIPS["stubborn"])
    bent = bend(made.rod, end=on_the_way(made.rod, 0.6))
    assert isinstance(bent.law, CurlingLaw)
    other = bend(resample(bent, samples), end=bent.position[-1])
    assert other.s.size == samples
    at = np.interp(bent.s, other.s, other.moment)
    assert at == pytest.approx(bent.moment, abs=1e-3 * np.abs(bent.moment).max())
    assert bend(bent, samples=samples).position == pytest.approx(other.position, abs=1e-8)


@pytest.mark.parametrize("options", [{}, {"gravity": True}, {"natural_curvature": 0.002}])
def test_the_flat_part_is_the_same_however_it_is_bent(options):
    """A strip made of the bent rod was a tenth narrower in places, and a heavy one was refused."""
    made = made_of("arch", *STRIPS["stubborn"], **options)
    bent = bend(made.rod, end=on_the_way(made.rod, 0.5))
    moved = replace(made, rod=bent)
    assert moved.width(made.rod.s) == pytest.approx(made.width(made.rod.s), rel=1e-5)
    assert moved.mass == pytest.approx(made.mass, rel=1e-5)
    assert moved.rod.law is None
    B, before = moved.bending_stiffness, made.bending_stiffness
    assert B * moved.rod.moment == pytest.approx(before * bent.moment, rel=1e-6)
    assert B * moved.rod.nodal_load == pytest.approx(before * made.rod.nodal_load, rel=1e-9)
    assert bend(moved.rod).position == pytest.approx(bent.position, abs=1e-7)


def test_it_weighs_as_its_width(wide_strips):
    """A strip that was made without its weight sags: not as its stiffness says, which has the plate's in it."""
    drawn = PlaneCurve.spline(DRAWN["S"], degree=4)
    drawn = drawn.transformed(np.diag([1.0, 1.0, drawn.length / 900.0]))
    sheet = replace(Sheet.named("acrylic-2"), density=4000.0, density_range=None)
    made = make_strip(drawn, sheet, max_width=75.0, ignore_limits=True)
    sagging = bend(made.rod, gravity=sheet.gravity())
    own = wide_strips.OwnStrip.cut(made.width, sheet, heavy=True).bent(sagging)
    sag = np.hypot(*(own.position - made.rod.position).T).max()
    assert np.hypot(*(sagging.position - own.position).T).max() < 5e-3 * sag
    assert replace(made, rod=sagging).rod.nodal_load.sum() * replace(made, rod=sagging).bending_stiffness == (
        pytest.approx(sagging.nodal_load.sum() * made.bending_stiffness, rel=1e-6)
    )


@pytest.mark.parametrize("share", [1.0, 0.5])
def test_edgewise_and_in_twist_it_is_as_stiff_as_its_width(share):
    """E h w^3 / 12 and G w h^3 / 3: what it gains across as a plate had been counted there too."""
    made = made_of("arch", *STRIPS["stubborn"])
    sheet, rod = made.sheet, bend(made.rod, end=on_the_way(made.rod, share))
    s = stations_of_sideways(rod)
    beam = sheet.bending_stiffness(1.0) * made.width(s) / made.bending_stiffness
    section = SidewaysSection.rectangle(
        beam, made.width(s), np.full(s.size, sheet.thickness), sheet.shear_ratio
    )
    own = sideways_stability_of(rod, section).margin
    assert strip_sideways(rod, made.layout).margin == pytest.approx(own, rel=1e-4)


OTHERWISE = {
    "narrower": Imperfection(width_loss=2.0),
    "thicker": Imperfection(thickness=1.1),
    "thinner and narrower": Imperfection(thickness=0.9, width_loss=1.0),
    "more even": Imperfection(stiffness_range=0.7),
    "clamps turned": Imperfection(start_angle=0.05, end_angle=-0.03),
}


@pytest.mark.parametrize("how", OTHERWISE)
@pytest.mark.parametrize("heavy", [False, True])
def test_a_strip_that_came_out_otherwise(how, heavy, wide_strips):
    """Light ones do not feel the modulus, but a thinner sheet bends as a plate sooner."""
    made, v = made_of("arch", *STRIPS["stubborn"], gravity=heavy), OTHERWISE[how]
    sheet, rod = made.sheet, made.rod
    h, nu = sheet.thickness, sheet.poisson_ratio
    width = made.width(rod.s)
    stiff = width * wide_strips.ashwell(width, rod.curvature, h, nu)
    stiff *= (1 + (rod.stiffness - 1) * v.stiffness_range) / rod.stiffness
    for _ in range(40):
        width = stiff / wide_strips.ashwell(width, rod.curvature, h, nu)
    cut = Profile.interpolate(rod.s, width - v.width_loss)
    other = replace(sheet, thickness=h * v.thickness)
    found = perturb_rod(rod, v, max_width=40.0)
    own = wide_strips.OwnStrip.cut(cut, other, heavy=heavy).bent(found)
    strayed = np.hypot(*(own.position - rod.position).T).max()
    # of 300 mm, what 601 nodes leave
    assert np.hypot(*(found.position - own.position).T).max() < AGREES * strayed + 2e-4


def test_a_study_requests_thickness_and_kerf_where_a_strip_bends_as_a_plate():
    made = made_of("arch", *STRIPS["stubborn"])
    ranges = ToleranceRanges(width_loss=(0.0, 2.0), thickness=(0.9, 1.1))
    study = tolerance_study(made.rod, ranges=ranges, max_width=40.0, samples=2)
    worst = perturb_rod(made.rod, Imperfection(width_loss=2.0), max_width=40.0)
    strayed = np.hypot(*(worst.position - made.rod.position).T).max()
    assert study["kerf"].worst == pytest.approx(strayed, rel=1e-12)
    assert study["thickness"].worst > 2e-3
    beam = replace(made.rod, section=None)
    assert tolerance_study(beam, ranges=ranges, samples=2)["thickness"].worst == 0.0
    narrow = float(made.width(made.rod.s).min())
    with pytest.raises(InputError, match=f"the least width, {narrow:.4g} mm"):
        perturb_rod(made.rod, Imperfection(width_loss=39.9), max_width=40.0)


def test_what_has_yielded_stays_in_a_plate():
    """Bent by more than its skin bears, to be let go: the moment is that of what is left of the bend."""
    made = made_of("arch", *STRIPS["stubborn"])
    rod = made.rod
    limit = 0.8 * float(np.abs(rod.curvature).max())
    found = perturb_rod(rod, Imperfection(yield_curvature=limit))
    kept = np.sign(rod.curvature) * np.maximum(np.abs(rod.curvature) - limit, 0.0)
    assert found.natural_curvature == pytest.approx(kept, abs=1e-15)
    width = made.width(rod.s)
    at = SheetCurl(width, made.sheet.thickness, 0.37)
    moment = rod.stiffness * (found.curvature - kept) * at(found.curvature) / at(rod.curvature)
    assert found.moment == pytest.approx(moment, abs=1e-5 * np.abs(moment).max())
