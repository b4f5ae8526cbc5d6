"""What the page makes its forms of: fields as they are declared, sheets, and the files that can be made."""

from collections.abc import Iterator
from importlib.util import find_spec
from typing import Any

from elastica_cad.design.records import described
from elastica_cad.design.strip_table import SharedKeys
from elastica_cad.files import step_trouble
from elastica_cad.mechanics.sheets import sheets_by_kind
from elastica_cad.pairs.flexure_spec import FlexureSpec
from elastica_cad.refusals import Wording
from elastica_cad.web.answers import DOWNLOADS
from elastica_cad.web.worker import wording_of


def page_words() -> dict[str, Any]:
    """Return fields, sheets and kinds of file for the page, as plain data for JSON."""
    without = {"pdf"} if find_spec("matplotlib") is None else set()
    without |= {"step", "stl"} if step_trouble() else set()
    fields = described(SharedKeys)
    pair_fields = [one for one in described(FlexureSpec) if one["name"] not in ("first", "second")]
    helps = set(_helps([fields, pair_fields]))
    return {
        "fields": fields,
        "pair_fields": pair_fields,
        "helps": {language: _translated(helps, wording_of(language)) for language in ("de", "zh")},
        "sheets": [
            [kind, [[one.name, one.full_name] for one in sheets]] for kind, sheets in sheets_by_kind().items()
        ],
        "downloads": [kind for kind in DOWNLOADS if kind not in without],
    }


def _helps(described: Any) -> Iterator[str]:
    """What is said of fields, and of those in their tables."""
    if isinstance(described, dict) and "help" in described:
        yield described["help"]
    if isinstance(described, dict | list):
        for one in described.values() if isinstance(described, dict) else described:
            yield from _helps(one)


def _translated(helps: set[str], words: Wording) -> dict[str, str]:
    return {text: said for text in helps if (said := words.template(text)) != text}
