"""Conversion of tables of design files to records, and access to keys by their path."""

import tomllib
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cache
from inspect import signature
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

from elastica_cad._text import plain_name
from elastica_cad._toml import parse_toml
from elastica_cad.declared import (
    REQUIRED,
    Field,
    Kind,
    Option,
    Record,
    declared,
    kind_of,
    name_of,
    require_bounds,
)
from elastica_cad.defaults import KERF
from elastica_cad.design.kit_spec import Cutting, PairCutting, cutting_keys
from elastica_cad.design.tables import FORMER_KEYS, OTHER_WORDS, Formula, Table
from elastica_cad.errors import Either, FieldName, InputError, Refusal, near_names, note, quoted
from elastica_cad.form_finding.limits import Limits
from elastica_cad.geometry.plane_curve import PlaneCurve
from elastica_cad.mechanics.cross_sections import SECTION_KINDS, Section
from elastica_cad.mechanics.elements import Element, Pin, Rail, Tie
from elastica_cad.mechanics.loads import EndName, RestCurvature, Supports
from elastica_cad.mechanics.sheets import Sheet
from elastica_cad.strip.lamination import Laminated
from elastica_cad.strip.perforation import Perforated
from elastica_cad.strip.styles import Plain, Style

if TYPE_CHECKING:
    from elastica_cad.formats.mesh_files import SurfaceReader

CurveReader = Callable[..., list[PlaneCurve]]
"""Function `read_curves(path, unit=...)`."""


# the schema describes a table by the docstring of its function, so each docstring names the result
def _blank(
    stations: Annotated[
        tuple[float, ...],
        Option(
            "Positions along the strip, from 0 to its length. A position that occurs twice marks a jump "
            "of the curvature.",
            "mm",
        ),
    ],
    curvatures: Annotated[
        tuple[float, ...], Option("Curvature at each of these positions; it is linear between them.", "1/mm")
    ],
) -> RestCurvature:
    """A pre-bent strip whose curvature is linear between stations."""
    return RestCurvature.linear(stations, curvatures)


def _drawn_blank(
    curve: Annotated[PlaneCurve, Option("Curve of the pre-bent strip when it is unloaded.")],
) -> RestCurvature:
    """A pre-bent strip that is drawn in its unloaded shape."""
    return RestCurvature.of(curve)


def _limits(strain: bool | float | None = None, *, sheet: Sheet | None, **limits: Any) -> Limits:
    """Return the limits of a strip. If `strain` is True, the strain limit of the sheet is used."""
    limit = None if isinstance(strain, bool) else strain
    return Limits(sheet=sheet if strain else None, strain=limit, **limits)


def _cutting(kerf: float | str = KERF, **options: Any) -> Cutting:
    # the only word for the kerf is "sheet", which `Cutting` stores as None
    named = {cutting_keys()[key].name: value for key, value in options.items()}
    return Cutting(kerf=None if isinstance(kerf, str) else kerf, **named)


BY_KIND: dict[Record, dict[str, Record]] = {
    Style: {"plain": Plain, "perforated": Perforated, "laminated": Laminated},
    Element: {"rail": Rail, "pin": Pin, "tie": Tie},
    Section: SECTION_KINDS,
}
"""Kinds of a record, by the value of the key `kind`. The first kind is the default."""

MAKERS: dict[Record, Callable[..., Any]] = {Limits: _limits, Cutting: _cutting, PairCutting: _cutting}
"""Functions that make a record from its table, if its class does not accept all values of the table."""

WRITTEN: dict[Record, Kind] = {
    Sheet: Kind("text"),
    Formula: Kind("number"),
    Supports: kind_of(tuple[EndName, EndName]),
    RestCurvature: Kind("either", (kind_of(_blank), kind_of(_drawn_blank))),
}
"""Kind of value in a file for each record class that is not written as a table; see `reads`."""


def written(kind: Kind) -> Kind:
    """Return the kind of a value as written in a file.

    It differs for a record that is not written as a table (`WRITTEN`), such as a sheet, which is written as its
    name. For a family of records (`BY_KIND`), it is any record of the family.
    """
    if kind.name == "either":
        alternatives = [alternative for inner in kind.of for alternative in written(inner).alternatives]
        return Kind("either", tuple(dict.fromkeys(alternatives)))
    if kind.name == "table" and kind.record in WRITTEN:
        return WRITTEN[kind.record]
    if kind.name == "table" and kind.record in BY_KIND:
        return Kind("either", tuple(kind_of(record) for record in BY_KIND[kind.record].values()))
    return kind


