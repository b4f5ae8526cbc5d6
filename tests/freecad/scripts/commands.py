"""A pole dragged in a sketch, then every command once; panels are accepted and cancelled, each is one undo step."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import gc
import subprocess
import time
import weakref

import FreeCAD as App
import FreeCADGui as Gui
import Part
from inside import (
    ARCH,
    OUT,
    WAVE,
    QtCore,
    QtWidgets,
    action_of,
    answers,
    at_rest,
    button,
    choose,
    click,
    drag,
    fill,
    fit,
    live_at_rest,
    looked,
    mouse,
    on_screen,
    panel,
    picture,
    run,
    scene,
    sketch,
    trigger,
    until,
    window,
)


def open_panel(command):
    from freecad.elastica_wb.panels.panel import Panel

    Panel.opened = None
    trigger(command)
    assert until(lambda: Panel.opened is not None), f"{command} opened no panel"
    assert until(Gui.Control.activeDialog), f"{command} shows no dialog"
    at_rest()
    return Panel.opened


def names(document):
    return sorted(obj.Name for obj in document.Objects)


def strip_command(document, drawn):
    choose(drawn)
    before = names(document)
    panel = open_panel("Elastica_Strip")
    picture("strip-panel.png")
    panel.reject()
    assert until(lambda: names(document) == before), "Cancel left something"
    choose(drawn)
    usual, drawn.Label = drawn.Label, "<b>arch</b> &lt; <img src=x>"
    panel = open_panel("Elastica_Strip")
    formats = {label.text(): str(label.textFormat()) for label in panel.form.findChildren(QtWidgets.QLabel)}
    answers["label with tags"] = {text: kind for text, kind in formats.items() if drawn.Label in text}
    from freecad.elastica_wb.panels.property_panel import table_of

    from elastica_cad.report_rows import Row

    answers["row with tags"] = table_of([Row("<i>row</i>", "<b>text</b>")])
    answers["formats"] = sorted(set(formats.values()))
    drawn.Label = usual
    fill(panel, MaxWidth=25.0)
    panel.form.EngravedText.setText("A1")
    panel.form.EngravedText.textEdited.emit("A1")
    at_rest()
    answers["strip panel"] = panel.form.numbers.text()
    panel.accept()
    until(lambda: document.getObject("Flat") is not None)
    strip, flat = document.getObject("Strip"), document.getObject("Flat")
    assert (strip.MaxWidth.Value, strip.EngravedText) == (25.0, "A1")
    assert strip.Shape.isValid()
    assert flat.Shape.isValid()
    assert document.UndoNames[0] == "Strip from sketch", document.UndoNames
    document.undo()
    assert names(document) == before, names(document)
    document.redo()
    until(lambda: document.getObject("Strip") is not None)
    document.recompute()
    strip = document.getObject("Strip")
    Gui.ActiveDocument.setEdit(strip.Name)
    until(Gui.Control.activeDialog)
    from freecad.elastica_wb.panels.panel import Panel

    fill(Panel.opened, MaxWidth=40.0)
    at_rest()
    assert strip.MaxWidth.Value == 40.0
    Panel.opened.reject()
    assert until(lambda: strip.MaxWidth.Value == 25.0), "Cancel restores"
    return strip


def check_command(drawn):
    choose(drawn)
    from freecad.elastica_wb.live import session as live

    panel = open_panel("Elastica_Check")
    until(lambda: live.session() is not None)
    live_at_rest()
    answers["check"] = panel.form.message.text()
    answers["check overlay"] = live.session().overlay.shown()
    scene("check.png")
    panel.reject()
    assert until(lambda: live.session() is None)


def nearest_command(document, bad):
    """A feature that follows the sketch; buttons of its panel draw the curve into the sketch instead."""
    from freecad.elastica_wb.curves.sketch_curves import drawn_curve, sketch_curve

    from elastica_cad import check_equilibrium

    choose(bad)
    count = len(document.Objects)
    panel = open_panel("Elastica_Nearest")
    answers["nearest"] = panel.form.message.text()
    panel.reject()
    assert len(document.Objects) == count
    poles = bad.Geometry[0].NbPoles
    choose(bad)
    panel = open_panel("Elastica_Nearest")
    click(panel.form.findChild(QtWidgets.QPushButton, "draw_into"))
    until(lambda: not Gui.Control.activeDialog())
    assert not Gui.Control.activeDialog()
    assert len(document.Objects) == count
    answers["replaced"] = (poles, check_equilibrium(sketch_curve(bad)).realizable)
    document.undo()
    assert until(lambda: bad.Geometry[0].NbPoles == poles)
    assert not check_equilibrium(sketch_curve(bad)).realizable
    choose(bad)
    panel = open_panel("Elastica_Nearest")
    panel.accept()
    until(lambda: document.getObject("Nearest").State == ["Up-to-date"])
    found = document.getObject("Nearest")
    assert found.State == ["Up-to-date"], found.getStatusString()
    assert len(document.Objects) == count + 1
    answers["nearest is realizable"] = check_equilibrium(drawn_curve((found, ())).curve).realizable
    length = found.Shape.Length
    document.openTransaction("Draw")
    curve = bad.Geometry[0]
    curve.setPole(3, App.Vector(85, -40, 0))
    bad.delGeometry(0)
    bad.addGeometry(curve, False)
    document.commitTransaction()
    document.recompute()
    changed = found.Shape.Length
    document.undo()
    until(lambda: abs(found.Shape.Length - length) < 1e-6)
    answers["nearest after undo"] = (length, changed, found.Shape.Length)


def bend_command(document, strip):
    choose(strip)
    panel = open_panel("Elastica_Bend")
    fill(panel, EndX=-15.0)
    at_rest()
    answers["bend"] = panel.form.message.text()
    view = Gui.ActiveDocument.ActiveView
    fit("Top")
    chosen = len(Gui.Selection.getSelection())
    places = drag(
        panel.rod.position[-1],
        12,
        (-4, -3),
        "bend.png",
        lambda: (tuple(panel.rod.position[-1]), panel.value("EndX"), panel.value("EndY")),
    )
    answers["bend drag"] = places
    until(lambda: not panel.preview.handles.is_held)
    answers["bend handles"] = (panel.preview.handles.is_held, len(Gui.Selection.getSelection()) - chosen)
    # most styles of navigation turn the view by the same button
    view.setNavigationType("Gui::GestureNavigationStyle")
    turned = view.getCameraOrientation().Q
    drag(panel.rest.position[0], 5, (-4, 0), grab=lambda: panel.value("StartX"))
    until(lambda: not panel.preview.handles.is_held)
    answers["view stays"] = turned == view.getCameraOrientation().Q
    view.setNavigationType("Gui::CADNavigationStyle")
    answers["start dragged"] = (panel.value("StartX"), tuple(panel.rod.position[0]))
    fill(panel, StartX=0.0)
    fill(panel, StartY=0.0)
    fill(panel, EndX=-30.0)
    fill(panel, EndY=5.0)
    at_rest()
    panel.play()
    panel.accept()
    until(lambda: document.getObject("Bent").Shape.Edges)
    bent = document.getObject("Bent")
    end = bent.Shape.Edges[0].valueAt(bent.Shape.Edges[0].LastParameter)
    answers["bent end"] = tuple(end)
    document.undo()
    assert document.getObject("Bent") is None
    choose(strip)
    panel = open_panel("Elastica_Bend")
    fill(panel, StartAngle=-75.0)
    fill(panel, EndAngle=75.0)
    fill(panel, StartAngle=-150.0)
    fill(panel, EndAngle=150.0)
    at_rest()
    answers["bend snaps"] = panel.form.message.text()
    panel.reject()
    options = strip.Sheet, strip.MaxWidth
    strip.Sheet, strip.MaxWidth = "pom-1", 5.0
    document.recompute()
    choose(strip)
    panel = open_panel("Elastica_Bend")
    for x in (-60.0, -120.0, -170.0, -200.0):
        fill(panel, EndX=x)
        at_rest()
    answers["bend sideways"] = panel.form.message.text()
    panel.reject()
    strip.Sheet, strip.MaxWidth = options
    document.recompute()


def projective_command(document):
    """Four handles, pulled by a real mouse; the sketch's spline becomes rational."""
    from freecad.elastica_wb.curves.sketch_curves import sketch_curve

    from elastica_cad import check_equilibrium

    wave = sketch(document, WAVE, name="Wave")
    wave.Placement = App.Placement(App.Vector(0, 0, 20), App.Rotation(App.Vector(1, 0, 0), 60))
    document.recompute()
    for obj in document.Objects:
        obj.Visibility = obj is wave
    fit("Isometric")
    before = names(document)
    choose(wave)
    panel = open_panel("Elastica_Projective")
    fill(panel, x3=200.0)
    at_rest()
    answers["typed handle"] = panel.form.message.text()
    panel.reject()
    assert not wave.Geometry[0].isRational(), "Cancel restores"
    choose(wave)
    panel = open_panel("Elastica_Projective")
    # 1.1 lays its panels over the view: what is at the left stays free
    corner = wave.Placement.multVec(App.Vector(*panel.corners[3], 0))
    seen = drag(corner, 10, (-4, -3), "projective.png", lambda: panel.curve.length)
    answers["projective drag"] = (panel.drawn.length, seen)
    answers["projective verdict"] = panel.form.message.text()
    at_rest()
    answers["projective strip"] = panel.form.message.text()
    pulled = panel.curve
    assert panel.accept()
    until(wave.Geometry[0].isRational)
    kept = sketch_curve(wave)
    answers["projective"] = (
        wave.Geometry[0].isRational(),
        check_equilibrium(kept).realizable,
        abs(kept.length / pulled.length - 1),
        wave.solve(),
    )
    assert names(document) == before
    document.undo()
    assert until(lambda: not wave.Geometry[0].isRational()), "one undo step"
    document.removeObject(wave.Name)
    for obj in document.Objects:
        obj.Visibility = True


