"""Checks of values that users give, equality of records, and numbers in sentences."""

from collections.abc import Iterable, Sized
from dataclasses import fields, is_dataclass
from functools import cache
from os import PathLike
from pathlib import Path
from types import UnionType
from typing import Any, TypeGuard, cast

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad.errors import InputError, quoted
from elastica_cad.refusals import note

LARGEST = 1e100
"""Largest permitted number, so that squares and cubes are finite."""


def is_number(value: object) -> TypeGuard[float]:
    """Return True if the value is a finite number up to 1e100; texts, booleans and arrays are not numbers.

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
    """Return True if the value is an integer; fractions, texts and booleans are not integers.

    Examples
    --------
    >>> is_whole(3), is_whole(np.int64(3)), is_whole(3.0), is_whole(True)
    (True, True, False, False)
    """
    return isinstance(value, int | np.integer) and not isinstance(value, bool)


def require_positive(value: object, what: str, unit: str = "mm") -> None:
    """Raise InputError unless the value is a finite number above 0.

    Raises
    ------
    InputError
        `what` names the value.
    """
    if not (is_number(value) and value > 0):
        shown_value = repr(value) if isinstance(value, str) else value
        wanted = "positive" if is_number(value) else "a number above 0"
        raise InputError(
            "{what} is {told}: it must be {wanted}, in {unit}",
            what=what,
            told=shown_value,
            wanted=wanted,
            unit=unit,
            where={"field": what},
        )


def require_number(value: object, what: str, unit: str = "") -> float:
    """Return the number, or raise InputError unless it is a finite number.

    Raises
    ------
    InputError
        `what` names the value.
    """
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
    """Return an array of floats, or None for texts, rows of unequal length, or integers larger than all floats."""
    try:
        return np.asarray(cast("ArrayLike", values), dtype=float)
    except (TypeError, ValueError, OverflowError):
        return None


def numbers(values: object, what: str) -> FloatArray:
    """Return numbers of any shape as floats; NaN and infinity are accepted.

    Raises
    ------
    InputError
        Values are texts, None, rows of unequal length, or integers larger than all floats.

    Examples
    --------
    >>> numbers([1, 2], "the heights").tolist()
    [1.0, 2.0]
    """
    array = None if values is None else as_floats(values)  # numpy converts None to NaN
    if array is None:
        raise InputError(f"{what} must be numbers, not {quoted(values)}")
    return array


def pair(value: object, what: str) -> FloatArray:
    """Return two finite numbers, such as the coordinates of a point or a range, (2,).

    Raises
    ------
    InputError
        `what` names the value.
    """
    point = None if value is None else as_floats(value)
    if point is None or point.shape != (2,) or not np.isfinite(point).all():
        raise InputError(f"{what} must be two finite numbers, not {quoted(value)}")
    return point


def three(values: object, what: str) -> FloatArray:
    """Return three finite numbers (3,); refuse other values."""
    row = None if values is None else as_floats(values)
    if row is None or row.shape != (3,) or not np.isfinite(row).all():
        raise InputError("{what} is {given}: give three finite numbers", what=what, given=quoted(values))
    return row


def direction(values: object, what: str) -> FloatArray:
    """Return the unit vector (3,) along three finite numbers that are not all 0; refuse other values."""
    row = three(values, what)
    if not row.any():
        raise InputError("{what} is zero: give a direction of three numbers", what=what)
    return np.asarray(row / np.linalg.norm(row))


def alike(**values: object) -> tuple[FloatArray, ...]:
    """Return arrays of compatible shapes by their names, each in its own shape.

    Raises
    ------
    InputError
        Values are not numbers, or their shapes are not compatible.

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
            f"the shapes of {shapes} do not match. Pass the same number of each, or a single one."
        ) from None
    return arrays


def require_flag(value: object, what: str) -> bool:
    """Return the boolean; refuse other values.

    Raises
    ------
    InputError
        `what` names the value.
    """
    if not isinstance(value, bool | np.bool_ | int):
        raise InputError("{what} is {given}: give True or False", what=what, given=quoted(value))
    return bool(value)


def is_one_of(value: object, choices: Iterable[object]) -> bool:
    """Return True if the value is one of these choices; an array, which compares by element, is not."""
    return not isinstance(value, np.ndarray) and value in choices


def is_series(value: object) -> TypeGuard[Iterable[Any]]:
    """Return True if the value is iterable, except texts and arrays of a single number."""
    alone = isinstance(value, str) or (isinstance(value, np.ndarray) and value.ndim == 0)
    return isinstance(value, Iterable) and not alone


def require_record(value: object, record: type[Any] | UnionType, what: str, cure: str) -> None:
    """Raise InputError unless the value is a record of this class; `cure` is the instruction in the message.

    Raises
    ------
    InputError
        `what` names the value.
    """
    if not isinstance(value, record):
        raise InputError(f"{what} is a {type(value).__name__}. Pass {cure}.")