def fields_of(record: Record) -> tuple[Field, ...]:
    """Return the fields of a table: the fields of its class, and of a second class that the class may name.

    `BESIDE` is the second class, and `WITHOUT` are the names of those of its fields that are excluded. If keys
    and fields have different names, the function `FIELDS` of the first class returns the fields by key.
    """
    if (renamed := getattr(record, "FIELDS", None)) is not None:
        return tuple(replace(entry, name=key) for key, entry in renamed().items())
    declared_here, beside = declared(record), getattr(record, "BESIDE", None)
    without = {*getattr(record, "WITHOUT", ()), *(entry.name for entry in declared_here)}
    inner = fields_of(beside) if beside else ()
    return (*(entry for entry in inner if entry.name not in without), *declared_here)


def idle_keys(record: Record, table: Table) -> dict[str, Refusal]:
    """Return the keys that have no effect beside the other keys of a record's table, each with the reason.

    Examples
    --------
    >>> from elastica_cad.strip.strip_spec import StripSpec
    >>> print(idle_keys(StripSpec, Table({"section": {}}, "", {}))["max_width"])
    max_width has no effect beside section. Leave out one of these keys.
    """
    idle = {}
    for entry in fields_of(record):
        needs = entry.option.needs
        # a function of the keys returns the missing setting, or "" if the key has an effect
        needed = needs if isinstance(needs, str) else needs(table.data)
        if needed and not table.has(needed):
            idle[entry.name] = note(
                "{place} has no effect without {other}. Set {other}, or leave out {key}.",
                place=table.place(entry.name), other=needed, key=entry.name,
            )  # fmt: skip
        for key in entry.option.replaces if table.has(entry.name) else ():
            idle[key] = note(
                "{key} has no effect beside {other}. Leave out one of these keys.",
                key=table.place(key), other=entry.name,
            )  # fmt: skip
    return idle


def require_keys(record: Record, table: Table) -> None:
    """Raise InputError for a key of a table that its record does not have, or that has no effect in it."""
    table.only(*names_of(record))
    for key, reason in idle_keys(record, table).items():
        if table.has(key):
            raise InputError(reason)


def word_of(record: Record) -> str | None:
    """Return the value of the key `kind` that selects a record, or None."""
    return next(
        (word for kinds in BY_KIND.values() for word, other in kinds.items() if other is record), None
    )


def names_of(record: Record) -> list[str]:
    """Return the names of all keys of a record's table."""
    return [*(["kind"] if word_of(record) else []), *(entry.name for entry in fields_of(record))]


