"""Sheets of material: their data, the folders of the user's own sheets, and the sheets that withstand a bend."""

import os
import re
import sys
from collections.abc import Iterable, Iterator, Mapping
from copy import copy
from dataclasses import dataclass, field, replace
from difflib import get_close_matches
from functools import cache, lru_cache
from math import isfinite
from os import PathLike
from pathlib import Path
from types import MappingProxyType
from typing import Annotated, Any, Literal, TypeAlias, get_args

import numpy as np

from elastica_cad._notebook import html_table
from elastica_cad._text import plain_name
from elastica_cad._toml import parse_toml, toml_string
from elastica_cad._units import MM_PER_INCH
from elastica_cad._values import is_number, is_one_of, require_number, require_path, require_record
from elastica_cad.declared import Field, Option, declared, require_declared
from elastica_cad.errors import (
    Either,
    FieldName,
    InputError,
    Length,
    Refusal,
    note,
    quoted,
    sentences,
    toml_slip,
)
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.mechanics.loads import STANDARD_GRAVITY_M_S2, ExcessCurvature, Gravity, NaturalCurvature

SCHEMA = 1

NOMINAL_KEY = "nominal_poisson_ratio"
"""Key in files of sheets for a typical Poisson's ratio that was not measured."""

UNITS = {
    "thickness": "mm",
    "youngs_modulus": "MPa",
    "density": "kg/m3",
    "max_strain": "parts of the length (0.01 = 1 %)",
    "kerf": "mm",
}
"""Units of the properties that every sheet has."""

