from elastica_cad.mechanics.bending import bend as bend, bend_path as bend_path
from elastica_cad.mechanics.between_clamps import (
    elastica_between as elastica_between,
    ElasticaBetween as ElasticaBetween,
)
from elastica_cad.mechanics.calibration import (
    calibrate_cantilever as calibrate_cantilever,
    Calibration as Calibration,
    cantilever_droop as cantilever_droop,
)
from elastica_cad.mechanics.creep_study import Creep as Creep, creep as creep
from elastica_cad.mechanics.discrete_rod import DiscreteRod as DiscreteRod
from elastica_cad.mechanics.elements import (
    ElementForce as ElementForce,
    Pin as Pin,
    PointForce as PointForce,
    Rail as Rail,
    Tie as Tie,
)
from elastica_cad.mechanics.laminated_section import LaminatedSection as LaminatedSection
from elastica_cad.mechanics.least_ratio import (
    Laminate as Laminate,
    optimal_laminate as optimal_laminate,
    optimal_rod as optimal_rod,
)
from elastica_cad.mechanics.loads import (
    End as End,
    Gravity as Gravity,
    PointMass as PointMass,
    RestCurvature as RestCurvature,
    Supports as Supports,
    Weight as Weight,
)
from elastica_cad.mechanics.many_optimal_rods import optimal_rods as optimal_rods
from elastica_cad.mechanics.moment_curvature import (
    ElasticPlasticLaw as ElasticPlasticLaw,
    MaterialLaw as MaterialLaw,
    PlasticLaw as PlasticLaw,
    PolynomialLaw as PolynomialLaw,
    TabulatedLaw as TabulatedLaw,
)
from elastica_cad.mechanics.rod import Rod as Rod
from elastica_cad.mechanics.section_limits import LayerStrain as LayerStrain, ScaleRange as ScaleRange
from elastica_cad.mechanics.sections import (
    anticlastic_factor as anticlastic_factor,
    crack_energy as crack_energy,
    PerforatedSection as PerforatedSection,
    PlainSection as PlainSection,
)
from elastica_cad.mechanics.sheets import (
    load_sheets as load_sheets,
    Sheet as Sheet,
    sheet_names as sheet_names,
)
from elastica_cad.mechanics.sideways import (
    sideways_stability as sideways_stability,
    SidewaysStability as SidewaysStability,
)
from elastica_cad.mechanics.stability import (
    conjugate_point as conjugate_point,
    determinant_gradient as determinant_gradient,
    Stability as Stability,
    stability_determinant as stability_determinant,
)
from elastica_cad.mechanics.stability_limits import (
    stability_limit as stability_limit,
    StabilityLimit as StabilityLimit,
)
from elastica_cad.mechanics.cross_sections import (
    LaidLeaves as LaidLeaves,
    Leaf as Leaf,
    LeavesLaw as LeavesLaw,
    RoundLaw as RoundLaw,
    Section as Section,
    SectionLayer as SectionLayer,
    ThicknessLaw as ThicknessLaw,
)
from elastica_cad.mechanics.support_search import suggest_support as suggest_support
from elastica_cad.mechanics.theorem1 import (
    EquilibriumCheck as EquilibriumCheck,
    InflectionLine as InflectionLine,
    NotRealizable as NotRealizable,
    PairCheck as PairCheck,
    PairZero as PairZero,
)
from elastica_cad.mechanics.tolerances import (
    Imperfection as Imperfection,
    perturb_rod as perturb_rod,
    tolerance_study as tolerance_study,
    ToleranceEffect as ToleranceEffect,
    ToleranceRanges as ToleranceRanges,
    ToleranceStudy as ToleranceStudy,
)
