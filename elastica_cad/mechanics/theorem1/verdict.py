"""Verdicts on a curve, and on two for one strip, as records, the line of Theorem 1, and their words."""

from collections.abc import Iterable
from dataclasses import asdict, dataclass, field
from typing import Any

import numpy as np

from elastica_cad._printable import html_text
from elastica_cad._types import FloatArray
from elastica_cad._values import numbers
from elastica_cad.errors import Change, ElasticaError, InputError
from elastica_cad.geometry.curves.plane_curve import CurvatureZero, PlaneCurve
from elastica_cad.geometry.pen_curves.measured_points import MeasuredPoints
from elastica_cad.geometry.pen_curves.provenance import Provenance
from elastica_cad.refusals import Length, Listed, Refusal, note, sentences


@dataclass(frozen=True)
class InflectionLine:
    """A line, zero of a + <b, x>, with |b| = 1.

    Attributes
    ----------
    point : (2,) tuple
        A point of it, mm.
    direction : (2,) tuple
        Unit vector along it.
    """

    point: tuple[float, float]
    direction: tuple[float, float]

    @property
    def b(self) -> FloatArray:
        """Unit normal (2,): the direction turned left."""
        return np.array([-self.direction[1], self.direction[0]])

    @property
    def a(self) -> float:
        """Constant of a + <b, x>, mm."""
        return -float(self.b @ np.asarray(self.point))

    def distance(self, position: FloatArray) -> FloatArray:
        """Signed distances (n,) of points (n, 2), mm."""
        points = numbers(position, "positions")
        if points.shape[-1:] != (2,):
            raise InputError("positions are points (n, 2), in mm, not of shape {shape}", shape=points.shape)
        return np.asarray((points - np.asarray(self.point)) @ self.b)

    def as_dict(self) -> dict[str, Any]:
        """For reports."""
        return {
            "point": list(self.point),
            "direction": list(self.direction),
            "a": self.a,
            "b": self.b.tolist(),
        }


@dataclass(frozen=True)
class FittedVerdict:
    """Verdict on one curve that was fitted to points.

    Attributes
    ----------
    realizable : bool
    distance : float
        Largest distance of a point from the curve, mm.
    inflections : int
        Number of inflections.
    """

    realizable: bool
    distance: float
    inflections: int


@dataclass(frozen=True)
class Undecided:
    """Two curves that follow the same points and have different verdicts; `str()` of it is a message.

    Attributes
    ----------
    resolution : float
        Distance by which the number of decimals may move a point, mm.
    fit, other : FittedVerdict
        The curve of the check, and another one.
    """

    resolution: float
    fit: FittedVerdict
    other: FittedVerdict

    def __str__(self) -> str:
        return note(
            "The verdict is undecided by these points (resolution {resolution}): give more points, or more "
            "decimals. A curve within {near} of the points (inflections: {others}) cannot be bent. The curve "
            "fitted to them within {far} (inflections: {count}) can."
            if self.fit.realizable else
            "The verdict is undecided by these points (resolution {resolution}): give more points, or more "
            "decimals. A curve within {near} of the points (inflections: {others}) can be bent. The curve "
            "fitted to them within {far} (inflections: {count}) cannot.",
            resolution=_two_digits(self.resolution), near=_two_digits(self.other.distance),
            far=_two_digits(self.fit.distance), others=self.other.inflections, count=self.fit.inflections,
            severity="warning",
        )  # fmt: skip


def _two_digits(mm: float) -> Length:
    return Length(float(f"{mm:.2g}"))


