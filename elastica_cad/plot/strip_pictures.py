"""Pictures of a strip and of its travel, and drawings in the colours of their layers."""

from collections.abc import Sequence
from textwrap import fill

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import require_record
from elastica_cad.errors import Mass, number_text
from elastica_cad.geometry.plane_curve import CurveSamples, PlaneCurve
from elastica_cad.geometry.plane_points import (
    box_about,
    clipped,
    left_of,
    norm,
    points_at,
    unit,
    unit_vectors,
)
from elastica_cad.geometry.profile import Profile
from elastica_cad.mechanics.bracing import slack_elements
from elastica_cad.mechanics.elements import NOUNS, Pin, PointForce, Rail, Tie
from elastica_cad.mechanics.loads import require_curve
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.sheets import sheet_color
from elastica_cad.mechanics.theorem1 import InflectionLine
from elastica_cad.mechanics.thrust_line import inflections_of, thrust_sides
from elastica_cad.plot.canvas import (
    INK,
    WIDTH_INCHES,
    Axes,
    Figure,
    Panel,
    draw_arrow,
    hide_axes,
    new_page,
    show_box,
    write_beside,
)
from elastica_cad.strip.drawing import Drawing
from elastica_cad.strip.element_cuts import element_cuts
from elastica_cad.strip.holding_template import HeldEnd, distance_between, freedom_text, held_ends
from elastica_cad.strip.strip import Strip
from elastica_cad.strip.travel import Travel

LAYER_COLORS = {
    "CUT_OUTER": "#c2452d",
    "CUT_INNER": "#2f6db3",
    "ENGRAVE": INK,
    "MARK": "#3a8f4d",
    "SHEET": "#8a8f98",
}
COMB, LINE, FAINT, HOLD = "#2f6db3", "#c2452d", "#8a8f98", "#3a8f4d"
LOAD = "#c77700"
MARKERS = {Rail: "^", Pin: "o", Tie: "s"}

NUMBERED = Panel(5.2, above=0.54, below=0.52, left=0.8, right=0.15)
"""Panel for a drawing with numbers on both axes, a title, and a legend below the title."""

STIFFNESS = NUMBERED._replace(height=1.6, above=0.32)
"""Panel for the graph of the stiffness along the strip, with a title."""

WIDE = WIDTH_INCHES - NUMBERED.left - NUMBERED.right
"""Width of the axes, inches."""


def numbered_panel(size: FloatArray, least: float = 2.2, most: float = 5.2) -> Panel:
    """Return a panel for a drawing of a size (2,) with numbers on both axes. The limits are its height, inches."""
    return NUMBERED._replace(height=float(np.clip(WIDE * size[1] / size[0], least, most)))


MARGIN_FRACTION = 0.04
"""Space beside the flat strip, as a fraction of its length."""

SMOOTH_MM = 0.02
"""Largest distance, mm, between a spline and the drawn polyline: less than a printed dot."""


def rod(rod: Rod, *, wish: PlaneCurve | None = None, design: Rod | None = None) -> Figure:
    """Draw the bent rod with its curvature comb and inflection line, and its stiffness along the strip.

    Parameters
    ----------
    rod : Rod
    wish : PlaneCurve, optional
        Requested curve, if the rod has the nearest possible curve instead.
    design : Rod, optional
        Designed shape of a loaded or moved rod. A displacement below 1 % of the length is also drawn enlarged.
        With `design`, the inflection line and the thrust line are left out.
    """
    require_record(rod, Rod, "what is drawn", "a Rod")
    require_record(design, Rod | None, "the designed shape", "a Rod")
    figure, (above, below) = new_page([_bent_panel(rod, wish), STIFFNESS])
    _paint_bent(above, rod, wish, design=design)
    _paint_stiffness(below, rod)
    return figure


def strip(strip: Strip) -> Figure:
    """Draw the flat strip with its dimensions."""
    require_record(strip, Strip, "what is drawn", "a Strip")
    figure, (axes,) = new_page([_flat_panel(strip)])
    _paint_dimensioned(axes, strip)
    return figure


