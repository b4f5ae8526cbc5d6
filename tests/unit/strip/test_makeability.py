"""Parts that no workshop can cut or handle are found, each with its place, its size and the cure."""

import re
import tracemalloc
from dataclasses import dataclass, replace

import numpy as np
import pytest

from elastica_cad import (
    FabricationLimits,
    Hole,
    InputError,
    Path,
    Perforated,
    PlaneCurve,
    Rod,
    Sheet,
    Slot,
    Strip,
    Tab,
    make_strip,
)
from elastica_cad.errors import StrainError
from elastica_cad.geometry import Line
from elastica_cad.strip.uncuttable_parts import (
    find_plate_faults,
    find_slot_faults,
    find_strip_faults,
    find_thin_places,
)

pytestmark = pytest.mark.core

PLYWOOD = Sheet.named("birch-plywood-0.8")


def strip(stiffness=(2, 2, 2), length=200.0, **options):
    return Strip(Rod.straight(length, list(stiffness)), PLYWOOD, **({"max_width": 20.0} | options))


def test_a_sound_strip_has_no_faults():
    assert find_strip_faults(strip()) == ()


def test_plainly_wide_strips_have_no_thin_place_and_keep_their_layers_for_later():
    rng, plainly = np.random.default_rng(67), 0
    for _ in range(150):
        wavy = strip(
            1 + rng.uniform(0, 3) * rng.random(7), length=rng.uniform(20, 300), max_width=rng.uniform(3, 30)
        )
        find_strip_faults(wavy)
        if "layers" not in vars(wavy):
            plainly += 1
            assert find_thin_places([wavy.outline], (), 3.0) == ()
    assert 50 < plainly < 140


@pytest.mark.parametrize("options", [{"ends": Tab(12, width=2.0)}, {"slots": Slot(100.0, 0.8, 18.5)}])
def test_a_tab_or_slot_leaves_a_neck_in_a_plainly_wide_strip(options):
    (fault,) = find_strip_faults(strip(**options))[:1]
    assert "only" in fault.what


def test_the_neck_of_half_a_millimetre_is_named_with_its_place():
    (fault,) = find_strip_faults(strip((40, 1, 40), max_width=20.4, label="A1"))
    assert fault.part == "A1"
    assert "only 0.513 mm wide at" in fault.what
    assert "birch-plywood-0.8 needs at least 3 mm" in fault.what
    assert "Make the strip 120 mm wide or wider (max_width)" in fault.cure
    assert find_strip_faults(strip((40, 1, 40), max_width=120.0)) == ()


def test_a_strip_is_not_made_wider_than_it_is_long():
    (fault,) = find_strip_faults(strip((160, 1, 160), max_width=80.0))
    assert fault.cure == "Let the program change the curve so that the widths differ less"


def test_a_strip_that_is_overstrained_at_every_width_is_not_made_wider():
    loop = PlaneCurve.spline([(0, 0), (310, 160), (-50, 160), (260, 0)], degree=3)
    assert not make_strip(loop, "pom-0.5", max_width=90).strain_verdict.allowed
    with pytest.raises(InputError, match=r"only 1\.07 mm wide") as refused:
        make_strip(loop, "pom-0.5", max_width=30)
    assert "Make the strip" not in str(refused.value)
    assert {change.field for change in refused.value.refusal.changes} == {"nearest"}


def test_a_strip_of_points_that_waver_is_smoothed_rather_than_made_very_wide():
    t = np.linspace(0, 1, 18)
    points = np.column_stack([130 * t, 38 * np.sin(np.pi * t) ** 2 * (0.825 + 0.35 * t) + 6 * t])
    wavering = PlaneCurve.fit(points + np.random.default_rng(20).normal(0, 0.3, points.shape))
    for smooth, wider in (
        (0.6, r"\. Make the strip 19.5 mm wide or wider \(max_width\), or let"),
        (0.33, r"\. Let"),
    ):
        cures = f"{wider} the program change the curve .*or smooth the points of the curve more"
        with pytest.raises(InputError, match=cures):
            make_strip(wavering, "spring-steel-0.2", max_width=12, smooth=smooth)
    make_strip(wavering, "spring-steel-0.2", max_width=20, smooth=0.6)
    make_strip(wavering, "spring-steel-0.2", max_width=12, smooth=0.8)


