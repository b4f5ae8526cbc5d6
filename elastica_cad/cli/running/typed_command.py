"""The command as the user typed it, and the cure that is looked for once it is refused."""

import shlex
import time
from collections.abc import Callable, Iterable, Iterator
from contextvars import ContextVar
from typing import TypeVar

import click

from elastica_cad.cli.running.program import name_program
from elastica_cad.errors import ElasticaError, NotMetError

T = TypeVar("T")

TRYING: ContextVar[bool] = ContextVar("elastica.trying", default=False)
"""Does a command run to see whether it works? It then looks for no cure of its own."""

TYPED = "elastica.typed"
"""Key of the words that the user typed, in click's `meta`."""

LONGEST_SEARCH_S = 10.0
"""For a command that would work: the user did not ask for this search, so nothing more is tried after so long."""

MOST_CURES = 7
"""Curves of a file whose refusals are told, and for which a command is sought; each costs a few solves."""


def command_line(*words: str) -> str:
    """A command as it is typed."""
    return f"{name_program()} {shlex.join(words)}"


def typed_length(mm: float) -> str:
    """A length, mm, as it is typed behind the words of the running command: with its unit where it has others."""
    context = click.get_current_context(silent=True)
    return length_among(f"{mm:g}", "mm" if context is None else context.params.get("units", "mm"))


def length_among(mm: str, units: str) -> str:
    """A length, mm, as it is typed among others in `units`: with its own where these are not mm."""
    return mm if units == "mm" else f"{mm}mm"


def cure_later(problem: ElasticaError, look: Callable[[], str]) -> None:
    """Have a cure looked for once the problem is told, as the running command would."""
    context = click.get_current_context()

    def look_here() -> str:
        with context.scope(cleanup=False):
            return look()

    problem.look_for_cure = look_here


def while_short(tries: Iterable[T]) -> Iterator[T]:
    """The things to try, as long as the search has not become long.

    Examples
    --------
    >>> list(while_short("ab"))
    ['a', 'b']
    """
    end = time.monotonic() + LONGEST_SEARCH_S
    for one in tries:
        if time.monotonic() > end:
            return
        yield one


def is_cured(problem: ElasticaError) -> bool:
    """Is its cure known, or known where to look for?"""
    known = problem.look_for_cure is not None or hasattr(problem, "__notes__")
    return known or isinstance(problem, NotMetError)


def cure_of(problem: ElasticaError) -> str:
    """What would work instead, looked for now unless it came with the problem."""
    look = problem.look_for_cure
    advice = () if TRYING.get() else problem.advice
    cures = getattr(problem, "__notes__", ()) if look is None else (look(),)
    return " ".join(filter(None, (*advice, *cures)))


def with_cure(said: str, cure: str) -> str:
    """Both as one text."""
    return f"{said}{'' if said.endswith(('.', '?', '!', '.)')) else '.'} {cure}" if cure else said


def first_told(refused: int) -> str:
    """Which of so many refusals of curves are told, behind how many there are."""
    if refused <= MOST_CURES:
        return ""
    return f", of which the first {MOST_CURES} are told: -v tells all, --curve N what works for one"
