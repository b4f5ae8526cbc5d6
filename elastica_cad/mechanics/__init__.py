"""mechanics"""

from elastica_cad.mechanics.bend import bend, bend_path
from elastica_cad.mechanics.gravity import Gravity
from elastica_cad.mechanics.loads import PointMass, Weight
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.sheet import Sheet, load_sheets, sheet_names
from elastica_cad.mechanics.stability import Stability, stability
from elastica_cad.mechanics.supports import End, Supports

__all__ = [
    "End",
    "Gravity",
    "PointMass",
    "Rod",
    "Sheet",
    "Stability",
    "Supports",
    "Weight",
    "bend",
    "bend_path",
    "load_sheets",
    "sheet_names",
    "stability",
]
