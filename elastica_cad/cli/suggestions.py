"""The typed command, and suggestions of a command that works."""

import shutil
import sys
from collections.abc import Callable, Iterable, Iterator, Sequence
from contextlib import suppress
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeAlias

import click
import numpy as np

from elastica_cad._text import quote_words
from elastica_cad.declared import REQUIRED, declared
from elastica_cad.errors import Change, ElasticaError
from elastica_cad.forming.rod_solution import solve_rod
from elastica_cad.mechanics.support_search import suggest_support

if TYPE_CHECKING:
    from elastica_cad.strip.strip_spec import StripSpec


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


MOST_TRIED = 3
"""Largest number of candidates after an error; each takes as long as the request."""

WIDEST_SHARE = 0.5
"""Largest width of a strip as a fraction of its length; a wider one bends as a plate."""

SUGGEST = "elastica.suggest"
"""Key, in click's `meta`, of the function that searches for a suggestion after an error."""

Candidate: TypeAlias = "tuple[str, Callable[[], Sequence[StripSpec]]]"
"""Message about a suggestion, and the requests of its strips."""


def suggest_later(look: Callable[[ElasticaError], str]) -> None:
    """Register a function that searches for a suggestion after an error of the running command is printed."""
    context = click.get_current_context()

    def look_here(problem: ElasticaError) -> str:
        with context.scope(cleanup=False):
            return look(problem)

    context.meta[SUGGEST] = look_here


def suggestion_below(problem: ElasticaError) -> str:
    """Return a sentence with a possible request, or "" if none was found."""
    look = click.get_current_context().meta.get(SUGGEST)
    return "" if look is None else look(problem)


def changed_requests(spec: "StripSpec", change: Change) -> "Sequence[StripSpec]":
    """Return the requests after a change of this request, or an empty list if nothing changes."""
    changed = spec.with_change(change)
    return [] if changed is None else [changed]


def supported(spec: "StripSpec", typed: Callable[..., str]) -> "Iterator[Candidate]":
    """Yield the request with the rail, pin or tie that makes the curve possible, if there is one.

    `typed` returns the command with added options.
    """
    if spec.may_change or spec.between or spec.loads or spec.gravity is not None:
        return
    support = None
    with suppress(ElasticaError):
        support = suggest_support(spec.rod_spec.curve_to_bend, spec.supports, spec.natural_curvature)
    if support is None:
        return
    # the option has the name of the record, and its values are the places
    record: Any = type(support)
    places = [getattr(support, field.name) for field in declared(record) if field.default is REQUIRED]
    words = f"--{record.__name__.lower()}", *map(typed_length, places)
    yield f"`{typed(*words)}`", lambda: [spec.changed(between=support)]


def first_that_holds(candidates: Iterable[Candidate], nearest: Iterable[Candidate] = ()) -> str:
    """Return a sentence with the first of `MOST_TRIED` candidates whose strips are stable and strong enough.

    If there is none, the sentence lists all suitable candidates in `nearest`, which change more of the request. It
    is empty if there are none, or after Ctrl-C.
    """
    texts = []
    with suppress(KeyboardInterrupt, MemoryError):
        for message, requests in islice(candidates, MOST_TRIED):
            if held := _held(requests):
                return f"This works: {message} ({held})."
        for message, requests in nearest:
            if held := _held(requests):
                texts.append(f"{message} ({held})")
    return f"Possible with a larger change: {'; or '.join(texts)}." if texts else ""


def _held(requests: Callable[[], Sequence["StripSpec"]]) -> str:
    """Return deviation and strain of the strips as a text, empty if a strip is impossible or unsuitable."""
    from elastica_cad.forming.limits import FAR_SHARE
    from elastica_cad.forming.nearest_record import NearestRod
    from elastica_cad.mechanics.stability import stability

    farthest, used, name = 0.0, 0, ""
    try:
        for spec in requests():
            rod = solve_rod(spec.rod_spec)
            made = spec.make(rod)
            away = spec.rod_spec.smoothing.moved + (rod.deviation if isinstance(rod, NearestRod) else 0.0)
            size = float(np.hypot(*np.ptp(spec.curve.bounds, axis=0)))
            wide = float(made.width.extremes[1]) > WIDEST_SHARE * made.rod.length
            if wide or away > FAR_SHARE * size or not made.strain_verdict.allowed:
                return ""
            if not stability(made.rod).stable:
                return ""
            farthest, used = max(farthest, away), max(used, made.strain_verdict.percent)
            name = made.sheet.name
    except ElasticaError:
        return ""
    near = f"within {farthest:.2g} mm of the drawn curve" if farthest else "the curve as drawn"
    return f"{near}, {used} % of the allowed strain of {name}" if name else ""