@dataclass(frozen=True, eq=False)
class EquilibriumCheck:
    """Verdict of Theorem 1 on a curve; `str()` of it is advice to a designer.

    Attributes
    ----------
    realizable : bool
        Can a flat strip take this curve?
    reasons : tuple of str
        Why not; empty when realizable.
    warnings : tuple of str
        What the designer should know all the same.
    length : float
        mm.
    any_stiffness : bool
        The curve is straight (or has the natural curvature throughout): every stiffness will do.
    inflections : tuple of float
        Arc lengths, mm, where kappa - kappa_0 changes sign.
    line : InflectionLine or None
        The inflection line; for a single inflection the middle one of those that will do; None where none is
        needed.
    off_line : tuple of (float, float)
        Arc length of every point that the line must pass, and its distance from it, mm.
    crossings, touches : tuple of float
        Arc lengths, mm, where the line crosses or touches the curve and must not.
    curvature_touches, jumps : tuple of float
        Arc lengths, mm, where kappa - kappa_0 touches zero without changing sign or changes it too gently,
        and where its sign changes by a jump.
    flats : tuple of (float, float)
        Straight pieces from, to, mm.
    moved : float
        Largest move, mm, of the curve by which its inflections were brought onto one line.
    curve : PlaneCurve
        The curve of this check: the drawn one, or the moved one.
    zeros : tuple of CurvatureZero
        All zeros of kappa - kappa_0 of `curve` at which the moment must vanish.
    bent_beforehand : bool
        Is the strip anything but flat before it is bent?
    undecided : Undecided or None
        Another verdict on another curve that follows the points as well, of a curve that was fitted to points.
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
        stray, points = stray_point(self.curve), self.told_of_points
        first = [*stray, self.verdict] if stray else [self.verdict, *points]
        return sentences([*first, *self.reasons, *self.warnings], " ")

    @property
    def cautions(self) -> tuple[str, ...]:
        """The warnings for a strip that is made, after the message that points leave the verdict undecided."""
        return self.warnings if self.undecided is None else (str(self.undecided), *self.warnings)

    @property
    def told_of_points(self) -> tuple[str, ...]:
        """Of a curve that was fitted to points that waver: the one that stands out, or how far they do."""
        points = measured_points(self.curve)
        if points is None:
            return ()
        return points.stray or (note("The curve was fitted to points, and {points}.", points=points.told),)

    @property
    def verdict(self) -> str:
        """Can a strip take it, in a sentence, without reasons."""
        if self.undecided is not None:
            return str(self.undecided)
        return self._tell_blank() if self.bent_beforehand else self._tell_flat()

    def _tell_flat(self) -> str:
        if not self.realizable:
            said = "A flat strip cannot take this curve of {length}."
        elif self.any_stiffness:
            said = "A strip of any width takes this curve of {length}: it is not bent."
        elif not self.inflections:
            said = "A flat strip can take this curve of {length}; it has no inflections."
        elif len(self.inflections) == 1:
            said = "A flat strip can take this curve of {length}; it has 1 inflection, at {places}."
        else:
            said = "A flat strip can take this curve of {length}; it has {count} inflections, at {places}."
        return self._said(said)

    def _tell_blank(self) -> str:
        """Its inflections cannot be seen in the curve: there it is bent as the blank was."""
        if not self.realizable:
            return self._said("A strip bent beforehand as asked cannot take this curve of {length}.")
        if self.any_stiffness:
            return self._said("A strip bent beforehand as asked has this curve of {length} already.")
        return self._said(
            "A strip bent beforehand as asked can take this curve of {length}; its bending changes sign at "
            "{places}."
            if self.inflections
            else "A strip bent beforehand as asked can take this curve of {length}; its bending does not "
            "change sign."
        )

    def _said(self, text: str) -> str:
        places = lengths(self.inflections)
        return note(text, length=Length(self.length), count=len(places), places=places)

    def _repr_html_(self) -> str:
        verdict = "undecided" if self.undecided else "yes" if self.realizable else "no"
        return f"<p><b>{verdict}</b>: {html_text(self)}</p>"

    def as_dict(self) -> dict[str, Any]:
        """Numbers, texts and lists for a report."""
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
    """A place where two curves are bent alike, so that their moments must be equal too.

    Attributes
    ----------
    s : float
        Arc length, mm.
    t : float
        Parameter of the first curve.
    order : int
        How often the difference of the curvatures vanishes there: 1 where it changes sign, 2 where it only
        touches zero, 3 where it changes sign without a slope; 0 where it changes sign by a jump.
    before, after : int
        Sign of the difference on either side; 0 beyond the ends.
    """

    s: float
    t: float
    order: int
    before: int
    after: int


@dataclass(frozen=True, eq=False)
class PairCheck:
    """Can one strip rest in two curves? `str()` of it is advice to a designer.

    Attributes
    ----------
    realizable : bool
        Is there a strip, with a shape of its own before it is bent, that rests in both?
    reasons : tuple of str
        Why not; empty when realizable.
    length : float
        Of both curves, mm.
    first, second : PlaneCurve
        The curves, brought to equal length to rounding.
    bistable : bool
        Do both states have the same clamps: ends that lie alike, and the same total turning?
    any_stiffness : bool
        The curves are congruent: every strip of their own shape will do, unbent.
    zeros : tuple of PairZero
        Where kappa_1 - kappa_2 vanishes or jumps to the other sign.
    unmet : tuple of PairZero
        Those of them at which no difference of moments vanishes as it must.
    flats : tuple of (float, float)
        Stretches from, to, mm, on which both curves are bent alike.
    against : tuple of float
        Arc lengths, mm, where the moments would have to act against the curvatures.
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
        return " ".join([self._tell(), *self.reasons])

    def _tell(self) -> str:
        if not self.realizable:
            return note("No strip rests in both curves of {length}.", length=Length(self.length))
        if self.any_stiffness:
            return "Both curves have the same shape: a strip of that shape rests in them without being bent."
        held = "in the same clamps" if self.bistable else "each in its own clamps"
        alike = "they are bent alike at {places}" if self.zeros else "they are bent alike nowhere"
        text = f"One strip can rest in both curves of {{length}}, {held}; {alike}."
        return note(text, length=Length(self.length), places=lengths(z.s for z in self.zeros))

    def _repr_html_(self) -> str:
        return f"<p><b>{'yes' if self.realizable else 'no'}</b>: {html_text(self)}</p>"

    def as_dict(self) -> dict[str, Any]:
        """Numbers, texts and lists for a report."""
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
    """No admissible stiffness makes the curve, or two curves, rest shapes; `check` tells why and where."""

    KIND = "not realizable"

    def __init__(self, check: EquilibriumCheck | PairCheck) -> None:
        self.check = check
        changes = () if isinstance(check, PairCheck) else changes_of(check.curve)
        super().__init__(str(check), changes=changes)


