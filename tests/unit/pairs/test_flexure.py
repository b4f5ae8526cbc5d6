"""Parts with two states: thickness, strain, outline, holder, the push from state to state, and what is refused."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from elastica_cad import Flexure, InputError, PlaneCurve, Sheet, bend
from elastica_cad.errors import StrainError
from elastica_cad.geometry import Spline
from elastica_cad.geometry.path import distances
from elastica_cad.pairs import FlexureSpec, Pad
from elastica_cad.pairs.flexure import LEAST_CUT_MM, curved_beam_factor, root_factors
from elastica_cad.pairs.pushed_rod import push_path
from elastica_cad.pairs.summary import pair_rows
from elastica_cad.strip.lettering import text_strokes

pytestmark = pytest.mark.core

POM = Sheet.named("pom-3")


def arch(rise: float, width: float = 150.0) -> PlaneCurve:
    """With level ends."""
    x = width * np.array([0, 0.18, 0.35, 0.7, 0.82, 1])
    return PlaneCurve.spline(np.column_stack([x, [0, 0, rise, rise, 0, 0]]), degree=4)


@pytest.fixture(scope="module")
def clip() -> Flexure:
    """A bistable part."""
    return FlexureSpec(arch(24), arch(-20), POM, label="CLIP").make()


@pytest.fixture(scope="module")
def low() -> Flexure:
    """A shallow, thick part, bistable too."""
    return FlexureSpec(arch(8), arch(-6.5), POM, least_thickness=1.72).make()


@pytest.fixture(scope="module")
def stand() -> Flexure:
    """A part with two settings of its end."""
    first = PlaneCurve.spline([(0, 0), (40, 0), (62, 22), (72, 52), (89, 99)], degree=4)
    second = PlaneCurve.spline([(0, 0), (40, 0), (66, 15), (90, 40), (122, 72)], degree=4)
    return FlexureSpec(first, second, "pla-4", printed=True, least_thickness=2.0).make()


def test_thickness_makes_the_stiffness(clip):
    rod = clip.pair.first
    h = clip.thickness_at(rod.s)
    bending = POM.youngs_modulus * POM.thickness * h**3 / 12
    assert bending == pytest.approx(clip.bending_stiffness * rod.stiffness, rel=1e-5)
    assert h.min() == pytest.approx(clip.thickness_range[0])


def test_what_the_way_requests_decides_how_thick_a_bistable_part_is(clip):
    assert max(clip.strain) < clip.travel.strain.max() <= POM.max_strain
    assert clip.travel.strain.max() > 0.9 * POM.max_strain
    assert clip.warnings == ()


def test_the_default_thickness_keeps_the_strain_of_its_own_path_within_the_limit():
    part = FlexureSpec(arch(13, 180.0), arch(-12, 180.0), POM).make()
    assert part.bistable
    assert 0.9 * POM.max_strain < part.travel_strain <= POM.max_strain


def test_a_force_is_listed_with_what_thickness_and_sheet_leave_open(clip):
    """Against the same part made a tenth of a mm thinner and thicker."""
    low, high = clip.force_range
    softest, stiffest = np.array(POM.youngs_modulus_range) / POM.youngs_modulus
    for off, result in ((-0.1, low / softest), (0.1, high / stiffest)):
        other = Flexure(clip.pair, POM, least_thickness=clip.scale + off, ignore_limits=True)
        assert result == pytest.approx(other.travel.largest_force, rel=0.04)
    assert f"about {clip.travel.largest_force:.2g} N ({low:.2g} to {high:.2g} N" in str(clip.force_text)


def test_curved_beams_are_strained_more_inside():
    """Against the stress of a ring's inner side, r d(angle), integrated over the section."""
    h, R = 0.2, 1.0
    y = np.linspace(-h / 2, h / 2, 20001)
    shift = -np.mean(y / (R + y)) / np.mean(1 / (R + y))
    strain = (y + shift) / (R + y)  # no force in all
    moment = np.sum(strain * y) * (y[1] - y[0])
    straight = moment / (h**3 / 12) * h / 2
    assert np.abs(strain[0]) / straight == pytest.approx(curved_beam_factor(np.array([h / R]))[0], rel=1e-3)


