"""How tightly aircraft plywood is bent dry and cold: the published least radii along and across the face grain."""

from typing import Literal

import numpy as np

PLYWOOD_SOURCE = "FAA AC 43.13-1B, table 1-2, 10 % moisture, cold mandrels"

INCH_MM = 25.4

# thickness, radius along and across the face grain, inches as published; a strip along the grain bends across the
# table's mandrel at 90 degrees to it
ROWS_INCH = {
    3: (
        (0.035, 2.0, 1.1), (0.070, 5.2, 3.2), (0.100, 8.6, 5.2), (0.125, 12.0, 7.1), (0.155, 16.0, 10.0),
        (0.185, 20.0, 13.0),
    ),
    5: (
        (0.160, 17.0, 11.0), (0.190, 21.0, 14.0), (0.225, 27.0, 17.0), (0.250, 31.0, 20.0), (0.315, 43.0, 28.0),
        (0.375, 54.0, 36.0),
    ),
}  # fmt: skip
"""Plies: rows of the table."""

SOLD_AS = 0.02
"""Share by which a sheet may be thinner than the first row of its plies: 4 mm is sold for 0.160 in."""

TOLD_TO = 0.01
"""Share to which a radius is known: the table has two digits, and a sheet's largest strain is rounded."""

LEAST_MM, LARGEST_MM = 0.7, 9.6
"""Thicknesses that the rows speak of: a sheet of 0.8 mm takes the strain of the thinnest row, 0.89 mm."""


def least_plywood_radius(thickness: float, grain: Literal["along", "across"]) -> float | None:
    """Least radius of a dry, cold bend of aircraft plywood, mm, or None for a thickness that was not published.

    Between rows the strain of the skin is interpolated; where plywood of 3 and of 5 plies is told of, the larger
    radius counts.

    Parameters
    ----------
    thickness : float
        mm.
    grain : "along" or "across"
        How the strip lies to the face grain.

    References
    ----------
    FAA Advisory Circular 43.13-1B, Acceptable Methods, Techniques, and Practices, 1998, table 1-2.

    Examples
    --------
    >>> round(least_plywood_radius(1.778, "along"), 2), least_plywood_radius(20.0, "along")
    (132.08, None)
    """
    if not LEAST_MM <= thickness <= LARGEST_MM:
        return None
    column = 1 if grain == "along" else 2
    strains = []
    for rows in ROWS_INCH.values():
        table = INCH_MM * np.array(rows)
        inside = table[0, 0] * (1 - SOLD_AS) <= thickness <= table[-1, 0]
        thinnest, thickest = min(ROWS_INCH), max(ROWS_INCH)
        below = thickness < table[0, 0] and rows is ROWS_INCH[thinnest]
        above = thickness > table[-1, 0] and rows is ROWS_INCH[thickest]
        if inside or below or above:
            strains.append(float(np.interp(thickness, table[:, 0], table[:, 0] / (2 * table[:, column]))))
    return thickness / (2 * min(strains))
