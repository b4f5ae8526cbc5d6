"""The typed command, and suggestions of a command that works."""

import shutil
import sys
from collections.abc import Callable, Collection, Sequence
from contextlib import suppress
from functools import partial
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias

import click

from elastica_cad._text import quote_words
from elastica_cad.errors import ElasticaError

if TYPE_CHECKING:
    from elastica_cad.strip.strip_spec import StripSpec
    from elastica_cad.strip.suggestions import Suggestion


def name_program() -> str:
    """Return the command of this program: its name, its path if the name finds another program, or the module."""
    called = Path(sys.argv[0])
    if called.parts[-2:] == ("elastica_cad", "__main__.py"):
        return f"{quote_words([sys.executable])} -m elastica_cad"
    program = shutil.which("elastica")
    if called.stem == "elastica" and called.exists() and not (program and called.samefile(program)):
        return quote_words([sys.argv[0]])
    return "elastica"


TYPED = "elastica.typed"
"""Key of the words that the user typed, in click's `meta`."""

MOST_REFUSALS = 7
"""Largest number of curves of a file whose refusals are printed."""


def typed_line(*added: str, instead: str | None = None) -> str:
    """Return the running command as typed, with added options that override earlier options of the same name.

    `instead` is another command with the same options, except output options.
    """
    context = click.get_current_context()
    words: Sequence[str] = context.meta.get(TYPED, ())
    if instead is not None:
        words = [instead if word == context.info_name else word for word in words if word != "--json"]
    return f"{name_program()} {quote_words([*words, *added])}"


def typed_length(mm: float) -> str:
    """Return a length (mm) as an argument of the running command, with its unit if the command uses another
    unit."""
    context = click.get_current_context(silent=True)
    units = "mm" if context is None else context.find_root().params.get("units", "mm")
    return f"{mm:g}" if units == "mm" else f"{mm:g}mm"


def listing_note(refused: int) -> str:
    """Return a text on which of many rejected curves are printed."""
    if refused <= MOST_REFUSALS:
        return ""
    return f"; the first {MOST_REFUSALS} are listed, all with -v"


Cure: TypeAlias = dict[str, Any]
"""Change as a table for reports, see `Suggestion.as_dict`; its text is what is printed."""

SUGGEST = "elastica.suggest"
"""Key, in click's `meta`, of the function that searches for a suggestion after an error."""


def suggest_later(
    request: Callable[[ElasticaError], "StripSpec | None"],
    spelled: "Callable[[Suggestion], str]",
    fields: Collection[str] | None = None,
) -> None:
    """Register a search for changes that is made after an error of the running command is printed.

    `request` returns the refused request, or None. `spelled` returns a change as the user types it.
    """

    def search(problem: ElasticaError) -> list[Cure]:
        with suppress(ElasticaError):
            spec = request(problem)
            return [] if spec is None else cures_of(spec, problem, spelled, fields)
        return []

    context = click.get_current_context()
    context.meta[SUGGEST] = lambda problem: _inside(context, partial(search, problem))


def _inside(context: click.Context, search: Callable[[], list[Cure]]) -> list[Cure]:
    with context.scope(cleanup=False):
        return search()


def cures_after(problem: ElasticaError) -> list[Cure]:
    """Return the changes that the running command registered for this error."""
    search = click.get_current_context().meta.get(SUGGEST)
    return [] if search is None else search(problem)


def cures_of(
    spec: "StripSpec",
    problem: ElasticaError,
    spelled: "Callable[[Suggestion], str]",
    fields: Collection[str] | None = None,
) -> list[Cure]:
    """Return the changes that make the request possible, as tables with a printed text; Ctrl-C ends the search."""
    from elastica_cad.strip.suggestions import suggest

    found: list[Cure] = []
    with suppress(KeyboardInterrupt, MemoryError):
        for suggestion in suggest(spec, problem, fields):
            text = f"This works: {spelled(suggestion).rstrip('.')} ({suggestion.effect})."
            found.append(suggestion.as_dict() | {"text": text})
    return found