def drawing(drawing: Drawing) -> Figure:
    """Draw a drawing in the colours of its layers."""
    from matplotlib.collections import LineCollection

    require_record(drawing, Drawing, "what is drawn", "a Drawing")
    low, high = drawing.bounds
    size = np.maximum(high - low, 1e-9)
    figure, (axes,) = new_page([numbered_panel(size, 1.6, 11.0)])
    for layer in dict.fromkeys(item.layer for item in drawing.strokes):
        strokes = [item.path.closed_points(SMOOTH_MM) for item in drawing.strokes if item.layer == layer]
        # do not snap to pixels, because snapping removes dots of letters
        axes.add_collection(
            LineCollection(strokes, colors=LAYER_COLORS[layer], linewidths=0.9, label=layer, snap=False)
        )
    axes.autoscale_view()
    finish_axes(axes, f"{drawing.name}: {size[0]:.1f} by {size[1]:.1f} mm")
    return figure


def strip_sheet(strip: Strip, *, wish: PlaneCurve | None = None) -> Figure:
    """Draw a page about a strip: its bent curve, its stiffness along the curve, and its flat pattern.

    Parameters
    ----------
    strip : Strip
    wish : PlaneCurve, optional
        Requested curve, if the strip has the nearest possible curve instead.

    Returns
    -------
    matplotlib.figure.Figure
        `save_figure` writes it to a file.

    Raises
    ------
    MissingDependencyError
        matplotlib is not installed.
    """
    require_record(strip, Strip, "what is drawn", "a Strip")
    sheet = strip.sheet
    size = strip.breadth() if strip.tapered else f"{sheet.thickness:g} mm thick"
    facts = f"{sheet.name}, {size}, {Mass(strip.mass)}"
    strain = f"largest strain {100 * strip.max_strain:.2f} %, {100 * strip.strain_limit:.2f} % allowed"
    title = f"{fill(strip.label or 'Strip', 90)}\n{facts}; {strain}"
    ends = () if strip.is_closed else held_ends(strip)
    panels = [_bent_panel(strip.rod, wish, ends), STIFFNESS, _flat_panel(strip)]
    figure, (bent, *below) = new_page(panels, title)
    _paint_bent(bent, strip.rod, wish, ends)
    _paint_stiffness(below[0], strip.rod)
    _paint_dimensioned(below[1], strip)
    (start, _), (end, _) = strip.outline.bounds
    margin = MARGIN_FRACTION * (end - start)
    for axes in below:
        axes.set_xlim(start - margin, end + margin)
    return figure


def paint_flat(axes: Axes, strip: Strip, shift: tuple[float, float] = (0.0, 0.0)) -> None:
    """Paint the flat pattern, moved by `shift` mm, in the colours of its sheets. A backing is translucent."""
    from matplotlib.patches import PathPatch
    from matplotlib.path import Path as Outline

    for layer in strip.layers:
        # matplotlib fills all loops except those whose direction is opposite to the outline's
        loops = [layer.outline, *(hole if hole.area < 0 else hole.reversed() for hole in layer.holes)]
        outlines = [Outline(loop.closed_points(SMOOTH_MM) + shift, closed=True) for loop in loops]
        # `add_patch` would slowly compute limits from every piece of every hole
        axes.add_artist(
            PathPatch(
                Outline.make_compound_path(*outlines),
                facecolor=sheet_color(layer.sheet),
                edgecolor=INK,
                linewidth=1.0,
                alpha=None if layer is strip.layers[0] else 0.6,
            )
        )


def _bent_panel(rod: Rod, wish: PlaneCurve | None, ends: Sequence[HeldEnd] = ()) -> Panel:
    shown = [rod.position, comb_tips(rod), *(end.tip[None] for end in ends)]
    if wish is not None:
        require_curve(wish)
        shown.append(wish.sample(200).position)
    return numbered_panel(_widened(np.ptp(_with_room_below(np.concatenate(shown), ends), axis=0)))


def _with_room_below(points: FloatArray, ends: Sequence[HeldEnd]) -> FloatArray:
    width, height = _widened(np.ptp(points, axis=0))
    # space for the angles below the ends
    room = 0.3 * max(width / WIDE, height / NUMBERED.height)
    return np.concatenate([points, *(end.position[None] - (0.0, room) for end in ends)])


