"""A maker at work: three strips, formulas, a deleted sketch, rooms that move, files that exist already."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import FreeCAD as App
import FreeCADGui as Gui
from inside import (
    ARCH,
    OUT,
    Dialog,
    QtWidgets,
    answers,
    at_rest,
    begun,
    button,
    choose,
    fit,
    keys,
    open_panel,
    panel,
    picture,
    press_button,
    report,
    run,
    shown_message,
    sketch,
    suggestions,
    trigger,
    typed,
    until,
    wait,
    window,
)

ACROSS = [(5, -40), (12, 0), (15, 50), (12, 100), (5, 140)]


def boxes():
    """Boxes for quantities that live."""
    every = QtWidgets.QApplication.allWidgets()
    return sum(one.metaObject().className() == "Gui::QuantitySpinBox" for one in every)


def refusals(strip):
    """What the panel says to sizes that make no strip, and whether it offers the nearest curve."""
    Gui.ActiveDocument.setEdit(strip.Name)
    until(lambda: Gui.Control.activeDialog() and panel().form.isVisible())
    found = {}
    for words in ("2 mm", "0 mm", "16 mm"):
        typed("MaxWidth", words)
        until(lambda words=words: strip.MaxWidth.Value == float(words.split()[0]))
        at_rest()
        found[words] = [panel().form.message.text(), suggestions()]
    button()
    return found


def strips():
    """Two at once, then a laminated one: no flat part lies on another, nor under a strip."""
    document = begun("Work")
    drawn = [sketch(document, ARCH, name="Arch"), sketch(document, ACROSS, name="Across")]
    fit("Isometric")
    open_panel("Elastica_Strip", *drawn)
    button()
    first = document.getObject("Strip")
    first.Anyway = True  # two layers of plywood would break
    for _ in range(2):
        open_panel("Elastica_Laminate", first)
        button()
    flats = [obj for obj in document.Objects if obj.Name.startswith("Flat")]
    answers["flat parts"] = [
        [obj.Label, obj.Shape.BoundBox.YMin, obj.Shape.BoundBox.YMax, obj.State[-1]] for obj in flats
    ]
    answers["least y of strips"] = min(obj.Shape.BoundBox.YMin for obj in (first, document.Strip001))
    fit("Isometric")
    picture("at-work.png")
    answers["refused"] = refusals(document.Strip001)
    App.closeDocument(document.Name)


def formula():
    """A formula for a width, after the panel was closed: nothing of the panel hears of it."""
    document = begun("Formula")
    open_panel("Elastica_Strip", sketch(document, ARCH))
    button()
    until(lambda: boxes() == 0)
    answers["boxes left"] = boxes()
    seen = len(report())
    strip = document.getObject("Strip")
    strip.setExpression("MaxWidth", "12 mm + 10 mm")
    document.recompute()
    wait(200)
    answers["formula"] = [strip.MaxWidth.Value, "Traceback" in report()[seen:]]
    App.closeDocument(document.Name)


def deleted():
    """The sketch goes and comes back by undo: the strip too, without a recompute."""
    document = begun("Deleted")
    drawn = sketch(document, ARCH)
    open_panel("Elastica_Strip", drawn)
    button()
    strip = document.getObject("Strip")
    choose(drawn)
    request = Dialog(lambda _: keys("alt+y"))
    trigger("Std_Delete")
    until(lambda: document.getObject("Sketch") is None)
    request.stop()
    until(lambda: "Invalid" in strip.State)
    answers["without its sketch"] = [strip.State, strip.Visibility]
    trigger("Std_Undo")
    until(lambda: "Invalid" not in strip.State)
    answers["with it again"] = [strip.State[-1], strip.Visibility]
    App.closeDocument(document.Name)


def rooms():
    """Holders go with the container of their strips, or follow it from outside."""
    document = begun("Rooms")
    room, other = (document.addObject("App::Part", name) for name in ("Room", "Other"))
    for place, name in ((room, "Here"), (other, "There")):
        drawn = sketch(document, ARCH, name=name)
        place.addObject(drawn)
        document.recompute()
        open_panel("Elastica_Strip", drawn)
        button()
    here, there = document.getObject("Strip"), document.getObject("Strip001")
    open_panel("Elastica_Fixtures", here)
    button()
    open_panel("Elastica_Fixtures", here, there)
    button()
    inside, outside = document.getObject("Fixtures"), document.getObject("Fixtures001")
    room.Placement.Base.z = 50
    other.Placement.Base.z = 300
    document.recompute()
    answers["in the room"] = [inside in room.Group, inside.Shape.BoundBox.Center.z]
    answers["over both rooms"] = [outside.Shape.BoundBox.ZMin, outside.Shape.BoundBox.ZMax]
    seen = len(report())
    other.addObject(outside)  # what a drag in the tree does
    document.recompute()
    bounds = outside.Shape.BoundBox
    answers["dragged into one"] = [bounds.ZMin + 300, bounds.ZMax + 300, "DAG" in report()[seen:]]
    room.removeObject(here)  # its flat part stays, and is made from it
    answers["hangs on"] = sorted({one.Label for one in here.OutList})
    document.recompute()
    heights = [here.Placement.Base.z]
    room.Placement.Base.z = 80
    document.recompute()
    heights.append(here.Placement.Base.z)
    house = document.addObject("App::Part", "House")
    house.Placement.Base.z = 1000
    house.addObject(room)
    document.recompute()
    answers["out of its room"] = [*heights, here.Placement.Base.z, "DAG" in report()[seen:]]
    App.closeDocument(document.Name)


def crossing():
    """Two arches that lie flat on each other: no slots, and the strips stay in sight."""
    document = begun("Crossing")
    upright = App.Rotation(App.Vector(1, 0, 0), 90)
    for name, turned in (("A", App.Rotation()), ("B", App.Rotation(App.Vector(0, 0, 1), 90))):
        drawn = sketch(document, [(-75, 0), (-50, 60), (0, 95), (50, 60), (75, 0)], name=name)
        drawn.Placement = App.Placement(App.Vector(), turned * upright)
        document.recompute()
        open_panel("Elastica_Strip", drawn)
        button()
    pair = [document.getObject("Strip"), document.getObject("Strip001")]
    open_panel("Elastica_Interlock", *pair)
    answers["no slots"] = [panel().form.message.text(), [one.Visibility for one in pair]]
    button("Cancel")
    App.closeDocument(document.Name)


def export():
    """Twice into one folder, then to paths that begin nowhere, or that no disk takes."""
    document = begun("Export")
    open_panel("Elastica_Strip", sketch(document, ARCH))
    button()
    folder = OUT / "cut"
    folder.mkdir()
    folders = {"first": str(folder), "again": str(folder), "nowhere": "cut"}
    folders |= {"to nobody": "~nobody-of-that-name/cut", "too far": f"/tmp/{'far' * 100}"}
    for name, words in folders.items():
        from freecad.elastica_wb.host import dialogs

        dialogs._open_boxes.clear()
        open_panel("Elastica_Export", document.getObject("Strip"))
        typed("folder", words)
        press_button("Ok")
        until(
            lambda: (
                shown_message() or ":" in panel().form.message.text() or "path" in panel().form.message.text()
            ),
            10,
        )
        # the list of files stays below the message
        answers[f"export {name}"] = (shown_message() or panel().form.message.text()).partition("\n")[0]
        for box in dialogs._open_boxes:
            box.close()
        if Gui.Control.activeDialog():
            button("Cancel")
    App.closeDocument(document.Name)


def work():
    window()
    Gui.activateWorkbench("ElasticaWorkbench")
    formula()
    strips()
    deleted()
    rooms()
    crossing()
    export()
    answers["tracebacks"] = report().count("Traceback")


run(work)
