from elastica_cad import (
    fabrication as fabrication,
    formats as formats,
    forming as forming,
    geometry as geometry,
    mechanics as mechanics,
    plot as plot,
    published as published,
)
from elastica_cad.errors import (
    ElasticaError as ElasticaError,
    InputError as InputError,
    MissingDependencyError as MissingDependencyError,
    NotConvergedError as NotConvergedError,
)
from elastica_cad.fabrication.drawings.drawing import Drawing as Drawing
from elastica_cad.fabrication.flexure import Flexure as Flexure
from elastica_cad.fabrication.makeability.fabrication_limits import FabricationLimits as FabricationLimits
from elastica_cad.fabrication.model.revolution_model import revolution as revolution, revolve as revolve
from elastica_cad.fabrication.model.strip_model import Model as Model
from elastica_cad.fabrication.model.touching_widths import touching_widths as touching_widths
from elastica_cad.fabrication.placed_strip import Placed as Placed
from elastica_cad.fabrication.slots.slot import Slot as Slot
from elastica_cad.fabrication.strip.lamination import Laminated as Laminated
from elastica_cad.fabrication.strip.perforation import Perforated as Perforated
from elastica_cad.fabrication.strip.strip_record import Strip as Strip
from elastica_cad.fabrication.strip_spec import StripSpec as StripSpec, make_strip as make_strip
from elastica_cad.fabrication.strip.styles import Plain as Plain
from elastica_cad.fabrication.strip.outline import Hole as Hole, Tab as Tab
from elastica_cad.fabrication.travel import bend_strip as bend_strip
from elastica_cad.files import read_curves as read_curves, save as save
from elastica_cad.formats.curve_files.write_curves import write_curves as write_curves
from elastica_cad.forming.limits import Box as Box, HalfPlane as HalfPlane, Keep as Keep, Limits as Limits
from elastica_cad.forming.many_rods import nearest_rods as nearest_rods
from elastica_cad.forming.matched_pair import matched_pair as matched_pair
from elastica_cad.forming.nearest.nearest_record import NearestRod as NearestRod, Status as Status
from elastica_cad.forming.nearest.nearest_rod import nearest_rod as nearest_rod
from elastica_cad.forming.revolution.meridian import (
    meridian as meridian,
    meridian_through as meridian_through,
)
from elastica_cad.forming.splitting import split as split
from elastica_cad.geometry.curves.plane_curve import PlaneCurve as PlaneCurve
from elastica_cad.geometry.curves.projective_maps import four_point_map as four_point_map
from elastica_cad.geometry.frame import Frame as Frame
from elastica_cad.geometry.paths.path import Path as Path
from elastica_cad.geometry.paths.profile import Profile as Profile
from elastica_cad.kit.kit_files import save_model as save_model
from elastica_cad.mechanics.bending.bend_forward import bend as bend
from elastica_cad.mechanics.loads.gravity import Gravity as Gravity
from elastica_cad.mechanics.loads.supports import End as End, Supports as Supports
from elastica_cad.mechanics.loads.weight import PointMass as PointMass, Weight as Weight
from elastica_cad.mechanics.material.sheet import (
    Sheet as Sheet,
    load_sheets as load_sheets,
    sheet_names as sheet_names,
)
from elastica_cad.mechanics.rod.rod_record import Rod as Rod
from elastica_cad.mechanics.stability.stability_verdict import Stability as Stability, stability as stability
from elastica_cad.mechanics.studies.stability_limit import stability_limit as stability_limit
from elastica_cad.mechanics.stiffness.optimal_rod import optimal_rod as optimal_rod
from elastica_cad.mechanics.theorem1.equilibrium_check import check_equilibrium as check_equilibrium
from elastica_cad.mechanics.theorem1.verdict import (
    EquilibriumCheck as EquilibriumCheck,
    NotRealizable as NotRealizable,
)
from elastica_cad.web.notebook import studio as studio
from elastica_cad.mechanics.two_states.pair_check import check_pair as check_pair
from elastica_cad.mechanics.two_states.two_state_rod import (
    PairLimits as PairLimits,
    TwoStateRod as TwoStateRod,
    two_state_rod as two_state_rod,
)
