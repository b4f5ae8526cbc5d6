"""Laws of nonlinear materials: M = P(kappa) w kappa for moment M, width w, curvature kappa (Appendix D)."""

from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import Any, Self

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import is_number, numbers, require_positive
from elastica_cad.errors import InputError, Length
from elastica_cad.mechanics.sheets import Sheet

_ROUNDING_SHARE = 1e-12


class MaterialLaw(ABC):
    """Moment-curvature law of a strip of width 1, divided by its stiffness at curvature 0.

    Hooke's law becomes M = K m(kappa - kappa_0) for moment M, stiffness K, curvature kappa and natural curvature
    kappa_0. The effective curvature is m(kappa) = P(kappa) kappa, with P even and P(0) = 1. Theorem 1 and the
    linear program remain valid as long as m is injective in the range of curvatures that occurs.
    """

    @property
    @abstractmethod
    def injective_limit(self) -> float:
        """Largest curvature, 1/mm, up to which equal moments mean equal curvatures; inf if there is no limit."""

    @property
    def kinks(self) -> tuple[tuple[float, int], ...]:
        """Positive curvatures, 1/mm, at which the law is not smooth, with the number of continuous derivatives."""
        return ()

    @abstractmethod
    def effective_curvature(self, curvature: ArrayLike) -> FloatArray:
        """Return moment / initial stiffness (n,), 1/mm, an odd function of the change of curvature (n,), 1/mm."""

    @abstractmethod
    def slope(self, curvature: ArrayLike) -> FloatArray:
        """Return the derivative (n,) of moment / initial stiffness by the change of curvature; 1 at curvature 0."""

    def with_slope(self, curvature: ArrayLike) -> tuple[FloatArray, FloatArray]:
        """Return moment / initial stiffness (n,), 1/mm, and its derivative (n,) by the change of curvature."""
        return self.effective_curvature(curvature), self.slope(curvature)

    @abstractmethod
    def energy(self, curvature: ArrayLike) -> FloatArray:
        """Return the elastic energy per length over the stiffness (n,), 1/mm2, by integration of the law."""

    def resampled(self, _s: FloatArray, _at: FloatArray, /) -> "MaterialLaw":
        """Return the law for other arc lengths (m,), mm, or the same law if it is uniform along the strip."""
        return self

    def require_injective(self, largest_curvature: float) -> None:
        """Refuse a law that is not injective up to `largest_curvature` (1/mm)."""
        limit = self.injective_limit
        if largest_curvature > limit * (1 + _ROUNDING_SHARE):
            raise InputError(
                "the moment of the material law increases only up to a curvature of {limit:.4g} 1/mm "
                "(radius {limit_2:.4g}), but the curve has {largest_curvature:.4g} 1/mm. Draw a gentler "
                "curve, or use a thinner sheet",
                limit=limit,
                limit_2=Length(1 / limit),
                largest_curvature=largest_curvature,
            )

    def require_design(self, largest_curvature: float) -> None:
        """Refuse the law if no strip can be designed for curvatures up to `largest_curvature` (1/mm)."""
        self.require_injective(largest_curvature)

    def curvature(self, effective: ArrayLike) -> FloatArray:
        """Return the inverse of `effective_curvature` (n,), 1/mm, by bisection."""
        m = np.asarray(effective, dtype=float)
        largest = float(np.abs(m).max(initial=0.0))
        top = min(largest, self.injective_limit)
        for _ in range(60):
            if self.effective_curvature(top) >= largest or top >= self.injective_limit:
                break
            top = min(2 * top, self.injective_limit)
        reached = float(self.effective_curvature(top))
        if largest > reached * (1 + _ROUNDING_SHARE):
            raise InputError(
                f"the material law reaches only {100 * reached / largest:.4g} % of the largest moment in the "
                "strip: draw a gentler curve, or use a thinner sheet"
            )
        low, high = np.zeros(m.shape), np.full(m.shape, top)
        for _ in range(100):
            middle = (low + high) / 2
            small = self.effective_curvature(middle) < np.abs(m)
            low, high = np.where(small, middle, low), np.where(small, high, middle)
        return np.asarray(np.sign(m) * (low + high) / 2)


