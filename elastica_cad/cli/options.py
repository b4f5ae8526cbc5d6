"""Options that several commands share, and the parameter type of lengths."""

from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import suppress
from pathlib import Path
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, TypeAlias, TypeVar

import click
from click.core import ParameterSource

from elastica_cad._units import MM_PER_INCH, read_length, read_number
from elastica_cad.declared import Field
from elastica_cad.errors import InputError

if TYPE_CHECKING:
    from elastica_cad.mechanics.sheets import Sheet


UNITS = {"mm": 1.0, "inch": MM_PER_INCH}
"""Size in mm of each unit that `--units` accepts."""


class Length(click.ParamType):  # type: ignore[type-arg]  # no generic class before click 8.2
    """Length in mm: "38", "1.5in", "5/16in", "3.8cm". `elastica --units` sets the default unit.

    Parameters
    ----------
    positive : bool
        Reject zero and negative lengths.
    words : tuple of str
        Permitted words instead of a length.
    """

    name = "length"

    def __init__(self, *, positive: bool = False, words: tuple[str, ...] = ()) -> None:
        self.positive, self.words = positive, words

    def convert(self, value: Any, param: click.Parameter | None, ctx: click.Context | None) -> float | str:
        """Return the length in mm, or a permitted word. Defaults that are numbers are in mm."""
        if not isinstance(value, str):
            return float(value)
        if value in self.words:
            return value
        plain = UNITS[(ctx.find_root().params.get("units") if ctx else None) or "mm"]
        length = read_length(value)
        with suppress(ValueError):
            length = plain * read_number(value) if length is None else length
        if length is None:
            accepted = ", ".join(["a number of mm", *(f"the word {word}" for word in self.words)])
            self.fail(
                f"{value!r} is not a length: give {accepted}, or a length with its unit such as 1.5in or 4cm",
                param,
                ctx,
            )
        if self.positive and not length > 0:
            self.fail(f"{value} is not a length above 0", param, ctx)
        return length


LENGTH = Length()
POINT, SPACE_POINT = (LENGTH, LENGTH), (LENGTH, LENGTH, LENGTH)


F = TypeVar("F", bound=Callable[..., Any])

Chosen: TypeAlias = Mapping[str, Any]
"""Values of the options of a command, by the names of their parameters."""


def option_name(name: str) -> str:
    """Return the option that sets a parameter, as the user types it: `--max-width`."""
    return f"--{name.replace('_', '-')}"


def option_of(
    field: Field,
    name: str = "",
    *,
    default: str = "",
    more: str = "",
    switch: bool = False,
    required: bool = False,
) -> Callable[[Any], Any]:
    """Return the option of a declared field, by default with the name of the field.

    Parameters
    ----------
    default, more : str
        Description of the default in help, and further help.
    switch : bool
        True for a flag that can only be switched on.
    """
    default_text = f"  [default: {default}]" if default else ""
    typed, help = option_name(name or field.name), f"{field.help.rstrip('.')}.{more}{default_text}"
    if switch or field.kind.name == "flag":
        words = typed if switch else f"{typed}/--no-{typed[2:]}"
        return click.option(words, is_flag=True, default=None, help=help)
    kind, placeholder = _typed_as(field)
    return click.option(typed, type=kind, metavar=placeholder, required=required, help=help)


def _typed_as(field: Field) -> tuple[Any, str | None]:
    """Return the type of an option, and its metavar, for a field.

    A length may also be one of the field's words.
    """
    from elastica_cad.design.records import written

    kinds = written(field.kind).alternatives
    words = tuple(word for alternative in kinds for word in alternative.choices)
    if any(alternative.name == "number" for alternative in kinds):
        if field.option.unit != "mm":
            return float, "NUMBER"
        return (Length(words=words), "|".join(("MM", *words))) if words else (LENGTH, "MM")
    return (click.Choice(words), None) if words else (str, "NAME" if field.name == "sheet" else "TEXT")


def given_of(chosen: Chosen, names: Iterable[str]) -> dict[str, Any]:
    """Return the named parameters that the user has given."""
    return {name: chosen[name] for name in names if chosen[name] is not None}


def typed_options() -> dict[str, str]:
    """Return the options that the user has typed, by the names of their parameters."""
    context = click.get_current_context()
    return {
        str(option.name): option.opts[0]
        for option in context.command.params
        if context.get_parameter_source(str(option.name)) is ParameterSource.COMMANDLINE
    }


def refuse_idle(
    needs: Mapping[str, Sequence[str]], replaces: Mapping[str, Sequence[str]] = MappingProxyType({})
) -> None:
    """Raise InputError for typed options that have no effect.

    An option of `needs` has no effect without one of the others. An option of `replaces` leaves the others without
    effect. All are given by the names of their parameters, and may be arguments.
    """
    known = {
        str(option.name): option.opts[0] if isinstance(option, click.Option) else option.opts[0].upper()
        for option in click.get_current_context().command.params
    }
    typed = {name: known[name] for name in typed_options()}
    for name, option in typed.items():
        others = needs.get(name, ())
        if others and typed.keys().isdisjoint(others):
            raise InputError(
                "{option} has no effect without {others}. Add {others}, or leave out {option}.",
                option=option, others=" or ".join(known[other] for other in others),
            )  # fmt: skip
        if idle := [typed[other] for other in replaces.get(name, ()) if other in typed]:
            raise InputError(
                "{option} has no effect beside {other}. Leave out one of these options.",
                option=idle[0], other=option,
            )  # fmt: skip


def join_options(*options: Callable[[Any], Any]) -> Callable[[F], F]:
    """Return a decorator that adds several options, in the order in which help lists them."""

    def add(function: F) -> F:
        for option in reversed(options):
            function = option(function)
        return function

    return add


smooth_option = click.option(
    "--smooth", type=LENGTH, metavar="MM",
    help="Largest movement of the curve by smoothing, which removes jumps of curvature; 0: exactly as drawn  "
         "[default: 0.1 mm or 5e-4 of the length if the width would jump, else 0]",
)  # fmt: skip


class _Folder(click.Path):
    """Output folder, which must not look like an option, because the folder was then probably forgotten."""

    def convert(self, value: Any, param: click.Parameter | None, context: click.Context | None) -> Any:
        if str(value).startswith("-"):
            self.fail(
                f"'{value}' looks like an option: name a folder before it, or write ./{value}", param, context
            )
        return super().convert(value, param, context)


output_options = join_options(
    click.option("--force", is_flag=True, help="Overwrite files that exist."),
    click.option("-o", "--output", type=_Folder(path_type=Path), default=Path(), help="Folder for files."),
)


def sheet_options(*, required: bool, use: str = "Material") -> Callable[[F], F]:
    """Return a decorator that adds options for the sheet, by name or file, and for its thickness."""

    return join_options(
        click.option("--sheet", required=required, metavar="NAME|FILE",
                     help=f"{use}: a name of `elastica sheets`, or a sheet file, my.toml or my.toml:NAME."),
        click.option("--thickness", type=LENGTH, metavar="MM",
                     help="Thickness, if it differs from that of the sheet."),
    )  # fmt: skip


def requested_sheet(chosen: Chosen) -> "Sheet":
    """Return the sheet that the options of `sheet_options` select."""
    from elastica_cad.mechanics.sheets import Sheet

    sheet = Sheet.named(chosen["sheet"])
    return sheet if chosen["thickness"] is None else sheet.with_thickness(chosen["thickness"])