def require_path(path: object) -> Path:
    """Return the path that a user named.

    Raises
    ------
    InputError
        The value is not a path, but for example a number or None.
    """
    if not isinstance(path, str | PathLike):
        raise InputError(f"{path!r} is not the name of a file or folder. Pass a name such as 'arch.dxf'.")
    return Path(path)


def several(
    name: str, values: object, record: type[Any] | UnionType, kind: str, cure: str = ""
) -> tuple[Any, ...]:
    """Return a tuple of records of one type; a single record becomes a tuple.

    `cure` is the instruction in the message.

    Raises
    ------
    InputError
        An item has another type.
    """
    many = is_series(values) and not isinstance(values, record)
    items: tuple[Any, ...] = tuple(cast("Iterable[Any]", values)) if many else (values,)
    for item in items:
        if not isinstance(item, record):
            raise InputError(f"{name} hold {quoted(item)}: give {kind} records{cure and f', {cure}'}")
    return items


_KEPT = "_value_key"  # key of the cached value in the dictionary of a record
_PLAIN = frozenset({type(None), bool, int, float, str})  # most fields have one of these types


class EqualByValue:
    """Base of a frozen dataclass (declared with `eq=False`) that is equal, and hashed, by all its fields."""

    def __eq__(self, other: object) -> bool:
        return isinstance(other, type(self)) and _record_key(self) == _record_key(other)

    def __hash__(self) -> int:
        return hash(_record_key(self))


def value_key(value: Any) -> Any:
    """Return a hashable key that is the same for equal values.

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
        return value.shape, (np.asarray(value, dtype=float) + 0.0).tobytes()  # -0.0 becomes 0.0
    if _compared(kind) is not None:
        return _record_key(value)
    if isinstance(value, tuple | list):
        return tuple(value_key(item) for item in value)
    return value


def _record_key(record: Any) -> tuple[Any, ...]:
    """Return the key of a record; frozen records store it, because a curve may be in several requests."""
    kept = getattr(record, "__dict__", {}) if record.__dataclass_params__.frozen else {}
    if _KEPT not in kept:
        kind: Any = type(record)
        names = _compared(kind) or ()
        kept[_KEPT] = kind, *(value_key(getattr(record, name)) for name in names)
    key: tuple[Any, ...] = kept[_KEPT]
    return key


@cache
def _compared(kind: type) -> tuple[str, ...] | None:
    """Return the names of the compared fields of a record class, or None for another class."""
    if not is_dataclass(kind):
        return None
    return tuple(field.name for field in fields(kind) if field.compare)


MORE_DIGITS = 9
"""Largest number of digits in addition to the usual digits; numbers that still look equal count as equal."""

SEEN_APART = 1e-5
"""Least relative difference that six digits always show; a figure that is closer to its limit meets the limit."""


def counted(count: int, noun: str) -> str:
    """Return the count with its noun.

    Examples
    --------
    >>> counted(1, "strip"), counted(2, "strip")
    ('1 strip', '2 strips')
    """
    return note(f"{{count}} {noun}{'' if count == 1 else 's'}", count=count)


def and_more(items: Sized, noun: str = "") -> str:
    """Return a text with the number of items after the first, or an empty text for a single item.

    Examples
    --------
    >>> and_more("a", "pair"), and_more("abc", "pair"), and_more("abc")
    ('', ' (and 2 more pairs)', ' (and 2 more)')
    """
    others = len(items) - 1
    if others < 1:
        return ""
    if not noun:
        return note(" (and {others} more)", others=others)
    return note(" (and {more})", more=counted(others, f"more {noun}"))


def distinct_digits(first: float, other: float, digits: str) -> tuple[float, float]:
    """Return two numbers rounded to enough digits to differ, with at least the digits of their format.

    Examples
    --------
    >>> distinct_digits(2.51, 3.0, ".3g"), distinct_digits(2.9982, 3.0, ".3g")
    ((2.51, 3.0), (2.998, 3.0))
    """
    usual, kind = int(digits[1:-1]), digits[-1]
    digits_of = range(usual, usual + MORE_DIGITS)
    rounded = [(float(f"{first:.{n}{kind}}"), float(f"{other:.{n}{kind}}")) for n in digits_of]
    return next((pair for pair in rounded if pair[0] != pair[1]), rounded[0])


def round_numbers(value: Any) -> Any:
    """Round to ten significant digits, because more would be noise, and equal designs must give equal files."""
    array = np.asarray(value, dtype=float)
    if array.ndim == 0:
        return float(f"{float(array):.10g}")
    return [round_numbers(row) for row in array]