@dataclass(frozen=True)
class PolynomialLaw(MaterialLaw):
    """Nonlinear elastic law in which the moment is P kappa times the initial stiffness.

    For a change of curvature kappa, P = 1 + c2 (kappa/kappa_1)^2 + c4 (kappa/kappa_1)^4. The material hardens if
    c2 > 0 and softens if c2 < 0.

    Parameters
    ----------
    quadratic, quartic : float
        Coefficients c2 and c4.
    curvature_scale : float
        Curvature kappa_1, 1/mm, at which the terms of P are c2 and c4.

    Examples
    --------
    >>> softening = PolynomialLaw(-0.2, curvature_scale=0.02)
    >>> softening.effective_curvature([0.01, -0.02]).round(6).tolist()
    [0.0095, -0.016]
    """

    quadratic: float
    quartic: float = 0.0
    curvature_scale: float = 1.0

    def __post_init__(self) -> None:
        for name in ("quadratic", "quartic"):
            if not is_number(getattr(self, name)):
                raise InputError(
                    f"{name} coefficient of the material law is {getattr(self, name)}: give a finite number"
                )
        require_positive(self.curvature_scale, "the law's curvature scale", "1/mm")

    def effective_curvature(self, curvature: ArrayLike) -> FloatArray:
        """See `MaterialLaw.effective_curvature`."""
        kappa = numbers(curvature, "curvature")
        t = (kappa / self.curvature_scale) ** 2
        return np.asarray(kappa * (1 + self.quadratic * t + self.quartic * t**2))

    def slope(self, curvature: ArrayLike) -> FloatArray:
        """See `MaterialLaw.slope`."""
        t = (numbers(curvature, "curvature") / self.curvature_scale) ** 2
        return np.asarray(1 + 3 * self.quadratic * t + 5 * self.quartic * t**2)

    def energy(self, curvature: ArrayLike) -> FloatArray:
        """See `MaterialLaw.energy`."""
        kappa = numbers(curvature, "curvature")
        t = (kappa / self.curvature_scale) ** 2
        return np.asarray(kappa**2 * (1 / 2 + self.quadratic / 4 * t + self.quartic / 6 * t**2))

    @property
    def injective_limit(self) -> float:
        """Exact root of a quadratic, at which the slope is 0; see `MaterialLaw.injective_limit`."""
        roots = np.roots([5 * self.quartic, 3 * self.quadratic, 1.0])
        real = [float(z.real) for z in roots if z.real > 0 and abs(z.imag) <= _ROUNDING_SHARE * abs(z)]
        return self.curvature_scale * float(np.sqrt(min(real))) if real else float("inf")


@dataclass(frozen=True)
class _YieldingLaw(MaterialLaw):
    """Law of a material that yields: beyond `curvature_limit`, 1/mm, a part of the bend remains."""

    curvature_limit: float

    def __post_init__(self) -> None:
        require_positive(self.curvature_limit, "the law's curvature limit", "1/mm")

    @classmethod
    def of(cls, sheet: Sheet) -> Self:
        """Return the law of a strip whose surface yields at the largest strain of the sheet."""
        return cls(1 / sheet.least_radius)

    def permanent_curvature(self, curvature: ArrayLike) -> FloatArray:
        """Return the curvature (n,), 1/mm, that remains after elastic unloading by Hooke's law."""
        return np.asarray(numbers(curvature, "curvature") - self.effective_curvature(curvature))


