"""Figures of sheets in files: those built in, of `sheets.toml` with their sources, and a user's own."""

import os
import sys
from collections.abc import Iterator, Mapping
from functools import lru_cache
from pathlib import Path
from types import MappingProxyType
from typing import Any

from elastica_cad._values import require_path
from elastica_cad.errors import InputError, quoted, toml_slip
from elastica_cad.mechanics.material.sheet_keys import (
    KEYS,
    NOMINAL_KEY,
    SCHEMA,
    NominalRatio,
    advise_key,
    finite_number,
    plausible_number,
)

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
"""Bytes of a file of sheets."""


@lru_cache(maxsize=1)
def built_in_figures() -> Mapping[str, Mapping[str, Any]]:
    """Fields of `Sheet` but for its name, by name, as they stand in the file.

    Examples
    --------
    >>> built_in_figures()["pom-0.5"]["youngs_modulus_range"]
    (2500.0, 3000.0)
    """
    import tomllib

    text = Path(__file__).with_name("sheets.toml").read_text(encoding="utf-8")
    return MappingProxyType(
        {
            name: fields
            for table, entry in tomllib.loads(text).items()
            for name, fields in _sheets(table, entry)
        }
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
        for key, (field, label) in _FIGURES.items():
            if key not in entry:
                if key not in _ESTIMATED:
                    sources.append(f"{label} not published: measure it on a coupon")
                continue
            figure = entry[key]
            value, lowest = (
                given[i] if isinstance(given, list) else given
                for given in (figure["value"], figure.get("lowest"))
            )
            fields[field] = value
            if "range" in figure:
                fields[f"{field}_range"] = tuple(figure["range"])
            elif lowest is not None:
                fields[f"{field}_range"] = (lowest, value)
            if "source" in figure:
                sources.append(f"{label}: {figure['source']}")
        if isinstance(known, dict):
            sources.append(f"nu: {known['source']}")
        yield entry.get("name", f"{table}-{thickness:g}"), {**fields, "source": "; ".join(sources)}


def library_folders() -> tuple[Path, ...]:
    """Where a user keeps sheets of his own: folders of TOML files, or such files.

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


def read_figures(path: str | Path) -> dict[str, dict[str, Any]]:
    """Fields of `Sheet` but for its name, by name, from a user's file: see `load_sheets`.

    Raises
    ------
    InputError
        No such file, not TOML, an unknown key, a missing value or another unit.
    """
    import tomllib

    path = require_path(path)
    if os.path.isdir(path):  # False, not an error, for a name that no disk takes
        raise InputError(f"{path} is a folder, not a file of sheets: name the TOML file inside it")
    if os.path.exists(path) and not path.is_file():
        raise InputError(f"{path} is no file but a device or a pipe: name a file of sheets")
    try:
        if path.stat().st_size > LARGEST_FILE:
            raise InputError(
                f"{path} has more than {LARGEST_FILE // 2**20} MB, which is no file of sheets: name one"
            )
        text = path.read_bytes().decode("utf-8-sig")  # with a byte order mark or without
        data = tomllib.loads(text)
    except RecursionError as error:
        raise InputError(f"{path} nests lists or tables too deep for a file of sheets") from error
    except OSError as error:
        raise InputError(
            f"{path} cannot be read: {error.strerror or error}; name a file that is there"
        ) from error
    except UnicodeDecodeError as error:
        raise InputError(f"{path} is not a TOML file, which are UTF-8: save it as text in UTF-8") from error
    except tomllib.TOMLDecodeError as error:
        raise InputError(f"{path} is not a TOML file: {error}; {toml_slip(text, error)}") from error
    for key in data:
        if key not in ("schema", "sheets"):
            raise InputError(f"{path}: unknown entry {key!r}; sheets are tables [sheets.NAME]")
    if data.get("schema", SCHEMA) != SCHEMA:
        raise InputError(
            f"{path}: schema {quoted(data['schema'])} is not known; this version reads schema {SCHEMA}"
        )
    return figures_from_table(data.get("sheets", {}), str(path))


def figures_from_table(table: object, where: str) -> dict[str, dict[str, Any]]:
    """The same from the parsed table ``sheets`` of a TOML file; `where` names the file in messages."""
    if not isinstance(table, Mapping) or not table:
        raise InputError(f"{where} holds no sheet: write at least one table [sheets.NAME]")
    return {name: _fields(name, entry, where) for name, entry in table.items()}


def _fields(name: str, entry: object, file: str) -> dict[str, Any]:
    """Fields of one sheet."""
    where = f"{file}: sheet {name!r}"
    if not isinstance(entry, Mapping):
        raise InputError(f"{where} must be a table [sheets.{name}], got {quoted(entry)}")
    values: dict[str, Any] = {}
    for key, value in entry.items():
        if key not in KEYS:
            raise InputError(f"{where}: unknown key {key!r}{advise_key(key)}")
        field_name, kind = KEYS[key]
        if kind == "grain" and not isinstance(value, str):
            values[field_name] = finite_number(value, f"{where}: {key}")
        elif kind in ("text", "grain"):
            if not isinstance(value, str):
                raise InputError(f"{where}: {key} is {quoted(value)}; it must be text in quotes")
            values[field_name] = value
        elif kind == "range":
            if not isinstance(value, list) or len(value) != 2:
                raise InputError(
                    f"{where}: {key} is {quoted(value)}; it must be two numbers, [lowest, highest]"
                )
            values[field_name] = tuple(plausible_number(v, key, where) for v in value)
        else:
            number = plausible_number(value, key, where)
            values[field_name] = NominalRatio(number) if key == NOMINAL_KEY else number
    if NOMINAL_KEY in entry and "poisson_ratio" in entry:
        raise InputError(
            f"{where}: poisson_ratio is given twice; leave out {NOMINAL_KEY}, now that it is known"
        )
    for key in ("thickness_mm", "youngs_modulus_MPa", "density_kg_m3", "max_strain"):
        if key not in entry:
            raise InputError(f"{where}: {key} is missing; give it a number")
    return values
