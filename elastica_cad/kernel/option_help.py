"""Lists of keyword arguments in docstrings, signatures and errors, for `help` and completion."""

import re
from collections.abc import Callable, Iterator
from functools import wraps
from inspect import Parameter, Signature, cleandoc, isclass
from typing import Any, TypeVar, get_args

from elastica_cad._signatures import PlainText, plain_signature

T = TypeVar("T")

DRAWN = {
    "path": (
        "edges or a wire of the library, a PlaneCurve, or a finished Strip",
        "Curve of the strip; the end of each edge is the start of the next.",
    ),
    "sheet": ("Sheet or str", "Material, or the name of a built-in sheet; omit it for a finished strip."),
    "max_width": ("float", "Largest width of the free part (mm); or set `min_width`, the least width."),
}
"""Type and description of the arguments of every function for a strip along a drawn path."""


def lists(*options: type, drawn: bool = False) -> Callable[[T], T]:
    """Return a decorator that adds the keys of `options` to docstring and signature of a class or function.

    A call that does not fit the signature raises a TypeError with the public name of the class or function.

    A key is declared as `Annotated["type", "help"]` in a typed dictionary. If several dictionaries declare a key,
    the first one describes the key. Keys that the docstring already describes are not repeated. With `drawn`, the
    docstring also describes path, sheet and max_width. In the signature, the keys replace `**options`.

    Examples
    --------
    >>> from inspect import signature
    >>> from elastica_cad.kernel.strip_options import FixtureSizes
    >>> @lists(FixtureSizes)
    ... def block(**sizes):
    ...     "A block."
    >>> block.__doc__.splitlines()[4:6]
    ['clearance : float', '    Clearance around the tab in its pocket (mm).']
    >>> list(signature(block).parameters)[:2]
    ['clearance', 'wall']
    """
    # type and help text by name; the first dictionary is last, so that its texts remain
    keys = {
        name: (get_args(hint)[0].__forward_arg__, get_args(hint)[1])
        for option in reversed(options)
        for name, hint in option.__annotations__.items()
    }

    def add(thing: Any) -> Any:
        function = thing.__init__ if isclass(thing) else thing
        given = plain_signature(function)
        named = [entry for entry in given.parameters.values() if entry.kind is not Parameter.VAR_KEYWORD]
        taken = {entry.name for entry in named}
        added = [
            Parameter(name, Parameter.KEYWORD_ONLY, default=PlainText("..."), annotation=PlainText(kind))
            for name, (kind, _) in keys.items()
            if name not in taken
        ]
        written = given.replace(parameters=[*named, *added])
        call = _checked(function, given, written)
        if isclass(thing):
            thing.__init__, call = call, thing  # type: ignore[method-assign]  # each class has its own
            written = written.replace(
                parameters=[*written.parameters.values()][1:], return_annotation=Parameter.empty
            )
        call.__signature__ = written
        if call.__doc__ is not None:  # `python -OO` removes docstrings
            text = cleandoc(call.__doc__)
            text = _with_first_parameters(text) if drawn else text
            rows = [
                row
                for name, row in _rows(keys)
                if not re.search(rf"^(.*, )?{name}(,.*)? :", text, re.MULTILINE)
            ]
            call.__doc__ = "\n".join([text, *(["", "Options", "-------", *rows, ""] if rows else [])])
        return call

    return add


def _checked(function: Callable[..., Any], given: Signature, written: Signature) -> Any:
    """Return the function with errors that state its public name and the names of its arguments.

    `given` has the keys of `written` as `**options`, so that the function itself refuses unknown keys.
    """
    placed, named = (
        [name for name, entry in written.parameters.items() if entry.kind is kind]
        for kind in (Parameter.POSITIONAL_OR_KEYWORD, Parameter.KEYWORD_ONLY)
    )
    public = [name for name in placed if name != "self"]
    hint = (
        f"takes {' and '.join(public) or 'no argument'} by position. Pass other arguments by name, "
        f"such as {named[0]}=..."
    )

    @wraps(function)
    def call(*args: Any, **options: Any) -> Any:
        try:
            given.bind(*args, **options)
        except TypeError as error:
            owner = "" if public == placed else f"{type(args[0]).__name__}."
            name = f"{owner}{function.__name__}".removesuffix(".__init__")
            raise TypeError(f"{name}: {hint if len(args) > len(placed) else error}") from None
        return function(*args, **options)

    return call


def _rows(keys: dict[str, tuple[str, str]]) -> Iterator[tuple[str, str]]:
    for name, (kind, description) in keys.items():
        yield name, f"{name} : {kind}\n    {description}"


def _with_first_parameters(text: str) -> str:
    """Return a docstring with the drawn shape as its first parameter."""
    title = "Parameters\n----------\n"
    first = title + "".join(f"{row}\n" for _, row in _rows(DRAWN))
    if title in text:
        return text.replace(title, first)
    section = re.search(r"^.+\n-{3,}$", text, re.MULTILINE)
    place = section.start() if section else len(text)
    return "\n\n".join(part for part in (text[:place].rstrip(), first.rstrip(), text[place:]) if part)
