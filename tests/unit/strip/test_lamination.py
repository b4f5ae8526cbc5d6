"""Laminated strips: the exact section met at every station, two drawings that register, refusals."""

from dataclasses import replace

import numpy as np
import pytest
import shapely

import elastica_cad as ec
from elastica_cad import Frame, Hole, InputError, Laminated, Perforated, Slot, Weight
from elastica_cad.mechanics import LaminatedSection, optimal_laminate
from elastica_cad.strip import BentSolid

CARD = ec.Sheet.named("card-200gsm")
THICK = ec.Sheet("card-400", 0.4, 2.5 * CARD.youngs_modulus, density=900.0, max_strain=0.006)
PLY = ec.Sheet.named("birch-plywood-0.8")
BOW = ec.PlaneCurve.spline([(0, 0), (21, 64), (106, 99), (191, 64), (212, 0)])
ARCH = ec.PlaneCurve.spline([(0, 0), (40, 90), (110, 100), (190, 70), (220, 0)])


@pytest.fixture(scope="module")
def rod():
    return ec.optimal_rod(ARCH)


def wavy(s):
    return 20.0 + 4.0 * np.sin(s / 60.0)


def integrated_stiffness(strip, s):
    """E I by integrating E z^2 over both rectangles about the axis that bears no force (Gauss, exact)."""
    base, backing = (layer.sheet for layer in strip.layers)
    widths = strip.width(s), strip.layout.backing.width(s)
    x, weight = np.polynomial.legendre.leggauss(4)
    h1, h2 = base.thickness, backing.thickness
    heights = (h1 * (x + 1) / 2, h1 + h2 * (x + 1) / 2)
    parts = [
        (sheet.youngs_modulus * w[:, None] * sheet.thickness * weight / 2, z)
        for sheet, w, z in zip((base, backing), widths, heights, strict=True)
    ]
    axis = sum((p * z).sum(axis=1) for p, z in parts) / sum(p.sum(axis=1) for p, _ in parts)
    return sum((p * (z - axis[:, None]) ** 2).sum(axis=1) for p, z in parts)


@pytest.mark.parametrize("width", [22.0, wavy])
def test_section_has_the_designs_stiffness_everywhere(rod, width):
    strip = ec.Strip(rod, CARD, style=Laminated(width=width, backing=THICK))
    s = np.linspace(0.0, rod.length, 1000)
    request = strip.bending_stiffness * rod.profile(s)
    assert np.abs(integrated_stiffness(strip, s) / request - 1).max() < 1e-6
    narrowest, widest = (strip.width(s) - strip.layout.backing.width(s)).min(), rod.profile(s).max()
    assert narrowest == pytest.approx(0.0, abs=1e-3)
    assert widest == pytest.approx(rod.ratio, rel=1e-4)


def test_max_width_bounds_the_backing(rod):
    strip = ec.Strip(rod, CARD, max_width=9.0, style=Laminated(width=24.0, backing=THICK))
    assert strip.layout.backing.width.extremes[1] == pytest.approx(9.0)
    assert strip.width.extremes == pytest.approx((24.0, 24.0))


@pytest.mark.parametrize(
    ("limits", "widths"),
    [((None, None), (1.0, 24.0)), ((3.0, 9.0), (3.0, 9.0)), ((9.0, 9.0), None), ((30.0, None), None)],
)
def test_widths_of_the_backing_that_a_laminate_allows(limits, widths):
    least, most = limits
    section = Laminated(width=24.0, backing=THICK).bounded(CARD, min_width=least, max_width=most)
    assert (section and section.limits) == widths


def test_own_weight_through_the_optimal_laminate():
    """The rod comes from the mechanics; the strip rebuilds its backing, weight and rest shape."""
    width = ec.Profile.fit(wavy, ARCH.length)
    section = LaminatedSection(CARD, THICK)
    found = optimal_laminate(ARCH, section, width, direction=(0, -1), least_backing=1.0)
    strip = ec.Strip(found.rod, CARD, style=Laminated(width=width, backing=THICK))
    assert strip.layout.backing.width(found.rod.s) == pytest.approx(found.backing_width, abs=1e-3)
    assert strip.deviation_as_built < 1e-3
    assert isinstance(strip.as_built.weight, Weight)
    assert not strip.warnings


def test_a_proportional_weight_is_reported(rod):
    heavy = ec.optimal_rod(ARCH, gravity=CARD.gravity())
    strip = ec.Strip(heavy, CARD, style=Laminated(width=20.0, backing=THICK))
    assert any("optimal_laminate" in text for text in strip.warnings)
    assert strip.deviation_as_built > 1e-3


