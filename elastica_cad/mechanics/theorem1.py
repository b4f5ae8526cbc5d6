"""Conditions on the curvature by Theorem 1 of the paper, and result of the check whether a curve is realizable."""

from collections.abc import Iterable, Sequence
from dataclasses import asdict, dataclass, field, replace
from typing import Any, TypeGuard

import numpy as np

from elastica_cad._text import html_text
from elastica_cad._types import FloatArray
from elastica_cad._values import numbers, pair, require_number
from elastica_cad.errors import (
    Angle,
    Change,
    Degrees,
    ElasticaError,
    FieldName,
    InputError,
    Length,
    Listed,
    Refusal,
    note,
    sentences,
)
from elastica_cad.geometry.fairing import smooth_for_corners
from elastica_cad.geometry.measured_points import REPORTED_MM, MeasuredPoints, Provenance
from elastica_cad.geometry.plane_curve import Break, CurvatureZero, PlaneCurve, TangentBreak, clamp_ends
from elastica_cad.geometry.plane_points import SMOOTH_TURN, left_of, norm
from elastica_cad.geometry.tangent_healing import Turn
from elastica_cad.mechanics.loads import (
    ExcessCurvature,
    NaturalCurvature,
    RestCurvature,
    Supports,
    require_curve,
)


@dataclass(frozen=True)
class InflectionLine:
    """Line of all points x at which a + <b, x> is zero, with a unit vector b.

    Attributes
    ----------
    point : (2,) tuple
        Point on the line, mm.
    direction : (2,) tuple
        Unit vector along the line.
    """

    point: tuple[float, float]
    direction: tuple[float, float]

    @classmethod
    def of_moment(cls, moment: float, b: FloatArray, position: FloatArray) -> "InflectionLine":
        """Return the line on which the moment, `moment` + <b, x - position>, is zero."""
        b, position = pair(b, "b"), pair(position, "position")
        size = norm(b)
        foot = position - b * require_number(moment, "moment") / size**2
        return cls((float(foot[0]), float(foot[1])), (float(b[1] / size), float(-b[0] / size)))

    @property
    def b(self) -> FloatArray:
        """Unit normal (2,) of the line: its direction turned to the left by 90 degrees."""
        return left_of(self.direction)

    @property
    def a(self) -> float:
        """Constant a, mm, of the equation a + <b, x> = 0 of the line."""
        return -float(self.b @ self.point)

    def distance(self, position: FloatArray) -> FloatArray:
        """Return the signed distances (n,), mm, of points (n, 2) from the line."""
        points = numbers(position, "positions")
        if points.shape[-1:] != (2,):
            raise InputError(f"positions have the shape {points.shape}: give points (n, 2), in mm")
        return np.asarray((points - self.point) @ self.b)

    def as_dict(self) -> dict[str, Any]:
        """Return the line as numbers and lists for a report."""
        return {
            "point": list(self.point),
            "direction": list(self.direction),
            "a": self.a,
            "b": self.b.tolist(),
        }


@dataclass(frozen=True)
class FittedVerdict:
    """Result of Theorem 1 for a curve that was fitted to points.

    Attributes
    ----------
    realizable : bool
        True if a strip can have the shape of this curve.
    distance : float
        Largest distance of a point from the curve, mm.
    inflections : int
        Number of inflections of the curve.
    """

    realizable: bool
    distance: float
    inflections: int


@dataclass(frozen=True)
class Undecided:
    """Two curves through the same points that differ in their result or inflections.

    `str()` returns a message with an instruction, and `details` the numbers.

    Attributes
    ----------
    resolution : float
        Rounding error of a point, mm, estimated from its number of decimals.
    fit, other : FittedVerdict
        Results for the checked curve and for another curve. If no strip can have the shape of either curve, the
        other curve lacks inflections that make the checked curve impossible.
    """

    resolution: float
    fit: FittedVerdict
    other: FittedVerdict

    def __str__(self) -> str:
        return note(
            "The points are too few or too inexact to decide how many inflections the curve has. Set {smooth} to "
            "smooth the points, or give more points or decimals."
            if self.fit.realizable == self.other.realizable else
            "The points are too few or too inexact to decide whether a strip can take the curve. Set {smooth} to "
            "smooth the points, or give more points or decimals.",
            smooth=FieldName("smooth"), severity="warning",
        )  # fmt: skip

    @property
    def details(self) -> str:
        """Sentences on the accuracy of the points, the curve through them, and a smoother curve near them."""
        return note(
            "The points are exact to {resolution} only. The fitted curve has {count} inflections; another curve "
            "that fits them too has {others}."
            if self.fit.realizable == self.other.realizable else
            "The points are exact to {resolution} only. The fitted curve (inflections: {count}) can be bent; "
            "another curve that fits them too (inflections: {others}) cannot."
            if self.fit.realizable else
            "The points are exact to {resolution} only. The fitted curve (inflections: {count}) cannot be bent; "
            "another curve that fits them too (inflections: {others}) can.",
            resolution=Length(float(f"{round(self.resolution, 6):.2g}")),
            others=self.other.inflections, count=self.fit.inflections,
        )  # fmt: skip