def measured_points(curve: PlaneCurve) -> MeasuredPoints | None:
    """Return the noisy points to which a curve was fitted, or None of any other curve."""
    points = None if curve.provenance is None else curve.provenance.measured
    return points if points is not None and points.wavers else None


def stray_point(curve: PlaneCurve) -> tuple[Refusal, ...]:
    """The sentence about the measured point that stands out; none where none does."""
    points = measured_points(curve)
    return () if points is None else points.stray


def changes_of(curve: PlaneCurve) -> tuple[Change, ...]:
    """With which a strip may come near a curve that none takes: points that waver are smoothed first.

    None where a point stands out: nobody wants a strip near a mistyped number.
    """
    points = measured_points(curve)
    if points is not None and points.stray:
        return ()
    smoothing = [] if points is None else [Change("smooth", times * points.reach) for times in (1, 2)]
    return (*smoothing, Change("nearest", True))


def lengths(s: Iterable[float]) -> Listed:
    """Places along the curve, without traces of rounding: "12 and 34.5 mm"."""
    return Listed(Length(round(x, 6)) for x in s)


def shown_on(curve: PlaneCurve, point: FloatArray) -> str:
    """A point (2,) as the program shows it in which the curve was drawn."""
    drawn = curve.provenance
    return (drawn or Provenance()).shown(point)
