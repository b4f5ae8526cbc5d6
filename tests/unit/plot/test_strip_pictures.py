"""Pictures: nothing overlaps, nothing is cut off, the file is whole."""

import math
from itertools import combinations

import numpy as np
import pytest
from matplotlib.text import Text as Matplotlib
from PIL import Image

import elastica_cad as ec
from elastica_cad import (
    Drawing,
    FabricationLimits,
    Hole,
    InputError,
    Path,
    PlaneCurve,
    Rod,
    Tab,
    make_strip,
    plot,
)
from elastica_cad.plot.bow_picture import bow as draw_bow
from elastica_cad.plot.strip_pictures import strip_sheet
from elastica_cad.plot.template_pages import save_templates
from elastica_cad.strip import CUT_OUTER, ENGRAVE, LayeredPath, Text

CURVES = {
    "arch": PlaneCurve.spline([(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)]),
    "S": PlaneCurve.spline([(0, 0), (50, 60), (100, 10), (150, -40), (200, 20)]),
    "tall": PlaneCurve.arc((0, 0), 100, -1.4, 1.4),
    "flat": PlaneCurve.arc((0, -2000), 2000, 1.7, 1.4),
}


def made(name, width=30):
    label = f"the {name} strip with a rather long name that goes on and on until it is time for another line"
    ends = (Tab(10, holes=(Hole(5, 3),)), Tab(10))
    return make_strip(
        CURVES[name],
        "birch-plywood-0.8",
        max_width=width,
        label=label,
        ends=ends,
        shop=FabricationLimits(least_width=0.1),
    )


