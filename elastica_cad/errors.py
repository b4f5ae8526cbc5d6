"""Errors of elastica_cad. Every message states the problem, its position (mm), and an instruction."""

import re
import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
from datetime import date, time
from functools import cache
from math import ceil, floor, isfinite, log10
from pathlib import Path
from reprlib import Repr
from typing import Any, ParamSpec, Self, TypeVar

from elastica_cad.refusals import Change, Length, Refusal

__all__ = [
    "Change",
    "ElasticaError",
    "FaultError",
    "InputError",
    "Length",
    "MissingDependencyError",
    "NotConvergedError",
    "NotMetError",
    "Refusal",
    "StrainError",
    "UnknownOptionError",
    "how_to_install",
    "installed_version",
    "missing_library",
    "near_names",
    "quoted",
    "refuse_options_unlike",
    "refuse_unknown",
    "rounded_down",
    "rounded_up",
    "toml_slip",
]

P = ParamSpec("P")
R = TypeVar("R")


class _Quoted(Repr):
    def repr_date(self, value: date | time, _: int) -> str:
        return value.isoformat()

    repr_datetime = repr_time = repr_date


_QUOTED = _Quoted()
_QUOTED.maxstring = _QUOTED.maxother = 60


class ElasticaError(Exception):
    """Base class of all errors raised by elastica_cad.

    Parameters
    ----------
    text : str
        A complete sentence, or a template with {name} for each value.
    kind : str, optional
        Identifier of the kind of error, for programs. The default is the identifier of the class.
    where : mapping, optional
        Location of the problem: "file", "strip", "field" (name of an option) or "at" (mm along the curve).
    changes : sequence of Change, optional
        Suggested values of options.
    **values : object
        Values of the template. Lengths are passed as `Length`.

    Attributes
    ----------
    refusal : Refusal
        Record of the message with `kind`, `where`, `changes` and `values`.
    details : tuple of str
        Sentences for verbose output.

    Examples
    --------
    >>> problem = InputError("the ends are {distance} apart", distance=Length(120), where={"field": "end"})
    >>> str(problem.at(strip="A1")), problem.refusal.values["distance"] + 0.0, problem.refusal.where["field"]
    ('A1: the ends are 120 mm apart', 120.0, 'end')
    """

    KIND = "error"

    refusal: Refusal
    details: tuple[str, ...] = ()

    def __init__(
        self,
        text: str = "",
        /,
        *,
        kind: str | None = None,
        where: Mapping[str, Any] | None = None,
        changes: Sequence[Change] = (),
        **values: Any,
    ) -> None:
        if isinstance(text, Refusal):
            where, changes = {**text.where, **(where or {})}, (*changes, *text.changes)
            values = {**text.values, **values}
            text = text.text
        # store errors as texts, because errors cannot be passed to another process
        values = {
            name: str(value) if isinstance(value, BaseException) else value for name, value in values.items()
        }
        self.refusal = Refusal(kind or self.KIND, str(text), values, where, changes)
        super().__init__(str(self.refusal))

    def __str__(self) -> str:
        return self.refusal  # front ends can translate a Refusal, which is a str

    def __reduce__(self) -> tuple[Any, ...]:
        return _restored, (type(self), str(self)), self.__dict__

    def at(self, **where: Any) -> Self:
        """Add a location to this error and return it: `raise problem.at(strip="A1")`."""
        self.refusal = self.refusal.at(**where)
        return self


def _restored(kind: type[ElasticaError], message: str) -> ElasticaError:
    """Restore a pickled error without calling its constructor, whose signature depends on the class."""
    return kind.__new__(kind, message)


class InputError(ElasticaError, ValueError):
    """The input is not valid: a file, number, option or curve."""

    KIND = "input"


class UnknownOptionError(InputError, TypeError):
    """An option does not exist. This error is also a `TypeError`, which Python raises for unknown arguments."""

    KIND = "unknown"


class StrainError(InputError):
    """The strip would break, because its strain exceeds the breaking strain of its sheet."""

    KIND = "strain"


class FaultError(InputError):
    """No part can be made within the widths of the request and the limits of the workshop."""

    KIND = "fault"


class NotConvergedError(ElasticaError, RuntimeError):
    """A solver did not reach its tolerance, so there is no result."""

    KIND = "not converged"


class NotMetError(NotConvergedError):
    """The limits cannot be met close enough to the drawn curve."""

    KIND = "not met"


class MissingDependencyError(ElasticaError, ImportError, RuntimeError):
    """A required optional library is not installed, or its version is not supported."""

    KIND = "missing"


