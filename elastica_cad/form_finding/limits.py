"""Limits that a strip must meet, and properties of the drawn curve that it must keep."""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from functools import partial
from typing import TYPE_CHECKING, Annotated, Any, Literal, NamedTuple, TypeAlias, cast

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import is_series, numbers, pair, require_positive, require_record, several
from elastica_cad.declared import Option, require_declared
from elastica_cad.defaults import UNLIMITED_RATIO
from elastica_cad.errors import InputError, Length, note, rounded_down, rounded_up
from elastica_cad.geometry.plane_points import norm
from elastica_cad.mechanics.sheets import Sheet

if TYPE_CHECKING:
    from elastica_cad.mechanics.rod import Rod

Symmetry: TypeAlias = Literal["mirror", "turn"]
Measure: TypeAlias = Literal["mean", "max"]
Bound: TypeAlias = float | ArrayLike | Callable[[FloatArray], FloatArray] | None

MET = 5e-5  # largest violation of a limit that counts as met; see `ActiveLimit.broken` for its units
# distance from the drawn curve, as a fraction of its diagonal, above which a rod counts as a different curve
FAR_SHARE = 0.03


@dataclass(frozen=True)
class ActiveLimit:
    """Limit or kept property without which the rod would be nearer to the drawn curve.

    Attributes
    ----------
    name : str
        "ratio", "margin", "curvature", "length", "keep-out", "stiffness bounds", "end position", "end tangent",
        "start position", "start tangent", "points", "inflection line", "symmetry", ...
    limit : float or None
        Value of the limit if it is a single number; curvatures are in 1/mm, lengths in mm.
    cost : float
        First-order estimate of the decrease of the distance, mm, per unit by which the limit is relaxed. For a
        kept property, the decrease is per mm or per rad.
    broken : float
        Violation of the limit: in rad for angles, as a fraction of the drawn curve's length for positions and
        lengths, and otherwise as a fraction of the limit.
    title : str
        Limit in suggestions to relax it, such as "the ratio limit"; "" if it cannot be relaxed.
    unit : "number", "length", "angle" or ""
        Unit of the limit: a number without unit or a curvature, mm, or rad; "" if it is not a number.
    sentence : callable, optional
        Function of `limit` and of a rod that violates it: the message, in place of the usual sentence.
    """

    name: str
    limit: float | None = None
    cost: float = 0.0
    broken: float = 0.0
    title: str = ""
    unit: Literal["number", "length", "angle", ""] = ""
    sentence: "Callable[[Any, Rod], str] | None" = field(default=None, repr=False, compare=False)


class Places(NamedTuple):
    """Places along a bent strip: nodes of a rod, or stations of glued plies.

    Attributes
    ----------
    length : float
        Length of the drawn curve, mm.
    s : (n,) array
        Arc length on the drawn curve, mm.
    position : (n, 2) array
        Positions, mm.
    bend : (n,) array
        Change of curvature by bending, 1/mm.
    curvature : (n,) array
        Curvature of the bent strip, 1/mm.
    kept : (bool, bool)
        For start and end, True if its position is that of the drawn curve.
    """

    length: float
    s: FloatArray
    position: FloatArray
    bend: FloatArray
    curvature: FloatArray
    kept: tuple[bool, bool]


Room: TypeAlias = tuple[FloatArray, FloatArray, FloatArray]
"""Values (n,) of places, at least 0 where a limit is met, in the unit of `ActiveLimit.broken`.

Their derivatives follow: by position / length (n, 2) and by the curvature (n,)."""


class PlaceLimit(NamedTuple):
    """A limit that each place of a strip meets by itself, such as a region or a largest curvature.

    Attributes
    ----------
    field : str
        Field of `Limits` that sets the limit.
    active : ActiveLimit
        Name, limit, title, unit and sentence.
    room : callable
        Function that returns the `Room` of `Places`.
    stricter : callable
        Function that returns `Limits` with this limit made stricter by a fraction of its value.
    """

    field: str
    active: ActiveLimit
    room: Callable[[Places], Room]
    stricter: "Callable[[Limits, float], Limits]" = lambda limits, _: limits


def _room_in_region(region: "HalfPlane | Box", places: Places) -> Room:
    distance, gradient = region.clearance(places.position)
    # a kept end cannot move, so it counts as far away even if it is on the border
    distance[[0, -1]] = np.where(places.kept, places.length, distance[[0, -1]])
    return distance / places.length, gradient, np.zeros(distance.size)


def _room_to_bend(limit: float, places: Places) -> Room:
    bend = places.bend
    return 1 - np.abs(bend) / limit, np.zeros(places.position.shape), -np.sign(bend) / limit


