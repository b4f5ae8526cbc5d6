"""Properties that are computed once for each object, without a lock."""

import functools
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    cached_property = functools.cached_property
else:

    class cached_property(functools.cached_property):  # noqa: N801 - named as its base
        """Property that is computed once, as in Python from 3.12 on.

        Up to Python 3.11, all objects of a class share one lock while they compute. Two threads that compute
        properties of different objects then wait for each other for ever, if each needs a property that the other
        computes. Without a lock, both may compute a value twice.
        """

        def __get__(self, instance: Any, owner: type | None = None) -> Any:
            if instance is None:
                return self
            value = vars(instance)[self.attrname] = self.func(instance)
            return value
