"""A number along the strip (stiffness, width) as a B-spline function of arc length."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad.errors import InputError

__all__ = ["Profile"]


@dataclass(frozen=True, eq=False)
class Profile:
    """A spline function of arc length; its graph is a true B-spline curve.

    Parameters
    ----------
    knots : (m + degree + 1,) array_like
        Full knot vector over arc length, mm, clamped at both ends.
    coefficients : (m,) array_like
        B-spline coefficients, in the unit of the value.
    degree : int
        Polynomial degree, 3 unless told.

    Examples
    --------
    >>> import numpy as np
    >>> taper = Profile.fit(lambda s: 1 + s / 100, 100.0, tolerance=1e-9)
    >>> float(np.round(taper(50.0), 6))
    1.5
    """

    knots: FloatArray
    coefficients: FloatArray
    degree: int = 3

    def __post_init__(self) -> None:
        for name in ("knots", "coefficients"):
            array = np.array(getattr(self, name), dtype=float)
            if array.ndim != 1 or not np.all(np.isfinite(array)):
                raise InputError(f"profile {name} must be a row of finite numbers")
            array.setflags(write=False)
            object.__setattr__(self, name, array)
        if self.knots.size != self.coefficients.size + self.degree + 1:
            raise InputError(
                f"profile has {self.knots.size} knots and {self.coefficients.size} coefficients: "
                f"degree {self.degree} needs {self.coefficients.size + self.degree + 1} knots"
            )

    @classmethod
    def fit(
        cls,
        function: Callable[[FloatArray], FloatArray],
        length: float,
        *,
        breaks: Sequence[tuple[float, int]] = (),
        tolerance: float = 1e-7,
        degree: int = 3,
    ) -> "Profile":
        """Approximate `function` on [0, length] to `tolerance` (absolute, checked between the samples).

        Parameters
        ----------
        function : callable
            Maps arc lengths (k,) to values (k,).
        breaks : sequence of (s, continuity)
            Places where the function is only `continuity` times differentiable; -1 is a jump.
            They become knots of the matching multiplicity, so that a kink stays a kink.
        """
        from scipy.interpolate import make_lsq_spline

        spans = sorted({0.0, float(length), *(float(s) for s, _ in breaks if 0 < s < length)})
        interior = {float(s): int(np.clip(degree - c, 1, degree)) for s, c in breaks if 0 < s < length}
        edges = np.array(spans)
        while True:
            knots = _clamped(edges, interior, degree)
            x, weight = _sites(edges, degree)
            spline = make_lsq_spline(x, function(x), knots, k=degree, w=weight)
            probe = edges[:-1, None] + np.diff(edges)[:, None] * _PROBES
            error = np.abs(spline(probe) - function(probe.ravel()).reshape(probe.shape)).max(axis=1)
            bad = error > tolerance
            if not bad.any() or edges.size > 3000:
                return cls(knots, spline.c, degree)
            edges = np.sort(np.concatenate([edges, (edges[:-1] + np.diff(edges) / 2)[bad]]))

    @classmethod
    def interpolate(cls, s: ArrayLike, values: ArrayLike) -> "Profile":
        """The cubic spline through `values` (n,) at increasing arc lengths `s` (n,)."""
        from scipy.interpolate import make_interp_spline

        s = np.asarray(s, dtype=float)
        degree = min(3, s.size - 1)
        spline = make_interp_spline(s, np.asarray(values, dtype=float), k=degree)
        return cls(spline.t, spline.c, degree)

    def __call__(self, s: ArrayLike, derivative: int = 0) -> FloatArray:
        """Values (or derivatives per mm) at arc lengths `s`, same shape as `s`."""
        spline = self._spline.derivative(derivative) if derivative else self._spline
        return np.asarray(spline(np.asarray(s, dtype=float)), dtype=float)

    @property
    def length(self) -> float:
        """End of the domain, mm."""
        return float(self.knots[-1])

    @cached_property
    def extremes(self) -> tuple[float, float]:
        """Smallest and largest value over the whole domain, to rounding error."""
        slope = self._spline.derivative()
        inner = np.unique(self.knots)
        dense = np.concatenate([np.linspace(a, b, 9) for a, b in pairwise(inner)])
        values = slope(dense)
        candidates = [self.knots[0], self.knots[-1], *inner]
        for i in np.flatnonzero(values[:-1] * values[1:] < 0):
            candidates.append(_bisected(slope, dense[i], dense[i + 1]))
        found = self(np.array(candidates))
        return float(found.min()), float(found.max())

    @property
    def greville(self) -> FloatArray:
        """Greville abscissae (m,): with these as x the graph of the spline is the spline curve itself."""
        windows = np.lib.stride_tricks.sliding_window_view(self.knots[1:-1], self.degree)
        return np.asarray(windows.mean(axis=1), dtype=float)

    def scaled(self, factor: float) -> "Profile":
        """The profile times `factor`."""
        return Profile(self.knots, self.coefficients * factor, self.degree)

    @cached_property
    def _spline(self):  # type: ignore[no-untyped-def]
        from scipy.interpolate import BSpline

        return BSpline(self.knots, self.coefficients, self.degree)


_PROBES = np.array([0.02, 0.11, 0.27, 0.43, 0.58, 0.72, 0.88, 0.98])


def _clamped(edges: FloatArray, interior: dict[float, int], degree: int) -> FloatArray:
    """Knot vector with the ends repeated and every edge as often as its break asks."""
    inner = [np.full(interior.get(float(e), 1), e) for e in edges[1:-1]]
    return np.concatenate([np.full(degree + 1, edges[0]), *inner, np.full(degree + 1, edges[-1])])


def _sites(edges: FloatArray, degree: int) -> tuple[FloatArray, FloatArray]:
    """Gauss points and root weights of every span: strictly inside, so jumps at edges are never sampled."""
    x, w = np.polynomial.legendre.leggauss(degree + 3)
    half = np.diff(edges)[:, None] / 2
    middle = edges[:-1, None] + half
    return (middle + half * x).ravel(), np.sqrt(half * w).ravel()


def _bisected(function: Callable[[FloatArray], FloatArray], a: float, b: float) -> float:
    from scipy.optimize import brentq

    return float(brentq(function, a, b, xtol=1e-14 * max(1.0, abs(b))))
