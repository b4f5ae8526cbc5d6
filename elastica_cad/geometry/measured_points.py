"""Source of a curve in a file, and the points to which it was fitted: their noise, and a single mistyped point."""

from dataclasses import dataclass, replace

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad.errors import FieldName, Length, Point, Refusal, note, rounded_up
from elastica_cad.geometry.plane_points import (
    angle_of,
    cross,
    is_closed,
    lengths_along,
    norm,
    thinned,
    transform_points,
)
from elastica_cad.geometry.tangent_healing import Turn

ORDERS = range(2, 8)
"""Orders of the divided differences that separate noise from shape."""

FEWEST = 8
"""Least number of divided differences for an estimate of the noise."""

SETTLED = 0.7
"""Ratio of divided differences of successive orders: smaller for a smooth curve, larger for noise.

Orders k and k + 2 are compared first, because differences of odd orders are 0 across the chord of a circle.
"""

REPORTED_MM = 0.01
"""Smallest noise that is reported, mm, because a fit removes smaller noise."""

FINEST_MM = 1e-3
"""Finest resolution of points, mm, that affects the widths of a strip."""

MOST_DECIMALS = 9
"""Largest number of decimals of millimetres that points may have."""

REACH = 4.0
"""Largest distance of a hundred or more noisy points from a smooth curve, in standard deviations.

For fewer points, the largest distance is smaller.
"""

OUTLIER_TIMES = 4.0
"""A point is an outlier if the largest divided difference exceeds this multiple of the largest one without it.

It must also exceed this multiple of the rounding errors.
"""


@dataclass(frozen=True, eq=False)
class MeasuredPoints:
    """Points to which a curve was fitted.

    Attributes
    ----------
    points : (n, 2) array
        Points, mm.
    noise : float
        Standard deviation of the distance of the points from the curve, mm.
    least : float
        Standard deviation that rounding alone causes, mm.
    rounding : float
        Largest rounding error of a coordinate, from the number of its decimals, mm.
    is_smoothed : bool
        True if the curve is smoothed by the noise already, as curves through closed points are.
    """

    points: FloatArray
    noise: float
    least: float = 0.0
    rounding: float = 0.0
    is_smoothed: bool = False

    @classmethod
    def of(cls, points: FloatArray, least: float = 0.0, rounding: float = 0.0) -> "MeasuredPoints":
        """Return the record of points (n, 2), with an estimate of their noise. Neighbouring points must differ.

        `rounding` is at least half a unit of the last decimal of the coordinates.
        """
        rounding = max(rounding, _half_last_decimal(points))
        return cls(points, max(_credible_noise(points, rounding / np.sqrt(3)), least), least, rounding)

    @property
    def is_noisy(self) -> bool:
        """True if the curve has noise that is large enough to be reported."""
        return self.noise >= REPORTED_MM and not self.is_smoothed

    @property
    def resolution(self) -> float:
        """Distance, mm, by which rounding may move a point, but at least `FINEST_MM`."""
        return max(float(np.sqrt(2.0)) * self.rounding, FINEST_MM)

    @property
    def reach(self) -> float:
        """Distance, mm, by which a smooth curve may differ from the points because of their noise.

        The distance is at least sqrt(3) standard deviations, which is the largest error of rounded numbers.
        """
        return rounded_up(np.clip(2 * np.log10(len(self.points)), np.sqrt(3), REACH) * self.noise, 2)

    @cached_property
    def outlier(self) -> tuple[Refusal, ...]:
        """Message about an outlier, such as a mistyped point. The tuple is empty if there is no outlier.

        If the outlier is removed, each other point is close to the cubic through its neighbours. The first and last
        points are not checked, because a curve may end anywhere.
        """
        count = len(self.points)
        if count < FEWEST + 4:
            return ()
        rough = np.abs(_differences(self.points, 4)[0])
        first = int(rough.argmax())
        # the largest difference contains five points; the outlier is the one whose removal helps most
        near = range(max(1, first), min(count - 1, first + 5))
        remaining_points = {at: np.delete(self.points, at, axis=0) for at in near}
        without = {at: np.abs(_differences(points, 4)[0]).max() for at, points in remaining_points.items()}
        at = min(without, key=without.__getitem__)
        if rough.max() <= OUTLIER_TIMES * max(without[at], self.least):
            return ()
        distance, rest = _off_nearest(self.points)[at], _off_nearest(remaining_points[at]).max()
        return (note(
            "The point at {place}, number {number} of {count}, is {far:.2g} from the curve of its "
            "neighbours; the other points are within {rest:.2g}. Measure it again, and also the end point "
            "beside it, which has only one neighbour."
            if at in (1, count - 2) else
            "The point at {place}, number {number} of {count}, is {far:.2g} from the curve of its "
            "neighbours; the other points are within {rest:.2g}. Measure it again.",
            place=Point(self.points[at]), number=at + 1, count=count, far=Length(distance), rest=Length(rest),
            severity="warning",
        ),)  # fmt: skip

    def turns_beside(self, place: FloatArray) -> tuple[float, float, float]:
        """Return the turning angles, rad, at the point nearest to `place` (2,), before this point and after it.

        Angles to the left are positive. Points beyond the ends have the angle 0.
        """
        # with two zeros at each end, the turn at point i has the index i + 1
        turn = np.pad(self._turns[0], 2)
        at = int(norm(self.points - place).argmin())
        before, here, after = turn[at : at + 3].tolist()
        return here, before, after

    @property
    def bend_changes(self) -> int:
        """Number of changes between left and right turns along the points, without turns that rounding can cause.

        A curve through the points has at least this number of inflections.
        """
        turn, rounding = self._turns
        sides = np.sign(turn[np.abs(turn) > rounding])
        return int((sides[1:] != sides[:-1]).sum())

    @cached_property
    def _turns(self) -> tuple[FloatArray, FloatArray]:
        """Turning angles (n - 2,), rad, at inner points, positive to the left, and their largest errors."""
        step = np.diff(self.points, axis=0)
        rounding = 2 * self.resolution / norm(step)
        return (np.diff(angle_of(step)) + np.pi) % (2 * np.pi) - np.pi, rounding[1:] + rounding[:-1]

    @property
    def rounded_noise(self) -> Length:
        """Noise, mm, rounded to one digit for messages."""
        return Length(float(f"{self.noise:.1g}"))

    @property
    def noise_message(self) -> str:
        """Message about the noise, without a full stop."""
        return note(
            "the points have noise of about {noise}: set {field} to about {reach:g} to smooth them",
            noise=self.rounded_noise, field=FieldName("smooth"), reach=Length(self.reach),
        )  # fmt: skip


