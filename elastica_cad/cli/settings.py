"""Keys of requests by their path, such as `limits.ratio`: what `--set` gives and `elastica help` tells."""

import tomllib
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Annotated, Any, ClassVar, Literal, TypeVar

import click

from elastica_cad._toml import parse_toml
from elastica_cad.declared import REQUIRED, Asked, Kind, Record
from elastica_cad.design.design_schema import told
from elastica_cad.design.kit_spec import DEFAULT_CUTTING, Cutting
from elastica_cad.design.model_tables import DesignKeys
from elastica_cad.design.records import paths_of, put, require_path_of, title, written
from elastica_cad.design.strip_table import StripKeys
from elastica_cad.errors import InputError, quoted
from elastica_cad.pairs.flexure_spec import FlexureSpec

F = TypeVar("F", bound=Callable[..., Any])

GROUPS = ("curve", "sheet", "widths", "ends", "limits", "weight", "files")
"""In which options of a strip are listed."""


@dataclass(frozen=True)
class CurveKeys:
    """Which curve of the file is taken, and whether it is split into pieces."""

    layer: Annotated[str | None, Asked("Only curves on this layer of the drawing.", group="curve")] = None
    split_corners: Annotated[
        bool, Asked("Cut curves at their corners; every piece is a strip of its own.", group="curve")
    ] = False


@dataclass(frozen=True)
class FileKeys:
    """Which files are written beside the cut pattern and the report."""

    paper: Annotated[
        Literal["A4", "A3", "A2", "A1", "A0", "letter", "tabloid"] | None,
        Asked(
            "Write NAME.pdf too: full size on this paper, tiles with marks to join them by.", group="files"
        ),
    ] = None
    glb: Annotated[
        bool,
        Asked("Write NAME.glb too: the bent strip for browsers and phones (needs build123d).", group="files"),
    ] = False
    strict: Annotated[
        bool, Asked("Exit with 1 when the strain is beyond what the sheet bears.", group="files")
    ] = False


@dataclass(frozen=True)
class CommandKeys(StripKeys):
    """All keys of `elastica strip`: those of a strip in a design file, and which files are written."""

    WITHOUT: ClassVar[tuple[str, ...]] = ("count", "let", "sections")
    curve: Annotated[CurveKeys, Asked("Which curve of the file.", group="curve")] = CurveKeys()
    cut: Annotated[Cutting, Asked("How cutting files are written.", group="files", common=True)] = (
        DEFAULT_CUTTING
    )
    files: Annotated[FileKeys, Asked("Which files are written.", group="files")] = FileKeys()


@dataclass(frozen=True)
class BentKeys(StripKeys):
    """What `elastica bend` is asked for of the strip that it bends."""

    WITHOUT: ClassVar[tuple[str, ...]] = (
        "count", "let", "sections", "curve", "origin", "x_axis", "y_axis", "label", "engrave",
    )  # fmt: skip


@dataclass(frozen=True)
class PairKeys:
    """What `elastica pair` is asked for of its part."""

    BESIDE: ClassVar[Record] = FlexureSpec
    WITHOUT: ClassVar[tuple[str, ...]] = ("first", "second", "sheet")
    cut: Annotated[Cutting, Asked("How cutting files are written.", group="files")] = DEFAULT_CUTTING


KEYS_OF: Mapping[str, Record] = {
    "strip": CommandKeys, "bend": BentKeys, "model": DesignKeys, "pair": PairKeys,
}  # fmt: skip
"""Keys that `--set` of each command knows."""


def parsed_settings(settings: Iterable[str], record: Record) -> dict[str, Any]:
    """Return the table that `KEY=VALUE` texts make: values are TOML, a bare word is a text.

    Raises
    ------
    InputError
        A text without "=", or an unknown key, with the nearest that is known.

    Examples
    --------
    >>> parsed_settings(["limits.ratio=3", "law.kind=rod"], CommandKeys)
    {'limits': {'ratio': 3}, 'law': {'kind': 'rod'}}
    """
    table: dict[str, Any] = {}
    for text in settings:
        path, between, value = (part.strip() for part in text.partition("="))
        if not between:
            raise InputError(
                "--set {text} has no value: write KEY=VALUE, such as limits.ratio=3", text=quoted(text)
            )
        require_path_of(path, record)
        put(table, path, _value(value))
    return table


def _value(text: str) -> Any:
    """A value as TOML has it; what is no TOML is a text, without quotes."""
    try:
        return parse_toml(f"value = {text}")["value"]
    except (tomllib.TOMLDecodeError, RecursionError):
        if text[:1] in "[{\"'" or "\n" in text:
            raise InputError(
                "{text} cannot be read: write the value as in a design file, such as [1, 2] or "
                "[{{ at = 40, width = 1.2 }}]",
                text=quoted(text),
            ) from None
        return text