@dataclass(frozen=True, eq=False)
class EquilibriumCheck:
    """Result of Theorem 1 for a curve; `str()` returns advice to a designer.

    Attributes
    ----------
    realizable : bool
        True if a strip can have the shape of this curve.
    reasons : tuple of str
        Reasons why no strip can have this shape; empty if `realizable`.
    warnings : tuple of str
        Warnings to the designer.
    length : float
        Length of the curve, mm.
    any_stiffness : bool
        True if the curve is straight (or has the natural curvature everywhere), so that every stiffness is
        admissible.
    inflections : tuple of float
        Arc lengths, mm, at which the curvature minus the natural curvature (kappa - kappa_0) changes
        its sign.
    line : InflectionLine or None
        Line through the inflections. For a single inflection it is the middle of the admissible lines. None if
        no line is needed.
    off_line : tuple of (float, float)
        Arc length, mm, of every point through which the line must pass, and the distance of the point from the
        line, mm.
    crossings, touches : tuple of float
        Arc lengths, mm, of inadmissible crossings and contacts between line and curve.
    curvature_touches, jumps : tuple of float
        Arc lengths, mm. At `curvature_touches`, kappa - kappa_0 is zero without a change of sign or with too
        small a slope. At `jumps`, kappa - kappa_0 jumps from one sign to the other.
    flats : tuple of (float, float)
        Start and end of straight pieces, mm.
    moved : float
        Largest displacement, mm, of the curve by moving its inflections onto a line.
    curve : PlaneCurve
        Curve of this check: the drawn curve, or the moved curve.
    zeros : tuple of CurvatureZero
        All zeros of kappa - kappa_0 of `curve`; the moment must be zero there. A straight tail without moment
        has its zero where the bent part begins, of the kind "flat".
    bent_beforehand : bool
        True if the strip is not flat before it is bent.
    undecided : Undecided or None
        Only for a curve that was fitted to points: the comparison with another curve that fits the points
        equally well. The other curve has a different result, or lacks inflections that make this curve impossible.
    """

    realizable: bool
    reasons: tuple[str, ...]
    warnings: tuple[str, ...]
    length: float
    curve: PlaneCurve = field(repr=False)
    any_stiffness: bool = False
    inflections: tuple[float, ...] = ()
    line: InflectionLine | None = None
    off_line: tuple[tuple[float, float], ...] = ()
    crossings: tuple[float, ...] = ()
    touches: tuple[float, ...] = ()
    curvature_touches: tuple[float, ...] = ()
    jumps: tuple[float, ...] = ()
    flats: tuple[tuple[float, float], ...] = ()
    moved: float = 0.0
    zeros: tuple[CurvatureZero, ...] = field(default=(), repr=False)
    bent_beforehand: bool = False
    undecided: Undecided | None = None

    def __repr__(self) -> str:
        verdict = "undecided" if self.undecided else "realizable" if self.realizable else "not realizable"
        return f"<EquilibriumCheck {verdict}, {self.length:.4g} mm>"

    def __str__(self) -> str:
        outlier = outlier_message(self.curve)
        if self.undecided is not None:
            return sentences([*outlier, self.verdict], " ")
        first = [*outlier, self.verdict] if outlier else [self.verdict, *self.points_message]
        kept = [text for text in self.warnings if self.realizable or not is_about_kinks(text)]
        return sentences([*first, *self.reasons, *kept], " ")

    @property
    def details(self) -> tuple[str, ...]:
        """Sentences that explain an undecided result; empty if the result is decided."""
        if self.undecided is None:
            return ()
        return self.undecided.details, *self.points_message, *self.reasons, *self.warnings

    @property
    def cautions(self) -> tuple[str, ...]:
        """Warnings for a finished strip; if the result is undecided, the first warning states this."""
        return self.warnings if self.undecided is None else (str(self.undecided), *self.warnings)

    @property
    def points_message(self) -> tuple[str, ...]:
        """Message about the outlier or the noise of the points to which the curve was fitted."""
        points = measured_points(self.curve)
        if points is None:
            return ()
        # a refused curve has tested changes instead of advice
        noise = (
            points.noise_message
            if self.realizable
            else note("the points have noise of about {noise}", noise=points.rounded_noise)
        )
        return points.outlier or (note("The curve was fitted to points, and {points}.", points=noise),)

    @property
    def verdict(self) -> str:
        """Result in a sentence, without reasons."""
        if self.undecided is not None:
            return str(self.undecided)
        places = lengths(self.inflections)
        if self.bent_beforehand:
            template = (
                "The pre-bent strip cannot take this curve of {length}."
                if not self.realizable else
                "The pre-bent strip already has the shape of this curve of {length}."
                if self.any_stiffness else
                "The pre-bent strip can take this curve of {length}. The side to which it is bent from its "
                "pre-bent shape changes at {places}."
                if places else
                "The pre-bent strip can take this curve of {length}. It is bent from its pre-bent shape to "
                "one side only."
            )  # fmt: skip
        else:
            template = (
                "A flat strip cannot take this curve of {length}."
                if not self.realizable else
                "A strip of any width takes this curve of {length}, because the curve is straight."
                if self.any_stiffness else
                "A flat strip can take this curve of {length}; it has no inflections."
                if not places else
                "A flat strip can take this curve of {length}; it has 1 inflection, {places} from its start."
                if len(places) == 1 else
                "A flat strip can take this curve of {length}; it has {count} inflections, {places} from its "
                "start."
            )  # fmt: skip
        return note(template, length=Length(self.length), count=len(places), places=places)

    def _repr_html_(self) -> str:
        verdict = "undecided" if self.undecided else "yes" if self.realizable else "no"
        return f"<p><b>{verdict}</b>: {html_text(self)}</p>"

    def as_dict(self) -> dict[str, Any]:
        """Return a dictionary of numbers, texts and lists for a report."""
        return {
            "realizable": self.realizable,
            "any_stiffness": self.any_stiffness,
            "reasons": list(self.reasons),
            "warnings": list(self.warnings),
            "length": self.length,
            "inflections": list(self.inflections),
            "line": self.line.as_dict() if self.line else None,
            "off_line": [list(pair) for pair in self.off_line],
            "crossings": list(self.crossings),
            "touches": list(self.touches),
            "curvature_touches": list(self.curvature_touches),
            "jumps": list(self.jumps),
            "flats": [list(pair) for pair in self.flats],
            "moved": self.moved,
            "undecided": None if self.undecided is None else asdict(self.undecided),
        }


