"""How wide a slot must be for the other strip, whose faces and own faces are bent."""

from itertools import product

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad.fabrication.interlocking.ruled_strip import RuledStrip

MOST_STEPS = 30
"""Of Newton's method with the slopes at the centre line: each leaves what a strip turns over a slot's width."""

CLOSE_MM = 1e-6
"""The faces meet there: what files keep."""


def bent_slot_width(
    own: RuledStrip, other: RuledStrip, rows: FloatArray, mates: FloatArray, *, thickness: tuple[float, float]
) -> FloatArray:
    """Widths (n,), mm, that let the faces of another strip through those of this one, half to either side.

    Where flat sheets meet it is `slot_width` without clearance. Bent ones fall away from each other to the sides of
    the line on which their middles meet, by (w / 2)^2 kappa / 2, and shift what goes through by cot(phi) of that.

    Parameters
    ----------
    own, other : RuledStrip
    rows, mates : (n, 2) array
        The centre line of the slot in both flat patterns, mm.
    thickness : (own, other)
        mm.

    Returns
    -------
    (n,) array
        0 where the faces do not meet: strips that bend away from each other beside a shallow crossing.
    """
    along = np.gradient(rows, np.arange(len(rows)), axis=0, edge_order=2)
    along /= np.hypot(*along.T)[:, None]
    across = np.column_stack([-along[:, 1], along[:, 0]])
    ways = across[:, :1] * own.motion(rows[:, 0])[1] + across[:, 1:] * own.axis
    tangents = other.motion(mates[:, 0])[1]
    slopes = np.stack([ways, -tangents, -np.broadcast_to(other.axis, tangents.shape)], axis=2)
    inverse, rows, mates, across = (
        np.tile(one, (4, *[1] * (one.ndim - 1))) for one in (np.linalg.inv(slopes), rows, mates, across)
    )
    z = np.repeat(list(product((-0.5, 0.5), repeat=2)), len(along), axis=0) * thickness
    x = np.zeros((len(rows), 3))  # across the slot, and along and across the other strip
    error = np.full(len(rows), np.inf)
    farthest = own.length + other.length  # where faces do not meet, steps would grow beyond all numbers
    for _ in range(MOST_STEPS):
        here = _on_face(own, rows + x[:, :1] * across, z[:, :1])
        there = _on_face(other, mates + x[:, 1:], z[:, 1:])
        error = np.abs(here - there).max(axis=1)
        if not (error > CLOSE_MM).any():
            break
        x -= (inverse @ (here - there)[:, :, None])[:, :, 0]
        np.clip(x, -farthest, farthest, out=x)
    reach = np.where(error <= CLOSE_MM, np.abs(x[:, 0]), 0.0)
    return np.asarray(2 * reach.reshape(4, -1).max(axis=0), dtype=float)


def _on_face(strip: RuledStrip, flat: FloatArray, height: FloatArray) -> FloatArray:
    """Points (n, 3) at heights (n, 1) to the left of the curve over flat places (n, 2)."""
    points, tangents = strip.in_plane(flat[:, 0])
    left = np.column_stack([-tangents[:, 1], tangents[:, 0]])
    return strip.frame.point(points + height * left) + flat[:, 1:] * strip.axis
