"""Design files: read and check the description of a model in TOML, and make the model.

A number may be written as a formula in quotes (see `tables.Formula`). Lengths are in mm, angles in rad (30 *
degrees). `design_schema.tables` lists all keys with their descriptions.
"""

import tomllib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, fields, replace
from functools import cache
from os import PathLike
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

import numpy as np

from elastica_cad._text import quote_words
from elastica_cad._toml import parse_toml
from elastica_cad._values import several, value_key
from elastica_cad.declared import Record, require_bounds
from elastica_cad.design.kit_spec import KitSpec
from elastica_cad.design.model_tables import HOLDERS, PATTERNS, DesignKeys, read_kit, share_keys
from elastica_cad.design.records import CurveReader, Reader, fields_of, names_of, require_keys
from elastica_cad.design.strip_table import StripEntry, StripKeys, read_strip, split_curve, split_entry
from elastica_cad.design.tables import Slips, Table, merged, with_present_keys
from elastica_cad.errors import (
    ElasticaError,
    InputError,
    NotConvergedError,
    Refusal,
    ended,
    note,
    quoted,
    toml_slip,
)
from elastica_cad.form_finding.limits import Keep, Limits
from elastica_cad.formats.source_file import file_in, read_below, require_below, require_file
from elastica_cad.mechanics.sheets import Sheet, load_sheets, sheets_from_table
from elastica_cad.mechanics.theorem1 import NotRealizable
from elastica_cad.model.interlocking import interlock
from elastica_cad.model.model import Model, interlock_compensated
from elastica_cad.strip.outline import Tab
from elastica_cad.strip.strip import Placed, Strip

if TYPE_CHECKING:
    from elastica_cad.design.revolution_table import RevolutionTable
    from elastica_cad.form_finding.section_lines import SectionCurve
    from elastica_cad.formats.mesh_files import SurfaceReader
    from elastica_cad.model.frames import Rib
    from elastica_cad.model.plates import Ring

DESIGN_SCHEMA = 1


@dataclass(frozen=True, eq=False)
class Design:
    """Contents of a design file after reading and checking. `model` makes the strips.

    Attributes
    ----------
    name : str
    entries : tuple of StripEntry
        Strips in the order of the file.
    patterns : tuple of (name, options)
        Patterns ("mirror", "rotate" or "repeat") with their options, in the order of application.
    interlock : dict or None
        Options of `Model.interlock`, if requested.
    kit : KitSpec
        Sheets, cutting files, holders and further pieces.
    reports : tuple of str
        Messages about sections of meshes and about meridians.
    revolution : RevolutionTable or None
        Surface of revolution. Its strips come before the other strips.
    """

    name: str
    entries: tuple[StripEntry, ...]
    patterns: tuple[tuple[str, dict[str, Any]], ...] = ()
    interlock: dict[str, Any] | None = None
    kit: KitSpec = field(default_factory=KitSpec)
    reports: tuple[str, ...] = ()
    revolution: "RevolutionTable | None" = None

    def with_limits_ignored(self) -> "Design":
        """Return the design with `ignore_limits`: parts beyond the limits of the workshop are made with a
        warning.
        """
        return replace(
            self,
            entries=tuple(
                replace(entry, spec=entry.spec.changed(ignore_limits=True)) for entry in self.entries
            ),
            revolution=None if self.revolution is None else replace(self.revolution, ignore_limits=True),
            kit=replace(self.kit, ignore_limits=True),
        )

    def nearest(self) -> "Design":
        """Return the design with strips that may deviate from their curves as little as necessary."""
        freed = (
            entry
            if entry.spec.may_change
            else replace(entry, spec=entry.spec.changed(limits=Limits(), keep=Keep()))
            for entry in self.entries
        )
        return replace(self, entries=tuple(freed))

    def model(self, done: Callable[[str], None] | None = None) -> Model:
        """Make all strips, place them, and apply patterns and interlocking.

        Parameters
        ----------
        done : callable, optional
            Function that is called with the label of each finished strip.

        Raises
        ------
        NotRealizable, NotConvergedError, InputError
            Errors of `StripSpec.make` and `Model.interlock`. A single error contains the messages of all strips,
            with their names. Sections that no strip can follow are left out and reported. If no strip remains,
            the error of the first section is raised.
        """
        strips: dict[Any, Strip] = {}
        placed: list[Placed] = []
        # errors of strips on sections, which are left out, and errors of other strips
        failed: list[ElasticaError] = []
        refused: list[ElasticaError] = []
        for entry in self.entries:
            # strips that differ only by label, position, slots and engraving are made once
            key = _comparison_key(entry)
            if key not in strips:
                try:
                    strips[key] = _make_named(entry, slotted=self.interlock is not None)
                except (NotRealizable, NotConvergedError, InputError) as problem:
                    (failed if entry.section else refused).append(problem)
                    continue
            strip = replace(
                strips[key],
                label=entry.label,
                engrave=entry.spec.engrave,
                slots=entry.spec.slots,
                joints=entry.joints,
            )
            if not strip.slots:
                strip.cut_as(strips[key])
            placed.append(Placed(strip, entry.frame.origin, entry.frame.x_axis, entry.frame.y_axis))
            if done is not None:
                done(entry.label)
        if refused:
            raise merged_error(refused)
        plates: tuple[Ring | Rib, ...] = ()
        notes: tuple[str, ...] = ()
        if self.revolution is not None:
            surface = self.revolution.model(self.name)
            placed, plates, notes = [*surface.placed, *placed], surface.plates, surface.reports
        if failed and not placed:
            raise failed[0]
        without = tuple(
            note("{said} This section is left out.", said=ended(problem.refusal)) for problem in failed
        )
        model = Model(tuple(placed), self.name, reports=(*notes, *without, *self.reports), plates=plates)
        for kind, options in self.patterns:
            model = getattr(model, _PATTERNS[kind])(**options)
        if self.interlock is None:
            return model
        which = {entry.label for entry in self.entries if entry.spec.compensate}
        if not which:
            return model.interlock(**self.interlock)
        return interlock_compensated(model, which, **self.interlock)


