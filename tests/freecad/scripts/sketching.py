"""A sketch drawn by the mouse: its plane, and the clicks of FreeCAD's B-spline tool."""

import FreeCADGui as Gui
from inside import (
    Dialog,
    QtCore,
    QtWidgets,
    click,
    dialog_button,
    keys,
    mouse,
    on_screen,
    press,
    press_button,
    still,
    toolbar_button,
    trigger,
    until,
    viewport,
    wait,
)


def ok_of(box):
    """The OK of a dialog."""
    buttons = (
        one.button(QtWidgets.QDialogButtonBox.Ok) for one in box.findChildren(QtWidgets.QDialogButtonBox)
    )
    return next(button for button in buttons if button is not None)


def draws():
    """Has the sketcher a tool in its hand? It gives the mouse another cursor."""
    kinds = {widget.cursor().shape() for widget in [viewport(), *viewport().findChildren(QtWidgets.QWidget)]}
    return QtCore.Qt.BitmapCursor in kinds


def splines(sketch):
    return [one for one in sketch.Geometry if "BSpline" in one.TypeId]


def plane_button(plane):
    """The choice of a plane in the dialog of 0.20 or in the panel of 1.1."""
    buttons = QtWidgets.QApplication.activeWindow().findChildren(QtWidgets.QRadioButton)
    return next(one for one in buttons if one.isVisible() and one.objectName().startswith(plane))


def new_sketch(plane="XY"):
    """The button asks for a plane; OK takes it."""

    def choose_plane():
        if plane != "XY":  # which is chosen already
            until(lambda: plane_button(plane).isVisible())
            click(plane_button(plane))

    def accept(box):
        until(lambda: ok_of(box).isVisible())
        choose_plane()
        still(lambda: ok_of(box).mapToGlobal(ok_of(box).rect().center()).toTuple())
        click(ok_of(box))

    request = Dialog(accept)
    press("Sketcher_NewSketch")
    for _ in range(60):
        if until(lambda: Gui.ActiveDocument.getInEdit() is not None, 1):
            break
        if dialog_button("Ok") is not None and not request.done:  # 1.1 asks in a panel
            choose_plane()
            press_button("Ok")
    request.stop()
    assert Gui.ActiveDocument.getInEdit() is not None, "no sketch is open"


def draw(places):
    """The sketcher's B-spline tool, one click for each pole in space, Escape ends it."""
    for name in ("Sketcher_CreateBSpline", "Sketcher_CompCreateBSpline"):
        button = toolbar_button(name)
        if button is not None:
            break
    if button is None:
        trigger("Sketcher_CreateBSpline")  # a tool of FreeCAD's own that its toolbar hides
    else:
        click(button)
    until(draws, 10)
    for place in places:
        x, y = on_screen(*place)
        mouse("mousemove", x - 4, y - 3, "sleep", 0.05, "mousemove", x, y, "sleep", 0.05, "click", 1)
    wait(200)
    sketch = Gui.ActiveDocument.getInEdit().Object
    mouse("click", 3)
    until(lambda: splines(sketch))
    if still(draws):  # without a tool, Escape would close the sketch
        keys("Escape")
    until(lambda: not draws(), 10)
