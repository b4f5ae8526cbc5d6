"""Loads of a rod (gravity, masses and weight per length), supports of its ends, and its natural curvature."""

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from itertools import product
from typing import Annotated, Literal, TypeAlias, cast

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import ArrayLike, BoolArray, FloatArray
from elastica_cad._values import (
    EqualByValue,
    alike,
    as_floats,
    is_number,
    is_series,
    is_whole,
    numbers,
    pair,
    require_number,
    require_positive,
    several,
    with_article,
)
from elastica_cad.declared import Option
from elastica_cad.errors import FieldName, InputError, Length, Point, note, quoted
from elastica_cad.geometry.plane_curve import ROUNDED_END_SHARE, CurvatureZero, PlaneCurve
from elastica_cad.geometry.profile import Profile
from elastica_cad.geometry.splines import finite


@dataclass(frozen=True)
class Gravity:
    """Weight of a strip whose weight per length is proportional to its stiffness.

    Parameters
    ----------
    length : float
        Elasto-gravity length (E h^2 / (12 rho g))^(1/3), mm, for Young's modulus E, thickness h and density rho
        (paper, section 5.1).
    direction : (2,) array_like
        Direction of gravity in the plane of the curve; the length of this vector has no effect.

    Examples
    --------
    >>> Gravity(96.0, (3, -4)).e.round(9).tolist()  # opposite to gravity, 1/mm3
    [-6.78e-07, 9.04e-07]
    """

    length: Annotated[
        float,
        Option("Elasto-gravity length; by default, the value of the sheet.", "mm", least=0, group="weight"),
    ]
    direction: Annotated[
        tuple[float, float],
        Option("Direction of gravity in the plane of the curve.", group="weight"),
    ] = (0.0, -1.0)

    def __post_init__(self) -> None:
        if not (is_number(self.length) and self.length > 0):
            raise InputError(
                f"the elasto-gravity length is {self.length!r}: give a positive number in mm "
                "(200 gsm card: 96)"
            )
        d = as_floats(self.direction)
        if d is None or d.shape != (2,) or not np.isfinite(d).all() or not d.any():
            raise InputError(
                f"the direction of gravity is {self.direction!r}: give two numbers, not both zero, e.g. "
                "(0, -1)"
            )
        d = d / np.hypot(*d)
        object.__setattr__(self, "direction", tuple(d.tolist()))

    @classmethod
    def in_plane(
        cls, length: float, direction: ArrayLike, x_axis: ArrayLike, y_axis: ArrayLike
    ) -> "Gravity | None":
        """Return gravity in a plane in space, or None if `direction` (3,) is perpendicular to the plane."""
        d, *axes = (
            numbers(vector, name)
            for vector, name in ((direction, "gravity direction"), (x_axis, "x axis"), (y_axis, "y axis"))
        )
        if any(row.shape != (3,) for row in (d, *axes)) or not 0 < np.abs(d).max() < np.inf:
            raise InputError(
                "gravity in a plane needs a direction and two axes: give three numbers for each, not all 0"
            )
        require_positive(length, "gravity length")
        d = d / np.linalg.norm(d)
        part = np.array([d @ axis for axis in axes])
        size = float(np.hypot(*part))
        if size < 1e-9:
            return None
        return cls(length / size ** (1 / 3), (float(part[0]), float(part[1])))

    @property
    def e(self) -> FloatArray:
        """Vector e of the paper's Eq. 5, 1/mm3, opposite to gravity (the paper has the wrong sign)."""
        return -np.asarray(self.direction) / self.length**3

    def scaled(self, factor: float) -> "Gravity":
        """Return gravity with the weight multiplied by `factor`."""
        require_positive(factor, "the factor of a gravity", "times the weight")
        return Gravity(self.length / factor ** (1 / 3), self.direction)


STANDARD_GRAVITY_M_S2 = 9.80665

Place: TypeAlias = float | tuple[float, float]
"""Arc length along the drawn curve, mm, or a point (x, y) near the curve, mm."""


