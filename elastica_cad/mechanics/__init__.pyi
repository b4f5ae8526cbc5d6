from elastica_cad.mechanics.bending.between_clamps import (
    ElasticaBetween as ElasticaBetween,
    elastica_between as elastica_between,
)
from elastica_cad.mechanics.bending.bend_forward import bend as bend, bend_path as bend_path
from elastica_cad.mechanics.loads.gravity import Gravity as Gravity
from elastica_cad.mechanics.loads.rest_curvature import RestCurvature as RestCurvature
from elastica_cad.mechanics.loads.supports import End as End, Supports as Supports
from elastica_cad.mechanics.loads.weight import PointMass as PointMass, Weight as Weight
from elastica_cad.mechanics.material.anticlastic import (
    anticlastic_factor as anticlastic_factor,
)
from elastica_cad.mechanics.material.laminated_section import LaminatedSection as LaminatedSection
from elastica_cad.mechanics.material.plain_section import (
    PerforatedSection as PerforatedSection,
    PlainSection as PlainSection,
    WidthLaw as WidthLaw,
)
from elastica_cad.mechanics.material.moment_curvature import (
    ElasticPlasticLaw as ElasticPlasticLaw,
    MaterialLaw as MaterialLaw,
    PlasticLaw as PlasticLaw,
    PolynomialLaw as PolynomialLaw,
    TabulatedLaw as TabulatedLaw,
)
from elastica_cad.mechanics.material.plain_section import crack_energy as crack_energy
from elastica_cad.mechanics.material.section_limits import (
    LayerStrain as LayerStrain,
    ScaleRange as ScaleRange,
)
from elastica_cad.mechanics.material.sheet import (
    Sheet as Sheet,
    load_sheets as load_sheets,
    sheet_names as sheet_names,
)
from elastica_cad.mechanics.material.stiffness_law import (
    BoundedLaw as BoundedLaw,
    StiffnessLaw as StiffnessLaw,
)
from elastica_cad.mechanics.material.stiffness_law import (
    LaidLeaves as LaidLeaves,
    Leaf as Leaf,
    LeavesLaw as LeavesLaw,
    RoundLaw as RoundLaw,
    ThicknessLaw as ThicknessLaw,
)
from elastica_cad.mechanics.rod.discrete_rod import DiscreteRod as DiscreteRod
from elastica_cad.mechanics.rod.rod_record import Rod as Rod
from elastica_cad.mechanics.stability.stability_verdict import (
    conjugate_point as conjugate_point,
    determinant_gradient as determinant_gradient,
    stability_determinant as stability_determinant,
)
from elastica_cad.mechanics.stability.sideways import (
    SidewaysStability as SidewaysStability,
    sideways_stability as sideways_stability,
)
from elastica_cad.mechanics.stability.stability_verdict import Stability as Stability
from elastica_cad.mechanics.stiffness.optimal_laminate import (
    Laminate as Laminate,
    optimal_laminate as optimal_laminate,
)
from elastica_cad.mechanics.stiffness.optimal_rod import optimal_rod as optimal_rod
from elastica_cad.mechanics.studies.calibration import (
    Calibration as Calibration,
    calibrate_cantilever as calibrate_cantilever,
    cantilever_droop as cantilever_droop,
)
from elastica_cad.mechanics.studies.creep import Creep as Creep, creep as creep
from elastica_cad.mechanics.studies.tolerance_study import (
    Imperfection as Imperfection,
    perturb_rod as perturb_rod,
)
from elastica_cad.mechanics.studies.stability_limit import (
    StabilityLimit as StabilityLimit,
    stability_limit as stability_limit,
)
from elastica_cad.mechanics.studies.tolerance_study import (
    ToleranceEffect as ToleranceEffect,
    ToleranceRanges as ToleranceRanges,
    ToleranceStudy as ToleranceStudy,
    tolerance_study as tolerance_study,
)
from elastica_cad.mechanics.theorem1.equilibrium_check import check_equilibrium as check_equilibrium
from elastica_cad.mechanics.theorem1.verdict import InflectionLine as InflectionLine
from elastica_cad.mechanics.theorem1.verdict import (
    EquilibriumCheck as EquilibriumCheck,
    NotRealizable as NotRealizable,
    PairCheck as PairCheck,
    PairZero as PairZero,
)
from elastica_cad.mechanics.two_states.pair_check import check_pair as check_pair
from elastica_cad.mechanics.two_states.two_state_rod import (
    PairLimits as PairLimits,
    TwoStateRod as TwoStateRod,
    two_state_rod as two_state_rod,
)
