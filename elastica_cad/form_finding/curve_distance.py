"""Drawn curve in units of its length, and measures of the distance of a rod from the curve."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, Protocol

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import FloatArray
from elastica_cad.errors import InputError, Length
from elastica_cad.form_finding.constraints import thin_rows
from elastica_cad.form_finding.limits import Symmetry
from elastica_cad.form_finding.rod_map import MappedRod, Sensitivities
from elastica_cad.form_finding.sqp import LocalModel
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.geometry.plane_points import cross, dot, left_of, norm, unit, unit_vectors
from elastica_cad.geometry.splines import spline_through

if TYPE_CHECKING:
    from scipy.interpolate import CubicHermiteSpline


# number of intervals of the interpolated curve, for an interpolation error of 1e-9 of the curve's length
SPANS = 1000
# half width of the window in which the nearest point is searched, as a fraction of the curve's length
_WINDOW_LENGTHS = 0.08


@dataclass(frozen=True, eq=False)
class TargetCurve:
    """The drawn curve as evenly spaced points, with cubic Hermite interpolation between them.

    Attributes
    ----------
    position : (spans + 1, 2) array
        Points relative to `origin`, divided by `size`.
    angle, curvature : (spans + 1,) arrays
    size : float
        Length of the curve, which is the unit of length, mm.
    origin : (2,) array
        Mean of the points of the curve, mm.
    """

    position: FloatArray
    angle: FloatArray
    curvature: FloatArray
    size: float
    origin: FloatArray

    @classmethod
    def of(cls, curve: PlaneCurve) -> "TargetCurve":
        """Return the target for a drawn curve."""
        samples = curve.sample(SPANS + 1)
        origin = samples.position.mean(axis=0)
        size = curve.length
        return cls((samples.position - origin) / size, samples.angle, samples.curvature * size, size, origin)

    def at(self, s: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return positions (n, 2) and their derivatives (n, 2) at arc lengths s (n,) in 0..1."""
        spline = self._spline
        return spline(s), spline(s, 1)

    def angles(self, s: FloatArray) -> FloatArray:
        """Return the tangent angles (n,), rad, at s (n,): arc lengths divided by the length of the target."""
        return np.interp(s, even_steps(self.angle.size), self.angle)

    def feet(self, points: FloatArray, near: FloatArray) -> FloatArray:
        """Return the arc lengths (n,) of the target points nearest to `points` (n, 2), in windows around `near`."""
        tries = (near[:, None] + np.linspace(-_WINDOW_LENGTHS, _WINDOW_LENGTHS, 17)).clip(0, 1)
        off = self.position[np.rint(tries * (len(self.position) - 1)).astype(int)] - points[:, None]
        s = tries[np.arange(len(points)), dot(off, off).argmin(axis=1)]
        for _ in range(4):
            position, direction = self.at(s)
            off, i = points - position, np.rint(s * (len(self.position) - 1)).astype(int)
            # limit the step, because Newton's method diverges near the centre of curvature
            spread = np.maximum(1 - self.curvature[i] * cross(self._directions[i], off), 0.3)
            s = (s + dot(off, direction) / spread).clip(0, 1)
        return np.asarray(s)

    @cached_property
    def _spline(self) -> "CubicHermiteSpline":
        from scipy.interpolate import CubicHermiteSpline

        return CubicHermiteSpline(even_steps(self.angle.size), self.position, self._directions)

    @cached_property
    def _directions(self) -> FloatArray:
        return unit_vectors(self.angle)

    @cached_property
    def diagonal(self) -> float:
        """Diagonal of the bounding box of the curve, as a multiple of the curve's length."""
        return float(norm(np.ptp(self.position, axis=0)))


def even_steps(count: int) -> FloatArray:
    """Return `count` evenly spaced numbers from 0 to 1."""
    return np.linspace(0, 1, count)


