"""Sheets by name: those that come with the package, those of users, and the keys of their tables."""

import os
import sys
from collections.abc import Iterator, Mapping
from difflib import get_close_matches
from functools import lru_cache
from math import isfinite
from pathlib import Path
from types import MappingProxyType
from typing import Any

from elastica_cad._toml import parse_toml
from elastica_cad._values import require_path
from elastica_cad.declared import Field
from elastica_cad.errors import InputError, quoted, toml_slip
from elastica_cad.refusals import note

SCHEMA = 1

NOMINAL_KEY = "nominal_poisson_ratio"
"""Key of a Poisson ratio that is not measured for this sheet."""

UNITS = {
    "thickness": "mm",
    "youngs_modulus": "MPa",
    "density": "kg/m3",
    "max_strain": "parts of the length (0.01 = 1 %)",
    "kerf": "mm",
}
"""Units of the figures that every sheet has."""

OPTIONAL_UNITS = {
    "shear_modulus": "MPa",
    "break_strain": UNITS["max_strain"],
    **dict.fromkeys(("least_width", "least_ligament", "least_bridge"), "mm"),
}
"""Units of the figures that a sheet may have."""

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
        raise InputError(
            "{place}: {key} = {number:g} looks like the wrong unit; {hint}",
            place=where,
            key=key,
            number=number,
            hint=hint,
        )
    return number


def _advise_key(key: str, keys: Mapping[str, Field]) -> str:
    """Suggest the known key that is nearest to an unknown one."""
    for known, entry in keys.items():
        stem = entry.name
        if key.lower() == known.lower() or (
            key.lower().startswith(stem) and "range" not in key.removeprefix(stem)
        ):
            return f"; write {known}{PLAUSIBLE[known][2].join((' (', ')')) if known in PLAUSIBLE else ''}"
    near = get_close_matches(key, keys, n=1, cutoff=0.5)
    return (
        note("; did you mean {near}?", near=near[0])
        if near
        else note("; known keys are {keys}", keys=", ".join(keys))
    )


def require_printable(text: str, where: str) -> str:
    """The text, unless it holds signs that break lines, steer a terminal or have no place in files."""
    if not isinstance(text, str):
        raise InputError("{place} is {typed!r}: give a text", place=where, typed=text)
    if not text.isprintable():
        odd = ", ".join(sorted({repr(sign) for sign in text if not sign.isprintable()}))
        raise InputError(
            "{place} {typed!r} holds {odd}: use signs that can be printed, in one line",
            place=where,
            typed=text,
            odd=odd,
        )
    return text


def even_shear_ratio(poisson_ratio: float) -> float:
    """G / E of a sheet without grain: 1 / (2 (1 + nu))."""
    return 1 / (2 * (1 + poisson_ratio))


def finite_number(value: Any, where: str) -> float:
    """The number, unless it is none or not finite."""
    if isinstance(value, bool | str | bytes) or value is None:
        raise InputError("{place} is {given!r}; it must be a number", place=where, given=value)
    try:
        number = float(value)
    except (TypeError, ValueError, OverflowError) as error:
        raise InputError(
            "{place} is {given}; it must be a number", place=where, given=quoted(value)
        ) from error
    if not isfinite(number):
        raise InputError("{place} is {number}; it must be a finite number", place=where, number=number)
    return number


def toml_text(text: str) -> str:
    """A TOML basic string."""
    import json

    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")


def toml_value(value: str | float | tuple[float, float]) -> str:
    """Write the value of a key as TOML: a text, a number or a range."""
    if isinstance(value, tuple):
        return f"[{value[0]!r}, {value[1]!r}]"
    return toml_text(value) if isinstance(value, str) else repr(float(value))


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
"""Poisson ratio of a sheet that gives none."""


def checked_poisson_ratio(value: Any, where: str) -> float:
    """The ratio, as nominal as it is given.

    Raises
    ------
    InputError
        No number from 0 to below 1.
    """
    nu = finite_number(value, f"{where}: poisson_ratio")
    if not 0 <= nu < 1:
        raise InputError("{place}: poisson_ratio is {nu:g}; it must lie between 0 and 1", place=where, nu=nu)
    return NominalRatio(nu) if isinstance(value, NominalRatio) else nu


LIBRARY_VARIABLE = "ELASTICA_SHEETS"
"""Environment variable that names other folders of sheets, or files, as PATH does."""

_WORDS = ("kind", "grain")  # keys that are fields of `Sheet` as they stand
_LIMITS = ("least_width_mm", "least_ligament_mm", "least_bridge_mm")