def texts_of(figure):
    """What is written where, of the texts that are really drawn."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.text import Text

    renderer = FigureCanvasAgg(figure).get_renderer()
    figure.draw(renderer)
    drawn, draw = [], Text.draw
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(
            Text, "draw", lambda text, *args, **kwargs: (drawn.append(text), draw(text, *args, **kwargs))
        )
        figure.draw(renderer)
    shown = [t for t in drawn if t.get_visible() and t.get_text().strip()]
    return [(t.get_text(), t.get_window_extent(renderer)) for t in shown], figure.bbox


def assert_readable(figure):
    texts, page = texts_of(figure)
    for (one, a), (two, b) in combinations(texts, 2):
        apart = a.x1 <= b.x0 or b.x1 <= a.x0 or a.y1 <= b.y0 + 1 or b.y1 <= a.y0 + 1
        assert apart, f"{one!r} lies on {two!r}"
    for text, box in texts:
        assert page.x0 <= box.x0 < box.x1 <= page.x1, f"{text!r} leaves the page"
        assert page.y0 <= box.y0 < box.y1 <= page.y1, f"{text!r} leaves the page"


@pytest.mark.parametrize("name", sorted(CURVES))
def test_sheet_of_a_strip(name):
    wish = PlaneCurve.spline([(0, 0), (60, 40), (120, 0)], degree=2)
    assert_readable(plot.strip_sheet(made(name), wish=wish))


@pytest.mark.campaign
@pytest.mark.parametrize("picture", [
    lambda: plot.rod(made("S").rod),
    lambda: plot.rod(Rod.straight(100.0)),
    lambda: plot.strip(made("arch", width=4)),
    lambda: plot.drawing(made("arch").drawing()),
])  # fmt: skip
def test_single_pictures(picture):
    assert_readable(picture())


def test_inflection_line_passes_the_inflection():
    figure = plot.rod(made("S").rod)
    lines = {line.get_label(): line.get_xydata() for line in figure.axes[0].lines}
    (point,), line = lines["inflection"], lines["inflection line"]
    along = line[1] - line[0]
    off = (point - line[0])[0] * along[1] - (point - line[0])[1] * along[0]
    assert off / (along @ along) ** 0.5 == pytest.approx(0, abs=1e-6)


def test_inflections_are_on_the_sides_of_the_thrust_line_and_stations_are_marked():
    points = [(0, 0), (60, 60), (120, 10), (180, -40), (240, 5), (300, 60), (360, 0)]
    wave = PlaneCurve.spline(points, degree=5)
    between = (ec.Pin(200), ec.Tie(40, 310))
    rod = ec.optimal_rod(wave, between=between)
    axes = plot.rod(rod).axes[0]
    lines = {line.get_label(): line.get_xydata() for line in axes.lines}
    sides = [lines["thrust line"], *(line.get_xydata() for line in axes.lines if line.get_label() == "_side")]
    assert "inflection line" not in lines
    assert [text.get_text() for text in axes.texts] == ["pin", "tie"]
    assert lines["_tie"] == pytest.approx(wave.at([40.0, 310.0]).position, abs=1e-2)
    for point in lines["inflections"]:
        near = []
        for first, last in sides:
            way = (last - first) / np.hypot(*(last - first))
            if -1e-6 <= (point - first) @ way <= np.hypot(*(last - first)) + 1e-6:
                near.append(abs((point - first) @ [way[1], -way[0]]))
        assert min(near) < 0.05


def test_a_thrust_line_under_weight_is_where_the_forces_of_a_part_have_no_moment():
    points = [(0, 0), (60, 60), (120, 10), (180, -40), (240, 5), (300, 60), (360, 0)]
    wave = PlaneCurve.spline(points, degree=5)
    rod = ec.optimal_rod(wave, ec.Gravity(120.0, (0, -1)), between=ec.Rail(200))
    axes = plot.rod(rod).axes[0]
    lines = {line.get_label(): line.get_xydata() for line in axes.lines}
    line = np.concatenate(
        [lines["thrust line"], *(part.get_xydata() for part in axes.lines if part.get_label() == "_side")]
    )
    for point in lines["inflections"]:
        assert np.hypot(*(line - point).T).min() < 1.0  # distance of the points of the line
    weights, rail = np.asarray(rod.nodal_load), rod.between[0]
    for k in (100, 250, 400, 550):
        x = line[np.hypot(*(line - rod.position[k]).T * [[1e3], [1]]).argmin()]  # above or below the node
        acting = [(rod.force[0], rod.position[0]), *zip(weights[:k], rod.position[:k], strict=True)]
        acting.append((weights[k] / 2, rod.position[k]))
        if rod.s[k] > rail.s[0]:
            acting.append((rail.force[0], wave.at(rail.s).position[0]))
        moments = [force[0] * (x - at)[1] - force[1] * (x - at)[0] for force, at in acting]
        assert rod.moment[0] - sum(moments) == pytest.approx(0.0, abs=1e-3 * np.abs(rod.moment).max())


def test_of_a_bent_blank_the_line_passes_where_the_bending_changes_sign():
    curve = CURVES["S"]
    found = make_strip(curve, "birch-plywood-0.8", max_width=20, natural_curvature=0.001)
    figure = plot.strip_sheet(found)
    lines = {line.get_label(): line.get_xydata() for line in figure.axes[0].lines}
    points, line = lines["inflection"], lines["inflection line"]
    along = (line[1] - line[0]) / np.hypot(*(line[1] - line[0]))
    off = (points - line[0]) @ [along[1], -along[0]]
    assert len(points) == len(found.rod.check.inflections)
    assert np.abs(off).max() < 0.05
    assert "beforehand" in figure.axes[2].get_title(loc="left")


def test_png_is_written_whole_and_the_same(tmp_path):
    for name in ("a", "b"):
        plot.save_figure(plot.strip_sheet(made("arch")), tmp_path / f"{name}.png", resolution=80)
    assert (tmp_path / "a.png").read_bytes() == (tmp_path / "b.png").read_bytes()
    assert (tmp_path / "a.png").read_bytes()[:4] == b"\x89PNG"
    assert (tmp_path / "a.png").stat().st_size < 200_000
    with pytest.raises(InputError, match="exists already"):
        plot.save_figure(plot.strip(made("arch")), tmp_path / "a.png")
    with pytest.raises(InputError, match="resolution"):
        plot.save_figure(plot.strip(made("arch")), tmp_path / "c.png", resolution=0)


@pytest.mark.parametrize(("ending", "begins"), [("svg", b"<?xml"), ("PDF", b"%PDF"), ("png", b"\x89PNG")])
def test_the_ending_says_what_is_written(tmp_path, ending, begins):
    """A file named .svg had held a PNG."""
    plot.save_figure(plot.strip(made("arch")), tmp_path / f"a.{ending}", resolution=80)
    assert (tmp_path / f"a.{ending}").read_bytes().startswith(begins)


@pytest.mark.parametrize("name", ["a.jpg", "a", ".svg"])
def test_other_endings_are_refused(tmp_path, name):
    with pytest.raises(InputError, match="not have the suffix of a picture"):
        plot.save_figure(plot.strip(made("arch")), tmp_path / name)


@pytest.mark.parametrize("draw", [plot.strip_sheet, lambda strip: plot.drawing(strip.drawing())])
def test_a_png_shows_what_savefig_shows(draw, tmp_path):
    """Laid out and drawn at one go; the figure stays as it was, for whoever draws on."""
    figure, same = draw(made("S")), draw(made("S"))
    for one in (figure, same):
        one.set_facecolor("#33669980")  # half seen through
    canvas, resolution = figure.canvas, figure.dpi
    plot.save_figure(figure, tmp_path / "ours.png", resolution=120)
    same.savefig(tmp_path / "theirs.png", dpi=120, metadata={"Software": None})
    ours, theirs = (Image.open(tmp_path / name) for name in ("ours.png", "theirs.png"))
    assert ours.convert("RGBA").tobytes() == theirs.tobytes()
    assert ours.info["dpi"] == theirs.info["dpi"]
    assert (figure.canvas, figure.dpi) == (canvas, resolution)


@pytest.mark.parametrize("turned", [0.0, math.pi / 2])
def test_colons_of_a_sheet_are_seen_wherever_they_lie(turned):
    """ "P1:2" beside an upright slot read "P1 2": its dots, a part of a pixel long, were snapped to nothing."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg

    places = [(30.0 + 20 * k, 200.0 + 0.07 * k) for k in range(28)]
    colons = tuple(Text(place, ":", 4.0, turned, ENGRAVE) for place in places)
    sheet = LayeredPath(CUT_OUTER, Path.rectangle(600, 450))
    figure = plot.drawing(Drawing("base", (sheet,), colons))
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    dark = 255.0 - np.asarray(canvas.buffer_rgba(), dtype=float)[::-1, :, :3].mean(axis=2)
    seen = []
    for place in places:
        x, y = figure.axes[0].transData.transform(place).astype(int)
        seen.append(dark[y - 9 : y + 10, x - 9 : x + 10].sum())
    assert min(seen) > 0.5 * max(seen)


