"""Rods and what holds them: materials, balance, Theorem 1, optimal stiffness, bending, stability."""

from elastica_cad.mechanics.anticlastic import AnticlasticWidths, anticlastic_factor, anticlastic_widths
from elastica_cad.mechanics.bend import bend, bend_path
from elastica_cad.mechanics.calibration import Calibration, calibrate_cantilever, cantilever_droop
from elastica_cad.mechanics.discrete import constrained_margin, margin_derivatives
from elastica_cad.mechanics.equilibrium import EquilibriumCheck, NotRealizable, check_equilibrium
from elastica_cad.mechanics.gravity import Gravity
from elastica_cad.mechanics.gravity_lp import SampledStiffness, sampled_stiffness
from elastica_cad.mechanics.jacobi import conjugate_point, determinant_gradient, stability_determinant
from elastica_cad.mechanics.laminate import Laminate, optimal_laminate
from elastica_cad.mechanics.limits_of_stability import StabilityLimit, stability_limit
from elastica_cad.mechanics.line import InflectionLine
from elastica_cad.mechanics.loads import PointMass, Weight
from elastica_cad.mechanics.material_laws import (
    ElasticPlasticLaw,
    MaterialLaw,
    PlasticLaw,
    PolynomialLaw,
    TabulatedLaw,
)
from elastica_cad.mechanics.notches import dead_zone_slope
from elastica_cad.mechanics.optimal import optimal_rod
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.section_limits import LayerStrain, ScaleRange
from elastica_cad.mechanics.sections import LaminatedSection, PerforatedSection, PlainSection
from elastica_cad.mechanics.sheet import Sheet, load_sheets, sheet_names
from elastica_cad.mechanics.stability import Stability, stability
from elastica_cad.mechanics.supports import End, Supports
from elastica_cad.mechanics.tolerance import (
    ToleranceEffect,
    ToleranceRanges,
    ToleranceStudy,
    tolerance_study,
)
from elastica_cad.mechanics.variation import Variation, varied_rod

__all__ = [
    "AnticlasticWidths",
    "Calibration",
    "ElasticPlasticLaw",
    "End",
    "EquilibriumCheck",
    "Gravity",
    "InflectionLine",
    "Laminate",
    "LaminatedSection",
    "LayerStrain",
    "MaterialLaw",
    "NotRealizable",
    "PerforatedSection",
    "PlainSection",
    "PlasticLaw",
    "PointMass",
    "PolynomialLaw",
    "Rod",
    "SampledStiffness",
    "ScaleRange",
    "Sheet",
    "Stability",
    "StabilityLimit",
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
    "check_equilibrium",
    "conjugate_point",
    "constrained_margin",
    "dead_zone_slope",
    "determinant_gradient",
    "load_sheets",
    "margin_derivatives",
    "optimal_laminate",
    "optimal_rod",
    "sampled_stiffness",
    "sheet_names",
    "stability",
    "stability_determinant",
    "stability_limit",
    "tolerance_study",
    "varied_rod",
]
