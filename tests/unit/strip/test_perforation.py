"""Perforated strips: ligaments that sum up to the stiffness, holes that can be cut, refusals that say where."""

import re

import numpy as np
import pytest
import shapely

import elastica_cad as ec
from elastica_cad import Hole, InputError, Perforated, Slot
from elastica_cad.mechanics import PerforatedSection, ScaleRange
from elastica_cad.strip import compensate_kerf, text_strokes
from elastica_cad.strip.corner_rounding import round_corners
from elastica_cad.strip.uncuttable_parts import find_strip_faults

CARD = ec.Sheet.named("card-200gsm")
STATIONS = 1000


@pytest.fixture(scope="module")
def rod():
    return ec.optimal_rod(ec.PlaneCurve.spline([(0, 0), (40, 90), (110, 100), (190, 70), (220, 0)]))


def wavy(s):
    return 30.0 + 6.0 * np.sin(s / 60.0)


def polygon(strip, tolerance=1e-4):
    return shapely.Polygon(strip.outline.points(tolerance), [hole.points(tolerance) for hole in strip.holes])


def ligament_sum(strip, s):
    """Independent of the package's own measure: lines across, cut with the part by shapely."""
    ends = np.stack([np.column_stack([s, np.full_like(s, y)]) for y in (-1e3, 1e3)], axis=1)
    return shapely.length(shapely.intersection(shapely.linestrings(ends), polygon(strip)))


@pytest.mark.campaign
@pytest.mark.parametrize(
    "style",
    [
        Perforated(width=wavy, columns=3, rows=8),
        Perforated(width=30.0, columns=1),
        Perforated(width=26.0, columns=2, rows=5, sides="arc"),
        Perforated(width=wavy, columns=2, rows=7, corner_radius=0.06),
    ],
)
def test_ligaments_sum_up_to_the_stiffness(rod, style):
    strip = ec.Strip(rod, CARD, style=style)
    s = (np.arange(STATIONS) + 0.5) * rod.length / STATIONS
    relative = ligament_sum(strip, s) / rod.profile(s)
    relative /= np.median(relative)
    joints = np.linspace(0, rod.length, 2 * strip.layout.pattern.rows + 1)
    pattern = strip.layout.pattern
    zone = pattern.bridge / 2 + float(2 * style.corner_radius / pattern.slopes(s).min())
    outside = np.abs(s[:, None] - joints).min(axis=1) > zone
    assert outside.mean() > 0.5
    assert np.abs(relative - 1)[outside].max() < 0.005
    assert np.abs(relative - 1).max() < 0.03
    assert strip.layers[0].material(s) == pytest.approx(ligament_sum(strip, s), abs=1e-3)
    assert not strip.layout.warnings


def test_sharp_holes_leave_the_exact_sum_even_at_the_tips(rod):
    strip = ec.Strip(rod, CARD, style=Perforated(width=wavy, columns=2, rows=6))
    near = strip.layout.pattern.joints[1:-1, None] + np.linspace(-0.4, 0.4, 41)
    s = near.ravel()
    assert strip.layers[0].material(s) == pytest.approx(strip.layout.material(s), rel=2e-5)


def test_columns_run_across_and_rows_along(rod):
    strip = ec.Strip(rod, CARD, style=Perforated(width=30.0, columns=3, rows=4))
    centres = np.array([hole.bounds.mean(axis=0) for hole in strip.holes])
    joints = strip.layout.pattern.joints
    for row in range(4):
        full = np.abs(centres[:, 0] - joints[2 * row + 1]) < 1.0
        assert full.sum() == 3
        assert centres[full, 1] == pytest.approx(-centres[full, 1][::-1], abs=1e-6)
    assert len(strip.holes) == 4 * 3 + 5 * 4


def test_ligaments_are_equal_and_none_is_below_the_least(rod):
    style = Perforated(width=wavy, columns=2, rows=6, least_ligament=0.7)
    strip = ec.Strip(rod, CARD, max_width=8.0, style=style)
    for s in (20.0, 111.1, 201.3):
        line = shapely.LineString([(s, -1e3), (s, 1e3)])
        parts = shapely.get_parts(shapely.intersection(line, polygon(strip)))
        widths = shapely.length(parts)
        assert widths == pytest.approx(np.full(6, strip.layout.material(s) / 6), rel=1e-4)
        assert widths.min() >= 0.7


