"""Helpers for scripts that run inside a FreeCAD with a window: waiting, pictures, a mouse, an answer in a file."""

import json
import os
import subprocess
import sys
import time
import traceback
from contextlib import suppress
from pathlib import Path

import FreeCAD as App
import FreeCADGui as Gui
from drawn_splines import spline
from PySide import QtCore

try:
    from PySide import QtWidgets
except ImportError:  # FreeCAD 0.20
    from PySide2 import QtWidgets

ARCH = [(0, 0), (30, 60), (70, 80), (120, 60), (150, 0)]
WAVE = [(0, 0), (25, 55), (60, 45), (95, -50), (130, -40), (150, 0)]
OUT = Path(os.environ["ELASTICA_TEST_OUT"])
PACE = float(os.environ.get("ELASTICA_TEST_PACE", "1"))
"""Waits are as many times as long: 0.1 is as on a slow machine, 4 as on a fast one; tests pass with both."""
PATIENCE_S = 60.0
"""For what must come: long enough for a machine that does ten other things."""
LOOKS_MS = 150
"""Interval of the timer by which FreeCAD's main window puts off its look at which commands can be used."""
NOT_YET = (AttributeError, IndexError, RuntimeError, StopIteration)
"""What looking for something that is not there yet raises."""
answers = {}


def wait(ms):
    """Let the window live; what is read afterwards must not hang on how long that was."""
    _live(ms * PACE)


def until(condition, seconds=PATIENCE_S):
    """Let the window live until something is true; False where it never came, which the test then tells."""
    end = time.monotonic() + seconds
    while True:
        with suppress(*NOT_YET):
            if condition():
                return True
        if time.monotonic() > end:
            return False
        _live(20)


def still(look, quiet=0.3, seconds=20.0):
    """Let the window live until what `look` gives has been the same for a while."""
    end = time.monotonic() + seconds
    seen, since = look(), time.monotonic()
    while time.monotonic() < min(end, since + quiet):
        _live(30)
        now = look()
        if now != seen:
            seen, since = now, time.monotonic()
    return seen


def _live(ms):
    loop = QtCore.QEventLoop()
    QtCore.QTimer.singleShot(round(ms), loop.quit)
    loop.exec_() if hasattr(loop, "exec_") else loop.exec()
    QtWidgets.QApplication.processEvents()  # what came in while the last of it was done


def sketch(document, points, degree=4, name="Sketch", poles=True):
    made = document.addObject("Sketcher::SketchObject", name)
    number = made.addGeometry(spline(points, degree), False)
    if poles:
        made.exposeInternalGeometry(number)
    document.recompute()
    return made


def picture(name):
    """The whole screen as a file."""
    wait(300)
    subprocess.run(["import", "-window", "root", str(OUT / name)], check=True, timeout=120)


def scene(name, size=(900, 620)):
    """The 3D view as a file."""
    wait(200)
    Gui.ActiveDocument.ActiveView.saveImage(str(OUT / name), *size, "White")


def choose(*things):
    Gui.Selection.clearSelection()
    for thing in things:
        Gui.Selection.addSelection(thing)


def looks_from():
    """Camera and window of the 3D view: what places on the screen hang on."""
    view = Gui.ActiveDocument.ActiveView
    return view.getCamera(), view.getSize(), Gui.getMainWindow().geometry().getRect()


def fit(direction="", height=0.0):
    """Look at everything, or at so many mm of height, from a direction; FreeCAD 1.x takes its time to turn."""
    view = Gui.ActiveDocument.ActiveView
    if direction:
        getattr(view, f"view{direction}")()
        still(looks_from)
    if height:
        view.setCameraType("Orthographic")
        view.getCameraNode().height.setValue(height)
    else:
        view.fitAll()
    still(looks_from)


def viewport():
    """The widget in which the 3D view is drawn."""
    area = Gui.getMainWindow().findChild(QtWidgets.QMdiArea)
    return (area.activeSubWindow() or area.currentSubWindow()).widget()


def on_screen(x, y, z=0):
    """Screen pixel of a point in space."""
    view = Gui.ActiveDocument.ActiveView
    px, py = view.getPointOnScreen(App.Vector(x, y, z))
    width, height = view.getSize()
    canvas = max(
        (w for w in viewport().findChildren(QtWidgets.QWidget) if w.isVisible()),
        key=lambda w: (min(w.width(), width) * min(w.height(), height), -w.width()),
    )
    corner = canvas.mapToGlobal(QtCore.QPoint(0, 0))
    ratio = height / canvas.height()
    return corner.x() + round(px / ratio), corner.y() + round((height - py) / ratio)


