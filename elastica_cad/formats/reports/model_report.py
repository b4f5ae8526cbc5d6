"""The report of a model: its strips, joints, sheets and files as one JSON record."""

from collections.abc import Mapping, Sequence
from typing import Any

from elastica_cad._values import require_record
from elastica_cad.fabrication.holding.held_shape import HeldShape
from elastica_cad.fabrication.model.strip_model import Model
from elastica_cad.fabrication.sheets.cut_list import CutList
from elastica_cad.fabrication.sheets.nesting import NestedSheet
from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.formats.design_files.strip_table import StripEntry
from elastica_cad.formats.reports.bent_blank import report_blank
from elastica_cad.formats.reports.check_report import round_numbers
from elastica_cad.formats.reports.strip_report import list_versions, report_held
from elastica_cad.geometry.paths.point_distance import largest_deviation

MODEL_SCHEMA = "elastica-model/1"


def report_model(
    model: Model,
    *,
    cut_list: CutList,
    nests: Sequence[NestedSheet],
    files: Mapping[str, str],
    held: Mapping[str, HeldShape],
    entries: Sequence[StripEntry] = (),
) -> dict[str, Any]:
    """The report of a model, ready for JSON.

    Parameters
    ----------
    model : Model
    cut_list : CutList
        All pieces.
    nests : sequence of NestedSheet
    files : mapping
        What each file is, by its name.
    held : mapping
        The shapes of strips as made and held, by their names.
    entries : sequence of StripEntry
        What the strips were made after; the report says how far they are from it.
    """
    require_record(model, Model, "the model", "a Model")
    require_record(cut_list, CutList, "the cut list", "a CutList, as model.cut_list() makes one")
    for value, what in ((files, "files"), (held, "held")):
        require_record(value, Mapping, what, "a mapping from names")
    drawn = {entry.label: entry for entry in entries}
    return {
        "schema": MODEL_SCHEMA,
        "name": model.name,
        "versions": list_versions(),
        "units": {
            "length": "mm",
            "curvature": "1/mm",
            "strain": "1",
            "mass": "g",
            "area": "mm2",
            "angle": "rad",
        },
        "strips": len(model.placed),
        "parts": [
            {
                **_strip(part.strip),
                **(_departure(part.strip, drawn[part.strip.label]) if part.strip.label in drawn else {}),
                "name": part.name,
                "count": part.count,
            }
            for part in model.parts
        ],
        "held": {name: report_held(shape) for name, shape in held.items()},
        "joints": [
            {
                "strips": [model.single_name_of(i) for i in joint.members],
                "angle": round_numbers(joint.angle),
                "position": round_numbers(joint.position),
            }
            for joint in model.joints
        ],
        "sheets": [
            {
                "drawing": nest.name,
                "size": round_numbers(nest.sheet_size),
                "pieces": nest.counts,
                "grain": nest.grain,
                "filled": round_numbers(nest.filled / nest.used),
                "share": round_numbers(nest.share),
            }
            for nest in nests
        ],
        "pieces": cut_list.count,
        "cut_length": round_numbers(cut_list.cut_length),
        "mass": round_numbers(cut_list.mass),
        "reports": list(model.reports),
        "files": dict(files),
    }


def _departure(strip: Strip, entry: StripEntry) -> dict[str, Any]:
    """How far the strip's shape is from the curve it was made after, and that from its section, mm."""
    found = strip.rod.curve
    told: dict[str, Any] = {"deviation": round_numbers(largest_deviation(entry.curve, found))}
    if entry.section:
        told |= {"section": entry.section, "curve_off_section": round_numbers(entry.off_section)}
    return told


def _strip(strip: Strip) -> dict[str, Any]:
    low, high = strip.width.extremes
    return {
        "sheet": strip.sheet.name,
        "length": round_numbers(strip.rod.length),
        "ratio": round_numbers(strip.rod.ratio),
        "width": {"least": round_numbers(low), "largest": round_numbers(high)},
        "largest_strain": round_numbers(strip.max_strain),
        "mass": round_numbers(strip.mass),
        "blank": report_blank(strip),
        "slots": len(strip.slots),
        "warnings": list(strip.warnings),
    }
