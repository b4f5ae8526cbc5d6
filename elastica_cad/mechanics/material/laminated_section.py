"""The section of two sheets glued back to back: from widths to bending stiffness E I, weight, strain, and back."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import is_number, numbers, require_positive
from elastica_cad.errors import InputError
from elastica_cad.geometry.paths.profile import Profile
from elastica_cad.mechanics.loads.weight import Weight
from elastica_cad.mechanics.material.plain_section import areal_weight, layer_strain
from elastica_cad.mechanics.material.section_limits import (
    LIMIT_SLACK,
    LayerStrain,
    ScaleRange,
    matched,
    positive,
)
from elastica_cad.mechanics.material.sheet import Sheet
from elastica_cad.mechanics.material.tapered_sections import FixedLaw

_TOUCH_SHARE = 1e-5
"""Relative slack on limits for a stiffness that is known between its nodes to 1e-6."""


@dataclass(frozen=True)
class LaminatedSection:
    """Two rectangles glued back to back, exact about their own neutral axis.

    The base (width w1, thickness h1) makes the outline; the backing (w2 <= w1, h2) adds stiffness. Each layer
    has its own modulus along the strip, so plywood may lie either way. The paper's formula of section 8.1
    keeps the neutral axis where it is and is 12 to 37 % too soft at h1/h2 = 1/2. With A_i = E_i w_i h_i and d
    = (h1 + h2)/2:

        E I = (A1 h1^2 + A2 h2^2) / 12 + d^2 A1 A2 / (A1 + A2)

    Parameters
    ----------
    base, backing : Sheet
        Outer and glued-on sheet.

    Examples
    --------
    >>> card = Sheet("card", 1.0, 12.0, density=600.0, max_strain=0.01)
    >>> section = LaminatedSection(card, card)
    >>> section.bending_stiffness(10.0, [0.0, 10.0]).round(9).tolist()
    [10.0, 80.0]
    >>> section.backing_width(10.0, 80.0).round(9).item()
    10.0
    """

    base: Sheet
    backing: Sheet

    def on(self, base_width: ArrayLike) -> "BackingLaw":
        """The law of the backing's width on a base of given widths (n,), mm."""
        return BackingLaw(self, positive(base_width, "base width"))

    @property
    def thickness(self) -> float:
        """Whole thickness, mm."""
        return self.base.thickness + self.backing.thickness

    def bending_stiffness(self, base_width: ArrayLike, backing_width: ArrayLike) -> FloatArray:
        """E I (n,), N mm2, of widths (n,), mm."""
        return self._stiffness(*self._widths(base_width, backing_width))

    def backing_width(self, base_width: ArrayLike, bending_stiffness: ArrayLike) -> FloatArray:
        """Backing width w2 (n,), mm, for the E I (n,), N mm2: the root of a quadratic, station by station.

        Raises
        ------
        InputError
            E I below that of the base alone or above that of two full layers; says at which station.
        """
        w1 = positive(base_width, "base width")
        EI = positive(bending_stiffness, "bending stiffness")
        w1, EI = matched(w1, EI)
        least, most = self._stiffness(w1, 0.0 * w1), self._stiffness(w1, w1)
        _refuse_stations(
            least * (1 - _TOUCH_SHARE) > EI,
            EI,
            "less than the base alone has: narrow the base or raise the scale",
        )
        _refuse_stations(
            most * (1 + _TOUCH_SHARE) < EI,
            EI,
            "more than two full layers have: widen the base or lower the scale",
        )
        A1, _ = self._axial(w1, 0.0 * w1)
        _, h2, d = self._heights
        p = h2**2 / 12
        # with x = A2:  p x^2 + q x - D A1 = 0;  D is what the backing must add
        D = np.maximum(EI - least, 0.0)
        q = A1 * (p + d**2) - D
        root = np.sqrt(q**2 + 4 * p * D * A1)
        # the form without cancellation depends on the sign of q
        safe = np.where(q > 0, q + root, 1.0)
        x = np.where(q > 0, 2 * D * A1 / safe, (root - q) / (2 * p))
        return np.minimum(x / (self.backing.youngs_modulus * h2), w1)

    def stiffening(self, base_width: ArrayLike, backing_width: ArrayLike) -> FloatArray:
        """d(E I) / d(w2) (n,), N mm: what one more mm of backing adds; always positive."""
        w1, w2 = self._widths(base_width, backing_width)
        A1, A2 = self._axial(w1, w2)
        _, h2, d = self._heights
        per_width = self.backing.youngs_modulus * h2
        return np.asarray(per_width * (h2**2 / 12 + (d * A1 / (A1 + A2)) ** 2))

    def neutral_axis(self, base_width: ArrayLike, backing_width: ArrayLike) -> FloatArray:
        """Height (n,) of the neutral axis above the free face of the base, mm."""
        w1, w2 = self._widths(base_width, backing_width)
        A1, A2 = self._axial(w1, w2)
        h1, _, d = self._heights
        return np.asarray(h1 / 2 + d * A2 / (A1 + A2))

    def distances(self, base_width: ArrayLike, backing_width: ArrayLike) -> tuple[FloatArray, FloatArray]:
        """Distance (n,) of the outermost fibre of base and backing from the neutral axis, mm.

        The backing's is 0 where there is none.
        """
        axis = self.neutral_axis(base_width, backing_width)
        glue = np.abs(axis - self.base.thickness)
        there = np.broadcast_to(np.asarray(backing_width, dtype=float) > 0, axis.shape)
        return np.maximum(axis, glue), np.where(there, np.maximum(self.thickness - axis, glue), 0.0)

    def strains(
        self,
        curvature: ArrayLike,
        base_width: ArrayLike,
        backing_width: ArrayLike,
        *,
        natural_curvature: float = 0.0,
    ) -> tuple[LayerStrain, LayerStrain]:
        """Strain of base and backing: each from its own distance to the neutral axis, against its own limit.

        Parameters
        ----------
        curvature : (n,) array_like
            1/mm, signed or not.
        base_width, backing_width : (n,) array_like
            mm.
        natural_curvature : float
            Curvature of the laminate at rest, 1/mm.
        """
        bend = np.abs(np.asarray(curvature, dtype=float) - natural_curvature)
        outer, inner = self.distances(base_width, backing_width)
        return layer_strain(self.base, outer, bend), layer_strain(self.backing, inner, bend)

    def curvature_limit(self, base_width: ArrayLike, backing_width: ArrayLike) -> FloatArray:
        """Largest |kappa - kappa_0| (n,), 1/mm, that both layers bear."""
        outer, inner = self.distances(base_width, backing_width)
        return np.minimum(
            self.base.max_strain / outer,
            np.where(inner > 0, self.backing.max_strain / np.where(inner > 0, inner, 1.0), np.inf),
        )

    def weight_per_length(self, base_width: ArrayLike, backing_width: ArrayLike) -> FloatArray:
        """N/mm (n,) of widths (n,), mm; linear in both, not in E I."""
        w1, w2 = self._widths(base_width, backing_width)
        return np.asarray(areal_weight(self.base) * w1 + areal_weight(self.backing) * w2)

    def weight(
        self, s: ArrayLike, base_width: ArrayLike, stiffness: ArrayLike, bending_stiffness: float
    ) -> Weight:
        """The weight law alpha(s) + beta(s) K, exact at the given K and tangent to the true law there.

        Parameters
        ----------
        s : (n,) array_like
            Arc length of the stations, mm.
        base_width, stiffness : (n,) array_like
            w1, mm, and K.
        bending_stiffness : float
            B, N mm2, the E I where K = 1: the scale c.

        Notes
        -----
        Iterated with an optimal K this is Newton's method for the laminate's fixed point; `optimal_laminate`
        does it.
        """
        require_positive(bending_stiffness, "bending stiffness", "N mm2")
        K, w1 = matched(positive(stiffness, "stiffness"), positive(base_width, "base width"))
        w2 = self.backing_width(w1, bending_stiffness * K)
        beta = areal_weight(self.backing) * bending_stiffness / self.stiffening(w1, w2)
        alpha = self.weight_per_length(w1, w2) - beta * K
        return Weight(alpha=Profile.interpolate(s, alpha), beta=Profile.interpolate(s, beta))

    def scale_range(
        self, base_width: ArrayLike, stiffness: ArrayLike, *, least_backing: float = 0.0
    ) -> ScaleRange:
        """Scales c for which `least_backing` <= w2 <= w1 everywhere (paper, 8.1, with the exact section).

        Parameters
        ----------
        base_width, stiffness : (n,) array_like
            w1, mm, and K.
        least_backing : float
            Narrowest backing that can be cut and glued, mm; a base narrower than that is backed fully.
        """
        w1 = positive(base_width, "base width")
        if not (is_number(least_backing) and least_backing >= 0):
            raise InputError(f"least backing width is {least_backing!r}: it can't be negative, in mm")
        return ScaleRange.of(
            self._stiffness(w1, np.minimum(least_backing, w1)), self._stiffness(w1, w1), stiffness
        )

    def thickness_ratio(
        self, base_width: ArrayLike, stiffness: ArrayLike, *, least_backing: float = 0.0
    ) -> float:
        """The largest h1/h2 that can be built with these materials, the base kept as it is.

        Any smaller ratio (a thicker backing) would do as well; inf when the base needs no backing at all.

        Raises
        ------
        InputError
            When no thickness would do, because `least_backing` fills the base where it should stay soft.
        """
        K, w1 = positive(stiffness, "stiffness"), positive(base_width, "base width")

        def feasible(ratio: float) -> bool:
            backing = replace(self.backing, thickness=self.base.thickness / ratio, thickness_range=None)
            return (
                LaminatedSection(self.base, backing).scale_range(w1, K, least_backing=least_backing).feasible
            )

        low, high = 1e-6, 1e6
        if feasible(high):
            return float("inf")
        if not feasible(low):
            raise InputError(
                f"no backing thickness would do: a least backing of {least_backing:g} mm is too wide for a "
                f"base of {w1.min():.4g} mm and a stiffness ratio of {K.max() / K.min():.4g}"
            )
        while high / low > 1 + 1e-12:
            middle = float(np.sqrt(low * high))
            low, high = (middle, high) if feasible(middle) else (low, middle)
        return low

    @property
    def _heights(self) -> tuple[float, float, float]:
        """h1, h2 and the distance of the layers' own axes."""
        return self.base.thickness, self.backing.thickness, self.thickness / 2

    def _stiffness(self, w1: FloatArray, w2: FloatArray) -> FloatArray:
        """E I (n,), N mm2, of widths that are known to be good."""
        A1, A2 = self._axial(w1, w2)
        h1, h2, d = self._heights
        return np.asarray((A1 * h1**2 + A2 * h2**2) / 12 + d**2 * A1 * A2 / (A1 + A2))

    def _axial(self, w1: FloatArray, w2: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Axial stiffness E w h of both layers, N."""
        return (
            self.base.youngs_modulus * self.base.thickness * w1,
            self.backing.youngs_modulus * self.backing.thickness * w2,
        )

    def _widths(self, base_width: ArrayLike, backing_width: ArrayLike) -> tuple[FloatArray, FloatArray]:
        w1, w2 = matched(positive(base_width, "base width"), numbers(backing_width, "backing width"))
        if not np.all((w2 >= 0) & (w2 <= w1 * (1 + LIMIT_SLACK))):
            i = int(np.argmin((w2 >= 0) & (w2 <= w1 * (1 + LIMIT_SLACK))))
            raise InputError(
                f"backing width at station {i} is {w2.flat[i]:.6g} mm: it must lie between 0 and the base's "
                f"{w1.flat[i]:.6g} mm"
            )
        return w1, w2


@dataclass(frozen=True, eq=False)
class BackingLaw:
    """A laminate as a `StiffnessLaw`: the base is given, the backing's width decides.

    Attributes
    ----------
    section : LaminatedSection
    base_width : (n,) array
        mm.

    Examples
    --------
    >>> card = Sheet("card", 1.0, 12.0, density=600.0, max_strain=0.01)
    >>> LaminatedSection(card, card).on(10.0).parameter(80.0).round(9).item()
    10.0
    """

    section: LaminatedSection
    base_width: FloatArray

    def bending_stiffness(self, backing_width: ArrayLike) -> FloatArray:
        """E I (n,), N mm2, of backing widths (n,), mm."""
        return self.section.bending_stiffness(self.base_width, backing_width)

    def parameter(self, bending_stiffness: ArrayLike) -> FloatArray:
        """Backing widths (n,), mm, that give the E I (n,), N mm2."""
        return self.section.backing_width(self.base_width, bending_stiffness)

    def weight_per_length(self, backing_width: ArrayLike) -> FloatArray:
        """N/mm (n,) of backing widths (n,), mm."""
        return self.section.weight_per_length(self.base_width, backing_width)

    def strains(
        self, curvature: ArrayLike, backing_width: ArrayLike, *, natural_curvature: float = 0.0
    ) -> tuple[LayerStrain, ...]:
        """Strain of base and backing."""
        return self.section.strains(
            curvature, self.base_width, backing_width, natural_curvature=natural_curvature
        )


@dataclass(frozen=True, eq=False)
class BoundedBacking(BackingLaw, FixedLaw):
    """The same on a base of one width, the backing within limits: what `nearest_rod` takes as `section`.

    Attributes
    ----------
    limits : (float, float)
        Least and largest width of the backing, mm.
    """

    limits: tuple[float, float]

    @property
    def quantity(self) -> str:
        """The backing."""
        return "backing"

    def parameter(self, bending_stiffness: ArrayLike) -> FloatArray:
        """Backing widths (n,), mm, that give the E I (n,), N mm2, or come nearest within the limits."""
        least, most = self.bending_stiffness(np.array(self.limits))
        return np.clip(super().parameter(np.clip(bending_stiffness, least, most)), *self.limits)


def stack_stiffness(layers: Sequence[tuple[Sheet, ArrayLike]]) -> FloatArray:
    """E I (n,), N mm2, of sheets of given widths (n,), mm, glued one on another, about their common neutral axis.

    Examples
    --------
    >>> card = Sheet("card", 1.0, 12.0, density=600.0, max_strain=0.01)
    >>> stack_stiffness([(card, 10.0)] * 3).round(9).item()
    270.0
    """
    heights = np.array([sheet.thickness for sheet, _ in layers])
    middles = np.cumsum(heights) - heights / 2
    axial = [
        sheet.youngs_modulus * sheet.thickness * np.asarray(width, dtype=float) for sheet, width in layers
    ]
    axis = sum(a * z for a, z in zip(axial, middles, strict=True)) / sum(axial)
    parts = zip(axial, heights, middles, strict=True)
    return np.asarray(sum(a * (h**2 / 12 + (z - axis) ** 2) for a, h, z in parts))


def _refuse_stations(bad: NDArray[np.bool_], bending_stiffness: FloatArray, text: str) -> None:
    if bad.any():
        i = int(np.argmax(bad))
        raise InputError(f"station {i} asks for E I = {bending_stiffness.flat[i]:.4g} N mm2, {text}")