def test_mass_and_strain_are_of_both_layers(rod):
    strip = ec.Strip(rod, CARD, style=Laminated(width=24.0, backing=THICK, dots=0.0))
    s = (np.arange(40000) + 0.5) * rod.length / 40000
    w2 = strip.layout.backing.width
    area = w2(s).mean() * rod.length + 2 * 10.0 * 24.0
    base, backing = strip.layers
    # long sides end level beside tabs: 0.01 mm at most, over a few millimetres
    assert backing.area == pytest.approx(area, abs=0.2)
    assert base.area == pytest.approx(24.0 * (rod.length + 20.0))
    assert strip.mass == pytest.approx(
        1e-6 * (base.area * 0.2 * CARD.density + backing.area * 0.4 * 900.0), rel=1e-7
    )
    first, second = strip.strains
    assert (first.name, second.name) == (CARD.name, THICK.name)
    assert (first.limit, second.limit) == (CARD.max_strain, THICK.max_strain)
    kappa = np.abs(rod.curve.sample(2001).curvature)
    assert max(first.largest, second.largest) > 0.5 * 0.3 * kappa.max()
    worst = max((first, second), key=lambda layer: layer.largest / layer.limit)
    assert strip.max_strain == worst.largest


def test_drawings_register(rod, check_drawing):
    strip = ec.Strip(rod, CARD, style=Laminated(width=wavy, backing=THICK), label="L1")
    base, backing = strip.drawings()
    assert (base.name, backing.name) == ("L1", "L1-backing")
    assert strip.drawing().name == "L1"
    for drawing in (base, backing):
        check_drawing(drawing)
    dots = [[path.bounds.mean(axis=0) for path in drawing.on("CUT_INNER")] for drawing in (base, backing)]
    assert np.array(dots[0]) == pytest.approx(np.array(dots[1]))
    assert np.array(dots[0]) == pytest.approx(np.array([(-5.0, 0.0), (rod.length + 5.0, 0.0)]))
    outer, inner = (shapely.Polygon(d.on("CUT_OUTER")[0].points(1e-4)) for d in (base, backing))
    assert outer.buffer(1e-3).contains(inner)
    guides = [path for path in base.on("MARK") if path.length > 100]
    rim = inner.exterior
    for guide in guides:
        assert max(rim.distance(shapely.Point(p)) for p in guide.points(0.1)) < 2e-4
    assert len(guides) == 2


def test_holes_of_the_tabs_take_the_place_of_dots(rod):
    tab = ec.Tab(10.0, holes=(Hole(4.0, 3.0),))
    strip = ec.Strip(rod, CARD, style=Laminated(width=20.0, backing=THICK), ends=(tab, ec.Tab(0.0)))
    assert [len(layer.holes) for layer in strip.layers] == [1, 1]


def test_slots_cut_both_layers_where_they_reach(rod):
    style = Laminated(width=24.0, backing=THICK)
    whole = ec.Strip(rod, CARD, style=style)
    deep = ec.Strip(rod, CARD, style=style, slots=(Slot(100.0, width=1.0),))
    edge = float(24.0 - whole.layout.backing.width(100.0)) / 2
    shallow = ec.Strip(rod, CARD, style=style, slots=(Slot(100.0, width=1.0, depth=0.8 * edge),))
    lost = [
        [a.area - b.area for a, b in zip(whole.layers, other.layers, strict=True)]
        for other in (deep, shallow)
    ]
    assert lost[0] == pytest.approx([12.0, 12.0 - edge], abs=0.02)
    assert lost[1] == pytest.approx([0.8 * edge, 0.0], abs=1e-6)
    assert deep.deviation_as_built > 10 * whole.deviation_as_built


@pytest.mark.parametrize(
    ("style", "max_width", "words"),
    [
        (Laminated(width=lambda s: 5 + 0.2 * s, backing=CARD), None, ["mm", "times as thick"]),
        (Laminated(width=0.7, backing=CARD), None, ["0.7 mm", "narrowest backing (1 mm)"]),
        (Laminated(width=20.0, backing=CARD, least_backing=5.0), 6.0, ["max_width is 6 mm"]),
        (Laminated(width=lambda s: 0 * s, backing=CARD), None, ["width of the base", "give numbers above 0"]),
    ],
)
def test_what_cannot_be_built_is_refused_with_the_place(rod, style, max_width, words):
    with pytest.raises(InputError) as refusal:
        ec.Strip(rod, CARD, max_width=max_width, style=style)
    for word in words:
        assert word in str(refusal.value)


def test_the_thickness_that_is_reported_would_do():
    stiff = ec.Rod.straight(200.0, ec.Profile.fit(lambda s: 1 + s / 40, 200.0))
    thin = ec.Sheet("thin", 0.05, CARD.youngs_modulus, density=700.0, max_strain=0.01)
    with pytest.raises(InputError) as refusal:
        ec.Strip(stiff, CARD, style=Laminated(width=20.0, backing=thin))
    times = float(str(refusal.value).split("make the backing at least ")[1].split(" times")[0])
    enough = replace(thin, thickness=1.01 * times * CARD.thickness)
    ec.Strip(stiff, CARD, style=Laminated(width=20.0, backing=enough))
    with pytest.raises(InputError):
        ec.Strip(
            stiff,
            CARD,
            style=Laminated(width=20.0, backing=replace(thin, thickness=0.98 * times * CARD.thickness)),
        )


