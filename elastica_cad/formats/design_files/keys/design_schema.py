"""All tables of a design file: their keys for those who read them, and as JSON schema for editors."""

from typing import Any

from elastica_cad.formats.design_files.keys.model_keys import MODEL_TABLES, TOP
from elastica_cad.formats.design_files.keys.strip_keys import STRIP, STRIP_TABLES, fragment_of
from elastica_cad.formats.design_files.keys.values import Keys

SCHEMA_FILE = "elastica.schema.json"
"""Beside a design file, which names it in its first line."""

TABLES: dict[str, Keys] = {"design": TOP, "strips": STRIP, **STRIP_TABLES, **MODEL_TABLES}


def design_schema() -> dict[str, Any]:
    """The JSON schema (draft 4, which TOML editors know best) of design files.

    Examples
    --------
    >>> sorted(design_schema()["definitions"]["mass"]["properties"])
    ['at', 'mass']
    """
    return {
        "$schema": "http://json-schema.org/draft-04/schema#",
        "title": "Design file of elastica_cad",
        **fragment_of(TOP),
        "required": ["schema"],
        "definitions": {name: fragment_of(keys) for name, keys in TABLES.items() if name != "design"},
    }
