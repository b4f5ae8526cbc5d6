"""The report of a verdict, and the numbers of all reports: light enough for a command that only checks."""

from typing import Any

import numpy as np

from elastica_cad._values import require_record
from elastica_cad.mechanics.theorem1.verdict import EquilibriumCheck


def report_check(check: EquilibriumCheck) -> dict[str, Any]:
    """Theorem 1's answer as plain data; places in mm along the curve."""
    require_record(check, EquilibriumCheck, "what is reported", "what check_equilibrium answers")
    return {
        "realizable": check.realizable,
        "reasons": list(check.reasons),
        "warnings": list(check.warnings),
        "inflections": round_numbers(check.inflections),
        "advice": str(check),
    }


def round_numbers(value: Any) -> Any:
    """Ten significant digits: more would be noise, and the same design must give the same file."""
    array = np.asarray(value, dtype=float)
    if array.ndim == 0:
        return float(f"{float(array):.10g}")
    return [round_numbers(row) for row in array]