def quoted(value: object) -> str:
    """Format a value from a file for a message. Long texts and lists are truncated.

    Examples
    --------
    >>> quoted("mm"), len(quoted("m" * 2000))
    ("'mm'", 60)
    """
    return _QUOTED.repr(value)


def toml_slip(text: str, error: Exception) -> str:
    """Return how to correct a line with a TOML error.

    Examples
    --------
    >>> toml_slip("max_width = 2,5", ValueError("Expected newline (at line 1, column 14)"))
    'write decimals with a point, 2.5'
    """
    match = re.search(r"at line (\d+)", str(error))
    lines = text.splitlines()
    line = lines[int(match[1]) - 1] if match and int(match[1]) <= len(lines) else ""
    if "\\" in line:
        return "write / in place of \\ in paths"
    if comma := re.search(r"=\s*([+-]?\d+),(\d+)", line):
        return f"write decimals with a point, {comma[1]}.{comma[2]}"
    if line.lstrip().startswith("[") and not line.isascii():
        return 'put names with letters beyond a-z in quotes, as in [sheets."grün"]'
    return "mend that line"


def how_to_install(package: str) -> str:
    """Return the command that installs a package in the running environment.

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


def missing_library(use: str, library: str) -> MissingDependencyError:
    """Return the error for a missing library. `use` is the operation that needs it.

    Examples
    --------
    >>> str(missing_library("reading a.dxf needs ezdxf", "ezdxf")).endswith("pip install ezdxf")
    True
    """
    return MissingDependencyError(f"{use}: {how_to_install(library)}")


def installed_version(package: str) -> str | None:
    """Return the version of an installed package, or None. elastica_cad may run from a checkout."""
    from importlib.metadata import PackageNotFoundError, version

    try:
        return version(package)
    except PackageNotFoundError:
        return None


def refuse_unknown(options: Iterable[str], known: Iterable[str], what: str) -> None:
    """Raise an error for unknown names of options.

    Parameters
    ----------
    options, known : iterable of str
        The names to be checked, and the known names.
    what : str
        Name, in the message, of the object that has these options.

    Raises
    ------
    UnknownOptionError
        A name is unknown. The message suggests the known name with the most similar spelling, or lists all.

    Examples
    --------
    >>> refuse_unknown(["widht"], ["width", "height"], "a plate")
    Traceback (most recent call last):
    elastica_cad.errors.UnknownOptionError: widht is not an option of a plate: did you mean width?
    """
    names = sorted(known)
    for name in options:
        if name not in names:
            near = near_names(name, names)
            hint = f"did you mean {near[0]}?" if near else f"there are {', '.join(names)}"
            raise UnknownOptionError(
                "{name} is not an option of {what}: {hint}", name=name, what=what, hint=hint, near=near
            )


def near_names(name: str, known: Iterable[str], *, cutoff: float = 0.6) -> list[str]:
    """Return a list of the known name with the most similar spelling, or an empty list.

    A name is similar enough if its similarity by `difflib`, 0 to 1, is at least `cutoff`.
    """
    from difflib import get_close_matches

    return get_close_matches(name, list(known), n=1, cutoff=cutoff)


def refuse_options_unlike(names: Iterable[str], function: Callable[..., object], what: str) -> None:
    """Raise UnknownOptionError for the first name that is not a keyword of the function."""
    refuse_unknown(names, _keywords(function), what)


@cache
def _keywords(function: Callable[..., object]) -> tuple[str, ...]:
    from inspect import signature

    return tuple(
        name
        for name, parameter in signature(function).parameters.items()
        if parameter.kind is parameter.KEYWORD_ONLY
    )


def rounded_up(value: float, figures: int = 4) -> float:
    """Round a minimum up for a message, so that the displayed value is sufficient.

    Examples
    --------
    >>> rounded_up(20.4612), rounded_up(20.0), rounded_up(0.0123401, 3)
    (20.47, 20.0, 0.0124)
    """
    return _rounded(value, figures, up=True)


def rounded_down(value: float, figures: int = 4) -> float:
    """Round a maximum down for a message, so that the displayed value is permitted.

    Examples
    --------
    >>> rounded_down(5.786, 3), rounded_down(5.78, 3)
    (5.78, 5.78)
    """
    return _rounded(value, figures, up=False)


def _rounded(value: float, figures: int, *, up: bool) -> float:
    """Return a positive number with `figures` significant digits, rounded up or down."""
    if not (isfinite(value) and value > 0):
        return value
    step = 10.0 ** (floor(log10(value)) - figures + 1)
    steps = value / step
    # the allowance of 1e-9 keeps numbers that need no rounding
    whole = ceil(steps - 1e-9) if up else floor(steps + 1e-9)
    return float(f"{whole * step:.{figures}g}")
