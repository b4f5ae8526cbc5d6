"""Files that are gone, folders that cannot be written, and edges that are picked where a link shows them."""

import sys
from itertools import pairwise
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import FreeCAD as App
import FreeCADGui as Gui
import Part
from inside import (
    ARCH,
    OUT,
    Dialog,
    QtWidgets,
    answers,
    begun,
    button,
    choose,
    click,
    click_view,
    fit,
    open_panel,
    panel,
    press,
    report,
    run,
    scroll_to,
    shown_message,
    sketch,
    still,
    trigger,
    until,
    window,
)

V = App.Vector


def state(document):
    """Which of the features are in sight, and what the strip says."""
    seen = {name: document.getObject(name).Visibility for name in ("Strip", "Flat", "Nest", "Fixtures")}
    return seen, document.Strip.Reasons, round(document.Strip.Shape.Volume, 3)


def refreshed(document):
    """Recompute by the button; what it says in the report view."""
    text = len(report())
    trigger("Std_Refresh")
    still(report)
    return [line.split("Elastica, ")[1] for line in report()[text:].splitlines() if "Elastica, " in line]


def everything_on(document, curve, *others):
    """A strip on a curve and what hangs on it."""
    open_panel("Elastica_Strip", curve)
    button()
    choose(document.Strip, *others)
    press("Elastica_Nest")
    until(lambda: document.getObject("Nest"))
    open_panel("Elastica_Fixtures", document.Strip)
    button()


def panel_of(name):
    Gui.ActiveDocument.setEdit(name)
    until(lambda: Gui.Control.activeDialog() and panel().form.isVisible())
    words = panel().form.message.text()
    button("Cancel")
    return words


def lost_file():
    """A spline that FreeCAD reads from a file anew: the file is moved away, and comes back."""
    file = OUT / "spline.brep"
    curve = Part.BSplineCurve()
    curve.interpolate([V(0, 0, 0), V(50, 30, 0), V(100, 35, 0), V(150, 0, 0)])
    curve.toShape().exportBrep(str(file))
    document = begun("File")
    imported = document.addObject("Part::ImportBrep", "Imported")
    imported.FileName = str(file)
    document.recompute()
    everything_on(document, imported)
    answers["file there"] = state(document)
    away = file.rename(OUT / "away.brep")
    imported.touch()
    answers["file lost, told"] = refreshed(document)
    answers["told again"] = refreshed(document)
    answers["file lost"] = state(document)
    answers["panels"] = [panel_of("Nest"), panel_of("Strip")]
    choose(document.Strip)
    press("Elastica_Export")
    until(shown_message)
    answers["export"] = shown_message()
    click(QtWidgets.QApplication.activeWindow().findChild(QtWidgets.QPushButton))
    away.rename(file)
    answers["file found, told"] = refreshed(document)
    answers["file found"] = state(document)
    App.closeDocument(document.Name)


def lost_numbers():
    """A spreadsheet with the largest width is deleted, and the delete undone by the button."""
    document = begun("Numbers")
    everything_on(document, sketch(document, ARCH, poles=False))
    cells = document.addObject("Spreadsheet::Sheet", "Cells")
    cells.set("A1", "=14 mm")
    cells.setAlias("A1", "breadth")
    document.recompute()
    document.Strip.setExpression("MaxWidth", "Cells.breadth")
    refreshed(document)
    answers["numbers there"] = state(document)
    document.openTransaction("Delete")
    document.removeObject(cells.Name)
    document.commitTransaction()
    answers["numbers lost, told"] = refreshed(document)
    answers["numbers lost"] = state(document)
    answers["panel of the formula"] = panel_of("Strip")
    choose(document.Strip)
    press("Elastica_Export")
    until(shown_message)
    answers["export of the formula"] = shown_message()
    click(QtWidgets.QApplication.activeWindow().findChild(QtWidgets.QPushButton))
    trigger("Std_Undo")
    until(lambda: all(state(document)[0].values()), 10)
    answers["numbers found"] = state(document)
    App.closeDocument(document.Name)


