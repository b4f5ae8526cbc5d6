"""Four handles that curves are reshaped by: the corners of their box, or any four points."""

from collections.abc import Mapping, Sequence

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad.errors import InputError
from elastica_cad.formats.design_files.keys.strip_keys import STRIP_TABLES
from elastica_cad.formats.design_files.tables import Table
from elastica_cad.geometry.boxes import box_around
from elastica_cad.geometry.curves.plane_curve import PlaneCurve
from elastica_cad.geometry.curves.projective_maps import four_point_map
from elastica_cad.refusals import Length

CORNERS = ("bottom_left", "bottom_right", "top_right", "top_left")
"""Handles of the box around the drawn curves, by name."""


def _box_around_curves(curves: Sequence[PlaneCurve]) -> FloatArray:
    """Lower left and upper right corner (2, 2) of the box around curves, mm."""
    return box_around(np.array([curve.bounds for curve in curves]))


def map_corners(curves: Sequence[PlaneCurve], places: Mapping[str, ArrayLike]) -> FloatArray:
    """The projective map that takes corners of the box around curves to `places`, mm; other corners stay.

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


def reshape_curve(curve: PlaneCurve, table: Table) -> PlaneCurve:
    """The curve as a table of a design file reshapes it: corners by name, or `handles` and where they go, `to`.

    Raises
    ------
    InputError
        Both kinds of handles, handles that make no map, or a curve sent through infinity; the place is named.
    """
    table.only(*STRIP_TABLES["reshape"])
    own = [key for key in ("handles", "to") if table.has(key)]
    corners = {name: table.vector(name, 2) for name in CORNERS if table.has(name)}
    if bool(own) == bool(corners) or len(own) == 1:
        raise InputError(
            "{where_} must hold corners of the curve's box with their new places ({corners}), or "
            "four points as handles and four as to",
            where_=table.where,
            corners=", ".join(CORNERS),
        )
    with table.naming():
        if corners:
            return curve.transformed(map_corners([curve], corners))
        return curve.transformed(four_point_map(*(table.points(key, 2, 4) for key in own)))
