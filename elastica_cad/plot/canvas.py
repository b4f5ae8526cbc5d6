"""Creation of figures without a display, and writing of figures to files."""

from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import contextmanager
from io import BytesIO
from os import PathLike
from pathlib import Path
from typing import Any, NamedTuple, TypeAlias

import numpy as np

from elastica_cad._text import MADE_BY
from elastica_cad._types import FloatArray
from elastica_cad._values import is_number, require_path, with_article
from elastica_cad.errors import InputError, missing_library
from elastica_cad.formats.write_files import write_atomically
from elastica_cad.geometry.plane_points import box_about

Figure: TypeAlias = Any
Axes: TypeAlias = Any

WIDTH_INCHES = 9.0
"""Width of all figures, inches. It fits a page in landscape."""

RESOLUTION = 150.0
"""Default resolution of PNG files, dots per inch."""

MOST_RESOLUTION = 2400.0
"""Largest resolution, dots per inch. A higher resolution would need too much memory."""

PICTURES = ("png", "svg", "pdf")

INK = "#1f2430"

TITLE_POINTS = 11

TITLE_INCHES, TITLE_LINE_INCHES = 0.1, 0.19
"""Space above and below the title of a page, and height of its lines, inches."""


class Panel(NamedTuple):
    """Height of a drawing on a page and the space around it, inches.

    `above` contains a title and a legend. `below`, `left` and `right` contain the numbers and names of axes.
    """

    height: float
    above: float = 0.08
    below: float = 0.08
    left: float = 0.08
    right: float = 0.08


def save_figure(
    figure: Figure, path: str | PathLike[str], *, force: bool = False, resolution: float = RESOLUTION
) -> None:
    """Write a figure as PNG, SVG or PDF, selected by the suffix of the file name.

    After an error, no incomplete file remains.

    Parameters
    ----------
    figure : matplotlib.figure.Figure
        Figure from a function of `elastica_cad.plot`.
    path : path-like
    force : bool
        Overwrite an existing file.
    resolution : float
        Dots per inch of a PNG.

    Raises
    ------
    InputError
        The file exists (without `force`), has another suffix or cannot be written, or the resolution is impossible.
    """
    if not (is_number(resolution) and 1 <= resolution <= MOST_RESOLUTION):
        raise InputError(f"resolution is {resolution!r}. Use 1 to {MOST_RESOLUTION:g} dots per inch.")
    if not hasattr(figure, "savefig"):
        raise InputError(f"The figure is {with_article(type(figure))}. Pass a figure of elastica_cad.plot.")
    kind = require_path(path).suffix.lower().removeprefix(".")
    if kind not in PICTURES:
        raise InputError(f"{path} does not have the suffix of a picture. Use .png, .svg or .pdf.")
    stream = BytesIO()
    undated = {"png": {}, "svg": {"Date": None}, "pdf": _properties()}[kind]
    figure.savefig(stream, format=kind, dpi=resolution, metadata=undated)
    write_atomically(path, stream.getvalue(), force=force)


def draw_file(draw: Callable[[], Figure], path: Path) -> None:
    """Draw a figure and write it to a file of a kit."""
    save_figure(draw(), path)


def write_pages(
    figures: Iterable[Figure],
    path: str | PathLike[str],
    title: str,
    *,
    what: str,
    force: bool = False,
    resolution: float = RESOLUTION,
) -> None:
    """Write figures as the pages of a PDF without time stamps. After an error, no incomplete file remains.

    Parameters
    ----------
    figures : iterable of Figure
        Figures are requested one at a time, so that only one page is in memory.
    title : str
        Title in the properties of the file.
    what : str
        Kind of files that need matplotlib, for the message if it is missing.
    resolution : float
        Resolution of pixel images in the file, dots per inch.

    Raises
    ------
    InputError
        The file exists (without `force`) or cannot be written.
    MissingDependencyError
        matplotlib is not installed.
    """
    try:
        from matplotlib.backends.backend_pdf import PdfPages
    except ImportError as error:
        raise missing_library(f"{what} need matplotlib", "matplotlib") from error
    stream = BytesIO()
    with PdfPages(stream, metadata=_properties() | {"Title": title}) as pages:
        for figure in figures:
            pages.savefig(figure, dpi=resolution)
    write_atomically(path, stream.getvalue(), force=force)


def _properties() -> dict[str, str | None]:
    """Return the metadata of a file, without a time, so that equal pictures give equal files."""
    return {"CreationDate": None} | ({"Subject": command} if (command := MADE_BY.get()) else {})


CHINESE_FONTS = (
    "Noto Sans CJK SC", "Noto Sans SC", "Source Han Sans SC", "Microsoft YaHei", "PingFang SC", "Hiragino Sans GB",
    "Heiti SC", "WenQuanYi Micro Hei", "WenQuanYi Zen Hei", "Droid Sans Fallback", "SimHei", "SimSun",
    "Arial Unicode MS", "Noto Sans CJK JP",
)  # fmt: skip
"""Fonts with Chinese characters, the preferred ones first."""


