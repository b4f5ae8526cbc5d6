"""The curvature that a strip has before it is bent: one number, or a blank that was bent beforehand."""

from dataclasses import dataclass
from functools import cached_property
from typing import TypeAlias

import numpy as np

from elastica_cad._equality import EqualByValue
from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import is_number, require_number
from elastica_cad.errors import InputError
from elastica_cad.geometry.curves.plane_curve import CurvatureZero, PlaneCurve
from elastica_cad.geometry.paths.profile import Profile
from elastica_cad.geometry.polynomials.splines import finite
from elastica_cad.refusals import Length

LENGTHS_APART = 0.01
"""A natural curvature may be given for a strip that is longer or shorter than the curve by this share; it is
then scaled."""

BLANK_TOLERANCE = 1e-9
"""Error of the natural curvature, relative to its largest value."""

_SAMPLES = 401  # of a curve, where its largest curvature is looked for
_AT_BREAK_SHARE = 1e-9  # of the length: nearer places are on the break


@dataclass(frozen=True, eq=False)
class RestCurvature(EqualByValue):
    """The curvature kappa_0 of a strip before it is bent, along its length.

    Attributes
    ----------
    profile : Profile
        kappa_0, 1/mm, over the length of the blank, mm.

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
                "a rest curvature needs a Profile that begins at 0 mm: use RestCurvature.linear(stations, "
                "curvatures), or RestCurvature.of(curve) for a blank that is drawn"
            )

    @classmethod
    def linear(cls, stations: ArrayLike, curvatures: ArrayLike) -> "RestCurvature":
        """Straight between `curvatures` (n,), 1/mm, at `stations` (n,), mm from 0; a station twice is a step."""
        s, kappa_0 = finite("stations", stations), finite("curvatures", curvatures)
        rising = s.ndim == 1 and s.size >= 2 and s[0] == 0 and np.all(np.diff(s) >= 0)
        if s.shape != kappa_0.shape or not rising or np.any(s[2:] == s[:-2]) or s[1] == 0 or s[-1] == s[-2]:
            raise InputError(
                "a rest curvature is given at two or more stations, one curvature each: begin at 0 mm, go on to "
                "the length of the strip, and name a station twice at most, for a step between the ends"
            )
        return cls(Profile(np.concatenate([s[:1], s, s[-1:]]), kappa_0, 1))

    @classmethod
    def of(cls, blank: PlaneCurve) -> "RestCurvature":
        """The curvature of a blank as it lies unbent, drawn on the side from which the bent strip is drawn."""
        if not isinstance(blank, PlaneCurve):
            raise InputError(
                "the blank is {blank!r}: give the PlaneCurve in which it lies before it is bent", blank=blank
            )
        if blank.tangent_breaks:
            raise InputError(
                "the blank has a corner at {s:.4g}: round it, a strip has none",
                s=Length(blank.tangent_breaks[0].s),
            )
        size = max(float(np.abs(blank.sample(_SAMPLES).curvature).max()), 1 / blank.length)
        return cls(
            Profile.fit(
                lambda s: blank.at(s).curvature,
                blank.length,
                breaks=[(one.s, one.continuity - 2) for one in blank.breaks],
                tolerance=BLANK_TOLERANCE * size,
                degree=5,
            )
        )

    @property
    def length(self) -> float:
        """Length of the strip, mm."""
        return self.profile.length

    def at(self, s: FloatArray, derivative: int = 0, *, left: bool = False) -> FloatArray:
        """kappa_0, 1/mm, or its derivatives at places of the blank, mm; at a break from the right, or `left`."""
        s = np.clip(s, 0.0, self.length)
        for place, _ in self.profile.breaks:
            beside = np.nextafter(place, -1.0) if left else place
            s = np.where(np.abs(s - place) < _AT_BREAK_SHARE * self.length, beside, s)
        return self.profile(s, derivative)

    def stretch_to(self, length: float) -> float:
        """What lengths along a curve of `length` mm are multiplied by to be lengths along the blank.

        Raises
        ------
        InputError
            They differ by more than `LENGTHS_APART`.
        """
        length = require_number(length, "the length of the curve", "mm")
        if abs(length / self.length - 1) > LENGTHS_APART:
            raise InputError(
                "the blank is {length:.5g} long before it is bent, the curve {length_2:.5g}: give "
                "its curvature along the length of the curve",
                length=Length(self.length),
                length_2=Length(length),
            )
        return self.length / length


@dataclass(frozen=True, eq=False)
class CurveOfRest(RestCurvature):
    """The curvature of a drawn blank, evaluated on its curve without a fit; `profile` tells where it is not smooth.

    Attributes
    ----------
    blank : PlaneCurve
    """

    blank: PlaneCurve

    @classmethod
    def of(cls, blank: PlaneCurve) -> "CurveOfRest":
        """The curvature of a blank: see `RestCurvature.of`."""
        return cls(RestCurvature.of(blank).profile, blank)

    def at(self, s: FloatArray, derivative: int = 0, *, left: bool = False) -> FloatArray:
        """Natural curvature at arc lengths s, or its first derivative, as `RestCurvature.at` gives it."""
        t = self.blank.parameter(np.clip(s, 0.0, self.blank.length))
        for one in self.blank.breaks:
            t = np.where(np.abs(s - one.s) < _AT_BREAK_SHARE * self.length, one.t, t)
        along = self.blank.curvature_slope_at if derivative else self.blank.curvature_at
        return along(t, left=left)


NaturalCurvature: TypeAlias = float | RestCurvature
"""Natural curvature: one value for the whole strip, 1/mm, or one that varies along it."""


def nodal_curvature(rest: NaturalCurvature, s: FloatArray) -> float | FloatArray:
    """kappa_0, 1/mm: the number, or that of a blank (n,) at nodes (n,) from 0 to the length, mm.

    Raises
    ------
    InputError
        The rod is not as long as the blank.
    """
    return rest.at(s * rest.stretch_to(float(s[-1]))) if isinstance(rest, RestCurvature) else rest


def require_natural_curvature(value: object) -> None:
    """Refuse what is neither a finite number nor a `RestCurvature`."""
    if not (isinstance(value, RestCurvature) or is_number(value)):
        raise InputError(
            "natural_curvature is {given!r}: give a finite number, in 1/mm, or a RestCurvature "
            "for a blank that is bent beforehand",
            given=value,
        )


@dataclass(frozen=True, eq=False)
class ExcessCurvature:
    """kappa - kappa_0 along a curve: what a strip feels of it.

    Attributes
    ----------
    curve : PlaneCurve
    rest : float or RestCurvature
    """

    curve: PlaneCurve
    rest: NaturalCurvature

    @property
    def is_bent_beforehand(self) -> bool:
        """Whether the strip has a natural curvature."""
        return isinstance(self.rest, RestCurvature) or self.rest != 0

    def at(self, t: ArrayLike, *, left: bool = False) -> FloatArray:
        """kappa - kappa_0, 1/mm, at parameters t."""
        return np.asarray(self.curve.curvature_at(t, left=left) - self.rest_at(t, left=left))

    def slope_at(self, t: ArrayLike, *, left: bool = False) -> FloatArray:
        """Return the derivative with respect to arc length, 1/mm2."""
        return np.asarray(self.curve.curvature_slope_at(t, left=left) - self.rest_at(t, 1, left=left))

    def rest_at(self, t: ArrayLike, derivative: int = 0, *, left: bool = False) -> FloatArray | float:
        """kappa_0, 1/mm, or its first derivative by arc length, at parameters t."""
        if not isinstance(self.rest, RestCurvature):
            return 0.0 if derivative else self.rest
        s = self.curve.arc_length(t) * self._stretch
        return self.rest.at(s, derivative, left=left) * self._stretch**derivative

    @cached_property
    def survey(self) -> FloatArray:
        """Values (n,), 1/mm, at the places of the curve's own survey."""
        nodes = self.curve.survey
        return np.asarray(nodes.curvature - self.rest_at(nodes.t))

    @cached_property
    def kinks(self) -> tuple[tuple[float, float, int], ...]:
        """Places (t, s, continuity) where kappa_0 is no more than `continuity` times differentiable."""
        if not isinstance(self.rest, RestCurvature):
            return ()
        s = np.array([s for s, _ in self.rest.profile.breaks]) / self._stretch
        orders = [continuity for _, continuity in self.rest.profile.breaks]
        return tuple(zip(self.curve.parameter(s).tolist(), s.tolist(), orders, strict=True))

    @cached_property
    def zeros(self) -> tuple[CurvatureZero, ...]:
        """All zeros and sign changes, in order."""
        return self.equals(0.0)

    def equals(self, level: float) -> tuple[CurvatureZero, ...]:
        """All places where it is `level`, 1/mm; before, after: signs of it less the level."""
        if not isinstance(self.rest, RestCurvature):
            return self.curve.curvature_equals(self.rest + level)
        breaks = [(t, order >= 0) for t, _, order in self.kinks]
        return self.curve.zeros_along(lambda t: self.at(t) - level, self._size, breaks)

    @cached_property
    def _stretch(self) -> float:
        return self.rest.stretch_to(self.curve.length) if isinstance(self.rest, RestCurvature) else 1.0

    @cached_property
    def _size(self) -> float:
        """Size of the curvatures that are subtracted from each other, 1/mm."""
        t = np.linspace(*self.curve.domain, _SAMPLES)
        return float((np.abs(self.curve.curvature_at(t)) + np.abs(self.rest_at(t))).max())
