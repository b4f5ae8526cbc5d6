"""What the page makes its forms of: fields as they are declared, sheets, and the files that can be made."""

from importlib.util import find_spec
from typing import Any

from elastica_cad.fabrication.flexure_spec import FlexureSpec
from elastica_cad.files import step_trouble
from elastica_cad.formats.design_files.records import described
from elastica_cad.formats.design_files.strip_table import SharedKeys
from elastica_cad.mechanics.material.sheet import sheets_by_kind
from elastica_cad.web.answers import DOWNLOADS


def page_words() -> dict[str, Any]:
    """Fields, sheets and files, ready for JSON."""
    without = {"pdf"} if find_spec("matplotlib") is None else set()
    without |= {"step", "stl"} if step_trouble() else set()
    return {
        "fields": described(SharedKeys),
        "pair_fields": [one for one in described(FlexureSpec) if one["name"] not in ("first", "second")],
        "sheets": [
            [kind, [[one.name, one.full_name] for one in sheets]] for kind, sheets in sheets_by_kind().items()
        ],
        "downloads": [kind for kind in DOWNLOADS if kind not in without],
    }
