"""Lines of plane sections, and smooth curves fitted to them."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import (
    is_number,
    is_whole,
    numbers,
    require_flag,
    require_positive,
    require_record,
    several,
)
from elastica_cad.errors import (
    Angle,
    Change,
    InputError,
    Length,
    Listed,
    NotConvergedError,
    Point,
    Span,
    note,
)
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.path import Spline, distances, polyline_distances
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.geometry.plane_points import (
    begun_at,
    dot,
    lengths_along,
    norm,
    numbers_in_groups,
    points_at,
    turn_between,
)
from elastica_cad.geometry.splines import fit_spline
from elastica_cad.mechanics.loads import Gravity
from elastica_cad.mechanics.section_limits import sharpest_bend
from elastica_cad.mechanics.sheets import Sheet

IN_PLANE = 1e-12
"""Distance below which a vertex is in a plane, as a fraction of the size of the surface."""


@dataclass(frozen=True, eq=False)
class SectionLine:
    """One line of a section, as a polyline.

    An open line starts at its lower end (smaller y), or at its left end if both are equally high. A closed line is
    anticlockwise and starts at its lowest point, which is repeated at the end.

    Attributes
    ----------
    points : (n, 2) array
        Points in the coordinates of the frame, mm.
    frame : Frame
    name : str
        Name in messages.
    """

    points: FloatArray
    frame: Frame
    name: str

    @property
    def is_closed(self) -> bool:
        """True if the line is closed."""
        return bool((self.points[0] == self.points[-1]).all())

    @property
    def length(self) -> float:
        """Length of the line, mm."""
        return float(lengths_along(self.points)[-1])

    @property
    def places(self) -> FloatArray:
        """Points of the line in space (n, 3), mm."""
        return self.frame.point(self.points)

    def reversed(self) -> "SectionLine":
        """Return the line in the opposite direction."""
        return replace(self, points=self.points[::-1])

    def split_at(self, points: ArrayLike) -> tuple["SectionLine", ...]:
        """Return the pieces of the line, split at the positions nearest to `points` (k, 2).

        There are k + 1 pieces of an open line, and k of a closed line.
        """
        places = np.atleast_2d(np.asarray(points, dtype=float))
        if places.shape[1] != 2 or not np.isfinite(places).all():
            raise InputError(
                f"the points to split {self.name} cannot be read: give an array (k, 2) of finite numbers, "
                "in mm, in the plane of the section"
            )
        return self._split(np.sort([_nearest(self.points, p) for p in places]))

    def split_by(self, point: ArrayLike, normal: ArrayLike) -> tuple["SectionLine", ...]:
        """Return the pieces of the line, split at the plane through `point` (3,) with the normal `normal` (3,).

        If the plane misses the line, the result is the line itself.
        """
        n, p = np.asarray(normal, dtype=float), np.asarray(point, dtype=float)
        if n.shape != (3,) or p.shape != (3,) or not n.any() or not np.isfinite([n, p]).all():
            raise InputError(
                "the splitting plane cannot be read: give a point and a normal of three numbers each, the "
                "normal not zero"
            )
        height = (self.places - p) @ (n / np.linalg.norm(n))
        height = np.where(np.abs(height) <= IN_PLANE * np.abs(self.places).max(), 0.0, height)
        above = height >= 0
        i = np.flatnonzero(above[:-1] != above[1:])
        cuts = i + height[i] / (height[i] - height[i + 1])
        if not self.is_closed:
            cuts = cuts[(cuts > 0) & (cuts < len(self.points) - 1)]
        return self._split(cuts) if cuts.size else (self,)

    def split_at_corners(self, turn: float) -> tuple["SectionLine", ...]:
        """Return the pieces of the line, split at corners whose direction changes by more than `turn`, rad."""
        if not 0 < turn < np.pi:
            raise InputError(f"the angle of a corner is {turn!r}: give a number between 0 and pi, in rad")
        points = np.concatenate([self.points, self.points[1:2]]) if self.is_closed else self.points
        corners = 1.0 + np.flatnonzero(_inner_turns(points) > turn)
        if self.is_closed:
            corners %= len(self.points) - 1
        return self._split(np.sort(corners)) if corners.size else (self,)

    def _split(self, cuts: FloatArray) -> tuple["SectionLine", ...]:
        """Return the pieces between `cuts`, which are indices of points plus a fraction of the next side."""
        last = len(self.points) - 1
        index = np.arange(last + 1.0)
        at = points_at(cuts, index, self.points)
        cuts = np.unique(cuts)
        if len(cuts) < len(at) or (not self.is_closed and (cuts[0] <= 0 or cuts[-1] >= last)):
            raise InputError(
                "{name} is split twice at the same place, or at its end: move the points", name=self.name
            )
        marks = np.concatenate([[0], cuts, [last]])
        points = [
            np.concatenate([[start], self.points[(index > a) & (index < b)], [end]])
            for a, b, start, end in zip(
                marks[:-1], marks[1:], [self.points[0], *at], [*at, self.points[-1]], strict=True
            )
        ]
        if self.is_closed:
            # the start of a closed line is not a cut, so the last and the first piece are one
            points = [np.concatenate([points[-1][:-1], points[0]]), *points[1:-1]]
        points = [p[np.append(True, (np.diff(p, axis=0) != 0).any(axis=1))] for p in points]
        return tuple(
            replace(self, points=p, name=f"{self.name}, piece {k + 1}")
            for k, p in enumerate(points)
            if len(p) > 1
        )


@dataclass(frozen=True, eq=False)
class PlaneSection:
    """Section of a mesh by one plane.

    Attributes
    ----------
    name : str
        Name from the number of the plane, such as "section 3".
    frame : Frame
    lines : tuple of SectionLine
        Lines, the longest first; empty if the plane misses the surface.
    reports : tuple of str
        Notes, one sentence each, with the name of the section and the position.
    """

    name: str
    frame: Frame
    lines: tuple[SectionLine, ...]
    reports: tuple[str, ...] = ()

    @property
    def line(self) -> SectionLine:
        """The line of a section that has only one line."""
        if len(self.lines) != 1:
            reason = (
                self.reports[0]
                if self.reports
                else note("{name} has {count} lines", name=self.name, count=len(self.lines))
            )
            raise InputError("{reason}: choose one line of the section", reason=reason)
        return self.lines[0]


def _inner_turns(points: FloatArray) -> FloatArray:
    # changes of direction (n - 2,), rad, at the inner points of a polyline (n, 2)
    step = np.diff(points, axis=0)
    return np.abs(turn_between(step[:-1], step[1:]))


def collect_section(
    name: str,
    frame: Frame,
    chains: Iterable[FloatArray],
    *,
    half: bool,
    apart: float,
    missed: Callable[[], str] = lambda: "misses the shape",
) -> PlaneSection:
    """Return the section `name`, with a label for each of its lines (k, 2), the longest first.

    Parameters
    ----------
    half : bool
        If True, only the part with x >= 0 is kept.
    apart : float
        Distance, mm, below which neighbouring points are merged.
    missed : callable
        Function without arguments that describes a plane without a line: "misses the shape".
    """
    if require_flag(half, "half"):
        chains = [part for chain in chains for part in _clip_to_right_half(chain)]
    lines = [line for line in (tidy_points(chain, apart) for chain in chains) if len(line) > 1]
    lines.sort(key=lambda line: -lengths_along(line)[-1])
    reports: tuple[str, ...] = ()
    if not lines:
        reports = (
            note(
                "{name} at {place}: the plane {missed}",
                name=name,
                place=place_in_words(frame.origin),
                missed=missed(),
            ),
        )
    elif len(lines) > 1:
        starts = Listed(place_in_words(frame.point(line[0])) for line in lines[:3])
        reports = (
            note(
                "{name} consists of {count} separate lines, starting at {starts}. Each line becomes its own "
                "curve",
                name=name,
                count=len(lines),
                starts=starts,
            ),
        )
    names = [name]
    if len(lines) != 1:
        names = [note("{name}, line {number}", name=name, number=k + 1) for k in range(len(lines))]
    named = tuple(SectionLine(line, frame, called) for line, called in zip(lines, names, strict=True))
    return PlaneSection(name, frame, named, reports)


def tidy_points(points: FloatArray, small: float) -> FloatArray:
    """Return the points of a line without repeated points and in the direction of `SectionLine`.

    `small` is the distance below which points are equal.
    """
    closed = bool((points[0] == points[-1]).all()) and len(points) > 2
    points = points[np.append(True, norm(np.diff(points, axis=0)) > small)]
    if closed and len(points) > 1:
        if norm(points[-1] - points[0]) <= small:
            points = points[:-1]
        if len(points) < 3:
            return points[:1]
        x, y = points.T
        if (x * np.roll(y, -1) - y * np.roll(x, -1)).sum() < 0:
            points = points[::-1]
        points = np.roll(points, -int(np.lexsort(points.T)[0]), axis=0)
        return np.concatenate([points, points[:1]])
    if len(points) > 1:
        first, last = points[0], points[-1]
        level = abs(first[1] - last[1]) <= 1e-9 * np.abs(points).max()
        if (last[0] < first[0]) if level else (last[1] < first[1]):
            points = points[::-1]
    return points


def _clip_to_right_half(points: FloatArray) -> list[FloatArray]:
    """Return the parts of a line with x >= 0, cut at x = 0."""
    x = points[:, 0]
    if (x >= 0).all():
        return [points]
    if (points[0] == points[-1]).all():
        # start the closed line at x < 0, so that its start does not divide a part with x >= 0
        points = begun_at(points, int(x[:-1].argmin()))
        x = points[:, 0]
    parts: list[list[FloatArray]] = []
    for i in range(len(points)):
        if i and (x[i] >= 0) != (x[i - 1] >= 0):
            u = x[i - 1] / (x[i - 1] - x[i])
            cut = np.array([0.0, points[i - 1, 1] + u * (points[i, 1] - points[i - 1, 1])])
            if x[i] >= 0:
                parts.append([cut])
            else:
                parts[-1].append(cut)
        if x[i] >= 0:
            if not parts:
                parts.append([])
            parts[-1].append(points[i])
    return [np.array(part) for part in parts]


def _nearest(points: FloatArray, place: FloatArray) -> float:
    """Return the position on a polyline nearest to a point: a vertex index plus a fraction of the next side."""
    step = np.diff(points, axis=0)
    u = (dot(place - points[:-1], step) / dot(step, step)).clip(0.0, 1.0)
    i = norm(points[:-1] + u[:, None] * step - place).argmin()
    return float(i + u[i])


def place_in_words(point: FloatArray) -> Point:
    """Return a point (3,) with rounded coordinates, for messages."""
    return Point(point.round(9) + 0.0)


SMOOTHED_POINTS, MOST_SMOOTHED = 240, 5_000
"""Default and largest number of smoothed points, which is the size of a dense matrix."""

FALSE_TURN_RAD = np.radians(4.0)
"""Angle, rad, below which a bend between two inflections counts as an artefact of the mesh."""

SAMPLES = 2001
"""Number of points of a curve at which its distance from the section is computed."""

SHARP_TURN_RAD = np.radians(20.0)
"""Least change of direction at a corner, rad."""

AT_CORNERS = Change("split_corners", True)
"""Change that is suggested for a line with a corner."""

AT_TWO_PLACES = Change("split", True)
"""Change that is suggested for a closed line: a split at a plane or at two points."""

NODES, WEIGHTS = np.polynomial.legendre.leggauss(8)


@dataclass(frozen=True, eq=False)
class SectionCurve:
    """A smooth curve fitted to the line of a section, in its plane in space.

    Attributes
    ----------
    curve : PlaneCurve
    frame : Frame
    name : str
    deviation : float
        Largest distance of a section point from the curve, or of a curve point from the section, mm.
    removed : int
        Number of false inflections that were removed by smoothing.
    """

    curve: PlaneCurve
    frame: Frame
    name: str
    deviation: float
    removed: int = 0

    @property
    def called(self) -> str:
        """Text with the name of the section and the start of the curve in space."""
        begins = place_in_words(self.frame.point(self.curve.evaluate(self.curve.domain[0])))
        return note("{name}, from {begins}", name=self.name, begins=begins)

    def gravity(self, sheet: Sheet, direction: ArrayLike = (0.0, 0.0, -1.0)) -> Gravity | None:
        """Return gravity for a sheet in the plane of the curve, for a `direction` in space."""
        frame = self.frame
        return Gravity.in_plane(sheet.elasto_gravity_length, direction, frame.x_axis, frame.y_axis)


def section_curves(
    sections: Iterable[PlaneSection | SectionLine],
    *,
    tolerance: float = 0.3,
    wavelength: float = 0.0,
    false_turn: float = FALSE_TURN_RAD,
) -> tuple[tuple[SectionCurve, ...], tuple[str, ...]]:
    """Return curves of degree 4 fitted to the lines of sections, for `nearest_rods`.

    Parameters
    ----------
    sections : iterable of PlaneSection or SectionLine
        Sections, all of whose lines are used, or lines. Closed lines must be split first.
    tolerance : float
        Largest distance of the points, after smoothing, from the curve, mm.
    wavelength : float
        Wavelength, mm, below which waves are smoothed first. The ends do not move. 0 for no smoothing.
    false_turn : float
        Angle, rad. Pairs of inflections are removed if the curve turns by less between them. 0 keeps all
        inflections.

    Returns
    -------
    curves : tuple of SectionCurve
        Curves with their planes.
    reports : tuple of str
        Notes of the sections, and a reason for each line without a curve.

    Examples
    --------
    >>> u = np.linspace(0, np.pi, 60)
    >>> line = SectionLine(50 * np.column_stack([-np.cos(u), np.sin(u)]), Frame(), "arch")
    >>> (found,), reports = section_curves([line])
    >>> found.name, found.curve.degree, reports
    ('arch', 4, ())
    """
    if not (is_number(wavelength) and wavelength >= 0):
        raise InputError(f"wavelength is {wavelength!r}: give 0 (no smoothing) or more, in mm")
    if not (is_number(tolerance) and tolerance > 0):
        raise InputError(f"tolerance is {tolerance!r}: give a number above 0, in mm")
    if not (is_number(false_turn) and 0 <= false_turn <= np.pi):
        raise InputError(f"false_turn is {false_turn!r}: give an angle from 0 to pi, in rad")
    curves: list[SectionCurve] = []
    reports: list[str] = []
    for item in several("sections", sections, PlaneSection | SectionLine, "PlaneSection or SectionLine"):
        reports += item.reports if isinstance(item, PlaneSection) else ()
        for line in item.lines if isinstance(item, PlaneSection) else (item,):
            try:
                curve, notes = _curve(line, tolerance, wavelength, false_turn)
            except (InputError, NotConvergedError) as error:
                reports.append(error.at(strip=line.name).refusal)
                continue
            curves.append(curve)
            reports += notes
    return tuple(curves), tuple(reports)


def _curve(
    line: SectionLine, tolerance: float, wavelength: float, false_turn: float
) -> tuple[SectionCurve, list[str]]:
    """Return the curve fitted to a line of a section, and notes on what was changed or remains doubtful.

    Lines with a positive `wavelength`, mm, are smoothed. Bends of less than `false_turn`, rad, are removed.
    """
    # a smaller gap between the ends, as a fraction of the length, is a rounding error
    if line.is_closed or norm(line.points[-1] - line.points[0]) <= 1e-6 * line.length:
        raise InputError(
            "the section is a closed line (through {place}), but a strip has two ends: split it by a plane "
            "or at two points",
            place=Point(line.places[0]),
            changes=[AT_TWO_PLACES],
        )
    # add points to long sides, because a curve fitted only to vertices could deviate from the sides
    s = lengths_along(line.points)
    # add about 240 points
    counts = np.maximum(np.ceil(np.diff(s) / s[-1] * 240), 1).astype(int)
    index = np.arange(len(counts)).repeat(counts)
    fraction = numbers_in_groups(counts) / counts[index]
    between = line.points[index] + fraction[:, None] * (line.points[index + 1] - line.points[index])
    vertices = np.concatenate([between, line.points[-1:]])
    points = smooth_polyline(line.points, wavelength) if wavelength > 0 else vertices
    try:
        curve = PlaneCurve(*fit_spline(points, 4, tolerance), 4)
    except NotConvergedError as error:
        raise NotConvergedError(_sharp_corner_message(line, tolerance) or str(error)) from error
    fitted, before = curve, curve.inflections.size
    notes = _sharp_bend_messages(curve, line)
    if false_turn > 0:
        try:
            curve = remove_false_inflections(curve, turn=false_turn)
        except NotConvergedError as error:
            notes.append(note("{name}: {why}. The curve was not changed", name=line.name, why=error.refusal))
    if notes and not wavelength:
        turned, sides = _inner_turns(line.points), np.diff(lengths_along(line.points))
        turned = np.where(np.minimum(sides[:-1], sides[1:]) > tolerance, turned, 0.0)
        if turned.max(initial=0.0) > SHARP_TURN_RAD:
            raise InputError(
                "{sharpest}. Split the section at its corners, export a finer mesh, or smooth the section",
                sharpest=_sharpest(line, turned),
                changes=[AT_CORNERS],
            )
    removed = before - curve.inflections.size
    on_curve = curve.sample(SAMPLES).position
    places = np.concatenate([vertices, on_curve])
    off = np.concatenate([distances(Spline(curve), vertices), polyline_distances(line.points, on_curve)])
    worst = off.argmax()
    if off[worst] > tolerance:
        cause = note(
            "smoothing removed waves shorter than {wavelength:g}; use a shorter wavelength to stay closer to "
            "the section"
            if wavelength > 0 else
            "the curve bent slightly to one side and back; these small bends were removed"
            if curve is not fitted else
            "no smooth curve is closer to the section; set a wavelength to remove shorter waves first",
            wavelength=Length(wavelength),
        )  # fmt: skip
        place = note(
            "{far} from the section at {place}", far=Length(off[worst]), place=_place(line, places[worst])
        )
        notes.append(note(
            "{name}: the curve is {off}, more than the tolerance of {tolerance:g}: {cause}",
            name=line.name, off=place, tolerance=Length(tolerance), cause=cause,
        ))  # fmt: skip
    return SectionCurve(curve, line.frame, line.name, float(off[worst]), removed), notes


def _place(line: SectionLine, point: FloatArray) -> str:
    return note("{place}", place=Point(line.frame.point(point).round(6) + 0.0))


def _sharp_corner_message(line: SectionLine, tolerance: float) -> str:
    turned = _inner_turns(line.points)
    if turned.max(initial=0.0) < SHARP_TURN_RAD:
        return ""
    return note(
        "no smooth curve stays within the tolerance of {tolerance:g}, because {sharpest}. Split the section "
        "at its corners, or smooth the section",
        tolerance=Length(tolerance), sharpest=_sharpest(line, turned), changes=(AT_CORNERS,),
    )  # fmt: skip


def _sharpest(line: SectionLine, turned: FloatArray) -> str:
    worst = turned.argmax()
    return note(
        "the section has a corner of {angle:.3g} at {place}",
        angle=Angle(turned[worst]),
        place=_place(line, line.points[worst + 1]),
    )


def _sharp_bend_messages(curve: PlaneCurve, line: SectionLine) -> list[str]:
    """Return the message on a bend that is a corner for a strip, if there is one."""
    kappa, at = sharpest_bend(curve, 0.0)
    # a bend with a radius below a hundredth of the length counts as a corner
    if kappa * curve.length <= 100:
        return []
    return [
        note(
            "{name} has a radius of {radius:.2g} at {place}, which is a corner for a strip: split the "
            "section at its corners, or smooth it",
            name=line.name,
            radius=Length(1 / kappa),
            place=_place(line, curve.at(np.array([at])).position[0]),
            changes=(AT_CORNERS,),
        )
    ]


def smooth_polyline(
    points: ArrayLike, wavelength: float, *, where: ArrayLike = (), count: int = SMOOTHED_POINTS
) -> FloatArray:
    """Return evenly spaced points (count, 2) on a polyline (n, 2), smoothed to remove short waves.

    The points x minimise |x - p|^2 + (wavelength / 2 pi)^6 |x'''|^2 for the unsmoothed points p. The amplitude
    of a wave of length `wavelength` is halved, and the amplitude of a wave of half this length is reduced to
    1/65. Parabolas do not change, and both ends do not move.

    Parameters
    ----------
    points : (n, 2) array_like
        Points of the polyline, mm.
    wavelength : float
        Wavelength, mm.
    where : (k, 2) array_like
        Pairs of arc lengths, mm, between which the polyline is smoothed; by default everywhere.
    count : int
        Number of returned points.

    Examples
    --------
    >>> x = np.linspace(0, 100, 400)
    >>> wavy = np.column_stack([x, np.sin(2 * np.pi * x / 4)])
    >>> bool(np.abs(smooth_polyline(wavy, 20)[20:-20, 1]).max() < 0.05)
    True
    """
    vertices = numbers(points, "points to smooth")
    if vertices.ndim != 2 or not len(vertices):
        raise InputError(f"the points to smooth have the shape {vertices.shape}: give an array (n, 2), in mm")
    if not np.isfinite(vertices).all():
        raise InputError("the points to smooth are not finite everywhere: give finite numbers, in mm")
    if not (is_whole(count) and 4 <= count <= MOST_SMOOTHED):
        raise InputError(f"count is {count!r}: give 4 to {MOST_SMOOTHED}, the number of smoothed points")
    if not (is_number(wavelength) and wavelength > 0):
        raise InputError(f"the wavelength is {wavelength!r}: give a number above 0, in mm")
    s = lengths_along(vertices)
    if s[-1] == 0:
        raise InputError("the points to smooth are all equal: give different points")
    at = np.linspace(0.0, s[-1], count)
    even = points_at(at, s, vertices)
    # matrix of third differences, and the arc lengths in the middle of their four points
    third = np.diff(np.eye(count), 3, axis=0)
    middle = (at[:-3] + at[3:]) / 2
    spans = numbers(where, "parts to smooth")
    if spans.size and spans.shape[1:] != (2,):
        raise InputError(
            "the parts to smooth cannot be read: give rows (start, end) of finite lengths along the points, "
            "in mm"
        )
    counted = np.any([(middle >= a) & (middle <= b) for a, b in spans], axis=0) if len(spans) else True
    # from a wavelength of four line lengths, the result is a parabola; larger wavelengths only add rounding errors
    share = min(wavelength, 4 * s[-1]) / (2 * np.pi * at[1])
    third = third * (np.broadcast_to(counted, middle.shape) * share**3)[:, None]
    system = np.eye(count) + third.T @ third
    inner = slice(1, -1)
    right = even[inner] - system[inner][:, [0, -1]] @ even[[0, -1]]
    even[inner] = np.linalg.solve(system[inner, inner], right)
    return np.asarray(even)


def remove_false_inflections(
    curve: PlaneCurve, *, turn: float = FALSE_TURN_RAD, give: float | None = None
) -> PlaneCurve:
    """Return the curve without bends that turn by less than `turn`. The ends of the curve do not move.

    A bend is a part between two inflections, or between an inflection and an end. Each bend, and one wavelength on
    both sides of the bend, is smoothed with the shortest sufficient wavelength.

    Parameters
    ----------
    curve : PlaneCurve
    turn : float
        Angle, rad.
    give : float, optional
        Largest distance by which the curve may move, mm; by default 1/100 of its length.

    Raises
    ------
    NotConvergedError
        The bends cannot be removed within this distance.

    Examples
    --------
    >>> x = np.linspace(0, 100, 60)
    >>> bumpy = PlaneCurve.fit(np.column_stack([x, 0.01 * (x - 50) ** 2 + 0.02 * np.sin(x)]), tolerance=1e-3)
    >>> bumpy.inflections.size > 4, remove_false_inflections(bumpy).inflections.size
    (True, 0)
    """
    require_record(curve, PlaneCurve, "the curve", "a PlaneCurve")
    require_positive(turn, "turn", "rad")
    if give is not None:
        require_positive(give, "give")
    bends = _false_bends(curve, turn)
    if not len(bends):
        return curve
    points = curve.sample(SMOOTHED_POINTS).position
    most = curve.length / 100 if give is None else give
    for wavelength in curve.length * 2.0 ** np.arange(-4.0, 0.1, 0.5):
        even = smooth_polyline(points, float(wavelength), where=bends + wavelength * np.array([-1.0, 1.0]))
        if norm(even - points).max() > most:
            break
        try:
            simpler = PlaneCurve(*fit_spline(even, 4, most / 20), 4)
        # kinks beside the smoothed part make the fit fail; a longer wavelength may avoid kinks
        except NotConvergedError:
            continue
        if not len(_false_bends(simpler, turn)):
            return simpler
    raise NotConvergedError(
        "the curve bends to one side and back by less than {turn:.2g} ({stretches} from its start), and "
        "smoothing by less than {most} does not remove these bends: draw the curve without them",
        stretches=Listed(Span((Length(a), Length(b))) for a, b in bends),
        turn=Angle(turn),
        most=Length(most),
    )


def _false_bends(curve: PlaneCurve, turn: float) -> FloatArray:
    """Return the arc lengths (k, 2), mm, of bends in which the curve turns by less than `turn`, rad.

    A bend is a part between two inflections or ends.
    """
    marks = np.concatenate([[0.0], curve.inflections, [curve.length]])
    if marks.size == 2:
        return np.empty((0, 2))
    half = np.diff(marks) / 2
    s = (marks[:-1] + half)[:, None] + half[:, None] * NODES
    kappa = curve.at(s.ravel()).curvature.reshape(s.shape)
    return np.column_stack([marks[:-1], marks[1:]])[np.abs(kappa @ WEIGHTS) * half < turn]
