from elastica_cad.geometry.approximations import (
    as_arcs as as_arcs,
    as_cubics as as_cubics,
    as_polyline as as_polyline,
)
from elastica_cad.geometry.control_point_constraints import (
    CollinearInflections as CollinearInflections,
    EndPositions as EndPositions,
    EndTangents as EndTangents,
    FixedLength as FixedLength,
    InflectionsOnLine as InflectionsOnLine,
    least_norm_newton as least_norm_newton,
)
from elastica_cad.geometry.fairing import FIT_TOLERANCE as FIT_TOLERANCE
from elastica_cad.geometry.frame import Frame as Frame
from elastica_cad.geometry.offset import offset_path as offset_path
from elastica_cad.geometry.path import Path as Path
from elastica_cad.geometry.plane_curve import (
    Break as Break,
    CurvatureZero as CurvatureZero,
    CurveSamples as CurveSamples,
    line_crossings as line_crossings,
    PlaneCurve as PlaneCurve,
    TangentBreak as TangentBreak,
)
from elastica_cad.geometry.profile import Profile as Profile
from elastica_cad.geometry.projective_maps import four_point_map as four_point_map
from elastica_cad.geometry.path import Arc as Arc, Line as Line, Segment as Segment, Spline as Spline
