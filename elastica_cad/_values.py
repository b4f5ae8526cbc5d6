"""Checks of values from users, equality of records by value, and formatting of numbers in sentences."""

from collections.abc import Iterable, Mapping, Sized
from dataclasses import fields, is_dataclass
from enum import Enum
from functools import cache
from os import PathLike
from pathlib import Path, PurePath
from types import UnionType
from typing import Any, TypeGuard, cast

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad.errors import InputError, note, quoted

LARGEST = 1e100
"""Largest permitted number. Its square and cube are finite."""


def is_number(value: object) -> TypeGuard[float]:
    """Return True if the value is a finite number up to 1e100. Strings, booleans and arrays are not numbers.

    Examples
    --------
    >>> is_number(3), is_number(np.float64(0.5)), is_number("3"), is_number(float("nan")), is_number(True)
    (True, True, False, False, False)
    """
    if type(value) is not float and (
        isinstance(value, bool | np.bool_) or not isinstance(value, float | int | np.integer | np.floating)
    ):
        return False
    return bool(-LARGEST <= value <= LARGEST)


def is_whole(value: object) -> TypeGuard[int]:
    """Return True if the value is an integer. Floats such as 3.0, strings and booleans are not integers.

    Examples
    --------
    >>> is_whole(3), is_whole(np.int64(3)), is_whole(3.0), is_whole(True)
    (True, True, False, False)
    """
    return isinstance(value, int | np.integer) and not isinstance(value, bool)


def require_positive(value: object, what: str, unit: str = "mm") -> None:
    """Raise InputError for a value that is not a finite number above 0."""
    if not (is_number(value) and value > 0):
        shown_value = repr(value) if isinstance(value, str) else value
        raise InputError(
            "{what} is {told}: give a number above 0, in {unit}",
            what=what,
            told=shown_value,
            unit=unit,
            where={"field": what},
        )


def require_number(value: object, what: str, unit: str = "") -> float:
    """Return a finite number. Raise InputError for another value."""
    if not is_number(value):
        shown_value = quoted(value) if isinstance(value, str) else value
        raise InputError(
            "{what} is {told}: give a finite number{unit}",
            what=what,
            told=shown_value,
            unit=unit and f", in {unit}",
        )
    return float(value)


def as_floats(values: object) -> FloatArray | None:
    """Return an array of floats, or None for strings, rows of unequal length, and too large integers."""
    try:
        return np.asarray(cast("ArrayLike", values), dtype=float)
    except (TypeError, ValueError, OverflowError):
        return None


def numbers(values: object, what: str) -> FloatArray:
    """Return an array of floats of any shape. NaN and infinity are accepted.

    Examples
    --------
    >>> numbers([1, 2], "the heights").tolist()
    [1.0, 2.0]
    """
    # numpy would convert None to NaN
    array = None if values is None else as_floats(values)
    if array is None:
        raise InputError(f"{what} cannot be {quoted(values)}: give numbers")
    return array


def pair(value: object, what: str) -> FloatArray:
    """Return two finite numbers (2,), such as a point. Raise InputError for other values."""
    point = as_floats(value)
    if point is None or point.shape != (2,) or not np.isfinite(point).all():
        raise InputError(f"{what} cannot be {quoted(value)}: give two finite numbers")
    return point


def three(values: object, what: str) -> FloatArray:
    """Return three finite numbers (3,). Raise InputError for other values."""
    row = as_floats(values)
    if row is None or row.shape != (3,) or not np.isfinite(row).all():
        raise InputError("{what} is {given}: give three finite numbers", what=what, given=quoted(values))
    return row


def direction(values: object, what: str) -> FloatArray:
    """Return the unit vector (3,) in the direction of a vector (3,).

    Raise InputError for a zero vector, and for values that are not finite.
    """
    row = three(values, what)
    if not row.any():
        raise InputError("{what} is zero: give a direction of three numbers", what=what)
    return np.asarray(row / np.linalg.norm(row))


