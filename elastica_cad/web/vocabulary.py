"""What the page makes its forms of: fields as they are declared, sheets, and the files that can be made."""

from importlib.util import find_spec
from typing import Any

from elastica_cad.declared import Field, Kind, Record
from elastica_cad.fabrication.flexure_spec import FlexureSpec
from elastica_cad.files import step_trouble
from elastica_cad.formats.design_files.records import fields_of, title, word_of, written
from elastica_cad.formats.design_files.strip_table import SharedKeys
from elastica_cad.mechanics.material.sheet import Sheet, sheet_names
from elastica_cad.web.answers import DOWNLOADS


def page_words() -> dict[str, Any]:
    """Fields, sheets and files, ready for JSON."""
    without = {"pdf"} if find_spec("matplotlib") is None else set()
    without |= {"step", "stl"} if step_trouble() else set()
    return {
        "fields": _form_of(SharedKeys),
        "pair_fields": [one for one in _form_of(FlexureSpec) if one["name"] not in ("first", "second")],
        "sheets": [{"name": one.name, "thickness": one.thickness} for one in map(Sheet.named, sheet_names())],
        "downloads": [kind for kind in DOWNLOADS if kind not in without],
    }


def _form_of(record: Record) -> list[dict[str, Any]]:
    """The fields of a table, each with its name, words, unit, bounds, default, and what its value may be.

    Examples
    --------
    >>> (ratio,) = [one for one in _form_of(SharedKeys) if one["name"] == "limits"][0]["of"][0]["fields"][:1]
    >>> ratio["name"], ratio["least"], [one["kind"] for one in ratio["of"]]
    ('ratio', 1, ['number'])
    """
    return [_field(one) for one in fields_of(record)]


def _field(field: Field) -> dict[str, Any]:
    asked, default = field.asked, field.default
    return {
        "name": field.name,
        "help": asked.help,
        "unit": asked.unit,
        "least": asked.least,
        "most": asked.most,
        "group": asked.group,
        "common": asked.common,
        "default": default if isinstance(default, bool | int | float | str) else None,
        "of": [_value(one) for one in written(field.kind).alternatives],
    }


def _value(kind: Kind) -> dict[str, Any]:
    """One of the things that a value may be."""
    told: dict[str, Any] = {"kind": kind.name, "choices": list(kind.choices), "size": kind.size}
    if kind.name == "table" and kind.record is not None:
        word = word_of(kind.record)
        return told | {
            "title": word or title(kind.record),
            "tagged": word is not None,
            "fields": _form_of(kind.record),
        }
    return told | {"of": [_value(written(one)) for one in kind.of]}
