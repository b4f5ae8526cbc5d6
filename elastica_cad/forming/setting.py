"""From a wish with its limits to a problem in numbers."""

from collections.abc import Callable
from dataclasses import dataclass
from functools import lru_cache
from typing import Literal, TypeAlias

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad.errors import InputError
from elastica_cad.forming import constraints as rows
from elastica_cad.forming.distance import ClosestDistance, Distance, LargestDistance, MeanDistance
from elastica_cad.forming.limits import Keep, Limits, Symmetry
from elastica_cad.forming.march import StripGrid
from elastica_cad.forming.problem import Problem
from elastica_cad.forming.wish import Wish, symmetry_frame
from elastica_cad.mechanics import Gravity, Supports

__all__ = ["Measure", "Setting", "Weights", "spline_basis"]

Measure: TypeAlias = Literal["mean", "closest", "max"]
Weights: TypeAlias = "ArrayLike | Callable[[FloatArray], ArrayLike] | None"

_LENGTHS = (0.2, 5.0)  # how much shorter or longer than the wish a rod may be when nothing says so


@dataclass(frozen=True, eq=False)
class Setting:
    """All that is given, in lengths of the wish; `problem` builds what the solver needs.

    Attributes
    ----------
    wish : Wish
    limits : Limits
    keep : Keep
    supports : Supports
    gravity : Gravity or None
    weights : (nodes,) array
        Of the nodes, mean 1.
    nodes, coefficients : int
    line : pair of points or None
        Inflection line to be kept, mm.
    """

    wish: Wish
    limits: Limits
    keep: Keep
    supports: Supports
    gravity: Gravity | None
    weights: FloatArray
    nodes: int
    coefficients: int
    line: tuple[FloatArray, FloatArray] | None = None

    def problem(self, measure: Measure, *, weight: float = 1.0, with_margin: bool = True) -> Problem:
        """The problem with a share `weight` of gravity."""
        grid = self.grid(weight)
        lower, upper = self._box(grid)
        return Problem(
            grid, self.distance(measure), tuple(self._constraints(with_margin)), lower, upper,
            self._scale(grid),
        )  # fmt: skip

    def grid(self, weight: float = 1.0) -> StripGrid:
        """The nodes, with a share `weight` of gravity."""
        e = np.zeros(2) if self.gravity is None else self.gravity.e * self.wish.size**3 * weight
        return StripGrid(self._paired(_nodal_basis(self.nodes, self.coefficients)), e)

    def basis(self, s: FloatArray) -> FloatArray:
        """Values of the basis of K at s (n,) in 0..1, its functions in mirrored pairs where symmetry is kept."""
        return self._paired(spline_basis(s, self.coefficients))

    def _paired(self, basis: FloatArray) -> FloatArray:
        if not self.keep.symmetry:
            return basis
        half = (self.coefficients + 1) // 2
        mirrored = basis[:, ::-1][:, :half].copy()
        if self.coefficients % 2:
            mirrored[:, -1] = 0
        return np.asarray(basis[:, :half] + mirrored)

    def coefficients_of(self, z: FloatArray) -> FloatArray:
        """All coefficients of K, mirrored where symmetry is kept."""
        m = self.coefficients
        if not self.keep.symmetry:
            return z[:m].copy()
        half = (m + 1) // 2
        return np.concatenate([z[:half], z[: m // 2][::-1]])

    @property
    def moment_scale(self) -> float:
        """Typical moment."""
        bend = float(np.sqrt(np.mean(self.wish.curvature**2)))
        return float(max(1.0, bend * min(2.0, np.sqrt(self.limits.largest_ratio))))

    def _scale(self, grid: StripGrid) -> FloatArray:
        u = grid.unknowns
        scale = np.ones(u.count)
        scale[u.moment] = self.moment_scale
        scale[u.force] = 5 * self.moment_scale
        return scale

    def _box(self, grid: StripGrid) -> tuple[FloatArray, FloatArray]:
        u, wish = grid.unknowns, self.wish
        lower, upper = np.full(u.count, -np.inf), np.full(u.count, np.inf)
        lower[u.stiffness], upper[u.stiffness] = self._stiffness_box(u.coefficients)
        start = self.supports.ends[0]
        if self.keep.both_ends[0]:
            lower[u.position] = upper[u.position] = wish.position[0]
        if self.keep.both_tangents[0]:
            lower[u.angle] = upper[u.angle] = wish.angle[0]
        if not start.angle:
            lower[u.moment] = upper[u.moment] = 0.0
        for axis, held in enumerate((start.x, start.y)):
            if not held:
                lower[u.force.start + axis] = upper[u.force.start + axis] = 0.0
        lower[u.length], upper[u.length] = self._lengths()
        return lower, upper

    def _lengths(self) -> tuple[float, float]:
        wish, limits = self.wish, self.limits
        low, high = _LENGTHS if limits.length is None else np.asarray(limits.length) / wish.size
        if self.keep.length:
            if not low * (1 - 1e-12) <= 1 <= high * (1 + 1e-12):
                raise InputError(
                    f"keep length asks for {wish.size:.6g} mm, outside the limit length of "
                    f"{low * wish.size:.6g} to {high * wish.size:.6g} mm: drop one of them"
                )
            low = high = 1.0
        if all(self.keep.both_ends):
            chord = float(np.hypot(*(wish.position[-1] - wish.position[0])))
            if high < chord * (1 - 1e-12):
                raise InputError(
                    f"the rod may be at most {high * wish.size:.6g} mm long, but its kept ends are "
                    f"{chord * wish.size:.6g} mm apart: allow more length or free an end"
                )
        return float(low), float(high)

    def distance(self, measure: Measure) -> Distance:
        """The measure of the distance from the wish."""
        if measure == "mean":
            targets, _ = self.wish.at(np.linspace(0, 1, self.nodes))
            return MeanDistance(targets, self._shares)
        if measure == "closest":
            return ClosestDistance(self.wish, self._shares)
        if measure == "max":
            return LargestDistance(self.wish, self.weights / self.weights.max())
        raise InputError(f"unknown measure {measure!r}: use 'mean', 'closest' or 'max'")

    @property
    def _shares(self) -> FloatArray:
        shares = self.weights.copy()
        shares[[0, -1]] /= 2
        return np.asarray(shares / shares.sum())

    def _constraints(self, with_margin: bool) -> list[rows.Constraint]:
        wish, limits, keep = self.wish, self.limits, self.keep
        end = self.supports.ends[1]
        found: list[rows.Constraint] = []
        if keep.symmetry:
            found.append(self._symmetry(keep.symmetry))
        else:
            if keep.both_ends[1]:
                found.append(rows.EndPosition(target=_pair(wish.position[-1])))
            if keep.both_tangents[1]:
                found.append(rows.EndAngle(target=float(wish.angle[-1])))
            if not end.angle:
                found.append(rows.EndMoment(scale=self.moment_scale))
            found += [
                rows.EndForce(axis=axis, scale=5 * self.moment_scale)
                for axis, held in enumerate((end.x, end.y))
                if not held
            ]
        for s in keep.points:
            if not 0 <= s <= wish.size * (1 + 1e-9):
                raise InputError(f"keep point at {s:.6g} mm lies off the drawn curve of {wish.size:.6g} mm")
            place = min(s / wish.size, 1.0)
            target, _ = wish.at(np.array([place]))
            found.append(rows.Through(target=_pair(target[0]), place=place))
        if self.line is not None:
            a, b = ((np.asarray(p) - wish.origin) / wish.size for p in self.line)
            direction = (b - a) / np.hypot(*(b - a))
            found.append(
                rows.InflectionLine(point=_pair(a), direction=_pair(direction), scale=self.moment_scale)
            )
        curvature = limits.largest_curvature
        if curvature is not None:
            found.append(rows.CurvatureLimit(curvature * wish.size))
        found += [
            rows.KeepOut(region, wish.size, _pair(wish.origin), keep.both_ends) for region in limits.keep_out
        ]
        if limits.stiffness_bounds is not None and limits.stiffness_bounds[0] is not None:
            found.append(rows.LeastStiffness())
        if with_margin and limits.margin is not None:
            found.append(rows.MarginLimit(limits.margin, self.supports))
        return found

    def _symmetry(self, kind: Symmetry) -> rows.Constraint:
        wish = self.wish
        centre, axis = symmetry_frame(wish, kind)
        if kind == "turn":
            if self.gravity is not None:
                raise InputError("a half turn turns gravity over: keep symmetry='turn' only without weight")
            return rows.MiddleOfTurn(centre=_pair(centre), scale=self.moment_scale)
        if self.gravity is not None and abs(np.dot(self.gravity.direction, axis)) < 1 - 1e-9:
            raise InputError(
                "gravity pulls across the mirror axis: a strip with weight cannot stay symmetric"
            )
        across = np.array([-axis[1], axis[0]])
        middle = float(wish.angles(np.array([0.5]))[0])
        angle = float(np.arctan2(across[1], across[0]))
        angle += np.pi * np.round((middle - angle) / np.pi)
        return rows.MiddleOfMirror(
            centre=_pair(centre), axis=_pair(axis), angle=angle, scale=5 * self.moment_scale
        )

    def _stiffness_box(self, count: int) -> tuple[FloatArray, FloatArray]:
        """Least and largest coefficients: of the bounds along the strip the strictest over each one's support."""
        ratio = self.limits.largest_ratio
        low, high = np.ones(count), np.full(count, ratio)
        if self.limits.stiffness_bounds is None:
            return low, high
        s = np.linspace(0, 1, 20 * self.coefficients + 1)
        support = self.basis(s) > 0
        below, above = self.limits.stiffness_bounds
        if below is not None:
            values = _along(below, s, self.wish.size, "stiffness bounds")
            low = np.maximum(low, np.where(support, values[:, None], -np.inf).max(axis=0))
        if above is not None:
            values = _along(above, s, self.wish.size, "stiffness bounds")
            high = np.minimum(high, np.where(support, values[:, None], np.inf).min(axis=0))
        if low.min() > 1:
            raise InputError(
                f"stiffness_bounds ask for at least {low.min():.4g} everywhere, but K / min K is 1 somewhere: "
                "let the lower bound come down to 1"
            )
        if np.any(low > high):
            at = float(s[int(np.argmax(support[:, int(np.argmax(low - high))]))]) * self.wish.size
            raise InputError(
                f"no stiffness is both above the lower and below the upper bound (or the ratio limit {ratio:.4g}) "
                f"near {at:.4g} mm: widen the bounds"
            )
        return low, high


@lru_cache(maxsize=16)
def _nodal_basis(nodes: int, coefficients: int) -> FloatArray:
    basis = spline_basis(np.linspace(0, 1, nodes), coefficients)
    basis.flags.writeable = False
    return basis


def spline_basis(x: FloatArray, count: int) -> FloatArray:
    """Values (n, count) of the cubic B-splines with uniform clamped knots at x (n,) in 0..1."""
    from scipy.interpolate import BSpline

    return np.asarray(BSpline.design_matrix(np.clip(x, 0, 1), spline_knots(count), 3).toarray())


def spline_knots(count: int) -> FloatArray:
    """Their knots."""
    return np.concatenate([np.zeros(3), np.linspace(0, 1, count - 2), np.ones(3)])


def node_factors(weights: Weights, nodes: int, size: float) -> FloatArray:
    """Weights along the curve at the nodes, mean 1."""
    values = _along(1.0 if weights is None else weights, np.linspace(0, 1, nodes), size, "weights")
    if np.any(values < 0) or not values.any():
        raise InputError("weights along the curve must be 0 or more, and not all 0")
    return np.asarray(values / values.mean())


def _along(given: object, x: FloatArray, size: float, what: str) -> FloatArray:
    """Values at x (0..1) of a number, of values at equal distances, or of a function of arc length in mm."""
    values = given(x * size) if callable(given) else given
    array = np.asarray(values, dtype=float)
    if array.ndim == 0:
        array = np.full(2, float(array))
    if array.ndim != 1 or array.size < 2 or not np.all(np.isfinite(array)):
        raise InputError(
            f"{what} must be a finite number, values at equal distances, or a function of arc length"
        )
    return np.asarray(np.interp(x, np.linspace(0, 1, array.size), array))


def _pair(point: FloatArray) -> tuple[float, float]:
    return float(point[0]), float(point[1])
