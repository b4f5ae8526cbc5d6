# SPDX-License-Identifier: MIT
# SPDX-FileNotice: Part of the Elastica addon.

"""The panel of the projective edit: four handles around a curve, the transformed curve, and its check."""

from typing import Any

import numpy as np
from freecad.elastica_wb.curves.sketch_curves import (
    box_around,
    curve_into,
    evened,
    lost_constraints,
    sketch_curve,
)
from freecad.elastica_wb.host.fields import set_value
from freecad.elastica_wb.host.resources import translate
from freecad.elastica_wb.live.curve_picture import curve_picture
from freecad.elastica_wb.live.preview import Handles, Preview
from freecad.elastica_wb.live.session import request_along
from freecad.elastica_wb.panels.panel import Panel, active_view
from freecad.elastica_wb.recording import recorded
from freecad.elastica_wb.solving.verdicts import answer_of

from elastica_cad._types import FloatArray
from elastica_cad.errors import sentences
from elastica_cad.geometry.projective_maps import four_point_map
from elastica_cad.strip.strip_spec import StripSpec

FIELDS = [f"{axis}{number}" for number in (1, 2, 3, 4) for axis in "xy"]


class ProjectivePanel(Panel):
    """Panel that transforms a curve by four handles. OK writes the poles and weights into the sketch."""

    file = "projective"
    icon_name = "Elastica_Projective"
    step = "Projective edit"

    def __init__(self, sketch: Any) -> None:
        self.drawn = sketch_curve(sketch)
        super().__init__(sketch.Document, [sketch])
        self.sketch = sketch
        self._asks: StripSpec | None = None
        self.curve = self.drawn
        self.corners = box_around(self.drawn)
        self.handles: FloatArray = self.corners
        self.lost = lost_constraints(sketch)
        view = active_view()
        if view is not None:
            place = sketch.getGlobalPlacement()
            self.preview = Preview(view, place)
            self.preview.handles = Handles(view, place, self.corners, self.dragged)
        self.watch(*FIELDS)
        self.form.reset.clicked.connect(self.reset)
        self.reset()

    def reset(self, *_: Any) -> None:
        """Move the handles back to the corners of the box around the drawn curve."""
        self._fill(self.corners)
        self._safely_changed()

    def dragged(self, number: int, place: tuple[float, float]) -> None:
        """Show the transformed curve during a drag, and its strip when the mouse rests."""
        places = self.handles.copy()
        places[number] = place
        self._fill(places)
        with self.telling():
            self.pull()
            self.soon()

    def changed(self) -> None:
        """Read the typed numbers, transform the curve, and describe its strip."""
        self._typed()
        self.pull()
        self.show_message(sentences([answer_of(self._spec()).sentence, self._warning()], ""))

    def pull(self) -> None:
        """Transform the curve by the handles and show whether it can be bent."""
        self._draw()
        same = np.array_equal(self.handles, self.corners)
        pulled = self.drawn if same else self.drawn.transformed(four_point_map(self.corners, self.handles))
        self.curve = pulled
        self._draw()
        answer = curve_picture(self.curve, self._spec()).answer
        self.show_message(sentences([answer.sentence, self._warning()], ""))

    def finished(self) -> None:
        """Write the curve into the sketch."""
        self._timer.stop()
        self._typed()
        self.pull()
        if self.curve is not self.drawn:
            recorded(curve_into, self.sketch, evened(self.curve))

    def _spec(self) -> StripSpec:
        if self._asks is None:
            self._asks = request_along(self.sketch, self.drawn)
        return self._asks.changed(curve=self.curve, limits=None, keep=None)

    def _draw(self) -> None:
        if self.preview is not None:
            around = self.handles[[0, 1, 2, 3, 0]]
            self.preview.show(self.drawn.sample(201).position, self.curve.sample(201).position, around)

    def _fill(self, places: FloatArray) -> None:
        self.handles, self._shown = places, []
        for name, value in zip(FIELDS, places.ravel(), strict=True):
            widget = getattr(self.form, name)
            set_value(widget, float(value))
            self._shown.append(self.value(name))
        if self.preview is not None and not self.preview.handles.is_held:
            self.preview.handles.put(places)

    def _typed(self) -> None:
        """Read the typed numbers. Unchanged numbers keep their full precision."""
        values = [self.value(name) for name in FIELDS]
        places = np.where(np.array(values) == self._shown, self.handles.ravel(), values)
        self._fill(places.reshape(4, 2))

    def _warning(self) -> str:
        if not self.lost or self.curve is self.drawn:
            return ""
        return f"\n{translate('Elastica', 'Constraints on the drawn curve that OK takes away')}: {self.lost}"