def _bend_sentence(limit: float, rod: "Rod") -> str:
    largest = float(np.abs(rod.curvature - rod.natural_curvature).max())
    if np.any(rod.natural_curvature):
        return note(
            "Bending changes the curvature by {change} 1/mm, above the limit of {most} 1/mm.",
            change=rounded_up(largest, 3),
            most=rounded_down(limit, 3),
        )
    return note(
        "The smallest radius is {radius}, below the limit of {least}.",
        least=Length(rounded_up(1 / limit, 3)),
        radius=Length(rounded_down(1 / largest, 3)),
    )


STRAIN = ActiveLimit("strain", title="the strain limit of the sheet (use a thinner sheet)", unit="number")


@dataclass(frozen=True)
class HalfPlane:
    """A half plane that the rod must not enter, such as the ground or a wall.

    Points x are allowed if <normal, x - point> >= 0.

    Parameters
    ----------
    point : (2,) array_like
        A point on the border, mm.
    normal : (2,) array_like
        Vector to the allowed side, of any length except 0.

    Examples
    --------
    >>> HalfPlane((0, 0), (0, 2)).normal
    (0.0, 1.0)
    """

    point: Annotated[tuple[float, float], Option("Point on the wall.", "mm")] = (0.0, 0.0)
    normal: Annotated[tuple[float, float], Option("Direction from the wall to the allowed side.")] = (
        0.0,
        1.0,
    )

    def __post_init__(self) -> None:
        point, normal = (
            pair(self.point, "point of a half plane"),
            pair(self.normal, "normal of a half plane"),
        )
        size = float(norm(normal))
        if size == 0:
            raise InputError("the normal of a half plane is zero: give the direction of the allowed side")
        vars(self).update(point=tuple(point.tolist()), normal=tuple((normal / size).tolist()))

    def clearance(self, points: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return the signed distances (n,) of points (n, 2) from the border, and their gradients (n, 2).

        Distances are positive on the allowed side.
        """
        return (points - self.point) @ self.normal, np.broadcast_to(self.normal, points.shape)


@dataclass(frozen=True)
class Box:
    """Rectangle with edges along x and y that the rod must not enter.

    Parameters
    ----------
    lower, upper : (2,) array_like
        Opposite corners, mm.
    """

    lower: Annotated[tuple[float, float], Option("Corner with the smallest x and y.", "mm")]
    upper: Annotated[tuple[float, float], Option("Corner with the largest x and y.", "mm")]

    def __post_init__(self) -> None:
        lower, upper = pair(self.lower, "lower corner of a box"), pair(self.upper, "upper corner of a box")
        if np.any(lower >= upper):
            raise InputError(
                f"the corners of a box are {lower.tolist()} and {upper.tolist()}: give the lower left corner first"
            )
        vars(self).update(lower=tuple(lower.tolist()), upper=tuple(upper.tolist()))

    def clearance(self, points: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return the signed distances (n,) of points (n, 2) from the box, and their gradients (n, 2).

        They are positive outside the box. Inside, they are minus the distance from the nearest side.
        """
        below, above = self.lower - points, points - self.upper
        off = np.maximum(below, above)
        outermost = off.max(axis=1, keepdims=True)
        # outside, the distances from the box in x and y; inside, 1 for the direction of the nearest side
        outward = np.where(outermost > 0, np.maximum(off, 0), off == outermost)
        size = norm(outward)
        gradient = np.where(above > below, 1.0, -1.0) * outward / size[:, None]
        return np.where(outermost[:, 0] > 0, size, outermost[:, 0]), gradient


Row: TypeAlias = tuple[float, ...]


def _bounds_along_strip(
    lower: Annotated[
        float | Row | None,
        Option(
            "Lower bound: one number for the whole strip, or numbers at equal distances along it.", least=1
        ),
    ] = None,
    upper: Annotated[
        float | Row | None,
        Option(
            "Upper bound: one number for the whole strip, or numbers at equal distances along it.", least=1
        ),
    ] = None,
) -> tuple[float | Row | None, float | Row | None]:
    """Bounds of the stiffness along the strip, as multiples of the least stiffness."""
    return lower, upper


@dataclass(frozen=True, eq=False)
class Limits:
    """Limits of material, machine and space. None means no limit.

    Parameters
    ----------
    ratio : float, optional
        Largest ratio of largest to least stiffness, at least 1.
    margin : float, optional
        Least stability margin (see `stability`). A strip is stable above 0, and safely stable from 5. For a
        strip that bends as a plate, the margin depends on the widths. The largest width may then be a few
        percent less than its limit.
    curvature : float, optional
        Largest change of curvature by bending, 1/mm.
    sheet : Sheet, optional
        Sheet whose strain limit bounds the change of curvature by 2 strain / thickness.
    strain : float, optional
        Strain limit in place of the limit of the sheet; requires `sheet`, for its thickness.
    width : (2,) array_like, optional
        Least and largest width of a solid strip, mm. The quotient of both widths limits the stiffness ratio.
    length : (2,) array_like, optional
        Least and largest length of the strip, mm.
    keep_out : sequence of HalfPlane and Box
        Regions that the rod must avoid.
    stiffness_bounds : pair, optional
        Lower and upper bound of stiffness / least stiffness along the strip. Each bound is None, a number, evenly
        spaced values, or a function of the arc length on the drawn curve, mm.

    Examples
    --------
    >>> Limits(ratio=5.0, width=(10, 30)).largest_ratio
    3.0
    """

    ratio: Annotated[
        float | None,
        Option(
            "Largest stiffness ratio: the widest place is at most this many times as stiff as the narrowest.",
            least=1,
            group="limits",
            common=True,
        ),
    ] = None
    margin: Annotated[
        float | None,
        Option(
            "Least stability margin. A strip is stable above 0, and safely stable from 5.",
            group="limits",
            common=True,
        ),
    ] = None
    curvature: Annotated[float | None, Option("Largest curvature.", "1/mm", above=0, group="limits")] = None
    sheet: Sheet | None = None
    strain: Annotated[
        float | None,
        Option(
            "Largest strain: a number such as 0.005, or true for the largest strain that the sheet allows.",
            above=0,
            group="limits",
            common=True,
            written=bool | float,
        ),
    ] = None
    width: Annotated[
        tuple[float, float] | None,
        Option("Least and largest width; they limit the stiffness ratio.", "mm", above=0, group="limits"),
    ] = None
    length: Annotated[
        tuple[float, float] | None, Option("Least and largest length.", "mm", above=0, group="limits")
    ] = None
    keep_out: Annotated[
        tuple[HalfPlane | Box, ...],
        Option("Ground, walls and boxes that the strip must avoid.", group="limits"),
    ] = ()
    stiffness_bounds: Annotated[
        tuple[Bound, Bound] | None,
        Option(
            "Bounds of the stiffness along the strip, divided by its least value.",
            group="limits",
            written=_bounds_along_strip,
        ),
    ] = None

    def __post_init__(self) -> None:
        require_declared(Limits, vars(self), "limit")
        require_record(
            self.sheet, Sheet | None, "the sheet of the limits", 'a Sheet, such as Sheet.named("pom-1")'
        )
        if self.strain is not None:
            require_positive(self.strain, "limit strain", "mm/mm")
            if self.sheet is None:
                raise InputError(
                    "a strain limit needs the thickness of a sheet, because the allowed curvature is 2 "
                    "strain / thickness: set `sheet`"
                )
        for name in ("width", "length"):
            if getattr(self, name) is None:
                continue
            low, high = getattr(self, name)
            if low > high:
                raise InputError(f"the limit of the {name} is {low} to {high}: give the smaller number first")
            object.__setattr__(self, name, (float(low), float(high)))
        keep_out = several("keep_out", self.keep_out, HalfPlane | Box, "HalfPlane or Box")
        object.__setattr__(self, "keep_out", keep_out)
        bounds = self.stiffness_bounds
        if bounds is not None and not (isinstance(bounds, (tuple, list)) and len(bounds) == 2):
            raise InputError("stiffness_bounds are not a pair: give (lower, upper), with None for no bound")

    @property
    def largest_ratio(self) -> float:
        """Largest stiffness ratio that both `ratio` and `width` allow."""
        by_width = UNLIMITED_RATIO if self.width is None else self.width[1] / self.width[0]
        return float(min(UNLIMITED_RATIO if self.ratio is None else self.ratio, by_width))

    def at_places(self, *, strain: bool) -> Iterator[PlaceLimit]:
        """Yield the limits that each place of a strip meets by itself.

        `strain` is True if the strain limit of the sheet bounds the curvature, because no section gives the strain.
        """
        curvature = self.largest_curvature if strain else self.curvature
        if curvature is not None:
            title = "the curvature limit" if curvature == self.curvature else STRAIN.title
            yield PlaceLimit(
                "curvature",
                ActiveLimit("curvature", curvature, title=title, unit="number", sentence=_bend_sentence),
                partial(_room_to_bend, curvature),
                lambda limits, by: limits.tightened(curvature=1 + by),
            )
        active = ActiveLimit("keep-out", title="the keep-out regions", unit="length")
        for region in self.keep_out:
            yield PlaceLimit("keep_out", active, partial(_room_in_region, region))

    @property
    def largest_curvature(self) -> float | None:
        """Largest change of curvature that `curvature`, `sheet` and `strain` allow, 1/mm."""
        limits = [] if self.curvature is None else [self.curvature]
        if self.sheet is not None:
            strain = self.sheet.max_strain if self.strain is None else self.strain
            limits.append(2 * strain / self.sheet.thickness)
        return min(limits) if limits else None

    def tightened(self, *, curvature: float = 1.0, strain: float = 1.0) -> "Limits":
        """Return the limits with the largest curvature and the strain limit divided by these factors.

        Examples
        --------
        >>> Limits(curvature=0.02).tightened(curvature=2).curvature
        0.01
        """
        require_positive(curvature, "what limits of curvature are tightened by", "times")
        require_positive(strain, "what limits of strain are tightened by", "times")
        tight = self
        if tight.curvature is not None:
            tight = replace(tight, curvature=tight.curvature / curvature)
        if tight.sheet is not None and strain != 1:
            tight = replace(tight, strain=(tight.strain or tight.sheet.max_strain) / strain)
        return tight


BOTH_ENDS: dict[str, bool | tuple[bool, bool]] = {
    "both": True, "start": (True, False), "end": (False, True), "none": False,
}  # fmt: skip
"""Values of `Keep.ends` by name: one flag for both ends, or flags for (start, end)."""


@dataclass(frozen=True, eq=False)
class Keep:
    """Properties of the drawn curve that the nearest rod must have.

    Parameters
    ----------
    ends, tangents : bool or (bool, bool)
        True to keep the positions or the tangents at both ends, or a pair for (start, end).
    length : bool
        True to keep the length.
    symmetry : "mirror", "turn" or None
        Symmetry of the drawn curve, by reflection or by rotation by 180 degrees, that the rod must have exactly.
    points : sequence of float
        Arc lengths on the drawn curve, mm, of points through which the rod must pass.
    line : True, or two points
        The inflections of the rod must be on the inflection line of the drawn curve, or on the line through two
        points, mm.

    Examples
    --------
    >>> Keep(tangents=(True, False)).tangents
    (True, False)
    """

    ends: Annotated[
        bool | tuple[bool, bool],
        Option(
            "Keep the positions of both ends: true or false, or a pair for start and end.",
            group="limits",
            common=True,
        ),
    ] = True
    tangents: Annotated[
        bool | tuple[bool, bool],
        Option(
            "Keep the tangents of both ends: true or false, or a pair for start and end.",
            group="limits",
            common=True,
        ),
    ] = False
    length: Annotated[bool, Option("Keep the length.", group="limits", common=True)] = False
    symmetry: Annotated[
        Symmetry | None, Option("Symmetry to keep: mirror image or half turn.", group="limits")
    ] = None
    points: Annotated[
        tuple[float, ...],
        Option("Places on the drawn curve that the strip must pass through.", "mm", many=100, group="limits"),
    ] = ()
    line: Annotated[
        bool | tuple[tuple[float, float], tuple[float, float]] | None,
        Option(
            "Keep the inflections on their line, or on the line through two points.", "mm", group="limits"
        ),
    ] = None

    def __post_init__(self) -> None:
        for name in ("ends", "tangents"):
            value = getattr(self, name)
            alone = isinstance(value, (bool, np.bool_))
            both = (value, value) if alone else tuple(value) if is_series(value) else ()
            if len(both) != 2 or not all(isinstance(v, (bool, np.bool_)) for v in both):
                raise InputError(f"`keep.{name}` is {value!r}: use True, False, or a pair for (start, end)")
            object.__setattr__(self, name, (bool(both[0]), bool(both[1])))
        require_declared(Keep, vars(self), "keep")
        points = np.atleast_1d(numbers(self.points, "keep points"))
        if points.ndim != 1 or not np.all(np.isfinite(points)):
            raise InputError(
                "`keep.points` are not a row of finite numbers: give arc lengths on the drawn curve, in mm"
            )
        object.__setattr__(self, "points", tuple(points.tolist()))
        if self.line is None or isinstance(self.line, bool):
            return
        line = numbers(self.line, "keep line")
        if line.shape != (2, 2) or not np.all(np.isfinite(line)) or np.all(line[0] == line[1]):
            raise InputError(
                "`keep.line` is not a line: give True, or two different finite points ((x, y), (x, y)), in mm"
            )
        object.__setattr__(self, "line", tuple(map(tuple, line.tolist())))

    @property
    def both_ends(self) -> tuple[bool, bool]:
        """For start and end, True if the position is kept."""
        return cast(tuple[bool, bool], self.ends)

    @property
    def both_tangents(self) -> tuple[bool, bool]:
        """For start and end, True if the tangent is kept."""
        return cast(tuple[bool, bool], self.tangents)


def require_limits(limits: object, keep: object) -> None:
    """Raise InputError unless `limits` and `keep` are of type `Limits` and `Keep`, or None."""
    require_record(limits, Limits | None, "limits", "a Limits record, or None")
    require_record(keep, Keep | None, "keep", "a Keep record, or None")
