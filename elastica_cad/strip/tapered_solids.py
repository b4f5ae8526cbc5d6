"""Solids of strips of varying thickness (extruded side views), and of round rods and tubes."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import FloatArray
from elastica_cad.errors import InputError, Length
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.path import Path, Segment, Spline
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.geometry.plane_points import left_of, unit_vectors
from elastica_cad.geometry.profile import Profile
from elastica_cad.geometry.splines import adaptive_spline
from elastica_cad.strip.bent_boundary import (
    Boundary,
    Edge,
    EdgeUse,
    Face,
    PlaneSurface,
    SpaceCurve,
    SpaceSurface,
    StraightTrace,
)
from elastica_cad.strip.outline import graph, lines_through
from elastica_cad.strip.strip import Strip

FACE_MM = 1e-4
"""Largest error, mm, of the two faces, which are half the thickness from the curve."""


def side_view(strip: Strip, *, bent: bool = False) -> Path:
    """Return the side view of a strip of varying thickness, anticlockwise, with straight tabs.

    For a flat strip, x is the arc length from the start of the bent part, and y = 0 is mid-thickness. For a bent
    strip, the view follows the curve of the strip.

    Examples
    --------
    >>> from elastica_cad.strip.strip_spec import make_strip
    >>> from elastica_cad.mechanics.sheets import Sheet
    >>> from elastica_cad.mechanics.cross_sections import ThicknessLaw
    >>> glass = Sheet("glass", 3.0, 38000.0, density=1900.0, max_strain=0.02)
    >>> arch = PlaneCurve.spline([(0, 0), (60, 120), (140, 160), (240, 120), (300, 0)])
    >>> strip = make_strip(arch, glass, section=ThicknessLaw(glass, 1.0, 4.0, width=20.0))
    >>> round(float(np.ptp(side_view(strip).bounds[:, 1])), 3)
    4.0
    """
    size = strip.layout.size
    if size is None:
        raise InputError(
            "this strip has a constant thickness, so it has no side view: use a strip with a section "
            "such as ThicknessLaw"
        )
    right, left = (
        Spline(_bent_face(strip, size, side))
        if bent
        else graph(size.knots, side * size.coefficients / 2, size.degree)
        for side in (-1, 1)
    )
    places, directions = places_of_ends(strip, bent=bent)
    half = size([0.0, strip.rod.length])[:, None] / 2 * left_of(directions)
    (low_start, low_end), (high_start, high_end) = places - half, places + half
    back, ahead = -strip.ends[0].length * directions[0], strip.ends[1].length * directions[1]
    segments: list[Segment] = [
        *lines_through([high_start, high_start + back, low_start + back, low_start]),
        right,
        *lines_through([low_end, low_end + ahead, high_end + ahead, high_end]),
        left.reversed(),
    ]
    return Path(segments, closed=True)


def places_of_ends(strip: Strip, *, bent: bool) -> tuple[FloatArray, FloatArray]:
    """Return start and end (2, 2), mm, of the bent part in a `side_view`, and the directions (2, 2) there."""
    if not bent:
        return np.array([[0.0, 0.0], [strip.rod.length, 0.0]]), np.array([[1.0, 0.0], [1.0, 0.0]])
    nodes = strip.rod.curve.at(np.array([0.0, strip.rod.curve.length]))
    return nodes.position, unit_vectors(nodes.angle)


def _bent_face(strip: Strip, size: Profile, side: int) -> PlaneCurve:
    """Return the upper (`side` 1) or lower (-1) face of a bent strip in its side view.

    It is half the thickness (`size`) from the curve.
    """
    curve, length = strip.rod.curve, strip.rod.length
    tight = np.abs(strip.rod.curvature) * size(strip.rod.s) / 2
    if tight.max() >= 1:
        raise InputError(
            "{at:.4g} from its start the strip bends to a radius below half its thickness: draw a gentler "
            "curve, or allow less thickness",
            at=Length(strip.rod.s[tight.argmax()]),
        )

    def face(s: FloatArray) -> FloatArray:
        nodes = curve.at(s.clip(0.0, curve.length))
        return nodes.position + side * size(s)[:, None] / 2 * left_of(unit_vectors(nodes.angle))

    # the normal has one continuous derivative less than the curve
    breaks = [*size.breaks, *((place.s, max(place.continuity - 1, 0)) for place in curve.breaks)]
    knots, points = adaptive_spline(face, (0.0, length), degree=5, tolerance=FACE_MM, breaks=breaks)
    return PlaneCurve(knots, points, 5)


HALF_TURN_SPANS = 8
"""Number of spans of the spline of degree 5 that approximates half a circle. The error is 1e-8 of the radius."""

DEGREE = 5


@dataclass(frozen=True, eq=False)
class RoundSolid:
    """A round rod or tube of varying diameter along the curve of a strip or along x, with straight tabs.

    Attributes
    ----------
    strip : Strip
        Strip whose section is a `RoundLaw`.
    frame : Frame
        Plane of the curve. The axis of a straight rod is the x axis.
    bent : bool
        True for a rod along the curve of the strip, False for a straight rod.
    bore : float
        Inner diameter divided by outer diameter; 0 for a solid rod.
    joints : mapping of str to Frame
        Frames at which other parts are joined, by name.
    """

    strip: Strip
    frame: Frame
    bent: bool
    bore: float
    joints: Mapping[str, Frame] = field(default_factory=dict)

    @cached_property
    def boundary(self) -> Boundary:
        """Closed boundary: half surfaces of the bent part, the tabs and a bore, and the two end faces."""
        first, last = (tab.length for tab in self.strip.ends)
        length = self.strip.rod.length
        stations = sorted({0.0, length, -first, length + last})
        pieces = [self._axis_spline(a, b) for a, b in pairwise(stations)]
        shares = (1.0, self.bore) if self.bore else (1.0,)
        skins = _RoundBoundary()
        rings = [skins.skin(pieces, share, self.frame, outward=share == 1.0) for share in shares]
        for end, station in ((0, stations[0]), (-1, stations[-1])):
            axis, normal, _ = self._at(np.array([station]))
            cross = Frame(self.frame.point(axis[0]), self.frame.direction(normal[0]), self.frame.z_axis)
            skins.cap([ring[end] for ring in rings], cross, at_start=end == 0)
        return Boundary(np.array(skins.vertices), tuple(skins.edges), tuple(skins.faces))

    def _at(self, s: FloatArray) -> tuple[FloatArray, FloatArray, FloatArray]:
        """Return axis points (n, 2), unit normals (n, 2) and radii (n,) at arc lengths s (n,), mm.

        Tabs, at s < 0 and beyond the length, are straight cylinders.
        """
        length, size = self.strip.rod.length, self.strip.layout.size
        assert size is not None
        within = s.clip(0.0, length)
        if self.bent:
            curve = self.strip.rod.curve
            nodes = curve.at(within / length * curve.length)
            position, angle = nodes.position, nodes.angle
        else:
            position, angle = np.column_stack([within, 0.0 * within]), 0.0 * within
        tangent = unit_vectors(angle)
        return position + (s - within)[:, None] * tangent, left_of(tangent), size(within) / 2

    def _axis_spline(self, start: float, end: float) -> tuple[FloatArray, FloatArray]:
        """Return knots and coefficients (m, 5) of a spline: axis point (2), unit normal * radius (2), and
        radius."""
        size, curve, length = self.strip.layout.size, self.strip.rod.curve, self.strip.rod.length
        breaks = [] if size is None else list(size.breaks)
        if self.bent:
            breaks += [
                (place.s / curve.length * length, max(place.continuity - 1, 0)) for place in curve.breaks
            ]

        def spine(s: FloatArray) -> FloatArray:
            axis, normal, radius = self._at(s)
            return np.column_stack([axis, radius[:, None] * normal, radius])

        inner = [(s, continuity) for s, continuity in breaks if start < s < end]
        return adaptive_spline(spine, (start, end), degree=DEGREE, tolerance=FACE_MM, breaks=inner)


class _RoundBoundary:
    """Boundary of a round rod or tube while its faces are added."""

    def __init__(self) -> None:
        self.vertices: list[FloatArray] = []
        self.edges: list[Edge] = []
        self.faces: list[Face] = []

    def skin(
        self, pieces: list[tuple[FloatArray, FloatArray]], share: float, frame: Frame, *, outward: bool
    ) -> list[list[int]]:
        """Add the surface of the rod (`share` 1) or of its bore (`share` is inner / outer diameter).

        Return the indices of two half circles for each end of a piece.
        """
        around, cosines, sines = _half_turn()
        z = frame.z_axis

        def control_net(rows: FloatArray, sign: float) -> FloatArray:
            """Return the control points (n, m, 3) of a half surface: n around the axis and m along the axis."""
            axis, across = frame.point(rows[:, :2]), share * frame.direction(rows[:, 2:4])
            up = share * rows[:, 4, None] * z
            return axis + sign * (cosines[:, None, None] * across + sines[:, None, None] * up)

        # at each end of a piece, two half circles (`rings`) meet at two vertices (the first is in `corners`)
        ends = [pieces[0][1][0], *(rows[-1] for _, rows in pieces)]
        rings, corners = [], []
        for row in ends:
            nets = [control_net(row[None], sign)[:, 0] for sign in (1.0, -1.0)]
            first = len(self.vertices)
            self.vertices += [nets[0][0], nets[0][-1]]
            rings.append(
                [self._edge(around, points, first + k, first + 1 - k) for k, points in enumerate(nets)]
            )
            corners.append(first)
        for i, (knots, rows) in enumerate(pieces):
            nets = [control_net(rows, sign) for sign in (1.0, -1.0)]
            seams = [
                self._edge(knots, points[0], corners[i] + k, corners[i + 1] + k)
                for k, points in enumerate(nets)
            ]
            span = float(knots[0]), float(knots[-1])
            for k, points in enumerate(nets):
                loop = (
                    EdgeUse(rings[i][k], True, StraightTrace((0.0, span[0]), (1.0, 0.0))),
                    EdgeUse(seams[1 - k], True, StraightTrace((1.0, 0.0), (0.0, 1.0))),
                    EdgeUse(rings[i + 1][k], False, StraightTrace((0.0, span[1]), (1.0, 0.0))),
                    EdgeUse(seams[k], False, StraightTrace((0.0, 0.0), (0.0, 1.0))),
                )
                surface = SpaceSurface((around, knots), points, (DEGREE, DEGREE))
                self.faces.append(Face(surface, (loop,), outward))
        return rings

    def cap(self, rings: list[list[int]], cross: Frame, *, at_start: bool) -> None:
        """Add the plane face at one end, between its outer ring and, for a tube, its inner ring."""
        # the normal points out of the rod; seen from outside, the outer ring is anticlockwise, the inner clockwise
        frame = Frame(cross.origin, cross.y_axis, cross.x_axis) if at_start else cross
        loops = []
        for i, ring in enumerate(rings):
            forward = at_start == bool(i)
            loops.append(tuple(EdgeUse(edge, forward) for edge in (ring if forward else ring[::-1])))
        self.faces.append(Face(PlaneSurface(frame), tuple(loops)))

    def _edge(self, knots: FloatArray, points: FloatArray, start: int, end: int) -> int:
        # add an edge between two vertices, and return its index
        self.edges.append(
            Edge(SpaceCurve(knots, points, DEGREE), float(knots[0]), float(knots[-1]), start, end)
        )
        return len(self.edges) - 1


def _half_turn() -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return knots over 0..1 and coefficients of splines that approximate cosine and sine over half a turn."""
    from scipy.interpolate import make_lsq_spline

    knots = np.pad(np.linspace(0.0, 1.0, HALF_TURN_SPANS + 1), DEGREE, mode="edge")
    u = np.linspace(0.0, 1.0, 40 * HALF_TURN_SPANS + 1)
    weights = np.ones(u.size)
    weights[[0, -1]] = 1e6  # large weights, because both halves of the cross section must meet exactly
    cosines, sines = make_lsq_spline(u, unit_vectors(np.pi * u), knots, DEGREE, w=weights).c.T.copy()
    cosines[[0, -1]], sines[[0, -1]] = (1.0, -1.0), 0.0
    return knots, cosines, sines
