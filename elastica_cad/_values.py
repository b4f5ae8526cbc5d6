"""Checks of what users fill records with: numbers, and records of a kind."""

from collections.abc import Iterable
from math import isfinite
from typing import Any, TypeGuard, cast

import numpy as np

from elastica_cad.errors import InputError


def is_number(value: object) -> TypeGuard[float]:
    """A finite number? Texts, truth values and rows of numbers are none.

    Examples
    --------
    >>> is_number(3), is_number(np.float64(0.5)), is_number("3"), is_number(float("nan")), is_number(True)
    (True, True, False, False, False)
    """
    if isinstance(value, bool | np.bool_) or not isinstance(value, float | int | np.integer | np.floating):
        return False
    return isfinite(value)


def several(name: str, values: object, record: type[Any], kind: str) -> tuple[Any, ...]:
    """A tuple of records of one kind; one record alone stands for a tuple of it.

    Raises
    ------
    InputError
        Something else among them.
    """
    many = isinstance(values, Iterable) and not isinstance(values, record | str)
    found: tuple[Any, ...] = tuple(cast("Iterable[Any]", values)) if many else (values,)
    for one in found:
        if not isinstance(one, record):
            raise InputError(f"{name} hold {one!r}: give {kind} records")
    return found
