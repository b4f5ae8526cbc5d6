"""Columns of numbers as comma-separated text."""

from collections.abc import Mapping
from typing import Any

import numpy as np

from elastica_cad._types import FloatArray

DUST_SHARE = 1e-12
"""Of the largest value of the same unit: what rounding leaves of 0."""


def csv_text(table: Mapping[str, Any]) -> str:
    """Columns (n,) by name as comma-separated text with a header; names end in their unit.

    Examples
    --------
    >>> print(csv_text({"x_mm": [0, 1], "y_mm": [1e-17, 2]}), end="")
    x_mm,y_mm
    0,0
    1,2
    """
    columns = {name: np.asarray(column, dtype=float) for name, column in table.items()}
    largest: dict[str, float] = {}
    for name, column in columns.items():
        finite = np.abs(column[np.isfinite(column)])
        largest[_unit(name)] = max(largest.get(_unit(name), 0.0), float(finite.max(initial=0.0)))
    cleaned: dict[str, FloatArray] = {
        name: np.where(np.abs(column) <= DUST_SHARE * largest[_unit(name)], 0.0, column)
        for name, column in columns.items()
    }
    rows = [",".join(cleaned)]
    rows += [",".join(f"{value:.9g}" for value in row) for row in zip(*cleaned.values(), strict=True)]
    return "\n".join(rows) + "\n"


def _unit(name: str) -> str:
    return name.rsplit("_", 1)[-1]
