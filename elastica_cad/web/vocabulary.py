"""Data for the forms of the page: declared fields, sheets, and file types."""

from typing import Any

from elastica_cad.design.records import described
from elastica_cad.design.strip_table import SharedKeys
from elastica_cad.errors import how_to_install
from elastica_cad.files import step_trouble
from elastica_cad.kit.kit import can_draw
from elastica_cad.mechanics.sheets import sheets_by_kind
from elastica_cad.mechanics.stability import SAFE_MARGIN
from elastica_cad.pairs.flexure_spec import FlexureSpec
from elastica_cad.translations import catalogue
from elastica_cad.web.answers import CATALOGUES, DOWNLOADS, DROPPED
from elastica_cad.web.saved_design import OF_MODELS


def page_words() -> dict[str, Any]:
    """Return the fields, sheets and kinds of files for the page, as plain data for JSON."""
    missing = {} if can_draw() else {"pdf": how_to_install("matplotlib")}
    if trouble := step_trouble():
        missing |= {"step": trouble, "stl": trouble}
    return {
        "fields": described(SharedKeys),
        "pair_fields": [
            entry for entry in described(FlexureSpec) if entry["name"] not in ("first", "second", "scale")
        ],
        "words": {  # omit texts with placeholders, because the page cannot insert values
            language: {text: translation for text, translation in catalogue(name).items() if "{" not in text}
            for language, name in CATALOGUES.items()
        },
        "sheets": [
            [kind, [[sheet.name, sheet.full_name] for sheet in sheets]]
            for kind, sheets in sheets_by_kind().items()
        ],
        "dropped": DROPPED,
        "downloads": [kind for kind in DOWNLOADS if kind not in missing],
        "missing": missing,
        "model_keys": OF_MODELS,
        "nearest": {"margin": SAFE_MARGIN},
    }