@dataclass(frozen=True)
class Reader:
    """Reads records from tables.

    Attributes
    ----------
    sheets : mapping
        Sheets, by name, that a file may use in addition to the known sheets.
    folder : Path
        Folder to which names of files are relative.
    read_curves : callable or None
        Function that reads a curve file.
    read_surface : callable or None
        Function that reads a surface; by default, only meshes are read.
    sheet : Sheet or None
        Sheet of the strip whose table is read.
    """

    sheets: Mapping[str, Sheet] = field(default_factory=dict)
    folder: Path = field(default_factory=Path)
    read_curves: CurveReader | None = None
    read_surface: "SurfaceReader | None" = None
    sheet: Sheet | None = None

    def record(self, record: Record, table: Table) -> Any:
        """Make the record that a table describes.

        In a family of `BY_KIND`, the key `kind` selects the record.
        """
        if record in BY_KIND:
            kinds = BY_KIND[record]
            record = kinds[table.text("kind", next(iter(kinds)), tuple(kinds))]
        values = self.given(record, table)
        make = MAKERS.get(record, record)
        parameters = signature(make).parameters if callable(make) else {}
        # a record that needs a sheet, but has no such key, gets the sheet of the strip
        if "sheet" in parameters and "sheet" not in {entry.name for entry in declared(record)}:
            values["sheet"] = self.sheet
        with table.naming():
            return make(**values)

    def given(self, record: Record, table: Table) -> dict[str, Any]:
        """Return the values in a table by field. Raise InputError for unknown and missing keys."""
        require_keys(record, table)
        values = {}
        for entry in fields_of(record):
            if table.has(entry.name):
                values[entry.name] = self.value(entry.kind, table, entry.name)
                require_bounds(entry, values[entry.name], table.place(entry.name))
            elif entry.default is REQUIRED:
                raise InputError(
                    "{place} is missing. Add this key: {help}",
                    place=table.place(entry.name),
                    help=entry.help.rstrip(".").lower(),
                )
        return values

    def value(self, kind: Kind, table: Table, key: str) -> Any:
        """Return the value of a key after checking its kind."""
        if kind.name == "table" and kind.record in _SPECIAL:
            return _SPECIAL[kind.record](self, table, key)
        match kind.name:
            case "number":
                return table.number(key)
            case "count":
                return table.count(key)
            case "flag":
                return table.flag(key)
            case "text" | "choice":
                return table.text(key, choices=kind.choices)
            case "names":
                return table.table(key).data
            case "table":
                assert kind.record is not None
                return self.record(kind.record, table.table(key))
            case "list":
                return self._row(kind, table, key)
        # the kind is "either"
        return self.value(_best_kind(kind.of, table.raw(key)), table, key)

    def _row(self, kind: Kind, table: Table, key: str) -> tuple[Any, ...]:
        """Return the values of a list: numbers, points, or items of another kind."""
        (inner,), rows = kind.of, table.raw(key)
        if inner.name == "number":
            return table.row(key) if kind.size is None else table.vector(key, kind.size)
        of_size = isinstance(rows, list) and kind.size in (None, len(rows))
        if inner.name == "list" and inner.of[0].name == "number" and not (of_size and rows):
            raise InputError(
                "{key} is not a list of {counts}points {axes}. Write such a list",
                key=table.place(key),
                counts=_COUNTS[kind.size],
                axes=_AXES[inner.size],
            )
        if inner.name == "table" and not isinstance(rows, list):
            table.tables(key)  # raises the error for a list of tables
        if not of_size:
            raise InputError(
                "{place} is {given}, which is not a list. Write a list."
                if kind.size is None
                else "{place} is {given}. Write a list of {size} values.",
                place=table.place(key),
                given=quoted(rows),
                size=kind.size,
            )
        # each item is read as a key of its own, so that errors name its number
        numbered = Table(
            {f"{key}[{i}]": row for i, row in enumerate(rows, start=1)}, table.where, table.scope
        )
        return tuple(self.value(inner, numbered, name) for name in numbered.data)


# words in messages for the size of points and for the number of points in a list
_AXES: Mapping[int | None, str] = {2: "[x, y]", 3: "[x, y, z]"}
_COUNTS = {None: "", 2: "two ", 4: "four "}


def _best_kind(kinds: tuple[Kind, ...], value: object) -> Kind:
    """Return the kind that fits a value best: for a table, the record that knows most of its keys.

    If no kind fits, the caller reads the value as the returned kind, and the user sees the error of that kind.
    """
    fitting = [kind for kind in kinds if _fits(kind, value)]
    if isinstance(value, Mapping):
        return max(fitting, key=lambda kind: _key_score(kind, value), default=kinds[-1])
    return fitting[0] if fitting else next((kind for kind in kinds if kind.name != "flag"), kinds[0])


def _fits(kind: Kind, value: object) -> bool:
    """Return True if a value of a design file can have this kind.

    Formulae are texts, and so fit numbers too.
    """
    if kind.name == "table" and kind.record in WRITTEN:
        return any(_fits(alternative, value) for alternative in written(kind).alternatives)
    match value:
        case bool():
            return kind.name == "flag"
        case str():
            # the word "sheet" is a choice of the kerf, not a formula
            return (
                kind.name == "text" or value in kind.choices or (kind.name == "number" and value != "sheet")
            )
        case int() | float():
            return kind.name in ("number", "count")
        case Mapping():
            return kind.name == "table"
        case list():
            return kind.name == "list" and kind.size in (None, len(value))
    return False


def _key_score(kind: Kind, table: Mapping[str, Any]) -> int:
    # number of keys of the table that the kind knows, minus the number of others
    known = {
        name
        for alternative in written(kind).alternatives
        if alternative.record
        for name in names_of(alternative.record)
    }
    return sum(1 if key in known else -1 for key in table)


