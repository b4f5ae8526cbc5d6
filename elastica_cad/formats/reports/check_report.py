"""The verdict on a curve as plain data, and numbers as all reports round them."""

from dataclasses import asdict
from typing import Any

import numpy as np

from elastica_cad._values import require_record
from elastica_cad.mechanics.theorem1.verdict import EquilibriumCheck


def report_check(check: EquilibriumCheck) -> dict[str, Any]:
    """Return the verdict of Theorem 1 as plain data; places in mm along the curve."""
    require_record(check, EquilibriumCheck, "what is reported", "what check_equilibrium answers")
    return {
        "realizable": check.realizable,
        "reasons": list(check.reasons),
        "warnings": list(check.warnings),
        "inflections": round_numbers(check.inflections),
        "undecided": None if check.undecided is None else asdict(check.undecided),
        "advice": str(check),
    }


def round_numbers(value: Any) -> Any:
    """Ten significant digits: more would be noise, and the same design must give the same file."""
    array = np.asarray(value, dtype=float)
    if array.ndim == 0:
        return float(f"{float(array):.10g}")
    return [round_numbers(row) for row in array]