def tolerance_command(strip):
    choose(strip)
    panel = open_panel("Elastica_Tolerance")
    fill(panel, samples=4)
    began = time.perf_counter()
    panel.run()
    answers["tolerance seconds"] = time.perf_counter() - began
    answers["tolerance"] = panel.form.table.text()
    assert not panel.form.plot.pixmap().isNull()
    picture("tolerance.png")
    panel.reject()


def coupon_command(document):
    panel = open_panel("Elastica_Coupon")
    fill(panel, sheet="card-200gsm")
    panel.make()
    panel.form.readings.setText("100 = 13.5, 120 = 26")
    panel.form.readings.textEdited.emit("")
    panel.form.name.setText("my-card")
    at_rest()
    answers["coupon"] = panel.form.message.text()
    panel.keep()
    panel.accept()
    until(lambda: document.getObject("Coupon") is not None)
    assert document.getObject("Coupon").Shape.isValid()
    from freecad.elastica_wb.host.sheet_store import sheet_called, sheet_list

    assert sheet_list()[0] == "my-card"
    answers["own sheet"] = sheet_called("my-card").youngs_modulus


def export_command(strip):
    choose(strip)
    panel = open_panel("Elastica_Export")
    answers["kerf not compensated"] = panel.form.message.text()
    panel.form.folder.setText(str(OUT / "files"))
    panel.form.dxf.setChecked(bool(answers["ezdxf"]))
    assert panel.accept()
    answers["files"] = sorted(p.name for p in (OUT / "files").iterdir())
    choose(strip)
    panel = open_panel("Elastica_Export")
    panel.form.folder.setText(str(OUT / "bare"))
    panel.form.marks.setChecked(False)
    fill(panel, kerf=0.2)
    panel.now()
    answers["kerf compensated"] = panel.form.message.text()
    assert panel.accept()
    answers["marked"] = [
        b"MARK" in next((OUT / name).glob("*.svg")).read_bytes() for name in ("files", "bare")
    ]
    choose(strip)
    panel = open_panel("Elastica_Export")
    panel.form.folder.setText(str(OUT / "files"))
    panel.form.dxf.setChecked(False)
    assert not panel.accept(), "files that exist are not overwritten unasked"
    answers["export refused"] = panel.form.message.text()
    panel.reject()
    step = next((OUT / "files").glob("*.step"))
    shape = Part.Shape()
    shape.read(str(step))
    answers["step volumes"] = sorted(solid.Volume for solid in shape.Solids)
    answers["volumes"] = sorted([strip.Shape.Volume, strip.Document.getObject("Flat").Shape.Volume])