# key in the file -> field of `Sheet`, what its source is called
_FIGURES = {
    "thickness_mm": ("thickness", "thickness"),
    "youngs_modulus_MPa": ("youngs_modulus", "E"),
    "density_kg_m3": ("density", "density"),
    "max_strain": ("max_strain", "strain"),
    "kerf_mm": ("kerf", "kerf"),
    "shear_modulus_MPa": ("shear_modulus", "G"),
    "break_strain": ("break_strain", "break"),
}
_ESTIMATED = ("shear_modulus_MPa", "break_strain")  # from other figures, where they are not published


LARGEST_FILE = 2**20
"""Largest size of a file of sheets, bytes."""


@lru_cache(maxsize=1)
def built_in_figures() -> Mapping[str, Mapping[str, Any]]:
    """Fields of `Sheet` but for its name, by name, as they stand in the file.

    Examples
    --------
    >>> built_in_figures()["pom-0.5"]["youngs_modulus_range"]
    (2500.0, 3000.0)
    """
    return MappingProxyType({name: fields for name, fields, _ in _built_in()})


@lru_cache(maxsize=1)
def built_in_titles() -> Mapping[str, str]:
    """What people call the built-in sheets, by name.

    Examples
    --------
    >>> built_in_titles()["pom-0.5"]
    'POM (acetal) 0.5 mm'
    """
    return MappingProxyType({name: title for name, _, title in _built_in()})


@lru_cache(maxsize=1)
def _built_in() -> tuple[tuple[str, dict[str, Any], str], ...]:
    """Name, fields and title of each built-in sheet, as they stand in the file."""
    import tomllib

    text = Path(__file__).with_name("sheets.toml").read_text(encoding="utf-8")
    return tuple(
        (name, fields, entry["title"] if "name" in entry else f"{entry['title']} {fields['thickness']:g} mm")
        for table, entry in tomllib.loads(text).items()
        for name, fields in _sheets(table, entry)
    )


def _sheets(table: str, entry: dict[str, Any]) -> Iterator[tuple[str, dict[str, Any]]]:
    """Name and fields of one sheet for each thickness."""
    thicknesses = entry["thickness_mm"]["value"]
    for i, thickness in enumerate(thicknesses if isinstance(thicknesses, list) else [thicknesses]):
        fields: dict[str, Any] = {key: entry[key] for key in _WORDS if key in entry}
        fields |= {key.removesuffix("_mm"): entry[key] for key in _LIMITS if key in entry}
        if "stock_mm" in entry:
            fields["stock"] = tuple(entry["stock_mm"])
        sources = [entry["note"]] if "note" in entry else []
        known = entry["poisson_ratio"]  # a number alone, or { value, source }
        if isinstance(known, dict):
            fields["poisson_ratio"] = known["value"]
        else:
            fields["poisson_ratio"] = NominalRatio(known)
        for key, (stem, label) in _FIGURES.items():
            if key not in entry:
                if key not in _ESTIMATED:
                    sources.append(f"{label} not published: measure it on a coupon")
                continue
            figure = entry[key]
            value, lowest = (
                given[i] if isinstance(given, list) else given
                for given in (figure["value"], figure.get("lowest"))
            )
            fields[stem] = value
            if "range" in figure:
                fields[f"{stem}_range"] = tuple(figure["range"])
            elif lowest is not None:
                fields[f"{stem}_range"] = (lowest, value)
            if "source" in figure:
                sources.append(f"{label}: {figure['source']}")
        if isinstance(known, dict):
            sources.append(f"nu: {known['source']}")
        yield entry.get("name", f"{table}-{thickness:g}"), {**fields, "source": "; ".join(sources)}


def library_folders() -> tuple[Path, ...]:
    """Return where a user keeps his own sheets: folders of TOML files, or such files.

    Those of the environment variable `ELASTICA_SHEETS`; without it `elastica/sheets` in the folder for settings:
    `%APPDATA%` on Windows, `~/Library/Application Support` on macOS, `$XDG_CONFIG_HOME` or `~/.config` elsewhere.
    """
    named = [part for part in os.environ.get(LIBRARY_VARIABLE, "").split(os.pathsep) if part.strip()]
    if named:
        return tuple(Path(part.strip()).expanduser() for part in named)
    try:
        home = Path.home()
    except RuntimeError:  # a process of a user without a home
        return ()
    if sys.platform == "win32":
        settings = Path(os.environ.get("APPDATA") or home / "AppData" / "Roaming")
    elif sys.platform == "darwin":
        settings = home / "Library" / "Application Support"
    else:
        settings = Path(os.environ.get("XDG_CONFIG_HOME") or home / ".config")
    return (settings / "elastica" / "sheets",)


def library_files() -> tuple[Path, ...]:
    """The user's files of sheets, in the order of folders and names."""
    return tuple(
        file
        for place in library_folders()
        for file in (sorted(place.glob("*.toml")) if place.is_dir() else [place] if place.is_file() else [])
    )


