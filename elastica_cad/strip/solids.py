"""Solids that a CAD kernel can build: flat parts, bent strips, and blocks made of prisms."""

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from itertools import product
from typing import TypeAlias

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import FloatArray
from elastica_cad._values import numbers, require_positive, require_record, several
from elastica_cad.errors import InputError
from elastica_cad.geometry.frame import Frame, frame_or_plain
from elastica_cad.geometry.path import Path, Spline
from elastica_cad.geometry.path_intersections import clip_across
from elastica_cad.geometry.plane_points import cross
from elastica_cad.geometry.splines import SplineFunction, knot_runs
from elastica_cad.mechanics.cross_sections import RoundLaw
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.sheets import Sheet, sheet_color
from elastica_cad.strip.bent_boundary import BentMap, Boundary, BoundaryMaker, Map, bent_maps
from elastica_cad.strip.flat_pattern import SIDE_DEGREE, CutPattern, cut_across, in_smooth_pieces
from elastica_cad.strip.outline import Tab, close_chain, fix_tab_widths
from elastica_cad.strip.strip import Strip
from elastica_cad.strip.tapered_solids import RoundSolid, places_of_ends, side_view


def centred_thickness(strip: Strip) -> float:
    """Return the thickness that is centred on the curve, mm.

    In a stack of plies, only the ply of full length is centred. In other strips, the sum of all layers is centred.
    """
    return strip.layers[-1 if strip.layout.stack is None else 0].high


def _joint_places(strip: Strip) -> dict[str, tuple[float, float, int]]:
    """Return (x, y, sign) of every joint in the flat strip, with x and y in mm.

    The sign is 1 if the x axis of the joint is along the strip, else -1.
    """
    places = {"start": (0.0, 0.0, -1), "end": (strip.rod.length, 0.0, 1)}
    for number, hole in enumerate(strip.holes, start=1):
        x, y = map(float, hole.bounds.mean(axis=0))
        places[f"hole{number}"] = (x, y, 1)
    return places


def _with_faces(joints: Mapping[str, Frame], thickness: float) -> dict[str, Frame]:
    """Return the joints, and for every hole two more joints, on the "top" and "bottom" face of the strip."""
    frames = dict(joints)
    for name, frame in joints.items():
        if name.startswith("hole"):
            frames[f"{name}:top"] = frame.shifted(z=thickness / 2)
            below = frame.shifted(z=-thickness / 2)
            frames[f"{name}:bottom"] = Frame(below.origin, below.x_axis, -below.y_axis)
    return frames


def turned(frame: Frame, sign: int) -> Frame:
    """Return the frame, turned by 180 degrees about its z axis if `sign` is -1."""
    return frame if sign == 1 else Frame(frame.origin, -frame.x_axis, -frame.y_axis)


GLUE_MM = 5e-4
"""Gap between the sheets of a body, mm. CAD kernels lose parts of solids that touch, and fail if the gap is
1e-4 mm."""