def sheets_command():
    panel = open_panel("Elastica_Sheets")
    fill(panel, sheets="birch-plywood-1")
    panel.form.name.setText("my-ply")
    fill(panel, thickness=0.93)
    panel.reject()
    from freecad.elastica_wb.host.sheet_store import own_sheets

    assert "my-ply" not in own_sheets(), "Cancel keeps nothing"
    panel = open_panel("Elastica_Sheets")
    fill(panel, sheets="birch-plywood-1")
    panel.form.name.setText("my-ply")
    fill(panel, thickness=0.93)
    picture("sheets.png")
    panel.accept()
    assert own_sheets()["my-ply"].thickness == 0.93


def section_command(document):
    barrel = document.addObject("Part::Feature", "Barrel")
    face = Part.BSplineSurface()
    rows = [
        [App.Vector(x, y, 40 - x * x / 90 - y * y / 160) for y in (-60, -30, 0, 30, 60)]
        for x in (-50, -25, 0, 25, 50)
    ]
    face.interpolate(rows)
    barrel.Shape = face.toShape()
    document.recompute()
    choose(barrel)
    panel = open_panel("Elastica_Section")
    fill(panel, Family="about an axis")
    at_rest()
    answers["about an axis"] = (panel.form.message.text(), panel.form.Sweep.isVisible())
    fill(panel, Family="parallel")
    fill(panel, Count=3)
    at_rest()
    answers["curves shown"] = (panel.form.numbers.text(), len(panel.object.Shape.Edges))
    fit("Isometric")
    picture("section-panel.png")
    panel.accept()
    cuts = document.getObject("Section")
    until(lambda: len(cuts.Shape.Edges) == 3)
    Gui.Selection.clearSelection()
    for name in ("Edge1", "Edge2", "Edge3"):
        Gui.Selection.addSelection(cuts, name)
    panel = open_panel("Elastica_Strip")
    panel.accept()
    until(lambda: not Gui.Control.activeDialog())
    answers["strips of sections"] = [
        (o.State, o.Shape.isValid())
        for o in document.Objects
        if o.Name.startswith("Strip") and o.Name != "Strip"
    ]
    fit("Isometric")
    scene("sections.png")
    mesh_sections_command(document)