@dataclass(frozen=True)
class PairZero:
    """Point at which two curves have equal curvature, so that their moments must be equal too.

    Attributes
    ----------
    s : float
        Arc length of the point, mm.
    t : float
        Parameter of the point on the first curve.
    order : int
        Order of the zero of the difference of curvatures. The order is 1 if the difference changes sign, 2 if
        the sign does not change, 3 if the sign changes with the slope 0, and 0 if the sign changes by a jump.
    before, after : int
        Signs of the difference before and after the point; 0 beyond the ends of the curves.
    """

    s: float
    t: float
    order: int
    before: int
    after: int


@dataclass(frozen=True, eq=False)
class PairCheck:
    """Result of the check whether a strip can have two curves as rest shapes; `str()` returns advice to a designer.

    Attributes
    ----------
    realizable : bool
        True if both curves are rest shapes of a strip with some natural curvature.
    reasons : tuple of str
        Reasons why no strip has both rest shapes; empty if `realizable`.
    length : float
        Length of both curves, mm.
    first, second : PlaneCurve
        Curves, scaled to the same length.
    bistable : bool
        True if both states have the same clamps: equal positions of the ends, and equal total turning of the
        tangent.
    any_stiffness : bool
        True if the curves are congruent, so that every strip of this shape has both rest shapes without being bent.
    zeros : tuple of PairZero
        Points at which the difference of both curvatures is zero or changes sign by a jump.
    unmet : tuple of PairZero
        Zeros at which the difference of moments cannot be zero, as would be required.
    flats : tuple of (float, float)
        Start and end, mm, of intervals in which both curves have equal curvature.
    against : tuple of float
        Arc lengths, mm, at which moments and curvatures would need opposite signs.
    """

    realizable: bool
    reasons: tuple[str, ...]
    length: float
    first: PlaneCurve = field(repr=False)
    second: PlaneCurve = field(repr=False)
    bistable: bool = False
    any_stiffness: bool = False
    zeros: tuple[PairZero, ...] = ()
    unmet: tuple[PairZero, ...] = ()
    flats: tuple[tuple[float, float], ...] = ()
    against: tuple[float, ...] = ()

    def __repr__(self) -> str:
        verdict = "realizable" if self.realizable else "not realizable"
        return f"<PairCheck {verdict}, {self.length:.4g} mm>"

    def __str__(self) -> str:
        return sentences([self._verdict(), *self.reasons], " ")

    def _verdict(self) -> str:
        if not self.realizable:
            return note("No strip {length} long can rest in both curves.", length=Length(self.length))
        if self.any_stiffness:
            return note(
                "Both curves have the same shape: a strip of that shape rests in them without being bent."
            )
        return note(
            "One strip can rest in both curves, each {length} long, {held}; {alike}.",
            length=Length(self.length),
            held=note("in the same clamps" if self.bistable else "each in its own clamps"),
            alike=note(
                "their curvatures are equal {places} from the start"
                if self.zeros
                else "their curvatures are equal nowhere",
                places=lengths(z.s for z in self.zeros),
            ),
        )

    def _repr_html_(self) -> str:
        return f"<p><b>{'yes' if self.realizable else 'no'}</b>: {html_text(self)}</p>"

    def as_dict(self) -> dict[str, Any]:
        """Return a dictionary of numbers, texts and lists for a report."""
        return {
            "realizable": self.realizable,
            "reasons": list(self.reasons),
            "length": self.length,
            "bistable": self.bistable,
            "any_stiffness": self.any_stiffness,
            "zeros": [{"s": z.s, "order": z.order} for z in self.zeros],
            "unmet": [{"s": z.s, "order": z.order} for z in self.unmet],
            "flats": [list(pair) for pair in self.flats],
            "against": list(self.against),
        }


class NotRealizable(ElasticaError, ValueError):  # noqa: N818 - a fixed public name
    """Error if no strip can have the shape of the drawn curve, or of both drawn curves; `check` has the reasons."""

    KIND = "not realizable"

    def __init__(self, check: EquilibriumCheck | PairCheck, changes: Iterable[Change] = ()) -> None:
        self.check = check
        own = () if isinstance(check, PairCheck) else _changes_of(check.curve)
        super().__init__(str(check), changes=(*changes, *own))
        self.details = () if isinstance(check, PairCheck) else check.details


def refused(check: EquilibriumCheck, reason: str) -> EquilibriumCheck:
    """Return the check of a curve that no strip can take for one more reason."""
    return replace(check, realizable=False, any_stiffness=False, reasons=(*check.reasons, reason))


def measured_points(curve: PlaneCurve) -> MeasuredPoints | None:
    """Return the noisy points to which a curve was fitted, or None if there are none."""
    points = None if curve.provenance is None else curve.provenance.measured
    return points if points is not None and points.is_noisy else None


def outlier_message(curve: PlaneCurve) -> tuple[Refusal, ...]:
    """Return the message about an outlier among the measured points, if there is one."""
    points = measured_points(curve)
    return () if points is None else points.outlier


