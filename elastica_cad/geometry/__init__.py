"""Plane curves, paths of line, arc and spline segments, offsets, and functions along a strip."""

from elastica_cad.geometry.arcs import as_arcs, as_polyline
from elastica_cad.geometry.constraints import (
    CollinearInflections,
    EndPositions,
    EndTangents,
    FixedLength,
    InflectionsOnLine,
    least_norm_newton,
)
from elastica_cad.geometry.cubics import as_cubics
from elastica_cad.geometry.curve import PlaneCurve
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.lines import line_crossings
from elastica_cad.geometry.offset import offset_path
from elastica_cad.geometry.path import Path
from elastica_cad.geometry.profile import Profile
from elastica_cad.geometry.projective import four_point_map
from elastica_cad.geometry.records import Break, CurvatureZero, CurveSamples, LineCrossing, TangentBreak
from elastica_cad.geometry.segments import Arc, Line, Segment, Spline

__all__ = [
    "Arc",
    "Break",
    "CollinearInflections",
    "CurvatureZero",
    "CurveSamples",
    "EndPositions",
    "EndTangents",
    "FixedLength",
    "Frame",
    "InflectionsOnLine",
    "Line",
    "LineCrossing",
    "Path",
    "PlaneCurve",
    "Profile",
    "Segment",
    "Spline",
    "TangentBreak",
    "as_arcs",
    "as_cubics",
    "as_polyline",
    "four_point_map",
    "least_norm_newton",
    "line_crossings",
    "offset_path",
]