def test_max_width_bounds_the_material_and_width_is_the_outline(rod):
    free = ec.Strip(rod, CARD, style=Perforated(width=30.0))
    bound = ec.Strip(rod, CARD, max_width=12.0, style=Perforated(width=30.0))
    loose = ec.Strip(rod, CARD, max_width=100.0, style=Perforated(width=30.0))
    assert bound.layout.material.extremes[1] == pytest.approx(12.0)
    assert loose.layout.material.extremes == pytest.approx(free.layout.material.extremes)
    for strip in (free, bound):
        assert strip.width.extremes == pytest.approx((30.0, 30.0))
        (_, low), (_, high) = strip.outline.bounds
        assert high - low == pytest.approx(30.0)


def test_scale_is_the_sections_own(rod):
    """As much material as leaves the least hole at every station: the section's range, not a second formula."""
    style = Perforated(width=wavy, columns=2, least_hole=0.8)
    strip = ec.Strip(rod, CARD, style=style)
    s = np.linspace(0, rod.length, 20001)
    section = PerforatedSection(CARD, ligaments=6)
    room: ScaleRange = section.scale_range(wavy(s) - 4 * 0.8, rod.profile(s))
    assert strip.bending_stiffness == pytest.approx(room.highest, rel=1e-6)


def test_weighs_like_its_stiffness(rod):
    strip = ec.Strip(rod, CARD, max_width=12.0, style=Perforated(width=wavy, columns=2))
    plain = ec.Strip(rod, CARD, max_width=12.0)
    tabs = 10.0 * sum(strip.end_widths) - 10.0 * sum(plain.end_widths)
    extra = tabs * CARD.thickness * CARD.density * 1e-6
    # long sides end level beside tabs: 0.01 mm at most, over a few millimetres
    assert strip.mass - extra == pytest.approx(plain.mass, rel=2e-4)
    assert strip.max_strain == pytest.approx(plain.max_strain)
    assert strip.reactions().end_force == pytest.approx(plain.reactions().end_force)


def test_as_built_is_as_designed_where_the_ligaments_are(rod):
    strip = ec.Strip(rod, CARD, max_width=12.0, style=Perforated(width=wavy, columns=2))
    assert strip.as_built.stiffness[25:-25] == pytest.approx(rod.stiffness[25:-25], rel=1e-4)
    # long sides end level beside tabs
    assert strip.as_built.stiffness == pytest.approx(rod.stiffness, rel=6e-3)
    assert strip.deviation_as_built < 2e-3


def test_a_solid_end_goes_back_into_the_rod(rod):
    """A tab narrower than the strip keeps the first holes off the end."""
    style = Perforated(width=30.0, columns=2, least_ligament=2.0, least_hole=1.0)
    held = ec.Strip(rod, CARD, style=style)
    narrow = ec.Strip(rod, CARD, style=style, ends=(ec.Tab(10.0, width=10.0), ec.Tab(10.0)))
    assert min(hole.bounds[0, 0] for hole in held.holes) == pytest.approx(0.0, abs=1e-9)
    assert min(hole.bounds[0, 0] for hole in narrow.holes) == pytest.approx(2.0, abs=1e-9)
    ratio = narrow.as_built.stiffness / rod.stiffness
    assert ratio[1] / ratio[50] == pytest.approx(30.0 / narrow.layout.material(0.0), rel=0.01)
    assert narrow.deviation_as_built > 5 * held.deviation_as_built


def test_slots_cut_holes_short_and_are_felt(rod):
    style = Perforated(width=wavy, columns=2, rows=8)
    slot = Slot(100.0, width=0.6)
    strip = ec.Strip(rod, CARD, max_width=14.0, style=style, slots=(slot,))
    part = polygon(strip)
    assert part.is_valid
    mouth = shapely.box(99.7, 0.0, 100.3, 40.0)
    assert shapely.intersection(part, mouth).area == pytest.approx(0.0, abs=1e-6)
    holes = shapely.union_all([shapely.Polygon(hole.points(1e-3)) for hole in strip.holes])
    assert holes.distance(mouth) > 0.49
    assert 1e-3 < strip.deviation_as_built < 0.5


