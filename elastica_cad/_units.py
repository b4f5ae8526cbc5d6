"""Units of length in mm: what an inch is, and the units that files, options and formulae may name."""

from elastica_cad.errors import InputError

MM_PER_INCH = 25.4

MILLIMETRES = {
    "mm": 1.0,
    "cm": 10.0,
    "dm": 100.0,
    "m": 1000.0,
    "um": 0.001,
    "in": MM_PER_INCH,
    "ft": 304.8,
    "px": MM_PER_INCH / 96,
    "pt": MM_PER_INCH / 72,
}
"""Millimetres in one of each unit that a file or an option may name; px is the pixel of CSS, pt the DTP point."""


def look_up_unit(unit: str) -> float:
    """Millimetres in one `unit`.

    Raises
    ------
    InputError
        A unit that is not known.

    Examples
    --------
    >>> look_up_unit("ft")
    304.8
    """
    if unit not in MILLIMETRES:
        raise InputError(
            "unknown unit {unit!r}: use one of {millimetres}", unit=unit, millimetres=", ".join(MILLIMETRES)
        )
    return MILLIMETRES[unit]