def test_the_neck_lies_where_the_width_is_least():
    rod = Rod.straight(200.0, 1 + 3 * np.abs(np.linspace(-1, 1, 301)))
    (place,) = find_thin_places([Strip(rod, PLYWOOD, max_width=8.0).outline], [], 3.0)
    assert place.width == pytest.approx(2.0, abs=0.03)
    assert place.x == pytest.approx(100.0, abs=1.0)


def test_a_slot_that_leaves_a_neck():
    assert find_strip_faults(strip(slots=(Slot(100.0, 1.0, depth=16.0),))) == ()  # 4 mm are left
    (fault,) = find_strip_faults(strip(slots=(Slot(100.0, 1.0, depth=18.0),)))
    assert "only 2 mm wide" in fault.what


def test_a_hole_near_the_edge_of_a_tab():
    fault, *_ = find_strip_faults(strip(ends=(Tab(20, holes=(Hole(10, 17.0),)), Tab(12))))
    assert "only 1.5 mm of material between a hole and the edge in the tab at its start" in fault.what
    assert (
        fault.cure == "Make the tab 21 mm wide and 20.5 mm long, or make the hole at most 16 mm in diameter"
    )


def test_the_change_for_a_hole_in_a_tab_is_enough():
    """Random holes: at most one fault for each hole, and each change, made as advised, leaves no fault."""
    rng, seen = np.random.default_rng(90), set()
    for _ in range(150):
        length, width = rng.uniform(8, 24), rng.uniform(5, 16)
        hole = Hole(rng.uniform(3, length - 3), rng.uniform(1, 6), rng.uniform(-2, 2))
        width = max(width, 2 * abs(hole.across) + hole.diameter + 0.1)
        tab = Tab(length, width=width, holes=hole)
        faults = [
            fault
            for fault in find_strip_faults(strip(ends=(Tab(12), tab)))
            if "a hole and the edge" in fault.what
        ]
        if not faults:
            continue
        (fault,) = faults
        sizes = {
            word: float(size)
            for size, word in re.findall(r"(\S+) mm (wide|long|away|in diameter)", fault.cure)
        }
        seen |= sizes.keys()
        if "in diameter" in sizes:
            smaller = replace(hole, diameter=sizes["in diameter"])
            assert find_strip_faults(strip(ends=(Tab(12), replace(tab, holes=smaller)))) == (), tab
        if "away" in sizes:
            places = find_thin_places(
                *cuts(strip(ends=(Tab(12), tab))), FabricationLimits().bridge_for(PLYWOOD)
            )
            away = np.array([200 + hole.at, hole.across]) - (places[0].x, places[0].y)
            away = np.where(
                abs(away) == abs(away).max(), sizes["away"] * np.sign(away), 0
            )  # off a straight edge
            changed = replace(tab, holes=Hole(hole.at + away[0], hole.diameter, hole.across + away[1]))
        else:
            changed = replace(tab, width=max(width, sizes["wide"]), length=max(length, sizes.get("long", 0)))
        assert find_strip_faults(strip(ends=(Tab(12), changed))) == (), (tab, fault.cure)
    assert seen == {"wide", "long", "away", "in diameter"}


def cuts(made):
    return [made.layers[0].outline], made.layers[0].holes


@dataclass(frozen=True)
class Notched(Tab):
    """A tab with a field that only its outline knows."""

    notch: float = 0.0

    def corners(self, width):
        w, deep, end = (self.width or width) / 2, self.notch, self.length
        points = [(0, -w), (4, -w), (4, deep - w), (6, deep - w), (6, -w), (end, -w), (end, w), (0, w)]
        return tuple(map(Line, points, points[1:]))