# lowest and highest plausible value of each key, and its unit
PLAUSIBLE: dict[str, tuple[float, float, str]] = {
    "thickness_mm": (1e-3, 1e3, "millimetres: 0.8 for a 0.8 mm sheet"),
    "youngs_modulus_MPa": (1e-6, 1.5e6, "N/mm2: 9000 for 9 GPa"),
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


def plausible_number(value: object, key: str, where: str, name: str | None = None) -> float:
    """Return the number, or refuse it if its size shows that its unit is wrong.

    The message contains `name` instead of the key, if a name is given.
    """
    number = _finite_number(value, f"{where}: {key}")
    low, high, hint = PLAUSIBLE.get(key.replace("_range", ""), (float("-inf"), float("inf"), ""))
    if not low <= number <= high and number > 0:
        raise InputError(
            "{place}: {key} = {number:g} looks like the wrong unit; {hint}",
            place=where,
            key=name or key,
            number=number,
            hint=hint,
        )
    return number


def _advise_key(key: str) -> str:
    """Return the continuation of a message on an unknown key: the correct spelling, similar keys, or all keys."""
    keys = sheet_keys()
    for match, entry in keys.items():
        stem = entry.name
        # the key in another case, or with another unit
        if key.lower() == match.lower() or (
            key.lower().startswith(stem) and "range" not in key.removeprefix(stem)
        ):
            return f"; write {match}{PLAUSIBLE[match][2].join((' (', ')')) if match in PLAUSIBLE else ''}"
    near = get_close_matches(key, keys, n=1, cutoff=0.5)
    return (
        note("; did you mean {near}?", near=near[0])
        if near
        else note("; known keys are {keys}", keys=", ".join(keys))
    )


def require_name(text: object, where: str) -> str:
    """Return the text as `plain_name` does. Refuse line breaks, control characters and changes of direction."""
    if not isinstance(text, str):
        raise InputError(f"{where} is {text!r}: give text")
    name = plain_name(text)
    for k, sign in enumerate(name):
        if not sign.isprintable():
            raise InputError(
                "the name {name} contains {sign} between {before} and {after}: use printable characters in one "
                "line",
                name=repr(name), sign=repr(sign), before=repr(name[k - 1]) if k else note("its start"),
                after=repr(name[k + 1]) if name[k + 1 :] else note("its end"),
            )  # fmt: skip
    return name


def even_shear_ratio(poisson_ratio: float) -> float:
    """Return G / E of a sheet without grain, 1 / (2 (1 + nu)), with Poisson's ratio nu."""
    return 1 / (2 * (1 + poisson_ratio))


def _finite_number(value: Any, where: str) -> float:
    if isinstance(value, bool | str | bytes) or value is None:
        raise InputError(f"{where} is {value!r}; write a number")
    try:
        number = float(value)
    except (TypeError, ValueError, OverflowError) as error:
        raise InputError(f"{where} is {quoted(value)}; write a number") from error
    if not isfinite(number):
        raise InputError(f"{where} is {number}; write a finite number")
    return number


class NominalRatio(float):
    """Poisson's ratio that was not measured; it is used for estimates, but not for widths.

    The number remains a `NominalRatio` in `dataclasses.replace`, copies, pickles and files of sheets.

    Examples
    --------
    >>> NominalRatio(0.3) == 0.3, NominalRatio(0.3)
    (True, NominalRatio(0.3))
    """

    __slots__ = ()

    def __repr__(self) -> str:
        return f"NominalRatio({float(self)!r})"


USUAL_RATIO = NominalRatio(0.3)
"""Poisson's ratio of a sheet for which no ratio is given."""


A_NAME = "a name such as 'birch-plywood-0.8'; `sheet_names()` lists the names"

LIBRARY_VARIABLE = "ELASTICA_SHEETS"
"""Environment variable with folders or files of sheets, separated as in PATH."""

# keys whose values are attributes of `Sheet` without conversion
_GIVEN = ("kind", "grain", "least_width_mm", "least_ligament_mm", "least_bridge_mm")

# for each key of the file, the word by which the sources of the sheet name it
_FIGURES = {
    "thickness_mm": "thickness",
    "youngs_modulus_MPa": "E",
    "density_kg_m3": "density",
    "max_strain": "strain",
    "kerf_mm": "kerf",
    "shear_modulus_MPa": "G",
    "break_strain": "break",
}

LARGEST_FILE = 10**6
"""Largest size of a file of sheets, bytes."""


@lru_cache(maxsize=1)
def built_in_figures() -> Mapping[str, Mapping[str, Any]]:
    """Return the attributes of each built-in `Sheet`, without its name, in a mapping by name.

    Examples
    --------
    >>> built_in_figures()["pom-0.5"]["youngs_modulus_range"]
    (2500.0, 3000.0)
    """
    return MappingProxyType({name: fields for name, fields, _ in _built_in()})


@lru_cache(maxsize=1)
def built_in_titles() -> Mapping[str, Refusal]:
    """Return the titles of the built-in sheets in a mapping by name.

    Examples
    --------
    >>> built_in_titles()["pom-0.5"]
    'POM (acetal) 0.5 mm'
    """
    return MappingProxyType({name: title for name, _, title in _built_in()})


@lru_cache(maxsize=1)
def _built_in() -> tuple[tuple[str, dict[str, Any], Refusal], ...]:
    # (name, attributes of `Sheet` without the name, title) of each sheet
    import tomllib

    text = Path(__file__).with_name("sheets.toml").read_text(encoding="utf-8")
    return tuple(sheet for entry in tomllib.loads(text).items() for sheet in _entry_sheets(*entry))


def _entry_sheets(table: str, entry: dict[str, Any]) -> Iterator[tuple[str, dict[str, Any], Refusal]]:
    """Yield name, fields and title of each sheet of an entry in the library, one for each thickness."""
    thicknesses, keys = entry["thickness_mm"]["value"], sheet_keys()
    for i, thickness in enumerate(thicknesses if isinstance(thicknesses, list) else [thicknesses]):
        fields: dict[str, Any] = {keys[key].name: entry[key] for key in _GIVEN if key in entry}
        if "stock_mm" in entry:
            fields["stock"] = tuple(entry["stock_mm"])
        sources = [entry["note"]] if "note" in entry else []
        ratio = entry["poisson_ratio"]
        fields["poisson_ratio"] = ratio["value"] if isinstance(ratio, dict) else NominalRatio(ratio)
        for key, label in _FIGURES.items():
            if key not in entry:
                # these are estimated from other properties if they are not published
                if key not in ("shear_modulus_MPa", "break_strain"):
                    sources.append(f"{label} not published: measure it on a coupon")
                continue
            figure, stem = entry[key], keys[key].name
            value, lowest = (
                number[i] if isinstance(number, list) else number
                for number in (figure["value"], figure.get("lowest"))
            )
            fields[stem] = value
            if "range" in figure:
                fields[f"{stem}_range"] = tuple(figure["range"])
            elif lowest is not None:
                fields[f"{stem}_range"] = (lowest, value)
            if "source" in figure:
                sources.append(f"{label}: {figure['source']}")
        if isinstance(ratio, dict):
            sources.append(f"nu: {ratio['source']}")
        fields["source"] = "; ".join(sources)
        title, name = entry["title"], f"{table}-{thickness:g}"
        if "name" in entry:
            yield entry["name"], fields, note(title)
        else:
            yield name, fields, note("{title} {thickness:g} mm", title=title, thickness=thickness)


def library_folders() -> tuple[Path, ...]:
    """Return the locations of a user's sheets: TOML files, or folders of TOML files.

    The environment variable `ELASTICA_SHEETS` contains the locations. By default it is `elastica/sheets` in
    the settings folder of the user: `%APPDATA%` on Windows, `~/Library/Application Support` on macOS,
    `$XDG_CONFIG_HOME` or `~/.config` elsewhere.
    """
    named = [part for part in os.environ.get(LIBRARY_VARIABLE, "").split(os.pathsep) if part.strip()]
    if named:
        return tuple(Path(part.strip()).expanduser() for part in named)
    try:
        home = Path.home()
    except RuntimeError:  # the user of this process has no home folder
        return ()
    if sys.platform == "win32":
        settings = Path(os.environ.get("APPDATA") or home / "AppData" / "Roaming")
    elif sys.platform == "darwin":
        settings = home / "Library" / "Application Support"
    else:
        settings = Path(os.environ.get("XDG_CONFIG_HOME") or home / ".config")
    return (settings / "elastica" / "sheets",)


def library_files() -> tuple[Path, ...]:
    """Return the user's files of sheets, sorted by folder and name."""
    return tuple(
        file
        for place in library_folders()
        for file in (sorted(place.glob("*.toml")) if place.is_dir() else [place] if place.is_file() else [])
    )


def _read_table(path: str | Path) -> object:
    """Return the tables of the sheets in a file, not yet checked."""
    import tomllib

    path = require_path(path)
    if os.path.isdir(path):  # `isdir` returns False for invalid names, without an error
        raise InputError(f"{path} is a folder, not a file of sheets: name the TOML file inside it")
    if os.path.exists(path) and not path.is_file():
        raise InputError(f"{path} is a device or a pipe, not a file: name a file of sheets")
    try:
        if path.stat().st_size > LARGEST_FILE:
            raise InputError(f"{path} is larger than {LARGEST_FILE // 10**6} MB: name a file of sheets")
        text = path.read_bytes().decode("utf-8-sig")
        data = parse_toml(text)
    except RecursionError as error:
        raise InputError(
            f"{path} nests lists or tables too deeply for a file of sheets; write tables [sheets.NAME]"
        ) from error
    except OSError as error:
        raise InputError(
            f"{path} cannot be read: {error.strerror or error}; name an existing file"
        ) from error
    except UnicodeDecodeError as error:
        raise InputError(
            f"{path} cannot be read as TOML, because the file is not UTF-8 text: save the file as UTF-8"
        ) from error
    except tomllib.TOMLDecodeError as error:
        raise InputError(f"{path} is not a TOML file: {error}; {toml_slip(text, error)}") from error
    for key in data:
        if key not in ("schema", "sheets"):
            raise InputError(f"{path}: unknown entry {key!r}; write sheets as tables [sheets.NAME]")
    if data.get("schema", SCHEMA) != SCHEMA:
        raise InputError(f"{path}: schema {quoted(data['schema'])} is not known; write schema = {SCHEMA}")
    return data.get("sheets", {})


def _fields(name: str, entry: object, file: str) -> dict[str, Any]:
    """Return the fields of the sheet `name` in a file, and refuse unknown or missing keys."""
    where = f"{file}: sheet {name!r}"
    if not isinstance(entry, Mapping):
        raise InputError(f"{where} is {quoted(entry)}; write a table [sheets.{name}]")
    values: dict[str, Any] = {}
    keys = sheet_keys()
    for key, value in entry.items():
        if key not in keys:
            raise InputError(f"{where}: unknown key {key!r}{_advise_key(key)}")
        field_name, kind = keys[key].name, keys[key].kind.name
        if kind == "either" and not isinstance(value, str):
            values[field_name] = _finite_number(value, f"{where}: {key}")
        elif kind in ("text", "either"):
            if not isinstance(value, str):
                raise InputError(f"{where}: {key} is {quoted(value)}; write text in quotes")
            values[field_name] = value
        elif kind == "list":
            if not isinstance(value, list) or len(value) != 2:
                raise InputError(f"{where}: {key} is {quoted(value)}; write two numbers, [lowest, highest]")
            values[field_name] = tuple(plausible_number(v, key, where) for v in value)
        else:
            number = plausible_number(value, key, where)
            values[field_name] = NominalRatio(number) if key == NOMINAL_KEY else number
    if NOMINAL_KEY in entry and "poisson_ratio" in entry:
        raise InputError(f"{where}: poisson_ratio is given twice; remove {NOMINAL_KEY}")
    for key in ("thickness_mm", "youngs_modulus_MPa", "density_kg_m3", "max_strain"):
        if key not in entry:
            raise InputError(f"{where}: {key} is missing; give it a number")
    return values


PLYWOOD_SOURCE = "FAA AC 43.13-1B, table 1-2, bent cold at 10 % moisture"

# thickness, least radius along and across the face grain, in inches; a strip along the grain is bent round a
# mandrel at 90 degrees to the grain
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
"""Published least radii of aircraft plywood (FAA AC 43.13-1B, table 1-2), by number of plies."""

SOLD_AS = 0.02
"""Fraction by which a sheet may be thinner than the first row of the table with its number of plies.

For example, plywood of 0.160 in is sold as 4 mm.
"""

PRINTED_ACCURACY = 0.01
"""Relative accuracy of a published radius, which has two digits."""

LEAST_MM, LARGEST_MM = 0.7, 9.6
"""Range of thicknesses, mm, for which `least_plywood_radius` uses `ROWS_INCH`.

A thinner sheet than the first row (0.89 mm) is given the strain of the first row.
"""


def least_plywood_radius(thickness: float, grain: Literal["along", "across"]) -> float | None:
    """Return the published least radius of a dry, cold bend of aircraft plywood, mm, or None if there is none.

    Between rows of the table the surface strain is interpolated. If the table has plywood of 3 and of 5 plies for
    this thickness, the larger radius is returned.

    Parameters
    ----------
    thickness : float
        Thickness of the plywood, mm.
    grain : "along" or "across"
        Direction of the strip relative to the face grain.

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
    for plies, rows in ROWS_INCH.items():
        table = MM_PER_INCH * np.array(rows)
        low = LEAST_MM if plies == min(ROWS_INCH) else table[0, 0] * (1 - SOLD_AS)
        high = LARGEST_MM if plies == max(ROWS_INCH) else table[-1, 0]
        if low <= thickness <= high:
            strains.append(float(np.interp(thickness, table[:, 0], table[:, 0] / (2 * table[:, column]))))
    return thickness / (2 * min(strains))


Grain: TypeAlias = Literal["along", "across", "none"]
Range: TypeAlias = tuple[float, float]


@dataclass(frozen=True)
class Sheet:
    """Sheet material of a given thickness; all values apply to the direction along the strip.

    Parameters
    ----------
    name : str
        Name of the sheet in reports and file names.
    thickness : float
        Thickness h, mm.
    youngs_modulus : float
        Young's modulus E in bending along the strip, MPa (N/mm2).
    density : float
        Density rho, kg/m3.
    max_strain : float
        Largest surface strain for permanent use, dimensionless (0.01 = 1 %).
    kerf : float
        Width of material that the laser removes, mm; 0 if unknown.
    poisson_ratio : float
        Poisson's ratio nu, dimensionless; 0 if the modulus was measured on a wide sample and is that of a plate. A
        given number counts as known (`poisson_known`), and widths are corrected for its effect. The default, and a
        given `NominalRatio`, are only used for estimates.
    shear_modulus : float, optional
        Shear modulus G in the plane of the sheet, MPa, which determines the torsional stiffness. By default
        E / (2 (1 + nu)), as for sheets without grain. The shear modulus of plywood is much smaller.
    grain : "along", "across" or "none"
        Direction of the strip relative to the (face) grain; "none" for sheets without grain. 0 and 90 (degrees) are
        accepted for "along" and "across".
    kind : str
        Family of materials, for example "plywood".
    source : str
        Source of the numbers.
    thickness_range, youngs_modulus_range, density_range, max_strain_range, kerf_range : (low, high), optional
        Range that occurs in practice, in the unit of the quantity; by default the value counts as exact.
    least_width, least_ligament, least_bridge : float, optional
        Least widths, mm, with which strips and tongues, ligaments of perforated strips, and bridges between the
        cuts of a plate can be cut and lifted out. The defaults are rules of thumb (`FabricationLimits`).
    stock : (float, float), optional
        Sides of the largest sheet on sale, mm.
    break_strain : float, optional
        Surface strain at which the sheet breaks. By default wood and brittle plastics break at 1.5 times
        `max_strain`, and other sheets do not break (`mechanics.section_limits`).

    Examples
    --------
    >>> ply = Sheet("my-ply", thickness=0.8, youngs_modulus=9250.0, density=680.0, max_strain=0.008)
    >>> ply.least_radius
    50.0
    >>> round(Sheet.named("card-200gsm").elasto_gravity_length, 1)
    96.0
    """

    name: str
    thickness: Annotated[float, Option("Thickness of the sheet.", "mm", above=0)]
    youngs_modulus: Annotated[float, Option("Young's modulus in bending along the strip.", "MPa", above=0)]
    density: Annotated[float, Option("Density.", "kg/m3", above=0)]
    max_strain: Annotated[
        float,
        Option("Largest strain of the surface that the sheet withstands for long: 0.01 is 1 %.", above=0),
    ]
    kerf: Annotated[float, Option("Width of material that the laser removes.", "mm", least=0)] = 0.0
    poisson_ratio: Annotated[float, Option("Poisson's ratio, if known.", least=0, most=0.999)] = USUAL_RATIO
    grain: Annotated[
        Grain,
        Option(
            "Direction of the strip relative to the face grain: along, across or none, or 0 or 90 degrees.",
            written=float | str,
        ),
    ] = "none"
    kind: Annotated[str, Option("Family of materials.")] = ""
    source: Annotated[str, Option("Source of the numbers.")] = ""
    thickness_range: Annotated[
        Range | None, Option("Least and largest thickness found in practice.", "mm", least=0)
    ] = None
    youngs_modulus_range: Annotated[
        Range | None, Option("Least and largest modulus found in practice.", "MPa", least=0)
    ] = None
    density_range: Annotated[
        Range | None, Option("Least and largest density found in practice.", "kg/m3", least=0)
    ] = None
    max_strain_range: Annotated[
        Range | None, Option("Least and largest strain that the sheet withstands.", least=0)
    ] = None
    kerf_range: Annotated[
        Range | None, Option("Least and largest kerf found in practice.", "mm", least=0)
    ] = None
    least_width: Annotated[
        float | None, Option("Narrowest strip or tongue that can be cut.", "mm", above=0)
    ] = None
    least_ligament: Annotated[
        float | None, Option("Narrowest ligament of a perforated strip.", "mm", above=0)
    ] = None
    least_bridge: Annotated[
        float | None, Option("Narrowest bridge between the cuts of a plate.", "mm", above=0)
    ] = None
    stock: Annotated[Range | None, Option("Side lengths of the largest sheet on sale.", "mm", above=0)] = None
    shear_modulus: Annotated[
        float | None, Option("Shear modulus in the plane of the sheet.", "MPa", above=0)
    ] = None
    break_strain: Annotated[
        float | None, Option("Strain of the surface at which the sheet breaks.", above=0)
    ] = None
    poisson_known: bool = field(init=False, repr=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "name", require_name(self.name, "the name of a sheet"))
        if not self.name.strip():
            raise InputError(f"the name of a sheet is {self.name!r}; give a text")
        require_declared(Sheet, vars(self), f"sheet {self.name!r}:")
        known = not isinstance(self.poisson_ratio, NominalRatio)
        vars(self).update(stock=self.stock and tuple(self.stock), poisson_known=known)
        for name in (*UNITS, "poisson_ratio") if known else UNITS:
            value = vars(self)[name] = float(getattr(self, name))
            limits = getattr(self, f"{name}_range", None)
            if limits is None:
                continue
            low, high = vars(self)[f"{name}_range"] = tuple(map(float, limits))
            if not low <= value <= high:
                raise InputError(
                    f"sheet {self.name!r}: {name}_range is {low:g} to {high:g}; write a range that contains "
                    f"{name} = {value:g}, lowest first"
                )
        grain: object = self.grain
        if is_number(grain):
            turned: dict[float, Grain] = {0.0: "along", 90.0: "across"}
            if grain % 180 not in turned:
                raise InputError(
                    f"sheet {self.name!r}: grain is {grain:g} degrees, but a strip at an angle to its grain twists "
                    "when it is bent. Lay the strip along (0) or across (90) the grain"
                )
            object.__setattr__(self, "grain", turned[grain % 180])
        if not is_one_of(self.grain, get_args(Grain)):
            raise InputError(
                f"sheet {self.name!r}: grain is {self.grain!r}; use one of {', '.join(get_args(Grain))}"
            )
        for key, entry in sheet_keys().items():
            if key in PLAUSIBLE and is_number(figure := getattr(self, entry.name)):
                plausible_number(figure, key, f"sheet {self.name!r}", entry.name)

    def with_weight_share(self, share: float) -> "Sheet":
        """Return the sheet with a fraction of its density, as if only a part of its weight acted."""
        sheet = copy(self)
        vars(sheet).update(density=share * self.density, density_range=None)
        return sheet

    @classmethod
    def of(cls, given: "Sheet | str") -> "Sheet":
        """Return a given sheet, or the sheet with a given name (see `named`).

        Examples
        --------
        >>> Sheet.of("mdf-3").thickness
        3.0
        """
        if isinstance(given, str):
            return cls.named(given)
        require_record(given, Sheet, "the sheet", f"a Sheet, or {A_NAME}")
        return given

    @classmethod
    def named(cls, name: str, *, folder: Path | None = None) -> "Sheet":
        """Return the sheet `name`: built-in, from the user's library or from a file.

        Parameters
        ----------
        name : str
            A name of `sheet_names`, a file such as "my.toml", or a sheet in a file, "my.toml:NAME".
        folder : Path, optional
            Folder of the files; by default the working folder.
        """
        require_record(name, str | PathLike, "the name of a sheet", A_NAME)
        figures, text = built_in_figures(), str(name)
        if name in figures:
            return cls(name, **figures[name])
        if text.endswith(".toml") or ".toml:" in text:
            return _sheet_of_file(text, folder)
        library, problems = library_sheets()
        if (called := plain_name(text)) in library:
            return library[called]
        names, low = [*library, *figures], text.lower()
        near = get_close_matches(low, names, n=3, cutoff=0.4)
        thicknesses = {known: Sheet.named(known).thickness for known in names if low in known}
        containing = sorted(thicknesses, key=lambda known: (not known.startswith(text), thicknesses[known]))
        # a known material in another thickness, such as "birch-plywood-7"
        material, _, size = low.removesuffix("mm").rpartition("-")
        found = (re.fullmatch(rf"{re.escape(material)}-(\d+(?:\.\d+)?)", other) for other in names)
        listed = [match for match in found if match]
        if re.fullmatch(r"\d+(\.\d+)?", size) and float(size) > 0 and listed:
            nearest = min(listed, key=lambda other: abs(float(other[1]) - float(size)))
            advice = note(
                "use {name} and set {field} to {size}",
                name=nearest[0],
                field=FieldName("thickness"),
                size=Length(float(size)),
            )
        elif name and containing:
            advice = note("use one of {names}", names=", ".join(containing))
        elif near:
            advice = note("did you mean {names}?", names=Either(near))
        else:
            advice = note("known sheets: {names}", names=", ".join(names))
        unknown = note("unknown sheet '{name}': {advice}", name=name, advice=advice)
        raise InputError(sentences([unknown, *problems]))

    def with_thickness(self, thickness: float) -> "Sheet":
        """Return the same material with another thickness, mm.

        For plywood, the strain limit is computed from the published radii.
        """
        changed = replace(self, thickness=thickness, thickness_range=None)
        if changed.thickness == self.thickness:
            return self
        stem = self.name.removesuffix(f"-{self.thickness:g}")
        before, after = self.published_radius, changed.published_radius
        limit, spread = self.max_strain, self.max_strain_range
        if before is not None and after is not None:
            limit *= (changed.thickness / after) / (self.thickness / before)
            spread = None
        source = "; ".join(filter(None, (self.source, f"figures of {self.name} at another thickness")))
        return replace(
            changed,
            name=f"{stem}-{changed.thickness:g}",
            max_strain=limit,
            max_strain_range=spread,
            source=source,
        )

    @property
    def published_radius(self) -> float | None:
        """Published least radius of plywood with this thickness and grain, mm, or None."""
        if self.kind != "plywood" or self.grain == "none":
            return None
        return least_plywood_radius(self.thickness, self.grain)

    @property
    def shear_ratio(self) -> float:
        """Ratio G / E of shear modulus to Young's modulus; by default the ratio of a sheet without grain."""
        G = self.shear_modulus
        return even_shear_ratio(self.poisson_ratio) if G is None else G / self.youngs_modulus

    @property
    def specific_weight(self) -> float:
        """Weight per volume, density * gravity, N/mm3."""
        return self.density * 1e-9 * STANDARD_GRAVITY_M_S2

    @property
    def elasto_gravity_length(self) -> float:
        """Elasto-gravity length (E h^2 / (12 rho g))^(1/3), mm (paper, section 5.1).

        Weight has little effect on a strip that is much shorter than this length.
        """
        return float((self.youngs_modulus * self.thickness**2 / (12 * self.specific_weight)) ** (1 / 3))

    def gravity(self, direction: tuple[float, float] = (0.0, -1.0)) -> Gravity:
        """Return the weight of a plain strip of this sheet; `direction` (2,) is the direction of gravity."""
        return Gravity(self.elasto_gravity_length, direction)

    @property
    def full_name(self) -> str:
        """Title of a built-in sheet, such as "Birch plywood 0.8 mm", or the name of a user's sheet.

        Examples
        --------
        >>> Sheet.named("card-200gsm").full_name
        'Card 200 g/m2'
        """
        return built_in_titles().get(self.name, self.name)

    @property
    def least_radius(self) -> float:
        """Least radius to which the sheet can be bent, mm: h / (2 max_strain).

        The surface is h/2 from the neutral axis, where h is the thickness.
        """
        return self.thickness / (2 * self.max_strain)

    def bending_stiffness(self, width: float) -> float:
        """Return the bending stiffness E h^3 w / 12, N mm2, of a strip of `width` w mm and thickness h."""
        return (
            self.youngs_modulus * self.thickness**3 * require_number(width, "the width of a strip", "mm") / 12
        )

    def range_of(self, quantity: str) -> Range:
        """Return the range of a quantity such as "youngs_modulus" or "thickness".

        Without a range, both limits are the value.
        """
        if not isinstance(quantity, str) or quantity not in UNITS:
            raise InputError(f"a sheet has no range of {quantity!r}: use one of {', '.join(UNITS)}")
        limits: Range | None = getattr(self, f"{quantity}_range")
        value = float(getattr(self, quantity))
        return (value, value) if limits is None else limits

    def _repr_html_(self) -> str:
        rows = []
        for name, unit in UNITS.items():
            low, high = self.range_of(name)
            spread = f"{low:g} to {high:g}" if low < high else ""
            number = f"{getattr(self, name):g}"
            rows.append({"": name.replace("_", " "), "value": number, "in practice": spread, "unit": unit})
        return html_table(f"Sheet {self.name!r}", rows)

    def toml(self) -> str:
        """Return the sheet as an entry of a file that `load_sheets` reads."""
        lines = [f"[sheets.{toml_string(self.name)}]"]
        for key, entry in sheet_keys().items():
            value = getattr(self, entry.name)
            if value is None or (entry.name in ("kind", "source") and not value):
                continue
            if entry.name == "poisson_ratio" and self.poisson_known == (key == NOMINAL_KEY):
                continue
            if isinstance(value, str):
                value = toml_string(value)
            else:
                value = [*value] if isinstance(value, tuple) else float(value)
            lines.append(f"{key} = {value}")
        return "\n".join(lines) + "\n"


def sheet_names() -> list[str]:
    """Return the names of the user's sheets and of the built-in sheets.

    Examples
    --------
    >>> "birch-plywood-0.8" in sheet_names()
    True
    """
    return [*library_sheets()[0], *built_in_figures()]


ROD_KIND = "rod"
"""Value of `Sheet.kind` for round rods, which are sold by length."""

KINDS = {
    "card": "Card and paper", "plywood": "Plywood", "wood": "Solid wood, veneer and bamboo", "plastic": "Plastics",
    "board": "Fibre boards", "metal": "Metals", "composite": "Composites", "rod": "Rods",
}  # fmt: skip


def cut_sheets() -> list[Sheet]:
    """Return all sheets of `sheet_names` from which strips are cut: rods are left out."""
    return [sheet for sheet in map(Sheet.named, sheet_names()) if sheet.kind != ROD_KIND]


def require_flat(sheet: Sheet) -> Sheet:
    """Return the sheet, or raise InputError for a rod, from which no flat part can be cut.

    Examples
    --------
    >>> try:
    ...     require_flat(Sheet.named("carbon-rod-4"))
    ... except InputError as problem:
    ...     print(str(problem).split('. ')[0])
    carbon-rod-4 is a rod, so no flat part can be cut from it
    """
    if sheet.kind == ROD_KIND:
        raise InputError(
            "{sheet} is a rod, so no flat part can be cut from it. Choose another {field}. "
            "`elastica bow --rod` bends a rod by a cord.",
            sheet=sheet.name, field=FieldName("sheet"), where={"field": "sheet"},
        )  # fmt: skip
    return sheet


def sheets_by_kind() -> dict[str, list[Sheet]]:
    """Return all sheets of `sheet_names`, grouped by the title of their kind."""
    by_kind: dict[str, list[Sheet]] = {}
    for sheet in map(Sheet.named, sheet_names()):
        by_kind.setdefault(KINDS.get(sheet.kind, sheet.kind.capitalize() or "Other"), []).append(sheet)
    return by_kind


def known_rods() -> dict[str, Sheet]:
    """Return a round rod of each known material, by the name of the material in lower case.

    Examples
    --------
    >>> [f"{name}: {rod.youngs_modulus:.0f} MPa" for name, rod in known_rods().items()]
    ['pultruded glass rod: 39600 MPa', 'pultruded carbon rod: 127000 MPa']
    """
    titles = built_in_titles()
    return {
        titles[name].values["title"].lower(): Sheet(name, **figures)
        for name, figures in built_in_figures().items()
        if figures["kind"] == ROD_KIND
    }


def library_sheets() -> tuple[Mapping[str, Sheet], tuple[str, ...]]:
    """Return the sheets of the user's library by name, and a message for each unusable file or sheet.

    The library consists of TOML files for `load_sheets`; see `library_folders`. Names of built-in sheets are
    reserved.
    """
    by_name: dict[str, Sheet] = {}
    problems: list[str] = []
    for file in library_files():
        try:
            state = file.stat()
            loaded = _library_file(file, state.st_mtime_ns, state.st_size)
        except (InputError, OSError) as problem:
            problems.append(str(problem))
            continue
        for name, sheet in loaded.items():
            if name in built_in_figures() or name in by_name:
                problems.append(
                    note(
                        "{file}: another sheet already has the name {name!r}: rename this sheet",
                        file=file,
                        name=name,
                    )
                )
            else:
                by_name[name] = sheet
    return by_name, tuple(problems)


SUFFIXES = {"mm": "_mm", "MPa": "_MPa", "kg/m3": "_kg_m3"}


@cache
def sheet_keys() -> Mapping[str, Field]:
    """Return the possible keys in the table of a sheet, with the attribute of `Sheet` for each key."""
    keys = {entry.name + SUFFIXES.get(entry.option.unit, ""): entry for entry in declared(Sheet)}
    return MappingProxyType(keys | {NOMINAL_KEY: keys["poisson_ratio"]})


@lru_cache(maxsize=64)
def _library_file(path: Path, *_state: int) -> Mapping[str, Sheet]:
    """Load a file of sheets, cached while its `_state` (time and size) does not change."""
    return load_sheets(path)


def _sheet_of_file(name: str, folder: Path | None) -> Sheet:
    """Return the only sheet of "my.toml", or the sheet NAME for "my.toml:NAME"."""
    stem, sign, sheet_name = name.partition(".toml:")
    path = (folder or Path()) / (f"{stem}.toml" if sign else name)
    sheets = load_sheets(path)
    if not sheet_name and len(sheets) == 1:
        return next(iter(sheets.values()))
    if (called := plain_name(sheet_name)) in sheets:
        return sheets[called]
    several = (
        note("there is no sheet {wanted!r}", wanted=sheet_name)
        if sheet_name
        else note("there are {count} sheets", count=len(sheets))
    )
    choices = " or ".join(f"{path.name}:{key}" for key in sheets)
    raise InputError(f"{path}: {several}; use the name {choices}")


def load_sheets(path: str | Path) -> dict[str, Sheet]:
    """Load sheets from a TOML file.

    The file contains a table ``[sheets.NAME]`` for each sheet, with ``thickness_mm``, ``youngs_modulus_MPa``,
    ``density_kg_m3`` and ``max_strain``. Optional keys are ``kerf_mm``, ``poisson_ratio`` (or
    ``nominal_poisson_ratio`` for estimates only), ``grain``, ``kind``, ``source`` and ranges such as
    ``youngs_modulus_range_MPa = [8200, 10300]``. ``grain`` is a word, or an angle of 0 or 90 degrees.

    Examples
    --------
    >>> from tempfile import TemporaryDirectory
    >>> figures = "thickness_mm = 0.5\\nyoungs_modulus_MPa = 2700\\ndensity_kg_m3 = 1410\\nmax_strain = 0.03"
    >>> with TemporaryDirectory() as folder:
    ...     file = Path(folder, "mine.toml")
    ...     _ = file.write_text("[sheets.my-pom]\\n" + figures)
    ...     round(load_sheets(file)["my-pom"].elasto_gravity_length, 1)
    159.6
    """
    return sheets_from_table(_read_table(path), where=str(path))


def sheets_from_table(table: object, *, where: str) -> dict[str, Sheet]:
    """Return the sheets of the parsed table ``sheets`` of a TOML file; messages call the file `where`."""
    if not isinstance(table, Mapping) or not table:
        raise InputError(f"{where} contains no sheet: add a table [sheets.NAME]")
    figures = {name: _fields(name, entry, where) for name, entry in table.items()}
    try:
        sheets = [Sheet(name=name, **fields) for name, fields in figures.items()]
    except InputError as error:
        raise InputError(f"{where}: {error}") from error
    return {sheet.name: sheet for sheet in sheets}


@dataclass(frozen=True)
class SheetForCurve:
    """Sheet, and the least scale at which it withstands a curve.

    Attributes
    ----------
    sheet : Sheet
    scale : float
        Largest strain of a strip in the shape of the curve, divided by the long-term limit of the sheet. At 1 or
        less the sheet withstands the curve as drawn. Above 1, the curve must be enlarged by this factor.
    """

    sheet: Sheet
    scale: float

    @property
    def fits(self) -> bool:
        """True if the sheet withstands the curve as drawn."""
        return self.scale <= 1.0


def sheets_for_curve(
    curve: PlaneCurve,
    natural_curvature: NaturalCurvature = 0.0,
    sheets: Iterable[Sheet] | None = None,
) -> tuple[SheetForCurve, ...]:
    """Return the sheets, by default all known ones, sorted by the least scale at which they withstand a curve.

    The surface strain of a sheet is half its thickness times the absolute change of curvature.

    Parameters
    ----------
    curve : PlaneCurve
    natural_curvature : float or RestCurvature
        Curvature of the strip before it is bent, 1/mm.

    Examples
    --------
    >>> arc = PlaneCurve.arc((0, 0), 50, 0, 2)
    >>> found = {one.sheet.name: one for one in sheets_for_curve(arc)}
    >>> found["birch-plywood-0.8"].fits, round(found["birch-plywood-3"].scale, 1)
    (True, 5.6)
    """
    sharpest = float(np.abs(ExcessCurvature(curve, natural_curvature).survey).max())
    scaled = [
        SheetForCurve(sheet, sharpest * sheet.thickness / (2 * sheet.max_strain))
        for sheet in (cut_sheets() if sheets is None else sheets)
    ]
    return tuple(sorted(scaled, key=lambda sheet: sheet.scale))


Color: TypeAlias = tuple[float, float, float]
"""Red, green and blue, from 0 to 1."""


def hex_color(color: Color) -> str:
    """Return a colour as "#rrggbb".

    Examples
    --------
    >>> hex_color((0.2, 0.4, 1.0))
    '#3366ff'
    """
    return "#" + "".join(f"{round(255 * part):02x}" for part in color)


_COLOR_BY_NAME = {
    "pom": (0.93, 0.93, 0.90),
    "polypropylene": (0.88, 0.91, 0.93),
    "petg": (0.72, 0.85, 0.88),
    "acrylic": (0.66, 0.82, 0.90),
    "gfrp": (0.78, 0.80, 0.60),
    "carbon": (0.24, 0.25, 0.27),
}
_COLOR_BY_KIND = {
    "plywood": (0.85, 0.70, 0.48),
    "wood": (0.80, 0.62, 0.40),
    "card": (0.94, 0.91, 0.84),
    "board": (0.66, 0.50, 0.34),
    "metal": (0.70, 0.72, 0.75),
    "plastic": (0.85, 0.87, 0.88),
    "composite": (0.78, 0.80, 0.60),
    "rod": (0.78, 0.80, 0.60),
}


def sheet_color(sheet: Sheet) -> Color:
    """Return the colour in which pictures show a sheet, by its name or else by its kind.

    Examples
    --------
    >>> sheet_color(Sheet.named("card-200gsm"))
    (0.94, 0.91, 0.84)
    """
    sheet = Sheet.of(sheet)
    for name, color in _COLOR_BY_NAME.items():
        if sheet.name.startswith(name):
            return color
    return _COLOR_BY_KIND.get(sheet.kind, (0.80, 0.74, 0.62))
