"""Arc length of smooth pieces as Chebyshev series, and its inverse."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from elastica_cad._types import FloatArray

__all__ = ["ArcLength", "arc_length_table"]

_DEGREE = 15
_DEEPEST = 40
_NOISE = 1e-8


@dataclass(frozen=True, eq=False)
class ArcLength:
    """Arc length s(t) on panels short enough for a series of degree 16 to be exact to rounding.

    Attributes
    ----------
    t : (k + 1,) array
        Ends of the panels.
    s : (k + 1,) array
        Arc length at the ends, mm; s[0] = 0.
    series : (k, 17) array
        Chebyshev coefficients over the panel of the arc length from its start.
    """

    t: FloatArray
    s: FloatArray
    series: FloatArray

    def length_at(self, t: FloatArray) -> FloatArray:
        """Arc lengths (n,) of parameters (n,)."""
        panel = np.clip(np.searchsorted(self.t, t, side="right") - 1, 0, self.series.shape[0] - 1)
        width = np.diff(self.t)[panel]
        x = np.clip(2 * (t - self.t[panel]) / width - 1, -1.0, 1.0)
        s = self.s[panel] + _clenshaw(self.series[panel].T, x)
        return np.asarray(np.where(x <= -1, self.s[panel], np.where(x >= 1, self.s[panel + 1], s)))

    def parameter_at(self, s: FloatArray) -> FloatArray:
        """Parameters (n,) of arc lengths (n,), by Newton steps kept inside the panel."""
        panel = np.clip(np.searchsorted(self.s, s, side="right") - 1, 0, self.series.shape[0] - 1)
        target = s - self.s[panel]
        whole = np.diff(self.s)[panel]
        slopes = self._slopes[panel].T
        series = self.series[panel].T
        x = np.clip(2 * target / whole - 1, -1.0, 1.0)
        low, high = np.full(x.shape, -1.0), np.ones(x.shape)
        for _ in range(60):
            gap = _clenshaw(series, x) - target
            low, high = np.where(gap < 0, x, low), np.where(gap < 0, high, x)
            newton = x - gap / _clenshaw(slopes, x)
            following = np.where((newton >= low) & (newton <= high), newton, (low + high) / 2)
            done = np.abs(following - x).max(initial=0.0) <= 1e-13
            x = following
            if done:
                break
        ends = np.where(target <= 0, -1.0, np.where(target >= whole, 1.0, x))
        return np.asarray(self.t[panel] + np.diff(self.t)[panel] * (1 + ends) / 2)

    @property
    def _slopes(self) -> FloatArray:
        return np.asarray(np.polynomial.chebyshev.chebder(self.series, axis=1), dtype=float)


def arc_length_table(speed: Callable[[FloatArray], FloatArray], edges: FloatArray) -> ArcLength:
    """Tabulate the integral of `speed` (parameters (n,) to mm per unit of t) over spans between `edges`.

    Panels are halved until the Chebyshev coefficients of the speed have fallen to rounding level, which is
    where halving no longer helps when the parameters themselves are large beside their domain.
    """
    nodes, to_series, integrate = _chebyshev()
    low, width = edges[:-1], np.diff(edges)
    parent = np.full(low.shape, np.inf)
    starts, widths, tables = [], [], []
    total = 0.0
    for depth in range(_DEEPEST):
        t = low[:, None] + width[:, None] * (1 + nodes) / 2
        values = speed(t.ravel()).reshape(t.shape)
        coefficients = values @ to_series.T
        total = max(total, float((coefficients[:, 0] * width).sum()))
        tail = np.abs(coefficients[:, -3:]).max(axis=1)
        fine = (
            (tail <= 2e-15 * coefficients[:, 0]) | (tail * width <= 1e-15 * total) | (depth == _DEEPEST - 1)
        )
        fine |= (tail < _NOISE * coefficients[:, 0]) & (tail > 0.3 * parent)
        starts.append(low[fine])
        widths.append(width[fine])
        tables.append((coefficients[fine] * width[fine, None] / 2) @ integrate.T)
        low, width = low[~fine], width[~fine] / 2
        low, width = np.concatenate([low, low + width]), np.concatenate([width, width])
        parent = np.concatenate([tail[~fine], tail[~fine]])
        if not low.size:
            break
    t = np.concatenate(starts)
    order = np.argsort(t)
    series = np.concatenate(tables)[order]
    s = np.concatenate([[0.0], np.cumsum(series.sum(axis=1))])
    return ArcLength(np.append(t[order], edges[-1]), s, series)


@lru_cache(maxsize=1)
def _chebyshev() -> tuple[FloatArray, FloatArray, FloatArray]:
    """Nodes (n,), values -> coefficients (n, n), coefficients -> those of the integral from -1 (n+1, n)."""
    n = _DEGREE + 1
    phase = np.pi * (np.arange(n) + 0.5) / n
    to_series = 2 / n * np.cos(np.arange(n)[:, None] * phase)
    to_series[0] /= 2
    integrate = np.asarray(np.polynomial.chebyshev.chebint(np.eye(n), lbnd=-1, axis=0), dtype=float)
    return np.cos(phase), to_series, integrate


def _clenshaw(c: FloatArray, x: FloatArray) -> FloatArray:
    """Chebyshev series with coefficients (k, n) at x (n,), one series for each x."""
    double = 2 * x
    b1, b2 = np.zeros(x.shape), np.zeros(x.shape)
    for k in range(c.shape[0] - 1, 0, -1):
        b1, b2 = c[k] + double * b1 - b2, b1
    return np.asarray(c[0] + x * b1 - b2)