@pytest.mark.campaign
def test_cutting_files(rod, check_drawing):
    tab = ec.Tab(12.0, holes=(Hole(6.0, 3.0),))
    style = Perforated(width=wavy, columns=1, rows=1)
    strip = ec.Strip(rod, CARD, style=style, ends=(ec.Tab(12.0), tab), label="P1")
    drawing = strip.drawing()
    check_drawing(drawing)
    rounded_arcs = Perforated(width=30.0, columns=1, rows=1, corner_radius=0.05, sides="arc")
    check_drawing(ec.Strip(rod, CARD, style=rounded_arcs).drawing(), kerf=0.1)


def test_holes_stay_apart_by_the_bridge_and_more_after_the_kerf(rod):
    style = Perforated(width=wavy, columns=2, rows=3, least_ligament=0.6)
    drawing = ec.Strip(rod, CARD, max_width=10.0, style=style).drawing()
    for kerf, least in ((0.0, 0.6), (0.1, 0.69)):
        loops = [
            shapely.Polygon(path.points(1e-3)) for path in compensate_kerf(drawing, kerf).on("CUT_INNER")
        ]
        gaps = [a.distance(b) for i, a in enumerate(loops) for b in loops[:i]]
        assert min(gaps) > least - 1e-3


def test_steps_of_the_outline_become_steps_of_the_holes():
    knots = np.concatenate([np.repeat(0.0, 4), np.repeat(33.0, 4), np.repeat(120.0, 4)])
    width = ec.Profile(knots, np.repeat([20.0, 26.0], 4))
    strip = ec.Strip(ec.Rod.straight(120.0, [1, 2, 1]), CARD, style=Perforated(width=width, rows=3))
    s = np.array([10.0, 32.9, 33.1, 70.0])
    assert ligament_sum(strip, s) == pytest.approx(strip.layout.material(s), rel=1e-4)


@pytest.mark.parametrize(
    ("style", "max_width", "words"),
    [
        (Perforated(width=30.0, columns=2, hole_ratio=0.99), 2.0, ["0.5 mm", "286 mm", "raise max_width"]),
        (Perforated(width=30.0, hole_ratio=0.3), None, ["30 %", "286 mm", "hole_ratio to 0.3"]),
        (Perforated(width=lambda s: 30 - 0.09 * s), None, ["285.7 mm", "6 ligaments", "fewer columns"]),
        (Perforated(width=30.0, rows=200), 20.0, ["200 rows", "fewer rows"]),
        (Perforated(width=lambda s: 8 + 0.2 * s, columns=2), None, ["hole"]),
        (Perforated(width=lambda s: 0 * s - 1.0), None, ["width of the outline", "give numbers above 0"]),
        (Perforated(width=np.nan), None, ["width of the outline"]),
    ],
)
def test_what_cannot_be_cut_is_refused_with_the_place(rod, style, max_width, words):
    with pytest.raises(InputError) as refusal:
        ec.Strip(rod, CARD, max_width=max_width, style=style)
    for word in words:
        assert word in str(refusal.value)


def test_an_infeasible_outline_names_what_would_do(rod):
    """Widening as told makes it just feasible."""
    stiff = ec.Rod.straight(200.0, ec.Profile.fit(lambda s: 1 + s / 20, 200.0))
    with pytest.raises(InputError, match=r"1 column") as refusal:
        ec.Strip(stiff, CARD, style=Perforated(width=30.0, columns=2, hole_ratio=0.95))
    needed = float(str(refusal.value).split("make the outline at least ")[1].split(" mm")[0])
    ec.Strip(stiff, CARD, style=Perforated(width=needed * 1.001, columns=2, hole_ratio=0.95))
    ec.Strip(stiff, CARD, style=Perforated(width=30.0, columns=1, hole_ratio=0.95))


@pytest.mark.parametrize("width", [17.0, 20.0, 26.0, 31.0])
def test_one_width_that_is_reported_will_do_whatever_limits_it(width):
    """Wider everywhere, more must be left at the narrowest place, too: 31.2 mm had been told 32.5, then 33.6."""
    sheet = ec.Sheet.named("birch-plywood-0.8")
    stiff = ec.Rod.straight(380.0, ec.Profile.fit(lambda s: 1 + 5.08 * s / 380, 380.0))
    with pytest.raises(InputError) as refusal:
        ec.Strip(stiff, sheet, style=Perforated(width=width, columns=2, rows=20))
    result = float(str(refusal.value).split("make the outline at least ")[1].split(" mm")[0])
    ec.Strip(stiff, sheet, style=Perforated(width=result, columns=2, rows=20))