def lost_document():
    """A sketch and a strip of another document, which is not where it was when this one is opened."""
    source = begun("Source")
    drawn = sketch(source, ARCH, poles=False)
    open_panel("Elastica_Strip", drawn)
    button()
    file, other = OUT / "source.FCStd", OUT / "links.FCStd"
    source.saveAs(str(file))
    document = begun("Links")
    document.saveAs(str(other))
    links = [document.addObject("App::Link", name) for name in ("Curve", "Shown")]
    for link, linked in zip(links, (drawn, source.Strip), strict=True):
        link.LinkedObject = linked
    document.recompute()
    everything_on(document, links[0], links[1])
    answers["document there"] = state(document)
    document.save()
    for one in (document, source):
        App.closeDocument(one.Name)
    away = file.rename(OUT / "away.FCStd")
    document = App.openDocument(str(other))
    answers["document lost, told"] = refreshed(document)
    answers["document lost"] = state(document)
    document.save()
    App.closeDocument(document.Name)
    away.rename(file)
    document = App.openDocument(str(other))
    refreshed(document)
    answers["document found"] = state(document)
    for name in list(App.listDocuments()):
        App.closeDocument(name)


def picked_through_a_link():
    """Edges of a body and of links to it and to what holds it, by a mouse in the view."""
    document = begun("Picked")
    body = document.addObject("PartDesign::Body", "Body")
    profile = body.newObject("Sketcher::SketchObject", "Profile")
    arc = Part.ArcOfCircle(Part.Circle(V(50, 40, 0), V(0, 0, 1), 50), 0, 3.141592653589793)
    corners = [V(0, 40, 0), V(0, 0, 0), V(100, 0, 0), V(100, 40, 0)]
    lines = [Part.LineSegment(*ends) for ends in pairwise(corners)]
    profile.addGeometry([*lines, arc])
    pad = body.newObject("PartDesign::Pad", "Pad")
    pad.Profile, pad.Length = profile, 20
    part = document.addObject("App::Part", "Part")
    part.addObject(body)
    places = {"Body": V(), "Linked body": V(-200, 0, 0), "Linked part": V(0, 300, 50)}
    for name, shown in (("Linked body", body), ("Linked part", part)):
        link = document.addObject("App::Link", "Link")
        link.Label, link.LinkedObject, link.Placement.Base = name, shown, places[name]
    document.recompute()
    profile.Visibility = False
    for name, place in places.items():
        fit("Top")
        Gui.Selection.clearSelection()
        click_view((50 + place.x, 91 + place.y, 20 + place.z))  # beside it, where no face is picked instead
        until(Gui.Selection.getSelectionEx, 5)
        press("Elastica_Strip")
        until(lambda: Gui.Control.activeDialog() and panel().form.isVisible())
        button()
        strip, flat = document.Objects[-2:]
        box = Part.getShape(strip).BoundBox  # its place in the document
        answers[name] = [strip.State[-1], box.Center.x - place.x, box.YMax - place.y, box.Center.z - place.z]
        for one in (strip, flat):
            one.Visibility = False
    pad.Length = 30
    document.recompute()
    answers["all follow"] = [obj.Shape.BoundBox.Center.z for obj in document.Objects if hasattr(obj, "Curve")]
    App.closeDocument(document.Name)


def unwritable():
    """The coupon's cutting file into a folder where nobody can write."""
    document = begun("Coupon")
    open_panel("Elastica_Coupon")

    def into(path):
        def named(box):
            box.findChild(QtWidgets.QLineEdit).setText(path)
            box.accept()

        request = Dialog(named)
        scroll_to(panel().form.write)
        click(panel().form.write)
        until(lambda: request.done, 10)
        still(panel().form.message.text)
        request.stop()
        return panel().form.message.text()

    answers["coupon refused"] = into("/proc/coupon.dxf")
    answers["coupon"] = into(str(OUT / "Prüf #1.dxf"))
    button("Cancel")
    App.closeDocument(document.Name)


def work():
    window()
    for one in (lost_file, lost_numbers, lost_document, picked_through_a_link, unwritable):
        text = len(report())
        one()
        answers["tracebacks"] = answers.get("tracebacks", 0) + report()[text:].count("Traceback")


run(work)