def _paint_bent(
    axes: Axes, rod: Rod, wish: PlaneCurve | None, ends: Sequence[HeldEnd] = (), design: Rod | None = None
) -> None:
    """Draw the bent strip with the comb of its curvature, inflections, loads and angles.

    `wish` is the drawn curve, and `design` the designed shape of a loaded or moved rod; see `rod`.
    """
    position, tips, turns = rod.position, comb_tips(rod), inflections_of(rod)
    paint_comb(axes, position, tips)
    wished = [] if wish is None else [wish.sample(600).position]
    for points in wished:
        axes.plot(*points.T, color=FAINT, linewidth=1.4, linestyle=(0, (4, 2)), label="drawn curve")
    if design is not None:
        wished += _paint_displacement(axes, rod, design)
    axes.plot(*position.T, color=INK, linewidth=2.2, label="strip")
    if len(turns):
        called = "inflection" if len(turns) == 1 else "inflections"
        axes.plot(*turns.T, "o", color=LINE, markersize=6, label=called)
    tabs = [np.array([end.position, end.tip]) for end in ends]
    for end, tab in zip(ends, tabs, strict=True):
        axes.plot(*tab.T, color=FAINT, linewidth=2.2)
        angle_text = f"{end.tilt:.1f}°" if end.support.angle else freedom_text(end.support)
        beside = 22 * np.sign(end.outward[0]) * end.outward[1]  # move the text away from a steep tab
        inward = "left" if end.outward[0] < 0 else "right"  # keep a long text inside the axes
        align = inward if end.support.is_free else "center"
        write_beside(axes, angle_text, end.position, (beside, -6), ha=align, va="top")
    low, high = box_about(np.concatenate([position, tips, *wished, *tabs, turns]))
    # `shown` has points that the axes must contain
    reach, shown = 0.04 * float(np.max(high - low)), [low, high]
    if design is None and rod.thrust_line and not rod.acting:
        shown += paint_inflection_line(axes, rod.thrust_line[0], low - reach, high + reach)
    for k, side in enumerate([] if design else thrust_sides(rod, low, high)):
        axes.plot(*side.T, color=LINE, linewidth=1.0, linestyle="--", label="_side" if k else "thrust line")
    _mark_stations(axes, rod)
    shown += _mark_loads(axes, rod, float(np.max(high - low)))
    # enlarge the axes of a nearly straight curve, so that their numbers can be read
    box = box_about(_with_room_below(np.array(shown), ends))
    half, middle = _widened(box[1] - box[0]) / 2, box.mean(axis=0)
    show_box(axes, middle - half, middle + half)
    _paint_both_axes(axes, f"Bent: {rod.length:.1f} mm along the curve")
    if len(ends) == 2:
        axes.set_xlabel(
            f"x (mm); ends {distance_between(ends):.1f} mm apart, angles from the line between them"
        )
    _paint_legend(axes)


def _paint_stiffness(axes: Axes, rod: Rod) -> None:
    s = np.linspace(0.0, rod.length, 1201)
    stiffness = rod.profile(s)
    axes.plot(s, stiffness, color=INK, linewidth=1.6)
    axes.fill_between(s, 0, stiffness, color=COMB, alpha=0.12, linewidth=0)
    show_box(axes, (0.0, 0.0), (s[-1], 1.12 * stiffness.max()))
    axes.set_xlabel("arc length from the start of the free part (mm)")
    axes.set_ylabel("stiffness K")
    _set_title(axes, f"Stiffness: largest over smallest {rod.ratio:.3f}")
    axes.grid(visible=True, color="#e3e5e8", linewidth=0.6)
    _style_spines(axes)


def _flat_panel(strip: Strip) -> Panel:
    (left, bottom), (right, top) = strip.outline.bounds
    tall = float(np.clip(WIDE * ((top - bottom) / (right - left) + 0.13), 1.2, 4.5))
    return STIFFNESS._replace(height=tall, below=0.08)


