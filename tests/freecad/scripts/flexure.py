"""A part with two states by hand: two sketches, the panel with its force curve, forms, files, a refusal."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import FreeCAD as App
import FreeCADGui as Gui
from inside import (
    OUT,
    answers,
    at_rest,
    button,
    choose,
    fit,
    open_panel,
    panel,
    picture,
    press,
    run,
    scroll_to,
    sketch,
    told,
    trigger,
    typed,
    until,
    wait,
    window,
)

UP = [(15, 75), (57, 75), (87, 102), (126, 102), (162, 102), (201, 75), (240, 75)]
DOWN = [(15, 51), (51, 51), (81, 27), (120, 27), (162, 27), (204, 51), (240, 51)]


def work():
    window()
    document = App.newDocument("Clip")
    document.UndoMode = 1
    Gui.activateWorkbench("ElasticaWorkbench")
    window()
    first = sketch(document, UP, degree=3, name="Up", poles=False)
    second = sketch(document, DOWN, degree=3, name="Down", poles=False)
    small = sketch(document, [(x / 2, y / 2 - 60) for x, y in UP], degree=3, name="Small", poles=False)
    fit("Top")
    choose(first)
    press("Elastica_Flexure")
    until(told)
    answers["one curve"] = told()
    from freecad.elastica_wb.host import dialogs

    for box in dialogs._open_boxes:
        box.close()
    dialogs._open_boxes.clear()

    open_panel("Elastica_Flexure", first, second)
    one = panel()
    part = document.getObject("Flexure")
    until(lambda: part.State == ["Up-to-date"])
    fit("Isometric")
    answers["made"] = [part.State, part.Verdict, list(part.Reasons), part.Bistable, part.Sheet]
    answers["rows"] = one.form.numbers.text()
    answers["chart"] = [one.form.picture.isVisible(), one.form.picture.pixmap().width()]
    answers["force"] = [part.LargestForce, part.SnapTravel.Value]
    answers["solids"] = len(part.Shape.Solids)
    picture("made.png")
    typed("PadWidth", "14 mm")
    until(lambda: part.PadWidth.Value == 14)
    answers["wider pads"] = [part.State, part.PadWidth.Value]
    field = one.form.Form
    scroll_to(field)
    field.setCurrentIndex(field.findData("As cut"))
    until(lambda: len(part.Shape.Solids) == 1)
    answers["as cut"] = [len(part.Shape.Solids), part.Shape.isValid()]
    picture("cut.png")
    field.setCurrentIndex(field.findData("Everything"))
    until(lambda: len(part.Shape.Solids) == 4)
    button()
    answers["closed"] = part.State

    before = part.LargestForce
    second.Placement.Base.y = 5  # the states do not depend on where the second curve is
    document.recompute()
    answers["moved"] = [part.State, before, part.LargestForce]

    open_panel("Elastica_Export", part)
    answers["pieces"] = [piece.name for piece in panel().pieces]
    panel().form.folder.setText(str(OUT / "files"))
    button()
    until(lambda: (OUT / "files").is_dir() and told())
    answers["files"] = sorted(path.name for path in (OUT / "files").iterdir())
    wait(300)
    for box in dialogs._open_boxes:
        box.close()
    dialogs._open_boxes.clear()

    open_panel("Elastica_Flexure", small, second)
    refused = document.getObject("Flexure001")
    at_rest()
    answers["refused"] = [refused.State, refused.Verdict, panel().form.message.text()]
    picture("refused.png")
    button("Cancel")
    answers["cancelled"] = [obj.Name for obj in document.Objects if obj.Name.startswith("Flexure")]
    trigger("Std_Undo")
    until(lambda: second.Placement.Base.y == 0 or document.getObject("Flexure") is None)
    document.saveAs(str(OUT / "clip.FCStd"))
    answers["saved"] = (OUT / "clip.FCStd").exists()


run(work)
