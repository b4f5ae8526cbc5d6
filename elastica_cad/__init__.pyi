from elastica_cad import (
    design as design,
    formats as formats,
    form_finding as form_finding,
    geometry as geometry,
    mechanics as mechanics,
    model as model,
    pairs as pairs,
    plot as plot,
    paper as paper,
    strip as strip,
)
from elastica_cad.errors import (
    ElasticaError as ElasticaError,
    InputError as InputError,
    MissingDependencyError as MissingDependencyError,
    NotConvergedError as NotConvergedError,
)
from elastica_cad.strip.drawing import Drawing as Drawing
from elastica_cad.pairs.flexure import Flexure as Flexure
from elastica_cad.strip.uncuttable_parts import FabricationLimits as FabricationLimits
from elastica_cad.model.revolution_model import revolution as revolution, revolve as revolve
from elastica_cad.model.model import Model as Model
from elastica_cad.model.revolution_model import touching_widths as touching_widths
from elastica_cad.strip.strip import Placed as Placed
from elastica_cad.strip.slots import Slot as Slot
from elastica_cad.strip.lamination import Laminated as Laminated
from elastica_cad.strip.perforation import Perforated as Perforated
from elastica_cad.strip.strip import Strip as Strip
from elastica_cad.strip.strip_spec import StripSpec as StripSpec, make_strip as make_strip
from elastica_cad.strip.styles import Plain as Plain
from elastica_cad.strip.outline import Hole as Hole, Tab as Tab
from elastica_cad.strip.travel import bend_strip as bend_strip
from elastica_cad.model.bows import bow as bow
from elastica_cad.files import read_curves as read_curves, read_model as read_model, save as save
from elastica_cad.formats.curve_writer import write_curves as write_curves
from elastica_cad.form_finding.limits import (
    Box as Box,
    HalfPlane as HalfPlane,
    Keep as Keep,
    Limits as Limits,
)
from elastica_cad.form_finding.many_rods import nearest_rods as nearest_rods
from elastica_cad.pairs.matching import matched_pair as matched_pair
from elastica_cad.form_finding.nearest_record import NearestRod as NearestRod, Status as Status
from elastica_cad.form_finding.nearest_search import nearest_rod as nearest_rod
from elastica_cad.form_finding.meridians import meridian as meridian, meridian_through as meridian_through
from elastica_cad.form_finding.splitting import split as split
from elastica_cad.geometry.plane_curve import PlaneCurve as PlaneCurve
from elastica_cad.geometry.projective_maps import four_point_map as four_point_map
from elastica_cad.geometry.frame import Frame as Frame
from elastica_cad.geometry.path import Path as Path
from elastica_cad.geometry.profile import Profile as Profile
from elastica_cad.kit.model_kit import save_model as save_model
from elastica_cad.mechanics.bending import bend as bend
from elastica_cad.mechanics.elements import Pin as Pin, Rail as Rail, Tie as Tie
from elastica_cad.mechanics.elements import PointForce as PointForce
from elastica_cad.mechanics.loads import Gravity as Gravity
from elastica_cad.mechanics.loads import End as End, Supports as Supports
from elastica_cad.mechanics.loads import PointMass as PointMass, Weight as Weight
from elastica_cad.mechanics.sheets import (
    Sheet as Sheet,
    load_sheets as load_sheets,
    sheet_names as sheet_names,
)
from elastica_cad.mechanics.rod import Rod as Rod
from elastica_cad.mechanics.stability import Stability as Stability, stability as stability
from elastica_cad.mechanics.stability_limits import stability_limit as stability_limit
from elastica_cad.mechanics.least_ratio import optimal_rod as optimal_rod
from elastica_cad.strip.curve_check import check_equilibrium as check_equilibrium
from elastica_cad.mechanics.theorem1 import (
    EquilibriumCheck as EquilibriumCheck,
    NotRealizable as NotRealizable,
)
from elastica_cad.web.notebook import studio as studio
from elastica_cad.pairs.pair_check import check_pair as check_pair
from elastica_cad.pairs.two_state_rods import (
    PairLimits as PairLimits,
    TwoStateRod as TwoStateRod,
    two_state_rod as two_state_rod,
)

__version__: str