def _paint_dimensioned(axes: Axes, strip: Strip) -> None:
    """Draw the flat strip with its length, widths at stations, and places of cuts for cords and pins."""
    paint_flat(axes, strip)
    (left, bottom), (right, top) = strip.outline.bounds
    length, free = right - left, strip.rod.length
    # step of the distances of texts and lines from the outline, mm
    unit = 0.012 * length
    axes.plot([0, 0, np.nan, free, free],
              [bottom, top, np.nan, bottom, top], color=FAINT, linewidth=0.8, linestyle=":")  # fmt: skip
    cuts = element_cuts(strip.rod)
    above, below = top + (2.4 if cuts else 1.6) * unit, bottom - 1.2 * unit
    line, whole = np.array([(left, above), (right, above)]), f"{length:.2f} mm in all, {free:.2f} mm free"
    draw_arrow(axes, line[0], line[1], FAINT, 0.8, "<->")
    write_beside(axes, whole, line.mean(axis=0), (0, 3), ha="center", va="bottom")
    called, size = next(iter(strip.tapered.items()), ("widths", strip.width))
    for x in _stations_of(size):
        half = float(strip.width(x)) / 2
        axes.plot([x, x], [-half, half], color=LINE, linewidth=0.9)
        axes.text(x, below, f"{float(size(x)):.2f}", ha="center", va="top", fontsize=9, color=LINE)
    for cut in cuts:
        axes.text(
            cut.at, top + 0.2 * unit, f"{cut.at - left:.1f}", ha="center", va="bottom", fontsize=9, color=INK
        )
    margin = MARGIN_FRACTION * length
    show_box(axes, (left - margin, bottom - 5.0 * unit), (right + margin, top + 5.2 * unit))
    hide_axes(axes)
    then = "; to be bent beforehand" if np.any(strip.rod.natural_curvature) else ""
    places = "; above, places of the cord and pin cuts from the left end" if cuts else ""
    title = f"Flat: {strip.breadth()}, {called} in mm below{places}{then}"
    if strip.backing_side:
        title += f"\n{fill(strip.backing_side, 100)}"
    _set_title(axes, title)


def _widened(size: FloatArray) -> FloatArray:
    """Return a size with each side at least 0.3 times the longer side, for legible numbers on the axes."""
    return np.asarray(1.1 * np.maximum(size, 0.3 * size.max()))


def _stations_of(size: Profile) -> list[float]:
    """Return the stations, mm, of labels that do not overlap: widest and narrowest place, ends and quarters."""
    length = size.length
    s = np.linspace(0.0, length, 801)
    # round the widths, so that rounding errors do not choose between places of equal width
    w = np.round(size(s), 9)
    candidates = [s[w.argmax()], s[w.argmin()], *(length * np.array([0.0, 1.0, 0.5, 0.25, 0.75]))]
    stations: list[float] = []
    for x in map(float, candidates):
        if all(abs(x - other) > 0.08 * length for other in stations):
            stations.append(x)
    return sorted(stations)


def paint_inflection_line(
    axes: Axes, line: InflectionLine | None, low: FloatArray, high: FloatArray
) -> list[FloatArray]:
    """Paint the part of an inflection line inside a box, and return the ends of this part."""
    ends = None if line is None else clipped(np.array(line.point), np.array(line.direction), low, high)
    if ends is None:
        return []
    axes.plot(*ends.T, color=LINE, linewidth=1.0, linestyle="--", label="inflection line")
    return [*ends]


def _paint_displacement(axes: Axes, rod: Rod, design: Rod) -> list[FloatArray]:
    """Draw the designed shape and, if the displacement is small, an enlarged shape. Return both lines."""
    light = {"color": FAINT, "linewidth": 1.2}
    lines = [design.position]
    axes.plot(*design.position.T, label="design", linestyle=(0, (4, 2)), **light)
    if len(design.position) != len(rod.position):
        return lines
    move = rod.position - design.position
    part = float(norm(move).max()) / rod.length
    # a displacement of less than 1 % of the length is also drawn enlarged to about 5 %
    if 1e-5 < part < 0.01:
        factor = float(f"{0.05 / part:.0e}")
        lines.append(design.position + factor * move)
        axes.plot(*lines[1].T, label=f"displacement x {factor:g}", **light)
    return lines


