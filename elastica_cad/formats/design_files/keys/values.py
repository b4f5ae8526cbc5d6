"""Kinds of values in a design file as fragments of JSON schema, and the same in words."""

from typing import Any, TypeAlias

Fragment: TypeAlias = dict[str, Any]

Keys: TypeAlias = dict[str, tuple[Fragment, str]]
"""Key -> its value, and what it says."""

NUMBER: Fragment = {"type": ["number", "string"]}  # a formula is a text
COUNT: Fragment = {"type": ["integer", "string"]}
FLAG: Fragment = {"type": "boolean"}
TEXT: Fragment = {"type": "string"}
NUMBERS: Fragment = {"type": "array", "items": NUMBER, "minItems": 1}
NAMES: Fragment = {"type": "object", "additionalProperties": NUMBER}

_REFERENCE = "#/definitions/"


def vector(size: int) -> Fragment:
    """So many numbers in brackets."""
    return {"type": "array", "items": NUMBER, "minItems": size, "maxItems": size}


def points(size: int, count: int | None = None) -> Fragment:
    """Points of so many numbers each: `count` of them, or however many."""
    limits = {"minItems": 1} if count is None else {"minItems": count, "maxItems": count}
    return {"type": "array", "items": vector(size), **limits}


def list_of(fragment: Fragment, count: int | None = None) -> Fragment:
    """A list; of `count` where that is given."""
    limits = {} if count is None else {"minItems": count, "maxItems": count}
    return {"type": "array", "items": fragment, **limits}


def choice(*words: str) -> Fragment:
    """One of some words."""
    return {"enum": list(words)}


def table(name: str) -> Fragment:
    """The table whose keys are listed by that name."""
    return {"$ref": _REFERENCE + name}


def either(*fragments: Fragment) -> Fragment:
    """Any of these."""
    return {"anyOf": list(fragments)}


def one_or_more(fragment: Fragment) -> Fragment:
    """One, or a list of them."""
    return either(fragment, list_of(fragment))