@pytest.mark.parametrize(
    ("radius", "bending", "tension"),
    [(0.05, 2.522, 3.68), (0.1, 1.955, 2.814), (0.2, 1.574, 2.107), (0.5, 1.270, 1.521), (1, 1.138, 1.268)],
)
def test_notch_factors_of_a_root_are_those_of_finite_elements(radius, bending, tension):
    """Of triangles of six nodes, ten sides to the radius, in plane stress."""
    assert root_factors(radius) == pytest.approx((bending, tension), rel=0.012)


def test_the_outline_is_one_closed_chain_of_splines_arcs_and_lines(clip):
    splines = [one for one in clip.outline.segments if isinstance(one, Spline)]
    assert len(splines) == 2
    assert clip.outline.closed
    assert clip.outline.widest_gap < 1e-6
    assert clip.outline.area > 0
    s = np.linspace(10, 140, 200)
    place, angle = clip.centre.at(s)
    normal = np.column_stack([-np.sin(angle), np.cos(angle)])
    edge = place + clip.thickness_at(s)[:, None] / 2 * normal
    assert np.min([distances(one, edge) for one in splines], axis=0).max() < 2e-3


def test_the_pads_carry_the_holes_and_one_plate_takes_them(clip, stand):
    both = [clip.hole_places(line) for line in clip.states]
    assert np.abs(both[0] - both[1]).max() < 0.05
    assert len(clip.holder().on("CUT_INNER")) == 4
    assert len(stand.holder().on("CUT_INNER")) == 6
    assert [text.text for text in stand.holder().texts] == ["1", "2"]
    apart = np.hypot(*np.diff(clip.hole_places(clip.centre)[0], axis=0)[0])
    assert apart == pytest.approx(Pad().length - 2 * Pad().inset)


def test_pads_are_10_mm_wide_with_fillets_of_1_mm_by_default(clip):
    points = clip.outline.points(1e-3)
    assert np.ptp(points[points[:, 0] < -5, 1]) == pytest.approx(10)
    segments = clip.outline.segments
    roots = [after for before, after in pairwise(segments) if isinstance(before, Spline)]
    assert [root.radius for root in roots] == pytest.approx([1.0, 1.0])


@pytest.mark.parametrize("r", [0.4, 1.0, 2.5])
def test_a_fillet_gives_as_much_as_the_strip_it_replaces(clip, r):
    """The compliance of the thickened root, summed by trapezia, is that of the strip up to the drawn end."""
    clip = replace(clip, fillet=r)
    h = float(clip.thickness_at(np.zeros(1))[0])
    x = np.linspace(0, r, 20001)
    wide = h + 2 * (r - np.sqrt(r**2 - x**2))
    give = np.sum((h / wide) ** 3) * (x[1] - x[0])
    root = 0.44 * (h + 2 * r) * (h / (h + 2 * r)) ** 3
    assert r - clip.overhang(0.0) == pytest.approx(give + root, rel=1e-3)


def test_the_push_is_the_slope_of_the_energy_and_ends_in_the_other_state(clip):
    way = clip.travel
    middle = (way.travel[1:] + way.travel[:-1]) / 2
    slope = np.diff(way.energy) / np.diff(way.travel)
    calm = np.abs(np.diff(way.force)) < 0.1 * way.largest_force
    assert np.interp(middle, way.travel, way.force)[calm] == pytest.approx(
        slope[calm], abs=0.02 * way.largest_force
    )
    assert way.reached
    assert clip.travel_back.reached
    assert 0 < way.snap < way.travel[-1]
    assert way.force[0] == pytest.approx(0, abs=1e-6)


def test_the_path_of_a_push_begins_at_the_shape_at_rest(low):
    assert low.travel.travel[0] == 0
    assert low.travel.force[0] == pytest.approx(0, abs=1e-6)


def test_a_pushed_arch_gives_as_half_of_it_led_does():
    """Pushed in its middle an arch stays symmetrical at first, so half of it, led so, tells the force."""
    from elastica_cad import Rod, bend

    whole = bend(Rod.straight(200.0), end=(196.0, 0.0))
    half = bend(Rod.straight(100.0), end=tuple(whole.position[300]), angles=(0.0, 0.0))
    u = 0.3
    pushed = push_path(whole, 100.0, (0, -1), [0.0, u], thickness=0.2)
    led = bend(half, end=(half.position[-1] - [0, u]), angles=(0.0, 0.0))
    assert pushed.force[1] == pytest.approx(2 * abs(led.force[-1][1]), rel=0.02)


