"""A strip on one page: its curve, its stiffness, its flat pattern; and drawings in the colours of their layers."""

import numpy as np

from elastica_cad._values import require_record
from elastica_cad.fabrication.drawings.drawing import Drawing
from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.mechanics.rod.rod_record import Rod
from elastica_cad.plot.canvas import INK, Axes, Figure, new_page
from elastica_cad.plot.strip_page import NUMBERED, STIFFNESS, WIDE, paint_both_axes, paint_legend
from elastica_cad.plot.strip_views import (
    view_bent,
    view_flat,
    view_layers,
    view_page,
    view_paths,
    view_stiffness,
)

LAYER_COLORS = {
    "CUT_OUTER": "#c2452d",
    "CUT_INNER": "#2f6db3",
    "ENGRAVE": INK,
    "MARK": "#3a8f4d",
    "SHEET": "#8a8f98",
}


def rod(rod: Rod, *, wish: PlaneCurve | None = None) -> Figure:
    """The bent rod with its curvature comb and inflection line, and its stiffness along the strip.

    `wish` is drawn beside it where the rod is the nearest one to a curve that was asked for.
    """
    require_record(rod, Rod, "what is drawn", "a Rod")
    bent = view_bent(rod, wish)
    figure, (above, below) = new_page([bent.panel, STIFFNESS])
    bent.paint(above)
    view_stiffness(rod).paint(below)
    return figure


def strip(strip: Strip) -> Figure:
    """The flat strip with its dimensions."""
    require_record(strip, Strip, "what is drawn", "a Strip")
    flat = view_flat(strip)
    figure, (axes,) = new_page([flat.panel])
    flat.paint(axes)
    return figure


def drawing(drawing: Drawing) -> Figure:
    """A drawing in the colours of its layers."""
    from matplotlib.collections import LineCollection

    require_record(drawing, Drawing, "what is drawn", "a Drawing")
    low, high = drawing.bounds
    size = np.maximum(high - low, 1e-9)
    figure, (axes,) = new_page(
        [NUMBERED._replace(height=float(np.clip(WIDE * size[1] / size[0], 1.6, 11.0)))]
    )
    lines = view_paths([item.path for item in drawing.strokes])
    for layer in dict.fromkeys(item.layer for item in drawing.strokes):
        strokes = [line for item, line in zip(drawing.strokes, lines, strict=True) if item.layer == layer]
        # on whole pixels, dots of letters would shrink to nothing
        axes.add_collection(
            LineCollection(strokes, colors=LAYER_COLORS[layer], linewidths=0.9, label=layer, snap=False)
        )
    axes.autoscale_view()
    paint_both_axes(axes, f"{drawing.name}: {size[0]:.1f} by {size[1]:.1f} mm")
    paint_legend(axes)
    return figure


def strip_sheet(strip: Strip, *, wish: PlaneCurve | None = None) -> Figure:
    """One page about a strip: its curve, its stiffness, its flat pattern.

    Parameters
    ----------
    strip : Strip
    wish : PlaneCurve, optional
        The curve that was asked for, where the rod is the nearest one that can be made.
    """
    return view_page(strip, wish).figure()


def paint_flat(axes: Axes, strip: Strip, shift: tuple[float, float] = (0.0, 0.0)) -> None:
    """The cut pattern in the colours of its sheets, a backing seen through, moved by `shift` mm."""
    for layer in view_layers(strip):
        layer.paint(axes, shift)
