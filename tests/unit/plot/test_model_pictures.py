"""Pictures of models (matplotlib): what is painted is the flat pattern, bent, with tabs, slots and holes."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from matplotlib.backends.backend_agg import FigureCanvasAgg
from matplotlib.figure import Figure

from elastica_cad import Hole, Model, Path, Placed, PlaneCurve, Sheet, Slot, Tab, make_strip, plot
from elastica_cad.model import PlacedTab, ring_plate
from elastica_cad.plot.canvas import paint_patches
from elastica_cad.plot.model_pictures import trapezoids

ARCH = PlaneCurve.spline([(20, 0), (40, 60), (70, 80), (120, 60), (150, 0)])
SLOTS = (Slot(at=60, width=2), Slot(at=120, width=2, side="lower"))


@pytest.fixture(scope="module")
def strip():
    ends = (Tab(14, holes=(Hole(7, 3),)), Tab(14))
    return make_strip(ARCH, "birch-plywood-0.8", max_width=20, ends=ends, slots=SLOTS)


def area(found):
    return float(np.diff(found[..., 0], axis=1)[:, 0] @ np.diff(found[..., 1:])[..., 0].mean(axis=1))


def test_all_of_the_pattern_and_nothing_else(strip):
    loops = (strip.outline, *strip.holes)
    found = trapezoids(loops, np.linspace(0, strip.rod.length, 50), 1.0)
    assert area(found) == pytest.approx(strip.area, rel=1e-3)
    middle = found.mean(axis=1)
    for slot in SLOTS:
        here = np.abs(middle[:, 0] - slot.at) < 0.9
        full = float(strip.width(slot.at))
        assert here.any()
        assert (middle[here, 2] - middle[here, 1]).sum() / here.sum() == pytest.approx(full / 2, rel=0.02)


@settings(max_examples=40, deadline=None)
@given(st.integers(3, 12), st.floats(0, 6.3), st.lists(st.floats(-3, 3), max_size=4))
def test_area_of_stars(corners, turn, stations):
    """Stars with a hole, turned anyhow: trapezoids have their area, whatever the stations."""
    angle = turn + np.pi * np.arange(2 * corners) / corners
    radius = np.where(np.arange(2 * corners) % 2, 1.5, 3.0)[:, None]
    star = Path.polygon(radius * np.column_stack([np.cos(angle), np.sin(angle)]))
    hole = Path.polygon(0.4 * np.column_stack([np.cos(angle), np.sin(angle)])[::-1])
    found = trapezoids((star, hole), np.array(stations), 0.1)
    assert area(found) == pytest.approx(abs(star.area) - abs(hole.area), rel=1e-5)


def test_a_picture_reaches_to_the_ends_of_the_tabs(strip):
    """Its title tells the extent of what is drawn, tabs along the end tangents included."""
    rod = strip.rod
    ends = [rod.position[i] + sign * 14 * np.array([np.cos(rod.angle[i]), np.sin(rod.angle[i])])
            for i, sign in ((0, -1), (-1, 1))]  # fmt: skip
    lowest = min(end[1] for end in ends)
    title = plot.model(Model((Placed(strip),))).get_suptitle()
    tall = rod.position[:, 1].max() - lowest
    shown = float(title.split(" x ")[1])
    assert tall - 0.5 <= shown <= tall + strip.sheet.thickness + 0.5


def test_flat_parts_stand_below_apart_and_named(strip):
    """Two of three parts, the first and the last, in the colours of their sheets and in one scale."""
    others = [make_strip(ARCH, "pom-0.5", max_width=width, ends=(Tab(10), Tab(10))) for width in (12, 16)]
    model = Model((Placed(strip), *(Placed(other) for other in others), Placed(strip)))
    _, below = plot.model(model, flat=2).axes
    boxes = [patch.get_path().get_extents() for patch in below.patches]
    assert [box.width for box in boxes] == pytest.approx(
        [np.ptp(one.outline.bounds, axis=0)[0] for one in (strip, others[1])], abs=1e-6
    )
    assert boxes[0].ymin > boxes[1].ymax
    names = [text.get_text() for text in below.texts]
    assert names[0].startswith("strip 1, 2 times: ")
    assert names[1].startswith("strip 3: ")
    assert names[1].endswith("pom-0.5")
    for text, box in zip(below.texts, boxes, strict=True):
        assert text.get_position()[1] > box.ymax
    assert below.patches[0].get_facecolor() != below.patches[1].get_facecolor()


def test_slots_let_the_paper_through():
    """No patch lies in the middle of a slot, seen square to the strip."""
    from matplotlib.path import Path as Region

    straight = make_strip(PlaneCurve.line((0, 0), (100, 0)), "card-200gsm", max_width=20,
                          slots=(Slot(at=50, width=4),))  # fmt: skip
    figure = plot.model(Model((Placed(straight),)), elevation=0.0, azimuth=90.0)
    (patches,) = figure.axes[0].collections

    def covered(point):
        return any(Region(p.vertices).contains_point(point) for p in patches.get_paths())

    mouths = [covered((-49.7, 8.0)), covered((-49.7, -8.0))]
    assert sorted(mouths) == [False, True]
    assert covered((-40.3, 8.1))
    assert covered((-105.3, 0.1))


@pytest.mark.parametrize("elevation", [40.0, -40.0])
def test_tabs_come_out_of_a_ring_whole(elevation):
    """The part beyond the ring is painted after it, from its face on; what is in the slot is not painted."""
    leaning = make_strip(
        PlaneCurve.line((60, 0), (75, -30)), "card-200gsm", max_width=12, ends=(Tab(12), Tab(12))
    )
    turns = 2 * np.pi * np.arange(8) / 8
    placed = tuple(Placed(leaning, (0, 0, 0), (np.cos(t), np.sin(t), 0), (0, 0, 1)) for t in turns)
    tabs = [PlacedTab.of(leaning, "start", one.frame) for one in placed]
    ring = ring_plate(tabs, Sheet.named("mdf-3"), ignore_limits=True)
    figure = plot.model(Model(placed, plates=(ring,)), elevation=elevation)
    (patches,) = figure.axes[0].collections
    colors = patches.get_facecolor()
    strip_at = np.flatnonzero(colors[:, 0] < 1.25 * colors[:, 2])
    # behind the ring, its visible face without a gap, and what comes out of it
    face = np.diff(strip_at).argmax()
    assert np.diff(strip_at)[face] > 0.4 * (len(colors) - len(strip_at))
    assert strip_at[-1] == len(colors) - 1
    assert face + 1 >= 8 * 3
    assert len(strip_at) - face - 1 >= 8 * 3


def painted(figure):
    """Red above blue by half: wood of plates; and blue above red: printed blocks."""
    (patches,) = figure.axes[0].collections
    red, _, blue, _ = patches.get_facecolor().T
    return int((red > 1.5 * blue).sum()), int((blue > 1.3 * red).sum())


def test_what_holds_the_strips_is_drawn():
    """A base of two plates below, blocks at both ends; the extent in the title grows with them."""
    arch = make_strip(ARCH, "pom-0.5", max_width=20, ends=(Tab(14), Tab(14)))
    model = Model((Placed(arch, (0, 0, 0), (1, 0, 0), (0, 0, 1)),))
    alone = plot.model(model)
    assert painted(alone) == (0, 0)
    base = model.base_plate("mdf-3")
    stood = plot.model(model, holders=(base,))
    wood, printed = painted(stood)
    assert wood > 500
    assert printed == 0
    wood, printed = painted(plot.model(model, holders=model.fixtures()))
    assert wood == 0
    assert printed > 100
    wide = np.ptp(base.outline.bounds, axis=0)
    assert f"{wide[0]:.0f} x {wide[1]:.0f} x " in stood.get_suptitle()


def test_patches_are_painted_without_seams_and_stay_polygons_in_vector_files(tmp_path):
    straight = make_strip(PlaneCurve.line((0, 0), (100, 0)), "card-200gsm", max_width=20)
    figure = plot.model(Model((Placed(straight),)), elevation=0.0, azimuth=90.0)
    canvas, axes = FigureCanvasAgg(figure), figure.axes[0]
    canvas.draw()
    pixels = np.asarray(canvas.buffer_rgba())[::-1, :, :3]
    (left, low), (right, high) = axes.transData.transform(axes.dataLim.get_points()).astype(int)
    inside = pixels[(low + high) // 2, left + 3 : right - 3]
    assert len(inside) > 300
    assert np.ptp(inside, axis=0).max() <= 1
    assert inside.max() < 255
    plot.save_figure(figure, tmp_path / "strip.svg")
    plot.save_figure(figure, tmp_path / "strip.pdf")
    text = (tmp_path / "strip.svg").read_text()
    assert "<image" not in text
    assert text.count("<path") > 80
    assert b"/Subtype /Image" not in (tmp_path / "strip.pdf").read_bytes()


def test_patches_of_a_sheet_for_paper_are_pixels(tmp_path):
    figure = Figure()
    axes = figure.add_subplot()
    squares = np.array([[(0, 0), (1, 0), (1, 1), (0, 1)]]) + np.arange(200)[:, None, None]
    paint_patches(axes, squares, np.full((200, 3), 0.5), rasterized=True)
    figure.savefig(tmp_path / "squares.svg")
    text = (tmp_path / "squares.svg").read_text()
    assert "<image" in text
    assert text.count("<path") < 100
