"""Laws between moment and curvature that are not straight lines: M = P(kappa) w kappa (paper, Appendix D)."""

from abc import ABC, abstractmethod
from dataclasses import dataclass
from functools import cached_property

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad.errors import InputError
from elastica_cad.mechanics.sheet import Sheet

__all__ = ["ElasticPlasticLaw", "MaterialLaw", "PlasticLaw", "PolynomialLaw", "TabulatedLaw"]


class MaterialLaw(ABC):
    """A moment-curvature law of the unit width, divided by its stiffness at rest.

    The effective curvature m(kappa) = P(kappa) kappa, P even and P(0) = 1, takes the place of kappa - kappa_0
    wherever Hooke's law has M = K (kappa - kappa_0): M = K m(kappa - kappa_0). Theorem 1 and the linear
    program hold unchanged as long as m is injective in the range of curvatures that occurs.
    """

    @abstractmethod
    def effective_curvature(self, curvature: ArrayLike) -> FloatArray:
        """The odd function m (n,), 1/mm, of the change of curvature (n,), 1/mm."""

    @abstractmethod
    def slope(self, curvature: ArrayLike) -> FloatArray:
        """dm/dkappa (n,); 1 at rest."""

    @abstractmethod
    def require_injective(self, largest_curvature: float) -> None:
        """Make sure that each moment up to `largest_curvature` (1/mm) belongs to one curvature.

        Raises
        ------
        InputError
            When it does not; the message says from which curvature on.
        """

    def curvature(self, effective: ArrayLike, *, largest_curvature: float) -> FloatArray:
        """The inverse of `effective_curvature` for |kappa| up to `largest_curvature`, by bisection.

        Raises
        ------
        InputError
            The law is not injective there, or the moment is beyond what it reaches.
        """
        self.require_injective(largest_curvature)
        m = np.asarray(effective, dtype=float)
        top = float(self.effective_curvature(largest_curvature))
        if np.any(np.abs(m) > top * (1 + 1e-12)):
            raise InputError(
                f"an effective curvature of {np.abs(m).max():.4g} 1/mm is beyond the {top:.4g} 1/mm that "
                f"this material reaches at a curvature of {largest_curvature:.4g} 1/mm"
            )
        low, high = np.zeros(m.shape), np.full(m.shape, float(largest_curvature))
        for _ in range(80):
            middle = (low + high) / 2
            small = self.effective_curvature(middle) < np.abs(m)
            low, high = np.where(small, middle, low), np.where(small, high, middle)
        return np.asarray(np.sign(m) * (low + high) / 2)


@dataclass(frozen=True)
class PolynomialLaw(MaterialLaw):
    """Nonlinear elastic: P = 1 + c2 (kappa/kappa_1)^2 + c4 (kappa/kappa_1)^4; c2 > 0 hardens, c2 < 0 softens.

    Parameters
    ----------
    quadratic, quartic : float
        c2 and c4.
    curvature_scale : float
        kappa_1, 1/mm, where the coefficients are the relative change of P.

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
            if not np.isfinite(getattr(self, name)):
                raise InputError(f"{name} coefficient of the law is {getattr(self, name)}: it must be finite")
        _require_positive(self.curvature_scale, "curvature scale", "1/mm")

    def effective_curvature(self, curvature: ArrayLike) -> FloatArray:
        """See `MaterialLaw`."""
        kappa = np.asarray(curvature, dtype=float)
        t = (kappa / self.curvature_scale) ** 2
        return np.asarray(kappa * (1 + self.quadratic * t + self.quartic * t**2))

    def slope(self, curvature: ArrayLike) -> FloatArray:
        """See `MaterialLaw`."""
        t = (np.asarray(curvature, dtype=float) / self.curvature_scale) ** 2
        return np.asarray(1 + 3 * self.quadratic * t + 5 * self.quartic * t**2)

    def require_injective(self, largest_curvature: float) -> None:
        """See `MaterialLaw`; exact: the slope's roots are those of a quadratic."""
        for root in np.roots([5 * self.quartic, 3 * self.quadratic, 1.0]):
            if abs(root.imag) < 1e-12 * abs(root) and root.real > 0:
                _refuse_beyond(self.curvature_scale * float(np.sqrt(root.real)), largest_curvature)


