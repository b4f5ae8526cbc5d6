"""What is easily overlooked: bent blanks, features that are left out, formulas, closed documents, empty fields."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import FreeCAD as App
import FreeCADGui as Gui
import Part
from inside import (
    ARCH,
    OUT,
    Dialog,
    QtCore,
    QtWidgets,
    answers,
    at_rest,
    begun,
    button,
    choose,
    click,
    dialog_button,
    fill,
    has_focus,
    keys,
    open_panel,
    panel,
    picture,
    press,
    press_button,
    run,
    scroll_to,
    shown_message,
    sketch,
    tree_row,
    trigger,
    until,
    wait,
    window,
)


def edited(obj):
    """The panel of a feature, by a double click in the tree; what it says."""
    tree, item = tree_row(obj)
    click(tree.viewport(), times=2, at=tree.visualItemRect(item).center())
    until(lambda: Gui.Control.activeDialog() and panel().form is not None and panel().form.isVisible())
    at_rest()
    return [panel().form.message.text(), panel().form.footnote.text()]


def dismissed():
    """The sentences of the window that tells something, which is closed."""
    until(shown_message)
    text = shown_message()
    click(QtWidgets.QApplication.activeWindow().findChild(QtWidgets.QPushButton))
    until(lambda: not shown_message())
    return text


def bent_blank(document, strip):
    """A strip that is bent beforehand, its flat part, what is exported of it."""
    strip.NaturalCurvature = -0.004
    trigger("Std_Refresh")
    until(lambda: not document.isTouched())
    answers["blank"] = edited(strip)[0]
    picture("blank.png")
    button()
    answers["blank, flat part"] = edited(document.Flat)[1]
    button()
    open_panel("Elastica_Export", strip)
    answers["blank, export"] = panel().form.message.text()
    picture("blank-export.png")
    panel().form.folder.setText(str(OUT / "bent"))
    at_rest()
    press_button("Ok")
    answers["blank, written"] = dismissed()
    answers["blank, cut list"] = (OUT / "bent" / "cut-list.csv").read_text(encoding="utf-8")
    strip.NaturalCurvature = 0.0
    document.recompute()


def left_out(document, strip):
    """A nest of a strip that a box is cut from, and of one that is rounded afterwards."""
    cut, box = document.addObject("Part::Cut", "Notch"), document.addObject("Part::Box", "Box")
    cut.Base, cut.Tool = strip, box
    document.recompute()
    choose(strip)
    press("Elastica_Nest")
    answers["nest told"] = dismissed()
    nest = document.Nest
    later = document.addObject("Part::Chamfer", "Rounded")
    later.Base = document.Flat
    trigger("Std_Refresh")
    until(lambda: "Rounded" in " ".join(nest.LeftOut), 10)
    answers["nest"] = edited(nest)[1]
    picture("nest.png")
    button()
    for one in (later, cut, box):
        document.removeObject(one.Name)
    until(lambda: not nest.LeftOut, 10)
    answers["nest of the strip alone"] = [nest.LeftOut, edited(nest)[1]]
    button()
    document.removeObject(nest.Name)
    strip.Visibility = document.Flat.Visibility = True


def formula(document, strip):
    """A style that a spreadsheet gives, and that there is not."""
    cells = document.addObject("Spreadsheet::Sheet", "Cells")
    cells.set("A1", "4")
    document.recompute()
    strip.setExpression("Style", "Cells.A1")
    trigger("Std_Refresh")
    until(lambda: not document.isTouched() or "Invalid" in strip.State)
    answers["formula"] = edited(strip)[0]
    button("Cancel")
    cells.set("A1", "1")
    trigger("Std_Refresh")
    until(lambda: "Invalid" not in strip.State)
    answers["formula mended"] = [strip.Style, strip.State[-1]]
    strip.setExpression("Style", None)
    strip.Style = "Plain"
    document.recompute()


def emptied(field):
    """Click into a field, take everything out, leave it by Tab."""
    scroll_to(field)
    click(field)
    until(lambda: has_focus(field), 10)
    keys("ctrl+a", "Delete", "Tab")
    until(lambda: not has_focus(field), 10)
    at_rest()


def shear():
    """A sheet of one's own with a shear modulus, then without."""
    from freecad.elastica_wb.host.sheet_store import own_sheets, own_sheets_file
    from inside import typed

    open_panel("Elastica_Sheets")
    fill(panel(), sheets="card-200gsm")
    answers["shear of card"] = panel().form.shear_modulus.text()
    fill(panel(), sheets="birch-plywood-0.8")
    answers["shear of birch"] = panel().value("shear_modulus")
    typed("name", "my birch")
    typed("shear_modulus", "600")
    picture("shear.png")
    button("Save")
    kept = own_sheets()["my birch"]
    answers["shear kept"] = [kept.shear_modulus, "shear_modulus_MPa = 600" in own_sheets_file().read_text()]
    open_panel("Elastica_Sheets")
    fill(panel(), sheets="my birch")
    emptied(panel().form.shear_modulus)
    answers["shear emptied"] = panel().form.shear_modulus.text()
    button("Save")
    kept = own_sheets()["my birch"]
    answers["shear estimated"] = [kept.shear_modulus, "shear" in own_sheets_file().read_text()]


