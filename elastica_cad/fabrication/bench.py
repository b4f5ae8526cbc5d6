"""What the workbench needs of a batten: its size from station to station, and its side at full size."""

import numpy as np

from elastica_cad._types import ArrayLike, FloatArray
from elastica_cad._units import MM_PER_INCH
from elastica_cad._values import numbers
from elastica_cad.errors import InputError
from elastica_cad.fabrication.drawings.drawing import CUT_OUTER, MARK, Drawing, LayeredPath
from elastica_cad.fabrication.drawings.lettering import Text
from elastica_cad.fabrication.leaf_stack import LeafStack
from elastica_cad.fabrication.solids.tapered_solids import side_view
from elastica_cad.fabrication.strip.strip_record import Strip
from elastica_cad.geometry.paths.path import Path
from elastica_cad.geometry.paths.segments import Line
from elastica_cad.mechanics.rod.rod_record import csv_text

ROWS = 21
"""Stations of a batten of which none are asked for, evenly from end to end."""

DECIMALS = {"mm": 2, "inch": 3, "percent": 3, "safety": 2}
"""Of a column in the table's file, by the unit in its name: as fine as a bench works."""

LETTER_MM, TICK_MM = 4.0, 3.0


def bench_table(strip: Strip, stations: ArrayLike | None = None) -> dict[str, FloatArray]:
    """Columns (n,) by name at stations (n,), mm along a tapered strip: size in mm and inch, strain, and safety.

    Safety is what the material bears over the strain; infinite where it is not bent.

    Raises
    ------
    InputError
        The strip is of one thickness.
    """
    law, size = strip.layout.section, strip.layout.size
    if law is None or size is None:
        raise InputError("the strip is of one thickness: it has no side view; give it a law")
    asked = np.linspace(0.0, strip.rod.length, ROWS) if stations is None else numbers(stations, "stations")
    s = np.clip(asked, 0.0, strip.rod.length)
    sizes = size(s)
    (layer,) = law.strains(np.abs(strip.rod.bend_at(s)), sizes)
    strain = np.where(layer.strain < 1e-12, 0.0, layer.strain)
    safety = np.divide(layer.limit, strain, out=np.full(s.size, np.inf), where=strain > 0)
    return {
        "s_mm": s, "s_inch": s / MM_PER_INCH, f"{law.quantity}_mm": sizes,
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

    A tick at every station has its distance from the start and the size there, mm.
    """
    if strip.layout.stack:
        return LeafStack(strip).drawing
    s, _, sizes, *_ = bench_table(strip, stations).values()
    view = side_view(strip)
    top = float(view.bounds[1, 1])
    ticks = [LayeredPath(MARK, Path((Line((x, top + 1.0), (x, top + 1.0 + TICK_MM)),))) for x in s.tolist()]
    texts = tuple(
        Text((x, top + 2.0 + TICK_MM), f"{x:.1f}: {size:.2f}", LETTER_MM, np.pi / 2)
        for x, size in zip(s.tolist(), sizes.tolist(), strict=True)
    )
    return Drawing(strip.label, (*ticks, LayeredPath(CUT_OUTER, view)), texts)
