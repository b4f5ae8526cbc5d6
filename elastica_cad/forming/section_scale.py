"""A section with limits as the search for a nearest rod sees it: K of one scale, its weight and its strain."""

from dataclasses import dataclass, replace
from typing import Self

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import InputError
from elastica_cad.forming.limits import Limits
from elastica_cad.geometry.paths.profile import Profile
from elastica_cad.mechanics.loads.weight import Weight
from elastica_cad.mechanics.material.stiffness_law import BoundedLaw
from elastica_cad.mechanics.rod.curling_law import CurlingLaw
from elastica_cad.mechanics.rod.rod_record import Rod
from elastica_cad.mechanics.stiffness.section_balance import TangentWeight

SAME_SCALE = 1e-5
"""Relative difference of scales below which the weight is that of the sections that are made."""

FULL_STRAIN = 1 - 2e-5
"""Share of a strain limit that is sought: nodes and fitted sizes miss the largest strain by less than the rest."""


@dataclass(frozen=True, eq=False)
class SectionScale:
    """E I = `scale` K with 1 <= K <= `ratio` within the limits of a section.

    Attributes
    ----------
    law : BoundedLaw
    scale : float
        N mm2.
    ratio : float
    """

    law: BoundedLaw
    scale: float
    ratio: float

    @classmethod
    def of(cls, law: BoundedLaw, limits: Limits, *, heavy: bool) -> "SectionScale":
        """Where another limit allows a smaller ratio, of the largest sections; if light, of those that bear most.

        A rod without weight takes the same shape in any size. Thin strips bear a sharper bend than thick ones,
        laminates where the backing is as wide as the base.

        Raises
        ------
        InputError
            The limits do not leave any section.
        """
        least, largest = law.limits
        ratio = limits.largest_ratio
        if not np.isfinite(largest):
            return cls(law, float(np.max(law.bending_stiffness(least))), ratio)
        most = float(np.min(law.bending_stiffness(largest)))
        if least > 0:
            low = float(np.max(law.bending_stiffness(least)))
            if low > most:
                raise InputError(
                    f"{law.quantity} limits {least:g} and {largest:g} mm are too close: widen them"
                )
            ratio = min(ratio, most / low)
            # what a law that follows the bend bears is no question of its size alone: its scale is settled later
            if not (heavy or law.follows_bend):
                thin, thick = cls(law, low, ratio).strain(np.array([1.0, most / low]), limits.strain)
                if thin < thick:
                    return cls(law, low, ratio)
        return cls(law, most / ratio, ratio)

    def grown(self, stiffness: FloatArray, bend: FloatArray, limits: Limits) -> Self:
        """As large as its limits and the strain let nodal K (n,) be, bent by kappa - kappa_0 (n,), 1/mm."""
        from scipy.optimize import brentq

        least, most = (
            pick(self.law.bending_stiffness(np.full(stiffness.size, limit)) / stiffness)
            for pick, limit in zip((np.max, np.min), self.law.limits, strict=True)
        )

        def room(log_scale: float) -> float:
            share = replace(self, scale=float(np.exp(log_scale))).strain(stiffness, limits.strain)
            return 1.0 - float(np.max(share * np.abs(bend)))

        low, high = np.log(min(least, self.scale)), np.log(max(most, self.scale))
        if limits.sheet is None or room(high) >= 0:
            return replace(self, scale=float(np.exp(high)))
        return replace(self, scale=float(np.exp(brentq(room, low, high)))) if room(low) > 0 else self

    def bearing(self, bend: FloatArray, limits: Limits) -> Self | None:
        """The largest smaller sections, in the same ratio, that all bear a bend (n,), 1/mm; None where none do.

        The thickest may bear too little while thinner ones take the curve.
        """
        least, largest = self.law.limits
        if limits.sheet is None or not (least > 0 and np.isfinite(largest)):
            return None
        low = float(np.max(self.law.bending_stiffness(least)))
        even = replace(self, scale=low).grown(np.ones(bend.size), bend, limits)
        scale = max(low, even.scale / self.ratio)
        return replace(self, scale=scale) if scale < self.scale * (1 - SAME_SCALE) else None

    def settled(self, bend: FloatArray, stiffness: FloatArray, rest: float | FloatArray) -> Self:
        """Scaled so that nodal K (n,), bent by kappa - kappa_0 (n,) from `rest`, comes up to the largest section.

        Itself where it has that scale already.
        """
        law = self.law.bent(bend, rest)
        least, largest = law.limits
        if np.isfinite(largest):
            scale = float(np.min(self.largest(bend, rest) / stiffness))
        else:
            scale = float(np.max(law.bending_stiffness(np.full(stiffness.size, least)) / stiffness))
        return self if abs(scale / self.scale - 1) < SAME_SCALE else replace(self, law=law, scale=scale)

    def largest(self, bend: FloatArray, rest: float | FloatArray) -> FloatArray:
        """E I (n,), N mm2, of the largest section, bent by kappa - kappa_0 (n,) from `rest`, 1/mm."""
        most = np.full(bend.size, self.law.limits[1])
        return self.law.bent(bend, rest).bending_stiffness(most)

    def weight(self, stiffness: FloatArray, *, size: float) -> tuple[FloatArray, FloatArray]:
        """Weight over the scale (n,) of K (n,), times `size` mm cubed, and its derivative."""
        EI = self.scale * stiffness
        tangent = TangentWeight.of(self.law, EI)
        over = size**3
        return (tangent.fixed / self.scale + tangent.slope * stiffness) * over, tangent.slope * over

    def carried_by(self, rod: Rod, stiffness: FloatArray) -> Rod:
        """The rod with its scale, and under gravity the weight of nodal K (n,) of the search."""
        EI = self.scale * stiffness
        scaled = replace(rod, bending_stiffness=float(EI.min()), section=self.law)
        if rod.gravity is None:
            return scaled
        tangent = TangentWeight.of(self.law, EI)
        alpha = Profile.interpolate(rod.s, tangent.fixed)
        return replace(scaled, weight=Weight(alpha, Profile.interpolate(rod.s, tangent.slope * EI.min())))

    def tangent(self, stiffness: FloatArray, bend: FloatArray, rest: float | FloatArray) -> FloatArray:
        """dM/dkappa (..., n) of K (..., n), in units of it, bent by kappa - kappa_0 (..., n) from `rest`, 1/mm."""
        law = self.law.bent(bend, rest)
        curl = law.curl(law.parameter(self.scale * stiffness))
        if curl is None:
            return stiffness
        return stiffness * CurlingLaw(curl, curl(bend + rest), rest).slope(bend)

    def strain(self, stiffness: FloatArray, limit: float | None) -> FloatArray:
        """Share (n,) of what the skin is let bear that a curvature of 1/mm takes, of K (n,)."""
        layers = self.law.strains(np.ones(stiffness.size), self.law.parameter(self.scale * stiffness))
        shares = [layer.strain / (FULL_STRAIN * (limit or layer.limit)) for layer in layers]
        return np.asarray(np.max(shares, axis=0))
