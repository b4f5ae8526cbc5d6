from elastica_cad.forming.nearest.nearest_record import Binding as Binding
from elastica_cad.forming.fairing_request import smooth_curve as smooth_curve
from elastica_cad.forming.leaf_ends import LeafedRod as LeafedRod, lay_leaves as lay_leaves
from elastica_cad.forming.limits import Box as Box, HalfPlane as HalfPlane, Keep as Keep, Limits as Limits
from elastica_cad.forming.many_rods import (
    nearest_rods as nearest_rods,
    stream_nearest_rods as stream_nearest_rods,
)
from elastica_cad.forming.matched_pair import MatchedPair as MatchedPair, matched_pair as matched_pair
from elastica_cad.forming.nearest.nearest_record import NearestRod as NearestRod, Status as Status
from elastica_cad.forming.nearest.nearest_rod import nearest_rod as nearest_rod
from elastica_cad.forming.plane_sections.section_spec import (
    parallel_planes as parallel_planes,
    planes_along as planes_along,
    radial_planes as radial_planes,
)
from elastica_cad.forming.plane_sections.mesh_sections import mesh_sections as mesh_sections
from elastica_cad.forming.plane_sections.section_curves import (
    SectionCurve as SectionCurve,
    section_curves as section_curves,
    smooth_polyline as smooth_polyline,
    remove_false_inflections as remove_false_inflections,
)
from elastica_cad.forming.plane_sections.section_lines import (
    PlaneSection as PlaneSection,
    SectionLine as SectionLine,
)
from elastica_cad.forming.plane_sections.mesh_sections import Mesh as Mesh
from elastica_cad.forming.revolution.meridian import (
    Meridian as Meridian,
    meridian as meridian,
    meridian_through as meridian_through,
)
from elastica_cad.forming.splitting import Splitting as Splitting, split as split
