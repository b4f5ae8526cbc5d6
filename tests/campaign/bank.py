"""Thirty curves and five styles of strips: the bank of problems that every kernel is asked."""

from collections.abc import Callable, Mapping

import numpy as np

from elastica_cad import Hole, Laminated, Perforated, PlaneCurve, Sheet, Slot, Strip, Tab, optimal_rod
from elastica_cad.geometry import Arc

__all__ = ["CURVES", "SHEET", "STYLES", "made"]

SHEET = Sheet.named("birch-plywood-0.8")


def _through(*points: tuple[float, float], ends: tuple[float, float] | None = None) -> PlaneCurve:
    """The cubic spline through points, as CAD programs draw it; `ends` are end angles in degrees."""
    from scipy.interpolate import make_interp_spline

    rows = np.array(points, dtype=float)
    t = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(rows, axis=0), axis=1))])
    kinds = None
    if ends is not None:
        turn = np.radians(ends)
        kinds = tuple([(1, np.array([np.cos(a), np.sin(a)]))] for a in turn)
    spline = make_interp_spline(t, rows, k=3, bc_type=kinds)
    return PlaneCurve(spline.t, spline.c, 3)


def _arcs(*turns: tuple[float, float]) -> PlaneCurve:
    """Tangent arcs of (radius, degrees) one after the other, as a drawing has them."""
    at, angle, knots, points, weights = np.zeros(2), 1.2, [0.0, 0.0, 0.0], [np.zeros(2)], [1.0]
    for radius, degrees in turns:
        sweep = np.radians(degrees)
        center = at + radius * np.array([np.sin(angle), -np.cos(angle)])
        pieces = int(np.ceil(sweep / (np.pi / 2)))
        for _ in range(pieces):
            first = angle + np.pi / 2
            arc = Arc(center, radius, first, first - sweep / pieces).as_spline().curve
            assert arc.weights is not None
            points += list(arc.control_points[1:])
            weights += list(arc.weights[1:] / arc.weights[0] * weights[-1])
            knots += [knots[-1] + 1.0] * 2
            angle -= sweep / pieces
            at = arc.control_points[-1]
    return PlaneCurve(np.array([*knots, knots[-1]]), np.array(points), 2, np.array(weights))


def _fitted(
    function: Callable[[np.ndarray], np.ndarray], first: float, last: float, degree: int
) -> PlaneCurve:
    return PlaneCurve.fit(function(np.linspace(first, last, 240)), degree=degree, tolerance=2e-3)


def _wave(x: np.ndarray) -> np.ndarray:
    return np.column_stack([60 * x, 25 * np.sin(x)])


def _spiral(t: np.ndarray) -> np.ndarray:
    r = 20 + 6 * t
    return np.column_stack([r * np.cos(t), r * np.sin(t)])


