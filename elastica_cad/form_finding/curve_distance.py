"""Drawn curve in units of its length, and measures of the distance of a rod from the curve."""

from dataclasses import dataclass
from typing import TYPE_CHECKING, ClassVar, TypeAlias

import numpy as np

from elastica_cad._cached_property import cached_property
from elastica_cad._types import FloatArray, IntArray
from elastica_cad.errors import InputError, Length
from elastica_cad.form_finding.constraints import thin_rows
from elastica_cad.form_finding.limits import Symmetry
from elastica_cad.form_finding.rod_map import MappedRod, Sensitivities
from elastica_cad.form_finding.sqp import LocalModel
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.geometry.plane_points import dot, left_of, norm, unit, unit_vectors
from elastica_cad.geometry.splines import spline_through

if TYPE_CHECKING:
    from scipy.interpolate import CubicHermiteSpline


# number of intervals of the interpolated curve, for an interpolation error of 1e-9 of the curve's length
SPANS = 1000
# weight of the mean squared distance in the model of the largest distance
_MEAN_SHARE = 0.2


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

    def at(self, s: FloatArray) -> FloatArray:
        """Return the positions (n, 2) at arc lengths s (n,) in 0..1."""
        return np.asarray(self._spline(s))

    def angles(self, s: FloatArray) -> FloatArray:
        """Return the tangent angles (n,), rad, at s (n,): arc lengths divided by the length of the target."""
        return np.interp(s, even_steps(self.angle.size), self.angle)

    @cached_property
    def _spline(self) -> "CubicHermiteSpline":
        from scipy.interpolate import CubicHermiteSpline

        return CubicHermiteSpline(even_steps(self.angle.size), self.position, unit_vectors(self.angle))

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
    power: ClassVar[int] = 2

    def value(self, rod: MappedRod) -> float:
        """Return half the weighted mean of the squared distances."""
        off = rod.position - self.targets
        return 0.5 * float(self.shares @ dot(off, off))

    def model(self, rod: MappedRod, sensitivities: Sensitivities) -> LocalModel:
        """Return a Gauss-Newton model, which is exact for positions linear in the unknowns.

        The last column of the sensitivities is the change that brings the rod into equilibrium.
        """
        J = sensitivities.position.reshape(-1, sensitivities.position.shape[2])
        p, roots = J.shape[1] - 1, np.sqrt(self.shares.repeat(2))
        A = J * roots[:, None]
        A[:, -1] += (rod.position - self.targets).ravel() * roots
        product = A.T @ A
        none = np.zeros(0)
        return LocalModel(
            0.5 * float(product[p, p]),
            product[:p, :p],
            product[:p, p],
            none,
            np.zeros((0, p)),
            none.astype(int),
        )


@dataclass(frozen=True, eq=False)
class LargestDistance:
    """Largest weighted distance of a node from the target, or of a target point from the rod.

    Attributes
    ----------
    factors : (n+1,) array
        Weights of the nodes, of which the largest is 1.
    """

    target: TargetCurve
    factors: FloatArray
    power: ClassVar[int] = 1

    def value(self, rod: MappedRod) -> float:
        """Return the largest weighted distance between rod and target."""
        return float(norm(self._gaps(rod)[3]).max())

    def model(self, rod: MappedRod, sensitivities: Sensitivities) -> LocalModel:
        """Return a local model of the largest weighted distance."""
        i, j, w, gaps = self._gaps(rod)
        size, p, d = norm(gaps), rod.z.size, sensitivities.position
        # nearer points are unlikely to be the farthest after a step
        far = thin_rows(np.flatnonzero(size >= 0.5 * size.max()), size)
        i, j, w = i[far], j[far], w[far, None, None]
        along = (self.factors[i, None] * unit(gaps[far]))[:, None] @ ((1 - w) * d[i] + w * d[j])
        rows = along[:, 0]
        # add a fraction of the mean square, so that the best step is unique and not too long
        J = d[..., :p].reshape(-1, p)
        hessian = _MEAN_SHARE / (len(d) * max(float(size.max()), 1e-9)) * J.T @ J
        return LocalModel(0.0, hessian, np.zeros(p), size[far] + rows[:, p], rows[:, :p], -1 - far)

    def _gaps(self, rod: MappedRod) -> tuple[IntArray, IntArray, FloatArray, FloatArray]:
        """Return the weighted gaps (2n+2, 2) of rod points from the target.

        The rod points are the nodes and the points nearest to points of the target. Each is between two nodes, at
        (1 - w) position[i] + w position[j].
        """
        nodes = np.arange(len(rod.position))
        _, _, off = _feet(rod.position, self.target.position)
        k, w, back = _feet(self.target.at(even_steps(nodes.size)), rod.position)
        i = np.append(nodes, k)
        gaps = self.factors[i, None] * np.concatenate([off, -back])
        return i, np.append(nodes, k + 1), np.append(np.zeros(nodes.size), w), gaps


Distance: TypeAlias = MeanDistance | LargestDistance
"""Distance of a rod from the target; `value` is the distance to the power of `power`, divided by `power`."""


def measure_deviation(target: TargetCurve, points: FloatArray) -> float:
    """Return the largest distance, mm, between the target and a smooth curve through `points` (n, 2), mm."""
    nodes = (points - target.origin) / target.size
    other = spline_through(even_steps(len(nodes)), nodes, 3)(even_steps(len(target.position)))
    pairs = (target.position, other), (other, target.position)
    return target.size * max(float(norm(_feet(*pair)[2]).max()) for pair in pairs)


def _feet(points: FloatArray, chain: FloatArray) -> tuple[IntArray, FloatArray, FloatArray]:
    """Return the nearest points of a polyline (c+1, 2) to `points` (m, 2).

    Each point is compared with the two sides beside its nearest vertex. The result is the sides (m,), the places on
    them (m,) from 0 to 1, and the offsets (m, 2) from there to the points.
    """
    from scipy.spatial import cKDTree

    chords, rows = np.diff(chain, axis=0), np.arange(len(points))
    squares = np.maximum(dot(chords, chords), 1e-300)
    _, nearest = cKDTree(chain).query(points)
    sides = np.stack([np.maximum(nearest - 1, 0), np.minimum(nearest, len(chords) - 1)])
    off = points - chain[sides]
    w = np.clip(dot(off, chords[sides]) / squares[sides], 0, 1)
    off = off - w[..., None] * chords[sides]
    best = norm(off).argmin(axis=0)
    return sides[best, rows], w[best, rows], off[best, rows]
