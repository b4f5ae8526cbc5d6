"""Bodies made of prisms: some are put together, others taken away."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from elastica_cad._types import FloatArray
from elastica_cad._values import several
from elastica_cad.errors import InputError
from elastica_cad.fabrication.solids.strip_solids import FlatSolid
from elastica_cad.geometry.frame import Frame

FLAT_SHARE = 1e-15
"""Of the squared size of a polygon, the area by which a corner must stand out of it: rounding."""


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

    Points that lie on its sides but for rounding are none. (Andrew's monotone chain, 1979; scipy's hull takes a
    seventh of a second to be loaded.)

    Examples
    --------
    >>> convex_corners(np.array([[0.0, 0.0], [1.0, 0.5], [2.0, 0.0], [1.0, 0.0], [1.0, 2.0]])).tolist()
    [[0.0, 0.0], [2.0, 0.0], [1.0, 2.0]]
    """
    places = sorted(set(zip(*np.asarray(points, dtype=float).T.tolist(), strict=True)))
    least = FLAT_SHARE * float(np.ptp(points, axis=0).max()) ** 2
    lower, upper = _right_turns_cut(places, least), _right_turns_cut(places[::-1], least)
    return np.array([*lower[:-1], *upper[:-1]], dtype=float)


def _right_turns_cut(places: Sequence[tuple[float, float]], least: float) -> list[tuple[float, float]]:
    """The chain from the first to the last of sorted places that turns to the left alone."""
    chain: list[tuple[float, float]] = []
    for x, y in places:
        while len(chain) > 1:
            (a, b), (c, d) = chain[-2:]
            if (c - a) * (y - b) - (d - b) * (x - a) > least:
                break
            chain.pop()
        chain.append((x, y))
    return chain