def mesh_sections_command(document):
    """A mesh with a sketch as the path; sections that make no curve are told, Cancel leaves nothing."""
    import Mesh

    ball = document.addObject("Mesh::Feature", "Ball")
    ball.Mesh = Mesh.createSphere(40.0, 60)
    path = sketch(document, [(-30, 0), (-10, 5), (0, 6), (10, 5), (30, 0)], name="Path")
    choose(ball, path)
    before = names(document)
    panel = open_panel("Elastica_Section")
    assert panel.value("Family") == "along a path"
    answers["closed sections"] = panel.form.message.text()
    panel.reject()
    assert names(document) == before
    choose(ball, path)
    panel = open_panel("Elastica_Section")
    fill(panel, Closed="left and right")
    at_rest()
    picture("mesh-section-panel.png")
    click(panel.form.findChild(QtWidgets.QPushButton, "section_sketches_of"))
    until(lambda: not Gui.Control.activeDialog())
    answers["halves"] = len(names(document)) - len(before)
    document.undo()
    assert names(document) == before


def style_commands(document, strip):
    choose(strip)
    panel = open_panel("Elastica_Perforate")
    fill(panel, OuterWidth=28.0)
    at_rest()
    assert strip.Style == "Perforated"
    answers["perforated"] = (strip.State, len(document.getObject("Flat").Shape.Faces))
    scene("perforated.png")
    panel.reject()
    assert until(lambda: strip.Style == "Plain")
    choose(strip)
    count = len(document.Objects)
    panel = open_panel("Elastica_Laminate")
    strip.Anyway = True  # two layers of plywood would break
    at_rest()
    panel.accept()
    until(lambda: strip.State == ["Up-to-date"])
    answers["laminated"] = (strip.State, len(strip.Shape.Solids), len(document.Objects) - count)
    document.undo()
    assert until(lambda: strip.Style == "Plain")
    document.recompute()
    assert len(document.Objects) == count


def long_work():
    """A strip with thousands of holes takes seconds: a bar shows, and Escape leaves a sentence."""
    from freecad.elastica_wb.features import strip

    document = App.newDocument("Long")
    made = strip.create(document, sketch(document, ARCH))
    document.recompute()
    volume = made.Shape.Volume
    made.Style, made.Columns, made.Rows = "Perforated", 8, 88
    seen, pressed = [], []

    def look(message):
        seen.append(message)
        if not pressed and "Escape" in seen[-1]:
            pressed.append(subprocess.Popen(["xdotool", "key", "Escape"]))

    bar = Gui.getMainWindow().statusBar()
    bar.messageChanged.connect(look)  # no timer runs within a recompute
    document.recompute()
    bar.messageChanged.disconnect(look)
    for key in pressed:
        key.wait()
    answers["bar"] = sorted(set(filter(None, seen)))
    answers["cancelled"] = made.getStatusString()
    assert made.Shape.Volume == volume, "the last good shape is kept"
    App.closeDocument(document.Name)


