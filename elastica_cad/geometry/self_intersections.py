"""Self-intersections of a curve, and angles of the directions from a point of the curve to its other points."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.geometry.nurbs_curve import (
    NurbsCurve,
    cut_into_tangent_cones,
    hodograph,
    tabulate_tangent_angle,
)
from elastica_cad.geometry.plane_points import box_about, boxes_meet, dot, norm, project, unit
from elastica_cad.geometry.polynomials import (
    binomials,
    divide_out_end_root,
    interior_roots,
    product,
    scaled_bernstein,
    subdivide_pieces,
    sums_in_pieces,
)

_MOST_HALVINGS = 40
"""Largest number of halvings of a piece, which is then as short as rounding errors."""

_MOST_PAIRS = 1000
"""Largest number of pairs of pieces that may meet.

If there are more, parts of the curve overlap, and only evenly selected pairs, a tenth of this number, are used.
"""


def find_self_intersections(
    bezier: FloatArray, edges: FloatArray, motion: Callable[[FloatArray], Sequence[FloatArray]]
) -> FloatArray:
    """Return the pairs of parameters (k, 2), the smaller one first, at which a curve meets itself.

    The curve consists of homogeneous Bezier pieces (p, degree + 1, 3). Pieces are halved while their boxes overlap.
    If all velocities of two neighbouring pieces are in a common half plane, the pieces meet only at their joint.
    Such neighbours are not compared, so joints are not reported as self-intersections.

    Parameters
    ----------
    edges : (p + 1,) array
        Parameters of the ends of the p pieces.
    motion : callable
        Function of parameters (n,) that returns positions and velocities d/dt, (n, 2) each.
    """
    # smaller pieces are starts for Newton's method
    small = 1e-4 * float(np.ptp(project(bezier), axis=(0, 1)).max())
    # parts of pieces with their parameters from `low` to `high`, and indices of pairs of parts that may meet
    part, low, high = bezier, edges[:-1], edges[1:]
    first, second = np.triu_indices(low.size)
    guesses: list[FloatArray] = []
    for _ in range(_MOST_HALVINGS):
        box = box_about(project(part))
        overlap = boxes_meet(box[first], box[second])
        first, second = first[overlap], second[overlap]
        joined = high[first] >= low[second]
        onward = np.zeros(first.size, dtype=bool)
        along = unit(hodograph(part))
        both = np.concatenate([along[first[joined]], along[second[joined]]], axis=1)
        # neighbours whose velocities are in a common half plane meet only at their joint
        onward[joined] = (np.einsum("pnk,pk->pn", both, both.sum(axis=1)) > 0).all(axis=1)
        first, second = first[~onward], second[~onward]
        size = (box[:, 1] - box[:, 0]).max(axis=1)
        tiny = np.maximum(size[first], size[second]) < small
        if first.size > _MOST_PAIRS:
            thinned = np.linspace(0, first.size - 1, _MOST_PAIRS // 10).astype(int)
            first, second, tiny = first[thinned], second[thinned], np.ones(thinned.size, dtype=bool)
        middle = (low + high) / 2
        guesses.append(np.column_stack([middle[first], middle[second]])[tiny])
        first, second = first[~tiny], second[~tiny]
        if not first.size:
            break
        # halve the parts that are in a pair
        used, index = np.unique(np.concatenate([first, second]), return_inverse=True)
        first, second = index[: first.size], index[first.size :]
        halves = np.stack(subdivide_pieces(part[used]), axis=1).reshape(-1, *part.shape[1:])
        middle = (low[used] + high[used]) / 2
        low = np.stack([low[used], middle], axis=1).ravel()
        high = np.stack([middle, high[used]], axis=1).ravel()
        # the halves of part i are 2 i and 2 i + 1; each pair gives four pairs of halves, equal parts only three
        a = (2 * first[:, None] + np.array([0, 0, 1, 1])).ravel()
        b = (2 * second[:, None] + np.array([0, 1, 0, 1])).ravel()
        part, first, second = halves, a[a <= b], b[a <= b]
    return _distinct(_polished(np.concatenate(guesses), motion, edges, small), edges)


def _polished(
    pairs: FloatArray,
    motion: Callable[[FloatArray], Sequence[FloatArray]],
    edges: FloatArray,
    small: float,
) -> FloatArray:
    """Improve pairs (t1, t2) with gamma(t1) = gamma(t2) by Newton's method; omit pairs without convergence."""
    start = pairs
    for _ in range(12):
        if not pairs.size:
            return pairs
        p, v = motion(pairs.T.ravel())
        n = len(pairs)
        gap, v1, v2 = p[n:] - p[:n], v[:n], v[n:]
        # a small damping of the least squares problem avoids division by zero where the parts touch
        a11, a12, a22 = dot(v1, v1), -dot(v1, v2), dot(v2, v2)
        r1, r2 = dot(v1, gap), -dot(v2, gap)
        determinant = a11 * a22 - a12**2 + 1e-14 * a11 * a22
        step = np.column_stack([a22 * r1 - a12 * r2, a11 * r2 - a12 * r1]) / determinant[:, None]
        pairs = (pairs + step).clip(edges[0], edges[-1])
    p, v = motion(pairs.T.ravel())
    n = len(pairs)
    met = norm(p[n:] - p[:n]) <= 1e-5 * small
    speed = norm(v)
    # refuse pairs that Newton's method moved far from their parts, or to one and the same point
    moved = (np.abs(pairs - start) * np.column_stack([speed[:n], speed[n:]])).max(axis=1)
    apart = (pairs[:, 1] - pairs[:, 0]) * np.minimum(speed[:n], speed[n:])
    return np.asarray(pairs[met & (moved <= 10 * small) & (apart > 1e-3 * small)])


