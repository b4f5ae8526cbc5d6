"""Records that are equal where their contents are: for requests that are kept, looked up and answered once."""

from dataclasses import fields, is_dataclass
from functools import cache
from typing import Any

import numpy as np

_KEPT = "_value_key"  # in a record's own dictionary
_PLAIN = frozenset({type(None), bool, int, float, str})  # most fields hold one of these


class EqualByValue:
    """Base of a frozen dataclass (declared with `eq=False`) that is equal, and hashed, by all its fields."""

    def __eq__(self, other: object) -> bool:
        return isinstance(other, type(self)) and _record_key(self) == _record_key(other)

    def __hash__(self) -> int:
        return hash(_record_key(self))


def value_key(value: Any) -> Any:
    """What two values have in common where they are equal, as something that can be hashed.

    Records count by their fields, arrays by their numbers, functions by being the same function.

    Examples
    --------
    >>> value_key([1.0, np.array([2.0, 3.0])]) == value_key((1, np.array([2.0, 3.0])))
    True
    """
    kind: Any = type(value)
    if kind in _PLAIN:
        return value
    if isinstance(value, np.ndarray):
        return value.shape, (np.asarray(value, dtype=float) + 0.0).tobytes()  # one zero, not two
    if _compared(kind) is not None:
        return _record_key(value)
    if isinstance(value, tuple | list):
        return tuple(value_key(one) for one in value)
    return value


def _record_key(record: Any) -> tuple[Any, ...]:
    """That of a record; a frozen one keeps it, as a curve stands in several requests."""
    kept = getattr(record, "__dict__", {}) if record.__dataclass_params__.frozen else {}
    if _KEPT not in kept:
        kind: Any = type(record)
        names = _compared(kind) or ()
        kept[_KEPT] = kind, *(value_key(getattr(record, name)) for name in names)
    key: tuple[Any, ...] = kept[_KEPT]
    return key


@cache
def _compared(kind: type) -> tuple[str, ...] | None:
    """Names of the fields by which records of a class are compared, None of what is no record."""
    if not is_dataclass(kind):
        return None
    return tuple(field.name for field in fields(kind) if field.compare)
