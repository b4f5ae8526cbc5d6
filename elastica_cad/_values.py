"""Checks of what users fill records with: numbers, names of files, and records of a kind."""

from collections.abc import Iterable
from math import isfinite
from os import PathLike
from pathlib import Path
from types import UnionType
from typing import Any, TypeGuard, cast

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad.errors import InputError, quoted


def is_number(value: object) -> TypeGuard[float]:
    """A finite number? Texts, truth values and rows of numbers are none.

    Examples
    --------
    >>> is_number(3), is_number(np.float64(0.5)), is_number("3"), is_number(float("nan")), is_number(True)
    (True, True, False, False, False)
    """
    if type(value) is float:  # nearly all are
        return isfinite(value)
    if isinstance(value, bool | np.bool_) or not isinstance(value, float | int | np.integer | np.floating):
        return False
    try:
        return isfinite(value)
    except OverflowError:  # a whole number larger than all floats
        return False


def is_whole(value: object) -> TypeGuard[int]:
    """A whole number? Fractions, texts and truth values are none.

    Examples
    --------
    >>> is_whole(3), is_whole(np.int64(3)), is_whole(3.0), is_whole(True)
    (True, True, False, False)
    """
    return isinstance(value, int | np.integer) and not isinstance(value, bool)


def require_positive(value: object, what: str, unit: str = "mm") -> None:
    """Refuse what is no finite number above 0.

    Raises
    ------
    InputError
        `what` names the value.
    """
    if not (is_number(value) and value > 0):
        told = repr(value) if isinstance(value, str) else value
        wanted = "positive" if is_number(value) else "a number above 0"
        raise InputError(f"{what} is {told}: it must be {wanted}, in {unit}", where={"field": what})


def require_number(value: object, what: str, unit: str = "") -> float:
    """The number; refused where it is none or not finite.

    Raises
    ------
    InputError
        `what` names the value.
    """
    if not is_number(value):
        told = quoted(value) if isinstance(value, str) else value
        raise InputError(f"{what} is {told}: give a finite number{unit and f', in {unit}'}")
    return float(value)


def as_floats(values: object) -> FloatArray | None:
    """An array of floats; None of texts, rows of unequal length, or whole numbers larger than all floats."""
    try:
        return np.asarray(cast("ArrayLike", values), dtype=float)
    except (TypeError, ValueError, OverflowError):
        return None


def numbers(values: object, what: str) -> FloatArray:
    """Numbers of any shape as floats; NaN and infinity pass.

    Raises
    ------
    InputError
        Texts, None, rows of unequal length, or whole numbers larger than all floats among them.

    Examples
    --------
    >>> numbers([1, 2], "the heights").tolist()
    [1.0, 2.0]
    """
    array = None if values is None else as_floats(values)  # numpy takes None for NaN
    if array is None:
        raise InputError(f"{what} must be numbers, not {quoted(values)}")
    return array


def require_record(value: object, record: type[Any] | UnionType, what: str, cure: str) -> None:
    """Refuse what is no such record; `cure` says what to give.

    Raises
    ------
    InputError
        `what` names the value.
    """
    if not isinstance(value, record):
        raise InputError(f"{what} is a {type(value).__name__}: give {cure}")


def require_path(path: object) -> Path:
    """The path that a user named.

    Raises
    ------
    InputError
        Something else, such as a number or None.
    """
    if not isinstance(path, str | PathLike):
        raise InputError(f"the name of a file or folder is needed, such as 'arch.dxf', not {path!r}")
    return Path(path)


def several(
    name: str, values: object, record: type[Any] | UnionType, kind: str, cure: str = ""
) -> tuple[Any, ...]:
    """A tuple of records of one kind; one record alone stands for a tuple of it.

    `cure` says how such records are had.

    Raises
    ------
    InputError
        Something else among them.
    """
    alone = isinstance(values, record | str) or (isinstance(values, np.ndarray) and values.ndim == 0)
    many = isinstance(values, Iterable) and not alone
    found: tuple[Any, ...] = tuple(cast("Iterable[Any]", values)) if many else (values,)
    for one in found:
        if not isinstance(one, record):
            raise InputError(f"{name} hold {quoted(one)}: give {kind} records{cure and f', {cure}'}")
    return found