def _distinct(pairs: FloatArray, edges: FloatArray) -> FloatArray:
    """Return each self-intersection once, in order, without the two ends of a closed curve."""
    close = 1e-7 * (edges[-1] - edges[0])
    distinct: list[FloatArray] = []
    for pair in pairs[np.lexsort(pairs.T[::-1])]:
        ends = pair[0] - edges[0] < close and edges[-1] - pair[1] < close
        if not ends and all(np.abs(pair - other).max() > close for other in distinct):
            distinct.append(pair)
    return np.array(distinct).reshape(-1, 2)


# a parameter closer to a knot than this fraction of the knot span is at the knot
_AT_KNOT_SHARE = 1e-9


@dataclass(frozen=True)
class ViewAngles:
    """Smallest and largest angle of the directions from a point to a curve, continuous along the curve.

    Attributes
    ----------
    point : (float, float)
        Point from which the directions are measured, mm.
    low, high : float
        Smallest and largest angle, rad; their difference may exceed a full turn.
    low_t, high_t : float
        Parameters of the points of the curve in these directions.
    """

    point: tuple[float, float]
    low: float
    high: float
    low_t: float
    high_t: float


def find_view_angles(curve: NurbsCurve, t: float) -> ViewAngles | None:
    """Return the range of the angles of the directions from the point at t to the other points of the curve.

    Directions to points before t are reversed, and the direction at t is the tangent. The angle is therefore
    continuous along the curve. The result is None if the curve passes through the point at t again.
    """
    views, edges, point = _views(curve, t)
    cones = cut_into_tangent_cones(views, edges)
    if cones.standstill is not None:
        return None
    across = views.transpose(2, 0, 1)
    # the angle is extreme where the determinant of direction and its derivative is 0, at joints or at the ends
    first, second = product(across, (across[..., 1:] - across[..., :-1])[::-1])
    roots = interior_roots(first - second)
    piece = np.array([*range(len(views)), len(views) - 1, *(root.piece for root in roots)])
    u = np.array([0.0] * len(views) + [1.0] + [root.u for root in roots])
    places = edges[piece] + u * (edges[piece + 1] - edges[piece])
    degree = views.shape[1] - 1
    direction = sums_in_pieces(scaled_bernstein(degree, u), views * binomials(degree)[:, None], piece)
    angle = tabulate_tangent_angle(cones).at(places, direction)
    low, high = angle.argmin(), angle.argmax()
    return ViewAngles(point, float(angle[low]), float(angle[high]), float(places[low]), float(places[high]))


def _views(curve: NurbsCurve, t: float) -> tuple[FloatArray, FloatArray, tuple[float, float]]:
    """Return Bezier pieces (k, n, 2) of the directions between the point p at t and all other points.

    The direction to a point q is q - p after t and p - q before t, so it does not jump at p. A piece that ends
    at p, with parameter u, has a factor u or 1 - u, which is divided out. Also return the edges (k + 1,) of the
    pieces, and p.
    """
    edges, bezier = curve.bezier_table
    at = int(edges[1:-1].searchsorted(t, side="right"))
    u = (t - edges[at]) / (edges[at + 1] - edges[at])
    if u > 1 - _AT_KNOT_SHARE:
        at += 1
    elif u > _AT_KNOT_SHARE:
        bezier = np.concatenate([bezier[:at], subdivide_pieces(bezier[at], u), bezier[at + 1 :]])
        at += 1
        edges = np.concatenate([edges[:at], [t], edges[at:]])
    x, y, w = (bezier[at, 0] if at < len(bezier) else bezier[-1, -1]).tolist()
    views = bezier[..., :2] - bezier[..., 2:] * np.array([x, y]) / w
    views[:at] *= -1
    if at:
        views[at - 1] = divide_out_end_root(views[at - 1].T, at_end=True).T
    if at < len(views):
        views[at] = divide_out_end_root(views[at].T, at_end=False).T
    return views, edges, (x / w, y / w)
