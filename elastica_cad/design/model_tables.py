"""The top of a design file, and its tables for all parts of a model that are not strips."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Annotated, Any, ClassVar, Literal, TypeAlias

from elastica_cad.declared import Field, Option, Record, require_bounds
from elastica_cad.design.kit_spec import Cutting, HolderKind, HolderSpec, KitSpec
from elastica_cad.design.records import Reader, fields_of, idle_keys, tables_in, written
from elastica_cad.design.strip_table import SHARED, CurveLength, SharedKeys, StripKeys
from elastica_cad.design.tables import Table
from elastica_cad.errors import InputError, Listed, Refusal, note
from elastica_cad.geometry.frame import Frame
from elastica_cad.mechanics.sheets import Sheet, sheet_keys
from elastica_cad.model.fixtures import EndFixture
from elastica_cad.model.frames import slotted_frame
from elastica_cad.model.interlocking import interlock as slots_at_crossings
from elastica_cad.model.model import mirror, repeat, rotate
from elastica_cad.model.nesting import Nesting
from elastica_cad.model.plates import PlateOptions, RingOptions
from elastica_cad.model.spacers import Spacers
from elastica_cad.strip.outline import StripEnd
from elastica_cad.translations import Language

Names: TypeAlias = str | tuple[str, ...]


@dataclass(frozen=True)
class OwnSheet:
    """Table of a design that defines a sheet: fields of `Sheet`, with the unit in each key."""

    FIELDS: ClassVar[Callable[[], Mapping[str, Field]]] = staticmethod(sheet_keys)


@dataclass(frozen=True)
class _Holder:
    strips: Annotated[
        Names, Option('Labels of the strips to hold; "A*" for all labels that begin with A.')
    ] = "*"


@dataclass(frozen=True, kw_only=True)
class Stand(_Holder):
    """The simplest holder that holds all tabs: a plate, rings, a frame or blocks."""

    sheet: Annotated[Sheet, Option("Sheet of the plates.")]
    thickness: Annotated[
        float | None, Option("Thickness of the sheet, if it differs from the listed one.", "mm", least=0)
    ] = None
    sheet_size: Annotated[
        tuple[float, float] | None, Option("Sheets that plates are cut from.", "mm", least=0)
    ] = None
    margin: Annotated[
        float | None, Option("Least distance between parts on these sheets.", "mm", least=0)
    ] = None


@dataclass(frozen=True, kw_only=True)
class NamedStand(Stand):
    """The simplest holder that holds all tabs, with a name."""

    name: Annotated[str | None, Option("Name of its plates.")] = None


@dataclass(frozen=True, kw_only=True)
class _Plates(Stand):
    feet: Annotated[
        float | None,
        Option(
            "Size of small plates that are glued beside inclined tabs.",
            "mm",
            least=0,
            replaces=("spacers",),
        ),
    ] = None


@dataclass(frozen=True, kw_only=True)
class Base(_Plates):
    """A plate with a slot for every tab."""

    BESIDE: ClassVar[Record] = PlateOptions
    height: Annotated[float, Option("Height of the upper face.", "mm")] = 0.0
    gap: Annotated[
        float | None, Option("Distance between two plates that hold inclined tabs.", "mm", least=0)
    ] = None
    spacers: Spacers = None


@dataclass(frozen=True, kw_only=True)
class Rings(_Plates):
    """A plate for each end."""

    BESIDE: ClassVar[Record] = RingOptions
    WITHOUT: ClassVar[tuple[str, ...]] = ("slot_width",)
    gap: Annotated[
        float | None, Option("Distance between two plates that hold inclined tabs.", "mm", above=0)
    ] = None
    spacers: Spacers = None


@dataclass(frozen=True, kw_only=True)
class FrameOfPlates(_Plates):
    """Two rails with ribs between them."""

    BESIDE: ClassVar[Record] = slotted_frame


@dataclass(frozen=True, kw_only=True)
class Fixtures(_Holder):
    """Printed blocks that hold the ends of strips."""

    BESIDE: ClassVar[Record] = EndFixture
    floor: Annotated[
        float | None, Option("Height of the lower face of the blocks.", "mm", least=-10_000, most=10_000)
    ] = None
    ends: Annotated[StripEnd | None, Option("Tabs to hold; by default all.")] = None


HOLDERS: dict[HolderKind, Record] = {
    "base": Base, "rings": Rings, "frame": FrameOfPlates, "fixtures": Fixtures, "stand": NamedStand,
}  # fmt: skip
"""Record class of each kind of holder, in the order in which a kit makes them."""


@dataclass(frozen=True)
class MirrorPattern:
    """Pattern of mirror images."""

    mirror: Annotated[Any, Option("Mirror image of the strips.", written=mirror)]


@dataclass(frozen=True)
class RotatePattern:
    """Pattern of copies about an axis."""

    rotate: Annotated[Any, Option("Copies of the strips around an axis.", written=rotate)]


@dataclass(frozen=True)
class RepeatPattern:
    """Pattern of copies in a row."""

    repeat: Annotated[Any, Option("Copies of the strips in a row.", written=repeat)]


PATTERNS: dict[str, Record] = {"mirror": mirror, "rotate": rotate, "repeat": repeat}
"""Function of each pattern. The options of the function are the keys of the pattern's table."""


