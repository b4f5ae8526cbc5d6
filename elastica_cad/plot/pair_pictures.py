"""Picture of a part with two states: flat part, both states, and force over travel."""

from collections.abc import Iterable, Sequence

import numpy as np

from elastica_cad._types import ArrayLike
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.geometry.plane_points import norm, unit_vectors
from elastica_cad.pairs.flexure import CentreLine, Flexure
from elastica_cad.plot.canvas import (
    INK,
    WIDTH_INCHES,
    Axes,
    Figure,
    Panel,
    draw_arrow,
    hide_axes,
    new_page,
    write_beside,
)

CUT, FIRST, SECOND, WAY = "#8a8f98", "#1f5fa8", "#c2571a", "#d9dbe0"


def pair_sheet(part: Flexure, drawn_as: Sequence[PlaneCurve] = ()) -> Figure:
    """Draw a two-state part: its flat pattern, its rest shapes with the holes of the holder, and its force.

    The requested curves `drawn_as` are drawn dashed.
    """
    # largest distance between splines and drawn polylines
    chord = 1e-4 * part.pair.length
    # centre lines and outlines of the two rest states
    lines = [part.line_through(rest.position) for rest in part.rests]
    shapes = [part.outline_along(line).points(chord) for line in lines]
    outlines = [part.outline.points(chord), np.concatenate(shapes)]
    tall = [
        float(np.clip((WIDTH_INCHES - 0.4) * np.ptp(p[:, 1]) / np.ptp(p[:, 0]), 0.6, 3.2)) for p in outlines
    ]
    right = 0.2 if part.pair.bistable else 0.7
    panels = [Panel(tall[0], 0.3, 0.1), Panel(tall[1], 0.35, 0.1), Panel(1.8, 0.35, 0.5, 0.7, right)]
    figure, (flat, bent, push) = new_page(panels)

    def paint(axes: Axes, loops: Iterable[ArrayLike], color: str = CUT) -> None:
        for loop in loops:
            axes.fill(*np.transpose(loop), color=color, lw=0.6, ec=INK)

    def paint_holes(axes: Axes, line: CentreLine) -> None:
        paint(axes, (hole.points(chord) for hole in part.holes_along(line)), "white")

    paint(flat, outlines[:1])
    paint_holes(flat, part.centre)
    thin, thick = part.thickness_range
    _equal_scales(flat, f"as cut: {part.sheet.name}, {thin:.2f} to {thick:.2f} mm thick")
    travel = part.travel
    for line in travel.position[:: max(1, len(travel.position) // 6)]:
        bent.plot(*line.T, color=WAY, lw=0.8, zorder=0)
    for line, shape, colour, name in zip(lines, shapes, (FIRST, SECOND), part.state_labels, strict=True):
        bent.fill(*shape.T, color=colour, alpha=0.75, lw=0, label=name)
        paint(bent, part.pads_along(line))
        paint_holes(bent, line)
    for n, curve in enumerate(drawn_as):
        points = curve.survey.position
        # curves may be drawn beside each other, but their directions matter
        points = points - points[0] + part.pair.first.position[0]
        bent.plot(*points.T, color=INK, lw=0.8, ls="--", label="as drawn" if n == 0 else None)
    if part.pair.bistable:
        # arc length of the pushed point, mm, and its displacement (2,) between the states, mm
        at, displacement = part.pushed
        start, size = lines[0].at(np.array([at]))[0][0], 0.3 * float(norm(displacement))
    else:
        start, size = travel.position[travel.force.argmax(), -1], part.pad.length
    tip = start + size * unit_vectors(np.radians(part.force_direction))
    draw_arrow(bent, tip, start, INK, 1.5)
    write_beside(bent, "force", tip if part.pair.bistable else start, (6, 0), "black", fontsize=8)
    corner = (0.99, bent.get_position().y1)
    figure.legend(frameon=False, fontsize=8, loc="lower right", bbox_to_anchor=corner, ncols=3)
    _equal_scales(bent, f"both states at rest, strained by {100 * max(part.strain):.2f} % at most")
    push.plot(travel.travel, travel.force, color=FIRST, lw=1.2)
    push.axhline(0, color=INK, lw=0.5)
    if travel.snap is not None:
        push.axvline(travel.snap, color=SECOND, lw=0.8, ls=":")
    unit = "mm" if travel.unit == "mm" else "degrees"
    label = f"{unit} of the {'pushed point' if part.pair.bistable else 'moved end'}"
    if travel.direction is None or travel.moment is None:
        label += f"; force at {part.force_direction:.0f}° to the x axis"
    else:
        label += f"; moment on this end from {travel.moment.min():.2g} to {travel.moment.max():.2g} N mm"
        turns = np.unwrap(travel.direction, period=360)
        # at the largest force, the curve agrees with the direction in the label
        turns += 360 * np.round((part.force_direction - turns[travel.force.argmax()]) / 360)
        directions = push.twinx()
        directions.plot(travel.travel, turns, color=SECOND, lw=0.8, ls="--")
        directions.set_ylabel("degrees to the x axis (dashed)", fontsize=7, color=SECOND)
        directions.tick_params(labelsize=7)
    push.set_xlabel(label, fontsize=8)
    push.set_ylabel("N", fontsize=8)
    push.tick_params(labelsize=7)
    upto = "force up to the snap" if travel.snap is not None and travel.forces_at_snap is None else "force"
    push.set_title(f"{upto}, at most {part.force_text}", fontsize=9, loc="left")
    return figure


def _equal_scales(axes: Axes, title: str) -> None:
    hide_axes(axes)
    axes.set_title(title, fontsize=9, loc="left")