def _read_sheet(reader: Reader, table: Table, key: str) -> Sheet:
    """Return the sheet that a key names: a sheet of the file, or a known sheet.

    With the key `sheet`, the key `thickness` of the same table sets the thickness.
    """
    text = table.text(key)
    name = text if ".toml" in text else plain_name(text)
    with table.naming(key):
        sheet = reader.sheets[name] if name in reader.sheets else Sheet.named(name)
        thickness = table.maybe("thickness") if key == "sheet" else None
        return sheet if thickness is None else sheet.with_thickness(thickness)


def _read_supports(reader: Reader, table: Table, key: str) -> Supports:
    names = reader.value(WRITTEN[Supports], table, key)
    with table.naming(key):
        return Supports(*names)


def _read_blank(reader: Reader, table: Table, key: str) -> Any:
    return reader.value(WRITTEN[RestCurvature], table, key)


def _read_formula(_: Reader, table: Table, key: str) -> Formula:
    return Formula(str(table.raw(key)), table.place(key))


_SPECIAL: dict[Record, Callable[[Reader, Table, str], Any]] = {
    Sheet: _read_sheet,
    Supports: _read_supports,
    RestCurvature: _read_blank,
    Formula: _read_formula,
}
"""Functions that read records of some classes from values that are not tables of fields."""


def reads(record: Record, kind: Kind, read: Callable[[Reader, Table, str], Any]) -> None:
    """Register a record class whose records are written as `kind` and read by the function `read`."""
    WRITTEN[record], _SPECIAL[record] = kind, read


def parsed_line(line: str, where: str, example: str = "") -> dict[str, Any]:
    """Parse the inside of an inline table, such as `at = 40, width = 1.2`."""
    inside = line.strip()
    try:
        data = parse_toml(f"line = {inside}" if inside.startswith("{") else f"line = {{{inside}}}")
    except (tomllib.TOMLDecodeError, RecursionError) as error:
        raise InputError(
            "{place}: {line} cannot be read. Write keys and values, such as {example}.",
            place=FieldName(where),
            line=quoted(line),
            example=example or "at = 40, side = 'lower'",
        ) from error
    table: dict[str, Any] = data["line"]
    return table


def title(record: Record) -> str:
    """Return the name of a record's table in the manual and schema.

    If a key `kind` selects the record from a family, the name is the family and the value of `kind`.

    Examples
    --------
    >>> title(Limits), title(Perforated)
    ('limits', 'style perforated')
    """
    word = word_of(record)
    kinds = next((name_of(base) for base, kinds in BY_KIND.items() if record in kinds.values()), "")
    return f"{kinds} {word}" if word else name_of(record)


def described(record: Record) -> list[dict[str, Any]]:
    """Return the fields of a table as plain JSON, for forms and editors.

    A field has the keys name, help, unit, least, most, group, common, required, default and `kind`, the type of
    its value. Some kinds also have `choices`, `size`, `of` (elements or alternatives), or `table` and `fields`.
    `word` is the value of the design's key `kind` that selects the table.

    Examples
    --------
    >>> ratio = described(Limits)[0]
    >>> ratio["name"], ratio["kind"], ratio["least"], ratio["default"]
    ('ratio', 'number', 1, None)
    """
    return [
        {
            "name": entry.name,
            **_plain_kind(entry.kind),
            "help": entry.help,
            "unit": entry.option.unit,
            "least": entry.option.least if entry.option.above is None else entry.option.above,
            "most": entry.option.most,
            "group": entry.option.group,
            "common": entry.option.common,
            "required": entry.default is REQUIRED,
            "default": _plain_default(entry.default),
        }
        for entry in fields_of(record)
    ]


def _plain_kind(kind: Kind) -> dict[str, Any]:
    """Return a kind as plain data, with the fields of its tables."""
    kind = written(kind)
    plain: dict[str, Any] = {"kind": kind.name}
    if kind.choices:
        plain["choices"] = list(kind.choices)
    if kind.size is not None:
        plain["size"] = kind.size
    if kind.of:
        plain["of"] = [_plain_kind(part) for part in kind.of]
    if kind.record is not None:
        plain |= {"table": title(kind.record), "word": word_of(kind.record), "fields": described(kind.record)}
    return plain


def _plain_default(value: Any) -> Any:
    """Return a default value as plain JSON, or None for a record, whose fields have defaults themselves."""
    if isinstance(value, tuple):
        plain = [_plain_default(item) for item in value]
        return None if None in plain else plain
    return value if isinstance(value, bool | int | float | str) else None