@dataclass(frozen=True, eq=False)
class FlatSolid:
    """A plate: a closed outline with holes in the xy plane of a frame, extruded along its z axis.

    Parameters
    ----------
    outline : Path
        Closed outline, mm.
    holes : tuple of Path
        Closed loops inside the outline.
    thickness : float
        Thickness, mm, from z = 0 to z = thickness of the frame.
    frame : Frame
        Plane of the drawing in space.
    joints : mapping of str to Frame
        Frames at which other parts are joined, by name.

    Examples
    --------
    >>> plate = FlatSolid(Path.rectangle(30, 20), (), 2.0)
    >>> plate.volume
    1200.0
    """

    outline: Path
    holes: tuple[Path, ...] = ()
    thickness: float = 1.0
    frame: Frame = field(default_factory=Frame)
    joints: Mapping[str, Frame] = field(default_factory=dict)

    def __post_init__(self) -> None:
        require_positive(self.thickness, "plate thickness")
        require_record(self.outline, Path, "the outline of a plate", "a Path")
        if not all(path.closed for path in (self.outline, *several("holes", self.holes, Path, "Path"))):
            raise InputError(
                "a path of the plate is open, but outline and holes must be closed: close the path"
            )

    @classmethod
    def of(cls, strip: Strip, frame: Frame | None = None) -> "FlatSolid | RoundSolid":
        """Return the flat strip, or the base of a laminate.

        In its frame, x = 0 is the start of the bent part, and z = 0 is the lower face. Joints have the same
        names as in `BentSolid`.
        """
        return cls.layers(strip, frame)[0]

    @classmethod
    def layers(cls, strip: Strip, frame: Frame | None = None) -> tuple["FlatSolid | RoundSolid", ...]:
        """Return every sheet of the flat strip, stacked as glued. Only the base has joints."""
        require_record(strip, Strip, "what lies flat", "a Strip")
        frame = frame_or_plain(frame)
        if strip.layout.worked_size is not None:
            return (_tapered_solid(strip, frame, bent=False),)
        thick = centred_thickness(strip)
        middle = frame.shifted(z=thick / 2)
        places = _joint_places(strip).items()
        on_middle = {name: turned(middle.shifted(x, y), sign) for name, (x, y, sign) in places}
        joints = _with_faces(on_middle, thick)
        return tuple(
            cls(
                in_smooth_pieces(layer.outline),
                tuple(in_smooth_pieces(hole, 1) for hole in layer.holes),
                layer.sheet.thickness,
                frame.shifted(z=layer.low),
                {} if layer.name else joints,
            )
            for layer in strip.layers
        )

    @property
    def area(self) -> float:
        """Area of the plate, mm2."""
        return abs(self.outline.area) - sum(abs(hole.area) for hole in self.holes)

    @property
    def volume(self) -> float:
        """Volume of the plate, mm3."""
        return self.area * self.thickness

    @property
    def is_prism(self) -> bool:
        """True if the plate can be extruded. With many spans in a spline, CAD kernels compute wrong areas.

        The result is False for smoothed sides, because the number of their spans changes with the curve.
        """
        segments = (segment for loop in (self.outline, *self.holes) for segment in loop.segments)
        splines = [
            spline for spline in segments if isinstance(spline, Spline) and not spline.curve.is_rational
        ]
        if any(spline.curve.degree == SIDE_DEGREE for spline in splines):
            return False
        # CAD kernels compute right areas along splines of at most eight spans
        many = [spline for spline in splines if knot_runs(spline.curve.knots)[0].size > 9]
        return not many or _misread_area(many) <= 1e-4 * self.area

    @cached_property
    def boundary(self) -> Boundary:
        """Closed boundary of planes, cylinders, and a ruled B-spline face along each spline."""
        pattern = cut_across(self.outline, self.holes, ())
        return BoundaryMaker(pattern.points, (self.frame,), (0.0, self.thickness)).boundary(pattern.regions)


def _misread_area(sides: Sequence[Spline]) -> float:
    """Return the error of the areas below splines, mm2, if one quadrature rule is used for all spans."""
    # OpenCASCADE uses this rule along an extruded spline, for any number of spans
    points, weights = np.polynomial.legendre.leggauss(16)
    off = 0.0
    for side in sides:
        curve, (first, last) = side.curve, side.curve.domain
        rows = SplineFunction(curve.knots, curve.control_points, curve.degree)
        half = (last - first) / 2
        t = first + half * (points + 1)
        # area that the line from the start to a point of the side sweeps
        swept = cross(rows(t) - side.start, rows(t, 1)) @ weights * half / 2
        off += abs(float(swept) - side.swept_area(side.start))
    return off


def _tapered_solid(strip: Strip, frame: Frame, *, bent: bool) -> "FlatSolid | RoundSolid":
    """Return the solid of a round rod, or the extruded side view of a strip of varying thickness."""
    section, size, width = strip.layout.section, strip.layout.size, strip.layout.width
    assert size is not None
    view = side_view(strip, bent=bent)
    # plane of the side view, and direction across the strip at the joints
    upright, across = frame, frame.z_axis
    if not bent:
        # the width of a flat strip is along y of `frame`, and its lowest point is at z = 0
        lowest = float(view.bounds[0, 1])
        upright, across = Frame(frame.shifted(z=-lowest).origin, frame.x_axis, frame.z_axis), frame.y_axis
    ends = zip(("start", "end"), *places_of_ends(strip, bent=bent), (-1, 1), strict=True)
    joints = {
        name: turned(Frame(upright.point(place), upright.direction(direction), across), sign)
        for name, place, direction, sign in ends
    }
    if isinstance(section, RoundLaw):
        return RoundSolid(strip, upright, bent, section.bore, joints)
    wide = width.extremes[1]
    return FlatSolid(view, (), wide, upright.shifted(z=-wide / 2), joints)