def _changes_of(curve: PlaneCurve) -> tuple[Change, ...]:
    """Return the changes to try for a refused curve: for noisy points more smoothing, then the nearest curve.

    There is none for points with an outlier, which must be corrected first.
    """
    points = None if curve.provenance is None else curve.provenance.measured
    nearest = Change("nearest", True)
    if points is None or points.noise < REPORTED_MM:
        return (nearest,)
    if points.is_noisy and points.outlier:
        return ()
    return Change("smooth", points.reach), Change("smooth", 2 * points.reach), nearest


def lengths(s: Iterable[float]) -> Listed:
    """Return arc lengths for a message, without rounding errors: "12 and 34.5 mm"."""
    return Listed(Length(round(x, 6)) for x in s)


def _shown_on(curve: PlaneCurve, point: FloatArray) -> str:
    return (curve.provenance or Provenance()).shown(point)


def require_bendable(curve: PlaneCurve) -> None:
    """Refuse objects that are not curves, and curves with a corner, which no strip can follow.

    A closed curve may also have a corner at its start.
    """
    require_curve(curve)
    corners = curve.tangent_breaks
    if (corners or curve.has_corners) and (points := measured_points(curve)) is not None:
        message = next(iter(points.outlier), points.noise_message)
        raise InputError(message, kind="corner", changes=_changes_of(curve))
    if corners:
        slight = _smoothing_change(curve)
        apart = Change("split_corners", True), Change("nearest", True)
        sharpest = max(corners, key=lambda corner: abs(corner.angle))
        raise InputError(
            _corner_message(curve, corners), kind="corner", where={"at": sharpest.s}, changes=slight or apart
        )
    if curve.has_corners:
        changes = _smoothing_change(curve) or (Change("nearest", True),)
        raise InputError(_seam_message(curve), kind="corner", changes=changes)


SAMPLED_SHARE = 0.15
"""Least turn at a point beside a corner that may be a bend through measured points, as a fraction of the corner.

The turn must also be less than `SMOOTH_TURN`, above which `corner_points` returns a corner of an open curve.
"""


def _corner_message(curve: PlaneCurve, corners: Sequence[TangentBreak]) -> str:
    """Return the message on corners of a curve.

    It asks for more points if rounding, or too few points, make the corners uncertain.
    """
    provenance = curve.provenance
    maybe = {} if provenance is None else {turn.t: turn for turn in provenance.undecided}
    if provenance is not None and all(corner.t in maybe for corner in corners):
        turn = max((maybe[corner.t] for corner in corners), key=lambda turn: turn.angle)
        return _undecided_message(provenance, turn, [c.s for c in corners])
    if provenance is not None and provenance.measured is not None:
        for corner in corners:
            place = curve.evaluate(corner.t)
            here, *beside = np.degrees(provenance.measured.turns_beside(place))
            if here and any(SAMPLED_SHARE <= turn / here < 1 and abs(turn) < SMOOTH_TURN for turn in beside):
                return note(
                    "the points turn by {angle:.3g} at {shown}, but are too few to distinguish a corner "
                    "from a tight bend. Give more points there, or split the curve{smooth}",
                    angle=Degrees(abs(here)), shown=provenance.shown(place), smooth=_smoothing_advice(curve),
                )  # fmt: skip
    sharpest = max(corners, key=lambda corner: abs(corner.angle))
    return note(
        "the curve has corners {places} from its start, but a strip bends without kinks. The sharpest, of "
        "{angle:.3g}, is at {shown}. Round the corners, or split the curve there{smooth}"
        if len(corners) > 1 else
        "the curve has a corner {places} from its start, at {shown}, of {angle:.3g}, but a strip "
        "bends without kinks. Round the corner, or split the curve there{smooth}",
        places=lengths(c.s for c in corners), angle=Angle(abs(sharpest.angle)),
        shown=_shown_on(curve, curve.evaluate(sharpest.t)), smooth=_smoothing_advice(curve),
    )  # fmt: skip


def _seam_message(curve: PlaneCurve) -> str:
    """Return the message on a corner where the ends of a closed curve meet."""
    provenance = curve.provenance
    start = curve.evaluate(curve.domain[0])
    if provenance is not None:
        for turn in provenance.undecided:
            if turn.t == curve.domain[0]:
                return _undecided_message(provenance, turn, [0.0])
    return note(
        "the closed curve has a corner of {angle:.3g} at {shown}, where its ends meet, but a strip "
        "bends without kinks. Round the corner, or leave a gap between the ends{smooth}",
        angle=Angle(abs(curve.seam_turn)), shown=_shown_on(curve, start), smooth=_smoothing_advice(curve),
    )  # fmt: skip


def _undecided_message(drawn: Provenance, turn: Turn, s: Iterable[float]) -> str:
    return note(
        "the curve turns by {angle:.2g} at {shown}, {places} from its start, because of a corner or a "
        "rounding error: the handle of this node is only {handle} long, so the rounding of numbers in the file "
        "can turn it by {bound:.2g}. Save the drawing with more decimals, or lengthen the handles of "
        "this node",
        angle=Angle(turn.angle), shown=drawn.shown(turn.point), places=lengths(s),
        handle=Length(turn.handle), bound=Angle(turn.bound),
    )  # fmt: skip


def _smoothing_change(curve: PlaneCurve) -> tuple[Change, ...]:
    slight = smooth_for_corners(curve)
    return () if slight is None else (Change("smooth", slight),)


def _smoothing_advice(curve: PlaneCurve) -> str:
    slight = _smoothing_change(curve)
    if not slight:
        return ""
    return note(", or set {field} to about {size:g} to smooth it", field=SMOOTH, size=Length(slight[0].value))