def body_in_hand():
    """A body is selected by a click in the tree, and a strip is asked for: its sketch is meant, if there is one."""
    document = begun("Design")
    body = document.addObject("PartDesign::Body", "Body")
    document.recompute()

    def dialog():
        tree, item = tree_row(body)
        choose()
        click(tree.viewport(), at=tree.visualItemRect(item).center())
        assert until(lambda: Gui.Selection.getSelection() == [body])
        press("Elastica_Strip")

    dialog()
    answers["body without a sketch"] = dismissed()
    drawn = sketch(document, ARCH, name="Drawn")
    profile = document.addObject("Sketcher::SketchObject", "Profile")
    profile.addGeometry(Part.Circle(App.Vector(0, -50, 0), App.Vector(0, 0, 1), 20), False)
    body.addObjects([drawn, profile])
    document.recompute()
    dialog()
    answers["body with two sketches"] = dismissed()
    from freecad.elastica_wb.commands.selection import chosen_curves

    choose(body, drawn)
    answers["body and its sketch"] = [(source.Name, edges) for source, edges in chosen_curves()]
    pad = body.newObject("PartDesign::Pad", "Pad")
    pad.Profile = profile
    document.recompute()
    dialog()
    assert until(lambda: Gui.Control.activeDialog() and panel().form.isVisible())
    button()
    answers["body"] = [document.Strip.Curve[0].Name, document.Strip.Verdict, document.Strip.State]
    App.closeDocument(document.Name)


def left_behind():
    """Strips are pasted into other documents, with their sketch and without."""
    document = begun("Copied")
    open_panel("Elastica_Strip", sketch(document, ARCH, name="Behind"))
    button()

    def copied(everything):
        def chosen(box):
            rows = [tree.topLevelItem(i) for tree in box.findChildren(QtWidgets.QTreeWidget)
                    for i in range(tree.topLevelItemCount())]  # fmt: skip
            for row in [row for row in rows if row.text(0) == "Behind" and not everything]:
                row.setCheckState(0, QtCore.Qt.Unchecked)
            box.accept()

        App.setActiveDocument(document.Name)
        Gui.ActiveDocument = Gui.getDocument(document.Name)
        choose(document.Strip)
        request = Dialog(chosen)
        trigger("Std_Copy")
        assert until(lambda: request.done)
        wait(200)
        other = App.newDocument("Taker")
        other.UndoMode = 1
        trigger("Std_Paste")
        until(lambda: other.Strip.MadeFrom or other.Strip.Reasons)
        strip = other.Strip
        found = [strip.Curve and strip.Curve[0].Name, strip.Verdict, list(strip.Reasons), strip.Visibility]
        other.undo()
        found.append(len(other.Objects))
        App.closeDocument(other.Name)
        return found

    answers["pasted with its sketch"] = copied(everything=True)
    answers["pasted alone"] = copied(everything=False)
    App.closeDocument(document.Name)


def closed(document, strip):
    """The export is left open while its document is closed; another one is open, with a step that is begun."""
    other = App.newDocument("Other")
    other.UndoMode = 1
    App.setActiveDocument(document.Name)
    Gui.ActiveDocument = Gui.getDocument(document.Name)
    open_panel("Elastica_Export", strip)
    form = panel().form
    scroll_to(form.force)
    other.openTransaction("of the other")
    other.addObject("App::FeaturePython", "Kept")
    App.closeDocument(document.Name)
    until(lambda: not Gui.Control.activeDialog(), 5)
    answers["closed with its document"] = not Gui.Control.activeDialog()
    answers["buttons left"] = dialog_button("Ok") is not None
    answers["the other's step"] = bool(other.getObject("Kept"))
    other.commitTransaction()
    App.closeDocument(other.Name)


def deleted():
    """The strip of an export is deleted: OK says so where it is seen."""
    document = begun("Deleted")
    open_panel("Elastica_Strip", sketch(document, ARCH))
    button()
    open_panel("Elastica_Export", document.Strip)
    main = Gui.getMainWindow()
    scroll_to(panel().form.force)
    document.removeObject(document.Flat.Name)
    document.removeObject(document.Strip.Name)
    wait(100)
    press_button("Ok")
    at_rest()
    message = panel().form.message
    answers["deleted"] = [message.text(), message.visibleRegion().isEmpty(), main.isVisible()]
    picture("deleted.png")
    button("Cancel")
    App.closeDocument(document.Name)


def work():
    window()
    document = begun("Untold")
    open_panel("Elastica_Strip", sketch(document, ARCH))
    button()
    strip = document.Strip
    bent_blank(document, strip)
    left_out(document, strip)
    formula(document, strip)
    shear()
    body_in_hand()
    left_behind()
    App.setActiveDocument(document.Name)
    closed(document, strip)
    deleted()


run(work)
