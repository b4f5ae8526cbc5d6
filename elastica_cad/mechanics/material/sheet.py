"""A sheet of material as a record: what it weighs, how it bends, what it bears, and how sharply plywood bends."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from difflib import get_close_matches
from functools import cache, lru_cache
from os import PathLike
from pathlib import Path
from types import MappingProxyType
from typing import Annotated, Any, Literal, TypeAlias, get_args

import numpy as np

from elastica_cad._notebook import html_table
from elastica_cad._units import MM_PER_INCH
from elastica_cad._values import is_number, is_one_of, is_series, require_number
from elastica_cad.declared import Asked, Field, declared
from elastica_cad.errors import InputError
from elastica_cad.mechanics.loads.gravity import Gravity
from elastica_cad.mechanics.loads.weight import STANDARD_GRAVITY_M_S2
from elastica_cad.mechanics.material.sheet_library import (
    NOMINAL_KEY,
    OPTIONAL_UNITS,
    UNITS,
    USUAL_RATIO,
    NominalRatio,
    built_in_figures,
    built_in_titles,
    checked_poisson_ratio,
    even_shear_ratio,
    figures_from_table,
    finite_number,
    library_files,
    read_figures,
    require_printable,
    toml_text,
    toml_value,
)
from elastica_cad.refusals import note

PLYWOOD_SOURCE = "FAA AC 43.13-1B, table 1-2, 10 % moisture, cold mandrels"

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
"""Rows of the table by number of plies."""

SOLD_AS = 0.02
"""Share by which a sheet may be thinner than the first row of its number of plies: 4 mm is sold as 0.160 in."""

TOLD_TO = 0.01
"""Relative accuracy of a radius: the table has two digits, and the largest strain of a sheet is rounded."""

LEAST_MM, LARGEST_MM = 0.7, 9.6
"""Range of thicknesses for which the rows are used: a sheet of 0.8 mm has the strain of the thinnest row, 0.89
mm."""


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
        table = MM_PER_INCH * np.array(rows)
        inside = table[0, 0] * (1 - SOLD_AS) <= thickness <= table[-1, 0]
        thinnest, thickest = min(ROWS_INCH), max(ROWS_INCH)
        below = thickness < table[0, 0] and rows is ROWS_INCH[thinnest]
        above = thickness > table[-1, 0] and rows is ROWS_INCH[thickest]
        if inside or below or above:
            strains.append(float(np.interp(thickness, table[:, 0], table[:, 0] / (2 * table[:, column]))))
    return thickness / (2 * min(strains))


Grain: TypeAlias = Literal["along", "across", "none"]
Range: TypeAlias = tuple[float, float]


@dataclass(frozen=True)
class Sheet:
    """A sheet material at one thickness; all numbers hold along the strip.

    Parameters
    ----------
    name : str
        What the sheet is called in reports and file names.
    thickness : float
        h, mm.
    youngs_modulus : float
        E in bending along the strip, MPa (N/mm2).
    density : float
        rho, kg/m3.
    max_strain : float
        Largest skin strain to be borne for long, dimensionless (0.01 = 1 %).
    kerf : float
        Width of material that the laser takes away, mm; 0 when not known.
    poisson_ratio : float
        nu, dimensionless; 0 where the modulus is that of a plate, measured on a wide coupon. A number given here
        is known, and widths make up for it (`poisson_known`); without one, or as a `NominalRatio`, it is only
        estimated with.
    shear_modulus : float, optional
        G of shear in the sheet's plane, MPa, which twist works against; without it E / (2 (1 + nu)), as of sheets
        without grain. That of plywood is far less.
    grain : "along", "across" or "none"
        How the strip lies to the (face) grain for which the numbers hold; "none" for sheets without grain. 0 and
        90, degrees, say the first two.
    kind : str
        Family of materials, for example "plywood".
    source : str
        Where the numbers come from.
    thickness_range, youngs_modulus_range, density_range, max_strain_range, kerf_range : (low, high), optional
        What is found in practice, in the number's own unit; without it the number is taken as certain.
    least_width, least_ligament, least_bridge : float, optional
        Narrowest strip or tongue, ligament of a perforated strip, and bridge between the cuts of a plate that can
        be cut and lifted out, mm; without them rules of thumb speak (`FabricationLimits`).
    stock : (float, float), optional
        Sides of the largest sheet on sale, mm.
    break_strain : float, optional
        Skin strain at which it breaks; without it wood and brittle plastics are taken to break at 1.5 times
        `max_strain`, other sheets to bend (`mechanics.material.section_limits`).

    Raises
    ------
    InputError
        A number that no sheet can have, or a range that does not hold its number.

    Examples
    --------
    >>> ply = Sheet("my-ply", thickness=0.8, youngs_modulus=9250.0, density=680.0, max_strain=0.008)
    >>> ply.least_radius
    50.0
    >>> round(Sheet.named("card-200gsm").elasto_gravity_length, 1)
    96.0
    """

    name: str
    thickness: Annotated[float, Asked("Thickness of the sheet.", "mm", least=0)]
    youngs_modulus: Annotated[float, Asked("Young's modulus in bending along the strip.", "MPa", least=0)]
    density: Annotated[float, Asked("Density.", "kg/m3", least=0)]
    max_strain: Annotated[
        float, Asked("Largest strain of the skin that is borne for long: 0.01 is 1 %.", least=0)
    ]
    kerf: Annotated[float, Asked("Width that the laser burns away.", "mm", least=0)] = 0.0
    poisson_ratio: Annotated[float, Asked("Poisson's ratio, where it is known.", least=0)] = USUAL_RATIO
    grain: Annotated[
        Grain,
        Asked(
            "How the strip lies to the face grain: along, across or none; or 0 or 90 degrees.",
            written=float | str,
        ),
    ] = "none"
    kind: Annotated[str, Asked("Family of materials.")] = ""
    source: Annotated[str, Asked("Where the numbers come from.")] = ""
    thickness_range: Annotated[
        Range | None, Asked("Least and largest thickness found in practice.", "mm", least=0)
    ] = None
    youngs_modulus_range: Annotated[
        Range | None, Asked("Least and largest modulus found in practice.", "MPa", least=0)
    ] = None
    density_range: Annotated[
        Range | None, Asked("Least and largest density found in practice.", "kg/m3", least=0)
    ] = None
    max_strain_range: Annotated[
        Range | None, Asked("Least and largest of the strain that is borne.", least=0)
    ] = None
    kerf_range: Annotated[Range | None, Asked("Least and largest kerf found in practice.", "mm", least=0)] = (
        None
    )
    least_width: Annotated[
        float | None, Asked("Narrowest strip or tongue that can be cut.", "mm", least=0)
    ] = None
    least_ligament: Annotated[
        float | None, Asked("Narrowest ligament of a perforated strip.", "mm", least=0)
    ] = None
    least_bridge: Annotated[
        float | None, Asked("Narrowest bridge between the cuts of a plate.", "mm", least=0)
    ] = None
    stock: Annotated[Range | None, Asked("Sides of the largest sheet on sale.", "mm", least=0)] = None
    shear_modulus: Annotated[
        float | None, Asked("Shear modulus in the plane of the sheet.", "MPa", least=0)
    ] = None
    break_strain: Annotated[float | None, Asked("Strain of the skin at which it breaks.", least=0)] = None
    poisson_known: bool = field(init=False, repr=False)

    def __post_init__(self) -> None:
        if not isinstance(self.name, str) or not self.name.strip():
            raise InputError("a sheet needs a name, got {name!r}", name=self.name)
        require_printable(self.name, "the sheet's name")
        sides = tuple(self.stock) if is_series(self.stock) else ()
        if self.stock is not None and len(sides) != 2:
            raise InputError(
                "sheet {name!r}: stock is {stock!r}; it must be two sides, in mm",
                name=self.name,
                stock=self.stock,
            )
        object.__setattr__(self, "stock", sides or None)
        for field_name, unit in UNITS.items():
            value = self._checked(field_name, getattr(self, field_name), unit)
            object.__setattr__(self, field_name, value)
            self._check_range(field_name, value)
        nu = checked_poisson_ratio(self.poisson_ratio, f"sheet {self.name!r}")
        object.__setattr__(self, "poisson_ratio", nu)
        object.__setattr__(self, "poisson_known", not isinstance(nu, NominalRatio))
        figures = [(name, getattr(self, name), unit) for name, unit in OPTIONAL_UNITS.items()]
        for name, given, unit in [*figures, *(("stock", side, "mm") for side in sides)]:
            if given is not None:
                self._checked(name, given, unit)
        asked: object = self.grain
        if is_number(asked):
            object.__setattr__(self, "grain", self._grain_at(asked))
        if not is_one_of(self.grain, get_args(Grain)):
            raise InputError(
                "sheet {name!r}: grain is {grain!r}; use one of {names}",
                name=self.name,
                grain=self.grain,
                names=", ".join(get_args(Grain)),
            )

    def _checked(self, field_name: str, given: Any, unit: str) -> float:
        """The number, unless it is no positive one; a kerf may be 0."""
        value = finite_number(given, f"sheet {self.name!r}: {field_name}")
        if value < 0 or (value == 0 and field_name != "kerf"):
            raise InputError(
                "sheet {name!r}: {field_name} is {given:g}; it must be {least}, in {unit}",
                name=self.name,
                field_name=field_name,
                given=value,
                least="zero or positive" if field_name == "kerf" else "positive",
                unit=unit,
            )
        return value

    def _grain_at(self, degrees: float) -> Grain:
        """The word for a strip that lies at so many degrees to the grain."""
        turned: dict[float, Grain] = {0.0: "along", 90.0: "across"}
        if degrees % 180 not in turned:
            raise InputError(
                "sheet {name!r}: grain is {degrees:g} degrees; a strip that lies askew to its grain "
                "twists when it is bent, and takes no plane curve: lay it along (0) or across (90) "
                "the grain",
                name=self.name,
                degrees=degrees,
            )
        return turned[degrees % 180]

    def _check_range(self, field_name: str, value: float) -> None:
        given = getattr(self, f"{field_name}_range")
        if given is None:
            return
        where = f"sheet {self.name!r}: {field_name}_range"
        if not isinstance(given, list | tuple) or len(given) != 2:
            raise InputError(
                "{place} is {given!r}; it must be two numbers, lowest and highest", place=where, given=given
            )
        low, high = (finite_number(v, where) for v in given)
        if not 0 <= low <= value <= high:
            raise InputError(
                "{place} is {low:g} to {high:g}; it must hold {field_name} = {given:g}, lowest first",
                place=where,
                low=low,
                high=high,
                field_name=field_name,
                given=value,
            )
        object.__setattr__(self, f"{field_name}_range", (low, high))

    @classmethod
    def of(cls, given: "Sheet | str") -> "Sheet":
        """The sheet given, or the one of that name (see `named`).

        Raises
        ------
        InputError
            What is neither.

        Examples
        --------
        >>> Sheet.of("mdf-3").thickness
        3.0
        """
        if isinstance(given, str):
            return cls.named(given)
        if not isinstance(given, Sheet):
            raise InputError(
                "a Sheet or the name of one is needed, such as 'birch-plywood-0.8', not {name}: "
                "`sheet_names()` lists them",
                name=type(given).__name__,
            )
        return given

    @classmethod
    def named(cls, name: str, *, folder: Path | None = None) -> "Sheet":
        """The sheet called `name`, built in or in the user's library, or the one in a file of sheets.

        Parameters
        ----------
        name : str
            A name that `sheet_names` lists; a file, "my.toml"; or one sheet of a file, "my.toml:NAME".
        folder : Path, optional
            Where files are looked for; the working folder unless given.

        Raises
        ------
        InputError
            Unknown name, of which the nearest ones are offered; or a file that is not as `load_sheets` reads it.
        """
        if not isinstance(name, str | PathLike):
            raise InputError(
                "the name of a sheet is needed, such as 'birch-plywood-0.8', not {name}: "
                "`sheet_names()` lists them",
                name=type(name).__name__,
            )
        figures = built_in_figures()
        if name in figures:
            return cls(name, **figures[name])
        if str(name).endswith(".toml") or ".toml:" in str(name):
            return _sheet_of_file(str(name), folder)
        own, problems = library_sheets()
        if name in own:
            return own[name]
        known = [*own, *figures]
        near = get_close_matches(str(name).lower(), known, n=3, cutoff=0.4)
        advice = (
            note("did you mean {names}?", names=" or ".join(near))
            if near
            else note("known sheets: {names}", names=", ".join(known))
        )
        raise InputError("; ".join((f"unknown sheet {name!r}: {advice}", *problems)))

    def with_thickness(self, thickness: float) -> "Sheet":
        """Return the same material at another thickness, mm; of plywood the strain limit follows the published
        radii.

        Examples
        --------
        >>> thick = Sheet.named("birch-plywood-3").with_thickness(3.6)
        >>> thick.name, round(thick.least_radius)
        ('birch-plywood-3.6', 359)
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
        told = "; ".join(filter(None, (self.source, f"figures of {self.name} at another thickness")))
        return replace(
            changed,
            name=f"{stem}-{changed.thickness:g}",
            max_strain=limit,
            max_strain_range=spread,
            source=told,
        )

    @property
    def published_radius(self) -> float | None:
        """Least radius published for plywood of this thickness and grain, mm; None for other sheets."""
        if self.kind != "plywood" or self.grain == "none":
            return None
        return least_plywood_radius(self.thickness, self.grain)

    @property
    def shear_ratio(self) -> float:
        """G / E: as known, else that of a sheet without grain."""
        G = self.shear_modulus
        return even_shear_ratio(self.poisson_ratio) if G is None else G / self.youngs_modulus

    @property
    def elasto_gravity_length(self) -> float:
        """(E h^2 / (12 rho g))^(1/3), mm (section 5.1): a much shorter strip does not feel its weight."""
        weight = self.density * 1e-9 * STANDARD_GRAVITY_M_S2  # N/mm3
        return float((self.youngs_modulus * self.thickness**2 / (12 * weight)) ** (1 / 3))

    def gravity(self, direction: tuple[float, float] = (0.0, -1.0)) -> Gravity:
        """Weight of a plain strip of this sheet; `direction` (2,): where things fall in the curve's plane."""
        return Gravity(self.elasto_gravity_length, direction)

    @property
    def full_name(self) -> str:
        """The name in words, "Birch plywood 0.8 mm"; of a user's own sheet its name.

        Examples
        --------
        >>> Sheet.named("card-200gsm").full_name
        'Card 200 g/m2'
        """
        return built_in_titles().get(self.name, self.name)

    @property
    def least_radius(self) -> float:
        """Smallest radius that the sheet bends to, mm: h / (2 max_strain), the skin being h/2 off centre."""
        return self.thickness / (2 * self.max_strain)

    def bending_stiffness(self, width: float) -> float:
        """E h^3 w / 12 of a plain strip of `width` mm, N mm2."""
        return (
            self.youngs_modulus * self.thickness**3 * require_number(width, "the width of a strip", "mm") / 12
        )

    def range_of(self, quantity: str) -> Range:
        """Lowest and highest `quantity` ("youngs_modulus", "thickness", ...); the number twice if certain."""
        if not isinstance(quantity, str) or quantity not in UNITS:
            raise InputError(
                "a sheet has no range of {quantity!r}: use one of {units}",
                quantity=quantity,
                units=", ".join(UNITS),
            )
        given: Range | None = getattr(self, f"{quantity}_range")
        value = float(getattr(self, quantity))
        return (value, value) if given is None else given

    def _repr_html_(self) -> str:
        rows = []
        for name, unit in UNITS.items():
            low, high = self.range_of(name)
            spread = f"{low:g} to {high:g}" if low < high else ""
            number = f"{getattr(self, name):g}"
            rows.append({"": name.replace("_", " "), "value": number, "in practice": spread, "unit": unit})
        return html_table(f"Sheet {self.name!r}", rows)

    def toml(self) -> str:
        """The sheet as an entry of a sheets file, as `load_sheets` reads it."""
        lines = [f"[sheets.{toml_text(self.name)}]"]
        for key, field_name in ((key, one.name) for key, one in sheet_keys().items()):
            value = getattr(self, field_name)
            if value is None or (field_name in ("kind", "source") and not value):
                continue
            if field_name == "poisson_ratio" and self.poisson_known == (key == NOMINAL_KEY):
                continue
            lines.append(f"{key} = {toml_value(value)}")
        return "\n".join(lines) + "\n"


