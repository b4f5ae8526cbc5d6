"""Keyword lists for `help`: names, types and units, from the classes that declare the keywords."""

import ast
import re
from collections.abc import Callable
from functools import cache
from inspect import cleandoc, getsourcefile
from itertools import pairwise
from pathlib import Path
from typing import TypeVar

T = TypeVar("T")

DRAWN = {
    "path": (
        "edges or a wire of the library, a PlaneCurve, or a Strip that is made",
        "The curve that the strip is to take; edges follow each other.",
    ),
    "sheet": ("Sheet or str", "The material, or the name of a built-in one; none for a strip that is made."),
    "max_width": ("float", "The largest width of the free part (mm); or give `min_width`, the least."),
}
"""Type and help of the arguments that every function has which makes a strip of what is drawn."""


def lists(*options: type, drawn: bool = False) -> Callable[[T], T]:
    """Add the keys of `options` to the docstring of a class or function, but for those that it explains itself.

    With `drawn` path, sheet and width come first.

    Examples
    --------
    >>> from elastica_cad.kernel.strip_options import FixtureSizes
    >>> @lists(FixtureSizes)
    ... def block(**sizes):
    ...     "A block."
    >>> block.__doc__.splitlines()[4:6]
    ['clearance : float', '    Room around the tab in its pocket (mm).']
    """

    def add(thing: T) -> T:
        if thing.__doc__ is None:  # python -OO
            return thing
        text = cleandoc(thing.__doc__)
        keys = dict(DRAWN) if drawn else {}
        for one in options:  # if two classes have the same key, the first describes it
            keys = _keys_of(one) | keys
        rows = (
            f"{name} : {kind}\n    {said}"
            for name, (kind, said) in keys.items()
            if not re.search(rf"^(.*, )?{name}(,.*)? :", text, re.MULTILINE)
        )
        thing.__doc__ = "\n".join([text, "", "Options", "-------", *rows, ""])
        return thing

    return add


def _keys_of(options: type) -> dict[str, tuple[str, str]]:
    """Type and help of the keys that a class declares, each with a docstring below it."""
    file = getsourcefile(options)
    assert file is not None
    body = next(
        node.body
        for node in _tree(file).body
        if isinstance(node, ast.ClassDef) and node.name == options.__name__
    )
    found = {}
    for field, below in pairwise(body):
        if isinstance(field, ast.AnnAssign) and isinstance(below, ast.Expr):
            kind = ast.unparse(field.annotation).strip("'\"")
            found[ast.unparse(field.target)] = kind, str(ast.literal_eval(below.value))
    return found


@cache
def _tree(file: str) -> ast.Module:
    return ast.parse(Path(file).read_text(encoding="utf-8"))
