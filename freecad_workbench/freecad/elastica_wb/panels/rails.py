# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""The panel for rails, pins, ties and loads of a strip, which are placed by clicks, dragging or numbers."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

import FreeCAD as App
import FreeCADGui as Gui
import numpy as np
from freecad.elastica_wb.curves.sketch_curves import drawn_curve
from freecad.elastica_wb.features.strip_properties import (
    Acting,
    acting_lines,
    acting_words,
    is_load,
    keys_of,
    places_of,
    spec_of,
)
from freecad.elastica_wb.host.fields import put_choices, set_value
from freecad.elastica_wb.host.resources import QT_TRANSLATE_NOOP, translate
from freecad.elastica_wb.host.words import worded
from freecad.elastica_wb.live.curve_picture import curve_picture
from freecad.elastica_wb.live.overlay import Overlay
from freecad.elastica_wb.live.preview import Handles
from freecad.elastica_wb.panels.panel import Panel, active_view
from freecad.elastica_wb.panels.property_panel import table_of
from freecad.elastica_wb.recording import record_value
from freecad.elastica_wb.solving.verdicts import Answer, refusal_answer
from freecad.elastica_wb.strip_report import strip_rows

from elastica_cad._types import FloatArray
from elastica_cad.errors import ElasticaError, FieldName, InputError
from elastica_cad.mechanics.elements import Pin, PlacedElement, PointForce, Rail, Tie
from elastica_cad.mechanics.loads import PointMass, Weight

Places = list[tuple[float, float]]

PLACE_DIGITS = 2
USUAL_FORCE_N, USUAL_MASS_G = (0.0, -1.0), 10.0
PROPERTIES = ("Between", "Loads")
UNITS = {"mass": 1e-3, "forceX": 1e3, "forceY": 1e3}
"""Size of the units g and N in FreeCAD's base units of mass and force."""


TIE = QT_TRANSLATE_NOOP("Elastica", "Tie (cord)")

KINDS: dict[str, Callable[[Places, list[float]], Acting]] = {
    QT_TRANSLATE_NOOP("Elastica", "Rail (bar on one side)"): lambda points, _: Rail(points[0]),
    QT_TRANSLATE_NOOP("Elastica", "Slot (two bars)"): lambda points, _: Rail(points[0], one_sided=False),
    QT_TRANSLATE_NOOP("Elastica", "Pin (the strip turns)"): lambda points, _: Pin(points[0]),
    TIE: lambda _, places: Tie(*sorted(places)),
    QT_TRANSLATE_NOOP("Elastica", "Force"): lambda _, places: PointForce(places[0], USUAL_FORCE_N),
    QT_TRANSLATE_NOOP("Elastica", "Hung mass"): lambda _, places: PointMass(places[0], USUAL_MASS_G),
}
"""Functions that make rails, pins, ties and loads from the points (x, y) of the user's clicks, and from their
distances along the curve, mm. A tie needs two clicks.

When the curve changes, rails and pins stay in place. Ties and loads keep their positions as fractions of the
length.
"""