@dataclass(frozen=True)
class Extras:
    """Additional parts to cut."""

    coupon: Annotated[bool, Option("Add a coupon of every sheet.")] = False
    reference_bar: Annotated[
        float | None,
        Option("Length of a bar for checking the scale of the machine; 0 for none.", "mm", least=0),
    ] = None
    pages: Annotated[
        Literal["A4", "A3", "letter"] | None,
        Option("Paper of a PDF with every part at full size and a bar for checking the printer."),
    ] = None


@dataclass(frozen=True, kw_only=True)
class DesignKeys(SharedKeys):
    """All keys at the top of a design file."""

    length: CurveLength = None
    schema: Annotated[Literal[1], Option("Version of the keys in this file.")] = 1
    name: Annotated[str | None, Option("Name of the model, and of its files.", most=60)] = None
    let: Annotated[
        dict[str, float] | None, Option("Names and values for formulae; each value may use earlier names.")
    ] = None
    sheets: Annotated[dict[str, OwnSheet] | None, Option("Your sheets, [sheets.NAME].")] = None
    sheets_file: Annotated[str | None, Option("File with your sheets.")] = None
    strips: Annotated[tuple[StripKeys, ...], Option("Strips; each table describes one or several.")] = ()
    revolution: Annotated[
        Any,
        Option(
            "Surface of revolution about z, tiled by equal strips.",
            written="elastica_cad.design.revolution_table:RevolutionTable",
        ),
    ] = None
    patterns: Annotated[
        tuple[MirrorPattern | RotatePattern | RepeatPattern, ...], Option("Copies of all strips, in order.")
    ] = ()
    pair: Annotated[
        Any,
        Option(
            "Part with two rest shapes, for `elastica pair`; without other parts in its file.",
            written="elastica_cad.pairs.flexure_spec:FlexureSpec",
        ),
    ] = None
    interlock: Annotated[Any, Option("Slots wherever two strips cross.", written=slots_at_crossings)] = None
    base: Annotated[Any, Option("Plate with a slot for every tab.", written=Base | tuple[Base, ...])] = None
    rings: Annotated[Any, Option("A plate for each end.", written=Rings | tuple[Rings, ...])] = None
    frame: Annotated[
        Any, Option("Two rails with ribs between.", written=FrameOfPlates | tuple[FrameOfPlates, ...])
    ] = None
    fixtures: Annotated[Any, Option("Printed blocks.", written=Fixtures | tuple[Fixtures, ...])] = None
    stand: Annotated[
        Any, Option("Simplest holder of all tabs.", written=NamedStand | tuple[NamedStand, ...])
    ] = None
    nest: Annotated[Nesting | None, Option("Sheets for nesting the parts.")] = None
    cut: Annotated[Cutting | None, Option("Settings of cutting files.")] = None
    extras: Annotated[Extras | None, Option("Additional parts to cut.")] = None
    language: Annotated[Language | None, Option("Language of the assembly sheet.")] = None


MAKERS = ("strips", "revolution", "pair")
"""Keys of a design whose tables make parts, and use the shared keys at its top."""


def _uses(record: Record, entry: Field) -> bool:
    """Return True if a table of parts has a shared key, which may have fewer kinds of values there."""
    kinds = {*written(entry.kind).alternatives}
    return any(
        own.name == entry.name and not kinds.isdisjoint(written(own.kind).alternatives)
        for own in fields_of(record)
    )


def makers_using(key: str) -> list[str]:
    """Return the tables of a design that use a key at its top.

    Examples
    --------
    >>> makers_using("smooth"), makers_using("max_width"), makers_using("nest")
    (['strips', 'revolution', 'pair'], ['strips'], [])
    """
    known = {entry.name: entry for entry in fields_of(DesignKeys)}
    records = {name: tables_in(written(known[name].kind))[-1] for name in MAKERS}
    return [name for name, record in records.items() if key in SHARED and _uses(record, known[key])]


