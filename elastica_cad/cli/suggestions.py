"""The command as the user typed it, and the text of the changes that `strip/suggestions` found."""

import shutil
import sys
from collections.abc import Callable, Collection, Sequence
from contextlib import suppress
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias, cast

import click

from elastica_cad._text import quote_words
from elastica_cad.cli.voice import say_rows, say_step, warn
from elastica_cad.errors import ElasticaError, InputError, quoted
from elastica_cad.report_rows import Row

if TYPE_CHECKING:
    from elastica_cad.strip.strip_spec import StripSpec
    from elastica_cad.strip.suggestions import Suggestion


def name_program() -> str:
    """Return the command that starts this program: `elastica`, its path, or `python -m elastica_cad`."""
    called = Path(sys.argv[0])
    if called.parts[-2:] == ("elastica_cad", "__main__.py"):
        return f"{quote_words([sys.executable])} -m elastica_cad"
    program = shutil.which("elastica")
    if called.stem == "elastica" and called.exists() and not (program and called.samefile(program)):
        return quote_words([sys.argv[0]])
    return "elastica"


TYPED = "elastica.typed"
"""Key of the typed arguments in click's `meta`."""


def refuse_extra_words(words: Sequence[str]) -> None:
    """Raise InputError for the first of the words, which the running command does not take."""
    if not words:
        return
    from elastica_cad.mechanics.sheets import sheet_names

    word, context = words[0], click.get_current_context()
    needs_sheet = "sheet" in context.params and context.params["sheet"] is None
    advice = f"Write --sheet {word}." if needs_sheet and word in sheet_names() else (
        "Leave it out, or put quotes around a name with spaces."
    )  # fmt: skip
    raise InputError("{word} is an extra argument. {advice}", word=quoted(word), advice=advice)


def typed_line(
    *added: str, instead: str | None = None, without: Collection[str] = (), curve: Path | None = None
) -> str:
    """Return the running command as typed, with added options, which replace earlier values.

    `instead` is another command, which gets the same options except those for output and those that it lacks.
    `without` has options and tables of `--set` that are left out. `curve` is another file of the curve.
    """
    context = click.get_current_context()
    words: Sequence[str] = context.meta.get(TYPED, ())
    if instead is not None:
        words = [instead if word == context.info_name else word for word in words if word != "--json"]
        here, there = (
            {name for option in command.params for name in option.opts}
            for command in (context.command, cast(click.Group, context.find_root().command).commands[instead])
        )
        words = _without_values(words, here - there)
    if curve is not None:
        words = [str(curve) if Path(word) == context.params["curve"] else word for word in words]
    return f"{name_program()} {quote_words([*_without_values(words, added, without), *added])}"


def _without_values(words: Sequence[str], added: Collection[str], without: Collection[str] = ()) -> list[str]:
    """Return the words without the values of single options, and of keys of `--set`, that are added anew.

    All options in `without`, and all keys of `--set` in its tables, are left out too.
    """
    # number of values of each option that is left out
    replaced = dict[str, int]()
    for option in click.get_current_context().command.params:
        if isinstance(option, click.Option):
            single = option.nargs == 1 and not (option.multiple or option.is_flag)
            if set(option.opts) & {*without, *(added if single else ())}:
                replaced |= dict.fromkeys(option.opts, 0 if option.is_flag else option.nargs)
    keys = {setting.partition("=")[0] for name, setting in pairwise(added) if name == "--set"}
    remaining, following = list[str](), iter(words)
    for word in following:
        name, equals_sign, _ = word.partition("=")
        if word == "--set":
            setting = next(following, "")
            key = setting.partition("=")[0]
            remaining += [] if key in keys or key.partition(".")[0] in without else [word, setting]
        elif name not in replaced:
            remaining.append(word)
        elif not equals_sign:
            for _ in range(replaced[name]):
                next(following, None)
    return remaining


def typed_length(mm: float) -> str:
    """Return a length in mm as an argument of the running command, with its unit if `--units` is not mm."""
    context = click.get_current_context(silent=True)
    units = "mm" if context is None else context.find_root().params.get("units", "mm")
    return f"{mm:g}" if units == "mm" else f"{mm:g}mm"


Cure: TypeAlias = dict[str, Any]
"""Suggested change in a report: the keys of `Suggestion.as_dict`, and the printed text."""

LOOKING = "looking for changes that make the strip possible"
"""Step that is reported during the search for suggestions."""

SUGGEST = "elastica.suggest"
"""Key, in click's `meta`, of the function that searches for suggestions after an error."""


def suggest_later(
    request: Callable[[ElasticaError], "StripSpec | None"],
    spelled: "Callable[[Suggestion], str]",
    fields: Collection[str] | None = None,
) -> None:
    """Register a search for changes that runs after an error of the running command is printed.

    `request` returns the refused request, or None. `spelled` converts a change to a command or an
    instruction.
    """

    context = click.get_current_context()

    def search(problem: ElasticaError) -> list[Cure]:
        with context.scope(cleanup=False), suppress(ElasticaError):
            spec = request(problem)
            say_step(LOOKING)
            return [] if spec is None else cures_of(spec, problem, spelled, fields)
        return []

    context.meta[SUGGEST] = search


def cures_of(
    spec: "StripSpec",
    problem: ElasticaError,
    spelled: "Callable[[Suggestion], str]",
    fields: Collection[str] | None = None,
    assumed: str = "",
) -> list[Cure]:
    """Return changes of options that make the strip possible. Ctrl-C ends the search for changes.

    `assumed` names values of `spec` that the user did not set.
    """
    from elastica_cad.mechanics.trials import not_tried
    from elastica_cad.strip.suggestions import suggest

    cures: list[Cure] = []
    if reason := not_tried(spec.curve):
        say_rows(Row("Change", reason))
    with suppress(KeyboardInterrupt, MemoryError):
        for suggestion in suggest(spec, problem, fields):
            title, change = suggestion.title, spelled(suggestion)
            command = "" if change == title else f": {change}"
            text = f"{title.rstrip('.')} ({suggestion.effect}){command}."
            cures.append(suggestion.as_dict() | {"text": text})
        if not (cures or reason):
            more = f", with {assumed} assumed" if assumed else ""
            warn(f"No change that was tried makes the strip possible{more}.", in_notes=False)
    return cures
