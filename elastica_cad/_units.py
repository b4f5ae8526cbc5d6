"""Units of length in mm, what an inch is, and numbers as rulers have them."""

import re

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


_FRACTION = re.compile(r"\s*(?:(\d+)[ -])?(\d+)/([1-9]\d*)\s*")
_OFFSET = re.compile(r"([-+]?)(\d+)-(\d+)-([0-7])(\+?)")


def read_number(text: str) -> float:
    """Of digits, or of a fraction as on a folding rule: "5/16", "1 3/8", "1-3/8".

    Raises
    ------
    ValueError
        Other text.

    Examples
    --------
    >>> read_number("12.5"), read_number("3 1/2")
    (12.5, 3.5)
    """
    parts = _FRACTION.fullmatch(text)
    return float(text) if parts is None else int(parts[1] or 0) + int(parts[2]) / int(parts[3])


def read_offset(text: str) -> float | None:
    """Inches of feet, inches and eighths, as tables of offsets have them; a plus behind them is a sixteenth more.

    None of any other text.

    Examples
    --------
    >>> read_offset("3-4-5"), read_offset("0-0-5+"), read_offset("3.5")
    (40.625, 0.6875, None)
    """
    parts = _OFFSET.fullmatch(text)
    if parts is None:
        return None
    inches = 12 * int(parts[2]) + int(parts[3]) + int(parts[4]) / 8 + bool(parts[5]) / 16
    return -inches if parts[1] == "-" else inches


def is_in_inches(text: str) -> bool:
    """Is it written as only inches are: a fraction, or feet, inches and eighths?"""
    return _FRACTION.fullmatch(text) is not None or read_offset(text) is not None
