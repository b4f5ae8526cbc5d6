"""From edges drawn in space to the plane they lie in."""

from collections.abc import Sequence

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.errors import InputError
from elastica_cad.formats.curve_files.edges import Edge, Run


def flatten_run(run: Sequence[Edge], tolerance: float) -> Run:
    """The run of edges (m, 3) in the coordinates of its own plane (m, 2).

    In a plane z = const x and y are kept as drawn. Any other plane is looked at from the side from which its
    horizontal direction runs towards positive x (or y), with y up: x along the plane's horizontal line, y
    along its steepest line, both measured from the origin of space.

    Raises
    ------
    InputError
        When the edges lie farther than `tolerance` mm off a common plane; it says how far.
    """
    points = np.concatenate([edge.at(edge.stations()) for edge in run])
    axes = plane_axes(points, tolerance)
    return tuple(edge.mapped(axes, (0.0, 0.0)) for edge in run)


def plane_axes(points: FloatArray, tolerance: float) -> FloatArray:
    """Horizontal and upward unit vectors (2, 3) of the plane through the points."""
    if np.ptp(points[:, 2]) <= tolerance:
        return np.eye(2, 3)
    centred = points - points.mean(axis=0)
    _, sizes, directions = np.linalg.svd(centred, full_matrices=False)
    normal = directions[-1]
    if len(sizes) < 3 or sizes[1] <= 1e-9 * sizes[0]:  # points in line: of all their planes the upright one
        normal = np.cross(directions[0], (0.0, 0.0, 1.0))
        if np.linalg.norm(normal) < 1e-9:
            normal = np.array([0.0, 1.0, 0.0])
    normal = normal / np.linalg.norm(normal)
    off = float(np.abs(centred @ normal).max())
    if off > tolerance:
        raise InputError(
            f"a curve leaves its plane by {off:.3g} mm (its z runs over {np.ptp(points[:, 2]):.4g} mm): "
            "a strip bends in one plane only; project the curve onto a plane first"
        )
    up = np.array([0.0, 0.0, 1.0])
    y_axis = up - (up @ normal) * normal
    y_axis = y_axis / np.linalg.norm(y_axis)
    x_axis = np.cross(y_axis, normal)
    x_axis = x_axis * np.sign(x_axis[np.abs(x_axis).argmax()])
    return np.array([x_axis, y_axis])
