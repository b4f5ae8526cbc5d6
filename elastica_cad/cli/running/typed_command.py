"""The command as the user typed it, and how a refusal of it is said."""

import shlex
from contextvars import ContextVar

from elastica_cad.cli.running.program import name_program
from elastica_cad.errors import ElasticaError

TRYING: ContextVar[bool] = ContextVar("elastica.trying", default=False)
"""Does a command run to see whether it works? It then looks for no cure of its own."""

TYPED = "elastica.typed"
"""Key of the words that the user typed, in click's `meta`."""

MOST_CURES = 12
"""Curves of a file for which a command is sought; each costs a few solves."""


def command_line(*words: str) -> str:
    """A command as it is typed."""
    return f"{name_program()} {shlex.join(words)}"


def say_with_cure(problem: ElasticaError) -> str:
    """The refusal, and the cure that was found for it."""
    said, cure = str(problem), " ".join(getattr(problem, "__notes__", ()))
    return f"{said}{'' if said.endswith(('.', '?', '!', '.)')) else '.'} {cure}" if cure else said