@dataclass(frozen=True)
class PlasticLaw(MaterialLaw):
    """The paper's ideal plasticity: effective curvature min(|kappa|, kappa_lim) with the sign of kappa.

    It is not injective beyond the limit, where the moment says nothing about the curvature any more: the
    width comes out as for any law, but how far the strip bends there is up to the history of bending (paper,
    Appendix D).

    Parameters
    ----------
    curvature_limit : float
        kappa_lim, 1/mm.

    Examples
    --------
    >>> PlasticLaw(0.05).effective_curvature([0.02, -0.08]).tolist()
    [0.02, -0.05]
    """

    curvature_limit: float

    def __post_init__(self) -> None:
        _require_positive(self.curvature_limit, "curvature limit", "1/mm")

    @classmethod
    def of(cls, sheet: Sheet) -> "PlasticLaw":
        """The law whose limit is the sheet's least cold-bend radius."""
        return cls(1 / sheet.least_radius)

    def effective_curvature(self, curvature: ArrayLike) -> FloatArray:
        """See `MaterialLaw`."""
        limit = self.curvature_limit
        return np.asarray(np.clip(np.asarray(curvature, dtype=float), -limit, limit))

    def slope(self, curvature: ArrayLike) -> FloatArray:
        """See `MaterialLaw`; 0 beyond the limit."""
        return np.asarray(np.abs(np.asarray(curvature, dtype=float)) < self.curvature_limit, dtype=float)

    def require_injective(self, largest_curvature: float) -> None:
        """See `MaterialLaw`."""
        _refuse_beyond(self.curvature_limit, largest_curvature)

    def permanent_curvature(self, curvature: ArrayLike) -> FloatArray:
        """What is left when the moment is taken away (n,), 1/mm: the excess beyond the limit."""
        return np.asarray(np.asarray(curvature, dtype=float) - self.effective_curvature(curvature))


@dataclass(frozen=True)
class ElasticPlasticLaw(MaterialLaw):
    """A rectangular section whose fibres yield one after the other from the skin inwards.

    m = kappa up to kappa_lim, then kappa_lim (3 - (kappa_lim/kappa)^2) / 2, towards 1.5 kappa_lim: injective,
    unlike the paper's `PlasticLaw`, as every section keeps an elastic core (Prager and Hodge 1951, section
    9).

    Parameters
    ----------
    curvature_limit : float
        kappa_lim where the skin begins to yield, 1/mm.

    Examples
    --------
    >>> ElasticPlasticLaw(0.05).effective_curvature([0.02, 0.1]).round(6).tolist()
    [0.02, 0.06875]
    """

    curvature_limit: float

    def __post_init__(self) -> None:
        _require_positive(self.curvature_limit, "curvature limit", "1/mm")

    @classmethod
    def of(cls, sheet: Sheet) -> "ElasticPlasticLaw":
        """The law whose skin yields at the sheet's largest strain."""
        return cls(1 / sheet.least_radius)

    def effective_curvature(self, curvature: ArrayLike) -> FloatArray:
        """See `MaterialLaw`."""
        kappa = np.asarray(curvature, dtype=float)
        core = self._core(kappa)
        yielded = np.sign(kappa) * self.curvature_limit * (3 - core**2) / 2
        return np.where(core < 1, yielded, kappa)

    def slope(self, curvature: ArrayLike) -> FloatArray:
        """See `MaterialLaw`."""
        return self._core(np.asarray(curvature, dtype=float)) ** 3

    def require_injective(self, largest_curvature: float) -> None:
        """See `MaterialLaw`; always fulfilled."""

    def permanent_curvature(self, curvature: ArrayLike) -> FloatArray:
        """What is left when the moment is taken away (n,), 1/mm: unloading follows Hooke's law."""
        return np.asarray(np.asarray(curvature, dtype=float) - self.effective_curvature(curvature))

    def _core(self, kappa: FloatArray) -> FloatArray:
        """Part of the thickness that is still elastic."""
        return self.curvature_limit / np.maximum(np.abs(kappa), self.curvature_limit)