def test_the_push_is_the_same_wherever_the_rod_is_drawn(low):
    first, _ = low.rods
    far = replace(first, position=first.position + np.array([3e3, -2e3]))
    pushed = [push_path(rod, 61.7, (0, -1), [0.0, 1.0, 2.0], thickness=1.7) for rod in (first, far)]
    assert pushed[1].force == pytest.approx(pushed[0].force, rel=1e-6, abs=1e-9)
    assert np.abs(pushed[1].position - pushed[0].position - [3e3, -2e3]).max() < 1e-6
    point = [np.interp(61.7, first.s, y) for y in pushed[0].position[..., 1]]
    assert point[0] - point == pytest.approx([0.0, 1.0, 2.0], abs=1e-3)


def test_the_largest_force_is_that_before_the_snap(low):
    """Beyond its rest a shallow part is pushed against its clamps."""
    for way in (low.travel, low.travel_back):
        before = way.travel <= way.snap
        assert way.force.max() > 2 * way.largest_force
        assert way.largest_force == way.force[before].max()
        assert (way.force[1:][before[1:]] > 0).all()
    low_force, high_force = low.force_range
    assert low_force < low.travel.largest_force < high_force < 1.5 * low.travel.largest_force
    report = low.as_dict()
    assert report["largest_force_N"] == low.travel.largest_force
    assert report["largest_force_range_N"] == [low_force, high_force]


def test_the_range_of_the_force_is_that_of_parts_of_other_thickness():
    """A thicker part of the same shallow curves snaps at less."""
    part = FlexureSpec(arch(5), arch(-4), POM, least_thickness=2.0).make()
    others = [
        Flexure(part.pair, POM, least_thickness=2.0 * (1 + off / np.mean(part.thickness_range)))
        for off in (-0.1, 0.1)
    ]
    thin, thick = (other.travel.largest_force for other in others)
    softest, stiffest = np.array(POM.youngs_modulus_range) / POM.youngs_modulus
    assert thick < part.travel.largest_force < thin
    assert part.force_range == pytest.approx((thick * softest, thin * stiffest), rel=1e-6)


def test_shapes_at_rest_are_reported_and_warned_of(low, clip):
    assert [round(far, 1) for far in low.rest_deviations] == [0.6, 0.5]
    assert [str(one).split(" (")[0] for one in low.rest_warnings] == [
        f"the part rests up to {far:.3g} mm" for far in low.rest_deviations
    ]
    assert low.as_dict()["rest_deviation_mm"] == list(low.rest_deviations)
    assert clip.rest_warnings == ()
    assert max(clip.rest_deviations) < 1e-3 * clip.pair.length


def test_shapes_at_rest_are_compared_with_the_length_of_the_part(low):
    for far, warning in zip(low.rest_deviations, low.rest_warnings, strict=True):
        assert f"({100 * far / low.pair.length:.2g} % of its length)" in str(warning)


def test_a_part_that_stretches_out_of_its_second_state_is_not_bistable():
    part = FlexureSpec(arch(6), arch(-5), POM, least_thickness=2.8).make()
    assert part.pair.bistable
    assert not part.bistable
    assert part.travel_back is None
    assert not part.travel.reached
    assert part.travel.largest_force == part.travel.force.max()
    assert [str(one)[:28] for one in part.warnings if "rests" in str(one)] == ["the part is not bistable: it"]


def test_settings_are_led_from_one_to_the_other(stand):
    assert not stand.pair.bistable
    assert stand.travel.reached
    assert stand.travel_back is None
    report = stand.as_dict()
    assert report["bistable"] is False
    assert report["reports"] == []


def test_curves_drawn_apart_are_held_by_the_same_clamps(clip):
    away = np.array([[1, 0, 9.0], [0, 1, -40], [0, 0, 1]])
    moved = FlexureSpec(arch(24), arch(-20).transformed(away), POM, least_thickness=1.0).make()
    assert moved.pair.bistable
    assert np.abs(moved.rods[1].position - clip.rods[1].position).max() < 1e-6


def test_a_part_too_thin_says_how_large_it_would_have_to_be():
    with pytest.raises(InputError, match="times as large") as refused:
        FlexureSpec(arch(10, 60), arch(-10, 60), POM).make()
    share = refused.value.refusal.values["share"]
    assert share > 1
    assert FlexureSpec(arch(10, 60), arch(-10, 60), POM, ignore_limits=True).make().warnings
    enlarged = FlexureSpec(arch(10, 60), arch(-10, 60), POM, scale=share).make()
    assert enlarged.scale == pytest.approx(LEAST_CUT_MM, rel=0.05)  # enough, and not much more