# method of `Model` for each pattern
_PATTERNS = {"mirror": "mirrored", "rotate": "rotated", "repeat": "repeated"}


def read_design(
    path: str | Path,
    read_curves: CurveReader,
    read_surface: "SurfaceReader | None" = None,
    *,
    below: Sequence[str | Path] = (),
    changes: Mapping[str, Any] = MappingProxyType({}),
) -> Design:
    """Read a design file: compute its formulae, read its curve files, and check every value.

    Parameters
    ----------
    path : path-like
        TOML file. Names of files in it are relative to its folder.
    read_curves : callable
        Function that reads a curve file, such as `elastica_cad.read_curves`.
    read_surface : callable
        Function that reads a surface for sections. The default reads only meshes;
        `elastica_cad.files.read_surface` also reads STEP bodies.
    below : sequence of path-like
        Folders from which files may be read, in addition to the folder of the design and the working folder.
    changes : mapping
        New values for keys of the file.
    """
    path = require_file(path)
    below = several("folders to read from", below, str | PathLike, "path")
    with read_below(path.parent, Path(), *below):
        return design_of(merged(parse_design(path), changes), path, read_curves, read_surface)


def design_of(
    data: Mapping[str, Any],
    path: Path,
    read_curves: CurveReader,
    read_surface: "SurfaceReader | None" = None,
) -> Design:
    """Make a design from the parsed tables of the file `path`; see `read_design`."""
    slips = Slips()
    top = top_table(data, path, slips)
    # read each file once, because many strips may name the same file
    read_surface = None if read_surface is None else cache(read_surface)
    reader = Reader(own_sheets(top, path), path.parent, cache(read_curves), read_surface)
    revolution: RevolutionTable | None = None
    notes: tuple[str, ...] = ()
    strips = top.tables("strips")
    # tables that make parts, with their records, by their names in messages
    makers: dict[str, tuple[Record, Table]] = {
        f"strips[{i}]": (StripKeys, table) for i, table in enumerate(strips, start=1)
    }
    if top.has("revolution"):
        from elastica_cad.design import revolution_table

        makers["a surface of revolution"] = revolution_table.RevolutionTable, top.table("revolution")
    with slips.gathering():
        notes = share_keys(top, makers, reader)
        if top.has("revolution"):
            _, table = makers["a surface of revolution"]
            revolution = revolution_table.read_revolution(table, reader)
            # without holders, the tabs have the length 0 by default
            if revolution.ends is None and revolution.rings is None and not any(map(top.has, HOLDERS)):
                revolution = replace(revolution, ends=(Tab(0.0), Tab(0.0)))
    entries, reports = _read_strips(strips, top, reader, slips)
    patterns: list[tuple[str, dict[str, Any]]] = []
    for table in top.tables("patterns"):
        with slips.gathering():
            table.only(*_PATTERNS)
            if len(table.data) != 1:
                raise InputError(
                    "{place} needs one of the keys {patterns}. Add one of them.",
                    place=table.where,
                    patterns=", ".join(_PATTERNS),
                )
            (kind,) = table.data
            patterns.append((kind, reader.given(PATTERNS[kind], table.table(kind))))
    interlocked, kit = None, KitSpec()
    if top.has("interlock"):
        with slips.gathering():
            interlocked = reader.given(interlock, top.table("interlock"))
    with slips.gathering():
        kit = read_kit(top, reader)
    slips.refuse()
    if top.has("pair"):
        raise InputError(
            "{place} describes a part with two states. Run `elastica pair {file} -o out` instead.",
            place=top.where,
            file=quote_words([str(path)]),
        )
    if not entries and revolution is None:
        raise InputError("{place} has no strips. Write at least one table [[strips]].", place=top.where)
    return Design(
        name=name_of_files(top, path),
        entries=tuple(entries),
        patterns=tuple(patterns),
        interlock=interlocked,
        kit=kit,
        reports=(*notes, *(() if revolution is None else revolution.reports), *reports),
        revolution=revolution,
    )