def test_a_travel_of_one_step_is_drawn_with_the_design():
    clip = ec.Strip(ec.Rod.straight(100.0, samples=201), "spring-steel-0.2", max_width=10.0)
    above = ec.plot.travel(ec.bend_strip(clip, [(95.0, 0.0)])).axes[0]
    lines = {line.get_label(): line.get_xydata() for line in above.lines}
    assert np.ptp(lines["design"][:, 1]) == pytest.approx(0, abs=1e-9)
    assert np.ptp(lines["strip"][:, 1]) > 10


def test_a_loaded_slat_is_drawn_with_its_loads_its_slack_rail_and_its_enlarged_sag():
    slat = ec.PlaneCurve.spline([(0, 0), (267, 14), (533, 14), (800, 0)], degree=3)
    strip = ec.make_strip(slat, "birch-plywood-6", max_width=100, between=ec.Rail(400))
    loads = (ec.PointForce(400, (0, 250)), ec.PointForce(200, (0, -30)))  # lifts the slat off its rail
    axes = plot.travel(ec.bend_strip(strip, [{"loads": loads}])).axes[0]
    lines = {line.get_label(): line.get_xydata() for line in axes.lines}
    assert not {"thrust line", "inflection line"} & {*lines}
    (enlarged,) = [label for label in lines if label.startswith("displacement")]
    factor = float(enlarged.rpartition(" ")[2])
    move = lines["strip"] - lines["design"]
    assert lines[enlarged] == pytest.approx(lines["design"] + factor * move)
    assert 20 < np.hypot(*move.T).max() * factor < 60
    assert {text.get_text() for text in axes.texts} == {"", "point force", "rail, slack"}
    arrows = [text for text in axes.texts if not text.get_text()]
    up, down = (np.subtract(arrow.xy, arrow.get_position()) for arrow in arrows)
    assert (up[1] > 0, down[1] < 0, up[0], down[0]) == (True, True, 0, 0)


def test_an_arrow_names_a_mass_and_a_tie_its_cord():
    arch = ec.PlaneCurve.spline([(0, 0), (60, 60), (120, 80), (180, 60), (240, 0)])
    weight = ec.Weight(masses=(ec.PointMass(100, 8),), own=True)
    rod = ec.optimal_rod(arch, ec.Gravity(400.0, (0, -1)), weight=weight, between=ec.Tie(40, 250))
    axes = plot.rod(rod).axes[0]
    texts = {text.get_text(): text for text in axes.texts}
    assert texts["tie"].xy == pytest.approx(arch.at([40.0, 250.0]).position.mean(axis=0), abs=0.1)
    assert texts["8 g"].get_position()[1] > np.interp(100, rod.s, rod.position[:, 1])


def test_shorter_cords_of_a_bow_are_named():
    arc = ec.PlaneCurve.arc((0, 0), 500, 0.8 * np.pi, 0.2 * np.pi)
    bow = ec.bow(arc, "gfrp-2", max_width=20, min_width=20)
    shorter = bow.shortened([0.05, 0.1])
    axes = draw_bow(bow, shorter).axes[0]
    (cords,) = [legend for legend in axes.artists if legend.get_title().get_text() == "shorter cords"]
    lengths = np.hypot(*shorter.end.T)
    assert [text.get_text() for text in cords.get_texts()] == [f"{length:.1f} mm" for length in lengths]


@pytest.mark.parametrize("label", [r"$\frac$", "5$ and 6$", "a$b"])
def test_names_with_dollar_signs_are_drawn_as_they_are(label, tmp_path):
    strip = make_strip(CURVES["arch"], "birch-plywood-0.8", max_width=30, label=label)
    figure = strip_sheet(strip)
    plot.save_figure(figure, tmp_path / "strip.svg")
    texts = [text for text in figure.findobj(Matplotlib) if label in text.get_text()]
    assert texts
    assert not any(text.get_parse_math() for text in texts)
    save_templates([strip.drawing()], tmp_path / "paper.pdf", title=label)
    model = ec.Model([ec.Placed(strip, (0, 0, 0), (1, 0, 0), (0, 0, 1))], name=label)
    plot.save_assembly_sheet(model, tmp_path / "sheet.pdf")