@dataclass(frozen=True, eq=False)
class BentSolid:
    """A strip bent into the curve of its rod.

    The x axis of the flat pattern is along the curve, and its y axis is the z axis of `frame`. The upper face of
    the flat pattern is on the right of the curve. Tabs continue straight along the end tangents.

    Attributes
    ----------
    pattern : CutPattern
        Flat pattern, divided where tabs begin and where the curvature jumps.
    maps : tuple
        Map of each interval of the pattern into space: a `BentMap`, or the plane of a tab as a `Frame`.
    heights : (lower, upper)
        Heights of the two faces, mm, positive to the right of the curve.
    frame : Frame
        Plane in which the curve is drawn.
    places : mapping of str to (x, y, way)
        Positions of the joints in the flat pattern, mm. `way` is 1 if the x axis of the joint is along the strip,
        else -1.
    between : float
        Thickness of the strip, mm, if holes have joints on both faces, else 0.
    """

    pattern: CutPattern
    maps: tuple[Map, ...]
    heights: tuple[float, float]
    frame: Frame
    places: Mapping[str, tuple[float, float, int]]
    between: float = 0.0

    @cached_property
    def joints(self) -> Mapping[str, Frame]:
        """Frames at which other parts are joined, by name, with the origin at mid-thickness.

        The names are "start" and "end" (of the bent part), "hole1", "hole2" and so on. The z axis is normal
        to the upper face. The x axis is along the strip; at the ends it points outward. "hole1:top" and
        "hole1:bottom" are on the faces of the strip, with z outward.
        """
        # ends of the intervals; a joint at an end belongs to the interval before it
        stations = [0.0, *(float(part.knots[-1]) for part in self.maps if isinstance(part, BentMap))]
        frames = {}
        for name, (x, y, sign) in self.places.items():
            shape = self.maps[np.searchsorted(stations, x)]
            tangent = shape.frame_at(x) if isinstance(shape, BentMap) else shape
            frames[name] = turned(tangent.shifted(x, y), sign)
        return _with_faces(frames, self.between) if self.between else frames

    @cached_property
    def boundary(self) -> Boundary:
        """Closed boundary: B-spline faces on the bent part, planes and cylinders on the tabs."""
        return BoundaryMaker(self.pattern.points, self.maps, self.heights).boundary(self.pattern.regions)

    @cached_property
    def middle(self) -> Boundary:
        """Open surface at mid-thickness; its area is the area of the flat strip."""
        half_way = (self.heights[0] + self.heights[1]) / 2
        return BoundaryMaker(self.pattern.points, self.maps, (half_way,)).boundary(self.pattern.regions)

    @classmethod
    def of(cls, strip: Strip, frame: Frame | None = None) -> "BentSolid":
        """Return the bent strip, or the bent base of a laminate. The curve is in the xy plane of `frame`.

        Raises
        ------
        NotConvergedError
            The curve could not be approximated to 1e-6 mm.
        """
        require_record(strip, Strip, "what is bent", "a Strip")
        return next(cls._layers(strip, frame))

    @classmethod
    def layers(cls, strip: Strip, frame: Frame | None = None) -> tuple["BodyRecord", ...]:
        """Return every sheet of the bent strip.

        The total thickness of the sheets is centred on the curve. Only the base has joints.

        In a stack of glued plies, the full-length ply is centred on the curve, and the other plies are on its
        upper face. The lap of a closed strip is a separate body on the inside, where it is glued. For errors,
        see `of`.
        """
        require_record(strip, Strip, "what is bent", "a Strip")
        frame = frame_or_plain(frame)
        if strip.layout.worked_size is not None:
            return (_tapered_solid(strip, frame, bent=True),)
        return tuple(cls._layers(strip, frame))

    @classmethod
    def _layers(cls, strip: Strip, frame: Frame | None) -> Iterator["BentSolid"]:
        """Yield the layers of a bent strip. Only the first has the joints."""
        if strip.is_closed:
            yield from cls._ring_and_lap(strip, frame)
            return
        joints: Mapping[str, tuple[float, float, int]] = _joint_places(strip)
        thick = centred_thickness(strip)
        for layer in strip.layers:
            yield cls.wrapped(
                strip.rod,
                layer.outline,
                layer.holes,
                heights=(layer.low - thick / 2, layer.high - thick / 2),
                frame=frame,
                joints=joints,
                between=thick,
            )
            joints = {}

    @classmethod
    def _ring_and_lap(cls, strip: Strip, frame: Frame | None) -> Iterator["BentSolid"]:
        """Yield the ring of a closed strip, cut open by 0.01 mm, and the lap on its inner side."""
        thickness, rod = strip.sheet.thickness, strip.rod
        bare = replace(strip, ends=(Tab(0.0), Tab(0.0)))
        # CAD kernels need a gap between the ends, far larger than their tolerance
        outline = clip_across(bare.outline, 0.0, rod.length - 0.01)
        yield cls.wrapped(
            rod, outline, bare.holes, heights=(-thickness / 2, thickness / 2), frame=frame,
            joints=_joint_places(bare), between=thickness,
        )  # fmt: skip
        if strip.ends[1].length:
            width, tab = strip.end_widths[1], fix_tab_widths(strip.width, strip.ends)[1]
            # heights are positive to the right, and the inside of a left bend is on the left
            inside = -1.0 if rod.curvature[0] > 0 else 1.0
            low, high = sorted((inside * thickness / 2, inside * 1.5 * thickness))
            lap = Path(close_chain(tab.corners(width)), closed=True)
            yield cls.wrapped(rod, lap, tab.hole_paths(width), heights=(low, high), frame=frame)

    @classmethod
    def wrapped(
        cls,
        rod: Rod,
        outline: Path,
        holes: Sequence[Path] = (),
        *,
        heights: tuple[float, float],
        frame: Frame | None = None,
        joints: Mapping[str, tuple[float, float, int]] | None = None,
        between: float = 0.0,
    ) -> "BentSolid":
        """Return a flat pattern bent along the curve of a rod.

        Parameters
        ----------
        rod : Rod
            Rod with the curve. The x axis of the pattern is mapped to the curve, with x as arc length. Beyond the
            ends of the rod the pattern is plane.
        outline, holes : Path
            Closed loops, mm.
        heights : (lower, upper)
            Heights of the two faces, mm, positive to the right of the curve.
        frame : Frame, optional
            Plane of the curve.
        joints : mapping of str to (x, y, way), optional
            Positions of the joints in the flat pattern, mm. `way` is 1 if the x axis of the joint is along the
            strip, else -1.
        between : float
            Thickness of the strip, mm, if every hole gets joints on both faces, else 0.

        Raises
        ------
        InputError, NotConvergedError
            See `BentSolid.of`.
        """
        frame = frame_or_plain(frame)
        require_record(rod, Rod, "what a pattern is wrapped on", "a Rod")
        both = numbers(heights, "heights of a wrapped pattern")
        if both.shape != (2,):
            raise InputError(f"`heights` are {heights!r}: give the lower and the upper height, mm")
        lower, upper = both.tolist()
        bent = bent_maps(rod, frame, max(abs(lower), abs(upper)))
        stations = [0.0, *(float(part.knots[-1]) for part in bent[:-1]), rod.length]
        require_record(outline, Path, "the outline of a pattern", "a Path")
        smooth_holes = [in_smooth_pieces(hole, 1) for hole in several("holes", holes, Path, "Path")]
        pattern = cut_across(in_smooth_pieces(outline), smooth_holes, stations)
        maps: tuple[Map, ...] = (bent[0].frame_at(0.0), *bent, bent[-1].frame_at(rod.length))
        solid = cls(pattern, maps, (lower, upper), frame, {} if joints is None else joints, between)
        if not solid.boundary.is_closed:
            raise InputError(
                "holes, slots or edges of the flat part touch, so the bent strip is not a solid. Move the holes "
                "and slots apart"
            )
        return solid


