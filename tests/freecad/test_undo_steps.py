"""Undo steps where transactions belong to the program (FreeCAD up to 1.1) and to the document (1.2)."""

from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

from . import launching


class OfProgram:
    """A document whose changes go into the program's transaction. `undo` lists the finished steps."""

    def __init__(self, app: Any) -> None:
        self.app, self.undo, self.pending = app, [], []

    def __repr__(self) -> str:
        return f"App.listDocuments()[{self.Name!r}]"

    @property
    def Name(self) -> str:  # as FreeCAD calls it
        return next(name for name, document in self.app.documents.items() if document is self)

    def change(self, what: str) -> None:
        if self.app.step:
            self.pending.append(what)

    def openTransaction(self, name: str) -> None:
        self.app.closeActiveTransaction(False)
        self.app.opened += 1
        self.app.step = (name, self.app.opened)

    def commitTransaction(self) -> None:
        if self.pending:  # FreeCAD ignores the call for an unchanged document
            self.app.closeActiveTransaction(False)

    def abortTransaction(self) -> None:
        if self.pending:
            self.app.closeActiveTransaction(True)

    def end(self, abort: bool) -> None:
        if self.pending and not abort:
            self.undo.append(self.pending)
        self.pending = []


class OfDocument(OfProgram):
    """A document with a transaction of its own."""

    booked = 0

    def change(self, what: str) -> None:
        if self.booked:
            self.pending.append(what)

    def openTransaction(self, name: str) -> None:
        self.end(False)
        self.app.opened += 1
        self.booked = self.app.opened

    def commitTransaction(self) -> None:
        self.end(False)

    def abortTransaction(self) -> None:
        self.end(True)

    def end(self, abort: bool) -> None:
        super().end(abort)
        self.booked = 0

    def getBookedTransactionID(self) -> int:
        return self.booked


class Program(ModuleType):
    """The module FreeCAD, with two documents. The second document is active."""

    DocumentObject = type("DocumentObject", (), {})

    def __init__(self, kind: type[OfProgram]) -> None:
        super().__init__("FreeCAD")
        self.Document, self.opened, self.step = kind, 0, None
        self.documents = {"First": kind(self), "Second": kind(self)}
        self.ActiveDocument = self.documents["Second"]

    def listDocuments(self) -> dict[str, OfProgram]:
        return self.documents

    def getDocument(self, name: str) -> OfProgram:
        return self.documents[name]

    def getActiveTransaction(self) -> tuple[str, int] | None:
        return self.step

    def closeActiveTransaction(self, abort: bool) -> None:
        of_documents = self.Document is OfDocument
        self.step = None
        for document in [self.ActiveDocument] if of_documents else self.documents.values():
            document.end(abort)


@pytest.fixture(params=[OfProgram, OfDocument])
def app(request, monkeypatch):
    from freecad.elastica_wb import recording, undo_steps

    program = Program(request.param)
    gui = ModuleType("FreeCADGui")
    gui.doCommand = lambda line: exec(line, {"App": program})
    for module in (recording, undo_steps):
        monkeypatch.setattr(module, "App", program)
        monkeypatch.setattr(module, "Gui", gui)
    return program


@pytest.fixture
def steps():
    from freecad.elastica_wb import undo_steps

    return undo_steps


@pytest.mark.parametrize("name", ["First", "Second"])
@pytest.mark.parametrize("abort", [False, True])
def test_a_step_is_one_undo_in_the_active_document_and_in_another(app, steps, name, abort):
    document = app.documents[name]
    steps.open_step(document, "Strip")
    assert steps.active_step(document) > 0
    document.change("strip")
    document.change("flat")
    steps.close_step(document, abort=abort)
    document.change("unrelated")
    assert document.undo == ([] if abort else [["strip", "flat"]])
    assert steps.active_steps() == {}


def test_an_unchanged_step_takes_no_later_change(app, steps):
    document = app.ActiveDocument
    steps.open_step(document, "Strip")
    steps.close_step(document)
    document.change("unrelated")
    document.commitTransaction()
    assert document.undo == []


def test_a_failed_command_takes_back_its_own_changes_only(app, steps):
    first, second = app.documents.values()
    second.openTransaction("of the user")
    second.change("line")
    before = steps.active_steps()
    steps.undo_new_steps(before)
    assert second.pending == ["line"]
    steps.open_step(first, "Strip")
    first.change("strip")
    steps.undo_new_steps(before)
    assert first.undo == first.pending == []
    assert [*second.undo, *filter(None, [second.pending])] == [["line"]]
    assert steps.active_step(first) == 0


def test_closing_the_sketch_does_not_split_the_step(app, steps):
    document = app.ActiveDocument

    def close_sketch() -> None:
        if app.Document is OfDocument:  # FreeCAD 1.1 keeps the step during a command
            document.commitTransaction()

    steps.open_step_and(close_sketch, document, "Strip")
    document.change("strip")
    steps.close_step(document)
    assert document.undo == [["strip"]]


def test_a_closed_document_ends_its_step_and_no_other(app, steps):
    first, second = app.documents.values()
    steps.open_step(first, "Strip")
    if app.Document is OfDocument:
        second.openTransaction("of the user")
        second.change("line")
    del app.documents["First"]
    steps.forget_step()
    if app.Document is OfDocument:
        assert second.pending == ["line"]
    else:
        second.change("unrelated")
        assert second.pending == []


STEPS = {
    "Strip": "Strip from sketch",
    "Nearest": "Nearest curve to sketch",
    "Edit": "Edit strip",
    "Rails": "Rails, ties and loads",
    "Perforate": "Perforate",
    "Laminate": "Laminate",
    "Flat": "Flat part",
    "Bend": "Bend forward",
    "Flexure": "Two-state part",
    "Projective": "Projective edit",
    "Fixtures": "End fixtures and base plate",
    "Nest": "Nest on sheets",
    "Coupon": "Coupon and calibrate",
    "Section": "Section into curves",
    "Interlock": "Interlock selected strips",
}
"""Commands with an undo step."""

IN_SKETCH = {
    "given length": "Curve of given length",
    "nearest curve": "Use the nearest curve",
    "keep possible": "Keep it possible",
}
"""Actions in an open sketch with an undo step."""


@pytest.mark.campaign
@pytest.mark.parametrize("owner", ["program", "document"])
def test_commands_make_one_step_each(tmp_path, owner):
    """Cancel and undo restore the document, OK makes one step, and no step stays open."""
    found = launching.run_window("steps.py", tmp_path, ELASTICA_TEST_STEPS=owner)["tried"]
    cancelled = {"Flat": [], "Nest": []}  # no panel
    assert found == {
        f"Elastica_{name}": [cancelled.get(name, [[], 0, {}]), [1, {}, True], step, []]
        for name, step in STEPS.items()
    } | {name: [[], [1, {}, True], step, []] for name, step in IN_SKETCH.items()}


def test_the_modules_name_no_transaction_elsewhere():
    """Every other module leaves transactions to `undo_steps`."""
    from freecad.elastica_wb import undo_steps

    folder = Path(undo_steps.__file__).parent
    texts = {path: path.read_text() for path in folder.rglob("*.py") if path.name != "undo_steps.py"}
    assert [path.name for path, text in texts.items() if "ActiveTransaction" in text] == []
