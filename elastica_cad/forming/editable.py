"""A rod's rest shape as a spline of degree 4 with few control points, for further editing."""

import numpy as np

from elastica_cad.forming.limits import Keep
from elastica_cad.geometry import PlaneCurve
from elastica_cad.mechanics import Rod

__all__ = ["editable_curve"]


def editable_curve(rod: Rod, keep: Keep) -> PlaneCurve:
    """Fit."""
    return PlaneCurve.fit(np.asarray(rod.position), degree=4, tolerance=1e-3)