def test_the_least_ratio_has_a_thickness_however_much_its_forces_stretch_the_part():
    """The strain by stretching grows with the square of the thickness."""
    spec = FlexureSpec(arch(24), arch(-20), POM, objective="ratio", ignore_limits=True)
    assert 0 < spec.make().scale < 1e-3
    with pytest.raises(InputError, match="parts must be at least"):
        replace(spec, ignore_limits=False).make()


def test_a_push_has_no_effect_on_a_part_with_two_settings(stand, clip):
    text = "no effect, because the end of this part is moved between two positions"
    assert [text in str(one) for one in replace(stand, push_at=50.0).warnings] == [
        *(False for _ in stand.warnings),
        True,
    ]
    assert not any(text in str(one) for one in replace(clip, push_at=50.0).warnings)


def test_a_part_that_nothing_bends_requests_how_thick_it_shall_be():
    with pytest.raises(InputError, match="the thickness of the part cannot be computed"):
        FlexureSpec(arch(24), arch(24), POM).make()
    unbent = FlexureSpec(arch(24), arch(24), POM, least_thickness=2.0).make()
    assert max(unbent.strain) < 1e-6


def test_a_part_that_breaks_is_refused():
    with pytest.raises(StrainError, match="breaks"):
        FlexureSpec(arch(24), arch(-20), "pla-4", least_thickness=4.0).make()


def test_a_part_that_touches_itself_is_refused():
    loop = PlaneCurve.arc((0, 40), 40, -np.pi / 2, -np.pi / 2 + 2 * np.pi - 0.15)
    wide = PlaneCurve.arc((0, 60), 60, -np.pi / 2, -np.pi / 2 + loop.length / 60)
    with pytest.raises(InputError, match="two places of the part overlap"):
        FlexureSpec(wide, loop, "polypropylene-3", match="shape", least_thickness=1.0).make()


def test_the_direction_of_the_force_is_that_of_the_push(low):
    moved, turn = low.pushed[1], np.radians(low.force_direction)
    assert moved @ [np.cos(turn), np.sin(turn)] == pytest.approx(np.hypot(*moved))


def test_the_direction_of_the_force_on_an_end_agrees_with_the_energy(stand):
    """The work of the force and of the moment on the end is the difference of the energy."""
    rods, k = stand._rods_with_moved_end, int(stand.travel.force.argmax())
    before, after = (min(max(n, 0), len(rods) - 1) for n in (k - 1, k + 1))
    moments = [stand.bending_stiffness * rods[n].moment[-1] for n in (before, after)]
    turn = np.radians(stand.force_direction)
    moved = (rods[after].position[-1] - rods[before].position[-1]) @ [np.cos(turn), np.sin(turn)]
    work = np.mean(stand.travel.force[[before, after]]) * moved
    work += np.mean(moments) * (rods[after].angle[-1] - rods[before].angle[-1])
    assert stand.travel.energy[after] - stand.travel.energy[before] == pytest.approx(work, rel=0.1)


@pytest.mark.campaign
@pytest.mark.parametrize("part", ["clip", "low", "stand"])
def test_half_the_step_changes_the_largest_force_below_one_percent(part, request, monkeypatch):
    flexure = request.getfixturevalue(part)
    points = len(flexure.travel.travel)  # computed before the number of steps changes
    monkeypatch.setattr("elastica_cad.pairs.flexure.TRAVEL_STEPS", 96)
    finer = replace(flexure, least_thickness=flexure.scale, ignore_limits=True)
    assert len(finer.travel.travel) > 1.5 * points
    assert finer.travel.largest_force == pytest.approx(flexure.travel.largest_force, rel=0.01)
    assert (flexure.travel.travel < flexure.travel.travel[flexure.travel.force.argmax()]).sum() >= 6


