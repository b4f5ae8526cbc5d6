"""The one family of errors: every message says what is wrong, where (mm), and what to do."""

import sys
from pathlib import Path
from reprlib import Repr

_QUOTED = Repr()
_QUOTED.maxstring = _QUOTED.maxother = 60


class ElasticaError(Exception):
    """Base of every error raised on purpose by elastica_cad."""


class InputError(ElasticaError, ValueError):
    """Input that no computation can start from: a bad file, number, option or curve."""


class NotConvergedError(ElasticaError, RuntimeError):
    """A solver stopped short of its tolerance; no half-converged shape is ever returned."""


class NotMetError(NotConvergedError):
    """The limits cannot be met near the drawn curve."""


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
