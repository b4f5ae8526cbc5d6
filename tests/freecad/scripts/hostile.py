"""A hostile user before a window: things vanish under open panels, documents change, selections make no sense."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import time

import FreeCAD as App
import FreeCADGui as Gui
import Part
from inside import (
    ARCH,
    OUT,
    WAVE,
    Dialog,
    QtWidgets,
    answers,
    choose,
    report,
    run,
    sketch,
    trigger,
    until,
    wait,
)

PANELS = {
    "Elastica_Strip": "sketch",
    "Elastica_Check": "sketch",
    "Elastica_Nearest": "sketch",
    "Elastica_Projective": "sketch",
    "Elastica_Perforate": "strip",
    "Elastica_Laminate": "strip",
    "Elastica_Interlock": "strips",
    "Elastica_Fixtures": "strip",
    "Elastica_Section": "body",
    "Elastica_Bend": "strip",
    "Elastica_Rails": "strip",
    "Elastica_Tolerance": "strip",
    "Elastica_Coupon": None,
    "Elastica_Export": "strip",
    "Elastica_Sheets": None,
}
answers["trouble"] = []


def box_text():
    from freecad.elastica_wb.host import dialogs as base

    words = [box.text() for box in base._open_boxes]
    for box in base._open_boxes:
        box.close()
    base._open_boxes.clear()
    return words


def watched(name, work):
    """Do something; a traceback anywhere, or more than a second without a bar, is trouble."""
    seen = len(report())
    sys.stderr.write(f"-- {name}\n")
    began = time.process_time()
    try:
        work()
    except BaseException as error:
        import traceback

        answers["trouble"].append(f"{name}: {error!r} {traceback.format_exc()[-900:]}")
    wait(80)
    took = time.process_time() - began
    text = report()[seen:]
    if "Traceback" in text or "Error:" in text:
        answers["trouble"].append(f"{name}: {text[-1500:]}")
    if Gui.Control.activeDialog():
        Gui.Control.closeDialog()
        answers["trouble"].append(f"{name}: a dialog stays open")
        wait(50)
    if App.getActiveTransaction():
        answers["trouble"].append(f"{name}: {App.getActiveTransaction()} stays open")
        App.closeActiveTransaction(True)
    answers.setdefault("times", {})[name] = round(took, 2)
    box_text()


def scene(name="Doc"):
    document = App.newDocument(name)
    document.UndoMode = 1
    from freecad.elastica_wb.features import flat, strip

    first, second = sketch(document, ARCH), sketch(document, WAVE, name="Wave")
    second.Placement.Base = App.Vector(0, 0, 60)
    bent = strip.create(document, first)
    flat.create(document, bent)
    other = strip.create(document, second)
    other.Anyway = True  # the wave bends plywood beyond what it bears
    box = document.addObject("Part::Sphere", "Body")
    document.recompute()
    wait(50)
    return {
        "document": document,
        "sketch": [first],
        "strip": [bent],
        "strips": [bent, other],
        "body": [box],
        None: [],
    }


def opened(command, parts):
    from freecad.elastica_wb.panels.panel import Panel

    choose(*parts[PANELS[command]])
    Panel.opened = None
    trigger(command)
    until(lambda: Panel.opened is not None)
    assert Panel.opened is not None, f"{command} opened no panel: {box_text()}"
    return Panel.opened


def poke(panel):
    """Touch every widget of a panel, as if a child played with it."""
    for box in panel.form.findChildren(QtWidgets.QAbstractSpinBox):
        if box.isVisible():
            box.stepUp()
    for box in panel.form.findChildren(QtWidgets.QCheckBox):
        box.setChecked(not box.isChecked())
    wait(90)


def finish(panel, document):
    """Type into the panel once more, press OK, or Cancel where OK refuses, and close."""
    poke(panel)
    if not panel.accept():
        panel.reject()
    wait(50)
    App.closeDocument(document.Name)


def vanish(command):
    """Everything that the panel works on is deleted while it is open."""
    parts = scene()
    document = parts["document"]
    panel = opened(command, parts)
    for obj in list(document.Objects):
        if obj.Name in [o.Name for o in document.Objects]:
            document.removeObject(obj.Name)
    wait(100)
    finish(panel, document)


def undone(command):
    parts = scene()
    document = parts["document"]
    panel = opened(command, parts)
    poke(panel)
    for _ in range(3):
        document.undo()
        wait(60)
    document.redo()
    wait(60)
    finish(panel, document)


def closed(command):
    parts = scene()
    panel = opened(command, parts)
    poke(panel)
    App.closeDocument(parts["document"].Name)
    wait(150)
    if Gui.Control.activeDialog():
        panel.reject()
    wait(50)


def elsewhere(command):
    """Another document comes to the front while the panel is open."""
    parts = scene()
    panel = opened(command, parts)
    other = App.newDocument("Other")
    App.setActiveDocument(other.Name)
    Gui.ActiveDocument = Gui.getDocument(other.Name)
    wait(60)
    poke(panel)
    if not panel.accept():
        panel.reject()
    wait(50)
    assert not other.Objects, f"{command} works in the wrong document: {[o.Name for o in other.Objects]}"
    App.closeDocument(other.Name)
    App.closeDocument(parts["document"].Name)


def nonsense(command):
    """Selections that mean nothing to a command."""
    from freecad.elastica_wb.panels.panel import Panel

    document = App.newDocument("Nonsense")
    box = document.addObject("Part::Box", "Box")
    things = [document.addObject(kind, "Thing") for kind in (
        "App::DocumentObjectGroup", "Spreadsheet::Sheet", "App::Part", "App::FeaturePython", "Mesh::Feature",
        "Sketcher::SketchObject", "PartDesign::Body",
    )]  # fmt: skip
    link = document.addObject("App::Link", "Link")
    link.LinkedObject = box
    loose = document.addObject("App::Link", "Loose")
    document.recompute()
    for choice in ([], [box], [link], [loose], things, things[4:5], things[5:6], [box, *things, link]):
        choose(*choice)
        Panel.opened = None
        trigger(command, usable=False)
        wait(20)
        if Panel.opened is not None and Gui.Control.activeDialog() and not Panel.opened.accept():
            Panel.opened.reject()
        box_text()
    Gui.Selection.clearSelection()
    Gui.Selection.addSelection(box, "Face1")
    Gui.Selection.addSelection(box, "Vertex1")
    Panel.opened = None
    trigger(command, usable=False)
    wait(60)
    if Panel.opened is not None and Gui.Control.activeDialog():
        Panel.opened.reject()
    App.closeDocument(document.Name)


def edits():
    """The sketch is deleted, undone, its document closed, while it is being edited."""
    from freecad.elastica_wb.live import session as live
    from freecad.elastica_wb.solving.verdicts import Verdict

    parts = scene()
    document, (drawn,) = parts["document"], parts["sketch"]
    Gui.ActiveDocument.setEdit(drawn.Name)
    assert until(lambda: live.session() is not None)
    for _ in range(4):
        document.undo()
        wait(80)
    for _ in range(4):
        document.redo()
        wait(80)
    Gui.ActiveDocument.resetEdit()
    assert until(lambda: live.session() is None)
    Gui.ActiveDocument.setEdit(drawn.Name)
    until(lambda: live.session() is not None)
    while drawn.Geometry:
        drawn.delGeometry(0)
        wait(60)
    until(lambda: live.session().card.answer.verdict is Verdict.NOTHING)
    answers["empty in edit"] = live.session().sentence
    drawn.addGeometry(Part.Circle(App.Vector(), App.Vector(0, 0, 1), 20), False)
    until(lambda: live.session().card.answer.verdict is Verdict.BREAKS)
    answers["circle in edit"] = live.session().card.heading.text()
    App.closeDocument(document.Name)
    assert until(lambda: live.session() is None)
    parts = scene()
    Gui.ActiveDocument.setEdit(parts["sketch"][0].Name)
    until(lambda: live.session() is not None)
    Gui.ActiveDocument.resetEdit()
    parts["document"].removeObject(parts["sketch"][0].Name)
    parts["document"].recompute()
    until(lambda: "missing" in parts["strip"][0].getStatusString())
    answers["sketch gone"] = parts["strip"][0].getStatusString()
    App.closeDocument(parts["document"].Name)


def second_view():
    """The view in which a panel shows its handles is closed, the document's other one stays."""
    parts = scene()
    for command in ("Elastica_Bend", "Elastica_Projective", "Elastica_Section", "Elastica_Check"):
        area = Gui.getMainWindow().findChild(QtWidgets.QMdiArea)
        windows = len(area.subWindowList())
        trigger("Std_ViewCreate")
        until(lambda area=area, windows=windows: len(area.subWindowList()) > windows)
        wait(200)
        panel = opened(command, parts)
        window = area.activeSubWindow() or area.currentSubWindow()
        window.close()
        until(lambda area=area, windows=windows: len(area.subWindowList()) == windows)
        wait(200)
        poke(panel)
        panel.reject()
        wait(50)
    assert App.listDocuments(), "the document is still there"