def twice(table: Mapping[str, Any], others: Mapping[str, Any], way: str = "") -> Iterator[str]:
    """Yield paths to which two tables give different values; `true` agrees with any table or list."""
    for key in table.keys() & others.keys():
        mine, theirs = table[key], others[key]
        if isinstance(mine, dict) and isinstance(theirs, dict):
            yield from twice(mine, theirs, f"{way}{key}.")
        elif mine != theirs and not (mine is True and key == "gravity"):
            yield f"{way}{key}"


def completed(_: click.Context, __: click.Parameter, typed: str) -> list[Any]:
    """Keys of a strip and of a design file that begin as typed, for shells."""
    known = {**paths_of(DesignKeys), **paths_of(CommandKeys)}
    return [one for one in known if one.startswith(typed)]


def set_option(record: Record) -> Callable[[F], F]:
    """Return a decorator that adds `--set KEY=VALUE` for the keys of a record, which shells complete."""

    def complete(_: click.Context, __: click.Parameter, typed: str) -> list[Any]:
        from click.shell_completion import CompletionItem

        path, given, _value = typed.partition("=")
        known = paths_of(record)
        if given and path in known:
            words = _values(known[path].kind)
            return [CompletionItem(f"{path}={one}") for one in words if one.startswith(_value)]
        return [CompletionItem(f"{one}=", help=known[one].help) for one in known if one.startswith(typed)]

    return click.option(
        "--set", "settings", metavar="KEY=VALUE", multiple=True, shell_complete=complete,
        help="Any other key, as in a design file: `elastica help` lists them. Repeatable.",
    )  # fmt: skip


def _values(kind: Kind) -> list[str]:
    """Words that a value may be."""
    found = list(kind.choices)
    for one in written(kind).alternatives:
        found += ["true", "false"] if one.name == "flag" else [] if one == kind else _values(one)
    return found


def _in_words(kind: Kind) -> str:
    """What a value may be, for people.

    Examples
    --------
    >>> _in_words(paths_of(CommandKeys)["limits.strain"].kind)
    'true or false, or a number'
    """
    kind = written(kind)
    if kind.name == "either":
        return ", or ".join(dict.fromkeys(_in_words(one) for one in kind.of))
    if kind.name == "choice":
        return " or ".join(str(one) for one in kind.choices)
    if kind.name == "table":
        assert kind.record is not None
        return f"table {title(kind.record)}"
    if kind.name == "list":
        inner, size = _in_words(kind.of[0]), "" if kind.size is None else f"{kind.size} "
        plural = {"a number": "numbers", "true or false": "times true or false"}.get(inner, f"times {inner}")
        return f"[{size}{plural}]" if inner in ("a number", "true or false") else f"list of {inner}"
    plain = {"number": "a number", "count": "a whole number", "flag": "true or false", "text": "a text"}
    return plain.get(kind.name, "names and their values")


def explained(path: str, option: str) -> str:
    """Return the text of `elastica help KEY`.

    Raises
    ------
    InputError
        There is no such key.
    """
    record: Record = CommandKeys if path in paths_of(CommandKeys) else DesignKeys
    field = require_path_of(path.removeprefix("strips."), record)
    asked = field.asked
    lines = [told(field.help, asked.unit), f"Value: {_in_words(field.kind)}."]
    if asked.bounds:
        lines.append(f"Bounds: {asked.bounds}.")
    if isinstance(field.default, bool | int | float | str) and field.default != "":
        lines.append(
            f"Default: {field.default}.".lower()
            if isinstance(field.default, bool)
            else f"Default: {field.default}."
        )
    elif field.default is REQUIRED:
        lines.append("It must be given.")
    inner = [one.rpartition(".")[2] for one in paths_of(record) if one.rpartition(".")[0] == path]
    if inner:
        lines.append(f"Keys below it: {', '.join(inner)}.")
    typed = f"{option}=VALUE" if option.startswith("--set") else option
    here = f"elastica strip: {typed}" if record is CommandKeys else "elastica model: a design file"
    return "\n".join([path, *(f"  {line}" for line in [*lines, here])])


DEEPEST = 1
"""Dots in the paths that `elastica help` lists; it explains those below by their tables."""


def listed() -> str:
    """Return the text of `elastica help`: all keys in their groups, each with its help."""
    known = paths_of(CommandKeys)
    lines = []
    for group in GROUPS:
        lines += ["", f"{group}:"]
        lines += [
            f"  {path:<24} {told(field.help, field.asked.unit)}"
            for path, field in known.items()
            if known[path.partition(".")[0]].asked.group == group and path.count(".") <= DEEPEST
        ]
    lines += ["", "whole models, in design files:"]
    lines += [
        f"  {path:<24} {told(field.help, field.asked.unit)}"
        for path, field in paths_of(DesignKeys).items()
        if path.partition(".")[0] not in {*known, "strips"} and path.count(".") <= DEEPEST
    ]
    return "\n".join(lines[1:])
