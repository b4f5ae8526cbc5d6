"""Display of records in notebooks without other libraries: lines as SVG, tables as HTML."""

from collections.abc import Iterable, Mapping, Sequence

import numpy as np

from elastica_cad._text import html_text
from elastica_cad._types import FloatArray
from elastica_cad.report_rows import Row

# colours that are legible on light and dark backgrounds
BLUE, RED, GREY, INK = "#2f6db3", "#c2452d", "#8a8f98", "#3c4658"

# width of a notebook's column, and largest height of a picture that fits a screen
WIDTH_PX, TALLEST_PX = 640.0, 420.0
EDGE_PX = 8.0
LINE_PX = 1.6
FIGURES = 5  # significant digits of coordinates in pixels


def svg_of_lines(lines: Iterable[tuple[FloatArray, str, bool]], title: str) -> str:
    """Return an SVG of polylines, scaled to fit.

    Each polyline is a triple: points (n, 2) with y upward, a colour, and True if it is closed.

    Examples
    --------
    >>> import numpy as np
    >>> svg_of_lines([(np.array([[0, 0], [10, 5]]), BLUE, False)], "two points")[:4]
    '<svg'
    """
    polylines = [(np.asarray(points, dtype=float), color, closed) for points, color, closed in lines]
    everything = np.concatenate([points for points, _, _ in polylines])
    low, high = everything.min(axis=0), everything.max(axis=0)
    span = np.maximum(high - low, 1e-9 * max(1.0, float(np.abs(everything).max())))
    scale = min((WIDTH_PX - 2 * EDGE_PX) / span[0], (TALLEST_PX - 2 * EDGE_PX) / span[1])
    size = span * scale + 2 * EDGE_PX
    paths = []
    for points, color, closed in polylines:
        pixels = (points - (low[0], high[1])) * (scale, -scale) + EDGE_PX
        run = " ".join(f"{x:.{FIGURES}g},{y:.{FIGURES}g}" for x, y in pixels)
        paths.append(
            f'<path d="M{run}{" Z" if closed else ""}" fill="none" stroke="{color}" stroke-width="{LINE_PX}"/>'
        )
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{size[0]:.0f}" height="{size[1]:.0f}" role="img" '
        f'viewBox="0 0 {size[0]:.2f} {size[1]:.2f}"><title>{html_text(title)}</title>{"".join(paths)}</svg>'
    )


def html_table(title: str, rows: Sequence[Mapping[str, object]]) -> str:
    """Return rows with equal keys as an HTML table with a caption. All texts are escaped."""
    if not rows:
        return f"<p>{html_text(title)}</p>"
    head = "".join(f"<th>{html_text(key)}</th>" for key in rows[0])
    body = "".join(
        "<tr>" + "".join(f"<td>{html_text(value)}</td>" for value in row.values()) + "</tr>" for row in rows
    )
    return f"<table><caption>{html_text(title)}</caption><tr>{head}</tr>{body}</table>"


def rows_table(title: str, rows: Sequence[Row]) -> str:
    """Return the rows of a report as an HTML table with a caption.

    Errors and warnings are marked, and details are tooltips.
    """
    body = "".join(
        f"<tr><th>{'! ' if row.stops else ''}{html_text(row.label)}</th>"
        f'<td style="text-align: left" title="{html_text(" ".join(row.details))}">{html_text(row.text)}</td></tr>'
        for row in rows
    )
    return f"<table><caption>{html_text(title)}</caption>{body}</table>"