def model_commands():
    from freecad.elastica_wb.features import strip

    document = App.newDocument("Model")
    document.UndoMode = 1
    view = Gui.ActiveDocument.ActiveView
    strips = []
    for name, points in (
        ("A", [(-75, 0), (-50, 60), (0, 95), (50, 60), (75, 0)]),
        ("B", [(5, -40), (12, 0), (15, 50), (12, 100), (5, 140)]),
    ):
        made = strip.create(document, sketch(document, points, name=f"Sketch{name}"))
        made.MaxWidth = 16
        made.EngravedText = name
        strips.append(made)
    document.recompute()
    choose(*strips)
    panel = open_panel("Elastica_Interlock")
    answers["joints"] = panel.form.numbers.text()
    fill(panel, Clearance=0.3)
    at_rest()
    panel.accept()
    model = document.getObject("Model")
    assert model.Clearance.Value == 0.3
    assert until(lambda: not strips[0].Visibility)
    choose(model)
    panel = open_panel("Elastica_Fixtures")
    panel.form.plate.setChecked(True)
    assert not panel.accept(), "no tab of this model goes through a plate"
    answers["no plate"] = panel.form.message.text()
    panel.form.plate.setChecked(False)
    assert panel.accept()
    until(lambda: document.getObject("Fixtures").State == ["Up-to-date"])
    answers["fixtures"] = len(document.getObject("Fixtures").Shape.childShapes())
    view.viewIsometric()
    view.fitAll()
    scene("model.png")
    choose(model)
    trigger("Elastica_Nest")
    until(lambda: document.getObject("Nest").State == ["Up-to-date"])
    answers["nest"] = (document.getObject("Nest").State, document.getObject("Nest").Sheets)
    view.fitAll()
    picture("model-window.png")
    document.undo()
    assert document.getObject("Nest") is None
    assert document.getObject("Fixtures") is not None
    document.undo()
    assert document.getObject("Fixtures") is None
    document.undo()
    assert document.getObject("Model") is None
    assert until(lambda: strips[0].Visibility), "undo shows the single strips again"
    App.closeDocument(document.Name)


def smoothed_body(feature):
    """How far smoothing moved the curve; kinds of the faces; and the volume, as a fraction of the core's."""
    from freecad.elastica_wb.features import strip

    core, shape = strip.strip_of(feature), feature.Shape
    kinds = [type(face.Surface).__name__ for face in shape.Faces]
    return feature.Deviation.Value, kinds, shape.Volume / (core.area * core.sheet.thickness)


