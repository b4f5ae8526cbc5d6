"""Lines that a plane cuts out of a surface: split, run the agreed way round, named, sorted and reported."""

from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import require_flag
from elastica_cad.errors import InputError
from elastica_cad.geometry.curves.curve_derivatives import turn_between
from elastica_cad.geometry.frame import Frame
from elastica_cad.geometry.running_sums import lengths_along
from elastica_cad.refusals import Listed, Point, note

IN_PLANE = 1e-12
"""Vertices nearer to a plane than this share of the surface's size lie in the plane."""


@dataclass(frozen=True, eq=False)
class SectionLine:
    """One line of a section.

    Open ones run from their lower end (y), at equal height from the left one; closed ones anticlockwise from
    their lowest point, which is repeated at the end.

    Attributes
    ----------
    points : (n, 2) array
        In the coordinates of the frame, mm.
    frame : Frame
    name : str
        What messages call it.
    """

    points: FloatArray
    frame: Frame
    name: str

    @property
    def is_closed(self) -> bool:
        """Whether the line ends at its start."""
        return bool(np.all(self.points[0] == self.points[-1]))

    @property
    def length(self) -> float:
        """Length of the line, mm."""
        return float(lengths_along(self.points)[-1])

    @property
    def places(self) -> FloatArray:
        """The points in space (n, 3), mm."""
        return self.frame.point(self.points)

    def reversed(self) -> "SectionLine":
        """The line in the opposite direction."""
        return replace(self, points=self.points[::-1])

    def split_at(self, points: ArrayLike) -> tuple["SectionLine", ...]:
        """The pieces between the places nearest to `points` (k, 2): k + 1 of an open line, k of a closed one.

        Raises
        ------
        InputError
            No points, or two with the same place.
        """
        wanted = np.atleast_2d(np.asarray(points, dtype=float))
        if wanted.shape[1] != 2 or not np.all(np.isfinite(wanted)):
            raise InputError("{name} is split at points (k, 2) of its plane, mm", name=self.name)
        return self._split(np.sort([_nearest(self.points, p) for p in wanted]))

    def split_by(self, point: ArrayLike, normal: ArrayLike) -> tuple["SectionLine", ...]:
        """The pieces on either side of the plane through `point` (3,) across `normal` (3,): a spine.

        The line itself where the plane misses it.
        """
        n, p = np.asarray(normal, dtype=float), np.asarray(point, dtype=float)
        if n.shape != (3,) or p.shape != (3,) or not np.any(n) or not np.all(np.isfinite([n, p])):
            raise InputError("a spine is a point and a normal of three numbers, the normal not zero")
        height = (self.places - p) @ (n / np.linalg.norm(n))
        height = np.where(np.abs(height) <= IN_PLANE * np.abs(self.places).max(), 0.0, height)
        above = height >= 0
        i = np.flatnonzero(above[:-1] != above[1:])
        cuts = i + height[i] / (height[i] - height[i + 1])
        if not self.is_closed:  # a plane through its end does not split it
            cuts = cuts[(cuts > 0) & (cuts < len(self.points) - 1)]
        return self._split(cuts) if cuts.size else (self,)

    def split_at_corners(self, turn: float) -> tuple["SectionLine", ...]:
        """The pieces between corners that turn by more than `turn`, rad; the line itself where it has none.

        Raises
        ------
        InputError
            An angle that is not between 0 and pi.
        """
        if not 0 < turn < np.pi:
            raise InputError("corners turn by an angle between 0 and pi rad, not {turn!r}", turn=turn)
        points = np.concatenate([self.points, self.points[1:2]]) if self.is_closed else self.points
        corners = 1.0 + np.flatnonzero(inner_turns(points) > turn)
        if self.is_closed:
            corners %= len(self.points) - 1
        return self._split(np.sort(corners)) if corners.size else (self,)

    def _split(self, cuts: FloatArray) -> tuple["SectionLine", ...]:
        """Pieces between cuts, in points and shares of the way to the next."""
        last = len(self.points) - 1
        index = np.arange(last + 1)
        at = np.column_stack([np.interp(cuts, index, column) for column in self.points.T])
        cuts = np.unique(cuts)
        if len(cuts) < len(at) or (not self.is_closed and (cuts[0] <= 0 or cuts[-1] >= last)):
            raise InputError(
                "{name} is split twice at one place, or at its very end: move the points", name=self.name
            )
        marks = np.concatenate([[0], cuts, [last]])
        points = [
            np.concatenate([[start], self.points[(index > a) & (index < b)], [end]])
            for a, b, start, end in zip(
                marks[:-1], marks[1:], [self.points[0], *at], [*at, self.points[-1]], strict=True
            )
        ]
        if self.is_closed:
            points = [np.concatenate([points[-1][:-1], points[0]]), *points[1:-1]]
        points = [p[np.append(True, np.any(np.diff(p, axis=0) != 0, axis=1))] for p in points]
        return tuple(
            replace(self, points=p, name=f"{self.name}, piece {k + 1}")
            for k, p in enumerate(points)
            if len(p) > 1
        )