def symmetry_frame(target: TargetCurve, kind: Symmetry) -> tuple[FloatArray, FloatArray]:
    """Return the centre of symmetry (2,), divided by the length, and a unit vector (2,) along the mirror axis."""
    p, q = target.position, target.position[::-1]
    middles, across = (p + q) / 2, p - q
    centre = middles.mean(axis=0)
    if kind == "turn":
        error = float(np.abs(middles - centre).max())
        axis = np.array([1.0, 0.0])
    else:
        # the vectors between mirrored points are normal to the axis, along which they have the least scatter
        values, vectors = np.linalg.eigh(across.T @ across)
        axis = vectors[:, int(values.argmin())]
        error = float(max(np.abs(across @ axis).max(), np.abs((middles - centre) @ left_of(axis)).max()))
    # a symmetric curve differs from its mirrored or rotated image by a smaller fraction of its length
    if error > 1e-4:
        name = "mirror image" if kind == "mirror" else "half turn"
        raise InputError(
            "the drawn curve differs from its {name} by {size}: draw a symmetric curve, or leave out "
            "`keep.symmetry`",
            name=name,
            size=Length(error * target.size),
        )
    return centre, axis


class Distance(Protocol):
    """Interface of a measure of the distance of a rod from the target."""

    def value(self, rod: MappedRod) -> float:
        """Return the distance to minimise; the unit of length is the length of the target."""

    def model(self, rod: MappedRod, sensitivities: Sensitivities) -> LocalModel:
        """Return a convex Gauss-Newton model of the distance as a function of a step of the unknowns.

        The last column of the sensitivities is the change that brings the rod into equilibrium.
        """


@dataclass(frozen=True, eq=False)
class MeanDistance:
    """Half the weighted mean of squared distances between rod and target at equal fractions of their lengths.

    Attributes
    ----------
    targets : (n+1, 2) array
        Points on the target for the n+1 nodes.
    shares : (n+1,) array
        Weights with the sum 1.
    """

    targets: FloatArray
    shares: FloatArray

    def value(self, rod: MappedRod) -> float:
        """Return half the weighted mean of the squared distances."""
        off = rod.position - self.targets
        return 0.5 * float(self.shares @ dot(off, off))

    def model(self, rod: MappedRod, sensitivities: Sensitivities) -> LocalModel:
        """Return a model of the distance that is exact for positions linear in the unknowns."""
        J = sensitivities.position.reshape(-1, sensitivities.position.shape[2])
        return _least_squares(J, (rod.position - self.targets).ravel(), self.shares.repeat(2))


@dataclass(frozen=True, eq=False)
class ClosestDistance:
    """Half the weighted mean of the squared distances of the nodes from the nearest points on the target.

    Attributes
    ----------
    shares : (n+1,) array
        Weights with the sum 1.
    """

    target: TargetCurve
    shares: FloatArray

    def value(self, rod: MappedRod) -> float:
        """Return half the weighted mean of the squared distances."""
        off, _ = offsets(self.target, rod)
        return 0.5 * float(self.shares @ dot(off, off))

    def model(self, rod: MappedRod, sensitivities: Sensitivities) -> LocalModel:
        """Return a Gauss-Newton model that omits the motion of the nodes along the target."""
        off, normal = offsets(self.target, rod)
        return _least_squares(_across(normal, sensitivities), dot(off, normal), self.shares)


