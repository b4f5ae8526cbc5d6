"""Result of `check_equilibrium` as plain data: the first part of the record that `cli/check_command` completes."""

from dataclasses import asdict
from typing import Any, TypeAlias

from elastica_cad._values import plain_data, require_record
from elastica_cad.mechanics.theorem1 import EquilibriumCheck

PlainData: TypeAlias = dict[str, Any]
"""Plain data for JSON: values by key."""


def report_check(check: EquilibriumCheck) -> PlainData:
    """Return the result of the check (Theorem 1 of the paper) as plain data.

    Positions are in mm along the curve.
    """
    require_record(check, EquilibriumCheck, "what is reported", "what check_equilibrium answers")
    return {
        "realizable": check.realizable,
        "reasons": list(check.reasons),
        "warnings": list(check.warnings),
        "inflections": plain_data(check.inflections),
        "undecided": None if check.undecided is None else asdict(check.undecided),
        "advice": str(check),
    }
