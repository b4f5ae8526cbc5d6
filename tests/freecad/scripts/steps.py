"""Commands and actions in a sketch that make an undo step: Cancel, OK, undo.

ELASTICA_TEST_STEPS=document: steps as in FreeCAD 1.2.
"""

import os
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import FreeCAD as App
import FreeCADGui as Gui
import Part
from inside import (
    ARCH,
    answers,
    at_rest,
    begun,
    choose,
    drag,
    fill,
    fit,
    live_at_rest,
    panel,
    press_on_card,
    run,
    sketch,
    trigger,
    until,
    wait,
    window,
)

BAD = [(0, 0), (40, 60), (80, -55), (120, 10), (160, 30), (180, 0)]
TURNED = [(x, -y) for x, y in ARCH]


class Documents:
    """App for `undo_steps` as in FreeCAD 1.2: a step belongs to a document, and ends with its open sketch."""

    class Document:
        """Stands in for the type of documents."""

        @staticmethod
        def getBookedTransactionID(document):
            step = (App.getActiveTransaction() or ("", 0))[1]
            return step if document.HasPendingTransaction or begun_steps.get(document.Name) == step else 0

    listDocuments = staticmethod(App.listDocuments)


begun_steps = {}


def of_documents():
    """Let the steps of the workbench belong to documents."""
    from freecad.elastica_wb import undo_steps
    from freecad.elastica_wb.commands import actions

    record_call, close_sketch = undo_steps.record_call, actions._close_sketch

    def call(document, method, *arguments):
        record_call(document, method, *arguments)
        if method == "openTransaction":
            begun_steps[document.Name] = App.getActiveTransaction()[1]
        else:  # it also ends the step of an unchanged document
            App.closeActiveTransaction(method == "abortTransaction")

    def close():
        if actions.edited_sketch() is not None:
            close_sketch()
            App.closeActiveTransaction(False)

    undo_steps.App, undo_steps.record_call, actions._close_sketch = Documents, call, close


def state(document):
    """What an undo has to bring back."""
    names = ("Style", "MaxWidth", "OuterWidth", "Between", "Visibility")
    return {
        one.Name: [str(getattr(one, name, "")) for name in names]
        + [f"{edge.Length:.6g}" for edge in one.Shape.Edges]
        for one in document.Objects
        if hasattr(one, "Shape")
    }


def changes(document, before):
    """Objects that came, went or changed."""
    now = state(document)
    return sorted(name for name in {*now, *before} if now.get(name) != before.get(name))


def opened(command, chosen, edited):
    """Run a command on objects, or within an open sketch."""
    if edited is not None:
        Gui.ActiveDocument.setEdit(edited.Name)
        until(lambda: Gui.ActiveDocument.getInEdit() is not None)
    choose(*chosen)
    trigger(command)
    if command not in AT_ONCE:
        assert until(lambda: Gui.Control.activeDialog() and panel().form is not None), command
        at_rest()


AT_ONCE = ("Elastica_Flat", "Elastica_Nest")
"""Commands without a panel."""


def tried(command, *chosen, edited=None, **values):
    """Cancel, OK and undo of a command: steps, what is left of the objects, and what is written under the step."""
    from freecad.elastica_wb.undo_steps import active_steps

    document = App.ActiveDocument
    document.recompute()
    before, steps = state(document), document.UndoCount
    left = []
    if command not in AT_ONCE:
        opened(command, chosen, edited)
        change(**values)
        panel().reject()
        until(lambda: not Gui.Control.activeDialog())
        left = [changes(document, before), document.UndoCount - steps, active_steps()]
    opened(command, chosen, edited)
    if command not in AT_ONCE:
        change(**values)
        assert panel().accept(), panel().form.message.text()
    until(lambda: not Gui.Control.activeDialog() and not document.Recomputing)
    made = [document.UndoCount - steps, active_steps(), changes(document, before) != []]
    name = document.UndoNames[0]
    document.undo()
    document.recompute()
    until(lambda: state(document) == before)
    answers.setdefault("tried", {})[command] = [left, made, name, changes(document, before)]
    document.redo()
    document.recompute()