@pytest.mark.parametrize("depth", [12.0, 15.0])
def test_a_longer_pad_keeps_its_holes_apart_in_a_thick_holder(clip, depth):
    thick = replace(clip, sheet=replace(POM, thickness=depth))
    with pytest.raises(InputError, match="two holes of a pad are 9 mm apart") as error:
        thick.holder()
    longer = float(str(error.value).rpartition(" to ")[2].split()[0])
    assert len(replace(thick, pad=Pad(length=longer)).holder().on("CUT_INNER")) == 4
    with pytest.raises(InputError, match="two holes of a pad"):
        replace(thick, pad=Pad(length=longer - 0.1)).holder()


def test_names_are_cleaned_before_the_part_is_computed(stand):
    request = FlexureSpec(
        arch(8), arch(-6.5), POM, label="a\u00a0b", first_state="e\u0301", second_state="\u200bdown"
    )
    assert (request.label, request.first_state, request.second_state) == ("a b", "é", "down")
    assert replace(stand, state_names=("e\u0301", "so\u00adft")).state_names == ("é", "soft")
    for name in ("label", "first_state", "second_state"):
        with pytest.raises(InputError, match=r"contains '\\u202e' between 'a' and 'b'"):
            replace(request, **{name: "a\u202eb"})
    with pytest.raises(InputError, match=r"contains '\\n'"):
        replace(stand, state_names=("a\nb", ""))
    with pytest.raises(InputError, match="Both states have the name é"):
        replace(request, second_state="é")


def test_states_have_names_in_the_holder_and_the_warnings(stand):
    named = replace(stand, state_names=("reading", ""))
    assert [text.text for text in named.holder().texts] == ["reading", "2"]
    assert [text.text for text in stand.holder().texts] == ["1", "2"]
    assert [str(label) for label in named.state_labels] == ["reading", "second state"]


def hook(rise: float, width: float) -> PlaneCurve:
    """Start level and end at an angle."""
    return PlaneCurve.spline([(0, 0), (15, 0), (30, 0), (0.7 * width, rise), (width, 0)], degree=4)


SNAPPING = {"moved end": (-22, 114, 0.87, "mm"), "turned end": (-25, 110, 0.75, "deg")}


@pytest.mark.parametrize(("rise", "width", "thickness", "unit"), SNAPPING.values(), ids=SNAPPING.keys())
def test_a_setting_that_jumps_names_place_and_forces(rise, width, thickness, unit):
    """Bent in one step to either side of the snap, the rod has the reported forces, and less energy after it."""
    spec = FlexureSpec(hook(30, 110), hook(rise, width), POM, least_thickness=thickness, ignore_limits=True)
    part = spec.make()
    travel = part.travel
    assert not part.pair.bistable
    assert travel.unit == unit
    (first, second), (before, after) = part.rods, travel.forces_at_snap
    share = travel.snap / travel.travel[-1]
    held = [
        {
            "end": first.position[-1] + at * (second.position[-1] - first.position[-1]),
            "angles": (first.angle[0], first.angle[-1] + at * (second.angle[-1] - first.angle[-1])),
        }
        for at in (share - 1e-5, share + 1e-5)
    ]
    near = bend(first, **held[0])
    far = bend(second, **held[1])
    B = part.bending_stiffness
    assert before == pytest.approx(B * np.hypot(*near.force[-1]), rel=0.01)
    assert after == pytest.approx(B * np.hypot(*far.force[-1]), rel=0.01)
    assert far.bending_energy < near.bending_energy
    (row,) = (row.text for row in pair_rows(part) if row.label == "Force")
    place = f"{travel.snap:.3g} " + ("mm of travel" if unit == "mm" else "degrees of rotation")
    assert f"the part snaps after {place}, and the force jumps from {before:.2g} to {after:.2g} N" in row
    assert travel.largest_force == travel.force.max()
    assert part.force_csv().startswith(
        {"mm": "travel_mm", "deg": "turn_deg"}[unit] + ",force_N,direction_deg,moment_Nmm,energy_Nmm,"
    )
    assert part.as_dict()["forces_at_snap_N"] == [before, after]


def test_force_and_moment_on_the_moved_end_do_the_work_between_two_settings():
    """The energy increases by the integral of F dx + M d(angle)."""
    spec = FlexureSpec(hook(30, 110), hook(20, 108), POM, least_thickness=0.87, ignore_limits=True)
    part = spec.make()
    travel, (first, second) = part.travel, part.rods
    assert travel.snap is None
    turn, share = np.radians(travel.direction), travel.travel / travel.travel[-1]
    along = np.column_stack([np.cos(turn), np.sin(turn)]) @ (second.position[-1] - first.position[-1])
    power = travel.force * along + travel.moment * (second.angle[-1] - first.angle[-1])
    work = np.sum((power[1:] + power[:-1]) / 2 * np.diff(share))
    assert work == pytest.approx(travel.work, abs=0.01 * np.ptp(travel.energy))
    assert travel.direction[travel.force.argmax()] == pytest.approx(part.force_direction)


