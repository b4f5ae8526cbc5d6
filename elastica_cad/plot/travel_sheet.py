"""A strip on its travel: every shape on the way, and force and energy over the way of its end."""

import numpy as np

from elastica_cad._values import require_record
from elastica_cad.fabrication.travel import Travel
from elastica_cad.plot.canvas import INK, Figure, Panel, new_page

FIRST, LAST, UNSTABLE = "#a9c6e8", "#1d4f8c", "#c2452d"  # shapes from first to last; what snaps away
SHAPES = Panel(3.2, above=0.3, below=0.52, left=0.8, right=0.8)
COSTS = SHAPES._replace(height=2.4)  # force on one side, energy on the other
FORCE, ENERGY = "#1d4f8c", "#e0962b"


def travel(moved: Travel) -> Figure:
    """All shapes of a travel above, force along the way and bending energy below."""
    require_record(moved, Travel, "what is drawn", "a Travel")
    figure, (above, below) = new_page([SHAPES, COSTS])
    steps = len(moved.rods)
    colors = _blend(FIRST, LAST, steps)
    for k, rod in enumerate(moved.rods):
        color = colors[k] if moved.stable[k] else UNSTABLE
        above.plot(*rod.position.T, color=color, linewidth=1.6 if k in (0, steps - 1) else 0.9)
    above.set_aspect("equal", adjustable="datalim")
    snapping = "" if moved.stable.all() else "; red: unstable, it snaps away"
    above.set_title(f"{steps} shapes, the last one darkest{snapping}", fontsize=9, color=INK, y=1.0)
    above.set_xlabel("x, mm")
    above.set_ylabel("y, mm")
    below.plot(moved.travel, moved.force_along, color=FORCE, marker=".", label="force along the way, N")
    below.set_xlabel("travel of the end, mm")
    below.set_ylabel("force, N", color=FORCE)
    below.grid(alpha=0.25)
    beside = below.twinx()
    beside.plot(moved.travel, moved.energy, color=ENERGY, linestyle="--")
    beside.set_ylabel("bending energy, N mm", color=ENERGY)
    for axes in (below, beside):  # from 0, so that a force that hardly changes looks so
        low, high = axes.get_ylim()
        room = 0.05 * (high - low) if low * high > 0 else 0.0
        axes.set_ylim(min(low - room, 0.0), max(high + room, 0.0))
    worst = int(np.argmin(moved.safety))
    below.set_title(
        f"largest strain {100 * moved.strain[worst]:.2f} % at {moved.travel[worst]:.4g} mm of travel, "
        f"safety {moved.safety[worst]:.2g}",
        fontsize=9,
        color=INK,
        y=1.0,
    )
    return figure


def _blend(first: str, last: str, count: int) -> list[tuple[float, float, float]]:
    """Colours from one to another."""
    a, b = (np.array([int(c[i : i + 2], 16) / 255 for i in (1, 3, 5)]) for c in (first, last))
    return [tuple(a + (b - a) * part) for part in np.linspace(0, 1, max(count, 2))][-count:]
