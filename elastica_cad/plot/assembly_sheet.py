"""Assembly sheet as PDF: an exploded view with numbered ends, and the steps of the assembly."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from itertools import groupby
from os import PathLike
from typing import Any

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import counted
from elastica_cad.model.assembly import (
    AssemblyStep,
    Holder,
    SingleHolder,
    list_assembly_steps,
    single_holders,
)
from elastica_cad.model.cut_rows import CutList
from elastica_cad.model.fixtures import EndFixture, PlacedTab, place_tabs
from elastica_cad.model.frames import Rib
from elastica_cad.model.model import Model
from elastica_cad.plot.canvas import INK, paint_patches, paint_polygons, write_pages
from elastica_cad.plot.model_pictures import look_from, rule_strip, screen_of
from elastica_cad.strip.holding_template import ARROW_MM, HeldElement, held_elements

PAGE_INCHES = (11.69, 8.27)  # A4 in landscape
ELEVATION_DEG, AZIMUTH_DEG = 24.0, -60.0  # direction of the viewer
# distance by which plates and blocks are moved away from the strips, as a fraction of the extent of the model
APART = 0.3
SPREAD = 0.25  # outward shift of each strip, as a fraction of its distance from the middle
ROWS = 34  # number of rows of a table on a page
EDGE_MM = 0.5  # largest distance, mm, between outlines and the polylines that are drawn
PLATE, HOLE, LEAD = "#d9c9a3", "#ffffff", "#c2452d"
# resolution of the pixel image of the strips; thousands of vector patches take minutes to open
PAINT_DPI = 300
MOST_NUMBERS = 120  # largest number of labels; more would cover the picture


def save_assembly_sheet(
    model: Model,
    path: str | PathLike[str],
    *,
    holders: Sequence[Holder] = (),
    cut_list: CutList | None = None,
    force: bool = False,
) -> tuple[AssemblyStep, ...]:
    """Write a PDF for the workshop: exploded view, numbered ends, order of assembly, positions, and cut list.

    Parameters
    ----------
    model : Model
        Model with its strips in the order of assembly.
    path : path-like
    holders : sequence of BasePlate, Ring, Rib, SlottedFrame or EndFixture
        Holders in addition to the plates of the model.
    cut_list : CutList, optional
        Cut list that is printed on the last pages.
    force : bool
        Overwrite a file of that name.

    Returns
    -------
    tuple of AssemblyStep
        The printed steps in order.

    Raises
    ------
    InputError
        The file exists.
    MissingDependencyError
        matplotlib is not installed.
    """
    steps = list_assembly_steps(model, holders)
    pages = _pages(model, holders, steps, cut_list)
    title = f"{model.name}: assembly"
    write_pages(pages, path, title, what="assembly sheets", force=force, resolution=PAINT_DPI)
    return steps


def _pages(
    model: Model, holders: Sequence[Holder], steps: Sequence[AssemblyStep], cut_list: CutList | None
) -> Iterator[Any]:
    yield _exploded(model, holders)
    head = ("step", "strip", "cut as", "end 1 goes to", "end 2 goes to", "locks into")
    yield from _tables(f"{model.name}: order of assembly", head, list(_rows(steps)))
    held = list(_held_rows(model))
    if held:
        head = ("strip", "element", "place (x, y, z), mm", "angle, degrees", "force, N", "length, mm")
        yield from _tables(f"{model.name}: rails, pins, ties and loads", head, held)
    if cut_list is not None:
        cut = [
            (row.part, str(row.count), row.sheet, f"{row.length:.1f} x {row.width:.1f}", row.file)
            for row in cut_list.rows
        ]
        cut += [
            (
                row.part,
                str(row.count),
                row.sheet,
                f"{row.length:.1f} x {row.width:.1f} x {row.thickness:.1f}",
                row.file,
            )
            for row in cut_list.printed
        ]
        yield from _tables(f"{model.name}: parts", ("part", "count", "sheet", "size, mm", "file"), cut)


def _rows(steps: Sequence[AssemblyStep]) -> Iterator[tuple[str, ...]]:
    """Return a row of the table for each step.

    Consecutive steps with equal text, as for equal strips, are combined in a row.
    """
    for (part, ends, locks), run in groupby(steps, lambda step: (step.part, step.ends, step.locks_into)):
        first, *others = run
        number, strip = str(first.number), first.strip
        if others:
            number = f"{first.number} to {others[-1].number}"
            strip = f"strips {number}"
        yield number, strip, part, *ends, ", ".join(locks)


def _held_rows(model: Model) -> Iterator[tuple[str, ...]]:
    """Yield a row of the table for each rail, pin, tie and load.

    Angles are between the strip, or the force of a load, and the line between the ends.
    """
    for i, member in enumerate(model.placed):
        for held in held_elements(member.strip):
            points = member.frame.point(held.position)
            at = " to ".join(f"({x:z.1f}, {y:z.1f}, {z:z.1f})" for x, y, z in points)
            apart = float(np.linalg.norm(points[-1] - points[0]))
            tied = len(points) > 1
            noun = f"{held.name} {held.noun}"
            angle, length = ("", f"{apart:.1f}") if tied else (f"{held.tilt:.1f}", "")
            yield model.single_name_of(i), noun, at, angle, f"{held.force:.2g}", length


def _mark(held: HeldElement) -> str:
    """Return the name of an element or load, with the force of a load."""
    return f"{held.name}, {held.force:.2g} N" if held.is_load else held.name


def _page(title: str) -> Any:
    from matplotlib.figure import Figure

    figure = Figure(figsize=PAGE_INCHES)
    figure.suptitle(title, x=0.05, y=0.96, ha="left", fontsize=13, color=INK)
    return figure


def _tables(title: str, head: Sequence[str], rows: Sequence[Sequence[str]]) -> Iterator[Any]:
    """Draw the rows on pages, with columns as wide as their longest words."""
    longest = [max(len(row[k]) for row in [head, *rows]) + 2 for k in range(len(head))]
    left = 0.05 + 0.9 * np.concatenate([[0.0], np.cumsum(longest)[:-1]]) / sum(longest)
    size = min(9.0, 9.0 * 150 / sum(longest))
    for first in range(0, len(rows), ROWS):
        figure = _page(title)
        for line, row in enumerate([head, *rows[first : first + ROWS]]):
            for x, text in zip(left, row, strict=True):
                weight = "bold" if line == 0 else "normal"
                y = 0.9 - 0.85 * line / (ROWS + 1)
                figure.text(x, y, text, fontsize=size, color=INK, fontweight=weight)
        yield figure


def _exploded(model: Model, holders: Sequence[Holder]) -> Any:
    """Draw the exploded view: strips and holders are moved apart, and a line leads from every tab to its
    position in a holder.
    """
    bent = np.concatenate([member.frame.point(member.strip.rod.position) for member in model.placed])
    middle, extent = bent.mean(axis=0), float(np.ptp(bent, axis=0).max())
    toward = look_from(ELEVATION_DEG, AZIMUTH_DEG)
    screen = screen_of(ELEVATION_DEG, AZIMUTH_DEG)
    figure = _page(f"{model.name}: {counted(len(model.placed), 'strip')}, taken apart")
    axes = figure.add_axes((0.03, 0.03, 0.94, 0.87))
    shown: list[tuple[FloatArray, FloatArray]] = []
    spread = []
    for member in model.placed:
        center = member.frame.point(member.strip.rod.position).mean(axis=0)
        out = SPREAD * (center - middle)
        spread.append(replace(member, origin=member.origin + out))
        shown.append(rule_strip(spread[-1]))
    far = APART * extent
    patches, colors = (np.concatenate(part) for part in zip(*shown, strict=True))
    outlines = list(_outlines([*model.plates, *holders], far))
    depths = [*(patches.mean(axis=1) @ toward), *(float(place @ toward) for _, place, _ in outlines)]
    # paint from far to near; consecutive patches with equal numbers of corners are drawn together, because this
    # is much faster than single polygons
    order = np.argsort(depths, kind="stable")
    whole = order >= len(patches)
    for run in np.split(order, np.flatnonzero(np.diff(whole)) + 1):
        if run[0] < len(patches):
            paint_patches(axes, patches[run] @ screen, colors[run], rasterized=True)
            continue
        some = [outlines[k - len(patches)] for k in run]
        polygons = [outline @ screen for outline, _, _ in some]
        fills = [color for _, _, color in some]
        paint_polygons(axes, polygons, facecolors=fills, edgecolors=INK, linewidths=0.4, rasterized=True)
    numbered = len(model.placed) * 2 <= MOST_NUMBERS
    targets = dict(_targets([*model.plates, *holders], far))
    for tab, own in zip(place_tabs(spread), place_tabs(model.placed), strict=True):
        start, target = tab.tip @ screen, targets.get(own.key, targets.get(own.name))
        if target is not None:
            axes.plot(*np.array([start, target @ screen]).T, color=LEAD, linewidth=0.5, linestyle=":")
        if numbered:
            text = tab.name.removeprefix("strip ")
            axes.text(*start, text, fontsize=6, color=INK, ha="center", va="center",
                      bbox={"boxstyle": "round,pad=0.15", "fc": "white", "ec": LEAD, "lw": 0.4})  # fmt: skip
    for member in spread:
        for held in held_elements(member.strip):
            points = member.frame.point(held.position) @ screen
            axes.plot(*points.T, color=LEAD, marker="o", markersize=3, linewidth=0.8)
            name_at = points[0]
            if held.is_load:
                name_at = member.frame.point(held.position + ARROW_MM * held.outward)[0] @ screen
                arrow = {"arrowstyle": "->", "color": LEAD, "linewidth": 0.8, "shrinkA": 0, "shrinkB": 0}
                axes.annotate("", name_at, points[0], arrowprops=arrow)
            beside = {"xytext": (4, 4), "textcoords": "offset points", "fontsize": 6, "color": LEAD}
            axes.annotate(_mark(held), name_at, **beside)
    axes.autoscale_view()
    axes.set_aspect("equal")
    axes.set_axis_off()
    return figure


def _outlines(holders: Sequence[Holder], far: float) -> Iterator[tuple[FloatArray, FloatArray, str]]:
    """Yield loops (n, 3) of plates and blocks, shifted by `far` mm, each with a point for depth sorting and a
    colour.
    """
    for holder in single_holders(holders):
        shift = _shift(holder, far)
        if isinstance(holder, EndFixture):
            yield _block(holder.tab) + shift, holder.tab.tip + shift, PLATE
            continue
        solid = holder.solid
        for k, path in enumerate((solid.outline, *solid.holes)):
            points = path.points(EDGE_MM)
            loop = solid.frame.point(np.column_stack([points, np.full(len(points), solid.thickness)])) + shift
            if k == 0:
                depth = loop.mean(axis=0)
            above = 1e-6 * k * look_from(ELEVATION_DEG, AZIMUTH_DEG)
            yield loop, depth + above, HOLE if k else PLATE


def _shift(holder: SingleHolder, far: float) -> FloatArray:
    """Return the vector by which a holder is moved away from the strips.

    Ribs are moved farther than their rails.
    """
    if isinstance(holder, EndFixture):
        return 0.5 * far * holder.tab.frame.x_axis
    if isinstance(holder, Rib):
        return np.array([0.0, 0.0, -1.6 * far])
    return -far * holder.frame.z_axis


def _block(tab: PlacedTab) -> FloatArray:
    """Return the side of a block along the tab, as a rectangle."""
    half, long = tab.width / 2 + 4.0, tab.length + 4.0
    corners = [(0.0, -half, 0.0), (long, -half, 0.0), (long, half, 0.0), (0.0, half, 0.0)]
    return np.asarray(tab.frame.point(corners), dtype=float)


def _targets(holders: Sequence[Holder], far: float) -> Iterator[tuple[object, FloatArray]]:
    """Yield the drawn position of each tab in a holder.

    Tabs are identified by `PlacedTab.key`, because equal strips have equal names, or else by their name.
    """
    for holder in single_holders(holders):
        shift = _shift(holder, far)
        if isinstance(holder, EndFixture):
            yield holder.tab.key, holder.tab.frame.origin + shift
        elif not isinstance(holder, Rib):
            for slot in holder.slots:
                x, y = slot.corners.mean(axis=0)
                yield slot.name if slot.tab is None else slot.tab.key, holder.frame.point((x, y, 0.0)) + shift
