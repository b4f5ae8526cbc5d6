# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""How a feature fails: a state with a sentence, and in the report view that sentence instead of a traceback.

FreeCAD turns every exception of `execute` into the feature's state and writes its traceback first. It asks for
the text of the exception's class, then for that of the exception, then it prints the traceback, then it lets go
of the exception: between the first and the last of these Python is told to print no tracebacks.
"""

import sys
from typing import Any

import FreeCAD as App
import Part
from freecad.elastica_wb.host.user_units import worded

from elastica_cad.errors import ElasticaError, InputError, MissingDependencyError

FAILURES = (ElasticaError, ImportError, Part.OCCError, App.Base.FreeCADError)
"""What `execute` answers in words; anything else is a mistake of ours and shows where it was made."""

LIMIT = "tracebacklimit"


class _Speaker(type):
    """The class of a class whose text is the name of what failed."""

    who = ""
    limit: int | None = None

    def __str__(cls) -> str:
        if not cls.who:
            return super().__str__()
        cls.limit = getattr(sys, LIMIT, None)
        sys.tracebacklimit = 0
        return f"Elastica, {cls.who}"

    def over(cls) -> None:
        """The exception is gone: tracebacks as before."""
        if cls.limit is not None:
            sys.tracebacklimit = cls.limit
        elif getattr(sys, LIMIT, None) == 0:
            del sys.tracebacklimit
        cls.who, cls.limit = "", None


class RefusalError(ValueError, metaclass=_Speaker):
    """Raised by `execute` only, and never kept: it lives as long as FreeCAD needs to report it."""

    def __del__(self) -> None:
        type(self).over()


def refused(obj: Any, error: ElasticaError) -> RefusalError:
    """What `execute` raises when an object cannot be made."""
    RefusalError.who = obj.Label
    return RefusalError(worded(str(error)))


def explained(error: Exception) -> ElasticaError:
    """One of `FAILURES` as a sentence of ours."""
    if isinstance(error, ElasticaError):
        return error
    if isinstance(error, ImportError):
        return MissingDependencyError(
            f"{error.name} is not installed in this FreeCAD: strips need numpy and scipy"
        )
    return InputError(
        f"FreeCAD's kernel cannot make this shape ({str(error).strip() or type(error).__name__}): change the "
        "curve, the widths or the holes"
    )
