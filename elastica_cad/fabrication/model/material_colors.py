"""Colours of materials in pictures and assemblies; those of cuts are in `formats.drawing_files.drawing_style`."""

from typing import TypeAlias

from elastica_cad.mechanics.material.sheet import Sheet

Color: TypeAlias = tuple[float, float, float]
"""Red, green and blue in 0..1, as on a screen."""

FIXTURE_COLOR: Color = (0.30, 0.36, 0.42)
"""Of printed blocks: dark, unlike any sheet."""

_BY_NAME = {
    "pom": (0.93, 0.93, 0.90),
    "polypropylene": (0.88, 0.91, 0.93),
    "petg": (0.72, 0.85, 0.88),
    "acrylic": (0.66, 0.82, 0.90),
    "gfrp": (0.78, 0.80, 0.60),
}
_BY_KIND = {
    "plywood": (0.85, 0.70, 0.48),
    "wood": (0.80, 0.62, 0.40),
    "card": (0.94, 0.91, 0.84),
    "board": (0.66, 0.50, 0.34),
    "metal": (0.70, 0.72, 0.75),
    "plastic": (0.85, 0.87, 0.88),
    "composite": (0.78, 0.80, 0.60),
}
_UNKNOWN = (0.80, 0.74, 0.62)  # of sheets of no known kind: between wood and card


def sheet_color(sheet: Sheet) -> Color:
    """The colour of a sheet by its name, else by its kind.

    Examples
    --------
    >>> sheet_color(Sheet.named("card-200gsm"))
    (0.94, 0.91, 0.84)
    """
    sheet = Sheet.of(sheet)
    for name, color in _BY_NAME.items():
        if sheet.name.startswith(name):
            return color
    return _BY_KIND.get(sheet.kind, _UNKNOWN)