def test_a_field_of_a_tab_that_is_known_to_its_outline_alone_is_checked():
    (fault,) = find_strip_faults(strip(ends=(Notched(12, notch=18.9), Tab(12))))
    assert "only 1.1 mm wide" in fault.what


@pytest.mark.parametrize("sides", [("lower", "upper"), ("lower", "lower")])
def test_slots_that_leave_too_little_between_them_are_to_be_moved_apart(sides):
    at = (150.0, 153.2)
    slots = [Slot(place, 1.0, side=side) for place, side in zip(at, sides, strict=True)]
    (fault,) = find_strip_faults(strip(slots=slots))
    assert fault.cure == "Move the slots at 150 and 153 mm apart"
    assert "-0.0000" not in fault.what
    far = replace(slots[1], at=154.1)
    assert find_strip_faults(strip(slots=[slots[0], far])) == ()


def test_wide_corners_are_no_necks():
    triangle = Path.polygon([(0, 0), (40, 0), (20, 30)])
    assert find_thin_places([triangle], [], 3.0) == ()
    needle = Path.polygon([(0, 0), (40, 0), (40, 6)])
    assert find_thin_places([needle], [], 3.0)


def test_bridges_of_plates_have_a_limit_of_their_own():
    plate = Path.rectangle(100, 60)
    slots = [Path.rectangle(26, 12, corner=(10, 10)), Path.rectangle(26, 12, corner=(37, 10))]
    (fault,) = find_plate_faults("ring", Sheet.named("mdf-3"), plate, slots)
    assert "only 1 mm between a hole at (36.5" in fault.what
    assert (
        find_plate_faults("ring", Sheet.named("mdf-3"), plate, slots, FabricationLimits(least_bridge=0.9))
        == ()
    )


def test_slots_far_wider_than_what_goes_through():
    (fault,) = find_slot_faults("ring", [("A", 2.0, 0.8), ("B", 12.0, 0.8)])
    text = "the slot for B is 12 mm wide, but a tab 0.8 mm thick is held only by a slot of at most 6.4 mm"
    assert text in str(fault)
    assert find_slot_faults("ring", [("A", 2.0, 0.8), ("C", 1.5, 0.2)]) == ()


def test_longer_than_the_stock_and_too_slender():
    faults = find_strip_faults(strip(length=8000.0, max_width=3.6))
    assert any("larger than the stock of 3050 x 1525 mm" in fault.what for fault in faults)
    assert any("too slender to handle" in fault.what for fault in faults)
    assert find_strip_faults(strip(length=900.0), FabricationLimits(stock=(600, 400)))


def test_ligaments_are_judged_by_their_own_limit():
    style = Perforated(width=24.0, columns=2, rows=4, least_ligament=0.5)
    holed = Strip(Rod.straight(120.0, [1, 2, 1]), Sheet.named("card-200gsm"), style=style)
    assert find_strip_faults(holed) == ()
    (fault,) = find_strip_faults(holed, FabricationLimits(least_ligament=0.8))
    assert "at least 0.8 mm wide" in fault.what


def test_a_sheet_has_limits_of_its_own():
    fine = replace(PLYWOOD, least_ligament=0.2, least_bridge=0.7, stock=(300, 900))
    assert (
        FabricationLimits().ligament_for(fine),
        FabricationLimits().bridge_for(fine),
        FabricationLimits().stock_for(fine),
    ) == (
        0.2,
        0.7,
        (900, 300),
    )
    given = FabricationLimits(least_ligament=0.4, least_bridge=1.0, stock=(600, 400))
    assert (given.ligament_for(fine), given.bridge_for(fine), given.stock_for(fine)) == (0.4, 1.0, (600, 400))
    assert FabricationLimits().stock_for(PLYWOOD) == (3050, 1525)
    with pytest.raises(InputError, match="least_bridge is 0: give a number above 0"):
        replace(PLYWOOD, least_bridge=0)