SMOOTH, SMOOTH_WITHIN = FieldName("smooth"), Length(0.1)
SMOOTHED = (Change("smooth", SMOOTH_WITHIN + 0.0),)
"""Smoothing that messages suggest if the curvature jumps, with the largest displacement of the curve, mm."""

PLACES = 721
"""Number of points along a closed curve among which the flattest point is chosen."""

PLACE_DIGITS = 6
"""Number of decimals of a start point in mm, so that equal curves from two programs begin at the same point."""

ALIKE = 1e-6
"""Points are equally flat if their curvatures differ by less than this fraction of the largest curvature."""

NEAR_KNOT_SHARE = 1e-5
"""A start closer to a knot than this fraction of the parameter range is moved to the knot.

The curvature of a shorter piece between start and knot would consist of rounding errors.
"""


def begin_at(curve: PlaneCurve, s: float) -> PlaneCurve:
    """Return the same closed curve with its start and end at the arc length `s`, mm.

    Examples
    --------
    >>> circle = PlaneCurve.arc((0, 0), 10, 0, 2 * np.pi)
    >>> begin_at(circle, circle.length / 4).at([0.0]).position.round(6).tolist()
    [[0.0, 10.0]]
    """
    if not curve.is_closed:
        raise InputError("the curve is open, so its start cannot be moved along it: give a closed curve")
    if not 0 <= s <= curve.length:
        raise InputError(
            "the closed curve is {length:.4g} long, so it cannot begin {s:g} from its drawn start: give a "
            "place from 0 to this length",
            s=Length(s),
            length=Length(curve.length),
        )
    low, high = curve.domain
    t = float(curve.parameter(s))
    provenance, curve = curve.provenance, _closed_exactly(curve)
    knot = float(curve.knots[np.abs(curve.knots - t).argmin()])
    t = knot if abs(knot - t) <= NEAR_KNOT_SHARE * (high - low) else t
    if t <= low or t >= high:
        return curve.drawn_as(provenance)
    first, second = curve.trimmed(t, high), curve.trimmed(low, t)
    p = curve.degree
    knots = np.concatenate([first.knots[:-1], second.knots[p + 1 :] + (high - low)])
    points = np.concatenate([first.control_points, second.control_points[1:]])
    weights = None
    if first.weights is not None and second.weights is not None:
        # continue the weights of the first part; a common factor of all weights does not change the shape
        scale = first.weights[-1] / second.weights[0]
        weights = np.concatenate([first.weights, second.weights[1:] * scale])
    return PlaneCurve(knots, points, p, weights).drawn_as(provenance and provenance.of_part())


def _closed_exactly(curve: PlaneCurve) -> PlaneCurve:
    # make the first and the last control point exactly equal
    clamped = clamp_ends(curve)
    points = clamped.control_points
    if np.array_equal(points[0], points[-1]):
        return curve
    return clamped.with_control_points(np.concatenate([points[:-1], points[:1]]))


def flattest_place(curve: PlaneCurve) -> float:
    """Return the arc length, mm, of the flattest point that is not near an inflection.

    Of several equally flat points, the first is returned.
    """
    nodes = curve.sample(PLACES)
    bent = np.abs(nodes.curvature)
    largest = float(bent.max())
    # points of smaller curvature are near an inflection
    bent[bent < 0.05 * largest] = np.inf
    first = float(nodes.s[np.flatnonzero(bent <= bent.min() + ALIKE * largest)[0]])
    return min(round(first, PLACE_DIGITS), curve.length)


AT_END_SHARE = 1e-6
"""A zero of the curvature closer to an end than this fraction of the length is at the end."""

PINNED_SHARE = 1e-6
"""At a pinned end, a curvature up to this fraction of the largest curvature counts as 0."""

GENTLE_SHARE = 1e-5
"""Largest slope of the curvature at an inflection that counts as 0.

The slope is relative to the largest curvature divided by the length. With this slope, the stiffness at the
inflection would be about ten thousand times the stiffness at other points.
"""

FAINT_SHARE = 1e-7
"""Minima of the absolute curvature up to this fraction of the largest curvature count as 0."""

ALL_BUT_UNBENT_SHARE = 1e-3
"""A zero just beyond an end is moved to the end if the end's curvature is below this fraction of the largest."""

STEP_SHARE = 1e-3
"""Jumps of the curvature up to this fraction of the curvature are not reported.

Such a jump changes a width of 40 mm by 0.04 mm.
"""

KINK_SHARE = 0.01
"""Largest jump of the slope of the curvature, times length divided by curvature, that is not reported.

If the width of a strip is a fifth of its length, such a jump turns its edge by at most 0.1 degree.
"""

SHARP_SHARE = 5.0
"""The edge of a strip has a visible corner where the slope of the curvature jumps by this value or more.

The jump is multiplied by the length of the curve and divided by the curvature.

If the width of a strip is a fifteenth of its length, the corner has 10 degrees.
"""