@dataclass(frozen=True)
class PlasticLaw(_YieldingLaw):
    """Ideal plasticity of the paper: moment / initial stiffness is kappa, limited to +-kappa_lim.

    The law is not injective beyond kappa_lim. There the curvature depends on the history of bending (paper,
    Appendix D).

    Parameters
    ----------
    curvature_limit : float
        Limit kappa_lim, 1/mm.

    Examples
    --------
    >>> PlasticLaw(0.05).effective_curvature([0.02, -0.08]).tolist()
    [0.02, -0.05]
    """

    def effective_curvature(self, curvature: ArrayLike) -> FloatArray:
        """See `MaterialLaw.effective_curvature`."""
        limit = self.curvature_limit
        return np.asarray(numbers(curvature, "curvature").clip(-limit, limit))

    def slope(self, curvature: ArrayLike) -> FloatArray:
        """See `MaterialLaw.slope`; the slope is 0 beyond the limit."""
        return np.asarray(np.abs(numbers(curvature, "curvature")) < self.curvature_limit, dtype=float)

    def energy(self, curvature: ArrayLike) -> FloatArray:
        """See `MaterialLaw.energy`."""
        kappa = np.abs(numbers(curvature, "curvature"))
        elastic = np.minimum(kappa, self.curvature_limit)
        return np.asarray(elastic * (kappa - elastic / 2))

    @property
    def injective_limit(self) -> float:
        """See `MaterialLaw.injective_limit`."""
        return self.curvature_limit

    @property
    def kinks(self) -> tuple[tuple[float, int], ...]:
        """See `MaterialLaw.kinks`."""
        return ((self.curvature_limit, 0),)

    def require_design(self, largest_curvature: float) -> None:
        """Accept every curvature, as in the paper: the injective limit is not checked."""


@dataclass(frozen=True)
class ElasticPlasticLaw(_YieldingLaw):
    """Elastic-plastic law of a rectangular cross-section that yields from its surfaces inwards.

    The ratio moment / initial stiffness is kappa up to kappa_lim, and kappa_lim (3 - (kappa_lim/kappa)^2) / 2
    beyond it. The ratio is at most 1.5 kappa_lim. The law is injective, unlike the paper's `PlasticLaw`, because
    every cross-section has an elastic core (Prager and Hodge 1951, section 9).

    Parameters
    ----------
    curvature_limit : float
        Curvature kappa_lim at which the surface begins to yield, 1/mm.

    Examples
    --------
    >>> ElasticPlasticLaw(0.05).effective_curvature([0.02, 0.1]).round(6).tolist()
    [0.02, 0.06875]
    """

    def effective_curvature(self, curvature: ArrayLike) -> FloatArray:
        """See `MaterialLaw.effective_curvature`."""
        kappa = numbers(curvature, "curvature")
        core = self._core(kappa)
        yielded = np.sign(kappa) * self.curvature_limit * (3 - core**2) / 2
        return np.where(core < 1, yielded, kappa)

    def slope(self, curvature: ArrayLike) -> FloatArray:
        """See `MaterialLaw.slope`."""
        return self._core(numbers(curvature, "curvature")) ** 3

    def energy(self, curvature: ArrayLike) -> FloatArray:
        """See `MaterialLaw.energy`."""
        kappa = np.abs(numbers(curvature, "curvature"))
        limit, beyond = self.curvature_limit, np.maximum(kappa, self.curvature_limit)
        yielded = 1.5 * limit * (beyond - limit) + limit**3 / 2 * (1 / beyond - 1 / limit)
        return np.asarray(np.minimum(kappa, limit) ** 2 / 2 + yielded)

    @property
    def injective_limit(self) -> float:
        """Infinite; see `MaterialLaw.injective_limit`."""
        return float("inf")

    @property
    def kinks(self) -> tuple[tuple[float, int], ...]:
        """See `MaterialLaw.kinks`."""
        return ((self.curvature_limit, 1),)

    def _core(self, kappa: FloatArray) -> FloatArray:
        """Return the elastic fraction of the thickness at curvatures `kappa`, 1/mm."""
        return self.curvature_limit / np.maximum(np.abs(kappa), self.curvature_limit)