def require_place(at: object, owner: str) -> Place:
    """Return an arc length as a number or a point as two numbers; refuse other values."""
    if is_number(at):
        return float(at)
    try:
        x, y = pair(at, "place").tolist()
    except InputError:
        raise InputError(
            f"The place of {owner} is {quoted(at)}, neither a finite number nor a point. Give the arc length in "
            "mm, or a point (x, y) on the curve."
        ) from None
    return x, y


@dataclass(frozen=True)
class PointMass:
    """Point mass on the rod: `mass` in g at arc length `at` in mm, or at the point (x, y) near the curve."""

    at: Annotated[Place, Option("Place along the curve, or a point (x, y) near it.", "mm")]
    mass: Annotated[float, Option("Mass hung at this place.", "g", least=0)]

    def __post_init__(self) -> None:
        object.__setattr__(self, "at", require_place(self.at, "a point mass"))
        if not (is_number(self.mass) and self.mass >= 0):
            raise InputError("a point mass is {mass!r}: give 0 or more, in g", mass=self.mass)

    @property
    def s(self) -> float:
        """Arc length of the mass, mm. A mass at a point (x, y) must first be moved to a curve."""
        if isinstance(self.at, tuple):
            raise InputError(
                "The place of a point mass is the point {point}. Give its distance along the rod from the start "
                "instead, in mm.",
                point=Point(self.at),
            )
        return self.at

    @property
    def newtons(self) -> float:
        """Weight of the mass, N."""
        return self.mass * 1e-3 * STANDARD_GRAVITY_M_S2