def test_a_rods_own_stiffness_must_fit(rod):
    for factor in (0.2, 5.0):
        free = ec.Strip(rod, CARD, style=Laminated(width=20.0, backing=THICK))
        fixed = replace(rod, bending_stiffness=factor * free.bending_stiffness)
        with pytest.raises(InputError, match="bending stiffness"):
            ec.Strip(fixed, CARD, style=Laminated(width=20.0, backing=THICK))
        with pytest.raises(InputError):
            ec.Strip(fixed, CARD, style=Perforated(width=2.0))


@pytest.mark.parametrize("options", [{"least_backing": 0.0}, {"dots": -1.0}, {"least_backing": np.nan}])
def test_bad_options(options):
    with pytest.raises(InputError):
        Laminated(width=20.0, backing=CARD, **options)


@pytest.mark.parametrize("name", ["inflected", "even base"])
def test_backing_that_fills_the_base_under_its_own_weight(name):
    """Stiffness is known to 1e-6 between its nodes: where the backing touches the base that is no refusal."""
    base = replace(CARD, name="base", thickness=0.1, thickness_range=None)
    if name == "inflected":
        x = np.linspace(-80, 130, 200)
        points = np.column_stack([x, 42 * np.sin(np.pi * x / 170)])
        curve, width = ec.PlaneCurve.fit(points, degree=5, tolerance=1e-3), None
    else:
        curve = ec.PlaneCurve.spline([(0, 0), (50, 60), (100, 40), (150, -30), (200, 0)], degree=4)
        width = 30.0
    if width is None:
        s = np.linspace(0.0, curve.length, 30)
        width = ec.Profile.interpolate(s, 20 + 5 * np.sin(3 * s / s[-1]))
    laminate = optimal_laminate(curve, LaminatedSection(base, CARD), width, direction=(0, -1))
    strip = ec.Strip(laminate.rod, base, style=Laminated(width=width, backing=CARD))
    assert len(strip.drawings()) == 2
    assert strip.as_built.ratio == pytest.approx(laminate.rod.ratio, rel=1e-3)
    assert 0 < strip.max_strain < 1


@pytest.mark.parametrize("ends", [(0.0, 0.0), (0.0, 8.0), (1e-3, 0.0)])
def test_a_backing_that_ends_without_a_tab_ends_square(rod, ends):
    """No whiskers as wide as the base: the backing's rim is as long as its sides and ends ask, not more."""
    tabs = tuple(ec.Tab(length) for length in ends)
    strip = ec.Strip(rod, CARD, style=Laminated(width=24.0, backing=THICK), ends=tabs)
    rim, width = strip.layers[1].outline.points(1e-3), strip.layout.backing.width
    for tab, x, at in zip(tabs, (0.0, rod.length), (-1, 1), strict=True):
        if tab.length < 1:
            beyond = rim[at * (rim[:, 0] - x) > -1e-3]
            assert np.ptp(beyond[:, 1]) == pytest.approx(float(width(x)), abs=1e-3)


def test_a_backing_has_no_shoulders_too_small_to_cut():
    """A backing that ends nearly as wide as the base had tabs that stood out by nm; turned bodies failed."""
    style = Laminated(width=20, backing=CARD)
    ends = (ec.Tab(10), ec.Tab(10))
    curve = ec.PlaneCurve.spline([(20, 0), (40, 60), (70, 80), (120, 60), (150, 0)])
    made = ec.make_strip(curve, CARD, style=style, limits=ec.Limits(ratio=3.0), ends=ends)
    shortest = min(segment.length for layer in made.layers for segment in layer.outline.segments)
    assert shortest > 5e-4
    for angle in (0.3, 1.0, 2.0):
        x, y = (np.cos(angle), 0.0, np.sin(angle)), (-np.sin(angle), 0.0, np.cos(angle))
        for body in BentSolid.layers(made, Frame((100.0, 50.0, 20.0), x, y)):
            assert body.boundary.is_closed


def test_a_backing_may_be_named():
    assert Laminated(width=20.0, backing="pom-0.5").backing == ec.Sheet.named("pom-0.5")
    with pytest.raises(InputError, match=r"unknown sheet 'pon-0\.5'"):
        Laminated(width=20.0, backing="pon-0.5")


