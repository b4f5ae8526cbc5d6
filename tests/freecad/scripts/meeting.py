"""What is found a moment after a model is made, and what is missing: strips that meet, a link to nothing."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import FreeCADGui as Gui
from inside import (
    ARCH,
    QtCore,
    action_of,
    answers,
    at_rest,
    begun,
    button,
    choose,
    click,
    is_grey,
    open_panel,
    panel,
    picture,
    press,
    report,
    run,
    scroll_to,
    shown_message,
    sketch,
    trigger,
    until,
    window,
)

BAD = [(0, 0), (40, 60), (80, -60), (120, 20), (160, 30), (180, 0)]
ACROSS = [(80, -60), (87, -20), (90, 30), (87, 100), (80, 140)]


def switched(model):
    """The box that cuts the slots is clicked in the model's panel."""
    choose(model)
    Gui.ActiveDocument.setEdit(model.Name)
    until(lambda: Gui.Control.activeDialog() and panel().form.isVisible())
    at_rest()
    box = panel().form.Interlock
    scroll_to(box)
    mark = box.height() // 2  # the box may be wider than what can be clicked
    click(box, at=QtCore.QPoint(mark, mark))


def stepped(command):
    """Undo or redo, once FreeCAD offers it."""
    until(action_of(command).isEnabled)
    trigger(command)


def broken_link(document):
    """A strip is exported with a link to one that was deleted."""
    open_panel("Elastica_Strip", sketch(document, ARCH, name="Other"))
    button()
    gone = document.Strip002
    link = document.addObject("App::Link", "Link")
    link.LinkedObject = gone
    document.recompute()
    document.removeObject(gone.Name)
    document.recompute()
    choose(document.Strip, link)
    press("Elastica_Export")
    until(shown_message)
    answers["broken link"] = [shown_message(), bool(Gui.Control.activeDialog())]
    from freecad.elastica_wb.host import dialogs

    for box in dialogs._open_boxes:
        box.close()
    dialogs._open_boxes.clear()


def loose():
    """Export with nothing selected: a document with three strips, one of which cannot be bent."""
    document = begun("Loose")
    from freecad.elastica_wb import make_strip

    for number, points in enumerate((ARCH, ACROSS, BAD)):
        strip = make_strip(sketch(document, points, degree=min(4, len(points) - 1), name=f"Sketch{number}"))
        strip.Label = ("Near", "Across", "Refused")[number]
    choose()
    answers["grey with loose strips"] = is_grey("Elastica_Export")
    press("Elastica_Export")
    until(Gui.Control.activeDialog)
    answers["one is refused"] = panel().form.message.text().splitlines()
    picture("refused.png")
    button("Cancel")


def work():
    window()
    document = begun("Meeting")
    for name, points in (("Arch", ARCH), ("Across", ACROSS)):
        open_panel("Elastica_Strip", sketch(document, points, name=name))
        button()
    open_panel("Elastica_Interlock", document.Strip, document.Strip001)
    button()
    model = document.Model
    answers["slotted"] = [model.Joints, until(lambda: not model.Overlaps)]
    switched(model)
    answers["found"] = until(lambda: model.Overlaps)
    until(panel().form.footnote.text)
    picture("meeting.png")
    answers["told"] = [list(model.Overlaps), panel().form.footnote.text()]
    answers["reported"] = report().count(model.Overlaps[0])
    button()
    open_panel("Elastica_Export", model)
    answers["before export"] = panel().form.message.text().splitlines()
    button("Cancel")
    stepped("Std_Undo")
    answers["undone"] = [until(lambda: model.Interlock and not model.Overlaps), model.Joints]
    stepped("Std_Redo")
    answers["redone"] = [until(lambda: not model.Interlock and model.Overlaps), model.Joints]
    switched(model)
    answers["slotted again"] = until(lambda: model.Interlock and not model.Overlaps)
    button()
    answers["states"] = [model.State, document.Strip.State]
    broken_link(document)
    loose()


run(work)
