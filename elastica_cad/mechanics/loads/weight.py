"""Weight in physical units, for rods whose weight is not proportional to their stiffness."""

from dataclasses import dataclass, replace
from typing import Annotated

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import is_number, several
from elastica_cad.declared import Asked
from elastica_cad.errors import InputError
from elastica_cad.geometry.paths.profile import Profile
from elastica_cad.refusals import Length

STANDARD_GRAVITY_M_S2 = 9.80665  # m/s2


@dataclass(frozen=True)
class PointMass:
    """A mass hung on the rod: `mass` in g at arc length `at` in mm."""

    at: Annotated[float, Asked("Place along the strip.", "mm")]
    mass: Annotated[float, Asked("Mass that hangs there.", "g", least=0)]

    def __post_init__(self) -> None:
        if not is_number(self.at):
            raise InputError(
                "a point mass hangs at {at!r}: give a finite number of mm along the strip", at=self.at
            )
        if not (is_number(self.mass) and self.mass >= 0):
            raise InputError("a point mass is {mass!r}: it can't be negative, in g", mass=self.mass)


@dataclass(frozen=True, eq=False)
class Weight:
    """Weight per length alpha(s) + beta(s) K(s), and point masses.

    Parameters
    ----------
    alpha, beta : float or Profile
        N/mm; `beta` multiplies the dimensionless stiffness K (least value 1).
    masses : tuple of PointMass
        For example a lamp holder.
    own : bool
        Ask `optimal_rod` to add a plain strip's own weight, B / gravity.length^3, to `beta` once the least
        bending stiffness B is known; the rod it returns has it there, and `own` is False again.
    """

    alpha: Annotated[float | Profile, Asked("Weight per length.", "N/mm", least=0, written=float)] = 0.0
    beta: Annotated[
        float | Profile,
        Asked("Weight per length that goes with the stiffness K.", "N/mm", least=0, written=float),
    ] = 0.0
    masses: Annotated[tuple[PointMass, ...], Asked("Masses hung on the strip.")] = ()
    own: Annotated[bool, Asked("Add the own weight of the strip.")] = False

    def __post_init__(self) -> None:
        object.__setattr__(self, "masses", several("masses", self.masses, PointMass, "PointMass"))
        for name in ("alpha", "beta"):
            value = getattr(self, name)
            # a profile may dip below 0: alpha + beta K as the tangent of a laminate's law
            if not isinstance(value, Profile) and not (is_number(value) and value >= 0):
                raise InputError(
                    "weight {name} is {given!r}: it can't be negative, in N/mm", name=name, given=value
                )

    def scaled(self, alpha: float = 1.0, beta: float = 1.0) -> "Weight":
        """Return the weight with alpha and beta multiplied by these factors; the masses stay."""
        return replace(self, alpha=_times(self.alpha, alpha), beta=_times(self.beta, beta))

    def along(self, s: FloatArray) -> tuple[FloatArray, FloatArray]:
        """alpha and beta (n,) at arc lengths (n,), N/mm."""
        alpha, beta = (
            value(s) if isinstance(value, Profile) else np.full(s.shape, float(value))
            for value in (self.alpha, self.beta)
        )
        return alpha, beta

    def lumped(self, s: FloatArray, stiffness: FloatArray, node_lengths: FloatArray) -> FloatArray:
        """Weight of each node (n,), N; a point mass is shared by its two neighbours."""
        if self.own:
            raise InputError(
                "a strip's own weight has no value before optimal_rod has found it: give beta in N/mm"
            )
        alpha, beta = self.along(s)
        weight = node_lengths * (alpha + beta * stiffness)
        for point in self.masses:
            if not 0 <= point.at <= s[-1]:
                raise InputError(
                    "point mass at {at:.6g} lies off the rod of {s:.6g}", at=Length(point.at), s=Length(s[-1])
                )
            i = min(int(np.searchsorted(s, point.at, side="right")) - 1, s.size - 2)
            share = (point.at - s[i]) / (s[i + 1] - s[i])
            newtons = point.mass * 1e-3 * STANDARD_GRAVITY_M_S2
            weight[i] += (1 - share) * newtons
            weight[i + 1] += share * newtons
        return weight


def _times(value: float | Profile, factor: float) -> float | Profile:
    return value.scaled(factor) if isinstance(value, Profile) else value * factor