def alike(**values: object) -> tuple[FloatArray, ...]:
    """Return the values as arrays, not broadcast. Raise InputError if the shapes cannot be broadcast together.

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
            f"the shapes of {shapes} do not match. Pass arrays of equal length, or single values."
        ) from None
    return arrays


def require_flag(value: object, what: str) -> bool:
    """Return a boolean. Raise InputError for another value."""
    if not isinstance(value, bool | np.bool_ | int):
        raise InputError("{what} is {given}: give True or False", what=what, given=quoted(value))
    return bool(value)


def is_one_of(value: object, choices: Iterable[object]) -> bool:
    """Return True if the value equals one of the choices. An array equals none."""
    return not isinstance(value, np.ndarray) and value in choices


def is_series(value: object) -> TypeGuard[Iterable[Any]]:
    """Return True if the value is iterable, but not a string or an array of dimension 0."""
    alone = isinstance(value, str) or (isinstance(value, np.ndarray) and value.ndim == 0)
    return isinstance(value, Iterable) and not alone


def require_executor(executor: object, method: str) -> None:
    """Raise InputError for an executor without the required method. None is accepted."""
    if not (executor is None or callable(getattr(executor, method, None))):
        raise InputError(f"executor is {quoted(executor)}: give a concurrent.futures.Executor, or None")


def with_article(kind: type) -> str:
    """Return the name of a class with its article, such as "an int"."""
    name = kind.__name__
    return f"{'an' if name[0] in 'aeioAEIO' else 'a'} {name}"


def require_record(value: object, record: type[Any] | UnionType, what: str, cure: str) -> None:
    """Raise InputError for a value of another class than `record`.

    The message tells the user to pass `cure`.
    """
    if not isinstance(value, record):
        raise InputError(f"{what} is {with_article(type(value))}. Pass {cure}.")


def require_path(path: object) -> Path:
    """Return a path that a user has passed."""
    if not isinstance(path, str | PathLike):
        raise InputError(f"{path!r} is not the name of a file or folder. Pass a name such as 'arch.dxf'.")
    return Path(path)


def several(
    name: str, values: object, record: type[Any] | UnionType, kind: str, cure: str = ""
) -> tuple[Any, ...]:
    """Return one or several records of a class as a tuple. `cure` is the end of the error message."""
    many = is_series(values) and not isinstance(values, record)
    items: tuple[Any, ...] = tuple(cast("Iterable[Any]", values)) if many else (values,)
    for item in items:
        if not isinstance(item, record):
            raise InputError(
                f"{name} contain {quoted(item)}. Pass only {kind} records{cure and f', {cure}'}."
            )
    return items


_CACHED_KEY = "_value_key"
# `value_key` returns values of these frequent types unchanged
_PLAIN = frozenset({type(None), bool, int, float, str})


class EqualByValue:
    """Base of a frozen dataclass, declared with `eq=False`, whose equality and hash depend on all fields."""

    def __eq__(self, other: object) -> bool:
        return isinstance(other, type(self)) and _record_key(self) == _record_key(other)

    def __hash__(self) -> int:
        return hash(_record_key(self))


def value_key(value: Any) -> Any:
    """Return a hashable key that is equal for equal values.

    Records are compared by their fields, arrays by their numbers, functions by identity.

    Examples
    --------
    >>> value_key([1.0, np.array([2.0, 3.0])]) == value_key((1, np.array([2.0, 3.0])))
    True
    """
    kind: Any = type(value)
    if kind in _PLAIN:
        return value
    if isinstance(value, np.ndarray):
        return value.shape, (np.asarray(value, dtype=float) + 0.0).tobytes()  # adding 0.0 turns -0.0 into 0.0
    if _compared_fields(kind) is not None:
        return _record_key(value)
    if isinstance(value, tuple | list):
        return tuple(value_key(item) for item in value)
    return value


def _record_key(record: Any) -> tuple[Any, ...]:
    """Return the key of a record. Frozen records cache it, because many requests contain the same curve."""
    attributes = getattr(record, "__dict__", {}) if record.__dataclass_params__.frozen else {}
    if _CACHED_KEY not in attributes:
        kind: Any = type(record)
        names = _compared_fields(kind) or ()
        attributes[_CACHED_KEY] = kind, *(value_key(getattr(record, name)) for name in names)
    key: tuple[Any, ...] = attributes[_CACHED_KEY]
    return key


@cache
def _compared_fields(kind: type) -> tuple[str, ...] | None:
    if not is_dataclass(kind):
        return None
    return tuple(field.name for field in fields(kind) if field.compare)


MORE_DIGITS = 9
"""Largest number of digits added to distinguish two numbers. If they still look equal, they count as equal.
"""

SEEN_APART = 1e-5
"""Least relative difference of two numbers that is always visible in six digits.

A value that exceeds its limit by less is accepted.
"""


def counted(count: int, noun: str) -> str:
    """Return a count with a noun, which is in the plural unless the count is 1.

    Examples
    --------
    >>> counted(1, "strip"), counted(2, "strip")
    ('1 strip', '2 strips')
    """
    return note(f"{{count}} {noun}{'' if count == 1 else 's'}", count=count)


def and_more(items: Sized, noun: str = "") -> str:
    """Return a text such as " (and 2 more pairs)" for the items after the first, or "" for a single item.

    Examples
    --------
    >>> and_more("a", "pair"), and_more("abc", "pair"), and_more("abc")
    ('', ' (and 2 more pairs)', ' (and 2 more)')
    """
    count = len(items) - 1
    if count < 1:
        return ""
    if not noun:
        return note(" (and {others} more)", others=count)
    return note(" (and {more})", more=counted(count, f"more {noun}"))


def distinct_digits(first: float, other: float, digits: str) -> tuple[float, float]:
    """Round two numbers to the digits of a format, or to more digits if they would look equal.

    Examples
    --------
    >>> distinct_digits(2.51, 3.0, ".3g"), distinct_digits(2.9982, 3.0, ".3g")
    ((2.51, 3.0), (2.998, 3.0))
    """
    usual, kind = int(digits[1:-1]), digits[-1]
    digits_of = range(usual, usual + MORE_DIGITS)
    rounded = [(float(f"{first:.{n}{kind}}"), float(f"{other:.{n}{kind}}")) for n in digits_of]
    return next((pair for pair in rounded if pair[0] != pair[1]), rounded[0])


def plain_data(value: Any) -> Any:
    """Return a value for JSON: numbers rounded to ten significant digits, null for infinity and nan.

    Further digits are noise, which would make files of equal designs differ.

    Examples
    --------
    >>> plain_data({"at": np.array([1 / 3, np.inf]), "file": PurePath("a.dxf")})
    {'at': [0.3333333333, None], 'file': 'a.dxf'}
    """
    if is_dataclass(value) and not isinstance(value, type):
        value = {entry.name: getattr(value, entry.name) for entry in fields(value)}
    if isinstance(value, Mapping):
        return {str(key): plain_data(item) for key, item in value.items()}
    if isinstance(value, np.ndarray | np.generic):
        return plain_data(value.tolist())
    if isinstance(value, list | tuple):
        return [plain_data(item) for item in value]
    if isinstance(value, Enum):
        return value.name.lower()
    if isinstance(value, PurePath):
        return str(value)
    if isinstance(value, float):
        return float(f"{float(value):.10g}") if np.isfinite(value) else None
    return value
