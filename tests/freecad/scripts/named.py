"""A model by its names: strips are called as their sketches, edited together, held by blocks, and written."""

import re
import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import FreeCAD as App
from inside import (
    ARCH,
    OUT,
    answers,
    begun,
    button,
    click,
    fit,
    keys,
    mouse,
    open_panel,
    panel,
    picture,
    press_button,
    run,
    shown_message,
    sketch,
    tree_row,
    typed,
    until,
    window,
)


def named_sketch(document, name, y):
    """An arch that stands on its ends."""
    drawn = sketch(document, ARCH)
    drawn.Label = name
    drawn.Placement = App.Placement(App.Vector(0, y, 0), App.Rotation(App.Vector(1, 0, 0), 90))
    return drawn


def renamed(obj, name):
    """By the key F2 in the tree."""
    tree, item = tree_row(obj)
    click(tree.viewport(), at=tree.visualItemRect(item).center())
    keys("F2")
    mouse("type", "--delay", 30, name)
    keys("Return")
    until(lambda: obj.Label == name)


def labels(document):
    return {obj.Name: obj.Label for obj in document.Objects if obj.Name.startswith(("Strip", "Flat"))}


def tabs(document):
    return [document.getObject(name).StartTab.Value for name in ("Strip", "Strip001")]


def edited(document):
    """Widths and tabs of two strips in one panel: of new ones, cancelled, and kept."""
    strips = [document.Strip, document.Strip001]
    found = [[one.MaxWidth.Value for one in strips]]
    open_panel("Elastica_Edit", *strips)
    typed("StartTab", "17 mm")
    answers["told together"] = panel().form.message.text()
    picture("together.png")
    found.append(tabs(document))
    button("Cancel")
    found.append(tabs(document))
    open_panel("Elastica_Edit", *strips)
    typed("StartTab", "15 mm")
    button()
    found.append(tabs(document))
    return found


def held(document):
    """A plate above all tabs is refused before any block is made; then both are made, and a pole is moved."""
    from freecad.elastica_wb.features import fixtures

    made, make = [], fixtures.make_solid
    fixtures.make_solid = lambda record: made.append(record) or make(record)
    open_panel("Elastica_Fixtures", document.Model)
    panel().form.plate.setChecked(True)
    typed("plateHeight", "500 mm")
    press_button("Ok")
    until(lambda: "below the plate" in panel().form.message.text())
    found = [len(made), panel().form.message.text()]
    typed("plateHeight", "0 mm")
    button()
    found.append(len(made))
    curve = document.Sketch.Geometry[0]
    curve.setPole(3, App.Vector(70, 84, 0))
    document.Sketch.Geometry = [curve, *document.Sketch.Geometry[1:]]
    document.recompute()
    found.append(len(made))
    fixtures.make_solid = make
    return found


def exported(document):
    """Names in the STEP file of the model, the cutting files, and the cut list."""
    from freecad.elastica_wb.host import dialogs

    folder = OUT / "cut"
    folder.mkdir()
    open_panel("Elastica_Export", document.Model, document.BasePlate)
    typed("folder", str(folder))
    press_button("Ok")
    until(shown_message)
    for box in dialogs._open_boxes:
        box.close()
    step = (folder / "Lamp.step").read_text(encoding="utf-8")
    return re.findall(r"PRODUCT\('([^']*)'", step), sorted(file.name for file in folder.iterdir())


def work():
    window()
    document = begun("Named")
    drawn = [named_sketch(document, "Träger", 0), named_sketch(document, "Left rib", 60)]
    open_panel("Elastica_Strip", *drawn)
    typed("MaxWidth", "14 mm")
    button()
    answers["labels"] = labels(document)
    answers["edited"] = edited(document)
    renamed(drawn[1], "Right rib")
    answers["renamed"] = labels(document)
    document.undo()
    answers["undone"] = labels(document)
    document.redo()
    open_panel("Elastica_Interlock", document.Strip, document.Strip001)
    button()
    document.Model.Label = "Lamp"
    answers["held"] = held(document)
    fit("Isometric")
    picture("held.png")
    answers["exported"] = exported(document)


run(work)