def share_keys(
    top: Table, makers: Mapping[str, tuple[Record, Table]], reader: Reader, others: Sequence[str] = ()
) -> tuple[Refusal, ...]:
    """Make the keys at the top of a design the defaults of the tables that use them.

    Return notes on the tables that do not use a key. Raise InputError for keys that no table uses, for the keys
    `others`, and for wrong values.

    Parameters
    ----------
    makers : mapping
        Records and tables of the parts that the design makes, by their names in messages.
    """
    # formulae of shared keys are checked with the number i = 1 of the first strip
    # `ignored` has keys that only some tables use, by the names of the other tables
    scope, unused, ignored = {**top.scope, "i": 1.0}, list(others), dict[tuple[str, ...], list[str]]()
    for _, table in makers.values():
        table.defaults = top  # a key at the top may replace others
        scope |= Table(table.data, table.where, scope).within(table.data.get("let", {}))
    idle = {name: idle_keys(record, table) for name, (record, table) in makers.items()}
    # names of the tables that use each key
    users = dict[str, list[str]]()
    # strain limits need the thickness of a sheet, and here any sheet serves
    checked, reader = Table(top.data, top.where, scope), replace(reader, sheet=Sheet.named("card-200gsm"))
    for entry in fields_of(DesignKeys) if makers else ():
        key = entry.name
        if key not in SHARED or not top.has(key):
            continue
        known = [name for name, (record, _) in makers.items() if _uses(record, entry)]
        # a key without effect on all of them is passed on, and refused with the reason
        users[key] = [name for name in known if key not in idle[name]] or known
        # a key that every table overrides is never read, so its value is checked here
        if users[key] and all(key in makers[name][1].data for name in users[key]):
            require_bounds(entry, reader.value(entry.kind, checked, key), top.place(key))
        rest = tuple(name for name in makers if name not in users[key])
        if rest:
            (ignored.setdefault(rest, []) if users[key] else unused).append(key)
    if unused:
        raise InputError(
            "{place} has no effect on {parts}. Leave out {keys}.",
            place=top.place(unused[0]), parts=Listed(makers), keys=Listed(unused),
        )  # fmt: skip
    for name, (_, table) in makers.items():
        shared = {key: top.raw(key) for key, names in users.items() if name in names}
        table.defaults = Table(shared, top.where, top.scope)
    text = "These keys at the top of the design have no effect on {parts}: {keys}."
    return tuple(note(text, parts=Listed(rest), keys=Listed(keys)) for rest, keys in ignored.items())


def read_kit(top: Table, reader: Reader) -> KitSpec:
    """Read the request for holders, nesting, cutting files and coupons from a design."""
    keys = ("nest", "cut", "extras", "shop", "ignore_limits", "language")
    given = {
        entry.name: reader.value(entry.kind, top, entry.name)
        for entry in fields_of(DesignKeys)
        if entry.name in keys and top.has(entry.name)
    }
    nesting = given.pop("nest", Nesting())
    return KitSpec(
        nesting=nesting,
        cutting=given.pop("cut", Cutting()),
        holders=tuple(_read_holders(top, reader, nesting)),
        **vars(given.pop("extras", Extras())),
        **given,
    )


def _read_holders(top: Table, reader: Reader, nesting: Nesting) -> Iterator[HolderSpec]:
    for kind in HOLDERS:
        listed = isinstance(top.raw(kind), list)
        tables = top.tables(kind) if listed else [top.table(kind)] if top.has(kind) else []
        for number, table in enumerate(tables, start=1):
            yield _read_holder(kind, table, number if len(tables) > 1 else 0, reader, nesting)


def _read_holder(kind: HolderKind, table: Table, number: int, reader: Reader, nesting: Nesting) -> HolderSpec:
    """Return the request for holders of a kind, with keys of its table converted to options.

    `number` distinguishes several tables of the kind.
    """
    options = reader.given(HOLDERS[kind], table)
    # the sheet already has this thickness
    options.pop("thickness", None)
    strips, sheet = options.pop("strips", "*"), options.pop("sheet", None)
    laid = {key: options.pop(key) for key in ("sheet_size", "margin") if key in options}
    if number and kind in ("base", "rings"):
        options.setdefault("name", f"{kind.removesuffix('s')}-{number}")
    if "ends" in options:
        options["ends"] = (options["ends"],)
    if kind == "base":
        options["frame"] = Frame((0.0, 0.0, options.pop("height", 0.0)))
    if "floor" in options:
        options["floor"] = Frame((0.0, 0.0, options["floor"]))
    return HolderSpec(
        kind,
        sheet,
        options,
        replace(nesting, **laid),
        (strips,) if isinstance(strips, str) else strips,
        table.where,
    )