@dataclass(frozen=True, eq=False)
class PlaneSection:
    """What one plane cuts out of a mesh.

    Attributes
    ----------
    name : str
        "section 3" after its place in the family.
    frame : Frame
    lines : tuple of SectionLine
        The longest first; none where the plane misses.
    reports : tuple of str
        What is worth knowing, one sentence each, the section and the place named.
    """

    name: str
    frame: Frame
    lines: tuple[SectionLine, ...]
    reports: tuple[str, ...] = ()

    @property
    def line(self) -> SectionLine:
        """The only line.

        Raises
        ------
        InputError
            None, or several: choose from `lines`.
        """
        if len(self.lines) != 1:
            reason = (
                self.reports[0]
                if self.reports
                else note("{name} has {count} lines", name=self.name, count=len(self.lines))
            )
            raise InputError("{reason}: choose from its lines", reason=reason)
        return self.lines[0]


def inner_turns(points: FloatArray) -> FloatArray:
    """Angles (n - 2,), rad, by which a polyline (n, 2) turns at its inner points."""
    step = np.diff(points, axis=0)
    return np.abs(turn_between(step[:-1], step[1:]))


def collect_section(
    name: str,
    frame: Frame,
    chains: Iterable[FloatArray],
    *,
    half: bool = False,
    apart: float,
    missed: Callable[[], str] = lambda: "misses the shape",
) -> PlaneSection:
    """The section that lines (k, 2) make: the longest first, each with a name, and what is worth knowing.

    Parameters
    ----------
    half : bool
        Only what lies at x >= 0.
    apart : float
        Neighbouring points nearer than this are one, mm.
    missed : callable
        What the plane does where there is no line, in words.
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
                "{name} falls into {count} lines, starting at {starts}",
                name=name,
                count=len(lines),
                starts=starts,
            ),
        )
    names = [name]
    if len(lines) != 1:
        names = [note("{name}, line {number}", name=name, number=k + 1) for k in range(len(lines))]
    made = tuple(SectionLine(line, frame, called) for line, called in zip(lines, names, strict=True))
    return PlaneSection(name, frame, made, reports)


def tidy_points(points: FloatArray, small: float) -> FloatArray:
    """Remove repeated points, and give the line its standard direction."""
    closed = bool(np.all(points[0] == points[-1])) and len(points) > 2
    keep = np.append(True, np.linalg.norm(np.diff(points, axis=0), axis=1) > small)
    points = points[keep]
    if closed and len(points) > 1:
        if np.linalg.norm(points[-1] - points[0]) <= small:
            points = points[:-1]
        if len(points) < 3:
            return points[:1]
        x, y = points.T
        if np.sum(x * np.roll(y, -1) - y * np.roll(x, -1)) < 0:
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
    """The parts of a line with x >= 0."""
    closed = bool(np.all(points[0] == points[-1]))
    x = points[:, 0]
    if np.all(x >= 0):
        return [points]
    if closed:  # begin on the other side, so that no part runs over the seam
        shift = int(np.argmin(x[:-1]))
        points = np.concatenate([points[shift:-1], points[: shift + 1]])
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
    """Position of the point of the polyline nearest to a place: number of a point plus the share of the way to
    the next."""
    step = np.diff(points, axis=0)
    u = np.clip(((place - points[:-1]) * step).sum(axis=1) / (step**2).sum(axis=1), 0.0, 1.0)
    off = np.linalg.norm(points[:-1] + u[:, None] * step - place, axis=1)
    i = int(np.argmin(off))
    return i + float(u[i])


def place_in_words(point: FloatArray) -> Point:
    """A point (3,) as messages give it."""
    return Point(np.asarray(point).round(9) + 0.0)
