from elastica_cad.form_finding.fairing_request import smooth_curve as smooth_curve
from elastica_cad.form_finding.leaf_ends import lay_leaves as lay_leaves, LeafedRod as LeafedRod
from elastica_cad.form_finding.limits import (
    ActiveLimit as ActiveLimit,
    Box as Box,
    HalfPlane as HalfPlane,
    Keep as Keep,
    Limits as Limits,
)
from elastica_cad.form_finding.many_rods import (
    nearest_rods as nearest_rods,
    stream_nearest_rods as stream_nearest_rods,
)
from elastica_cad.form_finding.meridians import (
    Meridian as Meridian,
    meridian as meridian,
    meridian_through as meridian_through,
)
from elastica_cad.form_finding.nearest_record import NearestRod as NearestRod, Status as Status
from elastica_cad.form_finding.nearest_search import nearest_rod as nearest_rod
from elastica_cad.form_finding.plane_sections import Mesh as Mesh, mesh_sections as mesh_sections
from elastica_cad.form_finding.section_lines import (
    PlaneSection as PlaneSection,
    remove_false_inflections as remove_false_inflections,
    section_curves as section_curves,
    SectionCurve as SectionCurve,
    SectionLine as SectionLine,
    smooth_polyline as smooth_polyline,
)
from elastica_cad.form_finding.section_spec import (
    parallel_planes as parallel_planes,
    planes_along as planes_along,
    radial_planes as radial_planes,
)
from elastica_cad.form_finding.splitting import split as split, Splitting as Splitting