def mouse(*words):
    """xdotool, while the window lives."""
    process = subprocess.Popen(["xdotool", *map(str, words)])
    while process.poll() is None:
        _live(5)
    _live(100)


def click(widget, button=1, times=1, at=None):
    """A real mouse clicks in the middle of a widget, or at a place of it, once it has found its place."""
    until(widget.isVisible, 10)
    still(lambda: widget.mapToGlobal(widget.rect().center()).toTuple(), 0.15)
    place = widget.mapToGlobal(at if at is not None else widget.rect().center())
    notice = QtWidgets.QApplication.widgetAt(place)
    if notice is not None and notice.objectName() == "NotificationBox_label":  # of FreeCAD 1.1, until a click
        mouse("mousemove", place.x(), place.y(), "click", 1)
        until(lambda: QtWidgets.QApplication.widgetAt(place) is not notice)
    mouse("mousemove", place.x() - 2, place.y() - 1, "sleep", 0.05, "mousemove", place.x(), place.y())
    mouse("click", "--repeat", times, "--delay", 80, button)


def click_view(place, button=1):
    """A real mouse clicks on a point in space."""
    still(looks_from)  # a panel that opens makes the view narrower
    x, y = on_screen(*place)
    mouse("mousemove", x - 2, y - 1, "sleep", 0.2, "mousemove", x, y, "sleep", 0.2, "click", button)


def tree_row(obj):
    """The tree and the row of an object in it, in sight."""
    main = Gui.getMainWindow()
    for dock in main.findChildren(QtWidgets.QDockWidget):
        if any(
            t.metaObject().className() == "Gui::TreeWidget" for t in dock.findChildren(QtWidgets.QTreeWidget)
        ):
            dock.show()
            until(dock.isVisible, 5)
    for bar in main.findChildren(QtWidgets.QTabBar):
        for i in range(bar.count() if bar.isVisible() else 0):
            if bar.tabText(i) == "Model":
                click(bar, at=bar.tabRect(i).center())

    def found():
        for tree in (tree for tree in main.findChildren(QtWidgets.QTreeWidget) if tree.isVisible()):
            tree.expandAll()
            for item in tree.findItems(obj.Label, QtCore.Qt.MatchExactly | QtCore.Qt.MatchRecursive, 0):
                return tree, item
        return None

    assert until(found), f"{obj.Label} is in no tree"  # it is filled by a timer
    tree, item = found()
    tree.scrollToItem(item)
    still(lambda: tree.visualItemRect(item).getRect(), 0.15)
    return tree, item