def tried_in(drawn, name, act):
    """An action in an open sketch, and its undo; answers as of a command without a panel."""
    from freecad.elastica_wb.live import between_clamps, observers
    from freecad.elastica_wb.live import session as live
    from freecad.elastica_wb.undo_steps import active_steps

    document = drawn.Document
    Gui.ActiveDocument.setEdit(drawn.Name)
    until(lambda: Gui.ActiveDocument.getInEdit() is not None)
    observers.switch(drawn, on=True)
    fit("Top")
    until(lambda: live.session() is not None)
    live_at_rest()
    before, steps = geometry(drawn), document.UndoCount
    act()
    until(lambda: geometry(drawn) != before and document.UndoCount != steps)
    live_at_rest()
    made = [document.UndoCount - steps, active_steps(), geometry(drawn) != before]
    step = document.UndoNames[0]
    trigger("Std_Undo")
    until(lambda: geometry(drawn) == before)
    live_at_rest()
    answers["tried"][name] = [[], made, step, [] if geometry(drawn) == before else [drawn.Name]]
    between_clamps.stop()
    Gui.ActiveDocument.resetEdit()
    until(lambda: live.session() is None)


def geometry(drawn):
    """The curves of a sketch."""
    return [
        [str(one), *map(str, one.getPoles() if hasattr(one, "getPoles") else [])] for one in drawn.Geometry
    ]


def lengthen():
    """Draw the curve of another length with the tool that keeps the ends of the curve."""
    from freecad.elastica_wb.live import between_clamps

    trigger("Elastica_Between")
    until(lambda: between_clamps.running() is not None)
    between_clamps.running()._lengthen(1.2 * between_clamps.running().length)


def use_nearest():
    """Press the button of the card when the nearest curve is found."""
    from freecad.elastica_wb.live import session as live

    until(lambda: live.session().near is not None)
    press_on_card("button")


def drag_too_far(drawn):
    """Keep the curve possible, and drag a pole where no strip can take it."""
    fit(height=320)
    press_on_card("keep")
    until(lambda: drawn.ElasticaKeep)
    drag(tuple(drawn.Geometry[0].getPole(3)), 8, (0, 25))
    wait(300)


def change(**values):
    """Type into the panel, or do what its buttons do."""
    if make := values.pop("press", None):
        make(panel())
    fill(panel(), **values)
    at_rest()


def halfway(drawn):
    """A point of the drawn curve, x and y."""
    edge = drawn.Shape.Edges[0]
    return tuple(edge.valueAt((edge.FirstParameter + edge.LastParameter) / 2))[:2]


def work():
    window()
    if os.environ["ELASTICA_TEST_STEPS"] == "document":
        of_documents()
    document = begun("Steps")
    document.UndoMode = 1
    drawn, bad, turned = (
        sketch(document, points, name=name, poles=False)
        for points, name in ((ARCH, "Drawn"), (BAD, "Bad"), (TURNED, "Turned"))
    )
    tried("Elastica_Strip", edited=drawn, MaxWidth=25.0)
    strip = document.getObject("Strip")
    tried("Elastica_Nearest", edited=bad)
    tried("Elastica_Edit", strip, MaxWidth=22.0)
    tried("Elastica_Rails", strip, press=lambda one: one.clicked(halfway(drawn)))
    strip.Between = []
    tried("Elastica_Perforate", strip, OuterWidth=28.0)
    strip.Style = "Plain"
    strip.Anyway = True
    tried("Elastica_Laminate", strip)
    strip.Style = "Plain"
    for part in [one for one in document.Objects if "Flat" in one.Name or "Backing" in one.Name]:
        document.removeObject(part.Name)
    tried("Elastica_Flat", strip)
    tried("Elastica_Bend", strip, EndX=-15.0)
    tried("Elastica_Flexure", drawn, turned)
    tried("Elastica_Projective", turned, x3=170.0)
    tried("Elastica_Fixtures", strip)
    tried("Elastica_Nest", strip)
    tried("Elastica_Coupon", sheet="card-200gsm", press=lambda one: one.make())
    barrel = document.addObject("Part::Feature", "Barrel")
    barrel.Shape = Part.makeSphere(40)
    tried("Elastica_Section", barrel)
    tried_in(turned, "given length", lengthen)
    tried_in(bad, "nearest curve", use_nearest)
    kept = sketch(begun("Kept"), ARCH)  # strips would be in front of the poles
    tried_in(kept, "keep possible", lambda: drag_too_far(kept))
    other = begun("Model")
    strips = []
    from freecad.elastica_wb.features import strip as strips_of

    for points in (
        [(-75, 0), (-50, 60), (0, 95), (50, 60), (75, 0)],
        [(5, -40), (12, 0), (15, 50), (12, 100), (5, 140)],
    ):
        strips.append(strips_of.create(other, sketch(other, points, poles=False)))
        strips[-1].MaxWidth = 16
    tried("Elastica_Interlock", *strips)


run(work)
