"""Arc length of smooth pieces as Chebyshev series, and its inverse."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property, lru_cache

import numpy as np

from elastica_cad._types import FloatArray, IntArray
from elastica_cad.geometry.polynomials.chebyshev import chebyshev, series_at
from elastica_cad.geometry.running_sums import numbers_in_groups

_DEGREE = 15
"""Of the Chebyshev series for the speed on one panel."""

_NARROWEST = 2.0**-40
"""Share of the whole: a panel as narrow is as wide as rounding."""

_FINE = 2e-15
"""Share of the speed below which the last coefficients are rounding."""

_NOISE_SHARE = 1e-8
"""Coefficients below this share of the speed that halving no longer lessens are rounding."""

_STEPS = np.linspace(-1.0, 1.0, 33)
_AT_STEPS = chebyshev(_STEPS, _DEGREE + 2)
"""Places in a panel between which its inverse is nearly straight, and the polynomials (17, 33) there."""

_LAST_NEWTON_STEP = 1e-8
"""In a panel from -1 to 1: the next step would be its square."""


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
        if not t.size:
            return np.zeros(0)
        panel = self._panel(self.t, t)
        x = np.minimum(np.maximum(2 * (t - self.t[panel]) / self._widths[panel] - 1, -1.0), 1.0)
        s = self.s[panel] + series_at(self.series, panel, chebyshev(x, self.series.shape[1]))
        return np.asarray(np.where(x <= -1, self.s[panel], np.where(x >= 1, self.s[panel + 1], s)))

    def parameter_at(self, s: FloatArray) -> FloatArray:
        """Parameters (n,) of arc lengths (n,)."""
        panel = self._panel(self.s, s)
        target, whole = s - self.s[panel], self._lengths[panel]
        share = np.minimum(np.maximum(2 * target / whole - 1, -1.0), 1.0)
        guess = series_at(self._inverse, panel, chebyshev(share, self._inverse.shape[1]))
        x = self._places(panel, target, guess)
        x = np.where(target <= 0, -1.0, np.where(target >= whole, 1.0, x))
        return np.asarray(self.t[panel] + self._widths[panel] * (1 + x) / 2)

    def _panel(self, edges: FloatArray, places: FloatArray) -> IntArray:
        """The panels between `edges` in which places (n,) lie; beyond the ends the outermost one."""
        return np.asarray(np.searchsorted(edges[1:-1], places, side="right"))

    def _places(self, panel: IntArray, target: FloatArray, guess: FloatArray) -> FloatArray:
        """Places x in [-1, 1] of panels (n,) at arc lengths `target` from their starts, by Newton steps."""
        x = np.minimum(np.maximum(guess, -1.0), 1.0)
        low, high = np.full(x.shape, -1.0), np.ones(x.shape)
        for _ in range(60):
            polynomials = chebyshev(x, self.series.shape[1])
            gap = series_at(self.series, panel, polynomials) - target
            low, high = np.where(gap < 0, x, low), np.where(gap < 0, high, x)
            newton = x - gap / series_at(self._slopes, panel, polynomials)
            following = np.where((newton >= low) & (newton <= high), newton, (low + high) / 2)
            step = np.abs(following - x).max(initial=0.0)
            x = following
            # the next step would be its square
            if step <= _LAST_NEWTON_STEP:
                break
        return np.asarray(x)

    @cached_property
    def _widths(self) -> FloatArray:
        """Of the panels (k,), in the parameter."""
        return np.diff(self.t)

    @cached_property
    def _lengths(self) -> FloatArray:
        """Of the panels (k,), mm."""
        return np.diff(self.s)

    @cached_property
    def _slopes(self) -> FloatArray:
        return np.asarray(np.polynomial.chebyshev.chebder(self.series, axis=1), dtype=float)

    @cached_property
    def _inverse(self) -> FloatArray:
        """Series (k, 16) of the place x over the arc length, both from -1 to 1: where Newton's method starts."""
        nodes, to_series, _ = _chebyshev()
        count = self.series.shape[0]
        panel = np.repeat(np.arange(count), nodes.size)
        share = np.tile((1 + nodes) / 2, count)
        target = share * self._lengths[panel]
        reached = self.series @ _AT_STEPS + self.s[:-1, None]
        steps = 2.0 * np.arange(count)[:, None] + _STEPS
        guess = np.interp(target + self.s[panel], reached.ravel(), steps.ravel()) - 2.0 * panel
        x = self._places(panel, target, guess)
        return np.asarray(x.reshape(count, -1) @ to_series.T)


