"""Quantity along a strip, such as stiffness or width, as a B-spline function of arc length."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._values import is_whole, numbers, require_number, require_positive
from elastica_cad.errors import InputError
from elastica_cad.geometry.polynomials import interior_roots, raise_degree, value_and_slope
from elastica_cad.geometry.splines import (
    SplineFunction,
    adaptive_spline,
    finite,
    greville,
    is_clamped,
    knot_runs,
    spline_through,
)

STEP_SHARE = 2e-5
"""Length of the ramp that replaces a step, as a fraction of the length of the strip.

The ramp keeps the edge of an outline continuous.
"""


@dataclass(frozen=True, eq=False)
class Profile:
    """B-spline function of arc length, whose graph is exactly a B-spline curve.

    Parameters
    ----------
    knots : (m + degree + 1,) array_like
        Full knot vector over arc length, mm, clamped at both ends.
    coefficients : (m,) array_like
        B-spline coefficients, in the unit of the values.
    degree : int
        Polynomial degree, 3 by default.

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
            array = finite(f"profile {name}", getattr(self, name))
            if array.ndim != 1:
                raise InputError(f"profile {name} has the shape {array.shape}: give a row of numbers")
            object.__setattr__(self, name, array)
        if not (is_whole(self.degree) and self.degree >= 1):
            raise InputError(f"the degree of a profile is {self.degree!r}: use a whole number, 1 or more")
        if self.knots.size != self.coefficients.size + self.degree + 1:
            raise InputError(
                f"a profile has {self.knots.size} knots and {self.coefficients.size} coefficients: give "
                f"{self.coefficients.size + self.degree + 1} knots for degree {self.degree}"
            )
        clamped = is_clamped(self.knots, self.degree)
        if (self.knots[1:] < self.knots[:-1]).any() or not self.knots[-1] > self.knots[0] or not clamped:
            raise InputError(
                "the knots of a profile are not clamped: give knots that never decrease, with "
                f"{self.degree + 1} equal knots at each end"
            )

    def __repr__(self) -> str:
        low, high = self.extremes
        return f"<Profile of degree {self.degree}, {self.coefficients.size} coefficients, {low:.4g} to {high:.4g}>"

    @classmethod
    def fit(
        cls,
        function: Callable[[FloatArray], FloatArray],
        length: float,
        *,
        breaks: Sequence[tuple[float, int]] = (),
        knots: ArrayLike = (),
        tolerance: float = 1e-7,
        degree: int = 3,
    ) -> "Profile":
        """Return the profile that approximates `function` on [0, length] within the absolute error `tolerance`.

        Parameters
        ----------
        function : callable
            Function of arc lengths (k,) that returns values (k,); it is not evaluated at breaks and ends.
        breaks : sequence of (s, continuity)
            Arc lengths at which the function has only `continuity` continuous derivatives; -1 means a jump. The
            profile has the same continuity there.
        knots : (k,) array_like
            Initial knots; further knots are inserted where the error exceeds the tolerance.

        Raises
        ------
        NotConvergedError
            The function has a break that is not in `breaks`, or noise above the tolerance.
        """
        require_positive(length, "the length of a profile")
        spline_knots, coefficients = adaptive_spline(
            function,
            (0.0, float(length)),
            degree=degree,
            tolerance=tolerance,
            breaks=breaks,
            knots=finite("knots", knots),
            rounding=1e-9,  # typical rounding error of quotients of moment and curvature
        )
        return cls(spline_knots, coefficients, degree)

    @classmethod
    def interpolate(cls, s: ArrayLike, values: ArrayLike) -> "Profile":
        """Return the cubic spline through `values` (n,) at increasing arc lengths `s` (n,)."""
        s, values = finite("arc lengths", s), finite("values", values)
        if s.ndim != 1 or s.shape != values.shape or s.size < 2 or (np.diff(s) <= 0).any():
            raise InputError(
                "the profile cannot be read: give two or more increasing arc lengths, each with a value"
            )
        through = spline_through(s, values, min(3, s.size - 1))
        knots, coefficients = through.knots, through.coefficients
        # two or three values give a polynomial of a lower degree, which is raised to 3
        while knots.size < 8:
            knots = np.pad(knots, 1, mode="edge")
            coefficients = raise_degree(coefficients)
        return cls(knots, coefficients)

    def __call__(self, s: ArrayLike, derivative: int = 0) -> FloatArray:
        """Return values, or derivatives per mm, at arc lengths `s`, also extrapolated beyond the ends."""
        if not (is_whole(derivative) and derivative >= 0):
            raise InputError(f"the order of a derivative is {derivative!r}: use 0, 1, 2 ...")
        return self._function(numbers(s, "arc lengths of a profile"), derivative)

    @property
    def length(self) -> float:
        """Largest arc length of the domain, mm."""
        return float(self.knots[-1])

    @property
    def extremes(self) -> tuple[float, float]:
        """Smallest and largest value, except for rounding errors. The values on both sides of a jump count."""
        low, high = self._extreme_points[1].tolist()
        return low, high

    @property
    def is_positive(self) -> bool:
        """True if the value is positive everywhere."""
        return bool(self.coefficients.min() > 0) or self.extremes[0] > 0

    @property
    def extreme_places(self) -> tuple[float, float]:
        """Arc lengths, mm, of the smallest and of the largest value."""
        first, second = self._extreme_points[0].tolist()
        return first, second

    @cached_property
    def _extreme_points(self) -> tuple[FloatArray, FloatArray]:
        """Arc lengths (2,), mm, and values (2,) of the smallest and of the largest value."""
        pieces = self._function.pieces
        at_knots = pieces[:, [0, -1]]
        # only a piece with a coefficient outside the range of knot values can leave this range
        passing = (pieces.min(axis=1) < at_knots.min()) | (pieces.max(axis=1) > at_knots.max())
        which = passing.nonzero()[0]
        turns = interior_roots(np.diff(pieces[which]))
        index, u = which[[root.piece for root in turns]], np.array([root.u for root in turns])
        edges, _ = knot_runs(self.knots)
        start, end = edges[:-1], edges[1:]
        places = np.concatenate([start, end, start[index] + u * (end - start)[index]])
        values = np.concatenate([*at_knots.T, value_and_slope(pieces[index], u)[0]])
        both = [values.argmin(), values.argmax()]
        return places[both], values[both]

    @property
    def breaks(self) -> tuple[tuple[float, int], ...]:
        """Arc length of each interior knot, with the number of continuous derivatives there; -1 at a jump."""
        knots, counts = knot_runs(self.knots[self.degree + 1 : -self.degree - 1])
        return tuple((float(s), self.degree - int(n)) for s, n in zip(knots, counts, strict=True))

    @cached_property
    def steps(self) -> tuple[tuple[float, float], ...]:
        """Start and end, mm, of each ramp that represents a step."""
        places = np.array([place for place, _ in self.breaks])
        ends = np.flatnonzero(np.diff(places, append=np.inf) > STEP_SHARE * self.length)
        starts = np.append(0, ends + 1)[:-1]
        return tuple((float(places[i]), float(places[j])) for i, j in zip(starts, ends, strict=True) if i < j)

    @property
    def greville(self) -> FloatArray:
        """Greville abscissae (m,): the x coordinates of the control points of the graph of the profile."""
        return greville(self.knots, self.degree)

    def scaled(self, factor: float) -> "Profile":
        """Return the profile times `factor`."""
        require_number(factor, "the factor of a profile")
        return self._changed(0.0, factor, 0.0)

    def stretched(self, low: float, high: float) -> "Profile":
        """Return the profile with values transformed linearly to the extremes `low` and `high`.

        The profile must not be constant.

        Examples
        --------
        >>> ramp = Profile.interpolate([0.0, 10.0], [1.0, 3.0]).stretched(1.0, 2.0)
        >>> ramp.extremes, float(ramp(5.0))
        ((1.0, 2.0), 1.5)
        """
        require_number(low, "the least value of a profile")
        require_number(high, "the largest value of a profile")
        least, most = self.extremes
        return self._changed(least, (high - low) / (most - least), low)

    def _changed(self, least: float, factor: float, low: float) -> "Profile":
        """Return the profile with its values mapped to low + (value - least) * factor.

        If the factor is positive, the arc lengths of the extremes do not change.
        """
        changed = Profile(self.knots, low + (self.coefficients - least) * factor, self.degree)
        if factor > 0 and "_extreme_points" in vars(self):
            places, values = self._extreme_points
            vars(changed)["_extreme_points"] = places, low + (values - least) * factor
        return changed

    @cached_property
    def _function(self) -> SplineFunction:
        return SplineFunction(self.knots, self.coefficients, self.degree)