@pytest.mark.campaign
@pytest.mark.parametrize("backing", [PLY, PLY.with_thickness(1.5)], ids=["as thick", "thicker"])
@pytest.mark.parametrize("ratio", [None, 1.5])
def test_a_near_laminate_bears_its_bend_in_both_layers(backing, ratio):
    """Alone the base bears the drawn arch; glued on, both layers are bent about an axis further off."""
    sharpest = np.abs(BOW.sample(2001).curvature).max()
    assert PLY.thickness / 2 * sharpest < PLY.max_strain < (PLY.thickness + backing.thickness) / 2 * sharpest
    request = {"style": Laminated(width=28.0, backing=backing), "limits": ec.Limits(ratio=ratio)}
    strip = ec.make_strip(BOW, PLY, **request)
    s = np.linspace(0.0, strip.rod.length, 1001)
    h1, h2, w1, w2 = PLY.thickness, backing.thickness, strip.width(s), strip.layout.backing.width(s)
    A1, A2 = w1 * h1 * PLY.youngs_modulus, w2 * h2 * backing.youngs_modulus
    axis = (A1 * h1 / 2 + A2 * (h1 + h2 / 2)) / (A1 + A2)
    bend = np.abs(strip.rod.bend_at(s))
    assert (axis * bend).max() < PLY.max_strain * (1 + 1e-3)
    assert ((h1 + h2 - axis) * bend).max() < backing.max_strain * (1 + 1e-3)
    assert strip.strain_verdict.allowed
    assert max(layer.largest / layer.limit for layer in strip.strains) > 0.99
    assert strip.held_deviation < 5e-3 * strip.rod.length  # borders curl


def test_a_laminate_near_a_gentle_curve_follows_it():
    gentle = ec.make_strip(ARCH, CARD, style=Laminated(width=22.0, backing=CARD), limits=ec.Limits(ratio=4.0))
    assert np.abs(gentle.rod.position - ARCH.sample(gentle.rod.s.size).position).max() < 1e-3
    assert gentle.layout.backing.width.extremes[1] == pytest.approx(22.0, rel=1e-4)
    assert gentle.rod.ratio == pytest.approx(ec.optimal_rod(ARCH).ratio, rel=0.01)


@pytest.mark.parametrize("lean", [0.0, 0.5])
def test_guides_of_the_backing_stop_at_slots(rod, lean):
    """A laser marked across the open slot, and the other strip's face behind it."""
    slots = (
        Slot(60.0, width=3.0, lean=lean),
        Slot(120.0, width=2.0, side="lower"),
        Slot(180.0, width=1.0, depth=0.1),
    )
    style = Laminated(width=24.0, backing=THICK)
    strip = ec.Strip(rod, CARD, style=style, slots=slots)
    whole = [path.length for path in ec.Strip(rod, CARD, style=style).drawings()[0].on("MARK")]
    base = strip.drawings()[0]
    material = shapely.Polygon(base.on("CUT_OUTER")[0].points(1e-4))
    guides = [path for path in base.on("MARK") if np.ptp(path.bounds[:, 0]) > 1]
    assert len(guides) == 4
    for guide in guides:
        line = shapely.LineString(guide.points(1e-3))
        assert line.difference(material.buffer(2e-3)).length == 0
    across = 3.0 / np.cos(lean) + 2.0
    assert sum(whole) - sum(p.length for p in base.on("MARK")) == pytest.approx(across, rel=0.05)


def arched(sign, *, wave=False):
    x = np.linspace(0, 120, 40)
    y = 15 * np.sin(x / 18) if wave else 40 * np.sin(np.pi * x / 120)
    return ec.optimal_rod(ec.PlaneCurve.fit(np.column_stack([x, sign * y]), tolerance=0.01))


@pytest.mark.parametrize(
    ("sign", "wave", "mark"),
    [(-1, False, "OUTSIDE"), (1, True, "INSIDE AT START")],
)
def test_both_sheets_say_which_side_of_the_bend_they_look_to(sign, wave, mark, check_drawing):
    strip = ec.Strip(arched(sign, wave=wave), CARD, style=Laminated(width=24, backing=CARD), label="L1")
    for drawing in strip.drawings():
        assert [text.text for text in drawing.texts] == [f"L1 {mark}"]
        check_drawing(drawing)
    assert mark in strip.backing_side
    assert ("at the start" in strip.backing_side) == wave
    # the backing lies on the right of the curve: outside, where that bends to the left
    solid = BentSolid.layers(strip)[1]
    places = np.array(solid.boundary.vertices)[:, :2]
    start, angle = strip.rod.position[0], strip.rod.angle[0]
    off = (places[np.hypot(*(places - start).T) < 10.5] - start) @ [-np.sin(angle), np.cos(angle)]
    assert off.max() < 1e-3
    assert off.min() == pytest.approx(-CARD.thickness, abs=1e-3)


def test_other_strips_have_no_side(rod):
    assert ec.Strip(rod, CARD, max_width=20.0).backing_side == ""