def drag_in_tree(obj, onto):
    """A real mouse drags the row of an object in the tree onto the row of another."""
    tree, target = tree_row(onto)
    item = tree_row(obj)[1]
    tree.collapseItem(target)  # so that both rows are in sight
    tree.scrollToTop()
    centre = lambda row: tree.viewport().mapToGlobal(tree.visualItemRect(row).center()).toTuple()  # noqa: E731
    (x, y), (to_x, to_y) = still(lambda: centre(item), 0.15), centre(target)
    # one command, because Qt does not return before the drop
    steps = [
        ("mousemove", x + (to_x - x) * i // 8, y + (to_y - y) * i // 8, "sleep", 0.1) for i in range(1, 9)
    ]
    moves = [word for step in steps for word in step]
    mouse("mousemove", x, y, "sleep", 0.1, "mousedown", 1, "sleep", 0.1, *moves, "sleep", 0.2, "mouseup", 1)


def keys(*names):
    """A real keyboard."""
    mouse("key", "--delay", 40, *names)


def report():
    """What stands in the report view."""
    view = Gui.getMainWindow().findChild(QtWidgets.QTextEdit, "Report view")
    return view.toPlainText() if view is not None else ""


def type_into(widget, words):
    """Click into a field, replace what is there, leave it by Tab; FreeCAD finds nothing wrong with that."""
    before = len(report())
    # a panel that grows moves the field away from the mouse; a person then clicks again
    for _ in range(4):
        scroll_to(widget)
        click(widget)
        if until(lambda: has_focus(widget), 4):
            break
    else:
        raise AssertionError(f"no click reached the field for {words!r}")
    keys("ctrl+a")
    mouse("type", "--delay", 15, "--", words)
    keys("Tab")
    until(lambda: not has_focus(widget), 10)
    wait(250)
    text = report()[before:]
    # to what we say FreeCAD adds lines of its own; FreeCAD 1.1 prints the state of failed objects itself
    failed = [one.getStatusString() for one in App.ActiveDocument.Objects if "Invalid" in one.State]
    assert not text or any(words in text for words in ["Elastica", *failed]), text


def has_focus(widget):
    """Do the keys go to this widget?"""
    focused = QtWidgets.QApplication.focusWidget()
    return focused is not None and (focused is widget or widget.isAncestorOf(focused))


def toolbar_button(command):
    """The visible button of a command, or None."""
    for bar in Gui.getMainWindow().findChildren(QtWidgets.QToolBar):
        for action in bar.actions() if bar.isVisible() else []:
            button = bar.widgetForAction(action)
            if action.objectName() == command and button is not None and button.isVisible():
                return button
    return None


def looked():
    """Let FreeCAD look at which commands can be used, where it put that off."""
    timers = [one for one in Gui.getMainWindow().children() if isinstance(one, QtCore.QTimer)]
    until(lambda: not any(one.isActive() for one in timers if one.interval() == LOOKS_MS))


def is_grey(command):
    """Can the command not be used now?"""
    until(lambda: toolbar_button(command) is not None)
    looked()
    button = toolbar_button(command)
    assert button is not None, f"no button for {command}"
    return not button.isEnabled()


def press(command):
    """The toolbar button of a command, by a real mouse."""
    until(lambda: not is_grey(command))
    assert not is_grey(command), f"{command} is grey"
    click(toolbar_button(command))
    wait(200)


def action_of(command):
    """The QAction behind the buttons and menu entries of a command."""
    return Gui.Command.get(command).getAction()[0]


def trigger(command, *, usable=True):
    """A command by its QAction, as its button and its menu entry do; nothing happens where it is grey."""
    looked()
    action = action_of(command)
    if usable:
        until(action.isEnabled)
    enabled = action.isEnabled()
    if enabled:
        action.trigger()
    return enabled


class Dialog:
    """Does something with the next dialog that stands before everything else, which holds up who opened it."""

    def __init__(self, work):
        self.work, self.done = work, False
        self.timer = QtCore.QTimer()
        self.timer.timeout.connect(self.look)
        self.timer.start(100)

    def look(self):
        for box in QtWidgets.QApplication.topLevelWidgets():
            if isinstance(box, QtWidgets.QDialog) and box.isModal() and box.isVisible() and not self.done:
                self.done = True
                self.stop()
                self.work(box)

    def stop(self):
        self.timer.stop()


def fill(panel, **values):
    """What a user types into fields of a panel, with everything that follows from it."""
    from freecad.elastica_wb.host.fields import send_change, set_value

    for name, value in values.items():
        widget = getattr(panel.form, name)
        set_value(widget, value)
        argument = {QtWidgets.QComboBox: 0, QtWidgets.QLineEdit: "", QtWidgets.QCheckBox: True}
        send = next((v for k, v in argument.items() if isinstance(widget, k)), value)
        send_change(widget, send)


def scroll_to(widget):
    """Bring a field of the panel into sight, as a person does."""
    for area in Gui.getMainWindow().findChildren(QtWidgets.QScrollArea):
        if area.isAncestorOf(widget):
            area.ensureWidgetVisible(widget)
    still(lambda: widget.mapToGlobal(widget.rect().topLeft()).toTuple(), 0.15)


def dialog_button(kind="Ok"):
    """A button of the open task panel."""
    for box in Gui.getMainWindow().findChildren(QtWidgets.QDialogButtonBox):
        button = box.button(getattr(QtWidgets.QDialogButtonBox, kind))
        if box.isVisible() and button is not None and button.isVisible():
            return button
    return None


def press_button(kind="Ok"):
    """Press a button of the open task panel by a real mouse, where need be from behind the tab of the model."""
    if not until(lambda: dialog_button(kind) is not None, 10):
        picture(f"no-{kind}-button.png")
        for bar in Gui.getMainWindow().findChildren(QtWidgets.QTabBar):
            for i in range(bar.count() if bar.isVisible() else 0):
                if bar.tabText(i) == "Tasks":
                    click(bar, at=bar.tabRect(i).center())
        until(lambda: dialog_button(kind) is not None)
    button = dialog_button(kind) or _button_that_says(kind)
    assert button is not None, (
        f"no button {kind}: {[(_said(one), one.isVisible()) for one in _all_buttons()]}"
    )
    scroll_to(button)
    click(button)


def _button_that_says(kind):
    """A button in sight by its word, as a person finds it.

    PySide2 hands one out in a hundred as the plain widget that lay at its address before; its box does not know it.
    """
    return next(
        (one for one in _all_buttons() if one.isVisible() and _said(one).lower() == kind.lower()), None
    )


def _all_buttons():
    return [
        one
        for one in Gui.getMainWindow().findChildren(QtWidgets.QWidget)
        if one.metaObject().className() == "QPushButton"
    ]


def _said(button):
    return str(button.property("text")).replace("&", "")


def panel():
    """The open panel of the workbench."""
    from freecad.elastica_wb.panels.panel import Panel

    return Panel.opened


def begun(name):
    """A new document that keeps its steps, with our workbench."""
    document = App.newDocument(name)
    document.UndoMode = 1
    Gui.activateWorkbench("ElasticaWorkbench")
    return document


def open_panel(command, *things):
    """The panel of a command, by its button."""
    choose(*things)
    press(command)
    until(lambda: Gui.Control.activeDialog() and panel().form.isVisible())
    at_rest()


def button(kind="Ok"):
    """Press it when nothing is put off any more, though the panel was scrolled down."""
    at_rest()
    press_button(kind)
    until(lambda: not Gui.Control.activeDialog(), 10)


def typed(name, words):
    """Words into a field of the open panel."""
    field = getattr(panel().form, name)
    scroll_to(field)
    type_into(field, words)
    at_rest()


def suggestions():
    """What the buttons of the open panel say that suggest a change."""
    return [" ".join(button.text().split()) for button in panel().form.suggestions if button.isVisible()]


def suggested(words):
    """The button that suggests this change, once it is there."""
    assert until(lambda: words in suggestions()), suggestions()
    button = panel().form.suggestions[suggestions().index(words)]
    scroll_to(button)
    return button


def shown_message():
    """What a window of the workbench says."""
    from freecad.elastica_wb.host import dialogs

    return dialogs._open_boxes[0].text() if dialogs._open_boxes and dialogs._open_boxes[0].isVisible() else ""


def window():
    """FreeCAD as large as the screen, and in front."""
    main = Gui.getMainWindow()
    main.showMaximized()
    main.activateWindow()
    until(lambda: main.isActiveWindow() and main.width() > 0.9 * main.screen().size().width())
    still(lambda: main.geometry().getRect())


def at_rest():
    """Let the open panel do what it put off: numbers are told a moment after the last change."""
    until(lambda: panel().form is None or not any(one.isActive() for one in timers_of(panel())))


def timers_of(opened):
    """The timers by which a panel puts something off."""
    return [opened._timer, *([opened._refresh] if hasattr(opened, "_refresh") else [])]


def live_at_rest():
    """Let the overlay give its slower answers: widths, and where a curve is refused the nearest one."""
    from freecad.elastica_wb.live import session as live

    def rests():
        one = live.session()
        return one is None or not any(timer.isActive() for timer in (one._soon, one._rest, one._answer))

    until(rests)


def press_on_card(part):
    """A button or check box of the verdict in the panel Tasks, by the mouse on its words."""
    from freecad.elastica_wb.live import session as live

    widget = getattr(live.session().card, part)
    until(lambda: widget.isVisible() and widget.isEnabled())
    scroll_to(widget)
    # a check box may be wider than its words, and takes no clicks beside them
    click(widget, at=QtCore.QPoint(min(widget.sizeHint().width(), widget.width()) // 2, widget.height() // 2))


def drag(start, steps, shift, name="", grab=lambda: None):
    """A real mouse takes what is at a point in space and moves it by `steps` times `shift` pixels.

    What `grab` gives is waited for after each step: it changes when the window has followed the mouse.
    """
    still(looks_from)  # a panel that opens makes the view narrower
    x, y = on_screen(*start)
    mouse("mousemove", x - 3, y + 3, "sleep", 0.1, "mousemove", x, y, "sleep", 0.1, "mousedown", 1)
    seen = []
    for i in range(1, steps + 1):
        before = grab()
        mouse("mousemove", x + shift[0] * i, y + shift[1] * i)
        until(lambda before=before: grab() != before, 2 if before is not None else 0)
        seen.append(grab())
    if name:
        picture(name)
    mouse("mouseup", 1)
    wait(200)
    return seen


def run(work):
    """Do the work once the window is up, write the answers, end FreeCAD."""

    def go():
        code = 1
        try:
            work()
            code = 0
        except BaseException:
            answers["error"] = traceback.format_exc()
        (OUT / "answers.json").write_text(json.dumps(answers, default=str))
        os._exit(code)

    QtCore.QTimer.singleShot(300, go)
    sys.stderr.flush()
