"""Units of length, and parsing of numbers with fractions, feet and inches."""

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
"""Size in mm of each unit in files and options. px is the CSS pixel, and pt is the DTP point."""


_WORDS = {
    "mm": "millimet(?:er|re)s?|millimètres?|milímetros?|毫米",
    "cm": "centimet(?:er|re)s?|zentimeter|centimètres?|centímetros?|厘米",
    "dm": "decimet(?:er|re)s?|dezimeter|décimètres?|分米",
    "m": "met(?:er|re)s?|mètres?|metros?|米",
    "um": "[µμ]m|micromet(?:er|re)s?|mikrometer|microns?|微米",
    "in": "in\\.|inch|inches|zoll|pouces?|pulgadas?|英寸|\"|″|”|''",
    "ft": "ft\\.|foot|feet|fu(?:ß|ss)|pieds?|pies?|英尺|'|′|’",
    "px": "pixels?",
    "pt": "points?|punkte?",
}
_UNIT = {unit: re.compile(f"{unit}|{words}", re.IGNORECASE) for unit, words in _WORDS.items()}
"""Pattern for the spellings of each unit: symbols, words and signs."""


def read_unit(text: str) -> str | None:
    """Return the unit that a word or a sign names, or None for other text.

    Examples
    --------
    >>> read_unit("Inches"), read_unit("″"), read_unit("Zoll"), read_unit("furlong")
    ('in', 'in', 'in', None)
    """
    return next((unit for unit, words in _UNIT.items() if words.fullmatch(text.strip())), None)


def look_up_unit(unit: str) -> float:
    """Return the size of `unit` in mm.

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


# groups: whole number, numerator, denominator
_FRACTION = re.compile(r"\s*(?:(\d+)[ -]+)?(\d+)/([1-9]\d*)\s*")
# groups: sign, feet, inches, eighths, and the sign of a further sixteenth
_OFFSET = re.compile(r"([-+]?)(\d+)-(\d+)-([0-7])\s*([-+]?)")
_INCHES = r"(?:\d+[ -]+)?\d+/[1-9]\d*|\d+\.?\d*|\.\d+"
# groups: sign, feet, inches, and the unit of the inches
_MARKED = re.compile(
    rf"""([-+]?)\s*(?=.*['"a-z])(?:(\d+\.?\d*)\s*(?:'|ft\.?|feet|foot)\s*-?\s*(?=\d|$))?
    (?:({_INCHES})\s*("|in\.?|inch|inches)?)?""",
    re.IGNORECASE | re.VERBOSE,
)
_SIGNS = str.maketrans({"′": "'", "’": "'", "‘": "'", "″": '"', "”": '"', "“": '"'})


def read_number(text: str) -> float:
    """Parse a number, which may be a fraction such as "5/16", "1 3/8" or "1-3/8".

    Raises
    ------
    ValueError
        The text is not a number.

    Examples
    --------
    >>> read_number("12.5"), read_number("3 1/2")
    (12.5, 3.5)
    """
    parts = _FRACTION.fullmatch(text)
    return float(text) if parts is None else int(parts[1] or 0) + int(parts[2]) / int(parts[3])


def read_length(text: str) -> float | None:
    """Return a length with its unit, in mm, or None for other text.

    Examples
    --------
    >>> read_length("2in"), read_length('5/16"'), read_length("4 cm"), read_length("4")
    (50.8, 7.9375, 40.0, None)
    """
    match = re.fullmatch(r"\s*([-+.\deE/ ]+?)\s*([a-z]+|\")\s*", text)
    unit = MILLIMETRES | {"inch": MM_PER_INCH, '"': MM_PER_INCH}
    try:
        return None if match is None else unit[match[2]] * read_number(match[1])
    except (KeyError, ValueError):
        return None


def read_offset(text: str) -> float | None:
    """Return a length in inches, or None if the text is not in feet and inches.

    The text has feet, inches and eighths ("3-4-5", as in tables of offsets), or feet and inches with their
    units (3' 4 5/8", 2 ft 11 in). A plus or minus sign after the eighths adds or subtracts a sixteenth.

    Examples
    --------
    >>> read_offset("3-4-5"), read_offset("0-0-5+"), read_offset("3-1-0-"), read_offset("3.5")
    (40.625, 0.6875, 36.9375, None)
    >>> read_offset("3' 4 5/8\\""), read_offset("2 ft 11in"), read_offset("40.5\\"")
    (40.625, 35.0, 40.5)
    """
    text = text.translate(_SIGNS).replace("''", '"').strip()
    if parts := _OFFSET.fullmatch(text):
        sixteenth = {"+": 1, "-": -1, "": 0}[parts[5]] / 16
        inches = 12 * int(parts[2]) + int(parts[3]) + int(parts[4]) / 8 + sixteenth
    elif (parts := _MARKED.fullmatch(text)) and (parts[2] or parts[4]):
        inches = 12 * float(parts[2] or 0) + read_number(parts[3] or "0")
    else:
        return None
    return -inches if parts[1] == "-" else inches


def is_in_inches(text: str) -> bool:
    """Return True for a text that implies inches: a fraction, feet and inches, or feet, inches and eighths."""
    return _FRACTION.fullmatch(text) is not None or read_offset(text) is not None