def read_figures(path: str | Path, keys: Mapping[str, Field]) -> dict[str, dict[str, Any]]:
    """Fields of `Sheet` but for its name, by name, from a user's file: see `load_sheets`.

    Raises
    ------
    InputError
        No such file, not TOML, an unknown key, a missing value or another unit.
    """
    import tomllib

    path = require_path(path)
    if os.path.isdir(path):  # False, not an error, for a name that no disk takes
        raise InputError("{path} is a folder, not a file of sheets: name the TOML file inside it", path=path)
    if os.path.exists(path) and not path.is_file():
        raise InputError("{path} is no file but a device or a pipe: name a file of sheets", path=path)
    try:
        if path.stat().st_size > LARGEST_FILE:
            raise InputError(
                "{path} has more than {largest_file} MB, which is no file of sheets: name one",
                path=path,
                largest_file=LARGEST_FILE // 2**20,
            )
        text = path.read_bytes().decode("utf-8-sig")  # with a byte order mark or without
        data = parse_toml(text)
    except RecursionError as error:
        raise InputError("{path} nests lists or tables too deep for a file of sheets", path=path) from error
    except OSError as error:
        raise InputError(
            "{path} cannot be read: {strerror}; name a file that is there",
            path=path,
            strerror=error.strerror or error,
        ) from error
    except UnicodeDecodeError as error:
        raise InputError(
            "{path} is not a TOML file, which are UTF-8: save it as text in UTF-8", path=path
        ) from error
    except tomllib.TOMLDecodeError as error:
        raise InputError(
            "{path} is not a TOML file: {error}; {toml_slip}",
            path=path,
            error=error,
            toml_slip=toml_slip(text, error),
        ) from error
    for key in data:
        if key not in ("schema", "sheets"):
            raise InputError(
                "{path}: unknown entry {key!r}; sheets are tables [sheets.NAME]", path=path, key=key
            )
    if data.get("schema", SCHEMA) != SCHEMA:
        raise InputError(
            "{path}: schema {given} is not known; this version reads schema {schema}",
            path=path,
            given=quoted(data["schema"]),
            schema=SCHEMA,
        )
    return figures_from_table(data.get("sheets", {}), str(path), keys)


def figures_from_table(table: object, where: str, keys: Mapping[str, Field]) -> dict[str, dict[str, Any]]:
    """Return the figures of sheets from the parsed table ``sheets`` of a TOML file; `where` names the file in
    messages.
    """
    if not isinstance(table, Mapping) or not table:
        raise InputError("{place} holds no sheet: write at least one table [sheets.NAME]", place=where)
    return {name: _fields(name, entry, where, keys) for name, entry in table.items()}


def _fields(name: str, entry: object, file: str, keys: Mapping[str, Field]) -> dict[str, Any]:
    """Fields of one sheet."""
    where = f"{file}: sheet {name!r}"
    if not isinstance(entry, Mapping):
        raise InputError(
            "{place} must be a table [sheets.{name}], got {entry}",
            place=where,
            name=name,
            entry=quoted(entry),
        )
    values: dict[str, Any] = {}
    for key, value in entry.items():
        if key not in keys:
            raise InputError(
                "{place}: unknown key {key!r}{advise_key}",
                place=where,
                key=key,
                advise_key=_advise_key(key, keys),
            )
        field_name, kind = keys[key].name, keys[key].kind.name
        if kind == "either" and not isinstance(value, str):
            values[field_name] = finite_number(value, f"{where}: {key}")
        elif kind in ("text", "either"):
            if not isinstance(value, str):
                raise InputError(
                    "{place}: {key} is {given}; it must be text in quotes",
                    place=where,
                    key=key,
                    given=quoted(value),
                )
            values[field_name] = value
        elif kind == "list":
            if not isinstance(value, list) or len(value) != 2:
                raise InputError(
                    "{place}: {key} is {given}; it must be two numbers, [lowest, highest]",
                    place=where,
                    key=key,
                    given=quoted(value),
                )
            values[field_name] = tuple(plausible_number(v, key, where) for v in value)
        else:
            number = plausible_number(value, key, where)
            values[field_name] = NominalRatio(number) if key == NOMINAL_KEY else number
    if NOMINAL_KEY in entry and "poisson_ratio" in entry:
        raise InputError(
            "{place}: poisson_ratio is given twice; leave out {nominal_key}, now that it is known",
            place=where,
            nominal_key=NOMINAL_KEY,
        )
    for key in ("thickness_mm", "youngs_modulus_MPa", "density_kg_m3", "max_strain"):
        if key not in entry:
            raise InputError("{place}: {key} is missing; give it a number", place=where, key=key)
    return values