def sheet_names() -> list[str]:
    """Names of the user's sheets and of the built-in ones; `Sheet.named(name).source` says where numbers come from.

    Examples
    --------
    >>> "birch-plywood-0.8" in sheet_names()
    True
    """
    return [*library_sheets()[0], *built_in_figures()]


KINDS = {
    "card": "Card and paper", "plywood": "Plywood", "wood": "Solid wood, veneer and bamboo", "plastic": "Plastics",
    "board": "Fibre boards", "metal": "Metals", "composite": "Composites",
}  # fmt: skip
"""What the kinds of sheets are called in a list."""


def sheets_by_kind() -> dict[str, list[Sheet]]:
    """All sheets of `sheet_names`, under what their kinds are called."""
    found: dict[str, list[Sheet]] = {}
    for one in map(Sheet.named, sheet_names()):
        found.setdefault(KINDS.get(one.kind, one.kind.capitalize() or "Other"), []).append(one)
    return found


def library_sheets() -> tuple[Mapping[str, Sheet], tuple[str, ...]]:
    """The sheets of the user's library by name, and a sentence for each file or sheet there that cannot be used.

    The library is `elastica/sheets` in the user's folder for settings, or what the environment variable
    `ELASTICA_SHEETS` names: folders of TOML files as `load_sheets` reads them. Names of built-in sheets are theirs.
    """
    own: dict[str, Sheet] = {}
    problems: list[str] = []
    for file in library_files():
        try:
            state = file.stat()
            found = _library_file(file, state.st_mtime_ns, state.st_size)
        except (InputError, OSError) as problem:
            problems.append(str(problem))
            continue
        for name, sheet in found.items():
            if name in built_in_figures() or name in own:
                problems.append(
                    note(
                        "{file}: the name {name!r} is taken: call that sheet otherwise", file=file, name=name
                    )
                )
            else:
                own[name] = sheet
    return own, tuple(problems)


