"""Figures without a display, and PNG files of them."""

from io import BytesIO
from os import PathLike
from typing import Any, TypeAlias

import numpy as np

from elastica_cad.errors import InputError, MissingDependencyError, how_to_install
from elastica_cad.formats.file_access.atomic_write import write_atomically

Figure: TypeAlias = Any

WIDTH_INCHES = 9.0
"""Of all figures: a page in landscape."""

NOTEBOOK_DPI = 90.0
"""A page as wide as a notebook's column."""

COMPRESSION = 3
"""Of PNG files: beyond, they take half as long again to write and are a twentieth smaller."""

INK = "#1f2430"


def save_figure(
    figure: Figure, path: str | PathLike[str], *, force: bool = False, resolution: float = 150.0
) -> None:
    """Write a figure as PNG, whole or not at all; `resolution` in dots per inch.

    Raises
    ------
    InputError
        The file exists (without `force`) or cannot be written.
    """
    if not (np.isfinite(resolution) and resolution > 0):
        raise InputError(f"resolution is {resolution}: it must be positive, in dots per inch")
    write_atomically(path, _png(figure, resolution), force=force)


def _png(figure: Figure, resolution: float) -> bytes:
    """What `savefig` shows: it would go through the whole figure once more, to lay it out before it is drawn."""
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from PIL import Image

    stream, canvas, before = BytesIO(), figure.canvas, figure.dpi
    figure.dpi = resolution
    try:
        drawn = FigureCanvasAgg(figure)
        drawn.draw()
        page = Image.fromarray(np.asarray(drawn.buffer_rgba()))
        if page.getextrema()[-1] == (255, 255):  # opaque all over
            page = page.convert("RGB")
        page.save(stream, format="png", dpi=(resolution, resolution), compress_level=COMPRESSION)
    finally:
        figure.dpi = before
        figure.set_canvas(canvas)
    return stream.getvalue()


def new_figure(height: float) -> Figure:
    """An empty figure `WIDTH_INCHES` wide and `height` tall, inches."""
    try:
        from matplotlib.figure import Figure as MatplotlibFigure
    except ImportError as error:
        raise MissingDependencyError(f"pictures need matplotlib: {how_to_install('matplotlib')}") from error

    class Page(MatplotlibFigure):
        """A figure that a notebook shows where it is the last thing of a cell, once."""

        def _repr_png_(self) -> bytes:
            stream = BytesIO()
            self.savefig(stream, format="png", dpi=NOTEBOOK_DPI)
            return stream.getvalue()

    return Page(figsize=(WIDTH_INCHES, height), layout="constrained")