@pytest.mark.parametrize("limits", [{"least_width": 0.0}, {"least_bridge": np.nan}, {"stock": (600, -1)}])
def test_limits_that_make_no_sense(limits):
    with pytest.raises(InputError):
        FabricationLimits(**limits)


def test_what_misses_by_less_than_usual_digits_show_is_listed_with_more():
    """ "Only 3 mm wide; birch needs 3 mm" would help nobody."""
    fault, *_ = find_strip_faults(strip((1, 2, 1), max_width=5.996))
    assert "only 2.998 mm wide in the tab at its " in fault.what
    assert "(and 1 more place), but" in fault.what
    assert "needs at least 3 mm" in fault.what
    (fault,) = find_strip_faults(strip(length=3030.4, max_width=30))
    assert "3050.4 x 30 mm is larger than the stock of 3050 x 1525 mm" in fault.what


@pytest.mark.parametrize("least", [1.0, 2.3, 9.99])
@pytest.mark.parametrize("missing", [1e-12, 3e-8, 5e-6, 1.2e-5, 1e-3])
def test_a_figure_that_equals_its_limit_in_the_digits_shown_is_no_fault(least, missing):
    faults = find_strip_faults(
        strip(max_width=least * (1 - missing)), FabricationLimits(least_width=least, stock=(219.999, 50))
    )
    assert all("219.999" not in fault.what for fault in faults), "220 mm of 219.999 mm"
    assert bool(faults) == (missing > 1e-5)
    for fault in faults:
        wide, needed = re.search(r"only (\S+) mm wide .* needs at least (\S+) mm", fault.what).groups()
        assert float(wide) < float(needed)


def test_strain_that_is_just_beyond_its_limit_differs_from_it():
    curve = PlaneCurve.arc((0, 0), 0.9999 * PLYWOOD.least_radius, 0.2, 2.2)
    (result,) = make_strip(curve, PLYWOOD, max_width=20).warnings
    found = re.search(
        r"strain is (\S+) % at .* allows (\S+) %: .* at least (\S+) mm there \(now (\S+) mm", result
    )
    assert found, result
    strain, limit, least, radius = map(float, found.groups())
    assert strain > limit
    assert radius < least


ARCH = PlaneCurve.spline([(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)])


def test_a_thin_web_is_listed_with_how_far_to_move_the_hole():
    ends = (Tab(20, holes=(Hole(6, 4), Hole(11, 4))), Tab(10))
    with pytest.raises(
        InputError, match=r"between two holes in the tab at its start, 8.5\d mm from the bent part"
    ) as refused:
        make_strip(ARCH, "birch-plywood-0.8", max_width=30, ends=ends)
    assert re.search(r"Move the holes farther apart by (1 mm|0\.9)", str(refused.value))
    wide = replace(ends[0], holes=(Hole(5, 4), Hole(11.1, 4)))
    make_strip(ARCH, "birch-plywood-0.8", max_width=30, ends=(wide, ends[1]))


def test_a_narrow_tab_is_reported_as_a_tab():
    with pytest.raises(
        InputError, match=r"in the tab at its start, .*, but pom-0.5 needs at least 3 mm\. Make the tab wider"
    ):
        tabbed(2, "pom-0.5")  # which does not break


def tabbed(width, sheet=PLYWOOD, **options):
    return make_strip(ARCH, sheet, max_width=30, ends=(Tab(20, width=width), Tab(10)), **options)


def test_a_tab_that_its_end_would_break_is_refused_with_the_width_that_bears_it():
    with pytest.raises(
        StrainError,
        match=r"strip is 24.7 mm wide and its tab is 3 mm wide\. .* tab at the start at least (\S+) mm wide",
    ) as no:
        tabbed(3)
    assert not tabbed(
        float(re.search(r"ends = \[{ width = (\S+), \.\.\. }, { \.\.\. }\]", str(no.value))[1])
    ).warnings
    (result,) = tabbed(3, ignore_limits=True).strain_warnings
    assert result in str(no.value)