def _half_last_decimal(points: FloatArray) -> float:
    """Return half the step of coordinates: one or five units of their last decimal, at most the ninth decimal.

    Examples
    --------
    >>> _half_last_decimal(np.array([[0.0, 12.53], [3.25, 7.0]])), _half_last_decimal(np.array([[0.5, 12.0]]))
    (0.005, 0.25)
    """
    exact = 1e-15 * np.abs(points).max(initial=1.0)
    steps = (units * 10.0**-k for k in range(MOST_DECIMALS) for units in (1.0, 0.5))
    whole = (step for step in steps if np.abs(np.round(points / step) * step - points).max() <= exact)
    return float(0.5 * next(whole, 10.0**-MOST_DECIMALS))


def _credible_noise(points: FloatArray, rounding: float) -> float:
    """Return the noise, mm, of points whose coordinates have rounding errors of standard deviation `rounding`.

    Curves through closed points are smoothed by their noise. The rounding errors therefore replace the estimate
    if it is within their scatter, or if it decreases with more points, because it is then due to the shape.
    """
    noise = estimate_noise(points)
    if not is_closed(points):
        return noise
    half = thinned(points, 2)
    is_scatter = noise < (1 + 4 / np.sqrt(len(points))) * rounding
    if is_scatter or not is_closed(half) or estimate_noise(half) > 2 * noise:
        return rounding
    return noise


def estimate_noise(points: FloatArray) -> float:
    """Return the standard deviation, mm, of the distance of points (n, 2) from a smooth curve.

    The result is the scaled median of divided differences normal to the curve. The order of the differences is
    increased as long as this reduces the estimate. Gasser, Sroka and Jennen-Steinmetz (Biometrika 73, 1986) use
    order 2. The result is 0 for too few points, or if the differences decrease like those of a smooth curve. On a
    closed curve, the differences continue beyond the last point.

    Examples
    --------
    >>> x = np.linspace(0.0, 400.0, 200)
    >>> arch = np.column_stack([x, 0.001 * x * (400 - x)])
    >>> noise = 0.5 * np.random.default_rng(2).normal(size=arch.shape)
    >>> round(estimate_noise(arch), 6), round(estimate_noise(arch + noise), 1)
    (0.0, 0.5)
    """
    while True:
        around = [np.concatenate([points, points[1 : order * is_closed(points)]]) for order in ORDERS]
        # the scaled median of differences normal to the curve is a standard deviation
        sizes = [
            float(np.median(np.abs(_differences(p, order)[0])) / 0.6745)
            for p, order in zip(around, ORDERS, strict=True)
            if len(p) - order >= FEWEST
        ]
        # estimates of the orders k and k + gap
        pairs = ((gap, *pair) for gap in (2, 1) for pair in zip(sizes, sizes[gap:], strict=False))
        noise = next((higher for gap, lower, higher in pairs if higher > SETTLED**gap * lower), 0.0)
        spacing = lengths_along(points)[-1] / len(points)
        # more noise could change the order of neighbouring points along the curve
        if noise <= 0.1 * spacing or len(points) < 4 * FEWEST:
            return noise
        points = thinned(points, 2)


