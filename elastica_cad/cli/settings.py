"""Keys of design files by their path, such as `limits.ratio`, for `--set` and `elastica help`."""

import tomllib
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Annotated, Any, ClassVar, Literal

import click

from elastica_cad._toml import parse_toml
from elastica_cad._units import read_length
from elastica_cad.cli.options import F
from elastica_cad.declared import Kind, Option, Record
from elastica_cad.design.kit_spec import DEFAULT_CUTTING, Cutting
from elastica_cad.design.records import current_path, help_with_unit, paths_of, put, require_path_of, written
from elastica_cad.design.strip_table import StripKeys
from elastica_cad.errors import InputError, quoted

GROUPS = ("curve", "sheet", "widths", "ends", "limits", "weight", "files")
"""Groups of the options of a strip, in the order of help."""


@dataclass(frozen=True)
class CurveKeys:
    """Selection of the curve in the file, and splitting at corners."""

    layer: Annotated[str | None, Option("Only curves on this layer of the drawing.", group="curve")] = None
    split_corners: Annotated[
        bool, Option("Split curves at their corners; every piece becomes a strip.", group="curve")
    ] = False


@dataclass(frozen=True)
class FileKeys:
    """Selection of files besides the cut pattern and the report."""

    paper: Annotated[
        Literal["A4", "A3", "A2", "A1", "A0", "letter", "tabloid"] | None,
        Option(
            "Also write NAME.pdf: full size on this paper, in pages with marks for joining.", group="files"
        ),
    ] = None
    glb: Annotated[
        bool,
        Option(
            "Also write NAME.glb: the bent strip for browsers and phones (needs build123d).", group="files"
        ),
    ] = False
    strict: Annotated[
        bool, Option("Exit with code 1 if the strain exceeds the limit of the sheet.", group="files")
    ] = False


@dataclass(frozen=True)
class CommandKeys(StripKeys):
    """All keys of `elastica strip`: the keys of a strip in a design file, and the files to write."""

    WITHOUT: ClassVar[tuple[str, ...]] = ("count", "let", "sections")
    curve: Annotated[CurveKeys, Option("Curve of the file.", group="curve")] = CurveKeys()
    cut: Annotated[Cutting, Option("Settings of cutting files.", group="files", common=True)] = (
        DEFAULT_CUTTING
    )
    files: Annotated[FileKeys, Option("Files to write.", group="files")] = FileKeys()


@dataclass(frozen=True)
class BentKeys(StripKeys):
    """Options of `elastica bend` that describe the strip."""

    WITHOUT: ClassVar[tuple[str, ...]] = (
        "count", "let", "sections", "split", "curve", "origin", "x_axis", "y_axis", "label", "engrave", "creep",
        "tolerance",
    )  # fmt: skip


def parsed_settings(settings: Iterable[str], record: Record) -> dict[str, Any]:
    """Return the table that `KEY=VALUE` texts define. Values are TOML, or a word without quotes.

    Examples
    --------
    >>> parsed_settings(["limits.ratio=3", "section.kind=rod"], CommandKeys)
    {'limits': {'ratio': 3}, 'section': {'kind': 'rod'}}
    """
    table: dict[str, Any] = {}
    for text in settings:
        path, between, value = (part.strip() for part in text.partition("="))
        if not between:
            raise InputError(
                "--set {text} has no value. Write KEY=VALUE, such as limits.ratio=3.", text=quoted(text)
            )
        path = current_path(path)
        if path not in paths_of(record):
            from elastica_cad.design.model_tables import DesignKeys

            if not paths_of(DesignKeys).keys().isdisjoint((path, f"strips.{path}")):
                raise InputError("The key {path} has no effect here. Leave it out.", path=quoted(path))
        require_path_of(path, record)
        put(table, path, _in_mm(_toml_or_text(value), path, record))
    return table


def _in_mm(value: Any, path: str, record: Record) -> Any:
    """Return the value of a key with lengths such as "0.2in" in mm."""
    if isinstance(value, dict):
        return {key: _in_mm(item, f"{path}.{key}", record) for key, item in value.items()}
    if isinstance(value, list):
        return [_in_mm(item, path, record) for item in value]
    length, field = read_length(value) if isinstance(value, str) else None, paths_of(record).get(path)
    if length is None or field is None or not _has_numbers(field.kind):
        return value
    if field.option.unit != "mm":
        raise InputError(
            "{path} is {given}, but {path} is not a length. Write a number: {help}",
            path=path, given=value, help=help_with_unit(field.help, field.option.unit),
        )  # fmt: skip
    return length


def _has_numbers(kind: Kind) -> bool:
    return kind.name in ("number", "count") or any(map(_has_numbers, written(kind).of))


def _toml_or_text(text: str) -> Any:
    try:
        return parse_toml(f"value = {text}")["value"]
    except (tomllib.TOMLDecodeError, RecursionError):
        # a text that begins as a list, table or string is a mistake and not a word
        if text[:1] in "[{\"'" or "\n" in text:
            raise InputError(
                "{text} cannot be read. Write the value as in a design file, such as [1, 2] or [{{ at = 40, "
                "width = 1.2 }}].",
                text=quoted(text),
            ) from None
        return text


def twice(table: Mapping[str, Any], other: Mapping[str, Any], prefix: str = "") -> Iterator[str]:
    """Yield the paths of keys with different values in two tables.

    The value `true` of the key `gravity` equals any table or list.
    """
    for key in table.keys() & other.keys():
        mine, theirs = table[key], other[key]
        if isinstance(mine, dict) and isinstance(theirs, dict):
            yield from twice(mine, theirs, f"{prefix}{key}.")
        elif mine != theirs and not (mine is True and key == "gravity"):
            yield f"{prefix}{key}"


class Setting(click.ParamType):  # type: ignore[type-arg]  # no generic class before click 8.2
    """Parameter type of `KEY=VALUE` with the keys of a record. Shells can complete the keys."""

    name = "setting"

    def __init__(self, record: Record) -> None:
        self.record = record

    def shell_complete(self, _: click.Context, __: click.Parameter, incomplete: str) -> list[Any]:
        """Return the keys that begin with the typed text or, after a complete key, its possible values."""
        from click.shell_completion import CompletionItem

        path, equals_sign, typed = incomplete.partition("=")
        keys = paths_of(self.record)
        if equals_sign and path in keys:
            words = _possible_words(keys[path].kind)
            return [CompletionItem(f"{path}={word}") for word in words if word.startswith(typed)]
        return [CompletionItem(f"{key}=", help=keys[key].help) for key in keys if key.startswith(incomplete)]


def set_option(record: Record) -> Callable[[F], F]:
    """Return a decorator that adds `--set KEY=VALUE` with the keys of a record."""
    return click.option(
        "--set", "settings", metavar="KEY=VALUE", multiple=True, type=Setting(record),
        help="Any other key, as in a design file; `elastica help` lists all. Repeatable.",
    )  # fmt: skip


def _possible_words(kind: Kind) -> list[str]:
    words = list(kind.choices)
    for part in written(kind).alternatives:
        words += ["true", "false"] if part.name == "flag" else [] if part == kind else _possible_words(part)
    return words