@dataclass(frozen=True, eq=False)
class LargestDistance:
    """Largest weighted distance of a node from the nearest point on the target.

    Attributes
    ----------
    factors : (n+1,) array
        Weights, of which the largest is 1.
    """

    target: TargetCurve
    factors: FloatArray

    def value(self, rod: MappedRod) -> float:
        """Return the largest weighted distance of a node from the target."""
        off, _ = offsets(self.target, rod)
        return float((self.factors * norm(off)).max())

    def model(self, rod: MappedRod, sensitivities: Sensitivities) -> LocalModel:
        """Return a local model of the largest weighted distance."""
        off, normal = offsets(self.target, rod)
        signed = self.factors * dot(off, normal)
        size, p = np.abs(signed), rod.z.size
        # nearer nodes are unlikely to be the farthest after a step
        farthest = thin_rows(np.flatnonzero(size >= 0.5 * size.max()), size)
        across = _across(normal, sensitivities)
        slopes = self.factors[farthest, None] * across[farthest]
        # signed distances of the nodes after the change to equilibrium; negative to the right of the target
        at = signed[farthest] + slopes[:, p]
        rows = np.sign(at)[:, None] * slopes[:, :p]
        # add a small fraction of the mean square, so that the best step is unique
        return LocalModel(
            0.0, 1e-3 / signed.size * across[:, :p].T @ across[:, :p], np.zeros(p), np.abs(at), rows
        )


def offsets(target: TargetCurve, rod: MappedRod) -> tuple[FloatArray, FloatArray]:
    """Return the offsets (n+1, 2) of nodes from the nearest target points, and the unit normals (n+1, 2) there.

    Beyond an end of the target, the normal is the direction of the offset.
    """
    return rod.remembered(target, lambda: _offsets(target, rod))


def _offsets(target: TargetCurve, rod: MappedRod) -> tuple[FloatArray, FloatArray]:
    """Return the offsets (n+1, 2) of the nodes from the target, and the normals (n+1, 2) there."""
    n = len(rod.position) - 1
    feet = target.feet(rod.position, even_steps(n + 1))
    position, direction = target.at(feet)
    off = rod.position - position
    normal = left_of(unit(direction))
    size = norm(off)
    past = ((feet <= 0) | (feet >= 1)) & (size > 0)
    normal[past] = off[past] / size[past, None]
    return off, normal


def _across(normal: FloatArray, sensitivities: Sensitivities) -> FloatArray:
    # derivatives (n+1, p) of the positions along the normals (n+1, 2)
    d = sensitivities.position
    return normal[:, 0, None] * d[:, 0] + normal[:, 1, None] * d[:, 1]


def _least_squares(J: FloatArray, r: FloatArray, shares: FloatArray) -> LocalModel:
    """Return the model of half the weighted mean square of r + J d for a step d, with the weights `shares` (k,).

    The last column of J is the change that brings the rod into equilibrium. This change is added to r.
    """
    p, roots = J.shape[1] - 1, np.sqrt(shares)
    A = J * roots[:, None]
    A[:, -1] += r * roots
    product = A.T @ A
    return LocalModel(
        0.5 * float(product[p, p]), product[:p, :p], product[:p, p], np.zeros(0), np.zeros((0, p))
    )


def measure_deviation(target: TargetCurve, nodes: FloatArray) -> float:
    """Return the largest distance between the target and a smooth curve through `nodes` (n, 2).

    The unit is the length of the target.
    """
    other = spline_through(even_steps(len(nodes)), nodes, 3)(even_steps(len(target.position)))
    return max(_largest_distance(target.position, other), _largest_distance(other, target.position))


def _largest_distance(points: FloatArray, chain: FloatArray) -> float:
    """Return the largest distance of points from a polyline.

    Each point is compared with the two sides beside its nearest vertex.
    """
    from scipy.spatial import cKDTree

    chords = np.diff(chain, axis=0)
    squares = np.maximum(np.einsum("ij,ij->i", chords, chords), 1e-300)
    _, nearest = cKDTree(chain).query(points)
    least = np.full(len(points), np.inf)
    for k in (np.maximum(nearest - 1, 0), np.minimum(nearest, len(chords) - 1)):
        off = points - chain[k]
        chord = chords[k]
        off -= np.clip(np.einsum("ij,ij->i", off, chord) / squares[k], 0, 1)[:, None] * chord
        least = np.minimum(least, norm(off))
    return float(least.max())