def glued(records: Sequence["BodyRecord | PrismSolid"]) -> "tuple[BodyRecord | PrismSolid, ...]":
    """Return the sheets of a strip for a single body, with gaps of `GLUE_MM` between the sheets.

    OpenCASCADE needs solids that share faces or do not touch. Shared faces are unreliable where base and
    backing are equally wide.
    """
    return tuple(_moved_apart(record, number * GLUE_MM) for number, record in enumerate(records))


def _moved_apart(record: "BodyRecord | PrismSolid", gap: float) -> "BodyRecord | PrismSolid":
    """Return a sheet moved by `gap` mm away from the curve; a flat sheet is moved along z."""
    if not gap or isinstance(record, PrismSolid):
        return record
    if isinstance(record, BentSolid):
        low, high = record.heights
        away = float(np.copysign(gap, low + high))
        return replace(record, heights=(low + away, high + away))
    return replace(record, frame=record.frame.shifted(z=gap))


def bent_sheets(strip: Strip) -> tuple[Sheet, ...]:
    """Return the sheet of each body of `BentSolid.layers`."""
    lap = (strip.sheet,) if strip.is_closed and strip.ends[1].length else ()
    return (*(layer.sheet for layer in strip.layers), *lap)


def bent_colors(strip: Strip, color: tuple[float, ...] | None) -> tuple[tuple[float, ...], ...]:
    """Return the screen colour of each body of `BentSolid.layers`. The base sheet has the colour `color`."""
    base = strip.layers[0].sheet
    return tuple(
        color if color is not None and sheet is base else sheet_color(sheet) for sheet in bent_sheets(strip)
    )