@cache
def paths_of(record: Record) -> Mapping[str, Field]:
    """Return all keys of a record by their dotted paths. Tables in a list have the path of a single table.

    Examples
    --------
    >>> from elastica_cad.strip.strip_spec import StripSpec
    >>> paths_of(StripSpec)["limits.ratio"].option.least, "slots.at" in paths_of(StripSpec)
    (1, True)
    """
    entries: dict[str, Field] = {}
    for path, entry in _walked(record):
        entries.setdefault(path, entry)
    return entries


def _walked(record: Record) -> Iterator[tuple[str, Field]]:
    """Yield all keys of a record with their paths, such as `style.kind`, also those of inner tables."""
    without = getattr(record, "WITHOUT", ())
    for key in fields_of(record):
        if key.name in without:
            continue
        yield key.name, key
        kind = written(key.kind)
        # values of the key `kind`, which selects the record and is not a field of it
        words = tuple(word for part in kind.alternatives if part.record and (word := word_of(part.record)))
        for inner in tables_in(kind):
            if word := word_of(inner):
                yield f"{key.name}.kind", Field("kind", Kind("choice", choices=words), key.option, word)
            for path, entry in _walked(inner):
                yield f"{key.name}.{path}", entry


def tables_in(kind: Kind) -> list[Record]:
    """Return the record classes of all tables that a value of this kind may contain."""
    inner_tables = [inner for part in kind.of for inner in tables_in(written(part))]
    return [*inner_tables, *([kind.record] if kind.record is not None else [])]


def put(table: dict[str, Any], path: str, value: Any) -> None:
    """Set the value at a dotted path in nested tables. Missing tables are created."""
    *parents, last = path.split(".")
    for key in parents:
        inner = table.setdefault(key, {})
        if not isinstance(inner, dict):
            raise InputError(
                "{key} is {inner}, so {path} cannot be set too. Leave out {key} or {path}.",
                key=key,
                inner=quoted(inner),
                path=path,
            )
        table = inner
    table[last] = value


def current_path(path: str) -> str:
    """Return the path of a key in its present names.

    Examples
    --------
    >>> current_path("law.kind")
    'section.kind'
    """
    return ".".join(FORMER_KEYS.get(name, name) for name in path.split("."))


def require_path_of(path: str, record: Record) -> Field:
    """Return the field at a dotted path."""
    known = paths_of(record)
    if path not in known:
        meant = meant_paths(path, known)
        tables = [name for name in known if "." not in name]
        listed = (
            f"the keys here are {', '.join(tables)}" if len(tables) <= 20 else "`elastica help` lists them"
        )
        hint = f"did you mean {Either(meant)}?" if meant else listed
        raise InputError("The key {path} does not exist: {hint}", path=quoted(path), hint=hint)
    return known[path]


def meant_paths(typed: str, known: Mapping[str, Field]) -> list[str]:
    """Return the known paths for which an unknown path may stand.

    A word of `OTHER_WORDS` stands for its key only. Other names stand for the paths with the same last name or, if
    there are none, with a last name of similar spelling. Keys in a list of tables, which `--set` cannot set, are
    returned only if there are no others.

    Examples
    --------
    >>> from elastica_cad.design.model_tables import DesignKeys
    >>> [meant_paths(typed, paths_of(DesignKeys)) for typed in ("kerf", "limits.ration", "boarder")]
    [['cut.kerf'], ['limits.ratio'], ['revolution.border', 'base.border', 'rings.border', 'frame.border']]
    """
    word = OTHER_WORDS.get(typed, "")
    if word or typed in known:
        return [path for path in (word, typed) if path in known][:1]
    last = typed.rpartition(".")[2]
    names = dict.fromkeys(path.rpartition(".")[2] for path in known)
    near = [last] if last in names else near_names(last, names, cutoff=0.75)
    alike = [path for path in known if path.rpartition(".")[2] in near]
    if "." in typed:
        return near_names(typed, alike) or alike
    alike = [path for path in alike if path.count(".") == min(path.count(".") for path in alike)]
    return [path for path in alike if is_settable(path, known)] or alike


def is_settable(path: str, known: Mapping[str, Field]) -> bool:
    """Return True if `--set` can set a key, which is not in a list of tables such as `strips`."""
    head = path.partition(".")[0]
    return head == path or written(known[head].kind).name != "list"


def help_with_unit(help: str, unit: str) -> str:
    """Return the help of a field, followed by its unit."""
    return f"{help.rstrip('.')} ({unit})." if unit else help
