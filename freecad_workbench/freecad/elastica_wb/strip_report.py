# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""The report on a displayed strip in rows, as the command line prints it."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from freecad.elastica_wb.features.strip import shown_nearest, shown_strip
from freecad.elastica_wb.host.refusal import FAILURES
from freecad.elastica_wb.solving.strip_cache import judged

from elastica_cad.report_rows import Row, in_order
from elastica_cad.strip import summary

FAILING = {
    "Size": {"Length", "NarrowestWidth"},
    "Strain": {"LargestStrain"},
    "Stability": {"Margin", "SidewaysMargin"},
}
"""Results that a row shows, by the label of the row. A result beyond its limit makes the row an error."""

IN_MESSAGE = ("Warning", "Note")
"""Labels of rows that are omitted, because the message above the rows has their text."""


def strip_rows(obj: Any) -> Sequence[Row]:
    """Return the rows of the report on the displayed strip, or () if the strip cannot be computed."""
    try:
        strip, near = shown_strip(obj), shown_nearest(obj)
        verdict = judged(strip.rod)
        waits = verdict is None or not (obj.Held or summary.not_computed_row(strip))
        rows = summary.strip_rows(strip, near, verdict, quick=waits)
    except FAILURES:
        return ()
    fails = {*obj.Fails}
    return in_order(
        [
            replace(row, severity="error") if fails & FAILING.get(row.label, set()) else row
            for row in rows
            if row.label not in IN_MESSAGE
        ]
    )
