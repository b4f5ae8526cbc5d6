# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""The panel for bending a strip by moving its ends; the document changes after OK."""

from typing import Any

import numpy as np
from freecad.elastica_wb.curves.sketch_curves import drawn_curve
from freecad.elastica_wb.features.curves import MOVES, bent, largest_move, way
from freecad.elastica_wb.features.strip import strip_of
from freecad.elastica_wb.host.fields import set_value
from freecad.elastica_wb.host.resources import translate
from freecad.elastica_wb.live.preview import Handles, Preview
from freecad.elastica_wb.panels.panel import Panel, active_view
from freecad.elastica_wb.recording import record_value, recorded

from elastica_cad.errors import Length, note, sentences
from elastica_cad.mechanics.bending import Leg, inaccuracies
from elastica_cad.mechanics.rod import Rod
from elastica_cad.mechanics.stability import stability
from elastica_cad.strip.strip import strip_sideways


class BendPanel(Panel):
    """Panel with displacements and rotations of both ends, set by numbers or handles."""

    file = "bend"
    icon_name = "Elastica_Bend"
    step = "Bend forward"

    def __init__(self, obj: Any, feature: Any = None) -> None:
        """Open the panel for a strip, or for an existing bent curve `feature`."""
        self.strip = strip_of(obj)
        self.rest = self.strip.rod_to_bend
        super().__init__(obj.Document, [obj] if feature is None else [obj, feature])
        self.object, self.feature = obj, feature
        self.rod = self.rest
        view = active_view()
        if view is not None:
            world = drawn_curve(obj.Curve, obj).world
            self.preview = Preview(view, world)
            self.preview.handles = Handles(view, world, self.rest.position[[0, -1]], self.dragged)
            self._draw(self.rest)
        self.watch(*MOVES)
        self.form.play.clicked.connect(self.play)
        self.show_message(
            translate(
                "Elastica", "Move or turn an end: type numbers, or drag one of the handles in the view."
            )
        )
        if feature is not None:
            for name in MOVES:
                set_value(getattr(self.form, name), getattr(feature, name).Value)
            self._safely_changed()

    def changed(self) -> None:
        """Bend the strip to the ends set in the widgets."""
        self._show(self._way(), 1.0)

    def dragged(self, end: int, place: tuple[float, float]) -> None:
        """Move the start (0) or the end (1) to the dragged handle, in the plane of the curve."""
        shift, name = np.asarray(place) - self.rest.position[-end], ("Start", "End")[end]
        widgets = (getattr(self.form, f"{name}{axis}") for axis in "XY")
        for widget, value in zip(widgets, shift, strict=True):
            set_value(widget, float(value))
        self._safely_changed()

    def play(self, *_: Any) -> None:
        """Animate the whole motion in small steps."""
        from freecad.elastica_wb.host.qt import QtWidgets

        with self.telling():
            leg = self._way()
            for t in np.linspace(0.0, 1.0, 21)[1:].tolist():
                self._show(leg, t)
                QtWidgets.QApplication.processEvents()

    def finished(self) -> None:
        """Store the displacements and rotations in a feature that depends on the strip."""
        self._timer.stop()
        moves = {name: self.value(name) for name in MOVES}
        if self.feature is None and not any(moves.values()):
            return
        self.changed()
        if self.feature is None:
            recorded(bent, self.document, self.object, **moves)
            return
        for name, value in moves.items():
            if getattr(self.feature, name).Value != value:
                record_value(self.feature, name, value)

    def _way(self) -> Leg:
        return way(self.rest, {name: self.value(name) for name in MOVES})

    def _show(self, leg: Leg, t: float) -> None:
        """Show the strip at the fraction t of its motion, and what happens on the way."""
        self.rod = rod = leg.rod(t)
        self._draw(rod)
        state = stability(rod)
        words = note(
            "The strip moves by at most {far:.2f} and is stable; its stability margin is {margin:.3g}."
            if state.stable else
            "The strip moves by at most {far:.2f} and is unstable; its stability margin is {margin:.3g}.",
            far=Length(largest_move(self.rest, rod)), margin=state.margin,
        )  # fmt: skip
        fresh = [*leg.warnings, *inaccuracies(rod)]
        tips = strip_sideways(rod, self.strip.layout)
        if tips.needs_guiding:
            fresh.append(str(tips))
        self.show_message(sentences([words, *fresh], " "))

    def _draw(self, rod: Rod) -> None:
        if self.preview is None:
            return
        self.preview.show(self.rest.position, rod.position)
        fractions = np.linspace(0.0, 1.0, len(rod.position))
        self.preview.show_strip(rod.position, self.strip.width(fractions * self.strip.width.length))
        if self.preview.handles is not None and not self.preview.handles.is_held:
            self.preview.handles.put(rod.position[[0, -1]])
