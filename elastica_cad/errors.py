"""The one family of errors: every message says what is wrong, where (mm), and what to do."""

import re
import sys
from collections.abc import Callable, Iterable
from datetime import date, time
from functools import cache
from math import ceil, floor, isfinite, log10
from pathlib import Path
from reprlib import Repr
from typing import Self


class _Quoted(Repr):
    def repr_date(self, value: date | time, _: int) -> str:
        """As files have them."""
        return value.isoformat()

    repr_datetime = repr_time = repr_date


_QUOTED = _Quoted()
_QUOTED.maxstring = _QUOTED.maxother = 60


class ElasticaError(Exception):
    """Base of every error raised on purpose by elastica_cad.

    Attributes
    ----------
    look_for_cure : callable, optional
        Gives a sentence with what would work instead, or "". It may take seconds, so the error is told before.
    """

    look_for_cure: Callable[[], str] | None = None

    @property
    def verdict(self) -> str:
        """What is known at once of what is wrong."""
        return str(self)

    @property
    def advice(self) -> tuple[str, ...]:
        """Sentences that the message ends with, where finding them takes longer than the verdict."""
        return ()

    def named(self, name: str) -> Self:
        """The same error, told of the part of this name."""
        said = str(self)
        return type(self)(said if said.startswith(name) else f"{name}: {said}")


class InputError(ElasticaError, ValueError):
    """Input that no computation can start from: a bad file, number, option or curve."""


class UnknownOptionError(InputError, TypeError):
    """An option that no strip has, as Python itself refuses unknown arguments."""


class NotConvergedError(ElasticaError, RuntimeError):
    """A solver stopped short of its tolerance; no half-converged shape is ever returned."""


class NotMetError(NotConvergedError):
    """The limits cannot be met near the drawn curve.

    Parameters
    ----------
    verdict : str
    advise : callable
        Gives the advice, sentences about what would help; each may take a search of its own, so it is looked for
        when the message is read.
    """

    def __init__(self, verdict: str, advise: Callable[[], tuple[str, ...]] = tuple) -> None:
        super().__init__(verdict)
        self._advise = advise

    def __str__(self) -> str:
        return " ".join((self.verdict, *self.advice))

    def __reduce__(self) -> tuple[type[Self], tuple[str]]:
        return type(self), (str(self),)

    @property
    def verdict(self) -> str:
        """What is known at once: how near the search came, and what it kept from the drawn curve."""
        return str(self.args[0])

    @property
    def advice(self) -> tuple[str, ...]:
        """What would help, the most useful first."""
        return self._advise()

    def named(self, name: str) -> Self:
        """The same error, told of the part of this name."""
        return type(self)(f"{name}: {self.verdict}", self._advise)


class MissingDependencyError(ElasticaError, ImportError, RuntimeError):
    """An optional library is needed for what was asked and is not installed, or of an unknown version."""


def quoted(value: object) -> str:
    """A value of a file as a message shows it: long texts and lists in part.

    Examples
    --------
    >>> quoted("mm"), len(quoted("m" * 2000))
    ("'mm'", 60)
    """
    return _QUOTED.repr(value)


def toml_slip(text: str, error: Exception) -> str:
    """What to do about a line that TOML refuses.

    Examples
    --------
    >>> toml_slip("max_width = 2,5", ValueError("Expected newline (at line 1, column 14)"))
    'write decimals with a point, 2.5'
    """
    found = re.search(r"at line (\d+)", str(error))
    lines = text.splitlines()
    line = lines[int(found[1]) - 1] if found and int(found[1]) <= len(lines) else ""
    if "\\" in line:
        return "write / in place of \\ in paths"
    if comma := re.search(r"=\s*[+-]?(\d+),(\d+)", line):
        return f"write decimals with a point, {comma[1]}.{comma[2]}"
    if line.lstrip().startswith("[") and not line.isascii():
        return 'put names with letters beyond a-z in quotes, as in [sheets."grün"]'
    return "mend that line"


def how_to_install(package: str) -> str:
    """The command that installs a package where this program runs.

    Examples
    --------
    >>> how_to_install("matplotlib").endswith(" -m pip install matplotlib")
    True
    """
    here = sys.executable if Path(sys.executable).stem.startswith("python") else "python"
    words = (
        f'"{word}"' if set(word) & set(" []") else word for word in (here, "-m", "pip", "install", package)
    )
    return " ".join(words)


def refuse_unknown(asked: Iterable[str], known: Iterable[str], what: str) -> None:
    """Refuse the first name that is not known as an option of `what`.

    Raises
    ------
    UnknownOptionError
        There is one.
    """
    from difflib import get_close_matches

    names = sorted(known)
    for name in asked:
        if name not in names:
            near = get_close_matches(name, names, n=1)
            hint = f"did you mean {near[0]}?" if near else f"there are {', '.join(names)}"
            raise UnknownOptionError(f"{name} is no option of {what}: {hint}")


def refuse_options_unlike(asked: Iterable[str], function: Callable[..., object], what: str) -> None:
    """Refuse the first name that is no keyword of the function that the options go to.

    Raises
    ------
    UnknownOptionError
        There is one.
    """
    refuse_unknown(asked, _keywords(function), what)


@cache
def _keywords(function: Callable[..., object]) -> tuple[str, ...]:
    from inspect import signature

    return tuple(name for name, one in signature(function).parameters.items() if one.kind is one.KEYWORD_ONLY)


def rounded_up(value: float, figures: int = 4) -> str:
    """A least value as a message tells it: never below, so that what is told will do.

    Examples
    --------
    >>> rounded_up(20.4612), rounded_up(20.0), rounded_up(0.0123401, 3)
    ('20.47', '20', '0.0124')
    """
    return _rounded(value, figures, up=True)


def rounded_down(value: float, figures: int = 4) -> str:
    """A largest value in the same way, never above.

    Examples
    --------
    >>> rounded_down(5.786, 3), rounded_down(5.78, 3)
    ('5.78', '5.78')
    """
    return _rounded(value, figures, up=False)


def _rounded(value: float, figures: int, *, up: bool) -> str:
    if not (isfinite(value) and value > 0):
        return f"{value:.{figures}g}"
    step = 10.0 ** (floor(log10(value)) - figures + 1)
    steps = value / step
    whole = ceil(steps - 1e-9) if up else floor(steps + 1e-9)  # a value told exactly stays
    return f"{whole * step:.{figures}g}"
