"""Where the numbers of a curve come from, and how exact measured points are."""

from dataclasses import dataclass, replace
from functools import cached_property
from itertools import pairwise

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad.errors import rounded_up
from elastica_cad.geometry.plane_points import lengths_along
from elastica_cad.geometry.tangent_healing import Turn
from elastica_cad.refusals import FieldName, Length, Point, Refusal, note

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

FINEST_MM = 1e-3
"""Finest resolution of points, mm: curves that differ by less have the same widths."""

MOST_DECIMALS = 9
"""Decimals of millimetres that are looked for in points."""

REACH = 4.0
"""Standard deviations from a smooth curve within which all of some hundred points lie; of fewer points, fewer."""

STRAY_TIMES = 4.0
"""A point stands out when it is this many times as far off its neighbours' curve as any point is without it, and as
rounding moves one.
"""


@dataclass(frozen=True, eq=False)
class MeasuredPoints:
    """Points that a curve was fitted to.

    Attributes
    ----------
    points : (n, 2) array
        mm.
    waver : float
        Standard deviation of their distance from the curve, mm.
    least : float
        What rounding alone makes of that, mm.
    rounding : float
        Largest error of a coordinate by the number of its decimals, mm.
    """

    points: FloatArray
    waver: float
    least: float = 0.0
    rounding: float = 0.0

    @classmethod
    def of(cls, points: FloatArray, least: float = 0.0, rounding: float = 0.0) -> "MeasuredPoints":
        """Return the points (n, 2), no two in a row the same, with their noise.

        A `rounding` of 0 is that of the decimals that the numbers have.
        """
        return cls(points, max(estimate_waver(points), least), least, rounding or _half_last_decimal(points))

    @property
    def wavers(self) -> bool:
        """Return True if the noise is large enough to be reported."""
        return self.waver >= TOLD_MM

    @property
    def resolution(self) -> float:
        """Distance, mm, by which rounding may move a point, at least `FINEST_MM`."""
        return max(float(np.sqrt(2.0)) * self.rounding, FINEST_MM)

    @property
    def reach(self) -> float:
        """How far from the points a smooth curve may be, mm, so that it need not follow the noise.

        It is never less than the largest error of rounding, whose standard deviation is a root of 3 below it.
        """
        return rounded_up(np.clip(2 * np.log10(len(self.points)), np.sqrt(3), REACH) * self.waver, 2)

    @cached_property
    def stray(self) -> tuple[Refusal, ...]:
        """A sentence about the one point that stands out, as a mistyped one does; none where none stands out.

        It is the one without which no points are far off the cubics through their neighbours. The first and last
        cannot be judged: a curve may end as they say.
        """
        count = len(self.points)
        if count < FEWEST + 4:
            return ()
        rough = np.abs(_differences(self.points, 4)[0])
        first = int(rough.argmax())
        near = range(max(1, first), min(count - 1, first + 5))
        others = {at: np.delete(self.points, at, axis=0) for at in near}
        without = {at: np.abs(_differences(points, 4)[0]).max() for at, points in others.items()}
        at = min(without, key=lambda one: without[one])
        if rough.max() <= STRAY_TIMES * max(without[at], self.least):
            return ()
        far, rest = _off_nearest(self.points)[at], _off_nearest(others[at]).max()
        said = (
            "The point at {place}, number {number} of {count}, is {far:.2g} off the curve of its neighbours, "
            "the others {rest:.2g} at most: measure it again, and the end beside it, which cannot be judged."
            if at in (1, count - 2) else
            "The point at {place}, number {number} of {count}, is {far:.2g} off the curve of its neighbours, "
            "the others {rest:.2g} at most: measure it again."
        )  # fmt: skip
        return (note(
            said,
            place=Point(self.points[at]), number=at + 1, count=count, far=Length(far), rest=Length(rest),
            severity="warning",
        ),)  # fmt: skip

    def turns_beside(self, place: FloatArray) -> tuple[float, float, float]:
        """Return by how much the points turn at the point nearest to a place (2,), and at its neighbours, rad.

        Turns to the left are positive. Beside the first and last point they are 0.
        """
        step = np.diff(self.points, axis=0)
        heading = np.arctan2(step[:, 1], step[:, 0])
        turn = np.pad((np.diff(heading) + np.pi) % (2 * np.pi) - np.pi, 2)
        at = int(np.hypot(*(self.points - place).T).argmin())
        before, here, after = turn[at : at + 3].tolist()
        return here, before, after

    @property
    def shown(self) -> Length:
        """The noise as a message tells it."""
        return Length(float(f"{self.waver:.1g}"))

    @property
    def told(self) -> str:
        """The noise, in a sentence without its full stop."""
        return note(
            "the points waver by about {waver}: set {field} to {reach:g} to smooth them",
            waver=self.shown, field=FieldName("smooth"), reach=Length(self.reach),
        )  # fmt: skip


