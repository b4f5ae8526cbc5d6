from elastica_cad.geometry.curve_editing.control_point_constraints import (
    CollinearInflections as CollinearInflections,
    EndPositions as EndPositions,
    EndTangents as EndTangents,
    FixedLength as FixedLength,
    InflectionsOnLine as InflectionsOnLine,
    least_norm_newton as least_norm_newton,
)
from elastica_cad.geometry.curves.plane_curve import (
    Break as Break,
    CurvatureZero as CurvatureZero,
    CurveSamples as CurveSamples,
    PlaneCurve as PlaneCurve,
    TangentBreak as TangentBreak,
    line_crossings as line_crossings,
)
from elastica_cad.geometry.curves.projective_maps import four_point_map as four_point_map
from elastica_cad.geometry.frame import Frame as Frame
from elastica_cad.geometry.paths.approximations import (
    as_arcs as as_arcs,
    as_cubics as as_cubics,
    as_polyline as as_polyline,
)
from elastica_cad.geometry.paths.offset import offset_path as offset_path
from elastica_cad.geometry.paths.path import Path as Path
from elastica_cad.geometry.paths.profile import Profile as Profile
from elastica_cad.geometry.paths.segments import (
    Arc as Arc,
    Line as Line,
    Segment as Segment,
    Spline as Spline,
)