def copies():
    """Copy and paste, within and into another document."""
    parts = scene()
    document = parts["document"]
    choose(*parts["strips"])

    request = Dialog(lambda box: box.accept())  # whether what the strips hang on is copied with them
    trigger("Std_Copy")
    wait(600)
    request.stop()
    trigger("Std_Paste")
    wait(300)
    other = App.newDocument("Pasted")
    trigger("Std_Paste")
    wait(300)
    for place in (document, other):
        place.recompute()
        from freecad.elastica_wb.host.objects import is_strip

        answers[f"pasted into {place.Name}"] = [
            (obj.State, obj.Shape.isValid()) for obj in place.Objects if is_strip(obj)
        ]
    App.closeDocument(other.Name)
    App.closeDocument(document.Name)


def draft():
    import Draft
    from freecad.elastica_wb.features import strip

    document = App.newDocument("Draft")
    points = [App.Vector(0, 0, 0), App.Vector(50, 30, 0), App.Vector(100, 0, 0)]
    sources = (
        Draft.make_bspline(points),
        Draft.make_bezcurve(points),
        Draft.make_circle(50, startangle=0, endangle=90),
        Draft.make_line(points[0], points[2]),
        Draft.make_wire(points),
        Draft.make_polygon(5, 50),
        Draft.make_point(1, 2, 3),
        Draft.make_bspline([*points, App.Vector(150, 40, 40)]),
    )
    made = [strip.create(document, source) for source in sources]
    document.recompute()
    answers["draft"] = [obj.getStatusString() if "Invalid" in obj.State else "" for obj in made]
    App.closeDocument(document.Name)


