"""geometry"""

from elastica_cad.geometry.arcs import as_arcs, as_polyline
from elastica_cad.geometry.cubics import as_cubics
from elastica_cad.geometry.curve import PlaneCurve, line_crossings
from elastica_cad.geometry.offset import offset_path
from elastica_cad.geometry.path import Path
from elastica_cad.geometry.profile import Profile
from elastica_cad.geometry.records import Break, CurvatureZero, CurveSamples, LineCrossing, TangentBreak
from elastica_cad.geometry.segments import Arc, Line, Segment, Spline

__all__ = [
    "Arc",
    "Break",
    "CurvatureZero",
    "CurveSamples",
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
    "line_crossings",
    "offset_path",
]
