"""Places where a curve meets itself."""

from collections.abc import Callable

import numpy as np

from elastica_cad._types import BoolArray, FloatArray, IntArray
from elastica_cad.geometry.boxes import boxes_about
from elastica_cad.geometry.curves.tangent_angle import hodograph
from elastica_cad.geometry.polynomials.bernstein import subdivide

_MOST_HALVINGS = 40
"""A piece halved this often is as short as rounding."""

_NEWTON_SHARE = 1e-4  # of the extent: from here Newton steps find the common point
_MOST_PAIRS = 1000  # more are overlapping stretches: a tenth of their points is enough


def find_self_intersections(
    bezier: FloatArray, edges: FloatArray, motion: Callable[[FloatArray], tuple[FloatArray, FloatArray]]
) -> FloatArray:
    """Pairs of parameters (k, 2), first < second, at which homogeneous Bezier pieces (p, degree + 1, 3) meet.

    Pieces are halved while their boxes overlap. Two neighbours, or one piece, whose velocities lie in a
    common half plane run on in one direction and cannot meet again, so that joints are no false alarms.

    Parameters
    ----------
    edges : (p + 1,) array
        Parameters at which the pieces meet.
    motion : callable
        Positions and velocities d/dt, (n, 2) each, at parameters (n,).
    """
    points = bezier[..., :2] / bezier[..., 2:]
    small = _NEWTON_SHARE * float(np.ptp(points, axis=(0, 1)).max())
    part, low, high = bezier, edges[:-1], edges[1:]
    first, second = np.triu_indices(low.size)
    found: list[FloatArray] = []
    for _ in range(_MOST_HALVINGS):
        first, second = _meeting(part, (low, high), first, second)
        size = _sizes(_boxes(part))
        tiny = np.maximum(size[first], size[second]) < small
        if first.size > _MOST_PAIRS:
            thinned = np.linspace(0, first.size - 1, _MOST_PAIRS // 10).astype(int)
            first, second, tiny = first[thinned], second[thinned], np.ones(thinned.size, dtype=bool)
        middle = (low + high) / 2
        found.append(np.column_stack([middle[first], middle[second]])[tiny])
        first, second = first[~tiny], second[~tiny]
        if not first.size:
            break
        part, low, high, first, second = _halved(part, low, high, first, second)
    starts = np.concatenate(found)
    return _distinct(_polished(starts, motion, edges, small), edges)


def _boxes(part: FloatArray) -> FloatArray:
    return boxes_about(part[..., :2] / part[..., 2:])


def _sizes(box: FloatArray) -> FloatArray:
    return np.asarray((box[:, 1] - box[:, 0]).max(axis=1))


def _meeting(
    part: FloatArray, limits: tuple[FloatArray, FloatArray], first: IntArray, second: IntArray
) -> tuple[IntArray, IntArray]:
    """The pairs whose boxes overlap and that do not simply run on in one direction."""
    (low, high), box = limits, _boxes(part)
    overlap = (box[first, 0] <= box[second, 1]).all(axis=1) & (box[second, 0] <= box[first, 1]).all(axis=1)
    first, second = first[overlap], second[overlap]
    joined = high[first] >= low[second]
    onward = np.zeros(first.size, dtype=bool)
    onward[joined] = _one_way(hodograph(part), first[joined], second[joined])
    return first[~onward], second[~onward]


def _one_way(velocity: FloatArray, first: IntArray, second: IntArray) -> BoolArray:
    length = np.linalg.norm(velocity, axis=2, keepdims=True)
    unit = velocity / np.where(length > 0, length, 1.0)
    both = np.concatenate([unit[first], unit[second]], axis=1)
    return np.asarray((np.einsum("pnk,pk->pn", both, both.sum(axis=1)) > 0).all(axis=1))


def _halved(
    part: FloatArray, low: FloatArray, high: FloatArray, first: IntArray, second: IntArray
) -> tuple[FloatArray, FloatArray, FloatArray, IntArray, IntArray]:
    """Halves of the pieces still in question, and all pairs of halves."""
    used, index = np.unique(np.concatenate([first, second]), return_inverse=True)
    first, second = index[: first.size], index[first.size :]
    left, right = subdivide(np.swapaxes(part[used], 1, 2))
    halves = np.swapaxes(np.stack([left, right], axis=1), 2, 3).reshape(-1, *part.shape[1:])
    middle = (low[used] + high[used]) / 2
    low = np.stack([low[used], middle], axis=1).ravel()
    high = np.stack([middle, high[used]], axis=1).ravel()
    a = (2 * first[:, None] + np.array([0, 0, 1, 1])).ravel()
    b = (2 * second[:, None] + np.array([0, 1, 0, 1])).ravel()
    return halves, low, high, a[a <= b], b[a <= b]


def _polished(
    pairs: FloatArray,
    motion: Callable[[FloatArray], tuple[FloatArray, FloatArray]],
    edges: FloatArray,
    small: float,
) -> FloatArray:
    """Common points by Newton steps on gamma(t1) = gamma(t2); pairs that only come near are dropped."""
    start = pairs
    for _ in range(12):
        if not pairs.size:
            return pairs
        p, v = motion(pairs.T.ravel())
        n = len(pairs)
        gap, v1, v2 = p[n:] - p[:n], v[:n], v[n:]
        # least squares with a small damping, so that tangent branches do not divide by zero
        a11, a12, a22 = (v1**2).sum(axis=1), -(v1 * v2).sum(axis=1), (v2**2).sum(axis=1)
        r1, r2 = (v1 * gap).sum(axis=1), -(v2 * gap).sum(axis=1)
        determinant = a11 * a22 - a12**2 + 1e-14 * a11 * a22
        step = np.column_stack([a22 * r1 - a12 * r2, a11 * r2 - a12 * r1]) / determinant[:, None]
        pairs = np.clip(pairs + step, edges[0], edges[-1])
    p, v = motion(pairs.T.ravel())
    n = len(pairs)
    met = np.linalg.norm(p[n:] - p[:n], axis=1) <= 1e-5 * small
    speed = np.linalg.norm(v, axis=1)
    moved = (np.abs(pairs - start) * np.column_stack([speed[:n], speed[n:]])).max(axis=1)
    apart = (pairs[:, 1] - pairs[:, 0]) * np.minimum(speed[:n], speed[n:])
    return np.asarray(pairs[met & (moved <= 10 * small) & (apart > 1e-3 * small)])


def _distinct(pairs: FloatArray, edges: FloatArray) -> FloatArray:
    """Each place once, in order; the two ends of a closed curve are no place where it meets itself."""
    close = 1e-7 * (edges[-1] - edges[0])
    kept: list[FloatArray] = []
    for pair in pairs[np.lexsort(pairs.T[::-1])]:
        ends = pair[0] - edges[0] < close and edges[-1] - pair[1] < close
        if not ends and all(np.abs(pair - other).max() > close for other in kept):
            kept.append(pair)
    return np.array(kept).reshape(-1, 2)
