"""Points that were measured: how far they waver about the smooth curve that they stand for."""

from dataclasses import dataclass
from itertools import pairwise

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import rounded_up
from elastica_cad.geometry.running_sums import lengths_along
from elastica_cad.refusals import Length, Point, note

ORDERS = range(2, 8)
"""Of the divided differences that tell noise from shape."""

FEWEST = 8
"""Differences of an order from which the noise is estimated."""

SETTLED = 0.7
"""A curve's differences fall by more than this from order to order, those of noise do not."""

CROWDED_SHARE = 0.1
"""Of the distance between points: where noise is larger, every other point is left out, as the way along the curve
cannot be told from noise."""

TOLD_MM = 0.01
"""Noise that is reported; less is within what a fit takes out."""

REACH = 4.0
"""Standard deviations from a smooth curve within which all of some hundred points lie; of fewer points, fewer."""

STRAY_TIMES = 4.0
"""A point stands out when it is this many times as far off its neighbours' curve as any point is without it."""


@dataclass(frozen=True, eq=False)
class MeasuredPoints:
    """Points that waver about a smooth curve.

    Attributes
    ----------
    points : (n, 2) array
        mm.
    waver : float
        Standard deviation of their distance from the curve, mm.
    """

    points: FloatArray
    waver: float

    @classmethod
    def of(cls, points: FloatArray) -> "MeasuredPoints | None":
        """The points (n, 2), no two in a row the same, with their noise; None where it is too little to matter."""
        waver = estimate_waver(points)
        return cls(points, waver) if waver >= TOLD_MM else None

    @property
    def reach(self) -> float:
        """How far from the points a smooth curve may be, mm, so that it need not follow the noise."""
        return rounded_up(min(REACH, 2 * np.log10(len(self.points))) * self.waver, 2)

    @property
    def stray(self) -> tuple[str, ...]:
        """A sentence about the one point that stands out, as a mistyped one does; none where none stands out.

        It is far off the cubic through its four neighbours, and without it no other point is.
        """
        off = np.abs(_off_neighbours(self.points))
        if len(off) < FEWEST:
            return ()
        far, at = off.max(), int(off.argmax()) + 2
        rest = np.abs(_off_neighbours(np.delete(self.points, at, axis=0))).max()
        if far <= STRAY_TIMES * rest:
            return ()
        return (note(
            "The point at {place}, number {number} of {count}, is {far:.2g} off the curve of its neighbours, "
            "the others {rest:.2g} at most: measure it again.",
            place=Point(self.points[at]), number=at + 1, count=len(self.points), far=Length(far), rest=Length(rest),
            severity="warning",
        ),)  # fmt: skip

    @property
    def shown(self) -> Length:
        """The noise as a message tells it."""
        return Length(float(f"{self.waver:.1g}"))

    @property
    def told(self) -> str:
        """The noise, in a sentence without its full stop."""
        return note(
            "the points waver by about {waver}: smooth them within {reach} (smooth = {mm:g}, --smooth {mm:g})",
            waver=self.shown, reach=Length(self.reach), mm=self.reach,
        )  # fmt: skip


def estimate_waver(points: FloatArray) -> float:
    """Standard deviation, mm, of the distance of points (n, 2) from the smooth curve that they stand for.

    It is the median of divided differences across the curve, scaled to unit variance of white noise, of the first
    order from which a higher one lowers it no more (Gasser, Sroka and Jennen-Steinmetz, Biometrika 73, 1986, take
    order 2); 0 where points are too few, or their differences are those of a curve.

    Examples
    --------
    >>> x = np.linspace(0.0, 400.0, 200)
    >>> arch = np.column_stack([x, 0.001 * x * (400 - x)])
    >>> noise = 0.5 * np.random.default_rng(2).normal(size=arch.shape)
    >>> round(estimate_waver(arch), 6), round(estimate_waver(arch + noise), 1)
    (0.0, 0.5)
    """
    while True:
        sizes = [_across(points, order) for order in ORDERS if len(points) - order >= FEWEST]
        waver = next((higher for lower, higher in pairwise(sizes) if higher > SETTLED * lower), 0.0)
        spacing = lengths_along(points)[-1] / len(points)
        if waver <= CROWDED_SHARE * spacing or len(points) < 4 * FEWEST:
            return waver
        points = points[::2]


def _across(points: FloatArray, order: int) -> float:
    """Typical divided difference of this order across the curve, of unit variance for white noise of 1 mm."""
    return float(np.median(np.abs(_differences(points, order)[0])) / 0.6745)


def _off_neighbours(points: FloatArray) -> FloatArray:
    """Distances (n - 4,), mm, of points across the curve from the cubics through two neighbours on either side."""
    across, weights = _differences(points, 4)
    return across / weights[:, 2]


def _differences(points: FloatArray, order: int) -> tuple[FloatArray, FloatArray]:
    """Divided differences (m,) across the curve, and the weights (m, order + 1) of their points, of unit norm."""
    window = np.arange(len(points) - order)[:, None] + np.arange(order + 1)
    s, near = lengths_along(points)[window], points[window]
    gaps = (s[:, :, None] - s[:, None, :]) / np.ptp(s, axis=1)[:, None, None] + np.eye(order + 1)
    weights = 1 / gaps.prod(axis=2)
    weights /= np.linalg.norm(weights, axis=1)[:, None]
    x, y = np.einsum("ij,ijk->ki", weights, near)
    chord_x, chord_y = (near[:, -1] - near[:, 0]).T
    return (chord_x * y - chord_y * x) / np.maximum(np.hypot(chord_x, chord_y), 1e-300), weights