@dataclass(frozen=True, eq=False)
class TabulatedLaw(MaterialLaw):
    """A measured moment-curvature table, continued oddly and joined by a shape-preserving cubic.

    Parameters
    ----------
    curvatures : (m,) array_like
        Increasing, positive, 1/mm; the point (0, 0) is added.
    moments : (m,) array_like
        In any unit; only their ratio to the first slope counts.

    Raises
    ------
    InputError
        Fewer than two points, curvatures that do not increase, values that are not positive; when used, a
        curvature beyond the table.

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
            array = np.array(getattr(self, name), dtype=float)
            if array.ndim != 1 or array.size < 2 or not np.all(np.isfinite(array)) or np.any(array <= 0):
                raise InputError(f"the law's {name} must be at least two positive, finite numbers")
            array.setflags(write=False)
            object.__setattr__(self, name, array)
        if self.curvatures.shape != self.moments.shape:
            raise InputError(
                f"the law has {self.curvatures.size} curvatures and {self.moments.size} moments: give one "
                "for each"
            )
        if np.any(np.diff(self.curvatures) <= 0):
            i = int(np.argmin(np.diff(self.curvatures)))
            raise InputError(
                f"the law's curvatures must increase: {self.curvatures[i + 1]:g} follows "
                f"{self.curvatures[i]:g} 1/mm"
            )

    def effective_curvature(self, curvature: ArrayLike) -> FloatArray:
        """See `MaterialLaw`."""
        return np.asarray(self._spline(self._inside(curvature)) / self._rest_slope)

    def slope(self, curvature: ArrayLike) -> FloatArray:
        """See `MaterialLaw`."""
        return np.asarray(self._spline(self._inside(curvature), 1) / self._rest_slope)

    def require_injective(self, largest_curvature: float) -> None:
        """See `MaterialLaw`; a shape-preserving cubic is monotone where its points are."""
        self._inside(largest_curvature)
        falling = np.flatnonzero(np.diff(self.moments) <= 0)
        if falling.size:
            _refuse_beyond(float(self.curvatures[falling[0]]), largest_curvature)

    def _inside(self, curvature: ArrayLike) -> FloatArray:
        kappa = np.asarray(curvature, dtype=float)
        if np.any(np.abs(kappa) > self.curvatures[-1] * (1 + 1e-12)):
            raise InputError(
                f"the law's table ends at a curvature of {self.curvatures[-1]:.4g} 1/mm, but "
                f"{np.abs(kappa).max():.4g} 1/mm occurs: measure further or draw a gentler curve"
            )
        return kappa

    @cached_property
    def _spline(self):  # type: ignore[no-untyped-def]
        from scipy.interpolate import PchipInterpolator

        x = np.concatenate([-self.curvatures[::-1], [0.0], self.curvatures])
        y = np.concatenate([-self.moments[::-1], [0.0], self.moments])
        return PchipInterpolator(x, y)

    @cached_property
    def _rest_slope(self) -> float:
        return float(self._spline(0.0, 1))


def _require_positive(value: float, name: str, unit: str) -> None:
    if not (np.isfinite(value) and value > 0):
        raise InputError(f"the law's {name} is {value}: it must be positive, in {unit}")


def _refuse_beyond(limit: float, largest_curvature: float) -> None:
    if largest_curvature > limit * (1 + 1e-12):
        raise InputError(
            f"the material law is not injective: its moment stops growing at a curvature of {limit:.4g} 1/mm "
            f"(radius {1 / limit:.4g} mm), but {largest_curvature:.4g} 1/mm occurs; draw a gentler curve or "
            "use a thinner sheet"
        )