BodyRecord: TypeAlias = FlatSolid | BentSolid | RoundSolid
"""A body of a strip: an extruded plate or side view, a bent sheet, or a round rod."""


def frame_beside(strip: Strip, frame: Frame) -> Frame:
    """Return a frame in the plane z = 0 for the flat strip, at smaller y than the strip bent in `frame`."""
    outline = strip.outline.bounds
    reach = max(tab.length for tab in strip.ends) + sum(layer.sheet.thickness for layer in strip.layers)
    low, high = strip.rod.position.min(axis=0) - reach, strip.rod.position.max(axis=0) + reach
    corners = product((low[0], high[0]), (low[1], high[1]), outline[:, 1])
    lowest = float(frame.point(np.array(list(corners)))[:, 1].min())
    # flat and bent strip are 20 mm apart
    return Frame((0.0, lowest - 20.0 - float(outline[1, 1]), 0.0))


@dataclass(frozen=True, eq=False)
class PrismSolid:
    """The union of the prisms `added`, without the prisms `removed`.

    Attributes
    ----------
    added, removed : tuple of FlatSolid
        Prisms, each in its own frame.
    joints : mapping of str to Frame
        Frames at which other parts are joined, by name.
    """

    added: tuple[FlatSolid, ...]
    removed: tuple[FlatSolid, ...] = ()
    joints: Mapping[str, Frame] = field(default_factory=dict)

    def __post_init__(self) -> None:
        for name in ("added", "removed"):
            prisms = several(f"the {name} prisms", getattr(self, name), FlatSolid, "FlatSolid")
            object.__setattr__(self, name, prisms)
        if not self.added:
            raise InputError("the list `added` of prisms is empty: give at least one prism")


def convex_corners(points: FloatArray) -> FloatArray:
    """Return the corners (n, 2) of the convex hull of points (m, 2), anticlockwise from the leftmost corner.

    Examples
    --------
    >>> convex_corners(np.array([[0.0, 0.0], [1.0, 0.5], [2.0, 0.0], [1.0, 0.0], [1.0, 2.0]])).tolist()
    [[0.0, 0.0], [2.0, 0.0], [1.0, 2.0]]
    """
    in_order = np.asarray(points, dtype=float)[np.lexsort(np.transpose(points)[::-1])]
    # twice the area of the triangle of three points that count as collinear
    least = 1e-14 * float(np.ptp(in_order, axis=0).max()) ** 2
    corners: list[list[float]] = []
    # the lower chain from left to right, then the upper chain back; each ends where the next begins
    for row in (in_order.tolist(), in_order[::-1].tolist()):
        corners = corners[:-1]
        first = len(corners)
        for x, y in row:
            while len(corners) > first + 1:
                (x0, y0), (x1, y1) = corners[-2:]
                if (x1 - x0) * (y - y1) - (y1 - y0) * (x - x1) > least:
                    break
                corners.pop()
            corners.append([x, y])
    return np.array(corners[:-1])
