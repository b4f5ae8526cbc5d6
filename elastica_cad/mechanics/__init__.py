"""mechanics"""

from elastica_cad.mechanics.anticlastic import AnticlasticWidths, anticlastic_factor, anticlastic_widths
from elastica_cad.mechanics.bend import bend, bend_path
from elastica_cad.mechanics.calibration import Calibration, calibrate_cantilever, cantilever_droop
from elastica_cad.mechanics.gravity import Gravity
from elastica_cad.mechanics.loads import PointMass, Weight
from elastica_cad.mechanics.material_laws import (
    ElasticPlasticLaw,
    MaterialLaw,
    PlasticLaw,
    PolynomialLaw,
    TabulatedLaw,
)
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.sections import (
    LaminatedSection,
    LayerStrain,
    PerforatedSection,
    PlainSection,
    ScaleRange,
)
from elastica_cad.mechanics.sheet import Sheet, load_sheets, sheet_names
from elastica_cad.mechanics.stability import Stability, stability
from elastica_cad.mechanics.supports import End, Supports
from elastica_cad.mechanics.tolerance import (
    ToleranceEffect,
    ToleranceRanges,
    ToleranceStudy,
    Variation,
    tolerance_study,
    varied_rod,
)

__all__ = [
    "AnticlasticWidths",
    "Calibration",
    "ElasticPlasticLaw",
    "End",
    "Gravity",
    "LaminatedSection",
    "LayerStrain",
    "MaterialLaw",
    "PerforatedSection",
    "PlainSection",
    "PlasticLaw",
    "PointMass",
    "PolynomialLaw",
    "Rod",
    "ScaleRange",
    "Sheet",
    "Stability",
    "Supports",
    "TabulatedLaw",
    "ToleranceEffect",
    "ToleranceRanges",
    "ToleranceStudy",
    "Variation",
    "Weight",
    "anticlastic_factor",
    "anticlastic_widths",
    "bend",
    "bend_path",
    "calibrate_cantilever",
    "cantilever_droop",
    "load_sheets",
    "sheet_names",
    "stability",
    "tolerance_study",
    "varied_rod",
]
