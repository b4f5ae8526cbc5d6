"""Drawings as SVG files in mm."""

from collections.abc import Mapping

import numpy as np

from elastica_cad._printable import html_text
from elastica_cad._values import require_record
from elastica_cad.fabrication.drawings.drawing import LAYERS, Drawing
from elastica_cad.formats.drawing_files.curve_style import check_curve_style, shape_paths
from elastica_cad.formats.drawing_files.layers import LayerChoice, style_layers
from elastica_cad.formats.drawing_files.svg_paths import format_length, path_data

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
    >>> from elastica_cad.geometry.paths.path import Path
    >>> plate = Drawing("plate", [LayeredPath(CUT_OUTER, Path.rectangle(40, 10))])
    >>> 'width="42mm" height="12mm"' in encode_svg(plate).decode()
    True
    """
    require_record(drawing, Drawing, "what is written", "a Drawing record")
    curves = check_curve_style(curves)
    styles = style_layers(layers)
    (left, low), (right, high) = drawing.bounds
    width, height = format_length(right - left + 2 * _MARGIN_MM), format_length(high - low + 2 * _MARGIN_MM)
    shaped = shape_paths([item.path for item in drawing.strokes], curves, tolerance, rational=False)
    corner = np.array([left - _MARGIN_MM, high + _MARGIN_MM])
    rows = [
        '<?xml version="1.0" encoding="UTF-8"?>',
        '<svg xmlns="http://www.w3.org/2000/svg" version="1.1" '
        'xmlns:inkscape="http://www.inkscape.org/namespaces/inkscape" '
        f'width="{width}mm" height="{height}mm" viewBox="0 0 {width} {height}">',
        f"<title>{html_text(drawing.name)}</title>",
    ]
    for layer in LAYERS:
        paths = [path for item, path in zip(drawing.strokes, shaped, strict=True) if item.layer == layer]
        if not paths:
            continue
        style = styles[layer]
        key, label = html_text(style.name.replace(" ", "_")), html_text(style.name)
        rows.append(
            f'<g id="{key}" inkscape:groupmode="layer" inkscape:label="{label}" '
            f'fill="none" stroke="{style.color}" stroke-width="{_STROKE_MM:g}">'
        )
        rows.extend(f'<path d="{path_data(path, corner)}"/>' for path in paths)
        rows.append("</g>")
    rows.append("</svg>\n")
    return "\n".join(rows).encode()
