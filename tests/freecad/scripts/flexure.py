"""A part with two states from an empty document to its files: two sketches drawn and picked by the mouse, the panel
with its force curve, forms, files, a refusal."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import FreeCADGui as Gui
from inside import (
    OUT,
    answers,
    at_rest,
    begun,
    button,
    choose,
    click,
    fit,
    looks_from,
    mouse,
    open_panel,
    panel,
    picture,
    press,
    press_button,
    run,
    scroll_to,
    shown_message,
    sketch,
    still,
    tree_row,
    trigger,
    type_into,
    typed,
    until,
    wait,
    window,
)
from sketching import draw, new_sketch

UP = [(-195, 12), (-153, 12), (-123, 39), (-84, 39), (-46, 39), (-9, 12), (30, 12)]
DOWN = [(-195, -12), (-159, -12), (-129, -36), (-90, -36), (-46, -36), (-9, -12), (30, -12)]


def drawn(places):
    """A sketch with one spline, by the mouse."""
    choose()  # a new sketch would lie on what is selected
    new_sketch()
    fit(height=300)
    camera = Gui.ActiveDocument.ActiveView.getCameraNode()
    # the panels of FreeCAD 1.1 are right of all places
    camera.position.setValue(0, 0, camera.position.getValue()[2])
    still(looks_from)
    draw(places)
    made = Gui.ActiveDocument.getInEdit().Object
    press_button("Close")
    until(lambda: Gui.ActiveDocument.getInEdit() is None)
    until(lambda: Gui.activeWorkbench().name() == "ElasticaWorkbench")
    return made


def picked(*sketches):
    """Rows of the tree, clicked one after another with the control key down."""
    for number, one in enumerate(sketches):
        tree, item = tree_row(one)
        mouse("keydown" if number else "keyup", "ctrl")
        click(tree.viewport(), at=tree.visualItemRect(item).center())
    mouse("keyup", "ctrl")
    until(lambda: Gui.Selection.getSelection() == list(sketches))


def work():
    window()
    document = begun("Clip")
    window()
    first, second = drawn(UP), drawn(DOWN)
    fit("Top")
    picture("drawn.png")
    picked(first)
    press("Elastica_Flexure")
    until(shown_message)
    answers["one curve"] = shown_message()
    from freecad.elastica_wb.host import dialogs

    for box in dialogs._open_boxes:
        box.close()
    dialogs._open_boxes.clear()

    picked(first, second)
    press("Elastica_Flexure")
    until(lambda: Gui.Control.activeDialog() and panel().form.isVisible())
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
    lines, tolerance = panel().form.curves, panel().form.tolerance
    for style in ("arc", "bezier", "polyline", "spline"):  # splines are exact
        lines.setCurrentIndex(lines.findData(style))
        until(lambda style=style: tolerance.isEnabled() == (style in ("arc", "polyline")))
    picture("exact.png")
    type_into(panel().form.folder, str(OUT / "files"))
    button()
    until(lambda: (OUT / "files").is_dir() and shown_message())
    answers["files"] = sorted(path.name for path in (OUT / "files").iterdir())
    wait(300)
    for box in dialogs._open_boxes:
        box.close()
    dialogs._open_boxes.clear()

    small = sketch(document, [(x / 2, y / 2 - 90) for x, y in UP], degree=3, name="Small", poles=False)
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