CURVES: Mapping[str, PlaneCurve] = {
    "arch": PlaneCurve.spline([(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)], degree=4),
    "cubic arch": PlaneCurve.spline([(0, 0), (20, 50), (60, 70), (110, 60), (140, 20), (150, 0)], degree=3),
    "S": PlaneCurve.spline([(0, 0), (50, 60), (100, 10), (150, -40), (200, 20)], degree=4),
    "circle": PlaneCurve.arc((10, 20), 60, 0.3, 3.1),
    "short arc": PlaneCurve.arc((0, 0), 200, 1.3, 1.8),
    "long arc": PlaneCurve.arc((0, 0), 50, 0.0, 4.9),
    "ellipse": PlaneCurve.ellipse((0, 0), (90, 50), 0.4, 0.2, 2.0),
    "half ellipse": PlaneCurve.ellipse((0, 0), (120, 60), 0.0, 0.0, np.pi),
    "tall ellipse": PlaneCurve.ellipse((5, 3), (60, 120), 0.3, 0.3, 2.5),
    "spiral": _fitted(_spiral, 0.0, 2.5 * np.pi, 4),
    "wave, one inflection": _fitted(_wave, -2.0, 1.7, 5),
    "wave, two inflections": _fitted(_wave, -0.9, np.pi + 0.7, 5),
    "wave, three inflections": _fitted(_wave, -1.0, 2 * np.pi + 0.8, 5),
    "drawn through three points": _through((0, 0), (95, 65), (210, 0), ends=(np.degrees(np.arctan2(1, 0.7)), -45)),
    "drawn through four points": _through((0, 0), (40, 40), (90, 50), (140, 0)),
    "drawn through five points": _through((0, 0), (35, 55), (95, 75), (155, 55), (190, 0)),
    "drawn through six points": _through((0, 0), (15, 40), (60, 75), (120, 80), (175, 45), (200, 0)),
    "drawn with end tangents": _through((0, 0), (60, 40), (140, 45), (220, 0), ends=(60.0, -70.0)),
    "two arcs": _arcs((50, 60), (90, 50)),
    "three arcs": _arcs((40, 50), (80, 60), (30, 40)),
    "oval of arcs": _arcs((30, 70), (100, 40), (30, 70)),
    "Bezier arch": PlaneCurve.spline([(0, 0), (40, 100), (130, 190), (220, 100), (260, 0)], degree=4),
    "cubic Bezier": PlaneCurve.spline([(0, 0), (20, 80), (140, 80), (160, 0)], degree=3),
    "cubic S": PlaneCurve.spline([(0, 0), (60, 70), (100, -70), (160, 0)], degree=3),
    "quadratic": PlaneCurve.spline([(0, 0), (60, 90), (140, 0)], degree=2),
    "parabola pieces": PlaneCurve.spline([(0, 0), (30, 50), (90, 70), (150, 40), (170, 0)], degree=2),
    "quintic": PlaneCurve.spline([(0, 0), (10, 50), (50, 90), (110, 85), (160, 50), (180, 0)], degree=5),
    "tight bend": PlaneCurve.spline([(0, 0), (70, 5), (80, 40), (75, 75), (0, 80)], degree=4),
    "hook": PlaneCurve.spline([(0, 0), (80, 0), (120, 40), (90, 90), (50, 70)], degree=3),
    "gentle": PlaneCurve.spline([(0, 0), (80, 12), (160, 16), (240, 10), (320, 0)], degree=4),
}  # fmt: skip

ENDS = (Tab(10.0), Tab(10.0))
HELD = (
    Tab(12.0, holes=(Hole(6, 3.2),)),
    Tab(14.0, width=18.0, corner_radius=3.0, holes=(Hole(5, 2, -3), Hole(8, 2, 3))),
)
HOLED = Perforated(width=30.0, columns=1, rows=2, least_ligament=0.2, least_hole=0.2)
BACKED = Laminated(width=24.0, backing=SHEET, least_backing=0.2)


def _slots(length: float) -> tuple[Slot, ...]:
    return Slot(0.35 * length, width=1.0, depth=4.0), Slot(0.7 * length, width=1.2, depth=3.0, side="lower")


STYLES: Mapping[str, Callable[[PlaneCurve], Strip]] = {
    "plain": lambda curve: Strip(optimal_rod(curve), SHEET, max_width=30.0, ends=ENDS),
    "held": lambda curve: Strip(optimal_rod(curve), SHEET, max_width=30.0, ends=HELD),
    "slotted": lambda curve: Strip(
        optimal_rod(curve), SHEET, max_width=30.0, ends=ENDS, slots=_slots(curve.length)
    ),
    "perforated": lambda curve: Strip(optimal_rod(curve), SHEET, style=HOLED, ends=ENDS),
    "laminated": lambda curve: Strip(optimal_rod(curve), SHEET, style=BACKED, ends=ENDS),
}


def made(curve: str, style: str) -> Strip:
    """The strip of a curve in a style."""
    return STYLES[style](CURVES[curve])