def examine_curvature(
    curve: PlaneCurve,
    supports: Supports,
    natural_curvature: NaturalCurvature = 0.0,
    *,
    tails: Sequence[int] = (),
) -> EquilibriumCheck:
    """Check the excess curvature (curvature minus natural curvature): zeros, jumps, straight pieces, kinks.

    `tails` are the ends (0 start, 1 end) with a straight tail, which carries no moment.
    """
    require_bendable(curve)
    excess = ExcessCurvature(curve, natural_curvature)
    largest = float(np.abs(excess.survey).max())
    excess, begun = _with_bent_start(excess, largest)
    curve = excess.curve
    zeros = _zeros_of(excess, supports, largest)
    flats = [z for z in zeros if z.kind == "flat"]
    jumps = tuple(z.s for z in zeros if z.kind == "jump")
    touches = [z.s for z in zeros if z.kind == "touch"]
    points = tuple(z for z in zeros if z.kind in ("crossing", "end"))
    # the first straight piece is the tail at the start (end 0), the last one the tail at the end (end 1)
    joints = []
    for end in tails if flats else ():
        tail = flats[-end]
        t, s = (tail.t, tail.s) if end else (tail.t_end, tail.s_end)
        sides = (tail.before, 0) if end else (0, tail.after)
        joints.append(CurvatureZero(s, t, "flat", s, t, *sides))
    check = EquilibriumCheck(
        realizable=True,
        reasons=(),
        warnings=(),
        length=curve.length,
        curve=curve,
        inflections=tuple((z.s + z.s_end) / 2 for z in zeros if z.changes_sign),
        jumps=jumps,
        flats=tuple((z.s, z.s_end) for z in flats),
        zeros=tuple(sorted((*points, *joints), key=lambda z: z.s)),
        bent_beforehand=excess.is_bent_beforehand,
    )
    if (
        flats
        and flats[0].s <= AT_END_SHARE * curve.length
        and flats[0].s_end >= (1 - AT_END_SHARE) * curve.length
    ):
        return replace(check, any_stiffness=True, warnings=crossing_notes(curve), zeros=())
    gentle = [z.s for z, slope in zip(points, _smaller_slopes(excess, points), strict=True)
              if slope <= GENTLE_SHARE * largest / curve.length]  # fmt: skip
    gentle += faint_places(excess, largest, zeros)
    bent_joints, gentle_joints = _faulty_joints(excess, joints, largest)
    gentle += gentle_joints
    loaded = [flat for k, flat in enumerate(flats) if k not in {end * (len(flats) - 1) for end in tails}]
    reasons = [
        *_pinned_end_reasons(excess, supports, zeros),
        *_straight_part_reasons(excess, supports, loaded, largest),
        *bent_joints,
    ]
    if jumps:
        reasons.append(note(
            "The curvature jumps from one sign to the other {places} from the start, where the stiffness "
            "would have to be 0. Support the strip there, or set {field} to about {within:g} to let the "
            "curvature pass smoothly through 0.",
            places=lengths(jumps), field=SMOOTH, within=SMOOTH_WITHIN,
        ))  # fmt: skip
    curvature_touches = tuple(sorted([*touches, *gentle]))
    if curvature_touches:
        reasons.append(note(
            "The curvature becomes 0 at {places} from the start, but the curve does not clearly bend to the "
            "other side there. The stiffness would have to be infinite or 0, even with a support. Bend the "
            "curve a little more there, or clearly to the other side.",
            places=lengths(curvature_touches),
        ))  # fmt: skip
    return replace(
        check,
        realizable=not reasons,
        reasons=tuple(reasons),
        warnings=(*begun, *_warn_of_widths(curve, jumps, flats), *crossing_notes(curve)),
        curvature_touches=curvature_touches,
    )


def _with_bent_start(excess: ExcessCurvature, largest: float) -> tuple[ExcessCurvature, tuple[str, ...]]:
    """Move an unbent start of a closed curve to a bent point. Also return a message about the move.

    `largest` is the largest excess curvature, 1/mm.
    """
    curve = excess.curve
    # keep the start of a `RestCurvature`, whose arc length is measured from there
    if not curve.is_closed or isinstance(excess.rest, RestCurvature):
        return excess, ()
    if np.abs(excess.at(curve.domain)).min() > 0.01 * largest:  # the start is bent
        return excess, ()
    place = flattest_place(curve)
    message = note(
        "The ends of a closed strip can meet only where the curve is bent. The drawn start is not bent, so the "
        "strip starts {s} farther along the curve, at {shown}; positions are measured from there.",
        shown=_shown_on(curve, curve.at(place).position[0]), s=Length(place), severity="warning",
    )  # fmt: skip
    return replace(excess, curve=begin_at(curve, place)), (message,)


def _zeros_of(excess: ExcessCurvature, supports: Supports, largest: float) -> tuple[CurvatureZero, ...]:
    """Return the zeros of curvature minus natural curvature. Zeros near or just beyond an end are moved to it."""
    curve = excess.curve
    low, high = curve.domain
    length, near = curve.length, AT_END_SHARE * curve.length
    zeros: list[CurvatureZero] = []
    # the zero at the start (False) and at the end (True) of the curve
    ends: dict[bool, CurvatureZero] = {}
    for zero in excess.zeros:
        at_start, at_end = zero.s_end <= near, zero.s >= length - near
        if zero.kind == "flat" or not (at_start or at_end):
            zeros.append(zero)
        else:
            ends[at_end] = zero
    # only such ends can be pinned or have a zero just beyond them; the factor 2 is a reserve
    hardly_bent = np.abs(excess.survey[[0, -1]]) <= 2 * max(PINNED_SHARE, ALL_BUT_UNBENT_SHARE) * largest
    if not (ends or hardly_bent.any()):
        return tuple(zeros)
    t_ends = np.array([low, high])
    at_ends = zip((low, high), excess.at(t_ends).tolist(), excess.slope_at(t_ends).tolist(), strict=True)
    for is_end, (support, (t, kappa, slope)) in enumerate(zip(supports.ends, at_ends, strict=True)):
        pinned = not support.angle and abs(kappa) <= PINNED_SHARE * largest
        # True if curvature minus natural curvature, extrapolated linearly, is zero just beyond this end
        beyond = 0 < abs(kappa) <= min(near * abs(slope), ALL_BUT_UNBENT_SHARE * largest)
        if bool(is_end) in ends or ((pinned or beyond) and not any(z.t <= t <= z.t_end for z in zeros)):
            slope_sign = int(np.sign(slope))
            sign = (0, slope_sign) if not is_end else (-slope_sign, 0)
            s = length if is_end else 0.0
            zeros.append(CurvatureZero(s, t, "end", s, t, *sign))
    return tuple(sorted(zeros, key=lambda z: z.s))


