"""From edges drawn in a CAD model to one plane curve and the plane it lies in."""

from collections.abc import Sequence
from itertools import pairwise

import numpy as np

from elastica_cad.errors import InputError
from elastica_cad.fabrication.boundary import Frame
from elastica_cad.formats.chains import chained, curve_from_run
from elastica_cad.formats.edges import Edge
from elastica_cad.formats.planes import plane_axes
from elastica_cad.geometry import PlaneCurve

__all__ = ["placed_curve", "placed_curves"]

JOIN = 1e-4  # mm: ends of edges that are meant to meet
TANGENT = 1e-3  # rad


def placed_curve(edges: Sequence[Edge]) -> tuple[PlaneCurve, Frame]:
    """The one curve that edges (m, 3) make end to end, and its plane in space.

    The curve runs the way the first edge does. Where the plane is parallel to xy the frame's axes are the
    world's; in every other plane the frame's y axis points up, towards z, as far as it can.

    Raises
    ------
    InputError
        Edges that are not plane, have no length, do not meet or meet at a corner, or that close.
    """
    runs = chained([(edge,) for edge in edges], JOIN)
    if not runs:
        raise InputError("the edge has no length: draw a curve for the strip to follow")
    if len(runs) > 1:
        raise InputError(
            f"the edges make {len(runs)} separate chains: a strip follows one chain of edges that meet "
            "end to end"
        )
    return _placed(runs[0])


def placed_curves(edges: Sequence[Edge]) -> list[tuple[PlaneCurve, Frame]]:
    """Every chain that the edges make, as in `placed_curve`."""
    return [_placed(run) for run in chained([(edge,) for edge in edges], JOIN)]


def _placed(run: Sequence[Edge]) -> tuple[PlaneCurve, Frame]:
    if np.linalg.norm(run[0].start - run[-1].end) <= JOIN:
        raise InputError("the wire is closed: a strip has two ends, so leave an edge out or split the wire")
    for before, after in pairwise(run):
        out, onward = before.points[-1] - before.points[-2], after.points[1] - after.points[0]
        turn = np.arctan2(np.linalg.norm(np.cross(out, onward)), out @ onward)
        if turn > TANGENT:
            x, y, z = before.end
            raise InputError(
                f"edges meet at a corner of {np.degrees(turn):.3g} degrees at ({x:.4g}, {y:.4g}, {z:.4g}) "
                "mm: make them tangent or round the corner"
            )
    frame = _plane_of(run)
    across = frame.axes[:2]
    flat = [edge.mapped(across, -across @ frame.origin) for edge in run]
    return curve_from_run(flat, tolerance=JOIN), frame


def _plane_of(run: Sequence[Edge]) -> Frame:
    points = np.concatenate([edge.points for edge in run])
    if np.ptp(points[:, 2]) > JOIN:
        points = np.concatenate([edge.at(edge.stations()) for edge in run])
    axes = plane_axes(points, max(JOIN, 1e-6 * float(np.ptp(points, axis=0).max())))
    normal = np.cross(*axes)
    return Frame((run[0].start @ normal) * normal, *axes)