def test_no_outline_is_reported_where_none_would_do():
    stiff = ec.Rod.straight(200.0, ec.Profile.fit(lambda s: 1 + 7 * s / 200, 200.0))
    with pytest.raises(InputError, match="hole_ratio") as refusal:
        ec.Strip(stiff, CARD, style=Perforated(width=30.0))
    assert "make the outline" not in str(refusal.value)


@pytest.mark.parametrize(
    "options",
    [{"columns": 0}, {"rows": 1.5}, {"hole_ratio": 1.5}, {"least_hole": 0.0}, {"corner_radius": -1}],
)
def test_bad_options(options):
    with pytest.raises(InputError):
        Perforated(width=30.0, **options)


def test_steep_ligaments_and_large_radii_are_reported(rod):
    steep = ec.Strip(rod, CARD, style=Perforated(width=30.0, columns=1, rows=30))
    assert any(text.startswith("the ligaments") for text in steep.warnings)
    blunt = ec.Strip(rod, CARD, max_width=10.0, style=Perforated(width=30.0, corner_radius=0.4))
    (text,) = blunt.warnings
    result = float(text.split("leaves ")[1].split(" %")[0]) / 100
    s = (blunt.layout.pattern.joints[1:-1, None] + np.linspace(-3, 3, 601)).ravel()
    excess = (blunt.layers[0].material(s) / blunt.layout.material(s) - 1).max()
    assert 0.6 * result < excess < 1.05 * result
    allowed = float(text.split(": use ")[1].split(" mm")[0])
    ec.Strip(rod, CARD, max_width=10.0, style=Perforated(width=30.0, corner_radius=allowed))


def test_rounded_corners_of_a_rectangle():
    loop = round_corners(ec.Path.rectangle(10.0, 6.0), 1.5)
    assert loop.area == pytest.approx(60 - (4 - np.pi) * 1.5**2)
    assert loop.length == pytest.approx(32 - 12 + 3 * np.pi)
    with pytest.raises(InputError, match="corner radius"):
        round_corners(ec.Path.rectangle(10.0, 6.0), 4.0)


@pytest.mark.parametrize(("lengths", "where"), [((12, 9), -6), ((0, 9), 4.5), ((0, 0), None)])
def test_a_label_stands_on_a_tab_that_is_there(rod, lengths, where):
    ends = tuple(ec.Tab(length) for length in lengths)
    (drawing,) = ec.Strip(rod, CARD, style=Perforated(width=30.0), ends=ends, label="P1").drawings()
    if where is None:
        assert not drawing.texts
        return
    (text,) = drawing.texts
    strokes = np.concatenate([stroke.points(0.1) for stroke in text_strokes(text)])
    low, high = strokes.min(axis=0), strokes.max(axis=0)
    start = 0 if where < 0 else rod.length
    assert (low[0] + high[0]) / 2 == pytest.approx(start + where, abs=0.3)
    assert low[0] > start - lengths[0]
    assert high[0] < rod.length + lengths[1]
    assert np.abs((low + high)[1]) < 0.3


@pytest.mark.campaign
def test_a_radius_that_leaves_too_much_at_the_tips_is_listed_with_the_share_that_is_there(rod):
    style = Perforated(width=30.0, columns=1, rows=6, corner_radius=0.6)
    strip = ec.Strip(rod, CARD, max_width=14.0, style=style, ends=(ec.Tab(12.0),) * 2)
    (result,) = [text for text in strip.warnings if "too much material" in text]
    share = float(re.search(r"leaves ([\d.]+) %", result)[1]) / 100
    place = float(re.search(r"tips of the holes ([\d.]+) mm", result)[1])
    s = np.linspace(place - 6, place + 6, 2401)
    there = ligament_sum(strip, s) / strip.layout.material(s) - 1
    assert there.max() == pytest.approx(share, rel=0.15)


@pytest.mark.parametrize("rows", [4, 8, 16, 24])
def test_ligaments_that_lean_too_far_are_listed_with_their_angle(rod, rows):
    """The angle is that between a hole's sides and the strip, where it is steepest."""
    strip = ec.Strip(rod, CARD, max_width=12.0, style=Perforated(width=30.0, columns=2, rows=rows))
    leans = []
    for hole in strip.holes:
        steps = np.abs(np.diff(hole.points(1e-3), axis=0))
        lean = np.degrees(np.arctan2(steps[:, 1], steps[:, 0]))
        leans.append(lean[lean < 80].max())  # without the ends of a hole, which run across
    result = [text for text in strip.warnings if text.startswith("the ligaments")]
    assert bool(result) == (max(leans) > 30)
    if result:
        assert float(re.search(r"by (\d+) degrees", result[0])[1]) == pytest.approx(max(leans), abs=2)


