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
from elastica_cad.forming import Box, HalfPlane, Keep, Limits, NearestRod, Status, nearest_rod
from elastica_cad.geometry import Path, PlaneCurve, Profile
from elastica_cad.mechanics import (
    Calibration,
    End,
    EquilibriumCheck,
    Gravity,
    NotRealizable,
    PointMass,
    Rod,
    Sheet,
    Stability,
    Supports,
    Weight,
    bend,
    bend_path,
    calibrate_cantilever,
    check_equilibrium,
    load_sheets,
    optimal_rod,
    sheet_names,
    stability,
    stability_limit,
    tolerance_study,
)

__all__ = [
    "Box",
    "Calibration",
    "Drawing",
    "ElasticaError",
    "End",
    "EquilibriumCheck",
    "Gravity",
    "HalfPlane",
    "InputError",
    "Keep",
    "Limits",
    "MissingDependencyError",
    "NearestRod",
    "NotConvergedError",
    "NotRealizable",
    "Path",
    "Plain",
    "PlaneCurve",
    "PointMass",
    "Profile",
    "Rod",
    "Sheet",
    "Stability",
    "Status",
    "Strip",
    "Supports",
    "Tab",
    "Weight",
    "bend",
    "bend_path",
    "calibrate_cantilever",
    "check_equilibrium",
    "load_sheets",
    "nearest_rod",
    "optimal_rod",
    "read_curves",
    "save",
    "sheet_names",
    "stability",
    "stability_limit",
    "tolerance_study",
]
