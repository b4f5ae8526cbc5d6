"""Checks of what users fill records with: numbers, names of files, and records of a kind."""

from collections.abc import Iterable
from os import PathLike
from pathlib import Path
from types import UnionType
from typing import Any, TypeGuard, cast

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad.errors import InputError, quoted

LARGEST = 1e100
"""Of numbers that mean something here: their squares and cubes are numbers still."""


def is_number(value: object) -> TypeGuard[float]:
    """A finite number? Texts, truth values, rows of numbers and what no drawing holds, beyond 1e100, are none.

    Examples
    --------
    >>> is_number(3), is_number(np.float64(0.5)), is_number("3"), is_number(float("nan")), is_number(True)
    (True, True, False, False, False)
    """
    if type(value) is not float and (  # nearly all are
        isinstance(value, bool | np.bool_) or not isinstance(value, float | int | np.integer | np.floating)
    ):
        return False
    return bool(-LARGEST <= value <= LARGEST)


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
        raise InputError(
            "{what} is {told}: it must be {wanted}, in {unit}",
            what=what,
            told=told,
            wanted=wanted,
            unit=unit,
            where={"field": what},
        )


def require_number(value: object, what: str, unit: str = "") -> float:
    """The number; refused where it is none or not finite.

    Raises
    ------
    InputError
        `what` names the value.
    """
    if not is_number(value):
        told = quoted(value) if isinstance(value, str) else value
        raise InputError(
            "{what} is {told}: give a finite number{unit}", what=what, told=told, unit=unit and f", in {unit}"
        )
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
        raise InputError("{what} must be numbers, not {values}", what=what, values=quoted(values))
    return array


def pair(value: object, what: str) -> FloatArray:
    """Two finite numbers, such as the coordinates of a point or a range, (2,).

    Raises
    ------
    InputError
        `what` names the value.
    """
    found = None if value is None else as_floats(value)
    if found is None or found.shape != (2,) or not np.isfinite(found).all():
        raise InputError("{what} must be two finite numbers, not {given}", what=what, given=quoted(value))
    return found


def three(values: object, what: str) -> FloatArray:
    """Three finite numbers (3,); refuses anything else."""
    row = None if values is None else as_floats(values)
    if row is None or row.shape != (3,) or not np.isfinite(row).all():
        raise InputError("{what} is {given}: give three finite numbers", what=what, given=quoted(values))
    return row


def direction(values: object, what: str) -> FloatArray:
    """Unit vector (3,) along three finite numbers that are not all 0; refuses anything else."""
    row = three(values, what)
    if not row.any():
        raise InputError("{what} is zero: give a direction of three numbers", what=what)
    return np.asarray(row / np.linalg.norm(row))


def alike(**values: object) -> tuple[FloatArray, ...]:
    """Numbers of shapes that go together, by their names, each as it is.

    Raises
    ------
    InputError
        No numbers, or of shapes that do not.

    Examples
    --------
    >>> alike(curvature=[1, 2], rest=0.0)
    (array([1., 2.]), array(0.))
    """
    arrays = tuple(numbers(value, name) for name, value in values.items())
    try:
        np.broadcast_shapes(*(array.shape for array in arrays))
    except ValueError:
        shapes = " and ".join(f"{name} {array.shape}" for name, array in zip(values, arrays, strict=True))
        raise InputError(
            "the shapes of {shapes} do not go together: give as many of each, or one", shapes=shapes
        ) from None
    return arrays


def require_flag(value: object, what: str) -> bool:
    """Yes or no; refused where it is neither.

    Raises
    ------
    InputError
        `what` names the value.
    """
    if not isinstance(value, bool | np.bool_ | int):
        raise InputError("{what} is {given}: give True or False", what=what, given=quoted(value))
    return bool(value)


def is_one_of(value: object, choices: Iterable[object]) -> bool:
    """Is it one of these? An array, which would answer for each of its elements, is none."""
    return not isinstance(value, np.ndarray) and value in choices


def is_series(value: object) -> TypeGuard[Iterable[Any]]:
    """Can it be gone through? A text stands for itself, and an array of one number for that number."""
    alone = isinstance(value, str) or (isinstance(value, np.ndarray) and value.ndim == 0)
    return isinstance(value, Iterable) and not alone


def require_record(value: object, record: type[Any] | UnionType, what: str, cure: str) -> None:
    """Refuse what is no such record; `cure` says what to give.

    Raises
    ------
    InputError
        `what` names the value.
    """
    if not isinstance(value, record):
        raise InputError("{what} is a {name}: give {cure}", what=what, name=type(value).__name__, cure=cure)


def require_path(path: object) -> Path:
    """The path that a user named.

    Raises
    ------
    InputError
        Something else, such as a number or None.
    """
    if not isinstance(path, str | PathLike):
        raise InputError(
            "the name of a file or folder is needed, such as 'arch.dxf', not {path!r}", path=path
        )
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
    many = is_series(values) and not isinstance(values, record)
    found: tuple[Any, ...] = tuple(cast("Iterable[Any]", values)) if many else (values,)
    for one in found:
        if not isinstance(one, record):
            raise InputError(
                "{name} hold {one}: give {thing} records{cure}",
                name=name,
                one=quoted(one),
                thing=kind,
                cure=cure and f", {cure}",
            )
    return found
