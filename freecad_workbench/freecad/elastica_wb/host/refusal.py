# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""How a feature fails: a state with a sentence, and in the report view that sentence in a line.

FreeCAD makes every exception of `execute` the feature's state, and writes the text of its class and its own behind
its traceback. A traceback is made of the Python functions that an exception leaves: one that is raised by compiled
code, called by FreeCAD through compiled code alone, has none. So Python hands its refusal over as a value, and
compiled code raises it: a generator at its end throws what it is given. FreeCAD then writes who asked for the
recompute instead.
"""

import os
import re
from collections.abc import Callable
from functools import partial, reduce
from operator import or_
from typing import Any

import Part
from FreeCAD import Base
from freecad.elastica_wb.host.lifetime import is_ours
from freecad.elastica_wb.host.words import worded

from elastica_cad.errors import ElasticaError, InputError, MissingDependencyError
from elastica_cad.refusals import note

FAILURES = (ElasticaError, ImportError, Part.OCCError, Base.FreeCADError)
"""What `execute` answers in words; anything else is a mistake of ours and shows where it was made."""

LOST_LINK = re.compile(r"[Oo]bject: (.+)\n.*[Ff]ile: (.+)")
"""What FreeCAD says of a link whose file it does not find, or whose document was closed."""


FORMULA = re.compile(r"(.*)\nin property binding '.*\.(\w+)'\s*", re.DOTALL)
"""What FreeCAD says of an object with a formula that it cannot compute: it leaves the object as it was."""


class _Speaker(type):
    """The class of a class whose text is the name of what failed."""

    who = ""

    def __str__(cls) -> str:
        return f" Elastica, {cls.who}"  # behind the place of the recompute


class RefusalError(ValueError, metaclass=_Speaker):
    """The error that `execute` raises when an object cannot be made."""


def refused(obj: Any, error: ElasticaError) -> RefusalError:
    """Return the error of an object as the exception that `raising` raises."""
    RefusalError.who = obj.Label
    return RefusalError(worded(str(error)))


def raising(work: Callable[[Any], RefusalError | None]) -> Callable[[Any], None]:
    """Work on an object that raises the refusal which `work` returns, without a Python function between."""
    return partial(reduce, or_, (_Worker(work), _Thrower()))  # (obj | worker) | thrower


class _Worker:
    """`obj | worker` works on the object: a refusal, or `_Made`."""

    def __init__(self, work: Callable[[Any], RefusalError | None]) -> None:
        self._work = work

    def __ror__(self, obj: Any) -> "RefusalError | _Made":
        return self._work(obj) or _Made()


class _Made:
    """Nothing is thrown after it."""

    def __or__(self, _thrower: object) -> None:
        return None


_ended: Any = (nothing for nothing in ())
next(_ended, None)


class _Thrower:
    """`refusal | thrower` raises it."""

    __ror__ = staticmethod(_ended.throw)


def explained(error: Exception) -> ElasticaError:
    """Return an exception of `FAILURES` as an error with advice."""
    if isinstance(error, ElasticaError):
        return error
    if isinstance(error, ImportError):
        return MissingDependencyError(
            "{name} is not installed in this FreeCAD: strips need numpy and scipy", name=error.name
        )
    return InputError(
        "FreeCAD's kernel cannot make this shape ({why}): change the curve, the widths or the holes",
        why=str(error).strip() or type(error).__name__,
    )


def why_not_made(obj: Any) -> str:
    """Return the error of an object, or of what it is made from; empty without error.

    FreeCAD leaves out what is made from something that failed, and that has no state of its own then.
    """
    failed = [one for one in (obj, *obj.OutListRecursive) if "Invalid" in one.State]
    first = next((one for one in failed if not set(one.OutListRecursive) & set(failed)), None)
    if first is None:
        return ""
    if not is_ours(first):
        return worded(_why_not_made_by_others(first))
    said = why_not_computed(first) or str(first.getStatusString())
    return said if first is obj else f"{first.Label}: {said}"


def why_not_computed(obj: Any) -> str:
    """Return the error of a formula of an object; empty without error."""
    found = FORMULA.fullmatch(str(obj.getStatusString())) if "Invalid" in obj.State else None
    if found is None:
        return ""
    reason = " ".join(found[1].split())
    return worded(note(
        "the formula of {property} cannot be computed ({reason}): mend it, or take it away",
        property=found[2], reason=reason,
    ))  # fmt: skip


def is_broken_link(obj: Any) -> bool:
    """Is it a link whose object was deleted, or is not found?"""
    return bool(obj.TypeId.startswith("App::Link")) and getattr(obj, "LinkedObject", obj) is None


def told_of_broken_link(obj: Any) -> str:
    """Return what is wrong with a broken link, and what to do."""
    lost = LOST_LINK.search(str(obj.getStatusString()))
    if lost:
        return note(
            "{object} links to {lost} in {file}, which is missing: put that file back or open it, and "
            "recompute the document",
            object=obj.Label, lost=lost[1], file=lost[2],
        )  # fmt: skip
    return note(
        "{object} links to what was deleted: choose another object in its property "
        "LinkedObject, or delete the link",
        object=obj.Label,
    )


def _why_not_made_by_others(obj: Any) -> str:
    """A sentence about an object of FreeCAD itself; its own words are those of a programmer."""
    said = str(obj.getStatusString())
    if is_broken_link(obj) or LOST_LINK.search(said):
        return told_of_broken_link(obj)
    file = getattr(obj, "FileName", "")
    if isinstance(file, str) and file and not os.path.exists(file):
        return note(
            "{object} reads {file}, which is missing: put that file back, or name another in its "
            "property FileName, and recompute the document",
            object=obj.Label,
            file=file,
        )
    return note(
        "{object} cannot be made ({why}): mend it first", object=obj.Label, why=" ".join(said.split())
    )