def faint_places(
    excess: ExcessCurvature, largest: float, zeros: Sequence[CurvatureZero], share: float = FAINT_SHARE
) -> list[float]:
    """Return arc lengths, mm, at which the curvature comes close to the natural curvature without reaching it."""
    curve, change = excess.curve, excess.survey
    s = curve.survey.s
    bent = np.abs(change)
    inside = bent[1:-1]
    # only deep minima are located exactly
    dips = (inside <= bent[:-2]) & (inside <= bent[2:]) & (inside < 0.01 * largest)
    places = []
    for i in np.flatnonzero(dips) + 1:
        low, high = s[i - 1], s[i + 1]
        if any(low <= z.s_end and z.s <= high for z in zeros):
            continue
        sign = np.sign(change[i])

        def depth(s: float, sign: float = sign) -> float:
            return float(sign * excess.at(curve.parameter(s)))

        from scipy.optimize import minimize_scalar

        least = minimize_scalar(
            depth, bounds=(low, high), method="bounded", options={"xatol": 1e-7 * curve.length}
        )
        if least.fun <= share * largest:
            places.append(float(least.x))
    return places


def _smaller_slopes(excess: ExcessCurvature, zeros: Sequence[CurvatureZero]) -> list[float]:
    """Return the smaller one-sided slope of the curvature, |d kappa / ds|, at each zero."""
    if not zeros:
        return []
    t = np.array([zero.t for zero in zeros])
    low, high = excess.curve.domain
    knots = excess.curve.bezier_table[0]
    if not isinstance(excess.rest, RestCurvature) and not (t[:, None] == knots[1:-1]).any():
        return list(map(float, np.abs(excess.slope_at(t))))
    before, after = (np.abs(excess.slope_at(t, left=left)) for left in (True, False))
    least = np.where(t <= low, after, np.where(t >= high, before, np.minimum(before, after)))
    return list(map(float, least))


def _pinned_end_reasons(
    excess: ExcessCurvature, supports: Supports, zeros: Sequence[CurvatureZero]
) -> Iterable[str]:
    """Yield a reason for each end that is free to turn but has another curvature than the unloaded strip."""
    curve = excess.curve
    for name, support, t, s in zip(
        ("start", "end"), supports.ends, curve.domain, (0.0, curve.length), strict=True
    ):
        if support.angle or any(z.kind in ("end", "flat") and z.t <= t <= z.t_end for z in zeros):
            continue
        kappa = float(curve.curvature_at(t))
        natural = float(excess.rest_at(t))
        yield note(
            "The {end} (at {s}) is free to turn, so its curvature must be that of the pre-bent strip, "
            "{natural:.3g} 1/mm, but it is {curvature:.3g} 1/mm. Let the curvature change to {natural:.3g} 1/mm "
            "there. Only a clamped end may have another curvature." if natural else
            "The {end} (at {s}) is free to turn, so the curvature there must be 0, but it is {curvature:.3g} "
            "1/mm. Let the curvature decrease to 0 there. Only a clamped end may be bent.",
            end=note(name), s=Length(s), curvature=kappa, natural=natural,
        )  # fmt: skip


def _straight_part_reasons(
    excess: ExcessCurvature, supports: Supports, flats: Sequence[CurvatureZero], largest: float
) -> Iterable[str]:
    """Yield a reason for each straight part, where the stiffness beside the joint or the moment would be 0."""
    curve = excess.curve
    for flat in flats:
        joints = [joint for joint in ((flat.s, flat.t, True), (flat.s_end, flat.t_end, False))
                  if AT_END_SHARE * curve.length < joint[0] < (1 - AT_END_SHARE) * curve.length]  # fmt: skip
        if any(
            not support.angle and flat.t <= t <= flat.t_end
            for support, t in zip(supports.ends, curve.domain, strict=True)
        ):
            yield note(
                "The piece from {start} to {end} is bent exactly as the pre-bent strip and has an end that "
                "is free to turn, so it carries no moment. The program computes no strip with such a piece, "
                "even with a tie or support at {places}. Clamp this end, or let the curve end at {places}."
                if excess.is_bent_beforehand else
                "The piece from {start} to {end} is straight and has an end that is free to turn, so it carries "
                "no moment. Let this end be free, with a tie, pin or rail at {places}, or let the curve end at "
                "{places}.",
                start=Length(round(flat.s, 6)), end=Length(flat.s_end), places=lengths(s for s, _, _ in joints),
            )  # fmt: skip
            continue
        opening = note(
            "The piece from {start} to {end} is bent exactly as the pre-bent strip, but the adjacent piece is "
            "not, so the stiffness at the joint would have to be 0" if excess.is_bent_beforehand else
            "The piece from {start} to {end} is straight, but the adjacent piece is bent, so the stiffness "
            "at the joint would have to be 0",
            start=Length(round(flat.s, 6)), end=Length(flat.s_end),
        )  # fmt: skip
        yield note(
            "{why}. A support at the joint does not help. Draw the piece with a slight bend."
            if any(_is_gentle(excess, t, largest, left=left) for _, t, left in joints) else
            "{why}. Support the strip at {places}, or draw the piece with a slight bend.",
            why=opening, places=lengths(s for s, _, _ in joints),
        )  # fmt: skip


