"""Pictures of rods, strips, drawings, models and bodies (needs matplotlib)."""

from elastica_cad.plot.canvas import save_figure
from elastica_cad.plot.sheets import drawing, rod, strip, strip_sheet
from elastica_cad.plot.space import bodies, model

__all__ = ["bodies", "drawing", "model", "rod", "save_figure", "strip", "strip_sheet"]
