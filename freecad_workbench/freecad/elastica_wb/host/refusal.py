# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""Errors of features, shown as the state of the feature and as one line in the report view.

FreeCAD prints the traceback of an exception that `execute` raises, with all Python functions in it, at every
recompute, and FreeCAD 1.x repeats the message at the end of the recompute. This output is suppressed, and an
error is reported once.
"""

import os
import re
from typing import Any

import FreeCAD as App
import Part
from FreeCAD import Base
from freecad.elastica_wb.host.objects import is_ours
from freecad.elastica_wb.host.words import before_report, report_error, worded

from elastica_cad.errors import ElasticaError, FieldName, InputError, MissingDependencyError, note

FAILURES = (ElasticaError, ImportError, Part.OCCError, Base.FreeCADError)
"""Exceptions that `execute` turns into messages. Any other exception is a bug."""

LOST_LINK = re.compile(r"[Oo]bject: (.+)\n.*[Ff]ile: (.+)")
"""Pattern of FreeCAD's message on a link whose file is missing or whose document was closed."""


FORMULA = re.compile(r"(.*)\nin property binding '.*\.(\w+)'\s*", re.DOTALL)
"""Pattern of FreeCAD's message on a formula that cannot be computed."""


def refused(obj: Any, error: ElasticaError) -> ValueError:
    """Report the error of an object, unless the last recompute reported it, and return it as an exception."""
    message = worded(str(error))
    if "Recompute" in obj.State:
        if message != obj.Proxy.reported and (App.GuiUp or not REPEATS):
            report_error(message, obj.Label)
        _silence.begin()
    obj.Proxy.reported = message
    return ValueError(message)


OBSERVERS = ("Console", "ReportOutput", "StatusBar", "File")
"""Names of what prints errors. FreeCAD 0.20 has no list of them."""

REPEATS = int(App.Version()[0]) >= 1
"""True if this FreeCAD prints the state of failed objects at the end of a recompute."""


class _Silence:
    """Suppression of printed errors, from `begin` until the next change, report or recompute."""

    def __init__(self) -> None:
        # names of the console's observers that print errors
        self._observers: list[str] = []
        App.addDocumentObserver(self)
        before_report.append(self.end)

    def begin(self) -> None:
        self.end()
        names = App.Console.GetObservers() if REPEATS else OBSERVERS
        self._observers = [name for name in names if App.Console.GetStatus(name, "Err")]
        self._set(False)

    def end(self, *_: Any) -> None:
        self._set(True)
        self._observers = []

    slotBeforeChangeObject = slotRecomputedObject = end

    def slotRecomputedDocument(self, document: Any) -> None:
        """Suppress also what FreeCAD prints after this signal, unless an object of another workbench failed."""
        self.end()
        failed = [obj for obj in document.Objects if "Invalid" in obj.State]
        if App.GuiUp and failed and all(map(is_ours, failed)):
            from freecad.elastica_wb.host.qt import QtCore

            self.begin()
            QtCore.QTimer.singleShot(0, self.end)

    def _set(self, on: bool) -> None:
        for name in self._observers:
            App.Console.SetStatus(name, "Err", on)


_silence = _Silence()


def explained(error: Exception) -> ElasticaError:
    """Convert an exception of `FAILURES` to an error with an instruction."""
    if isinstance(error, ElasticaError):
        return error
    if isinstance(error, ImportError):
        return MissingDependencyError(
            "{name} is not installed in this FreeCAD: install numpy and scipy",
            name=error.name or "a library",
        )
    return InputError(
        "FreeCAD's kernel cannot make this shape ({why}): change the curve, the widths or the holes",
        why=str(error).strip() or type(error).__name__,
    )


def why_not_made(obj: Any) -> str:
    """Return the error of an object or of its sources, or "" if there is none.

    An object whose source failed is skipped by FreeCAD and has no error state.
    """
    failed = [source for source in (obj, *obj.OutListRecursive) if "Invalid" in source.State]
    first = next((source for source in failed if not set(source.OutListRecursive) & set(failed)), None)
    if first is None:
        return ""
    if not is_ours(first):
        return worded(_message_of_other_object(first))
    message = why_not_computed(first) or str(first.getStatusString())
    return message if first is obj else f"{first.Label}: {message}"


def why_not_computed(obj: Any) -> str:
    """Return the error of a formula of an object, or "" if there is none."""
    match = FORMULA.fullmatch(str(obj.getStatusString())) if "Invalid" in obj.State else None
    if match is None:
        return ""
    reason = " ".join(match[1].split())
    return worded(note(
        "FreeCAD cannot compute the formula of {box} ({reason}). Correct or remove the formula.",
        box=FieldName(match[2]), reason=reason,
    ))  # fmt: skip


def is_broken_link(obj: Any) -> bool:
    """Return True if an object is a link whose target was deleted or is missing."""
    return bool(obj.TypeId.startswith("App::Link")) and getattr(obj, "LinkedObject", obj) is None


def broken_link_message(obj: Any) -> str:
    """Return a message on a broken link, with an instruction."""
    lost = LOST_LINK.search(str(obj.getStatusString()))
    if lost:
        return note(
            "{object} links to {lost} in {file}, which is missing. Restore or open the file, and recompute "
            "the document.",
            object=obj.Label, lost=lost[1], file=lost[2],
        )  # fmt: skip
    return note(
        "{object} links to a deleted object. Choose another object in {box}, or delete the link.",
        object=obj.Label,
        box=FieldName("LinkedObject"),
    )


def _message_of_other_object(obj: Any) -> str:
    """Return a message on an object of another workbench, because FreeCAD's text is for programmers."""
    status = str(obj.getStatusString())
    if is_broken_link(obj) or LOST_LINK.search(status):
        return broken_link_message(obj)
    file = getattr(obj, "FileName", "")
    if isinstance(file, str) and file and not os.path.exists(file):
        return note(
            "{object} reads {file}, which is missing. Restore the file, or choose another file in {box}, and "
            "recompute the document.",
            object=obj.Label,
            box=FieldName("FileName"),
            file=file,
        )
    return note(
        "{object} cannot be made ({why}). Correct this object first.",
        object=obj.Label,
        why=" ".join(status.split()),
    )
