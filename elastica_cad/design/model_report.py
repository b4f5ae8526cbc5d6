"""Report of a model: its results as plain data, and an HTML page that lists its files."""

from collections.abc import Mapping, Sequence
from pathlib import PurePosixPath
from typing import Any
from urllib.parse import quote

from elastica_cad._text import html_text
from elastica_cad._values import plain_data, require_record
from elastica_cad.design.reports import (
    UNITS,
    list_versions,
    report_held,
    report_measuring,
    strip_quantities,
)
from elastica_cad.design.strip_table import StripEntry
from elastica_cad.geometry.path import largest_deviation
from elastica_cad.model.cut_rows import CutList
from elastica_cad.model.model import Model
from elastica_cad.model.nesting import NestedSheet
from elastica_cad.strip.held_shape import HeldShape
from elastica_cad.strip.strip import Strip

MODEL_SCHEMA = "elastica-model/1"


def report_model(
    model: Model,
    *,
    cut_list: CutList,
    nests: Sequence[NestedSheet],
    files: Mapping[str, str],
    held: Mapping[str, HeldShape] | None,
    entries: Sequence[StripEntry] = (),
) -> dict[str, Any]:
    """Return the report of a model as plain data for JSON.

    Parameters
    ----------
    model : Model
    cut_list : CutList
        All pieces.
    nests : sequence of NestedSheet
    files : mapping
        Description of each file, by file name.
    held : mapping or None
        Shapes of the strips as cut, in their holders, by name. If None, the report has no quantities to measure.
    entries : sequence of StripEntry
        Entries of the strips in the design. The report gives the deviations of the strips from their curves.
    """
    require_record(model, Model, "the model", "a Model")
    require_record(cut_list, CutList, "the cut list", "a CutList, as model.cut_list() makes one")
    for value, what in ((files, "files"), (held or {}, "held")):
        require_record(value, Mapping, what, "a mapping from names")
    drawn = {entry.label: entry for entry in entries}
    report: dict[str, Any] = plain_data({
        "schema": MODEL_SCHEMA,
        "name": model.name,
        "versions": list_versions(),
        "units": UNITS,
        "strips": len(model.placed),
        "parts": [
            {
                **strip_quantities(part.strip),
                "sheet": part.strip.sheet.name,
                "largest_strain": part.strip.max_strain,
                "slots": len(part.strip.slots),
                "warnings": list(part.strip.warnings),
                **(_deviations(part.strip, drawn[part.strip.label]) if part.strip.label in drawn else {}),
                "name": part.name,
                "engraved": part.strip.engraved,
                "count": part.count,
                "measuring": None if held is None else report_measuring(part.strip),
            }
            for part in model.parts
        ],
        "held": {name: report_held(shape) for name, shape in (held or {}).items()},
        "joints": [
            {
                "strips": [model.single_name_of(i) for i in joint.members],
                "angle": joint.angle,
                "position": joint.position,
            }
            for joint in model.joints
        ],
        "sheets": [
            {
                "drawing": nest.name,
                "size": nest.sheet_size,
                "pieces": nest.counts,
                "grain": nest.grain,
                "filled": nest.filled / nest.used,
                "share": nest.share,
            }
            for nest in nests
        ],
        "pieces": cut_list.count,
        "cut_length": cut_list.cut_length,
        "mass": cut_list.mass,
        "blocks": [
            {
                "name": row.part,
                "size": [row.length, row.width, row.thickness],
                "count": row.count,
                "color": row.color,
            }
            for row in cut_list.printed
        ],
        "stock": [
            {
                "sheet": item.sheet,
                "size": item.size,
                "count": item.count,
                "sawn": list(item.sawn),
            }
            for item in cut_list.stock
        ],
        "reports": list(model.reports),
        "files": dict(files),
    })  # fmt: skip
    return report


def _deviations(strip: Strip, entry: StripEntry) -> dict[str, Any]:
    # distance, mm, of the strip from its drawn curve and, for a section, of this curve from the section
    deviation = largest_deviation(entry.curve, strip.rod.curve)
    if not entry.section:
        return {"deviation": deviation}
    return {"deviation": deviation, "section": entry.section, "curve_off_section": entry.off_section}


STYLE = (
    "body{font:15px/1.5 sans-serif;max-width:62rem;margin:2rem auto;padding:0 1rem;color:#1f2430}"
    "img{max-width:100%;border:1px solid #ddd}figure{margin:1rem 0}"
    "td,th{padding:.15rem .8rem .15rem 0;text-align:left}"
)


def compose_start_page(
    name: str, lines: Sequence[str], notes: Sequence[str], files: Mapping[str, str]
) -> str:
    """Return the start page of a kit in HTML, with a summary, notes and links to the files.

    Parameters
    ----------
    name : str
        Name of the model.
    lines : sequence of str
        Summary of the model, in a few sentences.
    notes : sequence of str
        Messages to read before cutting.
    files : mapping
        Description of each file, by its path with /. Pictures are displayed.

    Examples
    --------
    >>> page = compose_start_page("arch", ["1 strip"], [], {"sheets/arch 1.dxf": "nested sheet"})
    >>> '<a href="sheets/arch%201.dxf">' in page
    True
    """
    pictures = [file for file in files if file.endswith(".png")]
    listed_files = "".join(
        f'<figure><a href="{quote(file)}"><img src="{quote(file)}" alt="{html_text(files[file])}"></a>'
        f"<figcaption>{html_text(files[file])}: {html_text(PurePosixPath(file).name)}</figcaption></figure>"
        for file in pictures
    )
    rows = "".join(
        f'<tr><td><a href="{quote(file)}">{html_text(file)}</a></td><td>{html_text(what)}</td></tr>'
        for file, what in files.items()
        if file not in pictures
    )
    paragraphs = "".join(f"<p>{html_text(line)}</p>" for line in lines)
    warned = "".join(f"<li>{html_text(note)}</li>" for note in notes)
    return (
        f'<!doctype html><html lang="en"><head><meta charset="utf-8"><title>{html_text(name)}</title>'
        f"<style>{STYLE}</style></head><body><h1>{html_text(name)}</h1>{paragraphs}"
        f"{f'<h2>Before you cut</h2><ul>{warned}</ul>' if warned else ''}{listed_files}"
        f"<h2>Files</h2><table><tr><th>file</th><th>what it is</th></tr>{rows}</table></body></html>\n"
    )
