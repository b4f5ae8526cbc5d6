"""Keys of all tables of a design file, and the JSON schema with which editors check them."""

from functools import cache
from typing import Any, TypeAlias

from elastica_cad.declared import Field, Kind, Record
from elastica_cad.design.model_tables import DesignKeys
from elastica_cad.design.records import fields_of, help_with_unit, tables_in, title, word_of, written

SCHEMA_FILE = "elastica.schema.json"
"""Name of the schema file, which the first line of a design file in the same folder states."""

Fragment: TypeAlias = dict[str, Any]
Keys: TypeAlias = dict[str, tuple[Fragment, str]]
"""JSON schema and description of each key."""

_PLAIN: dict[str, Fragment] = {
    "number": {"type": ["number", "string"]},  # a formula is a string
    "count": {"type": ["integer", "string"]},
    "flag": {"type": "boolean"},
    "text": {"type": "string"},
}


@cache
def tables() -> dict[str, Keys]:
    """Return the keys of every table, by the name of the table. The top level of the file is "design".

    Examples
    --------
    >>> tables()["point mass"]["mass"][1]
    'Mass hung at this place (g).'
    """
    records: dict[str, Record] = {"design": DesignKeys}
    waiting: list[Record] = [DesignKeys]
    while waiting:
        for entry in fields_of(waiting.pop()):
            for inner in tables_in(written(entry.kind)):
                if title(inner) not in records:
                    records[title(inner)] = inner
                    waiting.append(inner)
    return {name: _keys(record) for name, record in records.items()}


def _keys(record: Record) -> Keys:
    # the key `kind` of a family has the word that selects this record, with the first sentence of its docstring
    word = word_of(record)
    kinds: Keys = (
        {} if word is None else {"kind": ({"enum": [word]}, str(record.__doc__).partition(".")[0] + ".")}
    )
    return kinds | {entry.name: _entry(entry) for entry in fields_of(record)}


@cache
def _entry(field: Field) -> tuple[Fragment, str]:
    return fragment(written(field.kind)), help_with_unit(field.help, field.option.unit)


def fragment(kind: Kind) -> Fragment:
    """Return the JSON schema for a kind of value."""
    if kind.name in _PLAIN:
        return _PLAIN[kind.name]
    if kind.name == "choice":
        return {"enum": list(kind.choices)}
    if kind.record is not None:
        return {"$ref": f"#/definitions/{title(kind.record)}"}
    inner = [fragment(written(part)) for part in kind.of]
    if kind.name == "names":
        return {"type": "object", "additionalProperties": inner[0]}
    if kind.name == "either":
        return {"anyOf": inner}
    limits = {"minItems": 0} if kind.size is None else {"minItems": kind.size, "maxItems": kind.size}
    return {"type": "array", "items": inner[0], **limits}


def _table(keys: Keys) -> Fragment:
    # draft 4 ignores a description beside $ref, so the reference is inside allOf
    return {
        "type": "object",
        "additionalProperties": False,
        "properties": {
            key: {"description": text, **({"allOf": [value]} if "$ref" in value else value)}
            for key, (value, text) in keys.items()
        },
    }


def design_schema() -> dict[str, Any]:
    """Return the JSON schema (draft 4, best supported by TOML editors) of design files.

    Examples
    --------
    >>> sorted(design_schema()["definitions"]["point mass"]["properties"])
    ['at', 'mass']
    """
    return {
        "$schema": "http://json-schema.org/draft-04/schema#",
        "title": "Design file of elastica_cad",
        **_table(tables()["design"]),
        "definitions": {name: _table(keys) for name, keys in tables().items() if name != "design"},
    }