SUFFIXES = {"mm": "_mm", "MPa": "_MPa", "kg/m3": "_kg_m3"}
"""Of keys in files, which say their unit."""


@cache
def sheet_keys() -> Mapping[str, Field]:
    """What a table of a sheet may hold: the fields of `Sheet`, by keys that say their unit."""
    known = {one.name + SUFFIXES.get(one.asked.unit, ""): one for one in declared(Sheet)}
    return MappingProxyType(known | {NOMINAL_KEY: known["poisson_ratio"]})


@lru_cache(maxsize=64)
def _library_file(path: Path, *_state: int) -> Mapping[str, Sheet]:
    """The file as it is in this state; it is asked for often."""
    return load_sheets(path)


def _sheet_of_file(name: str, folder: Path | None) -> Sheet:
    """The only sheet of "my.toml", or the one called NAME of "my.toml:NAME"."""
    stem, sign, wanted = name.partition(".toml:")
    path = (folder or Path()) / (f"{stem}.toml" if sign else name)
    found = load_sheets(path)
    if not wanted and len(found) == 1:
        return next(iter(found.values()))
    if wanted in found:
        return found[wanted]
    several = (
        note("there is no sheet {wanted!r}", wanted=wanted)
        if wanted
        else note("there are {count} sheets", count=len(found))
    )
    choices = " or ".join(f"{path.name}:{one}" for one in found)
    raise InputError("{path}: {several}: name one, {choices}", path=path, several=several, choices=choices)