def _half_last_decimal(points: FloatArray) -> float:
    """Return half a unit of the last decimal of coordinates; of numbers with all their digits, of the ninth.

    Examples
    --------
    >>> _half_last_decimal(np.array([[0.0, 12.5], [3.25, 7.0]]))
    0.005
    """
    exact = 1e-15 * np.abs(points).max(initial=1.0)
    decimals = (k for k in range(MOST_DECIMALS) if np.abs(np.round(points, k) - points).max() <= exact)
    return float(0.5 * 10.0 ** -next(decimals, MOST_DECIMALS))


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


def _off_nearest(points: FloatArray) -> FloatArray:
    """Distances (n,), mm, of points across the curve from the cubics through their four nearest; 0 at the ends."""
    across, weights = _differences(points, 4)
    middle = across / weights[:, 2]
    return np.abs([0.0, across[0] / weights[0, 1], *middle, across[-1] / weights[-1, 3], 0.0])


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


@dataclass(frozen=True, eq=False)
class Provenance:
    """What a file says about a curve beside its numbers.

    Parameters
    ----------
    rounding : float
        How far a coordinate may be from what was drawn by the number of its digits alone, mm; 0: not at all.
    healed : float
        How far the curve was moved to take rounding out of its tangents, mm.
    undecided : tuple of Turn
        Turns of the tangent that may be corners and may be rounding.
    place : (3, 3) array, optional
        From millimetres to the coordinates that the drawing program shows.
    unit : str
        What those coordinates are called: "mm", "user units".
    name, layer : str
        What the file calls the curve and its layer; empty when it has no name for them.
    holes : tuple of (float, float, float)
        Circles drawn on a straight first or last piece of the curve: centre and diameter, mm.
    measured : MeasuredPoints, optional
        The points that the whole curve was fitted to.
    vertices : (n, 2) array, optional
        The vertices of the drawn polyline that the whole curve is, if it has corners, mm.
    """

    rounding: float = 0.0
    healed: float = 0.0
    undecided: tuple[Turn, ...] = ()
    place: FloatArray | None = None
    unit: str = "mm"
    name: str = ""
    layer: str = ""
    holes: tuple[tuple[float, float, float], ...] = ()
    measured: MeasuredPoints | None = None
    vertices: FloatArray | None = None

    def shown(self, point: ArrayLike) -> str:
        """A point (2,) in mm as the drawing program shows it.

        Examples
        --------
        >>> Provenance(place=np.diag([2.0, -2.0, 1.0]), unit="user units").shown((10, 5))
        '(20, -10) user units'
        """
        x, y = np.asarray(point, dtype=float)
        if self.place is not None:
            x, y, w = self.place @ (x, y, 1.0)
            x, y = x / w, y / w
        x, y = (round(float(v), 6) + 0.0 for v in (x, y))
        if self.unit == "mm":
            return note("{place:.6g}", place=Point((x, y)))
        return note("({x:.6g}, {y:.6g}) {unit}", x=x, y=y, unit=self.unit)

    def transformed(self, matrix: FloatArray) -> "Provenance":
        """The record of the curve's image under a 3 x 3 map; of a projective one the digits say nothing."""
        m = np.asarray(matrix, dtype=float)
        if m[2, :2].any():
            return replace(self, rounding=0.0, place=None, holes=(), measured=None, vertices=None)
        linear = m[:2, :2] / m[2, 2]
        stretch = float(np.linalg.norm(linear, 2))
        place = (np.eye(3) if self.place is None else self.place) @ np.linalg.inv(m)
        holes = tuple((*(m @ (x, y, 1.0))[:2] / m[2, 2], stretch * size) for x, y, size in self.holes)
        offset = m[:2, 2] / m[2, 2]
        measured = self.measured and MeasuredPoints(
            self.measured.points @ linear.T + offset,
            stretch * self.measured.waver,
            stretch * self.measured.least,
            stretch * self.measured.rounding,
        )
        return replace(
            self,
            rounding=self.rounding * stretch,
            healed=self.healed * stretch,
            place=np.asarray(place),
            holes=tuple((float(x), float(y), float(size)) for x, y, size in holes),
            measured=measured,
            vertices=None if self.vertices is None else self.vertices @ linear.T + offset,
        )

    def reversed(self) -> "Provenance":
        """The record of the curve run from its other end."""
        measured = self.measured and replace(self.measured, points=self.measured.points[::-1])
        vertices = None if self.vertices is None else self.vertices[::-1]
        return replace(self, measured=measured, vertices=vertices)

    def of_part(self) -> "Provenance":
        """The record of a part of the curve: the points were of the whole."""
        return replace(self, measured=None, vertices=None)
