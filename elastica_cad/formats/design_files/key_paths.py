"""Keys of nested tables by their path, such as `limits.ratio`."""

from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from typing import Any

from elastica_cad.declared import Field, Kind, Record
from elastica_cad.errors import RENAMED, InputError, near_names, quoted
from elastica_cad.formats.design_files.records import fields_of, word_of, written


@cache
def paths_of(record: Record) -> Mapping[str, Field]:
    """Return all keys below a record by their dotted paths; keys of a table in a list follow the name of the list.

    Examples
    --------
    >>> from elastica_cad.fabrication.strip_spec import StripSpec
    >>> paths_of(StripSpec)["limits.ratio"].asked.least, "slots.at" in paths_of(StripSpec)
    (1, True)
    """
    found: dict[str, Field] = {}
    for path, entry in _walked(record):
        found.setdefault(path, entry)
    return found


def _walked(record: Record) -> Iterator[tuple[str, Field]]:
    without = getattr(record, "WITHOUT", ())
    for one in fields_of(record):
        if one.name in without:
            continue
        yield one.name, one
        for inner in _tables(written(one.kind)):
            if word := word_of(inner):
                yield (
                    f"{one.name}.kind",
                    Field("kind", Kind("choice", choices=_words(one.kind)), one.asked, word),
                )
            for path, entry in _walked(inner):
                yield f"{one.name}.{path}", entry


def _tables(kind: Kind) -> list[Record]:
    found = [inner for one in kind.of for inner in _tables(written(one))]
    return [*found, *([kind.record] if kind.record is not None else [])]


def _words(kind: Kind) -> tuple[str, ...]:
    """The words of the kinds that a table may have."""
    return tuple(word for one in written(kind).alternatives if one.record and (word := word_of(one.record)))


def put(table: dict[str, Any], path: str, value: Any) -> None:
    """Set the value at a dotted path of nested tables, and make the tables on the way.

    Raises
    ------
    InputError
        On the way there stands something that is no table.
    """
    *way, last = path.split(".")
    for key in way:
        inner = table.setdefault(key, {})
        if not isinstance(inner, dict):
            raise InputError(
                "{key} is {inner}, and {path} asks for a table: give one of them",
                key=key,
                inner=quoted(inner),
                path=path,
            )
        table = inner
    table[last] = value


def require_path_of(path: str, record: Record) -> Field:
    """Return the field at a dotted path.

    Raises
    ------
    InputError
        There is none; the message names the nearest.
    """
    known = paths_of(record)
    if RENAMED.get(path) in known:
        raise InputError("{old} is now called {new}", old=path, new=RENAMED[path])
    if path not in known:
        near = near_path(path, known)
        hint = f"did you mean {near}?" if near else "`elastica help` lists them"
        raise InputError("there is no key {path}: {hint}", path=quoted(path), hint=hint)
    return known[path]


def near_path(path: str, known: Iterable[str]) -> str:
    """Return the known path that was probably meant: one with the same last name, else the nearest, else ""."""
    ends = {one.rpartition(".")[2]: one for one in reversed(list(known))}
    last = path.rpartition(".")[2]
    near = near_names(path, known) or near_names(last, ends)
    return ends.get(last) or (near[0] if near and near[0] in known else ends.get(near[0], "") if near else "")
