"""Design changes: limits, the nearest rod that meets them, the paper's own routes, curves from surfaces."""

from elastica_cad.forming.binding import Binding
from elastica_cad.forming.enforce import EnforcedCurve, enforce_constraints
from elastica_cad.forming.limits import Box, HalfPlane, Keep, Limits
from elastica_cad.forming.many import nearest_rods
from elastica_cad.forming.mesh import Mesh
from elastica_cad.forming.nearest import NearestRod, Status, nearest_rod
from elastica_cad.forming.planes import parallel_planes, planes_along, radial_planes
from elastica_cad.forming.ratio import OptimizedRatio, RatioStatus, optimize_ratio
from elastica_cad.forming.recovery import RecoveredStability, RecoveryStatus, recover_stability
from elastica_cad.forming.revolution import Meridian, meridian, meridian_through
from elastica_cad.forming.section_curves import (
    SectionCurve,
    section_curves,
    smoothed,
    without_false_inflections,
)
from elastica_cad.forming.sections import Section, SectionLine, mesh_sections
from elastica_cad.forming.splitting import Splitting, split

__all__ = [
    "Binding",
    "Box",
    "EnforcedCurve",
    "HalfPlane",
    "Keep",
    "Limits",
    "Meridian",
    "Mesh",
    "NearestRod",
    "OptimizedRatio",
    "RatioStatus",
    "RecoveredStability",
    "RecoveryStatus",
    "Section",
    "SectionCurve",
    "SectionLine",
    "Splitting",
    "Status",
    "enforce_constraints",
    "meridian",
    "meridian_through",
    "mesh_sections",
    "nearest_rod",
    "nearest_rods",
    "optimize_ratio",
    "parallel_planes",
    "planes_along",
    "radial_planes",
    "recover_stability",
    "section_curves",
    "smoothed",
    "split",
    "without_false_inflections",
]
