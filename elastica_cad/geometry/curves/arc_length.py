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

_DERIVED = np.ascontiguousarray(np.polynomial.chebyshev.chebder(np.eye(_DEGREE + 2), axis=1))
"""Chebyshev coefficients of a series times this (17, 16) are those of its derivative."""

_NARROWEST = 2.0**-40
"""Share of the whole: a panel as narrow is as wide as rounding."""

_FINE = 2e-15
"""Share of the speed below which the last coefficients are rounding."""

_NOISE_SHARE = 1e-8
"""Coefficients below this share of the speed that halving no longer lessens are rounding."""

_SHORT_SHARE = 1e-15
"""Of the whole length: what the last coefficients of a panel leave out at most, where they are no rounding."""

_CELLS = 32
_STEPS = np.linspace(-1.0, 1.0, _CELLS + 1)
_AT_STEPS = chebyshev(_STEPS, _DEGREE + 2)
"""Places in a panel between which its inverse is a cubic to 1e-8, and the polynomials (17, 33) there."""

_PACE_AT_STEPS = _DERIVED @ _AT_STEPS[:-1]
"""Slopes (17, 33) of the polynomials there."""

_LAST_NEWTON_STEP, _STEP_FROM_CUBIC = 1e-8, 2e-8
"""In a panel from -1 to 1: the next step would be its square, or from a cubic, whose slope is as exact as it, as
little."""


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
        panel = np.searchsorted(self.t[1:-1], t, side="right")
        x = np.minimum(np.maximum(2 * (t - self.t[panel]) / self._widths[panel] - 1, -1.0), 1.0)
        s = self.s[panel] + series_at(self.series, panel, chebyshev(x, self.series.shape[1]))
        return np.asarray(np.where(x <= -1, self.s[panel], np.where(x >= 1, self.s[panel + 1], s)))

    def parameter_at(self, s: FloatArray) -> FloatArray:
        """Parameters (n,) of arc lengths (n,)."""
        meets, cubics = self._inverse
        cell = meets.searchsorted(s, side="right")
        panel = cell // _CELLS
        start, pace, c0, c1, c2, c3 = cubics.take(cell, axis=0).T
        share = (s - start) * pace
        guess = c0 + share * (c1 + share * (c2 + share * c3))
        rate = (c1 + share * (2 * c2 + share * (3 * c3))) * pace
        target, whole = s - self.s[panel], self._lengths[panel]
        x = self._places(panel, target, guess, rate)
        x = np.where(target <= 0, -1.0, np.where(target >= whole, 1.0, x))
        return np.asarray(self.t[panel] + self._widths[panel] * (1 + x) / 2)

    def _places(self, panel: IntArray, target: FloatArray, guess: FloatArray, rate: FloatArray) -> FloatArray:
        """Places x in [-1, 1] of panels (n,) at arc lengths `target` from their starts, by Newton steps.

        `rate` is dx/ds at the guess, as exact as that is.
        """
        x = np.minimum(np.maximum(guess, -1.0), 1.0)
        gap = series_at(self.series, panel, chebyshev(x, self.series.shape[1])) - target
        following = np.minimum(np.maximum(x - gap * rate, -1.0), 1.0)
        if np.abs(following - x).max(initial=0.0) <= _STEP_FROM_CUBIC:
            return np.asarray(following)
        low, high = np.full(x.shape, -1.0), np.ones(x.shape)
        for _ in range(60):
            step = np.abs(following - x).max()
            low, high = np.where(gap < 0, x, low), np.where(gap < 0, high, x)
            x = following
            if step <= _LAST_NEWTON_STEP:
                break
            polynomials = chebyshev(x, self.series.shape[1])
            gap = series_at(self.series, panel, polynomials) - target
            newton = x - gap / series_at(self._slopes, panel, polynomials)
            following = np.where((newton >= low) & (newton <= high), newton, (low + high) / 2)
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
        """Series (k, 16) of ds/dx."""
        return np.asarray(self.series @ _DERIVED)

    @cached_property
    def _inverse(self) -> tuple[FloatArray, FloatArray]:
        """Where Newton's method starts: arc lengths at which the cells of the panels meet, and rows (k * 32, 6).

        These are the cell's start, shares of it a mm, and the place x as a cubic in the share that is behind.
        """
        reached = self.series @ _AT_STEPS + self.s[:-1, None]
        reached[:, 0], reached[:, -1] = self.s[:-1], self.s[1:]
        size = np.maximum(reached[:, 1:] - reached[:, :-1], np.finfo(float).tiny)
        # dx over the cell at its ends, as fast as there
        pace = self.series @ _PACE_AT_STEPS
        pace = np.where(pace > 0, pace, np.inf)
        first, last, step = size / pace[:, :-1], size / pace[:, 1:], 2.0 / _CELLS
        cubics = np.empty((*size.shape, 6))
        cubics[..., 0], cubics[..., 1] = reached[:, :-1], 1 / size
        cubics[..., 2], cubics[..., 3] = _STEPS[:-1], first
        cubics[..., 4], cubics[..., 5] = 3 * step - 2 * first - last, first + last - 2 * step
        return reached[:, :-1].ravel()[1:], cubics.reshape(-1, 6)


