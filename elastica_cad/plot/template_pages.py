"""Paper templates: full-size drawings as PDF, on pages with marks for joining them."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from os import PathLike
from typing import Any

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._units import MM_PER_INCH
from elastica_cad._values import require_record
from elastica_cad.errors import InputError
from elastica_cad.geometry.plane_points import box_about, boxes_meet
from elastica_cad.plot.canvas import INK, empty_figure, show_box, write_pages
from elastica_cad.plot.strip_pictures import LAYER_COLORS
from elastica_cad.strip.drawing import Drawing

PAPERS = {
    "A4": (210.0, 297.0), "A3": (297.0, 420.0), "A2": (420.0, 594.0), "A1": (594.0, 841.0), "A0": (841.0, 1189.0),
    "letter": (215.9, 279.4), "tabloid": (279.4, 431.8),
}  # fmt: skip
"""Width and height of papers, mm (ISO 216; ANSI Y14.1)."""

MARGIN_MM = 10.0  # margin, mm, that home printers cannot print
OVERLAP_MM = 10.0  # overlap of neighbouring tiles, mm, for glue
# largest distance, mm, between splines and drawn lines: a quarter of a dot at 600 dpi
CHORD_MM = 0.01
CROSS_MM = 4.0  # length of the arms of a registration mark, mm
RULER_MM = 100.0  # length, mm, of the bar that shows whether the printer scaled the page
MOST_TILES = 400  # largest number of pages, because more pages are probably a mistake


def printed_size(paper: str) -> tuple[float, float]:
    """Return width and height, mm, of the printable area of one of `PAPERS`, upright."""
    wide, high = PAPERS[paper]
    return wide - 2 * MARGIN_MM, high - 2 * MARGIN_MM


@dataclass(frozen=True, eq=False)
class Tiling:
    """Arrangement of a drawing on pages.

    Attributes
    ----------
    page : (float, float)
        Width and height of the paper in the used orientation, mm.
    origins : (k, 2) array
        Lower left corner of each printed tile in the drawing, mm.
    names : tuple of str
        Names of the tiles. "A1" is the lower left tile. Letters count to the right, numbers upwards.
    size : (float, float)
        Size of the printed part of a page, mm.
    """

    page: tuple[float, float]
    origins: FloatArray
    names: tuple[str, ...]
    size: tuple[float, float]


def _tile_drawing(drawing: Drawing, paper: str) -> Tiling:
    """Return the tiles that cover a drawing.

    Pages are upright or across, whichever needs fewer. Empty tiles are left out.

    Raises
    ------
    InputError
        The paper is unknown, or there are more than 400 pages.

    Examples
    --------
    >>> from elastica_cad.strip.drawing import LayeredPath
    >>> from elastica_cad.geometry.path import Path
    >>> long = Drawing("long", [LayeredPath("CUT_OUTER", Path.rectangle(400, 20))])
    >>> _tile_drawing(long, "A4").names
    ('A1', 'B1')
    """
    require_record(drawing, Drawing, "what is printed", "a Drawing")
    if not isinstance(paper, str) or paper not in PAPERS:
        raise InputError(f"Unknown paper {paper!r}. Use one of {', '.join(PAPERS)}.")
    tilings = [_tiles(drawing, page) for page in (PAPERS[paper], PAPERS[paper][::-1])]
    return min(tilings, key=lambda tiling: len(tiling.names))


def _tiles(drawing: Drawing, page: tuple[float, float]) -> Tiling:
    """Return the pages on which the drawing has lines, named by column (A, B, ...) and row (1, 2, ...)."""
    low, high = drawing.bounds
    size = np.array(page) - 2 * MARGIN_MM
    step = size - OVERLAP_MM
    counts = np.maximum(1, np.ceil((high - low - OVERLAP_MM) / step - 1e-9)).astype(int)
    if counts.prod() > MOST_TILES:
        raise InputError(
            f"{drawing.name} needs {counts.prod()} pages of this paper, more than {MOST_TILES}. Use larger paper."
        )
    start = (low + high) / 2 - (size + (counts - 1) * step) / 2
    lines = [item.path.closed_points(1.0) for item in drawing.strokes]
    # boxes about the segments of all lines
    lows, highs = (
        np.concatenate([choose(line[:-1], line[1:]) for line in lines]) for choose in (np.minimum, np.maximum)
    )
    origins, names = [], []
    for row in range(counts[1]):
        for column in range(counts[0]):
            # the columns are A to Z, then AA, AB, and so on
            first = chr(ord("A") + column // 26 - 1) if column >= 26 else ""
            corner = start + (column, row) * step
            if ((lows < corner + size) & (highs > corner)).all(axis=1).any():
                origins.append(corner)
                names.append(f"{first}{chr(ord('A') + column % 26)}{row + 1}")
    return Tiling(page, np.array(origins), tuple(names), (float(size[0]), float(size[1])))


def save_template(
    drawing: Drawing,
    path: str | PathLike[str],
    *,
    paper: str = "A4",
    force: bool = False,
) -> Tiling:
    """Write a drawing at its true size as PDF, on as many pages as necessary.

    Each page has a name, and a bar to measure whether the printer scaled it. Pages are joined so that their
    crosses coincide. Lines follow splines to 0.01 mm.

    Parameters
    ----------
    drawing : Drawing
    path : path-like
    paper : str
        One of `PAPERS`.
    force : bool
        Overwrite an existing file.

    Returns
    -------
    Tiling
        Position of the pages on the drawing.

    Raises
    ------
    InputError
        The paper size is unknown, there would be more than 400 pages, or the file exists.
    MissingDependencyError
        matplotlib is not installed.
    """
    tiling = _tile_drawing(drawing, paper)
    write_pages(_pages(drawing, tiling), path, drawing.name, what="PDF templates", force=force)
    return tiling


def save_templates(
    drawings: Sequence[Drawing],
    path: str | PathLike[str],
    *,
    title: str,
    paper: str = "A4",
) -> None:
    """Write several drawings at full size to a single PDF, one after another; see `save_template`."""
    pages = (page for drawing in drawings for page in _pages(drawing, _tile_drawing(drawing, paper)))
    write_pages(pages, path, title, what="PDF templates")


def _pages(drawing: Drawing, tiling: Tiling) -> Iterator[Any]:
    from matplotlib.patches import Rectangle

    for name, low in zip(tiling.names, tiling.origins, strict=True):
        page = empty_figure(tuple(np.array(tiling.page) / MM_PER_INCH))
        tile = f"   page {name}" if len(tiling.names) > 1 else ""
        high = low + tiling.size
        axes = page.add_axes((0, 0, 1, 1))
        axes.set_axis_off()
        show_box(axes, low - MARGIN_MM, low - MARGIN_MM + tiling.page)
        window = Rectangle((low[0], low[1]), *tiling.size, transform=axes.transData)
        for item in drawing.strokes:
            points = item.path.closed_points(CHORD_MM)
            if not boxes_meet(box_about(points), np.array([low, high])):
                continue  # skip lines on other pages, which would take as long to draw
            style = {"color": LAYER_COLORS[item.layer], "linewidth": 0.6, "solid_capstyle": "butt"}
            (line,) = axes.plot(*points.T, **style)
            line.set_clip_path(window)
        # crosses for joining the pages
        for x in (low[0] + OVERLAP_MM / 2, high[0] - OVERLAP_MM / 2):
            for y in (low[1] + OVERLAP_MM / 2, high[1] - OVERLAP_MM / 2):
                axes.plot([x - CROSS_MM, x + CROSS_MM], [y, y], color=INK, linewidth=0.4)
                axes.plot([x, x], [y - CROSS_MM, y + CROSS_MM], color=INK, linewidth=0.4)
        height = 3.0 * 72 / MM_PER_INCH
        title = f"{drawing.name}{tile}   print at 100 %"
        axes.text(low[0], high[1] + 0.2 * MARGIN_MM, title, fontsize=height, color=INK)
        x, y = high[0] - RULER_MM, low[1] - 0.3 * MARGIN_MM
        ticks = y + np.array([-1.5, 1.5, 0, 0, 1.5, -1.5])
        axes.plot([x, x, x, high[0], high[0], high[0]], ticks, color=INK, linewidth=0.8)
        axes.text(x + RULER_MM / 2, y + 0.8, "100 mm", fontsize=0.8 * height, color=INK, ha="center")
        yield page
