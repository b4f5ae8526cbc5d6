"""What the workbench needs of a batten: its size from station to station, and its side at full size."""

from textwrap import wrap

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._units import MM_PER_INCH
from elastica_cad._values import numbers
from elastica_cad.errors import InputError
from elastica_cad.fabrication.drawings.drawing import CUT_OUTER, MARK, Drawing, LayeredPath
from elastica_cad.fabrication.drawings.lettering import Text, engravable
from elastica_cad.fabrication.holders.holding_template import tell_ends
from elastica_cad.fabrication.leaf_stack import LeafStack
from elastica_cad.fabrication.solids.tapered_solids import side_view
from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.segments import Line
from elastica_cad.mechanics.rod.rod_record import csv_text

ROWS = 21
"""Stations of a batten of which none are asked for, evenly from end to end of its free part."""

DECIMALS = {"mm": 2, "inch": 3, "percent": 3, "safety": 2}
"""Of a column in the table's file, by the unit in its name: as fine as a bench works."""

LETTER_MM, TICK_MM = 4.0, 3.0
LINE_MM, LETTERS = 1.8 * LETTER_MM, 46
"""Of what is written below a side view: distance of its lines, and letters in one, which a page of A4 holds."""


def bench_table(strip: Strip, stations: ArrayLike | None = None) -> dict[str, FloatArray]:
    """Columns (n,) by name at stations (n,), mm along a tapered strip: size in mm and inch, strain, and safety.

    Stations count from where the bend begins, and each has its distance from the tip of the first tab. Where none
    are asked for, both tips are among them. Safety is what the material bears over the strain; infinite
    where it is not bent.

    Raises
    ------
    InputError
        The strip is of one thickness.
    """
    law, size = strip.layout.section, strip.layout.size
    if law is None or size is None:
        raise InputError("the strip is of one thickness: it has no side view; give it a law")
    first, last = (tab.length for tab in strip.ends)
    tips = -first, strip.rod.length + last
    evenly = np.unique([*tips, *np.linspace(0.0, strip.rod.length, ROWS)])
    s = np.clip(evenly if stations is None else numbers(stations, "stations"), *tips)
    bent = np.clip(s, 0.0, strip.rod.length)
    sizes = size(bent)
    (layer,) = law.strains(np.abs(strip.rod.bend_at(bent)), sizes)
    strain = np.where((layer.strain < 1e-12) | (s != bent), 0.0, layer.strain)
    safety = np.divide(layer.limit, strain, out=np.full(s.size, np.inf), where=strain > 0)
    return {
        "s_mm": s, "s_inch": s / MM_PER_INCH,
        "from_tip_mm": s + first, "from_tip_inch": (s + first) / MM_PER_INCH, f"{law.quantity}_mm": sizes,
        f"{law.quantity}_inch": sizes / MM_PER_INCH, "strain": strain, "safety": safety,
    }  # fmt: skip


def bench_csv(strip: Strip, stations: ArrayLike | None = None) -> str:
    """The table as comma-separated text, the strain in percent, without a safety where nothing is bent; of leaves
    their cut list.
    """
    if strip.layout.stack:
        return LeafStack(strip).cut_list.csv
    table = bench_table(strip, stations)
    *sizes, (_, strain), safety = table.items()
    columns = dict([*sizes, ("strain_percent", 100 * strain), safety])
    rounded = {name: column.round(DECIMALS[name.rsplit("_", 1)[-1]]) for name, column in columns.items()}
    return csv_text(rounded).replace(",inf", ",")


def bench_drawing(strip: Strip, stations: ArrayLike | None = None) -> Drawing:
    """The side view at full size; of leaves their pattern.

    A tick at every station has its distance from the tip and the size there, mm; the lines below say what it is
    made of and how its ends are held.
    """
    if strip.layout.stack:
        return LeafStack(strip).drawing
    s, _, far, _, sizes, *_ = bench_table(strip, stations).values()
    view = side_view(strip)
    (left, low), (_, top) = view.bounds.tolist()
    ticks = [LayeredPath(MARK, Path((Line((x, top + 1.0), (x, top + 1.0 + TICK_MM)),))) for x in s.tolist()]
    texts = tuple(
        Text((x, top + 2.0 + TICK_MM), f"{tip:.1f}: {size:.2f}", LETTER_MM, np.pi / 2)
        for x, tip, size in zip(s.tolist(), far.tolist(), sizes.tolist(), strict=True)
    )
    told = tuple(
        Text((left, low - LINE_MM * row), line, LETTER_MM, 0.0, MARK)
        for row, line in enumerate(_told(strip), start=1)
    )
    return Drawing(strip.label, (*ticks, LayeredPath(CUT_OUTER, view)), (*texts, *told))


def _told(strip: Strip) -> list[str]:
    """The lines below a side view."""
    law, sheet = strip.layout.section, strip.sheet
    flat = law is not None and law.quantity == "thickness"
    stock = sheet.full_name.removesuffix(f" {sheet.thickness:g} mm")  # a sheet is given for its wood
    wide = f"{stock}, {strip.width.extremes[1]:g} mm wide: plane both faces alike"
    told = wide if flat else f"{stock}, round: turn it to the diameters"
    ticks = "full size, seen from the side; at a tick: mm from this tip, and the size there"
    said = strip.label or "batten", told, str(tell_ends(strip)), ticks
    return [engravable(line) for one in said for line in wrap(one, LETTERS)]
