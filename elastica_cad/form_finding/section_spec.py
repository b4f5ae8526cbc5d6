"""Requests for sections of a surface: families of planes, splitting of lines, and fitted curves."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Annotated, ClassVar, TypeAlias

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray, Triple
from elastica_cad._values import as_floats, is_whole, require_flag
from elastica_cad.declared import TWO_TURNS_RAD, Option
from elastica_cad.errors import Angle, InputError, Length, Point, Refusal, note, quoted, sentences
from elastica_cad.form_finding.plane_sections import FARTHEST_MM
from elastica_cad.form_finding.section_lines import PlaneSection, SectionCurve, SectionLine, section_curves
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.plane_points import lengths_along, points_at

MOST_PLANES = 1000


def parallel_planes(
    point: ArrayLike, normal: ArrayLike, offsets: ArrayLike, *, up: ArrayLike = (0.0, 0.0, 1.0)
) -> tuple[Frame, ...]:
    """Return planes perpendicular to `normal` (3,), at the distances `offsets` (k,), mm, from `point` (3,).

    The y axis of each plane points as nearly along `up` as possible.

    Examples
    --------
    >>> [frame.origin.tolist() for frame in parallel_planes((0, 0, 0), (0, 1, 0), (0, 5))]
    [[0.0, 0.0, 0.0], [0.0, 5.0, 0.0]]
    """
    p, n = _vector("point", point), _direction("normal", normal)
    return tuple(_across(p + offset * n, n, up) for offset in _row("offsets", offsets))


def radial_planes(
    point: ArrayLike,
    axis: ArrayLike,
    angles: ArrayLike,
    *,
    zero: ArrayLike = (1.0, 0.0, 0.0),
) -> tuple[Frame, ...]:
    """Return half planes that end at an axis. In each frame, x points away from the axis, and y is along the axis.

    Parameters
    ----------
    point, axis : (3,) array_like
        A point on the axis, mm, and the direction of the axis.
    angles : (k,) array_like
        Angles of the half planes about the axis, measured from `zero`, rad.
    zero : (3,) array_like
        Direction of the angle 0. Only its component normal to the axis has an effect.

    Examples
    --------
    >>> radial_planes((0, 0, 0), (0, 0, 1), [np.pi / 2])[0].x_axis.round(12).tolist()
    [0.0, 1.0, 0.0]
    """
    p, a = _vector("point", point), _direction("axis", axis)
    x = _normal_direction("zero", zero, a)
    y = np.cross(a, x)
    return tuple(Frame(p, np.cos(t) * x + np.sin(t) * y, a) for t in _row("angles", angles))


def planes_along(
    path: ArrayLike, count: int, *, ends: bool = False, up: ArrayLike = (0.0, 0.0, 1.0)
) -> tuple[Frame, ...]:
    """Return evenly spaced planes normal to a path in space.

    Parameters
    ----------
    path : (n, 3) array_like
        Points of the path, mm. A smooth path needs many points.
    count : int
        Number of planes. The first and the last plane are half a spacing from the ends, or at the ends with
        `ends=True`.
    up : (3,) array_like
        The y axis of each plane is as near to this direction as possible.

    Examples
    --------
    >>> [float(frame.origin[0]) for frame in planes_along([(0, 0, 0), (9, 0, 0)], 3)]
    [1.5, 4.5, 7.5]
    """
    points = _numbers("path", path)
    if points.ndim != 2 or points.shape[1] != 3:
        raise InputError(f"the path has the shape {points.shape}: give points (n, 3), in mm")
    if not is_whole(count) or not 1 <= count <= MOST_PLANES or (require_flag(ends, "ends") and count < 2):
        raise InputError(
            f"count is {quoted(count)}: give a whole number of planes from 1 (with ends=True from 2) to "
            f"{MOST_PLANES}"
        )
    points = points[np.append(True, (np.diff(points, axis=0) != 0).any(axis=1))]
    if len(points) < 2:
        raise InputError("all points of the path are equal: give two different points or more")
    s = lengths_along(points)
    at = np.linspace(0.0, s[-1], count) if ends else s[-1] * (np.arange(count) + 0.5) / count
    slopes = np.gradient(points, s, axis=0, edge_order=2 if len(points) > 2 else 1)
    places, ways = (points_at(at, s, rows) for rows in (points, slopes))
    return tuple(_across(p, _direction("path", w), up) for p, w in zip(places, ways, strict=True))


def _across(point: FloatArray, normal: FloatArray, up: ArrayLike) -> Frame:
    y = _normal_direction("up", up, normal)
    return Frame(point, np.cross(y, normal), y)


def _normal_direction(name: str, value: ArrayLike, along: FloatArray) -> FloatArray:
    """Return the unit vector of the part of a direction at right angles to the unit vector `along`."""
    v = _direction(name, value)
    part = v - (v @ along) * along
    size = float(np.linalg.norm(part))
    if size < 1e-9:
        raise InputError(f"{name}={v.tolist()} is at right angles to the plane: choose another direction")
    return part / size


def _direction(name: str, value: ArrayLike) -> FloatArray:
    v = _vector(name, value)
    size = float(np.linalg.norm(v))
    if size == 0:
        raise InputError(f"{name} is zero: give a direction of three numbers")
    return v / size


def _vector(name: str, value: ArrayLike) -> FloatArray:
    v = _numbers(name, value)
    if v.shape != (3,):
        raise InputError(f"{name} has the shape {np.shape(value)}: give three numbers")
    return v


def _row(name: str, value: ArrayLike) -> list[float]:
    v = np.atleast_1d(_numbers(name, value))
    if v.ndim != 1:
        raise InputError(f"{name} has the shape {v.shape}: give a number or a list of numbers")
    return [float(x) for x in v]


def _numbers(name: str, value: ArrayLike) -> FloatArray:
    v = as_floats(value)
    if v is None:
        raise InputError(f"{name} is {str(value)[:60]!r}: give numbers")
    if not np.isfinite(v).all():
        raise InputError(f"{name} is {v.tolist()}: give finite numbers")
    if np.abs(v).max(initial=0.0) > FARTHEST_MM:
        raise InputError(f"{name} contains {np.abs(v).max():.3g}: give numbers up to {FARTHEST_MM:g}")
    return v


NAMED_REASONS = 6
"""Largest number of reasons that a message lists."""


@dataclass(frozen=True, eq=False)
class Surface:
    """A surface that can be cut by planes.

    Attributes
    ----------
    points : (n, 3) array
        Points whose convex hull contains the surface, mm, such as the vertices of a mesh or the corners of a
        bounding box.
    cut : callable
        Function `cut(planes, half)` that returns the sections of the surface, with x >= 0 if `half` is True.
    """

    points: FloatArray
    cut: Callable[[Sequence[Frame], bool], tuple[PlaneSection, ...]]

    @property
    def middle(self) -> FloatArray:
        """Centre (3,) of the bounding box, mm."""
        return np.asarray((self.points.min(axis=0) + self.points.max(axis=0)) / 2)

    @property
    def size(self) -> float:
        """Diagonal of the bounding box, mm."""
        return float(np.linalg.norm(np.ptp(self.points, axis=0)))


@dataclass(frozen=True)
class RadialCuts:
    """Half planes that end at an axis: at given angles, or `count` half planes at equal angles."""

    half: ClassVar[bool] = True
    count: Annotated[int, Option("Number of half planes, at equal angles around the axis.", least=1)] = 8
    angles: Annotated[
        tuple[float, ...] | None,
        Option(
            "Angles of the half planes, instead of count.",
            "rad",
            least=-TWO_TURNS_RAD,
            most=TWO_TURNS_RAD,
            replaces=("count",),
        ),
    ] = None
    point: Annotated[Triple, Option("Point on the axis.", "mm")] = (0.0, 0.0, 0.0)
    axis: Annotated[Triple, Option("Direction of the axis.")] = (0.0, 0.0, 1.0)
    zero: Annotated[Triple, Option("Direction of the angle 0.")] = (1.0, 0.0, 0.0)

    def frames(self, _surface: Surface, /) -> tuple[Frame, ...]:
        """Return the planes, which do not depend on the surface."""
        if self.angles is not None:
            _refuse_twice("angles", self.angles, 2 * np.pi)
            return radial_planes(self.point, self.axis, self.angles, zero=self.zero)
        angles = 2 * np.pi * np.arange(_plane_count(self.count)) / self.count
        return radial_planes(self.point, self.axis, angles, zero=self.zero)


@dataclass(frozen=True)
class ParallelCuts:
    """Parallel planes: at given offsets from a point, or in the middle of `count` equal slices of the surface."""

    half: ClassVar[bool] = False
    normal: Annotated[Triple, Option("Normal of the planes.")]
    count: Annotated[int, Option("Number of planes at equal distances, instead of offsets.", least=1)] = 8
    offsets: Annotated[
        tuple[float, ...] | None,
        Option("Distances of the planes from the point.", "mm", replaces=("count",)),
    ] = None
    point: Annotated[Triple, Option("Point from which offsets are measured.", "mm")] = (0.0, 0.0, 0.0)
    up: Annotated[Triple, Option("The y axis of the sections.")] = (0.0, 0.0, 1.0)

    def frames(self, surface: Surface, /) -> tuple[Frame, ...]:
        """Return the planes, which depend on the extent of the surface if `offsets` is None."""
        if self.offsets is not None:
            _refuse_twice("offsets", self.offsets)
            return parallel_planes(self.point, self.normal, self.offsets, up=self.up)
        count = _plane_count(self.count)
        (first,) = parallel_planes(self.point, self.normal, 0.0, up=self.up)
        away = (surface.points - self.point) @ first.z_axis
        offsets = away.min() + np.ptp(away) * (np.arange(count) + 0.5) / count
        return parallel_planes(self.point, self.normal, offsets, up=self.up)


@dataclass(frozen=True, eq=False)
class AlongPath:
    """Planes normal to a path of points (n, 3), mm: see `planes_along`."""

    half: ClassVar[bool] = False
    path: Annotated[FloatArray, Option("Points of the path.", "mm", written=tuple[Triple, ...])]
    count: Annotated[int, Option("Number of planes.", least=1)] = 8
    ends: Annotated[bool, Option("Place the first and the last plane at the ends of the path.")] = False
    up: Annotated[Triple, Option("The y axis of the sections.")] = (0.0, 0.0, 1.0)

    def frames(self, _surface: Surface, /) -> tuple[Frame, ...]:
        """Return the planes, which do not depend on the surface."""
        return planes_along(self.path, self.count, ends=self.ends, up=self.up)


@dataclass(frozen=True, eq=False)
class GivenCuts:
    """Planes that are given as frames."""

    half: ClassVar[bool] = False
    planes: tuple[Frame, ...]

    def frames(self, _surface: Surface, /) -> tuple[Frame, ...]:
        """Return the planes, which do not depend on the surface."""
        return self.planes


Cuts: TypeAlias = RadialCuts | ParallelCuts | AlongPath | GivenCuts
"""Family of planes that cut a surface. With `half`, only the part with x >= 0 of a section is used by default."""


@dataclass(frozen=True)
class PlaneSplit:
    """Split at the plane through `point` with the normal `normal`."""

    normal: Annotated[Triple, Option("Normal of the plane.")]
    point: Annotated[Triple, Option("Point of the plane.", "mm")] = (0.0, 0.0, 0.0)

    def __post_init__(self) -> None:
        if not any(self.normal):
            raise InputError("normal is zero: give a direction of three numbers")

    @property
    def name(self) -> str:
        """Name of the split in messages."""
        x, y, z = map(float, self.normal)
        across = "the plane through {place} across ({x:.4g}, {y:.4g}, {z:.4g})"
        return note(across, place=Point(self.point), x=x, y=y, z=z)

    def pieces(self, line: SectionLine) -> tuple[SectionLine, ...]:
        """Return the pieces of a line, split at the plane."""
        return line.split_by(self.point, self.normal)


@dataclass(frozen=True, eq=False)
class PointSplit:
    """Split at the positions nearest to points (k, 3) in space."""

    points: Annotated[
        FloatArray, Option("Split at the places nearest to these points.", "mm", written=tuple[Triple, ...])
    ]

    name: ClassVar[str] = "a point"

    def pieces(self, line: SectionLine) -> tuple[SectionLine, ...]:
        """Return the pieces of a line, split at the positions nearest to the points."""
        return line.split_at(line.frame.local(self.points)[:, :2])


@dataclass(frozen=True)
class CornerSplit:
    """Split at corners whose direction changes by more than `corners`, rad."""

    corners: Annotated[float, Option("Split where the line turns by more than this angle.", "rad", least=0)]

    def __post_init__(self) -> None:
        if not 0 < self.corners < np.pi:
            raise InputError(f"corners is {self.corners:g}: give an angle between 0 and pi, in rad")

    @property
    def name(self) -> str:
        """Name of the split in messages."""
        return note("a turn of more than {turn:.4g} at a corner", turn=Angle(self.corners))

    def pieces(self, line: SectionLine) -> tuple[SectionLine, ...]:
        """Return the pieces of a line, split at corners."""
        return line.split_at_corners(self.corners)


Split: TypeAlias = PlaneSplit | PointSplit | CornerSplit
"""Method to split the line of a section."""


@dataclass(frozen=True, eq=False)
class SectionSpec:
    """Request for sections of a surface and for curves fitted to them.

    Parameters
    ----------
    cuts : RadialCuts, ParallelCuts, AlongPath or GivenCuts
        Family of planes.
    half : bool, optional
        If True, only the part with x >= 0 of each section is used. The default for radial cuts is True.
    longest : bool
        If True, only the longest line of each section is used.
    splits : sequence of PlaneSplit, PointSplit and CornerSplit
        Methods by which the lines are split, one after another.
    tolerance : float
        Largest distance of the curves from the sections, mm.
    wavelength : float
        Wavelength, mm, below which waves are smoothed first.
    """

    cuts: Cuts
    half: bool | None = None
    longest: bool = False
    splits: tuple[Split, ...] = ()
    tolerance: float = 0.3
    wavelength: float = 0.0

    def curves(self, surface: Surface) -> tuple[tuple[SectionCurve, ...], tuple[str, ...]]:
        """Return the curves of all lines that a strip can follow, and notes."""
        half = self.cuts.half if self.half is None else self.half
        divided = [self._divide(section) for section in surface.cut(self.cuts.frames(surface), half)]
        curves, reports = section_curves(
            [section for section, _ in divided], tolerance=self.tolerance, wavelength=self.wavelength
        )
        if not curves:
            raise InputError(
                f"no plane gives a strip: {_reasons(reports)}",
                changes=[
                    change
                    for report in reports
                    if isinstance(report, Refusal)
                    for change in report.all_changes
                ],
            )
        idle = [split.name for split in self.splits if not any(split.name in used for _, used in divided)]
        return tuple(curves), (
            *reports,
            *(note("{name} does not split any section", name=name) for name in idle),
        )

    def _divide(self, section: PlaneSection) -> tuple[PlaneSection, frozenset[str]]:
        """Return the section with its lines selected and split, and the names of the splits that had an effect."""
        used = set()
        lines, reports = section.lines, section.reports
        if self.longest and len(lines) > 1:
            reports = (
                *reports,
                note(
                    "{name}: only the longest line is used, with a length of {length}",
                    name=section.name,
                    length=Length(lines[0].length),
                ),
            )
            lines = lines[:1]
        for split in self.splits:
            pieces: list[SectionLine] = []
            for line in lines:
                try:
                    parts = split.pieces(line)
                except InputError as problem:
                    reports = (*reports, problem.at(strip=line.name).refusal)
                    used.add(split.name)
                    continue
                pieces += parts
                if parts != (line,):
                    used.add(split.name)
            lines = tuple(pieces)
        if not lines:
            # a section without lines does not show that a split has no effect
            used |= {split.name for split in self.splits if not section.lines}
        return replace(section, lines=lines, reports=reports), frozenset(used)


def _reasons(reports: Sequence[str]) -> str:
    """Return the first reports that name their object, or else the first reports, as sentences."""
    refusals = (report for report in reports if isinstance(report, Refusal))
    named = [report for report in refusals if "name" in report.values or report.where]
    reasons: Sequence[str] = named or reports
    omitted = len(reasons) - NAMED_REASONS
    more = [note("and {count} more like these", count=omitted)] if omitted > 0 else []
    return sentences([*reasons[:NAMED_REASONS], *more]) if reasons else note("none is given")


def _refuse_twice(name: str, values: Sequence[float], period: float = np.inf) -> None:
    """Raise InputError for two equal planes. `values` are offsets or, with a `period`, angles."""
    order = np.mod(values, period).argsort(kind="stable")
    # the last angle is compared with the first too
    ring = np.append(order, order[:1]) if np.isfinite(period) else order
    steps = np.diff(np.asarray(values)[ring])
    if np.isfinite(period):
        steps -= period * np.round(steps / period)
    # smaller differences, as fractions of the largest value, are rounding errors
    twice = np.flatnonzero(np.abs(steps) <= 1e-9 * max(1.0, float(np.abs(values).max(initial=0.0))))
    if len(values) > 1 and twice.size:
        i, j = sorted((int(ring[twice[0]]), int(ring[twice[0] + 1])))
        raise InputError(
            f"{name} contains the same plane twice, as numbers {i + 1} and {j + 1}: remove one of them"
        )


def _plane_count(count: int) -> int:
    if count > MOST_PLANES:
        raise InputError(f"count is {count}: give at most {MOST_PLANES} planes")
    return count
