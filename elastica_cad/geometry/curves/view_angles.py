"""The angle under which a curve is seen from one of its own points."""

from dataclasses import dataclass

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.curves.tangent_angle import cut_into_tangent_cones, tabulate_tangent_angle
from elastica_cad.geometry.polynomials.bernstein import (
    binomials,
    divide_out_end_root,
    interior_roots,
    product,
    subdivide,
    sums_in_pieces,
)

_AT_KNOT_SHARE = 1e-9  # of a span


@dataclass(frozen=True)
class ViewAngles:
    """Smallest and largest angle (rad), continued along the curve, of the directions towards it.

    Attributes
    ----------
    point : (float, float)
        Where it is seen from, mm.
    low, high : float
        rad; high - low may exceed a full turn.
    low_t, high_t : float
        The parameters where the curve is seen under these angles.
    """

    point: tuple[float, float]
    low: float
    high: float
    low_t: float
    high_t: float


def find_view_angles(curve: PlaneCurve, t: float) -> ViewAngles | None:
    """The directions gamma - p in which the point p at t sees the curve, those to what lies before p reversed.

    The direction at p itself is the tangent, so that the angle is continuous along the curve. None when the
    curve passes p again.
    """
    views, edges, point = _views(curve, t)
    cones = cut_into_tangent_cones(views, edges)
    if cones.standstill is not None:
        return None
    across = views.transpose(2, 0, 1)
    first, second = product(across, (across[..., 1:] - across[..., :-1])[::-1])
    turn = first - second
    roots = interior_roots(turn)
    piece = np.array([*range(len(views)), len(views) - 1, *(root.piece for root in roots)])
    u = np.array([0.0] * len(views) + [1.0] + [root.u for root in roots])
    places = edges[piece] + u * (edges[piece + 1] - edges[piece])
    direction = sums_in_pieces(views * binomials(views.shape[1] - 1)[:, None], piece, u)
    angle = tabulate_tangent_angle(cones).at(places, direction)
    low, high = int(angle.argmin()), int(angle.argmax())
    return ViewAngles(point, float(angle[low]), float(angle[high]), float(places[low]), float(places[high]))


def _views(curve: PlaneCurve, t: float) -> tuple[FloatArray, FloatArray, tuple[float, float]]:
    """Pieces (k, n, 2) along gamma - p (reversed before p), no longer zero at p, their edges (k + 1,), and p."""
    edges, bezier = curve.bezier_table
    at = int(np.searchsorted(edges[1:-1], t, side="right"))
    u = (t - edges[at]) / (edges[at + 1] - edges[at])
    if u > 1 - _AT_KNOT_SHARE:
        at += 1
    elif u > _AT_KNOT_SHARE:
        left, right = subdivide(bezier[at].T, u)
        bezier = np.concatenate([bezier[:at], [left.T, right.T], bezier[at + 1 :]])
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