@dataclass(frozen=True, eq=False)
class TabulatedLaw(MaterialLaw):
    """Measured table of moments and curvatures, interpolated by shape-preserving cubics. The law is odd.

    Parameters
    ----------
    curvatures : (m,) array_like
        Positive, increasing curvatures, 1/mm; the point (0, 0) is added.
    moments : (m,) array_like
        Moments in any unit, because they are divided by the slope at curvature 0.

    Examples
    --------
    >>> law = TabulatedLaw([0.01, 0.02, 0.03], [1.0, 1.9, 2.6])
    >>> bool(law.effective_curvature(0.02) < 0.02)
    True
    """

    curvatures: FloatArray
    moments: FloatArray

    def __post_init__(self) -> None:
        for name in ("curvatures", "moments"):
            array = numbers(getattr(self, name), f"the law's {name}").copy()
            if array.ndim != 1 or array.size < 2 or not np.isfinite(array).all() or (array <= 0).any():
                raise InputError(
                    f"{name} of the material law cannot be used: give at least two positive, finite numbers"
                )
            array.setflags(write=False)
            object.__setattr__(self, name, array)
        if self.curvatures.shape != self.moments.shape:
            raise InputError(
                f"the material law has {self.curvatures.size} curvatures and {self.moments.size} moments: give "
                "as many moments as curvatures"
            )
        if (np.diff(self.curvatures) <= 0).any():
            i = np.diff(self.curvatures).argmin()
            raise InputError(
                f"the curvatures of the material law do not increase: {self.curvatures[i + 1]:g} follows "
                f"{self.curvatures[i]:g} 1/mm. Give increasing curvatures"
            )

    def effective_curvature(self, curvature: ArrayLike) -> FloatArray:
        """See `MaterialLaw.effective_curvature`; beyond the last curvature, the slope is constant."""
        kappa = numbers(curvature, "curvature")
        inside, over = self._split(kappa)
        return np.asarray(np.sign(kappa) * (self._curve(inside) + self._end_slope * over))

    def slope(self, curvature: ArrayLike) -> FloatArray:
        """See `MaterialLaw.slope`."""
        return np.asarray(self._curve(self._split(curvature)[0], 1))

    def energy(self, curvature: ArrayLike) -> FloatArray:
        """See `MaterialLaw.energy`."""
        inside, over = self._split(curvature)
        top = self._curve(self.curvatures[-1])
        return np.asarray(self._curve.antiderivative()(inside) + over * (top + self._end_slope * over / 2))

    @property
    def injective_limit(self) -> float:
        """Curvature where the moments first decrease, or the last curvature; see `MaterialLaw.injective_limit`."""
        falling = np.flatnonzero(np.diff(self.moments) <= 0)
        return float(self.curvatures[falling[0]] if falling.size else self.curvatures[-1])

    @property
    def kinks(self) -> tuple[tuple[float, int], ...]:
        """All `curvatures`; see `MaterialLaw.kinks`."""
        return tuple((kappa, 1) for kappa in self.curvatures.tolist())

    def require_injective(self, largest_curvature: float) -> None:
        """Refuse the law also if `largest_curvature` exceeds the measured curvatures."""
        if largest_curvature > self.curvatures[-1] * (1 + _ROUNDING_SHARE):
            raise InputError(
                f"the material law ends at a curvature of {self.curvatures[-1]:.4g} 1/mm, but the curve has "
                f"{largest_curvature:.4g} 1/mm: measure larger curvatures, or draw a gentler curve"
            )
        super().require_injective(largest_curvature)

    def _split(self, curvature: ArrayLike) -> tuple[FloatArray, FloatArray]:
        kappa = np.abs(numbers(curvature, "curvature"))
        inside = np.minimum(kappa, self.curvatures[-1])
        return inside, kappa - inside

    @cached_property
    def _curve(self) -> Any:
        """Moment / initial stiffness as a piecewise cubic of the curvature, starting at 0 with slope 1."""
        from scipy.interpolate import PchipInterpolator, PPoly

        x = np.concatenate([-self.curvatures[::-1], [0.0], self.curvatures])
        odd = PchipInterpolator(x, np.concatenate([-self.moments[::-1], [0.0], self.moments]))
        half = self.curvatures.size
        return PPoly(odd.c[:, half:] / float(odd(0.0, 1)), odd.x[half:])

    @property
    def _end_slope(self) -> float:
        return float(self._curve(self.curvatures[-1], 1))