def chinese_font() -> str | None:
    """Return the name of an installed font with Chinese characters, or None."""
    try:
        from matplotlib import font_manager
    except ImportError as error:
        raise missing_library("pictures need matplotlib", "matplotlib") from error
    known = font_manager.fontManager
    # the stored list of fonts may be outdated, so a new list is made if it has no Chinese font
    listed: Callable[[], Any]
    for listed in (lambda: known, font_manager.FontManager):
        files = {font.name: font.fname for font in listed().ttflist}
        for name in CHINESE_FONTS:
            if name in files:
                known.addfont(files[name])
                return name
    return None


@contextmanager
def text_in(font: str | None) -> Iterator[None]:
    """Write text of new figures in a font. Characters that the font lacks are in matplotlib's default font."""
    if font is None:
        yield
        return
    from matplotlib import rc_context

    with rc_context({"font.family": [font, "DejaVu Sans"]}):
        yield


def show_box(axes: Axes, low: Sequence[float] | FloatArray, high: Sequence[float] | FloatArray) -> None:
    """Set the limits of axes to a box from its lower left to its upper right corner."""
    axes.set_xlim(low[0], high[0])
    axes.set_ylim(low[1], high[1])


def hide_axes(axes: Axes) -> None:
    """Show a drawing with equal scales, and without numbers."""
    axes.set_aspect("equal")
    axes.set_axis_off()


def draw_arrow(
    axes: Axes, head: FloatArray, tail: FloatArray, color: str, width: float, style: str = "-|>"
) -> None:
    """Draw an arrow of a line width, points, from its tail to its head."""
    arrow = {"arrowstyle": style, "color": color, "linewidth": width, "shrinkA": 0, "shrinkB": 0}
    axes.annotate("", tuple(head), tuple(tail), arrowprops=arrow)


def write_beside(
    axes: Axes, text: str, at: FloatArray, offset: tuple[float, float], color: str = INK, **style: Any
) -> None:
    """Write text at an offset, points, from a place on the drawing."""
    style = {"fontsize": 9, "color": color} | style
    axes.annotate(text, tuple(at), offset, textcoords="offset points", **style)


def paint_polygons(axes: Axes, polygons: FloatArray | Sequence[FloatArray], **style: Any) -> None:
    """Paint polygons, an array (n, k, 2) or a sequence of arrays (k, 2), later polygons on top.

    Matplotlib would slowly compute the box of every polygon, so the box of all polygons is set here.
    """
    from matplotlib.collections import PolyCollection

    painted: Any = polygons  # for matplotlib, an array (n, k, 2) is a sequence of polygons
    axes.add_collection(PolyCollection(painted, **style), autolim=False)
    corners = polygons.reshape(-1, 2) if isinstance(polygons, np.ndarray) else np.concatenate(polygons)
    axes.update_datalim(box_about(corners))


def paint_patches(axes: Axes, patches: FloatArray, colors: FloatArray, **style: Any) -> None:
    """Paint polygons (n, k, 2) with colours (n, 3), later polygons on top, without visible seams."""
    # outlines hide the seams between patches
    paint_polygons(axes, patches, facecolors=colors, edgecolors="face", linewidths=0.3, **style)


def empty_figure(size: tuple[float, float]) -> Figure:
    """Return a figure of the given width and height, inches, which draws names as they are.

    Matplotlib would draw the text between two signs $ as a formula. Letters that its font lacks are underscores, as
    on the sheets.
    """
    try:
        from matplotlib.figure import Figure as MatplotlibFigure
        from matplotlib.font_manager import findfont, get_font
        from matplotlib.text import Text
    except ImportError as error:
        raise missing_library("pictures need matplotlib", "matplotlib") from error

    class Page(MatplotlibFigure):
        """Figure that a notebook displays only once, even as the last value of a cell."""

        def draw(self, renderer: Any) -> None:
            for text in self.findobj(Text):
                text.set_parse_math(False)
                glyph = get_font(findfont(text.get_fontproperties())).get_char_index  # 0 if it is missing
                text.set_text("".join(c if c == "\n" or glyph(ord(c)) else "_" for c in text.get_text()))
            super().draw(renderer)

        def _repr_png_(self) -> bytes:
            stream = BytesIO()
            # at this resolution, a figure is as wide as a notebook's column
            self.savefig(stream, format="png", dpi=90.0)
            return stream.getvalue()

    return Page(figsize=size)


def new_page(panels: Sequence[Panel], title: str = "") -> tuple[Figure, list[Axes]]:
    """Make a figure, `WIDTH_INCHES` wide, with axes for the panels one above another.

    The space for text is estimated, because matplotlib's layouts slowly measure every text.
    """
    headed = 2 * TITLE_INCHES + TITLE_LINE_INCHES * (title.count("\n") + 1) if title else 0.0
    height = headed + sum(panel.above + panel.height + panel.below for panel in panels)
    figure = empty_figure((WIDTH_INCHES, height))
    if title:
        figure.suptitle(title, y=1 - TITLE_INCHES / height, va="top", fontsize=TITLE_POINTS, color=INK)
    stacked, low = [], height - headed
    for panel in panels:
        low -= panel.above + panel.height
        wide = WIDTH_INCHES - panel.left - panel.right
        place = (panel.left / WIDTH_INCHES, low / height, wide / WIDTH_INCHES, panel.height / height)
        stacked.append(figure.add_axes(place))
        low -= panel.below
    return figure, stacked