@pytest.mark.parametrize("side", ["upper", "lower"])
def test_a_slot_wider_than_holes_are_long_leaves_none_in_its_throat(side):
    style = Perforated(width=40.0, columns=4, rows=30)
    slot = ec.Slot(100.0, width=16.0, depth=20.0, side=side)
    made = ec.Strip(ec.Rod.straight(200.0, [1, 2, 1]), CARD, style=style, slots=(slot,))
    rim = shapely.Polygon(made.outline.points(1e-3))
    assert len(made.holes) > 250
    for hole in made.holes:
        assert rim.contains(shapely.Polygon(hole.points(1e-3)))


def rounded_strip(rod, radius, **options):
    """A strip with holes rounded by that radius."""
    style = Perforated(30.0, columns=2, rows=5, corner_radius=radius)
    return ec.Strip(rod, CARD, max_width=10.0, style=style, **options)


def opened(path, radius):
    """What a round tool of that radius can cut out inside a loop, by shapely."""
    return shapely.Polygon(path.points(1e-4)).buffer(-radius, quad_segs=64).buffer(radius, quad_segs=64)


@pytest.mark.parametrize("cuts", [(), (Slot(61.0, 1.0, 9.0, lean=0.3),)])
@pytest.mark.parametrize("ends", [(ec.Tab(8.0, width=9.0), ec.Tab(0.0)), (ec.Tab(8.0), ec.Tab(8.0))])
@pytest.mark.parametrize("radius", [0.1, 0.3])
def test_holes_cut_short_have_round_corners_too(rod, ends, cuts, radius):
    """At bare ends and beside narrow tabs and slots holes end bluntly, some of them narrower than the radius."""
    sharp, round_ = (rounded_strip(rod, r, ends=ends, slots=cuts) for r in (0.0, radius))
    left = shapely.union_all([shapely.Polygon(hole.points(1e-4)) for hole in round_.holes])
    wanted = shapely.union_all([opened(hole, radius) for hole in sharp.holes])
    assert left.symmetric_difference(wanted).area < 2e-3 * len(sharp.holes)
    assert len(round_.holes) == len(sharp.holes)


def test_what_a_slot_leaves_of_a_hole_is_not_cut_where_the_radius_does_not_fit(rod):
    slot = Slot(rod.length * 0.3 + 6.0, 1.0, 8.0)
    sharp, round_ = (rounded_strip(rod, r, slots=(slot,)) for r in (0.0, 0.5))
    kept = shapely.MultiPoint([hole.bounds.mean(axis=0) for hole in round_.holes])
    lost = [hole for hole in sharp.holes if not shapely.Polygon(hole.points(1e-3)).intersects(kept)]
    assert 0 < len(lost) < 3
    assert all(opened(hole, 0.5).is_empty for hole in lost)


@pytest.mark.parametrize("start", [0.0, -300.0])
def test_a_blunt_end_narrower_than_the_radius_is_rounded_as_its_tip_would_be(start):
    tip = [(0.0, -0.05), (10.0, -1.05), (20.0, -0.05), (20.0, 0.05), (10.0, 1.05), (0.0, 0.05)]
    loop = ec.Path.polyline([(start + x, y) for x, y in tip], closed=True)
    found = shapely.Polygon(round_corners(loop, 0.5).points(1e-5))
    assert found.symmetric_difference(opened(loop, 0.5)).area < 1e-4
    assert found.is_valid


def test_a_wide_outline_is_narrowed_by_its_own_width():
    style = Perforated(width=24.0, columns=2, rows=1)
    strip = ec.Strip(ec.Rod.straight(20.0, [1, 2, 1]), ec.Sheet.named("card-200gsm"), style=style)
    assert any("Set a smaller style.width" in warning for warning in strip.warnings)
    (fault,) = find_strip_faults(strip, ec.FabricationLimits(stock=(60.0, 22.0)))
    assert "Set a smaller style.width" in fault.cure