def dragging():
    """A pole of a spline is dragged by the mouse in the open sketch; the overlay follows."""
    from freecad.elastica_wb.features import strip
    from freecad.elastica_wb.live import session as live

    document = App.newDocument("Drag")
    document.UndoMode = 1
    drawn = sketch(document, [(1.5 * x, 1.5 * y) for x, y in WAVE], degree=3)  # as the sketcher draws
    feature = strip.create(document, drawn)
    feature.Sheet = "card-200gsm"
    document.recompute()
    answers["smoothed"] = [smoothed_body(feature)]
    Gui.ActiveDocument.setEdit(drawn.Name)
    until(lambda: live.session() is not None)
    fit("Top")
    session = live.session()
    until(lambda: session.overlay.shown()["width"])
    answers["overlay at start"] = session.overlay.shown()
    answers["usable"] = session._dragged.usable
    answers["sentence"] = session.sentence
    picture("edit.png")
    frames, moves = len(session.times), session.moves
    ratio, pole = feature.Ratio, tuple(drawn.Geometry[0].getPole(3))
    x, y = on_screen(*pole[:2])
    mouse("mousemove", x - 2, y + 2, "sleep", 0.1, "mousemove", x, y, "sleep", 0.15, "mousedown", 1)
    for i in range(1, 16):
        seen = len(session.times)
        mouse("mousemove", x + 2 * i, y - 4 * i)
        until(lambda seen=seen: len(session.times) > seen, 2)
    answers["updates while dragging"] = len(session.times) - frames
    answers["moves while dragging"] = session.moves - moves
    answers["times"] = session.times[frames:]
    answers["document pole while dragging"] = tuple(drawn.Geometry[0].getPole(3))
    answers["start pole"] = pole
    picture("dragging.png")
    mouse("mouseup", 1)
    until(lambda: tuple(drawn.Geometry[0].getPole(3)) != pole and feature.Ratio != ratio)
    until(lambda: session.overlay.shown()["width"])
    answers["pole"] = tuple(drawn.Geometry[0].getPole(3))
    answers["state"] = feature.State
    answers["smoothed"].append(smoothed_body(feature))
    answers["ratio"] = (ratio, feature.Ratio)
    answers["sentence after"] = session.sentence
    answers["overlay after"] = session.overlay.shown()
    scene("overlay.png")
    dragged = feature.Ratio
    document.undo()
    until(lambda: feature.Ratio == ratio)
    answers["pole after undo"] = tuple(drawn.Geometry[0].getPole(3))
    answers["ratio after undo"] = feature.Ratio
    document.redo()
    until(lambda: feature.Ratio == dragged)
    answers["ratio after redo"] = feature.Ratio
    began = time.perf_counter()
    session.refresh()
    answers["refresh"] = time.perf_counter() - began
    Gui.ActiveDocument.resetEdit()
    until(lambda: live.session() is None)
    left = [weakref.ref(one) for one in (session, session.card)]
    session = None
    deferred = QtCore.QEvent.DeferredDelete  # what a nested loop of events leaves for the outer one
    QtCore.QCoreApplication.sendPostedEvents(None, int(getattr(deferred, "value", deferred)))
    gc.collect()
    answers["closed"] = live.session() is None and not any(one() for one in left)
    # a curve that cannot be bent: the nearest one is shown beside it
    bad = sketch(document, [(0, 0), (40, 60), (80, -60), (120, 25), (160, 30), (180, 0)], name="Bad")
    strip.create(document, bad).Sheet = "card-200gsm"
    document.recompute()
    Gui.ActiveDocument.setEdit(bad.Name)
    until(lambda: live.session() is not None)
    fit("Top")
    until(lambda: live.session().overlay.shown()["nearest"], 120)
    answers["overlay of a bad curve"] = live.session().overlay.shown()
    answers["sentence of a bad curve"] = live.session().sentence
    picture("bad.png")
    for command in ("Elastica_Nearest", "Elastica_Strip"):
        if live.session() is None:
            Gui.ActiveDocument.setEdit(bad.Name)
        until(lambda: live.session() is not None)
        trigger(command)
        until(lambda: Gui.Control.activeDialog() and panel() is not None and panel().form.isVisible())
        answers.setdefault("steps from the open sketch", []).append(document.UndoNames[0])
        button("Cancel")
        answers.setdefault("left by Cancel", []).append(len(document.Objects))
    App.closeDocument(document.Name)


def work():
    from importlib.util import find_spec

    window()
    for other in ("PartWorkbench", "SketcherWorkbench", "PartDesignWorkbench", "DraftWorkbench"):
        Gui.activateWorkbench(other)  # their commands have shortcuts from now on
    Gui.activateWorkbench("ElasticaWorkbench")
    from freecad.elastica_wb import commands

    answers["workbench"] = Gui.activeWorkbench().name()
    answers["shortcuts"] = {
        name: pressed for name in Gui.Command.listAll() if (pressed := Gui.Command.get(name).getShortcut())
    }
    answers["known"] = [name for name in commands.MENU if name in Gui.listCommands()]
    answers["ezdxf"] = find_spec("ezdxf") is not None
    dragging()
    document = App.newDocument("Work")
    document.UndoMode = 1
    drawn = sketch(document, ARCH)
    strip = strip_command(document, drawn)
    fit("Isometric")
    picture("strip.png")
    check_command(drawn)
    bad = sketch(document, [(0, 0), (40, 60), (80, -55), (120, 10), (160, 30), (180, 0)], name="Bad")
    nearest_command(document, bad)
    style_commands(document, strip)
    bend_command(document, strip)
    projective_command(document)
    tolerance_command(strip)
    coupon_command(document)
    export_command(strip)
    sheets_command()
    section_command(document)
    model_commands()
    long_work()
    App.setActiveDocument(document.Name)
    document.saveAs(str(OUT / "work.FCStd"))
    # nothing selected: the button is grey
    Gui.Selection.clearSelection()
    looked()
    answers["usable with nothing"] = action_of("Elastica_Check").isEnabled()
    answers["wave"] = WAVE[0]


run(work)
