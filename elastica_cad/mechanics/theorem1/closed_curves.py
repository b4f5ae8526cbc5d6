"""Closed curves: how they turn where they close, and the same curve begun at another place."""

import numpy as np

from elastica_cad.errors import InputError
from elastica_cad.geometry.curves.plane_curve import PlaneCurve, clamp_ends, trim_curve

PLACES = 721
"""Places along a curve that may be its flattest."""

CLEAR_SHARE = 0.05
"""Of the largest curvature: places that are bent less lie too near to an inflection to begin there."""

PLACE_DIGITS = 6
"""Of a place, mm: the same curve of two programs begins at the same one."""

ALIKE = 1e-6
"""Share of the largest curvature by which two places differ that are flat alike, and of its range by which a
parameter differs from a knot: rounding and a little."""


def begin_at(curve: PlaneCurve, s: float) -> PlaneCurve:
    """The closed curve begun, and ended, at the arc length `s` (mm): exact.

    Raises
    ------
    InputError
        A curve that is open, or a place that lies beyond it.

    Examples
    --------
    >>> circle = PlaneCurve.arc((0, 0), 10, 0, 2 * np.pi)
    >>> begin_at(circle, circle.length / 4).at([0.0]).position.round(6).tolist()
    [[0.0, 10.0]]
    """
    if not curve.is_closed:
        raise InputError("the curve is open: only a closed one can begin anywhere")
    if not 0 <= s <= curve.length:
        raise InputError(
            f"the curve cannot begin at {s:g} mm: it is {curve.length:.4g} mm long; give a place along it"
        )
    low, high = curve.domain
    t = float(curve.parameter(np.array(s)))
    drawn, curve = curve.provenance, _closed_exactly(curve)
    # a span of rounding size would have no curvature to speak of
    knot = float(curve.knots[np.argmin(np.abs(curve.knots - t))])
    t = knot if abs(knot - t) <= ALIKE * (high - low) else t
    if t <= low or t >= high:
        return curve.drawn_as(drawn)
    first, second = trim_curve(curve, t, high), trim_curve(curve, low, t)
    p = curve.degree
    knots = np.concatenate([first.knots[:-1], second.knots[p + 1 :] + (high - low)])
    points = np.concatenate([first.control_points, second.control_points[1:]])
    weights = None
    if first.weights is not None and second.weights is not None:
        # the weights of one part may be scaled as a whole: those of the second go on where the first's end
        onward = second.weights * (first.weights[-1] / second.weights[0])
        weights = np.concatenate([first.weights, onward[1:]])
    return PlaneCurve(knots, points, p, weights).drawn_as(drawn)


def _closed_exactly(curve: PlaneCurve) -> PlaneCurve:
    """The curve with its last point on its first: programs that drew the same one then begin alike."""
    clamped = clamp_ends(curve)
    points = clamped.control_points
    if np.array_equal(points[0], points[-1]):
        return curve
    return clamped.with_control_points(np.concatenate([points[:-1], points[:1]]))


def flattest_place(curve: PlaneCurve) -> float:
    """Where (mm) a closed curve is bent least, clear of its inflections; its start where that is as flat."""
    nodes = curve.sample(PLACES)
    bent = np.abs(nodes.curvature)
    largest = float(bent.max())
    bent[bent < CLEAR_SHARE * largest] = np.inf
    first = float(nodes.s[np.flatnonzero(bent <= bent.min() + ALIKE * largest)[0]])
    return min(round(first, PLACE_DIGITS), curve.length)
