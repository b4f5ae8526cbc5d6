"""Keyword lists for `help`: names, types and units, from the classes that declare the keywords."""

import re
from collections.abc import Callable
from inspect import cleandoc
from typing import Any, TypeVar, get_args

T = TypeVar("T")

DRAWN = {
    "path": (
        "edges or a wire of the library, a PlaneCurve, or a finished Strip",
        "Curve of the strip; the end of each edge is the start of the next.",
    ),
    "sheet": ("Sheet or str", "Material, or the name of a built-in sheet; omit it for a finished strip."),
    "max_width": ("float", "Largest width of the free part (mm); or set `min_width`, the least width."),
}
"""Type and help of the arguments of every function that makes a strip of a drawn path."""


def lists(*options: type, drawn: bool = False) -> Callable[[T], T]:
    """Add the keys of `options` to the docstring of a class or function, except those that it explains itself.

    A key is declared as `Annotated["type", "help"]`; if two classes have the same key, the first describes it. With
    `drawn` path, sheet and width come first.

    Examples
    --------
    >>> from elastica_cad.kernel.strip_options import FixtureSizes
    >>> @lists(FixtureSizes)
    ... def block(**sizes):
    ...     "A block."
    >>> block.__doc__.splitlines()[4:6]
    ['clearance : float', '    Clearance around the tab in its pocket (mm).']
    """

    def add(thing: T) -> T:
        if thing.__doc__ is None:  # python -OO
            return thing
        text = cleandoc(thing.__doc__)
        keys: dict[str, Any] = dict(DRAWN) if drawn else {}
        for option in options:
            for name, hint in option.__annotations__.items():
                kind, description = get_args(hint)
                keys.setdefault(name, (kind.__forward_arg__, description))
        rows = (
            f"{name} : {kind}\n    {description}"
            for name, (kind, description) in keys.items()
            if not re.search(rf"^(.*, )?{name}(,.*)? :", text, re.MULTILINE)
        )
        thing.__doc__ = "\n".join([text, "", "Options", "-------", *rows, ""])
        return thing

    return add