def _mark_stations(axes: Axes, rod: Rod) -> None:
    """Draw labelled markers of rails, pins and ties. A tie is a dotted line. Slack rails and ties are grey.

    The label of a rail is on the side from which the rail pushes.
    """
    slack = slack_elements(rod.between, rod.force)
    # `beside` is the offset of the label, points
    for action in rod.between:
        noun = NOUNS[type(action.element)]
        at = points_at(action.s, rod.s, rod.position)
        beside = (0.0, 9.0) if len(at) > 1 else tuple(-14 * action.force[0] / (action.size or 1.0))
        color = HOLD
        if action in slack:
            color, noun, beside = FAINT, f"{noun}, slack", (0.0, -14.0)
            if isinstance(action.element, Rail) and action.mount is not None:
                at = np.array([action.mount.point])
        mark = {"color": color, "markersize": 8, "markerfacecolor": "none", "linestyle": ":"}
        axes.plot(*at.T, MARKERS[type(action.element)], label=f"_{noun}", **mark)
        write_beside(axes, noun, at.mean(axis=0), beside, color, ha="center", va="center")


def _mark_loads(axes: Axes, rod: Rod, size: float) -> list[FloatArray]:
    """Draw an arrow for each point force and mass, and return the positions of the labels.

    `size` is the size of the drawing, mm.
    """
    places = []
    # arc length (1,), direction (2,) and label of each load
    loads = [(load.s, load.force[0], NOUNS[PointForce]) for load in rod.point_forces]
    if rod.gravity is not None and rod.weight is not None:
        down = np.array(rod.gravity.direction)
        loads += [(np.array([mass.s]), down, f"{mass.mass:g} g") for mass in rod.weight.masses]
    for s, force, text in loads:
        (head,) = points_at(s, rod.s, rod.position)
        way = 0.08 * size * unit(force)
        draw_arrow(axes, head, head - way, LOAD, 1.6)
        places.append(head - 1.25 * way)
        axes.text(*places[-1], text, ha="center", va="center", fontsize=9, color=LOAD)
    return places


def comb_tips(rod: Rod | CurveSamples) -> FloatArray:
    """Return the ends (n, 2) of the teeth of the curvature comb."""
    largest = float(np.abs(rod.curvature).max())
    extent = float(np.ptp(rod.position, axis=0).max())
    # the longest tooth is 16 % of the size of the curve
    scale = 0.16 * extent / largest if largest > 0 else 0.0
    return rod.position - scale * rod.curvature[:, None] * left_of(unit_vectors(rod.angle))