def arc_length_table(speed: Callable[[FloatArray], FloatArray], edges: FloatArray) -> ArcLength:
    """Tabulate the integral of `speed` (parameters (n,) to mm per unit of t) over spans between `edges`."""
    one = np.zeros(edges.size - 1, dtype=int)
    _, t, _, series = _panels(lambda _, t: speed(t), one, edges[:-1], np.diff(edges), edges[[-1]] - edges[0])
    order = np.argsort(t)
    series = series[order]
    s = np.concatenate([[0.0], np.cumsum(series.sum(axis=1))])
    return ArcLength(np.append(t[order], edges[-1]), s, series)


def arc_lengths(
    speed: Callable[[IntArray, FloatArray], FloatArray],
    which: IntArray,
    low: FloatArray,
    width: FloatArray,
    whole: FloatArray,
) -> FloatArray:
    """Lengths (m,) of m curves at one go, each as exact as by a table of its own.

    Parameters
    ----------
    speed : callable
        Of the curves (n,) at parameters (n,), mm per unit of t.
    which, low, width : (k,) arrays
        The spans of all curves: whose they are, where they begin and how long they are in the parameter.
    whole : (m,) array
        Sizes of the curves' domains.
    """
    owner, _, _, series = _panels(speed, which, low, width, whole)
    return np.asarray(np.bincount(owner, series.sum(axis=1), minlength=whole.size), dtype=float)


def _panels(
    speed: Callable[[IntArray, FloatArray], FloatArray],
    which: IntArray,
    low: FloatArray,
    width: FloatArray,
    whole: FloatArray,
) -> tuple[IntArray, FloatArray, FloatArray, FloatArray]:
    """Whose each panel is (k,), its start (k,), its width (k,) and the series (k, 17) of its arc length.

    Panels are cut into 2, 4 or 8 until the Chebyshev coefficients of the speed have fallen to rounding level, which
    is where cutting no longer helps when the parameters themselves are large beside their domain.
    """
    nodes, to_series, integrate = _chebyshev()
    parent: FloatArray = np.full(low.shape, np.inf)
    owners, starts, widths, tables = [], [], [], []
    total = np.zeros(whole.size)
    while low.size:
        t = low[:, None] + width[:, None] * (1 + nodes) / 2
        values = speed(np.repeat(which, nodes.size), t.ravel()).reshape(t.shape)
        coefficients = values @ to_series.T
        sums = np.bincount(which, coefficients[:, 0] * width, minlength=whole.size)
        total = np.maximum(total, sums)
        tail = np.abs(coefficients[:, -3:]).max(axis=1)
        fine = (
            (tail <= _FINE * coefficients[:, 0])
            | (tail * width <= 1e-15 * total[which])
            | (width < _NARROWEST * whole[which])
        )
        fine |= (tail < _NOISE_SHARE * coefficients[:, 0]) & (tail > 0.3 * parent)
        owners.append(which[fine])
        starts.append(low[fine])
        widths.append(width[fine])
        tables.append((coefficients[fine] * width[fine, None] / 2) @ integrate.T)
        rough = ~fine
        # halving divides the last coefficients by 2^degree or so
        excess = tail[rough] / (_FINE * coefficients[rough, 0])
        parts = 2 ** np.clip(np.ceil(np.log2(excess) / _DEGREE), 1, 3).astype(int)
        width = np.repeat(width[rough] / parts, parts)
        low = np.repeat(low[rough], parts) + numbers_in_groups(parts) * width
        parent = np.repeat(tail[rough], parts)
        which = np.repeat(which[rough], parts)
    found = (np.concatenate(part) for part in (owners, starts, widths, tables))
    owner, start, size, series = found
    return owner, start, size, series


@lru_cache(maxsize=1)
def _chebyshev() -> tuple[FloatArray, FloatArray, FloatArray]:
    """Nodes (n,), values -> coefficients (n, n), coefficients -> those of the integral from -1 (n+1, n)."""
    n = _DEGREE + 1
    phase = np.pi * (np.arange(n) + 0.5) / n
    to_series = 2 / n * np.cos(np.arange(n)[:, None] * phase)
    to_series[0] /= 2
    integrate = np.asarray(np.polynomial.chebyshev.chebint(np.eye(n), lbnd=-1, axis=0), dtype=float)
    return np.cos(phase), to_series, integrate