def arc_length_table(speed: Callable[[IntArray, FloatArray], FloatArray], edges: FloatArray) -> ArcLength:
    """Tabulate the integral of `speed` over the spans between `edges`.

    Parameters
    ----------
    speed : callable
        Maps spans (n,) and parameters (n,) in them to mm per unit of t.
    """
    spans, owner = np.arange(edges.size - 1), np.zeros(edges.size - 1, dtype=int)
    _, t, _, series = _panels(speed, spans, owner, edges[:-1], edges[1:] - edges[:-1], edges[-1:] - edges[:1])
    return _tabulated(t, series, edges[-1:])


def _tabulated(t: FloatArray, series: FloatArray, end: FloatArray) -> ArcLength:
    """Panels that begin at t (k,), in any order, as a table; the last ends at `end` (1,)."""
    order = t.argsort()
    series = series[order]
    s = np.empty(t.size + 1)
    s[0] = 0.0
    series.sum(axis=1).cumsum(out=s[1:])
    return ArcLength(np.concatenate([t[order], end]), s, series)


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
    span, _, _, series = _panels(speed, which, np.arange(whole.size), low, width, whole)
    return np.asarray(np.bincount(span, series.sum(axis=1), minlength=whole.size), dtype=float)


def _panels(
    speed: Callable[[IntArray, FloatArray], FloatArray],
    which: IntArray,
    owners: IntArray,
    low: FloatArray,
    width: FloatArray,
    whole: FloatArray,
) -> tuple[IntArray, FloatArray, FloatArray, FloatArray]:
    """Spans of the panels (k,), their starts and widths (k,), and series (k, 17) of their arc length.

    `owners` are the curves of the spans that `which` (k,) names.

    Panels are cut into 2, 4 or 8 until the Chebyshev coefficients of the speed have fallen to rounding level, which
    is where cutting no longer helps when the parameters themselves are large beside their domain.
    """
    shares, to_series, integrate = _chebyshev()
    parent: FloatArray = np.full(low.shape, np.inf)
    found: list[tuple[IntArray, FloatArray, FloatArray, FloatArray]] = []
    total = np.zeros(whole.size)
    while True:
        t = low[:, None] + width[:, None] * shares
        coefficients = speed(which.repeat(shares.size), t.ravel()).reshape(t.shape) @ to_series
        mean = coefficients[:, 0]
        owner = owners[which]
        total = np.maximum(total, np.bincount(owner, mean * width, minlength=whole.size))
        tail = np.abs(coefficients[:, -3:]).max(axis=1)
        fine = (
            (tail <= _FINE * mean)
            | (tail * width <= _SHORT_SHARE * total[owner])
            | (width < _NARROWEST * whole[owner])
            | ((tail < _NOISE_SHARE * mean) & (tail > 0.3 * parent))
        )
        found.append(
            (which[fine], low[fine], width[fine], (coefficients[fine] * width[fine, None] / 2) @ integrate)
        )
        rough = (~fine).nonzero()[0]
        if not rough.size:
            break
        # halving divides the last coefficients by 2^degree or so
        parent = tail[rough]
        halvings = np.ceil(np.log2(parent / (_FINE * mean[rough])) / _DEGREE)
        parts = 2 ** np.minimum(np.maximum(halvings, 1), 3).astype(int)
        width = (width[rough] / parts).repeat(parts)
        low = low[rough].repeat(parts) + numbers_in_groups(parts) * width
        parent, which = parent.repeat(parts), which[rough].repeat(parts)
    if len(found) == 1:
        return found[0]
    span, start, size, series = (np.concatenate(part) for part in zip(*found, strict=True))
    return span, start, size, series


@lru_cache(maxsize=1)
def _chebyshev() -> tuple[FloatArray, FloatArray, FloatArray]:
    """Nodes (n,) from 0 to 1; values @ to_series (n, n) are coefficients, these @ integrate (n, n+1) those of the
    integral from -1.
    """
    n = _DEGREE + 1
    phase = np.pi * (np.arange(n) + 0.5) / n
    to_series = 2 / n * np.cos(np.arange(n)[:, None] * phase)
    to_series[0] /= 2
    integrate = np.asarray(np.polynomial.chebyshev.chebint(np.eye(n), lbnd=-1, axis=0), dtype=float)
    return (1 + np.cos(phase)) / 2, to_series.T.copy(), integrate.T.copy()