def load_sheets(path: str | Path) -> dict[str, Sheet]:
    """A user's own sheets from a TOML file.

    The file holds tables ``[sheets.NAME]`` with ``thickness_mm``, ``youngs_modulus_MPa``, ``density_kg_m3``
    and ``max_strain``, and where known ``kerf_mm``, ``poisson_ratio`` (``nominal_poisson_ratio`` for one to be
    estimated with only), ``grain``, ``kind``, ``source`` and ranges such as ``youngs_modulus_range_MPa = [8200,
    10300]``; ``grain`` is a word or 0 or 90 degrees.

    Raises
    ------
    InputError
        No such file, not TOML, an unknown key, a missing or impossible value; file, sheet and key are named.

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
    return _sheets(read_figures(path, sheet_keys()), str(path))


def sheets_from_table(table: object, *, where: str) -> dict[str, Sheet]:
    """Sheets from the parsed table ``sheets`` of a TOML file; `where` names the file in messages.

    Raises
    ------
    InputError
        As `load_sheets`.
    """
    return _sheets(figures_from_table(table, where, sheet_keys()), where)


def _sheets(figures: Mapping[str, Mapping[str, Any]], file: str) -> dict[str, Sheet]:
    """Sheets of these fields; a complaint names the file."""
    try:
        return {name: Sheet(name=name, **fields) for name, fields in figures.items()}
    except InputError as error:
        raise InputError("{file}: {error}", file=file, error=error) from error