class RailsPanel(Panel):
    """Panel that edits the properties Between and Loads of a strip, with an overlay during a drag."""

    file = "rails"
    icon_name = "Elastica_Rails"
    step = "Rails, ties and loads"

    def __init__(self, obj: Any) -> None:
        self.object, self.drawn = obj, drawn_curve(obj.Curve, obj)
        self.spec = spec_of(obj, self.drawn)
        if isinstance(self.spec.loads, Weight):
            raise InputError(
                "{box} already gives the loads of {strip}. Clear it first.",
                box=FieldName("WeightLaw"),
                strip=obj.Label,
            )
        self.items, self.chosen = [*self.spec.between, *self.spec.loads], 0
        self._before = {name: list(getattr(obj, name)) for name in PROPERTIES}
        self._clicked: Places = []
        self.handles: Handles | None = None
        super().__init__(obj.Document, [obj])
        put_choices(self.form.kind, list(KINDS))
        view = active_view()
        if view is not None:
            self.preview = Overlay(view, self.drawn.world)
            self.handles = Handles(view, self.drawn.world, self._marks(), self._dragged, self.changed)
        self.form.pick.toggled.connect(self._picking)
        self.form.remove.clicked.connect(self._remove)
        self.form.elements.currentRowChanged.connect(self._choose)
        self.watch("place", "other", "forceX", "forceY", "mass", "hole", "notch", "fixed")
        with self.telling():
            self._show()

    def value(self, name: str) -> Any:
        """Return the value that a widget shows, with lengths in mm, masses in g and forces in N."""
        return super().value(name) / UNITS[name] if name in UNITS else super().value(name)

    def changed(self) -> None:
        """Write the values of the chosen rail, pin, tie or load into the strip, and recompute."""
        if self.items:
            self.items[self.chosen] = self._typed(self.items[self.chosen])
        self._write()

    def finished(self) -> None:
        """Record the final values for macros."""
        self.now()
        for name in PROPERTIES:
            value = list(getattr(self.object, name))
            if value != self._before[name]:
                record_value(self.object, name, value)

    def closed(self) -> None:
        """Stop observing the selection, and remove the marks from the view."""
        Gui.Selection.removeObserver(self)
        self.let_go()
        super().closed()

    def let_go(self) -> None:
        """Remove the handles, which refer to the view."""
        if self.handles is not None:
            self.handles.remove()
            self.handles = None

    def addSelection(
        self, document: str, _name: str, element: str, place: tuple[float, float, float]
    ) -> None:
        """Use a point of the curve that the user clicks in the view."""
        # ignore clicks in the tree and in other documents
        if not element or document != self.object.Document.Name:
            return
        x, y, _ = self.drawn.world.inverse().multVec(App.Vector(*place))
        self.clicked((x, y))

    def clicked(self, point: tuple[float, float]) -> None:
        """Add a rail, pin, tie or load at a point in the plane of the curve. A tie needs two points."""
        kind = self.value("kind")
        with self.telling():
            self._distance(point)
            self._clicked.append(point)
            if kind == TIE and len(self._clicked) == 1:
                self.show_message(translate("Elastica", "Click the other end of the cord."))
                return
            points, self._clicked = self._clicked, []
            places = [self._distance(clicked) for clicked in points]
            item = KINDS[kind]([self._point(place) for place in places], places)
            set_value(self.form.pick, False)
            self._picking(False)
            if isinstance(item, PointMass):
                self.object.Gravity = True
            self.items.append(item)
            self.items.sort(key=is_load)
            self.chosen = self.items.index(item)
            self._write()

    def _picking(self, on: bool) -> None:
        Gui.Selection.removeObserver(self)
        self._clicked = []
        if on:
            Gui.Selection.clearSelection()
            Gui.Selection.addObserver(self, 0)
            self.object.Curve[0].Visibility = True
            self.show_message(translate("Elastica", "Click the place on the sketch or on the strip."))

    def _remove(self, *_: Any) -> None:
        if self.items:
            del self.items[self.chosen]
            self.chosen = max(min(self.chosen, len(self.items) - 1), 0)
            self._write()

    def _choose(self, row: int) -> None:
        self.chosen = max(row, 0)
        self._show_numbers()

    def _dragged(self, mark: int, point: tuple[float, float]) -> None:
        """Move a mark. The strip is computed only when the mouse is released."""
        self.chosen, key = self._keys()[mark]
        try:
            place = self._distance(point)
        except InputError:  # the mouse is not near the curve
            return
        item = self.items[self.chosen]
        is_point = isinstance(getattr(item, key), tuple)
        self.items[self.chosen] = replace(item, **{key: self._point(place) if is_point else place})
        self._show_numbers()
        answer = self._draw()
        self.show_message(answer.sentence)

    def _distance(self, point: tuple[float, float]) -> float:
        curve = self._along()
        return round(float(PlacedElement.on(Pin(point), curve, curve).s[0]), PLACE_DIGITS)

    def _point(self, place: float) -> tuple[float, float]:
        x, y = self._along().at(np.array([place])).position[0].round(PLACE_DIGITS).tolist()
        return x, y

    def _along(self) -> Any:
        rod_spec = self.spec.rod_spec
        return rod_spec.drawn or rod_spec.curve

    def _keys(self) -> list[tuple[int, str]]:
        return [(i, key) for i, item in enumerate(self.items) for key in keys_of(item)]

    def _marks(self) -> FloatArray:
        places = [place for item in self.items for place in places_of(item)]
        points = [place if isinstance(place, tuple) else self._point(place) for place in places]
        return np.array(points, dtype=float).reshape(-1, 2)

    def _typed(self, item: Acting) -> Acting:
        if isinstance(item, Pin | Tie):
            item = replace(item, hole=self.value("hole"), notch=self.value("notch"))
        if isinstance(item, Tie):
            return replace(item, start=self.value("place"), end=self.value("other"))
        place = self.value("place")
        if isinstance(item, PointForce):
            return PointForce(place, (self.value("forceX"), self.value("forceY")))
        if isinstance(item, PointMass):
            return PointMass(place, self.value("mass"))
        return replace(item, at=self._point(place) if self.value("fixed") else place)

    def _write(self) -> None:
        for name, lines in acting_lines(self.items).items():
            if list(getattr(self.object, name)) != lines:
                setattr(self.object, name, lines)
        self.document.recompute()
        self._show()

    def _show(self) -> None:
        if self.form is None:
            return
        rows = self.form.elements
        blocked = rows.blockSignals(True)
        rows.clear()
        for item in self.items:
            rows.addItem(worded(acting_words(item, [self._number(place) for place in places_of(item)])))
        rows.setCurrentRow(self.chosen if self.items else -1)
        rows.blockSignals(blocked)
        self._show_numbers()
        if self.handles is not None:
            self.handles.put(self._marks())
        self._draw()
        failed = "Invalid" in self.object.State
        self.form.numbers.setText("" if failed else table_of(strip_rows(self.object)))
        self.show_message("\n".join([self.object.Verdict, *self.object.Reasons]))

    def _show_numbers(self) -> None:
        item = self.items[self.chosen] if self.items else None
        kinds = {
            "place": (Rail, Pin, Tie, PointForce, PointMass), "other": (Tie,), "forceX": (PointForce,),
            "forceY": (PointForce,), "mass": (PointMass,), "hole": (Pin, Tie), "notch": (Pin, Tie),
            "fixed": (Rail, Pin), "remove": object,
        }  # fmt: skip
        for name, which in kinds.items():
            used = item is not None and isinstance(item, which)
            for widget in (getattr(self.form, name), getattr(self.form, f"{name}Label", None)):
                if widget is not None:
                    widget.setVisible(used)
        if item is None:
            return
        with self.telling():
            places = places_of(item)
            set_value(self.form.fixed, isinstance(places[0], tuple))
            for widget, place in zip((self.form.place, self.form.other), places, strict=False):
                set_value(widget, self._number(place))
            if isinstance(item, PointForce):
                for name, value in zip(("forceX", "forceY"), item.force, strict=True):
                    set_value(getattr(self.form, name), value * UNITS[name])
            if isinstance(item, PointMass):
                set_value(self.form.mass, item.mass * UNITS["mass"])
            if isinstance(item, Pin | Tie):
                set_value(self.form.hole, item.hole)
                set_value(self.form.notch, item.notch)

    def _number(self, place: Any) -> float:
        return self._distance(place) if isinstance(place, tuple) else float(place)

    def _draw(self) -> Answer:
        try:
            elements = tuple(item for item in self.items if not is_load(item))
            spec = self.spec.changed(between=elements, loads=tuple(filter(is_load, self.items)))
            picture = curve_picture(self.drawn.curve, spec)
        except ElasticaError as error:
            return refusal_answer(error)
        if self.preview is not None:
            self.preview.show(replace(picture, comb=(), strained=()))
        return picture.answer