def parse_design(path: Path) -> dict[str, Any]:
    """Return the tables of a TOML file, parsed but not checked. Former names of keys are replaced."""
    try:
        text = path.read_bytes().decode("utf-8-sig")
        tables: dict[str, Any] = with_present_keys(parse_toml(text))
        return tables
    except UnicodeDecodeError as error:
        raise InputError(
            "{path} is not a TOML file because it is not UTF-8. Save it as UTF-8 text.", path=path
        ) from error
    except RecursionError as error:
        raise InputError("{path} nests lists or tables too deeply. Reduce the depth.", path=path) from error
    except tomllib.TOMLDecodeError as error:
        raise InputError(
            "{path} is not a valid TOML file: {error}; {toml_slip}, or begin with a file of `elastica new`",
            path=path,
            error=error,
            toml_slip=toml_slip(text, error),
        ) from error


def top_table(data: Mapping[str, Any], path: Path, slips: Slips) -> Table:
    """Return the top level of a design, after checking its keys and the version of its schema."""
    top = Table(data, str(path), {})
    with slips.gathering():
        top.only(*names_of(DesignKeys))
    if data.get("schema", DESIGN_SCHEMA) != DESIGN_SCHEMA:
        slips.add(note(
            "{file}: schema is {schema}, but this version reads only schema {known}. Write schema = {known}",
            file=path, schema=quoted(data.get("schema")), known=DESIGN_SCHEMA,
        ))  # fmt: skip
    top.scope = top.within(data.get("let", {}))
    return top


def name_of_files(top: Table, path: Path) -> str:
    """Return the name of a model and of its files: the key `name`, or the name of the design file."""
    name = top.text("name", path.stem)
    # the limits of the key do not apply to the name of the file
    if top.has("name"):
        (entry,) = (entry for entry in fields_of(DesignKeys) if entry.name == "name")
        require_bounds(entry, name, top.place("name"))
    return name


class _Sheets(dict[str, Sheet]):
    """Sheets of a design by name, and sheet files in the folder of the design by file name.

    A sheet file counts as contained, and is read when its name is looked up. `folder` is the folder of the design.
    """

    folder = Path()

    def __contains__(self, name: object) -> bool:
        return super().__contains__(name) or ".toml" in str(name)

    def __missing__(self, name: str) -> Sheet:
        # a name may also be FILE.toml:SHEET
        if ".toml" in name:
            require_below(file_in(self.folder, f"{name.partition('.toml')[0]}.toml"))
        return Sheet.named(name, folder=self.folder)


def own_sheets(top: Table, path: Path) -> dict[str, Sheet]:
    """Return the sheets that a design defines itself, by name. The dict also reads sheet files; see `_Sheets`."""
    sheets = _Sheets()
    sheets.folder = path.parent
    if top.has("sheets_file"):
        with top.naming("sheets_file"):
            sheets.update(load_sheets(require_file(file_in(path.parent, top.text("sheets_file")))))
    if top.has("sheets"):
        sheets.update(sheets_from_table(top.raw("sheets"), where=str(path)))
    return sheets


