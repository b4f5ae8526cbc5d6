"""Gravity as a designer says it, in the drawing or in space, and what of it pulls in the plane of the curve."""

from collections.abc import Sequence
from dataclasses import replace
from typing import TypeAlias

import numpy as np

from elastica_cad._values import is_number
from elastica_cad.errors import InputError
from elastica_cad.geometry.frame import Frame
from elastica_cad.mechanics.loads.gravity import Gravity
from elastica_cad.mechanics.loads.weight import PointMass, Weight
from elastica_cad.mechanics.material.sheet import Sheet

AskedGravity: TypeAlias = "Gravity | bool | Sequence[float] | None"
"""A `Gravity`, True for the sheet's own weight along -y, or the direction in which that falls."""

Loads: TypeAlias = "tuple[PointMass, ...] | Weight"
"""Masses hung on a strip beside its own weight; or all weight in newtons."""


def pull_in_plane(given: AskedGravity, sheet: Sheet, frame: Frame | None) -> tuple[Gravity | None, float]:
    """Gravity as a strip feels it in the plane of its curve, and the share of a weight that acts there.

    Raises
    ------
    InputError
        No direction, or one in space where no `frame` says how the plane lies.
    """
    if given is None or isinstance(given, bool):
        return (sheet.gravity() if given else None), 1.0
    if isinstance(given, Gravity):
        return given, 1.0
    direction = _direction(given)
    if len(direction) == 2:
        return sheet.gravity(direction), 1.0
    if frame is None:
        raise InputError(
            f"gravity {direction} is a direction in space: give frame, the plane of the curve, or two numbers, "
            "the direction in the drawing",
            where={"field": "gravity"},
        )
    own = sheet.elasto_gravity_length
    felt = Gravity.in_plane(own, direction, frame.x_axis, frame.y_axis)
    return felt, 1.0 if felt is None else (own / felt.length) ** 3


def lightened(loads: Loads, share: float) -> Loads:
    """Masses of which only a share acts; a weight in newtons is what acts."""
    if isinstance(loads, Weight):
        return loads
    return tuple(replace(one, mass=share * one.mass) for one in loads)


def hung_weight(loads: Loads, share: float) -> Weight | None:
    """Loads as `optimal_rod` takes them; in a plane that leans, masses hang with a share of their weight."""
    felt = lightened(loads, share)
    if isinstance(felt, Weight):
        return felt
    return Weight(masses=felt, own=True) if felt else None


def _direction(given: object) -> tuple[float, ...]:
    """Two or three numbers that say where things fall."""
    row = tuple(given) if isinstance(given, Sequence | np.ndarray) and not isinstance(given, str) else ()
    if len(row) not in (2, 3) or not all(is_number(one) for one in row) or not any(row):
        raise InputError(
            f"gravity is {given!r}: give True, a Gravity record, or the direction in which things fall as two "
            "numbers in the drawing or three in space, not all zero, such as (0, -1) or (0, 0, -1)",
            where={"field": "gravity"},
        )
    return tuple(float(one) for one in row)
