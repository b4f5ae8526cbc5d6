"""The command as the user typed it, and the words that change it: each option knows the field that it sets."""

import shlex
from collections.abc import Sequence

import click

from elastica_cad.cli.running.program import name_program
from elastica_cad.errors import Change

TYPED = "elastica.typed"
"""Key of the words that the user typed, in click's `meta`."""

OTHER_FIELDS = {"limits": "nearest", "keep": "keep_ends", "loads": "hung", "ends": "tab", "width": "outer_width",
                "limit width": "width_range"}  # fmt: skip
"""Parameters of options that set a field of another name."""

MOST_REFUSALS = 7
"""Curves of a file whose refusals are printed."""


def _command_line(*words: str) -> str:
    """A command as it is typed."""
    return f"{name_program()} {shlex.join(words)}"


def typed_line(*added: str, instead: str | None = None) -> str:
    """The running command as it was typed with options behind it, which outweigh those of the same name before.

    `instead` names another command that takes the same options, but for those that print.
    """
    context = click.get_current_context()
    words: Sequence[str] = context.meta.get(TYPED, ())
    if instead is not None:
        words = [instead if word == context.info_name else word for word in words if word != "--json"]
    return _command_line(*words, *added)


def typed_length(mm: float) -> str:
    """A length, mm, as it is typed behind the words of the running command: with its unit where it has others."""
    context = click.get_current_context(silent=True)
    units = "mm" if context is None else context.params.get("units", "mm")
    return f"{mm:g}" if units == "mm" else f"{mm:g}mm"


def option_of(field: str) -> str:
    """The option of the running command that sets a field of the request; empty where it has none."""
    options = {option.name: option.opts[0] for option in click.get_current_context().command.params}
    name = options.get(OTHER_FIELDS.get(field, field), "")
    return name if name.startswith("--") else ""


def option_words(change: Change) -> tuple[str, ...]:
    """The words that make a change; none where the running command has no option for it."""
    option = option_of(change.field)
    if not option:
        return ()
    return (option,) if change.value is True else (option, typed_length(change.value))


def first_told(refused: int) -> str:
    """Which of so many refusals of curves are printed, behind how many there are."""
    if refused <= MOST_REFUSALS:
        return ""
    return f", of which the first {MOST_REFUSALS} are told: -v tells all"
