"""Side views of tapered strips: closed outlines in the plane of the curve, which their width extrudes."""

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import InputError
from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.fabrication.strip.tabs import lines_through
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.profile import Profile
from elastica_cad.geometry.paths.segments import Segment, Spline
from elastica_cad.geometry.polynomials.fit_function import adaptive_spline

FACE_MM = 1e-4
"""How closely the faces follow half the thickness off the curve: far below what a plane takes off."""


def side_view(strip: Strip, *, bent: bool = False) -> Path:
    """The outline of a tapered strip seen from the side, anticlockwise; its tabs go on straight.

    Flat, x runs along the strip from the start of the free part, y = 0 is half way through the thickness; bent, it
    stands on the strip's curve.

    Raises
    ------
    InputError
        The strip is not tapered, or bent to a radius below half its thickness.

    Examples
    --------
    >>> from elastica_cad.fabrication.strip_spec import make_strip
    >>> from elastica_cad.mechanics.material.sheet import Sheet
    >>> from elastica_cad.mechanics.material.stiffness_law import ThicknessLaw
    >>> glass = Sheet("glass", 3.0, 38000.0, density=1900.0, max_strain=0.02)
    >>> arch = PlaneCurve.spline([(0, 0), (60, 120), (140, 160), (240, 120), (300, 0)])
    >>> strip = make_strip(arch, glass, law=ThicknessLaw(glass, 1.0, 4.0, width=20.0))
    >>> round(float(np.ptp(side_view(strip).bounds[:, 1])), 3)
    4.0
    """
    size = strip.layout.size
    if size is None:
        raise InputError("the strip is of one thickness: it has no side view; give it a law")
    first, last = (tab.length for tab in strip.ends)
    ends = size([0.0, strip.rod.length]) / 2
    right, left = (
        (_flat_face(size, side) if not bent else _bent_face(strip, size, side)) for side in (-1, 1)
    )
    segments: list[Segment] = []
    places, directions = _frames(strip, bent)
    (start, end), (back, ahead) = places, (-directions[0] * first, directions[1] * last)
    across = [np.array([-d[1], d[0]]) for d in directions]
    low_start, high_start = start - ends[0] * across[0], start + ends[0] * across[0]
    low_end, high_end = end - ends[1] * across[1], end + ends[1] * across[1]
    segments += lines_through([high_start, high_start + back, low_start + back, low_start])
    segments.append(Spline(right))
    segments += lines_through([low_end, low_end + ahead, high_end + ahead, high_end])
    segments.append(Spline(left).reversed())
    return Path(tuple(segments), closed=True)


def _frames(strip: Strip, bent: bool) -> tuple[FloatArray, FloatArray]:
    """Positions and directions (2, 2) of the two ends of the free part."""
    if not bent:
        return np.array([[0.0, 0.0], [strip.rod.length, 0.0]]), np.array([[1.0, 0.0], [1.0, 0.0]])
    nodes = strip.rod.curve.at(np.array([0.0, strip.rod.curve.length]))
    return nodes.position, np.column_stack([np.cos(nodes.angle), np.sin(nodes.angle)])


def _flat_face(size: Profile, side: int) -> PlaneCurve:
    """One face of the flat strip: half the thickness is exactly a spline over its Greville abscissae."""
    points = np.column_stack([size.greville, side * size.coefficients / 2])
    return PlaneCurve(size.knots, points, size.degree)


def _bent_face(strip: Strip, size: Profile, side: int) -> PlaneCurve:
    """The curve half a thickness off the strip's own."""
    curve, length = strip.rod.curve, strip.rod.length
    tight = np.abs(strip.rod.curvature) * size(strip.rod.s) / 2
    if tight.max() >= 1:
        at = float(strip.rod.s[int(tight.argmax())])
        raise InputError(
            f"at {at:.4g} mm the strip bends to a radius below half its thickness: draw a gentler curve, or allow "
            "less thickness"
        )

    def face(s: FloatArray) -> FloatArray:
        nodes = curve.at(np.clip(s, 0.0, curve.length))
        normal = np.column_stack([-np.sin(nodes.angle), np.cos(nodes.angle)])
        return np.asarray(nodes.position + side * size(s)[:, None] / 2 * normal)

    breaks = [*size.breaks, *((place.s, max(place.continuity - 1, 0)) for place in curve.breaks)]
    knots, points = adaptive_spline(face, (0.0, length), degree=5, tolerance=FACE_MM, breaks=breaks)
    return PlaneCurve(knots, points, 5)
