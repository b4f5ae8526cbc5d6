"""Arc length along smooth pieces as Chebyshev series, and its inverse."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.polynomial import chebyshev

from elastica_cad._cached_property import cached_property
from elastica_cad._types import FloatArray, IntArray

_DEGREE = 15
"""Degree of the Chebyshev series of the speed on each panel."""

_FINE = 1e-14
"""Last Chebyshev coefficients below this fraction of the mean speed are rounding errors."""

# largest number of Newton steps; three are usual, except where the speed is almost 0
_NEWTON_STEPS = 40

# matrices applied from the right: values at the sites to coefficients, and coefficients to those of the integral
_SITES = chebyshev.chebpts1(_DEGREE + 1)
_TO_SERIES = np.linalg.inv(chebyshev.chebvander(_SITES, _DEGREE)).T
_INTEGRATE = chebyshev.chebint(np.eye(_DEGREE + 1), lbnd=-1, axis=0).T
_PLACES = np.linspace(-1.0, 1.0, 17)
"""Coordinates in a panel at which the arc length is tabulated, as starting points for Newton's method."""


@dataclass(frozen=True, eq=False)
class ArcLength:
    """Arc length as a function of the parameter: a Chebyshev series of degree 16 on each panel.

    The panels are so short that the series are exact except for rounding errors.

    Attributes
    ----------
    t : (k + 1,) array
        Parameters at the ends of the panels.
    s : (k + 1,) array
        Arc lengths at the ends of the panels, mm; s[0] = 0.
    series : (k, 17) array
        Chebyshev coefficients of the arc length from the start of each panel.
    """

    t: FloatArray
    s: FloatArray
    series: FloatArray

    def length_at(self, t: FloatArray) -> FloatArray:
        """Return arc lengths (n,), mm, at parameters (n,)."""
        panel = self.t[1:-1].searchsorted(t, side="right")
        x = (2 * (t - self.t[panel]) / np.diff(self.t)[panel] - 1).clip(-1.0, 1.0)
        s = self.s[panel] + chebyshev.chebval(x, self.series.T[:, panel], tensor=False)
        return np.where(x <= -1, self.s[panel], np.where(x >= 1, self.s[panel + 1], s))

    def parameter_at(self, s: FloatArray) -> FloatArray:
        """Return parameters (n,) at arc lengths (n,), by Newton's method between tabulated values."""
        places, reached = self._table
        cell = reached[1:-1].searchsorted(s, side="right")
        panel = cell // (_PLACES.size - 1)
        # x is the coordinate in the panel, between `low` and `high`
        low, high = (places[at] - 2.0 * panel for at in (cell, cell + 1))
        x = np.interp(s, reached, places) - 2.0 * panel
        series, slopes = self.series[panel], self._slopes[panel]
        for _ in range(_NEWTON_STEPS):
            polynomials = chebyshev.chebvander(x, _DEGREE + 1)
            gap = np.einsum("ij,ij->i", polynomials, series) - (s - self.s[panel])
            low, high = np.where(gap < 0, x, low), np.where(gap < 0, high, x)
            with np.errstate(divide="ignore", invalid="ignore"):
                newton = x - gap / np.einsum("ij,ij->i", polynomials[:, :-1], slopes)
            following = np.where((newton >= low) & (newton <= high), newton, (low + high) / 2)
            step = np.abs(following - x).max(initial=0.0)
            x = following
            if step < 1e-7:  # the remaining error is about the square of the step
                break
        t = self.t[panel] + np.diff(self.t)[panel] * (1 + x) / 2
        return np.asarray(np.where(s <= 0, self.t[0], np.where(s >= self.s[-1], self.t[-1], t)))

    @cached_property
    def _slopes(self) -> FloatArray:
        """Chebyshev coefficients (k, 16) of the derivative of the arc length by the panel coordinate."""
        return np.asarray(chebyshev.chebder(self.series, axis=1), dtype=float)

    @cached_property
    def _table(self) -> tuple[FloatArray, FloatArray]:
        """Coordinates at which the arc length is tabulated, and the arc lengths there, which never decrease.

        The coordinate runs through all panels: panel i has the coordinates from 2 i - 1 to 2 i + 1.
        """
        panels = len(self.series)
        inside = self.series @ chebyshev.chebvander(_PLACES[:-1], _DEGREE + 1).T + self.s[:-1, None]
        places = (2.0 * np.arange(panels)[:, None] + _PLACES[:-1]).ravel()
        reached = np.maximum.accumulate(np.append(inside.ravel(), self.s[-1]))
        return np.append(places, 2.0 * panels - 1.0), reached


def arc_length_table(speed: Callable[[IntArray, FloatArray], FloatArray], edges: FloatArray) -> ArcLength:
    """Return the arc length for a function `speed` that is smooth between `edges`.

    Panels are halved until the last Chebyshev coefficients of the speed are rounding errors. Halving also stops
    if it does not reduce these coefficients.

    Parameters
    ----------
    speed : callable
        Function of interval indices (n,) and parameters (n,) that returns speeds (n,), mm per unit of the
        parameter.
    """
    span, low, width = np.arange(edges.size - 1), edges[:-1], np.diff(edges)
    before = np.full(low.shape, np.inf)
    panels: list[tuple[FloatArray, FloatArray]] = []
    while low.size:
        t = low[:, None] + width[:, None] * (1 + _SITES) / 2
        series = speed(span.repeat(_SITES.size), t.ravel()).reshape(t.shape) @ _TO_SERIES
        mean, tail = series[:, 0], np.abs(series[:, -3:]).max(axis=1)
        # smaller last coefficients may be rounding errors: they are if halving the panel does not reduce them
        fine = (tail <= _FINE * mean) | ((tail < 1e-8 * mean) & (tail > 0.3 * before))
        # narrower panels are not halved
        fine |= width < 2.0**-40 * (edges[-1] - edges[0])
        panels.append((low[fine], (series[fine] * width[fine, None] / 2) @ _INTEGRATE))
        span, low, width, before = span[~fine], low[~fine], width[~fine] / 2, tail[~fine]
        span, before, width = np.tile(span, 2), np.tile(before, 2), np.tile(width, 2)
        low = np.concatenate([low, low + width[: low.size]])
    starts, rows = map(np.concatenate, zip(*panels, strict=True))
    order = starts.argsort()
    lengths = rows[order].sum(axis=1)
    return ArcLength(np.append(starts[order], edges[-1]), np.append(0.0, lengths.cumsum()), rows[order])