def _read_strips(
    tables: Sequence[Table], top: Table, reader: Reader, slips: Slips
) -> tuple[list[StripEntry], tuple[str, ...]]:
    """Return the strips of all tables, and reports.

    The errors of tables are gathered in `slips`. A section that cannot become a strip is left out, unless no
    strip remains.
    """
    entries: list[StripEntry] = []
    failed: list[InputError] = []
    reports: list[str] = []
    for table in tables:
        sections: tuple[SectionCurve | None, ...] = ()
        with slips.gathering():
            require_keys(StripKeys, table)
            if table.has("sections"):
                from elastica_cad.design.sections_table import read_sections

                sections, section_reports = read_sections(table.table("sections"), reader)
                reports += section_reports
            else:
                sections = (None,) * table.count("count")
        first = len(entries)
        for i, section in enumerate(sections, start=1):
            where = f"{table.where}, i = {i}" if len(sections) > 1 else table.where
            strip_table = Table(table.data, where, {**top.scope, "i": float(i)}, table.defaults)
            try:
                strip_table.scope = strip_table.within(table.data.get("let", {}))
                label = table.text("label", f"S{len(entries) + 1}").replace("{i}", str(i))
                strip_table.where = f"{where} ({label if label.isprintable() else quoted(label)})"
                entry = read_strip(strip_table, label, reader, section)
                if not table.has("split"):
                    entries.append(entry)
                    continue
                divided = split_curve(strip_table, entry.spec)
                entries += split_entry(entry, divided.pieces)
                reports.append(note("{label}: {divided}", label=label, divided=str(divided)))
            except InputError as problem:
                if section is None:
                    slips.add(str(problem), strip_table.where)
                else:
                    failed.append(problem)
        with slips.gathering():
            # copies of a part from one table may have the same label
            used_labels = {entry.label for entry in entries[:first]}
            known = dict[str, StripEntry]()
            for new in entries[first:]:
                twin = known.setdefault(new.label, new)
                if new.label in used_labels or (
                    twin is not new and _comparison_key(twin) != _comparison_key(new)
                ):
                    raise InputError(
                        "{place}: two strips have the label {twice!r}. Give each strip a different label, with "
                        "{{i}} for its number.",
                        place=top.where,
                        twice=new.label,
                    )
            entries[first:] = _with_copies_apart(entries[first:])
    if failed and not entries:
        raise failed[0]
    return entries, (
        *reports,
        *(note("{problem} This section is left out.", problem=ended(problem.refusal)) for problem in failed),
    )


def _with_copies_apart(entries: Sequence[StripEntry]) -> list[StripEntry]:
    """Place copies of a part, which would otherwise be in the same position, 20 mm apart."""
    alike = len({entry.label for entry in entries}) < len(entries)
    if not alike or np.ptp([entry.frame.origin for entry in entries], axis=0).any():
        return list(entries)
    widths = [entry.spec.max_width or getattr(entry.spec.style, "width", None) for entry in entries]
    apart = 20.0 + max((w for w in widths if isinstance(w, int | float)), default=0.0)
    return [
        replace(entry, spec=entry.spec.changed(frame=entry.frame.shifted(z=k * apart)))
        for k, entry in enumerate(entries)
    ]


def _comparison_key(entry: StripEntry) -> Any:
    """Return a value that is equal for strips with equal requests and, apart from rounding, equal curves."""
    spec, curve, gravity = entry.spec, entry.curve, entry.spec.gravity_in_plane
    numbers = [curve.knots - curve.knots[0], curve.control_points.ravel()]
    numbers += [] if curve.weights is None else [curve.weights]
    numbers += [] if gravity is None else [[gravity.length, *gravity.direction]]
    # a mirrored copy has the same curve in a mirrored frame, apart from rounding; -0.0 becomes 0.0
    digits = np.round(np.concatenate(numbers) / curve.length, 11) + 0.0
    placed = ("curve", "frame", "gravity", "slots", "label", "engrave")
    values = [getattr(spec, option.name) for option in fields(spec) if option.name not in placed]
    # slots change the widths only if the widths compensate them
    return digits.tobytes(), value_key([*values, spec.compensate and spec.slots])


def merged_error(problems: Sequence[ElasticaError]) -> ElasticaError:
    """Return one error with the texts of all."""
    first, slips = problems[0], Slips()
    if len(problems) == 1:
        return first
    for problem in problems:
        slips.add(str(problem))
    # merge the errors without their suggestions, because each suggestion applies to one error only
    first.refusal = Refusal(first.refusal.kind, slips.text)
    return first


def _make_named(entry: StripEntry, *, slotted: bool) -> Strip:
    """Make a strip, without slots unless its widths compensate them. With `slotted`, they are compensated later."""
    spec = entry.spec
    if slotted and spec.compensate:
        spec = spec.changed(compensate=False)
    if not spec.compensate:
        spec = spec.changed(slots=())
    try:
        return spec.make()
    except (NotRealizable, InputError, NotConvergedError) as problem:
        problem.at(strip=entry.called)
        raise