def _off_nearest(points: FloatArray) -> FloatArray:
    """Return the distance (n,), mm, of each point from a cubic through four neighbours, or 0 at the ends."""
    across, weights = _differences(points, 4)
    return np.abs(
        [0.0, across[0] / weights[0, 1], *(across / weights[:, 2]), across[-1] / weights[-1, 3], 0.0]
    )


def _differences(points: FloatArray, order: int) -> tuple[FloatArray, FloatArray]:
    """Return divided differences (m,) across the chord of their points, and the weights (m, order + 1).

    The chord of a difference is from the first to the last of its points.
    """
    window = np.arange(len(points) - order)[:, None] + np.arange(order + 1)
    s, near = lengths_along(points)[window], points[window]
    # the unit matrix makes the factor of a point and itself 1
    gaps = (s[:, :, None] - s[:, None, :]) / np.ptp(s, axis=1)[:, None, None] + np.eye(order + 1)
    weights = 1 / gaps.prod(axis=2)
    # with unit weights, independent errors of the points give the difference an error of the same size
    weights /= np.linalg.norm(weights, axis=1)[:, None]
    chord = near[:, -1] - near[:, 0]
    across = cross(chord, np.einsum("ij,ijk->ik", weights, near))
    return across / np.maximum(norm(chord), 1e-300), weights


@dataclass(frozen=True, eq=False)
class Provenance:
    """Origin of a curve in a file: name, layer, units, precision.

    Parameters
    ----------
    rounding : float
        Largest rounding error of a coordinate, estimated from the number of its digits, mm; 0 if coordinates are
        exact.
    healed : float
        Distance by which the curve was moved to remove rounding errors from its tangents, mm.
    undecided : tuple of Turn
        Turns of the tangent that may be corners or rounding errors.
    place : (3, 3) array, optional
        Matrix that converts millimetres to the coordinates displayed by the drawing program.
    unit : str
        Unit of the displayed coordinates, such as "mm" or "user units".
    name, layer : str
        Names of the curve and its layer in the file; empty if it has none.
    holes : tuple of (float, float, float)
        Circles drawn on a straight first or last piece of the curve: x and y of the centre, and diameter, mm.
    measured : MeasuredPoints, optional
        Points to which the whole curve was fitted.
    vertices : (n, 2) array, optional
        Vertices of the drawn polyline, mm, if the whole curve is a polyline with corners.
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
        """Return the coordinates of a point (2,), mm, as the drawing program displays them.

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

    def transformed(self, m: FloatArray) -> "Provenance":
        """Return the record for the image of the curve under a 3 x 3 matrix."""
        if m[2, :2].any():
            return replace(self, rounding=0.0, place=None, holes=(), measured=None, vertices=None)
        stretch = float(np.linalg.norm(m[:2, :2] / m[2, 2], 2))
        place = (np.eye(3) if self.place is None else self.place) @ np.linalg.inv(m)
        measured = self.measured and replace(
            self.measured,
            points=transform_points(m, self.measured.points),
            noise=stretch * self.measured.noise,
            least=stretch * self.measured.least,
            rounding=stretch * self.measured.rounding,
        )
        return replace(
            self,
            rounding=self.rounding * stretch,
            healed=self.healed * stretch,
            place=np.asarray(place),
            holes=tuple((*transform_points(m, (x, y)).tolist(), stretch * size) for x, y, size in self.holes),
            measured=measured,
            vertices=None if self.vertices is None else transform_points(m, self.vertices),
        )

    def reversed(self) -> "Provenance":
        """Return the record for the reversed curve."""
        measured = self.measured and replace(self.measured, points=self.measured.points[::-1])
        vertices = None if self.vertices is None else self.vertices[::-1]
        return replace(self, measured=measured, vertices=vertices)

    def of_part(self) -> "Provenance":
        """Return the record for a part of the curve, without the points of the whole curve."""
        return replace(self, measured=None, vertices=None)
