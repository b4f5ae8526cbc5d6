"""What the page makes its forms of: fields as they are declared, sheets, and the files that can be made."""

from importlib.util import find_spec
from typing import Any

from elastica_cad.fabrication.flexure_spec import FlexureSpec
from elastica_cad.files import step_trouble
from elastica_cad.formats.design_files.records import described
from elastica_cad.formats.design_files.strip_table import SharedKeys
from elastica_cad.mechanics.material.sheet import Sheet, sheet_names
from elastica_cad.web.answers import DOWNLOADS


def page_words() -> dict[str, Any]:
    """Return fields, sheets and kinds of file for the page, as plain data for JSON."""
    without = {"pdf"} if find_spec("matplotlib") is None else set()
    without |= {"step", "stl"} if step_trouble() else set()
    return {
        "fields": described(SharedKeys),
        "pair_fields": [one for one in described(FlexureSpec) if one["name"] not in ("first", "second")],
        "sheets": [{"name": one.name, "thickness": one.thickness} for one in map(Sheet.named, sheet_names())],
        "downloads": [kind for kind in DOWNLOADS if kind not in without],
    }
