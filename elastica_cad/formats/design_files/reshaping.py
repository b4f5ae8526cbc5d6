"""Four handles that curves are reshaped by: the corners of their box, or any four points."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Annotated, TypeAlias

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad.declared import Asked
from elastica_cad.errors import InputError
from elastica_cad.geometry.boxes import box_around
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.curves.projective_maps import four_point_map
from elastica_cad.refusals import Length

Point: TypeAlias = tuple[float, float]
Handles: TypeAlias = tuple[Point, Point, Point, Point]

_TO = "New place"

CORNERS = ("bottom_left", "bottom_right", "top_right", "top_left")
"""Handles of the box around the drawn curves, by name."""


def _box_around_curves(curves: Sequence[PlaneCurve]) -> FloatArray:
    """Lower left and upper right corner (2, 2) of the box around curves, mm."""
    return box_around(np.array([curve.bounds for curve in curves]))


def map_corners(curves: Sequence[PlaneCurve], places: Mapping[str, ArrayLike]) -> FloatArray:
    """Return the projective map (3, 3) that takes corners of the box around curves to `places`, mm; other corners
    stay.

    Raises
    ------
    InputError
        An unknown corner, a box without height or width, corners that make no map (see `four_point_map`).

    Examples
    --------
    >>> arch = PlaneCurve.arc((0, 0), 50, 0, np.pi)
    >>> leaning = arch.transformed(map_corners([arch], {"top_right": (70, 60)}))
    >>> leaning.bounds.round(6).tolist()[0]
    [-50.0, 0.0]
    """
    for name in places:
        if name not in CORNERS:
            raise InputError(
                "a box has no corner {name!r}: use {corners}", name=name, corners=", ".join(CORNERS)
            )
    (left, low), (right, high) = _box_around_curves(curves)
    if min(right - left, high - low) <= 1e-9 * max(right - left, high - low):
        raise InputError(
            "the box around the curve measures {left:.4g} by {low:.4g}: too thin for handles at "
            "its corners; give four handles of your own",
            left=right - left,
            low=Length(high - low),
        )
    before = [(left, low), (right, low), (right, high), (left, high)]
    after = [np.asarray(places.get(name, corner)) for name, corner in zip(CORNERS, before, strict=True)]
    return four_point_map(before, after)


@dataclass(frozen=True)
class Reshape:
    """How a curve is pulled by handles: corners of its box by name, or `handles` and where they go, `to`.

    Raises
    ------
    InputError
        Both kinds of handles, or one without the other.
    """

    bottom_left: Annotated[Point | None, Asked(f"{_TO} of the lower left corner of its box.", "mm")] = None
    bottom_right: Annotated[Point | None, Asked(f"{_TO} of the lower right corner.", "mm")] = None
    top_right: Annotated[Point | None, Asked(f"{_TO} of the upper right corner.", "mm")] = None
    top_left: Annotated[Point | None, Asked(f"{_TO} of the upper left corner.", "mm")] = None
    handles: Annotated[Handles | None, Asked("In place of corners: four points.", "mm")] = None
    to: Annotated[Handles | None, Asked("Where the handles go.", "mm")] = None

    def __post_init__(self) -> None:
        own = [one for one in (self.handles, self.to) if one is not None]
        if bool(own) == bool(self.corners) or len(own) == 1:
            raise InputError(
                "reshape must hold corners of the curve's box with their new places ({corners}), or four points "
                "as handles and four as to",
                corners=", ".join(CORNERS),
            )

    @property
    def corners(self) -> dict[str, Point]:
        """The new places of the corners that are named, mm."""
        return {name: place for name in CORNERS if (place := getattr(self, name)) is not None}

    def of(self, curve: PlaneCurve) -> PlaneCurve:
        """Return the curve with the handles pulled to their new places.

        Raises
        ------
        InputError
            Handles that make no map, or a curve sent through infinity.
        """
        if self.handles is not None and self.to is not None:
            return curve.transformed(four_point_map(self.handles, self.to))
        return curve.transformed(map_corners([curve], self.corners))
