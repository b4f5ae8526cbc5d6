"""Picture of a bow with its cord, of its drawn curve, and of its shapes with shorter cords."""

import numpy as np

from elastica_cad._values import require_record
from elastica_cad.geometry.plane_points import box_about, norm
from elastica_cad.model.bows import Bow
from elastica_cad.plot.canvas import INK, Figure, new_page
from elastica_cad.plot.strip_pictures import FAINT, LINE, blend, finish_axes, numbered_panel
from elastica_cad.strip.travel import Travel


def bow(bow: Bow, shorter: Travel) -> Figure:
    """Draw a bow with its cord, the drawn curve, and the shapes with a shorter cord.

    Raises
    ------
    MissingDependencyError
        matplotlib is not installed.
    """
    require_record(bow, Bow, "what is drawn", "a Bow")
    require_record(shorter, Travel, "the bow with shorter cords", "a Travel")
    rod, wish = bow.strip.rod, bow.drawn.sample(600).position
    low, high = box_about(np.concatenate([wish, rod.position, *(shape.position for shape in shorter.rods)]))
    size = np.maximum(high - low, 0.3 * np.max(high - low))
    figure, (axes,) = new_page([numbered_panel(size * (1.0, 1.1))])
    cords, colors = norm(shorter.end), blend(len(shorter.rods))
    lines = [
        axes.plot(*shape.position.T, color=color, linewidth=1.0, label=f"_{cord:.1f} mm")[0]
        for shape, cord, color in zip(shorter.rods, cords, colors, strict=True)
        if cord < (1 - 1e-6) * bow.cord
    ]
    axes.plot(*wish.T, color=FAINT, linewidth=1.4, linestyle=(0, (4, 2)), label="drawn curve")
    axes.plot(*rod.position.T, color=INK, linewidth=2.2, label="bow")
    axes.plot(*rod.position[[0, -1]].T, "o-", color=LINE, markersize=4, linewidth=1.2, label="cord")
    if lines:  # list the shapes between bow and cord, where the picture has space
        names = [line.get_label()[1:] for line in lines]
        place = {"loc": "lower center", "bbox_to_anchor": (0.5, 0.08)}
        axes.add_artist(axes.legend(lines, names, title="shorter cords", fontsize=9, frameon=False, **place))
    finish_axes(axes, f"Bow: {bow.length:.1f} mm long, cord {bow.cord:.1f} mm, rise {bow.rise:.1f} mm")
    return figure