def preferences():
    """Preferences change beside an open panel."""
    from freecad.elastica_wb.host import preferences as kept

    parts = scene()
    panel = opened("Elastica_Export", parts)
    kept.put("Kerf", 0.3)
    App.Units.setSchema(3)
    kept.put("DefaultSheet", "no such sheet")
    poke(panel)
    panel.reject()
    panel = opened("Elastica_Export", parts)
    answers["kerf of a new panel"] = panel.value("kerf")
    panel.reject()
    panel = opened("Elastica_Nearest", parts)
    answers["sheet of a new panel"] = panel.value("Sheet")
    panel.reject()
    App.Units.setSchema(0)
    kept.put("DefaultSheet", "birch-plywood-0.8")
    App.closeDocument(parts["document"].Name)


def work():
    Gui.activateWorkbench("ElasticaWorkbench")
    from freecad.elastica_wb.host import preferences as kept

    kept.put("ExportFolder", str(OUT))  # else the export asks for a folder, in a window that waits
    hook = sys.excepthook

    def note(kind, error, trace):
        import traceback

        answers["trouble"].append("".join(traceback.format_exception(kind, error, trace))[-1200:])
        hook(kind, error, trace)

    sys.excepthook = note
    for command in PANELS:
        for way in (vanish, undone, closed, elsewhere, nonsense):
            watched(f"{way.__name__} {command}", lambda way=way, command=command: way(command))
    # 0.20 itself crashes at the next document after a second view was closed: that comes last
    for way in (edits, copies, draft, preferences, second_view):
        watched(way.__name__, way)


run(work)
