"""Bricks of twenty nodes on a flat mesh: one through the thickness of each sheet, glued where sheets share a face.

A brick with reduced integration (C3D20R) bends exactly: the displacement is quadratic through the thickness, so
a strip may curl across (anticlastic), and two points through the thickness integrate z^2. It does not lock where
thin. Shells of CalculiX are expanded to the same bricks.
"""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from tests.campaign.finite_elements.flat_mesh import FlatMesh

__all__ = ["Bricks", "extrude"]


@dataclass(frozen=True, eq=False)
class Bricks:
    """A flat body of bricks.

    Attributes
    ----------
    nodes : (n, 3) array
        mm, flat; z = 0 is the surface that takes the drawn curve.
    bricks : (m, 20) int array
        In the order of CalculiX.
    layer : (m,) int array
        The sheet of each brick, 0 for the base.
    flat : FlatMesh
    """

    nodes: np.ndarray
    bricks: np.ndarray
    layer: np.ndarray
    flat: FlatMesh


def extrude(flat: FlatMesh, levels: Sequence[float]) -> Bricks:
    """Bricks between the faces of the sheets.

    Parameters
    ----------
    levels : sequence of float
        z of the faces, mm, upward: of one sheet its two, of two glued sheets three.
    """
    faces = np.asarray(levels, dtype=float)
    z = np.empty(2 * faces.size - 1)
    z[::2], z[1::2] = faces, (faces[:-1] + faces[1:]) / 2
    number = len(flat.nodes) * np.arange(z.size)[:, None] + np.arange(len(flat.nodes))
    bricks, layer = [], []
    for i in range(faces.size - 1):
        quads = flat.quads[flat.layers > i]
        corners, middles = quads[:, :4], quads[:, 4:]
        low, half, high = number[2 * i : 2 * i + 3]
        bricks.append(np.hstack([low[corners], high[corners], low[middles], high[middles], half[corners]]))
        layer.append(np.full(len(quads), i))
    used, rows = np.unique(np.concatenate(bricks), return_inverse=True)
    which, plane = np.divmod(used, len(flat.nodes))
    nodes = np.column_stack([flat.nodes[plane], z[which]])
    return Bricks(nodes, rows.reshape(-1, 20), np.concatenate(layer), flat)
