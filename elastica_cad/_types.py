"""Types of arrays and points, and of fields that accept more types than they store."""

from dataclasses import field
from typing import TYPE_CHECKING, Any, Generic, TypeAlias, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

FloatArray: TypeAlias = NDArray[np.float64]
IntArray: TypeAlias = NDArray[np.intp]
BoolArray: TypeAlias = NDArray[np.bool_]
Pair: TypeAlias = tuple[float, float]
Triple: TypeAlias = tuple[float, float, float]

__all__ = ["EMPTY", "ArrayLike", "BoolArray", "FloatArray", "IntArray", "Pair", "Takes", "Triple", "required"]

Kept_co = TypeVar("Kept_co", covariant=True)
Given_contra = TypeVar("Given_contra", contravariant=True)

if TYPE_CHECKING:

    class Takes(Generic[Kept_co, Given_contra]):
        """Type of a field that stores one type and also accepts another, as in `Takes[tuple[Hole, ...], Hole]`."""

        def __get__(self, record: object, owner: Any = None, /) -> Kept_co: ...

        def __set__(self, record: object, value: Given_contra, /) -> None: ...

else:

    class Takes:
        """At run time, `Takes[stored, accepted]` is the stored type."""

        def __class_getitem__(cls, kinds):
            return kinds[0]


EMPTY: Any = ()
"""Default of a field with the type `Takes`."""


def required() -> Any:
    """Return a dataclass field without a default. mypy accepts it for a field of type `Takes`."""
    return field()