@dataclass(frozen=True, eq=False)
class Weight:
    """Weight per length alpha(s) + beta(s) K(s), and point masses.

    Parameters
    ----------
    alpha, beta : float or Profile
        Weight per length, N/mm; `beta` is multiplied by the relative stiffness K, whose least value is 1.
    masses : tuple of PointMass
        Masses on the strip, for example a lamp holder.
    own : bool
        If True, `optimal_rod` adds the weight of the strip itself to `beta`: B / l^3 for the least bending
        stiffness B and the elasto-gravity length l, `gravity.length`. In the weight of the returned rod, `own` is
        False and `beta` includes this weight.
    """

    alpha: Annotated[float | Profile, Option("Weight per length.", "N/mm", least=0, written=float)] = 0.0
    beta: Annotated[
        float | Profile,
        Option(
            "Weight per length for a stiffness of K = 1; the weight is proportional to K.",
            "N/mm",
            least=0,
            written=float,
        ),
    ] = 0.0
    masses: Annotated[tuple[PointMass, ...], Option("Masses hung on the strip.")] = ()
    own: Annotated[bool, Option("Add the strip's own weight.")] = False

    def __post_init__(self) -> None:
        object.__setattr__(self, "masses", several("masses", self.masses, PointMass, "PointMass"))
        for name in ("alpha", "beta"):
            value = getattr(self, name)
            # a Profile may be negative, such as the linearised weight of a section
            if not isinstance(value, Profile) and not (is_number(value) and value >= 0):
                raise InputError(f"weight {name} is {value!r}: give 0 or more, in N/mm")

    def scaled(self, alpha: float = 1.0, beta: float = 1.0) -> "Weight":
        """Return the weight with alpha and beta multiplied by the factors. The point masses do not change."""
        return replace(self, alpha=_times(self.alpha, alpha), beta=_times(self.beta, beta))

    def along(self, s: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return alpha and beta (n,), N/mm, of the weight per length alpha + beta K at arc lengths `s` (n,)."""
        s = numbers(s, "s")
        alpha, beta = (
            value(s) if isinstance(value, Profile) else np.full(s.shape, float(value))
            for value in (self.alpha, self.beta)
        )
        return alpha, beta

    def lumped(self, s: FloatArray, stiffness: FloatArray, node_lengths: FloatArray) -> FloatArray:
        """Return the weight of each node (n,), N.

        A point mass is divided between its two neighbouring nodes.
        """
        if self.own:
            raise InputError(
                "only optimal_rod can compute the strip's own weight: give the weight per length as `beta`, "
                "in N/mm, and `own` as False"
            )
        s, stiffness, node_lengths = alike(s=s, stiffness=stiffness, node_lengths=node_lengths)
        if s.ndim != 1 or s.size < 2:
            raise InputError(
                "s is {given}: give the arc lengths of at least two nodes, in mm", given=quoted(s)
            )
        alpha, beta = self.along(s)
        weight = node_lengths * (alpha + beta * stiffness)
        for point in self.masses:
            at = min(max(point.s, 0.0), float(s[-1]))
            if abs(at - point.s) > ROUNDED_END_SHARE * s[-1]:
                raise InputError(
                    (
                        "the point mass at {at:.6g} is beyond the ends of the rod, which is {s:.6g} long: give a "
                        "place along the rod"
                    ),
                    at=Length(point.s),
                    s=Length(s[-1]),
                )
            i = min(int(s.searchsorted(at, side="right")) - 1, s.size - 2)
            share = (at - s[i]) / (s[i + 1] - s[i])
            weight[i] += (1 - share) * point.newtons
            weight[i + 1] += share * point.newtons
        return weight


def _times(value: float | Profile, factor: float) -> float | Profile:
    return value.scaled(factor) if isinstance(value, Profile) else value * factor


EndName: TypeAlias = Literal[
    "clamped", "pinned", "slide-x", "slide-y", "roller-x", "roller-y", "guided", "free"
]


@dataclass(frozen=True)
class End:
    """Coordinates and angle that the support at one end of a rod holds.

    Attributes
    ----------
    x, y : bool
        True if the coordinate is held. An end free in x slides horizontally.
    angle : bool
        True if the tangent is held. If False, the moment at the end is zero, and the curvature equals the natural
        curvature.
    """

    x: bool = True
    y: bool = True
    angle: bool = True

    def __post_init__(self) -> None:
        for name in ("x", "y", "angle"):
            if not isinstance(getattr(self, name), bool | np.bool_):
                raise InputError(
                    f"{name} of an End is {getattr(self, name)!r}: give True where it is held, False where it "
                    "is free"
                )

    @property
    def is_free(self) -> bool:
        """True if the support holds nothing."""
        return not (self.x or self.y or self.angle)

    @classmethod
    def named(cls, name: EndName) -> "End":
        """Return the end of a name.

        A slider moves along x or y and holds the angle, a roller moves along x or y and turns. A guided end holds
        only the angle.
        """
        ends = {
            "clamped": cls(),
            "pinned": cls(angle=False),
            "slide-x": cls(x=False),
            "slide-y": cls(y=False),
            "roller-x": cls(x=False, angle=False),
            "roller-y": cls(y=False, angle=False),
            "guided": cls(x=False, y=False),
            "free": cls(x=False, y=False, angle=False),
        }
        if not isinstance(name, str) or name not in ends:
            raise InputError(f"unknown end support {name!r}: use one of {', '.join(ends)}, or an End record")
        return ends[name]


@dataclass(frozen=True)
class Supports:
    """Supports of both ends; by default both ends are clamped (paper, section 4.1).

    Parameters
    ----------
    start, end : End or str
        An `End`, or a name that `End.named` accepts.

    Examples
    --------
    >>> Supports("clamped", "pinned").end
    End(x=True, y=True, angle=False)
    """

    start: End | EndName = field(default_factory=End)
    end: End | EndName = field(default_factory=End)

    def __post_init__(self) -> None:
        for side in ("start", "end"):
            value: End | EndName = getattr(self, side)
            if isinstance(value, str):
                object.__setattr__(self, side, End.named(value))
            elif not isinstance(value, End):
                raise InputError(f"the support of the {side} is {value!r}: give a name or an End record")

    @property
    def ends(self) -> tuple[End, End]:
        """Both ends as `End` records."""
        return cast(End, self.start), cast(End, self.end)  # `__post_init__` has replaced names by records

    @property
    def held(self) -> BoolArray:
        """Flags (6,) for x, y and angle of the start and of the end: True if the support holds this."""
        return np.array([flag for end in self.ends for flag in (end.x, end.y, end.angle)])

    @property
    def is_free(self) -> bool:
        """True if both ends are free, as in a bow."""
        return all(end.is_free for end in self.ends)

    def require_held(
        self,
        between: Sequence[Sequence[float]] = (),
        *,
        upright: bool = False,
    ) -> None:
        """Refuse a rod that can move as a whole, and name the fewest supports that hold the rod.

        Parameters
        ----------
        between : sequence of (float, float, float)
            Unit reactions of rails and pins: forces in x and y, and the moment about the start over the length.
        upright : bool
            True if the ends of the rod are farther apart in y than in x.
        """
        rows = numbers(between, "reactions")
        if rows.size % 3:
            raise InputError(f"the reactions have the shape {rows.shape}: give three numbers for each")
        between = rows.reshape(-1, 3).tolist()
        free = _free_motions(self, between)
        if not free.any():
            return
        rollers: tuple[EndName, ...] = ("roller-y", "roller-x") if upright else ("roller-x", "roller-y")
        names: tuple[EndName, ...] = ("pinned", *rollers, "free", "guided", "slide-x", "slide-y", "clamped")

        def holds(supports: Supports) -> bool:
            return bool((supports.held >= self.held).all()) and not _free_motions(supports, between).any()

        # prefer few held coordinates, and positions to angles, because an angle that is held also bends the rod
        pairs = sorted(product(names, names), key=lambda pair: Supports(*pair).held @ (1, 1, 1.5, 1, 1, 1.5))
        start, end = next(pair for pair in pairs if holds(Supports(*pair)))
        motions = note("move along x"), note("move along y"), note("turn")
        raise InputError(
            "The rod is free to {motion}, because no support, rail or pin prevents this. Set {start_field} to "
            "{start} and {end_field} to {end}.",
            motion=motions[free.argmax()],
            start_field=FieldName("supports.start"), start=start, end_field=FieldName("supports.end"), end=end,
        )  # fmt: skip

    @property
    def clamped(self) -> bool:
        """True if both ends hold position and angle."""
        return self.ends == (End(), End())

    @property
    def transmits_force(self) -> tuple[bool, bool]:
        """Flags for x and y: True if both ends hold the coordinate, so that they can exert a constant force."""
        a, b = self.ends
        return a.x and b.x, a.y and b.y

    @property
    def free_axes(self) -> tuple[bool, bool]:
        """Flags for x and y: True if no end holds the coordinate, so that the whole rod can move along the axis."""
        a, b = self.ends
        return not (a.x or b.x), not (a.y or b.y)

    def reversed(self) -> "Supports":
        """Return the supports of the rod with start and end exchanged."""
        return Supports(self.end, self.start)


def turning_nodes(supports: Supports) -> list[int]:
    """Return the indices, 0 and -1, of the end nodes at which the supports leave the angle free."""
    return [node for node, end in zip((0, -1), supports.ends, strict=True) if not end.angle]


# unit reactions of x, y and angle at the start and the end; the end of a bent rod is beside and above the start
_REACTIONS = np.array([(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 0, -1), (0, 1, 1), (0, 0, 1)], dtype=float)

# singular value of unit reactions below which they do not hold a rod
_LEAST_HOLD = 1e-6


def _free_motions(supports: Supports, between: Sequence[Sequence[float]]) -> FloatArray:
    """Return how freely (3,) the whole rod moves along x, along y and turns: 1 freely, 0 not at all."""
    # the part of each unit motion that is not in the span of the reactions
    reactions = np.vstack([_REACTIONS[supports.held], *between])
    free = 1 - np.einsum("ij,ji->i", np.linalg.pinv(reactions, rcond=_LEAST_HOLD), reactions)
    return np.where(free > _LEAST_HOLD, free, 0.0)


def require_curve(curve: object) -> None:
    """Refuse objects that are not a `PlaneCurve`."""
    if not isinstance(curve, PlaneCurve):
        raise InputError(
            f"the curve is {with_article(type(curve))}: give a PlaneCurve, such as PlaneCurve.fit(points)"
        )


def require_curves(curves: object, caller: str, kind: str = "a list") -> None:
    """Refuse a single curve, and what is not a series. `caller` is the name of a function for the message."""
    if isinstance(curves, PlaneCurve) or not is_series(curves):
        raise InputError(f"{caller} was called with {with_article(type(curves))}: give {kind} of curves")


def require_gravity(gravity: object) -> None:
    """Refuse objects other than a `Gravity` or None."""
    if not (gravity is None or isinstance(gravity, Gravity)):
        raise InputError(
            f"gravity is {gravity!r}: give a Gravity record, such as sheet.gravity() or "
            "Gravity(96.0), or None"
        )


def require_supports(supports: object, *, between: bool = False) -> Supports:
    """Return the supports; None means clamped at both ends.

    `between` is True if rails, pins or ties between the ends also support the rod.
    """
    if supports is None:
        return Supports()
    if not isinstance(supports, Supports):
        raise InputError(
            f'supports is {supports!r}: give a Supports record, such as Supports("clamped", "pinned")'
        )
    if not between:
        supports.require_held()
    return supports


def require_tolerance(tolerance: object) -> None:
    """Refuse a tolerance that is negative or not a number."""
    if not (is_number(tolerance) and tolerance >= 0):
        raise InputError(f"tolerance is {tolerance!r}: give a fraction of the curve's length, 0 or more")


def require_ratio(ratio: object, name: str) -> None:
    """Refuse a limit of the stiffness ratio max K / min K that is below 1 or not a number."""
    if not (is_number(ratio) and ratio >= 1):
        raise InputError(
            (
                "{name} is {ratio}, but the ratio of largest to least stiffness is at least 1: give a "
                "larger number, such as 2 to 4 for plain strips"
            ),
            name=name,
            ratio=ratio,
        )


MOST_COUNTED = 1_000_000
"""Largest number of nodes or samples; a larger number would not fit into memory."""


def whole_number(value: object, name: str, least: int) -> int:
    """Return a whole number of at least `least`; refuse fractions, texts and booleans."""
    if not is_whole(value) or value < least:
        raise InputError(
            "{name} is {given!r}: give a whole number, {least} or more",
            name=name,
            given=value,
            least=least,
        )
    if value > MOST_COUNTED:
        raise InputError(
            "{name} is {given}: give a whole number, {most_counted} at most",
            name=name,
            given=quoted(value),
            most_counted=MOST_COUNTED,
        )
    return int(value)


LENGTHS_APART = 0.01
"""A pre-bent strip is scaled to the length of the curve if both lengths differ by at most this fraction."""

_CURVATURE_SAMPLES = 401
# positions closer to a break than this fraction of the length are at the break
_AT_BREAK_SHARE = 1e-9


@dataclass(frozen=True, eq=False)
class RestCurvature(EqualByValue):
    """Natural curvature kappa_0 along a strip.

    Attributes
    ----------
    profile : Profile
        Curvature kappa_0, 1/mm, as a function of arc length along the pre-bent strip, mm.

    Examples
    --------
    >>> blank = RestCurvature.linear([0, 150, 300], [0, 0.002, 0])
    >>> blank.length, float(blank.profile(75.0))
    (300.0, 0.001)
    """

    profile: Profile

    def __post_init__(self) -> None:
        if not isinstance(self.profile, Profile) or self.profile.knots[0] != 0.0:
            raise InputError(
                "the curvature of a pre-bent strip needs a Profile that begins at 0 mm: use "
                "RestCurvature.linear(stations, curvatures), or RestCurvature.of(curve) for a drawn "
                "pre-bent strip"
            )

    @classmethod
    def linear(cls, stations: ArrayLike, curvatures: ArrayLike) -> "RestCurvature":
        """Return the natural curvature that is linear between values (n,), 1/mm, at stations (n,), mm.

        Two equal stations are a jump.
        """
        s, kappa_0 = finite("stations", stations), finite("curvatures", curvatures)
        rising = s.ndim == 1 and s.size >= 2 and s[0] == 0 and (np.diff(s) >= 0).all()
        if s.shape != kappa_0.shape or not rising or (s[2:] == s[:-2]).any() or s[1] == 0 or s[-1] == s[-2]:
            raise InputError(
                "the curvature before bending needs two or more stations, each with a curvature. Begin at 0 "
                "mm and end at the length of the strip. Give a station twice only where the curvature jumps"
            )
        return cls(Profile(np.concatenate([s[:1], s, s[-1:]]), kappa_0, 1))

    @classmethod
    def of(cls, blank: PlaneCurve) -> "RestCurvature":
        """Return the curvature of a pre-bent strip, drawn as seen from the same side as the bent strip."""
        if not isinstance(blank, PlaneCurve):
            raise InputError(f"the pre-bent strip is {blank!r}: give a PlaneCurve, its shape before assembly")
        if blank.tangent_breaks:
            raise InputError(
                "the pre-bent strip has a corner {s:.4g} from its start, but a strip bends without kinks: "
                "round the corner",
                s=Length(blank.tangent_breaks[0].s),
            )
        size = max(float(np.abs(blank.sample(_CURVATURE_SAMPLES).curvature).max()), 1 / blank.length)
        return cls(
            Profile.fit(
                lambda s: blank.at(s).curvature,
                blank.length,
                breaks=[(place.s, place.continuity - 2) for place in blank.breaks],
                tolerance=1e-9 * size,
                degree=5,
            )
        )

    @property
    def length(self) -> float:
        """Length of the strip, mm."""
        return self.profile.length

    def at(self, s: FloatArray, derivative: int = 0, *, left: bool = False) -> FloatArray:
        """Return the natural curvature, 1/mm, or its derivatives at arc lengths s, mm.

        At a jump the result is the value on the right, or on the left with `left`.
        """
        s = s.clip(0.0, self.length)
        for place, _ in self.profile.breaks:
            beside = np.nextafter(place, -1.0) if left else place
            s = np.where(np.abs(s - place) < _AT_BREAK_SHARE * self.length, beside, s)
        return self.profile(s, derivative)

    def stretch_to(self, length: float) -> float:
        """Return the length of the pre-bent strip divided by the `length` of a curve, mm.

        Refuse lengths that differ by more than `LENGTHS_APART`.
        """
        length = require_number(length, "the length of the curve", "mm")
        if abs(length / self.length - 1) > LENGTHS_APART:
            raise InputError(
                "the pre-bent strip is {length:.5g} long, but the curve is {length_2:.5g} long: give the "
                "curvature of the pre-bent strip along the length of the curve",
                length=Length(self.length),
                length_2=Length(length),
            )
        return self.length / length


@dataclass(frozen=True, eq=False)
class CurveOfRest(RestCurvature):
    """Curvature of a drawn pre-bent strip, evaluated exactly on the drawn curve.

    Attributes
    ----------
    blank : PlaneCurve
        Shape of the pre-bent strip; it has the same breaks as the `profile`.
    """

    blank: PlaneCurve

    @classmethod
    def of(cls, blank: PlaneCurve) -> "CurveOfRest":
        """Return the curvature of a pre-bent strip; see `RestCurvature.of`."""
        return cls(RestCurvature.of(blank).profile, blank)

    def at(self, s: FloatArray, derivative: int = 0, *, left: bool = False) -> FloatArray:
        """Return the natural curvature at arc lengths s, or its first derivative; see `RestCurvature.at`."""
        t = self.blank.parameter(s.clip(0.0, self.blank.length))
        for knot in self.blank.breaks:
            t = np.where(np.abs(s - knot.s) < _AT_BREAK_SHARE * self.length, knot.t, t)
        along = self.blank.curvature_slope_at if derivative else self.blank.curvature_at
        return along(t, left=left)


NaturalCurvature: TypeAlias = float | RestCurvature
"""Natural curvature: a value for the whole strip, 1/mm, or a curvature that varies along the strip."""


def nodal_curvature(rest: NaturalCurvature, s: FloatArray) -> float | FloatArray:
    """Return the natural curvature, 1/mm, at the nodes `s` (n,), mm: (n,) or one number."""
    return rest.at(s * rest.stretch_to(float(s[-1]))) if isinstance(rest, RestCurvature) else rest


def require_natural_curvature(value: object) -> None:
    """Refuse values other than a finite number or a `RestCurvature`."""
    if not (isinstance(value, RestCurvature) or is_number(value)):
        raise InputError(
            f"natural_curvature is {value!r}: give a finite number, in 1/mm, or a RestCurvature for a "
            "pre-bent strip"
        )


def require_gentle_pre_bend(natural_curvature: NaturalCurvature, thickness: float) -> None:
    """Raise InputError if the radius of a pre-bent strip is not larger than its thickness, mm."""
    bent = (
        max(map(abs, natural_curvature.profile.extremes))
        if isinstance(natural_curvature, RestCurvature)
        else abs(natural_curvature)
    )
    if bent * thickness >= 1:
        raise InputError(
            "the strip is pre-bent to a radius of {radius:.3g}, but the radius must be larger than the thickness "
            "of the sheet, {thickness:g}: set a smaller {field} (in 1/mm), or choose a thinner sheet",
            radius=Length(1 / bent), thickness=Length(thickness), field=FieldName("natural_curvature"),
            where={"field": "natural_curvature"},
        )  # fmt: skip


@dataclass(frozen=True, eq=False)
class ExcessCurvature:
    """Change of curvature kappa - kappa_0 by which a strip with natural curvature kappa_0 is bent into a curve.

    Attributes
    ----------
    curve : PlaneCurve
    rest : float or RestCurvature
    """

    curve: PlaneCurve
    rest: NaturalCurvature

    @property
    def is_bent_beforehand(self) -> bool:
        """Return True if the strip has a natural curvature."""
        return isinstance(self.rest, RestCurvature) or self.rest != 0

    def at(self, t: ArrayLike, *, left: bool = False) -> FloatArray:
        """Return the curvature minus the natural curvature, 1/mm, at parameters t."""
        return self.curve.curvature_at(t, left=left) - self.rest_at(t, left=left)

    def slope_at(self, t: ArrayLike, *, left: bool = False) -> FloatArray:
        """Return the derivative of curvature minus natural curvature by arc length, 1/mm2, at parameters t."""
        return self.curve.curvature_slope_at(t, left=left) - self.rest_at(t, 1, left=left)

    def rest_at(self, t: ArrayLike, derivative: int = 0, *, left: bool = False) -> FloatArray | float:
        """Return the natural curvature, 1/mm, or its derivative by arc length, at parameters t of the curve."""
        if not isinstance(self.rest, RestCurvature):
            return 0.0 if derivative else self.rest
        s = self.curve.arc_length(t) * self._stretch
        return self.rest.at(s, derivative, left=left) * self._stretch**derivative

    @cached_property
    def survey(self) -> FloatArray:
        """Curvature minus natural curvature (n,), 1/mm, at the sample points of the curve."""
        nodes = self.curve.survey
        return nodes.curvature - self.rest_at(nodes.t)

    @cached_property
    def kinks(self) -> tuple[tuple[float, float, int], ...]:
        """Kinks of the natural curvature, each (parameter, arc length in mm, number of continuous derivatives).

        The number is 0 at a corner and -1 at a jump.
        """
        if not isinstance(self.rest, RestCurvature):
            return ()
        s = np.array([s for s, _ in self.rest.profile.breaks]) / self._stretch
        orders = [continuity for _, continuity in self.rest.profile.breaks]
        return tuple(zip(self.curve.parameter(s).tolist(), s.tolist(), orders, strict=True))

    @cached_property
    def zeros(self) -> tuple[CurvatureZero, ...]:
        """All zeros and sign changes of curvature minus natural curvature, in order along the curve."""
        return self.equals(0.0)

    def equals(self, level: float) -> tuple[CurvatureZero, ...]:
        """Return the points at which curvature minus natural curvature equals `level`, 1/mm."""
        if not isinstance(self.rest, RestCurvature):
            return self.curve.curvature_equals(self.rest + level)
        # a kink with -1 continuous derivatives is a jump of the natural curvature
        breaks = [(t, order >= 0) for t, _, order in self.kinks]
        # the largest sum of |curvature| and |natural curvature| is the scale of rounding errors
        t = np.linspace(*self.curve.domain, _CURVATURE_SAMPLES)
        size = float((np.abs(self.curve.curvature_at(t)) + np.abs(self.rest_at(t))).max())
        return self.curve.zeros_along(lambda t: self.at(t) - level, size, breaks)

    @cached_property
    def _stretch(self) -> float:
        return self.rest.stretch_to(self.curve.length) if isinstance(self.rest, RestCurvature) else 1.0
