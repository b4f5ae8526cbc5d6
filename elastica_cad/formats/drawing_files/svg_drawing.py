"""Drawings as SVG files in mm."""

from collections.abc import Mapping
from html import escape  # xml.sax.saxutils would load the network first
from itertools import islice

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.fabrication.drawings.drawing import LAYERS, Drawing
from elastica_cad.formats.drawing_files.curve_style import check_curve_style, shape_path
from elastica_cad.formats.drawing_files.layers import LayerChoice, style_layers
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.segments import Arc, Line, Segment

_MARGIN_MM = 1.0
"""About the drawing, so that a stroke on its border is seen."""

_STROKE_MM = 0.1
"""Hairline: laser programs take thin strokes for cuts."""


def encode_svg(
    drawing: Drawing,
    *,
    curves: str = "spline",
    tolerance: float = 0.02,
    layers: Mapping[str, LayerChoice] | None = None,
) -> bytes:
    """A drawing as the content of an SVG file whose user unit is the mm; same drawing, same bytes.

    One group a layer, in working order, one <path> a loop, y upward on the sheet. Arcs and polynomial splines
    up to degree 3 are exact.

    Parameters
    ----------
    drawing : Drawing
    curves : str
        "spline" writes Bezier curves (weighted splines and degrees above 3 to the tolerance but at most
        0.001 mm), "arc" arcs, "polyline" lines.
    tolerance : float
        Largest distance, mm, of a replaced curve from the true one.
    layers : mapping, optional
        Names and colours, see `style_layers`.

    Raises
    ------
    InputError
        The drawing is empty, or an option is unknown.

    Examples
    --------
    >>> from elastica_cad.fabrication.drawings.drawing import CUT_OUTER, LayeredPath
    >>> plate = Drawing("plate", [LayeredPath(CUT_OUTER, Path.rectangle(40, 10))])
    >>> 'width="42mm" height="12mm"' in encode_svg(plate).decode()
    True
    """
    curves = check_curve_style(curves)
    styles = style_layers(layers)
    (left, low), (right, high) = drawing.bounds
    sheet = _Sheet(left - _MARGIN_MM, high + _MARGIN_MM)
    width, height = _number(right - left + 2 * _MARGIN_MM), _number(high - low + 2 * _MARGIN_MM)
    rows = [
        '<?xml version="1.0" encoding="UTF-8"?>',
        '<svg xmlns="http://www.w3.org/2000/svg" version="1.1" '
        'xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" '
        f'width="{width}mm" height="{height}mm" viewBox="0 0 {width} {height}">',
        f"<title>{escape(drawing.name, quote=False)}</title>",
    ]
    for layer in LAYERS:
        paths = [item.path for item in drawing.strokes if item.layer == layer]
        if not paths:
            continue
        style = styles[layer]
        key, label = escape(style.name.replace(" ", "_")), escape(style.name)
        rows.append(
            f'<g id="{key}" inkscape:groupmode="layer" inkscape:label="{label}" '
            f'fill="none" stroke="{style.color}" stroke-width="{_STROKE_MM:g}">'
        )
        rows.extend(
            f'<path d="{sheet.data(shape_path(path, curves, tolerance, rational=False))}"/>' for path in paths
        )
        rows.append("</g>")
    rows.append("</svg>\n")
    return "\n".join(rows).encode()


class _Sheet:
    """Path data with the origin at the upper left corner and y downward."""

    def __init__(self, left: float, top: float) -> None:
        self.origin = np.array([left, top])

    def data(self, path: Path) -> str:
        """The d attribute of one path."""
        runs = [("M", path.start), *[run for segment in path.segments for run in _runs(segment)]]
        if path.closed and isinstance(path.segments[-1], Line):
            runs.pop()  # the closing line is drawn by Z
        places = np.concatenate([points.reshape(-1, 2) for _, points in runs])
        placed = ((places - self.origin) * (1, -1)).tolist()
        written = iter([f"{_number(x)},{_number(y)}" for x, y in placed])
        parts = [command + " ".join(islice(written, points.size // 2)) for command, points in runs]
        return "".join(parts) + ("Z" if path.closed else "")


def _runs(segment: Segment) -> list[tuple[str, FloatArray]]:
    """Commands that go on along a segment, each with its points (..., 2)."""
    if isinstance(segment, Line):
        return [("L", segment.end)]
    if isinstance(segment, Arc):
        # more than half a turn in two parts: a whole turn has no ends, and nearly one is badly conditioned
        halves = abs(segment.sweep) > np.pi * (1 + 1e-9)
        ends = segment.at(np.array([0.5, 1.0])) if halves else segment.end[None]
        radius, flag = _number(segment.radius), "0" if segment.sweep > 0 else "1"
        return [(f"A{radius} {radius} 0 0 {flag} ", end) for end in ends]
    curve = segment.curve
    letter = {2: "Q", 3: "C"}[curve.degree]
    if curve.knots.size == 2 * curve.degree + 2:  # clamped and of one piece, as sides of holes are
        return [(letter, curve.control_points[1:])]
    return [(letter, points[1:, :2] / points[1:, 2:]) for _, _, points in curve.bezier_pieces()]


def _number(value: float) -> str:
    """A length to 1e-6 mm, as short as it goes."""
    text = f"{value:.6f}".rstrip("0").rstrip(".")
    return "0" if text == "-0" else text
