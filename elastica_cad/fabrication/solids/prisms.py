"""Bodies made of prisms: some are put together, others taken away."""

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import several
from elastica_cad.errors import InputError
from elastica_cad.fabrication.solids.strip_solids import FlatSolid
from elastica_cad.geometry.frame import Frame


@dataclass(frozen=True, eq=False)
class PrismSolid:
    """The union of the prisms `added`, less the prisms `removed`.

    Attributes
    ----------
    added, removed : tuple of FlatSolid
        Closed outlines with holes and thickness, each in its own frame.
    joints : mapping of str to Frame
        Places to join other parts to.

    Raises
    ------
    InputError
        Nothing added.
    """

    added: tuple[FlatSolid, ...]
    removed: tuple[FlatSolid, ...] = ()
    joints: Mapping[str, Frame] = field(default_factory=dict)

    def __post_init__(self) -> None:
        for name in ("added", "removed"):
            found = several(f"the {name} prisms", getattr(self, name), FlatSolid, "FlatSolid")
            object.__setattr__(self, name, found)
        if not self.added:
            raise InputError("a body of prisms needs at least one prism")


def convex_corners(points: FloatArray) -> FloatArray:
    """Corners (n, 2), anticlockwise from the leftmost, of the least convex polygon around points (m, 2) of an area.

    Examples
    --------
    >>> convex_corners(np.array([[0.0, 0.0], [1.0, 0.5], [2.0, 0.0], [1.0, 0.0], [1.0, 2.0]])).tolist()
    [[0.0, 0.0], [2.0, 0.0], [1.0, 2.0]]
    """
    from scipy.spatial import ConvexHull

    corners = np.asarray(points, dtype=float)[ConvexHull(points).vertices]
    return np.roll(corners, -int(np.lexsort(corners.T[::-1])[0]), axis=0)
