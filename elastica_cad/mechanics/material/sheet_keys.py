"""Keys of a file of sheets: what field each sets, in which unit, which values can be meant, and which are known."""

from difflib import get_close_matches
from math import isfinite
from typing import Any

from elastica_cad.errors import InputError
from elastica_cad.errors import quoted as shown

SCHEMA = 1

NOMINAL_KEY = "nominal_poisson_ratio"
"""Of a Poisson's ratio that is not known for the sheet."""

UNITS = {
    "thickness": "mm",
    "youngs_modulus": "MPa",
    "density": "kg/m3",
    "max_strain": "parts of the length (0.01 = 1 %)",
    "kerf": "mm",
}

# key in the file -> (field, kind)
KEYS: dict[str, tuple[str, str]] = {
    "thickness_mm": ("thickness", "number"),
    "youngs_modulus_MPa": ("youngs_modulus", "number"),
    "density_kg_m3": ("density", "number"),
    "max_strain": ("max_strain", "number"),
    "kerf_mm": ("kerf", "number"),
    "poisson_ratio": ("poisson_ratio", "number"),
    NOMINAL_KEY: ("poisson_ratio", "number"),
    "grain": ("grain", "grain"),
    "kind": ("kind", "text"),
    "source": ("source", "text"),
    "thickness_range_mm": ("thickness_range", "range"),
    "youngs_modulus_range_MPa": ("youngs_modulus_range", "range"),
    "density_range_kg_m3": ("density_range", "range"),
    "max_strain_range": ("max_strain_range", "range"),
    "kerf_range_mm": ("kerf_range", "range"),
    "least_width_mm": ("least_width", "number"),
    "least_ligament_mm": ("least_ligament", "number"),
    "least_bridge_mm": ("least_bridge", "number"),
    "stock_mm": ("stock", "range"),
    "shear_modulus_MPa": ("shear_modulus", "number"),
    "break_strain": ("break_strain", "number"),
}

# key -> (lowest, highest that any sheet has, what the unit is)
PLAUSIBLE: dict[str, tuple[float, float, str]] = {
    "thickness_mm": (1e-3, 1e3, "millimetres: 0.8 for a 0.8 mm sheet"),
    "youngs_modulus_MPa": (0.1, 1.5e6, "N/mm2: 9000 for 9 GPa"),
    "density_kg_m3": (5.0, 25000.0, "kg/m3: 680 for 0.68 g/cm3"),
    "max_strain": (1e-6, 0.4, "a fraction: 0.008 for 0.8 %"),
    "break_strain": (1e-6, 10.0, "a fraction: 0.02 for 2 %"),
    "kerf_mm": (0.0, 20.0, "millimetres: 0.15 for a fine laser"),
    "least_width_mm": (1e-2, 1e3, "millimetres: 3 for plywood"),
    "least_ligament_mm": (1e-2, 1e3, "millimetres: 0.5 for card"),
    "least_bridge_mm": (1e-2, 1e3, "millimetres: 3 for a board of 3 mm"),
    "shear_modulus_MPa": (0.01, 1e6, "N/mm2: 620 for 0.62 GPa"),
    "stock_mm": (10.0, 1e5, "millimetres: [1250, 2500]"),
}


def plausible_number(value: object, key: str, where: str) -> float:
    """The number, unless it can only have been meant in another unit."""
    number = finite_number(value, f"{where}: {key}")
    low, high, hint = PLAUSIBLE.get(key.replace("_range", ""), (float("-inf"), float("inf"), ""))
    if not low <= number <= high and number > 0:
        raise InputError(f"{where}: {key} = {number:g} looks like the wrong unit; {hint}")
    return number


def advise_key(key: str) -> str:
    """What was probably meant by an unknown key."""
    for known in KEYS:
        stem = KEYS[known][0]
        if key.lower() == known.lower() or (
            key.lower().startswith(stem) and "range" not in key.removeprefix(stem)
        ):
            return f"; write {known}{PLAUSIBLE[known][2].join((' (', ')')) if known in PLAUSIBLE else ''}"
    near = get_close_matches(key, KEYS, n=1, cutoff=0.5)
    return f"; did you mean {near[0]}?" if near else f"; known keys are {', '.join(KEYS)}"


def require_printable(text: str, where: str) -> str:
    """The text, unless it holds signs that break lines, steer a terminal or have no place in files."""
    if not isinstance(text, str):
        raise InputError(f"{where} is {text!r}: give a text")
    if not text.isprintable():
        odd = ", ".join(sorted({repr(sign) for sign in text if not sign.isprintable()}))
        raise InputError(f"{where} {text!r} holds {odd}: use signs that can be printed, in one line")
    return text


def even_shear_ratio(poisson_ratio: float) -> float:
    """G / E of a sheet without grain: 1 / (2 (1 + nu))."""
    return 1 / (2 * (1 + poisson_ratio))


def finite_number(value: Any, where: str) -> float:
    """The number, unless it is none or not finite."""
    if isinstance(value, bool | str | bytes) or value is None:
        raise InputError(f"{where} is {value!r}; it must be a number")
    try:
        number = float(value)
    except (TypeError, ValueError, OverflowError) as error:
        raise InputError(f"{where} is {shown(value)}; it must be a number") from error
    if not isfinite(number):
        raise InputError(f"{where} is {number}; it must be a finite number")
    return number


def quoted(text: str) -> str:
    """A TOML basic string."""
    import json

    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")


def toml_value(value: str | float | tuple[float, float]) -> str:
    """What stands behind a key: a text, a number or a range."""
    if isinstance(value, tuple):
        return f"[{value[0]!r}, {value[1]!r}]"
    return quoted(value) if isinstance(value, str) else repr(float(value))


class NominalRatio(float):
    """A Poisson's ratio that estimates count with, but that no width is made by: nobody vouches for it.

    It computes as the number that it is, and stays nominal wherever it is passed on: by `dataclasses.replace`,
    copies, pickles and files of sheets.

    Examples
    --------
    >>> NominalRatio(0.3) == 0.3, NominalRatio(0.3)
    (True, NominalRatio(0.3))
    """

    __slots__ = ()

    def __repr__(self) -> str:
        return f"NominalRatio({float(self)!r})"


USUAL_RATIO = NominalRatio(0.3)
"""Of a sheet of which nothing is said."""


def checked_poisson_ratio(value: Any, where: str) -> float:
    """The ratio, as nominal as it is given.

    Raises
    ------
    InputError
        No number from 0 to below 1.
    """
    nu = finite_number(value, f"{where}: poisson_ratio")
    if not 0 <= nu < 1:
        raise InputError(f"{where}: poisson_ratio is {nu:g}; it must lie between 0 and 1")
    return NominalRatio(nu) if isinstance(value, NominalRatio) else nu