@pytest.mark.parametrize(
    "first", ["for reading in bed", "for reading in bed, with the lamp turned down to the page"]
)
def test_names_of_settings_have_one_height_beside_the_holes(stand, first):
    holder = replace(stand, state_names=(first, "flat")).holder()
    assert {text.height for text in holder.texts} == {3.0}
    holes = [path.points(0.01).mean(axis=0) for path in holder.on("CUT_INNER")]
    (plate,) = holder.on("CUT_OUTER")
    for text in holder.texts:
        strokes = np.vstack([stroke.points(0.1) for stroke in text_strokes(text)])
        assert min(np.hypot(*(strokes - hole).T).min() for hole in holes) > stand.pad.hole / 2 + 0.5
        assert (plate.bounds[0] + 1 < strokes).all()
        assert (strokes < plate.bounds[1] - 1).all()


def test_scaled_curves_make_a_larger_part(stand):
    first = PlaneCurve.spline([(0, 0), (40, 0), (62, 22), (72, 52), (89, 99)], degree=4)
    second = PlaneCurve.spline([(0, 0), (40, 0), (66, 15), (90, 40), (122, 72)], degree=4)
    large = FlexureSpec(first, second, "pla-4", scale=1.5, printed=True, least_thickness=3.0).make()
    assert large.pair.length == pytest.approx(1.5 * stand.pair.length, rel=1e-3)
    assert large.rods[1].position == pytest.approx(1.5 * stand.rods[1].position, abs=0.3)


def test_no_flexure_is_cut_from_a_rod():
    with pytest.raises(InputError, match="carbon-rod-5 is a rod, so no flat part can be cut from it"):
        FlexureSpec(arch(24), arch(-20), "carbon-rod-5")


@pytest.mark.parametrize(("turn", "shift"), [(0.0, (0.0, 0.0)), (30.0, (0.0, 0.0)), (200.0, (0.0, 7.0))])
def test_the_turn_of_the_second_state_into_the_clamp_is_reported(turn, shift):
    """The arches start at 21.8 and -21.8 degrees before the second is turned further."""
    first = PlaneCurve.spline([(0, 0), (100, 40), (200, 40), (300, 0)], degree=3)
    c, s = np.cos(np.radians(turn)), np.sin(np.radians(turn))
    second = first.transformed(np.array([[c, s, shift[0]], [s, -c, shift[1]], [0, 0, 1]]))
    part = FlexureSpec(first, second, "pom-2", match="none", least_thickness=1.5).make()
    rows = {row.label: row.text for row in pair_rows(part, quick=True)}
    start, other = np.degrees(np.arctan2(40, 100)), turn - np.degrees(np.arctan2(40, 100))
    expected = (start - other + 180) % 360 - 180
    assert f"second state is turned by {expected:.1f} degrees" in rows["Position"]
    assert f"the drawn curves start at {start:.1f} and {other:.1f} degrees to the x axis" in rows["Position"]
    turned, moved = part.second_moved
    assert turned == pytest.approx(expected, abs=1e-6)
    placed, drawn = part.rods[1].position, second.sample(len(part.rods[1].s)).position
    assert moved == pytest.approx(np.hypot(*(placed - drawn).T).max(), rel=1e-6)
    assert "from its drawn position" in rows["Accuracy"]


def test_states_in_one_clamp_keep_their_positions(clip):
    assert clip.second_moved == pytest.approx((0, 0), abs=1e-6)
    assert "Position" not in {row.label for row in pair_rows(clip, quick=True)}


def test_names_in_other_alphabets_are_engraved_as_numbers_that_a_note_explains(stand):
    named = replace(stand, label="左边", state_names=("左", "2"))
    texts = [text.text for text in (*named.drawing().texts, *named.holder().texts)]
    assert texts[0] == "1"
    assert {"3", "2"} <= set(texts)
    (sentence,) = (str(message) for message in named.warnings if "Numbers are engraved" in message)
    assert "1 = 左边, 3 = 左" in sentence