def paint_comb(axes: Axes, position: FloatArray, tips: FloatArray) -> None:
    """Paint at most 199 teeth of a curvature comb, and the line through all tips."""
    step = max(1, len(position) // 100)
    teeth = np.stack([position, tips, np.full_like(tips, np.nan)], axis=1)[::step].reshape(-1, 2)
    axes.plot(*teeth.T, color=COMB, linewidth=0.5, alpha=0.6)
    axes.plot(*tips.T, color=COMB, linewidth=0.8, label="curvature comb")


def finish_axes(axes: Axes, title: str) -> None:
    """Draw numbers along both axes, a title, and the legend."""
    _paint_both_axes(axes, title)
    _paint_legend(axes)


def _paint_both_axes(axes: Axes, title: str) -> None:
    axes.set_aspect("equal")
    axes.set_xlabel("x (mm)")
    axes.set_ylabel("y (mm)")
    _set_title(axes, title, pad=22)
    _style_spines(axes)


def _set_title(axes: Axes, title: str, pad: float = 6.0) -> None:
    axes.set_title(title, fontsize=10, loc="left", color=INK, pad=pad, y=1.0)


def _style_spines(axes: Axes) -> None:
    axes.spines[["top", "right"]].set_visible(False)
    axes.tick_params(labelsize=9)


def _paint_legend(axes: Axes) -> None:
    axes.legend(
        fontsize=9, frameon=False, loc="lower left", bbox_to_anchor=(-0.01, 1.0), ncols=5, borderpad=0.1
    )


# colours of the first and the last shape, and of unstable shapes
FIRST, LAST, UNSTABLE = "#a9c6e8", "#1d4f8c", "#c2452d"
SHAPES = Panel(3.2, above=0.3, below=0.52, left=0.8, right=0.8)
# panel with force on the left axis and energy on the right
COSTS = SHAPES._replace(height=2.4, above=NUMBERED.above)
FORCE, ENERGY = "#1d4f8c", "#e0962b"


def travel(moved: Travel) -> Figure:
    """Draw all shapes of a travel, and below them the force along the path and the bending energy.

    If the travel has a single step, its shape and the designed shape are drawn without a graph.

    Dotted lines mark the positions on the path to which `Travel.warnings` refer.

    Examples
    --------
    >>> import elastica_cad as ec
    >>> clip = ec.Strip(ec.Rod.straight(100.0, samples=201), "spring-steel-0.2", max_width=10.0)
    >>> len(ec.plot.travel(ec.bend_strip(clip, [(95.0, 0.0), (90.0, 0.0)])).axes)
    3
    """
    require_record(moved, Travel, "what is drawn", "a Travel")
    steps = len(moved.rods)
    if steps == 1:
        return rod(moved.rods[0], design=moved.strip.rod)
    figure, (above, below) = new_page([SHAPES, COSTS])
    colors = blend(steps)
    for k, shape in enumerate(moved.rods):
        color = colors[k] if moved.stable[k] else UNSTABLE
        above.plot(*shape.position.T, color=color, linewidth=1.6 if k in (0, steps - 1) else 0.9)
    above.set_aspect("equal", adjustable="datalim")
    snapping = "" if moved.stable.all() else "; red: unstable, it snaps away"
    _set_title(above, f"{steps} shapes, the last one darkest{snapping}")
    above.set_xlabel("x, mm")
    above.set_ylabel("y, mm")
    if moved.unit == "deg":
        way, name, force = "turn of the end, degrees", "moment, N mm", moved.turning_moment
    elif moved.unit == "mm":
        way, name, force = "travel of the end, mm", "force, N", moved.force_along
    elif moved.unit == "N":
        way, name, force = "load, N", "largest movement under the load, mm", moved.sag
    else:
        way, name, force = "change of rails, pins and cords, %", "force, N", moved.support_force
    # before new loads grow, the ends move: only the last of these shapes is on the axis of the loads
    begins = [moved.stages[k].unit for k, _ in moved.places].index(moved.unit)
    shown = slice(max(begins - 1, 0), None)
    below.plot(moved.path_length[shown], force[shown], color=FORCE, marker=".")
    below.set_xlabel(way)
    below.set_ylabel(name, color=FORCE)
    below.grid(alpha=0.25)
    beside = below.twinx()
    beside.plot(moved.path_length[shown], moved.energy[shown], color=ENERGY, linestyle="--")
    beside.set_ylabel("bending energy, N mm", color=ENERGY)
    for axes in (below, beside):  # include 0, so that a nearly constant force looks constant
        low, high = axes.get_ylim()
        room = 0.05 * (high - low) if low * high > 0 else 0.0
        axes.set_ylim(min(low - room, 0.0), max(high + room, 0.0))
    places = (
        ("force falls", moved.force_falls_at, FORCE), ("strain limit", moved.strained_at, INK),
        ("snaps", moved.snaps_at, UNSTABLE), ("crosses itself", moved.crosses_at, FAINT),
    )  # fmt: skip
    for text, at, color in places:
        if at is not None:
            below.axvline(
                at, color=color, linestyle=":", label=f"{text}: {number_text(at, '.4g')} {moved.unit}"
            )
    if below.get_legend_handles_labels()[0]:
        _paint_legend(below)
    worst = moved.safety.argmin()
    text = (
        f"largest strain {100 * moved.strain[worst]:.2f} % at {moved.words(moved.places[worst])}, "
        f"safety {number_text(moved.safety[worst], '.2g')}"
    )
    _set_title(below, text, pad=22 if below.get_legend() else 6)
    return figure


def blend(count: int) -> list[tuple[float, float, float]]:
    """Return `count` colours, evenly spaced from `FIRST` to `LAST`."""
    a, b = (np.array([*bytes.fromhex(color[1:])]) / 255 for color in (FIRST, LAST))
    return [tuple(a + (b - a) * part) for part in np.linspace(0, 1, max(count, 2))][-count:]
