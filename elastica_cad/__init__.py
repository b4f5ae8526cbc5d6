"""Strips that are cut flat and bend into a drawn curve.

>>> import elastica_cad as ec
>>> curve = ec.PlaneCurve.ellipse((0, 0), (200, 100), 0.0, 0.0, 3.14159)
>>> rod = ec.optimal_rod(curve)
>>> round(rod.ratio, 3)
1.57
"""

from elastica_cad.errors import ElasticaError, InputError, MissingDependencyError, NotConvergedError
from elastica_cad.fabrication import Drawing, Plain, Strip, Tab
from elastica_cad.files import read_curves, save
from elastica_cad.geometry import Path, PlaneCurve, Profile
from elastica_cad.mechanics import (
    End,
    Gravity,
    NotRealizable,
    Rod,
    Sheet,
    Supports,
    check_equilibrium,
    optimal_rod,
    sheet_names,
)

__all__ = [
    "Drawing",
    "ElasticaError",
    "End",
    "Gravity",
    "InputError",
    "MissingDependencyError",
    "NotConvergedError",
    "NotRealizable",
    "Path",
    "Plain",
    "PlaneCurve",
    "Profile",
    "Rod",
    "Sheet",
    "Strip",
    "Supports",
    "Tab",
    "check_equilibrium",
    "optimal_rod",
    "read_curves",
    "save",
    "sheet_names",
]