def test_a_tab_bears_in_the_mean_what_the_moment_of_its_end_requests():
    """6 M / (E b h^2), from the reactions; corners of what yields are not counted."""
    metal = replace(PLYWOOD, kind="metal", max_strain=0.005, max_strain_range=None)
    made = tabbed(6, metal)
    request = 6 * abs(made.reactions().start_moment) / (metal.youngs_modulus * 6 * metal.thickness**2)
    assert made.strain_verdict.used == pytest.approx(request / 0.005, rel=1e-3)
    assert made.strain_verdict.at == 0.0
    assert not tabbed(6, replace(metal, max_strain=1.001 * request)).warnings
    (message,) = tabbed(
        6, replace(metal, max_strain=1.3 * request, kind="plywood")
    ).warnings  # its corners crack
    assert "its tab is 6 mm wide" in message


def test_a_tab_is_judged_beside_an_end_that_is_too_strained_itself():
    """6 M / (E b h^2) decides, and no width of the tab suffices."""
    metal = replace(PLYWOOD, kind="metal", max_strain=0.0005, max_strain_range=None)
    made = tabbed(6, metal, ignore_limits=True)
    strain = 6 * abs(made.reactions().start_moment) / (metal.youngs_modulus * 6 * metal.thickness**2)
    assert made.strain_verdict.used == pytest.approx(strain / metal.max_strain, rel=1e-3)
    ends, tab = made.strain_warnings
    assert "its tab" not in ends
    assert "Make the curve gentler there, and the tab wider." in tab


def test_every_rib_between_many_slots_is_found_with_the_width_that_is_narrowest():
    slots = [Path.rectangle(0.2, 2, corner=(5 + 0.5 * i, 2)) for i in range(40)]
    places = find_thin_places([Path.rectangle(30, 8)], slots, 0.6)
    np.testing.assert_allclose([place.width for place in places], 0.3, atol=1e-9)
    wide = find_thin_places([Path.rectangle(30, 8)], slots, 0.25)
    assert not wide


def test_thin_places_of_a_long_strip_are_found_in_blocks_of_bounded_memory():
    def peak_memory(length):
        x = np.linspace(0, length, length // 10)
        y = 1 + 0.3 * np.sin(x / 15)
        outline = Path.polygon(np.concatenate([np.stack([x, -y], axis=1), np.stack([x, y], axis=1)[::-1]]))
        tracemalloc.start()
        (place,) = find_thin_places([outline], [], 3.0)
        peak = tracemalloc.get_traced_memory()[1]
        tracemalloc.stop()
        assert place.width == pytest.approx(1.4, rel=0.01)
        return peak

    assert peak_memory(4000) < 1.4 * peak_memory(2000)


@pytest.mark.parametrize("width", [0.3, 1.0, 1.9, 1.99])
@pytest.mark.parametrize("radius", [3.0, 6.0, 40.0])
def test_the_width_between_round_cuts_is_exact(width, radius):
    plate = Path.circle((0, 0), 2 * radius + 2 * width)
    holes = [Path.circle((-radius, 0), radius), Path.circle((radius + width, 0), radius)]
    places = find_thin_places([plate], holes, 2.0)
    between = [place.width for place in places if place.loops == (1, 2)]
    beside = [place.width for place in places if 0 in place.loops]
    assert between == pytest.approx([width], abs=1e-9)
    assert min(beside) == pytest.approx(width, abs=1e-9)
    assert not [place for place in find_thin_places([plate], holes, 0.999 * width) if place.loops == (1, 2)]


def test_a_plate_far_larger_than_its_stock_is_refused_for_its_size_alone():
    plate, near_the_edge = Path.rectangle(1e5, 1e5), Path.rectangle(10, 10, corner=(0.1, 50))
    (fault,) = find_plate_faults("base", Sheet.named("mdf-3"), plate, [near_the_edge])
    assert "larger than the stock" in fault.what