def _faulty_joints(
    excess: ExcessCurvature, joints: Sequence[CurvatureZero], largest: float
) -> tuple[list[str], list[float]]:
    """Check the joints between straight tails and the bent part.

    Return messages about joints at which the curvature jumps, and the arc lengths, mm, of joints at which the slope
    of the curvature is almost 0.
    """
    bent, gentle = list[str](), []
    for joint in joints:
        t, left = joint.t, joint.after == 0
        kappa, slope = float(excess.at(t, left=left)), excess.slope_at(t, left=left)
        if abs(kappa) > PINNED_SHARE * largest:
            bent.append(
                note(
                    "The straight free end of the strip carries no moment, so the curvature must decrease to 0 "
                    "where this end meets the bent part, {s} from the start of the strip. There it jumps to "
                    "{curvature:.3g} 1/mm. Draw the curve with less and less bend towards {s}.",
                    s=Length(round(joint.s, 6)), curvature=kappa,
                )
            )  # fmt: skip
        elif abs(slope) <= GENTLE_SHARE * largest / excess.curve.length:
            gentle.append(joint.s)
    return bent, gentle


def _is_gentle(excess: ExcessCurvature, t: float, largest: float, *, left: bool) -> bool:
    kappa, slope = (abs(float(at(t, left=left))) for at in (excess.at, excess.slope_at))
    return kappa <= PINNED_SHARE * largest and slope <= PINNED_SHARE * largest / excess.curve.length


def is_about_kinks(warning: str) -> TypeGuard[Refusal]:
    """Return True for a warning of `_warn_of_widths` about corners of the edges or jumps of the width."""
    return isinstance(warning, Refusal) and warning.kind == "kinks"


def _warn_of_widths(
    curve: PlaneCurve, jumps: Sequence[float], flats: Sequence[CurvatureZero]
) -> Iterable[str]:
    """Warn of steps and corners of the width, except at straight pieces, where smoothing does not help."""
    knots = curve.breaks if curve.seam is None else (curve.seam, *curve.breaks)
    breaks = [knot for knot in knots if knot.continuity < 3]
    if not breaks:
        return
    straight = [end for flat in flats for end in (flat.s, flat.s_end)]
    if curve.seam is not None:  # on a closed curve, start and end are the same point
        straight += [end - curve.length for end in straight]
    near = AT_END_SHARE * curve.length
    visible = [
        (b, jump, kink)
        for b, jump, kink in zip(breaks, *curvature_jumps(curve, breaks), strict=True)
        if (jump > STEP_SHARE or kink > KINK_SHARE) and all(abs(b.s - end) > near for end in straight)
    ]
    kinks = [b.s for b, _, _ in visible if b.continuity == 2]
    sharp = any(jump > STEP_SHARE or kink > SHARP_SHARE for b, jump, kink in visible if b.continuity == 2)
    steps = [b.s for b, _, _ in visible if b.continuity == 1 and b.s not in jumps]
    if steps:
        yield Refusal(
            "kinks",
            "The width of the strip jumps at {places}, because the curvature jumps there. Set {field} to about "
            "{within:g} to smooth the curve, which moves it by at most that distance.",
            {"places": lengths(steps), "field": SMOOTH, "within": SMOOTH_WITHIN}, changes=SMOOTHED,
            severity="warning",
        )  # fmt: skip
    if kinks:
        yield Refusal(
            "kinks",
            "The edges of the strip have a corner at {places}, because the curvature changes abruptly there. "
            "Set {field} to about {within:g} to smooth the curve, which moves it by at most that distance."
            if curve.degree < 4 else
            "The edges of the strip have a corner at {places}, because the curvature changes abruptly there. "
            "Do not repeat the knot there.",
            {"places": lengths(kinks), "field": SMOOTH, "within": SMOOTH_WITHIN},
            changes=SMOOTHED if curve.degree < 4 else (), severity="warning" if sharp else "note",
        )  # fmt: skip


def curvature_jumps(curve: PlaneCurve, breaks: Sequence[Break]) -> tuple[FloatArray, FloatArray]:
    """Return the relative jumps (n,) of the curvature, and the jumps (n,) of its slope.

    All jumps are divided by the curvature, and the jumps of the slope are multiplied by the length of the curve.
    The divisor is at least 1e-6 of the largest curvature: where the curvature is 0, rounding errors are not jumps.
    """
    after = np.array([place.t for place in breaks])
    low, high = curve.domain
    before = np.where(after == low, high, after)  # the start of a closed curve follows its end
    kappa = curve.curvature_at(before, left=True), curve.curvature_at(after)
    slope = curve.curvature_slope_at(before, left=True), curve.curvature_slope_at(after)
    sizes = np.abs(kappa)
    size = np.maximum(sizes.max(axis=0), 1e-6 * sizes.max(initial=np.finfo(float).tiny))
    with np.errstate(over="ignore"):  # the curvature may be 0 everywhere
        return np.abs(kappa[1] - kappa[0]) / size, np.abs(slope[1] - slope[0]) * curve.length / size


def crossing_notes(curve: PlaneCurve) -> tuple[str, ...]:
    """Return a warning if the curve crosses itself."""
    pairs = curve.self_intersections()
    if not pairs.size:
        return ()
    return (
        note(
            "The curve crosses itself ({places} from its start): two parts of the strip must pass side by "
            "side there.",
            places=Listed(Listed(map(Length, pair)) for pair in pairs), severity="warning",
        ),
    )  # fmt: skip
